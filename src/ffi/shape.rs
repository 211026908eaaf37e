//! Tangents that points own, and points put on the curve.

use std::ffi::c_int;

use super::border::border;
use super::path::{edit_and, read};
use super::pointers::{Out, count};
use super::points::point;
use super::status::{V_ERR_INTERNAL, V_OK};
use super::types::V_PATH;
use crate::document::Edit;
use crate::path::curve;

/// Gets the tangents of the curve at a point, equal at an end of an open path, and
/// whether they are custom: 1 or 0. The property "tangents" sets them: the
/// derivatives with which the curve reaches and leaves the point, a segment counting
/// 1.
/// cbindgen:ptrs-as-arrays=[[before; 3], [after; 3]]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_get_tangents(
    path: *const V_PATH,
    at: c_int,
    before: *mut f64,
    after: *mut f64,
    own: *mut c_int,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let (before, after) = (
            Out::optional_array(before, "before")?,
            Out::optional_array(after, "after")?,
        );
        let own = Out::optional(own, "own")?;
        let (tangents, has_own) = read(path, |document| {
            let (at, point) = point(document, at, "at")?;
            Ok((
                curve::tangents(document.path(), at),
                point.tangents.is_some(),
            ))
        })?;
        // SAFETY: room for three doubles each and an int, as the header says.
        unsafe {
            before.write(tangents.before.to_array());
            after.write(tangents.after.to_array());
            own.write(c_int::from(has_own));
        }
        Ok(V_OK)
    })
}

/// Inserts a point on the curve where the camera is at a frame, without changing the
/// curve, any pose or the number of frames. It gets the nearest whole frame within
/// the section; a section of one frame becomes two. Neighbours get custom tangents,
/// angular velocities, slopes of zoom and roll, and a part of the old speed profile;
/// such tangents are removed when their point or a neighbour moves alone, unless you
/// set them. *at receives the index.
///
/// frame  not at a key, not in a pan, not with orientation_mode "barry-goldman"
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_insert_on_curve(
    path: *mut V_PATH,
    frame: f64,
    at: *mut c_int,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let at = Out::optional(at, "at")?;
        let edit = Edit::InsertOnCurve { frame };
        let new = edit_and(path, edit, |document| count(document.selection().point))??;
        // SAFETY: room for an int, as the header says.
        unsafe { at.answer(new) }
    })
}
