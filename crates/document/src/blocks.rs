//! Samples poses and writes them as text in blocks, so that memory does not grow with the film.

use std::io::{self, Write};

use crate::error::{Error, Result, vec_with_room};
use crate::path::{Pose, Sampler};

/// Called now and then with the number of poses written and the total.
pub type Progress<'a> = &'a mut dyn FnMut(usize, usize);

/// Poses per block: large enough to amortise the write call, small enough for the cache.
const BLOCK: usize = 512;

/// Expected bytes per pose; more only costs a reallocation.
const BYTES: usize = 256;

/// Writes all poses in order; `push` appends one, given its index from 0.
pub(super) fn write(
    sampler: &Sampler,
    out: &mut dyn Write,
    progress: Progress<'_>,
    push: &mut dyn FnMut(&mut Vec<u8>, usize, &Pose),
) -> Result<()> {
    let all = sampler.frame_count();
    let mut poses = vec_with_room(BLOCK)?;
    poses.resize(BLOCK.min(all), Pose::default());
    let mut text = vec_with_room(BLOCK * BYTES)?;
    let mut done = 0;
    while done < all {
        let block = poses.len().min(all - done);
        let poses = &mut poses[..block];
        sampler.sample(done + 1, poses)?;
        text.clear();
        for (index, pose) in poses.iter().enumerate() {
            push(&mut text, done + index, pose);
        }
        out.write_all(&text).map_err(failed)?;
        done += block;
        progress(done, all);
    }
    Ok(())
}

/// An error of a writer that has no name.
pub(super) fn failed(source: io::Error) -> Error {
    Error::Io {
        place: "the output".to_owned(),
        source,
    }
}
