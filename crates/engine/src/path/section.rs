//! Sections: what changes in one, and in how many frames.

use super::camera_path::CameraPath;
use crate::limits::BASE_SPEED;

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
    /// Nothing: the two orientations are one key, with the later one's properties.
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
    /// By how much, in the unit that its base speed counts.
    pub amount: f64,
    /// Mean of its speed curve.
    pub mean_speed: f64,
    /// Its frames; 0 if nothing changes.
    pub frames: usize,
    /// Whether its speed is the same all the way.
    pub constant_speed: bool,
    /// Its own curve time, if it has one.
    pub curve_time: Option<f64>,
}

impl Section {
    /// Its curve time: its own, else its frames, at the base speed.
    #[must_use]
    #[allow(clippy::cast_precision_loss)]
    pub const fn duration(&self) -> f64 {
        match self.curve_time {
            Some(own) => own,
            None => self.frames as f64 * self.mean_speed / BASE_SPEED,
        }
    }
}

/// Frames of a section that moves, not yet rounded.
pub(super) fn unrounded(path: &CameraPath, change: Change, amount: f64, mean_speed: f64) -> f64 {
    let base = match change {
        Change::Position => path.base_frames.movement,
        Change::View => path.base_frames.turning,
        Change::Roll => path.base_frames.rolling,
        Change::Zoom | Change::Nothing => path.base_frames.zoom,
    };
    amount * base * BASE_SPEED / mean_speed
}
