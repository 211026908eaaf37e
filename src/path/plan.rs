//! What has been computed of a path that changes: brought up to date when it
//! is asked for, and no more of it than the changes since touched.

use std::sync::Arc;

use super::camera_path::CameraPath;
use super::sampling::Sampler;
use super::timeline::Timeline;
use crate::error::Result;

/// The computed side of one path. The owner tells it what changes.
#[derive(Debug, Default)]
pub struct Plan {
    timeline: Option<Timeline>,
    changed: Vec<usize>,
    sampler: Option<Arc<Sampler>>,
}

/// More changed points than this are cheaper to compute all over.
const MANY: usize = 16;

impl Plan {
    /// Nothing computed yet.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            timeline: None,
            changed: Vec::new(),
            sampler: None,
        }
    }

    /// Something other than the values at one point changed.
    pub fn all_changed(&mut self) {
        *self = Self::new();
    }

    /// The values at one point changed, but not the number of its orientations.
    pub fn point_changed(&mut self, point: usize) {
        self.sampler = None;
        if self.timeline.is_none() || self.changed.contains(&point) {
            return;
        }
        if self.changed.len() == MANY || self.changed.try_reserve(1).is_err() {
            self.all_changed();
        } else {
            self.changed.push(point);
        }
    }

    /// Lengths and frames of `path`.
    ///
    /// # Errors
    /// [`crate::Error::Memory`].
    pub fn timeline(&mut self, path: &CameraPath) -> Result<&Timeline> {
        let mut timeline = match self.timeline.take() {
            Some(timeline) => timeline,
            None => Timeline::new(path)?,
        };
        for point in self.changed.drain(..) {
            timeline.update_point(path, point)?;
        }
        Ok(self.timeline.insert(timeline))
    }

    /// Everything prepared for sampling `path`.
    ///
    /// # Errors
    /// [`crate::Error::Memory`] or [`crate::Error::Limit`].
    pub fn sampler(&mut self, path: &CameraPath) -> Result<Arc<Sampler>> {
        if self.sampler.is_none() {
            let timeline = self.timeline(path)?;
            self.sampler = Some(Arc::new(Sampler::new(path, timeline)?));
        }
        match &self.sampler {
            Some(sampler) => Ok(Arc::clone(sampler)),
            None => Err(crate::Error::Memory),
        }
    }
}
