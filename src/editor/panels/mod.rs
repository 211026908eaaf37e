//! The panels on the left, one file each.

use super::state::Editor;

/// Shows the panels from top to bottom.
pub(super) fn show(editor: &mut Editor, ui: &mut egui::Ui) {
    ui.strong(editor.texts().position.heading);
}
