//! What is checked of a whole path.

use super::camera_path::{CameraPath, check_base_frames};
use super::cube::Space;
use super::up_vector::check_ups;
use crate::error::{OutOfRange, Place, Result, TooMany};
use crate::limits;

impl CameraPath {
    /// Checks that everything is finite, in range and within the limits.
    ///
    /// # Errors
    /// The first fault, with its place.
    pub fn check(&self) -> Result<()> {
        self.check_in(self.space)
    }

    /// As [`CameraPath::check`], as if it lay in this space.
    ///
    /// # Errors
    /// As [`CameraPath::check`].
    pub fn check_in(&self, space: Space) -> Result<()> {
        if self.points.len() < limits::MIN_POINTS {
            return Err(OutOfRange::TooFewSupportPoints.into());
        }
        if self.points.len() > limits::MAX_POINTS {
            return Err(TooMany::SupportPoints.into());
        }
        for preset in self.presets {
            preset.check()?;
        }
        check_base_frames(self.base_frames)?;
        space.check()?;
        for (index, point) in self.points.iter().enumerate() {
            point
                .check(space)
                .map_err(|error| error.at(Place::Point(index)))?;
        }
        check_ups(self)
    }
}
