//! The pace of a path recomputed: where the camera is at a place it looks where it looked before.

pub use self::request::{Request, Rest, Retimed};
use super::course::{Bounds, Course};
use super::frames::{GoOn, Joint, Paced};
use super::reach::{Margin, Reach};
use super::track::{Knot, Miss, Track, track};
use crate::error::{Error, Invalid, OutOfRange, Result, vec_with_room};
use crate::limits::{MAX_FRAMES, MAX_SPEED, MIN_SPEED, SPEEDS};
use crate::path::speed_curve::{CurveEnd, end_slopes};
use crate::path::{
    CameraPath, Orientation, Pace, PacePart, PaceSource, Sampler, Timeline, Timing, own,
};
use crate::tools::check::FindingKind;
use crate::tools::fit::Progress;

/// Cells of the grid on a section, and of all together, about.
const CELLS: [usize; 2] = [32, 2000];
const ALL_CELLS: usize = 2000;

/// Share of a frame's change by which a rate may jump where sections meet.
const JUMP: f64 = 0.1;

/// A joint at which a pace could have less than this share of its rate is a kink.
const KINK: f64 = 0.3;

/// The first shares of the limits of rates and of changes that are left free, for what cells and
/// keys do not follow, and the greatest.
const LEAST_MARGIN: Margin = [1e-6, 1e-6];
const MOST_MARGIN: f64 = 0.98;

/// The greatest share of one section's rate by another's where they meet; else the pace rests.
const MOST_GAIN: f64 = 100.0;

/// Rounds in which margins grow.
const ROUNDS: usize = 40;

/// Rounds in which a pace is smoothed, if it is to be.
const SMOOTHED: usize = 25;

/// The pace of a path, or of a range of it, recomputed: as fast as the limits allow, or in a
/// given time with the lowest peaks. Rest at the ends of an open path and where keys are held;
/// where a range ends, the speed of its neighbour, as far as the limits allow. `progress` gets
/// rounds done and the most there can be, and ends it with `false`.
///
/// # Errors
/// [`crate::Error::Argument`] for limits of 0, none at all, a time shorter than they allow, or
/// where the pace would have to rest within a section, or `progress` ends it;
/// [`crate::Error::Range`] for points that do not exist; [`crate::Error::Limit`] for too many
/// frames; [`crate::Error::Memory`].
pub fn retime(path: &CameraPath, request: &Request, progress: Progress<'_>) -> Result<Retimed> {
    let bounds = Bounds::new(&request.limits)?;
    if !(request.seconds >= 0.0 && request.seconds.is_finite()) {
        return Err(Invalid::PaceTime.into());
    }
    let timeline = Timeline::new(path)?;
    let sampler = Sampler::new(path, &timeline)?;
    let mut work = Work::new(path, &timeline, &sampler, request, bounds)?;
    if work.courses.is_empty() {
        return Ok(Retimed {
            path: path.try_clone()?,
            seconds: work.holds as f64 / request.fps,
            rests: Vec::new(),
        });
    }
    work.start_smooth()?;
    for round in 0..ROUNDS {
        // What does not come to whole frames is not smoothed.
        if round == SMOOTHED && work.smoothing.take().is_some() {
            work.start_plain();
        }
        let mut go_on = || match progress(round, ROUNDS) {
            true => Ok(()),
            false => Err(Error::from(Invalid::Cancelled)),
        };
        let (paces, slower) = match work.paces(&mut go_on) {
            // What was found is the least of a pace without whole frames and keys.
            Err(Error::Argument(Invalid::PaceSeconds { seconds, .. })) => {
                let fastest = Request {
                    seconds: 0.0,
                    ..*request
                };
                let least = retime(path, &fastest, progress)?.seconds;
                if least <= seconds {
                    return Err(work.not_held());
                }
                return Err(Invalid::PaceSeconds { seconds, least }.into());
            }
            paces => paces?,
        };
        let Some(flown) = work.flown(&paces, slower)? else {
            continue;
        };
        if !work.tracks(flown, &mut go_on)? {
            continue;
        }
        let made = work.apply(path, &timeline, &paces)?;
        if work.holds_in(&made)? {
            let frames: usize = paces.iter().map(|pace| pace.frames).sum();
            return Ok(Retimed {
                path: made,
                seconds: (frames + work.holds) as f64 / request.fps,
                rests: work.rests,
            });
        }
    }
    Err(work.not_held())
}

struct Work<'a> {
    request: &'a Request,
    bounds: Bounds,
    courses: Vec<Course>,
    joints: Vec<Joint>,
    ring: bool,
    /// Frames in which keys of the range rest, and where the path ends that of its last pose.
    holds: usize,
    rests: Vec<Rest>,
    /// Shares of the limits of rates and of changes that are left free, for each cell of each
    /// section.
    margins: Vec<Vec<Margin>>,
    tracks: Vec<Track>,
    smoothing: Option<Smoothing>,
    /// By how many seconds smoothing makes the fastest pace of a section longer.
    lags: Vec<f64>,
    /// The section and the limit that were missed last.
    missed: (usize, FindingKind),
}

/// Places of the courses of a range among all that move.
fn range(
    path: &CameraPath,
    timeline: &Timeline,
    points: Option<[usize; 2]>,
) -> Result<(Vec<usize>, bool)> {
    let last = path.points.len() - 1;
    let [from, to] = points.unwrap_or([0, last]);
    for point in [from, to] {
        if point > last {
            return Err(path.no_point(point));
        }
    }
    let count = timeline.section_count();
    let start = |point, orientation| timeline.section_from(point, orientation).unwrap_or(count);
    let begin = start(from, 0);
    let end = start(to, path.points[to].orientations.len() - 1);
    let whole = (from, to) == (0, last);
    let mut found = vec_with_room(count)?;
    match (path.closed, whole) {
        (_, true) => found.extend(0..count),
        (true, _) if from > to => found.extend((begin..count).chain(0..end)),
        _ if from > to => {
            return Err(OutOfRange::PointOrder {
                first: from,
                last: to,
            }
            .into());
        }
        _ => found.extend(begin..end),
    }
    Ok((found, whole))
}

impl<'a> Work<'a> {
    fn new(
        path: &CameraPath,
        timeline: &Timeline,
        sampler: &Sampler,
        request: &'a Request,
        bounds: Bounds,
    ) -> Result<Self> {
        let (sections, whole) = range(path, timeline, request.points)?;
        let moving = timeline.moving().count().max(1);
        let cells = (ALL_CELLS / moving).clamp(CELLS[0], CELLS[1]);
        let mut courses: Vec<Course> = vec_with_room(sections.len())?;
        let mut beside: [Option<Course>; 2] = [None, None];
        let mut all = vec_with_room(moving)?;
        all.extend(sampler.courses());
        let index = |section: usize| {
            all.iter()
                .position(|course| course.number_and_frames().0 == section)
        };
        let new = |at: usize| Course::new(path, timeline, all[at], cells);
        let mut places = vec_with_room(sections.len())?;
        for at in sections.iter().filter_map(|section| index(*section)) {
            places.push(at);
            courses.push(new(at)?);
        }
        if let (Some(&first), Some(&last)) = (places.first(), places.last())
            && !whole
        {
            let around = |at: usize, step: usize| (at + step) % all.len();
            if first > 0 || path.closed {
                beside[0] = Some(new(around(first, all.len() - 1))?);
            }
            if last + 1 < all.len() || path.closed {
                beside[1] = Some(new(around(last, 1))?);
            }
        }
        let hold =
            |course: &Course| path.points[course.point].orientations[course.orientation].hold;
        let mut holds: usize = courses.iter().map(|course| hold(course) as usize).sum();
        let last = path.points.len() - 1;
        let end = request.points.map_or(last, |points| points[1]);
        if !(whole && path.closed) {
            let view = path.points[end].orientations.last();
            holds += view.map_or(0, |view| view.hold as usize);
        }
        holds += usize::from(if path.closed { whole } else { end == last });
        let count = courses.len();
        let mut work = Self {
            request,
            bounds,
            courses,
            joints: vec_with_room(count + 1)?,
            ring: whole && path.closed && count > 0,
            holds,
            rests: Vec::new(),
            margins: vec_with_room(count)?,
            tracks: Vec::new(),
            smoothing: None,
            lags: vec_with_room(count)?,
            missed: (0, FindingKind::Speed),
        };
        if count > 0 {
            work.join(&beside)?;
        }
        work.lags.resize(count, 0.0);
        // Of a ring the first section is known now.
        for course in &work.courses {
            let mut margins = vec_with_room(course.cells())?;
            margins.resize(course.cells(), LEAST_MARGIN);
            work.margins.push(margins);
        }
        Ok(work)
    }

    /// How all sections meet.
    fn join(&mut self, beside: &[Option<Course>; 2]) -> Result<()> {
        let count = self.courses.len();
        let fps = self.request.fps;
        if self.ring {
            // It begins where it rests, if it does anywhere.
            let mut first = None;
            for k in 0..count {
                let (joint, _) =
                    self.joint(&self.courses[(k + count - 1) % count], &self.courses[k]);
                if joint.most == 0.0 && first.is_none() {
                    first = Some(k);
                }
            }
            if let Some(first) = first {
                self.courses.rotate_left(first);
            }
            self.ring = first.is_none();
        }
        let rest = Joint {
            gain: 1.0,
            most: 0.0,
        };
        for k in 0..=count {
            let before = match k {
                0 if self.ring => Some(&self.courses[count - 1]),
                0 => beside[0].as_ref(),
                k => Some(&self.courses[k - 1]),
            };
            let after = match k {
                k if k == count && self.ring => Some(&self.courses[0]),
                k if k == count => beside[1].as_ref(),
                k => Some(&self.courses[k]),
            };
            let (Some(before), Some(after)) = (before, after) else {
                self.joints.push(rest);
                continue;
            };
            let (mut joint, kink) = self.joint(before, after);
            if let Some(limit) = kink
                && !after.rests
            {
                self.rests.try_reserve(1)?;
                self.rests.push(Rest {
                    point: after.point,
                    orientation: after.orientation,
                    limit,
                });
            }
            // Beside a range its speed is as it is.
            let given = |course: &Course, slope: f64| (slope * fps / course.frames as f64).powi(2);
            if k == 0 && !self.ring && joint.most > 0.0 {
                joint.most = joint.most.min(given(before, before.slopes[1])) * joint.gain;
                joint.gain = 1.0;
            } else if k == count && !self.ring && joint.most > 0.0 {
                joint.most = joint.most.min(given(after, after.slopes[0]) / joint.gain);
            }
            self.joints.push(joint);
        }
        Ok(())
    }

    /// How two sections meet, and the limit of a kink.
    fn joint(&self, before: &Course, after: &Course) -> (Joint, Option<FindingKind>) {
        let (left, right) = (before.end(), after.node(0));
        let rest = Joint {
            gain: 1.0,
            most: 0.0,
        };
        if after.rests {
            return (rest, None);
        }
        let (ways, turns) = (
            [left, right].map(|ask| ask.tangent.length()),
            [left, right].map(|ask| ask.turn.length()),
        );
        let pairs = [ways, turns, [left.zoom, right.zoom]];
        let both = |pair: &&[f64; 2]| {
            let [a, b] = **pair;
            a.min(b) > 1e-6 && (a / b).max(b / a) < MOST_GAIN
        };
        let Some(pair) = pairs.iter().find(both) else {
            return (rest, Some(FindingKind::Acceleration));
        };
        let ratio = pair[0] / pair[1];
        let bounds = &self.bounds;
        let fps = self.request.fps;
        let total: f64 = self
            .courses
            .iter()
            .map(|course| course.node(0).tangent.length())
            .sum();
        let mut most = bounds.rate(left).0.min(bounds.rate(right).0 / ratio);
        most = most
            .min((2.0 * bounds.acceleration * total).sqrt() / ways[0])
            .min(1e6);
        let jumps = [
            (
                left.tangent,
                right.tangent,
                bounds.acceleration,
                FindingKind::Acceleration,
            ),
            (
                left.turn,
                right.turn,
                bounds.turning_acceleration,
                FindingKind::TurningAcceleration,
            ),
        ];
        let mut found = (f64::INFINITY, FindingKind::Acceleration);
        for (a, b, limit, kind) in jumps {
            let jump = (b * ratio - a).length();
            let passes = JUMP * limit / fps / jump;
            if jump > 1e-7 * a.length().max(b.length() * ratio) && passes < found.0 {
                found = (passes, kind);
            }
        }
        if found.0 < KINK * most || most <= 0.0 {
            return (rest, Some(found.1));
        }
        let joint = Joint {
            gain: ratio * ratio,
            most: found.0.min(most).powi(2),
        };
        (joint, None)
    }

    /// Paces of all sections with these limits, made slower all alike.
    fn planned(&self, slower: f64, go_on: GoOn<'_>) -> Result<(Vec<Reach>, Vec<Paced>)> {
        let reaches = self.reaches(&self.slower_bounds(slower))?;
        let paces = self.row(&reaches, slower).plan(go_on)?;
        Ok((reaches, paces))
    }

    /// Paces, and how much slower than the fastest their limits were.
    fn paces(&self, go_on: GoOn<'_>) -> Result<(Vec<Paced>, f64)> {
        let all = |paces: &[Paced]| paces.iter().map(|pace| pace.frames).sum::<usize>();
        let (_, fastest) = self.planned(1.0, go_on)?;
        if fastest.len() < self.courses.len() {
            return Err(self.not_held());
        }
        let least = all(&fastest);
        if least + self.holds > MAX_FRAMES {
            return Err(crate::error::TooMany::Frames.into());
        }
        if self.request.seconds == 0.0 {
            return Ok((fastest, 1.0));
        }
        let frames = self.request.seconds * self.request.fps;
        if frames > MAX_FRAMES as f64 {
            return Err(crate::error::TooMany::Frames.into());
        }
        let wanted = (frames.round() as usize).saturating_sub(self.holds);
        if wanted < least {
            return Err(Invalid::PaceSeconds {
                seconds: self.request.seconds,
                least: (least + self.holds) as f64 / self.request.fps,
            }
            .into());
        }
        let mut ends = [
            1.0,
            1.5 * (wanted + self.courses.len()) as f64 / least as f64,
        ];
        let (mut best, mut pace) = (self.planned(1.0, go_on)?, 1.0);
        for _ in 0..20 {
            let slower = 0.5 * (ends[0] + ends[1]);
            let found = self.planned(slower, go_on)?;
            let fits = found.1.len() == self.courses.len() && all(&found.1) <= wanted;
            ends[usize::from(!fits)] = slower;
            if fits {
                (best, pace) = (found, slower);
                if all(&best.1) == wanted {
                    break;
                }
            }
        }
        let (reaches, mut paces) = best;
        let row = self.row(&reaches, pace);
        let mut more = vec_with_room(paces.len())?;
        more.resize(paces.len(), 0_usize);
        for _ in 0..wanted - all(&paces) {
            // Where one more frame is the least.
            let share = |k: usize| (more[k] + 1) as f64 / paces[k].frames as f64;
            let fits = |k: &usize| (paces[*k].frames + more[*k] + 1) as f64 <= paces[*k].longest;
            let Some(at) = (0..paces.len())
                .filter(fits)
                .min_by(|a, b| share(*a).total_cmp(&share(*b)))
            else {
                return Err(self.not_held());
            };
            more[at] += 1;
        }
        for (k, more) in more.into_iter().enumerate().filter(|(_, more)| *more > 0) {
            paces[k] = row.lengthened(k, &paces[k], more)?;
        }
        Ok((paces, pace))
    }

    /// Keys for all paces; where they do not hold the limits, its margin grows.
    fn tracks(&mut self, flown: Vec<Vec<Knot>>, go_on: GoOn<'_>) -> Result<bool> {
        let mut hold = true;
        let mut before = std::mem::take(&mut self.tracks).into_iter();
        for (k, knots) in flown.into_iter().enumerate() {
            go_on()?;
            let fps = self.request.fps;
            // Most sections have the pace that they had.
            let same = before.next().filter(|track| track.knots == knots);
            let found = match same {
                Some(found) => found,
                None => track(knots, &self.courses[k], &self.bounds, fps)?,
            };
            let (worst, kind) = found.worst();
            if worst > 1.0 {
                hold = false;
                self.missed = (k, kind);
                for miss in &found.misses {
                    self.give_way(k, *miss);
                }
            }
            self.tracks.try_reserve(1)?;
            self.tracks.push(found);
        }
        Ok(hold)
    }

    /// A part of a section leaves more of a limit free.
    fn give_way(&mut self, section: usize, miss: Miss) {
        let changes = matches!(
            miss.kind,
            FindingKind::Acceleration | FindingKind::TurningAcceleration | FindingKind::Jerk
        );
        let cells = self.margins[section].len();
        let cell = |share: f64| ((share * cells as f64).max(0.0) as usize).min(cells);
        let range = cell(miss.from).saturating_sub(1)..(cell(miss.to) + 2).min(cells);
        for margin in &mut self.margins[section][range] {
            let margin = &mut margin[usize::from(changes)];
            let left = (1.0 - *margin) / miss.worst.clamp(1.0, 1.25).powf(0.7) - 0.001;
            *margin = (1.0 - left).min(MOST_MARGIN);
        }
    }

    fn not_held(&self) -> crate::Error {
        let course = &self.courses[self.missed.0.min(self.courses.len() - 1)];
        Invalid::PaceKeys {
            point: course.point,
            orientation: course.orientation,
            limit: self.missed.1.name(),
        }
        .into()
    }

    /// The path with the keys found. What is beside a range keeps its pace.
    fn apply(&self, path: &CameraPath, timeline: &Timeline, paces: &[Paced]) -> Result<CameraPath> {
        let mut made = path.try_clone()?;
        let inside = |section: usize| self.courses.iter().any(|course| course.section == section);
        for section in timeline.moving().filter(|section| !inside(*section)) {
            let at = timeline.section(section);
            let orientation = &mut made.points[at.point].orientations[at.orientation];
            if orientation.own.pace == Pace::Speeds && !at.constant_speed {
                let speeds = orientation.speeds;
                let slopes = end_slopes(&speeds, timeline.curve_ends(path, section)?);
                let of = PaceSource::Speeds { speeds, slopes };
                pinned(orientation, of)?;
            }
        }
        for ((course, pace), track) in self.courses.iter().zip(paces).zip(&self.tracks) {
            let orientation = &mut made.points[course.point].orientations[course.orientation];
            pinned(orientation, own::track(&track.keys)?)?;
            orientation.own = orientation.own.with(|own| {
                own.frames = pace.frames as u32;
                own.curve_time = Some(course.curve_time);
            })?;
            let timing = Timing::new(orientation, [CurveEnd::Free; 2])?;
            for (k, speed) in orientation.speeds.iter_mut().enumerate() {
                *speed = timing
                    .speed(k as f64 / (SPEEDS - 1) as f64)
                    .clamp(MIN_SPEED, MAX_SPEED);
            }
        }
        made.check()?;
        Ok(made)
    }
}

/// An orientation with a pace that its neighbours do not shape.
fn pinned(orientation: &mut Orientation, of: PaceSource) -> Result<()> {
    let part = PacePart {
        of,
        from: 0.0,
        to: 1.0,
    };
    orientation.own = orientation.own.with(|own| own.pace = Pace::Part(part))?;
    Ok(())
}

#[path = "held.rs"]
mod held;
mod request;

#[path = "jerky.rs"]
mod jerky;

use jerky::Smoothing;

#[cfg(test)]
#[path = "retime_tests.rs"]
mod tests;
