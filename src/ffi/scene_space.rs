//! Where a scene lies in the host's world.

use std::ffi::c_int;

use super::border::border;
use super::scene_handles::{edit, read};
use super::scene_types::V_SCENE;
use super::space::{SpaceOut, space};
use super::status::{V_ERR_INTERNAL, V_OK};

/// Sets the space, like v_path_set_space(); up applies to nodes that aim at others.
/// Values of nodes do not change; a path in the scene has its own space.
/// V_ERR_ARGUMENT, V_ERR_RANGE.
/// cbindgen:ptrs-as-arrays=[[centre; 3]]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_set_space(
    scene: *mut V_SCENE,
    centre: *const f64,
    half_size: f64,
    up: c_int,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        // SAFETY: three doubles, as the header says.
        let space = unsafe { space(centre, half_size, up) }?;
        edit(scene, |document| {
            document.info.check(space)?;
            document.scene.set_space(space)?;
            Ok(V_OK)
        })
    })
}

/// Gets the space.
/// cbindgen:ptrs-as-arrays=[[centre; 3]]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_get_space(
    scene: *const V_SCENE,
    centre: *mut f64,
    half_size: *mut f64,
    up: *mut c_int,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = SpaceOut::new(centre, half_size, up)?;
        let space = read(scene, |document| Ok(document.scene.space()))?;
        // SAFETY: room as the header says.
        unsafe { out.answer(space) }
    })
}
