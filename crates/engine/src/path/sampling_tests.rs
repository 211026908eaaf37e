//! Every kind of vectors gives the poses of the plain way, and writes nothing
//! beside them. The paths are short, since Miri looks at each step.

use glam::DVec3;

use super::*;
use crate::math::vector::Vector;
use crate::path::fill;
use crate::path::tables::Tables;
use crate::path::{Orientation, OrientationMode, SupportPoint, Target, Tcb};

/// Every kind of section: one long enough for pieces that are fitted, fewer
/// frames than vectors hold, uneven speed, a target on the way and one above it.
fn path(mode: OrientationMode, closed: bool) -> CameraPath {
    let mut path = CameraPath::default();
    let looks = |target, roll, zoom| Orientation {
        target,
        roll,
        zoom,
        turning: Tcb::new(0.2, -0.1, 0.3),
        ..Orientation::default()
    };
    let point = |position: [f64; 3], orientations| SupportPoint {
        orientations,
        ..SupportPoint::new(DVec3::from_array(position))
    };
    let ahead = Target::Relative(DVec3::new(0.1, 0.2, -0.4));
    let aside = Target::Relative(DVec3::new(-0.5, 0.1, 0.3));
    let there = Target::Absolute(DVec3::new(1.0, 0.1, 0.2));
    let above = Target::Absolute(DVec3::new(0.5, 2.0, 0.0));
    let mut slow = looks(aside, 30.0, 60.0);
    slow.speeds = std::array::from_fn(|k| [100.0, 5.0][k % 2]);
    slow.hold = 3;
    path.points = [
        point([0.0, 0.0, 0.0], vec![looks(ahead, 0.0, 20.0), slow.clone()]),
        point([0.1, 0.1, 0.3], vec![looks(there, 0.0, 20.0)]),
        point(
            [1.3, 0.1, 0.1],
            vec![looks(there, -70.0, 20.0), looks(above, 0.0, 5.0)],
        ),
        point([-0.3, 0.1, 0.0], vec![looks(above, 10.0, 24.0)]),
        point([-0.4, 0.3, 0.1], vec![looks(ahead, 0.0, 24.0)]),
        point(
            [-0.4, 0.5, 0.6],
            vec![looks(ahead, 0.0, 24.0), looks(ahead, 0.0, 25.0)],
        ),
    ]
    .into();
    path.closed = closed;
    path.orientation_mode = mode;
    path.base_frames.movement = 40.0;
    path.base_frames.turning = 200.0;
    path.base_frames.zoom = 30.0;
    path
}

fn prepared(path: &CameraPath) -> Sampler {
    path.check().expect("a path in order");
    let timeline = Timeline::new(path).expect("a timeline");
    Sampler::new(path, &timeline).expect("a sampler")
}

/// Whether all numbers of two poses are equal to within rounding.
fn near(a: &Pose, b: &Pose) -> bool {
    let of = |pose: &Pose| {
        let [vrp, vpn, vup] = [pose.vrp, pose.vpn, pose.vup];
        [vrp, vpn, vup, [pose.zoom, 0.0, 0.0]]
    };
    let pairs = of(a).into_iter().flatten().zip(of(b).into_iter().flatten());
    pairs.into_iter().all(|(a, b)| (a - b).abs() < 1e-12)
}

/// Fills poses of a section from a frame on.
type Fill<'a> = &'a dyn Fn(&SectionSampler, &mut Scratch, Frames<'_>, &mut [Pose]) -> Result<()>;

fn against_the_plain_way(name: &str, fill: Fill<'_>) {
    let never = Pose {
        zoom: -1.0,
        ..Pose::default()
    };
    let paths = [
        (OrientationMode::Tcb, true),
        (OrientationMode::BarryGoldman, false),
        (OrientationMode::Slerp, false),
    ];
    // To Miri all three are the same, and it is slow.
    for (mode, closed) in paths.into_iter().take(if cfg!(miri) { 1 } else { 3 }) {
        let sampler = prepared(&path(mode, closed));
        for (index, section) in sampler.sections.iter().enumerate() {
            let mut tables = Tables::default();
            tables.build::<f64>(section).expect("memory");
            let step = if cfg!(miri) { 83 } else { 1 };
            let frames = (1..=section.frames).step_by(step);
            let plain = frames.map(|frame| {
                let u = frame as f64 / section.frames as f64;
                (frame, section.pose(&tables, section.phi(u)))
            });
            let plain: Vec<(usize, Pose)> = plain.collect();
            let mut poses = vec![never; section.frames + 2];
            // In one go, and in two.
            for at_once in [section.frames, section.frames / 2 + 1] {
                let mut scratch = Scratch::new();
                poses.fill(never);
                for first in (1..=section.frames).step_by(at_once) {
                    let end = (first + at_once).min(section.frames + 1);
                    let frames = Frames::From(first);
                    fill(section, &mut scratch, frames, &mut poses[first..end]).expect("memory");
                }
                assert!(poses[0] == never && poses[section.frames + 1] == never);
                for (frame, plain) in &plain {
                    let pose = &poses[*frame];
                    assert!(
                        near(pose, plain),
                        "{name}, {mode:?}, section {index}, frame {frame} of {}: {pose:?} is not {plain:?}",
                        section.frames
                    );
                }
            }
        }
    }
}

/// Poses between frames, in order, in disorder and one by one.
#[test]
fn a_pose_does_not_depend_on_how_it_is_asked_for() {
    for mode in [OrientationMode::Tcb, OrientationMode::Slerp] {
        let path = path(mode, false);
        let sampler = prepared(&path);
        let last = sampler.frame_count();
        let steps = if cfg!(miri) { 20 } else { 5000 };
        let mut frames: Vec<f64> = (0..=steps)
            .map(|k| 1.0 + (last - 1) as f64 * f64::from(k) / f64::from(steps))
            .collect();
        frames.extend((1..=last.min(200)).map(|frame| frame as f64));
        let mut rising = vec![Pose::default(); frames.len()];
        sampler.poses_at(&frames, &mut rising).expect("frames");
        let order: Vec<usize> = (0..frames.len()).map(|k| k * 7919 % frames.len()).collect();
        let shuffled: Vec<f64> = order.iter().map(|&k| frames[k]).collect();
        let mut poses = rising.clone();
        sampler.poses_at(&shuffled, &mut poses).expect("frames");
        let fresh = prepared(&path);
        for (&k, pose) in order.iter().zip(&poses) {
            assert_eq!(*pose, rising[k], "{mode:?}, frame {}", frames[k]);
            assert_eq!(*pose, fresh.pose(frames[k]).expect("a frame"));
        }
        let mut list = vec![Pose::default(); last];
        sampler.sample(1, &mut list).expect("frames");
        for (frame, pose) in frames.iter().zip(&rising).filter(|(f, _)| f.fract() == 0.0) {
            assert_eq!(*pose, list[*frame as usize - 1], "{mode:?}, frame {frame}");
        }
        for section in &sampler.sections {
            let mut tables = Tables::default();
            tables.build::<f64>(section).expect("memory");
            let at = |k: usize| section.start as f64 + section.frames as f64 * k as f64 / 37.0;
            for frame in (1..37).map(at) {
                let u = (frame - section.start as f64) / section.frames as f64;
                let plain = section.pose(&tables, section.phi(u));
                assert!(
                    near(&sampler.pose(frame).expect("a frame"), &plain),
                    "{frame}"
                );
            }
        }
        for frame in [0.5, last as f64 + 0.25, f64::NAN] {
            let frames = [1.0, frame];
            assert!(
                sampler
                    .poses_at(&frames, &mut [Pose::default(); 2])
                    .is_err()
            );
        }
    }
}

/// Angle between two cameras.
fn turned(a: &Pose, b: &Pose) -> f64 {
    let axes = |pose: &Pose| {
        let (view, up) = (DVec3::from(pose.vpn), DVec3::from(pose.vup));
        glam::DMat3::from_cols(up.cross(view), up, view)
    };
    let turn = axes(a) - axes(b);
    // Each axis moves on a chord; the sum of their squares is 8·sin²(angle/2).
    let chord = turn.to_cols_array().map(|x| x * x).iter().sum::<f64>();
    2.0 * (chord / 8.0).sqrt().min(1.0).asin()
}

/// Motions against the poses beside them, in any order and one by one.
#[test]
fn motions_are_the_differences_of_poses() {
    const STEP: f64 = 1e-4;
    let paths = [
        (OrientationMode::Tcb, true),
        (OrientationMode::BarryGoldman, false),
        (OrientationMode::Slerp, false),
    ];
    for (mode, closed) in paths.into_iter().take(if cfg!(miri) { 1 } else { 3 }) {
        let sampler = prepared(&path(mode, closed));
        let mut frames = vec![];
        for section in &sampler.sections {
            let count = section.frames.min(if cfg!(miri) { 2 } else { 300 });
            let at = |k: usize| (k as f64 + 0.5) / count as f64 * section.frames as f64;
            frames.extend((0..count).map(|k| section.start as f64 + at(k)));
        }
        let order: Vec<usize> = (0..frames.len()).map(|k| k * 7919 % frames.len()).collect();
        let shuffled: Vec<f64> = order.iter().map(|&k| frames[k]).collect();
        let mut motions = vec![Motion::default(); frames.len()];
        sampler.motions_at(&shuffled, &mut motions).expect("frames");
        let fresh = prepared(&path(mode, closed));
        for (&frame, motion) in shuffled.iter().zip(&motions) {
            assert_eq!(*motion, fresh.motion(frame).expect("a frame"), "{frame}");
            let [before, here, after] =
                [-STEP, 0.0, STEP].map(|step| sampler.pose(frame + step).expect("a frame"));
            let [a, b, c] = [before, here, after].map(|pose| DVec3::from(pose.vrp));
            let (speed, bend) = ((c - a) / (2.0 * STEP), (c - 2.0 * b + a) / (STEP * STEP));
            let message = |what: &str, found: f64| {
                format!("{mode:?}, frame {frame}: {what} {found} of {motion:?}")
            };
            let found = speed.length();
            assert!(
                (motion.speed - found).abs() < 1e-6 * (1.0 + found),
                "{}",
                message("speed", found)
            );
            let found = turned(&before, &after) / (2.0 * STEP);
            assert!(
                (motion.turning - found).abs() < 1e-5 * (0.1 + found),
                "{}",
                message("turning", found)
            );
            let found = speed.cross(bend).length() / speed.length().powi(3);
            // Second differences lose digits where the camera is slow.
            let lost = 1e-14 / (STEP * speed.length()).powi(2);
            if found.is_finite() && lost < 0.1 {
                let near = (motion.curvature - found).abs() < 1e-4 * (1.0 + found) + lost;
                assert!(near, "{}", message("curvature", found));
            }
            let step =
                (sampler.motion(frame + STEP).expect("a frame").distance - motion.distance) / STEP;
            assert!(
                (step - motion.speed).abs() < 1e-3 * (0.1 + motion.speed),
                "{}",
                message("step", step)
            );
        }
    }
}

fn with<V: Vector>(name: &str) {
    against_the_plain_way(name, &fill::fill::<V>);
}

#[test]
fn plain_numbers_give_the_poses_of_the_plain_way() {
    with::<f64>("f64");
}

#[cfg(target_arch = "x86_64")]
#[test]
fn two_numbers_at_once_give_the_poses_of_the_plain_way() {
    with::<crate::math::vector::Sse2>("Sse2");
}

#[test]
fn the_widest_vectors_give_the_poses_of_the_plain_way() {
    against_the_plain_way("the widest", &fill_widest);
}

#[test]
fn the_path_has_every_kind_of_section() {
    let (mut tracked, mut kept, mut free, mut short, mut fitted) = (0, 0, 0, 0, 0);
    for closed in [false, true] {
        let sampler = prepared(&path(OrientationMode::Tcb, closed));
        for section in &sampler.sections {
            match section.turning {
                Turning::Tracked(..) => tracked += 1,
                Turning::Kept(..) => kept += 1,
                _ => free += 1,
            }
            short += usize::from(section.frames < 4);
            fitted += usize::from(section.frames > 128);
        }
    }
    assert!(tracked > 0 && kept > 0 && free > 0 && short > 0 && fitted > 0);
}

/// Something done to a path, and what it is called.
type Done = (&'static str, fn(&mut CameraPath));

/// What has the same fingerprint has the same poses; what a change does not reach keeps both.
#[test]
fn a_fingerprint_tells_whether_a_section_has_other_poses() {
    let changes: [Done; 8] = [
        ("a place", |path| path.points[4].position.y += 0.01),
        ("the last target", |path| {
            path.points[5].orientations[1].target = Target::Relative(DVec3::X);
        }),
        ("a roll", |path| path.points[1].orientations[0].roll = 0.5),
        ("a zoom", |path| path.points[5].orientations[1].zoom = 25.5),
        ("a speed", |path| {
            path.points[0].orientations[1].speeds[4] = 6.0
        }),
        ("a tension", |path| {
            path.points[0].orientations[1].turning = Tcb::new(0.9, 0.0, 0.0);
        }),
        ("a rest", |path| path.points[2].orientations[0].hold = 7),
        ("nothing", |_| {}),
    ];
    let seen =
        |path: &CameraPath| -> Vec<(u64, Vec<Pose>)> {
            let sampler = prepared(path);
            let own = sampler.sections.iter().zip(sampler.fingerprints()).map(
                |(section, fingerprint)| {
                    let few = if cfg!(miri) { 2 } else { usize::MAX };
                    let mut poses = vec![Pose::default(); (section.frames - 1).min(few)];
                    sampler
                        .sample(section.start + 1, &mut poses)
                        .expect("memory");
                    (fingerprint, poses)
                },
            );
            own.collect()
        };
    let base = path(OrientationMode::Tcb, false);
    let before = seen(&base);
    let some = if cfg!(miri) { 1 } else { changes.len() };
    for (name, change) in changes.into_iter().take(some) {
        let mut changed = base.clone();
        change(&mut changed);
        let after = seen(&changed);
        assert_eq!(before.len(), after.len(), "{name}");
        let (mut kept, mut others) = (0, 0);
        for (index, (before, after)) in before.iter().zip(&after).enumerate() {
            let same = before.0 == after.0;
            kept += usize::from(same);
            others += usize::from(!same);
            assert!(!same || before.1 == after.1, "{name}, section {index}");
        }
        assert!(kept > 0, "{name}");
        assert_eq!(others == 0, name == "nothing" || name == "a rest", "{name}");
    }
}
