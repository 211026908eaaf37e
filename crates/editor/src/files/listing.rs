//! The contents of a directory, read in pieces so that a large one does not hold up the window.
//! Names of any bytes are kept as they are.

use std::ffi::OsStr;
use std::io;
use std::os::unix::ffi::OsStrExt;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use crate::files::readable;
use crate::state::files::{Folder, Item};

/// Entries kept of one directory: more than anybody looks through.
pub(crate) const MAX_ENTRIES: usize = 20_000;

/// Time that one pass may spend reading.
const SLICE: Duration = Duration::from_millis(4);

/// Entries between two looks at the clock.
const BETWEEN: usize = 32;

impl Folder {
    pub(crate) fn open(path: PathBuf) -> io::Result<Self> {
        let reading = std::fs::read_dir(&path)?;
        Ok(Self {
            path,
            items: Vec::new(),
            reading: Some(reading),
            more: false,
        })
    }

    /// One with nothing in it, where a directory cannot be read.
    pub(crate) fn empty(path: PathBuf) -> Self {
        Self {
            path,
            items: Vec::new(),
            reading: None,
            more: false,
        }
    }

    pub(crate) fn is_reading(&self) -> bool {
        self.reading.is_some()
    }

    /// Reads on for a short while.
    pub(crate) fn read_on(&mut self) {
        let Some(reading) = &mut self.reading else {
            return;
        };
        let until = Instant::now() + SLICE;
        let mut ended = false;
        'reading: while Instant::now() < until {
            for _ in 0..BETWEEN {
                match reading.next() {
                    None => {
                        ended = true;
                        break 'reading;
                    }
                    Some(_) if self.items.len() == MAX_ENTRIES => {
                        self.more = true;
                        ended = true;
                        break 'reading;
                    }
                    Some(Ok(entry)) => {
                        let name = entry.file_name();
                        let about = entry.metadata().ok();
                        self.items.push(Item {
                            shown: readable(&name),
                            is_folder: is_folder(&entry),
                            written: about.as_ref().and_then(|about| about.modified().ok()),
                            size: about.map_or(0, |about| about.len()),
                            name,
                        });
                    }
                    // It vanished meanwhile, or cannot be looked at.
                    Some(Err(_)) => {}
                }
            }
        }
        if ended {
            self.reading = None;
        }
        self.items.sort_by(|a, b| {
            let key = |item: &Item| {
                (
                    !item.is_folder,
                    item.shown.to_lowercase(),
                    item.name.clone(),
                )
            };
            key(a).cmp(&key(b))
        });
    }

    pub(crate) fn above(&self) -> Option<&Path> {
        self.path.parent()
    }
}

/// A link to a directory counts as one.
fn is_folder(entry: &std::fs::DirEntry) -> bool {
    match entry.file_type() {
        Ok(kind) if kind.is_symlink() => entry.path().is_dir(),
        Ok(kind) => kind.is_dir(),
        Err(_) => false,
    }
}

pub(crate) fn is_hidden(name: &OsStr) -> bool {
    name.as_bytes().first() == Some(&b'.')
}

/// Whether a name fits one of the patterns, which spaces, semicolons or commas separate: `*` for
/// any characters, `?` for one. Without patterns all names fit.
pub(crate) fn fits(name: &str, patterns: &str) -> bool {
    let mut all = patterns
        .split([' ', ';', ','])
        .filter(|one| !one.is_empty())
        .peekable();
    if all.peek().is_none() {
        return true;
    }
    let name: Vec<char> = name.to_lowercase().chars().collect();
    all.any(|pattern| {
        let pattern: Vec<char> = pattern.to_lowercase().chars().collect();
        fits_one(&name, &pattern)
    })
}

/// On a mismatch goes back to the last star, which takes one character more.
fn fits_one(name: &[char], pattern: &[char]) -> bool {
    let (mut n, mut p) = (0, 0);
    let mut star: Option<(usize, usize)> = None;
    while n < name.len() {
        match pattern.get(p) {
            Some('*') => {
                star = Some((p, n));
                p += 1;
            }
            Some(&letter) if letter == '?' || letter == name[n] => {
                n += 1;
                p += 1;
            }
            _ => match star {
                Some((at, from)) => {
                    star = Some((at, from + 1));
                    p = at + 1;
                    n = from + 1;
                }
                None => return false,
            },
        }
    }
    pattern[p..].iter().all(|&letter| letter == '*')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn patterns_fit_what_they_say() {
        for (name, pattern) in [
            ("a.vid", "*.vid"),
            ("A.VID", "*.vid"),
            ("a.vid", ""),
            ("a.vid", "*"),
            ("a.vid", "?.v?d"),
            ("a.txt", "*.vid *.txt"),
            ("a.txt", "*.vid;*.txt"),
            ("abcabd", "*abd"),
            ("größe.vid", "gr??e.*"),
        ] {
            assert!(fits(name, pattern), "{name} {pattern}");
        }
        for (name, pattern) in [
            ("a.vid", "*.txt"),
            ("a.vid.bak", "*.vid"),
            ("", "?"),
            ("ab", "?"),
            ("abcabc", "*abd"),
        ] {
            assert!(!fits(name, pattern), "{name} {pattern}");
        }
        // Many stars do not take for ever.
        assert!(!fits(&"a".repeat(200), &format!("{}b", "*a".repeat(50))));
    }

    #[test]
    fn a_directory_is_read_with_odd_names_in_it() {
        let folder = tempfile::tempdir().expect("a folder");
        let odd = OsStr::from_bytes(b"odd\xff\xfe.vid");
        for name in [
            odd,
            OsStr::new("b.vid"),
            OsStr::new("A.vid"),
            OsStr::new(".hidden"),
        ] {
            std::fs::write(folder.path().join(name), "").expect("a file");
        }
        std::fs::create_dir(folder.path().join("z")).expect("a folder");
        std::os::unix::fs::symlink("z", folder.path().join("link")).expect("a link");
        std::os::unix::fs::symlink("nowhere", folder.path().join("lost")).expect("a link");
        let mut read = Folder::open(folder.path().to_owned()).expect("can be read");
        while read.is_reading() {
            read.read_on();
        }
        let names: Vec<&str> = read.items.iter().map(|item| item.shown.as_str()).collect();
        assert_eq!(
            names,
            [
                "link",
                "z",
                ".hidden",
                "A.vid",
                "b.vid",
                "lost",
                "odd??.vid"
            ]
        );
        assert!(read.items.iter().any(|item| item.name == odd));
        assert!(is_hidden(OsStr::new(".hidden")) && !is_hidden(odd));
    }
}
