//! Support points, their shape parameters and the presets.

use std::ffi::{c_char, c_int};

use super::border::border;
use super::path::{edit, edit_by, read};
use super::pointers::{Out, TextOut, copied, count, how_many, index, read_vector, text};
use super::status::{Answer, V_ERR_INTERNAL, V_OK};
use super::types::V_PATH;
use crate::document::{At, Document, Edit};
use crate::error::OutOfRange;
use crate::limits::PRESETS;
use crate::path::camera_path::check_name;
use crate::path::{CurveParameters, SupportPoint, Tcb};

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

/// ==== Points ====
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
/// other properties from the point before it, or from the one after it if at is 0; an
/// absolute target equal to its position becomes relative. Coordinates are at most 1e9
/// times half_size from the centre of the space.
/// V_ERR_ARGUMENT, V_ERR_RANGE, V_ERR_LIMIT, V_ERR_MEMORY.
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

/// Divides a segment with 1 to 10 points on its curve, at equal arc lengths. They copy
/// all other properties from the point before them, so the motion changes;
/// v_path_insert_on_curve() keeps it.
/// V_ERR_RANGE, V_ERR_LIMIT, V_ERR_MEMORY.
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
/// V_ERR_RANGE.
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

/// Moves a point, with its relative targets. Absolute ones stay in place and must not
/// equal the position. Coordinates as in v_path_insert_point().
/// V_ERR_ARGUMENT, V_ERR_RANGE.
/// cbindgen:ptrs-as-arrays=[[xyz; 3]]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_set_position(
    path: *mut V_PATH,
    at: c_int,
    xyz: *const f64,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        // SAFETY: three doubles, as the header says.
        let position = unsafe { read_vector(xyz, "xyz") }?;
        let at = index(at, "at")?;
        edit(path, Edit::set(At::Point(at), "position", position))
    })
}

/// Gets the position of a point.
/// V_ERR_RANGE.
/// cbindgen:ptrs-as-arrays=[[xyz; 3]]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_get_position(
    path: *const V_PATH,
    at: c_int,
    xyz: *mut f64,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let xyz = Out::array(xyz, "xyz")?;
        let position = read(path, |document| Ok(point(document, at, "at")?.1.position))?;
        // SAFETY: room for three doubles, as the header says.
        unsafe { xyz.answer(position.to_array()) }
    })
}

/// Moves a point to another index; the points between shift by one.
/// V_ERR_RANGE, V_ERR_MEMORY.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_move_point(path: *mut V_PATH, from: c_int, to: c_int) -> c_int {
    border(V_ERR_INTERNAL, || {
        let (from, to) = (index(from, "from")?, index(to, "to")?);
        edit(path, Edit::MovePoint { from, to })
    })
}

/// Sets the name of a point: one line of at most 256 bytes; "" removes it.
/// V_ERR_ARGUMENT, V_ERR_RANGE, V_ERR_LIMIT, V_ERR_MEMORY.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_set_point_name(
    path: *mut V_PATH,
    at: c_int,
    name: *const c_char,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        // SAFETY: a zero-terminated text, as the header says.
        let name = unsafe { text(name, "name") }?;
        // Checked before it is copied, since it may be of any length.
        check_name(name)?;
        let name = (!name.is_empty()).then(|| copied(name)).transpose()?;
        let at = index(at, "at")?;
        edit(path, Edit::set(At::Point(at), "name", name))
    })
}

/// Gets the name of a point, "" if it has none.
/// V_ERR_RANGE, V_ERR_SIZE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_get_point_name(
    path: *const V_PATH,
    at: c_int,
    name: *mut c_char,
    capacity: usize,
    length: *mut usize,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = TextOut::new(name, capacity, length, "name")?;
        read(path, |document| {
            let name = point(document, at, "at")?.1.name.as_deref();
            // SAFETY: room as the header says.
            unsafe { out.write(name.unwrap_or_default().as_bytes()) }
        })
    })
}

/// ==== Tension, continuity and bias of the curve ====
///
/// Sets the tension, continuity and bias of a point, each from -1 to 1 (Kochanek and
/// Bartels 1984), instead of a preset.
/// V_ERR_RANGE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_set_tcb(
    path: *mut V_PATH,
    at: c_int,
    tension: f64,
    continuity: f64,
    bias: f64,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let (at, tcb) = (index(at, "at")?, Tcb::new(tension, continuity, bias));
        edit(path, Edit::set(At::Point(at), "own", tcb))
    })
}

/// Makes a point use one of the path's presets, 0 to 9.
/// V_ERR_RANGE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_use_preset(path: *mut V_PATH, at: c_int, preset: c_int) -> c_int {
    border(V_ERR_INTERNAL, || {
        let (at, preset) = (index(at, "at")?, index(preset, "preset")?);
        if preset >= PRESETS {
            return Err(OutOfRange::NoPreset(preset).into());
        }
        edit(path, Edit::set(At::Point(at), "preset", preset))
    })
}

/// Gets the tension, continuity and bias in effect at a point, and its preset, or -1 if
/// it has its own values.
/// V_ERR_RANGE.
/// cbindgen:ptrs-as-arrays=[[tcb; 3]]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_get_tcb(
    path: *const V_PATH,
    at: c_int,
    tcb: *mut f64,
    preset: *mut c_int,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let (tcb, preset) = (
            Out::optional_array(tcb, "tcb")?,
            Out::optional(preset, "preset")?,
        );
        let (values, number) = read(path, |document| {
            let (at, point) = point(document, at, "at")?;
            let number = match point.curve {
                CurveParameters::Preset(number) => c_int::from(number),
                CurveParameters::Own(_) => -1,
            };
            Ok((document.path().tcb(at), number))
        })?;
        // SAFETY: room for three doubles and an int, as the header says.
        unsafe {
            tcb.write([values.tension, values.continuity, values.bias]);
            preset.write(number);
        }
        Ok(V_OK)
    })
}

/// Sets one of the path's ten presets, 0 to 9, for every point that uses it. Each value
/// is from -1 to 1.
/// V_ERR_RANGE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_set_preset(
    path: *mut V_PATH,
    preset: c_int,
    tension: f64,
    continuity: f64,
    bias: f64,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let tcb = Tcb::new(tension, continuity, bias);
        let number = index(preset, "preset")?;
        edit_by(path, |document| {
            let mut presets = document.path().presets;
            *presets
                .get_mut(number)
                .ok_or(OutOfRange::NoPreset(number))? = tcb;
            Ok(Edit::set(At::Path, "presets", presets))
        })
    })
}

/// Gets the tension, continuity and bias of a preset, 0 to 9.
/// V_ERR_RANGE.
/// cbindgen:ptrs-as-arrays=[[tcb; 3]]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_get_preset(
    path: *const V_PATH,
    preset: c_int,
    tcb: *mut f64,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let tcb = Out::array(tcb, "tcb")?;
        let number = index(preset, "preset")?;
        let values = read(path, |document| {
            let preset = document.path().presets.get(number);
            Ok(*preset.ok_or(OutOfRange::NoPreset(number))?)
        })?;
        // SAFETY: room for three doubles, as the header says.
        unsafe { tcb.answer([values.tension, values.continuity, values.bias]) }
    })
}
