//! The tracks of nodes as curves: their numbers over frames, with keys that are dragged in both and
//! the handles of own tangents. What is dragged is [`super::graph_drag`]'s.

use egui::{Pos2, Rect, Response, Role, Sense, Shape, Stroke, Ui, WidgetInfo, pos2, vec2};
use vides_document::EditedScene;

use super::axis::Axis;
use super::drag::Pass;
use super::graph_paint::{colour, headings, scale, signs};
use super::key_motion::by_track;
use super::track_curve::{Curve, Of};
use super::{graph_drag, track_menu, track_rows, tracks};
use crate::action::Action;
use crate::playing::track_dots::{Fit, Hit, MOST, Shown, range_of, select};
use crate::state::Editor;
use crate::state::playing::track_graph::Held;
pub(super) use crate::state::playing::track_graph::Memory;
use crate::state::playing::tracks::Row;

/// Curves are this near to what the engine says, in points.
const NEAR: f64 = 0.15;

impl Memory {
    /// The rows whose curves are seen.
    pub(super) fn shows(&self, editor: &Editor, edited: &EditedScene, rows: &[Row]) -> Vec<Row> {
        let with_track = || {
            let of = |row: &Row| Some((*row, row.of(edited)?));
            rows.iter().filter_map(of)
        };
        let chosen = |of: &Of<'_>| {
            self.chosen
                .iter()
                .any(|(node, channel)| of.is(*node, channel))
        };
        let chosen = with_track().filter(|(_, of)| chosen(of));
        let mut all: Vec<Row> = chosen.map(|(row, _)| row).collect();
        if all.is_empty() {
            let selected = by_track(edited, &editor.selected_keys());
            let has_key = |of: &Of<'_>| {
                let mut tracks = selected.iter().map(|(other, _)| other);
                tracks.any(|other| of.is(other.node, other.track.channel()))
            };
            let selected = with_track().filter(|(_, of)| has_key(of));
            all = selected.take(MOST).map(|(row, _)| row).collect();
        }
        if all.is_empty() {
            all.extend(with_track().next().map(|(row, _)| row));
        }
        all
    }

    /// Shows the curve of a row; `adds`: with the others, or no longer.
    pub(super) fn choose(
        &mut self,
        editor: &Editor,
        edited: &EditedScene,
        (rows, row): (&[Row], Row),
        adds: bool,
    ) {
        let of = |row: Row| Some((row.node, row.of(edited)?.track.channel().clone()));
        let before: Vec<_> = self.shows(editor, edited, rows).into_iter().collect();
        self.chosen = match adds {
            false => of(row).into_iter().collect(),
            true => {
                let others = before.iter().copied().filter(|other| *other != row);
                let added = (!before.contains(&row)).then_some(row);
                others.chain(added).filter_map(of).collect()
            }
        };
    }

    /// What is seen stays so, whatever is selected.
    fn keep(&mut self, shown: &Shown<'_>) {
        let tracks = shown.tracks.iter();
        self.chosen = tracks
            .map(|of| (of.node, of.track.channel().clone()))
            .collect();
    }
}

/// Shows the curves in `rect`; words above them end at `top`.
pub(super) fn show(
    editor: &Editor,
    memory: &mut tracks::Memory,
    ui: &Ui,
    (rect, top): (Rect, f32),
    (rows, axis): (&[Row], &Axis),
    actions: &mut Vec<Action>,
) {
    let Some(edited) = editor.document.edited_scene() else {
        return;
    };
    let ground = Rect::from_x_y_ranges(axis.rail.expand(8.0), rect.y_range());
    let ground = ground.shrink2(vec2(0.0, 1.0));
    let rows = memory.graph.shows(editor, edited, rows);
    let tracks: Vec<Of<'_>> = rows.iter().filter_map(|row| row.of(edited)).collect();
    let ends = (axis.frame(ground.left()), axis.frame(ground.right()));
    let column = axis.frames_per_point();
    let curves = |tolerance: f64| {
        let all = tracks
            .iter()
            .map(|of| Curve::new(of, ends, column, tolerance));
        all.collect::<Vec<Curve>>()
    };
    let bounds = |curves: &[Curve]| {
        let all = curves.iter().filter_map(Curve::bounds);
        range_of(all.reduce(|a, b| (a.0.min(b.0), a.1.max(b.1))))
    };
    let near = |range| NEAR * Fit::new(range, ground).per_point;
    let rough = memory.graph.range;
    let rough = rough.unwrap_or_else(|| bounds(&curves(f64::INFINITY)));
    let curves = curves(near(rough));
    let range = memory.graph.range.unwrap_or_else(|| bounds(&curves));
    let shown = Shown {
        axis: *axis,
        fit: Fit::new(range, ground),
        ground,
        tracks,
        selected: editor.selected_keys(),
    };
    let response = ui.interact(ground, track_rows::id(), Sense::click_and_drag());
    let name = editor.texts().timeline.graph_of_keys;
    response.widget_info(|| WidgetInfo::labeled(Role::Canvas, true, name));
    let painter = ui.painter_at(ground.intersect(ui.clip_rect()));
    scale(editor, ui, &painter, (&shown, range), rect.left());
    for (of, curve) in shown.tracks.iter().zip(&curves) {
        for part in 0..of.width() {
            let place = |(frame, value)| pos2(shown.axis.place(frame), shown.fit.y(value));
            let line: Vec<Pos2> = curve.line(part).map(place).collect();
            let stroke = Stroke::new(1.5, colour(ui, part, of.width()));
            painter.add(Shape::line(line, stroke));
        }
    }
    signs(&memory.graph, ui, &painter, &shown);
    let at = axis.x_of(editor.position_on_bar());
    let line = Stroke::new(1.0, super::ruler::colour_of_playhead(editor, ui));
    painter.vline(at, ground.y_range(), line);
    headings(editor, ui, &painter, &shown);
    pressed(editor, memory, ui, &shown, &response, (&rows, actions));
    let pass = Pass {
        editor,
        ui,
        response: &response,
        axis,
        top,
    };
    graph_drag::show(&mut memory.graph, &pass, &shown, actions);
    // What is held is seen on the same scale all the time.
    let held = !matches!(memory.graph.held, Held::Nothing);
    memory.graph.range = held.then_some(range);
}

/// Clicks: select, and open the menu.
fn pressed(
    editor: &Editor,
    memory: &mut tracks::Memory,
    ui: &Ui,
    shown: &Shown<'_>,
    response: &Response,
    (rows, actions): (&[Row], &mut Vec<Action>),
) {
    let texts = &editor.texts().timeline;
    if let Some(at) = response.hover_pos() {
        let read_only = match shown.hit(&memory.graph.parts, at) {
            Hit::Nothing => false,
            Hit::Handle(..) => {
                ui.set_cursor_icon(egui::CursorIcon::Move);
                false
            }
            Hit::Dot(dot) => {
                ui.set_cursor_icon(egui::CursorIcon::Move);
                shown.track_of(&dot.at).is_some_and(|of| of.is_read_only())
            }
        };
        if read_only {
            response.clone().on_hover_text(texts.read_only);
        }
    }
    let pointer = response.interact_pointer_pos();
    if let Some(at) = pointer.filter(|_| response.secondary_clicked()) {
        let hit = shown.hit(&memory.graph.parts, at);
        let (Hit::Dot(dot) | Hit::Handle(dot, _)) = hit else {
            memory.menu = rows.first().copied();
            return;
        };
        let same = shown
            .tracks
            .iter()
            .zip(rows)
            .find(|(of, _)| of.has(&dot.at));
        memory.menu = same.map(|(_, row)| *row);
        if !shown.selected.contains(&dot.at) {
            memory.graph.keep(shown);
            select(&mut memory.graph, shown, vec![dot], actions);
        }
    }
    if let Some(at) = pointer.filter(|_| response.clicked()) {
        response.request_focus();
        memory.graph.keep(shown);
        let held = ui.input(|input| input.modifiers);
        let clicked = match shown.hit(&memory.graph.parts, at) {
            Hit::Dot(dot) => vec![dot],
            Hit::Handle(..) => return,
            Hit::Nothing => Vec::new(),
        };
        let selected = shown.dots(&memory.graph.parts);
        let dots = tracks::chosen(selected, clicked, held, |dot| &mut dot.at);
        select(&mut memory.graph, shown, dots, actions);
    }
    if let Some(row) = memory.menu {
        track_menu::show(editor, &mut memory.graph, response, row, actions);
    }
}

#[cfg(test)]
#[path = "track_graph_tests.rs"]
pub(super) mod tests;
