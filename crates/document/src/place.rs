//! Positions of new points: on a segment of the curve, or beyond an end.

use glam::DVec3;

use crate::error::{End, Refused, Result};
use vides_engine::limits::MAX_DIVISION;
use vides_engine::math::orientation::unit;
use vides_engine::path::CameraPath;
use vides_engine::path::arc_length::ArcLength;
use vides_engine::path::curve;
use vides_engine::path::hermite::Cubic;

/// The points that divide a segment into `count + 1` pieces of equal length, written into `room`.
pub(super) fn divide<'a>(
    path: &CameraPath,
    segment: usize,
    count: usize,
    room: &'a mut [DVec3; MAX_DIVISION],
) -> Result<&'a [DVec3]> {
    if segment >= path.segment_count() {
        let last = path.segment_count() - 1;
        return Err(if segment + 1 == path.points.len() {
            Refused::NoSegmentAtEnd.into()
        } else {
            Refused::NoSegment { segment, last }.into()
        });
    }
    if count == 0 || count > MAX_DIVISION {
        return Err(Refused::Division.into());
    }
    let curve = curve::segment(path, segment);
    let measure = ArcLength::new(&curve)?;
    let length = measure.length();
    for (index, place) in room[..count].iter_mut().enumerate() {
        let way = length * (index + 1) as f64 / (count + 1) as f64;
        *place = curve.point(measure.parameter_at(way));
    }
    Ok(&room[..count])
}

/// A position beyond an end along the tangent, as far as the end segment is long, within the space.
pub(super) fn beyond(path: &CameraPath, end: End) -> Result<DVec3> {
    if path.closed {
        return Err(Refused::NoEnds.into());
    }
    let segment = match end {
        End::First => 0,
        End::Last => path.segment_count() - 1,
    };
    let curve = curve::segment(path, segment);
    let length = ArcLength::new(&curve)?.length();
    let (from, way) = match end {
        End::First => (curve.d, way_in_at_start(&curve).map(|way| -way)),
        End::Last => (curve.end, way_out_at_end(&curve)),
    };
    let Some(way) = way else {
        return Err(Refused::NoDirection(end).into());
    };
    // An end that already lies outside must not be pulled back in.
    let (low, high) = (from.min(path.space.low()), from.max(path.space.high()));
    let place = (from + length * way).clamp(low, high);
    if place == from {
        return Err(Refused::NoRoom(end).into());
    }
    Ok(place)
}

/// Direction at the start: the first derivative that is not zero.
fn way_in_at_start(curve: &Cubic) -> Option<DVec3> {
    direction([curve.c, curve.b, curve.a])
}

/// Direction at the end, where the second derivative counts backwards.
fn way_out_at_end(curve: &Cubic) -> Option<DVec3> {
    direction([
        curve.derivative(1.0),
        -curve.second_derivative(1.0),
        curve.a,
    ])
}

/// The first vector that is not mere rounding error compared with the others.
fn direction(derivatives: [DVec3; 3]) -> Option<DVec3> {
    let size = |v: &DVec3| v.abs().max_element();
    let largest = derivatives.iter().map(size).fold(0.0, f64::max);
    derivatives
        .into_iter()
        .find(|v| size(v) > largest * 1e-12)
        .map(unit)
}
