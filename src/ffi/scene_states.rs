//! The scene at a frame.

use std::ffi::{c_char, c_int, c_uchar};

use glam::DVec3;

use super::border::border;
use super::pointers::{ArrayOut, Out, check, index, slice_mut, text};
use super::scene_handles::read;
use super::scene_tracks::mesh_points;
use super::scene_types::{V_NODE_STATE, V_SCENE};
use super::status::{V_ERR_INTERNAL, V_OK, add_last_warning, clear_last_error, clear_last_warning};
use crate::document::SceneDocument;
use crate::error::vec_with_room;
use crate::scene::{Channel, NodeState, Warnings};

/// After a success: warns about failures of the host's interpolations, and clears
/// errors left by their own calls.
fn report(document: &SceneDocument, warnings: &Warnings) {
    clear_last_error();
    clear_last_warning();
    if let Some((node, message)) = warnings.first() {
        let name = document
            .scene
            .nodes()
            .get(node)
            .map_or("", |node| &node.name);
        add_last_warning(format_args!("node \"{name}\": {message}."));
    }
}

/// ==== Evaluation: the scene at a frame ====
///
/// Gets the first and last frame: those of v_scene_set_range(), otherwise those of all
/// paths and keys; 1 and 1 if nothing moves.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_frame_range(
    scene: *const V_SCENE,
    first: *mut f64,
    last: *mut f64,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let (first, last) = (Out::optional(first, "first")?, Out::optional(last, "last")?);
        let range = read(scene, |document| Ok(document.scene.frame_range()))?;
        // SAFETY: room for a double each, as the header says.
        unsafe {
            first.write(range.0);
            last.write(range.1);
        }
        Ok(V_OK)
    })
}

/// Gets the states of all nodes at any finite frame, in the order of their numbers.
///
/// If a "host:" interpolation is not registered, fails or returns a number that is
/// not finite, its channel steps from key to key; v_last_warning() reports it, also
/// after the functions below.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_evaluate(
    scene: *const V_SCENE,
    frame: f64,
    states: *mut V_NODE_STATE,
    capacity: usize,
    count: *mut usize,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        // The layouts are one, see `scene_types`.
        let out = ArrayOut::optional(
            states.cast::<NodeState>(),
            capacity,
            count,
            ["states", "count"],
        )?;
        let nodes = read(scene, |document| {
            let (scene, nodes) = (&document.scene, document.scene.nodes().len());
            // SAFETY: room for a size_t, as the header says.
            if nodes == 0 || !unsafe { out.wants(nodes) }? {
                crate::scene::motion::check_frame(frame)?;
                return Ok(nodes);
            }
            scene.prepare(frame)?;
            let mut warnings = Warnings::default();
            if scene.is_plain() {
                // No host function is called: evaluate in place.
                // SAFETY: room for that many states, as the header says; any bits make one.
                scene.evaluate(frame, unsafe { out.room(nodes) }?, &mut warnings)?;
            } else {
                // Not in place: a host's function may fail half way or read the array.
                let mut made = vec_with_room(nodes)?;
                made.resize(nodes, NodeState::default());
                scene.evaluate(frame, &mut made, &mut warnings)?;
                // SAFETY: as above.
                unsafe { out.room(nodes) }?.copy_from_slice(&made);
            }
            report(document, &warnings);
            Ok(nodes)
        })?;
        // SAFETY: room for a size_t, as the header says.
        unsafe { out.answer(nodes) }
    })
}

/// Gets count states of one node, at the frames first, first + frame_step and so on.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_sample(
    scene: *const V_SCENE,
    node: c_int,
    first: f64,
    frame_step: f64,
    states: *mut V_NODE_STATE,
    count: usize,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let node = index(node, "node")?;
        if count > 0 {
            check(states, "states")?;
        }
        read(scene, |document| {
            let scene = &document.scene;
            scene.node(node)?;
            scene.prepare(first)?;
            let mut warnings = Warnings::default();
            // SAFETY: room for that many states, as the header says; the layouts are one (see
            // `scene_types`), and any bits make a state.
            let out = || unsafe { slice_mut(states.cast(), count, "states") };
            if scene.is_plain() && count > 0 {
                // As in `v_scene_evaluate`: memory that is touched for the first time costs as much.
                scene.sample(node, first, frame_step, out()?, &mut warnings)?;
            } else {
                let mut made = vec_with_room(count)?;
                made.resize(count, NodeState::default());
                scene.sample(node, first, frame_step, &mut made, &mut warnings)?;
                if count > 0 {
                    out()?.copy_from_slice(&made);
                }
            }
            report(document, &warnings);
            Ok(())
        })?;
        Ok(V_OK)
    })
}

/// Gets the value of a channel at a frame, with or without a track, and the number of
/// its components.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_value(
    scene: *const V_SCENE,
    node: c_int,
    channel: *const c_char,
    frame: f64,
    values: *mut f64,
    capacity: usize,
    width: *mut usize,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let (out, node) = (
            ArrayOut::optional(values, capacity, width, ["values", "width"])?,
            index(node, "node")?,
        );
        // SAFETY: a zero-terminated text, as the header says.
        let channel = Channel::parse(unsafe { text(channel, "channel") }?)?;
        let numbers = read(scene, |document| {
            let mut warnings = Warnings::default();
            let value = document.scene.value(node, &channel, frame, &mut warnings)?;
            report(document, &warnings);
            Ok(value)
        })?;
        // SAFETY: room for that many numbers and a size_t, as the header says.
        unsafe {
            if out.wants(numbers.len())? {
                out.room(numbers.len())?.copy_from_slice(&numbers);
            }
            out.answer(numbers.len())
        }
    })
}

/// Gets the points of an object at a frame, morphed and deformed, in the coordinates
/// of the node, and their colours, morphed likewise (unchanged if the mesh has none).
/// capacity and *points count points.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_vertices(
    scene: *const V_SCENE,
    node: c_int,
    frame: f64,
    xyz: *mut f64,
    rgb: *mut c_uchar,
    capacity: usize,
    points: *mut usize,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        const { assert!(size_of::<DVec3>() == 24 && align_of::<DVec3>() == 8) };
        let (xyz, node) = (xyz.cast::<DVec3>(), index(node, "node")?);
        let out = ArrayOut::optional(xyz, capacity, points, ["xyz", "points"])?;
        let colours =
            ArrayOut::optional(rgb.cast::<[u8; 3]>(), capacity, points, ["rgb", "points"])?;
        let count = read(scene, |document| {
            let count = mesh_points(&document.scene.node(node)?.kind);
            // SAFETY: room for a size_t, as the header says.
            let wanted = unsafe { [out.wants(count)?, colours.wants(count)?] };
            let mut warnings = Warnings::default();
            let form = document.scene.form(node, frame, &mut warnings)?;
            if wanted[0] && count > 0 {
                // SAFETY: room for that many points, as the header says; a point is three doubles,
                // and no host function runs meanwhile.
                form.points(unsafe { out.room(count) }?);
            }
            if wanted[1] {
                let made = document.scene.vertex_colours(node, frame, &mut warnings)?;
                if !made.is_empty() {
                    // SAFETY: room for so many colours, as the header says.
                    unsafe { colours.room(count) }?.copy_from_slice(&made);
                }
            }
            report(document, &warnings);
            Ok(count)
        })?;
        // SAFETY: room for a size_t, as the header says.
        unsafe { out.answer(count) }
    })
}
