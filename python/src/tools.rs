//! The tools of the table, by name, with their parameters by name.

use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use vides::document::tool::{Needs, Tool, ToolInput, moved, tools as all_tools};
use vides::document::{self, Info};
use vides::path::{CameraPath, Space};
use vides::tools::moves::Move;
use vides::tools::{Parameter, Unit};

use crate::document::{Document, upright};
use crate::error::{Failure, Result};
use crate::planning::Given;

/// Name, description, the names of choices, whether it is a switch, its unit, the number of its
/// values, and the default of each.
type ParameterRow = (
    String,
    &'static str,
    Vec<&'static str>,
    bool,
    &'static str,
    usize,
    f64,
);

/// Name, description, whether it is a move, whether it takes another path, its parameters.
type ToolRow = (&'static str, &'static str, bool, bool, Vec<ParameterRow>);

fn row(known: &Parameter) -> ParameterRow {
    let choices = match known.unit {
        Unit::Choice(names) => names.to_vec(),
        _ => Vec::new(),
    };
    let unit = match known.unit {
        Unit::Length => "lengths",
        Unit::Count => "count",
        unit => unit.name(),
    };
    (
        known.name.replace('-', "_"),
        known.does,
        choices,
        known.unit == Unit::Switch,
        unit,
        known.width,
        known.default,
    )
}

/// All tools of the table.
#[pyfunction]
pub(crate) fn tools() -> Vec<ToolRow> {
    let rows = all_tools().map(|tool| {
        (
            tool.name,
            tool.does,
            tool.is_move(),
            tool.needs() == Needs::Block,
            tool.parameters().map(row).collect(),
        )
    });
    rows.collect()
}

/// The parameters of a tool by name: numbers, or one of several choices.
type Numbers = Vec<(String, Chosen)>;

enum Chosen {
    Numbers(Vec<f64>),
    Name(String),
}

fn given_numbers(given: &Bound<'_, PyDict>) -> PyResult<Numbers> {
    let one = |(name, value): (Bound<'_, PyAny>, Bound<'_, PyAny>)| {
        let name = name.extract::<String>()?;
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

/// Puts what is given into a tool's numbers.
fn put(
    numbers: &mut [f64],
    parameters: impl Iterator<Item = &'static Parameter>,
    given: &Numbers,
) -> Result<()> {
    let mut start = 0;
    let mut found = 0;
    for parameter in parameters {
        let room = &mut numbers[start..start + parameter.width];
        start += parameter.width;
        let name = parameter.name.replace('-', "_");
        let Some((_, chosen)) = given.iter().find(|given| given.0 == name) else {
            continue;
        };
        found += 1;
        match (chosen, parameter.unit) {
            (Chosen::Name(text), Unit::Choice(names)) => {
                let at = names.iter().position(|name| name == text);
                let at = at.ok_or_else(|| {
                    let names: Vec<_> = names.iter().map(|name| format!("{name:?}")).collect();
                    let names = names.join(", ");
                    Failure::argument(format!("{name} is one of {names}, not {text:?}"))
                })?;
                room[0] = at as f64;
            }
            (Chosen::Name(_), _) => {
                return Err(Failure::argument(format!("{name} takes numbers")));
            }
            (Chosen::Numbers(wanted), _) if wanted.len() == room.len() => {
                room.copy_from_slice(wanted);
            }
            (Chosen::Numbers(wanted), _) => {
                let (width, given) = (parameter.width, wanted.len());
                return Err(Failure::argument(format!(
                    "{name} takes {width} numbers, not {given}"
                )));
            }
        }
    }
    match found == given.len() {
        true => Ok(()),
        false => Err(Failure::argument("there is no such parameter")),
    }
}

/// Applies a tool that is no move; parameters that are not given have their defaults.
#[pyfunction]
#[pyo3(signature = (path, name, given, other=None))]
pub(crate) fn apply(
    py: Python<'_>,
    path: &Document,
    name: &str,
    given: &Bound<'_, PyDict>,
    other: Option<&Document>,
) -> PyResult<()> {
    let given = given_numbers(given)?;
    let found = all_tools().find(|tool: &Tool| tool.name == name && !tool.is_move());
    let tool = found.ok_or_else(|| Failure::argument(format!("there is no tool {name:?}")))?;
    let input = match other {
        Some(other) => {
            let other = other.read(py, |other| other.path().try_clone())?;
            ToolInput::Block(Box::new(other))
        }
        None => ToolInput::None,
    };
    path.planned(py, |document, go_on| {
        let mut numbers = tool.defaults(document)?;
        put(&mut numbers, tool.parameters(), &given)?;
        let edit = tool.edit(document, &input, &numbers, go_on)?.edit;
        let edit = edit.ok_or_else(|| Failure::argument(format!("{name} needs another path")))?;
        Ok((edit, ()))
    })
}

/// A path by a ready-made move, around an object if there is one.
#[pyfunction]
#[pyo3(signature = (name, given, object, up, fps))]
pub(crate) fn made(
    py: Python<'_>,
    name: &str,
    given: &Bound<'_, PyDict>,
    object: Option<Given<'_>>,
    up: Option<&str>,
    fps: f64,
) -> PyResult<Document> {
    let given = given_numbers(given)?;
    let up = up.map(upright).transpose()?;
    let source = object.map(Given::source).transpose()?;
    let made = py.detach(|| {
        let around =
            source.map(|source| -> Result<_> { Ok(document::Document::around(source.object()?)?) });
        let (path, info) = match around.transpose()? {
            Some(document) => document.into_parts(),
            None => (CameraPath::try_new()?, Info::default()),
        };
        let chosen = Move::named(name)?;
        let space = Space {
            up: up.unwrap_or(path.space.up),
            ..path.space
        };
        moved(chosen, space, &Info { fps, ..info }, true, |numbers| {
            put(numbers, chosen.parameters.iter(), &given)
        })
    })?;
    Ok(made.into())
}
