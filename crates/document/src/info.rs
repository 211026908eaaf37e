//! What a file holds besides the path: title, frame rate, unit, object and limits.

use std::ops::Deref;
use std::sync::Arc;

use glam::DVec3;
use vides_engine::scene::{Mesh, MeshSource};
use vides_engine::tools::check::Limits;

use crate::error::{OutOfRange, Place, TooMany};
use vides_engine::Result;
use vides_engine::limits;
use vides_engine::path::Space;
use vides_engine::path::camera_path::check_name;
use vides_engine::property::{Affects, Check, Row, SameBits, Stored, properties};

properties! {
    /// The part of a document that the engine does not read.
    pub struct Info {
        /// One line, at most 256 bytes.
        pub title: String = String::new() => Row {
            check: Check::By(|title, _| check_name(title)),
            affects: Affects::Nothing,
            ..Row::new(&["title"])
        },
        /// Any lines, at most 65536 bytes.
        pub comment: String = String::new() => Row {
            check: Check::By(|comment, _| check_comment(comment)),
            affects: Affects::Nothing,
            ..Row::new(&["comment"])
        },
        /// Frames per second; greater than 0, at most 100000.
        pub fps: f64 = 25.0 => Row {
            check: Check::By(|fps, _| check_fps(*fps)),
            affects: Affects::Nothing,
            ..Row::new(&["fps"])
        },
        /// Number of the first frame in the user's film.
        pub first_frame: i32 = 1 => Row { affects: Affects::Nothing, ..Row::new(&["first_frame"]) },
        /// Name of the world's unit ("m"), one line as the title; may be empty.
        pub unit: String = String::new() => Row {
            check: Check::By(|unit, _| check_name(unit).map_err(|error| error.at(Place::Unit))),
            ..Row::new(&[])
        },
        /// Wireframe object, shown for orientation.
        pub object: Object = Object::NONE => Row {
            check: Check::By(Object::check),
            ..Row::new(&[])
        },
        /// Limits for checks.
        pub limits: Limits = Limits::NEW => Row::new(&[]),
    }
}

/// A point of a wireframe object (thesis B.2.2, `V_OBJEKT_LIST`).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ObjectPoint {
    /// In world coordinates.
    pub position: DVec3,
    /// Whether a line from the previous point leads here; false for a document's first point.
    pub draw: bool,
}

/// The points of a wireframe object, shared since they may be many, and the mesh file it comes
/// from. An empty one allocates nothing, so that it can be made and copied when memory runs out.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Object {
    points: Option<Arc<Vec<ObjectPoint>>>,
    /// One per point, or none.
    colours: Option<Arc<Vec<[u8; 3]>>>,
    source: Option<Arc<MeshSource>>,
    /// What the points are the wireframe of.
    mesh: Option<Arc<Mesh>>,
}

impl From<Vec<ObjectPoint>> for Object {
    fn from(points: Vec<ObjectPoint>) -> Self {
        Self {
            points: (!points.is_empty()).then(|| Arc::new(points)),
            ..Self::default()
        }
    }
}

impl Object {
    const NONE: Self = Self {
        points: None,
        colours: None,
        source: None,
        mesh: None,
    };

    /// Few enough points, each in the space.
    fn check(&self, space: Space) -> Result<()> {
        if self.len() > limits::MAX_OBJECT_POINTS {
            return Err(TooMany::ObjectPoints.into());
        }
        for (index, point) in self.iter().enumerate() {
            space
                .check_place(point.position)
                .map_err(|error| error.at(Place::ObjectPoint(index)))?;
        }
        if let Some(mesh) = self.mesh() {
            for &corner in mesh.triangles.iter().flatten() {
                let place = mesh.points[corner as usize];
                let checked = space.check_place(place);
                checked.map_err(|error| error.at(Place::ObjectPoint(corner as usize)))?;
            }
        }
        Ok(())
    }

    /// Sets the mesh file, which a document names instead of listing the points.
    pub(super) fn of_source(self, source: MeshSource) -> Self {
        Self {
            source: Some(Arc::new(source)),
            ..self
        }
    }

    /// Sets RGB colours, one per point or none; kept only in documents with a mesh file.
    pub(super) fn coloured(self, colours: Vec<[u8; 3]>) -> Self {
        Self {
            colours: (colours.len() == self.len()).then(|| Arc::new(colours)),
            ..self
        }
    }

    /// Sets the mesh of which these are the lines.
    pub(super) fn of(self, mesh: Mesh) -> Self {
        Self {
            mesh: Some(Arc::new(mesh)),
            ..self
        }
    }

    /// The mesh that the wireframe was made of, with its faces; none if there is only the wireframe.
    #[must_use]
    pub fn mesh(&self) -> Option<&Mesh> {
        self.mesh.as_deref()
    }

    /// How many points, lines and triangles there are to look at.
    #[must_use]
    pub fn pieces(&self) -> usize {
        self.mesh().map_or(self.len(), |mesh| {
            mesh.points.len() + mesh.lines.len() + mesh.triangles.len()
        })
    }

    /// Whether both have the same points and mesh in memory.
    pub(super) fn shares(&self, other: &Self) -> bool {
        let points = |of: &Self| of.points.as_ref().map(Arc::as_ptr);
        let mesh = |of: &Self| of.mesh.as_ref().map(Arc::as_ptr);
        points(self) == points(other) && mesh(self) == mesh(other)
    }

    /// Approximate bytes of memory.
    pub(super) fn bytes(&self) -> usize {
        let mesh = self.mesh().map_or(0, |mesh| {
            size_of_val(&*mesh.points) + size_of_val(&*mesh.triangles) + size_of_val(&*mesh.lines)
        });
        size_of_val::<[ObjectPoint]>(self) + mesh
    }

    /// The lines to draw with the colours of their ends; isolated points are lines of length zero.
    pub fn lines(&self) -> impl Iterator<Item = ([DVec3; 2], Option<[u8; 3]>)> + '_ {
        let colours = self.colours.as_ref().map(|colours| colours.as_slice());
        self.iter().enumerate().filter_map(move |(at, point)| {
            let colour = colours.and_then(|colours| colours.get(at).copied());
            let alone = !self.get(at + 1).is_some_and(|next| next.draw);
            match point.draw {
                true => Some((
                    [self.get(at.checked_sub(1)?)?.position, point.position],
                    colour,
                )),
                false => alone.then_some(([point.position; 2], colour)),
            }
        })
    }

    /// The mesh file; none if the document keeps the points.
    #[must_use]
    pub fn source(&self) -> Option<&MeshSource> {
        self.source.as_deref()
    }
}

impl Deref for Object {
    type Target = [ObjectPoint];

    fn deref(&self) -> &[ObjectPoint] {
        self.points.as_ref().map_or(&[], |points| points)
    }
}

impl Default for Info {
    fn default() -> Self {
        Self::NEW
    }
}

impl SameBits for Object {
    fn same_bits(&self, other: &Self) -> bool {
        self == other
    }
}

impl Stored for Object {}

impl Info {
    pub(super) fn try_clone(&self) -> Result<Self> {
        Ok(Self {
            title: copy_text(&self.title)?,
            comment: copy_text(&self.comment)?,
            fps: self.fps,
            first_frame: self.first_frame,
            unit: copy_text(&self.unit)?,
            object: self.object.clone(),
            limits: self.limits,
        })
    }

    /// Clears the first object point's `draw`.
    pub(super) fn normalise(&mut self) {
        if let Some(points) = &mut self.object.points
            && points.first().is_some_and(|first| first.draw)
        {
            Arc::make_mut(points)[0].draw = false;
        }
    }

    /// Checks all fields against their ranges and the space.
    ///
    /// # Errors
    /// The first invalid field, with the reason.
    pub fn check(&self, space: Space) -> Result<()> {
        Self::PROPERTIES.iter().try_for_each(|row| {
            (row.check)(self, space).map_err(|error| match row.keys {
                ["title"] => error.at(Place::Title),
                _ => error,
            })
        })
    }
}

pub(super) fn check_fps(fps: f64) -> Result<()> {
    if !(fps > 0.0 && fps <= limits::MAX_FPS) {
        return Err(OutOfRange::Fps.into());
    }
    Ok(())
}

pub(super) fn check_comment(comment: &str) -> Result<()> {
    if comment.len() > limits::MAX_COMMENT_BYTES {
        return Err(TooMany::CommentBytes.into());
    }
    Ok(())
}

pub(super) fn copy_text(text: &str) -> Result<String> {
    let mut copy = String::new();
    copy.try_reserve_exact(text.len())?;
    copy.push_str(text);
    Ok(copy)
}
