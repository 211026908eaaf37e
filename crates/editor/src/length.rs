//! The length of the path: a change that alters it reports it, with a way back; or the
//! length is kept, and the frames of all sections adapt within the same step.

use vides_document::error::Result;
use vides_document::{Document, Edit, StepName};
use vides_engine::path::Timeline;

use crate::state::length::Seen;
use crate::state::{Editor, Message};
use crate::texts::fill;
use crate::texts::refusals::reason_of;

impl Seen {
    fn seconds(&self) -> f64 {
        self.frames as f64 / self.fps
    }
}

#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
fn frames_of(seconds: f64, fps: f64) -> usize {
    (seconds * fps).round() as usize
}

/// Brings the whole path to a number of frames.
pub(super) fn fit(document: &mut Document, frames: usize) -> Result<()> {
    if document.timeline(Timeline::frame_count)?? == frames {
        return Ok(());
    }
    let last = document.path().points.len().saturating_sub(1);
    document.apply(Edit::FitFrames {
        first: 0,
        last,
        frames,
    })
}

impl Editor {
    /// Whether the length is kept.
    pub(super) fn keeps_length(&self) -> bool {
        self.length.kept.is_some()
    }

    /// Keeps the present length from now on, or no longer.
    pub(super) fn switch_keeps_length(&mut self) {
        self.look_at_length();
        let now = self.length.seen.map(|seen| seen.seconds());
        self.length.kept = now.filter(|_| self.length.kept.is_none());
    }

    /// Takes the present length as it is: what others have changed says nothing.
    pub(super) fn look_at_length(&mut self) {
        let before = self.length.seen;
        let seen = self.seen(before);
        if let (Some(kept), Some(seen)) = (&mut self.length.kept, seen)
            && before.is_none_or(|before| before.state != seen.state)
        {
            *kept = seen.seconds();
        }
        self.length.seen = seen;
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

    /// After each action: says that the path's length is another now, or makes it what it was.
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
        let done = now.state.1 > before.newest;
        if !same || !done {
            // Another path, or one that was there before.
            if self.length.kept.is_some() && now.state != before.state {
                self.length.kept = Some(now.seconds());
            }
            return;
        }
        let step = self.document.step_names()[0];
        self.tell_step(step);
        let given = matches!(step, Some(StepName::FitFrames | StepName::Tool("frames")));
        match self.length.kept {
            Some(_) if given => self.length.kept = Some(now.seconds()),
            Some(seconds) => self.keep_length(seconds, now),
            None if !given && before.seconds() != now.seconds() => self.tell_length(before, now),
            None => {}
        }
    }

    /// Fits the frames within the step that has changed them.
    fn keep_length(&mut self, seconds: f64, now: Seen) {
        let frames = frames_of(seconds, now.fps);
        if frames == now.frames {
            return;
        }
        if let Err(error) = self.fit_newest_step(frames) {
            let text = self.texts().output.cannot_keep;
            let why = reason_of(self.language(), &error);
            self.complain(fill(text, &[&self.seconds(seconds, 2), &why]));
        }
        self.length.seen = self.seen(Some(now));
    }

    fn fit_newest_step(&mut self, frames: usize) -> Result<()> {
        self.document.reopen_step();
        let fitted = fit(&mut self.document, frames);
        self.document.end_step();
        fitted
    }

    /// The frames that the path keeps.
    pub(super) fn kept_frames(&self) -> Option<usize> {
        let seconds = self.length.kept?;
        Some(frames_of(seconds, self.document.info().fps))
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
        let [from, to] = [before, now].map(|seen| self.seconds(seen.seconds(), decimals));
        let change = fill(self.texts().output.length_changed, &[&from, &to]);
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

    fn seconds(&self, seconds: f64, decimals: usize) -> String {
        format!("{} s", self.language().number(seconds, decimals))
    }
}

#[cfg(test)]
mod tests {
    use crate::action::Action;
    use crate::entry::Entry;
    use crate::state::with;
    use crate::tests::*;
    use vides_document::{At, Edit, Selection};
    use vides_engine::path::Timeline;

    fn frames(window: &Window) -> usize {
        let document = &window.state().document;
        document.timeline(Timeline::frame_count).unwrap().unwrap()
    }

    fn hold(window: &Window, frames: u32) -> Edit {
        let editor = window.state();
        let at = editor.document.selection();
        with(at, editor.orientation().unwrap(), |key| key.hold = frames)
    }

    fn act(window: &mut Window, action: Action) {
        let context = window.ctx.clone();
        window.state_mut().act(action, &context);
        window.run();
    }

    fn window_of_300_frames(language: Language) -> Window {
        let mut document = some_points();
        let last = document.path().points.len() - 1;
        let fit = Edit::FitFrames {
            first: 0,
            last,
            frames: 300,
        };
        document.apply(fit).unwrap();
        let options = Options {
            document: document.as_opened(),
            ..options(language)
        };
        window_of(options, LARGE, 1.0, Theme::Dark)
    }

    /// 300 frames at 25 a second are 12 s; a hold of 30 makes them 13.2 s.
    #[test]
    fn a_change_of_the_length_says_so_and_is_undone_from_there() {
        for (language, text) in [
            (Language::English, "Now 13.20 s instead of 12.00 s"),
            (Language::German, "Jetzt 13,20 s statt 12,00 s"),
        ] {
            let mut window = window_of_300_frames(language);
            let edit = hold(&window, 30);
            act(&mut window, Action::Edit(edit));
            assert_eq!(said(&window).as_deref(), Some(text));
            click_button(&mut window, |texts| texts.menu.undo);
            assert_eq!((frames(&window), said(&window)), (300, None));
            assert!(!window.state().document.can_undo());
            // A drag says it once at its end, and where nothing changes nothing is said.
            let context = window.ctx.clone();
            let drags = [10, 40, 30].map(|frames| Entry::Drag(hold(&window, frames)));
            let editor = window.state_mut();
            for entry in std::iter::once(Entry::Begin).chain(drags) {
                editor.act(Action::Enter(entry), &context);
                assert_eq!(editor.message, None);
            }
            act(&mut window, Action::Enter(Entry::End));
            assert_eq!(said(&window).as_deref(), Some(text));
            let name = Edit::set(At::Point(0), "name", "A".to_owned());
            act(&mut window, Action::Edit(name));
            assert_eq!(said(&window), None);
            // Who types the length knows it.
            enter(&mut window, language.texts().space.duration, "14");
            assert_eq!((frames(&window), said(&window)), (350, None));
        }
    }

    #[test]
    fn a_padlock_keeps_the_length_within_the_same_step() {
        for language in BOTH {
            let texts = language.texts();
            let mut window = window_of_300_frames(language);
            click(&mut window, texts.space.keep_length);
            assert!(!window.state().document.is_modified());
            let edits = [
                hold(&window, 30),
                Edit::InsertOrientation {
                    point: 0,
                    at: 1,
                    orientation: None,
                },
                Edit::AppendAfterLast,
                Edit::RemovePoint { at: 1 },
                Edit::set(At::Path, "closed", true),
                Edit::Repeat(2),
            ];
            for (at, edit) in edits.into_iter().enumerate() {
                let before = window.state().document.path().clone();
                act(&mut window, Action::Edit(edit));
                assert_eq!(frames(&window), 300, "{at}");
                // What was added or removed, and nothing of the length.
                let told = [
                    None,
                    Some("new view"),
                    Some("new point"),
                    Some("removing a point"),
                ];
                let said = said(&window).map(|said| said.to_lowercase());
                if language == Language::English {
                    assert_eq!(said.as_deref(), told.get(at).copied().flatten(), "{at}");
                }
                let after = window.state().document.path().clone();
                assert_ne!(before, after, "{at}");
                press(&mut window, Modifiers::CTRL, Key::Z);
                assert_eq!(window.state().document.path(), &before, "{at}");
                press(&mut window, Modifiers::CTRL, Key::Y);
                assert_eq!(window.state().document.path(), &after, "{at}");
            }
            // So it does at another rate: 12 s of 50 frames.
            enter(&mut window, texts.space.rate, "50");
            assert_eq!(frames(&window), 600);
            // Another length that is typed is kept from now on.
            enter(&mut window, texts.space.duration, "10");
            act(&mut window, Action::Select(Selection::at(3, 0)));
            let edit = hold(&window, 100);
            act(&mut window, Action::Edit(edit));
            assert_eq!(frames(&window), 500);
            // A rest that is longer than all of it cannot be kept, and it says why.
            let edit = hold(&window, 5000);
            act(&mut window, Action::Edit(edit));
            assert!(frames(&window) > 5000);
            let text = said(&window).unwrap();
            let begin = fill(
                texts.output.cannot_keep,
                &[&format!("{} s", language.number(10.0, 2)), &""],
            );
            assert!(text.starts_with(&begin) && text.contains("500"), "{text}");
            assert!(window.state().document.can_undo());
            press(&mut window, Modifiers::CTRL, Key::Z);
            assert_eq!(frames(&window), 500);
            // Opened again it lets go.
            click(&mut window, texts.space.keep_length);
            let edit = hold(&window, 110);
            act(&mut window, Action::Edit(edit));
            assert_eq!(frames(&window), 510);
        }
    }
}
