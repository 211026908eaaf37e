//! How the camera turns within one section, as [`super::orientation_curve`] works it out.
//!
//! Places are the world's; directions and quaternions are in y-up axes ([`super::Up::upright`]).

use glam::{DQuat, DVec3};

use super::ahead::{AT_TARGET, Follow};
use super::quaternion_spline::{barry_goldman_between, bezier};
use super::space::Space;
use crate::math::monotone_cubic::{self, value};
use crate::math::orientation::{self, POLE};
use crate::math::quaternion::{continue_sign, log, slerp};
use crate::math::rotation_minimising::{perpendicular, turned};

/// Step of the differences that give the velocity of a view along the way.
const STEP: f64 = 1.0 / 16384.0;

/// How the camera turns in one section; φ ∈ [0, 1] is the share of its curve time and of its way.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Turning {
    Bezier([DQuat; 4]),
    /// The part of such a curve between two shares of its time.
    Part([DQuat; 4], [f64; 2]),
    Arc([DQuat; 2]),
    /// The section lies between the inner knots, which are 0 and 1.
    BarryGoldman([DQuat; 4], [f64; 4]),
    /// The same view direction and up all the way.
    Kept(DVec3, DVec3),
    /// Looks at a point of the world; the roll in radians in powers of φ.
    Tracked(DVec3, [f64; 4]),
    /// Looks along the way, or has an up that is not the up axis.
    Follow(Box<Follow>),
}

impl Turning {
    /// The quaternion at φ of a turning that is one of quaternions.
    pub(super) fn quaternion(&self, phi: f64) -> Option<DQuat> {
        match self {
            Self::Bezier(control) => Some(bezier(control, phi)),
            Self::Part(control, [from, to]) => Some(bezier(control, from + (to - from) * phi)),
            Self::Arc([a, b]) => Some(slerp(*a, *b, phi)),
            Self::BarryGoldman(keys, knots) => Some(barry_goldman_between(keys, knots, phi)),
            Self::Kept(..) | Self::Tracked(..) | Self::Follow(_) => None,
        }
    }

    /// Whether [`Self::quaternion`] gives one, without computing it.
    pub(super) const fn is_quaternion(&self) -> bool {
        !matches!(self, Self::Kept(..) | Self::Tracked(..) | Self::Follow(_))
    }

    /// View direction and up at φ. `place` gives the position at any φ; only tracking asks.
    pub(super) fn view_at(
        &self,
        phi: f64,
        place: &dyn Fn(f64) -> DVec3,
        space: Space,
    ) -> (DVec3, DVec3) {
        match self {
            Self::Kept(view, up) => (*view, *up),
            Self::Tracked(target, roll) => track(*target, roll, phi, place, space),
            Self::Follow(follow) => follow.view_at(phi),
            _ => {
                let q = self.quaternion(phi).unwrap_or(DQuat::IDENTITY);
                orientation::view_from_quaternion(q)
            }
        }
    }
}

/// Looks at the target; nearer to it than [`AT_TARGET`] there is no direction.
fn track(
    target: DVec3,
    roll: &[f64; 4],
    phi: f64,
    place: &dyn Fn(f64) -> DVec3,
    space: Space,
) -> (DVec3, DVec3) {
    let near = AT_TARGET * space.half_size;
    let direction = |phi: f64| {
        let offset = target - place(phi);
        (offset.length() >= near).then(|| orientation::unit(space.up.upright(offset)))
    };
    level_view(&direction, roll, phi, DVec3::Z)
}

impl Follow {
    /// View direction and up at φ; where either is undefined, the last one holds.
    pub(super) fn view_at(&self, phi: f64) -> (DVec3, DVec3) {
        let direction = |phi: f64| self.direction(phi);
        let Some(up) = &self.up else {
            let axes = self.rail.space.up;
            let levelled = |v: DVec3| self.level.upright(axes.world(v));
            let direction = |phi: f64| direction(phi).map(levelled);
            let (view, up) = level_view(&direction, &self.roll, phi, levelled(self.still));
            let back = |v: DVec3| axes.upright(self.level.world(v));
            return (back(view), back(up));
        };
        let view = held(&direction, phi).unwrap_or(self.still);
        let there = |phi: f64| self.reference(up, phi, direction(phi)?);
        let reference = self
            .reference(up, phi, view)
            .or_else(|| perpendicular(held(&there, phi)?, view))
            .unwrap_or_else(|| orientation::level_axes(view).1);
        (view, turned(reference, view, value(&self.roll, phi)))
    }

    /// Angular velocity on S³ at an end for one whole section.
    pub(super) fn velocity(&self, at_end: bool) -> DVec3 {
        let (from, h) = if at_end { (1.0, -STEP) } else { (0.0, STEP) };
        let axes = self.rail.space.up;
        // Of a parabola through three places, from the first of them.
        let slope = |one: DVec3, two: DVec3| (4.0 * one - two) / (2.0 * h);
        let moves = self.segment.is_some();
        if let Some(twist) = self.up.as_ref().and_then(|up| up.twist(moves)) {
            // No turn about the view but this one: the views alone tell the rest.
            let direction = |phi: f64| self.direction(phi);
            let view = |k: f64| held(&direction, from + k * h).unwrap_or(self.still);
            let first = view(0.0);
            let turn = first.cross(slope(view(1.0) - first, view(2.0) - first));
            return 0.5 * (turn + first * (twist + monotone_cubic::slope(&self.roll, from)));
        }
        // In the world's axes, so that its rounding does not depend on what is upright.
        let q = |k: f64| {
            let (view, up) = self.view_at(from + k * h);
            orientation::quaternion_from_view(axes.world(view), axes.world(up))
        };
        let first = q(0.0);
        let turned = |k| log(continue_sign(first, q(k)).0 * first.conjugate());
        axes.upright(slope(turned(1.0), turned(2.0)))
    }
}

/// A view in some direction at φ, rolled against the level; without direction or yaw the last.
fn level_view(
    direction: &dyn Fn(f64) -> Option<DVec3>,
    roll: &[f64; 4],
    phi: f64,
    still: DVec3,
) -> (DVec3, DVec3) {
    let level = |view: DVec3| view.x.hypot(view.z) >= POLE;
    let view = held(direction, phi).unwrap_or(still);
    let (u, v) = if level(view) {
        orientation::level_axes(view)
    } else {
        let yawed = |phi: f64| direction(phi).filter(|&view| level(view));
        let yaw = nearest_where(phi, &|phi| yawed(phi).is_some())
            .and_then(yawed)
            .map_or(0.0, |view| view.x.atan2(view.z));
        orientation::axes_with_yaw(view, yaw.sin(), yaw.cos())
    };
    let (sin, cos) = value(roll, phi).sin_cos();
    (view, v * cos - u * sin)
}

/// What there is at φ, else the last there was, else the next.
fn held(find: &dyn Fn(f64) -> Option<DVec3>, phi: f64) -> Option<DVec3> {
    find(phi).or_else(|| nearest_where(phi, &|phi| find(phi).is_some()).and_then(find))
}

/// The φ nearest before this one, else after it, where `good` holds: doubling, then bisection.
fn nearest_where(phi: f64, good: &dyn Fn(f64) -> bool) -> Option<f64> {
    for direction in [-1.0, 1.0] {
        let mut step = 1e-15;
        let mut bad = phi;
        loop {
            let next = (phi + direction * step).clamp(0.0, 1.0);
            if good(next) {
                let mut found = next;
                for _ in 0..60 {
                    let middle = 0.5 * (found + bad);
                    if good(middle) {
                        found = middle
                    } else {
                        bad = middle
                    }
                }
                return Some(found);
            }
            if next == 0.0 || next == 1.0 {
                break;
            }
            bad = next;
            step *= 2.0;
        }
    }
    None
}
