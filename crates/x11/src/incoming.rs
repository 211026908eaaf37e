//! A text on its way to us from another program's selection.
//!
//! The other program decides when it answers, what it answers and whether it
//! ever stops: so each transfer has a window of its own, gone with it, a limit
//! of size, and limits of time. Large texts come in pieces (ICCCM 2.7.2).

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
use crate::limits::MAX_CLIPBOARD_BYTES;

/// How long the other program may let us wait for its next step.
const PATIENCE: Duration = Duration::from_secs(5);

/// How long it may take in all.
const WHOLE: Duration = Duration::from_secs(60);

/// How long the server may take to hand over one piece that is there.
const READING: Duration = Duration::from_secs(2);

/// Words of a property that are asked for at once: 256 KB.
const PIECE: u32 = 1 << 16;

/// A transfer under way.
pub(super) struct Incoming {
    window: Window,
    selection: Atom,
    /// When the user asked for it, on the server's clock.
    time: u32,
    /// Where in the window it goes; where the keyboard is if nowhere.
    pub(super) place: Option<Pos2>,
    /// Which of [`targets`] was asked for.
    target: usize,
    pieces: bool,
    kind: Atom,
    bytes: Vec<u8>,
    patience: Instant,
    end: Instant,
}

/// What a transfer has come to.
#[derive(Debug, PartialEq, Eq)]
pub(super) enum Step {
    Underway,
    /// The text, empty if nobody offers one; none if what came is useless.
    Over(Option<String>),
}

enum Read {
    /// There is none.
    Missing,
    /// It announces pieces; about so many bytes in all.
    Pieces(u32),
    /// Its kind; what it holds was added to the bytes.
    Bytes(Atom, usize),
    /// It is too large, or no text.
    Useless,
}

impl Incoming {
    /// Asks the owner of a selection for its text. Nothing if the server gives
    /// no more windows.
    pub(super) fn start(
        connection: &Connection,
        selection: Atom,
        time: u32,
        place: Option<Pos2>,
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
            target: 0,
            pieces: false,
            kind: NONE,
            bytes: Vec::new(),
            patience: now + PATIENCE,
            end: now + WHOLE,
        };
        incoming.ask(connection)?;
        Ok(Some(incoming))
    }

    pub(super) fn window(&self) -> Window {
        self.window
    }

    /// When it has taken too long.
    pub(super) fn deadline(&self) -> Instant {
        self.patience.min(self.end)
    }

    /// The owner has answered.
    pub(super) fn answered(
        &mut self,
        connection: &Connection,
        event: &SelectionNotifyEvent,
        now: Instant,
    ) -> Result<Step> {
        let asked = targets(connection).get(self.target).copied();
        if self.pieces || event.selection != self.selection || Some(event.target) != asked {
            return Ok(Step::Underway);
        }
        self.patience = now + PATIENCE;
        if event.property == NONE {
            self.target += 1;
            if self.target >= targets(connection).len() {
                return Ok(Step::Over(Some(String::new())));
            }
            self.ask(connection)?;
            return Ok(Step::Underway);
        }
        match self.read(connection)? {
            Read::Pieces(size) if size as usize <= MAX_CLIPBOARD_BYTES => {
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

    /// A property of the window has a new value: the next piece, if pieces are
    /// what we wait for.
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
                self.patience = now + PATIENCE;
                Ok(Step::Underway)
            }
            Read::Bytes(..) | Read::Pieces(_) | Read::Useless => Ok(Step::Over(None)),
        }
    }

    /// Leaves nothing of it on the server; what is still sent, is sent to
    /// nobody.
    pub(super) fn finish(self, connection: &Connection) -> Result<()> {
        let destroyed = connection.destroy_window(self.window);
        destroyed
            .map_err(|error| connection.lost(error))?
            .ignore_error();
        Ok(())
    }

    fn ask(&self, connection: &Connection) -> Result<()> {
        let Some(&target) = targets(connection).get(self.target) else {
            return Ok(());
        };
        let property = connection.atoms()._VIDES_SELECTION;
        connection
            .convert_selection(self.window, self.selection, target, property, self.time)
            .map_err(|error| connection.lost(error))?
            .ignore_error();
        Ok(())
    }

    /// Reads the property, adds it to the bytes, and deletes it.
    fn read(&mut self, connection: &Connection) -> Result<Read> {
        let property = connection.atoms()._VIDES_SELECTION;
        let end = Instant::now() + READING;
        let mut words = 0;
        let mut read = 0;
        loop {
            // It is deleted together with the reading of its last bytes.
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
            if piece.format != 8 || size > MAX_CLIPBOARD_BYTES || Instant::now() > end {
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

    /// The bytes as text, by the kind that the owner says they are.
    fn text(&mut self, connection: &Connection) -> Option<String> {
        let atoms = connection.atoms();
        let bytes = std::mem::take(&mut self.bytes);
        let text = if self.kind == u32::from(AtomEnum::STRING) {
            bytes.iter().copied().map(char::from).collect()
        } else if [atoms.UTF8_STRING, atoms.TEXT_PLAIN_UTF8, atoms.TEXT_PLAIN].contains(&self.kind)
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

/// What a text is asked for as, the best first.
fn targets(connection: &Connection) -> [Atom; 3] {
    let atoms = connection.atoms();
    [
        atoms.UTF8_STRING,
        atoms.TEXT_PLAIN_UTF8,
        AtomEnum::STRING.into(),
    ]
}

/// A text with ends of lines as we write them, and no control characters.
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

/// Makes a window that is never seen, for selections.
pub(super) fn create(connection: &Connection, window: Window, events: EventMask) -> Result<()> {
    let root = connection.screen().root;
    let aux = CreateWindowAux::new().event_mask(events);
    connection
        .create_window(
            COPY_DEPTH_FROM_PARENT,
            window,
            root,
            0,
            0,
            1,
            1,
            0,
            WindowClass::INPUT_ONLY,
            COPY_FROM_PARENT,
            &aux,
        )
        .map_err(|error| connection.lost(error))?
        .ignore_error();
    Ok(())
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
