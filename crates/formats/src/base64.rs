//! Bytes as text (RFC 4648, section 4), piece by piece.

use std::io::{self, Write};

const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// Bytes of [`write()`] at a time, three a group.
const BLOCK: usize = 3 << 10;

/// What is left of the last piece: three bytes make four digits.
#[derive(Default)]
pub(super) struct Base64 {
    held: [u8; 3],
    count: usize,
}

impl Base64 {
    /// Appends the digits of all whole groups of three bytes.
    pub(super) fn push(&mut self, bytes: &[u8], text: &mut Vec<u8>) {
        for &byte in bytes {
            self.held[self.count] = byte;
            self.count += 1;
            if self.count == 3 {
                text.extend(group(self.held));
                self.count = 0;
            }
        }
    }

    pub(super) fn push_floats(&mut self, numbers: &[f32], text: &mut Vec<u8>) {
        for number in numbers {
            self.push(&number.to_le_bytes(), text);
        }
    }

    /// Appends the digits of what is left, filled up with `=`.
    pub(super) fn finish(mut self, text: &mut Vec<u8>) {
        if self.count > 0 {
            self.held[self.count..].fill(0);
            let mut digits = group(self.held);
            digits[self.count + 1..].fill(b'=');
            text.extend(digits);
        }
    }
}

fn group([a, b, c]: [u8; 3]) -> [u8; 4] {
    let bits = u32::from_be_bytes([0, a, b, c]);
    [18, 12, 6, 0].map(|shift| DIGITS[(bits >> shift & 63) as usize])
}

/// Writes all, without all of it as text in memory.
pub(super) fn write(bytes: &[u8], out: &mut dyn Write) -> io::Result<()> {
    let (mut text, mut digits) = (Vec::with_capacity(4 * BLOCK / 3), Base64::default());
    for block in bytes.chunks(BLOCK) {
        text.clear();
        digits.push(block, &mut text);
        out.write_all(&text)?;
    }
    text.clear();
    digits.finish(&mut text);
    out.write_all(&text)
}

/// All at once.
pub(super) fn base64(bytes: &[u8]) -> Vec<u8> {
    let mut text = Vec::new();
    let mut digits = Base64::default();
    digits.push(bytes, &mut text);
    digits.finish(&mut text);
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The examples of RFC 4648, section 10.
    #[test]
    fn the_rfc_s_examples() {
        for (bytes, text) in [
            ("", ""),
            ("f", "Zg=="),
            ("fo", "Zm8="),
            ("foo", "Zm9v"),
            ("foob", "Zm9vYg=="),
            ("fooba", "Zm9vYmE="),
            ("foobar", "Zm9vYmFy"),
        ] {
            assert_eq!(base64(bytes.as_bytes()), text.as_bytes());
            let mut whole = Vec::new();
            write(bytes.as_bytes(), &mut whole).unwrap();
            assert_eq!(whole, text.as_bytes());
        }
        assert_eq!(base64(&[0xff, 0xef, 0xbe]), b"/+++");
    }
}
