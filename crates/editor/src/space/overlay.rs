//! What is drawn above the curve and rebuilt in each pass: the current camera's arrows and
//! circle, the guides of a drag, numbers, the ring around what the pointer would drag.

use std::f64::consts::{PI, TAU};
use std::sync::Arc;

use egui::{Color32, Painter, Rect, Shape, Stroke};
use glam::{DVec2, DVec3};
use vides_document::Document;
use vides_document::tool::Cage;
use vides_engine::path::Pose;
use vides_raster::Lines;

use super::drag::VUP_LENGTH;
use super::picking::Tips;
use super::projection::{Axis, to_pos};
use super::scene::{Look, THIN};
use super::strokes::Strokes;
use super::tangents;
use crate::setup::Element;
use crate::state::space::{DragConstraint, Handle};
use crate::theme::{self, Palette};

/// Largest distance of a circle's straight pieces from it, in pixels.
const TOLERANCE: f64 = 0.1;

/// Length and half the width of an arrow's head, in points.
const HEAD: [f64; 2] = [12.0, 4.2];

/// Radius and width of the ring around what would be dragged, in points.
const RING: f64 = 8.0;
const RING_WIDTH: f32 = 1.5;

/// Half the side of the frame around a point selected with others, in points.
const FRAME: f64 = 6.0;

const ARROW: f32 = 2.0;

/// Width of the line along which something moves, in points.
const ALONG: f32 = 2.0;

/// The most recorded poses that have dots; of more, each second, third and so on.
const DOTS: usize = 4_000;

/// Radius of such a dot, in points.
const DOT: f64 = 1.3;

/// Half the side of a control point's square, in points.
const CONTROL: f64 = 2.5;

/// The straight pieces of a circle of `radius` points on the screen: their ends, in radii.
pub(super) fn corners(look: &Look<'_>, radius: f64) -> impl Iterator<Item = (DVec2, DVec2)> {
    let rise = TOLERANCE / (radius * look.pixels_per_point).max(1.0);
    let count = (PI / (1.0 - rise).acos()).ceil();
    let at = move |step: u32| DVec2::from_angle(TAU * f64::from(step) / count);
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    (0..count as u32).map(move |step| (at(step), at(step + 1)))
}

/// The circle on which the tip of VUP runs.
pub(super) fn circle(look: &Look<'_>, tips: &Tips) -> Lines {
    let mut strokes = Strokes::new(look.projection, look.viewport);
    if let Some(color) = look.of(Element::Circle) {
        let space = look.projection.space();
        let (u, v) = space.up.level_axes(tips.view);
        let radius = VUP_LENGTH * space.half_size;
        let corners = corners(look, VUP_LENGTH * look.projection.scale());
        let at = |turn: DVec2| tips.position + (v * turn.x - u * turn.y) * radius;
        for (from, to) in corners {
            strokes.line(at(from), at(to), THIN, color);
        }
    }
    strokes.finish()
}

pub(super) fn arrows(painter: &Painter, look: &Look<'_>, tips: &Tips) {
    let mut shafts = Strokes::new(look.projection, look.viewport);
    let mut heads = Vec::new();
    for (element, tip) in [(Element::Vpn, tips.target), (Element::Vup, tips.up_tip)] {
        if let Some(color) = look.of(element) {
            arrow(&mut shafts, &mut heads, look, [tips.position, tip], color);
        }
    }
    painter.add(Lines::shape(&Arc::new(shafts.finish()), look.viewport));
    painter.extend(heads);
}

/// An arrow whose head ends exactly at its tip; a dot if it points straight at the viewer.
fn arrow(
    shafts: &mut Strokes<'_>,
    heads: &mut Vec<Shape>,
    look: &Look<'_>,
    ends: [DVec3; 2],
    color: Color32,
) {
    let [from, to] = ends.map(|end| look.projection.image(end));
    let length = from.distance(to);
    if !length.is_finite() {
        return;
    }
    let head = HEAD[0].min(length * 0.6);
    if head < 4.0 {
        shafts.disc(to, 4.0, color);
        return;
    }
    let way = (to - from) / length;
    // The shaft ends within the head, so that no gap shows.
    shafts.flat(from, to - way * (head * 0.8), ARROW, color);
    if look.viewport.expand(24.0).contains(to_pos(to)) {
        let side = way.perp() * HEAD[1];
        let foot = to - way * head;
        // A notched head in two halves, since it is not convex.
        let notch = foot + way * (head * 0.22);
        heads.extend([side, -side].map(|side| {
            let corners = [to, foot + side, notch].map(to_pos).to_vec();
            Shape::convex_polygon(corners, color, Stroke::NONE)
        }));
    }
}

/// Guides of a drag, out to the cube: the plane's border and axes, or the one line of the motion.
pub(super) fn guides(look: &Look<'_>, through: DVec3, freedom: DragConstraint) -> Lines {
    let mut strokes = Strokes::new(look.projection, look.viewport);
    // Out to the point, if that lies outside.
    let space = look.projection.space();
    let (low, high) = (through.min(space.low()), through.max(space.high()));
    let plane = look.of(Element::Plane);
    if let (Some(color), None) = (plane, freedom.along) {
        let [a, b] = freedom.fixed.others().map(Axis::index);
        let corner = |at_a: f64, at_b: f64| {
            let mut corner = through;
            corner[a] = at_a;
            corner[b] = at_b;
            corner
        };
        let corners = [
            corner(low[a], low[b]),
            corner(high[a], low[b]),
            corner(high[a], high[b]),
            corner(low[a], high[b]),
        ];
        for k in 0..4 {
            strokes.line(corners[k], corners[(k + 1) % 4], 1.4, color);
        }
    }
    let axes = look.of(Element::Axes);
    let (color, width) = match freedom.along {
        // A thin one would be hard to find.
        Some(_) => (plane.or(axes), ALONG),
        None => (axes, THIN),
    };
    let shown = Axis::ALL.into_iter();
    let shown = shown.filter(|&axis| freedom.along.is_none_or(|along| along == axis));
    for axis in shown.map(Axis::index) {
        let [mut from, mut to] = [through; 2];
        from[axis] = low[axis];
        to[axis] = high[axis];
        if let Some(color) = color {
            strokes.line(from, to, width, color);
        }
    }
    strokes.finish()
}

/// A frame around the cross of each point that is selected with others.
pub(super) fn selected(document: &Document, look: &Look<'_>, points: &[usize]) -> Lines {
    let mut strokes = Strokes::new(look.projection, look.viewport);
    let color = look.colours.of(Element::Segment);
    let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    let corners = corners.map(|corner| DVec2::from(corner) * FRAME);
    for point in points
        .iter()
        .filter_map(|&at| document.path().points.get(at))
    {
        let image = look.projection.image(point.position);
        if !look.viewport.expand(8.0).contains(to_pos(image)) {
            continue;
        }
        for k in 0..4 {
            let [from, to] = [corners[k], corners[(k + 1) % 4]];
            strokes.flat(image + from, image + to, RING_WIDTH, color);
        }
    }
    strokes.finish()
}

/// The box that selects points.
pub(super) fn drawn_box(painter: &Painter, look: &Look<'_>, drawn: Rect) {
    let color = look.colours.of(Element::Segment);
    painter.add(theme::block(drawn, color.gamma_multiply(0.12)));
    let corners = [
        drawn.left_top(),
        drawn.right_top(),
        drawn.right_bottom(),
        drawn.left_bottom(),
        drawn.left_top(),
    ];
    for pair in corners.windows(2) {
        painter.line_segment([pair[0], pair[1]], Stroke::new(1.0, color));
    }
}

/// The plane of a drag, faintly filled.
pub(super) fn plane(painter: &Painter, look: &Look<'_>, through: DVec3, freedom: DragConstraint) {
    let Some(color) = look.of(Element::Plane).filter(|_| freedom.along.is_none()) else {
        return;
    };
    let [a, b] = freedom.fixed.others().map(Axis::index);
    let faces = [
        look.projection.space().low(),
        look.projection.space().high(),
    ];
    let corners = [[0, 0], [1, 0], [1, 1], [0, 1]].map(|[at_a, at_b]: [usize; 2]| {
        let mut corner = through;
        corner[a] = faces[at_a][a];
        corner[b] = faces[at_b][b];
        look.projection.pos(corner)
    });
    painter.add(Shape::convex_polygon(
        corners.to_vec(),
        color.gamma_multiply(0.08),
        Stroke::NONE,
    ));
}

/// The box that a tool deforms; `shown` is the control point whose numbers are shown.
pub(super) fn cage(look: &Look<'_>, cage: &Cage, shown: usize, palette: &Palette) -> Lines {
    let mut strokes = Strokes::new(look.projection, look.viewport);
    for pair in cage.lines.iter().flat_map(|line| line.windows(2)) {
        strokes.line(pair[0], pair[1], THIN, palette.weak);
    }
    for (at, &node) in cage.nodes.iter().enumerate() {
        let (half, color) = match at == shown {
            true => (CONTROL + 1.0, palette.accent),
            false => (CONTROL, palette.text),
        };
        let image = look.projection.image(node);
        let side = DVec2::X * half;
        strokes.flat(image - side, image + side, 2.0 * half as f32, color);
    }
    strokes.finish()
}

/// Recorded poses as dots, those that do not count as larger ones.
pub(super) fn recorded(
    look: &Look<'_>,
    poses: &[Pose],
    left_out: &[usize],
    palette: &Palette,
) -> Lines {
    let mut strokes = Strokes::new(look.projection, look.viewport);
    let every = poses.len().div_ceil(DOTS).max(1);
    let mut dot = |pose: &Pose, radius, color| {
        strokes.disc(look.projection.image(pose.position()), radius, color);
    };
    for pose in poses.iter().step_by(every) {
        dot(pose, DOT, palette.text.gamma_multiply(0.6));
    }
    let each = left_out.len().div_ceil(DOTS).max(1);
    for pose in left_out
        .iter()
        .step_by(each)
        .filter_map(|&at| poses.get(at))
    {
        dot(pose, 2.0 * DOT, palette.error);
    }
    strokes.finish()
}

/// A line being drawn.
pub(super) fn stroke(look: &Look<'_>, places: &[DVec3], palette: &Palette) -> Lines {
    let mut strokes = Strokes::new(look.projection, look.viewport);
    for pair in places.windows(2) {
        strokes.line(pair[0], pair[1], 1.5, palette.accent);
    }
    strokes.finish()
}

/// The ring around what would be dragged.
pub(super) fn ring(look: &Look<'_>, at: DVec3, color: Color32, held: bool) -> Lines {
    let mut strokes = Strokes::new(look.projection, look.viewport);
    let centre = look.projection.image(at);
    let fill = color.gamma_multiply(if held { 0.35 } else { 0.2 });
    strokes.disc(centre, RING, fill);
    for (from, to) in corners(look, RING) {
        strokes.flat(centre + from * RING, centre + to * RING, RING_WIDTH, color);
    }
    strokes.finish()
}

/// The place of a handle, and its colour.
pub(super) fn place_of(
    document: &Document,
    look: &Look<'_>,
    tips: &Tips,
    handle: Handle,
) -> Option<(DVec3, Color32)> {
    let colour = |element| look.colours.of(element);
    match handle {
        Handle::Vup => Some((tips.up_tip, colour(Element::Vup))),
        Handle::Vpn => Some((tips.target, colour(Element::Vpn))),
        Handle::Control(_) | Handle::Node(_) | Handle::Key(..) => None,
        Handle::Point(at) => {
            let point = document.path().points.get(at)?;
            Some((point.position, colour(Element::Segment)))
        }
        Handle::Tangent(side) => Some((tangents::tip(document, side)?, colour(Element::Segment))),
    }
}

#[cfg(test)]
mod tests {
    use super::super::projection::from_pos;
    use super::super::scene::tests::Eye;
    use super::*;

    use crate::setup::View;

    /// Only a chosen axis is drawn.
    #[test]
    fn the_guide_along_an_axis_is_that_axis_alone() {
        let eye = Eye::new(&View::default());
        let look = eye.look();
        let through = DVec3::new(0.2, -0.1, 0.3);
        for axis in Axis::ALL {
            let freedom = |along| DragConstraint {
                fixed: Axis::Y,
                along,
                edge_on: None,
            };
            let [line] = &guides(&look, through, freedom(Some(axis))).lines[..] else {
                panic!("one line along {axis:?}");
            };
            let way = (from_pos(line.to) - from_pos(line.from)).normalize();
            let wanted = look.projection.image_of_way(axis.unit()).normalize();
            assert!(way.perp_dot(wanted).abs() < 1e-3, "{axis:?}");
            let free = guides(&look, through, freedom(None)).lines;
            assert!(free.len() > 3 && free.iter().all(|free| free.width < line.width));
        }
    }
}
