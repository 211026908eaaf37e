//! The new file while it is written: without a name where the file system has such files, so that
//! nothing stays however the process ends.

use std::ffi::OsStr;
use std::fs::{self, File, OpenOptions};
use std::io;
use std::mem::MaybeUninit;
use std::os::fd::AsRawFd;
use std::os::unix::ffi::OsStrExt;
use std::os::unix::fs::{MetadataExt, OpenOptionsExt};
use std::path::{Path, PathBuf};
use std::process;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::Duration;

use rustix::fs::{AtFlags, CWD, OFlags, RawDir};
use rustix::io::Errno;
use rustix::process::geteuid;
use vides_engine::descriptor::off_standard;

/// How names of temporary files begin and end.
const PREFIX: &str = ".vides-";
const SUFFIX: &str = ".tmp";

/// A file that has not been written for so long, and is not locked, has no process any more.
const ABANDONED: Duration = Duration::from_secs(600);

/// Entries of a folder that are looked through for abandoned files.
const MAX_ENTRIES: usize = 10_000;

/// Names that are tried.
const MAX_NAMES: usize = 1000;

static NEXT: AtomicU64 = AtomicU64::new(0);

/// A new file in the folder of another, removed when dropped unless it has replaced that.
pub(super) struct Temporary {
    pub(super) file: File,
    folder: PathBuf,
    /// Its name, if it has one.
    path: Option<PathBuf>,
}

impl Temporary {
    /// Such a file that only we may read, or one with the rights of new files.
    pub(super) fn in_folder(folder: &Path, private: bool) -> io::Result<Self> {
        let mode = if private { 0o600 } else { 0o666 };
        // Some file systems have no files without a name, or there is no /proc to name them by.
        Self::nameless(folder, mode).or_else(|_| Self::named(folder, mode))
    }

    fn nameless(folder: &Path, mode: u32) -> io::Result<Self> {
        let file = OpenOptions::new()
            .write(true)
            .mode(mode)
            .custom_flags(OFlags::TMPFILE.bits().cast_signed())
            .open(folder)
            .and_then(off_standard)?;
        fs::metadata(by_descriptor(&file))?;
        Ok(Self {
            file,
            folder: folder.to_owned(),
            path: None,
        })
    }

    fn named(folder: &Path, mode: u32) -> io::Result<Self> {
        let create = |path: &Path| {
            OpenOptions::new()
                .write(true)
                .create_new(true)
                .mode(mode)
                .open(path)
                .and_then(off_standard)
        };
        let (path, file) = with_new_name(folder, create)?;
        // A file system without locks: then age alone says that it is abandoned.
        let _ = file.try_lock();
        Ok(Self {
            file,
            folder: folder.to_owned(),
            path: Some(path),
        })
    }

    /// Takes the place of `target`, in the same folder.
    pub(super) fn replace(mut self, target: &Path) -> io::Result<()> {
        let path = match self.path.take() {
            Some(path) => path,
            None => {
                let from = by_descriptor(&self.file);
                let link = |path: &Path| {
                    let follow = AtFlags::SYMLINK_FOLLOW;
                    Ok(rustix::fs::linkat(CWD, &from, CWD, path, follow)?)
                };
                with_new_name(&self.folder, link)?.0
            }
        };
        let renamed = fs::rename(&path, target);
        if renamed.is_err() {
            self.path = Some(path);
        }
        renamed
    }
}

/// A name for an open file.
fn by_descriptor(file: &File) -> PathBuf {
    format!("/proc/self/fd/{}", file.as_raw_fd()).into()
}

/// What `make` makes under a name that is not taken. It is not derived from the target's, which may
/// already have the maximum length.
fn with_new_name<T>(
    folder: &Path,
    make: impl Fn(&Path) -> io::Result<T>,
) -> io::Result<(PathBuf, T)> {
    for attempt in 0..MAX_NAMES {
        let number = NEXT.fetch_add(1, Ordering::Relaxed);
        let process = process::id();
        let path = folder.join(format!("{PREFIX}{process}-{number}-{attempt}{SUFFIX}"));
        match make(&path) {
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {}
            made => return made.map(|made| (path, made)),
        }
    }
    Err(Errno::EXIST.into())
}

impl Drop for Temporary {
    fn drop(&mut self) {
        if let Some(path) = &self.path {
            let _ = fs::remove_file(path);
        }
    }
}

/// Removes our temporary files that dead processes have left in a folder.
pub(super) fn clear(folder: &Path) {
    let Ok(opened) = File::open(folder).and_then(off_standard) else {
        return;
    };
    // The standard library's list panics where the folder cannot be closed.
    let mut buffer = [MaybeUninit::uninit(); 4096];
    let mut entries = RawDir::new(&opened, &mut buffer);
    for _ in 0..MAX_ENTRIES {
        let Some(Ok(entry)) = entries.next() else {
            return;
        };
        let name = entry.file_name().to_bytes();
        if name.starts_with(PREFIX.as_bytes()) && name.ends_with(SUFFIX.as_bytes()) {
            let _ = remove_abandoned(&folder.join(OsStr::from_bytes(name)));
        }
    }
}

fn remove_abandoned(path: &Path) -> io::Result<()> {
    let flags = OFlags::NONBLOCK | OFlags::NOFOLLOW;
    let file = OpenOptions::new()
        .read(true)
        .custom_flags(flags.bits().cast_signed())
        .open(path)
        .and_then(off_standard)?;
    let there = file.metadata()?;
    let old = there.modified()?.elapsed().is_ok_and(|age| age > ABANDONED);
    let ours = there.is_file() && there.uid() == geteuid().as_raw();
    if old && ours && file.try_lock().is_ok() {
        fs::remove_file(path)?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::time::SystemTime;

    fn names(folder: &Path) -> Vec<String> {
        let entries = fs::read_dir(folder).unwrap();
        let names = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap());
        names.collect()
    }

    #[test]
    fn a_file_system_without_nameless_files_has_named_ones() {
        let folder = tempfile::tempdir().unwrap();
        let target = folder.path().join("target");
        for private in [true, false] {
            let named = Temporary::named(folder.path(), if private { 0o600 } else { 0o666 });
            let named = named.unwrap();
            assert_eq!(names(folder.path()).len(), 1);
            assert_eq!(named.file.metadata().unwrap().mode() & 0o077 == 0, private);
            drop(named);
            assert!(names(folder.path()).is_empty());
        }
        let named = Temporary::named(folder.path(), 0o600).unwrap();
        named.replace(&target).unwrap();
        assert_eq!(names(folder.path()), ["target"]);
    }

    #[test]
    fn files_without_a_name_are_not_seen_until_they_replace() {
        let folder = tempfile::tempdir().unwrap();
        let target = folder.path().join("target");
        // Not every file system of a test has them.
        let Ok(nameless) = Temporary::nameless(folder.path(), 0o600) else {
            return;
        };
        assert!(names(folder.path()).is_empty());
        nameless.replace(&target).unwrap();
        assert_eq!(names(folder.path()), ["target"]);
        let nameless = Temporary::nameless(folder.path(), 0o600).unwrap();
        fs::create_dir(folder.path().join("in the way")).unwrap();
        assert!(nameless.replace(&folder.path().join("in the way")).is_err());
        assert_eq!(names(folder.path()).len(), 2);
    }

    #[test]
    fn only_abandoned_files_are_cleared() {
        let folder = tempfile::tempdir().unwrap();
        let long_ago = SystemTime::now() - 2 * ABANDONED;
        let make = |name: &str, age: SystemTime| {
            let file = File::create(folder.path().join(name)).unwrap();
            file.set_modified(age).unwrap();
            file
        };
        drop(make(".vides-1-2-3.tmp", long_ago));
        drop(make(".vides-4-5-6.tmp", SystemTime::now()));
        drop(make(".vides-other", long_ago));
        let held = make(".vides-7-8-9.tmp", long_ago);
        held.try_lock().unwrap();
        clear(folder.path());
        let mut left = names(folder.path());
        left.sort();
        assert_eq!(
            left,
            [".vides-4-5-6.tmp", ".vides-7-8-9.tmp", ".vides-other"]
        );
    }
}
