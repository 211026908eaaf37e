//! Easing.

use std::ffi::c_int;

use super::border::border;
use super::curve::between;
use super::pointers::{Out, numbered};
use super::status::{Answer, Failure, V_ERR_INTERNAL, V_OK};
use crate::limits::BASE_SPEED;
use crate::path::{Ease, EaseKind};

/// Kinds of easing, see v_ease().
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

/// Gets distance and speed of an ease at t, from 0 to 1: the fraction of the distance
/// covered, 0 to 1, and its derivative.
///
/// kind  V_EASE_...
/// rise, fall  fractions of the time for speeding up and slowing down, not negative,
///     together at most 1
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
