//! Paths that lead to something other than a regular file.

use std::fmt;
use std::fs::{File, Metadata, OpenOptions};
use std::io;
use std::os::unix::fs::OpenOptionsExt;
use std::path::Path;

use rustix::fs::OFlags;
use vides_engine::descriptor::off_standard;

/// What a path leads to instead of a regular file; can be recognised within an [`io::Error`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NotAFile {
    /// A directory.
    Directory,
    /// A pipe, a device, a socket.
    Special,
}

/// Opens a regular file for reading.
pub(super) fn open(file: &Path) -> io::Result<File> {
    // Without O_NONBLOCK, opening a pipe without a writer would block forever.
    let opened = OpenOptions::new()
        .read(true)
        .custom_flags((OFlags::NONBLOCK | OFlags::NOCTTY).bits().cast_signed())
        .open(file)
        .and_then(off_standard)?;
    NotAFile::refuse(&opened.metadata()?)?;
    Ok(opened)
}

impl NotAFile {
    pub(super) fn refuse(metadata: &Metadata) -> io::Result<()> {
        let what = if metadata.is_file() {
            return Ok(());
        } else if metadata.is_dir() {
            Self::Directory
        } else {
            Self::Special
        };
        Err(io::Error::other(what))
    }

    /// The cause of an error, if it comes from here.
    pub fn of(error: &io::Error) -> Option<Self> {
        error.get_ref()?.downcast_ref().copied()
    }
}

impl fmt::Display for NotAFile {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(match self {
            Self::Directory => "this is a directory, not a file",
            Self::Special => "this is not a regular file",
        })
    }
}

impl std::error::Error for NotAFile {}
