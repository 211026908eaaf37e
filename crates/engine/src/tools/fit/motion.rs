//! What recorded poses say about each moment: rests and turns on the spot as they are, between them
//! smooth splines that take a share of the tolerance.

use std::ops::RangeInclusive;

use glam::{DQuat, DVec3, DVec4};

use super::{Data, Follow, Sample, view_angle};
use crate::error::{Invalid, Result, vec_with_room};
use crate::limits::{MAX_ZOOM, MIN_ZOOM};
use crate::tools::smooth::{Spline, noise};

/// The shares of the tolerance that the splines may take, without noise and with much; the rest is
/// for the pieces.
const SHARES: [f64; 2] = [0.3, 0.95];

/// Standard deviations of a coordinate by which bounded noise misses a pose at most: at the corner of
/// a cube three.
const DEVIATIONS: f64 = 3.5;

/// What moves by less than this share of the tolerance rests,
const STILL: f64 = 1e-4;

/// if it does for at least this many frames,
const REST: f64 = 12.0;

/// or for this many without any motion.
const PAUSE: f64 = 4.0;

/// Poses that differ by at most this, in tolerances, are equal.
const EQUAL: f64 = 1e-9;

/// A motion is even whose acceleration would take more than 20 seconds to double its speed (per
/// second): no share of it says what is smooth,
const EVEN: f64 = 0.05;

/// so instead a share of what doubles it in a tenth of a second does.
const UNSEEN: f64 = 10.0;

/// Poses beyond its ends that the splines of a stretch include.
const LEAD: usize = 12;

/// One of this many poses before another has the right sign.
const BEFORE: usize = 6;

/// So many standard deviations of the noise no pose is off that is no outlier.
const OUTSTANDING: f64 = 6.0;

/// Rounds in which poses are left out and taken in again.
const AGAIN: usize = 8;

/// At most one of this many poses is left out.
const MOST: usize = 4;

/// What the camera does in a stretch.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Kind {
    Moves,
    /// Turns or zooms on the spot.
    Turns,
    Rests,
}

/// Poses of one kind, both ends among them. Two that move meet at a corner.
#[derive(Clone)]
pub(super) struct Part {
    pub kind: Kind,
    range: RangeInclusive<usize>,
    /// The pose where it stands, if it does.
    spot: usize,
    /// The whole frames at its ends.
    frames: [f64; 2],
}

/// What poses do, one after the other.
pub(super) struct Motion {
    pub parts: Vec<Part>,
    /// One for each.
    pub stretches: Vec<Stretch>,
    /// Of them.
    pub peaks: Peaks,
}

/// Accelerations of the position and of the turning on S³.
#[derive(Clone, Copy, Default)]
pub(super) struct Peaks {
    /// The greatest ones.
    pub greatest: [f64; 2],
    /// What noise may make of them.
    pub unsure: [f64; 2],
    /// Whether there is a motion, but nearly none.
    pub even: [bool; 2],
}

/// So many standard deviations of what noise leaves in an acceleration say nothing.
const UNSURE: f64 = 1.0;

impl Motion {
    /// Whether a part ends at a corner.
    pub(super) fn corner(&self, number: usize) -> bool {
        let moves = |part: &Part| part.kind == Kind::Moves;
        moves(&self.parts[number]) && self.parts.get(number + 1).is_some_and(moves)
    }
}

/// The poses of a stretch, both ends among them, and what is between.
pub(super) struct Stretch {
    pub kind: Kind,
    pub first: usize,
    pub last: usize,
    /// The whole frames at its ends.
    pub frames: [f64; 2],
    /// Number of poses before the first that the splines include.
    lead: usize,
    place: Spline<3>,
    turn: Spline<4>,
    zoom: Spline<1>,
}

/// Where the camera is at a time, and how it changes in a frame.
#[derive(Clone, Copy)]
pub(super) struct State {
    pub sample: Sample,
    pub velocity: DVec3,
    /// On S³.
    pub spin: DVec3,
    pub zooming: f64,
    /// The derivatives of velocity and spin.
    pub bends: [DVec3; 2],
}

/// By how much a zoom may change for an angle of the field of view.
pub(super) fn zoom_within(zoom: f64, angle: f64) -> f64 {
    angle * (zoom * zoom + 144.0) / 24.0
}

impl Stretch {
    pub(super) fn at(&self, time: f64) -> State {
        let [place, velocity, bend] = self.place.at(time).map(DVec3::from_array);
        let [turn, turning, twist] = self.turn.at(time).map(DQuat::from_array);
        let [[zoom], [zooming], _] = self.zoom.at(time);
        let size = turn.length();
        let turn = turn / size;
        // Of the derivatives, what lies across the quaternion turns.
        let [spin, twist] = [turning, twist].map(|part| (part / size) * turn.conjugate());
        let (grows, spin) = (spin.w, spin.xyz());
        State {
            sample: Sample {
                position: place,
                turn,
                zoom: zoom.clamp(MIN_ZOOM, MAX_ZOOM),
            },
            velocity,
            spin,
            zooming,
            bends: [bend, twist.xyz() - 2.0 * grows * spin],
        }
    }

    /// The greatest speeds and accelerations, of the position and on S³.
    fn peaks(&self) -> [[f64; 2]; 2] {
        let [mut speeds, mut peaks] = [[0.0_f64; 2]; 2];
        let rows = self.lead..=self.lead + self.last - self.first;
        let place = |row: usize| DVec3::from_array(*self.place.value(row));
        let turn = |row: usize| DVec4::from_array(*self.turn.value(row)).normalize();
        for row in rows.clone() {
            let turn = turn(row);
            let bend = DVec4::from_array(*self.turn.bend(row));
            let across = bend - turn * turn.dot(bend);
            let place = DVec3::from_array(*self.place.bend(row));
            peaks = [peaks[0].max(place.length()), peaks[1].max(across.length())];
        }
        for row in rows.skip(1) {
            let by = self.turn.time(row) - self.turn.time(row - 1);
            speeds[0] = speeds[0].max(place(row).distance(place(row - 1)) / by);
            speeds[1] = speeds[1].max(turn(row).distance(turn(row - 1)) / by);
        }
        [speeds, peaks]
    }
}

/// The noise of the rows of a spline.
#[derive(Clone, Copy)]
struct Noise {
    /// Standard deviation of a channel.
    deviation: f64,
    /// The same if it misses some rows by more than [`DEVIATIONS`], else 0: then the splines must not
    /// turn to these.
    unbounded: f64,
    /// Whether the splines have not room enough for it anyway.
    counts: bool,
}

impl Noise {
    /// Noise that the splines have room enough for anyway counts as bounded.
    fn of<const N: usize>(
        times: &[f64],
        rows: &[[f64; N]],
        allowed: f64,
        exact: bool,
        round: &mut dyn FnMut() -> Result<()>,
    ) -> Result<Self> {
        let deviation = noise(times, rows)?;
        let most = DEVIATIONS * deviation;
        let counts = !exact && most > SHARES[0] * allowed;
        let unbounded = counts && Spline::outgrows(times, rows, deviation, most, round)?;
        Ok(Self {
            deviation,
            unbounded: if unbounded { deviation } else { 0.0 },
            counts,
        })
    }
}

impl Data {
    /// With the noise left in, unless it follows smoothly.
    pub(super) fn motion(
        &mut self,
        follow: Follow,
        round: &mut dyn FnMut() -> Result<()>,
    ) -> Result<Motion> {
        let exact = follow != Follow::Smoothly;
        let all = 0..=self.raw.len() - 1;
        let mut parts = Vec::new();
        self.calm_down(exact)?;
        let place = |a: &Sample, b: &Sample| a.position.distance(b.position) / self.tolerance;
        let view = |a: &Sample, b: &Sample| a.off(b.turn, b.zoom) / self.angle;
        let corners = self.corners()?;
        for (on_the_spot, range) in self.runs(all, &place)? {
            let spot = *range.start();
            if on_the_spot {
                for (rests, range) in self.runs(range, &view)? {
                    let kind = if rests { Kind::Rests } else { Kind::Turns };
                    parts.try_reserve(1)?;
                    parts.push(Part {
                        kind,
                        range,
                        spot,
                        frames: [0.0; 2],
                    });
                }
                continue;
            }
            let (mut first, last) = range.into_inner();
            let within = corners.iter().filter(|at| (first + 1..last).contains(at));
            for end in within.copied().chain([last]).collect::<Vec<_>>() {
                parts.try_reserve(1)?;
                parts.push(Part {
                    kind: Kind::Moves,
                    range: first..=end,
                    spot: first,
                    frames: [0.0; 2],
                });
                first = end;
            }
        }
        self.set_frames(&mut parts, follow);
        let mut stretches = vec_with_room(parts.len())?;
        let mut most = [[0.0_f64; 2]; 2];
        let mut unsure = [0.0_f64; 2];
        for k in 0..parts.len() {
            let stretch = self.stretch(&parts, [k, k], exact, round)?;
            for (most, now) in most
                .iter_mut()
                .flatten()
                .zip(stretch.peaks().as_flattened())
            {
                *most = most.max(*now);
            }
            let left = [stretch.place.bend_noise(), stretch.turn.bend_noise()];
            unsure = [0, 1].map(|k| unsure[k].max(UNSURE * left[k]));
            stretches.push(stretch);
        }
        let [speeds, mut greatest] = most;
        let even = [0, 1].map(|k| greatest[k] < EVEN * speeds[k] / self.fps);
        for k in (0..2).filter(|k| even[*k]) {
            greatest[k] = UNSEEN * speeds[k] / self.fps;
        }
        Ok(Motion {
            parts,
            stretches,
            peaks: Peaks {
                greatest,
                unsure,
                even,
            },
        })
    }

    /// Whether a part is a cut: neither side says anything of the other.
    pub(super) fn is_cut(&self, part: &Part) -> bool {
        let (first, last) = (part.range.start(), part.range.end());
        *last == first + 1 && self.cuts.binary_search(first).is_ok()
    }

    /// Where parts meet between frames, the one that moves less has no more than its whole frames.
    fn set_frames(&self, parts: &mut [Part], follow: Follow) {
        let last = self.times[self.times.len() - 1];
        let mut begin = 0.0;
        for k in 0..parts.len() {
            let time = self.times[*parts[k].range.end()];
            let cut = self.is_cut(&parts[k]);
            let still = parts
                .get(k + 1)
                .is_some_and(|next| next.kind > parts[k].kind);
            let end = match (follow, still && !cut) {
                // Where the points are.
                (Follow::ByPoints, _) => time.round(),
                (_, true) => time.ceil(),
                (_, false) => time.floor(),
            };
            // A cut takes a frame, whatever is left for what follows.
            let least = begin + f64::from(u8::from(cut));
            let end = end.max(least).min(last);
            parts[k].frames = [begin, end];
            begin = end;
        }
    }

    /// Runs of poses that stay within `STILL`, and what lies between; neighbours share their ends.
    fn runs(
        &self,
        range: RangeInclusive<usize>,
        apart: &dyn Fn(&Sample, &Sample) -> f64,
    ) -> Result<Vec<(bool, RangeInclusive<usize>)>> {
        let (mut at, last) = range.into_inner();
        let mut runs = Vec::new();
        let mut begin = at;
        while at < last {
            let still =
                |k: &usize| self.left_out[*k] || apart(&self.calm[at], &self.calm[*k]) <= STILL;
            // Whether it rests in what is left out, the pose behind says.
            let there = |k: &usize| !self.left_out[*k];
            let end = (at + 1..=last).take_while(still).filter(there).last();
            let end = end.unwrap_or(at);
            let frames = self.times[end].floor() - self.times[at].ceil();
            let equal = |k: usize| apart(&self.calm[at], &self.calm[k]) <= EQUAL;
            if frames >= REST || frames >= PAUSE && (at..=end).all(equal) {
                runs.try_reserve(2)?;
                if begin < at {
                    runs.push((false, begin..=at));
                }
                runs.push((true, at..=end));
                begin = end;
            }
            at = end.max(at + 1);
        }
        if begin < last {
            runs.try_reserve(1)?;
            runs.push((false, begin..=last));
        }
        Ok(runs)
    }

    /// Of a part, or of several with corners between them. Its splines know some poses of its
    /// neighbours, too: so they leave a rest as gently as the camera does; but not beyond a corner.
    pub(super) fn stretch(
        &self,
        parts: &[Part],
        numbers: [usize; 2],
        exact: bool,
        round: &mut dyn FnMut() -> Result<()>,
    ) -> Result<Stretch> {
        let Part {
            kind,
            range,
            spot,
            frames: [begin_frame, _],
        } = &parts[numbers[0]];
        let frames = [*begin_frame, parts[numbers[1]].frames[1]];
        let (first, last) = (*range.start(), *parts[numbers[1]].range.end());
        let beside = [numbers[0].checked_sub(1), Some(numbers[1] + 1)];
        let beside = beside.map(|number| parts.get(number?));
        let cut = self.is_cut(&parts[numbers[0]]);
        let corner = beside.map(|beside| {
            beside.is_some_and(|part| {
                let moves = *kind == Kind::Moves && part.kind == Kind::Moves;
                moves || cut || self.is_cut(part)
            })
        });
        let leads = [0, 1].map(|side| beside[side].is_some() && !corner[side]);
        let begin = first.saturating_sub(if leads[0] { LEAD } else { 0 });
        let end = (last + if leads[1] { LEAD } else { 0 }).min(self.raw.len() - 1);
        let all = begin..=end;
        let times = &self.times[all.clone()];
        // Of two neighbours one stands on the spot, or they are held where they meet.
        let stands = beside.map(|beside| beside.is_some());
        let rests = [0, 1]
            .map(|side| corner[side] || beside[side].is_some_and(|part| part.kind == Kind::Rests));
        let at = |k: usize, held: [bool; 2], before: usize| match k {
            k if held[0] && k <= first => before,
            k if held[1] && k >= last => last,
            k => k,
        };
        let [left, rested] = match beside[0] {
            Some(part) if leads[0] => [part.spot, *part.range.start()],
            _ => [first; 2],
        };
        let share = |noise: Noise, allowed: f64, k: usize, held: [bool; 2]| {
            if self.left_out[k] && !(exact && k >= self.poses()) {
                return f64::INFINITY;
            }
            if exact || (held[0] && k <= first) || (held[1] && k >= last) {
                return 0.0;
            }
            let to_end = [0, 1].map(|side| {
                let free = stands[side] && !held[side];
                let far = (self.times[k] - self.times[[first, last][side]]).abs() / REST;
                if free { 1.0 } else { far }
            });
            let to_end = to_end[0].min(to_end[1]);
            let least = SHARES[0] * (to_end * to_end).clamp(0.02, 1.0);
            let noise = if noise.unbounded > 0.0 {
                f64::INFINITY
            } else {
                noise.deviation
            };
            (DEVIATIONS * noise).clamp(least * allowed, SHARES[1] * allowed)
        };
        let mut allowed: Vec<f64> = vec_with_room(times.len())?;
        let mut places: Vec<[f64; 3]> = vec_with_room(times.len())?;
        let mut turns: Vec<[f64; 4]> = vec_with_room(times.len())?;
        let mut zooms: Vec<[f64; 1]> = vec_with_room(times.len())?;
        let (stays, rest) = (*kind != Kind::Moves, *kind == Kind::Rests);
        for k in all.clone() {
            let place = &self.calm[if stays { *spot } else { at(k, stands, left) }];
            let view = &self.calm[if rest { first } else { at(k, rests, rested) }];
            places.push(place.position.to_array());
            turns.push(view.turn.to_array());
            zooms.push([view.zoom]);
        }
        let now = Noise::of(times, &places, self.tolerance, exact, round)?;
        allowed.extend(all.clone().map(|k| share(now, self.tolerance, k, stands)));
        let place = Spline::near(times, &places, &allowed, now.unbounded, now.counts, round)?;
        allowed.clear();
        // On S³ an angle counts half.
        let now = Noise::of(times, &turns, 0.5 * self.angle, exact, round)?;
        allowed.extend(all.clone().map(|k| share(now, 0.5 * self.angle, k, rests)));
        let turn = Spline::near(times, &turns, &allowed, now.unbounded, now.counts, round)?;
        let within = zoom_within(self.raw[first].zoom, self.angle);
        let now = Noise::of(times, &zooms, within, exact, round)?;
        allowed.clear();
        allowed.extend(all.map(|k| {
            let within = zoom_within(self.raw[k].zoom, self.angle);
            share(now, within, k, rests)
        }));
        let zoom = Spline::near(times, &zooms, &allowed, now.unbounded, now.counts, round)?;
        Ok(Stretch {
            kind: *kind,
            first,
            last,
            frames,
            lead: first - begin,
            place,
            turn,
            zoom,
        })
    }

    /// Leaves out poses that are off by more than the tolerance from what the others say.
    pub(super) fn leave_out(&mut self) -> Result<()> {
        let count = self.raw.len();
        let mut places: Vec<[f64; 3]> = vec_with_room(count)?;
        let mut turns: Vec<[f64; 4]> = vec_with_room(count)?;
        let mut angles: Vec<[f64; 1]> = vec_with_room(count)?;
        for k in 0..count {
            // The sign of a quaternion that is off says nothing of those behind it.
            let before = &self.raw[k.saturating_sub(BEFORE)..k];
            let nearest = |turn: DQuat| {
                let far = before.iter().map(|sample| (sample.turn - turn).length());
                far.fold(f64::INFINITY, f64::min)
            };
            let turn = self.raw[k].turn;
            if nearest(-turn) < nearest(turn) {
                self.raw[k].turn = -turn;
            }
            let sample = &self.raw[k];
            places.push(sample.position.to_array());
            turns.push(sample.turn.to_array());
            angles.push([view_angle(sample.zoom)]);
        }
        let mut found: Vec<Sample> = vec_with_room(count)?;
        let mut off: Vec<bool> = vec_with_room(count)?;
        let times = &self.times;
        // On S³ an angle counts half.
        let noises = [
            noise(times, &places)?,
            noise(times, &turns)?,
            noise(times, &angles)?,
        ];
        let given = [self.tolerance, 0.5 * self.angle, self.angle];
        let most: [f64; 3] = std::array::from_fn(|k| given[k].max(OUTSTANDING * noises[k]));
        // What is off draws those beside it along: so again without what seemed to be.
        for _ in 0..AGAIN {
            let out = &self.left_out;
            let place = Spline::robust(times, &places, 0.5 * most[0], noises[0], out)?;
            let turn = Spline::robust(times, &turns, 0.5 * most[1], noises[1], out)?;
            let angle = Spline::robust(times, &angles, 0.5 * most[2], noises[2], out)?;
            found.clear();
            found.extend((0..count).map(|k| Sample {
                position: DVec3::from_array(*place.value(k)),
                turn: DQuat::from_array(*turn.value(k)).normalize(),
                zoom: (12.0 / (0.5 * angle.value(k)[0]).tan()).clamp(MIN_ZOOM, MAX_ZOOM),
            }));
            off.clear();
            off.extend(self.raw.iter().zip(&found).map(|(sample, found)| {
                found.position.distance(sample.position) > most[0]
                    || sample.off(found.turn, found.zoom) > (2.0 * most[1]).max(most[2])
            }));
            if off == self.left_out {
                break;
            }
            self.left_out.copy_from_slice(&off);
        }
        let all = self.left_out.iter().filter(|out| **out).count();
        if all * MOST > count {
            return Err(Invalid::Outliers {
                off: all,
                all: count,
            }
            .into());
        }
        for ((sample, found), out) in self.raw.iter_mut().zip(found).zip(&self.left_out) {
            if *out {
                *sample = found;
            }
        }
        Ok(())
    }
}
