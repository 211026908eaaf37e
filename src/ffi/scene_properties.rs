//! Properties of scenes and their nodes by name.

use std::ffi::{c_char, c_int};

use super::border::border;
use super::pointers::{ArrayOut, Out, TextOut, index, text};
use super::properties::{answer_numbers, named, thread_key, value_numbers, value_text};
use super::scene_handles::{edit, read};
use super::scene_types::V_SCENE;
use super::status::{Answer, V_ERR_INTERNAL, V_OK};
use crate::document::Given;

/// ==== Properties of scenes by name ====
///
/// Returns the name of a property of a node, counted from 0, for loops, like
/// v_path_key(): v_scene_key(1, "intensity") is "node.2.intensity".
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_key(node: c_int, key: *const c_char) -> *const c_char {
    border(c"".as_ptr(), || {
        // SAFETY: a zero-terminated text, as the header says.
        let (key, node) = (unsafe { text(key, "key") }?, index(node, "node")? + 1);
        Ok(thread_key(format_args!("node.{node}.{key}")))
    })
}

/// Sets a number of a scene by its name, like v_path_set_number().
///
/// name  "fps", "first_frame", a limit, "check.turning", or a value of a node at rest by its
///     name or its number from 1: "node.lamp.intensity", "node.2.intensity".
///     docs/reference/files.md lists them; v_scene_key() makes names of indices
/// V_ERR_RANGE, V_ERR_ARGUMENT, V_ERR_LIMIT, V_ERR_MEMORY.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_set_number(
    scene: *mut V_SCENE,
    name: *const c_char,
    value: f64,
) -> c_int {
    // SAFETY: a zero-terminated text, as the header says.
    unsafe { set(scene, name, || Ok(Given::Number(value))) }
}

/// Gets a number by its name; NaN if it is not set.
/// V_ERR_RANGE, V_ERR_ARGUMENT, V_ERR_MEMORY.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_get_number(
    scene: *const V_SCENE,
    name: *const c_char,
    value: *mut f64,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = Out::new(value, "value")?;
        // SAFETY: a zero-terminated text, as the header says.
        let name = unsafe { text(name, "name") }?;
        let number = read(scene, |document| named(document.number_of(name)))?;
        // SAFETY: room for a double, as the header says.
        unsafe { out.answer(number.unwrap_or(f64::NAN)) }
    })
}

/// Sets several numbers by their name, like v_path_set_numbers(): "node.lamp.colour".
/// V_ERR_RANGE, V_ERR_ARGUMENT, V_ERR_LIMIT, V_ERR_MEMORY.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_set_numbers(
    scene: *mut V_SCENE,
    name: *const c_char,
    values: *const f64,
    count: usize,
) -> c_int {
    // SAFETY: a zero-terminated text and so many doubles, as the header says.
    unsafe { set(scene, name, || value_numbers(values, count)) }
}

/// Gets several numbers by their name.
/// V_ERR_RANGE, V_ERR_ARGUMENT, V_ERR_SIZE, V_ERR_MEMORY.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_get_numbers(
    scene: *const V_SCENE,
    name: *const c_char,
    values: *mut f64,
    capacity: usize,
    count: *mut usize,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = ArrayOut::new(values, capacity, count, ["values", "count"])?;
        // SAFETY: a zero-terminated text, as the header says.
        let name = unsafe { text(name, "name") }?;
        let numbers = read(scene, |document| named(document.numbers_of(name)))?;
        // SAFETY: room for so many doubles and a size_t, as the header says.
        unsafe { answer_numbers(out, &numbers) }
    })
}

/// Sets a text by its name, like v_path_set_text(): "title", "comment".
/// V_ERR_RANGE, V_ERR_ARGUMENT, V_ERR_LIMIT, V_ERR_MEMORY.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_set_text(
    scene: *mut V_SCENE,
    name: *const c_char,
    value: *const c_char,
) -> c_int {
    // SAFETY: zero-terminated texts, as the header says.
    unsafe { set(scene, name, || value_text(value)) }
}

/// Gets a text by its name, like v_path_get_text().
/// V_ERR_RANGE, V_ERR_ARGUMENT, V_ERR_SIZE, V_ERR_MEMORY.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_get_text(
    scene: *const V_SCENE,
    name: *const c_char,
    value: *mut c_char,
    capacity: usize,
    length: *mut usize,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = TextOut::new(value, capacity, length, "value")?;
        // SAFETY: a zero-terminated text, as the header says.
        let name = unsafe { text(name, "name") }?;
        let value = read(scene, |document| named(document.text_of(name)))?;
        // SAFETY: room as the header says.
        unsafe { out.write(value.as_bytes()) }
    })
}

/// Sets a flag by its name, not 0 or 0: "node.lamp.visible".
/// V_ERR_RANGE, V_ERR_ARGUMENT, V_ERR_MEMORY.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_set_flag(
    scene: *mut V_SCENE,
    name: *const c_char,
    value: c_int,
) -> c_int {
    // SAFETY: a zero-terminated text, as the header says.
    unsafe { set(scene, name, || Ok(Given::Flag(value != 0))) }
}

/// Gets a flag by its name: 1 or 0.
/// V_ERR_RANGE, V_ERR_ARGUMENT, V_ERR_MEMORY.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_get_flag(
    scene: *const V_SCENE,
    name: *const c_char,
    value: *mut c_int,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = Out::new(value, "value")?;
        // SAFETY: a zero-terminated text, as the header says.
        let name = unsafe { text(name, "name") }?;
        let on = read(scene, |document| named(document.flag_of(name)))?;
        // SAFETY: room for an int, as the header says.
        unsafe { out.answer(c_int::from(on)) }
    })
}

/// Sets a property of a scene.
///
/// # Safety
/// `name` is NULL or points to a zero-terminated text.
unsafe fn set<'a>(
    scene: *mut V_SCENE,
    name: *const c_char,
    given: impl FnOnce() -> Answer<Given<'a>>,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        // SAFETY: as required of the caller.
        let (name, given) = (unsafe { text(name, "name") }?, given()?);
        edit(scene, |document| named(document.set_value(name, given)))?;
        Ok(V_OK)
    })
}
