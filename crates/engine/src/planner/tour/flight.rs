//! A smooth path along a round: by chord lengths a spline with continuous curvature, which few
//! points more bring near to the straight ways where it comes too near to the object.

use std::f64::consts::{PI, TAU};

use glam::DVec3;

use crate::error::{Invalid, Result, vec_with_room};
use crate::limits::MAX_ORIENTATIONS;
use crate::math::tridiagonal::{Row, solve, solve_periodic};
use crate::path::{CameraPath, CurveKind, Orientation, Space, SupportPoint, Tangents, Target, Up};
use crate::tools::clearance::Clearance;
use crate::tools::watch::Watch;

/// Places of a section that are tried.
const TRIED: usize = 32;

/// Rounds in which points are put in.
const ROUNDS: usize = 10;

/// The cosine of a turn between two legs that counts as going back.
const BACK: f64 = -0.9;

/// The widest turn of the heading from one view in an object to the next, in radians.
const TURN: f64 = 1.0;

/// A place of the way with what is looked at from there; on the way between two views, nothing yet.
#[derive(Clone, Debug)]
pub(super) struct Stop {
    pub place: DVec3,
    pub targets: Vec<DVec3>,
}

/// The way of a tour.
pub(super) struct Flight {
    pub stops: Vec<Stop>,
    pub closed: bool,
}

impl Flight {
    /// The number of sections.
    fn legs(&self) -> usize {
        self.stops.len() - usize::from(!self.closed)
    }

    fn ends(&self, leg: usize) -> [DVec3; 2] {
        [leg, (leg + 1) % self.stops.len()].map(|at| self.stops[at].place)
    }

    fn chord(&self, leg: usize) -> f64 {
        let [a, b] = self.ends(leg);
        a.distance(b)
    }

    /// The velocities with which each stop is reached and left, for a way of one each.
    fn velocities(&self) -> Result<Vec<[DVec3; 2]>> {
        let count = self.stops.len();
        let slope = |leg: usize| {
            let [a, b] = self.ends(leg);
            (b - a) / self.chord(leg)
        };
        let inner = |at: usize| {
            let before = (at + count - 1) % count;
            let (h, k) = (self.chord(before), self.chord(at));
            let right = 3.0 * (k * slope(before) + h * slope(at));
            Row::new([k, 2.0 * (h + k), h], right)
        };
        let mut rows = vec_with_room(count)?;
        let mut found = vec_with_room(count)?;
        if self.closed {
            rows.extend((0..count - 1).map(inner));
            let joint = solve_periodic(&mut rows, inner(count - 1));
            found.extend(rows.iter().map(|row| [row.right; 2]));
            found.push([joint; 2]);
        } else {
            rows.push(Row::new([0.0, 2.0, 1.0], 3.0 * slope(0)));
            rows.extend((1..count - 1).map(inner));
            rows.push(Row::new([1.0, 2.0, 0.0], 3.0 * slope(count - 2)));
            solve(&mut rows);
            found.extend(rows.iter().map(|row| [row.right; 2]));
        }
        // Where the way goes back the camera rests.
        for at in usize::from(!self.closed)..self.legs() {
            let before = slope((at + count - 1) % count);
            if before.dot(slope(at)) < BACK {
                found[at] = [before, slope(at)];
            }
        }
        Ok(found)
    }

    /// Puts in points until the curve keeps away from the object; less where its ends are nearer.
    pub(super) fn clear(
        &mut self,
        object: &Clearance,
        clear: f64,
        watch: &Watch<'_>,
    ) -> Result<()> {
        for _ in 0..ROUNDS {
            let velocities = self.velocities()?;
            let mut faulty = vec_with_room(self.legs())?;
            for leg in 0..self.legs() {
                watch.check()?;
                if !self.is_clear(object, leg, &velocities, clear) {
                    faulty.push(leg);
                }
            }
            if faulty.is_empty() {
                return Ok(());
            }
            for leg in faulty.into_iter().rev() {
                let [a, b] = self.ends(leg);
                self.stops.try_reserve(1)?;
                let between = Stop {
                    place: a.midpoint(b),
                    targets: Vec::new(),
                };
                self.stops.insert(leg + 1, between);
            }
        }
        Err(Invalid::TourWay.into())
    }

    fn is_clear(
        &self,
        object: &Clearance,
        leg: usize,
        velocities: &[[DVec3; 2]],
        clear: f64,
    ) -> bool {
        let [a, b] = self.ends(leg);
        let far = |place: DVec3| object.distance(place, clear).unwrap_or(clear);
        let least = clear.min(0.9 * far(a).min(far(b)));
        let h = self.chord(leg);
        let (v, w) = (
            h * velocities[leg][1],
            h * velocities[(leg + 1) % self.stops.len()][0],
        );
        let mut last = a;
        (1..=TRIED).all(|k| {
            let t = k as f64 / TRIED as f64;
            let (s, both) = (1.0 - t, t * (1.0 - t));
            let place =
                a * (s * s * (1.0 + 2.0 * t)) + b * (t * t * (3.0 - 2.0 * t)) + v * (both * s)
                    - w * (both * t);
            let free = object.distance(place, least).is_none() && !object.is_crossed(last, place);
            last = place;
            free
        })
    }

    /// The stops with views, and behind the last one, if closed, the first again.
    fn keys(&self) -> Result<Vec<usize>> {
        let mut keys = vec_with_room(self.stops.len() + 1)?;
        keys.extend((0..self.stops.len()).filter(|at| !self.stops[*at].targets.is_empty()));
        if let (Some(&first), true) = (keys.first(), self.closed) {
            keys.push(first + self.stops.len());
        }
        Ok(keys)
    }

    /// From what the view at one stop shows last to what it shows first at another.
    fn views(&self, from: usize, to: usize) -> [DVec3; 2] {
        let [from, to] = [from, to].map(|at| &self.stops[at % self.stops.len()]);
        let way =
            |stop: &Stop, target: Option<&DVec3>| target.map_or(DVec3::X, |at| *at - stop.place);
        [way(from, from.targets.last()), way(to, to.targets.first())]
    }

    /// Puts in stops and views where the heading would turn far: a view that turns the shortest
    /// way might go straight up or down.
    pub(super) fn turn(&mut self, up: Up) -> Result<()> {
        for stop in &mut self.stops {
            let mut at = 1;
            while at < stop.targets.len() && stop.targets.len() < MAX_ORIENTATIONS {
                let ways = [at - 1, at].map(|k| stop.targets[k] - stop.place);
                if heading(ways, up).abs() > TURN {
                    stop.targets.try_reserve(1)?;
                    stop.targets.insert(at, stop.place + between(ways, 0.5, up));
                } else {
                    at += 1;
                }
            }
        }
        let keys = self.keys()?;
        for pair in keys.windows(2).rev() {
            let turned = heading(self.views(pair[0], pair[1]), up).abs();
            let mut steps = (turned / TURN).ceil();
            // Parts of at most so great a turn each, in legs of about the same length.
            steps -= (pair[1] - pair[0]) as f64;
            let mut end = pair[1];
            while steps > 0.0 {
                let longest = |a: &usize, b: &usize| self.chord(*a).total_cmp(&self.chord(*b));
                let legs = (pair[0]..end).map(|leg| leg % self.stops.len());
                let Some(leg) = legs.max_by(longest) else {
                    break;
                };
                let [a, b] = self.ends(leg);
                self.stops.try_reserve(1)?;
                let between = Stop {
                    place: a.midpoint(b),
                    targets: Vec::new(),
                };
                self.stops.insert(leg + 1, between);
                end += 1;
                steps -= 1.0;
            }
        }
        Ok(())
    }

    /// Gives the stops without a view one between those around them: what is looked at moves or,
    /// inside, the view turns.
    pub(super) fn look(&mut self, up: Up, inside: bool) -> Result<()> {
        let count = self.stops.len();
        let keys = self.keys()?;
        for pair in keys.windows(2) {
            let (from, to) = (pair[0], pair[1]);
            let all: f64 = (from..to).map(|leg| self.chord(leg % count)).sum();
            let ways = self.views(from, to);
            let [first, last] = [from, to].map(|at| self.stops[at % count].place);
            let mut gone = 0.0;
            for at in from + 1..to {
                gone += self.chord((at - 1) % count);
                let share = gone / all;
                let stop = &mut self.stops[at % count];
                stop.targets.try_reserve(1)?;
                stop.targets.push(if inside {
                    stop.place + between(ways, share, up)
                } else {
                    (first + ways[0]).lerp(last + ways[1], share)
                });
            }
        }
        Ok(())
    }

    /// Places that the curve keeps between: those of its stops and its control points.
    pub(super) fn reach(&self) -> Result<Vec<DVec3>> {
        let velocities = self.velocities()?;
        let mut all = vec_with_room(3 * self.stops.len())?;
        for (at, stop) in self.stops.iter().enumerate() {
            all.push(stop.place);
            let before = (at + self.stops.len() - 1) % self.stops.len();
            for (leg, third, side) in [(before, -1.0 / 3.0, 0), (at, 1.0 / 3.0, 1)] {
                if leg < self.legs() {
                    all.push(stop.place + third * self.chord(leg) * velocities[at][side]);
                }
            }
        }
        Ok(all)
    }

    /// The path.
    pub(super) fn path(&self, space: Space) -> Result<CameraPath> {
        let count = self.stops.len();
        let velocities = self.velocities()?;
        let mut points = vec_with_room(count)?;
        for (at, stop) in self.stops.iter().enumerate() {
            let [before, after] = [(at + count - 1) % count, at].map(|leg| {
                if leg < self.legs() {
                    self.chord(leg)
                } else {
                    1.0
                }
            });
            points.push(SupportPoint {
                tangents: Some(Tangents {
                    before: before * velocities[at][0],
                    after: after * velocities[at][1],
                }),
                ..point(stop, space, 0)?
            });
        }
        made(points, space, self.closed, CurveKind::Tcb)
    }

    /// The places with views alone, a frame for each view.
    pub(super) fn stills(&self, space: Space) -> Result<CameraPath> {
        let mut points = vec_with_room(self.stops.len())?;
        for stop in self.stops.iter().filter(|stop| !stop.targets.is_empty()) {
            points.push(point(stop, space, 1)?);
        }
        made(points, space, false, CurveKind::Linear)
    }
}

/// By which angle the heading turns between two views.
fn heading(ways: [DVec3; 2], up: Up) -> f64 {
    let [a, b] = ways.map(|way| {
        let way = up.upright(way);
        way.x.atan2(way.z)
    });
    (b - a + PI).rem_euclid(TAU) - PI
}

/// The view at a share of the turn between two, by heading, height and length.
fn between(ways: [DVec3; 2], share: f64, up: Up) -> DVec3 {
    let [a, b] = ways.map(|way| up.upright(way));
    let rise = |way: DVec3| way.y.atan2(way.x.hypot(way.z));
    let mix = |a: f64, b: f64| a + share * (b - a);
    let (sin, cos) = (a.x.atan2(a.z) + share * heading(ways, up)).sin_cos();
    let (high, flat) = mix(rise(a), rise(b)).sin_cos();
    up.world(mix(a.length(), b.length()) * DVec3::new(flat * sin, high, flat * cos))
}

fn point(stop: &Stop, space: Space, frames: u32) -> Result<SupportPoint> {
    let mut orientations = vec_with_room(stop.targets.len())?;
    for target in &stop.targets {
        let mut orientation = Orientation {
            target: Target::Absolute(*target),
            ..Orientation::new_in(space)
        };
        if frames > 0 {
            orientation.own = orientation.own.with(|own| own.frames = frames)?;
        }
        orientations.push(orientation);
    }
    Ok(SupportPoint {
        orientations,
        ..SupportPoint::try_new(stop.place)?
    })
}

fn made(
    points: Vec<SupportPoint>,
    space: Space,
    closed: bool,
    curve: CurveKind,
) -> Result<CameraPath> {
    let path = CameraPath {
        points: points.into(),
        space,
        closed,
        curve,
        ..CameraPath::try_new()?
    };
    path.check()?;
    Ok(path)
}
