//! Position and curve (thesis A.4.1): adding, removing and choosing points; the shape of the curve
//! at this point and the next.

use egui::{Button, Popup, RichText, Ui};
use glam::DVec3;

use super::curve::{self, in_place_of_tangents, without_shape, words_of};
use super::{PanelButton, button_row, heading_with_choice, pager, share, words};
use crate::action::Action;
use crate::document::{At, Edit};
use crate::limits::PRESETS;
use crate::number::Number;
use crate::path::{CurveKind, CurveParameters, Tcb};
use crate::playing::playhead::{Missing, Shown};
use crate::state::Editor;
use crate::texts::fill;
use crate::theme;

/// A lower window does not show the shape at the next point.
const MIN_HEIGHT_FOR_NEXT_SHAPE: f32 = 630.0;

pub(super) fn show(editor: &Editor, ui: &mut Ui, actions: &mut Vec<Action>) {
    let texts = &editor.texts().position;
    let selection = editor.document.selection();
    let count = editor.document.path().points.len();
    let Some(shown) = editor.shown() else {
        return;
    };
    presets(editor, ui, actions);
    button_row(
        editor,
        ui,
        &[
            PanelButton::new(texts.add, texts.add_hint, Action::AddPoint),
            PanelButton::new(texts.add_many, texts.add_many_hint, Action::AskPoints),
            PanelButton::new(texts.remove, texts.remove_hint, Action::RemovePoint),
        ],
        actions,
    );
    pager(
        editor,
        ui,
        [
            &PanelButton::new(texts.previous, texts.previous_hint, Action::PreviousPoint),
            &PanelButton::new(texts.next, texts.next_hint, Action::NextPoint),
        ],
        &Editor::number_of(texts.count, selection.point, count),
        actions,
    );
    coordinates(editor, ui, &shown, actions);
    if shown.missing == Missing::Nothing {
        shape(editor, ui, false, actions);
        if ui.ctx().content_rect().height() >= MIN_HEIGHT_FOR_NEXT_SHAPE {
            shape(editor, ui, true, actions);
        }
    } else {
        add_here(editor, ui, &shown, actions);
    }
    curve::show(editor, ui, actions);
}

/// The heading, with the choice of a preset for the current point at its right.
fn presets(editor: &Editor, ui: &mut Ui, actions: &mut Vec<Action>) {
    let texts = &editor.texts().position;
    let name = preset(editor);
    let [_, response] = heading_with_choice(ui, texts.heading, &name, texts.choice);
    let palette = theme::palette(ui);
    let now = editor.point().map(|point| point.curve);
    let without = without_shape(editor);
    Popup::menu(&response).show(|ui| {
        for preset in (0_u8..).take(PRESETS) {
            let chosen = now == Some(CurveParameters::Preset(preset)) && editor.joint().is_none();
            let tcb = editor.document.path().presets[usize::from(preset)];
            let shape = editor.texts().curve.shape(editor.language(), tcb);
            let shape = RichText::new(shape).color(if chosen {
                palette.on_accent
            } else {
                palette.weak
            });
            let button =
                Button::selectable(chosen, fill(texts.preset, &[&preset])).right_text(shape);
            let button = ui.add_enabled(without.is_none(), button);
            let button = button.on_disabled_hover_text(without.unwrap_or_default());
            if button.clicked() {
                let at = editor.document.selection().point;
                actions.push(Action::Edit(Edit::set(
                    At::Point(at),
                    "preset",
                    usize::from(preset),
                )));
            }
        }
    });
    response.on_hover_text(texts.choice_hint);
}

/// Where the current point's shape comes from.
fn preset(editor: &Editor) -> String {
    let texts = &editor.texts().position;
    if editor.joint().is_some() {
        return texts.tangents.to_owned();
    }
    match editor.document.path().curve {
        CurveKind::Tcb => {}
        kind => return words_of(editor, kind).0.to_owned(),
    }
    match editor.point().map(|point| point.curve) {
        Some(CurveParameters::Preset(preset)) => {
            let preset = usize::from(preset);
            let tcb = editor.document.path().presets[preset];
            editor.texts().curve.preset_name(preset, tcb)
        }
        Some(CurveParameters::Own(_)) => texts.own.to_owned(),
        None => String::new(),
    }
}

/// Between keys: makes one of what is shown.
fn add_here(editor: &Editor, ui: &mut Ui, shown: &Shown, actions: &mut Vec<Action>) {
    let texts = &editor.texts().position;
    let text = if shown.has_no_point() {
        texts.add_here
    } else {
        texts.add_orientation_here
    };
    let button = PanelButton::new(text, texts.add_here_hint, Action::AddHere);
    button_row(editor, ui, &[button], actions);
    let width = ui.available_width();
    words(ui, texts.in_between, width, theme::palette(ui).weak);
}

fn coordinates(editor: &Editor, ui: &mut Ui, shown: &Shown, actions: &mut Vec<Action>) {
    let texts = &editor.texts().position;
    let (at, position, missing) = (shown.at.point, shown.position, shown.has_no_point());
    three_numbers(
        editor,
        ui,
        ("position", texts.coordinate, texts.coordinate_hint),
        position,
        missing,
        |position| Ok(Edit::set(At::Point(at), "position", position)),
        actions,
    );
}

/// A place or a direction as three numbers, faint if `missing` in the path; `edit` sets them.
pub(super) fn three_numbers(
    editor: &Editor,
    ui: &mut Ui,
    (id, name, hint): (&str, &str, &str),
    vector: DVec3,
    missing: bool,
    edit: impl Fn(DVec3) -> Result<Edit, String>,
    actions: &mut Vec<Action>,
) {
    let space = editor.document.path().space;
    let third = share(ui, 3);
    // Side by side, unless the digits of such a space need more room.
    let beside = Number::room_in_space(ui, editor.language(), space) <= third;
    let width = if beside { third } else { ui.available_width() };
    let mut rows = |ui: &mut Ui| {
        for (axis, letter) in ["x", "y", "z"].into_iter().enumerate() {
            let entry = Number::new(&fill(name, &[&letter]), vector[axis])
                .label(letter)
                .hint(hint)
                .faint(missing)
                .in_space(space)
                .show(ui, editor.language(), &format!("{id}.{letter}"), width);
            let entry = entry.try_map(|value| {
                let mut new = vector;
                new[axis] = value;
                edit(new)
            });
            actions.push(Action::enter(missing, entry));
        }
    };
    if beside {
        ui.horizontal(rows);
    } else {
        rows(ui);
    }
}

/// Tension, continuity and bias of the current point, or those of the `next` one to be read only.
fn shape(editor: &Editor, ui: &mut Ui, next: bool, actions: &mut Vec<Action>) {
    let texts = editor.texts();
    let path = editor.document.path();
    let at = editor.document.selection().point;
    let point = match next {
        false => Some(at),
        true if at + 1 < path.points.len() => Some(at + 1),
        true => path.closed.then_some(0),
    };
    let tcb = point.map(|point| path.tcb(point));
    let width = share(ui, 3);
    let language = editor.language();
    let without = without_shape(editor);
    let owns = point.filter(|_| !next);
    let owns = owns.and_then(|point| in_place_of_tangents(editor, point));
    let hint = if let Some(why) = without.or(owns) {
        why
    } else if next {
        texts.position.next_shape_hint
    } else {
        texts.position.shape_hint
    };
    type Part = fn(&mut Tcb) -> &mut f64;
    let parts: [(&str, &str, Part); 3] = [
        ("T", texts.curve.tension, |tcb| &mut tcb.tension),
        ("C", texts.curve.continuity, |tcb| &mut tcb.continuity),
        ("B", texts.curve.bias, |tcb| &mut tcb.bias),
    ];
    ui.horizontal(|ui| {
        for (letter, name, part) in parts {
            let value = tcb.map(|mut tcb| *part(&mut tcb));
            let label = if next {
                format!("{letter} \u{203a}")
            } else {
                letter.to_owned()
            };
            // As the thesis calls it, so that no other number has the same name.
            let name = format!("{name} ({}{})", letter.to_lowercase(), 1 + u8::from(next));
            let number = Number::new(&name, value)
                .label(&label)
                .hint(hint)
                .decimals(2)
                .range(-1.0..=1.0)
                .steps(0.01, 0.01)
                .fixed_if(next || without.is_some());
            let entry = number.show(ui, language, &format!("shape {label}"), width);
            if let Some(tcb) = tcb.filter(|_| !next) {
                let edit = |value| {
                    let mut tcb = tcb;
                    *part(&mut tcb) = value;
                    Edit::set(At::Point(at), "own", tcb)
                };
                actions.push(Action::Enter(entry.map(edit)));
            }
        }
    });
}
