//! What the menu of a track has for its selected keys: how their tangents go together, their
//! tension, continuity and bias.

use std::collections::BTreeSet;

use egui::{Button, Ui};
use vides_document::Edit;
use vides_engine::scene::Interpolation;

use super::graph_drag::joint_of;
use super::track_curve::Of;
use crate::action::Action;
use crate::entry::Entry;
use crate::number::Number;
use crate::playing::track_dots::{has_handles, parts_of};
use crate::state::Editor;
use crate::state::playing::track_graph::Memory;
use crate::state::space::Joint;

/// The width of the field of a number.
const FIELD: f32 = 96.0;

/// An entry of a menu, which closes it; a hint where there is one.
pub(super) fn entry(ui: &mut Ui, button: Button<'_>, hint: &str) -> bool {
    let mut response = ui.add(button);
    if !hint.is_empty() {
        response = response.on_hover_text(hint);
    }
    if response.clicked() {
        ui.close();
    }
    response.clicked()
}

/// Shows it for the selected keys of a track, if it has any.
pub(super) fn show(
    editor: &Editor,
    graph: &mut Memory,
    ui: &mut Ui,
    of: &Of<'_>,
    actions: &mut Vec<Action>,
) {
    let selected = editor.selected_keys().into_iter();
    let own = selected.filter(|at| of.has(at)).map(|at| at.key);
    let keys: Vec<usize> = own.collect::<BTreeSet<_>>().into_iter().collect();
    if keys.is_empty() {
        return;
    }
    match of.track.interpolation() {
        Interpolation::Tcb => shapes(editor, ui, (of, &keys), actions),
        Interpolation::Hermite if has_handles(of.track) => {
            ties(editor, graph, ui, (of, &keys), actions);
        }
        _ => return,
    }
    ui.separator();
}

/// The edit that gives keys of a track another shape: each by its place among them.
fn with_shape(of: &Of<'_>, keys: &[usize], change: impl Fn(usize, &mut [f64])) -> Option<Edit> {
    let mut put = of.track.keys(keys).ok()?;
    let width = put.shape.len() / keys.len();
    let all = put.shape.chunks_exact_mut(width).enumerate();
    all.for_each(|(at, shape)| change(at, shape));
    Some(of.replaced(keys.to_vec(), put))
}

/// Three numbers, those of the first key; what is entered is for all.
fn shapes(
    editor: &Editor,
    ui: &mut Ui,
    (of, keys): (&Of<'_>, &[usize]),
    actions: &mut Vec<Action>,
) {
    let texts = &editor.texts().curve;
    let now = &of.track.shape()[3 * keys[0]..][..3];
    let names = [texts.tension, texts.continuity, texts.bias];
    let hints = [texts.tension_hint, texts.continuity_hint, texts.bias_hint];
    for (at, (name, hint)) in names.into_iter().zip(hints).enumerate() {
        let id = format!("tcb.{}.{}.{at}", of.node, of.track.channel());
        let number = Number::new(name, now[at]).label(name).hint(hint);
        let number = number.range(-1.0..=1.0).decimals(2).steps(0.05, 0.01);
        let entry = number.show(ui, editor.language(), &id, FIELD + 60.0);
        let edit = |value| with_shape(of, keys, |_, shape| shape[at] = value);
        if entry != Entry::Idle {
            actions.push(Action::Enter(
                entry.try_map(|value| edit(value).ok_or_else(String::new)),
            ));
        }
    }
}

/// How the two tangents of the selected numbers go together.
fn ties(
    editor: &Editor,
    graph: &mut Memory,
    ui: &mut Ui,
    (of, keys): (&Of<'_>, &[usize]),
    actions: &mut Vec<Action>,
) {
    let track = of.track;
    let texts = (&editor.texts().position, &editor.texts().timeline);
    let width = track.width();
    let mut ties = Vec::new();
    for (at, &key) in keys.iter().enumerate() {
        let frame = track.frames()[key];
        let tangents = &track.shape()[2 * width * key..][..2 * width];
        for part in parts_of(&graph.parts, of, frame) {
            let id = of.part(frame, part);
            let by_form = joint_of(tangents[part], tangents[width + part]);
            let now = graph.joints.get(&id).copied().unwrap_or(by_form);
            ties.push((at, part, id, now));
        }
    }
    let Some(&(.., first)) = ties.first() else {
        return;
    };
    for each in Joint::ALL {
        let (words, hint) = match each {
            Joint::Smooth => (texts.0.smooth, texts.1.smooth_hint),
            Joint::Mirrored => (texts.0.mirrored, texts.1.mirrored_hint),
            Joint::Corner => (texts.0.corner, texts.1.corner_hint),
        };
        if !entry(ui, Button::selectable(each == first, words), hint) {
            continue;
        }
        let edit = with_shape(of, keys, |at, tangents| {
            let (before, after) = tangents.split_at_mut(width);
            for (_, part, ..) in ties.iter().filter(|of| of.0 == at) {
                let (before, after) = (&mut before[*part], &mut after[*part]);
                let slope = match each {
                    Joint::Smooth => f64::midpoint(*before, *after),
                    Joint::Mirrored => 0.5 * (*after - *before),
                    Joint::Corner => continue,
                };
                *after = slope;
                *before = if each == Joint::Smooth { slope } else { -slope };
            }
        });
        if each != Joint::Corner && ties.iter().any(|of| of.3 != each) {
            actions.extend(edit.map(|edit| Action::Edits(vec![edit])));
        }
        let chosen = ties.into_iter().map(|(_, _, id, _)| (id, each));
        graph.joints.extend(chosen);
        return;
    }
}
