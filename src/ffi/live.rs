//! Calls on an open window: frame, current orientation, the host's camera, object and title, and
//! its own Quit.

use std::ffi::{c_char, c_double, c_int};

use super::border::border;
use super::editor::{CLOSED, opened};
use super::object::wireframe;
use super::pointers::{Out, file_name, index, optional, optional_text, read_optional};
use super::scene_types::V_MESH;
use super::status::{Answer, Failure, V_ERR_BUSY, V_ERR_INTERNAL, V_ERR_REFUSED, V_OK};
use super::types::{V_EDITOR, V_POSE};
use crate::editor::Editor;
use crate::instance;
use crate::path::Pose;

impl From<V_POSE> for Pose {
    fn from(pose: V_POSE) -> Self {
        Self {
            vrp: pose.vrp,
            vpn: pose.vpn,
            vup: pose.vup,
            zoom: pose.zoom,
        }
    }
}

fn command(
    editor: *const V_EDITOR,
    command: impl FnOnce(&mut Editor) -> crate::error::Result<()>,
) -> Answer<c_int> {
    let window = opened(editor)?.window;
    instance::command(window, command).ok_or(CLOSED)??;
    Ok(V_OK)
}

/// ==== The window and the host's own picture ====
///
/// Shows the host's camera in a window, as a ghost in the movement space that the
/// user can take over into the path. NULL: no more. vpn and vup may have any length
/// but 0.
///
/// What a callback changes by these functions or by v_editor_set_path(), that
/// callbacks are not called for.
/// The thread that opened the window; from callbacks too. V_ERR_HANDLE,
/// V_ERR_CLOSED, V_ERR_NULL (editor), V_ERR_ARGUMENT, V_ERR_RANGE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_editor_set_view(editor: *mut V_EDITOR, pose: *const V_POSE) -> c_int {
    border(V_ERR_INTERNAL, || {
        // SAFETY: a pose, as the header says.
        let pose = unsafe { read_optional(pose, "pose") }?.map(Pose::from);
        command(editor, |editor| editor.set_ghost(pose.as_ref()))
    })
}

/// The frame at the playhead, from 1: v_path_pose() of it is what the camera there
/// sees. It lies between two frames where the user has gone there. In a scene it is
/// the scene's frame, as v_scene_evaluate() takes it.
/// The thread that opened the window; from callbacks too. V_ERR_NULL,
/// V_ERR_HANDLE, V_ERR_CLOSED, V_ERR_MEMORY, V_ERR_LIMIT.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_editor_get_frame(
    editor: *const V_EDITOR,
    frame: *mut c_double,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = Out::new(frame, "frame")?;
        let window = opened(editor)?.window;
        let at = instance::look(window, Editor::frame).ok_or(CLOSED)??;
        // SAFETY: room for a double, as the header says.
        unsafe { out.answer(at) }
    })
}

/// The playhead goes to a frame, from 1 to v_path_frame_count(), also between two,
/// and stays there. The orientation from which the camera comes there is current
/// then. In a scene it is a frame of the scene, any from the first to the last one
/// of v_scene_frame_range(), whatever is selected.
/// The thread that opened the window; from callbacks too. V_ERR_NULL,
/// V_ERR_HANDLE, V_ERR_CLOSED, V_ERR_RANGE, V_ERR_MEMORY, V_ERR_LIMIT.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_editor_set_frame(editor: *mut V_EDITOR, frame: c_double) -> c_int {
    border(V_ERR_INTERNAL, || {
        command(editor, |editor| editor.set_frame(frame))
    })
}

/// Plays the flight from the playhead on, at the end from the beginning; play 0:
/// no more. It begins when the window is served next, and goes on whether or not
/// that is seen.
/// The thread that opened the window; from callbacks too. V_ERR_NULL,
/// V_ERR_HANDLE, V_ERR_CLOSED.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_editor_play(editor: *mut V_EDITOR, play: c_int) -> c_int {
    border(V_ERR_INTERNAL, || {
        command(editor, |editor| {
            editor.set_playing(play != 0);
            Ok(())
        })
    })
}

/// Makes an orientation of a point current, both counted from 0.
/// The thread that opened the window; from callbacks too. V_ERR_NULL,
/// V_ERR_HANDLE, V_ERR_CLOSED, V_ERR_ARGUMENT (no path is edited), V_ERR_RANGE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_editor_select(
    editor: *mut V_EDITOR,
    point: c_int,
    orientation: c_int,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let (point, orientation) = (index(point, "point")?, index(orientation, "orientation")?);
        command(editor, |editor| editor.select_key(point, orientation))
    })
}

/// Shows another object, copied, in one step that the user can take back. NULL:
/// none.
/// The thread that opened the window; from callbacks too. V_ERR_NULL (editor),
/// V_ERR_SIZE, V_ERR_HANDLE, V_ERR_CLOSED, V_ERR_ARGUMENT, V_ERR_RANGE,
/// V_ERR_LIMIT, V_ERR_MEMORY.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_editor_set_object(
    editor: *mut V_EDITOR,
    object: *const V_MESH,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        // SAFETY: a mesh, as the header says.
        let object = unsafe { wireframe(object, "object") }?;
        command(editor, |editor| editor.set_object(object))
    })
}

/// Sets what follows "VIDES" in the window's title, UTF-8, one line (control
/// characters are shown as spaces); NULL: the file's name.
/// The thread that opened the window; from callbacks too. V_ERR_NULL (editor),
/// V_ERR_HANDLE, V_ERR_CLOSED, V_ERR_ARGUMENT, V_ERR_MEMORY.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_editor_set_title(editor: *mut V_EDITOR, title: *const c_char) -> c_int {
    border(V_ERR_INTERNAL, || {
        // SAFETY: a text, as the header says.
        let title = unsafe { optional_text(title, "title") }?;
        command(editor, |editor| {
            editor.set_title(title);
            Ok(())
        })
    })
}

/// Whether there is work in a window that would be lost with it: *modified is 1 or 0.
/// The thread that opened the window; from callbacks too. V_ERR_NULL,
/// V_ERR_HANDLE, V_ERR_CLOSED.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_editor_is_modified(
    editor: *const V_EDITOR,
    modified: *mut c_int,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = Out::new(modified, "modified")?;
        let window = opened(editor)?.window;
        let unsaved = instance::look(window, Editor::is_unsaved).ok_or(CLOSED)?;
        // SAFETY: room for an int, as the header says.
        unsafe { out.answer(c_int::from(unsaved)) }
    })
}

/// Saves the path of a window as a .vid file, whatever is there, which the window
/// edits from then on. NULL: its own file, unless another program has changed that
/// meanwhile.
/// The thread that opened the window; from callbacks too. V_ERR_NULL (editor),
/// V_ERR_HANDLE, V_ERR_CLOSED, V_ERR_ARGUMENT (no file yet, or changed by others),
/// V_ERR_IO, V_ERR_MEMORY.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_editor_save(editor: *mut V_EDITOR, file: *const c_char) -> c_int {
    border(V_ERR_INTERNAL, || {
        // SAFETY: a text, as the header says.
        let file = optional(file, |file| unsafe { file_name(file, "file") })?;
        command(editor, |editor| editor.save_as(file))
    })
}

/// Brings a window before all others, if the desktop lets it.
/// The thread that opened the window; from callbacks too. V_ERR_NULL,
/// V_ERR_HANDLE, V_ERR_CLOSED, V_ERR_DISPLAY.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_editor_raise(editor: *mut V_EDITOR) -> c_int {
    border(V_ERR_INTERNAL, || {
        let window = opened(editor)?.window;
        instance::raise(window).ok_or(CLOSED)??;
        Ok(V_OK)
    })
}

/// Closes all windows of this thread, those of v_haupt(), too: for the host's own
/// Quit. ask not 0: each window asks about unsaved work, then on_close or ende, one
/// after the other; all are served until the last is closed or somebody says no.
/// Handles are freed by v_editor_close() nevertheless.
/// The thread that opens the windows. V_ERR_REFUSED (the windows before that one are
/// closed), V_ERR_BUSY from within a callback, V_ERR_DISPLAY, V_ERR_LIMIT without
/// descriptors.
#[unsafe(no_mangle)]
pub extern "C" fn v_editors_close(ask: c_int) -> c_int {
    border(V_ERR_INTERNAL, || {
        if instance::within_a_call() {
            return Err(Failure::Border(
                V_ERR_BUSY,
                "the windows cannot be closed all at once within a callback",
            ));
        }
        if instance::close_all(ask != 0)? {
            return Ok(V_OK);
        }
        Err(Failure::Border(
            V_ERR_REFUSED,
            "a user, on_close or ende keeps a window open",
        ))
    })
}
