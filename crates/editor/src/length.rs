//! The duration of the path: whether edits keep the times of other keys, and the sentence that says
//! that the duration is another now, with a way back.

use vides_document::StepName;
use vides_engine::path::Timeline;

use crate::state::length::Seen;
use crate::state::{Editor, Message};
use crate::texts::fill;

impl Seen {
    fn seconds(&self) -> f64 {
        self.frames as f64 / self.fps
    }
}

impl Editor {
    /// Whether all keys but those that an edit is about keep their times: as it was chosen, else
    /// unless the host fixes the speeds, which times then follow as in 1994.
    pub(super) fn times_are_fixed(&self) -> bool {
        self.setup.fixed_times.unwrap_or(!self.fixed_speeds)
    }

    /// Takes the present length as it is: what others have changed says nothing.
    pub(super) fn look_at_length(&mut self) {
        self.length.seen = self.seen(self.length.seen);
    }

    fn seen(&self, before: Option<Seen>) -> Option<Seen> {
        let state = self.step_number();
        if let Some(before) = before.filter(|before| before.state == state) {
            return Some(before);
        }
        let newest = before.filter(|before| before.state.0 == state.0);
        let newest = newest.map_or(0, |before| before.newest).max(state.1);
        let frames = self.document.timeline(Timeline::frame_count).ok()?.ok()?;
        Some(Seen {
            state,
            newest,
            node: self.document.edited_scene().and_then(|scene| scene.node()),
            frames,
            fps: self.document.info().fps,
        })
    }

    /// After each action: says that the path's length is another now.
    pub(super) fn settle_length(&mut self) {
        if self.document.in_step() {
            return;
        }
        let before = self.length.seen;
        let now = self.seen(before);
        self.length.seen = now;
        let (Some(before), Some(now)) = (before, now) else {
            return;
        };
        let same = before.state.0 == now.state.0 && before.node == now.node;
        if !same || now.state.1 <= before.newest {
            // Another path, or one that was there before.
            return;
        }
        self.tell_step(self.document.step_names()[0]);
        if before.seconds() != now.seconds() {
            self.tell_length(before, now);
        }
    }

    /// Says what has been added, removed or made, unless more has been said of it.
    fn tell_step(&mut self, step: Option<StepName>) {
        let tells = matches!(
            step,
            Some(
                StepName::Tool(_)
                    | StepName::InsertPoint
                    | StepName::InsertPoints
                    | StepName::RemovePoint
                    | StepName::InsertOrientation
                    | StepName::RemoveOrientation
                    | StepName::MovePoint
            )
        );
        if let Some(step) = step.filter(|_| tells && self.message.is_none()) {
            let name = self.language().step(step);
            let mut letters = name.chars();
            let first = letters.next().into_iter().flat_map(char::to_uppercase);
            self.say_done(first.chain(letters.clone()).collect());
        }
    }

    /// Says how the length has changed, behind what is said already.
    fn tell_length(&mut self, before: Seen, now: Seen) {
        let decimals = if (before.seconds() - now.seconds()).abs() < 0.01 {
            4
        } else {
            2
        };
        let seconds = |seen: Seen| self.language().number(seen.seconds(), decimals);
        let texts = &self.texts().output;
        // A scene ends when everything in it has ended.
        let text = match self.document.edited_scene() {
            Some(_) => texts.path_length_changed,
            None => texts.length_changed,
        };
        let change = fill(text, &[&seconds(now), &seconds(before)]);
        let (text, error) = match self.message.take() {
            Some(said) => (format!("{} · {change}", said.text), said.error),
            None => (change, false),
        };
        self.message = Some(Message {
            text,
            error,
            undoes: Some(now.state.1),
        });
    }
}

#[cfg(test)]
#[path = "length_tests.rs"]
mod tests;
