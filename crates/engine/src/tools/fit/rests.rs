//! Pauses in noise: the longest runs of rows of which no part says anything else than the others, and
//! beside which the camera moves at once. Where a motion only turns round, what lies beside a run
//! is hardly farther off than its ends.

use std::ops::Range;

use crate::error::{Result, vec_with_room};

/// Parts of a run whose means are compared.
const PARTS: usize = 4;

/// Fewest rows of a run.
const FEWEST: usize = 16;

/// The greatest sum of the squares of the means' deviations, in variances, that is chance: for nine
/// degrees of freedom one in a hundred.
const CHANCE: f64 = 21.7;

/// How far off, in deviations of a run's mean, rows beside it are on average at least: two and a half
/// times what a parabola has whose run is just chance.
const BESIDE: f64 = 46.0;

/// The share of a run that counts as its neighbourhood, on either side.
const SIDE: usize = 4;

/// The lengths of runs that are tried, each shorter than the one before by this factor.
const SHORTER: f64 = 0.75;

/// Sums of rows up to each.
pub(super) struct Sums<'a, const N: usize> {
    rows: &'a [[f64; N]],
    sums: Vec<[f64; N]>,
    /// Standard deviation of a channel.
    noise: f64,
}

impl<'a, const N: usize> Sums<'a, N> {
    pub(super) fn new(rows: &'a [[f64; N]], noise: f64) -> Result<Self> {
        let mut sums = vec_with_room(rows.len() + 1)?;
        let mut sum = [0.0; N];
        sums.push(sum);
        for row in rows {
            for (sum, value) in sum.iter_mut().zip(row) {
                *sum += value;
            }
            sums.push(sum);
        }
        Ok(Self { rows, sums, noise })
    }

    pub(super) fn mean(&self, run: Range<usize>) -> [f64; N] {
        let count = run.len() as f64;
        std::array::from_fn(|k| (self.sums[run.end][k] - self.sums[run.start][k]) / count)
    }

    /// How far the mean of a run is from a place.
    fn off(&self, run: Range<usize>, from: &[f64; N]) -> f64 {
        let mean = self.mean(run);
        let squares = mean.iter().zip(from).map(|(a, b)| (a - b) * (a - b));
        squares.sum::<f64>().sqrt()
    }

    /// Whether its parts differ by chance only.
    fn rests(&self, run: &Range<usize>) -> bool {
        let mean = self.mean(run.clone());
        let end = |part: usize| run.start + run.len() * part / PARTS;
        let squares = (0..PARTS).map(|part| {
            let part = end(part)..end(part + 1);
            let off = self.off(part.clone(), &mean) / self.noise;
            part.len() as f64 * off * off
        });
        squares.sum::<f64>() <= CHANCE
    }

    /// Whether its neighbours are elsewhere, all at once.
    fn stands_out(&self, run: &Range<usize>) -> bool {
        let mean = self.mean(run.clone());
        let least = BESIDE * self.noise / (run.len() as f64).sqrt();
        let side = (run.len() / SIDE).max(2);
        let before = run.start.saturating_sub(side)..run.start;
        let after = run.end..(run.end + side).min(self.rows.len());
        let beside = [before, after];
        // At an end of the recording it may rest without having moved.
        let mut moving = beside.into_iter().filter(|beside| beside.len() > side / 2);
        moving.all(|beside| self.off(beside, &mean) >= least)
    }

    /// As long as it rests.
    fn extended(&self, mut run: Range<usize>) -> Range<usize> {
        let mut step = run.len() / 2;
        while step > 0 {
            let longer = [
                run.start.saturating_sub(step)..run.end,
                run.start..(run.end + step).min(self.rows.len()),
            ];
            let found = longer
                .into_iter()
                .find(|longer| *longer != run && self.rests(longer));
            match found {
                Some(longer) => run = longer,
                None => step /= 2,
            }
        }
        run
    }

    /// Between the rows at which the camera begins and ends to move: what runs on says nothing of a
    /// few rows at its ends.
    fn settled(&self, run: &Range<usize>) -> Range<usize> {
        let side = run.len() / SIDE;
        let mean = self.mean(run.start + side..run.end - side);
        let (start, end) = (run.start + side, run.end - side);
        let before = self.bend(&mean, &|k| (start - 1).checked_sub(k), 2 * side);
        let after = self.bend(&mean, &|k| Some(end + k), 2 * side);
        // At an end of the rows nothing leaves.
        let ends = [run.start == 0, run.end == self.rows.len()];
        let [before, after] = [0, 1].map(|k| {
            if ends[k] {
                side
            } else {
                side.min([before, after][k])
            }
        });
        start - before..end + after
    }

    /// The row of so many, one after the other, from which on they leave a place evenly.
    fn bend(
        &self,
        from: &[f64; N],
        number: &dyn Fn(usize) -> Option<usize>,
        count: usize,
    ) -> usize {
        let row = |k: usize| number(k).and_then(|number| self.rows.get(number));
        // By how much a line from there on lessens the squares of what is missed.
        let gain = |bend: usize| {
            let (mut sum, mut squares) = ([0.0; N], 0.0);
            for (x, row) in (bend + 1..count).map_while(row).enumerate() {
                let x = x as f64 + 1.0;
                squares += x * x;
                for k in 0..N {
                    sum[k] += x * (row[k] - from[k]);
                }
            }
            sum.iter().map(|sum| sum * sum).sum::<f64>() / f64::max(squares, 1.0)
        };
        let mut step = (count / 4).max(1);
        let (mut best, mut most) = (count / 2, gain(count / 2));
        loop {
            for bend in [best.saturating_sub(step), best + step] {
                let gains = gain(bend);
                if gains > most {
                    (best, most) = (bend, gains);
                }
            }
            if step == 1 {
                return best;
            }
            step = step.div_ceil(2);
        }
    }

    /// The pauses, in order; apart from each other.
    pub(super) fn pauses(&self) -> Result<Vec<Range<usize>>> {
        let mut found: Vec<Range<usize>> = Vec::new();
        let mut length = self.rows.len();
        while self.noise > 0.0 && length >= FEWEST {
            let mut at = 0;
            while at + length <= self.rows.len() {
                let run = at..at + length;
                at += (length / 6).max(1);
                let apart = |other: &Range<usize>| run.end <= other.start || other.end <= run.start;
                if !found.iter().all(apart) || !self.rests(&run) {
                    continue;
                }
                let run = self.extended(run);
                let apart = |other: &Range<usize>| run.end <= other.start || other.end <= run.start;
                if found.iter().all(apart) && self.stands_out(&run) {
                    at = at.max(run.end);
                    found.try_reserve(1)?;
                    found.push(self.settled(&run));
                }
            }
            length = (length as f64 * SHORTER) as usize;
        }
        found.sort_unstable_by_key(|run| run.start);
        Ok(found)
    }
}
