//! Matrices of a camera for programs with axes of their own.

use std::ffi::c_int;

use glam::DVec3;

use super::border::border;
use super::pointers::{Out, read};
use super::status::{Answer, Failure, V_ERR_INTERNAL};
use super::types::V_POSE;
use crate::math::camera::{CameraAxes, Clip};

/// ==== Axes of a camera, see v_pose_matrix() ====
///
/// All are right-handed.
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

/// ==== Clip coordinates, see v_pose_projection() ====
///
/// V_CLIP_OPENGL    y up, depth from -1 (near) to 1 (far)
/// V_CLIP_D3D       y up, depth from 0 to 1: Direct3D, Metal, WebGPU
/// V_CLIP_VULKAN    y down, depth from 0 to 1
/// V_CLIP_REVERSED  added to one of them: near and far change places, so that depth
///                  in float stays exact far away (with depth from 0)
pub const V_CLIP_OPENGL: c_int = 0;
pub const V_CLIP_D3D: c_int = 1;
pub const V_CLIP_VULKAN: c_int = 2;
pub const V_CLIP_REVERSED: c_int = 16;

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

/// The matrix of a camera in a pose, for programs whose cameras have other axes than
/// OpenGL's: 16 numbers by columns, for column vectors.
///
/// convention  the camera's axes, V_AXES_...
/// to_world    0: from world coordinates into the camera's (the view matrix); with
///     V_AXES_OPENGL that of v_pose_gl_matrix(), bit for bit. Else from the camera's
///     into the world's: its columns are the axes and vrp
/// Any thread; from callbacks too. V_ERR_NULL, V_ERR_ARGUMENT, V_ERR_RANGE.
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

/// The projection of a camera in a pose, behind the view matrix of v_pose_gl_matrix(),
/// which looks along -z, whatever the convention: 16 numbers by columns, for column
/// vectors (the same numbers by rows, for row vectors, as Direct3D takes them). Of the
/// pose only the zoom counts: vertically 2 atan (12 / zoom) are seen.
///
/// aspect      the picture's width by its height
/// near_plane  distance of the front plane, > 0
/// far_plane   that of the back plane, > near_plane; INFINITY: there is none
/// convention  V_CLIP_..., | V_CLIP_REVERSED
/// Any thread; from callbacks too. V_ERR_NULL, V_ERR_RANGE.
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
