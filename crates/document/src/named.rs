//! Properties by the names of their keys.

use crate::error::{Error, Refused};
use vides_engine::property::Table;

/// The keys of a table.
pub(super) fn keys<T: Table>() -> impl Iterator<Item = &'static str> {
    T::PROPERTIES.iter().flat_map(|row| row.keys).copied()
}

/// The error for an unknown name.
pub(super) fn no_property(name: &str, known: impl Iterator<Item = &'static str>) -> Error {
    let (name, known) = (name.escape_debug(), known.collect::<Vec<_>>().join(", "));
    let (name, known) = ((&name).into(), (&known).into());
    Refused::NoProperty { name, known }.into()
}
