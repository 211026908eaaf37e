//! Tools: what makes a path, or another path of one, in one step (`docs/reference/tools.md`).
//!
//! Each is a function of plain data, so that the document's edits, the C interface, the command and
//! the window are thin callers. What a tool asks for stands in one table of [`Parameter`]s, from
//! which those make their fields, options and comments. It knows nothing of undo, files or windows.

mod backwards;
pub mod blend;
pub mod block;
pub mod check;
pub mod clearance;
pub mod enclosure;
pub mod fit;
pub(crate) mod keep;
pub(crate) mod kinds;
mod limits;
pub mod moves;
mod numbers;
pub mod parameter;
pub mod profile;
pub mod redundant;
pub(crate) mod smooth;
pub mod transform;
pub(crate) mod watch;

pub use parameter::{Parameter, Unit};

#[cfg(test)]
mod space_tests;
