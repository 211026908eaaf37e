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
pub enum Whole {
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
}

/// A part of a pace: what an insertion leaves on either side.
#[derive(Debug, Clone, PartialEq)]
pub struct PacePart {
    /// The whole.
    pub of: Whole,
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
            Whole::Speeds {
                speeds,
                before,
                after,
            } => {
                let facing = [before, after].into_iter().flatten();
                let mut all = speeds.iter().chain(facing);
                all.try_for_each(|speed| check_curve_speed(*speed))?;
            }
            Whole::Ease(ease) => ease.check()?,
            Whole::Distance(keys) => check_distance(keys)?,
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

/// Keys of a given distance: 2…[`limits::MAX_DISTANCE_KEYS`], rising from (0, 0) to (1, 1).
///
/// # Errors
/// [`crate::Error::Range`] or [`crate::Error::Argument`].
pub fn check_distance(keys: &[[f64; 2]]) -> Result<()> {
    if keys.len() < 2 || keys.len() > limits::MAX_DISTANCE_KEYS {
        return Err(OutOfRange::DistanceKeys.into());
    }
    if !keys.as_flattened().iter().all(|number| number.is_finite()) {
        return Err(Invalid::DistanceNotFinite.into());
    }
    let rising = keys
        .windows(2)
        .all(|pair| pair[1][0] - pair[0][0] >= LEAST_STEP && pair[1][1] > pair[0][1]);
    if !rising || keys[0] != [0.0, 0.0] || keys[keys.len() - 1] != [1.0, 1.0] {
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

fn check_part(from: f64, to: f64) -> Result<()> {
    if 0.0 <= from && from < to && to <= 1.0 {
        return Ok(());
    }
    Err(OutOfRange::Part.into())
}

/// What an orientation may have of its own.
#[derive(Debug, Clone, PartialEq)]
pub struct Own {
    /// How the section that begins here goes through its time.
    pub pace: Pace,
    /// Frames of the section that begins here, whatever its length; 0: by length.
    pub frames: u32,
    /// Whether that section keeps its frames where a whole is brought to a number of frames.
    pub locked: bool,
    /// Looks along the way, not at its target: along the tangent (0), or so far ahead on the curve.
    pub ahead: Option<f64>,
    /// Which way is up before the roll.
    pub up: UpVector,
    /// Angular velocities, in place of those by tension, continuity and bias.
    pub velocities: Option<Velocities>,
    /// How the section that begins here turns, if it is a part of a divided one; in the mode tcb.
    pub turning: Option<TurningPart>,
    /// Slope of the roll in tracked sections: degrees for each frame at speed 50.
    pub roll_slope: Option<f64>,
    /// Slope of the zoom: mm for each frame at speed 50.
    pub zoom_slope: Option<f64>,
}

impl Own {
    const NONE: Self = Self {
        pace: Pace::Speeds,
        frames: 0,
        locked: false,
        ahead: None,
        up: UpVector::Axis,
        velocities: None,
        turning: None,
        roll_slope: None,
        zoom_slope: None,
    };

    /// Everything finite and in range.
    ///
    /// # Errors
    /// [`crate::Error::Range`] or [`crate::Error::Argument`].
    pub fn check(&self, space: Space) -> Result<()> {
        match &self.pace {
            Pace::Speeds => {}
            Pace::Part(part) => part.check()?,
            Pace::Ease(ease) => ease.check()?,
            Pace::Distance(keys) => check_distance(keys)?,
        }
        check_frames(self.frames)?;
        self.ahead
            .map_or(Ok(()), |distance| check_ahead(distance, space))?;
        self.up.check(space)?;
        if let Some(Velocities { reach, leave }) = self.velocities {
            check_rates(&[reach.to_array(), leave.to_array()].concat())?;
        }
        if let Some(part) = self.turning {
            part.check()?;
        }
        for slope in [self.roll_slope, self.zoom_slope].into_iter().flatten() {
            check_rates(&[slope])?;
        }
        Ok(())
    }
}

/// A fixed number of frames, or 0.
///
/// # Errors
/// [`crate::Error::Range`].
pub fn check_frames(frames: u32) -> Result<()> {
    if frames as usize > limits::MAX_FRAMES {
        return Err(OutOfRange::SectionFrames.into());
    }
    Ok(())
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

/// The place of [`Own`] in an orientation; an empty one reads as an [`Own`] with nothing set.
#[derive(Debug, Clone, Default)]
pub struct MayOwn(Option<Arc<Own>>);

static NOTHING: Own = Own::NONE;

impl Deref for MayOwn {
    type Target = Own;
    fn deref(&self) -> &Own {
        self.0.as_deref().unwrap_or(&NOTHING)
    }
}

impl PartialEq for MayOwn {
    fn eq(&self, other: &Self) -> bool {
        self.is_shared_with(other) || **self == **other
    }
}

impl MayOwn {
    /// A changed copy.
    ///
    /// # Errors
    /// [`crate::Error::Memory`].
    pub fn with(&self, change: impl FnOnce(&mut Own)) -> Result<Self> {
        let mut own = Own::clone(self);
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

    /// Equal bit by bit: 0 and −0 differ.
    #[must_use]
    pub fn is_same(&self, other: &Self) -> bool {
        // Their text has each number in full, with the sign of a zero.
        self.is_shared_with(other)
            || (**self == **other && format!("{:?}", **self) == format!("{:?}", **other))
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
            own.frames = 0;
            own.locked = false;
            own.velocities = None;
            own.turning = None;
            own.roll_slope = None;
            own.zoom_slope = None;
            if let Pace::Part(_) = own.pace {
                own.pace = Pace::Speeds;
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
