//! The data of a camera path: what a person plans and a file keeps, in the terms of `docs/theory/path.md`.
//! [`super::timeline`] and [`super::sampling`] compute with it.

use glam::DVec3;

pub use super::base_frames::*;
pub use super::checks::*;
use super::cube::Space;
pub use super::modes::*;
use super::own::{Overrides, Tangents};
pub use super::tcb::Tcb;
use crate::error::{Error, Invalid, OutOfRange, Place, Quantity, Result, vec_with_room};
use crate::limits;
use crate::math::orientation;
use crate::property::{
    Affects, Check, Copied, Kind, Row, SameBits, Stored, Unit, Value, properties,
};
use crate::shared_list::SharedList;

/// Where a point takes its tension, continuity and bias from (thesis A.4.1).
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum CurveParameters {
    /// The path's preset of this number, 0–9 ("Standard n").
    Preset(u8),
    /// The point's own values ("Eigendef.").
    Own(Tcb),
}

impl SameBits for CurveParameters {
    fn same_bits(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Preset(a), Self::Preset(b)) => a == b,
            (Self::Own(a), Self::Own(b)) => a.same_bits(b),
            _ => false,
        }
    }
}

impl Stored for CurveParameters {
    const KINDS: &'static [Kind] = &[Kind::Whole, Kind::Shape];
    const RANGE: Option<(f64, f64)> = Some((0.0, (limits::PRESETS - 1) as f64));
    fn value(self) -> Value {
        match self {
            Self::Preset(preset) => Value::Whole(preset.into()),
            Self::Own(tcb) => Value::Shape(tcb),
        }
    }
    fn of(value: Value) -> Option<Self> {
        match value {
            Value::Whole(preset) => Some(Self::Preset(preset.try_into().unwrap_or(u8::MAX))),
            Value::Shape(tcb) => Some(Self::Own(tcb)),
            _ => None,
        }
    }
}

impl CurveParameters {
    /// Checks that the preset exists, or that the custom values are in range.
    ///
    /// # Errors
    /// [`crate::Error::Range`].
    pub fn check(self) -> Result<()> {
        match self {
            Self::Preset(preset) if usize::from(preset) >= limits::PRESETS => {
                Err(OutOfRange::NoPreset(preset.into()).into())
            }
            Self::Preset(_) => Ok(()),
            Self::Own(tcb) => tcb.check(),
        }
    }
}

/// What the camera of an orientation looks at (thesis A.4.2).
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Target {
    /// A point of the world; it stays where it is when the support point moves.
    Absolute(DVec3),
    /// An offset from the support point, of which only the direction turns the camera.
    Relative(DVec3),
}

impl SameBits for Target {
    fn same_bits(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Absolute(a), Self::Absolute(b)) | (Self::Relative(a), Self::Relative(b)) => {
                a.same_bits(b)
            }
            _ => false,
        }
    }
}

impl Stored for Target {
    const KINDS: &'static [Kind] = &[Kind::Place, Kind::Vector];
    fn value(self) -> Value {
        match self {
            Self::Absolute(target) => Value::Place(target),
            Self::Relative(offset) => Value::Vector(offset),
        }
    }
    fn of(value: Value) -> Option<Self> {
        match value {
            Value::Place(target) => Some(Self::Absolute(target)),
            Value::Vector(offset) => Some(Self::Relative(offset)),
            _ => None,
        }
    }
}

impl Target {
    /// The vector from a camera at `position`, its support point, to the target.
    #[must_use]
    pub fn offset_from(self, position: DVec3) -> DVec3 {
        match self {
            Self::Absolute(target) => target - position,
            Self::Relative(offset) => offset,
        }
    }

    /// Finite, in range, and seen in some direction from `position`.
    ///
    /// # Errors
    /// [`crate::Error::Argument`] or [`crate::Error::Range`].
    pub fn check(self, position: DVec3, space: Space) -> Result<()> {
        match self {
            Self::Absolute(target) => space.check_place(target)?,
            Self::Relative(offset) => space.check_offset(offset)?,
        }
        if self.offset_from(position) == DVec3::ZERO {
            return Err(Invalid::TargetOnCamera.into());
        }
        Ok(())
    }
}

/// What a new orientation looks along, in the space [−1, 1]³ with y up.
const FIRST_OFFSET: DVec3 = DVec3::new(0.0, 0.0, -0.4);

properties! {
    /// One camera orientation at a support point.
    pub struct Orientation {
        /// What the camera looks at.
        pub target: Target = Target::Relative(FIRST_OFFSET) => Row {
            always: true,
            affects: Affects::Frames,
            ..Row::new(&["target", "offset"])
        },
        /// Degrees in (−180, 180]: turns VUP about VPN.
        pub roll: f64 = 0.0 => Row {
            unit: Unit::Degrees,
            check: Check::Finite(Quantity::Roll),
            always: true,
            affects: Affects::Frames,
            ..Row::new(&["roll_degrees"])
        },
        /// The focal length of a camera with a picture of 36×24 mm.
        pub zoom: f64 = 24.0 => Row {
            unit: Unit::Millimetres,
            check: Check::Between(Quantity::Zoom, limits::MIN_ZOOM, limits::MAX_ZOOM),
            always: true,
            affects: Affects::Frames,
            ..Row::new(&["zoom_mm"])
        },
        /// Tension, continuity and bias of the turning.
        pub turning: Tcb = Tcb::new(0.0, 0.0, 0.0) => Row {
            check: Check::By(|tcb, _| tcb.check()),
            affects: Affects::Views,
            ..Row::new(&["turning"])
        },
        /// Frames that the camera rests here before it goes on.
        pub hold: u32 = 0 => Row {
            unit: Unit::Frames,
            check: Check::UpTo(limits::MAX_HOLD, || OutOfRange::Hold),
            affects: Affects::Frames,
            ..Row::new(&["hold_frames"])
        },
        /// The speed curve of the section that begins here, each 1…100.
        pub speeds: [f64; limits::SPEEDS] = [limits::BASE_SPEED; limits::SPEEDS] => Row {
            check: Check::By(|speeds, _| speeds.iter().try_for_each(|&speed| check_curve_speed(speed))),
            affects: Affects::Frames,
            ..Row::new(&["speed_curve"])
        },
        /// What it has beyond that, if anything.
        pub own: Overrides = Overrides::NOTHING => Row {
            check: Check::By(|own, space| own.check(space)),
            ..Row::new(&[])
        },
    }
}

impl Default for Orientation {
    fn default() -> Self {
        Self::NEW
    }
}

impl Orientation {
    /// The orientation of a new path in a space: towards −z, or −x if z is up.
    #[must_use]
    pub fn new_in(space: Space) -> Self {
        Self {
            target: Target::Relative(space.offset(FIRST_OFFSET)),
            ..Self::default()
        }
    }

    /// Checks that all is finite and in range, and that the view from `position` has a direction.
    ///
    /// # Errors
    /// [`crate::Error::Range`] or [`crate::Error::Argument`] with the reason.
    pub fn check(&self, position: DVec3, space: Space) -> Result<()> {
        self.target.check(position, space)?;
        Self::PROPERTIES
            .iter()
            .try_for_each(|row| (row.check)(self, space))
    }

    /// View direction of a camera at `position`: a unit vector.
    #[must_use]
    pub fn view(&self, position: DVec3) -> DVec3 {
        orientation::unit(self.target.offset_from(position))
    }
}

properties! {
    /// A support point: a key position of the curve with its orientations.
    pub struct SupportPoint {
        /// A name for people; the engine does not read it.
        pub name: Option<String> = None => Row {
            check: Check::By(|name, _| name.as_deref().map_or(Ok(()), check_name)),
            affects: Affects::Nothing,
            // Names identify a point.
            copied: Copied::Nowhere,
            ..Row::new(&["name"])
        },
        /// World coordinates, at most 1e9 half sizes from the space's centre.
        pub position: DVec3 = DVec3::ZERO => Row {
            unit: Unit::Length,
            check: Check::By(|place, space| space.check_place(*place)),
            always: true,
            copied: Copied::Nowhere,
            ..Row::new(&["position"])
        },
        /// Shape of the curve through this point: the number of a preset, or its own.
        pub curve: CurveParameters = CurveParameters::Preset(0) => Row {
            check: Check::By(|curve, _| curve.check()),
            always: true,
            ..Row::new(&["preset", "own"])
        },
        /// Tangents of its own, in place of those by the curve's kind and shape.
        pub tangents: Option<Tangents> = None => Row {
            unit: Unit::Length,
            check: Check::By(|tangents, space| tangents.map_or(Ok(()), |own| own.check(space))),
            copied: Copied::Nowhere,
            ..Row::new(&["tangents"])
        },
        /// Whether these came of an insertion that keeps the motion: they are removed when the point
        /// or one beside it moves.
        pub keeps_motion: bool = false => Row {
            affects: Affects::Nothing,
            copied: Copied::Nowhere,
            ..Row::new(&["keeps_motion"])
        },
        /// 1 to 10 orientations in the order they are taken.
        pub orientations: Vec<Orientation> = Vec::new() => Row::new(&[]),
    }
}

impl SupportPoint {
    /// A point with one default orientation and preset 0.
    #[must_use]
    pub fn new(position: DVec3) -> Self {
        Self {
            position,
            orientations: vec![Orientation::default()],
            ..Self::nowhere()
        }
    }

    /// A placeholder where a point has been taken out; it has no orientations.
    #[doc(hidden)]
    #[must_use]
    pub const fn nowhere() -> Self {
        Self::NEW
    }

    /// As [`SupportPoint::new`] where memory may run out.
    ///
    /// # Errors
    /// [`crate::Error::Memory`].
    pub fn try_new(position: DVec3) -> Result<Self> {
        Self::try_new_in(position, Space::default())
    }

    /// As [`SupportPoint::try_new`], looking as a new orientation in a space does.
    ///
    /// # Errors
    /// [`crate::Error::Memory`].
    pub fn try_new_in(position: DVec3, space: Space) -> Result<Self> {
        let mut orientations = vec_with_room(1)?;
        orientations.push(Orientation::new_in(space));
        Ok(Self {
            position,
            orientations,
            ..Self::nowhere()
        })
    }
}

properties! {
    /// A camera path.
    pub struct CameraPath {
        /// Whether one more segment leads from the last point to the first.
        pub closed: bool = false => Row { always: true, ..Row::new(&["closed"]) },
        /// How the curve leads through the points.
        pub curve: CurveKind = CurveKind::Tcb => Row::new(&["curve"]),
        /// How the camera turns.
        pub orientation_mode: OrientationMode = OrientationMode::Tcb => Row {
            always: true,
            affects: Affects::Views,
            ..Row::new(&["orientation_mode"])
        },
        /// How the zoom runs.
        pub zoom_mode: ZoomMode = ZoomMode::Smooth => Row {
            always: true,
            affects: Affects::Views,
            ..Row::new(&["zoom_mode"])
        },
        /// The base speeds.
        pub base_frames: BaseFrames = BaseFrames::NEW => Row {
            check: Check::By(|frames, _| check_base_frames(*frames)),
            always: true,
            affects: Affects::Frames,
            ..Row::new(&["base_speeds"])
        },
        /// The ten presets for tension, continuity and bias.
        pub presets: [Tcb; limits::PRESETS] = DEFAULT_PRESETS => Row {
            check: Check::By(|presets, _| presets.iter().try_for_each(|preset| preset.check())),
            always: true,
            ..Row::new(&["presets"])
        },
        /// Where it lies in the world.
        pub space: Space = Space::NEW => Row::new(&[]),
        /// At least 2 support points.
        pub points: SharedList<SupportPoint> = SharedList::new() => Row::new(&[]),
    }
}

/// The presets of thesis A.6.1.
pub const DEFAULT_PRESETS: [Tcb; limits::PRESETS] = [
    Tcb::new(0.0, 0.0, 0.0),
    Tcb::new(0.3, 0.0, 0.0),
    Tcb::new(0.6, 0.0, 0.0),
    Tcb::new(-0.3, 0.0, 0.0),
    Tcb::new(-0.6, 0.0, 0.0),
    Tcb::new(0.0, -0.5, 0.0),
    Tcb::new(0.0, 0.5, 0.0),
    Tcb::new(0.0, 0.0, 0.5),
    Tcb::new(0.0, 0.0, -0.5),
    Tcb::new(0.0, 0.0, 0.0),
];

/// Where the path of a new window leads through.
const FIRST_POSITIONS: [DVec3; 2] = [DVec3::new(-0.6, 0.2, 0.8), DVec3::new(0.6, 0.2, 0.8)];

impl Default for CameraPath {
    /// The path that a new window begins with.
    fn default() -> Self {
        Self::of_points(FIRST_POSITIONS.map(SupportPoint::new).into())
    }
}

impl CameraPath {
    /// How far away what the camera looks at is: its target, or as far as the middle of the space.
    pub(crate) fn depth(&self, target: Option<Target>, place: DVec3) -> f64 {
        match target {
            Some(Target::Absolute(target)) => target.distance(place),
            _ => self.space.centre.distance(place),
        }
    }

    /// As [`CameraPath::default`] where memory may run out.
    ///
    /// # Errors
    /// [`crate::Error::Memory`].
    pub fn try_new() -> Result<Self> {
        let mut points = vec_with_room(FIRST_POSITIONS.len())?;
        for position in FIRST_POSITIONS {
            points.push(SupportPoint::try_new(position)?);
        }
        Ok(Self::of_points(points))
    }

    /// Whether nothing distinguishes it from a new path but its space and base speeds.
    #[must_use]
    pub fn is_new(&self) -> bool {
        let Ok(mut new) = Self::try_new() else {
            return false;
        };
        (new.space, new.base_frames) = (self.space, self.base_frames);
        // The same but for the rounding of fitting into a space.
        let near = |a: DVec3, b: DVec3| a.distance(b) <= 1e-6 * self.space.half_size;
        for (point, own) in new.points.iter_mut().zip(&self.points) {
            let place = self.space.place(point.position);
            point.position = if near(place, own.position) {
                own.position
            } else {
                place
            };
            let view = Orientation::new_in(self.space);
            point.orientations[0] = match (
                view.target,
                own.orientations.first().map(|view| view.target),
            ) {
                (Target::Relative(seen), Some(Target::Relative(now))) if near(seen, now) => {
                    Orientation {
                        target: Target::Relative(now),
                        ..view
                    }
                }
                _ => view,
            };
        }
        new == *self
    }

    pub(super) fn of_points(points: Vec<SupportPoint>) -> Self {
        Self {
            points: points.into(),
            ..Self::NEW
        }
    }

    /// A copy, which shares the points.
    ///
    /// # Errors
    /// [`crate::Error::Memory`].
    pub fn try_clone(&self) -> Result<Self> {
        let points = self.points.try_clone()?;
        Ok(Self { points, ..*self })
    }

    /// The error where there is no point of this number.
    pub(crate) fn no_point(&self, point: usize) -> Error {
        let last = self.points.len() - 1;
        OutOfRange::NoPoint { point, last }.into()
    }

    /// Curve segments: one fewer than points, as many if the path is closed.
    #[must_use]
    pub fn segment_count(&self) -> usize {
        if self.closed {
            self.points.len()
        } else {
            self.points.len() - 1
        }
    }

    /// Tension, continuity and bias in force at a point.
    ///
    /// # Panics
    /// If there is no such point.
    #[must_use]
    pub fn tcb(&self, point: usize) -> Tcb {
        match self.points[point].curve {
            CurveParameters::Preset(preset) => self.presets[usize::from(preset)],
            CurveParameters::Own(tcb) => tcb,
        }
    }
}

impl SupportPoint {
    /// A copy.
    ///
    /// # Errors
    /// [`crate::Error::Memory`].
    pub fn try_clone(&self) -> Result<Self> {
        let mut orientations = vec_with_room(self.orientations.len())?;
        orientations.extend_from_slice(&self.orientations);
        let name = match &self.name {
            None => None,
            Some(name) => {
                let mut copy = String::new();
                copy.try_reserve_exact(name.len())?;
                copy.push_str(name);
                Some(copy)
            }
        };
        Ok(Self {
            name,
            orientations,
            ..*self
        })
    }

    /// Checks that everything at this point is finite and in range.
    ///
    /// # Errors
    /// The first fault.
    pub fn check(&self, space: Space) -> Result<()> {
        space.check_place(self.position)?;
        for row in Self::PROPERTIES {
            (row.check)(self, space).map_err(|error| match row.keys {
                ["name"] => error.at(Place::Name),
                ["tangents"] => error.at(Place::Tangents),
                _ => error,
            })?;
        }
        if self.orientations.is_empty() || self.orientations.len() > limits::MAX_ORIENTATIONS {
            return Err(OutOfRange::Orientations.into());
        }
        for (index, orientation) in self.orientations.iter().enumerate() {
            orientation
                .check(self.position, space)
                .map_err(|error| error.at(Place::Orientation(index)))?;
        }
        Ok(())
    }
}
