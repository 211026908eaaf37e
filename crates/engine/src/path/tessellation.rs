//! Polylines to draw a curve with: the thesis's ternary `sample` (5.1.4) with a test of flatness
//! that bounds place, straightness and speed at once.
//!
//! A piece P(t), t in [t₁, t₃], is compared with L(t), which goes from end to end at even speed.
//! Their difference is 0 at both ends, so its values at the two thirds fix it. Where both are at
//! most e long, |P(t) − L(t)| ≤ e·max(|l₁|+|l₂|) for the Lagrange polynomials l₁ and l₂ of the
//! thirds, and that maximum, at t = (3 ± √3)/6, is 3√3/4 ≈ 1.299. Angles between the chords (5.1.3)
//! bound none of this: they call a straight piece flat on which the curve runs to and fro.

use glam::DVec3;

use super::hermite::Cubic;
use crate::error::{Invalid, Result};

/// 3√3/4: how much farther a piece may stray than at its thirds.
const STRAY: f64 = 1.299_038_105_676_658;

/// Ternary divisions at the most. Each makes the deviation at least ninefold smaller; ten reach a
/// 3·10⁹th of the first, more than any picture shows, with at most 59,049 pieces.
pub const MAX_DEPTH: u32 = 10;

/// Appends to `out` the parameters and points of a polyline along `curve`, in order and with both
/// ends, such that |P(t) − L(t)| ≤ `error` (in the units of the points) for every t in [0, 1],
/// where L runs evenly from point to point. This holds up to the rounding of the points, and as
/// long as [`MAX_DEPTH`] suffices. If memory runs out, `out` is left as it was.
///
/// # Errors
/// [`crate::Error::Argument`] if `error` is not positive and finite, or the curve not finite;
/// [`crate::Error::Memory`].
pub fn tessellate(curve: &Cubic, error: f64, out: &mut Vec<(f64, DVec3)>) -> Result<()> {
    if !(error > 0.0 && error.is_finite()) {
        return Err(Invalid::DrawnBound.into());
    }
    if ![curve.a, curve.b, curve.c, curve.d, curve.end]
        .iter()
        .all(|v| v.is_finite())
    {
        return Err(Invalid::DrawnNotFinite.into());
    }
    let before = out.len();
    let result = sample(curve, error / STRAY, (0.0, 1.0), MAX_DEPTH, out)
        .and_then(|()| push(curve, 1.0, out));
    if result.is_err() {
        out.truncate(before);
    }
    result
}

/// Appends the pieces of [t₁, t₃] without its end, divided at most `depth` times.
fn sample(
    curve: &Cubic,
    thirds: f64,
    (t1, t3): (f64, f64),
    depth: u32,
    out: &mut Vec<(f64, DVec3)>,
) -> Result<()> {
    if depth == 0 || is_flat(curve, thirds, t1, t3) {
        return push(curve, t1, out);
    }
    let third = (t3 - t1) / 3.0;
    let (t21, t22) = (t1 + third, t3 - third);
    sample(curve, thirds, (t1, t21), depth - 1, out)?;
    sample(curve, thirds, (t21, t22), depth - 1, out)?;
    sample(curve, thirds, (t22, t3), depth - 1, out)
}

fn push(curve: &Cubic, t: f64, out: &mut Vec<(f64, DVec3)>) -> Result<()> {
    out.try_reserve(1)?;
    out.push((t, curve.point(t)));
    Ok(())
}

/// Whether the curve and its even chord over [t₁, t₃] differ by at most `error` at both thirds.
/// With u from 0 to 1 over the piece, P − L is −u(1−u)·(B + A(1+u)), A and B being the piece's
/// coefficients of u³ and u²: whatever the size of the coordinates, and 0 for a piece of length 0.
fn is_flat(curve: &Cubic, error: f64, t1: f64, t3: f64) -> bool {
    let h = t3 - t1;
    let a = curve.a * (h * h * h);
    let b = (curve.a * (3.0 * t1) + curve.b) * (h * h);
    let d1 = (b + a * (4.0 / 3.0)).length() * (2.0 / 9.0);
    let d2 = (b + a * (5.0 / 3.0)).length() * (2.0 / 9.0);
    d1 <= error && d2 <= error
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::path::test_support::vector;

    fn polyline(curve: &Cubic, error: f64) -> Vec<(f64, DVec3)> {
        let mut out = Vec::new();
        tessellate(curve, error, &mut out).unwrap();
        out
    }

    /// The largest distance between the curve and its polyline at the same t,
    /// densely sampled, and everything else that is promised.
    fn largest_error(curve: &Cubic, list: &[(f64, DVec3)]) -> f64 {
        assert_eq!(list[0], (0.0, curve.point(0.0)));
        assert_eq!(list[list.len() - 1], (1.0, curve.end));
        let mut worst = 0.0f64;
        for pair in list.windows(2) {
            let ((t1, p1), (t3, p3)) = (pair[0], pair[1]);
            assert!(t1 < t3);
            assert_eq!(p1, curve.point(t1));
            for k in 1..64 {
                let u = f64::from(k) / 64.0;
                let on_curve = curve.point(t1 + (t3 - t1) * u);
                worst = worst.max((on_curve - p1.lerp(p3, u)).length());
            }
        }
        worst
    }

    fn assert_bounded(curve: &Cubic, error: f64) -> usize {
        let list = polyline(curve, error);
        let worst = largest_error(curve, &list);
        let rounding = 1e-14
            * curve
                .control_points()
                .map(DVec3::length)
                .into_iter()
                .sum::<f64>();
        assert!(worst <= error + rounding, "{worst} > {error} for {curve:?}");
        list.len() - 1
    }

    fn line(x: [f64; 4]) -> Cubic {
        let direction = DVec3::new(2.0, -1.0, 0.5);
        Cubic::bezier(x.map(|x| direction * x + DVec3::ONE))
    }

    #[test]
    fn the_constant_is_the_maximum_that_it_should_be() {
        let stray = |t: f64| {
            let l1 = 13.5 * t * (1.0 - t) * (2.0 / 3.0 - t);
            let l2 = 13.5 * t * (1.0 - t) * (t - 1.0 / 3.0);
            l1.abs() + l2.abs()
        };
        let sampled = (0..=100_000).map(|i| stray(f64::from(i) / 1e5));
        let largest = sampled.fold(0.0, f64::max);
        assert!((largest - STRAY).abs() < 1e-8 && largest <= STRAY + 1e-15);
        assert!((STRAY - 3.0 * 3.0f64.sqrt() / 4.0).abs() < 1e-15);
    }

    #[test]
    fn straight_and_even_needs_one_piece() {
        assert_eq!(polyline(&line([0.0, 1.0, 2.0, 3.0]), 1e-12).len(), 2);
        let still = line([1.0; 4]);
        assert_eq!(polyline(&still, 1e-12).len(), 2);
    }

    #[test]
    fn degenerate_curves_keep_the_bound() {
        let curves = [
            // Straight but uneven; the polyline must keep the speed too.
            line([0.0, 0.0, 1.0, 1.0]),
            // There and back again, the ends together.
            line([0.0, 3.0, 3.0, 0.0]),
            // Overshoot beyond both ends.
            line([0.0, 4.0, -3.0, 1.0]),
            // Back and forth with a zero chord: P(0) = P(1), P(1/2) too.
            line([0.0, 1.0, -1.0, 0.0]),
            // A cusp in the middle.
            Cubic::bezier([
                DVec3::ZERO,
                DVec3::new(1.0, 1.0, 0.0),
                DVec3::new(0.0, 1.0, 0.0),
                DVec3::new(1.0, 0.0, 0.0),
            ]),
            // A loop that ends where it starts.
            Cubic::bezier([
                DVec3::ZERO,
                DVec3::new(3.0, 2.0, 1.0),
                DVec3::Y * 4.0,
                DVec3::ZERO,
            ]),
            // An S through its chord's middle: a test there sees nothing.
            Cubic::hermite(
                DVec3::ZERO,
                DVec3::X,
                DVec3::new(1.0, 4.0, 0.0),
                DVec3::new(1.0, 4.0, 0.0),
            ),
        ];
        for curve in curves {
            for error in [0.3, 1e-2, 1e-4, 1e-7] {
                let pieces = assert_bounded(&curve, error);
                assert!(pieces > 1 || error > 1e-2, "{pieces} piece for {curve:?}");
            }
        }
        let s = &curves[6];
        assert!(s.point(0.5).abs_diff_eq(DVec3::X / 2.0, 1e-15));
    }

    #[test]
    fn it_ends_where_the_bound_cannot_be_reached() {
        let curve = line([0.0, 4e8, -3e8, 1e8]);
        let list = polyline(&curve, 1e-300);
        assert_eq!(list.len(), 3usize.pow(MAX_DEPTH) + 1);
        assert!(list.windows(2).all(|pair| pair[0].0 < pair[1].0));
        // Coordinates that round coarser than the bound cost no more pieces.
        let near = Cubic::bezier([DVec3::ZERO, DVec3::Y, DVec3::X, DVec3::ONE]);
        let far = Cubic {
            d: near.d + 1e9,
            end: near.end + 1e9,
            ..near
        };
        assert_eq!(polyline(&near, 1e-6).len(), polyline(&far, 1e-6).len());
    }

    #[test]
    fn the_list_is_continued_and_bad_bounds_are_refused() {
        let curve = line([0.0, 0.0, 1.0, 1.0]);
        let mut out = vec![(7.0, DVec3::X)];
        tessellate(&curve, 0.01, &mut out).unwrap();
        assert_eq!(out[0], (7.0, DVec3::X));
        assert_eq!(out[1..], polyline(&curve, 0.01));
        for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert!(tessellate(&curve, bad, &mut out).is_err());
        }
        let bad = Cubic {
            a: DVec3::NAN,
            ..curve
        };
        assert!(tessellate(&bad, 0.01, &mut out).is_err());
    }

    proptest! {
        #[test]
        fn random_curves_keep_the_bound_with_few_pieces(
            g in prop::array::uniform4(vector(1.0)), exponent in -6.0..0.0f64,
        ) {
            let (curve, error) = (Cubic::bezier(g), 10f64.powf(exponent));
            let pieces = assert_bounded(&curve, error);
            // An even division needs √(|P″|/(8·error)) pieces at the most; a
            // ternary one may be three times as fine and a little more.
            let bend = curve.second_derivative(0.0).length()
                .max(curve.second_derivative(1.0).length());
            let even = (bend / (8.0 * error)).sqrt();
            prop_assert!(pieces as f64 <= 3.5 * even + 1.0, "{pieces} pieces, even {even}");
        }
    }
}
