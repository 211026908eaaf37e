//! A node of the scene: its kind, its rest values, what moves it.

use std::sync::Arc;

use glam::DVec3;

use super::channel::Channel;
use super::keys::Keys;
use super::mesh::Object;
use super::motion::FollowPath;
use super::track::Track;
pub use super::values::Values;
use crate::error::{Error, Invalid, OutOfRange, Place, Result};
use crate::limits::MAX_COORDINATE;
use crate::path::camera_path::{check_coordinates, check_name};
use crate::property::choices;

/// What a node is.
#[derive(Debug, Clone, PartialEq, Default)]
pub enum Kind {
    /// Nothing but a place for others.
    #[default]
    Group,
    /// Geometry.
    Object(Object),
    /// A light.
    Light(Light),
    /// A camera.
    Camera(Camera),
}

impl Kind {
    /// Its name in files.
    #[must_use]
    pub const fn name(&self) -> &'static str {
        match self {
            Self::Group => "group",
            Self::Object(_) => "object",
            Self::Light(_) => "light",
            Self::Camera(_) => "camera",
        }
    }

    /// Lights and cameras look along their own z axis.
    #[must_use]
    pub const fn looks(&self) -> bool {
        matches!(self, Self::Light(_) | Self::Camera(_))
    }
}

choices! {
    /// The kinds of light.
    pub enum Light {
        /// Parallel, along its own z axis.
        #[default]
        Directional = "directional",
        /// Into all directions.
        Point = "point",
        /// Into a cone about its own z axis.
        Spot = "spot",
    }
}

/// What a camera has besides its values.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Camera {
    /// Distance of the nearest thing that it shows, > 0.
    pub near: f64,
    /// Distance of the farthest one, > `near`.
    pub far: f64,
}

impl Default for Camera {
    /// For a space of half size 1.
    fn default() -> Self {
        Self {
            near: 0.01,
            far: 1000.0,
        }
    }
}

impl Camera {
    /// The planes of a new camera in a space of this half size, > 0.
    #[must_use]
    pub fn for_size(half_size: f64) -> Self {
        let Self { near, far } = Self::default();
        Self {
            near: near * half_size,
            far: (far * half_size).min(MAX_COORDINATE),
        }
    }
}

/// A node of a scene. The scene holds its parent and aim together.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Node {
    /// Unique in its scene, one line, not empty.
    pub name: String,
    /// What it is.
    pub kind: Kind,
    /// The number of the node that it is in.
    pub parent: Option<usize>,
    /// The number of the node that a camera or light looks at.
    pub aim: Option<usize>,
    /// The point that stays in place when the node turns and scales; 0 for lights and cameras.
    pub pivot: DVec3,
    /// What holds where nothing moves.
    pub rest: Values,
    pub(super) path: Option<Arc<FollowPath>>,
    pub(super) keys: Keys,
}

impl Node {
    /// A node at the origin.
    #[must_use]
    pub fn new(name: &str, kind: Kind) -> Self {
        Self {
            name: name.to_owned(),
            kind,
            ..Self::default()
        }
    }

    /// The path that it follows.
    #[must_use]
    pub fn path(&self) -> Option<&FollowPath> {
        self.path.as_deref()
    }

    /// What moves by keys.
    #[must_use]
    pub const fn keys(&self) -> &Keys {
        &self.keys
    }

    /// Whether a path or keys move it in its parent.
    #[must_use]
    pub fn moves(&self) -> bool {
        use super::channel::Channel::{Position, Rotation, Scale};
        let mut tracks = self.keys.tracks().iter().map(Track::channel);
        self.path.is_some() || tracks.any(|of| matches!(of, Position | Rotation | Scale))
    }

    /// Gives it a path to follow, or none.
    ///
    /// # Errors
    /// [`Error::Argument`] if keys move what the path would.
    pub fn set_path(&mut self, path: Option<FollowPath>) -> Result<()> {
        if path.is_some() {
            self.check_path()?;
        }
        self.path = path.map(Arc::new);
        Ok(())
    }

    /// Whether no keys move what a path would.
    pub(super) fn check_path(&self) -> Result<()> {
        let mut taken = self.keys.tracks().iter().map(Track::channel);
        match taken.find(|channel| self.path_moves(channel)) {
            Some(channel) => Err(Invalid::KeysMoveIt {
                node: (&self.name).into(),
                channel: (&channel).into(),
            }
            .into()),
            None => Ok(()),
        }
    }

    /// Sets a track in place of the one of the same channel.
    ///
    /// # Errors
    /// [`Error::Argument`] if the node has no such channel or a path moves it, [`Error::Range`] if
    /// the width does not fit, [`Error::Limit`], [`Error::Memory`].
    pub fn set_track(&mut self, track: Track) -> Result<()> {
        self.check_track(&track)?;
        self.keys.set(Arc::new(track))
    }

    /// Whether it can have this track.
    pub(super) fn check_track(&self, track: &Track) -> Result<()> {
        let width = track.channel().width(self)?;
        if track.channel_width() != width {
            return Err(OutOfRange::TrackWidth {
                channel: (&track.channel()).into(),
                wanted: width,
                given: track.channel_width(),
            }
            .into());
        }
        if self.path.is_some() && self.path_moves(track.channel()) {
            return Err(Invalid::PathMovesIt {
                node: (&self.name).into(),
                channel: (&track.channel()).into(),
            }
            .into());
        }
        Ok(())
    }

    /// Removes the track of a channel; false if the channel has no track.
    pub fn remove_track(&mut self, channel: &Channel) -> bool {
        self.keys.remove(channel)
    }

    /// About how many bytes it takes that another one does not share.
    pub(super) fn heap_size_without(&self, other: Option<&Self>) -> usize {
        let theirs = other.and_then(|other| other.path.as_ref());
        let path = self
            .path
            .as_ref()
            .filter(|path| theirs.is_none_or(|theirs| !Arc::ptr_eq(path, theirs)));
        let path = path.map_or(0, |path| path.heap_size());
        let object = match (&self.kind, other.map(|other| &other.kind)) {
            (Kind::Object(own), Some(Kind::Object(theirs))) => own.heap_size_without(Some(theirs)),
            (Kind::Object(own), _) => own.heap_size_without(None),
            _ => 0,
        };
        let none = Keys::default();
        let theirs = other.map_or(&none, |other| &other.keys);
        let tracks = self.keys.tracks().without(theirs.tracks());
        let tracks = tracks.map(Track::heap_size).sum::<usize>();
        size_of::<Self>() + self.name.len() + path + object + tracks
    }

    fn path_moves(&self, channel: &Channel) -> bool {
        matches!(
            channel,
            Channel::Position | Channel::Rotation | Channel::Zoom
        )
    }

    /// Checks name, kind and values; what depends on other nodes is the scene's part.
    ///
    /// # Errors
    /// The first thing that is not as it must be.
    pub fn check(&self) -> Result<()> {
        check_node_name(&self.name)?;
        check_coordinates(self.pivot).map_err(|error| error.at(Place::Pivot))?;
        if self.kind.looks() {
            if self.pivot != DVec3::ZERO {
                return Err(Invalid::Pivot.into());
            }
        } else if self.aim.is_some() {
            return Err(Invalid::CannotAim.into());
        }
        if let Kind::Camera(Camera { near, far }) = self.kind
            && !(0.0 < near && near < far && far <= MAX_COORDINATE)
        {
            return Err(OutOfRange::CameraPlanes.into());
        }
        self.rest.check()
    }
}

/// A node's name: one line, not empty.
///
/// # Errors
/// [`Error::Argument`] or [`Error::Limit`].
pub fn check_node_name(name: &str) -> Result<()> {
    check_name(name).map_err(|error| error.at(Place::Name))?;
    if name.is_empty() {
        return Err(Invalid::NoName.into());
    }
    Ok(())
}

impl Channel {
    /// How many numbers it has at a node.
    ///
    /// # Errors
    /// [`crate::Error::Argument`] or [`crate::Error::Range`] if the node has no such channel.
    pub fn width(&self, node: &Node) -> Result<usize> {
        let none = || {
            Error::Argument(Invalid::NoChannelOfKind {
                kind: node.kind.name(),
                channel: (&self).into(),
            })
        };
        let width = match (self, &node.kind) {
            (Self::Weights, Kind::Object(object)) => match object.shapes().len() {
                0 => return Err(Invalid::NoShapes.into()),
                shapes => Some(shapes),
            },
            (Self::Deformation { at, parameter }, Kind::Object(object)) => {
                let all = object.deformations();
                let missing = OutOfRange::NoDeformation {
                    at: *at,
                    count: all.len(),
                };
                let (deformation, _) = all.get(*at).ok_or(missing)?;
                Some(deformation.parameter(parameter)?.len())
            }
            _ => self.own_width(),
        };
        width
            .filter(|_| self.is_of(node.kind.name()))
            .ok_or_else(none)
    }
}
