//! What moves a node.

use std::sync::Arc;

use glam::DVec3;

use super::state::Warnings;
use super::time::{Extrapolation, local_frame};
use super::values::Values;
use crate::error::{Invalid, OutOfRange, Quantity, Result};
use crate::limits::MAX_COORDINATE;
use crate::math::orientation::quaternion_from_view;
use crate::path::{CameraPath, Plan, Pose, Sampler, Timeline};

/// What moves a node: it changes the values of rest into those of a frame.
pub trait Motion {
    /// Sets what moves to what it is at `frame`, any finite number.
    ///
    /// # Errors
    /// [`crate::Error::Memory`]. A host's function that fails is put among the warnings.
    fn at(&self, frame: f64, values: &mut Values, warnings: &mut Warnings) -> Result<()>;

    /// Its first and last frame; none if it does not move.
    fn frames(&self) -> Option<(f64, f64)>;
}

/// Motion along a path, in the parent's coordinates.
#[derive(Debug, Clone)]
pub struct FollowPath {
    path: CameraPath,
    plan: Arc<Plan>,
    count: usize,
    start_frame: f64,
    extrapolation: Extrapolation,
}

impl FollowPath {
    /// A path whose pose n is shown at the frame `start_frame` + n − 1, and `beyond` outside of it.
    ///
    /// # Errors
    /// What is wrong with the path; [`crate::Error::Argument`] for the start or
    /// [`Extrapolation::Offset`]; [`crate::Error::Limit`] if it has too many frames;
    /// [`crate::Error::Memory`].
    pub fn new(path: CameraPath, start_frame: f64, extrapolation: Extrapolation) -> Result<Self> {
        path.check()?;
        check_frame(start_frame)?;
        if extrapolation == Extrapolation::Offset {
            return Err(Invalid::PathWithOffset.into());
        }
        let plan = Arc::new(Plan::new());
        let count = plan.timeline(&path, Timeline::frame_count)??;
        Ok(Self {
            path,
            plan,
            count,
            start_frame,
            extrapolation,
        })
    }

    pub(super) const fn set_start(&mut self, start: f64, beyond: Extrapolation) {
        (self.start_frame, self.extrapolation) = (start, beyond);
    }

    /// The path.
    #[must_use]
    pub const fn path(&self) -> &CameraPath {
        &self.path
    }

    /// The frame of its first pose.
    #[must_use]
    pub const fn start_frame(&self) -> f64 {
        self.start_frame
    }

    /// What is shown before and after it.
    #[must_use]
    pub const fn extrapolation(&self) -> Extrapolation {
        self.extrapolation
    }

    /// How many poses it has.
    #[must_use]
    pub const fn count(&self) -> usize {
        self.count
    }

    /// The scene's frames of its first and its last pose.
    #[must_use]
    pub fn first_and_last(&self) -> (f64, f64) {
        (self.start_frame, self.start_frame + (self.count - 1) as f64)
    }

    pub(super) fn heap_size(&self) -> usize {
        let points = &self.path.points;
        let turns: usize = points.iter().map(|point| point.orientations.len()).sum();
        600 + 400 * points.len() + 200 * turns
    }

    pub(super) fn timeline<R>(&self, look: impl FnOnce(&Timeline) -> R) -> Result<R> {
        self.plan.timeline(&self.path, look)
    }

    /// Everything prepared for sampling the path, computed once.
    ///
    /// # Errors
    /// [`crate::Error::Memory`].
    pub fn sampler(&self) -> Result<&Sampler> {
        self.plan.sampler(&self.path)
    }

    /// The pose at a frame of the scene, by the path's own evaluation.
    ///
    /// # Errors
    /// [`crate::Error::Memory`].
    pub fn pose(&self, frame: f64) -> Result<Pose> {
        let sampler = self.sampler()?;
        let last = self.count as f64;
        let (local, _) = local_frame(
            frame - self.start_frame + 1.0,
            1.0,
            last,
            self.extrapolation,
            self.extrapolation,
        );
        sampler.pose(local)
    }
}

impl PartialEq for FollowPath {
    fn eq(&self, other: &Self) -> bool {
        self.path == other.path
            && self.start_frame == other.start_frame
            && self.extrapolation == other.extrapolation
    }
}

impl Motion for FollowPath {
    fn at(&self, frame: f64, values: &mut Values, _: &mut Warnings) -> Result<()> {
        let pose = self.pose(frame)?;
        let [view, up] = [pose.vpn, pose.vup].map(DVec3::from_array);
        values.position = DVec3::from_array(pose.vrp);
        values.rotation = quaternion_from_view(view, up);
        values.zoom = pose.zoom;
        Ok(())
    }

    fn frames(&self) -> Option<(f64, f64)> {
        Some(self.first_and_last())
    }
}

/// A frame of the timeline: finite, and small enough to compute with.
///
/// # Errors
/// [`crate::Error::Argument`] or [`crate::Error::Range`].
pub fn check_frame(frame: f64) -> Result<()> {
    if !frame.is_finite() {
        return Err(Invalid::NotFinite(Quantity::Frame).into());
    }
    if frame.abs() > MAX_COORDINATE {
        return Err(OutOfRange::Exceeds(Quantity::Frame, MAX_COORDINATE).into());
    }
    Ok(())
}
