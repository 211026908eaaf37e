//! The list of points beside the movement window: number, name, frame and orientations of each.
//! Points are selected, renamed and reordered here. A scene's list of nodes stands above it.
//!
//! It is folded in a narrow window at first; a click on its heading folds or unfolds it.

use egui::epaint::TextShape;
use egui::{
    Align2, Color32, Context, CornerRadius, EventFilter, Id, Key, Modifiers, Painter, Rect,
    Response, Role, ScrollArea, Sense, Stroke, TextEdit, Ui, UiBuilder, WidgetInfo, pos2, vec2,
};
use vides_document::{At, Document, Edit, Selection};

use crate::action::{Action, PathAction};
use crate::panels::parts::{PanelButton, button_row};
use crate::state::Editor;
use crate::state::points_list::{NameField, PointsList, Renaming, Row};
use crate::state::selected::SelectionChange;
use crate::texts::fill;
use crate::{keys, scene_view, theme};

/// Its share of the window's width, its least and largest width in points, its width when folded.
const SHARE: f32 = 0.12;
const WIDTH: [f32; 2] = [140.0, 210.0];
const FOLDED: f32 = 18.0;

/// A narrower window shows it folded at first.
const MIN_WIDTH_UNFOLDED: f32 = 1100.0;

/// The room of the buttons below the rows.
const BUTTONS: f32 = 2.0 * theme::ROW + 3.0 * theme::GAP;

const HEADING: f32 = 40.0;
const ROW: f32 = 22.0;

/// Room for a number, and the indent of orientations.
const NUMBER: f32 = 26.0;
const INDENT: f32 = 14.0;

/// Shows it at the left, and takes its room away.
pub(super) fn show(editor: &mut Editor, ui: &mut Ui) {
    let context = ui.ctx().clone();
    editor.part_of(
        &context,
        |editor| &mut editor.points_list,
        |editor, list, actions| list.show(editor, ui, actions),
    );
}

/// Takes F2 where the list has the keyboard: a point is renamed.
pub(super) fn take_keys(editor: &mut Editor, context: &Context) {
    let mine = context.memory(|memory| memory.has_focus(id()));
    if mine && context.input_mut(|input| input.consume_key(Modifiers::NONE, Key::F2)) {
        let point = editor.document.selection().point;
        editor.points_list.rename(&editor.document, point);
    }
}

fn id() -> Id {
    Id::unique("points list")
}

impl PointsList {
    /// Forgets all of another document.
    pub(super) fn show_anew(&mut self) {
        *self = Self {
            open: self.open,
            ..Self::default()
        };
    }

    pub(super) fn is_open(&self, context: &Context) -> bool {
        let whole = context.content_rect().width();
        self.open.unwrap_or(whole >= MIN_WIDTH_UNFOLDED)
    }

    fn show(&mut self, editor: &Editor, ui: &mut Ui, actions: &mut Vec<Action>) {
        let whole = ui.ctx().content_rect().width();
        let open = self.is_open(ui.ctx());
        let width = match open {
            // Nodes are indented, and have their kinds beside their names.
            true if editor.document.edited_scene().is_some() => WIDTH[1],
            true => (SHARE * whole).clamp(WIDTH[0], WIDTH[1]).floor(),
            false => FOLDED,
        };
        let frame = egui::Frame::new().fill(theme::palette(ui).panel);
        egui::Panel::left("points list")
            .resizable(false)
            .exact_size(width)
            .frame(frame)
            .show(ui, |ui| {
                ui.spacing_mut().item_spacing.y = 0.0;
                self.heading(editor, ui, open);
                if !open {
                    self.renaming = None;
                    return;
                }
                let edits_path = editor.document.edits_path();
                if editor.document.edited_scene().is_some() {
                    let share = if edits_path { 0.4 } else { 1.0 };
                    let highest = ui.available_height() * share;
                    let frame = egui::Frame::new().inner_margin(egui::Margin::symmetric(6, 0));
                    frame.show(ui, |ui| scene_view::list(editor, ui, highest, actions));
                    if edits_path {
                        let size = vec2(ui.available_width(), HEADING);
                        let (rect, _) = ui.allocate_exact_size(size, Sense::hover());
                        title(ui, rect, editor.texts().points_list.heading);
                    }
                }
                if edits_path {
                    let room = ui.available_rect_before_wrap();
                    let (rows, below) = room.split_top_bottom_at_y(room.bottom() - BUTTONS);
                    let inside = UiBuilder::new().max_rect(rows);
                    ui.scope_builder(inside, |ui| self.list(editor, ui, actions));
                    let inside = UiBuilder::new().max_rect(below.shrink(theme::GAP));
                    ui.scope_builder(inside, |ui| buttons(editor, ui, actions));
                }
            });
    }

    /// The heading, which folds it.
    fn heading(&mut self, editor: &Editor, ui: &mut Ui, open: bool) {
        let texts = &editor.texts().points_list;
        let high = if open { HEADING } else { ui.available_height() };
        let size = vec2(ui.available_width(), high);
        let (rect, response) = ui.allocate_exact_size(size, Sense::click());
        let name = if open { texts.fold } else { texts.unfold };
        response.widget_info(|| WidgetInfo::selected(Role::Button, true, open, name));
        let palette = theme::palette(ui);
        let color = match response.hovered() || response.has_focus() {
            true => palette.text,
            false => palette.weak,
        };
        let centre = pos2(rect.left() + FOLDED / 2.0, rect.top() + HEADING / 2.0);
        ui.painter().add(theme::triangle(centre, open, color));
        let heading = match editor.document.edited_scene() {
            Some(_) => editor.texts().scene.title,
            None => texts.heading,
        };
        if open {
            title(ui, rect, heading);
        } else {
            // From below, beside the space.
            let (font, text) = (theme::small(), heading.to_owned());
            let galley = ui.painter().layout_no_wrap(text, font, color);
            let at = pos2(
                rect.left() + 0.5 * (FOLDED - galley.size().y),
                rect.top() + HEADING + galley.size().x,
            );
            let words = TextShape::new(at, galley, color);
            ui.painter()
                .add(words.with_angle(-std::f32::consts::FRAC_PI_2));
        }
        if response.on_hover_text(name).clicked() {
            self.open = Some(!open);
        }
    }

    fn list(&mut self, editor: &Editor, ui: &mut Ui, actions: &mut Vec<Action>) {
        self.update(&editor.document);
        let rect = ui.available_rect_before_wrap();
        let response = ui.interact(rect, id(), Sense::focusable_noninteractive());
        let name = editor.texts().points_list.heading;
        response.widget_info(|| WidgetInfo::labeled(Role::List, true, name));
        let filter = EventFilter {
            vertical_arrows: true,
            escape: editor.several().is_some(),
            ..EventFilter::default()
        };
        ui.memory_mut(|memory| memory.set_focus_lock_filter(id(), filter));
        if response.has_focus() {
            by_keys(editor, ui, actions);
        }
        let mut area = ScrollArea::vertical()
            .id_salt("rows")
            .auto_shrink([false, false]);
        if let Some(offset) = self.wanted.take().or_else(|| self.scroll_for(editor)) {
            area = area.vertical_scroll_offset(offset);
        }
        let count = self.rows.len();
        let output = area.show_rows(ui, ROW, count, |ui, shown| {
            for index in shown {
                self.row(editor, ui, index, actions);
            }
        });
        let top = output.state.clamped_offset().y;
        self.seen = (top, top + output.inner_rect.height());
        if self.dragged.is_some() {
            let first = output.inner_rect.top() - top;
            self.drag(editor, ui, first, actions);
        }
    }

    fn update(&mut self, document: &Document) {
        if self.made_of == Some(document.revision()) {
            return;
        }
        self.made_of = Some(document.revision());
        self.rows.clear();
        for (point, of_point) in document.path().points.iter().enumerate() {
            self.rows.push(Row {
                at: Selection::at(point, 0),
                is_point: true,
            });
            self.rows
                .extend((1..of_point.orientations.len()).map(|view| Row {
                    at: Selection::at(point, view),
                    is_point: false,
                }));
        }
        let points = document.path().points.len();
        self.renaming.take_if(|renaming| renaming.point >= points);
    }

    /// Where to scroll to show what has become current elsewhere.
    fn scroll_for(&mut self, editor: &Editor) -> Option<f32> {
        let now = editor.document.selection();
        if self.shown.replace(now) == Some(now) {
            return None;
        }
        let row = self.rows.iter().position(|row| row.at == now)?;
        let (top, bottom) = self.seen;
        let begin = row as f32 * ROW;
        if begin < top {
            Some(begin)
        } else if begin + ROW > bottom && bottom > top {
            Some(begin + ROW - (bottom - top))
        } else {
            None
        }
    }

    fn row(&mut self, editor: &Editor, ui: &mut Ui, index: usize, actions: &mut Vec<Action>) {
        let Some(&Row { at, is_point }) = self.rows.get(index) else {
            return;
        };
        let size = vec2(ui.available_width(), ROW);
        let (rect, _) = ui.allocate_exact_size(size, Sense::hover());
        let Some(point) = editor.document.path().points.get(at.point) else {
            return;
        };
        let field = Rect::from_min_max(rect.min + vec2(NUMBER, 0.0), rect.max - vec2(4.0, 0.0));
        let renaming = self.renaming.as_mut();
        if let Some(renaming) = renaming.filter(|of| is_point && of.point == at.point) {
            paint_number(ui, rect, at, theme::palette(ui).text);
            if let Some(done) = renaming.show(editor, ui, field) {
                actions.extend(done);
                self.renaming = None;
            }
            return;
        }
        let texts = &editor.texts().points_list;
        let response = ui.interact(
            rect,
            id().with((at.point, at.orientation)),
            Sense::click_and_drag(),
        );
        let selected = editor.is_selected(at.point);
        let current = editor.document.selection() == at;
        let name = point
            .name
            .as_deref()
            .filter(|_| is_point)
            .unwrap_or_default();
        let label = match is_point {
            true => fill(texts.point, &[&(at.point + 1)]),
            false => fill(texts.view, &[&(at.point + 1), &(at.orientation + 1)]),
        };
        let label = match name {
            "" => label,
            name => format!("{label}: {name}"),
        };
        response.widget_info(|| WidgetInfo::selected(Role::ListItem, true, selected, &label));
        paint(editor, ui, rect, (at, is_point), name, &response);
        let modifiers = ui.input(|input| input.modifiers);
        if response.clicked() || response.drag_started() && !selected {
            ui.memory_mut(|memory| memory.request_focus(id()));
            actions.push(
                match (modifiers.command || modifiers.ctrl, modifiers.shift) {
                    (true, _) => Action::Choose(SelectionChange::Switch(at.point)),
                    (_, true) => Action::Choose(SelectionChange::UpTo(at.point)),
                    _ => Action::Choose(SelectionChange::Only(at)),
                },
            );
        }
        if response.double_clicked() && is_point {
            self.rename(&editor.document, at.point);
        }
        if response.drag_started() {
            self.dragged = Some(at.point);
        }
        if current {
            ui.ctx().accesskit_node_builder(response.id, |node| {
                node.set_aria_current(egui::accesskit::AriaCurrent::True);
            });
        }
        response.on_hover_text(texts.hint);
    }

    fn rename(&mut self, document: &Document, point: usize) {
        let Some(of_point) = document.path().points.get(point) else {
            return;
        };
        self.open = Some(true);
        // Scrolls to its row.
        self.shown = None;
        self.renaming = Some(Renaming {
            point,
            name: NameField::new(of_point.name.clone().unwrap_or_default()),
        });
    }

    /// Scrolls on while the pointer is held at an end, at this height of the rows.
    fn scroll_along(&mut self, context: &Context, at: f32) {
        let (top, bottom) = self.seen;
        let step = if at < top + ROW {
            -ROW / 2.0
        } else if at > bottom - ROW {
            ROW / 2.0
        } else {
            return;
        };
        let highest = (self.rows.len() as f32 * ROW - (bottom - top)).max(0.0);
        let wanted = (top + step).clamp(0.0, highest);
        if wanted != top {
            self.wanted = Some(wanted);
            context.request_repaint();
        }
    }

    /// Moves what is dragged to the pointer; `first`: where the first row begins.
    fn drag(&mut self, editor: &Editor, ui: &Ui, first: f32, actions: &mut Vec<Action>) {
        let (pointer, down) = ui.input(|input| {
            let pointer = &input.pointer;
            (pointer.latest_pos(), pointer.any_down())
        });
        let Some(pointer) = pointer else {
            return;
        };
        if ui.input(|input| input.key_pressed(Key::Escape)) {
            self.dragged = None;
            return;
        }
        // Between two points, after all orientations of the first.
        let border = (((pointer.y - first) / ROW).round().max(0.0) as usize).min(self.rows.len());
        let below = self.rows.get(border..).unwrap_or_default();
        let skipped = below.iter().take_while(|row| !row.is_point).count();
        let border = border + skipped;
        let points = editor.document.path().points.len();
        let before = self.rows.get(border).map_or(points, |row| row.at.point);
        if down {
            let y = first + border as f32 * ROW;
            let line = Stroke::new(2.0, theme::palette(ui).accent);
            ui.painter().hline(ui.max_rect().x_range(), y, line);
            ui.set_cursor_icon(egui::CursorIcon::Grabbing);
            self.scroll_along(ui.ctx(), pointer.y - first);
            return;
        }
        self.dragged = None;
        actions.push(Action::Path(PathAction::MoveSelected(before)));
    }
}

/// What adds and removes points and views.
fn buttons(editor: &Editor, ui: &mut Ui, actions: &mut Vec<Action>) {
    let (point, view) = (&editor.texts().position, &editor.texts().orientation);
    let points = [
        PanelButton::new(
            point.add,
            editor.add_hints()[0],
            Action::Path(PathAction::AddPoint),
        ),
        PanelButton::new(
            point.remove,
            point.remove_hint,
            Action::Path(PathAction::RemovePoint),
        ),
    ];
    let views = [
        PanelButton::new(
            view.add,
            view.add_hint,
            Action::Path(PathAction::AddOrientation),
        ),
        PanelButton::new(
            view.remove,
            view.remove_hint,
            Action::Path(PathAction::RemoveOrientation),
        ),
    ];
    ui.spacing_mut().item_spacing.y = theme::GAP;
    for row in [points, views] {
        button_row(editor, ui, &row, actions);
    }
}

/// Up and down go to the neighbouring points, Escape leaves one selected.
fn by_keys(editor: &Editor, ui: &Ui, actions: &mut Vec<Action>) {
    let pressed = |key| ui.input_mut(|input| input.consume_key(Modifiers::NONE, key));
    if pressed(Key::ArrowUp) && editor.document.selection().point > 0 {
        actions.push(Action::Path(PathAction::PreviousPoint));
    }
    let last = editor.document.path().points.len() - 1;
    if pressed(Key::ArrowDown) && editor.document.selection().point < last {
        actions.push(Action::Path(PathAction::NextPoint));
    }
    if editor.several().is_some() && keys::take_escape(ui.ctx()) {
        actions.push(Action::Choose(SelectionChange::Current));
    }
}

impl Renaming {
    /// The field in which it is typed; at the end returns what is to be done.
    fn show(&mut self, editor: &Editor, ui: &mut Ui, field: Rect) -> Option<Option<Action>> {
        let id = Id::unique("name of a point");
        let label = editor.texts().points_list.name;
        let done = self.name.show(ui, id, label, field)?;
        let rename = |name: String| {
            let name = Some(name).filter(|name| !name.is_empty());
            Action::Edit(Edit::set(At::Point(self.point), "name", name))
        };
        Some(done.map(rename))
    }
}

impl NameField {
    pub(crate) const fn new(text: String) -> Self {
        Self { text, fresh: true }
    }

    /// The field; at the end the name that was typed, none if the old one stays.
    pub(crate) fn show(
        &mut self,
        ui: &mut Ui,
        id: Id,
        label: &str,
        field: Rect,
    ) -> Option<Option<String>> {
        if self.fresh {
            theme::select(ui, id, &self.text);
            ui.memory_mut(|memory| memory.request_focus(id));
        }
        let edit = TextEdit::singleline(&mut self.text)
            .id(id)
            .frame(theme::field(ui))
            .margin(egui::Margin::symmetric(4, 0))
            .align(Align2::LEFT_CENTER)
            .min_size(vec2(0.0, field.height()));
        // The rows below stay where they are.
        let mut inside = ui.new_child(UiBuilder::new().max_rect(field));
        inside.spacing_mut().interact_size.y = field.height();
        let response = inside.put(field, edit.desired_width(field.width()));
        let context = ui.ctx();
        context.accesskit_node_builder(response.id, |node| node.set_label(label));
        if std::mem::take(&mut self.fresh) || !response.lost_focus() {
            return None;
        }
        let leaves = context.input(|input| input.key_pressed(Key::Escape));
        Some((!leaves).then(|| std::mem::take(&mut self.text)))
    }
}

fn title(ui: &Ui, rect: Rect, text: &str) {
    let at = pos2(rect.left() + FOLDED + 2.0, rect.center().y);
    let color = theme::palette(ui).text;
    let painter = ui.painter();
    painter.text(at, Align2::LEFT_CENTER, text, theme::heading(), color);
}

fn paint(
    editor: &Editor,
    ui: &Ui,
    rect: Rect,
    (at, is_point): (Selection, bool),
    name: &str,
    response: &Response,
) {
    let palette = theme::palette(ui);
    let here = editor.document.selection();
    let current = here == at;
    let selected = editor.is_selected(at.point) && (is_point || editor.several().is_some());
    let ground = if current {
        Some(palette.accent)
    } else if selected {
        Some(palette.pressed)
    } else {
        response.hovered().then_some(palette.button)
    };
    let painter = ui.painter();
    if let Some(ground) = ground {
        painter.rect_filled(rect.shrink2(vec2(2.0, 1.0)), CornerRadius::same(3), ground);
    }
    let [color, weak] = if current {
        [palette.on_accent; 2]
    } else if selected {
        [palette.text; 2]
    } else {
        [palette.text, palette.weak]
    };
    let right = frame(editor, painter, rect, at, weak);
    if is_point {
        paint_number(ui, rect, at, weak);
    } else {
        let number = format!("{}.{}", at.point + 1, at.orientation + 1);
        let left = pos2(rect.left() + NUMBER + INDENT - 8.0, rect.center().y);
        painter.text(left, Align2::LEFT_CENTER, number, theme::text(), color);
    }
    let room = rect
        .with_min_x(rect.left() + NUMBER)
        .with_max_x(right - 4.0);
    let mut job = egui::text::LayoutJob::simple_singleline(name.to_owned(), theme::text(), color);
    job.wrap = egui::text::TextWrapping::truncate_at_width(room.width().max(0.0));
    let galley = painter.layout_job(job);
    let at = Align2::LEFT_CENTER.anchor_size(room.left_center(), galley.size());
    painter.galley(at.min, galley, color);
}

fn paint_number(ui: &Ui, rect: Rect, at: Selection, color: Color32) {
    let place = pos2(rect.left() + NUMBER - 5.0, rect.center().y);
    let number = (at.point + 1).to_string();
    ui.painter()
        .text(place, Align2::RIGHT_CENTER, number, theme::text(), color);
}

/// The frame of a row at the right, as people count; returns where it begins.
fn frame(editor: &Editor, painter: &Painter, rect: Rect, at: Selection, color: Color32) -> f32 {
    let Some(mark) = editor.playing.mark_of(at) else {
        return rect.right();
    };
    let place = pos2(rect.right() - 8.0, rect.center().y);
    let frame = editor.document.frame_of_scene(mark.first());
    let frame = editor.frame_for_people(frame);
    let font = theme::small();
    painter
        .text(place, Align2::RIGHT_CENTER, frame, font, color)
        .left()
}

#[cfg(test)]
#[path = "points_list_tests.rs"]
mod tests;
