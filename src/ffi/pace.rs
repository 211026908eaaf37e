//! Easing, given distances and fixed frames.

use std::ffi::c_int;

use super::border::border;
use super::curve::between;
use super::orientations::{change_own, orientation};
use super::path::{edit, read};
use super::pointers::{ArrayOut, Out, index, numbered, slice};
use super::status::{Answer, Failure, V_ERR_INTERNAL, V_OK};
use super::types::V_PATH;
use crate::document::Edit;
use crate::error::OutOfRange;
use crate::limits::{BASE_SPEED, MAX_DISTANCE_KEYS};
use crate::path::{Ease, EaseKind, Pace, own};

/// ==== Kinds of easing, see v_ease() ====
///
/// V_EASE_SINE       the speed rises and falls as a quarter of a sine
/// V_EASE_PARABOLIC  it rises and falls as a straight line
pub const V_EASE_SINE: c_int = 0;
pub const V_EASE_PARABOLIC: c_int = 1;

const _: () = assert!(
    EaseKind::Sine as c_int == V_EASE_SINE && EaseKind::Parabolic as c_int == V_EASE_PARABOLIC
);

fn ease_kind(kind: c_int) -> Answer<EaseKind> {
    let known = "V_EASE_SINE (0), V_EASE_PARABOLIC (1)";
    numbered(&EaseKind::ALL, kind, "kind", known)
}

fn finite(numbers: [(f64, &'static str); 3]) -> Answer<()> {
    match numbers.into_iter().find(|(given, _)| !given.is_finite()) {
        Some((given, name)) => Err(Failure::NotFinite { name, given }),
        None => Ok(()),
    }
}

/// ==== Speed profile ====
///
/// Gets distance and speed of an ease at t, from 0 to 1: the fraction of the distance
/// covered, 0 to 1, and its derivative.
///
/// kind  V_EASE_...
/// rise, fall  fractions of the time for speeding up and slowing down, not negative,
///     together at most 1
/// V_ERR_ARGUMENT, V_ERR_RANGE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_ease(
    kind: c_int,
    rise: f64,
    fall: f64,
    t: f64,
    distance: *mut f64,
    speed: *mut f64,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let (distance, speed) = (
            Out::optional(distance, "distance")?,
            Out::optional(speed, "speed")?,
        );
        finite([(rise, "rise"), (fall, "fall"), (t, "t")])?;
        let ease = Ease {
            kind: ease_kind(kind)?,
            rise,
            fall,
            cruise: BASE_SPEED,
        };
        ease.check()?;
        let t = between(t, 1.0, "t")?;
        // SAFETY: room for a double each, as the header says.
        unsafe {
            distance.write(ease.distance(t));
            speed.write(ease.slope(t));
        }
        Ok(V_OK)
    })
}

/// Makes a section speed up, cruise and slow down, instead of using the ten speeds of
/// the orientation with which it begins (point, at) or a distance curve.
///
/// kind  V_EASE_..., or -1: back to the ten speeds; the other values are ignored
/// rise, fall  as in v_ease()
/// cruise  the cruising speed, 1 to 100
/// V_ERR_ARGUMENT, V_ERR_RANGE, V_ERR_MEMORY.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_set_ease(
    path: *mut V_PATH,
    point: c_int,
    at: c_int,
    kind: c_int,
    rise: f64,
    fall: f64,
    cruise: f64,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let pace = if kind == -1 {
            Pace::Speeds
        } else {
            finite([(rise, "rise"), (fall, "fall"), (cruise, "cruise")])?;
            Pace::Ease(Ease {
                kind: ease_kind(kind)?,
                rise,
                fall,
                cruise,
            })
        };
        change_own(path, point, at, |own| own.pace = pace)
    })
}

/// Gets the ease of a section, see v_path_set_ease(); kind -1 and zeros if it has none.
/// V_ERR_RANGE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_get_ease(
    path: *const V_PATH,
    point: c_int,
    at: c_int,
    kind: *mut c_int,
    rise: *mut f64,
    fall: *mut f64,
    cruise: *mut f64,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let (kind, rise) = (Out::optional(kind, "kind")?, Out::optional(rise, "rise")?);
        let (fall, cruise) = (
            Out::optional(fall, "fall")?,
            Out::optional(cruise, "cruise")?,
        );
        let ease = read(path, |document| {
            match orientation(document, point, at)?.own.pace {
                Pace::Ease(ease) => Ok(Some(ease)),
                _ => Ok(None),
            }
        })?;
        let number = ease.map_or(-1, |ease| ease.kind as c_int);
        // SAFETY: room for an int and three doubles, as the header says.
        unsafe {
            kind.write(number);
            rise.write(ease.map_or(0.0, |ease| ease.rise));
            fall.write(ease.map_or(0.0, |ease| ease.fall));
            cruise.write(ease.map_or(0.0, |ease| ease.cruise));
        }
        Ok(V_OK)
    })
}

/// Sets the distance as a function of time in a section (point, at), instead of ten
/// speeds or an ease. It runs smoothly through the keys and never goes back.
///
/// time_way  pairs (fraction of the time, of the distance), from 0, 0 to 1, 1, both
///     increasing
/// keys  number of pairs, 2 to 32; 0: back to the ten speeds
/// V_ERR_ARGUMENT, V_ERR_RANGE, V_ERR_MEMORY.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_set_distance(
    path: *mut V_PATH,
    point: c_int,
    at: c_int,
    time_way: *const f64,
    keys: usize,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        const { assert!(MAX_DISTANCE_KEYS == 32) }
        let pace = if keys == 0 {
            Pace::Speeds
        } else if keys > MAX_DISTANCE_KEYS {
            return Err(OutOfRange::DistanceKeys.into());
        } else {
            // SAFETY: that many pairs of doubles, as the header says.
            let numbers = unsafe { slice(time_way, 2 * keys, "time_way") }?;
            own::distance(numbers.as_chunks().0)?
        };
        change_own(path, point, at, |own| own.pace = pace)
    })
}

/// Gets the pairs of v_path_set_distance(), if any; capacity and *keys count pairs.
/// V_ERR_RANGE, V_ERR_SIZE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_get_distance(
    path: *const V_PATH,
    point: c_int,
    at: c_int,
    time_way: *mut f64,
    capacity: usize,
    keys: *mut usize,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let pairs = time_way.cast::<[f64; 2]>();
        let out = ArrayOut::new(pairs, capacity, keys, ["time_way", "keys"])?;
        read(path, |document| {
            let given: &[[f64; 2]] = match &orientation(document, point, at)?.own.pace {
                Pace::Distance(keys) => keys,
                _ => &[],
            };
            // SAFETY: room for that many pairs and a size_t, as the header says.
            unsafe {
                if out.wants(given.len())? {
                    out.room(given.len())?.copy_from_slice(given);
                }
                out.answer(given.len())
            }
        })
    })
}

/// ==== Fixed frames ====
///
/// Fixes the number of frames of the section that begins with an orientation; 0: it
/// follows from the length. A section in which nothing changes always has 0 frames. A
/// path has at most 100000000.
/// V_ERR_RANGE, V_ERR_LIMIT, V_ERR_MEMORY.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_set_frames(
    path: *mut V_PATH,
    point: c_int,
    at: c_int,
    frames: usize,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let frames = u32::try_from(frames).map_err(|_| OutOfRange::SectionFrames)?;
        change_own(path, point, at, |own| own.frames = frames)
    })
}

/// Gets the fixed frames of a section, see v_path_set_frames().
/// V_ERR_RANGE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_get_frames(
    path: *const V_PATH,
    point: c_int,
    at: c_int,
    frames: *mut usize,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = Out::new(frames, "frames")?;
        let frames = read(path, |document| {
            Ok(orientation(document, point, at)?.own.frames as usize)
        })?;
        // SAFETY: room for a size_t, as the header says.
        unsafe { out.answer(frames) }
    })
}

/// Sets whether v_path_fit_frames() keeps the frames of the section that begins with an
/// orientation (not 0) or not (0).
/// V_ERR_RANGE, V_ERR_MEMORY.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_set_frames_locked(
    path: *mut V_PATH,
    point: c_int,
    at: c_int,
    locked: c_int,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        change_own(path, point, at, |own| own.locked = locked != 0)
    })
}

/// Gets whether the frames of a section are locked: 1 or 0.
/// V_ERR_RANGE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_get_frames_locked(
    path: *const V_PATH,
    point: c_int,
    at: c_int,
    locked: *mut c_int,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = Out::new(locked, "locked")?;
        let locked = read(path, |document| {
            Ok(orientation(document, point, at)?.own.locked)
        })?;
        // SAFETY: room for an int, as the header says.
        unsafe { out.answer(c_int::from(locked)) }
    })
}

/// Fixes the frames of all moving sections between two points, so that it takes exactly
/// frames from the first pose at first_point to the last pose at last_point, holds
/// included. 0 and the last point stand for the whole path, if closed with the way back
/// to the first. On a closed path first_point may be after last_point.
///
/// Sections share the frames in proportion to those they have, at least one each; locked
/// ones keep theirs. If frames is too small, v_last_error() returns the least.
/// V_ERR_RANGE, V_ERR_MEMORY.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_fit_frames(
    path: *mut V_PATH,
    first_point: c_int,
    last_point: c_int,
    frames: usize,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let (first, last) = (
            index(first_point, "first_point")?,
            index(last_point, "last_point")?,
        );
        let fit = Edit::FitFrames {
            first,
            last,
            frames,
        };
        edit(path, fit)
    })
}
