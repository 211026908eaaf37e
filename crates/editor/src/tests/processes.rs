//! Processes that tests start, and folders whose locks they must not take along.

use std::ops::Deref;
use std::process::{Child, Command};
use std::sync::{Mutex, MutexGuard, PoisonError};

use super::until;

/// How many tests have a folder with locks.
static HOLD: Mutex<usize> = Mutex::new(0);

fn hold() -> MutexGuard<'static, usize> {
    HOLD.lock().unwrap_or_else(PoisonError::into_inner)
}

/// A folder for unsaved work. Until a process that is started is a program of its own it has
/// all that this one has open, locks too: while there is such a folder, none is [`started`].
pub(crate) struct WorkFolder(tempfile::TempDir);

pub(crate) fn work_folder() -> WorkFolder {
    *hold() += 1;
    WorkFolder(tempfile::tempdir().unwrap())
}

impl Deref for WorkFolder {
    type Target = tempfile::TempDir;

    fn deref(&self) -> &Self::Target {
        &self.0
    }
}

impl Drop for WorkFolder {
    fn drop(&mut self) {
        *hold() -= 1;
    }
}

/// Starts a process, as soon as nobody has a [`WorkFolder`].
pub(crate) fn started(command: &mut Command) -> Child {
    until("the locks of other tests", || {
        let held = hold();
        (*held == 0).then(|| command.spawn().unwrap())
    })
}
