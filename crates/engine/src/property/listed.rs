//! The rows of all tables in one list, for programs that show or set properties by name.

use super::table::{Affects, Table, Unit, choices};
use super::value::Kind;

choices! {
    /// What has a property.
    pub enum Owner {
        /// The whole path.
        #[default]
        Path = "path",
        /// A support point.
        Point = "point",
        /// An orientation of a support point.
        View = "view",
        /// A node of a scene.
        Node = "node",
    }
}

/// What is known of one key.
#[derive(Clone, Debug, PartialEq)]
pub struct Listed {
    /// The owner.
    pub owner: Owner,
    /// Its key in files.
    pub key: &'static str,
    /// What it is.
    pub kind: Kind,
    /// What its numbers count.
    pub unit: Unit,
    /// The least and the greatest number, if they do not depend on the space.
    pub range: Option<(f64, f64)>,
    /// What a new one has, as in a file; empty if nothing is set.
    pub new: String,
    /// What is recomputed where it changes.
    pub affects: Affects,
    /// Whether a copy elsewhere keeps it.
    pub copied: bool,
    /// What it is for.
    pub does: &'static str,
}

/// Adds the rows of a table to a list, a key each; `new` is a new one.
pub fn list<T: Table>(owner: Owner, new: &T, into: &mut Vec<Listed>) {
    for row in T::PROPERTIES {
        for (&key, &kind) in row.keys.iter().zip(row.kinds) {
            let value = (row.value)(new);
            into.push(Listed {
                owner,
                key,
                kind,
                unit: row.unit,
                range: row
                    .range
                    .filter(|_| matches!(kind, Kind::Number | Kind::Whole)),
                new: if kind.has(&value) {
                    value.to_string()
                } else {
                    String::new()
                },
                affects: row.affects,
                copied: row.copied[0],
                does: row.does.trim(),
            });
        }
    }
}
