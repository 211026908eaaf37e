//! The buttons of the bar that bear a picture: to play, for the graph, for the camera view.

use egui::{CornerRadius, Painter, Rect, Role, Sense, Shape, Stroke, Ui, WidgetInfo, vec2};

use crate::action::{Action, TimeAction};
use crate::state::Editor;
use crate::theme;

pub(super) const BUTTON: f32 = 32.0;

fn button(ui: &mut Ui, name: &str, tip: &str, on: bool) -> (egui::Response, Painter) {
    let size = vec2(BUTTON, theme::ROW + 4.0);
    let (rect, response) = ui.allocate_exact_size(size, Sense::click());
    response.widget_info(|| WidgetInfo::selected(Role::Button, ui.is_enabled(), on, name));
    let visuals = ui.style().interact_selectable(&response, on);
    ui.painter().rect(
        rect,
        CornerRadius::same(4),
        visuals.weak_bg_fill,
        visuals.bg_stroke,
        egui::StrokeKind::Inside,
    );
    let painter = ui.painter_at(rect);
    (response.on_hover_text(tip), painter)
}

pub(super) fn play_button(editor: &Editor, ui: &mut Ui, actions: &mut Vec<Action>) {
    let texts = &editor.texts().space;
    let plays = editor.playing.is_playing();
    let name = if plays { texts.pause } else { texts.play };
    let (response, painter) = button(ui, name, texts.play_tip, false);
    let color = ui.style().interact(&response).fg_stroke.color;
    let centre = response.rect.center();
    if plays {
        for x in [-3.5, 3.5] {
            let bar = Rect::from_center_size(centre + vec2(x, 0.0), vec2(3.0, 11.0));
            painter.rect_filled(bar, 0.5, color);
        }
    } else {
        let corners = [vec2(-4.0, -6.0), vec2(6.0, 0.0), vec2(-4.0, 6.0)];
        let corners = corners.map(|way| centre + way).to_vec();
        painter.add(Shape::convex_polygon(corners, color, Stroke::NONE));
    }
    if response.clicked() {
        actions.push(Action::Time(TimeAction::PlayOrPause));
    }
}

pub(super) fn camera_button(editor: &Editor, ui: &mut Ui, actions: &mut Vec<Action>) {
    let texts = &editor.texts().space;
    let on = editor.setup.camera_view;
    let (response, painter) = button(ui, texts.camera_view, texts.camera_view_tip, on);
    let visuals = ui.style().interact_selectable(&response, on);
    let stroke = Stroke::new(1.5, visuals.fg_stroke.color);
    let centre = response.rect.center();
    let body = Rect::from_center_size(centre - vec2(2.5, 0.0), vec2(11.0, 9.0));
    painter.rect_stroke(body, 1.5, stroke, egui::StrokeKind::Middle);
    let lens = [vec2(3.0, 0.0), vec2(8.0, -4.0), vec2(8.0, 4.0)];
    let lens = lens.map(|way| centre + way).to_vec();
    painter.add(Shape::closed_line(lens, stroke));
    if response.clicked() {
        actions.push(Action::SwitchCameraView);
    }
}

pub(super) fn speed_button(editor: &Editor, ui: &mut Ui, actions: &mut Vec<Action>) {
    let texts = &editor.texts().space;
    let on = editor.shows_speed_graph();
    let (response, painter) = button(ui, texts.speed_graph, texts.speed_graph_switch, on);
    let visuals = ui.style().interact_selectable(&response, on);
    let stroke = Stroke::new(1.5, visuals.fg_stroke.color);
    let centre = response.rect.center();
    let hill = (0..=12).map(|step| {
        let share = step as f32 / 12.0;
        let height = (share * std::f32::consts::PI).sin().powi(2);
        centre + vec2(share.mul_add(18.0, -9.0), height.mul_add(-10.0, 5.0))
    });
    painter.line(hill.collect(), stroke);
    if response.clicked() {
        actions.push(Action::Time(TimeAction::SwitchSpeedGraph));
    }
}
