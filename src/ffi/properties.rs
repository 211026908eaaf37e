//! Properties of a path by the names of their keys in files.

use std::ffi::{c_char, c_int};

use super::border::border;
use super::path::{change, read};
use super::pointers::{TextOut, text};
use super::status::{V_ERR_INTERNAL, V_OK};
use super::types::V_PATH;

/// ==== Properties by name ====
///
/// Sets a property of a path by its name, like `vides set`, atomically.
///
/// name  a key of .vid files (docs/reference/files.md), points and orientations counted from 1:
///     "closed", "point.2.position", "point.2.zoom" (of its first orientation),
///     "point.2.view.3.zoom" and so on
/// value  as in the file: "30" or "[0, 1, 2]". Text needs no quotes; "" restores the
///     value of a new path
/// V_ERR_RANGE (no such property), V_ERR_ARGUMENT (not a value for it), V_ERR_LIMIT,
/// V_ERR_MEMORY.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_set_property(
    path: *mut V_PATH,
    name: *const c_char,
    value: *const c_char,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        // SAFETY: zero-terminated texts, as the header says.
        let (name, value) = unsafe { (text(name, "name")?, text(value, "value")?) };
        change(path, |document| Ok(document.set_property(name, value)?))?;
        Ok(V_OK)
    })
}

/// Gets the value of a property as in a .vid file, "" if it has none.
/// V_ERR_SIZE, V_ERR_ARGUMENT, V_ERR_RANGE (no such property), V_ERR_MEMORY.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_get_property(
    path: *const V_PATH,
    name: *const c_char,
    value: *mut c_char,
    capacity: usize,
    length: *mut usize,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = TextOut::new(value, capacity, length, "value")?;
        // SAFETY: a zero-terminated text, as the header says.
        let name = unsafe { text(name, "name") }?;
        let value = read(path, |document| Ok(document.property(name)?))?;
        // SAFETY: room as the header says.
        unsafe { out.write(value.as_bytes()) }
    })
}
