//! Few keys that follow a pace and hold the limits.
//!
//! A pace is known at knots as time, share and rate, with cubics between them. Some of the knots
//! become keys, each with its rate, so that what is between two of them depends on those alone: from
//! each key on, the longest cubic that holds the limits.

use super::course::{Ask, Bounds, Course};
use crate::error::{Result, vec_with_room};
use crate::limits::MAX_DISTANCE_KEYS;
use crate::math::monotone_cubic::{cubic, scale, slope, value};
use crate::tools::check::FindingKind;

/// Seconds, share of the way and its rate; between two of them a cubic.
pub(super) type Knot = [f64; 3];

/// From one share of a way to another: the greatest share of a limit, above 1.
#[derive(Debug, Clone, Copy)]
pub(super) struct Miss {
    pub from: f64,
    pub to: f64,
    pub worst: f64,
    pub kind: FindingKind,
}

/// Keys, and where they miss the limits.
#[derive(Debug, Clone)]
pub(super) struct Track {
    /// Shares of the time, of the way, and slopes.
    pub keys: Vec<[f64; 3]>,
    pub misses: Vec<Miss>,
    /// The pace that it follows.
    pub knots: Vec<Knot>,
}

impl Track {
    /// About the share of the way after so many seconds; below 0: before the end.
    pub(super) fn share(&self, seconds: f64) -> f64 {
        let last = self.knots[self.knots.len() - 1][0];
        let time = if seconds < 0.0 {
            last + seconds
        } else {
            seconds
        };
        let at = self.knots.partition_point(|knot| knot[0] < time);
        self.knots[at.min(self.knots.len() - 1)][1]
    }

    /// The greatest share of a limit that is missed, else 1.
    pub(super) fn worst(&self) -> (f64, FindingKind) {
        let worst = self.misses.iter().map(|miss| (miss.worst, miss.kind));
        worst.fold((1.0, FindingKind::Speed), |worst, next| {
            if next.0 > worst.0 { next } else { worst }
        })
    }
}

/// The knots of squared rates on an even grid, in so many seconds.
pub(super) fn knots(xs: &[f64], seconds: f64) -> Result<Vec<Knot>> {
    let cells = xs.len() - 1;
    let mut found: Vec<Knot> = vec_with_room(xs.len())?;
    let mut time = 0.0;
    for (k, x) in xs.iter().enumerate() {
        found.push([time, k as f64 / cells as f64, x.sqrt()]);
        if k < cells {
            time += 2.0 / cells as f64 / (x.sqrt() + xs[k + 1].sqrt());
        }
    }
    let longer = seconds / time;
    for knot in &mut found {
        knot[0] *= longer;
        knot[2] /= longer;
    }
    found[cells][0] = seconds;
    Ok(found)
}

/// Places in a frame at which a pace is looked at, and between two keys at least.
const STEPS: f64 = 20.0;
const FEWEST: f64 = 4.0;

/// A share of a limit, as what there are more keys than there may be counts.
const TOO_MANY: f64 = 1.03;

/// Keys within the limits, as few as hold them; else what comes nearest to them.
pub(super) fn track(knots: Vec<Knot>, course: &Course, bounds: &Bounds, fps: f64) -> Result<Track> {
    let last = knots.len() - 1;
    let seconds = knots[last][0];
    let key = |[time, way, rate]: Knot| [time / seconds, way, rate * seconds];
    let mut track = Track {
        keys: vec_with_room(MAX_DISTANCE_KEYS)?,
        misses: Vec::new(),
        knots,
    };
    track.keys.push(key(track.knots[0]));
    let (mut at, mut length) = (0, 1);
    while at < last {
        let gap = |length: usize| {
            let pair = [track.knots[at], track.knots[at + length]];
            between(pair, course, bounds, fps)
        };
        let most = last - at;
        // One as long as the last one, or half of that and so on; then twice as long, halved.
        length = length.min(most);
        let mut known = gap(length);
        while length > 1 && known.0 > 1.0 {
            length = length.div_ceil(2);
            known = gap(length);
        }
        let mut step = length;
        let mut grows = known.0 <= 1.0;
        while step > 0 && known.0 <= 1.0 && length < most {
            let longer = (length + step).min(most);
            let found = gap(longer);
            if found.0 <= 1.0 {
                (length, known) = (longer, found);
                step = if grows { length } else { step / 2 };
            } else {
                grows = false;
                step /= 2;
            }
        }
        let miss = Miss {
            from: track.knots[at][1],
            to: track.knots[at + length][1],
            worst: known.0,
            kind: known.1,
        };
        if known.0 > 1.0 {
            track.misses.try_reserve(1)?;
            track.misses.push(miss);
        }
        at += length;
        if track.keys.len() == MAX_DISTANCE_KEYS {
            let miss = Miss {
                from: 0.0,
                to: 1.0,
                worst: TOO_MANY,
                ..miss
            };
            track.misses.try_reserve(1)?;
            track.misses.push(miss);
            return Ok(track);
        }
        track.keys.push(key(track.knots[at]));
    }
    if let (Some(first), Some(last)) = (track.keys.first().copied(), track.keys.last_mut()) {
        debug_assert_eq!(first[..2], [0.0, 0.0]);
        (last[0], last[1]) = (1.0, 1.0);
    }
    Ok(track)
}

/// The greatest share of a limit on the cubic between two knots; infinite where it goes back.
fn between(
    [from, to]: [Knot; 2],
    course: &Course,
    bounds: &Bounds,
    fps: f64,
) -> (f64, FindingKind) {
    let (time, way) = (to[0] - from[0], to[1] - from[1]);
    let mut worst = (0.0, FindingKind::Speed);
    if !(time > 0.0 && way > 0.0) || scale(way / time, from[2], to[2]) < 1.0 - 1e-12 {
        return (f64::INFINITY, worst.1);
    }
    let cubic = cubic(from[1], way, time, from[2], to[2]);
    let steps = (time * fps * STEPS).ceil().max(FEWEST);
    for k in 0..=steps as usize {
        let x = k as f64 / steps;
        let rate = slope(&cubic, x) / time;
        let change = (6.0 * cubic[3] * x + 2.0 * cubic[2]) / (time * time);
        let ask = course.at(value(&cubic, x));
        judge(&ask, rate, change, bounds, &mut |share, kind| {
            if share > worst.0 || share.is_nan() {
                worst = (if share.is_nan() { f64::INFINITY } else { share }, kind);
            }
        });
    }
    worst
}

/// The shares of all limits at a place.
pub(super) fn judge(
    ask: &Ask,
    rate: f64,
    change: f64,
    bounds: &Bounds,
    see: &mut dyn FnMut(f64, FindingKind),
) {
    let x = rate * rate;
    let moved = ask.tangent * change + ask.bend * x;
    let turned = ask.turn * change + ask.twist * x;
    see(
        ask.tangent.length() * rate / bounds.speed,
        FindingKind::Speed,
    );
    see(
        moved.length() / bounds.acceleration,
        FindingKind::Acceleration,
    );
    see(
        ask.turn.length() * rate / bounds.turning,
        FindingKind::Turning,
    );
    see(
        turned.length() / bounds.turning_acceleration,
        FindingKind::TurningAcceleration,
    );
    see(ask.zoom * rate / bounds.zoom, FindingKind::Zoom);
    see(ask.crossing * rate * bounds.crossing, FindingKind::Crossing);
}
