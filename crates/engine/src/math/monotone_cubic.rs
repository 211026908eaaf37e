//! Monotone piecewise cubic interpolation (Fritsch and Carlson, SIAM J. Numer. Anal. 17, 1980):
//! between two keys the curve never leaves the range of their values.

/// Slope of the parabola through three points, at the middle one.
fn middle_slope(h: [f64; 2], delta: [f64; 2]) -> f64 {
    (h[1] * delta[0] + h[0] * delta[1]) / (h[0] + h[1])
}

/// Slope of the parabola through three points, at the end next to `h[0]`.
fn end_slope(h: [f64; 2], delta: [f64; 2]) -> f64 {
    ((2.0 * h[0] + h[1]) * delta[0] - h[0] * delta[1]) / (h[0] + h[1])
}

/// Factor that brings two slopes into the circle of radius 3, in which the cubic is monotone.
pub(crate) fn scale(delta: f64, left: f64, right: f64) -> f64 {
    let size = left.hypot(right);
    let room = 3.0 * delta.abs();
    if size > room { room / size } else { 1.0 }
}

/// Writes slopes at the keys; from key i to the next the value rises by `rises[i]` over `steps[i]`.
/// All steps are > 0.
///
/// Each interval asks for its two slopes to be scaled, and a slope follows the stricter of the two,
/// so the curve does not depend on the direction in which keys are counted.
///
/// `periodic`: the last key is the first again (up to a constant), so their slopes agree. Two keys
/// that are not periodic give a straight line.
///
/// # Panics
/// Unless there are n ≥ 1 steps, n rises and n + 1 slopes.
pub fn slopes(steps: &[f64], rises: &[f64], periodic: bool, slopes: &mut [f64]) {
    let n = steps.len();
    assert!(n >= 1 && rises.len() == n && slopes.len() == n + 1);
    let delta = |i: usize| rises[i] / steps[i];
    let middle = |i: usize, j: usize| middle_slope([steps[i], steps[j]], [delta(i), delta(j)]);
    for k in 1..n {
        slopes[k] = middle(k - 1, k);
    }
    if periodic {
        slopes[0] = middle(n - 1, 0);
        slopes[n] = slopes[0];
    } else if n == 1 {
        (slopes[0], slopes[1]) = (delta(0), delta(0));
    } else {
        slopes[0] = end_slope([steps[0], steps[1]], [delta(0), delta(1)]);
        slopes[n] = end_slope([steps[n - 1], steps[n - 2]], [delta(n - 1), delta(n - 2)]);
    }
    let before = |k: usize| match k {
        0 => periodic.then(|| n - 1),
        k => Some(k - 1),
    };
    let after = |k: usize| match k {
        k if k == n => periodic.then_some(0),
        k => Some(k),
    };
    // Slopes beside level or opposing intervals become 0 first, or partners are scaled for nothing.
    for (k, slope) in slopes.iter_mut().enumerate() {
        let turns = |i: Option<usize>| i.is_some_and(|i| *slope * delta(i) <= 0.0);
        if turns(before(k)) || turns(after(k)) {
            *slope = 0.0;
        }
    }
    // Factors come from slopes not scaled yet, so the last two are kept aside.
    let factor = |slopes: &[f64], i: usize| scale(delta(i), slopes[i], slopes[i + 1]);
    let first = factor(slopes, 0);
    let last = factor(slopes, n - 1);
    let mut behind = if periodic { last } else { 1.0 };
    for k in 0..n {
        let ahead = factor(slopes, k);
        slopes[k] *= behind.min(ahead);
        behind = ahead;
    }
    slopes[n] *= behind.min(if periodic { first } else { 1.0 });
}

/// One interval's cubic in φ ∈ [0, 1], lowest power first: from `value` up by `rise` over `step`.
#[must_use]
pub fn cubic(value: f64, rise: f64, step: f64, left: f64, right: f64) -> [f64; 4] {
    let (left, right) = (left * step, right * step);
    [
        value,
        left,
        3.0 * rise - 2.0 * left - right,
        left + right - 2.0 * rise,
    ]
}

/// The value of a cubic, lowest power first.
#[must_use]
pub const fn value(c: &[f64; 4], x: f64) -> f64 {
    ((c[3] * x + c[2]) * x + c[1]) * x + c[0]
}

/// The derivative of a cubic, lowest power first.
#[must_use]
pub const fn slope(c: &[f64; 4], x: f64) -> f64 {
    (3.0 * c[3] * x + 2.0 * c[2]) * x + c[1]
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn a_parabola_that_rises_is_met_exactly() {
        // Three-point slopes are exact for parabolas, and far from the limit here.
        let keys = [1.0, 1.5, 2.5, 3.0, 4.0];
        let steps: Vec<_> = keys.windows(2).map(|w| w[1] - w[0]).collect();
        let rises: Vec<_> = keys.windows(2).map(|w| w[1] * w[1] - w[0] * w[0]).collect();
        let mut found = [0.0; 5];
        slopes(&steps, &rises, false, &mut found);
        for (slope, key) in found.iter().zip(keys) {
            assert!((slope - 2.0 * key).abs() < 1e-14);
        }
    }

    proptest! {
        #[test]
        fn never_leaves_the_range_of_two_keys(
            steps in prop::collection::vec(0.01..100.0f64, 1..12),
            seed in prop::collection::vec(-1.0..1.0f64, 12),
            periodic: bool,
        ) {
            let n = steps.len();
            let rises: Vec<_> = (0..n).map(|i| if seed[i].abs() < 0.1 { 0.0 } else { seed[i] }).collect();
            let mut found = vec![0.0; n + 1];
            slopes(&steps, &rises, periodic, &mut found);
            for i in 0..n {
                let c = cubic(0.0, rises[i], steps[i], found[i], found[i + 1]);
                let (low, high) = (rises[i].min(0.0), rises[i].max(0.0));
                let mut last = 0.0;
                for k in 0..=100 {
                    let v = value(&c, f64::from(k) / 100.0);
                    prop_assert!(v >= low - 1e-12 && v <= high + 1e-12);
                    prop_assert!((v - last) * rises[i] >= -1e-12);
                    last = v;
                }
            }
            if periodic {
                prop_assert_eq!(found[0], found[n]);
            }
        }
    }
}
