//! A distance over the time in the speed window: its keys are dragged, added and removed.

use egui::{Pos2, vec2};
use vides_engine::path::Pace;

use super::pace_tests::{choose, curve, drag_handle, frames, handle, is_there, keys, timing};
use super::tests::{drag, opened};
use crate::screenshots::screenshot;
use crate::tests::*;

#[test]
fn a_distance_begins_as_the_way_is_and_the_ten_speeds_are_kept() {
    for language in BOTH {
        let texts = &language.texts().speed_window;
        for first in [texts.ten, texts.sine, texts.parabolic] {
            let mut window = opened(language);
            let speeds = window.state().orientation().unwrap().speeds;
            if first != texts.ten {
                choose(&mut window, texts.pace, first);
            }
            let (before, old) = (timing(&window), frames(&window));
            choose(&mut window, texts.pace, texts.distance);
            assert_eq!(frames(&window), old, "as long as before");
            let keys = keys(&window);
            assert!((3..=19).contains(&keys.len()), "{keys:?}");
            for [time, way] in &keys {
                assert_eq!(before.fraction(*time), *way);
            }
            let now = timing(&window);
            for k in 0..=1000 {
                let u = f64::from(k) / 1000.0;
                assert!((now.fraction(u) - before.fraction(u)).abs() < 0.0025, "{u}");
            }
            choose(&mut window, texts.pace, texts.ten);
            let orientation = window.state().orientation().unwrap();
            assert_eq!((orientation.speeds, orientation.own.frames), (speeds, 0));
            assert!(orientation.own.is_empty());
            for _ in 0..2 + usize::from(first != texts.ten) {
                press(&mut window, Modifiers::CTRL, Key::Z);
            }
            assert!(!window.state().document.is_modified(), "each is one step");
        }
        // Even motion needs no key between; what was fixed stays so.
        let mut window = opened(language);
        click(&mut window, texts.constant);
        enter(&mut window, texts.frames, "77");
        choose(&mut window, texts.pace, texts.distance);
        assert_eq!(keys(&window), [[0.0, 0.0], [1.0, 1.0]]);
        choose(&mut window, texts.pace, texts.sine);
        assert_eq!(frames(&window), 77);
    }
}

/// A window that shows a distance of three keys.
pub(super) fn with_distance(language: Language) -> Window {
    let mut window = opened(language);
    let texts = &language.texts().speed_window;
    choose(&mut window, texts.pace, texts.distance);
    let way = [[0.0, 0.0], [0.5, 0.25], [1.0, 1.0]].as_slice();
    let set =
        |own: &mut vides_engine::path::OrientationOverrides| own.pace = Pace::Distance(way.into());
    let editor = window.state_mut();
    editor.set_orientation(|new| new.own = new.own.with(set).unwrap());
    editor.document.mark_saved();
    window.run();
    window
}

#[test]
fn keys_of_a_distance_are_dragged_between_their_neighbours() {
    for language in BOTH {
        let texts = &language.texts().speed_window;
        let mut window = with_distance(language);
        let name = fill(texts.way_key, &[&2]);
        let canvas = window.get_by_label(texts.way_graph).rect();
        let from = handle(&window, &name);
        drag_handle(&mut window, &name, vec2(40.0, -30.0));
        let to = handle(&window, &name);
        assert!(
            (to - from - vec2(40.0, -30.0)).length() < 1.0,
            "{from} {to}"
        );
        let [time, way] = keys(&window)[1];
        assert!(time > 0.55 && way > 0.35, "{time} {way}");
        // What is seen is what is said.
        assert_eq!(
            value(&window, texts.key_way),
            format!("{}\u{a0}%", language.number(100.0 * way, 1))
        );
        for way in [canvas.size(), -canvas.size()] {
            drag_handle(&mut window, &name, way);
            let all = keys(&window);
            assert_eq!(all.len(), 3);
            for part in 0..2 {
                assert!(all.windows(2).all(|pair| pair[1][part] > pair[0][part]));
            }
            assert_eq!(said_besides_length(&window), None);
        }
        for _ in 0..3 {
            press(&mut window, Modifiers::CTRL, Key::Z);
        }
        assert!(!window.state().document.is_modified(), "each is one step");
        assert_eq!(keys(&window)[1], [0.5, 0.25]);
        window.get_by_role_and_label(Role::Slider, &name).focus();
        window.run();
        press(&mut window, Modifiers::NONE, Key::ArrowRight);
        press(&mut window, Modifiers::SHIFT, Key::ArrowUp);
        let [time, way] = keys(&window)[1];
        assert!((time - 0.51).abs() < 1e-12 && (way - 0.35).abs() < 1e-12);
        let number = [
            (texts.key_time, "60"),
            (texts.key_way, "12,5"),
            (texts.key_way, "100"),
        ];
        for (name, text) in number {
            enter(&mut window, name, text);
        }
        assert_eq!(keys(&window)[1], [0.6, 0.125]);
        assert!(said(&window).is_some(), "100 % is where the next key is");
        // The ends stay, and are no handles.
        for end in [1, 3] {
            assert!(!is_there(&window, &fill(texts.way_key, &[&end])));
        }
    }
}

#[test]
fn a_click_on_the_curve_adds_a_key_and_delete_or_a_right_click_removes_it() {
    for language in BOTH {
        let texts = &language.texts().speed_window;
        let mut window = with_distance(language);
        let points = window.state().document.path().points.len();
        let before = timing(&window);
        let three = handle(&window, &fill(texts.way_key, &[&2]));
        let there = curve(&window)[140];
        let tap = |window: &mut Window, at: Pos2, button| {
            window.hover_at(at);
            window.run();
            for pressed in [true, false] {
                window.event(egui::Event::PointerButton {
                    pos: at,
                    button,
                    pressed,
                    modifiers: Modifiers::NONE,
                });
                window.run();
            }
        };
        let primary = egui::PointerButton::Primary;
        tap(&mut window, there + vec2(0.0, 40.0), primary);
        assert_eq!(keys(&window).len(), 3, "beside the curve");
        tap(&mut window, there, primary);
        let all = keys(&window);
        assert_eq!(all.len(), 4);
        assert!((all[2][0] - 140.0 / 180.0).abs() < 0.003);
        assert_eq!(all[2][1], before.fraction(all[2][0]), "on the curve");
        assert_eq!(handle(&window, &fill(texts.way_key, &[&2])), three);
        tap(&mut window, there, egui::PointerButton::Secondary);
        assert_eq!(keys(&window).len(), 3);
        press(&mut window, Modifiers::CTRL, Key::Z);
        assert_eq!(keys(&window), all, "one step");
        // Delete means the key that has the keyboard, and elsewhere the point.
        let third = fill(texts.way_key, &[&3]);
        window.get_by_role_and_label(Role::Slider, &third).focus();
        window.run();
        press(&mut window, Modifiers::NONE, Key::Delete);
        assert_eq!(keys(&window).len(), 3);
        assert_eq!(window.state().document.path().points.len(), points);
        click(&mut window, texts.new_key);
        click(&mut window, texts.remove_key);
        assert_eq!(keys(&window).len(), 3);
        window.get_by_label(texts.new_key).focus();
        window.run();
        press(&mut window, Modifiers::NONE, Key::Delete);
        assert_eq!(window.state().document.path().points.len(), points - 1);
    }
}

#[test]
fn the_key_whose_numbers_are_shown_is_marked_wherever_the_pointer_is() {
    for language in BOTH {
        let texts = &language.texts().speed_window;
        let mut window = with_distance(language);
        click(&mut window, texts.new_key);
        let names = [2, 3].map(|at| fill(texts.way_key, &[&at]));
        let away = window.get_by_label(texts.title).rect().center();
        for (chosen, name) in names.iter().enumerate() {
            let at = handle(&window, name);
            drag(&mut window, at, vec2(0.0, 0.0));
            window.drop_at(at);
            window.run();
            window.hover_at(away);
            window.run();
            window.ctx.memory_mut(|memory| {
                let focused = memory.focused().expect("the key");
                memory.surrender_focus(focused);
            });
            window.run();
            let which = fill(texts.which_key, &[&(chosen + 2), &keys(&window).len()]);
            assert!(window.query_by_label(&which).is_some(), "{which}");
            let is_marked = |name: &str| {
                let at = handle(&window, name);
                window.output().shapes.iter().any(|clipped| {
                    matches!(&clipped.shape, egui::Shape::Rect(rect)
                        if rect.rect.center().distance(at) < 0.5 && rect.rect.width() > 15.0)
                })
            };
            for (other, name) in names.iter().enumerate() {
                assert_eq!(is_marked(name), other == chosen, "{name}");
            }
            screenshot(&mut window, &format!("way-key-{chosen}.png"));
        }
    }
}
