//! The sub-windows, one file each. Each may stay open while work goes on; what changes path or
//! looks is docked ([`docked`]), so that it lies over nothing.
//!
//! A sub-window is a struct with what is pending in it, a [`SubWindow`] with a slot in [`Windows`]:
//! open if the slot is filled. It is taken out of the slot while it is shown and put back if it
//! stays; then its actions are done. [`open`] opens one or brings it to the front; [`sub_window`]
//! gives all the same frame and the same ways to close.

pub(crate) mod check;
pub(crate) mod compare;
pub(crate) mod curve;
pub(crate) mod dock;
pub(crate) mod help;
pub(crate) mod points;
pub(crate) mod space;
pub(crate) mod speed;
pub(crate) mod tool;

use crate::state::windows::{
    CheckWindow, CompareWindow, CurveWindow, HelpWindow, PointsWindow, SpaceWindow, SpeedWindow,
    ToolWindow, Windows,
};
pub(crate) use dock::{docked, place};
pub(super) use speed::{goes_by_ten, shapes, slow_past};

use crate::action::Action;
use crate::frame::BAR;
use crate::keys;
use crate::state::Editor;
use crate::state::files::{FileWindow, Question, RecoveryWindow};
use crate::state::windows::{ColourWindow, DisplayWindow, ParentWindow};

/// Where a sub-window opens: from the window's upper left corner or, where that would hide the
/// movement window and so its own effect, from the upper right one, over the panels.
const OVER_SPACE: egui::Vec2 = egui::vec2(28.0, 64.0);
const OVER_PANELS: egui::Vec2 = egui::vec2(0.0, 72.0);

/// A narrower window has little room beside the panels.
const MIN_WIDTH_FOR_ROOM: f32 = 1000.0;

/// Whether menus and sub-windows should take little room.
pub(super) fn is_cramped(context: &egui::Context) -> bool {
    context.content_rect().width() < MIN_WIDTH_FOR_ROOM
}

/// A lower window cannot show every sub-window whole: they scroll. Height of a title and the frame.
const MIN_HEIGHT_FOR_ALL: f32 = 528.0;
const FRAME: f32 = 72.0;

/// Height of a row in such a window.
const LOW_ROW: f32 = 20.0;

/// Whether sub-windows cannot be shown whole as they are.
fn is_low(context: &egui::Context) -> bool {
    below_bar(context).height() < MIN_HEIGHT_FOR_ALL
}

/// All below the menus and the output field, which stay to be seen.
pub(super) fn below_bar(context: &egui::Context) -> egui::Rect {
    let whole = context.content_rect();
    whole.with_min_y(whole.top() + BAR)
}

/// How far the cross of a sub-window lies within its upper right corner.
const CROSS: f32 = 36.0;

/// A kind of sub-window; at most one of each is open.
pub(super) trait SubWindow: Sized {
    /// Its name for egui, which remembers its place by it.
    const ID: &'static str;
    const DOCKED: bool = false;

    /// Where it is kept while it is open.
    fn slot(windows: &mut Windows) -> &mut Option<Self>;

    fn new(editor: &Editor) -> Self;

    /// Shows it by [`sub_window`] or [`docked`] and pushes what it asks for. False: it closes.
    fn show(&mut self, editor: &Editor, context: &egui::Context, actions: &mut Vec<Action>)
    -> bool;
}

pub(super) fn open<W: SubWindow>(editor: &mut Editor, context: &egui::Context) {
    if W::slot(&mut editor.windows).is_none() {
        let window = W::new(editor);
        *W::slot(&mut editor.windows) = Some(window);
    }
    if W::DOCKED {
        editor.windows.dock(W::ID);
    }
    context.move_to_top(layer(W::ID));
}

pub(super) fn show(editor: &mut Editor, context: &egui::Context) {
    show_one::<CurveWindow>(editor, context);
    show_one::<SpeedWindow>(editor, context);
    show_one::<ColourWindow>(editor, context);
    show_one::<DisplayWindow>(editor, context);
    show_one::<PointsWindow>(editor, context);
    show_one::<SpaceWindow>(editor, context);
    show_one::<HelpWindow>(editor, context);
    let keep_up = |window: &mut CheckWindow, editor: &_, context: &_, _: &mut _| {
        window.keep_up(editor, context);
        true
    };
    show_slot(editor, context, CheckWindow::slot, keep_up);
    show_one::<CheckWindow>(editor, context);
    show_one::<CompareWindow>(editor, context);
    if editor.windows.files.is_none() {
        // The file that it asked for was not chosen.
        editor.windows.tool.take_if(|window| window.waits());
    }
    if editor.windows.may_show(ToolWindow::ID) {
        show_slot(editor, context, |open| &mut open.tool, ToolWindow::show);
    }
    show_slot(editor, context, |open| &mut open.parent, ParentWindow::show);
    show_one::<RecoveryWindow>(editor, context);
    show_slot(editor, context, |open| &mut open.files, FileWindow::show);
    show_slot(editor, context, |open| &mut open.question, Question::show);
    show_slot(editor, context, |open| &mut open.changed, Question::show);
}

/// The sub-windows that lie about; [`ToolWindow`] and the modal ones beside.
const ALL: [&str; 12] = [
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

/// Takes away the tooltips of this pass that would cover another window than that of the pointer.
pub(super) fn free_of_tooltips(context: &egui::Context) {
    let pointer = context.input(|input| input.pointer.latest_pos());
    let owner = pointer.and_then(|pointer| context.layer_id_at(pointer));
    if owner.is_some_and(|owner| owner.order > egui::Order::Middle) {
        // A menu lies above windows, a modal one alone.
        return;
    }
    let hidden: Vec<egui::LayerId> = context.memory(|memory| {
        let visible = memory.areas().visible_layer_ids();
        let others = ALL.map(layer).into_iter().chain(memory.top_modal_layer());
        let others = others.filter(|other| Some(*other) != owner && visible.contains(other));
        let others: Vec<_> = others
            .filter_map(|other| memory.area_rect(other.id))
            .collect();
        let covers = |layer: &egui::LayerId| {
            let rect = memory.area_rect(layer.id);
            rect.is_some_and(|rect| others.iter().any(|other| other.intersects(rect)))
        };
        let tips = visible
            .into_iter()
            .filter(|layer| layer.order == egui::Order::Tooltip);
        tips.filter(covers).collect()
    });
    context.graphics_mut(|graphics| {
        for layer in hidden {
            if let Some(list) = graphics.get_mut(layer) {
                (0..list.next_idx().0).for_each(|at| list.reset_shape(egui::layers::ShapeIdx(at)));
            }
        }
    });
}

/// Takes the keys of what has the keyboard in one of them.
pub(super) fn take_keys(editor: &mut Editor, context: &egui::Context) {
    if let Some(window) = &mut editor.windows.speed {
        window.take_keys(context);
    }
}

impl Windows {
    /// Another path is open: what is pending was meant for the old one.
    pub(super) fn path_replaced(&mut self) {
        self.paths += 1;
        self.tool = None;
        if let Some(window) = &mut self.curve {
            window.lose();
        }
    }

    /// Whether one is open that wants an answer first.
    pub(super) fn has_modal(&self) -> bool {
        self.files.is_some() || self.question.is_some() || self.changed.is_some()
    }
}

fn show_one<W: SubWindow>(editor: &mut Editor, context: &egui::Context) {
    if !editor.windows.may_show(W::ID) {
        return;
    }
    show_slot(
        editor,
        context,
        W::slot,
        |window, editor, context, actions| {
            let stays = W::show(window, editor, context, actions);
            if !W::DOCKED {
                name_cross(context, layer(W::ID), editor.texts().menu.close_window);
            }
            stays
        },
    );
}

/// Takes a window out of its slot, shows it, and does what it asks for.
fn show_slot<W>(
    editor: &mut Editor,
    context: &egui::Context,
    slot: impl Fn(&mut Windows) -> &mut Option<W>,
    show: impl FnOnce(&mut W, &Editor, &egui::Context, &mut Vec<Action>) -> bool,
) {
    if let Some(mut window) = slot(&mut editor.windows).take() {
        let mut actions = Vec::new();
        if show(&mut window, editor, context, &mut actions) {
            *slot(&mut editor.windows) = Some(window);
        }
        editor.act_all(actions, context);
    }
}

/// The frame of a sub-window: a title, a cross. Escape closes the topmost one, if no text field and
/// no menu has use for it. False: it was closed.
pub(super) fn sub_window(
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
fn name_cross(context: &egui::Context, layer: egui::LayerId, name: &str) {
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
fn topmost(context: &egui::Context) -> Option<egui::LayerId> {
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

fn layer(id: &'static str) -> egui::LayerId {
    egui::LayerId::new(egui::Order::Middle, egui::Id::unique(id))
}
