//! What a host passes when it opens a window: the object to show and the base speeds.

use std::cell::RefCell;
use std::ffi::c_int;
use std::ptr::null;

use glam::DVec3;

use super::pointers::{optional, slice};
use super::scene_types::V_MESH;
use super::status::Answer;
use super::types::V_OBJEKT_LIST;
use crate::document::{Object, ObjectPoint};
use crate::editor::{Warning, Warnings};
use crate::error::{EngineError, TooMany, vec_with_room};
use crate::limits;
use crate::path::BaseFrames;
use crate::scene::Mesh;

/// Replaces an invalid speed; from the example of the thesis.
const USUAL_SPEED: f64 = 100.0;

/// Copies the host's object, empty without points. Warns if the numbers are not 1, 2, 3 …; the
/// order of the array counts.
///
/// # Safety
/// `points` is NULL or points to `count` readable elements.
pub(super) unsafe fn object(
    points: *const V_OBJEKT_LIST,
    count: c_int,
    warn: &mut Warnings,
) -> Answer<Object> {
    let count = usize::try_from(count).unwrap_or(0);
    if points.is_null() || count == 0 {
        return Ok(Object::default());
    }
    if count > limits::MAX_OBJECT_POINTS {
        return Err(TooMany::ObjectPoints.into());
    }
    // SAFETY: the caller's word.
    let given = unsafe { slice(points, count, "points") }?;
    let mut copied = vec_with_room(count)?;
    let mut misnumbered = None;
    for (point, should) in given.iter().zip(1..) {
        if point.number != should && misnumbered.is_none() {
            misnumbered = Some((should, point.number));
        }
        let [x, y, z] = [point.pos.x, point.pos.y, point.pos.z].map(f64::from);
        copied.push(ObjectPoint {
            position: DVec3::new(x, y, z),
            draw: point.draw != 0,
        });
    }
    if let Some((place, number)) = misnumbered {
        warn.add(Warning::Misnumbered { place, number });
    }
    Ok(copied.into())
}

/// Copies the host's object as a wireframe; NULL is an empty one.
///
/// # Safety
/// `mesh` is NULL or points to a mesh whose arrays are as long as it says.
pub(super) unsafe fn wireframe(mesh: *const V_MESH, name: &'static str) -> Answer<Object> {
    // SAFETY: the caller's word.
    let mesh = optional(mesh, |mesh| unsafe {
        super::scene_tracks::mesh(mesh, name)
    })?;
    Ok(mesh.map_or_else(|| Ok(Object::default()), Object::of_mesh)?)
}

thread_local! {
    /// What the last [`thread_mesh`] points to: an object's own mesh, or one made of its lines.
    static SHOWN: RefCell<(Object, Mesh)> = RefCell::default();
}

/// An object for C, kept until this thread requests the next one.
pub(super) fn thread_mesh(object: Object) -> Answer<V_MESH> {
    let made = if object.mesh().is_some() {
        Mesh::default()
    } else {
        as_drawn(&object)?
    };
    let kept = SHOWN.try_with(|shown| {
        let mut shown = shown.borrow_mut();
        *shown = (object, made);
        to_c(shown.0.mesh().unwrap_or(&shown.1))
    });
    // Only while the thread ends.
    Ok(kept.map_err(|_| EngineError::Memory)?)
}

/// The lines of an object without a mesh.
fn as_drawn(object: &Object) -> Answer<Mesh> {
    let (mut points, mut lines) = (vec_with_room(object.len())?, vec_with_room(object.len())?);
    points.extend(object.iter().map(|point| point.position));
    if object.iter().any(|point| point.draw) {
        for ((at, point), before) in (0u32..).zip(object.iter()).zip((0..1).chain(0..)) {
            let next = object.get(at as usize + 1);
            match point.draw {
                true => lines.push([before, at]),
                // A single point becomes a line of length 0.
                false if next.is_none_or(|next| !next.draw) => lines.push([at, at]),
                false => {}
            }
        }
    }
    Ok(Mesh {
        points,
        lines,
        ..Mesh::default()
    })
}

/// A mesh for C, which points into it.
pub(super) fn to_c(mesh: &Mesh) -> V_MESH {
    /// NULL where there is nothing.
    fn first<T, F>(all: &[T]) -> *const F {
        match all {
            [] => null(),
            all => all.as_ptr().cast(),
        }
    }
    V_MESH {
        size: size_of::<V_MESH>(),
        xyz: first(&mesh.points),
        points: mesh.points.len(),
        rgb: first(&mesh.colours),
        lines: first(&mesh.lines),
        line_ends: 2 * mesh.lines.len(),
        triangles: first(&mesh.triangles),
        corners: 3 * mesh.triangles.len(),
    }
}

// Three numbers per point.
const _: () = assert!(size_of::<DVec3>() == 24 && align_of::<DVec3>() == align_of::<f64>());

/// The host's base speeds: move, orient, zoom, winkel (roll). Invalid ones are replaced, with a
/// warning.
pub(super) fn speeds(given: [f64; 4], warn: &mut Warnings) -> BaseFrames {
    let names = ["move_speed", "orient_speed", "zoom_speed", "winkel_speed"];
    let mut sound = given;
    for (speed, name) in sound.iter_mut().zip(names) {
        if !(speed.is_finite() && *speed > 0.0) {
            warn.add(Warning::Speed {
                name,
                given: *speed,
                taken: USUAL_SPEED,
            });
            *speed = USUAL_SPEED;
        }
    }
    let [movement, turning, zoom, rolling] = sound;
    BaseFrames {
        movement,
        turning,
        zoom,
        rolling,
    }
}
