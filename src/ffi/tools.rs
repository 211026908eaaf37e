//! Tools on paths that need more than options: matrices, boxes, other paths.

use std::ffi::c_int;

use glam::DMat4;

use super::border::border;
use super::path::{edit, edit_by, insert, insert_new, read};
use super::pointers::{Out, index, most, read_array, slice};
use super::points::point;
use super::status::{Answer, Failure, Name, V_ERR_INTERNAL};
use super::types::V_PATH;
use crate::document::{Document, Edit};
use crate::error::{OutOfRange, can_allocate, vec_with_room};
use crate::path::CameraPath;
use crate::tools::blend;
use crate::tools::block::{self, Fit};

/// How v_path_insert_path() places a block.
///
/// V_FIT_NONE   unchanged
/// V_FIT_MOVE   moved, so that it begins at the point
/// V_FIT_TURN   also turned, so that it continues in the direction of travel
/// V_FIT_SCALE  moved, turned and scaled, so that it also ends at the next point
pub const V_FIT_NONE: c_int = 0;
pub const V_FIT_MOVE: c_int = 1;
pub const V_FIT_TURN: c_int = 2;
pub const V_FIT_SCALE: c_int = 3;

/// A copy of the document of a handle, usable while others are locked.
fn copy(path: *const V_PATH) -> Answer<Document> {
    read(path, |document| Ok(document.try_clone()?))
}

/// The points from `first` to `last`.
fn range(document: &Document, first: c_int, last: c_int) -> Answer<Vec<usize>> {
    let (first, _) = point(document, first, "first_point")?;
    let (last, _) = point(document, last, "last_point")?;
    if first > last {
        return Err(OutOfRange::PointOrder { first, last }.into());
    }
    let mut points = vec_with_room(last - first + 1)?;
    points.extend(first..=last);
    Ok(points)
}

/// Moves, turns, scales and mirrors the points from first_point to last_point, with
/// their custom tangents.
///
/// matrix  column by column, without shear; its last row is 0 0 0 1
/// with_targets  1: with targets, views and rolls; 0: absolute targets stay in place,
///     relative ones keep their direction
/// V_ERR_ARGUMENT (shear, or a point at its own target).
/// cbindgen:ptrs-as-arrays=[[matrix; 16]]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_transform(
    path: *mut V_PATH,
    first_point: c_int,
    last_point: c_int,
    matrix: *const f64,
    with_targets: c_int,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        // SAFETY: sixteen doubles, as the header says.
        let matrix = DMat4::from_cols_array(&unsafe { read_array(matrix, "matrix") }?);
        edit_by(path, |document| {
            Ok(Edit::TransformPoints {
                points: range(document, first_point, last_point)?,
                matrix,
                with_targets: zero_or_one(with_targets, "with_targets")?,
            })
        })
    })
}

fn zero_or_one(number: c_int, name: &'static str) -> Answer<bool> {
    match number {
        0 | 1 => Ok(number == 1),
        _ => Err(crate::Error::from(OutOfRange::NumberBetween(name, 0.0, 1.0)).into()),
    }
}

/// Copies the points from first_point to last_point into a new, open path with the same
/// curve. On a closed path first_point may be after last_point.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_extract(
    path: *const V_PATH,
    first_point: c_int,
    last_point: c_int,
    block: *mut *mut V_PATH,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = Out::new(block, "block")?;
        let (first, last) = (
            index(first_point, "first_point")?,
            index(last_point, "last_point")?,
        );
        let (taken, fps) = read(path, |document| {
            let taken = block::extract(document.path(), first, last)?;
            Ok((taken, document.info().fps))
        })?;
        let made = insert_new(taken, fps)?;
        // SAFETY: room for a handle, as the header says.
        unsafe { out.answer(made) }
    })
}

/// Inserts a copy of a path, block, which may be the same, after point at. Both keep
/// their curves, the block its targets; where they join, they have one direction.
/// Except with V_FIT_NONE, the block's first point is merged with that point, which
/// keeps its views; with V_FIT_SCALE its last point likewise with the next one. A
/// closed block ends where it begins. Duplicate names get a number.
/// V_ERR_ARGUMENT (no direction, or no length to scale).
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_insert_path(
    path: *mut V_PATH,
    at: c_int,
    block: *const V_PATH,
    fit: c_int,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let fit = match fit {
            V_FIT_NONE => Fit::None,
            V_FIT_MOVE => Fit::Move,
            V_FIT_TURN => Fit::Turn,
            V_FIT_SCALE => Fit::Scale,
            _ => {
                return Err(Failure::unknown(
                    "fit",
                    fit,
                    "V_FIT_NONE (0), V_FIT_MOVE (1), V_FIT_TURN (2), V_FIT_SCALE (3)",
                ));
            }
        };
        let (block, _) = copy(block)
            .map_err(|failure| failure.named("block"))?
            .into_parts();
        can_allocate(size_of::<CameraPath>())?;
        let insert = Edit::InsertPath {
            at: index(at, "at")?,
            block: Box::new(block),
            fit,
            with_targets: true,
        };
        edit(path, insert)
    })
}

/// Makes the weighted sum of paths, point by point: positions, curve, targets, roll,
/// zoom and speeds; also fixed frames (rounded), angular velocities and slopes that
/// all have. Paths with fewer points are first resampled by length. The rest comes
/// from the path with the greatest weight. The count weights have the sum 1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_blend(
    paths: *const *mut V_PATH,
    weights: *const f64,
    count: usize,
    blend: *mut *mut V_PATH,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = Out::new(blend, "blend")?;
        most(count, MOST_PATHS, "count")?;
        // SAFETY: that many handles and doubles, as the header says.
        let (handles, weights) = unsafe {
            (
                slice(paths, count, "paths")?,
                slice(weights, count, "weights")?,
            )
        };
        let mut copies = vec_with_room(count)?;
        for &handle in handles {
            let named = |failure: Failure| failure.named(Name::Element("paths", copies.len()));
            let document = copy(handle).map_err(named)?;
            copies.push(document);
        }
        let mut all = vec_with_room(count)?;
        all.extend(copies.iter().map(Document::path));
        let path = blend::blend(&all, weights)?;
        let heaviest = (0..count).max_by(|&a, &b| weights[a].total_cmp(&weights[b]));
        let info = heaviest.map(|at| copies.swap_remove(at).into_parts().1);
        let made = insert(Document::from_parts(path, info.unwrap_or_default())?)?;
        // SAFETY: room for a handle, as the header says.
        unsafe { out.answer(made) }
    })
}

/// The most paths that can be blended.
const MOST_PATHS: usize = 1_000;

#[cfg(test)]
mod tests {
    use std::ptr::null_mut;

    use crate::ffi::path::{v_path_clone, v_path_free, v_path_new};
    use crate::ffi::properties::{
        v_path_get_number, v_path_get_text, v_path_set_number, v_path_set_text,
    };
    use crate::ffi::status::V_OK;

    /// "Everything else comes from the path with the greatest weight."
    #[test]
    fn a_blend_plays_as_fast_as_the_path_that_weighs_most() {
        let (mut paths, mut blend) = ([null_mut(); 2], null_mut());
        let (mut fps, mut title, mut length) = (0.0, [0; 8], 0);
        // SAFETY: room for handles, a number and a text; handles and zero-terminated texts.
        unsafe {
            assert_eq!(v_path_new(&raw mut paths[0]), V_OK);
            assert_eq!(v_path_clone(paths[0], &raw mut paths[1]), V_OK);
            assert_eq!(v_path_set_number(paths[0], c"fps".as_ptr(), 50.0), V_OK);
            assert_eq!(v_path_set_number(paths[1], c"fps".as_ptr(), 60.0), V_OK);
            assert_eq!(
                v_path_set_text(paths[1], c"title".as_ptr(), c"heavy".as_ptr()),
                V_OK
            );
            let weights = [0.25, 0.75];
            let status = super::v_path_blend(paths.as_ptr(), weights.as_ptr(), 2, &raw mut blend);
            assert_eq!(status, V_OK);
            assert_eq!(
                v_path_get_number(blend, c"fps".as_ptr(), &raw mut fps),
                V_OK
            );
            let status = v_path_get_text(
                blend,
                c"title".as_ptr(),
                title.as_mut_ptr(),
                8,
                &raw mut length,
            );
            assert_eq!(status, V_OK);
            for path in [paths[0], paths[1], blend] {
                v_path_free(path);
            }
        }
        assert_eq!((fps, title[..length].len()), (60.0, "heavy".len()));
    }
}
