//! Catmull–Rom splines (thesis 3.6.1), uniform knots: tangents parallel to the neighbours' chord.

use glam::DVec3;

use super::hermite::{BasisMatrix, Cubic};
use crate::error::{Invalid, Result, TooMany, vec_with_room};
use crate::limits::{MAX_POINTS, MIN_POINTS};

/// The basis matrix of 3.6.1, for G = (Pᵢ₋₁, Pᵢ, Pᵢ₊₁, Pᵢ₊₂) and the segment
/// from Pᵢ to Pᵢ₊₁. (The thesis prints half the Bézier matrix in its place.)
pub const CATMULL_ROM: BasisMatrix = [
    [-0.5, 1.5, -1.5, 0.5],
    [1.0, -2.5, 2.0, -0.5],
    [-0.5, 0.0, 0.5, 0.0],
    [0.0, 1.0, 0.0, 0.0],
];

/// The tangent at the ends of an open curve, which 3.6.1 leaves free. With two points all but
/// [`EndRule::Tangents`] give the straight line.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum EndRule {
    /// That of the parabola through the three points nearest to the end, (−3P₀+4P₁−P₂)/2.
    #[default]
    Quadratic,
    /// That with no curvature at the end, (3(P₁−P₀)−R₁)/2.
    Natural,
    /// The chord of the end segment, P₁−P₀.
    Chord,
    /// Given tangents at the start and at the end, both in the direction of the curve.
    Tangents(DVec3, DVec3),
}

/// The tangent at a point from its neighbours: (Pᵢ₊₁ − Pᵢ₋₁)/2.
#[must_use]
pub fn tangent(previous: DVec3, next: DVec3) -> DVec3 {
    (next - previous) / 2.0
}

/// The segment from `p[1]` to `p[2]` with the neighbours `p[0]` and `p[3]`.
#[must_use]
pub fn segment(p: [DVec3; 4]) -> Cubic {
    Cubic::hermite(p[1], p[2], tangent(p[0], p[2]), tangent(p[1], p[3]))
}

/// The open curve through `points`: one segment less than points.
///
/// # Errors
/// [`crate::Error::Argument`] for fewer than two points or anything that is not finite,
/// [`crate::Error::Limit`] for more than [`MAX_POINTS`], [`crate::Error::Memory`].
pub fn open_curve(points: &[DVec3], ends: EndRule) -> Result<Vec<Cubic>> {
    check(points)?;
    if let EndRule::Tangents(start, end) = ends
        && !(start.is_finite() && end.is_finite())
    {
        return Err(Invalid::EndTangent.into());
    }
    let last = points.len() - 1;
    let (start, end) = match ends {
        EndRule::Tangents(start, end) => (start, end),
        // The end is a start of the curve run backwards.
        rule => (
            end_tangent(rule, points.iter().copied()),
            -end_tangent(rule, points.iter().rev().copied()),
        ),
    };
    let at = |i: usize| match i {
        0 => start,
        i if i == last => end,
        i => tangent(points[i - 1], points[i + 1]),
    };
    let mut curve = vec_with_room(last)?;
    curve.extend((0..last).map(|i| Cubic::hermite(points[i], points[i + 1], at(i), at(i + 1))));
    Ok(curve)
}

/// The closed curve through `points`: as many segments as points.
///
/// # Errors
/// As [`open_curve`].
pub fn closed_curve(points: &[DVec3]) -> Result<Vec<Cubic>> {
    check(points)?;
    let n = points.len();
    let mut curve = vec_with_room(n)?;
    curve.extend((0..n).map(|i| segment([n - 1, 0, 1, 2].map(|k| points[(i + k) % n]))));
    Ok(curve)
}

fn check(points: &[DVec3]) -> Result<()> {
    if points.len() < MIN_POINTS {
        return Err(Invalid::CurveTooShort.into());
    }
    if points.len() > MAX_POINTS {
        return Err(TooMany::CurvePoints.into());
    }
    match points.iter().position(|point| !point.is_finite()) {
        Some(at) => Err(Invalid::PointNotFinite(at).into()),
        None => Ok(()),
    }
}

/// The tangent at the first of at least two points; no rule looks at more than three.
fn end_tangent(rule: EndRule, mut points: impl Iterator<Item = DVec3>) -> DVec3 {
    let mut next = || points.next();
    let (Some(p0), Some(p1)) = (next(), next()) else {
        return DVec3::ZERO;
    };
    let near = p1 - p0;
    match (rule, next()) {
        (EndRule::Quadratic, Some(p2)) => 1.5 * near - 0.5 * (p2 - p1),
        (EndRule::Natural, Some(p2)) => 1.5 * near - 0.5 * tangent(p0, p2),
        (EndRule::Tangents(start, _), _) => start,
        _ => near,
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::path::test_support::{assert_near, map, vector};

    fn points() -> impl Strategy<Value = Vec<DVec3>> {
        prop::collection::vec(vector(10.0), 2..9)
    }

    fn rule() -> impl Strategy<Value = EndRule> {
        prop_oneof![
            Just(EndRule::Quadratic),
            Just(EndRule::Natural),
            Just(EndRule::Chord),
            (vector(5.0), vector(5.0)).prop_map(|(a, b)| EndRule::Tangents(a, b)),
        ]
    }

    #[test]
    fn refuses_what_is_no_curve() {
        assert!(open_curve(&[DVec3::ZERO], EndRule::Quadratic).is_err());
        assert!(closed_curve(&[]).is_err());
        assert!(closed_curve(&[DVec3::ZERO, DVec3::NAN]).is_err());
        let two = [DVec3::ZERO, DVec3::X];
        assert!(open_curve(&two, EndRule::Tangents(DVec3::NAN, DVec3::X)).is_err());
        let many = vec![DVec3::ZERO; MAX_POINTS + 1];
        assert!(matches!(closed_curve(&many), Err(crate::Error::Limit(_))));
    }

    proptest! {
        #[test]
        fn passes_through_its_points_smoothly(points in points(), rule in rule()) {
            let curve = open_curve(&points, rule).unwrap();
            prop_assert_eq!(curve.len(), points.len() - 1);
            for (piece, ends) in curve.iter().zip(points.windows(2)) {
                prop_assert_eq!(piece.point(0.0), ends[0]);
                prop_assert_eq!(piece.point(1.0), ends[1]);
            }
            for pair in curve.windows(2) {
                assert_near(pair[0].derivative(1.0), pair[1].derivative(0.0), 1e-12);
            }
            for (i, piece) in curve.iter().enumerate().skip(1) {
                prop_assert_eq!(piece.derivative(0.0), (points[i + 1] - points[i - 1]) / 2.0);
            }
        }

        #[test]
        fn a_closed_curve_is_smooth_all_round(points in points()) {
            let curve = closed_curve(&points).unwrap();
            let n = points.len();
            for i in 0..n {
                let (piece, next) = (&curve[i], &curve[(i + 1) % n]);
                prop_assert_eq!(piece.point(0.0), points[i]);
                prop_assert_eq!(piece.point(1.0), next.point(0.0));
                assert_near(piece.derivative(1.0), next.derivative(0.0), 1e-12);
            }
        }

        #[test]
        fn the_matrix_gives_the_same_segment(
            g in prop::array::uniform4(vector(10.0)), t in 0.0..=1.0f64,
        ) {
            let matrix = Cubic::from_basis(&CATMULL_ROM, g);
            assert_near(matrix.point(t), segment(g).point(t), 1e-12);
        }

        #[test]
        fn the_end_rules_keep_their_promise(points in points()) {
            let last = points.len() - 2;
            let curve = open_curve(&points, EndRule::Natural).unwrap();
            assert_near(curve[0].second_derivative(0.0), DVec3::ZERO, 1e-11);
            assert_near(curve[last].second_derivative(1.0), DVec3::ZERO, 1e-11);
            let curve = open_curve(&points, EndRule::Chord).unwrap();
            assert_near(curve[0].derivative(0.0), points[1] - points[0], 1e-12);
            assert_near(curve[last].derivative(1.0), points[last + 1] - points[last], 1e-12);
            let tangents = (points[0], points[1]);
            let rule = EndRule::Tangents(tangents.0, tangents.1);
            let curve = open_curve(&points, rule).unwrap();
            assert_near(curve[0].derivative(0.0), tangents.0, 1e-12);
            assert_near(curve[last].derivative(1.0), tangents.1, 1e-12);
        }

        #[test]
        fn the_quadratic_ends_are_exact_on_a_parabola(
            g in prop::array::uniform3(vector(5.0)), n in 3..8usize, t in 0.0..=1.0f64,
        ) {
            let parabola = |t: f64| g[0] + g[1] * t + g[2] * (t * t);
            let points: Vec<_> = (0..n).map(|i| parabola(i as f64)).collect();
            for (i, piece) in open_curve(&points, EndRule::Quadratic).unwrap().iter().enumerate() {
                assert_near(piece.point(t), parabola(i as f64 + t), 1e-12);
            }
        }

        #[test]
        fn two_points_make_a_straight_line(
            p in prop::array::uniform2(vector(10.0)), t in 0.0..=1.0f64,
        ) {
            for rule in [EndRule::Quadratic, EndRule::Natural, EndRule::Chord] {
                let curve = open_curve(&p, rule).unwrap();
                assert_near(curve[0].point(t), p[0].lerp(p[1], t), 1e-12);
            }
        }

        #[test]
        fn moves_with_its_points(points in points(), t in 0.0..=1.0f64) {
            let moved: Vec<_> = points.iter().map(|&p| map(p)).collect();
            for rule in [EndRule::Quadratic, EndRule::Natural, EndRule::Chord] {
                let curve = open_curve(&points, rule).unwrap();
                for (piece, moved) in curve.iter().zip(open_curve(&moved, rule).unwrap()) {
                    assert_near(moved.point(t), map(piece.point(t)), 1e-12);
                }
            }
        }
    }
}
