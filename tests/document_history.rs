//! Undo, steps and what counts as modified.

use glam::dvec3;
use vides::document::{At, Document, Edit};
use vides::limits;
use vides::path::{CameraPath, Orientation, SupportPoint, Target};

fn line(xs: &[f64]) -> Document {
    let path = CameraPath {
        points: xs
            .iter()
            .map(|&x| SupportPoint::new(dvec3(x, 0.0, 0.0)))
            .collect(),
        ..CameraPath::default()
    };
    Document::from_parts(path, vides::document::Info::default()).unwrap()
}

#[test]
fn a_drag_is_one_step_and_small() {
    let mut document = line(&[0.0, 0.5, 1.0]);
    document.begin_step();
    for step in 1..10_000 {
        let x = f64::from(step) * 1e-4;
        document
            .apply(Edit::set(At::Point(1), "position", dvec3(x, 0.1, 0.0)))
            .unwrap();
    }
    assert!(document.can_undo());
    document.end_step();
    assert!(document.undo());
    assert_eq!(document.path().points[1].position, dvec3(0.5, 0.0, 0.0));
    assert!(!document.can_undo());
    assert!(document.redo());
    assert_eq!(document.path().points[1].position, dvec3(0.9999, 0.1, 0.0));
}

#[test]
fn a_step_that_is_open_is_taken_back_if_something_was_done() {
    let mut document = line(&[0.0, 1.0]);
    document.cancel_step(); // there is none
    document.begin_step();
    assert!(document.in_step() && !document.can_undo() && !document.undo());
    document.begin_step();
    document.apply(Edit::set(At::Path, "closed", true)).unwrap();
    assert!(document.can_undo() && document.undo());
    assert!(!document.path().closed && !document.in_step() && document.can_redo());
}

#[test]
fn whatever_of_an_orientation_changes_is_a_step() {
    let one = Orientation::default();
    let mut others = vec![one.clone(); 9];
    others[0].target = Target::Relative(dvec3(0.0, 0.1, -0.4));
    others[1].target = Target::Absolute(dvec3(0.0, 0.0, -0.4));
    others[2].roll = -0.0;
    others[3].turning.tension = 0.5;
    others[4].turning.continuity = 0.5;
    others[5].turning.bias = 0.5;
    others[6].zoom = 25.0;
    others[7].speeds[9] = 51.0;
    others[8].hold = 1;
    for other in others {
        let set = |orientation: &Orientation| Edit::SetOrientation {
            point: 1,
            at: 0,
            orientation: orientation.clone(),
        };
        let mut document = line(&[0.0, 1.0]);
        document.apply(set(&one)).unwrap();
        assert!(!document.can_undo() && !document.is_modified());
        document.apply(set(&other)).unwrap();
        assert!(document.can_undo() && document.is_modified(), "{other:?}");
        assert!(document.undo());
        assert_eq!(document.path().points[1].orientations[0], one);
    }
}

#[test]
fn the_history_forgets_its_oldest_steps() {
    let mut document = line(&[0.0, 1.0]);
    let steps = limits::MAX_HISTORY_STEPS + 10;
    for step in 0..steps {
        document
            .apply(Edit::set(
                At::Point(0),
                "position",
                dvec3(0.0, 1.0 + step as f64, 0.0),
            ))
            .unwrap();
    }
    let mut undone = 0;
    while document.undo() {
        undone += 1;
    }
    assert_eq!(undone, limits::MAX_HISTORY_STEPS);
    assert_eq!(document.path().points[0].position.y, 10.0);
    assert!(document.is_modified());
}

#[test]
fn saving_is_remembered_across_undo() {
    let mut document = Document::new();
    let close = |closed| Edit::set(At::Path, "closed", closed);
    document.apply(close(true)).unwrap();
    document.mark_saved();
    assert!(!document.is_modified());
    document.apply(close(false)).unwrap();
    assert!(document.is_modified());
    document.undo();
    assert!(!document.is_modified());
    document.undo();
    assert!(document.is_modified());
    document.redo();
    assert!(!document.is_modified());
    document.undo();
    // Another way to what looks the same: the saved state is out of reach.
    document.apply(close(true)).unwrap();
    assert!(document.is_modified());
    // An edit that changes nothing is none.
    document.mark_saved();
    document.apply(close(true)).unwrap();
    assert!(!document.is_modified());
}

#[test]
fn contents_have_a_number_of_their_own() {
    let mut document = Document::new();
    let mut seen = vec![document.revision(), Document::new().revision()];
    document.select(1, 0).unwrap();
    assert_eq!(document.revision(), seen[0]);
    document.apply(Edit::set(At::Path, "closed", true)).unwrap();
    seen.push(document.revision());
    // Refused, or nothing changed: the same contents.
    document.apply(Edit::RemovePoint { at: 0 }).unwrap_err();
    document.apply(Edit::set(At::Path, "closed", true)).unwrap();
    assert_eq!(document.revision(), seen[2]);
    assert!(document.undo());
    seen.push(document.revision());
    assert!(document.redo());
    seen.push(document.revision());
    document.begin_step();
    assert!(document.in_step());
    document
        .apply(Edit::set(At::Path, "closed", false))
        .unwrap();
    seen.push(document.revision());
    document.cancel_step();
    assert!(!document.in_step());
    seen.push(document.revision());
    let count = seen.len();
    seen.sort_unstable();
    seen.dedup();
    assert_eq!(seen.len(), count);
}
