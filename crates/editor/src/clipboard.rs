//! Points by the clipboard, between windows and programs, and files dropped on the window.
//!
//! The clipboard has points as the text of a `.vid` file. A view that was copied is there as text,
//! too, so that what was copied last is what is pasted; it is pasted in its own window only.

use std::path::PathBuf;

use egui::{Context, ViewportCommand};
use vides_document::Document;
use vides_engine::limits::MIN_POINTS;

use crate::action::{Action, FileAction};
use crate::files::{is_object, readable};
use crate::state::files::{AfterSave, Purpose};
use crate::state::scene_view::NodeCommand;
use crate::state::selected::SelectionChange;
use crate::state::{Copied, Editor};
use crate::texts::fill;
use crate::texts::refusals::of_edit;

/// Whether a text is keys: nodes are a file, which begins with its version.
pub(crate) fn is_keys(text: &str) -> bool {
    text.contains("[[node.track]]") && !text.trim_start().starts_with("version")
}

impl Editor {
    /// Copies the points that are selected together, else the current orientation.
    pub(crate) fn copy(&mut self, context: &Context) {
        if !self.document.edits_path() {
            self.copy_nodes_out(context);
            return;
        }
        if self.several().is_some() {
            self.copy_points(context);
            return;
        }
        let Some(view) = self.orientation().cloned() else {
            return;
        };
        match Document::view_as_text(&view) {
            Ok(text) => {
                context.copy_text(text.clone());
                self.copied = Some(Copied { view, text });
                self.say(self.texts().output.copied);
            }
            Err(error) => self.complain_of(&error),
        }
    }

    fn copy_points(&mut self, context: &Context) -> bool {
        let points = self.all_selected();
        match self.document.points_as_text(&points) {
            Ok(text) => {
                context.copy_text(text);
                self.say(fill(self.texts().output.points_copied, &[&points.len()]));
                true
            }
            Err(error) => {
                self.complain_of(&error);
                false
            }
        }
    }

    /// Copies the points that are selected together, and removes them.
    pub(crate) fn cut(&mut self, context: &Context) {
        if !self.document.edits_path() {
            return self.cut_nodes(context);
        }
        let Some(chosen) = self.several().map(<[usize]>::len) else {
            return self.complain(self.texts().output.nothing_to_cut);
        };
        let left = self.document.path().points.len() - chosen;
        // Nothing is copied if it has to stay, which is told.
        if left < MIN_POINTS || self.copy_points(context) {
            let said = self.message.take();
            self.remove_selected();
            self.message = self.message.take().or(said);
        }
    }

    /// Asks for what the clipboard has; it comes as [`Action::Pasted`].
    pub(crate) fn ask_for_clipboard(context: &Context) {
        context.send_viewport_cmd(ViewportCommand::RequestPaste);
    }

    /// Inserts the points in a text after the current one, unmoved, or pastes the view whose text
    /// it is.
    pub(crate) fn pasted(&mut self, text: &str) {
        if is_keys(text) && self.document.edited_scene().is_some() {
            return self.paste_keys(text);
        }
        if !self.document.edits_path() {
            return self.do_to_nodes(NodeCommand::Paste(text.to_owned()));
        }
        let copied = self.copied.as_ref();
        if text.is_empty() || copied.is_some_and(|copied| copied.text.trim() == text.trim()) {
            self.paste_view();
            return;
        }
        // Nodes are nodes wherever they are pasted; of points each belongs to a path of its own.
        if !text.contains("[[point]]") && self.paste_nodes(text) {
            return;
        }
        let texts = &self.texts().output;
        let block = match Document::points_of_text(text) {
            Ok(Some(block)) => block,
            Ok(None) => return self.complain(texts.no_points),
            Err(error) => {
                let why = self.without_name(&error);
                return self.complain(fill(texts.not_pasted, &[&why]));
            }
        };
        let replaces = self.begins();
        let before = self.document.path().points.len();
        let done = match replaces {
            true => self.document.replace_by_points(&block, self.fixed_speeds),
            false => {
                let at = self.document.selection().point;
                self.document
                    .paste_points(at, &block, self.times_are_fixed())
            }
        };
        if let Err(error) = done {
            let why = of_edit(self.language(), &error);
            return self.complain(fill(texts.not_pasted, &[&why]));
        }
        self.playing.leave();
        let first = self.document.selection().point;
        let count = self.document.path().points.len();
        let count = if replaces { count } else { count - before };
        self.choose(SelectionChange::These((first..first + count).collect()));
        self.say_done(fill(self.texts().output.points_pasted, &[&count]));
    }

    /// Puts the view that was copied in place of the current one.
    pub(crate) fn paste_view(&mut self) {
        match self.copied.clone() {
            Some(Copied { view, .. }) => self.set_orientation(|current| *current = view),
            None => self.complain(self.texts().output.nothing_copied),
        }
    }

    /// Opens a file that was dropped: a path after a question, a mesh as the object; all else is
    /// imported.
    pub(crate) fn dropped(&mut self, files: &[PathBuf], context: &Context) {
        let texts = &self.texts().files;
        let [file] = files else {
            return self.complain(texts.one_file);
        };
        // What is on another machine, or no file, keeps its URI.
        if !file.is_absolute() {
            return self.complain(fill(texts.not_here, &[&readable(file.as_os_str())]));
        }
        let ending = file.extension().unwrap_or_default().to_ascii_lowercase();
        if ending == "vid" {
            self.windows.dropped = Some(file.clone());
            self.ask_before(AfterSave::Dropped);
        } else {
            let purpose = match is_object(file) {
                true => Purpose::LoadObject(None),
                false => Purpose::Import,
            };
            let chosen = FileAction::FileChosen(purpose, file.clone());
            self.act(Action::File(chosen), context);
        }
    }

    /// Opens the path that was dropped; what was unsaved is no more.
    pub(crate) fn load_dropped(&mut self) {
        if let Some(file) = self.windows.dropped.take() {
            self.file_chosen(Purpose::LoadPath, &file);
        }
    }
}

#[cfg(test)]
#[path = "clipboard_tests.rs"]
mod tests;
