//! One instance for each open window: the editor, its X window and its pixels,
//! joined and run under whatever event loop the host has.
//!
//! The windows belong to the thread that opened them; so do all calls here. A
//! window is taken out of the table while it works, and host code is called
//! only when nothing is borrowed: a callback may call anything.
//!
//! It knows nothing of C: what the host is told goes through [`Host`].

use std::rc::Rc;

use crate::editor;
use crate::error::{Error, Result};
use crate::path::Sampler;

/// What a window's owner does. Its methods run on the window's thread; those
/// that call host code run while nothing of ours is borrowed.
pub(crate) trait Host {
    /// Makes the poses ready for the host while the window is at work, and
    /// gives back what calls the host, to be run later. Calls no host code.
    ///
    /// # Errors
    /// Shown in the window.
    fn prepare(&self, window: Id, sampler: &Sampler) -> Result<Box<dyn FnOnce()>>;

    /// Asks the host whether the window may close.
    fn may_close(&self, window: Id) -> bool;

    /// The window is gone: closed by the user, or its X server went away.
    fn closed(&self, window: Id);
}

/// A window of this thread. Never used again for another.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct Id(u64);

/// How a window is opened.
pub(crate) struct Options {
    /// What it shows.
    pub(crate) editor: editor::Options,
    /// The X display's name; the environment's if none.
    pub(crate) display: Option<String>,
    /// A sentence that stands in the output field at first: what was wrong
    /// with the host's arguments.
    pub(crate) warning: Option<String>,
    /// Its owner.
    pub(crate) host: Rc<dyn Host>,
}

/// Opens a window, and returns before anything is drawn.
///
/// # Errors
/// [`Error::Display`] if there is no X server, [`Error::Memory`].
pub(crate) fn open(options: Options) -> Result<Id> {
    let _ = (options.editor, options.display, options.warning);
    drop(options.host);
    Err(Error::Display(
        "this version of the library opens no window".into(),
    ))
}
