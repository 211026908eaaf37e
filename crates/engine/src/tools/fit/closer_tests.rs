//! Poses that a path gave: how few points they come back with. The tolerance is looked at pose by pose
//! with what a sampler gives, not by anything of the fit.

use super::super::*;
use super::{errors, sampled};
use crate::path::test_support::Random;

/// Random paths of so many points, one after the other.
const COUNTS: std::ops::Range<usize> = 3..16;

/// Points that wander (even numbers) or lie anywhere in the cube, views near the way or anywhere,
/// and T/C/B of their own at every third one.
fn random_path(random: &mut Random, number: usize) -> CameraPath {
    let count = COUNTS.start + number % COUNTS.len();
    let mut signed = |most: f64| most * (2.0 * random.unit() - 1.0);
    let (mut at, mut heading) = (DVec3::ZERO, signed(3.0));
    let points = (0..count).map(|_| {
        let mut view = DVec3::new(signed(1.0), signed(0.5), signed(1.0));
        if number.is_multiple_of(2) {
            heading += signed(0.8);
            at += DVec3::new(heading.sin(), signed(0.3), heading.cos()) * (0.6 + signed(0.2));
            view = DVec3::new(heading.sin(), 0.0, heading.cos()) + 0.5 * view;
        } else {
            at = DVec3::new(signed(1.0), signed(1.0), signed(1.0));
        }
        let mut point = SupportPoint::new(at);
        point.orientations[0] = Orientation {
            target: Target::Relative(view),
            roll: signed(15.0),
            zoom: 30.0 + signed(10.0),
            ..Orientation::default()
        };
        point
    });
    let mut path = CameraPath {
        points: points.collect(),
        ..CameraPath::default()
    };
    path.base_frames.movement *= 1.0 + signed(0.6);
    path
}

#[test]
fn a_path_comes_back_with_few_points() {
    let paths = std::env::var("VIDES_PATHS").map_or(26, |text| text.parse().unwrap());
    let mut random = Random(41);
    let (mut sum, mut worst) = (0.0, 0.0_f64);
    let (mut missed, mut took) = (0, 0.0);
    for number in 0..paths {
        let path = random_path(&mut random, number);
        let poses = sampled(&path);
        let (low, high) = poses.iter().fold(
            (DVec3::INFINITY, DVec3::NEG_INFINITY),
            |(low, high), pose| (low.min(pose.vrp.into()), high.max(pose.vrp.into())),
        );
        let tolerance = Tolerance {
            position: 1e-3 * low.distance(high),
            angle: 0.5,
        };
        let begin = std::time::Instant::now();
        let fitted = fit(&poses, None, 25.0, &tolerance.into(), &mut |_, _| true).unwrap();
        took += begin.elapsed().as_secs_f64();
        let (far, off) = errors(&fitted.path, &poses);
        assert!(
            far <= 1.001 * tolerance.position && off <= 0.5005,
            "{number}: {far} {off}"
        );
        let (is, was) = (fitted.path.points.len() as f64, path.points.len() as f64);
        sum += is / was;
        worst = worst.max(is / was);
        if is > (was + 2.0).max(1.5 * was) {
            missed += 1;
        }
        println!(
            "{number}: {was} {is} {} poses, {:.3} {off:.3}",
            poses.len(),
            far / tolerance.position
        );
    }
    let mean = sum / paths as f64;
    println!(
        "{paths} paths: {mean:.3} in the mean, {worst:.3} at most, {missed} beyond; {took:.2} s"
    );
    assert!(mean <= 1.25 && missed == 0, "{mean} {missed}");
}
