//! Carries an up vector along a changing direction without turning it about that: double reflection
//! (Wang, Jüttler, Zheng, Liu, *Computation of Rotation Minimizing Frames*, 2008).
//!
//! Their curve is here the one that has the direction as its tangent; the chord of a step comes by
//! Simpson's rule. The error of a step is of fifth order, that of the whole way of fourth.

use glam::DVec3;

/// Lengths below this count as zero.
const NOTHING: f64 = 1e-12;

/// `v` made perpendicular to a unit `view` and unit; `None` where the two are parallel.
#[must_use]
pub fn perpendicular(v: DVec3, view: DVec3) -> Option<DVec3> {
    let part = v - v.dot(view) * view;
    if !(part.length() > NOTHING * v.length()) {
        return None;
    }
    // Once more, for the digits lost to a long parallel part.
    let part = part.normalize();
    Some((part - part.dot(view) * view).normalize())
}

/// One step: carries `up` from the unit direction `from` to `to`. `chord`, of any length, leads
/// along the curve that has them as tangents.
#[must_use]
pub fn step(up: DVec3, from: DVec3, to: DVec3, chord: DVec3) -> DVec3 {
    let reflect = |v: DVec3, n: DVec3| v - (2.0 * v.dot(n) / n.length_squared()) * n;
    let moved = if chord.length() > NOTHING {
        let second = to - reflect(from, chord);
        if second.length() > NOTHING {
            reflect(reflect(up, chord), second)
        } else {
            up
        }
    } else {
        up
    };
    perpendicular(moved, to).unwrap_or(up)
}

/// `up` under the shortest rotation between two directions; unchanged between opposite ones.
#[must_use]
pub fn shortest(up: DVec3, from: DVec3, to: DVec3) -> DVec3 {
    step(up, from, to, from + to)
}

/// Simpson's chord over a step, from its directions at both ends and in the middle.
#[must_use]
pub fn chord(from: DVec3, middle: DVec3, to: DVec3) -> DVec3 {
    from + 4.0 * middle + to
}

/// The signed angle about `view` from one perpendicular unit vector to another, in (−π, π].
#[must_use]
pub fn signed_angle(from: DVec3, to: DVec3, view: DVec3) -> f64 {
    view.dot(from.cross(to)).atan2(from.dot(to))
}

/// `up` turned about `view`, to which it is perpendicular.
#[must_use]
pub fn turned(up: DVec3, view: DVec3, angle: f64) -> DVec3 {
    let (sin, cos) = angle.sin_cos();
    up * cos + view.cross(up) * sin
}
