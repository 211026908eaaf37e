//! The open windows under the host's event loop: each is an editor with an X window and its pixels.
//!
//! All calls concern the windows of the calling thread. Host code is called only while nothing is
//! borrowed, so a callback may call anything.
//!
//! This crate does not know C; it reaches the host through [`Host`].

// Standard output is the host's.
#![cfg_attr(not(test), warn(clippy::print_stdout))]

mod clock;
mod descriptors;
mod edit;
mod error;
mod handle;
mod hint;
mod host;
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

pub use vides_editor as editor;

use vides_document::Document;
use vides_editor::{Editor, Warnings};

pub use edit::edit;
pub use error::{Error, Result};
pub use handle::Handle;
pub use host::{Gone, Host, Id};
pub use program::{host_program, own_program};
pub use pump::{Closing, close_all, dispatch, host_serves, main_loop};
pub use registry::{Lost, is_open, within_a_call};
pub use vides_editor::Reason;
pub use xt::{Refusal, own_thread};

/// The options for opening a window.
pub struct Options {
    /// The document, and what the editor shows.
    pub editor: vides_editor::Options,
    /// The name of the X display; by default that of the program's Xt, then that of the
    /// environment.
    pub display: Option<String>,
    /// The name of the application; by default that of the running program.
    pub application: Option<String>,
    /// The X window to embed this one in; `None` for a top-level window.
    pub parent: Option<u32>,
    /// The X window of the host that this window belongs to.
    pub transient_for: Option<u32>,
    /// Errors in the host's arguments, shown first in the output field.
    pub warnings: Warnings,
    /// Its owner.
    pub host: Rc<dyn Host>,
}

impl Options {
    /// Options for a top-level window with a path, for a program that takes its poses on hand-over.
    pub fn new(document: Document, host: Rc<dyn Host>) -> Self {
        Self {
            editor: vides_editor::Options {
                document,
                file: None,
                title: None,
                language: None,
                host_takes_poses: true,
                fixed_speeds: false,
                folders: vides_editor::Folders::of_environment(),
                program: host_program(true),
                host_view: vides_editor::HostView::default(),
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

/// The smallest inner size in which the window is usable; it also fits small screens of high
/// density.
const SMALLEST: [f32; 2] = [640.0, 440.0];

/// Opens a window, and returns before anything is drawn. Dropping the handle closes it.
///
/// # Errors
/// `ErrorKind::Display` without an X server, `ErrorKind::Argument` if a given X window of the host
/// does not exist, `ErrorKind::Memory`, `ErrorKind::Limit` if no descriptor is left.
pub fn open(options: Options) -> Result<Handle> {
    let mut editor = Editor::new(options.editor)?;
    editor.warn(&options.warnings);
    editor.work_beside(start);
    let title = editor.window_title();
    let screen = vides_x11::Window::open(&vides_x11::Options {
        display: options.display.or_else(xt::display),
        title: title.clone(),
        application: options.application.unwrap_or_else(program::name),
        size: SIZE,
        smallest: SMALLEST,
        parent: options.parent,
        transient_for: options.transient_for,
    })?;
    let window = window::Window::new(Box::new(screen), editor, title);
    let handle = Handle::new(registry::insert(Box::new(window), options.host)?);
    let descriptor = registry::descriptor()?;
    xt::watch_in_all_contexts(descriptor, host_called);
    hint::opened();
    if xt::thread_is_watched() {
        lookout::begin(descriptor);
    }
    Ok(handle)
}

/// Starts a thread for long work; false if that failed.
fn start(work: Box<dyn FnOnce() + Send>) -> bool {
    let thread = std::thread::Builder::new().name("vides work".to_owned());
    vides_x11::without_signals(|| thread.spawn(work)).is_ok()
}

/// Loads a path or scene, with warnings about its meshes; a new path if the file is missing.
///
/// # Errors
/// Those of [`Document::load`].
pub fn document_of(file: &Path) -> vides_document::Result<(Document, Vec<vides_document::Error>)> {
    match Document::load_scene(file) {
        Err(vides_document::Error::Io { source, .. })
            if source.kind() == io::ErrorKind::NotFound =>
        {
            Ok((Document::try_new()?, Vec::new()))
        }
        loaded => loaded,
    }
}

/// Closes a window without asking, or after its own callback if one is running. Unsaved work is
/// offered at the next start. False if the window is not open.
pub fn close(id: Id) -> bool {
    registry::close(id)
}

/// Reads the path of a window; `None` if it is not open.
pub fn read<R>(id: Id, f: impl FnOnce(&Document) -> R) -> Option<R> {
    look(id, |editor| f(editor.document()))
}

/// Changes the path of a window; `None` if it is not open. A change that the host's own callback
/// makes is not reported to the host.
pub fn change<R>(id: Id, f: impl FnOnce(&mut Document) -> R) -> Option<R> {
    command(id, |editor| editor.change(f))
}

/// Changes what a window does or shows, see [`Editor`]; `None` if it is not open. A change that the
/// host's own callback makes is not reported to the host.
pub fn command<R>(id: Id, f: impl FnOnce(&mut Editor) -> R) -> Option<R> {
    let within = within_a_call();
    let done = registry::work(id, |window, _| window.command(within, f));
    registry::ring();
    done
}

/// Reads the editor of a window; `None` if it is not open.
pub fn look<R>(id: Id, f: impl FnOnce(&Editor) -> R) -> Option<R> {
    registry::look(id, |window| f(window.editor()))
}

/// Raises a window above all others; `None` if it is not open.
///
/// # Errors
/// `ErrorKind::Display` if its X server went away.
pub fn raise(id: Id) -> Option<Result<()>> {
    let done = registry::work(id, |window, _| window.raise());
    registry::ring();
    done
}

/// The descriptor that is readable when [`dispatch`] has something to do; one for the whole thread.
///
/// # Errors
/// `ErrorKind::Limit` if no descriptor is left.
pub fn descriptor() -> Result<RawFd> {
    host_serves();
    registry::descriptor()
}

/// How long until [`dispatch`] has something to do without input.
pub fn wait() -> Option<Duration> {
    registry::wait()
}

/// Serves the windows of this thread in an Xt application context, for a host that creates its
/// context after it opened windows. The inner result is whether Xt accepts them.
///
/// # Errors
/// `ErrorKind::Limit` if no descriptor is left.
pub fn set_app_context(context: *mut c_void) -> Result<std::result::Result<(), Refusal>> {
    Ok(xt::watch_in(context, registry::descriptor()?, host_called))
}

static ON_INPUT: OnceLock<fn()> = OnceLock::new();

/// Sets what to call when an Xt loop finds the descriptor readable: [`dispatch`] and what follows.
pub fn on_input(serve: fn()) {
    let _ = ON_INPUT.set(serve);
}

fn host_called() {
    match ON_INPUT.get() {
        Some(serve) => serve(),
        None => drop(dispatch()),
    }
}
