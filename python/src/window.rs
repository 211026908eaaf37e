//! The editor's window, served by a loop in Python (`vides/_window.py`), so that Python waits,
//! handles signals and runs other threads meanwhile.

use std::cell::{Cell, RefCell};
use std::path::PathBuf;
use std::rc::Rc;

use pyo3::prelude::*;
use vides::document;
use vides::path::Pose;
use vides::window::{self, Handle, Host, Id, Options, Reason};

use crate::arrays;
use crate::document::Document;
use crate::error::{Failure, Result};

/// The window's host: calls Python and keeps what it raised.
struct Watching {
    path: Py<Document>,
    on_view: Option<Py<PyAny>>,
    /// The exception that Python raised; it closes the window.
    raised: RefCell<Option<PyErr>>,
    lost: RefCell<Option<String>>,
    open: Cell<bool>,
}

impl Watching {
    /// Copies the window's path to the Python path, and marks it as saved.
    fn follow(&self, window: Id) {
        let shown = window::change(window, |document| {
            document.mark_saved();
            document.shown_path().map(document::Document::into_parts)
        });
        // If memory is short, or a scene has no path, the path is unchanged.
        if let Some(Ok((path, info))) = shown {
            let taken = Python::attach(|py| self.path.get().follow(py, path, info));
            if let Err(failure) = taken {
                *self.lost.borrow_mut() = Some(format!("{failure:?}"));
            }
        }
    }
}

impl Host for Watching {
    fn hand_over(&self, window: Id) {
        self.follow(window);
    }

    fn watches(&self) -> bool {
        true
    }

    fn view(&self, _: Id, pose: &Pose, frame: f64, reason: Reason) {
        let Some(on_view) = &self.on_view else { return };
        if self.raised.borrow().is_some() {
            return;
        }
        let called = Python::attach(|py| {
            let row = arrays::table(py, std::iter::once(arrays::row(pose)));
            on_view.call1(py, (row, frame, word(reason))).map(drop)
        });
        *self.raised.borrow_mut() = called.err();
    }

    fn changed(&self, window: Id) {
        self.follow(window);
    }

    fn lost(&self, why: &str) {
        *self.lost.borrow_mut() = Some(why.to_owned());
    }

    fn closed(&self, _: Id, _: window::Gone) {
        self.open.set(false);
    }
}

const fn word(reason: Reason) -> &'static str {
    match reason {
        Reason::Edited => "edited",
        Reason::Scrubbed => "scrubbed",
        Reason::Played => "played",
        Reason::Selected => "selected",
        Reason::Rested => "rested",
    }
}

/// An open window.
#[pyclass(unsendable, module = "vides._vides")]
pub(crate) struct Window {
    handle: Option<Handle>,
    host: Rc<Watching>,
}

#[pymethods]
impl Window {
    #[new]
    #[pyo3(signature = (path, on_view, file, title))]
    fn new(
        py: Python<'_>,
        path: Py<Document>,
        on_view: Option<Py<PyAny>>,
        file: Option<PathBuf>,
        title: Option<String>,
    ) -> Result<Self> {
        let document = path
            .get()
            .read(py, document::Document::try_clone)?
            .as_opened();
        let host = Rc::new(Watching {
            path,
            on_view,
            raised: RefCell::default(),
            lost: RefCell::default(),
            open: Cell::new(true),
        });
        let mut options = Options::new(document, Rc::clone(&host) as Rc<dyn Host>);
        options.editor.file = file;
        options.editor.title = title;
        Ok(Self {
            handle: Some(window::open(options)?),
            host,
        })
    }

    /// The descriptor to watch.
    fn fileno(&self) -> Result<i32> {
        Ok(window::descriptor()?)
    }

    /// Does what is due. False once the window is closed.
    fn serve(&mut self, py: Python<'_>) -> PyResult<bool> {
        py.detach(window::dispatch);
        if let Some(raised) = self.host.raised.take() {
            self.close();
            return Err(raised);
        }
        if let Some(why) = self.host.lost.take() {
            self.close();
            return Err(Failure::display(&why).into());
        }
        Ok(self.host.open.get() && self.handle.is_some())
    }

    /// Milliseconds until something is due without input.
    fn wait(&self) -> Option<f64> {
        window::wait().map(|wait| wait.as_secs_f64() * 1e3)
    }

    fn close(&mut self) {
        self.handle = None;
    }
}
