//! The channels of a node: what of it can move, by name.

use std::fmt;

use crate::limits::{MAX_COORDINATE, MAX_ZOOM, MIN_ZOOM};

/// One thing of a node that a track moves. The order is that of a file.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub enum Channel {
    /// Three coordinates.
    Position,
    /// A quaternion w x y z; for the Euler interpolations yaw, pitch and roll in degrees.
    Rotation,
    /// Three factors.
    Scale,
    /// 0 or 1.
    Visible,
    /// Of cameras, 1…2000.
    Zoom,
    /// Of cameras, degrees.
    Roll,
    /// Of lights and objects, linear red, green, blue, each ≥ 0.
    Colour,
    /// Of lights, ≥ 0.
    Intensity,
    /// Of lights, half angles in degrees: inner and outer, 0…90.
    Cone,
    /// Of objects, one number for each shape.
    Weights,
    /// Of cameras and lights, 0…1.
    AimWeight,
    /// A parameter of one of an object's deformations.
    Deformation {
        /// Which one, counted from 0.
        at: usize,
        /// The name of the parameter.
        parameter: String,
    },
    /// The host's own.
    Value {
        /// Its name.
        name: String,
        /// How many numbers.
        width: usize,
    },
}

pub(super) const PLAIN: [(&str, Channel); 11] = [
    ("position", Channel::Position),
    ("rotation", Channel::Rotation),
    ("scale", Channel::Scale),
    ("visible", Channel::Visible),
    ("zoom", Channel::Zoom),
    ("roll", Channel::Roll),
    ("colour", Channel::Colour),
    ("intensity", Channel::Intensity),
    ("cone", Channel::Cone),
    ("weights", Channel::Weights),
    ("aim_weight", Channel::AimWeight),
];

impl Channel {
    /// The names of all, or of those that a kind of node can have.
    #[doc(hidden)]
    pub fn names(kind: Option<&str>) -> impl Iterator<Item = &'static str> + Clone {
        let has = move |channel: &Self| kind.is_none_or(|kind| channel.is_of(kind));
        let plain = PLAIN.iter().filter(move |(_, channel)| has(channel));
        let deforms = matches!(kind, None | Some("object")).then_some("deformation.N.NAME");
        plain
            .map(|(name, _)| *name)
            .chain(deforms)
            .chain(["value:NAME"])
    }

    /// Whether a node of this kind can have it.
    pub(super) fn is_of(&self, kind: &str) -> bool {
        match self {
            Self::Position | Self::Rotation | Self::Scale | Self::Visible | Self::Value { .. } => {
                true
            }
            Self::Zoom | Self::Roll => kind == "camera",
            Self::Colour => matches!(kind, "light" | "object"),
            Self::Intensity | Self::Cone => kind == "light",
            Self::AimWeight => matches!(kind, "light" | "camera"),
            Self::Weights | Self::Deformation { .. } => kind == "object",
        }
    }

    /// The least and the greatest number that it may have.
    #[must_use]
    pub const fn range(&self) -> (f64, f64) {
        match self {
            Self::Visible | Self::AimWeight => (0.0, 1.0),
            Self::Zoom => (MIN_ZOOM, MAX_ZOOM),
            Self::Colour | Self::Intensity => (0.0, MAX_COORDINATE),
            Self::Cone => (0.0, 90.0),
            _ => (-MAX_COORDINATE, MAX_COORDINATE),
        }
    }

    /// Whether both are the same channel of a node: the host's own by name, whatever their width.
    #[must_use]
    pub fn same_as(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Value { name: a, .. }, Self::Value { name: b, .. }) => a == b,
            _ => self == other,
        }
    }

    /// How many numbers it has, unless the node tells.
    pub(super) const fn own_width(&self) -> Option<usize> {
        Some(match self {
            Self::Position | Self::Scale | Self::Colour => 3,
            Self::Rotation => 4,
            Self::Cone => 2,
            Self::Visible | Self::Zoom | Self::Roll | Self::Intensity | Self::AimWeight => 1,
            Self::Value { width, .. } => *width,
            Self::Weights | Self::Deformation { .. } => return None,
        })
    }
}

impl fmt::Display for Channel {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Deformation { at, parameter } => write!(f, "deformation.{at}.{parameter}"),
            Self::Value { name, width: 1 } => write!(f, "value:{name}"),
            Self::Value { name, width } => write!(f, "value:{name}:{width}"),
            plain => {
                let found = PLAIN.iter().find(|(_, channel)| channel == plain);
                f.write_str(found.map_or("", |(name, _)| name))
            }
        }
    }
}
