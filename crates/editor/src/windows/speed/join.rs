//! Preset paces that join the neighbouring sections: a section ends as fast as the next goes on. No
//! egui here.

use vides_document::{Document, Selection};
use vides_engine::limits::{MAX_SPEED, MIN_SPEED, SPEEDS};
use vides_engine::path::joint;
use vides_engine::path::speed_curve::CurveEnd;
use vides_engine::path::{CameraPath, Change, Orientation, Pace, Timeline, Timing};

use super::shapes::{End, Shape};

/// Speeds and frames depend on each other: rounds until they agree to the last digit shown.
const ROUNDS: usize = 12;
const ENOUGH: f64 = 0.06;

/// As far as the rounding of frames moves a speed, it is that of the neighbour's square.
const ROUNDING: f64 = 0.05;

/// A section as it would be with other speeds around it.
#[derive(Clone, Copy)]
struct Beside<'a> {
    this: joint::Neighbour<'a>,
    around: [Option<joint::Neighbour<'a>>; 2],
}

impl<'a> Beside<'a> {
    fn new(path: &'a CameraPath, timeline: &Timeline, number: usize) -> Self {
        Self {
            this: timeline.neighbour(path, number),
            around: timeline.neighbours(path, number),
        }
    }

    /// Its pace, and how much faster it is than its speeds say since its frames are whole or fixed.
    fn timing(&self) -> Option<(Timing, f64)> {
        let [before, after] = self.around;
        let timing = self.this.timing(before, after).ok()?;
        let frames = self.this.work / timing.mean();
        let whole = match self.this.orientation.own.frames {
            0 => frames.round().max(1.0),
            fixed => f64::from(fixed),
        };
        Some((timing, frames / whole))
    }
}

/// What lies beyond an end of a section.
enum Neighbour<'a> {
    /// The end of the path.
    None,
    /// The camera rests, or turns in one place.
    Still,
    /// The camera passes slowly, at a speed that is not of this section's rounding.
    Slow(f64),
    Goes(Beside<'a>),
}

/// The sections that move before and after one.
fn neighbours(timeline: &Timeline, number: usize, closed: bool) -> [Option<usize>; 2] {
    let moves = |&at: &usize| timeline.section(at).change != Change::Nothing;
    let all = if closed { timeline.section_count() } else { 0 };
    [
        (0..number).rev().chain((number + 1..all).rev()).find(moves),
        (number + 1..timeline.section_count())
            .chain(0..number.min(all))
            .find(moves),
    ]
}

/// The neighbours of a section.
fn beside<'a>(path: &'a CameraPath, timeline: &Timeline, number: usize) -> [Neighbour<'a>; 2] {
    let change = timeline.section(number).change;
    let [before, after] = neighbours(timeline, number, path.closed);
    // The camera rests where a section begins.
    let rests = |begin: usize| {
        let section = timeline.section(begin);
        path.points[section.point].orientations[section.orientation].hold > 0
    };
    let of = |other: Option<usize>, begin: Option<usize>| match other {
        None => Neighbour::None,
        Some(_) if begin.is_some_and(rests) => Neighbour::Still,
        // A turn goes on in a flight, a flight not in a turn.
        Some(other)
            if change == Change::Position && timeline.section(other).change != Change::Position =>
        {
            Neighbour::Still
        }
        Some(other) => Neighbour::Goes(Beside::new(path, timeline, other)),
    };
    [of(before, Some(number)), of(after, after)]
}

/// Ten speeds of this shape for the section that begins with an orientation; without a section, as
/// if it stood alone.
pub(super) fn ready(document: &Document, at: Selection, shape: Shape) -> Option<[f64; SPEEDS]> {
    let path = document.path();
    let key = path
        .points
        .get(at.point)?
        .orientations
        .get(at.orientation)?;
    let made = document.timeline(|timeline| {
        let number = timeline.section_from(at.point, at.orientation)?;
        let this = Beside::new(path, timeline, number);
        joined(this, beside(path, timeline, number), shape)
    });
    match made {
        Ok(Some(speeds)) => Some(speeds),
        Ok(None) => {
            let alone = Timing::new(key, [CurveEnd::Free; 2]).ok()?;
            Some(shape.speeds([End::Free; 2], alone.mean(), true))
        }
        Err(_) => None,
    }
}

/// How fast the camera passes a key where it slows down, in shares of the slower neighbouring mean.
const SLOW: f64 = 0.25;

/// Two sections, each by the view with which it begins, and their ten speeds.
pub(crate) type Two = [(Selection, [f64; SPEEDS]); 2];

/// Ten speeds for the sections before and behind a key, with which the camera slows down to it and
/// goes on from it, as fast on both sides; `None` where it begins, ends, rests or turns in one place.
pub(crate) fn slow_past(document: &Document, at: Selection) -> Option<Two> {
    let path = document.path();
    let made = document.timeline(|timeline| {
        let after = timeline.section_from(at.point, at.orientation)?;
        let [Neighbour::Goes(_), _] = beside(path, timeline, after) else {
            return None;
        };
        let before = neighbours(timeline, after, path.closed)[0]?;
        let both = [before, after];
        let [flies, goes_on] = both.map(|at| timeline.section(at).change == Change::Position);
        if flies != goes_on {
            return None;
        }
        let [one, other] = both.map(|number| {
            let this = Beside::new(path, timeline, number);
            let (timing, faster) = this.timing()?;
            Some(SLOW * timing.mean() * faster)
        });
        let slow = one?.min(other?);
        let speeds = |number: usize, side: usize, shape| {
            let mut ends = beside(path, timeline, number);
            ends[side] = Neighbour::Slow(slow);
            joined(Beside::new(path, timeline, number), ends, shape)
        };
        let section = timeline.section(before);
        let from = Selection::at(section.point, section.orientation);
        Some([
            (from, speeds(before, 1, Shape::EaseOut)?),
            (at, speeds(after, 0, Shape::EaseIn)?),
        ])
    });
    made.ok().flatten()
}

fn joined(this: Beside<'_>, beside: [Neighbour<'_>; 2], shape: Shape) -> Option<[f64; SPEEDS]> {
    let begins = this.this.orientation;
    let fixed = begins.own.frames > 0;
    let mut new = Orientation {
        own: begins.own.with(|own| own.pace = Pace::Speeds).ok()?,
        ..begins.clone()
    };
    let old = this.timing()?.0.mean();
    let mut best: Option<(f64, [f64; SPEEDS])> = None;
    for round in 0..ROUNDS {
        let now = Beside {
            this: joint::Neighbour {
                orientation: &new,
                ..this.this
            },
            ..this
        };
        let scale = now.timing()?.1;
        let mut ends = [End::Free; 2];
        let mut off: f64 = 0.0;
        for (side, neighbour) in beside.iter().enumerate() {
            ends[side] = match neighbour {
                Neighbour::None => End::Free,
                Neighbour::Still => End::Still,
                Neighbour::Slow(speed) => End::Slow(*speed / scale),
                Neighbour::Goes(other) => {
                    let here = new.speeds[side * (SPEEDS - 1)];
                    let mut other = *other;
                    other.around[1 - side] = Some(now.this);
                    let (course, faster) = other.timing()?;
                    let nominal = course.speed(1.0 - side as f64);
                    let real = nominal * faster / scale;
                    let near = (real - nominal).abs() < ROUNDING * nominal;
                    let speed = if near { nominal } else { real }.clamp(MIN_SPEED, MAX_SPEED);
                    off = off.max((speed - here).abs());
                    End::Goes(speed)
                }
            };
        }
        if round > 0 && best.is_none_or(|(least, _)| off < least) {
            best = Some((off, new.speeds));
        }
        if round > 0 && off < ENOUGH {
            break;
        }
        new.speeds = shape.speeds(ends, old, fixed);
    }
    best.map(|(_, speeds)| speeds)
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;
    use vides_document::{Edit, Info};
    use vides_engine::path::{SupportPoint, Target};
    use vides_engine::tools::check::FindingKind;

    /// Random numbers in [0, 1): xorshift64*.
    struct Random(u64);

    impl Random {
        fn unit(&mut self) -> f64 {
            self.0 ^= self.0 >> 12;
            self.0 ^= self.0 << 25;
            self.0 ^= self.0 >> 27;
            (self.0.wrapping_mul(0x2545_F491_4F6C_DD1D) >> 11) as f64 / (1u64 << 53) as f64
        }

        fn vector(&mut self) -> DVec3 {
            DVec3::from_array(std::array::from_fn(|_| 2.0 * self.unit() - 1.0))
        }
    }

    /// From here on a check reports a jump.
    const LIMIT: f64 = 0.5;

    /// Flights with turns in one place and rests; with `fixed` frames, too.
    fn random_path(random: &mut Random, closed: bool, fixed: bool) -> Document {
        let count = 3 + (random.unit() * 4.0) as usize;
        let points = (0..count).map(|_| {
            let turns = if random.unit() < 0.2 { 2 } else { 1 };
            let keys = (0..turns).map(|_| {
                let speed = 35.0 + 30.0 * random.unit();
                let frames = if fixed {
                    20 + (random.unit() * 60.0) as u32
                } else {
                    0
                };
                Orientation {
                    target: Target::Relative(random.vector()),
                    speeds: std::array::from_fn(|_| speed + 4.0 * random.unit()),
                    hold: if random.unit() < 0.2 { 5 } else { 0 },
                    own: Orientation::default()
                        .own
                        .with(|own| own.frames = frames)
                        .unwrap(),
                    ..Orientation::default()
                }
            });
            SupportPoint {
                orientations: keys.collect(),
                ..SupportPoint::new(random.vector())
            }
        });
        let path = CameraPath {
            points: points.collect(),
            closed,
            ..CameraPath::default()
        };
        let mut info = Info::default();
        info.limits.set(FindingKind::SpeedJump, 0.0).unwrap();
        Document::from_parts(path, info).unwrap()
    }

    /// The jumps of the speed at all keys, in shares of the mean speed.
    fn jumps(document: &Document) -> Vec<((usize, usize), f64)> {
        let found = document.check(None).unwrap();
        let jumps = found
            .iter()
            .filter(|found| found.kind == FindingKind::SpeedJump);
        let jumps = jumps.map(|found| ((found.point, found.orientation), found.value));
        jumps.collect()
    }

    fn frames(document: &Document) -> f64 {
        document.sampler().unwrap().frame_count() as f64 - 1.0
    }

    /// The keys at which a section begins and ends.
    fn ends_of(document: &Document, at: Selection) -> [(usize, usize); 2] {
        let path = document.path();
        let here = (at.point, at.orientation);
        let next = if at.orientation + 1 < path.points[at.point].orientations.len() {
            (at.point, at.orientation + 1)
        } else {
            ((at.point + 1) % path.points.len(), 0)
        };
        [here, next]
    }

    #[test]
    fn a_ready_pace_makes_no_jump_that_was_not_there() {
        let mut random = Random(13);
        let mut made = 0;
        for round in 0..400 {
            let document = random_path(&mut random, round % 3 == 0, round % 4 == 0);
            let before = jumps(&document);
            let was = |key: &(usize, usize)| {
                let found = before.iter().find(|(other, _)| other == key);
                found.map_or(0.0, |found| found.1)
            };
            for (point, here) in document.path().points.iter().enumerate() {
                for (orientation, key) in here.orientations.iter().enumerate() {
                    for shape in [Shape::EaseIn, Shape::EaseOut, Shape::Both] {
                        let at = Selection::at(point, orientation);
                        let speeds = ready(&document, at, shape).unwrap();
                        let mut changed = document.try_clone().unwrap();
                        let orientation = Orientation {
                            speeds,
                            ..key.clone()
                        };
                        let edit = Edit::SetOrientation {
                            point,
                            at: at.orientation,
                            orientation,
                        };
                        changed.apply(edit).unwrap();
                        made += 1;
                        // Elsewhere the mean speed is another, and frames beside it are rounded.
                        let slower = frames(&document) / frames(&changed);
                        let ends = ends_of(&document, at);
                        for (jump, share) in jumps(&changed) {
                            let old = was(&jump);
                            let new = share > LIMIT && old <= LIMIT;
                            let rounded = share * slower < old + 0.1;
                            assert!(
                                !new || !ends.contains(&jump) && rounded,
                                "{round}: {shape:?} at {at:?} jumps at {jump:?} by {share}, not {old}: {speeds:?}"
                            );
                        }
                    }
                }
            }
        }
        assert!(made > 5000, "{made}");
    }

    /// By differences of poses a tenth of a frame apart: at the key the camera has a quarter of the
    /// slower neighbouring mean, from both sides, and is slower nowhere near.
    #[test]
    fn slowing_down_at_a_key_has_no_jerk() {
        let mut random = Random(29);
        let (mut made, mut refused) = (0, 0);
        for round in 0..120 {
            let document = random_path(&mut random, round % 3 == 0, round % 4 == 0);
            let path = document.path();
            for point in 0..path.points.len() {
                let at = Selection::at(point, 0);
                let Some(two) = slow_past(&document, at) else {
                    refused += 1;
                    continue;
                };
                let mut changed = document.try_clone().unwrap();
                for (of, speeds) in two {
                    let view = &path.points[of.point].orientations[of.orientation];
                    let edit = Edit::SetOrientation {
                        point: of.point,
                        at: of.orientation,
                        orientation: Orientation {
                            speeds,
                            ..view.clone()
                        },
                    };
                    changed.apply(edit).unwrap();
                }
                made += 1;
                // Where both sections begin, and how long each is.
                let spans = |document: &Document| {
                    let sampler = document.sampler().unwrap();
                    let of = |timeline: &Timeline, of: Selection| {
                        let at = timeline.section_from(of.point, of.orientation).unwrap();
                        let first = sampler.first_frame(at) as f64 - 1.0;
                        (first, timeline.section(at).frames as f64)
                    };
                    let spans = document.timeline(|timeline| two.map(|(at, _)| of(timeline, at)));
                    spans.unwrap()
                };
                let place = |document: &Document, frame: f64| {
                    DVec3::from(document.sampler().unwrap().pose(frame).unwrap().vrp)
                };
                let speed = |document: &Document, from: f64, to: f64| {
                    place(document, from).distance(place(document, to)) / (to - from)
                };
                let [(_, before), (key, after)] = spans(&changed);
                let means = spans(&document).map(|(first, frames)| {
                    let parts = (0..200).map(|part| {
                        let frame = |part: i32| first + frames * f64::from(part) / 200.0;
                        speed(&document, frame(part), frame(part + 1)) / 200.0
                    });
                    parts.sum::<f64>()
                });
                // A closed path ends where it begins.
                let arrival = if key < 1.5 {
                    frames(&changed) + 1.0
                } else {
                    key
                };
                let ends = [
                    speed(&changed, arrival - 0.1, arrival),
                    speed(&changed, key, key + 0.1),
                ];
                let slow = 0.25 * means[0].min(means[1]);
                let turns = means[0].max(means[1]) < 1e-9;
                let near = |speed: f64| turns || (speed / slow - 1.0).abs() < 0.08;
                assert!(
                    ends.into_iter().all(near),
                    "{round} {point}: {ends:?}, not {slow}"
                );
                let within = (1..before as i32).map(|step| arrival - f64::from(step) / 2.0);
                let behind = (1..after as i32).map(|step| key + f64::from(step) / 2.0);
                for frame in within.chain(behind) {
                    let there = speed(&changed, frame - 0.05, frame + 0.05);
                    assert!(
                        there > 0.75 * slow,
                        "{round} {point}: {there} at {frame}, not {slow}"
                    );
                }
            }
        }
        assert!(made > 200 && refused > 100, "{made} {refused}");
    }
}
