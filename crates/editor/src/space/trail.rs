//! The ways of selected nodes that move by keys: a dot a frame, a square a key; and their pivots.

use std::sync::Arc;

use egui::{Color32, Painter};
use glam::{DVec2, DVec3};
use vides_engine::scene::{Channel, Track, Warnings};
use vides_raster::Lines;

use super::held_nodes::parent_in_space;
use super::projection::Projection;
use super::scene::{Look, THIN};
use super::strokes::Strokes;
use super::{nodes, overlay, picking, transform};
use crate::setup::Element;
use crate::state::Editor;
use crate::state::scene_view::Now;
use crate::state::space::{PointerController, Transform};

/// Most dots of a way; of a longer one each second, third and so on.
const DOTS: f64 = 2_000.0;

/// Of more keys there are no squares: they would be one line.
const KEYS: usize = 2_000;

/// Of more selected nodes there are no ways, and of pivots only dots.
const NODES: usize = 32;

/// With more selected nodes, pivots are not distinguished.
const SIGNS: usize = 1_000;

/// Radius of a dot, half the side of a key's square, radius of a pivot's ring and length of its
/// arms, in points.
const DOT: f64 = 1.2;
const SQUARE: f64 = 3.0;
const RING: f64 = 5.0;
const ARM: f64 = 10.0;

/// The selected nodes that move by keys of their position.
fn moving(editor: &Editor, now: &Now, take: impl FnMut((usize, &Track))) {
    let selected = editor.selected_nodes();
    let few = selected.iter().filter(|_| selected.len() <= NODES);
    let nodes = now.scene.nodes();
    let tracks = few.filter_map(|&at| {
        let node = nodes.get(at).filter(|node| node.path().is_none())?;
        Some((at, node.keys().track(&Channel::Position)?))
    });
    tracks.for_each(take);
}

/// Where a node is with this position, in the space, its parent as it is now: its pivot, that is.
fn place(now: &Now, node: usize, position: &[f64]) -> DVec3 {
    let of = &now.scene.nodes()[node];
    let parent = parent_in_space(now, of.parent);
    parent.transform_point3(DVec3::from_slice(position) + of.pivot)
}

/// The keys of a way that have squares.
fn squares(now: &Now, node: usize, track: &Track) -> Vec<DVec3> {
    let few = track.frames().len() <= KEYS;
    let values = track.values().chunks_exact(3).filter(|_| few);
    values.map(|value| place(now, node, value)).collect()
}

/// The key whose square lies within reach: its node and number.
pub(super) fn key_at(
    editor: &Editor,
    projection: &Projection,
    pointer: DVec2,
) -> Option<(usize, usize)> {
    let found = editor.with_scene(|now| {
        let mut found = None;
        moving(editor, now, |(node, track)| {
            let places = squares(now, node, track);
            let key = picking::nearest(projection, places.into_iter(), pointer);
            found = found.or(key.map(|key| (node, key)));
        });
        found
    });
    found.ok().flatten().flatten()
}

/// The box of the deformation that was chosen, the ways, pivots and handles of the selected nodes.
pub(super) fn paint(
    pointer: &PointerController,
    editor: &Editor,
    painter: &Painter,
    look: &Look<'_>,
) {
    let add = |lines: Lines| {
        painter.add(Lines::shape(&Arc::new(lines), look.viewport));
    };
    if let Some(transform) = &pointer.transform {
        add(guides(look, transform));
    }
    if !editor.means_nodes() {
        return;
    }
    if let Some(cage) = editor.cage_in_space() {
        let palette = editor.setup.theme().palette();
        add(overlay::cage(look, &cage, usize::MAX, palette));
    }
    add(lines(editor, look));
    if let Some(middle) = transform::handles(editor, look.projection) {
        add(transform::show_handles(look, middle, pointer.meant));
    }
}

/// The ways, and a sign at each selected node's pivot.
fn lines(editor: &Editor, look: &Look<'_>) -> Lines {
    let mut strokes = Strokes::new(look.projection, look.viewport);
    let color = look.colours.of(Element::Segment);
    // An error was reported when the nodes were drawn.
    let _ = editor.with_scene(|now| {
        moving(editor, now, |(node, track)| {
            way(&mut strokes, look, now, (node, track), color);
        });
    });
    let pivots = nodes::selected_pivots(editor);
    let few = pivots.len() <= NODES;
    for &(_, pivot) in pivots.iter().take(SIGNS) {
        match few {
            true => sign(&mut strokes, look, pivot, color),
            false => strokes.disc(look.projection.image(pivot), 2.0 * DOT, color),
        }
    }
    strokes.finish()
}

fn way(
    strokes: &mut Strokes<'_>,
    look: &Look<'_>,
    now: &Now,
    (node, track): (usize, &Track),
    color: Color32,
) {
    let (first, last) = track.ends();
    let every = ((last - first) / DOTS).ceil().max(1.0);
    let mut frame = first.ceil();
    let (mut value, warnings) = ([0.0; 3], &mut Warnings::default());
    let faint = color.gamma_multiply(0.75);
    while frame <= last {
        track.numbers(frame, &mut value, warnings);
        let image = look.projection.image(place(now, node, &value));
        strokes.disc(image, DOT, faint);
        frame += every;
    }
    for place in squares(now, node, track) {
        let image = look.projection.image(place);
        let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
        let corners = corners.map(|corner| image + DVec2::from(corner) * SQUARE);
        let ground = look.colours.of(Element::Background);
        let side = DVec2::X * SQUARE;
        #[allow(clippy::cast_possible_truncation)]
        let width = 2.0 * SQUARE as f32;
        strokes.flat(image - side, image + side, width, ground);
        for k in 0..4 {
            strokes.flat(corners[k], corners[(k + 1) % 4], 1.2, color);
        }
    }
}

/// A ring with four arms.
fn sign(strokes: &mut Strokes<'_>, look: &Look<'_>, pivot: DVec3, color: Color32) {
    let centre = look.projection.image(pivot);
    for (from, to) in overlay::corners(look, RING) {
        strokes.flat(centre + from * RING, centre + to * RING, 1.4, color);
    }
    for way in [DVec2::X, DVec2::Y, -DVec2::X, -DVec2::Y] {
        strokes.flat(centre + way * RING, centre + way * ARM, THIN, color);
    }
}

/// The lines along which held nodes move or turn, out to the sides of the space.
fn guides(look: &Look<'_>, transform: &Transform) -> Lines {
    let mut strokes = Strokes::new(look.projection, look.viewport);
    if let Some((through, ways)) = transform.lines(look.projection)
        && let Some(color) = look.of(Element::Axes)
    {
        let far = 2.0 * look.projection.space().half_size;
        for way in ways {
            let way = way.normalize_or_zero() * far;
            strokes.line(through - way, through + way, THIN, color);
        }
    }
    strokes.finish()
}
