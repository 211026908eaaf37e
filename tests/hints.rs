//! The hints of the thesis's Anhang A.6, held against the poses: what the ten
//! presets do to a curve, and in which order orientations are gone through.

mod common;

use common::{all_poses, path_through, prepared, set_speeds};
use glam::DVec3;
use vides::document::{At, Document, Edit};
use vides::path::{CameraPath, CurveParameters, Orientation, Target, Tcb};

/// Looks so many degrees to the side of ahead, which is +z.
fn yawed(degrees: f64) -> Orientation {
    let (sin, cos) = degrees.to_radians().sin_cos();
    Orientation {
        target: Target::Relative(DVec3::new(sin, 0.0, cos)),
        ..Orientation::default()
    }
}

fn rolled(degrees: f64) -> Orientation {
    Orientation {
        roll: degrees,
        ..yawed(0.0)
    }
}

/// A corner: along x to its point 1, then along y.
fn corner(preset: u8) -> CameraPath {
    let mut path = path_through(&[
        [-2.0, 0.0, 0.0],
        [-1.0, 0.0, 0.0],
        [-1.0, 1.0, 0.0],
        [-1.0, 2.0, 0.0],
    ]);
    path.points[1].curve = CurveParameters::Preset(preset);
    set_speeds(&mut path, 1000.0);
    path
}

/// How steeply the curve comes into the corner and leaves it, in degrees from
/// the direction of its predecessor: 0 along x, 90 along y.
fn steepness(preset: u8) -> [f64; 2] {
    let (timeline, sampler) = prepared(&corner(preset));
    let key = 1.0 + timeline.section(0).frames as f64;
    let at = |frame: f64| DVec3::from(sampler.pose(frame).expect("a pose").vrp);
    [[-0.5, 0.0], [0.0, 0.5]].map(|[from, to]| {
        let way = at(key + to) - at(key + from);
        way.y.atan2(way.x).to_degrees()
    })
}

/// The length of a zigzag of which all points use a preset.
fn zigzag(preset: u8) -> f64 {
    let mut path = path_through(&[
        [0.0, 0.0, 0.0],
        [0.5, 1.0, 0.0],
        [1.0, 0.0, 0.0],
        [1.5, 1.0, 0.0],
        [2.0, 0.0, 0.0],
    ]);
    for point in &mut path.points {
        point.curve = CurveParameters::Preset(preset);
    }
    set_speeds(&mut path, 1000.0);
    let poses = all_poses(&prepared(&path).1);
    let place = |at: usize| DVec3::from(poses[at].vrp);
    (1..poses.len())
        .map(|at| place(at).distance(place(at - 1)))
        .sum()
}

#[test]
fn presets_1_and_2_tighten_and_3_and_4_round() {
    let [tightest, tight, normal, round, roundest] = [2, 1, 0, 3, 4].map(zigzag);
    assert!(
        tightest < tight && tight < normal,
        "{tightest} {tight} {normal}"
    );
    assert!(
        normal < round && round < roundest,
        "{normal} {round} {roundest}"
    );
}

#[test]
fn presets_0_and_9_run_smoothly_through_the_point() {
    for preset in [0, 9] {
        let [inward, outward] = steepness(preset);
        assert!((inward - outward).abs() < 0.5, "{inward} {outward}");
        assert!((inward - 45.0).abs() < 0.5, "{inward}");
    }
}

#[test]
fn preset_5_makes_a_corner_and_preset_6_one_the_other_way() {
    // In along the line from the predecessor, out towards the successor.
    let [inward, outward] = steepness(5);
    assert!(inward < 25.0 && outward > 65.0, "{inward} {outward}");
    let [inward, outward] = steepness(6);
    assert!(inward > 65.0 && outward < 25.0, "{inward} {outward}");
}

#[test]
fn preset_7_turns_behind_the_point_and_preset_8_before_it() {
    let [inward, outward] = steepness(7);
    assert!(
        (inward - outward).abs() < 0.5 && inward < 25.0,
        "{inward} {outward}"
    );
    let [inward, outward] = steepness(8);
    assert!(
        (inward - outward).abs() < 0.5 && inward > 65.0,
        "{inward} {outward}"
    );
}

#[test]
fn changed_presets_are_saved_with_the_path() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("presets.vid");
    let mut document = Document::new();
    for (preset, tcb) in [
        (5, Tcb::new(0.1, -0.7, 0.2)),
        (9, Tcb::new(0.25, 0.5, -1.0)),
    ] {
        let mut presets = document.path().presets;
        presets[preset] = tcb;
        let edit = Edit::set(At::Path, "presets", presets);
        document.apply(edit).expect("possible");
    }
    document.save(&file).expect("saved");
    let loaded = Document::load(&file).expect("loaded");
    assert_eq!(loaded.path().presets, document.path().presets);
    assert_eq!(loaded.path().presets[9], Tcb::new(0.25, 0.5, -1.0));
}

/// A path that pans through these at its first point.
fn pans(orientations: Vec<Orientation>) -> CameraPath {
    let mut path = path_through(&[[0.0; 3], [1.0, 0.0, 0.0]]);
    path.points[1].orientations = orientations.last().cloned().into_iter().collect();
    path.points[0].orientations = orientations;
    set_speeds(&mut path, 100.0);
    path
}

/// By how many degrees an angle of the poses turns in all.
fn turned(path: &CameraPath, angle: impl Fn(&vides::path::Pose) -> f64) -> f64 {
    let poses = all_poses(&prepared(path).1);
    let steps = poses.windows(2).map(|pair| {
        let step = angle(&pair[1]) - angle(&pair[0]);
        (step + 180.0).rem_euclid(360.0) - 180.0
    });
    steps.sum()
}

fn yaw(pose: &vides::path::Pose) -> f64 {
    pose.vpn[0].atan2(pose.vpn[2]).to_degrees()
}

/// Of a camera that looks ahead.
fn roll(pose: &vides::path::Pose) -> f64 {
    pose.vup[0].atan2(pose.vup[1]).to_degrees()
}

#[test]
fn a_view_goes_the_shorter_way() {
    for (to, way) in [
        (100.0, 100.0),
        (170.0, 170.0),
        (190.0, -170.0),
        (260.0, -100.0),
    ] {
        let path = pans(vec![yawed(0.0), yawed(to)]);
        assert!((turned(&path, yaw) - way).abs() < 1e-6, "{to}");
    }
}

#[test]
fn a_full_turn_takes_two_orientations_in_between() {
    let path = pans(vec![yawed(0.0), yawed(120.0), yawed(240.0), yawed(0.0)]);
    assert!((turned(&path, yaw) - 360.0).abs() < 1e-6);
    // Without them nothing turns at all.
    let path = pans(vec![yawed(0.0), yawed(0.0)]);
    assert_eq!(turned(&path, yaw), 0.0);
}

#[test]
fn vup_goes_the_shorter_way_too_and_larger_turns_in_parts() {
    let sign = turned(&pans(vec![rolled(0.0), rolled(90.0)]), roll).signum();
    for (from, to, way) in [
        (0.0, 170.0, 170.0),
        (-170.0, 170.0, -20.0),
        (100.0, -100.0, 160.0),
    ] {
        let path = pans(vec![rolled(from), rolled(to)]);
        let turned = sign * turned(&path, roll);
        assert!((turned - way).abs() < 1e-6, "{from} {to}: {turned}");
    }
    let path = pans(vec![
        rolled(0.0),
        rolled(120.0),
        rolled(-120.0),
        rolled(0.0),
    ]);
    assert!((sign * turned(&path, roll) - 360.0).abs() < 1e-6);
}

/// Two orientations at the start, two at the end of the movement.
fn movement() -> CameraPath {
    let mut path = path_through(&[[0.0; 3], [1.0, 0.0, 0.0]]);
    path.points[0].orientations = vec![yawed(0.0), yawed(40.0)];
    path.points[1].orientations = vec![yawed(80.0), yawed(120.0)];
    set_speeds(&mut path, 100.0);
    path
}

#[test]
fn moving_on_turns_from_the_last_orientation_to_the_first_of_the_next_point() {
    let (timeline, sampler) = prepared(&movement());
    let frame = |sections: usize| {
        let before: usize = (0..sections).map(|at| timeline.section(at).frames).sum();
        1.0 + before as f64
    };
    let at = |frame: f64| sampler.pose(frame).expect("a pose");
    let [start, end] = [at(frame(1)), at(frame(2))];
    assert_eq!([start.vrp[0], end.vrp[0]], [0.0, 1.0]);
    assert!((yaw(&start) - 40.0).abs() < 1e-9 && (yaw(&end) - 80.0).abs() < 1e-9);
    let mut last = start;
    for part in 1..=9 {
        let now = at(frame(1) + (frame(2) - frame(1)) * f64::from(part) / 10.0);
        assert!(
            now.vrp[0] > last.vrp[0] && yaw(&now) > yaw(&last) - 1e-9,
            "{part}"
        );
        last = now;
    }
    // Before it the camera stands and turns only.
    assert_eq!(at(frame(1) / 2.0).vrp, [0.0; 3]);
}

#[test]
fn the_last_speed_curve_of_a_point_times_the_way_to_the_next() {
    let frames = |orientation: usize, speed: f64| {
        let mut path = movement();
        path.points[0].orientations[orientation].speeds = [speed; 10];
        let timeline = prepared(&path).0;
        [0, 1].map(|section| timeline.section(section).frames as f64)
    };
    let [pan, way] = frames(0, 50.0);
    let [slow_pan, same_way] = frames(0, 25.0);
    let [same_pan, slow_way] = frames(1, 25.0);
    assert!((slow_pan / pan - 2.0).abs() < 0.15, "{slow_pan} {pan}");
    assert!((slow_way / way - 2.0).abs() < 0.15, "{slow_way} {way}");
    // The other section's curve shapes no more than the slope at the joint.
    assert!((same_way / way - 1.0).abs() < 0.1, "{same_way} {way}");
    assert!((same_pan / pan - 1.0).abs() < 0.1, "{same_pan} {pan}");
}
