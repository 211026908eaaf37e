//! Cubic splines with given knots (thesis 3.4), solved as a whole. A path's own spline
//! ([`super::CurveKind::Cubic`]) is solved around each segment instead, in [`super::curve`].

use glam::DVec3;

use super::hermite::Cubic;
use crate::error::{Invalid, OutOfRange, Result, TooMany, vec_with_room};
use crate::limits::{MAX_POINTS, MIN_POINTS};
use crate::math::tridiagonal::{Row, solve, solve_periodic};

/// The two conditions that the points leave free (3.4).
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SplineEnds {
    /// The second derivative vanishes at both ends.
    Natural,
    /// The first derivative by the parameter at the start and at the end.
    Clamped(DVec3, DVec3),
    /// First and second derivative agree at both ends, and the last point is the first.
    Periodic,
}

/// An interpolating cubic spline with given knots.
#[derive(Debug, Clone, PartialEq)]
pub struct CubicSpline {
    knots: Vec<f64>,
    pieces: Vec<Cubic>,
}

impl CubicSpline {
    /// The spline through `points[i]` at strictly rising `knots[i]`, in time linear in the points.
    ///
    /// # Errors
    /// [`crate::Error::Argument`] for fewer than two points, a different number of knots, anything
    /// not finite, knots that do not rise, or a periodic spline whose ends differ;
    /// [`crate::Error::Limit`] for more than [`MAX_POINTS`]; [`crate::Error::Range`] for knots too
    /// close together or too far apart to compute with; [`crate::Error::Memory`].
    pub fn new(points: &[DVec3], knots: &[f64], ends: SplineEnds) -> Result<Self> {
        check(points, knots, ends)?;
        let moments = moments(points, knots, ends)?;
        let mut pieces = vec_with_room(points.len() - 1)?;
        for i in 0..points.len() - 1 {
            let h = knots[i + 1] - knots[i];
            let (from, to) = (moments[i], moments[i + 1]);
            let chord = points[i + 1] - points[i];
            // Tangents over the piece's own parameter, 0 to 1.
            let leave = chord - (2.0 * from + to) * (h * h / 6.0);
            let reach = chord + (from + 2.0 * to) * (h * h / 6.0);
            let piece = Cubic::hermite(points[i], points[i + 1], leave, reach);
            if !(piece.a.is_finite() && piece.b.is_finite()) {
                return Err(OutOfRange::KnotDistance(i).into());
            }
            pieces.push(piece);
        }
        let mut kept = vec_with_room(knots.len())?;
        kept.extend_from_slice(knots);
        Ok(Self {
            knots: kept,
            pieces,
        })
    }

    /// The pieces in order, each over its own parameter from 0 to 1.
    #[must_use]
    pub fn pieces(&self) -> &[Cubic] {
        &self.pieces
    }

    /// The knots.
    #[must_use]
    pub fn knots(&self) -> &[f64] {
        &self.knots
    }

    /// The point at the parameter `x`, exact at the knots; outside them that at the nearer end.
    #[must_use]
    pub fn point(&self, x: f64) -> DVec3 {
        let (piece, t, _) = self.locate(x);
        piece.point(t)
    }

    /// The first derivative by the parameter.
    #[must_use]
    pub fn derivative(&self, x: f64) -> DVec3 {
        let (piece, t, h) = self.locate(x);
        piece.derivative(t) / h
    }

    /// The second derivative by the parameter.
    #[must_use]
    pub fn second_derivative(&self, x: f64) -> DVec3 {
        let (piece, t, h) = self.locate(x);
        piece.second_derivative(t) / h / h
    }

    fn locate(&self, x: f64) -> (&Cubic, f64, f64) {
        let inner = &self.knots[1..self.knots.len() - 1];
        let i = inner.partition_point(|&knot| knot <= x);
        let (from, to) = (self.knots[i], self.knots[i + 1]);
        let h = to - from;
        (&self.pieces[i], ((x - from) / h).clamp(0.0, 1.0), h)
    }
}

fn check(points: &[DVec3], knots: &[f64], ends: SplineEnds) -> Result<()> {
    if points.len() < MIN_POINTS {
        return Err(Invalid::SplineTooShort.into());
    }
    if points.len() > MAX_POINTS {
        return Err(TooMany::SplinePoints.into());
    }
    if points.len() != knots.len() {
        let (points, knots) = (points.len(), knots.len());
        return Err(Invalid::KnotCount { points, knots }.into());
    }
    if let Some(at) = points.iter().position(|point| !point.is_finite()) {
        return Err(Invalid::PointNotFinite(at).into());
    }
    if let Some(at) = knots.iter().position(|knot| !knot.is_finite()) {
        return Err(Invalid::KnotNotFinite(at).into());
    }
    if let Some(at) = knots.windows(2).position(|pair| pair[0] >= pair[1]) {
        return Err(Invalid::KnotOrder(at + 1).into());
    }
    match ends {
        SplineEnds::Clamped(start, end) if !(start.is_finite() && end.is_finite()) => {
            Err(Invalid::EndSlope.into())
        }
        SplineEnds::Periodic if points[0] != points[points.len() - 1] => {
            Err(Invalid::PeriodicEnds.into())
        }
        _ => Ok(()),
    }
}

/// The second derivatives at the knots: the solution of the equations of 3.4,
/// S″ⱼ₋₁·hⱼ/6 + S″ⱼ·(hⱼ+hⱼ₊₁)/3 + S″ⱼ₊₁·hⱼ₊₁/6 = (slope after − slope before).
fn moments(points: &[DVec3], knots: &[f64], ends: SplineEnds) -> Result<Vec<DVec3>> {
    let last = points.len() - 1;
    let h = |j: usize| knots[j + 1] - knots[j];
    let slope = |j: usize| (points[j + 1] - points[j]) / h(j);
    // Between pieces of lengths `before` and `after`, where the slope jumps.
    let row = |before: f64, after: f64, jump: DVec3| {
        Row::new([before / 6.0, (before + after) / 3.0, after / 6.0], jump)
    };
    let inner = (1..last).map(|j| row(h(j - 1), h(j), slope(j) - slope(j - 1)));
    let mut rows = vec_with_room(last + 1)?;
    let mut moments = vec_with_room(last + 1)?;
    match ends {
        SplineEnds::Natural => {
            rows.extend(inner);
            solve(&mut rows);
            moments.push(DVec3::ZERO);
            moments.extend(rows.iter().map(|row| row.right));
            moments.push(DVec3::ZERO);
        }
        SplineEnds::Clamped(start, end) => {
            rows.push(row(0.0, h(0), slope(0) - start));
            rows.extend(inner);
            rows.push(row(h(last - 1), 0.0, end - slope(last - 1)));
            solve(&mut rows);
            moments.extend(rows.iter().map(|row| row.right));
        }
        SplineEnds::Periodic => {
            rows.extend(inner);
            let joint = row(h(last - 1), h(0), slope(0) - slope(last - 1));
            let joint = solve_periodic(&mut rows, joint);
            moments.push(joint);
            moments.extend(rows.iter().map(|row| row.right));
            moments.push(joint);
        }
    }
    Ok(moments)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::path::test_support::{assert_near, map, vector};

    /// Points with rising knots whose distances differ up to twentyfold.
    fn data(least: usize) -> impl Strategy<Value = (Vec<DVec3>, Vec<f64>)> {
        prop::collection::vec((vector(10.0), 0.1..2.0f64), least..12).prop_map(|list| {
            let mut x = -3.0;
            let knots = list.iter().map(|(_, h)| {
                x += h;
                x
            });
            let knots = knots.collect();
            (list.iter().map(|(p, _)| *p).collect(), knots)
        })
    }

    fn all_ends(points: &[DVec3]) -> [SplineEnds; 2] {
        [
            SplineEnds::Natural,
            SplineEnds::Clamped(points[0] - points[1], points[1] * 0.5),
        ]
    }

    fn assert_twice_continuous(spline: &CubicSpline) {
        let knots = spline.knots();
        for (i, pair) in spline.pieces().windows(2).enumerate() {
            let (h, k) = (knots[i + 1] - knots[i], knots[i + 2] - knots[i + 1]);
            let first = pair[0].derivative(1.0) / h;
            assert_near(pair[1].derivative(0.0) / k, first, 1e-12);
            // Rounding of the coefficients counts by the shorter piece.
            let second = pair[0].second_derivative(1.0) / (h * h);
            let near = pair[1].second_derivative(0.0) / (k * k);
            assert_near(near, second, 1e-12 / h.min(k).powi(2));
        }
    }

    #[test]
    fn refuses_what_is_no_spline() {
        let (p, k) = ([DVec3::ZERO, DVec3::X, DVec3::Y], [0.0, 1.0, 3.0]);
        let new = CubicSpline::new;
        assert!(new(&p, &k, SplineEnds::Natural).is_ok());
        assert!(new(&p[..1], &k[..1], SplineEnds::Natural).is_err());
        assert!(new(&p, &k[..2], SplineEnds::Natural).is_err());
        assert!(new(&p, &[0.0, 1.0, 1.0], SplineEnds::Natural).is_err());
        assert!(new(&p, &[0.0, f64::NAN, 1.0], SplineEnds::Natural).is_err());
        assert!(new(&p, &[0.0, 1.0, f64::INFINITY], SplineEnds::Natural).is_err());
        assert!(new(&[DVec3::NAN, p[1], p[2]], &k, SplineEnds::Natural).is_err());
        assert!(new(&p, &k, SplineEnds::Periodic).is_err());
        assert!(new(&p, &k, SplineEnds::Clamped(DVec3::NAN, p[1])).is_err());
        let close = [0.0, 1e-320, 2e-320];
        let error = new(&p, &close, SplineEnds::Natural).unwrap_err();
        assert!(matches!(error, crate::Error::Range(_)), "{error}");
    }

    #[test]
    fn few_points_are_splines_too() {
        let p = [DVec3::ZERO, DVec3::new(2.0, 4.0, -6.0)];
        let line = CubicSpline::new(&p, &[1.0, 3.0], SplineEnds::Natural).unwrap();
        assert_near(line.point(1.5), p[1] / 4.0, 1e-15);
        assert_near(line.derivative(2.9), p[1] / 2.0, 1e-15);
        // Hermite's cubic with these ends.
        let ends = SplineEnds::Clamped(DVec3::Y, DVec3::Z);
        let one = CubicSpline::new(&p, &[1.0, 3.0], ends).unwrap();
        assert_near(one.derivative(1.0), DVec3::Y, 1e-14);
        assert_near(one.derivative(3.0), DVec3::Z, 1e-14);
        let still = [p[1], p[1]];
        let still = CubicSpline::new(&still, &[0.0, 1.0], SplineEnds::Periodic).unwrap();
        assert_eq!(still.point(0.3), p[1]);
        // There and back: the parts mirror each other.
        let back = [p[0], p[1], p[0]];
        let back = CubicSpline::new(&back, &[0.0, 1.0, 2.0], SplineEnds::Periodic).unwrap();
        assert_near(back.point(0.5), p[1] / 2.0, 1e-15);
        assert_near(back.derivative(1.0), DVec3::ZERO, 1e-14);
        assert_near(back.derivative(2.0), DVec3::ZERO, 1e-14);
    }

    #[test]
    fn outside_the_knots_the_ends_stay() {
        let p = [DVec3::ZERO, DVec3::X, DVec3::Y];
        let spline = CubicSpline::new(&p, &[0.0, 1.0, 3.0], SplineEnds::Natural).unwrap();
        assert_eq!(spline.point(-1.0), p[0]);
        assert_eq!(spline.point(3.1), p[2]);
        assert_eq!(spline.point(1.0), p[1]);
    }

    proptest! {
        #[test]
        fn passes_through_its_points_twice_continuously((points, knots) in data(2)) {
            for ends in all_ends(&points) {
                let spline = CubicSpline::new(&points, &knots, ends).unwrap();
                for (x, p) in knots.iter().zip(&points) {
                    prop_assert_eq!(spline.point(*x), *p);
                }
                assert_twice_continuous(&spline);
                let (first, last) = (knots[0], knots[knots.len() - 1]);
                match ends {
                    SplineEnds::Clamped(start, end) => {
                        assert_near(spline.derivative(first), start, 1e-11);
                        assert_near(spline.derivative(last), end, 1e-11);
                    }
                    _ => {
                        assert_near(spline.second_derivative(first), DVec3::ZERO, 1e-9);
                        assert_near(spline.second_derivative(last), DVec3::ZERO, 1e-9);
                    }
                }
            }
        }

        #[test]
        fn a_periodic_spline_is_continuous_at_its_joint((mut points, knots) in data(3)) {
            let last = points.len() - 1;
            points[last] = points[0];
            let spline = CubicSpline::new(&points, &knots, SplineEnds::Periodic).unwrap();
            assert_twice_continuous(&spline);
            let (a, b) = (knots[0], knots[last]);
            assert_near(spline.derivative(b), spline.derivative(a), 1e-11);
            assert_near(spline.second_derivative(b), spline.second_derivative(a), 1e-9);
        }

        /// With its own end slopes every cubic is its own spline.
        #[test]
        fn clamped_splines_are_exact_on_cubics(
            g in prop::array::uniform4(vector(2.0)), (_, knots) in data(2), t in 0.0..=1.0f64,
        ) {
            let cubic = |x: f64| ((g[0] * x + g[1]) * x + g[2]) * x + g[3];
            let slope = |x: f64| (3.0 * g[0] * x + 2.0 * g[1]) * x + g[2];
            let points: Vec<_> = knots.iter().map(|&x| cubic(x)).collect();
            let (first, last) = (knots[0], knots[knots.len() - 1]);
            let ends = SplineEnds::Clamped(slope(first), slope(last));
            let spline = CubicSpline::new(&points, &knots, ends).unwrap();
            let x = first + (last - first) * t;
            let size = points.iter().map(|p| p.length()).fold(1.0, f64::max);
            prop_assert!((spline.point(x) - cubic(x)).length() <= 1e-12 * size);
        }

        #[test]
        fn moves_with_its_points((points, knots) in data(2), t in 0.0..=1.0f64) {
            let moved: Vec<_> = points.iter().map(|&p| map(p)).collect();
            let spline = CubicSpline::new(&points, &knots, SplineEnds::Natural).unwrap();
            let other = CubicSpline::new(&moved, &knots, SplineEnds::Natural).unwrap();
            let x = knots[0] + (knots[knots.len() - 1] - knots[0]) * t;
            assert_near(other.point(x), map(spline.point(x)), 1e-12);
        }
    }
}
