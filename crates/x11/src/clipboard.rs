//! Text to and from other programs: the clipboard, and the primary selection (selected text, pasted
//! with the middle button).
//!
//! Transfers are driven by events; [`Clipboard::deadline`] returns when one times out. Other
//! programs are not trusted: their requests and data are bounded in size, number and time.

use rustix::event::PollFlags;
use std::cell::OnceCell;
use std::os::fd::AsFd as _;
use std::rc::Rc;
use std::time::{Duration, Instant};

use egui::{Event as Input, Pos2};
use x11rb::connection::Connection as _;
use x11rb::errors::ConnectionError;
use x11rb::protocol::Event;
use x11rb::protocol::xproto::{
    Atom, AtomEnum, ConnectionExt as _, EventMask, PropMode, Property, SELECTION_NOTIFY_EVENT,
    SelectionNotifyEvent, SelectionRequestEvent, Window,
};
use x11rb::wrapper::ConnectionExt as _;
use x11rb::{CURRENT_TIME, NONE};

use super::connection::Connection;
use super::incoming::{self, Incoming, Step, Wanted};
use super::outgoing::{self, Outgoing};
use super::stream::wait;
use crate::error::Result;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Selection {
    Clipboard,
    Primary,
}

/// Concurrent transfers to us.
const MOST_INCOMING: usize = 8;

/// Concurrent transfers in pieces to others.
const MOST_OUTGOING: usize = 16;

/// Requests are refused while more unsent bytes wait, so that no client can fill the memory.
const MOST_WAITING: usize = 4 << 20;

/// Pairs read from a MULTIPLE request.
const MOST_PAIRS: u32 = 64;

#[derive(Default)]
pub(super) struct Clipboard {
    /// The window that owns our selections, created on first use.
    owner: Option<Window>,
    clipboard: Option<Owned>,
    primary: Option<Owned>,
    incoming: Vec<Incoming>,
    outgoing: Vec<Outgoing>,
}

/// Text that others may request.
struct Owned {
    text: Rc<[u8]>,
    /// The text in Latin-1, once requested.
    latin: OnceCell<Rc<[u8]>>,
    /// The server time since which it is owned.
    time: u32,
}

enum Value {
    Atoms(Vec<Atom>),
    Time(u32),
    Text(Atom, Rc<[u8]>),
    Nothing,
}

impl Clipboard {
    pub(super) fn new() -> Self {
        Self::default()
    }

    /// Offers text to other programs. `time` is the server time of the user's action; a program
    /// that took the selection later keeps it.
    pub(super) fn own(
        &mut self,
        connection: &Connection,
        which: Selection,
        text: &str,
        time: u32,
    ) -> Result<()> {
        if text.is_empty() {
            return Ok(());
        }
        let Some(owner) = self.owner(connection)? else {
            return Ok(());
        };
        let selection = atom(connection, which);
        connection.sent_quietly(connection.set_selection_owner(owner, selection, time))?;
        let now = connection.answer(connection.get_selection_owner(selection))?;
        let ours = now.is_some_and(|now| now.owner == owner);
        *self.owned(which) = ours.then(|| Owned {
            text: text.as_bytes().into(),
            latin: OnceCell::new(),
            time,
        });
        Ok(())
    }

    /// Requests the text of a selection. It arrives as an [`Input::Paste`] or, with a place, as an
    /// [`Input::MiddleClickPaste`]: at once if the selection is ours, otherwise later or never. If
    /// no program offers text, `Paste` arrives empty, because the key may paste something other
    /// than text.
    pub(super) fn request(
        &mut self,
        connection: &Connection,
        which: Selection,
        time: u32,
        place: Option<Pos2>,
        out: &mut Vec<Input>,
    ) -> Result<()> {
        if let Some(owned) = self.owned(which) {
            let text = String::from_utf8_lossy(&owned.text).into_owned();
            out.push(pasted(text, place));
            return Ok(());
        }
        if self.incoming.len() >= MOST_INCOMING {
            return Ok(());
        }
        let selection = atom(connection, which);
        let now = Instant::now();
        let started = Incoming::start(connection, selection, time, place, Wanted::Text, now)?;
        self.incoming.extend(started);
        Ok(())
    }

    pub(super) fn deadline(&self) -> Option<Instant> {
        let incoming = self.incoming.iter().map(Incoming::deadline);
        let outgoing = self.outgoing.iter().map(Outgoing::deadline);
        incoming.chain(outgoing).min()
    }

    pub(super) fn tick(&mut self, connection: &Connection, now: Instant) -> Result<()> {
        while let Some(late) = self.incoming.iter().position(|one| one.deadline() <= now) {
            self.incoming.remove(late).finish(connection)?;
        }
        while let Some(late) = self.outgoing.iter().position(|one| one.deadline() <= now) {
            self.stop_sending(connection, late)?;
        }
        Ok(())
    }

    /// Handles an event about selections; false if it is about something else.
    pub(super) fn handle(
        &mut self,
        connection: &Connection,
        event: &Event,
        out: &mut Vec<Input>,
    ) -> Result<bool> {
        let now = Instant::now();
        match event {
            Event::SelectionNotify(event) => {
                return self.receive(connection, event.requestor, out, |incoming| {
                    incoming.answered(connection, event, now)
                });
            }
            Event::PropertyNotify(event) if event.state == Property::NEW_VALUE => {
                return self.receive(connection, event.window, out, |incoming| {
                    incoming.written(connection, event.atom, now)
                });
            }
            Event::PropertyNotify(event) => {
                let Some(at) = self.sending(event.window, event.atom) else {
                    return Ok(self.receiving(event.window).is_some());
                };
                if self.outgoing[at].taken(connection, now)? {
                    self.stop_sending(connection, at)?;
                }
            }
            Event::DestroyNotify(event) => {
                let before = self.outgoing.len();
                self.outgoing.retain(|one| one.requestor() != event.window);
                return Ok(self.outgoing.len() < before);
            }
            Event::SelectionRequest(event) if Some(event.owner) == self.owner => {
                self.asked(connection, event, now)?;
            }
            Event::SelectionClear(event) if Some(event.owner) == self.owner => {
                if let Some(which) = selection_of(connection, event.selection) {
                    // A late event: the selection may be ours again.
                    let asked = connection.get_selection_owner(event.selection);
                    let now = connection.answer(asked)?;
                    if now.is_none_or(|now| Some(now.owner) != self.owner) {
                        *self.owned(which) = None;
                    }
                }
            }
            _ => return Ok(false),
        }
        Ok(true)
    }

    /// Hands the clipboard's text to the clipboard manager, if there is one, so that it outlives
    /// the window. Waits at most `limit`; other events are lost.
    pub(super) fn hand_over(&mut self, connection: &Connection, limit: Duration) -> Result<()> {
        let end = Instant::now() + limit;
        let (Some(owner), Some(owned)) = (self.owner, &self.clipboard) else {
            return Ok(());
        };
        let time = owned.time;
        let atoms = connection.atoms();
        let manager = connection.get_selection_owner(atoms.CLIPBOARD_MANAGER);
        let manager = connection.answer(manager)?;
        if manager.is_none_or(|manager| manager.owner == NONE) {
            return Ok(());
        }
        let list = texts(connection);
        let property = atoms._VIDES_SELECTION;
        let (replace, kind) = (PropMode::REPLACE, AtomEnum::ATOM);
        let asked = connection.change_property32(replace, owner, property, kind, &list);
        connection.sent_quietly(asked)?;
        let (manager, save) = (atoms.CLIPBOARD_MANAGER, atoms.SAVE_TARGETS);
        let asked = connection.convert_selection(owner, manager, save, property, time);
        connection.sent_quietly(asked)?;
        let mut unheard = Vec::new();
        while Instant::now() < end && self.clipboard.is_some() {
            connection.flush()?;
            connection.push()?;
            match connection.next()? {
                Some(Event::SelectionNotify(event))
                    if event.requestor == owner && event.target == save =>
                {
                    break;
                }
                Some(event) => {
                    self.handle(connection, &event, &mut unheard)?;
                }
                None => {
                    let rest = end.saturating_duration_since(Instant::now());
                    let waited = wait(connection.as_fd(), PollFlags::IN, rest);
                    connection.sent(waited.map_err(ConnectionError::from))?;
                }
            }
            unheard.clear();
        }
        Ok(())
    }

    fn owned(&mut self, which: Selection) -> &mut Option<Owned> {
        match which {
            Selection::Clipboard => &mut self.clipboard,
            Selection::Primary => &mut self.primary,
        }
    }

    fn owner(&mut self, connection: &Connection) -> Result<Option<Window>> {
        if self.owner.is_none()
            && let Some(window) = connection.excuse(connection.generate_id())?
        {
            incoming::create(connection, window, EventMask::NO_EVENT)?;
            self.owner = Some(window);
        }
        Ok(self.owner)
    }

    fn receiving(&self, window: Window) -> Option<usize> {
        self.incoming.iter().position(|one| one.window() == window)
    }

    fn sending(&self, window: Window, property: Atom) -> Option<usize> {
        let same = |one: &Outgoing| one.requestor() == window && one.property() == property;
        self.outgoing.iter().position(same)
    }

    /// Continues the transfer to `window`; false without such a transfer.
    fn receive(
        &mut self,
        connection: &Connection,
        window: Window,
        out: &mut Vec<Input>,
        step: impl FnOnce(&mut Incoming) -> Result<Step>,
    ) -> Result<bool> {
        let Some(at) = self.receiving(window) else {
            return Ok(false);
        };
        if let Step::Over(text) = step(&mut self.incoming[at])? {
            let incoming = self.incoming.remove(at);
            let text = text.filter(|text| incoming.place.is_none() || !text.is_empty());
            out.extend(text.map(|text| pasted(text, incoming.place)));
            incoming.finish(connection)?;
        }
        Ok(true)
    }

    /// Drops a transfer; deselects the requestor's events if it gets no other.
    fn stop_sending(&mut self, connection: &Connection, at: usize) -> Result<()> {
        let window = self.outgoing.swap_remove(at).requestor();
        if self.outgoing.iter().all(|one| one.requestor() != window) {
            outgoing::listen(connection, window, false)?;
        }
        Ok(())
    }

    fn asked(
        &mut self,
        connection: &Connection,
        event: &SelectionRequestEvent,
        now: Instant,
    ) -> Result<()> {
        // Clients older than ICCCM name no property.
        let property = match event.property {
            NONE => event.target,
            property => property,
        };
        let to = (event.requestor, property);
        let which = selection_of(connection, event.selection);
        let known = which.is_some_and(|which| {
            let owned = self.owned(which).as_ref();
            owned.is_some_and(|owned| !is_before(event.time, owned.time))
        });
        // Selecting events on a window of ours would replace its event mask.
        let ours = is_ours(connection, event.requestor);
        let done = match which {
            Some(which) if known && !ours => {
                if event.target == connection.atoms().MULTIPLE {
                    event.property != NONE && self.convert_all(connection, which, to, now)?
                } else {
                    self.convert(connection, which, event.target, to, now)?
                }
            }
            _ => false,
        };
        let answer = SelectionNotifyEvent {
            response_type: SELECTION_NOTIFY_EVENT,
            sequence: 0,
            time: event.time,
            requestor: event.requestor,
            selection: event.selection,
            target: event.target,
            property: if done { property } else { NONE },
        };
        let (to, nobody) = (event.requestor, EventMask::NO_EVENT);
        connection.sent_quietly(connection.send_event(false, to, nobody, answer))
    }

    /// Converts the targets of a MULTIPLE request, replacing those that fail by None.
    fn convert_all(
        &mut self,
        connection: &Connection,
        which: Selection,
        (requestor, property): (Window, Atom),
        now: Instant,
    ) -> Result<bool> {
        let asked =
            connection.get_property(false, requestor, property, AtomEnum::ANY, 0, 2 * MOST_PAIRS);
        let list = (connection.answer(asked)?).filter(|list| list.bytes_after == 0);
        let Some(mut list) = list.and_then(|list| Some(list.value32()?.collect::<Vec<Atom>>()))
        else {
            return Ok(false);
        };
        for pair in list.chunks_exact_mut(2) {
            if let [target, into] = pair
                && (*into == NONE
                    || *target == connection.atoms().MULTIPLE
                    || !self.convert(connection, which, *target, (requestor, *into), now)?)
            {
                *into = NONE;
            }
        }
        let kind = connection.atoms().ATOM_PAIR;
        let replace = PropMode::REPLACE;
        let asked = connection.change_property32(replace, requestor, property, kind, &list);
        connection.sent_quietly(asked)?;
        Ok(true)
    }

    /// Writes one target into a property of the requestor, at once or in pieces. False if refused.
    fn convert(
        &mut self,
        connection: &Connection,
        which: Selection,
        target: Atom,
        to: (Window, Atom),
        now: Instant,
    ) -> Result<bool> {
        if connection.stream().waiting() > MOST_WAITING {
            return Ok(false);
        }
        let Some(value) = self.value(connection, which, target) else {
            return Ok(false);
        };
        let (window, property) = to;
        let replace = PropMode::REPLACE;
        let written = match value {
            Value::Atoms(atoms) => {
                connection.change_property32(replace, window, property, AtomEnum::ATOM, &atoms)
            }
            Value::Time(time) => {
                connection.change_property32(replace, window, property, AtomEnum::INTEGER, &[time])
            }
            Value::Nothing => {
                let kind = connection.atoms().NULL;
                connection.change_property32(replace, window, property, kind, &[])
            }
            Value::Text(kind, text) if text.len() <= outgoing::piece(connection) => {
                connection.change_property8(replace, window, property, kind, &text)
            }
            Value::Text(kind, text) => {
                if let Some(same) = self.sending(window, property) {
                    self.outgoing.swap_remove(same);
                }
                if self.outgoing.len() >= MOST_OUTGOING {
                    return Ok(false);
                }
                let started = Outgoing::start(connection, to, kind, text, now)?;
                self.outgoing.push(started);
                return Ok(true);
            }
        };
        connection.sent_quietly(written)?;
        Ok(true)
    }

    fn value(&mut self, connection: &Connection, which: Selection, target: Atom) -> Option<Value> {
        let atoms = connection.atoms();
        let string = Atom::from(AtomEnum::STRING);
        let owned = self.owned(which).as_ref()?;
        Some(if target == atoms.TARGETS {
            let mut list = vec![atoms.TARGETS, atoms.MULTIPLE, atoms.TIMESTAMP];
            if which == Selection::Clipboard {
                list.push(atoms.SAVE_TARGETS);
            }
            list.extend(texts(connection));
            Value::Atoms(list)
        } else if target == atoms.TIMESTAMP {
            Value::Time(owned.time)
        } else if target == atoms.SAVE_TARGETS && which == Selection::Clipboard {
            Value::Nothing
        } else if target == string {
            Value::Text(string, owned.latin())
        } else if target == atoms.TEXT {
            // The owner chooses; take the simplest encoding that holds the whole text.
            match owned.text.is_ascii() {
                true => Value::Text(string, Rc::clone(&owned.text)),
                false => Value::Text(atoms.UTF8_STRING, Rc::clone(&owned.text)),
            }
        } else if [atoms.UTF8_STRING, atoms.TEXT_PLAIN_UTF8].contains(&target) {
            Value::Text(target, Rc::clone(&owned.text))
        } else {
            return None;
        })
    }
}

impl Owned {
    fn latin(&self) -> Rc<[u8]> {
        let make = || {
            let text = String::from_utf8_lossy(&self.text);
            let signs = text.chars().map(|sign| u8::try_from(sign).unwrap_or(b'?'));
            signs.collect()
        };
        Rc::clone(self.latin.get_or_init(make))
    }
}

fn pasted(text: String, place: Option<Pos2>) -> Input {
    match place {
        Some(pos) => Input::MiddleClickPaste { pos, text },
        None => Input::Paste(text),
    }
}

/// The targets that deliver the text itself.
fn texts(connection: &Connection) -> [Atom; 4] {
    let atoms = connection.atoms();
    [
        atoms.UTF8_STRING,
        atoms.TEXT_PLAIN_UTF8,
        atoms.TEXT,
        AtomEnum::STRING.into(),
    ]
}

fn atom(connection: &Connection, which: Selection) -> Atom {
    match which {
        Selection::Clipboard => connection.atoms().CLIPBOARD,
        Selection::Primary => AtomEnum::PRIMARY.into(),
    }
}

fn selection_of(connection: &Connection, selection: Atom) -> Option<Selection> {
    [Selection::Clipboard, Selection::Primary]
        .into_iter()
        .find(|which| atom(connection, *which) == selection)
}

fn is_ours(connection: &Connection, window: Window) -> bool {
    let setup = connection.setup();
    window & !setup.resource_id_mask == setup.resource_id_base
}

/// Compares server times, which wrap around after 50 days. CurrentTime is never before another
/// time.
fn is_before(time: u32, other: u32) -> bool {
    let behind = other.wrapping_sub(time);
    time != CURRENT_TIME && other != CURRENT_TIME && behind != 0 && behind < u32::MAX / 2
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_servers_clock_wraps() {
        assert!(is_before(5, 6) && !is_before(6, 5) && !is_before(5, 5));
        assert!(is_before(u32::MAX - 5, 3) && !is_before(3, u32::MAX - 5));
        assert!(!is_before(CURRENT_TIME, 9) && !is_before(9, CURRENT_TIME));
    }

    #[test]
    fn latin_1_has_a_question_mark_for_the_rest() {
        let owned = Owned {
            text: "aä€\n".as_bytes().into(),
            latin: OnceCell::new(),
            time: 0,
        };
        assert_eq!(&*owned.latin(), b"a\xE4?\n");
    }
}
