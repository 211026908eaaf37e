//! How the camera turns in each section (thesis ch. 4; `docs/theory/path.md`, orientation curve): freely
//! through quaternions, tracking a target, looking along the way or keeping a direction.
//!
//! Positions, targets and ways are the world's; directions, quaternions and velocities are in y-up
//! axes ([`super::Up::upright`]).

use std::sync::Arc;

use glam::{DQuat, DVec3};

use super::ahead::{Follow, Look, Rail, UpAlong};
use super::camera_path::{OrientationMode, Target, Tcb};
use super::hermite::{Cubic, end_direction};
use super::own::{Overrides, TurningPart};
use super::quaternion_spline::{
    bezier, bezier_control, end_velocity, key_velocities, mean_velocity, reflect,
};
use super::space::{Space, Up};
use super::turning::Turning;
use super::ups::{Alignment, End, look_between, rolled};
use crate::error::{Result, vec_with_room};
use crate::math::monotone_cubic;
use crate::math::orientation::{self, POLE};
use crate::math::quaternion::{angle, continue_sign};

/// 1 less the cosine of the angle on S³, about 1e-7, below which two keys are the same.
const SAME_KEY: f64 = 1e-14;

/// Share of the way to the antipode that a taken velocity may swing out.
const SWING: f64 = 0.45;

/// One key of the turning: an orientation, or several that are alike.
#[derive(Debug, Clone)]
pub(super) struct Key {
    pub position: DVec3,
    pub target: Target,
    pub view: DVec3,
    /// Radians.
    pub roll: f64,
    /// Up before the roll, where it is not the up axis.
    pub reference: Option<DVec3>,
    pub turning: Tcb,
    /// With the sign that continues the key before it.
    pub q: DQuat,
    pub own: Overrides,
}

impl Key {
    /// Its own angular velocities, reaching and leaving; on S³ a rotation counts half.
    fn velocities(&self, up: Up) -> Option<(DVec3, DVec3)> {
        let half = |degrees: DVec3| up.upright(degrees) * (0.5 * 1f64.to_radians());
        let own = self.own.velocities?;
        Some((half(own.reach), half(own.leave)))
    }

    /// The axis against which its roll is measured, if it has no other up.
    pub(super) fn level(&self, upright: Up) -> Up {
        self.own.up.level(upright).unwrap_or(upright)
    }

    pub(super) fn up(&self) -> DVec3 {
        rolled(self.view, self.reference, self.roll)
    }

    fn end(&self) -> End<'_> {
        End {
            target: self.target,
            view: self.view,
            roll: self.roll,
            own: &self.own,
        }
    }
}

/// One section that has frames: the way from one key to the next.
#[derive(Debug, Clone, Copy)]
pub(super) struct Span<'a> {
    /// Curve time that it takes.
    pub duration: f64,
    /// Its curve and the length of it, if the camera moves.
    pub way: Option<(&'a Cubic, f64)>,
    pub segment: usize,
    pub section: usize,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Kind {
    Free,
    Tracked(DVec3),
    Follow(Look),
    Kept,
}

impl Kind {
    /// Whether its roll is a curve.
    fn has_roll_curve(self) -> bool {
        matches!(self, Self::Tracked(_) | Self::Follow(_))
    }
}

/// Neighbours of keys and spans. There is one span fewer than keys, or as many on a closed path.
#[derive(Clone, Copy)]
struct Ring {
    keys: usize,
    spans: usize,
}

impl Ring {
    fn closed(self) -> bool {
        self.keys == self.spans
    }
    fn before_key(self, key: usize) -> Option<usize> {
        if key > 0 {
            Some(key - 1)
        } else {
            self.closed().then(|| self.spans - 1)
        }
    }
    fn after_key(self, key: usize) -> Option<usize> {
        (key < self.spans).then_some(key)
    }
    fn end_of(self, span: usize) -> usize {
        (span + 1) % self.keys
    }
}

struct Work<'a> {
    ring: Ring,
    keys: &'a [Key],
    spans: &'a [Span<'a>],
    kinds: Vec<Kind>,
    /// Mean angular velocity of each span, and its angle on S³.
    means: Vec<(DVec3, f64)>,
    /// −1 where the last key of a closed path reaches the first with its sign changed.
    wrap: f64,
    /// Roll of each tracked span: powers of φ.
    rolls: Vec<[f64; 4]>,
    guides: Guides<'a>,
    space: Space,
}

/// What of a whole path some sections follow.
#[derive(Clone, Copy, Default)]
pub(super) struct Guides<'a> {
    /// The whole curve, where a key looks along it or has another up than the axis.
    pub rail: Option<&'a Arc<Rail>>,
    /// Where a key has another up than the axis.
    pub alignment: Option<&'a Alignment>,
}

/// Works out how the camera turns in each span, for `take`, and fixes the signs of the keys.
pub(super) fn turnings(
    keys: &mut [Key],
    spans: &[Span<'_>],
    mode: OrientationMode,
    guides: Guides<'_>,
    space: Space,
    mut take: impl FnMut(usize, Turning),
) -> Result<()> {
    let work = work(keys, spans, guides, space)?;
    for span in 0..spans.len() {
        take(span, work.turning(span, mode));
    }
    Ok(())
}

/// Velocities with which the turning passes a key, and its slope of roll beside a level section.
#[derive(Debug, Clone, Copy)]
pub(super) struct Rates {
    pub reach: DVec3,
    pub leave: DVec3,
    pub roll_slope: Option<f64>,
    /// Whether the velocities have an effect: an adjacent section is free.
    pub acts: bool,
}

/// The rates of every key in the mode tcb.
pub(super) fn rates(
    keys: &mut [Key],
    spans: &[Span<'_>],
    guides: Guides<'_>,
    space: Space,
) -> Result<Vec<Rates>> {
    let work = work(keys, spans, guides, space)?;
    let mut rates = vec_with_room(work.keys.len())?;
    for key in 0..work.keys.len() {
        let (reach, leave) = work.velocities(key);
        rates.push(Rates {
            reach,
            leave,
            roll_slope: work.roll_slope(key),
            acts: [work.ring.before_key(key), work.ring.after_key(key)]
                .into_iter()
                .flatten()
                .any(|span| work.kinds[span] == Kind::Free),
        });
    }
    Ok(rates)
}

/// Everything but the turnings themselves.
fn work<'a>(
    keys: &'a mut [Key],
    spans: &'a [Span<'a>],
    guides: Guides<'a>,
    space: Space,
) -> Result<Work<'a>> {
    for i in 1..keys.len() {
        let before = keys[i - 1].q;
        keys[i].q = continue_sign(before, keys[i].q).0;
    }
    let keys = &*keys;
    let ring = Ring {
        keys: keys.len(),
        spans: spans.len(),
    };
    let mut wrap = 1.0;
    if ring.closed() && !keys.is_empty() {
        let first = keys[0].q;
        let reached = continue_sign(keys[keys.len() - 1].q, first).0;
        wrap = if reached == first { 1.0 } else { -1.0 };
    }
    let mut work = Work {
        ring,
        keys,
        spans,
        kinds: vec_with_room(spans.len())?,
        means: vec_with_room(spans.len())?,
        wrap,
        rolls: vec_with_room(spans.len())?,
        guides,
        space,
    };
    for span in 0..spans.len() {
        let (from, to) = (&keys[span], &keys[ring.end_of(span)]);
        let (a, b) = work.ends(span);
        let kind = work.kind(span, from, to);
        work.kinds.push(kind);
        work.means
            .push((mean_velocity(a, b, spans[span].duration), angle(a, b)));
        work.rolls.push([0.0; 4]);
    }
    work.run_rolls()?;
    Ok(work)
}

impl Work<'_> {
    fn kind(&self, span: usize, from: &Key, to: &Key) -> Kind {
        match look_between(&from.end(), &to.end(), self.space.up) {
            None => Kind::Free,
            Some(look) if !from.own.up.is_level() => match self.up_along(span) {
                Some(_) => Kind::Follow(look),
                None => Kind::Free,
            },
            Some(Look::Target(target)) => Kind::Tracked(target),
            Some(Look::Still) => Kind::Kept,
            Some(look) => Kind::Follow(look),
        }
    }

    /// The axis against which the roll of a span is measured that has no other up.
    fn level(&self, span: usize) -> Up {
        self.keys[span].level(self.space.up)
    }

    fn up_along(&self, span: usize) -> Option<UpAlong> {
        let (begin, up) = (&self.spans[span], &self.keys[span].own.up);
        let moves = begin.way.is_some();
        self.guides
            .alignment?
            .along(begin.section, up, moves, self.space)
    }

    /// Quaternions at both ends of a span, with signs that belong together.
    fn ends(&self, span: usize) -> (DQuat, DQuat) {
        let end = self.ring.end_of(span);
        let sign = if end <= span { self.wrap } else { 1.0 };
        (self.keys[span].q, self.keys[end].q * sign)
    }

    fn turning(&self, span: usize, mode: OrientationMode) -> Turning {
        let (a, b) = self.ends(span);
        match (self.kinds[span], mode) {
            (Kind::Kept, _) => Turning::Kept(self.keys[span].view, self.keys[span].up()),
            (Kind::Tracked(target), _) => Turning::Tracked(target, self.rolls[span]),
            (Kind::Follow(_), _) => match self.along(span) {
                Some(follow) => Turning::Follow(Box::new(follow)),
                // There is always a rail where a section follows.
                None => Turning::Kept(self.keys[span].view, self.keys[span].up()),
            },
            (Kind::Free, OrientationMode::Slerp) => Turning::Arc([a, b]),
            (Kind::Free, OrientationMode::BarryGoldman) => self.barry_goldman(span),
            (Kind::Free, OrientationMode::Tcb) => {
                if let Some(part) = self.part(span, a, b) {
                    return part;
                }
                let (_, leave) = self.velocities(span);
                let (reach, _) = self.velocities(self.ring.end_of(span));
                Turning::Bezier(bezier_control(
                    a,
                    b,
                    leave,
                    reach,
                    self.spans[span].duration,
                ))
            }
        }
    }

    /// The rule that a span follows, if it does.
    fn along(&self, span: usize) -> Option<Follow> {
        let Kind::Follow(look) = self.kinds[span] else {
            return None;
        };
        Some(Follow {
            rail: self.guides.rail?.clone(),
            segment: self.spans[span]
                .way
                .map(|(_, length)| (self.spans[span].segment, length)),
            look,
            still: self.keys[span].view,
            up: self.up_along(span),
            level: self.level(span),
            roll: self.rolls[span],
        })
    }

    /// The part of a divided curve that a free span is, if it still leads from key to key.
    fn part(&self, span: usize, a: DQuat, b: DQuat) -> Option<Turning> {
        let TurningPart { control, from, to } = self.keys[span].own.turning?;
        let meets = |share, key: DQuat| bezier(&control, share).dot(key).abs() > 1.0 - SAME_KEY;
        (meets(from, a) && meets(to, b)).then_some(Turning::Part(control, [from, to]))
    }

    /// The four keys and knots around a span, time counted in the span's own φ.
    fn barry_goldman(&self, span: usize) -> Turning {
        let (a, b) = self.ends(span);
        let scale = 1.0 / self.spans[span].duration;
        let end = self.ring.end_of(span);
        let (before, t0) = match self.ring.before_key(span) {
            Some(other) => {
                // Brought to the sign that continues to `a`.
                let (q, reached) = self.ends(other);
                let sign = if reached == a { 1.0 } else { -1.0 };
                (q * sign, -self.spans[other].duration * scale)
            }
            None => (reflect(b, a), -1.0),
        };
        let (after, t3) = match self.ring.after_key(end) {
            Some(other) => {
                let (left, q) = self.ends(other);
                let sign = if left == b { 1.0 } else { -1.0 };
                (q * sign, 1.0 + self.spans[other].duration * scale)
            }
            None => (reflect(a, b), 2.0),
        };
        Turning::BarryGoldman([before, a, b, after], [t0, 0.0, 1.0, t3])
    }

    fn own_velocities(&self, key: usize) -> Option<(DVec3, DVec3)> {
        self.keys[key].velocities(self.space.up)
    }

    /// Velocities with which the curve reaches and leaves a key, limited so that none swings out.
    fn velocities(&self, key: usize) -> (DVec3, DVec3) {
        let before = self.ring.before_key(key);
        let after = self.ring.after_key(key);
        if let Some((reach, leave)) = self.own_velocities(key) {
            let limited = |omega: DVec3, span: Option<usize>| {
                span.map_or(omega, |span| {
                    omega * self.factor(omega, span, self.swing(span))
                })
            };
            return (limited(reach, before), limited(leave, after));
        }
        let taken = [
            before.and_then(|span| self.taken(span, true)),
            after.and_then(|span| self.taken(span, false)),
        ];
        if let Some(omega) = taken.into_iter().flatten().next() {
            let limited = |span: Option<usize>| {
                span.map_or(omega, |span| {
                    omega * self.factor(omega, span, self.swing(span))
                })
            };
            return (limited(before), limited(after));
        }
        let (reach, leave) = self.free_velocities(key, self.keys[key].turning);
        let mut scale = 1.0f64;
        for (omega, span) in [(reach, before), (leave, after)] {
            if let Some(span) = span {
                let (_, theta) = self.means[span];
                let bound = theta.min(SWING * (std::f64::consts::PI - theta));
                scale = scale.min(self.factor(omega, span, bound));
            }
        }
        (reach * scale, leave * scale)
    }

    /// The angle by which a third of the span may swing out.
    fn swing(&self, span: usize) -> f64 {
        let (_, theta) = self.means[span];
        SWING * (std::f64::consts::PI - theta)
    }

    /// Slope of the roll at a key beside a tracked span.
    fn roll_slope(&self, key: usize) -> Option<f64> {
        let tracked = |span: &usize| self.kinds[*span].has_roll_curve();
        if let Some(span) = self.ring.after_key(key).filter(tracked) {
            return Some(self.rolls[span][1] / self.spans[span].duration);
        }
        let span = self.ring.before_key(key).filter(tracked)?;
        let roll = &self.rolls[span];
        Some((roll[1] + 2.0 * roll[2] + 3.0 * roll[3]) / self.spans[span].duration)
    }

    /// Factor for ω, so that a third of the span turns by at most `bound`.
    fn factor(&self, omega: DVec3, span: usize, bound: f64) -> f64 {
        let third = omega.length() * self.spans[span].duration / 3.0;
        if third > bound { bound / third } else { 1.0 }
    }

    /// Kochanek and Bartels at a key all of whose spans are free.
    fn free_velocities(&self, key: usize, tcb: Tcb) -> (DVec3, DVec3) {
        let step = |span: usize| self.spans[span].duration;
        let mean = |span: usize| self.means[span].0;
        match (self.ring.before_key(key), self.ring.after_key(key)) {
            (Some(a), Some(b)) => key_velocities(tcb, mean(a), mean(b), step(a), step(b)),
            (None, Some(span)) => {
                let inner = self.ring.end_of(span);
                let omega = match self.ring.after_key(inner) {
                    None => mean(span),
                    Some(next) => {
                        let own = self.own_velocities(inner).map(|(reach, _)| reach);
                        let there = own.or_else(|| self.taken(next, false));
                        let there =
                            there.unwrap_or_else(|| self.free_velocities(inner, Tcb::default()).0);
                        end_velocity(tcb.tension, mean(span), there)
                    }
                };
                (omega, omega)
            }
            (Some(span), None) => {
                let omega = match self.ring.before_key(span) {
                    None => mean(span),
                    Some(last) => {
                        let own = self.own_velocities(span).map(|(_, leave)| leave);
                        let there = own.or_else(|| self.taken(last, true));
                        let there =
                            there.unwrap_or_else(|| self.free_velocities(span, Tcb::default()).1);
                        end_velocity(tcb.tension, mean(span), there)
                    }
                };
                (omega, omega)
            }
            (None, None) => (DVec3::ZERO, DVec3::ZERO),
        }
    }

    /// The velocity that a span which is not free has at its end or start.
    fn taken(&self, span: usize, at_end: bool) -> Option<DVec3> {
        match self.kinds[span] {
            Kind::Free => None,
            Kind::Kept => Some(DVec3::ZERO),
            Kind::Follow(_) => {
                let turned = self.along(span)?.velocity(at_end);
                Some(turned / self.spans[span].duration)
            }
            Kind::Tracked(target) => {
                let key = &self.keys[if at_end { self.ring.end_of(span) } else { span }];
                let roll = &self.rolls[span];
                let duration = self.spans[span].duration;
                let slope = if at_end {
                    roll[1] + 2.0 * roll[2] + 3.0 * roll[3]
                } else {
                    roll[1]
                };
                let velocity = self.spans[span].way.map_or(DVec3::ZERO, |(curve, length)| {
                    end_direction(curve, at_end).unwrap_or(DVec3::ZERO) * (length / duration)
                });
                let level = self.level(span);
                let [offset, velocity] =
                    [target - key.position, velocity].map(|v| level.upright(v));
                let turning = 0.5 * tracking_velocity(offset, velocity, slope / duration);
                Some(self.space.up.upright(level.world(turning)))
            }
        }
    }

    /// Rolls of the tracked spans: one monotone cubic through each run of them.
    fn run_rolls(&mut self) -> Result<()> {
        let spans = self.spans.len();
        let tracked = |kinds: &[Kind], span: usize| kinds[span % spans].has_roll_curve();
        let all = (0..spans).all(|span| tracked(&self.kinds, span));
        let around = self.ring.closed() && !all;
        // On a ring the counting begins at a span that is not tracked.
        let first = if around {
            (0..spans)
                .find(|&span| !tracked(&self.kinds, span))
                .unwrap_or(0)
        } else {
            0
        };
        let mut steps: Vec<f64> = vec_with_room(spans)?;
        let mut rises: Vec<f64> = vec_with_room(spans)?;
        let mut slopes: Vec<f64> = vec_with_room(spans + 1)?;
        let mut start = first;
        for span in first..=first + spans {
            if span < first + spans && tracked(&self.kinds, span) {
                let from = &self.keys[span % spans.max(1)];
                let to = &self.keys[self.ring.end_of(span % spans)];
                let turn = orientation::wrap_degrees((to.roll - from.roll).to_degrees());
                steps.push(self.spans[span % spans].duration);
                rises.push(turn.to_radians());
                continue;
            }
            if !steps.is_empty() {
                slopes.clear();
                slopes.resize(steps.len() + 1, 0.0);
                monotone_cubic::slopes(&steps, &rises, all && self.ring.closed(), &mut slopes);
                for (k, slope) in slopes.iter_mut().enumerate() {
                    let key = (start + k) % self.ring.keys;
                    *slope = self.keys[key]
                        .own
                        .roll_slope
                        .map_or(*slope, f64::to_radians);
                }
                for (k, step) in steps.iter().enumerate() {
                    let at = (start + k) % spans;
                    let roll = self.keys[at].roll;
                    self.rolls[at] =
                        monotone_cubic::cubic(roll, rises[k], *step, slopes[k], slopes[k + 1]);
                }
                steps.clear();
                rises.clear();
            }
            start = span + 1;
        }
        Ok(())
    }
}

/// Angular velocity of a camera that looks at a target at `offset` while it moves and rolls.
fn tracking_velocity(offset: DVec3, velocity: DVec3, rolling: f64) -> DVec3 {
    let view = orientation::unit(offset);
    let turn = -(velocity - view * view.dot(velocity)) / offset.length();
    let h2 = view.x * view.x + view.z * view.z;
    // The level frame turns about the view direction as the yaw goes on.
    let yawing = if h2.sqrt() < POLE {
        0.0
    } else {
        (turn.x * view.z - turn.z * view.x) / h2
    };
    view.cross(turn) + view * (yawing * view.y + rolling)
}
