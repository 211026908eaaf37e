//! How a path is flown, planned instead of given (`docs/reference/planning.md`).
//!
//! [`retime()`] recomputes the pace within limits. `course` measures what the curve and the views
//! ask of the pace, `reach` finds how fast it may be anywhere, `frames` gives each section a whole
//! number of frames, `track` few keys of a given distance. [`avoid()`] leads the way clear of an
//! object, [`keep_in_picture()`] keeps one whole in the picture, [`tour()`] makes a flight that shows
//! one, [`steady()`] stabilises a recorded flight. Limits are those of a
//! check ([`crate::tools::check::Limits`]), by `half_size`, in degrees, millimetres and seconds.

pub mod avoid;
mod course;
mod directions;
mod frames;
pub mod picture;
mod reach;
pub mod retime;
mod smooth;
pub mod steady;
pub mod tour;
mod track;

pub use avoid::{AvoidRequest, Avoided, AvoidedPart, avoid, avoid_object};
pub use picture::{
    DEFAULT_MARGIN, Framed, PictureRequest, What, keep_all_in_picture, keep_in_picture,
};
pub use retime::{Request, Rest, Retimed, retime};
pub use steady::{Steadied, SteadyRequest, steady};
pub use tour::{Tour, TourRequest, tour};

#[cfg(test)]
mod soup_tests;
