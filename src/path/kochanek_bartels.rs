//! Kochanek–Bartels splines (thesis 3.6.2; Kochanek and Bartels 1984), uniform
//! knots, quadratic ends. The sign of the bias is the 1984 paper's.

use glam::DVec3;

use super::camera_path::{CameraPath, Tcb};
use super::hermite::Cubic;

/// The tangent with which the curve leaves a point (R1 of 3.6.2): `before`
/// and `after` are the chords from the previous and to the next point.
#[must_use]
pub fn outgoing_tangent(tcb: Tcb, before: DVec3, after: DVec3) -> DVec3 {
    let Tcb {
        tension,
        continuity,
        bias,
    } = tcb;
    let loose = (1.0 - tension) / 2.0;
    loose * (1.0 + continuity) * (1.0 + bias) * before
        + loose * (1.0 - continuity) * (1.0 - bias) * after
}

/// The tangent with which the curve reaches a point (R2 of 3.6.2).
#[must_use]
pub fn incoming_tangent(tcb: Tcb, before: DVec3, after: DVec3) -> DVec3 {
    let Tcb {
        tension,
        continuity,
        bias,
    } = tcb;
    let loose = (1.0 - tension) / 2.0;
    loose * (1.0 - continuity) * (1.0 + bias) * before
        + loose * (1.0 + continuity) * (1.0 - bias) * after
}

/// The tangent at an end: that of the parabola through the three points
/// nearest to it, (−3P₀+4P₁−P₂)/2, loosened by the tension alone (SPEC 2.1).
/// `near` and `far` are the chords P₁−P₀ and P₂−P₁, both as the curve runs at
/// a start; at the end of a path they are Pₙ−Pₙ₋₁ and Pₙ₋₁−Pₙ₋₂.
#[must_use]
pub fn end_tangent(tension: f64, near: DVec3, far: DVec3) -> DVec3 {
    (1.0 - tension) * (1.5 * near - 0.5 * far)
}

/// The curve of one segment of a path.
///
/// # Panics
/// If there is no such segment.
#[must_use]
pub fn segment(path: &CameraPath, segment: usize) -> Cubic {
    let n = path.points.len();
    let (i, j) = (segment, (segment + 1) % n);
    let at = |k: usize| path.points[k].position;
    let chord = at(j) - at(i);
    let (from, to) = (path.tcb(i), path.tcb(j));
    let before = if i > 0 {
        Some(at(i) - at(i - 1))
    } else if path.closed {
        Some(at(0) - at(n - 1))
    } else {
        None
    };
    let after = if j + 1 < n {
        Some(at(j + 1) - at(j))
    } else if path.closed {
        Some(at((j + 1) % n) - at(j))
    } else {
        None
    };
    let leave = match (before, after) {
        (Some(before), _) => outgoing_tangent(from, before, chord),
        (None, Some(after)) => end_tangent(from.tension, chord, after),
        (None, None) => (1.0 - from.tension) * chord,
    };
    let reach = match (after, before) {
        (Some(after), _) => incoming_tangent(to, chord, after),
        (None, Some(before)) => end_tangent(to.tension, chord, before),
        (None, None) => (1.0 - to.tension) * chord,
    };
    Cubic::hermite(at(i), at(j), leave, reach)
}
