//! A section that speeds up, cruises and slows down: its numbers, and its corners to be dragged.

use egui::{CursorIcon, Id, Rangef, Rect, Ui, pos2};
use vides_engine::limits::{MAX_SPEED, MIN_SPEED};
use vides_engine::path::{Ease, Pace};

use super::graph::{Axes, Handle};
use crate::action::Action;
use crate::number::Number;
use crate::state::Editor;
use crate::state::windows::{Held, Quantity};
use crate::texts::fill;
use crate::theme;
use crate::windows::speed::section::{Section, entered_own};

/// One of the numbers of an ease.
type Part = fn(&mut Ease) -> &mut f64;

/// Room around a corner where it can be grabbed.
const GRIP: f32 = 14.0;

pub(super) fn corners(
    editor: &Editor,
    held: &mut Held,
    ui: &Ui,
    (axes, quantity): (&Axes, Quantity),
    (section, ease): (&Section, Ease),
    actions: &mut Vec<Action>,
) {
    let texts = &editor.texts().speed_window;
    let [rise, fall] = [ease.rise, 1.0 - ease.fall].map(|u| {
        let value = match quantity {
            Quantity::Speed => ease.cruise,
            Quantity::Distance => quantity.at(section, u),
            // It jumps there.
            Quantity::Acceleration => 0.0,
        };
        pos2(axes.x(u), axes.y(value))
    });
    // Where both are together, one is grabbed at its left, the other at its right.
    let between = ((fall.x - rise.x) / 2.0).clamp(0.0, GRIP);
    let ranges = [
        Rangef::new(rise.x - GRIP, rise.x + between),
        Rangef::new(fall.x - between, fall.x + GRIP),
    ];
    let parts: [(&str, Part, f64); 2] = [
        (texts.rise_end, |ease| &mut ease.rise, 1.0),
        (texts.fall_start, |ease| &mut ease.fall, -1.0),
    ];
    for (((name, part, sign), middle), across) in parts.into_iter().zip([rise, fall]).zip(ranges) {
        let share = *part(&mut ease.clone());
        let rows = Rangef::point(middle.y).expand(GRIP);
        let handle = Handle {
            id: Id::unique(("ease corner", name)),
            middle,
            place: Rect::from_x_y_ranges(across, rows),
            name,
            value: 100.0 * share,
            words: fill(
                texts.percent,
                &[&editor.language().number(100.0 * share, 1)],
            ),
            rises: false,
            cursor: CursorIcon::ResizeHorizontal,
        };
        let moved = handle.show(held, ui, axes.rect, actions);
        let mut new = None;
        if let Some((to, fine)) = moved.to {
            let u = axes.time(to.x);
            let scale = if fine { 1000.0 } else { 100.0 };
            let share = if sign > 0.0 { u } else { 1.0 - u };
            new = Some((share * scale).round() / scale);
        }
        if moved.steps[0] != 0.0 {
            // Whole percents stay whole.
            let percents = 100.0 * share + sign * moved.steps[0];
            new = Some((percents * 1e9).round() / 1e11);
        }
        if let Some(share) = new {
            actions.extend(editor.own_action(|own| set(&mut own.pace, part, share)));
        }
    }
}

/// Another share of the time, limited by that of the opposite end.
fn set(pace: &mut Pace, part: Part, share: f64) {
    if let Pace::Ease(ease) = pace {
        let room = 1.0 - (ease.rise + ease.fall - *part(ease));
        *part(ease) = share.clamp(0.0, room.max(0.0));
    }
}

/// Both shares and the cruising speed as numbers.
pub(super) fn typed(editor: &Editor, ui: &mut Ui, ease: Ease, actions: &mut Vec<Action>) {
    let texts = &editor.texts().speed_window;
    // The last says whether it is a share of the time.
    let parts: [(&str, &str, Part, bool); 3] = [
        (texts.rise, texts.rise_hint, |ease| &mut ease.rise, true),
        (texts.fall, texts.fall_hint, |ease| &mut ease.fall, true),
        (
            texts.cruise,
            texts.cruise_hint,
            |ease| &mut ease.cruise,
            false,
        ),
    ];
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = theme::GAP;
        let gaps = theme::GAP * (parts.len() - 1) as f32;
        let width = ((ui.available_width() - gaps) / parts.len() as f32).floor();
        for (name, hint, part, is_share) in parts {
            let value = *part(&mut ease.clone());
            // 0.07 is a little more than 7 percent.
            let rounded = |value: f64| (value * 1e9).round() / 1e9;
            let (unit, scale, range) = if is_share {
                let room = 1.0 - (ease.rise + ease.fall - value);
                ("\u{a0}%", 100.0, 0.0..=rounded(100.0 * room.max(0.0)))
            } else {
                ("", 1.0, MIN_SPEED..=MAX_SPEED)
            };
            let shown = rounded(value * scale);
            let number = Number::new(name, shown)
                .label(name)
                .hint(hint)
                .unit(unit)
                .decimals(usize::from(shown.fract() != 0.0))
                .range(range)
                .steps(1.0, 0.5);
            let entry = number.show(ui, editor.language(), &format!("speed.ease.{name}"), width);
            actions.extend(entered_own(editor, entry, |own, value| {
                let mut ease = ease;
                *part(&mut ease) = value / scale;
                own.pace = Pace::Ease(ease);
            }));
        }
    });
}
