//! What is done with the open tool.

use vides_document::tool::ToolInput;

use crate::action::ToolAction;
use crate::state::Editor;
use crate::state::windows::ToolWindow;

impl Editor {
    pub(super) fn tool_action(&mut self, action: ToolAction, context: &egui::Context) {
        match action {
            ToolAction::Open(tool) => {
                self.open_tool(tool);
                self.play_tour(context);
            }
            ToolAction::Made => {
                self.tool_made();
                self.play_tour(context);
            }
            ToolAction::Preview => {
                self.preview_tool();
                context.request_repaint();
            }
            ToolAction::MoveControl { at, place } => self.move_control(at, place),
            ToolAction::DrawOn(at, place) => self.draw_on(at, place),
            ToolAction::EndDrawing { keeps } => self.end_drawing(keeps),
            ToolAction::Stroke(places) => self.begin_tool_with(ToolInput::Stroke(places)),
            ToolAction::End { keeps } => self.end_tool(keeps),
        }
    }

    /// Plays a tour that has just been made.
    fn play_tour(&mut self, context: &egui::Context) {
        let made = self.windows.tool.as_ref();
        if let Some(from) = made.and_then(ToolWindow::plays_from)
            && !self.playing.is_playing()
        {
            let frame = self.document.frame_of_scene(from);
            self.stay_at(frame);
            self.play_or_pause(context);
        }
    }
}
