//! A smooth path along a round: by chord lengths a spline with continuous curvature, which few
//! points more bring near to the straight ways where it comes too near to the object.

use glam::DVec3;

use crate::error::{Error, Invalid, Result, vec_with_room};
use crate::math::tridiagonal::{Row, solve, solve_periodic};
use crate::path::{
    CameraPath, CurveKind, Orientation, Space, SupportPoint, Tangents, Target,
};
use crate::tools::clearance::Clearance;

/// Places of a section that are tried.
const TRIED: usize = 32;

/// Rounds in which points are put in.
const ROUNDS: usize = 10;

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

    /// The velocity at each stop, for a way of one each.
    fn velocities(&self) -> Result<Vec<DVec3>> {
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
            found.extend(rows.iter().map(|row| row.right));
            found.push(joint);
        } else {
            rows.push(Row::new([0.0, 2.0, 1.0], 3.0 * slope(0)));
            rows.extend((1..count - 1).map(inner));
            rows.push(Row::new([1.0, 2.0, 0.0], 3.0 * slope(count - 2)));
            solve(&mut rows);
            found.extend(rows.iter().map(|row| row.right));
        }
        Ok(found)
    }

    /// Puts in points until the curve keeps away from the object; less where its ends are nearer.
    pub fn clear(&mut self, object: &Clearance, clear: f64) -> Result<()> {
        for _ in 0..ROUNDS {
            let velocities = self.velocities()?;
            let mut faulty = vec_with_room(self.legs())?;
            for leg in 0..self.legs() {
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

    fn is_clear(&self, object: &Clearance, leg: usize, velocities: &[DVec3], clear: f64) -> bool {
        let [a, b] = self.ends(leg);
        let far = |place: DVec3| object.distance(place, clear).unwrap_or(clear);
        let least = clear.min(0.9 * far(a).min(far(b)));
        let h = self.chord(leg);
        let [v, w] = [leg, (leg + 1) % self.stops.len()].map(|at| h * velocities[at]);
        let mut last = a;
        (1..=TRIED).all(|k| {
            let t = k as f64 / TRIED as f64;
            let (s, both) = (1.0 - t, t * (1.0 - t));
            let place = a * (s * s * (1.0 + 2.0 * t)) + b * (t * t * (3.0 - 2.0 * t))
                + v * (both * s)
                - w * (both * t);
            let free = object.distance(place, least).is_none() && !object.is_crossed(last, place);
            last = place;
            free
        })
    }

    /// Gives the stops without a view one between those around them. `turns`: the view turns, else
    /// what is looked at moves.
    pub fn look(&mut self, turns: bool) -> Result<()> {
        let count = self.stops.len();
        let keys: Vec<usize> = {
            let mut keys = vec_with_room(count)?;
            keys.extend((0..count).filter(|at| !self.stops[*at].targets.is_empty()));
            keys
        };
        for (k, &from) in keys.iter().enumerate() {
            let to = match keys.get(k + 1) {
                Some(next) => *next,
                None if self.closed => keys[0] + count,
                None => break,
            };
            let all: f64 = (from..to).map(|leg| self.chord(leg % count)).sum();
            let mut gone = 0.0;
            let view = |at: usize, target: Option<&DVec3>| {
                let place = self.stops[at % count].place;
                target.map_or(DVec3::ZERO, |target| *target - place)
            };
            let first = view(from, self.stops[from].targets.last());
            let last = view(to, self.stops[to % count].targets.first());
            let mut seen = vec_with_room(to - from)?;
            for at in from + 1..to {
                gone += self.chord((at - 1) % count);
                let share = gone / all;
                let place = self.stops[at % count].place;
                seen.push(if turns {
                    let way = first.normalize_or_zero().lerp(last.normalize_or_zero(), share);
                    let far = first.length() * (1.0 - share) + last.length() * share;
                    place + far * way.try_normalize().unwrap_or(first.normalize_or_zero())
                } else {
                    let target = self.stops[from].place + first;
                    target.lerp(self.stops[to % count].place + last, share)
                });
            }
            for (at, target) in (from + 1..to).zip(seen) {
                let stop = &mut self.stops[at % count];
                stop.targets.try_reserve(1)?;
                stop.targets.push(target);
            }
        }
        Ok(())
    }

    /// Places that the curve keeps between: those of its stops and its control points.
    pub fn reach(&self) -> Result<Vec<DVec3>> {
        let velocities = self.velocities()?;
        let mut all = vec_with_room(3 * self.stops.len())?;
        for (at, stop) in self.stops.iter().enumerate() {
            all.push(stop.place);
            let before = (at + self.stops.len() - 1) % self.stops.len();
            for (leg, third) in [(before, -1.0 / 3.0), (at, 1.0 / 3.0)] {
                if leg < self.legs() {
                    all.push(stop.place + third * self.chord(leg) * velocities[at]);
                }
            }
        }
        Ok(all)
    }

    /// The path.
    pub fn path(&self, space: Space) -> Result<CameraPath> {
        let count = self.stops.len();
        let velocities = self.velocities()?;
        let mut points = vec_with_room(count)?;
        for (at, stop) in self.stops.iter().enumerate() {
            let [before, after] = [(at + count - 1) % count, at]
                .map(|leg| if leg < self.legs() { self.chord(leg) } else { 1.0 });
            points.push(SupportPoint {
                tangents: Some(Tangents {
                    before: before * velocities[at],
                    after: after * velocities[at],
                }),
                ..point(stop, space, 0)?
            });
        }
        made(points, space, self.closed, CurveKind::Tcb)
    }

    /// The places with views alone, a frame for each view.
    pub fn stills(&self, space: Space) -> Result<CameraPath> {
        let mut points = vec_with_room(self.stops.len())?;
        for stop in self.stops.iter().filter(|stop| !stop.targets.is_empty()) {
            points.push(point(stop, space, 1)?);
        }
        made(points, space, false, CurveKind::Linear)
    }
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
        points,
        space,
        closed,
        curve,
        ..CameraPath::try_new()?
    };
    path.check().map_err(Error::from)?;
    Ok(path)
}
