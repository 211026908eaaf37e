//! The speed curve of the current section, large (thesis A.4.3).

use super::{SubWindow, Windows, sub_window};
use crate::editor::state::Editor;

/// The speed curve of the current section, large (thesis A.4.3).
#[derive(Debug)]
pub(in crate::editor) struct SpeedWindow {}

impl SubWindow for SpeedWindow {
    const ID: &'static str = "speed";

    fn slot(windows: &mut Windows) -> &mut Option<Self> {
        &mut windows.speed
    }

    fn new(_: &Editor) -> Self {
        Self {}
    }

    fn show(&mut self, editor: &mut Editor, context: &egui::Context) -> bool {
        let texts = &editor.texts().speed_window;
        sub_window(context, Self::ID, texts.title, |ui| {
            ui.set_min_width(240.0);
        })
    }
}
