//! What the camera sees, in perspective (thesis chapter 2): at the frame that is played, else for
//! the current orientation.

use egui::{
    Align2, Context, CursorIcon, Id, Key, PointerButton, Pos2, Rect, Response, Sense, Ui,
    UiBuilder, Vec2, vec2,
};

use super::camera_caption::{CAPTION, caption};
use super::camera_picture::{paint, safe_frame};
use super::{drawing, flying};
use crate::action::Action;
use crate::setup::{CameraPlace, Element};
use crate::space::cameras::Camera;
use crate::state::Editor;
use crate::state::host::HostPane;
use crate::state::space::solid::Solid;
use crate::{keys, theme};

/// Initial width of the picture, in points.
const WIDTH: f32 = 228.0;
const LEAST: f32 = 96.0;
const LOW: f32 = 400.0;

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

pub(super) fn corner(viewport: Rect) -> Pos2 {
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

/// The shown camera, in the coordinates of the path.
fn camera_of_path(editor: &Editor) -> Option<Camera> {
    let of_scene = editor.with_scene(|now| Some(now.camera(now.scene.shown_camera()?)));
    match of_scene {
        Ok(Some(camera)) => camera,
        _ => Some(editor.camera()?.0),
    }
}

#[cfg(test)]
#[path = "camera_view_tests.rs"]
mod tests;
