//! The panels on the right (thesis A.4), one file each: what belongs to the selected point and view.
//! A click on a heading folds its panel. What adds, removes and selects stands in the list and has keys.

pub(crate) mod curve;
pub(crate) mod orientation;
#[cfg(test)]
mod orientation_tests;
pub(crate) mod output;
pub(crate) mod parts;
mod position;
mod timing;
mod zoom;
#[cfg(test)]
mod zoom_tests;

use egui::{ScrollArea, Ui};

use crate::action::Action;
use crate::panels::parts::{MIN_HEIGHT_FOR_GAPS, WIDTH, apart};
use crate::state::Editor;

/// Shows the panels, which scroll in a low window; each one's actions are done before the next.
pub(crate) fn show(editor: &mut Editor, ui: &mut Ui) {
    let height = ui.available_height();
    let there = editor.outside_path().is_none();
    let mut panel = |ui: &mut Ui, show: &dyn Fn(&Editor, &mut Ui, &mut Vec<Action>)| {
        let context = ui.ctx().clone();
        editor.part(&context, |editor, actions| show(editor, ui, actions));
    };
    ScrollArea::vertical().show(ui, |ui| {
        ui.set_width(WIDTH);
        if height < MIN_HEIGHT_FOR_GAPS {
            ui.spacing_mut().item_spacing.y -= 1.0;
        }
        if !there {
            panel(ui, &position::not_here);
            // The rest shows what the path does here.
            ui.disable();
        }
        panel(ui, &position::show);
        apart(ui);
        panel(ui, &curve::show);
        apart(ui);
        panel(ui, &orientation::show);
        apart(ui);
        panel(ui, &zoom::show);
        apart(ui);
        panel(ui, &timing::show);
    });
}

#[cfg(test)]
mod tests;
