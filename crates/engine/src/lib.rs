//! The engine of VIDES: from the data of a path to every pose on it.
//!
//! [`path`] is the engine itself, [`math`] what it stands on; [`scene`] is
//! everything that moves on one timeline, with paths among its motions, [`deform`]
//! what bends objects and paths, [`tools`] make paths of paths; [`limits`] and
//! [`error`] are everybody's. A crate of its own, so that it is optimised for time
//! where the rest of the library is for room; `vides` shows it under its own name.

pub mod deform;
pub mod error;
#[doc(hidden)]
pub mod inject;
pub mod limits;
pub mod math;
pub mod path;
pub mod scene;
pub mod tools;

pub use error::{Error, Result};
