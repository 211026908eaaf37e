//! Where a recording jumps: cuts, at which the camera is elsewhere from one pose to the next, and
//! gaps, in which poses are missing.

use super::Data;
use crate::error::{Result, vec_with_room};

/// A cut is so many times longer than the steps are mostly,
const CUT: f64 = 20.0;

/// so many times longer than those close by,
const CLOSE: f64 = 5.0;

/// and longer than so many tolerances.
const LEAST: f64 = 4.0;

/// So many steps on either side are close by.
const BESIDE: usize = 4;

/// Poses farther apart in time than so many usual steps have a gap between them.
const GAP: f64 = 5.0;

/// Poses of a cut are no farther apart in time than so many usual steps.
const AT_ONCE: f64 = 1.5;

impl Data {
    /// The poses before a cut, in order, and the number of gaps.
    pub(super) fn jumps(&self) -> Result<(Vec<usize>, usize)> {
        let count = self.poses();
        let (mut cuts, mut steps, mut times) = (
            Vec::new(),
            vec_with_room::<f64>(count)?,
            vec_with_room::<f64>(count)?,
        );
        for k in 1..count {
            let [a, b] = [&self.raw[k - 1], &self.raw[k]];
            let moved = a.position.distance(b.position) / self.tolerance;
            steps.push(moved.max(a.off(b.turn, b.zoom) / self.angle));
            times.push(self.times[k] - self.times[k - 1]);
        }
        if steps.len() <= 2 * BESIDE {
            return Ok((cuts, 0));
        }
        let usual = median(&mut steps.clone());
        let usual_time = median(&mut times.clone());
        let gaps = times
            .iter()
            .filter(|time| **time > (GAP * usual_time).max(1.0));
        for (k, step) in steps.iter().enumerate() {
            let around = &steps[k.saturating_sub(BESIDE)..(k + BESIDE + 1).min(steps.len())];
            // Of equal ones none is a cut.
            let longer = around
                .iter()
                .filter(|close| CLOSE * **close > *step)
                .count();
            let at_once = times[k] <= (AT_ONCE * usual_time).max(1.0);
            if at_once && longer == 1 && *step > (CUT * usual).max(LEAST) {
                cuts.try_reserve(1)?;
                cuts.push(k);
            }
        }
        Ok((cuts, gaps.count()))
    }

    /// Whether a pose lies within the frame in which a cut is crossed: no path can be on both sides.
    pub(super) fn in_a_cut(&self, pose: usize) -> bool {
        let time = self.times[pose];
        let within = |cut: &usize| {
            let begin = self.times[*cut].floor();
            let end = self.times[cut + 1].floor().max(begin + 1.0);
            begin < time && time < end
        };
        // Those beside it, as few frames are many cuts long.
        let at = self.cuts.partition_point(|cut| *cut < pose);
        let beside = self.cuts[at.saturating_sub(1)..].iter().take(2);
        beside.into_iter().any(within)
    }
}

fn median(numbers: &mut [f64]) -> f64 {
    let middle = numbers.len() / 2;
    *numbers.select_nth_unstable_by(middle, f64::total_cmp).1
}
