//! Long computations: other threads run meanwhile, Ctrl-C stops them, and a function of the
//! thread's learns how far they are.

use std::cell::RefCell;
use std::time::{Duration, Instant};

use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use vides::tools::fit::Progress;

use crate::error::Result;

/// How often to check for Ctrl-C.
const SOMETIMES: Duration = Duration::from_millis(20);

/// How often to report progress.
const NOW_AND_THEN: Duration = Duration::from_millis(100);

thread_local! {
    static CALLBACK: RefCell<Option<Py<PyAny>>> = const { RefCell::new(None) };
}

/// Sets the function that this thread's long calls report to, and returns the one before.
#[pyfunction]
pub(crate) fn set_progress(py: Python<'_>, callback: Option<Py<PyAny>>) -> PyResult<Py<PyAny>> {
    if let Some(callback) = &callback
        && !callback.bind(py).is_callable()
    {
        return Err(PyTypeError::new_err("the callback must be a function"));
    }
    let before = CALLBACK.replace(callback);
    Ok(before.unwrap_or_else(|| py.None()))
}

/// Computes without holding the interpreter. An exception from a signal handler, or
/// from the function for progress, stops it.
pub(crate) fn interruptible<R: Send>(
    py: Python<'_>,
    work: impl FnOnce(Progress<'_>) -> Result<R> + Send,
) -> PyResult<R> {
    let mut raised = None;
    let callback = CALLBACK.with_borrow(|callback| Some(callback.as_ref()?.clone_ref(py)));
    let (mut looked, mut told) = (Instant::now(), Instant::now());
    let made = py.detach(|| {
        work(&mut |done, all| {
            if raised.is_none() && looked.elapsed() >= SOMETIMES {
                looked = Instant::now();
                raised = Python::attach(|py| py.check_signals()).err();
            }
            if let Some(callback) = &callback
                && raised.is_none()
                && told.elapsed() >= NOW_AND_THEN
            {
                let share = (done as f64 / all.max(1) as f64).clamp(0.0, 1.0);
                raised = Python::attach(|py| callback.call1(py, (share,))).err();
                told = Instant::now();
            }
            raised.is_none()
        })
    });
    raised.map_or_else(|| Ok(made?), Err)
}
