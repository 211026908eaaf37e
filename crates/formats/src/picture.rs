//! How large the picture in a file is: the headers of PNG and JPEG.

use std::fs::File;
use std::io::Read;

use super::source::Source;

/// Headers longer than this are not searched.
const MAX_HEADER: u64 = 1 << 20;

/// The endings that files have whose names lack one.
const ENDINGS: [&str; 4] = ["", ".png", ".jpg", ".jpeg"];

/// Width and height of a picture that a file names, if it lies beside it and says so.
pub(super) fn size_beside(source: &Source, name: &str) -> Option<[f64; 2]> {
    ENDINGS.iter().find_map(|ending| {
        let file = source.place_beside(&format!("{name}{ending}")).ok()?;
        // A pipe would block.
        let file = file.is_file().then(|| File::open(file))?.ok()?;
        let mut header = Vec::new();
        file.take(MAX_HEADER).read_to_end(&mut header).ok()?;
        let size = png(&header).or_else(|| jpeg(&header))?;
        size.iter()
            .all(|&side| side > 0)
            .then(|| size.map(f64::from))
    })
}

fn png(bytes: &[u8]) -> Option<[u32; 2]> {
    let rest = bytes.strip_prefix(b"\x89PNG\r\n\x1a\n")?;
    let (width, rest) = rest.get(8..)?.split_first_chunk()?;
    let (height, _) = rest.split_first_chunk()?;
    Some([*width, *height].map(u32::from_be_bytes))
}

fn jpeg(bytes: &[u8]) -> Option<[u32; 2]> {
    let mut rest = bytes.strip_prefix(b"\xff\xd8")?;
    loop {
        let (&mark, behind) = rest.strip_prefix(b"\xff")?.split_first()?;
        // Any number of bytes 0xff may come before the mark.
        if mark == 0xff {
            rest = &rest[1..];
            continue;
        }
        let (length, _) = behind.split_first_chunk()?;
        let length = usize::from(u16::from_be_bytes(*length));
        let is_frame = (0xc0..=0xcf).contains(&mark) && ![0xc4, 0xc8, 0xcc].contains(&mark);
        if is_frame {
            let (&[a, b, c, d], _) = behind.get(3..)?.split_first_chunk()?;
            return Some([u16::from_be_bytes([c, d]), u16::from_be_bytes([a, b])].map(u32::from));
        }
        // What is shorter than its own length would be read again and again.
        rest = behind.get(length.max(2)..)?;
    }
}
