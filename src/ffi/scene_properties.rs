//! Properties of scenes and their nodes by name.

use std::ffi::{c_char, c_int};

use super::border::border;
use super::by_name::{by_name, get, get_numbers, get_text, numbers_given, set, text_given};
use super::pointers::{index, text};
use super::properties::thread_key;
use super::scene_handles;
use super::scene_types::V_SCENE;
use crate::document::{Given, SceneDocument};

/// Returns the name of a property of a node, counted from 0, like v_path_key():
/// v_scene_key(1, "intensity") is "node.2.intensity".
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_key(node: c_int, key: *const c_char) -> *const c_char {
    border(c"".as_ptr(), || {
        // SAFETY: a zero-terminated text, as the header says.
        let (key, node) = (unsafe { text(key, "key") }?, index(node, "node")? + 1);
        Ok(thread_key(format_args!("node.{node}.{key}")))
    })
}

/// The same functions for scenes. name is "fps", "first_frame", "space.half_size", a
/// limit, or a value of a node at rest by its name or its number from 1:
/// "node.lamp.intensity", "node.2.intensity".
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_set_number(
    scene: *mut V_SCENE,
    name: *const c_char,
    value: f64,
) -> c_int {
    // SAFETY: as the header says.
    unsafe { set(name, || Ok(Given::Number(value)), setter(scene)) }
}

/// See v_path_get_number().
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_get_number(
    scene: *const V_SCENE,
    name: *const c_char,
    value: *mut f64,
) -> c_int {
    // SAFETY: as the header says.
    unsafe { get(name, value, getter(scene, number)) }
}

/// See v_path_set_numbers().
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_set_numbers(
    scene: *mut V_SCENE,
    name: *const c_char,
    values: *const f64,
    count: usize,
) -> c_int {
    // SAFETY: as the header says.
    unsafe { set(name, || numbers_given(values, count), setter(scene)) }
}

/// See v_path_get_numbers().
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_get_numbers(
    scene: *const V_SCENE,
    name: *const c_char,
    values: *mut f64,
    capacity: usize,
    count: *mut usize,
) -> c_int {
    // SAFETY: as the header says.
    unsafe {
        get_numbers(
            name,
            values,
            capacity,
            count,
            getter(scene, SceneDocument::numbers_of),
        )
    }
}

/// See v_path_set_text().
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_set_text(
    scene: *mut V_SCENE,
    name: *const c_char,
    value: *const c_char,
) -> c_int {
    // SAFETY: as the header says.
    unsafe { set(name, || text_given(value), setter(scene)) }
}

/// See v_path_get_text().
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_get_text(
    scene: *const V_SCENE,
    name: *const c_char,
    value: *mut c_char,
    capacity: usize,
    length: *mut usize,
) -> c_int {
    // SAFETY: as the header says.
    unsafe {
        get_text(
            name,
            value,
            capacity,
            length,
            getter(scene, SceneDocument::text_of),
        )
    }
}

/// See v_path_set_flag().
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_set_flag(
    scene: *mut V_SCENE,
    name: *const c_char,
    value: c_int,
) -> c_int {
    // SAFETY: as the header says.
    unsafe { set(name, || Ok(Given::Flag(value != 0)), setter(scene)) }
}

/// See v_path_get_flag().
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_get_flag(
    scene: *const V_SCENE,
    name: *const c_char,
    value: *mut c_int,
) -> c_int {
    // SAFETY: as the header says.
    unsafe { get(name, value, getter(scene, flag)) }
}

by_name!(
    V_SCENE,
    SceneDocument,
    scene_handles::read,
    scene_handles::edit
);
