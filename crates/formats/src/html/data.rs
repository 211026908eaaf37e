//! The flight as the page's scripts read it (`flight.js`): JSON, long lists of numbers in base64.
//! Places are relative to the middle of the space, or of the object, so that 32 bits are enough.

use std::cell::RefCell;
use std::io::Write;

use glam::{DAffine3, DVec3};
use serde_json::{Value, json};
use vides_document::error::vec_with_room;
use vides_engine::path::{Change, Timeline};
use vides_engine::scene::{Channel, Kind, Mesh, NodeState};
use vides_mesh::srgb;

use crate::base64::Base64;
use crate::blocks::failed;
use crate::error::Result;
use crate::flight::Flight;
use crate::loss::{Loss, Report};

/// Bytes of text that are written at once.
const BLOCK: usize = 1 << 16;

/// JSON in which no `<` stands; it can stand in texts only, and is the same there as `\u003c`.
fn text(value: &Value) -> Vec<u8> {
    value.to_string().replace('<', "\\u003c").into_bytes()
}

/// An object without its closing brace.
fn open(value: &Value) -> Vec<u8> {
    let mut text = text(value);
    text.pop();
    text
}

/// Writes the flight, and reports what the page does not show.
pub(super) fn write(
    flight: &mut Flight<'_>,
    out: &mut dyn Write,
    report: &mut Report,
) -> Result<()> {
    tell(flight, report);
    let (info, space) = (flight.info(), flight.scene().space());
    let centre = flight.place(space.centre);
    let mut head = open(&json!({
        "title": info.title,
        "comment": info.comment,
        "unit": info.unit,
        "fps": flight.fps(),
        "first_frame": flight.number(0),
        "frame_step": flight.first_and_step().1,
        "up": flight.up().name(),
        "size": flight.size(),
        "space": { "centre": centre.to_array(), "half": space.half_size * flight.options().scale },
        "points": points(flight)?,
    }));
    head.extend(b",\"objects\":[");
    out.write_all(&head).map_err(failed)?;
    let mut list = List { out, begun: false };
    wireframe(flight, centre, &mut list)?;
    for (at, node) in flight.scene().nodes().iter().enumerate() {
        if let Kind::Object(object) = &node.kind
            && !object.mesh().points.is_empty()
        {
            placed(flight, at, object.mesh(), centre, &mut list)?;
        }
    }
    let digits = RefCell::new(Base64::default());
    flight.write_poses(b"],\"poses\":\"".to_vec(), out, |_, text, _, pose| {
        let [x, y, z] = (pose.position() - centre).to_array();
        let q = pose.rotation();
        let numbers = [x, y, z, q.w, q.x, q.y, q.z, pose.zoom].map(|number| number as f32);
        digits.borrow_mut().push_floats(&numbers, text);
    })?;
    let mut tail = Vec::new();
    digits.into_inner().finish(&mut tail);
    tail.extend(b"\"}");
    out.write_all(&tail).map_err(failed)
}

fn tell(flight: &Flight<'_>, report: &mut Report) {
    let nodes = flight.scene().nodes();
    let count = |test: fn(&Kind) -> bool| nodes.iter().filter(|node| test(&node.kind)).count();
    report.count(
        count(|kind| matches!(kind, Kind::Light(_))),
        Loss::OtherNodes,
    );
    let cameras = count(|kind| matches!(kind, Kind::Camera(_)));
    report.count(cameras - 1, Loss::OtherCameras);
    let deformed = count(|kind| match kind {
        Kind::Object(object) => !object.deformations().is_empty() || !object.shapes().is_empty(),
        _ => false,
    });
    report.count(deformed, Loss::Deformations);
    let tracks = || nodes.iter().flat_map(|node| node.keys().tracks());
    let hosts = tracks().filter(|track| matches!(track.channel(), Channel::Value { .. }));
    report.count(hosts.count(), Loss::HostChannels);
    let colours = tracks().filter(|track| *track.channel() == Channel::Colour);
    report.count(colours.count(), Loss::ColourTracks);
    if nodes[flight.node()].aim.is_some() {
        report.add(Loss::Aims(1));
    }
    if nodes[flight.node()].path().is_some() {
        report.add(Loss::Path);
    }
}

/// The support points that the camera passes in these frames, where it passes them first.
fn points(flight: &Flight<'_>) -> Result<Vec<Value>> {
    let Some(follow) = flight.scene().nodes()[flight.node()].path() else {
        return Ok(Vec::new());
    };
    let path = follow.path();
    let timeline = Timeline::new(path)?;
    let mut passed = vec_with_room(path.points.len())?;
    let mut frame = follow.start_frame();
    for section in (0..timeline.section_count()).map(|at| timeline.section(at)) {
        if section.orientation == 0 {
            passed.push((section.point, frame));
        }
        if section.change != Change::Nothing {
            let key = &path.points[section.point].orientations[section.orientation];
            frame += f64::from(key.hold) + section.frames as f64;
        }
    }
    let last = path.points.len() - 1;
    if !path.closed && path.points[last].orientations.len() == 1 {
        passed.push((last, frame));
    }
    let (first, step) = flight.first_and_step();
    let end = flight.frame(flight.count() - 1);
    let mut points = vec_with_room(passed.len())?;
    for (point, frame) in passed {
        if (first..=end).contains(&frame) {
            let state = state_at(flight, flight.node(), frame)?;
            points.push(json!({
                "number": point + 1,
                "name": path.points[point].name,
                "frame": (frame - first) / step,
                "position": flight.place(state.pose.position()).to_array(),
            }));
        }
    }
    Ok(points)
}

fn state_at(flight: &Flight<'_>, node: usize, frame: f64) -> Result<NodeState> {
    let mut state = [NodeState::default()];
    let warnings = &mut vides_engine::scene::Warnings::default();
    flight
        .scene()
        .sample(node, frame, 1.0, &mut state, warnings)?;
    Ok(state[0])
}

/// Objects, written one behind the other.
struct List<'a> {
    out: &'a mut dyn Write,
    begun: bool,
}

impl List<'_> {
    /// Writes `mesh` at the `matrices` of its middle, one a frame or one for all frames; `dots`:
    /// points of no line and no face are drawn.
    fn write(
        &mut self,
        mesh: &Mesh,
        colour: Option<[u8; 3]>,
        dots: bool,
        matrices: impl FnOnce(DVec3) -> Result<Vec<[f32; 12]>>,
    ) -> Result<()> {
        let (low, high) = mesh.points.iter().fold(
            (DVec3::INFINITY, DVec3::NEG_INFINITY),
            |(low, high), &point| (low.min(point), high.max(point)),
        );
        let middle = 0.5 * low + 0.5 * high;
        let comma: &[u8] = if self.begun { b"," } else { b"" };
        self.begun = true;
        self.out.write_all(comma).map_err(failed)?;
        let head = open(&json!({ "dots": dots, "colour": colour }));
        self.out.write_all(&head).map_err(failed)?;
        let points = mesh.points.iter();
        let float = |point: &DVec3| (*point - middle).as_vec3().to_array();
        self.list("points", points.flat_map(float).map(f32::to_le_bytes))?;
        let lines = mesh.lines.as_flattened().iter();
        self.list("lines", lines.copied().map(u32::to_le_bytes))?;
        let triangles = mesh.triangles.as_flattened().iter();
        self.list("triangles", triangles.copied().map(u32::to_le_bytes))?;
        self.list("colours", mesh.colours.iter().copied())?;
        let matrices = matrices(middle)?;
        let numbers = matrices.as_flattened().iter();
        self.list("matrices", numbers.copied().map(f32::to_le_bytes))?;
        self.out.write_all(b"}").map_err(failed)
    }

    fn list<const N: usize>(
        &mut self,
        name: &str,
        pieces: impl Iterator<Item = [u8; N]>,
    ) -> Result<()> {
        let mut text = format!(",\"{name}\":\"").into_bytes();
        let mut digits = Base64::default();
        for piece in pieces {
            digits.push(&piece, &mut text);
            if text.len() >= BLOCK {
                self.out.write_all(&text).map_err(failed)?;
                text.clear();
            }
        }
        digits.finish(&mut text);
        text.push(b'"');
        self.out.write_all(&text).map_err(failed)
    }
}

/// Three axes and the origin; all NaN: not seen.
fn matrix(world: DAffine3, middle: DVec3, centre: DVec3) -> [f32; 12] {
    let origin = world.transform_point3(middle) - centre;
    let moved = DAffine3::from_mat3_translation(world.matrix3, origin);
    moved.to_cols_array().map(|number| number as f32)
}

/// The document's own object: its lines and isolated points, and the faces that it is of.
fn wireframe(flight: &Flight<'_>, centre: DVec3, list: &mut List<'_>) -> Result<()> {
    let object = &flight.info().object;
    let at_rest = |middle| Ok(vec![matrix(flight.to_file(), middle, centre)]);
    let mut drawn = Mesh {
        points: vec_with_room(2 * object.len())?,
        ..Mesh::default()
    };
    let coloured = object.lines().any(|(_, colour)| colour.is_some());
    for ([from, to], colour) in object.lines() {
        let at = drawn.points.len() as u32;
        drawn.points.push(from);
        if from != to {
            drawn.points.push(to);
            drawn.lines.push([at, at + 1]);
        }
        if coloured {
            let count = drawn.points.len();
            drawn.colours.resize(count, colour.unwrap_or_default());
        }
    }
    if !drawn.points.is_empty() {
        list.write(&drawn, None, true, at_rest)?;
    }
    match object.mesh().filter(|mesh| !mesh.triangles.is_empty()) {
        Some(mesh) => {
            let faces = Mesh {
                lines: Vec::new(),
                ..mesh.clone()
            };
            list.write(&faces, None, false, at_rest)
        }
        None => Ok(()),
    }
}

/// An object of the scene, where it is at each frame.
fn placed(
    flight: &Flight<'_>,
    node: usize,
    mesh: &Mesh,
    centre: DVec3,
    list: &mut List<'_>,
) -> Result<()> {
    let count = if moves(flight, node) {
        flight.count()
    } else {
        1
    };
    let states = flight.states(node, 0, count)?;
    // White is what an object has that was given no colour: that of the page then.
    let colour = Some(states[0].colour).filter(|colour| *colour != [1.0; 3]);
    list.write(
        mesh,
        colour.map(|colour| colour.map(srgb::byte)),
        true,
        |middle| {
            let mut matrices = vec_with_room(count)?;
            matrices.extend(states.iter().map(|state| match state.visible {
                0 => [f32::NAN; 12],
                _ => matrix(flight.to_file() * state.world(), middle, centre),
            }));
            Ok(matrices)
        },
    )
}

/// Whether a node or one that it is in has keys or a path.
fn moves(flight: &Flight<'_>, node: usize) -> bool {
    let nodes = flight.scene().nodes();
    let chain = std::iter::successors(Some(node), |&at| nodes[at].parent);
    chain
        .into_iter()
        .any(|at| nodes[at].path().is_some() || !nodes[at].keys().tracks().is_empty())
}
