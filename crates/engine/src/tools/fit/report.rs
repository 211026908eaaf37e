//! How well a path follows the poses that it was made of.

use super::time_unit::TimeUnit;

/// How far poses are missed.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Deviation {
    /// The greatest distance.
    pub greatest: f64,
    /// The root of the mean of its squares.
    pub rms: f64,
}

/// How well a path follows its poses, and what was found in them. Poses that were left out or
/// dropped do not count.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Report {
    /// Points of the path.
    pub points: usize,
    /// Poses of the recording.
    pub poses: usize,
    /// Of positions, in the unit of the poses.
    pub position: Deviation,
    /// Of views with their up, in degrees.
    pub view: Deviation,
    /// Of vertical fields of view, in degrees.
    pub lens: Deviation,
    /// Frames per second.
    pub fps: f64,
    /// Points at which the camera rests.
    pub holds: usize,
    /// Poses that a robust fit left out.
    pub outliers: usize,
    /// Poses at the time of the one before, which were dropped.
    pub dropped: usize,
    /// What the times count, if they were too great for seconds.
    pub unit: Option<TimeUnit>,
}

/// By how much a path misses the poses.
pub(super) struct Measured {
    /// In tolerances.
    pub worst: f64,
    pub position: Deviation,
    pub view: Deviation,
    pub lens: Deviation,
}

impl Deviation {
    pub(super) fn add(&mut self, off: f64) {
        self.greatest = self.greatest.max(off);
        self.rms += off * off;
    }

    pub(super) fn mean(self, count: usize) -> Self {
        Self {
            rms: (self.rms / count.max(1) as f64).sqrt(),
            ..self
        }
    }
}
