//! Receives text, or a list of dropped files, from another program's selection, possibly in pieces
//! (ICCCM 2.7.2, INCR).
//!
//! The other program is not trusted to answer sensibly or to stop at all, so each transfer has its
//! own window, a size limit, and time limits.

use std::time::{Duration, Instant};

use egui::Pos2;
use x11rb::connection::Connection as _;
use x11rb::protocol::xproto::{
    Atom, AtomEnum, ConnectionExt as _, CreateWindowAux, EventMask, SelectionNotifyEvent, Window,
    WindowClass,
};
use x11rb::{COPY_DEPTH_FROM_PARENT, COPY_FROM_PARENT, NONE};

use super::connection::Connection;
use crate::error::Result;
use vides_engine::limits::MAX_CLIPBOARD_BYTES;

/// How long to wait for the other program's next step.
pub(super) const STEP_TIMEOUT: Duration = Duration::from_secs(5);

/// How long a transfer may take in all.
const TRANSFER_TIMEOUT: Duration = Duration::from_secs(60);

/// How long the server may take to deliver one available piece.
const READ_TIMEOUT: Duration = Duration::from_secs(2);

/// The length of one property read, in 32-bit words (256 KB).
const PIECE: u32 = 1 << 16;

/// The most bytes of a list of dropped files.
const MOST_OF_A_LIST: usize = 1 << 20;

/// What is requested.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Wanted {
    Text,
    /// A list of URIs.
    Files,
}

pub(super) struct Incoming {
    window: Window,
    selection: Atom,
    /// The server time of the user's request.
    time: u32,
    /// Where in the window to paste; `None` for the keyboard focus.
    pub(super) place: Option<Pos2>,
    wanted: Wanted,
    /// How many of the targets were requested in vain.
    refused: usize,
    pieces: bool,
    kind: Atom,
    bytes: Vec<u8>,
    step_end: Instant,
    end: Instant,
}

#[derive(Debug, PartialEq, Eq)]
pub(super) enum Step {
    Underway,
    /// The text, empty if no program offers one; `None` if the data is unusable.
    Over(Option<String>),
}

enum Read {
    Missing,
    /// An INCR transfer begins; a lower bound of its size.
    Pieces(u32),
    /// The property's type and the number of bytes appended.
    Bytes(Atom, usize),
    /// Too large, or not text.
    Useless,
}

impl Incoming {
    /// Requests a selection's text from its owner. `None` if the server has no identifiers left.
    pub(super) fn start(
        connection: &Connection,
        selection: Atom,
        time: u32,
        place: Option<Pos2>,
        wanted: Wanted,
        now: Instant,
    ) -> Result<Option<Self>> {
        let window = connection.generate_id();
        let Some(window) = connection.excuse(window)? else {
            return Ok(None);
        };
        create(connection, window, EventMask::PROPERTY_CHANGE)?;
        let incoming = Self {
            window,
            selection,
            time,
            place,
            wanted,
            refused: 0,
            pieces: false,
            kind: NONE,
            bytes: Vec::new(),
            step_end: now + STEP_TIMEOUT,
            end: now + TRANSFER_TIMEOUT,
        };
        incoming.ask(connection)?;
        Ok(Some(incoming))
    }

    pub(super) fn window(&self) -> Window {
        self.window
    }

    pub(super) fn deadline(&self) -> Instant {
        self.step_end.min(self.end)
    }

    pub(super) fn answered(
        &mut self,
        connection: &Connection,
        event: &SelectionNotifyEvent,
        now: Instant,
    ) -> Result<Step> {
        let asked = self.target(connection);
        if self.pieces || event.selection != self.selection || Some(event.target) != asked {
            return Ok(Step::Underway);
        }
        self.step_end = now + STEP_TIMEOUT;
        if event.property == NONE {
            self.refused += 1;
            if self.target(connection).is_none() {
                return Ok(Step::Over(Some(String::new())));
            }
            self.ask(connection)?;
            return Ok(Step::Underway);
        }
        match self.read(connection)? {
            Read::Pieces(size) if size as usize <= self.most() => {
                self.pieces = true;
                Ok(Step::Underway)
            }
            Read::Bytes(kind, _) => {
                self.kind = kind;
                Ok(Step::Over(self.text(connection)))
            }
            Read::Missing | Read::Pieces(_) | Read::Useless => Ok(Step::Over(None)),
        }
    }

    /// Handles a new property value, which is the next piece of an INCR transfer.
    pub(super) fn written(
        &mut self,
        connection: &Connection,
        property: Atom,
        now: Instant,
    ) -> Result<Step> {
        if !self.pieces || property != connection.atoms()._VIDES_SELECTION {
            return Ok(Step::Underway);
        }
        match self.read(connection)? {
            Read::Missing => Ok(Step::Underway),
            Read::Bytes(_, 0) => Ok(Step::Over(self.text(connection))),
            Read::Bytes(kind, _) if self.kind == NONE || self.kind == kind => {
                self.kind = kind;
                self.step_end = now + STEP_TIMEOUT;
                Ok(Step::Underway)
            }
            Read::Bytes(..) | Read::Pieces(_) | Read::Useless => Ok(Step::Over(None)),
        }
    }

    /// Destroys the window; anything that still arrives is lost.
    pub(super) fn finish(self, connection: &Connection) -> Result<()> {
        connection.sent_quietly(connection.destroy_window(self.window))
    }

    fn ask(&self, connection: &Connection) -> Result<()> {
        let Some(target) = self.target(connection) else {
            return Ok(());
        };
        let property = connection.atoms()._VIDES_SELECTION;
        connection.sent_quietly(connection.convert_selection(
            self.window,
            self.selection,
            target,
            property,
            self.time,
        ))
    }

    /// The target to request, best first.
    fn target(&self, connection: &Connection) -> Option<Atom> {
        let atoms = connection.atoms();
        let texts = [
            atoms.UTF8_STRING,
            atoms.TEXT_PLAIN_UTF8,
            AtomEnum::STRING.into(),
        ];
        let files = [atoms.TEXT_URI_LIST];
        let targets: &[Atom] = match self.wanted {
            Wanted::Text => &texts,
            Wanted::Files => &files,
        };
        targets.get(self.refused).copied()
    }

    /// The maximum number of bytes.
    const fn most(&self) -> usize {
        match self.wanted {
            Wanted::Text => MAX_CLIPBOARD_BYTES,
            Wanted::Files => MOST_OF_A_LIST,
        }
    }

    fn read(&mut self, connection: &Connection) -> Result<Read> {
        let property = connection.atoms()._VIDES_SELECTION;
        let end = Instant::now() + READ_TIMEOUT;
        let mut words = 0;
        let mut read = 0;
        loop {
            // The server deletes the property when its last bytes are read.
            let asked =
                connection.get_property(true, self.window, property, AtomEnum::ANY, words, PIECE);
            let Some(piece) = connection.answer(asked)? else {
                return Ok(Read::Useless);
            };
            if piece.type_ == NONE {
                return Ok(Read::Missing);
            }
            if piece.type_ == connection.atoms().INCR {
                let size = piece.value32().and_then(|mut sizes| sizes.next());
                return Ok(Read::Pieces(size.unwrap_or(0)));
            }
            let left = piece.bytes_after as usize;
            let size = self.bytes.len() + piece.value.len() + left;
            if piece.format != 8 || size > self.most() || Instant::now() > end {
                return Ok(Read::Useless);
            }
            if self.bytes.try_reserve(piece.value.len()).is_err() {
                return Ok(Read::Useless);
            }
            self.bytes.extend_from_slice(&piece.value);
            read += piece.value.len();
            if left == 0 {
                return Ok(Read::Bytes(piece.type_, read));
            }
            if piece.value.is_empty() {
                return Ok(Read::Useless);
            }
            words += PIECE;
        }
    }

    fn text(&mut self, connection: &Connection) -> Option<String> {
        let atoms = connection.atoms();
        let bytes = std::mem::take(&mut self.bytes);
        let text = if self.kind == u32::from(AtomEnum::STRING) {
            bytes.iter().copied().map(char::from).collect()
        } else if [atoms.UTF8_STRING, atoms.TEXT_PLAIN_UTF8, atoms.TEXT_PLAIN].contains(&self.kind)
            || self.wanted == Wanted::Files && self.kind == atoms.TEXT_URI_LIST
        {
            match String::from_utf8(bytes) {
                Ok(text) => text,
                Err(error) => String::from_utf8_lossy(error.as_bytes()).into_owned(),
            }
        } else {
            return None;
        };
        Some(clean(&text)).filter(|text| !text.is_empty())
    }
}

/// Normalizes line endings and drops control characters.
fn clean(text: &str) -> String {
    let mut clean = String::with_capacity(text.len());
    let mut signs = text.chars().peekable();
    while let Some(sign) = signs.next() {
        match sign {
            '\r' if signs.peek() == Some(&'\n') => {}
            '\r' => clean.push('\n'),
            '\n' | '\t' => clean.push(sign),
            sign if sign.is_control() => {}
            sign => clean.push(sign),
        }
    }
    clean
}

/// Creates an invisible window for transfers.
pub(super) fn create(connection: &Connection, window: Window, events: EventMask) -> Result<()> {
    let root = connection.screen().root;
    let aux = CreateWindowAux::new().event_mask(events);
    let (depth, class) = (COPY_DEPTH_FROM_PARENT, WindowClass::INPUT_ONLY);
    connection.sent_quietly(connection.create_window(
        depth,
        window,
        root,
        0,
        0,
        1,
        1,
        0,
        class,
        COPY_FROM_PARENT,
        &aux,
    ))
}

#[cfg(test)]
mod tests {
    use super::clean;

    #[test]
    fn pasted_text_has_no_control_characters() {
        assert_eq!(clean("a\r\nb\rc\nd\te"), "a\nb\nc\nd\te");
        assert_eq!(clean("\0x\u{1b}[1m\u{9b}y\u{7f}\0"), "x[1my");
        assert_eq!(clean("äöü €"), "äöü €");
    }
}
