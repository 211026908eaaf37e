//! The user's authority file, which holds the X servers' cookies (Xsecurity(7)).
//!
//! `XAUTHORITY` may name anything: a pipe, a device, a file on a server that does not respond. So a
//! separate thread reads it until the deadline, only if it is a regular file, and only its
//! beginning.

use std::fs::OpenOptions;
use std::io::{ErrorKind, Read as _, Result};
use std::os::unix::fs::OpenOptionsExt as _;
use std::path::{Path, PathBuf};
use std::time::Instant;

use vides_engine::descriptor::off_standard;
use x11rb::reexports::x11rb_protocol::xauth::Family;

use super::connect::in_time;

/// The bytes of an authority file that are read: some ten thousand entries.
const MAX_BYTES: u64 = 1 << 20;

const COOKIE: &[u8] = b"MIT-MAGIC-COOKIE-1";

/// The authorization name and data for this display; empty if it is missing or time runs out.
pub(super) fn authority(
    (family, address): (Family, &[u8]),
    display: u16,
    deadline: Instant,
) -> (Vec<u8>, Vec<u8>) {
    let read = file().and_then(|file| in_time(deadline, move || read(&file)).ok());
    let bytes = read.unwrap_or_default();
    let data = find(&bytes, (family, address), display.to_string().as_bytes());
    data.map(|data| (COOKIE.to_vec(), data.to_vec()))
        .unwrap_or_default()
}

fn file() -> Option<PathBuf> {
    if let Some(name) = std::env::var_os("XAUTHORITY") {
        return Some(name.into());
    }
    Some(Path::new(&std::env::var_os("HOME")?).join(".Xauthority"))
}

fn read(file: &Path) -> Result<Vec<u8>> {
    // Without O_NONBLOCK, opening a pipe without a writer would block forever.
    let opened = OpenOptions::new()
        .read(true)
        .custom_flags(libc::O_NONBLOCK | libc::O_NOCTTY)
        .open(file)?;
    let opened = off_standard(opened)?;
    if !opened.metadata()?.is_file() {
        return Err(ErrorKind::InvalidInput.into());
    }
    let mut bytes = Vec::new();
    opened.take(MAX_BYTES).read_to_end(&mut bytes)?;
    Ok(bytes)
}

/// The cookie of the first entry for this peer and display.
fn find<'a>(
    mut bytes: &'a [u8],
    (family, address): (Family, &[u8]),
    display: &[u8],
) -> Option<&'a [u8]> {
    loop {
        let of = Family::from(short(&mut bytes)?);
        let mut text = || {
            let length = usize::from(short(&mut bytes)?);
            let (text, rest) = bytes.split_at_checked(length)?;
            bytes = rest;
            Some(text)
        };
        let (entry, number, name, data) = (text()?, text()?, text()?, text()?);
        let meant = [of, family].contains(&Family::WILD) || (of, entry) == (family, address);
        if meant && (number.is_empty() || number == display) && name == COOKIE {
            return Some(data);
        }
    }
}

fn short(bytes: &mut &[u8]) -> Option<u16> {
    let (first, rest) = bytes.split_first_chunk()?;
    *bytes = rest;
    Some(u16::from_be_bytes(*first))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn entry(family: u16, address: &[u8], number: &[u8], name: &[u8], data: &[u8]) -> Vec<u8> {
        let mut entry = family.to_be_bytes().to_vec();
        for text in [address, number, name, data] {
            entry.extend(u16::try_from(text.len()).unwrap().to_be_bytes());
            entry.extend(text);
        }
        entry
    }

    #[test]
    fn the_first_cookie_of_the_peer_and_display_is_found_in_a_whole_file_only() {
        let file = [
            entry(256, b"other", b"7", COOKIE, b"a"),
            entry(0, b"host", b"7", COOKIE, b"b"),
            entry(256, b"host", b"8", COOKIE, b"c"),
            entry(256, b"host", b"7", b"XDM-AUTHORIZATION-1", b"d"),
            entry(256, b"host", b"7", COOKIE, b"e"),
            entry(65535, b"", b"", COOKIE, b"f"),
        ]
        .concat();
        let find =
            |bytes, family: u16, address, display| find(bytes, (family.into(), address), display);
        assert_eq!(find(&file, 256, b"host", b"7"), Some(&b"e"[..]));
        assert_eq!(find(&file, 256, b"host", b"8"), Some(&b"c"[..]));
        assert_eq!(find(&file, 0, b"host", b"7"), Some(&b"b"[..]));
        assert_eq!(find(&file, 6, b"host", b"7"), Some(&b"f"[..]));
        for end in 0..file.len() {
            let found = find(&file[..end], 6, b"host", b"7");
            assert_eq!(found, None, "cut after {end} bytes");
        }
    }

    #[test]
    fn only_the_beginning_of_a_regular_file_is_read() {
        let folder = tempfile::tempdir().unwrap();
        let pipe = folder.path().join("pipe");
        let made = std::process::Command::new("mkfifo").arg(&pipe).status();
        assert!(made.unwrap().success());
        for file in [
            &pipe,
            Path::new("/dev/zero"),
            Path::new("/dev/null"),
            folder.path(),
        ] {
            assert!(read(file).is_err(), "{}", file.display());
        }
        let long = folder.path().join("long");
        let file = std::fs::File::create(&long).unwrap();
        file.set_len(1 << 40).unwrap();
        assert_eq!(read(&long).unwrap().len() as u64, MAX_BYTES);
    }
}
