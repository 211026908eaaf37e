//! Unit quaternions as points on the sphere S³ (thesis 4.4; Shoemake 1985).
//! Angles here are angles on S³: half the angle of the rotation.

use std::ops::RangeInclusive;

use glam::{DQuat, DVec3, DVec4};

/// Below this angle an arc is as good as straight.
const STRAIGHT: f64 = 1e-12;

/// Above this angle the weights of an arc are more than seven times their sum.
const WIDE: f64 = 3.0;

/// Outside this range of `t` the weights no longer give a result of length 1.
const NEARBY: RangeInclusive<f64> = -2.0..=3.0;

/// Keys whose |q_i·q_{i+1}| is at most this are half a turn apart: both ways are equally long.
pub const HALF_TURN: f64 = 1e-12;

/// The angle between two unit quaternions on S³, in [0, π]; accurate at both ends, unlike acos.
#[must_use]
pub fn angle(a: DQuat, b: DQuat) -> f64 {
    let (a, b) = (DVec4::from(a), DVec4::from(b));
    2.0 * (a - b).length().atan2((a + b).length())
}

/// Interpolates along the great arc from `a` to `b` without a test of signs, at any finite `t`.
/// Antipodes have no arc and give `a`.
#[must_use]
pub fn slerp(a: DQuat, b: DQuat, t: f64) -> DQuat {
    let theta = angle(a, b);
    let sin = theta.sin();
    if sin < STRAIGHT && theta > 1.0 {
        return a;
    }
    if theta > WIDE || !NEARBY.contains(&t) {
        return turned(a, b, t * theta);
    }
    if theta < STRAIGHT {
        return a * (1.0 - t) + b * t;
    }
    a * (((1.0 - t) * theta).sin() / sin) + b * ((t * theta).sin() / sin)
}

/// `a` turned by an angle on S³ towards `b`: of length 1 whatever the angle, also where weights
/// would magnify the rounding: the two nearly equal or nearly opposite.
fn turned(a: DQuat, b: DQuat, angle: f64) -> DQuat {
    let across = b - a * a.dot(b);
    if across.length() == 0.0 {
        return a;
    }
    let across = across.normalize();
    let across = (across - a * a.dot(across)).normalize();
    // An angle that overflowed has no meaning, but must be finite for `sin_cos`.
    let (sin, cos) = angle.clamp(f64::MIN, f64::MAX).sin_cos();
    a * cos + across * sin
}

/// As [`slerp`], by the shorter way: `b` and −`b` are the same orientation.
#[must_use]
pub fn slerp_shortest(a: DQuat, b: DQuat, t: f64) -> DQuat {
    slerp(a, if a.dot(b) < 0.0 { -b } else { b }, t)
}

/// exp of the pure quaternion (0, v): a rotation by 2·|v| about v.
#[must_use]
pub fn exp(v: DVec3) -> DQuat {
    let length = v.length();
    let (sin, cos) = length.sin_cos();
    let v = if length > 0.0 { v * (sin / length) } else { v };
    DQuat::from_xyzw(v.x, v.y, v.z, cos)
}

/// The inverse of [`exp`] for a unit quaternion: |result| in [0, π].
#[must_use]
pub fn log(q: DQuat) -> DVec3 {
    let v = DVec3::new(q.x, q.y, q.z);
    let length = v.length();
    if length > 0.0 {
        v * (length.atan2(q.w) / length)
    } else {
        v
    }
}

/// `q` or −`q`, whichever continues from `before` by the shorter way. Half a turn apart, which the
/// flag tells, the one whose rotation vector in the camera's own frame has a positive first
/// non-zero component, in the order y, x, z (`docs/theory/path.md`, orientation curve).
#[must_use]
pub fn continue_sign(before: DQuat, q: DQuat) -> (DQuat, bool) {
    let dot = before.dot(q);
    if dot.abs() > HALF_TURN {
        return (if dot < 0.0 { -q } else { q }, false);
    }
    let relative = before.conjugate() * q;
    for component in [relative.y, relative.x, relative.z] {
        if component.abs() > HALF_TURN {
            return (if component < 0.0 { -q } else { q }, true);
        }
    }
    (q, true)
}

/// Gives each key the sign that continues the one before.
pub fn continue_signs(keys: &mut [DQuat]) {
    for k in 1..keys.len() {
        keys[k] = continue_sign(keys[k - 1], keys[k]).0;
    }
}
