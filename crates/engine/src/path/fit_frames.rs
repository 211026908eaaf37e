//! A path, or a range of its points, brought to a number of frames: sections share them in
//! proportion to the time that they take at their speed, or to the frames that they have, at least
//! one each, by largest remainder, so that the sum is exact.

use std::ops::Range;

use super::camera_path::{CameraPath, Orientation};
use super::timeline::{Change, Timeline};
use crate::error::{OutOfRange, Result, vec_with_room};
use crate::limits::MAX_FRAMES;

/// Frames for one section.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Fixed {
    /// The point at which the section begins.
    pub point: usize,
    /// The orientation of that point with which it begins.
    pub orientation: usize,
    /// Its frames, at least 1.
    pub frames: u32,
}

impl Fixed {
    /// Fixes the frames of that section of a path.
    ///
    /// # Errors
    /// [`crate::Error::Memory`].
    pub fn apply(self, path: &mut CameraPath) -> Result<()> {
        let own = &mut path.points[self.point].orientations[self.orientation].own;
        *own = own.with(|own| own.frames = self.frames)?;
        Ok(())
    }

    fn begin(self, path: &CameraPath) -> &Orientation {
        &path.points[self.point].orientations[self.orientation]
    }

    /// Whether the section has values that count by its frames: a curve time, or angular velocities
    /// at both ends, as in what was recorded.
    fn is_timed(self, path: &CameraPath) -> bool {
        let here = &path.points[self.point].orientations;
        let next = &path.points[(self.point + 1) % path.points.len()].orientations;
        let [begin, end] = [
            self.begin(path),
            here.get(self.orientation + 1).unwrap_or(&next[0]),
        ];
        let turns = |view: &Orientation| view.own.velocities.is_some();
        begin.own.curve_time.is_some() || turns(begin) && turns(end)
    }
}

/// The sections from the first orientation of `first` to the last of `last`, in order. On a closed
/// path all points stand for the whole way round, and a range may lead over the seam.
fn range(path: &CameraPath, timeline: &Timeline, first: usize, last: usize) -> Result<Vec<usize>> {
    let count = path.points.len();
    for point in [first, last] {
        if point >= count {
            return Err(path.no_point(point));
        }
    }
    if first > last && !path.closed {
        return Err(OutOfRange::PointOrder { first, last }.into());
    }
    let sections = timeline.section_count();
    let start = |point: usize| timeline.section_from(point, 0).unwrap_or(sections);
    let end = |point: usize| {
        let last = path.points[point].orientations.len() - 1;
        timeline.section_from(point, last).unwrap_or(sections)
    };
    let mut found = vec_with_room(sections)?;
    if path.closed && first == 0 && last == count - 1 {
        found.extend(0..sections);
    } else if first <= last {
        found.extend(start(first)..end(last));
    } else {
        found.extend(start(first)..sections);
        found.extend(0..end(last));
    }
    Ok(found)
}

/// Frames for the moving sections of a range of points (from 0), with exactly `frames` from the first
/// pose at `first` to the last at `last`, holds included, in proportion to the time that they take
/// at their speed, whatever their frames were. Locked sections keep theirs; those with a curve time
/// or with angular velocities at both ends, which count by their frames, keep their proportion.
///
/// # Errors
/// [`crate::Error::Range`] for a range that does not exist, or fewer or more frames than it can
/// have; [`crate::Error::Memory`].
pub fn fit_frames(
    path: &CameraPath,
    timeline: &Timeline,
    first: usize,
    last: usize,
    frames: usize,
) -> Result<Vec<Fixed>> {
    let sections = range(path, timeline, first, last)?;
    let extra = 1 + end_hold(path, first, last);
    fit(path, timeline, &sections, extra, frames, By::Speed)
}

/// The same in proportion to the frames that the sections have: keys keep their places in time.
///
/// # Errors
/// As [`fit_frames`].
pub fn scale_frames(
    path: &CameraPath,
    timeline: &Timeline,
    first: usize,
    last: usize,
    frames: usize,
) -> Result<Vec<Fixed>> {
    let sections = range(path, timeline, first, last)?;
    let extra = 1 + end_hold(path, first, last);
    fit(path, timeline, &sections, extra, frames, By::Frames)
}

/// The frames of a range of points as [`fit_frames`] counts them.
///
/// # Errors
/// As [`fit_frames`].
pub fn frames_of(
    path: &CameraPath,
    timeline: &Timeline,
    first: usize,
    last: usize,
) -> Result<usize> {
    let sections = range(path, timeline, first, last)?;
    let moving = moving_frames(path, timeline, sections.into_iter());
    Ok(moving + 1 + end_hold(path, first, last))
}

/// The key in which a range ends rests too, unless it is the whole way round.
fn end_hold(path: &CameraPath, first: usize, last: usize) -> usize {
    let round = path.closed && first == 0 && last + 1 == path.points.len();
    let end = path.points[last].orientations.last().filter(|_| !round);
    end.map_or(0, |end| end.hold as usize)
}

/// Frames for the moving sections between two points: `last` is reached `frames` after `first`. They
/// keep their proportions.
///
/// # Errors
/// As [`fit_frames`].
pub fn fit_between(
    path: &CameraPath,
    timeline: &Timeline,
    first: usize,
    last: usize,
    frames: usize,
) -> Result<Vec<Fixed>> {
    let mut sections = vec_with_room(timeline.section_count())?;
    sections.extend(between(timeline, first, last));
    fit(path, timeline, &sections, 0, frames, By::Frames)
}

/// The frames from reaching one point to reaching a later one, holds included.
#[must_use]
pub fn frames_between(path: &CameraPath, timeline: &Timeline, first: usize, last: usize) -> usize {
    moving_frames(path, timeline, between(timeline, first, last))
}

fn moving_frames(
    path: &CameraPath,
    timeline: &Timeline,
    sections: impl Iterator<Item = usize>,
) -> usize {
    let all = sections.map(|at| timeline.section(at));
    let moving = all.filter(|section| section.change != Change::Nothing);
    let hold = |point: usize, at: usize| path.points[point].orientations[at].hold as usize;
    moving
        .map(|section| section.frames + hold(section.point, section.orientation))
        .sum()
}

fn between(timeline: &Timeline, first: usize, last: usize) -> Range<usize> {
    let sections = timeline.section_count();
    let start = |point: usize| timeline.section_from(point, 0).unwrap_or(sections);
    start(first)..start(last)
}

/// What the frames of sections are in proportion to.
#[derive(Clone, Copy, PartialEq, Eq)]
enum By {
    /// The time that they take at their speed.
    Speed,
    /// The frames that they have.
    Frames,
}

/// Frames for these sections that with their holds and `extra` make exactly `frames`.
#[allow(clippy::cast_precision_loss)]
fn fit(
    path: &CameraPath,
    timeline: &Timeline,
    sections: &[usize],
    extra: usize,
    frames: usize,
    by: By,
) -> Result<Vec<Fixed>> {
    let mut fixed: Vec<Fixed> = vec_with_room(sections.len())?;
    let mut weights: Vec<f64> = vec_with_room(sections.len())?;
    let mut holds = 0;
    for &section in sections {
        let begin = timeline.section(section);
        if begin.change == Change::Nothing {
            continue;
        }
        let from = &path.points[begin.point].orientations[begin.orientation];
        holds += from.hold as usize;
        if from.own.locked {
            holds += begin.frames;
            continue;
        }
        let now = match from.own.frames {
            0 => timeline.unrounded_frames(path, section),
            fixed => f64::from(fixed),
        };
        weights.push(now);
        fixed.push(Fixed {
            point: begin.point,
            orientation: begin.orientation,
            frames: 1,
        });
    }
    let least = extra + holds + fixed.len();
    if frames < least {
        return Err(OutOfRange::TooFewFrames { frames, least }.into());
    }
    if frames > MAX_FRAMES || (fixed.is_empty() && frames > least) {
        let most = if fixed.is_empty() { least } else { MAX_FRAMES };
        return Err(OutOfRange::TooManyFrames { frames, most }.into());
    }
    if by == By::Speed {
        weigh_by_speed(path, &fixed, &mut weights)?;
    }
    share(&mut fixed, &mut weights, frames - extra - holds)?;
    Ok(fixed)
}

/// Weighs sections, in all as before, by the time that they take at their speed; not those that
/// count by their frames.
fn weigh_by_speed(path: &CameraPath, sections: &[Fixed], weights: &mut [f64]) -> Result<()> {
    let mut free: Vec<(usize, &Fixed)> = vec_with_room(sections.len())?;
    free.extend((0..).zip(sections).filter(|(_, at)| !at.is_timed(path)));
    let fixed = |(_, at): &&(usize, &Fixed)| at.begin(path).own.frames > 0;
    if !free.iter().any(|at| fixed(&at)) {
        return Ok(());
    }
    // Frames that sections have bear on the joints of speeds beside them.
    let mut plain = path.try_clone()?;
    for &(_, &at) in free.iter().filter(fixed) {
        Fixed { frames: 0, ..at }.apply(&mut plain)?;
    }
    let timeline = Timeline::new(&plain)?;
    let frames = |at: &Fixed| {
        let section = timeline.section_from(at.point, at.orientation);
        section.map_or(0.0, |at| timeline.unrounded_frames(&plain, at))
    };
    let before: f64 = free.iter().map(|&(k, _)| weights[k]).sum();
    let ratio = before / free.iter().map(|(_, at)| frames(at)).sum::<f64>();
    let ratio = if ratio.is_normal() { ratio } else { 1.0 };
    for (k, at) in free {
        weights[k] = frames(at) * ratio;
    }
    Ok(())
}

/// Shares `frames` in proportion to the weights (≥ 0; they are changed), at least 1 for each, by
/// largest remainder, ties to the earlier. There must be at least as many frames as weights, and as
/// many weights as sections.
///
/// # Errors
/// [`crate::Error::Memory`].
#[allow(
    clippy::cast_precision_loss,
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss
)]
pub fn share(fixed: &mut [Fixed], weights: &mut [f64], frames: usize) -> Result<()> {
    // Beside infinite weights the others are nothing.
    let largest = weights.iter().copied().fold(0.0, f64::max);
    for weight in weights.iter_mut() {
        *weight = if largest == 0.0 {
            1.0
        } else if largest.is_finite() {
            *weight / largest
        } else {
            f64::from(u8::from(weight.is_infinite()))
        };
    }
    let mut order: Vec<(f64, usize)> = vec_with_room(fixed.len())?;
    order.extend(weights.iter().copied().zip(0..));
    order.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    // The lightest first: what would have less than one frame has one, which the rest lacks.
    let (mut left, mut sum) = (frames, weights.iter().sum::<f64>());
    let mut single = 0;
    for &(weight, k) in &order {
        if weight * left as f64 >= sum {
            break;
        }
        fixed[k].frames = 1;
        left -= 1;
        sum -= weight;
        single += 1;
    }
    let shared = left;
    let sum: f64 = order[single..].iter().map(|(weight, _)| weight).sum();
    for (weight, k) in &mut order[single..] {
        let quota = shared as f64 * *weight / sum;
        // Rounding must not give away more than there is.
        let whole = (quota.floor() as usize).min(left);
        fixed[*k].frames = whole as u32;
        left -= whole;
        *weight = quota - quota.floor();
    }
    let order = &mut order[single..];
    order.sort_unstable_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
    for &(_, k) in order.iter().cycle().take(left) {
        fixed[k].frames += 1;
    }
    Ok(())
}

#[cfg(test)]
#[path = "fit_frames_tests.rs"]
mod tests;
