//! The keyboard against a real server, typed on by another program.

use egui::{Event as Input, Key, Modifiers};
use x11rb::connection::Connection as _;
use x11rb::protocol::xproto::{
    ConnectionExt as _, CreateWindowAux, EventMask, InputFocus, WindowClass,
};
use x11rb::{COPY_DEPTH_FROM_PARENT, COPY_FROM_PARENT, CURRENT_TIME};

use super::connection::Connection;
use super::keyboard::Keyboard;
use super::testing::{Server, until};

/// A window with the keyboard, and what egui would hear of it.
struct Desk {
    server: Server,
    connection: Connection,
    keyboard: Keyboard,
    window: u32,
    heard: Vec<Input>,
}

impl Desk {
    fn new(layout: &str, extension: bool) -> Self {
        let server = Server::start();
        server.run("setxkbmap", &["-layout", layout]);
        let connection = Connection::open(Some(server.display())).unwrap();
        let keyboard = match extension {
            true => Keyboard::new(&connection).unwrap(),
            false => Keyboard::without_extension(),
        };
        let window = connection.generate_id().unwrap();
        let events = EventMask::KEY_PRESS
            | EventMask::KEY_RELEASE
            | EventMask::FOCUS_CHANGE
            | EventMask::STRUCTURE_NOTIFY;
        let root = connection.screen().root;
        let aux = CreateWindowAux::new().event_mask(events);
        connection
            .create_window(
                COPY_DEPTH_FROM_PARENT,
                window,
                root,
                0,
                0,
                50,
                50,
                0,
                WindowClass::INPUT_OUTPUT,
                COPY_FROM_PARENT,
                &aux,
            )
            .unwrap();
        connection.map_window(window).unwrap();
        let focus = InputFocus::PARENT;
        connection
            .set_input_focus(focus, window, CURRENT_TIME)
            .unwrap()
            .check()
            .unwrap();
        Self {
            server,
            connection,
            keyboard,
            window,
            heard: Vec::new(),
        }
    }

    /// Takes what has arrived.
    fn poll(&mut self) {
        while let Some(event) = self.connection.poll_for_event().unwrap() {
            let (keyboard, connection) = (&mut self.keyboard, &self.connection);
            keyboard
                .handle(connection, &event, &mut self.heard)
                .unwrap();
        }
        let (keyboard, connection) = (&mut self.keyboard, &self.connection);
        keyboard.settle(connection, &mut self.heard).unwrap();
        connection.flush().unwrap();
    }

    /// Runs xdotool while listening; what was heard until the key named last,
    /// which must be Escape, went up again.
    fn type_with(&mut self, arguments: &[&str]) -> Vec<Input> {
        let mut xdotool = self.server.command("xdotool");
        let mut xdotool = xdotool
            .args(arguments)
            .args(["key", "Escape"])
            .spawn()
            .unwrap();
        until("Escape", || {
            self.poll();
            let escape = |event: &Input| {
                matches!(
                    event,
                    Input::Key {
                        key: Key::Escape,
                        pressed: false,
                        ..
                    }
                )
            };
            self.heard.iter().any(escape).then_some(())
        });
        assert!(xdotool.wait().unwrap().success());
        std::mem::take(&mut self.heard)
    }

    /// Presses and releases these keycodes one after the other.
    fn keys(&mut self, keycodes: &[u8]) -> Vec<Input> {
        let mut arguments = vec!["key".to_owned()];
        arguments.extend(keycodes.iter().map(u8::to_string));
        let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
        self.type_with(&arguments)
    }
}

/// All text of these events.
fn text(events: &[Input]) -> String {
    events
        .iter()
        .filter_map(|event| match event {
            Input::Text(text) => Some(text.as_str()),
            _ => None,
        })
        .collect()
}

/// The keys that went down, without modifiers' own.
fn pressed(events: &[Input]) -> Vec<(Key, Modifiers)> {
    let own = |key: &Key| Key::ShiftLeft <= *key && *key <= Key::SuperRight;
    events
        .iter()
        .filter_map(|event| match event {
            Input::Key {
                key,
                pressed: true,
                modifiers,
                ..
            } if !own(key) && *key != Key::Escape => Some((*key, *modifiers)),
            _ => None,
        })
        .collect()
}

const SENTENCE: &str = "The quick (brown) fox: 3.14 & {x}_[y] ~ \\/|<>!?";

#[test]
fn text_is_heard_as_it_was_typed() {
    for extension in [true, false] {
        let mut desk = Desk::new("us", extension);
        let heard = desk.type_with(&["type", "--args", "1", "--delay", "5", SENTENCE]);
        assert_eq!(text(&heard), SENTENCE, "extension {extension}");
        assert_eq!(desk.keyboard.modifiers(), Modifiers::NONE);
        // Each key that went down went up again, and none twice.
        let mut down = Vec::new();
        for event in &heard {
            match event {
                Input::Key {
                    key,
                    pressed: true,
                    repeat,
                    ..
                } => {
                    assert!(!repeat && !down.contains(key), "{event:?}");
                    down.push(*key);
                }
                Input::Key { key, .. } => down.retain(|held| held != key),
                _ => {}
            }
        }
        assert_eq!(down, []);
    }
}

/// Typed by place on a German keyboard: keycodes are those of the key caps.
#[test]
fn layouts_levels_dead_keys_and_sequences() {
    const ALT_GR: &str = "108";
    const SHIFT: &str = "50";
    for extension in [true, false] {
        let mut desk = Desk::new("de", extension);
        // z where others have y, and the umlauts.
        let heard = desk.keys(&[29, 52, 47, 48, 34, 20]);
        assert_eq!(text(&heard), "zyöäüß", "extension {extension}");
        let keys: Vec<Key> = pressed(&heard).iter().map(|(key, _)| *key).collect();
        assert_eq!(keys[..2], [Key::Z, Key::Y]);
        let heard = desk.type_with(&["keydown", SHIFT, "key", "47", "key", "16", "keyup", SHIFT]);
        assert_eq!(text(&heard), "Ö/");
        let heard = desk.type_with(&[
            "keydown", ALT_GR, "key", "24", "key", "26", "key", "16", "keyup", ALT_GR,
        ]);
        assert_eq!(text(&heard), "@€{");
        assert!(pressed(&heard).iter().all(|(_, held)| held.is_none()));
        // ´ e, ` a, ^ and space, ´ and backspace.
        let heard = desk.keys(&[21, 26, 49, 32, 49, 65, 21, 22, 26]);
        assert_eq!(text(&heard), "éô^e", "extension {extension}");
        assert_eq!(pressed(&heard), [(Key::E, Modifiers::NONE)]);
        // With a text being edited no more, a dead key is nothing.
        desk.keyboard.set_editing(false);
        assert_eq!(text(&desk.keys(&[21, 26])), "e");
        desk.keyboard.set_editing(true);
        desk.server
            .run("setxkbmap", &["-layout", "de", "-option", "compose:rctrl"]);
        let heard = desk.keys(&[105, 26, 53]);
        assert_eq!(text(&heard), "x", "extension {extension}");
        let heard = desk.type_with(&[
            "key", "105", "key", "94", "keydown", SHIFT, "key", "19", "keyup", SHIFT,
        ]);
        assert_eq!(text(&heard), "≤", "extension {extension}");
    }
}
