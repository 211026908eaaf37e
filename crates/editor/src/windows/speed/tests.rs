//! The speed-curve window (thesis A.4.3).

use egui::{Pos2, vec2};
use egui_kittest::kittest::NodeT;
use vides_document::At;

use super::pace_tests::{choose, drag_handle, frames, handle};
use crate::screenshots::screenshot;
use crate::tests::*;

pub(super) fn opened(language: Language) -> Window {
    let mut window = window_with_points(language, LARGE, 1.0, Theme::Dark);
    press(&mut window, Modifiers::NONE, Key::F3);
    window
}

fn speeds(window: &Window) -> [f64; 10] {
    window.state().orientation().unwrap().speeds
}

fn square(window: &Window, at: usize) -> Pos2 {
    let language = window.state().language();
    let name = fill(language.texts().speed_window.speed, &[&at]);
    let square = window.get_by_role_and_label(Role::Slider, &name);
    square.rect().center()
}

pub(super) fn drag(window: &mut Window, from: Pos2, way: egui::Vec2) {
    window.hover_at(from);
    window.run();
    window.drag_at(from);
    window.run();
    for part in 1..=4 {
        window.hover_at(from + way * part as f32 / 4.0);
        window.run();
    }
}

#[test]
fn squares_are_dragged_up_and_down_in_one_step() {
    for language in BOTH {
        let mut window = opened(language);
        let before = speeds(&window);
        let from = square(&window, 4);
        drag(&mut window, from, vec2(30.0, -40.0));
        window.drop_at(from + vec2(30.0, -40.0));
        window.run();
        let after = speeds(&window);
        assert!(after[3] > before[3] + 10.0, "{after:?}");
        assert_eq!(after[..3], before[..3]);
        assert_eq!(after[4..], before[4..]);
        // The square went along, upwards only.
        let to = square(&window, 4);
        assert!((to.y - (from.y - 40.0)).abs() < 2.0 && (to.x - from.x).abs() < 0.1);
        press(&mut window, Modifiers::CTRL, Key::Z);
        assert_eq!(speeds(&window), before);
        assert!(!window.state().document.is_modified());
    }
}

/// In the graphs of way and acceleration: the square goes where the hand is, what one speed
/// gains the other loses, and the section takes as long.
#[test]
fn the_way_and_the_acceleration_are_dragged_by_squares_too() {
    for language in BOTH {
        let texts = &language.texts().speed_window;
        for (graph, at, way, [rises, falls]) in [
            (texts.graph_distance, 5, vec2(30.0, -8.0), [3, 5]),
            (texts.graph_acceleration, 5, vec2(30.0, -24.0), [5, 4]),
        ] {
            let mut window = opened(language);
            choose(&mut window, texts.graph, graph);
            let name = format!("{graph} {at}");
            let (before, lasts) = (speeds(&window), frames(&window));
            let from = handle(&window, &name);
            drag(&mut window, from, way);
            let to = handle(&window, &name);
            assert!((to.y - (from + way).y).abs() < 2.0 && (to.x - from.x).abs() < 0.1);
            window.drop_at(from + way);
            window.run();
            let after = speeds(&window);
            let gained = after[rises] - before[rises];
            assert!(gained > 1.0, "{graph}: {after:?}");
            assert!((gained + after[falls] - before[falls]).abs() < 1e-9);
            let others = (0..10).filter(|other| *other != rises && *other != falls);
            assert!(
                others
                    .into_iter()
                    .all(|other| after[other] == before[other])
            );
            assert_eq!(frames(&window), lasts);
            // As far as picture and speeds go, and no farther.
            drag_handle(&mut window, &name, vec2(0.0, -500.0));
            let most = speeds(&window);
            let at_the_end = most[rises] == 100.0 || most[falls] == 1.0;
            assert!(at_the_end || graph == texts.graph_acceleration, "{most:?}");
            assert!(most != after, "{graph}: {after:?}");
            press(&mut window, Modifiers::CTRL, Key::Z);
            press(&mut window, Modifiers::CTRL, Key::Z);
            assert_eq!(speeds(&window), before);
            // By the keyboard, and on to the next square.
            window.get_by_role_and_label(Role::Slider, &name).focus();
            window.run();
            press(&mut window, Modifiers::NONE, Key::ArrowUp);
            assert!(speeds(&window)[rises] > before[rises]);
            press(&mut window, Modifiers::NONE, Key::ArrowRight);
            press(&mut window, Modifiers::NONE, Key::ArrowDown);
            assert!(speeds(&window)[rises + 1] < before[rises + 1]);
            screenshot(&mut window, &format!("speed-squares-{graph}.png"));
        }
    }
}

#[test]
fn speeds_stay_between_1_and_100() {
    let mut window = opened(Language::German);
    for (way, bound) in [(-500.0, 100.0), (700.0, 1.0)] {
        let from = square(&window, 4);
        drag(&mut window, from, vec2(0.0, way));
        window.drop_at(from + vec2(0.0, way));
        window.run();
        assert_eq!(speeds(&window)[3], bound);
    }
}

#[test]
fn escape_breaks_a_drag_off() {
    let mut window = opened(Language::English);
    let before = speeds(&window);
    let from = square(&window, 2);
    drag(&mut window, from, vec2(0.0, -60.0));
    assert_ne!(speeds(&window), before);
    press(&mut window, Modifiers::NONE, Key::Escape);
    assert_eq!(speeds(&window), before);
    window.drop_at(from);
    window.run();
    assert!(!window.state().document.is_modified());
    let title = Language::English.texts().speed_window.title;
    assert!(window.query_by_label(title).is_some(), "the window stays");
}

#[test]
fn the_keyboard_moves_and_chooses() {
    for language in BOTH {
        let mut window = opened(language);
        let before = speeds(&window);
        let name = fill(language.texts().speed_window.speed, &[&3]);
        window.get_by_role_and_label(Role::Slider, &name).focus();
        window.run();
        press(&mut window, Modifiers::NONE, Key::ArrowUp);
        press(&mut window, Modifiers::SHIFT, Key::ArrowUp);
        assert_eq!(speeds(&window)[2], before[2] + 11.0);
        press(&mut window, Modifiers::NONE, Key::ArrowRight);
        press(&mut window, Modifiers::NONE, Key::ArrowDown);
        assert_eq!(speeds(&window)[3], before[3] - 1.0);
        press(&mut window, Modifiers::NONE, Key::Tab);
        press(&mut window, Modifiers::NONE, Key::ArrowDown);
        assert_eq!(speeds(&window)[4], before[4] - 1.0);
    }
}

#[test]
fn values_are_typed() {
    for language in BOTH {
        let texts = language.texts();
        let mut window = opened(language);
        for (text, value) in [("77,5", 77.5), ("101", 77.5), ("0", 77.5), ("1", 1.0)] {
            let name = fill(texts.speed_window.speed, &[&10]);
            enter(&mut window, &name, text);
            assert_eq!(speeds(&window)[9], value, "{text}");
            assert_eq!(
                said_besides_length(&window).is_some(),
                matches!(text, "101" | "0")
            );
            window.state_mut().message = None;
        }
    }
}

#[test]
fn it_follows_the_current_point_and_orientation() {
    for language in BOTH {
        let texts = language.texts();
        let mut window = opened(language);
        let shown = |window: &Window, from: &str, to: &str| {
            let text = fill(texts.speed_window.section, &[&from, &to]);
            window.query_by_label(&text).is_some()
        };
        assert!(shown(&window, "3.1", "3.2"));
        press(
            &mut window,
            Modifiers::CTRL | Modifiers::SHIFT,
            Key::PageDown,
        );
        assert!(shown(&window, "3.2", "3.3"));
        press(&mut window, Modifiers::CTRL, Key::PageDown);
        assert!(shown(&window, "4", "5"));
        for _ in 0..2 {
            press(&mut window, Modifiers::CTRL, Key::PageDown);
        }
        let end = fill(texts.speed_window.end_of_path, &[&"6"]);
        assert!(window.query_by_label(&end).is_some());
        // Still to be edited there.
        click(&mut window, texts.speed_window.ease_in);
        assert!(speeds(&window)[0] < speeds(&window)[9]);
        press(&mut window, Modifiers::CTRL, Key::Z);
        let edit = Edit::set(At::Path, "closed", true);
        window.state_mut().document.apply(edit).unwrap();
        window.run();
        assert!(shown(&window, "6", "1"));
    }
}

#[test]
fn shapes_keep_the_frames_or_match_the_neighbours_and_are_one_step() {
    let texts = &Language::German.texts().speed_window;
    let frames = |window: &Window| {
        let document = &window.state().document;
        document
            .timeline(|timeline| timeline.section(2).frames)
            .unwrap()
    };
    for name in [texts.constant, texts.ease_in, texts.ease_out, texts.both] {
        let mut window = opened(Language::German);
        let (before, old) = (frames(&window), speeds(&window));
        let document = &window.state().document;
        let facing = document.timeline(|timeline| timeline.facing_speeds(document.path(), 2));
        let facing = facing.unwrap();
        click(&mut window, name);
        let new = speeds(&window);
        assert_ne!(new, old, "{name}");
        if name == texts.ease_in {
            assert_eq!(
                (Some(new[0]), new[2], Some(new[9])),
                (facing.0, 1.0, facing.1)
            );
        } else if name == texts.ease_out {
            assert_eq!(
                (Some(new[0]), new[7], Some(new[9])),
                (facing.0, 1.0, facing.1)
            );
        } else {
            assert!(frames(&window).abs_diff(before) <= 1, "{name}");
        }
        press(&mut window, Modifiers::CTRL, Key::Z);
        assert!(!window.state().document.is_modified());
    }
}

#[test]
fn ten_speeds_are_copied_to_another_section() {
    let texts = Language::English.texts();
    let mut window = opened(Language::English);
    let copied = speeds(&window);
    click(&mut window, texts.speed_window.copy);
    press(&mut window, Modifiers::CTRL, Key::PageDown);
    assert_eq!(speeds(&window), [50.0; 10]);
    click(&mut window, texts.speed_window.paste);
    assert_eq!(speeds(&window), copied);
    click(&mut window, texts.speed_window.reset);
    assert_eq!(speeds(&window), [50.0; 10]);
}

#[test]
fn base_frames_hold_for_the_whole_path() {
    for language in BOTH {
        let texts = &language.texts().speed_window;
        let mut window = opened(language);
        let frames = |window: &Window| {
            let document = &window.state().document;
            document.sampler().unwrap().frame_count()
        };
        let before = frames(&window);
        for name in [
            texts.base_move,
            texts.base_turn,
            texts.base_zoom,
            texts.base_roll,
        ] {
            let name = format!("{}: {name}", texts.base);
            let twice = 2.0 * value(&window, &name).parse::<f64>().unwrap();
            enter(&mut window, &name, &twice.to_string());
        }
        // Twice as many for each section, but for rounding and holds.
        let after = frames(&window);
        assert!(after.abs_diff(2 * before) <= 12, "{before} {after}");
        for _ in 0..4 {
            press(&mut window, Modifiers::CTRL, Key::Z);
        }
        assert_eq!(frames(&window), before);
        // Those of a host stay.
        let options = Options {
            fixed_speeds: true,
            ..options(language)
        };
        let mut window = window_of(options, LARGE, 1.0, Theme::Dark);
        press(&mut window, Modifiers::NONE, Key::F3);
        let name = format!("{}: {}", texts.base, texts.base_move);
        let field = window.get_by_label(&name);
        assert!(field.accesskit_node().is_disabled());
    }
}

#[test]
fn a_section_gets_so_many_frames_and_keeps_them() {
    for language in BOTH {
        let texts = language.texts();
        let mut window = opened(language);
        let frames = |window: &Window, section: usize| {
            let document = &window.state().document;
            let of = document.timeline(|timeline| timeline.section(section).frames);
            of.unwrap()
        };
        let by_length = frames(&window, 2);
        enter(&mut window, texts.speed_window.frames, "77");
        assert_eq!(frames(&window, 2), 77);
        click(&mut window, texts.speed_window.locked);
        enter(&mut window, texts.space.last_frame, "900");
        let document = &window.state().document;
        assert_eq!(document.sampler().unwrap().frame_count(), 900);
        assert_eq!(frames(&window, 2), 77);
        click(&mut window, texts.speed_window.locked);
        enter(&mut window, texts.space.last_frame, "450");
        assert_ne!(frames(&window, 2), 77);
        enter(&mut window, texts.speed_window.frames, "0");
        assert_eq!(frames(&window, 2), by_length);
        for _ in 0..6 {
            press(&mut window, Modifiers::CTRL, Key::Z);
        }
        assert!(!window.state().document.is_modified());
    }
}

#[test]
fn the_frame_rate_makes_seconds_of_frames() {
    for language in BOTH {
        let texts = &language.texts().speed_window;
        let mut window = opened(language);
        // Fixed times keep their seconds instead.
        click(&mut window, language.texts().space.times);
        let frames = window
            .state()
            .document
            .timeline(|timeline| timeline.section(2).frames)
            .unwrap();
        let shown = |window: &Window, fps: f64| {
            let seconds = language.number(frames as f64 / fps, 2);
            let text = fill(texts.seconds, &[&seconds]);
            value(window, texts.frames) == frames.to_string()
                && window.query_by_label(&text).is_some()
        };
        assert!(shown(&window, 25.0));
        for (name, text) in [(texts.fps, "50"), (texts.hold, "12")] {
            enter(&mut window, name, text);
        }
        assert_eq!(window.state().document.info().fps, 50.0);
        assert_eq!(window.state().orientation().unwrap().hold, 12);
        assert!(shown(&window, 50.0));
    }
}

#[test]
fn pictures() {
    for (language, theme, scale, name) in LOOKS {
        for point in [2, 5] {
            let mut window = window_with_points(language, SMALL, scale, theme);
            window.state_mut().select(point, 0);
            press(&mut window, Modifiers::NONE, Key::F3);
            screenshot(&mut window, &format!("speed-{name}-{point}.png"));
        }
    }
}
