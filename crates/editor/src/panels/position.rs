//! The position of the current point (thesis A.4.1).

use egui::{RichText, Ui};
use glam::DVec3;
use vides_document::{At, Edit};

use crate::action::{Action, PathAction};
use crate::number::Number;
use crate::panels::parts::{Heading, PanelButton, apart, button_row, share};
use crate::playing::playhead::Shown;
use crate::setup::Fold;
use crate::state::Editor;
use crate::texts::fill;
use crate::theme;

pub(super) fn show(editor: &Editor, ui: &mut Ui, actions: &mut Vec<Action>) {
    let texts = &editor.texts().position;
    let count = editor.document.path().points.len();
    let Some(shown) = editor.shown() else {
        return;
    };
    let heading = Heading {
        editor,
        fold: Fold::Position,
        text: texts.heading,
        remark: &Editor::number_of(texts.count, shown.at.point, count),
    };
    let here = shown
        .has_no_point()
        .then_some([texts.add_here, texts.new_point]);
    if heading.or_new(ui, here, actions) {
        coordinates(editor, ui, &shown, actions);
    }
}

/// Where the path has not begun or is over: why no point can be added.
pub(super) fn not_here(editor: &Editor, ui: &mut Ui, actions: &mut Vec<Action>) {
    let Some(why) = editor.why_not_here() else {
        return;
    };
    let text = editor.texts().position.add_here;
    ui.add_enabled_ui(false, |ui| {
        let button = PanelButton::new(text, &why, Action::Path(PathAction::AddHere));
        button_row(editor, ui, &[button], actions);
    });
    ui.label(RichText::new(&why).color(theme::palette(ui).weak));
    apart(ui);
}

fn coordinates(editor: &Editor, ui: &mut Ui, shown: &Shown, actions: &mut Vec<Action>) {
    let texts = &editor.texts().position;
    let (at, position, missing) = (shown.at.point, shown.position, shown.has_no_point());
    three_numbers(
        editor,
        ui,
        ("position", texts.coordinate, texts.coordinate_hint),
        position,
        missing,
        |position| Ok(Edit::set(At::Point(at), "position", position)),
        actions,
    );
}

/// A place or a direction as three numbers, faint if `missing` in the path; `edit` sets them.
pub(super) fn three_numbers(
    editor: &Editor,
    ui: &mut Ui,
    (id, name, hint): (&str, &str, &str),
    vector: DVec3,
    missing: bool,
    edit: impl Fn(DVec3) -> Result<Edit, String>,
    actions: &mut Vec<Action>,
) {
    let space = editor.document.path().space;
    let third = share(ui, 3);
    // Side by side, unless the digits of such a space need more room.
    let beside = Number::room_in_space(ui, editor.language(), space) <= third;
    let width = if beside { third } else { ui.available_width() };
    let mut rows = |ui: &mut Ui| {
        for (axis, letter) in ["x", "y", "z"].into_iter().enumerate() {
            let entry = Number::new(&fill(name, &[&letter]), vector[axis])
                .label(letter)
                .hint(hint)
                .faint(missing)
                .in_space(space)
                .show(ui, editor.language(), &format!("{id}.{letter}"), width);
            let entry = entry.try_map(|value| {
                let mut new = vector;
                new[axis] = value;
                edit(new)
            });
            actions.push(Action::enter(missing, entry));
        }
    };
    if beside {
        ui.horizontal(rows);
    } else {
        rows(ui);
    }
}
