//! Edits and tools by name, with their parameters by name.

use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use vides::document::tool::{ToolInput, tools};
use vides::document::{Document, Edit};
use vides::path::{CameraPath, SupportPoint};
use vides::tools::Unit;
use vides::tools::fit::Progress;

use crate::document::upright;
use crate::error::{Failure, Result};
use crate::listed::usable;

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
        "repeat" => Edit::Repeat(given.take("times")?),
        _ => return Err(Failure::argument(format!("there is no edit {name:?}")).into()),
    };
    if given.all.is_some_and(|all| all.len() > given.taken) {
        return Err(PyTypeError::new_err(format!(
            "{name} has too many arguments"
        )));
    }
    Ok(edit)
}

/// The parameters of a tool by name: numbers, or one of several choices.
pub(crate) type Numbers = Vec<(String, Chosen)>;

pub(crate) enum Chosen {
    Numbers(Vec<f64>),
    Name(String),
}

pub(crate) fn tool_numbers(given: &Bound<'_, PyDict>) -> PyResult<Numbers> {
    let one = |(name, value): (Bound<'_, PyAny>, Bound<'_, PyAny>)| {
        let name = name.extract::<String>()?.replace('_', "-");
        let chosen = if let Ok(number) = value.extract::<f64>() {
            Chosen::Numbers(vec![number])
        } else if let Ok(text) = value.extract::<String>() {
            Chosen::Name(text)
        } else {
            let wrong = |_| PyTypeError::new_err(format!("{name} takes numbers or a name"));
            Chosen::Numbers(value.extract().map_err(wrong)?)
        };
        Ok((name, chosen))
    };
    given.iter().map(one).collect()
}

/// The edit that a tool makes; parameters that are not given have their defaults.
pub(crate) fn tool(
    document: &Document,
    name: &str,
    given: &Numbers,
    block: Option<CameraPath>,
    go_on: Progress<'_>,
) -> Result<Edit> {
    let Some(tool) = tools().find(|tool| tool.name == name) else {
        let names: Vec<_> = tools().filter(usable).map(|tool| tool.name).collect();
        let names = names.join(", ");
        return Err(Failure::argument(format!(
            "there is no tool {name:?}; tools are {names}"
        )));
    };
    let mut numbers = tool.defaults(document)?;
    for (name, chosen) in given {
        let parameter = tool.parameters().find(|parameter| parameter.name == name);
        let (Some(parameter), Some(place)) = (parameter, tool.place_of(name)) else {
            let names: Vec<_> = tool
                .parameters()
                .map(|known| match known.name {
                    "from" => "from_".to_owned(),
                    name => name.replace('-', "_"),
                })
                .collect();
            return Err(Failure::argument(format!(
                "{} takes no {}; it takes {}",
                tool.name,
                name.replace('-', "_"),
                names.join(", ")
            )));
        };
        let wanted = match (chosen, parameter.unit) {
            (Chosen::Name(text), Unit::Choice(names)) => {
                let at = names.iter().position(|name| name == text);
                let at = at.ok_or_else(|| {
                    Failure::argument(format!(
                        "{name} is one of {}, not {text:?}",
                        names.join(", ")
                    ))
                })?;
                vec![at as f64]
            }
            (Chosen::Name(_), _) => return Err(Failure::argument(format!("{name} takes numbers"))),
            (Chosen::Numbers(numbers), _) => numbers.clone(),
        };
        let room = numbers.get_mut(place..place + parameter.width);
        let Some(room) = room.filter(|room| room.len() == wanted.len()) else {
            return Err(Failure::argument(format!(
                "{name} takes {} numbers, not {}",
                parameter.width,
                wanted.len()
            )));
        };
        room.copy_from_slice(&wanted);
    }
    let material = block.map_or(ToolInput::None, |block| ToolInput::Block(Box::new(block)));
    let edit = tool.edit(document, &material, &numbers, go_on)?.edit;
    edit.ok_or_else(|| {
        Failure::argument(format!(
            "{} needs another path, or is not for Python",
            tool.name
        ))
    })
}
