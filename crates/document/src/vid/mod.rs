//! `.vid` files: a whole document as TOML, to be read and written by people too.
//!
//! The parsed tree is read by hand, so that every error names its line and speaks of cameras.
//! Unknown keys are refused, since a typo must not vanish. Missing values have the defaults of a
//! new path. Numbers are written with as few digits as give the same bits back.
//!
//! ```toml
//! version = 1
//! title = "Two looks"
//!
//! [[point]]
//! name = "start"
//! position = [-0.6, 0.2, 0.8]
//! preset = 5
//!
//! [[point.orientation]]
//! target = [0.0, 0.0, 0.0]        # looks at this place, wherever the point is
//! roll_degrees = 15.0
//!
//! [[point]]
//! position = [0.6, 0.2, 0.8]
//! own = { tension = 0.2, continuity = 0.0, bias = 0.5 }
//!
//! [[point.orientation]]
//! offset = [0.0, 0.0, -0.4]       # looks in this direction
//! zoom_mm = 50.0
//! hold_frames = 12
//! speed_curve = [1.0, 20.0, 50.0, 50.0, 50.0, 50.0, 50.0, 50.0, 50.0, 50.0]
//! ```

mod alone;
mod comments;
pub mod field;
mod keys_text;
mod mesh;
mod mesh_source;
mod own;
mod path_read;
mod pieces;
mod read;
mod scene_read;
mod scene_write;
mod shown;
mod statements;
mod text;
pub mod tree;
mod weight;
mod write;

use std::io::Read;
use std::path::Path;

use super::not_a_file::open;
use crate::error::{EngineError, Error, Malformed, Result, can_allocate, vec_with_room};
use vides_engine::limits::MAX_FILE_BYTES;

pub(super) use alone::alone;
pub(super) use comments::{Comments, insert_points, remove_points};
pub(super) use keys_text::{keys_from_toml, keys_to_toml};
pub(super) use path_read::{point_keys, view_keys};
pub(super) use read::{
    PATH_KEYS, from_toml, nodes_from_toml, scene_from_toml, shown_from_toml, value_of,
};
pub(super) use scene_write::{nodes_to_toml, scene_to_toml};
pub(super) use text::quoted;
pub(super) use write::{to_toml, view_to_toml};

/// The format version that is written, and the newest that is read.
const VERSION: i64 = 1;

/// In place of a limit: its kind is not looked for.
const OFF_NAME: &str = "off";

/// For names, messages and the like: the standard library aborts if it cannot allocate them.
const ROOM: usize = 32 << 10;

/// What `parse` makes of the text of a file; all errors name it.
pub(super) fn load<T>(file: &Path, parse: impl FnOnce(&str) -> Result<T>) -> Result<T> {
    let text = read_text(file, MAX_FILE_BYTES)?;
    parse(&text).map_err(|error| error.at(file.display()))
}

/// The same of a reader, to its end, which errors call `name`.
pub(super) fn load_from<T>(
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
    let size = opened.metadata().map_err(io)?.len();
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
        field::at_line(line, Malformed::NotUtf8)
    })
}

fn too_large(most: u64) -> Error {
    Error::FileTooLarge(most >> 20)
}
