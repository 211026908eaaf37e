//! A document as nodes, cameras, lights, meshes and one animation.
//!
//! A camera or light looks along −z there: without children it is one node that is turned, with
//! children it hangs on a child that is. Where something above scales, its place is no rotation
//! and position: it stands at the top, frame by frame. A pivot is a child that moves back.

use glam::{DAffine3, DQuat, DVec3};
use serde_json::{Map, Value, json};
use vides_document::error::{Place as ScenePlace, vec_with_room};
use vides_engine::scene::{
    Channel, Interpolation, Kind, Motion, Node, NodeState, Track, Values, Warnings,
};

use super::binary::Binary;
use super::keys::{self, Animation, Continued, Keys, Place, Target, stored};
use super::meshes::Meshes;
use super::{TURNED, extensions};
use crate::convention;
use crate::error::Result;
use crate::flight::Flight;
use crate::loss::{Loss, Report};
use crate::math::camera::CameraAxes;
use crate::math::orientation::quaternion_from_view;
use crate::path::Pose;

/// States that are asked for at a time.
const BLOCK: usize = 512;

/// A node that is written.
struct Out {
    json: Map<String, Value>,
    children: Vec<usize>,
}

/// The numbers of what a node of ours became.
#[derive(Clone, Copy)]
struct Became {
    /// None: only its camera or light is there, at the top.
    node: Option<usize>,
    /// What holds mesh and children.
    inner: Option<usize>,
}

#[derive(Default)]
struct Counts {
    aims: usize,
    interpolations: usize,
    deformations: usize,
    host: usize,
    sheared: usize,
    paths: usize,
}

pub(super) struct Writer<'f, 'd> {
    flight: &'f Flight<'d>,
    pub(super) binary: Binary,
    nodes: Vec<Out>,
    roots: Vec<usize>,
    cameras: Vec<Value>,
    pub(super) lights: Vec<Value>,
    meshes: Meshes,
    pub(super) animation: Animation,
    counts: Counts,
    hides: bool,
}

/// What holds at a frame of a node's own values.
pub(super) fn values(node: &Node, frame: f64, warnings: &mut Warnings) -> Result<Values> {
    let mut values = node.rest;
    if let Some(path) = node.path() {
        path.at(frame, &mut values, warnings)?;
    }
    node.keys().at(frame, &mut values, warnings)?;
    Ok(values)
}

fn aims(node: &Node) -> bool {
    node.aim.is_some()
        && (node.rest.aim_weight > 0.0 || node.keys().track(&Channel::AimWeight).is_some())
}

/// A camera's roll goes into its rotation.
fn rolls(node: &Node) -> bool {
    matches!(node.kind, Kind::Camera(_))
        && (node.rest.roll != 0.0 || node.keys().track(&Channel::Roll).is_some())
}

fn rolled(node: &Node, values: &Values) -> DQuat {
    if rolls(node) {
        values.rotation.normalize() * DQuat::from_rotation_z(values.roll.to_radians())
    } else {
        values.rotation.normalize()
    }
}

impl<'f, 'd> Writer<'f, 'd> {
    pub(super) fn new(flight: &'f Flight<'d>) -> Result<Self> {
        keys::check_count(flight)?;
        Ok(Self {
            flight,
            binary: Binary::default(),
            nodes: Vec::new(),
            roots: Vec::new(),
            cameras: Vec::new(),
            lights: Vec::new(),
            meshes: Meshes::default(),
            animation: Animation::default(),
            counts: Counts::default(),
            hides: false,
        })
    }

    /// All of the document.
    pub(super) fn document(&mut self) -> Result<()> {
        let nodes = self.flight.scene().nodes();
        let mut has_children: Vec<bool> = vec_with_room(nodes.len())?;
        has_children.resize(nodes.len(), false);
        for parent in nodes.iter().filter_map(|node| node.parent) {
            has_children[parent] = true;
        }
        // The shown camera is the first, which importers look through.
        let shown = self.flight.node();
        let mut order: Vec<usize> = vec_with_room(nodes.len())?;
        order.push(shown);
        order.extend((0..nodes.len()).filter(|&at| at != shown));
        let mut became: Vec<Became> = vec_with_room(nodes.len())?;
        became.resize(
            nodes.len(),
            Became {
                node: None,
                inner: None,
            },
        );
        for at in order {
            became[at] = self.node(at, has_children[at])?;
        }
        for (at, node) in nodes.iter().enumerate() {
            let Some(own) = became[at].node else { continue };
            match node.parent.and_then(|parent| became[parent].inner) {
                Some(parent) => self.nodes[parent].children.push(own),
                None => self.roots.push(own),
            }
        }
        self.object()
    }

    /// The wireframe or mesh that a path is shown with.
    fn object(&mut self) -> Result<()> {
        let object = &self.flight.info().object;
        if object.is_empty() {
            return Ok(());
        }
        let scale = self.flight.options().scale;
        let mesh = self.meshes.of_document(&mut self.binary, object, scale)?;
        let turn = convention::turn(self.flight.document_up(), self.flight.up());
        let at = self.push("object")?;
        self.nodes[at].json.insert("mesh".into(), mesh.into());
        self.set_place(at, DVec3::ZERO, turn, DVec3::ONE);
        self.roots.push(at);
        Ok(())
    }

    fn push(&mut self, name: &str) -> Result<usize> {
        let mut json = Map::new();
        json.insert("name".into(), name.into());
        self.nodes.try_reserve(1)?;
        self.nodes.push(Out {
            json,
            children: Vec::new(),
        });
        Ok(self.nodes.len() - 1)
    }

    fn set_place(&mut self, at: usize, position: DVec3, rotation: DQuat, scale: DVec3) {
        let json = &mut self.nodes[at].json;
        if position != DVec3::ZERO {
            let position = position.as_vec3().to_array();
            json.insert("translation".into(), position[..].into());
        }
        let rotation = stored(rotation);
        if rotation != [0.0, 0.0, 0.0, 1.0] {
            json.insert("rotation".into(), rotation[..].into());
        }
        if scale != DVec3::ONE {
            let scale = scale.as_vec3().to_array();
            json.insert("scale".into(), scale[..].into());
        }
    }

    fn place(&self, node: &Node, look: DQuat) -> Place {
        let flight = self.flight;
        // What lies below is turned with its root.
        let to = match node.parent {
            None => flight.up(),
            Some(_) => flight.document_up(),
        };
        let from = flight.document_up();
        Place {
            turn: convention::turn(from, to),
            from,
            to,
            scale: flight.options().scale,
            pivot: node.pivot,
            look,
        }
    }

    fn scaled_above(&self, node: &Node) -> bool {
        let nodes = self.flight.scene().nodes();
        std::iter::successors(node.parent, |&at| nodes[at].parent).any(|at| {
            let above = &nodes[at];
            above.rest.scale != DVec3::ONE || above.keys().track(&Channel::Scale).is_some()
        })
    }

    /// One node of ours.
    fn node(&mut self, at: usize, has_children: bool) -> Result<Became> {
        let node = &self.flight.scene().nodes()[at];
        self.count(node);
        if !node.kind.looks() {
            let own = self.moved(at, node, &node.name, DQuat::IDENTITY, true)?;
            let inner = self.pivot(node, own)?;
            if let Kind::Object(object) = &node.kind {
                let mesh = self.meshes.of_object(
                    self.flight,
                    &mut self.binary,
                    &mut self.animation,
                    node,
                    object,
                )?;
                if let Some(mesh) = mesh {
                    self.nodes[inner].json.insert("mesh".into(), mesh.into());
                    self.weights(inner, node)?;
                }
            }
            return Ok(Became {
                node: Some(own),
                inner: Some(inner),
            });
        }
        let scale = node.rest.scale;
        let mirrors = scale.min_element() <= 0.0 || node.keys().track(&Channel::Scale).is_some();
        let scales = scale != DVec3::ONE || mirrors;
        if self.scaled_above(node) || mirrors || (has_children && scales) {
            let own = if has_children {
                let name = format!("{} axes", node.name);
                Some(self.moved(at, node, &name, DQuat::IDENTITY, true)?)
            } else {
                None
            };
            self.at_the_top(at, node)?;
            return Ok(Became {
                node: own,
                inner: own,
            });
        }
        let look = if has_children {
            DQuat::IDENTITY
        } else {
            TURNED
        };
        let own = self.moved(at, node, &node.name, look, false)?;
        let seen = if has_children {
            let child = self.push(&format!("{} view", node.name))?;
            self.set_place(child, DVec3::ZERO, TURNED, DVec3::ONE);
            self.nodes[child]
                .json
                .insert("extras".into(), json!({"vides": {"part": "view"}}));
            self.nodes[own].children.push(child);
            child
        } else {
            own
        };
        self.view(node, seen)?;
        Ok(Became {
            node: Some(own),
            inner: Some(own),
        })
    }

    fn count(&mut self, node: &Node) {
        let counts = &mut self.counts;
        counts.aims += usize::from(aims(node));
        counts.paths += usize::from(node.path().is_some());
        if let Kind::Object(object) = &node.kind {
            counts.deformations += usize::from(!object.deformations().is_empty());
        }
        for track in node.keys().tracks() {
            match track.channel() {
                Channel::Value { .. } => counts.host += 1,
                Channel::Position | Channel::Rotation | Channel::Scale | Channel::Weights => {
                    let known = matches!(
                        track.interpolation(),
                        Interpolation::Step | Interpolation::Linear | Interpolation::Hermite
                    );
                    counts.interpolations += usize::from(!known);
                }
                _ => {}
            }
        }
    }

    /// The node that holds mesh and children where there is a pivot.
    fn pivot(&mut self, node: &Node, own: usize) -> Result<usize> {
        if node.pivot == DVec3::ZERO {
            return Ok(own);
        }
        let back = -node.pivot * self.flight.options().scale;
        let child = self.push(&format!("{} pivot", node.name))?;
        self.set_place(child, back, DQuat::IDENTITY, DVec3::ONE);
        let extras = |value: Value| json!({"vides": value});
        let pivot = (-back).to_array();
        self.nodes[child]
            .json
            .insert("extras".into(), extras(json!({"part": "pivot"})));
        self.nodes[own]
            .json
            .insert("extras".into(), extras(json!({"pivot": pivot})));
        self.nodes[own].children.push(child);
        Ok(child)
    }

    /// A node with its place, its motion and whether it is seen.
    fn moved(
        &mut self,
        at: usize,
        node: &Node,
        name: &str,
        look: DQuat,
        scales: bool,
    ) -> Result<usize> {
        let own = self.push(name)?;
        let place = self.place(node, look);
        let flight = self.flight;
        let track = |channel| node.keys().track(&channel);
        let path = node.path().is_some();
        let by_keys = |track: Option<&Track>,
                       keys: fn(&Flight<'_>, &Track, Place) -> Option<Keys>| {
            track.and_then(|track| keys(flight, track, place))
        };
        let positions = by_keys(track(Channel::Position), keys::positions);
        let rotations = match aims(node) || rolls(node) {
            true => None,
            false => by_keys(track(Channel::Rotation), keys::rotations),
        };
        let scale = track(Channel::Scale).filter(|_| scales);
        let scale_keys = scale.and_then(|track| keys::numbers(flight, track));
        let moves = |channel| track(channel).is_some();
        let mut sample = Sample {
            positions: path || (moves(Channel::Position) && positions.is_none()),
            rotations: path
                || aims(node)
                || moves(Channel::Roll)
                || (moves(Channel::Rotation) && rotations.is_none()),
            scales: scale.is_some() && scale_keys.is_none(),
        };
        if aims(node) && scales {
            // Only its place in the world says what the aim does to axes of other lengths.
            sample.positions = true;
            sample.scales = true;
        }
        let frame = flight.frame(0);
        let first = self.locals(at, node, &place, 0, 1, sample)?[0];
        self.set_place(
            own,
            first.0,
            first.1,
            if scales { first.2 } else { DVec3::ONE },
        );
        let target = |path| Target::Node(own, path);
        for (keys, path, width) in [
            (positions.filter(|_| !sample.positions), "translation", 3),
            (rotations.filter(|_| !sample.rotations), "rotation", 4),
            (scale_keys.filter(|_| !sample.scales), "scale", 3),
        ] {
            if let Some(keys) = keys {
                self.animation
                    .keys(&mut self.binary, target(path), &keys, width)?;
            }
        }
        self.sampled(at, node, own, &place, sample)?;
        self.visible(own, node, frame)?;
        Ok(own)
    }

    /// A key a frame for what is asked for.
    fn sampled(
        &mut self,
        at: usize,
        node: &Node,
        own: usize,
        place: &Place,
        sample: Sample,
    ) -> Result<()> {
        if sample == Sample::default() {
            return Ok(());
        }
        let count = self.flight.count();
        let room = |wanted: bool| if wanted { count } else { 0 };
        let mut positions: Vec<[f64; 3]> = vec_with_room(room(sample.positions))?;
        let mut rotations: Vec<[f64; 4]> = vec_with_room(room(sample.rotations))?;
        let mut scales: Vec<f32> = vec_with_room(3 * room(sample.scales))?;
        let mut continued = Continued::default();
        for from in (0..count).step_by(BLOCK) {
            let block = BLOCK.min(count - from);
            for (position, rotation, scale) in self.locals(at, node, place, from, block, sample)? {
                if sample.positions {
                    positions.push(position.to_array());
                }
                if sample.rotations {
                    rotations.push(continued.next(rotation).to_array());
                }
                if sample.scales {
                    scales.extend(scale.as_vec3().to_array());
                }
            }
        }
        let (animation, binary) = (&mut self.animation, &mut self.binary);
        if sample.positions {
            animation.sampled(self.flight, binary, own, &positions)?;
        }
        if sample.rotations {
            animation.sampled(self.flight, binary, own, &rotations)?;
        }
        if sample.scales {
            let target = Target::Node(own, "scale");
            animation.a_key_a_frame(self.flight, binary, target, &scales, 3)?;
        }
        Ok(())
    }

    /// Places of a node in its parent, in the file's coordinates, from a frame on.
    fn locals(
        &mut self,
        at: usize,
        node: &Node,
        place: &Place,
        from: usize,
        count: usize,
        sample: Sample,
    ) -> Result<Vec<(DVec3, DQuat, DVec3)>> {
        let flight = self.flight;
        let mut locals = vec_with_room(count)?;
        let mut warnings = Warnings::default();
        let mut poses: Vec<Pose> = Vec::new();
        if !aims(node) {
            poses = path_poses(flight, node, from, count)?;
        }
        let (mut own, mut above): (Vec<NodeState>, Vec<NodeState>) = (Vec::new(), Vec::new());
        if aims(node) {
            own = self.states(at, from, count)?;
            if let Some(parent) = node.parent {
                above = self.states(parent, from, count)?;
            }
        }
        for index in 0..count {
            let frame = flight.frame(from + index);
            if let Some(pose) = poses.get(index) {
                let turn = quaternion_from_view(pose.view(), pose.up());
                let values = Values {
                    rotation: turn,
                    ..node.rest
                };
                let rotation = place.rotation(rolled(node, &values));
                locals.push((place.position(pose.position()), rotation, node.rest.scale));
                continue;
            }
            let values = values(node, frame, &mut warnings)?;
            let mut local = (
                place.position(values.position),
                place.rotation(rolled(node, &values)),
                values.scale,
            );
            if let Some(state) = own.get(index) {
                let parent = above
                    .get(index)
                    .map_or(DAffine3::IDENTITY, NodeState::world);
                let inside = parent.inverse() * state.world();
                let parts = convention::parts(inside);
                self.counts.sheared +=
                    usize::from(parts.sheared && sample.scales && from + index == 0);
                local = (
                    place.position(parts.position),
                    place.rotation(parts.rotation),
                    parts.scale,
                );
            }
            locals.push(local);
        }
        self.told(warnings, node)?;
        Ok(locals)
    }

    fn told(&self, warnings: Warnings, node: &Node) -> Result<()> {
        let place = || ScenePlace::Node(node.name.as_str().into());
        match warnings.into_error() {
            Some(error) => Err(error.at(place()).into()),
            None => Ok(()),
        }
    }

    fn states(&self, at: usize, from: usize, count: usize) -> Result<Vec<NodeState>> {
        let mut states = vec_with_room(count)?;
        states.resize(count, NodeState::default());
        self.flight.states(at, from, &mut states)?;
        Ok(states)
    }

    /// A camera or light that stands at the top, frame by frame.
    fn at_the_top(&mut self, at: usize, node: &Node) -> Result<()> {
        let top = self.push(&node.name)?;
        let (flight, count) = (self.flight, self.flight.count());
        let mut positions: Vec<[f64; 3]> = vec_with_room(count)?;
        let mut rotations: Vec<[f64; 4]> = vec_with_room(count)?;
        let mut continued = Continued::default();
        for from in (0..count).step_by(BLOCK) {
            for state in self.states(at, from, BLOCK.min(count - from))? {
                let pose = Pose {
                    vrp: flight.place(state.pose.vrp.into()).to_array(),
                    vpn: flight.direction(state.pose.vpn.into()).to_array(),
                    vup: flight.direction(state.pose.vup.into()).to_array(),
                    zoom: state.pose.zoom,
                };
                let turn = convention::rotation(&pose, CameraAxes::OpenGl);
                positions.push(pose.vrp);
                rotations.push(continued.next(turn).to_array());
            }
        }
        let (place, turn) = (
            DVec3::from_array(positions[0]),
            DQuat::from_array(rotations[0]),
        );
        self.set_place(top, place, turn, DVec3::ONE);
        if positions.iter().any(|other| *other != positions[0]) {
            self.animation
                .sampled(flight, &mut self.binary, top, &positions)?;
        }
        if rotations.iter().any(|other| *other != rotations[0]) {
            self.animation
                .sampled(flight, &mut self.binary, top, &rotations)?;
        }
        self.roots.push(top);
        self.view(node, top)
    }

    /// Gives a node the camera or light of one of ours.
    fn view(&mut self, node: &Node, seen: usize) -> Result<()> {
        match &node.kind {
            Kind::Camera(camera) => {
                let at = self.cameras.len();
                let yfov = self.zoom(node, at)?;
                let scale = self.flight.options().scale;
                let [width, height] = self.flight.size();
                self.cameras.try_reserve(1)?;
                self.cameras.push(json!({
                    "name": node.name,
                    "type": "perspective",
                    "perspective": {
                        "yfov": yfov,
                        "aspectRatio": width / height,
                        "znear": camera.near * scale,
                        "zfar": camera.far * scale,
                    },
                }));
                self.nodes[seen].json.insert("camera".into(), at.into());
            }
            Kind::Light(light) => {
                let at = self.light(node, *light)?;
                let light = json!({"light": at});
                self.extend(seen, extensions::LIGHTS, light);
            }
            _ => {}
        }
        Ok(())
    }

    fn extend(&mut self, at: usize, name: &str, value: Value) {
        let json = &mut self.nodes[at].json;
        let all = json.entry("extensions").or_insert_with(|| json!({}));
        all[name] = value;
    }

    /// The field of view at the first frame; its keys where it changes.
    fn zoom(&mut self, node: &Node, camera: usize) -> Result<f32> {
        let pointer = || format!("/cameras/{camera}/perspective/yfov");
        let moves = node.path().is_some() || node.keys().track(&Channel::Zoom).is_some();
        let fields = self.channel(node, moves, |values| {
            [convention::field_of_view(values.zoom) as f32]
        })?;
        self.pointer(pointer, &fields)?;
        Ok(fields[0][0])
    }

    /// Something of a node's values in each frame, or in the first alone if nothing moves it.
    pub(super) fn channel<const N: usize>(
        &self,
        node: &Node,
        moves: bool,
        take: impl Fn(&Values) -> [f32; N],
    ) -> Result<Vec<[f32; N]>> {
        let count = if moves { self.flight.count() } else { 1 };
        let mut all = vec_with_room(count)?;
        let mut warnings = Warnings::default();
        for from in (0..count).step_by(BLOCK) {
            let block = BLOCK.min(count - from);
            let poses = path_poses(self.flight, node, from, block)?;
            for index in 0..block {
                if let Some(pose) = poses.get(index) {
                    let zoom = pose.zoom;
                    all.push(take(&Values { zoom, ..node.rest }));
                } else {
                    let frame = self.flight.frame(from + index);
                    all.push(take(&values(node, frame, &mut warnings)?));
                }
            }
        }
        self.told(warnings, node)?;
        Ok(all)
    }

    /// A key a frame for what a pointer says, where it changes.
    pub(super) fn pointer<const N: usize>(
        &mut self,
        pointer: impl FnOnce() -> String,
        all: &[[f32; N]],
    ) -> Result<()> {
        if all.iter().all(|one| *one == all[0]) {
            return Ok(());
        }
        let target = Target::Pointer(pointer());
        let numbers = all.as_flattened();
        self.animation
            .a_key_a_frame(self.flight, &mut self.binary, target, numbers, N)
    }

    fn weights(&mut self, own: usize, node: &Node) -> Result<()> {
        let Some(track) = node.keys().track(&Channel::Weights) else {
            return Ok(());
        };
        let (flight, width) = (self.flight, track.width());
        let target = Target::Node(own, "weights");
        if let Some(keys) = keys::numbers(flight, track) {
            return self.animation.keys(&mut self.binary, target, &keys, width);
        }
        let mut all: Vec<f32> = vec_with_room(width * flight.count())?;
        let mut numbers = vec![0.0; width];
        let mut warnings = Warnings::default();
        for at in 0..flight.count() {
            track.numbers(flight.frame(at), &mut numbers, &mut warnings);
            all.extend(numbers.iter().map(|&number| number as f32));
        }
        self.told(warnings, node)?;
        self.animation
            .a_key_a_frame(flight, &mut self.binary, target, &all, width)
    }

    fn visible(&mut self, own: usize, node: &Node, frame: f64) -> Result<()> {
        let track = node.keys().track(&Channel::Visible);
        let mut warnings = Warnings::default();
        let seen = values(node, frame, &mut warnings)?.visible;
        if seen && track.is_none() {
            return Ok(());
        }
        self.hides = true;
        self.extend(own, extensions::VISIBILITY, json!({"visible": seen}));
        let Some(track) = track else { return Ok(()) };
        let pointer = format!("/nodes/{own}/extensions/{}/visible", extensions::VISIBILITY);
        let target = Target::Pointer(pointer);
        let (flight, binary) = (self.flight, &mut self.binary);
        if let Some(keys) = keys::numbers(flight, track) {
            return self.animation.keys(binary, target, &keys, 1);
        }
        let mut switches: Vec<u8> = vec_with_room(flight.count())?;
        for at in 0..flight.count() {
            let mut seen = [0.0];
            track.numbers(flight.frame(at), &mut seen, &mut warnings);
            switches.push(u8::from(seen != [0.0]));
        }
        self.animation
            .a_switch_a_frame(flight, binary, target, &switches)
    }

    /// What was lost.
    pub(super) fn tell(&self, report: &mut Report) {
        let counts = &self.counts;
        if counts.paths > 0 {
            report.add(Loss::Path);
        }
        report.count(counts.aims, Loss::Aims);
        report.count(counts.interpolations, Loss::Interpolations);
        report.count(counts.deformations, Loss::Deformations);
        report.count(counts.host, Loss::HostChannels);
        report.count(counts.sheared, Loss::Sheared);
        report.count(self.meshes.coloured_shapes, |count| Loss::NotTaken {
            what: "a shape's colours".into(),
            count,
        });
    }

    /// The JSON of the file without its buffers, and their bytes.
    pub(super) fn finish(mut self) -> (Map<String, Value>, Vec<u8>) {
        let mut used = Vec::new();
        if !self.lights.is_empty() {
            used.push(extensions::LIGHTS);
        }
        if self.hides {
            used.push(extensions::VISIBILITY);
        }
        if self.animation.points {
            used.push(extensions::POINTER);
        }
        let mut json = Map::new();
        let mut put = |name: &str, list: Vec<Value>| {
            if !list.is_empty() {
                json.insert(name.into(), list.into());
            }
        };
        put("cameras", self.cameras);
        put("meshes", self.meshes.json);
        put("materials", self.meshes.materials);
        put("accessors", self.binary.accessors);
        put("bufferViews", self.binary.views);
        put(
            "extensionsUsed",
            used.iter().map(|&name| name.into()).collect(),
        );
        let title = &self.flight.info().title;
        put(
            "animations",
            self.animation.into_json(title).into_iter().collect(),
        );
        for out in &mut self.nodes {
            if !out.children.is_empty() {
                let children = out.children.as_slice().into();
                out.json.insert("children".into(), children);
            }
        }
        let nodes = self.nodes.into_iter().map(|out| out.json.into());
        put("nodes", nodes.collect());
        if !self.lights.is_empty() {
            let lights = json!({(extensions::LIGHTS): {"lights": self.lights}});
            json.insert("extensions".into(), lights);
        }
        if !self.roots.is_empty() {
            json.insert("scenes".into(), json!([{"nodes": self.roots}]));
            json.insert("scene".into(), 0.into());
        }
        json.insert("asset".into(), asset(self.flight));
        (json, self.binary.bytes)
    }
}

/// What has a key a frame.
#[derive(Clone, Copy, Default, PartialEq)]
struct Sample {
    positions: bool,
    rotations: bool,
    scales: bool,
}

/// The poses of a node whose place is a path's alone, at whole frames of it; else none.
fn path_poses(flight: &Flight<'_>, node: &Node, from: usize, count: usize) -> Result<Vec<Pose>> {
    let Some(path) = node.path() else {
        return Ok(Vec::new());
    };
    let (first, step) = flight.first_and_step();
    let start = flight.frame(from) - path.start_frame() + 1.0;
    let inside = start >= 1.0 && start + (count - 1) as f64 <= path.count() as f64;
    if !node.keys().tracks().is_empty()
        || step != 1.0
        || start.fract() != 0.0
        || first.fract() != path.start_frame().fract()
        || !inside
    {
        return Ok(Vec::new());
    }
    let mut poses = vec_with_room(count)?;
    poses.resize(count, Pose::default());
    path.sampler()?.sample(start as usize, &mut poses)?;
    Ok(poses)
}

/// What is ours, beside what every file says of itself.
fn asset(flight: &Flight<'_>) -> Value {
    let info = flight.info();
    let space = flight.scene().space();
    let centre = flight.place(space.centre).to_array();
    let mut vides = json!({
        "fps": flight.fps(),
        "first_frame": flight.number(0),
        "centre": centre,
        "half_size": space.half_size * flight.options().scale,
    });
    for (key, text) in [
        ("title", &info.title),
        ("comment", &info.comment),
        ("unit", &info.unit),
    ] {
        if !text.is_empty() {
            vides[key] = text.as_str().into();
        }
    }
    json!({
        "version": "2.0",
        "generator": concat!("VIDES ", env!("CARGO_PKG_VERSION")),
        "extras": {"vides": vides},
    })
}
