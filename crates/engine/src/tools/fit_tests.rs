use super::*;
use crate::math::quaternion::exp;
use crate::path::test_support::Random;
use crate::path::{Sampler, Timeline};

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
    fit(poses, None, 25.0, TOLERANCE, &mut |_, _| true).unwrap()
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
    let path = fit(&chosen, Some(&seconds), 25.0, TOLERANCE, &mut |_, _| true).unwrap();
    assert!(path.points.len() <= 12);
    let (far, off) = errors(&path, &poses);
    assert!(far <= 0.012 && off <= 0.6, "{far} {off}");
}

#[test]
fn poses_that_are_no_path_are_refused() {
    let mut random = Random(6);
    let poses = flight(&mut random, 3, 50);
    let refused = |poses: &[Pose], seconds: Option<&[f64]>, tolerance: Tolerance| {
        let error = fit(poses, seconds, 25.0, tolerance, &mut |_, _| true).unwrap_err();
        error.to_string()
    };
    assert!(refused(&poses[..2], None, TOLERANCE).contains("three"));
    assert!(refused(&[poses[0]; 9], None, TOLERANCE).contains("same"));
    let mut bad = poses.clone();
    bad[4].vrp[1] = f64::NAN;
    assert!(refused(&bad, None, TOLERANCE).starts_with("pose 5: "));
    bad[4] = poses[4];
    bad[3].vup = bad[3].vpn;
    assert!(refused(&bad, None, TOLERANCE).starts_with("pose 4: "));
    assert!(refused(&poses[..3], Some(&[0.0, 1.0, 1.0]), TOLERANCE).contains("increase"));
    for position in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let tolerance = Tolerance {
            position,
            ..TOLERANCE
        };
        assert!(refused(&poses, None, tolerance).contains("greater than 0"));
    }
    let cancelled = fit(&poses, None, 25.0, TOLERANCE, &mut |_, _| false);
    assert!(cancelled.unwrap_err().to_string().contains("cancelled"));
}

/// Cuts, shaking by more than the tolerance and turns from one frame to the next are no
/// noise: the poses themselves are met, or the fit says which is not.
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
    // Between whole frames the view turns back and forth.
    let seconds: Vec<f64> = (0..flight.len()).map(|k| k as f64 / 60.0).collect();
    let mut poses = flight;
    for pose in poses.iter_mut().step_by(2) {
        pose.vpn[1] += 0.3;
    }
    let refused = fit(&poses, Some(&seconds), 25.0, TOLERANCE, &mut |_, _| true);
    let error = refused.unwrap_err().to_string();
    assert!(
        error.starts_with("pose ") && error.contains("times that"),
        "{error}"
    );
}
