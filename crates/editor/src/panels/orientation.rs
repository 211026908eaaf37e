//! The orientations of the current point (thesis A.4.2).

use egui::Ui;

use super::position::three_numbers;
use super::{Key, heading, keys, round, share};
use crate::actions::Action;
use crate::document::{Edit, Selection};
use crate::limits::MAX_HOLD;
use crate::number::Number;
use crate::path::{Orientation, Target};
use crate::playing::playhead::Shown;
use crate::state::Editor;

pub(super) fn show(editor: &Editor, ui: &mut Ui, actions: &mut Vec<Action>) {
    let texts = &editor.texts().orientation;
    let here = editor.document.selection();
    let count = editor.point().map_or(1, |point| point.orientations.len());
    let Some(shown) = editor.shown() else {
        return;
    };
    let missing = shown.has_no_orientation();
    let (selection, current) = (shown.at, &shown.orientation);
    let ahead = current.own.ahead.is_some();
    let absolute = !ahead && matches!(current.target, Target::Absolute(_));
    let how = match (ahead, absolute) {
        (true, _) => texts.along_way,
        (_, true) => texts.at_place,
        _ => texts.in_direction,
    };
    heading(ui, texts.heading, how);
    keys(
        editor,
        ui,
        &[
            Key::new(texts.add, texts.add_hint, Action::AddOrientation),
            Key::new(texts.remove, texts.remove_hint, Action::RemoveOrientation),
        ],
        actions,
    );
    round(
        editor,
        ui,
        [
            &Key::new(
                texts.previous,
                texts.previous_hint,
                Action::PreviousOrientation,
            ),
            &Key::new(texts.next, texts.next_hint, Action::NextOrientation),
        ],
        &Editor::number_of(texts.count, here.orientation, count),
        actions,
    );
    keys(
        editor,
        ui,
        &[
            Key::new(
                texts.absolute,
                texts.absolute_hint,
                Action::SetAbsolute(true),
            )
            .chosen(absolute),
            Key::new(
                texts.relative,
                texts.relative_hint,
                Action::SetAbsolute(false),
            )
            .chosen(!absolute && !ahead),
            Key::new(texts.ahead, texts.ahead_hint, Action::LookAhead).chosen(ahead),
        ],
        actions,
    );
    target(editor, ui, &shown, actions);
    let language = editor.language();
    let width = share(ui, 2);
    ui.horizontal(|ui| {
        let roll = Number::new(texts.roll, current.roll)
            .label(texts.roll)
            .hint(texts.roll_hint)
            .faint(missing)
            .unit("°")
            .decimals(1)
            .steps(1.0, 0.5)
            .show(ui, language, "roll", width);
        let roll = roll.map(|roll| with(selection, current, |new| new.roll = roll));
        actions.push(Action::enter(missing, roll));
        let hold = Number::new(texts.hold, f64::from(current.hold))
            .label(texts.hold)
            .hint(texts.hold_hint)
            .faint(missing)
            .unit(texts.hold_unit)
            .whole()
            .range(0.0..=f64::from(MAX_HOLD))
            .steps(1.0, 0.2)
            .show(ui, language, "hold", width);
        // Whole, and within an u32.
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
        let hold = hold.map(|hold| with(selection, current, |new| new.hold = hold as u32));
        actions.push(Action::enter(missing, hold));
    });
}

/// What the camera looks at: a place or a direction.
fn target(editor: &Editor, ui: &mut Ui, shown: &Shown, actions: &mut Vec<Action>) {
    let texts = &editor.texts().orientation;
    let (selection, current) = (shown.at, &shown.orientation);
    let missing = shown.has_no_orientation();
    if let Some(distance) = current.own.ahead {
        let entry = Number::new(texts.distance, distance)
            .label(texts.distance)
            .hint(texts.distance_hint)
            .faint(missing)
            .in_space(editor.document.path().space)
            .range(0.0..=f64::MAX)
            .show(ui, editor.language(), "ahead", ui.available_width());
        let entry = entry.map(|distance| with(selection, current, |new| look_ahead(new, distance)));
        actions.push(Action::enter(missing, entry));
        return;
    }
    let (words, vector) = match current.target {
        Target::Absolute(place) => (("target", texts.target, texts.target_hint), place),
        Target::Relative(way) => (("direction", texts.direction, texts.direction_hint), way),
    };
    let edit = |to| {
        with(selection, current, |new| {
            new.target = match new.target {
                Target::Absolute(_) => Target::Absolute(to),
                Target::Relative(_) => Target::Relative(to),
            };
        })
    };
    three_numbers(editor, ui, words, vector, missing, edit, actions);
}

/// Along the way from now on, or at the place so far ahead on it.
pub(crate) fn look_ahead(orientation: &mut Orientation, distance: f64) {
    // Without memory for it all stays as it is.
    if let Ok(own) = orientation.own.with(|own| own.ahead = Some(distance)) {
        orientation.own = own;
    }
}

/// The edit that changes the current orientation.
pub(super) fn with(
    at: Selection,
    current: &Orientation,
    change: impl FnOnce(&mut Orientation),
) -> Edit {
    let mut orientation = current.clone();
    change(&mut orientation);
    Edit::SetOrientation {
        point: at.point,
        at: at.orientation,
        orientation,
    }
}
