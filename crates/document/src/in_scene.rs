//! The document as a scene: what of it is edited, and when the path is shown.

use std::sync::Arc;

use vides_engine::scene::Scene;

use super::edited_scene::{self, EditedScene};
use super::editing::Document;
use super::scene::SceneDocument;
use crate::error::{Error, Result};
use vides_engine::path::fit_frames::frames_between;

impl Document {
    /// The scene in which the path is edited; none if it is nothing but one camera on this path.
    #[must_use]
    pub fn edited_scene(&self) -> Option<&EditedScene> {
        self.content.scene.as_deref()
    }

    /// Whether the path can be edited.
    #[must_use]
    pub fn edits_path(&self) -> bool {
        self.edited_scene()
            .is_none_or(|edited| edited.node().is_some())
    }

    /// The present scene; of a path alone that of a camera on it.
    ///
    /// # Errors
    /// `ErrorKind::Memory`; `ErrorKind::Limit` for too many frames.
    pub fn scene(&self) -> Result<Scene> {
        match self.edited_scene() {
            Some(edited) => edited.with(self.path()),
            None => Ok(Scene::of_path(self.path().try_clone()?)?),
        }
    }

    /// As [`Document::scene`], with the info.
    ///
    /// # Errors
    /// As [`Document::scene`].
    pub fn scene_document(&self) -> Result<SceneDocument> {
        Ok(SceneDocument::of(self.scene()?, self.info().try_clone()?))
    }

    /// The scene frame that shows a frame of the path.
    #[must_use]
    pub fn frame_of_scene(&self, frame: f64) -> f64 {
        self.start_frame() + (frame - 1.0)
    }

    /// The number that people read for a frame of the path: that of the scene, counted from
    /// `first_frame`.
    #[must_use]
    pub fn number_of_frame(&self, frame: f64) -> f64 {
        self.frame_of_scene(frame) - 1.0 + f64::from(self.info().first_frame)
    }

    /// The scene frame of the path's first pose; 1 without a scene.
    #[must_use]
    pub fn start_frame(&self) -> f64 {
        let Some(edited) = self.edited_scene() else {
            return 1.0;
        };
        let pins = edited.pins();
        let before = |point| {
            self.timeline(|timeline| frames_between(self.path(), timeline, 0, point))
                .ok()
        };
        let pinned = pins.first().and_then(|&(point, frame)| {
            #[allow(clippy::cast_precision_loss)]
            Some(frame - before(point)? as f64)
        });
        pinned.unwrap_or_else(|| edited.start_frame())
    }

    /// The inverse of [`Document::frame_of_scene`].
    #[must_use]
    pub fn frame_of_path(&self, frame: f64) -> f64 {
        frame - self.start_frame() + 1.0
    }
}

impl SceneDocument {
    /// Edits the path of a node in its scene, as the window does: pins hold. Atomic.
    ///
    /// # Errors
    /// `ErrorKind::Range` if there is no such node, `ErrorKind::Argument` if it follows no path;
    /// those of `work`; `ErrorKind::Limit`, `ErrorKind::Memory`.
    pub fn edit_path<R, E: From<Error>>(
        &mut self,
        node: usize,
        work: impl FnOnce(&mut Document) -> Result<R, E>,
    ) -> Result<R, E> {
        let (edited, path) = edited_scene::edit(self.scene.clone(), Some(node))?;
        let document = Document::from_parts(path, self.info.try_clone().map_err(Error::from)?)?;
        let mut document = document.without_history();
        document.content.scene = Some(Arc::new(edited));
        let made = work(&mut document)?;
        self.scene = document.scene()?;
        Ok(made)
    }
}
