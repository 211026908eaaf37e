//! Scenes and their nodes.

use std::cell::UnsafeCell;
use std::ffi::{c_char, c_int};

use glam::{DQuat, DVec3};

use super::border::border;
use super::path;
use super::pointers::{
    self, Growing, GrowingOut, Out, TextOut, copied, file_name, index, init, numbered, optional,
    read_growing, slice, text,
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

/// Room for the name of a node or an interpolation, zero-terminated.
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

/// Converts a link to a node from C; −1 is none.
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

/// `number` gives what it is in and what it aims at its number.
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

/// ==== Scenes: made, loaded, saved, freed ====
///
/// A node of this kind at the origin: visible, scale 1, rotation 1 0 0 0, in
/// none, aiming at none, zoom 24, white, intensity 1, a cone of 20 and 30
/// degrees, planes at 0.01 and 1000. Sets size. A kind that is none stays as it
/// is and is refused where the node is used.
/// Any thread; from callbacks too. NULL does no harm; v_last_error() tells.
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

/// A new scene: one camera, "camera", on the path of v_path_new(), from frame 1
/// on. *scene is the caller's, to be freed with v_scene_free(). For one in a space of
/// the host's world: v_scene_set_space(), then v_scene_set_path() of node 0 with a path
/// of v_path_new_in_space().
/// Any thread; from callbacks too. V_ERR_NULL, V_ERR_MEMORY, V_ERR_LIMIT.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_new(scene: *mut *mut V_SCENE) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = Out::new(scene, "scene")?;
        let made = insert(SceneDocument::try_new()?)?;
        // SAFETY: room for a handle, as the header says.
        unsafe { out.answer(made) }
    })
}

/// Reads a scene from a .vid file; one with a path alone is that of a camera on
/// it. file is a name as open() takes it. *scene is the caller's, to be freed
/// with v_scene_free().
///
/// A mesh in a file of its own that is gone or broken leaves its object empty, and one
/// that has changed is taken: the answer is V_OK, and v_last_warning() tells, "" if all are
/// as they were.
/// Any thread; from callbacks too. V_ERR_NULL, V_ERR_IO, V_ERR_FORMAT (with
/// line and reason in v_last_error()), V_ERR_MEMORY, V_ERR_LIMIT. Memory that
/// runs out while the text itself is read or parsed ends the program.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_load(file: *const c_char, scene: *mut *mut V_SCENE) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = Out::new(scene, "scene")?;
        // SAFETY: a text ended by zero, as the header says.
        let made = insert_loaded(SceneDocument::load(unsafe { file_name(file, "file") }?)?)?;
        // SAFETY: room for a handle, as the header says.
        unsafe { out.answer(made) }
    })
}

/// Reads a scene from the text of a .vid file in memory, as v_scene_load() does; size bytes
/// of UTF-8, a zero behind them is not needed. Meshes in files of their own are looked for
/// where the program runs, if the text does not name them from the root. *scene is the
/// caller's, to be freed with v_scene_free().
/// Any thread; from callbacks too. V_ERR_NULL, V_ERR_FORMAT (with line and reason in
/// v_last_error()), V_ERR_MEMORY, V_ERR_LIMIT. Memory that runs out while the text is
/// parsed ends the program.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_load_from_memory(
    text: *const c_char,
    size: usize,
    scene: *mut *mut V_SCENE,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = Out::new(scene, "scene")?;
        // SAFETY: as many bytes, as the header says.
        let mut text = unsafe { slice(text.cast::<u8>(), size, "text") }?;
        let made = insert_loaded(SceneDocument::load_from(&mut text, "memory")?)?;
        // SAFETY: room for a handle, as the header says.
        unsafe { out.answer(made) }
    })
}

/// A handle for a scene that was read; tells what was wrong with its meshes.
fn insert_loaded(document: SceneDocument) -> Answer<*mut V_SCENE> {
    clear_last_warning();
    for warning in document.warnings() {
        add_last_warning(format_args!("{warning}."));
    }
    insert(document)
}

/// The text of a .vid file of a scene in memory, as v_path_save_to_memory() gives that of a
/// path; names of meshes' files stay as they are.
/// Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_SIZE, V_ERR_BUSY,
/// V_ERR_LIMIT, V_ERR_MEMORY.
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

/// Writes a scene into a .vid file, as v_path_save() writes a path: afterwards
/// the file is wholly the old or wholly the new one.
/// Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_IO,
/// V_ERR_BUSY, V_ERR_LIMIT, V_ERR_MEMORY. Memory that runs out while the file is
/// opened or written may end the program; the old file stays.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_save(scene: *const V_SCENE, file: *const c_char) -> c_int {
    border(V_ERR_INTERNAL, || {
        // SAFETY: a text ended by zero, as the header says.
        let file = unsafe { file_name(file, "file") }?;
        read(scene, |document| Ok(document.save(file)?))?;
        Ok(V_OK)
    })
}

/// An independent copy of a scene; geometry is shared until one of them changes
/// it. *copy is the caller's, to be freed with v_scene_free().
/// Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_BUSY,
/// V_ERR_MEMORY, V_ERR_LIMIT.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_clone(scene: *const V_SCENE, copy: *mut *mut V_SCENE) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = Out::new(copy, "copy")?;
        let made = insert(read(scene, |document| Ok(document.try_clone()?))?)?;
        // SAFETY: room for a handle, as the header says.
        unsafe { out.answer(made) }
    })
}

/// Frees a scene, see v_path_free(). NULL is no error.
/// Any thread; from callbacks too.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_free(scene: *mut V_SCENE) {
    border((), || {
        if !scene.is_null() {
            scene_handles::free(scene)?;
        }
        Ok(())
    });
}

/// ==== Nodes ====
///
/// How many nodes a scene has.
/// Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_BUSY.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_node_count(scene: *const V_SCENE, count: *mut c_int) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = Out::new(count, "count")?;
        let nodes = look(scene, |nodes| pointers::count(nodes.count()))?;
        // SAFETY: room for an int, as the header says.
        unsafe { out.answer(nodes) }
    })
}

/// Adds a node behind the others; *node is its number (NULL: not wanted). name
/// is unique in its scene: UTF-8, one line, not empty.
/// Any thread; from callbacks too. V_ERR_NULL,
/// V_ERR_HANDLE, V_ERR_SIZE, V_ERR_ARGUMENT, V_ERR_RANGE, V_ERR_LIMIT,
/// V_ERR_BUSY, V_ERR_MEMORY.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_add_node(
    scene: *mut V_SCENE,
    name: *const c_char,
    values: *const V_NODE,
    node: *mut c_int,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = Out::optional(node, "node")?;
        // SAFETY: a text ended by zero and a node, as the header says.
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

/// Removes a node with all that is in it. The numbers behind move up; who aimed
/// at one of them aims at none. Many in a row cost no more than one: count, names
/// and nodes may be asked for in between.
/// Any thread; from callbacks too. V_ERR_NULL,
/// V_ERR_HANDLE, V_ERR_RANGE, V_ERR_BUSY, V_ERR_MEMORY.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_remove_node(scene: *mut V_SCENE, node: c_int) -> c_int {
    border(V_ERR_INTERNAL, || {
        let node = index(node, "node")?;
        scene_handles::remove_node(scene, node)
    })
}

/// The number of the node with this name.
/// Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_ARGUMENT (no
/// such node), V_ERR_BUSY.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_find_node(
    scene: *const V_SCENE,
    name: *const c_char,
    node: *mut c_int,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = Out::new(node, "node")?;
        // SAFETY: a text ended by zero, as the header says.
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

/// A node's name. The text belongs to the library and is valid until the same
/// thread's next call of a function that gives one of a scene.
/// Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_RANGE,
/// V_ERR_BUSY.
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

/// Gives a node another name, see v_scene_add_node().
/// Any thread; from callbacks too. V_ERR_NULL,
/// V_ERR_HANDLE, V_ERR_ARGUMENT, V_ERR_RANGE, V_ERR_LIMIT, V_ERR_BUSY,
/// V_ERR_MEMORY.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_set_name(
    scene: *mut V_SCENE,
    node: c_int,
    name: *const c_char,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        // SAFETY: a text ended by zero, as the header says.
        let (name, node) = (unsafe { text(name, "name") }?, index(node, "node")?);
        change(scene, |scene| scene.set_name(node, name))
    })
}

/// A node at rest. values->size must be set.
/// Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_SIZE,
/// V_ERR_RANGE, V_ERR_BUSY.
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

/// Gives a node other values; its kind stays. With another parent it stays where
/// it is in the world at the scene's first frame: position, rotation and scale
/// are taken as of the old parent. A node that moves can only be given to a
/// parent that lies as the old one does.
/// Any thread; from callbacks too. V_ERR_NULL,
/// V_ERR_HANDLE, V_ERR_SIZE, V_ERR_ARGUMENT (cycles among them), V_ERR_RANGE,
/// V_ERR_LIMIT, V_ERR_BUSY, V_ERR_MEMORY.
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

/// ==== What moves a node ====
///
/// Gives a node a path to follow, copied; NULL: none. Its pose n is shown at the
/// scene's frame start_frame + n - 1. after: V_AFTER_HOLD, V_AFTER_REPEAT or
/// V_AFTER_PINGPONG, before the path too. A path moves position, rotation and
/// zoom, in the parent's coordinates; a node that has a track of one of them
/// takes none.
/// Any thread; from callbacks too. V_ERR_NULL,
/// V_ERR_HANDLE, V_ERR_ARGUMENT, V_ERR_RANGE, V_ERR_LIMIT, V_ERR_BUSY,
/// V_ERR_MEMORY.
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

/// A copy of the path that a node follows. *path is the caller's, to be freed
/// with v_path_free().
/// Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_ARGUMENT (it
/// follows none), V_ERR_RANGE, V_ERR_LIMIT, V_ERR_BUSY, V_ERR_MEMORY.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_get_path(
    scene: *const V_SCENE,
    node: c_int,
    path: *mut *mut V_PATH,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let (out, node) = (Out::new(path, "path")?, index(node, "node")?);
        let copy = read(scene, |document| {
            let node = document.scene.node(node)?;
            let none = || Refused::NoPathOf((&node.name).into());
            let found = node.path().ok_or_else(none)?;
            crate::error::can_allocate(document.scene.heap_size())?;
            Ok(found.path().clone())
        })?;
        let made = path::insert_new(copy, Info::default().fps)?;
        // SAFETY: room for a handle, as the header says.
        unsafe { out.answer(made) }
    })
}

/// Sets a marker, or moves the one of this name (UTF-8, one line, not empty).
/// Any thread; from callbacks too. V_ERR_NULL,
/// V_ERR_HANDLE, V_ERR_ARGUMENT, V_ERR_RANGE, V_ERR_LIMIT, V_ERR_BUSY,
/// V_ERR_MEMORY.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_set_marker(
    scene: *mut V_SCENE,
    name: *const c_char,
    frame: f64,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        // SAFETY: a text ended by zero, as the header says.
        let name = unsafe { text(name, "name") }?;
        change(scene, |scene| scene.set_marker(name, frame))
    })
}

/// Pins a support point of a node's path to a marker; NULL frees it. Pins are
/// kept and saved.
/// Any thread; from callbacks too. V_ERR_NULL,
/// V_ERR_HANDLE, V_ERR_ARGUMENT, V_ERR_RANGE, V_ERR_LIMIT, V_ERR_BUSY,
/// V_ERR_MEMORY.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_pin(
    scene: *mut V_SCENE,
    node: c_int,
    point: c_int,
    marker: *const c_char,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let (node, point) = (index(node, "node")?, index(point, "point")?);
        // SAFETY: a text ended by zero, as the header says.
        let marker = optional(marker, |marker| unsafe { text(marker, "marker") })?;
        change(scene, |scene| scene.pin(node, point, marker))
    })
}
