//! A blend of paths, Σ αⱼ Pathⱼ with Σ αⱼ = 1 (lecture 9.3.2), point by point: exact for the curve.

use glam::DVec3;

use super::keep::{check_upright, keep_tangents};
use crate::error::{Invalid, OutOfRange, Result, vec_with_room};
use crate::limits::MAX_SECTION_FRAMES;
use crate::math::orientation::wrap_degrees;
use crate::path::resample::resample;
use crate::path::{
    CameraPath, Orientation, OrientationOverrides, Tangents, Target, Velocities, curve,
};

/// How far from 1 the weights' sum may be.
const SUM: f64 = 1e-9;

/// The weighted sum of some paths (`docs/reference/tools.md`, blend), resampled first where their numbers of
/// points differ. All that is not summed is that of the path with the greatest weight.
///
/// # Errors
/// [`crate::Error::Argument`] or [`crate::Error::Range`] for weights that are too few or do not sum
/// to 1, closed paths among open ones, results out of range; [`crate::Error::Memory`].
pub fn blend(paths: &[&CameraPath], weights: &[f64]) -> Result<CameraPath> {
    if paths.is_empty() || paths.len() != weights.len() {
        return Err(Invalid::PathWeights.into());
    }
    let sum: f64 = weights.iter().sum();
    if !((sum - 1.0).abs() <= SUM) {
        return Err(OutOfRange::WeightSum(sum).into());
    }
    if paths.iter().any(|path| path.closed != paths[0].closed) {
        return Err(Invalid::ClosedAndOpen.into());
    }
    check_upright(paths)?;
    let count = paths
        .iter()
        .map(|path| path.points.len())
        .max()
        .unwrap_or(0);
    let same = paths.iter().all(|path| path.points.len() == count);
    let mut resampled = vec_with_room(paths.len())?;
    if !same {
        for path in paths {
            resampled.push(resample(path, count)?);
        }
    }
    let mut all: Vec<(&CameraPath, f64)> = vec_with_room(paths.len())?;
    for (k, weight) in weights.iter().enumerate() {
        all.push((if same { paths[k] } else { &resampled[k] }, *weight));
    }
    let leader = (0..weights.len())
        .max_by(|a, b| weights[*a].total_cmp(&weights[*b]))
        .unwrap_or(0);
    let mut path = all[leader].0.try_clone()?;
    let mut wanted = vec_with_room(count)?;
    for (at, point) in path.points.iter_mut().enumerate() {
        let sum = |of: &dyn Fn(&CameraPath) -> DVec3| -> DVec3 {
            all.iter().map(|(path, weight)| *weight * of(path)).sum()
        };
        point.position = sum(&|path| path.points[at].position);
        point.tangents = None;
        wanted.push(Some(Tangents {
            before: sum(&|path| curve::tangents(path, at).before),
            after: sum(&|path| curve::tangents(path, at).after),
        }));
        for number in 0..point.orientations.len() {
            point.orientations[number] = blended(&all, leader, (at, number))?;
        }
    }
    path.check()?;
    keep_tangents(&mut path, &wanted)?;
    Ok(path)
}

fn blended(
    all: &[(&CameraPath, f64)],
    leader: usize,
    (at, number): (usize, usize),
) -> Result<Orientation> {
    let of = |k: usize| {
        let point = &all[k].0.points[at];
        (
            point,
            &point.orientations[number.min(point.orientations.len() - 1)],
        )
    };
    let sum =
        |value: &dyn Fn(usize) -> f64| -> f64 { (0..all.len()).map(|k| all[k].1 * value(k)).sum() };
    let vector = |value: &dyn Fn(usize) -> DVec3| -> DVec3 {
        (0..all.len()).map(|k| all[k].1 * value(k)).sum()
    };
    let first = of(leader).1;
    let mut new = first.clone();
    let absolute = (0..all.len()).all(|k| matches!(of(k).1.target, Target::Absolute(_)));
    new.target = if absolute {
        Target::Absolute(vector(&|k| match of(k).1.target {
            Target::Absolute(target) | Target::Relative(target) => target,
        }))
    } else {
        Target::Relative(vector(&|k| {
            let (point, orientation) = of(k);
            orientation.target.offset_from(point.position)
        }))
    };
    // Measured as the leader's is, and by the shorter way from it.
    let upright = all[leader].0.space.up;
    let level = first.own.up.level(upright);
    let roll = |k: usize| {
        let (point, orientation) = of(k);
        match (orientation.own.up.level(upright), level) {
            (Some(its), Some(level)) if its != level => {
                let view = orientation.view(point.position);
                let up = its.up_from_roll(view, orientation.roll.to_radians());
                level.roll_from_up(view, up).to_degrees()
            }
            _ => orientation.roll,
        }
    };
    new.roll = wrap_degrees(first.roll + sum(&|k| wrap_degrees(roll(k) - first.roll)));
    new.zoom = sum(&|k| of(k).1.zoom);
    for (n, speed) in new.speeds.iter_mut().enumerate() {
        *speed = sum(&|k| of(k).1.speeds[n]);
    }
    // Frames not fixed by all are the leader's; slopes and velocities not owned by all are not set.
    let owned = |value: &dyn Fn(&OrientationOverrides) -> Option<f64>| -> Option<f64> {
        let parts = (0..all.len()).map(|k| Some(all[k].1 * value(&of(k).1.own)?));
        parts.sum()
    };
    let velocity = |value: &dyn Fn(&Velocities) -> DVec3| -> Option<DVec3> {
        let parts = (0..all.len()).map(|k| {
            let own = of(k).1.own.velocities.as_ref()?;
            Some(all[k].1 * value(own))
        });
        parts.sum()
    };
    let fixed = |own: &OrientationOverrides| (own.frames > 0).then_some(f64::from(own.frames));
    let frames = owned(&fixed).map(|frames| frames.round().clamp(1.0, MAX_SECTION_FRAMES as f64));
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    let frames = frames.map_or(first.own.frames, |frames| frames as u32);
    let (locked, slopes) = (
        first.own.locked,
        [owned(&|own| own.roll_slope), owned(&|own| own.zoom_slope)],
    );
    let velocities = velocity(&|own| own.reach).zip(velocity(&|own| own.leave));
    let copy = first.own.for_a_copy()?;
    new.own = copy.with(|own| {
        (own.frames, own.locked) = (frames, locked);
        [own.roll_slope, own.zoom_slope] = slopes;
        own.velocities = velocities.map(|(reach, leave)| Velocities { reach, leave });
    })?;
    Ok(new)
}

#[cfg(test)]
#[path = "blend_tests.rs"]
mod tests;
