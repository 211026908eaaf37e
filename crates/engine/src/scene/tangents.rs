//! Velocities at the keys of numbers, so that every smooth interpolation is the same cubic between
//! two keys: Catmull and Rom, Kochanek and Bartels, C². They are laid out as the tangents of
//! `hermite`: for each key those before it, then those after it.

use crate::error::{OutOfRange, Result, vec_with_room};
use crate::math::tridiagonal::{Row, solve, solve_periodic};
use crate::path::Tcb;

#[derive(Clone, Copy)]
pub(super) struct NumberKeys<'a> {
    pub frames: &'a [f64],
    pub values: &'a [f64],
    pub width: usize,
}

impl NumberKeys<'_> {
    fn count(&self) -> usize {
        self.frames.len()
    }

    pub(super) fn step(&self, section: usize) -> f64 {
        self.frames[section + 1] - self.frames[section]
    }

    /// Mean velocity of one number within a section.
    fn mean(&self, section: usize, at: usize) -> f64 {
        let from = section * self.width + at;
        (self.values[from + self.width] - self.values[from]) / self.step(section)
    }
}

/// Velocities of Kochanek and Bartels, weighted for unequal times, with quadratic ends
/// (`docs/theory/path.md`, orientation curve; the same for numbers); with zeros those of Catmull and Rom.
pub(super) fn tcb(keys: NumberKeys<'_>, tcb: impl Fn(usize) -> Tcb) -> Result<Vec<f64>> {
    let (count, width) = (keys.count(), keys.width);
    let mut slopes = zeros(2 * width * count)?;
    let inner = |k: usize, at: usize, tcb: Tcb| {
        let (before, after) = (keys.step(k - 1), keys.step(k));
        let (v, w) = (keys.mean(k - 1, at), keys.mean(k, at));
        let scale = (1.0 - tcb.tension) / (before + after);
        let (v, w) = (v * after * scale, w * before * scale);
        let (c, b) = (tcb.continuity, tcb.bias);
        [
            (1.0 - c) * (1.0 + b) * v + (1.0 + c) * (1.0 - b) * w,
            (1.0 + c) * (1.0 + b) * v + (1.0 - c) * (1.0 - b) * w,
        ]
    };
    let end = |k: usize, section: usize, neighbour: usize, at: usize| {
        let loose = 1.0 - tcb(k).tension;
        let mean = keys.mean(section, at);
        if count == 2 {
            loose * mean
        } else {
            loose * (2.0 * mean - inner(neighbour, at, Tcb::default())[0])
        }
    };
    if count < 2 {
        return Ok(slopes);
    }
    for (k, both) in slopes.chunks_exact_mut(2 * width).enumerate() {
        let own = tcb(k);
        for at in 0..width {
            let [reach, leave] = if k == 0 {
                [end(0, 0, 1, at); 2]
            } else if k + 1 == count {
                [end(k, k - 1, k - 1, at); 2]
            } else {
                inner(k, at, own)
            };
            both[at] = reach;
            both[width + at] = leave;
        }
    }
    finite(slopes)
}

/// Velocities of the C² spline with natural ends, or periodic where the last values are the first.
pub(super) fn cubic(keys: NumberKeys<'_>, periodic: bool) -> Result<Vec<f64>> {
    let (count, width) = (keys.count(), keys.width);
    let mut slopes = zeros(2 * width * count)?;
    if count < 2 {
        return Ok(slopes);
    }
    let last = count - 1;
    let mut rows: Vec<Row<f64>> = vec_with_room(count)?;
    for at in 0..width {
        rows.clear();
        let inner = |k: usize, before: usize| {
            let (h, next) = (keys.step(before), keys.step(k));
            let right = 3.0 * (next * keys.mean(before, at) + h * keys.mean(k, at));
            Row::new([next, 2.0 * (h + next), h], right)
        };
        let mut set = |k: usize, slope: f64| slopes[2 * width * k + at] = slope;
        if !periodic {
            let end = |section| Row::new([1.0, 2.0, 1.0], 3.0 * keys.mean(section, at));
            rows.push(end(0));
            rows.extend((1..last).map(|k| inner(k, k - 1)));
            rows.push(end(last - 1));
            solve(&mut rows);
            (0..).zip(&rows).for_each(|(k, row)| set(k, row.right));
        } else if last > 1 {
            rows.extend((1..last).map(|k| inner(k, k - 1)));
            let joint = solve_periodic(&mut rows, inner(0, last - 1));
            set(0, joint);
            set(last, joint);
            (1..).zip(&rows).for_each(|(k, row)| set(k, row.right));
        }
    }
    for both in slopes.chunks_exact_mut(2 * width) {
        let (reach, leave) = both.split_at_mut(width);
        leave.copy_from_slice(reach);
    }
    finite(slopes)
}

fn zeros(count: usize) -> Result<Vec<f64>> {
    let mut zeros = vec_with_room(count)?;
    zeros.resize(count, 0.0);
    Ok(zeros)
}

fn finite(slopes: Vec<f64>) -> Result<Vec<f64>> {
    if slopes
        .iter()
        .all(|slope| slope.abs() <= crate::limits::MAX_TANGENT)
    {
        Ok(slopes)
    } else {
        Err(OutOfRange::KeyDistance.into())
    }
}
