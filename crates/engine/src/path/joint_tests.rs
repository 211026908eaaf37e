//! Joints on straight paths, where the speed is the difference of two places; each has many frames,
//! so that their rounding is small.

use glam::DVec3;

use super::*;
use crate::limits::SPEEDS;
use crate::path::test_support::Random;
use crate::path::{
    CameraPath, CurveKind, Ease, EaseKind, PacePart, PaceSource, Sampler, SupportPoint, Timeline,
};

/// Straight sections of these lengths and speeds.
fn straight(lengths: &[f64], speeds: &[[f64; SPEEDS]]) -> CameraPath {
    let mut x = 0.0;
    let mut points = vec![SupportPoint::new(DVec3::ZERO)];
    for (k, length) in lengths.iter().enumerate() {
        x += length;
        points[k].orientations[0].speeds = speeds[k];
        points.push(SupportPoint::new(DVec3::new(x, 0.0, 0.0)));
    }
    let mut path = CameraPath {
        points: points.into(),
        curve: CurveKind::Linear,
        ..CameraPath::default()
    };
    path.base_frames.movement = 1e6;
    path
}

/// Ten speeds from one to another, in even steps.
fn ramp(from: f64, to: f64) -> [f64; SPEEDS] {
    std::array::from_fn(|k| from + (to - from) * k as f64 / INTERVALS as f64)
}

fn random_speed(random: &mut Random) -> f64 {
    match (random.unit() * 6.0) as u32 {
        0 => 1.0,
        1 => 100.0,
        _ => (100.0 * random.unit()).max(1.0),
    }
}

/// Random speeds, each ten beginning with the last of those before.
fn joined(random: &mut Random, count: usize) -> Vec<[f64; SPEEDS]> {
    let mut last = random_speed(random);
    let ten = (0..count).map(|_| {
        let mut ten = std::array::from_fn(|_| random_speed(random));
        ten[0] = last;
        last = ten[INTERVALS];
        ten
    });
    ten.collect()
}

/// The acceleration just before and just behind the end of a section, by second differences of
/// places, extrapolated to the end; and the largest nearby.
fn around(path: &CameraPath, section: usize) -> [f64; 3] {
    let timeline = Timeline::new(path).unwrap();
    let sampler = Sampler::new(path, &timeline).unwrap();
    let of = |section: usize| timeline.section(section).frames as f64;
    let least = of(section).min(of(section + 1));
    let key = sampler.first_frame(section + 1) as f64 - 1.0;
    let x = |frame: f64| sampler.pose(frame).unwrap().vrp[0];
    let bend = |frame: f64, h: f64| (x(frame + h) - 2.0 * x(frame) + x(frame - h)) / (h * h);
    let h = least / 2000.0;
    let end = |side: f64| 2.0 * bend(key + side * h, h) - bend(key + side * 2.0 * h, h);
    let steps = (1..200).map(|k| f64::from(k) * least / 2000.0);
    let near = steps.flat_map(|away| [bend(key - away, h), bend(key + away, h)]);
    // What is below the rounding of places is none.
    let least_seen = 1e-5 * x(key + 1.0).abs() / (least * least);
    let most = near.fold(least_seen, |most: f64, bend| most.max(bend.abs()));
    [end(-1.0), end(1.0), most]
}

#[test]
fn the_acceleration_goes_on_where_facing_speeds_are_equal() {
    let mut random = Random(71);
    let mut worst: f64 = 0.0;
    for round in 0..300 {
        let count = 2 + round % 4;
        let lengths: Vec<f64> = (0..count)
            .map(|_| {
                if round % 3 == 0 {
                    0.25
                } else {
                    0.05 + 0.2 * random.unit()
                }
            })
            .collect();
        let speeds: Vec<_> = match round {
            0..40 => {
                let step = 60.0 / count as f64;
                let at = |k: usize| 20.0 + step * k as f64;
                (0..count).map(|k| ramp(at(k), at(k + 1))).collect()
            }
            _ => joined(&mut random, count),
        };
        let path = straight(&lengths, &speeds);
        let timeline = Timeline::new(&path).unwrap();
        let sections = (0..count).map(|k| timeline.section(k).frames);
        assert_eq!(timeline.frame_count().unwrap(), 1 + sections.sum::<usize>());
        for section in 0..count - 1 {
            let [before, after, most] = around(&path, section);
            let jump = (after - before).abs() / most;
            worst = worst.max(jump);
            assert!(
                jump < 2e-3,
                "{round} {section}: {before} {after}, up to {most}"
            );
        }
    }
    println!("worst jump of the acceleration, in shares of the largest nearby: {worst:.1e}");
}

/// To rounding, in frames that come from the mean speed of the finished curve; and no slope at a
/// joint needs to be clipped.
#[test]
fn slopes_at_a_joint_agree_in_frames_and_stay_between_the_speeds() {
    let mut random = Random(72);
    for round in 0..20_000 {
        let speeds = joined(&mut random, 3);
        let lengths = [0; 3].map(|_| 0.01 + random.unit());
        let mut path = straight(&lengths, &speeds);
        if round % 5 == 0 {
            let own = &mut path.points[1].orientations[0].own;
            *own = own.with(|own| own.frames = 77).unwrap();
        }
        let timeline = Timeline::new(&path).unwrap();
        let slope = |section: usize, side: usize| {
            let ends = timeline.curve_ends(&path, section).unwrap();
            let frames = match path.points[section].orientations[0].own.frames {
                0 => timeline.unrounded_frames(&path, section),
                fixed => f64::from(fixed),
            };
            let CurveEnd::Slope(slope) = ends[side] else {
                panic!("no joint: {ends:?}");
            };
            let inner = slope / (3 * INTERVALS) as f64;
            let [at, next] = match side {
                0 => [speeds[section][0], speeds[section][1]],
                _ => [speeds[section][INTERVALS], speeds[section][INTERVALS - 1]],
            };
            let inner = at + if side == 0 { inner } else { -inner };
            let room = at.min(next) - 1e-12..=at.max(next) + 1e-12;
            assert!(room.contains(&inner), "{round}: {inner} in {speeds:?}");
            slope / frames
        };
        for section in 0..2 {
            let (before, after) = (slope(section, 1), slope(section + 1, 0));
            let size = before.abs().max(after.abs());
            assert!(
                (before - after).abs() <= 1e-12 * size,
                "{round}: {before} {after}"
            );
        }
    }
}

/// Evenly timed sections have the slope of Catmull and Rom at their joint.
#[test]
fn in_even_time_a_joint_is_as_within_a_section() {
    let first = [20.0, 30.0, 40.0, 50.0, 60.0, 70.0, 60.0, 50.0, 40.0, 45.0];
    let mut second = first;
    second.reverse();
    second[1] = 52.0;
    // The sums of the ten, the ends halved, are equal.
    second[5] -= 12.0;
    let path = straight(&[0.2, 0.2], &[first, second]);
    let timeline = Timeline::new(&path).unwrap();
    let frames = timeline.unrounded_frames(&path, 0);
    let straight = 0.2 * 1e6 * 50.0 * 9.0 / (first.iter().sum::<f64>() - 32.5);
    let CurveEnd::Slope(slope) = timeline.curve_ends(&path, 0).unwrap()[1] else {
        panic!("no joint");
    };
    let wanted = (52.0 - 40.0) / (2.0 * straight / 9.0);
    assert!((slope / frames / wanted - 1.0).abs() < 1e-12);
}

#[test]
fn elsewhere_the_facing_speeds_shape_the_ends_as_ever() {
    let (up, down) = (ramp(20.0, 50.0), ramp(50.0, 30.0));
    let ends = |path: &CameraPath, section| {
        let timeline = Timeline::new(path).unwrap();
        timeline.curve_ends(path, section).unwrap()
    };
    let facing = |path: &CameraPath| [ends(path, 0)[1], ends(path, 1)[0]];
    let mut path = straight(&[0.2, 0.1], &[up, down]);
    assert_eq!(facing(&path), [CurveEnd::Slope(0.0); 2]);
    assert_eq!([ends(&path, 0)[0], ends(&path, 1)[1]], [CurveEnd::Free; 2]);
    path.points[1].orientations[0].hold = 1;
    assert_eq!(facing(&path), [50.0, 50.0].map(CurveEnd::Facing));
    path.points[1].orientations[0].hold = 0;
    path.points[1].orientations[0].speeds[0] = 50.001;
    assert_eq!(facing(&path), [50.001, 50.0].map(CurveEnd::Facing));
    let alone = straight(&[0.2], &[up]);
    assert_eq!(ends(&alone, 0), [CurveEnd::Free; 2]);
}

/// A section of one speed keeps it, whatever is beside it.
#[test]
fn constant_speed_stays_constant() {
    let mut random = Random(73);
    for round in 0..500 {
        let mut speeds = joined(&mut random, 3);
        speeds[1] = [speeds[1][0]; SPEEDS];
        speeds[2][0] = speeds[1][0];
        let mut path = straight(&[0.1, 0.2, 0.3], &speeds);
        if round % 2 == 0 {
            let ease = Ease {
                kind: EaseKind::Parabolic,
                rise: 0.7,
                fall: 0.0,
                cruise: speeds[1][0],
            };
            let own = &mut path.points[0].orientations[0].own;
            *own = own.with(|own| own.pace = Pace::Ease(ease)).unwrap();
        }
        let section = Timeline::new(&path).unwrap().section(1);
        assert!(section.constant_speed, "{round}");
        let alone = SpeedCurve::new(&speeds[1], [CurveEnd::Free; 2]).mean();
        assert_eq!(section.mean_speed, alone);
    }
}

/// Ten speeds go on with the acceleration of an ease, but at most as steeply as they rise themselves.
#[test]
fn ten_speeds_take_over_the_acceleration_of_another_pace() {
    for (cruise, rise, goes_on) in [(60.0, 0.8, true), (40.0, 1.0, true), (90.0, 0.9, false)] {
        let mut path = straight(&[0.2, 0.3], &[[50.0; SPEEDS], ramp(cruise, 100.0)]);
        let ease = Ease {
            kind: EaseKind::Parabolic,
            rise,
            fall: 0.0,
            cruise,
        };
        // Still rising where it ends.
        let part = PacePart {
            of: PaceSource::Ease(ease),
            from: 0.0,
            to: rise,
        };
        let own = &mut path.points[0].orientations[0].own;
        *own = own.with(|own| own.pace = Pace::Part(part)).unwrap();
        let [before, after, most] = around(&path, 0);
        let jump = (after - before) / most;
        assert!(jump < 2e-3 && (jump > -2e-3) == goes_on, "{cruise}: {jump}");
    }
}
