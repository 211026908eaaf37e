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
        let Some(autosave) = &mut self.autosave else {
            return;
        };
        let origin = Origin {
            program: &self.program.name,
            file: self.file.as_deref(),
            known: self.known,
        };
        let now = Duration::from_secs_f64(context.input(|input| input.time).max(0.0));
        match autosave.look_after(&self.document, unsaved, &origin, now) {
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

    /// Leaves nothing to be offered at the next start: the window closes because its user or its
    /// host wants it to. Otherwise, when the X server or the process goes away, unsaved work stays.
    pub fn forget_unsaved(&mut self) {
        if let Some(mut autosave) = self.autosave.take() {
            autosave.forget();
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
        self.document = document;
        self.windows.path_replaced();
        self.file.clone_from(&found.original);
        self.known = found.known;
        self.handed_state = None;
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
        let Some(autosave) = &mut self.autosave else {
            return Ok(());
        };
        let origin = Origin {
            program: &self.program.name,
            file: self.file.as_deref(),
            known: self.known,
        };
        autosave.write(&self.document, &origin)
    }

    /// The file that keeps unsaved work while there is some, if the window has one.
    pub fn work_file(&self) -> Option<&Path> {
        self.autosave.as_ref().map(Autosave::path)
    }
}

/// A copy without the history of what was done to it here.
fn unsaved_copy(document: &Document) -> Result<Document> {
    let mut copy = document.try_clone()?;
    copy.mark_unsaved();
    Ok(copy)
}

impl Drop for Editor {
    /// If the X server went away or the host ended, unsaved work stays for the next start, up to
    /// the last change. A user who closes the window has been asked about it, and leaves nothing.
    fn drop(&mut self) {
        let unsaved = self.is_unsaved() && !self.closing;
        if let Some(autosave) = &mut self.autosave {
            if !unsaved {
                autosave.forget();
            } else if autosave.is_behind(&self.document) {
                // Nobody is left to be told.
                let _ = self.write_work();
            }
        }
    }
}
