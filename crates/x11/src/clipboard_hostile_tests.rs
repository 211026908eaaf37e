//! The clipboard against programs that mean it ill, or die, or never answer.

use std::time::Duration;

use x11rb::connection::Connection as _;
use x11rb::protocol::Event;
use x11rb::protocol::xproto::{
    Atom, AtomEnum, ConnectionExt as _, EventMask, PropMode, Property, SelectionRequestEvent,
    Window,
};
use x11rb::wrapper::ConnectionExt as _;
use x11rb::{CURRENT_TIME, NONE};

use super::clipboard::Selection;
use super::clipboard_tests::{Fixture, long, notify, push};
use super::connection::Connection;
use super::testing::{Server, until};
use super::{incoming, outgoing};
use vides_engine::limits::MAX_CLIPBOARD_BYTES;

/// A program that owns the clipboard and does as a test tells it.
struct Owner {
    connection: Connection,
    window: Window,
}

impl Owner {
    fn new(server: &Server) -> Self {
        let connection = Connection::open(Some(server.display())).unwrap();
        let window = connection.generate_id().unwrap();
        incoming::create(&connection, window, EventMask::PROPERTY_CHANGE).unwrap();
        let clipboard = connection.atoms().CLIPBOARD;
        connection
            .set_selection_owner(window, clipboard, CURRENT_TIME)
            .unwrap()
            .check()
            .unwrap();
        Self { connection, window }
    }

    fn event(&self) -> Option<Event> {
        push(&self.connection);
        self.connection.poll_for_event().unwrap()
    }

    /// The next request for the clipboard.
    fn request(&self) -> SelectionRequestEvent {
        until("a request", || match self.event() {
            Some(Event::SelectionRequest(event)) => Some(event),
            _ => None,
        })
    }

    fn write(&self, to: &SelectionRequestEvent, kind: Atom, bytes: &[u8]) {
        let mode = PropMode::APPEND;
        for piece in bytes.chunks(1 << 17) {
            self.connection
                .change_property8(mode, to.requestor, to.property, kind, piece)
                .unwrap()
                .ignore_error();
        }
    }

    fn notify(&self, to: &SelectionRequestEvent, property: Atom) {
        notify(&self.connection, to, property);
    }
}

#[test]
#[expect(clippy::too_many_lines)] // told in one piece
fn owners_that_mean_it_ill_cost_neither_time_nor_memory() {
    let server = Server::start();
    let mut fixture = Fixture::new(&server);
    let owner = Owner::new(&server);
    let atoms = *owner.connection.atoms();
    let ends = |fixture: &mut Fixture, what: &str| {
        until(what, || {
            push(&owner.connection);
            fixture.poll();
            fixture.is_quiet().then_some(())
        });
        assert_eq!(fixture.pasted(), None, "{what}");
    };

    // No answer at all.
    fixture.request(Selection::Clipboard);
    owner.request();
    fixture.poll();
    assert!(!fixture.is_quiet());
    fixture.give_up_after(Duration::from_secs(4));
    assert!(!fixture.is_quiet());
    fixture.give_up_after(Duration::from_secs(6));
    assert!(fixture.is_quiet());

    // More requests than anybody makes.
    for _ in 0..100 {
        fixture.request(Selection::Clipboard);
    }
    fixture.give_up_after(Duration::from_secs(6));
    let waiting = || matches!(owner.event(), Some(Event::SelectionRequest(_)));
    let mut asked = 0;
    until("eight requests", || {
        asked += usize::from(waiting());
        (asked == 8).then_some(())
    });
    assert!(!waiting());

    // An answer without a property; wrong kinds; numbers instead of text.
    fixture.request(Selection::Clipboard);
    let request = owner.request();
    owner.notify(&request, request.property);
    ends(&mut fixture, "nothing");
    for kind in [atoms.TARGETS, atoms.ATOM_PAIR, AtomEnum::PIXMAP.into()] {
        fixture.request(Selection::Clipboard);
        let request = owner.request();
        owner.write(&request, kind, b"text");
        owner.notify(&request, request.property);
        ends(&mut fixture, "a wrong kind");
    }
    fixture.request(Selection::Clipboard);
    let request = owner.request();
    owner
        .connection
        .change_property32(
            PropMode::REPLACE,
            request.requestor,
            request.property,
            atoms.UTF8_STRING,
            &[1, 2, 3],
        )
        .unwrap()
        .ignore_error();
    owner.notify(&request, request.property);
    ends(&mut fixture, "numbers");

    // Bytes that are no UTF-8 do not end in a panic; what is text stays.
    fixture.request(Selection::Clipboard);
    let request = owner.request();
    owner.write(&request, atoms.UTF8_STRING, b"a\xFF\xFEb\0");
    owner.notify(&request, request.property);
    let pasted = until("text", || {
        fixture.poll();
        fixture.pasted()
    });
    assert_eq!(pasted, "a\u{FFFD}\u{FFFD}b");

    // One that knows Latin-1 only.
    fixture.request(Selection::Clipboard);
    let mut request = owner.request();
    while request.target != u32::from(AtomEnum::STRING) {
        owner.notify(&request, NONE);
        request = until("the next target", || {
            fixture.poll();
            match owner.event() {
                Some(Event::SelectionRequest(event)) => Some(event),
                _ => None,
            }
        });
    }
    owner.write(&request, AtomEnum::STRING.into(), b"Gr\xFC\xDFe");
    owner.notify(&request, request.property);
    let pasted = until("text", || {
        fixture.poll();
        fixture.pasted()
    });
    assert_eq!(pasted, "Grüße");

    // A property that is too large.
    fixture.request(Selection::Clipboard);
    let request = owner.request();
    owner.write(
        &request,
        atoms.UTF8_STRING,
        &vec![b'x'; MAX_CLIPBOARD_BYTES + 1],
    );
    owner.notify(&request, request.property);
    ends(&mut fixture, "a huge property");

    // Pieces of which the first announces too much.
    fixture.request(Selection::Clipboard);
    let request = owner.request();
    let announce = |size: u32| {
        owner
            .connection
            .change_property32(
                PropMode::REPLACE,
                request.requestor,
                request.property,
                atoms.INCR,
                &[size],
            )
            .unwrap()
            .ignore_error();
    };
    announce(u32::MAX);
    owner.notify(&request, request.property);
    ends(&mut fixture, "a boastful owner");
}

#[test]
fn pieces_without_an_end_end() {
    let server = Server::start();
    let mut fixture = Fixture::new(&server);
    let owner = Owner::new(&server);
    let atoms = *owner.connection.atoms();
    let begin = |fixture: &mut Fixture| {
        fixture.request(Selection::Clipboard);
        let request = owner.request();
        outgoing::listen(&owner.connection, request.requestor, true).unwrap();
        owner
            .connection
            .change_property32(
                PropMode::REPLACE,
                request.requestor,
                request.property,
                atoms.INCR,
                &[10],
            )
            .unwrap();
        owner.notify(&request, request.property);
        request
    };
    let taken = |fixture: &mut Fixture| {
        fixture.poll();
        matches!(owner.event(), Some(Event::PropertyNotify(event)) if event.state == Property::DELETE)
    };

    // Large ones, until it is too much.
    let request = begin(&mut fixture);
    let piece = vec![b'x'; 1 << 17];
    let mut pieces = 0;
    until("the end", || {
        if taken(&mut fixture) {
            owner.write(&request, atoms.UTF8_STRING, &piece);
            owner.connection.flush().unwrap();
            pieces += 1;
        }
        fixture.is_quiet().then_some(())
    });
    assert!(pieces << 17 <= MAX_CLIPBOARD_BYTES + (2 << 20), "{pieces}");
    assert_eq!(fixture.pasted(), None);

    // Small ones, each just in time, until it has lasted too long.
    let request = begin(&mut fixture);
    for _ in 0..3 {
        until("a deletion", || taken(&mut fixture).then_some(()));
        owner.write(&request, atoms.UTF8_STRING, b"y");
        owner.connection.flush().unwrap();
    }
    fixture.give_up_after(Duration::from_secs(61));
    assert!(fixture.is_quiet());
    assert_eq!(fixture.pasted(), None);

    // It stops in the middle; what comes later finds nobody.
    let request = begin(&mut fixture);
    until("a deletion", || taken(&mut fixture).then_some(()));
    fixture.give_up_after(Duration::from_secs(6));
    owner.write(&request, atoms.UTF8_STRING, b"late");
    owner.notify(&request, request.property);
    for _ in 0..20 {
        fixture.poll();
        std::thread::sleep(Duration::from_millis(1));
    }
    assert_eq!(fixture.pasted(), None);

    // And all is well afterwards.
    let request = begin(&mut fixture);
    for piece in ["ab", "c€"] {
        until("a deletion", || taken(&mut fixture).then_some(()));
        owner.write(&request, atoms.UTF8_STRING, piece.as_bytes());
        owner.connection.flush().unwrap();
    }
    until("a deletion", || taken(&mut fixture).then_some(()));
    owner
        .connection
        .change_property8(
            PropMode::REPLACE,
            request.requestor,
            request.property,
            atoms.UTF8_STRING,
            b"",
        )
        .unwrap();
    owner.connection.flush().unwrap();
    let pasted = until("the text", || {
        fixture.poll();
        fixture.pasted()
    });
    assert_eq!(pasted, "abc€");
}

#[test]
fn requestors_are_served_within_bounds() {
    let server = Server::start();
    let mut fixture = Fixture::new(&server);
    fixture.own(Selection::Clipboard, &long());
    let other = Owner::new(&server);
    let atoms = *other.connection.atoms();
    // The other took the clipboard as it began; it is taken back.
    fixture.own(Selection::Clipboard, &long());
    let ask = |window: Window, target: Atom, property: Atom| {
        other
            .connection
            .convert_selection(window, atoms.CLIPBOARD, target, property, CURRENT_TIME)
            .unwrap();
        other.connection.flush().unwrap();
    };
    let answer = |fixture: &mut Fixture| {
        until("an answer", || {
            fixture.poll();
            match other.event() {
                Some(Event::SelectionNotify(event)) => Some(event.property),
                _ => None,
            }
        })
    };
    // Several at once; those that we do not know are crossed out.
    let list = [
        atoms.TIMESTAMP,
        atoms.TARGETS,
        atoms._NET_WM_ICON,
        atoms.TEXT,
        atoms.MULTIPLE,
        atoms.MULTIPLE,
    ];
    let property = atoms._VIDES_SELECTION;
    other
        .connection
        .change_property32(
            PropMode::REPLACE,
            other.window,
            property,
            atoms.ATOM_PAIR,
            &list,
        )
        .unwrap();
    ask(other.window, atoms.MULTIPLE, property);
    assert_eq!(answer(&mut fixture), property);
    let asked = other
        .connection
        .get_property(false, other.window, property, AtomEnum::ANY, 0, 100)
        .unwrap();
    let pairs: Vec<Atom> = asked.reply().unwrap().value32().unwrap().collect();
    let crossed_out = [
        atoms.TIMESTAMP,
        atoms.TARGETS,
        atoms._NET_WM_ICON,
        NONE,
        atoms.MULTIPLE,
        NONE,
    ];
    assert_eq!(pairs, crossed_out);
    // A large text begun for many, then nobody takes it: no more than so many
    // are begun, and all are given up.
    for number in 0..100 {
        ask(other.window, atoms.UTF8_STRING, number + 1);
    }
    let begun = (0..100).filter(|_| answer(&mut fixture) != NONE).count();
    assert_eq!(begun, 16);
    fixture.give_up_after(Duration::from_secs(6));
    assert!(fixture.is_quiet());
    // One that goes away in the middle.
    let window = other.connection.generate_id().unwrap();
    incoming::create(&other.connection, window, EventMask::NO_EVENT).unwrap();
    ask(window, atoms.UTF8_STRING, property);
    assert_eq!(answer(&mut fixture), property);
    assert!(!fixture.is_quiet());
    other.connection.destroy_window(window).unwrap();
    other.connection.flush().unwrap();
    until("quiet", || {
        fixture.poll();
        fixture.is_quiet().then_some(())
    });
    // A request in the name of a window of ours must not make it deaf.
    let ours = fixture.connection.generate_id().unwrap();
    incoming::create(&fixture.connection, ours, EventMask::PROPERTY_CHANGE).unwrap();
    fixture.connection.flush().unwrap();
    ask(ours, atoms.UTF8_STRING, property);
    for _ in 0..20 {
        fixture.poll();
        std::thread::sleep(Duration::from_millis(1));
    }
    let asked = fixture.connection.get_window_attributes(ours).unwrap();
    let mask = asked.reply().unwrap().your_event_mask;
    assert_eq!(mask, EventMask::PROPERTY_CHANGE);
    assert!(fixture.is_quiet());
}
