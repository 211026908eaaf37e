//! The curve through the points of a path: cubics between tangents, which points may own.
//!
//! Cubic splines are solved where they are asked for: the influence of a point shrinks by 2 + √3
//! with each point between, and is below rounding beyond `REACH`.

use glam::DVec3;

use super::camera_path::{CameraPath, CurveKind};
use super::hermite::Cubic;
use super::kochanek_bartels;
use super::own::Tangents;

/// Points beyond which a point of a cubic spline is not felt: (2 − √3)³² is 5e-19.
const REACH: usize = 32;

/// The curve of one segment of a path.
///
/// # Panics
/// If there is no such segment.
#[must_use]
pub fn segment(path: &CameraPath, segment: usize) -> Cubic {
    let (i, j) = (segment, (segment + 1) % path.points.len());
    let (from, to) = (&path.points[i], &path.points[j]);
    let own = (from.tangents, to.tangents);
    let (leave, reach) = match own {
        (Some(from), Some(to)) => (from.after, to.before),
        _ => tangents_of_kind(path, segment),
    };
    let leave = own.0.map_or(leave, |own| own.after);
    let reach = own.1.map_or(reach, |own| own.before);
    Cubic::hermite(from.position, to.position, leave, reach)
}

/// The tangents at the start and the end of a segment, whatever tangents the points may own.
fn tangents_of_kind(path: &CameraPath, segment: usize) -> (DVec3, DVec3) {
    match path.curve {
        CurveKind::Tcb | CurveKind::Centripetal | CurveKind::Chordal => {
            kochanek_bartels::tangents(path, segment)
        }
        CurveKind::Cubic => spline_tangents(path, segment),
        CurveKind::Linear => {
            let to = path.points[(segment + 1) % path.points.len()].position;
            let chord = to - path.points[segment].position;
            (chord, chord)
        }
    }
}

/// The tangents with which the curve passes a point; at an end of an open path they are equal.
///
/// # Panics
/// If there is no such point.
#[must_use]
pub fn tangents(path: &CameraPath, point: usize) -> Tangents {
    if let Some(own) = path.points[point].tangents {
        return own;
    }
    let count = path.points.len();
    let before = match point {
        0 if path.closed => Some(count - 1),
        0 => None,
        point => Some(point - 1),
    };
    let after = (point < path.segment_count()).then_some(point);
    let before = before.map(|segment| tangents_of_kind(path, segment).1);
    let after = after.map(|segment| tangents_of_kind(path, segment).0);
    Tangents {
        before: before.or(after).unwrap_or_default(),
        after: after.or(before).unwrap_or_default(),
    }
}

/// One side of a point with the tangent m: the next tangent there is a − b·m.
#[derive(Clone, Copy)]
struct Side {
    a: DVec3,
    b: f64,
}

/// The next point on one side, around the ends of a closed path.
fn step(path: &CameraPath, point: usize, forwards: bool) -> Option<usize> {
    let count = path.points.len();
    if forwards {
        let next = point + 1;
        (next < count || path.closed).then_some(next % count)
    } else if point > 0 {
        Some(point - 1)
    } else {
        path.closed.then_some(count - 1)
    }
}

/// Elimination from far away towards `point`, over mᵢ₋₁ + 4mᵢ + mᵢ₊₁ = 3(Pᵢ₊₁ − Pᵢ₋₁); natural at
/// an end, 2m₀ + m₁ = 3(P₁ − P₀), and broken off where a point owns its tangents. `None` where
/// there is nothing on this side.
fn side(path: &CameraPath, point: usize, forwards: bool) -> Option<Side> {
    let at = |k: usize| path.points[k].position;
    let mut far = step(path, point, forwards)?;
    let mut steps = 1;
    let own = |k: usize| {
        path.points[k]
            .tangents
            .map(|own| if forwards { own.before } else { own.after })
    };
    while own(far).is_none() && steps < REACH {
        match step(path, far, forwards) {
            Some(next) => (far, steps) = (next, steps + 1),
            None => break,
        }
    }
    let near = |k: usize| step(path, k, !forwards).unwrap_or(point);
    let sign = if forwards { -1.0 } else { 1.0 };
    let mut known = if let Some(own) = own(far) {
        Side { a: own, b: 0.0 }
    } else {
        let chord = at(near(far)) - at(far);
        Side {
            a: 1.5 * sign * chord,
            b: 0.5,
        }
    };
    for _ in 1..steps {
        let here = near(far);
        let right = 3.0 * sign * (at(near(here)) - at(far));
        let share = 1.0 / (4.0 - known.b);
        known = Side {
            a: (right - known.a) * share,
            b: share,
        };
        far = here;
    }
    Some(known)
}

/// The tangent with which a cubic spline leaves or reaches a point: the one it owns, if it does.
fn spline_tangent(path: &CameraPath, point: usize, leaves: bool) -> DVec3 {
    if let Some(own) = path.points[point].tangents {
        return if leaves { own.after } else { own.before };
    }
    let at = |k: Option<usize>| path.points[k.unwrap_or(point)].position;
    let (next, last) = (step(path, point, true), step(path, point, false));
    match (side(path, point, false), side(path, point, true)) {
        (Some(before), Some(after)) => {
            let right = 3.0 * (at(next) - at(last)) - before.a - after.a;
            right / (4.0 - before.b - after.b)
        }
        // At an end, 2m₀ + m₁ = 3(P₁ − P₀), and its mirror image.
        (None, Some(side)) | (Some(side), None) => {
            (3.0 * (at(next) - at(last)) - side.a) / (2.0 - side.b)
        }
        (None, None) => DVec3::ZERO,
    }
}

/// The tangents of a cubic spline at the start and at the end of a segment.
fn spline_tangents(path: &CameraPath, segment: usize) -> (DVec3, DVec3) {
    let end = (segment + 1) % path.points.len();
    (
        spline_tangent(path, segment, true),
        spline_tangent(path, end, false),
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::path::cubic_spline::{CubicSpline, SplineEnds};
    use crate::path::test_support::Random;
    use crate::path::{CurveParameters, SupportPoint, Tcb};

    fn vector(random: &mut Random) -> DVec3 {
        DVec3::from_array(std::array::from_fn(|_| 2.0 * random.unit() - 1.0))
    }

    fn path(random: &mut Random, count: usize, curve: CurveKind) -> CameraPath {
        let tcb =
            |random: &mut Random| Tcb::new(2.0 * random.unit() - 1.0, random.unit(), random.unit());
        let points = (0..count).map(|_| SupportPoint {
            curve: CurveParameters::Own(tcb(random)),
            ..SupportPoint::new(vector(random))
        });
        CameraPath {
            points: points.collect(),
            curve,
            ..CameraPath::default()
        }
    }

    fn bits(path: &CameraPath) -> Vec<u64> {
        let coefficients = (0..path.segment_count()).flat_map(|k| {
            let c = segment(path, k);
            [c.a, c.b, c.c, c.d, c.end].map(|v| v.to_array())
        });
        coefficients.flatten().map(f64::to_bits).collect()
    }

    /// Against the equations of the second derivatives, solved as a whole.
    #[test]
    fn cubic_splines_are_those_of_the_moments() {
        let mut random = Random(31);
        for count in [2, 3, 4, 5, 9, 40, 90] {
            for closed in [false, true] {
                let mut path = path(&mut random, count, CurveKind::Cubic);
                path.closed = closed;
                let mut points: Vec<_> = path.points.iter().map(|p| p.position).collect();
                if closed {
                    points.push(points[0]);
                }
                let knots: Vec<_> = (0..points.len()).map(|k| k as f64).collect();
                let ends = if closed {
                    SplineEnds::Periodic
                } else {
                    SplineEnds::Natural
                };
                let whole = CubicSpline::new(&points, &knots, ends).unwrap();
                for (k, expected) in whole.pieces().iter().enumerate() {
                    let got = segment(&path, k);
                    for t in [0.0, 0.2, 0.5, 0.9, 1.0] {
                        assert!(
                            (got.point(t) - expected.point(t)).length() < 1e-14,
                            "{count} {closed} {k}"
                        );
                        assert!((got.derivative(t) - expected.derivative(t)).length() < 1e-13);
                    }
                }
            }
        }
    }

    #[test]
    fn own_tangents_clamp_a_cubic_spline() {
        let mut random = Random(32);
        let mut path = path(&mut random, 9, CurveKind::Cubic);
        let own = Tangents {
            before: vector(&mut random),
            after: vector(&mut random),
        };
        path.points[4].tangents = Some(own);
        path.points[8].tangents = Some(own);
        let points: Vec<_> = path.points.iter().map(|p| p.position).collect();
        let knots = [0.0, 1.0, 2.0, 3.0, 4.0];
        let whole = CubicSpline::new(
            &points[4..],
            &knots,
            SplineEnds::Clamped(own.after, own.before),
        )
        .unwrap();
        for (k, expected) in whole.pieces().iter().enumerate() {
            for t in [0.0, 0.3, 1.0] {
                assert!((segment(&path, 4 + k).point(t) - expected.point(t)).length() < 1e-14);
            }
        }
        for k in [0, 1, 2, 5, 6] {
            let (a, b) = (segment(&path, k), segment(&path, k + 1));
            assert!(
                (a.second_derivative(1.0) - b.second_derivative(0.0)).length() < 1e-12,
                "{k}"
            );
        }
    }

    #[test]
    fn tangents_that_a_point_has_change_no_bit() {
        let mut random = Random(33);
        for round in 0..3000 {
            let kind = CurveKind::ALL[round % CurveKind::ALL.len()];
            let count = 2 + round % 7;
            let mut path = path(&mut random, count, kind);
            path.closed = round % 2 == 0;
            let before = bits(&path);
            let at = (random.unit() * count as f64) as usize;
            // In a cubic spline the others are solved anew, to rounding.
            let exact = kind != CurveKind::Cubic;
            let all = (0..count).map(|at| tangents(&path, at)).collect::<Vec<_>>();
            path.points[at].tangents = Some(all[at]);
            if exact {
                assert_eq!(bits(&path), before, "{kind:?} {round}");
            }
            for (point, own) in path.points.iter_mut().zip(all) {
                point.tangents = Some(own);
            }
            assert_eq!(bits(&path), before, "{kind:?} {round}");
        }
    }

    #[test]
    fn straight_from_point_to_point() {
        let mut random = Random(34);
        let path = path(&mut random, 5, CurveKind::Linear);
        for k in 0..4 {
            let (a, b) = (path.points[k].position, path.points[k + 1].position);
            for t in [0.0, 0.25, 0.7, 1.0] {
                assert!((segment(&path, k).point(t) - a.lerp(b, t)).length() < 1e-15);
            }
        }
    }
}
