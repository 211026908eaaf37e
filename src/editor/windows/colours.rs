//! The colours of the movement window (thesis A.5).

use super::{SubWindow, Windows, sub_window};
use crate::editor::state::Editor;

/// The colours of the movement window (thesis A.5).
#[derive(Debug)]
pub(in crate::editor) struct ColourWindow {}

impl SubWindow for ColourWindow {
    const ID: &'static str = "colours";

    fn slot(windows: &mut Windows) -> &mut Option<Self> {
        &mut windows.colours
    }

    fn new(_: &Editor) -> Self {
        Self {}
    }

    fn show(&mut self, editor: &mut Editor, context: &egui::Context) -> bool {
        let texts = &editor.texts().colours;
        sub_window(context, Self::ID, texts.title, |ui| {
            ui.set_min_width(240.0);
        })
    }
}
