//! What has been set in a scene, read again.

use std::ffi::{c_char, c_int};

use glam::DVec3;

use super::border::border;
use super::object::to_c;
use super::pointers::{self, ArrayOut, GrowingOut, Out, index, text};
use super::scene::thread_text;
use super::scene_handles::{change, read};
use super::scene_types::*;
use super::status::{Answer, Failure, V_ERR_INTERNAL};
use crate::error::Refused;
use crate::scene::Scene;

/// The entry at an index of a list.
fn entry<'a, T>(all: &'a [T], at: usize, what: &'static str) -> Answer<&'a T> {
    let count = all.len();
    all.get(at).ok_or(Failure::NoEntry { what, at, count })
}

/// Writes a count as the result of a call.
///
/// # Safety
/// `count` is NULL or points to room for an int.
unsafe fn answer_count(
    scene: *const V_SCENE,
    count: *mut c_int,
    of: impl FnOnce(&Scene) -> Answer<usize>,
) -> Answer<c_int> {
    let out = Out::new(count, "count")?;
    let found = read(scene, |document| {
        of(&document.scene).and_then(pointers::count)
    })?;
    // SAFETY: as required of the caller.
    unsafe { out.answer(found) }
}

/// ==== What has been set in a scene ====
///
/// Gets start_frame and after of a node's path, see v_scene_set_path().
/// V_ERR_ARGUMENT (it follows none), V_ERR_RANGE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_get_start(
    scene: *const V_SCENE,
    node: c_int,
    start_frame: *mut f64,
    after: *mut c_int,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let (start, beyond) = (
            Out::optional(start_frame, "start_frame")?,
            Out::optional(after, "after")?,
        );
        let node = index(node, "node")?;
        let (from, how) = read(scene, |document| {
            let node = document.scene.node(node)?;
            let none = || Refused::NoPathOf((&node.name).into());
            let found = node.path().ok_or_else(none)?;
            Ok((found.start_frame(), found.extrapolation() as c_int))
        })?;
        // SAFETY: room for a double and an int, as the header says.
        unsafe {
            start.write(from);
            beyond.answer(how)
        }
    })
}

/// Gets the number of tracks of a node.
/// V_ERR_RANGE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_track_count(
    scene: *const V_SCENE,
    node: c_int,
    count: *mut c_int,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let node = index(node, "node")?;
        // SAFETY: room for an int, as the header says.
        unsafe {
            answer_count(scene, count, |scene| {
                Ok(scene.node(node)?.keys().tracks().len())
            })
        }
    })
}

/// Gets the channel of a node's track, for v_scene_get_track().
/// V_ERR_RANGE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_get_channel(
    scene: *const V_SCENE,
    node: c_int,
    at: c_int,
    channel: *mut *const c_char,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = Out::new(channel, "channel")?;
        let (node, at) = (index(node, "node")?, index(at, "at")?);
        let lent = read(scene, |document| {
            let tracks = document.scene.node(node)?.keys().tracks();
            let (what, count) = ("track", tracks.len());
            let track = tracks.get(at).ok_or(Failure::NoEntry { what, at, count })?;
            let channel = track.channel();
            Ok(thread_text(&channel.to_string()))
        })?;
        // SAFETY: room for a pointer, as the header says.
        unsafe { out.answer(lent) }
    })
}

/// Gets the number of markers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_marker_count(scene: *const V_SCENE, count: *mut c_int) -> c_int {
    border(V_ERR_INTERNAL, || {
        // SAFETY: room for an int, as the header says.
        unsafe { answer_count(scene, count, |scene| Ok(scene.markers().len())) }
    })
}

/// Gets a marker; they are sorted by name.
/// V_ERR_RANGE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_get_marker(
    scene: *const V_SCENE,
    at: c_int,
    name: *mut *const c_char,
    frame: *mut f64,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let (name, frame) = (Out::optional(name, "name")?, Out::optional(frame, "frame")?);
        let at = index(at, "at")?;
        read(scene, |document| {
            let marker = entry(document.scene.markers(), at, "marker")?;
            // SAFETY: room for a pointer and a double, as the header says.
            unsafe {
                name.write(thread_text(&marker.name));
                frame.answer(marker.frame)
            }
        })
    })
}

/// Removes a marker and its pins.
/// V_ERR_ARGUMENT (no such marker).
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_remove_marker(scene: *mut V_SCENE, name: *const c_char) -> c_int {
    border(V_ERR_INTERNAL, || {
        // SAFETY: a zero-terminated text, as the header says.
        let name = unsafe { text(name, "name") }?;
        change(scene, |scene| {
            if scene.marker(name).is_none() {
                return Err(crate::error::Invalid::NoMarker(name.into()).into());
            }
            scene.remove_marker(name);
            Ok(())
        })
    })
}

/// Gets the number of points that are pinned to markers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_pin_count(scene: *const V_SCENE, count: *mut c_int) -> c_int {
    border(V_ERR_INTERNAL, || {
        // SAFETY: room for an int, as the header says.
        unsafe { answer_count(scene, count, |scene| Ok(scene.pins().len())) }
    })
}

/// Gets a pin of v_scene_pin(); they are sorted by node and point.
/// V_ERR_RANGE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_get_pin(
    scene: *const V_SCENE,
    at: c_int,
    node: *mut c_int,
    point: *mut c_int,
    marker: *mut *const c_char,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let (node, point) = (Out::optional(node, "node")?, Out::optional(point, "point")?);
        let (marker, at) = (Out::optional(marker, "marker")?, index(at, "at")?);
        read(scene, |document| {
            let pin = entry(document.scene.pins(), at, "pin")?;
            let numbers = (pointers::count(pin.node)?, pointers::count(pin.point)?);
            // SAFETY: room for two ints and a pointer, as the header says.
            unsafe {
                node.write(numbers.0);
                point.write(numbers.1);
                marker.answer(thread_text(&pin.marker))
            }
        })
    })
}

/// Gets the geometry of an object at rest; 0 points if it has none. The arrays are
/// valid until the scene is changed or freed.
/// V_ERR_SIZE, V_ERR_ARGUMENT (no object), V_ERR_RANGE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_get_geometry(
    scene: *const V_SCENE,
    node: c_int,
    mesh: *mut V_MESH,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        // SAFETY: a struct as its size says, as the header demands.
        let out = unsafe { GrowingOut::new(mesh, "mesh") }?;
        let node = index(node, "node")?;
        let lent = read(scene, |document| {
            Ok(to_c(document.scene.object(node)?.mesh()))
        })?;
        // SAFETY: as above.
        unsafe { out.answer(lent) }
    })
}

/// Gets the number of shapes of an object.
/// V_ERR_ARGUMENT (no object), V_ERR_RANGE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_shape_count(
    scene: *const V_SCENE,
    node: c_int,
    count: *mut c_int,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let node = index(node, "node")?;
        // SAFETY: room for an int, as the header says.
        unsafe { answer_count(scene, count, |scene| Ok(scene.object(node)?.shapes().len())) }
    })
}

/// Gets the name and the points of an object's shape: three numbers per point; capacity
/// and *points count points. Any result may be NULL.
/// V_ERR_SIZE, V_ERR_ARGUMENT (no object), V_ERR_RANGE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_get_shape(
    scene: *const V_SCENE,
    node: c_int,
    at: c_int,
    name: *mut *const c_char,
    xyz: *mut f64,
    capacity: usize,
    points: *mut usize,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let name = Out::optional(name, "name")?;
        // A point is three doubles, see `object`.
        let out = ArrayOut::optional(xyz.cast::<DVec3>(), capacity, points, ["xyz", "points"])?;
        let (node, at) = (index(node, "node")?, index(at, "at")?);
        read(scene, |document| {
            let shape = entry(document.scene.object(node)?.shapes(), at, "shape")?;
            let count = shape.points.len();
            // SAFETY: room for a pointer, that many points and a size_t, as the header says.
            unsafe {
                if out.wants(count)? && count > 0 {
                    out.room(count)?.copy_from_slice(&shape.points);
                }
                name.write(thread_text(&shape.name));
                out.answer(count)
            }
        })
    })
}

/// Removes a shape of an object. The numbers of later shapes decrease; the others keep
/// their weights, also in a track of the channel "weights".
/// V_ERR_ARGUMENT (no object), V_ERR_RANGE, V_ERR_MEMORY.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_remove_shape(
    scene: *mut V_SCENE,
    node: c_int,
    at: c_int,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let (node, at) = (index(node, "node")?, index(at, "at")?);
        change(scene, |scene| scene.remove_shape(node, at))
    })
}

/// Gets the number of deformations of an object.
/// V_ERR_ARGUMENT (no object), V_ERR_RANGE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_deformation_count(
    scene: *const V_SCENE,
    node: c_int,
    count: *mut c_int,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let node = index(node, "node")?;
        // SAFETY: room for an int, as the header says.
        unsafe {
            answer_count(scene, count, |scene| {
                Ok(scene.object(node)?.deformations().len())
            })
        }
    })
}

/// Gets the kind, parameters and box of an object's deformation. A box of 1 1 1 -1 -1
/// -1, which no other is, stands for the bounds of the geometry: give
/// v_scene_add_deformation() NULL then. Any result may be NULL.
/// V_ERR_SIZE, V_ERR_ARGUMENT (no object), V_ERR_RANGE.
/// cbindgen:ptrs-as-arrays=[[box; 6]]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_get_deformation(
    scene: *const V_SCENE,
    node: c_int,
    at: c_int,
    kind: *mut *const c_char,
    parameters: *mut f64,
    capacity: usize,
    count: *mut usize,
    r#box: *mut f64,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let kind = Out::optional(kind, "kind")?;
        let out = ArrayOut::optional(parameters, capacity, count, ["parameters", "count"])?;
        let corners = Out::optional_array(r#box, "box")?;
        let (node, at) = (index(node, "node")?, index(at, "at")?);
        read(scene, |document| {
            let all = document.scene.object(node)?.deformations();
            let (found, bounds) = entry(all, at, "deformation")?;
            let numbers = found.parameters();
            let [low, high] = bounds.map_or([DVec3::ONE, DVec3::NEG_ONE], |bounds| {
                [bounds.min(), bounds.max()]
            });
            // SAFETY: room for a pointer, that many numbers, six more and a size_t, as the header
            // says.
            unsafe {
                if out.wants(numbers.len())? {
                    out.room(numbers.len())?.copy_from_slice(numbers);
                }
                kind.write(thread_text(found.kind()));
                corners.write([low.x, low.y, low.z, high.x, high.y, high.z]);
                out.answer(numbers.len())
            }
        })
    })
}
