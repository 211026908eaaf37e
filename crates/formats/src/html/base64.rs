//! Bytes as text (RFC 4648, section 4), piece by piece.

const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// What is left of the last piece: three bytes make four digits.
#[derive(Default)]
pub(super) struct Base64 {
    held: Vec<u8>,
}

impl Base64 {
    /// Appends the digits of all whole groups of three bytes.
    pub(super) fn push(&mut self, bytes: &[u8], text: &mut Vec<u8>) {
        for &byte in bytes {
            self.held.push(byte);
            if self.held.len() == 3 {
                self.group(text);
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
        let missing = (3 - self.held.len()) % 3;
        if missing > 0 {
            self.held.resize(3, 0);
            self.group(text);
            text.truncate(text.len() - missing);
            text.extend_from_slice(&b"=="[..missing]);
        }
    }

    fn group(&mut self, text: &mut Vec<u8>) {
        let bits = self
            .held
            .iter()
            .fold(0, |bits, byte| bits << 8 | usize::from(*byte));
        text.extend([18, 12, 6, 0].map(|shift| DIGITS[bits >> shift & 63]));
        self.held.clear();
    }
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
        }
        assert_eq!(base64(&[0xff, 0xef, 0xbe]), b"/+++");
    }
}
