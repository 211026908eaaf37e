//! Servers that are not there, that refuse, that stand still or go away.
#![allow(unsafe_code)] // signals for servers of our own

use rustix::event::PollFlags;
use std::os::fd::AsFd;
use std::process::Command;
use std::time::{Duration, Instant};

use egui::pos2;
use x11rb::protocol::xproto::{
    ConnectionExt as _, EventMask, MOTION_NOTIFY_EVENT, MotionNotifyEvent,
};
use x11rb::rust_connection::RustConnection;

use super::stream::wait;
use super::testing::{PATIENCE, Server, until};
use super::{MOST_EVENTS, Options, Window};
use vides_raster::Area;

fn open(display: Option<&str>) -> crate::error::Result<Window> {
    Window::open(&Options {
        display: display.map(str::to_owned),
        title: "VIDES".to_owned(),
        application: "a host".to_owned(),
        size: [640.0, 480.0],
        smallest: [100.0, 80.0],
        ..Options::default()
    })
}

fn refusal(display: &str) -> String {
    open(Some(display)).map(drop).unwrap_err().to_string()
}

fn signal(server: &Server, signal: i32) {
    // SAFETY: the process is a child that nobody has waited for yet.
    assert_eq!(unsafe { libc::kill(server.process(), signal) }, 0);
}

/// Does what an owner does at each turn.
fn turn(window: &mut Window) -> crate::error::Result<bool> {
    wait(window.as_fd(), PollFlags::IN, Duration::from_millis(5)).unwrap();
    let news = window.poll()?;
    window.take_input();
    if let Some(target) = window.target() {
        target.pixels.fill(0x0012_3456);
        let (width, height) = (target.width, target.height);
        let whole = Area {
            x: 0,
            y: 0,
            width,
            height,
        };
        window.present(&[whole])?;
    }
    Ok(news.shown)
}

/// Runs one test of this binary in a process of its own, where it may change
/// what belongs to the whole process.
fn alone(test: &str, change: impl FnOnce(&mut Command)) {
    let mut command = Command::new(std::env::current_exe().unwrap());
    let module = module_path!().split_once("::").unwrap().1;
    command.args([&format!("{module}::{test}"), "--exact", "--nocapture"]);
    command.env("VIDES_TEST_ALONE", "1");
    change(&mut command);
    let output = command.output().unwrap();
    let said = String::from_utf8_lossy(&output.stdout);
    assert!(output.status.success(), "{}\n{said}", output.status);
    assert!(said.contains("1 passed"), "{said}");
}

fn is_alone() -> bool {
    std::env::var_os("VIDES_TEST_ALONE").is_some()
}

#[test]
fn a_display_that_is_none_is_named_with_the_reason() {
    for name in [
        "x",
        "::",
        ":",
        ":-1",
        ":70000",
        ":60000",
        ":0.x",
        "/nowhere/at/all",
        "a:b:c",
    ] {
        let expected = format!(
            "\"{name}\" is not the name of a display; those look like \":0\" or \"host:0\""
        );
        assert_eq!(refusal(name), expected);
    }
    // The last possible display: nobody has so many.
    let error = refusal(":59535");
    let expected = "display \":59535\": no X server is reached (No such file or directory)";
    assert_eq!(error, expected);
    let error = refusal("localhost:59535");
    let expected = "display \"localhost:59535\": no X server is reached (Connection refused)";
    assert_eq!(error, expected);
    let server = Server::start();
    let display = format!("{}.7", server.display());
    assert_eq!(
        refusal(&display),
        format!("display \"{display}\": it has no screen 7")
    );
}

#[test]
fn displays_of_this_machine_have_the_names_that_xlib_knows() {
    let server = Server::start();
    let number = &server.display()[1..];
    for name in ["unix:", "unix/:", ":"] {
        for end in ["", ".0"] {
            let display = format!("{name}{number}{end}");
            open(Some(&display)).unwrap_or_else(|error| panic!("{error}"));
        }
    }
    let error = refusal("unix:59535");
    let expected = "display \"unix:59535\": no X server is reached (No such file or directory)";
    assert_eq!(error, expected);
    let expected = "\"unix:0x\" is not the name of a display; those look like \":0\" or \"host:0\"";
    assert_eq!(refusal("unix:0x"), expected);
}

#[test]
fn without_a_display_there_is_a_sentence() {
    if is_alone() {
        let expected = match std::env::var("DISPLAY") {
            Ok(name) if name == "x" => {
                "\"x\" is not the name of a display; those look like \":0\" or \"host:0\""
            }
            _ => "DISPLAY is not set: there is no X server for a window",
        };
        assert_eq!(open(None).map(drop).unwrap_err().to_string(), expected);
        return;
    }
    let name = "without_a_display_there_is_a_sentence";
    alone(name, |command| {
        command.env_remove("DISPLAY");
    });
    alone(name, |command| {
        command.env("DISPLAY", "");
    });
    alone(name, |command| {
        command.env("DISPLAY", "x");
    });
}

#[test]
fn a_cookie_opens_the_door_and_without_it_one_is_told() {
    if is_alone() {
        let result = open(None);
        match std::env::var_os("VIDES_TEST_REFUSED") {
            None => drop(result.expect("the cookie is right")),
            Some(_) => {
                let error = result.map(drop).unwrap_err().to_string();
                assert!(error.starts_with("display \":"), "{error}");
                assert!(
                    error.contains("the X server refuses the connection ("),
                    "{error}"
                );
            }
        }
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    // Family "any", no address, no number: good for each display.
    let cookie = |byte: u8| {
        let mut file = vec![0xff, 0xff, 0, 0, 0, 0, 0, 18];
        file.extend(b"MIT-MAGIC-COOKIE-1");
        file.extend([0, 16]);
        file.extend([byte; 16]);
        file
    };
    let [right, wrong, none] = ["right", "wrong", "none"].map(|name| folder.path().join(name));
    std::fs::write(&right, cookie(7)).unwrap();
    std::fs::write(&wrong, cookie(8)).unwrap();
    std::fs::write(&none, "nonsense").unwrap();
    let server = Server::with(&["-auth", right.to_str().unwrap()]);
    for (file, refused) in [(&right, false), (&wrong, true), (&none, true)] {
        alone(
            "a_cookie_opens_the_door_and_without_it_one_is_told",
            |command| {
                command
                    .env("DISPLAY", server.display())
                    .env("XAUTHORITY", file);
                if refused {
                    command.env("VIDES_TEST_REFUSED", "1");
                }
            },
        );
    }
}

#[test]
fn a_server_that_stands_still_holds_nobody_up_and_goes_on() {
    for more in [&[][..], &["-extension", "MIT-SHM"][..]] {
        let server = Server::with(more);
        let mut window = open(Some(server.display())).unwrap();
        until("a frame", || turn(&mut window).unwrap().then_some(()));
        signal(&server, libc::SIGSTOP);
        let start = Instant::now();
        for i in 0..400 {
            turn(&mut window).expect("a pause is no end");
            window.set_title(&i.to_string()).unwrap();
            window.raise().unwrap();
            let pasted = [egui::OutputCommand::CopyText(i.to_string())];
            let output = egui::PlatformOutput {
                commands: pasted.to_vec(),
                ..egui::PlatformOutput::default()
            };
            window.take_output(output).unwrap();
        }
        assert!(
            start.elapsed() < PATIENCE,
            "it was held up for {:?}",
            start.elapsed()
        );
        let opened = Instant::now();
        let expected = format!(
            "display \"{}\": the X server does not answer",
            server.display()
        );
        assert_eq!(refusal(server.display()), expected);
        assert!(opened.elapsed() < PATIENCE);
        signal(&server, libc::SIGCONT);
        until("a frame", || turn(&mut window).unwrap().then_some(()));
        for _ in 0..3 {
            until("another", || turn(&mut window).unwrap().then_some(()));
        }
    }
}

#[test]
fn a_server_that_dies_ends_the_window_with_a_sentence() {
    if !is_alone() {
        let name = "a_server_that_dies_ends_the_window_with_a_sentence";
        return alone(name, |_| ());
    }
    // As in a C host: writing to a closed connection would end the process.
    // SAFETY: the default action; this process runs this test alone.
    unsafe { libc::signal(libc::SIGPIPE, libc::SIG_DFL) };
    for more in [&[][..], &["-extension", "MIT-SHM"][..]] {
        let mut server = Server::with(more);
        let mut window = open(Some(server.display())).unwrap();
        let mut other = open(Some(server.display())).unwrap();
        until("a frame", || turn(&mut window).unwrap().then_some(()));
        let expected = format!("display \"{}\": the X server went away", server.display());
        server.end();
        // One finds out by reading, the other by writing.
        let error = until("the end", || turn(&mut window).err());
        assert_eq!(error.to_string(), expected);
        let error = until("the end", || other.set_title("x").err());
        assert_eq!(error.to_string(), expected);
        for window in [&mut window, &mut other] {
            assert!(window.target().is_none());
            for error in [
                window.poll().map(drop).unwrap_err(),
                window.present(&[]).unwrap_err(),
                window.raise().unwrap_err(),
                window.flush().unwrap_err(),
                window
                    .take_output(egui::PlatformOutput::default())
                    .unwrap_err(),
            ] {
                assert_eq!(error.to_string(), expected);
            }
        }
    }
}

#[test]
fn a_flood_is_taken_in_parts() {
    const MANY: i16 = 4000;
    let server = Server::start();
    let mut window = open(Some(server.display())).unwrap();
    until("a frame", || turn(&mut window).unwrap().then_some(()));
    let id = window.frame.window;
    let (other, _) = RustConnection::connect(Some(server.display())).unwrap();
    for x in 0..MANY {
        let moved = MotionNotifyEvent {
            response_type: MOTION_NOTIFY_EVENT,
            event: id,
            event_x: x,
            ..MotionNotifyEvent::default()
        };
        let sent = other.send_event(false, id, EventMask::NO_EVENT, moved);
        sent.unwrap().ignore_error();
    }
    other.get_input_focus().unwrap().reply().unwrap();
    // All of it has been sent. What the pointer did in one look is one move.
    let mut parts = 0;
    until("the last that was sent", || {
        parts += usize::from(window.poll().unwrap().more);
        let last = egui::Event::PointerMoved(pos2(f32::from(MANY - 1), 0.0));
        window.take_input().events.contains(&last).then_some(())
    });
    assert!(parts >= MANY as usize / MOST_EVENTS / 2, "{parts} parts");
}

#[test]
fn nothing_is_left_open() {
    if !is_alone() {
        return alone("nothing_is_left_open", |_| ());
    }
    let server = Server::start();
    let descriptors = || {
        let entries = std::fs::read_dir("/proc/self/fd").unwrap().flatten();
        let name = |entry: std::fs::DirEntry| entry.file_name().into_string().unwrap();
        entries
            .map(|entry| name(entry).parse::<i32>().unwrap())
            .collect::<Vec<_>>()
    };
    let mappings = || {
        let maps = std::fs::read_to_string("/proc/self/maps").unwrap();
        maps.lines().filter(|line| line.contains("memfd")).count()
    };
    let before = descriptors();
    for _ in 0..20 {
        let mut window = open(Some(server.display())).unwrap();
        until("a frame", || turn(&mut window).unwrap().then_some(()));
        assert!(mappings() > 0);
        for number in descriptors() {
            // SAFETY: only asks; a descriptor that is closed meanwhile gives -1.
            let flags = unsafe { libc::fcntl(number, libc::F_GETFD) };
            let handed_on = flags >= 0 && flags & libc::FD_CLOEXEC == 0;
            assert!(
                before.contains(&number) || !handed_on,
                "descriptor {number}"
            );
        }
    }
    assert_eq!((descriptors().len(), mappings()), (before.len(), 0));
}
