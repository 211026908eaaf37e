//! A field is one row. [`properties!`](crate::property::properties) declares a struct and, with
//! each field, its row: what a file calls it, what its numbers count, which are allowed, what it
//! affects, and what becomes of it in a copy. Range checks, equality bit by bit, edits, copies, the
//! keys of `.vid` files with their sentences, `vides set` and the tables of the documents come of
//! the rows; a field without one does not compile.
//!
//! A structure that files write in a special way is nested: its row has no key.

mod listed;
#[doc(hidden)]
pub mod named;
#[doc(hidden)]
pub mod same_bits;
#[doc(hidden)]
pub mod table;
#[doc(hidden)]
pub mod value;

pub use listed::{Listed, Owner, list};
pub use same_bits::SameBits;
pub use table::{
    Affects, Check, Copied, Property, Row, Stored, Table, Unit, choices, find, properties,
};
pub use value::{Kind, Quoted, Value, steers};

#[cfg(test)]
#[path = "property_tests.rs"]
mod tests;
