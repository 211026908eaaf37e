//! Numbers of points, names and hints above the space, where they cover the least.

use egui::{Align2, Color32, FontId, Painter, Pos2, Rect, vec2};
use glam::{DVec2, DVec3};
use vides_document::Document;

use super::cameras::Camera;
use super::projection::to_pos;
use super::scene::Look;
use super::tangents;
use crate::setup::Element;
use crate::theme::{self};

/// Size of the cells by which numbers keep apart, in points.
const CELL: [f32; 2] = [18.0, 14.0];

/// On paths of more points only the current one and the one under the pointer have numbers.
const MANY: usize = 2000;

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

    /// Takes the cells of a name, unless one of them or a neighbour is taken by something other
    /// than its own number, at `pos`.
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

/// The name of a camera, next to it.
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
    use super::super::scene::tests::Eye;
    use super::*;
    use crate::setup::View;
    use vides_document::Info;
    use vides_engine::path::{CameraPath, SupportPoint, Target};

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
                points: points.into(),
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
}
