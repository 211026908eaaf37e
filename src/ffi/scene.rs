//! Scenes and their nodes.

use std::cell::UnsafeCell;
use std::ffi::{c_char, c_int};
use std::ptr;

use glam::{DQuat, DVec3};

use super::border::border;
use super::path;
use super::pointers::{
    self, Growing, GrowingOut, MAX_TEXT, Out, TextOut, copied, file_name, index, init, most,
    numbered, optional, read_growing, slice, text,
};
use super::scene_handles::{self, change, edit, insert, look, read};
use super::scene_types::*;
use super::status::{Answer, Failure, V_ERR_INTERNAL, V_OK, add_last_warning, clear_last_warning};
use super::types::V_PATH;
use crate::document::{Info, SceneDocument};
use crate::error::{Invalid, Refused};
use crate::limits::MAX_NAME_BYTES;
use crate::path::camera_path::check_name;
use crate::scene::{Camera, Extrapolation, FollowPath, Kind, Light, Node, Object, Values};

/// Room for the name of a node or an interpolation, with a terminating zero.
const TEXT_BYTES: usize = MAX_NAME_BYTES + 16;

/// Copies a text into a thread's buffer for C, valid until the next call. No allocation.
pub(super) fn thread_text(text: &str) -> *const c_char {
    thread_local! {
        static TEXT: UnsafeCell<[u8; TEXT_BYTES]> = const { UnsafeCell::new([0; TEXT_BYTES]) };
    }
    TEXT.with(|buffer| {
        // SAFETY: the cell belongs to this thread, and the reference ends here.
        let buffer = unsafe { &mut *buffer.get() };
        let length = text.len().min(TEXT_BYTES - 1);
        buffer[..length].copy_from_slice(&text.as_bytes()[..length]);
        buffer[length] = 0;
        buffer.as_ptr().cast()
    })
}

/// Converts a link to a node from C; −1 is `None`.
pub(super) fn link(value: c_int, name: &'static str) -> Answer<Option<usize>> {
    if value == -1 {
        Ok(None)
    } else {
        index(value, name).map(Some)
    }
}

pub(super) fn unlink(value: Option<usize>) -> Answer<c_int> {
    value.map_or(Ok(-1), pointers::count)
}

const _: () = assert!(
    Extrapolation::Hold as c_int == V_AFTER_HOLD
        && Extrapolation::Repeat as c_int == V_AFTER_REPEAT
        && Extrapolation::PingPong as c_int == V_AFTER_PINGPONG
        && Extrapolation::Offset as c_int == V_AFTER_OFFSET
        && Light::Directional as c_int == V_LIGHT_DIRECTIONAL
        && Light::Point as c_int == V_LIGHT_POINT
        && Light::Spot as c_int == V_LIGHT_SPOT
);

/// How a motion continues beyond its end.
pub(super) fn beyond(after: c_int) -> Answer<Extrapolation> {
    let known = "V_AFTER_HOLD (0), V_AFTER_REPEAT (1), V_AFTER_PINGPONG (2), V_AFTER_OFFSET (3)";
    numbered(&Extrapolation::ALL, after, "after", known)
}

fn light(light: c_int) -> Answer<Light> {
    let known = "V_LIGHT_DIRECTIONAL (0), V_LIGHT_POINT (1), V_LIGHT_SPOT (2)";
    numbered(&Light::ALL, light, "values->light", known)
}

/// Converts a node from C, with defaults for what its kind lacks.
fn node(given: &V_NODE) -> Answer<Node> {
    let kind = match given.kind {
        V_NODE_GROUP => Kind::Group,
        V_NODE_OBJECT => Kind::Object(Object::default()),
        V_NODE_LIGHT => Kind::Light(light(given.light)?),
        V_NODE_CAMERA => Kind::Camera(Camera {
            near: given.near_plane,
            far: given.far_plane,
        }),
        _ => {
            return Err(Failure::unknown(
                "values->kind",
                given.kind,
                "V_NODE_GROUP (0), V_NODE_OBJECT (1), V_NODE_LIGHT (2), V_NODE_CAMERA (3)",
            ));
        }
    };
    let [w, x, y, z] = given.rotation;
    let mut rest = Values {
        position: given.position.into(),
        rotation: DQuat::from_xyzw(x, y, z, w),
        scale: given.scale.into(),
        visible: given.visible != 0,
        ..Values::default()
    };
    if matches!(kind, Kind::Camera(_)) {
        (rest.zoom, rest.roll) = (given.zoom, given.roll);
    }
    if matches!(kind, Kind::Light(_)) {
        (rest.intensity, rest.cone) = (given.intensity, given.cone);
    }
    if matches!(kind, Kind::Light(_) | Kind::Object(_)) {
        rest.colour = given.colour;
    }
    let aim = if kind.looks() {
        link(given.aim, "values->aim")?
    } else {
        None
    };
    let pivot = if kind.looks() {
        DVec3::ZERO
    } else {
        given.pivot.into()
    };
    let mut node = Node::default();
    node.parent = link(given.parent, "values->parent")?;
    (node.kind, node.rest, node.aim, node.pivot) = (kind, rest, aim, pivot);
    Ok(node)
}

/// Converts a node to C; `number` returns the number of its parent and of the node it
/// aims at.
fn node_for_c(node: &Node, number: impl Fn(usize) -> Option<usize>) -> Answer<V_NODE> {
    let (rest, q) = (&node.rest, node.rest.rotation);
    let camera = match node.kind {
        Kind::Camera(camera) => camera,
        _ => Camera::default(),
    };
    Ok(V_NODE {
        size: size_of::<V_NODE>(),
        kind: match node.kind {
            Kind::Group => V_NODE_GROUP,
            Kind::Object(_) => V_NODE_OBJECT,
            Kind::Light(_) => V_NODE_LIGHT,
            Kind::Camera(_) => V_NODE_CAMERA,
        },
        parent: unlink(node.parent.and_then(&number))?,
        visible: c_int::from(rest.visible),
        aim: unlink(node.aim.and_then(number))?,
        pivot: node.pivot.to_array(),
        position: rest.position.to_array(),
        rotation: [q.w, q.x, q.y, q.z],
        scale: rest.scale.to_array(),
        zoom: rest.zoom,
        roll: rest.roll,
        light: match node.kind {
            Kind::Light(Light::Point) => V_LIGHT_POINT,
            Kind::Light(Light::Spot) => V_LIGHT_SPOT,
            _ => V_LIGHT_DIRECTIONAL,
        },
        colour: rest.colour,
        intensity: rest.intensity,
        cone: rest.cone,
        near_plane: camera.near,
        far_plane: camera.far,
    })
}

/// ==== Scenes: nodes that move on one timeline ====
///
/// Fills in a node of this kind at the origin: visible, scale 1, rotation 1 0 0 0, no
/// parent, no aim, zoom 24, white, intensity 1, a cone of 20 and 30 degrees, planes
/// at 0.01 and 1000.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_node_init(node: *mut V_NODE, kind: c_int) {
    border((), || {
        let made = V_NODE {
            kind,
            ..node_for_c(&Node::default(), Some)?
        };
        // SAFETY: room for a node of version 1.0, as the header says.
        unsafe { init(node, made, V_NODE::FIRST, "node") }
    });
}

/// Makes a new scene: one camera, "camera", on the path of v_path_new(), from frame
/// 1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_new(scene: *mut *mut V_SCENE) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = Out::new(scene, "scene")?;
        let made = insert(SceneDocument::try_new()?)?;
        // SAFETY: room for a handle, as the header says.
        unsafe { out.answer(made) }
    })
}

/// Reads a scene from a .vid file; one with only a path gives a camera on it.
///
/// An object is left empty if its mesh file is missing, malformed, or outside the
/// folder of the .vid file once links are followed (v_scene_load_geometry() reads it
/// from anywhere); v_last_warning() reports this, and a mesh that has changed.
/// V_ERR_IO, V_ERR_FORMAT.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_load(file: *const c_char, scene: *mut *mut V_SCENE) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = Out::new(scene, "scene")?;
        // SAFETY: a zero-terminated text, as the header says.
        let made = insert_loaded(SceneDocument::load(unsafe { file_name(file, "file") }?)?)?;
        // SAFETY: room for a handle, as the header says.
        unsafe { out.answer(made) }
    })
}

/// Like v_scene_load(), from the text of a .vid file: size bytes. Relative names of
/// mesh files are looked up in the current directory.
/// V_ERR_FORMAT.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_load_from_memory(
    text: *const c_char,
    size: usize,
    scene: *mut *mut V_SCENE,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = Out::new(scene, "scene")?;
        most(size, MAX_TEXT, "size")?;
        // SAFETY: as many bytes, as the header says.
        let mut text = unsafe { slice(text.cast::<u8>(), size, "text") }?;
        let made = insert_loaded(SceneDocument::load_from(&mut text, "memory")?)?;
        // SAFETY: room for a handle, as the header says.
        unsafe { out.answer(made) }
    })
}

/// Creates a handle for a scene that was read, with warnings about its meshes.
fn insert_loaded(document: SceneDocument) -> Answer<*mut V_SCENE> {
    clear_last_warning();
    for warning in document.warnings() {
        add_last_warning(format_args!("{warning}."));
    }
    insert(document)
}

/// Gets the text of the .vid file of a scene. The names of mesh files are unchanged.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_save_to_memory(
    scene: *const V_SCENE,
    text: *mut c_char,
    capacity: usize,
    length: *mut usize,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = TextOut::new(text, capacity, length, "text")?;
        let written = read(scene, |document| Ok(document.to_toml()?))?;
        // SAFETY: room as the header says.
        unsafe { out.write(written.as_bytes()) }
    })
}

/// Saves a scene, like v_path_save().
/// V_ERR_IO.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_save(scene: *const V_SCENE, file: *const c_char) -> c_int {
    border(V_ERR_INTERNAL, || {
        // SAFETY: a zero-terminated text, as the header says.
        let file = unsafe { file_name(file, "file") }?;
        read(scene, |document| Ok(document.save(file)?))?;
        Ok(V_OK)
    })
}

/// Makes an independent copy of a scene, like v_path_clone().
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_clone(scene: *const V_SCENE, copy: *mut *mut V_SCENE) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = Out::new(copy, "copy")?;
        let made = insert(read(scene, |document| Ok(document.try_clone()?))?)?;
        // SAFETY: room for a handle, as the header says.
        unsafe { out.answer(made) }
    })
}

/// Frees a scene, like v_path_free().
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_free(scene: *mut V_SCENE) {
    border((), || {
        if !scene.is_null() {
            scene_handles::free(scene)?;
        }
        Ok(())
    });
}

/// ==== Nodes: groups, objects, lights and cameras ====
///
/// Adds a node after the others. *node receives its number; it may be NULL. name is
/// unique in its scene, one line, not empty.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_add_node(
    scene: *mut V_SCENE,
    name: *const c_char,
    values: *const V_NODE,
    node: *mut c_int,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = Out::optional(node, "node")?;
        // SAFETY: a zero-terminated text and a node, as the header says.
        let (name, given) = unsafe { (text(name, "name")?, read_growing(values, "values")?) };
        let mut made = self::node(&given)?;
        made.name = copied_name(name)?;
        let number = edit(scene, |document| Ok(document.scene.add(made)?))?;
        let number = pointers::count(number)?;
        // SAFETY: room for an int, as the header says.
        unsafe { out.answer(number) }
    })
}

/// Checks a name and copies it; may fail with `ErrorKind::Memory`.
pub(super) fn copied_name(text: &str) -> Answer<String> {
    check_name(text)?;
    copied(text)
}

/// Removes a node with all its descendants. The numbers of later nodes decrease;
/// nodes that aimed at a removed one no longer aim. Removing many in a row costs as
/// much as one.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_remove_node(scene: *mut V_SCENE, node: c_int) -> c_int {
    border(V_ERR_INTERNAL, || {
        let node = index(node, "node")?;
        scene_handles::remove_node(scene, node)
    })
}

/// Gets the number of the node with this name.
/// V_ERR_ARGUMENT (no such node).
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_find_node(
    scene: *const V_SCENE,
    name: *const c_char,
    node: *mut c_int,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = Out::new(node, "node")?;
        // SAFETY: a zero-terminated text, as the header says.
        let name = unsafe { text(name, "name") }?;
        let number = look(scene, |nodes| {
            let found = nodes.scene().find(name);
            let number = found.and_then(|place| nodes.number(place));
            pointers::count(number.ok_or_else(|| Invalid::NoNodeNamed(name.into()))?)
        })?;
        // SAFETY: room for an int, as the header says.
        unsafe { out.answer(number) }
    })
}

/// Gets the name of a node.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_get_name(
    scene: *const V_SCENE,
    node: c_int,
    name: *mut *const c_char,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let (out, node) = (Out::new(name, "name")?, index(node, "node")?);
        let lent = look(scene, |nodes| {
            let node = &nodes.scene().nodes()[nodes.place(node)?];
            Ok(thread_text(&node.name))
        })?;
        // SAFETY: room for a pointer, as the header says.
        unsafe { out.answer(lent) }
    })
}

/// Renames a node, see v_scene_add_node().
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_set_name(
    scene: *mut V_SCENE,
    node: c_int,
    name: *const c_char,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        // SAFETY: a zero-terminated text, as the header says.
        let (name, node) = (unsafe { text(name, "name") }?, index(node, "node")?);
        change(scene, |scene| scene.set_name(node, name))
    })
}

/// Gets a node at rest.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_get_node(
    scene: *const V_SCENE,
    node: c_int,
    values: *mut V_NODE,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        // SAFETY: a node as its size says, as the header demands.
        let (out, node) = (
            unsafe { GrowingOut::new(values, "values") }?,
            index(node, "node")?,
        );
        let found = look(scene, |nodes| {
            let found = &nodes.scene().nodes()[nodes.place(node)?];
            node_for_c(found, |link| nodes.number(link))
        })?;
        // SAFETY: as above.
        unsafe { out.answer(found) }
    })
}

/// Sets the values of a node; its kind does not change. If the parent changes,
/// position, rotation and scale are relative to the old one: the node keeps its place
/// in the world at the scene's first frame. A node that moves can only change to a
/// parent in the same place.
/// V_ERR_ARGUMENT (such as a cycle).
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_set_node(
    scene: *mut V_SCENE,
    node: c_int,
    values: *const V_NODE,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let node = index(node, "node")?;
        // SAFETY: a node, as the header says.
        let given = unsafe { read_growing(values, "values") }?;
        let mut made = self::node(&given)?;
        change(scene, |scene| {
            made.rest.aim_weight = scene.node(node)?.rest.aim_weight;
            scene.set_node(node, &made)
        })
    })
}

/// Makes a node follow a path; NULL: none. Pose n is shown at the scene's frame
/// start_frame + n - 1. The path moves position, rotation and zoom in the parent's
/// coordinates; a node with a track for one of them cannot have a path. after is
/// V_AFTER_HOLD, V_AFTER_REPEAT or V_AFTER_PINGPONG.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_set_path(
    scene: *mut V_SCENE,
    node: c_int,
    path: *const V_PATH,
    start_frame: f64,
    after: c_int,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let (node, after) = (index(node, "node")?, beyond(after)?);
        let follow = optional(path, |path| {
            let path = path::read(path, |document| Ok(document.path().try_clone()?))?;
            Ok(FollowPath::new(path, start_frame, after)?)
        })?;
        change(scene, |scene| scene.set_path(node, follow))
    })
}

/// Gets a copy of the path that a node follows, and its start_frame and after.
/// V_ERR_ARGUMENT (it follows none).
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_get_path(
    scene: *const V_SCENE,
    node: c_int,
    path: *mut *mut V_PATH,
    start_frame: *mut f64,
    after: *mut c_int,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let (out, node) = (Out::optional(path, "path")?, index(node, "node")?);
        let (start, beyond) = (
            Out::optional(start_frame, "start_frame")?,
            Out::optional(after, "after")?,
        );
        let (copy, from, how) = read(scene, |document| {
            let node = document.scene.node(node)?;
            let none = || Refused::NoPathOf((&node.name).into());
            let found = node.path().ok_or_else(none)?;
            let copy = (!path.is_null()).then(|| found.path().clone());
            Ok((copy, found.start_frame(), found.extrapolation() as c_int))
        })?;
        let made = copy.map(|copy| path::insert_new(copy, Info::default().fps));
        // SAFETY: room for a handle, a double and an int, as the header says.
        unsafe {
            start.write(from);
            beyond.write(how);
            out.answer(made.transpose()?.unwrap_or(ptr::null_mut()))
        }
    })
}

/// Sets a marker at a frame, or moves the one of this name (one line, not empty).
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_set_marker(
    scene: *mut V_SCENE,
    name: *const c_char,
    frame: f64,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        // SAFETY: a zero-terminated text, as the header says.
        let name = unsafe { text(name, "name") }?;
        change(scene, |scene| scene.set_marker(name, frame))
    })
}

/// Pins a point of a node's path to a marker; NULL removes the pin. Pins hold when
/// the path changes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_pin(
    scene: *mut V_SCENE,
    node: c_int,
    point: c_int,
    marker: *const c_char,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let (node, point) = (index(node, "node")?, index(point, "point")?);
        // SAFETY: a zero-terminated text, as the header says.
        let marker = optional(marker, |marker| unsafe { text(marker, "marker") })?;
        change(scene, |scene| scene.pin(node, point, marker))
    })
}
