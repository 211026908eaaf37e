//! A path through points at equal lengths of another one.

use glam::DVec3;

use super::camera_path::{CameraPath, CurveParameters, Orientation, SupportPoint, Target};
use super::own::Tangents;
use super::sampling::Sampler;
use super::timeline::Timeline;
use super::turning::Turning;
use super::up_vector::UpVector;
use crate::error::{Invalid, OutOfRange, Result, TooMany, vec_with_room};
use crate::limits::{MAX_POINTS, MAX_SPEED, MIN_POINTS, MIN_SPEED, SPEEDS};
use crate::math::orientation::{roll_from_up, unit, wrap_degrees};

/// A path of `count` points at equal lengths along another, with the views, the zoom and the mean
/// speed there. Each point owns its tangents; turns on the spot are left out.
///
/// # Errors
/// [`crate::Error::Argument`] if the camera does not move; [`crate::Error::Range`] for fewer than
/// two points; [`crate::Error::Limit`], [`crate::Error::Memory`].
#[allow(clippy::cast_precision_loss)]
pub fn resample(path: &CameraPath, count: usize) -> Result<CameraPath> {
    if count < MIN_POINTS {
        return Err(OutOfRange::TooFewSupportPoints.into());
    }
    if count > MAX_POINTS {
        return Err(TooMany::SupportPoints.into());
    }
    let timeline = Timeline::new(path)?;
    let sampler = Sampler::new(path, &timeline)?;
    let ways = || {
        let all = sampler.sections().iter();
        all.filter_map(|sampled| Some((sampled, sampled.way.as_ref()?)))
    };
    let length: f64 = ways().map(|(_, way)| way.length).sum();
    let steps = if path.closed { count } else { count - 1 };
    let step = length / steps as f64;
    let mut points = vec_with_room(count)?;
    let (mut begin, mut rest) = (0.0, ways());
    let Some(mut here) = rest.next() else {
        return Err(Invalid::NoWay.into());
    };
    for k in 0..count {
        let s = step * k as f64;
        while s > begin + here.1.length
            && let Some(next) = rest.next()
        {
            begin += here.1.length;
            here = next;
        }
        let (sampled, way) = here;
        let share = ((s - begin) / way.length).clamp(0.0, 1.0);
        let tables = sampled.prepared()?;
        let pose = sampled.pose(tables, share);
        let slope = way.curve.derivative(way.parameter(&tables.arc, share));
        let position = DVec3::from_array(pose.vrp);
        let view = DVec3::from_array(pose.vpn);
        let mut point = SupportPoint::try_new(position)?;
        let axes = sampled.space.up;
        let [level, up] = [view, DVec3::from_array(pose.vup)].map(|v| axes.upright(v));
        point.curve = CurveParameters::Preset(0);
        let along = step * slope.try_normalize().unwrap_or_default();
        point.tangents = Some(Tangents {
            before: along,
            after: along,
        });
        let target = match sampled.turning {
            Turning::Tracked(target, _) if target != position => Target::Absolute(target),
            _ => Target::Relative(view * path.space.half_size),
        };
        point.orientations[0] = Orientation {
            target,
            roll: wrap_degrees(roll_from_up(unit(level), up).to_degrees()),
            zoom: pose.zoom,
            speeds: [timeline
                .section(sampled.section)
                .mean_speed
                .clamp(MIN_SPEED, MAX_SPEED); SPEEDS],
            ..Orientation::default()
        };
        if axes != path.space.up {
            let own = &mut point.orientations[0].own;
            *own = own.with(|own| own.up = UpVector::Fixed(axes))?;
        }
        points.push(point);
    }
    let new = CameraPath {
        points: points.into(),
        ..*path
    };
    new.check()?;
    Ok(new)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fewer_points_than_a_path_has_are_refused() {
        for closed in [false, true] {
            let path = CameraPath {
                closed,
                ..CameraPath::default()
            };
            for count in [0, 1, MAX_POINTS + 1] {
                assert!(resample(&path, count).is_err(), "{closed} {count}");
            }
            assert_eq!(resample(&path, 2).unwrap().points.len(), 2);
        }
    }
}
