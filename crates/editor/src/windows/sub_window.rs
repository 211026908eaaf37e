//! What sub-windows share: the frame, the ways to close, the keyboard, how they fit into the room.

use crate::action::Action;
use crate::keys;
use crate::state::Editor;
use crate::state::files::RecoveryWindow;
use crate::state::windows::{
    CheckWindow, ColourWindow, CompareWindow, CurveWindow, DisplayWindow, HelpWindow, ParentWindow,
    PointsWindow, SpaceWindow, SpeedWindow, ToolWindow, Windows,
};
use crate::theme::BAR;

/// Where a sub-window opens: from the window's upper left corner or, where that would hide the
/// movement window and so its own effect, from the upper right one, over the panels.
pub(crate) const OVER_SPACE: egui::Vec2 = egui::vec2(28.0, 64.0);

pub(crate) const OVER_PANELS: egui::Vec2 = egui::vec2(0.0, 72.0);

/// A narrower window has little room beside the panels.
pub(crate) const MIN_WIDTH_FOR_ROOM: f32 = 1000.0;

/// Whether menus and sub-windows should take little room.
pub(crate) fn is_cramped(context: &egui::Context) -> bool {
    context.content_rect().width() < MIN_WIDTH_FOR_ROOM
}

/// A lower window cannot show every sub-window whole: they scroll. Height of a title and the frame.
pub(crate) const MIN_HEIGHT_FOR_ALL: f32 = 528.0;

pub(crate) const FRAME: f32 = 72.0;

/// Height of a row in such a window.
pub(crate) const LOW_ROW: f32 = 20.0;

/// Whether sub-windows cannot be shown whole as they are.
pub(crate) fn is_low(context: &egui::Context) -> bool {
    below_bar(context).height() < MIN_HEIGHT_FOR_ALL
}

/// All below the menus and the output field, which stay to be seen.
pub(crate) fn below_bar(context: &egui::Context) -> egui::Rect {
    let whole = context.content_rect();
    whole.with_min_y(whole.top() + BAR)
}

/// How far the cross of a sub-window lies within its upper right corner.
pub(crate) const CROSS: f32 = 36.0;

/// A kind of sub-window; at most one of each is open.
pub(crate) trait SubWindow: Sized {
    /// Its name for egui, which remembers its place by it.
    const ID: &'static str;
    const DOCKED: bool = false;

    /// Where it is kept while it is open.
    fn slot(windows: &mut Windows) -> &mut Option<Self>;

    fn new(editor: &Editor) -> Self;

    /// Shows it by [`sub_window`] or docked, and pushes what it asks for. False: it closes.
    fn show(&mut self, editor: &Editor, context: &egui::Context, actions: &mut Vec<Action>)
    -> bool;
}

/// The sub-windows that lie about; [`ToolWindow`] and the modal ones beside.
pub(crate) const ALL: [&str; 12] = [
    CurveWindow::ID,
    SpeedWindow::ID,
    ColourWindow::ID,
    DisplayWindow::ID,
    PointsWindow::ID,
    SpaceWindow::ID,
    HelpWindow::ID,
    CheckWindow::ID,
    CompareWindow::ID,
    RecoveryWindow::ID,
    ToolWindow::ID,
    ParentWindow::ID,
];

/// The frame of a sub-window: a title, a cross. Escape closes the topmost one, if no text field and
/// no menu has use for it. False: it was closed.
pub(crate) fn sub_window(
    context: &egui::Context,
    id: &'static str,
    title: &str,
    add: impl FnOnce(&mut egui::Ui),
) -> bool {
    let screen = context.content_rect();
    let (pivot, place) = if is_cramped(context) {
        (egui::Align2::RIGHT_TOP, screen.right_top() + OVER_PANELS)
    } else {
        (egui::Align2::LEFT_TOP, screen.left_top() + OVER_SPACE)
    };
    sub_window_as(
        context,
        id,
        title,
        |window| window.pivot(pivot).default_pos(place),
        add,
    )
}

/// The same, arranged in its own way.
pub(crate) fn sub_window_as(
    context: &egui::Context,
    id: &'static str,
    title: &str,
    arrange: impl FnOnce(egui::Window<'_>) -> egui::Window<'_>,
    add: impl FnOnce(&mut egui::Ui),
) -> bool {
    let mut open = true;
    // A question above it takes the key.
    let asked = context.memory(|memory| memory.top_modal_layer().is_some());
    let escape = !asked && topmost(context) == Some(layer(id)) && keys::take_escape(context);
    let window = egui::Window::new(title).id(egui::Id::unique(id));
    let below = below_bar(context);
    arrange(window)
        .constrain_to(below)
        .open(&mut open)
        .collapsible(false)
        .auto_sized()
        .show(context, |ui| {
            if !is_low(context) {
                return add(ui);
            }
            ui.spacing_mut().item_spacing.y = 2.0;
            ui.spacing_mut().interact_size.y = LOW_ROW;
            let room = (below.height() - FRAME).max(120.0);
            let all = egui::ScrollArea::vertical().id_salt("whole");
            all.max_height(room).show(ui, add).inner
        });
    open && !escape
}

/// Names the cross of a sub-window shown in this pass, for screen readers and as a tooltip: egui's
/// name is English. It is recognized by its place, the upper right corner.
pub(crate) fn name_cross(context: &egui::Context, layer: egui::LayerId, name: &str) {
    let Some(area) = context.memory(|memory| memory.area_rect(layer.id)) else {
        return;
    };
    let corner = egui::Rect::from_min_max(
        area.right_top() - egui::vec2(CROSS, 0.0),
        area.right_top() + egui::vec2(0.0, CROSS),
    );
    let cross = context.viewport(|viewport| {
        let mut widgets = viewport.this_pass.widgets.get_layer(layer);
        widgets
            .find(|widget| {
                let button = widget.sense.senses_click() && !widget.sense.senses_drag();
                button && corner.contains_rect(widget.rect)
            })
            .map(|widget| widget.id)
    });
    if let Some(id) = cross {
        context.accesskit_node_builder(id, |node| node.set_label(name));
        if let Some(response) = context.read_response(id) {
            response.on_hover_text(name);
        }
    }
}

/// The topmost sub-window.
pub(crate) fn topmost(context: &egui::Context) -> Option<egui::LayerId> {
    context.memory(|memory| {
        let shown = |layer: &egui::LayerId| {
            ALL.iter().any(|id| self::layer(id) == *layer)
                && memory.areas().visible_last_frame(layer)
        };
        memory.layer_ids().filter(shown).last()
    })
}

/// A window that wants an answer before anything else: in the middle, all else darkened.
pub(crate) fn modal(
    context: &egui::Context,
    id: &'static str,
    title: &str,
    width: f32,
    add: impl FnOnce(&mut egui::Ui),
) {
    let frame = egui::Frame::window(&context.global_style());
    egui::Modal::new(egui::Id::unique(id))
        .frame(frame.inner_margin(16))
        .show(context, |ui| {
            ui.set_width(width.min(context.content_rect().width() - 64.0));
            ui.heading(title);
            ui.add_space(8.0);
            add(ui);
        });
}

/// Gives the keyboard to what a window has for it when it opens; true when done. In the pass in
/// which egui finds the window's size nothing keeps it.
pub(crate) fn takes_keyboard(ui: &egui::Ui, response: &egui::Response, fresh: &mut bool) -> bool {
    let takes = *fresh && !ui.is_sizing_pass();
    if takes {
        *fresh = false;
        response.request_focus();
    }
    takes
}

/// Buttons that end where the row ends, with these words and at least this wide. They are made from
/// left to right, since Tab follows the order in which they are made.
pub(crate) fn row_at_right(
    ui: &mut egui::Ui,
    names: &[&str],
    least: f32,
    add: impl FnOnce(&mut egui::Ui),
) {
    ui.horizontal(|ui| {
        let padding = 2.0 * ui.spacing().button_padding.x;
        let widths = names.iter().map(|&name| {
            let words = egui::WidgetText::from(name).into_galley(
                ui,
                Some(egui::TextWrapMode::Extend),
                f32::INFINITY,
                egui::TextStyle::Button,
            );
            (words.size().x + padding).max(least)
        });
        let gaps = names.len().saturating_sub(1) as f32 * ui.spacing().item_spacing.x;
        let width = widths.sum::<f32>() + gaps;
        ui.add_space((ui.available_width() - width).max(0.0));
        add(ui);
    });
}

pub(crate) fn layer(id: &'static str) -> egui::LayerId {
    egui::LayerId::new(egui::Order::Middle, egui::Id::unique(id))
}
