//! A document checked: its path against its own space, object and limits.

use vides_engine::deform::Bounds;
use vides_engine::scene::Mesh;
use vides_engine::tools::check::{Against, Finding, check};
use vides_engine::tools::clearance::Clearance;

use super::editing::Document;
use super::info::Info;
use crate::error::{Result, vec_with_room};

impl Info {
    /// The wireframe object as lines between its points.
    ///
    /// # Errors
    /// [`vides_engine::Error::Memory`].
    pub fn mesh(&self) -> Result<Mesh> {
        let mut points = vec_with_room(self.object.len())?;
        let mut lines = vec_with_room(self.object.len())?;
        for (at, point) in self.object.iter().enumerate() {
            points.push(point.position);
            // An object has fewer points than 2³².
            if point.draw && at > 0 {
                lines.push([at as u32 - 1, at as u32]);
            }
        }
        Ok(Mesh {
            points,
            lines,
            ..Mesh::default()
        })
    }
}

impl Document {
    /// What will look wrong in the film; see [`vides_engine::tools::check`]. Without
    /// an object of the caller's the document's own counts, if it has one.
    ///
    /// # Errors
    /// [`vides_engine::Error::Argument`] for an object without geometry,
    /// [`vides_engine::Error::Limit`], [`vides_engine::Error::Memory`].
    pub fn check(&self, object: Option<&Mesh>) -> Result<Vec<Finding>> {
        let (info, space) = (self.info(), self.path().space);
        let clearance = match object {
            Some(mesh) => Some(Clearance::new(mesh)?),
            None if info.object.is_empty() => None,
            None => Some(Clearance::new(&info.mesh()?)?),
        };
        let against = Against {
            fps: info.fps,
            space: Some(Bounds::new(space.low(), space.high())?),
            object: clearance.as_ref(),
            limits: info.limits,
        };
        Ok(check(self.path(), &against)?)
    }
}
