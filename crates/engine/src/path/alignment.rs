//! Which way is up at the orientations of a path, and rolls that keep it so.

use glam::DVec3;

use super::ahead;
use super::camera_path::CameraPath;
use super::timeline::Timeline;
pub use super::ups::any;
use super::ups::rolled;
use crate::error::{Result, vec_with_room};
use crate::math::orientation::wrap_degrees;
use crate::math::rotation_minimising::{perpendicular, signed_angle};

/// Up with its roll, a unit vector of the world, at an orientation of the path of this timeline.
#[must_use]
pub fn up(path: &CameraPath, timeline: &Timeline, point: usize, orientation: usize) -> DVec3 {
    let axes = path.space.up;
    let view = ahead::view(path, point, orientation);
    let roll = path.points[point].orientations[orientation].roll;
    let reference = timeline.reference(path, (point, orientation), view);
    axes.world(rolled(axes.upright(view), reference, roll.to_radians()))
}

/// [`up`] of each orientation in turn.
///
/// # Errors
/// [`crate::Error::Memory`].
pub fn ups(path: &CameraPath) -> Result<Vec<DVec3>> {
    let timeline = Timeline::new(path)?;
    let mut ups = vec_with_room(path.points.iter().map(|p| p.orientations.len()).sum())?;
    for (point, here) in path.points.iter().enumerate() {
        ups.extend((0..here.orientations.len()).map(|at| up(path, &timeline, point, at)));
    }
    Ok(ups)
}

/// Rolls orientations so that they have the `wanted` ups (one entry for each orientation in turn,
/// `None` to leave its roll). Only those change whose up is not an axis; gives the point of each.
///
/// # Errors
/// [`crate::Error::Memory`].
pub fn keep_ups(path: &mut CameraPath, wanted: &[Option<DVec3>]) -> Result<Vec<usize>> {
    let mut changed = Vec::new();
    if !any(path) {
        return Ok(changed);
    }
    let now = ups(path)?;
    let mut all = now.iter().zip(wanted);
    for point in 0..path.points.len() {
        for at in 0..path.points[point].orientations.len() {
            let Some((now, wanted)) = all.next() else {
                return Ok(changed);
            };
            let view = ahead::view(path, point, at);
            let orientation = &mut path.points[point].orientations[at];
            if let Some(wanted) = wanted.and_then(|wanted| perpendicular(wanted, view))
                && !orientation.own.up.is_level()
            {
                let missing = signed_angle(*now, wanted, view).to_degrees();
                if missing.abs() > 1e-10 {
                    orientation.roll = wrap_degrees(orientation.roll + missing);
                    changed.try_reserve(1)?;
                    changed.push(point);
                }
            }
        }
    }
    Ok(changed)
}

#[cfg(test)]
#[path = "alignment_tests.rs"]
mod tests;
