//! The planning tools; each call is one undo step.

use std::path::PathBuf;

use numpy::PyReadonlyArray2;
use pyo3::prelude::*;
use vides::document::mesh::Format;
use vides::document::{self, Document, Edit, Info, Object};
use vides::path::CameraPath;
use vides::planner::{
    AvoidRequest, Request, SteadyRequest, TourRequest, What, avoid_object, retime, steady,
};
use vides::scene::Mesh;
use vides::tools::check::{FindingKind, Limits};
use vides::tools::fit::Progress;

use crate::arrays;
use crate::document::upright;
use crate::error::{Failure, Result};
use crate::interrupt::interruptible;

/// The kind as a Python keyword.
pub(crate) fn keyword(kind: FindingKind) -> String {
    kind.name().replace('-', "_")
}

/// What a limit counts in the engine, in the path's unit: half sizes for lengths.
pub(crate) fn scale(kind: FindingKind, half_size: f64) -> f64 {
    match kind.unit().starts_with("half sizes") {
        true => half_size,
        false => 1.0,
    }
}

/// Limits by keyword, in the path's unit.
pub(crate) fn named(limits: &Limits, half_size: f64) -> Vec<(String, f64)> {
    let kinds = FindingKind::all();
    kinds
        .map(|kind| (keyword(kind), limits.get(kind) * scale(kind, half_size)))
        .collect()
}

/// Limits, changed by keyword, in the path's unit; `None` restores a default.
pub(crate) fn limits(
    mut of: Limits,
    given: &[(String, Option<f64>)],
    half_size: f64,
) -> Result<Limits> {
    for (name, limit) in given {
        let kind = FindingKind::all().find(|kind| keyword(*kind) == *name);
        let kind = kind.ok_or_else(|| {
            let known: Vec<_> = FindingKind::all().map(keyword).collect();
            Failure::argument(format!(
                "there is no limit {name:?}; limits are {}",
                known.join(", ")
            ))
        })?;
        let limit = limit.map(|limit| limit / scale(kind, half_size));
        of.set(kind, limit.unwrap_or(kind.limit().default))?;
    }
    Ok(of)
}

/// The planned edit, and its report.
type Planned<T> = Result<(Edit, T)>;

fn replacing(path: CameraPath) -> Edit {
    Edit::ReplacePath(Box::new(path))
}

/// Where the camera rests: point, orientation, limit.
pub(crate) type Rests = Vec<(usize, usize, String)>;

/// Recomputes the speed of points; returns their duration and where the camera rests.
pub(crate) fn retimed(
    document: &Document,
    seconds: f64,
    points: [usize; 2],
    given: &[(String, Option<f64>)],
    go_on: Progress<'_>,
) -> Planned<(f64, Rests)> {
    let request = Request {
        limits: limits(
            document.info().limits,
            given,
            document.path().space.half_size,
        )?,
        fps: document.info().fps,
        points: Some(points),
        seconds,
    };
    let made = retime(document.path(), &request, go_on)?;
    let rests = made.rests.iter();
    let rests = rests.map(|rest| (rest.point, rest.orientation, keyword(rest.limit)));
    let told = (made.seconds, rests.collect());
    Ok((replacing(made.path), told))
}

/// An object as given in Python: a file name, or points and triangles.
#[derive(FromPyObject)]
pub(crate) enum Given<'py> {
    File(PathBuf),
    Mesh(PyReadonlyArray2<'py, f64>, Vec<[u32; 3]>),
}

/// The same, to be moved to another thread.
pub(crate) enum Source {
    File(PathBuf),
    Mesh(Mesh),
}

impl Given<'_> {
    pub(crate) fn source(self) -> Result<Source> {
        Ok(match self {
            Self::File(file) => Source::File(file),
            Self::Mesh(points, triangles) => Source::Mesh(Mesh {
                points: arrays::places(&points)?,
                triangles,
                ..Mesh::default()
            }),
        })
    }
}

impl Source {
    /// The object of a mesh file, of a `.vid` file, or of a mesh.
    pub(crate) fn object(self) -> Result<Object> {
        Ok(match self {
            Self::File(file) if Format::of(&file).is_some() => document::load_object(&file)?,
            Self::File(file) => Document::load_scene(&file)?.0.info().object.clone(),
            Self::Mesh(mesh) => Object::features_of(mesh)?,
        })
    }

    fn mesh(self) -> Result<Mesh> {
        match self {
            Self::Mesh(mesh) => {
                mesh.check()?;
                Ok(mesh)
            }
            file @ Self::File(_) => Ok(file.object()?.to_mesh()?),
        }
    }
}

/// First and last point, number of moved points, number of inserted points, greatest distance.
pub(crate) type Detours = Vec<(usize, usize, usize, usize, f64)>;

/// Moves the path away from an object, by default its own.
pub(crate) fn avoided(
    document: &Document,
    (clearance, radius): (f64, f64),
    object: Option<Source>,
    go_on: Progress<'_>,
) -> Planned<Detours> {
    let object = object.map(Source::mesh).transpose()?;
    let object = document.solid(object.as_ref())?;
    let request = AvoidRequest { clearance, radius };
    let made = avoid_object(document.path(), &object, &request, go_on)?;
    let parts = made.parts.iter();
    let told = parts
        .map(|part| (part.from, part.to, part.moved, part.inserted, part.furthest))
        .collect();
    Ok((replacing(made.path), told))
}

/// Keeps an object in the picture; returns the number of points added, the greatest and the least
/// share of the room.
pub(crate) fn framed(
    document: &Document,
    (margin, by): (f64, &str),
    object: Option<Source>,
    go_on: Progress<'_>,
) -> Planned<(usize, f64, f64)> {
    let what = What::named(by).ok_or_else(|| {
        Failure::argument(format!(
            "by is \"zoom\", \"distance\" or \"view\", not {by:?}"
        ))
    })?;
    let object = object.map(Source::mesh).transpose()?;
    let object = document.solid(object.as_ref())?;
    let limits = document.info().limits;
    let made = document.framed(&object, (margin, what), limits, go_on)?;
    Ok((
        replacing(made.path),
        (made.added, made.tightest, made.loosest),
    ))
}

/// Stabilises the path; returns how far a position moved and by how many degrees a view turned, at
/// most.
pub(crate) fn steadied(
    document: &Document,
    seconds: f64,
    within: f64,
    go_on: Progress<'_>,
) -> Planned<(f64, f64)> {
    let request = SteadyRequest {
        period: seconds,
        within,
        fps: document.info().fps,
    };
    let made = steady(document.path(), &request, go_on)?;
    Ok((replacing(made.path), (made.furthest, made.turned)))
}

/// Coverage, share of the surface, views, distance, length, seconds, and the shares of the surface
/// that are left out, narrow and hidden.
type Told = (f64, f64, usize, f64, f64, f64, f64, f64, f64);

/// Plans a flight that shows an object.
#[pyfunction]
#[pyo3(signature = (object, seconds, coverage, distance, inside, start, up, stills))]
#[expect(clippy::too_many_arguments)]
pub(crate) fn tour(
    py: Python<'_>,
    object: Given<'_>,
    seconds: f64,
    coverage: f64,
    distance: f64,
    inside: bool,
    start: Option<[f64; 3]>,
    up: &str,
    stills: bool,
) -> PyResult<(crate::document::Document, Told)> {
    let request = TourRequest {
        seconds,
        coverage,
        distance,
        inside,
        start: start.map(Into::into),
        up: upright(up)?,
        stills,
        ..TourRequest::default()
    };
    let source = object.source()?;
    interruptible(py, |go_on| {
        let object = source.object()?;
        let made = vides::planner::tour(&object.to_mesh()?, &request, go_on)?;
        let told = (
            made.coverage,
            made.surface,
            made.places,
            made.distance,
            made.length,
            made.seconds,
            made.left_out,
            made.narrow,
            made.hidden,
        );
        let info = Info {
            object,
            ..Info::default()
        };
        Ok((Document::from_parts(made.path, info)?.into(), told))
    })
}
