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

/// Undoes the last step of a window, like Ctrl-Z: up to 10,000 steps, and 256 MiB.
/// V_ERR_ARGUMENT (nothing to undo).
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_editor_undo(editor: *mut V_EDITOR) -> c_int {
    border(V_ERR_INTERNAL, || {
        travel(editor, Document::undo, "there is nothing to undo")
    })
}

/// Redoes the step that was undone last, like Ctrl-Y.
/// V_ERR_ARGUMENT (nothing to redo).
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_editor_redo(editor: *mut V_EDITOR) -> c_int {
    border(V_ERR_INTERNAL, || {
        travel(editor, Document::redo, "there is nothing to redo")
    })
}

/// Begins a group of changes in a window, yours and the user's, that the user undoes
/// as one step. It replaces a group begun before; loading another document ends it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_editor_begin_step(editor: *mut V_EDITOR) -> c_int {
    border(V_ERR_INTERNAL, || {
        let window = opened(editor)?.window;
        instance::change(window, Document::mark_steps).ok_or(CLOSED)?;
        Ok(V_OK)
    })
}

/// Ends the group of v_editor_begin_step(); does nothing without one.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_editor_end_step(editor: *mut V_EDITOR) -> c_int {
    border(V_ERR_INTERNAL, || {
        let window = opened(editor)?.window;
        instance::change(window, Document::join_steps).ok_or(CLOSED)?;
        Ok(V_OK)
    })
}

/// Gets the current point and orientation.
/// V_ERR_ARGUMENT (no path is edited).
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

/// Gets whether a window is playing: 1 or 0.
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
