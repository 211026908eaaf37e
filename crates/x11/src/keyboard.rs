//! Converts X key events to egui's: keys, text, modifiers, key repeat, dead keys, and the clipboard
//! shortcuts.
//!
//! The keymap is loaded at the first key press, so that windows open without it, and again after it
//! has changed. Each event has the modifiers. Between events XKB reports changes, but only while we
//! have the focus: otherwise each Shift pressed in another program would wake us.

use egui::{Event as Input, Key, Modifiers};
use kbvm::Keysym;
use x11rb::connection::RequestConnection as _;
use x11rb::protocol::Event;
use x11rb::protocol::xkb::{
    self, ConnectionExt as _, EventType, MapPart, NKNDetail, PerClientFlag, SelectEventsAux,
    SelectEventsAuxNewKeyboardNotify, SelectEventsAuxStateNotify, StatePart,
};
use x11rb::protocol::xproto::{KeyPressEvent, Mapping, ModMask, NotifyMode};

use super::compose::{Compose, Fed};
use super::connection::Connection;
use super::core_keymap::{CONTROL, MOD1, SHIFT};
use super::keymap::{KEYBOARD, Keymap, Meaning};
use crate::error::Result;

pub(super) struct Keyboard {
    extension: bool,
    keymap: Option<Keymap>,
    /// The keymap must be loaded again before use.
    stale: bool,
    /// XKB state events are selected.
    watching: bool,
    /// The server suppresses the releases between repeated presses.
    detectable: bool,
    /// Modifiers and group, in the layout of an event's state.
    state: u16,
    /// The modifiers last reported to egui.
    told: Modifiers,
    /// Held keys by keycode, with what was reported to egui.
    held: Vec<(u8, Told)>,
    /// A release that may turn out to be part of key repeat.
    waiting: Option<Release>,
    editing: bool,
    compose: Compose,
    paste: Option<u32>,
}

/// The logical and physical key reported to egui; `None` within a compose sequence or shortcut.
type Told = Option<(Key, Option<Key>)>;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Release {
    keycode: u8,
    time: u32,
}

impl Keyboard {
    pub(super) fn new(connection: &Connection) -> Result<Self> {
        let found = connection.sent(connection.extension_information(xkb::X11_EXTENSION_NAME))?;
        if found.is_some() {
            // Enables XKB, after which event states include the group. The reply is not needed.
            drop(connection.xkb_use_extension(1, 0));
        }
        Ok(Self::with(found.is_some()))
    }

    /// Uses the core protocol only.
    #[cfg(test)]
    pub(super) fn without_extension() -> Self {
        Self::with(false)
    }

    fn with(extension: bool) -> Self {
        Self {
            extension,
            keymap: None,
            stale: true,
            watching: false,
            detectable: false,
            state: 0,
            told: Modifiers::NONE,
            held: Vec::new(),
            waiting: None,
            editing: true,
            compose: Compose::default(),
            paste: None,
        }
    }

    pub(super) fn modifiers(&self) -> Modifiers {
        let alt = self.keymap.as_ref().map_or(MOD1, Keymap::alt);
        let held = |bits| self.state & bits != 0;
        Modifiers {
            alt: held(alt),
            ctrl: held(CONTROL),
            shift: held(SHIFT),
            mac_cmd: false,
            command: held(CONTROL),
        }
    }

    /// Dead keys compose only while text is being edited.
    pub(super) fn set_editing(&mut self, editing: bool) {
        if !editing {
            self.compose.reset();
        }
        self.editing = editing;
    }

    /// The time of a paste shortcut since the last call.
    pub(super) fn take_paste(&mut self) -> Option<u32> {
        self.paste.take()
    }

    /// Handles keyboard events, for which it returns true. Also follows the focus and the modifiers
    /// in pointer events, but leaves those events to others.
    pub(super) fn handle(
        &mut self,
        connection: &Connection,
        event: &Event,
        out: &mut Vec<Input>,
    ) -> Result<bool> {
        match event {
            Event::KeyPress(event) => self.press(connection, event, out)?,
            Event::KeyRelease(event) => self.release(event, out),
            Event::XkbStateNotify(event) => {
                if self.watching {
                    self.state = event_state(event.mods, event.group);
                    self.tell_modifiers(out);
                }
            }
            Event::XkbNewKeyboardNotify(_) | Event::XkbMapNotify(_) => self.stale = true,
            Event::MappingNotify(event) => self.stale |= event.request != Mapping::POINTER,
            // A grab takes the keys, including the releases of held ones, whichever window has the
            // focus.
            Event::FocusIn(event) => {
                if event.mode != NotifyMode::GRAB {
                    self.watch(connection, true)?;
                    self.tell_modifiers(out);
                }
                return Ok(false);
            }
            Event::FocusOut(_) => {
                self.leave(connection, out)?;
                return Ok(false);
            }
            Event::ButtonPress(event) | Event::ButtonRelease(event) => {
                return Ok(self.pointer(event.state.into(), out));
            }
            Event::MotionNotify(event) => return Ok(self.pointer(event.state.into(), out)),
            Event::EnterNotify(event) | Event::LeaveNotify(event) => {
                return Ok(self.pointer(event.state.into(), out));
            }
            _ => return Ok(false),
        }
        Ok(true)
    }

    /// To be called when no more events are queued.
    pub(super) fn settle(&mut self, connection: &Connection, out: &mut Vec<Input>) -> Result<()> {
        self.release_waiting(out);
        // Programs that remap keys to type missing characters soon restore them: load only once.
        if self.stale && self.keymap.is_some() {
            self.load(connection)?;
        }
        Ok(())
    }

    /// The keys go elsewhere: releases all, because no event will, and stops following modifiers.
    pub(super) fn leave(&mut self, connection: &Connection, out: &mut Vec<Input>) -> Result<()> {
        self.watch(connection, false)?;
        self.waiting = None;
        self.compose.reset();
        let modifiers = self.modifiers();
        for (_, key) in std::mem::take(&mut self.held) {
            up(key, modifiers, out);
        }
        self.state &= !0xFF;
        self.tell_modifiers(out);
        Ok(())
    }

    fn press(
        &mut self,
        connection: &Connection,
        event: &KeyPressEvent,
        out: &mut Vec<Input>,
    ) -> Result<()> {
        if self.stale {
            self.load(connection)?;
        }
        self.watch(connection, true)?;
        self.key(event.detail, event.state.into(), event.time, out);
        Ok(())
    }

    fn key(&mut self, keycode: u8, state: u16, time: u32, out: &mut Vec<Input>) {
        let half = Release { keycode, time };
        if self.waiting == Some(half) {
            self.waiting = None;
        } else {
            self.release_waiting(out);
        }
        self.state = state;
        self.tell_modifiers(out);
        let meaning = self.keymap.as_ref().map(|map| map.meaning(keycode, state));
        let at = self.held.iter().position(|(held, _)| *held == keycode);
        let before = at.map(|at| self.held.swap_remove(at).1);
        if let Some(meaning) = meaning
            && self.held.len() < MOST_HELD
        {
            let told = self.tell(meaning, before, time, out);
            self.held.push((keycode, told));
        }
        self.hold(keycode, true, out);
    }

    /// Reports a press to egui, and returns the key that it reported. `before` is the report for an
    /// earlier press that is not yet released.
    fn tell(
        &mut self,
        meaning: Meaning,
        before: Option<Told>,
        time: u32,
        out: &mut Vec<Input>,
    ) -> Told {
        let known = before.flatten();
        let modifiers = self.modifiers();
        if let Some(shortcut) = meaning.key.and_then(|key| shortcut(key, modifiers)) {
            match shortcut {
                Shortcut::Copy => out.push(Input::Copy),
                Shortcut::Cut => out.push(Input::Cut),
                Shortcut::Paste => self.paste = Some(time),
            }
            return known;
        }
        let text = match meaning.command {
            true => None,
            false => match self.feed(meaning.keysym) {
                Fed::Plain => meaning.keysym.char().map(String::from),
                Fed::Text(text) => {
                    tell_text(Some(text), out);
                    return known;
                }
                Fed::Taken => return known,
            },
        };
        // Keep the key that was reported first: the same key must be released.
        let told = known.or(meaning.key.map(|key| (key, meaning.physical)));
        if let Some((key, physical_key)) = told {
            out.push(Input::Key {
                key,
                physical_key,
                pressed: true,
                repeat: before.is_some(),
                modifiers,
            });
        }
        tell_text(text, out);
        told
    }

    fn feed(&mut self, keysym: Keysym) -> Fed {
        match self.editing {
            true => self.compose.feed(keysym),
            false => Fed::Plain,
        }
    }

    fn release(&mut self, event: &KeyPressEvent, out: &mut Vec<Input>) {
        self.release_waiting(out);
        self.state = event.state.into();
        self.tell_modifiers(out);
        let keycode = event.detail;
        if self.detectable {
            self.let_go(keycode, out);
        } else {
            let time = event.time;
            self.waiting = Some(Release { keycode, time });
        }
    }

    fn release_waiting(&mut self, out: &mut Vec<Input>) {
        if let Some(release) = self.waiting.take() {
            self.let_go(release.keycode, out);
        }
    }

    fn let_go(&mut self, keycode: u8, out: &mut Vec<Input>) {
        if let Some(at) = self.held.iter().position(|(held, _)| *held == keycode) {
            let (_, key) = self.held.swap_remove(at);
            up(key, self.modifiers(), out);
        }
        self.hold(keycode, false, out);
    }

    /// Updates the modifiers for a modifier key itself, whose event carries the state before it.
    /// Only without XKB, which reports them.
    fn hold(&mut self, keycode: u8, down: bool, out: &mut Vec<Input>) {
        let Some(map) = self.keymap.as_ref().filter(|_| !self.extension) else {
            return;
        };
        let sets = map.sets(keycode) & (SHIFT | CONTROL | map.alt());
        if sets == 0 {
            return;
        }
        let others = self.held.iter().filter(|(held, _)| *held != keycode);
        let still = others.fold(0, |bits, (held, _)| bits | map.sets(*held));
        match down {
            true => self.state |= sets,
            false => self.state &= !sets | still,
        }
        self.tell_modifiers(out);
    }

    /// Takes the modifiers from a pointer event: they are current even without the focus.
    fn pointer(&mut self, state: u16, out: &mut Vec<Input>) -> bool {
        self.state = state;
        self.tell_modifiers(out);
        false
    }

    fn tell_modifiers(&mut self, out: &mut Vec<Input>) {
        let modifiers = self.modifiers();
        if modifiers != self.told {
            self.told = modifiers;
            out.push(Input::ModifiersChanged(modifiers));
        }
    }

    fn load(&mut self, connection: &Connection) -> Result<()> {
        self.stale = false;
        if self.extension && self.keymap.is_none() {
            let map = MapPart::KEY_TYPES
                | MapPart::KEY_SYMS
                | MapPart::MODIFIER_MAP
                | MapPart::VIRTUAL_MODS
                | MapPart::VIRTUAL_MOD_MAP;
            let keyboard = SelectEventsAuxNewKeyboardNotify {
                affect_new_keyboard: NKNDetail::KEYCODES | NKNDetail::DEVICE_ID,
                new_keyboard_details: NKNDetail::KEYCODES | NKNDetail::DEVICE_ID,
            };
            let details = SelectEventsAux::new().new_keyboard_notify(keyboard);
            let none = EventType::default();
            // Without this flag in "all", the server ignores `map`.
            let all = EventType::MAP_NOTIFY;
            let asked = connection.xkb_select_events(KEYBOARD, none, all, map, map, &details);
            if let Ok(asked) = asked {
                asked.ignore_error();
            }
            let repeat = PerClientFlag::DETECTABLE_AUTO_REPEAT;
            let none = xkb::BoolCtrl::default();
            let asked = connection.xkb_per_client_flags(KEYBOARD, repeat, repeat, none, none, none);
            let flags = connection.answer(asked)?;
            self.detectable = flags.is_some_and(|flags| flags.value.contains(repeat));
        }
        if let Some(keymap) = Keymap::load(connection, self.extension)? {
            self.keymap = Some(keymap);
        }
        Ok(())
    }

    fn watch(&mut self, connection: &Connection, watch: bool) -> Result<()> {
        if !self.extension || self.watching == watch {
            return Ok(());
        }
        self.watching = watch;
        let parts = StatePart::MODIFIER_STATE | StatePart::GROUP_STATE;
        let state = SelectEventsAuxStateNotify {
            affect_state: parts,
            state_details: if watch { parts } else { StatePart::default() },
        };
        let nothing = EventType::default();
        let unchanged = MapPart::default();
        let details = SelectEventsAux::new().state_notify(state);
        if let Ok(asked) =
            connection.xkb_select_events(KEYBOARD, nothing, nothing, unchanged, unchanged, &details)
        {
            asked.ignore_error();
        }
        if watch && let Some(now) = connection.answer(connection.xkb_get_state(KEYBOARD))? {
            self.state = event_state(now.mods, now.group);
        }
        Ok(())
    }
}

/// XKB's modifiers and group in the layout of an event's state.
fn event_state(modifiers: ModMask, group: xkb::Group) -> u16 {
    u16::from(modifiers) & 0xFF | (u16::from(u8::from(group)) & 3) << 13
}

/// The most keys tracked as held, more than a keyboard sends.
const MOST_HELD: usize = 256;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Shortcut {
    Copy,
    Cut,
    Paste,
}

/// The clipboard shortcuts: Ctrl-C, Ctrl-X, Ctrl-V, the older Ctrl-Insert, Shift-Delete,
/// Shift-Insert, and dedicated keys.
fn shortcut(key: Key, held: Modifiers) -> Option<Shortcut> {
    let ctrl = held.ctrl && !held.alt;
    let shift = held.shift && !held.ctrl && !held.alt;
    match key {
        Key::Copy => Some(Shortcut::Copy),
        Key::Cut => Some(Shortcut::Cut),
        Key::Paste => Some(Shortcut::Paste),
        Key::C | Key::Insert if ctrl => Some(Shortcut::Copy),
        Key::X if ctrl => Some(Shortcut::Cut),
        Key::V if ctrl => Some(Shortcut::Paste),
        Key::Delete if shift => Some(Shortcut::Cut),
        Key::Insert if shift => Some(Shortcut::Paste),
        _ => None,
    }
}

fn up(key: Told, modifiers: Modifiers, out: &mut Vec<Input>) {
    if let Some((key, physical_key)) = key {
        out.push(Input::Key {
            key,
            physical_key,
            pressed: false,
            repeat: false,
            modifiers,
        });
    }
}

/// Reports text, except control characters, which are keys.
fn tell_text(text: Option<String>, out: &mut Vec<Input>) {
    if let Some(text) = text.filter(|text| !text.is_empty() && !text.chars().any(char::is_control))
    {
        out.push(Input::Text(text));
    }
}
