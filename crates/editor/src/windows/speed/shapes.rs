//! Speed curves to pick from: the shapes that a camera's motion mostly has.
//! No egui here.

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

/// The slowest speed of a shape, as a share of its fastest.
const SLOWEST: f64 = 0.1;

impl Shape {
    pub(crate) const ALL: [Self; 4] = [Self::Constant, Self::EaseIn, Self::EaseOut, Self::Both];

    /// Its speed at u in [0, 1], the fastest being 1.
    fn at(self, u: f64) -> f64 {
        let rise = |u: f64| {
            let u = u.clamp(0.0, 1.0);
            SLOWEST + (1.0 - SLOWEST) * u * u * (3.0 - 2.0 * u)
        };
        match self {
            Self::Constant => 1.0,
            Self::EaseIn => rise(u),
            Self::EaseOut => rise(1.0 - u),
            Self::Both => rise(2.0 * u.min(1.0 - u)),
        }
    }

    /// Ten speeds of this shape with the mean of `old`, so that the section
    /// takes as long as before, as far as 1…100 allows it.
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
                let speed = (fastest * self.at(u)).clamp(MIN_SPEED, MAX_SPEED);
                (speed * 10.0).round() / 10.0
            })
        };
        // The mean grows with the fastest speed: halve what is left between.
        let (mut low, mut high) = (MIN_SPEED, MAX_SPEED / SLOWEST);
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
                for shape in Shape::ALL {
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
}
