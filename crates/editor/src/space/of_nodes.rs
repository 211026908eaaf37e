//! What the pointer does with nodes: a click selects them, a drag or a key begins a transform.

use egui::{Key, PointerButton, Pos2, Rect};
use glam::DVec2;

use super::projection::{Projection, from_pos};
use super::{nodes, picking, trail};
use crate::action::{Action, TimeAction};
use crate::space::surface::{PointerContext, STILL, projection_of};
use crate::state::Editor;
use crate::state::space::{
    Gesture, Grip, Handle, Kind, PointerController, PointerPress, Transform,
};

impl PointerController {
    /// Whether the last click was on a node.
    pub(super) fn clicked_node(&self) -> bool {
        self.clicked.is_some_and(|(_, node)| node)
    }

    /// Begins the transform of nodes that a key asks for; false: it means something else.
    pub(super) fn begins_with_nodes(
        &mut self,
        editor: &Editor,
        surface: &PointerContext<'_>,
        key: Key,
        actions: &mut Vec<Action>,
    ) -> bool {
        let no_path = !editor.document.edits_path();
        let nodes = no_path || editor.means_nodes();
        let begun = match Kind::of_key(key) {
            Some(kind) if nodes => (kind, Grip::Nodes, None),
            None if key == Key::P && (no_path || editor.current_node().is_some()) => {
                (Kind::Move, Grip::Pivot, None)
            }
            _ => return false,
        };
        self.begin_nodes(editor, surface, begun, actions);
        true
    }

    /// Begins a transform of nodes, or reports why it cannot.
    pub(super) fn begin_nodes(
        &mut self,
        editor: &Editor,
        surface: &PointerContext<'_>,
        (kind, grip, held): (Kind, Grip, Option<(PointerButton, Pos2)>),
        actions: &mut Vec<Action>,
    ) {
        self.end_nudge(actions);
        let button = held.map(|(button, _)| button);
        match Transform::of_nodes(editor, surface, kind, grip, button) {
            Ok(transform) => {
                if editor.playing.is_playing() {
                    // Else each frame that goes by would get keys.
                    actions.push(Action::Time(TimeAction::PlayOrPause));
                }
                actions.push(Action::Gesture(Gesture::Begin));
                self.transform = Some(match held {
                    Some((_, at)) => transform.pressed_at(from_pos(at)),
                    None => transform,
                });
            }
            Err(why) => actions.push(Action::Complain(why)),
        }
    }

    /// Selects what a click meant of the scene; false: nothing of it lies there.
    pub(super) fn clicks_node(
        &mut self,
        editor: &Editor,
        viewport: Rect,
        hold: &PointerPress,
        actions: &mut Vec<Action>,
    ) -> bool {
        let before = self.clicked.replace((hold.pressed, false));
        let left = hold.button == PointerButton::Primary;
        if !left || hold.what.is_some_and(Handle::is_of_path) || editor.windows.tool.is_some() {
            return false;
        }
        let projection = projection_of(editor, viewport);
        let found = nodes::at(editor, &projection, viewport, hold.pressed);
        let Some(&first) = found.first() else {
            return false;
        };
        self.clicked = Some((hold.pressed, true));
        let mut selected = editor.selected_nodes();
        let chosen = if hold.adds || hold.boxes {
            match selected.iter().position(|&node| node == first) {
                Some(at) => drop(selected.remove(at)),
                None => selected.insert(0, first),
            }
            selected
        } else {
            let again = before.is_some_and(|(at, node)| {
                let way = (at - hold.pressed).abs();
                node && way.x.max(way.y) <= STILL
            });
            // What lies behind that which the click before took.
            let taken = found.iter().position(|node| selected.first() == Some(node));
            let next = taken.filter(|_| again).map(|at| (at + 1) % found.len());
            vec![found[next.unwrap_or(0)]]
        };
        actions.push(Action::SelectNodes(chosen));
        true
    }
}

/// The pivot of a selected node, or a key on its way.
pub(super) fn grip_at(editor: &Editor, projection: &Projection, pointer: DVec2) -> Option<Handle> {
    if !editor.means_nodes() || editor.windows.tool.is_some() {
        return None;
    }
    let (nodes, places): (Vec<_>, Vec<_>) = nodes::selected_pivots(editor).into_iter().unzip();
    let pivot = picking::nearest(projection, places.into_iter(), pointer);
    let key = || trail::key_at(editor, projection, pointer);
    let key = || key().map(|(node, key)| Handle::Key(node, key));
    pivot.map(|at| Handle::Node(nodes[at])).or_else(key)
}
