//! The menu of a point, and the keyboard in the movement window.

use egui::{Event, Key, Modifiers, PointerButton, pos2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;
use glam::DVec3;
use vides_document::Edit;
use vides_engine::path::{Orientation, Target};

use super::projection::Axis;
use super::tests::*;
use crate::setup::{Element, View};
use crate::state::Editor;

/// Opens the menu of a point, and chooses an entry.
fn choose(harness: &mut Harness<'_, Editor>, at: usize, entry: &str) {
    let place = image(harness, position(harness, at));
    press(harness, place, PointerButton::Secondary);
    release(harness, place, PointerButton::Secondary);
    assert_eq!(harness.state().document.selection().point, at);
    harness.get_by_label(entry).click();
    harness.run();
}

#[test]
fn a_points_menu_appends_prepends_closes_removes() {
    let mut harness = pyramid_window();
    let count = |harness: &Harness<'_, Editor>| harness.state().document.path().points.len();
    choose(&mut harness, 2, "Append after the last point");
    assert_eq!(count(&harness), 7);
    assert_eq!(harness.state().document.selection().point, 6);
    choose(&mut harness, 2, "Put before the first point");
    assert_eq!(count(&harness), 8);
    assert_eq!(harness.state().document.selection().point, 0);
    choose(&mut harness, 2, "Close the path");
    assert!(harness.state().document.path().closed);
    choose(&mut harness, 2, "Open the path");
    assert!(!harness.state().document.path().closed);
    choose(&mut harness, 2, "Remove this point");
    assert_eq!(count(&harness), 7);
    assert_eq!(harness.state().document.selection().point, 1);
    // Each was one step.
    for _ in 0..5 {
        assert!(harness.state_mut().document.undo());
    }
    assert!(!harness.state().document.can_undo());
}

#[test]
fn orientations_are_copied_from_point_to_point() {
    let mut harness = pyramid_window();
    harness.state_mut().document.select(3, 1).unwrap();
    let copied = harness.state().document.path().points[3].orientations[1].clone();
    harness.event(Event::Copy);
    harness.step();
    choose(&mut harness, 0, "Paste view");
    assert_eq!(
        harness.state().document.path().points[0].orientations[0],
        copied
    );
    choose(&mut harness, 1, "Copy view");
    choose(&mut harness, 0, "Paste view");
    let points = &harness.state().document.path().points;
    assert_eq!(points[0].orientations[0], points[1].orientations[0]);
}

#[test]
fn copy_and_paste_by_key() {
    let mut harness = pyramid_window();
    harness.state_mut().document.select(3, 2).unwrap();
    harness.step();
    let copied = harness.state().document.path().points[3].orientations[2].clone();
    harness.event(Event::Copy);
    harness.step();
    harness.state_mut().document.select(1, 0).unwrap();
    harness.event(Event::Paste(String::new()));
    harness.step();
    assert_eq!(
        harness.state().document.path().points[1].orientations[0],
        copied
    );
}

#[test]
fn a_right_press_with_motion_opens_no_menu() {
    let mut harness = pyramid_window();
    let place = image(&harness, position(&harness, 2));
    press(&mut harness, place, PointerButton::Secondary);
    motion(&mut harness, place + vec2(9.0, 3.0));
    release(
        &mut harness,
        place + vec2(9.0, 3.0),
        PointerButton::Secondary,
    );
    assert!(harness.query_by_label("Remove this point").is_none());
}

#[test]
fn the_menu_comes_by_keyboard_and_goes_by_escape() {
    let mut harness = pyramid_window();
    tap(&mut harness, Key::F10, Modifiers::SHIFT);
    harness.run();
    assert!(harness.query_by_label("Remove this point").is_some());
    tap(&mut harness, Key::Escape, Modifiers::NONE);
    harness.run();
    assert!(harness.query_by_label("Remove this point").is_none());
}

/// Turned so that no camera's arrow ends at a corner on the screen.
fn look_aside(harness: &mut Harness<'_, Editor>) {
    harness.state_mut().document.select(1, 0).unwrap();
    harness.state_mut().edit(Edit::SetOrientation {
        point: 1,
        at: 0,
        orientation: Orientation::default(),
    });
    harness.run();
}

/// What the cameras are to look at needs no numbers: a corner of the object is
/// there to be pointed at. The summit lies in front of nothing.
#[test]
fn cameras_are_aimed_at_a_corner_of_the_object() {
    let summit = DVec3::new(0.0, 0.5, 0.0);
    let mut harness = pyramid_window();
    let targets = |harness: &Harness<'_, Editor>| -> Vec<Target> {
        let points = harness.state().document.path().points.iter();
        let orientations = points.flat_map(|point| &point.orientations);
        orientations.map(|orientation| orientation.target).collect()
    };
    look_aside(&mut harness);
    let before = targets(&harness);
    let pick = |harness: &mut Harness<'_, Editor>, entry: &str| {
        let place = image(harness, summit) + vec2(3.0, -2.0);
        press(harness, place, PointerButton::Secondary);
        release(harness, place, PointerButton::Secondary);
        harness.get_by_label(entry).click();
        harness.run();
    };
    pick(&mut harness, "Aim the camera here");
    assert_eq!(target(&harness, 1), Target::Absolute(summit));
    let after = targets(&harness);
    let changed = before.iter().zip(&after).filter(|(a, b)| a != b);
    assert_eq!(changed.count(), 1);
    assert!(harness.state_mut().document.undo());
    harness.run();
    assert_eq!(targets(&harness), before);
    pick(&mut harness, "Aim all cameras here");
    let all = targets(&harness);
    assert!(all.iter().all(|&target| target == Target::Absolute(summit)));
    // The key does so while the corner is lit; elsewhere it goes by the current view.
    assert!(harness.state_mut().document.undo());
    let (lit, dark) = (image(&harness, summit), empty(&harness));
    for (place, aims) in [(dark, false), (lit, true)] {
        motion(&mut harness, place);
        harness.run();
        tap(&mut harness, Key::F7, Modifiers::NONE);
        harness.run();
        let at_it = |&target: &Target| target == Target::Absolute(summit);
        assert_eq!(targets(&harness).iter().all(at_it), aims);
    }
    // Elsewhere, and where the object is not shown, nothing of the kind is offered.
    let offers = |harness: &mut Harness<'_, Editor>, place| {
        press(harness, place, PointerButton::Secondary);
        release(harness, place, PointerButton::Secondary);
        let offers = harness.query_by_label("Aim all cameras here").is_some();
        tap(harness, Key::Escape, Modifiers::NONE);
        harness.run();
        offers
    };
    let place = image(&harness, summit);
    assert!(offers(&mut harness, place));
    let elsewhere = empty(&harness);
    assert!(!offers(&mut harness, elsewhere));
    harness.state_mut().setup.shown.set(Element::Object, false);
    assert!(!offers(&mut harness, place));
}

/// Which corner a right click would take is seen before; where none would be, nothing lights up.
#[test]
fn the_corner_under_the_pointer_lights_up() {
    let summit = DVec3::new(0.0, 0.5, 0.0);
    let mut harness = pyramid_window();
    look_aside(&mut harness);
    let place = image(&harness, summit);
    let elsewhere = empty(&harness);
    let mut seen = |at, shown: bool| {
        harness.state_mut().setup.shown.set(Element::Object, shown);
        motion(&mut harness, at);
        harness.run();
        let picture = harness.render().unwrap();
        let (x, y) = (place.x as u32 - 14, place.y as u32 - 14);
        // The pointer is painted, too, but in no colour.
        let part = image::imageops::crop_imm(&picture, x, y, 28, 28);
        let part = part.to_image();
        let blue = part
            .pixels()
            .filter(|pixel| pixel[2] > 130 && pixel[0] < 100);
        blue.count()
    };
    assert_eq!(seen(elsewhere, true), 0);
    let lit = seen(place + vec2(3.0, -2.0), true);
    assert!(lit > 30, "{lit}");
    assert_eq!(seen(elsewhere, true), 0, "it stays lit");
    assert_eq!(seen(place, false), 0, "what is not shown lights up");
}

/// Whoever comes near something that can be dragged is told what the buttons do.
#[test]
fn the_buttons_are_told_where_they_work() {
    let mut harness = pyramid_window();
    let told = |harness: &Harness<'_, Editor>, text: &str| {
        let shapes = &harness.output().shapes;
        shapes.iter().any(|shape| match &shape.shape {
            egui::Shape::Text(shown) => shown.galley.text() == text,
            _ => false,
        })
    };
    let (drag, roll) = (
        "Drag: left keeps x, middle y, right z",
        "Drag: roll the camera",
    );
    let point = image(&harness, position(&harness, 3));
    motion(&mut harness, point);
    harness.step();
    assert!(told(&harness, drag) && !told(&harness, roll));
    press(&mut harness, point, PointerButton::Middle);
    harness.step();
    assert!(!told(&harness, drag));
    release(&mut harness, point, PointerButton::Middle);
    let tip = image(&harness, tips(&harness).up_tip);
    motion(&mut harness, tip);
    harness.step();
    assert!(told(&harness, roll) && !told(&harness, drag));
    let elsewhere = empty(&harness);
    motion(&mut harness, elsewhere);
    harness.step();
    assert!(!told(&harness, roll) && !told(&harness, drag));
}

#[test]
fn the_empty_space_offers_views() {
    let mut harness = pyramid_window();
    for (entry, rotation, tilt) in [
        ("From the front", 0.0, 0.0),
        ("From the right", -90.0, 0.0),
        ("From above", 0.0, 90.0),
        ("Reset the view", 28.0, 20.0),
    ] {
        let place = empty(&harness);
        press(&mut harness, place, PointerButton::Secondary);
        release(&mut harness, place, PointerButton::Secondary);
        harness.get_by_label(entry).click();
        harness.run();
        let view = harness.state().setup.view;
        assert_eq!((view.rotation, view.tilt), (rotation, tilt));
    }
}

#[test]
fn seen_from_the_right_z_runs_to_the_left() {
    let view = View {
        rotation: -90.0,
        tilt: 0.0,
        ..View::default()
    };
    let viewport = egui::Rect::from_min_size(pos2(0.0, 0.0), vec2(400.0, 300.0));
    let projection = super::Projection::new(&view, viewport);
    assert!(projection.toward().abs_diff_eq(glam::DVec3::X, 1e-12));
    assert!(projection.image_of_way(glam::DVec3::Z).x < 0.0);
}

#[test]
fn arrow_keys_move_the_current_point_in_the_plane_that_is_seen_best() {
    let mut harness = pyramid_window();
    let start = position(&harness, 0);
    // The default view shows z = const best: right is x, up is y.
    for (which, axis, by) in [
        (Key::ArrowRight, Axis::X, 0.01),
        (Key::ArrowLeft, Axis::X, -0.01),
        (Key::ArrowUp, Axis::Y, 0.01),
        (Key::ArrowDown, Axis::Y, -0.01),
        (Key::PageUp, Axis::Z, -0.01),
        (Key::PageDown, Axis::Z, 0.01),
    ] {
        tap(&mut harness, which, Modifiers::NONE);
        let mut expected = start;
        expected[axis.index()] += by;
        let now = position(&harness, 0);
        assert!((now - expected).length() < 1e-12, "{which:?}: {now}");
        for other in axis.others() {
            let index = other.index();
            assert_eq!(now[index].to_bits(), start[index].to_bits());
        }
        assert!(harness.state_mut().document.undo());
        assert!(!harness.state().document.can_undo());
    }
    // Held down, a row of steps is one step of the history.
    for _ in 0..5 {
        key(&mut harness, Key::ArrowUp, true, Modifiers::SHIFT);
    }
    key(&mut harness, Key::ArrowUp, false, Modifiers::SHIFT);
    assert!((position(&harness, 0).y - start.y - 0.5).abs() < 1e-9);
    assert!(harness.state_mut().document.undo());
    assert_eq!(position(&harness, 0), start);
    // They end at the faces.
    for _ in 0..30 {
        tap(&mut harness, Key::ArrowUp, Modifiers::SHIFT);
    }
    assert_eq!(position(&harness, 0).y, 1.0);
}

#[test]
fn arrow_keys_go_where_they_point_in_every_view() {
    let mut harness = pyramid_window();
    for rotation in [-170.0, -100.0, -60.0, 0.0, 28.0, 80.0, 135.0] {
        for tilt in [-85.0, -40.0, 0.0, 20.0, 60.0, 88.0] {
            harness.state_mut().setup.view = View {
                rotation,
                tilt,
                ..View::default()
            };
            harness.step();
            for (which, way) in [
                (Key::ArrowRight, vec2(1.0, 0.0)),
                (Key::ArrowLeft, vec2(-1.0, 0.0)),
                (Key::ArrowUp, vec2(0.0, -1.0)),
                (Key::ArrowDown, vec2(0.0, 1.0)),
            ] {
                let from = image(&harness, position(&harness, 2));
                harness.state_mut().document.select(2, 0).unwrap();
                tap(&mut harness, which, Modifiers::SHIFT);
                let moved = image(&harness, position(&harness, 2)) - from;
                assert!(
                    moved.dot(way) > 0.0,
                    "{which:?} at {rotation}, {tilt}: {moved}"
                );
                harness.state_mut().document.undo();
            }
        }
    }
}

#[test]
fn other_keys_move_the_target_roll_turn_and_go_on() {
    let mut harness = pyramid_window();
    let tip = tips(&harness).target;
    tap(&mut harness, Key::ArrowUp, Modifiers::ALT);
    assert!((tips(&harness).target.y - tip.y - 0.01).abs() < 1e-12);
    tap(&mut harness, Key::Period, Modifiers::NONE);
    let roll = |harness: &Harness<'_, Editor>| {
        harness.state().document.path().points[0].orientations[0].roll
    };
    assert_eq!(roll(&harness), 1.0);
    tap(&mut harness, Key::Comma, Modifiers::SHIFT);
    assert_eq!(roll(&harness), -9.0);
    tap(&mut harness, Key::ArrowRight, Modifiers::COMMAND);
    tap(&mut harness, Key::ArrowUp, Modifiers::COMMAND);
    let view = harness.state().setup.view;
    assert_eq!((view.rotation, view.tilt), (33.0, 15.0));
    tap(&mut harness, Key::Plus, Modifiers::NONE);
    assert!(harness.state().setup.view.size > 1.05);
    tap(&mut harness, Key::Home, Modifiers::NONE);
    assert_eq!(harness.state().setup.view, View::default());
    let selection = |harness: &Harness<'_, Editor>| {
        let selection = harness.state().document.selection();
        (selection.point, selection.orientation)
    };
    tap(&mut harness, Key::N, Modifiers::SHIFT);
    assert_eq!(selection(&harness), (5, 0));
    tap(&mut harness, Key::N, Modifiers::NONE);
    assert_eq!(selection(&harness), (0, 0));
    harness.state_mut().document.select(3, 0).unwrap();
    tap(&mut harness, Key::O, Modifiers::NONE);
    assert_eq!(selection(&harness), (3, 1));
    tap(&mut harness, Key::O, Modifiers::SHIFT);
    tap(&mut harness, Key::O, Modifiers::SHIFT);
    assert_eq!(selection(&harness), (3, 3));
    tap(&mut harness, Key::C, Modifiers::NONE);
    assert!(!harness.state().setup.camera_view);
}
