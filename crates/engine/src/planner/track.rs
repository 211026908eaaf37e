//! Few keys that follow a pace and hold the limits.
//!
//! A pace is known at knots as time, share and rate, with cubics between them. Some of the knots
//! become keys, each with its rate, so that what is between two of them depends on those alone: from
//! each key on, the longest cubic that holds the limits.

use super::course::{Ask, Bounds, Course};
use super::reach::{Ramps, ramp, times};
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
    /// About the share of the way after a time in seconds; below 0: before the end.
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

/// The knots of squared rates on an even grid, for a duration in seconds.
pub(super) fn knots(xs: &[f64], ramps: Ramps, seconds: f64) -> Result<Vec<Knot>> {
    let last = xs.len() - 2;
    let share = 1.0 / (last + 1) as f64;
    let mut found: Vec<Knot> = vec_with_room(xs.len() + 2)?;
    let mut time = 0.0;
    found.push([0.0, 0.0, xs[0].sqrt()]);
    for (k, takes) in times(xs, ramps).enumerate() {
        let pair = [xs[k].sqrt(), xs[k + 1].sqrt()];
        let (from, to) = (k as f64 * share, (k + 1) as f64 * share);
        if let Some(ramp) = ramp(k, last, &xs[k..k + 2], ramps) {
            // Up to the rate at once, or down from it at last.
            let rate = pair[0] + pair[1];
            let (rise, way) = (rate / ramp, 0.5 * rate * rate / ramp);
            found.push(if pair[0] == 0.0 {
                [time + rise, from + way, rate]
            } else {
                [time + takes - rise, to - way, rate]
            });
        }
        time += takes;
        found.push([time, to, pair[1]]);
    }
    let longer = seconds / time;
    for knot in &mut found {
        knot[0] *= longer;
        knot[2] /= longer;
    }
    let last = found.len() - 1;
    (found[last][0], found[last][1]) = (seconds, 1.0);
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
            let knots = &track.knots[at..=at + length];
            let found = between([knots[0], knots[length]], course, bounds, fps);
            if length > 1 && !joins(knots, course, bounds, fps) {
                return (f64::INFINITY, FindingKind::Jerk);
            }
            found
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

/// Jump of the acceleration, as a share of what the jerk allows in a frame, that keys may make.
const JUMP: f64 = 0.01;

/// Whether one cubic in place of several makes no jerk that those have not.
fn joins(knots: &[Knot], course: &Course, bounds: &Bounds, fps: f64) -> bool {
    if bounds.jerk.is_infinite() {
        return true;
    }
    let last = knots.len() - 1;
    let piece = |from: Knot, to: Knot| {
        let time = to[0] - from[0];
        let c = cubic(from[1], to[1] - from[1], time, from[2], to[2]);
        let square = time * time;
        (
            [2.0 * c[2] / square, (6.0 * c[3] + 2.0 * c[2]) / square],
            time,
        )
    };
    let (whole, time) = piece(knots[0], knots[last]);
    let (first, begins) = piece(knots[0], knots[1]);
    let (end, ends) = piece(knots[last - 1], knots[last]);
    let ways = [knots[0][1], knots[last][1]].map(|way| course.at(way).tangent.length());
    let jump = ((whole[0] - first[0]).abs() * ways[0]).max((whole[1] - end[1]).abs() * ways[1]);
    let way = ways[0].max(ways[1]);
    let jerk = |[from, to]: [f64; 2], time: f64| (to - from).abs() / time * way;
    // Over less than a frame a window may make more.
    let most = bounds.jerk.max(jerk(first, begins)).max(jerk(end, ends));
    jump * fps <= JUMP * bounds.jerk && jerk(whole, time) <= most * (1.0 + 1e-6)
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
    if !(time > 0.0 && way > 0.0) || scale(way / time, from[2], to[2]) < 1.0 - 1e-6 {
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
