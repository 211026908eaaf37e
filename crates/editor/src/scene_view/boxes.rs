//! The box of a deformation that was chosen: its numbers in the panel, and its cage in the space.

use egui::{Ui, vec2};
use glam::{DAffine3, DVec3};
use vides_document::Edit;
use vides_document::tool::Cage;
use vides_engine::deform::{Bounds, Deformation};
use vides_engine::scene::{Channel, Kind, Object, Part};

use super::keys_panel::{AXES, Shown, indent};
use crate::action::Action;
use crate::entry::Entry;
use crate::number::Number;
use crate::panels::parts::share;
use crate::state::Editor;
use crate::state::scene_view::NodeAction;
use crate::texts::fill;
use crate::texts::refusals::reason_of;
use crate::theme;

/// The box of an object's deformation: its own, else that of the mesh at rest.
fn bounds_of(object: &Object, at: usize) -> Option<Bounds> {
    let (_, bounds) = object.deformations().get(at)?;
    Some(bounds.unwrap_or_else(|| Bounds::of(&object.mesh().points)))
}

/// The rows of a deformation's box: its lowest and its highest corner, and how it goes back to that
/// of the mesh. `name`: that of the deformation.
pub(super) fn rows(
    editor: &Editor,
    ui: &mut Ui,
    (of, object): (Shown<'_>, &Object),
    (at, name): (usize, &str),
    actions: &mut Vec<Action>,
) {
    let texts = &editor.texts().node;
    let Some(bounds) = bounds_of(object, at) else {
        return;
    };
    let (deformation, own) = &object.deformations()[at];
    let edit = |bounds: Option<Bounds>| {
        let part = Part::Deformation {
            node: of.at,
            at,
            deformation: deformation.clone(),
            bounds,
        };
        Edit::Part(Box::new(part))
    };
    let corners = [
        (texts.box_low, bounds.min()),
        (texts.box_high, bounds.max()),
    ];
    for (end, (words, corner)) in corners.into_iter().enumerate() {
        ui.horizontal(|ui| {
            indent(ui);
            ui.colored_label(theme::palette(ui).weak, words);
        });
        ui.horizontal(|ui| {
            let width = share(ui, 3);
            for (axis, (letter, _)) in AXES.into_iter().enumerate() {
                let label = format!("{name}: {words} {letter}");
                let id = format!("{}.box.{at}.{end}.{axis}", of.at);
                let entry = Number::new(&label, corner[axis])
                    .label(letter)
                    .hint(texts.box_hint)
                    .in_space(editor.shown_space())
                    .show(ui, editor.language(), &id, width);
                if entry == Entry::Idle {
                    continue;
                }
                let entry = entry.try_map(|value| {
                    let mut both = [bounds.min(), bounds.max()];
                    both[end][axis] = value;
                    let new = Bounds::new(both[0], both[1]);
                    new.map(|new| edit(Some(new)))
                        .map_err(|error| reason_of(editor.language(), &error.into()))
                });
                actions.push(Action::Node(NodeAction::Enter(Box::new(entry))));
            }
        });
    }
    let size = vec2(ui.available_width(), theme::ROW);
    let button = egui::Button::new(texts.box_of_mesh);
    let button = ui
        .add_enabled_ui(own.is_some(), |ui| ui.add_sized(size, button))
        .inner;
    let text = fill(texts.box_of_mesh_of, &[&name]);
    button.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, own.is_some(), &text));
    if button.on_hover_text(texts.box_of_mesh_hint).clicked() {
        actions.push(Action::Edits(vec![edit(None)]));
    }
}

impl Editor {
    /// The deformation whose box is shown, if it is one of the current node.
    pub(crate) fn chosen_deformation(&self) -> Option<(usize, usize)> {
        let chosen = self.scene_view.deformation?;
        (self.current_node() == Some(chosen.0)).then_some(chosen)
    }

    /// The cage of the deformation that was chosen, as it is at the playhead, and from its
    /// coordinates into those of the space.
    pub(crate) fn chosen_cage(&self) -> Option<(Cage, DAffine3)> {
        let (node, at) = self.chosen_deformation()?;
        let Kind::Object(object) = &self.node_of_scene(node).ok()?.kind else {
            return None;
        };
        let bounds = bounds_of(object, at)?;
        let mut now: Deformation = object.deformations()[at].0.clone();
        for (parameter, _) in object.deformations()[at].0.channels() {
            let parameter = parameter.to_owned();
            let channel = Channel::Deformation { at, parameter };
            let value = self.channel_value(node, &channel)?;
            let Channel::Deformation { parameter, .. } = channel else {
                continue;
            };
            if let Some(numbers) = now.channel_mut(&parameter)
                && numbers.len() == value.len()
            {
                numbers.copy_from_slice(&value);
            }
        }
        let into = self.with_scene(|now| now.into_path * now.states[node].world());
        Some((Cage::new(bounds, &now), into.ok()??))
    }

    /// The same in the space: its lines and control points.
    pub(crate) fn cage_in_space(&self) -> Option<Cage> {
        let (mut cage, into) = self.chosen_cage()?;
        let place = |place: &mut DVec3| *place = into.transform_point3(*place);
        cage.lines.iter_mut().flatten().for_each(place);
        cage.nodes.iter_mut().for_each(place);
        Some(cage)
    }
}

#[cfg(test)]
#[path = "boxes_tests.rs"]
mod tests;
