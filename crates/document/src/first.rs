//! What a window begins with.

use glam::DVec3;

use super::edit::Edit;
use super::editing::Document;
use crate::error::{Result, can_allocate};
use vides_engine::path::CameraPath;

impl Document {
    /// Puts the path in which a window begins around its object in place of the path
    /// ([`CameraPath::first`]); without an object it stays.
    ///
    /// # Errors
    /// `ErrorKind::Memory`.
    pub fn look_at_object(&mut self) -> Result<()> {
        match self.first_path()? {
            Some(path) => {
                can_allocate(size_of::<CameraPath>())?;
                self.apply(Edit::ReplacePath(Box::new(path)))
            }
            None => Ok(()),
        }
    }

    /// Whether nothing distinguishes the path from that of a new window but its space and base
    /// speeds.
    #[must_use]
    pub fn is_new(&self) -> bool {
        let around = || self.first_path().ok().flatten();
        self.path().is_new() || around().is_some_and(|first| first == *self.path())
    }

    /// The middle of the object's box; none without an object.
    #[must_use]
    pub fn object_middle(&self) -> Option<DVec3> {
        let [low, high] = self.object_box()?;
        Some(low + 0.5 * (high - low))
    }

    fn object_box(&self) -> Option<[DVec3; 2]> {
        let places = self.info().object.iter().map(|point| [point.position; 2]);
        places.reduce(|[low, high], [place, _]| [low.min(place), high.max(place)])
    }

    fn first_path(&self) -> Result<Option<CameraPath>> {
        let Some(corners) = self.object_box() else {
            return Ok(None);
        };
        let base_frames = self.path().base_frames;
        let path = CameraPath::first(self.path().space, corners)?;
        Ok(Some(CameraPath {
            base_frames,
            ..path
        }))
    }
}
