//! One instance for each open window: the editor, its X window and its pixels,
//! joined and run under whatever event loop the host has.
//!
//! The windows belong to the thread that opened them; so do all calls here. A
//! window is taken out of the table while it works, and host code is called
//! only when nothing is borrowed: a callback may call anything.
//!
//! It knows nothing of C: what the host is told goes through [`Host`].

mod descriptors;
mod edit;
mod ending;
mod error;
mod hint;
mod live;
mod lookout;
mod program;
mod pump;
mod registry;
mod screen;
#[cfg(test)]
mod tests;
mod thread_end;
mod window;
mod xt;
mod xt_wake;

use std::ffi::c_void;
use std::io;
use std::os::fd::RawFd;
use std::path::Path;
use std::rc::Rc;
use std::sync::OnceLock;
use std::time::Duration;

use vides_document as document;
pub use vides_editor as editor;
use vides_engine::{inject, path};
use vides_raster as raster;
use vides_x11 as x11;

use crate::document::{Document, Poses};
use crate::editor::{Editor, Warnings};
use crate::path::Pose;

pub use edit::edit;
pub use editor::Reason;
pub use error::{Error, Result};
pub use program::{host_program, own_program};
pub use pump::{close_all, dispatch, main_loop};
pub use registry::{Lost, is_open, within_a_call};
pub use xt::{Refusal, own_thread};

/// What a window's owner does. Its methods run on the window's thread; those
/// that call host code run while nothing of ours is borrowed.
pub trait Host {
    /// Makes the poses ready for a host that takes some, while the window is at
    /// work. Calls no host code.
    ///
    /// # Errors
    /// Shown in the window; what the host has is as it was.
    fn prepare(&self, window: Id, poses: &Poses<'_>) -> document::Result<()> {
        let _ = (window, poses);
        Ok(())
    }

    /// Calls the host with the poses that were made ready last.
    fn hand_over(&self, window: Id) {
        let _ = window;
    }

    /// Asks the host whether the window may close.
    fn may_close(&self, window: Id) -> bool {
        let _ = window;
        true
    }

    /// Whether [`Host::view`], [`Host::frame`] and [`Host::changed`] are to be called at all.
    fn watches(&self) -> bool {
        false
    }

    /// Calls the host with the camera at the playhead, at a frame from 1, after that
    /// has changed: at most once for each picture of the window.
    fn view(&self, window: Id, pose: &Pose, frame: f64, reason: Reason) {
        let _ = (window, pose, frame, reason);
    }

    /// Calls the host with the frame of the scene at the playhead after that or the scene has
    /// changed, for one that draws the scene itself: at most once for each picture.
    fn frame(&self, window: Id, frame: f64, reason: Reason) {
        let _ = (window, frame, reason);
    }

    /// Calls the host after each step that has changed the path or the scene, undo and redo too;
    /// not while a drag goes on.
    fn changed(&self, window: Id) {
        let _ = window;
    }

    /// Asks the host for its own camera, which the user wants to take over; vectors
    /// of any length. `None`: it has none.
    fn capture(&self, window: Id) -> Option<Pose> {
        let _ = window;
        None
    }

    /// Calls the host when the camera pane opened or changed its size, in pixels:
    /// an X window for it to draw in. 0: the pane closed.
    fn pane(&self, window: Id, pane: u32, size: [u32; 2]) {
        let _ = (window, pane, size);
    }

    /// A window is about to be gone for this reason, which nobody was told yet.
    /// Calls no host code.
    fn lost(&self, why: &str) {
        error::complain(why);
    }

    /// The window is gone, and its owner has not closed it. Calls no host code.
    fn closed(&self, window: Id, why: Gone) {
        let _ = (window, why);
    }
}

/// Why a window is gone that its owner has not closed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Gone {
    /// Its user has closed it.
    ByUser,
    /// Its X server went away, or will not have it any more.
    Screen,
    /// A fault of the library's own.
    Fault,
    /// The thread that opened it has ended.
    Thread,
}

/// A window. Never used again for another.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Id(u64);

/// How a window is opened.
pub struct Options {
    /// What it shows.
    pub editor: editor::Options,
    /// The X display's name; the environment's if none.
    pub display: Option<String>,
    /// What the program is called; the name of the running one if none.
    pub application: Option<String>,
    /// An X window to live in; none: a top-level window.
    pub parent: Option<u32>,
    /// The host's X window that this one belongs to.
    pub transient_for: Option<u32>,
    /// What was wrong with the host's arguments; stands in the output field at first.
    pub warnings: Warnings,
    /// Its owner.
    pub host: Rc<dyn Host>,
}

impl Options {
    /// A window of its own that shows a path, for a program that takes its poses when
    /// they are handed over.
    pub fn new(document: Document, host: Rc<dyn Host>) -> Self {
        Self {
            editor: editor::Options {
                document,
                file: None,
                title: None,
                language: None,
                hand_over: true,
                fixed_speeds: false,
                folders: editor::Folders::of_environment(),
                program: host_program(true),
                host_view: editor::HostView::default(),
            },
            display: None,
            application: None,
            parent: None,
            transient_for: None,
            warnings: Warnings::default(),
            host,
        }
    }
}

/// Inner size of a new window in points.
const SIZE: [f32; 2] = [1200.0, 800.0];

/// The smallest inner size at which everything is to be seen.
const SMALLEST: [f32; 2] = [800.0, 600.0];

/// Opens a window, and returns before anything is drawn.
///
/// # Errors
/// `ErrorKind::Display` if there is no X server, `ErrorKind::Argument`
/// if a window of the host's is none, `ErrorKind::Memory`,
/// `ErrorKind::Limit` without descriptors.
pub fn open(options: Options) -> Result<Id> {
    let mut editor = Editor::new(options.editor)?;
    editor.warn(&options.warnings);
    let title = editor.window_title();
    let screen = x11::Window::open(&x11::Options {
        display: options.display,
        title: title.clone(),
        application: options.application.unwrap_or_else(program::name),
        size: SIZE,
        smallest: SMALLEST,
        parent: options.parent,
        transient_for: options.transient_for,
    })?;
    let window = window::Window::new(Box::new(screen), editor, title);
    let id = registry::insert(Box::new(window), options.host)?;
    let descriptor = registry::descriptor()?;
    xt::watch_in_all_contexts(descriptor);
    hint::opened();
    if xt::thread_is_watched() {
        lookout::begin(descriptor);
    }
    Ok(id)
}

/// The path or the scene in a file to start with, and what was wrong with its meshes; a
/// new path if there is no such file yet.
///
/// # Errors
/// Those of [`Document::load`].
pub fn document_of(file: &Path) -> document::Result<(Document, Vec<document::Error>)> {
    match Document::load_scene(file) {
        Err(document::Error::Io { source, .. }) if source.kind() == io::ErrorKind::NotFound => {
            Ok((Document::try_new()?, Vec::new()))
        }
        loaded => loaded,
    }
}

/// Closes a window without asking anybody; from within a callback of the
/// window itself, when that has returned. False if there is none.
pub fn close(id: Id) -> bool {
    registry::close(id)
}

/// Looks at the path of a window; `None` if it is not open.
pub fn read<R>(id: Id, f: impl FnOnce(&Document) -> R) -> Option<R> {
    registry::look(id, |window| f(window.document()))
}

/// Changes the path of a window; `None` if it is not open. What a callback changes it
/// is not called for.
pub fn change<R>(id: Id, f: impl FnOnce(&mut Document) -> R) -> Option<R> {
    command(id, |editor| f(editor.document_mut()))
}

/// Tells a window what to do or to show: its frame, what is current, the host's view,
/// see [`Editor`]; `None` if it is not open. What a callback changes it is not called
/// for.
pub fn command<R>(id: Id, f: impl FnOnce(&mut Editor) -> R) -> Option<R> {
    let within = within_a_call();
    let done = registry::work(id, &mut None, |window, _| window.command(within, f));
    registry::ring();
    done
}

/// Looks at what a window shows; `None` if it is not open.
pub fn look<R>(id: Id, f: impl FnOnce(&Editor) -> R) -> Option<R> {
    registry::look(id, |window| f(window.editor()))
}

/// Brings a window before all others; `None` if it is not open.
///
/// # Errors
/// `ErrorKind::Display` if its X server went away.
pub fn raise(id: Id) -> Option<Result<()>> {
    let done = registry::work(id, &mut None, |window, _| window.raise());
    registry::ring();
    done
}

/// The descriptor that is readable when [`dispatch`] has something to do; the
/// same one as long as the thread lives.
///
/// # Errors
/// `ErrorKind::Limit` where the system gives no more descriptors.
pub fn descriptor() -> Result<RawFd> {
    told();
    registry::descriptor()
}

/// The host serves its windows itself, or is about to: it knows how.
pub fn told() {
    hint::served();
    lookout::end(true);
}

/// How long until [`dispatch`] has something to do of itself.
pub fn wait() -> Option<Duration> {
    registry::wait()
}

/// Serves the windows of this thread in an Xt application context that it
/// runs. For a host that makes its context after it has opened windows.
pub fn set_app_context(context: *mut c_void) -> Result<std::result::Result<(), Refusal>> {
    Ok(xt::watch_in(context, registry::descriptor()?))
}

/// What is done when an Xt context finds the descriptor readable.
static ON_INPUT: OnceLock<fn()> = OnceLock::new();

/// Says what is to be done when the host's loop finds the descriptor readable:
/// [`dispatch`], and what its answer asks for.
pub fn on_input(serve: fn()) {
    let _ = ON_INPUT.set(serve);
}

/// The host's loop found the descriptor readable.
fn host_called() {
    match ON_INPUT.get() {
        Some(serve) => serve(),
        None => drop(dispatch()),
    }
}
