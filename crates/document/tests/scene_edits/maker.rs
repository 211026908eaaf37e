//! Random edits of scenes, and all that an edit may change as text.

use std::fmt::Write;

use glam::{DQuat, DVec3};
use vides_document::{Document, Edit};
use vides_engine::deform::Deformation;
use vides_engine::path::{CameraPath, SupportPoint};
use vides_engine::scene::{
    Camera, Channel, Extrapolation, FollowPath, Geometry, Interpolation, Keep, KeyList, Kind,
    Light, Manner, Mesh, Node, Object, Part, Rest, Scene, Shape, Track,
};

/// All kinds of edits that [`Maker`] makes.
pub(crate) const KINDS: [&str; 28] = [
    "add",
    "copy",
    "parent",
    "rename-marker",
    "edit-node",
    "edit-path",
    "remove",
    "name",
    "rest",
    "links",
    "path",
    "start",
    "track",
    "keys",
    "manner",
    "mesh",
    "weights",
    "insert-shape",
    "remove-shape",
    "insert-deformation",
    "remove-deformation",
    "deformation",
    "move-deformation",
    "marker",
    "no-marker",
    "pin",
    "camera",
    "range",
];

pub(crate) fn kinds(edit: &Edit) -> &'static str {
    let at = match edit {
        Edit::AddNodes(_) => 0,
        Edit::CopyNodes(_) => 1,
        Edit::SetParent { .. } => 2,
        Edit::RenameMarker { .. } => 3,
        Edit::EditNode(_) => 4,
        Edit::Part(part) => match **part {
            Part::Remove(_) => 6,
            Part::Name { .. } => 7,
            Part::Rest { .. } => 8,
            Part::Links { .. } => 9,
            Part::Path { .. } => 10,
            Part::Start { .. } => 11,
            Part::Track { .. } => 12,
            Part::Keys { .. } => 13,
            Part::Manner { .. } => 14,
            Part::Mesh { .. } => 15,
            Part::Weights { .. } => 16,
            Part::InsertShape { .. } => 17,
            Part::RemoveShape { .. } => 18,
            Part::InsertDeformation { .. } => 19,
            Part::RemoveDeformation { .. } => 20,
            Part::Deformation { .. } => 21,
            Part::MoveDeformation { .. } => 22,
            Part::Marker { frame: Some(_), .. } => 23,
            Part::Marker { .. } => 24,
            Part::Pin { .. } => 25,
            Part::Camera(_) => 26,
            Part::Range(_) => 27,
            _ => unreachable!("not made here: {part:?}"),
        },
        _ => 5,
    };
    KINDS[at]
}

/// The nodes of a scene; `{:?}` tells 0 from −0 and gives every digit.
pub(crate) fn nodes(scene: &Scene) -> String {
    let mut text = String::new();
    for node in scene.nodes() {
        let mut still = node.clone();
        still.set_path(None).unwrap();
        writeln!(text, "{still:?}").unwrap();
        if let Some(path) = node.path() {
            let (start, beyond) = (path.start_frame(), path.extrapolation());
            writeln!(text, "{:?} {start:?} {beyond:?}", path.path()).unwrap();
        }
    }
    text
}

/// All that undo restores.
pub(crate) fn whole(document: &Document) -> String {
    let scene = document.scene().unwrap();
    let edited = document.edited_scene().map(|edited| edited.node());
    format!(
        "{}{:?} {:?} {:?} {:?} {:?}\n{edited:?} {:?}\n{:?} {:?}",
        nodes(&scene),
        scene.markers(),
        scene.pins(),
        scene.camera(),
        scene.range(),
        scene.space(),
        document.path(),
        document.info(),
        document.selection(),
    )
}

/// A splitmix64 generator of edits.
pub(crate) struct Maker {
    state: u64,
    most: usize,
}

const CHANNELS: [&str; 14] = [
    "position",
    "rotation",
    "scale",
    "visible",
    "zoom",
    "roll",
    "colour",
    "intensity",
    "cone",
    "weights",
    "aim_weight",
    "deformation.0.angle",
    "value:radius",
    "value:wind:3",
];

const WAYS: [&str; 10] = [
    "step",
    "linear",
    "ramp",
    "sine",
    "catmull-rom",
    "hermite",
    "tcb",
    "cubic",
    "euler-linear",
    "euler-catmull-rom",
];

impl Maker {
    pub(crate) fn new(seed: u64) -> Self {
        let most = [12, 30, 60, 200][(seed % 4) as usize];
        Self { state: seed, most }
    }

    fn next(&mut self) -> u64 {
        self.state = self.state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.state;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn below(&mut self, count: usize) -> usize {
        (self.next() % count.max(1) as u64) as usize
    }

    pub(crate) fn now_and_then(&mut self, every: usize) -> bool {
        self.below(every) == 0
    }

    fn number(&mut self) -> f64 {
        match self.below(40) {
            0 => 0.0,
            1 => -0.0,
            2 => 1e10,
            3 => f64::NAN,
            _ => (self.next() >> 11) as f64 / (1_u64 << 52) as f64 - 1.0,
        }
    }

    fn vector(&mut self) -> DVec3 {
        DVec3::new(self.number(), self.number(), self.number())
    }

    fn pick<T: Copy>(&mut self, all: &[T]) -> T {
        all[self.below(all.len())]
    }

    fn name(&mut self) -> String {
        format!(
            "{}{}",
            self.pick(&["lamp", "car", "arm", "eye"]),
            self.below(300)
        )
    }

    fn marker(&mut self) -> String {
        self.pick(&["begin", "middle", "end"]).to_owned()
    }

    fn kind(&mut self) -> Kind {
        match self.below(4) {
            0 => Kind::Group,
            1 => Kind::Light(self.pick(&[Light::Point, Light::Spot])),
            2 => Kind::Camera(Camera::default()),
            _ => Kind::Object(Object::default()),
        }
    }

    fn values(&mut self, node: &Node) -> Rest {
        let mut rest = Rest::of(node);
        let values = &mut rest.values;
        match self.below(7) {
            0 => values.position = self.vector(),
            1 => values.rotation = DQuat::from_euler(glam::EulerRot::XYZ, self.number(), 0.3, 0.5),
            2 => values.scale = self.vector(),
            3 => values.visible = !values.visible,
            4 => values.colour = self.vector().abs().to_array(),
            5 => values.roll = 90.0 * self.number(),
            _ => values.intensity = self.number().abs(),
        }
        if !node.kind.looks() && self.now_and_then(3) {
            rest.pivot = self.vector();
        }
        if let Kind::Light(light) = &mut rest.kind {
            *light = self.pick(&[Light::Directional, Light::Spot]);
        }
        rest
    }

    fn path(&mut self) -> Option<FollowPath> {
        let mut path = CameraPath::default();
        for _ in 0..self.below(3) {
            path.points.push(SupportPoint::new(0.5 * self.vector()));
        }
        let start = (100.0 * self.number()).round();
        FollowPath::new(path, start, self.beyond()).ok()
    }

    fn beyond(&mut self) -> Extrapolation {
        use Extrapolation::{Hold, Offset, PingPong, Repeat};
        self.pick(&[Hold, Hold, Repeat, PingPong, Offset])
    }

    fn track(&mut self, channel: Channel, width: usize) -> Option<Track> {
        let by = Interpolation::parse(self.pick(&WAYS)).ok()?;
        let count = 1 + self.below(6);
        let frames = (0..count)
            .map(|at| at as f64 * 10.0 + self.number().min(5.0))
            .collect();
        let euler = by.to_string().starts_with("euler");
        let width = if euler { 3 } else { width };
        let values: Vec<f64> = (0..count * width).map(|_| self.value(&channel)).collect();
        let shape = match by {
            Interpolation::Hermite => 2 * width,
            Interpolation::Tcb => 3,
            _ => 0,
        };
        let shape = (0..shape * count).map(|_| self.number()).collect();
        let track = Track::new(channel, by, frames, values, shape).ok()?;
        let (before, after) = (self.beyond(), self.beyond());
        track.with_extrapolation(before, after).ok()
    }

    fn value(&mut self, channel: &Channel) -> f64 {
        let number = self.number();
        match channel {
            Channel::Visible => f64::from(u8::from(number > 0.0)),
            Channel::Zoom => 24.0 + number,
            Channel::Cone => 30.0,
            Channel::Colour | Channel::Intensity | Channel::AimWeight => number.abs(),
            _ => number,
        }
    }

    fn mesh(&mut self, points: usize) -> Mesh {
        Mesh {
            points: (0..points).map(|_| self.vector()).collect(),
            lines: vec![[0, 0]],
            ..Mesh::default()
        }
    }

    fn deformation(&mut self) -> Deformation {
        let axis = self.below(3) as f64;
        let angle = 90.0 * self.number();
        let made = match self.below(3) {
            0 => Deformation::new("twist", &[axis, angle]),
            1 => Deformation::new("bend", &[axis, angle]),
            _ => Deformation::new("taper", &[axis, 1.5]),
        };
        made.unwrap_or_else(|_| Deformation::new("twist", &[0.0, 1.0]).unwrap())
    }

    /// An edit, now and then an impossible one.
    pub(crate) fn edit(&mut self, document: &Document) -> Edit {
        let alone = Scene::of_path(CameraPath::default()).unwrap();
        let scene = document
            .edited_scene()
            .map_or(&alone, |edited| edited.scene());
        let count = scene.nodes().len();
        let at = self.below(count + usize::from(self.state.is_multiple_of(64)));
        match self.below(40) {
            0..=5 if count < self.most => {
                let more = 1 + self.below(3);
                let nodes = (0..more).map(|_| self.node(count + more)).collect();
                Edit::AddNodes(nodes)
            }
            6 if count * 2 < self.most => Edit::CopyNodes(vec![at, self.below(count)]),
            7..=8 => Edit::SetParent {
                node: at,
                parent: self.now_and_then(2).then(|| self.below(count)),
                keep: self.pick(&[Keep::Place, Keep::Numbers]),
            },
            9 => Edit::RenameMarker {
                from: self.marker(),
                to: self.marker(),
            },
            10 => {
                let paths = (0..count).filter(|&at| scene.nodes()[at].path().is_some());
                let paths: Vec<usize> = paths.collect();
                let node = (!paths.is_empty() && !self.now_and_then(4)).then(|| self.pick(&paths));
                Edit::EditNode(node)
            }
            11 => Edit::AppendAfterLast,
            12 => Edit::RemovePoint {
                at: self.below(document.path().points.len()),
            },
            _ => Edit::Part(Box::new(self.part(scene, at))),
        }
    }

    fn node(&mut self, count: usize) -> Node {
        let mut node = Node::new("", self.kind());
        node.name = self.name();
        node.parent = self.now_and_then(2).then(|| self.below(count));
        if node.kind.looks() {
            node.aim = self.now_and_then(4).then(|| self.below(count));
        }
        if self.now_and_then(3) {
            let _ = node.set_path(self.path());
        }
        node
    }

    fn part(&mut self, scene: &Scene, at: usize) -> Part {
        let count = scene.nodes().len();
        let Some(node) = scene.nodes().get(at) else {
            return Part::Remove(vec![at]);
        };
        let tracks = node.keys().tracks();
        let known = (!tracks.is_empty()).then(|| self.below(tracks.len()));
        match self.below(26) {
            0 if self.now_and_then(4) => Part::Remove(vec![at, self.below(count)]),
            0..=1 => Part::Name {
                node: at,
                name: self.name(),
            },
            2..=3 => Part::Rest {
                node: at,
                rest: Box::new(self.values(node)),
            },
            4 => Part::Links {
                node: at,
                parent: self.now_and_then(2).then(|| self.below(count)),
                aim: self.now_and_then(2).then(|| self.below(count)),
            },
            5 => {
                let path = if self.now_and_then(4) {
                    None
                } else {
                    self.path()
                };
                Part::path(at, path).unwrap()
            }
            6 => Part::Start {
                node: at,
                start_frame: (100.0 * self.number()).round(),
                beyond: self.beyond(),
            },
            7..=8 => {
                let channel = Channel::parse(self.pick(&CHANNELS)).unwrap();
                let width = channel.width(node).unwrap_or(1);
                let track = self.track(channel.clone(), width);
                Part::track(at, channel, track).unwrap()
            }
            9..=12 => match known {
                Some(known) => self.keys(at, &tracks[known]),
                None => Part::Camera(self.now_and_then(2).then_some(at)),
            },
            13 => match known {
                Some(known) => self.manner(at, &tracks[known]),
                None => Part::Range(Some((-self.number().abs(), 50.0 + self.number()))),
            },
            14 => Part::Range(self.now_and_then(2).then(|| (1.0, 20.0 + self.number()))),
            15 => {
                let (name, frame) = (self.marker(), Some((60.0 * self.number()).round()));
                Part::Marker { name, frame }
            }
            16 => {
                let (name, frame) = (self.marker(), None);
                Part::Marker { name, frame }
            }
            17..=18 => {
                let paths = scene.nodes().iter().position(|node| node.path().is_some());
                Part::Pin {
                    node: paths.unwrap_or(at),
                    point: self.below(4),
                    marker: (!self.now_and_then(4)).then(|| self.marker()),
                }
            }
            _ => self.of_object(scene, at),
        }
    }

    fn keys(&mut self, node: usize, track: &Track) -> Part {
        let [width, shape] = track.key_numbers();
        let mut remove: Vec<usize> = (0..track.frames().len())
            .filter(|_| self.now_and_then(3))
            .collect();
        let mut put = KeyList::default();
        if !self.now_and_then(6) {
            let mut frame = 30.0 * self.number();
            for _ in 0..self.below(4) {
                put.frames.push(frame);
                put.values
                    .extend((0..width).map(|_| self.value(track.channel())));
                put.shape.extend((0..shape).map(|_| self.number()));
                frame += 10.0 * self.number().abs();
            }
            // On one that is there.
            if self.now_and_then(4)
                && let Some(frame) = put.frames.first_mut()
            {
                *frame = self.pick(track.frames());
            }
        } else if self.now_and_then(2) {
            remove = (0..track.frames().len()).collect();
        }
        Part::Keys {
            node,
            channel: track.channel().clone(),
            remove,
            put,
        }
    }

    fn manner(&mut self, node: usize, track: &Track) -> Part {
        let interpolation = Interpolation::parse(self.pick(&WAYS)).unwrap();
        let count = track.frames().len();
        let shape = match interpolation {
            Interpolation::Hermite => 2 * track.width() * count,
            Interpolation::Tcb => 3 * count,
            _ => 0,
        };
        let manner = Manner {
            interpolation,
            shape: (0..shape).map(|_| self.number()).collect(),
            before: self.beyond(),
            after: self.beyond(),
        };
        Part::Manner {
            node,
            channel: track.channel().clone(),
            manner: Box::new(manner),
        }
    }

    fn of_object(&mut self, scene: &Scene, at: usize) -> Part {
        let objects = (0..scene.nodes().len()).filter(|&at| scene.object(at).is_ok());
        let objects: Vec<usize> = objects.collect();
        let node = if objects.is_empty() {
            at
        } else {
            self.pick(&objects)
        };
        let object = scene.object(node).cloned().unwrap_or_default();
        let points = object.mesh().points.len();
        let (shapes, deformations) = (object.shapes().len(), object.deformations().len());
        match self.below(8) {
            0 => {
                let points = if shapes > 0 && !self.now_and_then(4) {
                    points
                } else {
                    1 + self.below(3)
                };
                match Geometry::new(self.mesh(points.max(1)), None) {
                    Ok(mesh) => Part::Mesh { node, mesh },
                    Err(_) => Part::Remove(vec![usize::MAX]),
                }
            }
            1 => Part::Weights {
                node,
                weights: (0..shapes).map(|_| self.number()).collect(),
            },
            2 => {
                let shape = Shape {
                    name: self.name(),
                    points: (0..points).map(|_| self.vector()).collect(),
                    colours: Vec::new(),
                };
                let place = self.below(shapes + 1);
                Part::insert_shape(node, place, shape).unwrap()
            }
            3 => Part::RemoveShape {
                node,
                at: self.below(shapes),
            },
            4 => Part::InsertDeformation {
                node,
                at: self.below(deformations + 1),
                deformation: self.deformation(),
                bounds: None,
            },
            5 => Part::RemoveDeformation {
                node,
                at: self.below(deformations),
            },
            6 => Part::Deformation {
                node,
                at: self.below(deformations),
                deformation: self.deformation(),
                bounds: None,
            },
            _ => Part::MoveDeformation {
                node,
                from: self.below(deformations),
                to: self.below(deformations),
            },
        }
    }
}
