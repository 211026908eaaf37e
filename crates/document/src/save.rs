//! Atomic, durable saving: write beside the file, sync, rename over it, sync the folder.

mod access;
mod temporary;

use std::fs::{self, File, OpenOptions};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use rustix::io::Errno;

use vides_engine::descriptor::off_standard;

use self::access::{destination, folder_of};
use self::temporary::Temporary;
use super::{Fingerprint, NotAFile, inputs};
use crate::error::{Error, Result, can_allocate};

const BUFFER: usize = 32 << 10;

/// For the buffer, names and messages: the standard library aborts if it cannot allocate them.
/// Small enough that the allocator keeps the room at hand when it is freed.
const ROOM: usize = BUFFER + (32 << 10);

/// Saves bytes as [`save_with`] does.
///
/// # Errors
/// As [`save_with`].
pub fn save(file: &Path, bytes: &[u8]) -> Result<()> {
    save_with(file, &mut |out| {
        out.write_all(bytes).map_err(|error| failed(file, error))
    })
}

/// As [`save`], but does nothing and returns false if the file exists and is not as `known` just
/// before it would be replaced.
///
/// # Errors
/// As [`save_with`].
pub fn save_unless_changed(file: &Path, bytes: &[u8], known: Option<Fingerprint>) -> Result<bool> {
    let as_known = |target: &Path| match Fingerprint::now(target) {
        Ok(now) => now.is_none() || now == known,
        // An unreadable file cannot be known to be unchanged.
        Err(_) => false,
    };
    replace(
        file,
        &mut |out| out.write_all(bytes).map_err(|error| failed(file, error)),
        &as_known,
    )
}

/// Saves what `write` writes. Of a symbolic link the target is replaced, unless another user has put
/// it into a folder like `/tmp`. Mode and access control list stay, owner and group where the system
/// lets us give them; other hard links keep the old file. Until it replaces the old file, the new
/// one is readable by its owner only.
///
/// # Errors
/// `ErrorKind::Io` naming the file, or the error of `write`. The old file is whole then, and
/// no temporary file is left.
pub fn save_with(file: &Path, write: &mut dyn FnMut(&mut dyn Write) -> Result<()>) -> Result<()> {
    replace(file, write, &|_| true).map(drop)
}

/// As [`save_with`], of several files: none is replaced before all are written. `write` gets the
/// number of the file, from 0.
///
/// # Errors
/// As [`save_with`]; of a system that fails while they are replaced some may be new.
pub fn save_all(
    files: &[PathBuf],
    write: &mut dyn FnMut(usize, &mut dyn Write) -> Result<()>,
) -> Result<()> {
    let mut written = Vec::new();
    for (number, file) in files.iter().enumerate() {
        written.push(Written::new(file, &mut |out| write(number, out))?);
    }
    written.into_iter().try_for_each(Written::replace)
}

/// [`save_with`] if `may` agrees just before the rename; returns whether it did.
fn replace(
    file: &Path,
    write: &mut dyn FnMut(&mut dyn Write) -> Result<()>,
    may: &dyn Fn(&Path) -> bool,
) -> Result<bool> {
    let written = Written::new(file, write)?;
    if !may(&written.target) {
        return Ok(false);
    }
    written.replace().map(|()| true)
}

/// A new file beside the one that it will replace, whole and on the disk.
struct Written<'a> {
    file: &'a Path,
    target: PathBuf,
    temporary: Temporary,
}

impl<'a> Written<'a> {
    fn new(file: &'a Path, write: &mut dyn FnMut(&mut dyn Write) -> Result<()>) -> Result<Self> {
        can_allocate(ROOM)?;
        let io = |error| failed(file, error);
        let target = destination(file).map_err(io)?;
        let old = old(&target).map_err(io)?;
        if target.file_name().is_none() {
            return Err(io(Errno::ISDIR.into()));
        }
        if let Some(old) = &old {
            let there = old.metadata().map_err(io)?;
            inputs::refuse(&there).map_err(|error| error.at(file.display()))?;
        }
        let temporary = Temporary::in_folder(folder_of(&target), old.is_some()).map_err(io)?;
        let mut out = BufWriter::with_capacity(BUFFER, &temporary.file);
        write(&mut out).map_err(|error| match error {
            Error::Io { source, .. } => io(source),
            other => other,
        })?;
        out.flush().map_err(io)?;
        drop(out);
        if let Some(old) = old {
            access::keep(&temporary.file, &old).map_err(io)?;
        }
        temporary.file.sync_all().map_err(io)?;
        Ok(Self {
            file,
            target,
            temporary,
        })
    }

    fn replace(self) -> Result<()> {
        let io = |error| failed(self.file, error);
        self.temporary.replace(&self.target).map_err(io)?;
        let folder = folder_of(&self.target);
        temporary::clear(folder);
        // Else a power cut could bring the old file back. Some file systems cannot sync a folder.
        match File::open(folder)
            .and_then(off_standard)
            .and_then(|folder| folder.sync_all())
        {
            Err(error) if !unsupported(&error) => Err(io(error)),
            _ => Ok(()),
        }
    }
}

/// The file that will be replaced, if there is one. Renaming needs only the folder to be writable;
/// the file must be, too.
fn old(target: &Path) -> io::Result<Option<File>> {
    match fs::metadata(target) {
        Ok(metadata) => NotAFile::refuse(&metadata)?,
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(None),
        Err(error) => return Err(error),
    }
    let opened = OpenOptions::new().write(true).open(target);
    opened.and_then(off_standard).map(Some)
}

fn failed(file: &Path, source: io::Error) -> Error {
    Error::Io {
        place: file.display().to_string(),
        source,
    }
}

fn unsupported(error: &io::Error) -> bool {
    matches!(
        Errno::from_io_error(error),
        Some(Errno::INVAL | Errno::NOTSUP | Errno::ACCESS)
    )
}
