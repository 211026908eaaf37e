//! Speed curves to pick from: the usual shapes of a camera's motion. No egui here.

use crate::limits::{MAX_SPEED, MIN_SPEED, SPEEDS};
use crate::path::speed_curve::SpeedCurve;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Shape {
    /// The same speed all the way.
    Constant,
    /// Slow at the start.
    EaseIn,
    /// Slow at the end.
    EaseOut,
    /// Slow at both ends.
    Both,
}

impl Shape {
    pub(crate) const ALL: [Self; 4] = [Self::Constant, Self::EaseIn, Self::EaseOut, Self::Both];

    /// Its share of the fastest speed, above the slowest, at u in [0, 1]. The slow ends are as slow
    /// as can be, so that the curve cannot dip.
    fn at(self, u: f64) -> f64 {
        let rise = |u: f64| {
            let u = u.clamp(0.0, 1.0);
            u * u * (3.0 - 2.0 * u)
        };
        match self {
            Self::Constant => 1.0,
            Self::EaseIn => rise(u),
            Self::EaseOut => rise(1.0 - u),
            Self::Both => rise(2.0 * u.min(1.0 - u)),
        }
    }

    /// Ten speeds of this shape. A fast end is as fast as the neighbour there (`before`, `after`);
    /// else the mean is that of `old`, so that the duration stays, as far as 1…100 allows.
    pub(crate) fn speeds(
        self,
        old: &[f64; SPEEDS],
        before: Option<f64>,
        after: Option<f64>,
    ) -> [f64; SPEEDS] {
        let mean = |speeds: &[f64; SPEEDS]| SpeedCurve::new(speeds, before, after).mean();
        let wanted = mean(old);
        let scaled = |fastest: f64| -> [f64; SPEEDS] {
            std::array::from_fn(|i| {
                let u = i as f64 / (SPEEDS - 1) as f64;
                let speed = MIN_SPEED + (fastest - MIN_SPEED) * self.at(u);
                (speed.clamp(MIN_SPEED, MAX_SPEED) * 10.0).round() / 10.0
            })
        };
        let neighbour = match self {
            Self::EaseIn => after,
            Self::EaseOut => before,
            Self::Constant | Self::Both => None,
        };
        if let Some(speed) = neighbour {
            return scaled(speed);
        }
        // The mean grows with the fastest speed: bisection.
        let (mut low, mut high) = (MIN_SPEED, 10.0 * MAX_SPEED);
        for _ in 0..40 {
            let middle = f64::midpoint(low, high);
            if mean(&scaled(middle)) < wanted {
                low = middle;
            } else {
                high = middle;
            }
        }
        scaled(high)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shapes_begin_and_end_as_they_are_called() {
        let old = [50.0; SPEEDS];
        let of = |shape: Shape| shape.speeds(&old, None, None);
        assert_eq!(of(Shape::Constant), old);
        let (into, out, both) = (of(Shape::EaseIn), of(Shape::EaseOut), of(Shape::Both));
        assert!(into.windows(2).all(|pair| pair[0] < pair[1]), "{into:?}");
        assert!(out.windows(2).all(|pair| pair[0] > pair[1]), "{out:?}");
        assert!(both[..5].windows(2).all(|pair| pair[0] < pair[1]));
        for i in 0..SPEEDS {
            assert_eq!(into[i], out[SPEEDS - 1 - i]);
            assert_eq!(both[i], both[SPEEDS - 1 - i]);
        }
        assert!(both[0] < 0.2 * both[4]);
    }

    #[test]
    fn the_duration_stays() {
        for level in [10.0, 30.0, 50.0] {
            let old: [f64; SPEEDS] = std::array::from_fn(|i| level + (i % 3) as f64);
            for (before, after) in [(None, None), (Some(5.0), Some(90.0))] {
                let mean = |speeds: &_| SpeedCurve::new(speeds, before, after).mean();
                let free = |shape: &Shape| {
                    let matched = matches!(shape, Shape::EaseIn | Shape::EaseOut);
                    before.is_none() || !matched
                };
                for shape in Shape::ALL.into_iter().filter(free) {
                    let new = shape.speeds(&old, before, after);
                    let change = (mean(&new) / mean(&old) - 1.0).abs();
                    assert!(change < 0.01, "{shape:?} {level}: {change}");
                }
            }
        }
        // As fast as can be stays in range.
        for shape in Shape::ALL {
            let new = shape.speeds(&[100.0; SPEEDS], None, None);
            assert!(new.iter().all(|speed| (1.0..=100.0).contains(speed)));
        }
    }

    #[test]
    fn the_fast_end_matches_the_neighbour_and_nothing_dips_below_the_slow_one() {
        for neighbour in [3.0, 25.0, 50.0, 100.0] {
            for other in [None, Some(1.0), Some(50.0), Some(100.0)] {
                let into = Shape::EaseIn.speeds(&[50.0; SPEEDS], other, Some(neighbour));
                let out = Shape::EaseOut.speeds(&[50.0; SPEEDS], Some(neighbour), other);
                assert_eq!((into[SPEEDS - 1], out[0]), (neighbour, neighbour));
                let curves = [
                    (SpeedCurve::new(&into, other, Some(neighbour)), into[0]),
                    (
                        SpeedCurve::new(&out, Some(neighbour), other),
                        out[SPEEDS - 1],
                    ),
                ];
                for (curve, slow) in curves {
                    for step in 0..=900 {
                        let speed = curve.speed(f64::from(step) / 900.0);
                        assert!(speed >= slow - 1e-12, "{speed} below {slow}");
                    }
                }
            }
        }
    }
}
