//! Kochanek–Bartels splines (thesis 3.6.2; Kochanek and Bartels 1984), quadratic ends. The sign of
//! the bias is the 1984 paper's. Knots are uniform, as there, or centripetal or chordal (Yuksel,
//! Schaefer and Keyser, Computer-Aided Design 43, 2011).

use glam::DVec3;

use super::camera_path::{CameraPath, CurveKind, Tcb};
use super::hermite::BasisMatrix;

/// The tangent with which the curve leaves a point (R1 of 3.6.2), from the chords to and from it.
#[must_use]
pub fn outgoing_tangent(tcb: Tcb, before: DVec3, after: DVec3) -> DVec3 {
    let Tcb {
        tension,
        continuity,
        bias,
    } = tcb;
    let loose = (1.0 - tension) / 2.0;
    loose * (1.0 + continuity) * (1.0 + bias) * before
        + loose * (1.0 - continuity) * (1.0 - bias) * after
}

/// The tangent with which the curve reaches a point (R2 of 3.6.2).
#[must_use]
pub fn incoming_tangent(tcb: Tcb, before: DVec3, after: DVec3) -> DVec3 {
    let continuity = -tcb.continuity;
    outgoing_tangent(Tcb { continuity, ..tcb }, before, after)
}

/// M_KB of 3.6.2, for G = (Pᵢ₋₁, Pᵢ, Pᵢ₊₁, Pᵢ₊₂) and the segment from Pᵢ, whose
/// values are `from`, to Pᵢ₊₁, whose values are `to`.
#[must_use]
pub fn basis(from: Tcb, to: Tcb) -> BasisMatrix {
    let (loose_from, loose_to) = ((1.0 - from.tension) / 2.0, (1.0 - to.tension) / 2.0);
    let k = loose_from * (1.0 + from.continuity) * (1.0 + from.bias);
    let l = loose_from * (1.0 - from.continuity) * (1.0 - from.bias);
    let m = loose_to * (1.0 - to.continuity) * (1.0 + to.bias);
    let n = loose_to * (1.0 + to.continuity) * (1.0 - to.bias);
    [
        [-k, 2.0 + k - l - m, -2.0 + l + m - n, n],
        [
            2.0 * k,
            -3.0 - 2.0 * k + 2.0 * l + m,
            3.0 - 2.0 * l - m + n,
            -n,
        ],
        [-k, k - l, l, 0.0],
        [0.0, 1.0, 0.0, 0.0],
    ]
}

/// The tangent of the parabola through the three points nearest to an end, loosened by the tension;
/// of uniform knots (−3P₀+4P₁−P₂)/2. `near` and `far` are P₁−P₀ and P₂−P₁; at the end Pₙ−Pₙ₋₁,
/// Pₙ₋₁−Pₙ₋₂.
fn end_tangent(kind: CurveKind, tension: f64, near: DVec3, far: DVec3) -> DVec3 {
    let [here, there] = [near, far].map(|chord| step(kind, chord));
    let (own, other) = (
        here / (here + there),
        here * here / ((here + there) * there),
    );
    if there > 0.0 {
        (1.0 - tension) * ((1.0 + own) * near - other * far)
    } else {
        (1.0 - tension) * near
    }
}

/// From the knot of one point to that of the next.
fn step(kind: CurveKind, chord: DVec3) -> f64 {
    match kind {
        CurveKind::Centripetal => chord.length().sqrt(),
        CurveKind::Chordal => chord.length(),
        _ => 1.0,
    }
}

/// A segment's own chord and its neighbour's, each times its share of a tangent per parameter of
/// the segment: of three-point slopes, or 1 and 1 between uniform knots.
fn weighted(kind: CurveKind, own: DVec3, beside: DVec3) -> [DVec3; 2] {
    let [here, there] = [own, beside].map(|chord| step(kind, chord));
    if !(there > 0.0) {
        return [DVec3::ZERO; 2];
    }
    let share = 2.0 / (here + there);
    [share * there * own, share * here * here / there * beside]
}

/// The tangents at the start and the end of a segment, whatever tangents the points may own.
///
/// # Panics
/// If there is no such segment.
#[must_use]
pub fn tangents(path: &CameraPath, segment: usize) -> (DVec3, DVec3) {
    let (n, kind) = (path.points.len(), path.curve);
    let (i, j) = (segment, (segment + 1) % n);
    let at = |k: usize| path.points[k].position;
    let chord = at(j) - at(i);
    let (from, to) = (path.tcb(i), path.tcb(j));
    let before = if i > 0 {
        Some(at(i) - at(i - 1))
    } else if path.closed {
        Some(at(0) - at(n - 1))
    } else {
        None
    };
    let after = if j + 1 < n {
        Some(at(j + 1) - at(j))
    } else if path.closed {
        Some(at((j + 1) % n) - at(j))
    } else {
        None
    };
    let leave = match (before, after) {
        (Some(before), _) => {
            let [own, beside] = weighted(kind, chord, before);
            outgoing_tangent(from, beside, own)
        }
        (None, Some(after)) => end_tangent(kind, from.tension, chord, after),
        (None, None) => (1.0 - from.tension) * chord,
    };
    let reach = match (after, before) {
        (Some(after), _) => {
            let [own, beside] = weighted(kind, chord, after);
            incoming_tangent(to, own, beside)
        }
        (None, Some(before)) => end_tangent(kind, to.tension, chord, before),
        (None, None) => (1.0 - to.tension) * chord,
    };
    (leave, reach)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::path::camera_path::{CurveParameters, SupportPoint};
    use crate::path::catmull_rom::{CATMULL_ROM, EndRule, closed_curve, open_curve};
    use crate::path::curve::segment;
    use crate::path::hermite::Cubic;
    use crate::path::test_support::{assert_near, map, vector};

    fn tcb() -> impl Strategy<Value = Tcb> {
        prop::array::uniform3(-1.0..=1.0f64).prop_map(|[t, c, b]| Tcb::new(t, c, b))
    }

    fn keys() -> impl Strategy<Value = Vec<(DVec3, Tcb)>> {
        prop::collection::vec((vector(10.0), tcb()), 2..8)
    }

    fn curve(keys: &[(DVec3, Tcb)], closed: bool) -> Vec<Cubic> {
        let point = |&(position, tcb): &(DVec3, Tcb)| SupportPoint {
            curve: CurveParameters::Own(tcb),
            ..SupportPoint::new(position)
        };
        let path = CameraPath {
            points: keys.iter().map(point).collect(),
            closed,
            ..CameraPath::default()
        };
        let segments = keys.len() - usize::from(!closed);
        (0..segments).map(|i| segment(&path, i)).collect()
    }

    fn with(keys: &[(DVec3, Tcb)], tcb: Tcb) -> Vec<(DVec3, Tcb)> {
        keys.iter().map(|&(p, _)| (p, tcb)).collect()
    }

    fn positions(keys: &[(DVec3, Tcb)]) -> Vec<DVec3> {
        keys.iter().map(|&(p, _)| p).collect()
    }

    #[test]
    fn the_matrix_without_shaping_is_that_of_catmull_and_rom() {
        assert_eq!(basis(Tcb::default(), Tcb::default()), CATMULL_ROM);
    }

    fn of_kind(kind: CurveKind, points: &[DVec3]) -> Vec<Cubic> {
        let path = CameraPath {
            points: points.iter().map(|&at| SupportPoint::new(at)).collect(),
            curve: kind,
            ..CameraPath::default()
        };
        (0..path.segment_count())
            .map(|i| segment(&path, i))
            .collect()
    }

    /// Barry and Goldman's pyramid (SIGGRAPH 1988): the curve through the middle two of four points
    /// at these knots.
    fn pyramid(points: &[DVec3], knots: [f64; 4], at: f64) -> DVec3 {
        let mix = |a: DVec3, b: DVec3, from: f64, to: f64| {
            a * ((to - at) / (to - from)) + b * ((at - from) / (to - from))
        };
        let [k0, k1, k2, k3] = knots;
        let a = mix(points[0], points[1], k0, k1);
        let b = mix(points[1], points[2], k1, k2);
        let c = mix(points[2], points[3], k2, k3);
        mix(mix(a, b, k0, k2), mix(b, c, k1, k3), k1, k2)
    }

    const SPACED: [(CurveKind, f64); 2] =
        [(CurveKind::Centripetal, 0.5), (CurveKind::Chordal, 1.0)];

    #[test]
    fn close_points_do_not_turn_the_camera_back() {
        let line = [0.0, 10.0, 10.5, 40.0, 50.0].map(|x| DVec3::new(x, 0.0, 0.0));
        let back = |kind: CurveKind| {
            let curve = of_kind(kind, &line);
            let slopes = curve
                .iter()
                .flat_map(|c| (0..=50).map(|k| c.derivative(f64::from(k) / 50.0).x));
            slopes.fold(f64::INFINITY, f64::min)
        };
        assert!(back(CurveKind::Tcb) < -1.0);
        for (kind, _) in SPACED {
            assert!(back(kind) > 0.0, "{kind:?}");
        }
    }

    #[test]
    fn equal_points_are_no_trouble() {
        let (a, b) = (DVec3::ZERO, DVec3::new(1.0, 2.0, 0.0));
        for (kind, _) in SPACED {
            for points in [[a, a, b, b], [a, b, b, a], [b, a, a, a], [a, a, a, a]] {
                for piece in of_kind(kind, &points) {
                    assert!(piece.point(0.3).is_finite() && piece.derivative(0.6).is_finite());
                }
            }
        }
    }

    proptest! {
        /// Without shaping they are Catmull and Rom's over these knots.
        #[test]
        fn spaced_knots_are_those_of_the_pyramid(
            points in prop::collection::vec(vector(10.0), 4..8), t in 0.0..=1.0f64,
        ) {
            for (kind, power) in SPACED {
                let pieces = of_kind(kind, &points);
                for (i, four) in points.windows(4).enumerate() {
                    let mut knots = [0.0; 4];
                    for k in 0..3 {
                        knots[k + 1] = knots[k] + four[k].distance(four[k + 1]).powf(power);
                    }
                    let want = pyramid(four, knots, knots[1] + t * (knots[2] - knots[1]));
                    assert_near(pieces[i + 1].point(t), want, 1e-9);
                }
            }
        }

        /// What Yuksel, Schaefer and Keyser prove: no segment has a cusp or meets itself.
        #[test]
        fn centripetal_segments_have_no_loop(points in prop::collection::vec(vector(10.0), 4)) {
            // In the plane, and the middle two close.
            let flat = |p: DVec3| DVec3::new(p.x, p.y, 0.0);
            let near = points[1] + (points[2] - points[1]) * 0.02;
            let points = [points[0], points[1], near, points[3]].map(flat);
            let pieces = of_kind(CurveKind::Centripetal, &points);
            let piece = &pieces[1];
            let at: Vec<DVec3> = (0..=150).map(|k| piece.point(f64::from(k) / 150.0)).collect();
            let side = |a: DVec3, b: DVec3, c: DVec3| (b - a).cross(c - a).z.signum();
            for (i, one) in at.windows(2).enumerate() {
                for two in at[i + 2..].windows(2) {
                    let apart = |p: &[DVec3], q: &[DVec3]| side(p[0], p[1], q[0]) == side(p[0], p[1], q[1]);
                    prop_assert!(apart(one, two) || apart(two, one));
                }
            }
        }

        #[test]
        fn passes_through_the_points_whatever_the_shaping(keys in keys(), closed: bool) {
            for (i, piece) in curve(&keys, closed).iter().enumerate() {
                prop_assert_eq!(piece.point(0.0), keys[i].0);
                prop_assert_eq!(piece.point(1.0), keys[(i + 1) % keys.len()].0);
            }
        }

        #[test]
        fn the_matrix_gives_the_inner_segments(keys in keys(), t in 0.0..=1.0f64) {
            let pieces = curve(&keys, false);
            for (i, four) in keys.windows(4).enumerate() {
                let matrix = basis(four[1].1, four[2].1);
                let geometry = [four[0].0, four[1].0, four[2].0, four[3].0];
                let want = Cubic::from_basis(&matrix, geometry);
                assert_near(pieces[i + 1].point(t), want.point(t), 1e-12);
            }
        }

        /// The 1984 paper, section 2: without shaping, Catmull–Rom.
        #[test]
        fn without_shaping_it_is_catmull_rom(keys in keys(), t in 0.0..=1.0f64) {
            let plain = with(&keys, Tcb::default());
            let points = positions(&keys);
            let open = open_curve(&points, EndRule::Quadratic).unwrap();
            for (got, want) in curve(&plain, false).iter().zip(&open) {
                assert_near(got.point(t), want.point(t), 1e-12);
            }
            for (got, want) in curve(&plain, true).iter().zip(&closed_curve(&points).unwrap()) {
                assert_near(got.point(t), want.point(t), 1e-12);
            }
        }

        #[test]
        fn is_smooth_where_the_continuity_is_zero(
            mut keys in keys(), closed: bool,
        ) {
            for key in &mut keys {
                key.1.continuity = 0.0;
            }
            let pieces = curve(&keys, closed);
            let joints = if closed { pieces.len() } else { pieces.len() - 1 };
            for i in 0..joints {
                let next = &pieces[(i + 1) % pieces.len()];
                assert_near(pieces[i].derivative(1.0), next.derivative(0.0), 1e-12);
            }
        }

        /// c = −1: between two such points the curve is the straight line.
        #[test]
        fn negative_continuity_makes_straight_corners(keys in keys(), t in 0.0..=1.0f64) {
            let corners = with(&keys, Tcb::new(0.0, -1.0, 0.0));
            for (i, piece) in curve(&corners, true).iter().enumerate() {
                let (from, to) = (keys[i].0, keys[(i + 1) % keys.len()].0);
                assert_near(piece.point(t), from.lerp(to, t), 1e-12);
            }
        }

        #[test]
        fn full_tension_rests_at_the_points(keys in keys(), t in 0.0..=1.0f64) {
            let tight = with(&keys, Tcb::new(1.0, 0.3, -0.4));
            for (i, piece) in curve(&tight, false).iter().enumerate() {
                let (from, to) = (keys[i].0, keys[i + 1].0);
                assert_near(piece.point(t), from.lerp(to, t * t * (3.0 - 2.0 * t)), 1e-12);
            }
        }

        /// The sign of the bias: at 1 only the chord before counts.
        #[test]
        fn full_bias_follows_the_chord_before(keys in keys()) {
            let biased = with(&keys, Tcb::new(0.0, 0.0, 1.0));
            for (i, piece) in curve(&biased, false).iter().enumerate().skip(1) {
                assert_near(piece.derivative(0.0), keys[i].0 - keys[i - 1].0, 1e-12);
            }
        }

        #[test]
        fn the_ends_are_exact_on_a_parabola(
            g in prop::array::uniform3(vector(5.0)), n in 3..8usize, t in 0.0..=1.0f64,
        ) {
            let parabola = |t: f64| g[0] + g[1] * t + g[2] * (t * t);
            let keys: Vec<_> = (0..n).map(|i| (parabola(i as f64), Tcb::default())).collect();
            for (i, piece) in curve(&keys, false).iter().enumerate() {
                assert_near(piece.point(t), parabola(i as f64 + t), 1e-12);
            }
        }

        /// Of the three only the tension acts at an end.
        #[test]
        fn only_tension_shapes_the_ends(keys in keys(), own in tcb()) {
            let mut changed = keys.clone();
            let last = keys.len() - 1;
            for end in [0, last] {
                changed[end].1 = Tcb { tension: keys[end].1.tension, ..own };
            }
            let (before, after) = (curve(&keys, false), curve(&changed, false));
            prop_assert_eq!(before[0].derivative(0.0), after[0].derivative(0.0));
            prop_assert_eq!(before[last - 1].derivative(1.0), after[last - 1].derivative(1.0));
        }

        #[test]
        fn moves_with_its_points(keys in keys(), closed: bool, t in 0.0..=1.0f64) {
            let moved: Vec<_> = keys.iter().map(|&(p, tcb)| (map(p), tcb)).collect();
            for (got, want) in curve(&moved, closed).iter().zip(curve(&keys, closed)) {
                assert_near(got.point(t), map(want.point(t)), 1e-12);
            }
        }
    }
}
