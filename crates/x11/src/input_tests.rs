//! A whole window with text fields in it, used by other programs' hands: what
//! is typed, copied, marked and pasted, and the pointer's shape over it.

use std::io::Write as _;
use std::process::{Child, Stdio};

use egui::{CursorIcon, Modifiers, PointerButton as PointerButtonKind, pos2};
use x11rb::CURRENT_TIME;
use x11rb::connection::{Connection as _, RequestConnection as _};
use x11rb::errors::ParseError;
use x11rb::protocol::xproto::{ConnectionExt as _, GrabMode, InputFocus};
use x11rb::x11_utils::TryParse;

use super::connection::Connection;
use super::testing::{Server, until};
use super::{MOST_EVENTS, Options, Window, first_deed};

/// A window with two fields, one above the other.
struct Fixture<'a> {
    server: &'a Server,
    window: Window,
    egui: egui::Context,
    fields: [String; 2],
}

impl<'a> Fixture<'a> {
    fn new(server: &'a Server) -> Self {
        let options = Options {
            display: Some(server.display().to_owned()),
            title: "VIDES".to_owned(),
            application: "a host".to_owned(),
            size: [300.0, 200.0],
            smallest: [100.0, 80.0],
            ..Options::default()
        };
        let mut fixture = Self {
            server,
            window: Window::open(&options).unwrap(),
            egui: egui::Context::default(),
            fields: <[String; 2]>::default(),
        };
        fixture.until("a visible window", |fixture| fixture.window.visible());
        fixture
    }

    /// One turn as the owner of a window does it, without the painting.
    fn turn(&mut self) {
        self.window.poll().unwrap();
        let input = self.window.take_input();
        let fields = &mut self.fields;
        let mut output = self.egui.run_ui(input, |ui| {
            for field in fields.iter_mut() {
                ui.add_sized([280.0, 40.0], egui::TextEdit::singleline(field));
            }
        });
        output.textures_delta.clear();
        self.window.take_output(output.platform_output).unwrap();
    }

    fn until(&mut self, what: &str, mut holds: impl FnMut(&mut Self) -> bool) {
        until(what, || {
            self.turn();
            holds(self).then_some(())
        });
    }

    /// Runs a program to its end and gives the window time to take it in.
    fn run(&mut self, program: &str, arguments: &[&str]) {
        let command = self.server.command(program).args(arguments).spawn();
        let mut command = command.unwrap();
        self.until(program, |_| command.try_wait().unwrap().is_some());
        for _ in 0..10 {
            self.turn();
        }
    }

    fn xdotool(&mut self, arguments: &[&str]) {
        self.run("xdotool", arguments);
    }

    fn holds(&mut self, field: usize, text: &str) {
        self.until(text, |fixture| fixture.fields[field] == text);
    }

    /// What xclip reads from a selection of ours.
    fn xclip(&mut self, selection: &str) -> String {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("text");
        let xclip = self
            .server
            .command("xclip")
            .args(["-o", "-selection", selection, "-t", "UTF8_STRING"])
            .stdout(std::fs::File::create(&file).unwrap())
            .spawn();
        let mut xclip = xclip.unwrap();
        self.until("xclip", |_| xclip.try_wait().unwrap().is_some());
        std::fs::read_to_string(file).unwrap()
    }

    /// An xclip that owns a selection until it is killed.
    fn owned_by_xclip(&mut self, selection: &str, text: &str) -> Child {
        let xclip = self
            .server
            .command("xclip")
            .args(["-i", "-selection", selection, "-quiet"])
            .stdin(Stdio::piped())
            .stderr(Stdio::null())
            .spawn();
        let mut xclip = xclip.unwrap();
        let mut input = xclip.stdin.take().unwrap();
        input.write_all(text.as_bytes()).unwrap();
        drop(input);
        // Until then it is we that are asked.
        until("xclip", || (self.xclip(selection) == text).then_some(()));
        xclip
    }

    /// The serial number of the shape that the pointer has, and its size.
    fn shape(&self) -> Shape {
        let connection = &self.window.connection;
        let name = "XFIXES";
        let found = connection.extension_information(name).unwrap().unwrap();
        let major = found.major_opcode;
        let version = [major, 0, 3, 0, 5, 0, 0, 0, 0, 0, 0, 0];
        let slices = [std::io::IoSlice::new(&version)];
        let asked = connection.send_request_with_reply::<Shape>(&slices, Vec::new());
        asked.unwrap().reply().unwrap();
        let image = [major, 4, 1, 0];
        let slices = [std::io::IoSlice::new(&image)];
        let asked = connection.send_request_with_reply::<Shape>(&slices, Vec::new());
        asked.unwrap().reply().unwrap()
    }
}

/// The beginning of XFIXES' answer to GetCursorImage.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Shape {
    width: u16,
    serial: u32,
}

impl TryParse for Shape {
    fn try_parse(reply: &[u8]) -> Result<(Self, &[u8]), ParseError> {
        let short = ParseError::InsufficientData;
        let (head, rest) = reply.split_at_checked(32).ok_or(short)?;
        let shape = Self {
            width: u16::from_le_bytes([head[12], head[13]]),
            serial: u32::from_le_bytes([head[20], head[21], head[22], head[23]]),
        };
        Ok((shape, rest))
    }
}

#[test]
fn texts_are_typed_copied_marked_and_pasted() {
    let server = Server::start();
    let mut fixture = Fixture::new(&server);
    fixture.run("setxkbmap", &["-layout", "de"]);
    // A click into the first field, then ´ and e, @ by AltGr, and umlauts.
    fixture.xdotool(&["mousemove", "100", "20", "click", "1"]);
    fixture.xdotool(&[
        "key", "21", "key", "26", "keydown", "108", "key", "24", "keyup", "108",
    ]);
    fixture.xdotool(&["key", "48", "key", "47", "key", "20"]);
    fixture.holds(0, "é@äöß");
    // Copied and marked, then cut.
    fixture.xdotool(&["key", "ctrl+a", "key", "ctrl+c"]);
    assert_eq!(fixture.xclip("clipboard"), "é@äöß");
    assert_eq!(fixture.xclip("primary"), "é@äöß");
    fixture.xdotool(&["key", "ctrl+x"]);
    fixture.holds(0, "");
    // Our own text, by both keys.
    fixture.xdotool(&["key", "ctrl+v", "key", "shift+Insert"]);
    fixture.holds(0, "é@äößé@äöß");
    // Another program's, and its marked text where one clicks.
    let mut xclip = fixture.owned_by_xclip("clipboard", "12 €");
    fixture.xdotool(&["key", "ctrl+a", "key", "ctrl+v"]);
    fixture.holds(0, "12 €");
    xclip.kill().unwrap();
    xclip.wait().unwrap();
    let mut xclip = fixture.owned_by_xclip("primary", "marked");
    fixture.xdotool(&["mousemove", "100", "65", "click", "2"]);
    fixture.holds(1, "marked");
    assert_eq!(fixture.fields[0], "12 €");
    // Beside the fields the button pastes nothing, and asks for nothing.
    fixture.xdotool(&["mousemove", "100", "150", "click", "2"]);
    assert!(fixture.window.clipboard.deadline().is_none());
    assert_eq!(fixture.fields, ["12 €", "marked"]);
    xclip.kill().unwrap();
    xclip.wait().unwrap();
}

#[test]
fn one_deed_at_a_time_and_writing_at_once() {
    use egui::Event::{Copy, Key, PointerButton, PointerMoved, Text};
    let key = |key, pressed| Key {
        key,
        physical_key: None,
        pressed,
        repeat: false,
        modifiers: Modifiers::NONE,
    };
    let button = |pressed| PointerButton {
        pos: pos2(1.0, 2.0),
        button: PointerButtonKind::Primary,
        pressed,
        modifiers: Modifiers::NONE,
    };
    let (a, written) = (key(egui::Key::A, true), Text("a".to_owned()));
    let (f1, up) = (key(egui::Key::F1, true), key(egui::Key::F1, false));
    let (down, let_go) = (button(true), button(false));
    let moved = PointerMoved(pos2(3.0, 4.0));
    let parts = [
        vec![a.clone(), written.clone(), a.clone(), written.clone()],
        vec![f1.clone()],
        vec![up.clone(), f1],
        vec![up, moved.clone(), down.clone(), moved.clone()],
        vec![let_go.clone()],
        vec![down.clone(), let_go.clone()],
        vec![a.clone(), written.clone(), moved.clone()],
        vec![down, let_go],
        vec![a.clone(), written],
        vec![Copy],
        vec![moved],
    ];
    let mut events = parts.concat();
    for part in parts {
        assert_eq!(first_deed(&mut events), part);
    }
    assert_eq!(events, []);
    let mut many = vec![a; MOST_EVENTS + 1];
    assert_eq!(first_deed(&mut many).len(), MOST_EVENTS + 1);
}

#[test]
fn the_pointer_has_the_wanted_shape() {
    let server = Server::start();
    let mut fixture = Fixture::new(&server);
    fixture.xdotool(&["mousemove", "100", "150"]);
    let plain = fixture.shape();
    fixture.xdotool(&["mousemove", "100", "20"]);
    let text = fixture.shape();
    assert_ne!(plain, text);
    fixture.xdotool(&["mousemove", "100", "21"]);
    assert_eq!(fixture.shape(), text);
    fixture.xdotool(&["mousemove", "100", "150"]);
    assert_eq!(fixture.shape(), plain);
    // Every shape there is; the server would complain of one that is none.
    let window = fixture.window.frame.window;
    for icon in CursorIcon::ALL {
        let Window {
            connection,
            cursors,
            resources,
            ..
        } = &mut fixture.window;
        cursors.apply(connection, resources, window, icon).unwrap();
        let before = fixture.shape();
        if icon == CursorIcon::None {
            assert_eq!(before.width, 1);
        } else {
            // Of those that move the server tells no size.
            let moves = matches!(icon, CursorIcon::Progress | CursorIcon::Wait);
            assert!(before.width > 1 || moves, "{icon:?}");
        }
    }
    while let Some(event) = fixture.window.connection.poll_for_event().unwrap() {
        if let x11rb::protocol::Event::Error(error) = event {
            panic!("{error:?}");
        }
    }
}

/// A grab takes the keys, those too that are held, and leaves the focus.
#[test]
fn a_grab_leaves_the_focus_and_lets_the_keys_go() {
    let server = Server::start();
    let mut fixture = Fixture::new(&server);
    fixture.xdotool(&[
        "mousemove",
        "100",
        "20",
        "click",
        "1",
        "keydown",
        "ctrl",
        "keydown",
        "k",
    ]);
    let down = |fixture: &mut Fixture<'_>| fixture.egui.input(|input| input.keys_down.len());
    fixture.until("the keys", |fixture| down(fixture) == 2);
    let other = Connection::open(Some(server.display())).unwrap();
    let (root, mode) = (other.screen().root, GrabMode::ASYNC);
    let grab = other.grab_keyboard(false, root, CURRENT_TIME, mode, mode);
    grab.unwrap().reply().unwrap();
    fixture.until("the loss of the keys", |fixture| down(fixture) == 0);
    assert_eq!(fixture.window.keyboard.modifiers(), Modifiers::NONE);
    fixture.xdotool(&["keyup", "k", "keyup", "ctrl"]);
    other
        .ungrab_keyboard(CURRENT_TIME)
        .unwrap()
        .check()
        .unwrap();
    fixture.xdotool(&["key", "a"]);
    fixture.holds(0, "a");
    assert!(fixture.window.focus.told && down(&mut fixture) == 0);
}

#[test]
fn without_the_focus_no_shift_wakes_the_window() {
    let server = Server::start();
    let mut fixture = Fixture::new(&server);
    // The focus follows the pointer, into the window and out of it.
    let connection = &fixture.window.connection;
    let follow = connection.set_input_focus(InputFocus::NONE, InputFocus::POINTER_ROOT, 0_u32);
    follow.unwrap().check().unwrap();
    fixture.xdotool(&["mousemove", "100", "20", "click", "1", "key", "a"]);
    fixture.holds(0, "a");
    fixture.xdotool(&["mousemove", "900", "700"]);
    fixture.until("the loss", |fixture| !fixture.window.focus.told);
    server.run("xdotool", &["key", "shift"]);
    let connection = &fixture.window.connection;
    // After this reply every event is there.
    connection.get_input_focus().unwrap().reply().unwrap();
    while let Some(event) = connection.poll_for_event().unwrap() {
        assert!(
            !matches!(event, x11rb::protocol::Event::XkbStateNotify(_)),
            "{event:?}"
        );
    }
}
