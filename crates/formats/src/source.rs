//! A file that is read, and the files next to it.

use std::path::{Path, PathBuf};

use vides_document::{inside, read_bytes};
use vides_engine::limits::MAX_FILE_BYTES;

use super::error::{Cause, Error, Place, Result};
use super::natural;

/// The content of a file, or a folder.
#[derive(Debug, Default)]
pub struct Source {
    /// As messages call it.
    pub name: String,
    /// The content; empty for a folder.
    pub bytes: Vec<u8>,
    /// Where files that it names lie, or the folder itself; none if it is no file.
    pub folder: Option<PathBuf>,
    /// Whether it is a folder.
    pub is_folder: bool,
}

impl Source {
    /// Reads a file, or names a folder.
    ///
    /// # Errors
    /// Those of the system; [`Error::Document`] if it is too large.
    pub fn open(file: &Path) -> Result<Self> {
        let name = file.display().to_string();
        if file.is_dir() {
            return Ok(Self {
                name,
                folder: Some(file.to_owned()),
                is_folder: true,
                ..Self::default()
            });
        }
        let folder = file.parent().unwrap_or(Path::new("")).to_owned();
        let bytes = read_bytes(file, MAX_FILE_BYTES).map_err(|error| error.at(&name))?;
        Ok(Self {
            name,
            bytes,
            folder: Some(folder),
            is_folder: false,
        })
    }

    /// What was read of a stream.
    #[must_use]
    pub fn of_bytes(name: &str, bytes: Vec<u8>) -> Self {
        Self {
            name: name.to_owned(),
            bytes,
            ..Self::default()
        }
    }

    /// The content as text.
    ///
    /// # Errors
    /// [`Cause::NotUtf8`] with the line.
    pub fn text(&self) -> Result<&str> {
        utf8(&self.bytes).map(without_mark)
    }

    /// The beginning as text, as far as it is some: for [`super::Format::recognises`].
    #[must_use]
    pub fn beginning(&self) -> &str {
        let start = &self.bytes[..self.bytes.len().min(4096)];
        match std::str::from_utf8(start) {
            Ok(text) => without_mark(text),
            Err(error) => {
                std::str::from_utf8(&start[..error.valid_up_to()]).map_or("", without_mark)
            }
        }
    }

    /// Where a file lies that the content names: in the folder of the file or below it.
    ///
    /// # Errors
    /// [`Cause::Outside`] for any other place; [`Cause::Missing`] without a folder.
    pub fn place_beside(&self, name: &str) -> Result<PathBuf> {
        let Some(folder) = &self.folder else {
            return Err(Place::Whole.wrong(Cause::Missing(name.into())));
        };
        if name.is_empty() || inside(folder, name).is_err() {
            return Err(Place::Whole.wrong(Cause::Outside(name.into())));
        }
        Ok(folder.join(name))
    }

    /// The content of a file that the content names, at most `most` bytes.
    ///
    /// # Errors
    /// As [`Source::place_beside`]; those of the system.
    pub fn beside(&self, name: &str, most: u64) -> Result<Vec<u8>> {
        let place = self.place_beside(name)?;
        let read = read_bytes(&place, most.min(MAX_FILE_BYTES));
        read.map_err(|error| Error::from(error.at(place.display())))
    }
}

impl Source {
    /// The names of files in the folder that `wanted` takes; numbers in them count as numbers.
    ///
    /// # Errors
    /// Those of the system.
    pub(super) fn names(&self, wanted: fn(&str) -> bool) -> Result<Vec<String>> {
        let mut names = Vec::new();
        let Some(folder) = self.folder.as_deref().filter(|_| self.is_folder) else {
            return Ok(names);
        };
        let io = |source| {
            Error::from(vides_document::Error::Io {
                place: self.name.clone(),
                source,
            })
        };
        for entry in std::fs::read_dir(folder).map_err(io)? {
            let name = entry.map_err(io)?.file_name();
            if let Some(name) = name.to_str().filter(|name| wanted(name)) {
                names.try_reserve(1)?;
                names.push(name.to_owned());
            }
        }
        names.sort_by(|a, b| natural::compare(a, b));
        Ok(names)
    }

    /// The first of these files, if it is small.
    pub(super) fn first_of(&self, wanted: fn(&str) -> bool) -> Option<Self> {
        let names = self.names(wanted).ok()?;
        let name = names.first()?;
        let bytes = self.beside(name, SMALL).ok()?;
        Some(Self::of_bytes(name, bytes))
    }

    /// The last number in a name.
    pub(super) fn number_of(name: &str) -> Option<f64> {
        let mut numbers = name.split(|c: char| !c.is_ascii_digit());
        numbers.rfind(|digits| !digits.is_empty())?.parse().ok()
    }
}

/// Bytes of a file with one pose, at most.
const SMALL: u64 = 1 << 16;

/// Some editors put a mark of the byte order before a text.
fn without_mark(text: &str) -> &str {
    text.strip_prefix('\u{feff}').unwrap_or(text)
}

/// Bytes as text.
///
/// # Errors
/// [`Cause::NotUtf8`] with the line.
pub(super) fn utf8(bytes: &[u8]) -> Result<&str> {
    std::str::from_utf8(bytes).map_err(|error| {
        let before = &bytes[..error.valid_up_to()];
        let line = 1 + before.iter().filter(|&&byte| byte == b'\n').count();
        Place::Line(line).wrong(Cause::NotUtf8)
    })
}
