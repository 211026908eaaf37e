//! Windows in others, and windows that belong to others.

use std::time::{Duration, Instant};

use x11rb::connection::Connection as _;
use x11rb::protocol::xproto::{
    ChangeWindowAttributesAux, ConfigureWindowAux, ConnectionExt as _, CreateWindowAux, EventMask,
    InputFocus, WindowClass,
};

use super::looker::Looker;
use super::{Shown, options};
use crate::testing::{Server, until};
use crate::{Options, Window};

/// A window in another.
fn within(server: &Server, parent: u32) -> crate::error::Result<Window> {
    Window::open(&Options {
        parent: Some(parent),
        ..options(server.display())
    })
}

fn focus(looker: &Looker) -> u32 {
    let asked = looker.connection.get_input_focus().unwrap();
    asked.reply().unwrap().focus
}

#[test]
fn it_fills_its_parent_whatever_that_is() {
    let server = Server::start();
    let looker = Looker::new(&server);
    for depth in [24, 32] {
        let host = looker.window(looker.root(), (320, 240), depth);
        let mut shown = Shown::of(within(&server, host).expect("a window"));
        shown.settle();
        assert_eq!(looker.place(shown.id()), Some((host, true)));
        assert_eq!(shown.window.size, (320, 240));
        looker.check(&shown, 1, (320, 240));
        looker.resize(host, 401, 303);
        shown.until("the size", |shown| shown.window.size == (401, 303));
        assert_eq!(looker.geometry(shown.id()), [0, 0, 401, 303]);
        // Another place within the host's windows.
        let other = looker.window(host, (111, 99), 24);
        looker
            .connection
            .reparent_window(shown.id(), other, 0, 0)
            .unwrap();
        looker.sync();
        shown.until("the new size", |shown| shown.window.size == (111, 99));
        looker.resize(other, 120, 98);
        shown.until("its size", |shown| shown.window.size == (120, 98));
        looker.connection.destroy_window(host).unwrap();
        looker.sync();
        let error = until("the end", || shown.window.poll().err());
        assert_eq!(error.to_string(), "the window was closed from outside");
    }
}

#[test]
fn put_out_to_the_root_it_ends() {
    let server = Server::start();
    let looker = Looker::new(&server);
    let host = looker.window(looker.root(), (320, 240), 24);
    let mut shown = Shown::of(within(&server, host).expect("a window"));
    shown.settle();
    let root = looker.root();
    looker
        .connection
        .reparent_window(shown.id(), root, 0, 0)
        .unwrap();
    looker.sync();
    let error = until("the end", || shown.window.poll().err());
    assert_eq!(
        error.to_string(),
        "the host has put the window out of its own"
    );
}

#[test]
fn what_is_no_window_is_refused_in_a_sentence() {
    let server = Server::start();
    let looker = Looker::new(&server);
    let [pixmap, input_only, never] = [(); 3].map(|()| looker.connection.generate_id().unwrap());
    let root = looker.root();
    looker
        .connection
        .create_pixmap(24, pixmap, root, 8, 8)
        .unwrap();
    let (kind, none) = (WindowClass::INPUT_ONLY, CreateWindowAux::new());
    let asked = looker
        .connection
        .create_window(0, input_only, root, 0, 0, 8, 8, 0, kind, 0, &none);
    asked.unwrap().check().unwrap();
    for (parent, reason) in [
        (pixmap, "does not exist"),
        (never, "does not exist"),
        (1, "does not exist"),
        (u32::MAX, "does not exist"),
        (input_only, "shows nothing: it takes input only"),
        (root, "is the root window"),
    ] {
        let error = within(&server, parent).map(drop).unwrap_err();
        let display = server.display();
        let wanted = format!("the parent, window {parent:#x} of display \"{display}\", {reason}");
        assert_eq!(error.kind(), vides_engine::error::ErrorKind::Argument);
        assert_eq!(error.to_string(), wanted);
    }
    for transient_for in [pixmap, never, 1, u32::MAX] {
        let opened = Window::open(&Options {
            transient_for: Some(transient_for),
            ..options(server.display())
        });
        let error = opened.map(drop).unwrap_err();
        assert_eq!(error.kind(), vides_engine::error::ErrorKind::Argument);
        let wanted = format!(
            "the window {transient_for:#x} to belong to does not exist on display \"{}\"",
            server.display()
        );
        assert_eq!(error.to_string(), wanted);
    }
}

#[test]
fn it_belongs_to_the_hosts_window_and_its_group() {
    let server = Server::start();
    let looker = Looker::new(&server);
    let host = looker.window(looker.root(), (320, 240), 24);
    let group = |window: u32| {
        let hints = looker.property(window, "WM_HINTS");
        u32::from_ne_bytes(hints[32..36].try_into().unwrap())
    };
    let open = |transient_for| {
        let opened = Window::open(&Options {
            transient_for,
            ..options(server.display())
        });
        let mut shown = Shown::of(opened.expect("a window"));
        shown.settle();
        shown
    };
    let first = open(Some(host));
    let owner = looker.property(first.id(), "WM_TRANSIENT_FOR");
    assert_eq!(owner, host.to_ne_bytes());
    assert_eq!(group(first.id()), host, "it leads a group");
    let second = open(Some(first.id()));
    assert_eq!(group(second.id()), host, "and is in one");
    let alone = open(None);
    assert_eq!(looker.property(alone.id(), "WM_TRANSIENT_FOR"), b"");
    assert_eq!(group(alone.id()), alone.id());
}

#[test]
fn a_click_takes_the_keyboard_and_takes_it_again() {
    let server = Server::start();
    let looker = Looker::new(&server);
    let host = looker.window(looker.root(), (320, 240), 24);
    let mut shown = Shown::of(within(&server, host).expect("a window"));
    shown.settle();
    let give = |window| {
        let asked = looker
            .connection
            .set_input_focus(InputFocus::PARENT, window, 0_u32);
        asked.unwrap().check().unwrap();
    };
    give(host);
    server.run("xdotool", &["mousemove", "50", "60", "click", "1"]);
    let ours = shown.id();
    for _ in 0..3 {
        // A toolkit that finds it gone takes it back, a few times.
        shown.until("the keyboard", |_| focus(&looker) == ours);
        give(host);
    }
    shown.until("the last time", |shown| {
        let due = shown.window.deadline();
        assert!(due.is_none_or(|due| due <= Instant::now() + Duration::from_secs(1)));
        focus(&looker) == ours
    });
    // Later it is the host's for good.
    let quiet = Instant::now();
    shown.until("a rest", |_| quiet.elapsed().as_millis() > 400);
    give(host);
    let quiet = Instant::now();
    shown.until("a rest", |_| quiet.elapsed().as_millis() > 400);
    assert_eq!(focus(&looker), host);
    assert_eq!(shown.window.deadline(), None);
}

#[test]
fn a_dialog_of_the_hosts_keeps_the_keyboard() {
    let server = Server::start();
    let looker = Looker::new(&server);
    let host = looker.window(looker.root(), (320, 240), 24);
    // Away from the pointer, as a dialog may be.
    let dialog = looker.window(looker.root(), (120, 80), 24);
    let aside = ConfigureWindowAux::new().x(400).y(300);
    looker.connection.configure_window(dialog, &aside).unwrap();
    let proxy = looker.window(host, (1, 1), 24);
    let mut shown = Shown::of(within(&server, host).expect("a window"));
    shown.settle();
    let give = |window| {
        let asked = looker
            .connection
            .set_input_focus(InputFocus::PARENT, window, 0_u32);
        asked.unwrap().check().unwrap();
    };
    let ours = shown.id();
    for (window, keeps) in [(dialog, true), (proxy, false)] {
        server.run("xdotool", &["mousemove", "50", "60", "click", "1"]);
        shown.until("the keyboard", |_| focus(&looker) == ours);
        give(window);
        let quiet = Instant::now();
        shown.until("a rest", |_| quiet.elapsed().as_millis() > 400);
        assert_eq!(focus(&looker) == window, keeps);
        assert_eq!(shown.window.deadline(), None);
    }
}

#[test]
fn to_the_front_comes_the_top_level_window() {
    let server = Server::start();
    let looker = Looker::new(&server);
    let frame = looker.window(looker.root(), (320, 240), 24);
    let top = looker.window(frame, (300, 200), 24);
    let inner = looker.window(top, (300, 200), 24);
    let state = looker.atom("WM_STATE");
    use x11rb::wrapper::ConnectionExt as _;
    let mode = x11rb::protocol::xproto::PropMode::REPLACE;
    looker
        .connection
        .change_property32(mode, top, state, state, &[1, 0])
        .unwrap();
    let manage = ChangeWindowAttributesAux::new().event_mask(EventMask::SUBSTRUCTURE_REDIRECT);
    looker
        .connection
        .change_window_attributes(looker.root(), &manage)
        .unwrap();
    looker.sync();
    let mut shown = Shown::of(within(&server, inner).expect("a window"));
    shown.settle();
    shown.window.raise().unwrap();
    let asked = until("the wish", || {
        match looker.connection.poll_for_event().unwrap() {
            Some(x11rb::protocol::Event::ClientMessage(message)) => Some(message.window),
            _ => None,
        }
    });
    assert_eq!(asked, top);
}
