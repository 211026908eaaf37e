//! The stretches of a way that is bent: from a point that stays to the next that does.

use glam::DVec3;

use super::apply::Bent;
use super::bend::{APART, Bend, Detour, Knot};
use super::{Work, no_way};
use crate::error::{OutOfRange, Result, vec_with_room};

/// Share of the distance by which a new curve keeps more than it must, for what is left between
/// two places.
const SURE: f64 = 1e-5;

/// A stretch is widened so often by a point on either side, less one.
const WIDER: usize = 3;

impl<'w> Work<'w> {
    /// Ranges of places in `points` between which the way is another.
    pub(super) fn stretches(&self, detours: &[Detour]) -> Result<Vec<[usize; 2]>> {
        let mut all: Vec<[usize; 2]> = vec_with_room(detours.len())?;
        let last = self.points.len() - 1;
        for detour in detours {
            let stays = |at: &usize| !self.moves(self.points[*at].1, detours);
            let before = |at: &usize| self.points[*at].1 <= detour.from && stays(at);
            let behind = |at: &usize| self.points[*at].1 >= detour.to && stays(at);
            let from = (0..=last).rev().find(before).unwrap_or(0);
            let to = (0..=last).find(behind).unwrap_or(last);
            match all.last_mut() {
                Some(before) if before[1] > from => before[1] = before[1].max(to),
                _ => all.push([from, to]),
            }
        }
        Ok(all)
    }

    /// A stretch that is clear; where it cannot be smooth within it, with the points beside, whose
    /// tangents turn, and with the stretch before, if that is among them; at last with knots that are
    /// nearer to one another.
    pub(super) fn bent<'b>(
        &'b self,
        mut range: [usize; 2],
        detours: &'b [Detour],
        before: &mut Vec<Bent<'b, 'w>>,
    ) -> Result<Bent<'b, 'w>> {
        let (mut left, mut short) = (0.0, None);
        let join = |a: [usize; 2], b: [usize; 2]| [a[0].min(b[0]), a[1].max(b[1])];
        let last = self.points.len() - 1;
        for apart in APART {
            let mut wide = range;
            for _ in 0..WIDER {
                while let Some(last) = before.pop_if(|last| last.range[1] > wide[0]) {
                    (range, wide) = (join(range, last.range), join(wide, last.range));
                }
                let mut bend = self.bend(wide, apart, detours)?;
                let Some(at) = bend.bend()? else {
                    return Ok(Bent { bend, range: wide });
                };
                (left, short) = (at, short.or(bend.short));
                wide = [wide[0].saturating_sub(1), (wide[1] + 1).min(last)];
            }
        }
        Err(match short {
            Some(leg) => OutOfRange::FewerFrames(self.segments[leg]).into(),
            None => no_way(self.frame(left), self.place(left), self.need),
        })
    }

    fn bend<'b>(
        &'b self,
        range: [usize; 2],
        apart: f64,
        detours: &'b [Detour],
    ) -> Result<Bend<'b, 'w>> {
        let mut knots: Vec<Knot> = vec_with_room(range[1] - range[0] + 1)?;
        let mut need = self.need * (1.0 + SURE);
        for at in range[0]..=range[1] {
            let u = self.points[at].1;
            if knots.last().is_some_and(|last| last.u == u) {
                continue;
            }
            let ends = u == self.points[range[0]].1 || u == self.points[range[1]].1;
            let moves = self.moves(u, detours);
            let mut delta = DVec3::ZERO;
            if moves {
                let inside = |detour: &&Detour| (detour.from..=detour.to).contains(&u);
                if let Some(detour) = detours.iter().find(inside) {
                    delta = detour.place(u) - self.place(u);
                }
            } else {
                need = need.min(self.field.far(self.place(u), need));
            }
            knots.push(Knot {
                u,
                delta,
                fixed: ends || !moves,
                still: ends,
                new: false,
            });
        }
        let plain = |at: usize| self.path.points[self.points[at].0].tangents.is_none();
        Ok(Bend {
            field: self.field,
            legs: &self.legs,
            frames: &self.frames,
            detours,
            need: need.max(self.need),
            apart,
            linear: self.path.curve.is_straight() && (range[0]..=range[1]).all(plain),
            knots,
            short: None,
        })
    }
}
