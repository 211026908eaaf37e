//! Tests of [`super`].

use egui::{Key, Modifiers, PointerButton};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;
use vides_engine::limits::BASE_SPEED;
use vides_engine::path;

use super::*;
use crate::screenshots::screenshot;
use crate::space::tests::{motion, press, pyramid, pyramid_window, release, tap};

/// The way from the start of a section to its end by the speeds that are shown is the
/// way that the camera goes in its frames.
#[test]
fn the_area_under_the_graph_is_the_way() {
    let document = pyramid();
    let mut marks = Marks::default();
    marks.update(&document).unwrap();
    let path = document.path();
    for stretch in &marks.graph.stretches {
        let Selection { point, orientation } = stretch.from;
        let section = document
            .timeline(|timeline| {
                timeline.section(timeline.section_from(point, orientation).unwrap())
            })
            .unwrap();
        assert_eq!(stretch.end - stretch.start, section.frames);
        if section.change != Change::Position {
            continue;
        }
        // Trapezoids; a base section of speed 50 takes `move_frames` for a length of 1.
        let pairs = stretch.speeds.windows(2);
        let mean = pairs
            .map(|pair| f64::from(pair[0] + pair[1]) / 2.0)
            .sum::<f64>()
            / PIECES as f64;
        let way = mean / BASE_SPEED * section.frames as f64 / path.base_frames.movement;
        assert!(
            (way / section.amount - 1.0).abs() < 0.01,
            "{way} {section:?}"
        );
    }
}

#[test]
fn where_there_are_no_ten_speeds_none_are_dragged() {
    let mut harness = pyramid_window();
    harness.state_mut().document.select(2, 0).unwrap();
    harness.step();
    assert!(harness.query_by_label("Speed 4").is_some());
    let ease = path::Ease {
        kind: path::EaseKind::Parabolic,
        rise: 0.25,
        fall: 0.0,
        cruise: 50.0,
    };
    let way = [[0.0, 0.0], [0.5, 0.2], [1.0, 1.0]].as_slice();
    for pace in [path::Pace::Ease(ease), path::Pace::Distance(way.into())] {
        let set = |own: &mut path::OrientationOverrides| own.pace = pace.clone();
        harness
            .state_mut()
            .set_orientation(|new| new.own = new.own.with(set).unwrap());
        harness.step();
        harness.step();
        assert!(harness.query_by_label("Speed 4").is_none(), "{pace:?}");
    }
    // The graph shows the pace itself: a fifth of the way in the first half.
    let stretches = &harness.state().playing.marks.graph.stretches;
    let selection = harness.state().document.selection();
    let shown = stretches.iter().find(|stretch| stretch.from == selection);
    let speeds = shown.unwrap().speeds;
    let way = |pieces: std::ops::Range<usize>| -> f32 {
        pieces.map(|at| speeds[at] + speeds[at + 1]).sum()
    };
    let half = way(0..PIECES / 2) / way(0..PIECES);
    assert!((half - 0.2).abs() < 0.005, "{half}");
}

#[test]
fn a_speed_of_the_current_section_is_dragged_up_and_down() {
    let mut harness = pyramid_window();
    harness.state_mut().document.select(2, 0).unwrap();
    harness.step();
    let speeds = |harness: &Harness<'_, Editor>| harness.state().orientation().unwrap().speeds;
    let before = speeds(&harness);
    let at = harness.get_by_label("Speed 4").rect().center();
    press(&mut harness, at, PointerButton::Primary);
    motion(&mut harness, at + vec2(0.0, 12.0));
    screenshot(&mut harness, "graph-dark.png");
    release(&mut harness, at + vec2(0.0, 12.0), PointerButton::Primary);
    let after = speeds(&harness);
    assert!(after[3] < before[3] - 10.0, "{before:?} {after:?}");
    for other in (0..SPEEDS).filter(|&other| other != 3) {
        assert_eq!(after[other], before[other]);
    }
    tap(&mut harness, Key::Z, Modifiers::CTRL);
    assert_eq!(speeds(&harness), before);
}

/// Where the next section goes on as fast, it follows; where not, or where the camera rests between
/// them, it stays as it was.
#[test]
fn a_speed_at_which_two_sections_meet_is_dragged_for_both() {
    let mut harness = pyramid_window();
    let speeds = |harness: &Harness<'_, Editor>| {
        let points = &harness.state().document.path().points;
        [1, 2].map(|at| points[at].orientations.last().unwrap().speeds)
    };
    let drag = |harness: &mut Harness<'_, Editor>, name: &str, by: f32| {
        harness.step();
        harness.step();
        let at = harness.get_by_label(name).rect().center();
        press(harness, at, PointerButton::Primary);
        motion(harness, at + vec2(0.0, by));
        release(harness, at + vec2(0.0, by), PointerButton::Primary);
    };
    let before = speeds(&harness);
    harness.state_mut().document.select(2, 0).unwrap();
    drag(&mut harness, "Speed 1", 20.0);
    let after = speeds(&harness);
    assert!(after[1][0] < before[1][0] - 10.0, "{before:?} {after:?}");
    assert!((after[0][SPEEDS - 1] - after[1][0]).abs() < 2.0);
    assert_eq!(after[0][..SPEEDS - 1], before[0][..SPEEDS - 1]);
    // From the other side, too, as one step each.
    harness.state_mut().document.select(1, 0).unwrap();
    drag(&mut harness, "Speed 10", -10.0);
    let both = speeds(&harness);
    assert!((both[0][SPEEDS - 1] - both[1][0]).abs() < 2.0 && both[1][0] > after[1][0] + 4.0);
    for known in [after, before] {
        tap(&mut harness, Key::Z, Modifiers::CTRL);
        assert_eq!(speeds(&harness), known);
    }
    // Across a rest, and where they differ already.
    harness.state_mut().document.select(2, 0).unwrap();
    harness.state_mut().set_orientation(|key| key.hold = 5);
    drag(&mut harness, "Speed 1", 20.0);
    assert_eq!(speeds(&harness)[0], before[0]);
    harness.state_mut().set_orientation(|key| key.hold = 0);
    drag(&mut harness, "Speed 1", 5.0);
    assert_eq!(speeds(&harness)[0], before[0]);
}

/// As in the window of the speeds; then the section goes by them.
#[test]
fn speeds_near_a_part_of_a_pace_are_dragged_too() {
    let mut harness = pyramid_window();
    harness.state_mut().document.select(2, 0).unwrap();
    let of = path::own::PaceSource::Speeds {
        speeds: harness.state().orientation().unwrap().speeds,
        slopes: [0.0; 2],
    };
    let (from, to) = (0.0, 0.5);
    let part = path::Pace::Part(path::own::PacePart { of, from, to });
    harness.state_mut().set_orientation(|new| {
        let own = new.own.with(|own| own.pace = part.clone());
        new.own = own.unwrap();
    });
    harness.step();
    harness.step();
    let pace = |harness: &Harness<'_, Editor>| {
        let orientation = harness.state().orientation().unwrap();
        orientation.own.pace.clone()
    };
    assert_eq!(pace(&harness), part);
    let at = harness.get_by_label("Speed 4").rect().center();
    press(&mut harness, at, PointerButton::Primary);
    motion(&mut harness, at + vec2(0.0, 12.0));
    release(&mut harness, at + vec2(0.0, 12.0), PointerButton::Primary);
    assert_eq!(pace(&harness), path::Pace::Speeds);
    tap(&mut harness, Key::Z, Modifiers::CTRL);
    assert_eq!(pace(&harness), part);
}

/// Where a camera runs by keys there is nothing to plot.
#[test]
fn without_a_path_no_plot_is_chosen() {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/car.vid");
    let (document, _) = vides_document::Document::load_scene(file.as_ref()).unwrap();
    let options = crate::Options {
        document,
        ..crate::tests::options(crate::Language::English)
    };
    let (size, theme) = (crate::tests::LARGE, crate::setup::Theme::Dark);
    let mut window = crate::tests::window_of(options, size, 1.0, theme);
    let texts = &window.state().texts().space;
    let name = texts.plot;
    window.get_by_label(name).click();
    window.run();
    assert!(!egui::Popup::is_any_open(&window.ctx));
    assert_eq!(window.state().playing.shown, plot::Shown::default());
}
