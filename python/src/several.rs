//! What concerns several points of a path; each call is one undo step, or changes nothing.

use numpy::{PyArray1, PyReadonlyArray1, PyReadonlyArray2};
use pyo3::prelude::*;
use vides::document::{self, Edit};
use vides::glam::DMat4;
use vides::math::orientation::wrap_degrees;
use vides::path::fit_frames::Fixed;
use vides::path::{CameraPath, Orientation, Target};
use vides::tools::block::{Fit, extract as extracted};

use crate::arrays;
use crate::document::Document;
use crate::edits;
use crate::error::{Failure, Result};

/// Ways to place an inserted path, by their names.
const FITS: [(&str, Fit); 4] = [
    ("none", Fit::None),
    ("move", Fit::Move),
    ("turn", Fit::Turn),
    ("scale", Fit::Scale),
];

fn replacing(path: CameraPath) -> Edit {
    Edit::ReplacePath(Box::new(path))
}

/// Fails unless there is one value a point.
fn each(path: &CameraPath, given: usize, what: &str) -> Result<()> {
    let count = path.points.len();
    if given == count {
        return Ok(());
    }
    Err(Failure::argument(format!(
        "there are {count} points, and {given} {what}"
    )))
}

/// Moves all points, and the targets given as offsets with them.
#[pyfunction]
pub(crate) fn set_positions(
    py: Python<'_>,
    path: &Document,
    positions: PyReadonlyArray2<'_, f64>,
) -> Result<()> {
    let places = arrays::places(&positions)?;
    path.write(py, |document| {
        let mut path = document.path().try_clone()?;
        each(&path, places.len(), "positions")?;
        for (point, place) in path.points.iter_mut().zip(places) {
            point.position = place;
        }
        Ok::<_, Failure>(document.apply(replacing(path))?)
    })
}

/// Makes all views of a point, or of all points, look at a place: one for all, or one a point.
#[pyfunction]
#[pyo3(signature = (path, targets, point))]
pub(crate) fn look_at(
    py: Python<'_>,
    path: &Document,
    targets: PyReadonlyArray2<'_, f64>,
    point: Option<usize>,
) -> Result<()> {
    let targets = arrays::places(&targets)?;
    path.write(py, |document| {
        let mut path = document.path().try_clone()?;
        let points = match point {
            Some(at) => {
                edits::point(document, at)?;
                at..at + 1
            }
            None => 0..path.points.len(),
        };
        if targets.len() != 1 {
            each(&path, targets.len(), "targets")?;
        }
        for at in points {
            let target = targets[if targets.len() == 1 { 0 } else { at }];
            for orientation in &mut path.points[at].orientations {
                orientation.target = Target::Absolute(target);
            }
        }
        Ok::<_, Failure>(document.apply(replacing(path))?)
    })
}

/// The field of a view by its name.
fn field<'a>(view: &'a mut Orientation, name: &str) -> Result<&'a mut f64> {
    match name {
        "zoom" => Ok(&mut view.zoom),
        "roll" => Ok(&mut view.roll),
        _ => Err(Failure::argument(format!("there are no {name}s"))),
    }
}

/// Zoom or roll of the first view of each point.
#[pyfunction]
pub(crate) fn numbers<'py>(
    py: Python<'py>,
    path: &Document,
    name: &str,
) -> Result<Bound<'py, PyArray1<f64>>> {
    let all = path.read(py, |document| {
        let mut all = Vec::with_capacity(document.path().points.len());
        for point in document.path().points.iter() {
            all.push(*field(&mut point.orientations[0].clone(), name)?);
        }
        Ok::<_, Failure>(all)
    })?;
    Ok(PyArray1::from_vec(py, all))
}

/// Sets zoom or roll of the first view of each point.
#[pyfunction]
pub(crate) fn set_numbers(
    py: Python<'_>,
    path: &Document,
    name: &str,
    numbers: PyReadonlyArray1<'_, f64>,
) -> Result<()> {
    let numbers = arrays::numbers(&numbers);
    path.write(py, |document| {
        let mut path = document.path().try_clone()?;
        each(&path, numbers.len(), &format!("{name}s"))?;
        for (point, number) in path.points.iter_mut().zip(numbers) {
            let number = if name == "roll" {
                wrap_degrees(number)
            } else {
                number
            };
            *field(&mut point.orientations[0], name)? = number;
        }
        Ok::<_, Failure>(document.apply(replacing(path))?)
    })
}

/// For each section from one point to the next: its point, view and frames, and the frame at which
/// it ends.
fn ways(document: &document::Document) -> Result<Vec<(Fixed, usize)>> {
    let sampler = document.sampler()?;
    let count = document.path().points.len();
    let closed = document.path().closed;
    let ways = document.timeline(|timeline| {
        let sections = timeline.section_count();
        let leads_on = |&number: &usize| {
            let point = timeline.section(number).point;
            match number + 1 < sections {
                true => timeline.section(number + 1).point != point,
                false => closed || point + 1 < count,
            }
        };
        let way = |number| {
            let section = timeline.section(number);
            let fixed = Fixed {
                point: section.point,
                orientation: section.orientation,
                frames: section.frames.try_into().unwrap_or(u32::MAX),
            };
            (fixed, sampler.first_frame(number) - 1 + section.frames)
        };
        (0..sections).filter(leads_on).map(way).collect()
    })?;
    Ok(ways)
}

/// The seconds at which the camera reaches each point; the first is 0.
#[pyfunction]
pub(crate) fn times<'py>(py: Python<'py>, path: &Document) -> Result<Bound<'py, PyArray1<f64>>> {
    let all = path.read(py, |document| {
        let (fps, count) = (document.info().fps, document.path().points.len());
        let ends = ways(document)?.into_iter().map(|(_, end)| end);
        #[expect(clippy::cast_precision_loss)]
        let seconds = ends.map(|end| (end - 1) as f64 / fps);
        Ok::<_, Failure>([0.0].into_iter().chain(seconds).take(count).collect())
    })?;
    Ok(PyArray1::from_vec(py, all))
}

/// Sets the seconds at which the camera reaches each point, to whole frames.
#[pyfunction]
pub(crate) fn set_times(
    py: Python<'_>,
    path: &Document,
    times: PyReadonlyArray1<'_, f64>,
) -> Result<()> {
    let times = arrays::numbers(&times);
    path.write(py, |document| {
        let mut path = document.path().try_clone()?;
        each(&path, times.len(), "times")?;
        let fps = document.info().fps;
        let frame = |at: usize| ((times[at] - times[0]) * fps).round();
        let mut before = 1;
        for (at, (way, end)) in ways(document)?.into_iter().enumerate().take(times.len() - 1) {
            if times[at + 1] <= times[at] {
                let (a, b) = (times[at], times[at + 1]);
                return Err(Failure::argument(format!(
                    "times[{}] is {b}, not after {a}: they must increase",
                    at + 1
                )));
            }
            // What the camera does at the point itself takes the rest.
            #[expect(clippy::cast_precision_loss)]
            let rest = (end - before) as f64 - f64::from(way.frames);
            let frames = frame(at + 1) - frame(at) - rest;
            if frames < 1.0 || way.frames == 0 {
                let (a, b) = (times[at], times[at + 1]);
                return Err(Failure::argument(match way.frames {
                    0 => format!("points {at} and {} are the same: nothing moves", at + 1),
                    _ => format!(
                        "from {a} s to {b} s the camera cannot move from point {at} to {}: it needs \
                         {} frames or more at {fps} a second",
                        at + 1,
                        rest + 1.0
                    ),
                }));
            }
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
            let fixed = Fixed {
                frames: frames as u32,
                ..way
            };
            fixed.apply(&mut path)?;
            before = end;
        }
        Ok(document.apply(replacing(path))?)
    })
}

/// Moves, turns, scales or mirrors all points with what the cameras see, by the rows of a matrix.
/// The space grows if they leave it.
#[pyfunction]
pub(crate) fn transform(py: Python<'_>, path: &Document, rows: [[f64; 4]; 4]) -> Result<()> {
    let matrix = DMat4::from_cols_array_2d(&rows).transpose();
    path.write(py, |document| {
        let edit = Edit::TransformPoints {
            points: (0..document.path().points.len()).collect(),
            matrix,
            with_targets: true,
        };
        let mut moved = document.try_clone()?;
        moved.apply(edit.clone())?;
        let space = Edit::SetSpace {
            space: moved.space_around_all()?,
            fit: false,
        };
        let grows = (moved.points_outside() > 0).then_some(space);
        document.apply_all([edit].into_iter().chain(grows))
    })
}

/// A part of a path, from point `first` to `last`.
#[pyfunction]
pub(crate) fn extract(
    py: Python<'_>,
    path: &Document,
    first: usize,
    last: usize,
) -> Result<Document> {
    path.read(py, |document| {
        let part = extracted(document.path(), first, last)?;
        let made = document::Document::from_parts(part, document.info().clone())?;
        Ok::<_, Failure>(made.into())
    })
}

/// Inserts a path after a point.
#[pyfunction]
pub(crate) fn insert_path(
    py: Python<'_>,
    path: &Document,
    at: usize,
    other: &Document,
    fit: &str,
    with_targets: bool,
) -> Result<()> {
    let known = FITS.iter().find(|known| known.0 == fit);
    let (_, fit) = *known.ok_or_else(|| {
        let names: Vec<_> = FITS.iter().map(|known| format!("{:?}", known.0)).collect();
        Failure::argument(format!("fit is one of {}, not {fit:?}", names.join(", ")))
    })?;
    // Read first: both may be the same.
    let block = other.read(py, |other| other.path().try_clone())?;
    path.write(py, |document| {
        document.apply(Edit::InsertPath {
            at,
            block: Box::new(block),
            fit,
            with_targets,
        })
    })
}
