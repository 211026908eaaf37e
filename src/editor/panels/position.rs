//! Position and curve (thesis A.4.1): points come, go and become current; the
//! shape of the curve at this point and the next is shown.

use glam::DVec3;

use super::{Key, heading, keys, round, share};
use crate::document::Edit;
use crate::editor::actions::Action;
use crate::editor::number::{Entry, Number};
use crate::editor::state::Editor;
use crate::editor::texts::fill;
use crate::limits::MAX_COORDINATE;
use crate::path::CurveParameters;

pub(super) fn show(editor: &mut Editor, ui: &mut egui::Ui) {
    let texts = &editor.texts().position;
    let selection = editor.document.selection();
    let count = editor.document.path().points.len();
    heading(ui, texts.heading, &preset(editor));
    keys(
        editor,
        ui,
        &[
            Key::new(texts.add, texts.add_hint, Action::AddPoint),
            Key::new(texts.add_many, texts.add_many_hint, Action::AskPoints),
            Key::new(texts.remove, texts.remove_hint, Action::RemovePoint),
        ],
    );
    round(
        editor,
        ui,
        &Key::new(texts.previous, texts.previous_hint, Action::PreviousPoint),
        &Editor::number_of(texts.count, selection.point, count),
        &Key::new(texts.next, texts.next_hint, Action::NextPoint),
    );
    coordinates(editor, ui);
    shape(editor, ui, 1);
    shape(editor, ui, 2);
    let change = Key::new(texts.change, texts.change_hint, Action::Curve);
    keys(editor, ui, &[change]);
}

/// Where the current point takes its shape from.
fn preset(editor: &Editor) -> String {
    let texts = &editor.texts().position;
    match editor.point().map(|point| point.curve) {
        Some(CurveParameters::Preset(preset)) => fill(texts.preset, &[&preset]),
        Some(CurveParameters::Own(_)) => texts.own.to_owned(),
        None => String::new(),
    }
}

fn coordinates(editor: &mut Editor, ui: &mut egui::Ui) {
    let texts = &editor.texts().position;
    let at = editor.document.selection().point;
    let Some(position) = editor.point().map(|point| point.position) else {
        return;
    };
    three_numbers(
        editor,
        ui,
        ("position", texts.coordinate, texts.coordinate_hint),
        position,
        |editor, entry, put| {
            editor.enter(entry, |value| Edit::SetPosition {
                at,
                position: put(value),
            })
        },
    );
}

/// A place or a direction: three numbers. `id`, `name` and `hint` are theirs;
/// `enter` gets what was done to one of them, and the vector with a new value
/// in its place.
pub(super) fn three_numbers(
    editor: &mut Editor,
    ui: &mut egui::Ui,
    (id, name, hint): (&str, &str, &str),
    vector: DVec3,
    enter: impl Fn(&mut Editor, Entry, &dyn Fn(f64) -> DVec3),
) {
    let width = share(ui, 3);
    ui.horizontal(|ui| {
        for (axis, letter) in ["x", "y", "z"].into_iter().enumerate() {
            let entry = Number::new(&fill(name, &[&letter]), vector[axis])
                .label(letter)
                .hint(hint)
                .range(-MAX_COORDINATE..=MAX_COORDINATE)
                .show(ui, editor.language(), &format!("{id}.{letter}"), width);
            enter(editor, entry, &|value| {
                let mut new = vector;
                new[axis] = value;
                new
            });
        }
    });
}

/// Bias, continuity and tension at the current point (1) or the next (2);
/// dashes where there is no next.
fn shape(editor: &mut Editor, ui: &mut egui::Ui, which: usize) {
    let hint = editor.texts().position.shape_hint;
    let path = editor.document.path();
    let at = editor.document.selection().point;
    let point = match which {
        1 => Some(at),
        _ if at + 1 < path.points.len() => Some(at + 1),
        _ => path.closed.then_some(0),
    };
    let tcb = point.map(|point| path.tcb(point));
    let width = share(ui, 3);
    let language = editor.language();
    ui.horizontal(|ui| {
        for (name, value) in [
            ("b", tcb.map(|tcb| tcb.bias)),
            ("c", tcb.map(|tcb| tcb.continuity)),
            ("t", tcb.map(|tcb| tcb.tension)),
        ] {
            let name = format!("{name}{which}");
            Number::new(&name, value)
                .label(&name)
                .hint(hint)
                .decimals(2)
                .fixed()
                .show(ui, language, &name, width);
        }
    });
}
