//! Shortcuts and numbers by the keyboard: who gets which key.

use vides_document::At;
use vides_engine::path::Timeline;

use super::*;

#[test]
fn a_number_takes_comma_and_point_and_refuses_the_rest() {
    for (language, name) in [
        (Language::German, "Position x"),
        (Language::English, "Position x"),
    ] {
        let mut window = window(language);
        let x = |window: &Window| window.state().point().expect("there").position.x;
        enter(&mut window, name, "0,25");
        assert_eq!(x(&window), 0.25);
        enter(&mut window, name, "-0.125");
        assert_eq!(x(&window), -0.125);
        assert_eq!(value(&window, name), language.number(-0.125, 3));
        enter(&mut window, name, "abc");
        assert_eq!(x(&window), -0.125);
        let message = fill(language.texts().errors.no_number, &[&name, &"abc"]);
        assert_eq!(said(&window), Some(message));
        enter(&mut window, name, "1e300");
        assert_eq!(x(&window), -0.125);
        // Two entries were made: two steps.
        press(&mut window, Modifiers::CTRL, Key::Z);
        assert_eq!(x(&window), 0.25);
        press(&mut window, Modifiers::CTRL, Key::Z);
        assert_eq!(x(&window), -0.6);
        assert!(!window.state().document.can_undo());
    }
}

#[test]
fn a_number_takes_other_units_and_changes() {
    let mut window = window(Language::English);
    let fps = window.state().document.info().fps;
    let texts = Language::English.texts();
    let hold = |window: &Window| {
        let path = window.state().document.path();
        path.points[0].orientations[0].hold
    };
    enter(&mut window, texts.timing.hold, "2s");
    assert_eq!(f64::from(hold(&window)), 2.0 * fps);
    enter(&mut window, texts.timing.hold, "/2");
    assert_eq!(f64::from(hold(&window)), fps);
    enter(&mut window, texts.timing.hold, "2 km");
    assert_eq!(f64::from(hold(&window)), fps);
    let message = fill(texts.errors.no_unit, &[&texts.timing.hold, &"km"]);
    assert_eq!(said(&window), Some(message));
    enter(&mut window, texts.space.duration, "200fr");
    assert_eq!(
        window
            .state()
            .document
            .timeline(Timeline::frame_count)
            .unwrap()
            .unwrap(),
        200
    );
    let x = |window: &Window| window.state().point().expect("there").position.x;
    let mut info = window.state().document.info().clone();
    info.unit = "cm".to_owned();
    let edit = Edit::SetInfo(Box::new(info));
    window.state_mut().document.apply(edit).unwrap();
    enter(&mut window, "Position x", "0.002m");
    assert_eq!(said(&window), None);
    assert!((x(&window) - 0.2).abs() < 1e-12);
    enter(&mut window, "Position x", "+10%");
    assert!((x(&window) - 0.22).abs() < 1e-12);
}

#[test]
fn escape_leaves_the_old_value() {
    let mut window = window(Language::German);
    type_into(&mut window, "Position x", "0,9");
    press(&mut window, Modifiers::NONE, Key::Escape);
    assert_eq!(window.state().point().expect("there").position.x, -0.6);
    assert!(!window.state().document.can_undo());
    assert_eq!(value(&window, "Position x"), "−0,600");
}

#[test]
fn a_value_that_was_not_touched_keeps_every_digit() {
    let mut window = window(Language::German);
    let odd = DVec3::new(0.123_456_789_012, 0.2, 0.8);
    window
        .state_mut()
        .edit(Edit::set(At::Point(0), "position", odd));
    window.run();
    window.get_by_label("Position x").click();
    window.run();
    press(&mut window, Modifiers::NONE, Key::Enter);
    assert_eq!(window.state().point().expect("there").position, odd);
}

#[test]
fn tab_goes_from_field_to_field_and_applies() {
    let mut window = window(Language::German);
    type_into(&mut window, "Position x", "0,1");
    press(&mut window, Modifiers::NONE, Key::Tab);
    assert_eq!(window.state().point().expect("there").position.x, 0.1);
    assert!(window.get_by_label("Position y").is_focused());
    press(&mut window, Modifiers::NONE, Key::Tab);
    assert!(window.get_by_label("Position z").is_focused());
    press(&mut window, Modifiers::SHIFT, Key::Tab);
    assert!(window.get_by_label("Position y").is_focused());
}

#[test]
fn arrows_step_a_number() {
    let mut window = window(Language::German);
    window.get_by_label("Rollen").click();
    window.run();
    press(&mut window, Modifiers::NONE, Key::ArrowUp);
    press(&mut window, Modifiers::NONE, Key::ArrowUp);
    press(&mut window, Modifiers::NONE, Key::ArrowDown);
    assert_eq!(window.state().orientation().expect("there").roll, 1.0);
}

#[test]
fn a_drag_is_one_step_and_escape_takes_it_back() {
    for broken_off in [false, true] {
        let mut window = window(Language::German);
        let rect = window.get_by_label("Position x").rect();
        let center = rect.center();
        window.drag_at(center);
        window.run();
        for x in 1..40 {
            window.hover_at(center + vec2(x as f32, 0.0));
            window.run();
        }
        let x = window.state().point().expect("there").position.x;
        assert!(x > -0.55, "{x}");
        assert_eq!(x, (x * 1000.0).round() / 1000.0);
        if broken_off {
            press(&mut window, Modifiers::NONE, Key::Escape);
            assert_eq!(window.state().point().expect("there").position.x, -0.6);
            window.hover_at(center + vec2(80.0, 0.0));
            window.run();
            window.drop_at(center + vec2(80.0, 0.0));
            window.run();
            assert_eq!(window.state().point().expect("there").position.x, -0.6);
            assert!(!window.state().document.can_undo());
        } else {
            window.drop_at(center + vec2(40.0, 0.0));
            window.run();
            press(&mut window, Modifiers::CTRL, Key::Z);
            assert_eq!(window.state().point().expect("there").position.x, -0.6);
            assert!(!window.state().document.can_undo());
            press(&mut window, Modifiers::CTRL | Modifiers::SHIFT, Key::Z);
            assert_eq!(window.state().point().expect("there").position.x, x);
            press(&mut window, Modifiers::CTRL, Key::Z);
            press(&mut window, Modifiers::CTRL, Key::Y);
            assert_eq!(window.state().point().expect("there").position.x, x);
        }
    }
}

#[test]
fn a_text_that_is_typed_keeps_its_keys() {
    let mut window = window(Language::German);
    click_button(&mut window, |texts| texts.position.add);
    type_into(&mut window, "Position x", "0,5");
    press(&mut window, Modifiers::CTRL, Key::Z);
    press(&mut window, Modifiers::NONE, Key::Delete);
    assert_eq!(window.state().document.path().points.len(), 3);
    // Any other shortcut lets the text apply first.
    press(&mut window, Modifiers::NONE, Key::Escape);
    type_into(&mut window, "Position x", "0,5");
    press(&mut window, Modifiers::ALT, Key::Z);
    assert!(window.state().windows.display.is_some());
    assert_eq!(window.state().point().expect("there").position.x, 0.5);
}

/// Presses keys that come in one pass, as after a host that was busy.
fn press_together(window: &mut Window, keys: &[(Modifiers, Key)]) {
    let all = keys.iter().flat_map(|&(modifiers, key)| {
        [true, false].map(|pressed| egui::Event::Key {
            key,
            physical_key: None,
            pressed,
            repeat: false,
            modifiers,
        })
    });
    window.input_mut().events.extend(all);
    window.run();
}

#[test]
fn shortcuts_that_come_together_are_all_done_in_their_order() {
    let mut window = window(Language::German);
    let points = |window: &Window| window.state().document.path().points.len();
    let insert = (Modifiers::NONE, Key::Insert);
    press_together(&mut window, &[insert, insert, insert]);
    assert_eq!(points(&window), 5);
    let undo = (Modifiers::CTRL, Key::Z);
    press_together(&mut window, &[undo, undo, (Modifiers::CTRL, Key::Y)]);
    assert_eq!(points(&window), 4);
    // A question stops the rest: nobody has seen it.
    press_together(&mut window, &[(Modifiers::ALT, Key::L), undo]);
    assert!(window.state().windows.has_modal());
    assert_eq!(points(&window), 4);
}

#[test]
fn the_panels_buttons_have_keys() {
    let mut window = window(Language::English);
    let state = |window: &Window| {
        let document = window.state().document();
        let at = document.selection();
        let orientations = &document.path().points[at.point].orientations;
        let absolute = matches!(orientations[at.orientation].target, Target::Absolute(_));
        (
            (document.path().points.len(), orientations.len()),
            (at.point, at.orientation),
            absolute,
        )
    };
    let ctrl_shift = Modifiers::CTRL | Modifiers::SHIFT;
    for (modifiers, key, expected) in [
        (Modifiers::NONE, Key::Insert, ((3, 1), (1, 0), false)),
        (Modifiers::CTRL, Key::PageDown, ((3, 1), (2, 0), false)),
        (Modifiers::CTRL, Key::PageDown, ((3, 1), (0, 0), false)),
        (Modifiers::CTRL, Key::PageUp, ((3, 1), (2, 0), false)),
        (Modifiers::ALT, Key::Insert, ((3, 2), (2, 1), false)),
        (Modifiers::NONE, Key::F6, ((3, 2), (2, 1), true)),
        (ctrl_shift, Key::PageDown, ((3, 2), (2, 0), false)),
        (ctrl_shift, Key::PageUp, ((3, 2), (2, 1), true)),
        (Modifiers::NONE, Key::F6, ((3, 2), (2, 1), false)),
        (Modifiers::ALT, Key::Delete, ((3, 1), (2, 0), false)),
        (Modifiers::NONE, Key::Delete, ((2, 1), (1, 0), false)),
    ] {
        press(&mut window, modifiers, key);
        assert_eq!(state(&window), expected, "{modifiers:?} {key:?}");
    }
    press(&mut window, Modifiers::NONE, Key::F4);
    assert!(!window.state().setup.camera_view);
    press(&mut window, Modifiers::CTRL, Key::PageUp);
    press(&mut window, Modifiers::CTRL, Key::I);
    assert!(window.state().windows.points.is_some());
    press(&mut window, Modifiers::NONE, Key::F2);
    assert!(window.state().windows.curve.is_some());
    press(&mut window, Modifiers::NONE, Key::F3);
    assert!(window.state().windows.speed.is_some());
    // The tooltips say so.
    press(&mut window, Modifiers::NONE, Key::Escape);
    press(&mut window, Modifiers::NONE, Key::Escape);
    press(&mut window, Modifiers::NONE, Key::Escape);
    let texts = &Language::English.texts().position;
    let at = window.get_by_label(texts.remove).rect().center();
    window.hover_at(at);
    for _ in 0..4 {
        window.step();
    }
    let hint = format!("{} (Del)", texts.remove_hint);
    assert!(window.query_by_label(&hint).is_some());
}

#[test]
fn the_flight_is_played_and_stopped_from_anywhere() {
    let mut window = window(Language::English);
    window.key_press_modifiers(Modifiers::NONE, Key::F5);
    window.step();
    assert!(window.state().playing.is_playing());
    window.key_press_modifiers(Modifiers::NONE, Key::F5);
    window.step();
    assert!(!window.state().playing.is_playing());
}

#[test]
fn undo_and_redo_say_when_there_is_nothing() {
    for language in BOTH {
        let mut window = window(language);
        let texts = &language.texts().output;
        press(&mut window, Modifiers::CTRL, Key::Z);
        assert_eq!(said(&window).as_deref(), Some(texts.nothing_to_undo));
        press(&mut window, Modifiers::CTRL, Key::Y);
        assert_eq!(said(&window).as_deref(), Some(texts.nothing_to_redo));
    }
}

#[test]
fn an_orientation_is_copied_and_pasted() {
    let mut window = window(Language::German);
    enter(&mut window, "Rollen", "45");
    // One event, so that the step shows what came of it.
    let pressed = |key| egui::Event::Key {
        key,
        physical_key: None,
        pressed: true,
        repeat: false,
        modifiers: Modifiers::CTRL,
    };
    window.event(pressed(Key::C));
    window.step();
    let commands = window.output().platform_output.commands.iter();
    let text = commands.last().and_then(|command| match command {
        egui::OutputCommand::CopyText(text) => Some(text.clone()),
        _ => None,
    });
    window.run();
    press(&mut window, Modifiers::CTRL, Key::PageDown);
    window.event(pressed(Key::V));
    window.step();
    let paste = |output: &egui::ViewportOutput| {
        output
            .commands
            .contains(&egui::ViewportCommand::RequestPaste)
    };
    assert!(window.output().viewport_output.values().any(paste));
    let text = text.expect("a text");
    assert!(text.contains("roll_degrees = 45.0"), "{text}");
    window.event(egui::Event::Paste(text));
    window.run();
    assert_eq!(window.state().orientation().expect("there").roll, 45.0);
    press(&mut window, Modifiers::CTRL, Key::Z);
    assert_eq!(window.state().orientation().expect("there").roll, 0.0);
}

#[test]
fn an_idle_window_wakes_nobody() {
    let mut window = window(Language::German);
    press(&mut window, Modifiers::NONE, Key::F1);
    window.get_by_label("Position x").click();
    window.run();
    window.step();
    let delay = window
        .output()
        .viewport_output
        .values()
        .map(|output| output.repaint_delay);
    assert_eq!(delay.min(), Some(std::time::Duration::MAX));
}

#[test]
fn escape_closes_the_topmost_window_and_one_only() {
    let mut window = window(Language::German);
    press(&mut window, Modifiers::ALT, Key::Z);
    press(&mut window, Modifiers::NONE, Key::F1);
    assert!(window.state().windows.help.is_some());
    press(&mut window, Modifiers::NONE, Key::Escape);
    assert!(window.state().windows.help.is_none());
    assert!(window.state().windows.display.is_some());
    press(&mut window, Modifiers::NONE, Key::Escape);
    assert!(window.state().windows.display.is_none());
}

/// Buttons of these words, in the order in which Tab goes through them, and from left
/// to right or from above.
fn tabbed(window: &mut Window, names: &[&str]) -> Vec<String> {
    let count = |window: &Window, name: &str| window.query_all_by_label(name).count();
    assert!(names.iter().all(|name| count(window, name) > 0));
    window.get_by_role_and_label(Role::Button, names[0]).focus();
    window.run();
    let mut found = vec![names[0].to_owned()];
    while found.len() < names.len() {
        press(window, Modifiers::NONE, Key::Tab);
        let focused = names.iter().find(|&&name| {
            window
                .get_by_role_and_label(Role::Button, name)
                .is_focused()
        });
        found.push(focused.map_or("elsewhere", |name| name).to_owned());
    }
    let places: Vec<f32> = names
        .iter()
        .map(|name| {
            window
                .get_by_role_and_label(Role::Button, name)
                .rect()
                .left()
        })
        .collect();
    assert!(places.is_sorted(), "{names:?} {places:?}");
    found
}

#[test]
fn tab_goes_through_buttons_as_they_are_read() {
    for language in BOTH {
        let texts = language.texts();
        let mut window = window(language);
        press(&mut window, Modifiers::NONE, Key::F2);
        let names = [texts.curve.show, texts.curve.ok];
        assert_eq!(tabbed(&mut window, &names), names);
        press(&mut window, Modifiers::NONE, Key::Escape);
        press(&mut window, Modifiers::NONE, Key::F3);
        click(&mut window, texts.speed_window.copy);
        let speed = &texts.speed_window;
        let names = [speed.copy, speed.paste, speed.reset];
        assert_eq!(tabbed(&mut window, &names), names);
        click(&mut window, texts.position.add);
        window.state_mut().ask_to_close();
        window.run();
        let question = &texts.questions;
        assert!(window.get_by_label(question.save).is_focused());
        let names = [question.cancel, question.discard, question.save];
        assert_eq!(tabbed(&mut window, &names), names);
        // And round again.
        press(&mut window, Modifiers::NONE, Key::Tab);
        assert!(window.get_by_label(question.cancel).is_focused());
    }
}
