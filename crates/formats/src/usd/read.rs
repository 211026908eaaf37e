//! The prims of a file as a scene.

use std::collections::BTreeMap;

use glam::DVec3;
use vides_document::error::{Place as ScenePlace, vec_with_room};
use vides_document::{Info, SceneDocument};
use vides_engine::limits::MAX_COORDINATE;
use vides_engine::path::Up;
use vides_engine::scene::{Channel, Interpolation, Kind, Light, Node, Object, Scene, Track};

use super::curve::{Clock, Curve, clamped, quaternion};
use super::geometry_in::{self, Geometry};
use super::ops::Room;
use super::stage::{Prim, Stage};
use super::{role, unit};
use crate::content::{Content, one_line, rate, shortened};
use crate::convention::HALF_TURN;
use crate::error::{Cause, Error, Result};
use crate::loss::{Loss, Report};
use crate::names::Names;
use crate::options::Options;
use crate::space;

/// Keys that may be computed between those of a file, beside one for each byte of it.
const ROOM: usize = 100_000;

/// Prims that one node is made of: triangles, lines, points.
const MAX_PARTS: usize = 3;

/// Time codes a second of a file that does not say (UsdStage).
const RATE: f64 = 24.0;

/// Reads all of a file.
///
/// # Errors
/// What is wrong in it, with the line; the node that is out of range.
pub(super) fn read(text: &str, options: &Options, report: &mut Report) -> Result<Content> {
    let stage = Stage::parse(text)?;
    let rates = [stage.frames_per_second, stage.codes_per_second];
    let fps = rate(&rates, options, RATE, report);
    let codes = stage.codes_per_second.filter(|codes| *codes > 0.0);
    let per_code = codes.map_or(1.0, |codes| fps / codes);
    let start = first_frame(&stage, per_code)?;
    let clock = Clock {
        rate: per_code,
        start: start.into(),
    };
    let mut reader = Reader {
        stage: &stage,
        clock,
        room: Room(text.len() + ROOM),
        names: Names::default(),
        nodes: Vec::new(),
        wireframe: Vec::new(),
        told: BTreeMap::new(),
        left_out: Vec::new(),
        counts: Counts::default(),
        parts: 0,
    };
    reader.all()?;
    let Reader {
        nodes,
        wireframe,
        told,
        left_out,
        counts,
        ..
    } = reader;
    counts.tell(report);
    for (what, count) in stage.told.iter().chain(&told) {
        report.not_taken(what, *count);
    }
    for what in &left_out {
        report.add(Loss::LeftOut(what.as_str().into()));
    }
    let names: Vec<String> = nodes.iter().map(|node| node.name.clone()).collect();
    let mut scene = Scene::from_nodes(nodes).map_err(|(at, error)| {
        let name = names.get(at).map_or("", String::as_str);
        Error::from(error.at(ScenePlace::Node(name.into())))
    })?;
    show(&mut scene, &stage, clock)?;
    let up = match stage.up.as_str() {
        "Z" | "z" => Up::Z,
        _ => Up::Y,
    };
    let places = wireframe.iter().map(|point| point.position);
    let space = space::around(&scene, places, options.up.unwrap_or(up))?;
    scene.set_space(space)?;
    let info = Info {
        title: one_line(&stage.title),
        comment: shortened(&stage.doc),
        fps,
        first_frame: start,
        unit: one_line(&stage.unit.clone().unwrap_or_else(|| {
            let metres = stage.metres.filter(|metres| *metres > 0.0);
            metres.map(unit::name).unwrap_or_default()
        })),
        object: wireframe.into(),
        ..Info::default()
    };
    Ok(Content::Scene(Box::new(SceneDocument::new(scene, info)?)))
}

/// The camera and the frames that are shown, where they are not those that would be.
fn show(scene: &mut Scene, stage: &Stage<'_>, clock: Clock) -> Result<()> {
    let is_camera = |at: &usize| matches!(scene.nodes()[*at].kind, Kind::Camera(_));
    let camera = scene.find(&stage.camera).filter(is_camera);
    if camera.is_some() && camera != scene.shown_camera() {
        scene.set_camera(camera)?;
    }
    let (Some(first), Some(last)) = (stage.start, stage.end) else {
        return Ok(());
    };
    let range = [first, last].map(|code| clock.frame(code));
    if range[0] <= range[1] && range != <[f64; 2]>::from(scene.frame_range()) {
        scene.set_range(Some(range.into()))?;
    }
    Ok(())
}

fn first_frame(stage: &Stage<'_>, per_code: f64) -> Result<i32> {
    let start = stage.start.map_or(1.0, |code| (code * per_code).round());
    if start.abs() > MAX_COORDINATE {
        return Err(stage.lexer.line(0).wrong(Cause::TooLarge));
    }
    Ok(start as i32)
}

#[derive(Default)]
pub(super) struct Counts {
    sampled: usize,
    pub(super) fields: usize,
    pub(super) off_centre: usize,
    skins: usize,
}

impl Counts {
    fn tell(&self, report: &mut Report) {
        report.count(self.sampled, Loss::Resampled);
        report.count(self.fields, Loss::FieldsClamped);
        report.count(self.off_centre, Loss::OffCentre);
        report.count(self.skins, Loss::Skins);
    }
}

pub(super) struct Reader<'s, 'a> {
    pub(super) stage: &'s Stage<'a>,
    clock: Clock,
    room: Room,
    names: Names,
    nodes: Vec<Node>,
    wireframe: Vec<vides_document::ObjectPoint>,
    pub(super) told: BTreeMap<&'a str, usize>,
    /// Geometry that cannot be read, and why.
    left_out: Vec<String>,
    pub(super) counts: Counts,
    /// Prims that became part of the last node.
    parts: usize,
}

/// What of a prim's children becomes the prim itself.
#[derive(Clone, Copy, PartialEq)]
enum Sole {
    /// Missing.
    None,
    /// The only child, by its number.
    One(usize),
    /// There are several, or others.
    Other,
}

/// What a type of prim is to us.
#[derive(Clone, Copy, PartialEq)]
enum Type {
    Place,
    /// Holds others, without a transform.
    Scope,
    Camera,
    Light(Light),
    Geometry,
    Unknown,
}

fn type_of(prim: &Prim<'_>, spot: bool) -> Type {
    match prim.kind {
        "Xform" | "SkelRoot" => Type::Place,
        "Scope" | "" => Type::Scope,
        "Camera" => Type::Camera,
        "DistantLight" => Type::Light(Light::Directional),
        "SphereLight" if spot => Type::Light(Light::Spot),
        "SphereLight" => Type::Light(Light::Point),
        "Mesh" | "Points" | "BasisCurves" => Type::Geometry,
        _ => Type::Unknown,
    }
}

impl<'a> Reader<'_, 'a> {
    fn all(&mut self) -> Result<()> {
        let prims = &self.stage.prims;
        // Which prims become nodes: what is known, and what holds such.
        let mut wanted = vec_with_room(prims.len())?;
        wanted.resize(prims.len(), false);
        let mut inside = wanted.clone();
        let mut sole: Vec<Sole> = vec_with_room(prims.len())?;
        sole.resize(prims.len(), Sole::None);
        for (at, prim) in prims.iter().enumerate().rev() {
            if prim.out {
                continue;
            }
            let known = !matches!(self.kind(prim), Type::Scope | Type::Unknown);
            wanted[at] =
                known || inside[at] || self.stage.attribute(prim, "xformOpOrder").is_some();
            let part = matches!(prim.role.as_str(), role::PART | role::LOOKS);
            if let Some(parent) = prim.parent.filter(|_| wanted[at]) {
                inside[parent] |= !part;
                let plain = !inside[at] && self.may_be_its_parent(prim);
                sole[parent] = match sole[parent] {
                    Sole::None if plain => Sole::One(at),
                    _ => Sole::Other,
                };
            }
        }
        let mut numbers: Vec<Option<usize>> = vec_with_room(prims.len())?;
        for (at, prim) in prims.iter().enumerate() {
            let parent = prim.parent.and_then(|parent| numbers[parent]);
            if !prim.out && self.kind(prim) == Type::Unknown {
                *self.told.entry(prim.kind).or_default() += 1;
            }
            let number = match prim.role.as_str() {
                role::WORLD if prim.parent.is_none() && prim.attributes.is_empty() => None,
                role::WIREFRAME if wanted[at] => {
                    geometry_in::wireframe(self.stage, prim, &mut self.wireframe)?;
                    None
                }
                role::PART | role::LOOKS if wanted[at] && !inside[at] && self.takes(parent) => {
                    self.part(prim, parent)?;
                    None
                }
                _ if prim
                    .parent
                    .is_some_and(|above| sole[above] == Sole::One(at)) =>
                {
                    None
                }
                _ if wanted[at] => Some(match sole[at] {
                    Sole::One(held) => self.node(prim, &prims[held], parent, false)?,
                    _ => self.node(prim, prim, parent, inside[at])?,
                }),
                _ => None,
            };
            numbers.push(number);
        }
        Ok(())
    }

    /// Whether a prim is nothing but the lens, light or geometry of the `Xform` that it is in, as
    /// many programs write them.
    fn may_be_its_parent(&self, prim: &Prim<'a>) -> bool {
        let held = |name: &str| self.stage.attribute(prim, name).is_some();
        let parent = prim.parent.map(|parent| &self.stage.prims[parent]);
        let holds = !matches!(self.kind(prim), Type::Place | Type::Scope | Type::Unknown);
        let plain = |parent: &Prim<'_>| parent.kind == "Xform" && parent.role.is_empty();
        holds
            && prim.role.is_empty()
            && parent.is_some_and(plain)
            && !held("xformOpOrder")
            && !held("visibility")
    }

    fn kind(&self, prim: &Prim<'a>) -> Type {
        let spot = self.stage.attribute(prim, "inputs:shaping:cone:angle");
        type_of(prim, spot.is_some())
    }

    /// Whether a node can take the lens, light or geometry of a prim in it: as we write it, these
    /// stand before other nodes, and are few.
    fn takes(&self, parent: Option<usize>) -> bool {
        let fits = |node: &Node| matches!(node.kind, Kind::Group | Kind::Object(_));
        let last = self.nodes.len().checked_sub(1);
        self.parts < MAX_PARTS && parent == last && self.nodes.last().is_some_and(fits)
    }

    /// A camera, light or geometry as what the node is that it is in.
    fn part(&mut self, prim: &Prim<'a>, parent: Option<usize>) -> Result<()> {
        let Some(parent) = parent else {
            return Ok(());
        };
        self.parts += 1;
        let mut node = std::mem::take(&mut self.nodes[parent]);
        if node.kind == Kind::Group {
            node.kind = self.kind_of(prim)?;
        }
        self.fill(prim, &mut node)?;
        self.nodes[parent] = node;
        Ok(())
    }

    fn kind_of(&self, prim: &Prim<'a>) -> Result<Kind> {
        Ok(match self.kind(prim) {
            Type::Camera => Kind::Camera(self.planes(prim)?),
            Type::Light(light) => Kind::Light(light),
            Type::Geometry => Kind::Object(Object::default()),
            _ => Kind::Group,
        })
    }

    /// The number of the node that a prim becomes, with what `held` holds, which is in it or itself.
    /// What looks and has others in it becomes two, since it looks the other way.
    fn node(
        &mut self,
        prim: &Prim<'a>,
        held: &Prim<'a>,
        parent: Option<usize>,
        inside: bool,
    ) -> Result<usize> {
        let kind = self.kind_of(held)?;
        let looks = kind.looks() && !inside;
        if let Some(at) = prim.spline.or(held.spline) {
            if matches!(kind, Kind::Camera(_)) {
                return Err(self.stage.lexer.from(at).wrong(Cause::Unsupported {
                    name: "the spline of a camera (bake it to time samples)".into(),
                    help: "",
                }));
            }
            *self.told.entry("spline").or_default() += 1;
        }
        let name = if prim.display_name.is_empty() {
            prim.name
        } else {
            &prim.display_name
        };
        let name = self.names.unique(name)?;
        let group = if kind.looks() && inside {
            Kind::Group
        } else {
            kind.clone()
        };
        let mut node = Node::new(&name, group);
        node.parent = parent;
        if self.kind(prim) != Type::Scope || !prim.attributes.is_empty() {
            self.place(prim, &mut node, looks)?;
        }
        self.visible(prim, &mut node)?;
        let at = self.nodes.len();
        self.parts = 0;
        self.nodes.try_reserve(2)?;
        if kind.looks() && inside {
            self.nodes.push(node);
            let name = self.names.unique(&format!("{name} {}", kind.name()))?;
            let mut looking = Node::new(&name, kind);
            looking.parent = Some(at);
            looking.rest.rotation = HALF_TURN;
            self.fill(held, &mut looking)?;
            self.nodes.push(looking);
        } else {
            self.fill(held, &mut node)?;
            self.nodes.push(node);
        }
        Ok(at)
    }

    fn place(&mut self, prim: &Prim<'a>, node: &mut Node, looks: bool) -> Result<()> {
        let mut placed = self.stage.placed(prim, looks, &mut self.room)?;
        self.counts.sampled += usize::from(placed.sampled);
        if placed.sheared {
            *self.told.entry("shear").or_default() += 1;
        }
        if placed.in_world {
            node.parent = None;
            *self.told.entry("!resetXformStack!").or_default() += 1;
        }
        node.pivot = placed.pivot;
        if let Some(curve) = placed
            .rotation
            .as_mut()
            .filter(|curve| looks && curve.width == 4)
        {
            curve.map(|turn| {
                let q = quaternion(turn) * HALF_TURN.conjugate();
                turn.copy_from_slice(&[q.w, q.x, q.y, q.z]);
            });
        } else if looks {
            placed.rotation = Some(Curve::constant(&[0.0, 0.0, -1.0, 0.0]));
        }
        if let Some(curve) = self.moving(node, Channel::Position, placed.position)? {
            node.rest.position = DVec3::from_slice(curve.first());
        }
        if let Some(curve) = self.moving(node, Channel::Scale, placed.scale)? {
            node.rest.scale = DVec3::from_slice(curve.first());
        }
        match placed.rotation {
            // Yaw, pitch and roll.
            Some(mut curve) if curve.width == 3 => {
                for time in &mut curve.times {
                    *time = self.clock.frame(*time);
                }
                let by = Interpolation::EulerLinear;
                let Curve { times, values, .. } = curve;
                self.set(
                    node,
                    Track::new(Channel::Rotation, by, times, values, vec![]),
                )?;
            }
            rotation => {
                if let Some(curve) = self.moving(node, Channel::Rotation, rotation)? {
                    node.rest.rotation = quaternion(curve.first());
                }
            }
        }
        Ok(())
    }

    /// Makes a track of a curve with times; gives back one without.
    pub(super) fn moving(
        &self,
        node: &mut Node,
        channel: Channel,
        curve: Option<Curve>,
    ) -> Result<Option<Curve>> {
        match curve {
            Some(curve) if !curve.rests() => {
                self.set(node, curve.into_track(channel, self.clock))?;
                Ok(None)
            }
            rests => Ok(rests),
        }
    }

    fn set(&self, node: &mut Node, track: Result<Track, vides_engine::Error>) -> Result<()> {
        let set = track.and_then(|track| node.set_track(track));
        set.map_err(|error| error.at(ScenePlace::Node(node.name.as_str().into())).into())
    }

    fn visible(&self, prim: &Prim<'a>, node: &mut Node) -> Result<()> {
        let curve = self.stage.switch(prim, "visibility", "invisible")?;
        if let Some(curve) = self.moving(node, Channel::Visible, curve)? {
            node.rest.visible = curve.first() != [0.0];
        }
        Ok(())
    }

    /// What a node has of its kind.
    fn fill(&mut self, prim: &Prim<'a>, node: &mut Node) -> Result<()> {
        match &mut node.kind {
            Kind::Camera(_) => self.lens(prim, node),
            Kind::Light(_) => self.light(prim, node),
            Kind::Object(object) => {
                self.counts.skins += usize::from(prim.skinned);
                let read = geometry_in::read(self.stage, prim, object.mesh());
                let Geometry { mesh, colour, told } = match read {
                    Ok(read) => read,
                    // The rest of the scene comes without it.
                    Err(error @ Error::Content { .. }) => {
                        self.left_out
                            .push(format!("the mesh of {}: {error}", node.name));
                        return Ok(());
                    }
                    Err(other) => return Err(other),
                };
                let done = object.set_mesh(mesh);
                done.map_err(|error| error.at(ScenePlace::Node(node.name.as_str().into())))?;
                for what in told {
                    *self.told.entry(what).or_default() += 1;
                }
                let colour = colour.map(|curve| clamped(curve, MAX_COORDINATE));
                if let Some(curve) = self.moving(node, Channel::Colour, colour)? {
                    node.rest.colour = curve.at(0.0);
                }
                Ok(())
            }
            Kind::Group => Ok(()),
        }
    }
}
