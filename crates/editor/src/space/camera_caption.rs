//! The caption of the camera's picture: what it shows, its buttons, its menu.

use egui::{
    Align, Button, Color32, FontId, Label, Layout, Painter, Popup, PopupCloseBehavior, Rect,
    Response, RichText, Sense, Ui, UiBuilder, Vec2, vec2,
};

use super::shown_camera;
use crate::action::{Action, PathAction};
use crate::setup::{Aspect, CameraPlace, Setup};
use crate::space::cameras::Camera;
use crate::state::Editor;
use crate::texts::fill;
use crate::theme;

/// Height of the caption above it, in points.
pub(super) const CAPTION: f32 = 19.0;
const CAPTION_TEXT: f32 = 11.0;

/// A narrower caption has no room for what is rarely wanted.
const MIN_WIDTH_FOR_OPTIONS: f32 = 330.0;

/// Stands above the picture, since all of that may be the host's; a pane can be dragged by it.
pub(super) fn caption(
    editor: &Editor,
    ui: &mut Ui,
    size: Vec2,
    camera: &Camera,
    actions: &mut Vec<Action>,
) {
    let (strip, _) = ui.allocate_exact_size(size, Sense::hover());
    let texts = &editor.texts().space;
    let setup = &editor.setup;
    let flown = editor.flown().is_some() && setup.camera_place != CameraPlace::Corner;
    let what = match editor.shown_frame() {
        _ if flown => texts.free_view.to_owned(),
        _ if editor.document.edited_scene().is_some() => scene_label(editor),
        Some(frame) => fill(texts.camera_at_frame, &[&frame]),
        None => {
            let selection = editor.document.selection();
            let (point, number) = (selection.point + 1, selection.orientation + 1);
            fill(texts.camera_at_key, &[&point, &number])
        }
    };
    let zoom = fill(
        texts.millimetres,
        &[&editor.language().number(camera.zoom, 0)],
    );
    let text = format!("{what} \u{b7} {zoom}");
    let row = UiBuilder::new()
        .max_rect(strip)
        .layout(Layout::right_to_left(Align::Center));
    ui.scope_builder(row, |ui| {
        ui.spacing_mut().item_spacing.x = 2.0;
        let (close, painter) = icon(ui, texts.close_camera_view, texts.close_camera_view, false);
        let centre = close.rect.center();
        for way in [vec2(4.0, 4.0), vec2(4.0, -4.0)] {
            painter.line_segment([centre - way, centre + way], stroke_of(ui, &close, false));
        }
        if close.clicked() {
            actions.push(Action::SwitchCameraView);
        }
        let mut changed = setup.clone();
        for (place, name, tip) in [
            (
                CameraPlace::Whole,
                texts.camera_whole,
                texts.camera_whole_tip,
            ),
            (
                CameraPlace::Beside,
                texts.camera_beside,
                texts.camera_beside_tip,
            ),
        ] {
            if place_button(ui, setup.camera_place, place, name, tip) {
                changed.camera_place = setup.camera_place.switched(place);
            }
        }
        if strip.width() > MIN_WIDTH_FOR_OPTIONS {
            options(editor, ui, &mut changed);
        }
        if flown {
            let small = |words| Button::new(RichText::new(words).font(theme::small())).small();
            let back = ui.add(small(texts.fly_back));
            if back.on_hover_text(texts.fly_back_tip).clicked() {
                actions.push(Action::Fly(None));
            }
            let take = ui.add(small(texts.take_over));
            let replace = ui.input(|input| input.modifiers.shift);
            if take.on_hover_text(texts.take_over_tip).clicked() {
                actions.push(Action::Path(PathAction::TakeOver { replace }));
            }
        }
        if changed != *setup {
            actions.push(Action::Setup(Box::new(changed)));
        }
        let left = UiBuilder::new()
            .max_rect(ui.available_rect_before_wrap())
            .layout(Layout::left_to_right(Align::Center));
        ui.scope_builder(left, |ui| {
            label(editor, ui, (&what, &text), actions);
        });
    });
}

/// The safe frame and the picture's shape.
fn options(editor: &Editor, ui: &mut Ui, changed: &mut Setup) {
    let (texts, setup) = (&editor.texts().space, &editor.setup);
    let on = setup.safe_frame;
    let (safe, painter) = icon(ui, texts.safe_frame, texts.safe_frame_tip, on);
    let stroke = stroke_of(ui, &safe, on);
    for inset in [5.0, 8.0] {
        let frame = safe.rect.shrink2(vec2(inset - 1.0, inset));
        painter.rect_stroke(frame, 0.0, stroke, egui::StrokeKind::Middle);
    }
    if safe.clicked() {
        changed.safe_frame = !on;
    }
    let words = RichText::new(setup.camera_aspect.name()).font(theme::small());
    let aspect = ui.add(Button::new(words).frame(false));
    aspect.widget_info(|| egui::WidgetInfo {
        current_text_value: Some(setup.camera_aspect.name().to_owned()),
        ..egui::WidgetInfo::labeled(egui::Role::Button, true, texts.camera_aspect)
    });
    if aspect.on_hover_text(texts.camera_aspect_tip).clicked() {
        changed.camera_aspect = setup.camera_aspect.next();
    }
}

/// The menu, and what is shown: as much of it as there is room for.
fn label(editor: &Editor, ui: &mut Ui, (what, text): (&str, &str), actions: &mut Vec<Action>) {
    let texts = &editor.texts().space;
    let (button, painter) = icon(ui, texts.camera_menu, texts.camera_menu, false);
    let centre = button.rect.center();
    let chevron = [vec2(-3.5, -2.0), vec2(0.0, 2.0), vec2(3.5, -2.0)];
    let line = chevron.map(|corner| centre + corner).to_vec();
    painter.line(line, stroke_of(ui, &button, false));
    Popup::menu(&button)
        .close_behavior(PopupCloseBehavior::CloseOnClickOutside)
        .show(|ui| menu(editor, ui, actions));
    // As much of it as there is room for: at last the number of the frame or the key.
    let cameras = shown_camera::all(editor);
    let arrow = if cameras.len() > 1 {
        shown_camera::ARROW
    } else {
        0.0
    };
    let room = ui.available_width() - arrow;
    let part = what.rsplit(" \u{b7} ").next().unwrap_or_default();
    let word = part.rsplit(' ').next().unwrap_or_default();
    let shown = [text, what, part, word].into_iter().find(|words| {
        let font = FontId::proportional(CAPTION_TEXT);
        let words = (*words).to_owned();
        let galley = ui
            .painter()
            .layout_no_wrap(words, font, Color32::PLACEHOLDER);
        galley.size().x <= room
    });
    let words = RichText::new(shown.unwrap_or(word))
        .size(CAPTION_TEXT)
        .color(theme::palette(ui).weak);
    let label = Label::new(words).truncate().selectable(false);
    let label = match cameras.len() > 1 {
        true => shown_camera::choice(editor, ui, (label, text), &cameras, actions),
        false => ui.add(label),
    };
    if shown != Some(text) {
        label.on_hover_text(text);
    }
}

/// What a narrow caption has no room for, too.
fn menu(editor: &Editor, ui: &mut Ui, actions: &mut Vec<Action>) {
    let texts = &editor.texts().space;
    let mut changed = editor.setup.clone();
    for (place, name) in [
        (CameraPlace::Corner, texts.camera_corner),
        (CameraPlace::Beside, texts.camera_beside),
        (CameraPlace::Whole, texts.camera_whole),
    ] {
        if theme::choice(ui, changed.camera_place == place, name).clicked() {
            changed.camera_place = place;
        }
    }
    ui.separator();
    ui.label(texts.camera_aspect);
    for aspect in Aspect::ALL {
        if theme::choice(ui, changed.camera_aspect == aspect, aspect.name()).clicked() {
            changed.camera_aspect = aspect;
        }
    }
    ui.separator();
    let safe = theme::tick(ui, &mut changed.safe_frame, texts.safe_frame);
    safe.on_hover_text(texts.safe_frame_tip);
    if changed != editor.setup {
        actions.push(Action::Setup(Box::new(changed)));
    }
    let views = editor.host_view.captures || editor.ghost.is_some() || editor.flown().is_some();
    let take = ui.add_enabled(views, Button::new(texts.take_over));
    if take.on_hover_text(texts.take_over_tip).clicked() {
        ui.close();
        actions.push(Action::Path(PathAction::TakeOver { replace: false }));
    }
}

/// A small button whose icon the caller paints.
fn icon(ui: &mut Ui, name: &str, tip: &str, on: bool) -> (Response, Painter) {
    let (place, response) = ui.allocate_exact_size(vec2(CAPTION, CAPTION), Sense::click());
    response.widget_info(|| egui::WidgetInfo::selected(egui::Role::Button, true, on, name));
    (response.on_hover_text(tip), ui.painter_at(place))
}

fn stroke_of(ui: &Ui, response: &Response, on: bool) -> egui::Stroke {
    let palette = theme::palette(ui);
    let color = if response.hovered() || response.has_focus() {
        palette.text
    } else if on {
        palette.accent
    } else {
        palette.weak
    };
    egui::Stroke::new(1.3, color)
}

/// The button that moves the picture to `place` or back; returns whether it was clicked.
fn place_button(ui: &mut Ui, now: CameraPlace, place: CameraPlace, name: &str, tip: &str) -> bool {
    let on = now == place;
    let (response, painter) = icon(ui, name, tip, on);
    let stroke = stroke_of(ui, &response, on);
    let frame = Rect::from_center_size(response.rect.center(), vec2(13.0, 9.0));
    painter.rect_stroke(frame, 1.0, stroke, egui::StrokeKind::Middle);
    let filled = match place {
        CameraPlace::Beside => frame.with_min_x(frame.center().x),
        _ => frame,
    };
    painter.rect_filled(filled.shrink(1.5), 0.0, stroke.color);
    response.clicked()
}

/// The name of the shown camera, and the frame of the scene.
fn scene_label(editor: &Editor) -> String {
    let said = editor.with_scene(|now| {
        let shown = now.scene.shown_camera();
        let none = editor.texts().scene.no_camera;
        let name = shown.map_or(none, |at| &now.scene.nodes()[at].name);
        let first = f64::from(editor.document.info().first_frame);
        let frame = editor.language().number(now.frame.round() - 1.0 + first, 0);
        fill(editor.texts().scene.at_frame, &[&name, &frame])
    });
    said.ok().flatten().unwrap_or_default()
}
