//! Tracks, the host's own interpolations, objects and deformations.

use std::ffi::{c_char, c_int, c_uchar, c_void};
use std::sync::Arc;

use glam::DVec3;

use super::border::border;
use super::pointers::{
    Out, file_name, index, most, optional, read_array, read_growing, slice, slice_mut, text,
};
use super::scene::{beyond, copied_name, thread_text};
use super::scene_handles::{change, edit, read, within_callback};
use super::scene_types::*;
use super::status::{Answer, Failure, Name, V_ERR_INTERNAL, V_OK};
use crate::deform::{Bounds, Deformation};
use crate::document::load_mesh;
use crate::error::{can_allocate, vec_with_room};
use crate::limits::{MAX_KEYS, MAX_MESH_CORNERS, MAX_MESH_POINTS, MAX_SCENE_NUMBERS};
use crate::scene::host::{self, Function};
use crate::scene::{Channel, Extrapolation, Interpolation, Kind, Mesh, Shape, Track};

/// Copies numbers from C.
///
/// # Safety
/// `from` is NULL or points to `count` numbers.
unsafe fn numbers(from: *const f64, count: usize, name: &'static str) -> Answer<Vec<f64>> {
    // SAFETY: as required of the caller.
    let from = unsafe { slice(from, count, name) }?;
    let mut copy = vec_with_room(count)?;
    copy.extend_from_slice(from);
    Ok(copy)
}

/// Copies points from C.
///
/// # Safety
/// `xyz` is NULL or points to three numbers for each.
unsafe fn points(
    xyz: *const f64,
    count: usize,
    [name, count_name]: [Name; 2],
) -> Answer<Vec<DVec3>> {
    if count == 0 {
        return Ok(Vec::new());
    }
    most(count, MAX_MESH_POINTS, count_name)?;
    // SAFETY: as required of the caller.
    let from = unsafe { slice(xyz, 3 * count, name) }?;
    let mut points = vec_with_room(count)?;
    points.extend(from.chunks_exact(3).map(DVec3::from_slice));
    Ok(points)
}

/// How many numbers a key of the channel has.
fn width(scene: *const V_SCENE, node: usize, channel: &Channel, euler: bool) -> Answer<usize> {
    read(scene, |document| {
        let width = channel.width(document.scene.node(node)?)?;
        Ok(if euler { 3 } else { width })
    })
}

/// ==== Tracks: values by keys ====
///
/// Sets the keys of a channel, replacing older ones; 0 keys remove the track.
///
/// channel  "position", "rotation" (w x y z), "scale", "visible" (0 or 1); for cameras
///     "roll" (degrees) and, unless they follow a path, "zoom" (mm); for lights
///     "colour", "intensity", "cone"; for objects "colour", "weights" (one per shape)
///     and "deformation.N.NAME" (N from 0; NAME of v_deform()); for cameras and lights
///     "aim_weight" (0 to 1); for your own use "value:NAME" or "value:NAME:W" with W
///     numbers (1 to 16)
/// interpolation  "step", "linear", "ramp", "sine", "parabolic", "catmull-rom",
///     "hermite", "tcb", "cubic" (not for rotations), "host:NAME"; for rotations also
///     "euler-linear" and "euler-catmull-rom", with yaw, pitch and roll in degrees per
///     key. "visible" takes only "step"
/// frames  strictly increasing
/// values  keys x width numbers, key by key
/// shape  "hermite": the tangents before and after each key (2 x width, per frame);
///     "tcb": tension, continuity and bias of each key; otherwise NULL
/// after  V_AFTER_..., optionally | V_BEFORE_...
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_set_track(
    scene: *mut V_SCENE,
    node: c_int,
    channel: *const c_char,
    interpolation: *const c_char,
    frames: *const f64,
    values: *const f64,
    shape: *const f64,
    keys: usize,
    after: c_int,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let node = index(node, "node")?;
        // SAFETY: a zero-terminated text, as the header says.
        let channel = Channel::parse(unsafe { text(channel, "channel") }?)?;
        if keys == 0 {
            return change(scene, |scene| scene.remove_track(node, &channel));
        }
        // SAFETY: a zero-terminated text, as the header says.
        let interpolation = Interpolation::parse(unsafe { text(interpolation, "interpolation") }?)?;
        let (before, after) = both(after)?;
        most(keys, MAX_KEYS, "keys")?;
        let euler = matches!(
            interpolation,
            Interpolation::EulerLinear | Interpolation::EulerCatmullRom
        );
        let width = width(scene, node, &channel, euler)?;
        most(
            keys.saturating_mul(width),
            MAX_SCENE_NUMBERS,
            "the count of values",
        )?;
        // SAFETY: as many numbers as the header says.
        let (frames, values) = unsafe {
            (
                numbers(frames, keys, "frames")?,
                numbers(values, keys * width, "values")?,
            )
        };
        let shaped = match interpolation {
            Interpolation::Hermite => 2 * width,
            Interpolation::Tcb => 3,
            _ => 0,
        };
        let shape = if shaped == 0 {
            Vec::new()
        } else {
            // SAFETY: as many numbers as the header says.
            unsafe { numbers(shape, keys * shaped, "shape") }?
        };
        let track = Track::new(channel, interpolation, frames, values, shape)?;
        let track = track.with_extrapolation(before, after)?;
        change(scene, |scene| scene.set_track(node, track))
    })
}

/// The continuation before and after the keys, from C's one number.
fn both(after: c_int) -> Answer<(Extrapolation, Extrapolation)> {
    if !(0..64).contains(&after) {
        return Err(Failure::unknown(
            "after",
            after,
            "V_AFTER_HOLD (0), V_AFTER_REPEAT (1), V_AFTER_PINGPONG (2), V_AFTER_OFFSET (3), each \
             alone or with V_BEFORE_REPEAT (16), V_BEFORE_PINGPONG (32) or V_BEFORE_OFFSET (48)",
        ));
    }
    Ok((beyond(after >> 4)?, beyond(after & 15)?))
}

/// Gets the keys of a channel as set. *keys receives their number, 0 if there is no
/// track (*interpolation is then ""). capacity counts keys.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_get_track(
    scene: *const V_SCENE,
    node: c_int,
    channel: *const c_char,
    interpolation: *mut *const c_char,
    capacity: usize,
    frames: *mut f64,
    values: *mut f64,
    shape: *mut f64,
    keys: *mut usize,
    after: *mut c_int,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let (name, count) = (
            Out::optional(interpolation, "interpolation")?,
            Out::optional(keys, "keys")?,
        );
        let (after, node) = (Out::optional(after, "after")?, index(node, "node")?);
        for (room, name) in [(frames, "frames"), (values, "values"), (shape, "shape")] {
            Out::optional(room, name)?;
        }
        // SAFETY: a zero-terminated text, as the header says.
        let channel = Channel::parse(unsafe { text(channel, "channel") }?)?;
        read(scene, |document| {
            let node = document.scene.node(node)?;
            let Some(track) = node.keys().track(&channel) else {
                channel.width(node)?;
                // SAFETY: room for each result, as the header says.
                unsafe {
                    name.write(thread_text(""));
                    count.write(0);
                    after.write(V_AFTER_HOLD);
                }
                return Ok(());
            };
            let wanted = [
                (frames, track.frames(), "frames"),
                (values, track.values(), "values"),
                (shape, track.shape(), "shape"),
            ];
            let needed = track.frames().len();
            let some = wanted.iter().find(|(room, ..)| !room.is_null());
            if let Some(&(.., name)) = some.filter(|_| needed > capacity) {
                // SAFETY: room for a size_t, as the header says.
                unsafe { count.write(needed) };
                return Err(Failure::NoRoom {
                    name,
                    room: capacity,
                    needed,
                });
            }
            for (room, numbers, name) in wanted {
                if !room.is_null() && !numbers.is_empty() {
                    // SAFETY: room for that many keys, as the header says.
                    unsafe { slice_mut(room, numbers.len(), name) }?.copy_from_slice(numbers);
                }
            }
            let (before, behind) = track.extrapolation();
            let text = thread_text(&track.interpolation().to_string());
            // SAFETY: room for each result, as the header says.
            unsafe {
                name.write(text);
                count.write(track.frames().len());
                after.write(behind as c_int | (before as c_int) << 4);
            }
            Ok(())
        })?;
        Ok(V_OK)
    })
}

/// Computes the value of a channel at a frame between its first and last key, from the
/// frames and the values of the keys, width numbers each. It writes width numbers to
/// value and returns V_OK; if it returns anything else, or writes a number that is not
/// finite, the channel steps from key to key.
pub type V_INTERPOLATE = Option<
    unsafe extern "C" fn(
        frames: *const f64,
        values: *const f64,
        width: usize,
        keys: usize,
        frame: f64,
        value: *mut f64,
        user: *mut c_void,
    ) -> c_int,
>;

struct Host {
    function: unsafe extern "C" fn(
        *const f64,
        *const f64,
        usize,
        usize,
        f64,
        *mut f64,
        *mut c_void,
    ) -> c_int,
    user: *mut c_void,
}

// SAFETY: the header says that any thread evaluating a scene calls the function with this pointer,
// which is not dereferenced here.
unsafe impl Send for Host {}
// SAFETY: as above.
unsafe impl Sync for Host {}

impl Host {
    fn ask(&self, question: host::Question<'_>, value: &mut [f64]) -> bool {
        let status = within_callback(|| {
            let function = self.function;
            // SAFETY: the host's own function, with arrays as the header says.
            unsafe {
                enter!("interpolation", function(
                    question.frames.as_ptr() => *const f64,
                    question.values.as_ptr() => *const f64,
                    question.width => usize,
                    question.frames.len() => usize,
                    question.frame => f64,
                    value.as_mut_ptr() => *mut f64,
                    self.user => *mut c_void,
                ) -> c_int)
            }
        });
        status == V_OK
    }
}

/// Registers a function as the interpolation "host:NAME" for all scenes of the
/// process, replacing an older one; NULL removes it. Any thread that evaluates a
/// scene calls it. It must not use scenes, and no longjmp() and no exception may
/// leave it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_register_interpolation(
    name: *const c_char,
    function: V_INTERPOLATE,
    user: *mut c_void,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        // SAFETY: a zero-terminated text, as the header says.
        let name = unsafe { text(name, "name") }?;
        let name = name.strip_prefix("host:").unwrap_or(name);
        let function = match function {
            None => None,
            Some(function) => {
                can_allocate(256)?;
                let host = Host { function, user };
                let function: Arc<Function> =
                    Arc::new(move |question: host::Question<'_>, value: &mut [f64]| {
                        host.ask(question, value)
                    });
                Some(function)
            }
        };
        host::register(name, function)?;
        Ok(V_OK)
    })
}

/// ==== Objects: meshes, shapes and deformations ====
///
/// Sets the geometry of an object. If the object has shapes, the mesh must have as many
/// points as they have.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_set_geometry(
    scene: *mut V_SCENE,
    node: c_int,
    mesh: *const V_MESH,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let node = index(node, "node")?;
        // SAFETY: a mesh, as the header says.
        let mesh = unsafe { self::mesh(mesh, "mesh") }?;
        change(scene, |scene| scene.set_mesh(node, mesh))
    })
}

/// Reads the geometry of an object from an OBJ, PLY, STL or glTF file, by its
/// extension. A saved .vid file refers to that file, by a relative name if it is in
/// the same folder or below.
/// V_ERR_IO, V_ERR_FORMAT.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_load_geometry(
    scene: *mut V_SCENE,
    node: c_int,
    file: *const c_char,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let node = index(node, "node")?;
        // SAFETY: a zero-terminated text, as the header says.
        let file = unsafe { file_name(file, "file") }?;
        read(scene, |document| Ok(document.scene.node(node).map(drop)?))?;
        // The lock is not held while the file is read.
        let (source, mesh) = load_mesh(file)?;
        change(scene, |scene| scene.set_mesh_of(node, source, mesh))
    })
}

/// Copies a mesh from C.
///
/// # Safety
/// `mesh` is NULL or points to a mesh whose arrays are as long as it says.
pub(super) unsafe fn mesh(mesh: *const V_MESH, name: &'static str) -> Answer<Mesh> {
    // SAFETY: as required of the caller.
    let given = unsafe { read_growing(mesh, name) }?;
    // SAFETY: as required of the caller, for each of the arrays.
    unsafe {
        let field = |field| Name::Field(name, field);
        let points = points(given.xyz, given.points, [field("xyz"), field("points")])?;
        let mut colours = Vec::new();
        if !given.rgb.is_null() && !points.is_empty() {
            let from = slice(given.rgb, 3 * points.len(), field("rgb"))?;
            colours = vec_with_room(points.len())?;
            colours.extend(from.chunks_exact(3).map(|c| [c[0], c[1], c[2]]));
        }
        Ok(Mesh {
            lines: indices(
                given.lines,
                given.line_ends,
                [field("lines"), field("line_ends")],
            )?,
            triangles: indices(
                given.triangles,
                given.corners,
                [field("triangles"), field("corners")],
            )?,
            points,
            colours,
        })
    }
}

/// Copies indices from C in groups.
///
/// # Safety
/// `from` is NULL or points to `count` indices.
unsafe fn indices<const N: usize>(
    from: *const u32,
    count: usize,
    [name, count_name]: [Name; 2],
) -> Answer<Vec<[u32; N]>> {
    if count == 0 {
        return Ok(Vec::new());
    }
    most(count, MAX_MESH_CORNERS, count_name)?;
    // SAFETY: as required of the caller.
    let (groups, rest) = unsafe { slice(from, count, name) }?.as_chunks::<N>();
    if !rest.is_empty() {
        return Err(Failure::NotMultiple {
            name: count_name,
            given: count,
            of: N,
        });
    }
    let mut copy = vec_with_room(groups.len())?;
    copy.extend_from_slice(groups);
    Ok(copy)
}

/// Adds a shape to an object: other positions for all its points, with weight 0 at
/// first. The channel "weights" has one number per shape; the mesh itself gets the
/// remainder to 1.
///
/// rgb  three bytes per point; NULL: the colours of the mesh
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_add_shape(
    scene: *mut V_SCENE,
    node: c_int,
    name: *const c_char,
    xyz: *const f64,
    rgb: *const c_uchar,
    points: usize,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let node = index(node, "node")?;
        // SAFETY: a zero-terminated text, and so many points and colours, as the header says.
        let shape = unsafe {
            let mut colours = Vec::new();
            if let Some(given) = optional(rgb, |rgb| slice(rgb.cast(), points, "rgb"))? {
                colours = vec_with_room(points)?;
                colours.extend_from_slice(given);
            }
            Shape {
                name: copied_name(text(name, "name")?)?,
                points: self::points(xyz, points, ["xyz", "points"].map(Name::Parameter))?,
                colours,
            }
        };
        change(scene, |scene| scene.add_shape(node, shape))
    })
}

/// A deformation from C.
///
/// # Safety
/// As the header says of v_deform().
pub(super) unsafe fn deformation(
    kind: *const c_char,
    parameters: *const f64,
    count: usize,
) -> Answer<Deformation> {
    most(count, 3 * crate::deform::LATTICE, "count")?;
    // SAFETY: as required of the caller.
    let (kind, parameters) =
        unsafe { (text(kind, "kind")?, slice(parameters, count, "parameters")?) };
    Ok(Deformation::new(kind, parameters)?)
}

/// A box from C.
///
/// # Safety
/// `corners` is NULL or points to six readable doubles.
pub(super) unsafe fn bounds(corners: *const f64) -> Answer<Bounds> {
    // SAFETY: as required of the caller.
    let [a, b, c, d, e, f] = unsafe { read_array(corners, "box") }?;
    Ok(Bounds::new(DVec3::new(a, b, c), DVec3::new(d, e, f))?)
}

/// Adds a deformation (see v_deform()) to an object, after the others. *at receives its
/// number and may be NULL. box NULL: the bounds of the geometry at rest.
/// cbindgen:ptrs-as-arrays=[[box; 6]]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_add_deformation(
    scene: *mut V_SCENE,
    node: c_int,
    kind: *const c_char,
    parameters: *const f64,
    count: usize,
    r#box: *const f64,
    at: *mut c_int,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let (out, node) = (Out::optional(at, "at")?, index(node, "node")?);
        // SAFETY: as the header says.
        let deformation = unsafe { deformation(kind, parameters, count) }?;
        // SAFETY: six doubles, as the header says.
        let bounds = optional(r#box, |corners| unsafe { bounds(corners) })?;
        let number = edit(scene, |document| {
            Ok(document.scene.add_deformation(node, deformation, bounds)?)
        })?;
        let number = super::pointers::count(number)?;
        // SAFETY: room for an int, as the header says.
        unsafe { out.answer(number) }
    })
}

/// Removes a deformation with its tracks. The numbers of later deformations decrease,
/// in the names of channels too.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_scene_remove_deformation(
    scene: *mut V_SCENE,
    node: c_int,
    at: c_int,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let (node, at) = (index(node, "node")?, index(at, "at")?);
        change(scene, |scene| scene.remove_deformation(node, at))
    })
}

/// Deforms points in place. u, v, w run from -1 to 1 along the sides of the box (min x
/// y z, max x y z); along a side of length 0 points do not move. Axes are 0, 1, 2.
/// Angles are degrees in u, v, w, stretched with a box that is not a cube. Tracks can
/// animate the names in parentheses.
///
/// "taper"      axis a (a): the other two times 1 + (a-1)(1-u^2)
/// "taper"      axis r0 r1 (r0 r1): from r0 at one end to r1 at the other
/// "twist"      axis angle (angle): about the axis, from 0 to angle
/// "bend"       axis angle (angle): about the axis; the middle does not move
/// "bend"       axis_u axis_v u0 v0 phi_min phi_max (the last four): u becomes
///              the angle about (u0, v0), v - v0 the distance from it
/// "free-form"  64 points, 3 numbers each (points): a Bezier volume over the box,
///              the first index fastest; (-1, -1, -1), (-1/3, -1, -1) ... is the
///              identity. Points outside the box do not move
/// cbindgen:ptrs-as-arrays=[[box; 6]]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_deform(
    kind: *const c_char,
    parameters: *const f64,
    count: usize,
    r#box: *const f64,
    xyz: *mut f64,
    points: usize,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        // SAFETY: as the header says.
        let deformation = unsafe { deformation(kind, parameters, count) }?;
        // SAFETY: six doubles, as the header says.
        let bounds = unsafe { bounds(r#box) }?;
        // SAFETY: that many points, as the header says.
        let mut deformed =
            unsafe { self::points(xyz, points, ["xyz", "points"].map(Name::Parameter)) }?;
        for &point in &deformed {
            crate::path::camera_path::check_coordinates(point)?;
        }
        deformation.apply(&bounds, &mut deformed);
        if points > 0 {
            // SAFETY: that many points, as the header says.
            let out = unsafe { slice_mut(xyz, 3 * points, "xyz") }?;
            for (out, point) in out.chunks_exact_mut(3).zip(deformed) {
                out.copy_from_slice(&point.to_array());
            }
        }
        Ok(V_OK)
    })
}

/// The number of points in an object's mesh.
pub(super) fn mesh_points(kind: &Kind) -> usize {
    match kind {
        Kind::Object(object) => object.mesh().points.len(),
        _ => 0,
    }
}
