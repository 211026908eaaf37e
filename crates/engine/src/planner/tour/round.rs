//! Ways between places that keep clear of the object, and a short round along them: a roadmap of
//! straight ways between neighbours (Kavraki et al. 1996), shortest ways (Dijkstra 1959), the
//! nearest neighbour made shorter by 2-opt (Croes 1958) and or-opt (Or 1976).

use glam::DVec3;

use crate::error::{Result, vec_with_room};
use crate::tools::clearance::Clearance;
use crate::tools::watch::Watch;

/// Neighbours that a place may have a way to.
const NEIGHBOURS: usize = 12;

/// The steepest view on a way, as the sine of its height: the picture spins near the poles.
pub(super) const STEEPEST: f64 = 0.92;

/// Places, how far each is from the object, and free ways between them.
pub(super) struct Roads<'a> {
    object: &'a Clearance,
    watch: &'a Watch<'a>,
    /// How far ways keep away, where their ends do.
    clear: f64,
    up: DVec3,
    /// What ways must not go straight above or below of; none: they may.
    middle: Option<DVec3>,
    pub places: Vec<DVec3>,
    apart: Vec<f64>,
    ways: Vec<Vec<(usize, f64)>>,
}

impl<'a> Roads<'a> {
    pub(super) fn new(
        (object, watch): (&'a Clearance, &'a Watch<'a>),
        clear: f64,
        up: DVec3,
        middle: Option<DVec3>,
        places: Vec<DVec3>,
    ) -> Result<Self> {
        let mut made = Self {
            object,
            watch,
            clear,
            up,
            middle,
            apart: vec_with_room(places.len())?,
            ways: vec_with_room(places.len())?,
            places,
        };
        for place in &made.places {
            watch.check()?;
            let far = object
                .distance(*place, f64::INFINITY)
                .unwrap_or(f64::INFINITY);
            made.apart.push(far);
            made.ways.push(Vec::new());
        }
        let mut near: Vec<(f64, usize)> = vec_with_room(made.places.len())?;
        for from in 0..made.places.len() {
            near.clear();
            let far = |to: usize| made.places[to].distance_squared(made.places[from]);
            near.extend(
                (0..made.places.len())
                    .filter(|to| *to != from)
                    .map(|to| (far(to), to)),
            );
            near.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
            for &(far, to) in near.iter().take(NEIGHBOURS) {
                watch.check()?;
                let known = made.ways[from].iter().any(|way| way.0 == to);
                if !known && made.is_free(from, to) {
                    for (a, b) in [(from, to), (to, from)] {
                        made.ways[a].try_reserve(1)?;
                        made.ways[a].push((b, far.sqrt()));
                    }
                }
            }
        }
        Ok(made)
    }

    /// Whether the straight way between two places keeps clear.
    pub(super) fn is_free(&self, from: usize, to: usize) -> bool {
        let clear = self.clear.min(0.95 * self.apart[from].min(self.apart[to]));
        let (a, b) = (self.places[from], self.places[to]);
        if let Some(middle) = self.middle {
            // The nearest that the way comes to the axis.
            let flat = |place: DVec3| (place - middle).reject_from_normalized(self.up);
            let (start, way) = (flat(a), flat(b) - flat(a));
            let share = -start.dot(way) / way.length_squared();
            let at = a.lerp(b, if share > 0.0 { share.min(1.0) } else { 0.0 }) - middle;
            let ends = [a, b].map(|end| (end - middle).normalize_or_zero().dot(self.up).abs());
            let most = STEEPEST.max(ends[0].max(ends[1]));
            if at.normalize_or_zero().dot(self.up).abs() > most {
                return false;
            }
        }
        let length = a.distance(b);
        let mut gone = 0.0;
        while gone < length && self.watch.goes_on() {
            let place = a.lerp(b, gone / length);
            let reach = clear + length - gone;
            let Some(far) = self.object.distance(place, reach) else {
                return true;
            };
            if far < clear {
                return false;
            }
            gone += (far - clear).max(0.05 * clear);
        }
        !self.object.is_crossed(a, b)
    }

    /// How far it is from one place to all others, and over which place each is reached.
    pub(super) fn from(&self, start: usize) -> Result<(Vec<f64>, Vec<usize>)> {
        let count = self.places.len();
        let (mut far, mut over) = (vec_with_room(count)?, vec_with_room(count)?);
        let mut done: Vec<bool> = vec_with_room(count)?;
        far.resize(count, f64::INFINITY);
        over.resize(count, start);
        done.resize(count, false);
        far[start] = 0.0;
        loop {
            let open = (0..count).filter(|at| !done[*at] && far[*at] < f64::INFINITY);
            let Some(next) = open.min_by(|a, b| far[*a].total_cmp(&far[*b])) else {
                return Ok((far, over));
            };
            done[next] = true;
            for &(to, length) in &self.ways[next] {
                if far[next] + length < far[to] {
                    far[to] = far[next] + length;
                    over[to] = next;
                }
            }
        }
    }

    /// The places on the shortest way behind `from` up to `to`, with those left out that a straight
    /// way passes by.
    pub(super) fn way(&self, from: usize, to: usize) -> Result<Vec<usize>> {
        let (_, over) = self.from(to)?;
        let mut all = vec_with_room(self.places.len() + 1)?;
        let mut at = from;
        all.push(at);
        while at != to && all.len() <= self.places.len() {
            at = over[at];
            all.push(at);
        }
        let mut way = vec_with_room(all.len())?;
        let mut here = 0;
        while here + 1 < all.len() {
            let free = |next: &usize| self.is_free(all[here], all[*next]);
            here = (here + 2..all.len()).rev().find(free).unwrap_or(here + 1);
            way.push(all[here]);
        }
        Ok(way)
    }
}

/// A short round through all places with such distances; it begins with the first. An open one
/// ends anywhere.
pub(super) fn round(far: &[Vec<f64>], closed: bool) -> Result<Vec<usize>> {
    let count = far.len();
    let mut order: Vec<usize> = vec_with_room(count)?;
    order.push(0);
    while order.len() < count {
        let here = order[order.len() - 1];
        let left = (0..count).filter(|at| !order.contains(at));
        let next = left.min_by(|a, b| far[here][*a].total_cmp(&far[here][*b]));
        order.extend(next);
    }
    // From a place to the one behind it; nothing from the end of an open round.
    let leg = |order: &[usize], at: usize| match order.get(at + 1) {
        Some(next) => far[order[at]][*next],
        None if closed => far[order[at]][order[0]],
        None => 0.0,
    };
    let length = |order: &[usize]| (0..count).map(|at| leg(order, at)).sum::<f64>();
    let mut trial = vec_with_room(count)?;
    let mut best = length(&order);
    // Each round is shorter than the last; few are needed.
    for _ in 0..100 {
        let before = best;
        for from in 1..count {
            for to in from..count {
                // The part turned round, or moved to any other place.
                trial.clear();
                trial.extend_from_slice(&order);
                trial[from..=to].reverse();
                take_shorter(&mut order, &trial, &mut best, length(&trial));
                if to - from < 3 {
                    for target in 1..count - (to - from) {
                        trial.clear();
                        trial.extend_from_slice(&order);
                        let moved = to - from + 1;
                        if target > from {
                            trial[from..target + moved].rotate_left(moved);
                        } else {
                            trial[target..=to].rotate_right(moved);
                        }
                        take_shorter(&mut order, &trial, &mut best, length(&trial));
                    }
                }
            }
        }
        if best >= before * (1.0 - 1e-9) {
            break;
        }
    }
    Ok(order)
}

fn take_shorter(order: &mut [usize], trial: &[usize], best: &mut f64, length: f64) {
    if length < *best * (1.0 - 1e-12) {
        order.copy_from_slice(trial);
        *best = length;
    }
}
