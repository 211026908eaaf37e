//! A fingerprint of a file as last read or written, so that changes made meanwhile are noticed. Of
//! its bytes, since dates fail on coarse clocks and on files only touched or changed back.

use std::fs::OpenOptions;
use std::hash::{DefaultHasher, Hasher};
use std::io::{self, Read};
use std::os::unix::fs::OpenOptionsExt;
use std::path::Path;

/// Length and 64-bit hash of a file's contents.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Contents {
    bytes: u64,
    hash: u64,
}

impl Contents {
    /// Of these bytes.
    #[must_use]
    pub fn of(bytes: &[u8]) -> Self {
        let mut all = Summing::default();
        all.add(bytes);
        all.done()
    }

    /// Of a file as it is now; none if there is no such file.
    ///
    /// # Errors
    /// It cannot be read.
    pub fn now(file: &Path) -> io::Result<Option<Self>> {
        // Without O_NONBLOCK, opening a pipe without a writer would block forever.
        let opened = OpenOptions::new()
            .read(true)
            .custom_flags(libc::O_NONBLOCK | libc::O_NOCTTY)
            .open(file);
        let mut file = match opened {
            Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(None),
            opened => opened?,
        };
        super::NotAFile::refuse(&file.metadata()?)?;
        let mut all = Summing::default();
        let mut some = [0; 16 << 10];
        loop {
            match file.read(&mut some) {
                Ok(0) => return Ok(Some(all.done())),
                Ok(count) => all.add(&some[..count]),
                Err(error) if error.kind() == io::ErrorKind::Interrupted => {}
                Err(error) => return Err(error),
            }
        }
    }
}

/// A line of text that [`FromStr`](std::str::FromStr) reads.
impl std::fmt::Display for Contents {
    fn fmt(&self, out: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(out, "{} {:016x}", self.bytes, self.hash)
    }
}

impl std::str::FromStr for Contents {
    type Err = ();

    fn from_str(text: &str) -> Result<Self, ()> {
        let (bytes, hash) = text.split_once(' ').ok_or(())?;
        Ok(Self {
            bytes: bytes.parse().map_err(|_| ())?,
            hash: u64::from_str_radix(hash, 16).map_err(|_| ())?,
        })
    }
}

#[derive(Default)]
struct Summing {
    bytes: u64,
    hash: DefaultHasher,
}

impl Summing {
    fn add(&mut self, bytes: &[u8]) {
        self.bytes += bytes.len() as u64;
        self.hash.write(bytes);
    }

    fn done(self) -> Contents {
        Contents {
            bytes: self.bytes,
            hash: self.hash.finish(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn they_are_told_by_their_bytes_however_they_are_read() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("a");
        assert_eq!(Contents::now(&file).unwrap(), None);
        for size in [0, 1, 16 << 10, 100_001] {
            let bytes: Vec<u8> = (0..size).map(|at| (at % 251) as u8).collect();
            std::fs::write(&file, &bytes).unwrap();
            let now = Contents::now(&file).unwrap().unwrap();
            assert_eq!(now, Contents::of(&bytes));
            assert_eq!(now.to_string().parse(), Ok(now));
            if size > 0 {
                let mut other = bytes;
                other[size / 2] ^= 1;
                assert_ne!(now, Contents::of(&other));
            }
        }
        assert!(Contents::now(folder.path()).is_err());
        assert!("".parse::<Contents>().is_err() && "1 x".parse::<Contents>().is_err());
    }
}
