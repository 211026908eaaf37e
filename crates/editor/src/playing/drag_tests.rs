//! The same drag, whatever stands on the timeline.

use egui::{Event, Key, Modifiers, PointerButton, Pos2, vec2};
use egui_kittest::kittest::Queryable;
use vides_engine::scene::{Channel, Part};

use super::*;
use crate::playing::tracks::tests::*;
use crate::screenshots::screenshot;
use crate::space::tests::{motion, release, tap};
use crate::texts::fill;

/// Where something is taken, and at which frame it is.
type Thing = (fn(&Window) -> Pos2, fn(&Window) -> f64);

fn key_of_path(harness: &Window) -> Pos2 {
    let label = fill(harness.state().texts().timeline.key, &[&"2"]);
    harness.get_by_label(&label).rect().center()
}

fn marker(harness: &Window) -> Pos2 {
    let label = fill(harness.state().texts().timeline.marker, &[&"m"]);
    harness.get_by_label(&label).rect().left_center() + vec2(4.0, 0.0)
}

/// The last key of the path, a marker, a key of a track, the bar of a path.
const THINGS: [Thing; 4] = [
    (key_of_path, |harness| {
        harness.state().playing.marks.keys[1].first()
    }),
    (marker, |harness| {
        let edited = harness.state().document.edited_scene().unwrap();
        edited.scene().marker("m").unwrap()
    }),
    (
        |harness| place_in_row(harness, POSITION, 20.0),
        |harness| {
            let all = frames(harness, &Channel::Position);
            let others = [5.0, 40.0, 60.0];
            *all.iter().find(|frame| !others.contains(frame)).unwrap()
        },
    ),
    (
        |harness| place_in_row(harness, DRONE, 30.0),
        |harness| {
            let edited = harness.state().document.edited_scene().unwrap();
            edited.scene().nodes()[2].path().unwrap().start_frame()
        },
    ),
];

fn window_with_marker() -> Window {
    let mut harness = window();
    let (name, frame) = ("m".to_owned(), Some(30.0));
    let edit = Edit::Part(Box::new(Part::Marker { name, frame }));
    let editor = harness.state_mut();
    editor.document.apply(edit).unwrap();
    editor.document = editor.document.try_clone().unwrap().as_opened();
    steps_on(&mut harness);
    harness
}

/// A time that is typed, from where it stood or from the beginning, in seconds or frames; with Enter
/// it is let go, and it is one step.
#[test]
fn times_are_typed_while_something_is_held() {
    for (at, of) in THINGS {
        for (typed, in_frames, expected) in [
            ("+3", true, None),
            ("-0,4", false, None),
            ("47", true, Some(47.0)),
            ("3", false, Some(76.0)),
        ] {
            let mut harness = window_with_marker();
            harness.state_mut().setup.ruler_frames = in_frames;
            harness.step();
            let (from, before) = (at(&harness), of(&harness));
            let by = if in_frames { 3.0 } else { -10.0 };
            let expected = expected.unwrap_or(before + by);
            take(&mut harness, from, from + vec2(9.0, 0.0));
            for sign in typed.chars() {
                harness.event(Event::Text(sign.to_string()));
                harness.step();
            }
            harness.step();
            screenshot(&mut harness, &format!("typed-{typed}-{before}.png"));
            assert_eq!(of(&harness), expected, "{typed} from {before}");
            tap(&mut harness, Key::Enter, Modifiers::NONE);
            // The mouse moves nothing any more.
            motion(&mut harness, from + vec2(60.0, 0.0));
            release(&mut harness, from + vec2(60.0, 0.0), PointerButton::Primary);
            steps_on(&mut harness);
            assert_eq!(of(&harness), expected, "{typed} from {before}");
            tap(&mut harness, Key::Z, Modifiers::CTRL);
            assert_eq!(of(&harness), before);
            assert!(!harness.state().document.can_undo());
        }
    }
}

/// With Shift it goes ten times finer; Escape gives it back.
#[test]
fn it_goes_finer_and_is_given_back() {
    for (at, of) in THINGS {
        let mut harness = window_with_marker();
        let (from, before) = (at(&harness), of(&harness));
        let by = x_of(&harness, 1.0) - x_of(&harness, 31.0);
        let to = from + vec2(by, 0.0);
        take(&mut harness, from, to);
        let coarse = of(&harness);
        assert!((coarse - before + 30.0).abs() <= 1.0, "{before} {coarse}");
        hold(&mut harness, Modifiers::SHIFT);
        motion(&mut harness, from);
        harness.step();
        let fine = of(&harness) - coarse;
        assert!((fine - 3.0).abs() <= 1.0, "{coarse} {fine}");
        hold(&mut harness, Modifiers::NONE);
        tap(&mut harness, Key::Escape, Modifiers::NONE);
        release(&mut harness, from, PointerButton::Primary);
        steps_on(&mut harness);
        assert_eq!(of(&harness), before);
        assert!(!harness.state().document.can_undo());
    }
}
