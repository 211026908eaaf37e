use super::*;
use crate::path::test_support::Random;
use crate::path::{CurveKind, CurveParameters, SupportPoint, Tcb};

fn random_path(random: &mut Random, count: usize) -> CameraPath {
    let vector =
        |random: &mut Random| DVec3::from_array(std::array::from_fn(|_| 2.0 * random.unit() - 1.0));
    let points = (0..count).map(|_| {
        let mut point = SupportPoint::new(vector(random));
        point.curve = CurveParameters::Own(Tcb::new(random.unit(), random.unit(), random.unit()));
        point.orientations[0].target = Target::Relative(vector(random));
        point.orientations[0].roll = 360.0 * random.unit() - 180.0;
        point.orientations[0].zoom = 1.0 + 99.0 * random.unit();
        point
    });
    CameraPath {
        points: points.collect(),
        curve: if random.unit() < 0.5 {
            CurveKind::Cubic
        } else {
            CurveKind::Tcb
        },
        ..CameraPath::default()
    }
}

#[test]
fn the_curve_is_the_sum_of_the_curves() {
    let mut random = Random(21);
    for _ in 0..300 {
        let count = 2 + (random.unit() * 6.0) as usize;
        let paths: Vec<_> = (0..3).map(|_| random_path(&mut random, count)).collect();
        let a = 0.6 * random.unit();
        let weights = [0.3, a, 0.7 - a];
        let blend = blend(&paths.iter().collect::<Vec<_>>(), &weights).unwrap();
        for segment in 0..count - 1 {
            for t in [0.0, 0.1, 0.5, 0.9, 1.0] {
                let point = |path: &CameraPath| curve::segment(path, segment).point(t);
                let want: DVec3 = (0..3).map(|k| weights[k] * point(&paths[k])).sum();
                assert!((point(&blend) - want).length() < 1e-12);
            }
        }
        let zoom: f64 = (0..3)
            .map(|k| weights[k] * paths[k].points[1].orientations[0].zoom)
            .sum();
        assert!((blend.points[1].orientations[0].zoom - zoom).abs() < 1e-12);
    }
}

/// Fixed frames, angular velocities and slopes of the zoom: those of one path blended with
/// itself, and the sum where they differ.
#[test]
fn what_each_path_owns_is_blended_too() {
    let mut random = Random(23);
    let path = |random: &mut Random, frames: u32, slope: f64| {
        let mut path = random_path(random, 4);
        for point in &mut path.points {
            let view = &mut point.orientations[0];
            let own = |own: &mut OrientationOverrides| {
                own.frames = frames;
                own.zoom_slope = Some(slope);
                let reach = DVec3::new(slope, 0.5, -1.0);
                let leave = 2.0 * reach;
                own.velocities = Some(Velocities { reach, leave });
            };
            view.own = view.own.with(own).unwrap();
        }
        path
    };
    let (a, b) = (path(&mut random, 41, 0.2), path(&mut random, 20, -0.1));
    let same = blend(&[&a, &a], &[0.75, 0.25]).unwrap();
    let both = blend(&[&a, &b], &[0.75, 0.25]).unwrap();
    for at in 0..4 {
        let [same, both] = [&same, &both].map(|path| &path.points[at].orientations[0].own);
        let old = a.points[at].orientations[0].own.velocities.unwrap();
        assert_eq!((same.frames, both.frames), (41, 36));
        assert!((same.zoom_slope.unwrap() - 0.2).abs() < 1e-12);
        assert!((both.zoom_slope.unwrap() - 0.125).abs() < 1e-12);
        let own = same.velocities.unwrap();
        assert!(own.reach.distance(old.reach) + own.leave.distance(old.leave) < 1e-12);
        assert!((both.velocities.unwrap().leave.x - 0.25).abs() < 1e-12);
    }
}

#[test]
fn one_path_alone_is_itself() {
    let mut random = Random(22);
    let (a, b) = (random_path(&mut random, 5), random_path(&mut random, 5));
    let same = blend(&[&a, &b], &[1.0, 0.0]).unwrap();
    for (new, old) in same.points.iter().zip(&a.points) {
        assert_eq!(new.position, old.position);
        assert_eq!(new.orientations[0].speeds, old.orientations[0].speeds);
    }
}

#[test]
fn paths_of_different_numbers_are_blended_by_length() {
    let straight = |points: &[[f64; 3]]| {
        let points = points
            .iter()
            .map(|p| SupportPoint::new(DVec3::from_array(*p)));
        CameraPath {
            points: points.collect(),
            ..CameraPath::default()
        }
    };
    let a = straight(&[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0]]);
    let b = straight(&[
        [0.0, 1.0, 0.0],
        [0.5, 1.0, 0.0],
        [2.0, 1.0, 0.0],
        [4.0, 1.0, 0.0],
    ]);
    let blend = blend(&[&a, &b], &[0.5, 0.5]).unwrap();
    for (k, point) in blend.points.iter().enumerate() {
        let want = DVec3::new(2.5 * k as f64 / 3.0, 0.5, 0.0);
        assert!(
            (point.position - want).length() < 1e-9,
            "{} {want}",
            point.position
        );
    }
}

#[test]
fn weights_that_do_not_do_are_refused() {
    let mut random = Random(23);
    let (a, b) = (random_path(&mut random, 3), random_path(&mut random, 3));
    for weights in [
        &[0.5, 0.6][..],
        &[1.0],
        &[f64::NAN, 1.0],
        &[],
        &[30.0, -29.0],
    ] {
        assert!(blend(&[&a, &b], weights).is_err(), "{weights:?}");
    }
    assert!(blend(&[], &[]).is_err());
    let closed = CameraPath { closed: true, ..b };
    assert!(blend(&[&a, &closed], &[0.5, 0.5]).is_err());
}
