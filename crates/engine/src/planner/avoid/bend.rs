//! The curve of a stretch, bent until it is clear: each place is moved by a displacement that is a
//! cubic of the curve parameter between knots, so that the new curve is of cubics too, and whatever
//! is not displaced stays to the last bit.
//!
//! Where it is too near, the knots beside are moved towards the way round by the least changes that
//! bring it there (least norm); where that does not converge a knot is put in. At last knots are
//! taken out again, and the others brought back as far as the curve stays clear.

use glam::DVec3;

use super::field::{Fault, Field};
use crate::error::{Result, vec_with_room};
use crate::path::hermite::Cubic;

/// Rounds of moving before a knot is put in.
const ROUNDS: usize = 16;

/// Knots put into a stretch, at most.
const KNOTS: usize = 48;

/// Share of a leg between two knots, at least; the lesser ones where a way is too winding for it.
pub(super) const APART: [f64; 3] = [0.02, 0.005, 0.001];

/// Beyond the place that is just clear.
const BEYOND: f64 = 1.04;

/// Sides from which a knot is brought back.
const WAYS: usize = 8;

/// Halvings when a knot is brought back.
const HALVINGS: usize = 9;

/// The way round a fault, by arc length over the parameters of the curve.
#[derive(Debug)]
pub(super) struct Detour {
    pub from: f64,
    pub to: f64,
    pub line: Vec<DVec3>,
}

impl Detour {
    pub(super) fn place(&self, u: f64) -> DVec3 {
        let lengths = self.line.windows(2).map(|pair| pair[0].distance(pair[1]));
        let all: f64 = lengths.clone().sum();
        let mut left = all * ((u - self.from) / (self.to - self.from)).clamp(0.0, 1.0);
        for (k, length) in lengths.enumerate() {
            if left <= length {
                let share = left / length.max(f64::MIN_POSITIVE);
                return self.line[k].lerp(self.line[k + 1], share);
            }
            left -= length;
        }
        self.line[self.line.len() - 1]
    }

    /// The parameters of its ends and corners.
    fn corners(&self) -> impl Iterator<Item = f64> {
        let lengths = self.line.windows(2).map(|pair| pair[0].distance(pair[1]));
        let all: f64 = lengths.clone().sum();
        let mut way = 0.0;
        [0.0].into_iter().chain(lengths).map(move |length| {
            way += length;
            self.from + (self.to - self.from) * (way / all).min(1.0)
        })
    }
}

/// Where the displacement is given.
#[derive(Debug, Clone, Copy)]
pub(super) struct Knot {
    /// Legs from the beginning of the way.
    pub u: f64,
    pub delta: DVec3,
    /// It stays.
    pub fixed: bool,
    /// Its tangent stays.
    pub still: bool,
    /// Not a point of the path.
    pub new: bool,
}

/// What a stretch is made of.
pub(super) struct Bend<'a, 'w> {
    pub field: Field<'w>,
    pub legs: &'a [Cubic],
    /// Frames of each leg.
    pub frames: &'a [usize],
    pub detours: &'a [Detour],
    pub need: f64,
    /// Share of a leg between two knots, at least.
    pub apart: f64,
    /// Straight from knot to knot.
    pub linear: bool,
    pub knots: Vec<Knot>,
    /// A leg that has not enough frames for the knots that it takes.
    pub short: Option<usize>,
}

impl Bend<'_, '_> {
    /// Where the curve was.
    fn old(&self, u: f64) -> DVec3 {
        let leg = (u as usize).min(self.legs.len() - 1);
        self.legs[leg].point(u - leg as f64)
    }

    /// The way round.
    fn guide(&self, u: f64) -> DVec3 {
        let at = |detour: &&Detour| (detour.from..=detour.to).contains(&u);
        let detour = self.detours.iter().find(at);
        detour.map_or_else(|| self.old(u), |detour| detour.place(u))
    }

    fn slope(&self, knot: usize) -> DVec3 {
        let here = &self.knots[knot];
        if here.still {
            return DVec3::ZERO;
        }
        let side = |a: &Knot, b: &Knot| (b.u - a.u, (b.delta - a.delta) / (b.u - a.u));
        let before = knot.checked_sub(1).map(|k| side(&self.knots[k], here));
        let after = self.knots.get(knot + 1).map(|next| side(here, next));
        match (before, after) {
            (Some((h, d)), Some((i, e))) => (d * i + e * h) / (h + i),
            (Some((_, d)), None) | (None, Some((_, d))) => d,
            (None, None) => DVec3::ZERO,
        }
    }

    /// The new curve from one knot to the next.
    pub(super) fn piece(&self, knot: usize) -> Cubic {
        let (a, b) = (&self.knots[knot], &self.knots[knot + 1]);
        let leg = ((0.5 * (a.u + b.u)) as usize).min(self.legs.len() - 1);
        let (curve, width) = (&self.legs[leg], b.u - a.u);
        let [s, t] = [a.u, b.u].map(|u| (u - leg as f64).clamp(0.0, 1.0));
        let (p, q) = (curve.point(s) + a.delta, curve.point(t) + b.delta);
        if self.linear {
            return Cubic::hermite(p, q, q - p, q - p);
        }
        let leave = (curve.derivative(s) + self.slope(knot)) * width;
        let reach = (curve.derivative(t) + self.slope(knot + 1)) * width;
        Cubic::hermite(p, q, leave, reach)
    }

    fn is_clear(&self, pieces: std::ops::Range<usize>) -> Result<bool> {
        for piece in pieces {
            if !self.field.faults(&self.piece(piece), self.need)?.is_empty() {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// The faults of all pieces.
    fn faults(&self) -> Result<Vec<(usize, Fault)>> {
        let mut all = Vec::new();
        for piece in 0..self.knots.len() - 1 {
            let found = self.field.faults(&self.piece(piece), self.need)?;
            all.try_reserve(found.len())?;
            all.extend(found.into_iter().map(|fault| (piece, fault)));
        }
        Ok(all)
    }

    /// Where a place of the curve is to be moved.
    fn wanted(&self, u: f64, place: DVec3) -> DVec3 {
        let guide = self.guide(u);
        let mut ends = [0.0, 1.0];
        for _ in 0..12 {
            let middle = 0.5 * (ends[0] + ends[1]);
            let there = guide.lerp(place, middle);
            ends[usize::from(!self.field.is_free(guide, there, self.need))] = middle;
        }
        (guide.lerp(place, ends[0]) - place) * BEYOND
    }

    /// Moves knots until all is clear, if that does.
    fn moved(&mut self) -> Result<bool> {
        for _ in 0..ROUNDS {
            let faults = self.faults()?;
            if faults.is_empty() {
                return Ok(true);
            }
            let mut changes = vec_with_room(self.knots.len())?;
            changes.resize(self.knots.len(), (DVec3::ZERO, 0.0));
            for (piece, fault) in faults {
                let cubic = self.piece(piece);
                for t in [fault.worst, 0.5 * (fault.from + fault.to)] {
                    let u = self.at(piece, t);
                    let by = self.wanted(u, cubic.point(t));
                    let after = t * t * (3.0 - 2.0 * t);
                    let shares = [1.0 - after, after];
                    let shares = [0, 1].map(|k| {
                        let fixed = self.knots[piece + k].fixed;
                        if fixed { 0.0 } else { shares[k] }
                    });
                    let norm: f64 = shares.iter().map(|share| share * share).sum();
                    // A knot far from the fault would have to go far.
                    if norm < 0.04 {
                        continue;
                    }
                    for k in [0, 1] {
                        let change: &mut (DVec3, f64) = &mut changes[piece + k];
                        change.0 += by * (shares[k] / norm) * shares[k];
                        change.1 += shares[k];
                    }
                }
            }
            let mut moves = false;
            for (knot, (by, share)) in self.knots.iter_mut().zip(changes) {
                if share > 0.0 {
                    knot.delta += by / share;
                    moves = true;
                }
            }
            if !moves {
                break;
            }
        }
        Ok(false)
    }

    /// The parameter of the way at one of a piece.
    fn at(&self, piece: usize, t: f64) -> f64 {
        let (a, b) = (&self.knots[piece], &self.knots[piece + 1]);
        a.u + t * (b.u - a.u)
    }

    /// Puts a knot in, on the way round, where there is room for it.
    fn put_in(&mut self, (piece, fault): (usize, Fault)) -> Result<bool> {
        let u = self.at(piece, 0.5 * (fault.from + fault.to));
        let (a, b) = (self.knots[piece].u, self.knots[piece + 1].u);
        let leg = ((0.5 * (a + b)) as usize).min(self.legs.len() - 1);
        let inside = |knot: &&Knot| knot.new && (knot.u as usize) == leg;
        let known = self.knots.iter().filter(inside).count();
        let new = self.knots.iter().filter(|knot| knot.new).count();
        let least = if self.linear { 1e-4 } else { 2.0 * self.apart };
        if known + 2 > self.frames[leg] {
            self.short = Some(leg);
            return Ok(false);
        }
        if b - a < least || new >= KNOTS {
            return Ok(false);
        }
        let edge = (0.1 * (b - a)).max(0.5 * least);
        let mut u = u.clamp(a + edge, b - edge);
        if self.linear {
            // Straight lines follow the way round by its corners.
            let corners = self.detours.iter().flat_map(Detour::corners);
            let inside = corners.filter(|corner| *corner > a && *corner < b);
            let near = inside.min_by(|p, q| (p - u).abs().total_cmp(&(q - u).abs()));
            u = near.unwrap_or(u);
        }
        self.knots.try_reserve(1)?;
        let knot = Knot {
            u,
            delta: self.guide(u) - self.old(u),
            fixed: false,
            still: false,
            new: true,
        };
        self.knots.insert(piece + 1, knot);
        Ok(true)
    }

    /// Bends until it is clear; else where it is not.
    pub(super) fn bend(&mut self) -> Result<Option<f64>> {
        while !self.moved()? {
            // From the way round anew: what was moved for fewer knots may lie far off.
            for knot in 0..self.knots.len() {
                let Knot { u, fixed, .. } = self.knots[knot];
                if !fixed {
                    self.knots[knot].delta = self.guide(u) - self.old(u);
                }
            }
            let faults = self.faults()?;
            let least = |a: &&(usize, Fault), b: &&(usize, Fault)| a.1.least.total_cmp(&b.1.least);
            let Some(&worst) = faults.iter().min_by(least) else {
                break;
            };
            self.field.watch.check()?;
            if !self.put_in(worst)? {
                return Ok(Some(self.at(worst.0, worst.1.worst)));
            }
        }
        self.take_out()?;
        self.bring_back()?;
        Ok(None)
    }

    fn take_out(&mut self) -> Result<()> {
        let mut knot = 0;
        while knot < self.knots.len() {
            let new = self.knots.iter().filter(|knot| knot.new).count();
            if self.knots[knot].new && (new > 1 || self.knots.len() > 3) {
                let mut before = vec_with_room(self.knots.len())?;
                before.extend_from_slice(&self.knots);
                self.knots.remove(knot);
                if self.moved()? {
                    continue;
                }
                self.knots = before;
            }
            knot += 1;
        }
        Ok(())
    }

    /// Brings each knot back towards where the curve was, straight and from either side.
    fn bring_back(&mut self) -> Result<()> {
        for round in 0..3 {
            for knot in 0..self.knots.len() {
                if self.knots[knot].fixed {
                    continue;
                }
                self.bring(knot)?;
                let size = self.knots[knot].delta.length() * [0.5, 0.25, 0.12][round];
                for k in 0..WAYS {
                    let turn = std::f64::consts::TAU * k as f64 / WAYS as f64;
                    let delta = self.knots[knot].delta;
                    let (side, up) = delta.normalize_or(DVec3::X).any_orthonormal_pair();
                    let to = delta + size * (side * turn.cos() + up * turn.sin());
                    self.knots[knot].delta = to * (0.98 * delta.length() / to.length().max(1e-300));
                    if self.is_clear(self.around(knot))? {
                        self.bring(knot)?;
                    } else {
                        self.knots[knot].delta = delta;
                    }
                }
            }
        }
        Ok(())
    }

    /// The pieces that change with a knot.
    fn around(&self, knot: usize) -> std::ops::Range<usize> {
        knot.saturating_sub(2)..(knot + 2).min(self.knots.len() - 1)
    }

    fn bring(&mut self, knot: usize) -> Result<()> {
        let far = self.knots[knot].delta;
        let mut ends = [0.0, 1.0];
        for _ in 0..HALVINGS {
            let middle = 0.5 * (ends[0] + ends[1]);
            self.knots[knot].delta = far * middle;
            let clear = self.is_clear(self.around(knot))?;
            ends[usize::from(clear)] = middle;
        }
        self.knots[knot].delta = far * ends[1];
        Ok(())
    }
}
