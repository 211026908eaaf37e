//! The question before a file is overwritten that has changed since it was read or
//! written here.

use egui::{Button, Key, Modifiers, vec2};

use crate::actions::Action;
use crate::files::{Then, short};
use crate::state::Editor;
use crate::texts::fill;
use crate::windows::modal;

/// Size of the buttons.
const BUTTON: egui::Vec2 = vec2(112.0, 28.0);

/// The question, and what was to be done after saving.
#[derive(Debug)]
pub(crate) struct ChangedFile {
    then: Option<Then>,
    fresh: bool,
}

/// The answers.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Answer {
    Reload,
    SaveAs,
    Overwrite,
    Cancel,
}

impl ChangedFile {
    pub(crate) fn new(then: Option<Then>) -> Self {
        Self { then, fresh: true }
    }

    /// Shows it: none until there is an answer.
    pub(crate) fn show(&mut self, editor: &Editor, context: &egui::Context) -> Option<Vec<Action>> {
        let (texts, files) = (&editor.texts().questions, &editor.texts().files);
        let Some(file) = &editor.file else {
            return Some(Vec::new());
        };
        let mut answer = None;
        modal(context, "changed", texts.changed, 480.0, |ui| {
            ui.label(fill(texts.changed_since, &[&short(file)]));
            ui.add_space(8.0);
            ui.horizontal(|ui| {
                let used = 4.0 * BUTTON.x + 3.0 * ui.spacing().item_spacing.x;
                ui.add_space((ui.available_width() - used).max(0.0));
                for (text, hint, which) in [
                    (texts.reload, texts.reload_hint, Answer::Reload),
                    (texts.save_as, texts.save_as_hint, Answer::SaveAs),
                    (files.overwrite, files.overwrite_hint, Answer::Overwrite),
                    (texts.cancel, texts.cancel_hint, Answer::Cancel),
                ] {
                    let response = ui.add(Button::new(text).min_size(BUTTON));
                    let response = response.on_hover_text(hint);
                    // The one by which nobody loses anything.
                    if self.fresh && which == Answer::SaveAs {
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
            Answer::Reload => vec![Action::Reload],
            Answer::SaveAs => vec![Action::SaveAsBefore(self.then)],
            Answer::Overwrite => vec![Action::Overwrite(self.then)],
            Answer::Cancel => Vec::new(),
        })
    }
}
