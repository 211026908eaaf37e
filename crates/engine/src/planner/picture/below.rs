//! The greatest smooth function below another one.

use crate::error::{Result, vec_with_room};

/// Tops of parabolas beyond each open end.
const BEYOND: usize = 256;

/// Places on an axis, how long it takes from one to the next, and a bound at each.
#[derive(Debug, Clone, Copy)]
pub(super) struct Course<'a> {
    /// Not falling.
    pub at: &'a [f64],
    /// Not falling.
    pub time: &'a [f64],
    /// Whether the last place is the first again.
    pub closed: bool,
}

impl Course<'_> {
    /// The greatest function that is nowhere above `bound`, changes by at most `rate` a second and
    /// bends down by at most `bend` for each unit of the axis squared: first by both passes of a
    /// distance transform, then opened by a parabola (a morphological opening; both transforms of
    /// Felzenszwalb and Huttenlocher, *Distance transforms of sampled functions*, 2012).
    pub(super) fn below(&self, bound: &[f64], rate: f64, bend: f64) -> Result<Vec<f64>> {
        let count = bound.len();
        // A closed course goes round three times; the middle one knows both neighbours.
        let rounds = if self.closed { 3 } else { 1 };
        let (length, seconds) = (
            self.at[count - 1] - self.at[0],
            self.time[count - 1] - self.time[0],
        );
        let mut at = vec_with_room(rounds * count)?;
        let mut time = vec_with_room(rounds * count)?;
        let mut found: Vec<f64> = vec_with_room(rounds * count)?;
        for round in 0..rounds {
            at.extend(self.at.iter().map(|x| x + round as f64 * length));
            time.extend(self.time.iter().map(|t| t + round as f64 * seconds));
            found.extend_from_slice(bound);
        }
        let all = found.len();
        let most = |before: f64, step: f64| {
            if step > 0.0 {
                before + rate * step
            } else {
                before
            }
        };
        for k in 1..all {
            found[k] = found[k].min(most(found[k - 1], time[k] - time[k - 1]));
        }
        for k in (1..all).rev() {
            found[k - 1] = found[k - 1].min(most(found[k], time[k] - time[k - 1]));
        }
        if bend.is_finite() && bend > 0.0 {
            // Parabolas that touch near an open end may have their tops beyond it.
            let steep = (1..all)
                .filter(|k| at[*k] > at[k - 1])
                .map(|k| ((found[k] - found[k - 1]) / (at[k] - at[k - 1])).abs())
                .fold(0.0, f64::max);
            let beyond = (steep / bend).min(4.0 * (at[all - 1] - at[0]));
            let step = |k: usize| beyond * (k as f64 / BEYOND as f64);
            let mut tops = vec_with_room(all + 2 * BEYOND)?;
            tops.extend((1..=BEYOND).rev().map(|k| at[0] - step(k)));
            tops.extend_from_slice(&at);
            tops.extend((1..=BEYOND).map(|k| at[all - 1] + step(k)));
            let least = envelope(&at, &found, &tops, bend, 1.0)?;
            found = envelope(&tops, &least, &at, bend, -1.0)?;
        }
        let from = (rounds / 2) * count;
        found.copy_within(from..from + count, 0);
        found.truncate(count);
        for (found, bound) in found.iter_mut().zip(bound) {
            *found = found.min(*bound);
        }
        Ok(found)
    }
}

/// The lower envelope of parabolas that stand on the values (`sign` 1), or the upper one of those
/// that hang from them (−1), at other places.
fn envelope(at: &[f64], values: &[f64], places: &[f64], bend: f64, sign: f64) -> Result<Vec<f64>> {
    let mut stack: Vec<(usize, f64)> = vec_with_room(at.len())?;
    let value = |k: usize| sign * values[k];
    for k in 0..at.len() {
        let mut start = f64::NEG_INFINITY;
        let mut stands = true;
        while let Some(&(top, from)) = stack.last() {
            let step = at[k] - at[top];
            if step <= 0.0 {
                stands = value(k) < value(top);
                if !stands {
                    break;
                }
                stack.pop();
                continue;
            }
            // Where the two parabolas meet.
            start = (value(k) - value(top)) / (bend * step) + 0.5 * (at[k] + at[top]);
            if start > from {
                break;
            }
            stack.pop();
            start = f64::NEG_INFINITY;
        }
        if stands {
            stack.push((k, start));
        }
    }
    let mut made = vec_with_room(places.len())?;
    let mut top = 0;
    for x in places {
        while top + 1 < stack.len() && stack[top + 1].1 <= *x {
            top += 1;
        }
        let from = stack[top].0;
        made.push(sign * (value(from) + 0.5 * bend * (x - at[from]).powi(2)));
    }
    Ok(made)
}
