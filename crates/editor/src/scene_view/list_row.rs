//! A row of the list of nodes: its ground, name, kind and eye.

use egui::{
    Align2, Color32, CornerRadius, Painter, Pos2, Rect, Response, Role, Sense, Shape, Stroke, Ui,
    WidgetInfo, pos2, vec2,
};
use vides_engine::scene::{Channel, Kind, Node, Scene};

use super::list::id;
use super::rows::Row;
use crate::action::Action;
use crate::entry::Entry;
use crate::state::Editor;
use crate::state::scene_view::NodeAction;
use crate::texts::fill;
use crate::theme;

/// Room for the eye.
pub(super) const EYE: f32 = 22.0;

/// What all rows need.
pub(super) struct Shown<'a> {
    pub(super) editor: &'a Editor,
    pub(super) scene: &'a Scene,
    pub(super) current: Option<usize>,
    /// In rising order.
    pub(super) selected: Vec<usize>,
}

/// The ground of a row: of the current one, of a selected one, of what the pointer is over.
fn ground(ui: &Ui, rect: Rect, [current, selected]: [bool; 2], hovered: bool) {
    let palette = theme::palette(ui);
    let ground = if current {
        Some(palette.accent)
    } else if selected {
        Some(palette.pressed)
    } else {
        hovered.then_some(palette.button)
    };
    if let Some(ground) = ground {
        let place = rect.shrink2(vec2(0.0, 1.0));
        let corners = CornerRadius::same(3);
        ui.painter().rect_filled(place, corners, ground);
    }
}

/// The colour of a row's icons over its background.
pub(super) fn sign_color(of: &Shown<'_>, ui: &Ui, node: usize, hovered: bool) -> Color32 {
    let palette = theme::palette(ui);
    if of.current == Some(node) {
        palette.on_accent
    } else if hovered || of.selected.binary_search(&node).is_ok() {
        palette.text
    } else {
        palette.weak
    }
}

/// A row's ground, its name and its kind within `room`.
pub(super) fn paint(of: &Shown<'_>, ui: &Ui, room: Rect, row: Row, response: &Response) {
    let palette = theme::palette(ui);
    let node = &of.scene.nodes()[row.node];
    let current = of.current == Some(row.node);
    let selected = of.selected.binary_search(&row.node).is_ok();
    ground(ui, response.rect, [current, selected], response.hovered());
    let color = if current {
        palette.on_accent
    } else {
        palette.text
    };
    let weak = sign_color(of, ui, row.node, false);
    let painter = ui.painter();
    let kind = kind(of.editor, node);
    let right = room.right_center() - vec2(2.0, 0.0);
    let kind = painter.text(right, Align2::RIGHT_CENTER, kind, theme::small(), weak);
    let width = kind.left() - room.left() - 6.0;
    let name = node.name.clone();
    let mut job = egui::text::LayoutJob::simple_singleline(name, theme::text(), color);
    job.wrap = egui::text::TextWrapping::truncate_at_width(width.max(0.0));
    let galley = painter.layout_job(job);
    let at = Align2::LEFT_CENTER.anchor_size(room.left_center(), galley.size());
    painter.galley(at.min, galley, color);
}

/// The eye at the end of a row, which hides a node or shows it.
pub(super) fn show_eye(of: &Shown<'_>, ui: &Ui, rect: Rect, at: usize, actions: &mut Vec<Action>) {
    let node = &of.scene.nodes()[at];
    let visible = of.editor.channel_value(at, &Channel::Visible) != Some(vec![0.0]);
    let texts = &of.editor.texts().scene;
    let name = if visible { texts.hide } else { texts.show };
    let name = fill(name, &[&node.name]);
    let response = ui.interact(rect, id().with(at).with("eye"), Sense::click());
    response.widget_info(|| WidgetInfo::selected(Role::Button, true, visible, &name));
    let color = sign_color(of, ui, at, response.hovered());
    paint_eye(ui.painter(), rect.center(), visible, color);
    let hint = if node.keys().track(&Channel::Visible).is_some() {
        texts.eye_key_hint
    } else {
        texts.eye_hint
    };
    if response.on_hover_text(format!("{name}. {hint}")).clicked() {
        let value = Entry::Set(vec![f64::from(u8::from(!visible))]);
        let action = NodeAction::Value(at, Channel::Visible, value);
        actions.push(Action::Node(action));
    }
}

fn paint_eye(painter: &Painter, centre: Pos2, open: bool, color: Color32) {
    let stroke = Stroke::new(1.2, color);
    let lid = |up: f32| {
        (0..=8_u8).map(move |step| {
            let share = f32::from(step) / 8.0;
            let high = 3.6 * (std::f32::consts::PI * share).sin();
            centre + vec2(12.0 * share - 6.0, -up * high)
        })
    };
    painter.add(Shape::line(lid(-1.0).collect(), stroke));
    if open {
        painter.add(Shape::line(lid(1.0).collect(), stroke));
        painter.circle_filled(centre, 1.8, color);
    } else {
        for across in [-3.0, 0.0, 3.0] {
            let from = pos2(centre.x + across, centre.y + 3.2);
            painter.line_segment([from, from + vec2(0.4 * across, 2.4)], stroke);
        }
    }
}

pub(super) fn kind(editor: &Editor, node: &Node) -> &'static str {
    let texts = &editor.texts().scene;
    match node.kind {
        Kind::Group => texts.group,
        Kind::Object(_) => texts.object,
        Kind::Light(_) => texts.light,
        Kind::Camera(_) => texts.camera,
    }
}
