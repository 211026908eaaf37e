//! What there is, from the tables of the crates.

use pyo3::prelude::*;
use vides::document::tool::{Needs, tools as all_tools};
use vides::formats::{OPTIONS, formats as all_formats};
use vides::path::{Orientation, OrientationOverrides};
use vides::property::Property;
use vides::tools::Unit;

/// Name, title, endings, whether it is read, whether it is written.
#[pyfunction]
pub(crate) fn formats() -> Vec<(&'static str, &'static str, Vec<&'static str>, bool, bool)> {
    let rows = all_formats().iter().map(|format| format.row());
    rows.map(|row| {
        (
            row.name,
            row.title,
            row.endings.to_vec(),
            row.reads,
            row.writes,
        )
    })
    .collect()
}

/// Name, what stands for the value, what it does.
#[pyfunction]
pub(crate) fn options() -> Vec<(&'static str, &'static str, &'static str)> {
    OPTIONS
        .iter()
        .map(|row| (row.name, row.value, row.help))
        .collect()
}

/// Name, what it does, whether it wants another path, and its parameters: name, what it does, unit
/// or choices, how many numbers.
type ToolRow = (
    &'static str,
    &'static str,
    bool,
    Vec<(String, &'static str, String, usize)>,
);

#[pyfunction]
pub(crate) fn tools() -> Vec<ToolRow> {
    // The others want a file to write, a line drawn by hand, or poses, for which there is `fit`.
    let usable = |needs| matches!(needs, Needs::Nothing | Needs::Block);
    let rows = all_tools().filter(|tool| usable(tool.needs()));
    rows.map(|tool| {
        let parameters = tool.parameters().map(|known| {
            let unit = match known.unit {
                Unit::Choice(names) => names.join(" | "),
                unit => unit.name().to_owned(),
            };
            (known.name.replace('-', "_"), known.does, unit, known.width)
        });
        (
            tool.name,
            tool.does,
            tool.needs() == Needs::Block,
            parameters.collect(),
        )
    })
    .collect()
}

/// A property: its key, what it is for, its kind, its unit, and its range.
type Row = (
    &'static str,
    &'static str,
    String,
    &'static str,
    Option<(f64, f64)>,
);

fn rows<T>(table: &'static [Property<T>]) -> impl Iterator<Item = Row> {
    table.iter().flat_map(|row| {
        let one = |key: &&'static str| {
            (
                *key,
                row.does.trim(),
                row.kind.to_string(),
                row.unit.name(),
                row.range,
            )
        };
        row.keys.iter().map(one)
    })
}

/// The properties of an orientation, as the engine's table has them.
#[pyfunction]
pub(crate) fn keys() -> Vec<Row> {
    rows(Orientation::PROPERTIES)
        .chain(rows(OrientationOverrides::PROPERTIES))
        .collect()
}
