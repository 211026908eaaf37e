//! What there is, from the tables of the crates.

use pyo3::prelude::*;
use vides::document::tool::{Needs, Tool, tools as all_tools};
use vides::formats::{Format, OPTIONS, formats as all_formats};
use vides::property::Listed;
use vides::tools::Unit;

/// Name, title, endings, whether it is read, whether it is written.
#[pyfunction]
pub(crate) fn formats() -> Vec<(&'static str, &'static str, Vec<&'static str>, bool, bool)> {
    let row = |format: &&Format| {
        (
            format.name,
            format.title,
            format.endings.to_vec(),
            format.reads(),
            format.writes(),
        )
    };
    all_formats().iter().map(row).collect()
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

/// Whether Python has it: the others want a file to write, a line drawn by hand, or poses, for
/// which there is `fit`.
pub(crate) fn usable(tool: &Tool) -> bool {
    matches!(tool.needs(), Needs::Nothing | Needs::Block)
}

#[pyfunction]
pub(crate) fn tools() -> Vec<ToolRow> {
    let rows = all_tools().filter(usable);
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

/// A property: what has it, its key, what it is for, its kind, its unit, its range, and the value of
/// a new one as a file has it.
type Row = (
    &'static str,
    &'static str,
    &'static str,
    String,
    &'static str,
    Option<(f64, f64)>,
    String,
);

/// The properties of paths, points, views and nodes, as the engine's table has them.
#[pyfunction]
pub(crate) fn keys() -> Vec<Row> {
    let row = |listed: Listed| {
        let (owner, key, kind) = (listed.owner.name(), listed.key, listed.kind.to_string());
        let unit = listed.unit.name();
        (
            owner,
            key,
            listed.does,
            kind,
            unit,
            listed.range,
            listed.new,
        )
    };
    vides::properties().into_iter().map(row).collect()
}
