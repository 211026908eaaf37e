//! Free-form deformation: a Bézier volume of degree 3 in each direction.

use glam::DVec3;

use super::bounds::Bounds;
use super::formula::LATTICE;

/// The identity: x, y, z of each control point in the box's coordinates, first index fastest.
#[must_use]
pub fn identity_lattice() -> [f64; 3 * LATTICE] {
    let thirds = [-1.0, -1.0 / 3.0, 1.0 / 3.0, 1.0];
    std::array::from_fn(|at| {
        let (point, axis) = (at / 3, at % 3);
        thirds[(point >> (2 * axis)) & 3]
    })
}

/// Bernstein's polynomials of degree 3 at (u + 1)/2.
fn bernstein(u: f64) -> [f64; 4] {
    let (t, s) = ((1.0 + u) / 2.0, (1.0 - u) / 2.0);
    [s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t]
}

pub(super) fn apply(bounds: &Bounds, lattice: &[f64], points: &mut [DVec3]) {
    for point in points {
        if !bounds.contains(*point) {
            continue;
        }
        let [i, j, k] = [0, 1, 2].map(|axis| bernstein(bounds.coordinate(*point, axis)));
        let mut sum = DVec3::ZERO;
        for (at, control) in lattice.chunks_exact(3).enumerate() {
            let weight = i[at & 3] * j[(at >> 2) & 3] * k[at >> 4];
            sum += weight * DVec3::from_slice(control);
        }
        for axis in 0..3 {
            bounds.place(point, axis, sum[axis]);
        }
    }
}
