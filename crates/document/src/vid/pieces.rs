//! Parsing piece by piece. A tree of the parser takes some twenty times the memory of its text.
//! With the text cut before points or nodes, each tree stays small and in the cache, which is twice
//! as fast.
//!
//! Cutting is sound: a piece ends just before a line that begins with `[[point]]` or `[[node]]`. If
//! that line were within an array or a multi-line string, parsing the piece would fail as
//! unfinished. So a piece that parses ends where a new table begins, and what follows does not
//! depend on it, except for keys given twice, which the reader checks.

use toml::de::{DeTable, Error as ParseError};

use super::field::Source;
use super::tree::{self, Table};
use super::weight;
use crate::error::{EngineError, Error, Result, can_allocate};
use vides_engine::limits::{MAX_COMMENT_BYTES, MAX_FILE_BYTES, MAX_PARSE_BYTES, MAX_TREE_BYTES};

/// Minimum bytes of a piece; small for the fuzzer, so that its files are cut too.
const PIECE: usize = if cfg!(fuzzing) { 256 } else { 128 << 10 };

/// More than the longest comment takes, each byte written as six; no other text here is longer.
const LONGEST_TEXT: usize = 6 * MAX_COMMENT_BYTES + 100;

const CUTS: [&[u8]; 2] = [b"\n[[point]]", b"\n[[node]]"];

/// No byte of a text takes more than this, with what memory takes at the least.
const MOST: usize = 4096 + weight::TOKEN + 2 * weight::TABLE;

/// Parses the piece that begins at `source.start`; returns its tree and end.
pub(super) fn parse(source: Source<'_>) -> Result<(Table<'_>, usize)> {
    let end = cut(source, PIECE);
    match parse_to(source, end)? {
        Ok(root) => Ok((root, end)),
        // Either an error, or such a line within a `comment` value, which ends further on.
        Err(_) if end < source.text.len() => {
            let end = cut(source, end - source.start + LONGEST_TEXT);
            match parse_to(source, end)? {
                Ok(root) => Ok((root, end)),
                Err(error) => Err(source.not_toml(&error)),
            }
        }
        Err(error) => Err(source.not_toml(&error)),
    }
}

/// A text that we have written, if it can be read again.
///
/// # Errors
/// [`Error::FileTooLarge`], [`Error::PieceTooLarge`].
pub(super) fn readable(text: String) -> Result<String> {
    if text.len() as u64 > MAX_FILE_BYTES {
        return Err(Error::FileTooLarge(MAX_FILE_BYTES >> 20));
    }
    each_fits(&text, MAX_TREE_BYTES).map(|()| text)
}

/// Whether each piece can be read within a limit of bytes.
fn each_fits(text: &str, most: usize) -> Result<()> {
    let mut source = Source { text, start: 0 };
    while source.start < text.len() {
        let end = cut(source, PIECE);
        let piece = &text[source.start..end];
        // A short piece cannot take so much.
        if piece.len() > most / tree::MOST && !tree::fits(piece, most) {
            return Err(Error::PieceTooLarge(source.line(0)));
        }
        source.start = end;
    }
    Ok(())
}

/// The end of a piece of at least `least` bytes.
fn cut(source: Source<'_>, least: usize) -> usize {
    let bytes = source.text.as_bytes();
    let from = source.start.saturating_add(least);
    // Bytes, since only ASCII is searched for.
    bytes
        .get(from..)
        .and_then(|rest| {
            (0..rest.len())
                .find(|&at| rest[at] == b'\n' && CUTS.iter().any(|cut| rest[at..].starts_with(cut)))
        })
        .map_or(bytes.len(), |position| from + position + 1)
}

fn parse_to(source: Source<'_>, end: usize) -> Result<Result<Table<'_>, ParseError>> {
    let piece = &source.text[source.start..end];
    match tree::read(piece, MAX_TREE_BYTES) {
        tree::Reading::Plain(table) => return Ok(Ok(table)),
        tree::Reading::Dear => return Err(Error::PieceTooLarge(source.line(0))),
        tree::Reading::NoMemory => return Err(EngineError::Memory.into()),
        tree::Reading::Other => {}
    }
    // A short piece cannot weigh so much.
    let long = piece.len() > MAX_PARSE_BYTES / MOST;
    if long && weight::memory(piece) > MAX_PARSE_BYTES {
        return Err(Error::PieceTooLarge(source.line(0)));
    }
    // The parser cannot handle running out of memory: check first, copies of its strings included.
    can_allocate(weight::memory(piece) + piece.len())?;
    Ok(DeTable::parse(piece).map(|table| table.into_inner().into()))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By the same count as reading: what is refused in one place is in the other.
    #[test]
    fn what_could_not_be_read_again_is_refused_with_its_line() {
        let rows = |count: usize| "  [0, 1, 2],\n".repeat(count);
        let node = |count| format!("[[node]]\ntriangles = [\n{}]\n", rows(count));
        let text = format!("version = 1\n{}{}", node(PIECE / 10), node(PIECE));
        let second = text[20..].find("[[node]]").unwrap() + 20;
        let most = 200 * PIECE;
        assert!(tree::fits(&text[..second], most) && !tree::fits(&text[second..], most));
        let line = 1 + text[..second].lines().count();
        let error = each_fits(&text, most).unwrap_err();
        assert!(
            matches!(error, Error::PieceTooLarge(at) if at == line),
            "{error}"
        );
        assert!(each_fits(&text, 1000 * PIECE).is_ok());
    }
}
