//! A line that the left button draws, for a tool that waits for one.

use egui::{Event, Key, Modifiers, PointerButton, Pos2};
use glam::DVec3;

use super::pointer::PointerContext;
use super::projection::from_pos;
use super::projection_of;
use crate::actions::Action;
use crate::state::Editor;
use crate::windows::ToolWindow;

/// What was drawn so far.
#[derive(Debug)]
pub(super) struct Drawing(Vec<DVec3>);

/// A tool waits for a line.
pub(super) fn is_wanted(editor: &Editor) -> bool {
    let tool = editor.windows.tool.as_ref();
    tool.is_some_and(ToolWindow::draws)
}

/// What a line leads through that is drawn at `pos`: as deep as the current point, and
/// within the space.
fn place(editor: &Editor, surface: &PointerContext<'_>, pos: Pos2) -> DVec3 {
    let projection = projection_of(editor, surface.viewport);
    let space = projection.space();
    let point = editor.point().map_or(space.centre, |point| point.position);
    let place = projection.point_facing(point, from_pos(pos));
    place.clamp(space.low(), space.high())
}

impl Drawing {
    pub(super) fn begin(editor: &Editor, surface: &PointerContext<'_>, pos: Pos2) -> Self {
        Self(vec![place(editor, surface, pos)])
    }

    pub(super) fn places(&self) -> &[DVec3] {
        &self.0
    }

    /// Takes what the hand does; the line, or none once it is over.
    pub(super) fn take(
        mut self,
        editor: &Editor,
        surface: &PointerContext<'_>,
        event: &Event,
        actions: &mut Vec<Action>,
    ) -> Option<Self> {
        match *event {
            Event::PointerMoved(pos) => self.0.push(place(editor, surface, pos)),
            Event::PointerButton {
                button: PointerButton::Primary,
                pressed: false,
                ..
            } => {
                if self.0.len() > 2 {
                    actions.push(Action::Stroke(self.0));
                }
                return None;
            }
            Event::Key {
                key: Key::Escape,
                pressed: true,
                ..
            } => {
                (surface.context)
                    .input_mut(|input| input.consume_key(Modifiers::NONE, Key::Escape));
                return None;
            }
            _ => {}
        }
        Some(self)
    }
}
