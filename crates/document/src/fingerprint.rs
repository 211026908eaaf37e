//! A fingerprint of a file as last read or written, so that changes made meanwhile are noticed. Of
//! its bytes, since dates fail on coarse clocks and on files only touched or changed back.

use std::io::{self, Read};
use std::path::Path;

use super::not_a_file::open;

/// Length and 64-bit FNV-1a of some bytes, the same in every version: detects changes, not
/// tampering.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Fingerprint {
    pub(super) bytes: u64,
    pub(super) hash: u64,
}

impl Fingerprint {
    /// Of these bytes.
    #[must_use]
    pub fn of(bytes: &[u8]) -> Self {
        let mut all = Self::default();
        all.add(bytes);
        all
    }

    /// Of a file as it is now; none if there is no such file.
    ///
    /// # Errors
    /// It cannot be read.
    pub fn now(file: &Path) -> io::Result<Option<Self>> {
        let mut file = match open(file) {
            Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(None),
            opened => opened?,
        };
        let mut all = Self::default();
        let mut some = [0; 16 << 10];
        loop {
            match file.read(&mut some) {
                Ok(0) => return Ok(Some(all)),
                Ok(count) => all.add(&some[..count]),
                Err(error) if error.kind() == io::ErrorKind::Interrupted => {}
                Err(error) => return Err(error),
            }
        }
    }

    fn add(&mut self, bytes: &[u8]) {
        self.bytes += bytes.len() as u64;
        for &byte in bytes {
            self.hash = (self.hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3);
        }
    }
}

/// Of no bytes.
impl Default for Fingerprint {
    fn default() -> Self {
        Self {
            bytes: 0,
            hash: 0xcbf2_9ce4_8422_2325,
        }
    }
}

/// A line of text that [`FromStr`](std::str::FromStr) reads.
impl std::fmt::Display for Fingerprint {
    fn fmt(&self, out: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(out, "{} {:016x}", self.bytes, self.hash)
    }
}

impl std::str::FromStr for Fingerprint {
    type Err = ();

    fn from_str(text: &str) -> Result<Self, ()> {
        let (bytes, hash) = text.split_once(' ').ok_or(())?;
        Ok(Self {
            bytes: bytes.parse().map_err(|_| ())?,
            hash: u64::from_str_radix(hash, 16).map_err(|_| ())?,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Recovery files outlive the program that wrote them.
    #[test]
    fn they_are_the_same_in_every_version() {
        assert_eq!(Fingerprint::of(b"").to_string(), "0 cbf29ce484222325");
        assert_eq!(Fingerprint::of(b"foobar").to_string(), "6 85944171f73967e8");
    }

    #[test]
    fn they_are_told_by_their_bytes_however_they_are_read() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("a");
        assert_eq!(Fingerprint::now(&file).unwrap(), None);
        for size in [0, 1, 16 << 10, 100_001] {
            let bytes: Vec<u8> = (0..size).map(|at| (at % 251) as u8).collect();
            std::fs::write(&file, &bytes).unwrap();
            let now = Fingerprint::now(&file).unwrap().unwrap();
            assert_eq!(now, Fingerprint::of(&bytes));
            assert_eq!(now.to_string().parse(), Ok(now));
            if size > 0 {
                let mut other = bytes;
                other[size / 2] ^= 1;
                assert_ne!(now, Fingerprint::of(&other));
            }
        }
        assert!(Fingerprint::now(folder.path()).is_err());
        assert!("".parse::<Fingerprint>().is_err() && "1 x".parse::<Fingerprint>().is_err());
    }
}
