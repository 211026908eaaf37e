//! The ten speeds of a section: small squares to be dragged up and down, numbers, shapes
//! to pick from, copies.

use egui::{CursorIcon, Id, Rect, Ui, pos2, vec2};

use super::graph::{Frame, Handle, Held};
use super::shapes::Shape;
use super::{SCALE, Section, Size, entered};
use crate::actions::Action;
use crate::limits::{BASE_SPEED, MAX_SPEED, MIN_SPEED, SPEEDS};
use crate::number::Number;
use crate::state::Editor;
use crate::texts::fill;
use crate::theme;
use crate::windows::row_at_right;

/// One square for each; `choose` is the one that an arrow key has chosen.
pub(super) fn squares(
    editor: &Editor,
    (held, choose): (&mut Held, &mut Option<usize>),
    ui: &Ui,
    frame: &Frame,
    section: &Section,
    actions: &mut Vec<Action>,
) {
    for (at, &speed) in section.speeds.iter().enumerate() {
        let middle = pos2(frame.x(at as f64 / (SPEEDS - 1) as f64), frame.y(speed));
        let handle = Handle {
            id: Id::unique(("speed square", at)),
            middle,
            place: Rect::from_center_size(middle, vec2(Size::of(ui).step * 0.6, 28.0)),
            name: &fill(editor.texts().speed_window.speed, &[&(at + 1)]),
            value: speed,
            words: editor.language().number(speed, 1),
            rises: false,
            cursor: CursorIcon::ResizeVertical,
        };
        let moved = handle.show(held, ui, frame.rect, actions);
        if *choose == Some(at) {
            *choose = None;
            moved.response.request_focus();
        }
        if let Some((to, fine)) = moved.to {
            let scale = if fine { 10.0 } else { 1.0 };
            let rounded = (frame.value(to.y) * scale).round() / scale;
            actions.extend(set_speed(editor, at, rounded));
        }
        let [aside, rise] = moved.steps;
        if rise != 0.0 {
            actions.extend(set_speed(editor, at, speed + rise));
        }
        let next = if aside > 0.0 {
            at + 1
        } else {
            at.wrapping_sub(1)
        };
        if aside != 0.0 && next < SPEEDS {
            *choose = Some(next);
            ui.ctx().request_repaint();
        }
    }
}

/// Gives one of the ten speeds another value.
fn set_speed(editor: &Editor, at: usize, speed: f64) -> Option<Action> {
    let speed = speed.clamp(MIN_SPEED, MAX_SPEED);
    let edit = editor.orientation_edit(|orientation| {
        if let Some(old) = orientation.speeds.get_mut(at) {
            *old = speed;
        }
    });
    edit.map(Action::Edit)
}

/// The ten values as numbers, each below its square.
pub(super) fn typed(editor: &Editor, ui: &mut Ui, section: &Section, actions: &mut Vec<Action>) {
    let texts = &editor.texts().speed_window;
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = theme::GAP;
        let step = Size::of(ui).step;
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
        new = shapes(editor, ui, section);
        if Size::of(ui).one_row {
            new = new.or(exchange(editor, ui, section, actions));
        }
    });
    if !Size::of(ui).one_row {
        ui.horizontal(|ui| new = new.or(exchange(editor, ui, section, actions)));
    }
    if let Some(speeds) = new {
        let edit = editor.orientation_edit(|orientation| orientation.speeds = speeds);
        actions.extend(edit.map(Action::Edit));
    }
}

fn shapes(editor: &Editor, ui: &mut Ui, section: &Section) -> Option<[f64; SPEEDS]> {
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
            new = Some(shape.speeds(&section.speeds, section.before, section.after));
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
