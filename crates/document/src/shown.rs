//! What is shown of the scene that is edited: from which frame to which, by which camera, and the
//! poses of that.

use vides_engine::scene::{Kind, Motion, Node, NodeState, Scene, Warnings, local_frame};

use super::editing::Document;
use crate::error::{EngineError, OutOfRange, Refused, Result, vec_with_room};
use vides_engine::path::{Pose, Sampler, Timeline};

impl Document {
    /// The first and the last frame of what is edited: of the scene as it is now, or of the path.
    ///
    /// # Errors
    /// `ErrorKind::Memory`; `ErrorKind::Limit` for too many frames of the edited path.
    pub fn frame_range(&self) -> Result<(f64, f64)> {
        let chosen = self
            .edited_scene()
            .and_then(|edited| edited.scene().range());
        chosen.map_or_else(|| self.own_frame_range(), Ok)
    }

    /// The same as it is where no range is chosen: the first and the last frame of all paths and
    /// keys.
    ///
    /// # Errors
    /// As [`Document::frame_range`].
    pub fn own_frame_range(&self) -> Result<(f64, f64)> {
        let own = || -> Result<_> {
            let first = self.start_frame();
            let frames = self.timeline(Timeline::frame_count)??;
            #[allow(clippy::cast_precision_loss)]
            Ok((first, first + (frames - 1) as f64))
        };
        let Some(edited) = self.edited_scene() else {
            return own();
        };
        let scene = edited.scene();
        // The edited path as it is now.
        let mut all = match edited.node() {
            Some(_) => Some(own()?),
            None => None,
        };
        for (at, node) in scene.nodes().iter().enumerate() {
            let path = node.path().filter(|_| edited.node() != Some(at));
            let both = [path.and_then(Motion::frames), node.keys().frames()];
            for (first, last) in both.into_iter().flatten() {
                let wider = |all: (f64, f64)| (all.0.min(first), all.1.max(last));
                all = Some(all.map_or((first, last), wider));
            }
        }
        Ok(all.unwrap_or((1.0, 1.0)))
    }

    /// The frame of the path that is seen at one of the scene: where the path has not begun or is
    /// over, that with which it goes on there.
    ///
    /// # Errors
    /// As [`Document::frame_range`].
    pub fn seen_frame_of_path(&self, frame: f64) -> Result<f64> {
        let at = self.frame_of_path(frame);
        let follow = self.edited_scene().and_then(|edited| {
            let node = edited.scene().nodes().get(edited.node()?)?;
            node.path()
        });
        let Some(beyond) = follow.map(|follow| follow.extrapolation()) else {
            return Ok(at);
        };
        #[allow(clippy::cast_precision_loss)]
        let last = self.timeline(Timeline::frame_count)?? as f64;
        Ok(local_frame(at, 1.0, last, beyond, beyond).0)
    }

    /// A document of the shown camera's path.
    ///
    /// # Errors
    /// `ErrorKind::Argument` if there is no shown camera or it has no path; `ErrorKind::Memory`.
    pub fn shown_path(&self) -> Result<Self> {
        let Some(edited) = self.edited_scene() else {
            return self.try_clone();
        };
        let shown = edited.scene().shown_camera().ok_or(Refused::NoCamera)?;
        let path = if edited.node() == Some(shown) {
            self.path()
        } else {
            let node = &edited.scene().nodes()[shown];
            let none = || Refused::NoPathOf((&node.name).into());
            node.path().ok_or_else(none)?.path()
        };
        Self::from_parts(path.try_clone()?, self.info().try_clone()?)
    }

    /// Whether the shown camera sees exactly the edited path; none if another path or none is
    /// edited.
    #[must_use]
    pub fn shows_path(&self) -> Option<bool> {
        let Some(edited) = self.edited_scene() else {
            return Some(true);
        };
        let shown = edited.scene().shown_camera();
        let shown = shown.filter(|_| edited.node() == shown)?;
        Some(is_plain(&edited.scene().nodes()[shown]))
    }

    /// All present poses of the shown camera, one for each frame of the path; in a scene one for
    /// each whole step of its range ([`Scene::frame_range`]), as in a file.
    ///
    /// # Errors
    /// `ErrorKind::Argument` without a camera; `ErrorKind::Limit` for too many frames;
    /// `ErrorKind::Memory`.
    pub fn poses(&self) -> Result<Poses<'_>> {
        let Some(edited) = self.edited_scene() else {
            return Ok(Poses::Path(self.sampler()?));
        };
        let camera = edited.scene().shown_camera().ok_or(Refused::NoCamera)?;
        let scene = edited.with(self.path())?;
        let (first, count) = (scene.frame_range().0, scene.frame_count()?);
        scene.prepare(first)?;
        Ok(Poses::Scene {
            scene: Box::new(scene),
            camera,
            first,
            count,
        })
    }
}

/// Whether a camera sees what its path says and nothing else.
fn is_plain(node: &Node) -> bool {
    matches!(node.kind, Kind::Camera(_))
        && node.path().is_some()
        && node.parent.is_none()
        && node.aim.is_none()
        && node.rest.roll == 0.0
        && node.keys().tracks().is_empty()
}

/// The poses of the shown camera.
#[derive(Debug)]
pub enum Poses<'a> {
    /// Those of a path alone.
    Path(&'a Sampler),
    /// Those it has in a scene, at each whole step from its first frame on.
    Scene {
        /// The scene.
        scene: Box<Scene>,
        /// Number of the camera's node.
        camera: usize,
        /// The scene frame of the first pose.
        first: f64,
        /// How many there are.
        count: usize,
    },
}

impl Poses<'_> {
    /// How many there are.
    #[must_use]
    pub fn frame_count(&self) -> usize {
        match self {
            Self::Path(sampler) => sampler.frame_count(),
            Self::Scene { count, .. } => *count,
        }
    }

    /// Samples poses from number `first` on, 1 to their count.
    ///
    /// # Errors
    /// As [`Sampler::sample`].
    pub fn sample(&self, first: usize, poses: &mut [Pose]) -> Result<(), EngineError> {
        match self {
            Self::Path(sampler) => sampler.sample_once(first, poses),
            Self::Scene {
                scene,
                camera,
                first: start,
                count,
            } => {
                let inside = (1..=count + 1).contains(&first);
                if !inside || poses.len() > count + 1 - first {
                    #[allow(clippy::cast_precision_loss)]
                    let [frame, last] =
                        [first.saturating_add(poses.len().saturating_sub(1)), *count]
                            .map(|n| n as f64);
                    return Err(OutOfRange::NoFrame {
                        frame,
                        first: 1.0,
                        last,
                    }
                    .into());
                }
                let mut states = vec_with_room(poses.len().min(BLOCK))?;
                states.resize(poses.len().min(BLOCK), NodeState::default());
                for (block, poses) in poses.chunks_mut(BLOCK).enumerate() {
                    #[allow(clippy::cast_precision_loss)]
                    let from = start + (first - 1 + block * BLOCK) as f64;
                    let states = &mut states[..poses.len()];
                    // A failing host interpolation steps; the rest moves on.
                    let warnings = &mut Warnings::default();
                    scene.sample(*camera, from, 1.0, states, warnings)?;
                    for (pose, state) in poses.iter_mut().zip(states) {
                        *pose = state.pose;
                    }
                }
                Ok(())
            }
        }
    }
}

/// States evaluated at once.
const BLOCK: usize = 512;

#[cfg(test)]
#[path = "shown_tests.rs"]
mod tests;
