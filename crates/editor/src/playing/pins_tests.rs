//! Tests of [`super`], by mouse and keys as in the window.

use egui::{Key, Modifiers, PointerButton, Shape};
use egui_kittest::kittest::Queryable;

use super::super::tracks::tests::*;
use super::*;
use crate::screenshots::screenshot;
use crate::setup::Theme;
use crate::space::tests::{motion, tap};
use crate::tests::{BOTH, LARGE};
use crate::texts::{Language, fill};

/// A camera's path of two points over 121 frames, with markers.
fn with_markers(language: Language, markers: &[(&str, f64)]) -> Window {
    let mut harness = window_in(language, LARGE, Theme::Dark);
    let editor = harness.state_mut();
    for (name, frame) in markers {
        let (name, frame) = ((*name).to_owned(), Some(*frame));
        let edit = Edit::Part(Box::new(Part::Marker { name, frame }));
        editor.document.apply(edit).unwrap();
    }
    editor.document = editor.document.try_clone().unwrap().as_opened();
    steps_on(&mut harness);
    harness
}

fn pinned(harness: &Window) -> Vec<(usize, String)> {
    let edited = harness.state().document.edited_scene().unwrap();
    edited.pinned().collect()
}

/// Chooses a marker in the menu of a point's key.
fn pin(harness: &mut Window, point: usize, words: &str) {
    let texts = &harness.state().language().texts().timeline;
    let name = harness.state().name_of(point, 0);
    let key = harness.get_by_label(&fill(texts.key, &[&name])).rect();
    click(harness, key.center(), PointerButton::Secondary);
    let entry = harness.get_by_label(texts.pin_to).rect();
    click(harness, entry.center(), PointerButton::Primary);
    let all = harness.get_all_by_label(words);
    let place = all.last().unwrap().rect();
    click(harness, place.center(), PointerButton::Primary);
}

/// A point is pinned in its menu, which is one step; a line joins both; it can be free again.
#[test]
fn a_point_is_pinned_in_its_menu() {
    for language in BOTH {
        let texts = &language.texts().timeline;
        let mut harness = with_markers(language, &[("start", 11.0), ("end", 91.0)]);
        let before = harness.state().document.scene().unwrap();
        pin(&mut harness, 0, "start");
        pin(&mut harness, 1, "end");
        assert_eq!(
            pinned(&harness),
            [(0, "start".to_owned()), (1, "end".to_owned())]
        );
        // The camera is there then.
        let scene = harness.state().document.scene().unwrap();
        let path = scene.nodes()[0].path().unwrap();
        assert_eq!(path.first_and_last(), (11.0, 91.0));
        screenshot(&mut harness, &format!("pins-{language:?}.png"));
        // From each marker to its point.
        let dots =
            harness.output().shapes.iter().filter(
                |shape| matches!(&shape.shape, Shape::Circle(circle) if circle.radius == 2.5),
            );
        assert_eq!(dots.count(), 2);
        pin(&mut harness, 1, texts.no_marker);
        assert_eq!(pinned(&harness), [(0, "start".to_owned())]);
        for _ in 0..3 {
            tap(&mut harness, Key::Z, Modifiers::CTRL);
        }
        assert_eq!(harness.state().document.scene().unwrap(), before);
        assert!(!harness.state().document.can_undo());
    }
}

/// A pin that cannot be met is refused with a sentence, and nothing changes.
#[test]
fn a_pin_that_cannot_be_met_changes_nothing() {
    let markers = [("late", 60.0), ("early", 20.0), ("soon", 60.2)];
    let mut harness = with_markers(Language::English, &markers);
    pin(&mut harness, 0, "late");
    let before = harness.state().document.scene().unwrap();
    // Before that of the first point; and no frame left between.
    for marker in ["early", "soon"] {
        pin(&mut harness, 1, marker);
        let message = harness.state().message.clone().expect("a sentence");
        assert!(
            message.error && message.text.contains("point 2"),
            "{}",
            message.text
        );
        assert_eq!(harness.state().document.scene().unwrap(), before);
    }
    tap(&mut harness, Key::Z, Modifiers::CTRL);
    assert!(!harness.state().document.can_undo());
}

/// Without a marker the entry says how one is made.
#[test]
fn without_markers_it_says_how_to_make_one() {
    let mut harness = with_markers(Language::English, &[]);
    let texts = &Language::English.texts().timeline;
    let name = harness.state().name_of(0, 0);
    let key = harness.get_by_label(&fill(texts.key, &[&name])).rect();
    click(&mut harness, key.center(), PointerButton::Secondary);
    let entry = harness.get_by_label(texts.pin_to).rect();
    motion(&mut harness, entry.center());
    for _ in 0..60 {
        harness.step();
    }
    assert!(harness.query_by_label(texts.no_markers).is_some());
}
