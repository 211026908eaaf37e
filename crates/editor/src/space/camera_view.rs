//! What the camera sees: cube and object in perspective, by its zoom, with the
//! projection of the thesis's chapter 2. At the frame that is played, else for
//! the current orientation.

use std::sync::Arc;

use egui::{Align2, Color32, Context, FontId, Pos2, Rect, Sense, Ui, Vec2, vec2};
use glam::{DMat4, DVec2, DVec3};

use super::Camera;
use crate::actions::Action;
use crate::host::HostPane;
use crate::math::view::View;
use crate::raster::{Line, Lines};
use crate::scene_view::wires;
use crate::setup::Element;
use crate::state::Editor;
use crate::texts::fill;
use crate::theme;

/// Width by height of the picture: that of the film.
const ASPECT: f32 = 1.5;

/// Width of the picture at first, in points.
const WIDTH: f32 = 228.0;

/// Height of the strip above it that says what it shows, in points.
const CAPTION: f32 = 19.0;

/// The nearest thing that is seen, in half sizes of the movement space.
const FRONT: f64 = 1e-3;

/// Shows the pane if it is open; `viewport` is the movement window. Where the host draws
/// it, what it is to draw into.
pub(super) fn show(
    editor: &Editor,
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
        .min_width(WIDTH / 2.0);
    // Where no hand has moved it, it goes along with the window's size.
    let known: Option<Placed> = context.data(|data| data.get_temp(id));
    if known.is_some_and(|known| !known.by_hand && known.viewport != viewport) {
        pane = pane
            .current_pos(corner(viewport))
            .min_width(width)
            .max_width(width);
    }
    let shown = pane.show(context, |ui| contents(editor, ui, actions))?;
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
    shown.inner?
}

pub(crate) fn id() -> egui::Id {
    egui::Id::unique("camera view")
}

/// Where the pane is.
#[derive(Clone, Copy, Debug)]
struct Placed {
    /// The movement window.
    viewport: Rect,
    rect: Rect,
    /// Somebody has put it there.
    by_hand: bool,
}

fn corner(viewport: Rect) -> Pos2 {
    viewport.right_top() + vec2(-12.0, 12.0)
}

fn first_width(viewport: Rect) -> f32 {
    WIDTH.min(viewport.width() * 0.27).max(WIDTH / 2.0)
}

fn contents(editor: &Editor, ui: &mut Ui, actions: &mut Vec<Action>) -> Option<HostPane> {
    ui.spacing_mut().item_spacing.y = 0.0;
    // The height follows the width.
    let width = ui.available_width().max(60.0);
    let scene = editor.scene_pose().ok().flatten().map(Camera::from);
    let camera = scene.or_else(|| Some(editor.camera()?.0))?;
    caption(editor, ui, vec2(width, CAPTION), camera.zoom, actions);
    let (picture, response) = ui.allocate_exact_size(vec2(width, width / ASPECT), Sense::hover());
    let name = editor.texts().space.camera_picture;
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Canvas, true, name));
    if editor.host_view.fills_pane {
        let above = Vec::new();
        return (!ui.is_sizing_pass()).then_some(HostPane { picture, above });
    }
    let lines = picture_of(editor, &camera, picture);
    ui.painter_at(picture)
        .add(Lines::shape(&Arc::new(lines), picture));
    None
}

/// What is shown, beside the picture and not on it: that may be the host's, whole. By
/// this strip the pane can be moved then, too.
fn caption(editor: &Editor, ui: &mut Ui, size: Vec2, zoom: f64, actions: &mut Vec<Action>) {
    let (strip, _) = ui.allocate_exact_size(size, Sense::hover());
    let palette = theme::palette(ui);
    let texts = &editor.texts().space;
    let what = match editor.shown_frame() {
        _ if editor.document.around().is_some() => scene_label(editor),
        Some(frame) => fill(texts.camera_at_frame, &[&frame]),
        None => {
            let selection = editor.document.selection();
            let (point, number) = (selection.point + 1, selection.orientation + 1);
            fill(texts.camera_at_key, &[&point, &number])
        }
    };
    let zoom = fill(texts.millimetres, &[&editor.language().number(zoom, 0)]);
    let text = format!("{what} \u{b7} {zoom}");
    let start = strip.left_center() + vec2(7.0, 0.0);
    let font = FontId::proportional(11.0);
    let room = strip.with_max_x(strip.right() - CAPTION);
    ui.painter_at(room)
        .text(start, Align2::LEFT_CENTER, text, font, palette.weak);
    if close_button(editor, ui, strip) {
        actions.push(Action::SwitchCameraView);
    }
}

/// The name of the camera that is shown, and the frame of the scene.
fn scene_label(editor: &Editor) -> String {
    let said = editor.with_scene(|now| {
        let shown = now.scene.shown_camera();
        let name = shown.map_or("", |at| now.scene.nodes()[at].name.as_str());
        let frame = editor.language().number(now.frame.round(), 0);
        fill(editor.texts().scene.at_frame, &[&name, &frame])
    });
    said.ok().flatten().unwrap_or_default()
}

/// A small cross at the strip's end: whether it was clicked.
fn close_button(editor: &Editor, ui: &Ui, strip: Rect) -> bool {
    let place = Rect::from_min_max(strip.right_top() - vec2(CAPTION, 0.0), strip.max);
    let response = ui.interact(place, ui.scope_id().with("close"), Sense::click());
    let text = editor.texts().space.close_camera_view;
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, true, text));
    let palette = theme::palette(ui);
    let color = if response.hovered() || response.has_focus() {
        palette.text
    } else {
        palette.weak
    };
    let stroke = egui::Stroke::new(1.5, color);
    let centre = place.center();
    for way in [vec2(4.0, 4.0), vec2(4.0, -4.0)] {
        ui.painter()
            .line_segment([centre - way, centre + way], stroke);
    }
    response.on_hover_text(text).clicked()
}

/// Cube and object as the camera sees them, in `picture`.
fn picture_of(editor: &Editor, camera: &Camera, picture: Rect) -> Lines {
    let mut lines = Lines::default();
    // Behind the farthest corner and beyond the object.
    let object = &editor.document.info().object;
    let around = editor.document.around();
    let space = around.map_or(editor.document.path().space, |around| {
        around.scene().space()
    });
    // Counted from its middle in half sizes: what is far away loses no digits.
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
        f64::from(ASPECT),
        FRONT,
        back,
    );
    let Ok(matrix) = view.and_then(|view| view.matrix()) else {
        return lines;
    };
    let mut add = |from: DVec3, to: DVec3, width: f32, color: Color32| {
        let [from, to] = [from, to].map(local);
        if let Some([from, to]) = seen(&matrix, FRONT / back, from, to) {
            lines.lines.push(Line {
                from: on_picture(from, picture),
                to: on_picture(to, picture),
                width,
                color,
            });
        }
    };
    let colours = editor.setup.colours();
    let shown = &editor.setup.shown;
    if shown.has(Element::Cube) {
        let color = colours.of(Element::Cube).gamma_multiply(0.7);
        for (from, to) in super::cube(space) {
            add(from, to, 1.0, color);
        }
    }
    if shown.has(Element::Object) {
        let color = colours.of(Element::Object);
        for pair in object.windows(2) {
            if pair[1].draw {
                add(pair[0].position, pair[1].position, 1.2, color);
            }
        }
        // Without memory there is nothing to be seen, and no other harm.
        let _ = editor.with_scene(|now| {
            wires(editor, now, |wire| {
                let [from, to] = wire.ends;
                add(from, to, 1.2, super::wire_colour(wire.colour, color));
            });
        });
    }
    lines
}

/// The part of a line in the camera's pyramid, from −1 to 1 to the right and up
/// on the picture; none if it is not seen. `front` is the depth of the front
/// plane in the canonical volume (thesis 2.5.1).
fn seen(matrix: &DMat4, front: f64, from: DVec3, to: DVec3) -> Option<[DVec2; 2]> {
    let [a, b] = [from, to].map(|p| matrix.transform_point3(p));
    // Distances to the planes: inside where they are not negative.
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
