//! Where a path lies in the user's world: a cube round a centre, and which axis is up.
//! Positions are the world's throughout; only thresholds and base speeds count in units of
//! `half_size`, and only what knows a vertical is computed in y-up axes.

use glam::DVec3;

use crate::error::{Error, Invalid, OutOfRange, Quantity, Result};
use crate::limits;
use crate::math::orientation;
use crate::property::named::named;
use crate::property::same_bits::SameBits;

named! {
    /// The axis of the world that is up.
    #[derive(Hash)]
    #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
    pub enum Up {
        /// y.
        #[default]
        Y = "y",
        /// z.
        Z = "z",
    }
}

impl Up {
    /// A vector of the world in y-up axes: a cyclic permutation, right-handed, that loses no bit.
    #[must_use]
    #[inline(always)]
    pub const fn upright(self, v: DVec3) -> DVec3 {
        match self {
            Self::Y => v,
            Self::Z => DVec3::new(v.y, v.z, v.x),
        }
    }

    /// The inverse of [`Up::upright`].
    #[must_use]
    #[inline(always)]
    pub const fn world(self, v: DVec3) -> DVec3 {
        match self {
            Self::Y => v,
            Self::Z => DVec3::new(v.z, v.x, v.y),
        }
    }

    /// [`orientation::level_axes`] of a view of the world.
    #[must_use]
    pub fn level_axes(self, view: DVec3) -> (DVec3, DVec3) {
        let (u, v) = orientation::level_axes(self.upright(view));
        (self.world(u), self.world(v))
    }

    /// [`orientation::up_from_roll`] of a view of the world.
    #[must_use]
    pub fn up_from_roll(self, view: DVec3, roll: f64) -> DVec3 {
        self.world(orientation::up_from_roll(self.upright(view), roll))
    }

    /// [`orientation::roll_from_up`] of a view of the world.
    #[must_use]
    pub fn roll_from_up(self, view: DVec3, up: DVec3) -> f64 {
        orientation::roll_from_up(self.upright(view), self.upright(up))
    }

    /// The number of the axis: y 1, z 2.
    #[must_use]
    pub const fn index(self) -> usize {
        match self {
            Self::Y => 1,
            Self::Z => 2,
        }
    }
}

/// The movement space: a cube in the user's world.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Space {
    /// Its centre, each coordinate at most [`limits::MAX_COORDINATE`] times `half_size`.
    pub centre: DVec3,
    /// Half the length of an edge, [`limits::MIN_HALF_SIZE`] to [`limits::MAX_HALF_SIZE`].
    pub half_size: f64,
    /// The axis that is up.
    pub up: Up,
}

impl Default for Space {
    fn default() -> Self {
        Self::NEW
    }
}

impl SameBits for Space {
    fn same_bits(&self, other: &Self) -> bool {
        self.centre.same_bits(&other.centre) && self == other
    }
}

impl Space {
    /// The cube [−1, 1]³, y up.
    pub const NEW: Self = Self {
        centre: DVec3::ZERO,
        half_size: 1.0,
        up: Up::Y,
    };

    /// Checks that `centre` and `half_size` are in range.
    ///
    /// # Errors
    /// [`Error::Argument`] or [`Error::Range`].
    pub fn check(self) -> Result<()> {
        check_half_size(self.half_size)?;
        if !self.centre.is_finite() {
            return Err(Invalid::CentreNotFinite.into());
        }
        if self.centre.abs().max_element() > self.farthest() {
            return Err(OutOfRange::Centre.into());
        }
        Ok(())
    }

    /// How far from the centre a place may be, and how long an offset.
    #[must_use]
    pub fn farthest(self) -> f64 {
        limits::MAX_COORDINATE * self.half_size
    }

    /// A place: finite, and near enough to compute with.
    ///
    /// # Errors
    /// [`Error::Argument`] if not finite, [`Error::Range`] if too far away.
    pub fn check_place(self, place: DVec3) -> Result<()> {
        self.check_offset(place - self.centre)
    }

    /// A difference of places: finite, and small enough to compute with.
    ///
    /// # Errors
    /// As [`Space::check_place`].
    pub fn check_offset(self, offset: DVec3) -> Result<()> {
        if !offset.is_finite() {
            return Err(Invalid::NotFinite(Quantity::Coordinate).into());
        }
        if offset.abs().max_element() > self.farthest() {
            return Err(Error::Range(if self == Self::default() {
                OutOfRange::Exceeds(Quantity::Coordinate, limits::MAX_COORDINATE)
            } else {
                OutOfRange::FarFromCentre
            }));
        }
        Ok(())
    }

    /// The cube's corner with the smallest coordinates.
    #[must_use]
    pub fn low(self) -> DVec3 {
        self.centre - self.half_size
    }

    /// The cube's corner with the largest coordinates.
    #[must_use]
    pub fn high(self) -> DVec3 {
        self.centre + self.half_size
    }

    /// An offset in the cube [−1, 1]³ with y up, in the world.
    #[must_use]
    pub fn offset(self, v: DVec3) -> DVec3 {
        self.up.world(v * self.half_size)
    }

    /// A place in the cube [−1, 1]³ with y up, in the world.
    #[must_use]
    pub fn place(self, p: DVec3) -> DVec3 {
        self.centre + self.offset(p)
    }

    /// The smallest space that holds some places, with a tenth of its size to spare.
    ///
    /// # Errors
    /// [`Error::Argument`] if they have no extent; as [`Space::check`].
    pub fn around(places: impl IntoIterator<Item = DVec3>, up: Up) -> Result<Self> {
        let (low, high) = places.into_iter().fold(
            (DVec3::INFINITY, DVec3::NEG_INFINITY),
            |(low, high), place| (low.min(place), high.max(place)),
        );
        let extent = (high - low).max_element();
        if !(extent > 0.0) {
            return Err(Invalid::NoSize.into());
        }
        let space = Self {
            centre: low + (high - low) / 2.0,
            half_size: 0.55 * extent,
            up,
        };
        space.check()?;
        Ok(space)
    }
}

/// Half the length of a space's edge.
///
/// # Errors
/// [`Error::Range`].
pub fn check_half_size(half_size: f64) -> Result<()> {
    if !(limits::MIN_HALF_SIZE..=limits::MAX_HALF_SIZE).contains(&half_size) {
        return Err(OutOfRange::HalfSize.into());
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn axes_change_places_and_stay_right_handed() {
        let v = DVec3::new(1.0, 2.0, 3.0);
        assert_eq!(Up::Z.upright(DVec3::Z), DVec3::Y);
        assert_eq!(Up::Z.world(DVec3::Y), DVec3::Z);
        for up in [Up::Y, Up::Z] {
            assert_eq!(up.world(up.upright(v)), v);
            let [x, y, z] = [DVec3::X, DVec3::Y, DVec3::Z].map(|axis| up.upright(axis));
            assert_eq!(x.cross(y), z);
        }
    }

    #[test]
    fn what_cannot_be_computed_with_is_refused() {
        let space = |half_size| Space {
            half_size,
            ..Space::default()
        };
        for half_size in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e-300, 1e300] {
            assert!(space(half_size).check().is_err(), "{half_size}");
        }
        for half_size in [1e-30, 1e-10, 1.0, 1e30] {
            let mut space = space(half_size);
            space.check().unwrap();
            for far in [f64::NAN, f64::INFINITY, 1.1e9 * half_size, -1e300] {
                space.centre.y = far;
                assert!(space.check().is_err(), "{half_size} {far}");
            }
            space.centre.y = 1000.0 * half_size;
            space.check().unwrap();
            space.check_place(space.high()).unwrap();
            assert!(space.check_place(DVec3::splat(1.1e9 * half_size)).is_err());
        }
    }

    #[test]
    fn a_space_holds_what_it_is_made_around() {
        let places = [DVec3::new(3.0, 0.0, -1.0), DVec3::new(3.5, 4.0, 2.0)];
        let space = Space::around(places, Up::Z).unwrap();
        assert_eq!(space.centre, DVec3::new(3.25, 2.0, 0.5));
        assert!((space.half_size - 2.2).abs() < 1e-15);
        assert!(Space::around([DVec3::ONE; 3], Up::Y).is_err());
        assert!(Space::around([], Up::Y).is_err());
    }
}
