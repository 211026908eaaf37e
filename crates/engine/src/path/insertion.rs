//! A new point on the curve that leaves the motion as it is.
//!
//! The segment is split (de Casteljau) and the pace of its section divided. What the new point
//! would change elsewhere its neighbours then own: tangents, angular velocities, slopes. Which
//! these are is found by comparing the path before with the path after.
//!
//! A part of a spherical Bézier curve is not such a curve itself (views would be off by up to some
//! degrees), so the halves of a turning remember the whole, as long as their keys stay.

use glam::{DQuat, DVec3};

use super::ahead::Look;
use super::alignment;
use super::arc_length::ArcLength;
use super::camera_path::{CameraPath, Orientation, OrientationMode, SupportPoint, Target, Tcb};
use super::curve;
use super::orientation_curve::{Rates, rates};
use super::own::{Pace, PacePart, PaceSource, Tangents, TurningPart, Velocities};
use super::sampling::{Layout, Sampler, zoom_slopes};
use super::section_sampler::SectionSampler;
use super::speed_curve::{CurveEnd, end_slopes};
use super::timeline::Timeline;
use super::timing::Timing;
use super::turning::Turning;
use super::up_vector::UpVector;
use crate::error::{Error, Invalid, OutOfRange, Result, vec_with_room};
use crate::limits::{MAX_SPEED, MAX_ZOOM, MIN_SPEED, MIN_ZOOM, SPEEDS};
use crate::math::{orientation, quaternion};

/// A path with one point more.
#[derive(Debug)]
pub struct Insertion {
    /// The number of the new point.
    pub at: usize,
    /// The whole path with it.
    pub path: CameraPath,
    /// Numbers of the other points that have changed.
    pub changed: Vec<usize>,
}

/// Points to either side whose tangents may change: beyond, a cubic spline is the same to the bit.
const NEIGHBOURS: usize = 40;

/// A difference that need not be owned, as a share of what it belongs to.
const SAME: f64 = 1e-14;

/// Rounds of comparing: what one neighbour owns may change the next.
const ROUNDS: usize = 6;

/// Step, in shares of a section, of the differences that give the angular velocity.
const DIFFERENCE: f64 = 1.0 / 512.0;

/// Puts a point on the curve where the camera is at a frame: at the nearest whole frame inside the
/// section, so that no pose changes; in a section of one frame, where it is asked for.
///
/// # Errors
/// [`Error::Range`] where there is no such frame or no way to divide there, [`Error::Argument`] in
/// the mode Barry–Goldman, [`Error::Limit`], [`Error::Memory`].
pub fn on_curve(path: &CameraPath, frame: f64) -> Result<Insertion> {
    if path.orientation_mode == OrientationMode::BarryGoldman {
        return Err(Invalid::NoNewKey.into());
    }
    let timeline = Timeline::new(path)?;
    let sampler = Sampler::new(path, &timeline)?;
    let (index, u) = find(path, &timeline, &sampler, frame)?;
    let sampled = &sampler.sections()[index];
    let section = sampled.section;
    let begin = timeline.section(section);
    let at = begin.point + 1;
    let mut new = path.try_clone()?;
    new.points.try_reserve(1)?;
    let (point, wanted) = divide(path, &timeline, section, sampled, u)?;
    new.points.insert(at, point);
    let here = &mut new.points[begin.point].orientations[begin.orientation];
    let timing = timeline.timing(path, section)?;
    let old = &path.points[begin.point].orientations[begin.orientation];
    let whole = (timeline.curve_ends(path, section)?, old);
    take_part(here, whole, &timing, [0.0, u])?;
    let phi = sampled.phi(u);
    let turning = turning_part(&sampled.turning, [0.0, phi]);
    let time = old.own.curve_time;
    here.own = here.own.with(|own| {
        own.turning = turning;
        own.curve_time = time.map(|time| time * phi);
    })?;
    let fixed = old.own.frames;
    if fixed > 0 {
        let first = ((u * f64::from(fixed)).round() as u32).clamp(1, fixed.max(2) - 1);
        let rest = fixed.saturating_sub(first).max(1);
        here.own = here.own.with(|own| own.frames = first)?;
        let there = &mut new.points[at].orientations[0];
        there.own = there.own.with(|own| own.frames = rest)?;
    }
    new.check()?;
    let mut changed: Vec<usize> = vec_with_room(2 * NEIGHBOURS)?;
    changed.push(begin.point);
    keep_tangents(path, &mut new, at, &wanted, &mut changed)?;
    if alignment::any(path) {
        let old = alignment::ups(path)?;
        let mut ups = vec_with_room(old.len() + 1)?;
        ups.extend(old.into_iter().map(Some));
        ups.insert(section + 1, None);
        changed.append(&mut alignment::keep_ups(&mut new, &ups)?);
    }
    keep_rates(path, &timeline, &mut new, index, &wanted, &mut changed)?;
    new.check()?;
    changed.sort_unstable();
    changed.dedup();
    changed.retain(|&point| point != at);
    Ok(Insertion {
        at,
        path: new,
        changed,
    })
}

/// The frames nearest to where a segment divides into equal lengths, for [`on_curve`] one by one.
///
/// # Errors
/// [`Error::Range`] for no such way or too few frames; [`Error::Limit`], [`Error::Memory`].
#[allow(clippy::cast_precision_loss)]
pub fn dividing_frames(path: &CameraPath, segment: usize, points: usize) -> Result<Vec<f64>> {
    let timeline = Timeline::new(path)?;
    let sampler = Sampler::new(path, &timeline)?;
    let section = (segment < timeline.segment_count())
        .then(|| path.points[segment].orientations.len() - 1)
        .and_then(|last| timeline.section_from(segment, last))
        .filter(|&section| timeline.section(section).frames > points);
    let too_few = || Error::Range(OutOfRange::FewerFrames(segment));
    let section = section.ok_or_else(too_few)?;
    let mut sampled = sampler.sections().iter();
    let sampled = sampled.find(|sampled| sampled.section == section);
    let sampled = sampled.ok_or_else(too_few)?;
    let timing = timeline.timing(path, section)?;
    let all = sampled.frames;
    let mut found = vec_with_room(points)?;
    let mut least = 1;
    for number in 0..points {
        let share = (number + 1) as f64 / (points + 1) as f64;
        let at = |frame: usize| timing.fraction(frame as f64 / all as f64);
        let most = all - (points - number);
        let mut frame = least;
        while frame < most && (at(frame + 1) - share).abs() < (at(frame) - share).abs() {
            frame += 1;
        }
        found.push((sampled.start + frame) as f64);
        least = frame + 1;
    }
    Ok(found)
}

/// The section to divide, and at which share of its time.
#[allow(clippy::cast_precision_loss)]
fn find(
    path: &CameraPath,
    timeline: &Timeline,
    sampler: &Sampler,
    frame: f64,
) -> Result<(usize, f64)> {
    let frames = sampler.frame_count();
    if !(frame >= 1.0 && frame <= frames as f64) {
        return Err(sampler.no_frame(frame));
    }
    let sections = sampler.sections();
    let index =
        sections.partition_point(|sampled| (sampled.start + sampled.frames) as f64 <= frame);
    let at_a_key = || Error::Range(OutOfRange::AtKey(frame));
    let sampled = sections.get(index).ok_or_else(at_a_key)?;
    let within = frame - sampled.start as f64;
    if within <= 0.0 {
        return Err(at_a_key());
    }
    let begin = timeline.section(sampled.section);
    let last = path.points[begin.point].orientations.len() - 1;
    if sampled.way.is_none() || begin.orientation != last {
        return Err(OutOfRange::Turning {
            frame,
            point: begin.point,
        }
        .into());
    }
    let frames = sampled.frames as f64;
    let share = if sampled.frames > 1 {
        within.round().clamp(1.0, frames - 1.0) / frames
    } else {
        within
    };
    Ok((index, share))
}

/// What the path must have after the insertion.
struct Wanted {
    /// Tangents of the point before, the new one and the one after.
    leave: DVec3,
    middle: Tangents,
    reach: DVec3,
    /// Of the new key, in y-up axes.
    velocity: DVec3,
    roll_slope: f64,
    zoom_slope: f64,
}

/// The new point, with nothing custom but its pace, and what it and its neighbours must have.
fn divide(
    path: &CameraPath,
    timeline: &Timeline,
    section: usize,
    sampled: &SectionSampler,
    u: f64,
) -> Result<(SupportPoint, Wanted)> {
    let begin = timeline.section(section);
    let source = &path.points[begin.point];
    let old = &source.orientations[begin.orientation];
    let cubic = timeline.curve(begin.point);
    let phi = sampled.phi(u);
    let arc = ArcLength::new(cubic)?;
    let t = arc.parameter_at(phi * arc.length());
    let position = cubic.point(t);
    let ends = [cubic.point(0.0), cubic.point(1.0)];
    if !(t > 0.0 && t < 1.0) || phi <= 0.0 || phi >= 1.0 || ends.contains(&position) {
        return Err(OutOfRange::NearPoint.into());
    }
    let pose = sampled.pose(sampled.prepared()?, phi);
    let (view, up) = (DVec3::from(pose.vpn), DVec3::from(pose.vup));
    let seen = Target::Relative(view * old.target.offset_from(source.position).length());
    let roll_there = sampled.turning_slope(phi);
    let duration = begin.duration();
    let (target, roll) = match &sampled.turning {
        Turning::Kept(..) => (
            Target::Relative(old.target.offset_from(source.position)),
            old.roll,
        ),
        Turning::Tracked(target, _) if *target != position => {
            (Target::Absolute(*target), roll_there.0.to_degrees())
        }
        Turning::Follow(follow) => {
            let target = match follow.look {
                Look::Ahead(_) => seen,
                Look::Target(target) if target != position => Target::Absolute(target),
                Look::Still | Look::Target(_) => old.target,
            };
            (target, roll_there.0.to_degrees())
        }
        _ => (seen, path.space.up.roll_from_up(view, up).to_degrees()),
    };
    let mut orientation = Orientation {
        target,
        roll: orientation::wrap_degrees(roll),
        zoom: pose.zoom.clamp(MIN_ZOOM, MAX_ZOOM),
        turning: Tcb::default(),
        speeds: old.speeds,
        hold: 0,
        own: old.own.for_a_copy()?.with(|own| {
            match sampled.turning {
                Turning::Follow(_) => {}
                // Rolls are measured as at the section's beginning.
                Turning::Tracked(..) | Turning::Kept(..) => own.ahead = None,
                _ => {
                    own.ahead = None;
                    own.up = UpVector::Axis;
                }
            }
        })?,
    };
    let timing = timeline.timing(path, section)?;
    let whole = (timeline.curve_ends(path, section)?, old);
    take_part(&mut orientation, whole, &timing, [u, 1.0])?;
    let turning = turning_part(&sampled.turning, [phi, 1.0]);
    let time = old.own.curve_time;
    orientation.own = orientation.own.with(|own| {
        own.turning = turning;
        own.locked = old.own.locked;
        own.curve_time = time.map(|time| time * (1.0 - phi));
    })?;
    let mut orientations = vec_with_room(1)?;
    orientations.push(orientation);
    let rest = 1.0 - t;
    let slope = cubic.derivative(t);
    let wanted = Wanted {
        leave: cubic.derivative(0.0) * t,
        middle: Tangents {
            before: slope * t,
            after: slope * rest,
        },
        reach: cubic.derivative(1.0) * rest,
        velocity: angular_velocity(&sampled.turning, phi) / duration,
        roll_slope: roll_there.1 / duration,
        zoom_slope: sampled.zoom_slope(phi) / duration,
    };
    let point = SupportPoint {
        position,
        name: None,
        curve: source.curve,
        tangents: None,
        keeps_motion: false,
        orientations,
    };
    Ok((point, wanted))
}

/// Gives an orientation a part of the pace of `old`'s section, and ten speeds near to that.
fn take_part(
    to: &mut Orientation,
    (ends, old): ([CurveEnd; 2], &Orientation),
    timing: &Timing,
    [from, end]: [f64; 2],
) -> Result<()> {
    if timing.is_constant() && old.own.pace == Pace::Speeds {
        return Ok(());
    }
    #[allow(clippy::cast_precision_loss)]
    for (k, speed) in to.speeds.iter_mut().enumerate() {
        let x = k as f64 / (SPEEDS - 1) as f64;
        *speed = timing.speed(from + (end - from) * x);
        *speed = speed.clamp(MIN_SPEED, MAX_SPEED);
    }
    let part = |of: PaceSource| PacePart { of, from, to: end };
    let pace = match &old.own.pace {
        Pace::Speeds => part(PaceSource::Speeds {
            speeds: old.speeds,
            slopes: end_slopes(&old.speeds, ends),
        }),
        Pace::Ease(ease) => part(PaceSource::Ease(*ease)),
        Pace::Distance(keys) => part(PaceSource::Distance(keys.clone())),
        Pace::Part(old) => {
            let [from, to] = part_of([old.from, old.to], [from, end]);
            let of = old.of.clone();
            PacePart { of, from, to }
        }
    };
    to.own = to.own.with(|own| own.pace = Pace::Part(pace))?;
    Ok(())
}

/// The part of a Bézier turning between two shares of its time. (A part of an arc is an arc.)
fn turning_part(turning: &Turning, part: [f64; 2]) -> Option<TurningPart> {
    let (&control, [from, to]) = match turning {
        Turning::Bezier(control) => (control, part),
        Turning::Part(control, whole) => (control, part_of(*whole, part)),
        _ => return None,
    };
    Some(TurningPart { control, from, to })
}

/// A part of a part, exact where the one ends with the other.
fn part_of([from, to]: [f64; 2], part: [f64; 2]) -> [f64; 2] {
    part.map(|share| match share {
        1.0 => to,
        _ => from + (to - from) * share,
    })
}

/// Angular velocity on S³ of a turning by quaternions, for one whole section.
fn angular_velocity(turning: &Turning, phi: f64) -> DVec3 {
    let q = |phi: f64| turning.quaternion(phi).unwrap_or(DQuat::IDENTITY);
    let difference = |h: f64| {
        let (before, after) = (q(phi - h), q(phi + h));
        quaternion::log(after * before.conjugate()) / (2.0 * h)
    };
    // Richardson: the error of the second order goes.
    (4.0 * difference(DIFFERENCE / 2.0) - difference(DIFFERENCE)) / 3.0
}

/// Gives points the tangents that the new one would change.
fn keep_tangents(
    path: &CameraPath,
    new: &mut CameraPath,
    at: usize,
    wanted: &Wanted,
    changed: &mut Vec<usize>,
) -> Result<()> {
    let count = new.points.len();
    let (before, after) = (at - 1, (at + 1) % count);
    for _ in 0..ROUNDS {
        let mut settled = true;
        let near = |point: usize| {
            let apart = point.abs_diff(at);
            apart.min(if path.closed { count - apart } else { apart }) <= NEIGHBOURS
        };
        for point in (0..count).filter(|&point| near(point)) {
            let should = if point == at {
                wanted.middle
            } else {
                let mut old = curve::tangents(path, point - usize::from(point > at));
                // At an end of an open path both sides are one.
                if point == before {
                    old.after = wanted.leave;
                    if point == 0 && !path.closed {
                        old.before = old.after;
                    }
                }
                if point == after {
                    old.before = wanted.reach;
                    if point == count - 1 && !path.closed {
                        old.after = old.before;
                    }
                }
                old
            };
            let is = curve::tangents(new, point);
            let size = should.before.length() + should.after.length();
            let far = (is.before - should.before).length() + (is.after - should.after).length();
            if far > SAME * size {
                settled = false;
                new.points[point].tangents = Some(should);
                changed.try_reserve(1)?;
                changed.push(point);
            }
        }
        if settled {
            break;
        }
    }
    Ok(())
}

/// Velocities and slopes of all keys, with the longest curve time beside each.
struct Keys {
    rates: Vec<Rates>,
    zoom: Vec<f64>,
    steps: Vec<f64>,
}

impl Keys {
    fn new(path: &CameraPath, timeline: &Timeline) -> Result<Self> {
        let mut layout = Layout::new(path, timeline)?;
        let zoom = zoom_slopes(path, &layout.keys, &layout.spans, &layout.poses)?;
        let count = layout.keys.len();
        let mut steps = vec_with_room(count)?;
        for key in 0..count {
            let beside = [
                layout.spans.get(key),
                layout.spans.get((key + count - 1) % count),
            ];
            let longest = beside.into_iter().flatten().map(|way| way.duration);
            steps.push(longest.fold(0.0, f64::max));
        }
        let rates = rates(&mut layout.keys, &layout.spans, layout.guides, path.space)?;
        Ok(Self { rates, zoom, steps })
    }

    /// What a key lacks of the rates and the slope of the zoom that it should have.
    fn missing(
        &self,
        key: usize,
        should: Rates,
        zoom: Option<f64>,
        path: &CameraPath,
    ) -> Option<Missing> {
        let (is, step) = (self.rates[key], self.steps[key]);
        // Less than this turns or zooms nothing by 1e-9.
        let same = |far: f64| far * step <= 1e-9;
        let differ = |(a, b): &(f64, f64)| !same((a - b).abs());
        let turned = (is.reach - should.reach)
            .length()
            .max((is.leave - should.leave).length());
        let turns = path.orientation_mode == OrientationMode::Tcb && is.acts;
        let owned = |rate: DVec3| path.space.up.world(rate) * 2f64.to_degrees();
        let velocities = (turns && !same(turned)).then(|| Velocities {
            reach: owned(should.reach),
            leave: owned(should.leave),
        });
        let rolls = is.roll_slope.zip(should.roll_slope).filter(differ);
        let zooms = self.zoom.get(key).copied().zip(zoom).filter(differ);
        let missing = Missing {
            velocities,
            roll_slope: rolls.map(|(_, should)| should.to_degrees()),
            zoom_slope: zooms.map(|(_, should)| should),
        };
        (velocities.is_some() || rolls.is_some() || zooms.is_some()).then_some(missing)
    }
}

/// What a key must come to own.
struct Missing {
    velocities: Option<Velocities>,
    roll_slope: Option<f64>,
    zoom_slope: Option<f64>,
}

/// Gives keys the velocities and slopes that the new one would change.
fn keep_rates(
    path: &CameraPath,
    timeline: &Timeline,
    new: &mut CameraPath,
    segment: usize,
    wanted: &Wanted,
    changed: &mut Vec<usize>,
) -> Result<()> {
    let old = Keys::new(path, timeline)?;
    let middle = segment + 1;
    for _ in 0..ROUNDS {
        let timeline = Timeline::new(new)?;
        let is = Keys::new(new, &timeline)?;
        if is.rates.len() != old.rates.len() + 1 {
            return Err(OutOfRange::NearPoint.into());
        }
        let starts = timeline.moving().map(|section| timeline.start_of(section));
        let last = new.points.len() - 1;
        let end = (last, new.points[last].orientations.len() - 1);
        let mut settled = true;
        for (key, (point, number)) in starts.chain([end]).take(is.rates.len()).enumerate() {
            let before = key - usize::from(key > middle);
            let (rates, zoom) = if key == middle {
                let rates = Rates {
                    reach: wanted.velocity,
                    leave: wanted.velocity,
                    roll_slope: is.rates[key].roll_slope.map(|_| wanted.roll_slope),
                    acts: is.rates[key].acts,
                };
                (rates, Some(wanted.zoom_slope))
            } else {
                (old.rates[before], old.zoom.get(before).copied())
            };
            let Some(missing) = is.missing(key, rates, zoom, path) else {
                continue;
            };
            settled = false;
            let orientation = &mut new.points[point].orientations[number];
            orientation.own = orientation.own.with(|own| {
                own.velocities = missing.velocities.or(own.velocities);
                own.roll_slope = missing.roll_slope.or(own.roll_slope);
                own.zoom_slope = missing.zoom_slope.or(own.zoom_slope);
            })?;
            changed.try_reserve(1)?;
            changed.push(point);
        }
        if settled {
            break;
        }
    }
    Ok(())
}

#[cfg(test)]
#[path = "insertion_tests.rs"]
pub(crate) mod tests;
