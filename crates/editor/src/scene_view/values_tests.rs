use vides_document::Document;

use super::*;
use crate::state::Editor;
use crate::tests::{Language, options};

/// An editor of a scene with one group "thing" and a light "lamp", the first selected.
fn editor(tracks: Vec<Track>) -> Editor {
    let mut scene = Scene::new();
    scene.add(Node::new("thing", Kind::Group)).unwrap();
    scene
        .add(Node::new("lamp", Kind::Light(Default::default())))
        .unwrap();
    for track in tracks {
        scene.set_track(0, track).unwrap();
    }
    scene.set_range(Some((1.0, 101.0))).unwrap();
    let mut document = Document::new();
    document.apply(Edit::ReplaceScene(Box::new(scene))).unwrap();
    let options = crate::Options {
        document: document.as_opened(),
        ..options(Language::English)
    };
    let mut editor = Editor::new(options).unwrap();
    editor.select_nodes(vec![0]);
    editor
}

fn thing(editor: &Editor) -> &Node {
    &editor.document.edited_scene().unwrap().scene().nodes()[0]
}

fn hermite(channel: Channel, values: &[f64], slopes: &[f64]) -> Track {
    let frames = vec![11.0, 31.5, 61.0];
    let by = Interpolation::Hermite;
    Track::new(channel, by, frames, values.to_vec(), slopes.to_vec()).unwrap()
}

/// Numbers that are not round, from a seed.
fn some(count: usize, seed: u64) -> Vec<f64> {
    let mut state = seed;
    let mut next = || {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1);
        (state >> 33) as f64 / 2_f64.powi(30) - 1.0
    };
    (0..count).map(|_| next()).collect()
}

/// Two hundred frames before, between and behind the keys.
fn frames() -> impl Iterator<Item = f64> {
    (0..200).map(|at| -10.0 + 0.4567 * f64::from(at))
}

/// A new key of `hermite` takes the tangents of the curve: what the engine makes of the track is the
/// same at all frames, also beyond an end that holds.
#[test]
fn a_new_key_leaves_the_curve_of_hermite_as_it_is() {
    let wide = [(Channel::Position, 3), (Channel::Rotation, 4)];
    for (channel, width) in wide {
        for at in [5.0, 12.0, 31.0, 32.0, 47.0, 60.0, 77.0] {
            let values = some(3 * width, 7);
            let track = hermite(channel.clone(), &values, &some(6 * width, 8));
            let mut editor = editor(vec![track.clone()]);
            editor.set_frame(at).unwrap();
            assert_eq!(editor.key_state(0, &channel), KeyState::NotHere);
            editor.switch_key(0, &channel);
            assert_eq!(editor.key_state(0, &channel), KeyState::Here);
            let new = thing(&editor).keys().track(&channel).unwrap().clone();
            assert_eq!(new.frames().len(), 4, "{at}");
            // And so it is where the value that is there is set.
            assert!(editor.document.undo());
            let value = editor.channel_value(0, &channel).unwrap();
            assert!(editor.set_channel(0, &channel, &value));
            let set = thing(&editor).keys().track(&channel).unwrap();
            let warnings = &mut Warnings::default();
            for frame in frames() {
                for made in [&new, set] {
                    let off = if width == 4 {
                        let [a, b] = [&track, made].map(|of| {
                            DVec4::from_array(wxyz(of.rotation(frame, &mut Warnings::default())))
                        });
                        (a - b).abs().max_element()
                    } else {
                        let [mut a, mut b] = [[0.0; 3]; 2];
                        track.numbers(frame, &mut a, warnings);
                        made.numbers(frame, &mut b, warnings);
                        (0..3).map(|k| (a[k] - b[k]).abs()).fold(0.0, f64::max)
                    };
                    assert!(off < 1e-12, "{channel}, key {at}, frame {frame}: {off}");
                }
            }
        }
    }
}

/// The same for a thousand random tracks: any number of keys at any frames, any width, any ends that
/// do not repeat where the key is.
#[test]
fn a_new_key_leaves_random_curves_of_hermite_as_they_are() {
    let wind = Channel::parse("value:wind:2").unwrap();
    let channels = [(Channel::Position, 3), (Channel::Scale, 3), (wind, 2)];
    for round in 0..1000_u64 {
        let (channel, width) = channels[(round % 3) as usize].clone();
        let mut frames = some(2 + (round % 7) as usize, 3 * round + 1);
        frames
            .iter_mut()
            .for_each(|frame| *frame = 50.0 + 45.0 * *frame);
        frames.sort_by(f64::total_cmp);
        frames.dedup_by(|a, b| *a - *b < 0.5);
        let (keys, size) = (frames.len(), 10_f64.powi((round % 5) as i32 - 2));
        let numbers = |count, seed| {
            let all = some(count, seed).into_iter();
            all.map(|number| size * number).collect::<Vec<f64>>()
        };
        let values = numbers(keys * width, 5 * round + 2);
        let slopes = numbers(2 * keys * width, 7 * round + 3);
        let by = Interpolation::Hermite;
        let (first, last) = (frames[0], frames[keys - 1]);
        let track = Track::new(channel.clone(), by, frames, values, slopes).unwrap();
        let mut editor = editor(vec![track.clone()]);
        let at = (first + (last - first) * (0.5 + 0.6 * some(1, 11 * round)[0])).round();
        editor.set_frame(at.clamp(1.0, 101.0)).unwrap();
        if editor.key_state(0, &channel) == KeyState::Here {
            continue;
        }
        editor.switch_key(0, &channel);
        let new = thing(&editor).keys().track(&channel).unwrap().clone();
        assert!(new.frames().len() > keys);
        let warnings = &mut Warnings::default();
        let most = track
            .values()
            .iter()
            .fold(0.0_f64, |most, value| most.max(value.abs()));
        for frame in frames_all() {
            let [mut a, mut b] = [vec![0.0; width], vec![0.0; width]];
            track.numbers(frame, &mut a, warnings);
            new.numbers(frame, &mut b, warnings);
            // Of what is large rounding alone is more.
            let reach = a
                .iter()
                .fold(most.max(1.0), |most, value| most.max(value.abs()));
            for (a, b) in a.iter().zip(&b) {
                assert!(
                    (a - b).abs() <= 1e-12 * reach,
                    "{track:?}, key {at}: {frame}"
                );
            }
        }
    }
}

fn frames_all() -> impl Iterator<Item = f64> {
    (0..200).map(|at| -5.0 + 0.5567 * f64::from(at))
}

/// Without a track it is the value at rest; with one a key, at a whole frame.
#[test]
fn a_changed_value_is_a_key_where_there_is_a_track_and_else_at_rest() {
    let mut editor = editor(Vec::new());
    assert_eq!(editor.key_state(0, &Channel::Position), KeyState::NoTrack);
    editor.set_frame(20.0).unwrap();
    assert!(editor.set_channel(0, &Channel::Position, &[1.0, 2.0, 3.0]));
    assert_eq!(thing(&editor).rest.position.to_array(), [1.0, 2.0, 3.0]);
    assert!(thing(&editor).keys().tracks().is_empty());
    // The diamond makes a track of one key with the value that is there.
    editor.switch_key(0, &Channel::Position);
    let track = thing(&editor).keys().track(&Channel::Position).unwrap();
    assert_eq!(
        (track.frames(), track.values()),
        (&[20.0][..], &[1.0, 2.0, 3.0][..])
    );
    editor.set_frame(30.4).unwrap();
    assert!(editor.set_channel(0, &Channel::Position, &[4.0, 2.0, 3.0]));
    let track = thing(&editor).keys().track(&Channel::Position).unwrap();
    assert_eq!(track.frames(), [20.0, 30.0]);
    assert_eq!(thing(&editor).rest.position.to_array(), [1.0, 2.0, 3.0]);
    // A key that is there gets the value, none comes.
    assert!(editor.set_channel(0, &Channel::Position, &[5.0, 2.0, 3.0]));
    let track = thing(&editor).keys().track(&Channel::Position).unwrap();
    assert_eq!(track.frames(), [20.0, 30.0]);
    assert_eq!(track.values()[3], 5.0);
    // The last key that goes leaves its value at rest.
    editor.set_frame(20.0).unwrap();
    editor.switch_key(0, &Channel::Position);
    editor.set_frame(30.0).unwrap();
    assert_eq!(editor.key_state(0, &Channel::Position), KeyState::Here);
    editor.switch_key(0, &Channel::Position);
    assert!(thing(&editor).keys().tracks().is_empty());
    assert_eq!(thing(&editor).rest.position.to_array(), [5.0, 2.0, 3.0]);
    let mut steps = 0;
    while editor.document.undo() {
        steps += 1;
    }
    assert_eq!(steps, 6);
    assert_eq!(thing(&editor).rest.position.to_array(), [0.0; 3]);
}

/// Rotations are taken as quaternions or as angles, whatever the keys have.
#[test]
fn a_rotation_is_written_as_its_keys_have_it() {
    let mut editor = editor(Vec::new());
    assert!(editor.set_channel(0, &Channel::Rotation, &[30.0, 20.0, 10.0]));
    let there = thing(&editor).rest.rotation;
    let glam = DQuat::from_euler(
        glam::EulerRot::YXZ,
        30_f64.to_radians(),
        20_f64.to_radians(),
        10_f64.to_radians(),
    );
    assert!(there.dot(glam).abs() > 1.0 - 1e-15);
    // More than one turn stays so.
    let wheel = Track::new(
        Channel::Rotation,
        Interpolation::EulerLinear,
        vec![1.0, 101.0],
        vec![0.0, 0.0, 0.0, 0.0, 1440.0, 0.0],
        Vec::new(),
    );
    let mut editor = self::editor(vec![wheel.unwrap()]);
    editor.set_frame(51.0).unwrap();
    let value = editor.channel_value(0, &Channel::Rotation).unwrap();
    assert_eq!(value, [0.0, 720.0, 0.0]);
    assert!(editor.set_channel(0, &Channel::Rotation, &[0.0, 725.0, 0.0]));
    let track = thing(&editor).keys().track(&Channel::Rotation).unwrap();
    assert_eq!(track.values()[3..6], [0.0, 725.0, 0.0]);
    // As many turns as were there.
    let turned = wxyz(DQuat::from_rotation_x(30_f64.to_radians()));
    assert!(editor.set_channel(0, &Channel::Rotation, &turned));
    let track = thing(&editor).keys().track(&Channel::Rotation).unwrap();
    let angles = &track.values()[3..6];
    assert!((angles[1] - 750.0).abs() < 1e-9, "{angles:?}");
}

/// K, on all selected nodes, is one step, and leaves keys that are there.
#[test]
fn keys_for_the_place_are_set_in_one_step() {
    let mut editor = editor(Vec::new());
    editor.select_nodes(vec![0, 1]);
    editor.set_frame(7.0).unwrap();
    editor.switch_key(0, &Channel::Scale);
    editor.set_keys();
    for node in editor.document.edited_scene().unwrap().scene().nodes() {
        for channel in PLACE {
            assert_eq!(node.keys().track(&channel).unwrap().frames(), [7.0]);
        }
    }
    let revision = editor.document.revision();
    editor.set_keys();
    assert_eq!(editor.document.revision(), revision);
    assert!(editor.document.undo());
    let tracks = thing(&editor).keys().tracks().len();
    assert_eq!(tracks, 1);
}

/// What a value cannot be is a sentence, and nothing changes.
#[test]
fn what_cannot_be_set_is_told() {
    let mut editor = editor(Vec::new());
    let value = |name: &str| Channel::Value {
        name: name.to_owned(),
        width: 1,
    };
    let bend = Channel::Deformation {
        at: 0,
        parameter: "angle".to_owned(),
    };
    let before = editor.document.revision();
    for (node, channel, numbers) in [
        (0, Channel::Zoom, &[30.0][..]),
        (0, Channel::Position, &[1.0][..]),
        (0, Channel::Position, &[f64::NAN, 0.0, 0.0][..]),
        (0, Channel::Rotation, &[0.0; 4][..]),
        (0, value("radius"), &[1.0][..]),
        (0, bend, &[1.0][..]),
        (1, Channel::Cone, &[40.0, 30.0][..]),
        (1, Channel::Intensity, &[-1.0][..]),
        (9, Channel::Scale, &[1.0; 3][..]),
    ] {
        editor.message = None;
        assert!(!editor.set_channel(node, &channel, numbers), "{channel}");
        assert!(editor.message.take().unwrap().error, "{channel}");
    }
    editor.switch_key(0, &value("radius"));
    assert!(editor.message.take().unwrap().error);
    assert_eq!(editor.document.revision(), before);
}
