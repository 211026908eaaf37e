//! What is chosen in the menu of a track.

use super::tracks::tests::{POSITION, click, place_in_row, steps_on, values, window, window_in};
use crate::setup::Theme;
use crate::space::tests::tap;
use crate::tests::{BOTH, LARGE, functions_change, functions_stay};
use crate::texts::Language;
use egui::{Key, Modifiers, PointerButton};
use egui_kittest::kittest::Queryable;
use vides_engine::scene::{Channel, Extrapolation, Interpolation};

/// Interpolation, before and after; frames and values stay, and it is one step.
#[test]
fn a_track_has_a_menu() {
    let _stay = functions_stay();
    for language in BOTH {
        let mut harness = window_in(language, LARGE, Theme::Light);
        harness.state_mut().select_nodes(vec![1]);
        steps_on(&mut harness);
        let texts = &language.texts().timeline;
        let before = values(&harness);
        let at = place_in_row(&harness, POSITION, 30.0);
        for (words, expected) in [
            (texts.hermite, Interpolation::Hermite),
            (texts.tcb, Interpolation::Tcb),
            (texts.cubic, Interpolation::Cubic),
        ] {
            click(&mut harness, at, PointerButton::Secondary);
            harness.get_by_label(words).click();
            steps_on(&mut harness);
            let edited = harness.state().document.edited_scene().unwrap();
            let keys = edited.scene().nodes()[1].keys();
            let track = keys.track(&Channel::Position).unwrap();
            assert_eq!(*track.interpolation(), expected);
            assert_eq!(track.frames(), [5.0, 20.0, 40.0, 60.0]);
            assert_eq!(track.values(), before);
            tap(&mut harness, Key::Z, Modifiers::CTRL);
            assert!(!harness.state().document.can_undo());
        }
    }
}

/// A choice in a menu within the menu closes both.
#[test]
fn before_and_after_are_chosen() {
    let _stay = functions_stay();
    let mut harness = window();
    let texts = &Language::English.texts().timeline;
    let at = place_in_row(&harness, POSITION, 30.0);
    click(&mut harness, at, PointerButton::Secondary);
    let entry = harness.get_by_label(texts.after).rect().center();
    click(&mut harness, entry, PointerButton::Primary);
    harness.get_by_label(texts.repeats).click();
    steps_on(&mut harness);
    let edited = harness.state().document.edited_scene().unwrap();
    let track = edited.scene().nodes()[1].keys().track(&Channel::Position);
    let ends = (Extrapolation::Hold, Extrapolation::Repeat);
    assert_eq!(track.unwrap().extrapolation(), ends);
    assert!(harness.query_by_label(texts.after).is_none());
}

/// What the program around has registered is in the menu, by its name.
#[test]
fn functions_of_the_host_are_in_the_menu() {
    use vides_engine::scene::host;
    let _change = functions_change();
    let first = |question: host::Question<'_>, out: &mut [f64]| {
        out.copy_from_slice(&question.values[..question.width]);
        true
    };
    host::register("bounce", Some(std::sync::Arc::new(first))).unwrap();
    let mut harness = window();
    let at = place_in_row(&harness, POSITION, 30.0);
    click(&mut harness, at, PointerButton::Secondary);
    harness.get_by_label("host:bounce").click();
    steps_on(&mut harness);
    let edited = harness.state().document.edited_scene().unwrap();
    let track = edited.scene().nodes()[1].keys().track(&Channel::Position);
    let by = track.unwrap().interpolation();
    assert_eq!(*by, Interpolation::Host("bounce".to_owned()));
    // Not where it does not fit, and gone with its function.
    host::register("bounce", None).unwrap();
    tap(&mut harness, Key::Z, Modifiers::CTRL);
    click(&mut harness, at, PointerButton::Primary);
    click(&mut harness, at, PointerButton::Secondary);
    assert!(harness.query_by_label("host:bounce").is_none());
}
