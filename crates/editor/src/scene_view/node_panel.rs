//! The panels of a node: what it is in and looks at, where it is, what its kind has, what moves it.

use egui::{Button, Popup, Role, ScrollArea, Ui, WidgetInfo, vec2};
use glam::DVec3;
use vides_document::Edit;
use vides_engine::scene::{Channel, Node, Part, Rest};
use vides_engine::shared_list::SharedList;

use super::keys_panel::{AXES, Shown, Words, channel, diamond, indent};
use super::{kind_panel, list_row, motion_panel, object_panel, panel};
use crate::action::Action;
use crate::entry::Entry;
use crate::number::Number;
use crate::panels::parts::{Heading, PanelButton, apart, button_row, share};
use crate::setup::Fold;
use crate::state::Editor;
use crate::state::scene_view::{NodeAction, NodeCommand};
use crate::texts::fill;
use crate::{panels, theme};

/// A long list of nodes scrolls from here on.
const MENU: f32 = 320.0;

/// Room in the first heading for the kind, and for the triangle.
const ROOM: f32 = 90.0;

/// One panel.
type Panel = dyn Fn(&Editor, &mut Ui, Shown<'_>, &mut Vec<Action>);

/// Shows at the right the points of the edited path, or the current node of a scene, which is chosen
/// where there are both.
pub(crate) fn beside(editor: &mut Editor, ui: &mut Ui) {
    let context = ui.ctx().clone();
    let edits_path = editor.document.edits_path();
    if editor.current_node().is_none() {
        if edits_path {
            panels::show(editor, ui);
        } else {
            editor.part(&context, |editor, actions| {
                panel::no_path(editor, ui, actions);
            });
        }
        return;
    }
    if edits_path {
        editor.part(&context, |editor, actions| tabs(editor, ui, actions));
        ui.add_space(theme::GAP);
    }
    if edits_path && !editor.scene_view.shows_node {
        panels::show(editor, ui);
    } else {
        show(editor, ui);
    }
}

fn tabs(editor: &Editor, ui: &mut Ui, actions: &mut Vec<Action>) {
    let texts = &editor.texts().node;
    let node = editor.scene_view.shows_node;
    let tab = |text, hint, shown: bool| {
        let action = Action::Node(NodeAction::ShowNode(shown));
        PanelButton::new(text, hint, action).chosen(shown == node)
    };
    let both = [
        tab(texts.points_tab, texts.points_tab_hint, false),
        tab(texts.node_tab, texts.node_tab_hint, true),
    ];
    button_row(editor, ui, &both, actions);
}

fn show(editor: &mut Editor, ui: &mut Ui) {
    let context = ui.ctx().clone();
    let parts: [&Panel; 6] = [
        &links,
        &place,
        &kind_panel::show,
        &object_panel::deformations,
        &object_panel::shapes,
        &motion_panel::show,
    ];
    ScrollArea::vertical().id_salt("node").show(ui, |ui| {
        ui.set_width(panels::parts::WIDTH);
        for part in parts {
            // What one has changed the next one sees.
            editor.part(&context, |editor, actions| {
                if let Some(at) = editor.current_node()
                    && let Ok(node) = editor.node_of_scene(at)
                {
                    part(editor, ui, Shown { at, node }, actions);
                }
            });
        }
    });
}

/// What the node is, what it is in, what it looks at.
fn links(editor: &Editor, ui: &mut Ui, of: Shown<'_>, actions: &mut Vec<Action>) {
    let texts = &editor.texts().node;
    let heading = Heading {
        editor,
        fold: Fold::Node,
        text: &shortened(ui, &of.node.name),
        remark: list_row::kind(editor, of.node),
    };
    let (open, row) = heading.show(ui, actions);
    row.on_hover_text(&of.node.name);
    if !open {
        return;
    }
    let selected = editor.selected_nodes().len();
    if selected > 1 {
        ui.colored_label(theme::palette(ui).weak, fill(texts.first_of, &[&selected]));
    }
    let words = (texts.parent_name, texts.parent, texts.no_parent);
    if let Some(parent) = node_menu(editor, ui, of.at, words, of.node.parent, texts.parent_hint) {
        let command = NodeCommand::PutInto(vec![of.at], parent);
        actions.push(Action::Nodes(command));
    }
    if of.node.kind.looks() {
        let words = (texts.aim_name, texts.aim, texts.no_aim);
        if let Some(aim) = node_menu(editor, ui, of.at, words, of.node.aim, texts.aim_hint) {
            let part = Part::Links {
                node: of.at,
                parent: of.node.parent,
                aim,
            };
            actions.push(Action::Edits(vec![Edit::Part(Box::new(part))]));
        }
        if of.node.aim.is_some() {
            let words = Words::new(texts.aim_weight, texts.aim_weight_hint);
            channel(editor, ui, of, &Channel::AimWeight, words, actions);
        }
    }
    visible(editor, ui, of, actions);
}

fn visible(editor: &Editor, ui: &mut Ui, of: Shown<'_>, actions: &mut Vec<Action>) {
    let texts = &editor.texts().node;
    let Some(value) = editor.channel_value(of.at, &Channel::Visible) else {
        return;
    };
    ui.horizontal(|ui| {
        actions.extend(diamond(editor, ui, of, &Channel::Visible, texts.visible));
        let mut seen = value != [0.0];
        let tick = theme::tick(ui, &mut seen, texts.visible);
        if tick.on_hover_text(texts.visible_hint).changed() {
            let value = vec![f64::from(u8::from(seen))];
            let action = NodeAction::Value(of.at, Channel::Visible, Entry::Set(value));
            actions.push(Action::Node(action));
        }
    });
}

/// Where it is in its parent.
fn place(editor: &Editor, ui: &mut Ui, of: Shown<'_>, actions: &mut Vec<Action>) {
    let texts = &editor.texts().node;
    apart(ui);
    let heading = Heading {
        editor,
        fold: Fold::Place,
        text: texts.place,
        remark: "",
    };
    if !heading.show(ui, actions).0 {
        return;
    }
    let position = Words::new(texts.position, texts.position_hint).of(&AXES);
    channel(editor, ui, of, &Channel::Position, position, actions);
    let parts = [(texts.yaw, ""), (texts.pitch, ""), (texts.roll, "")];
    let rotation = Words::new(texts.rotation, texts.rotation_hint).of(&parts);
    channel(editor, ui, of, &Channel::Rotation, rotation, actions);
    let scale = Words::new(texts.scale, texts.scale_hint).of(&AXES);
    channel(editor, ui, of, &Channel::Scale, scale, actions);
    if !of.node.kind.looks() {
        pivot(editor, ui, of, actions);
    }
}

fn pivot(editor: &Editor, ui: &mut Ui, of: Shown<'_>, actions: &mut Vec<Action>) {
    let texts = &editor.texts().node;
    ui.horizontal(|ui| {
        indent(ui);
        ui.colored_label(theme::palette(ui).weak, texts.pivot);
    });
    ui.horizontal(|ui| {
        let width = share(ui, 3);
        for (axis, (letter, _)) in AXES.into_iter().enumerate() {
            let name = format!("{} {letter}", texts.pivot);
            let entry = Number::new(&name, of.node.pivot[axis])
                .label(letter)
                .hint(texts.pivot_hint)
                .in_space(editor.shown_space())
                .show(
                    ui,
                    editor.language(),
                    &format!("{}.pivot.{axis}", of.at),
                    width,
                );
            let mut pivot: DVec3 = of.node.pivot;
            enter_rest(of, entry, actions, |rest, value| {
                pivot[axis] = value;
                rest.pivot = pivot;
            });
        }
    });
}

/// An entry into what a node has at rest and no key changes.
pub(super) fn enter_rest(
    of: Shown<'_>,
    entry: Entry,
    actions: &mut Vec<Action>,
    change: impl FnOnce(&mut Rest, f64),
) {
    if entry == Entry::Idle {
        return;
    }
    let entry = entry.map(|value| {
        let mut rest = Rest::of(of.node);
        change(&mut rest, value);
        rest_edit(of, rest)
    });
    actions.push(Action::Node(NodeAction::Enter(Box::new(entry))));
}

pub(super) fn rest_edit(of: Shown<'_>, rest: Rest) -> Edit {
    let (node, rest) = (of.at, Box::new(rest));
    Edit::Part(Box::new(Part::Rest { node, rest }))
}

/// A menu of all other nodes, or none; what was chosen. `words`: its name, the text for the
/// choice, and the text for none.
fn node_menu(
    editor: &Editor,
    ui: &mut Ui,
    own: usize,
    (name, text, none): (&str, &str, &str),
    now: Option<usize>,
    hint: &str,
) -> Option<Option<usize>> {
    let nodes: &SharedList<Node> = editor.document.edited_scene()?.scene().nodes();
    let called = |at: Option<usize>| at.map_or(none, |at| nodes[at].name.as_str());
    let button = Button::new(fill(text, &[&called(now)])).truncate();
    let size = vec2(ui.available_width(), theme::ROW);
    let response = ui.add_sized(size, button);
    response.widget_info(|| WidgetInfo {
        current_text_value: Some(called(now).to_owned()),
        ..WidgetInfo::labeled(Role::ComboBox, true, name)
    });
    let mut chosen = None;
    Popup::menu(&response)
        .width(panels::parts::WIDTH)
        .show(|ui| {
            ui.spacing_mut().item_spacing.y = 0.0;
            let area = ScrollArea::vertical().max_height(MENU);
            // None, and all but itself and what is in it.
            let others = (0..nodes.len())
                .filter(|&at| !is_in(nodes, at, own))
                .map(Some);
            let all: Vec<_> = std::iter::once(None).chain(others).collect();
            area.show_rows(ui, theme::ROW, all.len(), |ui, rows| {
                for &at in &all[rows] {
                    let entry = Button::selectable(at == now, called(at)).truncate();
                    let entry = entry.min_size(vec2(ui.available_width(), theme::ROW));
                    if ui.add(entry).clicked() && at != now {
                        chosen = Some(at);
                    }
                }
            });
        });
    response.on_hover_text(hint);
    chosen
}

/// Whether a node is another one, or in it.
fn is_in(nodes: &SharedList<Node>, at: usize, other: usize) -> bool {
    let mut above = std::iter::successors(Some(at), |&at| nodes[at].parent);
    above.any(|at| at == other)
}

/// A name that leaves room for what stands at the right of a heading.
fn shortened(ui: &Ui, name: &str) -> String {
    let wide = |text: &str| {
        let galley =
            ui.painter()
                .layout_no_wrap(text.to_owned(), theme::heading(), theme::palette(ui).text);
        galley.size().x
    };
    let room = ui.available_width() - ROOM;
    if wide(name) <= room {
        return name.to_owned();
    }
    let mut text = name.to_owned();
    while text.pop().is_some() && wide(&format!("{text}…")) > room {}
    format!("{text}…")
}

#[cfg(test)]
#[path = "node_tests.rs"]
mod tests;
