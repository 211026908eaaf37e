//! Tools on paths: moves, points moved and deformed, blocks, blends.

use std::ffi::{c_char, c_int};
use std::ptr;

use glam::DMat4;

use super::border::border;
use super::path::{edit, edit_by, insert, insert_new, read};
use super::pointers::{Out, index, most, optional, read_array, slice, text};
use super::points::point;
use super::scene_tracks::{bounds, deformation};
use super::space::optional_space;
use super::status::{Answer, Failure, Name, V_ERR_INTERNAL};
use super::types::{V_PATH, V_SPACE};
use crate::document::tool::moved;
use crate::document::{Document, Edit, Info};
use crate::error::{OutOfRange, can_allocate, vec_with_room};
use crate::path::CameraPath;
use crate::tools::blend;
use crate::tools::block::{self, Fit};
use crate::tools::moves::Move;

/// ==== How a block is put in, see v_path_insert_path() ====
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

/// ==== Tools ====
///
/// Makes a path by a ready-made move, at 25 frames per second and one speed. parameters
/// has the numbers in the order below; those after count have the defaults in
/// parentheses. around and at are three numbers, from, to, rise and tilt degrees. Headings
/// are seen from the target: 0 is towards +z, 90 towards +x.
///
/// "orbit"  on a circle round a target
///     around x y z (0), radius (1), height (0.4), from degrees (0), turns (1),
///     zoom mm (24), seconds (10)
/// "spiral"  round a target with another radius and height at the end
///     around x y z (0), radius (1), height (0.4), from degrees (0), turns (1),
///     zoom mm (24), seconds (10), end-radius (0.5), end-height (1)
/// "arc"  on a part of a circle, from one heading to another
///     around x y z (0), radius (1), height (0.4), from degrees (-45),
///     to degrees (45), zoom mm (24), seconds (10)
/// "flyby"  straight past a target that stays in view
///     around x y z (0), distance (1), height (0.4), from degrees (0),
///     length (2), zoom mm (24), seconds (10)
/// "approach"  straight towards a target
///     around x y z (0), distance (1), end-distance (0.4), from degrees (0),
///     rise degrees (15), zoom mm (24), seconds (10)
/// "dolly-zoom"  towards a target that keeps its size in the picture
///     around x y z (0), distance (1), end-distance (0.4), from degrees (0),
///     rise degrees (15), zoom mm (60), seconds (10)
/// "crane"  straight up or down beside a target that stays in view
///     around x y z (0), radius (1), height (-0.2), end-height (1),
///     from degrees (0), zoom mm (24), seconds (10)
/// "pan"  turns on the spot
///     at x y z (0), from degrees (-45), to degrees (45), tilt degrees (0),
///     zoom mm (24), seconds (10)
/// "figure-eight"  on an eight that lies before the target
///     around x y z (0), radius (0.7), height (0.4), width (1.2),
///     from degrees (0), zoom mm (24), seconds (10)
///
/// V_ERR_ARGUMENT, V_ERR_RANGE, V_ERR_LIMIT, V_ERR_MEMORY.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_from_move(
    r#move: *const c_char,
    parameters: *const f64,
    count: usize,
    path: *mut *mut V_PATH,
) -> c_int {
    // SAFETY: the same.
    unsafe { v_path_from_move_in_space(r#move, parameters, count, ptr::null(), path) }
}

/// Like v_path_from_move(), in a space; NULL: that of v_space_init(). With V_UP_Z,
/// headings are towards +x (0) and +y (90), and heights along z. Default lengths are
/// multiplied by half_size; default positions are the centre.
/// V_ERR_SIZE, V_ERR_ARGUMENT, V_ERR_RANGE, V_ERR_LIMIT, V_ERR_MEMORY.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_from_move_in_space(
    r#move: *const c_char,
    parameters: *const f64,
    count: usize,
    space: *const V_SPACE,
    path: *mut *mut V_PATH,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = Out::new(path, "path")?;
        // SAFETY: a zero-terminated text, as the header says.
        let found = Move::named(unsafe { text(r#move, "move") }?)?;
        // SAFETY: a space, as the header says.
        let space = unsafe { optional_space(space) }?.unwrap_or_default();
        let put = |numbers: &mut [f64]| {
            if count > 0 {
                let most = numbers.len();
                let Some(numbers) = numbers.get_mut(..count) else {
                    return Err(OutOfRange::NumbersGiven { given: count, most }.into());
                };
                // SAFETY: that many doubles, as the header says.
                numbers.copy_from_slice(unsafe { slice(parameters, count, "parameters") }?);
            }
            Ok::<_, Failure>(())
        };
        let made = insert(moved(found, space, &Info::default(), false, put)?)?;
        // SAFETY: room for a handle, as the header says.
        unsafe { out.answer(made) }
    })
}

/// Moves, turns, scales and mirrors the points from first_point to last_point, with
/// their custom tangents.
///
/// matrix  column by column, without shear; its last row is 0 0 0 1
/// with_targets  1: with targets, views and rolls; 0: absolute targets stay in place,
///     relative ones keep their direction
/// V_ERR_ARGUMENT (shear, or a point at its own target), V_ERR_RANGE, V_ERR_MEMORY.
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

/// Deforms the points from first_point to last_point like v_deform(), with their custom
/// tangents, and with their targets (with_targets 1) or not (0). box NULL: the bounds
/// of the points.
/// V_ERR_ARGUMENT, V_ERR_RANGE, V_ERR_LIMIT, V_ERR_MEMORY.
/// cbindgen:ptrs-as-arrays=[[box; 6]]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_deform(
    path: *mut V_PATH,
    first_point: c_int,
    last_point: c_int,
    kind: *const c_char,
    parameters: *const f64,
    count: usize,
    r#box: *const f64,
    with_targets: c_int,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        // SAFETY: as the header says of v_deform().
        let deformation = unsafe { deformation(kind, parameters, count) }?;
        // SAFETY: six doubles, as the header says.
        let bounds = optional(r#box, |corners| unsafe { bounds(corners) })?;
        edit_by(path, |document| {
            Ok(Edit::DeformPoints {
                points: range(document, first_point, last_point)?,
                deformation,
                bounds,
                with_targets: zero_or_one(with_targets, "with_targets")?,
            })
        })
    })
}

/// Copies the points from first_point to last_point into a new, open path with the same
/// curve. On a closed path first_point may be after last_point.
/// V_ERR_RANGE, V_ERR_MEMORY, V_ERR_LIMIT.
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
/// their curves, the block its targets; where they join, they have one direction. Except
/// with V_FIT_NONE, the block's first point is merged with that point, which keeps its
/// views; with V_FIT_SCALE its last point likewise with the next one. A closed block ends
/// where it begins. Duplicate names get a number.
/// V_ERR_ARGUMENT (no direction, or no length to scale), V_ERR_RANGE, V_ERR_LIMIT,
/// V_ERR_MEMORY.
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
/// zoom and speeds; also fixed frames (rounded), angular velocities and slopes that all
/// have. Paths with fewer points are first resampled by length. Everything else comes
/// from the path with the greatest weight. The count weights have the sum 1.
/// V_ERR_ARGUMENT, V_ERR_RANGE, V_ERR_LIMIT, V_ERR_MEMORY.
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
    use std::fmt::Write as _;
    use std::ptr::null_mut;

    use crate::ffi::path::{v_path_clone, v_path_free, v_path_new};
    use crate::ffi::properties::{
        v_path_get_number, v_path_get_text, v_path_set_number, v_path_set_text,
    };
    use crate::ffi::status::V_OK;
    use crate::tools::moves::MOVES;

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

    /// The header's comment is the engine's table.
    #[test]
    fn the_moves_of_the_header_are_those_of_the_engine() {
        let mut want = String::new();
        for known in MOVES {
            let _ = writeln!(want, "/// \"{}\"  {}", known.name, known.does);
            let mut line = "///    ".to_owned();
            for (k, parameter) in known.parameters.iter().enumerate() {
                let mut word = parameter.name.to_owned();
                if parameter.width == 3 {
                    word += " x y z";
                }
                let unit = parameter.unit.name();
                if !unit.is_empty() && unit != parameter.name {
                    let _ = write!(word, " {unit}");
                }
                let last = k + 1 == known.parameters.len();
                let _ = write!(
                    word,
                    " ({}){}",
                    parameter.default,
                    if last { "" } else { "," }
                );
                if line.len() + 1 + word.len() > 82 {
                    want += &line;
                    want += "\n";
                    line = "///    ".to_owned();
                }
                line += " ";
                line += &word;
            }
            want += &line;
            want += "\n";
        }
        let source = include_str!("tools.rs");
        assert!(source.contains(&want), "{want}");
    }
}
