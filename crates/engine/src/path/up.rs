//! Which way is up for a camera, in place of the up axis (Kolb, Computergraphik II, 9.2.2).

use std::sync::Arc;

use glam::DVec3;

use super::cube::{Space, Up};
use super::up_path::{UpPath, UpPathPoint};
use crate::error::{Result, vec_with_room};
use crate::property::{Kind, SameBits, Stored, Value};

/// Which way is up before the roll.
#[derive(Debug, Clone, Default)]
pub enum UpVector {
    /// The up axis of the space.
    #[default]
    Axis,
    /// Towards a point of the world.
    Point(DVec3),
    /// Towards the place on a second path at the same share of length.
    Path(Arc<UpPath>),
    /// Carried along without turning about the view.
    Minimal,
    /// The principal normal of the curve.
    Frenet,
    /// This axis of the world, whichever axis is up.
    Fixed(Up),
}

impl PartialEq for UpVector {
    fn eq(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Point(a), Self::Point(b)) => a == b,
            (Self::Path(a), Self::Path(b)) => Arc::ptr_eq(a, b) || a.points() == b.points(),
            (Self::Fixed(a), Self::Fixed(b)) => a == b,
            _ => std::mem::discriminant(self) == std::mem::discriminant(other),
        }
    }
}

impl SameBits for UpVector {
    fn same_bits(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Point(a), Self::Point(b)) => a.same_bits(b),
            (Self::Path(a), Self::Path(b)) => Arc::ptr_eq(a, b) || a.points().same_bits(b.points()),
            _ => self == other,
        }
    }
}

impl Stored for UpVector {
    const KINDS: &'static [Kind] = &[
        Kind::Choice(&["axis", "minimal", "frenet", "y", "z"]),
        Kind::Place,
        Kind::UpPath,
    ];
    fn value(self) -> Value {
        match self {
            Self::Point(place) => Value::Place(place),
            Self::Path(path) => Value::UpPath(path),
            other => Value::Choice(other.name()),
        }
    }
    fn of(value: Value) -> Option<Self> {
        match value {
            Value::Choice("axis") => Some(Self::Axis),
            Value::Choice("minimal") => Some(Self::Minimal),
            Value::Choice("frenet") => Some(Self::Frenet),
            Value::Choice(axis) => Up::named(axis).map(Self::Fixed),
            Value::Place(place) => Some(Self::Point(place)),
            Value::UpPath(path) => Some(Self::Path(path)),
            _ => None,
        }
    }
}

impl UpVector {
    /// The names, in files and in C.
    pub const NAMES: [&'static str; 7] = ["axis", "point", "path", "minimal", "frenet", "y", "z"];

    /// Its name.
    #[must_use]
    pub const fn name(&self) -> &'static str {
        match self {
            Self::Axis => "axis",
            Self::Point(_) => "point",
            Self::Path(_) => "path",
            Self::Minimal => "minimal",
            Self::Frenet => "frenet",
            Self::Fixed(axis) => axis.name(),
        }
    }

    /// The axis against which the roll is measured, if it is one; `upright` is the space's.
    #[must_use]
    pub const fn level(&self, upright: Up) -> Option<Up> {
        match self {
            Self::Axis => Some(upright),
            Self::Fixed(axis) => Some(*axis),
            _ => None,
        }
    }

    /// Whether the roll is measured against an axis, so that up depends on the view alone.
    #[must_use]
    pub const fn is_level(&self) -> bool {
        matches!(self, Self::Axis | Self::Fixed(_))
    }

    /// Whether two ups are the same if `upright` is the up axis, which has two names.
    #[must_use]
    pub fn same(&self, other: &Self, upright: Up) -> bool {
        match (self.level(upright), other.level(upright)) {
            (None, None) => self == other,
            (a, b) => a == b,
        }
    }

    /// Carried along by a map of places, and of directions at a place.
    ///
    /// # Errors
    /// [`crate::Error::Memory`].
    pub fn map(
        &self,
        place: impl Fn(DVec3) -> DVec3,
        direction: impl Fn(DVec3, DVec3) -> DVec3,
    ) -> Result<Self> {
        Ok(match self {
            Self::Point(point) => Self::Point(place(*point)),
            Self::Path(path) => {
                let mut points = vec_with_room(path.points().len())?;
                points.extend(path.points().iter().map(|point| UpPathPoint {
                    position: place(point.position),
                    before: direction(point.position, point.before),
                    after: direction(point.position, point.after),
                }));
                Self::Path(UpPath::new(points)?)
            }
            other => other.clone(),
        })
    }

    /// Checks that its places are within reach.
    ///
    /// # Errors
    /// [`crate::Error::Range`], [`crate::Error::Argument`] or [`crate::Error::Limit`].
    pub fn check(&self, space: Space) -> Result<()> {
        match self {
            Self::Point(place) => space.check_place(*place),
            Self::Path(path) => path.check(space),
            _ => Ok(()),
        }
    }
}
