//! Points of paths that are reached at markers, so that flights meet (`docs/reference/scene.md`, markers).

use super::motion::{FollowPath, check_frame};
use super::scene::Scene;
use crate::error::{Invalid, Place, Result, vec_with_room};
use crate::path::fit_frames::{Fixed, fit_between, frames_between};
use crate::path::{CameraPath, Timeline};

/// What pins make of a path.
#[derive(Debug, Clone, PartialEq)]
pub struct Pinned {
    /// Sections that get other frames.
    pub fixed: Vec<Fixed>,
    /// The frame of its first pose.
    pub start_frame: f64,
}

/// What pins make of a path: points with the frames of their markers, in the order of the points.
///
/// # Errors
/// [`crate::Error::Range`] if the sections between two pins cannot have that number of frames,
/// [`crate::Error::Argument`] if markers lie in another order, [`crate::Error::Memory`].
pub fn pinned(path: &CameraPath, timeline: &Timeline, pins: &[(usize, f64)]) -> Result<Pinned> {
    let mut fixed = Vec::new();
    let Some(&(first, start)) = pins.first() else {
        return Ok(Pinned {
            fixed,
            start_frame: 1.0,
        });
    };
    for pair in pins.windows(2) {
        let [(from, begin), (to, end)] = [pair[0], pair[1]];
        let [begin, end] = [begin, end].map(|frame| (frame - start).round());
        let at = |error: crate::Error| error.at(Place::Point(to));
        if !(begin < end) {
            return Err(at(Invalid::PinsTurnBack.into()));
        }
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
        let frames = (end - begin) as usize;
        if frames_between(path, timeline, from, to) == frames {
            continue;
        }
        let shared = fit_between(path, timeline, from, to, frames).map_err(at)?;
        fixed.try_reserve(shared.len())?;
        fixed.extend(shared);
    }
    #[allow(clippy::cast_precision_loss)]
    let start_frame = start - frames_between(path, timeline, 0, first) as f64;
    check_frame(start_frame)?;
    Ok(Pinned { fixed, start_frame })
}

impl Scene {
    /// The pins of a node at its first `points` points, with the frames of their markers.
    fn pins_of(&self, at: usize, points: usize) -> Result<Vec<(usize, f64)>> {
        let mine = || self.pins().iter().filter(|pin| pin.node == at);
        let mut pins = vec_with_room(mine().count())?;
        let there = mine().filter(|pin| pin.point < points);
        pins.extend(there.filter_map(|pin| Some((pin.point, self.marker(&pin.marker)?))));
        Ok(pins)
    }

    /// A node's path with its pins held; none if it stays as it is.
    pub(super) fn held_by_pins(
        &self,
        at: usize,
        follow: &FollowPath,
    ) -> Result<Option<FollowPath>> {
        follow.held(&self.pins_of(at, follow.path().points.len())?)
    }

    /// The path that a node must follow for its pins to hold; none if it does.
    ///
    /// # Errors
    /// [`crate::Error::Range`] for the node; as [`pinned`], with its name.
    pub fn path_held_by_pins(&self, at: usize) -> Result<Option<FollowPath>> {
        let node = self.node(at)?;
        let held = node.path().map(|path| self.held_by_pins(at, path));
        held.unwrap_or(Ok(None))
            .map_err(|error| error.at(Place::Node((&node.name).into())))
    }
}

impl FollowPath {
    /// The path with pins held: points and frames, in the order of the points; none if it is.
    ///
    /// # Errors
    /// As [`pinned`].
    pub fn held(&self, pins: &[(usize, f64)]) -> Result<Option<Self>> {
        let path = self.path();
        if pins.is_empty() {
            return Ok(None);
        }
        let pinned = self.timeline(|timeline| pinned(path, timeline, pins))??;
        if pinned.fixed.is_empty() && pinned.start_frame == self.start_frame() {
            return Ok(None);
        }
        let mut path = path.try_clone()?;
        for fixed in &pinned.fixed {
            fixed.apply(&mut path)?;
        }
        Self::new(path, pinned.start_frame, self.extrapolation()).map(Some)
    }
}

#[cfg(test)]
#[path = "pins_tests.rs"]
mod tests;
