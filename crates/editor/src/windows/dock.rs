//! Docked windows: they have a fixed place, so that they never cover what they change.
//!
//! At the right they stand in place of the values of what is selected; the speeds of a section,
//! whose picture is wide, stand at the bottom. One is seen at a time: the one before comes back
//! when it closes. What one changes is seen at once; Enter keeps it, Escape gives it back.

use egui::{Align, Button, Context, Key, Layout, Modifiers, Rect, Stroke, Ui, vec2};

use crate::state::Editor;
use crate::state::windows::{
    CheckWindow, ColourWindow, CompareWindow, DisplayWindow, SpeedWindow, Windows,
};
use crate::theme::LARGE;
use crate::windows::sub_window::{SubWindow as _, layer, row_at_right, topmost};
use crate::{keys, theme};

/// Distance from the border to what stands in it.
const MARGIN: f32 = 12.0;

/// Height of its title, and of its last row with the gap above.
const TITLE: f32 = 28.0;
const LAST: f32 = theme::ROW + 8.0;

/// Width of a button of the last row.
const BUTTON: f32 = 88.0;

impl Windows {
    /// Brings a docked window to the front.
    pub(super) fn dock(&mut self, id: &'static str) {
        self.dock.order.retain(|other| *other != id);
        self.dock.order.push(id);
        self.dock.fresh.set(true);
    }

    /// The docked window in front.
    pub(crate) fn front(&self) -> Option<&'static str> {
        let is_open = |id: &&str| match *id {
            CheckWindow::ID => self.check.is_some(),
            CompareWindow::ID => self.compare.is_some(),
            SpeedWindow::ID => self.speed.is_some(),
            ColourWindow::ID => self.colours.is_some(),
            DisplayWindow::ID => self.display.is_some(),
            _ => self.tool.as_ref().is_some_and(|tool| !tool.waits()),
        };
        self.dock.order.iter().rev().copied().find(is_open)
    }

    /// Where the docked window in front stands.
    #[cfg(test)]
    pub(crate) fn dock_place(&self) -> Option<Rect> {
        self.front().and(self.dock.shown).map(|(_, place)| place)
    }

    /// Whether this window may be shown: docked ones only in front, and where there is a place.
    pub(super) fn may_show(&self, id: &'static str) -> bool {
        let docked = self.dock.order.contains(&id);
        !docked || self.dock.shown.is_some_and(|(shown, _)| shown == id)
    }
}

/// Gives the docked window in front its place: at the right, or what it takes at the bottom of
/// `middle` and `right`. Whether it stands at the right.
pub(crate) fn place(
    editor: &mut Editor,
    context: &Context,
    middle: &mut Rect,
    right: &mut Rect,
) -> bool {
    let front = editor.windows.front();
    let mut place = *right;
    if front == Some(SpeedWindow::ID) {
        let height = super::speed::height(context, middle.union(*right));
        let edge = middle.bottom() - height;
        place = middle.union(*right).with_min_y(edge);
        (middle.max.y, right.max.y) = (edge, edge);
    }
    editor.windows.dock.shown = front.map(|front| (front, place));
    front.is_some() && front != Some(SpeedWindow::ID)
}

/// The window that was given a place, with what it is closed by: `Some(true)` keeps, `Some(false)`
/// gives back. Those with something to give back have two buttons for it: word and hint of the one
/// that keeps are given, and whether it can be pressed.
pub(crate) fn docked(
    editor: &Editor,
    context: &Context,
    (id, title): (&'static str, &str),
    keeps: Option<([&str; 2], bool)>,
    add: impl FnOnce(&mut Ui),
) -> Option<bool> {
    let (_, place) = editor.windows.dock.shown?;
    let able = keeps.is_none_or(|(_, able)| able);
    // A question above it takes the keys.
    let asked = context.memory(|memory| memory.top_modal_layer().is_some());
    let first = !asked && topmost(context) == Some(layer(id));
    let mut end = (first && keys::take_escape(context)).then_some(false);
    // Enter is for a control that has the keyboard, but not for a part of the window such as the space.
    let focused = context.memory(|memory| memory.focused());
    let focused = focused.and_then(|id| context.read_response(id));
    let focused = focused.filter(|control| control.rect.size().min_elem() < LARGE);
    let free = !keys::was_typing(context) && focused.is_none();
    if first
        && able
        && free
        && !egui::Popup::is_any_open(context)
        && context.input_mut(|input| input.consume_key(Modifiers::NONE, Key::Enter))
    {
        end = Some(true);
    }
    let area = egui::Area::new(egui::Id::unique(id))
        .order(egui::Order::Middle)
        .movable(false)
        .constrain(false)
        .fixed_pos(place.min)
        .default_size(place.size());
    area.show(context, |ui| {
        let palette = theme::palette(ui);
        ui.painter().rect_filled(place, 0.0, palette.panel);
        let line = Stroke::new(1.0, palette.line);
        ui.painter()
            .vline(place.left() + 0.5, place.y_range(), line);
        ui.painter().hline(place.x_range(), place.top() + 0.5, line);
        ui.set_min_size(place.size());
        let inner = place.shrink(MARGIN);
        let inside = egui::UiBuilder::new().max_rect(inner.with_min_y(place.top() + 8.0));
        ui.scope_builder(inside, |ui| {
            ui.set_width(inner.width());
            if heading(ui, title, editor.texts().menu.close_window) {
                end = Some(false);
            }
            let last = if keeps.is_some() { LAST } else { 0.0 };
            let room = (inner.bottom() - ui.cursor().top() - last).max(48.0);
            let all = egui::ScrollArea::vertical()
                .id_salt("whole")
                .max_height(room);
            all.show(ui, |ui| {
                ui.set_width(inner.width());
                add(ui);
            });
            if let Some((words, _)) = keeps {
                let top = egui::pos2(inner.left(), ui.cursor().top() + LAST - theme::ROW);
                let row = Rect::from_min_size(top, vec2(inner.width(), theme::ROW));
                let row = egui::UiBuilder::new().max_rect(row);
                let pressed = ui.scope_builder(row, |ui| last_row(editor, ui, words, able));
                end = pressed.inner.or(end);
            }
        });
    });
    end
}

/// The title, and the cross that closes: whether it was clicked.
fn heading(ui: &mut Ui, title: &str, close: &str) -> bool {
    let row = vec2(ui.available_width(), TITLE);
    let layout = Layout::right_to_left(Align::Center);
    let row = ui.allocate_ui_with_layout(row, layout, |ui| {
        ui.set_min_height(TITLE);
        let cross = ui.add(
            Button::new("")
                .min_size(vec2(theme::ROW, theme::ROW))
                .frame(false),
        );
        cross.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, true, close));
        let palette = theme::palette(ui);
        let colour = if cross.hovered() {
            palette.text
        } else {
            palette.weak
        };
        let arms = Rect::from_center_size(cross.rect.center(), vec2(9.0, 9.0));
        let stroke = Stroke::new(1.5, colour);
        let painter = ui.painter();
        painter.line_segment([arms.left_top(), arms.right_bottom()], stroke);
        painter.line_segment([arms.right_top(), arms.left_bottom()], stroke);
        let words = egui::RichText::new(title)
            .font(theme::heading())
            .color(palette.text);
        ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
            let label = ui.add(egui::Label::new(words).truncate());
            label.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Heading, true, title));
        });
        cross.on_hover_text(close).clicked()
    });
    row.inner
}

/// What gives back and what keeps.
fn last_row(editor: &Editor, ui: &mut Ui, [ok, hint]: [&str; 2], able: bool) -> Option<bool> {
    let texts = &editor.texts().tools;
    let mut end = None;
    row_at_right(ui, &[texts.cancel, ok], BUTTON, |ui| {
        let button = |text| Button::new(text).min_size(vec2(BUTTON, theme::ROW));
        let cancel = ui.add(button(texts.cancel));
        if cancel.on_hover_text(texts.cancel_hint).clicked() {
            end = Some(false);
        }
        let ok = ui.add_enabled(able, button(ok));
        if editor.windows.dock.fresh.replace(false) {
            ok.request_focus();
        }
        if ok.on_hover_text(hint).clicked() {
            end = Some(true);
        }
    });
    end
}
