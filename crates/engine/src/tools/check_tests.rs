//! Each check finds its example and lets a near one pass.

use super::*;
use crate::path::own;
use crate::path::{CurveKind, Ease, EaseKind, Orientation, Pace, SupportPoint, Tangents, UpVector};
use crate::scene::Mesh;

fn path(points: &[[f64; 3]]) -> CameraPath {
    let points = points.iter().map(|p| {
        let mut point = SupportPoint::new(DVec3::from_array(*p));
        point.orientations[0].target = Target::Relative(DVec3::NEG_Z);
        point
    });
    CameraPath {
        points: points.collect(),
        ..CameraPath::default()
    }
}

fn found_against(path: &CameraPath, against: &CheckContext<'_>) -> Vec<&'static str> {
    let mut kinds: Vec<_> = check(path, against)
        .unwrap()
        .iter()
        .map(|f| f.kind.name())
        .collect();
    kinds.dedup();
    kinds
}

fn plain() -> CheckContext<'static> {
    CheckContext {
        fps: 25.0,
        space: None,
        object: None,
        limits: Limits::default(),
    }
}

fn found(path: &CameraPath) -> Vec<&'static str> {
    found_against(path, &plain())
}

/// Its middle is aside by so much that it is not redundant.
const LINE: [[f64; 3]; 3] = [[-0.5, 0.0, 0.8], [0.0, 0.002, 0.8], [0.5, 0.0, 0.8]];

#[test]
fn a_quiet_flight_has_nothing() {
    assert!(found(&path(&LINE)).is_empty());
    let orbit = crate::tools::moves::Move::named("orbit").unwrap();
    assert!(
        found(
            &orbit
                .path(&[], crate::path::Space::default(), 25.0)
                .unwrap()
        )
        .is_empty()
    );
}

#[test]
fn kinds_stand_in_their_order_and_have_names() {
    for (at, kind) in FindingKind::all().enumerate() {
        assert_eq!(kind as usize, at);
        assert_eq!(FindingKind::parse(kind.name()).unwrap(), kind);
    }
}

#[test]
fn space() {
    let space = Bounds::new(DVec3::splat(-1.0), DVec3::ONE).unwrap();
    let against = CheckContext {
        space: Some(space),
        ..plain()
    };
    let mut path = path(&LINE);
    path.points[2].position.x = 1.0;
    assert!(found_against(&path, &against).is_empty());
    path.points[2].position.x = 1.01;
    let all = check(&path, &against).unwrap();
    assert_eq!(all[0].kind, FindingKind::Space);
    assert_eq!(all[0].point, 1);
    assert!((all[0].value - 0.01).abs() < 1e-12 && all[0].last_frame > 140.0);
}

#[test]
fn cusp() {
    let mut cusp = path(&[[0.0, 0.0, 0.0], [0.4, 0.0, 0.0]]);
    let mut tangents = |y: f64| {
        // A cubic with a cusp in its middle: P′(1/2) = 3/2·chord − 1/4·(both tangents).
        for (point, sign) in cusp.points.iter_mut().zip([1.0, -1.0]) {
            let tangent = DVec3::new(1.2, sign * y, 0.0);
            point.tangents = Some(Tangents {
                before: tangent,
                after: tangent,
            });
        }
        found(&cusp)
    };
    assert!(tangents(1.0).contains(&"cusp"));
    let mut gentle = path(&[[0.0, 0.0, 0.0], [0.4, 0.0, 0.0]]);
    for point in &mut gentle.points {
        point.tangents = Some(Tangents {
            before: DVec3::new(0.6, 0.0, 0.0),
            after: DVec3::new(0.6, 0.0, 0.0),
        });
    }
    assert!(found(&gentle).is_empty());
    // A pace that stops in the middle.
    let pace = |keys: &[[f64; 2]]| {
        let mut path = path(&LINE);
        let orientation = &mut path.points[0].orientations[0];
        let pace = own::distance(keys).unwrap();
        orientation.own = orientation.own.with(|own| own.pace = pace).unwrap();
        found(&path)
    };
    let stops = [[0.0, 0.0], [0.4, 0.5], [0.6, 0.500_001], [1.0, 1.0]];
    assert!(pace(&stops).contains(&"cusp"));
    let slows = [[0.0, 0.0], [0.4, 0.45], [0.6, 0.55], [1.0, 1.0]];
    assert!(!pace(&slows).contains(&"cusp"));
}

#[test]
fn speed_jump() {
    let mut path = path(&LINE);
    path.points[1].orientations[0].hold = 10;
    eased(&mut path, 0, 0.4, 0.0);
    let all = check(&path, &plain()).unwrap();
    assert_eq!(all[0].kind, FindingKind::SpeedJump);
    assert!(
        (all[0].first_frame, all[0].last_frame) == (60.0, 70.0),
        "{:?}",
        all[0]
    );
    // Eased on both sides of the rest.
    eased(&mut path, 0, 0.0, 0.4);
    eased(&mut path, 1, 0.4, 0.0);
    assert!(found(&path).is_empty(), "{:?}", found(&path));
}

fn eased(path: &mut CameraPath, at: usize, rise: f64, fall: f64) {
    let ease = Pace::Ease(Ease {
        kind: EaseKind::Sine,
        rise,
        fall,
        cruise: 50.0,
    });
    let orientation = &mut path.points[at].orientations[0];
    orientation.own = orientation.own.with(|own| own.pace = ease).unwrap();
}

/// A hold, and a turn on the spot, between sections without an ease are as they are meant. A limit
/// that somebody sets counts there, too.
#[test]
fn a_plain_stop_is_found_only_against_a_limit_that_was_set() {
    let mut stops = path(&LINE);
    for point in &mut stops.points {
        point.orientations[0].target = Target::Absolute(DVec3::ZERO);
    }
    let mut turns = stops.clone();
    stops.points[1].orientations[0].hold = 10;
    let mut aside = turns.points[1].orientations[0].clone();
    aside.target = Target::Relative(DVec3::new(-0.5, 0.0, -0.8));
    turns.points[1].orientations.push(aside);
    turns.base_frames.turning = 200.0;
    for (path, kinds) in [(&stops, 3), (&turns, 2)] {
        assert!(found(path).is_empty(), "{:?}", found(path));
        for (kind, limit) in [
            (FindingKind::SpeedJump, 0.4),
            (FindingKind::Acceleration, 5.0),
            (FindingKind::TurningAcceleration, 299.0),
        ]
        .into_iter()
        .take(kinds)
        {
            let mut against = plain();
            against.limits.set(kind, limit).unwrap();
            assert!(found_against(path, &against).contains(&kind.name()));
        }
    }
    // One side with an ease that does not begin at rest.
    let mut eased_after = stops.clone();
    eased(&mut eased_after, 1, 0.0, 0.4);
    assert!(found(&eased_after).contains(&"speed-jump"));
    // Without a stop, speeds that differ are found.
    stops.points[1].orientations[0].hold = 0;
    stops.points[1].orientations[0].speeds = [100.0; 10];
    assert!(found(&stops).contains(&"speed-jump"));
}

#[test]
fn acceleration() {
    let mut fast = path(&[
        [0.0, 0.0, 0.0],
        [0.5, 0.0, 0.0],
        [0.5, 0.0, 0.5],
        [0.0, 0.0, 0.5],
    ]);
    fast.base_frames.movement = 10.0;
    assert!(found(&fast).contains(&"acceleration"));
    fast.base_frames.movement = 200.0;
    assert!(!found(&fast).contains(&"acceleration"));
}

fn ahead(path: &mut CameraPath, distance: f64) {
    for point in &mut path.points {
        let orientation = &mut point.orientations[0];
        orientation.own = orientation
            .own
            .with(|own| own.ahead = Some(distance))
            .unwrap();
    }
}

#[test]
fn view_jump_and_corner() {
    let mut corner = path(&[[0.0, 0.0, 0.0], [0.5, 0.0, 0.0], [0.5, 0.0, 0.5]]);
    corner.curve = crate::path::CurveKind::Linear;
    ahead(&mut corner, 0.0);
    let all = check(&corner, &plain()).unwrap();
    let jump = all
        .iter()
        .find(|f| f.kind == FindingKind::ViewJump)
        .unwrap();
    assert!((jump.value - 90.0).abs() < 1e-6, "{jump:?}");
    assert!(
        all.iter()
            .any(|f| f.kind == FindingKind::Corner && (f.value - 90.0).abs() < 1e-3)
    );
    ahead(&mut corner, 0.2);
    assert!(!found(&corner).contains(&"view-jump"));
    corner.points[2].position = DVec3::new(1.0, 0.0, 0.5);
    assert!(!found(&corner).contains(&"corner"));
}

#[test]
fn turning_and_its_acceleration() {
    let turn = |degrees: f64, frames: u32| {
        let mut path = path(&LINE[..2]);
        let (sin, cos) = degrees.to_radians().sin_cos();
        path.points[1].orientations[0].target = Target::Relative(DVec3::new(sin, 0.0, -cos));
        let orientation = &mut path.points[0].orientations[0];
        orientation.own = orientation.own.with(|own| own.frames = frames).unwrap();
        path
    };
    assert!(found(&turn(59.0, 25)).is_empty());
    let all = check(&turn(61.0, 25), &plain()).unwrap();
    assert_eq!(all[0].kind, FindingKind::Turning);
    assert!((all[0].value - 61.0).abs() < 1e-6);
    let mut rest = turn(50.0, 25);
    rest.points[0].orientations[0].hold = 5;
    assert!(!found(&rest).contains(&"turning-acceleration"));
    eased(&mut rest, 0, 0.0, 0.1);
    assert!(found(&rest).contains(&"turning-acceleration"));
    let mut slow = turn(10.0, 25);
    slow.points[0].orientations[0].hold = 5;
    eased(&mut slow, 0, 0.0, 0.1);
    assert!(!found(&slow).contains(&"turning-acceleration"));
}

#[test]
fn half_turn() {
    let mut path = path(&LINE[..2]);
    path.points[1].orientations[0].target = Target::Relative(DVec3::Z);
    assert!(found(&path).contains(&"half-turn"));
    path.points[1].orientations[0].target = Target::Relative(DVec3::new(0.01, 0.0, 1.0));
    assert!(!found(&path).contains(&"half-turn"));
}

#[test]
fn a_half_turn_is_one_within_a_tenth_of_a_degree() {
    for (degrees, there) in [(0.0, true), (0.09, true), (-0.09, true), (0.11, false)] {
        let mut path = path(&LINE[..2]);
        let (sin, cos) = f64::to_radians(degrees).sin_cos();
        path.points[1].orientations[0].target = Target::Relative(DVec3::new(sin, 0.0, cos));
        let all = check(&path, &plain()).unwrap();
        let half = all.iter().find(|f| f.kind == FindingKind::HalfTurn);
        assert_eq!(half.is_some(), there, "{degrees}");
        assert!(half.is_none_or(|f| (f.value - degrees.abs()).abs() < 1e-9));
    }
}

/// A point on the straight way between two others, moved aside, its view turned, its zoom changed:
/// without it the poses change by so much there, and nowhere by more.
#[test]
fn a_point_is_redundant_if_the_poses_change_by_less() {
    let redundant = |aside: f64, degrees: f64, zoom: f64| {
        let mut path = path(&[[-0.5, 0.0, 0.8], [0.0, aside, 0.8], [0.5, 0.0, 0.8]]);
        let (sin, cos) = degrees.to_radians().sin_cos();
        let view = &mut path.points[1].orientations[0];
        view.target = Target::Relative(DVec3::new(sin, 0.0, -cos));
        view.zoom += zoom;
        found(&path).contains(&"redundant")
    };
    assert!(redundant(0.0, 0.0, 0.0));
    assert!(redundant(0.000_9, 0.0, 0.0) && !redundant(0.001_1, 0.0, 0.0));
    assert!(redundant(0.0, 0.09, 0.0) && !redundant(0.0, 0.11, 0.0));
    assert!(redundant(0.0, 0.0, 0.09) && !redundant(0.0, 0.0, 0.11));
    // Another pace, a rest.
    let mut slow = path(&[[-0.5, 0.0, 0.8], [0.0, 0.0, 0.8], [0.5, 0.0, 0.8]]);
    let first = &mut slow.points[0].orientations[0];
    first.own = first.own.with(|own| own.frames = 40).unwrap();
    assert!(!found(&slow).contains(&"redundant"));
    let mut rest = path(&[[-0.5, 0.0, 0.8], [0.0, 0.0, 0.8], [0.5, 0.0, 0.8]]);
    rest.points[1].orientations[0].hold = 1;
    assert!(!found(&rest).contains(&"redundant"));
    // In a long path, where only the points around are planned: a straight one, and a wave.
    for curve in [crate::path::CurveKind::Tcb, crate::path::CurveKind::Cubic] {
        for (high, count) in [(0.0, 98), (0.3, 0)] {
            let points = (0..100).map(f64::from);
            let points = points.map(|k| [0.1 * k, high * (0.9 * k).sin(), 0.8]);
            let long = path(&points.collect::<Vec<_>>());
            let all = check(&CameraPath { curve, ..long }, &plain()).unwrap();
            let redundant = all.iter().filter(|f| f.kind == FindingKind::Redundant);
            assert_eq!(redundant.count(), count, "{curve:?}");
        }
    }
}

/// From rest to rest in 50 frames with constant acceleration, then constant braking: 4·L/T² is
/// 1 half size/s², which goes down to −1 within two frames, 1/s³ times 25 for each.
#[test]
fn jerk_is_found_if_it_is_limited() {
    let mut braking = path(&[[-0.5, 0.0, 0.8], [0.5, 0.0, 0.8]]);
    let ease = Pace::Ease(Ease {
        kind: EaseKind::Parabolic,
        rise: 0.5,
        fall: 0.5,
        cruise: 50.0,
    });
    let begin = &mut braking.points[0].orientations[0];
    let own = begin.own.with(|own| (own.pace, own.frames) = (ease, 50));
    begin.own = own.unwrap();
    assert!(found(&braking).is_empty());
    let mut against = plain();
    for (limit, there) in [(24.9, true), (25.1, false)] {
        against.limits.set(FindingKind::Jerk, limit).unwrap();
        let all = check(&braking, &against).unwrap();
        assert_eq!(all.len(), usize::from(there), "{all:?}");
        assert!(all.iter().all(|f| (f.value - 25.0).abs() < 1e-9));
    }
    assert!(all_off(&braking).is_empty());
}

/// What is found where nothing is looked for.
fn all_off(path: &CameraPath) -> Vec<&'static str> {
    let mut against = plain();
    for kind in FindingKind::all() {
        against.limits.set(kind, OFF).unwrap();
    }
    found_against(path, &against)
}

#[test]
fn a_finding_is_a_sentence_with_its_numbers() {
    let finding = Finding {
        kind: FindingKind::Turning,
        first_frame: 1.0,
        last_frame: 2.0,
        point: 1,
        orientation: 0,
        value: 123.456,
        limit: 60.0,
    };
    let said = "From point 2, view 1 the view turns by 123°/s (limit 60°/s).";
    assert_eq!(finding.to_string(), said);
    let numbers = [0.0, 0.02, 0.5, 1.234_56, 12.3456, 0.000_123_4, 60.0, 1e6];
    let decimals = numbers.map(super::decimals);
    assert_eq!(decimals, [0, 2, 1, 2, 1, 6, 0, 0]);
}

#[test]
fn pole_and_target() {
    let over = |height: f64, aside: f64| {
        let mut path = path(&[[-0.5, height, aside], [0.5, height, aside]]);
        for point in &mut path.points {
            point.orientations[0].target = Target::Absolute(DVec3::ZERO);
        }
        found(&path)
    };
    assert!(over(0.5, 0.01).contains(&"pole"));
    assert!(!over(0.5, 0.05).contains(&"pole"));
    // Another up does not spin there.
    let mut above = path(&[[-0.5, 0.5, 0.01], [0.5, 0.5, 0.01]]);
    for point in &mut above.points {
        let orientation = &mut point.orientations[0];
        orientation.target = Target::Absolute(DVec3::ZERO);
        let with = orientation.own.with(|own| own.up = UpVector::Minimal);
        orientation.own = with.unwrap();
    }
    assert!(!found(&above).contains(&"pole"));
    assert!(over(0.04, 0.0).contains(&"target"));
    assert!(!over(0.06, 0.0).contains(&"target"));
}

#[test]
fn clearance_through_and_nothing_to_see() {
    let mesh = Mesh {
        points: vec![
            DVec3::new(-1.0, -1.0, 0.7),
            DVec3::new(1.0, -1.0, 0.7),
            DVec3::new(0.0, 2.0, 0.7),
        ],
        triangles: vec![[0, 1, 2]],
        ..Mesh::default()
    };
    let object = Clearance::new(&mesh).unwrap();
    let against = CheckContext {
        object: Some(&object),
        ..plain()
    };
    let mut line = path(&LINE);
    assert!(found_against(&line, &against).is_empty());
    for point in &mut line.points {
        point.position.z = 0.719;
    }
    assert_eq!(found_against(&line, &against), ["clearance"]);
    line.points[2].position.z = 0.6;
    let all = check(&line, &against).unwrap();
    assert!(all.iter().any(|f| f.kind == FindingKind::Through));
    // Between two frames it is nowhere near, and yet there.
    let mut near = all.iter().filter(|f| f.kind == FindingKind::Clearance);
    assert!(near.any(|f| f.value == 0.0), "{all:?}");
    let many = all_off(&line);
    assert!(many.is_empty(), "{many:?}");
    // Away from it for 1.2 seconds, and for 0.8.
    for (seconds, there) in [(1.2, true), (0.8, false)] {
        let mut away = path(&LINE[..2]);
        for point in &mut away.points {
            point.orientations[0].target = Target::Relative(DVec3::Z);
            let frames = (seconds * 25.0) as u32;
            let orientation = &mut point.orientations[0];
            orientation.own = orientation.own.with(|own| own.frames = frames).unwrap();
        }
        assert_eq!(
            found_against(&away, &against).contains(&"nothing-to-see"),
            there
        );
    }
}

#[test]
fn zoom_and_redundant_keys() {
    let mut path = path(&LINE[..2]);
    path.points[1].orientations[0].zoom = 90.0;
    assert!(found(&path).contains(&"zoom"));
    path.points[1].orientations[0].zoom = 60.0;
    assert!(!found(&path).contains(&"zoom"));
    let mut again: Orientation = path.points[1].orientations[0].clone();
    path.points[1].orientations.push(again.clone());
    let all = check(&path, &plain()).unwrap();
    assert!(
        all.iter()
            .any(|f| f.kind == FindingKind::Redundant && (f.point, f.orientation) == (1, 0))
    );
    again.roll = 1.0;
    path.points[1].orientations[1] = again;
    assert!(!found(&path).contains(&"redundant"));
}

#[test]
fn limits_are_set_by_name() {
    let mut limits = Limits::default();
    assert_eq!(limits.get(FindingKind::Turning), 60.0);
    limits.set(FindingKind::Turning, 90.0).unwrap();
    assert_eq!(
        limits.changed().collect::<Vec<_>>(),
        [(FindingKind::Turning, 90.0)]
    );
    assert!(limits.set(FindingKind::Turning, f64::NAN).is_err());
    assert!(limits.set(FindingKind::Turning, -1.0).is_err());
    assert!(FindingKind::parse("tuning").is_err() && FindingKind::parse("").is_err());
}

/// Neither a least nor a greatest value at its limit is beyond it, whatever rounding says.
#[test]
fn at_its_limit_nothing_is_found() {
    let space = crate::path::Space::default();
    let made = |name: &str, numbers: &[f64]| {
        let known = crate::tools::moves::Move::named(name).unwrap();
        known.path(numbers, space, 25.0).unwrap()
    };
    let mut against = plain();
    for tilt in 1..87 {
        let tilt = f64::from(tilt);
        let path = made("pan", &[0.0, 0.0, 0.0, -10.0, 10.0, tilt]);
        against.limits.set(FindingKind::Pole, 90.0 - tilt).unwrap();
        assert!(!found_against(&path, &against).contains(&"pole"), "{tilt}");
        let path = made("approach", &[0.0, 0.0, 0.0, 2.0, 0.01 * tilt, 4.0 * tilt]);
        against
            .limits
            .set(FindingKind::Target, 0.01 * tilt)
            .unwrap();
        assert!(
            !found_against(&path, &against).contains(&"target"),
            "{tilt}"
        );
        against
            .limits
            .set(FindingKind::Target, 0.01 * tilt + 1e-6)
            .unwrap();
        assert!(found_against(&path, &against).contains(&"target"), "{tilt}");
    }
}

/// The way back is the extremum of a Hermite cubic: between 10 and 10.5 the tangents are 5.25 and
/// 15, so that s = 5.25 t − 24 t² + 19.25 t³.
#[test]
fn a_way_back_is_found_and_centripetal_has_none() {
    let line = [0.0, 10.0, 10.5, 40.0, 50.0].map(|x| [x / 50.0, 0.0, 0.0]);
    let mut path = path(&line);
    let all = check(&path, &plain()).unwrap();
    let back = all
        .iter()
        .find(|found| found.kind == FindingKind::Backwards);
    let back = back.expect("a way back");
    let s = |t: f64| (5.25 * t - 24.0 * t * t + 19.25 * t * t * t) / 50.0;
    let ends = [-1.0, 1.0]
        .map(|side| (48.0 + side * (48.0_f64.powi(2) - 4.0 * 57.75 * 5.25).sqrt()) / 115.5);
    assert!(
        (back.value - (s(ends[0]) - s(ends[1]))).abs() < 1e-4,
        "{back:?}"
    );
    assert_eq!((back.point, back.limit), (1, 0.001));
    for kind in [CurveKind::Centripetal, CurveKind::Chordal] {
        path.curve = kind;
        assert!(!found(&path).contains(&"backwards"));
    }
    // A way that its points lead back is none.
    let hairpin = [
        [0.0, 0.0, 0.0],
        [0.5, 0.0, 0.0],
        [0.1, 0.05, 0.0],
        [-0.5, 0.0, 0.0],
    ];
    assert!(!found(&self::path(&hairpin)).contains(&"backwards"));
}
