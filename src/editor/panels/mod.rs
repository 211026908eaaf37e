//! The panels on the left, one file each (thesis A.4).

mod orientation;
mod position;
mod speed;
mod zoom;

use egui::{Button, Color32, Response, RichText, ScrollArea, Sense, Ui, WidgetInfo, vec2};

use super::actions::Action;
use super::state::Editor;
use super::theme;

/// Between two panels.
const APART: f32 = 12.0;

/// Shows the panels from top to bottom. They scroll where the window is lower
/// than they are.
pub(super) fn show(editor: &mut Editor, ui: &mut Ui) {
    let height = ui.available_height();
    ScrollArea::vertical().show(ui, |ui| {
        position::show(editor, ui);
        ui.add_space(APART);
        orientation::show(editor, ui);
        ui.add_space(APART);
        speed::show(editor, ui, height);
        ui.add_space(APART);
        zoom::show(editor, ui);
    });
}

/// A panel's heading, with a remark at the right.
fn heading(ui: &mut Ui, text: &str, remark: &str) -> Response {
    let palette = theme::palette(ui);
    let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width(), 20.0), Sense::hover());
    let font = theme::digits();
    let (left, right) = (rect.left_center(), rect.right_center());
    let painter = ui.painter();
    painter.text(
        left,
        egui::Align2::LEFT_CENTER,
        text,
        font.clone(),
        palette.accent,
    );
    painter.text(
        right,
        egui::Align2::RIGHT_CENTER,
        remark,
        font,
        palette.weak,
    );
    response.widget_info(|| {
        let words = if remark.is_empty() {
            text.to_owned()
        } else {
            format!("{text}: {remark}")
        };
        WidgetInfo::labeled(egui::Role::Heading, true, words)
    });
    response
}

/// A button of a panel.
struct Key<'a> {
    text: &'a str,
    hint: &'a str,
    action: Action,
    /// For two that exclude each other: whether this one holds.
    chosen: Option<bool>,
}

impl<'a> Key<'a> {
    const fn new(text: &'a str, hint: &'a str, action: Action) -> Self {
        Self {
            text,
            hint,
            action,
            chosen: None,
        }
    }

    const fn chosen(mut self, chosen: bool) -> Self {
        self.chosen = Some(chosen);
        self
    }

    fn show(&self, editor: &mut Editor, ui: &mut Ui, width: f32) {
        let chosen = self.chosen == Some(true);
        let palette = theme::palette(ui);
        let mut text = RichText::new(self.text);
        let mut button = Button::new(text.clone());
        if chosen {
            text = text.color(palette.on_accent);
            button = Button::new(text).fill(palette.accent);
        }
        let button = match self.chosen {
            Some(chosen) => button.selected(chosen),
            None => button,
        };
        let response = ui.add_sized([width, theme::ROW], button);
        if response.on_hover_text(self.hint).clicked() {
            editor.act(self.action, ui.ctx());
        }
    }
}

/// Buttons of equal width that fill a row.
fn keys(editor: &mut Editor, ui: &mut Ui, keys: &[Key<'_>]) {
    let width = share(ui, keys.len());
    ui.horizontal(|ui| {
        for key in keys {
            key.show(editor, ui, width);
        }
    });
}

/// One to go back, where one is, one to go on.
fn round(editor: &mut Editor, ui: &mut Ui, back: &Key<'_>, place: &str, on: &Key<'_>) {
    let width = share(ui, 3);
    ui.horizontal(|ui| {
        back.show(editor, ui, width);
        words(ui, place, width, theme::palette(ui).text);
        on.show(editor, ui, width);
    });
}

/// A text in the middle of so much room.
fn words(ui: &mut Ui, text: &str, width: f32, color: Color32) -> Response {
    let (rect, response) = ui.allocate_exact_size(vec2(width, theme::ROW), Sense::hover());
    let center = rect.center();
    ui.painter().text(
        center,
        egui::Align2::CENTER_CENTER,
        text,
        theme::digits(),
        color,
    );
    response.widget_info(|| WidgetInfo::labeled(egui::Role::Label, true, text));
    response
}

/// Width of one of `count` things that fill a row.
fn share(ui: &Ui, count: usize) -> f32 {
    let gaps = (count - 1) as f32 * ui.spacing().item_spacing.x;
    ((ui.available_width() - gaps) / count as f32).floor()
}
