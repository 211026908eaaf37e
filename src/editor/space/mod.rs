//! The movement window: the path in space, and the mouse in it (thesis chapter
//! 6, A.3).

use super::state::Editor;

/// What the movement window remembers.
#[derive(Debug, Default)]
pub(super) struct Space {}

/// Shows the movement window in all the room that is left.
pub(super) fn show(editor: &mut Editor, ui: &mut egui::Ui) {
    let _ = (&editor.space, &editor.setup.view, ui);
}
