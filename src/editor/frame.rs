//! The layout: menu bar with the output field, panels on the left, the
//! movement window in the middle, sub-windows above.

use egui::{
    CentralPanel, Context, CornerRadius, Frame, Id, Key, Margin, Panel, Stroke, StrokeKind, Ui,
};

use super::state::Editor;
use super::{keys, menu, output, panels, space, theme, windows};

/// Height of the menu bar, in points.
const BAR: f32 = 32.0;

/// Width of the panels, in points.
const PANELS: f32 = panels::WIDTH + 24.0;

/// Shows everything, and does what was asked for.
pub(super) fn show(editor: &mut Editor, ui: &mut Ui) {
    let context = ui.ctx().clone();
    context.set_theme(editor.setup.theme.of_egui());
    let dragging = context.input(|input| input.pointer.any_down() || input.pointer.any_released());
    if !dragging && !editor.space.keeps_step_open() {
        // A drag whose end nobody saw: its control vanished meanwhile.
        editor.document.end_step();
    }
    let before = editor.stamp();
    let mut action = editor.waiting.take();
    if !editor.windows.ask() {
        action = action.or_else(|| keys::pressed(&context));
    }
    if action.is_some() {
        keys::release(&context);
    }
    let palette = editor.setup.theme.palette();
    let bar = Frame::new()
        .fill(palette.panel)
        .inner_margin(Margin::symmetric(8, 0));
    let picked = Panel::top("bar")
        .exact_size(BAR)
        .frame(bar)
        .show(ui, |ui| {
            egui::MenuBar::new()
                .ui(ui, |ui| {
                    ui.set_min_height(BAR);
                    let picked = menu::show(editor, ui);
                    output::show(editor, ui);
                    picked
                })
                .inner
        })
        .inner;
    Panel::left("panels")
        .resizable(false)
        .exact_size(PANELS)
        .frame(
            Frame::new()
                .fill(palette.panel)
                .inner_margin(Margin::same(12)),
        )
        .show(ui, |ui| panels::show(editor, ui));
    CentralPanel::default()
        .frame(Frame::new().fill(editor.background()))
        .show(ui, |ui| space::show(editor, ui));
    windows::show(editor, &context);
    if let Some(action) = action.or(picked) {
        editor.act(action, &context);
    }
    show_focus(&context);
    editor.typing = keys::remember_typing(&context);
    if editor.stamp() != before {
        // What stands further up was shown before the change.
        context.request_repaint();
    }
}

/// A border around what has the keyboard, if it came there by a key: who
/// clicks knows where.
fn show_focus(context: &Context) {
    let by_key = Id::unique("focus came by a key");
    let (pressed, walked) = context.input(|input| {
        let keys = [
            Key::Tab,
            Key::ArrowUp,
            Key::ArrowDown,
            Key::ArrowLeft,
            Key::ArrowRight,
        ];
        (
            input.pointer.any_pressed(),
            keys.iter().any(|&key| input.key_pressed(key)),
        )
    });
    if pressed || walked {
        context.data_mut(|data| data.insert_temp(by_key, walked && !pressed));
    }
    let Some(response) = context
        .memory(|memory| memory.focused())
        .filter(|_| {
            let by_key = context.data(|data| data.get_temp(by_key));
            by_key.unwrap_or(false) || context.text_edit_focused()
        })
        .and_then(|id| context.read_response(id))
    else {
        return;
    };
    let palette = theme::palette_of(&context.global_style().visuals);
    let painter = context
        .layer_painter(response.layer_id)
        .with_clip_rect(response.interact_rect.expand(3.0));
    painter.rect_stroke(
        response.rect,
        CornerRadius::same(4),
        Stroke::new(1.5, palette.focus),
        StrokeKind::Inside,
    );
}
