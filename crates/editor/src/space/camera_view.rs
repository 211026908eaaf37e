//! What the camera sees, in perspective (thesis chapter 2): at the frame that is played, else for
//! the current orientation.

use std::sync::Arc;

use egui::{
    Align, Align2, Button, Color32, Context, CursorIcon, FontId, Id, Key, Label, Layout, Painter,
    PointerButton, Popup, PopupCloseBehavior, Pos2, Rect, Response, RichText, Sense, Ui, UiBuilder,
    Vec2, vec2,
};
use glam::{DMat4, DVec2, DVec3, DVec4};

use super::projection::{from_pos, light};
use super::scene::{EDGE, floor, object_line};
use super::{Camera, drawing, flying, shown_camera};
use crate::action::Action;
use crate::math::view::View;
use crate::raster::{Line, Lines, Surfaces};
use crate::scene_view::wires;
use crate::setup::{Aspect, CameraPlace, Element};
use crate::state::Editor;
use crate::state::host::HostPane;
use crate::state::space::solid::{Eye, Solid};
use crate::texts::fill;
use crate::{keys, theme};

/// Initial width of the picture, in points.
const WIDTH: f32 = 228.0;
const LEAST: f32 = 96.0;
const LOW: f32 = 400.0;

/// Height of the caption above it, in points.
const CAPTION: f32 = 19.0;
const CAPTION_TEXT: f32 = 11.0;

/// A narrower caption has no room for what is rarely wanted.
const MIN_WIDTH_FOR_OPTIONS: f32 = 330.0;

/// Distance of the front plane, in half sizes of the movement space.
const FRONT: f64 = 1e-3;

/// Width of the border between them by which it is dragged.
const BORDER: f32 = 6.0;

/// Divides the movement window into the part for the space and that for a docked picture, if any.
pub(super) fn divided(editor: &Editor, viewport: Rect) -> (Rect, Option<Rect>) {
    let share = editor.camera_share;
    match editor.setup.camera_place {
        _ if !editor.setup.camera_view => (viewport, None),
        CameraPlace::Corner => (viewport, None),
        CameraPlace::Whole => (viewport, Some(viewport)),
        CameraPlace::Beside if is_wide(viewport) => {
            let border = viewport.right() - share * viewport.width();
            let (space, picture) = viewport.split_left_right_at_x(border.round());
            (space, Some(picture))
        }
        CameraPlace::Beside => {
            let border = viewport.top() + share * viewport.height();
            let (picture, space) = viewport.split_top_bottom_at_y(border.round());
            (space, Some(picture))
        }
    }
}

/// Whether the picture lies at the right of the space, not above it.
fn is_wide(viewport: Rect) -> bool {
    viewport.width() > viewport.height()
}

/// The border between space and picture, by which either is made larger.
pub(super) fn dragged_border(
    editor: &Editor,
    ui: &Ui,
    (viewport, picture): (Rect, Rect),
    actions: &mut Vec<Action>,
) {
    if viewport == picture {
        return;
    }
    let wide = is_wide(viewport);
    let (place, cursor) = match wide {
        true => (
            picture.with_max_x(picture.left() + BORDER),
            CursorIcon::ResizeHorizontal,
        ),
        false => (
            picture.with_min_y(picture.bottom() - BORDER),
            CursorIcon::ResizeVertical,
        ),
    };
    let response = ui.interact(place, Id::unique("border of the camera"), Sense::DRAG);
    let (name, share) = (editor.texts().space.camera_border, editor.camera_share);
    response.widget_info(|| egui::WidgetInfo::slider(true, f64::from(share), name));
    if response.hovered() || response.dragged() {
        ui.set_cursor_icon(cursor);
        ui.painter()
            .rect_filled(place, 0.0, theme::palette(ui).focus.gamma_multiply(0.5));
    }
    if let (true, Some(at)) = (response.dragged(), response.interact_pointer_pos()) {
        let share = match wide {
            true => (viewport.right() - at.x) / viewport.width(),
            false => (at.y - viewport.top()) / viewport.height(),
        };
        actions.push(Action::CameraShare(share));
    }
}

/// Shows the picture docked, where one can fly through it; returns what the host is to draw into.
pub(super) fn docked(
    editor: &Editor,
    solid: &mut Solid,
    ui: &mut Ui,
    rect: Rect,
    actions: &mut Vec<Action>,
) -> Option<HostPane> {
    let ground = editor.setup.colours().of(Element::Background);
    let line = egui::Stroke::new(1.0, theme::palette(ui).line);
    ui.painter().rect_filled(rect, 0.0, ground);
    ui.painter()
        .rect_stroke(rect, 0.0, line, egui::StrokeKind::Inside);
    let inside = UiBuilder::new()
        .max_rect(rect.shrink(4.0))
        .id_salt("camera view");
    ui.scope_builder(inside, |ui| contents(editor, solid, ui, true, actions))
        .inner
}

/// Shows the picture as a floating pane, if it is open; returns what the host is to draw into.
pub(super) fn show(
    editor: &Editor,
    solid: &mut Solid,
    context: &Context,
    viewport: Rect,
    actions: &mut Vec<Action>,
) -> Option<HostPane> {
    if !editor.setup.camera_view {
        return None;
    }
    let palette = editor.setup.theme().palette();
    let ground = editor.setup.colours().of(Element::Background);
    let frame = egui::Frame::new()
        .fill(ground)
        .stroke(egui::Stroke::new(1.0, palette.rim))
        .corner_radius(4)
        .inner_margin(1);
    let id = id();
    let width = first_width(viewport);
    let mut pane = egui::Window::new(editor.texts().space.camera_view)
        .id(id)
        .title_bar(false)
        .frame(frame)
        .resizable([true, false])
        .constrain_to(viewport)
        .pivot(Align2::RIGHT_TOP)
        .default_pos(corner(viewport))
        .default_width(width)
        .min_width(LEAST);
    // Until the user moves it, it follows the window's size.
    let known: Option<Placed> = context.data(|data| data.get_temp(id));
    if known.is_some_and(|known| !known.by_hand && known.viewport != viewport) {
        pane = pane
            .current_pos(corner(viewport))
            .min_width(width)
            .max_width(width);
    }
    let shown = pane.show(context, |ui| contents(editor, solid, ui, false, actions))?;
    let rect = shown.response.rect;
    let held = context.input(|input| input.pointer.any_down());
    let by_hand = known.is_some_and(|known| {
        known.by_hand || (held && known.viewport == viewport && known.rect != rect)
    });
    let placed = Placed {
        viewport,
        rect,
        by_hand,
    };
    context.data_mut(|data| data.insert_temp(id, placed));
    // egui placed it by its previous width; with a new one it must be placed again.
    if known.is_none_or(|known| known.viewport != viewport || known.rect.size() != rect.size()) {
        context.request_repaint();
    }
    shown.inner?
}

/// Where the floating pane is, if there is one.
pub(super) fn floating(editor: &Editor, context: &Context) -> Option<Rect> {
    let floats = editor.setup.camera_view && editor.setup.camera_place == CameraPlace::Corner;
    let known: Option<Placed> = context.data(|data| data.get_temp(id()));
    known.filter(|_| floats).map(|known| known.rect)
}

pub(crate) fn id() -> egui::Id {
    egui::Id::unique("camera view")
}

/// Where the pane was in the last pass.
#[derive(Clone, Copy, Debug)]
struct Placed {
    viewport: Rect,
    rect: Rect,
    /// The user has put it there.
    by_hand: bool,
}

fn corner(viewport: Rect) -> Pos2 {
    viewport.right_top() + vec2(-12.0, 12.0)
}

fn first_width(viewport: Rect) -> f32 {
    // In a low space it would hide the path.
    let part = if viewport.height() < LOW { 0.23 } else { 0.27 };
    WIDTH.min(viewport.width() * part).max(LEAST)
}

fn contents(
    editor: &Editor,
    solid: &mut Solid,
    ui: &mut Ui,
    docked: bool,
    actions: &mut Vec<Action>,
) -> Option<HostPane> {
    ui.spacing_mut().item_spacing.y = 0.0;
    let width = ui.available_width().max(60.0);
    let scene = editor.scene_pose().ok().flatten().map(Camera::from);
    let flown = editor.flown().filter(|_| docked);
    let camera = flown.or(scene).or_else(|| Some(editor.camera()?.0))?;
    caption(editor, ui, vec2(width, CAPTION), &camera, actions);
    let aspect = editor.setup.camera_aspect.ratio();
    // A floating pane's height follows its width.
    let high = if docked {
        ui.available_height().max(40.0)
    } else {
        f32::INFINITY
    };
    let size = vec2(width.min(high * aspect), high.min(width / aspect));
    let room = if docked { vec2(width, high) } else { size };
    let draws = drawing::is_wanted(editor);
    let sense = if (docked || draws) && !editor.host_view.fills_pane {
        Sense::click_and_drag()
    } else {
        Sense::hover()
    };
    let (room, response) = ui.allocate_exact_size(room, sense);
    let picture = Rect::from_center_size(room.center(), size);
    let name = editor.texts().space.camera_picture;
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Canvas, true, name));
    if editor.host_view.fills_pane {
        let above = Vec::new();
        return (!ui.is_sizing_pass()).then_some(HostPane { picture, above });
    }
    let painter = ui.painter_at(picture);
    paint(editor, solid, &camera, &painter, picture);
    let line = egui::Stroke::new(1.0, theme::palette(ui).line);
    if docked {
        painter.rect_stroke(picture, 0.0, line, egui::StrokeKind::Inside);
    }
    if editor.setup.safe_frame {
        safe_frame(&painter, picture, theme::palette(ui).rim);
    }
    if draws {
        let camera = if flown.is_some() {
            Some(camera)
        } else {
            camera_of_path(editor)
        };
        if let Some(camera) = camera {
            let aspect = f64::from(editor.setup.camera_aspect.ratio());
            drawing::in_picture(editor, ui, &response, (picture, camera, aspect), actions);
        }
    } else if docked {
        actions.extend(flown_on(editor, ui, &response, camera));
        if flown.is_none() {
            response.on_hover_text(editor.texts().space.fly_tip);
        }
    }
    None
}

/// Outlines the safe action and title areas (SMPTE ST 2046-1: 93 % and 90 % of each side).
fn safe_frame(painter: &Painter, picture: Rect, colour: Color32) {
    for share in [0.93, 0.9] {
        let safe = Rect::from_center_size(picture.center(), picture.size() * share);
        let corners = [
            safe.left_top(),
            safe.right_top(),
            safe.right_bottom(),
            safe.left_bottom(),
            safe.left_top(),
        ];
        let stroke = egui::Stroke::new(1.0, colour);
        painter.extend(egui::Shape::dashed_line(&corners, stroke, 4.0, 4.0));
    }
}

/// Moves the camera by mouse and keys.
fn flown_on(editor: &Editor, ui: &Ui, response: &Response, camera: Camera) -> Option<Action> {
    let space = editor.shown_space();
    let mut at = camera;
    let by = response.drag_delta();
    if response.dragged() && by != Vec2::ZERO {
        let [x, y] = [by.x, by.y].map(f64::from);
        let shift = ui.input(|input| input.modifiers.shift);
        let walks = response.dragged_by(PointerButton::Middle) || shift;
        at = if response.dragged_by(PointerButton::Secondary) {
            flying::circled(at, space, [x, y])
        } else if walks {
            flying::walked(at, space, [-x * flying::DRAG, y * flying::DRAG, 0.0])
        } else {
            flying::looked(at, space, [x, y])
        };
    }
    if response.contains_pointer() || editor.flown().is_some() {
        let typing = ui.ctx().text_edit_focused();
        let (wheel, way, seconds, fast) = ui.input(|input| {
            let held = |key| f64::from(u8::from(input.key_down(key)));
            let way = [
                held(Key::D) - held(Key::A),
                held(Key::E) - held(Key::Q),
                held(Key::W) - held(Key::S),
            ];
            let plain = !(typing || input.modifiers.command || input.modifiers.alt);
            (
                f64::from(input.smooth_scroll_delta().y) / 50.0,
                if plain { way } else { [0.0; 3] },
                f64::from(input.stable_dt.min(0.1)),
                if input.modifiers.shift { 4.0 } else { 1.0 },
            )
        });
        if wheel != 0.0 && response.contains_pointer() {
            at = flying::walked(at, space, [0.0, 0.0, wheel * flying::NOTCH]);
        }
        if way != [0.0; 3] {
            let far = flying::WALK * seconds * fast;
            at = flying::walked(at, space, way.map(|part| part * far));
            ui.ctx().request_repaint();
        }
        if editor.flown().is_some() && !typing && keys::consume_escape(ui.ctx()) {
            return Some(Action::Fly(None));
        }
    }
    (at != camera).then_some(Action::Fly(Some(at)))
}

/// Stands above the picture, since all of that may be the host's; a pane can be dragged by it.
fn caption(editor: &Editor, ui: &mut Ui, size: Vec2, camera: &Camera, actions: &mut Vec<Action>) {
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
        if flown {
            let small = |words| Button::new(RichText::new(words).font(theme::small())).small();
            let back = ui.add(small(texts.fly_back));
            if back.on_hover_text(texts.fly_back_tip).clicked() {
                actions.push(Action::Fly(None));
            }
            let take = ui.add(small(texts.take_over));
            let replace = ui.input(|input| input.modifiers.shift);
            if take.on_hover_text(texts.take_over_tip).clicked() {
                actions.push(Action::TakeOver { replace });
            }
        }
        if changed != *setup {
            actions.push(Action::Setup(Box::new(changed)));
        }
        let left = UiBuilder::new()
            .max_rect(ui.available_rect_before_wrap())
            .layout(Layout::left_to_right(Align::Center));
        ui.scope_builder(left, |ui| {
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
            let shown = [text.as_str(), &what, part, word]
                .into_iter()
                .find(|words| {
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
                true => shown_camera::choice(editor, ui, (label, &text), &cameras, actions),
                false => ui.add(label),
            };
            if shown != Some(&text) {
                label.on_hover_text(&text);
            }
        });
    });
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
        actions.push(Action::TakeOver { replace: false });
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

/// The shown camera, in the coordinates of the path.
fn camera_of_path(editor: &Editor) -> Option<Camera> {
    let of_scene = editor.with_scene(|now| Some(now.camera(now.scene.shown_camera()?)));
    match of_scene {
        Ok(Some(camera)) => camera,
        _ => Some(editor.camera()?.0),
    }
}

/// The matrix into the canonical volume, in half sizes from the middle of the space, and how a
/// camera sees the world in `picture`.
pub(super) fn eye(
    editor: &Editor,
    camera: &Camera,
    picture: Rect,
    pixels_per_point: f64,
) -> Option<(DMat4, Eye)> {
    let object = &editor.document.info().object;
    let space = editor.shown_space();
    // In half sizes from the middle, so that a space far from the origin loses no digits.
    let local = |place: DVec3| (place - space.centre) / space.half_size;
    let farthest = object
        .iter()
        .map(|point| local(point.position).abs().max_element())
        .fold(1.0, f64::max);
    let position = local(camera.position);
    let back = 4.0 * (farthest + position.abs().max_element()) + 1.0;
    let view = View::from_pose(
        position,
        camera.view,
        camera.up,
        camera.zoom,
        f64::from(editor.setup.camera_aspect.ratio()),
        FRONT,
        back,
    );
    let matrix = view.and_then(|view| view.matrix()).ok()?;
    let unit = DMat4::from_scale(DVec3::splat(1.0 / space.half_size));
    let eye = Eye {
        matrix: pixels(picture, pixels_per_point)
            * matrix
            * unit
            * DMat4::from_translation(-space.centre),
        front: FRONT / back,
        slack: [0.0, 4e-3],
        light: light(camera.view.cross(camera.up), camera.up, -camera.view),
        rect: picture,
        pixels_per_point,
        of_path: false,
    };
    Some((matrix, eye))
}

/// Paints cube and object as the camera sees them, in `picture`.
fn paint(editor: &Editor, solid: &mut Solid, camera: &Camera, painter: &Painter, picture: Rect) {
    let pixels_per_point = f64::from(painter.pixels_per_point());
    let Some((matrix, eye)) = eye(editor, camera, picture, pixels_per_point) else {
        return;
    };
    let object = &editor.document.info().object;
    let space = editor.shown_space();
    let local = |place: DVec3| (place - space.centre) / space.half_size;
    let sight = solid.update(editor, painter.ctx(), eye).cloned();
    let shape = |lines: Vec<Line>| Lines::shape(&Arc::new(Lines { lines }), picture);
    let line = |[from, to]: [DVec3; 2], width: f32, color: Color32| {
        let [from, to] = seen(&matrix, eye.front, local(from), local(to))?;
        let [from, to] = [from, to].map(|end| on_picture(end, picture));
        Some(Line {
            from,
            to,
            width,
            color,
        })
    };
    let colours = editor.setup.colours();
    let shown = &editor.setup.shown;
    let mut lines = Vec::new();
    let mut room = |ends: [DVec3; 2], color: Color32| match &sight {
        None => lines.extend(line(ends, 1.0, color)),
        Some(sight) => sight.parts(ends[0], ends[1], |start, end, hidden| {
            let part = [start, end].map(|at| ends[0].lerp(ends[1], at));
            lines.extend(line(part, 1.0, color).filter(|_| !hidden));
        }),
    };
    if shown.has(Element::Cube) {
        let color = colours.of(Element::Cube).gamma_multiply(0.7);
        for (from, to) in super::cube(space) {
            room([from, to], color);
        }
        let color = color.gamma_multiply(0.45);
        for ends in floor(space) {
            room(ends, color);
        }
    }
    if let Some(sight) = &sight {
        painter.add(Surfaces::shape(&sight.surfaces, picture));
    }
    if shown.has(Element::Object) {
        let color = colours.of(Element::Object);
        for &ends in sight.iter().flat_map(|sight| sight.edges.iter()) {
            lines.extend(line(ends, 1.0, color.gamma_multiply(EDGE)));
        }
        if sight.is_none() || object.mesh().is_none() {
            for (ends, own) in object.lines() {
                let (width, color) = object_line(ends[0] == ends[1], own, color);
                lines.extend(line(ends, width, color));
            }
        }
        if sight.is_none() {
            // Out of memory these lines are merely missing.
            let _ = editor.with_scene(|now| {
                wires(editor, now, |wire| {
                    let color = super::wire_colour(wire.colour, color);
                    lines.extend(line(wire.ends, 1.2, color));
                });
            });
        }
    }
    painter.add(shape(lines));
}

/// From the canonical volume to the pixels of `picture`, and nearness, times the distance.
fn pixels(picture: Rect, pixels_per_point: f64) -> DMat4 {
    let [x, y] = from_pos(picture.center()).to_array();
    let half = 0.5 * from_pos(picture.size().to_pos2());
    let row = |x: f64, y: f64, z: f64| DVec4::new(x, y, z, 0.0) * pixels_per_point;
    DMat4::from_cols(
        row(half.x, 0.0, x),
        row(0.0, -half.y, y),
        DVec4::W,
        DVec4::Z,
    )
    .transpose()
}

/// The part of a line within the camera's pyramid, from −1 to 1 to the right and up. `front` is the
/// depth of the front plane in the canonical volume (thesis 2.5.1).
fn seen(matrix: &DMat4, front: f64, from: DVec3, to: DVec3) -> Option<[DVec2; 2]> {
    let [a, b] = [from, to].map(|p| matrix.transform_point3(p));
    // Distances to the six planes; inside where they are not negative.
    let planes = |p: DVec3| {
        [
            p.z - p.x,
            p.z + p.x,
            p.z - p.y,
            p.z + p.y,
            p.z - front,
            1.0 - p.z,
        ]
    };
    let [mut start, mut end] = [0.0f64, 1.0f64];
    for (at_a, at_b) in planes(a).into_iter().zip(planes(b)) {
        if !(at_a.is_finite() && at_b.is_finite()) || (at_a < 0.0 && at_b < 0.0) {
            return None;
        }
        let crossing = at_a / (at_a - at_b);
        if at_a < 0.0 {
            start = start.max(crossing);
        } else if at_b < 0.0 {
            end = end.min(crossing);
        }
    }
    (start < end).then(|| {
        [start, end]
            .map(|t| a.lerp(b, t))
            .map(|p| p.truncate() / p.z)
    })
}

fn on_picture(at: DVec2, picture: Rect) -> Pos2 {
    #[allow(clippy::cast_possible_truncation)]
    let [x, y] = at.to_array().map(|x| x as f32);
    picture.center() + vec2(x, -y) * picture.size() / 2.0
}

#[cfg(test)]
#[path = "camera_view_tests.rs"]
mod tests;
