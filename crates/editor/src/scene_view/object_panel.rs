//! The panels of an object's deformations and of its shapes.

use egui::{Button, Popup, Role, Ui, WidgetInfo, vec2};
use glam::DVec3;
use vides_document::Edit;
use vides_engine::deform::{Deformation, identity_lattice};
use vides_engine::scene::{Channel, Kind, Object, Part};

use super::keys_panel::{Shown, Sign, Words, channel, heading, sign};
use crate::action::Action;
use crate::entry::Entry;
use crate::number::Number;
use crate::panels::parts::{Heading, PanelButton, apart, button_row};
use crate::setup::Fold;
use crate::state::Editor;
use crate::state::files::Purpose;
use crate::state::scene_view::NodeAction;
use crate::texts::fill;
use crate::theme;

const fn object<'a>(of: Shown<'a>) -> Option<&'a Object> {
    match &of.node.kind {
        Kind::Object(object) => Some(object),
        _ => None,
    }
}

fn edit(part: Part) -> Action {
    Action::Edits(vec![Edit::Part(Box::new(part))])
}

pub(super) fn deformations(editor: &Editor, ui: &mut Ui, of: Shown<'_>, actions: &mut Vec<Action>) {
    let Some(object) = object(of) else {
        return;
    };
    let texts = &editor.texts().node;
    let all = object.deformations();
    apart(ui);
    let count = match all.len() {
        0 => String::new(),
        count => count.to_string(),
    };
    let title = Heading {
        editor,
        fold: Fold::Deformations,
        text: texts.deformations,
        remark: &count,
    };
    if !title.show(ui, actions).0 {
        return;
    }
    for at in 0..all.len() {
        deformation(editor, ui, of, object, at, actions);
    }
    add(editor, ui, of, all.len(), actions);
}

/// What a deformation is called.
fn called(editor: &Editor, deformation: &Deformation) -> &'static str {
    let bulges = deformation.channel("a").is_some();
    match bulges {
        true => editor.texts().node.bulge,
        false => editor.language().tool(deformation.kind()),
    }
}

fn deformation(
    editor: &Editor,
    ui: &mut Ui,
    of: Shown<'_>,
    object: &Object,
    at: usize,
    actions: &mut Vec<Action>,
) {
    let (texts, node) = (&editor.texts().node, of.at);
    let all = object.deformations();
    let (this, bounds) = &all[at];
    let name = format!("{}. {}", at + 1, called(editor, this));
    ui.horizontal(|ui| {
        let signs = 3.0 * (super::keys_panel::DIAMOND + theme::GAP);
        let room = ui.available_width() - signs;
        ui.scope(|ui| {
            ui.set_width(room);
            ui.horizontal(|ui| {
                let node = of.at;
                let chosen = editor.chosen_deformation() == Some((node, at));
                let button = ui.selectable_label(chosen, &name);
                if button.on_hover_text(texts.choose_box_hint).clicked() {
                    let shown = (!chosen).then_some((node, at));
                    actions.push(Action::Node(NodeAction::ShowBox(shown)));
                }
                if let Some(turned) = axis(editor, ui, this, &name) {
                    actions.push(edit(Part::Deformation {
                        node,
                        at,
                        deformation: turned,
                        bounds: *bounds,
                    }));
                }
            });
        });
        let text = fill(texts.earlier, &[&name]);
        if sign(ui, Sign::Up, &text, at > 0) {
            swap(editor, (node, at, at - 1), actions);
        }
        let text = fill(texts.later, &[&name]);
        if sign(ui, Sign::Down, &text, at + 1 < all.len()) {
            swap(editor, (node, at, at + 1), actions);
        }
        let text = fill(texts.remove_deformation, &[&name]);
        if sign(ui, Sign::Remove, &text, true) {
            actions.push(edit(Part::RemoveDeformation { node, at }));
            actions.push(Action::Node(NodeAction::ShowBox(None)));
        }
    });
    for (parameter, width) in this.channels() {
        let of_parameter = Channel::Deformation {
            at,
            parameter: parameter.to_owned(),
        };
        let words = Words::new(texts.parameter(parameter), texts.parameter_hint);
        match width {
            1 => channel(editor, ui, of, &of_parameter, words, actions),
            _ => actions.extend(heading(editor, ui, of, &of_parameter, words)),
        }
    }
    if editor.chosen_deformation() == Some((node, at)) {
        super::boxes::rows(editor, ui, (of, object), (at, &name), actions);
    }
}

/// Swaps a deformation with its neighbour; the box that is shown moves with it.
fn swap(editor: &Editor, (node, from, to): (usize, usize, usize), actions: &mut Vec<Action>) {
    actions.push(edit(Part::MoveDeformation { node, from, to }));
    let shown = match editor.chosen_deformation() {
        Some((_, at)) if at == from => to,
        Some((_, at)) if at == to => from,
        _ => return,
    };
    actions.push(Action::Node(NodeAction::ShowBox(Some((node, shown)))));
}

/// A button with the axis, which chooses the next one.
fn axis(editor: &Editor, ui: &mut Ui, this: &Deformation, name: &str) -> Option<Deformation> {
    let numbers: usize = this.channels().map(|(_, width)| width).sum();
    let axes = this.parameters().len() - numbers;
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    let first = *this.parameters()[..axes].first()? as usize;
    let texts = &editor.texts().node;
    let letter = ["x", "y", "z"][first % 3];
    let button = ui.add(Button::new(letter).min_size(vec2(theme::ROW, theme::ROW)));
    let label = fill(texts.axis, &[&name]);
    button.widget_info(|| WidgetInfo {
        current_text_value: Some(letter.to_owned()),
        ..WidgetInfo::labeled(Role::Button, true, &label)
    });
    let hint = match this.kind() {
        "bend" => texts.bend_axis_hint,
        _ => texts.axis_hint,
    };
    if !button.on_hover_text(hint).clicked() {
        return None;
    }
    let mut parameters = this.parameters().to_vec();
    for axis in &mut parameters[..axes] {
        *axis = (*axis + 1.0) % 3.0;
    }
    Deformation::new(this.kind(), &parameters).ok()
}

/// A deformation along the longest side of the object: what bends does so about another one.
fn along_longest(of: Shown<'_>, kind: &str, parameters: &[f64]) -> Option<Deformation> {
    let points = &object(of)?.mesh().points;
    let ends = |pick: fn(DVec3, DVec3) -> DVec3| points.iter().copied().reduce(pick);
    let size = (ends(DVec3::max)? - ends(DVec3::min)?).to_array();
    // Along y, where none is longer.
    let longest = [0, 2].into_iter().filter(|&at| size[at] > size[1]);
    let longest = longest.max_by(|&a, &b| size[a].total_cmp(&size[b]));
    let longest = longest.unwrap_or(1);
    let axis = match kind {
        "bend" => (longest + 2) % 3,
        "free-form" => return None,
        _ => longest,
    };
    let mut parameters = parameters.to_vec();
    parameters[0] = axis as f64;
    Deformation::new(kind, &parameters).ok()
}

/// The menu of the kinds; each begins with numbers that change nothing.
fn add(editor: &Editor, ui: &mut Ui, of: Shown<'_>, at: usize, actions: &mut Vec<Action>) {
    let texts = &editor.texts().node;
    let size = vec2(ui.available_width(), theme::ROW);
    let button = ui.add_sized(size, Button::new(texts.add_deformation));
    Popup::menu(&button).show(|ui| {
        let lattice = identity_lattice();
        let kinds: [(&str, &[f64]); 5] = [
            ("twist", &[1.0, 0.0]),
            ("bend", &[1.0, 0.0]),
            ("taper", &[1.0, 1.0, 1.0]),
            ("taper", &[1.0, 1.0]),
            ("free-form", &lattice),
        ];
        for (kind, parameters) in kinds {
            let Ok(new) = Deformation::new(kind, parameters) else {
                continue;
            };
            if ui.button(called(editor, &new)).clicked() {
                let new = along_longest(of, kind, parameters).unwrap_or(new);
                actions.push(edit(Part::InsertDeformation {
                    node: of.at,
                    at,
                    deformation: new,
                    bounds: None,
                }));
                let shown = Some((of.at, at));
                actions.push(Action::Node(NodeAction::ShowBox(shown)));
            }
        }
    });
    button.on_hover_text(texts.add_deformation_hint);
}

pub(super) fn shapes(editor: &Editor, ui: &mut Ui, of: Shown<'_>, actions: &mut Vec<Action>) {
    let Some(object) = object(of) else {
        return;
    };
    let texts = &editor.texts().node;
    apart(ui);
    let count = match object.shapes().len() {
        0 => String::new(),
        count => count.to_string(),
    };
    let title = Heading {
        editor,
        fold: Fold::Shapes,
        text: texts.shapes,
        remark: &count,
    };
    if !title.show(ui, actions).0 {
        return;
    }
    if !object.shapes().is_empty() {
        weights(editor, ui, of, object, actions);
    }
    let ask = Action::Node(NodeAction::AskFile(Purpose::LoadShape(of.at)));
    let button = PanelButton::new(texts.add_shape, texts.add_shape_hint, ask);
    button_row(editor, ui, &[button], actions);
}

/// One diamond for all weights, which are one track.
fn weights(
    editor: &Editor,
    ui: &mut Ui,
    of: Shown<'_>,
    object: &Object,
    actions: &mut Vec<Action>,
) {
    let texts = &editor.texts().node;
    let words = Words::new(texts.weights, texts.weight_hint);
    actions.extend(heading(editor, ui, of, &Channel::Weights, words));
    let Some(now) = editor.channel_value(of.at, &Channel::Weights) else {
        return;
    };
    for (at, (shape, &weight)) in object.shapes().iter().zip(&now).enumerate() {
        ui.horizontal(|ui| {
            let width = ui.available_width() - super::keys_panel::DIAMOND - theme::GAP;
            let name = fill(texts.weight, &[&shape.name]);
            let id = format!("{}.weight.{at}", of.at);
            let label = cut(&shape.name);
            let entry = Number::new(&name, weight)
                .label(&label)
                .hint(texts.weight_hint)
                .show(ui, editor.language(), &id, width);
            if entry != Entry::Idle {
                let entry = entry.map(|weight| {
                    let mut new = now.clone();
                    new[at] = weight;
                    new
                });
                let action = NodeAction::Value(of.at, Channel::Weights, entry);
                actions.push(Action::Node(action));
            }
            let text = fill(texts.remove_shape, &[&shape.name]);
            if sign(ui, Sign::Remove, &text, true) {
                let node = of.at;
                actions.push(edit(Part::RemoveShape { node, at }));
            }
        });
    }
}

/// A name that leaves room for its number.
fn cut(name: &str) -> String {
    const MOST: usize = 16;
    match name.char_indices().nth(MOST) {
        Some((end, _)) => format!("{}…", &name[..end]),
        None => name.to_owned(),
    }
}
