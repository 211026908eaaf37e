//! Decides when to call the host while the user is editing.
//!
//! The calls have their own clock, sixty a second, because a window that is covered, iconified or
//! behind a slow line shows no picture. Everything between two ticks is one call. A slow host gets
//! as much time as its call took, so that the window can follow the pointer. The last
//! call always has the current state, and one more call reports that nothing moves.

use std::time::{Duration, Instant};

use vides_editor::{Editor, PlayheadState, Reason};
use vides_engine::path::Pose;

/// The least time between frames of an animation, or of mere pointer motion.
pub(super) const FRAME: Duration = Duration::from_nanos(1_000_000_000 / 60);

/// A call that takes longer delays the next one by as long as it took.
const SLOW: Duration = Duration::from_millis(30);

/// How long nothing must move before the host is called with [`Reason::Rested`].
const REST: Duration = Duration::from_millis(100);

/// The least time between two automatic hand-overs.
const BETWEEN_HAND_OVERS: Duration = Duration::from_millis(100);

#[derive(Debug)]
pub(super) enum HostEvent {
    /// The camera at the playhead, its frame, and the reason.
    View(Pose, f64, Reason),
    /// The frame of the scene at the playhead, and the reason.
    Frame(f64, Reason),
    Changed,
    /// The host takes all poses.
    HandOver,
}

/// What the host knows already.
#[derive(Debug, Default)]
pub(super) struct Live {
    seen: Option<PlayheadState>,
    view: Notified<(Pose, f64)>,
    /// The revision and the frame: after a change, the same frame may look different.
    frame: Notified<(u64, f64)>,
    /// The last step that the host knows of.
    step: Option<(u64, u64)>,
    /// When the next step may be reported.
    steps: Clock,
    /// Whether the host wants these calls.
    watches: bool,
    /// The revision of the path whose poses the host has.
    handed: Option<u64>,
    next_hand_over: Option<Instant>,
    /// No calls until then.
    busy: Option<Instant>,
}

/// When the next call of this kind may come.
#[derive(Debug, Default)]
struct Clock(Option<Instant>);

impl Clock {
    fn is_due(&self, now: Instant) -> bool {
        self.0.is_none_or(|at| now >= at)
    }

    /// Notes a call. A call that is slightly late because of a frame does not delay the next one.
    fn strike(&mut self, now: Instant) {
        let tick = self.0.filter(|at| now < *at + FRAME / 2);
        self.0 = Some(tick.unwrap_or(now) + FRAME);
    }
}

/// What the host knows of a value that follows the pointer.
#[derive(Debug, Default)]
struct Notified<T> {
    /// The reason for a call that is due.
    waits: Option<Reason>,
    last: Option<T>,
    clock: Clock,
    /// When to report that nothing moves.
    rest: Option<Instant>,
}

impl<T: Copy + PartialEq> Notified<T> {
    /// What to report now, if it differs from the last report.
    fn next(&mut self, now: Instant, what: impl FnOnce() -> Option<T>) -> Option<(T, Reason)> {
        if !self.clock.is_due(now) {
            return None;
        }
        let reason = self.waits.take()?;
        let what = what()?;
        if self.last.replace(what) == Some(what) {
            return None;
        }
        self.clock.strike(now);
        self.rest = Some(now + REST);
        Some((what, reason))
    }

    /// What to report once nothing moves any more.
    fn at_rest(
        &mut self,
        now: Instant,
        moves: bool,
        what: impl FnOnce() -> Option<T>,
    ) -> Option<T> {
        if moves {
            self.rest = self.rest.map(|_| now + REST);
            return None;
        }
        self.rest.take_if(|rest| now >= *rest)?;
        self.last = what().or(self.last);
        self.last
    }

    /// When something may be due, if not now.
    fn due(&self) -> Option<Instant> {
        self.waits.and(self.clock.0)
    }

    /// Host code changed the value.
    fn known(&mut self) {
        if self.waits.is_none() {
            // The last report is no longer current.
            self.last = None;
        }
    }
}

impl Live {
    /// For a new window, whose path the host knows.
    pub(super) fn new(editor: &Editor) -> Self {
        let mut new = Self {
            step: Some(editor.step_number()),
            ..Self::default()
        };
        new.look(editor);
        if editor.keeps_host_view() {
            new.view.waits = None;
        }
        new
    }

    /// The next call into the host, if any; only poses unless the host watches. `held`: a button is
    /// held.
    pub(super) fn next(
        &mut self,
        editor: &Editor,
        watches: bool,
        held: bool,
        now: Instant,
    ) -> Option<HostEvent> {
        self.look(editor);
        self.watches = watches;
        let moves = held || editor.is_under_way();
        if self.busy.is_some_and(|busy| now < busy) {
            return None;
        }
        self.busy = None;
        if self.owes_step(editor) && self.steps.is_due(now) {
            self.step = Some(editor.step_number());
            if watches {
                self.steps.strike(now);
                return Some(HostEvent::Changed);
            }
        }
        // A path that cannot be sampled has no poses; the window shows why.
        let view = || editor.view().ok();
        let frame = || Some((editor.document().revision(), editor.frame().ok()?));
        if watches && let Some(((pose, at), reason)) = self.view.next(now, view) {
            return Some(HostEvent::View(pose, at, reason));
        }
        if watches && let Some(((_, at), reason)) = self.frame.next(now, frame) {
            return Some(HostEvent::Frame(at, reason));
        }
        if self.owes_poses(editor) && self.next_hand_over.is_none_or(|at| now >= at) {
            self.handed = Some(editor.document().revision());
            self.next_hand_over = Some(now + BETWEEN_HAND_OVERS);
            return Some(HostEvent::HandOver);
        }
        if let Some((pose, at)) = self.view.at_rest(now, moves, view) {
            return Some(HostEvent::View(pose, at, Reason::Rested));
        }
        let (_, at) = self.frame.at_rest(now, moves, frame)?;
        Some(HostEvent::Frame(at, Reason::Rested))
    }

    /// Notes what has changed since the last time.
    fn look(&mut self, editor: &Editor) {
        let standing = editor.standing();
        let reason = match self.seen.replace(standing) {
            None => Some(Reason::Selected),
            Some(before) => (before != standing).then(|| standing.reason(&before)),
        };
        self.view.waits = reason.or(self.view.waits);
        self.frame.waits = reason.or(self.frame.waits);
        if !editor.auto_hand_over() {
            self.handed = None;
        }
    }

    fn owes_poses(&self, editor: &Editor) -> bool {
        editor.auto_hand_over() && self.handed != Some(editor.document().revision())
    }

    fn owes_step(&self, editor: &Editor) -> bool {
        !editor.document().in_step() && self.step != Some(editor.step_number())
    }

    /// When something is due without input from the screen.
    pub(super) fn due(&self, editor: &Editor, held: bool) -> Option<Instant> {
        let moves = held || editor.is_under_way();
        let rest = [self.view.rest, self.frame.rest];
        let rest = rest.into_iter().flatten().min().filter(|_| !moves);
        let told = [
            self.owes_step(editor).then_some(self.steps.0).flatten(),
            self.view.due(),
            self.frame.due(),
        ];
        let told = told.into_iter().flatten().filter(|_| self.watches).min();
        let poses = self.owes_poses(editor).then_some(self.next_hand_over);
        let next = [told, poses.flatten(), rest].into_iter().flatten().min();
        // Nothing while the host is left alone; afterwards whatever is due.
        self.busy
            .map_or(next, |busy| Some(next.map_or(busy, |at| at.max(busy))))
    }

    /// A call into the host, or its preparation, has ended.
    pub(super) fn called(&mut self, took: Duration, now: Instant) {
        if took > SLOW {
            self.busy = Some(now + took);
        }
    }

    /// Lets host code change something within a call; only changes that are not reported yet remain
    /// due.
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
        self.view.known();
        self.frame.known();
        if step {
            self.step = Some(editor.step_number());
        }
        if poses && editor.auto_hand_over() {
            self.handed = Some(editor.document().revision());
        }
        done
    }
}
