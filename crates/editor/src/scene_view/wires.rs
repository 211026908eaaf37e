//! What is drawn of a scene, as lines in the world.

use glam::{DAffine3, DVec3};
use vides_document::Document;
use vides_document::error::Result;
use vides_engine::path::curve;
use vides_engine::scene::{Kind, Mesh, Node, Warnings};

use super::edges::{Drawn, Edges};
use crate::state::Editor;
use crate::state::scene_view::Now;

/// A line of an object; one without length is a point.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Wire {
    /// The object.
    pub(crate) node: usize,
    pub(crate) ends: [DVec3; 2],
    /// The object's, linear.
    pub(crate) colour: [f64; 3],
}

/// Pieces of all other paths together.
const PIECES: usize = 4_000;

/// Pieces of one segment of them, at most.
const OF_SEGMENT: usize = 24;

/// The lines of all visible objects.
pub(crate) fn wires(editor: &Editor, now: &Now, take: impl FnMut(Wire)) {
    of_objects(&mut editor.scene_view.edges.borrow_mut(), now, take);
}

/// The lines of a scene at its first frame: objects and other paths.
pub(crate) fn outline(document: &Document) -> Result<Vec<[DVec3; 2]>> {
    let mut lines = Vec::new();
    if let Some(now) = Now::of(document, 1.0, None)? {
        of_objects(&mut Edges::default(), &now, |wire| lines.push(wire.ends));
        other_paths(&now, |_, ends| lines.push(ends));
    }
    Ok(lines)
}

fn of_objects(edges: &mut Edges, now: &Now, mut take: impl FnMut(Wire)) {
    each_object(edges, now, |node, object| {
        let world = object.world;
        let place = |at: u32| world.transform_point3(object.points[at as usize]);
        for &[a, b] in object.drawn.wires(object.mesh) {
            take(Wire {
                node,
                ends: [place(a), place(b)],
                colour: object.colour,
            });
        }
    });
}

/// A visible object of the scene as it is now.
pub(crate) struct Seen<'a> {
    pub(crate) mesh: &'a Mesh,
    /// Those of the mesh, or where its deformations bring them.
    pub(crate) points: &'a [DVec3],
    pub(crate) world: DAffine3,
    /// Linear.
    pub(crate) colour: [f64; 3],
    pub(crate) drawn: &'a mut Drawn,
}

/// All of them, each with its node.
pub(crate) fn each_object(edges: &mut Edges, now: &Now, mut take: impl FnMut(usize, Seen<'_>)) {
    let mut moved = Vec::new();
    for (at, node) in now.scene.nodes().iter().enumerate() {
        let state = &now.states[at];
        let Kind::Object(object) = &node.kind else {
            continue;
        };
        if state.visible == 0 {
            continue;
        }
        let mesh = object.mesh();
        let mut points: &[DVec3] = &mesh.points;
        if !object.shapes().is_empty() || !object.deformations().is_empty() {
            moved.clear();
            moved.resize(points.len(), DVec3::ZERO);
            let warnings = &mut Warnings::default();
            let done = now.scene.vertices(at, now.frame, &mut moved, warnings);
            if done.is_ok() {
                points = &moved;
            }
        }
        let seen = Seen {
            mesh,
            points,
            world: state.world(),
            colour: state.colour,
            drawn: edges.of(now.meshes, at),
        };
        take(at, seen);
    }
}

/// The curves of all paths but the edited one, piece by piece, each with its node.
pub(crate) fn other_paths(now: &Now, mut take: impl FnMut(usize, [DVec3; 2])) {
    let others = |&(at, node): &(usize, &Node)| Some(at) != now.edited && node.path().is_some();
    let nodes = || now.scene.nodes().iter().enumerate().filter(others);
    let segments = |node: &Node| {
        node.path()
            .map_or(0, |follow| follow.path().segment_count())
    };
    let all: usize = nodes().map(|(_, node)| segments(node)).sum();
    let steps = (PIECES / all.max(1)).clamp(1, OF_SEGMENT);
    let every = all.div_ceil(PIECES).max(1);
    for (at, node) in nodes() {
        let Some(follow) = node.path() else {
            continue;
        };
        let world = node.parent.map(|parent| now.states[parent].world());
        let place = |at: DVec3| world.map_or(at, |world| world.transform_point3(at));
        for segment in (0..segments(node)).step_by(every) {
            let curve = curve::segment(follow.path(), segment);
            #[allow(clippy::cast_precision_loss)]
            let along = |step: usize| place(curve.point(step as f64 / steps as f64));
            for step in 0..steps {
                take(at, [along(step), along(step + 1)]);
            }
        }
    }
}
