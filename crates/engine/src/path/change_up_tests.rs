//! Poses before and after, at whole frames and between, of paths with everything that a path may
//! have.

use std::sync::Arc;

use super::*;
use crate::path::insertion::on_curve;
use crate::path::insertion::tests::random_path;
use crate::path::test_support::Random;
use crate::path::up_vector::check_ups;
use crate::path::{
    CurveKind, OrientationMode, OrientationOverrides, Pose, Sampler, Target, UpPath, UpPathPoint,
    Velocities,
};

fn pick(random: &mut Random, count: usize) -> usize {
    (random.unit() * count as f64) as usize
}

fn direction(random: &mut Random) -> DVec3 {
    DVec3::new(random.unit(), random.unit(), random.unit()) - 0.5
}

fn second_path(random: &mut Random) -> Arc<UpPath> {
    let points = (0..3).map(|_| UpPathPoint {
        position: 5.0 * direction(random),
        before: direction(random),
        after: direction(random),
    });
    UpPath::new(points.collect()).unwrap()
}

/// A path with ups of all kinds, in runs; views along, at and against both axes and each other.
fn varied(random: &mut Random, round: usize) -> CameraPath {
    let mut path = random_path(random, round);
    path.space.up = [Up::Y, Up::Z][pick(random, 2)];
    path.orientation_mode = [
        OrientationMode::Tcb,
        OrientationMode::Tcb,
        OrientationMode::BarryGoldman,
        OrientationMode::Slerp,
    ][pick(random, 4)];
    let mut ups = vec![
        UpVector::Axis,
        UpVector::Axis,
        UpVector::Fixed(Up::Y),
        UpVector::Fixed(Up::Z),
        UpVector::Minimal,
        UpVector::Point(8.0 * direction(random)),
        UpVector::Path(second_path(random)),
    ];
    if path.points.len() > 2 && pick(random, 3) == 0 {
        path.curve = CurveKind::Cubic;
        path.points
            .iter_mut()
            .for_each(|point| point.tangents = None);
        ups.push(UpVector::Frenet);
    }
    let only = (pick(random, 3) == 0).then(|| ups[pick(random, ups.len())].clone());
    let mut up = ups[pick(random, ups.len())].clone();
    let mut ahead = None;
    let mut last: Option<Target> = None;
    for orientation in path.points.iter_mut().flat_map(|p| &mut p.orientations) {
        if pick(random, 3) == 0 {
            up = ups[pick(random, ups.len())].clone();
            ahead = [None, None, None, Some(0.0), Some(0.2)][pick(random, 5)];
        }
        match (pick(random, 8), last) {
            (0..=2, Some(last)) => orientation.target = last,
            (3, Some(Target::Relative(last))) => orientation.target = Target::Relative(-last),
            (4, _) => {
                let axis = [DVec3::Y, DVec3::Z, DVec3::X, -DVec3::Y][pick(random, 4)];
                orientation.target = Target::Relative(axis);
            }
            _ => {}
        }
        if pick(random, 2) == 0 {
            orientation.roll = [0.0, 180.0, 30.0][pick(random, 3)];
        }
        last = Some(orientation.target);
        let slope = (pick(random, 4) == 0).then(|| 4.0 * random.unit() - 2.0);
        let velocities = (pick(random, 6) == 0).then(|| Velocities {
            reach: 3.0 * direction(random),
            leave: 3.0 * direction(random),
        });
        let up = only.as_ref().unwrap_or(&up).clone();
        let change = |own: &mut OrientationOverrides| {
            (own.up, own.ahead) = (up, ahead);
            (own.roll_slope, own.velocities) = (slope, velocities);
        };
        orientation.own = orientation.own.with(change).unwrap();
    }
    path.check().unwrap();
    check_ups(&path).unwrap();
    path
}

fn sampler(path: &CameraPath) -> Sampler {
    Sampler::new(path, &Timeline::new(path).unwrap()).unwrap()
}

/// How far two paths' poses are apart at most, half frames included.
fn apart(a: &CameraPath, b: &CameraPath) -> f64 {
    let (a, b) = (sampler(a), sampler(b));
    assert_eq!(a.frame_count(), b.frame_count());
    let between = |x: &Pose, y: &Pose| {
        let pairs = [(x.vrp, y.vrp), (x.vpn, y.vpn), (x.vup, y.vup)];
        let far = pairs.map(|(x, y)| (DVec3::from(x) - DVec3::from(y)).abs().max_element());
        far.into_iter().fold((x.zoom - y.zoom).abs(), f64::max)
    };
    let sampled = |sampler: &Sampler| {
        let mut all = vec![Pose::default(); sampler.frame_count()];
        sampler.sample(1, &mut all).unwrap();
        all
    };
    let whole = sampled(&a)
        .iter()
        .zip(&sampled(&b))
        .map(|(x, y)| between(x, y))
        .fold(0.0, f64::max);
    let half = (1..a.frame_count()).map(|frame| {
        let at = frame as f64 + 0.37;
        between(&a.pose(at).unwrap(), &b.pose(at).unwrap())
    });
    half.fold(whole, f64::max)
}

#[test]
fn poses_stay() {
    let mut random = Random(26);
    let (mut worst, mut fixed, mut rolled): (f64, usize, usize) = (0.0, 0, 0);
    for round in 0..1000 {
        let path = varied(&mut random, round);
        let (old, new) = match path.space.up {
            Up::Y => (Up::Y, Up::Z),
            Up::Z => (Up::Z, Up::Y),
        };
        let there = change_up(&path, new).unwrap();
        check_ups(&there).unwrap();
        assert_eq!(there.space.up, new);
        let back = change_up(&there, old).unwrap();
        for changed in [&there, &back] {
            let far = apart(&path, changed);
            assert!(far < 1e-12, "{round}: {far:e}");
            worst = worst.max(far);
        }
        for orientation in there.points.iter().flat_map(|point| &point.orientations) {
            fixed += usize::from(orientation.own.up == UpVector::Fixed(old));
            rolled += usize::from(orientation.own.up == UpVector::Axis);
        }
    }
    println!("worst {worst:e}, {fixed} ups fixed, {rolled} rolled");
    assert!(fixed > 500 && rolled > 500);
}

/// Divided turnings remember quaternions of the axes in which they were made.
#[test]
fn divided_turnings_stay() {
    let mut random = Random(7);
    let mut divided = 0;
    for round in 0..60 {
        let mut path = varied(&mut random, round);
        path.orientation_mode = OrientationMode::Tcb;
        let timeline = Timeline::new(&path).unwrap();
        let frames = timeline.frame_count().unwrap() as f64;
        let at = 1.0 + (frames - 1.0) * random.unit();
        let Ok(divided_path) = on_curve(&path, at) else {
            continue;
        };
        let path = divided_path.path;
        let all = || path.points.iter().flat_map(|point| &point.orientations);
        divided += all().filter(|o| o.own.turning.is_some()).count();
        let new = if path.space.up == Up::Y { Up::Z } else { Up::Y };
        let far = apart(&path, &change_up(&path, new).unwrap());
        assert!(far < 1e-12, "{round}: {far:e}");
    }
    assert!(divided > 10, "{divided}");
}

#[test]
fn the_turn_is_the_exchange_of_axes() {
    for up in [Up::Y, Up::Z] {
        for v in [DVec3::X, DVec3::Y, DVec3::Z] {
            assert_eq!(turn(up) * v, up.upright(v));
        }
    }
}

/// By hand: level in a y-up path and looking along x is a quarter roll where z is upright.
#[test]
fn rolls_are_those_against_the_new_axis() {
    let mut path = CameraPath::default();
    for (point, view) in path.points.iter_mut().zip([DVec3::X, -DVec3::X]) {
        point.orientations[0].target = Target::Relative(view);
    }
    let new = change_up(&path, Up::Z).unwrap();
    let rolls = [0, 1].map(|at| new.points[at].orientations[0].roll);
    // Right of a view along x with z up lies −y: up towards it is a roll of −90°.
    assert!(
        (rolls[0] + 90.0).abs() < 1e-12 && (rolls[1] - 90.0).abs() < 1e-12,
        "{rolls:?}"
    );
    let both = change_up(&new, Up::Y).unwrap();
    assert!(both.points[0].orientations[0].roll.abs() < 1e-12);
}

/// A tracked path keeps its axis by name, and has it as the upright one again.
#[test]
fn tracked_paths_come_back_as_they_were() {
    let mut path = CameraPath::default();
    for point in &mut path.points {
        point.orientations[0].target = Target::Absolute(DVec3::new(0.1, 0.0, -0.3));
        point.orientations[0].roll = 20.0;
    }
    let new = change_up(&path, Up::Z).unwrap();
    for point in &new.points {
        assert_eq!(point.orientations[0].own.up, UpVector::Fixed(Up::Y));
        assert_eq!(point.orientations[0].roll, 20.0);
    }
    assert!(change_up(&new, Up::Y).unwrap() == path);
}
