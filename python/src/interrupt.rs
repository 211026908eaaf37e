//! Long computations: other threads run meanwhile, and Ctrl-C stops them.

use std::time::{Duration, Instant};

use pyo3::prelude::*;
use vides::tools::fit::Progress;

use crate::error::Result;

/// How often to check for Ctrl-C.
const SOMETIMES: Duration = Duration::from_millis(20);

/// Computes without holding the interpreter. An exception from a signal handler stops it.
pub(crate) fn interruptible<R: Send>(
    py: Python<'_>,
    work: impl FnOnce(Progress<'_>) -> Result<R> + Send,
) -> PyResult<R> {
    let mut raised = None;
    let mut looked = Instant::now();
    let made = py.detach(|| {
        work(&mut |_, _| {
            if raised.is_none() && looked.elapsed() >= SOMETIMES {
                looked = Instant::now();
                raised = Python::attach(|py| py.check_signals()).err();
            }
            raised.is_none()
        })
    });
    raised.map_or_else(|| Ok(made?), Err)
}
