//! VIDES plans camera paths: a few support points in space, each with one or more camera
//! orientations, become every camera pose in between.
//!
//! [`path`] is the engine, [`document`] the path being edited and its files, [`math`] the basis of
//! both. `docs/theory/path.md` has the rules by which a path becomes poses.
//!
//! | feature | brings |
//! |---|---|
//! | – | the engine and the document |
//! | `formats` | [`formats`]: files of other programs, out and in |
//! | `plot` | [`plot`]: a path as a picture |
//! | `window` | [`window`]: the editor in a window of its own |
//! | `capi` | the functions of `include/libvides.h` |
//! | `cli` | the command `vides` |
//!
//! A path becomes poses:
//!
//! ```
//! use vides::document::{At, Document, Edit};
//! use vides::glam::DVec3;
//! use vides::path::Pose;
//!
//! # fn main() -> vides::Result<()> {
//! // Two points, and a third between them.
//! let mut document = Document::new();
//! let position = DVec3::new(-0.6, 0.2, 0.8);
//! document.apply(Edit::set(At::Point(0), "position", position))?;
//! document.apply(Edit::InsertPoint { at: 1, position: DVec3::new(0.1, 0.5, 0.4) })?;
//!
//! let sampler = document.sampler()?;
//! let mut poses = vec![Pose::default(); sampler.frame_count()];
//! sampler.sample(1, &mut poses)?;
//! assert_eq!(poses[0].vrp, position.to_array());
//!
//! assert!(document.undo());
//! assert_eq!(document.path().points.len(), 2);
//! # Ok(())
//! # }
//! ```
//!
//! With the feature `window` the user plans it, and the program follows the flight
//! (`examples/watch.rs` gives its own camera, too):
//!
#![cfg_attr(feature = "window", doc = "```no_run")]
#![cfg_attr(not(feature = "window"), doc = "```ignore")]
//! use std::rc::Rc;
//!
//! use vides::document::Document;
//! use vides::path::Pose;
//! use vides::window::{self, Host, Id, Options, Reason};
//!
//! struct Picture;
//!
//! impl Host for Picture {
//!     fn watches(&self) -> bool {
//!         true
//!     }
//!
//!     fn view(&self, _: Id, pose: &Pose, frame: f64, reason: Reason) {
//!         println!("frame {frame}: the camera is at {:?} ({reason:?})", pose.vrp);
//!     }
//! }
//!
//! # fn main() -> window::Result<()> {
//! let _window = window::open(Options::new(Document::new(), Rc::new(Picture)))?;
//! window::main_loop()?;
//! # Ok(())
//! # }
//! ```
//!
//! "The thesis" is W.-D. Groß, *Orts- und Orientierungsinterpolation zur
//! kontrollierten Generierung von Zwischenpositionen für Animationssequenzen*,
//! Jül-2948, 1994.

#[cfg(feature = "capi")]
mod ffi;
#[cfg(feature = "plot")]
pub mod plot;

pub use glam;
pub use vides_document::{self as document, Error, Result, error, properties};
pub use vides_engine::{deform, limits, math, path, planner, property, scene, shared_list, tools};
#[cfg(feature = "formats")]
pub use vides_formats as formats;
#[cfg(feature = "window")]
pub use vides_window as window;

#[cfg(feature = "capi")]
use {
    vides_engine::inject,
    vides_window::{self as instance, editor},
};

/// Readers for the fuzzer in `fuzz/`; exists only with `--cfg fuzzing`.
#[cfg(all(fuzzing, feature = "window"))]
pub use vides_window::editor::hostile;
