//! The scene's markers below the ruler: made by a double click, dragged, renamed, removed with what
//! is pinned to them.

use egui::{
    Button, Context, CursorIcon, FontId, Id, Key, Modifiers, Popup, PopupCloseBehavior, Rect,
    Response, Sense, Shape, Stroke, Ui, WidgetInfo, pos2, vec2,
};
use vides_document::Edit;
use vides_engine::scene::Part;

use super::axis::Axis;
use super::drag::{Moves, Pass, To, begun};
use super::key_menu::entry;
use crate::action::{Action, TimeAction};
use crate::entry::Entry;
use crate::state::Editor;
use crate::state::playing::drag::Drag;
use crate::state::playing::markers::{Memory, Moved, Renaming};
use crate::texts::fill;
use crate::theme;

/// Height of their row.
pub(super) const HEIGHT: f32 = 16.0;

/// Width of the field for another name.
const FIELD: f32 = 140.0;

impl Memory {
    fn rename(&mut self, name: &str) {
        self.renaming = Some(Renaming {
            name: name.to_owned(),
            text: name.to_owned(),
            fresh: true,
        });
    }
}

fn id(name: &str) -> Id {
    Id::unique(("marker", name))
}

fn set(name: &str, frame: Option<f64>) -> Edit {
    let name = name.to_owned();
    Edit::Part(Box::new(Part::Marker { name, frame }))
}

/// Takes F2 and Delete where a marker has the keyboard.
pub(super) fn take_keys(editor: &mut Editor, context: &Context) {
    let Some(focused) = context.memory(|memory| memory.focused()) else {
        return;
    };
    let mut all = editor.playing.marks.markers.iter();
    let Some(name) = all.find_map(|(_, name)| (id(name) == focused).then(|| name.clone())) else {
        return;
    };
    let pressed = |key| context.input_mut(|input| input.consume_key(Modifiers::NONE, key));
    if pressed(Key::F2) {
        editor.playing.speeds.markers.rename(&name);
    }
    if pressed(Key::Delete) {
        editor.act(Action::Edits(vec![set(&name, None)]), context);
    }
}

/// Makes a marker where the ruler was clicked twice.
pub(super) fn make(editor: &Editor, response: &Response, axis: &Axis, actions: &mut Vec<Action>) {
    let Some(edited) = editor.document.edited_scene() else {
        return;
    };
    if let Some(at) = response.interact_pointer_pos()
        && response.double_clicked()
    {
        let frame = axis.frame(at.x).round();
        let name = editor.texts().timeline.new_marker;
        let names = (1..).map(|number: usize| fill(name, &[&number]));
        let free = names
            .into_iter()
            .find(|name| edited.scene().marker(name).is_none());
        actions.extend(free.map(|name| Action::Edits(vec![set(&name, Some(frame))])));
    }
}

impl Editor {
    /// Moves a marker in place of what the open step has done. Where it cannot go it stays where
    /// it could last, and reports why.
    pub(crate) fn move_marker(&mut self, name: &str, to: f64) {
        let edited = self.document.edited_scene();
        let last = edited.and_then(|edited| edited.scene().marker(name));
        self.restart_step();
        if !self.edit(set(name, Some(to))) {
            let why = self.message.take();
            self.edit(set(name, last));
            self.message = why;
        }
    }
}

impl Moves for Moved {
    fn go_on(&mut self, _pass: &Pass<'_>, to: &To) -> Option<Action> {
        let (name, to) = (self.name.clone(), to.frame);
        let moves = std::mem::replace(&mut self.to, to) != to;
        moves.then_some(Action::Time(TimeAction::MoveMarker { name, to }))
    }

    /// Where it could go.
    fn at(&self, editor: &Editor, from: f64) -> f64 {
        let edited = editor.document.edited_scene();
        let now = edited.and_then(|edited| edited.scene().marker(&self.name));
        now.unwrap_or(from)
    }
}

/// Shows them in `rect`, with their names as far as there is room; words above end at `top`.
pub(super) fn show(
    editor: &Editor,
    memory: &mut Memory,
    ui: &Ui,
    (rect, top): (Rect, f32),
    axis: &Axis,
    actions: &mut Vec<Action>,
) {
    let (palette, painter) = (theme::palette(ui), ui.painter_at(rect));
    let marks = &editor.playing.marks;
    let mut free = f32::NEG_INFINITY;
    // From left to right, so that each name has the room up to the next one.
    let mut all: Vec<_> = marks.markers_there().collect();
    // What is held may be taken beyond the ends.
    let held = memory.held.as_ref().map(|drag| drag.of.name.clone());
    let is_held = |marker: &&(f64, String)| held.as_ref() == Some(&marker.1);
    all.retain(|marker| axis.sees(axis.x_of(marker.0)) && !is_held(marker));
    all.extend(marks.markers.iter().filter(is_held));
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    for (frame, name) in all {
        let tip = pos2(axis.x_of(*frame), rect.top());
        let galley = painter.layout_no_wrap(name.clone(), FontId::proportional(11.0), palette.weak);
        let most = (rect.right() - galley.size().x).max(rect.left());
        let left = (tip.x + 6.0).min(most);
        let has_room = left > free;
        let end = if has_room {
            left + galley.size().x
        } else {
            tip.x + 4.0
        };
        let place = Rect::from_x_y_ranges(tip.x - 4.0..=end, rect.y_range());
        let response = one(
            editor,
            memory,
            ui,
            (place, (*frame, name), top),
            axis,
            actions,
        );
        let colour = match response.hovered() || response.dragged() || response.has_focus() {
            true => palette.focus,
            false => palette.weak,
        };
        let corners = [tip, tip + vec2(3.5, 6.0), tip + vec2(-3.5, 6.0)];
        painter.add(Shape::convex_polygon(
            corners.to_vec(),
            colour,
            Stroke::NONE,
        ));
        if has_room {
            free = end + 12.0;
            painter.galley(pos2(left, tip.y - 1.0), galley, palette.weak);
        }
    }
}

/// A marker's place: dragged, renamed, removed.
fn one(
    editor: &Editor,
    memory: &mut Memory,
    ui: &Ui,
    (place, (frame, name), top): (Rect, (f64, &str), f32),
    axis: &Axis,
    actions: &mut Vec<Action>,
) -> Response {
    let texts = &editor.texts().timeline;
    let response = ui.interact(place, id(name), Sense::click_and_drag());
    let label = fill(texts.marker, &[&name]);
    response.widget_info(|| WidgetInfo::labeled(egui::Role::Button, true, label.as_str()));
    if response.clicked() {
        response.request_focus();
    }
    if response.hovered() || response.dragged() {
        ui.set_cursor_icon(CursorIcon::ResizeHorizontal);
    }
    if let Some(pointer) = begun(ui, &response) {
        let of = Moved {
            name: name.to_owned(),
            to: frame,
        };
        memory.held = Some(Drag::new(of, label, frame, pointer));
        actions.push(Action::Enter(Entry::Begin));
    }
    if let Some(drag) = memory.held.as_mut().filter(|drag| drag.of.name == name) {
        let pass = Pass {
            editor,
            ui,
            response: &response,
            axis,
            top,
        };
        if drag.go_on(&pass, actions).is_some() {
            memory.held = None;
        }
    }
    Popup::context_menu(&response).show(|ui| {
        if entry(ui, Button::new(texts.rename_marker), "") {
            memory.rename(name);
        }
        let remove = Button::new(texts.remove_marker);
        if entry(ui, remove, texts.remove_marker_hint) {
            actions.push(Action::Edits(vec![set(name, None)]));
        }
    });
    renamed(editor, memory, &response, name, actions);
    response.on_hover_text(texts.marker_tip)
}

/// The field for another name, over the marker.
fn renamed(
    editor: &Editor,
    memory: &mut Memory,
    response: &Response,
    name: &str,
    actions: &mut Vec<Action>,
) {
    let Some(renaming) = memory.renaming.as_mut().filter(|of| of.name == name) else {
        return;
    };
    let texts = &editor.texts().timeline;
    let field = Popup::from_response(response)
        .id(response.id.with("name"))
        .open(true)
        .close_behavior(PopupCloseBehavior::IgnoreClicks)
        .show(|ui| {
            let words = (texts.marker_name, texts.marker_name);
            let field = theme::line_edit(ui, &mut renaming.text, "name of a marker", FIELD, words);
            if field.has_focus() {
                renaming.fresh = false;
            } else if renaming.fresh {
                // A menu that closes takes it away once more.
                field.request_focus();
                theme::select(ui, field.id, &renaming.text);
                ui.ctx().request_repaint();
            }
            (
                field.lost_focus(),
                ui.input(|input| input.key_pressed(Key::Escape)),
            )
        });
    let Some((true, given_up)) = field.map(|shown| shown.inner) else {
        return;
    };
    let (from, to) = (name.to_owned(), renaming.text.trim().to_owned());
    memory.renaming = None;
    if !given_up && from != to {
        actions.push(Action::Edits(vec![Edit::RenameMarker { from, to }]));
    }
}

#[cfg(test)]
#[path = "markers_tests.rs"]
mod tests;
