//! Paths as handles: made, copied, freed, loaded and saved.

use std::ffi::{c_char, c_int};
use std::sync::RwLock;

use super::border::border;
use super::handles::{Handles, KIND_PATH};
use super::pointers::{Out, TextOut, file_name, slice};
use super::status::{Answer, Failure, V_ERR_INTERNAL, V_OK};
use super::types::V_PATH;
use crate::document::{Document, Edit, Info};
use crate::inject;
use crate::path::CameraPath;

/// All paths that C holds.
static PATHS: Handles<RwLock<Document>, V_PATH> = Handles::new(KIND_PATH);

const SPOILED: Failure = Failure::Border(
    V_ERR_INTERNAL,
    "this path is unusable since a fault inside the library",
);

/// A handle for a path, which from now on has no history.
pub(super) fn insert(document: Document) -> Answer<*mut V_PATH> {
    PATHS.insert(RwLock::new(document.without_history()))
}

/// A handle for a path made just now.
pub(super) fn insert_new(path: CameraPath, fps: f64) -> Answer<*mut V_PATH> {
    let info = Info {
        fps,
        ..Info::default()
    };
    insert(Document::from_parts(path, info)?)
}

pub(super) fn read<R>(path: *const V_PATH, look: impl FnOnce(&Document) -> Answer<R>) -> Answer<R> {
    let document = PATHS.get(path)?;
    let document = document.read().map_err(|_| SPOILED)?;
    inject::point(inject::Place::Path);
    look(&document)
}

/// Works on a path with exclusive access.
pub(super) fn change<R>(
    path: *mut V_PATH,
    work: impl FnOnce(&mut Document) -> Answer<R>,
) -> Answer<R> {
    let document = PATHS.get(path)?;
    let mut document = document.write().map_err(|_| SPOILED)?;
    inject::point(inject::Place::Path);
    work(&mut document)
}

/// Applies an edit, wholly or not at all.
pub(super) fn edit(path: *mut V_PATH, edit: Edit) -> Answer<c_int> {
    edit_by(path, |_| Ok(edit))
}

/// Applies several edits, all or none.
pub(super) fn edits<const N: usize>(path: *mut V_PATH, edits: [Edit; N]) -> Answer<c_int> {
    change(path, |document| {
        document.apply_all(edits)?;
        Ok(V_OK)
    })
}

/// As [`edit`], with an edit that depends on the path.
pub(super) fn edit_by(
    path: *mut V_PATH,
    edit: impl FnOnce(&Document) -> Answer<Edit>,
) -> Answer<c_int> {
    change(path, |document| {
        let edit = edit(document)?;
        document.apply(edit)?;
        Ok(V_OK)
    })
}

/// As [`edit`], and then reads the path.
pub(super) fn edit_and<R>(
    path: *mut V_PATH,
    edit: Edit,
    look: impl FnOnce(&Document) -> R,
) -> Answer<R> {
    change(path, |document| {
        document.apply(edit)?;
        Ok(look(document))
    })
}

/// ==== Paths ====
///
/// A new path: two support points at (-0.6, 0.2, 0.8) and (0.6, 0.2, 0.8), each
/// with one orientation as v_orientation_init() makes it. *path is the
/// caller's, to be freed with v_path_free().
/// Any thread; from callbacks too. V_ERR_NULL, V_ERR_MEMORY, V_ERR_LIMIT.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_new(path: *mut *mut V_PATH) -> c_int {
    border(V_ERR_INTERNAL, || {
        let path = Out::new(path, "path")?;
        let made = insert(Document::try_new()?)?;
        // SAFETY: room for a handle, as the header says.
        unsafe { path.answer(made) }
    })
}

/// An independent copy of a path. *copy is the caller's, to be freed with
/// v_path_free().
/// Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_MEMORY,
/// V_ERR_LIMIT.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_clone(path: *const V_PATH, copy: *mut *mut V_PATH) -> c_int {
    border(V_ERR_INTERNAL, || {
        let copy = Out::new(copy, "copy")?;
        let made = insert(read(path, |document| Ok(document.try_clone()?))?)?;
        // SAFETY: room for a handle, as the header says.
        unsafe { copy.answer(made) }
    })
}

/// Frees a path; its handle is not valid from now on. NULL is no error. A
/// handle that is not valid does no harm; v_last_error() tells. A call that
/// another thread has under way on this path ends as if it had come before.
/// Any thread; from callbacks too.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_free(path: *mut V_PATH) {
    border((), || {
        if !path.is_null() {
            PATHS.remove(path)?;
        }
        Ok(())
    });
}

/// Reads a path from a .vid file; of a scene (v_scene_load()) that of the camera
/// that is shown: to save it to that file would lose the rest of the scene. file
/// is a name as open() takes it. *path is the caller's, to be freed with
/// v_path_free().
/// Any thread; from callbacks too. V_ERR_NULL, V_ERR_IO, V_ERR_FORMAT (with
/// line and reason in v_last_error()), V_ERR_ARGUMENT (that camera follows none, or
/// there is none), V_ERR_MEMORY, V_ERR_LIMIT. Memory that
/// runs out while the text itself is read or parsed ends the program.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_load(file: *const c_char, path: *mut *mut V_PATH) -> c_int {
    border(V_ERR_INTERNAL, || {
        let path = Out::new(path, "path")?;
        // SAFETY: a text ended by zero, as the header says.
        let document = Document::load_shown(unsafe { file_name(file, "file") }?)?;
        let made = insert(document)?;
        // SAFETY: room for a handle, as the header says.
        unsafe { path.answer(made) }
    })
}

/// Reads a path from the text of a .vid file in memory, as v_path_load() does; size
/// bytes of UTF-8, a zero behind them is not needed. *path is the caller's, to be freed with v_path_free().
/// Any thread; from callbacks too. V_ERR_NULL, V_ERR_FORMAT (with line and reason
/// in v_last_error()), V_ERR_ARGUMENT (a scene without such a camera), V_ERR_MEMORY,
/// V_ERR_LIMIT. Memory that runs out while the text is parsed ends the program.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_load_from_memory(
    text: *const c_char,
    size: usize,
    path: *mut *mut V_PATH,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let path = Out::new(path, "path")?;
        // SAFETY: as many bytes, as the header says.
        let mut text = unsafe { slice(text.cast::<u8>(), size, "text") }?;
        let document = Document::load_shown_from(&mut text, "memory")?;
        let made = insert(document)?;
        // SAFETY: room for a handle, as the header says.
        unsafe { path.answer(made) }
    })
}

/// Writes a path into a .vid file. Whatever happens, the file is afterwards
/// wholly the old or wholly the new one; when the call returns V_OK the new one
/// is on the disk. A symbolic link is followed, permissions are kept.
/// Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_IO,
/// V_ERR_MEMORY. Memory that runs out while the file is opened or written may
/// end the program; the old file stays.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_save(path: *const V_PATH, file: *const c_char) -> c_int {
    border(V_ERR_INTERNAL, || {
        // SAFETY: a text ended by zero, as the header says.
        let file = unsafe { file_name(file, "file") }?;
        read(path, |document| Ok(document.save(file)?))?;
        Ok(V_OK)
    })
}

/// The text of a .vid file of a path in memory, ended by zero, as v_path_save() writes it
/// and v_path_load_from_memory() reads it; *length is its bytes without the zero. With a
/// capacity not larger than *length nothing else is written, and the answer is V_ERR_SIZE.
/// text NULL with capacity 0 only asks for *length.
/// Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_SIZE, V_ERR_LIMIT,
/// V_ERR_MEMORY.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_save_to_memory(
    path: *const V_PATH,
    text: *mut c_char,
    capacity: usize,
    length: *mut usize,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = TextOut::new(text, capacity, length, "text")?;
        let written = read(path, |document| Ok(document.to_toml()?))?;
        // SAFETY: room as the header says.
        unsafe { out.write(written.as_bytes()) }
    })
}
