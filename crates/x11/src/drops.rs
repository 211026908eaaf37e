//! Files dropped on the window (Xdnd, versions 3 to 5). A list of URIs is accepted, as a copy;
//! anything else is refused, as the protocol requires.
//!
//! The other program is not trusted: what it sends is bounded in size and time, a drop that was not
//! announced is ignored, and only one drop is under way at a time.

use std::ffi::OsString;
use std::os::unix::ffi::OsStringExt as _;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Instant;

use x11rb::NONE;
use x11rb::protocol::Event;
use x11rb::protocol::xproto::{
    Atom, AtomEnum, ClientMessageEvent, ConnectionExt as _, EventMask, Property, Window,
};

use super::connect::host_name;
use super::connection::Connection;
use super::incoming::{Incoming, Step, Wanted};
use crate::error::Result;

/// The version that the window announces.
pub(super) const VERSION: u32 = 5;

/// Earlier versions have neither the list of types nor the time of the drop.
const OLDEST: u32 = 3;

/// Types read from a source that offers many.
const MOST_TYPES: u32 = 256;

const MOST_FILES: usize = 256;

/// The number of letters to show of an entry that is no file.
const MOST_LETTERS: usize = 200;

#[derive(Default)]
pub(super) struct Drops {
    /// The window that drags over ours, and whether it offers files.
    source: Option<(Window, bool)>,
    /// The transfer of dropped files, and the window that they come from.
    incoming: Option<(Incoming, Window)>,
    files: Vec<PathBuf>,
}

/// A file for egui, which only needs its name.
#[derive(Debug)]
struct Dropped(PathBuf);

impl egui::DroppedFile for Dropped {
    fn path(&self) -> &Path {
        &self.0
    }

    fn bytes(&self) -> std::result::Result<Vec<u8>, String> {
        std::fs::read(&self.0).map_err(|error| error.to_string())
    }
}

impl Drops {
    /// The files dropped since the last call; an entry that is no file of this machine is a
    /// relative path.
    pub(super) fn take(&mut self) -> Vec<egui::DroppedFileHandle> {
        let files = std::mem::take(&mut self.files).into_iter();
        files.map(|file| Arc::new(Dropped(file)) as _).collect()
    }

    pub(super) fn deadline(&self) -> Option<Instant> {
        Some(self.incoming.as_ref()?.0.deadline())
    }

    pub(super) fn tick(
        &mut self,
        connection: &Connection,
        ours: Window,
        now: Instant,
    ) -> Result<()> {
        if self.deadline().is_some_and(|deadline| deadline <= now) {
            self.end(connection, ours, None)?;
        }
        Ok(())
    }

    pub(super) fn message(
        &mut self,
        connection: &Connection,
        ours: Window,
        event: &ClientMessageEvent,
    ) -> Result<()> {
        let atoms = connection.atoms();
        let data = event.data.as_data32();
        let from = data[0];
        if event.type_ == atoms.XdndEnter {
            let known = data[1] >> 24 >= OLDEST;
            self.source = match known {
                true => Some((from, has_files(connection, &data)?)),
                false => None,
            };
            return Ok(());
        }
        let Some((_, files)) = self.source.filter(|source| source.0 == from) else {
            return Ok(());
        };
        let wanted = files && self.incoming.is_none();
        if event.type_ == atoms.XdndPosition {
            // An empty rectangle: the source may send every motion.
            let answer = [ours, u32::from(wanted), 0, 0, action(connection, wanted)];
            return send(connection, from, atoms.XdndStatus, answer);
        }
        if event.type_ == atoms.XdndLeave {
            self.source = None;
        } else if event.type_ == atoms.XdndDrop {
            self.source = None;
            let (selection, time) = (atoms.XdndSelection, data[2]);
            let started = match wanted {
                true => {
                    let now = Instant::now();
                    Incoming::start(connection, selection, time, None, Wanted::Files, now)?
                }
                false => None,
            };
            match started {
                Some(incoming) => self.incoming = Some((incoming, from)),
                None => finished(connection, from, ours, false)?,
            }
        }
        Ok(())
    }

    /// Handles an event of a transfer; true if files have arrived.
    pub(super) fn handle(
        &mut self,
        connection: &Connection,
        ours: Window,
        event: &Event,
    ) -> Result<bool> {
        let now = Instant::now();
        let Some((incoming, _)) = &mut self.incoming else {
            return Ok(false);
        };
        let step = match event {
            Event::SelectionNotify(event) if event.requestor == incoming.window() => {
                incoming.answered(connection, event, now)?
            }
            Event::PropertyNotify(event)
                if event.window == incoming.window() && event.state == Property::NEW_VALUE =>
            {
                incoming.written(connection, event.atom, now)?
            }
            _ => return Ok(false),
        };
        if let Step::Over(list) = step {
            self.end(connection, ours, list)?;
        }
        Ok(!self.files.is_empty())
    }

    /// Ends a transfer, with the list if it has arrived, and notifies its source.
    fn end(&mut self, connection: &Connection, ours: Window, list: Option<String>) -> Result<()> {
        let Some((incoming, source)) = self.incoming.take() else {
            return Ok(());
        };
        incoming.finish(connection)?;
        let files = files_of(&list.unwrap_or_default(), &host_name());
        let done = !files.is_empty();
        if done {
            self.files = files;
        }
        finished(connection, source, ours, done)
    }
}

/// Whether the types that a source offers include a list of URIs.
fn has_files(connection: &Connection, data: &[u32; 5]) -> Result<bool> {
    const MORE_THAN_THREE: u32 = 1;
    let list = connection.atoms().TEXT_URI_LIST;
    if data[1] & MORE_THAN_THREE == 0 {
        return Ok(data[2..].contains(&list));
    }
    let (types, kind) = (connection.atoms().XdndTypeList, AtomEnum::ATOM);
    let asked = connection.get_property(false, data[0], types, kind, 0, MOST_TYPES);
    let types = connection.answer(asked)?;
    Ok(types.is_some_and(|types| {
        types
            .value32()
            .is_some_and(|mut all| all.any(|one| one == list))
    }))
}

fn action(connection: &Connection, wanted: bool) -> Atom {
    match wanted {
        true => connection.atoms().XdndActionCopy,
        false => NONE,
    }
}

fn finished(connection: &Connection, source: Window, ours: Window, done: bool) -> Result<()> {
    let answer = [ours, u32::from(done), action(connection, done), 0, 0];
    send(connection, source, connection.atoms().XdndFinished, answer)
}

fn send(connection: &Connection, to: Window, kind: Atom, data: [u32; 5]) -> Result<()> {
    let message = ClientMessageEvent::new(32, to, kind, data);
    connection.sent_quietly(connection.send_event(false, to, EventMask::NO_EVENT, message))
}

/// The entries of a list of URIs (RFC 2483): files of this machine, which is called `host`, as
/// absolute paths; anything else verbatim, for a message about it.
fn files_of(list: &str, host: &[u8]) -> Vec<PathBuf> {
    let lines = list.lines().map(str::trim);
    let uris = lines.filter(|line| !line.is_empty() && !line.starts_with('#'));
    let other = |uri: &str| {
        let letters = uri.trim_start_matches('/').chars();
        PathBuf::from(letters.take(MOST_LETTERS).collect::<String>())
    };
    let files = uris.map(|uri| file_of(uri, host).unwrap_or_else(|| other(uri)));
    files.take(MOST_FILES).collect()
}

/// The file of this machine that a URI names (RFC 8089).
fn file_of(uri: &str, host: &[u8]) -> Option<PathBuf> {
    let (scheme, rest) = uri.split_once(':')?;
    if !scheme.eq_ignore_ascii_case("file") {
        return None;
    }
    let path = match rest.strip_prefix("//") {
        None => rest,
        Some(rest) => {
            let (machine, path) = rest.split_at(rest.find('/')?);
            let here = [&b""[..], b"localhost", host];
            let is = |known: &&[u8]| machine.as_bytes().eq_ignore_ascii_case(known);
            here.iter().any(is).then_some(path)?
        }
    };
    let path = decoded(path).filter(|path| path.starts_with(b"/") && !path.contains(&0))?;
    Some(PathBuf::from(OsString::from_vec(path)))
}

/// Decodes bytes, some of which are written as `%` and two hexadecimal digits.
fn decoded(text: &str) -> Option<Vec<u8>> {
    let digit = |byte: u8| char::from(byte).to_digit(16);
    let mut out = Vec::with_capacity(text.len());
    let mut bytes = text.bytes();
    while let Some(byte) = bytes.next() {
        out.push(match byte {
            b'%' => u8::try_from(16 * digit(bytes.next()?)? + digit(bytes.next()?)?).ok()?,
            other => other,
        });
    }
    Some(out)
}

#[cfg(test)]
mod tests {
    use std::os::unix::ffi::OsStrExt as _;

    use super::*;

    #[test]
    fn uris_become_files_of_this_machine() {
        let known =
            |uri: &str| file_of(uri, b"here").map(|path| path.as_os_str().as_bytes().to_vec());
        let cases: [(&str, &[u8]); 7] = [
            ("file:///a/b.vid", b"/a/b.vid"),
            ("file:/a/b.vid", b"/a/b.vid"),
            ("FILE://localhost/a%20b.vid", b"/a b.vid"),
            ("file://HERE/%C3%A4%23%25.obj", "/ä#%.obj".as_bytes()),
            ("file:///%ff%FE", b"/\xff\xfe"),
            ("file:///a+b&c;d=e", b"/a+b&c;d=e"),
            ("file:///ä", "/ä".as_bytes()),
        ];
        for (uri, path) in cases {
            assert_eq!(known(uri).as_deref(), Some(path), "{uri}");
        }
        for uri in [
            "",
            ":",
            "file:",
            "file://",
            "file://there/a",
            "file://here",
            "file:a",
            "file:///a%00b",
            "file:///a%2",
            "file:///a%",
            "file:///a%zz",
            "file:///%+1",
            "http://here/a",
            "/a/b",
            "data:,file:///a",
        ] {
            assert_eq!(known(uri), None, "{uri}");
        }
    }

    #[test]
    fn lists_have_comments_and_both_line_ends() {
        let list = "# from a test\r\nfile:///a\r\n\r\nfile:///b\n /etc/passwd \nhttp://x/y";
        let files = files_of(list, b"here");
        let paths = ["/a", "/b", "etc/passwd", "http://x/y"].map(PathBuf::from);
        assert_eq!(files, paths);
        assert_eq!(files_of(&"x:\n".repeat(9999), b"here").len(), MOST_FILES);
        assert_eq!(
            files_of(&"y".repeat(1 << 20), b"here")[0].as_os_str().len(),
            MOST_LETTERS
        );
    }
}
