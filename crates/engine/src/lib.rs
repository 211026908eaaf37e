//! The engine of VIDES: from the data of a path to every pose on it.
//!
//! [`path`] is the engine itself, [`math`] what it stands on; [`property`] its table of fields;
//! [`shared_list`] the lists whose copies share their elements; [`scene`] is everything that moves
//! on one timeline, [`deform`] deforms objects and paths, [`tools`] make paths of paths,
//! [`planner`] plans how they are flown. It is a separate crate so that it is optimised for speed,
//! while the rest of the library is for size.

// Standard output is the host's.
#![cfg_attr(not(test), warn(clippy::print_stdout))]

pub mod deform;
pub mod descriptor;
pub mod error;
#[doc(hidden)]
pub mod inject;
pub mod limits;

pub mod math;
pub mod path;
pub mod planner;
pub mod property;
pub mod scene;
pub mod shared_list;
pub mod tools;

pub use error::{Error, Result};
