//! The space of a path in the host's world, and the host's camera as an orientation.

use std::ffi::c_int;

use glam::DVec3;

use super::border::border;
use super::path::{edit, insert};
use super::pointers::{self, GrowingOut, Out, read_growing, read_vector};
use super::quaternions::view;
use super::status::{Answer, Failure, Name, V_ERR_INTERNAL};
use super::types::{V_ORIENTATION, V_PATH, V_POSE, V_UP_Y, V_UP_Z};
use crate::document::{Document, Edit};
use crate::path::camera_path::check_zoom;
use crate::path::{Space, Up};

pub(super) fn up_from_c(up: c_int, name: impl Into<Name>) -> Answer<Up> {
    match up {
        V_UP_Y => Ok(Up::Y),
        V_UP_Z => Ok(Up::Z),
        _ => Err(Failure::unknown(name, up, "V_UP_Y (1), V_UP_Z (2)")),
    }
}

/// ==== Spaces: the scale and the up axis of a path ====
///
/// Makes a new path in a space, a cube in your world, placed as that of v_path_new()
/// is in its own. half_size is half the length of its edge, up V_UP_Y or V_UP_Z.
///
/// The properties "space.centre", "space.half_size" and "space.up" change the space
/// of a path or scene, not its coordinates. Base speeds, default limits and the
/// distances below which nothing moves are relative to half_size; nothing is farther
/// than 1e9 times half_size from the centre. In a scene, "space.up" applies to nodes
/// that aim at others; a path in it has its own space.
/// cbindgen:ptrs-as-arrays=[[centre; 3]]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_new_in_space(
    centre: *const f64,
    half_size: f64,
    up: c_int,
    path: *mut *mut V_PATH,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = Out::new(path, "path")?;
        let space = Space {
            // SAFETY: three doubles, as the header says.
            centre: unsafe { read_vector(centre, "centre") }?,
            half_size,
            up: up_from_c(up, "up")?,
        };
        let mut document = Document::try_new()?;
        document.apply(Edit::SetSpace { space, fit: true })?;
        let made = insert(document)?;
        // SAFETY: room for a handle, as the header says.
        unsafe { out.answer(made) }
    })
}

/// Changes the up axis of a path (V_UP_Y, V_UP_Z) without changing any pose. Rolls
/// are then measured from the new axis. Views that track a target or look ahead get
/// the old axis as their up, "y" or "z"; one that equals the new axis becomes "axis".
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_change_up(path: *mut V_PATH, up: c_int) -> c_int {
    border(V_ERR_INTERNAL, || {
        edit(path, Edit::ChangeUp(up_from_c(up, "up")?))
    })
}

/// Makes an orientation look like the camera of a pose, for a path with this up axis
/// (V_UP_Y, V_UP_Z): sets a relative target, the pose's vpn, and roll and zoom. The
/// rest of *orientation is unchanged: call v_orientation_init() before. vpn and vup
/// have any length but 0 and are not parallel.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_orientation_from_pose(
    pose: *const V_POSE,
    up: c_int,
    orientation: *mut V_ORIENTATION,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        // SAFETY: a pose, and a struct as its size says, as the header demands.
        let (out, mut result) = unsafe {
            (
                GrowingOut::new(orientation, "orientation")?,
                read_growing(orientation, "orientation")?,
            )
        };
        // SAFETY: as above.
        let pose = unsafe { pointers::read(pose, "pose") }?;
        let axes = up_from_c(up, "up")?;
        check_zoom(pose.zoom)?;
        let [vpn, vup] = [pose.vpn, pose.vup].map(DVec3::from_array);
        let (view, up) = view(vpn, vup)?;
        result.absolute = 0;
        result.target = view.to_array();
        result.roll = axes.roll_from_up(view, up).to_degrees();
        result.zoom = pose.zoom;
        // SAFETY: as above.
        unsafe { out.answer(result) }
    })
}
