//! Orientations as quaternions, angles and pairs of vectors (thesis 4.3, 4.4.5).
//!
//! Conventions: q = q_yaw(y)·q_pitch(x)·q_roll(z); positive pitch looks down. A camera that is not
//! turned looks along (0, 0, 1) with (0, 1, 0) up.

use glam::{DQuat, DVec3};

/// Below this hypot(VPN.x, VPN.z) the yaw has no meaning and is taken as 0.
pub const POLE: f64 = 1e-12;

/// `v` with length 1, even where its square would over- or underflow. `v` must not be zero.
#[must_use]
pub fn unit(v: DVec3) -> DVec3 {
    let scaled = v / v.abs().max_element();
    scaled / scaled.length()
}

/// The camera's x and y axes (U0 and V0) for a unit view direction without roll.
#[must_use]
pub fn level_axes(view: DVec3) -> (DVec3, DVec3) {
    let h = view.x.hypot(view.z);
    let (sin_yaw, cos_yaw) = if h < POLE {
        (0.0, 1.0)
    } else {
        (view.x / h, view.z / h)
    };
    axes_with_yaw(view, sin_yaw, cos_yaw)
}

/// As [`level_axes`] with a given yaw, for use at a pole.
#[must_use]
pub fn axes_with_yaw(view: DVec3, sin_yaw: f64, cos_yaw: f64) -> (DVec3, DVec3) {
    let h = view.x.hypot(view.z);
    let u = DVec3::new(cos_yaw, 0.0, -sin_yaw);
    let v = DVec3::new(-view.y * sin_yaw, h, -view.y * cos_yaw);
    (u, v)
}

/// Up vector for a unit view direction and a roll in radians.
#[must_use]
pub fn up_from_roll(view: DVec3, roll: f64) -> DVec3 {
    let (u, v) = level_axes(view);
    let (sin, cos) = roll.sin_cos();
    v * cos - u * sin
}

/// Roll in radians, in (−π, π], of an up vector perpendicular to `view`.
#[must_use]
pub fn roll_from_up(view: DVec3, up: DVec3) -> f64 {
    let (u, v) = level_axes(view);
    let roll = (-up.dot(u)).atan2(up.dot(v));
    if roll == -std::f64::consts::PI {
        std::f64::consts::PI
    } else {
        roll
    }
}

/// Degrees brought into (−180, 180]; exact where they already lie there.
#[must_use]
pub fn wrap_degrees(degrees: f64) -> f64 {
    if degrees > -180.0 && degrees <= 180.0 {
        return degrees;
    }
    let wrapped = degrees.rem_euclid(360.0);
    if wrapped > 180.0 {
        wrapped - 360.0
    } else {
        wrapped
    }
}

/// The quaternion that turns z into `view` and y into `up` (unit, perpendicular); its w may be < 0.
#[must_use]
pub fn quaternion_from_view(view: DVec3, up: DVec3) -> DQuat {
    // Shepperd's method: divide by the largest component, never by a small one.
    let right = up.cross(view);
    let (x, y, z) = (right, up, view);
    let trace = x.x + y.y + z.z;
    let four = if trace >= x.x.max(y.y).max(z.z) {
        DQuat::from_xyzw(y.z - z.y, z.x - x.z, x.y - y.x, 1.0 + trace)
    } else if x.x >= y.y && x.x >= z.z {
        DQuat::from_xyzw(1.0 + x.x - y.y - z.z, x.y + y.x, z.x + x.z, y.z - z.y)
    } else if y.y >= z.z {
        DQuat::from_xyzw(x.y + y.x, 1.0 - x.x + y.y - z.z, y.z + z.y, z.x - x.z)
    } else {
        DQuat::from_xyzw(z.x + x.z, y.z + z.y, 1.0 - x.x - y.y + z.z, x.y - y.x)
    };
    four.normalize()
}

/// The quaternion of a view given by direction and roll in radians.
#[must_use]
pub fn quaternion_from_roll(view: DVec3, roll: f64) -> DQuat {
    quaternion_from_view(view, up_from_roll(view, roll))
}

/// View direction and up of a quaternion that is not zero: unit and perpendicular to rounding.
#[must_use]
pub fn view_from_quaternion(q: DQuat) -> (DVec3, DVec3) {
    let (x, y, z, w) = (q.x, q.y, q.z, q.w);
    let scale = 1.0 / (x * x + y * y + z * z + w * w);
    let view = DVec3::new(
        2.0 * (x * z + w * y),
        2.0 * (y * z - w * x),
        w * w - x * x - y * y + z * z,
    );
    let up = DVec3::new(
        2.0 * (x * y - w * z),
        w * w - x * x + y * y - z * z,
        2.0 * (y * z + w * x),
    );
    (view * scale, up * scale)
}
