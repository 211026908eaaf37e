//! What the movement window shows (thesis A.5).

use super::{SubWindow, Windows, sub_window};
use crate::editor::state::Editor;

/// What the movement window shows (thesis A.5).
#[derive(Debug)]
pub(in crate::editor) struct DisplayWindow {}

impl SubWindow for DisplayWindow {
    const ID: &'static str = "display";

    fn slot(windows: &mut Windows) -> &mut Option<Self> {
        &mut windows.display
    }

    fn new(_: &Editor) -> Self {
        Self {}
    }

    fn show(&mut self, editor: &mut Editor, context: &egui::Context) -> bool {
        let texts = &editor.texts().display;
        sub_window(context, Self::ID, texts.title, |ui| {
            ui.set_min_width(240.0);
        })
    }
}
