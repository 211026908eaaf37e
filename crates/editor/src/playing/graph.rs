//! The speed along the whole path, below the bar of its frames: jumps between sections show there.
//! Borders of sections are dragged sideways, the ten speeds of the current section up and down.

use egui::{
    Align2, CornerRadius, CursorIcon, Id, Painter, Pos2, Rangef, Rect, Response, Sense, Stroke,
    StrokeKind, Ui, WidgetInfo, pos2, vec2,
};

use super::curve::Curve;
use super::{Marks, as_frame, plot, scrub_by_mouse};
use crate::actions::Action;
use crate::document::{Document, Selection};
use crate::error::Result;
use crate::limits::{MAX_SPEED, MIN_SPEED, SPEEDS};
use crate::number::Entry;
use crate::path::Change;
use crate::state::Editor;
use crate::texts::fill;
use crate::theme::{self, Palette};
use crate::windows::goes_by_ten;

pub(super) const HEIGHT: f32 = 76.0;

/// On a path of more sections each has only one value.
const FINE_SECTIONS: usize = 1000;

/// Pieces of a section's curve.
pub(super) const PIECES: usize = 24;

/// Borders and squares with less room than this cannot be dragged, in points.
const GRIP: f32 = 7.0;

/// Least distance between the labels of seconds, in points.
const ROOM_OF_SECONDS: f32 = 52.0;

/// The speeds of the whole path.
#[derive(Debug, Default)]
pub(super) struct Graph {
    stretches: Vec<Stretch>,
    /// The highest speed, or [`MAX_SPEED`] if that is higher.
    highest: f32,
}

/// The frames of a section in which something changes.
#[derive(Debug)]
pub(super) struct Stretch {
    /// The orientation with which it begins.
    pub(super) from: Selection,
    /// The frame after its hold, and the one of the next key.
    pub(super) start: usize,
    pub(super) end: usize,
    /// 50 is the base speed; higher the fewer frames the section has for its length.
    pub(super) speeds: [f32; PIECES + 1],
    /// Factor from the ten speeds to these.
    pub(super) scale: f32,
}

impl Graph {
    pub(super) fn clear(&mut self) {
        self.stretches.clear();
        self.highest = MAX_SPEED as f32;
    }

    /// Computes the speeds anew, on the frames of `keys`.
    pub(super) fn update(&mut self, document: &Document, keys: &[super::Mark]) -> Result<()> {
        self.clear();
        let path = document.path();
        document.timeline(|timeline| {
            self.stretches.try_reserve(timeline.section_count())?;
            let fine = timeline.section_count() <= FINE_SECTIONS;
            for (index, key) in keys.iter().take(timeline.section_count()).enumerate() {
                let section = timeline.section(index);
                if section.change == Change::Nothing || section.frames == 0 {
                    continue;
                }
                let scale = (timeline.unrounded_frames(path, index) / as_frame(section.frames))
                    .clamp(0.0, 1e6) as f32;
                let speeds = if fine {
                    let timing = timeline.timing(path, index)?;
                    std::array::from_fn(|piece| {
                        scale * timing.speed(piece as f64 / PIECES as f64) as f32
                    })
                } else {
                    [scale * section.mean_speed as f32; PIECES + 1]
                };
                self.highest = speeds.iter().copied().fold(self.highest, f32::max);
                self.stretches.push(Stretch {
                    from: Selection::at(key.point, key.orientation),
                    start: key.frame + key.hold,
                    end: key.frame + key.hold + section.frames,
                    speeds,
                    scale,
                });
            }
            Ok(())
        })?
    }
}

/// What is being dragged.
#[derive(Debug, Default)]
enum Dragged {
    #[default]
    Nothing,
    /// A border: the sections at its sides with their frames, and where it was pressed.
    Border {
        before: (Selection, usize),
        after: Option<(Selection, usize)>,
        from: f32,
        /// Frames per point.
        frames: f32,
    },
    /// One of the ten speeds, and the pointer's offset from its middle.
    Speed(usize, f32),
}

/// From frames and speeds to the screen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Scale {
    pub(super) rail: Rangef,
    pub(super) rows: Rangef,
    pub(super) frames: f32,
    pub(super) highest: f32,
}

impl Scale {
    #[allow(clippy::cast_precision_loss)]
    fn new(rail: Rangef, rect: Rect, marks: &Marks) -> Self {
        Self {
            rail,
            rows: Rangef::new(rect.top() + 14.0, rect.bottom() - 5.0),
            frames: (marks.frames as f32 - 1.0).max(1.0),
            highest: marks.graph.highest,
        }
    }

    pub(super) fn x(&self, frame: f32) -> f32 {
        let share = ((frame - 1.0) / self.frames).min(1.0);
        self.rail.min + self.rail.span() * share
    }

    pub(super) fn y(&self, speed: f32) -> f32 {
        self.rows.max - self.rows.span() * speed / self.highest
    }

    fn speed(&self, y: f32) -> f32 {
        (self.rows.max - y) / self.rows.span() * self.highest
    }

    pub(super) fn pos(&self, stretch: &Stretch, piece: usize) -> Pos2 {
        let share = piece as f32 / PIECES as f32;
        let (start, end) = (stretch.start as f32, stretch.end as f32);
        pos2(
            self.x(start + (end - start) * share),
            self.y(stretch.speeds[piece]),
        )
    }
}

/// What the graph remembers from pass to pass.
#[derive(Debug, Default)]
pub(super) struct Memory {
    held: Dragged,
    curve: Curve,
}

/// Shows the graph in `rect`; `rail` is that of the playhead.
pub(super) fn show(
    editor: &Editor,
    Memory { held, curve }: &mut Memory,
    ui: &mut Ui,
    rect: Rect,
    rail: Rect,
    actions: &mut Vec<Action>,
) {
    let texts = &editor.texts().space;
    let marks = &editor.playing.marks;
    let palette = theme::palette(ui);
    let ground = Rect::from_x_y_ranges(rail.x_range().expand(8.0), rect.y_range());
    let id = ui.scope_id().with("speed graph");
    let response = ui.interact(ground, id, Sense::click_and_drag());
    response.widget_info(|| WidgetInfo::labeled(egui::Role::Canvas, true, texts.speed_graph));
    let painter = ui.painter_at(rect);
    painter.rect_filled(ground, CornerRadius::same(3), palette.field);
    let room = rect.with_max_x(ground.left() - 12.0);
    let edits_path = editor.document.edits_path();
    ui.add_enabled_ui(edits_path, |ui| {
        plot::choices(editor, ui, room, actions);
    });
    if marks.frames == 0 || !edits_path {
        return;
    }
    let scale = Scale::new(rail.x_range(), ground, marks);
    if matches!(held, Dragged::Nothing) {
        scrub_by_mouse(editor, ui, &response, rail, actions);
    }
    seconds(editor, &painter, &scale, ground, palette);
    plot::findings(editor, &painter, &scale, ground);
    let of_sections = editor.playing.quantity.is_none();
    if of_sections {
        let stretches = (marks.revision, &*marks.graph.stretches);
        let current = editor.document.selection();
        curve.paint(&painter, stretches, current, &scale, palette);
    } else {
        plot::paint(editor, &painter, &scale, ground, palette);
    }
    let at = scale.x(editor.position_on_bar() as f32);
    let line = Stroke::new(1.0, palette.accent);
    painter.vline(at, ground.y_range(), line);
    if of_sections {
        borders(editor, held, ui, &scale, ground, actions);
        squares(editor, held, ui, &scale, actions);
    }
    response.on_hover_text(plot::meaning(editor.texts(), editor.playing.quantity));
}

/// Labels of seconds at the upper edge, as many as have room.
fn seconds(editor: &Editor, painter: &Painter, scale: &Scale, ground: Rect, palette: &Palette) {
    let fps = editor.document.info().fps as f32;
    let whole = (scale.frames / fps).max(1e-6);
    let least = whole * ROOM_OF_SECONDS / scale.rail.span().max(1.0);
    // 1, 2, 5, 10, 20 …
    let power = 10f32.powf(least.log10().floor());
    let step = [1.0, 2.0, 5.0, 10.0].map(|part| part * power);
    let step = step
        .into_iter()
        .find(|&step| step >= least)
        .unwrap_or(least);
    let decimals = (-step.log10().floor()).clamp(0.0, 6.0) as usize;
    let mut at = step;
    while at < whole {
        let x = scale.x(1.0 + at * fps);
        let text = editor.language().number(f64::from(at), decimals);
        let top = pos2(x, ground.top() + 1.0);
        let font = egui::FontId::proportional(9.5);
        painter.text(
            top,
            Align2::CENTER_TOP,
            format!("{text} s"),
            font,
            palette.weak,
        );
        at += step;
    }
}

/// The borders between sections, each as far as it has room.
fn borders(
    editor: &Editor,
    held: &mut Dragged,
    ui: &Ui,
    scale: &Scale,
    ground: Rect,
    actions: &mut Vec<Action>,
) {
    let texts = &editor.texts().space;
    let stretches = &editor.playing.marks.graph.stretches;
    let palette = theme::palette(ui);
    let mut free = f32::NEG_INFINITY;
    for (index, stretch) in stretches.iter().enumerate() {
        let x = scale.x(stretch.end as f32);
        let room = x - free.max(scale.x(stretch.start as f32));
        if room < GRIP {
            continue;
        }
        free = x;
        let id = Id::unique(("section border", index));
        let place = Rect::from_x_y_ranges(Rangef::point(x).expand(GRIP / 2.0), ground.y_range());
        let response = ui.interact(place, id, Sense::drag());
        let name = fill(
            texts.section_border,
            &[&editor.name_of(stretch.from.point, stretch.from.orientation)],
        );
        response.widget_info(|| WidgetInfo::slider(true, stretch.end as f64, name.as_str()));
        if response.drag_started()
            && let Some(pointer) = ui.input(|input| input.pointer.press_origin())
        {
            let next = stretches.get(index + 1);
            let of = |stretch: &Stretch| (stretch.from, stretch.end - stretch.start);
            *held = Dragged::Border {
                before: of(stretch),
                after: next.map(of),
                from: pointer.x,
                frames: scale.frames / scale.rail.span().max(1.0),
            };
            actions.push(Action::Enter(Entry::Begin));
        }
        if response.dragged()
            && let Some(pointer) = response.interact_pointer_pos()
        {
            let ripple = ui.input(|input| input.modifiers.shift);
            actions.extend(moved_border(editor, held, pointer.x, ripple));
        }
        ended(ui, &response, held, actions);
        let lively = response.hovered() || response.dragged();
        if lively {
            ui.set_cursor_icon(CursorIcon::ResizeHorizontal);
        }
        let color = if lively { palette.focus } else { palette.line };
        let width = if lively { 2.0 } else { 1.0 };
        ui.painter()
            .vline(x, ground.y_range(), Stroke::new(width, color));
        response.on_hover_text(texts.section_border_tip);
    }
}

/// The edits for a dragged border; with `ripple` the section after it keeps its frames and shifts.
fn moved_border(editor: &Editor, held: &Dragged, at: f32, ripple: bool) -> Vec<Action> {
    let &Dragged::Border {
        before: (first, frames),
        after,
        from,
        frames: each,
    } = held
    else {
        return Vec::new();
    };
    #[allow(clippy::cast_possible_truncation)]
    let wanted = f64::from((at - from) * each).round() as i64;
    let length = |frames: usize| i64::try_from(frames).unwrap_or(i64::MAX);
    let after = after.filter(|_| !ripple);
    let most = after.map_or(i64::MAX, |(_, frames)| length(frames) - 1);
    let moved = wanted.min(most).max(1 - length(frames));
    let set = |(at, frames): (Selection, i64)| {
        let point = editor.document.path().points.get(at.point)?;
        let orientation = point.orientations.get(at.orientation)?;
        let frames = u32::try_from(frames).ok()?;
        let edit = editor.with_own(at, orientation, |own| own.frames = frames);
        Some(edit.map_or_else(Action::Complain, Action::Edit))
    };
    let before = (first, length(frames) + moved);
    let after = after.map(|(at, frames)| (at, length(frames) - moved));
    [Some(before), after]
        .into_iter()
        .flatten()
        .filter_map(set)
        .collect()
}

/// The ten speeds of the current section, if there is room for them.
fn squares(editor: &Editor, held: &mut Dragged, ui: &Ui, scale: &Scale, actions: &mut Vec<Action>) {
    let selection = editor.document.selection();
    let stretches = &editor.playing.marks.graph.stretches;
    let Some(orientation) = editor.orientation() else {
        return;
    };
    let Some(stretch) = stretches.iter().find(|stretch| stretch.from == selection) else {
        return;
    };
    let ends = Rangef::new(scale.x(stretch.start as f32), scale.x(stretch.end as f32));
    let step = ends.span() / (SPEEDS - 1) as f32;
    if step < GRIP || !goes_by_ten(&orientation.own.pace) {
        return;
    }
    let palette = theme::palette(ui);
    for (at, &speed) in orientation.speeds.iter().enumerate() {
        let shown = stretch.scale * speed as f32;
        let middle = pos2(ends.min + step * at as f32, scale.y(shown));
        let id = Id::unique(("speed in graph", at));
        // Above and below the outermost ones the borders can be dragged.
        let place = Rect::from_center_size(middle, vec2(step.min(14.0), 14.0));
        let response = ui.interact(place, id, Sense::drag());
        let name = fill(editor.texts().speed_window.speed, &[&(at + 1)]);
        response.widget_info(|| WidgetInfo::slider(true, speed, name.as_str()));
        if response.drag_started()
            && let Some(pointer) = ui.input(|input| input.pointer.press_origin())
        {
            *held = Dragged::Speed(at, pointer.y - middle.y);
            actions.push(Action::Enter(Entry::Begin));
        }
        if let Dragged::Speed(held, grip) = *held
            && held == at
            && response.dragged()
            && let Some(pointer) = response.interact_pointer_pos()
        {
            let exact = f64::from(scale.speed(pointer.y - grip) / stretch.scale.max(1e-6));
            let rounded = exact.round().clamp(MIN_SPEED, MAX_SPEED);
            let edit = editor.orientation_edit(|orientation| orientation.speeds[at] = rounded);
            actions.extend(edit.map(Action::Edit));
        }
        ended(ui, &response, held, actions);
        let lively = response.hovered() || response.dragged();
        if lively {
            ui.set_cursor_icon(CursorIcon::ResizeVertical);
        }
        let color = if lively {
            palette.focus
        } else {
            palette.accent
        };
        let size = if lively { 8.0 } else { 6.0 };
        ui.painter().rect(
            Rect::from_center_size(middle, vec2(size, size)),
            CornerRadius::same(1),
            color,
            Stroke::new(1.0, palette.field),
            StrokeKind::Outside,
        );
        if lively {
            let text = editor.language().number(speed, 0);
            let above = pos2(middle.x, middle.y.max(scale.rows.min + 12.0) - 6.0);
            let color = palette.text;
            ui.painter()
                .text(above, Align2::CENTER_BOTTOM, text, theme::small(), color);
        }
    }
}

/// Ends a drag; Escape undoes it.
fn ended(ui: &Ui, response: &Response, held: &mut Dragged, actions: &mut Vec<Action>) {
    if !response.drag_stopped() || matches!(held, Dragged::Nothing) {
        return;
    }
    *held = Dragged::Nothing;
    actions.push(Action::Enter(Entry::of_end(ui.ctx())));
}

#[cfg(test)]
#[path = "graph_tests.rs"]
mod tests;
