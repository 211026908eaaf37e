//! Atomic, durable saving: write beside the file, sync, rename over it, sync the folder.

use std::fs::{self, File, OpenOptions, Permissions};
use std::io::{self, BufWriter, Write};
use std::os::unix::fs::{MetadataExt, OpenOptionsExt, PermissionsExt};
use std::path::{Path, PathBuf};

use super::{Fingerprint, NotAFile};
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

/// Saves what `write` writes. Of a symbolic link the target is replaced; permissions stay.
///
/// # Errors
/// `ErrorKind::Io` naming the file, or the error of `write`. The old file is whole then, and
/// nothing is left beside it.
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
        let old = match fs::metadata(&target) {
            Ok(metadata) => {
                NotAFile::refuse(&metadata).map_err(io)?;
                Some(metadata)
            }
            Err(error) if error.kind() == io::ErrorKind::NotFound => None,
            Err(error) => return Err(io(error)),
        };
        // Renaming needs only the folder to be writable; require the file to be, too.
        if old.is_some() {
            OpenOptions::new().write(true).open(&target).map_err(io)?;
        }
        let temporary = Temporary::beside(&target, folder_of(&target)).map_err(io)?;
        let mut out = BufWriter::with_capacity(BUFFER, &temporary.file);
        write(&mut out).map_err(|error| match error {
            Error::Io { source, .. } => io(source),
            other => other,
        })?;
        out.flush().map_err(io)?;
        drop(out);
        if let Some(old) = old {
            // The group first: changing it may clear permission bits.
            let _ = std::os::unix::fs::fchown(&temporary.file, None, Some(old.gid()));
            let permissions = Permissions::from_mode(old.mode() & 0o7777);
            temporary.file.set_permissions(permissions).map_err(io)?;
        }
        temporary.file.sync_all().map_err(io)?;
        Ok(Self {
            file,
            target,
            temporary,
        })
    }

    fn replace(mut self) -> Result<()> {
        let io = |error| failed(self.file, error);
        fs::rename(&self.temporary.path, &self.target).map_err(io)?;
        self.temporary.renamed = true;
        let folder = folder_of(&self.target);
        // Else a power cut could bring the old file back. Some file systems cannot sync a folder.
        match File::open(folder).and_then(|folder| folder.sync_all()) {
            Err(error) if !unsupported(&error) => Err(io(error)),
            _ => Ok(()),
        }
    }
}

/// The folder that a file is in.
fn folder_of(file: &Path) -> &Path {
    match file.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    }
}

fn failed(file: &Path, source: io::Error) -> Error {
    Error::Io {
        place: file.display().to_string(),
        source,
    }
}

fn unsupported(error: &io::Error) -> bool {
    matches!(
        error.raw_os_error(),
        Some(libc::EINVAL | libc::ENOTSUP | libc::EACCES)
    )
}

/// As many symbolic links as Linux itself follows.
const MAX_LINKS: usize = 40;

/// The file to replace: the end of the chain of symbolic links, even if missing.
fn destination(file: &Path) -> io::Result<PathBuf> {
    let mut file = file.to_path_buf();
    if file.as_os_str().is_empty() {
        return Err(io::Error::from_raw_os_error(libc::ENOENT));
    }
    for _ in 0..MAX_LINKS {
        match fs::symlink_metadata(&file) {
            Ok(metadata) if metadata.file_type().is_symlink() => {
                let link = fs::read_link(&file)?;
                // Absolute links replace the whole path, relative ones the name.
                file.pop();
                file.push(link);
            }
            _ => return Ok(file),
        }
    }
    Err(io::Error::from_raw_os_error(libc::ELOOP))
}

/// A new file beside another, removed when dropped unless renamed.
struct Temporary {
    path: PathBuf,
    file: File,
    renamed: bool,
}

impl Temporary {
    fn beside(target: &Path, folder: &Path) -> io::Result<Self> {
        if target.file_name().is_none() {
            return Err(io::Error::from_raw_os_error(libc::EISDIR));
        }
        for attempt in 0..1000 {
            let number = NEXT.fetch_add(1, std::sync::atomic::Ordering::Relaxed);
            // Not derived from the target's name, which may already have the maximum length.
            let path = folder.join(format!(
                ".vides-{}-{number}-{attempt}.tmp",
                std::process::id()
            ));
            match OpenOptions::new()
                .write(true)
                .create_new(true)
                .mode(0o666)
                .open(&path)
            {
                Ok(file) => {
                    return Ok(Self {
                        path,
                        file,
                        renamed: false,
                    });
                }
                Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {}
                Err(error) => return Err(error),
            }
        }
        Err(io::Error::from(io::ErrorKind::AlreadyExists))
    }
}

static NEXT: std::sync::atomic::AtomicU64 = std::sync::atomic::AtomicU64::new(0);

impl Drop for Temporary {
    fn drop(&mut self) {
        if !self.renamed {
            let _ = fs::remove_file(&self.path);
        }
    }
}
