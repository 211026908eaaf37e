//! What recorded poses say about each moment: rests and turns on the spot as they are, between them
//! smooth splines that take a share of the tolerance.

use std::ops::RangeInclusive;

use glam::{DQuat, DVec3, DVec4};

use super::{Data, Sample, view_angle};
use crate::error::{Invalid, Result, vec_with_room};
use crate::limits::{MAX_ZOOM, MIN_ZOOM};
use crate::tools::smooth::{Spline, noise};

/// The shares of the tolerance that the splines may take, without noise and with much; the rest is
/// for the pieces.
const SHARES: [f64; 2] = [0.3, 0.85];

/// So many standard deviations of the noise the splines may miss.
const DEVIATIONS: f64 = 3.5;

/// What moves by less than this share of the tolerance rests,
const STILL: f64 = 1e-4;

/// if it does for so many frames.
const REST: f64 = 12.0;

/// One of the last so many poses is right.
const BEFORE: usize = 6;

/// Rounds in which poses are left out and taken in again.
const AGAIN: usize = 8;

/// No more than one pose of so many is left out.
const MOST: usize = 4;

/// What the camera does in a stretch.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    Moves,
    /// Turns or zooms on the spot.
    Turns,
    Rests,
}

/// The poses of a stretch, both ends among them, and what is between.
pub(super) struct Stretch {
    pub kind: Kind,
    pub first: usize,
    pub last: usize,
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
}

fn zoom_row(sample: &Sample) -> [f64; 1] {
    [sample.zoom]
}

/// By how much a zoom may change for an angle of the field of view.
fn zoom_within(zoom: f64, angle: f64) -> f64 {
    angle * (zoom * zoom + 144.0) / 24.0
}

impl Stretch {
    pub(super) fn at(&self, time: f64) -> State {
        let [place, velocity] = self.place.at(time).map(DVec3::from_array);
        let [turn, turning] = self.turn.at(time).map(DQuat::from_array);
        let [[zoom], [zooming]] = self.zoom.at(time);
        let size = turn.length();
        let turn = turn / size;
        // Of the derivative, what lies across the quaternion turns.
        let spin = (turning / size) * turn.conjugate();
        State {
            sample: Sample {
                position: place,
                turn,
                zoom: zoom.clamp(MIN_ZOOM, MAX_ZOOM),
            },
            velocity,
            spin: DVec3::new(spin.x, spin.y, spin.z),
            zooming,
        }
    }

    /// The greatest accelerations, of the position and on S³.
    fn peaks(&self) -> [f64; 2] {
        let mut peaks = [0.0_f64; 2];
        for row in 0..=self.last - self.first {
            let turn = DVec4::from_array(*self.turn.value(row)).normalize();
            let bend = DVec4::from_array(*self.turn.bend(row));
            let across = bend - turn * turn.dot(bend);
            let place = DVec3::from_array(*self.place.bend(row));
            peaks = [peaks[0].max(place.length()), peaks[1].max(across.length())];
        }
        peaks
    }
}

impl Data {
    /// The stretches, and the greatest accelerations in them. `exact`: with the noise left in.
    pub(super) fn stretches(
        &self,
        exact: bool,
        round: &mut dyn FnMut() -> Result<()>,
    ) -> Result<(Vec<Stretch>, [f64; 2])> {
        let all = 0..=self.raw.len() - 1;
        let mut found = Vec::new();
        let mut peaks = [0.0_f64; 2];
        let place = |a: &Sample, b: &Sample| a.position.distance(b.position) / self.tolerance;
        let view = |a: &Sample, b: &Sample| a.off(b.turn, b.zoom) / self.angle;
        for (on_the_spot, range) in self.runs(all, &place)? {
            let parts = if on_the_spot {
                self.runs(range, &view)?
            } else {
                vec![(false, range)]
            };
            for (rests, range) in parts {
                let kind = match (on_the_spot, rests) {
                    (false, _) => Kind::Moves,
                    (true, false) => Kind::Turns,
                    (true, true) => Kind::Rests,
                };
                let stretch = self.stretch(kind, range, exact, round)?;
                let now = stretch.peaks();
                peaks = [peaks[0].max(now[0]), peaks[1].max(now[1])];
                found.try_reserve(1)?;
                found.push(stretch);
            }
        }
        Ok((found, peaks))
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
                |k: &usize| self.left_out[*k] || apart(&self.raw[at], &self.raw[*k]) <= STILL;
            // Whether it rests in what is left out, the pose behind says.
            let there = |k: &usize| !self.left_out[*k];
            let end = (at + 1..=last).take_while(still).filter(there).last();
            let end = end.unwrap_or(at);
            if self.times[end].round() - self.times[at].round() >= REST {
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

    fn stretch(
        &self,
        kind: Kind,
        range: RangeInclusive<usize>,
        exact: bool,
        round: &mut dyn FnMut() -> Result<()>,
    ) -> Result<Stretch> {
        let (first, last) = range.into_inner();
        let (raw, times) = (&self.raw[first..=last], &self.times[first..=last]);
        // What follows or went before rests there.
        let free = |k: usize| match k {
            0 => first == 0,
            k => k + 1 < raw.len() || last + 1 == self.raw.len(),
        };
        let share = |noise: f64, allowed: f64, k: usize| {
            if self.left_out[first + k] {
                return f64::INFINITY;
            }
            if exact || !free(k) {
                return 0.0;
            }
            let last = raw.len() - 1;
            let to_end = (times[k] - times[0]).min(times[last] - times[k]) / REST;
            let least = SHARES[0] * (to_end * to_end).clamp(0.02, 1.0);
            (DEVIATIONS * noise).clamp(least * allowed, SHARES[1] * allowed)
        };
        let mut allowed: Vec<f64> = vec_with_room(raw.len())?;
        let mut places: Vec<[f64; 3]> = vec_with_room(raw.len())?;
        let mut turns: Vec<[f64; 4]> = vec_with_room(raw.len())?;
        let mut zooms: Vec<[f64; 1]> = vec_with_room(raw.len())?;
        let (spot, rest) = (kind != Kind::Moves, kind == Kind::Rests);
        for sample in raw {
            places.push(if spot { &raw[0] } else { sample }.position.to_array());
            turns.push(if rest { &raw[0] } else { sample }.turn.to_array());
            zooms.push(zoom_row(if rest { &raw[0] } else { sample }));
        }
        let all = 0..raw.len();
        let now = noise(&places)?;
        allowed.extend(all.clone().map(|k| share(now, self.tolerance, k)));
        let place = Spline::near(times, &places, &allowed, round)?;
        allowed.clear();
        let now = noise(&turns)?;
        // On S³ an angle counts half.
        allowed.extend(all.map(|k| share(now, 0.5 * self.angle, k)));
        let turn = Spline::near(times, &turns, &allowed, round)?;
        let now = noise(&zooms)?;
        for (k, allowed) in allowed.iter_mut().enumerate() {
            *allowed = share(now, zoom_within(raw[k].zoom, self.angle), k);
        }
        let zoom = Spline::near(times, &zooms, &allowed, round)?;
        Ok(Stretch {
            kind,
            first,
            last,
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
        // What is off draws those beside it along: so again without what seemed to be.
        for _ in 0..AGAIN {
            let out = &self.left_out;
            let place = Spline::robust(&self.times, &places, 0.5 * self.tolerance, out)?;
            // On S³ an angle counts half.
            let turn = Spline::robust(&self.times, &turns, 0.25 * self.angle, out)?;
            let angle = Spline::robust(&self.times, &angles, 0.5 * self.angle, out)?;
            found.clear();
            found.extend((0..count).map(|k| Sample {
                position: DVec3::from_array(*place.value(k)),
                turn: DQuat::from_array(*turn.value(k)).normalize(),
                zoom: (12.0 / (0.5 * angle.value(k)[0]).tan()).clamp(MIN_ZOOM, MAX_ZOOM),
            }));
            off.clear();
            off.extend(self.raw.iter().zip(&found).map(|(sample, found)| {
                found.position.distance(sample.position) > self.tolerance
                    || sample.off(found.turn, found.zoom) > self.angle
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
