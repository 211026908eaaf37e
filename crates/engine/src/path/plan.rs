//! What has been computed of a path that changes, brought up to date on demand.
//!
//! Several threads may ask at once. What is prepared for sampling is lent, not shared by a counted
//! pointer, whose making cannot be refused when memory has run out.

use std::sync::{Mutex, MutexGuard, OnceLock, PoisonError};

use super::camera_path::{CameraPath, SupportPoint};
use super::sampling::Sampler;
use super::timeline::Timeline;
use crate::error::Result;
use crate::property::{Affects, Property, SameBits};
use crate::shared_list::SharedList;

/// The computed side of one path. The owner tells it when another takes its place.
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

    /// To be called when one path has taken the place of another: what both share stays computed.
    pub fn follow(&mut self, old: &CameraPath, new: &CameraPath) {
        if std::ptr::eq(old, new) {
            return;
        }
        let settings = |path: &CameraPath| CameraPath {
            points: SharedList::new(),
            ..*path
        };
        let many = old.points.len() != new.points.len();
        if many || !settings(old).same_bits(&settings(new)) {
            *self = Self::new();
            return;
        }
        let [differ, _] = new.points.difference(&old.points);
        for at in differ {
            let (old, new) = (&old.points[at], &new.points[at]);
            let same = |row: &Property<SupportPoint>| {
                row.affects == Affects::Nothing || (row.same)(old, new)
            };
            if old.orientations.len() != new.orientations.len() {
                *self = Self::new();
                return;
            }
            if !std::ptr::eq(old, new) && !SupportPoint::PROPERTIES.iter().all(same) {
                self.point_changed(at);
            }
        }
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
        if lengths.changed.len() == MANY {
            *self = Self::new();
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
