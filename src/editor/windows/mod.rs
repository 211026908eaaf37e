//! The sub-windows, one file each. Each may stay open while work goes on.

use super::state::Editor;

/// Which of them are open, and what is pending in them.
#[derive(Debug, Default)]
pub(super) struct Windows {}

/// Shows those that are open.
pub(super) fn show(editor: &mut Editor, context: &egui::Context) {
    let _ = (&editor.windows, context);
}
