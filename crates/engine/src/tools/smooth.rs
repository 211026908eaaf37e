//! A cubic spline with continuous second derivative near recorded rows: as little bent as it can be
//! while it misses each by no more than is allowed.
//!
//! Each solution is a smoothing spline (C. Reinsch, *Smoothing by spline functions*, 1967): the
//! second derivatives from a system with five diagonals, in linear time. A few rounds find the
//! weights: heavier where a row is missed by too much, and around it.

use crate::error::{Result, vec_with_room};

/// Weights begin so light that bends within a thousand rows, and a thousand frames, are taken out:
/// (1000/2π)⁴.
const LIGHT: f64 = 6e8;

/// Rounds of weighing; what is missed after them is met exactly.
const ROUNDS: usize = 30;

/// In noise, rounds after which a row that is missed by a little weighs at least twice as much: met
/// exactly with its noise, it would draw the spline far away from its neighbours.
const PATIENT: usize = 15;

/// Weights for noise: at most this many times heavier, halvings between the logarithms.
const HEAVIEST: f64 = 1e-14;
const HALVINGS: usize = 8;

/// By how much the residual may exceed the noise, and how many deviations of what so many rows say
/// of both; and such a share of that with outliers, or what bends would seem to be one.
const RESIDUAL: [f64; 2] = [1.02, 4.0];
const FOLLOWED: f64 = 0.75;

/// The standard deviation of normal noise in medians of its sizes.
const DEVIATION_IN_MEDIANS: f64 = 1.4826;

/// Standard deviation of the noise, of the channel with most, from the median of third divided
/// differences, which a smooth motion hardly has (Gasser, Sroka, Jennen-Steinmetz 1986 for second
/// ones).
pub(crate) fn noise<const N: usize>(times: &[f64], rows: &[[f64; N]]) -> Result<f64> {
    let mut factors: Vec<[f64; 4]> = vec_with_room(rows.len())?;
    factors.extend(times.windows(4).map(|times| {
        let factor = |k: usize| {
            let others = (0..4).filter(|other| *other != k);
            others
                .map(|other| times[k] - times[other])
                .product::<f64>()
                .recip()
        };
        let all = [0, 1, 2, 3].map(factor);
        let size = all.iter().map(|factor| factor * factor).sum::<f64>().sqrt();
        all.map(|factor| factor / size)
    }));
    let difference = |at: usize, channel: usize| {
        let parts = factors[at].iter().zip(&rows[at..]);
        parts
            .map(|(factor, row)| factor * row[channel])
            .sum::<f64>()
    };
    deviation::<N>(factors.len(), &difference)
}

/// The greatest of the channels, by the median of the sizes.
fn deviation<const N: usize>(count: usize, value: &dyn Fn(usize, usize) -> f64) -> Result<f64> {
    let mut most = 0.0_f64;
    let mut sizes = vec_with_room(count)?;
    for channel in 0..N {
        sizes.clear();
        sizes.extend((0..count).map(|at| value(at, channel).abs()));
        let middle = count / 2;
        if middle > 0 {
            let (_, median, _) = sizes.select_nth_unstable_by(middle, f64::total_cmp);
            most = most.max(*median * DEVIATION_IN_MEDIANS);
        }
    }
    Ok(most)
}

/// A cubic spline.
#[derive(Debug)]
pub(crate) struct Spline<const N: usize> {
    times: Vec<f64>,
    values: Vec<[f64; N]>,
    /// Second derivatives.
    bends: Vec<[f64; N]>,
    /// Standard deviation of the noise left in a channel of `bends`.
    bend_noise: f64,
}

fn add<const N: usize>(sum: &mut [f64; N], factor: f64, row: &[f64; N]) {
    for (sum, value) in sum.iter_mut().zip(row) {
        *sum += factor * value;
    }
}

fn apart<const N: usize>(a: &[f64; N], b: &[f64; N]) -> f64 {
    let squares = a.iter().zip(b).map(|(a, b)| (a - b) * (a - b));
    squares.sum::<f64>().sqrt()
}

impl<const N: usize> Spline<N> {
    /// Near all rows: `allowed` is how far each may be missed: 0 not at all, an
    /// infinite one does not count. No smoother than that its residual is the noise, if that is
    /// not 0; rows that are `is_noisy` are not met exactly. `round` is called before each solution.
    pub(crate) fn near(
        times: &[f64],
        rows: &[[f64; N]],
        allowed: &[f64],
        noise: f64,
        is_noisy: bool,
        round: &mut dyn FnMut() -> Result<()>,
    ) -> Result<Self> {
        let mut spline = Self::straight(times, rows)?;
        let step = spline.step();
        let mut light = LIGHT * step.powi(3).max(1.0 / step);
        if noise > 0.0 {
            let counts = |k: usize| allowed[k] > 0.0 && allowed[k].is_finite();
            light = spline.light_for(rows, &counts, noise, light, round)?;
            // What a low pass of that length leaves of white noise.
            let length = (light * step).sqrt().sqrt().max(step);
            spline.bend_noise = 0.3 * noise * (step / length.powi(5)).sqrt();
        }
        let patient = if is_noisy { PATIENT } else { ROUNDS };
        spline.weighed(rows, allowed, light, patient, round)
    }

    /// Whether noise misses some row by more than `most`, as normal noise does where there are many.
    pub(crate) fn outgrows(
        times: &[f64],
        rows: &[[f64; N]],
        noise: f64,
        most: f64,
        round: &mut dyn FnMut() -> Result<()>,
    ) -> Result<bool> {
        let mut spline = Self::straight(times, rows)?;
        let lightest = LIGHT * spline.step().powi(3);
        let all = spline.light_for(rows, &|_| true, noise, lightest, round)?;
        let mut light = vec_with_room(rows.len())?;
        light.resize(rows.len(), all);
        spline.solve(rows, &light)?;
        let mut missed = rows.iter().zip(&spline.values);
        Ok(missed.any(|(row, value)| apart(row, value) > most))
    }

    /// The lightest of all weights with which the residual is no greater than the noise (V. A.
    /// Morozov's discrepancy principle, 1966).
    fn light_for(
        &mut self,
        rows: &[[f64; N]],
        counts: &dyn Fn(usize) -> bool,
        noise: f64,
        lightest: f64,
        round: &mut dyn FnMut() -> Result<()>,
    ) -> Result<f64> {
        let mut counted = vec_with_room(rows.len())?;
        counted.extend((0..rows.len()).filter(|k| counts(*k)));
        let mut light = vec_with_room(rows.len())?;
        light.resize(rows.len(), lightest);
        let most = (RESIDUAL[0] + RESIDUAL[1] / (counted.len() as f64).sqrt()) * noise;
        let [mut low, mut high] = [HEAVIEST.ln(), 0.0];
        let mut now = 0.0_f64;
        for _ in 0..=HALVINGS {
            round()?;
            for k in &counted {
                light[*k] = lightest * now.exp();
            }
            self.solve(rows, &light)?;
            let off = |at: usize, channel: usize| {
                let k = counted[at];
                rows[k][channel] - self.values[k][channel]
            };
            if deviation::<N>(counted.len(), &off)? <= most {
                low = now;
            } else {
                high = now;
            }
            if low == 0.0 {
                break;
            }
            now = 0.5 * (low + high);
        }
        Ok(lightest * low.exp())
    }

    /// A low pass: rows one a time, of whose waves ω a time it leaves 1/(1 + `light`·ω⁴), but
    /// misses none by more than is allowed.
    pub(crate) fn low_pass(
        times: &[f64],
        rows: &[[f64; N]],
        allowed: &[f64],
        light: f64,
        round: &mut dyn FnMut() -> Result<()>,
    ) -> Result<Self> {
        Self::straight(times, rows)?.weighed(rows, allowed, light, ROUNDS, round)
    }

    /// All rows weigh as little, 1/`all`, until they are missed; after `patient` rounds those that are
    /// missed by a little weigh more, too.
    fn weighed(
        self,
        rows: &[[f64; N]],
        allowed: &[f64],
        all: f64,
        patient: usize,
        round: &mut dyn FnMut() -> Result<()>,
    ) -> Result<Self> {
        let mut spline = self;
        if rows.iter().all(|row| *row == rows[0]) {
            return Ok(spline);
        }
        let mut light = vec_with_room(rows.len())?;
        light.extend(
            allowed
                .iter()
                .map(|allowed| if *allowed > 0.0 { all } else { 0.0 }),
        );
        let mut factors: Vec<f64> = vec_with_room(rows.len())?;
        for number in 0..ROUNDS {
            round()?;
            spline.solve(rows, &light)?;
            factors.clear();
            let least = if number < patient { 1.0 } else { 2.0 };
            let missed = rows.iter().zip(&spline.values).zip(allowed);
            factors.extend(missed.map(|((row, value), allowed)| {
                let off = apart(row, value);
                if off > *allowed && *allowed > 0.0 {
                    (off / allowed).powf(1.25).clamp(least, 100.0)
                } else {
                    1.0
                }
            }));
            if factors.iter().all(|factor| *factor == 1.0) {
                return Ok(spline);
            }
            // Rows nearby go along, so that weights change no faster than the spline can bend.
            for k in 1..rows.len() {
                spline.spread(&mut factors, [k - 1, k], light[k]);
            }
            for k in (1..rows.len()).rev() {
                spline.spread(&mut factors, [k, k - 1], light[k - 1]);
            }
            for ((light, factor), allowed) in light.iter_mut().zip(&factors).zip(allowed) {
                if allowed.is_finite() {
                    *light /= factor;
                }
            }
        }
        let missed = rows.iter().zip(&spline.values).zip(allowed);
        for (((row, value), allowed), light) in missed.zip(&mut light) {
            if apart(row, value) > 1.1 * allowed {
                *light = 0.0;
            }
        }
        spline.solve(rows, &light)?;
        Ok(spline)
    }

    /// Near the rows except a few that are far off (P. J. Huber, *Robust estimation of a location
    /// parameter*, 1964): beyond `bound` a row pulls no more, and those left out not at all.
    pub(crate) fn robust(
        times: &[f64],
        rows: &[[f64; N]],
        bound: f64,
        noise: f64,
        left_out: &[bool],
    ) -> Result<Self> {
        let mut spline = Self::straight(times, rows)?;
        let step = spline.step();
        let mut light = vec_with_room(rows.len())?;
        let mut all = step * step * step;
        if noise > 0.0 {
            let counts = |k: usize| !left_out[k];
            let most = FOLLOWED * noise;
            let least = spline.light_for(rows, &counts, most, LIGHT * all, &mut || Ok(()))?;
            all = all.max(least);
        }
        light.extend(
            left_out
                .iter()
                .map(|out| if *out { LIGHT * step.powi(3) } else { all }),
        );
        for _ in 0..ROUNDS {
            spline.solve(rows, &light)?;
            let off = rows.iter().zip(&spline.values).zip(left_out);
            for (((row, value), left_out), light) in off.zip(&mut light) {
                if !left_out {
                    *light = all * (apart(row, value) / bound).max(1.0);
                }
            }
        }
        Ok(spline)
    }

    fn straight(times: &[f64], rows: &[[f64; N]]) -> Result<Self> {
        let mut spline = Self {
            times: vec_with_room(rows.len())?,
            values: vec_with_room(rows.len())?,
            bends: vec_with_room(rows.len())?,
            bend_noise: 0.0,
        };
        spline.times.extend_from_slice(times);
        spline.values.extend_from_slice(rows);
        spline.bends.resize(rows.len(), [0.0; N]);
        Ok(spline)
    }

    /// What a row's factor asks of its neighbour: less, the more the spline may bend between.
    fn spread(&self, factors: &mut [f64], [from, to]: [usize; 2], light: f64) {
        let step = (self.times[to] - self.times[from]).abs();
        let length = (light * step).sqrt().sqrt();
        if length > 0.0 {
            let asked = 1.0 + (factors[from] - 1.0) * (-step / length).exp();
            factors[to] = factors[to].max(asked);
        }
    }

    /// The mean step of time.
    #[allow(clippy::cast_precision_loss)]
    fn step(&self) -> f64 {
        let last = self.times.len() - 1;
        (self.times[last] - self.times[0]) / last.max(1) as f64
    }

    /// Values and bends for rows and the inverses of their weights: with the second differences Q
    /// and R, by which bends belong to them, (R + Qᵀ·light·Q)·bends = Qᵀ·rows. At the ends the
    /// spline is a parabola: a natural one would unbend there.
    fn solve(&mut self, rows: &[[f64; N]], light: &[f64]) -> Result<()> {
        let Some(inner) = rows.len().checked_sub(2).filter(|inner| *inner > 0) else {
            return Ok(());
        };
        let step = |k: usize| self.times[k + 1] - self.times[k];
        // Column k of Q, whose rows are k, k + 1 and k + 2.
        let column = |k: usize| {
            let (before, after) = (1.0 / step(k), 1.0 / step(k + 1));
            [before, -before - after, after]
        };
        // The rows of L·D·Lᵀ: D, and L one and two below the diagonal.
        let mut factors: Vec<[f64; 3]> = vec_with_room(inner)?;
        for k in 0..inner {
            let q = column(k);
            let before = if k == 0 { 2.0 } else { 3.0 };
            let after = if k + 1 == inner { 2.0 } else { 3.0 };
            let mut row = [
                step(k) / before
                    + step(k + 1) / after
                    + q[0] * q[0] * light[k]
                    + q[1] * q[1] * light[k + 1]
                    + q[2] * q[2] * light[k + 2],
                0.0,
                0.0,
            ];
            let mut right = [0.0; N];
            for (offset, q) in q.iter().enumerate() {
                add(&mut right, *q, &rows[k + offset]);
            }
            if k > 1 {
                let p = column(k - 2);
                row[2] = p[2] * q[0] * light[k] / factors[k - 2][0];
                row[0] -= row[2] * row[2] * factors[k - 2][0];
                let known = self.bends[k - 1];
                add(&mut right, -row[2], &known);
            }
            if k > 0 {
                let p = column(k - 1);
                let mut beside =
                    step(k) / 6.0 + p[1] * q[0] * light[k] + p[2] * q[1] * light[k + 1];
                if k > 1 {
                    beside -= row[2] * factors[k - 1][1] * factors[k - 2][0];
                }
                row[1] = beside / factors[k - 1][0];
                row[0] -= row[1] * row[1] * factors[k - 1][0];
                let known = self.bends[k];
                add(&mut right, -row[1], &known);
            }
            // R alone leaves more than this, and light weights only add to it; rounding takes it away
            // where they differ by many orders.
            row[0] = row[0].max(0.2 * (step(k) + step(k + 1)));
            factors.push(row);
            self.bends[k + 1] = right;
        }
        for k in (0..inner).rev() {
            let mut bend = self.bends[k + 1].map(|right| right / factors[k][0]);
            for below in 1..=2 {
                if k + below < inner {
                    let known = self.bends[k + 1 + below];
                    add(&mut bend, -factors[k + below][below], &known);
                }
            }
            self.bends[k + 1] = bend;
        }
        self.bends[0] = self.bends[1];
        self.bends[inner + 1] = self.bends[inner];
        self.values.copy_from_slice(rows);
        for k in 0..inner {
            for (offset, q) in column(k).iter().enumerate() {
                let bend = self.bends[k + 1];
                add(&mut self.values[k + offset], -light[k + offset] * q, &bend);
            }
        }
        Ok(())
    }

    /// The value at a row's time.
    pub(crate) fn value(&self, row: usize) -> &[f64; N] {
        &self.values[row]
    }

    /// A row's time.
    pub(crate) fn time(&self, row: usize) -> f64 {
        self.times[row]
    }

    /// The second derivative at a row's time.
    pub(crate) fn bend(&self, row: usize) -> &[f64; N] {
        &self.bends[row]
    }

    /// Standard deviation of the noise left in a channel of the second derivatives.
    pub(crate) const fn bend_noise(&self) -> f64 {
        self.bend_noise
    }

    /// Value and two derivatives at any time.
    pub(crate) fn at(&self, time: f64) -> [[f64; N]; 3] {
        let last = self.times.len() - 1;
        if last == 0 {
            return [self.values[0], [0.0; N], [0.0; N]];
        }
        let after = self.times.partition_point(|at| *at <= time).clamp(1, last);
        let (from, to) = (after - 1, after);
        let step = self.times[to] - self.times[from];
        let b = (time - self.times[from]) / step;
        let a = 1.0 - b;
        let (mut value, mut slope, mut bend) = (self.values[from], [0.0; N], [0.0; N]);
        for k in 0..N {
            bend[k] = a * self.bends[from][k] + b * self.bends[to][k];
            let rise = self.values[to][k] - self.values[from][k];
            let [left, right] = [from, to].map(|at| self.bends[at][k] * step / 6.0);
            value[k] += b * rise + ((a * a * a - a) * left + (b * b * b - b) * right) * step;
            slope[k] = rise / step - (3.0 * a * a - 1.0) * left + (3.0 * b * b - 1.0) * right;
        }
        [value, slope, bend]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TIMES: [f64; 7] = [0.0, 1.0, 1.5, 4.0, 5.0, 9.0, 10.0];
    const ROWS: [[f64; 1]; 7] = [[1.0], [3.0], [2.0], [5.0], [-1.0], [0.0], [4.0]];

    /// SciPy 1.17: `CubicSpline` whose second derivatives at the ends equal those of the adjacent
    /// knots; and with weights of ½ the values at which the gradient of the sum that is to
    /// be least, differences of it by that spline, is 0 to 1e-11.
    #[test]
    fn it_is_the_spline_of_another_library() {
        let mut through = Spline::straight(&TIMES, &ROWS).unwrap();
        through.solve(&ROWS, &[0.0; 7]).unwrap();
        let mut near = Spline::straight(&TIMES, &ROWS).unwrap();
        near.solve(&ROWS, &[2.0; 7]).unwrap();
        let known = [
            (&through, 0.7, 3.132_132_84, 0.605_461_25),
            (&through, 4.5, 2.315_424_23, -6.589_815_62),
            (&through, 8.0, -3.437_143_47, 2.895_397_58),
            (&through, 10.0, 4.0, 4.194_655_72),
            (&near, 0.0, 1.581_635_36, 0.844_901_64),
            (&near, 2.0, 2.695_789_16, 0.264_872_43),
            (&near, 8.0, 0.496_040_94, 0.535_685_41),
            (&near, 10.0, 2.764_886_08, 1.748_215_57),
        ];
        for (spline, time, value, slope) in known {
            let [[v], [s], _] = spline.at(time);
            assert!(
                (v - value).abs() < 1e-8 && (s - slope).abs() < 1e-8,
                "{time}: {v} {s}"
            );
        }
    }

    #[test]
    fn no_row_is_missed_by_more_than_allowed() {
        let times: Vec<f64> = (0..500).map(f64::from).collect();
        let rows: Vec<[f64; 1]> = times
            .iter()
            .map(|t| [(0.05 * t).sin() + (7.0 * t).sin() * 0.004])
            .collect();
        let mut allowed = [0.006; 500];
        (allowed[0], allowed[499]) = (0.0, 0.0);
        let spline = Spline::near(&times, &rows, &allowed, 0.0, false, &mut || Ok(())).unwrap();
        for (k, row) in rows.iter().enumerate() {
            assert!(
                (spline.value(k)[0] - row[0]).abs() <= 1.1 * allowed[k] + 1e-12,
                "{k}"
            );
            // The sine bends by 0.0025, the noise by up to 0.016.
            assert!(
                spline.bend(k)[0].abs() < 0.0027 || !(3..497).contains(&k),
                "{k}"
            );
        }
    }
}
