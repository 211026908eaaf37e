//! How a path is flown, planned.

use std::ffi::c_int;

use super::border::border;
use super::path::{edit_by, insert_new};
use super::pointers::{Growing, Out, index, init, optional, read_growing};
use super::progress::watched;
use super::scene_tracks::mesh;
use super::scene_types::V_MESH;
use super::space::up_from_c;
use super::status::{Answer, Failure, Name, V_ERR_INTERNAL, add_last_warning, clear_last_warning};
use super::types::{V_LIMITS, V_PATH, V_TOUR, V_UP_Y};
use crate::document::Edit;
use crate::error::can_allocate;
use crate::path::CameraPath;
use crate::planner::{
    self, AvoidRequest, Request, SteadyRequest, TourRequest, What, avoid_object, retime, steady,
};
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
/// Fills in the defaults of v_path_check(): acceleration 10, turning 60,
/// turning_acceleration 300, zoom 30; no other limits.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_limits_init(limits: *mut V_LIMITS) {
    border((), || {
        // SAFETY: room for the struct of version 1.0, as the header says.
        unsafe { init(limits, V_LIMITS::DEFAULTS, V_LIMITS::FIRST, "limits") }
    });
}

/// Like v_limits_init(), for a struct of size bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_limits_init_sized(limits: *mut V_LIMITS, size: usize) {
    border((), || {
        // SAFETY: room for so much of the struct, as the header says.
        unsafe { init(limits, V_LIMITS::DEFAULTS, size, "limits") }
    });
}

/// Recomputes the speed profile between the first orientation of one point and the last
/// of another, as fast as the limits allow, in at most 40 rounds over the sections.
/// Curve and views do not change. The camera rests at the ends of an open path, at held
/// keys, and where curve or view have a kink, which v_last_warning() lists. The sections
/// get fixed frames, a distance curve and a curve time.
///
/// limits  NULL: the path's own, see v_path_check()
/// first_point, last_point  as for v_path_fit_frames()
/// seconds  0: as few as the limits allow; otherwise this duration, to a whole frame,
///     with the lowest peaks; the last frame of the path counts, too
/// V_ERR_SIZE, V_ERR_ARGUMENT (no limit, one that is not positive, too few seconds:
/// v_last_error() names the least), V_ERR_RANGE, V_ERR_LIMIT, V_ERR_MEMORY,
/// V_ERR_REFUSED.
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
            let made = watched(|go_on| Ok(retime(document.path(), &request, go_on)?))?;
            for rest in &made.rests {
                add_last_warning(format_args!("{rest}"));
            }
            can_allocate(size_of::<CameraPath>())?;
            Ok(Edit::ReplacePath(Box::new(made.path)))
        })
    })
}

/// Stabilises a recorded flight: a low-pass filter without lag at whole frames, then
/// v_path_fit_poses() with as many frames. The first and the last pose do not change.
/// Names, targets and modes are discarded; a closed path becomes open. v_last_warning()
/// returns how far the path moved.
///
/// period  cut-off period: motion of this period is halved, faster motion is removed;
///     > 0 and at most 2,000 frames
/// within  maximum distance any position may move; 0: no limit
/// V_ERR_ARGUMENT (a path that does not move, no path within the limit), V_ERR_RANGE,
/// V_ERR_LIMIT, V_ERR_MEMORY, V_ERR_REFUSED.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_steady(path: *mut V_PATH, period: f64, within: f64) -> c_int {
    clear_last_warning();
    border(V_ERR_INTERNAL, || {
        edit_by(path, |document| {
            let request = SteadyRequest {
                period,
                within,
                fps: document.info().fps,
            };
            let made = watched(|go_on| Ok(steady(document.path(), &request, go_on)?))?;
            add_last_warning(format_args!(
                "places went {:.6} at most, views turned {:.3} degrees",
                made.furthest, made.turned
            ));
            can_allocate(size_of::<CameraPath>())?;
            Ok(Edit::ReplacePath(Box::new(made.path)))
        })
    })
}

/// Moves a path away from an object where the camera, or a sphere around it, comes
/// nearer than the clearance or passes through: points move as little, and as few are
/// added, as possible. Points that were clear do not move, except within a closed part of
/// the object between others outside. Frames and targets do not change. v_last_warning()
/// returns a line for each changed part, or "".
///
/// A part takes at most a few searches of a grid with 96 cells along its longest side;
/// a distance, the logarithm of the number of triangles, up to that number if they
/// overlap widely.
///
/// object  in the coordinates of the path; NULL: the path's own
/// clearance, radius  in the path's units; clearance > 0, radius of the sphere 0 or
///     more
/// V_ERR_SIZE, V_ERR_ARGUMENT (no way round: v_last_error() names the frame and the
/// place; an object without geometry), V_ERR_RANGE, V_ERR_LIMIT, V_ERR_MEMORY,
/// V_ERR_REFUSED.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_avoid(
    path: *mut V_PATH,
    object: *const V_MESH,
    clearance: f64,
    radius: f64,
) -> c_int {
    clear_last_warning();
    border(V_ERR_INTERNAL, || {
        // SAFETY: a mesh, as the header says.
        let object = optional(object, |object| unsafe { mesh(object, "object") })?;
        edit_by(path, |document| {
            let object = document.solid(object.as_ref())?;
            let request = AvoidRequest { clearance, radius };
            let made =
                watched(|go_on| Ok(avoid_object(document.path(), &object, &request, go_on)?))?;
            for part in &made.parts {
                add_last_warning(format_args!("{part}"));
            }
            can_allocate(size_of::<CameraPath>())?;
            Ok(Edit::ReplacePath(Box::new(made.path)))
        })
    })
}

/// How v_path_keep_in_picture() keeps an object in the picture: by the zoom, by moving
/// the camera along its view, by turning it.
pub const V_PICTURE_ZOOM: c_int = 0;
pub const V_PICTURE_DISTANCE: c_int = 1;
pub const V_PICTURE_VIEW: c_int = 2;

/// Keeps an object whole in the picture less margin, at every frame and between. By zoom
/// or distance it is as large as the margin and the path's limits of zoom, or of speed
/// and acceleration, allow; by the view the camera turns no more than necessary. Frames
/// and speed profile do not change; points are added where keys are not enough. Takes 20
/// positions per frame, each tried at most 60 times.
///
/// object  in the coordinates of the path; NULL: the path's own, with the objects of
///     its scene
/// margin  the fraction of the picture's width and height (36 x 24 mm) to keep free on
///     each side, from 0 to below 0.5
/// what  V_PICTURE_...
/// V_ERR_ARGUMENT (no object, or it does not fit into the picture, with the frame),
/// V_ERR_RANGE, V_ERR_SIZE, V_ERR_LIMIT, V_ERR_MEMORY, V_ERR_REFUSED.
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
            let object = document.solid(object.as_ref())?;
            let limits = document.info().limits;
            let made =
                watched(|go_on| Ok(document.framed(&object, (margin, what), limits, go_on)?))?;
            can_allocate(size_of::<CameraPath>())?;
            Ok(Edit::ReplacePath(Box::new(made.path)))
        })
    })
}

// SAFETY: a number of bytes first, then numbers only.
unsafe impl Growing for V_TOUR {
    const NAME: &'static str = "V_TOUR";
    const FIRST: usize = size_of::<V_TOUR>();
    const DEFAULTS: Self = Self {
        size: size_of::<V_TOUR>(),
        seconds: 60.0,
        coverage: 0.95,
        distance: 0.0,
        inside: 0,
        has_start: 0,
        start: [0.0; 3],
        up: V_UP_Y,
    };
}

/// Fills in the default tour: 60 seconds, coverage 0.95, outside the object, at a
/// distance that VIDES chooses, closed, V_UP_Y.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_tour_init(tour: *mut V_TOUR) {
    border((), || {
        // SAFETY: room for the struct of version 1.0, as the header says.
        unsafe { init(tour, V_TOUR::DEFAULTS, V_TOUR::FIRST, "tour") }
    });
}

/// Like v_tour_init(), for a struct of size bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_tour_init_sized(tour: *mut V_TOUR, size: usize) {
    border((), || {
        // SAFETY: room for so much of the struct, as the header says.
        unsafe { init(tour, V_TOUR::DEFAULTS, size, "tour") }
    });
}

/// Plans a flight that shows an object: the fewest positions from which the wanted
/// fraction of its surface is seen, a short path through them that keeps clear of it,
/// and a speed profile within the limits of v_path_check(), at 25 frames per second.
/// Takes some seconds for a million triangles, and about 300 bytes per triangle.
///
/// object  its triangles count. From outside, only the side of the normals is to be
///     seen where neighbouring triangles agree about it, otherwise either side
/// tour  NULL: that of v_tour_init()
/// coverage  the fraction shown of what can be seen; may be NULL
/// v_last_warning() returns two lines: positions, coverage, length and seconds; and
/// what remains unseen, and why.
/// V_ERR_SIZE, V_ERR_ARGUMENT (no surface, no free place, too few seconds:
/// v_last_error() names the least), V_ERR_RANGE, V_ERR_LIMIT, V_ERR_MEMORY,
/// V_ERR_REFUSED.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_tour(
    object: *const V_MESH,
    tour: *const V_TOUR,
    path: *mut *mut V_PATH,
    coverage: *mut f64,
) -> c_int {
    clear_last_warning();
    border(V_ERR_INTERNAL, || {
        let (path, coverage) = (
            Out::new(path, "path")?,
            Out::optional(coverage, "coverage")?,
        );
        // SAFETY: a mesh, as the header says.
        let object = unsafe { mesh(object, "object") }?;
        // SAFETY: a struct as its size says, as the header says.
        let given = optional(tour, |tour| unsafe { read_growing(tour, "tour") })?;
        let given = given.unwrap_or(V_TOUR::DEFAULTS);
        let request = TourRequest {
            seconds: given.seconds,
            coverage: given.coverage,
            distance: given.distance,
            inside: given.inside != 0,
            start: (given.has_start != 0).then(|| given.start.into()),
            up: up_from_c(given.up, Name::Field("tour", "up"))?,
            ..TourRequest::default()
        };
        let made = watched(|go_on| Ok(planner::tour(&object, &request, go_on)?))?;
        for line in made.to_string().lines() {
            add_last_warning(format_args!("{line}"));
        }
        let share = made.coverage;
        let made = insert_new(made.path, request.fps)?;
        // SAFETY: room for a handle and, unless NULL, a double, as the header says.
        unsafe {
            coverage.write(share);
            path.answer(made)
        }
    })
}
