//! Editor windows by handles.

use std::ffi::{c_int, c_ulong};
use std::path::{Path, PathBuf};
use std::ptr;
use std::rc::Rc;
use std::sync::OnceLock;

use super::border::border;
use super::callbacks::Callbacks;
use super::counted::TryArc;
use super::curve::positive;
use super::handles::{Handles, KIND_EDITOR};
use super::host_loop;
use super::object::wireframe;
use super::path::{insert, read};
use super::pointers::{
    Growing, Out, bytes, file_name, init, optional, optional_text, read_growing, read_optional,
};
use super::space::up_from_c;
use super::status::{
    Answer, Failure, V_ERR_CLOSED, V_ERR_HANDLE, V_ERR_INTERNAL, V_OK, clear_last_error,
};
use super::types::{V_EDITOR, V_EDITOR_OPTIONS, V_PATH, V_UP_Y};
use crate::document::{At, Document, Edit, Info};
use crate::editor::{self, Language};
use crate::error::{Refused, Result};
use crate::instance::{self, Gone, Id};
use crate::path::{BaseFrames, Pose, Space};

/// All windows that C holds.
static EDITORS: Handles<Opened, V_EDITOR> = Handles::new(KIND_EDITOR);

/// What a handle stands for.
pub(super) struct Opened {
    pub(super) window: Id,
    /// The opening thread, by [`instance::own_thread`].
    thread: usize,
    /// The host has set the base speeds.
    pub(super) fixed_speeds: bool,
    /// Why the window is gone, unless `v_editor_close` closed it.
    gone: OnceLock<Gone>,
}

pub(super) const CLOSED: Failure = Failure::Border(V_ERR_CLOSED, "the window has been closed");

fn gone(why: Gone) -> Failure {
    let sentence = match why {
        Gone::ByUser => "the user has closed the window",
        Gone::WithAll => "the window was closed by v_editors_close()",
        Gone::Screen => "the window is gone: its X server went away or refused to go on",
        Gone::FromOutside => "the window is gone: it was destroyed, or put out of its parent",
        Gone::Fault => "the window is gone: a fault inside the library closed it",
        Gone::Thread => "the window is gone: the thread that opened it has ended",
    };
    Failure::Border(V_ERR_CLOSED, sentence)
}

const OTHER_THREAD: Failure =
    Failure::Border(V_ERR_HANDLE, "this window belongs to another thread");

/// Records why the window of a handle is gone.
pub(super) fn closed(editor: *const V_EDITOR, why: Gone) {
    if let Ok(opened) = EDITORS.get(editor) {
        let _ = opened.gone.set(why);
    }
}

/// The window of a handle, if it is open and belongs to the calling thread.
pub(super) fn opened(editor: *const V_EDITOR) -> Answer<TryArc<Opened>> {
    let found = EDITORS.get(editor)?;
    if let Some(&why) = found.gone.get() {
        return Err(gone(why));
    }
    if found.thread != instance::own_thread() {
        return Err(OTHER_THREAD);
    }
    if !instance::is_open(found.window) {
        return Err(CLOSED);
    }
    Ok(found)
}

/// ==== Windows: an editor beside your own program ====
///
/// Fills in the default options: space_up V_UP_Y, everything else NULL or 0.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_editor_options_init(options: *mut V_EDITOR_OPTIONS) {
    border((), || {
        // SAFETY: room for the options of version 1.0, as the header says.
        unsafe {
            init(
                options,
                V_EDITOR_OPTIONS::DEFAULTS,
                V_EDITOR_OPTIONS::FIRST,
                "options",
            )
        }
    });
}

/// Like v_editor_options_init(), for a struct of size bytes; size becomes what was
/// filled in. A struct shorter than in version 1.0 is unchanged.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_editor_options_init_sized(options: *mut V_EDITOR_OPTIONS, size: usize) {
    border((), || {
        // SAFETY: room for that much of the options, as the header says.
        unsafe { init(options, V_EDITOR_OPTIONS::DEFAULTS, size, "options") }
    });
}

// SAFETY: `repr(C)` with `size` first; the host is responsible for its pointers and functions in
// every version.
unsafe impl Growing for V_EDITOR_OPTIONS {
    const NAME: &'static str = "V_EDITOR_OPTIONS";
    const FIRST: usize = size_of::<V_EDITOR_OPTIONS>();
    const DEFAULTS: Self = Self {
        size: size_of::<V_EDITOR_OPTIONS>(),
        title: ptr::null(),
        file: ptr::null(),
        path: ptr::null(),
        object: ptr::null(),
        move_frames: 0.0,
        turn_frames: 0.0,
        zoom_frames: 0.0,
        roll_frames: 0.0,
        display: ptr::null(),
        language: ptr::null(),
        on_poses: None,
        on_close: None,
        user: ptr::null_mut(),
        space_centre: [0.0; 3],
        space_half_size: 0.0,
        space_up: V_UP_Y,
        on_view: None,
        on_change: None,
        on_capture: None,
        on_pane: None,
        host_name: ptr::null(),
        parent: 0,
        transient_for: 0,
        application: ptr::null(),
        hand_over_saves: 0,
        on_frame: None,
        view: ptr::null(),
        on_gone: None,
    };
}

/// Opens an editor window and returns at once; see v_fd() for how your program serves
/// it. options NULL: the defaults. Call it from the thread that runs the event loop.
///
/// The callbacks run there, also while your program shows a modal dialog. No
/// longjmp() and no exception may leave them; an exception that does ends the
/// program, after a line on standard error that names the callback. When the thread
/// ends, its window is closed, with a line on standard error.
/// V_ERR_HANDLE (of path), V_ERR_IO and V_ERR_FORMAT (of file), V_ERR_DISPLAY.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_editor_open(
    options: *const V_EDITOR_OPTIONS,
    editor: *mut *mut V_EDITOR,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = Out::new(editor, "editor")?;
        // SAFETY: the host's options, as the header says.
        let options = unsafe { options_of(options) }?;
        // SAFETY: as above for what they point to.
        let beginning = unsafe { begin(&options) }?;
        let opened = open(beginning, Callbacks::new(options))?;
        // SAFETY: room for a handle, as the header says.
        unsafe { out.answer(opened) }
    })
}

/// # Safety
/// `options` is NULL or points to a size and, if that is valid, to the options.
unsafe fn options_of(options: *const V_EDITOR_OPTIONS) -> Answer<V_EDITOR_OPTIONS> {
    // SAFETY: as required of the caller.
    let given = optional(options, |options| unsafe {
        read_growing(options, "options")
    })?;
    Ok(given.unwrap_or(V_EDITOR_OPTIONS::DEFAULTS))
}

/// Everything needed to open a window.
struct Beginning {
    editor: editor::Options,
    warnings: editor::Warnings,
    display: Option<String>,
    application: Option<String>,
    parent: Option<u32>,
    transient_for: Option<u32>,
}

/// Converts the options, copying everything.
///
/// # Safety
/// Every pointer in the options is NULL or as the header says.
unsafe fn begin(options: &V_EDITOR_OPTIONS) -> Answer<Beginning> {
    let mut warnings = editor::Warnings::default();
    // SAFETY: as required of the caller.
    let file = optional(options.file, |file| unsafe { file_name(file, "file") })?;
    let mut document = document_of(file, options.path, &mut warnings)?;
    // SAFETY: as required of the caller.
    let fixed_speeds = unsafe { configure(&mut document, options) }?;
    // SAFETY: as required of the caller, for all texts.
    let (title, display, language, application, host_name) = unsafe {
        (
            optional_text(options.title, "options->title")?,
            optional_text(options.display, "options->display")?,
            optional(options.language, |language| {
                language_of(bytes(language, "language")?)
            })?,
            optional_text(options.application, "options->application")?,
            optional_text(options.host_name, "options->host_name")?,
        )
    };
    Ok(Beginning {
        editor: editor::Options {
            // The window's own undo history begins here.
            document: document.as_opened(),
            file: file.map(PathBuf::from),
            title,
            language,
            host_takes_poses: options.on_poses.is_some(),
            fixed_speeds,
            folders: editor::Folders::of_environment(),
            program: program(options, application.as_deref()),
            host_view: editor::HostView {
                name: host_name,
                captures: options.on_capture.is_some(),
                fills_pane: options.on_pane.is_some(),
                keeps_view: !options.view.is_null(),
            },
        },
        warnings,
        display,
        application,
        parent: x_window(options.parent, "options->parent")?,
        transient_for: x_window(options.transient_for, "options->transient_for")?,
    })
}

/// What is edited: that of a file, a copy of a path, or a new path.
fn document_of(
    file: Option<&Path>,
    path: *const V_PATH,
    warnings: &mut editor::Warnings,
) -> Answer<Document> {
    match (file, path.is_null()) {
        (Some(_), false) => Err(Failure::argument(
            "options->file and options->path are both given: a window starts with only one",
        )),
        (None, true) => Ok(Document::try_new()?),
        (None, false) => read(path, |document| Ok(document.try_clone()?))
            .map_err(|failure| failure.named("options->path")),
        (Some(name), true) => {
            let (document, meshes) = instance::document_of(name)?;
            warnings.add_meshes(meshes);
            Ok(document)
        }
    }
}

fn language_of(name: &[u8]) -> Answer<Language> {
    match name {
        b"de" => Ok(Language::German),
        b"en" => Ok(Language::English),
        other => Err(Failure::NoLanguage(
            (&String::from_utf8_lossy(other)).into(),
        )),
    }
}

/// Gives the document the options' space, object and base speeds, and a new path its first view.
/// Whether there are speeds.
///
/// # Safety
/// As for [`begin`].
unsafe fn configure(document: &mut Document, options: &V_EDITOR_OPTIONS) -> Answer<bool> {
    // A new path is moved to the same place in the given space; others have coordinates of their
    // own.
    let fit = options.path.is_null() && document.fingerprint().is_none();
    // A host that fills its options with zeroes has not chosen.
    let unset = options.space_up == 0 && options.space_half_size == 0.0;
    let up = if unset { V_UP_Y } else { options.space_up };
    let mut space = Space {
        up: up_from_c(up, "options->space_up")?,
        ..Space::default()
    };
    if options.space_half_size != 0.0 {
        space.centre = options.space_centre.into();
        space.half_size = options.space_half_size;
        document.apply(Edit::SetSpace { space, fit })?;
    } else if fit {
        document.apply(Edit::SetSpace { space, fit })?;
    }
    // SAFETY: as required of the caller.
    let object = unsafe { wireframe(options.object, "options->object") }?;
    if !object.is_empty() {
        let mut info = document.info().clone();
        info.object = object;
        document.apply(Edit::SetInfo(Box::new(info)))?;
    }
    let speeds = BaseFrames {
        movement: options.move_frames,
        turning: options.turn_frames,
        zoom: options.zoom_frames,
        rolling: options.roll_frames,
    };
    // A scene that edits no path keeps its own speeds.
    let unset = [speeds.movement, speeds.turning, speeds.zoom, speeds.rolling] == [0.0; 4];
    if !unset {
        positive(speeds.movement, "options->move_frames")?;
        positive(speeds.turning, "options->turn_frames")?;
        positive(speeds.zoom, "options->zoom_frames")?;
        positive(speeds.rolling, "options->roll_frames")?;
    }
    if !unset && document.edits_path() {
        document.apply(Edit::set(At::Path, "base_speeds", speeds))?;
    }
    // SAFETY: as required of the caller.
    let view = unsafe { read_optional(options.view, "options->view") }?.map(Pose::from);
    match view {
        Some(view) if fit => editor::begin_at(document, &view)?,
        Some(view) => editor::check_view(document, &view)?,
        None if fit => document.look_at_object()?,
        None => {}
    }
    Ok(!unset)
}

/// Converts an X window of the host's; 0 is `None`.
fn x_window(given: c_ulong, name: &'static str) -> Answer<Option<u32>> {
    let id = u32::try_from(given).map_err(|_| Failure::NoWindow { name, given })?;
    Ok((id != 0).then_some(id))
}

/// The host's name, and whether its windows may save.
fn program(options: &V_EDITOR_OPTIONS, application: Option<&str>) -> editor::Program {
    let saves = options.file.is_null() || options.hand_over_saves != 0;
    let mut program = instance::host_program(saves);
    if let Some(name) = application.filter(|name| !name.is_empty()) {
        name.clone_into(&mut program.name);
    }
    program
}

/// Opens the window and creates its handle.
fn open(editor: Beginning, host: Callbacks) -> Answer<*mut V_EDITOR> {
    let host = Rc::new(host);
    let fixed_speeds = editor.editor.fixed_speeds;
    instance::on_input(host_loop::serve);
    let window = instance::open(instance::Options {
        editor: editor.editor,
        display: editor.display,
        application: editor.application,
        parent: editor.parent,
        transient_for: editor.transient_for,
        warnings: editor.warnings,
        host: Rc::<Callbacks>::clone(&host),
    })?
    .keep();
    let handle = EDITORS.insert(Opened {
        window,
        thread: instance::own_thread(),
        fixed_speeds,
        gone: OnceLock::new(),
    });
    match handle {
        Ok(handle) => host.handle.set(handle),
        Err(_) => {
            instance::close(window);
        }
    }
    handle
}

/// Closes a window without asking, and frees its handle: on the thread that opened
/// it, or on any once the window is gone. Inside the window's own callbacks it closes
/// when they have returned. on_gone is not called. Unsaved work is offered at the
/// next start of the program. NULL is ignored.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_editor_close(editor: *mut V_EDITOR) -> c_int {
    border(V_ERR_INTERNAL, || {
        if editor.is_null() {
            return Ok(V_OK);
        }
        match opened(editor) {
            Ok(found) => {
                EDITORS.remove(editor)?;
                instance::close(found.window);
                // Failed calls in the host's on_pane are not failures of this one.
                clear_last_error();
            }
            Err(Failure::Border(V_ERR_CLOSED, _)) => {
                EDITORS.remove(editor)?;
            }
            Err(failure) => return Err(failure),
        }
        Ok(V_OK)
    })
}

/// Gets a copy of the path in a window; in a scene, that of the camera shown.
/// V_ERR_ARGUMENT (no camera, or it follows no path).
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_editor_get_path(
    editor: *const V_EDITOR,
    path: *mut *mut V_PATH,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = Out::new(path, "path")?;
        let window = opened(editor)?.window;
        let copy = instance::read(window, Document::shown_path).ok_or(CLOSED)??;
        let made = insert(copy)?;
        // SAFETY: room for a handle, as the header says.
        unsafe { out.answer(made) }
    })
}

/// Replaces the path in a window, in one step that the user can undo, with its space,
/// title, comment and so on, and its object if it has one. Base speeds given when the
/// window was opened are kept. In a scene it replaces the path of the camera shown,
/// which is then edited. The playhead stays if it can.
/// V_ERR_ARGUMENT (no camera, or it follows no path).
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_editor_set_path(editor: *mut V_EDITOR, path: *const V_PATH) -> c_int {
    border(V_ERR_INTERNAL, || {
        let found = opened(editor)?;
        let copy = read(path, |document| Ok(document.try_clone()?))?;
        instance::change(found.window, |document| {
            replace(document, copy, found.fixed_speeds)
        })
        .ok_or(CLOSED)??;
        Ok(V_OK)
    })
}

/// Replaces the path.
fn replace(document: &mut Document, by: Document, fixed_speeds: bool) -> Result<()> {
    let (mut path, info) = by.into_parts();
    if fixed_speeds {
        path.base_frames = document.path().base_frames;
    }
    replace_with(document, info, |document| {
        edit_shown(document)?;
        document.apply(Edit::ReplacePath(Box::new(path)))
    })
}

/// Replaces what is edited by `contents`, and the information with it, in one undo step. An object
/// that is shown stays if there is no other.
pub(super) fn replace_with(
    document: &mut Document,
    mut info: Info,
    contents: impl FnOnce(&mut Document) -> Result<()>,
) -> Result<()> {
    if info.object.is_empty() {
        info.object = document.info().object.clone();
    }
    document.begin_step();
    let done = contents(document).and_then(|()| document.apply(Edit::SetInfo(Box::new(info))));
    match done {
        Ok(()) => document.end_step(),
        Err(_) => document.cancel_step(),
    }
    done
}

/// Makes the shown camera's path the one being edited.
fn edit_shown(document: &mut Document) -> Result<()> {
    let Some(edited) = document.edited_scene() else {
        return Ok(());
    };
    let shown = edited.scene().shown_camera().ok_or(Refused::NoCamera)?;
    document.apply(Edit::EditNode(Some(shown)))
}
