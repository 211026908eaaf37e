//! A path, or a range of its points, brought to a number of frames: sections share them in
//! proportion to their unrounded durations, at least one each, by largest remainder, so that the
//! sum is exact.

use std::ops::Range;

use super::camera_path::CameraPath;
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
/// pose at `first` to the last at `last`, holds included. Proportions are kept.
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
    fit(
        path,
        timeline,
        &sections,
        1 + end_hold(path, first, last),
        frames,
    )
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

/// Frames for the moving sections between two points: `last` is reached `frames` after `first`.
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
    fit(path, timeline, &sections, 0, frames)
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

/// Frames for these sections that with their holds and `extra` make exactly `frames`.
#[allow(clippy::cast_precision_loss)]
fn fit(
    path: &CameraPath,
    timeline: &Timeline,
    sections: &[usize],
    extra: usize,
    frames: usize,
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
    share(&mut fixed, &mut weights, frames - extra - holds)?;
    Ok(fixed)
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
mod tests {
    use super::*;
    use crate::path::insertion::tests::random_path;
    use crate::path::test_support::Random;
    use crate::path::{Plan, Sampler, SupportPoint};
    use glam::DVec3;

    fn set(path: &mut CameraPath, fixed: &[Fixed]) {
        for fixed in fixed {
            fixed.apply(path).unwrap();
        }
    }

    #[test]
    fn a_locked_section_keeps_its_frames() {
        let points = [-0.5, 0.0, 0.1, 0.9];
        let mut path = CameraPath {
            points: points
                .map(|x| SupportPoint::new(DVec3::new(x, 0.0, 0.5)))
                .into(),
            ..CameraPath::default()
        };
        let lock = |path: &mut CameraPath, at: usize| {
            let orientation = &mut path.points[at].orientations[0];
            orientation.own = orientation.own.with(|own| own.locked = true).unwrap();
        };
        let fit = |path: &CameraPath, frames: usize| {
            let fit = |timeline: &Timeline| fit_frames(path, timeline, 0, 3, frames);
            Plan::new().timeline(path, fit).unwrap()
        };
        let before: Vec<usize> = Plan::new()
            .timeline(&path, |timeline| {
                (0..3).map(|at| timeline.section(at).frames).collect()
            })
            .unwrap();
        lock(&mut path, 1);
        let fixed = fit(&path, 1000).unwrap();
        let points: Vec<usize> = fixed.iter().map(|fixed| fixed.point).collect();
        assert_eq!(points, [0, 2]);
        let sum: usize = fixed.iter().map(|fixed| fixed.frames as usize).sum();
        assert_eq!(1 + sum + before[1], 1000);
        // Fewer than it leaves are refused, and any other number where all are locked.
        let least = 1 + before[1] + 2;
        assert!(fit(&path, least).is_ok() && fit(&path, least - 1).is_err());
        lock(&mut path, 0);
        lock(&mut path, 2);
        let whole = 1 + before.iter().sum::<usize>();
        assert!(fit(&path, whole).unwrap().is_empty());
        assert!(fit(&path, whole - 1).is_err() && fit(&path, whole + 1).is_err());
    }

    #[test]
    fn ten_thousand_paths_have_exactly_so_many_frames() {
        let mut random = Random(51);
        for round in 0..10_000 {
            let mut path = random_path(&mut random, round);
            if round % 4 == 0 {
                // Coincident points: sections in which nothing changes.
                let mut twin = path.points[0].clone();
                twin.orientations.truncate(1);
                path.points.insert(1, twin.clone());
                path.points[0] = twin;
            }
            let timeline = Timeline::new(&path).unwrap();
            let last = path.points.len() - 1;
            let fit = |frames| fit_frames(&path, &timeline, 0, last, frames);
            let said = fit(0).unwrap_err().to_string();
            let least: usize = said.rsplit(' ').next().unwrap().parse().unwrap();
            assert!(fit(least - 1).is_err());
            let frames = match round % 3 {
                0 => least,
                _ => least + (random.unit() * 2000.0) as usize,
            };
            let fixed = fit(frames).unwrap();
            set(&mut path, &fixed);
            let timeline = Timeline::new(&path).unwrap();
            assert_eq!(timeline.frame_count().unwrap(), frames, "round {round}");
            let sampler = Sampler::new(&path, &timeline).unwrap();
            assert_eq!(sampler.frame_count(), frames);
        }
    }

    #[test]
    fn frames_go_by_largest_remainder() {
        let frames = |weights: &[f64], frames: usize| {
            let one = Fixed {
                point: 0,
                orientation: 0,
                frames: 1,
            };
            let mut fixed = vec![one; weights.len()];
            share(&mut fixed, &mut weights.to_vec(), frames).unwrap();
            fixed.iter().map(|fixed| fixed.frames).collect::<Vec<_>>()
        };
        // Hare's method: 4.8, 3.6, 1.6 of 10.
        assert_eq!(frames(&[48.0, 36.0, 16.0], 10), [5, 4, 1]);
        assert_eq!(frames(&[1.0, 1.0, 1.0], 5), [2, 2, 1]);
        assert_eq!(frames(&[1.0, 1.0, 1.0, 1.0], 10), [3, 3, 2, 2]);
        assert_eq!(frames(&[0.0, 0.0], 5), [3, 2]);
        assert_eq!(frames(&[f64::INFINITY, 1.0], 5), [4, 1]);
        assert_eq!(frames(&[5.0, 0.0, 1e-300], 3), [1, 1, 1]);
        // One each for the light ones, the rest by weight.
        assert_eq!(frames(&[0.001, 6.0, 0.5, 3.0], 11), [1, 6, 1, 3]);
        assert_eq!(
            frames(&[3.0, 1.0], 99_999_992).iter().sum::<u32>(),
            99_999_992
        );
    }

    /// From twice as many frames as sections on, each section's frames are within one of its share.
    #[test]
    fn sections_have_one_mean_speed() {
        let points = [-0.9, -0.897, -0.6, -0.59, 0.1, 0.9];
        let path = CameraPath {
            points: points
                .map(|x| SupportPoint::new(DVec3::new(x, 0.0, 0.5)))
                .into(),
            curve: crate::path::CurveKind::Linear,
            ..CameraPath::default()
        };
        let timeline = Timeline::new(&path).unwrap();
        for frames in [11, 50, 1000, 20_000, 1_000_000] {
            let fixed = fit_frames(&path, &timeline, 0, 5, frames).unwrap();
            let mut speeds = fixed.iter().zip(points.windows(2)).map(|(fixed, ends)| {
                let share = (ends[1] - ends[0]) * (frames - 1) as f64 / 1.8;
                (f64::from(fixed.frames), share)
            });
            assert!(
                speeds.all(|(frames, share)| (frames - share).abs() <= 1.0 || frames == 1.0),
                "{frames}: {fixed:?}"
            );
        }
    }

    #[test]
    fn a_path_that_has_so_many_stays_as_it_is() {
        let mut random = Random(52);
        for round in 0..500 {
            let mut path = random_path(&mut random, round);
            let last = path.points.len() - 1;
            let timeline = Timeline::new(&path).unwrap();
            let fixed = fit_frames(&path, &timeline, 0, last, 500).unwrap();
            set(&mut path, &fixed);
            let timeline = Timeline::new(&path).unwrap();
            assert_eq!(fit_frames(&path, &timeline, 0, last, 500).unwrap(), fixed);
        }
    }

    #[test]
    fn a_range_changes_nothing_outside_it() {
        let mut random = Random(53);
        for round in 0..300 {
            let mut path = random_path(&mut random, round);
            path.points.push(SupportPoint::new(glam::DVec3::ONE));
            let timeline = Timeline::new(&path).unwrap();
            let count = path.points.len();
            let (a, b) = (round % count, (round / 5) % count);
            let fitted = fit_frames(&path, &timeline, a, b, 300);
            if a > b && !path.closed {
                assert!(fitted.is_err());
                continue;
            }
            let inside = |point: usize| {
                if a <= b {
                    (a..=b).contains(&point)
                } else {
                    point >= a || point <= b
                }
            };
            for fixed in fitted.unwrap_or_default() {
                let last = path.points[fixed.point].orientations.len() - 1;
                let whole = path.closed && (a, b) == (0, count - 1);
                assert!(
                    inside(fixed.point) && (whole || fixed.point != b || fixed.orientation < last)
                );
            }
        }
        let path = CameraPath::default();
        let timeline = Timeline::new(&path).unwrap();
        assert!(fit_frames(&path, &timeline, 0, 2, 100).is_err());
        assert!(fit_frames(&path, &timeline, 0, 0, 2).is_err());
        assert!(fit_frames(&path, &timeline, 0, 1, MAX_FRAMES + 1).is_err());
        assert_eq!(fit_frames(&path, &timeline, 0, 0, 1).unwrap(), []);
    }
}
