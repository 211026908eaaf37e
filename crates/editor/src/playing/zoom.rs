//! Which part of the time is seen: the wheel zooms about the pointer, the middle button and the
//! wheel with Shift move it.

use egui::{Event, MouseWheelUnit, PointerButton, Rect, Ui};

use super::axis::Axis;
use crate::action::Action;

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
        actions.push(Action::See(seen));
        ui.ctx().request_repaint();
    }
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
