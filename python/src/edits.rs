//! Edits by name, with their parameters by name.

use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use vides::document::{Document, Edit};
use vides::path::SupportPoint;

use crate::document::upright;
use crate::error::{Failure, Result};

/// A point by its index.
pub(crate) fn point(document: &Document, at: usize) -> Result<&SupportPoint> {
    let points = &document.path().points;
    points.get(at).ok_or_else(|| {
        let last = points.len() - 1;
        vides::Error::from(vides::error::OutOfRange::NoPoint { point: at, last }).into()
    })
}

/// Parameters by name. Each is taken once; any that is left over is an error.
struct Given<'a, 'py> {
    all: Option<&'a Bound<'py, PyDict>>,
    taken: usize,
}

impl Given<'_, '_> {
    fn find<T>(&mut self, name: &str) -> PyResult<Option<T>>
    where
        T: for<'x, 'y> FromPyObject<'x, 'y, Error = PyErr>,
    {
        let Some(all) = self.all else { return Ok(None) };
        match all.get_item(name)? {
            Some(value) => {
                self.taken += 1;
                Ok(Some(value.extract::<T>()?))
            }
            None => Ok(None),
        }
    }

    fn take<T>(&mut self, name: &str) -> PyResult<T>
    where
        T: for<'x, 'y> FromPyObject<'x, 'y, Error = PyErr>,
    {
        self.find(name)?
            .ok_or_else(|| PyTypeError::new_err(format!("{name} is missing")))
    }
}

/// The edit with this name.
pub(crate) fn by_name(name: &str, given: Option<&Bound<'_, PyDict>>) -> PyResult<Edit> {
    let mut given = Given {
        all: given,
        taken: 0,
    };
    let edit = match name {
        "insert_point" => Edit::InsertPoint {
            at: given.take("at")?,
            position: given.take::<[f64; 3]>("position")?.into(),
        },
        "append" => Edit::AppendAfterLast,
        "prepend" => Edit::PrependBeforeFirst,
        "divide" => Edit::DivideSegment {
            segment: given.take("segment")?,
            points: given.take("points")?,
        },
        "insert_on_curve" => Edit::InsertOnCurve {
            frame: given.take("frame")?,
        },
        "fit_frames" => Edit::FitFrames {
            first: given.take("first")?,
            last: given.take("last")?,
            frames: given.take("frames")?,
        },
        "remove_point" => Edit::RemovePoint {
            at: given.take("at")?,
        },
        "move_point" => Edit::MovePoint {
            from: given.take("source")?,
            to: given.take("to")?,
        },
        "insert_orientation" => Edit::InsertOrientation {
            point: given.take("point")?,
            at: given.take("at")?,
            orientation: None,
        },
        "remove_orientation" => Edit::RemoveOrientation {
            point: given.take("point")?,
            at: given.take("at")?,
        },
        "set_absolute" => Edit::SetAbsolute {
            point: given.take("point")?,
            at: given.take("at")?,
            absolute: given.take("absolute")?,
        },
        "change_up" => Edit::ChangeUp(upright(&given.take::<String>("up")?)?),
        "reverse" => Edit::Reverse,
        _ => return Err(Failure::argument(format!("there is no edit {name:?}")).into()),
    };
    if given.all.is_some_and(|all| all.len() > given.taken) {
        return Err(PyTypeError::new_err(format!(
            "{name} has too many arguments"
        )));
    }
    Ok(edit)
}
