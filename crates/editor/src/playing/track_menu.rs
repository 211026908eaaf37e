//! The menu of a row of the timeline: a track's interpolation, and how it continues before and
//! after its keys, or a node's path.

use egui::{Button, Popup, PopupCloseBehavior, Response, RichText, Ui};
use vides_document::Edit;
use vides_document::error::Result;
use vides_engine::math::euler::EulerAngles;
use vides_engine::scene::{
    Channel, Extrapolation, Interpolation, KeyList, Manner, Part, Track, Warnings, host,
};

use super::key_menu::{self, entry};
use super::track_curve::Of;
use crate::action::Action;
use crate::playing::track_rows::{bar_of, channel_name};
use crate::state::Editor;
use crate::state::playing::track_graph;
use crate::state::playing::tracks::Row;
use crate::texts::refusals::of_edit;
use crate::texts::{Texts, fill};

pub(super) fn show(
    editor: &Editor,
    graph: &mut track_graph::Memory,
    response: &Response,
    row: Row,
    actions: &mut Vec<Action>,
) {
    let menu = Popup::context_menu(response);
    // Numbers are dragged in it.
    let menu = menu.close_behavior(PopupCloseBehavior::CloseOnClickOutside);
    menu.show(|ui| {
        let Some(edited) = editor.document.edited_scene() else {
            return;
        };
        let Some(node) = row.node(edited) else {
            return;
        };
        let texts = &editor.texts().timeline;
        if let Some(of) = row.of(edited) {
            let track = of.track;
            let channel = channel_name(editor, track.channel());
            ui.label(RichText::new(fill(texts.channel_of, &[&channel, &node.name])).weak());
            key_menu::show(editor, graph, ui, &of, actions);
            of_track(editor, ui, &of, actions);
            if *track.channel() == Channel::Rotation {
                ui.separator();
                let texts = &editor.texts().compare;
                let button = ui.button(texts.menu).on_hover_text(texts.menu_hint);
                if button.clicked() {
                    actions.push(Action::SelectNodes(vec![row.node]));
                    actions.push(Action::CompareRotations);
                }
            }
            return;
        }
        ui.label(RichText::new(node.name.as_str()).weak());
        if let Some((path, (start_frame, _))) = node.path().zip(bar_of(editor, edited, row.node)) {
            ui.label(texts.beyond);
            let edit = |beyond| {
                let node = row.node;
                Ok(part(Part::Start {
                    node,
                    start_frame,
                    beyond,
                }))
            };
            let three = &BEYOND[..3];
            beyond(editor, ui, (path.extrapolation(), three), edit, actions);
        }
    });
}

const BEYOND: [Extrapolation; 4] = [
    Extrapolation::Hold,
    Extrapolation::Repeat,
    Extrapolation::PingPong,
    Extrapolation::Offset,
];

fn part(part: Part) -> Edit {
    Edit::Part(Box::new(part))
}

/// Applies an edit, or reports why it failed.
fn push(editor: &Editor, edit: Result<Edit>, actions: &mut Vec<Action>) {
    actions.push(match edit {
        Ok(edit) => Action::Edits(vec![edit]),
        Err(error) => Action::Complain(of_edit(editor.language(), &error)),
    });
}

/// What may come beyond the ends, and what does.
fn beyond(
    editor: &Editor,
    ui: &mut Ui,
    (now, all): (Extrapolation, &[Extrapolation]),
    edit: impl Fn(Extrapolation) -> Result<Edit>,
    actions: &mut Vec<Action>,
) {
    let texts = &editor.texts().timeline;
    for &each in all {
        let words = match each {
            Extrapolation::Hold => texts.holds,
            Extrapolation::Repeat => texts.repeats,
            Extrapolation::PingPong => texts.back_and_forth,
            Extrapolation::Offset => texts.goes_on,
        };
        if entry(ui, Button::selectable(each == now, words), "") && each != now {
            push(editor, edit(each), actions);
        }
    }
}

fn of_track(editor: &Editor, ui: &mut Ui, of: &Of<'_>, actions: &mut Vec<Action>) {
    let track = of.track;
    let texts = &editor.texts().timeline;
    let now = track.interpolation();
    for each in interpolations(track) {
        let words = interpolation_name(editor.texts(), &each);
        let button = Button::selectable(each == *now, words);
        if entry(ui, button, texts.manner_hint) && each != *now {
            let lost = by_angles(now) && !by_angles(&each) && turns(track);
            push(editor, with(of, each), actions);
            if lost {
                actions.push(Action::Complain(texts.turns_lost.to_owned()));
            }
        }
    }
    ui.separator();
    let (before, after) = track.extrapolation();
    let count = match track.channel() {
        // It is on or off: nothing is added to it.
        Channel::Visible => 3,
        _ => 4,
    };
    let changed = |change: &dyn Fn(&mut Manner)| {
        let mut manner = track.manner();
        change(&mut manner);
        manner_of(of, manner)
    };
    ui.menu_button(texts.before, |ui| {
        let edit = |to| Ok(changed(&|manner| manner.before = to));
        beyond(editor, ui, (before, &BEYOND[..count]), edit, actions);
    });
    ui.menu_button(texts.after, |ui| {
        let edit = |to| Ok(changed(&|manner| manner.after = to));
        beyond(editor, ui, (after, &BEYOND[..count]), edit, actions);
    });
}

/// Whether a node turns by more than a half between two keys of its angles.
fn turns(track: &Track) -> bool {
    let values: Vec<_> = track.values().chunks_exact(3).collect();
    let far = |(from, to): (&f64, &f64)| (to - from).abs() > 180.0;
    values
        .windows(2)
        .any(|two| two[0].iter().zip(two[1]).any(far))
}

/// The ways from key to key that a track may have, those of the program around at the end.
fn interpolations(track: &Track) -> Vec<Interpolation> {
    let mut all = Vec::new();
    for name in Interpolation::names(Some(track.channel())) {
        match Interpolation::parse(name) {
            Ok(Interpolation::Host(_)) => {
                all.extend(host::names().into_iter().map(Interpolation::Host));
            }
            Ok(plain) => all.push(plain),
            Err(_) => {}
        }
    }
    // One that is not registered any more.
    if !all.contains(track.interpolation()) {
        all.push(track.interpolation().clone());
    }
    all
}

fn manner_of(of: &Of<'_>, manner: Manner) -> Edit {
    part(Part::Manner {
        node: of.node,
        channel: of.track.channel().clone(),
        manner: Box::new(manner),
    })
}

fn interpolation_name(texts: &Texts, interpolation: &Interpolation) -> String {
    let texts = &texts.timeline;
    let words = match interpolation {
        Interpolation::Step => texts.step,
        Interpolation::Linear => texts.linear,
        Interpolation::Ramp => texts.ramp,
        Interpolation::Sine => texts.sine,
        Interpolation::Parabolic => texts.parabolic,
        Interpolation::CatmullRom => texts.catmull_rom,
        Interpolation::Hermite => texts.hermite,
        Interpolation::Tcb => texts.tcb,
        Interpolation::Cubic => texts.cubic,
        Interpolation::EulerLinear => texts.euler_linear,
        Interpolation::EulerCatmullRom => texts.euler_catmull_rom,
        Interpolation::Host(name) => return format!("host:{name}"),
    };
    words.to_owned()
}

fn by_angles(interpolation: &Interpolation) -> bool {
    matches!(
        interpolation,
        Interpolation::EulerLinear | Interpolation::EulerCatmullRom
    )
}

/// The edit that lets a track go from key to key in another way. Frames and values stay; angles
/// become quaternions, and these angles.
fn with(of: &Of<'_>, interpolation: Interpolation) -> Result<Edit> {
    let (node, track) = (of.node, of.track);
    if by_angles(track.interpolation()) == by_angles(&interpolation) {
        let mut manner = track.manner();
        manner.shape = converted(track, &interpolation).shape;
        manner.interpolation = interpolation;
        return Ok(manner_of(of, manner));
    }
    let new = rotation_by(track, interpolation)?;
    Ok(part(Part::track(node, track.channel().clone(), Some(new))?))
}

/// The keys of a track as one has them that goes from key to key in this way.
pub(super) fn converted(track: &Track, to: &Interpolation) -> KeyList {
    let frames = track.frames().to_vec();
    let values = match (by_angles(track.interpolation()), by_angles(to)) {
        (true, false) => quaternions(track),
        (false, true) => angles(track),
        _ => track.values().to_vec(),
    };
    let shape = match to {
        _ if to == track.interpolation() => track.shape().to_vec(),
        Interpolation::Hermite => smooth(&frames, &values, values.len() / frames.len()),
        Interpolation::Tcb => vec![0.0; 3 * frames.len()],
        _ => Vec::new(),
    };
    KeyList {
        frames,
        values,
        shape,
    }
}

/// A track that goes on as another beyond its ends, of these keys.
pub(super) fn of_keys(track: &Track, by: Interpolation, keys: KeyList) -> Result<Track> {
    let (before, after) = track.extrapolation();
    let channel = track.channel().clone();
    let new = Track::new(channel, by, keys.frames, keys.values, keys.shape)?;
    Ok(new.with_extrapolation(before, after)?)
}

/// The keys of a rotation gone through in another way.
pub(crate) fn rotation_by(track: &Track, interpolation: Interpolation) -> Result<Track> {
    let keys = converted(track, &interpolation);
    of_keys(track, interpolation, keys)
}

/// The quaternions at the keys of angles.
fn quaternions(track: &Track) -> Vec<f64> {
    let warnings = &mut Warnings::default();
    let frames = track.frames().iter();
    let turns = frames.map(|&frame| track.rotation(frame, warnings));
    turns
        .flat_map(|turn| [turn.w, turn.x, turn.y, turn.z])
        .collect()
}

/// Yaw, pitch and roll in degrees at the keys, each as near as can be to the one before.
fn angles(track: &Track) -> Vec<f64> {
    let warnings = &mut Warnings::default();
    let mut all: Vec<f64> = Vec::new();
    for &frame in track.frames() {
        let angles = EulerAngles::from_quaternion(track.rotation(frame, warnings));
        for angle in [angles.yaw, angles.pitch, angles.roll] {
            let mut angle = angle.to_degrees();
            if let Some(before) = all.len().checked_sub(3) {
                angle += 360.0 * ((all[before] - angle) / 360.0).round();
            }
            all.push(angle);
        }
    }
    all
}

/// Tangents of a smooth way through keys: those of Catmull and Rom, with quadratic ends.
fn smooth(frames: &[f64], values: &[f64], width: usize) -> Vec<f64> {
    let last = frames.len() - 1;
    let step = |k: usize| frames[k + 1] - frames[k];
    let mean = |k: usize, i: usize| (values[(k + 1) * width + i] - values[k * width + i]) / step(k);
    let inner = |k: usize, i: usize| {
        let (before, after) = (step(k - 1), step(k));
        (after * mean(k - 1, i) + before * mean(k, i)) / (before + after)
    };
    let mut shape = Vec::with_capacity(2 * values.len());
    for k in 0..=last {
        let slope = |i: usize| match k {
            _ if last == 0 => 0.0,
            _ if last == 1 => mean(0, i),
            0 => 2.0 * mean(0, i) - inner(1, i),
            k if k == last => 2.0 * mean(k - 1, i) - inner(k - 1, i),
            k => inner(k, i),
        };
        for _ in 0..2 {
            shape.extend((0..width).map(slope));
        }
    }
    shape
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rotations by angles and by quaternions are the same at their keys.
    #[test]
    fn angles_become_quaternions_and_come_back() {
        let turns = [
            [30.0, 20.0, 10.0],
            [170.0, -40.0, 5.0],
            [200.0, 60.0, -90.0],
        ];
        let track = Track::new(
            Channel::Rotation,
            Interpolation::EulerLinear,
            vec![1.0, 10.0, 20.0],
            turns.concat(),
            Vec::new(),
        );
        let track = track.unwrap();
        let by_quaternions = Track::new(
            Channel::Rotation,
            Interpolation::Linear,
            track.frames().to_vec(),
            quaternions(&track),
            Vec::new(),
        );
        let back = angles(&by_quaternions.unwrap());
        for (found, wanted) in back.iter().zip(turns.concat()) {
            assert!((found - wanted).abs() < 1e-9, "{back:?}");
        }
    }

    /// The tangents that a track gets are those of the same curve where it is smooth already.
    #[test]
    fn tangents_are_those_of_catmull_and_rom() {
        let frames = vec![0.0, 3.0, 10.0, 11.0];
        let values = vec![1.0, 4.0, -2.0, 0.5];
        let of = |by, shape| Track::new(Channel::Roll, by, frames.clone(), values.clone(), shape);
        let known = of(Interpolation::CatmullRom, Vec::new()).unwrap();
        let shape = smooth(&frames, &values, 1);
        let hermite = of(Interpolation::Hermite, shape).unwrap();
        for step in 0..=110_u8 {
            let at = f64::from(step) * 0.1;
            let value = |track: &Track| {
                let mut out = [0.0];
                track.numbers(at, &mut out, &mut Default::default());
                out[0]
            };
            assert!((value(&known) - value(&hermite)).abs() < 1e-12, "{at}");
        }
    }
}
