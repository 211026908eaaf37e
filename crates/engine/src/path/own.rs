//! What a point or an orientation may have of its own: tangents, pace, frames, velocities, slopes.
//!
//! Few orientations have any, so it lies behind one pointer, which is empty for all others: plain
//! paths stay small, and copying them needs no memory.

use std::ops::Deref;
use std::sync::Arc;

use glam::{DQuat, DVec3};

use super::camera_path::check_curve_speed;
use super::ease::Ease;
use super::space::Space;
use super::up_vector::UpVector;
use crate::error::{Invalid, OutOfRange, Quantity, Result, can_allocate, try_arc};
use crate::limits;
use crate::property::{
    Affects, Check, Copied, Kind, Row, SameBits, Stored, Unit, Value, properties,
};

/// The derivatives with which the curve passes a point, per segment parameter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tangents {
    /// Where the segment before reaches it.
    pub before: DVec3,
    /// Where the segment after leaves it.
    pub after: DVec3,
}

impl Tangents {
    /// Finite, and small enough to compute with.
    ///
    /// # Errors
    /// [`crate::Error::Argument`] or [`crate::Error::Range`].
    pub fn check(self, space: Space) -> Result<()> {
        space.check_offset(self.before)?;
        space.check_offset(self.after)
    }
}

/// The pace that a [`PacePart`] is taken from.
#[derive(Debug, Clone, PartialEq)]
pub enum PaceSource {
    /// Ten speeds, each 1…100, and the speeds that faced them, if any.
    Speeds {
        /// The ten.
        speeds: [f64; limits::SPEEDS],
        /// The speed that faced the first.
        before: Option<f64>,
        /// The speed that faced the last.
        after: Option<f64>,
    },
    /// Speeding up, cruising and slowing down.
    Ease(Ease),
    /// Share of way by share of time.
    Distance(Arc<[[f64; 2]]>),
    /// Share of time, share of way and the slope there: what a computed pace needs, whose
    /// acceleration jumps at keys.
    Track(Arc<[[f64; 3]]>),
}

/// A part of a pace: what an insertion leaves on either side.
#[derive(Debug, Clone, PartialEq)]
pub struct PacePart {
    /// The whole.
    pub of: PaceSource,
    /// Share of its time where the part begins, 0 ≤ from < to.
    pub from: f64,
    /// Where it ends, to ≤ 1.
    pub to: f64,
}

impl PacePart {
    /// Everything in range.
    ///
    /// # Errors
    /// [`crate::Error::Range`] or [`crate::Error::Argument`].
    pub fn check(&self) -> Result<()> {
        match &self.of {
            PaceSource::Speeds {
                speeds,
                before,
                after,
            } => {
                let facing = [before, after].into_iter().flatten();
                let mut all = speeds.iter().chain(facing);
                all.try_for_each(|speed| check_curve_speed(*speed))?;
            }
            PaceSource::Ease(ease) => ease.check()?,
            PaceSource::Distance(keys) => check_distance(keys)?,
            PaceSource::Track(keys) => check_track(keys)?,
        }
        check_part(self.from, self.to)
    }
}

/// How a section goes through its time.
#[derive(Debug, Clone, PartialEq, Default)]
pub enum Pace {
    /// By the ten speeds of its orientation.
    #[default]
    Speeds,
    /// By speeding up, cruising and slowing down.
    Ease(Ease),
    /// By the way gone at some times: (share of time, share of way).
    Distance(Arc<[[f64; 2]]>),
    /// By a part of another pace.
    Part(PacePart),
}

impl Pace {
    /// Everything in range.
    ///
    /// # Errors
    /// [`crate::Error::Range`] or [`crate::Error::Argument`].
    pub fn check(&self) -> Result<()> {
        match self {
            Self::Speeds => Ok(()),
            Self::Part(part) => part.check(),
            Self::Ease(ease) => ease.check(),
            Self::Distance(keys) => check_distance(keys),
        }
    }
}

impl SameBits for Pace {
    fn same_bits(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Speeds, Self::Speeds) => true,
            (Self::Ease(a), Self::Ease(b)) => a.same_bits(b),
            (Self::Distance(a), Self::Distance(b)) => a.same_bits(b),
            (Self::Part(a), Self::Part(b)) => {
                a.of.same_bits(&b.of) && [a.from, a.to].same_bits(&[b.from, b.to])
            }
            _ => false,
        }
    }
}

impl Stored for Pace {
    const KINDS: &'static [Kind] = &[Kind::Ease, Kind::Distance, Kind::Part];
    fn value(self) -> Value {
        match self {
            Self::Speeds => Value::Unset,
            Self::Ease(ease) => Value::Ease(ease),
            Self::Distance(keys) => Value::Distance(keys),
            Self::Part(part) => Value::Part(part),
        }
    }
    fn of(value: Value) -> Option<Self> {
        match value {
            Value::Unset => Some(Self::Speeds),
            Value::Ease(ease) => Some(Self::Ease(ease)),
            Value::Distance(keys) => Some(Self::Distance(keys)),
            Value::Part(part) => Some(Self::Part(part)),
            _ => None,
        }
    }
}

impl SameBits for PaceSource {
    fn same_bits(&self, other: &Self) -> bool {
        match (self, other) {
            // Speeds are ≥ 1, so `==` is bitwise there.
            (Self::Speeds { .. }, Self::Speeds { .. }) => self == other,
            (Self::Ease(a), Self::Ease(b)) => a.same_bits(b),
            (Self::Distance(a), Self::Distance(b)) => a.same_bits(b),
            (Self::Track(a), Self::Track(b)) => a.same_bits(b),
            _ => false,
        }
    }
}

/// Keys of a given distance: 2…[`limits::MAX_DISTANCE_KEYS`], rising from (0, 0) to (1, 1).
///
/// # Errors
/// [`crate::Error::Range`] or [`crate::Error::Argument`].
pub fn check_distance(keys: &[[f64; 2]]) -> Result<()> {
    check_keys(keys)
}

/// Keys of a track: as [`check_distance`], no slope below 0.
///
/// # Errors
/// [`crate::Error::Range`] or [`crate::Error::Argument`].
pub fn check_track(keys: &[[f64; 3]]) -> Result<()> {
    check_keys(keys)?;
    if keys.iter().any(|key| key[2] < 0.0) {
        return Err(OutOfRange::DistanceOrder.into());
    }
    Ok(())
}

fn check_keys<const N: usize>(keys: &[[f64; N]]) -> Result<()> {
    if keys.len() < 2 || keys.len() > limits::MAX_DISTANCE_KEYS {
        return Err(OutOfRange::DistanceKeys.into());
    }
    if !keys.as_flattened().iter().all(|number| number.is_finite()) {
        return Err(Invalid::DistanceNotFinite.into());
    }
    let rising = keys
        .windows(2)
        .all(|pair| pair[1][0] - pair[0][0] >= LEAST_STEP && pair[1][1] > pair[0][1]);
    let ends = [&keys[0], &keys[keys.len() - 1]].map(|key| [key[0], key[1]]);
    if !rising || ends != [[0.0, 0.0], [1.0, 1.0]] {
        return Err(OutOfRange::DistanceOrder.into());
    }
    Ok(())
}

/// Keys of a given distance gone backwards. Of keys that rounding brings too near, one is left.
#[must_use]
pub fn distance_backwards(keys: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let mut back: Vec<[f64; 2]> = Vec::with_capacity(keys.len());
    for (left, &[time, way]) in (0..keys.len()).rev().zip(keys.iter().rev()) {
        let key = [1.0 - time, 1.0 - way];
        let near = |last: &[f64; 2]| key[0] - last[0] < LEAST_STEP || key[1] <= last[1];
        // The first and the last key stay.
        while left == 0 && back.len() > 1 && back.last().is_some_and(near) {
            back.pop();
        }
        if left == 0 || !back.last().is_some_and(near) {
            back.push(key);
        }
    }
    back
}

/// Keys of a track gone backwards, as [`distance_backwards`].
#[must_use]
pub fn track_backwards(keys: &[[f64; 3]]) -> Vec<[f64; 3]> {
    let plain: Vec<[f64; 2]> = keys.iter().map(|key| [key[0], key[1]]).collect();
    let back = distance_backwards(&plain).into_iter();
    let slope = |time: f64| {
        let key = keys.iter().find(|key| 1.0 - key[0] == time);
        key.map_or(0.0, |key| key[2])
    };
    back.map(|[time, way]| [time, way, slope(time)]).collect()
}

/// The least time between two keys: far below a frame, and quotients of it stay finite.
const LEAST_STEP: f64 = 1e-9;

/// Angular velocities in the mode tcb: world rotation vectors, degrees for each frame at speed 50.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Velocities {
    /// With which the turning reaches the key.
    pub reach: DVec3,
    /// With which it leaves it.
    pub leave: DVec3,
}

impl Velocities {
    /// Finite, none beyond [`limits::MAX_RATE`].
    ///
    /// # Errors
    /// [`crate::Error::Range`] or [`crate::Error::Argument`].
    pub fn check(self) -> Result<()> {
        check_rates(&self.reach.to_array())?;
        check_rates(&self.leave.to_array())
    }
}

/// How a section turned before it was divided. It counts as long as it leads from key to key.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TurningPart {
    /// Control quaternions of the whole curve, in y-up axes ([`super::Up::upright`]).
    pub control: [DQuat; 4],
    /// Share of its time where the part begins, 0 ≤ from < to.
    pub from: f64,
    /// Where it ends, to ≤ 1.
    pub to: f64,
}

impl TurningPart {
    /// Unit quaternions, and a part of [0, 1].
    ///
    /// # Errors
    /// [`crate::Error::Range`] or [`crate::Error::Argument`].
    pub fn check(&self) -> Result<()> {
        let unit = |q: &DQuat| q.is_finite() && (q.length() - 1.0).abs() < 1e-6;
        if !self.control.iter().all(unit) {
            return Err(Invalid::ControlNotUnit.into());
        }
        check_part(self.from, self.to)
    }
}

impl SameBits for TurningPart {
    fn same_bits(&self, other: &Self) -> bool {
        self.control.same_bits(&other.control)
            && [self.from, self.to].same_bits(&[other.from, other.to])
    }
}

fn check_part(from: f64, to: f64) -> Result<()> {
    if 0.0 <= from && from < to && to <= 1.0 {
        return Ok(());
    }
    Err(OutOfRange::Part.into())
}

properties! {
    /// What an orientation may have of its own.
    pub struct OrientationOverrides {
        /// Looks along the way, not at its target: along the tangent (0), or so far ahead on the curve.
        pub ahead: Option<f64> = None => Row {
            unit: Unit::Length,
            check: Check::By(|ahead, space| ahead.map_or(Ok(()), |far| check_ahead(far, space))),
            affects: Affects::Frames,
            ..Row::new(&["ahead"])
        },
        /// Which way is up before the roll.
        pub up: UpVector = UpVector::Axis => Row {
            check: Check::By(|up, space| up.check(space)),
            affects: Affects::Frames,
            ..Row::new(&["up", "up_point", "up_path"])
        },
        /// Frames of the section that begins here, whatever its length; 0: by length.
        pub frames: u32 = 0 => Row {
            unit: Unit::Frames,
            check: Check::UpTo(limits::MAX_FRAMES as u32, || OutOfRange::SectionFrames),
            copied: Copied::IfAsked,
            affects: Affects::Frames,
            ..Row::new(&["frames"])
        },
        /// Whether that section keeps its frames where a whole is brought to a number of frames.
        pub locked: bool = false => Row {
            affects: Affects::Nothing,
            copied: Copied::IfAsked,
            ..Row::new(&["locked"])
        },
        /// Curve time of the section that begins here, in frames at speed 50, whatever its frames
        /// and its pace; none: as they have it.
        pub curve_time: Option<f64> = None => Row {
            unit: Unit::Frames,
            copied: Copied::IfAsked,
            check: Check::By(|time, _| time.map_or(Ok(()), check_curve_time)),
            ..Row::new(&["curve_time"])
        },
        /// How the section that begins here goes through its time.
        pub pace: Pace = Pace::Speeds => Row {
            check: Check::By(|pace, _| pace.check()),
            copied: Copied::After(|pace| {
                if matches!(pace, Pace::Part(_)) {
                    *pace = Pace::Speeds;
                }
            }),
            affects: Affects::Frames,
            ..Row::new(&["ease", "distance", "pace_part"])
        },
        /// Angular velocities, in place of those by tension, continuity and bias.
        pub velocities: Option<Velocities> = None => Row {
            check: Check::By(|velocities, _| velocities.map_or(Ok(()), Velocities::check)),
            copied: Copied::Nowhere,
            affects: Affects::Views,
            ..Row::new(&["velocity_degrees"])
        },
        /// How the section that begins here turns, if it is a part of a divided one; in the mode tcb.
        pub turning: Option<TurningPart> = None => Row {
            check: Check::By(|part, _| part.map_or(Ok(()), |part| part.check())),
            copied: Copied::Nowhere,
            affects: Affects::Views,
            ..Row::new(&["turning_part"])
        },
        /// Slope of the roll in tracked sections: degrees for each frame at speed 50.
        pub roll_slope: Option<f64> = None => Row {
            unit: Unit::Degrees,
            copied: Copied::Nowhere,
            check: Check::By(|slope, _| check_rates(slope.as_slice())),
            affects: Affects::Views,
            ..Row::new(&["roll_slope_degrees"])
        },
        /// Slope of the zoom: mm for each frame at speed 50.
        pub zoom_slope: Option<f64> = None => Row {
            unit: Unit::Millimetres,
            check: Check::By(|slope, _| check_rates(slope.as_slice())),
            copied: Copied::Nowhere,
            affects: Affects::Views,
            ..Row::new(&["zoom_slope_mm"])
        },
    }
}

impl OrientationOverrides {
    /// Everything finite and in range.
    ///
    /// # Errors
    /// [`crate::Error::Range`] or [`crate::Error::Argument`].
    pub fn check(&self, space: Space) -> Result<()> {
        Self::PROPERTIES
            .iter()
            .try_for_each(|row| (row.check)(self, space))
    }
}

/// A distance along the way, ≥ 0.
///
/// # Errors
/// [`crate::Error::Range`] or [`crate::Error::Argument`].
pub fn check_ahead(distance: f64, space: Space) -> Result<()> {
    if !distance.is_finite() {
        return Err(Invalid::NotFinite(Quantity::DistanceAhead).into());
    }
    if !(0.0..=space.farthest()).contains(&distance) {
        return Err(OutOfRange::DistanceAhead.into());
    }
    Ok(())
}

/// A curve time: as long as some frames can make it, and not zero.
///
/// # Errors
/// [`crate::Error::Range`].
pub fn check_curve_time(time: f64) -> Result<()> {
    let most = 2.0 * limits::MAX_FRAMES as f64;
    if (LEAST_STEP..=most).contains(&time) {
        return Ok(());
    }
    Err(OutOfRange::NumberBetween("curve_time", LEAST_STEP, most).into())
}

/// Angular velocities and slopes: finite, none beyond [`limits::MAX_RATE`].
///
/// # Errors
/// [`crate::Error::Range`] or [`crate::Error::Argument`].
pub fn check_rates(rates: &[f64]) -> Result<()> {
    for rate in rates {
        if !rate.is_finite() {
            return Err(Invalid::NotFinite(Quantity::Rate).into());
        }
        if rate.abs() > limits::MAX_RATE {
            return Err(OutOfRange::Exceeds(Quantity::Rate, limits::MAX_RATE).into());
        }
    }
    Ok(())
}

/// The place of [`OrientationOverrides`] in an orientation; an empty one reads as an [`OrientationOverrides`] with nothing set.
#[derive(Debug, Clone, Default)]
pub struct Overrides(Option<Arc<OrientationOverrides>>);

static NOTHING: OrientationOverrides = OrientationOverrides::NEW;

impl Deref for Overrides {
    type Target = OrientationOverrides;
    fn deref(&self) -> &OrientationOverrides {
        self.0.as_deref().unwrap_or(&NOTHING)
    }
}

impl PartialEq for Overrides {
    fn eq(&self, other: &Self) -> bool {
        self.is_shared_with(other) || **self == **other
    }
}

impl SameBits for Overrides {
    fn same_bits(&self, other: &Self) -> bool {
        self.is_shared_with(other) || (**self).same_bits(other)
    }
}

impl Stored for Overrides {}

impl Overrides {
    /// Nothing.
    pub const NOTHING: Self = Self(None);

    /// A changed copy.
    ///
    /// # Errors
    /// [`crate::Error::Memory`].
    pub fn with(&self, change: impl FnOnce(&mut OrientationOverrides)) -> Result<Self> {
        let mut own = OrientationOverrides::clone(self);
        change(&mut own);
        if own == NOTHING {
            return Ok(Self(None));
        }
        Ok(Self(Some(try_arc(own)?)))
    }

    /// Whether there is nothing.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.0.is_none()
    }

    fn is_shared_with(&self, other: &Self) -> bool {
        match (&self.0, &other.0) {
            (None, None) => true,
            (Some(a), Some(b)) => Arc::ptr_eq(a, b),
            _ => false,
        }
    }

    /// What a copy at another place takes along: not what holds for this place alone.
    ///
    /// # Errors
    /// [`crate::Error::Memory`].
    pub fn for_a_copy(&self) -> Result<Self> {
        if self.is_empty() {
            return Ok(Self(None));
        }
        self.with(|own| {
            for row in OrientationOverrides::PROPERTIES {
                (row.for_a_copy)(own);
            }
        })
    }
}

/// The keys of a given distance, checked.
///
/// # Errors
/// As [`check_distance`]; [`crate::Error::Memory`].
pub fn distance(keys: &[[f64; 2]]) -> Result<Pace> {
    check_distance(keys)?;
    can_allocate(size_of_val(keys) + 2 * size_of::<usize>())?;
    Ok(Pace::Distance(keys.into()))
}

/// A track as a whole pace, checked.
///
/// # Errors
/// As [`check_track`]; [`crate::Error::Memory`].
pub fn track(keys: &[[f64; 3]]) -> Result<PaceSource> {
    check_track(keys)?;
    can_allocate(size_of_val(keys) + 2 * size_of::<usize>())?;
    Ok(PaceSource::Track(keys.into()))
}
