//! Between two corners one piece, where it can be: at an even pace, by the poses themselves.

use glam::{DMat3, DVec3};

use super::motion::{Motion, Peaks, Stretch};
use super::pace::{Way, timing};
use super::piece::Course;
use super::{Data, Joint, Piece};
use crate::error::Result;
use crate::path::arc_length::ArcLength;
use crate::path::hermite::Cubic;
use crate::path::own;

/// Rounds of a cubic towards its poses.
const ROUNDS: usize = 20;

/// What it may miss, in tolerances, for no more rounds.
const NEAR: f64 = 0.02;

/// At most about this many poses determine its position.
const POSES: usize = 240;

/// Lengths of tangents that are tried, in ways.
const LENGTHS: [f64; 3] = [0.3, 1.0, 3.0];

/// No tangent is longer.
const LONGEST: f64 = 20.0;

/// What they may say nothing of stays: along a straight line a cubic may go in many ways.
const DAMPING: f64 = 1e-9;

impl Data {
    /// How many parts with corners between them, from one on, a single piece can be, and that piece;
    /// none where even the first part needs more, or beside no corner.
    pub(super) fn over_corners(
        &self,
        motion: &Motion,
        first: usize,
        joint: Joint,
        exact: bool,
    ) -> Result<(usize, Option<Piece>)> {
        let before = first > 0 && motion.corner(first - 1);
        if !(before || motion.corner(first)) {
            return Ok((1, None));
        }
        let Some(mut piece) =
            self.whole(&motion.stretches[first], motion.peaks, joint, &LENGTHS)?
        else {
            return Ok((1, None));
        };
        let most = (first..motion.parts.len())
            .take_while(|k| motion.corner(*k))
            .count()
            + 1;
        // Doubled as long as it goes, then halved.
        let (mut count, mut bad, mut step) = (1, most + 1, 1);
        while step > 0 {
            let next = (count + step).min(bad - 1);
            if next <= count {
                break;
            }
            let ends = [first, first + next - 1];
            let stretch = self.stretch(&motion.parts, ends, exact, &mut || Ok(()))?;
            match self.whole(&stretch, motion.peaks, joint, &[])? {
                Some(longer) => (piece, count) = (longer, next),
                None => bad = next,
            }
            step = if bad > most {
                2 * step
            } else {
                (bad - count) / 2
            };
        }
        Ok((count, Some(piece)))
    }

    /// Across a cut, to where the other side is at the frame of its end.
    pub(super) fn crossing(&self, motion: &Motion, number: usize, joint: Joint) -> Result<Piece> {
        let [begin, end] = motion.stretches[number].frames;
        let beyond = motion.stretches.get(number + 1);
        let to = beyond.unwrap_or(&motion.stretches[number]).at(end).sample;
        self.straight(end - begin, joint, to)
    }

    /// All of a stretch as one piece; none if it cannot be one.
    /// Tangents of such lengths, in ways, are tried where those of the splines lead nowhere.
    fn whole(
        &self,
        stretch: &Stretch,
        peaks: Peaks,
        joint: Joint,
        lengths: &[f64],
    ) -> Result<Option<Piece>> {
        let mut course = Course::new(stretch, stretch.frames, joint, [true; 2], peaks)?;
        if let Some((start, _)) = self.cubic(&course)?
            && let Some(curve) = self.by_poses(start, stretch, joint.sample.position, lengths)?
        {
            let arc = ArcLength::new(&curve)?;
            let pace = own::distance(&[[0.0, 0.0], [1.0, 1.0]])?;
            let way = Way {
                curve: Some(curve),
                length: arc.length(),
                timing: timing(&pace)?,
                pace,
            };
            let place = |way: f64| curve.point(arc.parameter_at(way * arc.length()));
            course.must = true;
            if let Some(piece) = self.finished(&course, way, &place)?
                && (0..2).all(|k| piece.missed[k].sqrt() <= self.near[k])
            {
                return Ok(Some(piece));
            }
            course.must = false;
        }
        self.moving(&course)
    }

    /// The first of several beginnings that leads to a cubic within the tolerance.
    fn by_poses(
        &self,
        start: Cubic,
        stretch: &Stretch,
        from: DVec3,
        lengths: &[f64],
    ) -> Result<Option<Cubic>> {
        let place = |k: usize| self.raw[k].position;
        let (first, last) = (stretch.first, stretch.last);
        let directions = [
            place(first + 1) - place(first),
            place(last) - place(last - 1),
        ];
        let [leave, reach] = directions.map(DVec3::normalize_or_zero);
        let way: f64 = (first..last).map(|k| place(k).distance(place(k + 1))).sum();
        let tangents = [start.derivative(0.0), start.derivative(1.0)];
        let most = LONGEST * way;
        let found = self.nearer(stretch, from, tangents, most)?;
        if found.is_some() {
            return Ok(found);
        }
        for a in lengths {
            for b in lengths {
                let tangents = [leave * (a * way), reach * (b * way)];
                let found = self.nearer(stretch, from, tangents, most)?;
                if found.is_some() {
                    return Ok(found);
                }
            }
        }
        Ok(None)
    }

    /// A cubic with tangents no longer than `most` that goes through the poses of a stretch at an even
    /// pace; none if none does within the tolerance. Gauss–Newton for its tangents, by what it misses across its way: what it
    /// misses along it says only that its length is another one (tangent distances: Wang, Pottmann,
    /// Liu, *Fitting B-spline curves to point clouds*, 2006).
    fn nearer(
        &self,
        stretch: &Stretch,
        from: DVec3,
        mut tangents: [DVec3; 2],
        most: f64,
    ) -> Result<Option<Cubic>> {
        let (first, last) = (stretch.first, stretch.last);
        let [begin, end] = stretch.frames;
        let skip = (last - first).div_ceil(POSES).max(1);
        // The last pose may be behind the frame at which it ends.
        let to = stretch.at(end).sample.position;
        let mut step = [DVec3::ZERO; 2];
        let mut best: Option<(f64, f64, [DVec3; 2])> = None;
        for _ in 0..ROUNDS {
            let curve = Cubic::hermite(from, to, tangents[0], tangents[1]);
            let arc = ArcLength::new(&curve)?;
            let (mut worst, mut squares) = (0.0_f64, 0.0);
            let (mut m, mut right) = ([DMat3::ZERO; 3], [DVec3::ZERO; 2]);
            for k in (first + 1..last).step_by(skip) {
                let share = (self.times[k] - begin) / (end - begin);
                let t = arc.parameter_at(share * arc.length());
                let off = self.raw[k].position - curve.point(t);
                worst = worst.max(off.length());
                squares += off.length_squared();
                let along = curve.derivative(t).normalize_or_zero();
                let columns = along.to_array().map(|part| along * part);
                let across =
                    DMat3::IDENTITY - DMat3::from_cols_array_2d(&columns.map(|c| c.to_array()));
                let (x, y) = (t * (1.0 - t) * (1.0 - t), -t * t * (1.0 - t));
                let products = [x * x, x * y, y * y];
                m = std::array::from_fn(|k| m[k] + across * products[k]);
                let off = across * off;
                right = [right[0] + x * off, right[1] + y * off];
            }
            if worst <= NEAR * self.tolerance {
                return Ok(Some(curve));
            }
            if best.is_none_or(|best| squares < best.0) {
                best = Some((squares, worst, tangents));
                let Some(found) = solved(m, right) else {
                    break;
                };
                step = found;
            } else {
                step = step.map(|part| 0.25 * part);
            }
            let Some((.., were)) = best else { break };
            tangents = [0, 1].map(|end| (were[end] + step[end]).clamp_length_max(most));
        }
        let near = best.filter(|best| best.1 <= self.tolerance);
        Ok(near.map(|(.., [leave, reach])| Cubic::hermite(from, to, leave, reach)))
    }
}

/// Two unknown vectors by their normal equations.
fn solved(m: [DMat3; 3], right: [DVec3; 2]) -> Option<[DVec3; 2]> {
    let trace = |m: DMat3| m.x_axis.x + m.y_axis.y + m.z_axis.z;
    let damped = |m: DMat3| m + DMat3::IDENTITY * (DAMPING * trace(m));
    let (a, b, c) = (damped(m[0]), m[1], damped(m[2]));
    let inverse = c.inverse();
    let schur = a - b * inverse * b.transpose();
    let x = schur.inverse() * (right[0] - b * inverse * right[1]);
    let y = inverse * (right[1] - b.transpose() * x);
    (x.is_finite() && y.is_finite()).then_some([x, y])
}
