//! Several points at once, as a user selects and changes them.

use egui::{Key, Modifiers, PointerButton, Pos2, vec2};
use egui_kittest::Harness;
use glam::{DMat3, DVec3};
use vides_document::At;
use vides_engine::path::CurveParameters;

use super::tests::{
    editor, empty, hold, image, message, motion, position, press, pyramid, pyramid_window, release,
    tap, text, tips, viewport, window,
};
use super::*;
use crate::screenshots::screenshot;
use crate::setup::Theme;
use crate::state::selected::SelectionChange;
use crate::texts::{Language, fill};

type Window<'a> = Harness<'a, Editor>;

const LEFT: PointerButton = PointerButton::Primary;

fn click_at(harness: &mut Window<'_>, at: Pos2, held: Modifiers) {
    hold(harness, held);
    press(harness, at, LEFT);
    release(harness, at, LEFT);
    hold(harness, Modifiers::NONE);
}

fn click_point(harness: &mut Window<'_>, at: usize, held: Modifiers) {
    let place = position(harness, at);
    let place = image(harness, place);
    click_at(harness, place, held);
}

fn selected(harness: &Window<'_>) -> Vec<usize> {
    harness.state().all_selected()
}

fn current(harness: &Window<'_>) -> usize {
    harness.state().document.selection().point
}

fn choose(harness: &mut Window<'_>, points: &[usize]) {
    let context = harness.ctx.clone();
    let choice = SelectionChange::These(points.to_vec());
    harness.state_mut().act(Action::Choose(choice), &context);
    harness.step();
}

fn positions(harness: &Window<'_>) -> Vec<DVec3> {
    let points = &harness.state().document.path().points;
    points.iter().map(|point| point.position).collect()
}

/// One step, whose undoing restores every bit and leaves none.
fn is_one_step(harness: &mut Window<'_>, before: &str) {
    let after = text(harness);
    assert_ne!(after, before);
    assert!(!harness.state().document.in_step());
    let document = &mut harness.state_mut().document;
    assert!(document.undo());
    assert!(!document.can_undo());
    assert_eq!(text(harness), before);
    assert!(harness.state_mut().document.redo());
    assert_eq!(text(harness), after);
}

#[test]
fn shift_and_ctrl_with_a_click_select_and_no_longer() {
    let mut harness = pyramid_window();
    click_point(&mut harness, 2, Modifiers::NONE);
    click_point(&mut harness, 4, Modifiers::SHIFT);
    assert_eq!((selected(&harness), current(&harness)), (vec![2, 4], 4));
    click_point(&mut harness, 1, Modifiers::CTRL);
    assert_eq!((selected(&harness), current(&harness)), (vec![1, 2, 4], 1));
    // The current one goes too: the nearest of the others becomes current.
    click_point(&mut harness, 1, Modifiers::SHIFT);
    assert_eq!((selected(&harness), current(&harness)), (vec![2, 4], 2));
    // A plain click on one of them leaves it alone.
    click_point(&mut harness, 4, Modifiers::NONE);
    assert_eq!((selected(&harness), current(&harness)), (vec![4], 4));
    click_point(&mut harness, 4, Modifiers::SHIFT);
    assert_eq!(selected(&harness), [4], "one is always current");
    assert!(!harness.state().document.is_modified());
}

#[test]
fn without_the_current_point_the_nearest_one_becomes_current() {
    let mut harness = pyramid_window();
    click_point(&mut harness, 5, Modifiers::NONE);
    for (points, nearest) in [([0, 3], 3), ([0, 1], 1), ([2, 4], 2)] {
        choose(&mut harness, &points);
        assert_eq!(selected(&harness), points);
        assert_eq!(current(&harness), nearest);
    }
}

#[test]
fn all_are_selected_by_a_key_and_one_by_escape_a_click_or_another_point() {
    let mut harness = pyramid_window();
    let all: Vec<usize> = (0..6).collect();
    let nothing = empty(&harness);
    let ways: [&dyn Fn(&mut Window<'_>); 4] = [
        &|harness| tap(harness, Key::Escape, Modifiers::NONE),
        &|harness| click_at(harness, nothing, Modifiers::NONE),
        &|harness| tap(harness, Key::N, Modifiers::NONE),
        &|harness| {
            harness.state_mut().document.select(5, 0).unwrap();
            harness.step();
        },
    ];
    for way in ways {
        tap(&mut harness, Key::A, Modifiers::CTRL);
        assert_eq!(selected(&harness), all);
        way(&mut harness);
        let now = current(&harness);
        assert_eq!(selected(&harness), [now]);
    }
}

#[test]
fn a_box_selects_what_is_in_it() {
    let mut harness = pyramid_window();
    let drawn = |harness: &mut Window<'_>, of: &[usize], held: Modifiers| {
        let places = of.iter().map(|&at| image(harness, position(harness, at)));
        let places: Vec<Pos2> = places.collect();
        let bounds = Rect::from_points(&places).expand(14.0);
        hold(harness, held);
        press(harness, bounds.min, LEFT);
        motion(harness, bounds.center());
        assert_eq!(
            harness.state().space.pointer.drawn_box(),
            Some(Rect::from_two_pos(bounds.min, bounds.center()))
        );
        motion(harness, bounds.max);
        release(harness, bounds.max, LEFT);
        hold(harness, Modifiers::NONE);
    };
    let view = harness.state().setup.view;
    drawn(&mut harness, &[1], Modifiers::CTRL);
    assert_eq!((selected(&harness), current(&harness)), (vec![1], 1));
    drawn(&mut harness, &[0, 1], Modifiers::CTRL);
    let two = selected(&harness);
    assert!(
        two.len() >= 2 && two.contains(&0) && two.contains(&1),
        "{two:?}"
    );
    choose(&mut harness, &[4]);
    drawn(&mut harness, &[1], Modifiers::CTRL | Modifiers::SHIFT);
    assert_eq!((selected(&harness), current(&harness)), (vec![1, 4], 4));
    // An empty one leaves the current one.
    let nothing = empty(&harness);
    hold(&mut harness, Modifiers::CTRL);
    press(&mut harness, nothing, LEFT);
    motion(&mut harness, nothing + vec2(9.0, 9.0));
    release(&mut harness, nothing + vec2(9.0, 9.0), LEFT);
    assert_eq!(selected(&harness), [4]);
    assert_eq!(harness.state().setup.view, view, "a box turns nothing");
    assert!(!harness.state().document.is_modified());
}

#[test]
fn a_drag_moves_all_in_one_step() {
    for (which, axis) in [
        (LEFT, 0),
        (PointerButton::Middle, 1),
        (PointerButton::Secondary, 2),
    ] {
        let mut harness = pyramid_window();
        choose(&mut harness, &[0, 1, 5]);
        let (before, from) = (text(&harness), positions(&harness));
        let start = image(&harness, from[1]);
        press(&mut harness, start, which);
        assert_eq!((selected(&harness), current(&harness)), (vec![0, 1, 5], 1));
        for step in 1..=6_u8 {
            motion(&mut harness, start + vec2(5.0, -4.0) * f32::from(step));
            let now = positions(&harness);
            let by = now[1] - from[1];
            assert!(by != DVec3::ZERO && by[axis] == 0.0, "{by}");
            for at in 0..6 {
                let wanted = if [0, 1, 5].contains(&at) {
                    by
                } else {
                    DVec3::ZERO
                };
                assert!((now[at] - from[at] - wanted).length() < 1e-15, "{at}");
            }
        }
        release(&mut harness, start + vec2(30.0, -24.0), which);
        assert_eq!(selected(&harness), [0, 1, 5]);
        is_one_step(&mut harness, &before);
        // Far out: all stop when the first comes to a face.
        let start = image(&harness, position(&harness, 1));
        let from = positions(&harness);
        press(&mut harness, start, which);
        motion(&mut harness, start + vec2(900.0, -300.0));
        let now = positions(&harness);
        for at in [0, 1, 5] {
            assert!(now[at].abs().max_element() <= 1.0 + 1e-12, "{}", now[at]);
            assert!((now[at] - from[at] - (now[1] - from[1])).length() < 1e-12);
        }
        assert!(
            [0, 1, 5]
                .iter()
                .any(|&at| now[at].abs().max_element() > 1.0 - 1e-12)
        );
        let there = text(&harness);
        tap(&mut harness, Key::Escape, Modifiers::NONE);
        assert_ne!(text(&harness), there);
        assert_eq!(positions(&harness), from);
        release(&mut harness, start, which);
        assert_eq!(selected(&harness), [0, 1, 5]);
    }
}

#[test]
fn arrow_keys_move_all_and_delete_removes_all() {
    let mut harness = pyramid_window();
    choose(&mut harness, &[1, 3, 4]);
    let (before, from) = (text(&harness), positions(&harness));
    for _ in 0..3 {
        tap(&mut harness, Key::PageUp, Modifiers::NONE);
    }
    let now = positions(&harness);
    let by = now[1] - from[1];
    assert!((by.abs().max_element() - 0.03).abs() < 1e-12, "{by}");
    for at in 0..6 {
        let wanted = if [1, 3, 4].contains(&at) {
            by
        } else {
            DVec3::ZERO
        };
        assert!((now[at] - from[at] - wanted).length() < 1e-12);
    }
    while harness.state_mut().document.undo() {}
    assert_eq!(text(&harness), before);
    choose(&mut harness, &[1, 3, 4]);
    tap(&mut harness, Key::Delete, Modifiers::NONE);
    assert_eq!(positions(&harness), [from[0], from[2], from[5]]);
    assert_eq!(selected(&harness), [0]);
    is_one_step(&mut harness, &before);
    // Two remain: nothing of it is done.
    tap(&mut harness, Key::A, Modifiers::CTRL);
    let there = text(&harness);
    tap(&mut harness, Key::Delete, Modifiers::NONE);
    assert_eq!(text(&harness), there);
    assert!(message(&harness).unwrap().1);
}

#[test]
fn fields_and_buttons_change_all() {
    let mut harness = pyramid_window();
    // Else the ways next to what turns get frames of their own.
    harness.state_mut().setup.fixed_times = Some(false);
    choose(&mut harness, &[0, 1, 3]);
    let texts = harness.state().texts();
    let before = text(&harness);
    let from = positions(&harness);
    let x = fill(texts.position.coordinate, &[&"x"]);
    enter_in(&mut harness, &x, "-0.5");
    let now = positions(&harness);
    assert_eq!(now[0], DVec3::new(-0.5, from[0].y, from[0].z));
    for at in [1, 3] {
        assert!((now[at].x - from[at].x - (-0.5 - from[0].x)).abs() < 1e-15);
        assert_eq!((now[at].y, now[at].z), (from[at].y, from[at].z));
    }
    is_one_step(&mut harness, &before);
    harness.state_mut().document.undo();
    choose(&mut harness, &[0, 1, 3]);
    let views = |harness: &Window<'_>| -> Vec<_> {
        let points = &harness.state().document.path().points;
        points
            .iter()
            .map(|point| point.orientations.clone())
            .collect()
    };
    let old = views(&harness);
    enter_in(&mut harness, texts.orientation.roll, "30");
    for (at, orientations) in views(&harness).iter().enumerate() {
        for (k, orientation) in orientations.iter().enumerate() {
            // The first orientation of each, and nothing else of it.
            let mut wanted = old[at][k].clone();
            if k == 0 && [0, 1, 3].contains(&at) {
                wanted.roll = 30.0;
            }
            assert_eq!(*orientation, wanted, "{at} {k}");
        }
    }
    is_one_step(&mut harness, &before);
    harness.state_mut().document.undo();
    choose(&mut harness, &[0, 1, 3]);
    click_label(&mut harness, texts.orientation.relative);
    let relative = |orientation: &vides_engine::path::Orientation| {
        matches!(orientation.target, vides_engine::path::Target::Relative(_))
    };
    let turned: Vec<bool> = views(&harness).iter().map(|of| relative(&of[0])).collect();
    assert_eq!(turned, [true, true, false, true, false, false]);
    is_one_step(&mut harness, &before);
    harness.state_mut().document.undo();
    choose(&mut harness, &[0, 1, 3]);
    let context = harness.ctx.clone();
    let edit = vides_document::Edit::set(At::Point(0), "preset", 4);
    harness.state_mut().act(Action::Edit(edit), &context);
    for at in [0, 1, 3] {
        let curve = harness.state().document.path().points[at].curve;
        assert_eq!(curve, CurveParameters::Preset(4));
    }
    is_one_step(&mut harness, &before);
}

fn enter_in(harness: &mut Window<'_>, name: &str, text: &str) {
    use egui_kittest::kittest::Queryable;
    harness
        .get_all_by_role_and_label(egui::Role::SpinButton, name)
        .last()
        .expect("a number")
        .click();
    harness.run();
    harness.event(egui::Event::Text(text.to_owned()));
    harness.run();
    tap(harness, Key::Enter, Modifiers::NONE);
    harness.run();
}

fn click_label(harness: &mut Window<'_>, label: &str) {
    use egui_kittest::kittest::Queryable;
    harness.get_by_label(label).click();
    harness.run();
}

fn write(harness: &mut Window<'_>, text: &str) {
    harness.event(egui::Event::Text(text.to_owned()));
    harness.step();
}

#[test]
fn tools_turn_and_scale_about_the_middle() {
    let mut harness = pyramid_window();
    let points = [0, 1, 4, 5];
    let turned = DMat3::from_rotation_y(std::f64::consts::FRAC_PI_2);
    let cases: [(&[Key], &str, DMat3); 5] = [
        (&[Key::S], "0,5", DMat3::from_diagonal(DVec3::splat(0.5))),
        (
            &[Key::S, Key::X],
            "0.25",
            DMat3::from_diagonal(DVec3::new(0.25, 1.0, 1.0)),
        ),
        (&[Key::R, Key::Y], "90", turned),
        (&[Key::R, Key::X, Key::Y], "90", turned),
        (&[Key::R, Key::Y, Key::Y, Key::Y], "-270", turned),
    ];
    for (keys, number, wanted) in cases {
        choose(&mut harness, &points);
        let (before, from) = (text(&harness), positions(&harness));
        let middle = points.iter().map(|&at| from[at]).sum::<DVec3>() / 4.0;
        for &key in keys {
            tap(&mut harness, key, Modifiers::NONE);
        }
        // What the mouse does counts no more once a number stands there.
        let beside = empty(&harness);
        motion(&mut harness, beside);
        write(&mut harness, number);
        tap(&mut harness, Key::Enter, Modifiers::NONE);
        let now = positions(&harness);
        for at in 0..6 {
            let to = middle + wanted * (from[at] - middle);
            let to = if points.contains(&at) { to } else { from[at] };
            assert!(
                (now[at] - to).length() < 1e-14,
                "{keys:?} {at}: {} {to}",
                now[at]
            );
        }
        assert_eq!(selected(&harness), points);
        is_one_step(&mut harness, &before);
        harness.state_mut().document.undo();
    }
}

#[test]
fn tools_follow_the_mouse_and_end_by_click_or_escape() {
    let mut harness = pyramid_window();
    choose(&mut harness, &[0, 1, 5]);
    let (before, from) = (text(&harness), positions(&harness));
    let middle = (from[0] + from[1] + from[5]) / 3.0;
    let centre = image(&harness, middle);
    motion(&mut harness, centre + vec2(100.0, 0.0));
    tap(&mut harness, Key::S, Modifiers::NONE);
    motion(&mut harness, centre + vec2(0.0, 50.0));
    let now = positions(&harness);
    for at in [0, 1, 5] {
        let wanted = middle + 0.5 * (from[at] - middle);
        assert!((now[at] - wanted).length() < 1e-6, "{at}");
    }
    tap(&mut harness, Key::Escape, Modifiers::NONE);
    assert_eq!(text(&harness), before);
    assert!(!harness.state().document.can_undo());
    assert_eq!(selected(&harness), [0, 1, 5], "Escape ends the tool first");
    // A quarter turn as it is seen from above, anticlockwise: z goes to x.
    harness.state_mut().setup.view = View {
        rotation: 0.0,
        tilt: 90.0,
        ..View::default()
    };
    harness.step();
    let centre = image(&harness, middle);
    motion(&mut harness, centre + vec2(0.0, 90.0));
    tap(&mut harness, Key::R, Modifiers::NONE);
    motion(&mut harness, centre + vec2(90.0, 0.0));
    let now = positions(&harness);
    let turned = DMat3::from_rotation_y(std::f64::consts::FRAC_PI_2);
    assert!((turned * DVec3::Z - DVec3::X).length() < 1e-15);
    for at in [0, 1, 5] {
        let wanted = middle + turned * (from[at] - middle);
        assert!((now[at] - wanted).length() < 1e-6, "{at}");
    }
    // A click anywhere ends it, and chooses nothing.
    press(&mut harness, centre + vec2(90.0, 0.0), LEFT);
    release(&mut harness, centre + vec2(90.0, 0.0), LEFT);
    assert_eq!(selected(&harness), [0, 1, 5]);
    is_one_step(&mut harness, &before);
    harness.state_mut().document.undo();
    // Moved along an axis by a number, one point alone too.
    choose(&mut harness, &[3]);
    for key in [Key::M, Key::X] {
        tap(&mut harness, key, Modifiers::NONE);
    }
    write(&mut harness, "-0.5");
    tap(&mut harness, Key::Enter, Modifiers::NONE);
    assert!((position(&harness, 3) - from[3] + 0.5 * DVec3::X).length() < 1e-15);
    is_one_step(&mut harness, &before);
    harness.state_mut().document.undo();
    tap(&mut harness, Key::S, Modifiers::NONE);
    let said = harness.state().texts().space.needs_several;
    assert_eq!(message(&harness), Some((said.to_owned(), false)));
    assert_eq!(text(&harness), before);
}

#[test]
fn the_ring_turns_and_its_square_scales() {
    let mut harness = pyramid_window();
    // From above, where y points at the viewer.
    harness.state_mut().setup.view = View {
        rotation: 0.0,
        tilt: 90.0,
        ..View::default()
    };
    choose(&mut harness, &[0, 5]);
    let (before, from) = (text(&harness), positions(&harness));
    let middle = (from[0] + from[5]) / 2.0;
    let centre = image(&harness, middle);
    let on_ring = centre + vec2(0.0, 56.0);
    press(&mut harness, on_ring, LEFT);
    motion(&mut harness, centre + vec2(56.0, 0.0));
    assert!(harness.state().document.in_step());
    release(&mut harness, centre + vec2(56.0, 0.0), LEFT);
    let turned = DMat3::from_rotation_y(std::f64::consts::FRAC_PI_2);
    for at in [0, 5] {
        let wanted = middle + turned * (from[at] - middle);
        let now = position(&harness, at);
        assert!((now - wanted).length() < 1e-6, "{at}: {now}");
    }
    assert_eq!(selected(&harness), [0, 5]);
    is_one_step(&mut harness, &before);
    harness.state_mut().document.undo();
    harness.step();
    choose(&mut harness, &[0, 5]);
    let square = vec2(56.0, -56.0) * std::f32::consts::FRAC_1_SQRT_2;
    press(&mut harness, centre + square, LEFT);
    motion(&mut harness, centre + square * 1.5);
    // A number takes the place of the mouse here too.
    tap(&mut harness, Key::X, Modifiers::NONE);
    write(&mut harness, "2");
    release(&mut harness, centre + square * 1.5, LEFT);
    for at in [0, 5] {
        let mut wanted = from[at];
        wanted.x = middle.x + 2.0 * (from[at].x - middle.x);
        assert!((position(&harness, at) - wanted).length() < 1e-12);
    }
    is_one_step(&mut harness, &before);
    // A press alone, and one that is taken back, change nothing.
    harness.state_mut().document.undo();
    harness.step();
    choose(&mut harness, &[0, 5]);
    press(&mut harness, on_ring, LEFT);
    release(&mut harness, on_ring, LEFT);
    press(&mut harness, on_ring, LEFT);
    motion(&mut harness, on_ring + vec2(30.0, 0.0));
    tap(&mut harness, Key::Escape, Modifiers::NONE);
    release(&mut harness, on_ring, LEFT);
    assert_eq!(text(&harness), before);
    assert!(!harness.state().document.can_undo());
    assert_eq!(selected(&harness), [0, 5]);
}

#[test]
fn pictures_of_several() {
    for (name, theme, language) in [
        ("several-dark-de.png", Theme::Dark, Language::German),
        ("several-light-en.png", Theme::Light, Language::English),
    ] {
        let mut editor = editor(pyramid(), language);
        editor.setup.theme = Some(theme);
        let mut harness = window(editor, vec2(1200.0, 800.0), 1.0);
        choose(&mut harness, &[1, 2, 3]);
        screenshot(&mut harness, name);
        tap(&mut harness, Key::R, Modifiers::NONE);
        tap(&mut harness, Key::Y, Modifiers::NONE);
        write(&mut harness, "20");
        screenshot(&mut harness, &format!("turned-{name}"));
        tap(&mut harness, Key::Enter, Modifiers::NONE);
        let corner = viewport(&harness).left_top() + vec2(120.0, 160.0);
        hold(&mut harness, Modifiers::CTRL);
        press(&mut harness, corner, LEFT);
        motion(&mut harness, corner + vec2(240.0, 200.0));
        screenshot(&mut harness, &format!("box-{name}"));
    }
}

#[test]
fn a_number_typed_while_the_mouse_drags_is_the_distance() {
    let mut harness = pyramid_window();
    let before = text(&harness);
    let from = position(&harness, 2);
    let at = image(&harness, from);
    press(&mut harness, at, PointerButton::Secondary);
    motion(&mut harness, at + vec2(12.0, 5.0));
    let way = (position(&harness, 2) - from).normalize();
    assert_eq!(way.z, 0.0);
    write(&mut harness, "0.1255");
    tap(&mut harness, Key::Backspace, Modifiers::NONE);
    let moved = position(&harness, 2) - from;
    assert!((moved - way * 0.125).length() < 1e-12, "{moved}");
    // Only the pointer's direction counts from now on.
    motion(&mut harness, at + vec2(24.0, 10.0));
    assert!((position(&harness, 2) - from).distance(way * 0.125) < 1e-2);
    motion(&mut harness, at - vec2(24.0, 10.0));
    assert!((position(&harness, 2) - from).distance(way * -0.125) < 1e-2);
    // Along one line, and not farther than the space.
    tap(&mut harness, Key::Z, Modifiers::NONE);
    for _ in 0..5 {
        tap(&mut harness, Key::Backspace, Modifiers::NONE);
    }
    write(&mut harness, "9");
    let place = position(&harness, 2);
    assert_eq!(place.z, from.z);
    assert_eq!(place.abs().max_element(), 1.0);
    release(&mut harness, at, PointerButton::Secondary);
    is_one_step(&mut harness, &before);
    // The next drag begins without a number.
    let from = position(&harness, 1);
    let at = image(&harness, from);
    press(&mut harness, at, PointerButton::Secondary);
    motion(&mut harness, at + vec2(12.0, 5.0));
    let end = image(&harness, position(&harness, 1));
    assert!((end - at - vec2(12.0, 5.0)).length() < 0.1);
    tap(&mut harness, Key::Escape, Modifiers::NONE);
}

#[test]
fn a_number_typed_while_the_camera_is_rolled_is_the_roll() {
    let mut harness = pyramid_window();
    let tip = image(&harness, tips(&harness).up_tip);
    press(&mut harness, tip, PointerButton::Primary);
    motion(&mut harness, tip + vec2(20.0, 12.0));
    write(&mut harness, "-12,5");
    release(&mut harness, tip + vec2(20.0, 12.0), PointerButton::Primary);
    assert_eq!(harness.state().orientation().unwrap().roll, -12.5);
}

#[test]
fn what_is_moved_against_a_face_says_how_far_it_came() {
    let mut harness = pyramid_window();
    choose(&mut harness, &[0, 1, 5]);
    let from = positions(&harness);
    let start = image(&harness, from[1]);
    motion(&mut harness, start);
    tap(&mut harness, Key::M, Modifiers::NONE);
    for way in [vec2(4.0, -3.0), vec2(900.0, -300.0)] {
        motion(&mut harness, start + way);
        let editor = harness.state();
        let by = position(&harness, current(&harness)) - from[current(&harness)];
        assert!(by != DVec3::ZERO);
        let [x, y, z] = by.to_array().map(|by| editor.language().number(by, 3));
        let words = fill(editor.texts().space.moved_by, &[&x, &y, &z]);
        let tool = editor.space.pointer.transform.as_ref().unwrap();
        let hint = tool.hint(editor, &projection_of(editor, viewport(&harness)));
        assert!(hint.starts_with(&words), "{words}: {hint}");
    }
    screenshot(&mut harness, "moved-against-a-face.png");
    tap(&mut harness, Key::X, Modifiers::NONE);
    motion(&mut harness, start + vec2(90.0, -30.0));
    screenshot(&mut harness, "moved-along-x.png");
    tap(&mut harness, Key::Escape, Modifiers::NONE);
    assert_eq!(positions(&harness), from);
}
