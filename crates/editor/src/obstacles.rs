//! What the camera must not run into, prepared when a check, a plot or a drawn line first asks.

use std::ptr;
use std::sync::Arc;

use vides_document::error::Result;
use vides_document::{Document, Object};
use vides_engine::tools::clearance::Clearance;

use crate::state::Editor;
use crate::state::obstacles::Prepared;

impl Editor {
    /// The path with all that stands around it, for another thread: without a scene, which may have
    /// functions of the host's.
    pub(crate) fn apart(&self) -> Result<Document> {
        let mut info = self.document.info().clone();
        if self.document.edited_scene().is_some() {
            info.object = match self.document.obstacles()? {
                Some(mesh) => Object::of_mesh(mesh)?,
                None => Object::default(),
            };
        }
        Document::from_parts(self.document.path().try_clone()?, info)
    }

    /// Whether there may be an object.
    pub(crate) fn has_object(&self) -> bool {
        !self.document.info().object.is_empty() || self.document.edited_scene().is_some()
    }

    /// The tree over the objects, if any.
    pub(crate) fn obstacles(&self) -> Result<Option<Arc<Clearance>>> {
        let object = &self.document.info().object;
        let scene = self.document.edited_scene().map(|edited| edited.number());
        let mut known = self.obstacles.0.borrow_mut();
        if let Some(old) = &*known
            && ptr::eq::<[_]>(&**object, &*old.object)
            && old.scene == scene
        {
            return Ok(old.tree.clone());
        }
        *known = None;
        let mesh = self.document.obstacles()?;
        let tree = mesh.as_ref().map(Clearance::new).transpose()?.map(Arc::new);
        *known = Some(Prepared {
            object: object.clone(),
            scene,
            tree: tree.clone(),
        });
        Ok(tree)
    }
}
