//! The layout: menu bar, movement window over the timeline, panels at the right, sub-windows above.

use egui::{
    Color32, Context, CornerRadius, Event, Id, Key, Rect, Stroke, StrokeKind, Ui, UiBuilder, vec2,
};

use crate::action::{Action, FileAction};
use crate::entry::Entry;
use crate::panels::output;
use crate::setup::Theme;
use crate::space::camera_view;
use crate::state::Editor;
use crate::theme::{BAR, LARGE};
use crate::typed::Measures;
use crate::{keys, menu, panels, playing, points_list, scene_view, space, theme, windows};

const PANELS: f32 = panels::parts::WIDTH + 2.0 * MARGIN;

const MARGIN: f32 = 12.0;

impl Editor {
    /// Runs one pass: shows everything and takes the input.
    pub fn show(&mut self, ui: &mut egui::Ui) {
        self.closing = false;
        show(self, ui);
        self.keep_work(ui.ctx());
    }
}

fn show(editor: &mut Editor, ui: &mut Ui) {
    let context = ui.ctx().clone();
    // The host edits the path, too.
    editor.selected.follow(&editor.document);
    editor.scene_view.follow(&editor.document);
    if !editor.document.in_step() {
        editor.look_at_length();
    }
    if let Some(theme) = context.system_theme() {
        editor.setup.desktop = Theme::of_system(theme);
    }
    context.set_theme(editor.setup.theme().of_egui());
    let dragging = context.input(|input| input.pointer.any_down() || input.pointer.any_released());
    if !dragging && !editor.space.keeps_step_open() && editor.windows.tool.is_none() {
        // A drag whose end nobody saw, since its control vanished.
        editor.act(Action::Enter(Entry::End), &context);
    }
    if context.input(|input| input.events.contains(&Event::WindowFocused(true))) {
        editor.look_after_file();
        editor.look_after_meshes();
    }
    let info = editor.document.info();
    let measures = Measures {
        fps: info.fps,
        length: info.unit.clone(),
    };
    context.data_mut(|data| data.insert_temp(Id::NULL, measures));
    let actions = asked(editor, &context);
    let palette = editor.setup.theme().palette();
    let whole = ui.max_rect();
    let (bar, below) = whole.split_top_bottom_at_y(whole.top() + BAR);
    let first = editor.is_first_screen();
    let panels = if first { 0.0 } else { PANELS };
    let (mut middle, mut right) = below.split_left_right_at_x(below.right() - panels);
    if !first {
        let inside = UiBuilder::new().max_rect(below);
        let top = ui.scope_builder(inside, |ui| {
            playing::show(editor, ui);
            ui.available_rect_before_wrap().bottom()
        });
        (middle.max.y, right.max.y) = (top.inner, top.inner);
    }
    let docked = windows::place(editor, &context, &mut middle, &mut right);
    // First what moves under the pointer: panels and output field then show it in this pass.
    part(ui, "space", middle, editor.background(), |ui| {
        space::show(editor, ui)
    });
    let before = editor.stamp();
    let picked = part(ui, "bar", bar, palette.panel, |ui| {
        ui.set_clip_rect(bar);
        let room = bar.shrink2(vec2(8.0, 0.0));
        let bar = egui::MenuBar::new();
        let inside = UiBuilder::new().max_rect(room);
        ui.scope_builder(inside, |ui| {
            bar.ui(ui, |ui| {
                ui.set_min_height(BAR);
                let picked = menu::show(editor, ui);
                picked.or(output::show(editor, ui))
            })
        })
    });
    let picked = picked.inner.inner;
    part(ui, "panels", right, palette.panel, |ui| {
        let inside = UiBuilder::new().max_rect(right.shrink(MARGIN));
        ui.scope_builder(inside, |ui| {
            if docked || first {
                // A window stands there.
            } else {
                scene_view::beside(editor, ui);
            }
        });
    });
    let line = Stroke::new(1.0, palette.line);
    ui.painter()
        .hline(whole.x_range(), bar.bottom() - 0.5, line);
    ui.painter()
        .vline(right.left() + 0.5, right.y_range(), line);
    windows::show(editor, &context);
    windows::free_of_tooltips(&context, right);
    for (number, action) in actions.into_iter().chain(picked).enumerate() {
        // The first may have raised a question: the rest was typed blindly.
        if number > 0 && editor.windows.has_modal() {
            break;
        }
        editor.act(action, &context);
    }
    show_focus(&context);
    if let Some(pane) = &mut editor.host_pane {
        pane.add_what_lies_above(&context, camera_view::id());
    }
    editor.typing = keys::remember_typing(&context);
    if editor.stamp() != before {
        // What stands further up was shown before the change.
        context.request_repaint();
    }
}

/// What keys and dropped files ask for, and what waited.
fn asked(editor: &mut Editor, context: &Context) -> Vec<Action> {
    let mut actions = Vec::from_iter(editor.waiting.take());
    if !editor.windows.has_modal() {
        if !editor.is_first_screen() {
            points_list::take_keys(editor, context);
            scene_view::take_keys(editor, context);
            playing::take_keys(editor, context);
        }
        windows::take_keys(editor, context);
        let scene = editor.document.edited_scene().is_some();
        let menus = menu::letters(editor.language(), editor.fixed_speeds);
        let menus = menus.map(|(letter, _)| letter);
        let mut pressed = keys::pressed(context, scene, &menus);
        pressed.retain(|action| !windows::close_front(&mut editor.windows, action));
        if editor.is_first_screen() {
            pressed.retain(|action| !action.needs_path());
        }
        actions.extend(pressed);
        let dropped: Vec<_> = context.input(|input| {
            let files = input.raw.dropped_files.iter();
            files.map(|file| file.path().to_owned()).collect()
        });
        actions.extend((!dropped.is_empty()).then_some(Action::File(FileAction::Dropped(dropped))));
    }
    // Those of a scene are no keys while a text is typed; undone, a node is deleted again by the
    // same key.
    let of_scene = |action: &Action| matches!(action, Action::Node(_));
    if !actions.iter().all(of_scene) && !scene_view::has_keyboard(context) {
        keys::release(context);
    }
    actions
}

fn part<R>(
    ui: &mut Ui,
    name: &str,
    rect: Rect,
    fill: Color32,
    add: impl FnOnce(&mut Ui) -> R,
) -> R {
    ui.painter().rect_filled(rect, CornerRadius::ZERO, fill);
    let inside = UiBuilder::new().max_rect(rect).id_salt(name);
    ui.scope_builder(inside, add).inner
}

/// A border around what has the keyboard, if that came by a key: who clicks knows where.
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
    // Outside a control, since a selected one has the same colour; inside a large part, which
    // reaches up to its neighbours.
    let kind = if response.rect.size().min_elem() > LARGE {
        StrokeKind::Inside
    } else {
        StrokeKind::Outside
    };
    let rounding = CornerRadius::same(4);
    painter.rect_stroke(
        response.rect,
        rounding,
        Stroke::new(2.0, palette.focus),
        kind,
    );
}
