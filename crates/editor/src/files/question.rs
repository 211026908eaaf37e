//! The question before unsaved work is lost.

use egui::{Button, Key, Modifiers, Vec2, vec2};

use crate::actions::Action;
use crate::files::{Then, short};
use crate::state::Editor;
use crate::texts::fill;
use crate::windows::{modal, row_at_right};

/// The question, and what it stands before.
#[derive(Debug)]
pub(crate) struct Question {
    then: Then,
    fresh: bool,
}

/// A button's least size.
const BUTTON: Vec2 = vec2(96.0, 28.0);

/// The answers.
#[derive(Clone, Copy)]
enum Answer {
    Save,
    Discard,
    Cancel,
}

impl Question {
    pub(crate) fn new(then: Then) -> Self {
        Self { then, fresh: true }
    }

    /// Shows it: none until there is an answer.
    pub(crate) fn show(&mut self, editor: &Editor, context: &egui::Context) -> Option<Vec<Action>> {
        let texts = &editor.texts().questions;
        let text = match self.then {
            Then::Close => texts.before_close,
            Then::Load | Then::Recent(_) => texts.before_load,
            Then::Restore(_) => texts.before_restore,
        };
        let name = editor
            .file
            .as_deref()
            .map_or_else(|| texts.this_path.to_owned(), short);
        let mut answer = None;
        modal(context, "question", texts.unsaved, 380.0, |ui| {
            ui.label(fill(text, &[&name]));
            ui.add_space(8.0);
            let names = [texts.save, texts.discard, texts.cancel];
            row_at_right(ui, &names, BUTTON.x, |ui| {
                for (text, hint, which) in [
                    (texts.save, texts.save_hint, Answer::Save),
                    (texts.discard, texts.discard_hint, Answer::Discard),
                    (texts.cancel, texts.cancel_hint, Answer::Cancel),
                ] {
                    let button = Button::new(text).min_size(BUTTON);
                    let response = ui.add(button).on_hover_text(hint);
                    if self.fresh && matches!(which, Answer::Save) {
                        self.fresh = false;
                        response.request_focus();
                    }
                    if response.clicked() {
                        answer = Some(which);
                    }
                }
            });
        });
        if context.input_mut(|input| input.consume_key(Modifiers::NONE, Key::Escape)) {
            answer = Some(Answer::Cancel);
        }
        Some(match answer? {
            Answer::Save => vec![Action::SaveBefore(self.then)],
            Answer::Discard => vec![Action::GoOn(self.then)],
            Answer::Cancel => Vec::new(),
        })
    }
}
