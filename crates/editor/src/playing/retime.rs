//! Keys are moved and copied in time. The sections around a key get fixed frames, so that
//! all else stays where it is.

use vides_document::error::Result;
use vides_document::{Edit, Selection, StepName};
use vides_engine::path::{CameraPath, Orientation, SupportPoint};

use crate::state::Editor;
use crate::state::playing::graph::Stretch;
use crate::state::playing::{Beside, Marks, Retiming};

impl Marks {
    /// The sections that end and begin at the key of this frame.
    pub(super) fn beside(&self, frame: usize) -> Beside {
        let all = self.graph.stretches();
        let of = |stretch: &Stretch| (stretch.from, stretch.end - stretch.start);
        let behind = all.partition_point(|stretch| stretch.end <= frame);
        let before = behind.checked_sub(1).and_then(|at| all.get(at));
        [
            before.filter(|stretch| stretch.end == frame).map(of),
            all.get(behind).map(of),
        ]
    }

    /// By how many frames a key between these may move; `moves_along`: with all behind it.
    fn reach(&self, beside: Beside, moves_along: bool) -> (i64, i64) {
        let count = |frames: usize| i64::try_from(frames).unwrap_or(i64::MAX);
        let [Some((_, before)), after] = beside else {
            return (0, 0);
        };
        let least = 1 - count(before);
        match after.filter(|_| !moves_along) {
            Some((_, after)) => (least, count(after) - 1),
            None => {
                let most = vides_engine::limits::MAX_FRAMES.saturating_sub(self.frames);
                (least, count(most))
            }
        }
    }

    /// What moves a key between these by so many frames, or as many as can be.
    pub(super) fn moved(&self, beside: Beside, by: i64, moves_along: bool) -> Retiming {
        let (least, most) = self.reach(beside, moves_along);
        match (by.min(most).max(least), beside) {
            (by, [Some(before), after]) if by != 0 => {
                let after = after.filter(|_| !moves_along);
                Retiming::Move { before, after, by }
            }
            _ => Retiming::Nothing,
        }
    }
}

/// The orientation there.
fn view(path: &mut CameraPath, at: Selection) -> Option<&mut Orientation> {
    let point = path.points.get_mut(at.point)?;
    point.orientations.get_mut(at.orientation)
}

/// Gives the section that begins there its frames.
fn fix(path: &mut CameraPath, at: Selection, frames: usize) -> Result<()> {
    if let Some(begin) = view(path, at) {
        let frames = u32::try_from(frames).unwrap_or(u32::MAX);
        begin.own = begin.own.with(|own| own.frames = frames)?;
    }
    Ok(())
}

/// Lets the camera rest there for more frames.
fn rest(path: &mut CameraPath, at: Selection, frames: usize) {
    if let Some(begin) = view(path, at) {
        let frames = u32::try_from(frames).unwrap_or(u32::MAX);
        begin.hold = begin.hold.saturating_add(frames);
    }
}

impl Editor {
    /// Does this in place of what the drag has done so far.
    pub(crate) fn retime(&mut self, retiming: Retiming) {
        self.restart_step();
        match retiming {
            Retiming::Nothing => self.message = None,
            Retiming::Move { before, after, by } => {
                let moved = |(at, frames): (Selection, usize), by| {
                    let point = self.document.path().points.get(at.point)?;
                    let current = point.orientations.get(at.orientation)?;
                    let frames = i64::try_from(frames).ok()?.saturating_add(by);
                    let frames = u32::try_from(frames).ok()?;
                    Some(self.with_own(at, current, |own| own.frames = frames))
                };
                let edits = [
                    moved(before, by),
                    after.and_then(|at| moved(at, by.saturating_neg())),
                ];
                match edits.into_iter().flatten().collect::<Result<Vec<_>, _>>() {
                    Ok(edits) => {
                        self.edit_together(edits);
                    }
                    Err(why) => self.complain(why),
                }
            }
            Retiming::Copy { of, to } => match self.copy_key(of, to) {
                Ok(true) => self.message = None,
                Ok(false) => {
                    self.restart_step();
                    self.complain(self.texts().timeline.no_copy);
                }
                Err(error) => {
                    self.restart_step();
                    self.complain_of(&error);
                }
            },
        }
    }

    /// Makes a key like another one at a frame; false where none can be.
    fn copy_key(&mut self, of: Selection, to: usize) -> Result<bool> {
        let mut marks = Marks::default();
        marks.update(&self.document)?;
        let mut all = marks.graph.stretches().iter();
        let Some(stretch) = all.find(|stretch| stretch.start < to && to < stretch.end) else {
            // There is a key, or the camera rests.
            return Ok(false);
        };
        // Its neighbours' curves change, and with them the frames that come of lengths: these
        // stay. Where that is not all, all of them stay.
        for all in [false, true] {
            let mut path = self.document.path().try_clone()?;
            let near = near(&path, stretch.from);
            for stretch in marks.graph.stretches() {
                if all || near.contains(&stretch.from.point) {
                    fix(&mut path, stretch.from, stretch.end - stretch.start)?;
                }
            }
            let Some((name, new)) = copied(&mut path, stretch, of, to)? else {
                return Ok(false);
            };
            self.restart_step();
            self.document.apply(Edit::ReplacePath(Box::new(path)))?;
            self.document.name_step(name);
            self.document.select(new.point, new.orientation)?;
            let mut after = Marks::default();
            after.update(&self.document)?;
            // Between two keys that are equal nothing would move, and so no frames pass.
            let times = |marks: &Marks| marks.keys.iter().map(|key| key.frame).collect::<Vec<_>>();
            let (before, after) = (times(&marks), times(&after));
            let stay = match name {
                StepName::Hold => after.len() == before.len() && after.last() == before.last(),
                _ => after.contains(&to) && before.iter().all(|time| after.contains(time)),
            };
            if stay {
                return Ok(true);
            }
        }
        Ok(false)
    }
}

/// The points whose curves a new key behind this one changes.
fn near(path: &CameraPath, from: Selection) -> [usize; 3] {
    let count = path.points.len().max(1);
    [count - 1, 0, 1].map(|by| (from.point + by) % count)
}

/// Copies a key into a section; what that is called, and which key is new or rests.
fn copied(
    path: &mut CameraPath,
    stretch: &Stretch,
    of: Selection,
    to: usize,
) -> Result<Option<(StepName, Selection)>> {
    let from = stretch.from;
    let [first, second] = [to - stretch.start, stretch.end - to];
    let Some(point) = path.points.get(from.point) else {
        return Ok(None);
    };
    // The camera turns where it is, or goes on.
    let pans = from.orientation + 1 < point.orientations.len();
    let next = match pans {
        true => Selection::at(from.point, from.orientation + 1),
        false => Selection::at((from.point + 1) % path.points.len(), 0),
    };
    if of == from {
        // Beside itself it stays there until then.
        rest(path, of, first);
        fix(path, from, second)?;
        return Ok(Some((StepName::Hold, of)));
    }
    if of == next {
        // Or it comes earlier.
        fix(path, from, first)?;
        rest(path, of, second);
        return Ok(Some((StepName::Hold, of)));
    }
    let source = path.points.get(of.point);
    let Some((source, key)) =
        source.and_then(|point| Some((point, point.orientations.get(of.orientation)?)))
    else {
        return Ok(None);
    };
    let mut key = key.clone();
    key.hold = 0;
    let mut views = Vec::new();
    views.try_reserve(1)?;
    let point = SupportPoint {
        name: None,
        orientations: views,
        ..*source
    };
    fix(path, from, first)?;
    let new = insert(path, from, pans, point, key)?;
    fix(path, new, second)?;
    let name = match pans {
        true => StepName::InsertOrientation,
        false => StepName::InsertPoint,
    };
    Ok(Some((name, new)))
}

/// Puts a key behind another: a view where the camera turns, else a point.
fn insert(
    path: &mut CameraPath,
    from: Selection,
    pans: bool,
    mut point: SupportPoint,
    key: Orientation,
) -> Result<Selection> {
    if pans {
        if let Some(here) = path.points.get_mut(from.point) {
            here.orientations.try_reserve(1)?;
            here.orientations.insert(from.orientation + 1, key);
        }
        return Ok(Selection::at(from.point, from.orientation + 1));
    }
    path.points.try_reserve(1)?;
    point.orientations.push(key);
    path.points.insert(from.point + 1, point);
    Ok(Selection::at(from.point + 1, 0))
}

#[cfg(test)]
#[path = "retime_tests.rs"]
mod tests;
