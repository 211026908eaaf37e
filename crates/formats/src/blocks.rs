//! Samples poses or states and writes them as text in blocks, so that memory does not grow with the
//! film.

use std::io::{self, Write};

use vides_document::Error as DocumentError;
use vides_document::error::vec_with_room;

use super::error::{Error, Result};

/// Called now and then with the number of poses written and the total.
pub type Progress<'a> = &'a mut dyn FnMut(usize, usize);

/// Poses or states per block: large enough to amortise the write call, small enough for the cache.
pub(super) const BLOCK: usize = 512;

/// Expected bytes per pose; more only costs a reallocation.
const BYTES: usize = 256;

/// Writes `text` and behind it `count` poses or states in order: `sample` fills in those from an
/// index on, `push` appends one to the text.
pub(super) fn write<T: Clone + Default>(
    mut text: Vec<u8>,
    count: usize,
    out: &mut dyn Write,
    progress: Progress<'_>,
    mut sample: impl FnMut(usize, &mut [T]) -> Result<()>,
    mut push: impl FnMut(&mut Vec<u8>, usize, &T),
) -> Result<()> {
    let mut room = vec_with_room(BLOCK)?;
    room.resize(BLOCK.min(count), T::default());
    text.try_reserve(BLOCK * BYTES)?;
    let mut done = 0;
    while done < count {
        let block = room.len().min(count - done);
        let block = &mut room[..block];
        sample(done, block)?;
        for (index, one) in block.iter().enumerate() {
            push(&mut text, done + index, one);
        }
        out.write_all(&text).map_err(failed)?;
        text.clear();
        done += block.len();
        progress(done, count);
    }
    Ok(())
}

/// An error of a writer that has no name.
pub(super) fn failed(source: io::Error) -> Error {
    DocumentError::Io {
        place: "the output".to_owned(),
        source,
    }
    .into()
}
