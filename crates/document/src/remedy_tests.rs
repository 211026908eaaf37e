use super::*;
use crate::Info;
use crate::path::{CurveKind, SupportPoint, Target};

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
        let edits = document.remedy(&finding).unwrap();
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
    assert!(document.remedy(&finding).unwrap().is_empty());
}

#[test]
fn keys_that_stand_for_nothing_go() {
    let mut document = straight([DVec3::NEG_Z; 3]);
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
        .apply(Edit::SetCurveKind(CurveKind::Linear))
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
        .apply(Edit::SetPosition { at: 2, position })
        .unwrap();
    document
        .apply(Edit::SetCurveKind(CurveKind::Linear))
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
        .apply(Edit::SetPosition { at: 2, position })
        .unwrap();
    let finding = found(&document, "space").unwrap();
    assert!(document.remedy(&finding).unwrap().is_empty());
}
