//! The toolbox: splines through quaternions, the speed curve.

use std::ffi::c_int;

use glam::DQuat;

use super::border::border;
use super::curve::between;
use super::pointers::most;
use super::pointers::{Out, check, how_many, optional, read_array, read_optional, slice};
use super::quaternions::{from_c, to_c};
use super::status::{Answer, Failure, V_ERR_INTERNAL, V_OK};
use crate::error::vec_with_room;
use crate::limits;
use crate::path::Tcb;
use crate::path::quaternion_spline;
use crate::path::speed_curve::{CurveEnd, SpeedCurve};

/// Keys and their times from C.
///
/// # Safety
/// `keys` and `times` are NULL or point to `count`×4 and `count` doubles.
unsafe fn keys_and_times<'a>(
    keys: *const f64,
    times: *const f64,
    count: c_int,
) -> Answer<(Vec<DQuat>, &'a [f64])> {
    check(keys, "keys")?;
    check(times, "key_times")?;
    let count = how_many(count, "count")?;
    most(count, limits::MAX_KEYS, "count")?;
    // SAFETY: as required of the caller.
    let (keys, times) = unsafe {
        (
            slice(keys.cast::<[f64; 4]>(), count, "keys")?,
            slice(times, count, "key_times")?,
        )
    };
    let mut converted = vec_with_room(count)?;
    converted.extend(keys.iter().map(|&key| from_c(key)));
    Ok((converted, times))
}

/// Gets the quaternion at the time when on a smooth curve through orientations (Barry
/// and Goldman 1988), whose ends are made by reflection.
///
/// keys  count quaternions, four doubles each
/// key_times  the time of each key, strictly increasing
/// count  at least 2
/// when  from the first time to the last
/// cbindgen:ptrs-as-arrays=[[q; 4]]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_quat_spline(
    keys: *const f64,
    key_times: *const f64,
    count: c_int,
    when: f64,
    q: *mut f64,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = Out::array(q, "q")?;
        // SAFETY: as many doubles as the header says.
        let (keys, times) = unsafe { keys_and_times(keys, key_times, count) }?;
        let q = quaternion_spline::barry_goldman(&keys, times, when)?;
        // SAFETY: room for four doubles, as the header says.
        unsafe { out.answer(to_c(q)) }
    })
}

/// Like v_quat_spline(), on a cubic spherical curve. tcb has tension, continuity and
/// bias of each key, from -1 to 1; NULL: all zero.
/// cbindgen:ptrs-as-arrays=[[q; 4]]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_quat_tcb_spline(
    keys: *const f64,
    key_times: *const f64,
    tcb: *const f64,
    count: c_int,
    when: f64,
    q: *mut f64,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = Out::array(q, "q")?;
        // SAFETY: as many doubles as the header says.
        let (keys, times) = unsafe { keys_and_times(keys, key_times, count) }?;
        let tcb = optional(tcb.cast::<[f64; 3]>(), |tcb| {
            // SAFETY: as many doubles as the header says.
            let values = unsafe { slice(tcb, keys.len(), "tcb") }?;
            let mut parameters = vec_with_room(keys.len())?;
            parameters.extend(values.iter().map(|&[t, c, b]| Tcb::new(t, c, b)));
            Ok(parameters)
        })?;
        let q = quaternion_spline::tcb(&keys, times, tcb.as_deref(), when)?;
        // SAFETY: room for four doubles, as the header says.
        unsafe { out.answer(to_c(q)) }
    })
}

/// Gets, at u from 0 to 1, the speed and the fraction of the distance on the speed
/// curve of a section: ten speeds from 1 to 100 at u = 0, 1/9, ... 1, smoothly
/// joined, never leaving 1 to 100. (On a path, where the adjacent speed equals that
/// of the section, the acceleration is joined, too.)
///
/// before, after  the adjacent speed of the section before and after; NULL: no
///     section
/// cbindgen:ptrs-as-arrays=[[speed; 10]]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_speed_curve(
    speed: *const f64,
    before: *const f64,
    after: *const f64,
    u: f64,
    speed_at_u: *mut f64,
    distance_fraction: *mut f64,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let (at_u, fraction) = (
            Out::optional(speed_at_u, "speed_at_u")?,
            Out::optional(distance_fraction, "distance_fraction")?,
        );
        // SAFETY: ten doubles, and one each if not NULL, as the header says.
        let (speed, before, after) = unsafe {
            (
                read_array(speed, "speed")?,
                read_optional(before, "before")?,
                read_optional(after, "after")?,
            )
        };
        let u = between(u, 1.0, "u")?;
        for value in speed {
            check_speed(value, "speed")?;
        }
        for (value, name) in [(before, "before"), (after, "after")] {
            value.map_or(Ok(()), |value| check_speed(value, name))?;
        }
        let curve = SpeedCurve::new(&speed, [before, after].map(CurveEnd::from));
        // SAFETY: room for a double each, as the header says.
        unsafe {
            at_u.write(curve.speed(u));
            fraction.write(curve.fraction(u));
        }
        Ok(V_OK)
    })
}

fn check_speed(value: f64, name: &'static str) -> Answer<()> {
    if !value.is_finite() {
        return Err(Failure::NotFinite { name, given: value });
    }
    if !(limits::MIN_SPEED..=limits::MAX_SPEED).contains(&value) {
        return Err(Failure::NotBetween {
            name,
            given: value,
            from: limits::MIN_SPEED,
            end: limits::MAX_SPEED,
        });
    }
    Ok(())
}
