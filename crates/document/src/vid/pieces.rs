//! Parsing piece by piece. A parsed tree takes some twenty times the memory
//! of its text; cut before points, a file of any size needs only a small tree
//! at a time, which stays in the processor's cache: that is twice as fast. A
//! scene is cut before its nodes.
//!
//! Why cutting is sound: a piece ends just before a line that begins with
//! `[[point]]` or `[[node]]`. Were that line within an array or a text over several lines,
//! the piece before it would be unfinished, and parsing it fails. So a piece
//! that parses ends where a new table begins, and what follows does not
//! depend on it, but for keys given twice, which the reader watches.

use toml::de::{DeTable, Error as ParseError};

use super::field::Source;
use super::weight;
use crate::error::{Error, Result, can_allocate};
use crate::limits::{MAX_COMMENT_BYTES, MAX_PARSE_BYTES};

/// Bytes of a piece, at least. A fuzzer's files are small, and are to be cut too.
const PIECE: usize = if cfg!(fuzzing) { 256 } else { 128 << 10 };

/// More than the longest comment takes, even if each of its bytes is written
/// as six; nothing else that may hold a line of this kind is longer.
const LONGEST_TEXT: usize = 6 * MAX_COMMENT_BYTES + 100;

const CUTS: [&[u8]; 2] = [b"\n[[point]]", b"\n[[node]]"];

/// The tree of the piece that begins where `source` does, and its end.
pub(super) fn parse(source: Source<'_>) -> Result<(DeTable<'_>, usize)> {
    let end = cut(source, PIECE);
    match parse_to(source, end)? {
        Ok(root) => Ok((root, end)),
        // Either an error, or such a line within a comment. The comment ends
        // further on; an error stays.
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

/// The end of a piece of at least so many bytes.
fn cut(source: Source<'_>, least: usize) -> usize {
    let bytes = source.text.as_bytes();
    let from = source.start.saturating_add(least);
    // Any byte may be looked at: only ASCII is looked for.
    bytes
        .get(from..)
        .and_then(|rest| {
            (0..rest.len())
                .find(|&at| rest[at] == b'\n' && CUTS.iter().any(|cut| rest[at..].starts_with(cut)))
        })
        .map_or(bytes.len(), |position| from + position + 1)
}

/// The tree of the text up to `end`, or why there is none.
fn parse_to(source: Source<'_>, end: usize) -> Result<Result<DeTable<'_>, ParseError>> {
    let piece = &source.text[source.start..end];
    let memory = weight::memory(piece);
    if memory > MAX_PARSE_BYTES {
        return Err(Error::PieceTooLarge(source.line(0)));
    }
    // The parser cannot give up when memory runs out: see that there is enough,
    // for copies of its texts too.
    can_allocate(memory + piece.len())?;
    Ok(DeTable::parse(piece).map(toml::Spanned::into_inner))
}
