//! Tests of [`super`], by mouse and keys as in the window.

use egui::{Key, Modifiers, Pos2, Rangef, pos2, vec2};
use egui_kittest::kittest::Queryable;

use super::*;
use crate::playing::tracks::tests::{Window, steps_on};
use crate::screenshots::screenshot;
use crate::space::tests::{motion, press, pyramid_window, release, tap};

fn axis(harness: &Window) -> Axis {
    let bar = harness.get_by_label("Frame").rect();
    let rail = Rangef::new(bar.left() + 8.0, bar.right() - 8.0);
    let playing = &harness.state().playing;
    Axis::new(rail, playing.marks.range, playing.seen)
}

fn wheel(harness: &mut Window, at: Pos2, steps: f32, modifiers: Modifiers) {
    motion(harness, at);
    harness.event(Event::MouseWheel {
        unit: MouseWheelUnit::Line,
        delta: vec2(0.0, steps),
        phase: egui::TouchPhase::Move,
        source: egui::MouseWheelSource::Wheel,
        modifiers,
    });
    steps_on(harness);
}

/// The middles of ruler, keys and graph, at this part of their width.
fn rows(harness: &Window, share: f32) -> [Pos2; 3] {
    let texts = harness.state().texts();
    let ruler = harness.get_by_label(texts.space.timeline).rect();
    let canvas = |name| {
        harness
            .get_by_role_and_label(egui::Role::Canvas, name)
            .rect()
    };
    let x = ruler.left() + share * ruler.width();
    let keys = canvas(texts.timeline.all_sections);
    let all = [ruler, keys, canvas(texts.space.speed_graph)];
    all.map(|row| pos2(x, row.center().y))
}

/// Wherever the pointer is over the time, the frame below it stays there; what is seen of keys and
/// graph goes along with the ruler.
#[test]
fn the_wheel_zooms_about_the_pointer() {
    for row in 0..3 {
        let mut harness = pyramid_window();
        let before = harness.render().unwrap();
        let at = rows(&harness, 0.4)[row];
        let frame = axis(&harness).frame(at.x);
        wheel(&mut harness, at, 5.0, Modifiers::NONE);
        let part = axis(&harness);
        let span = part.last() - part.first();
        let all = harness.state().playing.marks.frames as f64 - 1.0;
        assert!((span / all - WHEEL.powi(5)).abs() < 1e-6, "{span} of {all}");
        assert!((part.frame(at.x) - frame).abs() < 1e-6);
        // A key's sign goes along; those outside are not there.
        let mut shown = 0;
        for mark in harness.state().playing.marks.keys.clone() {
            let name = harness.state().name_of(mark.point, mark.orientation);
            let label = format!("Time of {name}");
            let sign = harness.query_by_label(&label);
            let x = part.x_of(mark.first());
            assert_eq!(sign.is_some(), part.sees(x), "{name}");
            if let Some(sign) = sign {
                assert!(sign.rect().x_range().expand(0.5).contains(x), "{name}");
                shown += 1;
            }
        }
        assert!((1..7).contains(&shown), "{shown}");
        let picture = screenshot(&mut harness, &format!("timeline-zoomed-{row}.png"));
        assert_ne!(picture, before);
        wheel(&mut harness, at, -9.0, Modifiers::NONE);
        assert_eq!(harness.state().playing.seen, None);
        assert!(!harness.state().document.can_undo());
    }
}

/// With all of it shown again the picture is that of before, to the pixel.
#[test]
fn with_all_shown_nothing_differs() {
    let mut harness = pyramid_window();
    let before = harness.render().unwrap();
    let at = rows(&harness, 0.7)[0];
    let seen = axis(&harness).zoomed(at.x, 0.3);
    harness.state_mut().playing.see(seen);
    harness.run();
    assert_ne!(harness.render().unwrap(), before);
    harness.state_mut().playing.see(None);
    harness.run();
    assert_eq!(harness.render().unwrap(), before);
}

/// The middle button takes the time along and moves neither playhead nor key; with Shift the wheel
/// moves it. Home shows all, and once more it is the first frame, as it was.
#[test]
fn the_middle_button_moves_what_is_seen_and_home_shows_all() {
    let mut harness = pyramid_window();
    for at in rows(&harness, 0.4) {
        wheel(&mut harness, at, 6.0, Modifiers::NONE);
        let before = axis(&harness);
        let playhead = harness.state().position_on_bar();
        press(&mut harness, at, PointerButton::Middle);
        for step in 1..=4_u8 {
            motion(&mut harness, at + vec2(-20.0 * f32::from(step), 0.0));
        }
        release(&mut harness, at - vec2(80.0, 0.0), PointerButton::Middle);
        steps_on(&mut harness);
        let after = axis(&harness);
        assert!((after.frame(at.x - 80.0) - before.frame(at.x)).abs() < 1e-3);
        assert_eq!(harness.state().position_on_bar(), playhead);
        assert!(!harness.state().document.can_undo());
        wheel(&mut harness, at, 1.0, Modifiers::SHIFT);
        let moved = axis(&harness);
        assert!(moved.first() < after.first() || after.first() == 1.0);
        assert!((moved.last() - moved.first() - after.last() + after.first()).abs() < 1e-6);
        let ruler = harness.get_by_label("Frame").rect();
        let place = pos2(at.x, ruler.center().y);
        press(&mut harness, place, PointerButton::Primary);
        release(&mut harness, place, PointerButton::Primary);
        steps_on(&mut harness);
        assert!(harness.state().position_on_bar() > 1.0);
        tap(&mut harness, Key::Home, Modifiers::NONE);
        assert_eq!(harness.state().playing.seen, None);
        assert!(harness.state().position_on_bar() > 1.0);
        tap(&mut harness, Key::Home, Modifiers::NONE);
        assert_eq!(harness.state().position_on_bar(), 1.0);
    }
}

/// Gone to by keys or played, the playhead is in sight.
#[test]
fn the_playhead_stays_in_sight() {
    let mut harness = pyramid_window();
    let sees = |harness: &Window| {
        let axis = axis(harness);
        let at = harness.state().position_on_bar();
        (axis.first()..=axis.last()).contains(&at)
    };
    let at = rows(&harness, 0.1)[0];
    wheel(&mut harness, at, 10.0, Modifiers::NONE);
    let span = axis(&harness).last() - axis(&harness).first();
    let name = harness.state().texts().space.timeline;
    harness.get_by_label(name).focus();
    for _ in 0..4 {
        tap(&mut harness, Key::Period, Modifiers::NONE);
        steps_on(&mut harness);
        assert!(sees(&harness));
    }
    assert!(harness.state().position_on_bar() > 400.0);
    tap(&mut harness, Key::Comma, Modifiers::NONE);
    steps_on(&mut harness);
    assert!(sees(&harness));
    let axis = axis(&harness);
    assert!((axis.last() - axis.first() - span).abs() < 1e-6);
    harness.state_mut().scrub(axis.last() - 2.0);
    harness.get_by_label("Play").click();
    for _ in 0..10 {
        harness.step();
        assert!(sees(&harness));
    }
}
