//! What holds for a whole path: base speeds, closed or open, modes.

use std::ffi::c_int;

use super::border::border;
use super::path::{edit, read};
use super::pointers::Out;
use super::status::{Answer, V_ERR_INTERNAL, V_OK};
use super::types::V_PATH;
use crate::document::Edit;
use crate::error::Error;
use crate::path::{BaseSpeeds, OrientationMode, ZoomMode};

/// ==== Modes, see v_path_set_modes() ====
///
/// V_ORIENTATION_TCB            smooth turning with limited speeds; the default
/// V_ORIENTATION_BARRY_GOLDMAN  smooth turning, the curve of Barry and Goldman
/// V_ORIENTATION_SLERP          straight from orientation to orientation
/// V_ZOOM_SMOOTH                smooth and without overshoot; the default
/// V_ZOOM_LINEAR                straight from value to value
pub const V_ORIENTATION_TCB: c_int = 0;
pub const V_ORIENTATION_BARRY_GOLDMAN: c_int = 1;
pub const V_ORIENTATION_SLERP: c_int = 2;
pub const V_ZOOM_SMOOTH: c_int = 0;
pub const V_ZOOM_LINEAR: c_int = 1;

fn orientation_mode(number: c_int) -> Answer<OrientationMode> {
    match number {
        V_ORIENTATION_TCB => Ok(OrientationMode::Tcb),
        V_ORIENTATION_BARRY_GOLDMAN => Ok(OrientationMode::BarryGoldman),
        V_ORIENTATION_SLERP => Ok(OrientationMode::Slerp),
        _ => Err(Error::Range("there is no such orientation mode".into()).into()),
    }
}

fn zoom_mode(number: c_int) -> Answer<ZoomMode> {
    match number {
        V_ZOOM_SMOOTH => Ok(ZoomMode::Smooth),
        V_ZOOM_LINEAR => Ok(ZoomMode::Linear),
        _ => Err(Error::Range("there is no such zoom mode".into()).into()),
    }
}

/// ==== What holds for the whole path ====
///
/// Sets the base speeds, each finite and > 0: the poses at speed 50 for a way
/// of length 1 (move), for turning by 180 degrees (orient), for the zoom from
/// 1 to 100 (zoom), for rolling by 90 degrees (winkel).
/// Any thread that has the path for itself; from callbacks too. V_ERR_NULL,
/// V_ERR_HANDLE, V_ERR_ARGUMENT.
///
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_set_speeds(
    path: *mut V_PATH,
    r#move: f64,
    orient: f64,
    zoom: f64,
    winkel: f64,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let speeds = BaseSpeeds {
            movement: r#move,
            turning: orient,
            zoom,
            rolling: winkel,
        };
        edit(path, Edit::SetSpeeds(speeds))
    })
}

/// The base speeds, see v_path_set_speeds(). Each result may be NULL.
/// Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_get_speeds(
    path: *const V_PATH,
    r#move: *mut f64,
    orient: *mut f64,
    zoom: *mut f64,
    winkel: *mut f64,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let (movement, turning) = (Out::optional(r#move)?, Out::optional(orient)?);
        let (zoom, rolling) = (Out::optional(zoom)?, Out::optional(winkel)?);
        let speeds = read(path, |document| Ok(document.path().speeds))?;
        // SAFETY: room for a double each, as the header says.
        unsafe {
            movement.write(speeds.movement);
            turning.write(speeds.turning);
            zoom.write(speeds.zoom);
            rolling.write(speeds.rolling);
        }
        Ok(V_OK)
    })
}

/// Joins the last support point to the first by one more segment (not 0), or
/// opens the path (0).
/// Any thread that has the path for itself; from callbacks too. V_ERR_NULL,
/// V_ERR_HANDLE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_set_closed(path: *mut V_PATH, closed: c_int) -> c_int {
    border(V_ERR_INTERNAL, || edit(path, Edit::SetClosed(closed != 0)))
}

/// Whether a path is closed: 1 or 0.
/// Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_get_closed(path: *const V_PATH, closed: *mut c_int) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = Out::new(closed)?;
        let closed = read(path, |document| Ok(document.path().closed))?;
        // SAFETY: room for an int, as the header says.
        unsafe { out.write(c_int::from(closed)) };
        Ok(V_OK)
    })
}

/// Sets how the camera turns between its orientations (V_ORIENTATION_TCB,
/// V_ORIENTATION_BARRY_GOLDMAN, V_ORIENTATION_SLERP) and how the zoom runs
/// (V_ZOOM_SMOOTH, V_ZOOM_LINEAR).
/// Any thread that has the path for itself; from callbacks too. V_ERR_NULL,
/// V_ERR_HANDLE, V_ERR_RANGE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_set_modes(
    path: *mut V_PATH,
    orientation_mode: c_int,
    zoom_mode: c_int,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let turning = self::orientation_mode(orientation_mode)?;
        let zooming = self::zoom_mode(zoom_mode)?;
        edit(path, Edit::SetModes(turning, zooming))
    })
}

/// The modes, see v_path_set_modes(). Each result may be NULL.
/// Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_get_modes(
    path: *const V_PATH,
    orientation_mode: *mut c_int,
    zoom_mode: *mut c_int,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let (turning, zooming) = (Out::optional(orientation_mode)?, Out::optional(zoom_mode)?);
        let (orientation_mode, zoom_mode) = read(path, |document| {
            let path = document.path();
            Ok((path.orientation_mode, path.zoom_mode))
        })?;
        // SAFETY: room for an int each, as the header says.
        unsafe {
            turning.write(match orientation_mode {
                OrientationMode::Tcb => V_ORIENTATION_TCB,
                OrientationMode::BarryGoldman => V_ORIENTATION_BARRY_GOLDMAN,
                OrientationMode::Slerp => V_ORIENTATION_SLERP,
            });
            zooming.write(match zoom_mode {
                ZoomMode::Smooth => V_ZOOM_SMOOTH,
                ZoomMode::Linear => V_ZOOM_LINEAR,
            });
        }
        Ok(V_OK)
    })
}
