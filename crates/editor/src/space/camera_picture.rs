//! What stands in the camera's picture: objects, the path, the frame within which all is safe.

use std::sync::Arc;

use egui::{Color32, Painter, Pos2, Rect, vec2};
use glam::{DMat4, DVec2, DVec3, DVec4};
use vides_engine::math::view::View;
use vides_raster::{Line, Lines, Surfaces};

use super::nodes::colour as wire_colour;
use super::projection::{cube, from_pos, lights};
use super::scene::{EDGE, floor, object_line};
use crate::scene_view::wires;
use crate::setup::Element;
use crate::space::cameras::Camera;
use crate::state::Editor;
use crate::state::space::solid::{Eye, Solid};

/// Distance of the front plane, in units of the space's `half_size`.
pub(super) const FRONT: f64 = 1e-3;

/// Outlines the safe action and title areas (SMPTE ST 2046-1: 93 % and 90 % of each side).
pub(super) fn safe_frame(painter: &Painter, picture: Rect, colour: Color32) {
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

/// The matrix into the canonical volume, from units of `half_size` around the middle, and how a
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
        lights: lights(camera.view.cross(camera.up), camera.up, -camera.view),
        rect: picture,
        pixels_per_point,
        of_path: false,
    };
    Some((matrix, eye))
}

/// Paints cube and object as the camera sees them, in `picture`.
pub(super) fn paint(
    editor: &Editor,
    solid: &mut Solid,
    camera: &Camera,
    painter: &Painter,
    picture: Rect,
) {
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
        for (from, to) in cube(space) {
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
                    let color = wire_colour(wire.colour, color);
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
pub(super) fn seen(matrix: &DMat4, front: f64, from: DVec3, to: DVec3) -> Option<[DVec2; 2]> {
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

pub(super) fn on_picture(at: DVec2, picture: Rect) -> Pos2 {
    #[allow(clippy::cast_possible_truncation)]
    let [x, y] = at.to_array().map(|x| x as f32);
    picture.center() + vec2(x, -y) * picture.size() / 2.0
}
