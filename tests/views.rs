//! Where the camera looks, on every path: unit and perpendicular vectors, no
//! flips, tracked targets, kept directions. Rotations are measured from the
//! vectors of the poses alone, never from quaternions.

mod common;

use std::f64::consts::{FRAC_PI_2, PI};

use common::turning::{at_target, busy_path, free, looking, moving, panning, span, turned, yawed};
use common::{Random, all_poses, prepared, set_speeds};
use glam::{DQuat, DVec3};
use vides::path::{CameraPath, CurveParameters, Orientation, OrientationMode, Pose};

const ROUNDING: f64 = 1e-12;

#[test]
fn unit_and_perpendicular_on_a_hundred_thousand_paths() {
    let mut random = Random::new(31);
    let mut poses = Vec::new();
    for round in 0..100_000 {
        let path = random.path(if round % 100 == 0 { 40.0 } else { 2.0 });
        let (_, sampler) = prepared(&path);
        poses.resize(sampler.frame_count(), Pose::default());
        sampler.sample(1, &mut poses).unwrap();
        for pose in &poses {
            let (view, up) = (DVec3::from(pose.vpn), DVec3::from(pose.vup));
            // Each bound so that NaN fails.
            let good = (view.length() - 1.0).abs() <= ROUNDING
                && (up.length() - 1.0).abs() <= ROUNDING
                && view.dot(up).abs() <= ROUNDING;
            assert!(good, "{pose:?} on {path:?}");
        }
    }
}

/// With θ the angle between two keys on S³, each outer arc of the control
/// polygon has at most m = min(θ, 0.45·(π − θ)), so the inner one at most
/// θ + 2m. A cubic moves by no more than three times the longest arc in the
/// whole section, that is 3·(θ + 2m)/N from frame to frame; rotations are twice
/// as large. A flip would be half a turn in one frame, a hundred times more.
fn check_no_flip(name: &str, path: &CameraPath) -> f64 {
    let (timeline, sampler) = prepared(path);
    let poses = all_poses(&sampler);
    let mut worst = 0.0f64;
    for index in 0..timeline.section_count() {
        let section = timeline.section(index);
        if section.frames == 0 {
            continue;
        }
        let (_, angle) = span(&timeline, &sampler, index);
        let reach = angle.min(0.45 * (PI - angle));
        let bound = 2.0 * 3.0 * (angle + 2.0 * reach) / section.frames as f64;
        let first = sampler.first_frame(index);
        for pair in poses[first - 2..first - 1 + section.frames].windows(2) {
            let step = turned(&pair[0], &pair[1]);
            if bound > 1e-9 {
                worst = worst.max(step / bound);
            }
            assert!(
                step <= bound + 1e-12,
                "{name}: {step} in one frame, allowed {bound}"
            );
        }
    }
    worst
}

#[test]
fn the_camera_never_flips() {
    let mut random = Random::new(35);
    let mut worst = 0.0f64;
    for round in 0..400 {
        let apart = [170.0, 179.9, 180.0, 120.0][round % 4];
        // Each key turned by `apart` about any axis from the one before.
        let mut view = orientation_of(random.vector(), random.between(-180.0, 180.0));
        let mut orientations = Vec::new();
        for _ in 0..6 {
            orientations.push(as_orientation(&view));
            let axis = random.vector().normalize();
            for v in &mut view {
                *v = DQuat::from_axis_angle(axis, f64::to_radians(apart)) * *v;
            }
        }
        let mut path = if random.chance(0.5) {
            moving(orientations)
        } else {
            panning(orientations)
        };
        set_speeds(&mut path, 400.0);
        for point in &mut path.points {
            point.position.x *= random.between(0.3, 3.0);
        }
        worst = worst.max(check_no_flip(&format!("{apart}°"), &path));
    }
    // At the poles and beside them, with any roll.
    for _ in 0..400 {
        let orientations = (0..6).map(|_| {
            let pole = if random.chance(0.5) {
                DVec3::Y
            } else {
                -DVec3::Y
            };
            let beside = [0.0, 1e-13, 1e-9, 1e-3, 1.0][random.below(5)];
            looking(
                pole + beside * random.vector(),
                random.between(-180.0, 180.0),
            )
        });
        let mut path = panning(orientations.collect());
        set_speeds(&mut path, 400.0);
        worst = worst.max(check_no_flip("poles", &path));
    }
    println!("{worst} of what is allowed on a plane");
}

/// View and up of a camera with this view direction and roll, by the formula
/// of the thesis, 4.4.5: yaw, then pitch, then roll.
fn orientation_of(view: DVec3, roll: f64) -> [DVec3; 2] {
    let view = view.normalize();
    let yaw = view.x.atan2(view.z);
    let pitch = -view.y.atan2(view.x.hypot(view.z));
    let turn = DQuat::from_rotation_y(yaw)
        * DQuat::from_rotation_x(pitch)
        * DQuat::from_rotation_z(roll.to_radians());
    [turn * DVec3::Z, turn * DVec3::Y]
}

/// An orientation with this view and up: its roll is the angle from the level
/// up vector.
fn as_orientation(&[view, up]: &[DVec3; 2]) -> Orientation {
    let [_, level] = orientation_of(view, 0.0);
    let sine = level.cross(up).dot(view);
    looking(view, sine.atan2(level.dot(up)).to_degrees())
}

#[test]
fn a_tracked_target_stays_on_the_axis() {
    let mut random = Random::new(36);
    let mut worst = 0.0f64;
    for round in 0..2000 {
        // From a millionth to a million times the size of the path.
        let far = 10f64.powf(random.between(-6.0, 6.0));
        let centre = random.vector();
        let target = centre + far * random.vector();
        let mut path = busy_path(&mut random, |random| {
            at_target(target, random.between(-180.0, 180.0))
        });
        for point in &mut path.points {
            point.curve = CurveParameters::Own(random.tcb());
            // Now and then the way leads close by.
            if random.chance(0.3) {
                point.position = centre;
            }
        }
        path.orientation_mode = [
            OrientationMode::Tcb,
            OrientationMode::BarryGoldman,
            OrientationMode::Slerp,
        ][round % 3];
        let (_, sampler) = prepared(&path);
        let mut poses = all_poses(&sampler);
        for _ in 0..5 {
            let frame = random.between(1.0, sampler.frame_count() as f64);
            poses.push(sampler.pose(frame).unwrap());
        }
        for pose in &poses {
            let (place, view) = (DVec3::from(pose.vrp), DVec3::from(pose.vpn));
            let offset = target - place;
            if offset.length() < 2e-9 {
                continue;
            }
            let beside = view.cross(offset).length() / offset.length();
            worst = worst.max(beside);
            assert!(beside < ROUNDING && view.dot(offset) > 0.0, "{beside:e}");
        }
    }
    println!("{worst:e}");
}

#[test]
fn a_kept_direction_is_kept_to_the_last_bit() {
    let mut random = Random::new(37);
    for round in 0..300 {
        let (direction, roll) = (random.vector(), random.between(-180.0, 180.0));
        let mut path = busy_path(&mut random, |random| {
            if random.chance(0.7) {
                // Only the direction counts, not the length.
                looking(2.0 * direction, roll)
            } else {
                looking(direction, roll)
            }
        });
        let odd = random.below(path.points.len());
        path.points[odd].orientations[0] = free(&mut random);
        path.orientation_mode = [
            OrientationMode::Tcb,
            OrientationMode::BarryGoldman,
            OrientationMode::Slerp,
        ][round % 3];
        let (timeline, sampler) = prepared(&path);
        let poses = all_poses(&sampler);
        for index in 0..timeline.section_count() {
            let section = timeline.section(index);
            let end = (section.point + 1) % path.points.len();
            let last = section.orientation + 1 == path.points[section.point].orientations.len();
            let touches = (section.point == odd && section.orientation == 0)
                || (last && end == odd)
                || section.frames == 0;
            if touches {
                continue;
            }
            let first = sampler.first_frame(index);
            for pose in &poses[first - 2..first - 1 + section.frames] {
                assert_eq!(pose.vpn, poses[first - 2].vpn);
                assert_eq!(pose.vup, poses[first - 2].vup);
            }
            let frame = first as f64 - random.unit();
            let between = sampler.pose(frame).unwrap();
            assert_eq!(
                (between.vpn, between.vup),
                (poses[first - 2].vpn, poses[first - 2].vup)
            );
        }
    }
}

/// Half a turn has two ways; the rule takes the one on which the rotation
/// vector in the camera's own frame points to positive y first.
#[test]
fn half_a_turn_goes_by_the_rule() {
    let mut path = panning(vec![yawed(0.0), yawed(180.0)]);
    path.orientation_mode = OrientationMode::Slerp;
    let (_, sampler) = prepared(&path);
    assert_eq!(sampler.frame_count(), 1 + 100 + 70);
    let quarter = sampler.pose(51.0).unwrap();
    // Positive about y: from +z towards +x.
    assert!((DVec3::from(quarter.vpn) - DVec3::X).length() < ROUNDING);
    assert!((turned(&sampler.pose(1.0).unwrap(), &quarter) - FRAC_PI_2).abs() < ROUNDING);
}
