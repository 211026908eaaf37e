//! Other paces than ten speeds in the speed window.

use egui::{Pos2, vec2};
use vides_engine::path::{Ease, EaseKind, Pace, Timing};

use super::distance_tests::with_distance;
use super::tests::{drag, opened};
use crate::screenshots::screenshot;
use crate::tests::*;

pub(super) fn pace(window: &Window) -> Pace {
    window.state().orientation().unwrap().own.pace.clone()
}

fn ease(window: &Window) -> Ease {
    match pace(window) {
        Pace::Ease(ease) => ease,
        other => panic!("{other:?}"),
    }
}

pub(super) fn keys(window: &Window) -> Vec<[f64; 2]> {
    match pace(window) {
        Pace::Distance(keys) => keys.to_vec(),
        other => panic!("{other:?}"),
    }
}

pub(super) fn timing(window: &Window) -> Timing {
    let document = &window.state().document;
    let timing = document.timeline(|timeline| timeline.timing(document.path(), 2));
    timing.unwrap().unwrap()
}

pub(super) fn frames(window: &Window) -> usize {
    let document = &window.state().document;
    document
        .timeline(|timeline| timeline.section(2).frames)
        .unwrap()
}

/// Chooses a pace or a graph.
pub(super) fn choose(window: &mut Window, title: &str, name: &str) {
    let label = format!("{title}: {name}");
    window
        .get_by_role_and_label(Role::RadioButton, &label)
        .click();
    window.run();
}

pub(super) fn handle(window: &Window, name: &str) -> Pos2 {
    let square = window.get_by_role_and_label(Role::Slider, name);
    square.rect().center()
}

pub(super) fn is_there(window: &Window, name: &str) -> bool {
    window.query_by_role_and_label(Role::Slider, name).is_some()
}

/// Drags what has this name.
pub(super) fn drag_handle(window: &mut Window, name: &str, way: egui::Vec2) {
    let from = handle(window, name);
    drag(window, from, way);
    window.drop_at(from + way);
    window.run();
}

/// Where the section begins and ends in the picture: below the first and the last of the
/// ten speeds.
fn ends(window: &Window) -> [f32; 2] {
    let language = window.state().language();
    [1, 10].map(|at| {
        let name = fill(language.texts().speed_window.speed, &[&at]);
        handle(window, &name).x
    })
}

/// The curve of the picture: the line with most points.
pub(super) fn curve(window: &Window) -> Vec<Pos2> {
    let shapes = window.output().shapes.iter();
    let lines = shapes.filter_map(|clipped| match &clipped.shape {
        egui::Shape::Path(path) if !path.closed => Some(path.points.clone()),
        _ => None,
    });
    lines.max_by_key(Vec::len).expect("a curve")
}

/// How high the curve is at a share of the time, as a share of the room between two
/// heights.
fn height(curve: &[Pos2], [left, right]: [f32; 2], u: f32) -> f32 {
    let x = left + u * (right - left);
    let at = curve.partition_point(|point| point.x < x).max(1);
    let (a, b) = (curve[at - 1], curve[at.min(curve.len() - 1)]);
    a.y + (b.y - a.y) * ((x - a.x) / (b.x - a.x).max(1e-6)).clamp(0.0, 1.0)
}

#[test]
fn an_ease_is_chosen_and_the_section_takes_as_long() {
    for language in BOTH {
        let texts = &language.texts().speed_window;
        for (name, kind) in [
            (texts.sine, EaseKind::Sine),
            (texts.parabolic, EaseKind::Parabolic),
        ] {
            let mut window = opened(language);
            let (before, mean) = (frames(&window), timing(&window).mean());
            choose(&mut window, texts.pace, name);
            let chosen = ease(&window);
            assert_eq!((chosen.kind, chosen.rise, chosen.fall), (kind, 0.25, 0.25));
            // What the parabola's trapezoid and the sine's integral leave of the cruise.
            let area = match kind {
                EaseKind::Parabolic => 0.75,
                EaseKind::Sine => 0.5 + 0.5 * 2.0 / std::f64::consts::PI,
            };
            assert!((chosen.cruise * area - mean).abs() < 0.05, "{chosen:?}");
            assert!(frames(&window).abs_diff(before) <= 1, "{name}");
            // No ten speeds are offered any more, in numbers or squares.
            let first = fill(texts.speed, &[&1]);
            assert!(window.query_all_by_label(&first).next().is_none());
            assert!(window.query_by_label(texts.ease_in).is_none());
            press(&mut window, Modifiers::CTRL, Key::Z);
            assert_eq!(pace(&window), Pace::Speeds);
            assert!(!window.state().document.is_modified());
        }
    }
}

#[test]
fn the_numbers_of_an_ease_are_typed() {
    for language in BOTH {
        let texts = &language.texts().speed_window;
        let mut window = opened(language);
        choose(&mut window, texts.pace, texts.sine);
        for (name, text, wrong) in [
            (texts.rise, "40", false),
            (texts.fall, "60,5", true),
            (texts.fall, "60", false),
            (texts.rise, "7", false),
            (texts.cruise, "101", true),
            (texts.cruise, "77,5", false),
        ] {
            enter(&mut window, name, text);
            assert_eq!(
                said_besides_length(&window).is_some(),
                wrong,
                "{name} {text}"
            );
            window.state_mut().message = None;
        }
        let Ease {
            rise, fall, cruise, ..
        } = ease(&window);
        assert_eq!([rise, fall, cruise], [0.07, 0.6, 77.5]);
        assert_eq!(value(&window, texts.rise), "7\u{a0}%");
        // Another kind has the same shares, and takes as long.
        let mean = timing(&window).mean();
        choose(&mut window, texts.pace, texts.parabolic);
        assert_eq!((ease(&window).rise, ease(&window).fall), (0.07, 0.6));
        assert!((timing(&window).mean() - mean).abs() < 0.05);
    }
}

#[test]
fn the_corners_of_an_ease_are_dragged_aside_in_each_graph() {
    for language in BOTH {
        let texts = &language.texts().speed_window;
        for graph in [
            texts.graph_speed,
            texts.graph_distance,
            texts.graph_acceleration,
        ] {
            let mut window = opened(language);
            let [left, right] = ends(&window);
            choose(&mut window, texts.pace, texts.parabolic);
            choose(&mut window, texts.graph, graph);
            let before = ease(&window);
            let at = |share: f32| left + share * (right - left);
            let of = |window: &Window, name: &str| handle(window, name).x;
            assert!((of(&window, texts.rise_end) - at(0.25)).abs() < 0.5);
            assert!((of(&window, texts.fall_start) - at(0.75)).abs() < 0.5);
            let tenth = vec2(0.1 * (right - left), 0.0);
            drag_handle(&mut window, texts.rise_end, tenth + vec2(0.0, 25.0));
            assert_eq!(
                ease(&window),
                Ease {
                    rise: 0.35,
                    ..before
                },
                "{graph}"
            );
            drag_handle(&mut window, texts.fall_start, -tenth);
            assert_eq!(ease(&window).fall, 0.35, "{graph}");
            // No farther than to each other; there each is taken at its own side.
            drag_handle(&mut window, texts.rise_end, 7.0 * tenth);
            assert_eq!((ease(&window).rise, ease(&window).fall), (0.65, 0.35));
            drag_handle(&mut window, texts.rise_end, -tenth);
            assert_eq!((ease(&window).rise, ease(&window).fall), (0.55, 0.35));
            drag_handle(&mut window, texts.fall_start, tenth);
            assert_eq!((ease(&window).rise, ease(&window).fall), (0.55, 0.25));
            for _ in 0..5 {
                press(&mut window, Modifiers::CTRL, Key::Z);
            }
            assert_eq!(ease(&window), before, "each is one step");
            // By keys; and a drag is broken off.
            window
                .get_by_role_and_label(Role::Slider, texts.fall_start)
                .focus();
            window.run();
            press(&mut window, Modifiers::NONE, Key::ArrowRight);
            press(&mut window, Modifiers::SHIFT, Key::ArrowLeft);
            assert_eq!(ease(&window).fall, 0.34);
            let from = handle(&window, texts.rise_end);
            drag(&mut window, from, tenth);
            assert_ne!(ease(&window).rise, before.rise);
            press(&mut window, Modifiers::NONE, Key::Escape);
            assert_eq!(ease(&window).rise, before.rise);
            window.drop_at(from);
            window.run();
        }
    }
}

#[test]
fn the_picture_shows_speed_way_and_acceleration() {
    let texts = &Language::English.texts().speed_window;
    let mut window = opened(Language::English);
    let ends = ends(&window);
    choose(&mut window, texts.pace, texts.parabolic);
    enter(&mut window, texts.rise, "40");
    enter(&mut window, texts.fall, "20");
    let cruise = ease(&window).cruise as f32;
    // Closed forms of the trapezoid, to a pixel.
    let speed = |u: f32| cruise * (u / 0.4).min((1.0 - u) / 0.2).min(1.0);
    let way = |u: f32| {
        let gone = match u {
            u if u < 0.4 => u * u / 0.8,
            u if u < 0.8 => u - 0.2,
            u => 0.7 - (1.0 - u) * (1.0 - u) / 0.4,
        };
        gone / 0.7
    };
    let change = |u: f32| match u {
        u if u < 0.4 => 1.0 / 0.4,
        u if u < 0.8 => 0.0,
        _ => -1.0 / 0.2,
    };
    let graphs: [(&str, &dyn Fn(f32) -> f32); 3] = [
        (texts.graph_speed, &speed),
        (texts.graph_distance, &way),
        (texts.graph_acceleration, &change),
    ];
    for (name, expected) in graphs {
        choose(&mut window, texts.graph, name);
        let curve = curve(&window);
        let y = |u: f32| height(&curve, ends, u);
        // Two places give the scale; all others must fit.
        let (a, b) = (0.1, 0.6);
        let scale = (y(b) - y(a)) / (expected(b) - expected(a));
        assert!(
            scale.abs() * (expected(b) - expected(a)).abs() > 20.0,
            "{name}"
        );
        for k in 1..40 {
            let u = k as f32 / 40.0 + 0.003;
            let fits = y(a) + scale * (expected(u) - expected(a));
            assert!((y(u) - fits).abs() < 1.0, "{name} {u}: {} {fits}", y(u));
        }
    }
}

#[test]
fn what_the_engine_refuses_is_a_sentence() {
    for (language, sentence) in [
        (Language::German, "2 bis 32"),
        (Language::English, "between 2 and 32"),
    ] {
        let texts = &language.texts().speed_window;
        let mut window = with_distance(language);
        for _ in 3..32 {
            click(&mut window, texts.new_key);
            assert!(said(&window).is_none());
        }
        assert_eq!(keys(&window).len(), 32);
        click(&mut window, texts.new_key);
        assert_eq!(keys(&window).len(), 32);
        let said = said(&window).expect("a refusal");
        assert!(said.contains(sentence), "{said}");
    }
}

#[test]
fn all_of_it_has_a_hint() {
    for language in BOTH {
        let texts = &language.texts().speed_window;
        let mut window = window_with_points(language, LARGE, 1.0, Theme::Dark);
        press(&mut window, Modifiers::NONE, Key::F3);
        let paces = [
            (texts.ten, texts.ten_hint),
            (texts.sine, texts.sine_hint),
            (texts.parabolic, texts.parabolic_hint),
            (texts.distance, texts.distance_hint),
        ];
        let graphs = [
            (texts.graph_speed, texts.graph_speed_hint),
            (texts.graph_distance, texts.graph_distance_hint),
            (texts.graph_acceleration, texts.graph_acceleration_hint),
        ];
        let titled = |title, all: &[(&str, &'static str)]| -> Vec<(String, &'static str)> {
            let label = |name: &str| format!("{title}: {name}");
            all.iter()
                .map(|&(name, hint)| (label(name), hint))
                .collect()
        };
        let mut all = titled(texts.pace, &paces);
        all.extend(titled(texts.graph, &graphs));
        for (label, hint) in &all {
            assert!(tip(&mut window, label, hint), "{label}");
        }
        choose(&mut window, texts.pace, texts.sine);
        for (label, hint) in [
            (texts.rise, texts.rise_hint),
            (texts.fall, texts.fall_hint),
            (texts.cruise, texts.cruise_hint),
        ] {
            assert!(tip(&mut window, label, hint), "{label}");
        }
        choose(&mut window, texts.pace, texts.distance);
        for (label, hint) in [
            (texts.key_time, texts.key_time_hint),
            (texts.key_way, texts.key_way_hint),
            (texts.new_key, texts.new_key_hint),
            (texts.remove_key, texts.remove_key_hint),
        ] {
            assert!(tip(&mut window, label, hint), "{label}");
        }
        // No key stands in the middle.
        for _ in 0..keys(&window).len() / 2 {
            click(&mut window, texts.remove_key);
        }
        assert!(tip(&mut window, texts.way_graph, texts.way_graph_hint));
    }
}

/// The texts of the sub-window that are painted, with their places: what is painted after
/// its title.
fn texts_of(window: &Window) -> Vec<(String, egui::Rect)> {
    let title = window.state().texts().speed_window.title;
    let shapes = window.output().shapes.iter();
    let texts = shapes.filter_map(|clipped| match &clipped.shape {
        egui::Shape::Text(text) if !text.galley.text().is_empty() => {
            let rect = text.galley.rect.translate(text.pos.to_vec2());
            Some((text.galley.text().to_owned(), rect, clipped.clip_rect))
        }
        _ => None,
    });
    let texts: Vec<_> = texts.collect();
    let first = texts.iter().rposition(|(text, _, _)| text == title);
    let own = texts.into_iter().skip(first.expect("a title"));
    own.map(|(text, rect, clip)| {
        // It scrolls.
        let across = clip.x_range().expand(1.0);
        let within = across.contains(rect.left()) && across.contains(rect.right());
        assert!(within, "{text} is cut off");
        (text, rect)
    })
    .collect()
}

#[test]
fn no_text_lies_over_another_in_the_smallest_window() {
    for language in BOTH {
        let texts = &language.texts().speed_window;
        let mut window = window_with_points(language, SMALL, 1.0, Theme::Dark);
        press(&mut window, Modifiers::NONE, Key::F3);
        for pace in [texts.ten, texts.sine, texts.parabolic, texts.distance] {
            if pace != texts.ten {
                choose(&mut window, texts.pace, pace);
            }
            for graph in [
                texts.graph_acceleration,
                texts.graph_distance,
                texts.graph_speed,
            ] {
                choose(&mut window, texts.graph, graph);
                window.hover_at(egui::pos2(1.0, 599.0));
                window.run();
                let shown = texts_of(&window);
                assert!(shown.len() > 25, "{}", shown.len());
                for (index, (one, a)) in shown.iter().enumerate() {
                    for (other, b) in &shown[index + 1..] {
                        let both = a.shrink(1.0).intersects(b.shrink(1.0));
                        assert!(!both, "{pace}: {one} {a:?} over {other} {b:?}");
                    }
                }
            }
        }
    }
}

#[test]
fn pictures() {
    for (language, theme, scale, name) in LOOKS {
        for size in [SMALL, LARGE] {
            let texts = &language.texts().speed_window;
            let mut window = window_with_points(language, size, scale, theme);
            press(&mut window, Modifiers::NONE, Key::F3);
            let end = if size == SMALL { "small" } else { "large" };
            screenshot(&mut window, &format!("pace-{name}-{end}-0ten.png"));
            choose(&mut window, texts.graph, texts.graph_acceleration);
            screenshot(&mut window, &format!("pace-{name}-{end}-1acc.png"));
            choose(&mut window, texts.pace, texts.parabolic);
            screenshot(&mut window, &format!("pace-{name}-{end}-2acc.png"));
            choose(&mut window, texts.pace, texts.sine);
            choose(&mut window, texts.graph, texts.graph_speed);
            screenshot(&mut window, &format!("pace-{name}-{end}-3sine.png"));
            choose(&mut window, texts.pace, texts.distance);
            screenshot(&mut window, &format!("pace-{name}-{end}-4way.png"));
            choose(&mut window, texts.graph, texts.graph_speed);
            screenshot(&mut window, &format!("pace-{name}-{end}-5speed.png"));
        }
    }
}
