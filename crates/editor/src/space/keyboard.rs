//! The keyboard in the movement window: everything that the mouse does there.
//!
//! Arrow keys move the current point in the plane that is seen best, Page Up
//! and Page Down across it; with Alt they move the target. Comma and full stop
//! roll. With Ctrl the arrow keys turn the space; plus, minus and Home are its
//! size. N and O go to the next point and orientation, with Shift back.

use egui::{Key, Modifiers};
use glam::DVec3;

use super::drag::{self, Handle};
use super::pointer::{PointerContext, WHEEL, make_current, resize, tell_place};
use super::projection::{Axis, Projection};
use super::projection_of;
use crate::document::Edit;
use crate::setup::View;
use crate::state::Editor;

/// What an arrow key moves by, in half sizes of the space; the larger one with
/// Shift.
const STEPS: [f64; 2] = [0.01, 0.1];

/// The keys that move something a step.
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

/// Takes a key that was pressed while the movement window has the keyboard.
pub(super) fn press(
    editor: &mut Editor,
    surface: &PointerContext<'_>,
    key: Key,
    modifiers: Modifiers,
) {
    if modifiers.command {
        let view = &mut editor.setup.view;
        match key {
            Key::ArrowLeft => view.rotation -= 5.0,
            Key::ArrowRight => view.rotation += 5.0,
            Key::ArrowUp => view.tilt -= 5.0,
            Key::ArrowDown => view.tilt += 5.0,
            _ => return,
        }
        *view = view.in_range();
        return;
    }
    // With Alt only what moves; the rest are the menus' keys.
    if modifiers.alt && !NUDGES[..6].contains(&key) {
        return;
    }
    let step = STEPS[usize::from(modifiers.shift)];
    let projection = projection_of(editor, surface.viewport);
    let what = if modifiers.alt {
        Handle::Vpn
    } else {
        Handle::Point(editor.document.selection().point)
    };
    match key {
        Key::ArrowLeft | Key::ArrowRight | Key::ArrowUp | Key::ArrowDown => {
            let (axis, sign) = direction_of(&projection, key);
            nudge(editor, &projection, what, axis, sign * step);
        }
        Key::PageUp | Key::PageDown => {
            let axis = projection.facing();
            let away = -projection.toward()[axis.index()].signum();
            let sign = if key == Key::PageUp { away } else { -away };
            nudge(editor, &projection, what, axis, sign * step);
        }
        Key::Comma => nudge_roll(editor, -100.0 * step),
        Key::Period => nudge_roll(editor, 100.0 * step),
        Key::Plus | Key::Equals => resize(&mut editor.setup.view, surface.viewport, None, WHEEL),
        Key::Minus => resize(&mut editor.setup.view, surface.viewport, None, 1.0 / WHEEL),
        Key::Num0 | Key::Home => editor.setup.view = View::default(),
        Key::Space => editor.play_or_pause(surface.context),
        Key::L => editor.switch_loops(surface.context),
        Key::C => editor.setup.camera_view = !editor.setup.camera_view,
        Key::N => step_point(editor, if modifiers.shift { -1 } else { 1 }),
        Key::O => step_orientation(editor, if modifiers.shift { -1 } else { 1 }),
        _ => {}
    }
}

/// The axis along which an arrow key moves, in the plane that is seen best, and
/// which way along it.
fn direction_of(projection: &Projection, key: Key) -> (Axis, f64) {
    let [a, b] = projection.facing().others();
    let way = |axis: Axis| {
        let mut unit = DVec3::ZERO;
        unit[axis.index()] = 1.0;
        projection.image_of_way(unit)
    };
    // Whichever runs more to the side is the one for left and right.
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

/// Moves a coordinate by a step; repeated while the key is down, it is one step
/// of the history.
fn nudge(editor: &mut Editor, projection: &Projection, what: Handle, axis: Axis, by: f64) {
    let selection = editor.document.selection();
    let Some(point) = editor.document.path().points.get(selection.point) else {
        return;
    };
    let space = projection.space();
    let (low, high) = (space.low()[axis.index()], space.high()[axis.index()]);
    let moved = |from: DVec3| {
        let mut to = from;
        let at = &mut to[axis.index()];
        // Steps of a hundredth stay hundredths. One that lies outside the
        // cube goes no farther.
        let wanted = rounded(*at + by * space.half_size, space.half_size) + 0.0;
        *at = wanted.clamp(at.min(low), at.max(high));
        to
    };
    let edit = match what {
        Handle::Vpn => drag::current_tip(&editor.document)
            .and_then(|tip| drag::move_target(&editor.document, moved(tip))),
        _ => Some(Edit::SetPosition {
            at: selection.point,
            position: moved(point.position),
        }),
    };
    if let Some(edit) = edit {
        nudge_by(editor, what, edit);
    }
}

/// A coordinate to nine digits behind the first one of the half size.
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

fn nudge_roll(editor: &mut Editor, degrees: f64) {
    let selection = editor.document.selection();
    let Some(current) = editor
        .document
        .path()
        .points
        .get(selection.point)
        .and_then(|point| point.orientations.get(selection.orientation))
    else {
        return;
    };
    let mut orientation = current.clone();
    orientation.roll = ((orientation.roll + degrees) * 1e9).round() / 1e9;
    let edit = Edit::SetOrientation {
        point: selection.point,
        at: selection.orientation,
        orientation,
    };
    nudge_by(editor, Handle::Vup, edit);
}

fn nudge_by(editor: &mut Editor, what: Handle, edit: Edit) {
    if !(editor.space.pointer.nudging && editor.document.in_step()) {
        editor.document.begin_step();
        editor.space.pointer.nudging = true;
    }
    if editor.edit(edit) {
        tell_place(editor, what);
    }
}

/// Ends the step that the keys opened.
pub(super) fn end_nudge(editor: &mut Editor) {
    if std::mem::take(&mut editor.space.pointer.nudging) {
        editor.let_go();
    }
}

/// The next point or the one before, round and round.
fn step_point(editor: &mut Editor, by: isize) {
    end_nudge(editor);
    let count = editor.document.path().points.len();
    let at = editor.document.selection().point;
    editor.message = None;
    make_current(editor, around(at, by, count));
}

/// The next orientation of the current point or the one before.
fn step_orientation(editor: &mut Editor, by: isize) {
    end_nudge(editor);
    let selection = editor.document.selection();
    let points = &editor.document.path().points;
    let count = points
        .get(selection.point)
        .map_or(1, |point| point.orientations.len());
    let next = around(selection.orientation, by, count);
    editor.message = None;
    if let Err(error) = editor.document.select(selection.point, next) {
        editor.complain_of(&error);
    }
}

fn around(at: usize, by: isize, count: usize) -> usize {
    let count = count.max(1);
    if by < 0 {
        (at + count - 1) % count
    } else {
        (at + 1) % count
    }
}
