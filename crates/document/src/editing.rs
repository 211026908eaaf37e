//! The document: a path with its edits, its history and cached results.

use super::change::{State, exchange_all};
use super::edit::{Edit, Selection};
use super::edited_scene::fresh_revision;
use super::fingerprint::Fingerprint;
use super::held;
use super::history::{History, Step};
use super::info::{Info, Object};
use super::normalise::normalise;
use super::prepare;
use super::set::orientation;
use super::step_name::StepName;
use super::touched::Touched;
use crate::error::Result;
use vides_engine::limits;
use vides_engine::path::up_vector::check_ups;
use vides_engine::path::{CameraPath, Plan};

/// A path being edited, with its info, selection and history. It can be saved, loaded and sampled
/// after any edit (unless it has more than [`limits::MAX_FRAMES`] frames).
///
/// Reading takes `&self` and may happen on several threads at once.
#[derive(Debug)]
pub struct Document {
    pub(super) state: State,
    selection: Selection,
    history: History,
    /// The open step, which collects edits.
    open: Option<Step>,
    /// The way from the node whose path was edited at the newest step to the one that is now, closed.
    away: Option<Step>,
    touched: Touched,
    /// Number of the present state; each edit makes a new one.
    number: u64,
    newest: u64,
    saved: u64,
    /// Unique to these contents within the process.
    revision: u64,
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
        Self {
            state: State::new(path, info),
            selection: Selection::default(),
            history: History::new(limits::MAX_HISTORY_STEPS),
            open: None,
            away: None,
            touched: Touched::default(),
            number: 0,
            newest: 0,
            saved: 0,
            revision: fresh_revision(),
            plan: Plan::new(),
            fingerprint: None,
        }
    }

    /// The same document as if just opened: unmodified, without a history.
    #[must_use]
    pub fn as_opened(self) -> Self {
        let mut opened = Self::with(self.state.path, self.state.info);
        opened.fingerprint = self.fingerprint;
        opened.state.comments = self.state.comments;
        opened.state.edited_scene = self.state.edited_scene;
        opened
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

    /// A copy with the same selection, without the history.
    ///
    /// # Errors
    /// `ErrorKind::Memory`.
    pub fn try_clone(&self) -> Result<Self> {
        let path = self.state.path.try_clone()?;
        let mut copy = Self::with(path, self.state.info.try_clone()?);
        copy.selection = self.selection;
        copy.fingerprint = self.fingerprint;
        copy.state.comments = self.state.comments.try_clone()?;
        copy.state.edited_scene.clone_from(&self.state.edited_scene);
        if !self.history.keeps_any() {
            copy = copy.without_history();
        }
        if self.is_modified() {
            copy.number = 1;
            copy.newest = 1;
        }
        Ok(copy)
    }

    /// The path and the info, without the rest.
    #[must_use]
    pub fn into_parts(self) -> (CameraPath, Info) {
        (self.state.path, self.state.info)
    }

    /// The path.
    #[must_use]
    pub fn path(&self) -> &CameraPath {
        &self.state.path
    }

    /// What the file holds besides the path.
    #[must_use]
    pub fn info(&self) -> &Info {
        &self.state.info
    }

    /// The current point and orientation.
    #[must_use]
    pub fn selection(&self) -> Selection {
        self.selection
    }

    /// A number for the present contents, the selection excepted: equal numbers mean equal
    /// contents, also across documents of this process.
    #[must_use]
    pub fn revision(&self) -> u64 {
        self.revision
    }

    /// Selects a point and one of its orientations. Not an edit: it adds no step and modifies
    /// nothing.
    ///
    /// # Errors
    /// `ErrorKind::Range` if there is no such point or orientation.
    pub fn select(&mut self, point: usize, orientation: usize) -> Result<()> {
        self::orientation(&self.state.path, point, orientation)?;
        self.selection = Selection::at(point, orientation);
        Ok(())
    }

    /// Does an edit: one step of the history, or part of the open one, unless it changes nothing.
    /// Another node to edit by itself is no step: it goes back with the next one.
    ///
    /// # Errors
    /// Why the edit is impossible; the document is unchanged then.
    pub fn apply(&mut self, edit: Edit) -> Result<()> {
        let node = match edit {
            Edit::EditNode(node) if self.open.is_none() && self.history.keeps_any() => node,
            other => return self.done(other, true),
        };
        let edit = Edit::EditNode(node);
        let Some(mut away) = self.away.take_if(|_| self.state.node() != node) else {
            return self.done(edit, false);
        };
        // One way back is enough, however many nodes were visited.
        if let Err(error) = self.exchange(&mut away) {
            self.away = Some(away);
            return Err(error);
        }
        let done = self.done(edit, false);
        if done.is_err() {
            // It was just exchanged, and can be again.
            let _ = self.exchange(&mut away);
            self.away = Some(away);
        } else if self.away.is_none() {
            // It is that node again; what was selected there still goes back with the next step.
            self.away = Some(Step::new(self.selection, self.number));
            self.selection = Selection::default();
        }
        done
    }

    fn done(&mut self, edit: Edit, is_step: bool) -> Result<()> {
        let same_for_a_file = matches!(edit, Edit::EditNode(_));
        let name = StepName::of(&edit, self.path(), self.info());
        let (mut change, selection) = prepare::prepare(&self.state, edit)?;
        if change.is_idle(&self.state) {
            return Ok(());
        }
        let keeps_record = self.open.is_some() || self.history.keeps_any();
        let mut own = Step::new(self.selection, self.number);
        let step = self.open.as_mut().unwrap_or(&mut own);
        if keeps_record {
            step.reserve()?;
            self.history.reserve()?;
        }
        change.reserve(&mut self.state)?;
        let shapes = change.may_undefine_ups();
        let of_scene = change.of_scene();
        change.apply(&mut self.state, &mut self.plan)?;
        let mut follow = || -> Result<_> {
            if shapes {
                check_ups(&self.state.path)?;
            }
            let mut held = held::what_follows(&self.state, &self.plan, of_scene)?;
            if keeps_record {
                step.reserve_more(1 + held.len())?;
            }
            exchange_all(&mut held, |held| {
                held.apply(&mut self.state, &mut self.plan)
            })?;
            Ok(held)
        };
        let held = match follow() {
            Ok(held) => held,
            Err(error) => {
                // It was just exchanged, and can be again.
                let _ = change.apply(&mut self.state, &mut self.plan);
                return Err(error);
            }
        };
        if keeps_record {
            step.name.get_or_insert(name);
            step.push(change);
            // They stand as they are to be undone.
            held.into_iter().rev().for_each(|held| step.push(held));
        }
        if self.open.is_none() {
            own.close();
            match is_step {
                true => self.keep(own),
                false => self.away = Some(own),
            }
        }
        if let Some(selection) = selection {
            self.selection = selection;
        }
        if !same_for_a_file {
            self.newest += 1;
            self.number = self.newest;
        }
        self.revision = fresh_revision();
        Ok(())
    }

    /// Adds a closed step to the history, with the way to the node that it changes.
    fn keep(&mut self, mut step: Step) {
        if step.is_empty() {
            return;
        }
        if let Some(mut away) = self.away.take()
            && away.reserve_for(&step).is_ok()
        {
            away.reopen();
            step.reopen();
            away.name = None;
            away.append(step);
            away.close();
            step = away;
        }
        self.history.push(step);
    }

    /// Does several edits as one step of the history, or as part of the open step.
    ///
    /// # Errors
    /// Why one of them is impossible; the document is unchanged then.
    pub fn apply_all(&mut self, edits: impl IntoIterator<Item = Edit>) -> Result<()> {
        let outer = self.open.take();
        self.begin_step();
        let done = edits.into_iter().try_for_each(|edit| self.apply(edit));
        let Some(mut outer) = outer else {
            match done {
                Ok(()) => self.end_step(),
                Err(_) => self.cancel_step(),
            }
            return done;
        };
        let done = done.and_then(|()| match &self.open {
            Some(inner) => outer.reserve_for(inner),
            None => Ok(()),
        });
        match done {
            Ok(()) => self
                .open
                .take()
                .into_iter()
                .for_each(|inner| outer.append(inner)),
            Err(_) => self.cancel_step(),
        }
        self.open = Some(outer);
        done
    }

    /// Opens a step, such as a drag: all edits until [`Document::end_step`]. Ends an open one.
    pub fn begin_step(&mut self) {
        self.end_step();
        self.open = Some(Step::new(self.selection, self.number));
    }

    /// Whether a step is open; see [`Document::begin_step`].
    #[must_use]
    pub fn in_step(&self) -> bool {
        self.open.is_some()
    }

    /// Opens the newest step again, so that what follows is taken back together with it. False if
    /// there is none, or if it was undone.
    pub fn reopen_step(&mut self) -> bool {
        self.end_step();
        self.open = self.history.pop();
        if let Some(step) = &mut self.open {
            step.reopen();
            if let Some(mut away) = self.away.take()
                && step.reserve_for(&away).is_ok()
            {
                away.reopen();
                step.append(away);
            }
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
        if let Some(mut step) = self.open.take() {
            step.close();
            // Out of memory: the edits stand but cannot be undone.
            if self.history.reserve().is_ok() {
                self.keep(step);
            }
        }
    }

    /// Marks where the history stands, for [`Document::join_steps`]. Ends an open step.
    pub fn mark_steps(&mut self) {
        self.end_step();
        self.history.mark();
    }

    /// Makes one step of all that were done since [`Document::mark_steps`] and not undone, and ends
    /// an open one. Without a mark they stay.
    ///
    /// # Errors
    /// `ErrorKind::Memory`; they stay as they are then.
    pub fn join_steps(&mut self) -> Result<()> {
        self.end_step();
        self.history.join()
    }

    /// Undoes the open step, selection included, and drops it: it cannot be redone.
    pub fn cancel_step(&mut self) {
        if let Some(mut step) = self.open.take() {
            step.close();
            let _ = self.exchange(&mut step);
        }
    }

    /// Ends the open step and undoes the last one, selection included. False if there is none.
    /// Needs no memory, but for edits of a scene as much as the tracks or the list of nodes that
    /// change take; without it, it is false and nothing has changed.
    pub fn undo(&mut self) -> bool {
        self.travel(false)
    }

    /// Redoes the step undone last, selection included. False if there is none. Needs memory as
    /// [`Document::undo`].
    pub fn redo(&mut self) -> bool {
        self.travel(true)
    }

    fn travel(&mut self, redo: bool) -> bool {
        self.end_step();
        let possible = match redo {
            true => self.history.can_redo(),
            false => self.history.can_undo(),
        };
        let mut away = self.away.take_if(|_| possible);
        if let Some(back) = &mut away
            && self.exchange(back).is_err()
        {
            self.away = away;
            return false;
        }
        self.touched.clear();
        let mut history = std::mem::replace(&mut self.history, History::new(0));
        let done = history.exchange(redo, |step| self.exchange(step));
        self.history = history;
        if let Some(mut away) = away.filter(|_| !done) {
            // It was just exchanged, and can be again.
            let _ = self.exchange(&mut away);
            self.away = Some(away);
        }
        done
    }

    /// What the last undo or redo has changed of the scene.
    #[must_use]
    pub const fn touched(&self) -> &Touched {
        &self.touched
    }

    /// Whether there is a step to undo.
    #[must_use]
    pub fn can_undo(&self) -> bool {
        self.history.can_undo() || self.open.as_ref().is_some_and(|step| !step.is_empty())
    }

    /// Whether there is a step to redo.
    #[must_use]
    pub fn can_redo(&self) -> bool {
        self.history.can_redo()
    }

    fn exchange(&mut self, step: &mut Step) -> Result<()> {
        step.exchange(|change| {
            change.apply(&mut self.state, &mut self.plan)?;
            self.touched.note(change, self.state.node());
            Ok(())
        })?;
        std::mem::swap(&mut step.selection, &mut self.selection);
        std::mem::swap(&mut step.number, &mut self.number);
        self.revision = fresh_revision();
        Ok(())
    }

    /// Whether there are unsaved changes. False again after undoing back to the saved state.
    #[must_use]
    pub fn is_modified(&self) -> bool {
        self.number != self.saved
    }

    /// Number of the present state: new after each edit, the old one again after undo.
    #[must_use]
    pub fn state_number(&self) -> u64 {
        self.number
    }

    /// Marks every state, past and present, as unsaved.
    pub fn mark_unsaved(&mut self) {
        self.saved = u64::MAX;
    }

    /// Marks the present state as the saved one.
    pub fn mark_saved(&mut self) {
        self.saved = self.number;
    }
}
