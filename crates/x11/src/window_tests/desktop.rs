//! What a desktop and other clients want of a window.

use x11rb::connection::Connection as _;
use x11rb::protocol::Event;
use x11rb::protocol::xproto::{
    CONFIGURE_NOTIFY_EVENT, ChangeWindowAttributesAux, ClientMessageEvent, ConfigureNotifyEvent,
    ConnectionExt as _, DESTROY_NOTIFY_EVENT, DestroyNotifyEvent, EXPOSE_EVENT, EventMask,
    ExposeEvent, UNMAP_NOTIFY_EVENT,
};

use super::Shown;
use super::looker::Looker;
use crate::testing::{Server, until};

#[test]
fn what_others_send_is_not_believed() {
    let server = Server::start();
    let looker = Looker::new(&server);
    let mut shown = Shown::open(&server);
    shown.settle();
    let id = shown.id();
    let other = looker.connection.generate_id().unwrap();
    for window in [id, other, looker.root(), 0] {
        let configured = ConfigureNotifyEvent {
            response_type: CONFIGURE_NOTIFY_EVENT,
            window,
            event: window,
            width: 5,
            height: 60_000,
            ..ConfigureNotifyEvent::default()
        };
        looker.send(id, configured);
        let destroyed = DestroyNotifyEvent {
            response_type: DESTROY_NOTIFY_EVENT,
            window: other,
            event: window,
            ..DestroyNotifyEvent::default()
        };
        looker.send(id, destroyed);
        let exposed = ExposeEvent {
            response_type: EXPOSE_EVENT,
            window,
            x: 65_535,
            y: 7,
            width: 65_535,
            height: 65_535,
            ..ExposeEvent::default()
        };
        looker.send(id, exposed);
        for kind in 0..600 {
            looker.send(id, ClientMessageEvent::new(32, window, kind, [kind; 5]));
            looker.send(id, ClientMessageEvent::new(8, window, kind, [7; 20]));
        }
        for kind in 2..128_u8 {
            if kind == DESTROY_NOTIFY_EVENT || kind == UNMAP_NOTIFY_EVENT {
                continue;
            }
            let mut event = [0xff; 32];
            event[0] = kind;
            looker.send(id, event);
        }
    }
    looker.sync();
    for _ in 0..20 {
        shown.turn();
    }
    assert_eq!(shown.window.size, (300, 200));
    assert!(!shown.close);
    shown.until("a target", |shown| shown.paint());
    let frames = shown.frames;
    shown.until("a frame", |shown| shown.frames > frames);
    looker.check(&shown, 1, (300, 200));
}

#[test]
fn a_window_manager_finds_what_it_looks_for() {
    let server = Server::start();
    let looker = Looker::new(&server);
    let mut shown = Shown::open(&server);
    shown.settle();
    let id = shown.id();
    assert_eq!(looker.property(id, "WM_CLASS"), b"a host\0Vides\0");
    assert_eq!(looker.property(id, "WM_CLIENT_LEADER"), id.to_ne_bytes());
    assert_eq!(looker.property(id, "WM_NAME"), b"VIDES - Pr\xfcfung");
    assert_eq!(
        looker.property(id, "_NET_WM_NAME"),
        "VIDES – Prüfung".as_bytes()
    );
    assert_eq!(
        looker.property(id, "_NET_WM_PID"),
        std::process::id().to_ne_bytes()
    );
    let machine = std::fs::read_to_string("/proc/sys/kernel/hostname").unwrap();
    assert_eq!(
        looker.property(id, "WM_CLIENT_MACHINE"),
        machine.trim_end().as_bytes()
    );
    let sizes = looker.property(id, "WM_NORMAL_HINTS");
    let sizes: Vec<_> = sizes
        .chunks(4)
        .map(|b| u32::from_ne_bytes(b.try_into().unwrap()))
        .collect();
    assert_eq!(sizes[0] & 1 << 4, 1 << 4, "there is a smallest size");
    assert_eq!(sizes[5..7], [100, 80]);
    assert!(looker.property(id, "_NET_WM_ICON").len() > 16 * 16 * 4);
    assert_eq!(
        looker.property(id, "_NET_WM_WINDOW_TYPE"),
        looker.atom("_NET_WM_WINDOW_TYPE_NORMAL").to_ne_bytes()
    );
    shown.window.set_title("VIDES – *点\n\0").unwrap();
    until("the title", || {
        (looker.property(id, "_NET_WM_NAME") == "VIDES – *点".as_bytes()).then_some(())
    });
    assert_eq!(looker.property(id, "WM_NAME"), b"VIDES - *?");

    let protocols = looker.atom("WM_PROTOCOLS");
    let close = [looker.atom("WM_DELETE_WINDOW"), 0, 0, 0, 0];
    looker.send(id, ClientMessageEvent::new(32, id, protocols, close));
    looker.connection.flush().unwrap();
    shown.until("the wish to close", |shown| shown.close);

    // The answer to a ping goes to whoever manages the root window.
    let manage = ChangeWindowAttributesAux::new().event_mask(EventMask::SUBSTRUCTURE_REDIRECT);
    looker
        .connection
        .change_window_attributes(looker.root(), &manage)
        .unwrap();
    let ping = [looker.atom("_NET_WM_PING"), 4711, id, 0, 0];
    looker.send(id, ClientMessageEvent::new(32, id, protocols, ping));
    looker.connection.flush().unwrap();
    let answer = until("an answer to the ping", || {
        shown.turn();
        match looker.connection.poll_for_event().unwrap() {
            Some(Event::ClientMessage(answer)) => Some(answer),
            _ => None,
        }
    });
    assert_eq!((answer.window, answer.type_), (looker.root(), protocols));
    assert_eq!(answer.data.as_data32(), ping);
}

#[test]
fn the_mouse_is_followed() {
    let server = Server::start();
    let mut shown = Shown::open(&server);
    shown.settle();
    let expect = |shown: &mut Shown, arguments: &[&str], wanted: egui::Event| {
        shown.events.clear();
        server.run("xdotool", arguments);
        shown.until("an event", |shown| shown.events.contains(&wanted));
    };
    let at = |x, y| egui::pos2(x, y);
    let go = |x, y| ["mousemove", x, y];
    let inside = egui::Event::PointerMoved(at(20.0, 30.0));
    for _ in 0..2 {
        expect(&mut shown, &go("20", "30"), inside.clone());
        expect(&mut shown, &go("400", "300"), egui::Event::PointerGone);
    }
    expect(&mut shown, &go("20", "30"), inside);
    for (number, button) in [
        ("1", egui::PointerButton::Primary),
        ("2", egui::PointerButton::Middle),
        ("3", egui::PointerButton::Secondary),
    ] {
        for (what, pressed) in [("mousedown", true), ("mouseup", false)] {
            let wanted = egui::Event::PointerButton {
                pos: at(20.0, 30.0),
                button,
                pressed,
                modifiers: egui::Modifiers::NONE,
            };
            expect(&mut shown, &[what, number], wanted);
        }
    }
    // A drag leads out of the window and back.
    server.run("xdotool", &["mousedown", "1"]);
    expect(
        &mut shown,
        &go("390", "310"),
        egui::Event::PointerMoved(at(390.0, 310.0)),
    );
    assert!(!shown.events.contains(&egui::Event::PointerGone));
    shown.events.clear();
    server.run("xdotool", &["mouseup", "1"]);
    shown.until("the end", |shown| {
        shown.events.last() == Some(&egui::Event::PointerGone)
    });
    assert!(shown.input.screen_rect.unwrap().size() == egui::vec2(300.0, 200.0));
}

#[test]
fn the_resolution_is_followed() {
    let server = Server::start();
    let looker = Looker::new(&server);
    looker.resources("Xft.dpi:\t144\n");
    let mut shown = Shown::open(&server);
    shown.settle();
    assert_eq!((shown.window.scale, shown.window.size), (1.5, (450, 300)));
    assert_eq!(
        shown.input.screen_rect.unwrap().size(),
        egui::vec2(300.0, 200.0)
    );
    assert_eq!(shown.input.viewport().native_pixels_per_point, Some(1.5));
    looker.resources("Xft.dpi:\t192\n");
    shown.until("another scale", |shown| shown.window.scale == 2.0);
    assert_eq!(
        shown.input.screen_rect.unwrap().size(),
        egui::vec2(225.0, 150.0)
    );
}

#[test]
fn a_window_destroyed_by_others_says_so() {
    let server = Server::start();
    let looker = Looker::new(&server);
    let mut shown = Shown::open(&server);
    shown.settle();
    looker.connection.destroy_window(shown.id()).unwrap();
    looker.sync();
    let error = until("the end", || shown.window.poll().err());
    assert_eq!(error.to_string(), "the window was closed from outside");
    assert!(shown.window.target().is_none());
    for error in [
        shown.window.present(&[]).unwrap_err(),
        shown.window.set_title("x").unwrap_err(),
        shown.window.raise().unwrap_err(),
        shown.window.poll().map(drop).unwrap_err(),
    ] {
        assert_eq!(error.to_string(), "the window was closed from outside");
    }
}
