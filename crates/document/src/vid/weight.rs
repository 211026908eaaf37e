//! How much memory parsing a text takes, at most, told from the text alone.
//!
//! The parser makes a list of all tokens first, and then a tree in which each
//! table takes more than a kilobyte, however short its name in the file. A text
//! made for the purpose (`a.a.a.a = 1`, or nothing but line ends) takes fifty to
//! six hundred times its size. So every byte is looked at: what may begin a
//! token, a value, a table. Texts and comments are counted as if they were
//! values, so it may be too much by far; `tests/parsing_memory.rs` holds it
//! against what is really taken. (The events of `toml_parser` come too late: they are
//! made of a list of all tokens, which is the first thing that has to be bounded.)

/// Bytes for a token, the list's doubling included.
const TOKEN: usize = 60;

/// Bytes for a value in an array or a table, the same included.
const VALUE: usize = 220;

/// Bytes for a table with one entry.
const TABLE: usize = 1600;

/// Bytes that parsing this takes at most.
pub(super) fn memory(text: &str) -> usize {
    let bytes = text.as_bytes();
    let mut sum = 4096;
    let mut before = b'\n';
    // Dots since the last byte that is no part of a number.
    let mut dots = 0;
    for (at, &byte) in bytes.iter().enumerate() {
        let more = match byte {
            b'a'..=b'z' | b'A'..=b'Z' | b'0'..=b'9' | b'_' | b'-' | b'+' => {
                let inside = before.is_ascii_alphanumeric() || matches!(before, b'_' | b'-' | b'+');
                before = byte;
                sum += if inside { 0 } else { TOKEN };
                continue;
            }
            b' ' | b'\t' if before == byte => 0,
            b' ' | b'\t' => TOKEN,
            // A point, or a way from table to table.
            b'.' => {
                dots += 1;
                let next = bytes.get(at + 1).is_some_and(u8::is_ascii_digit);
                if dots == 1 && next && before.is_ascii_digit() {
                    before = byte;
                    sum += TOKEN;
                    continue;
                }
                before = byte;
                sum += TOKEN + TABLE;
                continue;
            }
            // Each name may be a number with a point, and so a table more.
            b'=' => TOKEN + VALUE + TABLE,
            b'{' => TOKEN + VALUE + TABLE,
            b'[' | b',' => TOKEN + VALUE,
            b']' if ends_line(&bytes[at + 1..]) => TOKEN + 2 * TABLE,
            _ => TOKEN,
        };
        dots = 0;
        before = byte;
        sum += more;
    }
    sum
}

/// Whether nothing but a comment follows on the line, as after a header.
fn ends_line(rest: &[u8]) -> bool {
    let next = rest.iter().find(|byte| !matches!(byte, b' ' | b'\t'));
    matches!(next, None | Some(b'\n' | b'\r' | b'#'))
}
