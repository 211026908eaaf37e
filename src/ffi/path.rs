//! Paths as handles: made, copied, freed, loaded and saved.

use std::ffi::{c_char, c_int};
use std::sync::RwLock;

use super::border::border;
use super::handles::{Handles, KIND_PATH};
use super::pointers::{MAX_TEXT, Out, TextOut, file_name, most, slice};
use super::progress::locked;
use super::status::{Answer, Failure, V_ERR_INTERNAL, V_OK};
use super::types::V_PATH;
use crate::document::{Document, Edit, Info};
use crate::inject;
use crate::path::CameraPath;

/// All paths that C holds.
static PATHS: Handles<RwLock<Document>, V_PATH> = Handles::new(KIND_PATH);

const SPOILED: Failure = Failure::Border(
    V_ERR_INTERNAL,
    "this path is unusable after a fault inside the library",
);

/// Creates a handle for a path, which then has no history.
pub(super) fn insert(document: Document) -> Answer<*mut V_PATH> {
    PATHS.insert(RwLock::new(document.without_history()))
}

/// Creates a handle for a new path.
pub(super) fn insert_new(path: CameraPath, fps: f64) -> Answer<*mut V_PATH> {
    let info = Info {
        fps,
        ..Info::default()
    };
    insert(Document::from_parts(path, info)?)
}

pub(super) fn read<R>(path: *const V_PATH, look: impl FnOnce(&Document) -> Answer<R>) -> Answer<R> {
    let document = PATHS.get(path)?;
    let document = locked(|| document.read(), || document.try_read(), SPOILED)?;
    inject::point(inject::Place::Path);
    look(&document)
}

/// Works on a path with exclusive access.
pub(super) fn change<R>(
    path: *mut V_PATH,
    work: impl FnOnce(&mut Document) -> Answer<R>,
) -> Answer<R> {
    let document = PATHS.get(path)?;
    let mut document = locked(|| document.write(), || document.try_write(), SPOILED)?;
    inject::point(inject::Place::Path);
    work(&mut document)
}

/// Applies an edit atomically.
pub(super) fn edit(path: *mut V_PATH, edit: Edit) -> Answer<c_int> {
    edit_by(path, |_| Ok(edit))
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

/// ==== Paths: made, copied, loaded, saved ====
///
/// Makes a new path: two points at (-0.6, 0.2, 0.8) and (0.6, 0.2, 0.8), each with one
/// orientation of v_orientation_init().
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_new(path: *mut *mut V_PATH) -> c_int {
    border(V_ERR_INTERNAL, || {
        let path = Out::new(path, "path")?;
        let made = insert(Document::try_new()?)?;
        // SAFETY: room for a handle, as the header says.
        unsafe { path.answer(made) }
    })
}

/// Makes an independent copy of a path.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_clone(path: *const V_PATH, copy: *mut *mut V_PATH) -> c_int {
    border(V_ERR_INTERNAL, || {
        let copy = Out::new(copy, "copy")?;
        let made = insert(read(path, |document| Ok(document.try_clone()?))?)?;
        // SAFETY: room for a handle, as the header says.
        unsafe { copy.answer(made) }
    })
}

/// Frees a path. NULL is ignored. A call that uses it in another thread completes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_free(path: *mut V_PATH) {
    border((), || {
        if !path.is_null() {
            PATHS.remove(path)?;
        }
        Ok(())
    });
}

/// Reads a path from a .vid file; of a scene, the path of the camera shown: saving that
/// to the same file would lose the rest.
/// V_ERR_IO, V_ERR_FORMAT, V_ERR_ARGUMENT (no camera, or it follows no path).
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_load(file: *const c_char, path: *mut *mut V_PATH) -> c_int {
    border(V_ERR_INTERNAL, || {
        let path = Out::new(path, "path")?;
        // SAFETY: a zero-terminated text, as the header says.
        let document = Document::load_shown(unsafe { file_name(file, "file") }?)?;
        let made = insert(document)?;
        // SAFETY: room for a handle, as the header says.
        unsafe { path.answer(made) }
    })
}

/// Like v_path_load(), from the text of a .vid file: size bytes.
/// V_ERR_FORMAT.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_load_from_memory(
    text: *const c_char,
    size: usize,
    path: *mut *mut V_PATH,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let path = Out::new(path, "path")?;
        most(size, MAX_TEXT, "size")?;
        // SAFETY: as many bytes, as the header says.
        let mut text = unsafe { slice(text.cast::<u8>(), size, "text") }?;
        let document = Document::load_shown_from(&mut text, "memory")?;
        let made = insert(document)?;
        // SAFETY: room for a handle, as the header says.
        unsafe { path.answer(made) }
    })
}

/// Saves a path to a .vid file, which is replaced atomically and is on the disk when
/// the call returns. Symbolic links are followed and permissions kept.
/// V_ERR_IO.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_save(path: *const V_PATH, file: *const c_char) -> c_int {
    border(V_ERR_INTERNAL, || {
        // SAFETY: a zero-terminated text, as the header says.
        let file = unsafe { file_name(file, "file") }?;
        read(path, |document| Ok(document.save(file)?))?;
        Ok(V_OK)
    })
}

/// Gets the text that v_path_save() would write.
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
