//! The list of the scene's nodes: a tree that folds. Nodes are selected, renamed, hidden, copied,
//! removed and put into others here. Only rows that are seen are made.

use egui::{
    Align2, Context, CornerRadius, CursorIcon, Event, EventFilter, Id, Key, Modifiers, Rect,
    RichText, Role, ScrollArea, Sense, Stroke, StrokeKind, Ui, WidgetInfo, vec2,
};

use super::list_row::{EYE, Shown, kind, paint, show_eye, sign_color};
use super::panel::trouble;
use super::selection::select;
use crate::action::Action;
use crate::clipboard::is_keys;
use crate::state::Editor;
use crate::state::points_list::NameField;
use crate::state::scene_view::{NodeCommand, SceneList};
use crate::texts::fill;
use crate::theme;

/// The indent of each level of the tree, and the deepest level that is indented.
const INDENT: f32 = 12.0;
const DEEPEST: usize = 6;

/// Room for the sign that folds.
const SIGN: f32 = 16.0;

/// Where there are more nodes names can be looked for.
const MANY: usize = 12;

/// Whether this pass has shown the list.
pub(super) fn is_shown(editor: &Editor, context: &Context) -> bool {
    editor.scene_view.list.borrow().pass == context.cumulative_pass_nr()
}

/// Shows the list, at most this high, if there is a scene.
pub(crate) fn list(editor: &Editor, ui: &mut Ui, highest: f32, actions: &mut Vec<Action>) {
    let Some(edited) = editor.document.edited_scene() else {
        return;
    };
    // Taken out, since the editor is read meanwhile.
    let mut list = editor.scene_view.list.take();
    let mut selected = editor.selected_nodes();
    let shown = Shown {
        editor,
        scene: edited.scene(),
        current: selected.first().copied(),
        selected: {
            selected.sort_unstable();
            selected
        },
    };
    list.pass = ui.ctx().cumulative_pass_nr();
    list.follow(&shown, edited.number());
    list.show(&shown, ui, highest, actions);
    editor.scene_view.list.replace(list);
    if let Some(trouble) = trouble(editor) {
        ui.add_space(theme::GAP);
        ui.label(RichText::new(trouble).color(theme::palette(ui).error));
    }
}

pub(super) fn id() -> Id {
    Id::unique("list of nodes")
}

/// Whether keys mean nodes.
pub(crate) fn has_keyboard(context: &Context) -> bool {
    context.memory(|memory| memory.has_focus(id()))
}

/// Takes the keys that mean nodes where the list has the keyboard.
pub(crate) fn take_keys(editor: &mut Editor, context: &Context) {
    if !has_keyboard(context) {
        return;
    }
    if editor.document.edited_scene().is_none() {
        return;
    }
    if pressed(context, Modifiers::NONE, Key::F2) {
        editor.name_current_node();
    }
    let mut actions = Vec::new();
    if pressed(context, Modifiers::NONE, Key::Delete) {
        actions.push(Action::Nodes(NodeCommand::Remove));
    }
    if pressed(context, Modifiers::CTRL, Key::D) {
        actions.push(Action::Nodes(NodeCommand::Copy));
    }
    if pressed(context, Modifiers::CTRL, Key::A) {
        editor.select_all_nodes();
    }
    editor.act_all(actions, context);
    take_clipboard(editor, context);
}

impl Editor {
    /// Lets the user type another name into the row of the current node.
    pub(crate) fn name_current_node(&mut self) {
        let (Some(edited), Some(node)) = (self.document.edited_scene(), self.current_node()) else {
            return;
        };
        let name = edited.scene().nodes()[node].name.clone();
        self.scene_view.list.get_mut().rename(node, name);
    }
}

/// Whether a key was pressed; one that is held counts once.
fn pressed(context: &Context, with: Modifiers, wanted: Key) -> bool {
    let mut found = false;
    context.input_mut(|input| {
        input.events.retain(|event| match event {
            Event::Key {
                key,
                pressed: true,
                repeat,
                modifiers,
                ..
            } if *key == wanted && modifiers.matches_exact(with) => {
                found |= !repeat;
                false
            }
            _ => true,
        });
    });
    found
}

/// Copies, cuts and pastes nodes, and not points.
fn take_clipboard(editor: &mut Editor, context: &Context) {
    let [mut copies, mut cuts, pastes] =
        [Key::C, Key::X, Key::V].map(|key| pressed(context, Modifiers::CTRL, key));
    let mut pasted = Vec::new();
    context.input_mut(|input| {
        input.events.retain_mut(|event| {
            match event {
                Event::Copy => copies = true,
                Event::Cut => cuts = true,
                Event::Paste(text) => pasted.push(std::mem::take(text)),
                _ => return true,
            }
            false
        });
    });
    if copies {
        editor.copy_nodes_out(context);
    }
    if cuts {
        editor.cut_nodes(context);
    }
    if pastes {
        // It comes as an event.
        Editor::ask_for_clipboard(context);
    }
    let paste = |text: String| match is_keys(&text) {
        true => Action::Pasted(text),
        false => Action::Nodes(NodeCommand::Paste(text)),
    };
    editor.act_all(pasted.into_iter().map(paste), context);
}

impl SceneList {
    /// A node that is folded stays so under its new name.
    pub(super) fn renamed(&mut self, from: &str, to: &str) {
        self.rows.rename(from, to);
    }

    fn rename(&mut self, node: usize, name: String) {
        // Scrolls to its row.
        self.shown = None;
        self.renaming = Some((node, NameField::new(name)));
    }

    /// Brings the rows up to date; what has become current elsewhere is unfolded.
    fn follow(&mut self, shown: &Shown<'_>, number: u64) {
        let nodes = shown.scene.nodes();
        self.renaming.take_if(|(node, _)| *node >= nodes.len());
        self.dragged.take_if(|node| *node >= nodes.len());
        if let Some(current) = shown.current.filter(|_| self.shown != shown.current) {
            self.rows.unfold_to(nodes, current);
        }
        self.rows.filter(&self.filter);
        self.rows.update(shown.scene, number);
    }

    fn show(&mut self, of: &Shown<'_>, ui: &mut Ui, highest: f32, actions: &mut Vec<Action>) {
        ui.spacing_mut().item_spacing.y = 0.0;
        let mut room = highest;
        if of.scene.nodes().len() > MANY || !self.filter.is_empty() {
            self.show_filter(of.editor, ui);
            room -= theme::ROW + theme::GAP;
        }
        let count = self.rows.all().len() + 1;
        let high = (count as f32 * theme::ROW).min(room);
        let rect = Rect::from_min_size(
            ui.available_rect_before_wrap().min,
            vec2(ui.available_width(), high),
        );
        let response = ui.interact(rect, id(), Sense::focusable_noninteractive());
        let name = of.editor.texts().scene.title;
        response.widget_info(|| WidgetInfo::labeled(Role::Tree, true, name));
        let arrows = EventFilter {
            vertical_arrows: true,
            horizontal_arrows: true,
            ..EventFilter::default()
        };
        ui.memory_mut(|memory| memory.set_focus_lock_filter(id(), arrows));
        if response.has_focus() {
            self.by_keys(of, ui, actions);
        }
        let mut area = ScrollArea::vertical()
            .id_salt("scene")
            .max_height(room)
            .auto_shrink([false, true]);
        if let Some(offset) = self.wanted.take().or_else(|| self.scroll_for(of)) {
            area = area.vertical_scroll_offset(offset);
        }
        let output = area.show_rows(ui, theme::ROW, count, |ui, seen| {
            for row in seen {
                match row == count - 1 {
                    true => below(of, ui, actions),
                    false => self.row(of, ui, row, actions),
                }
            }
        });
        let top = output.state.clamped_offset().y;
        self.seen = (top, top + output.inner_rect.height());
        if let Some(dragged) = self.dragged {
            self.drag(of, ui, output.inner_rect, dragged, actions);
        }
        if count == 1 && !self.filter.is_empty() {
            let weak = theme::palette(ui).weak;
            ui.label(RichText::new(of.editor.texts().scene.not_found).color(weak));
        }
    }

    fn show_filter(&mut self, editor: &Editor, ui: &mut Ui) {
        let texts = &editor.texts().scene;
        let words = (texts.filter, texts.filter_hint);
        let width = ui.available_width() - 12.0;
        let response = theme::line_edit(ui, &mut self.filter, "scene.filter", width, words);
        if self.filter.is_empty() && !response.has_focus() {
            let at = response.rect.left_center() + vec2(8.0, 0.0);
            let color = theme::palette(ui).weak;
            let painter = ui.painter();
            painter.text(at, Align2::LEFT_CENTER, texts.filter, theme::text(), color);
        }
        ui.add_space(theme::GAP);
    }

    /// Up and down go through the rows, left and right fold and unfold.
    fn by_keys(&mut self, of: &Shown<'_>, ui: &Ui, actions: &mut Vec<Action>) {
        let pressed = |key| ui.input_mut(|input| input.consume_key(Modifiers::NONE, key));
        let rows = self.rows.all();
        let at = of.current.and_then(|current| self.rows.of(current));
        let row = at.map(|at| rows[at]);
        if pressed(Key::ArrowDown) {
            let next = rows.get(at.map_or(0, |at| at + 1));
            actions.extend(next.map(|row| select(row.node)));
        }
        if pressed(Key::ArrowUp) {
            let before = at.and_then(|at| at.checked_sub(1));
            actions.extend(before.map(|at| select(rows[at].node)));
        }
        let folds = pressed(Key::ArrowLeft);
        let unfolds = pressed(Key::ArrowRight);
        let Some(row) = row.filter(|_| folds || unfolds) else {
            return;
        };
        let node = &of.scene.nodes()[row.node];
        match (row.open, folds) {
            (Some(open), folds) if open == folds => self.rows.fold(&node.name, folds),
            (_, true) => actions.extend(node.parent.map(select)),
            (Some(_), false) => {
                let inside = at.and_then(|at| rows.get(at + 1));
                actions.extend(inside.map(|row| select(row.node)));
            }
            (None, false) => {}
        }
    }

    /// Where to scroll to show what has become current elsewhere.
    fn scroll_for(&mut self, of: &Shown<'_>) -> Option<f32> {
        if std::mem::replace(&mut self.shown, of.current) == of.current {
            return None;
        }
        let row = self.rows.of(of.current?)?;
        let (top, bottom) = self.seen;
        let begin = row as f32 * theme::ROW;
        if begin < top {
            Some(begin)
        } else if begin + theme::ROW > bottom && bottom > top {
            Some(begin + theme::ROW - (bottom - top))
        } else {
            None
        }
    }

    fn row(&mut self, of: &Shown<'_>, ui: &mut Ui, index: usize, actions: &mut Vec<Action>) {
        let size = vec2(ui.available_width(), theme::ROW);
        let (rect, _) = ui.allocate_exact_size(size, Sense::hover());
        let Some(&row) = self.rows.all().get(index) else {
            return;
        };
        let node = &of.scene.nodes()[row.node];
        let texts = &of.editor.texts().scene;
        let left = rect.left() + INDENT * row.level.min(DEEPEST) as f32;
        let sign = rect.with_min_x(left).with_max_x(left + SIGN);
        if let Some((_, field)) = self.renaming.as_mut().filter(|of| of.0 == row.node) {
            let room = rect.with_min_x(sign.right());
            if let Some(done) = field.show(ui, id().with("name"), texts.name, room) {
                let rename = |name| Action::Nodes(NodeCommand::Rename(row.node, name));
                actions.extend(done.map(rename));
                self.renaming = None;
                // A click went elsewhere.
                if ui.input(|input| !input.pointer.any_pressed()) {
                    ui.memory_mut(|memory| memory.request_focus(id()));
                }
            }
            return;
        }
        let place = id().with(row.node);
        let response = ui.interact(rect, place, Sense::click_and_drag());
        let selected = of.selected.binary_search(&row.node).is_ok();
        let label = format!("{} {}", node.name, kind(of.editor, node));
        response.widget_info(|| WidgetInfo::selected(Role::ListItem, true, selected, &label));
        let eye = rect.with_min_x(rect.right() - EYE);
        paint(
            of,
            ui,
            rect.with_min_x(sign.right()).with_max_x(eye.left()),
            row,
            &response,
        );
        let modifiers = ui.input(|input| input.modifiers);
        if response.clicked() || response.drag_started() && !selected {
            ui.memory_mut(|memory| memory.request_focus(id()));
            actions.push(self.choice(of, index, modifiers));
        }
        if response.double_clicked() {
            self.rename(row.node, node.name.clone());
        }
        if response.drag_started() {
            self.dragged = Some(row.node);
        }
        if of.current == Some(row.node) {
            ui.ctx().accesskit_node_builder(response.id, |node| {
                node.set_aria_current(egui::accesskit::AriaCurrent::True);
            });
        }
        let hint = match (node.path(), node.keys().tracks().is_empty()) {
            (Some(_), _) => texts.edit_hint,
            (None, false) => texts.by_keys,
            (None, true) => texts.still,
        };
        response.on_hover_text(format!("{hint}\n{}", texts.row_hint));
        if let Some(open) = row.open {
            let name = if open { texts.fold } else { texts.unfold };
            let name = fill(name, &[&node.name]);
            let response = ui.interact(sign, place.with("fold"), Sense::click());
            response.widget_info(|| WidgetInfo::selected(Role::Button, true, open, &name));
            let color = sign_color(of, ui, row.node, response.hovered());
            let painter = ui.painter();
            painter.add(theme::triangle(sign.center(), open, color));
            if response.on_hover_text(name).clicked() {
                self.rows.fold(&node.name, open);
            }
        }
        show_eye(of, ui, eye, row.node, actions);
    }

    /// What a click on a row selects.
    fn choice(&self, of: &Shown<'_>, index: usize, modifiers: Modifiers) -> Action {
        let rows = self.rows.all();
        let node = rows[index].node;
        let current = of.current.and_then(|current| self.rows.of(current));
        if modifiers.command || modifiers.ctrl {
            let mut all = of.editor.selected_nodes();
            match all.iter().position(|&other| other == node) {
                Some(at) => drop(all.remove(at)),
                None => all.insert(0, node),
            }
            return Action::SelectNodes(all);
        }
        // The current one stays, so that another click counts from there.
        let Some(current) = current.filter(|_| modifiers.shift) else {
            return select(node);
        };
        let others = rows[current.min(index)..=current.max(index)].iter();
        let others = others.map(|row| row.node);
        let first = rows[current].node;
        let others = others.filter(|&other| other != first);
        Action::SelectNodes(std::iter::once(first).chain(others).collect())
    }

    /// Shows into what the dragged rows would be put, and puts them there.
    fn drag(
        &mut self,
        of: &Shown<'_>,
        ui: &Ui,
        area: Rect,
        dragged: usize,
        actions: &mut Vec<Action>,
    ) {
        let (pointer, down) = ui.input(|input| {
            let pointer = &input.pointer;
            (pointer.latest_pos(), pointer.any_down())
        });
        let escape = ui.input(|input| input.key_pressed(Key::Escape));
        if escape || !down {
            self.dragged = None;
        }
        let Some(pointer) = pointer.filter(|_| !escape) else {
            return;
        };
        if down {
            self.scroll_along(ui.ctx(), pointer.y - area.top());
        }
        let height = pointer.y - area.top() + self.seen.0;
        let row = (height / theme::ROW).floor().max(0.0) as usize;
        let rows = self.rows.all();
        let target = rows.get(row).map(|row| row.node);
        if row > rows.len() {
            return;
        }
        if !area.contains(pointer) || target == Some(dragged) {
            return;
        }
        if down {
            let top = area.top() + row as f32 * theme::ROW - self.seen.0;
            let place = Rect::from_x_y_ranges(area.x_range(), top..=top + theme::ROW);
            let line = Stroke::new(2.0, theme::palette(ui).accent);
            ui.painter().rect_stroke(
                place.intersect(area).shrink(1.0),
                CornerRadius::same(3),
                line,
                StrokeKind::Inside,
            );
            ui.set_cursor_icon(CursorIcon::Grabbing);
        } else if of.scene.nodes().get(dragged).is_some() {
            actions.push(Action::Nodes(NodeCommand::PutInto(
                of.editor.selected_nodes(),
                target,
            )));
        }
    }

    /// Scrolls on while the pointer is held at an end, at this height of what is seen.
    fn scroll_along(&mut self, context: &Context, at: f32) {
        let (top, bottom) = self.seen;
        let step = if at < theme::ROW / 2.0 {
            -theme::ROW / 2.0
        } else if at > bottom - top - theme::ROW / 2.0 {
            theme::ROW / 2.0
        } else {
            return;
        };
        let all = (self.rows.all().len() + 1) as f32 * theme::ROW;
        let wanted = (top + step).clamp(0.0, (all - (bottom - top)).max(0.0));
        if wanted != top {
            self.wanted = Some(wanted);
            context.request_repaint();
        }
    }
}

/// The room below the last row, which is in no node.
fn below(of: &Shown<'_>, ui: &mut Ui, actions: &mut Vec<Action>) {
    let texts = &of.editor.texts().scene;
    let size = vec2(ui.available_width(), theme::ROW);
    let (_, response) = ui.allocate_exact_size(size, Sense::click());
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, texts.below));
    if response.clicked() {
        ui.memory_mut(|memory| memory.request_focus(id()));
        actions.push(Action::SelectNodes(Vec::new()));
    }
    response.on_hover_text(texts.below_hint);
}

#[cfg(test)]
#[path = "list_shown_tests.rs"]
mod shown_tests;
#[cfg(test)]
#[path = "list_tests.rs"]
pub(super) mod tests;
