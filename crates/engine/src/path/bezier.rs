//! Bézier curves (thesis 3.5.2): cubics, and curves of any degree by de Casteljau's construction.

use glam::DVec3;

use super::hermite::{BasisMatrix, Cubic};
use crate::error::{Invalid, Result, TooMany, vec_with_room};
use crate::limits::MAX_BEZIER_POINTS;

/// M_B of 3.5.2, for G = the four control points.
pub const BEZIER: BasisMatrix = [
    [-1.0, 3.0, -3.0, 1.0],
    [3.0, -6.0, 3.0, 0.0],
    [-3.0, 3.0, 0.0, 0.0],
    [1.0, 0.0, 0.0, 0.0],
];

/// M_HB of 3.5.2: from the control points to the ends and end tangents, G_H = M_HB·G_B.
pub const HERMITE_FROM_BEZIER: BasisMatrix = [
    [1.0, 0.0, 0.0, 0.0],
    [0.0, 0.0, 0.0, 1.0],
    [-3.0, 3.0, 0.0, 0.0],
    [0.0, 0.0, -3.0, 3.0],
];

impl Cubic {
    /// The curve with these control points; exactly the first and the last at its ends.
    #[must_use]
    pub fn bezier(control: [DVec3; 4]) -> Self {
        let [p0, p1, p2, p3] = control;
        Self {
            a: (p3 - p0) + 3.0 * (p1 - p2),
            b: 3.0 * ((p0 - p1) + (p2 - p1)),
            c: 3.0 * (p1 - p0),
            d: p0,
            end: p3,
        }
    }

    /// The control points of this curve as a Bézier curve.
    #[must_use]
    pub fn control_points(&self) -> [DVec3; 4] {
        let second = self.d + self.c / 3.0;
        // P′(1) computed from the coefficients, so that the four belong to them.
        let third = self.end - (3.0 * self.a + 2.0 * self.b + self.c) / 3.0;
        [self.d, second, third, self.end]
    }
}

/// A Bézier curve of any degree: one less than its control points.
#[derive(Debug, Clone, PartialEq)]
pub struct Bezier {
    points: Vec<DVec3>,
}

impl Bezier {
    /// The curve with 1 to [`MAX_BEZIER_POINTS`] control points; with a single one it stays there.
    ///
    /// # Errors
    /// [`crate::Error::Argument`] for no point or one that is not finite, [`crate::Error::Limit`]
    /// for too many, [`crate::Error::Memory`].
    pub fn new(control: &[DVec3]) -> Result<Self> {
        if control.is_empty() {
            return Err(Invalid::NoControlPoint.into());
        }
        if control.len() > MAX_BEZIER_POINTS {
            return Err(TooMany::ControlPoints.into());
        }
        if let Some(at) = control.iter().position(|point| !point.is_finite()) {
            return Err(Invalid::ControlPointNotFinite(at).into());
        }
        let mut points = vec_with_room(control.len())?;
        points.extend_from_slice(control);
        Ok(Self { points })
    }

    /// The control points.
    #[must_use]
    pub fn control_points(&self) -> &[DVec3] {
        &self.points
    }

    /// One less than the number of control points.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.points.len() - 1
    }

    /// The point at `t`, exact at 0 and 1; outside [0, 1] rounding grows with the degree.
    #[must_use]
    pub fn point(&self, t: f64) -> DVec3 {
        let mut level = [DVec3::ZERO; MAX_BEZIER_POINTS];
        let level = &mut level[..self.points.len()];
        level.copy_from_slice(&self.points);
        reduce(level, t, 1);
        level[0]
    }

    /// The first derivative at `t`, from the two points before the last step of the construction.
    #[must_use]
    pub fn derivative(&self, t: f64) -> DVec3 {
        if self.degree() == 0 {
            return DVec3::ZERO;
        }
        let mut level = [DVec3::ZERO; MAX_BEZIER_POINTS];
        let level = &mut level[..self.points.len()];
        level.copy_from_slice(&self.points);
        reduce(level, t, 2);
        // At most MAX_BEZIER_POINTS, so exact.
        (level[1] - level[0]) * self.degree() as f64
    }

    /// The parts before and after `t`, each over [0, 1] again.
    ///
    /// # Errors
    /// [`crate::Error::Memory`].
    pub fn split(&self, t: f64) -> Result<(Self, Self)> {
        let mut before = vec_with_room(self.points.len())?;
        let mut after = vec_with_room(self.points.len())?;
        after.extend_from_slice(&self.points);
        for left in (1..=after.len()).rev() {
            before.push(after[0]);
            // The outer edges of the construction are the control points of the two parts.
            step(&mut after[..left], t);
        }
        Ok((Self { points: before }, Self { points: after }))
    }
}

/// Steps of the construction until `left` points are left.
fn reduce(level: &mut [DVec3], t: f64, left: usize) {
    for count in (left + 1..=level.len()).rev() {
        step(&mut level[..count], t);
    }
}

/// One step: each point moves by the share `t` to the next; the last stays.
fn step(level: &mut [DVec3], t: f64) {
    for i in 1..level.len() {
        level[i - 1] = level[i - 1] * (1.0 - t) + level[i] * t;
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::path::hermite::HERMITE;
    use crate::path::test_support::{assert_near, map, product, vector};

    /// The Bernstein form of 3.5.2, the binomials by recurrence.
    fn bernstein(points: &[DVec3], t: f64) -> DVec3 {
        let n = points.len() - 1;
        let mut binomial = 1.0;
        let mut sum = DVec3::ZERO;
        for (i, p) in points.iter().enumerate() {
            sum += *p * (binomial * t.powi(i as i32) * (1.0 - t).powi((n - i) as i32));
            binomial = binomial * (n - i) as f64 / (i + 1) as f64;
        }
        sum
    }

    fn control() -> impl Strategy<Value = Vec<DVec3>> {
        prop::collection::vec(vector(10.0), 1..14)
    }

    #[test]
    fn the_bezier_matrix_is_the_product_of_the_other_two() {
        assert_eq!(product(&HERMITE, &HERMITE_FROM_BEZIER), BEZIER);
    }

    #[test]
    fn the_degree_is_limited_and_bad_points_are_refused() {
        assert!(Bezier::new(&[]).is_err());
        assert!(Bezier::new(&[DVec3::ZERO; MAX_BEZIER_POINTS]).is_ok());
        let many = [DVec3::ZERO; MAX_BEZIER_POINTS + 1];
        assert!(matches!(Bezier::new(&many), Err(crate::Error::Limit(_))));
        let message = Bezier::new(&[DVec3::ZERO, DVec3::NAN])
            .unwrap_err()
            .to_string();
        assert!(message.contains("index 1"), "{message}");
    }

    #[test]
    fn a_point_stays_and_a_line_runs_evenly() {
        let p = DVec3::new(1.0, 2.0, 3.0);
        let point = Bezier::new(&[p]).unwrap();
        assert_eq!(point.point(0.3), p);
        assert_eq!(point.derivative(0.3), DVec3::ZERO);
        let line = Bezier::new(&[DVec3::ZERO, p * 4.0]).unwrap();
        assert_eq!(line.point(0.25), p);
        assert_eq!(line.derivative(0.25), p * 4.0);
    }

    #[test]
    fn the_highest_degree_stays_accurate() {
        // Control points on a line at equal steps give that line.
        let last = (MAX_BEZIER_POINTS - 1) as f64;
        let points: Vec<_> = (0..MAX_BEZIER_POINTS)
            .map(|i| DVec3::new(i as f64 / last, 1.0, -2.0))
            .collect();
        let curve = Bezier::new(&points).unwrap();
        for t in [0.0, 0.1, 0.5, 0.77, 1.0] {
            assert_near(curve.point(t), DVec3::new(t, 1.0, -2.0), 1e-13);
            assert_near(curve.derivative(t), DVec3::X, 1e-10);
        }
    }

    proptest! {
        #[test]
        fn is_the_bernstein_sum(points in control(), t in 0.0..=1.0f64) {
            let curve = Bezier::new(&points).unwrap();
            assert_near(curve.point(t), bernstein(&points, t), 1e-12);
            prop_assert_eq!(curve.point(0.0), points[0]);
            prop_assert_eq!(curve.point(1.0), points[points.len() - 1]);
        }

        /// The derivative is the curve of the differences, times the degree.
        #[test]
        fn its_derivative_is_the_curve_of_the_differences(points in control(), t in 0.0..=1.0f64) {
            prop_assume!(points.len() > 1);
            let n = (points.len() - 1) as f64;
            let differences: Vec<_> = points.windows(2).map(|w| (w[1] - w[0]) * n).collect();
            let curve = Bezier::new(&points).unwrap();
            assert_near(curve.derivative(t), bernstein(&differences, t), 1e-12);
        }

        #[test]
        fn its_parts_are_the_curve(points in control(), at in 0.0..=1.0f64, t in 0.0..=1.0f64) {
            let curve = Bezier::new(&points).unwrap();
            let (before, after) = curve.split(at).unwrap();
            prop_assert_eq!(before.degree(), curve.degree());
            prop_assert_eq!(after.degree(), curve.degree());
            assert_near(before.point(t), curve.point(at * t), 1e-12);
            assert_near(after.point(t), curve.point(at + (1.0 - at) * t), 1e-12);
            prop_assert_eq!(before.point(1.0), after.point(0.0));
        }

        #[test]
        fn stays_in_the_box_of_its_points_and_moves_with_them(
            points in control(), t in 0.0..=1.0f64,
        ) {
            let p = Bezier::new(&points).unwrap().point(t);
            let low = points.iter().copied().reduce(DVec3::min).unwrap() - 1e-12;
            let high = points.iter().copied().reduce(DVec3::max).unwrap() + 1e-12;
            prop_assert!(p.cmpge(low).all() && p.cmple(high).all());
            let moved: Vec<_> = points.iter().map(|&p| map(p)).collect();
            assert_near(Bezier::new(&moved).unwrap().point(t), map(p), 1e-12);
        }

        #[test]
        fn a_cubic_is_the_same_in_every_form(
            g in prop::array::uniform4(vector(10.0)), t in 0.0..=1.0f64,
        ) {
            let cubic = Cubic::bezier(g);
            let want = bernstein(&g, t);
            assert_near(cubic.point(t), want, 1e-12);
            assert_near(Cubic::from_basis(&BEZIER, g).point(t), want, 1e-12);
            let general = Bezier::new(&g).unwrap();
            assert_near(general.point(t), want, 1e-12);
            assert_near(cubic.derivative(t), general.derivative(t), 1e-12);
            let [p0, p1, p2, p3] = g;
            let ends = HERMITE_FROM_BEZIER.map(|m| p0 * m[0] + p1 * m[1] + p2 * m[2] + p3 * m[3]);
            let hermite = Cubic::hermite(ends[0], ends[1], ends[2], ends[3]);
            assert_near(hermite.point(t), want, 1e-12);
            for (got, want) in cubic.control_points().into_iter().zip(g) {
                assert_near(got, want, 1e-12);
            }
        }

        /// P₄ − P₃ = P₅ − P₄: the joint condition of 3.5.2 with k = 1.
        #[test]
        fn curves_join_smoothly_where_the_controls_mirror(
            g in prop::array::uniform4(vector(10.0)), rest in prop::array::uniform2(vector(10.0)),
        ) {
            let first = Cubic::bezier(g);
            let second = Cubic::bezier([g[3], 2.0 * g[3] - g[2], rest[0], rest[1]]);
            prop_assert_eq!(first.point(1.0), second.point(0.0));
            assert_near(first.derivative(1.0), second.derivative(0.0), 1e-12);
        }
    }
}
