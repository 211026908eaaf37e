use super::*;
use crate::path::test_support::Random;
use crate::path::{
    CurveKind, OrientationOverrides, Pose, Sampler, Timeline, UpPath, UpVector, curve,
};

fn path(random: &mut Random, absolute: bool) -> CameraPath {
    let mut vector = || DVec3::from_array(std::array::from_fn(|_| 2.0 * random.unit() - 1.0));
    let points = (0..5).map(|_| {
        let mut point = SupportPoint::new(vector());
        let target = vector();
        point.orientations[0] = Orientation {
            target: if absolute {
                Target::Absolute(target)
            } else {
                Target::Relative(target)
            },
            roll: 100.0 * vector().x,
            ..Orientation::default()
        };
        point.tangents = Some(Tangents {
            before: vector(),
            after: vector(),
        });
        point
    });
    CameraPath {
        points: points.collect(),
        ..CameraPath::default()
    }
}

fn changed(path: &CameraPath, changed: Changed) -> CameraPath {
    let mut new = path.clone();
    for (at, point) in changed {
        new.points[at] = point;
    }
    new
}

fn poses(path: &CameraPath) -> Vec<Pose> {
    let sampler = Sampler::new(path, &Timeline::new(path).unwrap()).unwrap();
    let mut poses = vec![Pose::default(); sampler.frame_count()];
    sampler.sample(1, &mut poses).unwrap();
    poses
}

/// All poses move as one body, since nothing in a path knows a direction but the
/// level of its rolls.
#[test]
fn a_whole_path_turns_as_one_body() {
    let mut random = Random(9);
    for number in 0..60 {
        let old = path(&mut random, number % 2 == 0);
        let axis = DVec3::new(random.unit(), random.unit(), random.unit()).normalize();
        let turn = DQuat::from_axis_angle(axis, 6.0 * random.unit());
        let matrix = DMat4::from_rotation_translation(turn, DVec3::new(1.0, -2.0, 0.5));
        let new = changed(
            &old,
            transform(&old, &[0, 1, 2, 3, 4], &matrix, true).unwrap(),
        );
        let (a, b) = (poses(&old), poses(&new));
        assert_eq!(a.len(), b.len());
        for (a, b) in a.iter().zip(&b) {
            let place = matrix.transform_point3(a.vrp.into()) - DVec3::from(b.vrp);
            let view = turn * DVec3::from(a.vpn) - DVec3::from(b.vpn);
            let up = turn * DVec3::from(a.vup) - DVec3::from(b.vup);
            assert!(place.length() < 1e-12);
            assert!(
                view.length() < 1e-9 && up.length() < 1e-9,
                "{number}: {view} {up}"
            );
        }
    }
}

/// Whatever up goes by, it goes along: what an orientation begins with is its roll's.
#[test]
fn a_path_turns_with_its_ups() {
    let mut random = Random(10);
    let turn = DQuat::from_axis_angle(DVec3::new(0.3, 0.5, -0.8).normalize(), 2.2);
    let matrix = DMat4::from_rotation_translation(turn, DVec3::new(1.0, -2.0, 0.5));
    let up_path = UpPath::of(&path(&mut random, false)).unwrap();
    for up in [
        UpVector::Point(DVec3::new(0.2, 4.0, 0.3)),
        UpVector::Path(up_path),
        UpVector::Minimal,
        UpVector::Frenet,
    ] {
        for ahead in [None, Some(0.0), Some(0.3)] {
            let mut old = path(&mut random, true);
            old.curve = CurveKind::Cubic;
            for point in &mut old.points {
                point.tangents = None;
                let own = &mut point.orientations[0].own;
                let change =
                    |own: &mut OrientationOverrides| (own.up, own.ahead) = (up.clone(), ahead);
                *own = own.with(change).unwrap();
            }
            let new = transform(&old, &[0, 1, 2, 3, 4], &matrix, true).unwrap();
            let new = changed(&old, new);
            for (a, b) in poses(&old).iter().zip(&poses(&new)) {
                let place = matrix.transform_point3(a.vrp.into()) - DVec3::from(b.vrp);
                let view = turn * DVec3::from(a.vpn) - DVec3::from(b.vpn);
                let far = turn * DVec3::from(a.vup) - DVec3::from(b.vup);
                assert!(place.length() < 1e-12 && view.length() < 1e-9);
                assert!(far.length() < 1e-7, "{} {ahead:?}: {far}", up.name());
            }
        }
    }
}

#[test]
fn a_mirrored_path_shows_mirrored_views() {
    let mut random = Random(10);
    let old = path(&mut random, true);
    let flip = DVec3::new(-1.0, 1.0, 1.0);
    let matrix = DMat4::from_scale(flip);
    let new = changed(
        &old,
        transform(&old, &[0, 1, 2, 3, 4], &matrix, true).unwrap(),
    );
    for (a, b) in poses(&old).iter().zip(&poses(&new)) {
        for (a, b) in [(a.vrp, b.vrp), (a.vpn, b.vpn), (a.vup, b.vup)] {
            assert!((flip * DVec3::from(a) - DVec3::from(b)).length() < 1e-10);
        }
    }
}

#[test]
fn only_what_is_picked_moves() {
    let mut random = Random(11);
    let old = path(&mut random, true);
    let by = DVec3::new(0.25, 0.5, -1.0);
    let moved = transform(&old, &[3, 1, 3], &DMat4::from_translation(by), false).unwrap();
    assert_eq!(moved.iter().map(|(at, _)| *at).collect::<Vec<_>>(), [1, 3]);
    for (at, point) in moved {
        assert_eq!(point.position, old.points[at].position + by);
        assert_eq!(point.orientations, old.points[at].orientations);
        assert_eq!(point.tangents, old.points[at].tangents);
    }
}

#[test]
fn what_does_not_do_is_refused() {
    let mut random = Random(12);
    let mut old = path(&mut random, true);
    let fine = DMat4::IDENTITY;
    let sheared = DMat4::from_cols_array(&[
        1.0, 0.0, 0.0, 0.0, 0.5, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0,
    ]);
    for matrix in [
        sheared,
        fine * 0.0,
        fine * 2.0,
        fine * f64::NAN,
        DMat4::from_scale(DVec3::X),
    ] {
        assert!(transform(&old, &[0], &matrix, false).is_err(), "{matrix}");
    }
    assert!(transform(&old, &[], &fine, false).is_err());
    assert!(transform(&old, &[5], &fine, false).is_err());
    // Onto its own target.
    let Target::Absolute(target) = old.points[0].orientations[0].target else {
        unreachable!()
    };
    old.points[0].position = DVec3::ZERO;
    let error = transform(&old, &[0], &DMat4::from_translation(target), false).unwrap_err();
    assert!(error.to_string().starts_with("point 1: "), "{error}");
    assert!(transform(&old, &[0], &DMat4::from_translation(target), true).is_ok());
    assert!(
        transform(
            &old,
            &[0],
            &DMat4::from_translation(DVec3::splat(2e9)),
            true
        )
        .is_err()
    );
}

#[test]
fn tangents_are_deformed_by_the_derivative() {
    let mut random = Random(13);
    let old = path(&mut random, false);
    let bounds = Bounds::new(DVec3::splat(-1.5), DVec3::splat(1.5)).unwrap();
    let all = [0, 1, 2, 3, 4];
    // A twist by angle·(w+1)/2 about z, its derivative by hand.
    let twist = Deformation::new("twist", &[2.0, 90.0]).unwrap();
    let new = changed(
        &old,
        deform(&old, &all, &twist, Some(bounds), false).unwrap(),
    );
    let rate = 90f64.to_radians() / 3.0;
    for (a, b) in old.points.iter().zip(&new.points) {
        let turn = DQuat::from_rotation_z(rate * (a.position.z + 1.5));
        let want = turn * a.position;
        assert!((b.position - want).length() < 1e-12);
        let tangent = a.tangents.unwrap().after;
        let spun = rate * tangent.z * DVec3::Z.cross(want);
        let got = b.tangents.unwrap().after;
        assert!((got - (turn * tangent + spun)).length() < 1e-9);
    }
    // The untouched lattice is the identity.
    let lattice = Deformation::new("free-form", &crate::deform::identity_lattice()).unwrap();
    let new = changed(
        &old,
        deform(&old, &all, &lattice, Some(bounds), true).unwrap(),
    );
    for segment in 0..4 {
        let (a, b) = (curve::segment(&old, segment), curve::segment(&new, segment));
        assert!((a.point(0.4) - b.point(0.4)).length() < 1e-11);
    }
}

/// Bernstein's polynomials of degree 3 of a coordinate in [-1, 1], and their derivatives.
fn bernstein(u: f64) -> ([f64; 4], [f64; 4]) {
    let (t, s) = (f64::midpoint(1.0, u), f64::midpoint(1.0, -u));
    (
        [s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t],
        [
            -1.5 * s * s,
            1.5 * (s * s - 2.0 * s * t),
            1.5 * (2.0 * s * t - t * t),
            1.5 * t * t,
        ],
    )
}

#[test]
fn tangents_of_the_outermost_points_go_by_the_slope_within_the_box() {
    let mut random = Random(29);
    for _ in 0..50 {
        let old = path(&mut random, false);
        let all = [0, 1, 2, 3, 4];
        let places: Vec<_> = old.points.iter().map(|point| point.position).collect();
        // The box of the points: each of its sides has one of them.
        let bounds = Bounds::of(&places);
        let half = (bounds.max() - bounds.min()) / 2.0;
        let mut lattice = crate::deform::identity_lattice();
        for number in &mut lattice {
            *number += random.unit() - 0.5;
        }
        let form = Deformation::new("free-form", &lattice).unwrap();
        let new = changed(&old, deform(&old, &all, &form, None, false).unwrap());
        for (a, b) in old.points.iter().zip(&new.points) {
            let at = bounds.coordinates(a.position);
            let along = [0, 1, 2].map(|axis| bernstein(at[axis]));
            let tangent = a.tangents.unwrap().after;
            let mut want = DVec3::ZERO;
            for (number, node) in lattice.chunks_exact(3).enumerate() {
                let place = [number & 3, number >> 2 & 3, number >> 4];
                for axis in 0..3 {
                    let weight: f64 = (0..3)
                        .map(|k| match k == axis {
                            true => along[k].1[place[k]] / half[k],
                            false => along[k].0[place[k]],
                        })
                        .product();
                    want += weight * tangent[axis] * DVec3::from_slice(node) * half;
                }
            }
            let got = b.tangents.unwrap().after;
            assert!(
                (got - want).length() < 1e-8 * want.length().max(1.0),
                "{got} {want}"
            );
        }
        // r = 1 at the low end and 0.5 at the high one, of which no half is taken.
        let taper = Deformation::new("taper", &[0.0, 1.0, 0.5]).unwrap();
        let new = changed(&old, deform(&old, &all, &taper, None, false).unwrap());
        let middle = (bounds.max() + bounds.min()) / 2.0;
        for (a, b) in old.points.iter().zip(&new.points) {
            let tangent = a.tangents.unwrap().after;
            let r = 0.75 - 0.25 * bounds.coordinates(a.position).x;
            let rate = -0.25 / half.x * tangent.x;
            let mut want = r * tangent + rate * (a.position - middle);
            want.x = tangent.x;
            let got = b.tangents.unwrap().after;
            assert!(
                (got - want).length() < 1e-8 * want.length().max(1.0),
                "{got} {want}"
            );
        }
    }
}
