use glam::DVec3;

use super::*;
use crate::math::orientation::quaternion_from_view;
use crate::path::insertion::tests::random_path;
use crate::path::test_support::Random;
use crate::path::{Pose, SupportPoint};
use crate::tools::check::{Limits, OFF};

fn limits(all: &[(FindingKind, f64)]) -> Limits {
    let mut limits = Limits::default();
    for kind in FindingKind::all() {
        limits.set(kind, OFF).unwrap();
    }
    for (kind, limit) in all {
        limits.set(*kind, *limit).unwrap();
    }
    limits
}

fn request(all: &[(FindingKind, f64)]) -> Request {
    Request {
        limits: limits(all),
        fps: 25.0,
        points: None,
        seconds: 0.0,
    }
}

fn line(length: f64) -> CameraPath {
    CameraPath {
        points: [0.0, length]
            .map(|x| SupportPoint::new(DVec3::new(x, 0.0, 0.0)))
            .into(),
        ..CameraPath::default()
    }
}

fn sampler(path: &CameraPath) -> Sampler {
    Sampler::new(path, &Timeline::new(path).unwrap()).unwrap()
}

#[test]
fn it_ends_when_it_is_told_at_any_section() {
    let path = random_path(&mut Random(3), 1);
    let wanted = request(&[(FindingKind::Speed, 1.0), (FindingKind::Acceleration, 1.0)]);
    let mut all = 0;
    retime(&path, &wanted, &mut |_, _| {
        all += 1;
        true
    })
    .unwrap();
    assert!(all >= 2 * path.points.len() - 2, "{all}");
    for last in 1..=all {
        let mut asked = 0;
        let ended = retime(&path, &wanted, &mut |_, _| {
            asked += 1;
            asked < last
        });
        assert_eq!(ended.unwrap_err(), Invalid::Cancelled.into());
        assert_eq!(asked, last);
    }
}

/// From rest to rest with speed v and acceleration a: L/v + v/a, or 2√(L/a), to a frame.
#[test]
fn a_straight_line_takes_the_trapezoid() {
    for (length, v, a) in [
        (1.0, 0.5, 1.0),
        (0.2, 5.0, 1.0),
        (3.0, 1.0, 0.5),
        (1.7, 0.3, 2.0),
    ] {
        let wanted = request(&[(FindingKind::Speed, v), (FindingKind::Acceleration, a)]);
        let made = retime(&line(length), &wanted, &mut |_, _| true).unwrap();
        let known = if length > v * v / a {
            length / v + v / a
        } else {
            2.0 * (length / a).sqrt()
        };
        // The last pose has a frame of its own.
        let frames = made.seconds * 25.0 - 1.0;
        println!("{length} {v} {a}: {frames} known {} keys", known * 25.0);
        assert!(frames >= known * 25.0 - 1e-6 && frames <= known * 25.0 + 1.0);
    }
}

/// From rest to rest with jerk j, too: L/v + v/a + a/j where both v and a are reached, (32 L/j)^⅓
/// where neither is; 1.05 of it and a frame, and third differences over frames within the limit.
#[test]
fn a_straight_line_with_jerk_takes_about_the_shortest() {
    for (length, v, a, j) in [
        (2.0, 0.5, 0.5, 1.0),
        (1.0, 0.3, 1.0, 4.0),
        (0.5, 50.0, 50.0, 2.0),
        (1.0, 0.2, 0.3, 500.0),
    ] {
        let wanted = request(&[
            (FindingKind::Speed, v),
            (FindingKind::Acceleration, a),
            (FindingKind::Jerk, j),
        ]);
        let made = retime(&line(length), &wanted, &mut |_, _| true).unwrap();
        let known = if v > 10.0 {
            (32.0 * length / j).cbrt()
        } else {
            length / v + v / a + a / j
        };
        let seconds = made.seconds - 1.0 / 25.0;
        assert!(
            seconds >= 0.99 * known - 1.0 / 25.0 && seconds <= 1.05 * known + 1.0 / 25.0,
            "{length} {v} {a} {j}: {seconds} s, known {known} s"
        );
        assert!(greatest_jerk(&made.path, 25.0) <= 1.001 * j);
    }
}

/// The greatest third difference of places at whole frames, at rest before and behind.
fn greatest_jerk(path: &CameraPath, fps: f64) -> f64 {
    let sampler = sampler(path);
    let last = sampler.frame_count() as f64;
    let place = |frame: i32| -> DVec3 {
        let frame = f64::from(frame).clamp(1.0, last);
        sampler.pose(frame).unwrap().vrp.into()
    };
    let frames = -2..=last as i32 + 2;
    let third = |k: i32| place(k + 1) - 3.0 * place(k) + 3.0 * place(k - 1) - place(k - 2);
    let lengths = frames.map(|k| third(k).length() / path.space.half_size * fps.powi(3));
    lengths.fold(0.0, f64::max)
}

/// A jerk within its limit on paths of several sections, and in a given time.
#[test]
fn random_paths_hold_the_jerk() {
    let mut random = Random(67);
    let wanted = request(&[
        (FindingKind::Speed, 1.0),
        (FindingKind::Acceleration, 2.0),
        (FindingKind::Jerk, 8.0),
    ]);
    for round in 0..30 {
        let path = random_path(&mut random, round);
        let made = match retime(&path, &wanted, &mut |_, _| true) {
            Ok(made) => made,
            Err(error) => panic!("round {round}: {error}"),
        };
        let again = Request {
            seconds: (made.seconds * 1.3 * 25.0).round() / 25.0,
            ..wanted
        };
        let slower = retime(&path, &again, &mut |_, _| true).unwrap();
        assert!((slower.seconds - again.seconds).abs() < 1e-9);
        let plain = request(&[(FindingKind::Speed, 1.0), (FindingKind::Acceleration, 2.0)]);
        let plain = retime(&path, &plain, &mut |_, _| true).unwrap();
        let times = [made.seconds, plain.seconds];
        assert!(times[0] <= 2.0 * times[1], "round {round}: {times:?}");
        for made in [made, slower] {
            let found = check_of(&made.path, &again.limits);
            assert!(found.is_empty(), "round {round}: {found:?}");
        }
    }
}

fn check_of(path: &CameraPath, limits: &Limits) -> Vec<crate::tools::check::Finding> {
    let against = crate::tools::check::CheckContext {
        fps: 25.0,
        space: None,
        object: None,
        limits: *limits,
    };
    crate::tools::check::check(path, &against).unwrap()
}

/// Where the camera is at a place it looks where it looked before.
fn same_views(before: &CameraPath, after: &CameraPath, round: usize) {
    let (a, b) = (
        Timeline::new(before).unwrap(),
        Timeline::new(after).unwrap(),
    );
    let (s, t) = (sampler(before), sampler(after));
    for (x, y) in s.courses().zip(t.courses()) {
        assert_eq!(x.number_and_frames().0, y.number_and_frames().0);
        let number = x.number_and_frames().0;
        assert!((a.section(number).duration() - b.section(number).duration()).abs() < 1e-9);
        let shares: Vec<f64> = (0..=40).map(|k| f64::from(k) / 40.0).collect();
        let mut all = Vec::new();
        x.along(&shares, &mut |along| all.push(along)).unwrap();
        let mut k = 0;
        y.along(&shares, &mut |along| {
            let was = &all[k];
            k += 1;
            assert!((along.place - was.place).length() < 1e-9, "round {round}");
            let turned = super::super::course::turned(was.turn, along.turn).length();
            assert!(turned < 0.05_f64.to_radians(), "round {round}: {turned}");
            assert!((along.zoom - was.zoom).abs() < 0.05, "round {round}");
        })
        .unwrap();
    }
}

/// The greatest share of speed, acceleration, turning, turning acceleration at 20 samples a frame:
/// differences over a frame, and the acceleration over a twentieth of one.
fn peaks(path: &CameraPath, limits: &Limits, fps: f64) -> [f64; 5] {
    let sampler = sampler(path);
    let frames = sampler.frame_count();
    let count = 20 * (frames - 1) + 1;
    let poses: Vec<Pose> = (0..count)
        .map(|k| {
            sampler
                .pose((1.0 + k as f64 / 20.0).min(frames as f64))
                .unwrap()
        })
        .collect();
    let place: Vec<DVec3> = poses.iter().map(|pose| pose.vrp.into()).collect();
    let turn: Vec<_> = poses
        .iter()
        .map(|pose| quaternion_from_view(pose.view(), pose.up()))
        .collect();
    let get = |kind| limits.get(kind);
    let mut found = [0.0_f64; 5];
    let half = path.space.half_size;
    for k in 0..count.saturating_sub(20) {
        let speed = (place[k + 20] - place[k]).length() / half * fps;
        found[0] = found[0].max(speed / get(FindingKind::Speed));
        let turned = crate::planner::course::turned(turn[k], turn[k + 20]);
        found[2] = found[2].max(turned.length().to_degrees() * fps / get(FindingKind::Turning));
        if k + 40 < count {
            let bend = place[k + 40] - 2.0 * place[k + 20] + place[k];
            found[1] =
                found[1].max(bend.length() / half * fps * fps / get(FindingKind::Acceleration));
            let next = crate::planner::course::turned(turn[k + 20], turn[k + 40]);
            let change = (next - turned).length().to_degrees() * fps * fps;
            found[3] = found[3].max(change / get(FindingKind::TurningAcceleration));
        }
        if k + 2 < count {
            let bend = place[k + 2] - 2.0 * place[k + 1] + place[k];
            let fine = bend.length() / half * (20.0 * fps).powi(2);
            found[4] = found[4].max(fine / get(FindingKind::Acceleration));
        }
    }
    found
}

#[test]
fn views_stay_and_limits_hold_on_random_paths() {
    let mut random = Random(61);
    let wanted = request(&[
        (FindingKind::Speed, 1.0),
        (FindingKind::Acceleration, 2.0),
        (FindingKind::Turning, 60.0),
        (FindingKind::TurningAcceleration, 300.0),
        (FindingKind::Zoom, 30.0),
    ]);
    let (mut kinks, mut keys, mut most) = (0, 0, [0.0_f64; 5]);
    let (mut failed, mut sections) = (0, 0);
    let start = std::time::Instant::now();
    for round in 0..200 {
        let path = random_path(&mut random, round);
        let made = match retime(&path, &wanted, &mut |_, _| true) {
            Ok(made) => made,
            Err(error) => {
                println!("round {round}: {error}");
                failed += 1;
                continue;
            }
        };
        kinks += made.rests.len();
        for orientation in made
            .path
            .points
            .iter()
            .flat_map(|point| &point.orientations)
        {
            if let Pace::Part(PacePart {
                of: PaceSource::Track(all),
                ..
            }) = &orientation.own.pace
            {
                keys += all.len();
                sections += 1;
            }
        }
        same_views(&path, &made.path, round);
        let found = peaks(&made.path, &wanted.limits, 25.0);
        for (most, found) in most.iter_mut().zip(found) {
            *most = most.max(found);
        }
        println!(
            "round {round}: {:.2} s, peaks {found:.4?}, rests {}",
            made.seconds,
            made.rests.len()
        );
    }
    println!(
        "{kinks} kinks, {keys} keys in {sections} sections, most {most:.4?}, {failed} failed, {:?}",
        start.elapsed()
    );
    assert!(failed == 0 && most[..4].iter().all(|share| *share <= 1.001));
}
