//! The open windows under the host's event loop: each an editor with its X window and its pixels.
//!
//! All calls concern the windows of the calling thread. Host code is called only while nothing is
//! borrowed, so a callback may call anything.
//!
//! It knows nothing of C: the host is reached through [`Host`].

mod clock;
mod descriptors;
mod edit;
mod ending;
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
pub use pump::{close_all, dispatch, host_serves, main_loop};
pub use registry::{Lost, is_open, within_a_call};
pub use vides_editor::Reason;
pub use xt::{Refusal, own_thread};

/// How a window is opened.
pub struct Options {
    /// What it shows.
    pub editor: vides_editor::Options,
    /// The X display's name; by default the environment's.
    pub display: Option<String>,
    /// What the program is called; by default the name of the running one.
    pub application: Option<String>,
    /// An X window to be embedded in; `None`: a top-level window.
    pub parent: Option<u32>,
    /// The host's X window that this one belongs to.
    pub transient_for: Option<u32>,
    /// What was wrong with the host's arguments; shown in the output field at first.
    pub warnings: Warnings,
    /// Its owner.
    pub host: Rc<dyn Host>,
}

impl Options {
    /// A top-level window on a path, for a program that takes its poses when handed over.
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

/// The smallest inner size in which one can work: it fits small screens of high density, too.
const SMALLEST: [f32; 2] = [640.0, 440.0];

/// Opens a window, and returns before anything is drawn. It closes when the handle is dropped.
///
/// # Errors
/// `ErrorKind::Display` without an X server, `ErrorKind::Argument` if a window of the host's does
/// not exist, `ErrorKind::Memory`, `ErrorKind::Limit` without descriptors.
pub fn open(options: Options) -> Result<Handle> {
    let mut editor = Editor::new(options.editor)?;
    editor.warn(&options.warnings);
    editor.work_beside(start);
    let title = editor.window_title();
    let screen = vides_x11::Window::open(&vides_x11::Options {
        display: options.display,
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

/// Starts a thread for work that takes long; whether that could be.
fn start(work: Box<dyn FnOnce() + Send>) -> bool {
    let thread = std::thread::Builder::new().name("vides work".to_owned());
    vides_x11::without_signals(|| thread.spawn(work)).is_ok()
}

/// Loads a path or scene, with what was wrong with its meshes; a new path if the file is missing.
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

/// Closes a window without asking, after a callback of its own if one runs. False if none is open.
pub fn close(id: Id) -> bool {
    registry::close(id)
}

/// Looks at the path of a window; `None` if it is not open.
pub fn read<R>(id: Id, f: impl FnOnce(&Document) -> R) -> Option<R> {
    look(id, |editor| f(editor.document()))
}

/// Changes the path of a window; `None` if it is not open. The host is not called for what its own
/// callback changes.
pub fn change<R>(id: Id, f: impl FnOnce(&mut Document) -> R) -> Option<R> {
    command(id, |editor| f(editor.document_mut()))
}

/// Changes what a window does or shows, see [`Editor`]; `None` if it is not open. The host is not
/// called for what its own callback changes.
pub fn command<R>(id: Id, f: impl FnOnce(&mut Editor) -> R) -> Option<R> {
    let within = within_a_call();
    let done = registry::work(id, |window, _| window.command(within, f));
    registry::ring();
    done
}

/// Looks at the editor of a window; `None` if it is not open.
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
/// `ErrorKind::Limit` where the system gives no more descriptors.
pub fn descriptor() -> Result<RawFd> {
    host_serves();
    registry::descriptor()
}

/// How long until [`dispatch`] has something to do without any news.
pub fn wait() -> Option<Duration> {
    registry::wait()
}

/// Serves the windows of this thread in an Xt application context, for a host that makes its
/// context after it has opened windows. Within the result is whether Xt takes them.
///
/// # Errors
/// `ErrorKind::Limit` where the system gives no more descriptors.
pub fn set_app_context(context: *mut c_void) -> Result<std::result::Result<(), Refusal>> {
    Ok(xt::watch_in(context, registry::descriptor()?, host_called))
}

static ON_INPUT: OnceLock<fn()> = OnceLock::new();

/// Sets what is done when an Xt loop finds the descriptor readable: [`dispatch`] and what follows.
pub fn on_input(serve: fn()) {
    let _ = ON_INPUT.set(serve);
}

fn host_called() {
    match ON_INPUT.get() {
        Some(serve) => serve(),
        None => drop(dispatch()),
    }
}
