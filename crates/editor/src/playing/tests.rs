//! Tests of [`super`].

use std::time::Duration;

use egui::{Key, Modifiers, PointerButton, Pos2, pos2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;
use vides_document::At;
use vides_engine::path::Pose;

use super::*;
use crate::playing::axis::as_frame;
use crate::space::tests::{
    editor, image, motion, press, pyramid, pyramid_window, release, tap, window,
};
use crate::state::playing::Marks;
use crate::texts::Language;

/// When the window wants to be shown again.
fn wait(harness: &Harness<'_, Editor>) -> Duration {
    let output = harness.output().viewport_output.values();
    output.map(|output| output.repaint_delay).min().unwrap()
}

#[test]
fn marks_lie_where_the_sampler_puts_the_keys() {
    for closed in [false, true] {
        let mut document = pyramid();
        document
            .apply(vides_document::Edit::set(At::Path, "closed", closed))
            .unwrap();
        let mut marks = Marks::default();
        marks.update(&document).unwrap();
        let sampler = document.sampler().unwrap();
        assert_eq!(marks.frames, sampler.frame_count());
        let keys: usize = document
            .path()
            .points
            .iter()
            .map(|p| p.orientations.len())
            .sum();
        assert_eq!(marks.keys.len(), keys);
        for mark in &marks.keys {
            let pose = sampler.pose(as_frame(mark.frame)).unwrap();
            let key = Camera::at(&document, mark.point, mark.orientation).unwrap();
            let at: Camera = pose.into();
            assert!(at.position.abs_diff_eq(key.position, 1e-12), "{mark:?}");
            assert!(at.view.abs_diff_eq(key.view, 1e-9), "{mark:?}");
            // It is the first frame of its kind: a hold comes after it.
            if mark.frame > 1 {
                let before = sampler.pose(as_frame(mark.frame - 1)).unwrap();
                assert_ne!(before, Pose::default());
                assert_ne!(before, pose, "{mark:?}");
            }
        }
    }
}

#[test]
fn at_rest_it_wakes_nobody_and_playing_it_wakes_for_each_frame() {
    let mut harness = pyramid_window();
    assert_eq!(wait(&harness), Duration::MAX);
    harness.get_by_label("Play").click();
    harness.step();
    harness.step();
    assert!(harness.state().playing.is_playing());
    let wanted = wait(&harness);
    assert!(wanted <= Duration::from_millis(40), "{wanted:?}");
    // 25 frames a second, shown at 60.
    let first = harness.state().playing.frame.unwrap();
    for _ in 0..60 {
        harness.step();
    }
    let gone = harness.state().playing.frame.unwrap() - first;
    assert!((24.0..=26.0).contains(&gone), "{gone}");
    harness.get_by_label("Pause").click();
    harness.run();
    assert!(!harness.state().playing.is_playing());
    assert_eq!(wait(&harness), Duration::MAX);
}

#[test]
fn it_stops_at_the_end_and_begins_anew() {
    let mut harness = pyramid_window();
    let last = harness.state().playing.marks.frames;
    harness.state_mut().scrub(as_frame(last) - 3.0);
    harness.get_by_label("Play").click();
    for _ in 0..30 {
        harness.step();
    }
    assert_eq!(harness.state().position_on_bar(), as_frame(last));
    assert!(!harness.state().playing.is_playing());
    assert_eq!(wait(&harness), Duration::MAX);
    harness.get_by_label("Play").click();
    harness.step();
    harness.step();
    assert!(harness.state().playing.frame.unwrap() < 5.0);
}

#[test]
fn another_current_point_is_shown_instead_of_the_frame() {
    let mut harness = pyramid_window();
    harness.state_mut().scrub(100.0);
    harness.step();
    assert!(harness.state().camera().unwrap().1);
    assert_eq!(harness.state().shown_frame(), Some(100));
    harness.state_mut().document.select(2, 0).unwrap();
    harness.step();
    let (camera, of_frame) = harness.state().camera().unwrap();
    assert!(!of_frame);
    assert_eq!(
        camera.position,
        harness.state().document.path().points[2].position
    );
    let mark = harness.state().playing.marks.keys[2];
    assert_eq!(harness.state().position_on_bar(), as_frame(mark.frame));
}

#[test]
fn the_bar_is_used_by_mouse_and_by_keys() {
    let mut harness = pyramid_window();
    let last = as_frame(harness.state().playing.marks.frames);
    let bar = harness.get_by_label("Frame").rect();
    let place = pos2(
        bar.left() + 8.0 + (bar.width() - 16.0) * 0.5,
        bar.center().y,
    );
    harness.hover_at(place);
    harness.step();
    harness.drag_at(place);
    harness.step();
    let middle = harness.state().playing.frame.unwrap();
    assert!((middle - (1.0 + last) / 2.0).abs() < 1.0, "{middle}");
    harness.drop_at(pos2(bar.right() + 50.0, bar.center().y));
    harness.run();
    tap(&mut harness, Key::Home, Modifiers::NONE);
    assert_eq!(harness.state().position_on_bar(), 1.0);
    tap(&mut harness, Key::ArrowRight, Modifiers::NONE);
    tap(&mut harness, Key::ArrowRight, Modifiers::SHIFT);
    assert_eq!(harness.state().position_on_bar(), 12.0);
    tap(&mut harness, Key::End, Modifiers::NONE);
    assert_eq!(harness.state().position_on_bar(), last);
    tap(&mut harness, Key::ArrowRight, Modifiers::NONE);
    assert_eq!(harness.state().position_on_bar(), last);
    tap(&mut harness, Key::Space, Modifiers::NONE);
    assert!(harness.state().playing.is_playing());
}

/// A click on the bar, press and release in one pass.
fn click_at_once(harness: &mut Harness<'_, Editor>, pos: Pos2) {
    let button = |pressed| egui::Event::PointerButton {
        pos,
        button: PointerButton::Primary,
        pressed,
        modifiers: Modifiers::NONE,
    };
    let events = [egui::Event::PointerMoved(pos), button(true), button(false)];
    harness.input_mut().events.extend(events);
    harness.step();
}

#[test]
fn a_press_and_release_that_come_together_meet_the_bar() {
    let mut harness = pyramid_window();
    let last = as_frame(harness.state().playing.marks.frames);
    let bar = harness.get_by_label("Frame").rect().shrink2(vec2(8.0, 0.0));
    for step in 0..20_u8 {
        let share = (f32::from(step) * 7.0 % 20.0 + 0.5) / 20.0;
        let pos = pos2(bar.left() + bar.width() * share, bar.center().y);
        click_at_once(&mut harness, pos);
        let expected = 1.0 + f64::from(share) * (last - 1.0);
        let at = harness.state().position_on_bar();
        assert!((at - expected).abs() < 8.0, "{step}: {at}, {expected}");
    }
}

#[test]
fn a_shorter_path_keeps_the_frame_in_range() {
    let mut harness = window(editor(pyramid(), Language::German), vec2(900.0, 600.0), 1.0);
    harness.state_mut().scrub(700.0);
    harness.step();
    while harness.state().document.path().points.len() > 2 {
        let edit = vides_document::Edit::RemovePoint { at: 2 };
        harness.state_mut().document.apply(edit).unwrap();
    }
    harness.step();
    let frames = harness.state().playing.marks.frames;
    assert!(frames < 700);
    assert!(
        harness
            .state()
            .playing
            .frame
            .is_none_or(|frame| frame <= as_frame(frames))
    );
}

/// While a point is dragged they follow now and then, and at its end.
#[test]
fn the_marks_follow_what_is_dragged() {
    let mut harness = pyramid_window();
    // The times change with the place.
    harness.state_mut().setup.fixed_times = Some(false);
    let from = image(&harness, harness.state().document.path().points[0].position);
    let marks = |harness: &Harness<'_, Editor>| harness.state().playing.marks.keys.clone();
    let right = |harness: &Harness<'_, Editor>| {
        let mut right = Marks::default();
        right.update(&harness.state().document).unwrap();
        right.keys
    };
    press(&mut harness, from, PointerButton::Middle);
    motion(&mut harness, from + vec2(10.0, 0.0));
    let mut changes = 0;
    for step in 0..60_u8 {
        let before = marks(&harness);
        motion(&mut harness, from + vec2(10.0, f32::from(step)));
        changes += usize::from(marks(&harness) != before);
    }
    assert!((3..=5).contains(&changes), "{changes} in a second");
    for step in 0..6_u8 {
        motion(&mut harness, from + vec2(10.0, f32::from(step)));
    }
    // The pointer rests.
    assert_ne!(marks(&harness), right(&harness));
    assert!(wait(&harness) <= Duration::from_millis(250));
    harness.run_steps(16);
    assert_eq!(marks(&harness), right(&harness));
    // It lets go.
    motion(&mut harness, from + vec2(40.0, 10.0));
    release(&mut harness, from + vec2(40.0, 10.0), PointerButton::Middle);
    harness.run();
    assert_eq!(marks(&harness), right(&harness));
    assert_eq!(wait(&harness), Duration::MAX);
}

/// Types into a number of the bar.
fn type_into(harness: &mut Harness<'_, Editor>, name: &str, text: &str) {
    harness.get_by_label(name).click();
    harness.run();
    harness.event(egui::Event::Text(text.to_owned()));
    harness.run();
    tap(harness, Key::Enter, Modifiers::NONE);
    harness.run();
}

#[test]
fn frame_and_second_are_typed_and_move_the_playhead() {
    for language in [Language::English, Language::German] {
        let mut document = pyramid();
        let info = vides_document::Info {
            first_frame: 1001,
            fps: 24.0,
            ..document.info().clone()
        };
        let edit = vides_document::Edit::SetInfo(Box::new(info));
        document.apply(edit).unwrap();
        let before = document.to_toml().unwrap();
        let mut harness = window(editor(document, language), vec2(1200.0, 800.0), 1.0);
        let texts = &language.texts().space;
        let shown =
            |harness: &Harness<'_, Editor>, name: &str| harness.get_by_label(name).value().unwrap();
        type_into(&mut harness, texts.frame_number, "1121");
        assert_eq!(harness.state().position_on_bar(), 121.0);
        assert_eq!(harness.state().shown_frame(), Some(1121));
        assert_eq!(
            shown(&harness, texts.second),
            format!("{} s", language.number(5.0, 2))
        );
        type_into(&mut harness, texts.second, "7,5");
        assert_eq!(harness.state().position_on_bar(), 181.0);
        assert_eq!(shown(&harness, texts.frame_number), "1181");
        // Out of range it stays, and is told.
        type_into(&mut harness, texts.frame_number, "1000");
        assert_eq!(harness.state().position_on_bar(), 181.0);
        assert!(harness.state().message.as_ref().unwrap().error);
        // Looking changes nothing.
        assert_eq!(harness.state().document.to_toml().unwrap(), before);
        // The rate does: everything keeps its second, the playhead too.
        let keys = |harness: &Harness<'_, Editor>| {
            let document = &harness.state().document;
            let sampler = document.sampler().unwrap();
            (0..5)
                .map(|k| (sampler.first_frame(k) - 1) as f64 / document.info().fps)
                .collect::<Vec<_>>()
        };
        let seconds = keys(&harness);
        type_into(&mut harness, texts.rate, "30");
        assert_eq!(harness.state().document.info().fps, 30.0);
        assert_eq!(harness.state().position_on_bar(), 226.0);
        assert_eq!(
            shown(&harness, texts.second),
            format!("{} s", language.number(7.5, 2))
        );
        for (before, after) in seconds.iter().zip(keys(&harness)) {
            assert!((before - after).abs() < 0.05, "{before} {after}");
        }
        assert!(harness.state_mut().document.undo());
        assert_eq!(harness.state().document.to_toml().unwrap(), before);
    }
}

/// Its second at another rate may lie between frames, and then its key beside it.
#[test]
fn the_playhead_stays_at_its_key_when_rate_and_duration_change() {
    for key in 0..5 {
        let mut harness = pyramid_window();
        let there = |harness: &Harness<'_, Editor>| harness.state().playing.marks.keys[key].first();
        let at = there(&harness);
        harness.state_mut().scrub(at);
        for (name, text) in [
            ("Frames per second", "30"),
            ("Duration", "12"),
            ("Frames per second", "7"),
        ] {
            harness.run();
            type_into(&mut harness, name, text);
            let editor = harness.state();
            assert_eq!(editor.position_on_bar(), there(&harness), "{name} {text}");
            assert!(!editor.shown().unwrap().has_no_orientation());
        }
    }
}

#[test]
fn a_number_of_the_bar_is_dragged_and_escape_takes_it_back() {
    let mut harness = pyramid_window();
    harness.state_mut().scrub(100.0);
    harness.run();
    let at = harness.get_by_label("Number of the frame").rect().center();
    press(&mut harness, at, PointerButton::Primary);
    for step in 1..=20_u8 {
        motion(&mut harness, at + vec2(f32::from(step) * 2.0, 0.0));
    }
    let dragged = harness.state().position_on_bar();
    assert!((120.0..=140.0).contains(&dragged), "{dragged}");
    tap(&mut harness, Key::Escape, Modifiers::NONE);
    assert_eq!(harness.state().position_on_bar(), 100.0);
    release(&mut harness, at, PointerButton::Primary);
    assert_eq!(harness.state().position_on_bar(), 100.0);
}

#[test]
fn what_is_typed_as_the_whole_is_the_whole_exactly() {
    for (name, text, frames) in [
        ("Last frame", "360", 360),
        ("Duration", "12", 300),
        ("Duration", "12.04 s", 301),
    ] {
        let mut harness = pyramid_window();
        let before = harness.state().document.path().clone();
        type_into(&mut harness, name, text);
        let editor = harness.state();
        assert_eq!(editor.document.sampler().unwrap().frame_count(), frames);
        let [new, old] = [editor.document.path(), &before].map(|path| {
            let positions = path.points.iter().map(|point| point.position);
            positions.collect::<Vec<_>>()
        });
        assert_eq!(new, old);
        assert!(harness.state_mut().document.undo());
        assert_eq!(*harness.state().document.path(), before);
    }
    // Fewer than there are sections and holds: a sentence, and nothing else.
    let mut harness = pyramid_window();
    let before = harness.state().document.path().clone();
    type_into(&mut harness, "Last frame", "20");
    assert_eq!(*harness.state().document.path(), before);
    assert!(harness.state().message.is_some());
}

#[test]
fn it_plays_in_a_loop_at_half_and_double_speed() {
    let mut harness = pyramid_window();
    let last = as_frame(harness.state().playing.marks.frames);
    let gone = |harness: &mut Harness<'_, Editor>, from: f64| {
        harness.state_mut().scrub(from);
        harness.get_by_label("Play").click();
        harness.step();
        harness.step();
        let first = harness.state().position_on_bar();
        for _ in 0..60 {
            harness.step();
        }
        harness.state().position_on_bar() - first
    };
    for (click, expected) in [(0, 25.0), (1, 50.0), (1, 12.5)] {
        for _ in 0..click {
            harness.get_by_label("Playing speed").click();
            harness.run();
        }
        let seen = gone(&mut harness, 50.0);
        assert!((seen - expected).abs() <= 1.5, "{seen}, {expected}");
        // Another speed while it plays goes on from here.
        let at = harness.state().position_on_bar();
        let (pace, context) = (harness.state().playing.pace, harness.ctx.clone());
        harness.state_mut().set_pace(pace, &context);
        harness.step();
        assert!((harness.state().position_on_bar() - at).abs() <= 1.0);
        harness.get_by_label("Pause").click();
        harness.run();
    }
    harness.get_by_label("Playing speed").click();
    harness.get_by_label("Loop").click();
    harness.run();
    let seen = gone(&mut harness, last - 10.0);
    assert!((seen - 25.0 + last).abs() <= 1.5, "{seen}");
    assert!(harness.state().playing.is_playing());
    // In the second round it goes on to the end then.
    harness.get_by_label("Loop").click();
    harness.step();
    harness.step();
    assert!(harness.state().playing.is_playing());
    harness.get_by_label("Pause").click();
    harness.run();
    assert_eq!(wait(&harness), Duration::MAX);
    // By the keyboard, too.
    tap(&mut harness, Key::L, Modifiers::NONE);
    assert!(harness.state().playing.loops);
}
