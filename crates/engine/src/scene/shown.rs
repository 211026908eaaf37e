//! What is shown of a scene: which camera, and from which frame to which.

use super::motion::{Motion, check_frame};
use super::node::Kind;
use super::scene::Scene;
use crate::error::{Invalid, Result, TooMany};
use crate::limits::MAX_FRAMES;

/// A part of a frame that is rounding: from 1.1 to 4.1 it is three steps.
const HAIR: f64 = 1e-6;

impl Scene {
    /// The number of the camera that is shown: the one chosen, else the first on a path, else the
    /// first.
    #[must_use]
    pub fn shown_camera(&self) -> Option<usize> {
        let cameras = || {
            let all = self.nodes.iter().enumerate();
            all.filter(|(_, node)| matches!(node.kind, Kind::Camera(_)))
        };
        let first = || {
            let moving = cameras().find(|(_, node)| node.path().is_some());
            moving.or_else(|| cameras().next()).map(|(at, _)| at)
        };
        self.camera.or_else(first)
    }

    /// The number of the camera that was chosen to be shown ([`Scene::shown_camera`]).
    #[must_use]
    pub const fn camera(&self) -> Option<usize> {
        self.camera
    }

    /// Sets [`Scene::camera`]. The choice stays with the node, and ends when that is removed.
    ///
    /// # Errors
    /// [`crate::Error::Range`] if there is no such node, [`crate::Error::Argument`] if it is no
    /// camera.
    pub fn set_camera(&mut self, camera: Option<usize>) -> Result<()> {
        if let Some(at) = camera {
            let node = self.node(at)?;
            if !matches!(node.kind, Kind::Camera(_)) {
                return Err(Invalid::NotACamera((&node.name).into()).into());
            }
        }
        self.camera = camera;
        Ok(())
    }

    /// The first and the last frame that were chosen to be shown ([`Scene::frame_range`]).
    #[must_use]
    pub const fn range(&self) -> Option<(f64, f64)> {
        self.range
    }

    /// Sets [`Scene::range`]; none: that of paths and keys.
    ///
    /// # Errors
    /// [`crate::Error::Argument`] or [`crate::Error::Range`] for a frame, and if the last one lies
    /// before the first; [`crate::Error::Limit`] for more than [`MAX_FRAMES`].
    pub fn set_range(&mut self, range: Option<(f64, f64)>) -> Result<()> {
        if let Some((first, last)) = range {
            check_frame(first)?;
            check_frame(last)?;
            if last < first {
                return Err(Invalid::RangeEnds.into());
            }
            count(first, last)?;
        }
        self.range = range;
        Ok(())
    }

    /// The first and the last frame: [`Scene::range`], else of all that moves; 1 and 1 if nothing
    /// does.
    #[must_use]
    pub fn frame_range(&self) -> (f64, f64) {
        let moves = || {
            let paths = self.nodes.iter().filter_map(|node| node.path()?.frames());
            let keys = self.nodes.iter().filter_map(|node| node.keys.frames());
            let all = paths.chain(keys);
            all.reduce(|a, b| (a.0.min(b.0), a.1.max(b.1)))
        };
        let known = || *self.nodes.frames.get_or_init(moves);
        self.range.or_else(known).unwrap_or((1.0, 1.0))
    }

    /// How many whole steps there are from the first frame to the last, both counted.
    ///
    /// # Errors
    /// [`crate::Error::Limit`] for more than [`MAX_FRAMES`].
    pub fn frame_count(&self) -> Result<usize> {
        let (first, last) = self.frame_range();
        count(first, last)
    }
}

fn count(first: f64, last: f64) -> Result<usize> {
    // Frames are at most 1e9.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    let count = (last - first + HAIR).floor() as usize + 1;
    if count > MAX_FRAMES {
        return Err(TooMany::SceneFrames(MAX_FRAMES).into());
    }
    Ok(count)
}

#[cfg(test)]
#[path = "shown_tests.rs"]
mod tests;
