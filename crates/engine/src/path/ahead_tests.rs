//! Views along the way against what finite differences and a plain quadrature
//! say of the curve.

use super::*;
use crate::path::insertion::tests::random_path;
use crate::path::test_support::Random;
use crate::path::{CurveKind, Pose, Sampler, SupportPoint, Target, Timeline};

fn look(path: &mut CameraPath, distance: f64) {
    for orientation in path.points.iter_mut().flat_map(|p| &mut p.orientations) {
        orientation.own = orientation
            .own
            .with(|own| own.ahead = Some(distance))
            .unwrap();
    }
}

fn smooth_path(random: &mut Random, round: usize, distance: f64) -> CameraPath {
    let mut path = random_path(random, round);
    while path.points.len() < 4 {
        let v = std::array::from_fn(|_| 2.0 * random.unit() - 1.0);
        path.points.push(SupportPoint::new(DVec3::from_array(v)));
    }
    path.curve = CurveKind::Cubic;
    look(&mut path, distance);
    path
}

fn sampler(path: &CameraPath) -> Sampler {
    path.check().unwrap();
    Sampler::new(path, &Timeline::new(path).unwrap()).unwrap()
}

fn vector(v: [f64; 3]) -> DVec3 {
    DVec3::from_array(v)
}

#[test]
fn the_tangent_is_where_the_camera_goes() {
    let mut random = Random(61);
    let mut seen = 0;
    for round in 0..100 {
        let path = smooth_path(&mut random, round, 0.0);
        let sampler = sampler(&path);
        let mut all = vec![Pose::default(); sampler.frame_count()];
        sampler.sample(1, &mut all).unwrap();
        for (k, pose) in all.iter().enumerate().skip(1) {
            let frame = (k + 1) as f64;
            let (view, up) = (vector(pose.vpn), vector(pose.vup));
            assert!((view.length() - 1.0).abs() < 1e-12 && view.dot(up).abs() < 1e-12);
            if frame >= sampler.frame_count() as f64 {
                continue;
            }
            let again = sampler.pose(frame).unwrap();
            assert!((vector(again.vpn) - view).length() < 1e-12);
            let at = |d: f64| vector(sampler.pose(frame + d).unwrap().vrp);
            let far = |h: f64| (at(h) - at(-h)) / (2.0 * h);
            let moved = (4.0 * far(1e-3) - far(2e-3)) / 3.0;
            // At rest and where the way turns sharply differences tell little; how
            // much, two of them tell.
            let ambiguity = (far(1e-3) - far(2e-3)).length() / moved.length();
            if ambiguity < 1e-5 {
                let error = (unit(moved) - view).length();
                assert!(
                    error < 10.0 * ambiguity + 1e-8,
                    "{round} {frame}: {error} {ambiguity}"
                );
                seen += 1;
            }
        }
    }
    assert!(seen > 8_000, "{seen}");
}

/// The place `s` along the whole curve: the midpoint rule over many small
/// steps, corrected by the rule of Simpson.
struct Measured {
    places: Vec<(f64, usize, f64)>,
}

const STEPS: usize = 4000;

impl Measured {
    fn new(curves: &[Cubic]) -> Self {
        let mut places = vec![(0.0, 0, 0.0)];
        let mut s = 0.0;
        for (k, curve) in curves.iter().enumerate() {
            let speed = |t: f64| curve.derivative(t).length();
            for i in 0..STEPS {
                let [a, m, b] = [0.0, 0.5, 1.0].map(|x| (i as f64 + x) / STEPS as f64);
                s += (speed(a) + 4.0 * speed(m) + speed(b)) / 6.0 / STEPS as f64;
                places.push((s, k, b));
            }
        }
        Self { places }
    }

    fn place(&self, curves: &[Cubic], s: f64) -> DVec3 {
        let at = self.places.partition_point(|place| place.0 <= s).max(1) - 1;
        let (from, k, t) = self.places[at];
        let (k, t) = if t == 1.0 && k + 1 < curves.len() {
            (k + 1, 0.0)
        } else {
            (k, t)
        };
        let curve = &curves[k];
        let mut t1 = t;
        for _ in 0..20 {
            let speed = |t: f64| curve.derivative(t).length();
            let gone = (speed(t) + 4.0 * speed((t + t1) / 2.0) + speed(t1)) / 6.0 * (t1 - t);
            t1 += (s - from - gone) / speed(t1);
        }
        curve.point(t1)
    }
}

#[test]
fn the_secant_meets_the_place_ahead() {
    let mut random = Random(62);
    for round in 0..60 {
        let distance = 0.05 + 1.5 * random.unit();
        let path = smooth_path(&mut random, round, distance);
        let timeline = Timeline::new(&path).unwrap();
        let curves: Vec<_> = (0..path.segment_count())
            .map(|k| *timeline.curve(k))
            .collect();
        // Where the way all but stops the plain quadrature tells too little.
        let slowest = |curve: &Cubic| {
            (0..=400)
                .map(|k| curve.derivative(f64::from(k) / 400.0).length())
                .fold(f64::INFINITY, f64::min)
        };
        if curves.iter().any(|curve| slowest(curve) < 0.05) {
            continue;
        }
        let measured = Measured::new(&curves);
        let whole = measured.places[measured.places.len() - 1].0;
        let sampler = sampler(&path);
        for section in 0..timeline.section_count() {
            let begin = timeline.section(section);
            if begin.orientation + 1 < path.points[begin.point].orientations.len()
                || begin.frames < 3
            {
                continue;
            }
            let before: f64 = (0..begin.point).map(|k| timeline.segment_length(k)).sum();
            let timing = timeline.timing(&path, section).unwrap();
            for n in 1..begin.frames.min(20) {
                let frame = (sampler.first_frame(section) - 1 + n) as f64;
                let pose = sampler.pose(frame).unwrap();
                let u = n as f64 / begin.frames as f64;
                let s = before + timing.fraction(u) * begin.amount;
                let there = s + distance;
                let place = if path.closed {
                    measured.place(&curves, there % whole)
                } else if there < whole {
                    measured.place(&curves, there)
                } else {
                    let last = &curves[curves.len() - 1];
                    last.point(1.0) + unit(last.derivative(1.0)) * (there - whole)
                };
                let expected = place - vector(pose.vrp);
                if expected.length() > 1e-3 {
                    let error = (unit(expected) - vector(pose.vpn)).length() * expected.length();
                    assert!(error < 1e-9, "{round} {frame}: {error}");
                }
            }
        }
    }
}

/// Steps of the view shrink as more frames are asked for: nowhere a jump.
#[test]
fn views_do_not_jump() {
    let mut random = Random(63);
    for round in 0..40 {
        let mut path = smooth_path(&mut random, round, if round % 2 == 0 { 0.0 } else { 0.3 });
        // Other looks beside it, which take over its velocity.
        let count = path.points.len();
        if round % 3 == 0 {
            for orientation in &mut path.points[count - 1].orientations {
                orientation.own = orientation.own.with(|own| own.ahead = None).unwrap();
            }
        }
        let steps = |path: &mut CameraPath, frames: f64| {
            path.base_frames.movement = frames;
            path.base_frames.turning = frames;
            path.base_frames.zoom = frames;
            path.base_frames.rolling = frames;
            let sampler = sampler(path);
            let mut all = vec![Pose::default(); sampler.frame_count()];
            sampler.sample(1, &mut all).unwrap();
            let far = |pair: &[Pose]| (vector(pair[1].vpn) - vector(pair[0].vpn)).length();
            all.windows(2).map(far).fold(0.0, f64::max)
        };
        let coarse = steps(&mut path, 500.0);
        let fine = steps(&mut path, 4000.0);
        // A jump would stay what it is; where the way turns within a few frames,
        // they are still far apart.
        assert!(
            fine < 0.7 * coarse || fine < 0.02,
            "{round}: {coarse} {fine}"
        );
    }
}

#[test]
fn without_a_direction_the_last_one_holds() {
    let place = |x: f64| SupportPoint::new(DVec3::new(x, 0.2, 0.1));
    let mut path = CameraPath {
        points: [-0.5, -0.5, 0.1, 0.1, 0.7].map(place).into(),
        curve: CurveKind::Linear,
        ..CameraPath::default()
    };
    look(&mut path, 0.0);
    for point in 0..5 {
        assert_eq!(view(&path, point, 0), DVec3::X, "{point}");
    }
    look(&mut path, 100.0);
    for point in 0..5 {
        assert!(
            (view(&path, point, 0) - DVec3::X).length() < 1e-15,
            "{point}"
        );
    }
    // Nowhere a direction: the target of the orientation itself.
    for point in &mut path.points {
        point.position = DVec3::ZERO;
        point.orientations[0].target = Target::Relative(DVec3::Y);
    }
    look(&mut path, 0.0);
    assert_eq!(view(&path, 2, 0), DVec3::Y);
    look(&mut path, 0.5);
    assert_eq!(view(&path, 2, 0), DVec3::Y);
    assert_eq!(sampler(&path).frame_count(), 1);
    // Straight up there is no yaw; nothing may come out that is no number.
    let mut path = CameraPath::default();
    for (k, point) in path.points.iter_mut().enumerate() {
        point.position = DVec3::new(0.0, k as f64, 0.0);
    }
    look(&mut path, 0.0);
    let sampler = sampler(&path);
    let mut all = vec![Pose::default(); sampler.frame_count()];
    sampler.sample(1, &mut all).unwrap();
    for pose in &all {
        assert_eq!(pose.vpn, [0.0, 1.0, 0.0]);
        assert_eq!(pose.vup, all[0].vup);
    }
}
