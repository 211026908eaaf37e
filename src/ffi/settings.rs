//! What holds for a whole path: base speeds, closed or open, modes.

use std::ffi::{c_char, c_int};

use super::border::border;
use super::object::{thread_mesh, wireframe};
use super::path::{edit, edit_by, edits, read};
use super::pointers::{GrowingOut, Out, TextOut, copied, numbered, text};
use super::scene_types::V_MESH;
use super::status::{Answer, Failure, V_ERR_INTERNAL, V_OK};
use super::types::V_PATH;
use crate::document::{At, Edit};
use crate::error::{Place, TooMany};
use crate::limits::MAX_COMMENT_BYTES;
use crate::path::camera_path::{check_base_speed, check_name};
use crate::path::{BaseFrames, OrientationMode, ZoomMode};
use crate::property::Value;

/// ==== Modes, see v_path_set_modes() ====
///
/// V_ORIENTATION_TCB            smooth turning with limited speeds; the default
/// V_ORIENTATION_BARRY_GOLDMAN  smooth turning, the curve of Barry and Goldman
/// V_ORIENTATION_SLERP          straight from orientation to orientation
/// V_ZOOM_SMOOTH                smooth and without overshoot; the default
/// V_ZOOM_LINEAR                straight from value to value
pub const V_ORIENTATION_TCB: c_int = 0;
pub const V_ORIENTATION_BARRY_GOLDMAN: c_int = 1;
pub const V_ORIENTATION_SLERP: c_int = 2;
pub const V_ZOOM_SMOOTH: c_int = 0;
pub const V_ZOOM_LINEAR: c_int = 1;

const _: () = assert!(
    OrientationMode::Tcb as c_int == V_ORIENTATION_TCB
        && OrientationMode::BarryGoldman as c_int == V_ORIENTATION_BARRY_GOLDMAN
        && OrientationMode::Slerp as c_int == V_ORIENTATION_SLERP
        && ZoomMode::Smooth as c_int == V_ZOOM_SMOOTH
        && ZoomMode::Linear as c_int == V_ZOOM_LINEAR
);

/// Checks a base speed, which has a name here.
pub(super) fn positive(given: f64, name: &'static str) -> Answer<()> {
    check_base_speed(given).map_err(|_| Failure::NotPositive { name, given })
}

/// A title from C, checked before it is copied, since it may be of any length.
///
/// # Safety
/// `title` is NULL or points to a zero-terminated text.
pub(super) unsafe fn title_of(title: *const c_char) -> Answer<String> {
    // SAFETY: as required of the caller.
    let title = unsafe { text(title, "title") }?;
    check_name(title).map_err(|error| error.at(Place::Title))?;
    copied(title)
}

/// A comment from C, checked in the same way.
///
/// # Safety
/// `comment` is NULL or points to a zero-terminated text.
pub(super) unsafe fn comment_of(comment: *const c_char) -> Answer<String> {
    // SAFETY: as required of the caller.
    let comment = unsafe { text(comment, "comment") }?;
    if comment.len() > MAX_COMMENT_BYTES {
        return Err(TooMany::CommentBytes.into());
    }
    copied(comment)
}

/// ==== What holds for the whole path ====
///
/// Sets the base speeds: the frames that each movement takes at speed 50, finite and >
/// 0; larger is slower.
///
/// move_frames  moving by half_size (v_path_set_space())
/// turn_frames  turning by 180 degrees
/// zoom_frames  zooming from 1 to 100
/// roll_frames  rolling by 90 degrees
/// V_ERR_ARGUMENT.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_set_base_frames(
    path: *mut V_PATH,
    move_frames: f64,
    turn_frames: f64,
    zoom_frames: f64,
    roll_frames: f64,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        positive(move_frames, "move_frames")?;
        positive(turn_frames, "turn_frames")?;
        positive(zoom_frames, "zoom_frames")?;
        positive(roll_frames, "roll_frames")?;
        let speeds = BaseFrames {
            movement: move_frames,
            turning: turn_frames,
            zoom: zoom_frames,
            rolling: roll_frames,
        };
        edit(path, Edit::set(At::Path, "base_speeds", speeds))
    })
}

/// Gets the base speeds.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_get_base_frames(
    path: *const V_PATH,
    move_frames: *mut f64,
    turn_frames: *mut f64,
    zoom_frames: *mut f64,
    roll_frames: *mut f64,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let (movement, turning) = (
            Out::optional(move_frames, "move_frames")?,
            Out::optional(turn_frames, "turn_frames")?,
        );
        let (zoom, rolling) = (
            Out::optional(zoom_frames, "zoom_frames")?,
            Out::optional(roll_frames, "roll_frames")?,
        );
        let speeds = read(path, |document| Ok(document.path().base_frames))?;
        // SAFETY: room for a double each, as the header says.
        unsafe {
            movement.write(speeds.movement);
            turning.write(speeds.turning);
            zoom.write(speeds.zoom);
            rolling.write(speeds.rolling);
        }
        Ok(V_OK)
    })
}

/// Closes a path with one more segment from the last point to the first (not 0), or
/// opens it (0).
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_set_closed(path: *mut V_PATH, closed: c_int) -> c_int {
    border(V_ERR_INTERNAL, || {
        edit(path, Edit::set(At::Path, "closed", closed != 0))
    })
}

/// Gets whether a path is closed: 1 or 0.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_get_closed(path: *const V_PATH, closed: *mut c_int) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = Out::new(closed, "closed")?;
        let closed = read(path, |document| Ok(document.path().closed))?;
        // SAFETY: room for an int, as the header says.
        unsafe { out.answer(c_int::from(closed)) }
    })
}

/// Sets how the camera turns between its orientations (V_ORIENTATION_...) and how the
/// zoom changes (V_ZOOM_...).
/// V_ERR_RANGE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_set_modes(
    path: *mut V_PATH,
    orientation_mode: c_int,
    zoom_mode: c_int,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let turning = numbered(
            &OrientationMode::ALL,
            orientation_mode,
            "orientation_mode",
            "V_ORIENTATION_TCB (0), V_ORIENTATION_BARRY_GOLDMAN (1), V_ORIENTATION_SLERP (2)",
        )?;
        let known = "V_ZOOM_SMOOTH (0), V_ZOOM_LINEAR (1)";
        let zooming = numbered(&ZoomMode::ALL, zoom_mode, "zoom_mode", known)?;
        edits(
            path,
            [
                Edit::set(At::Path, "orientation_mode", turning),
                Edit::set(At::Path, "zoom_mode", zooming),
            ],
        )
    })
}

/// Gets the modes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_get_modes(
    path: *const V_PATH,
    orientation_mode: *mut c_int,
    zoom_mode: *mut c_int,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let (turning, zooming) = (
            Out::optional(orientation_mode, "orientation_mode")?,
            Out::optional(zoom_mode, "zoom_mode")?,
        );
        let (orientation_mode, zoom_mode) = read(path, |document| {
            let path = document.path();
            Ok((path.orientation_mode, path.zoom_mode))
        })?;
        // SAFETY: room for an int each, as the header says.
        unsafe {
            turning.write(orientation_mode as c_int);
            zooming.write(zoom_mode as c_int);
        }
        Ok(V_OK)
    })
}

/// Sets the title: one line of at most 256 bytes; "" removes it.
/// V_ERR_ARGUMENT, V_ERR_LIMIT, V_ERR_MEMORY.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_set_title(path: *mut V_PATH, title: *const c_char) -> c_int {
    border(V_ERR_INTERNAL, || {
        // SAFETY: a zero-terminated text, as the header says.
        let title = unsafe { title_of(title) }?;
        edit(path, Edit::set(At::Path, "title", title))
    })
}

/// Gets the title.
/// V_ERR_SIZE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_get_title(
    path: *const V_PATH,
    title: *mut c_char,
    capacity: usize,
    length: *mut usize,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = TextOut::new(title, capacity, length, "title")?;
        // SAFETY: room as the header says.
        read(path, |document| unsafe {
            out.write(document.info().title.as_bytes())
        })
    })
}

/// Sets the comment: any number of lines; "" removes it.
/// V_ERR_ARGUMENT, V_ERR_LIMIT, V_ERR_MEMORY.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_set_comment(path: *mut V_PATH, comment: *const c_char) -> c_int {
    border(V_ERR_INTERNAL, || {
        // SAFETY: a zero-terminated text, as the header says.
        let comment = unsafe { comment_of(comment) }?;
        edit(path, Edit::set(At::Path, "comment", comment))
    })
}

/// Gets the comment.
/// V_ERR_SIZE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_get_comment(
    path: *const V_PATH,
    comment: *mut c_char,
    capacity: usize,
    length: *mut usize,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = TextOut::new(comment, capacity, length, "comment")?;
        // SAFETY: room as the header says.
        read(path, |document| unsafe {
            out.write(document.info().comment.as_bytes())
        })
    })
}

/// Sets the frame rate in frames per second, > 0 and at most 100000, by default 25.
/// Poses do not change.
/// V_ERR_RANGE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_set_fps(path: *mut V_PATH, fps: f64) -> c_int {
    border(V_ERR_INTERNAL, || {
        edit(path, Edit::set(At::Path, "fps", fps))
    })
}

/// Gets the frame rate.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_get_fps(path: *const V_PATH, fps: *mut f64) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = Out::new(fps, "fps")?;
        let fps = read(path, |document| Ok(document.info().fps))?;
        // SAFETY: room for a double, as the header says.
        unsafe { out.answer(fps) }
    })
}

/// Sets the number of the first pose in the user's film, by default 1. Files in other
/// formats count from it, this library from 1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_set_first_frame(path: *mut V_PATH, number: c_int) -> c_int {
    border(V_ERR_INTERNAL, || {
        let number = Value::Whole(number.into());
        edit(path, Edit::set(At::Path, "first_frame", number))
    })
}

/// Gets the number of the first pose.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_get_first_frame(path: *const V_PATH, number: *mut c_int) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = Out::new(number, "number")?;
        let number = read(path, |document| Ok(document.info().first_frame))?;
        // SAFETY: room for an int, as the header says.
        unsafe { out.answer(number) }
    })
}

/// Sets the object shown with a path; NULL: none. The window draws its lines and the
/// edges of its triangles; beyond 1,000,000 points of lines, only points where they end
/// or bend. v_path_check() uses the triangles.
/// V_ERR_SIZE, V_ERR_ARGUMENT, V_ERR_RANGE, V_ERR_LIMIT, V_ERR_MEMORY.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_set_object(path: *mut V_PATH, object: *const V_MESH) -> c_int {
    border(V_ERR_INTERNAL, || {
        // SAFETY: a mesh, as the header says.
        let object = unsafe { wireframe(object, "object") }?;
        edit_by(path, |document| {
            let mut info = document.info().clone();
            info.object = object;
            Ok(Edit::SetInfo(Box::new(info)))
        })
    })
}

/// Gets the object shown with a path, 0 points without one. The arrays are valid until
/// the same thread's next call of this function or its end.
/// V_ERR_SIZE, V_ERR_MEMORY.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_get_object(path: *const V_PATH, mesh: *mut V_MESH) -> c_int {
    border(V_ERR_INTERNAL, || {
        // SAFETY: a struct as its size says, as the header demands.
        let out = unsafe { GrowingOut::new(mesh, "mesh") }?;
        let object = read(path, |document| Ok(document.info().object.clone()))?;
        let mesh = thread_mesh(object)?;
        // SAFETY: as above.
        unsafe { out.answer(mesh) }
    })
}
