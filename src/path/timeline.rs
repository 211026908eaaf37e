//! Sections and their frames (SPEC 2.2): what changes, by how much, how many
//! frames it takes. Kept up to date in constant time when one point changes.

use super::camera_path::CameraPath;
use super::hermite::Cubic;
use crate::error::Result;

/// What decides the number of frames of a section: the first that changes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Change {
    /// The position: the camera moves along a segment.
    Position,
    /// The view direction at one place.
    View,
    /// The roll alone.
    Roll,
    /// The zoom alone.
    Zoom,
    /// Nothing: the two orientations are one key.
    Nothing,
}

/// One section: the way from one orientation to the next.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Section {
    /// The support point at which it begins.
    pub point: usize,
    /// The orientation of that point with which it begins.
    pub orientation: usize,
    /// What changes.
    pub change: Change,
    /// By how much, in the unit that its base speed counts (SPEC 2.2: M).
    pub amount: f64,
    /// Mean of its speed curve.
    pub mean_speed: f64,
    /// Its frames; 0 if nothing changes.
    pub frames: usize,
}

/// Lengths of all segments, frames of all sections.
#[derive(Debug, Clone)]
pub struct Timeline {}

impl Timeline {
    /// Computes everything.
    pub fn new(_path: &CameraPath) -> Result<Self> {
        unimplemented!()
    }
    /// To be called after the values (not the number) of anything at one point changed.
    pub fn update_point(&mut self, _path: &CameraPath, _point: usize) -> Result<()> {
        unimplemented!()
    }
    /// All frames of the path, at least 1; [`crate::Error::Limit`] if over [`crate::limits::MAX_FRAMES`].
    pub fn frame_count(&self) -> Result<usize> {
        unimplemented!()
    }
    /// Length of the whole curve.
    pub fn length(&self) -> f64 {
        unimplemented!()
    }
    /// Length of one segment.
    pub fn segment_length(&self, _segment: usize) -> f64 {
        unimplemented!()
    }
    /// Curve of one segment.
    pub fn curve(&self, _segment: usize) -> &Cubic {
        unimplemented!()
    }
    /// Sections: orientations − 1, or as many if the path is closed.
    pub fn section_count(&self) -> usize {
        unimplemented!()
    }
    /// One section.
    pub fn section(&self, _index: usize) -> Section {
        unimplemented!()
    }
}
