//! Edits by which only what they are about gets other times: all other keys keep theirs.
//!
//! Between two keys that keep their times the sections take what the holds leave. A turn at one
//! place keeps its frames, and the way to the next point takes the rest, so that a view that is
//! added or turned takes its time from that way. Where sections only follow one another along the
//! way, they share it in proportion.

use std::ops::Range;
use std::sync::Arc;

use vides_engine::limits::MAX_SECTION_FRAMES;
use vides_engine::path::fit_frames::{Fixed, scale_frames, share};
use vides_engine::path::{CameraPath, Change, Orientation, Timeline};

use super::Edit;
use super::edit::At;
use super::editing::Document;
use crate::error::Result;

/// When the keys of a path come, and which of them are which after edits.
pub(super) struct KeyTimes {
    /// In their order, as they were.
    keys: Vec<Key>,
    closed: bool,
    /// Of each key of the path after the edits, which it was; none: it is new.
    origins: Vec<Option<usize>>,
}

#[derive(Clone, Copy)]
struct Key {
    hold: u32,
    /// Its hold, and the frames to the next key; 0 if both are one.
    time: usize,
    /// It was one with the key before, or its time is edited.
    free: bool,
}

impl KeyTimes {
    pub(super) fn of(document: &Document) -> Result<Self> {
        let path = document.path();
        let views = path.points.iter().flat_map(|point| &point.orientations);
        let mut keys: Vec<Key> = views
            .map(|view| Key {
                hold: view.hold,
                time: 0,
                free: false,
            })
            .collect();
        let count = keys.len();
        document.timeline(|timeline| {
            for at in 0..timeline.section_count() {
                let section = timeline.section(at);
                match section.change {
                    Change::Nothing => keys[(at + 1) % count].free = true,
                    _ => keys[at].time = keys[at].hold as usize + section.frames,
                }
            }
        })?;
        Ok(Self {
            origins: (0..count).map(Some).collect(),
            closed: path.closed,
            keys,
        })
    }

    /// Takes into account what an edit has made of a path.
    fn follow(&mut self, about: About, before: &CameraPath, after: &Document) {
        let path = after.path();
        let now = after.selection();
        match about {
            About::RemovedPoint(at) => drop(self.origins.drain(keys_of(before, at..at + 1))),
            About::NewView => self
                .origins
                .insert(key(path, now.point, now.orientation), None),
            About::RemovedView(point, at) => drop(self.origins.remove(key(before, point, at))),
            About::View(point, _) => self.free_turns(path, point),
            // The first new point becomes current.
            About::Points if path.points.len() > before.points.len() => {
                let count = path.points.len() - before.points.len();
                self.insert_points(path, now.point..now.point + count);
            }
            About::Points | About::Order => {}
        }
    }

    /// Takes into account that these points of a path are new.
    pub(super) fn insert_points(&mut self, path: &CameraPath, points: Range<usize>) {
        let new = keys_of(path, points);
        let none = new.clone().map(|_| None);
        drop(self.origins.splice(new.start..new.start, none));
    }

    /// The views of a point behind its first one come when the turns to them are over.
    fn free_turns(&mut self, path: &CameraPath, point: usize) {
        for at in keys_of(path, point..point + 1).skip(1) {
            if let Some(origin) = self.origins[at] {
                self.keys[origin].free = true;
            }
        }
    }

    /// The frames of those sections that have to change for all other keys to keep their times.
    /// Keys that would be less than a frame apart come later instead.
    pub(super) fn wanted(&self, document: &Document) -> Result<Vec<Fixed>> {
        let path = document.path();
        document.timeline(|timeline| {
            let after = After { path, timeline };
            let anchors = self.origins.iter().zip(0..).filter_map(|(origin, at)| {
                let origin = origin.filter(|&origin| !self.keys[origin].free)?;
                Some([at, origin])
            });
            let anchors: Vec<[usize; 2]> = anchors.collect();
            let mut wanted = Vec::new();
            for pair in anchors.windows(2) {
                let [[from, was_from], [to, was_to]] = [pair[0], pair[1]];
                self.span(&after, from..to, was_from..was_to, &mut wanted)?;
            }
            if let (Some(&[first, was_first]), Some(&[last, was_last])) =
                (anchors.first(), anchors.last())
                && self.closed
                && path.closed
            {
                let sections = (last..self.origins.len()).chain(0..first);
                let keys = (was_last..self.keys.len()).chain(0..was_first);
                self.span(&after, sections, keys, &mut wanted)?;
            }
            Ok(wanted)
        })?
    }

    /// Between two keys that keep their times: the sections from one to the other, and the keys
    /// that were there from the first one on.
    fn span(
        &self,
        after: &After<'_>,
        sections: impl Iterator<Item = usize> + Clone,
        keys: impl Iterator<Item = usize>,
        wanted: &mut Vec<Fixed>,
    ) -> Result<()> {
        let [mut now, mut before] = [0, 0];
        for at in sections.clone() {
            if let Some(origin) = self.origins[at] {
                now += after.hold(at);
                before += self.keys[origin].hold as usize;
            }
        }
        let moving = sections.filter(|&at| after.timeline.section(at).change != Change::Nothing);
        let moving: Vec<usize> = moving.collect();
        let holds: usize = moving.iter().map(|&at| after.hold(at)).sum();
        let time = keys.map(|key| self.keys[key].time).sum::<usize>() + now;
        let frames = |at: &usize| after.timeline.section(*at).frames;
        let all: usize = moving.iter().map(frames).sum();
        let Some(rest) = time.checked_sub(before + holds) else {
            return Ok(());
        };
        if all == rest || rest < moving.len() {
            return Ok(());
        }
        let mut shared = moving.clone();
        shared.retain(|&at| after.gives(at));
        let turns = all - shared.iter().map(frames).sum::<usize>();
        let mut left = rest.saturating_sub(turns);
        if shared.is_empty() || left < shared.len() {
            (shared, left) = (moving, rest);
        }
        let begin = wanted.len();
        wanted.extend(shared.iter().map(|&at| after.fixed(at)));
        let mut weights: Vec<f64> = shared.iter().map(|at| frames(at) as f64).collect();
        let most = MAX_SECTION_FRAMES.saturating_mul(shared.len());
        share(&mut wanted[begin..], &mut weights, left.min(most))?;
        Ok(())
    }
}

/// A path after edits. Its sections have the numbers of the keys with which they begin.
struct After<'a> {
    path: &'a CameraPath,
    timeline: &'a Timeline,
}

impl After<'_> {
    fn view(&self, at: usize) -> &Orientation {
        let section = self.timeline.section(at);
        &self.path.points[section.point].orientations[section.orientation]
    }

    fn hold(&self, at: usize) -> usize {
        self.view(at).hold as usize
    }

    /// Whether it leads to another place, and is not to keep its frames.
    fn gives(&self, at: usize) -> bool {
        self.timeline.section(at).change == Change::Position && !self.view(at).own.locked
    }

    fn fixed(&self, at: usize) -> Fixed {
        let section = self.timeline.section(at);
        Fixed {
            point: section.point,
            orientation: section.orientation,
            frames: 1,
        }
    }
}

/// What an edit is about.
#[derive(Clone, Copy)]
enum About {
    /// Places, or new points.
    Points,
    RemovedPoint(usize),
    NewView,
    RemovedView(usize, usize),
    View(usize, usize),
    /// Times or their order, another path or no path: what it says holds.
    Order,
}

impl About {
    const fn of(edit: &Edit) -> Self {
        match *edit {
            Edit::RemovePoint { at } => Self::RemovedPoint(at),
            Edit::InsertOrientation { .. } => Self::NewView,
            Edit::RemoveOrientation { point, at } => Self::RemovedView(point, at),
            Edit::Set {
                place: At::View(point, at),
                ..
            }
            | Edit::SetOrientation { point, at, .. }
            | Edit::SetAbsolute { point, at, .. } => Self::View(point, at),
            Edit::Set {
                place: At::Point(_) | At::Path,
                ..
            }
            | Edit::InsertPoint { .. }
            | Edit::AppendAfterLast
            | Edit::PrependBeforeFirst
            | Edit::DivideSegment { .. }
            | Edit::InsertOnCurve { .. }
            | Edit::TransformPoints { .. }
            | Edit::DeformPoints { .. }
            | Edit::InsertPath { .. }
            | Edit::SetSpace { .. }
            | Edit::ChangeUp(_) => Self::Points,
            _ => Self::Order,
        }
    }

    /// Whether an edit that has made `after` of a path is of speeds, frames or the order of points.
    fn is_of_times(self, before: &CameraPath, after: &CameraPath) -> bool {
        let [old, new] = match self {
            Self::View(point, at) => {
                [before, after].map(|path| &path.points[point].orientations[at])
            }
            _ => return matches!(self, Self::Order) || before.base_frames != after.base_frames,
        };
        old.speeds != new.speeds || old.own.frames != new.own.frames || old.own.pace != new.own.pace
    }
}

/// The number of a key among all of a path.
fn key(path: &CameraPath, point: usize, at: usize) -> usize {
    keys_of(path, point..point).start + at
}

/// The numbers of the keys of some points.
fn keys_of(path: &CameraPath, points: Range<usize>) -> Range<usize> {
    let count = |points: Range<usize>| -> usize {
        let points = points.map(|at| path.points[at].orientations.len());
        points.sum()
    };
    let start = count(0..points.start);
    start..start + count(points)
}

impl Document {
    /// As [`Document::apply`]; all keys but those that the edit is about keep their times: where a
    /// point is removed its two sections are joined and their frames add up. Speeds, base speeds,
    /// frames of a section and holds have the effect that they have in [`Document::apply`]. A number
    /// of frames stretches the times of all keys, which keep their proportions.
    ///
    /// # Errors
    /// As [`Document::apply`].
    pub fn apply_keeping_times(&mut self, edit: Edit) -> Result<()> {
        match About::of(&edit) {
            About::Order => self.apply_sharing(edit, scale_frames),
            _ => self.apply_all_keeping_times([edit]),
        }
    }

    /// The same of several edits, as [`Document::apply_all`] does them.
    ///
    /// # Errors
    /// As [`Document::apply_all`].
    pub fn apply_all_keeping_times(&mut self, edits: impl IntoIterator<Item = Edit>) -> Result<()> {
        let mut times = KeyTimes::of(self)?;
        self.within_step(|document| {
            for edit in edits {
                let about = About::of(&edit);
                let before = Arc::clone(&document.content.path);
                document.apply_sharing(edit, scale_frames)?;
                match about.is_of_times(&before, document.path()) {
                    true => times = KeyTimes::of(document)?,
                    false => times.follow(about, &before, document),
                }
            }
            document.keep_frames(&times.wanted(document)?)
        })
    }
}

#[cfg(test)]
#[path = "key_times_tests.rs"]
mod tests;
