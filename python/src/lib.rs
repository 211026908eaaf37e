//! `vides._vides`: what the Python package `vides` (`vides/*.py`) is made on. Numbers, arrays and
//! texts go through here; names, defaults and documentation are Python's.
//!
//! A path and a scene are behind a lock, and are waited for and computed with while the interpreter
//! is free: so threads may share them, and none waits for the interpreter while it holds one.

mod arrays;
mod document;
mod edits;
mod error;
mod files;
mod interrupt;
mod listed;
mod planning;
mod scene;
mod values;
mod window;

use pyo3::prelude::*;

/// The engine beneath `vides`; not for direct use.
#[pymodule]
mod _vides {
    #[pymodule_export]
    use super::arrays::{poses_of, quaternions};
    #[pymodule_export]
    use super::document::Document;
    #[pymodule_export]
    use super::files::{convert, fit, recording};
    #[pymodule_export]
    use super::listed::{formats, keys, options, tools};
    #[pymodule_export]
    use super::planning::tour;
    #[pymodule_export]
    use super::scene::Scene;
    #[pymodule_export]
    use super::window::Window;
}
