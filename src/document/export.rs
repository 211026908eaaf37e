//! Poses in the formats of the command.

use std::io::Write;
use std::path::Path;

use super::editing::Document;
use crate::error::Result;

/// How poses are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Format {
    /// Ten numbers a line, four decimals (thesis B.2.3).
    #[default]
    Ascii,
    /// Comma-separated, a header row, every digit.
    Csv,
    /// An object with meta data and poses, every digit.
    Json,
}

/// What is written and how.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Options {
    /// The format.
    pub format: Format,
    /// Positions in the user's world instead of the movement space.
    pub world: bool,
}

/// Called now and then with the number of poses written and that of all.
pub type Progress<'a> = &'a mut dyn FnMut(usize, usize);

/// Writes all poses of a document.
pub fn write(
    _document: &Document,
    _options: Options,
    _out: &mut dyn Write,
    _progress: Progress,
) -> Result<()> {
    unimplemented!()
}

/// The same into a file, atomically.
pub fn write_file(
    _document: &Document,
    _options: Options,
    _file: &Path,
    _progress: Progress,
) -> Result<()> {
    unimplemented!()
}
