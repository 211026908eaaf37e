//! The scene around the path at the playhead: its objects, lights, cameras and other paths; and which
//! of them lies under the pointer.

use std::collections::HashMap;
use std::sync::Arc;

use egui::{Color32, Painter, Pos2, Rect, Rgba};
use glam::{DVec2, DVec3};
use vides_document::error::Result;
use vides_engine::scene::{Kind, Light, Node, NodeState};
use vides_raster::Lines;

use super::cameras::{self, Camera};
use super::labels;
use super::picking::REACH;
use super::projection::{Projection, from_pos};
use super::scene::{Look, THIN};
use super::strokes::Strokes;
use crate::scene_view::wires;
use crate::scene_view::wires::other_paths;
use crate::setup::Element;
use crate::state::Editor;
use crate::state::scene_view::Now;
use crate::state::space::Nodes;

/// Length of a camera's edges and of a light's rays, in points.
const CAMERA: f64 = 34.0;
const RAYS: f64 = 12.0;

/// Half the size of a group's cross, and the radius of an object's dot, in points.
const CROSS: f64 = 4.0;
const DOT: f64 = 2.0;

/// With more cameras than this the names would hide them.
const NAMES: usize = 12;

impl Nodes {
    #[cfg(test)]
    pub(super) fn lines(&self) -> *const Lines {
        Arc::as_ptr(&self.lines)
    }

    /// The current lines; none where there is no scene.
    pub(super) fn update(&mut self, editor: &Editor, look: &Look<'_>) -> Result<&Arc<Lines>> {
        let made = editor.with_scene(|now| {
            let of = (look.key(), now.made_of, now.frame);
            if self.made.as_ref() != Some(&of) {
                self.lines = Arc::new(lines(editor, now, look));
                self.made = Some(of);
            }
        })?;
        if made.is_none() && self.made.take().is_some() {
            self.lines = Arc::default();
        }
        Ok(&self.lines)
    }
}

/// A wire object's colour, moved towards the window's for contrast; white counts as none.
pub(crate) fn colour(own: [f64; 3], of_window: Color32) -> Color32 {
    if own == [1.0; 3] {
        return of_window;
    }
    #[allow(clippy::cast_possible_truncation)]
    let [r, g, b] = own.map(|share| share.clamp(0.0, 1.0) as f32);
    let own = Color32::from(Rgba::from_rgb(r, g, b));
    own.lerp_to_gamma(of_window, 0.35)
}

fn lines(editor: &Editor, now: &Now, look: &Look<'_>) -> Lines {
    let mut strokes = Strokes::in_space(look);
    if let Some(color) = look.of(Element::Curve) {
        let faint = color.gamma_multiply(0.35);
        other_paths(now, |_, ends| {
            let [from, to] = ends.map(|end| now.into_path.transform_point3(end));
            strokes.line(from, to, THIN, faint);
        });
    }
    if let Some(color) = look.of(Element::Object).filter(|_| look.sight.is_none()) {
        wires(editor, now, |wire| {
            let [from, to] = wire.ends.map(|end| now.into_path.transform_point3(end));
            let color = colour(wire.colour, color);
            let width = if from == to { 2.0 } else { 1.2 };
            strokes.line(from, to, width, color);
        });
    }
    for at in 0..now.states.len() {
        if now.states[at].visible != 0 {
            glyph(&mut strokes, look, now, at);
        }
    }
    strokes.finish()
}

/// What stands for a node at its place: a camera, a light; a cross or a dot at the pivot of others.
fn glyph(strokes: &mut Strokes<'_>, look: &Look<'_>, now: &Now, at: usize) {
    let node = &now.scene.nodes()[at];
    if !node.kind.looks() {
        let Some(color) = look.of(Element::Object) else {
            return;
        };
        let image = look.projection.image(pivot(now, at));
        if matches!(node.kind, Kind::Object(_)) {
            strokes.disc(image, DOT, color.gamma_multiply(0.7));
        } else {
            for way in [DVec2::X, DVec2::Y] {
                strokes.flat(image - way * CROSS, image + way * CROSS, THIN, color);
            }
        }
        return;
    }
    let Some(color) = look.of(Element::Cameras) else {
        return;
    };
    let player = look.of(Element::Player).unwrap_or(color);
    let seen = now.camera(at);
    match node.kind {
        Kind::Camera(_) if Some(at) == now.scene.shown_camera() => {
            cameras::camera(strokes, look, &seen, CAMERA * 1.2, 1.8, player);
        }
        Kind::Light(kind) => light(strokes, look, &seen, kind, &now.states[at], color),
        _ => cameras::camera(strokes, look, &seen, CAMERA, THIN, color),
    }
}

/// Where a node's pivot is in the space; a camera's and a light's place.
pub(super) fn pivot(now: &Now, at: usize) -> DVec3 {
    let world = now.states[at].world();
    let place = world.transform_point3(now.scene.nodes()[at].pivot);
    now.into_path.transform_point3(place)
}

/// The pivots of the selected nodes that exist.
pub(super) fn selected_pivots(editor: &Editor) -> Vec<(usize, DVec3)> {
    let selected = editor.selected_nodes();
    let places = editor.with_scene(|now| {
        let places = selected.iter().map(|&at| (at, pivot(now, at)));
        places.collect()
    });
    places.ok().flatten().unwrap_or_default()
}

/// The visible nodes whose pivots are where it is said.
pub(super) fn within(editor: &Editor, is_there: impl Fn(DVec3) -> bool) -> Vec<usize> {
    let found = editor.with_scene(|now| {
        let seen = (0..now.states.len()).filter(|&at| now.states[at].visible != 0);
        seen.filter(|&at| is_there(pivot(now, at))).collect()
    });
    found.ok().flatten().unwrap_or_default()
}

/// The middle of the pivots of the selected nodes.
pub(super) fn middle(editor: &Editor) -> Option<DVec3> {
    let all = selected_pivots(editor);
    let sum: DVec3 = all.iter().map(|(_, place)| *place).sum();
    #[allow(clippy::cast_precision_loss)]
    let count = all.len() as f64;
    (count > 0.0).then(|| sum / count)
}

/// The visible nodes within reach of the pointer: those whose sign is there, the nearest first, then
/// those of which a line is.
pub(super) fn at(
    editor: &Editor,
    projection: &Projection,
    viewport: Rect,
    pointer: Pos2,
) -> Vec<usize> {
    let look = Look {
        projection,
        viewport,
        pixels_per_point: 1.0,
        colours: editor.setup.colours(),
        shown: &editor.setup.shown,
        pane: None,
        sight: None,
    };
    let pointer = from_pos(pointer);
    let found = editor.with_scene(|now| {
        let signs = near_signs(now, &look, pointer);
        let lines = near_lines(editor, now, &look, pointer);
        let others = lines.into_iter().filter(|node| !signs.contains(node));
        signs.iter().copied().chain(others).collect()
    });
    found.ok().flatten().unwrap_or_default()
}

/// Those whose sign is near, the nearest first.
fn near_signs(now: &Now, look: &Look<'_>, pointer: DVec2) -> Vec<usize> {
    let mut near = HashMap::new();
    for (at, node) in now.scene.nodes().iter().enumerate() {
        let sign = match node.kind.looks() {
            true => Element::Cameras,
            false => Element::Object,
        };
        if now.states[at].visible != 0 && look.shown.has(sign) {
            let image = look.projection.image(pivot(now, at));
            note(&mut near, at, image.distance(pointer));
        }
    }
    sorted(near)
}

/// Those of which a line is near, the nearest first.
fn near_lines(editor: &Editor, now: &Now, look: &Look<'_>, pointer: DVec2) -> Vec<usize> {
    let mut near = HashMap::new();
    let away = |ends: [DVec3; 2]| {
        let [from, to] = ends.map(|end| {
            let end = now.into_path.transform_point3(end);
            look.projection.image(end)
        });
        away_from_line(pointer, from, to)
    };
    if look.shown.has(Element::Object) {
        wires(editor, now, |wire| {
            note(&mut near, wire.node, away(wire.ends))
        });
    }
    if look.shown.has(Element::Curve) {
        other_paths(now, |node, ends| note(&mut near, node, away(ends)));
    }
    for at in 0..now.states.len() {
        let looks = now.scene.nodes()[at].kind.looks();
        if now.states[at].visible == 0 || !looks {
            continue;
        }
        let mut strokes = Strokes::new(look.projection, look.viewport);
        glyph(&mut strokes, look, now, at);
        for line in &strokes.finish().lines {
            let away = away_from_line(pointer, from_pos(line.from), from_pos(line.to));
            note(&mut near, at, away);
        }
    }
    sorted(near)
}

/// Keeps the least distance of what is within reach.
fn note(near: &mut HashMap<usize, f64>, node: usize, away: f64) {
    if away <= REACH {
        let known = near.entry(node).or_insert(away);
        *known = known.min(away);
    }
}

fn sorted(near: HashMap<usize, f64>) -> Vec<usize> {
    let mut all: Vec<(usize, f64)> = near.into_iter().collect();
    all.sort_by(|a, b| {
        (a.1, a.0)
            .partial_cmp(&(b.1, b.0))
            .unwrap_or(std::cmp::Ordering::Equal)
    });
    all.into_iter().map(|(node, _)| node).collect()
}

fn away_from_line(pointer: DVec2, from: DVec2, to: DVec2) -> f64 {
    let way = to - from;
    let share = (pointer - from).dot(way) / way.length_squared();
    // A line without length gives no number, and its first end.
    let share = if share.is_finite() {
        share.clamp(0.0, 1.0)
    } else {
        0.0
    };
    (from + way * share).distance(pointer)
}

/// A light: a star for a point light, a cone for a spot, a bundle of rays for a directional one.
fn light(
    strokes: &mut Strokes<'_>,
    look: &Look<'_>,
    at: &Camera,
    kind: Light,
    state: &NodeState,
    color: Color32,
) {
    let length = RAYS / look.projection.scale() * look.projection.space().half_size;
    let right = at.view.cross(at.up);
    let axes = [right, at.up, at.view];
    match kind {
        Light::Point => {
            for way in axes.into_iter().chain(star(axes)) {
                let way = way * length;
                strokes.line(at.position - way, at.position + way, THIN, color);
            }
        }
        Light::Spot => {
            let length = 2.5 * length;
            let wide = state.cone[1].clamp(1.0, 80.0).to_radians().tan() * length;
            let rim = |k: u32| {
                let turn = std::f64::consts::TAU * f64::from(k) / 12.0;
                let out = right * turn.cos() + at.up * turn.sin();
                at.position + at.view * length + out * wide
            };
            for k in 0..12 {
                strokes.line(rim(k), rim(k + 1), THIN, color);
                if k % 3 == 0 {
                    strokes.line(at.position, rim(k), THIN, color);
                }
            }
        }
        Light::Directional => {
            for [x, y] in [[0.0, 0.0], [1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0]] {
                let from = at.position + (right * x + at.up * y) * (0.7 * length);
                let to = from + at.view * (2.5 * length);
                strokes.line(from, to, THIN, color);
            }
        }
    }
}

/// The diagonals between three axes.
fn star([x, y, z]: [DVec3; 3]) -> [DVec3; 4] {
    [x + y + z, x + y - z, x - y + z, y + z - x].map(|way| way * 0.5)
}

/// The names of the cameras, if these are few.
pub(super) fn names(editor: &Editor, painter: &Painter, look: &Look<'_>) {
    let Some(color) = look.of(Element::Numbers) else {
        return;
    };
    // An error was reported when the lines were made.
    let _ = editor.with_scene(|now| {
        let nodes = now.scene.nodes().iter().enumerate();
        let camera = |node: &Node| matches!(node.kind, Kind::Camera(_));
        let seen = nodes.filter(|(at, node)| camera(node) && now.states[*at].visible != 0);
        if seen.clone().count() > NAMES {
            return;
        }
        for (at, node) in seen {
            let weak = color.gamma_multiply(0.7);
            labels::name(painter, look, &now.camera(at), &node.name, weak);
        }
    });
}
