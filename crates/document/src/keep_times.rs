//! Points removed and pasted while the keys that stay keep their times.

use vides_engine::limits::MAX_SECTION_FRAMES;
use vides_engine::path::fit_frames::Fixed;
use vides_engine::path::{CameraPath, Change, Timeline};

use super::Edit;
use super::editing::Document;
use super::key_times::KeyTimes;
use super::step_name::StepName;
use crate::error::{Result, vec_with_room};

impl Document {
    /// Removes points, given in ascending order, as one step. The points before and after
    /// them stay as far apart in time.
    ///
    /// # Errors
    /// `ErrorKind::Range` if there are no such points; `ErrorKind::Argument` if fewer than two
    /// remain; `ErrorKind::Memory`.
    pub fn remove_points(&mut self, points: &[usize]) -> Result<()> {
        let removals = points.iter().rev().map(|&at| Edit::RemovePoint { at });
        self.apply_all_keeping_times(removals)
    }

    /// Inserts copied points behind point `at`, where they were, as one step. They keep their
    /// seconds; the sections that join them have the mean speed of all others. With `fixed_times`
    /// they share the time up to the next point instead, which keeps its own.
    ///
    /// # Errors
    /// As [`Edit::InsertPath`].
    pub fn paste_points(&mut self, at: usize, copied: &Self, fixed_times: bool) -> Result<()> {
        let before = self.path().points.len();
        let mut times = KeyTimes::of(self)?;
        let (block, mut wanted) = copied.at_rate(self.info().fps)?;
        for fixed in &mut wanted {
            fixed.point += at + 1;
        }
        let insert = Edit::InsertPath {
            at,
            block: Box::new(block),
            fit: vides_engine::tools::block::Fit::None,
            with_targets: false,
        };
        self.within_step(|document| {
            document.name_step(StepName::PastePoints);
            document.apply(insert)?;
            document.keep_frames(&wanted)?;
            let last = at + document.path().points.len() - before;
            let joins = document.timeline(|timeline| joins(timeline, [at, last]))?;
            document.keep_frames(&joins)?;
            if fixed_times {
                times.insert_points(document.path(), at + 1..last + 1);
                document.keep_frames(&times.wanted(document)?)?;
            }
            Ok(())
        })
    }

    /// Replaces the path by copied points, as one step. They keep their space, unless this document
    /// has an object, and their seconds. `fixed_speeds`: the base speeds and the frame rate stay.
    ///
    /// # Errors
    /// As [`Edit::ReplacePath`].
    pub fn replace_by_points(&mut self, copied: &Self, fixed_speeds: bool) -> Result<()> {
        let mut info = self.info().try_clone()?;
        if !fixed_speeds {
            info.fps = copied.info().fps;
        }
        let (mut path, wanted) = copied.at_rate(info.fps)?;
        if fixed_speeds {
            path.base_frames = self.path().base_frames;
        }
        let has_object = !info.object.is_empty();
        if has_object {
            path.space = self.path().space;
        }
        self.within_step(|document| {
            document.name_step(StepName::PastePoints);
            document.apply(Edit::ReplacePath(Box::new(path)))?;
            document.apply(Edit::SetInfo(Box::new(info)))?;
            if has_object {
                let space = document.space_around_all()?;
                document.apply(Edit::SetSpace { space, fit: false })?;
            }
            document.keep_frames(&wanted)
        })
    }

    /// Fixes the frames of those sections that would have others.
    pub(super) fn keep_frames(&mut self, wanted: &[Fixed]) -> Result<()> {
        let others = self.timeline(|timeline| {
            let mut others = vec_with_room(wanted.len())?;
            others.extend(wanted.iter().filter(|fixed| {
                let section = timeline.section_from(fixed.point, fixed.orientation);
                let section = section.map(|at| timeline.section(at));
                fixed.frames > 0
                    && section.is_some_and(|section| {
                        section.change != Change::Nothing && section.frames != fixed.frames as usize
                    })
            }));
            Ok::<_, crate::error::Error>(others)
        })??;
        let mut edits = vec_with_room(others.len())?;
        for &Fixed {
            point,
            orientation: at,
            frames,
        } in others
        {
            let mut orientation = self.path().points[point].orientations[at].clone();
            orientation.own = orientation.own.with(|own| own.frames = frames)?;
            edits.push(Edit::SetOrientation {
                point,
                at,
                orientation,
            });
        }
        self.apply_all(edits)
    }

    /// The frames of all sections from one point to a later one, which becomes the first.
    pub(super) fn frames_from(&self, first: usize, last: usize) -> Result<Vec<Fixed>> {
        self.timeline(|timeline| {
            let mut all = vec_with_room(timeline.section_count())?;
            for at in 0..timeline.section_count() {
                let section = timeline.section(at);
                if (first..=last).contains(&section.point) {
                    all.push(Fixed {
                        point: section.point - first,
                        orientation: section.orientation,
                        frames: whole(section.frames),
                    });
                }
            }
            Ok(all)
        })?
    }

    /// The path and the frames of its sections at another frame rate.
    fn at_rate(&self, fps: f64) -> Result<(CameraPath, Vec<Fixed>)> {
        let rate = fps / self.info().fps;
        let mut path = self.path().try_clone()?;
        let mut wanted = self.frames_from(0, path.points.len())?;
        if rate != 1.0 {
            // Rounded in sum, so that the whole takes as long as it did.
            let (mut time, mut told) = (0, 0);
            for fixed in &mut wanted {
                time += fixed.frames as usize;
                let end = scaled(time, rate);
                fixed.frames = whole((end - told).max(usize::from(fixed.frames > 0)));
                told = end;
            }
            let views = path.points.iter_mut();
            for view in views.flat_map(|point| &mut point.orientations) {
                view.hold = whole(scaled(view.hold as usize, rate));
            }
        }
        Ok((path, wanted))
    }
}

/// The sections from these points to the next ones, with the mean speed of all others.
fn joins(timeline: &Timeline, from: [usize; 2]) -> Vec<Fixed> {
    let moving = (0..timeline.section_count()).map(|at| timeline.section(at));
    let moving = moving.filter(|section| section.change == Change::Position);
    let (joins, others): (Vec<_>, Vec<_>) =
        moving.partition(|section| from.contains(&section.point));
    let length: f64 = others
        .iter()
        .map(|of| timeline.segment_length(of.point))
        .sum();
    let frames: usize = others.iter().map(|of| of.frames).sum();
    let speed = length / frames as f64;
    if !(speed.is_finite() && speed > 0.0) {
        return Vec::new();
    }
    let fixed = joins.iter().map(|section| Fixed {
        point: section.point,
        orientation: section.orientation,
        frames: whole(rounded(timeline.segment_length(section.point) / speed).max(1)),
    });
    fixed.collect()
}

fn scaled(frames: usize, rate: f64) -> usize {
    rounded(frames as f64 * rate)
}

#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
fn rounded(frames: f64) -> usize {
    frames.round() as usize
}

/// A number of frames that a section can have.
#[allow(clippy::cast_possible_truncation)]
fn whole(frames: usize) -> u32 {
    frames.min(MAX_SECTION_FRAMES) as u32
}

#[cfg(test)]
#[path = "keep_times_tests.rs"]
mod tests;
