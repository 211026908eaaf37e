//! Hermite curves (thesis 3.5.1): a cubic from its ends and its end tangents.

use glam::DVec3;

use crate::math::orientation::unit;

/// A basis matrix M by rows: P(t) = \[t³ t² t 1\]·M·G, where G are the four
/// points or tangents that the kind of curve is made from (thesis 3.5).
pub type BasisMatrix = [[f64; 4]; 4];

/// M_H of 3.5.1, for G = (P₁, P₂, R₁, R₂): ends, then end tangents.
pub const HERMITE: BasisMatrix = [
    [2.0, -2.0, 1.0, 1.0],
    [-3.0, 3.0, -2.0, -1.0],
    [0.0, 0.0, 1.0, 0.0],
    [1.0, 0.0, 0.0, 0.0],
];

/// A cubic curve in space: P(t) = ((a·t + b)·t + c)·t + d, t in [0, 1].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cubic {
    /// Coefficient of t³.
    pub a: DVec3,
    /// Coefficient of t².
    pub b: DVec3,
    /// Coefficient of t: the tangent at t = 0.
    pub c: DVec3,
    /// P(0).
    pub d: DVec3,
    /// P(1), kept so that the curve ends there to the last bit.
    pub end: DVec3,
}

impl Cubic {
    /// The curve from `p0` to `p1` with tangents `r0` and `r1` (M_H of 3.5.1).
    #[must_use]
    pub fn hermite(p0: DVec3, p1: DVec3, r0: DVec3, r1: DVec3) -> Self {
        let chord = p1 - p0;
        Self {
            a: r0 + r1 - 2.0 * chord,
            b: 3.0 * chord - 2.0 * r0 - r1,
            c: r0,
            d: p0,
            end: p1,
        }
    }

    /// The curve of a basis matrix and its geometry vector: the coefficients are the rows of M·G.
    /// Its end is right to rounding only, that of [`Cubic::hermite`] to the last bit.
    #[must_use]
    pub fn from_basis(matrix: &BasisMatrix, geometry: [DVec3; 4]) -> Self {
        let [a, b, c, d] = matrix.map(|row| {
            let [p, q, r, s] = geometry;
            p * row[0] + q * row[1] + r * row[2] + s * row[3]
        });
        Self {
            a,
            b,
            c,
            d,
            end: a + b + c + d,
        }
    }

    /// The point at `t`; exact at both ends.
    #[must_use]
    pub fn point(&self, t: f64) -> DVec3 {
        if t == 1.0 {
            return self.end;
        }
        ((self.a * t + self.b) * t + self.c) * t + self.d
    }

    /// The first derivative at `t`.
    #[must_use]
    pub fn derivative(&self, t: f64) -> DVec3 {
        (3.0 * self.a * t + 2.0 * self.b) * t + self.c
    }

    /// The second derivative at `t`.
    #[must_use]
    pub fn second_derivative(&self, t: f64) -> DVec3 {
        6.0 * self.a * t + 2.0 * self.b
    }
}

/// A tangent shorter than this share of the curve's size counts as none.
pub(super) const NO_TANGENT: f64 = 1e-12;

/// Direction of movement at an end: the tangent, or else the next derivative that is not zero.
pub(super) fn end_direction(curve: &Cubic, at_end: bool) -> Option<DVec3> {
    let (t, inwards) = if at_end { (1.0, -1.0) } else { (0.0, 1.0) };
    let size = NO_TANGENT * (curve.a.length() + curve.b.length() + curve.c.length());
    let derivatives = [
        curve.derivative(t),
        inwards * curve.second_derivative(t),
        6.0 * curve.a,
    ];
    derivatives
        .into_iter()
        .find(|derivative| derivative.length() > size)
        .map(unit)
}

#[cfg(test)]
mod tests {
    use glam::DMat4;
    use proptest::prelude::*;

    use super::*;
    use crate::path::test_support::{assert_near, map, product, vector};

    #[test]
    fn the_matrix_inverts_the_conditions() {
        // Rows: P(0), P(1), P′(0), P′(1) of t³, t², t, 1.
        let conditions = [
            [0.0, 0.0, 0.0, 1.0],
            [1.0, 1.0, 1.0, 1.0],
            [0.0, 0.0, 1.0, 0.0],
            [3.0, 2.0, 1.0, 0.0],
        ];
        let identity = DMat4::IDENTITY.to_cols_array_2d();
        assert_eq!(product(&conditions, &HERMITE), identity);
    }

    proptest! {
        #[test]
        fn starts_and_ends_as_asked(g in prop::array::uniform4(vector(10.0))) {
            let [p0, p1, r0, r1] = g;
            let curve = Cubic::hermite(p0, p1, r0, r1);
            prop_assert_eq!(curve.point(0.0), p0);
            prop_assert_eq!(curve.point(1.0), p1);
            prop_assert_eq!(curve.derivative(0.0), r0);
            assert_near(curve.derivative(1.0), r1, 1e-12);
        }

        /// The Hermite polynomials of 3.5.1, written out.
        #[test]
        fn is_the_sum_of_the_hermite_polynomials(
            g in prop::array::uniform4(vector(10.0)), t in -1.0..2.0f64,
        ) {
            let [p0, p1, r0, r1] = g;
            let (t2, t3) = (t * t, t * t * t);
            let want = p0 * (2.0 * t3 - 3.0 * t2 + 1.0)
                + p1 * (-2.0 * t3 + 3.0 * t2)
                + r0 * (t3 - 2.0 * t2 + t)
                + r1 * (t3 - t2);
            assert_near(Cubic::hermite(p0, p1, r0, r1).point(t), want, 1e-12);
            assert_near(Cubic::from_basis(&HERMITE, g).point(t), want, 1e-12);
        }

        #[test]
        fn derivatives_are_those_of_the_point(
            g in prop::array::uniform4(vector(10.0)), t in 0.1..0.9f64,
        ) {
            // Central differences of a cubic are exact but for its t³ term.
            let curve = Cubic::from_basis(&HERMITE, g);
            let h = 1e-3;
            let first = (curve.point(t + h) - curve.point(t - h)) / (2.0 * h) - curve.a * h * h;
            assert_near(curve.derivative(t), first, 1e-10);
            let second = (curve.derivative(t + h) - curve.derivative(t - h)) / (2.0 * h);
            assert_near(curve.second_derivative(t), second, 1e-9);
        }

        #[test]
        fn moves_with_its_points(g in prop::array::uniform4(vector(10.0)), t in 0.0..1.0f64) {
            let [p0, p1, r0, r1] = g;
            let linear = |v| map(v) - map(DVec3::ZERO);
            let moved = Cubic::hermite(map(p0), map(p1), linear(r0), linear(r1));
            assert_near(moved.point(t), map(Cubic::hermite(p0, p1, r0, r1).point(t)), 1e-12);
        }
    }
}
