use super::*;
use crate::path::OrientationOverrides as Own;
use crate::path::insertion::tests::random_path;
use crate::path::test_support::Random;
use crate::path::{Plan, Sampler, SupportPoint};
use glam::DVec3;

fn set(path: &mut CameraPath, fixed: &[Fixed]) {
    for fixed in fixed {
        fixed.apply(path).unwrap();
    }
}

#[test]
fn a_locked_section_keeps_its_frames() {
    let points = [-0.5, 0.0, 0.1, 0.9];
    let mut path = CameraPath {
        points: points
            .map(|x| SupportPoint::new(DVec3::new(x, 0.0, 0.5)))
            .into(),
        ..CameraPath::default()
    };
    let lock = |path: &mut CameraPath, at: usize| {
        let orientation = &mut path.points[at].orientations[0];
        orientation.own = orientation.own.with(|own| own.locked = true).unwrap();
    };
    let fit = |path: &CameraPath, frames: usize| {
        let fit = |timeline: &Timeline| fit_frames(path, timeline, 0, 3, frames);
        Plan::new().timeline(path, fit).unwrap()
    };
    let before: Vec<usize> = Plan::new()
        .timeline(&path, |timeline| {
            (0..3).map(|at| timeline.section(at).frames).collect()
        })
        .unwrap();
    lock(&mut path, 1);
    let fixed = fit(&path, 1000).unwrap();
    let points: Vec<usize> = fixed.iter().map(|fixed| fixed.point).collect();
    assert_eq!(points, [0, 2]);
    let sum: usize = fixed.iter().map(|fixed| fixed.frames as usize).sum();
    assert_eq!(1 + sum + before[1], 1000);
    // Fewer than it leaves are refused, and any other number where all are locked.
    let least = 1 + before[1] + 2;
    assert!(fit(&path, least).is_ok() && fit(&path, least - 1).is_err());
    lock(&mut path, 0);
    lock(&mut path, 2);
    let whole = 1 + before.iter().sum::<usize>();
    assert!(fit(&path, whole).unwrap().is_empty());
    assert!(fit(&path, whole - 1).is_err() && fit(&path, whole + 1).is_err());
}

#[test]
fn ten_thousand_paths_have_exactly_so_many_frames() {
    let mut random = Random(51);
    for round in 0..10_000 {
        let mut path = random_path(&mut random, round);
        if round % 4 == 0 {
            // Coincident points: sections in which nothing changes.
            let mut twin = path.points[0].clone();
            twin.orientations.truncate(1);
            path.points.insert(1, twin.clone());
            path.points[0] = twin;
        }
        let timeline = Timeline::new(&path).unwrap();
        let last = path.points.len() - 1;
        let fit = |frames| fit_frames(&path, &timeline, 0, last, frames);
        let said = fit(0).unwrap_err().to_string();
        let least: usize = said.rsplit(' ').next().unwrap().parse().unwrap();
        assert!(fit(least - 1).is_err());
        let frames = match round % 3 {
            0 => least,
            _ => least + (random.unit() * 2000.0) as usize,
        };
        let fixed = fit(frames).unwrap();
        set(&mut path, &fixed);
        let timeline = Timeline::new(&path).unwrap();
        assert_eq!(timeline.frame_count().unwrap(), frames, "round {round}");
        let sampler = Sampler::new(&path, &timeline).unwrap();
        assert_eq!(sampler.frame_count(), frames);
    }
}

#[test]
fn frames_go_by_largest_remainder() {
    let frames = |weights: &[f64], frames: usize| {
        let one = Fixed {
            point: 0,
            orientation: 0,
            frames: 1,
        };
        let mut fixed = vec![one; weights.len()];
        share(&mut fixed, &mut weights.to_vec(), frames).unwrap();
        fixed.iter().map(|fixed| fixed.frames).collect::<Vec<_>>()
    };
    // Hare's method: 4.8, 3.6, 1.6 of 10.
    assert_eq!(frames(&[48.0, 36.0, 16.0], 10), [5, 4, 1]);
    assert_eq!(frames(&[1.0, 1.0, 1.0], 5), [2, 2, 1]);
    assert_eq!(frames(&[1.0, 1.0, 1.0, 1.0], 10), [3, 3, 2, 2]);
    assert_eq!(frames(&[0.0, 0.0], 5), [3, 2]);
    assert_eq!(frames(&[f64::INFINITY, 1.0], 5), [4, 1]);
    assert_eq!(frames(&[5.0, 0.0, 1e-300], 3), [1, 1, 1]);
    // One each for the light ones, the rest by weight.
    assert_eq!(frames(&[0.001, 6.0, 0.5, 3.0], 11), [1, 6, 1, 3]);
    assert_eq!(
        frames(&[3.0, 1.0], 99_999_992).iter().sum::<u32>(),
        99_999_992
    );
}

/// From twice as many frames as sections on, each section's frames are within one of its share.
#[test]
fn sections_have_one_mean_speed() {
    let points = [-0.9, -0.897, -0.6, -0.59, 0.1, 0.9];
    let path = CameraPath {
        points: points
            .map(|x| SupportPoint::new(DVec3::new(x, 0.0, 0.5)))
            .into(),
        curve: crate::path::CurveKind::Linear,
        ..CameraPath::default()
    };
    let timeline = Timeline::new(&path).unwrap();
    for frames in [11, 50, 1000, 20_000, 1_000_000] {
        let fixed = fit_frames(&path, &timeline, 0, 5, frames).unwrap();
        let mut speeds = fixed.iter().zip(points.windows(2)).map(|(fixed, ends)| {
            let share = (ends[1] - ends[0]) * (frames - 1) as f64 / 1.8;
            (f64::from(fixed.frames), share)
        });
        assert!(
            speeds.all(|(frames, share)| (frames - share).abs() <= 1.0 || frames == 1.0),
            "{frames}: {fixed:?}"
        );
    }
}

fn even(points: &[f64]) -> CameraPath {
    let points = points.iter();
    CameraPath {
        points: points
            .map(|&x| SupportPoint::new(DVec3::new(x, 0.0, 0.5)))
            .collect::<Vec<_>>()
            .into(),
        curve: crate::path::CurveKind::Linear,
        ..CameraPath::default()
    }
}

/// Brings a whole path to so many frames; those that its sections then have.
fn brought(path: &mut CameraPath, frames: usize) -> Vec<u32> {
    let timeline = Timeline::new(path).unwrap();
    let last = path.points.len() - 1;
    let fixed = fit_frames(path, &timeline, 0, last, frames).unwrap();
    set(path, &fixed);
    fixed.iter().map(|fixed| fixed.frames).collect()
}

#[test]
fn after_a_point_moved_the_total_is_shared_anew() {
    let mut path = even(&[-0.9, -0.3, 0.3, 0.9]);
    assert_eq!(brought(&mut path, 301), [100, 100, 100]);
    path.points[1].position.x = -0.8;
    assert_eq!(brought(&mut path, 301), [17, 183, 100]);
    // One that has twice the speed takes half the time, whatever it had.
    path.points[2].orientations[0].speeds = [100.0; 10];
    let own = &mut path.points[1].orientations[0].own;
    *own = own.with(|own| own.frames = 7).unwrap();
    let shared = brought(&mut path, 1001);
    for (frames, time) in shared.iter().zip([0.1, 1.1, 0.3]) {
        assert!(
            (f64::from(*frames) - 1000.0 * time / 1.5).abs() <= 1.0,
            "{shared:?}"
        );
    }
    // In proportion to what they have: one that was changed by hand stays slower.
    path.points[0].position.x = -0.9;
    let timeline = Timeline::new(&path).unwrap();
    let double = scale_frames(&path, &timeline, 0, 3, 2001).unwrap();
    assert!(
        double
            .iter()
            .zip(&shared)
            .all(|(new, old)| new.frames == 2 * old)
    );
}

/// Random points moved at random: the mean speeds are within a frame of one another.
#[test]
fn moved_points_leave_one_mean_speed() {
    let mut random = Random(54);
    for round in 0..300 {
        let mut x = -0.9;
        let points: Vec<f64> = (0..3 + round % 9)
            .map(|_| {
                x += 0.001 + random.unit() * random.unit() / 6.0;
                x
            })
            .collect();
        let mut path = even(&points);
        let sections = points.len() - 1;
        brought(&mut path, 500);
        for point in 0..points.len() {
            path.points[point].position.y = random.unit();
        }
        let frames = 1 + sections * 2 + (random.unit() * 5000.0) as usize;
        let shared = brought(&mut path, frames);
        let places = || path.points.iter().map(|point| point.position);
        let ways: Vec<f64> = places()
            .zip(places().skip(1))
            .map(|(a, b)| a.distance(b))
            .collect();
        // What has a single frame would have less; the others share what that leaves.
        let more = |(frames, _): &(&u32, &f64)| **frames > 1;
        let all: f64 = shared
            .iter()
            .zip(&ways)
            .filter(more)
            .map(|(_, way)| way)
            .sum();
        let left: u32 = shared.iter().filter(|frames| **frames > 1).sum();
        for (frames, way) in shared.iter().zip(&ways).filter(more) {
            let share = f64::from(left) * way / all;
            assert!(
                (f64::from(*frames) - share).abs() <= 1.0,
                "{round}: {shared:?}"
            );
        }
    }
}

/// What was recorded or retimed has its own times, beside which the others share anew.
#[test]
fn sections_that_count_by_their_frames_keep_their_proportion() {
    let mut path = even(&[-0.9, -0.5, -0.1, 0.3, 0.9]);
    let own = |path: &mut CameraPath, at: usize, change: &dyn Fn(&mut Own)| {
        let own = &mut path.points[at].orientations[0].own;
        *own = own.with(change).unwrap();
    };
    for (at, frames) in [(0, 30), (1, 90), (2, 70), (3, 10)] {
        own(&mut path, at, &|own| own.frames = frames);
    }
    own(&mut path, 0, &|own| own.curve_time = Some(30.0));
    let turns = crate::path::Velocities {
        reach: DVec3::ZERO,
        leave: DVec3::ZERO,
    };
    for at in [1, 2] {
        own(&mut path, at, &|own| own.velocities = Some(turns));
    }
    assert_eq!(brought(&mut path.clone(), 201), [30, 90, 32, 48]);
    assert_eq!(brought(&mut path, 401), [60, 180, 64, 96]);
    own(&mut path, 0, &|own| own.locked = true);
    assert_eq!(brought(&mut path, 741), [360, 128, 192]);
}

#[test]
fn a_path_that_has_so_many_stays_as_it_is() {
    let mut random = Random(52);
    for round in 0..500 {
        let mut path = random_path(&mut random, round);
        let last = path.points.len() - 1;
        let timeline = Timeline::new(&path).unwrap();
        let fixed = fit_frames(&path, &timeline, 0, last, 500).unwrap();
        set(&mut path, &fixed);
        let timeline = Timeline::new(&path).unwrap();
        assert_eq!(fit_frames(&path, &timeline, 0, last, 500).unwrap(), fixed);
    }
}

#[test]
fn a_range_changes_nothing_outside_it() {
    let mut random = Random(53);
    for round in 0..300 {
        let mut path = random_path(&mut random, round);
        path.points.push(SupportPoint::new(glam::DVec3::ONE));
        let timeline = Timeline::new(&path).unwrap();
        let count = path.points.len();
        let (a, b) = (round % count, (round / 5) % count);
        let fitted = fit_frames(&path, &timeline, a, b, 300);
        if a > b && !path.closed {
            assert!(fitted.is_err());
            continue;
        }
        let inside = |point: usize| {
            if a <= b {
                (a..=b).contains(&point)
            } else {
                point >= a || point <= b
            }
        };
        for fixed in fitted.unwrap_or_default() {
            let last = path.points[fixed.point].orientations.len() - 1;
            let whole = path.closed && (a, b) == (0, count - 1);
            assert!(inside(fixed.point) && (whole || fixed.point != b || fixed.orientation < last));
        }
    }
    let path = CameraPath::default();
    let timeline = Timeline::new(&path).unwrap();
    assert!(fit_frames(&path, &timeline, 0, 2, 100).is_err());
    assert!(fit_frames(&path, &timeline, 0, 0, 2).is_err());
    assert!(fit_frames(&path, &timeline, 0, 1, MAX_FRAMES + 1).is_err());
    assert_eq!(fit_frames(&path, &timeline, 0, 0, 1).unwrap(), []);
}
