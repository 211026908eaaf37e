//! The layout: menu bar with the output field, panels on the left, the
//! movement window in the middle, sub-windows above.

use super::state::Editor;
use super::{panels, space, windows};

/// Shows everything.
pub(super) fn show(editor: &mut Editor, ui: &mut egui::Ui) {
    egui::Panel::left("panels")
        .resizable(false)
        .show(ui, |ui| panels::show(editor, ui));
    egui::CentralPanel::default().show(ui, |ui| space::show(editor, ui));
    windows::show(editor, ui.ctx());
}
