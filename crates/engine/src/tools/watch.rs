//! Whether work that takes long goes on. It is asked by time, whatever a step of the work costs: a
//! question to a large object of overlapping triangles may take as long as a thousand others.

use std::cell::{Cell, RefCell};
use std::time::{Duration, Instant};

use super::fit::Progress;
use crate::error::{Invalid, Result};

/// The least time between two questions.
const PAUSE: Duration = Duration::from_millis(20);

/// A progress that many parts of a work share. Once it has said no, the answers of those who ask
/// [`Watch::goes_on`] no longer count: the caller ends with [`Watch::check`].
pub(crate) struct Watch<'a> {
    progress: RefCell<Progress<'a>>,
    done: Cell<usize>,
    all: Cell<usize>,
    asked: Cell<Instant>,
    stopped: Cell<bool>,
}

impl<'a> Watch<'a> {
    pub(crate) fn new(progress: Progress<'a>) -> Self {
        Self {
            progress: RefCell::new(progress),
            done: Cell::new(0),
            all: Cell::new(1),
            asked: Cell::new(Instant::now()),
            stopped: Cell::new(false),
        }
    }

    /// Reports the progress.
    pub(crate) fn at(&self, done: usize, all: usize) -> Result<()> {
        self.done.set(done);
        self.all.set(all);
        self.ask();
        self.check()
    }

    /// Whether it goes on; asks now and then.
    pub(crate) fn goes_on(&self) -> bool {
        if !self.stopped.get() && self.asked.get().elapsed() >= PAUSE {
            self.ask();
        }
        !self.stopped.get()
    }

    /// Ends the work if it does not go on.
    pub(crate) fn check(&self) -> Result<()> {
        if self.goes_on() {
            return Ok(());
        }
        Err(Invalid::Cancelled.into())
    }

    fn ask(&self) {
        if !self.stopped.get() {
            let mut progress = self.progress.borrow_mut();
            self.stopped.set(!progress(self.done.get(), self.all.get()));
            self.asked.set(Instant::now());
        }
    }
}
