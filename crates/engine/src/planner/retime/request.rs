//! What is asked of a new pace, and what is made.

use std::fmt;

use crate::error::{Called, Index};
use crate::path::camera_path::CameraPath;
use crate::tools::check::{FindingKind, Limits};

/// What is asked for.
#[derive(Debug, Clone, Copy)]
pub struct Request {
    /// Limits, those of a check; of them speed, acceleration, jerk, turning, turning acceleration,
    /// zoom and crossing count.
    pub limits: Limits,
    /// Frames a second.
    pub fps: f64,
    /// From the first orientation of one point to the last of another; none: all.
    pub points: Option<[usize; 2]>,
    /// The duration in seconds, holds included; 0: as few as the limits allow. A path's seconds are
    /// those of its poses: where it ends, its last pose has a frame, too.
    pub seconds: f64,
}

/// A place where the pace rests without a hold.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Rest {
    /// The point.
    pub point: usize,
    /// The orientation of that point.
    pub orientation: usize,
    /// The limit that does not allow to pass it: the acceleration at a kink of the curve, the
    /// turning acceleration at one of the view.
    pub limit: FindingKind,
}

/// The English sentence.
impl fmt::Display for Rest {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (point, at) = (Index(self.point), Index(self.orientation));
        let view = Called("view", "orientation");
        let what = if self.limit == FindingKind::TurningAcceleration {
            "view"
        } else {
            "curve"
        };
        write!(
            f,
            "at point {point}, {view} {at} the pace rests, since the {what} has a kink there"
        )
    }
}

/// A path with a new pace.
#[derive(Debug)]
pub struct Retimed {
    /// The path.
    pub path: CameraPath,
    /// Seconds of the part that was retimed, holds included, and where the path ends its last pose.
    pub seconds: f64,
    /// Where the pace rests at a kink.
    pub rests: Vec<Rest>,
}
