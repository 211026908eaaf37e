//! Which numbers and names a path or a scene may have.

use glam::DVec3;

use crate::error::{Invalid, OutOfRange, Quantity, Result, TooMany};
use crate::limits;

/// Finite, and small enough to compute with.
///
/// # Errors
/// [`crate::Error::Argument`] if not finite, [`crate::Error::Range`] if too large.
pub fn check_coordinates(v: DVec3) -> Result<()> {
    if !v.is_finite() {
        return Err(Invalid::NotFinite(Quantity::Coordinate).into());
    }
    if v.abs().max_element() > limits::MAX_COORDINATE {
        return Err(OutOfRange::Exceeds(Quantity::Coordinate, limits::MAX_COORDINATE).into());
    }
    Ok(())
}

/// One line of text: no control characters, at most [`limits::MAX_NAME_BYTES`] bytes.
///
/// # Errors
/// [`crate::Error::Argument`] or [`crate::Error::Limit`].
pub fn check_name(name: &str) -> Result<()> {
    if name.len() > limits::MAX_NAME_BYTES {
        return Err(TooMany::NameBytes.into());
    }
    if name.chars().any(char::is_control) {
        return Err(Invalid::ControlCharacter.into());
    }
    Ok(())
}

/// A tension, continuity or bias (`what` says which): in [−1, 1].
///
/// # Errors
/// [`crate::Error::Range`].
pub fn check_shape(value: f64, what: Quantity) -> Result<()> {
    if !(-1.0..=1.0).contains(&value) {
        return Err(OutOfRange::Between(what, -1.0, 1.0).into());
    }
    Ok(())
}

/// A zoom: 1…2000.
///
/// # Errors
/// [`crate::Error::Range`].
pub fn check_zoom(zoom: f64) -> Result<()> {
    if !(limits::MIN_ZOOM..=limits::MAX_ZOOM).contains(&zoom) {
        return Err(OutOfRange::Between(Quantity::Zoom, limits::MIN_ZOOM, limits::MAX_ZOOM).into());
    }
    Ok(())
}

/// One value of a speed curve: 1…100.
///
/// # Errors
/// [`crate::Error::Range`].
pub fn check_curve_speed(speed: f64) -> Result<()> {
    if !(limits::MIN_SPEED..=limits::MAX_SPEED).contains(&speed) {
        return Err(OutOfRange::Between(Quantity::CurveSpeed, 1.0, limits::MAX_SPEED).into());
    }
    Ok(())
}
