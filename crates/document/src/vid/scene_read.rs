//! Reads the nodes and markers of a scene from the parsed pieces of its file.

use glam::DVec3;

use super::field::{Field, Source, at_line};
use super::mesh;
use super::own::{ReadContext, read_setting};
use super::path_read::{one_line, points, space};
use super::shown::Shown;
use crate::error::{EngineError, Error, Invalid, Malformed, Place, Result, TooMany, vec_with_room};
use vides_engine::deform::{Bounds, Deformation};
use vides_engine::limits;
use vides_engine::path::{CameraPath, Space};
use vides_engine::property::find;
use vides_engine::scene::motion::check_frame;
use vides_engine::scene::node::check_node_name;
use vides_engine::scene::{
    Camera, Channel, Extrapolation, FollowPath, Interpolation, Kind, Light, Node, Object, Scene,
    Shape, Track, Values,
};
use vides_engine::shared_list::SharedList;

/// What has been read of a scene; nodes may name nodes further down.
#[derive(Default)]
pub(super) struct Drafts {
    nodes: Vec<Draft>,
    markers: Vec<(usize, String, f64)>,
    pub(super) shown: Shown,
}

/// Byte offset and name; counting lines for every node, not only for errors, would be quadratic.
type Named = (usize, String);

/// A node whose links are not resolved yet.
struct Draft {
    node: Node,
    parent: Option<Named>,
    aim: Option<Named>,
    rest: Deferred,
}

/// What is added to a node in its scene, each with its byte offset.
#[derive(Default)]
struct Deferred {
    offset: usize,
    shapes: Vec<(usize, Shape)>,
    weights: Option<(usize, Vec<f64>)>,
    tracks: Vec<(usize, Track)>,
    pins: Vec<(usize, usize, String)>,
}

fn placed(line: usize, error: EngineError) -> Error {
    match error {
        EngineError::Memory => error.into(),
        other => at_line(line, other),
    }
}

impl Drafts {
    pub(super) fn count(&self) -> usize {
        self.nodes.len()
    }

    pub(super) fn markers(&mut self, array: Field<'_>) -> Result<()> {
        for table in array.elements()? {
            let (mut name, mut frame) = (None, None);
            for field in table.fields()? {
                match field.key {
                    "name" => name = Some(node_name(field)?),
                    "frame" => {
                        let number = field.number()?;
                        field.checked(check_frame(number))?;
                        frame = Some(number);
                    }
                    _ => return Err(field.unknown(&["name", "frame"])),
                }
            }
            let (Some(name), Some(frame)) = (name, frame) else {
                return Err(table.error(Malformed::Marker));
            };
            if self.markers.len() >= limits::MAX_MARKERS {
                return Err(table.error(TooMany::Markers));
            }
            self.markers.push((table.offset(), name, frame));
        }
        Ok(())
    }

    pub(super) fn nodes(
        &mut self,
        array: Field<'_>,
        so_far: &mut ReadContext,
        space: Space,
    ) -> Result<()> {
        let elements = array.elements()?;
        self.nodes
            .try_reserve(elements.len().min(limits::MAX_NODES))?;
        for table in elements {
            if self.nodes.len() >= limits::MAX_NODES {
                return Err(table.error(TooMany::Nodes));
            }
            self.nodes.push(draft(table, so_far, space)?);
        }
        Ok(())
    }

    /// Takes out aims at nodes that are not among them.
    pub(super) fn take_aims_beyond(&mut self) -> Result<Vec<(usize, String)>> {
        let mut names: Vec<String> = vec_with_room(self.nodes.len())?;
        names.extend(self.nodes.iter().map(|draft| draft.node.name.clone()));
        names.sort_unstable();
        let mut aims = Vec::new();
        for (at, draft) in self.nodes.iter_mut().enumerate() {
            let beyond = |aim: &mut Named| names.binary_search(&aim.1).is_err();
            if let Some((_, name)) = draft.aim.take_if(beyond) {
                aims.try_reserve(1)?;
                aims.push((at, name));
            }
        }
        Ok(aims)
    }

    pub(super) fn finish(mut self, text: &str) -> Result<Scene> {
        let source = Source { text, start: 0 };
        let placed = |offset, error| placed(source.line(offset), error);
        let drafts = std::mem::take(&mut self.nodes);
        let mut numbers: Vec<usize> = vec_with_room(drafts.len())?;
        numbers.extend(0..drafts.len());
        numbers.sort_by(|&a, &b| drafts[a].node.name.cmp(&drafts[b].node.name));
        let find = |named: &Option<Named>, what: Place| {
            let Some((offset, name)) = named else {
                return Ok(None);
            };
            let found = numbers.binary_search_by(|&at| drafts[at].node.name.cmp(name));
            found.map(|at| Some(numbers[at])).map_err(|_| {
                let missing = EngineError::from(Invalid::NoNodeNamed(name.into()));
                source.complain(*offset, missing.at(what))
            })
        };
        let mut links = vec_with_room(drafts.len())?;
        for draft in &drafts {
            links.push((
                find(&draft.parent, Place::Parent)?,
                find(&draft.aim, Place::Aim)?,
            ));
        }
        let mut nodes = vec_with_room(drafts.len())?;
        let mut rests = vec_with_room(drafts.len())?;
        for (mut draft, (parent, aim)) in drafts.into_iter().zip(links) {
            draft.node.parent = parent;
            draft.node.aim = aim;
            nodes.push(draft.node);
            rests.push(draft.rest);
        }
        let mut scene = Scene::from_nodes(nodes).map_err(|(node, error)| {
            placed(rests.get(node).map_or(0, |rest| rest.offset), error)
        })?;
        let mut pins = Vec::new();
        for (node, rest) in rests.into_iter().enumerate() {
            for (offset, shape) in rest.shapes {
                scene
                    .add_shape(node, shape)
                    .map_err(|e| placed(offset, at_node(&scene, node, e)))?;
            }
            if let Some((offset, weights)) = rest.weights {
                scene
                    .set_weights(node, &weights)
                    .map_err(|e| placed(offset, at_node(&scene, node, e)))?;
            }
            for (offset, track) in rest.tracks {
                let channel = Place::Channel(track.channel().into());
                let set = match scene.nodes()[node].keys().track(track.channel()) {
                    Some(_) => Err(Invalid::GivenTwice.into()),
                    None => scene.set_track(node, track),
                };
                set.map_err(|e| placed(offset, at_node(&scene, node, e.at(channel))))?;
            }
            pins.extend(rest.pins.into_iter().map(|pin| (node, pin)));
        }
        let mut scene = self.mark(scene, text)?;
        for (node, (offset, point, marker)) in pins {
            scene
                .pin(node, point, Some(&marker))
                .map_err(|e| placed(offset, at_node(&scene, node, e)))?;
        }
        Ok(scene)
    }

    pub(super) fn mark(self, mut scene: Scene, text: &str) -> Result<Scene> {
        let source = Source { text, start: 0 };
        for (offset, name, frame) in self.markers {
            if scene.markers().iter().any(|marker| marker.name == name) {
                return Err(source.complain(offset, Malformed::MarkerTwice((&name).into())));
            }
            scene
                .set_marker(&name, frame)
                .map_err(|e| placed(source.line(offset), e))?;
        }
        self.shown.set(&mut scene, text)?;
        Ok(scene)
    }
}

fn at_node(scene: &Scene, node: usize, error: EngineError) -> EngineError {
    let name = scene.nodes()[node].name.as_str();
    error.at(Place::Node(name.into()))
}

fn node_name(field: Field<'_>) -> Result<String> {
    let name = field.text()?;
    field.checked(check_node_name(name))?;
    Ok(name.to_owned())
}

const KEYS: [&str; 24] = [
    "name",
    "kind",
    "parent",
    "aim",
    "pivot",
    "position",
    "rotation",
    "scale",
    "visible",
    "zoom_mm",
    "roll_degrees",
    "near",
    "far",
    "light",
    "colour",
    "intensity",
    "cone_degrees",
    "aim_weight",
    "mesh",
    "weights",
    "shape",
    "deformation",
    "path",
    "track",
];

fn draft(table: Field<'_>, so_far: &mut ReadContext, space: Space) -> Result<Draft> {
    let Some(name) = table.find("name")? else {
        return Err(table.error(Malformed::NoName));
    };
    let name = node_name(name)?;
    let mut draft = Draft {
        node: Node::new(&name, kind(table)?),
        parent: None,
        aim: None,
        rest: Deferred {
            offset: table.offset(),
            ..Deferred::default()
        },
    };
    let (node, added) = (&mut draft.node, &mut draft.rest);
    for field in table.fields()? {
        match field.key {
            "name" | "kind" => {}
            "position" => node.rest.position = field.vector()?,
            "scale" => node.rest.scale = field.vector()?,
            "parent" => draft.parent = Some((field.offset(), field.text()?.to_owned())),
            "aim" => draft.aim = Some((field.offset(), field.text()?.to_owned())),
            "pivot" => node.pivot = field.vector()?,
            "near" | "far" => {
                let Kind::Camera(camera) = &mut node.kind else {
                    return Err(misplaced(&field, &node.kind));
                };
                let plane = if field.key == "near" {
                    &mut camera.near
                } else {
                    &mut camera.far
                };
                *plane = field.number()?;
            }
            "light" => {
                let Kind::Light(light) = &mut node.kind else {
                    return Err(misplaced(&field, &node.kind));
                };
                *light = field.choice()?;
            }
            "mesh" => {
                let (source, mesh) = mesh::read(field)?;
                let Kind::Object(object) = &mut node.kind else {
                    return Err(misplaced(&field, &node.kind));
                };
                field.checked(object.set_mesh(mesh))?;
                field.checked(object.set_source(source))?;
            }
            "deformation" => {
                let Kind::Object(object) = &mut node.kind else {
                    return Err(misplaced(&field, &node.kind));
                };
                for element in field.elements()? {
                    let (deformation, bounds) = deformation(element)?;
                    element.checked(object.add_deformation(deformation, bounds))?;
                }
            }
            "shape" => {
                for element in field.elements()? {
                    added.shapes.push((element.offset(), shape(element)?));
                }
            }
            "weights" => added.weights = Some((field.offset(), numbers(field, None)?)),
            "path" => {
                let path = path(field, so_far, &mut added.pins, space)?;
                field.checked(node.set_path(Some(path)))?;
            }
            "track" => {
                for element in field.elements()? {
                    added
                        .tracks
                        .push((element.offset(), track(element, &name)?));
                }
            }
            key => {
                let row = find(Values::PROPERTIES, key).ok_or_else(|| field.unknown(&KEYS))?;
                let mut value = field.plain(row.kind(key), row.range)?;
                (row.exchange)(&mut node.rest, &mut value);
            }
        }
    }
    let named = |error: EngineError| error.at(Place::Node((&name).into()));
    let checked = draft.node.check().map_err(named);
    checked.map_err(|error| placed(table.line(), error))?;
    Ok(draft)
}

fn misplaced(field: &Field<'_>, kind: &Kind) -> Error {
    field.error(Malformed::NotOfKind(kind.name()))
}

fn kind(table: Field<'_>) -> Result<Kind> {
    let Some(field) = table.find("kind")? else {
        return Err(table.error(Malformed::NoKind));
    };
    let kinds = [
        Kind::Group,
        Kind::Object(Object::default()),
        Kind::Light(Light::default()),
        Kind::Camera(Camera::default()),
    ];
    field.one_of(&["group", "object", "light", "camera"], kinds)
}

fn numbers(array: Field<'_>, rows: Option<usize>) -> Result<Vec<f64>> {
    let elements = array.elements()?;
    let mut all: Vec<f64> = Vec::new();
    all.try_reserve(elements.len())?;
    let count = elements.len();
    let mut width = None;
    for element in elements {
        if !element.is_array() {
            if width.is_some() {
                return Err(element.error(Malformed::RowsBefore));
            }
            all.try_reserve(1)?;
            all.push(element.number()?);
            continue;
        }
        let row = element.elements()?;
        if width.is_none() && !all.is_empty() {
            return Err(element.error(Malformed::NumbersBefore));
        }
        if *width.get_or_insert(row.len()) != row.len() {
            let wanted = width.unwrap_or_default();
            return Err(element.error(Malformed::NumberCount {
                wanted,
                found: row.len(),
            }));
        }
        all.try_reserve(row.len())?;
        for number in row {
            all.push(number.number()?);
        }
    }
    if let Some(rows) = rows.filter(|&rows| rows != count) {
        return Err(array.error(Malformed::ValueCount {
            keys: rows,
            values: count,
        }));
    }
    Ok(all)
}

fn shape(table: Field<'_>) -> Result<Shape> {
    let mut shape = Shape {
        name: String::new(),
        points: Vec::new(),
        colours: Vec::new(),
    };
    for field in table.fields()? {
        match field.key {
            "name" => shape.name = one_line(field)?,
            "points" => shape.points = mesh::vectors(field, limits::MAX_MESH_POINTS)?,
            "colours" => shape.colours = mesh::colours(field)?,
            _ => return Err(field.unknown(&["name", "points", "colours"])),
        }
    }
    Ok(shape)
}

fn deformation(table: Field<'_>) -> Result<(Deformation, Option<Bounds>)> {
    let (mut kind, mut parameters, mut bounds) = (None, Vec::new(), None);
    for field in table.fields()? {
        match field.key {
            "kind" => kind = Some(field.text()?),
            "parameters" => parameters = numbers(field, None)?,
            "box" => {
                let [a, b, c, d, e, f] = field.numbers()?;
                let made = Bounds::new(DVec3::new(a, b, c), DVec3::new(d, e, f));
                bounds = Some(field.checked(made)?);
            }
            _ => return Err(field.unknown(&["kind", "parameters", "box"])),
        }
    }
    let Some(kind) = kind else {
        return Err(table.error(Malformed::NoDeformationKind));
    };
    let made = table.checked(Deformation::new(kind, &parameters))?;
    Ok((made, bounds))
}

fn path(
    table: Field<'_>,
    so_far: &mut ReadContext,
    pins: &mut Vec<(usize, usize, String)>,
    space: Space,
) -> Result<FollowPath> {
    let mut path = CameraPath {
        points: SharedList::new(),
        space,
        ..CameraPath::default()
    };
    if let Some(own) = table.find("space")? {
        self::space(own, &mut path.space, None)?;
    }
    let (mut start, mut after) = (1.0, Extrapolation::Hold);
    so_far.up_paths = Default::default();
    for field in table.fields()? {
        match field.key {
            "start_frame" => start = field.number()?,
            "beyond" => after = field.choice()?,
            "point" => points(field, &mut path.points, so_far, path.space)?,
            "space" => {}
            "pins" => {
                for element in field.elements()? {
                    pins.push(pin(element)?);
                }
            }
            _ if read_setting(field, &mut path)? => {}
            _ => {
                return Err(field.unknown(&[
                    "start_frame",
                    "beyond",
                    "closed",
                    "curve",
                    "orientation_mode",
                    "zoom_mode",
                    "base_speeds",
                    "presets",
                    "space",
                    "point",
                    "pins",
                ]));
            }
        }
    }
    table.checked(FollowPath::new(path, start, after))
}

fn pin(table: Field<'_>) -> Result<(usize, usize, String)> {
    let (mut point, mut marker) = (None, None);
    for field in table.fields()? {
        match field.key {
            "point" => point = Some(field.integer_in(0, limits::MAX_POINTS as i64)? as usize),
            "marker" => marker = Some(node_name(field)?),
            _ => return Err(field.unknown(&["point", "marker"])),
        }
    }
    match (point, marker) {
        (Some(point), Some(marker)) => Ok((table.offset(), point, marker)),
        _ => Err(table.error(Malformed::Pin)),
    }
}

pub(super) fn track(table: Field<'_>, node: &str) -> Result<Track> {
    let complain = |field: &Field<'_>, error: EngineError| {
        // Copied keys of one node alone have none.
        let error = match node.is_empty() {
            true => error,
            false => error.at(Place::Node(node.into())),
        };
        placed(field.line(), error)
    };
    let (mut channel, mut interpolation) = (None, None);
    let (mut before, mut after) = (Extrapolation::Hold, Extrapolation::Hold);
    let (mut frames, mut values, mut shape) = (None, None, Vec::new());
    for field in table.fields()? {
        match field.key {
            "channel" => {
                let made = Channel::parse(field.text()?);
                channel = Some(made.map_err(|error| complain(&field, error))?);
            }
            "interpolation" => {
                let made = Interpolation::parse(field.text()?);
                interpolation = Some(made.map_err(|error| complain(&field, error))?);
            }
            "before" => before = field.choice()?,
            "after" => after = field.choice()?,
            "frames" => frames = Some(numbers(field, None)?),
            "values" => values = Some(field),
            "shape" => shape = numbers(field, None)?,
            _ => {
                return Err(field.unknown(&[
                    "channel",
                    "interpolation",
                    "before",
                    "after",
                    "frames",
                    "values",
                    "shape",
                ]));
            }
        }
    }
    let (Some(channel), Some(interpolation), Some(frames), Some(values)) =
        (channel, interpolation, frames, values)
    else {
        return Err(table.error(Malformed::Track));
    };
    let values = numbers(values, Some(frames.len()))?;
    Track::new(channel, interpolation, frames, values, shape)
        .and_then(|track| track.with_extrapolation(before, after))
        .map_err(|error| complain(&table, error))
}
