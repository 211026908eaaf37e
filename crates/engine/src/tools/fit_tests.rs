use std::f64::consts::{PI, TAU};

use super::*;
use crate::math::quaternion::{exp, log};
use crate::path::test_support::Random;
use crate::path::{Sampler, Timeline};
use crate::tools::check::{CheckContext, Limits, check};

#[path = "fit/closer_tests.rs"]
mod closer;
#[path = "fit/noise_tests.rs"]
mod noise;
#[path = "fit/recordings_tests.rs"]
mod recordings;

fn vector(random: &mut Random) -> DVec3 {
    DVec3::from_array(std::array::from_fn(|_| 2.0 * random.unit() - 1.0))
}

/// A flight of `count` points, brought to so many poses.
fn flight(random: &mut Random, count: usize, poses: usize) -> Vec<Pose> {
    let mut at = DVec3::ZERO;
    let mut heading = 6.0 * random.unit();
    let points = (0..count).map(|_| {
        heading += 1.6 * (random.unit() - 0.5);
        at += DVec3::new(heading.sin(), 0.6 * (random.unit() - 0.5), heading.cos())
            * (0.4 + 0.4 * random.unit());
        let mut point = SupportPoint::new(at);
        let view = DVec3::new(heading.sin(), 0.4 * (random.unit() - 0.5), heading.cos());
        point.orientations[0] = Orientation {
            target: Target::Relative(view),
            roll: 30.0 * (random.unit() - 0.5),
            zoom: 20.0 + 20.0 * random.unit(),
            ..Orientation::default()
        };
        point
    });
    let mut path = CameraPath {
        points: points.collect(),
        ..CameraPath::default()
    };
    let timeline = Timeline::new(&path).unwrap();
    path.base_frames.movement *= poses as f64 / timeline.frame_count().unwrap() as f64;
    sampled(&path)
}

fn sampled(path: &CameraPath) -> Vec<Pose> {
    let timeline = Timeline::new(path).unwrap();
    let sampler = Sampler::new(path, &timeline).unwrap();
    let mut poses = vec![Pose::default(); sampler.frame_count()];
    sampler.sample(1, &mut poses).unwrap();
    poses
}

/// The largest errors of position and angles, as VIDES itself samples the fit.
fn errors(path: &CameraPath, poses: &[Pose]) -> (f64, f64) {
    let again = sampled(path);
    assert_eq!(again.len(), poses.len());
    let mut most = (0.0_f64, 0.0_f64);
    for (a, b) in again.iter().zip(poses) {
        let far = (DVec3::from(a.vrp) - DVec3::from(b.vrp)).length();
        let turned = |a: [f64; 3], b: [f64; 3]| {
            DVec3::from(a)
                .cross(b.into())
                .length()
                .atan2(DVec3::from(a).dot(b.into()))
        };
        let off = turned(a.vpn, b.vpn).max(turned(a.vup, b.vup));
        let seen = (view_angle(a.zoom) - view_angle(b.zoom)).abs();
        most = (most.0.max(far), most.1.max(off.max(seen).to_degrees()));
    }
    most
}

const TOLERANCE: Tolerance = Tolerance {
    position: 0.01,
    angle: 0.5,
};

fn fitted(poses: &[Pose]) -> CameraPath {
    fit(poses, None, 25.0, &TOLERANCE.into(), &mut |_, _| true)
        .unwrap()
        .path
}

#[test]
fn a_sampled_flight_needs_no_more_than_twice_its_points() {
    let mut random = Random(77);
    for count in [2, 5, 10, 20, 40] {
        let mut poses = flight(&mut random, count, 10_000);
        let path = fitted(&poses);
        let (far, off) = errors(&path, &poses);
        println!(
            "{count} points: {} back, {far:.5} {off:.4}",
            path.points.len()
        );
        assert!(far <= 0.0101 && off <= 0.505, "{far} {off}");
        assert!(
            path.points.len() <= 2 * count,
            "{count}: {}",
            path.points.len()
        );
        // Noise of half the tolerance.
        for pose in &mut poses {
            let noise = |random: &mut Random, most: f64| loop {
                let v = vector(random);
                if v.length() <= 1.0 {
                    return most * v;
                }
            };
            let q = exp(noise(&mut random, 0.25f64.to_radians() / 2.0))
                * quaternion_from_view(pose.vpn.into(), pose.vup.into());
            let (view, up) = view_from_quaternion(q);
            (pose.vpn, pose.vup) = (view.to_array(), up.to_array());
            pose.vrp = (DVec3::from(pose.vrp) + noise(&mut random, 0.005)).to_array();
        }
        let path = fitted(&poses);
        let (far, off) = errors(&path, &poses);
        println!(
            "{count} points, noise: {} back, {far:.5} {off:.4}",
            path.points.len()
        );
        assert!(far <= 0.0101 && off <= 0.505, "{far} {off}");
        assert!(
            path.points.len() <= 2 * count,
            "{count}: {}",
            path.points.len()
        );
    }
}

#[test]
fn rest_and_turns_on_the_spot_are_met() {
    let mut path = CameraPath::default();
    path.points[0].orientations[0].hold = 40;
    let mut turned = path.points[0].orientations[0].clone();
    turned.target = Target::Relative(DVec3::new(0.4, 0.1, -0.1));
    turned.hold = 20;
    path.points[0].orientations.push(turned);
    let poses = sampled(&path);
    let path = fitted(&poses);
    let (far, off) = errors(&path, &poses);
    assert!(far <= 0.0101 && off <= 0.505, "{far} {off}");
    assert!(path.points.len() <= 6, "{}", path.points.len());
}

#[test]
fn times_of_their_own_are_kept() {
    let mut random = Random(5);
    let poses = flight(&mut random, 6, 600);
    let (mut seconds, mut chosen) = (Vec::new(), Vec::new());
    for (k, pose) in poses.iter().enumerate() {
        if k == 0 || k + 1 == poses.len() || random.unit() < 0.4 {
            seconds.push(3.0 + k as f64 / 25.0);
            chosen.push(*pose);
        }
    }
    let path = fit(
        &chosen,
        Some(&seconds),
        25.0,
        &TOLERANCE.into(),
        &mut |_, _| true,
    )
    .unwrap()
    .path;
    assert!(path.points.len() <= 12);
    let (far, off) = errors(&path, &poses);
    assert!(far <= 0.012 && off <= 0.6, "{far} {off}");
}

#[test]
fn poses_that_are_no_path_are_refused() {
    let mut random = Random(6);
    let poses = flight(&mut random, 3, 50);
    let refused = |poses: &[Pose], seconds: Option<&[f64]>, tolerance: Tolerance| {
        let error = fit(poses, seconds, 25.0, &tolerance.into(), &mut |_, _| true).unwrap_err();
        error.to_string()
    };
    assert!(refused(&poses[..1], None, TOLERANCE).contains("two"));
    let mut bad = poses.clone();
    bad[4].vrp[1] = f64::NAN;
    assert!(refused(&bad, None, TOLERANCE).starts_with("pose 5: "));
    bad[4] = poses[4];
    bad[3].vup = bad[3].vpn;
    assert!(refused(&bad, None, TOLERANCE).starts_with("pose 4: "));
    for seconds in [[0.0, 1.0, 0.5], [0.0, 1.0, f64::NAN], [0.0, f64::NAN, 1.0]] {
        let error = refused(&poses[..3], Some(&seconds), TOLERANCE);
        assert!(
            error.starts_with("pose ") && error.contains("backwards"),
            "{error}"
        );
    }
    for position in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let tolerance = Tolerance {
            position,
            ..TOLERANCE
        };
        assert!(refused(&poses, None, tolerance).contains("greater than 0"));
    }
    let cancelled = fit(&poses, None, 25.0, &TOLERANCE.into(), &mut |_, _| false);
    assert!(cancelled.unwrap_err().to_string().contains("cancelled"));
}

/// Cuts, shaking by more than the tolerance and turns from one frame to the next are no
/// noise: the poses themselves are met, or the report says by how much they are missed.
#[test]
fn what_is_no_noise_is_met_too() {
    let mut random = Random(8);
    let flight = flight(&mut random, 6, 250);
    let mut noisy = |poses: &[Pose], most: f64| -> Vec<Pose> {
        let mut poses = poses.to_vec();
        for pose in &mut poses {
            let place = DVec3::from(pose.vrp) + most * vector(&mut random);
            pose.vrp = place.to_array();
        }
        poses
    };
    let mut cut = flight.clone();
    for pose in &mut cut[120..] {
        pose.vrp[0] += 0.5;
    }
    let mut shaking = flight.clone();
    for pose in shaking.iter_mut().step_by(2) {
        pose.vrp[1] += 0.05;
    }
    let mut flips = flight.clone();
    for pose in &mut flips[100..102] {
        pose.vpn = pose.vpn.map(|x| -x);
    }
    for poses in [
        noisy(&flight, 0.008),
        noisy(&flight, 0.02),
        noisy(&flight, 0.2),
        noisy(&cut, 0.003),
        shaking,
        noisy(&flips, 0.002),
        flips,
    ] {
        let path = fitted(&poses);
        let (far, off) = errors(&path, &poses);
        assert!(far <= 0.0101 && off <= 0.505, "{far} {off}");
    }
    // Between whole frames the view turns back and forth: the report says by how much it is missed.
    let seconds: Vec<f64> = (0..flight.len()).map(|k| k as f64 / 60.0).collect();
    let mut poses = flight;
    for pose in poses.iter_mut().step_by(2) {
        pose.vpn[1] += 0.3;
    }
    let options = TOLERANCE.into();
    let made = fit(&poses, Some(&seconds), 25.0, &options, &mut |_, _| true).unwrap();
    assert!(made.report.view.greatest > 5.0 && made.report.view.greatest < 30.0);
    assert!(made.path.points.len() <= 106);
}

/// A sum of six sines, and its second derivative.
fn waves(size: f64, number: f64, t: f64) -> [f64; 2] {
    let mut sum = [0.0; 2];
    for k in 0..6 {
        let k = f64::from(k);
        let rate = TAU * 0.03 * 1.9f64.powf(k) * (1.0 + 0.1 * (3.0 * k + number).sin());
        let value = size * 1.9f64.powf(-1.6 * k) * (rate * t + k * k + number).sin();
        sum = [sum[0] + value, sum[1] - rate * rate * value];
    }
    sum
}

/// A camera carried by hand for a hundred seconds, at 30 frames a second; and the greatest
/// acceleration of its place, in closed form.
fn handheld() -> (Vec<Pose>, f64) {
    let mut peak = 0.0_f64;
    let poses = (0..3000).map(|frame| {
        let t = f64::from(frame) / 30.0;
        let place = [(2.5, 1.0), (0.6, 2.0), (2.5, 3.0)].map(|(size, n)| waves(size, n, t));
        peak = peak.max(DVec3::from_array(place.map(|wave| wave[1])).length());
        let [yaw, pitch, roll] =
            [(1.2, 4.0), (0.3, 5.0), (0.1, 6.0)].map(|(size, n)| waves(size, n, t)[0]);
        let turn = DQuat::from_rotation_y(yaw)
            * DQuat::from_rotation_x(pitch)
            * DQuat::from_rotation_z(roll);
        Pose {
            vrp: place.map(|wave| wave[0]),
            vpn: (turn * DVec3::Z).to_array(),
            vup: (turn * DVec3::Y).to_array(),
            zoom: 30.0,
        }
    });
    (poses.collect(), peak)
}

fn places(poses: &[Pose]) -> Vec<DVec3> {
    poses.iter().map(|pose| pose.vrp.into()).collect()
}

/// The greatest acceleration at whole frames, and that of the turning in degrees.
fn peaks(poses: &[Pose]) -> [f64; 2] {
    let bend = |p: &[DVec3]| (p[2] - 2.0 * p[1] + p[0]).length() * 900.0;
    let q = |pose: &Pose| quaternion_from_view(pose.vpn.into(), pose.vup.into());
    let turned = |a: &Pose, b: &Pose| {
        let by = q(b) * q(a).conjugate();
        2.0 * log(if by.w < 0.0 { -by } else { by })
    };
    let spin = |p: &[Pose]| {
        (turned(&p[1], &p[2]) - turned(&p[0], &p[1]))
            .length()
            .to_degrees()
    };
    [
        places(poses).windows(3).map(bend).fold(0.0, f64::max),
        poses
            .windows(3)
            .map(|three| spin(three) * 900.0)
            .fold(0.0, f64::max),
    ]
}

/// The greatest jump of the acceleration at a point, from places close beside it.
fn jump(path: &CameraPath) -> f64 {
    let sampler = Sampler::new(path, &Timeline::new(path).unwrap()).unwrap();
    let place = |frame: f64| DVec3::from(sampler.pose(frame).unwrap().vrp);
    let (mut at, mut worst) = (1.0, 0.0_f64);
    for point in path.points.range(..path.points.len() - 2) {
        at += f64::from(point.orientations[0].own.frames);
        let bend = |h: f64| (place(at) - 2.0 * place(at + h) + place(at + 2.0 * h)) / (h * h);
        worst = worst.max((bend(0.05) - bend(-0.05)).length() * 900.0);
    }
    worst
}

/// SciPy 1.17: the greatest acceleration of `make_smoothing_spline` of each coordinate, with the
/// largest `lam` that misses no place by more than 0.01.
const SMOOTHING_SPLINE: f64 = 1.183;

#[test]
fn a_recorded_flight_stays_as_smooth_as_it_was() {
    let (poses, peak) = handheld();
    for noise in [0.0, 0.005] {
        let mut random = Random(12);
        let mut noisy = poses.clone();
        for pose in &mut noisy {
            let off = vector(&mut random).clamp_length_max(1.0);
            pose.vrp = (DVec3::from(pose.vrp) + noise * off).to_array();
        }
        let tolerance = TOLERANCE.into();
        let path = fit(&noisy, None, 30.0, &tolerance, &mut |_, _| true)
            .unwrap()
            .path;
        let (far, off) = errors(&path, &noisy);
        let again = sampled(&path);
        let (was, is, jump) = (peaks(&poses), peaks(&again), jump(&path));
        println!(
            "noise {noise}: {} points, {far:.4} {off:.4}; {was:.2?} {is:.2?}, jump {jump:.4}",
            path.points.len()
        );
        assert!((was[0] / peak - 1.0).abs() < 0.01, "{peak}");
        assert!(far <= 0.0101 && off <= 0.505);
        assert!(is[0] <= 1.05 * was[0] && is[0] <= 1.5 * SMOOTHING_SPLINE);
        assert!(is[1] <= 1.1 * was[1]);
        assert!(jump <= 0.05 * was[0]);
        if noise == 0.0 {
            let against = CheckContext {
                fps: 30.0,
                space: Some(path.space.into()),
                object: None,
                limits: Limits::default(),
            };
            let found = check(&path, &against).unwrap();
            assert!(found.is_empty(), "{found:?}");
        }
    }
}

/// 0 to 1 with two continuous derivatives, and its integral.
fn eased(u: f64) -> [f64; 2] {
    let t = u.clamp(0.0, 1.0);
    let rises = t * t * t * (10.0 - 15.0 * t + 6.0 * t * t);
    let gone = t.powi(4) * (2.5 - 3.0 * t + t * t);
    [rises, gone + (u - 1.0).max(0.0)]
}

fn turned(place: [f64; 3], yaw: f64, pitch: f64) -> Pose {
    let turn = DQuat::from_rotation_y(yaw) * DQuat::from_rotation_x(pitch);
    Pose {
        vrp: place,
        vpn: (turn * DVec3::Z).to_array(),
        vup: (turn * DVec3::Y).to_array(),
        zoom: 30.0,
    }
}

/// Differences of second differences over an eighth of a frame hold every jump, and little else:
/// of these motions themselves they are 1.3 % at most.
#[test]
fn accelerations_do_not_jump_where_the_camera_is_slow() {
    // Carried by hand, a twenty-fifth as far and four times as slowly as the other one.
    let slow = |t: f64| {
        let wave = |size: f64, number: f64| waves(size, number, 0.25 * t)[0];
        let place = [wave(0.1, 1.0), wave(0.03, 2.0), wave(0.1, 3.0)];
        turned(place, wave(0.06, 4.0), wave(0.02, 5.0))
    };
    // Slows down to a fiftieth, and pans meanwhile.
    let pan = |t: f64| {
        let eases = 4.0 * (eased((t - 14.0) / 4.0)[1] - eased((t - 6.0) / 4.0)[1]);
        let x = 0.4 * (0.02 * t + 0.98 * (t + eases));
        let place = [
            (0.3 * x).sin() / 0.3,
            0.1 * (0.5 * x).sin(),
            (1.0 - (0.3 * x).cos()) / 0.3,
        ];
        turned(
            place,
            0.5 * PI * eased((t - 8.0) / 8.0)[0],
            0.1 * (0.4 * x).sin(),
        )
    };
    type Flight<'a> = (&'a dyn Fn(f64) -> Pose, f64, usize);
    let flights: [Flight<'_>; 2] = [(&slow, 100.0, 28), (&pan, 24.0, 46)];
    for (at, seconds, most) in flights {
        let frames = 25.0 * seconds;
        let poses: Vec<Pose> = (0..=frames as usize).map(|k| at(k as f64 / 25.0)).collect();
        let path = fitted(&poses);
        let (far, off) = errors(&path, &poses);
        assert!(far <= 0.0101 && off <= 0.505, "{far} {off}");
        assert!(path.points.len() <= most, "{}", path.points.len());
        let sampler = Sampler::new(&path, &Timeline::new(&path).unwrap()).unwrap();
        let fine = 0..=8 * frames as usize;
        let made: Vec<Pose> = fine
            .clone()
            .map(|k| sampler.pose(1.0 + k as f64 / 8.0).unwrap())
            .collect();
        let known: Vec<Pose> = fine.map(|k| at(k as f64 / 200.0)).collect();
        for kind in 0..2 {
            let peak = bends(&known, kind)
                .into_iter()
                .map(DVec3::length)
                .fold(0.0, f64::max);
            let made = bends(&made, kind);
            let jumps = made.windows(3).map(|three| three[2].distance(three[0]));
            let jump = jumps.fold(0.0, f64::max) / peak;
            println!("{} points, jump {jump:.4}", path.points.len());
            assert!(jump <= [0.05, 0.06][kind], "{kind}: {jump}");
        }
    }
}

/// Second differences of the places (0) or of the turning (1).
fn bends(poses: &[Pose], kind: usize) -> Vec<DVec3> {
    let q = |pose: &Pose| quaternion_from_view(pose.vpn.into(), pose.vup.into());
    let step = |pair: &[Pose]| {
        let by = q(&pair[1]) * q(&pair[0]).conjugate();
        let moved = DVec3::from(pair[1].vrp) - DVec3::from(pair[0].vrp);
        [moved, log(if by.w < 0.0 { -by } else { by })][kind]
    };
    let steps: Vec<DVec3> = poses.windows(2).map(step).collect();
    steps.windows(2).map(|pair| pair[1] - pair[0]).collect()
}

#[test]
fn outliers_are_left_out_where_asked() {
    let (clean, _) = handheld();
    let mut random = Random(31);
    let mut poses = clean.clone();
    for k in 0..30 {
        let pose = &mut poses[50 + 97 * k];
        match k % 3 {
            0 => pose.zoom = 400.0,
            1 => pose.vpn = (-DVec3::from(pose.vpn)).to_array(),
            _ => {
                let off = 0.3 * vector(&mut random).normalize();
                pose.vrp = (DVec3::from(pose.vrp) + off).to_array();
            }
        }
    }
    let mut options = Options::from(TOLERANCE);
    let followed = fit(&poses, None, 30.0, &options, &mut |_, _| true).unwrap();
    assert!(followed.left_out.is_empty() && errors(&followed.path, &poses).0 <= 0.0101);
    options.robust = true;
    let fitted = fit(&poses, None, 30.0, &options, &mut |_, _| true).unwrap();
    // Also where a pose was off, the others tell where it should have been.
    let (far, off) = errors(&fitted.path, &clean);
    println!("{far} {off} {:?}", peaks(&sampled(&fitted.path)));
    assert!(
        fitted.left_out == (0..30).map(|k| 50 + 97 * k).collect::<Vec<_>>()
            && far <= 0.0101
            && off <= 0.505,
        "{far} {off}"
    );
    assert!(peaks(&sampled(&fitted.path))[0] <= 1.05 * peaks(&clean)[0]);
    let calm = fit(&clean, None, 30.0, &options, &mut |_, _| true).unwrap();
    assert!(calm.left_out.is_empty());
}

#[test]
fn a_fit_has_a_space_that_holds_its_poses() {
    let mut random = Random(3);
    let poses = flight(&mut random, 5, 400);
    let [low, high] = places(&poses).into_iter().fold(
        [DVec3::INFINITY, DVec3::NEG_INFINITY],
        |[low, high], place| [low.min(place), high.max(place)],
    );
    let path = fitted(&poses);
    let half = 0.5 * (high - low).max_element();
    assert!((path.space.half_size - 1.1 * half).abs() < 1e-12 && path.space.up == Up::Y);
    assert!((path.space.centre - 0.5 * (low + high)).length() < 1e-12);
    // The same with z upright: x becomes y, y z and z x.
    let turned: Vec<Pose> = poses
        .iter()
        .map(|pose| {
            let [vrp, vpn, vup] = [pose.vrp, pose.vpn, pose.vup].map(|[x, y, z]| [z, x, y]);
            Pose {
                vrp,
                vpn,
                vup,
                ..*pose
            }
        })
        .collect();
    let options = Options {
        up: Up::Z,
        ..TOLERANCE.into()
    };
    let upright = fit(&turned, None, 25.0, &options, &mut |_, _| true)
        .unwrap()
        .path;
    assert_eq!(
        (upright.space.up, upright.points.len()),
        (Up::Z, path.points.len())
    );
    for (a, b) in upright.points.iter().zip(&path.points) {
        let (a, b) = (&a.orientations[0], &b.orientations[0]);
        assert!((a.roll - b.roll).abs() < 1e-9, "{} {}", a.roll, b.roll);
    }
    let (far, off) = errors(&upright, &turned);
    assert!(far <= 0.0101 && off <= 0.505, "{far} {off}");
    let space = Space {
        half_size: 100.0,
        ..Space::default()
    };
    let options = Options {
        space: Some(space),
        ..TOLERANCE.into()
    };
    let path = fit(&poses, None, 25.0, &options, &mut |_, _| true)
        .unwrap()
        .path;
    assert_eq!(path.space, space);
}

/// Nanoseconds taken for seconds, a frame far away: refused before any work is done.
#[test]
fn poses_that_span_too_many_frames_are_refused_at_once() {
    let mut random = Random(8);
    let poses = flight(&mut random, 4, 100);
    let refused = |seconds: &[f64], fps: f64| {
        let poses = &poses[..seconds.len()];
        let mut asked = 0;
        let mut progress = |_, _| {
            asked += 1;
            true
        };
        let error = fit(poses, Some(seconds), fps, &TOLERANCE.into(), &mut progress).unwrap_err();
        assert_eq!(asked, 0, "{error}");
        error
    };
    let evenly = |step: f64| (0..100).map(move |k| f64::from(k) * step);
    let error = refused(&evenly(33e6).collect::<Vec<_>>(), 25.0);
    assert!(matches!(error, Error::Limit(TooMany::PoseSpan(_))));
    assert_eq!(
        error.to_string(),
        "the times of the poses span 81675000000 frames, at most 100000000 are allowed: check \
         their unit, times are seconds"
    );
    for seconds in [[0.0, 1.0, 1e9], [0.0, 1.0, f64::INFINITY], [0.0, 1.0, 1e7]] {
        refused(&seconds, 25.0);
    }
    refused(&[0.0, 1.0, 1000.0], 1e5);
    // Just below, a path is made: of few points, as the poses are few.
    let seconds = [0.0, 1.0, 2.0, 1e8 - 1.0];
    let made = fit(
        &poses[..4],
        Some(&seconds),
        1.0,
        &TOLERANCE.into(),
        &mut |_, _| true,
    );
    let frames = Timeline::new(&made.unwrap().path).unwrap().frame_count();
    assert_eq!(frames, Ok(100_000_000));
}
