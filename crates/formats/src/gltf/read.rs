//! A file as a scene: every node with its mesh, camera or light.
//!
//! What we wrote as several nodes (a camera with children, a pivot) comes back as one. A camera or
//! light without children is one node of ours, turned to look along z; with children, or with
//! a mesh, it becomes a separate node.

use std::borrow::Cow;
use std::collections::{HashMap, HashSet};
use std::path::{Path, absolute};

use glam::{DQuat, DVec3};
use vides_document::error::vec_with_room;
use vides_document::mesh::gltf::{Container, Local, Placed, Room};
use vides_document::{Info, SceneDocument, mesh_source};
use vides_engine::limits::MAX_FILE_BYTES;
use vides_engine::scene::{Kind, MeshSource, Node, Object, Scene, Shape};

use super::became::Became;
use super::clips::Clips;
use super::extras::{is_empty, is_visible, light_of, ours, part_of};
use super::motion::{self, Users};
use super::wrong::{of_file, of_mesh, of_place, of_tree};
use super::{key_rate, looks};
use crate::content::{DEFAULT_FPS, one_line, rate, shortened};
use crate::convention;
use crate::convention::HALF_TURN;
use crate::error::{Cause, Error, Result};
use crate::loss::{Loss, Report};
use crate::names::Names;
use crate::options::Options;
use crate::source::Source;
use crate::space;
use crate::tree::At;

/// How far a rotation may be from half a turn about y to be taken for it.
const NEARLY: f64 = 1e-6;

struct Reader<'a> {
    container: &'a Container<'a>,
    root: At<'a>,
    tree: Vec<Placed>,
    /// Children by their place in the tree.
    children: Vec<u32>,
    /// The file's nodes that an animation moves.
    moved: HashSet<usize>,
    nodes: Vec<Node>,
    became: Vec<Became>,
    names: Names,
    /// By the number of the mesh and the bits of what its vertices count from.
    objects: HashMap<(usize, [u64; 3]), Object>,
    source: Option<MeshSource>,
    room: Room,
    users: Users,
    sheared: usize,
    skins: usize,
    clamped: usize,
    flat: usize,
}

/// The scene in a file.
pub(super) fn read(
    source: &Source,
    options: &Options,
    report: &mut Report,
) -> Result<SceneDocument> {
    let mut beside = |name: &str| source.beside(name, MAX_FILE_BYTES).ok();
    let container = Container::open(Cow::Borrowed(&source.bytes), &mut beside);
    let container = container.map_err(|error| of_file(source, error))?;
    let root = At::root(container.json());
    let tree = container.tree().map_err(|error| of_tree(root, error))?;
    if tree.is_empty() {
        return Err(root.wrong(Cause::Empty));
    }
    let seen = above_the_camera(root, &tree)?;
    let clips = Clips::of(root, options.clip.as_deref(), &seen)?;
    let mut reader = Reader::new(&container, root, tree, source)?;
    reader.moved = motion::moved(&clips.taken)?;
    for at in 0..reader.tree.len() {
        reader.node(at)?;
    }
    let vides = root.get("asset").and_then(ours);
    let number = |key| vides?.get(key)?.value.as_f64();
    let otherwise = key_rate::guessed(&container, &clips.taken)?.unwrap_or(DEFAULT_FPS);
    let fps = rate(&[number("fps")], options, otherwise, report);
    reader.animate(&clips.taken, fps, report)?;
    if !clips.left.is_empty() {
        report.add(Loss::OtherAnimations((&clips.left.join(", ")).into()));
    }
    report.count(reader.sheared, Loss::Sheared);
    report.count(reader.skins, Loss::Skins);
    report.count(reader.clamped, Loss::FieldsClamped);
    report.count(reader.flat, Loss::Orthographic);
    let scenes = root
        .get("scenes")
        .map_or(Ok(0), |list| Ok::<_, Error>(list.list()?.len()))?;
    let textures = root.get("textures").and_then(|list| list.value.as_array());
    report.count(textures.map_or(0, Vec::len), Loss::Textures);
    report.count(scenes.saturating_sub(1), Loss::OtherScenes);
    let mut scene = Scene::from_nodes(reader.nodes).map_err(|(_, error)| error)?;
    let up = options.up.unwrap_or_default();
    let own = vides.and_then(|vides| {
        let centre = vides.get("centre")?.numbers::<3>().ok()?;
        let half_size = vides.get("half_size")?.number().ok()?;
        let space = vides_engine::path::Space {
            centre: centre.into(),
            half_size,
            up,
        };
        space.check().is_ok().then_some(space)
    });
    let space = match own {
        Some(own) => own,
        None => space::around(&scene, std::iter::empty(), up)?,
    };
    scene.set_space(space)?;
    let text = |key| vides.and_then(|vides| vides.get(key)?.value.as_str());
    // What does not fit is as if it were not there.
    let shown = text("camera").and_then(|name| scene.find(name));
    if shown != scene.shown_camera() {
        let _ = scene.set_camera(shown);
    }
    let range = number("frames").map(|frames| (1.0, frames));
    if range.is_some_and(|range| range != scene.frame_range()) {
        let _ = scene.set_range(range);
    }
    let info = Info {
        title: one_line(text("title").unwrap_or("")),
        comment: shortened(text("comment").unwrap_or("")),
        // The format's lengths are metres.
        unit: match vides {
            Some(_) => one_line(text("unit").unwrap_or("")),
            None => "m".to_owned(),
        },
        fps,
        first_frame: number("first_frame").map_or(1, |first| first.round() as i32),
        ..Info::default()
    };
    Ok(SceneDocument::new(scene, info)?)
}

/// The file's nodes of the first camera and of all above it.
fn above_the_camera(root: At<'_>, tree: &[Placed]) -> Result<HashSet<usize>> {
    let nodes = root.need("nodes")?;
    let mut above = HashSet::new();
    for (at, placed) in tree.iter().enumerate() {
        if nodes.element(placed.node)?.get("camera").is_some() {
            let chain = std::iter::successors(Some(at), |&at| tree[at].parent);
            above.extend(chain.map(|at| tree[at].node));
            break;
        }
    }
    Ok(above)
}

impl<'a> Reader<'a> {
    fn new(
        container: &'a Container<'a>,
        root: At<'a>,
        tree: Vec<Placed>,
        source: &Source,
    ) -> Result<Self> {
        let mut children: Vec<u32> = vec_with_room(tree.len())?;
        children.resize(tree.len(), 0);
        for parent in tree.iter().filter_map(|placed| placed.parent) {
            children[parent] += 1;
        }
        let file = source.folder.as_ref().map(|_| {
            let file = Path::new(&source.name);
            absolute(file).unwrap_or_else(|_| file.to_owned())
        });
        let source = file.map(|file| mesh_source(&file.display().to_string(), &source.bytes));
        Ok(Self {
            container,
            root,
            nodes: vec_with_room(tree.len())?,
            became: vec_with_room(tree.len())?,
            tree,
            children,
            moved: HashSet::new(),
            names: Names::default(),
            objects: HashMap::new(),
            source,
            room: Room::of(container),
            users: Users::default(),
            sheared: 0,
            skins: 0,
            clamped: 0,
            flat: 0,
        })
    }

    fn at(&self, placed: usize) -> Result<At<'a>> {
        self.root.need("nodes")?.element(self.tree[placed].node)
    }

    /// The only child of a node that is a part of it.
    fn part(&self, node: At<'a>, part: &str) -> Result<Option<usize>> {
        let mut found = None;
        let Some(children) = node.get("children") else {
            return Ok(None);
        };
        for child in children.list()? {
            let Some(number) = child.value.as_u64() else {
                continue;
            };
            let child = self.root.need("nodes")?.element(number as usize)?;
            if part_of(child, part) && !self.moved.contains(&(number as usize)) {
                if found.is_some() {
                    return Ok(None);
                }
                found = Some(number as usize);
            }
        }
        Ok(found)
    }

    /// A pivot that we wrote as a child, and the number of that child.
    fn pivot(&self, placed: usize) -> Result<Option<(DVec3, usize)>> {
        let node = self.at(placed)?;
        let Some(pivot) = ours(node).and_then(|vides| vides.get("pivot")) else {
            return Ok(None);
        };
        let Ok(pivot) = pivot.numbers::<3>() else {
            return Ok(None);
        };
        if self.children[placed] != 1 {
            return Ok(None);
        }
        let pivot = DVec3::from(pivot);
        let Some(child) = self.part(node, "pivot")? else {
            return Ok(None);
        };
        let back = self
            .translation(child)?
            .is_some_and(|by| by.as_vec3() == -pivot.as_vec3());
        Ok(back.then_some((pivot, child)))
    }

    fn local(&self, node: usize) -> Result<Local> {
        let at = self.root.need("nodes")?.element(node)?;
        let local = self.container.local(node);
        local.map_err(|error| of_place(at, error))
    }

    /// The translation of a node that has nothing else.
    fn translation(&self, node: usize) -> Result<Option<DVec3>> {
        Ok(match self.local(node)? {
            Local::Parts {
                translation,
                rotation,
                scale: DVec3::ONE,
            } if rotation == DQuat::IDENTITY => Some(translation),
            _ => None,
        })
    }

    /// What a node that we wrote above others moves them by, since they are far away.
    fn origin(&self, node: usize, at: At<'a>) -> Result<Option<DVec3>> {
        let ours = part_of(at, "origin") && !self.moved.contains(&node);
        match ours && is_empty(at) {
            true => self.translation(node),
            false => Ok(None),
        }
    }

    /// A mesh that we wrote as a child, since its vertices are far away: the number of that child
    /// and what they count from.
    fn vertices(&self, inner: At<'a>) -> Result<Option<(usize, DVec3)>> {
        let Some(child) = self.part(inner, "vertices")? else {
            return Ok(None);
        };
        let at = self.root.need("nodes")?.element(child)?;
        let plain = at.get("children").is_none() && at.get("camera").is_none();
        if !plain || at.get("mesh").is_none() || light_of(at).is_some() || !is_empty(inner) {
            return Ok(None);
        }
        Ok(self.translation(child)?.map(|origin| (child, origin)))
    }

    /// A camera or light that we wrote as a child: the number of that child.
    fn view(&self, placed: usize) -> Result<Option<usize>> {
        let own = self.at(placed)?;
        let Some(child) = self.part(own, "view")?.filter(|_| is_empty(own)) else {
            return Ok(None);
        };
        let at = self.root.need("nodes")?.element(child)?;
        let turned = match self.local(child)? {
            Local::Parts {
                translation,
                rotation,
                scale,
            } => {
                translation == DVec3::ZERO
                    && scale == DVec3::ONE
                    && rotation.dot(HALF_TURN).abs() > 1.0 - NEARLY
            }
            _ => false,
        };
        let plain = at.get("mesh").is_none() && at.get("children").is_none();
        let looks = at.get("camera").is_some() != light_of(at).is_some();
        Ok((turned && plain && looks).then_some(child))
    }

    /// One node of the file.
    fn node(&mut self, placed: usize) -> Result<()> {
        let Placed { node, parent, .. } = self.tree[placed];
        let at = self.at(placed)?;
        let above = parent.map(|parent| self.became[parent]);
        if let Some(above) = above
            && above.parts.contains(&Some(node))
        {
            // Children and mesh are those of the node above.
            self.became.push(Became {
                absorbed: true,
                turned: false,
                ..above
            });
            return Ok(());
        }
        let from = above.map_or(DVec3::ZERO, |above| above.origin);
        if let Some(origin) = self.origin(node, at)? {
            self.became.push(Became {
                node: above.and_then(|above| above.node),
                absorbed: true,
                origin: from + origin,
                ..Became::default()
            });
            return Ok(());
        }
        let pivoted = self.pivot(placed)?;
        let (pivot, inner) = match pivoted {
            Some((pivot, child)) => (pivot, self.root.need("nodes")?.element(child)?),
            None => (DVec3::ZERO, at),
        };
        let vertices = self.vertices(inner)?;
        let (holder, moved_by) = match vertices {
            Some((child, origin)) => (self.root.need("nodes")?.element(child)?, origin),
            None => (inner, DVec3::ZERO),
        };
        let view = self.view(placed)?;
        let seen = match view {
            Some(child) => self.root.need("nodes")?.element(child)?,
            None => at,
        };
        self.skins += usize::from(holder.get("skin").is_some());
        let (mesh, camera, light) = (holder.get("mesh"), seen.get("camera"), light_of(seen));
        let free = self.children[placed] == 0 && mesh.is_none();
        let both = camera.is_some() && light.is_some();
        let alone = !both && (view.is_some() || free);
        let turned = alone && view.is_none() && (camera.is_some() || light.is_some());
        let kind = match (mesh, camera, light) {
            (Some(mesh), _, _) => Kind::Object(self.object(holder, mesh, moved_by)?),
            _ => Kind::Group,
        };
        let wanted = match at.get("name").and_then(|name| name.value.as_str()) {
            Some(name) if !name.is_empty() => name.to_owned(),
            _ => {
                let kinds = [(mesh, "object"), (camera, "camera"), (light, "light")];
                let kind = kinds.iter().find(|(has, _)| has.is_some());
                format!("{} {node}", kind.map_or("node", |(_, kind)| kind))
            }
        };
        let mut own = Node::new(&self.names.unique(&wanted)?, kind);
        own.parent = above.and_then(|above| above.node);
        own.pivot = pivot;
        // What the file's positions count from.
        let from = pivot - from;
        self.place(node, at, &mut own, turned, from)?;
        own.rest.visible = is_visible(at);
        let number = self.nodes.len();
        self.became.push(Became {
            node: Some(number),
            turned,
            pivot: from,
            absorbed: false,
            parts: [
                pivoted.map(|(_, child)| child),
                view,
                vertices.map(|(child, _)| child),
            ],
            origin: DVec3::ZERO,
        });
        if let Some(mesh) = mesh
            && let Some(material) = looks::material(self.root, mesh)?
        {
            own.rest.colour = looks::base_colour(self.root, material)?;
            self.users.material(material, number)?;
        }
        self.push(own)?;
        let parts = [(camera, true), (light, false)];
        for (found, is_camera) in parts {
            let Some(found) = found else { continue };
            let number = if alone {
                number
            } else {
                let name = self.names.unique(&format!("{wanted} view"))?;
                let mut child = Node::new(&name, Kind::Group);
                child.parent = Some(number);
                child.rest.rotation = HALF_TURN.inverse();
                self.push(child)?;
                self.nodes.len() - 1
            };
            self.look(number, found, is_camera)?;
        }
        Ok(())
    }

    fn push(&mut self, node: Node) -> Result<()> {
        self.nodes.try_reserve(1)?;
        self.nodes.push(node);
        Ok(())
    }

    /// Where it stands in its parent.
    fn place(
        &mut self,
        node: usize,
        at: At<'a>,
        own: &mut Node,
        turned: bool,
        from: DVec3,
    ) -> Result<()> {
        let (position, rotation, scale) = match self.local(node)? {
            Local::Matrix(matrix) => {
                let parts = convention::parts(matrix);
                self.sheared += usize::from(parts.sheared);
                (parts.position, parts.rotation, parts.scale)
            }
            Local::Parts {
                translation,
                rotation,
                scale,
            } => {
                let length = rotation.length();
                if !(length > 1e-12) {
                    return Err(at.wrong(Cause::NoRotation));
                }
                (translation, rotation / length, scale)
            }
        };
        own.rest.position = position - from;
        own.rest.rotation = match turned {
            true => rotation * HALF_TURN.inverse(),
            false => rotation,
        };
        own.rest.scale = scale;
        Ok(())
    }

    /// Makes a node a camera or light.
    fn look(&mut self, number: usize, found: At<'a>, is_camera: bool) -> Result<()> {
        let node = &mut self.nodes[number];
        let index = found.index()?;
        if is_camera {
            let read = looks::camera(self.root, index)?;
            self.clamped += usize::from(read.clamped);
            self.flat += usize::from(read.flat);
            node.kind = Kind::Camera(read.camera);
            node.rest.zoom = read.zoom;
            self.users.camera(index, number)
        } else {
            let light = looks::light(self.root, index, &mut node.rest)?;
            node.kind = Kind::Light(light);
            self.users.light(index, number)
        }
    }

    /// An object with the mesh of this number; objects of one mesh share it.
    fn object(&mut self, node: At<'a>, mesh: At<'a>, origin: DVec3) -> Result<Object> {
        let number = mesh.index()?;
        let key = (number, origin.to_array().map(f64::to_bits));
        let mesh = self.root.need("meshes")?.element(number)?;
        let mut object = match self.objects.get(&key) {
            Some(known) => known.clone(),
            None => {
                let object = self.new_object(number, mesh, origin)?;
                self.objects.try_reserve(1)?;
                self.objects.insert(key, object.clone());
                object
            }
        };
        let weights = node.get("weights").or_else(|| mesh.get("weights"));
        if let Some(weights) = weights.filter(|_| !object.mesh().points.is_empty()) {
            let count = object.shapes().len();
            let list = weights.list()?;
            if list.len() != count {
                return Err(weights.wrong(Cause::NumberCount {
                    wanted: count,
                    found: list.len(),
                }));
            }
            let numbers: Vec<f64> = list.map(At::number).collect::<Result<_>>()?;
            object.set_weights(&numbers)?;
        }
        Ok(object)
    }

    fn new_object(&mut self, number: usize, mesh: At<'a>, origin: DVec3) -> Result<Object> {
        let mut part = self
            .container
            .part(number, &mut self.room, &mut |_| true)
            .map_err(|error| of_mesh(self.container, mesh, error))?;
        let names = mesh
            .get("extras")
            .and_then(|extras| extras.get("targetNames")?.value.as_array());
        let mut object = Object::default();
        if part.mesh.points.is_empty() {
            return Ok(object);
        }
        let targets = part.targets.iter_mut().flatten();
        for point in part.mesh.points.iter_mut().chain(targets) {
            *point += origin;
        }
        object.set_mesh(part.mesh)?;
        // The file alone would give its vertices without what they count from.
        if let Some(source) = self.source.as_ref().filter(|_| origin == DVec3::ZERO) {
            object.set_source(Some(MeshSource {
                part: u32::try_from(number).ok(),
                ..source.clone()
            }))?;
        }
        let mut shapes = Names::default();
        for (at, points) in part.targets.into_iter().enumerate() {
            let name = names.and_then(|names| names.get(at)?.as_str());
            let name = name.map_or_else(|| format!("shape {at}"), ToOwned::to_owned);
            object.add_shape(Shape {
                name: shapes.unique(&name)?,
                points,
                colours: Vec::new(),
            })?;
        }
        Ok(object)
    }

    fn animate(&mut self, clips: &[At<'_>], fps: f64, report: &mut Report) -> Result<()> {
        let nodes = self
            .root
            .get("nodes")
            .and_then(|nodes| nodes.value.as_array());
        let mut became: Vec<Option<Became>> = vec_with_room(nodes.map_or(0, Vec::len))?;
        became.resize(nodes.map_or(0, Vec::len), None);
        for (placed, own) in self.tree.iter().zip(&self.became) {
            became[placed.node] = Some(*own);
        }
        let mut motion = motion::Reader {
            container: self.container,
            fps,
            nodes: &mut self.nodes,
            became: &became,
            users: &self.users,
            clamped: 0,
            left_out: 0,
            room: motion::room(),
        };
        for clip in clips {
            motion.animation(*clip)?;
        }
        self.clamped += motion.clamped;
        report.count(motion.left_out, Loss::OtherTracks);
        Ok(())
    }
}

/// Whether a file's text is one of this format.
pub(super) fn is_text(bytes: &[u8]) -> bool {
    let begins =
        |bytes: &[u8]| bytes.iter().find(|byte| !byte.is_ascii_whitespace()) == Some(&b'{');
    let holds = |word: &[u8]| bytes.windows(word.len()).any(|window| window == word);
    begins(bytes) && holds(b"\"asset\"") && holds(b"\"version\"")
}
