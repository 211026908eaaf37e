//! The toolbox: quaternions and pairs of vectors.

use std::ffi::c_int;

use glam::{DQuat, DVec3};

use super::border::border;
use super::pointers::{Out, read_array, read_vector};
use super::status::{Answer, Failure, V_ERR_INTERNAL, V_OK};
use crate::error::Invalid;
use crate::math::orientation::{quaternion_from_view, unit, view_from_quaternion};
use crate::math::quaternion::slerp_shortest;
use crate::path::quaternion_spline::normalized;

/// Directions with a smaller sine of the angle between them count as parallel.
const PARALLEL: f64 = 1e-12;

/// Converts from C's order w x y z.
pub(super) fn from_c([w, x, y, z]: [f64; 4]) -> DQuat {
    DQuat::from_xyzw(x, y, z, w)
}

/// Converts to C's order w x y z.
pub(super) fn to_c(q: DQuat) -> [f64; 4] {
    [q.w, q.x, q.y, q.z]
}

/// Normalizes a quaternion from C.
fn unit_of(given: [f64; 4], name: &'static str) -> Answer<DQuat> {
    normalized(from_c(given)).map_err(|_| Failure::Zero(name))
}

/// Normalizes a direction from C.
fn direction(v: DVec3, name: &'static str) -> Answer<DVec3> {
    if !v.is_finite() || v == DVec3::ZERO {
        return Err(Failure::Zero(name));
    }
    Ok(unit(v))
}

/// Normalizes the view direction and up vector from C, and makes them perpendicular.
pub(super) fn view(vpn: DVec3, vup: DVec3) -> Answer<(DVec3, DVec3)> {
    let (view, up) = (direction(vpn, "vpn")?, direction(vup, "vup")?);
    let side = up.cross(view);
    if side.length() < PARALLEL {
        return Err(Invalid::UpParallel.into());
    }
    Ok((view, view.cross(unit(side))))
}

/// ==== Toolbox: formulas without a path ====
///
/// Gets the spherical linear interpolation from a (t = 0) to b (t = 1) by the shorter
/// arc, at any finite t.
///
/// Quaternions are w, x, y, z, not zero; they are normalized. The identity is a
/// camera that looks along (0, 0, 1) with (0, 1, 0) up. Results may be the same
/// arrays as arguments.
/// cbindgen:ptrs-as-arrays=[[a; 4], [b; 4], [q; 4]]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_quat_slerp(a: *const f64, b: *const f64, t: f64, q: *mut f64) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = Out::array(q, "q")?;
        // SAFETY: four doubles each, as the header says.
        let (a, b) = unsafe { (read_array(a, "a")?, read_array(b, "b")?) };
        if !t.is_finite() {
            return Err(Failure::NotFinite {
                name: "t",
                given: t,
            });
        }
        let q = slerp_shortest(unit_of(a, "a")?, unit_of(b, "b")?, t).normalize();
        // SAFETY: room for four doubles, as the header says.
        unsafe { out.answer(to_c(q)) }
    })
}

/// Gets the quaternion of a camera that looks along vpn with vup up, of any length
/// but 0, not parallel.
/// cbindgen:ptrs-as-arrays=[[vpn; 3], [vup; 3], [q; 4]]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_quat_from_view(vpn: *const f64, vup: *const f64, q: *mut f64) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = Out::array(q, "q")?;
        // SAFETY: three doubles each, as the header says.
        let (vpn, vup) = unsafe { (read_vector(vpn, "vpn")?, read_vector(vup, "vup")?) };
        let (view, up) = view(vpn, vup)?;
        let q = quaternion_from_view(view, up);
        // SAFETY: room for four doubles, as the header says.
        unsafe { out.answer(to_c(q)) }
    })
}

/// Gets the view direction and up vector of a quaternion.
/// cbindgen:ptrs-as-arrays=[[q; 4], [vpn; 3], [vup; 3]]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_view_from_quat(q: *const f64, vpn: *mut f64, vup: *mut f64) -> c_int {
    border(V_ERR_INTERNAL, || {
        let (vpn, vup) = (
            Out::optional_array(vpn, "vpn")?,
            Out::optional_array(vup, "vup")?,
        );
        // SAFETY: four doubles, as the header says.
        let q = unit_of(unsafe { read_array(q, "q") }?, "q")?;
        let (view, up) = view_from_quaternion(q);
        // SAFETY: room for three doubles each, as the header says.
        unsafe {
            vpn.write(view.to_array());
            vup.write(up.to_array());
        }
        Ok(V_OK)
    })
}
