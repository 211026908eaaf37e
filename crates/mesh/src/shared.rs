//! Helpers that the readers of all formats share.

use vides_engine::scene::Mesh;

use super::error::{Error, Problem, Result};

/// Lines or records between two calls of `go_on`.
pub(super) const EVERY: usize = 1 << 14;

/// The words of each non-empty line, with the line number; calls `go_on`.
pub(super) fn lines<'a>(
    bytes: &'a [u8],
    go_on: &'a mut dyn FnMut(f64) -> bool,
) -> impl Iterator<Item = Result<(usize, impl Iterator<Item = &'a str> + Clone)>> {
    let mut done = 0;
    bytes
        .split(|&byte| byte == b'\n')
        .enumerate()
        .filter_map(move |(at, line)| {
            done += line.len() + 1;
            if at % EVERY == 0 && !go_on(done as f64 / bytes.len().max(1) as f64) {
                return Some(Err(Error::Stopped));
            }
            // Anything but UTF-8 is a name, a comment, or not a valid number.
            let text = str::from_utf8(line).unwrap_or("?").trim();
            (!text.is_empty()).then(|| Ok((at + 1, text.split_ascii_whitespace())))
        })
}

pub(super) fn coordinates<'a>(words: &mut impl Iterator<Item = &'a str>) -> Option<glam::DVec3> {
    let mut next = || {
        words
            .next()?
            .parse()
            .ok()
            .filter(|number: &f64| number.is_finite())
    };
    Some(glam::DVec3::new(next()?, next()?, next()?))
}

/// A polygon as a fan of triangles around its first corner.
///
/// # Errors
/// [`Error::Memory`].
pub fn fan(corners: &[u32], triangles: &mut Vec<[u32; 3]>) -> Result<(), Error> {
    triangles.try_reserve(corners.len().saturating_sub(2))?;
    triangles.extend(
        corners
            .windows(2)
            .skip(1)
            .map(|pair| [corners[0], pair[0], pair[1]]),
    );
    Ok(())
}

/// Checks that a mesh has points and is within the engine's limits.
pub(super) fn checked(mesh: Mesh) -> Result<Mesh> {
    if mesh.points.is_empty() {
        return Err(Error::File(Problem::Empty));
    }
    mesh.check()?;
    Ok(mesh)
}
