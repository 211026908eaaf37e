//! The ten speeds of a section: squares to be dragged, numbers, shapes to pick from, copies.

use egui::{CursorIcon, Id, Rect, Ui, pos2, vec2};
use vides_engine::limits::{BASE_SPEED, MAX_SPEED, MIN_SPEED, SPEEDS};
use vides_engine::path::{Orientation, Pace};

use super::graph::{Axes, Handle};
use super::join::ready;
use super::shapes::Shape;
use crate::action::Action;
use crate::number::Number;
use crate::state::Editor;
use crate::state::windows::{Held, Quantity};
use crate::texts::fill;
use crate::theme;
use crate::windows::speed::section::{SCALE, Section, Size, entered, timing};
use crate::windows::sub_window::row_at_right;

/// Rounding to this fraction of one leaves a value unchanged.
const EXACT: f64 = 1e9;

/// Squares to be dragged: on the speed one for each; on the way one for each but the outermost; on
/// the acceleration one between two. `choose` is the one chosen by an arrow key.
pub(super) fn squares(
    editor: &Editor,
    (held, choose): (&mut Held, &mut Option<usize>),
    ui: &Ui,
    axes: &Axes,
    section: &Section,
    actions: &mut Vec<Action>,
) {
    let (texts, shown) = (&editor.texts().speed_window, axes.quantity);
    let (squares, beside) = match shown {
        Quantity::Speed => (0..SPEEDS, 0.0),
        Quantity::Distance => (1..SPEEDS - 1, 0.0),
        Quantity::Acceleration => (0..SPEEDS - 1, 0.5),
    };
    for at in squares.clone() {
        let time = (at as f64 + beside) / (SPEEDS - 1) as f64;
        let (value, name, words) = match shown {
            Quantity::Speed => {
                let speed = section.speeds[at];
                let words = editor.language().number(speed, 1);
                (speed, fill(texts.speed, &[&(at + 1)]), words)
            }
            Quantity::Distance => {
                let way = shown.at(section, time);
                let [words, when] = [way, 100.0 * time].map(|x| editor.language().number(x, 1));
                let name = format!("{} {}", texts.graph_distance, at + 1);
                (way, name, fill(texts.way_at, &[&words, &when]))
            }
            Quantity::Acceleration => {
                let change = shown.at(section, time);
                let name = format!("{} {}", texts.graph_acceleration, at + 1);
                (change, name, editor.language().number(change, 1))
            }
        };
        let middle = pos2(axes.x(time), axes.y(value));
        let handle = Handle {
            id: Id::unique(("speed square", at)),
            middle,
            place: Rect::from_center_size(middle, vec2(Size::of(ui.ctx()).step * 0.6, 28.0)),
            name: &name,
            value,
            words,
            rises: shown == Quantity::Distance,
            cursor: CursorIcon::ResizeVertical,
        };
        let moved = handle.show(held, ui, axes.rect, actions);
        if *choose == Some(at) {
            *choose = None;
            moved.response.request_focus();
        }
        let [aside, rise] = moved.steps;
        let mut new = None;
        if let Some((to, fine)) = moved.to {
            let whole = shown == Quantity::Speed;
            let parts = if whole { 1.0 } else { 10.0 } * if fine { 10.0 } else { 1.0 };
            new = with_value(editor, section, (shown, at, time), axes.value(to.y), parts);
        }
        if rise != 0.0 {
            let value = value + rise * axes.percent().max(1.0);
            new = with_value(editor, section, (shown, at, time), value, EXACT);
        }
        if let Some(speeds) = new {
            let edit = editor.orientation_edit(|orientation| orientation.speeds = speeds);
            actions.extend(edit.map(Action::Edit));
        }
        let next = if aside > 0.0 {
            at + 1
        } else {
            at.wrapping_sub(1)
        };
        if aside != 0.0 && squares.contains(&next) {
            *choose = Some(next);
            ui.ctx().request_repaint();
        }
    }
}

/// The ten speeds, rounded to parts of one, with which a graph has a value at one of its squares,
/// as near as their range allows. More way up to a square takes a higher speed before it and a
/// lower one after it, more acceleration between two speeds a lower first and a higher second one:
/// the section's mean speed hardly changes.
fn with_value(
    editor: &Editor,
    section: &Section,
    (shown, at, time): (Quantity, usize, f64),
    value: f64,
    parts: f64,
) -> Option<[f64; SPEEDS]> {
    let old = section.speeds;
    let (rises, falls) = match shown {
        Quantity::Speed => {
            let mut speeds = old;
            let speed = (value * parts).round() / parts;
            *speeds.get_mut(at)? = speed.clamp(MIN_SPEED, MAX_SPEED);
            return Some(speeds);
        }
        Quantity::Distance => (at.checked_sub(1)?, at + 1),
        Quantity::Acceleration => (at + 1, at),
    };
    // An outermost speed counts for half as much of the way.
    let weight = |at| {
        if at == 0 || at == SPEEDS - 1 {
            2.0
        } else {
            1.0
        }
    };
    let room = |at: usize, end: f64| (end - old[at]) / weight(at);
    let mut low = room(rises, MIN_SPEED).max(-room(falls, MAX_SPEED));
    let mut high = room(rises, MAX_SPEED).min(-room(falls, MIN_SPEED));
    let current = editor.orientation()?;
    let by_ten = Orientation {
        own: current.own.with(|own| own.pace = Pace::Speeds).ok()?,
        ..current.clone()
    };
    let by = |by: f64, parts: f64| {
        let mut orientation = by_ten.clone();
        for (at, by) in [(rises, by), (falls, -by)] {
            let speed = ((old[at] + by * weight(at)) * parts).round() / parts;
            orientation.speeds[at] = speed.clamp(MIN_SPEED, MAX_SPEED);
        }
        orientation
    };
    for _ in 0..50 {
        let middle = f64::midpoint(low, high);
        let timing = timing(editor, &by(middle, EXACT))?;
        let less = shown.of(&timing, section.seconds, time) < value;
        *(if less { &mut low } else { &mut high }) = middle;
    }
    Some(by(low, parts).speeds)
}

/// The ten values as numbers, each below its square.
pub(super) fn typed(editor: &Editor, ui: &mut Ui, section: &Section, actions: &mut Vec<Action>) {
    let texts = &editor.texts().speed_window;
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = theme::GAP;
        let step = Size::of(ui.ctx()).step;
        ui.add_space(SCALE + step);
        for at in 0..SPEEDS {
            let name = fill(texts.speed, &[&(at + 1)]);
            let number = Number::new(&name, section.speeds[at])
                .decimals(if section.speeds[at].fract() == 0.0 {
                    0
                } else {
                    1
                })
                .range(MIN_SPEED..=MAX_SPEED)
                .steps(1.0, 0.5);
            let id = format!("speed.{at}");
            let entry = number.show(ui, editor.language(), &id, step - theme::GAP);
            let speeds = section.speeds;
            actions.extend(entered(editor, entry, |orientation, value| {
                orientation.speeds = speeds;
                if let Some(speed) = orientation.speeds.get_mut(at) {
                    *speed = value;
                }
            }));
        }
    });
}

/// Shapes on the left; copy, paste and reset on the right, or below.
pub(super) fn buttons(editor: &Editor, ui: &mut Ui, section: &Section, actions: &mut Vec<Action>) {
    let mut new = None;
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = theme::GAP;
        new = shapes(editor, ui);
        if Size::of(ui.ctx()).one_row {
            new = new.or(exchange(editor, ui, section, actions));
        }
    });
    if !Size::of(ui.ctx()).one_row {
        ui.horizontal(|ui| new = new.or(exchange(editor, ui, section, actions)));
    }
    if let Some(speeds) = new {
        let edit = editor.orientation_edit(|orientation| orientation.speeds = speeds);
        actions.extend(edit.map(Action::Edit));
    }
}

/// The ready paces as buttons; the one that was clicked, for the current section.
pub(crate) fn shapes(editor: &Editor, ui: &mut Ui) -> Option<[f64; SPEEDS]> {
    let texts = &editor.texts().speed_window;
    let names = [
        (texts.constant, texts.constant_hint),
        (texts.ease_in, texts.ease_in_hint),
        (texts.ease_out, texts.ease_out_hint),
        (texts.both, texts.both_hint),
    ];
    let mut new = None;
    for (shape, (name, hint)) in Shape::ALL.into_iter().zip(names) {
        if ui.button(name).on_hover_text(hint).clicked() {
            new = ready(&editor.document, editor.document.selection(), shape);
        }
    }
    new
}

fn exchange(
    editor: &Editor,
    ui: &mut Ui,
    section: &Section,
    actions: &mut Vec<Action>,
) -> Option<[f64; SPEEDS]> {
    let texts = &editor.texts().speed_window;
    let mut new = None;
    ui.spacing_mut().item_spacing.x = theme::GAP;
    let names = [texts.copy, texts.paste, texts.reset];
    row_at_right(ui, &names, 0.0, |ui| {
        let button = |ui: &mut Ui, enabled, name: &str, hint: &str| {
            ui.add_enabled(enabled, egui::Button::new(name))
                .on_hover_text(hint)
                .clicked()
        };
        if button(ui, true, texts.copy, texts.copy_hint) {
            actions.push(Action::CopySpeeds(section.speeds));
        }
        let known = editor.windows.copied_speeds;
        if button(ui, known.is_some(), texts.paste, texts.paste_hint) {
            new = known;
        }
        if button(ui, true, texts.reset, texts.reset_hint) {
            new = Some([BASE_SPEED; SPEEDS]);
        }
    });
    new
}
