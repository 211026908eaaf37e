//! Camera matrices for programs with other camera axes.

use std::ffi::c_int;

use glam::{DMat3, DMat4, DQuat, DVec3};

use super::border::border;
use super::curve::positive;
use super::pointers::{Out, read, read_array, read_vector};
use super::status::{Answer, Failure, V_ERR_INTERNAL};
use super::types::V_POSE;
use crate::math::camera::{CameraAxes, Clip};
use crate::math::euler::{euler, of_euler};

/// Conventions of camera axes, all right-handed.
///
/// V_AXES_OPENGL  x right, y up, z backward
/// V_AXES_OPENCV  x right, y down, z forward
/// V_AXES_ROS     x forward, y left, z up (REP 103)
/// V_AXES_VIDES   x left, y up, z forward: those of nodes (V_NODE_STATE) and of
///                v_view_from_quat()
pub const V_AXES_OPENGL: c_int = 0;
pub const V_AXES_OPENCV: c_int = 1;
pub const V_AXES_ROS: c_int = 2;
pub const V_AXES_VIDES: c_int = 3;

/// Clip coordinates, see v_pose_projection().
///
/// V_CLIP_OPENGL    y up, depth from -1 (near) to 1 (far)
/// V_CLIP_D3D       y up, depth from 0 to 1: Direct3D, Metal, WebGPU
/// V_CLIP_VULKAN    y down, depth from 0 to 1
/// V_CLIP_REVERSED  added to one of these: swaps near and far, so that a float depth from
///                  0 is precise far away
pub const V_CLIP_OPENGL: c_int = 0;
pub const V_CLIP_D3D: c_int = 1;
pub const V_CLIP_VULKAN: c_int = 2;
pub const V_CLIP_REVERSED: c_int = 16;

/// The order of three turns: the first letter is the axis of the first turn.
/// V_ORDER_XYZ is XYZ in Blender and ZYX in three.js; V_ORDER_ZXY is ZXY in Nuke.
pub const V_ORDER_XYZ: c_int = 0;
pub const V_ORDER_XZY: c_int = 1;
pub const V_ORDER_YXZ: c_int = 2;
pub const V_ORDER_YZX: c_int = 3;
pub const V_ORDER_ZXY: c_int = 4;
pub const V_ORDER_ZYX: c_int = 5;

/// The axes of an order, the first turn's first.
fn order(number: c_int) -> Answer<[usize; 3]> {
    match number {
        V_ORDER_XYZ => Ok([0, 1, 2]),
        V_ORDER_XZY => Ok([0, 2, 1]),
        V_ORDER_YXZ => Ok([1, 0, 2]),
        V_ORDER_YZX => Ok([1, 2, 0]),
        V_ORDER_ZXY => Ok([2, 0, 1]),
        V_ORDER_ZYX => Ok([2, 1, 0]),
        _ => Err(Failure::unknown(
            "order",
            number,
            "V_ORDER_XYZ (0), V_ORDER_XZY (1), V_ORDER_YXZ (2), V_ORDER_YZX (3), V_ORDER_ZXY (4), \
             V_ORDER_ZYX (5)",
        )),
    }
}

/// Checks that a matrix from C is that of a camera.
fn placed(axes: CameraAxes, matrix: DMat4, to_world: bool) -> Answer<[DVec3; 3]> {
    axes.of_matrix(matrix, to_world).ok_or(Failure::argument(
        "m is not the matrix of a camera: its numbers must be finite, its last row 0, 0, 0, 1, and \
         the rest a rotation with at most one scale for all axes",
    ))
}

fn pose_of([position, view, up]: [DVec3; 3], zoom: f64) -> V_POSE {
    V_POSE {
        vrp: position.to_array(),
        vpn: view.to_array(),
        vup: up.to_array(),
        zoom,
    }
}

fn axes(number: c_int) -> Answer<CameraAxes> {
    match number {
        V_AXES_OPENGL => Ok(CameraAxes::OpenGl),
        V_AXES_OPENCV => Ok(CameraAxes::OpenCv),
        V_AXES_ROS => Ok(CameraAxes::Ros),
        V_AXES_VIDES => Ok(CameraAxes::Vides),
        _ => Err(Failure::unknown(
            "convention",
            number,
            "V_AXES_OPENGL (0), V_AXES_OPENCV (1), V_AXES_ROS (2), V_AXES_VIDES (3)",
        )),
    }
}

fn clip(number: c_int) -> Answer<Clip> {
    let (from_minus_one, y_down) = match number & !V_CLIP_REVERSED {
        V_CLIP_OPENGL => (true, false),
        V_CLIP_D3D => (false, false),
        V_CLIP_VULKAN => (false, true),
        _ => {
            return Err(Failure::unknown(
                "convention",
                number,
                "V_CLIP_OPENGL (0), V_CLIP_D3D (1), V_CLIP_VULKAN (2), each with V_CLIP_REVERSED (16) too",
            ));
        }
    };
    Ok(Clip {
        from_minus_one,
        reversed: number & V_CLIP_REVERSED != 0,
        y_down,
    })
}

/// Gets the matrix of a camera: 16 numbers, column by column, for column vectors.
///
/// convention  the camera's axes, V_AXES_...
/// to_world  0: world to camera (the view matrix), with V_AXES_OPENGL that of
///     gluLookAt(), for glLoadMatrixd(). Otherwise camera to world: the columns are the
///     axes and vrp
/// cbindgen:ptrs-as-arrays=[[m; 16]]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_pose_matrix(
    pose: *const V_POSE,
    convention: c_int,
    to_world: c_int,
    m: *mut f64,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let m = Out::array(m, "m")?;
        // SAFETY: a pose, as the header demands.
        let pose = unsafe { read(pose, "pose") }?;
        let [vrp, vpn, vup] = [pose.vrp, pose.vpn, pose.vup].map(DVec3::from_array);
        let axes = axes(convention)?;
        let matrix = if to_world == 0 {
            axes.from_world(vrp, vpn, vup)?
        } else {
            axes.to_world(vrp, vpn, vup)?
        };
        // SAFETY: room for 16 doubles, as the header says.
        unsafe { m.answer(matrix.to_cols_array()) }
    })
}

/// Gets the pose of a camera from its matrix, the inverse of v_pose_matrix(). For a
/// matrix of glGetDoublev(GL_MODELVIEW_MATRIX), read before the object's own
/// transformations, use V_AXES_OPENGL and to_world 0. A scale common to all axes is
/// removed, and the axes are made perpendicular.
///
/// m  its last row is 0, 0, 0, 1
/// zoom  of the pose, finite and > 0; from a vertical angle: v_zoom_from_fov(angle,
///     24)
/// V_ERR_ARGUMENT (a matrix that mirrors, shears, projects or is not finite).
/// cbindgen:ptrs-as-arrays=[[m; 16]]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_pose_from_matrix(
    m: *const f64,
    convention: c_int,
    to_world: c_int,
    zoom: f64,
    pose: *mut V_POSE,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = Out::new(pose, "pose")?;
        // SAFETY: 16 doubles, as the header says.
        let m = DMat4::from_cols_array(&unsafe { read_array(m, "m") }?);
        let axes = axes(convention)?;
        positive(zoom, "zoom")?;
        let made = pose_of(placed(axes, m, to_world != 0)?, zoom);
        // SAFETY: room for a pose, as the header says.
        unsafe { out.answer(made) }
    })
}

/// Gets the orientation of a camera as three angles. At 0, 0, 0 the camera's axes lie
/// along the world's. It is turned about the fixed axes of the world in the order of
/// the letters: V_ORDER_XYZ is Rz Ry Rx for column vectors. Positive angles are
/// counter-clockwise, seen against the axis. With V_AXES_VIDES and V_ORDER_ZXY they
/// are pitch (positive looks down), yaw and roll in a world with y up.
///
/// convention  V_AXES_...; Blender and glTF use V_AXES_OPENGL
/// order  V_ORDER_...
/// angles  degrees about x, y and z. The second turn is within -90 to 90, the others
///     within -180 to 180. If it is 90 or -90, the others turn about the same axis and
///     share its angle
/// cbindgen:ptrs-as-arrays=[[angles; 3]]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_pose_to_euler(
    pose: *const V_POSE,
    convention: c_int,
    order: c_int,
    angles: *mut f64,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = Out::array(angles, "angles")?;
        // SAFETY: a pose, as the header demands.
        let pose = unsafe { read(pose, "pose") }?;
        let [vrp, vpn, vup] = [pose.vrp, pose.vpn, pose.vup].map(DVec3::from_array);
        let (axes, order) = (axes(convention)?, self::order(order)?);
        let turn = DQuat::from_mat3(&DMat3::from_mat4(axes.to_world(vrp, vpn, vup)?));
        // SAFETY: room for three doubles, as the header says.
        unsafe { out.answer(euler(turn, order).map(f64::to_degrees)) }
    })
}

/// Gets the pose of a camera at position vrp, turned by three angles: the inverse of
/// v_pose_to_euler(). Any finite angles are valid; zoom is finite and > 0.
/// cbindgen:ptrs-as-arrays=[[vrp; 3], [angles; 3]]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_pose_from_euler(
    vrp: *const f64,
    angles: *const f64,
    convention: c_int,
    order: c_int,
    zoom: f64,
    pose: *mut V_POSE,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = Out::new(pose, "pose")?;
        // SAFETY: three doubles each, as the header says.
        let (position, angles) = unsafe {
            (
                read_vector(vrp, "vrp")?,
                read_array::<f64, 3>(angles, "angles")?,
            )
        };
        let (axes, order) = (axes(convention)?, self::order(order)?);
        positive(zoom, "zoom")?;
        let given = [("vrp", position.to_array()), ("angles", angles)];
        for (name, numbers) in given {
            if let Some(&given) = numbers.iter().find(|number| !number.is_finite()) {
                return Err(Failure::NotFinite { name, given });
            }
        }
        let turn = of_euler(angles.map(f64::to_radians), &order);
        let matrix = DMat4::from_rotation_translation(turn, position);
        let made = pose_of(placed(axes, matrix, true)?, zoom);
        // SAFETY: room for a pose, as the header says.
        unsafe { out.answer(made) }
    })
}

/// Gets the projection matrix of a camera, for its zoom, to be applied after the view
/// matrix of V_AXES_OPENGL: 16 numbers, column by column, for column vectors (row by
/// row for row vectors, as Direct3D uses them).
///
/// aspect  width of the picture divided by its height
/// near_plane  distance of the front plane, > 0
/// far_plane  distance of the back plane, > near_plane; INFINITY: no back plane
/// convention  V_CLIP_..., optionally | V_CLIP_REVERSED
/// cbindgen:ptrs-as-arrays=[[m; 16]]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_pose_projection(
    pose: *const V_POSE,
    aspect: f64,
    near_plane: f64,
    far_plane: f64,
    convention: c_int,
    m: *mut f64,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let m = Out::array(m, "m")?;
        // SAFETY: a pose, as the header demands.
        let zoom = unsafe { read(pose, "pose") }?.zoom;
        let matrix = clip(convention)?.projection(zoom, aspect, near_plane, far_plane)?;
        // SAFETY: room for 16 doubles, as the header says.
        unsafe { m.answer(matrix.to_cols_array()) }
    })
}
