//! VIDES plans camera paths: a few support points in space, each with one or
//! more camera orientations, become every in-between camera pose.
//!
//! [`path`] is the engine, [`document`] the path being edited and its files,
//! [`math`] what both stand on. `ffi` is the border to C; its header is
//! `include/libvides.h`. `ARCHITECTURE.md` draws the arrows between them.

pub mod document;
pub mod error;
pub mod limits;
pub mod math;
pub mod path;

mod ffi;

pub use error::{Error, Result};
