//! The part of a window that a host draws in, and that it never loses.

use x11rb::connection::Connection as _;
use x11rb::protocol::shape::{ConnectionExt as _, SK};
use x11rb::protocol::xproto::{ConnectionExt as _, EventMask};

use super::Shown;
use super::looker::Looker;
use crate::testing::{Server, until};
use crate::{PanePlace, PaneWindow};
use vides_raster::Area;

fn place(width: u32, height: u32) -> PanePlace {
    PanePlace {
        area: Area {
            x: 20,
            y: 10,
            width,
            height,
        },
        above: Vec::new(),
    }
}

/// Opens a pane in which the host makes a window.
fn filled(shown: &mut Shown, looker: &Looker) -> (u32, u32) {
    assert!(shown.window.place_pane(Some(&place(100, 60))).unwrap());
    let pane = shown.window.pane().expect("a pane").window;
    let child = looker.window(pane, (7, 9), 32);
    shown.until("the size", |_| looker.geometry(child) == [0, 0, 100, 60]);
    (pane, child)
}

#[test]
fn a_pane_is_shown_followed_parked_and_used_again() {
    let server = Server::start();
    let looker = Looker::new(&server);
    let mut shown = Shown::open(&server);
    shown.settle();
    let (pane, child) = filled(&mut shown, &looker);
    assert_eq!(looker.place(pane), Some((shown.id(), true)));
    assert_eq!(looker.geometry(pane), [20, 10, 100, 60]);
    // What only one client may ask for is left to the host.
    let asked = looker.connection.get_window_attributes(pane).unwrap();
    let mask = asked.reply().unwrap().all_event_masks;
    assert_eq!(mask, EventMask::SUBSTRUCTURE_NOTIFY);

    let larger = PanePlace {
        above: vec![Area {
            x: 100,
            y: 10,
            width: 20,
            height: 15,
        }],
        ..place(101, 61)
    };
    shown.window.place_pane(Some(&larger)).unwrap();
    assert_eq!(looker.geometry(child), [0, 0, 101, 61]);
    let known = shown.window.pane();
    let told = PaneWindow {
        window: pane,
        width: 101,
        height: 61,
    };
    assert_eq!(known, Some(told));
    let shape = looker.connection.shape_get_rectangles(pane, SK::BOUNDING);
    let shape = shape.unwrap().reply().unwrap().rectangles;
    let pixels: u32 = (shape.iter())
        .map(|part| u32::from(part.width) * u32::from(part.height))
        .sum();
    assert_eq!(pixels, 101 * 61 - 20 * 15);

    for round in 0..20 {
        shown.window.place_pane(None).unwrap();
        assert_eq!(shown.window.pane(), None);
        let root = looker.root();
        assert_eq!(looker.place(pane), Some((root, false)), "round {round}");
        assert!(looker.geometry(pane)[0] < -1000);
        assert_eq!(looker.place(child), Some((root, false)));
        shown
            .window
            .place_pane(Some(&place(50 + round, 40)))
            .unwrap();
        assert_eq!(
            shown.window.pane().unwrap().window,
            pane,
            "the same one again"
        );
        looker
            .connection
            .reparent_window(child, pane, 0, 0)
            .unwrap();
        looker.connection.map_window(child).unwrap();
        looker.connection.flush().unwrap();
        let wanted = [0, 0, 50 + round.cast_signed(), 40];
        shown.until("the size", |_| looker.geometry(child) == wanted);
    }
    // With the window it goes, too, and another window takes it.
    drop(shown);
    assert_eq!(looker.place(pane), Some((looker.root(), false)));
    assert_eq!(looker.place(child), Some((looker.root(), false)));
    let mut second = Shown::open(&server);
    assert!(second.window.place_pane(Some(&place(30, 20))).unwrap());
    assert_eq!(second.window.pane().unwrap().window, pane);
    let mut third = Shown::open(&server);
    assert!(third.window.place_pane(Some(&place(30, 20))).unwrap());
    assert_ne!(third.window.pane().unwrap().window, pane);
}

#[test]
fn a_pane_outlives_a_window_that_is_cut_off() {
    let server = Server::start();
    let looker = Looker::new(&server);
    for round in 0..20 {
        let mut shown = Shown::open(&server);
        shown.settle();
        let (pane, child) = filled(&mut shown, &looker);
        if round % 2 == 0 {
            looker.connection.kill_client(shown.id()).unwrap();
        } else {
            looker.connection.destroy_window(child).unwrap();
            looker.connection.kill_client(shown.id()).unwrap();
        }
        looker.sync();
        // The server itself has put it away.
        assert_eq!(looker.place(pane), Some((looker.root(), false)));
        until("the end", || shown.window.poll().err());
        drop(shown);
        if round % 2 == 0 {
            assert_eq!(looker.place(child), Some((looker.root(), false)));
        }
    }
}

#[test]
fn a_window_goes_on_if_the_panes_connection_is_cut() {
    let server = Server::start();
    let looker = Looker::new(&server);
    let mut shown = Shown::open(&server);
    shown.settle();
    for _ in 0..5 {
        let (pane, child) = filled(&mut shown, &looker);
        looker.connection.kill_client(pane).unwrap();
        looker.sync();
        assert_eq!(looker.place(pane), None);
        assert_eq!(
            looker.place(child),
            Some((looker.root(), false)),
            "the host's is safe"
        );
        shown.until("the news", |shown| shown.window.pane().is_none());
    }
    shown.paint();
    shown.settle();
}

#[test]
fn what_others_send_of_a_pane_is_not_believed() {
    use x11rb::protocol::xproto::{
        CREATE_NOTIFY_EVENT, CreateNotifyEvent, DESTROY_NOTIFY_EVENT, DestroyNotifyEvent,
        REPARENT_NOTIFY_EVENT, ReparentNotifyEvent,
    };
    let server = Server::start();
    let looker = Looker::new(&server);
    let mut shown = Shown::open(&server);
    shown.settle();
    let (pane, child) = filled(&mut shown, &looker);
    let other = looker.window(looker.root(), (11, 13), 24);
    let (id, root) = (shown.id(), looker.root());
    let created = CreateNotifyEvent {
        response_type: CREATE_NOTIFY_EVENT,
        parent: pane,
        window: other,
        ..CreateNotifyEvent::default()
    };
    let moved = |window, parent| ReparentNotifyEvent {
        response_type: REPARENT_NOTIFY_EVENT,
        event: pane,
        window,
        parent,
        ..ReparentNotifyEvent::default()
    };
    let destroyed = |window| DestroyNotifyEvent {
        response_type: DESTROY_NOTIFY_EVENT,
        event: pane,
        window,
        ..DestroyNotifyEvent::default()
    };
    looker.send(id, created);
    looker.send(id, moved(other, pane));
    looker.send(id, moved(child, root));
    looker.send(id, destroyed(child));
    looker.send(id, destroyed(pane));
    looker.sync();
    for _ in 0..20 {
        shown.turn();
    }
    assert_eq!(looker.geometry(other), [0, 0, 11, 13]);
    shown.window.place_pane(Some(&place(44, 55))).unwrap();
    assert_eq!(looker.geometry(child), [0, 0, 44, 55]);
}

#[test]
fn without_what_it_takes_there_is_no_pane() {
    let server = Server::with(&["-extension", "XFIXES"]);
    let mut shown = Shown::open(&server);
    shown.settle();
    assert!(!shown.window.place_pane(Some(&place(30, 20))).unwrap());
    assert_eq!(shown.window.pane(), None);
    shown.window.place_pane(None).unwrap();
}
