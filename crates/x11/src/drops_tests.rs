//! Files dropped on a window by another program, which may mean it ill.

use std::path::PathBuf;
use std::time::{Duration, Instant};

use x11rb::connection::Connection as _;
use x11rb::protocol::Event;
use x11rb::protocol::xproto::{
    Atom, AtomEnum, ClientMessageEvent, ConnectionExt as _, EventMask, PropMode,
    SelectionRequestEvent,
};
use x11rb::wrapper::ConnectionExt as _;
use x11rb::{CURRENT_TIME, NONE};

use super::clipboard_tests::{notify, push};
use super::connection::Connection;
use super::testing::{Server, until};
use super::{Options, Window, incoming};

/// A program from which something is dragged over a window of ours.
struct Source {
    connection: Connection,
    own: u32,
    window: Window,
}

/// What the source hears.
#[derive(Debug, PartialEq)]
enum Heard {
    /// Whether it may drop.
    Status(bool),
    /// Whether the drop was taken.
    Finished(bool),
    Asked(Atom),
}

impl Source {
    fn new(server: &Server) -> Self {
        let window = Window::open(&Options {
            display: Some(server.display().to_owned()),
            size: [300.0, 200.0],
            ..Options::default()
        });
        let connection = Connection::open(Some(server.display())).unwrap();
        let own = connection.generate_id().unwrap();
        incoming::create(&connection, own, EventMask::PROPERTY_CHANGE).unwrap();
        let selection = connection.atoms().XdndSelection;
        let owned = connection.set_selection_owner(own, selection, CURRENT_TIME);
        owned.unwrap().check().unwrap();
        Self {
            connection,
            own,
            window: window.unwrap(),
        }
    }

    fn send(&self, kind: Atom, data: [u32; 4]) {
        let to = self.window.frame.window;
        let data = [self.own, data[0], data[1], data[2], data[3]];
        let message = ClientMessageEvent::new(32, to, kind, data);
        let sent = (self.connection).send_event(false, to, EventMask::NO_EVENT, message);
        sent.unwrap().ignore_error();
        push(&self.connection);
    }

    fn enter(&self, version: u32, types: [Atom; 3]) {
        let more = u32::from(types == [NONE; 3]);
        let kind = self.connection.atoms().XdndEnter;
        self.send(kind, [version << 24 | more, types[0], types[1], types[2]]);
    }

    fn over(&self) {
        let atoms = self.connection.atoms();
        let data = [0, 30 << 16 | 40, CURRENT_TIME, atoms.XdndActionCopy];
        self.send(atoms.XdndPosition, data);
    }

    fn drop(&self) {
        self.send(self.connection.atoms().XdndDrop, [0, CURRENT_TIME, 0, 0]);
    }

    fn event(&mut self) -> Option<Event> {
        self.window.poll().unwrap();
        push(&self.connection);
        self.connection.poll_for_event().unwrap()
    }

    fn next(&mut self) -> (Heard, Event) {
        let atoms = *self.connection.atoms();
        until("an answer", || {
            let event = self.event()?;
            let heard = match &event {
                Event::ClientMessage(message) => {
                    let data = message.data.as_data32();
                    assert_eq!(data[0], self.window.frame.window);
                    let yes = data[1] & 1 != 0;
                    if message.type_ == atoms.XdndStatus {
                        let action = if yes { atoms.XdndActionCopy } else { NONE };
                        assert_eq!(data[4], action);
                        Heard::Status(yes)
                    } else {
                        assert_eq!(message.type_, atoms.XdndFinished);
                        Heard::Finished(yes)
                    }
                }
                Event::SelectionRequest(request) => Heard::Asked(request.target),
                _ => return None,
            };
            Some((heard, event))
        })
    }

    fn hears(&mut self, expected: Heard) {
        assert_eq!(self.next().0, expected);
    }

    fn asked(&mut self) -> SelectionRequestEvent {
        match self.next().1 {
            Event::SelectionRequest(request) => request,
            other => panic!("{other:?}"),
        }
    }

    /// Answers a request.
    fn give(&self, to: &SelectionRequestEvent, kind: Atom, bytes: &[u8]) {
        for piece in bytes.chunks(1 << 16) {
            let mode = PropMode::APPEND;
            let connection = &self.connection;
            let asked = connection.change_property8(mode, to.requestor, to.property, kind, piece);
            asked.unwrap().ignore_error();
        }
        notify(&self.connection, to, to.property);
        push(&self.connection);
    }

    /// Nothing more comes of what was sent.
    fn is_quiet(&mut self) -> bool {
        // The window has seen all that was sent before the server answered.
        let asked = self.connection.get_input_focus().unwrap();
        push(&self.connection);
        asked.reply().unwrap();
        (0..20).all(|_| {
            std::thread::sleep(Duration::from_millis(5));
            !matches!(
                self.event(),
                Some(Event::ClientMessage(_) | Event::SelectionRequest(_))
            )
        })
    }

    fn dropped(&mut self) -> Vec<PathBuf> {
        let files = self.window.take_input().dropped_files;
        files.iter().map(|file| file.path().to_owned()).collect()
    }
}

#[test]
fn files_are_taken_and_what_else_is_dragged_is_refused() {
    let server = Server::start();
    let mut source = Source::new(&server);
    let atoms = *source.connection.atoms();
    let aware = source.connection.get_property(
        false,
        source.window.frame.window,
        atoms.XdndAware,
        AtomEnum::ATOM,
        0,
        1,
    );
    let aware = aware.unwrap().reply().unwrap();
    assert_eq!(aware.value32().unwrap().collect::<Vec<_>>(), [5]);

    for many in [false, true] {
        if many {
            let (own, kind) = (source.own, AtomEnum::ATOM);
            let types = [
                atoms.TEXT,
                atoms.UTF8_STRING,
                atoms.INCR,
                atoms.TEXT_URI_LIST,
            ];
            let (mode, list) = (PropMode::REPLACE, atoms.XdndTypeList);
            let asked = source
                .connection
                .change_property32(mode, own, list, kind, &types);
            asked.unwrap().check().unwrap();
            source.enter(5, [NONE; 3]);
        } else {
            source.enter(4, [atoms.TEXT_PLAIN, atoms.TEXT_URI_LIST, NONE]);
        }
        source.over();
        source.hears(Heard::Status(true));
        source.drop();
        let request = source.asked();
        assert_eq!(request.target, atoms.TEXT_URI_LIST);
        let list = b"# two\r\nfile:///tmp/a%20b.vid\r\nfile://localhost/%C3%A4.obj\r\n";
        source.give(&request, atoms.TEXT_URI_LIST, list);
        source.hears(Heard::Finished(true));
        assert_eq!(
            source.dropped(),
            ["/tmp/a b.vid", "/ä.obj"].map(PathBuf::from)
        );
        assert!(source.dropped().is_empty());
    }

    // A text; a source that is too old; one that leaves.
    source.enter(5, [atoms.TEXT_PLAIN, atoms.UTF8_STRING, NONE]);
    source.over();
    source.hears(Heard::Status(false));
    source.drop();
    source.hears(Heard::Finished(false));
    source.enter(2, [atoms.TEXT_URI_LIST, NONE, NONE]);
    source.over();
    source.drop();
    assert!(source.is_quiet());
    source.enter(5, [atoms.TEXT_URI_LIST, NONE, NONE]);
    source.send(atoms.XdndLeave, [0; 4]);
    source.drop();
    assert!(source.is_quiet() && source.dropped().is_empty());
}

#[test]
fn sources_that_mean_it_ill_cost_neither_time_nor_memory() {
    let server = Server::start();
    let mut source = Source::new(&server);
    let atoms = *source.connection.atoms();
    let files = [atoms.TEXT_URI_LIST, NONE, NONE];
    // Messages out of order, of windows that are not there, again and again.
    source.drop();
    source.over();
    for kind in [atoms.XdndStatus, atoms.XdndFinished, atoms.XdndLeave] {
        source.send(kind, [u32::MAX; 4]);
    }
    let own = std::mem::replace(&mut source.own, 0x7fff_ffff);
    for _ in 0..500 {
        source.enter(5, [NONE; 3]);
        source.enter(255, files);
        source.over();
    }
    source.drop();
    source.own = own;
    // That one has no window to answer with: it is the selection's owner who is asked.
    let request = source.asked();
    notify(&source.connection, &request, NONE);
    assert!(source.is_quiet());

    // Wrong kinds, nothing, numbers, no files, too much: each is refused.
    let long = vec![b'x'; (1 << 20) + 1];
    let wrong: [(Atom, &[u8]); 4] = [
        (atoms.ATOM_PAIR, b"file:///a"),
        (atoms.TEXT_URI_LIST, b""),
        (atoms.TEXT_URI_LIST, b"\r\n# nothing\r\n"),
        (atoms.TEXT_URI_LIST, &long),
    ];
    for (kind, bytes) in wrong {
        source.enter(5, files);
        source.drop();
        let request = source.asked();
        source.give(&request, kind, bytes);
        source.hears(Heard::Finished(false));
    }
    // More than is taken, in pieces; a second drop meanwhile.
    source.enter(5, files);
    source.drop();
    let request = source.asked();
    source.enter(5, files);
    source.over();
    source.hears(Heard::Status(false));
    source.drop();
    source.hears(Heard::Finished(false));
    let (mode, property) = (PropMode::REPLACE, request.property);
    let connection = &source.connection;
    let size =
        connection.change_property32(mode, request.requestor, property, atoms.INCR, &[1 << 30]);
    size.unwrap().ignore_error();
    notify(&source.connection, &request, property);
    source.hears(Heard::Finished(false));

    // No answer at all.
    source.enter(5, files);
    source.drop();
    source.asked();
    assert!(source.window.deadline().is_some());
    let late = Instant::now() + Duration::from_secs(6);
    let window = &mut source.window;
    let ours = window.frame.window;
    window.drops.tick(&window.connection, ours, late).unwrap();
    window.flush().unwrap();
    source.hears(Heard::Finished(false));
    // And one that is gone before it is told.
    source.enter(5, files);
    source.over();
    source.hears(Heard::Status(true));
    source.over();
    source
        .connection
        .destroy_window(source.own)
        .unwrap()
        .ignore_error();
    source.drop();
    assert!(source.is_quiet() && source.dropped().is_empty());
    until("the end of the transfer", || {
        source.event();
        source.window.drops.deadline().is_none().then_some(())
    });
}
