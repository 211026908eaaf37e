//! Parts of a scene that are exchanged for others: the small changes that an undo can take back.
//!
//! Everything is checked before anything changes, in one place, so that a scene stays valid
//! whatever is exchanged, and an exchange that fails leaves no trace. One that succeeds leaves in
//! the part what the scene had there, so that the same exchange brings back every bit. A part holds
//! what differs and no more: keys, not their track; a name, not its node.

use std::sync::Arc;

use glam::DVec3;

use super::channel::Channel;
use super::key_list::{KeyList, Manner};
use super::mesh::{Geometry, Shape};
use super::motion::FollowPath;
use super::node::{Kind, Node};
use super::node_list::NodeList;
use super::time::Extrapolation;
use super::track::Track;
use super::values::Values;
use crate::deform::{Bounds, Deformation};
use crate::error::{Result, can_allocate};

/// A part of a scene. Nodes, keys, points and what objects have count from 0.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Part {
    /// Nodes that come: what is given is put in.
    Insert(Box<NodeList>),
    /// Nodes that go, in rising order, with all that is in them.
    Remove(Vec<usize>),
    /// A node's name.
    Name {
        /// The node.
        node: usize,
        /// One line, not empty, that no other node has.
        name: String,
    },
    /// What a node has where nothing moves it.
    Rest {
        /// The node.
        node: usize,
        /// The values.
        rest: Box<Rest>,
    },
    /// What a node is in, and what it looks at; its numbers stay.
    Links {
        /// The node.
        node: usize,
        /// The node that it is in.
        parent: Option<usize>,
        /// The node that it aims at.
        aim: Option<usize>,
    },
    /// The path that a node follows, in which every point that is pinned must be.
    Path {
        /// The node.
        node: usize,
        /// The path, if any.
        path: Option<Box<FollowPath>>,
    },
    /// When a node's path begins, and what comes before and after it.
    Start {
        /// The node.
        node: usize,
        /// The scene's frame of its first pose.
        start_frame: f64,
        /// What is shown beyond.
        beyond: Extrapolation,
    },
    /// The track of a channel.
    Track {
        /// The node.
        node: usize,
        /// The channel.
        channel: Channel,
        /// The track, if any.
        track: Option<Box<Track>>,
    },
    /// Keys of a track: `remove` go, `put` come, at frames where none stays. One key must be left.
    Keys {
        /// The node.
        node: usize,
        /// The channel of the track.
        channel: Channel,
        /// The numbers of those that go, in rising order.
        remove: Vec<usize>,
        /// Those that come, in the order of their frames.
        put: KeyList,
    },
    /// How a track goes from key to key, before its first and after its last.
    Manner {
        /// The node.
        node: usize,
        /// The channel of the track.
        channel: Channel,
        /// How.
        manner: Box<Manner>,
    },
    /// An object's mesh.
    Mesh {
        /// The node.
        node: usize,
        /// The mesh with the file it comes from.
        mesh: Geometry,
    },
    /// An object's weights at rest, one for each shape.
    Weights {
        /// The node.
        node: usize,
        /// The weights.
        weights: Vec<f64>,
    },
    /// A shape that comes.
    InsertShape {
        /// The node.
        node: usize,
        /// The number that it gets.
        at: usize,
        /// The shape.
        shape: Arc<Shape>,
        /// Its weight at rest.
        weight: f64,
        /// Its weights in a track of them, as [`Track::values`] and [`Track::shape`] hold them;
        /// empty: 0 throughout.
        weights: Vec<f64>,
    },
    /// A shape that goes; if it is the only one there must be no track of weights.
    RemoveShape {
        /// The node.
        node: usize,
        /// The shape.
        at: usize,
    },
    /// A deformation that comes. Tracks of later ones stay with them.
    InsertDeformation {
        /// The node.
        node: usize,
        /// The number that it gets.
        at: usize,
        /// The deformation.
        deformation: Deformation,
        /// Its box; none: that of the mesh.
        bounds: Option<Bounds>,
    },
    /// A deformation that goes, of which there are no tracks.
    RemoveDeformation {
        /// The node.
        node: usize,
        /// The deformation.
        at: usize,
    },
    /// A deformation that becomes another one, with the parameters of its tracks.
    Deformation {
        /// The node.
        node: usize,
        /// The deformation.
        at: usize,
        /// What it becomes.
        deformation: Deformation,
        /// Its box; none: that of the mesh.
        bounds: Option<Bounds>,
    },
    /// A deformation that acts earlier or later, with its tracks.
    MoveDeformation {
        /// The node.
        node: usize,
        /// The deformation.
        from: usize,
        /// The number that it gets.
        to: usize,
    },
    /// A marker; no path is fitted to it.
    Marker {
        /// One line, not empty.
        name: String,
        /// Its frame; none: there is no such marker, and nothing is pinned to it.
        frame: Option<f64>,
    },
    /// The marker to which a point of a node's path is pinned, if any; no path is fitted to it.
    Pin {
        /// The node.
        node: usize,
        /// The point.
        point: usize,
        /// The marker.
        marker: Option<String>,
    },
    /// [`super::Scene::camera`].
    Camera(Option<usize>),
    /// [`super::Scene::range`].
    Range(Option<(f64, f64)>),
}

/// What a node has where nothing moves it.
#[derive(Debug, Clone, PartialEq)]
pub struct Rest {
    /// The point that stays in place when the node turns and scales; 0 for lights and cameras.
    pub pivot: DVec3,
    /// The values.
    pub values: Values,
    /// What a light or a camera has; of others it is not looked at.
    pub kind: Kind,
}

impl Rest {
    /// What a node has.
    #[must_use]
    pub fn of(node: &Node) -> Self {
        let kind = match &node.kind {
            Kind::Object(_) => Kind::Group,
            own => own.clone(),
        };
        Self {
            pivot: node.pivot,
            values: node.rest,
            kind,
        }
    }
}

impl Part {
    /// A path for a node.
    ///
    /// # Errors
    /// [`crate::Error::Memory`].
    pub fn path(node: usize, path: Option<FollowPath>) -> Result<Self> {
        can_allocate(size_of::<FollowPath>())?;
        let path = path.map(Box::new);
        Ok(Self::Path { node, path })
    }

    /// A track for a node, or none for a channel.
    ///
    /// # Errors
    /// [`crate::Error::Memory`].
    pub fn track(node: usize, channel: Channel, track: Option<Track>) -> Result<Self> {
        can_allocate(size_of::<Track>())?;
        let track = track.map(Box::new);
        Ok(Self::Track {
            node,
            channel,
            track,
        })
    }

    /// About how many bytes it takes besides itself.
    #[must_use]
    pub fn heap_size(&self) -> usize {
        let keys = |list: &KeyList| 8 * (list.frames.len() + list.values.len() + list.shape.len());
        match self {
            Self::Insert(list) => list.heap_size(),
            Self::Remove(places) => 8 * places.len(),
            Self::Name { name, .. } => name.len(),
            Self::Rest { .. } => size_of::<Rest>(),
            Self::Path { path, .. } => path.as_ref().map_or(0, |path| path.heap_size()),
            Self::Track { track, .. } => track.as_ref().map_or(0, |track| track.heap_size()),
            Self::Keys { remove, put, .. } => 8 * remove.len() + keys(put),
            Self::Manner { manner, .. } => size_of::<Manner>() + 8 * manner.shape.len(),
            Self::Mesh { mesh, .. } => mesh.heap_size(),
            Self::Weights { weights, .. } => 8 * weights.len(),
            Self::InsertShape { shape, weights, .. } => {
                8 * weights.len() + size_of_val(&shape.points[..]) + size_of_val(&shape.colours[..])
            }
            Self::InsertDeformation { deformation, .. } | Self::Deformation { deformation, .. } => {
                8 * deformation.parameters().len()
            }
            Self::Marker { name, .. } => name.len(),
            Self::Pin { marker, .. } => marker.as_ref().map_or(0, String::len),
            _ => 0,
        }
    }

    /// Whether both are values of the same place, so that the older one of two that a scene had
    /// there brings back what was before both.
    #[must_use]
    pub fn is_at_place_of(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Rest { .. }, Self::Rest { .. })
            | (Self::Path { .. }, Self::Path { .. })
            | (Self::Mesh { .. }, Self::Mesh { .. })
            | (Self::Weights { .. }, Self::Weights { .. }) => self.node() == other.node(),
            (Self::Deformation { at: a, .. }, Self::Deformation { at: b, .. }) => {
                a == b && self.node() == other.node()
            }
            (Self::Marker { name: a, frame: f }, Self::Marker { name: b, frame: g }) => {
                a == b && f.is_some() && g.is_some()
            }
            (Self::Camera(_), Self::Camera(_)) | (Self::Range(_), Self::Range(_)) => true,
            _ => false,
        }
    }

    /// Whether it is such a value. Others change what numbers and names mean, or whether a value
    /// can be there: names and parents depend on those of other nodes.
    #[must_use]
    pub fn is_value(&self) -> bool {
        self.is_at_place_of(self)
    }

    /// The one node that an exchange changes and nothing else of the scene; `None` where it
    /// changes more.
    #[must_use]
    pub const fn node(&self) -> Option<usize> {
        match self {
            Self::Rest { node, .. }
            | Self::Path { node, .. }
            | Self::Start { node, .. }
            | Self::Track { node, .. }
            | Self::Keys { node, .. }
            | Self::Manner { node, .. }
            | Self::Mesh { node, .. }
            | Self::Weights { node, .. }
            | Self::InsertShape { node, .. }
            | Self::RemoveShape { node, .. }
            | Self::InsertDeformation { node, .. }
            | Self::RemoveDeformation { node, .. }
            | Self::Deformation { node, .. }
            | Self::MoveDeformation { node, .. } => Some(*node),
            Self::Insert(_)
            | Self::Remove(_)
            | Self::Name { .. }
            | Self::Links { .. }
            | Self::Marker { .. }
            | Self::Pin { .. }
            | Self::Camera(_)
            | Self::Range(_) => None,
        }
    }
}
