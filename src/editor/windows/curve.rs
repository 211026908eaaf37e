//! The curve window (thesis A.4.1): presets, own values, numbers.

use super::{SubWindow, Windows, sub_window};
use crate::editor::state::Editor;

/// The curve window (thesis A.4.1): presets, own values, numbers.
#[derive(Debug)]
pub(in crate::editor) struct CurveWindow {}

impl SubWindow for CurveWindow {
    const ID: &'static str = "curve";

    fn slot(windows: &mut Windows) -> &mut Option<Self> {
        &mut windows.curve
    }

    fn new(_: &Editor) -> Self {
        Self {}
    }

    fn show(&mut self, editor: &mut Editor, context: &egui::Context) -> bool {
        let texts = &editor.texts().curve;
        sub_window(context, Self::ID, texts.title, |ui| {
            ui.set_min_width(240.0);
        })
    }
}
