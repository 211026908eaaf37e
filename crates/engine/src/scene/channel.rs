//! The channels of a node: what of it can move, by name.

use std::fmt;

use super::node::{Kind, Node};
use crate::error::{Error, Invalid, OutOfRange, Result};
use crate::limits::{MAX_CHANNEL_WIDTH, MAX_NAME_BYTES};
use crate::path::camera_path::check_name;

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

const PLAIN: [(&str, Channel); 11] = [
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
    /// By its name: `position`, `deformation.2.angle`, `value:radius`, `value:wind:3` (width 3).
    ///
    /// # Errors
    /// [`crate::Error::Argument`], [`crate::Error::Range`] or [`crate::Error::Limit`].
    pub fn parse(name: &str) -> Result<Self> {
        if let Some((_, channel)) = PLAIN.iter().find(|(plain, _)| *plain == name) {
            return Ok(channel.clone());
        }
        if let Some(rest) = name.strip_prefix("value:") {
            return Self::parse_value(rest);
        }
        if let Some(rest) = name.strip_prefix("deformation.")
            && let Some((at, parameter)) = rest.split_once('.')
            && let Some(at) = whole(at)
            && parameter.len() <= MAX_NAME_BYTES
        {
            return Ok(Self::Deformation {
                at,
                parameter: parameter.to_owned(),
            });
        }
        check_name(name)?;
        Err(Invalid::NoChannel(name.into()).into())
    }

    /// The names of all, or of those that a kind of node can have.
    #[doc(hidden)]
    pub fn names(kind: Option<&str>) -> impl Iterator<Item = &'static str> + Clone {
        let has = move |channel: &Self| {
            matches!(
                (channel, kind),
                (_, None)
                    | (
                        Self::Position | Self::Rotation | Self::Scale | Self::Visible,
                        _
                    )
                    | (Self::Zoom | Self::Roll, Some("camera"))
                    | (Self::Colour, Some("light" | "object"))
                    | (Self::Intensity | Self::Cone, Some("light"))
                    | (Self::AimWeight, Some("light" | "camera"))
                    | (Self::Weights, Some("object"))
            )
        };
        let plain = PLAIN.iter().filter(move |(_, channel)| has(channel));
        let deforms = matches!(kind, None | Some("object")).then_some("deformation.N.NAME");
        plain
            .map(|(name, _)| *name)
            .chain(deforms)
            .chain(["value:NAME"])
    }

    fn parse_value(rest: &str) -> Result<Self> {
        let (name, width) = match rest.split_once(':') {
            Some((name, width)) => (name, whole(width)),
            None => (rest, Some(1)),
        };
        check_name(name)?;
        if name.is_empty() {
            return Err(Invalid::ChannelWithoutName.into());
        }
        match width {
            Some(width) if (1..=MAX_CHANNEL_WIDTH).contains(&width) => Ok(Self::Value {
                name: name.to_owned(),
                width,
            }),
            _ => Err(OutOfRange::ChannelWidth.into()),
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
        let kind = &node.kind;
        let has = match self {
            Self::Position | Self::Rotation | Self::Scale | Self::Visible | Self::Value { .. } => {
                true
            }
            Self::Zoom | Self::Roll => matches!(kind, Kind::Camera(_)),
            Self::Colour => matches!(kind, Kind::Light(_) | Kind::Object(_)),
            Self::Intensity | Self::Cone => matches!(kind, Kind::Light(_)),
            Self::AimWeight => matches!(kind, Kind::Light(_) | Kind::Camera(_)),
            Self::Weights | Self::Deformation { .. } => matches!(kind, Kind::Object(_)),
        };
        let width = match (self, kind) {
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
        width.filter(|_| has).ok_or_else(none)
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

/// A whole number in its one spelling: digits without leading zeros.
fn whole(digits: &str) -> Option<usize> {
    let plain = digits.bytes().all(|byte| byte.is_ascii_digit());
    let number = digits.parse().ok()?;
    (plain && (digits.len() == 1 || !digits.starts_with('0'))).then_some(number)
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_lead_back() {
        for name in [
            "position",
            "aim_weight",
            "deformation.12.phi_min",
            "value:radius",
            "value:wind:3",
        ] {
            assert_eq!(Channel::parse(name).unwrap().to_string(), name);
        }
        let one = Channel::parse("value:a:1").unwrap();
        assert_eq!(one.to_string(), "value:a");
        assert!(one.same_as(&Channel::parse("value:a:16").unwrap()));
        for wrong in [
            "",
            "Position",
            "value:",
            "value:a:0",
            "value:a:17",
            "value:a:b:2",
            "value:a\n",
            "deformation.x.angle",
            "deformation.01.angle",
            "deformation.1",
        ] {
            assert!(Channel::parse(wrong).is_err(), "{wrong}");
        }
    }
}
