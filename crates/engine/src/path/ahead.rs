//! Views along the way, by tangent or secant (Kolb, Computergraphik II, 9.2.2).

use std::sync::Arc;

use glam::DVec3;

use super::arc_length::ArcLength;
use super::camera_path::CameraPath;
use super::chain::Chain;
use super::curve;
use super::dispatch;
use super::frenet::Normals;
use super::hermite::{Cubic, NO_TANGENT, end_direction};
use super::space::{Space, Up};
use super::up_path::UpPath;
use crate::error::{Result, try_arc};
use crate::math::orientation::unit;
use crate::math::rotation_minimising::{chord, perpendicular, step, turned};

/// A camera nearer to its target than this, in units of `half_size`, has no direction.
pub(super) const AT_TARGET: f64 = 1e-9;

/// Direction in which a point is left; without one, the last before it, else the next after it.
fn direction_at(path: &CameraPath, point: usize) -> Option<DVec3> {
    let (count, segments) = (path.points.len(), path.segment_count());
    let leaving = |point: usize| {
        (point < segments)
            .then(|| end_direction(&curve::segment(path, point), false))
            .flatten()
    };
    let arriving = |point: usize| {
        let before = if point > 0 { point - 1 } else { count - 1 };
        (before < segments)
            .then(|| end_direction(&curve::segment(path, before), true))
            .flatten()
    };
    let around = |steps: usize| if path.closed { steps % count } else { steps };
    leaving(point)
        .or_else(|| {
            let turns = if path.closed { count } else { point + 1 };
            (0..turns).find_map(|back| arriving(around(point + count - back) % count))
        })
        .or_else(|| {
            let turns = if path.closed { count } else { count - point };
            (0..turns).find_map(|steps| leaving(around(point + steps)))
        })
}

/// The place `distance` along the curve from a point, measuring one segment after the other.
fn place_after(path: &CameraPath, point: usize, distance: f64) -> Option<DVec3> {
    let (count, segments) = (path.points.len(), path.segment_count());
    let mut left = distance;
    let mut total = 0.0;
    let mut segment = point;
    let mut steps = 0;
    loop {
        if segment >= segments {
            let end = direction_at(path, count - 1)?;
            return Some(path.points[count - 1].position + left * end);
        }
        let cubic = curve::segment(path, segment);
        let length = dispatch::length(&cubic);
        if left <= length {
            let arc = ArcLength::new(&cubic).ok()?;
            return Some(cubic.point(arc.parameter_at(left)));
        }
        left -= length;
        total += length;
        steps += 1;
        if steps == segments && path.closed {
            // Once round: whole rounds lead back here.
            if total <= 0.0 {
                return None;
            }
            left %= total;
        }
        segment = if path.closed {
            (segment + 1) % count
        } else {
            segment + 1
        };
    }
}

/// The view of an orientation: along the way, if it looks ahead and there is one, or to its target.
///
/// # Panics
/// If there is no such orientation.
#[must_use]
pub fn view(path: &CameraPath, point: usize, orientation: usize) -> DVec3 {
    let here = &path.points[point];
    let orientation = &here.orientations[orientation];
    let ahead = orientation.own.ahead.and_then(|distance| {
        if distance == 0.0 {
            return direction_at(path, point);
        }
        let there = place_after(path, point, distance)? - here.position;
        if there == DVec3::ZERO {
            direction_at(path, point)
        } else {
            Some(unit(there))
        }
    });
    ahead.unwrap_or_else(|| orientation.view(here.position))
}

/// The curve of a whole path by its length.
#[derive(Debug, PartialEq)]
pub(super) struct Rail {
    pub chain: Chain,
    closed: bool,
    /// Direction at the end of an open path.
    end: DVec3,
    pub space: Space,
}

impl Rail {
    pub(super) fn new(
        path: &CameraPath,
        segments: impl ExactSizeIterator<Item = (Cubic, f64)>,
    ) -> Result<Arc<Self>> {
        let chain = Chain::new(segments)?;
        let end = direction_at(path, path.points.len() - 1);
        try_arc(Self {
            chain,
            closed: path.closed,
            end: end.unwrap_or(path.space.up.world(DVec3::Z)),
            space: path.space,
        })
    }

    /// The place at the length `after` from the start of a segment.
    fn place(&self, segment: usize, after: f64) -> Option<DVec3> {
        let (mut s, length) = (self.chain.starts[segment] + after, self.chain.length());
        if self.closed {
            s %= length;
        } else if s >= length {
            let last = self.chain.curves.last()?;
            return Some(last.point(1.0) + (s - length) * self.end);
        }
        self.chain.place(s)
    }
}

/// Where a section looks that follows a rule.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Look {
    /// At this distance ahead along the way; 0: along the tangent.
    Ahead(f64),
    /// At a point of the world.
    Target(DVec3),
    /// In the direction of both its keys.
    Still,
}

#[derive(Debug, Clone, PartialEq)]
pub(super) struct Follow {
    pub rail: Arc<Rail>,
    /// The segment along which it leads and its length; `None` where it stays.
    pub segment: Option<(usize, f64)>,
    pub look: Look,
    /// The view where the way has no direction at all, in y-up axes.
    pub still: DVec3,
    /// Which way is up; `None`: an axis.
    pub up: Option<UpAlong>,
    /// That axis.
    pub level: Up,
    /// Roll in radians in powers of φ.
    pub roll: [f64; 4],
}

impl Follow {
    /// The direction at φ in y-up axes, if there is one.
    pub(super) fn direction(&self, phi: f64) -> Option<DVec3> {
        let Some((segment, length)) = self.segment else {
            return Some(self.still);
        };
        if self.look == Look::Still {
            return Some(self.still);
        }
        let arc = ArcLength::new(&self.rail.chain.curves[segment]).ok()?;
        let t = arc.parameter_at(phi * length);
        Some(
            self.rail
                .space
                .up
                .upright(self.look_direction((segment, length), t, phi)?),
        )
    }

    /// The direction at the parameter `t` of the segment, φ of its length.
    pub(super) fn look_direction(
        &self,
        (segment, length): (usize, f64),
        t: f64,
        phi: f64,
    ) -> Option<DVec3> {
        let curve = &self.rail.chain.curves[segment];
        match self.look {
            Look::Still => Some(self.rail.space.up.world(self.still)),
            Look::Target(target) => {
                let offset = target - curve.point(t);
                let near = AT_TARGET * self.rail.space.half_size;
                (offset.length() >= near).then(|| unit(offset))
            }
            Look::Ahead(distance) if distance > 0.0 => {
                let there = self.rail.place(segment, phi * length + distance)?;
                let offset = there - curve.point(t);
                (offset.length() > NO_TANGENT * distance).then(|| unit(offset))
            }
            Look::Ahead(_) if t <= 0.0 || t >= 1.0 => end_direction(curve, t >= 1.0),
            Look::Ahead(_) => {
                let derivative = curve.derivative(t);
                let size = curve.a.length() + curve.b.length() + curve.c.length();
                (derivative.length() > NO_TANGENT * size).then(|| unit(derivative))
            }
        }
    }

    /// Up before the roll at φ for a view there, both in y-up axes, if the rule gives one.
    pub(super) fn reference(&self, up: &UpAlong, phi: f64, view: DVec3) -> Option<DVec3> {
        let axes = self.rail.space.up;
        let view = axes.world(view);
        let found = match self.segment {
            None => up.standing(view),
            Some((segment, length)) => {
                let arc = ArcLength::new(&self.rail.chain.curves[segment]).ok()?;
                up.at(
                    self,
                    (segment, length),
                    (arc.parameter_at(phi * length), phi),
                    view,
                )
            }
        };
        found.map(|up| axes.upright(up))
    }
}

#[derive(Debug, Clone, PartialEq)]
pub(super) enum UpAlong {
    Point(DVec3),
    Path(Arc<UpPath>),
    Minimal(Arc<TransportedFrame>),
    Frenet(Arc<Normals>),
    /// The up of the key in which the section begins, where the camera stays.
    Key(DVec3),
}

/// A minimal up along one section.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct TransportedFrame {
    /// Directions and ups at equal steps of the curve's parameter, both of the world.
    pub nodes: Vec<(DVec3, DVec3)>,
    /// Extra turn at both ends, so that a closed path closes.
    pub turn: [f64; 2],
}

impl UpAlong {
    /// The turn about the view, from φ = 0 to 1, of a minimal up or of one at rest; none for others.
    pub(super) fn twist(&self, moves: bool) -> Option<f64> {
        match self {
            Self::Minimal(carried) => Some(carried.turn[1] - carried.turn[0]),
            Self::Key(_) if !moves => Some(0.0),
            _ => None,
        }
    }

    pub(super) fn standing(&self, view: DVec3) -> Option<DVec3> {
        match self {
            Self::Key(up) => perpendicular(*up, view),
            _ => None,
        }
    }

    /// At the parameter `t` of a segment, φ of its length, for a view there.
    pub(super) fn at(
        &self,
        follow: &Follow,
        (segment, length): (usize, f64),
        (t, phi): (f64, f64),
        view: DVec3,
    ) -> Option<DVec3> {
        let rail = &follow.rail;
        let place = || rail.chain.curves[segment].point(t);
        let up = match self {
            Self::Key(up) => *up,
            Self::Point(point) => *point - place(),
            Self::Path(path) => {
                path.place((rail.chain.starts[segment] + phi * length) / rail.chain.length())
                    - place()
            }
            Self::Frenet(normals) => normals.up(segment, (t, phi), view)?,
            Self::Minimal(carried) => {
                let steps = carried.nodes.len() - 1;
                let at = ((t * steps as f64) as usize).min(steps - 1);
                let (from, up) = carried.nodes[at];
                let begin = at as f64 / steps as f64;
                let middle = 0.5 * (begin + t);
                let there = match follow.look {
                    Look::Ahead(distance) if distance > 0.0 => {
                        let arc = ArcLength::new(&rail.chain.curves[segment]).ok()?;
                        follow.look_direction(
                            (segment, length),
                            middle,
                            arc.length_at(middle) / length,
                        )
                    }
                    _ => follow.look_direction((segment, length), middle, 0.0),
                };
                let up = step(up, from, view, chord(from, there.unwrap_or(view), view));
                let [a, b] = carried.turn;
                turned(up, view, a + (b - a) * phi)
            }
        };
        perpendicular(up, view)
    }
}

#[cfg(test)]
#[path = "ahead_tests.rs"]
mod tests;
