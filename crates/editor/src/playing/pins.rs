//! Points of paths that are pinned to markers: the entry of a point's menu, and what joins both on
//! the timeline.

use egui::{Button, Painter, Pos2, Rangef, Shape, Stroke, Ui, pos2};
use vides_document::{Edit, EditedScene};
use vides_engine::scene::Part;

use super::axis::Axis;
use super::key_menu::entry;
use crate::action::Action;
use crate::state::Editor;
use crate::theme;

/// The entry by which a point of the edited path is pinned to a marker, or free again.
pub(crate) fn menu(editor: &Editor, ui: &mut Ui, point: usize, actions: &mut Vec<Action>) {
    let Some((edited, node)) = editor
        .document
        .edited_scene()
        .and_then(|edited| Some((edited, edited.node()?)))
    else {
        return;
    };
    let texts = &editor.texts().timeline;
    let markers = edited.scene().markers();
    if markers.is_empty() {
        let entry = ui.add_enabled(false, Button::new(texts.pin_to));
        entry.on_disabled_hover_text(texts.no_markers);
        return;
    }
    let now = edited.pinned().find(|pin| pin.0 == point).map(|pin| pin.1);
    ui.menu_button(texts.pin_to, |ui| {
        let none = (None, texts.no_marker.to_owned());
        let all = markers.iter().map(|marker| {
            let name = marker.name.clone();
            (Some(name.clone()), name)
        });
        for (marker, words) in std::iter::once(none).chain(all) {
            let button = Button::selectable(marker == now, words);
            if entry(ui, button, texts.pin_hint) && marker != now {
                let part = Part::Pin {
                    node,
                    point,
                    marker,
                };
                actions.push(Action::Edits(vec![Edit::Part(Box::new(part))]));
            }
        }
    });
}

/// Joins the pinned points of the edited path with their markers above.
/// The axis of the scene and that of the path.
pub(super) fn of_keys(
    editor: &Editor,
    painter: &Painter,
    (of_scene, axis): (&Axis, &Axis),
    rows: Rangef,
) {
    let Some(edited) = editor.document.edited_scene() else {
        return;
    };
    for (point, marker) in edited.pinned() {
        let mut keys = editor.playing.marks.keys.iter();
        let key = keys.find(|mark| mark.point == point);
        let frame = edited.scene().marker(&marker);
        if let Some((key, frame)) = key.zip(frame) {
            let from = pos2(of_scene.place(frame), rows.min);
            join(painter, [from, pos2(axis.x_of(key.first()), rows.center())]);
        }
    }
}

/// Joins the bar of a path with the markers to which its points are pinned.
pub(super) fn of_bar(
    edited: &EditedScene,
    painter: &Painter,
    axis: &Axis,
    (node, top, rows): (usize, f32, Rangef),
) {
    let of_scene = edited.scene().pins().iter();
    let of_scene = of_scene.filter(|pin| pin.node == node && edited.node() != Some(node));
    let own = edited.pinned().filter(|_| edited.node() == Some(node));
    let all = of_scene.map(|pin| pin.marker.clone());
    for marker in all.chain(own.map(|pin| pin.1)) {
        if let Some(frame) = edited.scene().marker(&marker) {
            let x = axis.place(frame);
            if axis.sees(x) {
                join(painter, [pos2(x, top), pos2(x, rows.center())]);
            }
        }
    }
}

fn join(painter: &Painter, ends: [Pos2; 2]) {
    let palette = theme::palette_of(&painter.ctx().global_style().visuals);
    let line = Stroke::new(1.5, palette.text);
    painter.extend(Shape::dashed_line(&ends, line, 3.0, 2.0));
    painter.circle_filled(ends[1], 2.5, palette.text);
}

#[cfg(test)]
#[path = "pins_tests.rs"]
mod tests;
