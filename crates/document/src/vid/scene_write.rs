//! From a scene to the text of its `.vid` file.

use std::fmt::{self, Write, from_fn};
use std::path::Path;

use glam::DVec3;

use super::alone::alone;
use super::comments::Comments;
use super::own::UpPaths;
use super::text::{Quoted, Text, plain, rows};
use super::write::{base_speeds, head, place, point, shape_and_modes, space, to_toml};
use super::{mesh, mesh_source, pieces, shown};
use crate::error::{EngineError, Result};
use crate::info::Info;
use vides_engine::deform::{Bounds, Deformation};
use vides_engine::path::Space;
use vides_engine::path::camera_path::DEFAULT_PRESETS;
use vides_engine::property::{SameBits, Value};
use vides_engine::scene::{
    Camera, Extrapolation, FollowPath, Kind, Light, Node, Object, Pin, Scene, Shape, Track, Values,
};

/// The text of a scene, or of its path if it is just a camera on that; refused if it is too long to
/// be read. Node values equal to the defaults are omitted; mesh files are named relative to
/// `folder`.
pub(crate) fn scene_to_toml(
    scene: &Scene,
    info: &Info,
    comments: &Comments,
    folder: Option<&Path>,
) -> Result<String> {
    if let Some(path) = alone(scene) {
        let comments = comments.of_path_alone(scene.ids()[0]);
        return to_toml(path.path(), info, &comments, folder);
    }
    let mut out = Text(String::new());
    // Only running out of memory fails here.
    document(&mut out, scene, info, folder).map_err(|_| EngineError::Memory)?;
    comments
        .put_into(out.0, scene.ids())
        .and_then(pieces::readable)
}

/// The text of these nodes of a scene, without pins; in others they are no longer.
pub(crate) fn nodes_to_toml(scene: &Scene, which: &[bool], info: &Info) -> Result<String> {
    let mut out = Text(String::new());
    let mut write = || {
        head(&mut out, info)?;
        space(&mut out, scene.space(), info, None)?;
        let nodes = scene.nodes().iter().zip(which);
        for (of, _) in nodes.filter(|(_, chosen)| **chosen) {
            match of.parent.is_some_and(|parent| !which[parent]) {
                true => {
                    let mut top = of.clone();
                    top.parent = None;
                    node(&mut out, scene, &top, &[], None)?;
                }
                false => node(&mut out, scene, of, &[], None)?,
            }
        }
        Ok(())
    };
    // Only running out of memory fails here.
    write().map_err(|_: fmt::Error| EngineError::Memory)?;
    pieces::readable(out.0)
}

fn document(out: &mut Text, scene: &Scene, info: &Info, folder: Option<&Path>) -> fmt::Result {
    head(out, info)?;
    shown::write(out, scene)?;
    if scene.nodes().is_empty() {
        writeln!(out, "node = []")?;
    }
    space(out, scene.space(), info, folder)?;
    for marker in scene.markers() {
        writeln!(out, "\n[[marker]]\nname = {}", Quoted(&marker.name))?;
        writeln!(out, "frame = {:?}", marker.frame)?;
    }
    let mut pins = scene.pins();
    for (at, node) in scene.nodes().iter().enumerate() {
        let own = pins.partition_point(|pin| pin.node <= at);
        let (here, rest) = pins.split_at(own);
        pins = rest;
        self::node(out, scene, node, here, folder)?;
    }
    Ok(())
}

fn node(
    out: &mut Text,
    scene: &Scene,
    node: &Node,
    pins: &[Pin],
    folder: Option<&Path>,
) -> fmt::Result {
    writeln!(out, "\n[[node]]\nname = {}", Quoted(&node.name))?;
    writeln!(out, "kind = \"{}\"", node.kind.name())?;
    for (key, link) in [("parent", node.parent), ("aim", node.aim)] {
        if let Some(link) = link {
            writeln!(out, "{key} = {}", Quoted(&scene.nodes()[link].name))?;
        }
    }
    if !node.pivot.same_bits(&DVec3::ZERO) {
        writeln!(out, "pivot = {:?}", node.pivot.to_array())?;
    }
    for row in Values::PROPERTIES {
        plain(out, row, &node.rest, &Values::NEW)?;
    }
    match &node.kind {
        Kind::Group => {}
        Kind::Camera(Camera { near, far }) => {
            writeln!(out, "near = {near:?}\nfar = {far:?}")?;
        }
        Kind::Light(light) => {
            let light: Light = *light;
            writeln!(out, "light = \"{}\"", light.name())?;
        }
        Kind::Object(object) => self::object(out, object, folder)?,
    }
    if let Some(path) = node.path() {
        self::path(out, path, pins, scene.space())?;
    }
    let mut tracks = node.keys().tracks().iter();
    tracks.try_for_each(|track| self::track(out, track))
}

fn object(out: &mut Text, object: &Object, folder: Option<&Path>) -> fmt::Result {
    if object.weights().iter().any(|weight| weight.to_bits() != 0) {
        writeln!(out, "weights = {:?}", object.weights())?;
    }
    if let Some(source) = object.source() {
        writeln!(out, "\n[node.mesh]")?;
        mesh_source::write(out, source, folder)?;
    } else if !object.mesh().points.is_empty() {
        writeln!(out, "\n[node.mesh]")?;
        mesh::write(out, object.mesh())?;
    }
    for shape in object.shapes() {
        self::shape(out, shape)?;
    }
    let mut deformations = object.deformations().iter();
    deformations.try_for_each(|(deformation, bounds)| self::deformation(out, deformation, bounds))
}

fn shape(out: &mut Text, shape: &Shape) -> fmt::Result {
    writeln!(out, "\n[[node.shape]]\nname = {}", Quoted(&shape.name))?;
    rows(out, "points", shape.points.iter().map(DVec3::to_array))?;
    rows(out, "colours", &shape.colours)
}

fn deformation(out: &mut Text, deformation: &Deformation, bounds: &Option<Bounds>) -> fmt::Result {
    writeln!(
        out,
        "\n[[node.deformation]]\nkind = \"{}\"",
        deformation.kind()
    )?;
    writeln!(out, "parameters = {:?}", deformation.parameters())?;
    if let Some(bounds) = bounds {
        let ends = [bounds.min(), bounds.max()].map(|end| end.to_array());
        writeln!(out, "box = {:?}", ends.as_flattened())?;
    }
    Ok(())
}

fn path(out: &mut Text, follow: &FollowPath, pins: &[Pin], space: Space) -> fmt::Result {
    let path = follow.path();
    writeln!(
        out,
        "\n[node.path]\nstart_frame = {:?}",
        follow.start_frame()
    )?;
    writeln!(out, "beyond = \"{}\"", follow.extrapolation().name())?;
    shape_and_modes(out, path)?;
    let pins = pins.iter().map(|pin| {
        let (point, marker) = (pin.point, Quoted(&pin.marker));
        from_fn(move |out| write!(out, "{{ point = {point}, marker = {marker} }}"))
    });
    rows(out, "pins", pins)?;
    writeln!(out, "\n[node.path.base_speeds]")?;
    base_speeds(out, path)?;
    writeln!(out, "\n[node.path.presets]")?;
    for (number, preset) in path.presets.iter().enumerate() {
        if !preset.same_bits(&DEFAULT_PRESETS[number]) {
            writeln!(out, "{number} = {}", Value::Shape(*preset))?;
        }
    }
    if path.space != space {
        writeln!(out, "\n[node.path.space]")?;
        place(out, path.space)?;
    }
    let mut points = path.points.iter();
    let mut up_paths = UpPaths::default();
    points.try_for_each(|point| self::point(out, "node.path.point", point, &mut up_paths))
}

pub(super) fn track(out: &mut Text, track: &Track) -> fmt::Result {
    let channel = track.channel().to_string();
    let interpolation = track.interpolation().to_string();
    writeln!(out, "\n[[node.track]]\nchannel = {}", Quoted(&channel))?;
    writeln!(out, "interpolation = {}", Quoted(&interpolation))?;
    let (before, after) = track.extrapolation();
    for (key, beyond) in [("before", before), ("after", after)] {
        if beyond != Extrapolation::Hold {
            writeln!(out, "{key} = \"{}\"", beyond.name())?;
        }
    }
    writeln!(out, "frames = {:?}", track.frames())?;
    keys(out, "values", track.values(), track.frames().len())?;
    keys(out, "shape", track.shape(), track.frames().len())
}

/// A track's numbers: on one line if there is one per key, else a row per key.
fn keys(out: &mut Text, key: &str, numbers: &[f64], count: usize) -> fmt::Result {
    let width = numbers.len() / count;
    if width == 1 {
        return writeln!(out, "{key} = {numbers:?}");
    }
    rows(out, key, numbers.chunks_exact(width.max(1)))
}
