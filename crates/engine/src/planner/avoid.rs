//! A way that keeps clear of an object: where the camera comes too near or goes through it, points
//! are moved as little as possible, and as few put in as it takes.

use std::fmt;

use glam::DVec3;

use self::apply::Bent;
use self::bend::{Detour, Knot};
use self::field::Field;
use self::route::Router;
use crate::error::{Error, Index, Invalid, Result, vec_with_room};
use crate::path::hermite::Cubic;
use crate::path::{CameraPath, Change, Sampler, Timeline};
use crate::scene::Mesh;
use crate::tools::clearance::Clearance;
use crate::tools::enclosure::Enclosure;
use crate::tools::fit::Progress;
use crate::tools::watch::Watch;

mod apply;
mod bend;
mod field;
mod route;
mod stretch;

/// What is asked for, in the path's units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AvoidRequest {
    /// The least distance from the object, greater than 0.
    pub clearance: f64,
    /// The radius of a sphere around the camera that keeps it, 0 or greater.
    pub radius: f64,
}

/// A part of a path whose way is another.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AvoidedPart {
    /// The point of the new path from which the way is new.
    pub from: usize,
    /// The point where it is the old one again.
    pub to: usize,
    /// Points that were moved.
    pub moved: usize,
    /// Points that were put in.
    pub inserted: usize,
    /// The farthest that any of these is from where the way was.
    pub furthest: f64,
}

/// The English sentence.
impl fmt::Display for AvoidedPart {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let number = |count: usize, what: &str| match count {
            1 => format!("1 point {what}"),
            count => format!("{count} points {what}"),
        };
        write!(
            f,
            "from point {} to point {}: {}, {}, at most {:.4} from the way that was",
            Index(self.from),
            Index(self.to),
            number(self.moved, "moved"),
            number(self.inserted, "put in"),
            self.furthest
        )
    }
}

/// A path that keeps clear.
#[derive(Debug)]
pub struct Avoided {
    /// The path.
    pub path: CameraPath,
    /// What is another way than before, in order; nothing if it was clear.
    pub parts: Vec<AvoidedPart>,
}

/// Shares of the distance kept beyond it on the way round, so that a smooth curve follows it.
const ROOM: [f64; 2] = [0.06, 0.002];

/// Rounds in which the distance grows, since the straight lines between frames that are far apart
/// still meet the object.
const ROUNDS: usize = 4;

/// A way round is at most so many times as long as the part of the curve that it stands for, where
/// it has room on each side; and places of the curve that are added on either side.
const LONGER: f64 = 1.5;
const BESIDE: usize = 24;

/// Faults after one that are tried as the end of a way round.
const AHEAD: usize = 12;

/// A way that keeps clear of a mesh, of its points if it has neither triangles nor lines.
///
/// The camera, with the sphere around it, keeps the clearance everywhere, between frames too.
/// Points that were clear stay, unless they lie where the way cannot come: within a closed part of
/// the object. The number of frames of each section stays, and so do targets.
///
/// # Errors
/// [`Error::Argument`] for a bad clearance or radius, an object without geometry, and where no way
/// is found: with the frame and the place; [`Error::Range`] where a section has fewer frames than
/// it takes points; [`Error::Limit`], [`Error::Memory`].
pub fn avoid(path: &CameraPath, object: &Mesh, request: &AvoidRequest) -> Result<Avoided> {
    let object = Clearance::new(object)?;
    avoid_object(path, &object, request, &mut |_, _| true)
}

/// As [`avoid`], of an object that is prepared; `progress` gets places that were looked at and all,
/// and ends it with `false`.
///
/// # Errors
/// As [`avoid`]; [`Error::Argument`] where `progress` ends it.
pub fn avoid_object(
    path: &CameraPath,
    object: &Clearance,
    request: &AvoidRequest,
    progress: Progress<'_>,
) -> Result<Avoided> {
    for (number, name) in [(request.clearance, "clearance"), (request.radius, "radius")] {
        if !number.is_finite() {
            return Err(Invalid::NumberNotFinite(name).into());
        }
    }
    let farthest = path.space.farthest();
    let need = request.clearance + request.radius;
    if !(request.clearance > 0.0 && request.radius >= 0.0 && need <= farthest) {
        return Err(Invalid::AvoidClearance(farthest).into());
    }
    let watch = &Watch::new(progress);
    let field = Field { object, watch };
    let made = led_clear(path, field, need);
    watch.check()?;
    made
}

/// As [`avoid_object`]; nothing to go by once the work does not go on.
fn led_clear<'a>(path: &'a CameraPath, field: Field<'a>, need: f64) -> Result<Avoided> {
    let mut more = need;
    for _ in 0..ROUNDS {
        let made = Work::new(path, field, more)?.avoided()?;
        let Some(bulge) = chords(&made.path, field)? else {
            return Ok(made);
        };
        more = more.max(need + 1.5 * bulge) * 1.01;
    }
    let sampler = Sampler::new(path, &Timeline::new(path)?)?;
    Err(no_way(1.0, sampler.pose(1.0)?.position(), need))
}

fn no_way(frame: f64, place: DVec3, need: f64) -> Error {
    let [x, y, z] = place.to_array();
    Invalid::NoWayRound {
        frame,
        x,
        y,
        z,
        need,
    }
    .into()
}

/// How far the curve bulges where the straight line from a frame to the next meets the object.
fn chords(path: &CameraPath, field: Field<'_>) -> Result<Option<f64>> {
    let timeline = Timeline::new(path)?;
    let sampler = Sampler::new(path, &timeline)?;
    let mut last: Option<DVec3> = None;
    let mut worst: Option<f64> = None;
    for (k, pose) in sampler.iter().enumerate() {
        let here = pose?.position();
        if let Some(last) = last
            && field.is_crossed(last, here)
        {
            let middle = sampler.pose(k as f64 + 0.5)?.position();
            let bulge = middle.distance(0.5 * (last + here));
            worst = Some(worst.unwrap_or(0.0).max(bulge));
        }
        last = Some(here);
    }
    Ok(worst)
}

/// The path as one curve of legs: the segments that have a length, from the point at which it
/// begins. A closed one ends where it begins.
struct Work<'a> {
    path: &'a CameraPath,
    timeline: Timeline,
    sampler: Sampler,
    field: Field<'a>,
    need: f64,
    /// Its points in order, of a closed path the first again; and where they lie.
    points: Vec<(usize, f64)>,
    /// Segments of the legs, their curves and frames.
    segments: Vec<usize>,
    legs: Vec<Cubic>,
    frames: Vec<usize>,
    enclosure: Option<Enclosure<'a>>,
}

/// A part of the way that is too near, as numbers of legs, and as wide as where there is room.
#[derive(Debug, Clone, Copy)]
struct Near {
    from: f64,
    to: f64,
    wide: [f64; 2],
}

impl<'a> Work<'a> {
    fn new(path: &'a CameraPath, field: Field<'a>, need: f64) -> Result<Self> {
        let timeline = Timeline::new(path)?;
        let sampler = Sampler::new(path, &timeline)?;
        let count = path.points.len();
        let mut work = Self {
            path,
            timeline,
            sampler,
            field,
            need,
            points: vec_with_room(count + 1)?,
            segments: vec_with_room(count)?,
            legs: vec_with_room(count)?,
            frames: vec_with_room(count)?,
            enclosure: None,
        };
        let first = if path.closed { work.beginning()? } else { 0 };
        for k in 0..count {
            let point = (first + k) % count;
            work.points.push((point, work.legs.len() as f64));
            if point >= work.timeline.segment_count() {
                continue;
            }
            let last = path.points[point].orientations.len() - 1;
            let section = work.timeline.section_from(point, last);
            let section = section.map(|section| work.timeline.section(section));
            if let Some(section) = section.filter(|section| section.change == Change::Position) {
                work.segments.push(point);
                work.legs.push(*work.timeline.curve(point));
                work.frames.push(section.frames);
            }
        }
        if path.closed {
            work.points.push((first, work.legs.len() as f64));
        }
        Ok(work)
    }

    /// Where to begin on a closed path: at a clear point outside of closed parts, if there is one.
    fn beginning(&mut self) -> Result<usize> {
        let mut clear = None;
        for (at, point) in self.path.points.iter().enumerate() {
            if self.field.far(point.position, self.need) < self.need {
                continue;
            }
            if !self.is_inside(point.position)? {
                return Ok(at);
            }
            clear = clear.or(Some(at));
        }
        Ok(clear.unwrap_or(0))
    }

    fn is_inside(&mut self, place: DVec3) -> Result<bool> {
        if let Some(known) = &self.enclosure {
            return known.holds(place);
        }
        self.enclosure = Enclosure::around(self.field.object, place)?;
        Ok(self.enclosure.is_some())
    }

    fn place(&self, u: f64) -> DVec3 {
        let leg = (u as usize).min(self.legs.len() - 1);
        self.legs[leg].point(u - leg as f64)
    }

    /// Where the curve is too near.
    fn near(&self, need: f64) -> Result<Vec<Near>> {
        let mut all: Vec<Near> = Vec::new();
        for (leg, curve) in self.legs.iter().enumerate() {
            for fault in self.field.faults(curve, need)? {
                let (from, to) = (leg as f64 + fault.from, leg as f64 + fault.to);
                match all.last_mut() {
                    Some(last) if last.to == from => (last.to, last.wide[1]) = (to, to),
                    _ => {
                        all.try_reserve(1)?;
                        let wide = [from, to];
                        all.push(Near { from, to, wide });
                    }
                }
            }
        }
        Ok(all)
    }

    /// The faults, each as wide as where there is more room, but not over a clear point.
    fn faults(&self) -> Result<Vec<Near>> {
        let mut all = self.near(self.need)?;
        if all.is_empty() {
            return Ok(all);
        }
        let wide = self.near(self.need * (1.0 + ROOM[0]))?;
        let clear = |at: f64| {
            let here = self.points.iter().filter(|(_, u)| *u == at);
            here.clone().count() > 0 && self.field.far(self.place(at), self.need) >= self.need
        };
        for k in 0..all.len() {
            let Near { from, to, .. } = all[k];
            let around = wide.iter().find(|near| near.from <= from && near.to >= to);
            let mut ends = around.map_or([from, to], |near| [near.from, near.to]);
            // Clear points are at whole numbers.
            if let Some(at) = whole(ends[0], from).rev().find(|at| clear(*at)) {
                ends[0] = ends[0].max(at);
            }
            if let Some(at) = whole(to, ends[1]).find(|at| clear(*at)) {
                ends[1] = ends[1].min(at);
            }
            if k > 0 {
                ends[0] = ends[0].max(all[k - 1].wide[1]);
            }
            if let Some(next) = all.get(k + 1) {
                ends[1] = ends[1].min(0.5 * (to + next.from));
            }
            all[k].wide = ends;
        }
        Ok(all)
    }

    fn avoided(&mut self) -> Result<Avoided> {
        if self.legs.is_empty() {
            return self.resting();
        }
        let faults = self.faults()?;
        if faults.is_empty() {
            return Ok(Avoided {
                path: self.path.try_clone()?,
                parts: Vec::new(),
            });
        }
        let detours = self.detours(&faults)?;
        let mut bent: Vec<Bent<'_, '_>> = vec_with_room(detours.len())?;
        for stretch in self.stretches(&detours)? {
            let found = self.bent(stretch, &detours, &mut bent)?;
            bent.push(found);
            let done = detours.len() + bent.len();
            self.field.watch.at(done, 2 * detours.len())?;
        }
        self.applied(&bent)
    }

    /// A path that stays at one place.
    fn resting(&self) -> Result<Avoided> {
        let mut path = self.path.try_clone()?;
        let mut parts = Vec::new();
        let here = path.points[0].position;
        if self.field.far(here, self.need) < self.need {
            let there = self.field.pushed(here, self.need);
            let there = there.ok_or_else(|| no_way(1.0, here, self.need))?;
            for point in &mut path.points {
                point.position += there - here;
            }
            path.check()?;
            parts.try_reserve(1)?;
            parts.push(AvoidedPart {
                from: 0,
                to: path.points.len() - 1,
                moved: path.points.len(),
                inserted: 0,
                furthest: here.distance(there),
            });
        }
        Ok(Avoided { path, parts })
    }

    /// Where a way round begins or ends: on the curve, or next to it where the curve ends too near.
    fn end(&mut self, u: f64, clear: f64) -> Result<DVec3> {
        let here = self.place(u);
        if self.field.far(here, self.need) >= self.need {
            return Ok(here);
        }
        let found = self.field.pushed(here, clear);
        let found = found.or_else(|| self.field.pushed(here, self.need * (1.0 + ROOM[1])));
        found.ok_or_else(|| no_way(self.frame(u), here, self.need))
    }

    /// The ways round.
    fn detours(&mut self, faults: &[Near]) -> Result<Vec<Detour>> {
        let [low, high] = [self.path.space.low(), self.path.space.high()];
        let router = Router {
            field: self.field,
            space: [low, high],
            need: self.need,
        };
        let clear = self.need * (1.0 + ROOM[0]);
        let mut detours: Vec<Detour> = vec_with_room(faults.len())?;
        let mut k = 0;
        while k < faults.len() {
            self.field.watch.at(k, 2 * faults.len())?;
            let [from, _] = faults[k].wide;
            let begin = self.end(from, clear)?;
            let mut found: Option<(usize, Detour)> = None;
            for last in k..faults.len().min(k + AHEAD) {
                let to = faults[last].wide[1];
                let end = self.end(to, clear)?;
                // A way into a cavity and out again may be longer than past it.
                let beyond = found.is_some();
                if beyond && self.has_point(faults[last - 1].to, faults[last].from) {
                    break;
                }
                let ends = [begin, end];
                if self.is_inside(begin)? != self.is_inside(end)? {
                    if beyond { break } else { continue }
                }
                let around = self.around(from, to, ends);
                let mut line = router.way(ends, around, clear)?;
                if line.is_none() && !beyond {
                    let less = self.need * (1.0 + ROOM[1]);
                    line = router.way(ends, around, less)?;
                }
                let Some(line) = line else {
                    if beyond { break } else { continue }
                };
                let shorter = |known: &Detour| length(&line) <= length(&known.line);
                if found.as_ref().is_none_or(|(_, known)| shorter(known)) {
                    found = Some((last, Detour { from, to, line }));
                } else {
                    break;
                }
            }
            let Some((last, detour)) = found else {
                let at = faults[k].from;
                return Err(no_way(self.frame(at), self.place(at), self.need));
            };
            detours.push(detour);
            k = last + 1;
        }
        for k in 0..detours.len() {
            self.spread(&mut detours, k)?;
        }
        Ok(detours)
    }

    /// Gives a way round that is much longer than the part of the curve that it stands for more of
    /// the curve around it, so that its parameters do not crowd.
    fn spread(&self, detours: &mut [Detour], k: usize) -> Result<()> {
        let Detour { from, to, .. } = detours[k];
        let stays = |u: &f64| !self.moves(*u, detours);
        let points = || self.points.iter().map(|(_, u)| *u);
        let low = points().rfind(|u| *u <= from && stays(u));
        let high = points().find(|u| *u >= to && stays(u));
        let before = k.checked_sub(1).map_or(0.0, |k| detours[k].to);
        let behind = detours.get(k + 1);
        let behind = behind.map_or(self.legs.len() as f64, |next| next.from);
        let low = low.unwrap_or(from).max(before).min(from);
        let high = high.unwrap_or(to).min(behind).max(to);
        let old = |a: f64, b: f64| -> f64 {
            let place = |k: i32| self.place(a + (b - a) * f64::from(k) / 32.0);
            (0..32).map(|k| place(k).distance(place(k + 1))).sum()
        };
        let (new, was) = (length(&detours[k].line), old(from, to));
        let mut ends = [from, to];
        for share in (1..=8).map(|step| f64::from(step) / 10.0) {
            let beside = old(ends[0], from) + old(to, ends[1]);
            if new + beside <= LONGER * (was + beside) {
                break;
            }
            ends = [from - share * (from - low), to + share * (high - to)];
        }
        let steps = if self.path.curve.is_straight() {
            1
        } else {
            BESIDE
        };
        let places = |a: f64, b: f64, skip: usize| {
            let count = if a < b { steps } else { 0 };
            let at = move |k: usize| a + (b - a) * k as f64 / steps as f64;
            (skip..count + skip).map(move |k| self.place(at(k)))
        };
        let mut line = vec_with_room(detours[k].line.len() + 2 * steps)?;
        line.extend(places(ends[0], from, 0));
        line.extend_from_slice(&detours[k].line);
        line.extend(places(to, ends[1], 1));
        [detours[k].from, detours[k].to] = ends;
        detours[k].line = line;
        Ok(())
    }

    fn has_point(&self, from: f64, to: f64) -> bool {
        self.points.iter().any(|(_, u)| *u >= from && *u <= to)
    }

    /// The box of a part of the way.
    fn around(&self, from: f64, to: f64, ends: [DVec3; 2]) -> [DVec3; 2] {
        let places = (0..=64).map(|k| self.place(from + (to - from) * f64::from(k) / 64.0));
        let start = [ends[0].min(ends[1]), ends[0].max(ends[1])];
        places.fold(start, |[low, high], p| [low.min(p), high.max(p)])
    }

    /// Whether a point has to move: it is too near, or a way round leads past it.
    fn moves(&self, u: f64, detours: &[Detour]) -> bool {
        let passed = |detour: &Detour| detour.from < u && u < detour.to;
        detours.iter().any(passed) || self.field.far(self.place(u), self.need) < self.need
    }

    /// The section of a leg.
    fn section(&self, leg: usize) -> usize {
        let point = self.segments[leg];
        let last = self.path.points[point].orientations.len() - 1;
        self.timeline.section_from(point, last).unwrap_or(0)
    }

    /// The frame at which the camera is at a place of the way, for people.
    fn frame(&self, u: f64) -> f64 {
        let leg = (u as usize).min(self.legs.len() - 1);
        let section = self.section(leg);
        let first = self.sampler.first_frame(section) as f64 - 1.0;
        let frames = self.frames[leg];
        let wanted = self.place(u);
        let far = |k: &usize| {
            let pose = self.sampler.pose(first + *k as f64);
            pose.map_or(f64::INFINITY, |pose| pose.position().distance(wanted))
        };
        let near = (0..=frames).min_by(|a, b| far(a).total_cmp(&far(b)));
        first + near.unwrap_or(0) as f64
    }
}

/// Whole numbers in a range.
fn whole(from: f64, to: f64) -> impl DoubleEndedIterator<Item = f64> {
    (from.ceil() as usize..=to.floor() as usize).map(|k| k as f64)
}

fn length(line: &[DVec3]) -> f64 {
    line.windows(2).map(|pair| pair[0].distance(pair[1])).sum()
}

#[cfg(test)]
#[path = "avoid_tests.rs"]
mod tests;
