//! Conversion between absolute and relative targets (thesis A.4.2) that keeps the view.

use glam::DVec3;

use crate::error::{Refused, Result};
use vides_engine::path::{Space, Target};

/// 2⁻¹³: a target closer than this times the camera's largest coordinate would lose more than four
/// of its direction's sixteen digits when position and offset are added.
const NEAR: f64 = 1.0 / 8192.0;

/// The target as seen from `position`, made absolute or relative.
///
/// Relative: the offset is the engine's own difference, so the view keeps every bit. Absolute: the
/// view keeps about 12 digits; to that end a target too near is moved out along the view, and one
/// beyond the largest coordinate is moved in. `ErrorKind::Range` if none is within it.
pub(super) fn switched(
    target: Target,
    position: DVec3,
    absolute: bool,
    space: Space,
) -> Result<Target> {
    match (target, absolute) {
        (Target::Absolute(_), false) => {
            let offset = target.offset_from(position);
            // Opposite corners are too far apart for an offset. Halving keeps the direction exact.
            let fits = space.check_offset(offset).is_ok();
            Ok(Target::Relative(if fits { offset } else { offset * 0.5 }))
        }
        (Target::Relative(offset), true) => {
            Ok(Target::Absolute(seen_along(offset, position, space)?))
        }
        (same, _) => Ok(same),
    }
}

/// A point within the world seen from `position` along `offset`, at its end if possible.
fn seen_along(offset: DVec3, position: DVec3, space: Space) -> Result<DVec3> {
    let least = position.abs().max_element() * NEAR;
    let mut offset = offset;
    while offset.abs().max_element() < least {
        offset *= 2.0;
    }
    let mut target = position + offset;
    while space.check_place(target).is_err() {
        offset *= 0.5;
        if offset.abs().max_element() < least {
            return Err(Refused::TargetTooFar.into());
        }
        target = position + offset;
    }
    Ok(target)
}
