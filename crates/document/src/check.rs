//! Checks a document's path against its own space, object and limits.

use glam::{DAffine3, DVec3};
use vides_engine::scene::{Kind, Mesh, NodeState, Warnings};
use vides_engine::tools::check::{CheckContext, Finding, check_watched};
use vides_engine::tools::clearance::Clearance;
use vides_engine::tools::fit::Progress;

use super::editing::Document;
use super::info::Object;
use crate::error::{Invalid, Result, vec_with_room};

impl Object {
    /// Its mesh, or the wireframe as lines between its points.
    ///
    /// # Errors
    /// [`vides_engine::Error::Memory`].
    pub fn to_mesh(&self) -> Result<Mesh> {
        let mut all = Mesh::default();
        if let Some(mesh) = self.mesh() {
            add(&mut all, mesh, &mesh.points)?;
            return Ok(all);
        }
        all.points.try_reserve_exact(self.len())?;
        all.lines.try_reserve(self.len())?;
        for (at, point) in self.iter().enumerate() {
            all.points.push(point.position);
            if point.draw && at > 0 {
                all.lines.push([at as u32 - 1, at as u32]);
            }
        }
        Ok(all)
    }
}

impl Document {
    /// What the camera must not run into, in the path's coordinates: the wireframe object and the
    /// scene's objects visible at the path's first frame. None if there is nothing.
    ///
    /// # Errors
    /// [`vides_engine::Error::Memory`]; [`vides_engine::Error::Range`] for a scene too far away.
    pub fn obstacles(&self) -> Result<Option<Mesh>> {
        self.obstacles_of(None)
    }

    /// As [`Document::obstacles`], of one object of the scene alone.
    ///
    /// # Errors
    /// As [`Document::obstacles`]; [`vides_engine::Error::Argument`] if there is no such node.
    pub fn obstacles_of(&self, name: Option<&str>) -> Result<Option<Mesh>> {
        let mut all = match name {
            None => self.info().object.to_mesh()?,
            Some(_) => Mesh::default(),
        };
        let mut found = name.is_none();
        if let Some(edited) = self.edited_scene() {
            let scene = edited.with(self.path())?;
            let frame = self.frame_of_scene(1.0);
            let mut states = vec_with_room(scene.nodes().len())?;
            states.resize(scene.nodes().len(), NodeState::default());
            let warnings = &mut Warnings::default();
            scene.evaluate(frame, &mut states, warnings)?;
            let parent = edited.node().and_then(|at| scene.nodes()[at].parent);
            let into = parent.map_or(DAffine3::IDENTITY, |at| states[at].world().inverse());
            // A parent scaled to zero has no inverse; use world coordinates.
            let into = Some(into).filter(|into| into.is_finite());
            let into = into.unwrap_or(DAffine3::IDENTITY);
            for (at, node) in scene.nodes().iter().enumerate() {
                if name.is_some_and(|name| node.name != name) {
                    continue;
                }
                found = true;
                if let Kind::Object(object) = &node.kind
                    && states[at].visible != 0
                {
                    let mut points = vec_with_room(object.mesh().points.len())?;
                    points.resize(object.mesh().points.len(), DVec3::ZERO);
                    scene.vertices(at, frame, &mut points, warnings)?;
                    let place = into * states[at].world();
                    points
                        .iter_mut()
                        .for_each(|point| *point = place.transform_point3(*point));
                    add(&mut all, object.mesh(), &points)?;
                }
            }
        }
        if let (false, Some(name)) = (found, name) {
            return Err(Invalid::NoNodeNamed(name.into()).into());
        }
        Ok((!all.points.is_empty()).then_some(all))
    }

    /// What will look wrong in the film ([`vides_engine::tools::check`]); `object` stands in for
    /// the document's own obstacles.
    ///
    /// # Errors
    /// [`vides_engine::Error::Argument`] for an object without geometry,
    /// [`vides_engine::Error::Limit`], [`vides_engine::Error::Memory`].
    pub fn check(&self, object: Option<&Mesh>) -> Result<Vec<Finding>> {
        self.check_against(self.clearance(object)?.as_ref(), &mut |_, _| true)
    }

    /// A mesh prepared for a check, the document's own obstacles in its absence.
    ///
    /// # Errors
    /// As [`Document::check`].
    pub fn clearance(&self, object: Option<&Mesh>) -> Result<Option<Clearance>> {
        let own = match object {
            Some(_) => None,
            None => self.obstacles()?,
        };
        let mesh = object.or(own.as_ref());
        Ok(mesh.map(Clearance::new).transpose()?)
    }

    /// As [`Document::clearance`], for what cannot do without an object.
    ///
    /// # Errors
    /// As [`Document::check`]; [`vides_engine::Error::Argument`] without an object.
    pub fn solid(&self, object: Option<&Mesh>) -> Result<Clearance> {
        self.clearance(object)?
            .ok_or_else(|| Invalid::NoGeometry.into())
    }

    /// As [`Document::check`], against a prepared object or none; `progress` gets frames that were
    /// looked at and all, and ends it with `false`.
    ///
    /// # Errors
    /// [`vides_engine::Error::Argument`] where `progress` ends it; [`vides_engine::Error::Limit`],
    /// [`vides_engine::Error::Memory`].
    pub fn check_against(
        &self,
        object: Option<&Clearance>,
        progress: Progress<'_>,
    ) -> Result<Vec<Finding>> {
        let (info, space) = (self.info(), self.path().space);
        let against = CheckContext {
            fps: info.fps,
            space: Some(space.into()),
            object,
            limits: info.limits,
        };
        Ok(check_watched(self.path(), &against, progress)?)
    }
}

/// Appends a mesh with its points moved to `points`; a point cloud becomes lines of length zero.
fn add(all: &mut Mesh, mesh: &Mesh, points: &[DVec3]) -> Result<()> {
    // A mesh has fewer than 2³² points.
    let start = all.points.len() as u32;
    all.points.try_reserve(points.len())?;
    all.points.extend_from_slice(points);
    all.lines.try_reserve(mesh.lines.len())?;
    let lines = mesh.lines.iter();
    all.lines
        .extend(lines.map(|ends| ends.map(|at| start + at)));
    all.triangles.try_reserve(mesh.triangles.len())?;
    let triangles = mesh.triangles.iter();
    all.triangles
        .extend(triangles.map(|corners| corners.map(|at| start + at)));
    if mesh.lines.is_empty() && mesh.triangles.is_empty() {
        all.lines.try_reserve(points.len())?;
        all.lines
            .extend((start..).take(points.len()).map(|at| [at, at]));
    }
    Ok(())
}

#[cfg(test)]
#[path = "check_tests.rs"]
mod tests;
