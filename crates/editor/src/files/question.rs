//! The questions before unsaved work is lost, or a file changed elsewhere since it was read here.

use egui::{Button, Key, Modifiers, vec2};

use crate::actions::Action;
use crate::files::{Then, short};
use crate::state::Editor;
use crate::texts::fill;
use crate::windows::{modal, row_at_right};

#[derive(Debug)]
pub(crate) struct Question {
    about: About,
    fresh: bool,
}

#[derive(Clone, Copy, Debug)]
enum About {
    Unsaved(Then),
    Changed(Option<Then>),
    /// Another program has written the file.
    Newer,
}

/// An answer: its words, its hint, what it does.
type Answer = (&'static str, &'static str, Option<Action>);

impl Question {
    /// Unsaved work would be lost.
    pub(crate) fn unsaved(then: Then) -> Self {
        let about = About::Unsaved(then);
        Self { about, fresh: true }
    }

    /// The file would be overwritten.
    pub(crate) fn changed(then: Option<Then>) -> Self {
        let about = About::Changed(then);
        Self { about, fresh: true }
    }

    /// The file could be read again.
    pub(crate) fn newer() -> Self {
        let about = About::Newer;
        Self { about, fresh: true }
    }

    pub(crate) fn show(
        &mut self,
        editor: &Editor,
        context: &egui::Context,
        actions: &mut Vec<Action>,
    ) -> bool {
        let (texts, files) = (&editor.texts().questions, &editor.texts().files);
        let name = editor.file.as_deref().map(short);
        let cancel = (texts.cancel, texts.cancel_hint, None);
        match self.about {
            About::Unsaved(then) => {
                let text = match then {
                    Then::Close => texts.before_close,
                    Then::Load | Then::Recent(_) => texts.before_load,
                    Then::Restore(_) => texts.before_restore,
                };
                let name = name.unwrap_or_else(|| texts.this_path.to_owned());
                let save = Action::SaveBefore(then);
                let discard = Action::GoOn(then);
                let answers = [
                    (texts.save, texts.save_hint, Some(save)),
                    (texts.discard, texts.discard_hint, Some(discard)),
                    cancel,
                ];
                let place = ("question", texts.unsaved, 380.0, 96.0);
                self.ask(context, place, &fill(text, &[&name]), answers, 0, actions)
            }
            About::Newer => {
                let Some(name) = name else {
                    return false;
                };
                let answers = [
                    (texts.reload, texts.reload_hint, Some(Action::Reload)),
                    (texts.keep, texts.keep_hint, None),
                ];
                let modified = editor.document.is_modified();
                let text = if modified {
                    texts.newer_unsaved
                } else {
                    texts.newer
                };
                let place = ("changed", texts.changed, 420.0, 112.0);
                // The keyboard is at the answer that loses nothing.
                let first = usize::from(modified);
                self.ask(
                    context,
                    place,
                    &fill(text, &[&name]),
                    answers,
                    first,
                    actions,
                )
            }
            About::Changed(then) => {
                let Some(name) = name else {
                    return false;
                };
                let (overwrite, hint) = (files.overwrite, files.overwrite_hint);
                let save_as = Action::SaveAsBefore(then);
                let answers = [
                    (texts.reload, texts.reload_hint, Some(Action::Reload)),
                    (texts.save_as, texts.save_as_hint, Some(save_as)),
                    (overwrite, hint, Some(Action::Overwrite(then))),
                    cancel,
                ];
                let text = fill(texts.changed_since, &[&name]);
                let place = ("changed", texts.changed, 480.0, 112.0);
                // The keyboard is at the answer that loses nothing.
                self.ask(context, place, &text, answers, 1, actions)
            }
        }
    }

    /// Asks in a window with this name, title, width and least button width, `first` focused.
    fn ask<const N: usize>(
        &mut self,
        context: &egui::Context,
        (id, title, width, least): (&'static str, &str, f32, f32),
        text: &str,
        answers: [Answer; N],
        first: usize,
        actions: &mut Vec<Action>,
    ) -> bool {
        let mut open = true;
        modal(context, id, title, width, |ui| {
            ui.label(text);
            ui.add_space(8.0);
            let words = answers.each_ref().map(|&(text, ..)| text);
            row_at_right(ui, &words, least, |ui| {
                for (number, (text, hint, action)) in answers.into_iter().enumerate() {
                    let button = Button::new(text).min_size(vec2(least, 28.0));
                    let response = ui.add(button).on_hover_text(hint);
                    if number == first && std::mem::take(&mut self.fresh) {
                        response.request_focus();
                    }
                    if response.clicked() {
                        open = false;
                        actions.extend(action);
                    }
                }
            });
        });
        if context.input_mut(|input| input.consume_key(Modifiers::NONE, Key::Escape)) {
            actions.clear();
            open = false;
        }
        open
    }
}
