//! VIDES plans camera paths: a few support points in space, each with one or
//! more camera orientations, become every in-between camera pose.
//!
//! [`path`] is the engine, [`document`] the path being edited and its files,
//! [`math`] what both stand on. `docs/path.md` tells by which rules a path
//! becomes poses.
//!
//! | feature | brings |
//! |---|---|
//! | – | the engine and the document |
//! | `window` | [`window`]: the editor in a window of its own |
//! | `capi` | the functions of `include/libvides.h` |
//! | `cli` | the command `vides` |
//!
//! "The thesis" is W.-D. Groß, *Orts- und Orientierungsinterpolation zur
//! kontrollierten Generierung von Zwischenpositionen für Animationssequenzen*,
//! Jül-2948, 1994.

#[cfg(feature = "capi")]
mod ffi;

pub use glam;
pub use vides_document::{self as document, Error, Result, error};
pub use vides_engine::{deform, limits, math, path, scene, tools};
#[cfg(feature = "window")]
pub use vides_window as window;

#[cfg(feature = "capi")]
use {
    vides_engine::inject,
    vides_window::{self as instance, editor},
};

/// The door of the fuzzer in `fuzz/` to readers that are nobody else's business.
/// There only when the compiler is told `--cfg fuzzing`.
#[cfg(all(fuzzing, feature = "window"))]
pub use vides_window::editor::hostile;
