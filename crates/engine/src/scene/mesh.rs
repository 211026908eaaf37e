//! What an object is made of: points, lines and triangles, other shapes, deformations.

use std::sync::Arc;

use glam::DVec3;

use crate::deform::{Bounds, Deformation};
use crate::error::{Entry, Invalid, OutOfRange, Place, Result, TooMany, can_allocate, try_arc};
use crate::limits::{
    MAX_COORDINATE, MAX_DEFORMATIONS, MAX_MESH_CORNERS, MAX_MESH_POINTS, MAX_SHAPES,
};
use crate::path::camera_path::{check_coordinates, check_name};

/// A deformation with its box; none: that of the mesh.
pub(super) type Boxed = (Deformation, Option<Bounds>);

/// Geometry at rest. With neither lines nor triangles it is a cloud of points.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Mesh {
    /// In the object's coordinates.
    pub points: Vec<DVec3>,
    /// Red, green, blue of each point; empty: none.
    pub colours: Vec<[u8; 3]>,
    /// Two indices a line.
    pub lines: Vec<[u32; 2]>,
    /// Three indices a triangle.
    pub triangles: Vec<[u32; 3]>,
}

impl Mesh {
    /// Checks that everything is finite and every index that of a point.
    ///
    /// # Errors
    /// The first thing that is not; [`crate::Error::Limit`] for more than [`crate::limits`] allow.
    pub fn check(&self) -> Result<()> {
        let count = self.points.len();
        if count > MAX_MESH_POINTS {
            return Err(TooMany::MeshPoints.into());
        }
        let corners = (2 * self.lines.len()).max(3 * self.triangles.len());
        if corners > MAX_MESH_CORNERS {
            return Err(TooMany::MeshCorners.into());
        }
        check_points(&self.points)?;
        if !self.colours.is_empty() && self.colours.len() != count {
            return Err(OutOfRange::MeshColours {
                points: count,
                given: self.colours.len(),
            }
            .into());
        }
        let wrong = |indices: &[u32], name| {
            let at = indices.iter().position(|&index| index as usize >= count)?;
            Some(OutOfRange::NoMeshPoint {
                corner: Entry(name, at),
                point: indices[at],
                count,
            })
        };
        let lines = wrong(self.lines.as_flattened(), "lines");
        let found = lines.or_else(|| wrong(self.triangles.as_flattened(), "triangles"));
        found.map_or(Ok(()), |wrong| Err(wrong.into()))
    }
}

fn check_points(points: &[DVec3]) -> Result<()> {
    for (at, &point) in points.iter().enumerate() {
        check_coordinates(point).map_err(|error| error.at(Place::Point(at)))?;
    }
    Ok(())
}

/// Another shape of an object's points.
#[derive(Debug, Clone, PartialEq)]
pub struct Shape {
    /// One line.
    pub name: String,
    /// As many points as the mesh has.
    pub points: Vec<DVec3>,
    /// As many colours, or none: then those of the mesh.
    pub colours: Vec<[u8; 3]>,
}

/// The file that a mesh came from, saved in its place. Nothing here opens it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct MeshSource {
    /// Its name.
    pub file: String,
    /// How long it was; 0: it was not read yet, and has no checksum either.
    pub bytes: u64,
    /// A checksum of its bytes.
    pub checksum: u64,
    /// The number of its mesh in a glTF file, from 0; none: all of the file.
    pub part: Option<u32>,
}

/// An object: its mesh, shapes with weights, and deformations with their boxes (none: the mesh's).
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Object {
    mesh: Option<Arc<Mesh>>,
    source: Option<Arc<MeshSource>>,
    bounds: Option<Bounds>,
    shapes: Vec<Arc<Shape>>,
    weights: Vec<f64>,
    deformations: Vec<(Deformation, Option<Bounds>)>,
}

/// A mesh that an object can have, and where it comes from. Clones share it.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Geometry {
    mesh: Option<Arc<Mesh>>,
    bounds: Option<Bounds>,
    source: Option<Arc<MeshSource>>,
}

impl Mesh {
    fn heap_size(&self) -> usize {
        let corners = size_of_val(&self.lines[..]) + size_of_val(&self.triangles[..]);
        size_of_val(&self.points[..]) + size_of_val(&self.colours[..]) + corners
    }
}

impl Geometry {
    /// A mesh; with `source` that file is saved in its place.
    ///
    /// # Errors
    /// As [`Mesh::check`]; [`crate::Error::Memory`].
    pub fn new(mesh: Mesh, source: Option<MeshSource>) -> Result<Self> {
        mesh.check()?;
        can_allocate(256 + size_of::<Mesh>())?;
        Ok(Self {
            bounds: Some(Bounds::of(&mesh.points)),
            mesh: Some(Arc::new(mesh)),
            source: source.map(Arc::new),
        })
    }

    /// That of an object, which both share.
    #[must_use]
    pub fn of(object: &Object) -> Self {
        Self {
            mesh: object.mesh.clone(),
            bounds: object.bounds,
            source: object.source.clone(),
        }
    }
}

static EMPTY: Mesh = Mesh {
    points: Vec::new(),
    colours: Vec::new(),
    lines: Vec::new(),
    triangles: Vec::new(),
};

impl Object {
    /// The mesh; empty if none was set.
    #[must_use]
    pub fn mesh(&self) -> &Mesh {
        self.mesh.as_deref().unwrap_or(&EMPTY)
    }

    /// Sets the mesh; it comes from no file then.
    ///
    /// # Errors
    /// As [`Mesh::check`]; [`crate::Error::Argument`] if it has other points than the shapes.
    pub fn set_mesh(&mut self, mesh: Mesh) -> Result<()> {
        mesh.check()?;
        self.check_shapes(&mesh)?;
        self.bounds = Some(Bounds::of(&mesh.points));
        self.mesh = Some(Arc::new(mesh));
        self.source = None;
        Ok(())
    }

    fn check_shapes(&self, mesh: &Mesh) -> Result<()> {
        match self.shapes.first() {
            Some(shape) if mesh.points.len() != shape.points.len() => Err(Invalid::MeshOfShapes {
                given: mesh.points.len(),
                wanted: shape.points.len(),
            }
            .into()),
            _ => Ok(()),
        }
    }

    /// Takes the mesh of another object, which both share then.
    ///
    /// # Errors
    /// [`crate::Error::Argument`] if it has other points than the shapes.
    pub fn share_mesh(&mut self, other: &Self) -> Result<()> {
        self.check_shapes(other.mesh())?;
        (self.mesh, self.bounds) = (other.mesh.clone(), other.bounds);
        self.source = None;
        Ok(())
    }

    pub(super) fn put_mesh(&mut self, other: Geometry) -> Result<()> {
        // An empty one stands for a file that is not there now.
        let mesh = other.mesh.as_deref().unwrap_or(&EMPTY);
        if other.source.is_none() || !mesh.points.is_empty() {
            self.check_shapes(mesh)?;
        }
        (self.mesh, self.bounds, self.source) = (other.mesh, other.bounds, other.source);
        Ok(())
    }

    /// The file that is saved in place of the mesh, which is empty where that could not be read.
    #[must_use]
    pub fn source(&self) -> Option<&MeshSource> {
        self.source.as_deref()
    }

    /// Sets the file that the mesh came from, or will come from where it is empty; none: its own.
    ///
    /// # Errors
    /// [`crate::Error::Memory`].
    pub fn set_source(&mut self, source: Option<MeshSource>) -> Result<()> {
        can_allocate(256)?;
        self.source = source.map(Arc::new);
        Ok(())
    }

    /// The shapes, each with the weight that it has at rest.
    #[must_use]
    pub fn shapes(&self) -> &[Arc<Shape>] {
        &self.shapes
    }

    /// The weights at rest, one for each shape.
    #[must_use]
    pub fn weights(&self) -> &[f64] {
        &self.weights
    }

    /// Sets the weights at rest.
    ///
    /// # Errors
    /// [`crate::Error::Range`] or [`crate::Error::Argument`].
    pub fn set_weights(&mut self, weights: &[f64]) -> Result<()> {
        self.check_weights(weights)?;
        self.weights.copy_from_slice(weights);
        Ok(())
    }

    fn check_weights(&self, weights: &[f64]) -> Result<()> {
        if weights.len() != self.shapes.len() {
            return Err(OutOfRange::ShapeWeights {
                shapes: self.shapes.len(),
                given: weights.len(),
            }
            .into());
        }
        if !weights.iter().all(|weight| weight.abs() <= MAX_COORDINATE) {
            return Err(Invalid::Weight.into());
        }
        Ok(())
    }

    /// Adds a shape with weight 0; tracks of the weights are the scene's part.
    ///
    /// # Errors
    /// [`crate::Error::Argument`], [`crate::Error::Range`], [`crate::Error::Limit`],
    /// [`crate::Error::Memory`].
    pub fn add_shape(&mut self, shape: Shape) -> Result<()> {
        let at = self.shapes.len();
        self.check_new_shape(at, &shape)?;
        self.insert_shape(at, try_arc(shape)?);
        Ok(())
    }

    /// Whether it can have this shape as number `at`.
    pub(super) fn check_new_shape(&self, at: usize, shape: &Shape) -> Result<()> {
        check_name(&shape.name).map_err(|error| error.at(Place::Name))?;
        let known = self.shapes.len();
        if at > known {
            return Err(OutOfRange::NoShape { at, count: known }.into());
        }
        if known >= MAX_SHAPES {
            return Err(TooMany::Shapes.into());
        }
        // Where the mesh lies in a file that was not read, shapes agree with each other.
        let count = match self.shapes.first() {
            Some(other) => other.points.len(),
            None if self.source.is_some() && self.mesh().points.is_empty() => shape.points.len(),
            None => self.mesh().points.len(),
        };
        let colours = shape.colours.len();
        if shape.points.len() != count || (colours != 0 && colours != count) {
            return Err(OutOfRange::ShapePoints {
                shape: (&shape.name).into(),
                given: shape.points.len(),
                wanted: count,
            }
            .into());
        }
        check_points(&shape.points)?;
        can_allocate(32 * (known + 1))
    }

    /// Puts in a shape that was checked; tracks of the weights are the scene's part.
    pub(super) fn insert_shape(&mut self, at: usize, shape: Arc<Shape>) {
        self.shapes.insert(at, shape);
        self.weights.insert(at, 0.0);
    }

    /// Removes a shape that is there; tracks of the weights are the scene's part.
    pub(super) fn remove_shape(&mut self, at: usize) {
        self.shapes.remove(at);
        self.weights.remove(at);
    }

    /// The deformations in the order in which they act.
    #[must_use]
    pub fn deformations(&self) -> &[(Deformation, Option<Bounds>)] {
        &self.deformations
    }

    /// Adds a deformation behind the others and returns its number; no box: that of the mesh.
    ///
    /// # Errors
    /// [`crate::Error::Limit`], [`crate::Error::Memory`].
    pub fn add_deformation(
        &mut self,
        deformation: Deformation,
        bounds: Option<Bounds>,
    ) -> Result<usize> {
        let at = self.deformations.len();
        self.insert_deformation(at, (deformation, bounds))?;
        Ok(at)
    }

    pub(super) fn insert_deformation(&mut self, at: usize, new: Boxed) -> Result<()> {
        let count = self.deformations.len();
        if at > count {
            return Err(OutOfRange::NoDeformation { at, count }.into());
        }
        if count >= MAX_DEFORMATIONS {
            return Err(TooMany::Deformations.into());
        }
        self.deformations.try_reserve(1)?;
        self.deformations.insert(at, new);
        Ok(())
    }

    pub(super) fn check_deformation(&self, at: usize) -> Result<()> {
        let count = self.deformations.len();
        if at >= count {
            return Err(OutOfRange::NoDeformation { at, count }.into());
        }
        Ok(())
    }

    /// Removes a deformation that is there.
    pub(super) fn remove_deformation(&mut self, at: usize) {
        self.deformations.remove(at);
    }

    /// One that is there.
    pub(super) fn deformation_mut(&mut self, at: usize) -> &mut Boxed {
        &mut self.deformations[at]
    }

    /// Gives a deformation that is there another place.
    pub(super) fn move_deformation(&mut self, from: usize, to: usize) {
        let moved = self.deformations.remove(from);
        self.deformations.insert(to, moved);
    }

    pub(super) fn bounds(&self) -> Bounds {
        self.bounds.unwrap_or_else(|| Bounds::of(&[]))
    }

    /// About how many bytes it takes that another one does not share.
    pub(super) fn heap_size_without(&self, other: Option<&Self>) -> usize {
        let deformations = self.deformations.iter();
        let numbers: usize = deformations.map(|(d, _)| d.parameters().len()).sum();
        let lists = 8 * numbers + 160 * self.deformations.len() + 16 * self.shapes.len();
        let theirs = other.and_then(|other| other.mesh.as_ref());
        let mesh = self
            .mesh
            .as_ref()
            .filter(|mesh| theirs.is_none_or(|theirs| !Arc::ptr_eq(mesh, theirs)));
        let known = |shape: &&Arc<Shape>| {
            let mut theirs = other.into_iter().flat_map(|other| &other.shapes);
            theirs.any(|theirs| Arc::ptr_eq(theirs, shape))
        };
        let shapes = self.shapes.iter().filter(|shape| !known(shape));
        let shape =
            |shape: &Arc<Shape>| size_of_val(&shape.points[..]) + size_of_val(&shape.colours[..]);
        lists + mesh.map_or(0, |mesh| mesh.heap_size()) + shapes.map(shape).sum::<usize>()
    }
}
