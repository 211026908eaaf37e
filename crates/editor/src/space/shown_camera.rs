//! The heading of the camera's picture as a list, where a scene has several cameras: which one is
//! shown.

use egui::{
    Button, CursorIcon, Label, Popup, Response, ScrollArea, Sense, Shape, Stroke, Ui, vec2,
};
use vides_document::Edit;
use vides_engine::scene::{Kind, Node, Part};

use crate::action::Action;
use crate::state::Editor;
use crate::theme;

/// Room behind the heading for its arrow, with which it is a list.
pub(super) const ARROW: f32 = 12.0;

/// A long list scrolls from here on.
const MENU: f32 = 320.0;

/// The cameras of a scene.
pub(super) fn all(editor: &Editor) -> Vec<usize> {
    let edited = editor.document.edited_scene();
    let nodes = edited.into_iter().flat_map(|edited| edited.scene().nodes());
    let of_camera = |(_, node): &(usize, &Node)| matches!(node.kind, Kind::Camera(_));
    let all = nodes.enumerate().filter(of_camera);
    all.map(|(at, _)| at).collect()
}

/// Shows the heading with the list that a click opens.
pub(super) fn choice(
    editor: &Editor,
    ui: &mut Ui,
    (heading, words): (Label, &str),
    cameras: &[usize],
    actions: &mut Vec<Action>,
) -> Response {
    let heading = ui.add(heading.sense(Sense::click()));
    let Some(edited) = editor.document.edited_scene() else {
        return heading;
    };
    let scene = edited.scene();
    let (texts, shown) = (&editor.texts().scene, scene.shown_camera());
    let name = |at: usize| scene.nodes()[at].name.as_str();
    heading.widget_info(|| egui::WidgetInfo {
        current_text_value: Some(words.to_owned()),
        ..egui::WidgetInfo::labeled(egui::Role::ComboBox, true, texts.shown_camera)
    });
    let palette = theme::palette(ui);
    let colour = match heading.hovered() || heading.has_focus() {
        true => palette.text,
        false => palette.weak,
    };
    let at = |x: f32, y: f32| heading.rect.right_center() + vec2(7.0 + x, 1.0 + y);
    let arrow = vec![at(-3.0, -2.0), at(0.0, 1.0), at(3.0, -2.0)];
    ui.painter()
        .add(Shape::line(arrow, Stroke::new(1.3, colour)));
    if heading.hovered() {
        ui.set_cursor_icon(CursorIcon::PointingHand);
    }
    Popup::menu(&heading).show(|ui| {
        ScrollArea::vertical().max_height(MENU).show(ui, |ui| {
            for &at in cameras {
                let entry = Button::selectable(Some(at) == shown, name(at));
                if ui.add(entry).clicked() && Some(at) != shown {
                    let part = Part::Camera(Some(at));
                    actions.push(Action::Edits(vec![Edit::Part(Box::new(part))]));
                }
            }
        });
    });
    heading.on_hover_text(texts.shown_camera_hint)
}

#[cfg(test)]
#[path = "shown_camera_tests.rs"]
mod tests;
