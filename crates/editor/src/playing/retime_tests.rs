//! Tests of [`super`], by mouse and keys as in the window.

use egui::{Key, Modifiers, PointerButton, Pos2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;
use vides_engine::path::Change;

use super::*;
use crate::playing::tracks::tests as tracks;
use crate::screenshots::screenshot;
use crate::space::tests::{hold, press, pyramid_window, release, tap};

type Window = Harness<'static, Editor>;

/// The frame of each key by the sampler, in the order of the keys.
fn times(harness: &Window) -> Vec<usize> {
    let document = &harness.state().document;
    let sampler = document.sampler().unwrap();
    let frames = document.timeline(|timeline| {
        let mut at = 1;
        let mut all = vec![1];
        for number in 0..timeline.section_count() {
            let section = timeline.section(number);
            let key = &document.path().points[section.point].orientations[section.orientation];
            if section.change != Change::Nothing {
                at += key.hold as usize + section.frames;
            }
            all.push(at);
        }
        all
    });
    let frames = frames.unwrap();
    assert_eq!(*frames.last().unwrap(), sampler.frame_count());
    frames
}

/// The middle of a key's sign, and how many points a frame is wide.
fn key(harness: &Window, name: &str) -> (Pos2, f32) {
    let place = harness.get_by_label(&format!("Time of {name}")).rect();
    let bar = harness.get_by_label("Frame").rect().shrink2(vec2(8.0, 0.0));
    let frame = bar.width() / (harness.state().playing.marks.frames as f32 - 1.0);
    // Between its neighbours it may have more room at one side.
    let number = harness.state().playing.marks.of(selection(name));
    let x = bar.left() + frame * (number.unwrap().first() as f32 - 1.0);
    (egui::pos2(x, place.center().y), frame)
}

fn selection(name: &str) -> Selection {
    let (point, orientation) = name.split_once('.').unwrap_or((name, "1"));
    let number = |text: &str| text.parse::<usize>().unwrap() - 1;
    Selection::at(number(point), number(orientation))
}

/// Takes a key and goes so many frames aside; it is still held.
fn take(harness: &mut Window, name: &str, frames: f32) -> Pos2 {
    let (at, frame) = key(harness, name);
    let to = at + vec2(frames * frame, 0.0);
    tracks::take(harness, at, to);
    to
}

fn drag(harness: &mut Window, name: &str, frames: f32) {
    let to = take(harness, name, frames);
    release(harness, to, PointerButton::Primary);
    harness.run();
}

/// By its sign, or by the border of the graph where it stands.
#[test]
fn a_dragged_key_takes_its_frames_from_its_neighbours() {
    for (name, border) in [("3", None), ("4.2", None), ("5", None), ("3", Some(2))] {
        let mut harness = pyramid_window();
        let before = times(&harness);
        let selected = harness.state().playing.marks.keys.clone();
        let number = selected
            .iter()
            .position(|mark| Selection::at(mark.point, mark.orientation) == selection(name));
        let number = number.unwrap();
        let steps = harness.state().document.state_number();
        match border {
            None => drag(&mut harness, name, 20.0),
            Some(section) => {
                let label = format!("End of section {section}");
                let at = harness.get_by_label(&label).rect().center();
                let by = 20.0 * key(&harness, name).1;
                tracks::drag(&mut harness, at, at + vec2(by, 0.0));
            }
        }
        let after = times(&harness);
        let moved = after[number] - before[number];
        assert!((19..=21).contains(&moved), "{name}: {before:?} {after:?}");
        for other in (0..before.len()).filter(|&other| other != number) {
            assert_eq!(after[other], before[other], "{name}, key {other}");
        }
        // The sections beside it have frames of their own now, and it is one step.
        assert_ne!(harness.state().document.state_number(), steps);
        tap(&mut harness, Key::Z, Modifiers::CTRL);
        assert_eq!(times(&harness), before);
        assert!(!harness.state().document.can_undo());
    }
}

#[test]
fn with_the_switch_what_follows_moves_along() {
    let mut harness = pyramid_window();
    let before = times(&harness);
    harness.get_by_label("What follows moves along").click();
    harness.run();
    drag(&mut harness, "3", 25.0);
    let after = times(&harness);
    let moved = after[2] - before[2];
    assert!((24..=26).contains(&moved), "{moved}");
    for (number, (after, before)) in after.iter().zip(&before).enumerate() {
        let expected = if number < 2 { 0 } else { moved };
        assert_eq!(after - before, expected, "key {number}");
    }
    tap(&mut harness, Key::Z, Modifiers::CTRL);
    assert_eq!(times(&harness), before);
}

/// The last key makes the flight longer, and the first one stays at its beginning.
#[test]
fn ends_stay_where_they_must() {
    let mut harness = pyramid_window();
    let before = times(&harness);
    drag(&mut harness, "6", -50.0);
    let shorter = *times(&harness).last().unwrap();
    let less = before.last().unwrap() - shorter;
    assert!((49..=51).contains(&less), "{less}");
    tap(&mut harness, Key::Z, Modifiers::CTRL);
    drag(&mut harness, "1", 50.0);
    assert_eq!(times(&harness), before);
    assert!(!harness.state().document.can_undo());
}

/// No key passes another, however far the mouse goes.
#[test]
fn a_key_stops_a_frame_before_its_neighbours() {
    let mut harness = pyramid_window();
    let before = times(&harness);
    drag(&mut harness, "2", 5000.0);
    assert_eq!(times(&harness)[1], before[2] - 1);
    drag(&mut harness, "2", -5000.0);
    assert_eq!(times(&harness)[1], 2);
    tap(&mut harness, Key::Z, Modifiers::CTRL);
    tap(&mut harness, Key::Z, Modifiers::CTRL);
    assert_eq!(times(&harness), before);
}

#[test]
fn with_ctrl_a_copy_stands_where_it_is_dropped() {
    let mut harness = pyramid_window();
    let before = times(&harness);
    let text = harness.state().document.to_toml().unwrap();
    let at = |harness: &Window, frame: f64| {
        let pose = harness.state().document.sampler().unwrap().pose(frame);
        pose.unwrap()
    };
    let original = at(&harness, before[1] as f64);
    // The second key, into the section behind the third one.
    let to = take(&mut harness, "2", 150.0);
    hold(&mut harness, Modifiers::CTRL);
    harness.step();
    screenshot(&mut harness, "key-copied.png");
    release(&mut harness, to, PointerButton::Primary);
    hold(&mut harness, Modifiers::NONE);
    harness.run();
    let after = times(&harness);
    assert_eq!(after.len(), before.len() + 1);
    let new = after[3];
    assert!(new.abs_diff(before[1] + 150) <= 1, "{new}");
    let copy = at(&harness, new as f64);
    for (a, b) in [(copy.vrp, original.vrp), (copy.vpn, original.vpn)] {
        let far = (0..3).map(|k| (a[k] - b[k]).abs()).fold(0.0, f64::max);
        assert!(far < 1e-9, "{copy:?} {original:?}");
    }
    // All others are when they were, and the new one is current.
    let mut others = after.clone();
    others.remove(3);
    assert_eq!(others, before);
    assert_eq!(harness.state().document.selection(), Selection::at(3, 0));
    tap(&mut harness, Key::Z, Modifiers::CTRL);
    assert_eq!(harness.state().document.to_toml().unwrap(), text);
    assert!(!harness.state().document.can_undo());
}

/// Between a key and the next one it rests until there, since nothing moves between two equal keys.
#[test]
fn a_copy_beside_its_key_is_a_rest() {
    let mut harness = pyramid_window();
    let before = times(&harness);
    for by in [30.0, -30.0] {
        let to = take(&mut harness, "3", by);
        hold(&mut harness, Modifiers::CTRL);
        release(&mut harness, to, PointerButton::Primary);
        hold(&mut harness, Modifiers::NONE);
        harness.run();
        let point = &harness.state().document.path().points[2];
        let hold = point.orientations[0].hold;
        assert!((29..=31).contains(&hold), "{hold}");
        let after = times(&harness);
        assert_eq!(after.last(), before.last());
        let reached = before[2] as i64 - after[2] as i64;
        let expected = if by < 0.0 { i64::from(hold) } else { 0 };
        assert_eq!(reached, expected);
        tap(&mut harness, Key::Z, Modifiers::CTRL);
        assert_eq!(times(&harness), before);
    }
    // Where the camera cannot rest nothing is changed, and it says so.
    let to = take(&mut harness, "6", -30.0);
    hold(&mut harness, Modifiers::CTRL);
    assert!(harness.state().message.as_ref().unwrap().error);
    release(&mut harness, to, PointerButton::Primary);
    hold(&mut harness, Modifiers::NONE);
    harness.run();
    assert_eq!(times(&harness), before);
    assert!(!harness.state().document.can_undo());
}

#[test]
fn from_the_ruler_the_arrow_keys_move_the_current_key() {
    let mut harness = pyramid_window();
    let before = times(&harness);
    harness.state_mut().document.select(2, 0).unwrap();
    harness.step();
    harness.get_by_label("Frame").focus();
    harness.step();
    tap(&mut harness, Key::ArrowRight, Modifiers::CTRL);
    assert_eq!(times(&harness)[2], before[2] + 1);
    tap(
        &mut harness,
        Key::ArrowLeft,
        Modifiers::CTRL | Modifiers::SHIFT,
    );
    assert_eq!(times(&harness)[2], before[2] - 9);
    tap(&mut harness, Key::Z, Modifiers::CTRL);
    tap(&mut harness, Key::Z, Modifiers::CTRL);
    assert_eq!(times(&harness), before);
    assert!(!harness.state().document.can_undo());
}

#[test]
fn a_click_selects_a_key_and_with_ctrl_one_more() {
    let mut harness = pyramid_window();
    for name in ["4.3", "2"] {
        let (at, _) = key(&harness, name);
        press(&mut harness, at, PointerButton::Primary);
        release(&mut harness, at, PointerButton::Primary);
        harness.run();
        assert_eq!(harness.state().document.selection(), selection(name));
        assert!(!harness.state().document.can_undo());
    }
    hold(&mut harness, Modifiers::CTRL);
    let (at, _) = key(&harness, "5");
    press(&mut harness, at, PointerButton::Primary);
    release(&mut harness, at, PointerButton::Primary);
    harness.run();
    assert_eq!(harness.state().all_selected(), [1, 4]);
}

/// Bad input ends in a refusal, never in another path.
#[test]
fn copies_that_cannot_be_leave_the_path_alone() {
    let mut harness = pyramid_window();
    let text = harness.state().document.to_toml().unwrap();
    let last = harness.state().playing.marks.frames;
    let editor = harness.state_mut();
    for of in [
        Selection::at(0, 0),
        Selection::at(99, 0),
        Selection::at(3, 99),
    ] {
        for to in [0, 1, last, last + 1, usize::MAX, 155, 100] {
            editor.document.begin_step();
            editor.retime(Retiming::Copy { of, to });
            editor.document.cancel_step();
        }
    }
    let far = Selection::at(99, 0);
    for by in [i64::MIN, i64::MAX, -1000, 5] {
        for before in [
            (far, 5),
            (Selection::at(0, 0), 76),
            (Selection::at(0, 0), usize::MAX),
        ] {
            editor.document.begin_step();
            let after = Some((Selection::at(1, 0), 78));
            editor.retime(Retiming::Move { before, after, by });
            editor.document.cancel_step();
        }
    }
    assert_eq!(harness.state().document.to_toml().unwrap(), text);
}
