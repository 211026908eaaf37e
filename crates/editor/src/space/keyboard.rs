//! The keyboard in the movement window. Arrow keys move the current point in the plane that is seen
//! best, Page Up and Page Down across it; with Alt they move the target.

use egui::{Key, Modifiers, Rect};
use glam::{DMat3, DVec2, DVec3};
use vides_document::{At, Edit, Selection};

use super::drag::{self, Room};
use super::held_nodes::Motion;
use super::projection::{Axis, Projection};
use crate::action::{Action, TimeAction};
use crate::number::decimals;
use crate::setup::{CameraPlace, View};
use crate::space::surface::{WHEEL, projection_of, resized};
use crate::state::Editor;
use crate::state::selected::step_around;
use crate::state::space::{Gesture, Grip, Handle, Held, NodeChange, PointerController};
use crate::texts::fill;

/// How far an arrow key moves, in units of `half_size`: without and with Shift.
const STEPS: [f64; 2] = [0.01, 0.1];

/// The keys that move something by a step; the first six can move the target.
pub(super) const NUDGES: [Key; 8] = [
    Key::ArrowLeft,
    Key::ArrowRight,
    Key::ArrowUp,
    Key::ArrowDown,
    Key::PageUp,
    Key::PageDown,
    Key::Comma,
    Key::Period,
];

/// The letters that mean something here; only text fields use them otherwise.
pub(super) const LETTERS: [Key; 11] = [
    Key::M,
    Key::P,
    Key::R,
    Key::S,
    Key::N,
    Key::O,
    Key::C,
    Key::B,
    Key::G,
    Key::L,
    Key::F,
];

/// Handles a key that was pressed while the movement window has the focus.
pub(super) fn press(
    controller: &mut PointerController,
    editor: &Editor,
    viewport: Rect,
    (key, modifiers): (Key, Modifiers),
    actions: &mut Vec<Action>,
) {
    if modifiers.command {
        let mut view = editor.setup.view;
        match key {
            Key::ArrowLeft => view.rotation -= 5.0,
            Key::ArrowRight => view.rotation += 5.0,
            Key::ArrowUp => view.tilt -= 5.0,
            Key::ArrowDown => view.tilt += 5.0,
            _ => return,
        }
        actions.push(Action::View(view.in_range()));
        return;
    }
    // With Alt only what moves something; the rest are the menus' keys.
    if modifiers.alt && !NUDGES[..6].contains(&key) {
        return;
    }
    let step = STEPS[usize::from(modifiers.shift)];
    let forward = !modifiers.shift;
    let projection = projection_of(editor, viewport);
    let selection = editor.document.selection();
    let what = match key {
        Key::Comma | Key::Period => Handle::Vup,
        _ if modifiers.alt => Handle::Vpn,
        _ => Handle::Point(selection.point),
    };
    if editor.means_nodes() && NUDGES.contains(&key) {
        if !matches!(key, Key::Comma | Key::Period) && !modifiers.alt {
            nudge_nodes(controller, editor, &projection, (key, step), actions);
        }
        return;
    }
    let resized = |factor| Action::View(resized(&editor.setup.view, viewport, None, factor));
    let edit = match key {
        Key::ArrowLeft | Key::ArrowRight | Key::ArrowUp | Key::ArrowDown => {
            let way = |axis: Axis| projection.image_of_way(axis.unit());
            let (axis, sign) = direction_of(projection.facing(), way, key);
            nudge(editor, &projection, what, axis, sign * step)
        }
        Key::PageUp | Key::PageDown => {
            let axis = projection.facing();
            let away = -projection.toward()[axis.index()].signum();
            let sign = if key == Key::PageUp { away } else { -away };
            nudge(editor, &projection, what, axis, sign * step)
        }
        Key::Comma => nudge_roll(editor, -100.0 * step),
        Key::Period => nudge_roll(editor, 100.0 * step),
        key => {
            if matches!(key, Key::N | Key::O) {
                controller.end_nudge(actions);
            }
            actions.push(match key {
                Key::Plus | Key::Equals => resized(WHEEL),
                Key::Minus => resized(1.0 / WHEEL),
                Key::Num0 | Key::Home => Action::View(View::default()),
                Key::F => match super::framing(editor, viewport, modifiers.shift) {
                    Some(view) => Action::View(view),
                    None => return,
                },
                Key::Space => Action::Time(TimeAction::PlayOrPause),
                Key::L => Action::Time(TimeAction::SwitchLoops),
                Key::C if modifiers.shift => Action::CameraPlace(CameraPlace::Whole),
                Key::C => Action::SwitchCameraView,
                Key::B => Action::CameraPlace(CameraPlace::Beside),
                Key::G => Action::Time(TimeAction::SwitchSpeedGraph),
                Key::N => {
                    let count = editor.document.path().points.len();
                    Action::Select(Selection::at(
                        step_around(selection.point, forward, count),
                        0,
                    ))
                }
                Key::O => {
                    let count = editor.point().map_or(1, |point| point.orientations.len());
                    let next = step_around(selection.orientation, forward, count);
                    Action::Select(Selection::at(selection.point, next))
                }
                _ => return,
            });
            return;
        }
    };
    if let Some(edit) = edit {
        // A key that repeats makes one step of the history.
        if !(controller.nudging && editor.document.in_step()) {
            controller.nudging = true;
            actions.push(Action::Gesture(Gesture::Begin));
        }
        actions.push(Action::Gesture(Gesture::Move(what, edit)));
    }
}

/// Moves the selected nodes by a step along an axis of the parent of the first one.
fn nudge_nodes(
    controller: &mut PointerController,
    editor: &Editor,
    projection: &Projection,
    (key, step): (Key, f64),
    actions: &mut Vec<Action>,
) {
    let held = match Held::new(editor, Grip::Nodes, true) {
        Ok(held) => held,
        Err(why) => return actions.push(Action::Complain(why)),
    };
    let facing = held.facing(DMat3::IDENTITY, projection);
    let way = |axis: Axis| held.way(axis.unit());
    let (axis, sign) = match key {
        Key::PageUp | Key::PageDown => {
            let away = -projection.toward().dot(way(facing)).signum();
            (facing, if key == Key::PageUp { away } else { -away })
        }
        _ => direction_of(facing, |axis| projection.image_of_way(way(axis)), key),
    };
    let half_size = projection.space().half_size;
    let Some(mut change) = held.changed(Motion::Move(axis.unit() * (sign * step * half_size)))
    else {
        return;
    };
    if let NodeChange::Values(values) = &mut change {
        for (_, _, numbers) in values {
            // Steps of a hundredth stay hundredths.
            let number = &mut numbers[axis.index()];
            *number = rounded(*number, half_size) + 0.0;
        }
    }
    if !(controller.nudging && editor.document.in_step()) {
        controller.nudging = true;
        actions.push(Action::Gesture(Gesture::Begin));
    }
    let number = editor
        .language()
        .number(sign * step * half_size, decimals(half_size));
    let words = fill(editor.texts().space.nudged, &[&axis.letter(), &number]);
    actions.push(Action::Gesture(Gesture::Nodes(change, words)));
}

/// The axis and direction in which an arrow key moves, in the plane that is seen best; `way`: how an
/// axis is seen.
fn direction_of(facing: Axis, way: impl Fn(Axis) -> DVec2, key: Key) -> (Axis, f64) {
    let [a, b] = facing.others();
    // The axis that runs more sideways is the one for left and right.
    let (side, other) = if way(a).x.abs() * way(b).y.abs() >= way(b).x.abs() * way(a).y.abs() {
        (a, b)
    } else {
        (b, a)
    };
    match key {
        Key::ArrowRight => (side, way(side).x.signum()),
        Key::ArrowLeft => (side, -way(side).x.signum()),
        Key::ArrowDown => (other, way(other).y.signum()),
        _ => (other, -way(other).y.signum()),
    }
}

fn nudge(
    editor: &Editor,
    projection: &Projection,
    what: Handle,
    axis: Axis,
    by: f64,
) -> Option<Edit> {
    let point = editor.point()?;
    let space = projection.space();
    let moved = |from: DVec3, [low, high]: Room| {
        let mut to = from;
        let at = &mut to[axis.index()];
        // Steps of a hundredth stay hundredths.
        let wanted = rounded(*at + by * space.half_size, space.half_size) + 0.0;
        *at = wanted.clamp(low[axis.index()], high[axis.index()]);
        to
    };
    if what == Handle::Vpn {
        let tip = drag::current_tip(&editor.document)?;
        // A target outside the cube goes no farther out.
        let [low, high] = drag::cube(projection);
        let to = moved(tip, [low.min(tip), high.max(tip)]);
        return drag::move_target(&editor.document, to);
    }
    let at = editor.document.selection().point;
    let to = moved(point.position, editor.room_of(at));
    Some(Edit::set(At::Point(at), "position", to))
}

/// A coordinate rounded to nine digits after the first one of `half_size`.
#[allow(clippy::cast_possible_truncation)]
fn rounded(value: f64, half_size: f64) -> f64 {
    let digits = 9 - half_size.log10().floor() as i32;
    // By a power of ten that is a whole number, and so exact.
    let power = 10f64.powi(digits.abs());
    if digits >= 0 {
        (value * power).round() / power
    } else {
        (value / power).round() * power
    }
}

fn nudge_roll(editor: &Editor, degrees: f64) -> Option<Edit> {
    editor.orientation_edit(|orientation| {
        orientation.roll = ((orientation.roll + degrees) * 1e9).round() / 1e9;
    })
}
