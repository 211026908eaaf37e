//! How a path is flown, planned.

use std::ffi::c_int;

use super::border::border;
use super::path::insert_new;
use super::pointers::{Growing, Out, init, optional, read_growing};
use super::progress::watched;
use super::scene_tracks::mesh;
use super::scene_types::V_MESH;
use super::space::up_from_c;
use super::status::{Name, V_ERR_INTERNAL, add_last_warning, clear_last_warning};
use super::types::{V_PATH, V_TOUR, V_UP_Y};
use crate::planner::{self, TourRequest};

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

/// ==== Planning ====
///
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
