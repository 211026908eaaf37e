//! VIDES plans camera paths: a few support points in space, each with one or
//! more camera orientations, become every in-between camera pose.
//!
//! [`path`] is the engine, [`document`] the path being edited and its files,
//! [`math`] what both stand on. `editor` is the window's contents, `raster`
//! and `x11` bring them to a screen, `instance` joins the three under the
//! host's event loop; [`window`] opens one from Rust. `ffi` is the border to C;
//! its header is `include/libvides.h`. `ARCHITECTURE.md` draws the arrows
//! between them, `docs/path.md` tells the rules by which a path becomes poses.
//!
//! "The thesis" is W.-D. Groß, *Orts- und Orientierungsinterpolation zur
//! kontrollierten Generierung von Zwischenpositionen für Animationssequenzen*,
//! Jül-2948, 1994.

pub mod document;
pub mod error;
pub mod limits;
pub mod math;
pub mod path;
pub mod window;

mod editor;
mod ffi;
mod instance;
mod raster;
mod x11;

pub use error::{Error, Result};
