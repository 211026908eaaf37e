//! One piece of a fitted path: as long as its errors at the poses themselves allow.

use glam::{DQuat, DVec3};

use super::{Data, Joint, Piece, ROUNDS, view_angle};
use crate::error::{Result, vec_with_room};
use crate::limits::{MAX_DISTANCE_KEYS, MAX_LIST_ZOOM, MAX_ZOOM, MIN_ZOOM};
use crate::math::quaternion::{angle, exp, log};
use crate::path::arc_length::ArcLength;
use crate::path::hermite::Cubic;
use crate::path::quaternion_spline::bezier;
use crate::path::timing::Timing;
use crate::path::{Orientation, Pace, own};

impl Data {
    /// The longest piece from a pose on; none if no whole frame is left.
    pub(super) fn longest(
        &self,
        first: usize,
        joint: Joint,
        guess: usize,
    ) -> Result<Option<Piece>> {
        let last = self.raw.len() - 1;
        let Some(least) = (first + 1..=last).find(|&k| self.frames(first, k) > 0) else {
            return Ok(None);
        };
        let mut good = self.piece(first, least, joint, true)?;
        let (mut step, mut bad) = (guess.max(2), last + 1);
        loop {
            let from = good.as_ref().map_or(least, |piece| piece.last);
            let next = (first + step).clamp(from, last);
            if next == from {
                break;
            }
            if let Some(piece) = self.piece(first, next, joint, false)? {
                good = Some(piece);
                step *= 2;
            } else {
                bad = next;
                break;
            }
        }
        loop {
            let from = good.as_ref().map_or(least, |piece| piece.last);
            let middle = usize::midpoint(from, bad);
            if middle <= from {
                return Ok(good);
            }
            match self.piece(first, middle, joint, false)? {
                Some(piece) => good = Some(piece),
                None => bad = middle,
            }
        }
    }

    /// A piece from one pose to another, within the tolerance unless there `must` be one.
    fn piece(&self, first: usize, last: usize, joint: Joint, must: bool) -> Result<Option<Piece>> {
        let frames = self.frames(first, last);
        if frames == 0 {
            return Ok(None);
        }
        let from = self.smooth[first].position;
        let near = |k: usize| (self.raw[k].position - from).length() <= self.tolerance;
        if let Some(piece) = self.moving(first, last, frames, joint)? {
            return Ok(Some(piece));
        }
        if (first..=last).all(near)
            && let Some(piece) = self.resting(first, last, frames, joint)?
        {
            return Ok(Some(piece));
        }
        Ok(must.then_some(Piece {
            first,
            last,
            frames,
            curve: Some(self.straight(first, last)),
            pace: own::distance(&[[0.0, 0.0], [1.0, 1.0]])?,
            velocities: [log(self.turned(first, last)); 2],
            zoom_slopes: [self.smooth[last].zoom - self.smooth[first].zoom; 2],
            holds: false,
        }))
    }

    fn straight(&self, first: usize, last: usize) -> Cubic {
        let [a, b] = [first, last].map(|k| self.smooth[k].position);
        Cubic::hermite(a, b, b - a, b - a)
    }

    fn turned(&self, first: usize, last: usize) -> DQuat {
        self.smooth[last].turn * self.smooth[first].turn.conjugate()
    }

    /// Poses at even distances, both ends among them: as many as a pace has keys.
    fn chosen(&self, first: usize, last: usize) -> Result<Vec<usize>> {
        let count = (last - first + 1).min(MAX_DISTANCE_KEYS);
        let mut chosen = vec_with_room(count)?;
        chosen.extend(
            (0..count).map(|k| first + (k * (last - first) + (count - 1) / 2) / (count - 1)),
        );
        Ok(chosen)
    }

    fn moving(
        &self,
        first: usize,
        last: usize,
        frames: u32,
        joint: Joint,
    ) -> Result<Option<Piece>> {
        let chosen = self.chosen(first, last)?;
        let Some((curve, places)) = self.cubic(&chosen, joint.direction)? else {
            return Ok(None);
        };
        let arc = ArcLength::new(&curve)?;
        if !(arc.length() > 1e-6 * self.tolerance) {
            return Ok(None);
        }
        let mut ways = vec_with_room(places.len())?;
        ways.extend(places.iter().map(|t| arc.length_at(*t) / arc.length()));
        let place = |way: f64| curve.point(arc.parameter_at(way * arc.length()));
        let piece = Piece {
            first,
            last,
            frames,
            curve: Some(curve),
            pace: Pace::Speeds,
            velocities: [DVec3::ZERO; 2],
            zoom_slopes: [0.0; 2],
            holds: false,
        };
        let slack = 0.1 * self.tolerance / arc.length();
        self.finished(piece, &chosen, &ways, slack, joint, &place)
    }

    /// On the spot: the way is the turning, else the zoom.
    fn resting(
        &self,
        first: usize,
        last: usize,
        frames: u32,
        joint: Joint,
    ) -> Result<Option<Piece>> {
        let chosen = self.chosen(first, last)?;
        let mut ways: Vec<f64> = vec_with_room(chosen.len())?;
        let mut gone = 0.0;
        ways.push(gone);
        for pair in chosen.windows(2) {
            let (a, b) = (self.smooth[pair[0]], self.smooth[pair[1]]);
            gone += angle(a.turn, b.turn) + (view_angle(a.zoom) - view_angle(b.zoom)).abs();
            ways.push(gone);
        }
        let still = self.smooth[first];
        let holds = (first..=last).all(|k| self.off(k, still.turn, still.zoom) <= self.angle);
        for way in &mut ways {
            *way /= gone.max(f64::MIN_POSITIVE);
        }
        let piece = Piece {
            first,
            last,
            frames,
            curve: None,
            pace: own::distance(&[[0.0, 0.0], [1.0, 1.0]])?,
            velocities: [DVec3::ZERO; 2],
            zoom_slopes: [0.0; 2],
            holds,
        };
        if holds {
            return Ok(Some(piece));
        }
        let position = still.position;
        self.finished(piece, &chosen, &ways, 0.02, joint, &|_| position)
    }

    pub(super) fn off(&self, at: usize, turn: DQuat, zoom: f64) -> f64 {
        self.raw[at].off(turn, zoom)
    }

    /// Pace, turning and zoom of a piece; and whether it meets all its poses.
    fn finished(
        &self,
        mut piece: Piece,
        chosen: &[usize],
        ways: &[f64],
        slack: f64,
        joint: Joint,
        place: &dyn Fn(f64) -> DVec3,
    ) -> Result<Option<Piece>> {
        let (first, last) = (piece.first, piece.last);
        let (begin, frames) = (self.times[first].round(), f64::from(piece.frames));
        let share = |k: usize| ((self.times[k] - begin) / frames).clamp(0.0, 1.0);
        let mut pace = None;
        for intervals in [1, 2, 4, 8, 16, chosen.len() - 1] {
            if intervals > chosen.len() - 1 {
                continue;
            }
            let mut keys: Vec<[f64; 2]> = vec_with_room(intervals + 1)?;
            for k in 0..=intervals {
                let at = k * (chosen.len() - 1) / intervals;
                let (mut time, mut way) = (share(chosen[at]), ways[at]);
                if k == 0 {
                    (time, way) = (0.0, 0.0);
                } else if k == intervals {
                    (time, way) = (1.0, 1.0);
                } else if let Some(before) = keys.last() {
                    // Rest within a piece: nearly none.
                    way = way.clamp(before[1] + 1e-9, 1.0 - 1e-9 * (intervals - k) as f64);
                }
                keys.push([time, way]);
            }
            let Ok(found) = own::distance(&keys) else {
                continue;
            };
            let timing = timing(&found)?;
            let off = |(at, way): (&usize, &f64)| (timing.fraction(share(*at)) - way).abs();
            let fits = chosen.iter().zip(ways).map(off).all(|off| off <= slack);
            pace = Some((found, timing));
            if fits {
                break;
            }
        }
        let Some((pace, timing)) = pace else {
            return Ok(None);
        };
        piece.pace = pace;

        let mut ways = vec_with_room(chosen.len())?;
        ways.extend(chosen.iter().map(|k| timing.fraction(share(*k))));
        let Some(control) = self.turning(chosen, &ways) else {
            return Ok(None);
        };
        piece.velocities = [
            3.0 * log(control[1] * control[0].conjugate()),
            3.0 * log(control[3] * control[2].conjugate()),
        ];
        let zoom = self.zoom(chosen, &ways, joint.zoom_slope.map(|slope| slope * frames));
        piece.zoom_slopes = zoom;
        let [from, to] = [first, last].map(|k| self.smooth[k].zoom);
        for k in first..=last {
            let way = timing.fraction(share(k));
            let far = (place(way) - self.raw[k].position).length();
            if !(far <= self.tolerance) {
                return Ok(None);
            }
            let zoom = hermite(way, [from, to], zoom);
            if !(self.off(k, bezier(&control, way), zoom) <= self.angle) {
                return Ok(None);
            }
        }
        Ok(Some(piece))
    }

    /// A cubic through the positions of some poses by least squares, and their parameters on it.
    fn cubic(
        &self,
        chosen: &[usize],
        direction: Option<DVec3>,
    ) -> Result<Option<(Cubic, Vec<f64>)>> {
        let mut points = vec_with_room(chosen.len())?;
        points.extend(chosen.iter().map(|k| self.smooth[*k].position));
        let (from, to) = (points[0], points[points.len() - 1]);
        let mut places: Vec<f64> = vec_with_room(chosen.len())?;
        let mut length = 0.0;
        places.push(0.0);
        for pair in points.windows(2) {
            length += (pair[1] - pair[0]).length();
            places.push(length);
        }
        if !(length > 1e-9 * self.tolerance) {
            return Ok(None);
        }
        places.iter_mut().for_each(|place| *place /= length);
        let mut best: Option<(f64, Cubic, Vec<f64>)> = None;
        for _ in 0..ROUNDS {
            let curve = least_squares(&points, &places, (from, to), direction, length);
            let squares = points.iter().zip(&places);
            let error: f64 = squares
                .map(|(p, t)| (curve.point(*t) - *p).length_squared())
                .sum();
            let settled = best.as_ref().is_some_and(|best| error > 0.98 * best.0);
            if best.as_ref().is_none_or(|best| error < best.0) {
                let mut kept = vec_with_room(places.len())?;
                kept.extend_from_slice(&places);
                best = Some((error, curve, kept));
            }
            let enough = 0.02 * self.tolerance;
            if settled || error < enough * enough {
                break;
            }
            // Newton towards the nearest point, in order.
            for k in 1..points.len() - 1 {
                let t = places[k];
                let off = curve.point(t) - points[k];
                let (d, dd) = (curve.derivative(t), curve.second_derivative(t));
                let slope = d.length_squared() + off.dot(dd);
                if slope > 0.0 {
                    places[k] = t - off.dot(d) / slope;
                }
                places[k] = places[k].clamp(places[k - 1], 1.0);
            }
        }
        Ok(best.map(|(_, curve, places)| (curve, places)))
    }

    /// Control quaternions from the first to the last of some poses by Gauss–Newton (a small turn
    /// of one acts with its Bernstein polynomial), as far as a key may own such velocities.
    fn turning(&self, chosen: &[usize], ways: &[f64]) -> Option<[DQuat; 4]> {
        let (a, b) = (
            self.smooth[chosen[0]].turn,
            self.smooth[chosen[chosen.len() - 1]].turn,
        );
        if a.dot(b) < 1e-6 {
            return None;
        }
        let whole = log(b * a.conjugate());
        let (mut leave, mut reach) = (whole / 3.0, whole / 3.0);
        let control = |leave: DVec3, reach: DVec3| [a, exp(leave) * a, exp(-reach) * b, b];
        for _ in 0..6 {
            let (mut m, mut right) = ([0.0_f64; 3], [DVec3::ZERO; 2]);
            let now = control(leave, reach);
            for (k, &t) in chosen.iter().zip(ways) {
                let q = self.smooth[*k].turn;
                let off = log(q * bezier(&now, t).conjugate());
                let (x, y) = (3.0 * t * (1.0 - t) * (1.0 - t), -3.0 * t * t * (1.0 - t));
                m = [m[0] + x * x, m[1] + x * y, m[2] + y * y];
                right = [right[0] + x * off, right[1] + y * off];
            }
            let determinant = m[0] * m[2] - m[1] * m[1];
            if determinant <= 1e-9 * m[0] * m[2] {
                break;
            }
            leave += (right[0] * m[2] - right[1] * m[1]) / determinant;
            reach += (right[1] * m[0] - right[0] * m[1]) / determinant;
        }
        let most = 0.45 * (std::f64::consts::PI - angle(a, b));
        (leave.length() <= most && reach.length() <= most).then(|| control(leave, reach))
    }

    /// Slopes of the zoom at both ends by least squares, clipped to its range.
    fn zoom(&self, chosen: &[usize], ways: &[f64], given: Option<f64>) -> [f64; 2] {
        let zoom = |k: usize| self.smooth[chosen[k]].zoom;
        let (from, to) = (zoom(0), zoom(chosen.len() - 1));
        let (mut m, mut right) = ([0.0; 3], [0.0; 2]);
        for (k, &t) in ways.iter().enumerate() {
            let off = zoom(k) - hermite(t, [from, to], [0.0; 2]);
            let (x, y) = (t * (1.0 - t) * (1.0 - t), -t * t * (1.0 - t));
            m = [m[0] + x * x, m[1] + x * y, m[2] + y * y];
            right = [right[0] + x * off, right[1] + y * off];
        }
        // A piece of few frames tells its slopes badly: none may leave for the longest lenses.
        let longest = MAX_LIST_ZOOM.max(2.0 * from.max(to)).min(MAX_ZOOM);
        let clip = |slope: f64, end: f64, sign: f64| {
            let bounds = [3.0 * sign * (MIN_ZOOM - end), 3.0 * sign * (longest - end)];
            slope.clamp(bounds[0].min(bounds[1]), bounds[0].max(bounds[1]))
        };
        let determinant = m[0] * m[2] - m[1] * m[1];
        let first = given.unwrap_or(if determinant > 1e-9 * m[0] * m[2] {
            (right[0] * m[2] - right[1] * m[1]) / determinant
        } else {
            to - from
        });
        let first = clip(first, from, 1.0);
        let second = if m[2] > 1e-12 {
            (right[1] - m[1] * first) / m[2]
        } else {
            to - from
        };
        [first, clip(second, to, -1.0)]
    }
}

fn timing(pace: &Pace) -> Result<Timing> {
    let mut orientation = Orientation::default();
    orientation.own = orientation.own.with(|own| own.pace = pace.clone())?;
    Timing::new(&orientation, None, None)
}

fn hermite(t: f64, [from, to]: [f64; 2], [leave, reach]: [f64; 2]) -> f64 {
    let (a, b) = (t * t * (3.0 - 2.0 * t), t * (1.0 - t));
    from * (1.0 - a) + to * a + leave * b * (1.0 - t) - reach * b * t
}

/// The cubic between two ends nearest to points at given parameters, leaving in `direction`.
fn least_squares(
    points: &[DVec3],
    places: &[f64],
    (from, to): (DVec3, DVec3),
    direction: Option<DVec3>,
    length: f64,
) -> Cubic {
    let (mut m, mut right) = ([0.0; 3], [DVec3::ZERO; 2]);
    for (point, &t) in points.iter().zip(places) {
        let a = t * t * (3.0 - 2.0 * t);
        let (x, y) = (t * (1.0 - t) * (1.0 - t), -t * t * (1.0 - t));
        let off = *point - from * (1.0 - a) - to * a;
        m = [m[0] + x * x, m[1] + x * y, m[2] + y * y];
        right = [right[0] + x * off, right[1] + y * off];
    }
    let determinant = m[0] * m[2] - m[1] * m[1];
    let chord = to - from;
    if points.len() < 4 || determinant <= 1e-9 * m[0] * m[2] {
        let leave = direction.map_or(chord, |direction| direction * length);
        return Cubic::hermite(from, to, leave, chord);
    }
    let leave = match direction {
        None => (right[0] * m[2] - right[1] * m[1]) / determinant,
        Some(d) => {
            let along = (right[0].dot(d) * m[2] - right[1].dot(d) * m[1]) / determinant;
            d * along.max(0.02 * length)
        }
    };
    Cubic::hermite(from, to, leave, (right[1] - leave * m[1]) / m[2])
}
