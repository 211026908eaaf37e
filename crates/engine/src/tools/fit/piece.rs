//! One piece of a fitted path: as long as its errors at the poses themselves allow, and as its
//! accelerations stay near those of the splines.

use glam::{DQuat, DVec3};

use super::motion::{Kind, Peaks, State, Stretch};
use super::pace::{Way, pace, timing};
use super::{Data, Joint, Piece, Sample};
use crate::error::{Result, vec_with_room};
use crate::limits::{BASE_SPEED, MAX_LIST_ZOOM, MAX_ZOOM, MIN_ZOOM};
use crate::math::quaternion::{angle, exp, log};
use crate::path::arc_length::ArcLength;
use crate::path::hermite::Cubic;
use crate::path::quaternion_spline::bezier;
use crate::path::timing::Timing;
use crate::path::{Pace, own};

/// Equal intervals of a piece between the moments at which its splines are evaluated.
pub(super) const MOMENTS: usize = 30;

/// Where the pace is slower than this share of its mean, turning and zoom ignore their rates.
const SLOW: f64 = 1e-3;

/// By how much accelerations may jump from piece to piece, of the position and of the turning before
/// its jumps are evened out, and be off between, in shares of the greatest.
const JUMP: [f64; 2] = [0.04, 0.12];
const OFF: f64 = 0.25;

/// Of the jump, what the keys of a pace may take.
const AT_KEYS: f64 = 0.01;

/// How much the spin may jump, in shares of what the greatest acceleration makes of it in a frame.
const SPIN_JUMP: f64 = 1e-3;

/// An acceleration is nothing if it moves by less than this share of the tolerance in a second.
const NOTHING: f64 = 1e-2;

/// Moments from an end of a stretch at which its splines do not know the acceleration yet.
const OPEN: usize = 8;

/// Factor by which a turning may exceed the velocity that a key may own, before it is clamped.
const LIMITED: f64 = 1.05;

/// Rounds of a cubic by least squares; most settle sooner.
const ROUNDS: usize = 24;

/// Rounds of projection onto the one that is taken.
const SETTLED: usize = 4;

/// What the splines say at the moments of a piece.
pub(super) struct Course {
    from: f64,
    frames: f64,
    states: Vec<State>,
    joint: Joint,
    /// Whether it begins and ends where the stretch does: no acceleration goes on there.
    open: [bool; 2],
    peaks: Peaks,
    /// Nothing better was found: it need not be smooth,
    pub must: bool,
    /// and may miss poses.
    free: bool,
}

impl Course {
    pub(super) fn new(
        stretch: &Stretch,
        [from, to]: [f64; 2],
        joint: Joint,
        open: [bool; 2],
        peaks: Peaks,
    ) -> Result<Self> {
        let mut states = vec_with_room(MOMENTS + 1)?;
        states.extend((0..=MOMENTS).map(|k| stretch.at(from + (to - from) * Self::share(k))));
        Ok(Self {
            from,
            frames: to - from,
            states,
            joint,
            open,
            peaks,
            must: false,
            free: false,
        })
    }

    pub(super) fn share(moment: usize) -> f64 {
        moment as f64 / MOMENTS as f64
    }

    fn ends(&self) -> [&State; 2] {
        [&self.states[0], &self.states[MOMENTS]]
    }

    fn end(&self) -> Sample {
        self.states[MOMENTS].sample
    }

    fn turns(&self) -> [DQuat; 2] {
        [self.joint.sample.turn, self.states[MOMENTS].sample.turn]
    }

    fn zooms(&self) -> [f64; 2] {
        [self.joint.sample.zoom, self.states[MOMENTS].sample.zoom]
    }
}

impl Data {
    /// The longest piece from a whole frame on, at most to another one.
    pub(super) fn longest(
        &self,
        stretch: &Stretch,
        peaks: Peaks,
        [begin, from, end]: [f64; 3],
        joint: Joint,
        guess: f64,
    ) -> Result<Piece> {
        if stretch.kind == Kind::Rests {
            return Ok(rest(end - from, joint));
        }
        let course = |to: f64| {
            let open = [from == begin, to == end];
            Course::new(stretch, [from, to], joint, open, peaks)
        };
        let search = |on_the_spot: bool| -> Result<Option<Piece>> {
            let (mut good, mut reached, mut bad) = (None, from, end + 1.0);
            let mut step = guess;
            loop {
                let next = (from + step).min(end).min(bad - 1.0);
                if next <= reached {
                    return Ok(good);
                }
                let course = course(next)?;
                let found = if on_the_spot {
                    self.on_the_spot(&course)?
                } else {
                    self.moving(&course)?
                };
                if found.is_some() {
                    (good, reached) = (found, next);
                } else {
                    bad = next;
                }
                // Doubled as long as it goes, then halved.
                step = if bad > end {
                    2.0 * step
                } else {
                    (0.5 * (reached + bad) - from).floor()
                };
            }
        };
        let moves = stretch.kind == Kind::Moves;
        if moves && let Some(piece) = search(false)? {
            return Ok(piece);
        }
        let mut frame = course(from + 1.0)?;
        frame.must = true;
        if moves && let Some(piece) = self.moving(&frame)? {
            return Ok(piece);
        }
        match search(true)? {
            Some(piece) => Ok(piece),
            None => self.straight(frame.frames, joint, frame.end()),
        }
    }

    /// From a pose to the next, as the splines lead there, whatever that misses between.
    pub(super) fn to_next_pose(
        &self,
        stretch: &Stretch,
        frames: [f64; 2],
        joint: Joint,
    ) -> Result<Piece> {
        if stretch.kind == Kind::Rests {
            return Ok(rest(frames[1] - frames[0], joint));
        }
        let mut course = Course::new(stretch, frames, joint, [false; 2], Peaks::default())?;
        (course.must, course.free) = (true, true);
        let moved = match stretch.kind {
            Kind::Moves => self.moving(&course)?,
            _ => self.on_the_spot(&course)?,
        };
        moved.map_or_else(|| self.straight(course.frames, joint, course.end()), Ok)
    }

    /// The whole frame nearest to the next pose behind a frame.
    pub(super) fn next_pose(&self, frame: f64) -> f64 {
        let end = self.times[self.times.len() - 1];
        let next = self.times.partition_point(|time| time.round() <= frame);
        // The last pose is at the end, though it may be nearer to the frame before.
        let within = next + 1 < self.poses();
        if within {
            self.times[next].round()
        } else {
            end
        }
    }

    /// What there must be where nothing else will do.
    pub(super) fn straight(&self, frames: f64, joint: Joint, end: Sample) -> Result<Piece> {
        let start = joint.sample;
        let [a, b] = [start, end].map(|sample| sample.position);
        // Between two equal views there is no section.
        if !(a.distance(b) > 1e-6 * self.tolerance) && self.same_view(&start, &end) {
            return Ok(rest(frames, joint));
        }
        let turned = log(end.turn * start.turn.conjugate());
        Ok(Piece {
            frames: whole(frames),
            start,
            end,
            curve: Some(Cubic::hermite(a, b, b - a, b - a)),
            pace: own::distance(&[[0.0, 0.0], [1.0, 1.0]])?,
            velocities: [turned; 2],
            zoom_slopes: [end.zoom - start.zoom; 2],
            length: a.distance(b),
            speeds: [[1.0 / frames, 0.0]; 2],
            missed: [0.0; 2],
            holds: false,
            corner: false,
        })
    }

    pub(super) fn moving(&self, course: &Course) -> Result<Option<Piece>> {
        let Some((curve, places)) = self.cubic(course)? else {
            return Ok(None);
        };
        let arc = ArcLength::new(&curve)?;
        if !(arc.length() > 1e-6 * self.tolerance) {
            return Ok(None);
        }
        // Share of the way, and its derivative by the share of the time.
        let square = course.frames * course.frames;
        let mut ways: Vec<[f64; 3]> = vec_with_room(places.len())?;
        for (state, place) in course.states.iter().zip(&places) {
            let along = curve.derivative(*place).normalize_or_zero();
            let speed = state.velocity.dot(along) * course.frames;
            let faster = state.bends[0].dot(along) * square;
            ways.push([arc.length_at(*place), speed, faster].map(|part| part / arc.length()));
        }
        let [a, b] = course.turns();
        let [moves, turns] = self
            .shares(course, [AT_KEYS; 2])
            .map(|share| share * square);
        let slack = [
            0.01 * self.tolerance / arc.length(),
            (moves / arc.length()).min(turns / angle(a, b).max(1e-9)),
        ];
        let Some((pace, timing)) = pace(&ways, slack)? else {
            return Ok(None);
        };
        let place = |way: f64| curve.point(arc.parameter_at(way * arc.length()));
        let way = Way {
            curve: Some(curve),
            length: arc.length(),
            pace,
            timing,
        };
        self.finished(course, way, &place)
    }

    fn same_view(&self, a: &Sample, b: &Sample) -> bool {
        angle(a.turn, b.turn) < 1e-3 * self.angle && (b.zoom - a.zoom).abs() < 1e-6
    }

    /// On the spot, by an even pace.
    fn on_the_spot(&self, course: &Course) -> Result<Option<Piece>> {
        // From and to the same view there is no section.
        if self.same_view(&course.joint.sample, &course.end()) {
            return Ok(None);
        }
        let pace = own::distance(&[[0.0, 0.0], [1.0, 1.0]])?;
        let way = Way {
            curve: None,
            length: 0.0,
            timing: timing(&pace)?,
            pace,
        };
        let position = course.joint.sample.position;
        self.finished(course, way, &|_| position)
    }

    /// Turning and zoom of a piece; none if it does not meet its poses, or not smoothly.
    pub(super) fn finished(
        &self,
        course: &Course,
        way: Way,
        place: &dyn Fn(f64) -> DVec3,
    ) -> Result<Option<Piece>> {
        let (frames, timing) = (course.frames, &way.timing);
        // For a frame at speed 50: what the ends say, where the pace is not too slow for it.
        let rates = [0, 1].map(|side| {
            let speed = timing.speed([0.0, 1.0][side]) / BASE_SPEED;
            (speed >= SLOW && !course.open[side]).then_some(frames / speed)
        });
        let mut ways = vec_with_room(MOMENTS + 1)?;
        ways.extend((0..=MOMENTS).map(|k| timing.fraction(Course::share(k))));
        let spins = [0, 1].map(|side| Some(course.ends()[side].spin * rates[side]?));
        let Some(control) = turning(course, &ways, spins) else {
            return Ok(None);
        };
        let begins = course.joint.zoom_slope.map(|slope| slope * frames);
        let zooming = [0, 1].map(|side| Some(course.ends()[side].zooming * rates[side]?));
        let zoom_slopes = zoom(course, &ways, [begins.or(zooming[0]), zooming[1]]);
        let first = self.times.partition_point(|time| *time < course.from);
        for (k, time) in self.times.iter().enumerate().skip(first) {
            if *time > course.from + frames {
                break;
            }
            if self.left_out[k] || course.free {
                continue;
            }
            let raw = &self.raw[k];
            let way = timing.fraction(((time - course.from) / frames).clamp(0.0, 1.0));
            let far = (place(way) - raw.position).length();
            let zoom = hermite(way, course.zooms(), zoom_slopes);
            if !(far <= self.tolerance && raw.off(bezier(&control, way), zoom) <= self.angle) {
                return Ok(None);
            }
        }
        let mut missed = [0.0; 2];
        for (state, way) in course.states.iter().zip(&ways) {
            let sample = &state.sample;
            let far = [
                place(*way).distance(sample.position),
                sample.off(bezier(&control, *way), sample.zoom),
            ];
            if !course.must && (0..2).any(|k| far[k] > self.near[k]) {
                return Ok(None);
            }
            missed = [0, 1].map(|k| missed[k] + far[k] * far[k] / (MOMENTS + 1) as f64);
        }
        let piece = Piece {
            frames: whole(frames),
            start: course.joint.sample,
            end: Sample {
                position: place(1.0),
                ..course.states[MOMENTS].sample
            },
            velocities: [
                3.0 * log(control[1] * control[0].conjugate()),
                3.0 * log(control[3] * control[2].conjugate()),
            ],
            zoom_slopes,
            speeds: [0, 1].map(|side| way.speeds(side, frames)),
            curve: way.curve,
            length: way.length,
            pace: way.pace,
            missed,
            holds: false,
            corner: false,
        };
        let smooth = course.must
            || self.goes_on(course, &piece, timing)
                && self.is_smooth(course, &ways, &control, place);
        Ok(smooth.then_some(piece))
    }

    /// Such a share of the greatest accelerations, of the position and on S³, or what counts as
    /// nothing or may be noise.
    fn shares(&self, course: &Course, shares: [f64; 2]) -> [f64; 2] {
        let nothing = NOTHING / (self.fps * self.fps);
        let least = [self.tolerance, self.angle].map(|tolerance| nothing * tolerance);
        let Peaks {
            greatest, unsure, ..
        } = course.peaks;
        [0, 1].map(|k| (shares[k] * greatest[k]).max(least[k]).max(unsure[k]))
    }

    /// Whether spin and accelerations go on at the ends: from the piece before, and to where the
    /// splines go on. Those of the turning are made to meet later.
    fn goes_on(&self, course: &Course, piece: &Piece, timing: &Timing) -> bool {
        let jump = self.shares(course, JUMP);
        let kick = self.shares(course, [SPIN_JUMP; 2])[1];
        (0..2).filter(|side| !course.open[*side]).all(|side| {
            let state = course.ends()[side];
            let near = [course.joint.bend, state.bends[0]][side];
            let rate = timing.speed([0.0, 1.0][side]) / BASE_SPEED / course.frames;
            let spin = piece.velocities[side] * rate - state.spin;
            spin.length() <= kick
                && (piece.bend(side) - near).length() <= jump[0]
                && (piece.twist(side) - state.bends[1]).length() <= jump[1]
        })
    }

    /// Whether the accelerations within are near those of the splines: what is missed at three
    /// moments tells by how much they are off.
    fn is_smooth(
        &self,
        course: &Course,
        ways: &[f64],
        control: &[DQuat; 4],
        place: &dyn Fn(f64) -> DVec3,
    ) -> bool {
        let step = course.frames / MOMENTS as f64;
        let most = self
            .shares(course, [OFF; 2])
            .map(|share| share * step * step);
        let off = |k: usize| {
            let (state, way) = (&course.states[k], ways[k]);
            let turned = log(bezier(control, way) * state.sample.turn.conjugate());
            [place(way) - state.sample.position, turned]
        };
        let mut last = [off(0), off(1)];
        for k in 2..=MOMENTS {
            let next = off(k);
            let at_an_end =
                (course.open[0] && k < OPEN) || (course.open[1] && k > MOMENTS + 2 - OPEN);
            let bend = |k: usize| last[0][k] - 2.0 * last[1][k] + next[k];
            if !at_an_end && (0..2).any(|k| bend(k).length() > most[k]) {
                return false;
            }
            last = [last[1], next];
        }
        true
    }

    /// The cubic nearest to the positions that leaves and ends in the directions of the splines,
    /// and the parameters at which it comes nearest.
    pub(super) fn cubic(&self, course: &Course) -> Result<Option<(Cubic, Vec<f64>)>> {
        let mut points = vec_with_room(MOMENTS + 1)?;
        points.extend(course.states.iter().map(|state| state.sample.position));
        points[0] = course.joint.sample.position;
        let length: f64 = points
            .windows(2)
            .map(|pair| pair[0].distance(pair[1]))
            .sum();
        if !(length > 1e-6 * self.tolerance) {
            return Ok(None);
        }
        // At rest, the direction in which it begins to move.
        let direction = |state: &State, near: DVec3| {
            let velocity = state.velocity * course.frames;
            let moves = velocity.length() > 1e-3 * length;
            if moves { velocity } else { near }.normalize_or_zero()
        };
        let directions = [
            direction(&course.states[0], points[1] - points[0]),
            direction(
                &course.states[MOMENTS],
                points[MOMENTS] - points[MOMENTS - 1],
            ),
        ];
        let mut places = vec_with_room(MOMENTS + 1)?;
        places.extend((0..=MOMENTS).map(Course::share));
        let mut best: Option<(f64, Cubic, Vec<f64>)> = None;
        for _ in 0..ROUNDS {
            let curve = least_squares(&points, &places, directions, length);
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
            if settled {
                break;
            }
            project(&curve, &points, &mut places);
        }
        Ok(best.map(|(_, curve, mut places)| {
            for _ in 0..SETTLED {
                project(&curve, &points, &mut places);
            }
            (curve, places)
        }))
    }
}

/// Newton towards the nearest points of a curve, in order.
fn project(curve: &Cubic, points: &[DVec3], places: &mut [f64]) {
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

pub(super) fn rest(frames: f64, joint: Joint) -> Piece {
    Piece {
        frames: whole(frames),
        start: joint.sample,
        end: joint.sample,
        curve: None,
        pace: Pace::Speeds,
        velocities: [DVec3::ZERO; 2],
        zoom_slopes: [0.0; 2],
        speeds: [[0.0; 2]; 2],
        length: 0.0,
        missed: [0.0; 2],
        holds: true,
        corner: false,
    }
}

#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
pub(super) fn whole(frames: f64) -> u32 {
    frames as u32
}

/// Control quaternions of a piece. Where a velocity is not given it is found by Gauss–Newton (a
/// small turn of one acts with its Bernstein polynomial). None if a key may not own such ones.
fn turning(course: &Course, ways: &[f64], spins: [Option<DVec3>; 2]) -> Option<[DQuat; 4]> {
    let [a, b] = course.turns();
    if a.dot(b) < 1e-6 {
        return None;
    }
    let whole = log(b * a.conjugate());
    let [mut leave, mut reach] = spins.map(|spin| spin.unwrap_or(whole) / 3.0);
    let control = |leave: DVec3, reach: DVec3| [a, exp(leave) * a, exp(-reach) * b, b];
    for _ in 0..if spins.iter().all(Option::is_some) {
        0
    } else {
        6
    } {
        let (mut m, mut right) = ([0.0_f64; 3], [DVec3::ZERO; 2]);
        let now = control(leave, reach);
        for (state, &t) in course.states.iter().zip(ways) {
            let off = log(state.sample.turn * bezier(&now, t).conjugate());
            let x = if spins[0].is_some() {
                0.0
            } else {
                3.0 * t * (1.0 - t) * (1.0 - t)
            };
            let y = if spins[1].is_some() {
                0.0
            } else {
                -3.0 * t * t * (1.0 - t)
            };
            m = [m[0] + x * x, m[1] + x * y, m[2] + y * y];
            right = [right[0] + x * off, right[1] + y * off];
        }
        let [x, y] = solved(m, right);
        (leave, reach) = (leave + x, reach + y);
    }
    let most = 0.45 * (std::f64::consts::PI - angle(a, b));
    // A key's own limiter does the last bit of this.
    let within = [leave, reach]
        .iter()
        .all(|part| part.length() <= LIMITED * most);
    let [leave, reach] = [leave, reach].map(|part| part.clamp_length_max(most));
    within.then(|| control(leave, reach))
}

/// Two unknowns by their normal equations; one that has no part in them is 0.
fn solved(m: [f64; 3], right: [DVec3; 2]) -> [DVec3; 2] {
    let determinant = m[0] * m[2] - m[1] * m[1];
    if m[0] == 0.0 || m[2] == 0.0 {
        let alone = |m: f64, right: DVec3| if m > 1e-12 { right / m } else { DVec3::ZERO };
        return [alone(m[0], right[0]), alone(m[2], right[1])];
    }
    if determinant <= 1e-9 * m[0] * m[2] {
        return [DVec3::ZERO; 2];
    }
    [
        (right[0] * m[2] - right[1] * m[1]) / determinant,
        (right[1] * m[0] - right[0] * m[1]) / determinant,
    ]
}

/// Slopes of the zoom at both ends, by least squares where they are not given, clipped to its range.
fn zoom(course: &Course, ways: &[f64], given: [Option<f64>; 2]) -> [f64; 2] {
    let [from, to] = course.zooms();
    if course.states.iter().all(|state| state.sample.zoom == from) {
        return [0.0; 2];
    }
    // A piece of few frames tells its slopes badly: none may leave for the longest lenses.
    let longest = MAX_LIST_ZOOM.max(2.0 * from.max(to)).min(MAX_ZOOM);
    let clip = |slope: f64, end: f64, sign: f64| {
        let bounds = [3.0 * sign * (MIN_ZOOM - end), 3.0 * sign * (longest - end)];
        slope.clamp(bounds[0].min(bounds[1]), bounds[0].max(bounds[1]))
    };
    let clipped = |[leave, reach]: [f64; 2]| [clip(leave, from, 1.0), clip(reach, to, -1.0)];
    let known = clipped(given.map(|given| given.unwrap_or(0.0)));
    let (mut m, mut right) = ([0.0; 3], [DVec3::ZERO; 2]);
    for (state, &t) in course.states.iter().zip(ways) {
        let off = DVec3::X * (state.sample.zoom - hermite(t, [from, to], known));
        let x = if given[0].is_some() {
            0.0
        } else {
            t * (1.0 - t) * (1.0 - t)
        };
        let y = if given[1].is_some() {
            0.0
        } else {
            -t * t * (1.0 - t)
        };
        m = [m[0] + x * x, m[1] + x * y, m[2] + y * y];
        right = [right[0] + x * off, right[1] + y * off];
    }
    let found = solved(m, right);
    clipped([known[0] + found[0].x, known[1] + found[1].x])
}

pub(super) fn hermite(t: f64, [from, to]: [f64; 2], [leave, reach]: [f64; 2]) -> f64 {
    let (a, b) = (t * t * (3.0 - 2.0 * t), t * (1.0 - t));
    from * (1.0 - a) + to * a + leave * b * (1.0 - t) - reach * b * t
}

/// The cubic between the first and the last of some points nearest to those between, at given
/// parameters, with tangents of given directions.
fn least_squares(
    points: &[DVec3],
    places: &[f64],
    [leave, reach]: [DVec3; 2],
    length: f64,
) -> Cubic {
    let (from, to) = (points[0], points[points.len() - 1]);
    let (mut m, mut right) = ([0.0; 3], [0.0; 2]);
    for (point, &t) in points.iter().zip(places) {
        let a = t * t * (3.0 - 2.0 * t);
        let (x, y) = (t * (1.0 - t) * (1.0 - t), -t * t * (1.0 - t));
        let off = *point - from * (1.0 - a) - to * a;
        m = [m[0] + x * x, m[1] + x * y * leave.dot(reach), m[2] + y * y];
        right = [right[0] + x * off.dot(leave), right[1] + y * off.dot(reach)];
    }
    let determinant = m[0] * m[2] - m[1] * m[1];
    let least = 0.02 * length;
    let (mut along, mut out) = (length, length);
    if determinant > 1e-9 * m[0] * m[2] {
        along = (right[0] * m[2] - right[1] * m[1]) / determinant;
        out = (right[1] * m[0] - right[0] * m[1]) / determinant;
    }
    Cubic::hermite(from, to, leave * along.max(least), reach * out.max(least))
}
