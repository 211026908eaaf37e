//! The menu bar.

use super::actions::Action;
use super::state::Editor;

/// Shows the menus.
pub(super) fn show(editor: &mut Editor, ui: &mut egui::Ui) {
    let texts = &editor.texts().menu;
    let entries = [
        (texts.undo, Action::Undo),
        (texts.redo, Action::Redo),
        (texts.colours, Action::Colours),
        (texts.display, Action::Display),
        (texts.quit, Action::Quit),
    ];
    ui.menu_button(texts.file, |ui| {
        for (text, action) in entries {
            if ui.button(text).clicked() {
                editor.act(action, ui.ctx());
            }
        }
    });
}
