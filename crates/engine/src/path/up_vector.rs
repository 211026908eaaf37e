//! Which way is up for a camera, in place of the upright axis (Kolb, Computergraphik II, 9.2.2).

use std::sync::Arc;

use glam::DVec3;

use super::camera_path::{CameraPath, SupportPoint};
use super::chain::Chain;
use super::curve;
use super::dispatch;
use super::hermite::Cubic;
use super::own::Tangents;
use super::space::{Space, Up};
use crate::error::{Invalid, OutOfRange, Result, TooMany, try_arc, vec_with_room};
use crate::limits;
use crate::property::{Kind, SameBits, Stored, Value};

/// Which way is up before the roll.
#[derive(Debug, Clone, Default)]
pub enum UpVector {
    /// The upright axis of the space.
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
    /// This axis of the world, whatever is upright.
    Fixed(Up),
}

impl PartialEq for UpVector {
    fn eq(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Point(a), Self::Point(b)) => a == b,
            (Self::Path(a), Self::Path(b)) => Arc::ptr_eq(a, b) || a.points == b.points,
            (Self::Fixed(a), Self::Fixed(b)) => a == b,
            _ => std::mem::discriminant(self) == std::mem::discriminant(other),
        }
    }
}

impl SameBits for UpVector {
    fn same_bits(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Point(a), Self::Point(b)) => a.same_bits(b),
            (Self::Path(a), Self::Path(b)) => {
                Arc::ptr_eq(a, b) || a.points[..].same_bits(&b.points[..])
            }
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

    /// Whether two ups are the same where `upright` is: the upright axis by either name.
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
                let mut points = vec_with_room(path.points.len())?;
                points.extend(path.points.iter().map(|point| UpPathPoint {
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

/// A point of an up path, and the curve's derivatives there, per segment parameter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct UpPathPoint {
    /// Where it is.
    pub position: DVec3,
    /// With which the curve reaches it.
    pub before: DVec3,
    /// With which the curve leaves it.
    pub after: DVec3,
}

impl SameBits for UpPathPoint {
    fn same_bits(&self, other: &Self) -> bool {
        let vectors = |point: &Self| [point.position, point.before, point.after];
        vectors(self)[..].same_bits(&vectors(other)[..])
    }
}

/// A second path of which only the curve counts. A closed one ends where it begins.
#[derive(Debug, Clone, PartialEq)]
pub struct UpPath {
    points: Vec<UpPathPoint>,
    chain: Chain,
}

impl UpPath {
    /// The curve through these points.
    ///
    /// # Errors
    /// [`crate::Error::Range`] for fewer than two, [`crate::Error::Limit`] for more than
    /// [`limits::MAX_UP_PATH_POINTS`]; [`crate::Error::Memory`].
    pub fn new(points: Vec<UpPathPoint>) -> Result<Arc<Self>> {
        if points.len() < limits::MIN_POINTS {
            return Err(OutOfRange::TooFewSupportPoints.into());
        }
        if points.len() > limits::MAX_UP_PATH_POINTS {
            return Err(TooMany::UpPathPoints.into());
        }
        let chain = Chain::new(points.windows(2).map(|pair| {
            let (a, b) = (&pair[0], &pair[1]);
            let curve = Cubic::hermite(a.position, b.position, a.after, b.before);
            (curve, dispatch::length(&curve))
        }))?;
        try_arc(Self { points, chain })
    }

    /// The curve of a path.
    ///
    /// # Errors
    /// As [`Self::new`].
    pub fn of(path: &CameraPath) -> Result<Arc<Self>> {
        let count = path.points.len() + usize::from(path.closed);
        if count > limits::MAX_UP_PATH_POINTS {
            return Err(TooMany::UpPathPoints.into());
        }
        let mut points = vec_with_room(count)?;
        for at in 0..count {
            let at = at % path.points.len();
            let tangents = curve::tangents(path, at);
            points.push(UpPathPoint {
                position: path.points[at].position,
                before: tangents.before,
                after: tangents.after,
            });
        }
        Self::new(points)
    }

    /// A path of which [`Self::of`] makes this curve.
    ///
    /// # Errors
    /// [`crate::Error::Memory`].
    pub fn as_path(&self, space: Space) -> Result<CameraPath> {
        let mut points = vec_with_room(self.points.len())?;
        for point in &self.points {
            points.push(SupportPoint {
                tangents: Some(Tangents {
                    before: point.before,
                    after: point.after,
                }),
                ..SupportPoint::try_new(point.position)?
            });
        }
        Ok(CameraPath {
            points,
            space,
            ..CameraPath::try_new()?
        })
    }

    /// Its points.
    #[must_use]
    pub fn points(&self) -> &[UpPathPoint] {
        &self.points
    }

    /// The other way round.
    ///
    /// # Errors
    /// [`crate::Error::Memory`].
    pub fn reversed(&self) -> Result<Arc<Self>> {
        let mut points = vec_with_room(self.points.len())?;
        points.extend(self.points.iter().rev().map(|point| UpPathPoint {
            position: point.position,
            before: -point.after,
            after: -point.before,
        }));
        Self::new(points)
    }

    fn check(&self, space: Space) -> Result<()> {
        for point in &self.points {
            space.check_place(point.position)?;
            space.check_offset(point.before)?;
            space.check_offset(point.after)?;
        }
        Ok(())
    }

    /// The place at a share of its length, 0 to 1.
    pub(super) fn place(&self, share: f64) -> DVec3 {
        let place = self.chain.place(share * self.chain.length());
        place.unwrap_or(self.points[0].position)
    }
}

/// Checks that a path's ups are defined (the principal normal needs continuous curvature), and that
/// there are not too many up paths.
///
/// # Errors
/// [`crate::Error::Argument`] or [`crate::Error::Limit`].
pub fn check_ups(path: &CameraPath) -> Result<()> {
    let mut paths: [Option<&Arc<UpPath>>; limits::MAX_UP_PATHS] = [None; limits::MAX_UP_PATHS];
    let mut frenet = false;
    for orientation in path.points.iter().flat_map(|point| &point.orientations) {
        if orientation.own.is_empty() {
            continue;
        }
        match &orientation.own.up {
            UpVector::Frenet => frenet = true,
            UpVector::Path(new) => {
                let known = |old: &&Arc<UpPath>| Arc::ptr_eq(old, new) || old.points == new.points;
                if paths.iter().flatten().any(known) {
                    continue;
                }
                match paths.iter_mut().find(|place| place.is_none()) {
                    Some(place) => *place = Some(new),
                    None => return Err(TooMany::UpPaths.into()),
                }
            }
            _ => {}
        }
    }
    let smooth = || {
        path.curve == super::CurveKind::Cubic
            && path.points.iter().all(|point| point.tangents.is_none())
    };
    if frenet && !smooth() {
        return Err(Invalid::NoNormal.into());
    }
    Ok(())
}
