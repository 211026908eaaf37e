//! Work not yet saved, kept so that a crash, a kill or an X server that goes away costs at most a
//! second of it.
//!
//! One file per window, in the state folder: a `.vid` file that begins with comments on its origin.
//! It is written to a temporary file and renamed, so that replacing it is atomic, but it is not
//! synced each time: the death of a process, unlike a power cut, loses nothing that was written. It
//! is locked as long as its process lives; a file that can be locked has no process any more, and
//! is offered to the next window. A new one is locked before it takes its name, so that no other
//! process ever finds it free.
//!
//! No egui here; [`super::autosave`] joins it to the window.

use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{self, Read, Write};
use std::os::unix::ffi::{OsStrExt, OsStringExt};
use std::os::unix::fs::{MetadataExt, OpenOptionsExt};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, SystemTime, UNIX_EPOCH};

use rustix::fs::OFlags;
use rustix::process::geteuid;
use vides_document::error::{Error, Result};
use vides_document::{Document, Fingerprint, trusting};
use vides_engine::descriptor::off_standard;
use vides_engine::limits::MAX_FILE_BYTES;

use super::folders;

/// From a change to writing it. The rest of the second is for writing, 20 ms for 10,000 points.
pub(crate) const DELAY: Duration = Duration::from_millis(700);

/// How names of recovery files begin and end; those being written end in `NEW`.
const PREFIX: &str = "unsaved-";
const SUFFIX: &str = ".vid";
const NEW: &str = ".new";

const PROGRAM_MARK: &str = "# program = ";
const FILE_MARK: &str = "# file = ";
const CONTENTS_MARK: &str = "# contents = ";

/// How the lines of the header begin.
const HEADER: [&str; 6] = [
    "# Work in VIDES that was not saved.",
    "# process = ",
    "# written = ",
    PROGRAM_MARK,
    FILE_MARK,
    CONTENTS_MARK,
];

/// Where unsaved work comes from.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Origin<'a> {
    /// The program whose window it is in.
    pub(crate) program: &'a str,
    pub(crate) file: Option<&'a Path>,
    pub(crate) known: Option<Fingerprint>,
}

static NEXT: AtomicU64 = AtomicU64::new(0);

/// Keeps the unsaved work of one window.
#[derive(Debug)]
pub(crate) struct Autosave {
    folder: PathBuf,
    path: PathBuf,
    /// The file at `path`, locked.
    held: Option<File>,
    /// The state that was written or needs no writing.
    settled: u64,
    /// When the first change came that is not written yet, by the clock of the passes.
    since: Option<Duration>,
    /// Writing failed, and that was reported.
    failed: bool,
}

/// The outcome of looking after unsaved work.
#[derive(Debug)]
pub(crate) enum Saved {
    Idle,
    /// To be looked after again after this time.
    In(Duration),
    /// It could not be written; reported only once.
    Failed(Error),
}

impl Autosave {
    /// For a window that shows this document. Writes nothing yet.
    pub(crate) fn new(folder: &Path, document: &Document) -> Self {
        let started = SystemTime::now().duration_since(UNIX_EPOCH);
        let started = started.map_or(0, |since| since.as_millis());
        let number = NEXT.fetch_add(1, Ordering::Relaxed);
        let process = std::process::id();
        let name = format!("{PREFIX}{process}-{started}-{number}{SUFFIX}");
        Self {
            folder: folder.to_owned(),
            path: folder.join(name),
            held: None,
            settled: document.state_number(),
            since: None,
            failed: false,
        }
    }

    /// To be called in each pass: writes what has changed, [`DELAY`] after the first change, and
    /// removes the file when nothing is unsaved any more.
    pub(crate) fn look_after(
        &mut self,
        document: &Document,
        unsaved: bool,
        origin: &Origin<'_>,
        now: Duration,
    ) -> Saved {
        if !unsaved {
            self.forget();
            self.settled = document.state_number();
            self.since = None;
            return Saved::Idle;
        }
        if document.state_number() == self.settled {
            self.since = None;
            return Saved::Idle;
        }
        let since = *self.since.get_or_insert(now);
        let waited = now.saturating_sub(since);
        if waited < DELAY {
            return Saved::In(DELAY - waited);
        }
        match self.write(document, origin) {
            Ok(()) => Saved::Idle,
            Err(_) if self.failed => Saved::Idle,
            Err(error) => {
                self.failed = true;
                Saved::Failed(error)
            }
        }
    }

    /// Writes what is unsaved now; after an error what was written before stays.
    pub(crate) fn write(&mut self, document: &Document, origin: &Origin<'_>) -> Result<()> {
        // Even if it fails: the next change tries again.
        self.settled = document.state_number();
        self.since = None;
        let text = document.to_toml()?;
        let io = |source| Error::Io {
            place: self.folder.display().to_string(),
            source,
        };
        folders::make_ours(&self.folder).map_err(io)?;
        let written = self.replace(&header(origin), &text).map_err(io)?;
        self.held = Some(written);
        Ok(())
    }

    fn replace(&self, header: &str, text: &str) -> io::Result<File> {
        let mut new = self.path.clone().into_os_string();
        new.push(NEW);
        let new = PathBuf::from(new);
        let written = locked_new(&new)
            .and_then(|mut file| {
                file.write_all(header.as_bytes())?;
                file.write_all(text.as_bytes())?;
                Ok(file)
            })
            .and_then(|file| fs::rename(&new, &self.path).map(|()| file));
        if written.is_err() {
            let _ = fs::remove_file(&new);
        }
        written
    }

    /// Removes the file: the work is saved or discarded.
    pub(crate) fn forget(&mut self) {
        if self.held.take().is_some() {
            // If it cannot be removed it is offered at the next start: better than lost.
            let _ = fs::remove_file(&self.path);
        }
    }

    /// Whether this state is not written yet.
    pub(crate) fn is_behind(&self, document: &Document) -> bool {
        document.state_number() != self.settled
    }
}

/// A new file, locked, that only we may read. Another process that looks around may lock it for a
/// moment first, and removes it: then it is made again.
fn locked_new(path: &Path) -> io::Result<File> {
    let mut attempts = 0;
    loop {
        attempts += 1;
        // Left by a process that had our number long ago, if at all.
        match fs::remove_file(path) {
            Err(error) if error.kind() != io::ErrorKind::NotFound => return Err(error),
            _ => {}
        }
        let file = OpenOptions::new()
            .write(true)
            .create_new(true)
            .mode(0o600)
            .open(path)
            .and_then(off_standard)?;
        match file.try_lock() {
            Ok(()) if is_still(&file, path) => return Ok(file),
            // A file system without locks: better kept than locked.
            Err(TryLockError::Error(_)) => return Ok(file),
            _ if attempts < 100 => {}
            _ => return Err(io::Error::from(io::ErrorKind::WouldBlock)),
        }
    }
}

/// Whether this open file still bears the name.
fn is_still(file: &File, path: &Path) -> bool {
    match (file.metadata(), fs::symlink_metadata(path)) {
        (Ok(open), Ok(named)) => open.ino() == named.ino() && open.dev() == named.dev(),
        _ => false,
    }
}

/// The header: comments, so that the file is a `.vid` file.
fn header(origin: &Origin<'_>) -> String {
    let written = SystemTime::now().duration_since(UNIX_EPOCH);
    let written = written.map_or(0, |since| since.as_secs());
    let process = std::process::id();
    use std::fmt::Write as _;
    let mut text = format!(
        "# Work in VIDES that was not saved.\n# process = {process}\n# written = {written}\n"
    );
    if !origin.program.is_empty() {
        text.push_str(PROGRAM_MARK);
        text.push_str(&escaped(Path::new(origin.program)));
        text.push('\n');
    }
    if let Some(file) = origin.file {
        let file = std::path::absolute(file).unwrap_or_else(|_| file.to_owned());
        text.push_str(FILE_MARK);
        text.push_str(&escaped(&file));
        text.push('\n');
        if let Some(known) = origin.known {
            // Writing to a string cannot fail.
            let _ = writeln!(text, "{CONTENTS_MARK}{known}");
        }
    }
    // What follows belongs to the document, even a comment.
    text.push('\n');
    text
}

/// The document's own text, without the comments that we wrote above it.
fn without_header(text: &str) -> &str {
    let mut rest = text;
    while let Some((line, after)) = rest.split_once('\n')
        && HEADER.iter().any(|mark| line.starts_with(mark))
    {
        rest = after;
    }
    rest
}

/// A path as one line: `%` and two digits for `%` and bytes other than printable ASCII.
pub(crate) fn escaped(path: &Path) -> String {
    use std::fmt::Write;
    let mut text = String::new();
    for &byte in path.as_os_str().as_bytes() {
        if byte.is_ascii_graphic() && byte != b'%' || byte == b' ' {
            text.push(char::from(byte));
        } else {
            // Writing to a string cannot fail.
            let _ = write!(text, "%{byte:02X}");
        }
    }
    text
}

/// The path in a line of [`escaped`]; `None` if it is malformed.
pub(crate) fn unescaped(text: &str) -> Option<PathBuf> {
    let mut bytes = Vec::with_capacity(text.len());
    let mut rest = text.as_bytes();
    while let [first, after @ ..] = rest {
        rest = after;
        if *first == b'%' {
            let (digits, after) = after.split_at_checked(2)?;
            let digits = std::str::from_utf8(digits).ok()?;
            bytes.push(u8::from_str_radix(digits, 16).ok()?);
            rest = after;
        } else {
            bytes.push(*first);
        }
    }
    let plain = !bytes.is_empty() && !bytes.contains(&0);
    plain.then(|| PathBuf::from(std::ffi::OsString::from_vec(bytes)))
}

/// Unsaved work whose process is gone. We lock it: while this lives no other window gets it.
#[derive(Debug)]
pub(crate) struct Found {
    path: PathBuf,
    file: File,
    pub(crate) program: Option<String>,
    /// The file that it was a change of.
    pub(crate) original: Option<PathBuf>,
    pub(crate) known: Option<Fingerprint>,
    pub(crate) written: SystemTime,
    text: String,
}

impl Found {
    /// The document in it, unsaved as it was.
    pub(crate) fn document(&self) -> Result<Document> {
        // Names of meshes are absolute. A mesh that cannot be read is reported where it is missed.
        let text = without_header(&self.text);
        let read = trusting(|| Document::scene_from_toml(text, Path::new("")));
        let (mut document, _) = read?;
        document.mark_unsaved();
        Ok(document)
    }

    pub(crate) fn discard(self) {
        if is_still(&self.file, &self.path) {
            let _ = fs::remove_file(&self.path);
        }
    }
}

/// The unsaved work of dead processes of a program (`None`: any), newest first, where readable.
pub(crate) fn find(folder: &Path, program: Option<&str>) -> Vec<Found> {
    if !folders::ours(folder) {
        return Vec::new();
    }
    let Ok(entries) = fs::read_dir(folder) else {
        return Vec::new();
    };
    let mut found: Vec<Found> = entries
        .flatten()
        .filter_map(|entry| {
            let name = entry.file_name();
            let name = name.to_str()?;
            let path = entry.path();
            if !name.starts_with(PREFIX) {
                return None;
            }
            if name.ends_with(NEW) {
                remove_unfinished(&path);
                return None;
            }
            name.ends_with(SUFFIX).then(|| take(&path))?
        })
        .filter(|found| program.is_none() || found.program.as_deref() == program)
        .collect();
    found.sort_by_key(|found| std::cmp::Reverse(found.written));
    found
}

/// Locks and reads one file; `None` if a process has locked it.
fn take(path: &Path) -> Option<Found> {
    let mut file = OpenOptions::new()
        .read(true)
        .custom_flags((OFlags::NONBLOCK | OFlags::NOFOLLOW).bits().cast_signed())
        .open(path)
        .and_then(off_standard)
        .ok()?;
    let metadata = file.metadata().ok()?;
    let ours = metadata.is_file() && metadata.uid() == geteuid().as_raw();
    if !ours || metadata.len() > MAX_FILE_BYTES {
        return None;
    }
    file.try_lock().ok()?;
    // Replaced after we opened it: its process lives.
    if !is_still(&file, path) {
        return None;
    }
    let mut text = String::new();
    (&mut file)
        .take(MAX_FILE_BYTES)
        .read_to_string(&mut text)
        .ok()?;
    let said = |mark| {
        let mut head = text.lines().take_while(|line| line.starts_with('#'));
        head.find_map(|line| line.strip_prefix(mark))
    };
    let program = said(PROGRAM_MARK).and_then(unescaped);
    let original = said(FILE_MARK).and_then(unescaped);
    Some(Found {
        program: program.and_then(|name| name.into_os_string().into_string().ok()),
        known: said(CONTENTS_MARK)
            .filter(|_| original.is_some())
            .and_then(|known| known.parse().ok()),
        original,
        written: metadata.modified().unwrap_or(UNIX_EPOCH),
        path: path.to_owned(),
        file,
        text,
    })
}

/// Removes a file whose process died while writing it: the one before is whole.
fn remove_unfinished(path: &Path) {
    let Ok(file) = OpenOptions::new()
        .read(true)
        .custom_flags((OFlags::NONBLOCK | OFlags::NOFOLLOW).bits().cast_signed())
        .open(path)
        .and_then(off_standard)
    else {
        return;
    };
    if file.try_lock().is_ok() && is_still(&file, path) {
        let _ = fs::remove_file(path);
    }
}

#[cfg(test)]
#[path = "recovery_tests.rs"]
mod tests;
