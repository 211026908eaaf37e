//! Tests of [`super`], by mouse and keys as in the window.

use egui::{Event, PointerButton};
use egui_kittest::kittest::Queryable;

use super::*;
use crate::playing::tracks::tests::*;
use crate::screenshots::screenshot;
use crate::setup::Theme;
use crate::space::tests::{motion, press, release, tap};
use crate::tests::{BOTH, LARGE};
use crate::texts::Language;

fn markers(harness: &Window) -> Vec<(String, f64)> {
    let edited = harness.state().document.edited_scene().unwrap();
    let markers = edited.scene().markers().iter();
    markers
        .map(|marker| (marker.name.clone(), marker.frame))
        .collect()
}

/// Made, moved, renamed, removed: each one step.
#[test]
fn a_marker_is_made_moved_renamed_and_removed() {
    for language in BOTH {
        let texts = &language.texts().timeline;
        let mut harness = window_in(language, LARGE, Theme::Light);
        let ruler = harness.get_by_label(language.texts().space.timeline).rect();
        let at = pos2(x_of(&harness, 40.0), ruler.center().y);
        // The passes of a test are far apart.
        let options = |options: &mut egui::Options| {
            options.input_options.max_double_click_delay = 5.0;
        };
        harness.ctx.options_mut(options);
        for _ in 0..2 {
            press(&mut harness, at, PointerButton::Primary);
            release(&mut harness, at, PointerButton::Primary);
        }
        steps_on(&mut harness);
        let name = fill(texts.new_marker, &[&1]);
        assert_eq!(markers(&harness), [(name.clone(), 40.0)]);
        let label = fill(texts.marker, &[&name]);
        let sign = harness.get_by_label(&label).rect();
        assert!((sign.left() + 4.0 - at.x).abs() <= 0.5);
        let from = sign.left_center() + vec2(4.0, 0.0);
        let by = vec2(x_of(&harness, 60.0) - at.x, 0.0);
        drag(&mut harness, from, from + by);
        assert_eq!(markers(&harness), [(name.clone(), 60.0)]);
        click(&mut harness, from + by, PointerButton::Primary);
        tap(&mut harness, Key::F2, Modifiers::NONE);
        steps_on(&mut harness);
        screenshot(&mut harness, &format!("marker-{language:?}.png"));
        harness.event(Event::Text("meeting".to_owned()));
        steps_on(&mut harness);
        tap(&mut harness, Key::Enter, Modifiers::NONE);
        steps_on(&mut harness);
        assert_eq!(markers(&harness), [("meeting".to_owned(), 60.0)]);
        click(&mut harness, from + by, PointerButton::Primary);
        tap(&mut harness, Key::Delete, Modifiers::NONE);
        steps_on(&mut harness);
        assert_eq!(markers(&harness), []);
        let steps = [Some(60.0), Some(60.0), Some(40.0), None];
        for frame in steps {
            tap(&mut harness, Key::Z, Modifiers::CTRL);
            let there = markers(&harness).first().map(|marker| marker.1);
            assert_eq!(there, frame);
        }
        assert!(!harness.state().document.can_undo());
    }
}

/// Where a drag cannot be met the last place that could be stays, and why is told.
#[test]
fn a_marker_stops_where_its_pins_cannot_follow() {
    let mut harness = window_in(Language::English, LARGE, Theme::Light);
    for (name, point, frame) in [("a", 0, 1.0), ("b", 1, 121.0)] {
        let editor = harness.state_mut();
        editor.document.apply(set(name, Some(frame))).unwrap();
        let (node, marker) = (0, Some(name.to_owned()));
        let pin = Part::Pin {
            node,
            point,
            marker,
        };
        editor.document.apply(Edit::Part(Box::new(pin))).unwrap();
    }
    steps_on(&mut harness);
    let label = fill(harness.state().texts().timeline.marker, &[&"a"]);
    let sign = harness.get_by_label(&label).rect();
    let from = sign.left_center() + vec2(4.0, 0.0);
    let before = markers(&harness);
    let to = pos2(x_of(&harness, 121.0), from.y);
    press(&mut harness, from, PointerButton::Primary);
    for step in 1..=40_u8 {
        motion(&mut harness, from + (to - from) * (f32::from(step) / 40.0));
    }
    steps_on(&mut harness);
    let there = markers(&harness)[0].1;
    assert!(there > 100.0 && there < 121.0, "{there}");
    assert!(
        harness
            .state()
            .message
            .as_ref()
            .is_some_and(|message| message.error)
    );
    release(&mut harness, to, PointerButton::Primary);
    steps_on(&mut harness);
    assert_eq!(markers(&harness)[0].1, there);
    tap(&mut harness, Key::Z, Modifiers::CTRL);
    assert_eq!(markers(&harness), before);
}
