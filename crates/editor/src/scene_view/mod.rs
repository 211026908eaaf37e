//! The scene around the path that is edited: everything at the playhead, as lines to be drawn, the
//! list of nodes, and what is done to them.
//!
//! It exists only where there is more than one camera on a path. The movement space is in the
//! coordinates of the parent of the path's node; what is drawn of the scene is brought into them.
//!
//! It changes nothing but by the document's edits, and knows no projection.

mod boxes;
mod clipboard;
mod commands;
pub(crate) mod edges;
mod keys_panel;
mod kind_panel;
mod list;
mod list_row;
mod motion_panel;
mod node_action;
mod node_panel;
mod object_panel;
mod panel;
mod parent_window;
mod pivot;
pub(crate) mod rows;
mod selection;
mod values;
pub(crate) mod wires;

use glam::{DAffine3, DVec3};
use vides_document::Document;
use vides_document::error::{Error, Refused, Result};
use vides_engine::path::{Pose, Space};
use vides_engine::scene::{NodeState, Warnings};

pub(super) use self::list::{has_keyboard, list, take_keys};
pub(super) use self::node_panel::beside;
pub(super) use self::panel::show;
pub(super) use self::wires::{outline, wires};
use crate::space::cameras::Camera;
use crate::state::Editor;
use crate::state::scene_view::{Now, SceneView};

impl SceneView {
    /// Brings what is selected up to date.
    pub(super) fn follow(&mut self, document: &Document) {
        self.selection.follow(document);
    }
}

impl Now {
    fn of(document: &Document, frame: f64, old: Option<Self>) -> Result<Option<Self>> {
        let Some(edited) = document.edited_scene() else {
            return Ok(None);
        };
        let made_of = (edited.number(), document.revision());
        let mut now = match old {
            Some(old) if old.made_of == made_of && old.frame == frame => return Ok(Some(old)),
            Some(mut old) => {
                if old.made_of != made_of {
                    edited.update(&mut old.scene, document.path())?;
                }
                old
            }
            None => Self {
                states: Vec::new(),
                scene: document.scene()?,
                frame,
                edited: None,
                into_path: DAffine3::IDENTITY,
                trouble: None,
                meshes: 0,
                made_of,
            },
        };
        now.states
            .resize(now.scene.nodes().len(), NodeState::default());
        (now.edited, now.meshes) = (edited.node(), edited.meshes());
        (now.made_of, now.frame) = (made_of, frame);
        now.evaluate()?;
        Ok(Some(now))
    }

    fn evaluate(&mut self) -> Result<()> {
        // A channel whose host function fails moves in steps; the rest moves as it should.
        let mut warnings = Warnings::default();
        self.scene
            .evaluate(self.frame, &mut self.states, &mut warnings)?;
        let node = warnings.first().map(|(node, _)| node);
        self.trouble = node.zip(warnings.into_error().map(Error::from));
        let parent = self.edited.and_then(|at| self.scene.nodes()[at].parent);
        let world = parent.map_or(DAffine3::IDENTITY, |at| self.states[at].world());
        // A flat parent has no inverse: the world is shown as it is.
        let inverse = Some(world.inverse()).filter(|inverse| inverse.is_finite());
        self.into_path = inverse.unwrap_or(DAffine3::IDENTITY);
        Ok(())
    }

    fn pose(&self) -> Result<Pose> {
        let shown = self.scene.shown_camera().ok_or(Refused::NoCamera)?;
        Ok(self.states[shown].pose)
    }

    /// A camera or light in the coordinates of the edited path.
    pub(super) fn camera(&self, at: usize) -> Camera {
        let seen = Camera::from(self.states[at].pose);
        let turned = |way: DVec3| {
            let way = self.into_path.transform_vector3(way);
            way.try_normalize()
        };
        Camera {
            position: self.into_path.transform_point3(seen.position),
            view: turned(seen.view).unwrap_or(seen.view),
            up: turned(seen.up).unwrap_or(seen.up),
            zoom: seen.zoom.max(1.0),
        }
    }
}

impl Editor {
    /// Looks at the scene at the playhead, if there is one.
    pub(super) fn with_scene<R>(&self, look: impl FnOnce(&Now) -> R) -> Result<Option<R>> {
        if self.document.edited_scene().is_none() {
            return Ok(None);
        }
        let frame = self.previewed_frame()?;
        let mut slot = self.scene_view.now.borrow_mut();
        let old = slot.take();
        *slot = Now::of(&self.document, frame, old)?;
        Ok(slot.as_ref().map(look))
    }

    /// The movement space of the scene; without a scene, of the path.
    pub(super) fn shown_space(&self) -> Space {
        let edited = self.document.edited_scene();
        edited.map_or(self.document.path().space, |edited| edited.scene().space())
    }

    /// The pose of the camera that is shown; `None`: that of the path's own.
    pub(super) fn scene_pose(&self) -> Result<Option<Pose>> {
        let document = self.document();
        if std::ptr::eq(document, &raw const self.document) {
            return self.with_scene(Now::pose)?.transpose();
        }
        let now = Now::of(document, self.frame()?, None)?;
        now.as_ref().map(Now::pose).transpose()
    }
}

#[cfg(test)]
mod refusals_tests;
#[cfg(test)]
mod tests;
#[cfg(test)]
mod without_path_tests;
