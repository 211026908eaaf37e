//! The curve window (thesis A.4.1).

use vides_document::At;
use vides_engine::path::{CameraPath, CurveParameters, Tcb};

use crate::screenshots::screenshot;
use crate::tests::*;

/// A window at the third point with the curve window open.
fn opened(language: Language) -> Window {
    let mut window = window_with_points(language, LARGE, 1.0, Theme::Dark);
    press(&mut window, Modifiers::NONE, Key::F2);
    window
}

/// The words at a preset's choice, as it is in the document.
fn preset(window: &Window, language: Language, preset: usize) -> String {
    let tcb = window.state().document.path().presets[preset];
    language.texts().curve.preset_name(preset, tcb)
}

fn choose(window: &mut Window, number: usize) {
    let name = preset(window, window.state().language(), number);
    click(window, &name);
}

fn tcb(window: &Window, point: usize) -> Tcb {
    window.state().document.path().tcb(point)
}

#[test]
fn a_preset_is_chosen_and_applied_by_show() {
    for language in BOTH {
        let texts = &language.texts().curve;
        let mut window = opened(language);
        assert!(window.query_by_label(texts.title).is_some());
        choose(&mut window, 5);
        assert_eq!(tcb(&window, 2), Tcb::default(), "pending only");
        assert!(window.query_by_label(texts.waiting).is_some());
        click(&mut window, texts.show);
        assert_eq!(tcb(&window, 2), Tcb::new(0.0, -0.5, 0.0));
        let point = &window.state().document.path().points[2];
        assert_eq!(point.curve, CurveParameters::Preset(5));
        assert!(window.query_by_label(texts.title).is_some(), "stays open");
        assert!(window.query_by_label(texts.waiting).is_none());
        // One step back.
        press(&mut window, Modifiers::CTRL, Key::Z);
        assert_eq!(tcb(&window, 2), Tcb::default());
        assert!(!window.state().document.is_modified());
    }
}

#[test]
fn ok_applies_everything_as_one_step_and_closes() {
    for language in BOTH {
        let texts = &language.texts().curve;
        let mut window = opened(language);
        click(&mut window, texts.own);
        enter(&mut window, texts.tension, "0.5");
        enter(&mut window, texts.bias, "-0,25");
        enter(&mut window, &format!("{} y", texts.position), "0.4");
        enter(&mut window, &format!("{} z", texts.orientation), "-0.1");
        enter(&mut window, texts.roll, "370");
        assert!(!window.state().document.is_modified());
        click(&mut window, texts.ok);
        assert!(window.query_by_label(texts.title).is_none());
        let document = &window.state().document;
        let point = &document.path().points[2];
        assert_eq!(point.curve, CurveParameters::Own(Tcb::new(0.5, 0.0, -0.25)));
        assert_eq!(point.position, DVec3::new(0.72, 0.4, 0.6));
        let target = Target::Absolute(DVec3::new(0.0, 0.15, -0.1));
        assert_eq!(point.orientations[0].target, target);
        assert_eq!(point.orientations[0].roll, 10.0);
        press(&mut window, Modifiers::CTRL, Key::Z);
        assert!(!window.state().document.is_modified());
    }
}

/// The continuity slider goes three steps up.
fn slide(window: &mut Window, language: Language) {
    let texts = &language.texts().curve;
    let slider = window.get_by_role_and_label(Role::Slider, texts.continuity);
    slider.focus();
    window.run();
    for _ in 0..3 {
        press(window, Modifiers::NONE, Key::ArrowRight);
    }
}

#[test]
fn a_preset_that_others_use_is_changed_for_all_if_that_is_meant() {
    for language in BOTH {
        let texts = &language.texts().curve;
        let mut window = opened(language);
        slide(&mut window, language);
        assert_eq!(tcb(&window, 2), Tcb::default(), "pending only");
        // Five of the six use preset 0; there and back again, and there.
        let all = fill(texts.for_all, &[&5]);
        click(&mut window, &all);
        click(&mut window, texts.for_this);
        click(&mut window, &all);
        let changed = Tcb::new(0.0, 0.03, 0.0);
        let name = format!("{} *", texts.preset_name(0, changed));
        assert!(window.query_by_label(&name).is_some());
        // What comes then is meant so, too.
        enter(&mut window, texts.tension, "0.5");
        click(&mut window, texts.show);
        for point in [0, 1, 2, 4, 5] {
            let found = tcb(&window, point);
            assert!((found.continuity - 0.03).abs() < 1e-12 && found.tension == 0.5);
        }
        assert_eq!(tcb(&window, 3), Tcb::new(0.0, -0.5, 0.0), "another preset");
        press(&mut window, Modifiers::CTRL, Key::Z);
        assert!(!window.state().document.is_modified());
    }
}

#[test]
fn a_preset_that_others_use_is_left_alone_without_a_word() {
    let texts = &Language::English.texts().curve;
    let mut window = opened(Language::English);
    slide(&mut window, Language::English);
    click(&mut window, texts.show);
    let path = window.state().document.path();
    assert_eq!(path.presets, CameraPath::default().presets);
    let CurveParameters::Own(own) = path.points[2].curve else {
        panic!("{:?}", path.points[2].curve);
    };
    assert!((own.continuity - 0.03).abs() < 1e-12);
    // The only one that uses it changes it.
    let mut window = opened(Language::English);
    choose(&mut window, 7);
    enter(&mut window, texts.tension, "0.5");
    assert!(window.query_by_label(texts.for_this).is_none());
    click(&mut window, texts.show);
    assert_eq!(window.state().document.path().presets[7].tension, 0.5);
}

#[test]
fn own_values_begin_as_those_in_force() {
    let texts = &Language::English.texts().curve;
    let mut window = opened(Language::English);
    choose(&mut window, 2);
    click(&mut window, texts.own);
    click(&mut window, texts.show);
    let point = &window.state().document.path().points[2];
    assert_eq!(point.curve, CurveParameters::Own(Tcb::new(0.6, 0.0, 0.0)));
}

#[test]
fn escape_and_closing_discard() {
    let texts = &Language::German.texts().curve;
    let mut window = opened(Language::German);
    choose(&mut window, 5);
    press(&mut window, Modifiers::NONE, Key::Escape);
    assert!(window.query_by_label(texts.title).is_none());
    assert!(!window.state().document.is_modified());
    press(&mut window, Modifiers::NONE, Key::F2);
    assert!(window.query_by_label(texts.waiting).is_none());
}

#[test]
fn another_point_or_orientation_discards_with_a_message() {
    for language in BOTH {
        let texts = language.texts();
        for keys in [Modifiers::CTRL, Modifiers::CTRL | Modifiers::SHIFT] {
            let mut window = opened(language);
            choose(&mut window, 5);
            press(&mut window, keys, Key::PageDown);
            assert_eq!(said(&window).as_deref(), Some(texts.curve.given_up));
            assert!(window.query_by_label(texts.curve.waiting).is_none());
            click(&mut window, texts.curve.show);
            assert!(!window.state().document.is_modified());
        }
        // Nothing pending, nothing to say.
        let mut window = opened(language);
        press(&mut window, Modifiers::CTRL, Key::PageDown);
        assert_eq!(said(&window), None);
    }
}

#[test]
fn undo_and_loading_discard_with_a_message() {
    let texts = Language::English.texts();
    let mut window = opened(Language::English);
    let edit = Edit::set(At::Path, "closed", true);
    window.state_mut().document.apply(edit).unwrap();
    window.run();
    choose(&mut window, 5);
    // An edit elsewhere leaves it.
    let edit = Edit::set(At::Path, "closed", false);
    window.state_mut().document.apply(edit).unwrap();
    window.run();
    assert!(window.query_by_label(texts.curve.waiting).is_some());
    window.state_mut().document.undo();
    window.run();
    assert_eq!(said(&window).as_deref(), Some(texts.curve.given_up_changed));
    assert!(window.query_by_label(texts.curve.waiting).is_none());

    // The very same path again, as a document as young as the old one; with a
    // host's speeds it has had an edit.
    for fixed_speeds in [false, true] {
        let options = Options {
            fixed_speeds,
            ..options(Language::English)
        };
        let mut window = window_of(options, LARGE, 1.0, Theme::Dark);
        press(&mut window, Modifiers::NONE, Key::F2);
        choose(&mut window, 5);
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("same.vid");
        Document::new().save(&file).unwrap();
        window.state_mut().load_path(&file).unwrap();
        window.run();
        assert!(window.query_by_label(texts.curve.waiting).is_none());
    }
}

#[test]
fn what_is_refused_stays_and_changes_nothing() {
    for language in BOTH {
        let texts = language.texts();
        // The target on the position.
        let mut window = opened(language);
        choose(&mut window, 5);
        for (axis, value) in [("x", "0"), ("y", "0.15"), ("z", "0")] {
            enter(
                &mut window,
                &format!("{} {axis}", texts.curve.position),
                value,
            );
        }
        click(&mut window, texts.curve.ok);
        assert_eq!(said(&window).as_deref(), Some(texts.position.on_target));
        assert!(!window.state().document.is_modified());
        assert!(window.query_by_label(texts.curve.waiting).is_some());
        // With another target it is possible.
        enter(
            &mut window,
            &format!("{} x", texts.curve.orientation),
            "0.72",
        );
        click(&mut window, texts.curve.ok);
        assert!(window.state().document.is_modified());

        // Out of range: the number stays as it was typed.
        let mut window = opened(language);
        enter(&mut window, texts.curve.tension, "1.5");
        click(&mut window, texts.curve.show);
        assert!(said(&window).is_some());
        assert!(!window.state().document.is_modified());
        assert_eq!(value(&window, texts.curve.tension), language.number(1.5, 2));
        // No number at all.
        let mut window = opened(language);
        enter(&mut window, texts.curve.tension, "zwei");
        assert!(said(&window).is_some_and(|said| said.contains("zwei")));
    }
}

#[test]
fn position_and_target_may_change_places() {
    let texts = Language::German.texts();
    let mut window = opened(Language::German);
    let place = [("x", "0", "0.72"), ("y", "0.15", "0.25"), ("z", "0", "0.6")];
    for (axis, position, target) in place {
        enter(
            &mut window,
            &format!("{} {axis}", texts.curve.position),
            position,
        );
        enter(
            &mut window,
            &format!("{} {axis}", texts.curve.orientation),
            target,
        );
    }
    click(&mut window, texts.curve.ok);
    let point = &window.state().document.path().points[2];
    assert_eq!(point.position, DVec3::new(0.0, 0.15, 0.0));
    let target = Target::Absolute(DVec3::new(0.72, 0.25, 0.6));
    assert_eq!(point.orientations[0].target, target);
}

/// What was typed but not entered counts when a button is pressed.
#[test]
fn a_button_takes_what_is_being_typed() {
    let texts = &Language::German.texts().curve;
    let mut window = opened(Language::German);
    type_into(&mut window, texts.tension, "0,7");
    click(&mut window, texts.ok);
    assert_eq!(tcb(&window, 2).tension, 0.7);
    assert!(window.query_by_label(texts.title).is_none());
}

/// What is done elsewhere shows here too, unless it is pending.
#[test]
fn what_is_not_pending_follows_the_document() {
    let texts = &Language::English.texts().curve;
    let mut window = opened(Language::English);
    enter(&mut window, &format!("{} x", texts.position), "0.5");
    let position = DVec3::new(0.1, 0.9, 0.6);
    window
        .state_mut()
        .document
        .apply(Edit::set(At::Point(2), "position", position))
        .unwrap();
    window.run();
    let shown = |axis| value(&window, &format!("{} {axis}", texts.position));
    assert_eq!([shown("x"), shown("y")], ["0.500", "0.900"]);
}

/// Escape while a number is dragged takes the drag back, and nothing else.
#[test]
fn escape_breaks_a_drag_off() {
    let texts = &Language::German.texts().curve;
    let mut window = opened(Language::German);
    enter(&mut window, texts.bias, "0.5");
    let at = number(&window, texts.tension).rect().center();
    window.hover_at(at);
    window.run();
    window.drag_at(at);
    window.run();
    for way in [10.0, 20.0, 30.0] {
        window.hover_at(at + vec2(way, 0.0));
        window.run();
    }
    assert_ne!(value(&window, texts.tension), "0,00");
    press(&mut window, Modifiers::NONE, Key::Escape);
    assert_eq!(value(&window, texts.tension), "0,00");
    assert_eq!(value(&window, texts.bias), "0,50");
}

#[test]
fn pictures() {
    for (language, theme, scale, name) in LOOKS {
        let mut window = window_with_points(language, SMALL, scale, theme);
        press(&mut window, Modifiers::NONE, Key::F2);
        screenshot(&mut window, &format!("curve-{name}.png"));
        let texts = &language.texts().curve;
        click(&mut window, texts.own);
        enter(&mut window, texts.tension, "-0.8");
        enter(&mut window, texts.bias, "0.9");
        enter(&mut window, &format!("{} y", texts.position), "0.5");
        screenshot(&mut window, &format!("curve-{name}-pending.png"));
    }
}

/// Choosing goes from preset to preset under a pointer that stays.
#[test]
fn the_window_keeps_its_size_whatever_is_chosen() {
    for language in BOTH {
        let texts = &language.texts().curve;
        let mut window = opened(language);
        let area = |window: &Window| {
            let area = |memory: &egui::Memory| memory.area_rect(egui::Id::unique("curve"));
            window.ctx.memory(area).expect("an open window")
        };
        let first = area(&window);
        for choice in [preset(&window, language, 6), texts.own.to_owned()] {
            window
                .get_by_role_and_label(Role::RadioButton, &choice)
                .click();
            window.run();
            assert_eq!(area(&window), first, "{choice}");
        }
    }
}

#[test]
fn its_buttons_are_called_as_those_of_other_windows() {
    for language in BOTH {
        let texts = language.texts();
        let window = &texts.space_window;
        assert_eq!([texts.curve.ok, texts.tools.ok], [window.ok, window.apply]);
    }
}
