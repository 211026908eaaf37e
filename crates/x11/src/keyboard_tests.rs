//! The keyboard against a real server, typed on by another program.

use egui::{Event as Input, Key, Modifiers};
use x11rb::connection::Connection as _;
use x11rb::protocol::Event;
use x11rb::protocol::xproto::{
    ConnectionExt as _, CreateWindowAux, EventMask, InputFocus, KeyPressEvent, WindowClass,
};
use x11rb::{COPY_DEPTH_FROM_PARENT, COPY_FROM_PARENT, CURRENT_TIME};

use super::connection::Connection;
use super::keyboard::Keyboard;
use super::testing::{Server, until};

/// A window with the keyboard, and what egui would hear of it.
struct Fixture {
    server: Server,
    connection: Connection,
    keyboard: Keyboard,
    window: u32,
    heard: Vec<Input>,
}

impl Fixture {
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
        let mut fixture = Fixture::new("us", extension);
        let heard = fixture.type_with(&["type", "--args", "1", "--delay", "5", SENTENCE]);
        assert_eq!(text(&heard), SENTENCE, "extension {extension}");
        assert_eq!(fixture.keyboard.modifiers(), Modifiers::NONE);
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
        let mut fixture = Fixture::new("de", extension);
        // z where others have y, and the umlauts.
        let heard = fixture.keys(&[29, 52, 47, 48, 34, 20]);
        assert_eq!(text(&heard), "zyöäüß", "extension {extension}");
        let keys: Vec<Key> = pressed(&heard).iter().map(|(key, _)| *key).collect();
        assert_eq!(keys[..2], [Key::Z, Key::Y]);
        let heard =
            fixture.type_with(&["keydown", SHIFT, "key", "47", "key", "16", "keyup", SHIFT]);
        assert_eq!(text(&heard), "Ö/");
        let heard = fixture.type_with(&[
            "keydown", ALT_GR, "key", "24", "key", "26", "key", "16", "keyup", ALT_GR,
        ]);
        assert_eq!(text(&heard), "@€{");
        assert!(pressed(&heard).iter().all(|(_, held)| held.is_none()));
        // ´ e, ` a, ^ and space, ´ and backspace.
        let heard = fixture.keys(&[21, 26, 49, 32, 49, 65, 21, 22, 26]);
        assert_eq!(text(&heard), "éô^e", "extension {extension}");
        assert_eq!(pressed(&heard), [(Key::E, Modifiers::NONE)]);
        // With a text being edited no more, a dead key is nothing.
        fixture.keyboard.set_editing(false);
        assert_eq!(text(&fixture.keys(&[21, 26])), "e");
        fixture.keyboard.set_editing(true);
        fixture
            .server
            .run("setxkbmap", &["-layout", "de", "-option", "compose:rctrl"]);
        let heard = fixture.keys(&[105, 26, 53]);
        assert_eq!(text(&heard), "x", "extension {extension}");
        let heard = fixture.type_with(&[
            "key", "105", "key", "94", "keydown", SHIFT, "key", "19", "keyup", SHIFT,
        ]);
        assert_eq!(text(&heard), "≤", "extension {extension}");
    }
}

fn held(names: &str) -> Modifiers {
    Modifiers {
        alt: names.contains("alt"),
        ctrl: names.contains("ctrl"),
        shift: names.contains("shift"),
        mac_cmd: false,
        command: names.contains("ctrl"),
    }
}

#[test]
fn commands_are_no_text() {
    for extension in [true, false] {
        let mut fixture = Fixture::new("us", extension);
        for (keys, key, with) in [
            ("alt+d", Key::D, "alt"),
            ("ctrl+z", Key::Z, "ctrl"),
            ("ctrl+shift+z", Key::Z, "ctrl shift"),
            ("alt+F4", Key::F4, "alt"),
            ("ctrl+alt+v", Key::V, "ctrl alt"),
            ("shift+Tab", Key::Tab, "shift"),
        ] {
            let events = fixture.type_with(&["key", keys]);
            assert_eq!(pressed(&events), [(key, held(with))], "{keys} {extension}");
            assert_eq!(text(&events), "", "{keys} {extension}");
        }
        assert_eq!(pressed(&fixture.type_with(&["key", "super+a"])).len(), 1);
        assert_eq!(fixture.keyboard.modifiers(), Modifiers::NONE);
        for (keys, event) in [
            ("ctrl+c", Some(Input::Copy)),
            ("ctrl+Insert", Some(Input::Copy)),
            ("ctrl+x", Some(Input::Cut)),
            ("shift+Delete", Some(Input::Cut)),
            ("XF86Copy", Some(Input::Copy)),
            ("ctrl+v", None),
            ("shift+Insert", None),
        ] {
            let events = fixture.type_with(&["key", keys]);
            assert_eq!(pressed(&events), [], "{keys} {extension}");
            assert_eq!(text(&events), "", "{keys} {extension}");
            let paste = fixture.keyboard.take_paste();
            assert_eq!(paste.is_some(), event.is_none(), "{keys} {extension}");
            if let Some(event) = event {
                let times = events.iter().filter(|heard| **heard == event).count();
                assert_eq!(times, 1, "{keys} {extension}");
            }
        }
    }
}

#[test]
fn the_keypad_follows_num_lock() {
    for extension in [true, false] {
        let mut fixture = Fixture::new("us", extension);
        let events = fixture.keys(&[79, 91, 86, 104]);
        let keys = [Key::Home, Key::Delete, Key::Plus, Key::Enter];
        assert_eq!(pressed(&events), keys.map(|key| (key, Modifiers::NONE)));
        assert_eq!(text(&events), "+", "extension {extension}");
        fixture.type_with(&["key", "Num_Lock"]);
        let events = fixture.keys(&[79, 91, 86, 104]);
        let keys = [Key::Num7, Key::Period, Key::Plus, Key::Enter];
        assert_eq!(pressed(&events), keys.map(|key| (key, Modifiers::NONE)));
        assert_eq!(text(&events), "7.+", "extension {extension}");
    }
}

#[test]
fn other_alphabets_keep_their_shortcuts() {
    for layout in ["ru", "gr", "de,ru"] {
        let mut fixture = Fixture::new(layout, true);
        if layout == "de,ru" {
            fixture.server.run("setxkbmap", &["-layout", "ru,de"]);
        }
        let events = fixture.keys(&[54]);
        let sign = if layout == "gr" { "ψ" } else { "с" };
        assert_eq!(text(&events), sign);
        assert_eq!(pressed(&events), [(Key::C, Modifiers::NONE)]);
        let events = fixture.type_with(&["keydown", "37", "key", "54", "keyup", "37"]);
        assert!(events.contains(&Input::Copy), "{layout}");
        // By place where nothing else is known, by letter where it is.
        let key = if layout == "de,ru" { Key::Z } else { Key::Y };
        assert_eq!(pressed(&fixture.keys(&[29])), [(key, Modifiers::NONE)]);
    }
}

#[test]
fn another_keymap_is_taken_over_at_once() {
    for extension in [true, false] {
        let mut fixture = Fixture::new("us", extension);
        assert_eq!(text(&fixture.keys(&[29, 47])), "y;");
        fixture.server.run("setxkbmap", &["-layout", "de"]);
        assert_eq!(
            text(&fixture.keys(&[29, 47])),
            "zö",
            "extension {extension}"
        );
        fixture.server.run("setxkbmap", &["-layout", "fr"]);
        assert_eq!(
            text(&fixture.keys(&[24, 11])),
            "aé",
            "extension {extension}"
        );
    }
    // The second group, as an event's state has it (xdotool knows the first
    // only).
    let mut fixture = Fixture::new("us,de", true);
    assert_eq!(text(&fixture.keys(&[29])), "y");
    for (group, sign) in [(0, "y"), (1, "z"), (2, "y"), (3, "z"), (0, "y")] {
        let down = Event::KeyPress(event(29, 1, group << 13));
        let up = Event::KeyRelease(event(29, 2, group << 13));
        let mut heard = Vec::new();
        for event in [down, up] {
            let (keyboard, connection) = (&mut fixture.keyboard, &fixture.connection);
            keyboard.handle(connection, &event, &mut heard).unwrap();
        }
        assert_eq!(text(&heard), sign, "group {group}");
    }
    // Signs that no key has, put onto a spare key for the moment.
    let events = fixture.type_with(&["type", "--args", "1", "--delay", "400", "жλ😀"]);
    assert_eq!(text(&events), "жλ😀");
}

/// An event as the server makes it.
fn event(keycode: u8, time: u32, state: u16) -> KeyPressEvent {
    KeyPressEvent {
        response_type: 2,
        detail: keycode,
        sequence: 0,
        time,
        root: 0,
        event: 0,
        child: 0,
        root_x: 0,
        root_y: 0,
        event_x: 0,
        event_y: 0,
        state: state.into(),
        same_screen: true,
    }
}

#[test]
fn a_held_key_repeats_and_goes_up_once() {
    for extension in [true, false] {
        let mut fixture = Fixture::new("us", extension);
        let mut heard = Vec::new();
        let mut hear = |events: &[Event]| {
            let (keyboard, connection) = (&mut fixture.keyboard, &fixture.connection);
            for event in events {
                keyboard.handle(connection, event, &mut heard).unwrap();
            }
            keyboard.settle(connection, &mut heard).unwrap();
            let keys = heard.iter().filter_map(|event| match event {
                Input::Key {
                    pressed, repeat, ..
                } => Some((*pressed, *repeat)),
                _ => None,
            });
            let keys: Vec<_> = keys.collect();
            (std::mem::take(&mut heard), keys)
        };
        let down = |time| Event::KeyPress(event(38, time, 0));
        let up = |time| Event::KeyRelease(event(38, time, 0));
        // Without the extension a repetition is a release and a press at once.
        let repetitions = match extension {
            true => vec![down(1), down(500), down(540)],
            false => vec![down(1), up(500), down(500), up(540), down(540)],
        };
        let (events, keys) = hear(&repetitions);
        assert_eq!(keys, [(true, false), (true, true), (true, true)]);
        assert_eq!(text(&events), "aaa");
        assert_eq!(hear(&[up(560)]).1, [(false, false)]);
        assert_eq!(hear(&[up(570)]).1, []);
        // Pressed twice is no repetition.
        let twice = [down(600), up(620), down(640), up(660)];
        let expected = [(true, false), (false, false), (true, false), (false, false)];
        assert_eq!(hear(&twice).1, expected);
        // What was shift-1 goes up as that, though shift went up before.
        let keys = [
            Event::KeyPress(event(10, 700, 1)),
            Event::KeyRelease(event(10, 720, 0)),
        ];
        for heard in hear(&keys).0 {
            if let Input::Key { key, .. } = heard {
                assert_eq!(key, Key::Exclamationmark);
            }
        }
    }
}

#[test]
fn without_the_keyboard_no_key_is_held() {
    for extension in [true, false] {
        let mut fixture = Fixture::new("us", extension);
        let events = fixture.type_with(&["keydown", "ctrl", "keydown", "k"]);
        assert_eq!(pressed(&events), [(Key::K, held("ctrl"))]);
        assert_eq!(fixture.keyboard.modifiers(), held("ctrl"));
        let focus = InputFocus::NONE;
        let asked = fixture
            .connection
            .set_input_focus(focus, 0u32, CURRENT_TIME);
        asked.unwrap();
        until("the loss", || {
            fixture.poll();
            (fixture.keyboard.modifiers() == Modifiers::NONE).then_some(())
        });
        let up = |event: &&Input| {
            matches!(
                event,
                Input::Key {
                    key: Key::K,
                    pressed: false,
                    ..
                }
            )
        };
        assert_eq!(fixture.heard.iter().filter(up).count(), 1);
        // Whatever happens meanwhile is none of ours.
        let before = fixture.heard.len();
        fixture.server.run("xdotool", &["keyup", "k", "key", "x"]);
        fixture.poll();
        assert_eq!(fixture.heard.len(), before);
        // Back again, control is held still.
        let focus = InputFocus::PARENT;
        let asked = fixture
            .connection
            .set_input_focus(focus, fixture.window, CURRENT_TIME);
        // Before the keys of another program come in.
        asked.unwrap().check().unwrap();
        fixture.heard.clear();
        let events = fixture.type_with(&["key", "j", "keyup", "ctrl"]);
        assert_eq!(pressed(&events), [(Key::J, held("ctrl"))]);
        assert_eq!(fixture.keyboard.modifiers(), Modifiers::NONE);
    }
}

#[test]
fn a_child_with_the_focus_has_the_keys() {
    let mut fixture = Fixture::new("us", true);
    let connection = &fixture.connection;
    let child = connection.generate_id().unwrap();
    let (depth, class) = (COPY_DEPTH_FROM_PARENT, WindowClass::INPUT_ONLY);
    let none = CreateWindowAux::new();
    let parent = fixture.window;
    connection
        .create_window(
            depth,
            child,
            parent,
            0,
            0,
            9,
            9,
            0,
            class,
            COPY_FROM_PARENT,
            &none,
        )
        .unwrap();
    connection.map_window(child).unwrap();
    fixture.type_with(&["keydown", "ctrl", "keydown", "k"]);
    let asked = (fixture.connection).set_input_focus(InputFocus::PARENT, child, CURRENT_TIME);
    asked.unwrap().check().unwrap();
    until("the loss", || {
        fixture.poll();
        (fixture.keyboard.modifiers() == Modifiers::NONE).then_some(())
    });
    // What is done with them there wakes nobody here.
    let before = fixture.heard.len();
    let keys = ["keyup", "k", "keyup", "ctrl", "key", "shift"];
    fixture.server.run("xdotool", &keys);
    fixture.poll();
    assert_eq!(fixture.heard.len(), before);
}
