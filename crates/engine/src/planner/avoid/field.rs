//! The free space around an object: how far a place is from it, and whether lines and curves keep
//! a distance from it everywhere, not only at samples.
//!
//! Between two places s apart on a curve the distance is at least (d₀ + d₁ − s)/2, since it changes
//! by no more than the way. From a line to a convex piece of the object it is a convex function
//! with a second derivative of at most 1/d, so it dips below the lesser end by at most s²/8d; a
//! curve adds by how much it bulges.

use glam::DVec3;

use crate::error::{Result, vec_with_room};
use crate::path::hermite::Cubic;
use crate::planner::directions::directions;
use crate::tools::clearance::Clearance;
use crate::tools::watch::Watch;

/// Lines of a way round may dip below their distance by this share of it between two samples.
const LINE: f64 = 0.03;

/// Shares of the distance down to which a curve is halved: where both ends are clear (dips by
/// 3e-6 of the distance then), and where one is not.
const CURVE: [f64; 2] = [5e-3, 1e-3];

/// By which share of the distance a curve may bulge there.
const DIP: f64 = 3e-6;

/// No way is cut into more parts.
const PARTS: [f64; 2] = [1e-4, 1e-5];

const DEPTH: u32 = 40;

/// Directions in which a nearest clear place is looked for.
const WAYS: usize = 200;

/// A part of a curve that is too near.
#[derive(Debug, Clone, Copy)]
pub(super) struct Fault {
    pub from: f64,
    pub to: f64,
    /// Where it is nearest, of what was looked at.
    pub worst: f64,
    pub least: f64,
}

/// An object, and whether the work goes on: if not, all is clear.
#[derive(Clone, Copy)]
pub(super) struct Field<'a> {
    pub object: &'a Clearance,
    pub watch: &'a Watch<'a>,
}

/// One end of a part of a curve.
#[derive(Clone, Copy)]
struct End {
    t: f64,
    place: DVec3,
    far: f64,
}

impl Field<'_> {
    /// The distance of a place, at most `most`.
    pub(super) fn far(&self, place: DVec3, most: f64) -> f64 {
        let far = || self.object.distance(place, most);
        self.watch.goes_on().then(far).flatten().unwrap_or(most)
    }

    /// Whether a straight way goes through a triangle.
    pub(super) fn is_crossed(&self, a: DVec3, b: DVec3) -> bool {
        self.watch.goes_on() && self.object.is_crossed(a, b)
    }

    /// Whether a straight line keeps a distance, except for a few hundredths of it.
    pub(super) fn is_free(&self, a: DVec3, b: DVec3, need: f64) -> bool {
        let length = a.distance(b);
        let floor = (LINE * need).max(PARTS[0] * length);
        let end = |t: f64| {
            let place = a.lerp(b, t);
            let far = self.far(place, need + length);
            End { t, place, far }
        };
        let (first, last) = (end(0.0), end(1.0));
        first.far >= need
            && last.far >= need
            && self.part_is_free(&end, [first, last], (length, need, floor), 0)
    }

    fn part_is_free(
        &self,
        end: &dyn Fn(f64) -> End,
        [a, b]: [End; 2],
        known: (f64, f64, f64),
        depth: u32,
    ) -> bool {
        let (length, need, floor) = known;
        let step = (b.t - a.t) * length;
        if is_clear([a.far, b.far], step, 0.0, need) {
            return true;
        }
        if step < floor || depth > DEPTH {
            return !self.is_crossed(a.place, b.place);
        }
        let middle = end(0.5 * (a.t + b.t));
        middle.far >= need
            && self.part_is_free(end, [a, middle], known, depth + 1)
            && self.part_is_free(end, [middle, b], known, depth + 1)
    }

    /// The parts of a curve that are nearer than `need`; their ends are clear, unless the curve
    /// ends there.
    pub(super) fn faults(&self, curve: &Cubic, need: f64) -> Result<Vec<Fault>> {
        let length = bound(curve, 0.0, 1.0);
        let end = |t: f64, most: f64| {
            let place = curve.point(t);
            let far = self.far(place, need + most);
            End { t, place, far }
        };
        let mut found: Vec<Fault> = Vec::new();
        let mut stack: Vec<(End, End, u32)> = vec_with_room(2 * DEPTH as usize + 2)?;
        stack.push((end(0.0, length), end(1.0, length), 0));
        while let Some((a, b, depth)) = stack.pop() {
            let step = bound(curve, a.t, b.t);
            let bulge = bulge(curve, a.t, b.t);
            let near = [a.far < need, b.far < need];
            let split = match near {
                [false, false] if is_clear([a.far, b.far], step, bulge, need) => continue,
                [false, false] => {
                    let done = step <= CURVE[0] * need && bulge <= DIP * need;
                    !done && step > PARTS[1] * length
                }
                [true, true] => step > (0.5 * need).max(PARTS[1] * length),
                _ => step > (CURVE[1] * need).max(PARTS[1] * length),
            };
            if split && depth < DEPTH {
                let middle = end(0.5 * (a.t + b.t), 0.5 * step);
                stack.push((middle, b, depth + 1));
                stack.push((a, middle, depth + 1));
                continue;
            }
            if near == [false; 2] && !self.is_crossed(a.place, b.place) {
                continue;
            }
            let worst = if a.far <= b.far { a } else { b };
            if let Some(last) = found.last_mut()
                && last.to == a.t
            {
                last.to = b.t;
                if worst.far < last.least {
                    (last.worst, last.least) = (worst.t, worst.far);
                }
                continue;
            }
            found.try_reserve(1)?;
            found.push(Fault {
                from: a.t,
                to: b.t,
                worst: worst.t,
                least: worst.far,
            });
        }
        Ok(found)
    }

    /// The nearest clear place, about, that is reached without going through the object.
    pub(super) fn pushed(&self, place: DVec3, need: f64) -> Option<DVec3> {
        let mut size = 0.25 * need;
        // As far as four distances away; within a thick object there is none.
        for _ in 0..24 {
            let clear = |p: &DVec3| self.far(*p, need) >= need && !self.is_crossed(place, *p);
            // Of those that are clear the one with most room around.
            let room = |p: &DVec3| self.far(*p, 4.0 * need);
            let mut best: Option<(f64, DVec3)> = None;
            for p in directions(WAYS).map(|way| place + size * way).filter(clear) {
                let room = room(&p);
                if best.is_none_or(|(most, _)| room > most) {
                    best = Some((room, p));
                }
            }
            if let Some((_, p)) = best {
                return Some(p);
            }
            size *= 1.25;
        }
        None
    }
}

/// Whether a part of a curve certainly keeps the distance.
fn is_clear([a, b]: [f64; 2], step: f64, bulge: f64, need: f64) -> bool {
    0.5 * (a + b - step) >= need
        || (step <= 0.5 * need && a.min(b) - step * step / (4.0 * need) - bulge >= need)
}

/// At least the length of a part of a curve.
pub(super) fn bound(curve: &Cubic, from: f64, to: f64) -> f64 {
    let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
    let first = curve.derivative(middle).length();
    let second = curve.second_derivative(middle).length();
    let third = 6.0 * curve.a.length();
    (first + (second + 0.5 * third * half) * half) * (to - from)
}

/// How far a part of a curve is from its chord, at most.
fn bulge(curve: &Cubic, from: f64, to: f64) -> f64 {
    let ends = [from, to].map(|t| curve.second_derivative(t).length());
    ends[0].max(ends[1]) * (to - from).powi(2) / 8.0
}
