//! What has been computed of a path that changes, brought up to date on demand.
//!
//! Several threads may ask at once. What is prepared for sampling is lent, not shared by a counted
//! pointer, whose making cannot be refused when memory has run out.

use std::sync::{Mutex, MutexGuard, OnceLock, PoisonError};

use super::camera_path::CameraPath;
use super::sampling::Sampler;
use super::timeline::Timeline;
use crate::error::Result;

/// The computed side of one path. The owner tells it what changes.
#[derive(Debug, Default)]
pub struct Plan {
    lengths: Mutex<Lengths>,
    sampler: OnceLock<Sampler>,
}

/// The timeline, and the points that have changed since it was computed.
#[derive(Debug, Default)]
struct Lengths {
    timeline: Option<Timeline>,
    changed: Vec<usize>,
}

/// With more changed points than this it is cheaper to compute everything.
const MANY: usize = 16;

impl Lengths {
    const fn new() -> Self {
        Self {
            timeline: None,
            changed: Vec::new(),
        }
    }

    /// The timeline, up to date. Taken out meanwhile, so that an error or a panic leaves none.
    fn up_to_date(&mut self, path: &CameraPath) -> Result<&Timeline> {
        let mut timeline = match self.timeline.take() {
            Some(timeline) => timeline,
            None => Timeline::new(path)?,
        };
        for point in self.changed.drain(..) {
            timeline.update_point(path, point)?;
        }
        Ok(self.timeline.insert(timeline))
    }
}

impl Plan {
    /// Nothing computed yet.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            lengths: Mutex::new(Lengths::new()),
            sampler: OnceLock::new(),
        }
    }

    /// To be called when more has changed than the values at one point.
    pub fn all_changed(&mut self) {
        *self = Self::new();
    }

    /// To be called when values at one point have changed, but not the number of its orientations.
    pub fn point_changed(&mut self, point: usize) {
        self.sampler.take();
        let lengths = self
            .lengths
            .get_mut()
            .unwrap_or_else(PoisonError::into_inner);
        if lengths.timeline.is_none() || lengths.changed.contains(&point) {
            return;
        }
        if lengths.changed.len() == MANY || lengths.changed.try_reserve(1).is_err() {
            self.all_changed();
        } else {
            lengths.changed.push(point);
        }
    }

    /// Looks at lengths and frames of `path`; other threads wait meanwhile.
    ///
    /// # Errors
    /// [`crate::Error::Memory`].
    pub fn timeline<R>(&self, path: &CameraPath, look: impl FnOnce(&Timeline) -> R) -> Result<R> {
        self.lengths().up_to_date(path).map(look)
    }

    /// Everything prepared for sampling `path`.
    ///
    /// # Errors
    /// [`crate::Error::Memory`] or [`crate::Error::Limit`].
    pub fn sampler(&self, path: &CameraPath) -> Result<&Sampler> {
        if let Some(sampler) = self.sampler.get() {
            return Ok(sampler);
        }
        // Held until it is made, so that one thread computes and the others find it here.
        let mut lengths = self.lengths();
        if let Some(sampler) = self.sampler.get() {
            return Ok(sampler);
        }
        let made = Sampler::new(path, lengths.up_to_date(path)?)?;
        Ok(self.sampler.get_or_init(|| made))
    }

    /// A panic while they were locked left nothing half done.
    fn lengths(&self) -> MutexGuard<'_, Lengths> {
        self.lengths.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
