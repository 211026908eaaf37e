//! The pace of a section, worked out.

use super::camera_path::Orientation;
use super::ease::Ease;
use super::own::{Pace, PacePart, PaceSource};
use super::speed_curve::{CurveEnd, SpeedCurve};
use crate::error::{Result, vec_with_room};
use crate::limits::{BASE_SPEED, MAX_DISTANCE_KEYS, MAX_SPEED, MIN_SPEED};
use crate::math::monotone_cubic;

/// From the share of a section's time to the share of its way.
#[derive(Debug, Clone, PartialEq)]
pub struct Timing {
    course: Course,
    /// Shares of the course's time between which it is taken.
    from: f64,
    to: f64,
    /// Shares of its way before `from`, and from there to `to`.
    before: f64,
    within: f64,
}

/// The whole that a timing is taken from. The largest is the usual one: boxing it gains nothing.
#[derive(Debug, Clone, PartialEq)]
#[allow(clippy::large_enum_variant)]
enum Course {
    Curve(SpeedCurve),
    Ease(Ease),
    Distance(Vec<DistancePiece>),
}

/// A cubic between two keys of a given distance.
#[derive(Debug, Clone, Copy, PartialEq)]
struct DistancePiece {
    start: f64,
    length: f64,
    /// The way in powers of the share of the piece.
    way: [f64; 4],
}

/// Mean speed of a part that stands still; frame counts are divided by it.
const STILL: f64 = 1e-9;

/// Slopes of a given distance at its keys.
fn slopes(keys: &[[f64; 2]], slopes: &mut [f64; MAX_DISTANCE_KEYS]) {
    let (mut steps, mut rises) = ([0.0; MAX_DISTANCE_KEYS], [0.0; MAX_DISTANCE_KEYS]);
    let last = keys.len() - 1;
    for (k, pair) in keys.windows(2).enumerate() {
        steps[k] = pair[1][0] - pair[0][0];
        rises[k] = pair[1][1] - pair[0][1];
    }
    monotone_cubic::slopes(&steps[..last], &rises[..last], false, &mut slopes[..=last]);
}

fn pieces(keys: &[[f64; 2]]) -> Result<Vec<DistancePiece>> {
    let mut found = [0.0; MAX_DISTANCE_KEYS];
    slopes(keys, &mut found);
    let mut pieces = vec_with_room(keys.len() - 1)?;
    for (k, pair) in keys.windows(2).enumerate() {
        let ([start, way], [end, next]) = (pair[0], pair[1]);
        let length = end - start;
        pieces.push(DistancePiece {
            start,
            length,
            way: monotone_cubic::cubic(way, next - way, length, found[k], found[k + 1]),
        });
    }
    Ok(pieces)
}

/// The pieces of keys with custom slopes, which are reduced where the way would go back.
fn track_pieces(keys: &[[f64; 3]]) -> Result<Vec<DistancePiece>> {
    let mut pieces = vec_with_room(keys.len() - 1)?;
    for pair in keys.windows(2) {
        let ([start, way, left], [end, next, right]) = (pair[0], pair[1]);
        let (length, rise) = (end - start, next - way);
        let scale = monotone_cubic::scale(rise / length, left, right);
        pieces.push(DistancePiece {
            start,
            length,
            way: monotone_cubic::cubic(way, rise, length, scale * left, scale * right),
        });
    }
    Ok(pieces)
}

/// The piece of a given distance that holds `u`, and the share of it there.
fn piece_at(pieces: &[DistancePiece], u: f64) -> (&DistancePiece, f64) {
    let at = pieces.partition_point(|piece| piece.start <= u).max(1) - 1;
    (&pieces[at], (u - pieces[at].start) / pieces[at].length)
}

impl Course {
    fn mean(&self) -> f64 {
        match self {
            Self::Curve(curve) => curve.mean(),
            Self::Ease(ease) => ease.mean(),
            Self::Distance(_) => BASE_SPEED,
        }
    }

    fn fraction(&self, u: f64) -> f64 {
        match self {
            Self::Curve(curve) => curve.fraction(u),
            Self::Ease(ease) => ease.distance(u),
            Self::Distance(_) if u >= 1.0 => 1.0,
            Self::Distance(pieces) => {
                let (piece, x) = piece_at(pieces, u);
                monotone_cubic::value(&piece.way, x).clamp(0.0, 1.0)
            }
        }
    }

    fn speed(&self, u: f64) -> f64 {
        match self {
            Self::Curve(curve) => curve.speed(u),
            Self::Ease(ease) => ease.speed(u),
            Self::Distance(pieces) => {
                let (piece, x) = piece_at(pieces, u);
                let slope = monotone_cubic::slope(&piece.way, x);
                (BASE_SPEED * slope / piece.length).max(0.0)
            }
        }
    }

    fn acceleration(&self, u: f64) -> f64 {
        match self {
            Self::Curve(curve) => curve.acceleration(u),
            Self::Ease(ease) => ease.acceleration(u),
            Self::Distance(pieces) => {
                let (DistancePiece { length, way: c, .. }, x) = piece_at(pieces, u);
                BASE_SPEED * (6.0 * c[3] * x + 2.0 * c[2]) / (length * length)
            }
        }
    }
}

impl Timing {
    /// The pace of an orientation's section; `ends` shape the curve of its ten speeds.
    ///
    /// # Errors
    /// [`crate::Error::Memory`].
    pub fn new(orientation: &Orientation, ends: [CurveEnd; 2]) -> Result<Self> {
        let pace = &orientation.own.pace;
        let course = match pace {
            Pace::Speeds => Course::Curve(SpeedCurve::new(&orientation.speeds, ends)),
            Pace::Ease(ease) => Course::Ease(*ease),
            Pace::Distance(keys) => Course::Distance(pieces(keys)?),
            Pace::Part(part) => match &part.of {
                PaceSource::Speeds { speeds, slopes } => {
                    Course::Curve(SpeedCurve::new(speeds, slopes.map(CurveEnd::Slope)))
                }
                PaceSource::Ease(ease) => Course::Ease(*ease),
                PaceSource::Distance(keys) => Course::Distance(pieces(keys)?),
                PaceSource::Track(keys) => Course::Distance(track_pieces(keys)?),
            },
        };
        let (from, to) = match pace {
            Pace::Part(part) => (part.from, part.to),
            _ => (0.0, 1.0),
        };
        let before = course.fraction(from);
        let within = course.fraction(to) - before;
        Ok(Self {
            course,
            from,
            to,
            before,
            within,
        })
    }

    /// Mean speed, and whether it is the same everywhere; mostly without taking memory.
    pub(super) fn outline(orientation: &Orientation, ends: [CurveEnd; 2]) -> Result<(f64, bool)> {
        match &orientation.own.pace {
            Pace::Speeds => {
                let curve = SpeedCurve::new(&orientation.speeds, ends);
                Ok((curve.mean(), curve.is_constant()))
            }
            Pace::Distance(_) => Ok((BASE_SPEED, false)),
            Pace::Ease(_) | Pace::Part(_) => {
                let timing = Self::new(orientation, ends)?;
                Ok((timing.mean(), timing.is_constant()))
            }
        }
    }

    /// Whether the speed is the same everywhere.
    #[must_use]
    pub fn is_constant(&self) -> bool {
        match &self.course {
            Course::Curve(curve) => curve.is_constant(),
            Course::Ease(ease) => ease.rise == 0.0 && ease.fall == 0.0,
            Course::Distance(_) => false,
        }
    }

    fn is_whole(&self) -> bool {
        self.from == 0.0 && self.to == 1.0
    }

    /// The ten speeds' curve, where it is that and nothing else.
    pub(super) fn plain_curve(&self) -> Option<&SpeedCurve> {
        match &self.course {
            Course::Curve(curve) if self.is_whole() => Some(curve),
            _ => None,
        }
    }

    /// The place on the whole.
    fn at(&self, u: f64) -> f64 {
        (self.from + (self.to - self.from) * u).min(1.0)
    }

    /// Mean speed: 50 where the way is given.
    #[must_use]
    pub fn mean(&self) -> f64 {
        if self.is_whole() {
            return self.course.mean();
        }
        (self.course.mean() * self.within / (self.to - self.from)).max(STILL)
    }

    /// Share of the way at the share `u` of the time, both in [0, 1]; exact at both ends.
    #[must_use]
    pub fn fraction(&self, u: f64) -> f64 {
        if u >= 1.0 {
            1.0
        } else if self.is_whole() {
            self.course.fraction(u)
        } else if self.within > 0.0 {
            let gone = self.course.fraction(self.at(u)) - self.before;
            (gone / self.within).clamp(0.0, 1.0)
        } else {
            u
        }
    }

    /// Derivative of [`Self::fraction`] at the share `u`; where it jumps, one of the two values.
    #[must_use]
    pub fn slope(&self, u: f64) -> f64 {
        if self.within > 0.0 {
            self.speed(u) / self.mean()
        } else {
            1.0
        }
    }

    /// Speed at the share `u` of the time; 50 is the base speed.
    #[must_use]
    pub fn speed(&self, u: f64) -> f64 {
        self.course.speed(self.at(u))
    }

    /// Derivative of [`Self::speed`] at the share `u`; where it jumps, one of the two values.
    #[must_use]
    pub fn acceleration(&self, u: f64) -> f64 {
        self.course.acceleration(self.at(u)) * (self.to - self.from)
    }

    /// All that defines it.
    pub(super) fn each_number(&self, see: &mut dyn FnMut([f64; 4])) {
        match &self.course {
            Course::Curve(curve) => curve.coefficients().for_each(|c| see(*c)),
            Course::Ease(ease) => see(ease.numbers()),
            Course::Distance(pieces) => pieces.iter().for_each(|piece| {
                see([piece.start, piece.length, 0.0, 0.0]);
                see(piece.way);
            }),
        }
        if !self.is_whole() {
            see([self.from, self.to, self.before, self.within]);
        }
    }
}

/// The speeds at both ends of an orientation's section, as its neighbours' ten speeds see them.
#[must_use]
pub fn facing(orientation: &Orientation) -> [f64; 2] {
    let [first, .., last] = orientation.speeds;
    let seen = |speed: f64| speed.clamp(MIN_SPEED, MAX_SPEED);
    let ease = |ease: &Ease, ends: [f64; 2]| ends.map(|t| seen(ease.speed(t)));
    let distance = |keys: &[[f64; 2]]| {
        let mut found = [0.0; MAX_DISTANCE_KEYS];
        slopes(keys, &mut found);
        [found[0], found[keys.len() - 1]].map(|slope| seen(BASE_SPEED * slope))
    };
    match &orientation.own.pace {
        Pace::Speeds => [first, last],
        Pace::Ease(whole) => ease(whole, [0.0, 1.0]),
        Pace::Distance(keys) => distance(keys),
        Pace::Part(PacePart { of, from, to }) => match of {
            PaceSource::Speeds { speeds, slopes } => {
                let curve = SpeedCurve::new(speeds, slopes.map(CurveEnd::Slope));
                [curve.speed(*from), curve.speed(*to)]
            }
            PaceSource::Ease(whole) => ease(whole, [*from, *to]),
            // Without memory for its pieces, the ten speeds come near.
            PaceSource::Distance(_) | PaceSource::Track(_) => {
                match Timing::new(orientation, [CurveEnd::Free; 2]) {
                    Ok(timing) => [0.0, 1.0].map(|u| seen(timing.speed(u))),
                    Err(_) => [first, last],
                }
            }
        },
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::path::speed_curve::end_slopes;
    use crate::path::test_support::Random;
    use crate::path::{EaseKind, own};

    fn with(pace: Pace) -> Orientation {
        let own = Orientation::default().own.with(|own| own.pace = pace);
        Orientation {
            own: own.unwrap(),
            ..Orientation::default()
        }
    }

    #[test]
    fn two_parts_are_the_whole_curve() {
        let mut random = Random(5);
        for _ in 0..10_000 {
            let speeds = std::array::from_fn(|_| 1.0 + 99.0 * random.unit());
            let mut facing = || (random.unit() < 0.5).then_some(1.0 + 99.0 * random.unit());
            let ends = [facing(), facing()].map(CurveEnd::from);
            let whole = SpeedCurve::new(&speeds, ends);
            let slopes = end_slopes(&speeds, ends);
            let cut = 0.01 + 0.98 * random.unit();
            let part = |from, to| PacePart {
                of: PaceSource::Speeds { speeds, slopes },
                from,
                to,
            };
            let [a, b] = [part(0.0, cut), part(cut, 1.0)]
                .map(|part| Timing::new(&with(Pace::Part(part)), [CurveEnd::Free; 2]).unwrap());
            let mean = cut * a.mean() + (1.0 - cut) * b.mean();
            assert!((mean - whole.mean()).abs() < 1e-11);
            for k in 0..=10 {
                let u = f64::from(k) / 10.0;
                let first = whole.fraction(cut * u);
                assert!((a.fraction(u) * whole.fraction(cut) - first).abs() < 1e-14);
                let rest = 1.0 - whole.fraction(cut);
                let second = whole.fraction(cut + (1.0 - cut) * u) - whole.fraction(cut);
                assert!((b.fraction(u) * rest - second).abs() < 1e-14);
                assert!((a.speed(u) - whole.speed(cut * u)).abs() < 1e-12);
            }
        }
    }

    /// Between the places where it jumps, the mean of the acceleration (five nodes of Gauss
    /// and Legendre) is the change of the speed.
    #[test]
    fn the_speed_is_the_integral_of_the_acceleration() {
        const NODES: [(f64, f64); 5] = [
            (-0.906_179_845_938_664, 0.236_926_885_056_189_1),
            (-0.538_469_310_105_683_1, 0.478_628_670_499_366_5),
            (0.0, 0.568_888_888_888_888_9),
            (0.538_469_310_105_683_1, 0.478_628_670_499_366_5),
            (0.906_179_845_938_664, 0.236_926_885_056_189_1),
        ];
        let ease = |kind| Ease {
            kind,
            rise: 0.3,
            fall: 0.45,
            cruise: 70.0,
        };
        let speeds = [3.0, 60.0, 100.0, 1.0, 1.0, 55.0, 20.0, 70.0, 90.0, 5.0];
        let ends = [CurveEnd::Facing(40.0), CurveEnd::Free];
        let whole = PaceSource::Speeds {
            speeds,
            slopes: end_slopes(&speeds, ends),
        };
        let keys = [[0.0, 0.0], [0.2, 0.05], [0.5, 0.7], [0.9, 0.8], [1.0, 1.0]];
        let part = |of| {
            Pace::Part(PacePart {
                of,
                from: 0.0,
                to: 0.5,
            })
        };
        let ninths: Vec<f64> = (0..=9).map(|i| f64::from(i) / 9.0).collect();
        let halves: Vec<f64> = ninths
            .iter()
            .map(|u| 2.0 * u)
            .filter(|&u| u <= 1.0)
            .collect();
        for (pace, jumps) in [
            (Pace::Ease(ease(EaseKind::Sine)), vec![0.0, 0.3, 0.55, 1.0]),
            (
                Pace::Ease(ease(EaseKind::Parabolic)),
                vec![0.0, 0.3, 0.55, 1.0],
            ),
            (
                own::distance(&keys).unwrap(),
                keys.map(|key| key[0]).to_vec(),
            ),
            (part(whole), halves),
            (Pace::Speeds, ninths),
        ] {
            let orientation = Orientation {
                speeds,
                ..with(pace.clone())
            };
            let timing = Timing::new(&orientation, ends).unwrap();
            for pair in jumps.windows(2) {
                // Pieces of it, so that the sine is a polynomial to rounding.
                for piece in 0..4 {
                    let at = |part: i32| pair[0] + (pair[1] - pair[0]) * f64::from(part) / 4.0;
                    let (from, to) = (at(piece) + 1e-13, at(piece + 1) - 1e-13);
                    let (middle, half) = (f64::midpoint(from, to), (to - from) / 2.0);
                    let change: f64 = NODES
                        .iter()
                        .map(|(x, weight)| half * weight * timing.acceleration(middle + half * x))
                        .sum();
                    let found = timing.speed(to) - timing.speed(from);
                    assert!(
                        (found - change).abs() < 1e-9,
                        "{pace:?} {from}: {found} {change}"
                    );
                }
            }
        }
    }

    #[test]
    fn a_given_distance_meets_its_keys_and_never_goes_back() {
        let mut random = Random(6);
        for _ in 0..3_000 {
            let count = 2 + (random.unit() * 12.0) as usize;
            let mut row = |n: usize| {
                let mut sum = vec![0.0];
                for _ in 1..n {
                    sum.push(sum[sum.len() - 1] + 0.01 + random.unit().powi(3));
                }
                let last = sum[n - 1];
                sum.iter().map(|x| x / last).collect::<Vec<f64>>()
            };
            let (times, ways) = (row(count), row(count));
            let keys: Vec<_> = times.iter().zip(&ways).map(|(&t, &w)| [t, w]).collect();
            let orientation = with(own::distance(&keys).unwrap());
            let timing = Timing::new(&orientation, [CurveEnd::Free; 2]).unwrap();
            for [t, w] in &keys {
                assert!((timing.fraction(*t) - w).abs() < 1e-15);
            }
            let mut last = 0.0;
            for k in 0..=300 {
                let way = timing.fraction(f64::from(k) / 300.0);
                assert!(way >= last - 1e-15);
                last = way;
            }
            let [first, end] = facing(&orientation);
            assert!((timing.speed(0.0).clamp(1.0, 100.0) - first).abs() < 1e-9);
            assert!((timing.speed(1.0).clamp(1.0, 100.0) - end).abs() < 1e-9);
        }
        for bad in [
            vec![[0.0, 0.0]],
            vec![[0.0, 0.0], [1.0, 0.5]],
            vec![[0.0, 0.1], [1.0, 1.0]],
            vec![[0.0, 0.0], [0.5, 0.5], [0.5, 0.7], [1.0, 1.0]],
            vec![[0.0, 0.0], [0.5, 0.5], [0.6, 0.5], [1.0, 1.0]],
            vec![[0.0, 0.0], [f64::NAN, 0.5], [1.0, 1.0]],
            vec![[0.0, 0.0]; 1000],
        ] {
            assert!(own::distance(&bad).is_err(), "{bad:?}");
        }
    }
}
