use vides_engine::scene::Mesh;

use super::*;
use crate::{At, Info};
use vides_engine::path::{CurveKind, SupportPoint, Target};

/// The first finding of a kind.
fn found(document: &Document, kind: &str) -> Option<Finding> {
    let all = document.check(None).unwrap();
    all.into_iter().find(|finding| finding.kind.name() == kind)
}

/// Does what helps, as often as it says something; whether the finding is gone.
fn mended(document: &mut Document, kind: &str) -> bool {
    for _ in 0..8 {
        let Some(finding) = found(document, kind) else {
            return true;
        };
        let edits = document.remedy(&finding, None, &mut |_, _| true).unwrap();
        assert!(!edits.is_empty(), "{finding:?}");
        edits
            .into_iter()
            .for_each(|edit| document.apply(edit).unwrap());
    }
    false
}

fn straight(targets: [DVec3; 3]) -> Document {
    let points = targets.into_iter().zip([-0.5, 0.0, 0.5]);
    let points = points.map(|(target, x)| {
        let mut point = SupportPoint::new(DVec3::new(x, 0.0, 0.8));
        point.orientations[0].target = Target::Relative(target);
        point
    });
    let path = CameraPath {
        points: points.collect(),
        ..CameraPath::default()
    };
    Document::from_parts(path, Info::default()).unwrap()
}

#[test]
fn a_view_that_turns_too_fast_gets_more_frames() {
    let mut document = straight([DVec3::NEG_Z, DVec3::new(1.0, 0.0, 0.2), DVec3::NEG_Z]);
    let few = Edit::FitFrames {
        first: 0,
        last: 2,
        frames: 40,
    };
    document.apply(few).unwrap();
    assert!(found(&document, "turning").is_some());
    assert!(mended(&mut document, "turning"));
}

/// A section that is slowed changes its neighbour's speed at the key; aimed exactly at the limit,
/// more and more presses would come nearer to it.
#[test]
fn presses_leave_nothing_at_the_limit() {
    for frames in (30..120).step_by(3) {
        let mut document = straight([DVec3::NEG_Z, DVec3::new(1.0, 0.0, 0.2), DVec3::NEG_Z]);
        let few = Edit::FitFrames {
            first: 0,
            last: 2,
            frames: frames as usize,
        };
        document.apply(few).unwrap();
        let mut presses = 0;
        while let Some(finding) = found(&document, "turning") {
            for edit in document.remedy(&finding, None, &mut |_, _| true).unwrap() {
                document.apply(edit).unwrap();
            }
            presses += 1;
            assert!(presses <= 5, "{frames}");
        }
    }
}

#[test]
fn a_zoom_that_is_too_fast_gets_more_frames() {
    let mut document = straight([DVec3::NEG_Z; 3]);
    let mut orientation = document.path().points[1].orientations[0].clone();
    orientation.zoom = 90.0;
    let set = Edit::SetOrientation {
        point: 1,
        at: 0,
        orientation,
    };
    document.apply(set).unwrap();
    let few = Edit::FitFrames {
        first: 0,
        last: 2,
        frames: 40,
    };
    document.apply(few).unwrap();
    assert!(found(&document, "zoom").is_some());
    assert!(mended(&mut document, "zoom"));
}

/// A turn in three frames is for another view: a flight of minutes is no remedy.
#[test]
fn a_turn_at_once_is_left_to_the_user() {
    let mut document = straight([DVec3::NEG_Z, DVec3::X, DVec3::Z]);
    let few = Edit::FitFrames {
        first: 0,
        last: 2,
        frames: 5,
    };
    document.apply(few).unwrap();
    let finding = found(&document, "turning").unwrap();
    assert!(finding.value > 8.0 * finding.limit, "{finding:?}");
    assert!(
        document
            .remedy(&finding, None, &mut |_, _| true)
            .unwrap()
            .is_empty()
    );
    // Whoever asks for it in the window gets eight times as many, and may ask again.
    let edits = document.quick_remedy(&finding).unwrap().expect("edits");
    edits
        .into_iter()
        .for_each(|edit| document.apply(edit).unwrap());
    let less = found(&document, "turning").map_or(0.0, |left| left.value);
    assert!(less < finding.value / 4.0, "{less} of {finding:?}");
}

#[test]
fn keys_that_stand_for_nothing_go() {
    let mut document = straight([DVec3::NEG_Z; 3]);
    // Not redundant itself.
    let position = DVec3::new(0.0, 0.01, 0.8);
    document
        .apply(Edit::set(At::Point(1), "position", position))
        .unwrap();
    document
        .apply(Edit::InsertOrientation {
            point: 1,
            at: 1,
            orientation: None,
        })
        .unwrap();
    assert!(found(&document, "redundant").is_some());
    assert!(mended(&mut document, "redundant"));
    assert_eq!(document.path().points[1].orientations.len(), 1);
    // Of other kinds a curve has a loop there.
    document
        .apply(Edit::set(At::Path, "curve", CurveKind::Linear))
        .unwrap();
    let position = document.path().points[1].position;
    document
        .apply(Edit::InsertPoint { at: 2, position })
        .unwrap();
    assert!(found(&document, "redundant").is_some());
    assert!(mended(&mut document, "redundant"));
    assert_eq!(document.path().points.len(), 3);
}

#[test]
fn a_corner_becomes_round_and_a_view_along_it_does_not_jump() {
    let mut document = straight([DVec3::NEG_Z; 3]);
    let position = DVec3::new(-0.5, 0.1, -0.6);
    document
        .apply(Edit::set(At::Point(2), "position", position))
        .unwrap();
    document
        .apply(Edit::set(At::Path, "curve", CurveKind::Linear))
        .unwrap();
    assert!(found(&document, "corner").is_some());
    for point in 0..3 {
        let mut orientation = document.path().points[point].orientations[0].clone();
        orientation.own = orientation.own.with(|own| own.ahead = Some(0.0)).unwrap();
        let at = 0;
        let ahead = Edit::SetOrientation {
            point,
            at,
            orientation,
        };
        document.apply(ahead).unwrap();
    }
    assert!(found(&document, "view-jump").is_some());
    assert!(mended(&mut document, "view-jump"));
    assert!(mended(&mut document, "corner"));
}

#[test]
fn what_is_for_the_user_to_choose_has_no_edit() {
    let mut document = straight([DVec3::NEG_Z; 3]);
    let position = DVec3::new(1.5, 0.0, 0.8);
    document
        .apply(Edit::set(At::Point(2), "position", position))
        .unwrap();
    let finding = found(&document, "space").unwrap();
    assert!(
        document
            .remedy(&finding, None, &mut |_, _| true)
            .unwrap()
            .is_empty()
    );
}

fn speeds(document: &mut Document, point: usize, speed: f64, (frames, hold): (u32, u32)) {
    let mut orientation = document.path().points[point].orientations[0].clone();
    (orientation.speeds, orientation.hold) = ([speed; SPEEDS], hold);
    orientation.own = orientation.own.with(|own| own.frames = frames).unwrap();
    let at = 0;
    document
        .apply(Edit::SetOrientation {
            point,
            at,
            orientation,
        })
        .unwrap();
}

#[test]
fn speeds_that_jump_are_joined() {
    // By the ten speeds, by fixed frames, and before a rest.
    for (speed, frames, hold) in [(100.0, 0, 0), (50.0, 10, 0), (50.0, 0, 12)] {
        let mut document = straight([DVec3::NEG_Z; 3]);
        speeds(&mut document, 0, 40.0, (0, 0));
        speeds(&mut document, 1, speed, (frames, hold));
        // A hold of sections without an ease is a finding only where a limit is set.
        let mut info = document.info().clone();
        info.limits.set(FindingKind::SpeedJump, 0.45).unwrap();
        document.apply(Edit::SetInfo(Box::new(info))).unwrap();
        assert!(
            found(&document, "speed-jump").is_some(),
            "{speed} {frames} {hold}"
        );
        assert!(
            mended(&mut document, "speed-jump"),
            "{speed} {frames} {hold}"
        );
    }
}

/// Where neither section has ten speeds that could be joined, the planner is asked.
#[test]
fn a_speed_that_jumps_between_paces_of_their_own_has_a_fix() {
    let mut document = straight([DVec3::NEG_Z; 3]);
    for (point, frames) in [(0, 100), (1, 30)] {
        let even = [[0.0, 0.0], [0.5, 0.5], [1.0, 1.0]];
        let edit = owned(document.path(), (point, 0), &|own| {
            own.pace = Pace::Distance(even.into());
            own.frames = frames;
        });
        document.apply(edit.unwrap()).unwrap();
    }
    let finding = found(&document, "speed-jump").expect("a jump");
    assert_eq!(document.quick_remedy(&finding).unwrap(), None);
    assert!(mended(&mut document, "speed-jump"));
}

#[test]
fn a_cusp_gets_smooth_tangents() {
    let mut document = straight([DVec3::NEG_Z; 3]);
    for (at, y) in [(0, 2.5), (1, -2.5)] {
        let tangent = DVec3::new(1.5, y, 0.0);
        document.apply(set_tangent(at, tangent)).unwrap();
    }
    assert!(found(&document, "cusp").is_some());
    assert!(mended(&mut document, "cusp"));
}

/// The poses stay where a point goes that changes nothing, also if the others have fixed frames.
#[test]
fn without_a_redundant_point_the_poses_stay() {
    let mut document = straight([DVec3::NEG_Z; 3]);
    speeds(&mut document, 0, 50.0, (70, 0));
    speeds(&mut document, 1, 50.0, (70, 0));
    let before = document.sampler().unwrap().pose(70.0).unwrap();
    assert!(mended(&mut document, "redundant"));
    assert_eq!(document.path().points.len(), 2);
    let after = document.sampler().unwrap();
    assert_eq!(after.frame_count(), 141);
    let after = after.pose(70.0).unwrap();
    assert!((DVec3::from(before.vrp) - DVec3::from(after.vrp)).length() < 1e-9);
}

#[test]
fn all_that_can_be_is_fixed_and_the_rest_is_left() {
    let mut document = straight([DVec3::NEG_Z, DVec3::new(1.0, 0.0, 0.2), DVec3::NEG_Z]);
    let position = DVec3::new(1.5, 0.0, 0.8);
    document
        .apply(Edit::set(At::Point(2), "position", position))
        .unwrap();
    let few = Edit::FitFrames {
        first: 0,
        last: 2,
        frames: 60,
    };
    document.apply(few).unwrap();
    speeds(&mut document, 0, 20.0, (10, 0));
    let before = document.check(None).unwrap();
    let mut told = Vec::new();
    let left = document
        .fix(None, &mut |finding| told.push(finding.kind), &mut |_, _| {
            true
        })
        .unwrap();
    assert_eq!(left, document.check(None).unwrap());
    assert!(
        left.len() < before.len() && !told.is_empty(),
        "{before:?} {left:?}"
    );
    let kinds: Vec<_> = left.iter().map(|finding| finding.kind).collect();
    assert!(kinds.contains(&FindingKind::Space), "{kinds:?}");
    for cured in [FindingKind::Turning, FindingKind::SpeedJump] {
        assert!(!kinds.contains(&cured), "{kinds:?}");
    }
    // Nothing more helps.
    let path = document.path().clone();
    assert_eq!(
        document.fix(None, &mut |_| (), &mut |_, _| true).unwrap(),
        left
    );
    assert_eq!(*document.path(), path);
}

/// Where the camera is too fast, or its speed or its turning change too much, the pace is computed
/// anew, and where the limits allow it in the same time.
#[test]
fn a_pace_beyond_its_limits_is_computed_anew() {
    for (kind, limit, frames) in [
        (FindingKind::Speed, 0.4, 60),
        (FindingKind::Acceleration, 1.0, 60),
        (FindingKind::TurningAcceleration, 100.0, 60),
    ] {
        let turned = DVec3::new(0.6, 0.0, -1.0);
        let mut document = straight([DVec3::NEG_Z, turned, DVec3::NEG_Z]);
        let few = Edit::FitFrames {
            first: 0,
            last: 2,
            frames: frames as usize,
        };
        document.apply(few).unwrap();
        speeds(&mut document, 0, 90.0, (frames / 3, 0));
        let mut info = document.info().clone();
        info.limits.set(kind, limit).unwrap();
        document.apply(Edit::SetInfo(Box::new(info))).unwrap();
        assert!(found(&document, kind.name()).is_some(), "{kind:?}");
        assert!(mended(&mut document, kind.name()), "{kind:?}");
    }
}

fn is_led(kind: FindingKind) -> bool {
    matches!(kind, FindingKind::Clearance | FindingKind::Through)
}

/// A line across the way: the cure leads round it, and fixing all finds nothing of it any more.
#[test]
fn what_is_in_the_way_is_gone_round() {
    let mut document = straight([DVec3::NEG_Z; 3]);
    let line = Mesh {
        points: vec![DVec3::new(0.2, -1.0, 0.805), DVec3::new(0.2, 1.0, 0.805)],
        lines: vec![[0, 1]],
        ..Default::default()
    };
    let object = Clearance::new(&line).unwrap();
    let near = |document: &Document| {
        let found = document
            .check_against(Some(&object), &mut |_, _| true)
            .unwrap();
        found.into_iter().find(|finding| is_led(finding.kind))
    };
    let finding = near(&document).unwrap();
    assert!(
        document
            .remedy(&finding, None, &mut |_, _| true)
            .unwrap()
            .is_empty()
    );
    let edits = document
        .remedy(&finding, Some(&object), &mut |_, _| true)
        .unwrap();
    let mut mended = document.try_clone().unwrap();
    for edit in edits {
        mended.apply(edit).unwrap();
    }
    assert!(near(&mended).is_none());
    let mut told = Vec::new();
    let left = document.fix(
        Some(&object),
        &mut |finding| told.push(finding.kind),
        &mut |_, _| true,
    );
    assert!(told.contains(&FindingKind::Clearance));
    assert!(!left.unwrap().iter().any(|finding| is_led(finding.kind)));
}

/// Views away from an object are turned to it: all of it, or if it is too large, its middle.
#[test]
fn where_nothing_is_to_be_seen_views_turn_to_the_object() {
    for half in [0.1, 5.0] {
        let mut document = straight([DVec3::Z, DVec3::new(0.2, 0.0, 1.0), DVec3::Z]);
        let z = -1.0 - half;
        let corner = |x: f64, y: f64| DVec3::new(half * x, half * y, z);
        let mesh = Mesh {
            points: vec![corner(-1.0, -1.0), corner(1.0, -1.0), corner(0.0, 1.0)],
            triangles: vec![[0, 1, 2]],
            ..Mesh::default()
        };
        let object = Clearance::new(&mesh).unwrap();
        let kinds =
            |found: &[Finding]| found.iter().map(|finding| finding.kind).collect::<Vec<_>>();
        let found = document
            .check_against(Some(&object), &mut |_, _| true)
            .unwrap();
        assert!(kinds(&found).contains(&FindingKind::NothingToSee));
        let left = document
            .fix(Some(&object), &mut |_| (), &mut |_, _| true)
            .unwrap();
        assert!(
            !kinds(&left).contains(&FindingKind::NothingToSee),
            "{left:?}"
        );
        let pose = document.sampler().unwrap().pose(1.0).unwrap();
        let seen = |corner: &DVec3| {
            let way = *corner - pose.position();
            let depth = way.dot(pose.view());
            let aside = way.dot(pose.view().cross(pose.up())).abs() / 18.0;
            depth > 0.0 && aside.max(way.dot(pose.up()).abs() / 12.0) * pose.zoom <= 0.8 * depth
        };
        assert_eq!(mesh.points.iter().all(seen), half < 1.0);
    }
}

#[test]
fn a_way_back_makes_the_curve_centripetal() {
    let points = [0.0, 0.2, 0.21, 0.8, 1.0].map(|x| SupportPoint::new(DVec3::new(x, 0.0, 0.8)));
    let path = CameraPath {
        points: points.to_vec().into(),
        ..CameraPath::default()
    };
    let mut document = Document::from_parts(path, Info::default()).unwrap();
    assert!(found(&document, "backwards").is_some());
    assert!(mended(&mut document, "backwards"));
    assert_eq!(document.path().curve, CurveKind::Centripetal);
}
