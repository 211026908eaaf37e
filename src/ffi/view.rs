//! The toolbox: views and matrices.

use std::ffi::c_int;

use glam::DVec3;

use super::border::border;
use super::pointers::{self, Growing, GrowingOut, Out, read_growing};
use super::status::V_ERR_INTERNAL;
use super::types::{V_POSE, V_VIEW};
use crate::math::view::{View, fov_from_zoom, zoom_from_fov};

fn from_c(view: &V_VIEW) -> View {
    View {
        vrp: DVec3::from_array(view.vrp),
        normal: DVec3::from_array(view.normal),
        up: DVec3::from_array(view.up),
        prp: DVec3::from_array(view.prp),
        window: view.window,
        front: view.front,
        back: view.back,
        distance: view.distance,
        perspective: view.perspective != 0,
    }
}

fn to_c(view: &View) -> V_VIEW {
    V_VIEW {
        size: size_of::<V_VIEW>(),
        vrp: view.vrp.to_array(),
        normal: view.normal.to_array(),
        up: view.up.to_array(),
        prp: view.prp.to_array(),
        window: view.window,
        front: view.front,
        back: view.back,
        distance: view.distance,
        perspective: c_int::from(view.perspective),
    }
}

// SAFETY: `repr(C)` with `size` first; numbers only.
unsafe impl Growing for V_VIEW {
    const NAME: &'static str = "V_VIEW";
    const FIRST: usize = size_of::<V_VIEW>();
}

/// Gets the matrix from world coordinates to the canonical volume of a view: 16
/// numbers, row by row, for column vectors. In a parallel projection, x and y are then
/// from -1 to 1, z 0 in the front plane and -1 in the back plane; in a perspective
/// projection, |x| and |y| at most z, and z 1 in the back plane.
/// V_ERR_ARGUMENT (up parallel to normal), V_ERR_RANGE (prp not in front of the front
/// plane, back plane not behind it, empty window).
/// cbindgen:ptrs-as-arrays=[[m; 16]]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_view_matrix(view: *const V_VIEW, m: *mut f64) -> c_int {
    border(V_ERR_INTERNAL, || {
        let m = Out::array(m, "m")?;
        // SAFETY: a struct as its size says, as the header demands.
        let view = unsafe { read_growing(view, "view") }?;
        let matrix = from_c(&view).matrix()?.transpose();
        // SAFETY: room for 16 doubles, as the header says.
        unsafe { m.answer(matrix.to_cols_array()) }
    })
}

/// Gets the perspective view of a camera in a pose. aspect is the picture's width
/// divided by its height; 0 < front < back are the planes' distances from the camera.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_view_from_pose(
    pose: *const V_POSE,
    aspect: f64,
    front: f64,
    back: f64,
    view: *mut V_VIEW,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        // SAFETY: a pose, and a struct as its size says, as the header demands.
        let (out, pose) = unsafe {
            (
                GrowingOut::new(view, "view")?,
                pointers::read(pose, "pose")?,
            )
        };
        let [vrp, vpn, vup] = [pose.vrp, pose.vpn, pose.vup].map(DVec3::from_array);
        let view = View::from_pose(vrp, vpn, vup, pose.zoom, aspect, front, back)?;
        // SAFETY: as above.
        unsafe { out.answer(to_c(&view)) }
    })
}

/// Returns the vertical field of view, in degrees, of a lens of zoom mm and a picture
/// height mm high: 2 atan (height / (2 zoom)). For the zoom of a V_POSE, height is
/// 24. NaN, with the reason in v_last_error(), unless both are finite and > 0.
#[unsafe(no_mangle)]
pub extern "C" fn v_fov_from_zoom(zoom: f64, height: f64) -> f64 {
    border(f64::NAN, || Ok(fov_from_zoom(zoom, height)?))
}

/// Returns the focal length in mm that gives a picture height mm high the vertical
/// field of view fov, in degrees: the inverse of v_fov_from_zoom(). NaN, with the
/// reason in v_last_error(), unless height is finite and > 0 and fov between 0 and
/// 180, both excluded.
#[unsafe(no_mangle)]
pub extern "C" fn v_zoom_from_fov(fov: f64, height: f64) -> f64 {
    border(f64::NAN, || Ok(zoom_from_fov(fov, height)?))
}
