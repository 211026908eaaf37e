//! Tests of [`super`], by mouse and keys as in the window.

use egui::{PointerButton, vec2};
use egui_kittest::kittest::Queryable;
use vides_engine::scene::{Channel, Interpolation};

use super::super::track_graph::tests::*;
use super::super::tracks::tests::*;
use super::*;
use crate::setup::Theme;
use crate::space::tests::{release, tap};
use crate::tests::{BOTH, LARGE, spent};

fn number(harness: &Window, channel: &Channel, key: usize, part: usize) -> f64 {
    let track = track_of(harness, channel);
    track.values()[key * track.width() + part]
}

/// Position keys at 5, 20, 40, 60 with numbers that lie apart.
pub(in crate::playing) fn apart(by: Interpolation) -> Track {
    let values = vec![0.0, 4.0, 8.0, 1.0, 5.0, 9.0, 2.0, 6.0, 10.0, 3.0, 7.0, 11.0];
    let shape = match by {
        Interpolation::Hermite => vec![0.1; 24],
        Interpolation::Tcb => vec![0.0; 12],
        _ => Vec::new(),
    };
    let frames = vec![5.0, 20.0, 40.0, 60.0];
    Track::new(Channel::Position, by, frames, values, shape).unwrap()
}

/// Keys are moved in time and in value, in one step; X and Y hold one of both, Escape gives back.
#[test]
fn a_key_is_dragged_both_ways() {
    let mut harness = graph();
    set_track(&mut harness, apart(Interpolation::Linear));
    let (y, position) = (1, Channel::Position);
    let before = track_of(&harness, &position);
    let from = place(&harness, 20.0, 5.0);
    let to = place(&harness, 30.0, 7.0);
    drag(&mut harness, from, to);
    let after = track_of(&harness, &position);
    assert_eq!(after.frames(), [5.0, 30.0, 40.0, 60.0]);
    // A point of the screen is worth so much.
    let each = (7.0 - 5.0) / f64::from(from.y - to.y);
    assert!(
        (number(&harness, &position, 1, y) - 7.0).abs() < each,
        "{after:?}"
    );
    for (at, (old, new)) in before.values().iter().zip(after.values()).enumerate() {
        assert!(at == 4 || old == new, "{at}");
    }
    assert_eq!(harness.state().selected_keys().len(), 1);
    tap(&mut harness, Key::Z, Modifiers::CTRL);
    assert_eq!(track_of(&harness, &position), before);
    assert!(!harness.state().document.can_undo());
    // The time stays with X, the value with Y; once more lets both go.
    for (keys, frame, moves) in [
        (&[Key::X][..], 20.0, true),
        (&[Key::Y], 30.0, false),
        (&[Key::X, Key::Y], 30.0, false),
        (&[Key::Y, Key::Y], 30.0, true),
    ] {
        take(&mut harness, from, to);
        for &key in keys {
            tap(&mut harness, key, Modifiers::NONE);
        }
        release(&mut harness, to, PointerButton::Primary);
        steps_on(&mut harness);
        let after = track_of(&harness, &position);
        assert_eq!(after.frames()[1], frame, "{keys:?}");
        let moved = number(&harness, &position, 1, y) != 5.0;
        assert_eq!(moved, moves, "{keys:?}");
        tap(&mut harness, Key::Z, Modifiers::CTRL);
        assert_eq!(track_of(&harness, &position), before);
    }
    take(&mut harness, from, to);
    assert_ne!(track_of(&harness, &position), before);
    tap(&mut harness, Key::Escape, Modifiers::NONE);
    release(&mut harness, to, PointerButton::Primary);
    steps_on(&mut harness);
    assert_eq!(track_of(&harness, &position), before);
    assert!(!harness.state().document.can_undo());
    // Shift: tenths of frames, ten times finer.
    hold(&mut harness, Modifiers::SHIFT);
    drag(&mut harness, from, to);
    hold(&mut harness, Modifiers::NONE);
    let frame = track_of(&harness, &position).frames()[1];
    assert!(
        (frame - 21.0).abs() < 0.11 && (frame * 10.0).fract() == 0.0,
        "{frame}"
    );
    let value = number(&harness, &position, 1, y);
    assert!((value - 5.2).abs() < each, "{value}");
    tap(&mut harness, Key::Z, Modifiers::CTRL);
    // Ctrl: a copy.
    hold(&mut harness, Modifiers::CTRL);
    drag(&mut harness, from, to);
    hold(&mut harness, Modifiers::NONE);
    let after = track_of(&harness, &position);
    assert_eq!(after.frames(), [5.0, 20.0, 30.0, 40.0, 60.0]);
    assert_eq!(after.values()[3..6], before.values()[3..6]);
    assert_eq!(after.values()[6], 1.0);
}

/// A box, Ctrl and Shift select numbers of keys, which go together; the others stay.
#[test]
fn several_numbers_are_dragged_together() {
    let mut harness = graph();
    set_track(&mut harness, apart(Interpolation::CatmullRom));
    let position = Channel::Position;
    let before = track_of(&harness, &position);
    // The two middle keys of y, and no x or z.
    let corners = [place(&harness, 15.0, 7.4), place(&harness, 45.0, 4.2)];
    drag(&mut harness, corners[0], corners[1]);
    assert_eq!(harness.state().selected_keys().len(), 2);
    hold(&mut harness, Modifiers::CTRL);
    let at = place(&harness, 60.0, 3.0);
    click(&mut harness, at, PointerButton::Primary);
    hold(&mut harness, Modifiers::NONE);
    assert_eq!(harness.state().selected_keys().len(), 3);
    let (from, to) = (place(&harness, 40.0, 6.0), place(&harness, 42.0, 5.0));
    drag(&mut harness, from, to);
    let after = track_of(&harness, &position);
    assert_eq!(after.frames(), [5.0, 22.0, 42.0, 62.0]);
    let by = after.values()[7] - 6.0;
    assert!(by < -0.8, "{by}");
    for (at, (old, new)) in before.values().iter().zip(after.values()).enumerate() {
        let wanted = match at {
            // y of the second and the third key, x of the last one.
            4 | 7 | 9 => old + by,
            _ => *old,
        };
        assert!((new - wanted).abs() < 1e-12, "{at}: {new}, not {wanted}");
    }
    // Once more: the same ones are still selected.
    let from = place(&harness, 42.0, after.values()[7]);
    drag(&mut harness, from, from + vec2(0.0, 20.0));
    let again = track_of(&harness, &position);
    let changed = after.values().iter().zip(again.values());
    let changed: Vec<usize> = changed
        .enumerate()
        .filter(|(_, (a, b))| a != b)
        .map(|of| of.0)
        .collect();
    assert_eq!(changed, [4, 7, 9]);
    tap(&mut harness, Key::Z, Modifiers::CTRL);
    tap(&mut harness, Key::Z, Modifiers::CTRL);
    assert_eq!(track_of(&harness, &position), before);
    assert!(!harness.state().document.can_undo());
    // Shift: all on the curve up to there.
    let at = place(&harness, 5.0, 8.0);
    click(&mut harness, at, PointerButton::Primary);
    hold(&mut harness, Modifiers::SHIFT);
    let at = place(&harness, 40.0, 10.0);
    click(&mut harness, at, PointerButton::Primary);
    hold(&mut harness, Modifiers::NONE);
    let keys: Vec<usize> = harness
        .state()
        .selected_keys()
        .iter()
        .map(|at| at.key)
        .collect();
    assert_eq!(keys, [0, 1, 2]);
    // Delete and undo mean the keys.
    tap(&mut harness, Key::Delete, Modifiers::NONE);
    assert_eq!(track_of(&harness, &position).frames(), [60.0]);
    tap(&mut harness, Key::Z, Modifiers::CTRL);
    assert_eq!(track_of(&harness, &position), before);
}

/// The handles of own tangents: smooth, mirrored and corner.
#[test]
fn handles_change_tangents() {
    let _stay = crate::tests::functions_stay();
    for language in BOTH {
        let mut harness = graph_in(language, LARGE, Theme::Light);
        let position = Channel::Position;
        set_track(&mut harness, apart(Interpolation::Hermite));
        let before = track_of(&harness, &position);
        let tangents = |harness: &Window| {
            let track = track_of(harness, &Channel::Position);
            let of_key = &track.shape()[6..12];
            // Of y: before and after; the others stay.
            assert_eq!([of_key[0], of_key[2], of_key[3], of_key[5]], [0.1; 4]);
            assert_eq!(track.values(), apart(Interpolation::Hermite).values());
            [of_key[1], of_key[4]]
        };
        let dot = place(&harness, 20.0, 5.0);
        click(&mut harness, dot, PointerButton::Primary);
        // It points along the curve.
        let along = |harness: &Window, slope: f64| {
            let [a, b] = [
                place(harness, 20.0, 5.0),
                place(harness, 40.0, 5.0 + 20.0 * slope),
            ];
            (b - a).normalized()
        };
        let way = along(&harness, 0.1) * 40.0;
        let texts = &language.texts().position;
        // Smooth, as both are alike.
        let steep = along(&harness, 0.3) * 40.0;
        drag(&mut harness, dot + way, dot + steep);
        let [into, out] = tangents(&harness);
        assert!((out - 0.3).abs() < 0.01 && into == out, "{into} {out}");
        tap(&mut harness, Key::Z, Modifiers::CTRL);
        assert_eq!(track_of(&harness, &position), before);
        assert!(!harness.state().document.can_undo());
        for (joint, words) in [
            (Joint::Corner, texts.corner),
            (Joint::Mirrored, texts.mirrored),
        ] {
            click(&mut harness, dot, PointerButton::Secondary);
            harness.get_by_label(words).click();
            steps_on(&mut harness);
            let [into, out] = tangents(&harness);
            match joint {
                Joint::Corner => assert_eq!([into, out], [0.1; 2]),
                _ => assert_eq!(into, -out),
            }
            let way = along(&harness, out) * 40.0;
            drag(&mut harness, dot + way, dot + steep);
            let [into, out] = tangents(&harness);
            assert!((out - 0.3).abs() < 0.01, "{joint:?} {out}");
            match joint {
                Joint::Corner => assert_eq!(into, 0.1),
                _ => assert_eq!(into, -out),
            }
            while harness.state().document.can_undo() {
                tap(&mut harness, Key::Z, Modifiers::CTRL);
            }
            assert_eq!(track_of(&harness, &position), before);
        }
    }
}

/// Tension, continuity and bias of the selected keys are numbers of the menu.
#[test]
fn tension_is_entered_in_the_menu() {
    let _stay = crate::tests::functions_stay();
    let mut harness = graph();
    set_track(&mut harness, apart(Interpolation::Tcb));
    let before = track_of(&harness, &Channel::Position);
    let dot = place(&harness, 20.0, 5.0);
    click(&mut harness, dot, PointerButton::Secondary);
    let name = harness.state().texts().curve.tension;
    let field = harness.get_by_label(name).rect().center();
    drag(&mut harness, field, field + vec2(40.0, 0.0));
    let after = track_of(&harness, &Channel::Position);
    let shape = after.shape();
    assert!(
        (0.2..=0.4).contains(&shape[3]) && shape[..3] == [0.0; 3],
        "{shape:?}"
    );
    assert_eq!(shape[4..], [0.0; 8]);
    tap(&mut harness, Key::Escape, Modifiers::NONE);
    tap(&mut harness, Key::Z, Modifiers::CTRL);
    assert_eq!(track_of(&harness, &Channel::Position), before);
    assert!(!harness.state().document.can_undo());
}

/// Angles are dragged; quaternions are shown as angles, and their numbers stay.
#[test]
fn quaternions_are_only_read() {
    let mut harness = graph();
    let frames = vec![10.0, 30.0, 50.0];
    let angles = vec![0.0, 40.0, -40.0, 400.0, 20.0, 10.0, 90.0, -60.0, 20.0];
    let by = Interpolation::EulerLinear;
    let track = Track::new(Channel::Rotation, by, frames.clone(), angles, Vec::new()).unwrap();
    set_track(&mut harness, track);
    choose(&mut harness, &Channel::Rotation);
    // More than one turn.
    let (from, to) = (place(&harness, 30.0, 400.0), place(&harness, 30.0, 250.0));
    drag(&mut harness, from, to);
    let yaw = number(&harness, &Channel::Rotation, 1, 0);
    assert!((yaw - 250.0).abs() < 5.0, "{yaw}");
    let half = std::f64::consts::FRAC_1_SQRT_2;
    let turns = vec![
        1.0, 0.0, 0.0, 0.0, half, 0.0, half, 0.0, half, half, 0.0, 0.0,
    ];
    let by = Interpolation::Linear;
    let track = Track::new(Channel::Rotation, by, frames, turns, Vec::new()).unwrap();
    set_track(&mut harness, track.clone());
    // A quarter turn about y is a yaw of ninety degrees.
    let from = place(&harness, 30.0, 90.0);
    let near = diamonds(&harness)
        .into_iter()
        .any(|at| at.distance(from) < 1.0);
    assert!(near, "{from:?}");
    drag(&mut harness, from, from + vec2(0.0, 30.0));
    assert_eq!(track_of(&harness, &Channel::Rotation), track);
    assert!(!harness.state().document.can_undo());
    // In time it moves.
    let to = place(&harness, 35.0, 60.0);
    drag(&mut harness, from, to);
    let after = track_of(&harness, &Channel::Rotation);
    assert_eq!(after.frames(), [10.0, 35.0, 50.0]);
    assert_eq!(after.values(), track.values());
}

/// Numbers stay in the range of their channel.
#[test]
fn numbers_stay_in_range() {
    let mut harness = graph();
    choose(&mut harness, &Channel::Intensity);
    let from = place(&harness, 10.0, 0.0);
    let value = number(&harness, &Channel::Intensity, 0, 0);
    assert_eq!(value, 0.0);
    drag(&mut harness, from, from + vec2(0.0, 60.0));
    assert_eq!(number(&harness, &Channel::Intensity, 0, 0), 0.0);
    let refused = harness
        .state()
        .message
        .as_ref()
        .is_some_and(|said| said.error);
    assert!(!refused);
    drag(&mut harness, from, from - vec2(0.0, 30.0));
    assert!(number(&harness, &Channel::Intensity, 0, 0) > 0.01);
}

/// A pass in which a key is dragged costs little more than one that scrubs, in a scene of ten
/// thousand nodes with a million keys.
#[test]
fn timed_a_dragged_key_costs_little_more_than_scrubbing() {
    use vides_engine::scene::{Kind, Node, Scene};
    let mut scene = Scene::new();
    let frames: Vec<f64> = (0..100).map(|key| 1.0 + 3.0 * f64::from(key)).collect();
    let values: Vec<f64> = (0..300).map(|at| 0.01 * f64::from(at % 37)).collect();
    for number in 0..10_000_u32 {
        let at = scene
            .add(Node::new(&format!("node {number}"), Kind::Group))
            .unwrap();
        let (frames, values) = (frames.clone(), values.clone());
        let by = Interpolation::CatmullRom;
        let track = Track::new(Channel::Position, by, frames, values, Vec::new());
        scene.set_track(at, track.unwrap()).unwrap();
    }
    let mut document = vides_document::Document::new();
    let edit = vides_document::Edit::ReplaceScene(Box::new(scene));
    document.apply(edit).unwrap();
    let options = crate::Options {
        document: document.as_opened(),
        ..crate::tests::options(crate::texts::Language::English)
    };
    let mut harness = crate::tests::window_of(options, LARGE, 1.0, Theme::Dark);
    harness.state_mut().select_nodes(vec![1]);
    steps_on(&mut harness);
    let name = harness.state().texts().timeline.graph_switch;
    harness.get_by_label(name).click();
    steps_on(&mut harness);
    let spent = |harness: &mut Window, pass: &mut dyn FnMut(&mut Window, u8)| {
        let mut all: Vec<f64> = (0..15_u8)
            .map(|number| {
                let before = spent();
                pass(harness, number);
                harness.step();
                spent() - before
            })
            .collect();
        all.sort_by(f64::total_cmp);
        all[all.len() / 2]
    };
    let scrubbed = spent(&mut harness, &mut |harness, number| {
        harness.state_mut().scrub(100.0 + f64::from(number));
    });
    let value = number(&harness, &Channel::Position, 40, 1);
    let from = place(&harness, 121.0, value);
    take(&mut harness, from, from + vec2(20.0, 20.0));
    let mut values = vec![value];
    let dragged = spent(&mut harness, &mut |harness, number| {
        values.push(self::number(harness, &Channel::Position, 40, 1));
        let to = from + vec2(0.0, 20.0 + f32::from(number));
        harness.event(egui::Event::PointerMoved(to));
    });
    // Each pass has moved it.
    values.dedup();
    assert!(values.len() >= 15, "{values:?}");
    let ratio = dragged / scrubbed;
    println!("{dragged:.1} ms a pass, {ratio:.2} times one that scrubs");
    assert!(ratio <= 1.5, "{ratio}: {dragged} and {scrubbed} ms");
}
