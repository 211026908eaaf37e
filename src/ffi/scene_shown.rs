//! What is shown of scenes, and the parents of nodes.

use std::ffi::c_int;

use super::border::border;
use super::pointers::{Out, index};
use super::scene::{link, unlink};
use super::scene_handles::{change, read};
use super::scene_types::*;
use super::status::{Answer, Failure, V_ERR_INTERNAL};
use crate::scene::Keep;

/// Sets the camera that is shown; -1: the first one on a path, else the first one. The
/// choice follows the node, is removed with it, and is saved.
/// V_ERR_ARGUMENT (no camera).
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

/// Sets the first and last frame; if first > last, they follow from all paths and
/// keys. They are saved.
/// V_ERR_LIMIT (more than 100000000 frames).
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

/// Sets the parent of a node; -1: no parent. keep is V_KEEP_PLACE (its place in the
/// world at the scene's first frame) or V_KEEP_NUMBERS (its values, path and tracks).
/// V_ERR_ARGUMENT (such as a cycle).
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
