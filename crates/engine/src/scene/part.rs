//! Parts of a scene, each a small change that leaves everything else as it is.
//!
//! Everything is checked before anything changes, in one place, so that a scene stays valid
//! whatever is done to it, and a change that fails leaves no trace. A part holds what differs and
//! no more: keys, not their track; a name, not its node.

use std::sync::Arc;

use glam::DVec3;

use super::channel::Channel;
use super::key_list::{KeyList, Manner};
use super::mesh::{Geometry, Shape};
use super::motion::FollowPath;
use super::node::{Kind, Node};
use super::time::Extrapolation;
use super::track::Track;
use super::values::Values;
use crate::deform::{Bounds, Deformation};
use crate::error::{Result, can_allocate};

/// A part of a scene. Nodes, keys, points and what objects have count from 0.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Part {
    /// Nodes that go with all that is in them. Later ones move up; aims at them end, and their pins go.
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
        path: Option<Arc<FollowPath>>,
    },
    /// When a node's path begins, and how it continues before and after.
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
        track: Option<Arc<Track>>,
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
    /// The values of a light or a camera; other kinds ignore them.
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
        let path = path.map(Arc::new);
        Ok(Self::Path { node, path })
    }

    /// A track for a node, or none for a channel.
    ///
    /// # Errors
    /// [`crate::Error::Memory`].
    pub fn track(node: usize, channel: Channel, track: Option<Track>) -> Result<Self> {
        can_allocate(size_of::<Track>())?;
        let track = track.map(Arc::new);
        Ok(Self::Track {
            node,
            channel,
            track,
        })
    }

    /// The one node that it changes; `None` where it changes more, or something else.
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
            Self::Remove(_)
            | Self::Name { .. }
            | Self::Links { .. }
            | Self::Marker { .. }
            | Self::Pin { .. }
            | Self::Camera(_)
            | Self::Range(_) => None,
        }
    }
}
