//! A document as nodes, cameras, lights, meshes and one animation.
//!
//! A camera or light looks along −z there: without children it is one node that is turned, with
//! children it hangs on a child that is. Where something above scales, its place is no rotation
//! and position: it stands at the top, frame by frame. A pivot is a child that moves back.

use std::collections::HashMap;

use glam::{DQuat, DVec3};
use serde_json::{Map, Value, json};
use vides_document::error::vec_with_room;
use vides_engine::scene::{Channel, Interpolation, Kind, Node, NodeState, Warnings};

use super::binary::Binary;
use super::extensions;
use super::keys::{self, Animation};
use super::meshes::Meshes;
use super::of_node::aims;
use crate::blocks::Progress;
use crate::convention;
use crate::convention::HALF_TURN;
use crate::error::Result;
use crate::flight::Flight;
use crate::loss::{Loss, Report};

/// A node that is written.
pub(super) struct Out {
    pub(super) json: Map<String, Value>,
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
pub(super) struct Counts {
    aims: usize,
    interpolations: usize,
    deformations: usize,
    host: usize,
    pub(super) sheared: usize,
    paths: usize,
}

pub(super) struct Writer<'f, 'd> {
    pub(super) flight: &'f Flight<'d>,
    pub(super) binary: Binary,
    pub(super) nodes: Vec<Out>,
    pub(super) roots: Vec<usize>,
    cameras: Vec<Value>,
    pub(super) lights: Vec<Value>,
    meshes: Meshes,
    pub(super) animation: Animation,
    pub(super) counts: Counts,
    /// Fields of view of the camera that was sampled last.
    pub(super) fields: Vec<[f32; 1]>,
    pub(super) hides: bool,
    /// How long a unit of each node is in the world at the first frame, where it is longest.
    pub(super) scales: Vec<f64>,
    /// What roots count from.
    pub(super) origin: DVec3,
    /// The nodes above those that count from elsewhere in their parent.
    above: HashMap<usize, usize>,
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
            fields: Vec::new(),
            hides: false,
            scales: world_scales(flight)?,
            origin: flight.origin(flight.place(flight.bounds()?.centre), 1.0)?,
            above: HashMap::new(),
        })
    }

    /// All of the document.
    pub(super) fn document(&mut self, progress: Progress<'_>) -> Result<()> {
        let nodes = self.flight.scene().nodes();
        let mut has_children: Vec<bool> = vec_with_room(nodes.len())?;
        has_children.resize(nodes.len(), false);
        for parent in nodes.iter().filter_map(|node| node.parent) {
            has_children[parent] = true;
        }
        // The shown camera is the first, which importers look through.
        let shown = self.flight.node();
        let mut order: Vec<usize> = vec_with_room(nodes.len())?;
        order.extend((0..nodes.len()).filter(|&at| at == shown));
        order.extend((0..nodes.len()).filter(|&at| at != shown));
        let mut became: Vec<Became> = vec_with_room(nodes.len())?;
        became.resize(
            nodes.len(),
            Became {
                node: None,
                inner: None,
            },
        );
        for (done, at) in order.into_iter().enumerate() {
            progress(done, nodes.len());
            became[at] = self.node(at, has_children[at])?;
        }
        progress(nodes.len(), nodes.len());
        for (at, node) in nodes.iter().enumerate() {
            let Some(own) = became[at].node else { continue };
            let own = self.above.get(&own).copied().unwrap_or(own);
            match node.parent.and_then(|parent| became[parent].inner) {
                Some(parent) => self.nodes[parent].children.push(own),
                None => self.roots.push(own),
            }
        }
        self.object()?;
        if self.origin != DVec3::ZERO {
            let origin = self.push_origin(self.origin)?;
            self.nodes[origin].children = std::mem::replace(&mut self.roots, vec![origin]);
        }
        Ok(())
    }

    /// A node whose children count from there.
    fn push_origin(&mut self, origin: DVec3) -> Result<usize> {
        let at = self.push("origin")?;
        self.set_place(at, origin, DQuat::IDENTITY, DVec3::ONE);
        self.mark(at, "origin");
        Ok(at)
    }

    /// Says which part of the node above a node is.
    fn mark(&mut self, at: usize, part: &str) {
        let extras = json!({"vides": {"part": part}});
        self.nodes[at].json.insert("extras".into(), extras);
    }

    /// Puts a node into one that its positions count from, unless that is zero.
    pub(super) fn put_below(&mut self, own: usize, origin: DVec3) -> Result<()> {
        if origin != DVec3::ZERO {
            let above = self.push_origin(origin)?;
            self.nodes[above].children.push(own);
            self.above.try_reserve(1)?;
            self.above.insert(own, above);
        }
        Ok(())
    }

    /// Gives a node a mesh: in a child that its vertices count from, unless that is zero. Returns
    /// the node that has it.
    fn hang(&mut self, node: usize, (mesh, origin): (usize, DVec3)) -> Result<usize> {
        let mut holder = node;
        if origin != DVec3::ZERO {
            holder = self.push("vertices")?;
            self.set_place(holder, origin, DQuat::IDENTITY, DVec3::ONE);
            self.mark(holder, "vertices");
            self.nodes[node].children.push(holder);
        }
        self.nodes[holder].json.insert("mesh".into(), mesh.into());
        Ok(holder)
    }

    /// The wireframe or mesh that a path is shown with.
    fn object(&mut self) -> Result<()> {
        let object = &self.flight.info().object;
        if object.is_empty() {
            return Ok(());
        }
        let mesh = self
            .meshes
            .of_document(self.flight, &mut self.binary, object)?;
        let turn = convention::turn(self.flight.document_up(), self.flight.up());
        let at = self.push("object")?;
        self.set_place(at, -self.origin, turn, DVec3::ONE);
        self.hang(at, mesh)?;
        self.roots.push(at);
        Ok(())
    }

    pub(super) fn push(&mut self, name: &str) -> Result<usize> {
        let mut json = Map::new();
        json.insert("name".into(), name.into());
        self.nodes.try_reserve(1)?;
        self.nodes.push(Out {
            json,
            children: Vec::new(),
        });
        Ok(self.nodes.len() - 1)
    }

    /// One node of ours.
    fn node(&mut self, at: usize, has_children: bool) -> Result<Became> {
        let node = &self.flight.scene().nodes()[at];
        self.count(node);
        if !node.kind.looks() {
            let own = self.moved(at, node, &node.name, DQuat::IDENTITY, true)?;
            let inner = self.pivot(node, own)?;
            if let Kind::Object(object) = &node.kind {
                let scale = self.scales[at];
                let mesh = self.meshes.of_object(
                    self.flight,
                    &mut self.binary,
                    &mut self.animation,
                    node,
                    object,
                    scale,
                )?;
                if let Some(mesh) = mesh {
                    let holder = self.hang(inner, mesh)?;
                    self.weights(holder, node)?;
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
            HALF_TURN
        };
        let own = self.moved(at, node, &node.name, look, false)?;
        let seen = if has_children {
            let child = self.push(&format!("{} view", node.name))?;
            self.set_place(child, DVec3::ZERO, HALF_TURN, DVec3::ONE);
            self.mark(child, "view");
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
        let pivot = (-back).to_array();
        self.mark(child, "pivot");
        let extras = json!({"vides": {"pivot": pivot}});
        self.nodes[own].json.insert("extras".into(), extras);
        self.nodes[own].children.push(child);
        Ok(child)
    }

    /// Gives a node the camera or light of one of ours.
    pub(super) fn view(&mut self, node: &Node, seen: usize) -> Result<()> {
        match &node.kind {
            Kind::Camera(camera) => {
                let at = self.cameras.len();
                let yfov = self.zoom(node, at)?;
                let [near, far] = self.flight.planes(*camera)?;
                let [width, height] = self.flight.size();
                self.cameras.try_reserve(1)?;
                self.cameras.push(json!({
                    "name": node.name,
                    "type": "perspective",
                    "perspective": {
                        "yfov": yfov,
                        "aspectRatio": width / height,
                        "znear": near,
                        "zfar": far,
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

    pub(super) fn extend(&mut self, at: usize, name: &str, value: Value) {
        let json = &mut self.nodes[at].json;
        let all = json.entry("extensions").or_insert_with(|| json!({}));
        all[name] = value;
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
        if self.meshes.coloured_shapes {
            report.add(Loss::PointColours);
        }
        if self.origin != DVec3::ZERO {
            report.add(Loss::Origin(self.origin.to_array()));
        }
        report.count(self.flight.scene().markers().len(), Loss::Markers);
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

fn world_scales(flight: &Flight<'_>) -> Result<Vec<f64>> {
    let scene = flight.scene();
    let count = scene.nodes().len();
    let mut states = vec_with_room(count)?;
    states.resize(count, NodeState::default());
    scene.evaluate(flight.frame(0), &mut states, &mut Warnings::default())?;
    let mut scales = vec_with_room(count)?;
    scales.extend(states.iter().map(|state| {
        let axes = state.world().matrix3;
        let lengths = [axes.x_axis, axes.y_axis, axes.z_axis].map(DVec3::length);
        lengths.into_iter().fold(0.0, f64::max)
    }));
    Ok(scales)
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
        "frames": flight.count(),
    });
    if let Some(shown) = flight.scene().nodes().get(flight.node()) {
        vides["camera"] = shown.name.as_str().into();
    }
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
