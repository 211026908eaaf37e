//! How fast a pace may be: time-optimal path parameterisation (J. Bobrow, S. Dubowsky, J. Gibson,
//! *Time-optimal control of robotic manipulators along specified paths*, 1985; H. Pham, Q.-C. Pham,
//! *A new approach to time-optimal path parameterization based on reachability analysis*, 2018).
//!
//! The unknown is x = (dφ/dt)², on a grid. Within a cell d²φ/dt² = (x₁ − x₀)/(2Δ) is constant, so
//! the acceleration in its middle, tangent·d²φ/dt² + bend·(dφ/dt)², is linear in x₀ and x₁, and a
//! limit of its length an ellipse around the origin. So each cell allows a convex set of pairs with
//! the origin in it: a mix of two paces, and a slower one, hold where they do.

use super::course::{Bounds, Course};
use crate::error::{Result, vec_with_room};

/// An ellipse a·x₀² + 2b·x₀·x₁ + c·x₁² ≤ 1.
#[derive(Debug, Clone, Copy)]
struct Ellipse {
    a: f64,
    b: f64,
    c: f64,
}

impl Ellipse {
    /// The interval of the other coordinate, if there is one.
    fn range(a: f64, b: f64, c: f64, known: f64) -> Option<[f64; 2]> {
        let middle = -b * known / a;
        let square = middle * middle - (c * known * known - 1.0) / a;
        let root = if square >= 0.0 {
            square.sqrt()
        } else {
            return None;
        };
        Some([middle - root, middle + root])
    }
}

/// What one cell allows: the ellipses of way and turning, else a strip along the diagonal.
#[derive(Debug, Clone, Copy)]
pub(super) struct Cell {
    limits: [Option<Ellipse>; 2],
}

impl Cell {
    /// Range of x at the end that is not known, not below 0.
    fn range(&self, known: f64, backwards: bool) -> Option<[f64; 2]> {
        let mut range = [0.0_f64, f64::INFINITY];
        for limit in self.limits.iter().flatten() {
            let (a, c) = if backwards {
                (limit.a, limit.c)
            } else {
                (limit.c, limit.a)
            };
            let [low, high] = Ellipse::range(a, limit.b, c, known)?;
            range = [range[0].max(low), range[1].min(high)];
        }
        // By rounding where the two meet.
        (range[0] <= range[1] * (1.0 + 1e-9)).then_some([range[0].min(range[1]), range[1]])
    }

    fn holds(&self, x: f64, y: f64) -> bool {
        let within = |e: &Ellipse| e.a * x * x + 2.0 * e.b * x * y + e.c * y * y <= 1.0 + 1e-9;
        self.limits.iter().flatten().all(within)
    }

    /// The greatest x₀ from which some x₁ of at most `most` is reached.
    fn controllable(&self, most: f64) -> f64 {
        let at = |y: f64| {
            self.range(y, true)
                .map_or(f64::NEG_INFINITY, |range| range[1])
        };
        if most <= 0.0 || at(most) > at(most * (1.0 - 1e-7)) || at(most) == f64::INFINITY {
            return at(most);
        }
        // Concave: golden section.
        let golden = 0.5 * (5f64.sqrt() - 1.0);
        let (mut low, mut high) = (0.0, most);
        let (mut left, mut right) = (high - golden * high, golden * high);
        let (mut f, mut g) = (at(left), at(right));
        for _ in 0..60 {
            if f >= g && f > f64::NEG_INFINITY || g == f64::NEG_INFINITY {
                (high, right, g) = (right, left, f);
                left = high - golden * (high - low);
                f = at(left);
            } else {
                (low, left, f) = (left, right, g);
                right = low + golden * (high - low);
                g = at(right);
            }
        }
        f.max(g)
    }
}

/// A section with its limits: cells, and the greatest x at their ends.
#[derive(Debug)]
pub(super) struct Reach {
    cells: Vec<Cell>,
    pub most: Vec<f64>,
    pub ramps: Ramps,
}

/// Where no change of the rate is limited it is at most this many times the mean, and takes so many
/// frames to get there.
const HIGHEST: f64 = 4.0;
const RISE: f64 = 4.0;

/// Below this share of the greatest a pace counts as resting.
const RESTS: f64 = 1e-12;

/// Shares of the limits of rates and of changes that are left free.
pub(super) type Margin = [f64; 2];

impl Reach {
    /// Margins are those of the cells.
    ///
    /// # Errors
    /// [`crate::Error::Argument`] where the pace would rest within the section;
    /// [`crate::Error::Memory`].
    pub(super) fn new(
        course: &Course,
        bounds: &Bounds,
        margins: &[Margin],
        fps: f64,
    ) -> Result<Self> {
        let count = course.cells();
        let width = 2.0 / count as f64;
        let mut cells = vec_with_room(count)?;
        // Where no change is limited, the rate rises and falls within some frames.
        let all: f64 = (0..count)
            .map(|cell| 1.0 / bounds.rate(course.middle(cell)).0)
            .sum();
        let highest = HIGHEST / (all / count as f64).max(1.0 / fps);
        let strip = (width * highest * fps / RISE).powi(-2);
        let strip = Ellipse {
            a: strip,
            b: -strip,
            c: strip,
        };
        for cell in 0..count {
            let ask = course.middle(cell);
            let bounds = bounds.with_margin(margins[cell]);
            let limit = |one: glam::DVec3, two: glam::DVec3, most: f64| {
                let (one, two) = (one / (width * most), 0.5 * two / most);
                let (p, q) = (two - one, two + one);
                let (a, b, c) = (p.dot(p), p.dot(q), q.dot(q));
                // What hardly moves has no limit.
                (most.is_finite() && a.min(c) > 1e-24).then_some(Ellipse { a, b, c })
            };
            let mut limits = [
                limit(ask.tangent, ask.bend, bounds.acceleration),
                limit(ask.turn, ask.twist, bounds.turning_acceleration),
            ];
            if limits.iter().all(Option::is_none) {
                limits[0] = Some(strip);
            }
            cells.push(Cell { limits });
        }
        let mut most = vec_with_room(count + 1)?;
        let mut fastest = 0.0_f64;
        for node in 0..=count {
            let mut rate = f64::INFINITY;
            // Between nodes, too.
            for cell in [node.checked_sub(1), (node < count).then_some(node)] {
                let Some(cell) = cell else { continue };
                let bounds = bounds.with_margin(margins[cell]);
                let both = [course.node(node), course.middle(cell)].map(|ask| bounds.rate(ask).0);
                rate = rate.min(both[0]).min(both[1]);
            }
            let free = |cell: &Cell| cell.limits[0].is_some_and(|limit| limit.b == -limit.a);
            if free(&cells[node.min(count - 1)]) || free(&cells[node.max(1) - 1]) {
                rate = rate.min(highest);
            }
            fastest = fastest.max(rate);
            most.push(rate * rate);
        }
        for (node, most) in most.iter().enumerate().skip(1).take(count - 1) {
            if !(*most > RESTS * fastest * fastest) || *most < 1e-14 {
                let (share, kind) = (node as f64 / count as f64, bounds.rate(course.node(node)).1);
                return Err(course.refused(share, kind));
            }
        }
        // Where only changes are limited: as fast as they can be from end to end.
        for most in &mut most {
            *most = most.min(1e12);
        }
        let ramp = |cell: &Cell, backwards: bool| {
            let range = cell.range(0.0, backwards);
            range.map_or(0.0, |range| 0.5 * count as f64 * range[1])
        };
        let ramps = [ramp(&cells[0], false), ramp(&cells[count - 1], true)];
        Ok(Self { cells, most, ramps })
    }

    /// From an end with at most `end`: the greatest x from which it is reached.
    pub(super) fn controllable(&self, end: f64) -> Result<Vec<f64>> {
        let mut found = vec_with_room(self.most.len())?;
        found.resize(self.most.len(), 0.0);
        let mut next = end.min(self.most[self.cells.len()]);
        found[self.cells.len()] = next;
        for (k, cell) in self.cells.iter().enumerate().rev() {
            next = cell.controllable(next).min(self.most[k]);
            found[k] = next;
        }
        Ok(found)
    }

    /// As fast as it goes from a start, below `most`.
    pub(super) fn fastest(&self, start: f64, most: &[f64]) -> Result<Vec<f64>> {
        let mut found = vec_with_room(most.len())?;
        let mut x = start.min(most[0]);
        found.push(x);
        for (cell, most) in self.cells.iter().zip(&most[1..]) {
            // By rounding a little too fast to go on.
            let mut range = cell.range(x, false);
            while range.is_none() && x > 0.0 {
                x *= 0.999;
                range = cell.range(x, false);
            }
            x = range.map_or(0.0, |range| range[1].min(*most));
            found.push(x);
        }
        Ok(found)
    }

    /// The fastest pace that ends in `end`, given the fastest from its start; none if that does
    /// not reach this speed or cannot slow down to it.
    pub(super) fn ending(&self, ahead: &[f64], end: f64) -> Result<Option<Vec<f64>>> {
        let last = self.cells.len();
        if ahead[last] < end * (1.0 - 1e-9) {
            return Ok(None);
        }
        let mut found = vec_with_room(ahead.len())?;
        found.extend_from_slice(ahead);
        found[last] = end.min(ahead[last]);
        for k in (0..last).rev() {
            let Some([_, high]) = self.cells[k].range(found[k + 1], true) else {
                return Ok(None);
            };
            if high >= ahead[k] {
                return Ok(Some(found));
            }
            found[k] = high;
        }
        Ok(None)
    }

    /// The slowest pace with the ends of a fast one.
    pub(super) fn slowest(&self, fast: &[f64]) -> Result<Vec<f64>> {
        let last = self.cells.len();
        let mut slow = vec_with_room(fast.len())?;
        slow.extend(fast.iter().map(|x| 1e-6 * x));
        (slow[0], slow[last]) = (fast[0], fast[last]);
        for backwards in [false, true] {
            let mut x = if backwards { fast[last] } else { fast[0] };
            for k in 0..last {
                let cell = if backwards { last - 1 - k } else { k };
                x = match self.cells[cell].range(x, backwards) {
                    Some([low, _]) if low > 0.0 => low,
                    _ => break,
                };
                let node = if backwards { cell } else { cell + 1 };
                slow[node] = slow[node].max(x).min(fast[node]);
            }
        }
        // Where slowing down meets speeding up: so much of the fast one that it holds.
        let mut share = 0.0_f64;
        let mix = |k: usize, share: f64| slow[k] + (fast[k] - slow[k]) * share;
        for (k, cell) in self.cells.iter().enumerate() {
            let holds = |share: f64| cell.holds(mix(k, share), mix(k + 1, share));
            if !holds(share) {
                let mut ends = [share, 1.0];
                for _ in 0..40 {
                    let middle = 0.5 * (ends[0] + ends[1]);
                    ends[usize::from(holds(middle))] = middle;
                }
                share = ends[1];
            }
        }
        let mut found = vec_with_room(fast.len())?;
        found.extend((0..fast.len()).map(|k| mix(k, share)));
        Ok(found)
    }
}

/// The greatest d²φ/dt² in the first and the last cell of a section.
pub(super) type Ramps = [f64; 2];

/// Seconds in each cell of a pace. One that begins or ends at rest is gone through as fast as it may
/// be with the rate at its other end: a ramp may be much shorter than a cell.
pub(super) fn times(xs: &[f64], ramps: Ramps) -> impl Iterator<Item = f64> {
    let last = xs.len() - 2;
    let share = 1.0 / (last + 1) as f64;
    xs.windows(2).enumerate().map(move |(k, pair)| {
        let rates = pair[0].sqrt() + pair[1].sqrt();
        match ramp(k, last, pair, ramps) {
            Some(ramp) => share / rates + 0.5 * rates / ramp,
            None => 2.0 * share / rates,
        }
    })
}

/// With which change the ramp in a cell goes, if there is one shorter than the cell.
pub(super) fn ramp(cell: usize, last: usize, pair: &[f64], ramps: Ramps) -> Option<f64> {
    let share = 1.0 / (last + 1) as f64;
    let ramp = match (cell, pair) {
        (0, [0.0, _]) => ramps[0],
        (cell, [_, 0.0]) if cell == last => ramps[1],
        _ => return None,
    };
    let x = pair[0] + pair[1];
    (x > 0.0 && ramp.is_finite() && 2.0 * share * ramp > x * (1.0 + 1e-9)).then_some(ramp)
}

/// Seconds that a pace takes.
pub(super) fn seconds(xs: &[f64], ramps: Ramps) -> f64 {
    times(xs, ramps).sum()
}

/// A mix of a fast and a slow pace that takes these seconds.
pub(super) fn mixed(fast: &[f64], slow: &[f64], ramps: Ramps, wanted: f64) -> Result<Vec<f64>> {
    let mut mix = vec_with_room(fast.len())?;
    let mut ends = [0.0, 1.0];
    for _ in 0..60 {
        let share = 0.5 * (ends[0] + ends[1]);
        mix.clear();
        mix.extend(fast.iter().zip(slow).map(|(f, s)| f + (s - f) * share));
        ends[usize::from(seconds(&mix, ramps) > wanted)] = share;
    }
    Ok(mix)
}
