//! Interpolation at the 16 Chebyshev nodes of the first kind (Trefethen,
//! *Approximation Theory and Approximation Practice*, ch. 3–4, 8).
//!
//! The coefficients of a function analytic around [−1, 1] fall geometrically: the last ones tell
//! the error of the fit. They fall faster than 2^k, so powers of x are as safe as the series.

use super::vector::Vector;

/// Nodes of a fit; its degree is one less.
pub(crate) const NODES: usize = 16;

/// Terms of a fit whose last ones amount to nothing.
pub(crate) const SHORT: usize = 12;

const HALF: usize = NODES / 2;

/// cos(mπ/32), m = 0…16.
const COSINES: [f64; 17] = [
    1.0,
    0.9951847266721969,
    0.9807852804032304,
    0.9569403357322088,
    0.9238795325112867,
    0.881921264348355,
    0.8314696123025452,
    0.773010453362737,
    std::f64::consts::FRAC_1_SQRT_2,
    0.6343932841636455,
    0.5555702330196022,
    0.47139673682599764,
    0.3826834323650898,
    0.2902846772544624,
    0.19509032201612828,
    0.0980171403295606,
    0.0,
];

/// cos(mπ/32) for any m.
const fn cosine(m: usize) -> f64 {
    match m % 64 {
        m @ 0..=16 => COSINES[m],
        m @ 17..=32 => -COSINES[32 - m],
        m @ 33..=48 => -COSINES[m - 32],
        m => COSINES[64 - m],
    }
}

/// The nodes, ascending: −cos((2j+1)π/32).
pub(crate) const POINTS: [f64; NODES] = {
    let mut points = [0.0; NODES];
    let mut j = 0;
    while j < NODES {
        points[j] = cosine(32 + 2 * j + 1);
        j += 1;
    }
    points
};

/// Half of the discrete cosine transform: `WEIGHTS[parity][j][i]` is what the value at node j (and,
/// up to its sign, at the node opposite) adds to coefficient 2i + parity.
const WEIGHTS: [[[f64; HALF]; HALF]; 2] = {
    let mut weights = [[[0.0; HALF]; HALF]; 2];
    let mut k = 0;
    while k < NODES {
        let scale = if k == 0 { 1.0 / 16.0 } else { 1.0 / 8.0 };
        let mut j = 0;
        while j < HALF {
            // T_k(x_j) with x_j = cos(π − (2j+1)π/32).
            weights[k % 2][j][k / 2] = scale * cosine(k * (32 - (2 * j + 1)));
            j += 1;
        }
        k += 1;
    }
    weights
};

/// Powers of x in the Chebyshev polynomials: `POWERS[parity][k][j]` is the
/// coefficient of x^(2j + parity) in T_(2k + parity). Whole numbers, exact.
const POWERS: [[[f64; HALF]; HALF]; 2] = {
    let mut all = [[0.0; NODES]; NODES];
    all[0][0] = 1.0;
    all[1][1] = 1.0;
    let mut k = 2;
    while k < NODES {
        let mut j = 0;
        while j < NODES {
            let up = if j > 0 { 2.0 * all[k - 1][j - 1] } else { 0.0 };
            all[k][j] = up - all[k - 2][j];
            j += 1;
        }
        k += 1;
    }
    let mut powers = [[[0.0; HALF]; HALF]; 2];
    let mut k = 0;
    while k < NODES {
        let mut j = k % 2;
        while j < NODES {
            powers[k % 2][k / 2][j / 2] = all[k][j];
            j += 2;
        }
        k += 1;
    }
    powers
};

/// Sum of the rows of a matrix, each times a factor.
#[inline(always)]
fn combine<V: Vector>(factors: &[f64; HALF], rows: &[[f64; HALF]; HALF]) -> [f64; HALF] {
    let mut sums = [0.0; HALF];
    for k in (0..HALF).step_by(V::LANES) {
        let mut sum = V::splat(0.0);
        for j in 0..HALF {
            sum = V::splat(factors[j]).mul_add(V::load(&rows[j][k..]), sum);
        }
        sum.store(&mut sums[k..]);
    }
    sums
}

#[inline(always)]
fn weave(even: &[f64; HALF], odd: &[f64; HALF]) -> [f64; NODES] {
    let mut woven = [0.0; NODES];
    for k in 0..HALF {
        woven[2 * k] = even[k];
        woven[2 * k + 1] = odd[k];
    }
    woven
}

/// The Chebyshev series through the values at [`POINTS`].
#[inline(always)]
#[must_use]
pub(crate) fn series<V: Vector>(values: &[f64; NODES]) -> [f64; NODES] {
    let (mut sums, mut differences) = ([0.0; HALF], [0.0; HALF]);
    for j in 0..HALF {
        sums[j] = values[j] + values[NODES - 1 - j];
        differences[j] = values[j] - values[NODES - 1 - j];
    }
    weave(
        &combine::<V>(&sums, &WEIGHTS[0]),
        &combine::<V>(&differences, &WEIGHTS[1]),
    )
}

/// Error of the fit, within a small factor; an even or odd function lacks every other coefficient.
#[inline(always)]
#[must_use]
pub(crate) fn tail(series: &[f64; NODES]) -> f64 {
    series[NODES - 1].abs().max(series[NODES - 2].abs())
}

/// Leaves out the terms beyond [`SHORT`] where they amount to no more than `tolerance`.
#[inline(always)]
pub(crate) fn shorten(series: &mut [f64; NODES], tolerance: f64) {
    let beyond = &mut series[SHORT..];
    if beyond.iter().fold(0.0, |sum, term| sum + term.abs()) <= tolerance {
        beyond.fill(0.0);
    }
}

/// The same polynomial in powers of x, lowest first.
#[inline(always)]
#[must_use]
pub(crate) fn powers<V: Vector>(series: &[f64; NODES]) -> [f64; NODES] {
    let (mut even, mut odd) = ([0.0; HALF], [0.0; HALF]);
    for k in 0..HALF {
        even[k] = series[2 * k];
        odd[k] = series[2 * k + 1];
    }
    weave(
        &combine::<V>(&even, &POWERS[0]),
        &combine::<V>(&odd, &POWERS[1]),
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::vector::horner;

    #[test]
    fn the_nodes_are_the_zeros_of_the_sixteenth_polynomial() {
        for x in POINTS {
            assert!((16.0 * x.acos()).cos().abs() < 1e-14);
        }
        assert!(POINTS.windows(2).all(|pair| pair[0] < pair[1]));
    }

    #[test]
    fn an_entire_function_is_met_to_rounding() {
        let values = POINTS.map(|x| (1.3 * x + 0.2).exp());
        let series = series::<f64>(&values);
        assert!(tail(&series) < 1e-13);
        let powers = powers::<f64>(&series);
        for i in 0..=1000 {
            let x = f64::from(i) / 500.0 - 1.0;
            let exact = (1.3 * x + 0.2).exp();
            assert!((horner::<f64, NODES>(&powers, x) - exact).abs() < 4e-15 * 5.0);
        }
    }

    #[test]
    fn every_chebyshev_polynomial_has_one_coefficient() {
        for k in 0..NODES {
            let values = POINTS.map(|x| (k as f64 * x.acos()).cos());
            for (j, coefficient) in series::<f64>(&values).into_iter().enumerate() {
                let expected = if j == k { 1.0 } else { 0.0 };
                assert!((coefficient - expected).abs() < 1e-14, "{k} {j}");
            }
        }
    }
}
