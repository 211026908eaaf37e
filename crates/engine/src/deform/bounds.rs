//! The box that a deformation is relative to.

use glam::DVec3;

use crate::error::{Invalid, Result};
use crate::path::checks::check_coordinates;
use crate::path::cube::Space;

/// The shortest side that is not flat: coordinates relative to shorter ones would overflow.
const SHORTEST: f64 = 1e-150;

/// A box along the axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bounds {
    min: DVec3,
    max: DVec3,
}

impl From<Space> for Bounds {
    fn from(space: Space) -> Self {
        let (min, max) = (space.low(), space.high());
        Self { min, max }
    }
}

impl Bounds {
    /// A box from its lowest to its highest corner; sides may be flat.
    ///
    /// # Errors
    /// [`crate::Error::Argument`] or [`crate::Error::Range`].
    pub fn new(min: DVec3, max: DVec3) -> Result<Self> {
        check_coordinates(min)?;
        check_coordinates(max)?;
        if min.cmpgt(max).any() {
            return Err(Invalid::BoxEnds.into());
        }
        Ok(Self { min, max })
    }

    /// The smallest box around some points; without points, the origin.
    #[must_use]
    pub fn of(points: &[DVec3]) -> Self {
        let Some(&first) = points.first() else {
            return Self {
                min: DVec3::ZERO,
                max: DVec3::ZERO,
            };
        };
        let (min, max) = points
            .iter()
            .fold((first, first), |(min, max), p| (min.min(*p), max.max(*p)));
        Self { min, max }
    }

    /// The lowest corner.
    #[must_use]
    pub const fn min(&self) -> DVec3 {
        self.min
    }

    /// The highest corner.
    #[must_use]
    pub const fn max(&self) -> DVec3 {
        self.max
    }

    /// The length of a side, 0 if it is flat.
    pub(super) fn size(&self, axis: usize) -> f64 {
        let size = self.max[axis] - self.min[axis];
        if size >= SHORTEST { size } else { 0.0 }
    }

    /// A point in the coordinates of the box: −1…1 from side to side, 0 where it is flat.
    #[must_use]
    pub fn coordinates(&self, point: DVec3) -> DVec3 {
        DVec3::from_array([0, 1, 2].map(|axis| self.coordinate(point, axis)))
    }

    /// The point with such coordinates.
    #[must_use]
    pub fn point(&self, coordinates: DVec3) -> DVec3 {
        let mut point = self.min;
        for axis in 0..3 {
            self.place(&mut point, axis, coordinates[axis]);
        }
        point
    }

    pub(super) fn coordinate(&self, point: DVec3, axis: usize) -> f64 {
        let (min, max) = (self.min[axis], self.max[axis]);
        if self.size(axis) > 0.0 {
            (2.0 * point[axis] - (min + max)) / (max - min)
        } else {
            0.0
        }
    }

    /// Moves a point to a coordinate; where the box is flat it stays.
    pub(super) fn place(&self, point: &mut DVec3, axis: usize, coordinate: f64) {
        let (min, max) = (self.min[axis], self.max[axis]);
        if self.size(axis) > 0.0 {
            point[axis] = (1.0 - coordinate) / 2.0 * min + (1.0 + coordinate) / 2.0 * max;
        }
    }

    /// Whether a point is in the box; its flat sides are ignored.
    pub(super) fn contains(&self, point: DVec3) -> bool {
        (0..3).all(|axis| self.coordinate(point, axis).abs() <= 1.0)
    }
}
