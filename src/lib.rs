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
pub mod window;

mod editor;
mod ffi;
mod inject;
mod instance;
mod x11;

pub use vides_engine::{Error, Result, deform, error, limits, math, path, scene};
use vides_raster as raster;

/// The door of the fuzzer in `fuzz/` to readers that are nobody else's business;
/// see `editor::hostile`. There only when the compiler is told `--cfg fuzzing`.
#[cfg(fuzzing)]
pub mod hostile {
    use std::path::Path;

    /// Checks bytes as a setup file, in a folder for this alone.
    pub fn setup(folder: &Path, bytes: &[u8]) {
        crate::editor::hostile::setup(folder, bytes);
    }

    /// Checks bytes as a recovery file, in a folder for this alone.
    pub fn recovery(folder: &Path, bytes: &[u8]) {
        crate::editor::hostile::recovery(folder, bytes);
    }
}
