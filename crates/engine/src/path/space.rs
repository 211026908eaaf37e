//! Paths that move from one space to another.

use glam::DVec3;

use super::camera_path::{SupportPoint, Target};
pub use super::cube::{Space, Up, check_half_size};
use super::own::{Tangents, Velocities};
use super::up_vector::UpVector;
use crate::error::{Invalid, Result};

/// A map from one space to another, in which everything lies as it did in the first.
#[derive(Debug, Clone, Copy)]
pub struct Move {
    from: Space,
    to: Space,
}

impl Move {
    /// The map between two spaces.
    #[must_use]
    pub const fn new(from: Space, to: Space) -> Self {
        Self { from, to }
    }

    /// What lengths are multiplied by.
    #[must_use]
    pub fn scale(self) -> f64 {
        self.to.half_size / self.from.half_size
    }

    /// A direction, or another vector whose length stays.
    #[must_use]
    pub const fn direction(self, v: DVec3) -> DVec3 {
        self.to.up.world(self.from.up.upright(v))
    }

    /// A difference of places.
    #[must_use]
    pub fn offset(self, v: DVec3) -> DVec3 {
        self.direction(v * self.scale())
    }

    /// A place.
    #[must_use]
    pub fn place(self, p: DVec3) -> DVec3 {
        self.to.centre + self.offset(p - self.from.centre)
    }

    /// A fixed up. If the up axis changes, only a fixed up by the former one can follow.
    fn axis(self, axis: Up) -> Result<Up> {
        if self.from.up == self.to.up {
            return Ok(axis);
        }
        if axis == self.from.up {
            return Ok(self.to.up);
        }
        Err(Invalid::FixedUp(axis.name()).into())
    }

    /// A support point with all it has.
    ///
    /// # Errors
    /// [`crate::Error::Memory`]; [`crate::Error::Argument`] for a fixed up that would lie along x.
    pub fn point(self, point: &SupportPoint) -> Result<SupportPoint> {
        let mut new = point.try_clone()?;
        new.position = self.place(point.position);
        new.tangents = point.tangents.map(|own| Tangents {
            before: self.offset(own.before),
            after: self.offset(own.after),
        });
        for orientation in &mut new.orientations {
            orientation.target = match orientation.target {
                Target::Absolute(target) => Target::Absolute(self.place(target)),
                Target::Relative(offset) => Target::Relative(self.offset(offset)),
            };
            if orientation.own.is_empty() {
                continue;
            }
            let up = match &orientation.own.up {
                UpVector::Fixed(axis) => UpVector::Fixed(self.axis(*axis)?),
                up => up.map(|p| self.place(p), |_, v| self.offset(v))?,
            };
            orientation.own = orientation.own.with(|own| {
                own.up = up;
                own.ahead = own.ahead.map(|distance| distance * self.scale());
                own.velocities = own.velocities.map(|own| Velocities {
                    reach: self.direction(own.reach),
                    leave: self.direction(own.leave),
                });
            })?;
        }
        Ok(new)
    }
}
