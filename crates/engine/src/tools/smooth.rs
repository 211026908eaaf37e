//! Noise taken out of recorded channels: a cubic spline with continuous slope by least squares,
//! whose pieces are halved where it misses too much. Its normal equations are block tridiagonal
//! with 2×2 blocks (value and slope), so that a solution takes linear time.

use glam::{DMat2, DVec2};

use crate::error::{Result, vec_with_room};

/// Position, quaternion, zoom.
pub(super) const CHANNELS: usize = 8;

pub(super) type Row = [f64; CHANNELS];

/// Samples that a piece must have, to tell noise from motion.
const LEAST: usize = 12;

/// Standard deviation of the noise of each channel, from the median of third differences, which a
/// smooth motion hardly has (Gasser, Sroka, Jennen-Steinmetz 1986 for second ones).
pub(super) fn noise(rows: &[Row]) -> Result<Row> {
    let mut found = [0.0; CHANNELS];
    let mut differences = vec_with_room(rows.len())?;
    for (channel, noise) in found.iter_mut().enumerate() {
        differences.clear();
        differences.extend(rows.windows(4).map(|w| {
            let x = |k: usize| w[k][channel];
            (x(3) - 3.0 * x(2) + 3.0 * x(1) - x(0)).abs()
        }));
        if differences.is_empty() {
            continue;
        }
        let middle = differences.len() / 2;
        let (_, median, _) = differences.select_nth_unstable_by(middle, f64::total_cmp);
        *noise = *median / (0.6745 * 20f64.sqrt());
    }
    Ok(found)
}

/// Values of the Hermite basis: at the start, slope there, at the end, slope there.
fn basis(t: f64, step: f64) -> [f64; 4] {
    let (a, b) = (t * t * (3.0 - 2.0 * t), t * (1.0 - t));
    [1.0 - a, step * b * (1.0 - t), a, -step * b * t]
}

/// The rows without noise; `misses` gives how far the spline misses a row, 1 being what it may.
pub(super) fn smoothed(
    times: &[f64],
    rows: &[Row],
    misses: &dyn Fn(&Row, &Row) -> f64,
) -> Result<Vec<Row>> {
    let last = rows.len() - 1;
    let mut smooth: Vec<Row> = vec_with_room(rows.len())?;
    smooth.extend_from_slice(rows);
    if rows.len() < 2 * LEAST {
        return Ok(smooth);
    }
    let mut knots: Vec<usize> = vec_with_room(rows.len() / LEAST + 2)?;
    knots.extend([0, last]);
    loop {
        let solved = solve(times, rows, &knots)?;
        let mut split = vec_with_room(knots.capacity())?;
        split.push(0);
        for (piece, pair) in knots.windows(2).enumerate() {
            let step = times[pair[1]] - times[pair[0]];
            let mut worst = 0.0_f64;
            for k in pair[0]..=pair[1] {
                let b = basis((times[k] - times[pair[0]]) / step, step);
                for channel in 0..CHANNELS {
                    let (from, to) = (solved[piece][channel], solved[piece + 1][channel]);
                    smooth[k][channel] = b[0] * from.x + b[1] * from.y + b[2] * to.x + b[3] * to.y;
                }
                worst = worst.max(misses(&rows[k], &smooth[k]));
            }
            let middle = usize::midpoint(pair[0], pair[1]);
            if worst > 1.0 && middle - pair[0] >= LEAST && pair[1] - middle >= LEAST {
                split.push(middle);
            }
            split.push(pair[1]);
        }
        if split.len() == knots.len() {
            return Ok(smooth);
        }
        knots = split;
    }
}

/// Value and slope of each channel at each knot.
fn solve(times: &[f64], rows: &[Row], knots: &[usize]) -> Result<Vec<[DVec2; CHANNELS]>> {
    let count = knots.len();
    let mut diagonal = vec_with_room(count)?;
    diagonal.resize(count, DMat2::ZERO);
    // Of each knot with the next one.
    let mut beside = vec_with_room(count)?;
    beside.resize(count, DMat2::ZERO);
    let mut right = vec_with_room(count)?;
    right.resize(count, [DVec2::ZERO; CHANNELS]);
    let outer = |a: DVec2, b: DVec2| DMat2::from_cols(a * b.x, a * b.y);
    for (piece, pair) in knots.windows(2).enumerate() {
        let step = times[pair[1]] - times[pair[0]];
        let end = if piece + 2 == count {
            pair[1] + 1
        } else {
            pair[1]
        };
        for k in pair[0]..end {
            let b = basis((times[k] - times[pair[0]]) / step, step);
            let (from, to) = (DVec2::new(b[0], b[1]), DVec2::new(b[2], b[3]));
            diagonal[piece] += outer(from, from);
            diagonal[piece + 1] += outer(to, to);
            beside[piece] += outer(from, to);
            for channel in 0..CHANNELS {
                right[piece][channel] += from * rows[k][channel];
                right[piece + 1][channel] += to * rows[k][channel];
            }
        }
    }
    for knot in 1..count {
        let factor = beside[knot - 1].transpose() * diagonal[knot - 1].inverse();
        diagonal[knot] -= factor * beside[knot - 1];
        for channel in 0..CHANNELS {
            let known = right[knot - 1][channel];
            right[knot][channel] -= factor * known;
        }
    }
    for knot in (0..count).rev() {
        let inverse = diagonal[knot].inverse();
        for channel in 0..CHANNELS {
            let behind = right
                .get(knot + 1)
                .map_or(DVec2::ZERO, |next| next[channel]);
            right[knot][channel] = inverse * (right[knot][channel] - beside[knot] * behind);
        }
    }
    Ok(right)
}
