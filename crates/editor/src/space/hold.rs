//! What a held mouse button drags, and what its motion leads to.

use egui::Rect;
use glam::DVec3;

use super::drag::{self, Motion, Outcome};
use super::projection::{from_pos, scale};
use super::typed::Typed;
use super::{nodes, tangents};
use crate::action::{Action, ToolAction};
use crate::setup::View;
use crate::space::surface::projection_of;
use crate::state::Editor;
use crate::state::selected::SelectionChange;
use crate::state::space::{Gesture, Handle, Joint, PointerPress};

/// Degrees of turning for each point of motion.
const TURN: f64 = 0.35;

impl PointerPress {
    /// Whether a control point of a tool's box is held; the tool's step is open already.
    pub(super) fn controls(&self) -> bool {
        matches!(self.what, Some(Handle::Control(_)))
    }

    /// The action that moves what is held to the pointer.
    pub(super) fn pull(
        &self,
        editor: &Editor,
        viewport: Rect,
        what: Handle,
        typed: &Typed,
    ) -> Option<Action> {
        let projection = projection_of(editor, viewport);
        let motion = Motion {
            freedom: self.freedom,
            snaps: self.snaps,
            pointer: from_pos(self.now) + self.lag,
            typed: typed.number().map(|number| (self.from, number)),
            joint: match self.alone {
                true => Joint::Corner,
                false => self.joint,
            },
        };
        if let Handle::Control(at) = what {
            let place = drag::follow(
                &projection,
                place_held(editor, what)?,
                &motion,
                drag::cube(&projection),
            )?;
            return Some(Action::Tool(ToolAction::MoveControl { at, place }));
        }
        let room = match what {
            Handle::Point(at) => editor.room_of(at),
            _ => drag::cube(&projection),
        };
        match drag::outcome(&editor.document, &projection, what, &motion, room) {
            Outcome::Edit(edit) => Some(Action::Gesture(Gesture::Move(what, edit))),
            Outcome::CircleEdgeOn => Some(Action::Complain(
                editor.texts().space.circle_edge_on.to_owned(),
            )),
            Outcome::Nothing => None,
        }
    }

    /// The view turned or shifted by a drag in empty space.
    pub(super) fn turned(&self, viewport: Rect) -> View {
        let way = from_pos(self.now) - from_pos(self.pressed);
        let mut changed = self.view;
        if self.shifts {
            let scale = scale(&self.view, viewport);
            changed.shift[0] += way.x / scale;
            changed.shift[1] -= way.y / scale;
        } else {
            changed.rotation += way.x * TURN;
            changed.tilt += way.y * TURN;
        }
        changed.in_range()
    }

    /// Selects the points within the drawn box; where nodes are meant, those whose pivot is.
    pub(super) fn within(&self, editor: &Editor, viewport: Rect) -> Action {
        if editor.document.edits_path() {
            return Action::Choose(self.points_within(editor, viewport));
        }
        let drawn = Rect::from_two_pos(self.pressed, self.now);
        let projection = projection_of(editor, viewport);
        let mut found = nodes::within(editor, |place| drawn.contains(projection.pos(place)));
        if self.adds {
            let others = editor.selected_nodes();
            found.retain(|node| !others.contains(node));
            found.splice(0..0, others);
        }
        Action::SelectNodes(found)
    }

    /// The points within the drawn box, and those selected before if it adds.
    pub(super) fn points_within(&self, editor: &Editor, viewport: Rect) -> SelectionChange {
        let drawn = Rect::from_two_pos(self.pressed, self.now);
        let projection = projection_of(editor, viewport);
        let points = editor.document.path().points.iter().enumerate();
        let within = points.filter(|(_, point)| drawn.contains(projection.pos(point.position)));
        let mut found: Vec<usize> = within.map(|(at, _)| at).collect();
        if self.adds {
            found.extend(editor.all_selected());
        }
        if found.is_empty() {
            return SelectionChange::Current;
        }
        SelectionChange::These(found)
    }
}

/// The place that a drag's guides lead through.
pub(super) fn place_held(editor: &Editor, what: Handle) -> Option<DVec3> {
    match what {
        Handle::Point(at) => {
            let points = &editor.document.path().points;
            points.get(at).map(|point| point.position)
        }
        Handle::Vpn => drag::current_tip(&editor.document),
        Handle::Tangent(side) => tangents::tip(&editor.document, side),
        Handle::Vup | Handle::Node(_) | Handle::Key(..) => None,
        Handle::Control(at) => {
            let cage = editor.windows.tool.as_ref()?.cage()?;
            cage.nodes.get(at).copied()
        }
    }
}
