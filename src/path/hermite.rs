//! Hermite curves (thesis 3.5.1): a cubic from its ends and its end tangents.

use glam::DVec3;

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
