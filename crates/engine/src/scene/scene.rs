//! The scene: its nodes, its markers, and every way in which they change.

use std::sync::Arc;

use super::channel::Channel;
use super::hierarchy;
use super::marker::{Marker, Pin};
use super::membership::NodeId;
use super::mesh::{Mesh, MeshSource, Object, Shape};
use super::motion::FollowPath;
use super::node::{Camera, Kind, Node};
use super::order::Order;
use super::part::Part;
use super::side_by_side::Nodes;
use super::time::Extrapolation;
use super::track::Track;
use crate::deform::{Bounds, Deformation};
use crate::error::{
    Error, Invalid, OutOfRange, Place, Result, TooMany, can_allocate, vec_with_room,
};
use crate::limits::{MAX_NODES, MAX_SCENE_NUMBERS};
use crate::path::{CameraPath, Space};
use crate::shared_list::SharedList;

/// A tree of nodes, numbered from 0, on one timeline. Whatever is done to it, it stays valid.
#[derive(Debug, Clone, Default)]
pub struct Scene {
    pub(super) nodes: Nodes,
    /// Nodes in the order of evaluation.
    pub(super) order: Order,
    /// Nodes by name.
    pub(super) names: Arc<Vec<usize>>,
    /// Which nodes they are, by number.
    pub(super) ids: Arc<Vec<NodeId>>,
    pub(super) markers: Vec<Marker>,
    pub(super) pins: Vec<Pin>,
    /// All numbers of all keys.
    pub(super) numbers: usize,
    /// The camera that was chosen to be shown.
    pub(super) camera: Option<usize>,
    /// The first and the last frame, where they were chosen.
    pub(super) range: Option<(f64, f64)>,
    pub(super) space: Space,
}

impl PartialEq for Scene {
    fn eq(&self, other: &Self) -> bool {
        self.nodes == other.nodes
            && self.markers == other.markers
            && self.pins == other.pins
            && self.space == other.space
            && self.camera == other.camera
            && self.range == other.range
    }
}

impl Scene {
    /// A scene without nodes.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// A scene with one camera, "camera", that follows a path from frame 1 on.
    ///
    /// # Errors
    /// As [`FollowPath::new`].
    pub fn of_path(path: CameraPath) -> Result<Self> {
        let space = path.space;
        let mut camera = Node::new("camera", Kind::Camera(Camera::default()));
        camera.set_path(Some(FollowPath::new(path, 1.0, Extrapolation::Hold)?))?;
        let mut scene = Self {
            space,
            ..Self::new()
        };
        scene.add(camera)?;
        scene.ids = Arc::new(vec![NodeId::OF_PATH]);
        Ok(scene)
    }

    /// Where it is in the world, and the up axis for nodes that aim. A path in it has its own.
    #[must_use]
    pub const fn space(&self) -> Space {
        self.space
    }

    /// Sets [`Scene::space`].
    ///
    /// # Errors
    /// As [`Space::check`].
    pub fn set_space(&mut self, space: Space) -> Result<()> {
        space.check()?;
        self.space = space;
        Ok(())
    }

    /// A scene of these nodes, whose parents and aims are numbers among them.
    ///
    /// # Errors
    /// The number of a node and what is wrong there, with its name.
    pub fn from_nodes(nodes: Vec<Node>) -> Result<Self, (usize, Error)> {
        let whole = |error| (0, error);
        let each = size_of::<(Node, [usize; 8])>();
        can_allocate(nodes.len() * each).map_err(whole)?;
        let nodes = SharedList::from(nodes);
        check_count(nodes.len()).map_err(whole)?;
        let mut names: Vec<usize> = vec_with_room(nodes.len()).map_err(whole)?;
        names.extend(0..nodes.len());
        names.sort_unstable_by(|&a, &b| nodes[a].name.cmp(&nodes[b].name));
        for pair in names.windows(2) {
            if nodes[pair[0]].name == nodes[pair[1]].name {
                let later = pair[0].max(pair[1]);
                return Err((later, taken(&nodes[later].name)));
            }
        }
        for (at, node) in nodes.iter().enumerate() {
            check_node(node, at).map_err(|error| (at, error))?;
        }
        let numbers = nodes.iter().map(|node| node.keys.numbers()).sum();
        check_numbers(numbers).map_err(whole)?;
        Ok(Self {
            order: hierarchy::order(&nodes)?.into(),
            ids: Arc::new(nodes.iter().map(|_| NodeId::fresh()).collect()),
            nodes: nodes.into(),
            names: Arc::new(names),
            numbers,
            ..Self::default()
        })
    }

    /// The nodes.
    #[must_use]
    pub fn nodes(&self) -> &SharedList<Node> {
        &self.nodes
    }

    /// A node by its number.
    ///
    /// # Errors
    /// [`Error::Range`] if it does not exist.
    pub fn node(&self, at: usize) -> Result<&Node> {
        self.nodes.get(at).ok_or_else(|| self.no_node(at))
    }

    fn node_mut(&mut self, at: usize) -> Result<&mut Node> {
        if at >= self.nodes.len() {
            return Err(self.no_node(at));
        }
        Ok(&mut self.nodes[at])
    }

    fn no_node(&self, at: usize) -> Error {
        Error::Range(OutOfRange::NoNode {
            node: at,
            count: self.nodes.len(),
        })
    }

    /// The number of the node with this name.
    #[must_use]
    pub fn find(&self, name: &str) -> Option<usize> {
        self.place_of(name).ok().map(|at| self.names[at])
    }

    /// Where among the names it stands, or would.
    pub(super) fn place_of(&self, name: &str) -> Result<usize, usize> {
        self.names
            .binary_search_by(|&node| self.nodes[node].name.as_str().cmp(name))
    }

    /// Adds a node behind the others and returns its number.
    ///
    /// # Errors
    /// What is wrong with it; nothing has changed then.
    pub fn add(&mut self, node: Node) -> Result<usize> {
        let at = self.nodes.len();
        check_count(at + 1)?;
        check_node(&node, at)?;
        let Err(place) = self.place_of(&node.name) else {
            return Err(taken(&node.name));
        };
        let numbers = self.numbers + node.keys.numbers();
        check_numbers(numbers)?;
        if let Some(parent) = node.parent {
            self.check_below(parent, &node.name)?;
        }
        if let Some(aim) = node.aim {
            self.node(aim).map_err(|error| {
                let place = Place::Node((&node.name).into());
                error.at(Place::Aim).at(place)
            })?;
        }
        self.order.add(&node);
        self.nodes.push(node);
        Arc::make_mut(&mut self.names).insert(place, at);
        Arc::make_mut(&mut self.ids).push(NodeId::fresh());
        self.numbers = numbers;
        Ok(at)
    }

    fn check_below(&self, parent: usize, name: &str) -> Result<()> {
        let place = |error: Error| error.at(Place::Node(name.into()));
        self.node(parent)
            .map_err(|error| place(error.at(Place::Parent)))?;
        let levels = std::iter::successors(Some(parent), |&at| self.nodes[at].parent).count();
        if levels >= crate::limits::MAX_LEVELS {
            return Err(place(TooMany::Levels.into()));
        }
        Ok(())
    }

    /// Gives a node another name.
    ///
    /// # Errors
    /// [`Error::Argument`] for the name, [`Error::Range`], [`Error::Limit`], [`Error::Memory`].
    pub fn set_name(&mut self, at: usize, name: &str) -> Result<()> {
        let (node, name) = (at, copy(name)?);
        self.apply(Part::Name { node, name })
    }

    /// Gives a node other values: parent, aim, pivot, rest values, and what a light or a camera
    /// has. Name, motion and geometry stay. The values are taken as of the old parent: in another
    /// one the node stays where it is in the world at the scene's first frame.
    ///
    /// # Errors
    /// What is wrong with them; nothing has changed then.
    pub fn set_node(&mut self, at: usize, values: &Node) -> Result<()> {
        let old = self.node(at)?;
        let mut new = Node {
            name: copy(&old.name)?,
            kind: values.kind.clone(),
            parent: values.parent,
            aim: values.aim,
            pivot: values.pivot,
            rest: values.rest,
            ..Node::default()
        };
        if std::mem::discriminant(&old.kind) != std::mem::discriminant(&new.kind) {
            return Err(Invalid::KindStays {
                node: (&old.name).into(),
                kind: old.kind.name(),
            }
            .into());
        }
        check_node(&new, at)?;
        if old.parent != new.parent {
            self.keep_world(at, &mut new)?;
        }
        self.link(at, new.parent, new.aim)?;
        let node = self.nodes.still(at);
        (node.pivot, node.rest) = (new.pivot, new.rest);
        if !matches!(node.kind, Kind::Object(_)) {
            node.kind = new.kind;
        }
        Ok(())
    }

    /// Puts a node into another one and lets it aim at another one, where the tree allows that.
    pub(super) fn link(
        &mut self,
        at: usize,
        parent: Option<usize>,
        aim: Option<usize>,
    ) -> Result<()> {
        let node = &self.nodes[at];
        let old = (node.parent, node.aim);
        if old == (parent, aim) {
            return Ok(());
        }
        if self.order.moved(&self.nodes, at, (parent, aim))? {
            let node = self.nodes.still(at);
            (node.parent, node.aim) = (parent, aim);
            return Ok(());
        }
        (self.nodes[at].parent, self.nodes[at].aim) = (parent, aim);
        match hierarchy::order(&self.nodes) {
            Ok(order) => {
                self.order = order.into();
                Ok(())
            }
            Err((_, error)) => {
                (self.nodes[at].parent, self.nodes[at].aim) = old;
                Err(error)
            }
        }
    }

    /// Sets the path of a node. Pins of points that it lacks go, the others hold ([`super::pins`]).
    ///
    /// # Errors
    /// [`Error::Range`] for the node; as [`Node::set_path`] and [`super::pins::pinned`].
    pub fn set_path(&mut self, at: usize, path: Option<FollowPath>) -> Result<()> {
        self.node(at)?;
        let path = match path {
            Some(path) => Some(self.held_by_pins(at, &path)?.unwrap_or(path)),
            None => None,
        };
        let node = self.node_mut(at)?;
        node.set_path(path)?;
        let count = node.path().map_or(0, |path| path.path().points.len());
        self.pins.retain(|pin| pin.node != at || pin.point < count);
        Ok(())
    }

    /// The same with other pins: points and names of markers, in the order of the points.
    ///
    /// # Errors
    /// As [`Scene::set_path`]; nothing has changed then.
    pub fn set_pinned_path(
        &mut self,
        at: usize,
        path: FollowPath,
        pins: impl Iterator<Item = (usize, String)>,
    ) -> Result<()> {
        let mut others: Vec<Pin> = vec_with_room(self.pins.len() + pins.size_hint().0)?;
        others.extend(self.pins.iter().filter(|pin| pin.node < at).cloned());
        others.extend(pins.map(|(point, marker)| Pin {
            node: at,
            point,
            marker,
        }));
        others.extend(self.pins.iter().filter(|pin| pin.node > at).cloned());
        std::mem::swap(&mut self.pins, &mut others);
        let done = self.set_path(at, Some(path));
        if done.is_err() {
            self.pins = others;
        }
        done
    }

    /// Sets a track of a node in place of the one of the same channel.
    ///
    /// # Errors
    /// [`Error::Range`], [`Error::Argument`], [`Error::Limit`], [`Error::Memory`].
    pub fn set_track(&mut self, at: usize, track: Track) -> Result<()> {
        let node = self.node(at)?;
        let old = node
            .keys
            .track(track.channel())
            .map_or(0, Track::numbers_kept);
        let numbers = self.numbers - old + track.numbers_kept();
        check_numbers(numbers)?;
        self.node_mut(at)?.set_track(track)?;
        self.numbers = numbers;
        Ok(())
    }

    /// Removes the track of a channel, if there is one.
    ///
    /// # Errors
    /// [`Error::Range`] for the node.
    pub fn remove_track(&mut self, at: usize, channel: &Channel) -> Result<()> {
        let node = self.node_mut(at)?;
        let before = node.keys.numbers();
        node.remove_track(channel);
        let after = node.keys.numbers();
        self.numbers -= before - after;
        Ok(())
    }

    /// The object that a node is.
    ///
    /// # Errors
    /// [`Error::Range`] if there is no such node, [`Error::Argument`] if it is no object.
    pub fn object(&self, at: usize) -> Result<&Object> {
        let node = self.node(at)?;
        match &node.kind {
            Kind::Object(object) => Ok(object),
            _ => Err(Invalid::NoObject((&node.name).into()).into()),
        }
    }

    fn object_mut(&mut self, at: usize) -> Result<&mut Object> {
        let node = self.node_mut(at)?;
        match &mut node.kind {
            Kind::Object(object) => Ok(object),
            _ => Err(Invalid::NoObject((&node.name).into()).into()),
        }
    }

    /// Sets an object's mesh.
    ///
    /// # Errors
    /// As [`Object::set_mesh`]; [`Error::Argument`] if it is no object.
    pub fn set_mesh(&mut self, at: usize, mesh: Mesh) -> Result<()> {
        self.object_mut(at)?.set_mesh(mesh)
    }

    /// Sets an object's mesh and the file that it came from.
    ///
    /// # Errors
    /// As [`Scene::set_mesh`].
    pub fn set_mesh_of(&mut self, at: usize, source: MeshSource, mesh: Mesh) -> Result<()> {
        let object = self.object_mut(at)?;
        object.set_mesh(mesh)?;
        object.set_source(Some(source))
    }

    /// Gives an object the mesh of another, which both share then, and the file that it came from.
    ///
    /// # Errors
    /// [`Error::Range`] for the nodes; [`Error::Argument`] if one is no object, or has shapes of
    /// other points.
    pub fn share_mesh(&mut self, at: usize, from: usize, source: MeshSource) -> Result<()> {
        // Meshes are shared: this copies none.
        let other = self.object_mut(from)?.clone();
        let object = self.object_mut(at)?;
        object.share_mesh(&other)?;
        object.set_source(Some(source))
    }

    /// Renames the file that an object's mesh comes from.
    ///
    /// # Errors
    /// [`Error::Argument`] if it is no object, [`Error::Memory`].
    pub fn name_mesh(&mut self, at: usize, file: String) -> Result<()> {
        let object = self.object_mut(at)?;
        let source = object.source().cloned();
        object.set_source(source.map(|source| MeshSource { file, ..source }))
    }

    /// Adds a shape to an object; its weight is 0, also in a track of the weights.
    ///
    /// # Errors
    /// [`Error::Range`], [`Error::Argument`], [`Error::Limit`], [`Error::Memory`].
    pub fn add_shape(&mut self, at: usize, shape: Shape) -> Result<()> {
        let part = Part::insert_shape(at, self.object(at)?.shapes().len(), shape)?;
        self.apply_to_object(part)
    }

    /// Removes an object's shape; the others keep their weights, in a track of them too.
    ///
    /// # Errors
    /// [`Error::Range`], [`Error::Argument`], [`Error::Memory`].
    pub fn remove_shape(&mut self, at: usize, which: usize) -> Result<()> {
        if which == 0 && self.object(at)?.shapes().len() == 1 {
            self.remove_track(at, &Channel::Weights)?;
        }
        self.apply_to_object(Part::RemoveShape {
            node: at,
            at: which,
        })
    }

    /// Sets an object's weights at rest.
    ///
    /// # Errors
    /// As [`Object::set_weights`]; [`Error::Argument`] if it is no object.
    pub fn set_weights(&mut self, at: usize, weights: &[f64]) -> Result<()> {
        self.object_mut(at)?.set_weights(weights)
    }

    /// Adds a deformation to an object, behind the others, and returns its number.
    ///
    /// # Errors
    /// [`Error::Range`], [`Error::Argument`], [`Error::Limit`], [`Error::Memory`].
    pub fn add_deformation(
        &mut self,
        at: usize,
        deformation: Deformation,
        bounds: Option<Bounds>,
    ) -> Result<usize> {
        self.object_mut(at)?.add_deformation(deformation, bounds)
    }

    /// Removes an object's deformation with its tracks; later ones move up, in channels too.
    ///
    /// # Errors
    /// [`Error::Range`] or [`Error::Argument`].
    pub fn remove_deformation(&mut self, at: usize, which: usize) -> Result<()> {
        self.object(at)?.check_deformation(which)?;
        let node = &mut self.nodes[at];
        let before = node.keys.numbers();
        let of =
            |channel: &Channel| matches!(channel, Channel::Deformation { at, .. } if *at == which);
        node.keys.retain(|track| !of(track.channel()));
        self.numbers -= before - node.keys.numbers();
        self.apply_to_object(Part::RemoveDeformation {
            node: at,
            at: which,
        })
    }

    /// About how many bytes it takes that another scene does not share.
    #[must_use]
    pub fn heap_size_without(&self, other: &Self) -> usize {
        let node = |node: &Node| {
            let theirs = other.find(&node.name).map(|at| &other.nodes[at]);
            node.heap_size_without(theirs)
        };
        let nodes = self.nodes.without(&other.nodes).map(node);
        let order = !self.order.is_shared_with(&other.order);
        let names = !Arc::ptr_eq(&self.names, &other.names);
        let ids = !Arc::ptr_eq(&self.ids, &other.ids);
        let lists = size_of::<usize>()
            * self.nodes.len()
            * (1 + [order, names, ids].map(usize::from).iter().sum::<usize>());
        let names = self.markers.iter().map(|marker| marker.name.len());
        let names = names.chain(self.pins.iter().map(|pin| pin.marker.len()));
        let markers = size_of_val(&self.markers[..]) + size_of_val(&self.pins[..]);
        nodes.sum::<usize>() + lists + markers + names.sum::<usize>()
    }
}

pub(super) fn check_count(count: usize) -> Result<()> {
    if count > MAX_NODES {
        return Err(TooMany::Nodes.into());
    }
    Ok(())
}

pub(super) fn check_numbers(numbers: usize) -> Result<()> {
    if numbers > MAX_SCENE_NUMBERS {
        return Err(TooMany::SceneNumbers.into());
    }
    Ok(())
}

pub(super) fn check_node(node: &Node, at: usize) -> Result<()> {
    let own = if node.aim == Some(at) {
        Err(Invalid::AimsAtItself.into())
    } else if node.parent == Some(at) {
        Err(Invalid::InItself.into())
    } else {
        node.check()
    };
    own.map_err(|error| error.at(Place::Node((&node.name).into())))
}

pub(super) fn taken(name: &str) -> Error {
    Error::Argument(Invalid::NodeTwice(name.into()))
}

pub(super) fn copy(text: &str) -> Result<String> {
    let mut copy = String::new();
    copy.try_reserve_exact(text.len())?;
    copy.push_str(text);
    Ok(copy)
}

#[cfg(test)]
#[path = "aim_tests.rs"]
mod aim_tests;
#[cfg(test)]
#[path = "scene_tests.rs"]
pub(super) mod tests;
