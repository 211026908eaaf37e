//! Tests of [`super`], by mouse and keys as in the window.

use egui::{Event, Key, Modifiers, MouseWheelUnit, PointerButton, Pos2, Shape};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;
use vides_document::{Document, Edit};
use vides_engine::path::CameraPath;
use vides_engine::scene::{Channel, Extrapolation, Interpolation, Kind, Part, Scene, Track};

use super::*;
use crate::playing::track_rows::OUTSIDE;
use crate::screenshots::screenshot;
use crate::setup::Theme;
pub(in crate::playing) use crate::space::tests::hold;
use crate::space::tests::{motion, press, release, tap};
use crate::tests::{LARGE, SMALL, options, spent, window_of};
use crate::texts::{Language, fill};

pub(in crate::playing) type Window = Harness<'static, Editor>;

pub(in crate::playing) fn track(channel: Channel, frames: &[f64], width: usize) -> Track {
    let values = (0..frames.len() * width).map(|k| 0.25 * k as f64).collect();
    Track::new(
        channel,
        Interpolation::Linear,
        frames.to_vec(),
        values,
        Vec::new(),
    )
    .unwrap()
}

/// A camera on a path from frame 1, a lamp by keys, and a drone on a path from frame 21.
pub(in crate::playing) fn document() -> Document {
    let mut scene = Scene::new();
    let on_path = |name, kind, start| {
        let mut node = Node::new(name, kind);
        let path = FollowPath::new(CameraPath::default(), start, Extrapolation::Hold).unwrap();
        node.set_path(Some(path)).unwrap();
        node
    };
    scene
        .add(on_path("camera", Kind::Camera(Default::default()), 1.0))
        .unwrap();
    scene
        .add(Node::new("lamp", Kind::Light(Default::default())))
        .unwrap();
    scene.add(on_path("drone", Kind::Group, 21.0)).unwrap();
    let mut document = Document::new();
    document.apply(Edit::ReplaceScene(Box::new(scene))).unwrap();
    for track in [
        track(Channel::Position, &[5.0, 20.0, 40.0, 60.0], 3),
        track(Channel::Intensity, &[10.0, 20.0], 1),
    ] {
        let channel = track.channel().clone();
        let part = Part::track(1, channel, Some(track)).unwrap();
        document.apply(Edit::Part(Box::new(part))).unwrap();
    }
    document.as_opened()
}

pub(in crate::playing) fn window_in(language: Language, size: [f32; 2], theme: Theme) -> Window {
    let options = crate::Options {
        document: document(),
        ..options(language)
    };
    let mut harness = window_of(options, size, 1.0, theme);
    harness.state_mut().select_nodes(vec![1, 2]);
    let editor = harness.state_mut();
    editor.edit_node(Some(0));
    editor.document = editor.document.try_clone().unwrap().as_opened();
    steps_on(&mut harness);
    harness
}

pub(in crate::playing) fn window() -> Window {
    window_in(Language::English, LARGE, Theme::Dark)
}

/// A hint that comes keeps the window busy.
pub(in crate::playing) fn steps_on(harness: &mut Window) {
    for _ in 0..4 {
        harness.step();
    }
}

/// Where a frame of the scene is on the screen, by the ruler.
pub(in crate::playing) fn x_of(harness: &Window, frame: f64) -> f32 {
    let name = harness.state().texts().space.timeline;
    let bar = harness.get_by_label(name).rect();
    let editor = harness.state();
    let (first, last) = editor.playing.axis;
    let width = f64::from(bar.width() - 16.0);
    (f64::from(bar.left()) + 8.0 + width * (frame - first) / (last - first)) as f32
}

/// The place of a frame in a row.
pub(in crate::playing) fn place_in_row(harness: &Window, row: usize, frame: f64) -> Pos2 {
    let name = harness.state().texts().timeline.tracks;
    let rows = harness.get_by_role_and_label(Role::Canvas, name).rect();
    pos2(x_of(harness, frame), rows.top() + ROW * (row as f32 + 0.5))
}

pub(in crate::playing) fn frames(harness: &Window, channel: &Channel) -> Vec<f64> {
    let edited = harness.state().document.edited_scene().unwrap();
    let keys = edited.scene().nodes()[1].keys();
    keys.track(channel)
        .map_or(Vec::new(), |track| track.frames().to_vec())
}

pub(in crate::playing) fn values(harness: &Window) -> Vec<f64> {
    let edited = harness.state().document.edited_scene().unwrap();
    let keys = edited.scene().nodes()[1].keys();
    keys.track(&Channel::Position).unwrap().values().to_vec()
}

pub(in crate::playing) fn selected(harness: &Window) -> Vec<(Channel, usize)> {
    let keys = harness.state().selected_keys();
    keys.into_iter().map(|at| (at.channel, at.key)).collect()
}

pub(in crate::playing) fn take(harness: &mut Window, from: Pos2, to: Pos2) {
    press(harness, from, PointerButton::Primary);
    for step in 1..=4_u8 {
        motion(harness, from + (to - from) * (f32::from(step) / 4.0));
    }
    harness.step();
}

pub(in crate::playing) fn drag(harness: &mut Window, from: Pos2, to: Pos2) {
    take(harness, from, to);
    release(harness, to, PointerButton::Primary);
    steps_on(harness);
}

pub(in crate::playing) fn click(harness: &mut Window, at: Pos2, button: PointerButton) {
    press(harness, at, button);
    release(harness, at, button);
    steps_on(harness);
}

pub(in crate::playing) const POSITION: usize = 1;
const INTENSITY: usize = 2;
pub(in crate::playing) const DRONE: usize = 3;

#[test]
fn pictures() {
    for (language, size, theme, name) in [
        (Language::English, LARGE, Theme::Dark, "en-dark"),
        (Language::German, SMALL, Theme::Light, "de-light"),
    ] {
        let mut harness = window_in(language, size, theme);
        let at = place_in_row(&harness, POSITION, 20.0);
        click(&mut harness, at, PointerButton::Primary);
        hold(&mut harness, Modifiers::CTRL);
        let other = place_in_row(&harness, INTENSITY, 10.0);
        click(&mut harness, other, PointerButton::Primary);
        hold(&mut harness, Modifiers::NONE);
        screenshot(&mut harness, &format!("tracks-{name}.png"));
        let to = place_in_row(&harness, POSITION, 33.0);
        take(&mut harness, at, to);
        screenshot(&mut harness, &format!("tracks-{name}-drag.png"));
        release(&mut harness, to, PointerButton::Primary);
        click(&mut harness, to, PointerButton::Secondary);
        screenshot(&mut harness, &format!("tracks-{name}-menu.png"));
    }
}

/// Signs stand where the axis says, to half a pixel, for a thousand tracks, all shown and a part.
#[test]
fn diamonds_stand_at_their_frames() {
    let mut seed = 1_u64;
    let mut random = || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        (seed >> 33) as f64 / f64::from(1_u32 << 31)
    };
    let mut harness = window();
    let middle = place_in_row(&harness, POSITION, 1.0).y;
    let ruler = harness.get_by_label("Frame").rect();
    let rail = Rangef::new(ruler.left() + 8.0, ruler.right() - 8.0);
    let mut checked = 0;
    for _ in 0..1000 {
        let mut frames: Vec<f64> = (0..1 + (random() * 12.0) as usize)
            .map(|_| (random() * 900.0 - 50.0) * 0.1)
            .collect();
        frames.sort_by(f64::total_cmp);
        frames.dedup();
        let part = Part::track(
            1,
            Channel::Position,
            Some(track(Channel::Position, &frames, 3)),
        );
        let edit = Edit::Part(Box::new(part.unwrap()));
        let editor = harness.state_mut();
        editor.document.apply(edit).unwrap();
        let all = editor.document.frame_range().unwrap();
        let whole = Axis::new(rail, all, None);
        let seen = match random() < 0.5 {
            true => whole.zoomed(rail.min + 500.0, 0.05 + random()),
            false => None,
        };
        editor.playing.see(seen);
        let (first, last) = match seen {
            Some(_) => {
                let axis = Axis::new(rail, all, seen);
                (axis.first(), axis.last())
            }
            None => all,
        };
        harness.step();
        harness.step();
        let wanted: Vec<f32> = frames
            .iter()
            .map(|frame| {
                let share = (frame - first) / (last - first);
                (f64::from(rail.min) + share * f64::from(rail.span())) as f32
            })
            .filter(|&x| rail.contains(x))
            .collect();
        let painted: Vec<f32> = harness
            .output()
            .shapes
            .iter()
            .filter_map(|shape| match &shape.shape {
                Shape::Path(path) if path.closed && path.points.len() == 4 => {
                    let centre = shape.shape.visual_bounding_rect().center();
                    ((centre.y - middle).abs() < 2.0).then_some(centre.x)
                }
                _ => None,
            })
            .collect();
        for &x in &wanted {
            let exact = painted.iter().any(|at| (at - x).abs() <= 0.5);
            // Others may stand for it.
            let close = wanted.iter().any(|at| *at != x && (at - x).abs() < APART);
            let near = painted.iter().any(|at| (at - x).abs() <= APART);
            assert!(exact || (close && near), "{x} of {wanted:?}: {painted:?}");
            checked += 1;
        }
        for &x in painted.iter().filter(|x| rail.contains(**x)) {
            assert!(
                wanted.iter().any(|at| (at - x).abs() <= 0.5),
                "{x}: {wanted:?}"
            );
        }
    }
    assert!(checked > 2000, "{checked}");
}

#[test]
fn keys_are_selected_by_clicks_and_by_a_box() {
    let mut harness = window();
    let at = |harness: &Window, frame| place_in_row(harness, POSITION, frame);
    let there = at(&harness, 20.0);
    click(&mut harness, there, PointerButton::Primary);
    assert_eq!(selected(&harness), [(Channel::Position, 1)]);
    hold(&mut harness, Modifiers::CTRL);
    let there = at(&harness, 60.0);
    click(&mut harness, there, PointerButton::Primary);
    assert_eq!(selected(&harness).len(), 2);
    click(&mut harness, there, PointerButton::Primary);
    assert_eq!(selected(&harness), [(Channel::Position, 1)]);
    hold(&mut harness, Modifiers::SHIFT);
    click(&mut harness, there, PointerButton::Primary);
    assert_eq!(selected(&harness).len(), 3);
    hold(&mut harness, Modifiers::NONE);
    // The sign of the node stands for both tracks.
    let there = place_in_row(&harness, 0, 20.0);
    click(&mut harness, there, PointerButton::Primary);
    let both = [(Channel::Position, 1), (Channel::Intensity, 1)];
    assert_eq!(selected(&harness), both);
    let there = at(&harness, 30.0);
    click(&mut harness, there, PointerButton::Primary);
    assert!(selected(&harness).is_empty());
    let (from, to) = (at(&harness, 15.0), place_in_row(&harness, INTENSITY, 45.0));
    drag(&mut harness, from, to);
    let all = [
        (Channel::Position, 1),
        (Channel::Position, 2),
        (Channel::Intensity, 1),
    ];
    assert_eq!(selected(&harness), all);
    assert!(!harness.state().document.can_undo());
    // With Ctrl besides those.
    hold(&mut harness, Modifiers::CTRL);
    let (from, to) = (at(&harness, 55.0), place_in_row(&harness, INTENSITY, 65.0));
    drag(&mut harness, from, to);
    assert_eq!(selected(&harness).len(), 4);
    hold(&mut harness, Modifiers::NONE);
    let (from, to) = (at(&harness, 15.0), place_in_row(&harness, INTENSITY, 45.0));
    drag(&mut harness, from, to);
    assert_eq!(selected(&harness), all);
    tap(&mut harness, Key::Delete, Modifiers::NONE);
    assert_eq!(frames(&harness, &Channel::Position), [5.0, 60.0]);
    assert_eq!(frames(&harness, &Channel::Intensity), [10.0]);
    tap(&mut harness, Key::Z, Modifiers::CTRL);
    assert_eq!(frames(&harness, &Channel::Intensity), [10.0, 20.0]);
    assert!(!harness.state().document.can_undo());
}

/// To whole frames, with Shift to tenths; what it comes to lie on comes back with undo.
#[test]
fn keys_are_dragged_in_time() {
    let mut harness = window();
    let before = values(&harness);
    let [from, to] = [20.0, 29.7].map(|frame| place_in_row(&harness, POSITION, frame));
    drag(&mut harness, from, to);
    assert_eq!(
        frames(&harness, &Channel::Position),
        [5.0, 30.0, 40.0, 60.0]
    );
    assert_eq!(values(&harness), before);
    assert_eq!(selected(&harness), [(Channel::Position, 1)]);
    // Past another one, which stays as it was, and onto one, whose place it takes.
    let [from, to] = [30.0, 60.0].map(|frame| place_in_row(&harness, POSITION, frame));
    drag(&mut harness, from, to);
    assert_eq!(frames(&harness, &Channel::Position), [5.0, 40.0, 60.0]);
    assert_eq!(values(&harness)[6..], before[3..6]);
    tap(&mut harness, Key::Z, Modifiers::CTRL);
    tap(&mut harness, Key::Z, Modifiers::CTRL);
    assert_eq!(values(&harness), before);
    assert!(!harness.state().document.can_undo());
    let from = place_in_row(&harness, POSITION, 20.0);
    // Shift.
    hold(&mut harness, Modifiers::SHIFT);
    let to = place_in_row(&harness, POSITION, 24.0);
    drag(&mut harness, from, to);
    hold(&mut harness, Modifiers::NONE);
    let at = frames(&harness, &Channel::Position)[1];
    assert!(
        (at - 20.4).abs() < 0.11 && (at * 10.0).fract() == 0.0,
        "{at}"
    );
}

/// With Ctrl copies are dragged.
#[test]
fn copies_are_dragged() {
    let mut harness = window();
    // Undo selects what it changes; the rows stay where they are.
    harness.state_mut().select_nodes(vec![1]);
    steps_on(&mut harness);
    let [from, to] = [20.0, 30.0].map(|frame| place_in_row(&harness, POSITION, frame));
    hold(&mut harness, Modifiers::CTRL);
    drag(&mut harness, from, to);
    hold(&mut harness, Modifiers::NONE);
    let all = [5.0, 20.0, 30.0, 40.0, 60.0];
    assert_eq!(frames(&harness, &Channel::Position), all);
    assert_eq!(values(&harness)[3..6], values(&harness)[6..9]);
    tap(&mut harness, Key::Z, Modifiers::CTRL);
    assert!(!harness.state().document.can_undo());
}

#[test]
fn a_bracket_scales_the_time_of_a_selection() {
    let mut harness = window();
    harness.state_mut().select_nodes(vec![1]);
    steps_on(&mut harness);
    let (from, to) = (
        place_in_row(&harness, POSITION, 15.0),
        place_in_row(&harness, POSITION, 70.0),
    );
    drag(&mut harness, from, to);
    assert_eq!(selected(&harness).len(), 3);
    let bracket = place_in_row(&harness, POSITION, 60.0) + vec2(OUTSIDE, 0.0);
    let gone = x_of(&harness, 40.0) - x_of(&harness, 60.0);
    drag(&mut harness, bracket, bracket + vec2(gone, 0.0));
    assert_eq!(
        frames(&harness, &Channel::Position),
        [5.0, 20.0, 30.0, 40.0]
    );
    tap(&mut harness, Key::Z, Modifiers::CTRL);
    assert!(!harness.state().document.can_undo());
    // Tangents are by frame: half the time, twice as steep.
    let hermite = Track::new(
        Channel::Position,
        Interpolation::Hermite,
        frames(&harness, &Channel::Position),
        values(&harness),
        vec![1.0; 24],
    );
    let part = Part::track(1, Channel::Position, Some(hermite.unwrap())).unwrap();
    let edit = Edit::Part(Box::new(part));
    harness.state_mut().document.apply(edit).unwrap();
    steps_on(&mut harness);
    drag(&mut harness, from, to);
    drag(&mut harness, bracket, bracket + vec2(gone, 0.0));
    let edited = harness.state().document.edited_scene().unwrap();
    let keys = edited.scene().nodes()[1].keys();
    let track = keys.track(&Channel::Position).unwrap();
    assert_eq!(track.frames(), [5.0, 20.0, 30.0, 40.0]);
    let steep = [vec![1.0; 6], vec![2.0; 18]].concat();
    assert_eq!(track.shape(), steep);
}

/// A path's bar moves its start, and nothing else of it.
#[test]
fn a_bar_is_dragged() {
    let mut harness = window();
    let start = |harness: &Window| {
        let edited = harness.state().document.edited_scene().unwrap();
        edited.scene().nodes()[2].path().unwrap().start_frame()
    };
    assert_eq!(start(&harness), 21.0);
    let [from, to] = [30.0, 42.0].map(|frame| place_in_row(&harness, DRONE, frame));
    drag(&mut harness, from, to);
    assert_eq!(start(&harness), 33.0);
    tap(&mut harness, Key::Z, Modifiers::CTRL);
    assert_eq!(start(&harness), 21.0);
    assert!(!harness.state().document.can_undo());
}

#[test]
fn comma_and_period_go_from_key_to_key() {
    let mut harness = window();
    let name = harness.state().texts().space.timeline;
    harness.get_by_label(name).focus();
    harness.state_mut().scrub(12.0);
    steps_on(&mut harness);
    for (key, expected) in [
        (Key::Period, 20.0),
        (Key::Period, 40.0),
        (Key::Comma, 20.0),
        (Key::Comma, 10.0),
        (Key::Comma, 5.0),
    ] {
        tap(&mut harness, key, Modifiers::NONE);
        steps_on(&mut harness);
        let frame = harness.state().frame().unwrap();
        assert_eq!(frame, expected);
    }
}

/// Rows scroll with the wheel; with Ctrl it zooms.
#[test]
fn rows_scroll_and_fold() {
    let mut harness = window();
    let texts = &harness.state().texts().timeline;
    let (name, canvas) = (fill(texts.tracks_of, &[&"lamp"]), texts.tracks);
    let height = |harness: &Window| {
        let rows = harness.get_by_role_and_label(Role::Canvas, canvas);
        rows.rect().height()
    };
    assert_eq!(height(&harness), 4.0 * ROW);
    harness.get_by_label(&name).click();
    steps_on(&mut harness);
    assert_eq!(height(&harness), 2.0 * ROW);
    harness.get_by_label(&name).click();
    steps_on(&mut harness);
    // Lower than its rows.
    harness.state_mut().set_graph_height(44.0);
    harness.state_mut().setup.speed_graph = false;
    steps_on(&mut harness);
    assert_eq!(height(&harness), 44.0);
    let first = |harness: &Window| harness.get_by_label(&name).rect().top();
    let (at, top) = (place_in_row(&harness, 1, 30.0), first(&harness));
    for (modifiers, zooms) in [(Modifiers::CTRL, true), (Modifiers::NONE, false)] {
        harness.state_mut().playing.see(None);
        motion(&mut harness, at);
        harness.event(Event::MouseWheel {
            unit: MouseWheelUnit::Line,
            delta: vec2(0.0, if zooms { 1.0 } else { -1.0 }),
            phase: egui::TouchPhase::Move,
            source: egui::MouseWheelSource::Wheel,
            modifiers,
        });
        for _ in 0..20 {
            harness.step();
        }
        assert_eq!(harness.state().playing.seen.is_some(), zooms);
        let scrolled = harness.query_by_label(&name).is_none() || first(&harness) < top;
        assert_eq!(scrolled, !zooms);
    }
}

/// Rows cost where they are seen: ten thousand of them scroll nearly as fast as a hundred.
#[test]
fn timed_many_rows_scroll_as_fast_as_few() {
    let mut scene = Scene::new();
    for number in 0..10_000_u32 {
        let mut lamp = Node::new(&format!("lamp {number}"), Kind::Light(Default::default()));
        lamp.rest.intensity = 0.5;
        scene.add(lamp).unwrap();
        let frames = [1.0, 10.0 + f64::from(number % 80), 100.0];
        scene
            .set_track(number as usize, track(Channel::Position, &frames, 3))
            .unwrap();
    }
    let mut document = Document::new();
    document.apply(Edit::ReplaceScene(Box::new(scene))).unwrap();
    let options = crate::Options {
        document: document.as_opened(),
        ..options(Language::English)
    };
    let mut harness = window_of(options, LARGE, 1.0, Theme::Dark);
    let mut best = [f64::INFINITY; 2];
    for round in 0..10 {
        let few = round % 2 == 0;
        let count = if few { 50 } else { 5_000 };
        harness.state_mut().select_nodes((0..count).collect());
        steps_on(&mut harness);
        let at = place_in_row(&harness, 1, 30.0);
        motion(&mut harness, at);
        let start = spent();
        for pass in 0..30 {
            harness.event(Event::MouseWheel {
                unit: MouseWheelUnit::Line,
                delta: vec2(0.0, if pass < 15 { -2.0 } else { 2.0 }),
                phase: egui::TouchPhase::Move,
                source: egui::MouseWheelSource::Wheel,
                modifiers: Modifiers::NONE,
            });
            harness.step();
        }
        best[round % 2] = best[round % 2].min(spent() - start);
    }
    let ratio = best[1] / best[0];
    println!(
        "{:.1} ms a pass, {ratio:.2} times that of a hundred rows",
        best[1] / 30.0
    );
    assert!(ratio <= 1.2, "{ratio}");
}

/// Shift and Home show the selected keys, else what moves the nodes; Home shows everything.
#[test]
fn shift_and_home_show_the_selection() {
    let mut harness = window();
    let at = place_in_row(&harness, POSITION, 20.0);
    click(&mut harness, at, PointerButton::Primary);
    hold(&mut harness, Modifiers::SHIFT);
    let at = place_in_row(&harness, POSITION, 40.0);
    click(&mut harness, at, PointerButton::Primary);
    hold(&mut harness, Modifiers::NONE);
    let ruler = harness.get_by_label("Frame").rect();
    let rail = Rangef::new(ruler.left() + 8.0, ruler.right() - 8.0);
    let axis = |harness: &Window| {
        let playing = &harness.state().playing;
        Axis::new(rail, playing.marks.range, playing.seen)
    };
    tap(&mut harness, Key::Home, Modifiers::SHIFT);
    steps_on(&mut harness);
    let ends = [20.0, 40.0].map(|frame| axis(&harness).place(frame));
    // All of them, with little room beside.
    assert!(rail.contains(ends[0]) && rail.contains(ends[1]), "{ends:?}");
    assert!(ends[1] - ends[0] > 0.8 * rail.span(), "{ends:?}");
    tap(&mut harness, Key::Home, Modifiers::NONE);
    steps_on(&mut harness);
    assert!(axis(&harness).shows_all());
    // Without a key all that moves: from the first one to the end of the drone's path.
    harness.state_mut().select_keys(Vec::new());
    harness.state_mut().select_nodes(vec![1]);
    steps_on(&mut harness);
    let name = harness.state().texts().space.timeline;
    harness.get_by_label(name).focus();
    tap(&mut harness, Key::Home, Modifiers::SHIFT);
    steps_on(&mut harness);
    let ends = [5.0, 60.0].map(|frame| axis(&harness).place(frame));
    assert!(rail.contains(ends[0]) && rail.contains(ends[1]), "{ends:?}");
    assert!(ends[1] - ends[0] > 0.8 * rail.span(), "{ends:?}");
}
