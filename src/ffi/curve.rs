//! The curve in space: lengths and points.

use std::ffi::c_int;

use super::border::border;
use super::path::read;
use super::pointers::{Out, index};
use super::status::{Answer, Failure, V_ERR_INTERNAL};
use super::types::V_PATH;
use crate::document::Document;
use crate::error::Refused;
use crate::path::arc_length::ArcLength;
use crate::path::camera_path::check_base_speed;
use crate::path::hermite::Cubic;

/// The index of a segment given by C.
fn segment(document: &Document, number: c_int) -> Answer<usize> {
    let (segment, count) = (index(number, "segment")?, document.path().segment_count());
    if segment >= count {
        let last = count - 1;
        return Err(Refused::NoSegment { segment, last }.into());
    }
    Ok(segment)
}

/// The cubic of a segment given by C.
fn cubic(document: &Document, number: c_int) -> Answer<Cubic> {
    let segment = segment(document, number)?;
    Ok(document.timeline(|timeline| *timeline.curve(segment))?)
}

/// A number that must be finite and greater than 0.
pub(super) fn positive(given: f64, name: &'static str) -> Answer<()> {
    check_base_speed(given).map_err(|_| Failure::NotPositive { name, given })
}

/// A finite number between 0 and `end`.
pub(super) fn between(value: f64, end: f64, name: &'static str) -> Answer<f64> {
    if (0.0..=end).contains(&value) {
        Ok(value)
    } else if value.is_finite() {
        Err(Failure::NotBetween {
            name,
            given: value,
            from: 0.0,
            end,
        })
    } else {
        Err(Failure::NotFinite { name, given: value })
    }
}

/// ==== The curve: where a path leads, whatever its speed ====
///
/// Gets the length of the whole curve.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_length(path: *const V_PATH, length: *mut f64) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = Out::new(length, "length")?;
        let length = read(path, |document| Ok(document.timeline(|t| t.length())?))?;
        // SAFETY: room for a double, as the header says.
        unsafe { out.answer(length) }
    })
}

/// Gets the length of a segment. Segment n leads from point n to the next; a closed
/// path has one more, from the last point to the first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_segment_length(
    path: *const V_PATH,
    segment: c_int,
    length: *mut f64,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = Out::new(length, "length")?;
        let length = read(path, |document| {
            let segment = self::segment(document, segment)?;
            Ok(document.timeline(|timeline| timeline.segment_length(segment))?)
        })?;
        // SAFETY: room for a double, as the header says.
        unsafe { out.answer(length) }
    })
}

/// Gets the position on a segment at the spline's parameter t, 0 to 1.
/// cbindgen:ptrs-as-arrays=[[xyz; 3]]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_curve_point(
    path: *const V_PATH,
    segment: c_int,
    t: f64,
    xyz: *mut f64,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let xyz = Out::array(xyz, "xyz")?;
        let curve = read(path, |document| cubic(document, segment))?;
        let point = curve.point(between(t, 1.0, "t")?);
        // SAFETY: room for three doubles, as the header says.
        unsafe { xyz.answer(point.to_array()) }
    })
}

/// Gets the position on a segment at the distance s along the curve, from 0 to the
/// segment's length.
/// cbindgen:ptrs-as-arrays=[[xyz; 3]]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_point_at_length(
    path: *const V_PATH,
    segment: c_int,
    s: f64,
    xyz: *mut f64,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let xyz = Out::array(xyz, "xyz")?;
        let (curve, length) = read(path, |document| {
            let segment = self::segment(document, segment)?;
            Ok(document.timeline(|timeline| {
                (*timeline.curve(segment), timeline.segment_length(segment))
            })?)
        })?;
        // The end is as v_path_segment_length() says; the inverse's own measure of the length may
        // differ in the last bit.
        let t = match between(s, length, "s")? {
            s if s == length => 1.0,
            s => ArcLength::new(&curve)?.parameter_at(s),
        };
        let point = curve.point(t);
        // SAFETY: room for three doubles, as the header says.
        unsafe { xyz.answer(point.to_array()) }
    })
}
