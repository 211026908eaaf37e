//! What [`super::own`] is made of: tangents, sources and parts of paces, velocities, parts of turnings.

use std::sync::Arc;

use glam::{DQuat, DVec3};

use super::checks::check_curve_speed;
use super::cube::Space;
use super::ease::Ease;
use crate::error::{Invalid, OutOfRange, Quantity, Result};
use crate::limits;
use crate::property::same_bits::SameBits;

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
    /// Ten speeds, each 1…100, and the slopes of their curve at both ends.
    Speeds {
        /// The ten.
        speeds: [f64; limits::SPEEDS],
        /// Change of the speed by the share of the time, as the neighbours had made it.
        slopes: [f64; 2],
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
            PaceSource::Speeds { speeds, slopes } => {
                speeds
                    .iter()
                    .try_for_each(|speed| check_curve_speed(*speed))?;
                check_rates(slopes)?;
            }
            PaceSource::Ease(ease) => ease.check()?,
            PaceSource::Distance(keys) => check_distance(keys)?,
            PaceSource::Track(keys) => check_track(keys)?,
        }
        check_part(self.from, self.to)
    }
}

impl SameBits for PaceSource {
    fn same_bits(&self, other: &Self) -> bool {
        match (self, other) {
            (
                Self::Speeds { speeds, slopes },
                Self::Speeds {
                    speeds: ten,
                    slopes: two,
                },
            ) => speeds.same_bits(ten) && slopes.same_bits(two),
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
pub(super) const LEAST_STEP: f64 = 1e-9;

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
