//! What stands in the movement space, as lines: made again only where it changed.
//!
//! A drag changes four segments of perhaps ten thousand. So the curve is kept in chunks that know
//! the points they were made of. Its straight pieces are kept in space, so that turning the view
//! costs only a projection.

use std::ops::Range;
use std::ptr;
use std::sync::Arc;

use egui::{Color32, Painter, Rect};
use glam::{DVec2, DVec3};
use vides_document::error::Result;
use vides_document::{Document, Object};
use vides_engine::path::hermite::Cubic;
use vides_engine::path::tessellation::tessellate;
use vides_engine::path::{CameraPath, CurveKind, Space, Tangents, Tcb, curve};
use vides_raster::Lines;

use super::projection::{Projection, cube_edges, edge_ends};
use super::strokes::{Strokes, dimmed, in_pixel, part_between};
use crate::setup::{Colours, Element, Shown};
use crate::state::space::solid::Sight;

/// Segments in a chunk; more in paths of over [`FEW`] points, since each pass looks at each chunk.
const CHUNK: usize = 16;
const LARGE_CHUNK: usize = 64;
const FEW: usize = 1024;

/// Largest distance of the drawn curve from the true one, in pixels.
const TOLERANCE: f64 = 0.25;

/// Points of the curve and crosses nearer than this to the last one are left out, in pixels.
const MERGE: f64 = 0.25;
const MERGE_CROSSES: f64 = 1.5;

/// Half the size of a cross, in points.
const CROSS: f64 = 4.0;

/// Widths of unimportant lines, of the curve and of the current segment, in points.
pub(super) const THIN: f32 = 1.0;
const CURVE: f32 = 1.7;
const SEGMENT: f32 = 2.6;

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Look<'a> {
    pub(super) projection: &'a Projection,
    pub(super) viewport: Rect,
    pub(super) pixels_per_point: f64,
    pub(super) colours: &'a Colours,
    pub(super) shown: &'a Shown,
    /// The camera's pane, which lies above.
    pub(super) pane: Option<Rect>,
    /// The faces of objects, if they are shaded.
    pub(super) sight: Option<&'a Sight>,
}

/// The values of a [`Look`], to be compared with the next.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct LookKey {
    projection: Projection,
    viewport: Rect,
    pixels_per_point: f64,
    colours: Colours,
    shown: Shown,
    sight: Option<u64>,
}

impl Look<'_> {
    pub(super) fn key(&self) -> LookKey {
        LookKey {
            projection: *self.projection,
            viewport: self.viewport,
            pixels_per_point: self.pixels_per_point,
            colours: *self.colours,
            shown: *self.shown,
            sight: self.sight.map(|sight| sight.number),
        }
    }

    pub(super) fn of(&self, element: Element) -> Option<Color32> {
        self.shown.has(element).then(|| self.colours.of(element))
    }

    /// Error bound of curves in space: `half_size` by a power of two, so that a small zoom keeps
    /// them.
    fn tolerance(&self) -> f64 {
        let exact = TOLERANCE / (self.projection.scale() * self.pixels_per_point);
        exact.log2().floor().exp2() * self.projection.space().half_size
    }
}

/// What the curve depends on at a point.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Knot {
    position: DVec3,
    tcb: Tcb,
    kind: CurveKind,
    /// Those it owns; in a cubic spline those it has, which depend on points farther away.
    tangents: Option<Tangents>,
}

/// Some segments of the curve, and the crosses where they begin.
#[derive(Debug, Default)]
struct Chunk {
    /// The points it depends on: one before, those of the segments, two after; none past an end.
    knots: Vec<Option<Knot>>,
    /// Straight pieces; a segment's first point is the last one of the segment before.
    pieces: Vec<DVec3>,
    /// Error bound of the pieces.
    tolerance: f64,
    curve: Arc<Lines>,
    crosses: Arc<Lines>,
}

#[derive(Debug, Default)]
pub(crate) struct PathLines {
    seen: Option<LookKey>,
    /// What does not move on its own: what is behind all objects, and all else.
    behind: Arc<Lines>,
    still: Arc<Lines>,
    object: Object,
    chunks: Vec<Chunk>,
    /// Chunks made in the last pass, for tests only.
    made: usize,
}

impl PathLines {
    pub(super) fn update(&mut self, document: &Document, look: &Look<'_>) -> Result<()> {
        let seen = look.key();
        let other_look = self.seen.as_ref() != Some(&seen);
        let object = &document.info().object;
        // The same allocation, held by us meanwhile, has the same points.
        let other_object = !ptr::eq::<[_]>(&**object, &*self.object);
        if other_look || other_object {
            self.object = object.clone();
            [self.behind, self.still] = still(object, look).map(Arc::new);
        }
        // Out of memory below, everything is made again next time.
        self.seen = None;
        self.made = 0;
        let path = document.path();
        // The last point of an open path begins no segment, yet has a cross.
        let count = path.points.len().div_ceil(chunk(path));
        self.chunks.truncate(count);
        self.chunks.resize_with(count, Chunk::default);
        for (index, chunk) in self.chunks.iter_mut().enumerate() {
            let other_knots = !chunk.is_of(path, index);
            if other_knots || other_look {
                chunk.make(path, index, other_knots, look)?;
                self.made += 1;
            }
        }
        self.seen = Some(seen);
        Ok(())
    }

    pub(super) fn still(&self) -> [&Arc<Lines>; 2] {
        [&self.behind, &self.still]
    }

    pub(super) fn paint(&self, painter: &Painter, viewport: Rect) {
        let add = |lines: &Arc<Lines>| {
            if !lines.lines.is_empty() {
                painter.add(Lines::shape(lines, viewport));
            }
        };
        self.chunks.iter().for_each(|chunk| add(&chunk.curve));
        self.chunks.iter().for_each(|chunk| add(&chunk.crosses));
    }

    #[cfg(test)]
    fn all(&self) -> Vec<Vec<vides_raster::Line>> {
        let chunks = self.chunks.iter();
        [self.behind.lines.clone(), self.still.lines.clone()]
            .into_iter()
            .chain(
                chunks.flat_map(|chunk| [chunk.curve.lines.clone(), chunk.crosses.lines.clone()]),
            )
            .collect()
    }
}

fn chunk(path: &CameraPath) -> usize {
    if path.points.len() <= FEW {
        CHUNK
    } else {
        LARGE_CHUNK
    }
}

/// The points of a chunk, at which its segments begin.
fn segments(path: &CameraPath, index: usize) -> Range<usize> {
    let first = index * chunk(path);
    first..(first + chunk(path)).min(path.points.len())
}

fn knots(path: &CameraPath, index: usize) -> impl Iterator<Item = Option<Knot>> {
    let count = path.points.len();
    let Range { start: first, end } = segments(path, index);
    // From one before to two after the points, shifted by one to stay ≥ 0.
    (first..end + 3).map(move |shifted| {
        let at = match shifted.checked_sub(1) {
            Some(at) if at < count => at,
            _ if !path.closed => return None,
            Some(at) => at % count,
            None => count - 1,
        };
        Some(Knot {
            position: path.points[at].position,
            tcb: path.tcb(at),
            kind: path.curve,
            tangents: match path.curve.is_spline() {
                true => Some(curve::tangents(path, at)),
                false => path.points[at].tangents,
            },
        })
    })
}

impl Chunk {
    /// Whether it was made of the points that the path has now.
    fn is_of(&self, path: &CameraPath, index: usize) -> bool {
        knots(path, index).eq(self.knots.iter().copied())
    }

    fn make(
        &mut self,
        path: &CameraPath,
        index: usize,
        other_knots: bool,
        look: &Look<'_>,
    ) -> Result<()> {
        let tolerance = look.tolerance();
        let Range { start: first, end } = segments(path, index);
        if other_knots || self.tolerance != tolerance {
            self.knots.clear();
            self.pieces.clear();
            let mut viewport = Vec::new();
            for segment in first..end.min(path.segment_count()) {
                viewport.clear();
                let curve = curve::segment(path, segment);
                pieces(&curve, look, &mut viewport)?;
                let skip = usize::from(!self.pieces.is_empty());
                self.pieces.try_reserve(viewport.len())?;
                self.pieces
                    .extend(viewport.iter().skip(skip).map(|&(_, p)| p));
            }
            self.tolerance = tolerance;
            self.knots.extend(knots(path, index));
        }
        let mut strokes = Strokes::in_space(look);
        let merge = MERGE / look.pixels_per_point;
        stroke_curve(
            &mut strokes,
            thinned(&self.pieces, look.projection, merge),
            look.of(Element::Curve),
            look.of(Element::Outside),
            CURVE,
        );
        self.curve = Arc::new(strokes.finish());
        let mut strokes = Strokes::new(look.projection, look.viewport);
        if let Some(color) = look.of(Element::Crosses) {
            let merge = MERGE_CROSSES / look.pixels_per_point;
            let mut last = DVec2::INFINITY;
            for point in path.points.range(first..end) {
                let image = look.projection.image(point.position);
                if image.distance(last) < merge {
                    continue;
                }
                last = image;
                let hidden = look.sight.is_some_and(|sight| sight.hides(point.position));
                let color = dimmed(color, hidden);
                cross(&mut strokes, look, point.position, CROSS, THIN, color);
            }
        }
        self.crosses = Arc::new(strokes.finish());
        Ok(())
    }
}

/// The straight pieces of a segment; one that leads far out of the space is drawn less exactly.
fn pieces(curve: &Cubic, look: &Look<'_>, viewport: &mut Vec<(f64, DVec3)>) -> Result<()> {
    let from = curve.d - look.projection.space().centre;
    let size = [curve.a, curve.b, curve.c, from]
        .map(|v| v.abs().max_element())
        .into_iter()
        .fold(0.0, f64::max);
    Ok(tessellate(
        curve,
        look.tolerance().max(size * 1e-6),
        viewport,
    )?)
}

/// Leaves out points seen nearer than `merge` to the last one kept, but not the first and the last.
fn thinned(points: &[DVec3], projection: &Projection, merge: f64) -> impl Iterator<Item = DVec3> {
    let end = points.len().saturating_sub(1);
    let mut last = DVec2::INFINITY;
    points
        .iter()
        .enumerate()
        .filter_map(move |(index, &point)| {
            let image = projection.image(point);
            if index != end && image.distance(last) < merge {
                return None;
            }
            last = image;
            Some(point)
        })
}

/// A curve through points: inside the cube in one colour, outside dashed in another.
fn stroke_curve(
    strokes: &mut Strokes<'_>,
    points: impl Iterator<Item = DVec3>,
    inside: Option<Color32>,
    outside: Option<Color32>,
    width: f32,
) {
    let space = strokes.space();
    let (low, high) = (space.low(), space.high());
    let within = |p: DVec3| p.cmpge(low).all() && p.cmple(high).all();
    // Without a colour for the outside it is one curve.
    let outside = outside.or(inside);
    let marked = outside != inside;
    strokes.restart_dashes();
    let mut last = None;
    for to in points {
        let Some(from) = last.replace(to) else {
            continue;
        };
        if !marked || (within(from) && within(to)) {
            if let Some(color) = inside {
                strokes.line(from, to, width, color);
            }
            strokes.restart_dashes();
            continue;
        }
        let [start, end] = part_between(from, to, low, high)
            .filter(|[start, end]| start < end)
            .unwrap_or([1.0, 1.0]);
        let (enter, leave) = (from.lerp(to, start), from.lerp(to, end));
        if let Some(color) = outside {
            strokes.dashed(from, enter, width, color);
        }
        if start < end {
            if let Some(color) = inside {
                strokes.line(enter, leave, width, color);
            }
            strokes.restart_dashes();
            if let Some(color) = outside {
                strokes.dashed(leave, to, width, color);
            }
        }
    }
}

/// A small + on whole pixels.
fn cross(
    strokes: &mut Strokes<'_>,
    look: &Look<'_>,
    at: DVec3,
    size: f64,
    width: f32,
    color: Color32,
) {
    let image = look.projection.image(at);
    if !image.is_finite() {
        return;
    }
    let centre = DVec2::from_array(image.to_array().map(|x| in_pixel(x, look.pixels_per_point)));
    strokes.flat(
        centre - DVec2::X * size,
        centre + DVec2::X * size,
        width,
        color,
    );
    strokes.flat(
        centre - DVec2::Y * size,
        centre + DVec2::Y * size,
        width,
        color,
    );
}

/// The current segment and the current point's cross, above everything else.
pub(super) fn current(document: &Document, look: &Look<'_>) -> Result<Lines> {
    let path = document.path();
    let at = document.selection().point;
    let mut strokes = Strokes::in_space(look);
    if at < path.segment_count()
        && let Some(color) = look.of(Element::Segment)
    {
        let mut viewport = Vec::new();
        pieces(&curve::segment(path, at), look, &mut viewport)?;
        let points: Vec<DVec3> = viewport.into_iter().map(|(_, point)| point).collect();
        let outside = look.of(Element::Outside);
        stroke_curve(
            &mut strokes,
            points.into_iter(),
            Some(color),
            outside,
            SEGMENT,
        );
    }
    if let Some(point) = path.points.get(at)
        && let Some(color) = look.of(Element::Crosses)
    {
        cross(&mut strokes, look, point.position, CROSS + 2.0, 2.0, color);
    }
    Ok(strokes.finish())
}

/// Cube and object: the part behind the object, and the rest.
fn still(object: &Object, look: &Look<'_>) -> [Lines; 2] {
    let [mut behind, mut strokes] = [(); 2].map(|()| Strokes::new(look.projection, look.viewport));
    if let Some(color) = look.of(Element::Cube) {
        cube(&mut behind, &mut strokes, look, color);
    }
    let Some(color) = look.of(Element::Object) else {
        return [behind, strokes].map(Strokes::finish);
    };
    if let Some(sight) = look.sight {
        for &[from, to] in &*sight.edges {
            strokes.line(from, to, THIN, color.gamma_multiply(EDGE));
        }
    }
    if look.sight.is_none() || object.mesh().is_none() {
        for ([from, to], own) in object.lines() {
            let (width, color) = object_line(from == to, own, color);
            strokes.line(from, to, width, color);
        }
    }
    [behind, strokes].map(Strokes::finish)
}

/// How much of their colour edges have on shaded faces.
pub(super) const EDGE: f32 = 0.6;

/// Width and colour of a line or point of the object: its own colour, else `color`.
pub(super) fn object_line(point: bool, own: Option<[u8; 3]>, color: Color32) -> (f32, Color32) {
    let width = if point { 2.0 } else { 1.2 };
    let own = own.map(|[red, green, blue]| Color32::from_rgb(red, green, blue));
    (width, own.unwrap_or(color))
}

/// Cells of the floor's grid in each direction.
pub(super) const FLOOR_CELLS: i32 = 8;

/// The lines of that grid, without the edges of the space.
pub(super) fn floor(space: Space) -> impl Iterator<Item = [DVec3; 2]> {
    (1..FLOOR_CELLS).flat_map(move |step| {
        let at = 2.0 * f64::from(step) / f64::from(FLOOR_CELLS) - 1.0;
        let ends = [-1.0, 1.0];
        let across = ends.map(|way| space.place(DVec3::new(at, -1.0, way)));
        let along = ends.map(|way| space.place(DVec3::new(way, -1.0, at)));
        [across, along]
    })
}

fn cube(behind: &mut Strokes<'_>, before: &mut Strokes<'_>, look: &Look<'_>, color: Color32) {
    let floor = color.gamma_multiply(0.16);
    let space = look.projection.space();
    for [from, to] in self::floor(space) {
        behind.line(from, to, THIN, floor);
    }
    let hidden = color.gamma_multiply(0.7);
    for (axis, signs) in cube_edges() {
        let mut ends = edge_ends(space, axis, signs).map(|end| look.projection.image(end));
        // Edges that are upright on the screen fill whole pixels.
        if ends[0].x == ends[1].x {
            let x = in_pixel(ends[0].x, look.pixels_per_point);
            ends = ends.map(|end| DVec2::new(x, end.y));
        }
        if look.projection.hides_edge(axis, signs) {
            behind.restart_dashes();
            behind.flat_dashed(ends[0], ends[1], THIN, hidden);
        } else {
            before.flat(ends[0], ends[1], THIN, color);
        }
    }
}

#[cfg(test)]
#[path = "scene_tests.rs"]
pub(super) mod tests;
