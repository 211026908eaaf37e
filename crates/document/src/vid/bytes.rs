//! What files hold before it is read: bytes and text, of no more than there may be.

use std::io::Read;
use std::path::Path;

use super::field::at_line;
use crate::error::{EngineError, Error, Malformed, Result, can_allocate, vec_with_room};
use crate::inputs::note_input;
use crate::not_a_file::open;
use vides_engine::limits::MAX_FILE_BYTES;

/// The format version that is written, and the newest that is read.
pub(super) const VERSION: i64 = 1;

/// In place of a limit: disables its kind.
pub(super) const OFF_NAME: &str = "off";

/// For names, messages and the like: the standard library aborts if it cannot allocate them.
const ROOM: usize = 32 << 10;

/// What `parse` makes of the text of a file; all errors name it.
pub(crate) fn load<T>(file: &Path, parse: impl FnOnce(&str) -> Result<T>) -> Result<T> {
    let text = read_text(file, MAX_FILE_BYTES)?;
    parse(&text).map_err(|error| error.at(file.display()))
}

/// The same of a reader, to its end, which errors call `name`.
pub(crate) fn load_from<T>(
    reader: &mut dyn Read,
    name: &str,
    parse: impl FnOnce(&str) -> Result<T>,
) -> Result<T> {
    read_all(reader, name, 0, MAX_FILE_BYTES)
        .and_then(text_of)
        .and_then(|text| parse(&text))
        .map_err(|error| error.at(name))
}

/// The text of a regular file of at most `most` bytes.
///
/// # Errors
/// `ErrorKind::Io`, `Limit`, `Memory`, or `Format` if it is not UTF-8; each names the file.
pub fn read_text(file: &Path, most: u64) -> Result<String> {
    read_bytes(file, most)
        .and_then(text_of)
        .map_err(|error| error.at(file.display()))
}

/// The bytes of a regular file of at most `most`; only `ErrorKind::Io` errors name the file.
#[doc(hidden)]
pub fn read_bytes(file: &Path, most: u64) -> Result<Vec<u8>> {
    can_allocate(ROOM)?;
    let place = file.display().to_string();
    let io = |source| Error::Io {
        place: file.display().to_string(),
        source,
    };
    let mut opened = open(file).map_err(io)?;
    let metadata = opened.metadata().map_err(io)?;
    note_input(&metadata, &place);
    let size = metadata.len();
    if size > most {
        return Err(too_large(most));
    }
    // One byte more, so that reading to the end does not grow it.
    let room = usize::try_from(size).map_err(|_| EngineError::Memory)? + 1;
    read_all(&mut opened, &place, room, most)
}

fn read_all(reader: &mut dyn Read, place: &str, room: usize, most: u64) -> Result<Vec<u8>> {
    let mut bytes = vec_with_room(room)?;
    // The file and its size may change while it is read.
    reader
        .take(most + 1)
        .read_to_end(&mut bytes)
        .map_err(|source| match source.kind() {
            std::io::ErrorKind::OutOfMemory => EngineError::Memory.into(),
            _ => Error::Io {
                place: place.to_owned(),
                source,
            },
        })?;
    if bytes.len() as u64 > most {
        return Err(too_large(most));
    }
    Ok(bytes)
}

fn text_of(bytes: Vec<u8>) -> Result<String> {
    String::from_utf8(bytes).map_err(|error| {
        let before = &error.as_bytes()[..error.utf8_error().valid_up_to()];
        let line = 1 + before.iter().filter(|&&byte| byte == b'\n').count();
        at_line(line, Malformed::NotUtf8)
    })
}

pub(super) fn too_large(most: u64) -> Error {
    Error::FileTooLarge(most >> 20)
}
