//! `vides._vides`: the native part of the Python package `vides` (`vides/*.py`). It passes numbers,
//! arrays and texts; names, defaults and documentation are in Python.
//!
//! Each path and scene has a lock. Waiting for a lock and computing under it release the
//! interpreter, so threads may share paths and scenes without a deadlock.

mod arrays;
mod document;
mod edits;
mod error;
mod files;
mod interrupt;
mod listed;
mod planning;
mod scene;
mod several;
mod tools;
mod values;
mod window;

use pyo3::prelude::*;

/// The native part of `vides`; not for direct use.
#[pymodule]
mod _vides {
    #[pymodule_export]
    use super::arrays::{matrices, poses_of, quaternions};
    #[pymodule_export]
    use super::document::Document;
    #[pymodule_export]
    use super::files::{convert, fit, recording, save_poses};
    #[pymodule_export]
    use super::interrupt::set_progress;
    #[pymodule_export]
    use super::listed::{formats, keys, options};
    #[pymodule_export]
    use super::planning::tour;
    #[pymodule_export]
    use super::scene::Scene;
    #[pymodule_export]
    use super::several::{
        extract, insert_path, look_at, numbers, set_numbers, set_positions, set_times, times,
        transform,
    };
    #[pymodule_export]
    use super::tools::{apply, made, tools};
    #[pymodule_export]
    use super::window::Window;
}
