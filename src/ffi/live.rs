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
use crate::instance::{self, Closing};
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

/// ==== Windows and your picture: what both show ====
///
/// Shows your program's camera as a ghost, which the user can add to the path as a
/// point; NULL hides it. vpn and vup have any length but 0.
///
/// Changes that a callback makes with the functions of this section or with
/// v_editor_set_path() cause no further callbacks.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_editor_set_view(editor: *mut V_EDITOR, pose: *const V_POSE) -> c_int {
    border(V_ERR_INTERNAL, || {
        // SAFETY: a pose, as the header says.
        let pose = unsafe { read_optional(pose, "pose") }?.map(Pose::from);
        command(editor, |editor| editor.set_ghost(pose.as_ref()))
    })
}

/// Gets the frame at the playhead, for v_path_pose(); in a scene a frame of the scene,
/// for v_scene_evaluate().
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

/// Moves the playhead to a frame; in a scene one of the scene, within
/// v_scene_frame_range(). The orientation that the camera comes from becomes current.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_editor_set_frame(editor: *mut V_EDITOR, frame: c_double) -> c_int {
    border(V_ERR_INTERNAL, || {
        command(editor, |editor| editor.set_frame(frame))
    })
}

/// Plays the flight from the playhead, or from the beginning if that is at the end,
/// even if the window is not visible; 0 stops.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_editor_play(editor: *mut V_EDITOR, play: c_int) -> c_int {
    border(V_ERR_INTERNAL, || {
        command(editor, |editor| {
            editor.set_playing(play != 0);
            Ok(())
        })
    })
}

/// Makes an orientation current.
/// V_ERR_ARGUMENT (no path is edited).
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

/// Replaces the object shown, in one step; NULL removes it.
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

/// Sets the text after "VIDES" in the window's title, one line; NULL: the name of the
/// file.
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

/// Gets whether closing a window would lose work: 1 or 0.
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

/// Marks the contents of a window as saved, after your program has kept them.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_editor_mark_saved(editor: *mut V_EDITOR) -> c_int {
    border(V_ERR_INTERNAL, || {
        command(editor, |editor| {
            editor.mark_saved();
            Ok(())
        })
    })
}

/// Saves the contents of a window to a .vid file, which it edits from then on. NULL:
/// its own file.
/// V_ERR_ARGUMENT (no file yet, or changed by another program), V_ERR_IO.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_editor_save(editor: *mut V_EDITOR, file: *const c_char) -> c_int {
    border(V_ERR_INTERNAL, || {
        // SAFETY: a text, as the header says.
        let file = optional(file, |file| unsafe { file_name(file, "file") })?;
        command(editor, |editor| editor.save_as(file))
    })
}

/// Raises a window above all others, if the desktop allows it.
/// V_ERR_DISPLAY.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_editor_raise(editor: *mut V_EDITOR) -> c_int {
    border(V_ERR_INTERNAL, || {
        let window = opened(editor)?.window;
        instance::raise(window).ok_or(CLOSED)??;
        Ok(V_OK)
    })
}

/// Closes all windows that this thread has open, also those of v_haupt(), for your
/// program's Quit. You still free the handles with v_editor_close().
///
/// ask  0: without asking; unsaved work is offered at the next start. Otherwise each
///     window in turn asks about unsaved work and then calls on_close or ende, until
///     all are closed or one refuses; meanwhile all are served
///
/// Meanwhile the call handles the events, timers and inputs of a program with Xt, in
/// the context that this thread ran last; no longjmp() and no exception may leave
/// their callbacks. A second call raises the window that asks.
/// V_ERR_REFUSED (the windows before that one are closed), V_ERR_BUSY (within a
/// callback, or while an earlier call asks), V_ERR_DISPLAY, V_ERR_LIMIT (no
/// descriptors).
#[unsafe(no_mangle)]
pub extern "C" fn v_editors_close(ask: c_int) -> c_int {
    border(V_ERR_INTERNAL, || {
        if instance::within_a_call() {
            return Err(Failure::Border(
                V_ERR_BUSY,
                "v_editors_close() cannot be called within a callback",
            ));
        }
        match instance::close_all(ask != 0)? {
            Closing::Done => Ok(V_OK),
            Closing::Refused => Err(Failure::Border(
                V_ERR_REFUSED,
                "the user, on_close or ende refused to close a window",
            )),
            Closing::Asking => Err(Failure::Border(
                V_ERR_BUSY,
                "the windows are being closed already: one is asking its user",
            )),
        }
    })
}
