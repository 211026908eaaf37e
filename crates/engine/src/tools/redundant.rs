//! Points without which the poses would be the same. Without a point the way from the point before
//! to the one behind has the frames of both sections; all other poses keep their frames.
//!
//! Only the points around it are planned: without a point, tangents and angular velocities change
//! at its neighbours alone, of a cubic spline by (2 − √3)ⁿ at the n-th one.

use std::sync::Arc;

use glam::{DQuat, DVec3};

use crate::error::Result;
use crate::limits::MIN_POINTS;
use crate::math::orientation::quaternion_from_view;
use crate::math::quaternion::{angle, continue_sign};
use crate::path::{CameraPath, Pose, Sampler, Timeline, curve, hermite::Cubic};
use crate::shared_list::SharedList;

/// By how much poses may differ: units of `half_size`, degrees, millimetres.
const SAME: [f64; 3] = [1e-3, 0.1, 0.1];

/// Points on either side that are planned, of a curve by T/C/B and of a cubic spline.
const AROUND: [usize; 2] = [3, 12];

/// More poses are compared at equal distances.
const MOST: usize = 500;

/// How the poses change without a point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Without {
    /// The greatest change, as a share of 1e-3 `half_size`, 0.1° or 0.1 mm.
    pub change: f64,
    /// The frames that the section before the point must own then; 0: by its length.
    pub frames: u32,
}

/// How the poses change without a point, if by less than `most` of what counts as the same.
///
/// # Errors
/// [`crate::Error::Memory`], as [`Sampler::pose`].
pub fn without(path: &CameraPath, point: usize, most: f64) -> Result<Option<Without>> {
    let count = path.points.len();
    // Without its first point a closed film begins elsewhere.
    let inner = (1..count - usize::from(!path.closed)).contains(&point);
    let here = &path.points[point];
    // Who gives a point tangents of its own wants it there: tools do.
    let plain =
        here.tangents.is_none() && here.orientations.len() == 1 && here.orientations[0].hold == 0;
    if !inner || !plain || count <= MIN_POINTS {
        return Ok(None);
    }
    let radius = AROUND[usize::from(path.curve.is_spline())];
    let (with, at) = around(path, point, radius)?;
    let mut less = with.try_clone()?;
    less.points.remove(at);
    if is_aside(&less, at - 1, here.position, most) {
        return Ok(None);
    }
    let timeline = Timeline::new(&with)?;
    let sampler = Sampler::new(&with, &timeline)?;
    let mut other = Timeline::new(&less)?;
    let last = less.points[at - 1].orientations.len() - 1;
    let frames = |timeline: &Timeline, point, orientation| {
        let found = timeline.section_from(point, orientation);
        found.map_or(0, |number| timeline.section(number).frames)
    };
    let wanted = frames(&timeline, at - 1, last) + frames(&timeline, at, 0);
    let mut fixed = 0;
    if frames(&other, at - 1, last) != wanted {
        let Ok(wanted) = u32::try_from(wanted) else {
            return Ok(None);
        };
        fixed = wanted;
        let begin = &mut less.points[at - 1].orientations[last];
        begin.own = begin.own.with(|own| own.frames = fixed)?;
        other = Timeline::new(&less)?;
    }
    let without = Sampler::new(&less, &other)?;
    let all = sampler.frame_count();
    if without.frame_count() != all {
        return Ok(None);
    }
    let mut change = 0.0_f64;
    for frame in (1..=all).step_by(all.div_ceil(MOST)) {
        let [a, b] = [&sampler, &without].map(|sampler| sampler.pose(frame as f64));
        change = change.max(apart(&a?, &b?, path.space.half_size));
        if change >= most {
            return Ok(None);
        }
    }
    let frames = fixed;
    Ok(Some(Without { change, frames }))
}

/// The points around one, as a separate path, and which of them it is.
fn around(path: &CameraPath, point: usize, radius: usize) -> Result<(CameraPath, usize)> {
    let count = path.points.len();
    if count <= 2 * radius + 1 {
        return Ok((path.try_clone()?, point));
    }
    let (first, end) = if path.closed {
        (point + count - radius, point + count + radius + 1)
    } else {
        (
            point.saturating_sub(radius),
            (point + radius + 1).min(count),
        )
    };
    let mut points = SharedList::new();
    for at in first..end {
        points.push(Arc::clone(path.points.get_shared(at % count)));
    }
    let at = if path.closed { radius } else { point - first };
    let closed = false;
    Ok((
        CameraPath {
            points,
            closed,
            ..*path
        },
        at,
    ))
}

/// Whether a place is farther from the segment behind a point than may be. Quick, for most points.
fn is_aside(path: &CameraPath, segment: usize, place: DVec3, most: f64) -> bool {
    let next = (segment + 1) % path.points.len();
    let [a, b] = [segment, next].map(|point| path.points[point].position);
    let (leave, reach) = (
        curve::tangents(path, segment).after,
        curve::tangents(path, next).before,
    );
    let cubic = Cubic::hermite(a, b, leave, reach);
    let places = (0..=128).map(|k| cubic.point(f64::from(k) / 128.0));
    let near = places.map(|p| p.distance_squared(place));
    // Half a step may lie between; steps are at most so long.
    let step = 1.5 * (leave.length() + reach.length() + a.distance(b)) / 128.0;
    near.fold(f64::INFINITY, f64::min).sqrt() > most * SAME[0] * path.space.half_size + step
}

/// How far two poses are apart, as a share of what counts as the same.
fn apart(a: &Pose, b: &Pose, half_size: f64) -> f64 {
    let turn = |pose: &Pose| -> DQuat { quaternion_from_view(pose.vpn.into(), pose.vup.into()) };
    let (p, q) = (turn(a), turn(b));
    let turned = 2.0 * angle(p, continue_sign(p, q).0);
    let far = DVec3::from_array(a.vrp).distance(b.vrp.into());
    let apart = [
        far / half_size,
        turned.to_degrees(),
        (a.zoom - b.zoom).abs(),
    ];
    let shares = apart.iter().zip(SAME).map(|(apart, same)| apart / same);
    shares.fold(0.0, f64::max)
}
