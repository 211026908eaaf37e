//! The plane of a drag in the window: seen edge-on, with held keys, by steps, at the faces.

use egui::{Key, Modifiers, PointerButton, Vec2, vec2};
use egui_kittest::Harness;
use glam::DVec3;
use vides_document::Edit;
use vides_engine::path::Target;

use super::projection::Axis;
use super::tests::{
    BUTTONS, hold, image, key, message, motion, position, press, pyramid_window, release, shown,
    text, tips, viewport,
};
use super::*;
use crate::setup::View;
use crate::texts::fill;

/// The window's own views, and which plane faces the viewer there.
const VIEWS: [(f64, f64, Axis); 3] = [
    (0.0, 0.0, Axis::Z),
    (-90.0, 0.0, Axis::X),
    (0.0, 90.0, Axis::Y),
];

/// A window that is seen from there.
fn seen_from<'a>(rotation: f64, tilt: f64) -> Harness<'a, Editor> {
    let mut harness = pyramid_window();
    harness.state_mut().setup.view = View {
        rotation,
        tilt,
        ..View::default()
    };
    // Before others that are seen at the same place.
    harness.state_mut().document.select(2, 0).unwrap();
    harness.step();
    harness
}

#[test]
fn seen_edge_on_a_plane_keeps_its_coordinate_and_it_is_said() {
    for (rotation, tilt, facing) in VIEWS {
        let mut told = Vec::new();
        for (which, kept) in BUTTONS {
            let mut harness = seen_from(rotation, tilt);
            let from = position(&harness, 2);
            let start = image(&harness, from);
            motion(&mut harness, start);
            let end = start + vec2(9.0, -7.0);
            let along = Axis::ALL.into_iter();
            let mut along = along.filter(|&axis| kept != facing && axis != kept && axis != facing);
            let along = along.next();
            let texts = &harness.state().texts().space;
            let (words, hint) = match along {
                None => (
                    fill(texts.in_plane, &[&kept.letter()]),
                    kept.letter().to_owned(),
                ),
                Some(along) => (
                    fill(texts.edge_on, &[&kept.letter(), &along.letter()]),
                    fill(texts.only_along, &[&kept.letter(), &along.letter()]),
                ),
            };
            told.push(hint);
            press(&mut harness, start, which);
            // As soon as the button is down, and while it is dragged.
            assert!(shown(&harness).contains(&words), "{words}");
            motion(&mut harness, end);
            assert!(shown(&harness).contains(&words), "{words}");
            let now = position(&harness, 2);
            let moved = Axis::ALL.map(|axis| now[axis.index()] != from[axis.index()]);
            let wanted = Axis::ALL.map(|axis| along.map_or(axis != kept, |along| axis == along));
            assert_eq!(moved, wanted, "{facing:?} {which:?}");
            if along.is_none() {
                assert!(image(&harness, now).distance(end) < 1e-3);
            }
            let (said, error) = message(&harness).unwrap();
            assert!(said.starts_with("Position") && !error, "{said}");
            release(&mut harness, end, which);
        }
        // Before, the hint tells what each button would do.
        let mut harness = seen_from(rotation, tilt);
        let start = image(&harness, position(&harness, 2));
        motion(&mut harness, start);
        let hint = harness.state().texts().space.drag_hint;
        let hint = fill(hint, &[&told[0], &told[1], &told[2]]);
        assert!(shown(&harness).contains(&hint), "{hint}");
    }
}

#[test]
fn a_held_key_keeps_its_coordinate_where_its_plane_is_seen_edge_on() {
    for (rotation, tilt, facing) in VIEWS {
        for (which, kept) in [(Key::X, Axis::X), (Key::Y, Axis::Y), (Key::Z, Axis::Z)] {
            let mut harness = seen_from(rotation, tilt);
            let from = position(&harness, 2);
            let start = image(&harness, from);
            press(&mut harness, start, PointerButton::Primary);
            motion(&mut harness, start + vec2(9.0, -7.0));
            // Another key while it is dragged: what that one moved comes back.
            key(&mut harness, which, true, Modifiers::NONE);
            motion(&mut harness, start + vec2(11.0, -8.0));
            let now = position(&harness, 2);
            let last = now[kept.index()];
            motion(&mut harness, start + vec2(19.0, -15.0));
            let later = position(&harness, 2);
            assert_eq!(later[kept.index()].to_bits(), last.to_bits());
            assert_eq!(
                later[facing.index()].to_bits(),
                from[facing.index()].to_bits()
            );
            let moved = Axis::ALL.map(|axis| later[axis.index()] != now[axis.index()]);
            let expected = Axis::ALL.map(|axis| axis != kept && axis != facing);
            assert_eq!(moved, expected, "{facing:?} {kept:?}");
            key(&mut harness, which, false, Modifiers::NONE);
            release(&mut harness, start, PointerButton::Primary);
            assert!(harness.state_mut().document.undo());
            assert!(!harness.state().document.can_undo());
        }
    }
}

#[test]
fn with_ctrl_a_drag_goes_by_steps_and_with_shift_it_is_finer() {
    let mut harness = pyramid_window();
    let start = image(&harness, position(&harness, 4));
    press(&mut harness, start, PointerButton::Middle);
    motion(&mut harness, start + vec2(31.0, 17.0));
    let free = position(&harness, 4);
    // Ctrl counts at once, while the pointer rests.
    hold(&mut harness, Modifiers::CTRL);
    let snapped = position(&harness, 4);
    assert_eq!(snapped.y.to_bits(), free.y.to_bits());
    for index in [0, 2] {
        let nearest = (free[index] * 20.0).round() / 20.0;
        assert_eq!(snapped[index], nearest);
    }
    hold(&mut harness, Modifiers::NONE);
    assert_eq!(position(&harness, 4), free);
    // A tenth of the way, from where it is; without Shift as far as the pointer again.
    let place = |harness: &Harness<'_, Editor>| image(harness, position(harness, 4));
    hold(&mut harness, Modifiers::SHIFT);
    let before = place(&harness);
    motion(&mut harness, start + vec2(51.0, 7.0));
    let way = place(&harness) - before;
    assert!((way - vec2(2.0, -1.0)).length() < 1e-3, "{way:?}");
    hold(&mut harness, Modifiers::NONE);
    let before = place(&harness);
    motion(&mut harness, start + vec2(56.0, 12.0));
    let way = place(&harness) - before;
    assert!((way - vec2(5.0, 5.0)).length() < 1e-3, "{way:?}");
    release(
        &mut harness,
        start + vec2(56.0, 12.0),
        PointerButton::Middle,
    );
    assert!(harness.state_mut().document.undo());
    assert!(!harness.state().document.can_undo());
    // The roll goes by 15 degrees.
    let start = image(&harness, tips(&harness).up_tip);
    let centre = image(&harness, tips(&harness).position);
    press(&mut harness, start, PointerButton::Primary);
    hold(&mut harness, Modifiers::CTRL);
    for turn in 1..9_u8 {
        motion(
            &mut harness,
            centre + Vec2::angled(f32::from(turn) * 0.7) * 70.0,
        );
        let at = harness.state().document.selection().point;
        let roll = harness.state().document.path().points[at].orientations[0].roll;
        assert_eq!(roll % 15.0, 0.0, "{roll}");
    }
    release(&mut harness, centre, PointerButton::Primary);
}

#[test]
fn edge_on_a_circle_turns_nothing_and_it_is_said() {
    let mut harness = pyramid_window();
    harness.state_mut().setup.view = View {
        rotation: 0.0,
        tilt: 0.0,
        ..View::default()
    };
    harness.step();
    let texts = &harness.state().texts().space;
    // A camera that looks to the side: its circle is a line.
    let orientation = vides_engine::path::Orientation {
        target: Target::Relative(DVec3::X),
        ..vides_engine::path::Orientation::default()
    };
    let edit = Edit::SetOrientation {
        point: 0,
        at: 0,
        orientation,
    };
    harness.state_mut().document.apply(edit).unwrap();
    harness.state_mut().document.select(0, 0).unwrap();
    harness.step();
    let before = text(&harness);
    let start = image(&harness, tips(&harness).up_tip);
    press(&mut harness, start, PointerButton::Primary);
    motion(&mut harness, start + vec2(30.0, 10.0));
    assert_eq!(text(&harness), before);
    let said = Some((texts.circle_edge_on.to_owned(), true));
    assert_eq!(message(&harness), said);
    release(&mut harness, start, PointerButton::Primary);
    // It stays to be read.
    assert_eq!(message(&harness), said);
}

#[test]
fn a_drag_stops_before_the_target() {
    let mut harness = pyramid_window();
    let corner = DVec3::new(1.0, 1.0, 0.8);
    let mut orientation = harness.state().document.path().points[0].orientations[0].clone();
    orientation.target = Target::Absolute(corner);
    let edit = Edit::SetOrientation {
        point: 0,
        at: 0,
        orientation,
    };
    harness.state_mut().document.apply(edit).unwrap();
    harness.step();
    let start = image(&harness, position(&harness, 0));
    press(&mut harness, start, PointerButton::Secondary);
    let near = start + vec2(40.0, -40.0);
    motion(&mut harness, near);
    let last = position(&harness, 0);
    // Far out both coordinates end at the faces: exactly where the target is.
    let far = viewport(&harness).right_top() + vec2(400.0, -900.0);
    motion(&mut harness, far);
    assert_eq!(position(&harness, 0), last);
    let (said, error) = message(&harness).unwrap();
    assert!(error && said.contains("target"), "{said}");
    // And it goes on where it can.
    motion(&mut harness, near + vec2(5.0, 5.0));
    assert_ne!(position(&harness, 0), last);
    release(&mut harness, near, PointerButton::Secondary);
}

#[test]
fn coordinates_end_at_the_faces() {
    let mut harness = pyramid_window();
    let start = image(&harness, position(&harness, 1));
    press(&mut harness, start, PointerButton::Middle);
    motion(&mut harness, start + vec2(-3000.0, 0.0));
    let now = position(&harness, 1);
    assert!(now.abs().max_element() == 1.0 && now.y == 0.3, "{now}");
    release(&mut harness, start, PointerButton::Middle);
}
