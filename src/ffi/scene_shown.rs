//! Titles of scenes, what is shown of them, and the parents of nodes.

use std::ffi::{c_char, c_int};

use super::border::border;
use super::pointers::{Out, TextOut, index, text};
use super::scene::{link, unlink};
use super::scene_handles::{change, edit, read, set_info};
use super::scene_types::*;
use super::settings::{comment_of, title_of};
use super::status::{Answer, Failure, V_ERR_INTERNAL, V_OK};
use crate::property::Value;
use crate::scene::Keep;
use crate::tools::check::FindingKind;

/// ==== What a scene is called ====
///
/// Sets the title, like v_path_set_title().
/// V_ERR_ARGUMENT, V_ERR_LIMIT, V_ERR_MEMORY.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_set_title(scene: *mut V_SCENE, title: *const c_char) -> c_int {
    border(V_ERR_INTERNAL, || {
        // SAFETY: a zero-terminated text, as the header says.
        set_info(scene, "title", unsafe { title_of(title) }?)
    })
}

/// Gets the title.
/// V_ERR_SIZE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_get_title(
    scene: *const V_SCENE,
    title: *mut c_char,
    capacity: usize,
    length: *mut usize,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = TextOut::new(title, capacity, length, "title")?;
        // SAFETY: room as the header says.
        read(scene, |document| unsafe {
            out.write(document.info.title.as_bytes())
        })
    })
}

/// Sets the comment, like v_path_set_comment().
/// V_ERR_ARGUMENT, V_ERR_LIMIT, V_ERR_MEMORY.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_set_comment(scene: *mut V_SCENE, comment: *const c_char) -> c_int {
    border(V_ERR_INTERNAL, || {
        // SAFETY: a zero-terminated text, as the header says.
        set_info(scene, "comment", unsafe { comment_of(comment) }?)
    })
}

/// Gets the comment.
/// V_ERR_SIZE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_get_comment(
    scene: *const V_SCENE,
    comment: *mut c_char,
    capacity: usize,
    length: *mut usize,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = TextOut::new(comment, capacity, length, "comment")?;
        // SAFETY: room as the header says.
        read(scene, |document| unsafe {
            out.write(document.info.comment.as_bytes())
        })
    })
}

/// Sets the frame rate, like v_path_set_fps(). Positions at frames do not change.
/// V_ERR_RANGE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_set_fps(scene: *mut V_SCENE, fps: f64) -> c_int {
    border(V_ERR_INTERNAL, || set_info(scene, "fps", fps))
}

/// Gets the frame rate.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_get_fps(scene: *const V_SCENE, fps: *mut f64) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = Out::new(fps, "fps")?;
        let fps = read(scene, |document| Ok(document.info.fps))?;
        // SAFETY: room for a double, as the header says.
        unsafe { out.answer(fps) }
    })
}

/// Sets the number shown to users for frame 1, by default 1. This library always uses
/// the scene's own frames.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_set_first_frame(scene: *mut V_SCENE, number: c_int) -> c_int {
    border(V_ERR_INTERNAL, || {
        set_info(scene, "first_frame", Value::Whole(number.into()))
    })
}

/// Gets the number shown to users for frame 1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_get_first_frame(
    scene: *const V_SCENE,
    number: *mut c_int,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = Out::new(number, "number")?;
        let number = read(scene, |document| Ok(document.info.first_frame))?;
        // SAFETY: room for an int, as the header says.
        unsafe { out.answer(number) }
    })
}

/// Sets the limit of a finding, like v_path_set_limit().
/// V_ERR_ARGUMENT (no such kind), V_ERR_RANGE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_set_limit(
    scene: *mut V_SCENE,
    kind: *const c_char,
    limit: f64,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        // SAFETY: a zero-terminated text, as the header says.
        let kind = FindingKind::parse(unsafe { text(kind, "kind") }?)?;
        edit(scene, |document| {
            document.info.limits.set(kind, limit)?;
            Ok(V_OK)
        })
    })
}

/// Gets the limit of a finding.
/// V_ERR_ARGUMENT (no such kind).
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_get_limit(
    scene: *const V_SCENE,
    kind: *const c_char,
    limit: *mut f64,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = Out::new(limit, "limit")?;
        // SAFETY: a zero-terminated text, as the header says.
        let kind = FindingKind::parse(unsafe { text(kind, "kind") }?)?;
        let limit = read(scene, |document| Ok(document.info.limits.get(kind)))?;
        // SAFETY: room for a double, as the header says.
        unsafe { out.answer(limit) }
    })
}

/// ==== What is shown of a scene ====
///
/// Sets the camera that is shown; -1: the first one on a path, else the first one. The
/// choice follows the node, is removed with it, and is saved.
/// V_ERR_ARGUMENT (no camera), V_ERR_RANGE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_set_camera(scene: *mut V_SCENE, node: c_int) -> c_int {
    border(V_ERR_INTERNAL, || {
        let node = link(node, "node")?;
        change(scene, |scene| scene.set_camera(node))
    })
}

/// Gets the camera that is shown; -1: none.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_get_camera(scene: *const V_SCENE, node: *mut c_int) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = Out::new(node, "node")?;
        let shown = read(scene, |document| unlink(document.scene.shown_camera()))?;
        // SAFETY: room for an int, as the header says.
        unsafe { out.answer(shown) }
    })
}

/// Sets the first and last frame; if first > last, they follow from all paths and keys.
/// They are saved.
/// V_ERR_ARGUMENT, V_ERR_RANGE, V_ERR_LIMIT (more than 100000000 frames).
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_set_range(scene: *mut V_SCENE, first: f64, last: f64) -> c_int {
    border(V_ERR_INTERNAL, || {
        let range = if first > last {
            None
        } else {
            Some((first, last))
        };
        change(scene, |scene| scene.set_range(range))
    })
}

/// Sets the parent of a node; -1: no parent.
///
/// keep  V_KEEP_PLACE: its place in the world at the scene's first frame, as in
///     v_scene_set_node(). V_KEEP_NUMBERS: its values, path and tracks; it moves with
///     its new parent
/// V_ERR_ARGUMENT (such as a cycle), V_ERR_RANGE, V_ERR_LIMIT, V_ERR_MEMORY.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_set_parent(
    scene: *mut V_SCENE,
    node: c_int,
    parent: c_int,
    keep: c_int,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let (node, parent) = (index(node, "node")?, link(parent, "parent")?);
        let keep = self::keep(keep)?;
        change(scene, |scene| scene.set_parent(node, parent, keep))
    })
}

fn keep(keep: c_int) -> Answer<Keep> {
    match keep {
        V_KEEP_PLACE => Ok(Keep::Place),
        V_KEEP_NUMBERS => Ok(Keep::Numbers),
        _ => Err(Failure::unknown(
            "keep",
            keep,
            "V_KEEP_PLACE (0), V_KEEP_NUMBERS (1)",
        )),
    }
}
