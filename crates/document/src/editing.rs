//! The document: a path with its edits, its history and cached results.

use std::mem::replace;
use std::sync::Arc;

use super::apply::{self, Share};
use super::content::Content;
use super::edit::{Edit, Selection};
use super::edited_scene::fresh_revision;
use super::fingerprint::Fingerprint;
use super::held;
use super::history::{History, Step};
use super::info::{Info, Object};
use super::lapse;
use super::normalise::normalise;
use super::set::orientation;
use super::step_name::StepName;
use super::touched::Touched;
use crate::error::Result;
use vides_engine::limits;
use vides_engine::path::fit_frames::fit_frames;
use vides_engine::path::up_vector::check_ups;
use vides_engine::path::{CameraPath, Orientation, Plan, SupportPoint, UpVector};

/// A path being edited, with its info, selection and history. It can be saved, loaded and sampled
/// after any edit (unless it has more than [`limits::MAX_FRAMES`] frames).
///
/// Reading takes `&self` and may happen on several threads at once.
#[derive(Debug)]
pub struct Document {
    pub(super) content: Content,
    history: History,
    /// The open step, with what was there before it.
    open: Option<Step>,
    /// What was there at the newest step, if another node has been chosen since.
    away: Option<Content>,
    touched: Touched,
    saved: u64,
    pub(super) plan: Plan,
    /// That of the file it was read from.
    pub(super) fingerprint: Option<Fingerprint>,
}

impl Default for Document {
    fn default() -> Self {
        Self::new()
    }
}

impl Document {
    /// The path a new window begins with.
    #[must_use]
    pub fn new() -> Self {
        Self::with(CameraPath::default(), Info::default())
    }

    /// As [`Document::new`], but reports running out of memory.
    ///
    /// # Errors
    /// `ErrorKind::Memory`.
    pub fn try_new() -> Result<Self> {
        Ok(Self::with(CameraPath::try_new()?, Info::default()))
    }

    /// A new path in a space around an object, which is no change of the user's.
    ///
    /// # Errors
    /// As [`vides_engine::path::Space::around`]; `ErrorKind::Memory`.
    pub fn around(object: Object) -> Result<Self> {
        let mut document = Self::try_new()?.without_history();
        let mut info = document.info().clone();
        info.object = object;
        document.apply(Edit::SetInfo(Box::new(info)))?;
        let space = document.space_around_object()?;
        document.apply(Edit::SetSpace { space, fit: true })?;
        Ok(document.as_opened())
    }

    /// A document of this path.
    ///
    /// # Errors
    /// The first value that violates [`vides_engine::path::camera_path`] or [`Info`].
    pub fn from_parts(mut path: CameraPath, mut info: Info) -> Result<Self> {
        normalise(&mut path)?;
        info.check(path.space)?;
        info.normalise();
        Ok(Self::with(path, info))
    }

    fn with(path: CameraPath, info: Info) -> Self {
        Self::of(Content::new(path, info, fresh_revision()))
    }

    fn of(content: Content) -> Self {
        Self {
            saved: content.number,
            content,
            history: History::new(limits::MAX_HISTORY_STEPS),
            open: None,
            away: None,
            touched: Touched::default(),
            plan: Plan::new(),
            fingerprint: None,
        }
    }

    /// The same document as if just opened: unmodified, without a history.
    #[must_use]
    pub fn as_opened(self) -> Self {
        Self {
            fingerprint: self.fingerprint,
            ..Self::of(Content {
                selection: Selection::default(),
                revision: fresh_revision(),
                ..self.content
            })
        }
    }

    /// That of the file the document was read from, if any, as it was then.
    #[must_use]
    pub fn fingerprint(&self) -> Option<Fingerprint> {
        self.fingerprint
    }

    /// The same document without a history from now on: `undo` has nothing to take back.
    #[must_use]
    pub fn without_history(mut self) -> Self {
        (self.open, self.away) = (None, None);
        self.history = History::new(0);
        self
    }

    /// A copy with the same selection, state number and revision, without the history.
    ///
    /// # Errors
    /// `ErrorKind::Memory`.
    pub fn try_clone(&self) -> Result<Self> {
        let mut copy = Self::of(self.content.clone());
        copy.fingerprint = self.fingerprint;
        if !self.history.keeps_any() {
            copy = copy.without_history();
        }
        copy.saved = self.saved;
        Ok(copy)
    }

    /// The path and the info, without the rest.
    #[must_use]
    pub fn into_parts(self) -> (CameraPath, Info) {
        let Content { path, info, .. } = self.content;
        (Arc::unwrap_or_clone(path), Arc::unwrap_or_clone(info))
    }

    /// The path.
    #[must_use]
    pub fn path(&self) -> &CameraPath {
        &self.content.path
    }

    /// What the file holds besides the path.
    #[must_use]
    pub fn info(&self) -> &Info {
        &self.content.info
    }

    /// The current point and orientation.
    #[must_use]
    pub fn selection(&self) -> Selection {
        self.content.selection
    }

    /// A number for the present contents, the selection excepted: equal numbers mean equal
    /// contents, also across documents of this process.
    #[must_use]
    pub fn revision(&self) -> u64 {
        self.content.revision
    }

    /// Selects a point and one of its orientations. Not an edit: it adds no step and modifies
    /// nothing.
    ///
    /// # Errors
    /// `ErrorKind::Range` if there is no such point or orientation.
    pub fn select(&mut self, point: usize, orientation: usize) -> Result<()> {
        self::orientation(&self.content.path, point, orientation)?;
        self.content.selection = Selection::at(point, orientation);
        Ok(())
    }

    /// Does an edit: one step of the history, or part of the open one, unless it changes nothing.
    /// The choice of another node alone is no step: undo restores it together with the next one.
    ///
    /// # Errors
    /// Why the edit is impossible; the document is unchanged then.
    pub fn apply(&mut self, edit: Edit) -> Result<()> {
        self.apply_sharing(edit, fit_frames)
    }

    /// The same; a number of frames is shared in this way.
    pub(super) fn apply_sharing(&mut self, edit: Edit, share: Share) -> Result<()> {
        let chooses = matches!(edit, Edit::EditNode(_));
        let name = StepName::of(&edit, self.path(), self.info());
        let moves = lapse::moves_points(&edit);
        let mut next = self.content.clone();
        apply::apply(&mut next, edit, share)?;
        if next.shares_all(&self.content) {
            return Ok(());
        }
        if moves {
            lapse::lapse(&self.content.path, &mut next.path);
        }
        if !chooses {
            check_new_ups(&self.content.path, &next.path)?;
        }
        self.follow(&mut next)?;
        next.revision = fresh_revision();
        if !chooses {
            next.number = next.revision;
        }
        let other = replace(&mut self.content, next);
        if let Some(open) = &mut self.open {
            open.name.get_or_insert(name);
        } else if chooses && self.history.keeps_any() {
            self.away.get_or_insert(other);
        } else {
            let name = Some(name);
            self.keep(Step { name, other });
        }
        Ok(())
    }

    /// Adds to an edit's result what must follow it, and brings the plan up to date.
    fn follow(&mut self, next: &mut Content) -> Result<()> {
        let edited = Arc::clone(&next.path);
        self.plan.follow(&self.content.path, &edited);
        let done = held::follow(&self.content, next, &self.plan);
        let path = match done {
            Ok(()) => &next.path,
            Err(_) => &self.content.path,
        };
        self.plan.follow(&edited, path);
        done
    }

    /// Puts something else in the place of the contents.
    fn put(&mut self, content: Content) {
        self.plan.follow(&self.content.path, &content.path);
        self.content = content;
    }

    /// Adds a step to the history, with the way to the node that it changes.
    fn keep(&mut self, step: Step) {
        let name = step.name;
        let other = self.away.take().unwrap_or(step.other);
        self.history.push(Step { name, other }, &self.content);
    }

    /// Does several edits as one step of the history, or as part of the open step.
    ///
    /// # Errors
    /// Why one of them is impossible; the document is unchanged then.
    pub fn apply_all(&mut self, edits: impl IntoIterator<Item = Edit>) -> Result<()> {
        self.within_step(|document| edits.into_iter().try_for_each(|edit| document.apply(edit)))
    }

    /// Makes changes as one step of the history, or as part of the open step; none after an error.
    pub(super) fn within_step(
        &mut self,
        change: impl FnOnce(&mut Self) -> Result<()>,
    ) -> Result<()> {
        let own = !self.in_step();
        if own {
            self.begin_step();
        }
        let before = self.content.clone();
        let name = self.open.as_ref().and_then(|open| open.name);
        let done = change(self);
        if done.is_err() {
            self.put(before);
            if let Some(open) = &mut self.open {
                open.name = name;
            }
        }
        if own {
            self.end_step();
        }
        done
    }

    /// Opens a step, such as a drag: all edits until [`Document::end_step`]. Ends an open one.
    pub fn begin_step(&mut self) {
        self.end_step();
        self.open = Some(Step {
            name: None,
            other: self.content.clone(),
        });
    }

    /// Whether a step is open; see [`Document::begin_step`].
    #[must_use]
    pub fn in_step(&self) -> bool {
        self.open.is_some()
    }

    /// Opens the newest step again, so that what follows is undone together with it. False without
    /// a step, or if it was undone.
    pub fn reopen_step(&mut self) -> bool {
        self.end_step();
        self.open = self.history.pop();
        if self.open.is_some() {
            self.away = None;
        }
        self.open.is_some()
    }

    /// Names the open step, for example after a tool; else it is called after its first edit.
    pub fn name_step(&mut self, name: StepName) {
        if let Some(step) = &mut self.open {
            step.name = Some(name);
        }
    }

    /// The names of the steps that [`Document::undo`] and [`Document::redo`] would take, if any.
    #[must_use]
    pub fn step_names(&self) -> [Option<StepName>; 2] {
        match &self.open {
            Some(open) => [open.name, None],
            None => self.history.names(),
        }
    }

    /// Ends the open step, if any.
    pub fn end_step(&mut self) {
        if let Some(step) = self.open.take()
            && step.other.revision != self.content.revision
        {
            self.keep(step);
        }
    }

    /// Marks where the history stands, for [`Document::join_steps`]. Ends an open step.
    pub fn mark_steps(&mut self) {
        self.end_step();
        self.history.mark();
    }

    /// Makes one step of all that were done since [`Document::mark_steps`] and not undone, and ends
    /// an open one. Without a mark they stay.
    pub fn join_steps(&mut self) {
        self.end_step();
        self.history.join(&self.content);
    }

    /// Undoes the open step, selection included, and drops it: it cannot be redone.
    pub fn cancel_step(&mut self) {
        if let Some(step) = self.open.take() {
            self.put(Content {
                revision: fresh_revision(),
                ..step.other
            });
        }
    }

    /// Ends the open step and undoes the last one, selection included. False without a step.
    pub fn undo(&mut self) -> bool {
        self.travel(false)
    }

    /// Redoes the step undone last, selection included. False without a step.
    pub fn redo(&mut self) -> bool {
        self.travel(true)
    }

    fn travel(&mut self, redo: bool) -> bool {
        self.end_step();
        let possible = match redo {
            true => self.history.can_redo(),
            false => self.history.can_undo(),
        };
        if possible {
            let before = self.away.take().unwrap_or_else(|| self.content.clone());
            let mut content = before.clone();
            self.history.travel(redo, &mut content);
            content.revision = fresh_revision();
            self.touched = Touched::between(&before, &content);
            self.put(content);
        }
        possible
    }

    /// What the last undo or redo has changed of the scene.
    #[must_use]
    pub const fn touched(&self) -> &Touched {
        &self.touched
    }

    /// Whether there is a step to undo.
    #[must_use]
    pub fn can_undo(&self) -> bool {
        let changed = |step: &Step| step.other.revision != self.content.revision;
        self.history.can_undo() || self.open.as_ref().is_some_and(changed)
    }

    /// Whether there is a step to redo.
    #[must_use]
    pub fn can_redo(&self) -> bool {
        self.history.can_redo()
    }

    /// Whether there are unsaved changes. False again after undoing back to the saved state.
    #[must_use]
    pub fn is_modified(&self) -> bool {
        self.content.number != self.saved
    }

    /// Number of the present state: new after each edit, the old one again after undo.
    #[must_use]
    pub fn state_number(&self) -> u64 {
        self.content.number
    }

    /// Marks every state, past and present, as unsaved.
    pub fn mark_unsaved(&mut self) {
        self.saved = u64::MAX;
    }

    /// Marks the present state as the saved one.
    pub fn mark_saved(&mut self) {
        self.saved = self.content.number;
    }

    /// Marks the state before the open step as the saved one, or the present one if no step is open.
    pub fn mark_saved_before_step(&mut self) {
        let before = self.open.as_ref().map_or(&self.content, |step| &step.other);
        self.saved = before.number;
    }
}

/// Refuses a change of a path that leaves an orientation without a defined up vector.
fn check_new_ups(old: &CameraPath, new: &CameraPath) -> Result<()> {
    let demands = |o: &Orientation| matches!(o.own.up, UpVector::Frenet | UpVector::Path(_));
    let shapes =
        |point: &SupportPoint| point.tangents.is_some() || point.orientations.iter().any(demands);
    if new.curve != old.curve || new.points.without(&old.points).any(shapes) {
        check_ups(new)?;
    }
    Ok(())
}
