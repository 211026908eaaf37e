//! What will look wrong in a film. Lengths count in half sizes of the space.
//!
//! Between frames a view that jumps is found by halving the interval, a cusp by the least tangent
//! of the curve, a jump of the speed by differences on both sides of a key.

use glam::{DQuat, DVec3};

use super::clearance::Clearance;
use super::parameter::{Parameter, Unit};
use crate::deform::Bounds;
use crate::error::{Invalid, Result, vec_with_room};
use crate::limits::{BASE_SPEED, MAX_COORDINATE, MIN_SPEED};
use crate::math::orientation::quaternion_from_view;
use crate::math::quaternion::{angle, continue_sign, log};
use crate::path::arc_length::ArcLength;
use crate::path::{
    Ambiguity, CameraPath, Change, Pose, Sampler, Section, Target, Timeline, ambiguity,
};

/// A kind of fault that is looked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FindingKind {
    /// The camera is outside the space.
    Space,
    /// The curve or the pace nearly stops within a section.
    Cusp,
    /// The speed jumps at a key.
    SpeedJump,
    /// The camera accelerates too much.
    Acceleration,
    /// The view jumps.
    ViewJump,
    /// The view turns too fast.
    Turning,
    /// The turning accelerates too much.
    TurningAcceleration,
    /// A half turn might go either way.
    HalfTurn,
    /// The view is nearly straight up or down.
    Pole,
    /// The target is too near.
    Target,
    /// The object is too near.
    Clearance,
    /// The way leads through the object.
    Through,
    /// Nothing of the object is in the picture.
    NothingToSee,
    /// The zoom is too fast.
    Zoom,
    /// Several keys stand where one would do.
    Redundant,
    /// The way turns too much at a point.
    Corner,
}

/// Number of kinds.
pub const COUNT: usize = 16;

/// A kind, the limit beyond which it is reported, under the kind's name, and what helps.
type Row = (FindingKind, Parameter, &'static str);

const fn row(
    kind: FindingKind,
    [name, does]: [&'static str; 2],
    unit: Unit,
    most: f64,
    default: f64,
    remedy: &'static str,
) -> Row {
    let limit = Parameter {
        name,
        does,
        unit,
        width: 1,
        least: 0.0,
        most,
        default,
    };
    (kind, limit, remedy)
}

/// All that is looked for, in the order of the kinds.
#[rustfmt::skip]
static ROWS: [Row; COUNT] = [
    row(FindingKind::Space, ["space", "the camera is so far outside the space"], Unit::Length,
        MAX_COORDINATE, 0.0, "move or scale the points: vides transform"),
    row(FindingKind::Cusp, ["cusp",
        "the curve or the pace nearly stops within a section, to such a share of its mean"],
        Unit::One, 1.0, 0.02, "draw the points apart or give them tangents"),
    row(FindingKind::SpeedJump, ["speed-jump",
        "the speed jumps at a key by such a share of the mean speed"], Unit::One, 1000.0, 0.5,
        "ease the section"),
    row(FindingKind::Acceleration, ["acceleration",
        "the camera accelerates more, in half sizes a second squared"], Unit::One, MAX_COORDINATE,
        10.0, "ease the section or give it more frames"),
    row(FindingKind::ViewJump, ["view-jump", "the view jumps by so much"], Unit::Degrees, 180.0,
        1.0, "look ahead by a distance, or round off the corner"),
    row(FindingKind::Turning, ["turning", "the view turns faster, in degrees a second"],
        Unit::Degrees, 1e6, 60.0, "give the section more frames"),
    row(FindingKind::TurningAcceleration, ["turning-acceleration",
        "the turning accelerates more, in degrees a second squared"], Unit::Degrees, 1e9, 300.0,
        "ease the section"),
    row(FindingKind::HalfTurn, ["half-turn", "a half turn might go either way"], Unit::One, 1.0,
        0.0, "put a view between the two"),
    row(FindingKind::Pole, ["pole", "the view is so near to straight up or down"], Unit::Degrees,
        90.0, 3.0, "lead the way aside"),
    row(FindingKind::Target, ["target", "the target is nearer"], Unit::Length, MAX_COORDINATE,
        0.05, "lead the way aside"),
    row(FindingKind::Clearance, ["clearance", "the object is nearer"], Unit::Length,
        MAX_COORDINATE, 0.02, "lead the way aside"),
    row(FindingKind::Through, ["through", "the way leads through the object"], Unit::One, 1.0, 0.0,
        "lead the way aside"),
    row(FindingKind::NothingToSee, ["nothing-to-see",
        "nothing of the object is in the picture for longer"], Unit::Seconds, 1e6, 1.0,
        "turn the views towards the object"),
    row(FindingKind::Zoom, ["zoom", "the zoom is faster, in mm a second"], Unit::Zoom, 1e6, 30.0,
        "give the section more frames"),
    row(FindingKind::Redundant, ["redundant", "several keys stand where one would do"], Unit::One,
        1.0, 0.0, "remove the orientation or the point"),
    row(FindingKind::Corner, ["corner", "the way turns at a point by more"], Unit::Degrees, 180.0,
        60.0, "give the point tangents"),
];

impl FindingKind {
    /// All of them.
    pub fn all() -> impl Iterator<Item = Self> + Clone {
        ROWS.iter().map(|row| row.0)
    }

    /// The limit beyond which it is reported; its name is that of the kind.
    #[must_use]
    pub const fn limit(self) -> &'static Parameter {
        &ROWS[self as usize].1
    }

    /// Its name: small letters, words joined by `-`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        self.limit().name
    }

    /// What helps.
    #[must_use]
    pub const fn remedy(self) -> &'static str {
        ROWS[self as usize].2
    }

    /// The kind of this name.
    ///
    /// # Errors
    /// [`crate::Error::Argument`] if there is none.
    pub fn parse(name: &str) -> Result<Self> {
        let found = Self::all().find(|kind| kind.name() == name);
        found.ok_or_else(|| Invalid::NoCheck(name.into()).into())
    }
}

/// The limits of all kinds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limits([f64; COUNT]);

impl Default for Limits {
    fn default() -> Self {
        Self(ROWS.map(|row| row.1.default))
    }
}

impl Limits {
    /// The limit of a kind.
    #[must_use]
    pub const fn get(&self, kind: FindingKind) -> f64 {
        self.0[kind as usize]
    }

    /// Sets a limit.
    ///
    /// # Errors
    /// [`crate::Error::Argument`] or [`crate::Error::Range`]; nothing is changed then.
    pub fn set(&mut self, kind: FindingKind, limit: f64) -> Result<()> {
        kind.limit().check(limit, 1.0)?;
        self.0[kind as usize] = limit;
        Ok(())
    }

    /// Those that differ from the defaults.
    pub fn changed(&self) -> impl Iterator<Item = (FindingKind, f64)> {
        FindingKind::all()
            .zip(self.0)
            .filter(|(kind, limit)| kind.limit().default.to_bits() != limit.to_bits())
    }
}

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

/// What a path is checked against.
#[derive(Debug, Clone, Copy)]
pub struct Against<'a> {
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
pub fn check(path: &CameraPath, against: &Against<'_>) -> Result<Vec<Finding>> {
    let timeline = Timeline::new(path)?;
    let sampler = Sampler::new(path, &timeline)?;
    let mut scan = Scan {
        path,
        against,
        sampler: &sampler,
        sections: sections(&timeline, &sampler)?,
        open: [None; COUNT],
        found: Vec::new(),
    };
    for section in 0..timeline.section_count() {
        scan.section(&timeline, section)?;
    }
    scan.joins(&timeline)?;
    let frames = sampler.frame_count();
    let mut poses = vec_with_room(BLOCK)?;
    let mut before = [None; 2];
    let mut done = 0;
    while done < frames {
        let count = BLOCK.min(frames - done);
        poses.resize(count, Pose::default());
        sampler.sample(done + 1, &mut poses)?;
        for pose in &poses {
            done += 1;
            let here = Frame::new(done, pose, before[1].as_ref());
            scan.frame(&here, before)?;
            before = [before[1], Some(here)];
        }
    }
    for kind in FindingKind::all() {
        scan.close(kind)?;
    }
    let mut found = scan.found;
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
    against: &'a Against<'a>,
    sampler: &'a Sampler,
    sections: Vec<(usize, Section)>,
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

    fn frame(&mut self, here: &Frame, before: [Option<Frame>; 2]) -> Result<()> {
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
        if let Some(object) = self.against.object {
            let least = self.against.limits.get(FindingKind::Clearance);
            let near = object.distance(here.place, size * least);
            let near = near.map(|near| near / size);
            let near = near.filter(|near| beyond(least, *near));
            self.see(FindingKind::Clearance, at, near, -1.0)?;
            let seen = object.is_seen(&picture(&here.pose));
            self.see(FindingKind::NothingToSee, at, (!seen).then_some(0.0), 1.0)?;
        }
        let Some(last) = before[1] else {
            return Ok(());
        };
        let pair = (number - 1, number);
        if let Some(object) = self.against.object {
            let crossed = object.is_crossed(last.place, here.place);
            self.see(FindingKind::Through, pair, crossed.then_some(0.0), 1.0)?;
        }
        let turned = 2.0 * angle(last.turn, here.turn);
        let jump = if turned > SUSPECT {
            self.jump(number)?.to_degrees()
        } else {
            0.0
        };
        self.above(FindingKind::ViewJump, pair, jump)?;
        self.above(FindingKind::Turning, pair, turned.to_degrees() * fps)?;
        self.above(
            FindingKind::Zoom,
            pair,
            (here.pose.zoom - last.pose.zoom).abs() * fps,
        )?;
        let Some(first) = before[0] else {
            return Ok(());
        };
        let three = (number - 2, number);
        let bend = here.place - 2.0 * last.place + first.place;
        self.above(
            FindingKind::Acceleration,
            three,
            bend.length() / size * fps * fps,
        )?;
        let rate = |a: &Frame, b: &Frame| 2.0 * log(b.turn * a.turn.conjugate());
        let change = (rate(&last, here) - rate(&first, &last)).length();
        self.above(
            FindingKind::TurningAcceleration,
            three,
            change.to_degrees() * fps * fps,
        )
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
            return self.add(self.finding(FindingKind::Redundant, frames, Some(&section), 1.0));
        }
        if ambiguity(self.path, timeline, number) == Some(Ambiguity::HalfTurn) {
            let frames = [begin, end];
            self.add(self.finding(FindingKind::HalfTurn, frames, Some(&section), 180.0))?;
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
            let (end, begin) = ((first + before.frames - 1) as f64, next as f64 - 1.0);
            let place = |frame: f64| -> Result<DVec3> { Ok(self.sampler.pose(frame)?.vrp.into()) };
            let reach = (place(end)? - place(end - BESIDE)?) / BESIDE;
            let leave = (place(begin + BESIDE)? - place(begin)?) / BESIDE;
            let rests = begin > end;
            let (a, b) = (reach.length(), leave.length());
            let change = if rests { a.max(b) } else { (a - b).abs() };
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
