//! The pace of a piece: its way over its time.

use super::piece::{Course, MOMENTS};
use crate::error::{Result, vec_with_room};
use crate::limits::BASE_SPEED;
use crate::path::hermite::Cubic;
use crate::path::speed_curve::CurveEnd;
use crate::path::timing::Timing;
use crate::path::{Orientation, Pace, own};

/// Numbers of parts into which the way is divided for a pace: with a close pair of keys between each
/// two, which gives way and speed there, no more keys than a pace may have.
const PARTS: [usize; 6] = [1, 2, 3, 5, 10, 15];

/// Ends of the most parts.
const MOST_PARTS: usize = 16;

/// Half the distance of such a pair, in shares of the time.
const PAIR: f64 = 1e-6;

/// Along what a piece moves, and how fast.
pub(super) struct Way {
    /// None on the spot.
    pub curve: Option<Cubic>,
    pub length: f64,
    pub pace: Pace,
    pub timing: Timing,
}

impl Way {
    /// Share of the way in a frame at an end, and by how much that grows in one.
    pub(super) fn speeds(&self, side: usize, frames: f64) -> [f64; 2] {
        // Beside the pair of keys.
        let at = ([0.0, 1.0][side] - 2.0 * PAIR).abs();
        let speed = self.timing.speed(at) / BASE_SPEED / frames;
        let faster = self.timing.acceleration(at) / BASE_SPEED / (frames * frames);
        [speed, faster]
    }
}

/// A pace with ways and speeds as given: of as few keys as leave ways and accelerations within the
/// slack.
pub(super) fn pace(ways: &[[f64; 3]], slack: [f64; 2]) -> Result<Option<(Pace, Timing)>> {
    let mut best = None;
    for parts in PARTS {
        let at = |part: usize| part * MOMENTS / parts;
        let slopes = slopes(
            parts,
            &|part| ways[at(part)][0],
            [ways[0][1], ways[MOMENTS][1]],
        );
        let mut keys: Vec<[f64; 2]> = vec_with_room(2 * parts + 2)?;
        for part in 0..=parts {
            let (time, way) = (Course::share(at(part)), ways[at(part)][0]);
            // Rest within a piece: nearly none.
            let rise = PAIR * slopes[part].max(1e-6);
            match part {
                0 => keys.extend([[0.0, 0.0], [PAIR, rise]]),
                part if part == parts => keys.extend([[1.0 - PAIR, 1.0 - rise], [1.0, 1.0]]),
                _ => keys.extend([[time - PAIR, way - rise], [time + PAIR, way + rise]]),
            }
        }
        let Ok(pace) = own::distance(&keys) else {
            continue;
        };
        let timing = timing(&pace)?;
        let off =
            |(k, [way, ..]): (usize, &[f64; 3])| (timing.fraction(Course::share(k)) - way).abs();
        let fits = ways.iter().enumerate().map(off).all(|off| off <= slack[0])
            && [0, MOMENTS].into_iter().all(|k| {
                let beside = (Course::share(k) - 2.0 * PAIR).abs();
                let bend = timing.acceleration(beside) / BASE_SPEED;
                (bend - ways[k][2]).abs() <= slack[1]
            });
        best = Some((pace, timing));
        if fits {
            break;
        }
    }
    Ok(best)
}

/// The slopes of a cubic spline with continuous second derivative through values at even distances
/// in [0, 1], its slopes at the ends given.
fn slopes(
    parts: usize,
    value: &dyn Fn(usize) -> f64,
    [first, last]: [f64; 2],
) -> [f64; MOST_PARTS] {
    let mut slopes = [0.0; MOST_PARTS];
    let mut factors = [0.0; MOST_PARTS];
    (slopes[0], slopes[parts]) = (first, last);
    for k in 1..parts {
        let right = 3.0 * parts as f64 * (value(k + 1) - value(k - 1));
        let end = if k + 1 == parts { last } else { 0.0 };
        factors[k] = 1.0 / (4.0 - factors[k - 1]);
        slopes[k] = (right - end - slopes[k - 1]) * factors[k];
    }
    for k in (1..parts.max(2) - 1).rev() {
        slopes[k] -= factors[k] * slopes[k + 1];
    }
    slopes
}

pub(super) fn timing(pace: &Pace) -> Result<Timing> {
    let mut orientation = Orientation::default();
    orientation.own = orientation.own.with(|own| own.pace = pace.clone())?;
    Timing::new(&orientation, [CurveEnd::Free; 2])
}
