//! The scene around the path at the playhead: its objects, lights, cameras and other paths.

use std::sync::Arc;

use egui::{Color32, Painter, Rgba};
use glam::DVec3;
use vides_engine::scene::{Kind, Light, Node, NodeState};

use super::cameras::{self, Camera};
use super::overlay;
use super::scene::{Look, LookKey, THIN};
use super::strokes::Strokes;
use crate::error::Result;
use crate::raster::Lines;
use crate::scene_view::{Now, other_paths, wires};
use crate::setup::Element;
use crate::state::Editor;

/// Length of a camera's edges and of a light's rays, in points.
const CAMERA: f64 = 34.0;
const RAYS: f64 = 12.0;

/// With more cameras than this the names would hide them.
const NAMES: usize = 12;

/// The lines made last, and what they were made of.
#[derive(Debug, Default)]
pub(super) struct Nodes {
    made: Option<(LookKey, (u64, u64), f64)>,
    lines: Arc<Lines>,
}

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
        other_paths(now, |ends| {
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
    if let Some(color) = look.of(Element::Cameras) {
        let player = look.of(Element::Player).unwrap_or(color);
        for (at, node) in now.scene.nodes().iter().enumerate() {
            let state = &now.states[at];
            if state.visible == 0 {
                continue;
            }
            let seen = now.camera(at);
            match node.kind {
                Kind::Camera(_) if Some(at) == now.scene.shown_camera() => {
                    cameras::camera(&mut strokes, look, &seen, CAMERA * 1.2, 1.8, player);
                }
                Kind::Camera(_) => {
                    cameras::camera(&mut strokes, look, &seen, CAMERA, THIN, color);
                }
                Kind::Light(kind) => light(&mut strokes, look, &seen, kind, state, color),
                _ => {}
            }
        }
    }
    strokes.finish()
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
            overlay::name(painter, look, &now.camera(at), &node.name, weak);
        }
    });
}
