//! Speed curves to pick from: the usual shapes of a camera's motion. No egui here.

use vides_engine::limits::{MAX_SPEED, MIN_SPEED, SPEEDS};
use vides_engine::path::speed_curve::{CurveEnd, SpeedCurve};

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

    /// Whether it is slow at the start, and at the end.
    const fn slow(self) -> [bool; 2] {
        match self {
            Self::Constant => [false, false],
            Self::EaseIn => [true, false],
            Self::EaseOut => [false, true],
            Self::Both => [true, true],
        }
    }

    /// Ten speeds of this shape, as slow as can be where it is slow and where the camera stands
    /// still next to it. An end beyond which the camera goes on joins that speed. The fast end does
    /// so as a whole, unless the section `lasts` as long as before; else the mean is this, as far
    /// as 1…100 allows.
    pub(crate) fn speeds(self, ends: [End; 2], mean: f64, lasts: bool) -> [f64; SPEEDS] {
        let mut slow = self.slow();
        let mut joins = [None; 2];
        let mut least = [MIN_SPEED; 2];
        let mut fastest = None;
        for side in 0..2 {
            match ends[side] {
                _ if self == Self::Constant => {}
                End::Free => {}
                End::Still => slow[side] = true,
                End::Slow(speed) => {
                    slow[side] = true;
                    least[side] = speed.clamp(MIN_SPEED, MAX_SPEED);
                }
                End::Goes(speed) if lasts || slow[side] => joins[side] = Some(speed),
                End::Goes(speed) => fastest = Some(speed),
            }
        }
        let ten = |fastest: f64| made((slow, least), joins, fastest);
        if let Some(speed) = fastest {
            return ten(speed);
        }
        // The mean grows with the fastest speed: bisection.
        let facing = ends.map(|end| CurveEnd::from(end.speed()));
        let (mut low, mut high) = (MIN_SPEED, 10.0 * MAX_SPEED);
        for _ in 0..40 {
            let middle = f64::midpoint(low, high);
            if SpeedCurve::new(&ten(middle), facing).mean() < mean {
                low = middle;
            } else {
                high = middle;
            }
        }
        ten(high)
    }
}

/// What lies beyond an end of a section.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum End {
    /// Nothing.
    Free,
    /// The camera stands still.
    Still,
    /// It goes on with this speed, to which this section slows down.
    Slow(f64),
    /// It goes on with this speed.
    Goes(f64),
}

impl End {
    const fn speed(self) -> Option<f64> {
        match self {
            Self::Goes(speed) | Self::Slow(speed) => Some(speed),
            Self::Free | Self::Still => None,
        }
    }
}

/// Intervals in which a speed to be joined gives way to the shape.
const JOINT: usize = 2;

/// Ten speeds up to the fastest, with slow ends and how slow these are, or with ends that are led to
/// other speeds.
fn made(
    (slow, least): ([bool; 2], [f64; 2]),
    joins: [Option<f64>; 2],
    fastest: f64,
) -> [f64; SPEEDS] {
    let last = SPEEDS - 1;
    let rise = |u: f64| {
        let u = u.clamp(0.0, 1.0);
        u * u * (3.0 - 2.0 * u)
    };
    let [from, to] = joins.map(|speed| if speed.is_some() { JOINT } else { 0 });
    let share = |u: f64| match slow {
        [false, false] => 1.0,
        [true, false] => rise(u),
        [false, true] => rise(1.0 - u),
        [true, true] => rise(2.0 * u.min(1.0 - u)),
    };
    std::array::from_fn(|i| {
        let inner = i.clamp(from, last - to);
        let u = (inner - from) as f64 / (last - to - from) as f64;
        // The slow ends are as slow as it gets, so that the curve cannot dip.
        let least = least[usize::from(!slow[0] || (slow[1] && u > 0.5))];
        let mut speed = least + (fastest - least) * share(u);
        for (side, joined) in joins.into_iter().enumerate() {
            let away = if side == 0 { i } else { last - i };
            if let Some(joined) = joined.filter(|_| away < JOINT) {
                speed += (joined - speed) * rise(1.0 - away as f64 / JOINT as f64);
            }
        }
        (speed.clamp(MIN_SPEED, MAX_SPEED) * 10.0).round() / 10.0
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn free(shape: Shape, mean: f64) -> [f64; SPEEDS] {
        shape.speeds([End::Free; 2], mean, false)
    }

    #[test]
    fn shapes_begin_and_end_as_they_are_called() {
        let of = |shape: Shape| free(shape, 50.0);
        assert_eq!(of(Shape::Constant), [50.0; SPEEDS]);
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
            // Beside slow ends a slow part takes speeds above 100 for a mean of 50.
            let slow = (Some(5.0), Some(20.0));
            for (before, after) in
                [(None, None), slow]
                    .into_iter()
                    .take(if level < 50.0 { 2 } else { 1 })
            {
                let ends = [before, after].map(|speed| speed.map_or(End::Free, End::Goes));
                for shape in Shape::ALL {
                    let new = shape.speeds(ends, level, true);
                    let change = SpeedCurve::new(&new, [before, after].map(CurveEnd::from)).mean()
                        / level
                        - 1.0;
                    assert!(change.abs() < 0.01, "{shape:?} {level}: {change}");
                }
            }
        }
        // As fast as can be stays in range.
        for shape in Shape::ALL {
            let new = free(shape, 100.0);
            assert!(new.iter().all(|speed| (1.0..=100.0).contains(speed)));
        }
    }

    /// Ends join the neighbouring speeds, the slow part is within; where the camera rests
    /// next to it, the section is as slow as possible.
    #[test]
    fn ends_join_their_neighbours_and_nothing_dips_below_the_slow_one() {
        for shape in [Shape::EaseIn, Shape::EaseOut, Shape::Both] {
            let between_rests = shape.speeds([End::Still; 2], 50.0, false);
            assert_eq!((between_rests[0], between_rests[SPEEDS - 1]), (1.0, 1.0));
        }
        for speed in [3.0, 25.0, 50.0, 100.0] {
            for other in [End::Free, End::Still, End::Goes(1.0), End::Goes(100.0)] {
                let into = Shape::EaseIn.speeds([other, End::Goes(speed)], 50.0, false);
                let out = Shape::EaseOut.speeds([End::Goes(speed), other], 50.0, false);
                let [slow, facing] = match other {
                    End::Goes(joined) => [2, joined as usize],
                    _ => [0, 1],
                };
                assert_eq!((into[SPEEDS - 1], out[0]), (speed, speed));
                assert_eq!((into[slow], out[SPEEDS - 1 - slow]), (1.0, 1.0));
                assert_eq!((into[0], out[SPEEDS - 1]), (facing as f64, facing as f64));
                for (speeds, [before, after]) in [
                    (into, [other.speed(), Some(speed)]),
                    (out, [Some(speed), other.speed()]),
                ] {
                    let curve = SpeedCurve::new(&speeds, [before, after].map(CurveEnd::from));
                    for step in 0..=900 {
                        assert!(curve.speed(f64::from(step) / 900.0) >= 1.0 - 1e-12);
                    }
                }
            }
        }
    }
}
