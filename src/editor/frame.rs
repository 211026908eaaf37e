//! The layout: menu bar with the output field, panels on the left, the
//! movement window in the middle, sub-windows above.

use super::state::Editor;
use super::{keys, menu, panels, space, theme, windows};

/// Width of the panels, in points.
const PANELS: f32 = 264.0;

/// Shows everything.
pub(super) fn show(editor: &mut Editor, ui: &mut egui::Ui) {
    ui.ctx().set_theme(editor.setup.theme.of_egui());
    egui::Panel::top("menu").show(ui, |ui| {
        egui::MenuBar::new().ui(ui, |ui| menu::show(editor, ui));
    });
    egui::Panel::left("panels")
        .resizable(false)
        .exact_size(PANELS)
        .show(ui, |ui| panels::show(editor, ui));
    egui::CentralPanel::default()
        .frame(egui::Frame::new().fill(editor.background()))
        .show(ui, |ui| space::show(editor, ui));
    windows::show(editor, ui.ctx());
    keys::remember_typing(ui.ctx());
}
