//! Checks a document's path against its own space, object and limits.

use glam::{DAffine3, DVec3};
use vides_engine::scene::{Kind, Mesh, NodeState, Warnings};
use vides_engine::tools::check::{Against, Finding, FindingKind, check};
use vides_engine::tools::clearance::Clearance;

use super::edit::Edit;
use super::editing::Document;
use super::info::Info;
use crate::error::{Result, vec_with_room};
use crate::limits::{MAX_FRAMES, MIN_POINTS};
use crate::path::{Change, Orientation, Own, Tangents, curve};

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
    /// What the camera must not run into, in the path's coordinates: the wireframe object and the
    /// scene's objects visible at the path's first frame. None if there is nothing.
    ///
    /// # Errors
    /// [`vides_engine::Error::Memory`]; [`vides_engine::Error::Range`] for a scene too far away.
    pub fn obstacles(&self) -> Result<Option<Mesh>> {
        let mut all = self.info().mesh()?;
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
        Ok((!all.points.is_empty()).then_some(all))
    }

    /// What will look wrong in the film ([`vides_engine::tools::check`]); `object` stands in for
    /// the document's own obstacles.
    ///
    /// # Errors
    /// [`vides_engine::Error::Argument`] for an object without geometry,
    /// [`vides_engine::Error::Limit`], [`vides_engine::Error::Memory`].
    pub fn check(&self, object: Option<&Mesh>) -> Result<Vec<Finding>> {
        let own = match object {
            Some(_) => None,
            None => self.obstacles()?,
        };
        let clearance = object.or(own.as_ref()).map(Clearance::new).transpose()?;
        self.check_against(clearance.as_ref())
    }

    /// As [`Document::check`], against a prepared object or none.
    ///
    /// # Errors
    /// [`vides_engine::Error::Limit`], [`vides_engine::Error::Memory`].
    pub fn check_against(&self, object: Option<&Clearance>) -> Result<Vec<Finding>> {
        let (info, space) = (self.info(), self.path().space);
        let against = Against {
            fps: info.fps,
            space: Some(space.into()),
            object,
            limits: info.limits,
        };
        Ok(check(self.path(), &against)?)
    }

    /// The edits, to be one step, that fix a finding; none where the choice is the user's. A turn
    /// or zoom gets more frames (not over eight times as many: then the view should change), a
    /// corner a smooth tangent, a view that jumps a place ahead to look at; a redundant key is
    /// removed.
    ///
    /// # Errors
    /// [`vides_engine::Error::Limit`], [`vides_engine::Error::Memory`].
    pub fn remedy(&self, finding: &Finding) -> Result<Vec<Edit>> {
        let path = self.path();
        let (point, at) = (finding.point, finding.orientation);
        let Some(key) = path
            .points
            .get(point)
            .and_then(|here| here.orientations.get(at))
        else {
            return Ok(Vec::new());
        };
        let mut edits = Vec::new();
        let mut own = |point: usize, at: usize, change: &dyn Fn(&mut Own)| -> Result<()> {
            let key = &path.points[point].orientations[at];
            let orientation = Orientation {
                own: key.own.with(|own| change(own))?,
                ..key.clone()
            };
            edits.push(Edit::SetOrientation {
                point,
                at,
                orientation,
            });
            Ok(())
        };
        match finding.kind {
            FindingKind::Turning | FindingKind::Zoom if finding.value <= MOST * finding.limit => {
                let sampler = self.sampler()?;
                let more = finding.value / finding.limit;
                let sections = self.timeline(|timeline| {
                    let all = 0..timeline.section_count();
                    let all = all.map(|k| (sampler.first_frame(k) as f64, timeline.section(k)));
                    let found = all.filter(|(first, section)| {
                        section.change != Change::Nothing
                            && *first <= finding.last_frame
                            && first + section.frames as f64 > finding.first_frame
                    });
                    found.map(|(_, section)| section).collect::<Vec<_>>()
                })?;
                for section in sections {
                    let frames = (section.frames as f64 * more).ceil().min(MAX_FRAMES as f64);
                    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
                    let frames = frames as u32;
                    own(section.point, section.orientation, &|own| {
                        own.frames = frames
                    })?;
                }
            }
            FindingKind::ViewJump => {
                let ahead = AHEAD * path.space.half_size;
                let next = (point + 1) % path.points.len();
                let keys = [(point, at), (next, 0)];
                for (point, at) in keys {
                    if path.points[point].orientations[at].own.ahead == Some(0.0) {
                        own(point, at, &|own| own.ahead = Some(ahead))?;
                    }
                }
            }
            FindingKind::Corner => {
                let old = curve::tangents(path, point);
                let middle = 0.5 * (old.before + old.after);
                if middle.length() > 1e-6 * path.space.half_size {
                    let tangents = Some(Tangents {
                        before: middle,
                        after: middle,
                    });
                    edits.push(Edit::SetTangents {
                        at: point,
                        tangents,
                    });
                }
            }
            FindingKind::Redundant if path.points[point].orientations.len() > 1 => {
                edits.push(Edit::RemoveOrientation { point, at });
            }
            FindingKind::Redundant if path.points.len() > MIN_POINTS && key.hold == 0 => {
                edits.push(Edit::RemovePoint { at: point });
            }
            _ => {}
        }
        Ok(edits)
    }
}

/// A section's frames grow by at most this factor.
const MOST: f64 = 8.0;

/// How far ahead a view that jumped shall look, in half sizes.
const AHEAD: f64 = 0.1;

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
