//! Checking paths.

use std::ffi::{CStr, c_char, c_int};

use super::border::border;
use super::path::read;
use super::pointers::{ArrayOut, count, optional};
use super::progress::watched;
use super::scene_tracks::mesh;
use super::scene_types::V_MESH;
use super::status::{Answer, V_ERR_INTERNAL, add_last_warning, clear_last_warning};
use super::types::V_PATH;
use crate::document::limit_scale;
use crate::path::Space;
use crate::tools::check::{COUNT, Finding};

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

/// A finding for C, with its lengths in those of the path.
fn finding(found: &Finding, space: Space) -> Answer<V_FINDING> {
    let scale = limit_scale(found.kind, space);
    Ok(v_finding {
        kind: NAMES[found.kind as usize].as_ptr(),
        first_frame: found.first_frame,
        last_frame: found.last_frame,
        point: count(found.point)?,
        orientation: count(found.orientation)?,
        value: found.value * scale,
        limit: found.limit * scale,
    })
}

/// Finds what will look wrong: jerks, flips, collisions. Writes one finding per kind
/// and run of frames to your array, in their order. In parentheses the default
/// limits, for a space of half_size 1; those of lengths are relative to it. The
/// property "check.turning" and so on is the limit, in lengths of your world.
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
/// "speed-jump", an "acceleration" or a "turning-acceleration" only if that limit is
/// not the default.
///
/// object  in the coordinates of the path; NULL: the path's own, if it has one
/// v_last_warning() returns notes: that the camera is always inside the object, and
/// what was ignored (moving objects, the motion of the camera's parent).
/// V_ERR_ARGUMENT (an object without geometry), V_ERR_REFUSED.
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
        let (found, notes, space) = read(path, |document| {
            let clearance = document.clearance(object.as_ref())?;
            let notes = document.notes(clearance.as_ref(), object.is_none())?;
            let found = watched(|go_on| Ok(document.check_against(clearance.as_ref(), go_on)?))?;
            Ok((found, notes, document.path().space))
        })?;
        notes
            .iter()
            .for_each(|note| add_last_warning(format_args!("{note}")));
        // SAFETY: room for so many and a size_t, as the header says; any bits make a finding.
        unsafe {
            if out.wants(found.len())? {
                for (room, found) in out.room(found.len())?.iter_mut().zip(&found) {
                    *room = finding(found, space)?;
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
