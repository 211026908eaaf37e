//! What can be asked for of the open tool.

use egui::Pos2;
use glam::DVec3;
use vides_document::tool::Tool;

/// What opens, shapes and ends a tool.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum ToolAction {
    /// Open it.
    Open(Tool),
    /// Show the path with the tool applied.
    Preview,
    /// Show what the tool has made beside the window.
    Made,
    /// Move a control point of the tool's cage.
    MoveControl { at: usize, place: DVec3 },
    /// Continue the line being drawn for the tool: in the camera's picture, and in space.
    DrawOn(Pos2, DVec3),
    /// Take or give up that line.
    EndDrawing { keeps: bool },
    /// Give the tool a line that was drawn.
    Stroke(Vec<DVec3>),
    /// `OK` of the tool, or its cancellation.
    End { keeps: bool },
}
