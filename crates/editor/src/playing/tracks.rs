//! Rows of the selected nodes below the keys of the path: their paths as bars, their tracks as
//! diamonds. What is dragged there is [`super::track_drag`]'s.

use std::ops::Range;

use egui::{
    CursorIcon, Painter, Rangef, Rect, Response, Role, ScrollArea, Sense, Stroke, StrokeKind, Ui,
    UiBuilder, WidgetInfo, pos2, vec2,
};
use vides_document::EditedScene;
use vides_engine::path::Sampler;
use vides_engine::scene::{FollowPath, Node};

use super::axis::APART;
use super::axis::Axis;
use super::drag::Pass;
use super::{graph_paint, pins, track_drag, track_graph, track_menu, track_rows};
use crate::action::Action;
use crate::playing::axis::as_frame;
use crate::playing::track_curve::Of;
use crate::playing::track_rows::{Hit, ROW, Shown, bar_of, caption, diamond, id};
use crate::state::Editor;
pub(super) use crate::state::playing::tracks::Memory;
use crate::state::playing::tracks::Row;
use crate::state::scene_view::KeyAt;
use crate::theme;

/// Half of a key's sign; of that of a node, which stands for keys of several tracks.
const SIGN: f32 = 4.5;
const SMALL: f32 = 3.0;

/// The switch between rows and curves.
const SWITCH: egui::Vec2 = vec2(22.0, 18.0);

/// Shows these rows in `rect`, their names in `captions` points at the left of it; words above them
/// end at `top`.
pub(super) fn show(
    editor: &Editor,
    memory: &mut Memory,
    ui: &mut Ui,
    (rect, captions, top): (Rect, f32, f32),
    (rows, axis): (&[Row], &Axis),
    actions: &mut Vec<Action>,
) {
    let (left, right) = rect.split_left_right_at_x(rect.left() + captions);
    if memory.curves {
        graph_paint::names(editor, memory, ui, left, rows);
        track_graph::show(editor, memory, ui, (right, top), (rows, axis), actions);
    } else {
        shown_as_rows(
            editor,
            memory,
            ui,
            (rect, captions, top),
            (rows, axis),
            actions,
        );
    }
    let corner = left.right_top() + vec2(-theme::GAP - SWITCH.x, 1.0);
    let place = Rect::from_min_size(corner, SWITCH);
    graph_paint::switch(editor, &mut memory.curves, ui, place);
}

fn shown_as_rows(
    editor: &Editor,
    memory: &mut Memory,
    ui: &mut Ui,
    (rect, captions, top): (Rect, f32, f32),
    (rows, axis): (&[Row], &Axis),
    actions: &mut Vec<Action>,
) {
    let inside = UiBuilder::new().max_rect(rect).id_salt("tracks");
    ui.scope_builder(inside, |ui| {
        ui.set_clip_rect(rect.intersect(ui.clip_rect()));
        ui.spacing_mut().item_spacing.y = 0.0;
        ScrollArea::vertical()
            .id_salt("tracks")
            .max_height(rect.height())
            .min_scrolled_height(0.0)
            .auto_shrink(false)
            .show_viewport(ui, |ui, _| {
                #[allow(clippy::cast_precision_loss)]
                ui.set_height(ROW * rows.len() as f32);
                let top_of_rows = ui.max_rect().top();
                let (left, right) = rect.split_left_right_at_x(rect.left() + captions);
                let along = axis.rail.expand(8.0);
                let ground = Rect::from_x_y_ranges(along, right.y_range());
                let selected = editor.selected_keys();
                let shown = Shown {
                    rows,
                    axis: *axis,
                    top: top_of_rows,
                    ground,
                    ends: track_rows::ends(editor, &selected),
                    selected,
                };
                all(editor, memory, ui, (&shown, left));
                let response = ui.interact(ground, id(), Sense::click_and_drag());
                let name = editor.texts().timeline.tracks;
                response.widget_info(|| WidgetInfo::labeled(Role::Canvas, true, name));
                pressed(editor, memory, ui, &shown, &response, actions);
                let pass = Pass {
                    editor,
                    ui,
                    response: &response,
                    axis,
                    top,
                };
                track_drag::show(&mut memory.held, &pass, &shown, actions);
            });
    });
}

/// Paints the rows that are seen, with their names.
#[allow(clippy::cast_precision_loss)]
fn all(editor: &Editor, memory: &mut Memory, ui: &Ui, (shown, left): (&Shown<'_>, Rect)) {
    let Some(edited) = editor.document.edited_scene() else {
        return;
    };
    let palette = theme::palette(ui);
    let painter = ui.painter_at(shown.ground.intersect(ui.clip_rect()));
    for number in seen(shown) {
        let row = shown.rows[number];
        let y = shown.top + ROW * number as f32;
        let rows = Rangef::new(y, y + ROW);
        let ground = Rect::from_x_y_ranges(shown.ground.x_range(), rows);
        painter.rect_filled(ground.shrink2(vec2(0.0, 1.0)), 3.0, palette.field);
        let room = Rect::from_x_y_ranges(left.x_range(), rows);
        let room = room.with_max_x(room.right() - theme::GAP);
        caption(editor, memory, ui, (row, room), edited);
        match row.of(edited) {
            Some(of) => diamonds(shown, ui, &painter, &of, rows.center()),
            None => of_node(editor, edited, shown, ui, &painter, (row, rows)),
        }
    }
    if let Some(brackets) = shown.brackets() {
        for (x, way) in brackets.into_iter().zip([3.0, -3.0]) {
            let rows = shown.ground.y_range();
            let end = shown.top + ROW * shown.rows.len() as f32;
            let rows = Rangef::new(rows.min, rows.max.min(end));
            let stroke = Stroke::new(1.5, palette.accent);
            painter.vline(x, rows, stroke);
            for y in [rows.min + 1.0, rows.max - 1.0] {
                painter.hline(Rangef::new(x.min(x + way), x.max(x + way)), y, stroke);
            }
        }
    }
    let at = shown.axis.x_of(editor.position_on_bar());
    let colour = super::ruler::colour_of_playhead(editor, ui);
    painter.vline(at, shown.ground.y_range(), Stroke::new(1.0, colour));
}

/// The numbers of the rows that are seen.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
fn seen(shown: &Shown<'_>) -> Range<usize> {
    let number = |y: f32| shown.number_at(y).max(0.0);
    let (first, last) = (number(shown.ground.top()), number(shown.ground.bottom()));
    let count = shown.rows.len();
    (first.floor() as usize).min(count)..(last.ceil() as usize).min(count)
}

fn diamonds(shown: &Shown<'_>, ui: &Ui, painter: &Painter, of: &Of<'_>, y: f32) {
    let palette = theme::palette(ui);
    let selected = shown.selected.iter().filter(|at| of.has(at));
    let chosen: Vec<usize> = selected.map(|at| at.key).collect();
    let line = Stroke::new(1.0, palette.field);
    for (x, keys) in shown.axis.signs(of.track.frames()) {
        let fill = match chosen.iter().any(|key| keys.contains(key)) {
            true => palette.accent,
            false => palette.weak,
        };
        painter.add(diamond(pos2(x, y), SIGN, fill, line));
    }
}

/// The bar of a node's path, and small signs for the keys of its tracks.
fn of_node(
    editor: &Editor,
    edited: &EditedScene,
    shown: &Shown<'_>,
    ui: &Ui,
    painter: &Painter,
    (row, rows): (Row, Rangef),
) {
    let palette = theme::palette(ui);
    if let Some((first, last)) = bar_of(editor, edited, row.node) {
        let ends = [first, last].map(|frame| shown.axis.place(frame));
        let rows = rows.shrink(4.0);
        let bar = Rect::from_x_y_ranges(ends[0]..=ends[1].max(ends[0] + 2.0), rows);
        let of_edited = edited.node() == Some(row.node);
        let part = if of_edited { 0.5 } else { 0.28 };
        painter.rect_filled(bar, 3.0, palette.accent.gamma_multiply(part));
        let mut free = bar.left();
        for frame in borders(editor, edited, row.node) {
            let x = shown.axis.place(first + frame);
            if x - free >= APART && shown.axis.sees(x) {
                painter.vline(x, rows, Stroke::new(1.0, palette.field));
                free = x;
            }
        }
        if of_edited {
            let line = Stroke::new(1.0, palette.accent);
            painter.rect_stroke(bar, 3.0, line, StrokeKind::Inside);
        }
        let place = (row.node, shown.ground.top(), rows);
        pins::of_bar(edited, painter, &shown.axis, place);
    }
    for of in row.tracks(edited) {
        for (x, _) in shown.axis.signs(of.track.frames()) {
            painter.add(diamond(
                pos2(x, rows.center()),
                SMALL,
                palette.edge,
                Stroke::NONE,
            ));
        }
    }
}

/// The frames from a path's first one at which its sections end.
fn borders(editor: &Editor, edited: &EditedScene, node: usize) -> Vec<f64> {
    if edited.node() == Some(node) {
        let keys = &editor.playing.marks.keys;
        return keys.iter().map(|mark| mark.first() - 1.0).collect();
    }
    let path = edited.scene().nodes().get(node).and_then(Node::path);
    path.map(sections).unwrap_or_default()
}

fn sections(follow: &FollowPath) -> Vec<f64> {
    let path = follow.path();
    let views: usize = path
        .points
        .iter()
        .map(|point| point.orientations.len())
        .sum();
    let count = if path.closed { views } else { views - 1 };
    // What cannot be prepared is told where it is evaluated.
    let sampler = follow.sampler().ok();
    let begins = |sampler: &Sampler| {
        let first = |section| as_frame(sampler.first_frame(section).saturating_sub(2));
        (0..count).map(first).collect()
    };
    sampler.map(begins).unwrap_or_default()
}

/// Clicks: select, and open the menu.
fn pressed(
    editor: &Editor,
    memory: &mut Memory,
    ui: &Ui,
    shown: &Shown<'_>,
    response: &Response,
    actions: &mut Vec<Action>,
) {
    if let Some(at) = response.hover_pos() {
        match shown.hit(editor, at) {
            Hit::Keys(_) | Hit::End { .. } => ui.set_cursor_icon(CursorIcon::ResizeHorizontal),
            Hit::Bar(_) => ui.set_cursor_icon(CursorIcon::Grab),
            Hit::Nothing => {}
        }
    }
    let pointer = response.interact_pointer_pos();
    if let Some(at) = pointer.filter(|_| response.secondary_clicked()) {
        memory.menu = shown.row_at(at.y);
        if let Hit::Keys(keys) = shown.hit(editor, at)
            && !keys.iter().all(|key| shown.selected.contains(key))
        {
            actions.push(Action::SelectKeys(keys));
        }
    }
    if let Some(at) = pointer.filter(|_| response.clicked()) {
        response.request_focus();
        let held = ui.input(|input| input.modifiers);
        let keys = match shown.hit(editor, at) {
            Hit::Keys(keys) => keys,
            Hit::End { .. } => return,
            Hit::Nothing | Hit::Bar(_) => Vec::new(),
        };
        let selected = shown.selected.clone();
        let chosen = chosen(selected, keys, held, |at| at);
        actions.push(Action::SelectKeys(chosen));
    }
    if let Some(row) = memory.menu {
        track_menu::show(editor, &mut memory.graph, response, row, actions);
    }
}

/// The selection after a click at some, with the modifier keys.
pub(super) fn chosen<T: Clone + PartialEq>(
    mut all: Vec<T>,
    clicked: Vec<T>,
    held: egui::Modifiers,
    key: impl Fn(&mut T) -> &mut KeyAt,
) -> Vec<T> {
    if held.ctrl {
        let taken = clicked.iter().all(|one| all.contains(one));
        all.retain(|one| !clicked.contains(one));
        if !taken {
            all.splice(0..0, clicked);
        }
        return all;
    }
    if !held.shift {
        return clicked;
    }
    // All up to here from the last one that was clicked in the track.
    for mut one in clicked {
        let to = key(&mut one).key;
        let same = |other: &T| {
            let mut other = other.clone();
            let from = std::mem::replace(&mut key(&mut other).key, to);
            (other == one).then_some(from)
        };
        let from = all.iter().find_map(same).unwrap_or(to);
        for between in from.min(to)..=from.max(to) {
            let mut next = one.clone();
            key(&mut next).key = between;
            if !all.contains(&next) {
                all.push(next);
            }
        }
    }
    all
}

#[cfg(test)]
#[path = "tracks_tests.rs"]
pub(super) mod tests;
