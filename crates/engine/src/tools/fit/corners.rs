//! Where a motion is no smooth one: a path of few points has a jump of its acceleration at each of
//! them, and often a small one of its speed.
//!
//! At such a place the fourth difference of the poses is as large as the jump, and next to it h²–h⁴
//! times smaller, so even a jump far below the tolerance is found. In noise none stands out.

use glam::DVec3;

use super::Data;
use super::motion::zoom_within;
use crate::error::{Result, vec_with_room};
use crate::math::quaternion::log;

/// By how many times the differences there are greater than those close by,
const OUTSTANDING: f64 = 6.0;

/// how great they are at least, in tolerances,
const LEAST: f64 = 1e-5;

/// The share of their squares that the square of the sum of three may have.
const SUM: f64 = 0.25;

/// and how great all are mostly: in more noise a corner would lead through a pose that is off.
const QUIET: f64 = 0.3;

/// Differences on either side whose median is the usual one.
const AROUND: usize = 12;

/// Positions, turning and zoom, in tolerances; and where each begins and ends.
type Row = [f64; 7];
const KINDS: [[usize; 2]; 3] = [[0, 3], [3, 6], [6, 7]];

impl Data {
    /// The poses, counted from the first, at which a motion has a corner, as at both sides of a cut;
    /// in order.
    pub(super) fn corners(&self) -> Result<Vec<usize>> {
        let mut found = self.outstanding()?;
        found.try_reserve(2 * self.cuts.len())?;
        found.extend(self.cuts.iter().flat_map(|cut| [*cut, cut + 1]));
        found.sort_unstable();
        found.dedup();
        Ok(found)
    }

    fn outstanding(&self) -> Result<Vec<usize>> {
        let count = self.raw.len();
        let mut found = Vec::new();
        if count < 2 * AROUND {
            return Ok(found);
        }
        let mut rows: Vec<Row> = vec_with_room(count)?;
        rows.extend((0..count).map(|k| self.fourth_difference(k)));
        let mut usual = vec_with_room(2 * AROUND + 1)?;
        for k in 6..count - 6 {
            let outstanding = KINDS
                .iter()
                .any(|kind| stands_out(&rows, *kind, k, &mut usual));
            if outstanding
                && KINDS
                    .iter()
                    .all(|kind| median(&rows, *kind, k, &mut usual) < QUIET * QUIET)
            {
                found.try_reserve(1)?;
                found.push(k);
            }
        }
        Ok(found)
    }

    /// Of the poses around one; NaN where some are left out or not one at each whole frame.
    fn fourth_difference(&self, at: usize) -> Row {
        let Some(first) = at.checked_sub(2).filter(|_| at + 2 < self.raw.len()) else {
            return [f64::NAN; 7];
        };
        let whole = |k: usize| (self.times[k] - self.times[at].round()).abs();
        let even = |k: usize| (whole(k) - at.abs_diff(k) as f64).abs() < 1e-6;
        if !(first..=at + 2).all(|k| even(k) && !self.left_out[k]) {
            return [f64::NAN; 7];
        }
        let mut sum: Row = [0.0; 7];
        for (k, factor) in [-1.0, 3.0, -3.0, 1.0].into_iter().enumerate() {
            for (sum, step) in sum.iter_mut().zip(self.step(first + k)) {
                *sum += factor * step;
            }
        }
        sum
    }

    /// From a pose to the next.
    fn step(&self, at: usize) -> Row {
        let [a, b] = [&self.raw[at], &self.raw[at + 1]];
        let moved: DVec3 = (b.position - a.position) / self.tolerance;
        let turned = log(b.turn * a.turn.conjugate()) * (2.0 / self.angle);
        let zoomed = (b.zoom - a.zoom) / zoom_within(a.zoom, self.angle);
        let ([x, y, z], [u, v, w]) = (moved.to_array(), turned.to_array());
        [x, y, z, u, v, w, zoomed]
    }
}

/// Whether those of a kind at a place, the one before and the one behind are greater than elsewhere;
/// NaN, where a difference does not exist, does not count. `usual` is a buffer.
fn stands_out(rows: &[Row], kind: [usize; 2], at: usize, usual: &mut Vec<f64>) -> bool {
    let part = |k: usize| &rows[k][kind[0]..kind[1]];
    let square = |k: usize| part(k).iter().map(|x| x * x).sum::<f64>();
    let three = |k: usize| square(k - 1) + square(k) + square(k + 1);
    let here = three(at);
    let most = here / 3.0 / (OUTSTANDING * OUTSTANDING);
    let close = [at - 3, at - 2, at + 2, at + 3];
    if !(here > 3.0 * LEAST * LEAST
        && close.iter().all(|beside| most > square(*beside))
        && three(at - 1) <= here
        && three(at + 1) < here)
    {
        return false;
    }
    // Those of a jump of the speed or the acceleration sum up to nothing.
    let sum = (0..kind[1] - kind[0]).map(|x| part(at - 1)[x] + part(at)[x] + part(at + 1)[x]);
    if sum.map(|x| x * x).sum::<f64>() > SUM * here {
        return false;
    }
    most > median(rows, kind, at, usual)
}

/// The median of the squares of a kind around a place.
fn median(rows: &[Row], kind: [usize; 2], at: usize, usual: &mut Vec<f64>) -> f64 {
    let around = &rows[at.saturating_sub(AROUND)..(at + AROUND + 1).min(rows.len())];
    let square = |row: &Row| row[kind[0]..kind[1]].iter().map(|x| x * x).sum::<f64>();
    usual.clear();
    usual.extend(around.iter().map(square).filter(|square| !square.is_nan()));
    let middle = usual.len() / 2;
    if usual.is_empty() {
        return f64::NAN;
    }
    *usual.select_nth_unstable_by(middle, f64::total_cmp).1
}
