//! An upper bound on the memory that parsing a text takes, from the text alone.
//!
//! The parser first lists all tokens and then builds a tree in which each table takes over a
//! kilobyte, however short its name. A malicious text (`a.a.a.a = 1`, or only line ends) takes
//! fifty to six hundred times its size. So every byte that may begin a token, a value or a table
//! counts, strings and comments included, which may overestimate by far; `tests/parsing_memory.rs`
//! compares it with the real use. (The events of `toml_parser` come too late: they are made from
//! the token list, which must be bounded first.)

/// Bytes for a token, including the list's doubling.
pub(super) const TOKEN: usize = 60;

/// Bytes for a value in an array or a table, including doubling.
const VALUE: usize = 220;

/// Bytes for a table with one entry.
pub(super) const TABLE: usize = 1600;

pub(super) fn memory(text: &str) -> usize {
    let bytes = text.as_bytes();
    let mut sum = 4096;
    let mut before = b'\n';
    // Dots since the last byte that is not part of a number.
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
            // A decimal point, or a dotted key that makes a table.
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
            // The key may be a dotted number, which makes another table.
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

/// Whether only a comment may follow on the line, as after a header.
fn ends_line(rest: &[u8]) -> bool {
    let next = rest.iter().find(|byte| !matches!(byte, b' ' | b'\t'));
    matches!(next, None | Some(b'\n' | b'\r' | b'#'))
}
