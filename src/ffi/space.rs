//! The space of a path in the host's world, and the host's camera as an orientation.

use std::ffi::c_int;

use glam::DVec3;

use super::border::border;
use super::path::{edit, insert, read};
use super::pointers::{self, Growing, GrowingOut, Out, init, optional, read_growing, read_vector};
use super::quaternions::view;
use super::status::{Answer, Failure, Name, V_ERR_INTERNAL, V_OK};
use super::types::{V_ORIENTATION, V_PATH, V_POSE, V_SPACE, V_UP_Y, V_UP_Z};
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

const fn up_to_c(up: Up) -> c_int {
    match up {
        Up::Y => V_UP_Y,
        Up::Z => V_UP_Z,
    }
}

// SAFETY: `repr(C)` with `size` first; numbers only.
unsafe impl Growing for V_SPACE {
    const NAME: &'static str = "V_SPACE";
    const FIRST: usize = size_of::<V_SPACE>();
    const DEFAULTS: Self = Self {
        size: size_of::<V_SPACE>(),
        centre: [0.0; 3],
        half_size: 1.0,
        up: V_UP_Y,
    };
}

/// A space from C, checked; `None` for NULL.
///
/// # Safety
/// `space` is NULL or points to a struct as its `size` says.
pub(super) unsafe fn optional_space(space: *const V_SPACE) -> Answer<Option<Space>> {
    // SAFETY: as required of the caller.
    let given = optional(space, |space| unsafe { read_growing(space, "space") })?;
    given.as_ref().map(checked).transpose()
}

pub(super) fn checked(given: &V_SPACE) -> Answer<Space> {
    let space = Space {
        centre: given.centre.into(),
        half_size: given.half_size,
        up: up_from_c(given.up, Name::Field("space", "up"))?,
    };
    space.check()?;
    Ok(space)
}

/// A space from its numbers, not checked.
///
/// # Safety
/// `centre` is NULL or points to three readable doubles.
pub(super) unsafe fn space(centre: *const f64, half_size: f64, up: c_int) -> Answer<Space> {
    Ok(Space {
        // SAFETY: as required of the caller.
        centre: unsafe { read_vector(centre, "centre") }?,
        half_size,
        up: up_from_c(up, "up")?,
    })
}

/// The destinations of a space, each of which may be NULL.
pub(super) struct SpaceOut(Out<[f64; 3]>, Out<f64>, Out<c_int>);

impl SpaceOut {
    pub(super) fn new(centre: *mut f64, half_size: *mut f64, up: *mut c_int) -> Answer<Self> {
        let centre = Out::optional_array(centre, "centre")?;
        Ok(Self(
            centre,
            Out::optional(half_size, "half_size")?,
            Out::optional(up, "up")?,
        ))
    }

    /// # Safety
    /// There is room for three doubles, a double and an int where not NULL.
    pub(super) unsafe fn answer(self, space: Space) -> Answer<c_int> {
        // SAFETY: as required of the caller.
        unsafe {
            self.0.write(space.centre.to_array());
            self.1.write(space.half_size);
            self.2.write(up_to_c(space.up));
        }
        Ok(V_OK)
    }
}

/// ==== Where a path lies ====
///
/// Sets the space of a path: a cube in your world; coordinates do not change.
///
/// centre  (0, 0, 0) in a new path
/// half_size  half the length of its edge, 1e-30 to 1e30; 1 in a new path. Centre,
///     points and targets are at most 1e9 times as far away
/// up  V_UP_Y, as in a new path, or V_UP_Z
///
/// Positions, offsets, tangents and lengths of a path are in your world's units. Base
/// frames, limits (v_path_check()) and the distances below which nothing
/// moves count in units of half_size.
/// V_ERR_ARGUMENT, V_ERR_RANGE.
/// cbindgen:ptrs-as-arrays=[[centre; 3]]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_set_space(
    path: *mut V_PATH,
    centre: *const f64,
    half_size: f64,
    up: c_int,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        // SAFETY: three doubles, as the header says.
        let space = unsafe { space(centre, half_size, up) }?;
        edit(path, Edit::SetSpace { space, fit: false })
    })
}

/// Gets the space.
/// cbindgen:ptrs-as-arrays=[[centre; 3]]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_get_space(
    path: *const V_PATH,
    centre: *mut f64,
    half_size: *mut f64,
    up: *mut c_int,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = SpaceOut::new(centre, half_size, up)?;
        let space = read(path, |document| Ok(document.path().space))?;
        // SAFETY: room as the header says.
        unsafe { out.answer(space) }
    })
}

/// Fills in a space: centre (0, 0, 0), half_size 1, V_UP_Y.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_space_init(space: *mut V_SPACE) {
    border((), || {
        // SAFETY: room for the struct of version 1.0, as the header says.
        unsafe { init(space, V_SPACE::DEFAULTS, V_SPACE::FIRST, "space") }
    });
}

/// Like v_space_init(), for a struct of size bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_space_init_sized(space: *mut V_SPACE, size: usize) {
    border((), || {
        // SAFETY: room for that much of the struct, as the header says.
        unsafe { init(space, V_SPACE::DEFAULTS, size, "space") }
    });
}

/// Makes a new path in a space, placed as that of v_path_new() is in its own, as in a
/// new window with this space. NULL: like v_path_new().
/// V_ERR_SIZE, V_ERR_ARGUMENT, V_ERR_RANGE, V_ERR_MEMORY, V_ERR_LIMIT.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_new_in_space(
    space: *const V_SPACE,
    path: *mut *mut V_PATH,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = Out::new(path, "path")?;
        // SAFETY: a space, as the header says.
        let space = unsafe { optional_space(space) }?.unwrap_or_default();
        let mut document = Document::try_new()?;
        document.apply(Edit::SetSpace { space, fit: true })?;
        let made = insert(document)?;
        // SAFETY: room for a handle, as the header says.
        unsafe { out.answer(made) }
    })
}

/// Changes the up axis of a path (V_UP_Y, V_UP_Z) without changing any pose, between
/// frames too. Rolls are then measured from the new axis. Views that track a target or
/// look ahead get the old axis as their up, "y" or "z" (v_path_set_up()); one that
/// equals the new axis becomes "axis".
/// V_ERR_RANGE, V_ERR_MEMORY.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_change_up(path: *mut V_PATH, up: c_int) -> c_int {
    border(V_ERR_INTERNAL, || {
        edit(path, Edit::ChangeUp(up_from_c(up, "up")?))
    })
}

/// Makes an orientation look like the camera of a pose, for a path with this up axis
/// (V_UP_Y, V_UP_Z): sets a relative target, the pose's vpn, and roll and zoom.
/// Everything else in *orientation is unchanged: call v_orientation_init() before. vpn
/// and vup have any length but 0 and are not parallel.
/// V_ERR_SIZE, V_ERR_ARGUMENT, V_ERR_RANGE.
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
