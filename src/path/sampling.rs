//! Sections become poses (SPEC 2.2, 2.3).

use super::camera_path::CameraPath;
use super::pose::Pose;
use super::timeline::Timeline;
use crate::error::Result;

/// Everything prepared to give any pose of a path; independent of the path
/// that it was made from.
#[derive(Debug)]
pub struct Sampler {}

impl Sampler {
    /// Prepares a path.
    pub fn new(_path: &CameraPath, _timeline: &Timeline) -> Result<Self> {
        unimplemented!()
    }
    /// All frames, at least 1.
    pub fn frame_count(&self) -> usize {
        unimplemented!()
    }
    /// Number (from 1) of the first pose of a section's own; its last one is
    /// this plus its frames less 1. Sections without frames: that of the key.
    pub fn first_frame(&self, _section: usize) -> usize {
        unimplemented!()
    }
    /// Fills `poses` with the frames `first`, `first + 1`, … (numbered from 1).
    pub fn sample(&self, _first: usize, _poses: &mut [Pose]) -> Result<()> {
        unimplemented!()
    }
    /// The pose at any frame between 1 and the last, also between two frames.
    pub fn pose(&self, _frame: f64) -> Result<Pose> {
        unimplemented!()
    }
}
