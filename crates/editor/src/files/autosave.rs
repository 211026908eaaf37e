//! Joins the keeping of unsaved work to the window.

use std::path::Path;
use std::time::Duration;

use vides_document::error::Result;
use vides_document::{At, Document, Edit};

use super::recovery::{self, Autosave, Found, Origin, Saved};
use crate::state::Editor;
use crate::state::files::RecoveryWindow;
use crate::texts::fill;
use crate::texts::refusals::reason_of;

impl Editor {
    /// Begins to keep unsaved work, if there is a folder for it, and offers what was left behind.
    pub(crate) fn begin_recovery(&mut self) {
        let Some(folder) = self.folders.state.clone() else {
            return;
        };
        self.autosave = Some(Autosave::new(&folder, &self.document));
        let program = Some(self.program.name.as_str()).filter(|_| !self.program.offers_all);
        let found = recovery::find(&folder, program);
        if !found.is_empty() {
            self.windows.recovery = Some(RecoveryWindow::of(found));
        }
    }

    /// To be called at the end of each pass. Asks for no wake-up where nothing is to be written.
    pub(crate) fn keep_work(&mut self, context: &egui::Context) {
        let unsaved = self.is_unsaved();
        let document = self.windows.without_preview(&self.document);
        let Some(autosave) = &mut self.autosave else {
            return;
        };
        let origin = Origin {
            program: &self.program.name,
            file: self.file.as_deref(),
            known: self.known,
        };
        let now = Duration::from_secs_f64(context.input(|input| input.time).max(0.0));
        match autosave.look_after(document, unsaved, &origin, now) {
            Saved::Idle => {}
            Saved::In(time) => context.request_repaint_after(time),
            Saved::Failed(error) => {
                let why = reason_of(self.language(), &error);
                let folder = self.folders.state.as_deref().unwrap_or(Path::new(""));
                let text = self.texts().recovery.not_kept;
                self.complain(fill(text, &[&folder.display(), &why]));
                context.request_repaint();
            }
        }
    }

    /// Puts unsaved work that was found in place of what is open, unless the file is broken.
    pub(crate) fn restore(&mut self, found: &Found) -> Result<()> {
        let mut document = found.document()?;
        if self.fixed_speeds && document.edits_path() {
            document.apply(Edit::set(
                At::Path,
                "base_speeds",
                self.document.path().base_frames,
            ))?;
            document = unsaved_copy(&document)?;
        }
        self.take_up(document, found.original.as_deref(), found.known);
        // Kept as this window's before the old file is removed.
        self.write_work()?;
        self.say(self.texts().recovery.restored);
        Ok(())
    }

    /// Restores what the recovery window offers under this number.
    pub(crate) fn restore_found(&mut self, number: usize) {
        let Some(found) = self.take_found(number) else {
            return;
        };
        match self.restore(&found) {
            Ok(()) => found.discard(),
            Err(error) => {
                let why = reason_of(self.language(), &error);
                self.complain(fill(self.texts().recovery.broken, &[&why]));
            }
        }
    }

    /// Discards what the recovery window offers under this number.
    pub(crate) fn discard_found(&mut self, number: usize) {
        let found = self.take_found(number);
        found.into_iter().for_each(Found::discard);
    }

    /// Takes what is offered under this number; the window closes with the last.
    fn take_found(&mut self, number: usize) -> Option<Found> {
        let window = self.windows.recovery.as_mut()?;
        let found = window.found(number);
        self.windows.recovery.take_if(|window| window.is_empty());
        found
    }

    fn write_work(&mut self) -> Result<()> {
        let document = self.windows.without_preview(&self.document);
        let Some(autosave) = &mut self.autosave else {
            return Ok(());
        };
        let origin = Origin {
            program: &self.program.name,
            file: self.file.as_deref(),
            known: self.known,
        };
        autosave.write(document, &origin)
    }
}

/// A copy without the history of what was done to it here.
fn unsaved_copy(document: &Document) -> Result<Document> {
    let mut copy = document.try_clone()?;
    copy.mark_unsaved();
    Ok(copy)
}

impl Drop for Editor {
    /// Unsaved work stays for the next start, up to the last change, however the window ended. A user
    /// who closes it has been asked about that work, and leaves nothing.
    fn drop(&mut self) {
        let unsaved = self.is_unsaved() && !self.closing;
        let document = self.windows.without_preview(&self.document);
        if let Some(autosave) = &mut self.autosave {
            if !unsaved {
                autosave.forget();
            } else if autosave.is_behind(document) {
                // Nobody is left to be told.
                let _ = self.write_work();
            }
        }
    }
}
