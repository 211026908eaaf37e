//! When the host is told of what the user does while it is done.
//!
//! A picture of the window comes first, then the host; what came meanwhile is one
//! call. A host that is slow gets as long for itself as it took, so that the window
//! can follow the hand. What it is told last is always how things stand, and when
//! nothing moves any more it is told that, too.

use std::time::{Duration, Instant};

use super::Reason;
use crate::editor::{Editor, Standing};
use crate::path::Pose;

/// A call that takes longer makes the next one wait as long.
const SLOW: Duration = Duration::from_millis(30);

/// So long nothing must have moved for it to be at rest.
const REST: Duration = Duration::from_millis(100);

/// From one hand-over that nobody asked for to the next, at least.
const BETWEEN_HAND_OVERS: Duration = Duration::from_millis(100);

/// What the host is to be called for.
#[derive(Debug)]
pub(super) enum Call {
    /// The camera at the playhead, its frame, and what led there.
    View(Pose, f64, Reason),
    /// The path has changed.
    Changed,
    /// Take all poses.
    HandOver,
}

/// What the host has been told.
#[derive(Debug, Default)]
pub(super) struct Live {
    seen: Option<Standing>,
    /// What led to the view that it has still to be told.
    waits: Option<Reason>,
    told: Option<(Pose, f64)>,
    /// It is told of the rest then.
    rest: Option<Instant>,
    /// The step that it knows.
    step: Option<(u64, u64)>,
    /// The path of which it has the poses, by its revision.
    handed: Option<u64>,
    next_hand_over: Option<Instant>,
    /// It has time for itself until then.
    busy: Option<Instant>,
}

impl Live {
    /// Of a window that opens: the host knows the path as it is then.
    pub(super) fn new(editor: &Editor) -> Self {
        Self {
            step: Some(editor.step_number()),
            ..Self::default()
        }
    }

    /// What the host is to be called for now, if anything. Whoever does not watch takes
    /// poses only. `held`: a button is.
    pub(super) fn next(
        &mut self,
        editor: &Editor,
        watches: bool,
        held: bool,
        now: Instant,
    ) -> Option<Call> {
        self.look(editor);
        let moves = held || editor.is_under_way();
        if self.busy.is_some_and(|busy| now < busy) {
            return None;
        }
        self.busy = None;
        if !editor.document().in_step() && self.step != Some(editor.step_number()) {
            self.step = Some(editor.step_number());
            if watches {
                return Some(Call::Changed);
            }
        }
        if watches
            && let Some(reason) = self.waits.take()
            // A path that cannot be sampled has no poses; the window says so.
            && let Ok(view) = editor.view()
            && self.told.replace(view) != Some(view)
        {
            self.rest = Some(now + REST);
            return Some(Call::View(view.0, view.1, reason));
        }
        if self.owes_poses(editor) && self.next_hand_over.is_none_or(|at| now >= at) {
            self.handed = Some(editor.document().revision());
            self.next_hand_over = Some(now + BETWEEN_HAND_OVERS);
            return Some(Call::HandOver);
        }
        if moves {
            self.rest = self.rest.map(|_| now + REST);
        } else if self.rest.is_some_and(|rest| now >= rest) {
            self.rest = None;
            let view = editor.view().ok().or(self.told)?;
            self.told = Some(view);
            return Some(Call::View(view.0, view.1, Reason::Rested));
        }
        None
    }

    /// Notes what has happened since it looked last.
    fn look(&mut self, editor: &Editor) {
        let standing = editor.standing();
        match self.seen.replace(standing) {
            None => self.waits = Some(Reason::Selected),
            Some(before) if before != standing => self.waits = Some(standing.reason(&before)),
            Some(_) => {}
        }
        if !editor.hands_over() {
            self.handed = None;
        }
    }

    fn owes_poses(&self, editor: &Editor) -> bool {
        editor.hands_over() && self.handed != Some(editor.document().revision())
    }

    /// When there is something to do without news from the screen.
    pub(super) fn due(&self, editor: &Editor, held: bool) -> Option<Instant> {
        let moves = held || editor.is_under_way();
        let later = self
            .owes_poses(editor)
            .then_some(self.next_hand_over)
            .flatten();
        let rest = self.rest.filter(|_| !moves);
        let waits = self.busy.filter(|_| {
            self.waits.is_some()
                || self.step != Some(editor.step_number())
                || self.owes_poses(editor)
        });
        // While it has time for itself nothing else comes either.
        let other = [later, rest].into_iter().flatten().min();
        let other = other.map(|at| self.busy.map_or(at, |busy| busy.max(at)));
        waits.into_iter().chain(other).min()
    }

    /// A call into the host has ended, or what was made ready for one.
    pub(super) fn called(&mut self, took: Duration, now: Instant) {
        if took > SLOW {
            self.busy = Some(now + took);
        }
    }

    /// Host code changes something within a call: it knows of that. `change` is
    /// made, and only what was not told before is still to be told.
    pub(super) fn known<R>(
        &mut self,
        editor: &mut Editor,
        change: impl FnOnce(&mut Editor) -> R,
    ) -> R {
        self.look(editor);
        let step = self.step == Some(editor.step_number());
        let poses = !self.owes_poses(editor);
        let done = change(editor);
        self.seen = Some(editor.standing());
        if self.waits.is_none() {
            // What it was told is no longer how things stand.
            self.told = None;
        }
        if step {
            self.step = Some(editor.step_number());
        }
        if poses && editor.hands_over() {
            self.handed = Some(editor.document().revision());
        }
        done
    }
}
