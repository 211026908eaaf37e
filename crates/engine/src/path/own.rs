//! Custom values of a point or an orientation: tangents, pace, frames, velocities, slopes.
//!
//! Few orientations have any, so it lies behind one pointer, which is empty for all others: plain
//! paths stay small, and copying them needs no memory.

use std::ops::Deref;
use std::sync::Arc;

use super::cube::Space;
use super::ease::Ease;
use super::own_parts::LEAST_STEP;
pub use super::own_parts::{
    PacePart, PaceSource, Tangents, TurningPart, Velocities, check_distance, check_rates,
    check_track, distance_backwards, track_backwards,
};
use super::up::UpVector;
use crate::error::{Invalid, OutOfRange, Quantity, Result, can_allocate, try_arc};
use crate::limits;
use crate::property::{
    Affects, Check, Copied, Kind, Row, SameBits, Stored, Unit, Value, properties,
};

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

properties! {
    /// Custom values of an orientation.
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
            check: Check::UpTo(limits::MAX_SECTION_FRAMES as u32, || OutOfRange::SectionFrames),
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
