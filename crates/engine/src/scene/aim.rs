//! Cameras and lights that look at a node.

use glam::{DQuat, DVec3};

use crate::math::orientation::{
    POLE, axes_with_yaw, level_axes, quaternion_from_view, unit, up_from_roll,
};
use crate::math::quaternion::slerp_shortest;
use crate::path::{Space, Up};

/// Within this distance, in units of `half_size`, there is no direction (`docs/theory/path.md`, tracked
/// sections).
const NEAR: f64 = 1e-9;

pub(super) fn direction(eye: DVec3, target: DVec3, space: Space) -> Option<DVec3> {
    let offset = target - eye;
    (offset.abs().max_element() > NEAR * space.half_size && offset.is_finite())
        .then(|| unit(offset))
}

/// Whether a view is so steep that it has no yaw.
pub(super) fn steep(view: DVec3, up: Up) -> bool {
    let view = up.upright(view);
    view.x.hypot(view.z) < POLE
}

/// Looks along `view` with the space's up, turned by `roll` (radians); at a pole with `last`'s yaw.
pub(super) fn aimed(view: DVec3, last: Option<DVec3>, roll: f64, axes: Up) -> DQuat {
    let upright = axes.upright(view);
    let up = match last.map(|last| axes.upright(last)) {
        Some(last) if steep(view, axes) => {
            let h = last.x.hypot(last.z);
            let (u, v) = axes_with_yaw(upright, last.x / h, last.z / h);
            let (sin, cos) = roll.sin_cos();
            v * cos - u * sin
        }
        _ => up_from_roll(upright, roll),
    };
    debug_assert!(level_axes(upright).0.is_finite());
    quaternion_from_view(view, axes.world(up))
}

pub(super) fn blend(own: DQuat, aimed: DQuat, weight: f64) -> DQuat {
    if weight <= 0.0 {
        own
    } else if weight >= 1.0 {
        aimed
    } else {
        slerp_shortest(own, aimed, weight)
    }
}
