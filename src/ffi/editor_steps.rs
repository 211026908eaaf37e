//! The history of an open window, and what it is about.

use std::ffi::c_int;

use super::border::border;
use super::editor::{CLOSED, opened};
use super::pointers::{self, Out};
use super::status::{Answer, Failure, V_ERR_INTERNAL, V_OK};
use super::types::V_EDITOR;
use crate::document::Document;
use crate::editor::Editor;
use crate::instance;

/// Goes one step through the history.
fn travel(
    editor: *const V_EDITOR,
    step: impl FnOnce(&mut Document) -> bool,
    none: &'static str,
) -> Answer<c_int> {
    let window = opened(editor)?.window;
    if instance::change(window, step).ok_or(CLOSED)? {
        Ok(V_OK)
    } else {
        Err(Failure::argument(none))
    }
}

/// ==== Steps of a window ====
///
/// Takes back the last step of a window, as the user does by Ctrl-Z. A window keeps the last
/// 10,000 steps, and of what they have changed 256 MiB.
/// The thread that opened the window; from callbacks too. V_ERR_NULL,
/// V_ERR_HANDLE, V_ERR_CLOSED, V_ERR_ARGUMENT (there is none).
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_editor_undo(editor: *mut V_EDITOR) -> c_int {
    border(V_ERR_INTERNAL, || {
        travel(editor, Document::undo, "there is no step to take back")
    })
}

/// Does again what was taken back last, as the user does by Ctrl-Y.
/// The thread that opened the window; from callbacks too. V_ERR_NULL,
/// V_ERR_HANDLE, V_ERR_CLOSED, V_ERR_ARGUMENT (there is none).
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_editor_redo(editor: *mut V_EDITOR) -> c_int {
    border(V_ERR_INTERNAL, || {
        travel(editor, Document::redo, "there is no step to do again")
    })
}

/// Begins what the user can take back at once: all that is changed in a window, by whomever,
/// until v_editor_end_step(). One that was begun before is forgotten; another document in the
/// window ends it.
/// The thread that opened the window; from callbacks too. V_ERR_NULL,
/// V_ERR_HANDLE, V_ERR_CLOSED.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_editor_begin_step(editor: *mut V_EDITOR) -> c_int {
    border(V_ERR_INTERNAL, || {
        let window = opened(editor)?.window;
        instance::change(window, Document::mark_steps).ok_or(CLOSED)?;
        Ok(V_OK)
    })
}

/// Ends what v_editor_begin_step() has begun; without that it does nothing.
/// The thread that opened the window; from callbacks too. V_ERR_NULL,
/// V_ERR_HANDLE, V_ERR_CLOSED, V_ERR_MEMORY (the steps stay apart).
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_editor_end_step(editor: *mut V_EDITOR) -> c_int {
    border(V_ERR_INTERNAL, || {
        let window = opened(editor)?.window;
        instance::change(window, Document::join_steps).ok_or(CLOSED)??;
        Ok(V_OK)
    })
}

/// The point that is current and its orientation, both counted from 0, see
/// v_editor_select(). Each result may be NULL.
/// The thread that opened the window; from callbacks too. V_ERR_NULL,
/// V_ERR_HANDLE, V_ERR_CLOSED, V_ERR_ARGUMENT (no path of its scene is edited).
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_editor_get_selection(
    editor: *const V_EDITOR,
    point: *mut c_int,
    orientation: *mut c_int,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let (point, orientation) = (
            Out::optional(point, "point")?,
            Out::optional(orientation, "orientation")?,
        );
        let window = opened(editor)?.window;
        let selection = instance::read(window, |document| {
            document.edits_path().then(|| document.selection())
        });
        let Some(at) = selection.ok_or(CLOSED)? else {
            return Err(Failure::argument("no path of the scene is edited"));
        };
        let numbers = (pointers::count(at.point)?, pointers::count(at.orientation)?);
        // SAFETY: room for an int each, as the header says.
        unsafe {
            point.write(numbers.0);
            orientation.answer(numbers.1)
        }
    })
}

/// Whether a window plays the flight, see v_editor_play(): *playing is 1 or 0.
/// The thread that opened the window; from callbacks too. V_ERR_NULL,
/// V_ERR_HANDLE, V_ERR_CLOSED.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_editor_is_playing(
    editor: *const V_EDITOR,
    playing: *mut c_int,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = Out::new(playing, "playing")?;
        let window = opened(editor)?.window;
        let plays = instance::look(window, Editor::plays).ok_or(CLOSED)?;
        // SAFETY: room for an int, as the header says.
        unsafe { out.answer(c_int::from(plays)) }
    })
}
