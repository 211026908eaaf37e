//! Parsing piece by piece. A parsed tree takes some twenty times the memory
//! of its text; cut before points, a file of any size needs only a small tree
//! at a time, which stays in the processor's cache: that is twice as fast.
//!
//! Why cutting is sound: a piece ends just before a line that begins with
//! `[[point]]`. Were that line within an array or a text over several lines,
//! the piece before it would be unfinished, and parsing it fails. So a piece
//! that parses ends where a new table begins, and what follows does not
//! depend on it, but for keys given twice, which the reader watches.

use toml::de::{DeTable, Error as ParseError};

use super::field::Source;
use crate::error::{Error, Result};
use crate::limits::{MAX_COMMENT_BYTES, MAX_FILE_VALUES};

/// Bytes of a piece, at least.
const PIECE: usize = 128 << 10;

/// More than the longest comment takes, even if each of its bytes is written
/// as six; nothing else that may hold a line of this kind is longer.
const LONGEST_TEXT: usize = 6 * MAX_COMMENT_BYTES + 100;

const CUT: &str = "\n[[point]]";

/// The tree of the piece that begins where `source` does, and its end.
pub(super) fn parse(source: Source<'_>) -> Result<(DeTable<'_>, usize)> {
    let end = cut(source, PIECE);
    match parse_to(source, end)? {
        Ok(root) => Ok((root, end)),
        // Either an error, or a `[[point]]` within a comment. The comment ends
        // further on; an error stays.
        Err(_) if end < source.text.len() => {
            let end = cut(source, end - source.start + LONGEST_TEXT);
            match parse_to(source, end)? {
                Ok(root) => Ok((root, end)),
                Err(error) => Err(refusal(source, &error)),
            }
        }
        Err(error) => Err(refusal(source, &error)),
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
            rest.windows(CUT.len())
                .position(|window| window == CUT.as_bytes())
        })
        .map_or(bytes.len(), |position| from + position + 1)
}

fn parse_to(source: Source<'_>, end: usize) -> Result<Result<DeTable<'_>, ParseError>> {
    let piece = &source.text[source.start..end];
    // Each value stands behind one of these; nobody counts in a small piece.
    let opens = |byte: &u8| matches!(byte, b'=' | b'[' | b',' | b'{');
    let values = match piece.len() {
        ..=MAX_FILE_VALUES => 0,
        _ => piece.as_bytes().iter().filter(|byte| opens(byte)).count(),
    };
    if values > MAX_FILE_VALUES {
        return Err(Error::Limit(
            format!("the file has more than {MAX_FILE_VALUES} values in one table").into(),
        ));
    }
    Ok(DeTable::parse(piece).map(toml::Spanned::into_inner))
}

fn refusal(source: Source<'_>, error: &ParseError) -> Error {
    let offset = error.span().map_or(0, |span| span.start);
    source.complain(offset, error.message())
}
