//! Playhead and selection go together: at a key the playhead selects it; between keys the panels
//! show what the camera does there, and a value that is entered makes a key of it. No other key
//! changes.

use glam::DVec3;
use vides_document::{Document, Edit, Info, Selection};
use vides_engine::math::orientation;
use vides_engine::math::rotation_minimising::signed_angle;
use vides_engine::path::{Orientation, Overrides, Space, Target, UpVector};

use crate::entry::Entry;
use crate::space::cameras::Camera;
use crate::state::Editor;
use crate::state::playing::{Between, Mark};
use crate::texts::fill;

/// Length of a view direction without a key, in units of the space's `half_size`.
const DIRECTION: f64 = 0.4;

/// What the panels show and change.
#[derive(Clone, Debug)]
pub(crate) struct Shown {
    /// Its place in the path, or the place it would have.
    pub(crate) at: Selection,
    pub(crate) position: DVec3,
    pub(crate) orientation: Orientation,
    pub(crate) missing: Missing,
}

/// What would have to be added for a key.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Missing {
    /// It is a key.
    Nothing,
    /// It is on the way to another point.
    Point,
    /// The camera pans at a point.
    Orientation,
    /// Nothing can be: the path has not begun there, or is over.
    Outside,
}

impl Shown {
    pub(crate) fn has_no_point(&self) -> bool {
        self.missing == Missing::Point
    }

    pub(crate) fn has_no_orientation(&self) -> bool {
        self.missing != Missing::Nothing
    }
}

impl Editor {
    /// What the panels show: the current key, or what the camera does at the playhead.
    pub(crate) fn shown(&self) -> Option<Shown> {
        if !self.document.edits_path() {
            return None;
        }
        if let Some((shown, _)) = self.at_playhead() {
            return Some(shown);
        }
        let at = self.document.selection();
        Some(Shown {
            at,
            position: self.point()?.position,
            orientation: self.orientation()?.clone(),
            missing: Missing::Nothing,
        })
    }

    /// The same, if the playhead shows a frame, and the path's frame that is seen there.
    fn at_playhead(&self) -> Option<(Shown, f64)> {
        let frame = self.seen_on_path(self.playing.frame()?)?;
        let mut shown = self.at_frame(frame)?;
        if self.outside_path().is_some() {
            shown.missing = Missing::Outside;
        }
        Some((shown, frame))
    }

    /// What the path does at one of its frames.
    fn at_frame(&self, frame: f64) -> Option<Shown> {
        let mark = self.playing.mark_before(frame)?;
        let points = &self.document.path().points;
        let point = points.get(mark.point)?;
        let from = point.orientations.get(mark.orientation)?;
        if frame <= mark.last() {
            // The camera is at this key, or rests there.
            return Some(Shown {
                at: Selection::at(mark.point, mark.orientation),
                position: point.position,
                orientation: from.clone(),
                missing: Missing::Nothing,
            });
        }
        let (camera, true) = self.camera()? else {
            return None;
        };
        let (at, missing, to) = match point.orientations.get(mark.orientation + 1) {
            Some(to) => {
                let at = Selection::at(mark.point, mark.orientation + 1);
                (at, Missing::Orientation, Some(to))
            }
            None => {
                let next = points.get((mark.point + 1) % points.len())?;
                let at = Selection::at(mark.point + 1, 0);
                (at, Missing::Point, next.orientations.first())
            }
        };
        let mut orientation = between(from, to, &camera, self.document.path().space);
        let axis = |key: &Orientation| key.own.up == UpVector::Axis;
        if !(axis(from) && to.is_none_or(axis))
            && let Some((roll, own)) = self.roll_there(frame, at, missing, &orientation)
        {
            (orientation.roll, orientation.own) = (roll, own);
        }
        Some(Shown {
            at,
            position: camera.position,
            orientation,
            missing,
        })
    }

    /// Roll and own values of a key that would show this frame, where up is not the axis: those it
    /// has in a copy of the path.
    fn roll_there(
        &self,
        frame: f64,
        at: Selection,
        missing: Missing,
        orientation: &Orientation,
    ) -> Option<(f64, Overrides)> {
        let known =
            |found: &&Between| (found.revision, found.frame) == (self.document.revision(), frame);
        if let Some(found) = self.playing.between.as_ref().filter(known) {
            return Some((found.roll, found.own.clone()));
        }
        let path = self.document.path().try_clone().ok()?;
        let copy = Document::from_parts(path, Info::default()).ok()?;
        let mut copy = copy.without_history();
        let Selection {
            point,
            orientation: number,
        } = at;
        match missing {
            Missing::Nothing | Missing::Outside => return None,
            Missing::Point => copy.apply(Edit::InsertOnCurve { frame }).ok()?,
            Missing::Orientation => copy
                .apply(Edit::InsertOrientation {
                    point,
                    at: number,
                    orientation: Some(orientation.clone()),
                })
                .ok()?,
        }
        let key = copy.path().points.get(point)?.orientations.get(number)?;
        let pose = self.document.sampler().ok()?.pose(frame).ok()?;
        let [view, up] = [pose.vpn, pose.vup].map(DVec3::from_array);
        let missing = signed_angle(copy.up(point, number).ok()?, up, view).to_degrees();
        let own = orientation
            .own
            .with(|own| own.up = key.own.up.clone())
            .ok()?;
        Some((orientation::wrap_degrees(key.roll + missing), own))
    }

    /// Keeps the roll between keys, so that it is found once in a pass.
    pub(super) fn keep_between(&mut self) {
        let shown = self.at_playhead().filter(|(shown, _)| {
            shown.missing != Missing::Nothing && shown.orientation.own.up != UpVector::Axis
        });
        self.playing.between = shown.map(|(shown, frame)| Between {
            revision: self.document.revision(),
            frame,
            roll: shown.orientation.roll,
            own: shown.orientation.own,
        });
    }

    /// Selects the last key at or before the playhead, which stays with the key if it is at it.
    pub(crate) fn select_at_playhead(&mut self) {
        let Some(frame) = self.playing.frame() else {
            return;
        };
        if self.outside_path().is_some() {
            // What is selected stays so.
            self.playing.selected(self.document.selection(), false);
            return;
        }
        let frame = self.frame_on_path(frame);
        let current = self.playing.mark_of(self.document.selection());
        // Of several keys at one frame the current one.
        let here = current.filter(|mark| mark.begins_at(frame));
        let Some(mark) = here.or_else(|| self.playing.mark_before(frame)) else {
            // No path is edited.
            self.playing.selected(self.document.selection(), false);
            return;
        };
        if Selection::at(mark.point, mark.orientation) != self.document.selection() {
            self.message = None;
            // The marks may be older than the path.
            if self.document.select(mark.point, mark.orientation).is_err() {
                return;
            }
        }
        self.playing
            .selected(self.document.selection(), mark.begins_at(frame));
    }

    /// Why nothing can be added to the path at the playhead.
    pub(crate) fn why_not_here(&self) -> Option<String> {
        let (first, last) = self.outside_path()?;
        let (first, last) = (self.frame_for_people(first), self.frame_for_people(last));
        Some(fill(self.texts().position.outside, &[&first, &last]))
    }

    /// Makes a key of what the panels show, within the open step or as a new step.
    pub(crate) fn add_here(&mut self) -> bool {
        let Some(shown) = self.shown() else {
            return false;
        };
        if shown.missing == Missing::Nothing {
            self.say(self.texts().position.is_a_key);
            return false;
        }
        if let Some(why) = self.why_not_here() {
            self.complain(why);
            return false;
        }
        let within = self.document.in_step();
        if !within {
            self.document.begin_step();
        }
        let Selection { point, orientation } = shown.at;
        let done = match shown.missing {
            Missing::Nothing | Missing::Outside => false,
            Missing::Orientation => self.edit(Edit::InsertOrientation {
                point,
                at: orientation,
                orientation: Some(shown.orientation),
            }),
            Missing::Point => self
                .playing
                .frame()
                .map(|frame| self.frame_on_path(frame))
                .is_some_and(|frame| self.edit(Edit::InsertOnCurve { frame })),
        };
        if !done {
            self.document.cancel_step();
            return false;
        }
        if !within {
            self.document.end_step();
        }
        self.playing.leave();
        true
    }

    /// Enters a value of what the path does not have yet: adds it first, in the same step.
    pub(crate) fn enter_missing(&mut self, entry: Entry<Edit>) {
        match entry {
            Entry::Begin => {
                self.document.begin_step();
                self.add_here();
            }
            // A slider that was not held drags without a beginning: a step of its own.
            Entry::Set(edit) | Entry::Drag(edit) => {
                self.document.begin_step();
                if self.add_here() {
                    self.edit(edit);
                    self.document.end_step();
                }
            }
            entry => self.enter(entry),
        }
    }
}

/// An orientation for this camera: looking at a place if both keys do, with the first one's speeds.
fn between(
    from: &Orientation,
    to: Option<&Orientation>,
    camera: &Camera,
    space: Space,
) -> Orientation {
    let target = match (from.target, to.map(|to| to.target)) {
        (Target::Absolute(place), Some(Target::Absolute(other)))
            if place == other && place != camera.position =>
        {
            from.target
        }
        (Target::Relative(offset), _) => Target::Relative(camera.view * offset.length()),
        _ => Target::Relative(camera.view * (DIRECTION * space.half_size)),
    };
    let roll = space.up.roll_from_up(camera.view, camera.up).to_degrees();
    Orientation {
        target,
        roll: orientation::wrap_degrees(roll),
        zoom: camera.zoom,
        hold: 0,
        ..from.clone()
    }
}

impl Mark {
    fn begins_at(self, frame: f64) -> bool {
        self.first() == frame
    }
}

#[cfg(test)]
#[path = "playhead_tests.rs"]
mod tests;
