//! Support points.

use std::ffi::c_int;

use super::border::border;
use super::path::{edit, read};
use super::pointers::{Out, count, how_many, index, read_vector};
use super::status::{Answer, V_ERR_INTERNAL};
use super::types::V_PATH;
use crate::document::{Document, Edit};
use crate::error::OutOfRange;
use crate::path::SupportPoint;

/// A point by its index from C.
pub(super) fn point<'a>(
    document: &'a Document,
    at: c_int,
    name: &'static str,
) -> Answer<(usize, &'a SupportPoint)> {
    let (at, points) = (index(at, name)?, &document.path().points);
    let last = points.len() - 1;
    let point = points.get(at);
    Ok((at, point.ok_or(OutOfRange::NoPoint { point: at, last })?))
}

/// ==== Points: what the curve passes through ====
///
/// Gets the number of points, at least 2.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_point_count(path: *const V_PATH, count: *mut c_int) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = Out::new(count, "count")?;
        let points = read(path, |document| self::count(document.path().points.len()))?;
        // SAFETY: room for an int, as the header says.
        unsafe { out.answer(points) }
    })
}

/// Inserts a point before index at; if at is their number, appends it. It copies all
/// other properties from the point before it, or from the first one; an absolute
/// target equal to its position becomes relative.
/// cbindgen:ptrs-as-arrays=[[xyz; 3]]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_insert_point(
    path: *mut V_PATH,
    at: c_int,
    xyz: *const f64,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        // SAFETY: three doubles, as the header says.
        let position = unsafe { read_vector(xyz, "xyz") }?;
        let at = index(at, "at")?;
        edit(path, Edit::InsertPoint { at, position })
    })
}

/// Divides a segment with 1 to 10 points on its curve, at equal arc lengths. They
/// copy all other properties from the point before them, so the motion changes;
/// v_path_insert_on_curve() keeps it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_divide_segment(
    path: *mut V_PATH,
    segment: c_int,
    points: c_int,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let (segment, points) = (index(segment, "segment")?, how_many(points, "points")?);
        edit(path, Edit::DivideSegment { segment, points })
    })
}

/// Removes a point. The last two cannot be removed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_remove_point(path: *mut V_PATH, at: c_int) -> c_int {
    border(V_ERR_INTERNAL, || {
        edit(
            path,
            Edit::RemovePoint {
                at: index(at, "at")?,
            },
        )
    })
}

/// Moves a point to another index; the points between shift by one.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_move_point(path: *mut V_PATH, from: c_int, to: c_int) -> c_int {
    border(V_ERR_INTERNAL, || {
        let (from, to) = (index(from, "from")?, index(to, "to")?);
        edit(path, Edit::MovePoint { from, to })
    })
}
