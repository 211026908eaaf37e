//! Unsaved work and the window: kept while one works, offered at the start.

use std::path::Path;
use std::time::Instant;

use super::recovery::{self, Found, Keeper, Kept};
use super::state::Editor;
use super::texts::fill;
use crate::document::{Document, Edit};
use crate::error::Result;

impl Editor {
    /// Begins to keep unsaved work, if there is a folder for it, and offers
    /// what was left behind.
    pub(super) fn begin_recovery(&mut self) {
        let Some(folder) = self.folders.state.clone() else {
            return;
        };
        self.keeper = Some(Keeper::new(&folder, &self.document));
        let found = recovery::find(&folder);
        if !found.is_empty() {
            self.windows.rescue = Some(super::windows::RescueWindow::new(found));
        }
    }

    /// To be called at the end of each pass. An unmodified window, or one
    /// whose changes are all written, asks for no wake-up.
    pub(super) fn keep_work(&mut self, context: &egui::Context) {
        let Some(keeper) = &mut self.keeper else {
            return;
        };
        let file = self.file.as_deref();
        match keeper.look_after(&self.document, file, Instant::now()) {
            Kept::Idle => {}
            Kept::In(time) => context.request_repaint_after(time),
            Kept::Failed(error) => {
                let why = super::refusals::reason_of(self.language(), &error);
                let folder = self.folders.state.as_deref().unwrap_or(Path::new(""));
                let text = self.texts().rescue.not_kept;
                self.complain(fill(text, &[&folder.display(), &why]));
                context.request_repaint();
            }
        }
    }

    /// The window closes because its user or its host wants it to: nothing is
    /// to be offered at the next start. Without this call, when the window's
    /// server or its process goes away, unsaved work stays.
    pub fn forget_unsaved(&mut self) {
        if let Some(mut keeper) = self.keeper.take() {
            keeper.forget();
        }
    }

    /// Puts unsaved work that was found in place of what is open.
    ///
    /// # Errors
    /// The file is broken; what is open stays.
    pub(super) fn restore(&mut self, found: &Found) -> Result<()> {
        let mut document = found.document()?;
        if self.fixed_speeds {
            document.apply(Edit::SetSpeeds(self.document.path().speeds))?;
            document = unsaved_copy(&document)?;
        }
        self.document = document;
        self.windows.path_replaced();
        self.file.clone_from(&found.original);
        // Kept as this window's before the old file is removed.
        if let (Some(keeper), file) = (&mut self.keeper, self.file.as_deref()) {
            keeper.write(&self.document, file)?;
        }
        self.say(self.texts().rescue.restored);
        Ok(())
    }
}

/// Without the history of what was done to it here.
fn unsaved_copy(document: &Document) -> Result<Document> {
    let mut copy = document.try_clone()?;
    copy.mark_unsaved();
    Ok(copy)
}

impl Drop for Editor {
    /// What is unsaved stays for the next start, up to the last change: the
    /// X server went away, or the host ended. Closing that the user asked for
    /// leaves nothing: unsaved work was asked about then.
    fn drop(&mut self) {
        if let Some(keeper) = &mut self.keeper {
            if self.closing {
                keeper.forget();
            } else if keeper.is_behind(&self.document) {
                // Nobody is left to be told.
                let _ = keeper.write(&self.document, self.file.as_deref());
            } else if !self.document.is_modified() {
                keeper.forget();
            }
        }
    }
}
