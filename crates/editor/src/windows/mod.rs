//! The sub-windows, one file each. Each may stay open while work goes on; what changes path or
//! looks is docked ([`dock::docked`]), so that it lies over nothing.
//!
//! A sub-window is a struct with what is pending in it, a [`SubWindow`] with a slot in [`Windows`]:
//! open if the slot is filled. It is taken out of the slot while it is shown and put back if it
//! stays; then its actions are done. [`open`] opens one or brings it to the front; [`sub_window`]
//! gives all the same frame and the same ways to close.

mod check;
mod compare;
pub(crate) mod curve;
pub(crate) mod dock;
mod fit;
mod help;
mod points;
#[cfg(test)]
mod preview_tests;
mod space;
pub(crate) mod speed;
pub(crate) mod sub_window;
mod tool;

use vides_document::Document;

use crate::action::Action;
use crate::state::Editor;
use crate::state::files::{FileWindow, Question, RecoveryWindow};
use crate::state::windows::{
    CheckWindow, ColourWindow, CompareWindow, CurveWindow, DisplayWindow, HelpWindow, ParentWindow,
    PointsWindow, SpaceWindow, SpeedWindow, ToolWindow, Windows,
};
use crate::windows::sub_window::{ALL, SubWindow, layer, name_cross};
pub(crate) use dock::place;
pub(super) use speed::shapes;

/// Between the panels and their tooltips.
const BESIDE: f32 = 4.0;

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

/// Closes the window that a key opens, if it is in front: the same key opens and closes. Whether it
/// did.
pub(super) fn close_front(windows: &mut Windows, action: &Action) -> bool {
    match action {
        Action::Keys => close_one::<HelpWindow>(windows),
        Action::Curve => close_one::<CurveWindow>(windows),
        Action::SpeedCurve => close_one::<SpeedWindow>(windows),
        Action::Check => close_one::<CheckWindow>(windows),
        _ => false,
    }
}

fn close_one<W: SubWindow>(windows: &mut Windows) -> bool {
    let front = !W::DOCKED || windows.front() == Some(W::ID);
    front && W::slot(windows).take().is_some()
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

/// Puts the tooltips of the `panels` beside them, where they cover no field, and takes away those of
/// this pass that would cover another window than that of the pointer.
pub(super) fn free_of_tooltips(context: &egui::Context, panels: egui::Rect) {
    let pointer = context.input(|input| input.pointer.latest_pos());
    let owner = pointer.and_then(|pointer| context.layer_id_at(pointer));
    if owner.is_some_and(|owner| owner.order > egui::Order::Middle) {
        // A menu lies above windows, a modal one alone.
        return;
    }
    let beside = pointer.is_some_and(|pointer| panels.contains(pointer));
    let aside = |rect: egui::Rect| {
        let far = rect.right() - panels.left() + BESIDE;
        let by = if beside {
            far.clamp(0.0, rect.left().max(0.0))
        } else {
            0.0
        };
        egui::vec2(-by, 0.0)
    };
    let tips: Vec<_> = context.memory(|memory| {
        let layers = memory.areas().visible_layer_ids().into_iter();
        let tips = layers.filter(|layer| layer.order == egui::Order::Tooltip);
        tips.filter_map(|layer| Some((layer, memory.area_rect(layer.id)?)))
            .collect()
    });
    for &(layer, rect) in &tips {
        let place = egui::emath::TSTransform::from_translation(aside(rect));
        context.set_transform_layer(layer, place);
    }
    let hidden: Vec<egui::LayerId> = context.memory(|memory| {
        let visible = memory.areas().visible_layer_ids();
        let others = ALL.map(layer).into_iter().chain(memory.top_modal_layer());
        let others = others.filter(|other| Some(*other) != owner && visible.contains(other));
        let others: Vec<_> = others
            .filter_map(|other| memory.area_rect(other.id))
            .collect();
        let covers = |rect: egui::Rect| {
            let rect = rect.translate(aside(rect));
            others.iter().any(|other| other.intersects(rect))
        };
        let covering = tips.iter().filter(|(_, rect)| covers(*rect));
        covering.map(|(layer, _)| *layer).collect()
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
    if let Some(window) = &mut editor.windows.help {
        window.take_keys(context);
    }
    if let Some(window) = &mut editor.windows.speed {
        window.take_keys(context);
    }
}

impl Windows {
    /// The document without what a tool shows of it.
    pub(super) fn without_preview<'a>(&'a self, document: &'a Document) -> &'a Document {
        let tool = self.tool.as_ref();
        let unapplied = tool.and_then(|window| window.unapplied.as_deref());
        unapplied.unwrap_or(document)
    }

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
