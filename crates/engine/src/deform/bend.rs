//! Bending in the plane of two axes.

use glam::DVec3;

use super::bounds::Bounds;

/// Bends the middle line, keeping its length, by `angle` (radians) about `axis`; straight beyond.
pub(super) fn by_angle(bounds: &Bounds, axis: usize, angle: f64, points: &mut [DVec3]) {
    let (a, b) = ((axis + 1) % 3, (axis + 2) % 3);
    for point in points {
        let (u, v) = (bounds.coordinate(*point, a), bounds.coordinate(*point, b));
        let inside = u.clamp(-1.0, 1.0);
        let phi = angle * inside / 2.0;
        let (sin, cos) = phi.sin_cos();
        // The arc's end by sin φ/φ and (1−cos φ)/φ, which have no 0/0.
        let half = sinc(phi / 2.0);
        let (along, aside) = (inside * sinc(phi), inside * half * half * phi / 2.0);
        let beyond = u - inside;
        bounds.place(point, a, along - v * sin + beyond * cos);
        bounds.place(point, b, aside + v * cos + beyond * sin);
    }
}

fn sinc(x: f64) -> f64 {
    // The next term of the series is below half a unit in the last place.
    if x.abs() < 1e-4 {
        1.0 - x * x / 6.0
    } else {
        x.sin() / x
    }
}

/// The lecture's bend: u becomes an angle (radians, φ_min…φ_max) about `centre`, v − v0 the radius.
pub(super) fn polar(
    bounds: &Bounds,
    [a, b]: [usize; 2],
    centre: [f64; 2],
    [from, to]: [f64; 2],
    points: &mut [DVec3],
) {
    for point in points {
        let u = bounds.coordinate(*point, a).clamp(-1.0, 1.0);
        let radius = bounds.coordinate(*point, b) - centre[1];
        let (sin, cos) = ((1.0 - u) / 2.0 * from + (1.0 + u) / 2.0 * to).sin_cos();
        bounds.place(point, a, radius * cos + centre[0]);
        bounds.place(point, b, radius * sin + centre[1]);
    }
}
