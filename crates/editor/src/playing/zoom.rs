//! Which part of the time is seen: the wheel zooms about the pointer, the middle button and the
//! wheel with Shift move it.

use egui::{Event, Key, Modifiers, MouseWheelUnit, PointerButton, Rect, Ui};
use vides_engine::scene::Track;

use super::axis::Axis;
use super::{ruler, track_rows};
use crate::action::{Action, TimeAction};
use crate::state::Editor;

/// Factor of the frames that are seen for each step of the wheel.
const WHEEL: f64 = 0.8;

/// Points by which a step of the wheel with Shift moves the time.
const STEP: f32 = 60.0;

/// Steps of the wheel over the time in `rect`, and the middle button that is held there; in
/// `scrolls` the wheel needs Ctrl.
pub(super) fn by_mouse(
    ui: &Ui,
    rect: Rect,
    scrolls: Option<Rect>,
    axis: &Axis,
    actions: &mut Vec<Action>,
) {
    let mine = |at| rect.contains(at) && ui.ctx().layer_id_at(at) == Some(ui.layer_id());
    let (pointer, pressed, by) = ui.input(|input| {
        let pointer = &input.pointer;
        let held = pointer.button_down(PointerButton::Middle);
        let pressed = pointer.press_origin().filter(|_| held);
        (pointer.latest_pos(), pressed, pointer.delta().x)
    });
    let mut seen = None;
    if by != 0.0 && pressed.is_some_and(mine) {
        seen = Some(axis.moved(by));
    }
    if let Some(pointer) = pointer.filter(|&at| mine(at)) {
        let plain = !scrolls.is_some_and(|scrolls| scrolls.contains(pointer));
        let (near, along) = ui.input(|input| steps(&input.events, plain));
        if near != 0.0 {
            seen = Some(axis.zoomed(pointer.x, WHEEL.powf(near)));
        } else if along != 0.0 {
            seen = Some(axis.moved(along * STEP));
        }
    }
    if let Some(seen) = seen.filter(|seen| seen.is_some() || !axis.shows_all()) {
        actions.push(Action::Time(TimeAction::See(seen)));
        ui.ctx().request_repaint();
    }
}

/// Shift and Home show the selected keys, else all that moves the selected nodes; Home in the rows of
/// tracks shows everything.
pub(super) fn by_keys(editor: &Editor, ui: &Ui, axis: &Axis, actions: &mut Vec<Action>) {
    let has = |id| ui.memory(|memory| memory.has_focus(id));
    let (rows, ruler) = (has(track_rows::id()), has(ruler::id()));
    if !(rows || ruler) || editor.document.edited_scene().is_none() {
        return;
    }
    let pressed = |modifiers| ui.input_mut(|input| input.consume_key(modifiers, Key::Home));
    if pressed(Modifiers::SHIFT) {
        let keys = editor.selected_keys();
        let ends = track_rows::ends(editor, &keys).or_else(|| of_nodes(editor));
        if let Some((first, last)) = ends {
            let seen = axis.between(first, last);
            actions.push(Action::Time(TimeAction::See(seen)));
        }
    } else if rows && pressed(Modifiers::NONE) {
        actions.push(Action::Time(TimeAction::See(None)));
    }
}

/// The scene's frames between which the selected nodes move.
pub(super) fn of_nodes(editor: &Editor) -> Option<(f64, f64)> {
    let edited = editor.document.edited_scene()?;
    let nodes = edited.scene().nodes();
    let of_node = |node: usize| {
        let tracks = nodes[node].keys().tracks().iter().map(Track::ends);
        tracks.chain(track_rows::bar_of(editor, edited, node))
    };
    let ends = editor.selected_nodes().into_iter().flat_map(of_node);
    ends.reduce(|a, b| (a.0.min(b.0), a.1.max(b.1)))
}

/// Steps of the wheel towards, and along the time; with Ctrl only unless they may be `plain`.
fn steps(events: &[Event], plain: bool) -> (f64, f32) {
    let (mut near, mut along) = (0.0, 0.0);
    for event in events {
        let Event::MouseWheel {
            unit,
            delta,
            modifiers,
            ..
        } = event
        else {
            continue;
        };
        let delta = match unit {
            MouseWheelUnit::Line => *delta,
            MouseWheelUnit::Point => *delta / 50.0,
            MouseWheelUnit::Page => *delta * 5.0,
        };
        match modifiers.shift {
            true => along += delta.x + delta.y,
            false if !plain && !modifiers.ctrl => {}
            false => {
                near += f64::from(delta.y);
                along += delta.x;
            }
        }
    }
    (near, along)
}

#[cfg(test)]
#[path = "zoom_tests.rs"]
mod tests;
