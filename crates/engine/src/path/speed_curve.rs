//! The speed curve of a section (thesis 5.2): ten speeds at u = 0, 1/9 … 1, joined by explicit
//! Catmull–Rom cubics whose slopes are clipped so that the speed stays in [1, 100].

use crate::limits::{MAX_SPEED, MIN_SPEED, SPEEDS};
use crate::math::monotone_cubic::{slope, value};

/// Intervals between the ten speeds.
pub const INTERVALS: usize = SPEEDS - 1;

/// What shapes a speed curve at one of its ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum CurveEnd {
    /// Nothing lies beyond: it has the slope of the parabola through three speeds.
    Free,
    /// The facing speed, 1/9 outside.
    Facing(f64),
    /// Its slope, v′.
    Slope(f64),
}

impl From<Option<f64>> for CurveEnd {
    fn from(facing: Option<f64>) -> Self {
        facing.map_or(Self::Free, Self::Facing)
    }
}

/// A speed curve and its integral.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpeedCurve {
    /// Speed in each interval, in powers of x = 9u − i.
    speed: [[f64; 4]; INTERVALS],
    /// Share of the whole integral up to u, in powers of the same x.
    fraction: [[f64; 5]; INTERVALS],
    mean: f64,
}

impl SpeedCurve {
    pub(super) fn coefficients(&self) -> impl Iterator<Item = &[f64; 4]> {
        self.speed.iter()
    }

    /// The curve through `speeds`, each in [1, 100].
    #[must_use]
    pub fn new(speeds: &[f64; SPEEDS], ends: [CurveEnd; 2]) -> Self {
        let slopes = slopes(speeds, ends);
        let mut areas = [0.0; INTERVALS];
        let mut speed = [[0.0; 4]; INTERVALS];
        for i in 0..INTERVALS {
            let (v0, v1, m0, m1) = (speeds[i], speeds[i + 1], slopes[i], slopes[i + 1]);
            let rise = v1 - v0;
            speed[i] = [v0, m0, 3.0 * rise - 2.0 * m0 - m1, m0 + m1 - 2.0 * rise];
            areas[i] = (v0 + v1) / 2.0 + (m0 - m1) / 12.0;
        }
        let total: f64 = areas.iter().sum();
        let mut fraction = [[0.0; 5]; INTERVALS];
        let mut sum = 0.0;
        for i in 0..INTERVALS {
            let v = speed[i];
            fraction[i] = [sum, v[0], v[1] / 2.0, v[2] / 3.0, v[3] / 4.0].map(|c| c / total);
            sum += areas[i];
        }
        #[allow(clippy::cast_precision_loss)]
        let mean = total / INTERVALS as f64;
        Self {
            speed,
            fraction,
            mean,
        }
    }

    /// ∫v over [0, 1].
    #[must_use]
    pub const fn mean(&self) -> f64 {
        self.mean
    }

    /// Whether the speed is the same everywhere, so that f(u) = u.
    #[must_use]
    pub fn is_constant(&self) -> bool {
        let first = self.speed[0][0];
        self.speed.iter().all(|c| *c == [first, 0.0, 0.0, 0.0])
    }

    /// v(u), u in [0, 1].
    #[must_use]
    pub fn speed(&self, u: f64) -> f64 {
        let (i, x) = interval(u);
        // The curve stays in range; its rounding need not.
        value(&self.speed[i], x).clamp(MIN_SPEED, MAX_SPEED)
    }

    /// v′(u), u in [0, 1]; where two intervals meet, that of the later one.
    #[must_use]
    pub fn acceleration(&self, u: f64) -> f64 {
        let (i, x) = interval(u);
        slope(&self.speed[i], x) * INTERVALS as f64
    }

    /// f(u) = ∫₀ᵘv / ∫₀¹v, u in [0, 1]; exact at both ends.
    #[must_use]
    pub fn fraction(&self, u: f64) -> f64 {
        if u >= 1.0 {
            return 1.0;
        }
        let (i, x) = interval(u);
        let c = &self.fraction[i];
        ((((c[4] * x + c[3]) * x + c[2]) * x + c[1]) * x + c[0]).clamp(0.0, 1.0)
    }

    /// f on each interval, in powers of x = 9u − i.
    #[must_use]
    pub const fn fraction_coefficients(&self) -> &[[f64; 5]; INTERVALS] {
        &self.fraction
    }
}

/// The interval that holds u, and x in it.
#[allow(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    clippy::cast_precision_loss
)]
fn interval(u: f64) -> (usize, f64) {
    let x = u * INTERVALS as f64;
    let i = (x.max(0.0) as usize).min(INTERVALS - 1);
    (i, x - i as f64)
}

/// v′ at both ends.
#[must_use]
pub fn end_slopes(speeds: &[f64; SPEEDS], ends: [CurveEnd; 2]) -> [f64; 2] {
    let [first, .., last] = slopes(speeds, ends);
    [first, last].map(|slope| slope * INTERVALS as f64)
}

/// Slopes at the ten knots, per interval, clipped so that both inner Bézier points of every
/// interval, and by their hull the curve, lie in [1, 100].
fn slopes(v: &[f64; SPEEDS], ends: [CurveEnd; 2]) -> [f64; SPEEDS] {
    let last = SPEEDS - 1;
    let mut slopes = [0.0; SPEEDS];
    for i in 1..last {
        let room = 3.0 * (v[i] - MIN_SPEED).min(MAX_SPEED - v[i]);
        slopes[i] = ((v[i + 1] - v[i - 1]) / 2.0).clamp(-room, room);
    }
    let start = match ends[0] {
        CurveEnd::Free => (-3.0 * v[0] + 4.0 * v[1] - v[2]) / 2.0,
        CurveEnd::Facing(before) => (v[1] - before) / 2.0,
        CurveEnd::Slope(slope) => slope / INTERVALS as f64,
    };
    let end = match ends[1] {
        CurveEnd::Free => (3.0 * v[last] - 4.0 * v[last - 1] + v[last - 2]) / 2.0,
        CurveEnd::Facing(after) => (after - v[last - 1]) / 2.0,
        CurveEnd::Slope(slope) => slope / INTERVALS as f64,
    };
    slopes[0] = start.clamp(3.0 * (MIN_SPEED - v[0]), 3.0 * (MAX_SPEED - v[0]));
    slopes[last] = end.clamp(3.0 * (v[last] - MAX_SPEED), 3.0 * (v[last] - MIN_SPEED));
    slopes
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::path::test_support::Random;

    fn speed(random: &mut Random) -> f64 {
        match (random.unit() * 8.0) as u32 {
            0 => 1.0,
            1 => 100.0,
            _ => 1.0 + 99.0 * random.unit(),
        }
    }

    fn curve(random: &mut Random) -> SpeedCurve {
        let speeds = std::array::from_fn(|_| speed(random));
        let before = (random.unit() < 0.5).then(|| speed(random));
        let after = (random.unit() < 0.5).then(|| speed(random));
        SpeedCurve::new(&speeds, [before, after].map(CurveEnd::from))
    }

    #[test]
    fn a_million_random_curves_stay_in_range_and_move_on() {
        let mut random = Random(7);
        for _ in 0..1_000_000 {
            let curve = curve(&mut random);
            let mut last = 0.0;
            for c in &curve.speed {
                // The extremes of a cubic are at its ends or where its derivative is zero.
                let mut at = vec![0.0, 1.0];
                let (a, b, d) = (3.0 * c[3], 2.0 * c[2], c[1]);
                let root = b * b - 4.0 * a * d;
                if root >= 0.0 {
                    let q = -0.5 * (b + root.sqrt().copysign(b));
                    at.extend(
                        [q / a, d / q]
                            .into_iter()
                            .filter(|x| (0.0..=1.0).contains(x)),
                    );
                }
                for x in at {
                    let v = ((c[3] * x + c[2]) * x + c[1]) * x + c[0];
                    assert!((1.0 - 1e-12..=100.0 + 1e-12).contains(&v), "{v}");
                }
            }
            for k in 1..=40 {
                let f = curve.fraction(f64::from(k) / 40.0);
                assert!(f > last);
                last = f;
            }
            assert_eq!(last, 1.0);
        }
    }

    #[test]
    fn the_integral_is_that_of_gauss_legendre() {
        // Two nodes are exact for cubics.
        let mut random = Random(8);
        for _ in 0..10_000 {
            let curve = curve(&mut random);
            let g = 0.5 / 3.0f64.sqrt();
            let mut sum = 0.0;
            for i in 0..9 {
                let middle = (f64::from(i) + 0.5) / 9.0;
                sum += (curve.speed(middle - g / 9.0) + curve.speed(middle + g / 9.0)) / 18.0;
                let f = curve.fraction(f64::from(i + 1) / 9.0);
                assert!((f - sum / curve.mean()).abs() < 1e-12);
            }
            assert!((sum - curve.mean()).abs() < 1e-12 * sum);
        }
    }

    #[test]
    fn slopes_are_clipped_only_where_needed() {
        // The thesis's own bad example: 100, 1, 1, 100 gives −11.4 unclipped.
        let mut v = [50.0; 10];
        v[3..7].copy_from_slice(&[100.0, 1.0, 1.0, 100.0]);
        let clipped = slopes(&v, [CurveEnd::Free; 2]);
        assert_eq!(clipped[4..6], [0.0, 0.0]);
        let gentle = [40.0, 45.0, 52.0, 60.0, 55.0, 50.0, 50.0, 45.0, 42.0, 41.0];
        let free = slopes(&gentle, [38.0, 44.0].map(CurveEnd::Facing));
        for i in 1..9 {
            assert_eq!(free[i], (gentle[i + 1] - gentle[i - 1]) / 2.0);
        }
        assert_eq!(free[0], 3.5);
        assert_eq!(free[9], 1.0);
        assert_eq!(
            slopes(&gentle, [CurveEnd::Free; 2])[0],
            (-120.0 + 180.0 - 52.0) / 2.0
        );
    }

    #[test]
    fn constant_speed_is_a_straight_distance() {
        let curve = SpeedCurve::new(&[50.0; 10], [CurveEnd::Free, CurveEnd::Facing(50.0)]);
        assert_eq!(curve.mean(), 50.0);
        for k in 0..=1000 {
            let u = f64::from(k) / 1000.0;
            assert!((curve.fraction(u) - u).abs() < 3e-16);
        }
    }
}
