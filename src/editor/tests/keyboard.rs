//! Shortcuts and numbers by the keyboard: who gets which key.

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
    window.state_mut().edit(Edit::SetPosition {
        at: 0,
        position: odd,
    });
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
    window.get_by_label("Winkel").click();
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
    click(&mut window, "Pos.+");
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
    enter(&mut window, "Winkel", "45");
    press(&mut window, Modifiers::CTRL, Key::C);
    click(&mut window, "Pos. >>");
    press(&mut window, Modifiers::CTRL, Key::V);
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
