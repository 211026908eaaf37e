//! A whole number of frames for each section: which squared speeds x to have where sections meet,
//! so that each is possible and all together are the fewest.
//!
//! Between two of them a section may take any time from that of its fastest pace to that of its
//! slowest ([`super::reach`]), so a shortest path through a few speeds for each joint finds them.

use super::reach::{Ramps, Reach, mixed, seconds};
use crate::error::{Result, vec_with_room};

/// Asked before each section whether to go on.
pub(super) type GoOn<'a> = &'a mut dyn FnMut() -> Result<()>;

/// How two sections meet.
#[derive(Debug, Clone, Copy)]
pub(super) struct Joint {
    /// Of the section after it by that of the section before it.
    pub gain: f64,
    /// The greatest x there, of the section before it; 0: the pace rests.
    pub most: f64,
}

/// The pace of one section.
#[derive(Debug, Clone)]
pub(super) struct Paced {
    pub frames: usize,
    pub xs: Vec<f64>,
    /// Between which it was mixed.
    pub fast: Vec<f64>,
    pub slow: Vec<f64>,
    pub ramps: Ramps,
    /// The most frames that it could have with the speeds at its ends.
    pub longest: f64,
}

/// Sections one after the other.
pub(super) struct Row<'a> {
    pub reaches: &'a [Reach],
    /// Before each section and behind the last. Of a ring the first and last are one.
    pub joints: &'a [Joint],
    /// Seconds by which smoothing makes each section longer, of paces that are not slower.
    pub lags: &'a [f64],
    pub slower: f64,
    /// Whether the last section meets the first, and none rests.
    pub ring: bool,
    pub fps: f64,
}

/// Shares of the greatest x at a joint that are tried. The last one always leads on.
const LEVELS: [f64; 11] = [1.0, 0.98, 0.95, 0.9, 0.84, 0.75, 0.6, 0.45, 0.25, 0.08, 0.0];

/// Frames for which one section less at its share is given up.
const LOWER: f64 = 1e-3;

/// How much worse a share of a section's time is that is spent within it.
const WITHIN: f64 = 5.0;

/// Laps after which a ring has settled.
const LAPS: usize = 4;

impl Row<'_> {
    /// The greatest x from which all that follows can be done, for each section.
    fn controllable(&self) -> Result<Vec<Vec<f64>>> {
        let count = self.reaches.len();
        let mut all = vec_with_room(count)?;
        all.resize(count, Vec::new());
        let mut end = self.joints[count].most;
        for _ in 0..if self.ring { LAPS } else { 1 } {
            for k in (0..count).rev() {
                all[k] = self.reaches[k].controllable(end.min(self.joints[k + 1].most))?;
                end = all[k][0] / self.joints[k].gain;
            }
        }
        Ok(all)
    }

    /// The greatest x at each joint, of the section before it; at the first of that behind.
    fn tops(&self, controllable: &[Vec<f64>]) -> Result<Vec<f64>> {
        let count = self.reaches.len();
        let mut tops = vec_with_room(count + 1)?;
        tops.resize(count + 1, 0.0);
        let mut x = self.joints[0].most.min(controllable[0][0]);
        for _ in 0..if self.ring { LAPS } else { 1 } {
            tops[0] = x;
            for k in 0..count {
                let pace = self.reaches[k].fastest(x, &controllable[k])?;
                tops[k + 1] = pace[pace.len() - 1].min(self.joints[k + 1].most);
                x = tops[k + 1];
                if k + 1 < count || self.ring {
                    x *= self.joints[(k + 1) % count].gain;
                }
            }
        }
        if self.ring {
            tops[0] = x;
        }
        Ok(tops)
    }

    fn lag(&self, section: usize) -> f64 {
        self.lags[section] * self.slower
    }

    /// The fastest pace of each section, in whatever time.
    pub(super) fn fastest(&self) -> Result<Vec<Vec<f64>>> {
        let controllable = self.controllable()?;
        let tops = self.tops(&controllable)?;
        let mut paces = vec_with_room(self.reaches.len())?;
        for (k, reach) in self.reaches.iter().enumerate() {
            let gain = if k == 0 { 1.0 } else { self.joints[k].gain };
            paces.push(reach.fastest(tops[k] * gain, &controllable[k])?);
        }
        Ok(paces)
    }

    /// The fewest frames for all.
    pub(super) fn plan(&self, go_on: GoOn<'_>) -> Result<Vec<Paced>> {
        let count = self.reaches.len();
        let controllable = self.controllable()?;
        let tops = self.tops(&controllable)?;
        let level = |joint: usize, level: usize| tops[joint] * LEVELS[level];
        let levels = |joint: usize| if tops[joint] > 0.0 { LEVELS.len() } else { 1 };
        let start = |section: usize, a: usize| {
            let gain = if section == 0 {
                1.0
            } else {
                self.joints[section].gain
            };
            level(section, a) * gain
        };
        // Frames from each level of a joint to each of the next.
        let mut tables: Vec<[[f64; LEVELS.len()]; LEVELS.len()]> = vec_with_room(count)?;
        for k in 0..count {
            go_on()?;
            let mut table = [[f64::INFINITY; LEVELS.len()]; LEVELS.len()];
            for (a, row) in table.iter_mut().enumerate().take(levels(k)) {
                let ahead = self.reaches[k].fastest(start(k, a), &controllable[k])?;
                for (b, cost) in row.iter_mut().enumerate().take(levels(k + 1)) {
                    let Some((fewest, _, _)) = self.pair(k, &ahead, level(k + 1, b))? else {
                        continue;
                    };
                    // Rather a joint a little slower than a short section that slows down within;
                    // in a long one nobody sees it.
                    let within = WITHIN * (fewest.0 - fewest.1) / fewest.0;
                    *cost = fewest.0 + LOWER * (within * within + (1.0 - LEVELS[b]));
                }
            }
            tables.push(table);
        }
        let mut best = (f64::INFINITY, Vec::new());
        let firsts = if self.ring { levels(0) } else { 1 };
        for first in 0..firsts {
            let found = route(&tables, first, self.ring.then_some(first))?;
            if found.0 < best.0 {
                best = found;
            }
        }
        // From a given speed at which it cannot go on, as fast as it can.
        for first in 1..levels(0) {
            if best.1.is_empty() {
                best = route(&tables, first, None)?;
            }
        }
        if best.1.is_empty() {
            return Ok(Vec::new());
        }
        let mut paces = vec_with_room(count)?;
        for k in 0..count {
            let (a, b) = (best.1[k], best.1[k + 1]);
            let ahead = self.reaches[k].fastest(start(k, a), &controllable[k])?;
            let Some((fewest, fast, slow)) = self.pair(k, &ahead, level(k + 1, b))? else {
                continue;
            };
            let ramps = self.reaches[k].ramps;
            paces.push(Paced {
                frames: fewest.0 as usize,
                xs: mixed(&fast, &slow, ramps, fewest.0 / self.fps - self.lag(k))?,
                longest: (seconds(&slow, ramps) + self.lag(k)) * self.fps,
                fast,
                slow,
                ramps,
            });
        }
        Ok(paces)
    }

    /// The fewest frames (and before they are rounded) from a pace ahead to an end, with the
    /// fastest and the slowest pace.
    #[allow(clippy::type_complexity)]
    fn pair(
        &self,
        section: usize,
        ahead: &[f64],
        end: f64,
    ) -> Result<Option<((f64, f64), Vec<f64>, Vec<f64>)>> {
        let reach = &self.reaches[section];
        let Some(fast) = reach.ending(ahead, end)? else {
            return Ok(None);
        };
        let slow = reach.slowest(&fast)?;
        let exact = (seconds(&fast, reach.ramps) + self.lag(section)) * self.fps;
        let fewest = (exact - 1e-6).ceil().max(1.0);
        let fits = exact.is_finite()
            && fewest <= (seconds(&slow, reach.ramps) + self.lag(section)) * self.fps + 1e-6;
        Ok(fits.then_some(((fewest, exact), fast, slow)))
    }

    /// The same joints with more frames in one section.
    pub(super) fn lengthened(&self, section: usize, paced: &Paced, more: usize) -> Result<Paced> {
        let frames = paced.frames + more;
        let slow = self.reaches[section].slowest(&paced.xs)?;
        let mut fast = vec_with_room(paced.xs.len())?;
        fast.extend_from_slice(&paced.xs);
        Ok(Paced {
            frames,
            xs: mixed(
                &paced.xs,
                &slow,
                paced.ramps,
                frames as f64 / self.fps - self.lag(section),
            )?,
            longest: paced.longest,
            fast,
            slow,
            ramps: paced.ramps,
        })
    }
}

/// The cheapest way through all tables from a level, to a level if that is given.
fn route(
    tables: &[[[f64; LEVELS.len()]; LEVELS.len()]],
    first: usize,
    last: Option<usize>,
) -> Result<(f64, Vec<usize>)> {
    let mut costs = [f64::INFINITY; LEVELS.len()];
    costs[first] = 0.0;
    let mut from: Vec<[usize; LEVELS.len()]> = vec_with_room(tables.len())?;
    for table in tables {
        let mut next = [f64::INFINITY; LEVELS.len()];
        let mut came = [0; LEVELS.len()];
        for (a, row) in table.iter().enumerate() {
            for (b, cost) in row.iter().enumerate() {
                if costs[a] + cost < next[b] {
                    (next[b], came[b]) = (costs[a] + cost, a);
                }
            }
        }
        costs = next;
        from.push(came);
    }
    // At an open end the first level that is reached: what was asked for.
    let reached = (0..LEVELS.len()).find(|level| costs[*level].is_finite());
    let Some(mut at) = last.or(reached).filter(|at| costs[*at].is_finite()) else {
        return Ok((f64::INFINITY, Vec::new()));
    };
    let cost = costs[at];
    let mut levels = vec_with_room(tables.len() + 1)?;
    levels.push(at);
    for came in from.iter().rev() {
        at = came[at];
        levels.push(at);
    }
    levels.reverse();
    Ok((cost, levels))
}
