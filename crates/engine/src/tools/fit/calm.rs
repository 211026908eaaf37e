//! What the splines take for the poses: those that between two cuts, or in a pause, are one within
//! the tolerance are their mean, and those that are noise on an even motion are on it, since what is
//! left of them is noise, in which no piece could be long.

use std::iter;
use std::ops::Range;

use glam::{DQuat, DVec3};

use super::rests::Sums;
use super::{Data, Sample, view_angle};
use crate::error::{Result, vec_with_room};
use crate::math::quaternion::{exp, log};
use crate::tools::smooth::noise;

/// How far from the mean they may be, in tolerances.
const WITHIN: f64 = 0.95;

/// Noise below this, in tolerances, is ignored.
const LEAST: f64 = 1e-3;

/// Fewest poses of an even motion.
const FEWEST: f64 = 16.0;

/// Deviations of its estimate by which a residual may exceed the noise.
const CHANCE: f64 = 4.0;

/// What turns farther from its middle, on S³, has no logarithm to rely on.
const FARTHEST: f64 = 1.2;

/// An even motion.
struct Even {
    time: f64,
    /// Where it is then.
    middle: DVec3,
    speed: DVec3,
}

impl Even {
    fn at(&self, time: f64) -> DVec3 {
        self.middle + self.speed * (time - self.time)
    }
}

impl Data {
    /// Sets `calm`; `exact`: to the poses themselves.
    pub(super) fn calm_down(&mut self, exact: bool) -> Result<()> {
        self.calm.clear();
        self.calm.try_reserve_exact(self.raw.len())?;
        self.calm.extend_from_slice(&self.raw);
        if exact {
            return Ok(());
        }
        let mut begin = 0;
        for cut in 0..=self.cuts.len() {
            let end = self.cuts.get(cut).map_or(self.raw.len(), |cut| cut + 1);
            self.calm_side(begin, end)?;
            begin = end;
        }
        Ok(())
    }

    /// The poses between two cuts.
    fn calm_side(&mut self, begin: usize, end: usize) -> Result<()> {
        let all = begin..end;
        let Some(mean) = self.mean(all.clone()) else {
            return Ok(());
        };
        let stands = self.is_place(all.clone(), &mean);
        if stands {
            self.place(all.clone(), &mean);
        }
        let [turns, zooms] = self.moves(all.clone(), &mean);
        let calm = &mut self.calm[all.clone()];
        if !turns {
            calm.iter_mut().for_each(|sample| sample.turn = mean.turn);
        }
        if !zooms {
            calm.iter_mut().for_each(|sample| sample.zoom = mean.zoom);
        }
        let mut pauses = vec_with_room(1)?;
        if stands {
            pauses.push(all.clone());
        } else {
            let mut places = vec_with_room(end - begin)?;
            places.extend(
                self.raw[all.clone()]
                    .iter()
                    .map(|raw| raw.position.to_array()),
            );
            pauses = self.pauses(all.clone(), &places, self.tolerance)?;
            let mut from = begin;
            let beyond = end..end;
            for pause in pauses.iter().chain(iter::once(&beyond)) {
                let between = from..pause.start;
                from = pause.end;
                let rows = &places[between.start - begin..between.end - begin];
                if let Some(even) = self.even(between.clone(), rows, self.tolerance)? {
                    for k in between {
                        self.calm[k].position = even.at(self.times[k]);
                    }
                }
            }
            for pause in &pauses {
                if let Some(mean) = self.mean(pause.clone())
                    && self.is_place(pause.clone(), &mean)
                {
                    self.place(pause.clone(), &mean);
                }
            }
        }
        if turns && self.turns_evenly(all)? {
            return Ok(());
        }
        for pause in pauses.into_iter().filter(|_| turns) {
            let mut views = vec_with_room(pause.len())?;
            views.extend(
                self.raw[pause.clone()]
                    .iter()
                    .map(|raw| raw.turn.to_array()),
            );
            for pause in self.pauses(pause, &views, 0.5 * self.angle)? {
                let Some(mean) = self.mean(pause.clone()) else {
                    continue;
                };
                if self.moves(pause.clone(), &mean) == [false; 2] {
                    for sample in &mut self.calm[pause] {
                        (sample.turn, sample.zoom) = (mean.turn, mean.zoom);
                    }
                }
            }
        }
        Ok(())
    }

    /// Whether all turn evenly except for noise; then they do.
    fn turns_evenly(&mut self, all: Range<usize>) -> Result<bool> {
        let mut middle = self.raw[all.start + all.len() / 2].turn;
        let mut turned = vec_with_room(all.len())?;
        // The noise of the pose in the middle is in all of the first logarithms.
        for round in 0..2 {
            turned.clear();
            let raw = self.raw[all.clone()].iter();
            turned.extend(raw.map(|raw| log(raw.turn * middle.conjugate()).to_array()));
            let Some(even) = self.even(all.clone(), &turned, 0.5 * self.angle)? else {
                return Ok(false);
            };
            let far = [all.start, all.end - 1].map(|k| self.times[k] - even.time);
            if far
                .iter()
                .any(|time| (even.speed * *time).length() > FARTHEST)
            {
                return Ok(false);
            }
            middle = exp(even.middle) * middle;
            if round == 1 {
                for k in all.clone() {
                    self.calm[k].turn = exp(even.speed * (self.times[k] - even.time)) * middle;
                }
            }
        }
        Ok(true)
    }

    /// The line of which rows are noise, if they are.
    fn even(&self, all: Range<usize>, rows: &[[f64; 3]], allowed: f64) -> Result<Option<Even>> {
        let noise = noise(&self.times[all.clone()], rows)?;
        let counted = || {
            let counts = all.clone().zip(rows).filter(|(k, _)| !self.left_out[*k]);
            counts.map(|(k, row)| (self.times[k], DVec3::from_array(*row)))
        };
        let count = counted().count() as f64;
        if !(noise > LEAST * allowed && count >= FEWEST) {
            return Ok(None);
        }
        let time = counted().map(|(time, _)| time).sum::<f64>() / count;
        let middle = counted().map(|(_, row)| row).sum::<DVec3>() / count;
        let squares: f64 = counted().map(|(at, _)| (at - time) * (at - time)).sum();
        let speed = counted().map(|(at, row)| row * (at - time)).sum::<DVec3>() / squares;
        let even = Even {
            time,
            middle,
            speed,
        };
        let (mut far, mut missed) = (0.0_f64, DVec3::ZERO);
        for (at, row) in counted() {
            let off = row - even.at(at);
            far = far.max(off.length());
            missed += off * off;
        }
        let deviation = (missed.max_element() / count).sqrt();
        let is_noise = deviation <= (1.0 + CHANCE / count.sqrt()) * noise;
        Ok((far <= WITHIN * allowed && is_noise).then_some(even))
    }

    /// Runs of poses that are noise but no motion. Without noise their neighbours say so
    /// themselves.
    fn pauses<const N: usize>(
        &self,
        all: Range<usize>,
        rows: &[[f64; N]],
        allowed: f64,
    ) -> Result<Vec<Range<usize>>> {
        let noise = noise(&self.times[all.clone()], rows)?;
        if !(noise > LEAST * allowed) {
            return Ok(Vec::new());
        }
        let mut pauses = Sums::new(rows, noise)?.pauses()?;
        for pause in &mut pauses {
            *pause = all.start + pause.start..all.start + pause.end;
        }
        Ok(pauses)
    }

    /// Of the poses that count.
    fn mean(&self, poses: Range<usize>) -> Option<Sample> {
        let all = || self.counted(poses.clone());
        let count = all().count() as f64;
        let position = all().map(|sample| sample.position).sum::<DVec3>() / count;
        let turn = all().fold(DQuat::from_array([0.0; 4]), |sum, sample| sum + sample.turn);
        let zoom = all().map(|sample| sample.zoom).sum::<f64>() / count;
        let turn = turn.normalize();
        (count > 0.0 && turn.is_finite()).then_some(Sample {
            position,
            turn,
            zoom,
        })
    }

    fn counted(&self, poses: Range<usize>) -> impl Iterator<Item = &Sample> {
        let counts = poses.filter(|k| !self.left_out[*k]);
        counts.map(|k| &self.raw[k])
    }

    fn is_place(&self, poses: Range<usize>, mean: &Sample) -> bool {
        let most = WITHIN * self.tolerance;
        self.counted(poses)
            .all(|sample| sample.position.distance(mean.position) <= most)
    }

    fn place(&mut self, poses: Range<usize>, mean: &Sample) {
        for sample in &mut self.calm[poses] {
            sample.position = mean.position;
        }
    }

    /// Whether any turns or zooms by more than noise.
    fn moves(&self, poses: Range<usize>, mean: &Sample) -> [bool; 2] {
        let most = WITHIN * self.angle;
        let mut found = [false; 2];
        for sample in self.counted(poses) {
            let lens = view_angle(sample.zoom) - view_angle(mean.zoom);
            found[0] |= !(sample.off(mean.turn, sample.zoom) <= most);
            found[1] |= !(lens.abs() <= most);
        }
        found
    }
}
