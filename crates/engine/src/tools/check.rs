//! What will look wrong in a film. Lengths count in units of `half_size`.
//!
//! Between frames a view that jumps is found by halving the interval, a cusp by the least tangent
//! of the curve, a jump of the speed by differences on both sides of a key.

use std::fmt;

use glam::{DQuat, DVec3};

use super::clearance::Clearance;
use super::fit::Progress;
pub use super::kinds::{COUNT, FindingKind, OFF};
pub use super::limits::Limits;
use super::redundant::without;
use super::watch::Watch;
use crate::deform::Bounds;
use crate::error::{Result, vec_with_room};
use crate::limits::{BASE_SPEED, MIN_SPEED};
use crate::math::orientation::quaternion_from_view;
use crate::math::quaternion::{angle, continue_sign, log};
use crate::path::arc_length::ArcLength;
use crate::path::hermite::Cubic;
use crate::path::{CameraPath, Change, Pace, Pose, Sampler, Section, Target, Timeline, half_turn};

/// Whether a value is beyond a limit by more than rounding.
fn beyond(value: f64, limit: f64) -> bool {
    value - limit > 1e-9 * limit.max(1.0)
}

/// Something that was found.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Finding {
    /// What it is.
    pub kind: FindingKind,
    /// The first frame, from 1.
    pub first_frame: f64,
    /// The last frame.
    pub last_frame: f64,
    /// The point at which the section begins, from 0.
    pub point: usize,
    /// The orientation of that point with which it begins.
    pub orientation: usize,
    /// The worst value.
    pub value: f64,
    /// The limit.
    pub limit: f64,
}

impl Finding {
    /// Its sentence, or that of another language in its place; `number` writes one with so many
    /// decimals.
    #[must_use]
    pub fn say(&self, sentence: &str, number: impl Fn(f64, usize) -> String) -> String {
        let [value, limit] = [self.value, self.limit].map(|value| number(value, decimals(value)));
        let filled = sentence.replace("{0}", &value).replace("{1}", &limit);
        let key = [self.point + 1, self.orientation + 1].map(|at| at.to_string());
        filled.replace("{2}", &key[0]).replace("{3}", &key[1])
    }
}

/// The English sentence.
impl fmt::Display for Finding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let number = |value: f64, decimals: usize| format!("{value:.decimals$}");
        f.write_str(&self.say(self.kind.sentence(), number))
    }
}

/// The number of decimals that show three digits of a number, or all.
fn decimals(value: f64) -> usize {
    let enough = |decimals: &usize| {
        let scaled = (value * 10_f64.powi(*decimals as i32)).abs();
        scaled >= 99.95 || (scaled - scaled.round()).abs() < 1e-6
    };
    (0..9).find(enough).unwrap_or(9)
}

/// What a path is checked against.
#[derive(Debug, Clone, Copy)]
pub struct CheckContext<'a> {
    /// Frames a second.
    pub fps: f64,
    /// The space that the camera must not leave.
    pub space: Option<Bounds>,
    /// The object, if there is one.
    pub object: Option<&'a Clearance>,
    /// The limits.
    pub limits: Limits,
}

/// Poses that are sampled at once.
const BLOCK: usize = 1024;

/// Step of the differences beside a key, in frames.
const BESIDE: f64 = 1e-4;

/// A turn between two frames that may be a jump, in radians.
const SUSPECT: f64 = 0.01;

/// Everything that is found, in the order of the frames.
///
/// # Errors
/// [`crate::Error::Limit`] if the path has too many frames, [`crate::Error::Memory`].
pub fn check(path: &CameraPath, against: &CheckContext<'_>) -> Result<Vec<Finding>> {
    check_watched(path, against, &mut |_, _| true)
}

/// As [`check`]; `progress` gets frames that were looked at and all, and ends it with `false`.
///
/// # Errors
/// As [`check`]; [`crate::Error::Argument`] where `progress` ends it.
pub fn check_watched(
    path: &CameraPath,
    against: &CheckContext<'_>,
    progress: Progress<'_>,
) -> Result<Vec<Finding>> {
    let watch = Watch::new(progress);
    let timeline = Timeline::new(path)?;
    let sampler = Sampler::new(path, &timeline)?;
    let sections = sections(&timeline, &sampler)?;
    let mut scan = Scan {
        path,
        against,
        sampler: &sampler,
        stops: stops(path, &sections, sampler.frame_count())?,
        sections,
        open: [None; COUNT],
        found: Vec::new(),
    };
    for section in 0..timeline.section_count() {
        scan.section(&timeline, section)?;
    }
    scan.joins(&timeline)?;
    scan.redundant(&timeline, &watch)?;
    let frames = sampler.frame_count();
    let mut poses = vec_with_room(BLOCK)?;
    let mut before = [None; 3];
    let mut done = 0;
    while done < frames {
        let count = BLOCK.min(frames - done);
        poses.resize(count, Pose::default());
        sampler.sample(done + 1, &mut poses)?;
        watch.at(done, frames)?;
        for pose in &poses {
            watch.check()?;
            done += 1;
            let here = Frame::new(done, pose, before[2].as_ref());
            scan.frame(&here, before)?;
            before = [before[1], before[2], Some(here)];
        }
    }
    for kind in FindingKind::all() {
        scan.close(kind)?;
    }
    let mut found = scan.found;
    found.retain(|finding| finding.limit != OFF);
    found.sort_by(|a, b| a.first_frame.total_cmp(&b.first_frame));
    Ok(found)
}

/// The first own frame of each section that has some, with the section.
fn sections(timeline: &Timeline, sampler: &Sampler) -> Result<Vec<(usize, Section)>> {
    let mut sections = vec_with_room(timeline.section_count())?;
    let moving = timeline.moving();
    sections.extend(moving.map(|k| (sampler.first_frame(k), timeline.section(k))));
    Ok(sections)
}

/// The frames, in order, at which the camera stops or starts moving in a section without an ease:
/// beside a hold, and where it moves on one side only.
fn stops(path: &CameraPath, sections: &[(usize, Section)], frames: usize) -> Result<Vec<usize>> {
    let plain = |section: &Section| {
        let begin = &path.points[section.point].orientations[section.orientation];
        begin.own.pace == Pace::Speeds
    };
    let mut stops = vec_with_room(2 * (sections.len() + 1))?;
    for k in 0..=sections.len() {
        let before = k.checked_sub(1).map(|k| &sections[k]);
        let after = sections.get(k);
        let end = before.map_or(1, |(first, section)| first + section.frames - 1);
        let begin = after.map_or(frames, |(first, _)| first - 1);
        let sides = [before, after].map(|side| side.map(|(_, section)| section));
        if begin > end {
            let keys = sides.into_iter().zip([end, begin]);
            stops.extend(keys.filter_map(|(side, key)| side.is_some_and(plain).then_some(key)));
        } else if let [Some(before), Some(after)] = sides
            && (before.change == Change::Position) != (after.change == Change::Position)
            && plain(before)
            && plain(after)
        {
            stops.push(end);
        }
    }
    Ok(stops)
}

/// A pose, its quaternion with the sign that continues the one before.
#[derive(Clone, Copy)]
struct Frame {
    number: usize,
    pose: Pose,
    place: DVec3,
    turn: DQuat,
}

impl Frame {
    fn new(number: usize, pose: &Pose, before: Option<&Self>) -> Self {
        let turn = quaternion_from_view(pose.vpn.into(), pose.vup.into());
        Self {
            number,
            pose: *pose,
            place: pose.vrp.into(),
            turn: before.map_or(turn, |before| continue_sign(before.turn, turn).0),
        }
    }
}

struct Scan<'a> {
    path: &'a CameraPath,
    against: &'a CheckContext<'a>,
    sampler: &'a Sampler,
    sections: Vec<(usize, Section)>,
    stops: Vec<usize>,
    open: [Option<Finding>; COUNT],
    found: Vec<Finding>,
}

impl Scan<'_> {
    /// The section to which a frame belongs; a rest belongs to the one behind it.
    fn section_at(&self, frame: usize) -> Option<&Section> {
        let behind = |(first, section): &(usize, Section)| first + section.frames <= frame;
        let at = self.sections.partition_point(behind);
        let last = self.sections.len().checked_sub(1)?;
        Some(&self.sections[at.min(last)].1)
    }

    fn add(&mut self, finding: Finding) -> Result<()> {
        self.found.try_reserve(1)?;
        self.found.push(finding);
        Ok(())
    }

    fn close(&mut self, kind: FindingKind) -> Result<()> {
        let Some(mut finding) = self.open[kind as usize].take() else {
            return Ok(());
        };
        if kind == FindingKind::NothingToSee {
            let frames = finding.last_frame - finding.first_frame + 1.0;
            finding.value = frames / self.against.fps;
            if !beyond(finding.value, finding.limit) {
                return Ok(());
            }
        }
        self.add(finding)
    }

    /// Opens, extends or closes the finding of a kind; the greatest value counts if `worst` > 0.
    fn see(
        &mut self,
        kind: FindingKind,
        (from, to): (usize, usize),
        value: Option<f64>,
        worst: f64,
    ) -> Result<()> {
        let Some(value) = value else {
            return self.close(kind);
        };
        if let Some(open) = &mut self.open[kind as usize] {
            open.last_frame = to as f64;
            open.value = if worst > 0.0 {
                open.value.max(value)
            } else {
                open.value.min(value)
            };
            return Ok(());
        }
        let frames = [from as f64, to as f64];
        self.open[kind as usize] = Some(self.finding(kind, frames, self.section_at(to), value));
        Ok(())
    }

    fn finding(
        &self,
        kind: FindingKind,
        [first_frame, last_frame]: [f64; 2],
        section: Option<&Section>,
        value: f64,
    ) -> Finding {
        let (point, orientation) = section.map_or((0, 0), |s| (s.point, s.orientation));
        Finding {
            kind,
            first_frame,
            last_frame,
            point,
            orientation,
            value,
            limit: self.against.limits.get(kind),
        }
    }

    fn above(&mut self, kind: FindingKind, frames: (usize, usize), value: f64) -> Result<()> {
        let there = beyond(value, self.against.limits.get(kind));
        self.see(kind, frames, there.then_some(value), 1.0)
    }

    fn below(&mut self, kind: FindingKind, frames: (usize, usize), value: f64) -> Result<()> {
        let there = beyond(self.against.limits.get(kind), value);
        self.see(kind, frames, there.then_some(value), -1.0)
    }

    /// Whether a sudden stop or start at a frame is no finding: the section has no ease, and
    /// the limit of this kind is the default.
    fn may_stop(&self, kind: FindingKind, frame: usize) -> bool {
        self.against.limits.get(kind) == kind.limit().default
            && self.stops.binary_search(&frame).is_ok()
    }

    /// As [`Self::above`] for what three frames say about the middle one.
    fn acceleration(&mut self, kind: FindingKind, middle: usize, value: f64) -> Result<()> {
        let value = if self.may_stop(kind, middle) {
            0.0
        } else {
            value
        };
        self.above(kind, (middle - 1, middle + 1), value)
    }

    fn frame(&mut self, here: &Frame, before: [Option<Frame>; 3]) -> Result<()> {
        let (number, fps) = (here.number, self.against.fps);
        let size = self.path.space.half_size;
        let at = (number, number);
        if let Some(space) = self.against.space {
            let out = (here.place - space.max()).max(space.min() - here.place);
            self.above(FindingKind::Space, at, out.max_element() / size)?;
        }
        let begin = self.section_at(number).map(|section| {
            let point = &self.path.points[section.point];
            &point.orientations[section.orientation]
        });
        let upright = self.path.space.up;
        let level = begin.map_or(Some(upright), |begin| begin.own.up.level(upright));
        // Another up than an axis does not spin there.
        let pole = level.map_or(f64::INFINITY, |level| {
            let view = level.upright(here.pose.vpn.into());
            view.x.hypot(view.z).atan2(view.y.abs()).to_degrees()
        });
        let target = match begin.map(|begin| begin.target) {
            Some(Target::Absolute(target)) => (target - here.place).length() / size,
            _ => f64::INFINITY,
        };
        self.below(FindingKind::Pole, at, pole)?;
        self.below(FindingKind::Target, at, target)?;
        let last = before[2];
        if let Some(object) = self.against.object {
            self.beside(object, here, last.as_ref())?;
        }
        let Some(last) = last else {
            return Ok(());
        };
        let pair = (number - 1, number);
        let turned = 2.0 * angle(last.turn, here.turn);
        let jump = if turned > SUSPECT {
            self.jump(number)?.to_degrees()
        } else {
            0.0
        };
        let way = (here.place - last.place).length() / size;
        self.above(FindingKind::Speed, pair, way * fps)?;
        let seen = self.path.depth(begin.map(|begin| begin.target), last.place);
        let crossing = crossing(&last, here, seen) / fps;
        self.below(FindingKind::Crossing, pair, crossing)?;
        self.above(FindingKind::ViewJump, pair, jump)?;
        self.above(FindingKind::Turning, pair, turned.to_degrees() * fps)?;
        self.above(
            FindingKind::Zoom,
            pair,
            (here.pose.zoom - last.pose.zoom).abs() * fps,
        )?;
        let Some(first) = before[1] else {
            return Ok(());
        };
        let bend = here.place - 2.0 * last.place + first.place;
        self.acceleration(
            FindingKind::Acceleration,
            number - 1,
            bend.length() / size * fps * fps,
        )?;
        let rate = |a: &Frame, b: &Frame| 2.0 * log(b.turn * a.turn.conjugate());
        let change = (rate(&last, here) - rate(&first, &last)).length();
        self.acceleration(
            FindingKind::TurningAcceleration,
            number - 1,
            change.to_degrees() * fps * fps,
        )?;
        let Some(start) = before[0] else {
            return Ok(());
        };
        let third = bend - (last.place - 2.0 * first.place + start.place);
        self.above(
            FindingKind::Jerk,
            (number - 3, number),
            third.length() / size * fps.powi(3),
        )
    }

    /// How a frame and the way to it lie to the object.
    fn beside(&mut self, object: &Clearance, here: &Frame, last: Option<&Frame>) -> Result<()> {
        let (number, size) = (here.number, self.path.space.half_size);
        let (at, pair) = ((number, number), (number - 1, number));
        let crossed = last.is_some_and(|last| object.is_crossed(last.place, here.place));
        let least = self.against.limits.get(FindingKind::Clearance);
        let near = object.distance(here.place, size * least);
        let near = near.map(|near| near / size);
        let near = near.filter(|near| beyond(least, *near));
        if crossed && least > 0.0 {
            self.see(FindingKind::Clearance, pair, Some(0.0), -1.0)?;
        } else {
            self.see(FindingKind::Clearance, at, near, -1.0)?;
        }
        let seen = object.is_seen(&picture(&here.pose));
        self.see(FindingKind::NothingToSee, at, (!seen).then_some(0.0), 1.0)?;
        self.see(FindingKind::Through, pair, crossed.then_some(0.0), 1.0)
    }

    /// The turn left when the interval before a frame is halved often, to where it turns more.
    fn jump(&self, frame: usize) -> Result<f64> {
        let turn = |frame: f64| -> Result<DQuat> {
            let pose = self.sampler.pose(frame)?;
            Ok(quaternion_from_view(pose.vpn.into(), pose.vup.into()))
        };
        let apart = |a: DQuat, b: DQuat| 2.0 * angle(a, continue_sign(a, b).0);
        let (mut from, mut to) = (frame as f64 - 1.0, frame as f64);
        let (mut a, mut b) = (turn(from)?, turn(to)?);
        for _ in 0..30 {
            let middle = 0.5 * (from + to);
            let m = turn(middle)?;
            if apart(a, m) > apart(m, b) {
                (to, b) = (middle, m);
            } else {
                (from, a) = (middle, m);
            }
            if apart(a, b) < SUSPECT / 16.0 {
                return Ok(0.0);
            }
        }
        Ok(apart(a, b))
    }

    fn section(&mut self, timeline: &Timeline, number: usize) -> Result<()> {
        let section = timeline.section(number);
        let first = self.sampler.first_frame(number);
        let limits = &self.against.limits;
        let begin = (first as f64 - 1.0).max(1.0);
        let end = begin + section.frames as f64;
        if section.change == Change::Nothing {
            let frames = [first as f64; 2];
            return self.add(self.finding(FindingKind::Redundant, frames, Some(&section), 0.0));
        }
        if let Some(short) = half_turn(self.path, timeline, number)
            && !beyond(short, limits.get(FindingKind::HalfTurn))
        {
            let frames = [begin, end];
            self.add(self.finding(FindingKind::HalfTurn, frames, Some(&section), short))?;
        }
        let timing = timeline.timing(self.path, number)?;
        let mut least = (limits.get(FindingKind::Cusp), None);
        // The pace, and where there is a way its tangent, away from the ends.
        let places = |k: i32| 0.05 + 0.9 * f64::from(k) / 256.0;
        for u in (0..=256).map(places) {
            let speed = timing.speed(u) / BASE_SPEED;
            // A section all at the least speed is slow, but has no cusp.
            if speed < least.0.min(0.5 * MIN_SPEED / BASE_SPEED) {
                least = (speed, Some(u));
            }
        }
        if section.change == Change::Position {
            let curve = timeline.curve(section.point);
            let arc = ArcLength::new(curve)?;
            let (back, t) = way_back(self.path, section.point, curve);
            let back = back / self.path.space.half_size;
            if beyond(back, limits.get(FindingKind::Backwards)) {
                let frame = begin
                    + time_of(&timing, arc.length_at(t) / arc.length()) * section.frames as f64;
                let finding =
                    self.finding(FindingKind::Backwards, [frame; 2], Some(&section), back);
                self.add(finding)?;
            }
            for t in (0..=256).map(places) {
                let share = curve.derivative(t).length() / arc.length();
                if share < least.0 {
                    least = (
                        share,
                        Some(time_of(&timing, arc.length_at(t) / arc.length())),
                    );
                }
            }
        }
        if let (value, Some(u)) = least {
            let frame = begin + u * section.frames as f64;
            self.add(self.finding(FindingKind::Cusp, [frame; 2], Some(&section), value))?;
        }
        Ok(())
    }

    /// Points without which the poses would be the same.
    fn redundant(&mut self, timeline: &Timeline, watch: &Watch<'_>) -> Result<()> {
        let most = self.against.limits.get(FindingKind::Redundant);
        if most == OFF || most == 0.0 {
            return Ok(());
        }
        for point in 1..self.path.points.len() {
            watch.check()?;
            let Some(without) = without(self.path, point, most)? else {
                continue;
            };
            let Some(number) = timeline.section_from(point, 0) else {
                continue;
            };
            let section = timeline.section(number);
            if section.change != Change::Nothing {
                let frames = [(self.sampler.first_frame(number) - 1) as f64; 2];
                let value = without.change;
                self.add(self.finding(FindingKind::Redundant, frames, Some(&section), value))?;
            }
        }
        Ok(())
    }

    /// Keys at which two sections meet: speeds and directions.
    fn joins(&mut self, timeline: &Timeline) -> Result<()> {
        let frames = self.sampler.frame_count();
        if frames < 3 {
            return Ok(());
        }
        let mean = timeline.length() / (frames - 1) as f64;
        let pairs = self.sections.len().saturating_sub(1);
        for k in 0..pairs {
            let ((first, before), (next, after)) = (self.sections[k], self.sections[k + 1]);
            let keys = [first + before.frames - 1, next - 1];
            let [end, begin] = keys.map(|key| key as f64);
            let place = |frame: f64| -> Result<DVec3> { Ok(self.sampler.pose(frame)?.vrp.into()) };
            let reach = (place(end)? - place(end - BESIDE)?) / BESIDE;
            let leave = (place(begin + BESIDE)? - place(begin)?) / BESIDE;
            let rests = begin > end;
            let (a, b) = (reach.length(), leave.length());
            let seen = |speed: f64, key: usize| {
                let may = self.may_stop(FindingKind::SpeedJump, key);
                if may { 0.0 } else { speed }
            };
            let (stops, starts) = (seen(a, keys[0]), seen(b, keys[1]));
            let change = if rests {
                stops.max(starts)
            } else {
                (stops - starts).abs()
            };
            let jump = change / mean.max(f64::MIN_POSITIVE);
            let turned = reach.angle_between(leave).to_degrees();
            let corner = if a.min(b) > 1e-3 * mean { turned } else { 0.0 };
            for (kind, value) in [
                (FindingKind::SpeedJump, jump),
                (FindingKind::Corner, corner),
            ] {
                if beyond(value, self.against.limits.get(kind)) {
                    self.add(self.finding(kind, [end, begin], Some(&after), value))?;
                }
            }
        }
        Ok(())
    }
}

/// How far the curve of a segment goes back against its chord, and the parameter at which it has;
/// nothing where the points around it turn back themselves.
fn way_back(path: &CameraPath, segment: usize, curve: &Cubic) -> (f64, f64) {
    let count = path.points.len();
    let chord = |k: usize| path.points[(k + 1) % count].position - path.points[k % count].position;
    let own = chord(segment);
    let beside = match (path.closed, segment) {
        (true, k) => [Some(chord(k + count - 1)), Some(chord(k + 1))],
        (false, k) => [
            k.checked_sub(1).map(chord),
            (k + 2 < count).then(|| chord(k + 1)),
        ],
    };
    let on = beside.iter().flatten().all(|chord| chord.dot(own) > 0.0);
    let (mut most, mut found) = (0.0_f64, (0.0, 0.0));
    for t in (0..=256).map(|k| f64::from(k) / 256.0) {
        let along = (curve.point(t) - path.points[segment].position).dot(own.normalize_or_zero());
        most = most.max(along);
        if on && most - along > found.0 {
            found = (most - along, t);
        }
    }
    found
}

/// The share of the time at which such a share of the way is gone.
fn time_of(timing: &crate::path::Timing, way: f64) -> f64 {
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..50 {
        let middle = 0.5 * (low + high);
        if timing.fraction(middle) < way {
            low = middle;
        } else {
            high = middle;
        }
    }
    low
}

/// How many frames something in the middle of the picture at a depth would need to cross it.
fn crossing(last: &Frame, here: &Frame, depth: f64) -> f64 {
    let thing = last.place + depth * last.pose.view();
    let seen = (thing - here.place).reject_from_normalized(here.pose.view());
    let width = 36.0 / here.pose.zoom * depth;
    width / seen.length()
}

/// The sides of a picture of 36 × 24 mm, and the plane of the camera.
fn picture(pose: &Pose) -> [(DVec3, f64); 5] {
    let [eye, view, up] = [pose.vrp, pose.vpn, pose.vup].map(DVec3::from_array);
    let right = view.cross(up);
    let side = |normal: DVec3| (normal, normal.dot(eye));
    let (wide, high) = (18.0 / pose.zoom, 12.0 / pose.zoom);
    [
        side(wide * view + right),
        side(wide * view - right),
        side(high * view + up),
        side(high * view - up),
        side(view),
    ]
}

#[cfg(test)]
#[path = "check_tests.rs"]
mod tests;
