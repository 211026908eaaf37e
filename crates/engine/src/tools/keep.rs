//! What tools share: points picked out of a path, and curves that stay while points change.

use crate::error::{Invalid, Result, vec_with_room};
use crate::path::{CameraPath, CurveParameters, Tangents, alignment, curve};
use glam::DVec3;

/// Tangents are the same within this share of their length.
const SAME: f64 = 1e-14;

/// A cubic spline is cut where a point comes to own its tangents, which moves its neighbours by
/// rounding; the next round sees that.
const ROUNDS: usize = 8;

/// True at each of the points.
pub(super) fn picked(path: &CameraPath, points: &[usize]) -> Result<Vec<bool>> {
    if points.is_empty() {
        return Err(Invalid::NothingSelected.into());
    }
    let count = path.points.len();
    let mut picked = vec_with_room(count)?;
    picked.resize(count, false);
    for &point in points {
        *picked.get_mut(point).ok_or_else(|| path.no_point(point))? = true;
    }
    Ok(picked)
}

/// Rolls are measured against the vertical: paths that are put together must share it.
pub(super) fn check_upright(paths: &[&CameraPath]) -> Result<()> {
    if paths
        .windows(2)
        .any(|pair| pair[0].space.up != pair[1].space.up)
    {
        return Err(Invalid::UprightDiffers.into());
    }
    Ok(())
}

/// Up at the orientations of each point; nothing where all ups are the axis.
pub(super) fn ups(path: &CameraPath) -> Result<Vec<Vec<Option<DVec3>>>> {
    let mut found = Vec::new();
    if !alignment::any(path) {
        return Ok(found);
    }
    let mut all = alignment::ups(path)?.into_iter().map(Some);
    found = vec_with_room(path.points.len())?;
    for point in &path.points {
        let mut ups = vec_with_room(point.orientations.len())?;
        ups.extend(all.by_ref().take(point.orientations.len()));
        found.push(ups);
    }
    Ok(found)
}

pub(super) fn tangents(path: &CameraPath) -> Result<Vec<Option<Tangents>>> {
    let mut found = vec_with_room(path.points.len())?;
    found.extend((0..path.points.len()).map(|point| Some(curve::tangents(path, point))));
    Ok(found)
}

/// Lets those points own their tangents that would have others than is wanted.
pub(crate) fn keep_tangents(path: &mut CameraPath, wanted: &[Option<Tangents>]) -> Result<()> {
    let last = path.points.len() - 1;
    for _ in 0..ROUNDS {
        let mut settled = true;
        for (point, wanted) in wanted.iter().enumerate() {
            let Some(mut wanted) = *wanted else { continue };
            if !path.closed && point == 0 {
                wanted.before = wanted.after;
            } else if !path.closed && point == last {
                wanted.after = wanted.before;
            }
            let is = curve::tangents(path, point);
            let size = wanted.before.length() + wanted.after.length();
            let far = (is.before - wanted.before).length() + (is.after - wanted.after).length();
            if far > SAME * size {
                path.points[point].tangents = Some(wanted);
                settled = false;
            }
        }
        if settled || !path.curve.is_spline() {
            break;
        }
    }
    path.check()
}

/// The same shape of the curve at a point of `from` in a path with other presets.
pub(super) fn shape_in(
    path: &CameraPath,
    from: &CameraPath,
    curve: CurveParameters,
) -> CurveParameters {
    match curve {
        CurveParameters::Preset(number) => {
            let number = usize::from(number);
            if path.presets[number] == from.presets[number] {
                curve
            } else {
                CurveParameters::Own(from.presets[number])
            }
        }
        own => own,
    }
}
