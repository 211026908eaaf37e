//! What has been set in a scene, read again.

use std::ffi::{c_char, c_int, c_uchar};

use glam::DVec3;

use super::border::border;
use super::object::to_c;
use super::pointers::{self, ArrayOut, GrowingOut, Out, index, text};
use super::scene::thread_text;
use super::scene_handles::{change, look, read};
use super::scene_types::*;
use super::status::{Answer, Failure, V_ERR_INTERNAL};

/// The entry at an index of a list.
fn entry<'a, T>(all: &'a [T], at: usize, what: &'static str) -> Answer<&'a T> {
    let count = all.len();
    all.get(at).ok_or(Failure::NoEntry { what, at, count })
}

/// ==== Contents: what has been set in a scene ====
///
/// Gets how many there are of a scene's "nodes", "markers" or "pins" (node is then
/// ignored), or of a node's "tracks", "shapes" or "deformations".
/// V_ERR_ARGUMENT (no such thing; no object).
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_count(
    scene: *const V_SCENE,
    node: c_int,
    what: *const c_char,
    count: *mut c_int,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = Out::new(count, "count")?;
        // SAFETY: a zero-terminated text, as the header says.
        let what = unsafe { text(what, "what") }?;
        let found = match what {
            // Also between removals.
            "nodes" => look(scene, |nodes| pointers::count(nodes.count()))?,
            _ => read(scene, |document| {
                let scene = &document.scene;
                let node = || index(node, "node");
                pointers::count(match what {
                    "markers" => scene.markers().len(),
                    "pins" => scene.pins().len(),
                    "tracks" => scene.node(node()?)?.keys().tracks().len(),
                    "shapes" => scene.object(node()?)?.shapes().len(),
                    "deformations" => scene.object(node()?)?.deformations().len(),
                    _ => return Err(Failure::NoKind(what.into())),
                })
            })?,
        };
        // SAFETY: room for an int, as the header says.
        unsafe { out.answer(found) }
    })
}

/// Gets the channel of a node's track, for v_scene_get_track().
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

/// Gets a marker; they are sorted by name.
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

/// Gets a pin of v_scene_pin(); they are sorted by node and point.
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
/// V_ERR_ARGUMENT (no object).
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

/// Gets the name of an object's shape, its points and, if it has its own (*coloured 1),
/// their colours. capacity and *points count points.
/// V_ERR_ARGUMENT (no object).
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_get_shape(
    scene: *const V_SCENE,
    node: c_int,
    at: c_int,
    name: *mut *const c_char,
    xyz: *mut f64,
    rgb: *mut c_uchar,
    capacity: usize,
    points: *mut usize,
    coloured: *mut c_int,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let (name, coloured) = (
            Out::optional(name, "name")?,
            Out::optional(coloured, "coloured")?,
        );
        let colours =
            ArrayOut::optional(rgb.cast::<[u8; 3]>(), capacity, points, ["rgb", "points"])?;
        // A point is three doubles, see `object`.
        let out = ArrayOut::optional(xyz.cast::<DVec3>(), capacity, points, ["xyz", "points"])?;
        let (node, at) = (index(node, "node")?, index(at, "at")?);
        read(scene, |document| {
            let shape = entry(document.scene.object(node)?.shapes(), at, "shape")?;
            let count = shape.points.len();
            // SAFETY: room for a pointer, so many points and colours, an int and a size_t, as the
            // header says.
            unsafe {
                let wanted = [out.wants(count)?, colours.wants(count)?];
                if wanted[0] && count > 0 {
                    out.room(count)?.copy_from_slice(&shape.points);
                }
                if wanted[1] && !shape.colours.is_empty() {
                    colours.room(count)?.copy_from_slice(&shape.colours);
                }
                coloured.write(c_int::from(!shape.colours.is_empty()));
                name.write(thread_text(&shape.name));
                out.answer(count)
            }
        })
    })
}

/// Removes a shape of an object. The numbers of later shapes decrease; the others keep
/// their weights, also in a track of the channel "weights".
/// V_ERR_ARGUMENT (no object).
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

/// Gets the kind, parameters and box of an object's deformation. A box of 1 1 1 -1 -1
/// -1 stands for the bounds of the geometry: give v_scene_add_deformation() NULL then.
/// V_ERR_ARGUMENT (no object).
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
