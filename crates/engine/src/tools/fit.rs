//! Recorded poses become a path of few points.
//!
//! Noise is taken out first (`smooth.rs`). Then pieces, each as long as it may
//! be, are fitted one after the other: a cubic by least squares with its
//! parameters projected anew (Schneider 1990) that goes on in the direction of the
//! one before; the way over the time as given distances; the turning as a spherical
//! Bézier curve and the zoom as a cubic over the way, by least squares too. A piece is
//! accepted by its errors at the poses themselves. Its length is sought by doubling
//! and halving, so that n poses cost n·log n.

use glam::{DMat3, DQuat, DVec3};

use super::smooth::{Row, noise, smoothed};
use crate::error::{Invalid, OutOfRange, Place, Result, vec_with_room};
use crate::limits::{MAX_DISTANCE_KEYS, MAX_FPS, MAX_ZOOM, MIN_ZOOM};
use crate::math::orientation::{quaternion_from_view, roll_from_up, view_from_quaternion};
use crate::math::quaternion::{angle, continue_sign, exp, log};
use crate::path::arc_length::ArcLength;
use crate::path::camera_path::{check_coordinates, check_zoom};
use crate::path::hermite::Cubic;
use crate::path::quaternion_spline::bezier;
use crate::path::timing::Timing;
use crate::path::{
    CameraPath, Orientation, Own, Pace, Pose, SupportPoint, Tangents, Target, Velocities, own,
};

/// Rounds of a fit; most settle sooner.
const ROUNDS: usize = 24;

/// How well the path must meet the poses.
#[derive(Debug, Clone, Copy)]
pub struct Tolerance {
    /// Of the position, > 0.
    pub position: f64,
    /// Of the view, up and field of view, in degrees, > 0.
    pub angle: f64,
}

/// Called now and then with the poses done and all of them; false ends the work.
pub type Progress<'a> = &'a mut dyn FnMut(usize, usize) -> bool;

/// All poses, as they came and without noise.
struct Data {
    /// In frames from the first.
    times: Vec<f64>,
    raw: Vec<Sample>,
    smooth: Vec<Sample>,
    tolerance: f64,
    /// Radians.
    angle: f64,
}

#[derive(Clone, Copy)]
struct Sample {
    position: DVec3,
    turn: DQuat,
    zoom: f64,
}

struct Piece {
    first: usize,
    last: usize,
    frames: u32,
    curve: Option<Cubic>,
    pace: Pace,
    /// Of the whole piece, on S³, leaving and reaching.
    velocities: [DVec3; 2],
    /// Slopes of the zoom for the whole piece at its ends.
    zoom_slopes: [f64; 2],
    /// Nothing moves: the frames are those of a hold.
    holds: bool,
}

/// What a piece takes over from the one before.
#[derive(Clone, Copy, Default)]
struct Joint {
    direction: Option<DVec3>,
    /// For a frame.
    zoom_slope: Option<f64>,
}

/// A path that passes all poses within a tolerance at their times: `seconds`
/// increasing, or evenly one a frame.
///
/// # Errors
/// [`crate::Error::Argument`] or [`crate::Error::Range`] for poses that are no path (fewer than
/// three, all the same, not finite, a view without direction) and tolerances that are
/// not > 0; [`crate::Error::Argument`] if `progress` ends it; [`crate::Error::Limit`],
/// [`crate::Error::Memory`].
pub fn fit(
    poses: &[Pose],
    seconds: Option<&[f64]>,
    fps: f64,
    tolerance: Tolerance,
    progress: Progress<'_>,
) -> Result<CameraPath> {
    let data = Data::new(poses, seconds, fps, tolerance)?;
    let last = poses.len() - 1;
    let mut pieces: Vec<Piece> = Vec::new();
    let (mut at, mut joint, mut guess) = (0, Joint::default(), 8);
    while at < last {
        let Some(piece) = data.longest(at, joint, guess)? else {
            // The rest is within one frame.
            break;
        };
        guess = piece.last - piece.first;
        at = piece.last;
        joint = Joint {
            direction: piece
                .curve
                .and_then(|curve| curve.derivative(1.0).try_normalize()),
            zoom_slope: if piece.holds {
                joint.zoom_slope
            } else {
                Some(piece.zoom_slopes[1] / f64::from(piece.frames))
            },
        };
        pieces.try_reserve(1)?;
        pieces.push(piece);
        if !progress(at, last) {
            return Err(Invalid::Cancelled.into());
        }
    }
    data.path(&pieces)
}

impl Data {
    fn new(
        poses: &[Pose],
        seconds: Option<&[f64]>,
        fps: f64,
        tolerance: Tolerance,
    ) -> Result<Self> {
        let sound = fps > 0.0
            && fps <= MAX_FPS
            && tolerance.position > 0.0
            && tolerance.position.is_finite()
            && tolerance.angle > 0.0
            && tolerance.angle <= 180.0;
        if !sound {
            return Err(OutOfRange::Tolerance.into());
        }
        if poses.len() < 3 {
            return Err(Invalid::TooFewPoses.into());
        }
        let mut times = vec_with_room(poses.len())?;
        match seconds {
            None => times.extend((0..poses.len()).map(|k| k as f64)),
            Some(seconds) => {
                times.extend(seconds.iter().map(|when| (when - seconds[0]) * fps));
                if times.len() != poses.len() || !times.windows(2).all(|pair| pair[1] > pair[0]) {
                    return Err(Invalid::PoseTimes.into());
                }
            }
        }
        let mut raw: Vec<Sample> = vec_with_room(poses.len())?;
        for (k, pose) in poses.iter().enumerate() {
            let sample = sample(pose).map_err(|error| error.at(Place::Pose(k + 1)))?;
            let before = raw.last().map_or(sample.turn, |before| before.turn);
            raw.push(Sample {
                turn: continue_sign(before, sample.turn).0,
                ..sample
            });
        }
        let first = poses[0];
        if poses.iter().all(|pose| *pose == first) {
            return Err(Invalid::SamePoses.into());
        }
        let mut data = Self {
            times,
            smooth: Vec::new(),
            raw,
            tolerance: tolerance.position,
            angle: tolerance.angle.to_radians(),
        };
        data.smooth = data.without_noise()?;
        Ok(data)
    }

    /// The samples with the noise taken out, if there is any to speak of.
    fn without_noise(&self) -> Result<Vec<Sample>> {
        let mut rows: Vec<Row> = vec_with_room(self.raw.len())?;
        rows.extend(self.raw.iter().map(|sample| {
            let (p, q) = (sample.position, sample.turn);
            [p.x, p.y, p.z, q.x, q.y, q.z, q.w, sample.zoom]
        }));
        let noise = noise(&rows)?;
        let place = noise[0].max(noise[1]).max(noise[2]);
        // On S³ an angle counts half.
        let turn = 2.0 * noise[3..7].iter().fold(0.0, |a: f64, b| a.max(*b));
        let mut smooth = vec_with_room(self.raw.len())?;
        if place < 0.01 * self.tolerance && turn < 0.01 * self.angle {
            smooth.extend_from_slice(&self.raw);
            return Ok(smooth);
        }
        // Noise may miss by all of its own, and motion by a little more.
        let allowed = |noise: f64, most: f64| (3.3 * noise).clamp(0.6 * most, 0.93 * most);
        let (place, turn) = (allowed(place, self.tolerance), allowed(turn, self.angle));
        let misses = |is: &Row, fitted: &Row| {
            let far = |range: std::ops::Range<usize>| {
                let squares = range.map(|k| (is[k] - fitted[k]).powi(2));
                squares.sum::<f64>().sqrt()
            };
            let seen = (view_angle(is[7]) - view_angle(fitted[7])).abs();
            (far(0..3) / place)
                .max(2.0 * far(3..7) / turn)
                .max(seen / turn)
        };
        for row in smoothed(&self.times, &rows, &misses)? {
            let turn = DQuat::from_xyzw(row[3], row[4], row[5], row[6]);
            smooth.push(Sample {
                position: DVec3::new(row[0], row[1], row[2]),
                turn: turn.normalize(),
                zoom: row[7].clamp(MIN_ZOOM, MAX_ZOOM),
            });
        }
        Ok(smooth)
    }

    /// Whole frames from one pose to another.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    fn frames(&self, first: usize, last: usize) -> u32 {
        (self.times[last].round() - self.times[first].round()) as u32
    }

    /// The longest piece from a pose on; none if no whole frame is left.
    fn longest(&self, first: usize, joint: Joint, guess: usize) -> Result<Option<Piece>> {
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

    /// A piece from one pose to another, if it is within the tolerance; else only if
    /// it `must` be.
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

    /// By which angle a view misses that of a pose, or its field of view.
    fn off(&self, at: usize, turn: DQuat, zoom: f64) -> f64 {
        let pose = &self.raw[at];
        let turned = 2.0 * angle(pose.turn, continue_sign(pose.turn, turn).0);
        turned.max((view_angle(pose.zoom) - view_angle(zoom)).abs())
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

    /// A cubic through the positions of some poses by least squares, from the first to
    /// the last, and their parameters on it.
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

    /// Control quaternions that turn from the first to the last of some poses by least
    /// squares (Gauss and Newton; a small turn of a control quaternion acts with its
    /// Bernstein polynomial), as far as a key may own such velocities.
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

    /// Slopes of the zoom at both ends for a whole piece, by least squares; the first
    /// may be given. Clipped, so that it stays in its range.
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
        let clip = |slope: f64, end: f64, sign: f64| {
            let bounds = [3.0 * sign * (MIN_ZOOM - end), 3.0 * sign * (MAX_ZOOM - end)];
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

    fn path(&self, pieces: &[Piece]) -> Result<CameraPath> {
        let mut points: Vec<SupportPoint> = vec_with_room(pieces.len() + 2)?;
        let mut start = Start::default();
        for piece in pieces {
            if piece.holds {
                let hold = start.hold + piece.frames;
                start = Start { hold, ..start };
                continue;
            }
            points.push(self.point(&start, Some(piece))?);
            start = Start {
                at: piece.last,
                hold: 0,
                before: Some(piece),
            };
        }
        points.push(self.point(&start, None)?);
        if points.len() == 1 {
            return Err(Invalid::WithinTolerance.into());
        }
        let mut path = CameraPath::try_new()?;
        path.points = points;
        path.check()?;
        Ok(path)
    }

    fn point(&self, start: &Start<'_>, next: Option<&Piece>) -> Result<SupportPoint> {
        let at = &self.smooth[start.at];
        let before = start.before;
        let mut point = SupportPoint::try_new(at.position)?;
        let tangent = |piece: Option<&Piece>, t: f64| {
            Some(
                piece?
                    .curve
                    .map_or(DVec3::ZERO, |curve| curve.derivative(t)),
            )
        };
        let (reach, leave) = (tangent(before, 1.0), tangent(next, 0.0));
        point.tangents = Some(Tangents {
            before: reach.or(leave).unwrap_or_default(),
            after: leave.or(reach).unwrap_or_default(),
        });
        let (view, up) = view_from_quaternion(at.turn);
        let rate = |piece: Option<&Piece>, side: usize| {
            // A rotation counts twice its angle on S³.
            let piece = piece?;
            Some(piece.velocities[side] * (2f64.to_degrees() / f64::from(piece.frames)))
        };
        let (reach, leave) = (rate(before, 1), rate(next, 0));
        let slope = |piece: &Piece, side: usize| piece.zoom_slopes[side] / f64::from(piece.frames);
        let zoom_slope = before
            .map(|piece| slope(piece, 1))
            .or_else(|| next.map(|piece| slope(piece, 0)));
        let zooms = |piece: Option<&Piece>| {
            piece.is_some_and(|piece| {
                let ends = [piece.first, piece.last].map(|k| self.smooth[k].zoom);
                ends[0] != ends[1] || piece.zoom_slopes != [0.0; 2]
            })
        };
        let zooms = zooms(before) || zooms(next);
        let own = |own: &mut Own| {
            own.velocities = Some(Velocities {
                reach: reach.or(leave).unwrap_or_default(),
                leave: leave.or(reach).unwrap_or_default(),
            });
            own.zoom_slope = zoom_slope.filter(|_| zooms);
            if let Some(piece) = next {
                own.pace = piece.pace.clone();
                own.frames = piece.frames;
            }
        };
        point.orientations[0] = Orientation {
            target: Target::Relative(view),
            roll: roll_from_up(view, up).to_degrees(),
            zoom: at.zoom,
            hold: start.hold,
            ..Orientation::default()
        };
        point.orientations[0].own = point.orientations[0].own.with(own)?;
        Ok(point)
    }
}

/// Where the next point comes to lie.
#[derive(Clone, Copy, Default)]
struct Start<'a> {
    at: usize,
    hold: u32,
    before: Option<&'a Piece>,
}

/// Half of what is seen from top to bottom, doubled: the vertical field of view.
fn view_angle(zoom: f64) -> f64 {
    2.0 * (12.0 / zoom).atan()
}

fn timing(pace: &Pace) -> Result<Timing> {
    let mut orientation = Orientation::default();
    orientation.own = orientation.own.with(|own| own.pace = pace.clone())?;
    Timing::new(&orientation, None, None)
}

/// A cubic from its ends and its slopes there.
fn hermite(t: f64, [from, to]: [f64; 2], [leave, reach]: [f64; 2]) -> f64 {
    let (a, b) = (t * t * (3.0 - 2.0 * t), t * (1.0 - t));
    from * (1.0 - a) + to * a + leave * b * (1.0 - t) - reach * b * t
}

/// The cubic between two ends that is nearest to points at given parameters; if a
/// direction is given it sets out in it.
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

/// A pose as a sample: finite, its view and up made to stand at right angles.
fn sample(pose: &Pose) -> Result<Sample> {
    let [position, view, up] = [pose.vrp, pose.vpn, pose.vup].map(DVec3::from_array);
    for v in [position, view, up] {
        check_coordinates(v)?;
    }
    check_zoom(pose.zoom)?;
    let side = up.cross(view).try_normalize();
    let (Some(side), Some(view)) = (side, view.try_normalize()) else {
        return Err(Invalid::UpParallel.into());
    };
    let up = DMat3::from_cols(side, view.cross(side), view).y_axis;
    Ok(Sample {
        position,
        turn: quaternion_from_view(view, up),
        zoom: pose.zoom,
    })
}

#[cfg(test)]
#[path = "fit_tests.rs"]
mod tests;
