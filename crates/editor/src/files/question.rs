//! The questions before unsaved work is lost, or a file changed elsewhere since it was read here.

use std::ffi::OsStr;
use std::path::Path;

use egui::{Button, vec2};
use vides_engine::path::Up;

use crate::action::{Action, FileAction};
use crate::files::{readable, short};
use crate::keys;
use crate::state::Editor;
use crate::state::files::{About, AfterSave, Question};
use crate::texts::fill;
use crate::windows::sub_window::{modal, row_at_right, takes_keyboard};

/// Files that a question names at most.
const MAX_NAMED: usize = 8;

/// An answer: its words, its hint, what it does.
type Answer = (&'static str, &'static str, Option<Action>);

struct Parts {
    /// The window's name, title, width and least button width.
    place: (&'static str, &'static str, f32, f32),
    text: String,
    answers: Vec<Answer>,
    /// The answer that loses nothing, by its number: the keyboard is there.
    safe: usize,
}

impl Question {
    /// Unsaved work would be lost.
    pub(crate) fn unsaved(then: AfterSave) -> Self {
        let about = About::Unsaved(then);
        Self { about, fresh: true }
    }

    /// The file would be overwritten.
    pub(crate) fn changed(then: Option<AfterSave>) -> Self {
        let about = About::Changed(then);
        Self { about, fresh: true }
    }

    /// The file could be read again.
    pub(crate) fn newer() -> Self {
        let about = About::Newer;
        Self { about, fresh: true }
    }

    /// Which axis is up in a file that does not say.
    pub(crate) fn upright(file: &Path) -> Self {
        let about = About::Upright(file.to_owned());
        Self { about, fresh: true }
    }

    /// Whether files are read that the open one names outside its folder.
    pub(crate) fn outside(named: Vec<String>) -> Self {
        let about = About::Outside(named);
        Self { about, fresh: true }
    }

    /// What is lost in a file of another program's format.
    pub(crate) fn losses(file: &Path, format: &'static str, lost: Vec<String>) -> Self {
        let about = About::Losses {
            file: file.to_owned(),
            format,
            lost,
        };
        Self { about, fresh: true }
    }

    pub(crate) fn show(
        &mut self,
        editor: &Editor,
        context: &egui::Context,
        actions: &mut Vec<Action>,
    ) -> bool {
        let Some(parts) = self.parts(editor) else {
            return false;
        };
        self.ask(context, parts, actions)
    }

    /// What it shows; none if what it is about is gone.
    fn parts(&self, editor: &Editor) -> Option<Parts> {
        let (texts, files) = (&editor.texts().questions, &editor.texts().files);
        let name = editor.file.as_deref().map(short);
        let cancel = (texts.cancel, texts.cancel_hint, None);
        let reload = (
            texts.reload,
            texts.reload_hint,
            Some(Action::File(FileAction::Reload)),
        );
        Some(match &self.about {
            &About::Unsaved(then) => {
                let text = match then {
                    AfterSave::Close => texts.before_close,
                    AfterSave::New => texts.before_new,
                    AfterSave::Load
                    | AfterSave::Example
                    | AfterSave::Recent(_)
                    | AfterSave::Dropped => texts.before_load,
                    AfterSave::Restore(_) => texts.before_restore,
                };
                let name = name.unwrap_or_else(|| texts.this_path.to_owned());
                let (save, discard) = (
                    Action::File(FileAction::SaveBefore(then)),
                    Action::File(FileAction::GoOn(then)),
                );
                Parts {
                    place: ("question", texts.unsaved, 380.0, 96.0),
                    text: fill(text, &[&name]),
                    answers: vec![
                        cancel,
                        (texts.discard, texts.discard_hint, Some(discard)),
                        (texts.save, texts.save_hint, Some(save)),
                    ],
                    safe: 2,
                }
            }
            About::Newer => {
                let modified = editor.document().is_modified();
                let text = if modified {
                    texts.newer_unsaved
                } else {
                    texts.newer
                };
                Parts {
                    place: ("changed", texts.changed, 420.0, 112.0),
                    text: fill(text, &[&name?]),
                    answers: vec![(texts.keep, texts.keep_hint, None), reload],
                    safe: usize::from(!modified),
                }
            }
            &About::Changed(then) => {
                let (save_as, overwrite) = (
                    Action::File(FileAction::SaveAsBefore(then)),
                    Action::File(FileAction::Overwrite(then)),
                );
                Parts {
                    place: ("changed", texts.changed, 480.0, 112.0),
                    text: fill(texts.changed_since, &[&name?]),
                    answers: vec![
                        cancel,
                        reload,
                        (files.overwrite, files.overwrite_hint, Some(overwrite)),
                        (texts.save_as, texts.save_as_hint, Some(save_as)),
                    ],
                    safe: 3,
                }
            }
            About::Upright(file) => {
                let axis = |up, (text, hint)| {
                    let import = FileAction::ImportUpright(file.clone(), up);
                    (text, hint, Some(Action::File(import)))
                };
                Parts {
                    place: ("upright", texts.upright, 420.0, 112.0),
                    text: fill(texts.which_upright, &[&short(file)]),
                    answers: vec![
                        cancel,
                        axis(Up::Y, (texts.y_up, texts.y_up_hint)),
                        axis(Up::Z, (texts.z_up, texts.z_up_hint)),
                    ],
                    safe: 1 + usize::from(editor.document.path().space.up == Up::Z),
                }
            }
            About::Outside(named) => outside(editor, named, &name?),
            About::Losses { file, format, lost } => {
                let mut text = fill(texts.lossy, &[&short(file)]);
                for loss in lost {
                    text += &format!("\n•  {loss}");
                }
                let write = Action::File(FileAction::WriteAs(file.clone(), format));
                Parts {
                    place: ("losses", texts.losses, 480.0, 112.0),
                    text,
                    answers: vec![cancel, (files.write, texts.write_hint, Some(write))],
                    safe: 1,
                }
            }
        })
    }

    fn ask(&mut self, context: &egui::Context, parts: Parts, actions: &mut Vec<Action>) -> bool {
        let (id, title, width, least) = parts.place;
        let mut open = true;
        modal(context, id, title, width, |ui| {
            ui.label(parts.text);
            ui.add_space(8.0);
            let words: Vec<_> = parts.answers.iter().map(|&(text, ..)| text).collect();
            row_at_right(ui, &words, least, |ui| {
                for (number, (text, hint, action)) in parts.answers.into_iter().enumerate() {
                    let button = Button::new(text).min_size(vec2(least, 28.0));
                    let response = ui.add(button).on_hover_text(hint);
                    if number == parts.safe {
                        takes_keyboard(ui, &response, &mut self.fresh);
                    }
                    if response.clicked() {
                        open = false;
                        actions.extend(action);
                    }
                }
            });
        });
        if keys::consume_escape(context) {
            actions.clear();
            open = false;
        }
        open
    }
}

/// Whether files are read that the open one, of this name, names outside its folder.
fn outside(editor: &Editor, named: &[String], name: &str) -> Parts {
    let texts = &editor.texts().questions;
    let mut text = fill(texts.names_outside, &[&name]);
    for file in named.iter().take(MAX_NAMED) {
        text += &format!("\n•  {}", readable(OsStr::new(file)));
    }
    let read = Action::File(FileAction::ReadOutside);
    Parts {
        place: ("outside", texts.outside, 480.0, 112.0),
        text,
        answers: vec![
            (texts.leave_outside, texts.leave_outside_hint, None),
            (texts.read_outside, texts.read_outside_hint, Some(read)),
        ],
        safe: 0,
    }
}
