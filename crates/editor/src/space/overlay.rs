//! What stands above the curve and is made anew in each pass: the current camera's arrows and
//! circle, the guides of a drag, numbers, the ring around what the pointer would drag.

use std::f64::consts::{PI, TAU};
use std::sync::Arc;

use egui::{Align2, Color32, FontId, Painter, Pos2, Rect, Shape, Stroke, vec2};
use glam::{DVec2, DVec3};

use super::cameras::Camera;
use super::drag::VUP_LENGTH;
use super::picking::Tips;
use super::projection::{Axis, to_pos};
use super::scene::{Look, THIN};
use super::strokes::Strokes;
use super::tangents;
use crate::document::Document;
use crate::document::tool::Cage;
use crate::raster::Lines;
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

/// Half the side of a control point's square, in points.
const CONTROL: f64 = 2.5;

/// Size of the cells by which numbers keep apart, in points.
const CELL: [f32; 2] = [18.0, 14.0];

/// On paths of more points only the current one and the one under the pointer have numbers.
const MANY: usize = 2000;

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

/// The numbers of the points, from 1, as far as there is room; always that of the current point and
/// that under the pointer, the latter with its name. Other names appear where they cover nothing.
pub(super) fn numbers(
    painter: &Painter,
    document: &Document,
    look: &Look<'_>,
    hover: Option<usize>,
    several: &[usize],
) {
    let Some(color) = look.of(Element::Numbers) else {
        return;
    };
    let current = document.selection().point;
    let points = &document.path().points;
    let mut taken = Taken::new(look.viewport);
    let mut labels = Vec::new();
    let mut put = |at: usize, always: bool| {
        let Some(point) = points.get(at) else { return };
        let image = look.projection.image(point.position);
        let pos = to_pos(image);
        if !look.viewport.contains(pos) || !taken.take(pos, always) {
            return;
        }
        let (size, color) = if at == current {
            (13.0, look.colours.of(Element::Segment))
        } else if several.binary_search(&at).is_ok() {
            (11.0, look.colours.of(Element::Segment))
        } else {
            (11.0, color)
        };
        let corners = corners_by_room(document, look, at, image);
        let name = point.name.as_deref().unwrap_or_default();
        let label = Label {
            pos,
            corners,
            size,
            color,
        };
        let whole = format!("{}  {name}", at + 1);
        let seen = hover == Some(at) && label.show(painter, look, &whole, |rect| free(look, rect));
        if !seen {
            labels.push((label, at + 1, name));
        }
    };
    put(current, true);
    if let Some(hover) = hover.filter(|&hover| hover != current) {
        put(hover, true);
    }
    if points.len() <= MANY {
        (0..points.len())
            .filter(|&at| at != current && Some(at) != hover)
            .for_each(|at| put(at, false));
    }
    // A name, or else the number alone, wholly to be seen or not at all.
    for (label, number, name) in labels {
        let whole = format!("{number}  {name}");
        let fits = |rect| free(look, rect) && taken.take_beside(label.pos, rect);
        if name.is_empty() || !label.show(painter, look, &whole, fits) {
            let number = number.to_string();
            label.show(painter, look, &number, |rect| free(look, rect));
        }
    }
}

/// Whether a text is seen whole there: the camera's pane lies above the space.
fn free(look: &Look<'_>, text: Rect) -> bool {
    look.viewport.contains_rect(text) && look.pane.is_none_or(|pane| !pane.intersects(text))
}

/// The cells of the viewport that hold a number, and its place; with a margin of one cell.
struct Taken {
    cells: Vec<Option<Pos2>>,
    wide: usize,
    corner: Pos2,
}

impl Taken {
    fn new(viewport: Rect) -> Self {
        let (wide, high) = (viewport.width() / CELL[0], viewport.height() / CELL[1]);
        let (wide, high) = (wide as usize + 3, high as usize + 3);
        Self {
            cells: vec![None; wide * high],
            wide,
            corner: viewport.min,
        }
    }

    /// Column and row of a position.
    fn cell(&self, pos: Pos2) -> [usize; 2] {
        let way = pos - self.corner;
        [
            (way.x / CELL[0]) as usize + 1,
            (way.y / CELL[1]) as usize + 1,
        ]
    }

    /// Takes the cell of a number, unless another is less than a cell away and it is not needed
    /// `always`.
    fn take(&mut self, pos: Pos2, always: bool) -> bool {
        let [x, y] = self.cell(pos);
        let rows =
            (y - 1..=y + 1).filter_map(|y| self.cells.get(y * self.wide + x - 1..)?.get(..3));
        let near = |other: &Pos2| {
            let way = (*other - pos).abs();
            way.x < CELL[0] && way.y < CELL[1]
        };
        if !always && rows.flatten().flatten().any(near) {
            return false;
        }
        if let Some(taken) = self.cells.get_mut(y * self.wide + x) {
            *taken = Some(pos);
        }
        true
    }

    /// Takes the cells of a name, unless one of them or beside them is taken by another than its own
    /// number, at `pos`.
    fn take_beside(&mut self, pos: Pos2, name: Rect) -> bool {
        let own = self.cell(pos);
        let cells = |taken: &Self, room: Rect| {
            let ([left, top], [right, bottom]) = (taken.cell(room.min), taken.cell(room.max));
            let cells = (top..=bottom).flat_map(move |y| (left..=right).map(move |x| [x, y]));
            let wide = taken.wide;
            let others = cells.filter(move |&cell| cell != own);
            others.map(move |[x, y]| y * wide + x)
        };
        let room = name.expand2(vec2(CELL[0], CELL[1]) / 2.0);
        if cells(self, room).any(|cell| self.cells.get(cell).is_none_or(Option::is_some)) {
            return false;
        }
        cells(self, name).for_each(|cell| self.cells[cell] = Some(pos));
        true
    }
}

/// An offset from a point, and which corner of the text comes to lie there.
type Corner = (egui::Vec2, Align2);

/// The corners beside a point, first that farthest from its curve and its camera's view and up.
fn corners_by_room(document: &Document, look: &Look<'_>, at: usize, image: DVec2) -> [Corner; 4] {
    let points = &document.path().points;
    let neighbour = |at: Option<usize>| {
        let point = at.and_then(|at| points.get(at))?;
        Some(look.projection.image(point.position) - image)
    };
    let selection = document.selection();
    let number = if at == selection.point {
        selection.orientation
    } else {
        0
    };
    let camera = Camera::at(document, at, number);
    let seen = |way: DVec3| look.projection.image_of_way(way);
    let mut tips = tangents::tips(document).filter(|_| at == selection.point);
    let mut handle = || {
        tips.next()
            .map(|(_, tip)| look.projection.image(tip) - image)
    };
    // Towards up lie the ribbon and the current camera's arrow.
    let taken = [
        handle(),
        handle(),
        neighbour(at.checked_sub(1)),
        neighbour(Some(at + 1)),
        camera.map(|camera| seen(camera.view)),
        camera.map(|camera| seen(camera.up)),
    ];
    let taken = taken.map(|way| way.map_or(DVec2::ZERO, DVec2::normalize_or_zero));
    let mut corners = [
        (DVec2::new(1.0, -1.0), Align2::LEFT_BOTTOM),
        (DVec2::new(-1.0, -1.0), Align2::RIGHT_BOTTOM),
        (DVec2::new(1.0, 1.0), Align2::LEFT_TOP),
        (DVec2::new(-1.0, 1.0), Align2::RIGHT_TOP),
    ];
    let crowd = |corner: DVec2| {
        let near = taken.iter().map(|way| way.dot(corner.normalize()));
        near.fold(-1.0, f64::max)
    };
    let mut best = 0;
    for at in 1..corners.len() {
        // Earlier corners are preferred: there one looks for a number.
        if crowd(corners[at].0) < crowd(corners[best].0) - 0.1 {
            best = at;
        }
    }
    corners[..=best].rotate_right(1);
    corners[1..].sort_by(|a, b| crowd(a.0).total_cmp(&crowd(b.0)));
    #[allow(clippy::cast_possible_truncation)]
    corners.map(|(way, align)| (vec2(way.x as f32 * 6.0, way.y as f32 * 4.0), align))
}

/// Where and how a text with a halo stands beside a point.
struct Label<const N: usize> {
    pos: Pos2,
    corners: [Corner; N],
    size: f32,
    color: Color32,
}

impl<const N: usize> Label<N> {
    /// Shows a text at the first corner at which it `fits`. False: at none.
    fn show(
        &self,
        painter: &Painter,
        look: &Look<'_>,
        text: &str,
        mut fits: impl FnMut(Rect) -> bool,
    ) -> bool {
        let font = FontId::proportional(self.size);
        let galley = painter.layout_no_wrap(text.to_owned(), font, self.color);
        let at = |(way, align): &Corner| align.anchor_size(self.pos + *way, galley.size());
        let Some(rect) = self.corners.iter().map(at).find(|&rect| fits(rect)) else {
            return false;
        };
        halo(painter, look, rect);
        painter.galley(rect.min, galley, self.color);
        true
    }
}

/// The name of a camera, beside it.
pub(super) fn name(
    painter: &Painter,
    look: &Look<'_>,
    camera: &Camera,
    text: &str,
    color: Color32,
) {
    let pos = look.projection.pos(camera.position);
    let corners = [
        (vec2(8.0, -6.0), Align2::LEFT_BOTTOM),
        (vec2(-8.0, -6.0), Align2::RIGHT_BOTTOM),
    ];
    let label = Label {
        pos,
        corners,
        size: 11.0,
        color,
    };
    label.show(painter, look, text, |rect| free(look, rect));
}

/// A hint in the upper left corner, where it covers the least.
pub(super) fn hint(painter: &Painter, look: &Look<'_>, text: &str, color: Color32) {
    let pos = look.viewport.left_top() + vec2(12.0, 10.0);
    // Up to where the camera's pane is.
    let right = look.pane.map_or(look.viewport.right(), |pane| pane.left());
    let room = (right - 8.0 - pos.x)
        .min(look.viewport.width() * 0.68)
        .max(100.0);
    let galley = painter.layout(text.to_owned(), theme::small(), color, room);
    halo(painter, look, Rect::from_min_size(pos, galley.size()));
    painter.galley(pos, galley, color);
}

/// A background, so that a text can be read above lines.
fn halo(painter: &Painter, look: &Look<'_>, text: Rect) {
    let ground = look.colours.of(Element::Background).gamma_multiply(0.7);
    painter.add(theme::block(text.expand2(vec2(2.0, -1.0)), ground));
}

#[cfg(test)]
mod tests {
    use super::super::projection::from_pos;
    use super::super::scene::tests::Eye;
    use super::*;
    use crate::document::Info;
    use crate::path::{CameraPath, SupportPoint, Target};
    use crate::setup::View;

    /// A number stands neither on the arrow that shows what is up nor on the curve.
    #[test]
    fn the_number_leaves_the_arrows_free() {
        let eye = Eye::new(&View {
            rotation: 0.0,
            tilt: 0.0,
            ..View::default()
        });
        let look = eye.look();
        let mut met = 0;
        for roll in (-175..=180).step_by(5) {
            // The camera looks nearly at us, and the curve runs to the left.
            let mut points = [0.0, -0.5].map(|x| SupportPoint::new(DVec3::new(x, 0.0, 0.0)));
            let orientation = &mut points[0].orientations[0];
            orientation.target = Target::Relative(DVec3::new(-0.05, 0.0, 0.4));
            orientation.roll = f64::from(roll);
            let path = CameraPath {
                points: points.to_vec(),
                ..CameraPath::default()
            };
            let document = Document::from_parts(path, Info::default()).unwrap();
            let camera = Camera::at(&document, 0, 0).unwrap();
            let up = look.projection.image_of_way(camera.up).normalize();
            let [(way, _), ..] =
                corners_by_room(&document, &look, 0, look.projection.image(DVec3::ZERO));
            let number = DVec2::new(way.x.into(), way.y.into()).normalize();
            assert!(number.dot(up) < 0.9, "roll {roll}");
            assert!(number.x > 0.0 || up.x > 0.5, "roll {roll}: on the curve");
            met += usize::from(up.dot(DVec2::new(1.0, -1.0).normalize()) > 0.9);
        }
        assert!(met > 5, "the arrow was never where numbers stand as a rule");
    }

    /// An axis that was chosen is seen to be it: the others are not drawn.
    #[test]
    fn the_guide_along_an_axis_is_that_axis_alone() {
        let eye = Eye::new(&View::default());
        let look = eye.look();
        let through = DVec3::new(0.2, -0.1, 0.3);
        for axis in Axis::ALL {
            let freedom = |along| DragConstraint {
                fixed: Axis::Y,
                along,
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
