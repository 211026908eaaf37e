//! The nodes of a scene as prims: what holds what, kinds, names, lenses and lights.

use std::io::{BufWriter, Write};

use glam::DQuat;
use vides_engine::path::Up;
use vides_engine::scene::{Camera, Channel, Extrapolation, Interpolation, Kind, Light, Node};
use vides_engine::shared_list::SharedList;

use super::text::{self, Names, Quoted, single};
use super::{role, unit};
use crate::blocks::failed;
use crate::convention::{FILM_HEIGHT, HALF_TURN};
use crate::error::Result;
use crate::flight::Flight;
use crate::loss::{Loss, Report};

/// Writes a line, indented by a depth; deep trees are not indented without end.
macro_rules! put {
    ($self:ident, $depth:expr, $($format:tt)*) => {{
        let depth = 4 * usize::min($depth, 8);
        write!($self.out, "{:depth$}", "")
            .and_then(|()| writeln!($self.out, $($format)*))
            .map_err(failed)
    }};
}
pub(super) use put;

/// How a camera or light stands in the file.
#[derive(Clone, Copy, PartialEq)]
enum Stand {
    /// Nothing above it scales: at its place, alone.
    Alone,
    /// The same with others in it: on a separate prim in the node's.
    Within,
    /// Something scales: at the top, frame by frame.
    Top,
}

pub(super) struct Writer<'w, 'f, 'd> {
    pub(super) flight: &'w Flight<'d>,
    pub(super) out: BufWriter<&'w mut dyn Write>,
    report: &'f mut Report,
    names: Names,
    idents: Vec<String>,
    children: Vec<Vec<usize>>,
    /// Whether neither the node nor anything above it scales.
    rigid: Vec<bool>,
    /// Tracks that became a key a frame.
    pub(super) sampled: usize,
    /// Objects that are written point by point, frame by frame.
    pub(super) formed: usize,
}

/// Writes all of a scene.
///
/// # Errors
/// Those of sampling and of `out`.
pub(super) fn write(
    flight: &mut Flight<'_>,
    out: &mut dyn Write,
    report: &mut Report,
) -> Result<()> {
    let nodes = flight.scene().nodes();
    let mut names = Names::default();
    let world = names.give("World");
    let idents = nodes.iter().map(|node| names.give(&node.name)).collect();
    let mut children = vec![Vec::new(); nodes.len()];
    let mut roots = Vec::new();
    for (at, node) in nodes.iter().enumerate() {
        match node.parent {
            Some(parent) => children[parent].push(at),
            None => roots.push(at),
        }
    }
    let mut writer = Writer {
        flight,
        out: BufWriter::new(out),
        report,
        names,
        idents,
        rigid: rigid(nodes),
        children,
        sampled: 0,
        formed: 0,
    };
    writer.head(&world)?;
    writer.open(0, "Xform", &world, None, Some(role::WORLD), "")?;
    for root in roots {
        writer.node(root, 1)?;
    }
    writer.wireframe(1)?;
    for at in 0..nodes.len() {
        if writer.stand(at) == Some(Stand::Top) {
            writer.looks_at_top(at)?;
        }
    }
    put!(writer, 0, "}}")?;
    writer.tell();
    writer.out.flush().map_err(failed)
}

/// Of each node whether neither it nor anything above it scales; parents may stand behind.
fn rigid(nodes: &SharedList<Node>) -> Vec<bool> {
    let own: Vec<bool> = nodes
        .iter()
        .map(|node| {
            node.rest.scale == glam::DVec3::ONE && node.keys().track(&Channel::Scale).is_none()
        })
        .collect();
    let above = |at: usize| std::iter::successors(Some(at), |&at| nodes[at].parent);
    (0..nodes.len())
        .map(|at| above(at).all(|at| own[at]))
        .collect()
}

impl<'d> Writer<'_, '_, 'd> {
    pub(super) fn of(&self, at: usize) -> &'d Node {
        &self.flight.scene().nodes()[at]
    }

    /// Metres of a unit of the file.
    fn metres(&self) -> f64 {
        let known = unit::metres(&self.flight.info().unit);
        // What nothing is known of counts as metres, whatever the scale.
        known.map_or(1.0, |metres| metres / self.flight.options().scale)
    }

    fn head(&mut self, world: &str) -> Result<()> {
        let info = self.flight.info();
        let first = self.flight.number(0);
        put!(self, 0, "#usda 1.0\n(")?;
        put!(self, 1, "defaultPrim = {}", Quoted(world))?;
        if !info.comment.is_empty() {
            put!(self, 1, "doc = {}", Quoted(&info.comment))?;
        }
        put!(self, 1, "customLayerData = {{")?;
        put!(self, 2, "string title = {}", Quoted(&info.title))?;
        let shown = Quoted(&self.of(self.flight.node()).name);
        put!(self, 2, "string camera = {shown}")?;
        // A scaled unit has another name, which `metersPerUnit` gives if the unit is known.
        let known = unit::metres(&info.unit).is_some();
        match self.flight.options().scale == 1.0 {
            true => put!(self, 2, "string unit = {}", Quoted(&info.unit))?,
            false if known => {}
            false => put!(self, 2, "string unit = \"\"")?,
        }
        put!(self, 1, "}}")?;
        put!(self, 1, "metersPerUnit = {:?}", self.metres())?;
        let up = match self.flight.up() {
            Up::Y => "Y",
            Up::Z => "Z",
        };
        put!(self, 1, "upAxis = \"{up}\"")?;
        put!(self, 1, "startTimeCode = {first}")?;
        let last = first + (self.flight.count() - 1) as f64;
        put!(self, 1, "endTimeCode = {last}")?;
        put!(self, 1, "timeCodesPerSecond = {}", self.flight.fps())?;
        put!(self, 1, "framesPerSecond = {}", self.flight.fps())?;
        put!(self, 0, ")\n")
    }

    /// Begins a prim, with the true name where the identifier is another.
    pub(super) fn open(
        &mut self,
        depth: usize,
        kind: &str,
        ident: &str,
        name: Option<&str>,
        role: Option<&str>,
        schema: &str,
    ) -> Result<()> {
        let mut lines = Vec::new();
        if let Some(name) = name.filter(|name| *name != ident) {
            lines.push(format!("displayName = {}", Quoted(name)));
        }
        if !schema.is_empty() {
            lines.push(format!("prepend apiSchemas = [\"{schema}\"]"));
        }
        if let Some(role) = role {
            lines.push(format!("customData = {{ string vides = \"{role}\" }}"));
        }
        if lines.is_empty() {
            put!(self, depth, "def {kind} \"{ident}\"")?;
        } else {
            put!(self, depth, "def {kind} \"{ident}\" (")?;
            for line in lines {
                put!(self, depth + 1, "{line}")?;
            }
            put!(self, depth, ")")?;
        }
        put!(self, depth, "{{")
    }

    /// An identifier for a prim that is no node.
    pub(super) fn ident(&mut self, name: &str) -> String {
        self.names.give(name)
    }

    fn stand(&self, at: usize) -> Option<Stand> {
        if !self.of(at).kind.looks() {
            return None;
        }
        Some(match (self.rigid[at], self.children[at].is_empty()) {
            (false, _) => Stand::Top,
            (true, true) => Stand::Alone,
            (true, false) => Stand::Within,
        })
    }

    fn node(&mut self, at: usize, depth: usize) -> Result<()> {
        let node = self.of(at);
        let ident = self.idents[at].clone();
        let stand = self.stand(at);
        match (&node.kind, stand) {
            // All of it stands at the top.
            (_, Some(Stand::Top)) if self.children[at].is_empty() => return Ok(()),
            (_, Some(Stand::Alone)) => {
                let (kind, schema) = prim_kind(&node.kind);
                self.open(depth, kind, &ident, Some(&node.name), None, schema)?;
                self.transform(at, depth + 1, HALF_TURN, self.rigid[at])?;
                self.visibility(at, depth + 1)?;
                self.looks(at, depth + 1)?;
            }
            (Kind::Object(object), _) => {
                let inside = !self.children[at].is_empty();
                self.object(at, object, &ident, depth, inside)?;
            }
            _ => {
                // What stands at the top has the name itself.
                let plain = if stand == Some(Stand::Top) {
                    self.ident(&format!("{}_place", node.name))
                } else {
                    ident.clone()
                };
                let name = (stand != Some(Stand::Top)).then_some(node.name.as_str());
                self.open(depth, "Xform", &plain, name, None, "")?;
                self.transform(at, depth + 1, DQuat::IDENTITY, self.rigid[at])?;
                self.visibility(at, depth + 1)?;
                if stand == Some(Stand::Within) {
                    self.looks_within(at, &ident, depth + 1)?;
                }
            }
        }
        for at in std::mem::take(&mut self.children[at]) {
            self.node(at, depth + 1)?;
        }
        put!(self, depth, "}}")
    }

    /// The camera or light of a prim with children, turned round in it.
    fn looks_within(&mut self, at: usize, ident: &str, depth: usize) -> Result<()> {
        let (kind, schema) = prim_kind(&self.of(at).kind);
        let ident = self.ident(&format!("{ident}_{}", kind.to_lowercase()));
        self.open(depth, kind, &ident, None, Some(role::LOOKS), schema)?;
        put!(
            self,
            depth + 1,
            "quatd xformOp:orient = (0.0, 0.0, 1.0, 0.0)"
        )?;
        put!(
            self,
            depth + 1,
            "uniform token[] xformOpOrder = [\"xformOp:orient\"]"
        )?;
        self.looks(at, depth + 1)?;
        put!(self, depth, "}}")
    }

    /// A camera or light that something scales: its pose in the world, frame by frame.
    fn looks_at_top(&mut self, at: usize) -> Result<()> {
        let node = self.of(at);
        let (kind, schema) = prim_kind(&node.kind);
        let ident = self.idents[at].clone();
        self.open(1, kind, &ident, Some(&node.name), None, schema)?;
        self.pose_frames(at, 2)?;
        self.looks(at, 2)?;
        put!(self, 1, "}}")
    }

    /// Lens or light.
    fn looks(&mut self, at: usize, depth: usize) -> Result<()> {
        match self.of(at).kind {
            Kind::Camera(camera) => self.lens(at, camera, depth),
            Kind::Light(light) => self.light(at, light, depth),
            _ => Ok(()),
        }
    }

    fn lens(&mut self, at: usize, camera: Camera, depth: usize) -> Result<()> {
        let [width, height] = self.flight.size();
        // A tenth of a unit for a millimetre of our film.
        let tenth = 1.0 / (100.0 * self.metres());
        let [near, far] = self.flight.planes(camera)?.map(single);
        put!(self, depth, "float2 clippingRange = ({near:?}, {far:?})")?;
        let wide = single(FILM_HEIGHT * tenth * width / height);
        put!(self, depth, "float horizontalAperture = {wide:?}")?;
        let high = single(FILM_HEIGHT * tenth);
        put!(self, depth, "float verticalAperture = {high:?}")?;
        self.attribute(at, depth, "float focalLength", &Channel::Zoom, &|v| {
            format!("{:?}", single(v[0] * tenth))
        })
    }

    fn light(&mut self, at: usize, light: Light, depth: usize) -> Result<()> {
        let colour = Channel::Colour;
        self.attribute(at, depth, "color3f inputs:color", &colour, &text::colour)?;
        let intensity = Channel::Intensity;
        // A normalised sphere shines to all sides; a candela is what it gives to one.
        let per_candela = match light {
            Light::Directional => 1.0,
            Light::Point | Light::Spot => 4.0,
        };
        self.attribute(at, depth, "float inputs:intensity", &intensity, &|v| {
            format!("{:?}", single(per_candela * v[0]))
        })?;
        put!(self, depth, "bool inputs:normalize = 1")?;
        match light {
            Light::Directional => put!(self, depth, "float inputs:angle = 0.0")?,
            _ => {
                put!(self, depth, "float inputs:radius = 0.0")?;
                put!(self, depth, "bool treatAsPoint = 1")?;
            }
        }
        if light == Light::Spot {
            let angle = "float inputs:shaping:cone:angle";
            self.attribute(at, depth, angle, &Channel::Cone, &|v| {
                format!("{:?}", single(v[1]))
            })?;
            let softness = "float inputs:shaping:cone:softness";
            let soft = |v: &[f64]| {
                let inner = if v[1] > 0.0 { v[0] / v[1] } else { 1.0 };
                format!("{:?}", single(1.0 - inner))
            };
            // A quotient is not straight where both angles are.
            let straight = self.of(at).keys().track(&Channel::Cone);
            let straight = straight.is_none_or(|cone| *cone.interpolation() == Interpolation::Step);
            if straight {
                self.attribute(at, depth, softness, &Channel::Cone, &soft)?;
            } else {
                self.frames_of(at, depth, softness, &Channel::Cone, &soft)?;
            }
        }
        Ok(())
    }

    fn tell(&mut self) {
        let nodes = self.flight.scene().nodes();
        let count = |is: &dyn Fn(&Node) -> bool| nodes.iter().filter(|node| is(node)).count();
        if count(&|node| node.path().is_some()) > 0 {
            self.report.add(Loss::Path);
        }
        self.report
            .count(count(&|node| node.aim.is_some()), Loss::Aims);
        self.report.count(self.sampled, Loss::Interpolations);
        self.report.count(self.formed, Loss::Forms);
        let top = (0..nodes.len())
            .filter(|&at| self.stand(at) == Some(Stand::Top))
            .count();
        self.report.count(top, Loss::Scaled);
        let host = |node: &Node| {
            let tracks = node.keys().tracks().iter();
            tracks
                .filter(|track| matches!(track.channel(), Channel::Value { .. }))
                .count()
        };
        self.report
            .count(nodes.iter().map(host).sum(), Loss::HostChannels);
        self.report
            .count(self.flight.scene().markers().len(), Loss::Markers);
    }
}

/// The type of a prim and the schema applied to it.
fn prim_kind(kind: &Kind) -> (&'static str, &'static str) {
    match kind {
        Kind::Camera(_) => ("Camera", ""),
        Kind::Light(Light::Directional) => ("DistantLight", ""),
        Kind::Light(Light::Point) => ("SphereLight", ""),
        Kind::Light(Light::Spot) => ("SphereLight", "ShapingAPI"),
        _ => ("Xform", ""),
    }
}

/// Whether a track's own keys mean the same in the file, all over the frames that are written.
pub(super) fn keeps_keys(track: &vides_engine::scene::Track, first: f64, last: f64) -> bool {
    let (before, after) = track.extrapolation();
    let (begins, ends) = track.ends();
    matches!(
        track.interpolation(),
        Interpolation::Step | Interpolation::Linear
    ) && (before == Extrapolation::Hold || begins <= first)
        && (after == Extrapolation::Hold || last <= ends)
}
