//! The clipboard against a real server: with xclip, with another of ours, with a
//! clipboard manager.

use std::io::Write as _;
use std::process::{Child, Stdio};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::time::{Duration, Instant};

use egui::Event as Input;
use x11rb::connection::Connection as _;
use x11rb::protocol::Event;
use x11rb::protocol::xproto::{
    Atom, AtomEnum, ConnectionExt as _, EventMask, SELECTION_NOTIFY_EVENT, SelectionNotifyEvent,
    SelectionRequestEvent,
};
use x11rb::{CURRENT_TIME, NONE};

use super::clipboard::{Clipboard, Selection};
use super::connection::Connection;
use super::incoming;
use super::testing::{Server, until};

/// One program with a clipboard of ours.
pub(super) struct Fixture {
    pub(super) connection: Connection,
    clipboard: Clipboard,
    heard: Vec<Input>,
}

impl Fixture {
    pub(super) fn new(server: &Server) -> Self {
        let connection = Connection::open(Some(server.display())).unwrap();
        connection.settle();
        Self {
            connection,
            clipboard: Clipboard::new(),
            heard: Vec::new(),
        }
    }

    pub(super) fn poll(&mut self) {
        while let Some(event) = self.connection.poll_for_event().unwrap() {
            let taken = self
                .clipboard
                .handle(&self.connection, &event, &mut self.heard);
            taken.unwrap();
        }
        push(&self.connection);
    }

    pub(super) fn own(&mut self, which: Selection, text: &str) {
        let owned = self
            .clipboard
            .own(&self.connection, which, text, CURRENT_TIME);
        owned.unwrap();
    }

    pub(super) fn request(&mut self, which: Selection) {
        let place = (which == Selection::Primary).then(|| egui::pos2(3.0, 4.0));
        self.clipboard
            .request(
                &self.connection,
                which,
                CURRENT_TIME,
                place,
                &mut self.heard,
            )
            .unwrap();
        self.connection.flush().unwrap();
    }

    /// The text that was pasted, if one was.
    pub(super) fn pasted(&mut self) -> Option<String> {
        match self.heard.pop()? {
            Input::Paste(text) => Some(text),
            Input::MiddleClickPaste { pos, text } => {
                assert_eq!(pos, egui::pos2(3.0, 4.0));
                Some(text)
            }
            other => panic!("{other:?}"),
        }
    }

    /// Nothing is under way any more.
    pub(super) fn is_quiet(&self) -> bool {
        self.clipboard.deadline().is_none()
    }

    pub(super) fn give_up_after(&mut self, wait: Duration) {
        let late = Instant::now() + wait;
        self.clipboard.tick(&self.connection, late).unwrap();
        self.connection.flush().unwrap();
    }
}

/// Sends what the socket takes; the rest waits for the next time.
pub(super) fn push(connection: &Connection) {
    connection.flush().unwrap();
    connection.stream().push().unwrap();
}

/// About five megabytes with signs of one to four bytes, no two lines equal.
pub(super) fn long() -> String {
    (0..150_000)
        .map(|line| format!("{line} äöü € 𝄞 line of text\n"))
        .collect()
}

fn name(which: Selection) -> &'static str {
    match which {
        Selection::Clipboard => "clipboard",
        Selection::Primary => "primary",
    }
}

/// What xclip makes of our selection.
fn xclip_reads(server: &Server, fixture: &mut Fixture, which: Selection, target: &str) -> Vec<u8> {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("text");
    let mut xclip = server
        .command("xclip")
        .args(["-o", "-selection", name(which), "-t", target])
        .stdout(std::fs::File::create(&file).unwrap())
        .spawn()
        .unwrap();
    until("xclip", || {
        fixture.poll();
        xclip.try_wait().unwrap()
    });
    until("quiet", || {
        fixture.poll();
        fixture.is_quiet().then_some(())
    });
    std::fs::read(file).unwrap()
}

/// An xclip that owns a selection until it is killed.
fn xclip_owns(server: &Server, which: Selection, text: &[u8]) -> Child {
    let mut xclip = server
        .command("xclip")
        .args(["-i", "-selection", name(which), "-quiet"])
        .stdin(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    xclip.stdin.take().unwrap().write_all(text).unwrap();
    xclip
}

const BOTH: [Selection; 2] = [Selection::Clipboard, Selection::Primary];

#[test]
fn others_read_what_we_own() {
    let server = Server::start();
    let mut fixture = Fixture::new(&server);
    for which in BOTH {
        fixture.own(which, "a = 1 €");
        assert_eq!(
            xclip_reads(&server, &mut fixture, which, "UTF8_STRING"),
            "a = 1 €".as_bytes()
        );
        assert_eq!(
            xclip_reads(&server, &mut fixture, which, "STRING"),
            b"a = 1 ?"
        );
        let targets = xclip_reads(&server, &mut fixture, which, "TARGETS");
        let targets = String::from_utf8(targets).unwrap();
        for target in [
            "UTF8_STRING",
            "text/plain;charset=utf-8",
            "TEXT",
            "STRING",
            "MULTIPLE",
        ] {
            assert!(targets.lines().any(|line| line == target), "{targets}");
        }
        assert_eq!(xclip_reads(&server, &mut fixture, which, "image/png"), b"");
        let long = long();
        fixture.own(which, &long);
        assert!(xclip_reads(&server, &mut fixture, which, "UTF8_STRING") == long.as_bytes());
    }
}

#[test]
fn we_read_what_others_own() {
    let server = Server::start();
    let mut fixture = Fixture::new(&server);
    let long = long();
    for which in BOTH {
        for text in ["kurz: ß", &long] {
            let mut xclip = xclip_owns(&server, which, text.as_bytes());
            // xclip becomes the owner when it has read everything.
            let selection = match which {
                Selection::Clipboard => fixture.connection.atoms().CLIPBOARD,
                Selection::Primary => AtomEnum::PRIMARY.into(),
            };
            until("an owner", || {
                let asked = fixture.connection.get_selection_owner(selection).unwrap();
                (asked.reply().unwrap().owner != NONE).then_some(())
            });
            fixture.request(which);
            let pasted = until("the text", || {
                fixture.poll();
                fixture.pasted()
            });
            assert!(pasted == text, "{} bytes", pasted.len());
            assert!(fixture.is_quiet());
            xclip.kill().unwrap();
            xclip.wait().unwrap();
            until("no owner", || {
                let asked = fixture.connection.get_selection_owner(selection).unwrap();
                (asked.reply().unwrap().owner == NONE).then_some(())
            });
        }
        // Nobody owns it any more: the server says so at once. The key was
        // pressed all the same.
        fixture.request(which);
        until("quiet", || {
            fixture.poll();
            fixture.is_quiet().then_some(())
        });
        let key = (which == Selection::Clipboard).then(String::new);
        assert_eq!(fixture.pasted(), key);
    }
}

#[test]
fn two_windows_of_one_thread_share_texts() {
    let server = Server::start();
    let (mut one, mut two) = (Fixture::new(&server), Fixture::new(&server));
    let long = long();
    one.own(Selection::Clipboard, &long);
    one.own(Selection::Primary, "marked");
    for _ in 0..3 {
        two.request(Selection::Clipboard);
    }
    two.request(Selection::Primary);
    let mut pasted = Vec::new();
    until("four texts", || {
        one.poll();
        two.poll();
        pasted.extend(two.pasted());
        (pasted.len() == 4).then_some(())
    });
    assert_eq!(pasted.iter().filter(|text| **text == long).count(), 3);
    assert!(pasted.iter().any(|text| text == "marked"));
    until("quiet", || {
        one.poll();
        (one.is_quiet() && two.is_quiet()).then_some(())
    });
    // Our own text comes at once, without the server.
    one.request(Selection::Primary);
    assert_eq!(one.pasted().as_deref(), Some("marked"));
    // When the other takes it, it is ours no more.
    two.own(Selection::Primary, "other");
    until("the loss", || {
        one.poll();
        one.request(Selection::Primary);
        two.poll();
        one.poll();
        one.pasted().filter(|text| text == "other")
    });
}

#[test]
fn a_clipboard_manager_takes_the_text_over() {
    let server = Server::start();
    let mut fixture = Fixture::new(&server);
    let long = long();
    fixture.own(Selection::Clipboard, &long);
    // Without a manager there is nothing to wait for.
    let begun = Instant::now();
    let hand_over =
        |fixture: &mut Fixture, limit| fixture.clipboard.hand_over(&fixture.connection, limit);
    hand_over(&mut fixture, Duration::from_secs(10)).unwrap();
    assert!(begun.elapsed() < Duration::from_secs(5));

    let (ready, is_ready) = channel();
    let (go, told_to_go) = channel();
    let server = &server;
    std::thread::scope(|scope| {
        let served = scope.spawn(move || serve_as_manager(server, &ready, &told_to_go));
        is_ready.recv().unwrap();
        // One that does nothing holds nobody up for long.
        let begun = Instant::now();
        hand_over(&mut fixture, Duration::from_millis(50)).unwrap();
        assert!(begun.elapsed() < Duration::from_secs(5));
        go.send(()).unwrap();
        hand_over(&mut fixture, Duration::from_secs(20)).unwrap();
        hand_over(&mut fixture, Duration::from_secs(20)).unwrap();
        go.send(()).unwrap();
        for text in served.join().unwrap() {
            assert!(text == long);
        }
    });
}

/// Takes over the clipboard's text twice: for the request that is waiting when
/// it is told to go, and for one more.
fn serve_as_manager(server: &Server, ready: &Sender<()>, go: &Receiver<()>) -> Vec<String> {
    let mut manager = Fixture::new(server);
    let window = manager.connection.generate_id().unwrap();
    incoming::create(&manager.connection, window, EventMask::NO_EVENT).unwrap();
    let role = manager.connection.atoms().CLIPBOARD_MANAGER;
    let asked = manager
        .connection
        .set_selection_owner(window, role, CURRENT_TIME);
    asked.unwrap().check().unwrap();
    ready.send(()).unwrap();
    go.recv().unwrap();
    let serve = |_| {
        let request = until("a request", || {
            match manager.connection.poll_for_event().unwrap() {
                Some(Event::SelectionRequest(event)) => Some(event),
                _ => None,
            }
        });
        manager.request(Selection::Clipboard);
        let text = until("the text", || {
            manager.poll();
            manager.pasted()
        });
        notify(&manager.connection, &request, request.property);
        text
    };
    let texts = (0..2).map(serve).collect();
    // Its last answer must not be lost with its connection.
    go.recv().unwrap();
    texts
}

/// Tells who asked that the answer is there.
pub(super) fn notify(connection: &Connection, to: &SelectionRequestEvent, property: Atom) {
    let answer = SelectionNotifyEvent {
        response_type: SELECTION_NOTIFY_EVENT,
        sequence: 0,
        time: to.time,
        requestor: to.requestor,
        selection: to.selection,
        target: to.target,
        property,
    };
    let sent = connection.send_event(false, to.requestor, EventMask::NO_EVENT, answer);
    sent.unwrap().ignore_error();
    connection.flush().unwrap();
}
