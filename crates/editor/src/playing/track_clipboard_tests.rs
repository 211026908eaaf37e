//! Tests of [`super`], by keys as in the window.

use egui::{Key, Modifiers, OutputCommand, ViewportCommand};
use vides_engine::scene::{Interpolation, Kind, Scene};

use super::super::tracks::tests::*;
use super::*;
use crate::space::tests::tap;
use crate::state::scene_view::KeyAt;
use crate::tests::LARGE;
use crate::texts::Language;

fn track(channel: Channel, by: Interpolation, frames: &[f64], values: &[f64]) -> Track {
    let keys = frames.len();
    let shape = match by {
        Interpolation::Hermite => vec![0.25; 2 * values.len()],
        Interpolation::Tcb => vec![0.5; 3 * keys],
        _ => Vec::new(),
    };
    Track::new(channel, by, frames.to_vec(), values.to_vec(), shape).unwrap()
}

/// The lamp with keys of intensity and position is selected; beside it there is another lamp.
fn with_two_lamps() -> Window {
    let mut harness = window_in(Language::English, LARGE, crate::setup::Theme::Dark);
    let mut other = Node::new("other lamp", Kind::Light(Default::default()));
    other.rest.intensity = 0.5;
    let editor = harness.state_mut();
    editor.document.apply(Edit::AddNodes(vec![other])).unwrap();
    editor.select_nodes(vec![1]);
    editor.document = editor.document.try_clone().unwrap().as_opened();
    steps_on(&mut harness);
    harness
}

fn select(harness: &mut Window, keys: &[(Channel, usize)]) {
    let keys = keys.iter().map(|(channel, key)| KeyAt {
        node: 1,
        channel: channel.clone(),
        key: *key,
    });
    let keys = keys.collect();
    harness.state_mut().select_keys(keys);
    focus(harness);
}

fn focus(harness: &mut Window) {
    let id = super::super::track_rows::id();
    harness.ctx.memory_mut(|memory| memory.request_focus(id));
    steps_on(harness);
}

fn focus_ruler(harness: &mut Window) {
    let ruler = super::super::ruler::id();
    harness.ctx.memory_mut(|memory| memory.request_focus(ruler));
    steps_on(harness);
}

/// What a key leaves on the clipboard.
fn copied(harness: &mut Window, key: Key) -> Option<String> {
    harness.event(Event::Key {
        key,
        physical_key: None,
        pressed: true,
        repeat: false,
        modifiers: Modifiers::CTRL,
    });
    harness.step();
    let commands = &harness.output().platform_output.commands;
    let text = commands.iter().find_map(|command| match command {
        OutputCommand::CopyText(text) => Some(text.clone()),
        _ => None,
    });
    steps_on(harness);
    text
}

fn paste(harness: &mut Window, text: &str) {
    harness.event(Event::Paste(text.to_owned()));
    steps_on(harness);
}

fn track_of(harness: &Window, node: usize, channel: &Channel) -> Option<Track> {
    let edited = harness.state().document.edited_scene().unwrap();
    edited.scene().nodes()[node].keys().track(channel).cloned()
}

fn message(harness: &Window) -> String {
    let said = harness.state().message.as_ref();
    said.map_or(String::new(), |said| said.text.clone())
}

/// The whole scene, to be compared.
fn scene(harness: &Window) -> Scene {
    harness.state().document.scene().unwrap()
}

#[test]
fn keys_are_copied_and_put_in_at_the_playhead() {
    let mut harness = with_two_lamps();
    let before = scene(&harness);
    select(
        &mut harness,
        &[
            (Channel::Position, 1),
            (Channel::Position, 2),
            (Channel::Intensity, 1),
        ],
    );
    let text = copied(&mut harness, Key::C).expect("copied");
    assert!(
        text.starts_with("[[node.track]]\nchannel = \"position\""),
        "{text}"
    );
    assert!(text.contains("frames = [0.0, 20.0]"), "{text}");
    assert_eq!(scene(&harness), before);
    // At the playhead; the ruler may have the keyboard.
    harness.state_mut().scrub(31.0);
    focus_ruler(&mut harness);
    tap(&mut harness, Key::V, Modifiers::CTRL);
    paste(&mut harness, &text);
    let position = track_of(&harness, 1, &Channel::Position).unwrap();
    assert_eq!(position.frames(), [5.0, 20.0, 31.0, 40.0, 51.0, 60.0]);
    assert_eq!(position.values()[6..9], position.values()[3..6]);
    assert_eq!(position.values()[12..15], position.values()[9..12]);
    let intensity = track_of(&harness, 1, &Channel::Intensity).unwrap();
    assert_eq!(intensity.frames(), [10.0, 20.0, 31.0]);
    assert_eq!(harness.state().selected_keys().len(), 3);
    assert!(
        message(&harness).starts_with("Keys pasted at the playhead: 3"),
        "{}",
        message(&harness)
    );
    // One step; put in where keys lie, these come back with undo.
    tap(&mut harness, Key::Z, Modifiers::CTRL);
    assert_eq!(scene(&harness), before);
    assert!(!harness.state().document.can_undo());
    harness.state_mut().scrub(40.0);
    focus(&mut harness);
    paste(&mut harness, &text);
    let position = track_of(&harness, 1, &Channel::Position).unwrap();
    assert_eq!(position.frames(), [5.0, 20.0, 40.0, 60.0]);
    assert_eq!(
        position.values()[6..9],
        before.nodes()[1].keys().tracks()[0].values()[3..6]
    );
    tap(&mut harness, Key::Z, Modifiers::CTRL);
    assert_eq!(scene(&harness), before);
    // Another node gets tracks of its own, for what it has.
    let other = before.nodes().len() - 1;
    harness.state_mut().select_nodes(vec![other]);
    focus_ruler(&mut harness);
    paste(&mut harness, &text);
    let track = track_of(&harness, other, &Channel::Position);
    let track = track.unwrap_or_else(|| panic!("{}", message(&harness)));
    assert_eq!(track.frames(), [40.0, 60.0]);
    assert!(track_of(&harness, other, &Channel::Intensity).is_some());
    tap(&mut harness, Key::Z, Modifiers::CTRL);
    // The drone's path moves its position, and it has no intensity.
    harness.state_mut().select_nodes(vec![2]);
    focus(&mut harness);
    let before = scene(&harness);
    paste(&mut harness, &text);
    let texts = &Language::English.texts().timeline;
    assert_eq!(message(&harness), texts.fits_no_channel);
    assert_eq!(scene(&harness), before);
}

#[test]
fn keys_are_cut() {
    let mut harness = with_two_lamps();
    let before = scene(&harness);
    select(
        &mut harness,
        &[(Channel::Position, 0), (Channel::Position, 3)],
    );
    let text = copied(&mut harness, Key::X).expect("copied");
    let position = track_of(&harness, 1, &Channel::Position).unwrap();
    assert_eq!(position.frames(), [20.0, 40.0]);
    harness.state_mut().scrub(5.0);
    focus(&mut harness);
    paste(&mut harness, &text);
    assert_eq!(scene(&harness), before);
    tap(&mut harness, Key::Z, Modifiers::CTRL);
    tap(&mut harness, Key::Z, Modifiers::CTRL);
    assert_eq!(scene(&harness), before);
    assert!(!harness.state().document.can_undo());
}

/// Keys of several nodes go to as many, in their order.
#[test]
fn keys_of_several_nodes_go_to_as_many() {
    let mut harness = with_two_lamps();
    let other = scene(&harness).nodes().len() - 1;
    let new = track(
        Channel::Intensity,
        Interpolation::Linear,
        &[7.0, 9.0],
        &[0.1, 0.9],
    );
    let part = Part::track(other, Channel::Intensity, Some(new)).unwrap();
    let editor = harness.state_mut();
    editor.document.apply(Edit::Part(Box::new(part))).unwrap();
    editor.select_nodes(vec![other, 1]);
    let of = |node, key| KeyAt {
        node,
        channel: Channel::Intensity,
        key,
    };
    editor.select_keys(vec![of(other, 0), of(1, 0), of(1, 1)]);
    focus(&mut harness);
    let text = copied(&mut harness, Key::C).expect("copied");
    assert!(text.contains("[[node]]\nname = \"lamp\""), "{text}");
    harness.state_mut().scrub(30.0);
    focus(&mut harness);
    let before = scene(&harness);
    paste(&mut harness, &text);
    let frames = |node| {
        track_of(&harness, node, &Channel::Intensity)
            .unwrap()
            .frames()
            .to_vec()
    };
    assert_eq!(frames(1), [10.0, 20.0, 33.0, 43.0]);
    assert_eq!(frames(other), [7.0, 9.0, 30.0]);
    tap(&mut harness, Key::Z, Modifiers::CTRL);
    harness.state_mut().select_nodes(vec![1]);
    focus(&mut harness);
    paste(&mut harness, &text);
    let texts = &Language::English.texts().timeline;
    assert_eq!(message(&harness), fill(texts.as_many_nodes, &[&2, &1]));
    assert_eq!(scene(&harness), before);
}

/// Keys become those of the track that is there: tangents, tensions, angles and quaternions.
#[test]
fn keys_become_those_of_the_track_that_is_there() {
    use Interpolation::{EulerLinear, Hermite, Linear, Tcb};
    let half = std::f64::consts::FRAC_1_SQRT_2;
    let turn = [1.0, 0.0, 0.0, 0.0, half, 0.0, half, 0.0];
    let turned = [0.0, 0.0, 0.0, 90.0, 0.0, 0.0];
    let cases = [
        (
            Channel::Intensity,
            Linear,
            &[1.0, 2.0][..],
            Hermite,
            &[1.0, 2.0][..],
            vec![0.1; 4],
        ),
        (
            Channel::Intensity,
            Hermite,
            &[1.0, 2.0],
            Hermite,
            &[1.0, 2.0],
            vec![0.25; 4],
        ),
        (
            Channel::Intensity,
            Hermite,
            &[1.0, 2.0],
            Tcb,
            &[1.0, 2.0],
            vec![0.0; 6],
        ),
        (
            Channel::Intensity,
            Tcb,
            &[1.0, 2.0],
            Tcb,
            &[1.0, 2.0],
            vec![0.5; 6],
        ),
        (
            Channel::Rotation,
            Linear,
            &turn,
            EulerLinear,
            &turned,
            Vec::new(),
        ),
        (
            Channel::Rotation,
            EulerLinear,
            &turned,
            Linear,
            &turn,
            Vec::new(),
        ),
    ];
    for (channel, from, values, by, wanted, shape) in cases {
        let new = track(channel.clone(), from, &[0.0, 10.0], values);
        let width = wanted.len() / 2;
        let there = track(
            channel.clone(),
            by,
            &[100.0, 110.0],
            &[&turned[..], &turn].concat()[..2 * width],
        );
        let there = match (channel, width) {
            (Channel::Rotation, 4) => track(Channel::Rotation, Linear, &[100.0, 110.0], &turn),
            _ => there,
        };
        let keys = converted(&new, there.interpolation());
        let near = keys
            .values
            .iter()
            .zip(wanted)
            .all(|(a, b)| (a - b).abs() < 1e-9);
        assert!(near, "{keys:?}");
        assert_eq!(keys.shape.len(), shape.len(), "{keys:?}");
        let near = keys
            .shape
            .iter()
            .zip(&shape)
            .all(|(a, b)| (a - b).abs() < 1e-12);
        assert!(near, "{keys:?}");
    }
}

/// What is no keys, or broken ones, is told in one sentence, and nothing changes.
#[test]
fn a_text_that_is_no_keys_changes_nothing() {
    let mut harness = with_two_lamps();
    let before = scene(&harness);
    harness.state_mut().scrub(30.0);
    let good = "[[node.track]]\nchannel = \"intensity\"\ninterpolation = \"linear\"\nframes = [0.0]\nvalues = [1.0]\n";
    let texts = &Language::English.texts().timeline;
    for (text, told) in [
        ("", texts.no_keys),
        ("some words", texts.no_keys),
        ("[[point]]\nposition = [0.0, 0.0, 0.0]\n", texts.no_keys),
        ("# [[node.track]]\n", texts.no_keys),
        ("[[node.track]]\nchannel = \"intensity\"\n", "line 1"),
        (&good.replace("linear", "wobbly"), "line 3"),
        (&good.replace("intensity", "loudness"), "line 2"),
        (&good.replace("[1.0]", "[1.0, 2.0]"), "line 5"),
        (&good.replace("[1.0]", "[-1.0]"), "intensity"),
        (&good.replace("[0.0]", "[nan]"), "line 4"),
        (&good.replace("[0.0]", "[1e300]"), "intensity"),
        (&good.replace("frames", "faces"), "faces"),
        (&format!("{good}}}"), "line 6"),
        (
            &good.replace("[[node.track]]", "[[node.track]"),
            texts.no_keys,
        ),
        (
            &good.replace("intensity", "zoom").replace("1.0", "20.0"),
            texts.fits_no_channel,
        ),
    ] {
        focus(&mut harness);
        paste(&mut harness, text);
        let said = message(&harness);
        assert!(
            said.contains(told) && !said.contains('\n'),
            "{text}: {said}"
        );
        assert_eq!(scene(&harness), before, "{text}");
        assert!(!harness.state().document.can_undo(), "{text}");
    }
    focus(&mut harness);
    paste(&mut harness, good);
    assert!(harness.state().document.can_undo());
    // Beyond all frames.
    tap(&mut harness, Key::Z, Modifiers::CTRL);
    // Nothing is selected.
    harness.state_mut().select_keys(Vec::new());
    focus(&mut harness);
    assert_eq!(copied(&mut harness, Key::C), None);
    assert_eq!(message(&harness), texts.no_keys_selected);
}

/// Elsewhere the keys of the clipboard mean what they meant.
#[test]
fn without_the_keyboard_it_is_the_points_clipboard() {
    let mut harness = with_two_lamps();
    let position = (Channel::Position, 1);
    select(&mut harness, &[position]);
    harness.ctx.memory_mut(|memory| {
        let id = super::super::track_rows::id();
        memory.surrender_focus(id);
    });
    harness.state_mut().select_nodes(vec![0]);
    steps_on(&mut harness);
    let text = copied(&mut harness, Key::C);
    assert!(text.is_none_or(|text| !text.contains("[[node.track]]")));
    focus(&mut harness);
    harness.event(Event::Key {
        key: Key::V,
        physical_key: None,
        pressed: true,
        repeat: false,
        modifiers: Modifiers::CTRL,
    });
    harness.step();
    let asked = harness
        .output()
        .viewport_output
        .values()
        .any(|of| of.commands.contains(&ViewportCommand::RequestPaste));
    assert!(asked);
}
