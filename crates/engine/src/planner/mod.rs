//! How a path is flown, planned instead of given (`docs/planning.md`).
//!
//! [`retime()`] computes the pace anew within limits. `course` measures what the curve and the views
//! ask of the pace, `reach` finds how fast it may be anywhere, `frames` gives each section a whole
//! number of frames, `track` few keys of a given distance. Limits are those of a check
//! ([`crate::tools::check::Limits`]), in half sizes, degrees, millimetres and seconds.

mod course;
mod frames;
mod reach;
pub mod retime;
mod smooth;
mod track;

pub use retime::{Request, Rest, Retimed, retime};
