use std::f64::consts::TAU;

use super::*;
use crate::path::test_support::Random;
use crate::path::{Orientation, SupportPoint, Target};

const FPS: f64 = 25.0;
const SECONDS: f64 = 0.8;
const NOISE: [f64; 2] = [0.004, 0.006];

/// Nearly normal, of variance 1.
fn normal(random: &mut Random) -> DVec3 {
    DVec3::from_array(std::array::from_fn(|_| {
        (0..12).map(|_| random.unit()).sum::<f64>() - 6.0
    }))
}

/// A smooth flight at a frame, with a rotation from the one that looks along z.
fn smooth(frame: f64) -> (DVec3, DQuat) {
    let t = frame / FPS;
    let wave = |period: f64, phase: f64| (TAU * t / period + phase).sin();
    let place = DVec3::new(
        2.0 * wave(17.0, 0.0) + 0.4 * t,
        0.5 * wave(11.0, 1.0),
        1.5 * wave(13.0, 2.0),
    );
    let turn = DQuat::from_rotation_y(0.4 * t + 0.5 * wave(15.0, 0.5))
        * DQuat::from_rotation_x(0.4 * wave(12.0, 1.5));
    (place, turn)
}

/// One point a pose.
fn recorded(poses: &[(DVec3, DQuat)]) -> CameraPath {
    let point = |(place, turn): &(DVec3, DQuat)| {
        let (view, up) = view_from_quaternion(*turn);
        let mut point = SupportPoint::new(*place);
        point.orientations[0] = Orientation {
            target: Target::Relative(view),
            roll: crate::math::orientation::roll_from_up(view, up).to_degrees(),
            ..Orientation::default()
        };
        let own = &point.orientations[0].own;
        point.orientations[0].own = own.with(|own| own.frames = 1).unwrap();
        point
    };
    CameraPath {
        points: poses.iter().map(point).collect(),
        ..CameraPath::default()
    }
}

/// The smooth flight of so many frames, and with noise of a known power in place and turn.
fn shaken(frames: usize) -> (Vec<(DVec3, DQuat)>, CameraPath) {
    let mut random = Random(9);
    let clean: Vec<_> = (0..frames).map(|k| smooth(k as f64)).collect();
    let noisy = clean.iter().map(|(place, turn)| {
        let [far, off] = NOISE;
        // On S³ an angle counts half.
        let turn = exp(0.5 * off * normal(&mut random)) * *turn;
        (*place + far * normal(&mut random), turn)
    });
    let noisy: Vec<_> = noisy.collect();
    (clean, recorded(&noisy))
}

fn sampled(path: &CameraPath) -> Vec<(DVec3, DQuat)> {
    let sampler = Sampler::new(path, &Timeline::new(path).unwrap()).unwrap();
    let mut poses = vec![Pose::default(); sampler.frame_count()];
    sampler.sample(1, &mut poses).unwrap();
    poses
        .iter()
        .map(|pose| (pose.vrp.into(), turn(pose)))
        .collect()
}

fn request(within: f64) -> SteadyRequest {
    SteadyRequest {
        period: SECONDS,
        within,
        fps: FPS,
    }
}

fn off(a: &(DVec3, DQuat), b: &(DVec3, DQuat)) -> [DVec3; 2] {
    let turned = 2.0 * log(continue_sign(b.1, a.1).0 * b.1.conjugate());
    [a.0 - b.0, turned]
}

/// The rest of the noise against the transfer of the smoothing spline in closed form (the cardinal
/// one: its knots are all frames).
#[test]
fn the_rest_of_the_noise_is_what_the_filter_lets_through() {
    let (clean, path) = shaken(1000);
    let made = steady(&path, &request(0.0), &mut |_, _| true).unwrap();
    let again = sampled(&made.path);
    assert_eq!(again.len(), clean.len());
    let light = (SECONDS * FPS / TAU).powi(4);
    let transfer = |w: f64| {
        let stiff = light * (2.0 * (0.5 * w).sin()).powi(4) * 3.0 / (2.0 + w.cos());
        1.0 / (1.0 + stiff)
    };
    let steps = 10_000;
    let waves = (0..steps).map(|k| transfer(TAU * 0.5 * (f64::from(k) + 0.5) / f64::from(steps)));
    let let_through = waves.map(|h| h * h).sum::<f64>() / f64::from(steps);
    let inner = 20..clean.len() - 20;
    for (kind, noise) in NOISE.into_iter().enumerate() {
        let rest = inner.clone().map(|k| off(&again[k], &clean[k])[kind]);
        let power = rest.clone().map(DVec3::length_squared).sum::<f64>() / inner.len() as f64;
        let share = power / (3.0 * noise * noise * let_through);
        let drift = rest.sum::<DVec3>() / inner.len() as f64;
        let drift = drift.length() / (noise * (3.0 / inner.len() as f64).sqrt());
        println!("{kind}: {share:.3} of the transfer, drift {drift:.2} deviations");
        // A thousand values, of which some ninety are independent: 1 ± 0.09.
        assert!(share < 1.2, "{kind}: {share}");
        assert!(drift < 2.0, "{kind}: {drift}");
        // No lag: no shift by a part of a frame fits better.
        let miss = |lag: f64| {
            let shifted = |k: usize| smooth(k as f64 + lag);
            let all = inner.clone().map(|k| off(&again[k], &shifted(k))[kind]);
            all.map(DVec3::length_squared).sum::<f64>()
        };
        let three = [-0.5, 0.0, 0.5].map(miss);
        let peak = 0.25 * (three[0] - three[2]) / (three[0] - 2.0 * three[1] + three[2]);
        println!("lag {peak:.4} frames");
        assert!(peak.abs() < 0.02, "{peak}");
    }
    println!(
        "steady: {} points, {:.4} {:.3}",
        made.path.points.len(),
        made.furthest,
        made.turned
    );
    // The ends stay, and few points are left.
    let was = sampled(&path);
    for end in [0, was.len() - 1] {
        let [far, turned] = off(&again[end], &was[end]);
        assert!(
            far.length() < 1e-9 && turned.length() < 1e-9,
            "{far} {turned}"
        );
    }
    assert!(
        made.path.points.len() * 7 < was.len(),
        "{}",
        made.path.points.len()
    );
    let furthest = again.iter().zip(&was).map(|(a, b)| off(a, b)[0].length());
    assert!((furthest.fold(0.0, f64::max) - made.furthest).abs() < 1e-12);
}

#[test]
fn what_is_even_stays() {
    let turn = |k: usize| DQuat::from_rotation_y(0.08 * k as f64) * DQuat::from_rotation_x(0.3);
    let place = |k: usize| DVec3::new(0.01 * k as f64, 0.2, -0.02 * k as f64);
    let even: Vec<_> = (0..200).map(|k| (place(k), turn(k))).collect();
    let made = steady(&recorded(&even), &request(0.0), &mut |_, _| true).unwrap();
    println!("{} {}", made.furthest, made.turned);
    assert!(made.furthest < 1e-3 && made.turned < 0.03, "{made:?}");
}

#[test]
fn a_bound_holds() {
    let (_, path) = shaken(300);
    let free = steady(&path, &request(0.0), &mut |_, _| true).unwrap();
    for within in [0.5 * free.furthest, 0.1 * free.furthest] {
        let made = steady(&path, &request(within), &mut |_, _| true).unwrap();
        let pairs = sampled(&made.path).into_iter().zip(sampled(&path));
        let far = pairs.map(|(a, b)| a.0.distance(b.0)).fold(0.0, f64::max);
        println!("{within}: {far}, {} points", made.path.points.len());
        assert!(far <= within && far > 0.3 * within, "{far} of {within}");
    }
    let again = steady(&path, &request(0.0), &mut |_, _| true).unwrap();
    assert!(again.path == free.path);
}

#[test]
fn what_will_not_do_is_refused() {
    let (_, path) = shaken(40);
    let refused = |path: &CameraPath, request: SteadyRequest, go_on: bool| {
        steady(path, &request, &mut |_, _| go_on)
            .unwrap_err()
            .to_string()
    };
    for seconds in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e300, 80.01] {
        let wrong = refused(
            &path,
            SteadyRequest {
                period: seconds,
                ..request(0.0)
            },
            true,
        );
        assert!(wrong.contains("at most 80 s"), "{wrong}");
    }
    for within in [-1.0, f64::NAN, f64::INFINITY] {
        assert!(refused(&path, request(within), true).contains("not less than 0"));
    }
    for fps in [0.0, f64::NAN, 1e300] {
        refused(
            &path,
            SteadyRequest {
                fps,
                ..request(0.0)
            },
            true,
        );
    }
    let still = CameraPath {
        points: [0, 0].map(|at: usize| path.points[at].clone()).into(),
        ..CameraPath::default()
    };
    assert!(refused(&still, request(0.0), true).contains("does not move"));
    refused(&path, request(1e-300), true);
    assert!(refused(&path, request(0.0), false).contains("cancelled"));
}

#[test]
fn more_frames_than_can_be_fitted_are_refused_before_any_work() {
    let mut path = CameraPath::default();
    path.points[0].orientations[0].hold = 1_000_000;
    let request = SteadyRequest {
        period: SECONDS,
        within: 0.0,
        fps: FPS,
    };
    let mut asked = false;
    let mut progress = |_, _| {
        asked = true;
        true
    };
    let error = steady(&path, &request, &mut progress).unwrap_err();
    let said = "at most 1000000 frames can be fitted, this has 1000121";
    assert_eq!(error.to_string(), said);
    assert!(!asked);
}
