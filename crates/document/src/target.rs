//! Absolute and relative targets (thesis A.4.2): the same view either way.

use glam::DVec3;

use crate::error::{Refused, Result};
use crate::path::{Space, Target};

/// A target closer to the camera than this, measured in the camera's largest
/// coordinate, would lose more than four of the sixteen digits of its
/// direction when position and offset are added. 2⁻¹³.
const NEAR: f64 = 1.0 / 8192.0;

/// The same target as seen from `position`, absolute or relative as wanted.
///
/// Relative: the offset is the difference as the engine itself forms it, so
/// the view keeps every bit. Absolute: the view keeps about 12 digits; for
/// that, a target too near for its coordinates is moved out along the view,
/// and one that would lie beyond the largest coordinate is moved in.
///
/// # Errors
/// `ErrorKind::Range` if no target within the largest coordinate is seen in
/// that direction.
pub(super) fn switched(
    target: Target,
    position: DVec3,
    absolute: bool,
    space: Space,
) -> Result<Target> {
    match (target, absolute) {
        (Target::Absolute(_), false) => {
            let offset = target.offset_from(position);
            // Two opposite corners of the world are further apart than an
            // offset may be long. A power of two keeps its direction exactly.
            let fits = space.check_offset(offset).is_ok();
            Ok(Target::Relative(if fits { offset } else { offset * 0.5 }))
        }
        (Target::Relative(offset), true) => {
            Ok(Target::Absolute(seen_along(offset, position, space)?))
        }
        (same, _) => Ok(same),
    }
}

/// A point of the world that is seen from `position` in the direction of
/// `offset`, at its end if possible.
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
