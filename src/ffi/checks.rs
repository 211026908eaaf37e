//! Fitting recorded poses, and checking paths.

use std::ffi::{CStr, c_char, c_int};
use std::ptr;

use super::border::border;
use super::path::{insert_new, read};
use super::pointers::{ArrayOut, Out, count, optional, read_growing, slice};
use super::progress::watched;
use super::scene_tracks::mesh;
use super::scene_types::V_MESH;
use super::space::{checked, up_from_c};
use super::status::{Answer, Name, V_ERR_INTERNAL, add_last_warning, clear_last_warning};
use super::types::{V_PATH, V_POSE, V_SPACE};
use crate::path::Pose;
use crate::tools::check::{COUNT, Finding};
use crate::tools::fit::{Fitted, Options, Tolerance, fit};

/// Something that v_path_check() found. It does not grow.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct v_finding {
    /// see v_path_check(); the text is constant
    pub kind: *const c_char,
    /// where it begins
    pub first_frame: f64,
    /// and where it ends
    pub last_frame: f64,
    /// the point at which the section begins
    pub point: c_int,
    /// the orientation with which it begins
    pub orientation: c_int,
    /// the worst value
    pub value: f64,
    /// the limit of its kind
    pub limit: f64,
}

pub type V_FINDING = v_finding;

/// The names of the kinds, for C.
const NAMES: [&CStr; COUNT] = [
    c"space",
    c"cusp",
    c"speed-jump",
    c"acceleration",
    c"view-jump",
    c"turning",
    c"turning-acceleration",
    c"half-turn",
    c"pole",
    c"target",
    c"clearance",
    c"through",
    c"nothing-to-see",
    c"zoom",
    c"redundant",
    c"corner",
    c"jerk",
    c"speed",
    c"crossing",
    c"backwards",
];

fn finding(found: &Finding) -> Answer<V_FINDING> {
    Ok(v_finding {
        kind: NAMES[found.kind as usize].as_ptr(),
        first_frame: found.first_frame,
        last_frame: found.last_frame,
        point: count(found.point)?,
        orientation: count(found.orientation)?,
        value: found.value,
        limit: found.limit,
    })
}

/// ==== Paths from recorded poses, checks ====
///
/// Fits a path of few points to recorded poses: each position within tolerance, each
/// view, up and field of view within angle degrees, at its time. Noise below that is
/// removed. Poses that jerk between whole frames, where no points are, may be missed.
/// The space is the smallest cube around the positions, enlarged by a tenth, with
/// V_UP_Y.
///
/// v_last_warning() then reports points, deviations and frame rate; if there are any,
/// holds, gaps, cuts and outliers; and what helps against many points: where a few
/// outliers cost a third of them, v_path_fit_poses_robust() with the points it needs;
/// else, where more than a third of the poses became points, a tolerance that needs at
/// most half of them.
///
/// seconds  when each pose was taken, in order; NULL: one per frame. Of equal times the
///     first counts. Times beyond 1e11 count nanoseconds or microseconds, by their
///     median step
/// count  at least two
/// fps  frame rate of the path
/// V_ERR_ARGUMENT (times that run backwards, a view without direction), V_ERR_RANGE,
/// V_ERR_LIMIT (times that span more than 100,000,000 frames), V_ERR_MEMORY,
/// V_ERR_REFUSED.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_fit_poses(
    poses: *const V_POSE,
    seconds: *const f64,
    count: usize,
    fps: f64,
    tolerance: f64,
    angle: f64,
    path: *mut *mut V_PATH,
) -> c_int {
    let space = ptr::null();
    // SAFETY: the same.
    unsafe { v_path_fit_poses_in_space(poses, seconds, count, fps, tolerance, angle, space, path) }
}

/// Like v_path_fit_poses(), in a space whose up axis applies to rolls and ups.
///
/// space  with half_size 0 only its up axis counts, and it is the smallest cube around
///     the positions, as with NULL
/// V_ERR_SIZE, V_ERR_ARGUMENT, V_ERR_RANGE, V_ERR_LIMIT, V_ERR_MEMORY, V_ERR_REFUSED.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_fit_poses_in_space(
    poses: *const V_POSE,
    seconds: *const f64,
    count: usize,
    fps: f64,
    tolerance: f64,
    angle: f64,
    space: *const V_SPACE,
    path: *mut *mut V_PATH,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = Out::new(path, "path")?;
        // SAFETY: a space, as the header says.
        let options = unsafe { options(tolerance, angle, space) }?;
        // SAFETY: so many poses and doubles, as the header says.
        let fitted = unsafe { fitted(poses, seconds, count, fps, &options) }?;
        let made = insert_new(fitted.path, fps)?;
        // SAFETY: room for a handle, as the header says.
        unsafe { out.answer(made) }
    })
}

/// Like v_path_fit_poses_in_space(), without outliers: poses farther than the tolerance
/// from what their neighbours suggest. *left_out receives their number, and may be NULL;
/// the last sentence of v_last_warning() names it and the first one.
/// V_ERR_SIZE, V_ERR_ARGUMENT, V_ERR_RANGE, V_ERR_LIMIT, V_ERR_MEMORY, V_ERR_REFUSED.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_fit_poses_robust(
    poses: *const V_POSE,
    seconds: *const f64,
    count: usize,
    fps: f64,
    tolerance: f64,
    angle: f64,
    space: *const V_SPACE,
    left_out: *mut usize,
    path: *mut *mut V_PATH,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let (out, left_out) = (
            Out::new(path, "path")?,
            Out::optional(left_out, "left_out")?,
        );
        // SAFETY: a space, as the header says.
        let mut options = unsafe { options(tolerance, angle, space) }?;
        options.robust = true;
        // SAFETY: so many poses and doubles, as the header says.
        let fitted = unsafe { fitted(poses, seconds, count, fps, &options) }?;
        let made = insert_new(fitted.path, fps)?;
        let (first, count) = (fitted.left_out.first(), fitted.left_out.len());
        if let Some(first) = first {
            let are = if count == 1 { "pose is" } else { "poses are" };
            add_last_warning(format_args!(
                "{count} {are} left out, first poses[{first}]."
            ));
        }
        // SAFETY: room for a number and a handle, as the header says.
        unsafe {
            left_out.write(fitted.left_out.len());
            out.answer(made)
        }
    })
}

/// What a fit goes by.
///
/// # Safety
/// `space` is NULL or points to a struct as its `size` says.
unsafe fn options(position: f64, angle: f64, space: *const V_SPACE) -> Answer<Options> {
    let mut options = Options::from(Tolerance { position, angle });
    // SAFETY: as required of the caller.
    let given = optional(space, |space| unsafe { read_growing(space, "space") })?;
    match given {
        Some(given) if given.half_size == 0.0 => {
            options.up = up_from_c(given.up, Name::Field("space", "up"))?
        }
        _ => options.space = given.as_ref().map(checked).transpose()?,
    }
    Ok(options)
}

/// # Safety
/// There are `count` poses and, unless NULL, seconds.
unsafe fn fitted(
    poses: *const V_POSE,
    seconds: *const f64,
    count: usize,
    fps: f64,
    options: &Options,
) -> Answer<Fitted> {
    // SAFETY: as required of the caller; the layouts are one.
    let poses = unsafe { slice(poses.cast::<Pose>(), count, "poses") }?;
    // SAFETY: as required of the caller.
    let seconds = optional(seconds, |seconds| unsafe {
        slice(seconds, count, "seconds")
    })?;
    clear_last_warning();
    let fitted: Fitted = watched(|go_on| Ok(fit(poses, seconds, fps, options, go_on)?))?;
    // A sentence for each line.
    for line in fitted.report.to_string().lines() {
        let (first, rest) = line.split_at(1);
        add_last_warning(format_args!("{}{rest}.", first.to_uppercase()));
    }
    Ok(fitted)
}

/// Finds what will look wrong: jerks, flips, collisions. Writes one finding per kind
/// and run of frames to your array, in their order. docs/reference/tools.md describes
/// the kinds; in parentheses their default limits, lengths in units of half_size. v_path_set_number()
/// sets the limit of one as "check.turning" and so on; it is saved.
///
/// "space"         outside the space (0)
/// "cusp"          curve or speed nearly stop (0.02 of the mean)
/// "speed-jump"    at a key, of the mean speed (0.5)
/// "acceleration"  per second squared (10)
/// "view-jump"     degrees at once (1)
/// "turning"       degrees per second (60)
/// "turning-acceleration"  degrees per second squared (300)
/// "half-turn"     degrees from a half turn (0.1)
/// "pole"          degrees from straight up or down (3)
/// "target"        distance (0.05)
/// "clearance"     distance of the object (0.02)
/// "through"       through a triangle of the object
/// "nothing-to-see"  seconds without the object in the picture (1)
/// "zoom"          mm per second (30)
/// "redundant"     times 0.001, 0.1 degrees and 0.1 mm that a key changes (1)
/// "corner"        degrees (60)
/// "jerk"          per second cubed (off)
/// "speed"         per second (off)
/// "crossing"      seconds in which what is seen crosses the picture (off)
/// "backwards"     distance back between points that lead on (0.001)
///
/// A hold, or a turn on the spot, between sections without an ease counts as a
/// "speed-jump", an "acceleration" or a "turning-acceleration" only if that limit is not
/// the default. The distance to the object is computed three times per frame, as by
/// the tool "avoid".
///
/// object  the obstacle, in the coordinates of the path; NULL: the path's own, with its
///     faces, if it has one
/// v_last_warning() returns notes, or "": that the camera is always inside the object,
/// and what was ignored (moving objects, the motion of the camera's parent).
/// V_ERR_SIZE, V_ERR_ARGUMENT (an object without geometry), V_ERR_RANGE, V_ERR_LIMIT,
/// V_ERR_MEMORY, V_ERR_REFUSED.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_check(
    path: *const V_PATH,
    object: *const V_MESH,
    findings: *mut V_FINDING,
    capacity: usize,
    count: *mut usize,
) -> c_int {
    clear_last_warning();
    border(V_ERR_INTERNAL, || {
        let out = ArrayOut::new(findings, capacity, count, ["findings", "count"])?;
        // SAFETY: a mesh, as the header says.
        let object = optional(object, |object| unsafe { mesh(object, "object") })?;
        let (found, notes) = read(path, |document| {
            let clearance = document.clearance(object.as_ref())?;
            let notes = document.notes(clearance.as_ref(), object.is_none())?;
            let found = watched(|go_on| Ok(document.check_against(clearance.as_ref(), go_on)?))?;
            Ok((found, notes))
        })?;
        notes
            .iter()
            .for_each(|note| add_last_warning(format_args!("{note}")));
        // SAFETY: room for so many and a size_t, as the header says; any bits make a finding.
        unsafe {
            if out.wants(found.len())? {
                for (room, found) in out.room(found.len())?.iter_mut().zip(&found) {
                    *room = finding(found)?;
                }
            }
            out.answer(found.len())
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tools::check::FindingKind;

    #[test]
    fn the_names_are_those_of_the_engine() {
        let names = NAMES.map(|name| name.to_str().unwrap());
        assert!(FindingKind::all().map(FindingKind::name).eq(names));
        let source = include_str!("checks.rs");
        for kind in FindingKind::all() {
            let limit = kind.limit();
            let line = source
                .lines()
                .find(|line| line.starts_with(&format!("/// \"{}\" ", limit.name)));
            let line = line.unwrap_or_else(|| panic!("{} is not in the header", limit.name));
            let told = format!("({}", limit.default);
            let plain = limit.default == 0.0 || !limit.default.is_finite();
            let told = source
                .lines()
                .skip_while(|at| *at != line)
                .take(2)
                .any(|l| l.contains(&told));
            assert!(plain || told, "{line}");
        }
    }
}
