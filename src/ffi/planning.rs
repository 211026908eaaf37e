//! How a path is flown, planned.

use std::ffi::c_int;

use super::border::border;
use super::path::edit_by;
use super::pointers::{Growing, index, init, optional, read_growing};
use super::scene_tracks::mesh;
use super::scene_types::V_MESH;
use super::status::{Answer, Failure, V_ERR_INTERNAL, add_last_warning, clear_last_warning};
use super::types::{V_LIMITS, V_PATH};
use crate::document::Edit;
use crate::error::can_allocate;
use crate::path::CameraPath;
use crate::planner::{Request, What, retime};
use crate::tools::check::{FindingKind, Limits, OFF};

// SAFETY: a number of bytes first, then doubles.
unsafe impl Growing for V_LIMITS {
    const NAME: &'static str = "V_LIMITS";
    const FIRST: usize = size_of::<V_LIMITS>();
    const DEFAULTS: Self = Self {
        size: size_of::<V_LIMITS>(),
        speed: 0.0,
        acceleration: 10.0,
        jerk: 0.0,
        turning: 60.0,
        turning_acceleration: 300.0,
        zoom: 30.0,
        crossing: 0.0,
    };
}

fn limits(given: &V_LIMITS) -> Answer<Limits> {
    let mut limits = Limits::default();
    for (kind, limit) in [
        (FindingKind::Speed, given.speed),
        (FindingKind::Acceleration, given.acceleration),
        (FindingKind::Jerk, given.jerk),
        (FindingKind::Turning, given.turning),
        (FindingKind::TurningAcceleration, given.turning_acceleration),
        (FindingKind::Zoom, given.zoom),
        (FindingKind::Crossing, given.crossing),
    ] {
        limits.set(kind, if limit == 0.0 { OFF } else { limit })?;
    }
    Ok(limits)
}

/// ==== Planning ====
///
/// Fills in the limits that a check has unless told (v_path_check()): acceleration 10,
/// turning 60, turning_acceleration 300, zoom 30, and no others. NULL does nothing but
/// set v_last_error(). In C a macro of this name hands the struct's size on to
/// v_limits_init_sized(); the function itself, for other languages, fills in the struct
/// of version 1.0.
/// Any thread; from callbacks too.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_limits_init(limits: *mut V_LIMITS) {
    border((), || {
        // SAFETY: room for the struct of version 1.0, as the header says.
        unsafe { init(limits, V_LIMITS::DEFAULTS, V_LIMITS::FIRST, "limits") }
    });
}

/// As v_limits_init(), for a struct that is size bytes long. One shorter than in version
/// 1.0 stays as it is, and v_last_error() says so. What is behind the fields that the
/// library knows is not touched, and size is set to what was filled in.
/// Any thread; from callbacks too.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_limits_init_sized(limits: *mut V_LIMITS, size: usize) {
    border((), || {
        // SAFETY: room for so much of the struct, as the header says.
        unsafe { init(limits, V_LIMITS::DEFAULTS, size, "limits") }
    });
}

/// Computes the pace anew from the first orientation of one support point to the last
/// of another, as fast as the limits allow; the curve and the views stay where they
/// were in place. The way rests at the ends of an open path, where keys are held, and
/// where curve or view have a kink; v_last_warning() names these. What is beside the
/// points keeps its pace. Sections get fixed frames, a given distance and a curve time
/// of their own.
///
/// limits  see v_limits_init(); NULL: the path's own, see v_path_set_limit()
/// first_point, last_point  0 and the last: all, closed paths with the way back to
///     the first point; on a closed path first_point may lie behind last_point
/// seconds  0: as few as the limits allow; else exactly so many, to a whole frame, with
///     the lowest peaks
/// Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_SIZE,
/// V_ERR_ARGUMENT (no limit, one that is not positive, too few seconds: v_last_error()
/// names the least), V_ERR_RANGE, V_ERR_LIMIT, V_ERR_MEMORY.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_retime(
    path: *mut V_PATH,
    limits: *const V_LIMITS,
    first_point: c_int,
    last_point: c_int,
    seconds: f64,
) -> c_int {
    clear_last_warning();
    border(V_ERR_INTERNAL, || {
        // SAFETY: a struct as its size says, as the header says.
        let given = optional(limits, |limits| unsafe { read_growing(limits, "limits") })?;
        let given = given.as_ref().map(self::limits).transpose()?;
        let points = [
            index(first_point, "first_point")?,
            index(last_point, "last_point")?,
        ];
        edit_by(path, |document| {
            let request = Request {
                limits: given.unwrap_or(document.info().limits),
                fps: document.info().fps,
                points: Some(points),
                seconds,
            };
            let made = retime(document.path(), &request)?;
            for rest in &made.rests {
                add_last_warning(format_args!("{rest}"));
            }
            can_allocate(size_of::<CameraPath>())?;
            Ok(Edit::ReplacePath(Box::new(made.path)))
        })
    })
}

/// By what v_path_keep_in_picture() keeps an object in the picture: the zoom, moving the
/// camera along its view, turning the camera.
pub const V_PICTURE_ZOOM: c_int = 0;
pub const V_PICTURE_DISTANCE: c_int = 1;
pub const V_PICTURE_VIEW: c_int = 2;

/// Keeps an object whole in the picture less margin, at every frame and between: by the
/// zoom or the distance as large as that allows and the path's limits of zoom, or of
/// speed and acceleration (see v_path_set_limit()), let it change; by turning no more
/// than it takes. Frames and pace stay. Where keys do not hold it points are added.
/// The path stays as it is where that cannot be.
///
/// object  in the coordinates of the path; NULL: the path's own, with the objects of
///     its scene
/// margin  the share of the picture's width and height (36 x 24 mm) that stays free at
///     each side, from 0 to below 0.5
/// what  V_PICTURE_ZOOM, V_PICTURE_DISTANCE or V_PICTURE_VIEW
/// Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_ARGUMENT (no object,
/// or where it cannot be whole, with the frame), V_ERR_RANGE, V_ERR_SIZE, V_ERR_LIMIT,
/// V_ERR_MEMORY.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_keep_in_picture(
    path: *mut V_PATH,
    object: *const V_MESH,
    margin: f64,
    what: c_int,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        // SAFETY: a mesh, as the header says.
        let object = optional(object, |object| unsafe { mesh(object, "object") })?;
        let what = match what {
            V_PICTURE_ZOOM => What::Zoom,
            V_PICTURE_DISTANCE => What::Distance,
            V_PICTURE_VIEW => What::View,
            _ => {
                let known = "V_PICTURE_ZOOM (0), V_PICTURE_DISTANCE (1), V_PICTURE_VIEW (2)";
                return Err(Failure::unknown("what", what, known));
            }
        };
        edit_by(path, |document| {
            let object = document.clearance(object.as_ref())?;
            let limits = document.info().limits;
            let made = document.framed(object.as_ref(), (margin, what), limits)?;
            can_allocate(size_of::<CameraPath>())?;
            Ok(Edit::ReplacePath(Box::new(made.path)))
        })
    })
}
