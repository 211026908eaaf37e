//! Freehand lines for a tool that waits for one: in the space, or on the object in the picture.

use egui::{CursorIcon, Event, Key, PointerButton, Pos2, Rect, Response, Shape, Stroke, Ui};
use glam::DVec3;
use vides_engine::tools::clearance::Clearance;

use super::projection::from_pos;
use crate::action::{Action, ToolAction};
use crate::space::cameras::Camera;
use crate::space::surface::{PointerContext, projection_of};
use crate::state::Editor;
use crate::state::space::Drawing;
use crate::state::windows::ToolWindow;
use crate::{keys, theme};

/// A line drawn this near, in points, to lines and points of an object leads through them.
const NEAR: f64 = 8.0;

/// Whether a tool waits for a line.
pub(super) fn is_wanted(editor: &Editor) -> bool {
    let tool = editor.windows.tool.as_ref();
    tool.is_some_and(ToolWindow::draws)
}

/// The place drawn at `pos`: at the depth of the current point, within the space.
fn place(editor: &Editor, surface: &PointerContext<'_>, pos: Pos2) -> DVec3 {
    place_in(editor, surface.viewport, pos)
}

/// The same; where there is no path yet, at the depth of the space's centre.
pub(super) fn place_in(editor: &Editor, viewport: Rect, pos: Pos2) -> DVec3 {
    let projection = projection_of(editor, viewport);
    let space = projection.space();
    let point = editor.point().filter(|_| !editor.is_first_screen());
    let point = point.map_or(space.centre, |point| point.position);
    let place = projection.point_facing(point, from_pos(pos));
    place.clamp(space.low(), space.high())
}

impl Drawing {
    pub(super) fn begin(editor: &Editor, surface: &PointerContext<'_>, pos: Pos2) -> Self {
        Self(vec![place(editor, surface, pos)])
    }

    pub(super) fn places(&self) -> &[DVec3] {
        &self.0
    }

    /// Handles an event; returns the line, or none once it is over.
    pub(super) fn take(
        mut self,
        editor: &Editor,
        surface: &PointerContext<'_>,
        event: &Event,
        actions: &mut Vec<Action>,
    ) -> Option<Self> {
        match *event {
            Event::PointerMoved(pos) => self.0.push(place(editor, surface, pos)),
            Event::PointerButton {
                button: PointerButton::Primary,
                pressed: false,
                ..
            } => {
                if self.0.len() > 2 {
                    actions.push(Action::Tool(ToolAction::Stroke(self.0)));
                }
                return None;
            }
            Event::Key {
                key: Key::Escape,
                pressed: true,
                ..
            } => {
                keys::consume_escape(surface.context);
                return None;
            }
            _ => {}
        }
        Some(self)
    }
}

/// Handles drawing in the camera's picture, and shows the line.
pub(super) fn in_picture(
    editor: &Editor,
    ui: &Ui,
    response: &Response,
    (picture, camera, aspect): (Rect, Camera, f64),
    actions: &mut Vec<Action>,
) {
    if response.hovered() || response.dragged() {
        ui.set_cursor_icon(CursorIcon::Crosshair);
    }
    let Some(window) = &editor.windows.tool else {
        return;
    };
    let drawn = window.drawn();
    let line: Vec<Pos2> = drawn.iter().map(|(at, _)| *at).collect();
    let stroke = Stroke::new(2.0, theme::palette(ui).accent);
    ui.painter_at(picture).add(Shape::line(line, stroke));
    if !drawn.is_empty() && keys::consume_escape(ui.ctx()) {
        actions.push(Action::Tool(ToolAction::EndDrawing { keeps: false }));
        return;
    }
    let begins = response.drag_started_by(PointerButton::Primary);
    if begins || (response.dragged_by(PointerButton::Primary) && !drawn.is_empty()) {
        // Out of memory for the tree, the line is drawn in the air.
        let object = editor.obstacles().ok().flatten();
        let space = editor.document.path().space;
        let mut last = drawn.last().map_or(space.centre, |(_, place)| *place);
        let pressed = ui.input(|input| input.pointer.press_origin());
        let motions = ui.input(|input| {
            let moved = input.events.iter().filter_map(|event| match event {
                Event::PointerMoved(at) => Some(*at),
                _ => None,
            });
            moved.collect::<Vec<_>>()
        });
        for at in pressed.filter(|_| begins).into_iter().chain(motions) {
            let at = picture.clamp(at);
            let ray = Ray::through(at, picture, &camera, aspect);
            let place = ray.meets(object.as_deref(), last, space.half_size);
            last = place.clamp(space.low(), space.high());
            actions.push(Action::Tool(ToolAction::DrawOn(at, last)));
        }
    }
    if response.drag_stopped() {
        actions.push(Action::Tool(ToolAction::EndDrawing { keeps: true }));
    }
}

/// From the camera through a place of its picture.
struct Ray {
    from: DVec3,
    way: DVec3,
    view: DVec3,
    /// Its width for each unit of distance.
    spread: f64,
}

impl Ray {
    fn through(at: Pos2, picture: Rect, camera: &Camera, aspect: f64) -> Self {
        let away = from_pos(at) - from_pos(picture.center());
        let half = 0.5 * from_pos(picture.size().to_pos2());
        let way = camera.ray(away.x / half.x, -away.y / half.y, aspect);
        Self {
            from: camera.position,
            way: way.normalize_or(camera.view),
            view: camera.view,
            spread: NEAR * camera.half_height() / half.y,
        }
    }

    /// The place on the object, else at the depth of `last`, or ahead if that is behind the camera.
    fn meets(&self, object: Option<&Clearance>, last: DVec3, half_size: f64) -> DVec3 {
        let far = object.and_then(|object| object.ahead(self.from, self.way, self.spread));
        let far = far.unwrap_or_else(|| {
            let deep = (last - self.from).dot(self.view);
            let deep = if deep > 1e-3 * half_size {
                deep
            } else {
                half_size
            };
            deep / self.way.dot(self.view)
        });
        self.from + far * self.way
    }
}
