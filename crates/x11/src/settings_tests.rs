//! The desktop's settings manager: there, gone, changing its mind, or writing
//! what it likes.

use rustix::event::PollFlags;
use std::os::fd::AsFd as _;
use std::time::{Duration, Instant};

use x11rb::connection::Connection as _;
use x11rb::protocol::xproto::{
    AtomEnum, ClientMessageEvent, ConnectionExt as _, CreateWindowAux, EventMask, PropMode,
    WindowClass,
};
use x11rb::rust_connection::RustConnection;
use x11rb::wrapper::ConnectionExt as _;

use super::settings::tests::settings;
use super::stream::{REPLY_TIMEOUT, wait};
use super::testing::{Server, until};
use super::{Options, Window};

/// A client that owns the settings.
struct Manager {
    connection: RustConnection,
    window: u32,
    property: u32,
}

impl Manager {
    fn new(server: &Server) -> Self {
        let (connection, screen) = x11rb::connect(Some(server.display())).unwrap();
        let root = connection.setup().roots[screen].root;
        let window = connection.generate_id().unwrap();
        let looks = CreateWindowAux::new();
        connection
            .create_window(
                0,
                window,
                root,
                -9,
                -9,
                1,
                1,
                0,
                WindowClass::INPUT_ONLY,
                0,
                &looks,
            )
            .unwrap();
        let atom = |name: &[u8]| {
            let asked = connection.intern_atom(false, name).unwrap();
            asked.reply().unwrap().atom
        };
        let (selection, property) = (atom(b"_XSETTINGS_S0"), atom(b"_XSETTINGS_SETTINGS"));
        connection
            .set_selection_owner(window, selection, x11rb::CURRENT_TIME)
            .unwrap();
        connection.sync().unwrap();
        Self {
            connection,
            window,
            property,
        }
    }

    fn write(&self, kind: u32, bytes: &[u8]) {
        let connection = &self.connection;
        let asked =
            connection.change_property8(PropMode::REPLACE, self.window, self.property, kind, bytes);
        asked.unwrap();
        connection.sync().unwrap();
    }

    /// Tells the root window that it has begun, or something like that.
    fn announce(&self, change: impl FnOnce(&mut [u32; 5])) {
        let connection = &self.connection;
        let atom = |name: &[u8]| {
            let asked = connection.intern_atom(false, name).unwrap();
            asked.reply().unwrap().atom
        };
        let root = connection.setup().roots[0].root;
        let mut data = [
            x11rb::CURRENT_TIME,
            atom(b"_XSETTINGS_S0"),
            self.window,
            0,
            0,
        ];
        change(&mut data);
        let message = ClientMessageEvent::new(32, root, atom(b"MANAGER"), data);
        connection
            .send_event(false, root, EventMask::STRUCTURE_NOTIFY, message)
            .unwrap();
        connection.sync().unwrap();
    }

    fn theme(&self, name: &str) {
        self.write(self.property, &settings(cfg!(target_endian = "big"), name));
    }
}

fn open(server: &Server) -> Window {
    Window::open(&Options {
        display: Some(server.display().to_owned()),
        title: "VIDES".to_owned(),
        application: "a host".to_owned(),
        size: [300.0, 200.0],
        smallest: [100.0, 80.0],
        ..Options::default()
    })
    .unwrap()
}

/// Waits until egui is told this.
fn hears(window: &mut Window, wanted: Option<egui::Theme>) {
    until("the desktop's theme", || {
        wait(window.as_fd(), PollFlags::IN, Duration::from_millis(5)).unwrap();
        window.poll().unwrap();
        (window.take_input().system_theme == wanted).then_some(())
    });
}

/// Hears all that was sent until now.
fn settle(window: &mut Window) {
    let asked = window.connection.get_input_focus();
    window.connection.answer(asked).unwrap();
    window.poll().unwrap();
}

#[test]
fn the_desktops_theme_is_told_and_followed() {
    let server = Server::start();
    assert_eq!(open(&server).take_input().system_theme, None);
    let manager = Manager::new(&server);
    manager.theme("Adwaita-dark");
    let mut window = open(&server);
    assert_eq!(window.take_input().system_theme, Some(egui::Theme::Dark));
    manager.theme("Adwaita");
    hears(&mut window, Some(egui::Theme::Light));
    // A change is input: the window is drawn anew without a hand in it.
    manager.theme("Breeze-Dark");
    until("input", || window.poll().unwrap().input.then_some(()));
    assert_eq!(window.take_input().system_theme, Some(egui::Theme::Dark));
    // The manager ends: it stays as it was.
    drop(manager);
    settle(&mut window);
    assert_eq!(window.take_input().system_theme, Some(egui::Theme::Dark));
    until("the server to notice", || {
        let told = open(&server).take_input().system_theme;
        told.is_none().then_some(())
    });
}

/// A desktop may start, or start anew, what manages its settings while our window
/// is open.
#[test]
fn a_manager_that_begins_later_is_heard() {
    let server = Server::start();
    let mut window = open(&server);
    assert_eq!(window.take_input().system_theme, None);
    let first = Manager::new(&server);
    first.theme("Adwaita-dark");
    first.announce(|_| ());
    hears(&mut window, Some(egui::Theme::Dark));
    // Its changes too.
    first.theme("Adwaita");
    hears(&mut window, Some(egui::Theme::Light));
    first.theme("Adwaita-dark");
    hears(&mut window, Some(egui::Theme::Dark));
    // Another takes its place, writes nothing at first, and what the one before
    // still writes counts no more.
    let second = Manager::new(&server);
    second.announce(|_| ());
    settle(&mut window);
    assert_eq!(window.take_input().system_theme, Some(egui::Theme::Dark));
    second.theme("Adwaita");
    hears(&mut window, Some(egui::Theme::Light));
    first.theme("Adwaita-dark");
    settle(&mut window);
    assert_eq!(window.take_input().system_theme, Some(egui::Theme::Light));
}

/// Other managers begin as well, and anybody may say so.
#[test]
fn who_begins_something_else_is_not_asked() {
    let server = Server::start();
    let mut window = open(&server);
    let manager = Manager::new(&server);
    manager.theme("Adwaita-dark");
    manager.announce(|data| data[1] += 1);
    settle(&mut window);
    assert_eq!(window.take_input().system_theme, None);
    // Whom the message names does not matter, only whom the server knows.
    manager.announce(|data| data[2] = 0xffff_ffff);
    hears(&mut window, Some(egui::Theme::Dark));
    // One that has gone again leaves all as it was.
    let gone = Manager::new(&server);
    gone.theme("Adwaita");
    drop(gone);
    until("the server to notice", || {
        let told = open(&server).take_input().system_theme;
        told.is_none().then_some(())
    });
    manager.announce(|_| ());
    settle(&mut window);
    assert_eq!(window.take_input().system_theme, Some(egui::Theme::Dark));
}

#[test]
fn a_manager_that_writes_rubbish_is_not_listened_to() {
    let server = Server::start();
    let manager = Manager::new(&server);
    let kind = manager.property;
    // No settings at all.
    let mut window = open(&server);
    assert_eq!(window.take_input().system_theme, None);
    let good = settings(false, "Adwaita-dark");
    let mut long = good.clone();
    long.resize(1 << 20, 0xff);
    let huge_count = [&[0; 8][..], &[0xff; 4], &[1; 400]].concat();
    for (kind, bytes) in [
        (kind, &good[..good.len() - 1]),
        (kind, &[][..]),
        (kind, &[0xff; 4096]),
        (kind, &huge_count),
        (u32::from(AtomEnum::STRING), &good),
    ] {
        manager.theme("Adwaita-dark");
        hears(&mut window, Some(egui::Theme::Dark));
        manager.write(kind, bytes);
        hears(&mut window, None);
        assert_eq!(open(&server).take_input().system_theme, None);
    }
    // Very much behind what is asked for does not matter.
    manager.write(kind, &long);
    hears(&mut window, Some(egui::Theme::Dark));
    // Of numbers of another size nothing is read, whatever they are.
    let connection = &manager.connection;
    let (fours, _) = good.as_chunks::<4>();
    let words: Vec<u32> = fours.iter().map(|&four| u32::from_ne_bytes(four)).collect();
    connection
        .change_property32(PropMode::REPLACE, manager.window, kind, kind, &words)
        .unwrap();
    connection.sync().unwrap();
    hears(&mut window, None);
}

#[test]
fn what_is_not_answered_changes_nothing() {
    let server = Server::start();
    let manager = Manager::new(&server);
    let (connection, root) = (
        &manager.connection,
        manager.connection.setup().roots[0].root,
    );
    let resources = |dots: &str| {
        let (kind, bytes) = (AtomEnum::STRING, format!("Xft.dpi:\t{dots}\n"));
        let property = AtomEnum::RESOURCE_MANAGER;
        connection
            .change_property8(PropMode::REPLACE, root, property, kind, bytes.as_bytes())
            .unwrap();
        connection.sync().unwrap();
    };
    resources("192");
    manager.theme("Adwaita-dark");
    let mut window = open(&server);
    window.poll().unwrap();
    let said = |window: &mut Window| (window.take_input().system_theme, window.scale);
    assert_eq!(said(&mut window), (Some(egui::Theme::Dark), 2.0));
    // The manager has the server for itself: changes are told, no question is heard.
    connection.grab_server().unwrap();
    resources("96");
    manager.theme("Adwaita");
    let held = (0..20).filter(|_| {
        wait(window.as_fd(), PollFlags::IN, Duration::from_millis(5)).unwrap();
        let start = Instant::now();
        window.poll().unwrap();
        let held = start.elapsed() >= REPLY_TIMEOUT;
        assert_eq!(said(&mut window), (Some(egui::Theme::Dark), 2.0));
        held
    });
    assert_eq!(held.count(), 1, "it is asked once");
    connection.ungrab_server().unwrap();
    resources("96");
    manager.theme("Adwaita");
    hears(&mut window, Some(egui::Theme::Light));
    assert_eq!(window.scale, 1.0);
}
