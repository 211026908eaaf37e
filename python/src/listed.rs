//! Lists from the tables of the crates.

use pyo3::prelude::*;
use vides::formats::{Format, OPTIONS, formats as all_formats};
use vides::property::Listed;

/// Name, title, extensions, whether it can be read, whether it can be written.
#[pyfunction]
pub(crate) fn formats() -> Vec<(&'static str, &'static str, Vec<&'static str>, bool, bool)> {
    let row = |format: &&Format| {
        (
            format.name,
            format.title,
            format.all_endings().collect(),
            format.reads(),
            format.writes(),
        )
    };
    all_formats().iter().map(row).collect()
}

/// Name, placeholder of the value, description.
#[pyfunction]
pub(crate) fn options() -> Vec<(&'static str, &'static str, &'static str)> {
    OPTIONS
        .iter()
        .map(|row| (row.name, row.value, row.help))
        .collect()
}

/// A property: owner, key, description, type, unit, range, and the default as in files.
type Row = (
    &'static str,
    &'static str,
    &'static str,
    String,
    &'static str,
    Option<(f64, f64)>,
    String,
);

/// The properties of paths, points, views and nodes, from the engine's table.
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
