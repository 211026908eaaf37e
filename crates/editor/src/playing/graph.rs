//! The graph below the keys: the pace along the whole path, where jumps between sections show, and
//! other quantities. Borders of sections are dragged sideways as the keys are, the ten speeds of the
//! current section up and down.

use egui::{
    Align2, CornerRadius, CursorIcon, Id, Pos2, Rangef, Rect, Sense, Stroke, StrokeKind, Ui,
    WidgetInfo, pos2, vec2,
};
use vides_document::error::Result;
use vides_document::{Document, Edit, Selection};
use vides_engine::limits::{MAX_SPEED, MIN_SPEED, SPEEDS};
use vides_engine::path::Change;

use super::axis::Axis;
use super::drag::{begun, ended};
use super::key_row::take;
use super::plot;
use super::ruler::{colour_of_playhead, scrub_by_mouse};
use crate::action::Action;
use crate::entry::Entry;
use crate::playing::axis::as_frame;
use crate::state::playing::graph::{Graph, PIECES, Scale, Stretch};
pub(super) use crate::state::playing::graph::{Held, Memory};
use crate::state::playing::{Mark, Marks};
use crate::state::{Editor, with};
use crate::texts::fill;
use crate::theme;
use crate::windows::speed::section::goes_by_ten;

/// Its least height, in points.
pub(super) const LEAST: f32 = 44.0;

/// On a path of more sections each has only one value.
const FINE_SECTIONS: usize = 1000;

/// Borders and squares with less room than this cannot be dragged, in points.
const GRIP: f32 = 7.0;

impl Graph {
    pub(super) fn clear(&mut self) {
        self.stretches.clear();
        self.highest = MAX_SPEED as f32;
    }

    /// The sections in which something changes, in their order.
    pub(super) fn stretches(&self) -> &[Stretch] {
        &self.stretches
    }

    /// Recomputes the speeds on the frames of `keys`.
    pub(super) fn update(&mut self, document: &Document, keys: &[Mark]) -> Result<()> {
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

impl Scale {
    fn new(axis: Axis, rect: Rect, marks: &Marks) -> Self {
        Self {
            axis,
            rows: Rangef::new(rect.top() + plot::WORDS, rect.bottom() - 5.0),
            highest: marks.graph.highest,
        }
    }

    pub(super) fn x(&self, frame: f32) -> f32 {
        self.axis.x_of(f64::from(frame))
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

/// Shows the graph in `rect`, with what is chosen at the left of it in `room`.
pub(super) fn show(
    editor: &Editor,
    Memory {
        held,
        carries,
        curve,
        ..
    }: &mut Memory,
    ui: &mut Ui,
    (rect, room): (Rect, Rect),
    axis: &Axis,
    actions: &mut Vec<Action>,
) {
    let texts = &editor.texts().space;
    let marks = &editor.playing.marks;
    let palette = theme::palette(ui);
    let ground = Rect::from_x_y_ranges(axis.rail.expand(8.0), rect.y_range());
    let id = ui.scope_id().with("speed graph");
    let response = ui.interact(ground, id, Sense::click_and_drag());
    response.widget_info(|| WidgetInfo::labeled(egui::Role::Canvas, true, texts.speed_graph));
    let painter = ui.painter_at(ground);
    painter.rect_filled(ground, CornerRadius::same(3), palette.field);
    let edits_path = editor.document.edits_path();
    ui.add_enabled_ui(edits_path, |ui| {
        plot::choices(editor, ui, room, actions);
    });
    if marks.frames == 0 || !edits_path {
        return;
    }
    if matches!(held, Held::Nothing) {
        scrub_by_mouse(editor, ui, &response, axis, actions);
    }
    let at = axis.x_of(editor.position_on_bar());
    let axis = &editor.axis_of_path(axis);
    let scale = Scale::new(*axis, ground, marks);
    plot::findings(editor, &painter, &scale, ground);
    let shown = &editor.playing.shown;
    if shown.pace {
        let stretches = (marks.revision, &*marks.graph.stretches);
        let current = editor.document.selection();
        curve.paint(&painter, stretches, current, &scale, palette);
    }
    // What is read under the pointer; else what stands at the playhead.
    let pointer = response
        .hover_pos()
        .filter(|_| !response.is_pointer_button_down_on());
    let pointer = pointer.map(|pointer| axis.frame(pointer.x));
    plot::paint(editor, ui, &painter, axis, (ground, room, pointer));
    let line = Stroke::new(1.0, colour_of_playhead(editor, ui));
    painter.vline(at, ground.y_range(), line);
    if shown.pace {
        borders(editor, (held, *carries), ui, (&scale, ground), actions);
        squares(editor, held, ui, &scale, actions);
    }
    if editor.playing.plot.is_empty() {
        response.on_hover_text(plot::told(editor.texts(), None));
    }
}

/// The borders between sections, each as far as it has room.
fn borders(
    editor: &Editor,
    (held, carries): (&mut Held, bool),
    ui: &Ui,
    (scale, ground): (&Scale, Rect),
    actions: &mut Vec<Action>,
) {
    let texts = &editor.texts().space;
    let stretches = &editor.playing.marks.graph.stretches;
    let palette = theme::palette(ui);
    let painter = ui.painter_at(ground);
    let mut free = f32::NEG_INFINITY;
    for (index, stretch) in stretches.iter().enumerate() {
        let x = scale.x(stretch.end as f32);
        let room = x - free.max(scale.x(stretch.start as f32));
        if room < GRIP || !scale.axis.sees(x) {
            continue;
        }
        free = x;
        let line = |width, color| {
            painter.vline(x, ground.y_range(), Stroke::new(width, color));
        };
        if carries {
            line(1.0, palette.line);
            continue;
        }
        let id = Id::unique(("section border", index));
        let place = Rect::from_x_y_ranges(Rangef::point(x).expand(GRIP / 2.0), ground.y_range());
        let response = ui.interact(place, id, Sense::drag());
        let name = fill(
            texts.section_border,
            &[&editor.name_of(stretch.from.point, stretch.from.orientation)],
        );
        response.widget_info(|| WidgetInfo::slider(true, stretch.end as f64, name.as_str()));
        let next = editor.playing.marks.at(stretch.end);
        let key = next.unwrap_or(stretch.from);
        take(editor, held, ui, (&response, key, stretch.end), actions);
        if response.hovered() {
            line(2.0, palette.focus);
        } else {
            line(1.0, palette.line);
        }
        response.on_hover_text(texts.section_border_tip);
    }
}

/// The ten speeds of the current section, if there is room for them.
fn squares(editor: &Editor, held: &mut Held, ui: &Ui, scale: &Scale, actions: &mut Vec<Action>) {
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
        if !scale.axis.sees(middle.x) {
            continue;
        }
        let id = Id::unique(("speed in graph", at));
        // Above and below the outermost ones the borders can be dragged.
        let place = Rect::from_center_size(middle, vec2(step.min(14.0), 14.0));
        let response = ui.interact(place, id, Sense::drag());
        let name = fill(editor.texts().speed_window.speed, &[&(at + 1)]);
        response.widget_info(|| WidgetInfo::slider(true, speed, name.as_str()));
        if let Some(pointer) = begun(ui, &response) {
            let joins = editor.several().is_none() && goes_on(editor, stretch, at);
            *held = Held::Speed(at, pointer.y - middle.y, joins);
            actions.push(Action::Enter(Entry::Begin));
        }
        if let Held::Speed(held, grip, joins) = *held
            && held == at
            && response.dragged()
            && let Some(pointer) = response.interact_pointer_pos()
        {
            let exact = f64::from(scale.speed(pointer.y - grip) / stretch.scale.max(1e-6));
            let rounded = exact.round().clamp(MIN_SPEED, MAX_SPEED);
            let edit = editor.orientation_edit(|orientation| orientation.speeds[at] = rounded);
            let drag = |edit| Action::Enter(Entry::Drag(edit));
            actions.extend(edit.map(drag));
            let other = joins.then(|| follow(editor, stretch, at, rounded));
            actions.extend(other.flatten().map(drag));
        }
        if matches!(held, Held::Speed(one, ..) if *one == at)
            && ended(ui, &response, actions).is_some()
        {
            *held = Held::Nothing;
        }
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

/// The section in which the camera flies on beyond one of the ten speeds of another, and which of
/// its own speeds is there: none but at the ends, and none where it rests or turns between them.
fn beside<'a>(editor: &'a Editor, stretch: &Stretch, at: usize) -> Option<(&'a Stretch, usize)> {
    let stretches = &editor.playing.marks.graph.stretches;
    let index = stretches.iter().position(|one| one.from == stretch.from)?;
    let (other, there) = match at {
        0 => (stretches.get(index.checked_sub(1)?)?, SPEEDS - 1),
        _ if at + 1 == SPEEDS => (stretches.get(index + 1)?, 0),
        _ => return None,
    };
    let flies = |from: Selection| {
        let point = editor.document.path().points.get(from.point);
        point.is_some_and(|point| from.orientation + 1 == point.orientations.len())
    };
    let touches = other.end == stretch.start || stretch.end == other.start;
    (touches && flies(stretch.from) && flies(other.from)).then_some((other, there))
}

/// Whether a section goes on as fast there.
fn goes_on(editor: &Editor, stretch: &Stretch, at: usize) -> bool {
    let [here, there] = [at, SPEEDS - 1 - at].map(|at| at.min(1) * PIECES);
    beside(editor, stretch, at).is_some_and(|(other, _)| {
        let (here, there) = (stretch.speeds[here], other.speeds[there]);
        (here - there).abs() < 0.02 * here.max(there)
    })
}

/// The edit by which a section goes on as fast as one of the ten speeds of another.
fn follow(editor: &Editor, stretch: &Stretch, at: usize, speed: f64) -> Option<Edit> {
    let (other, there) = beside(editor, stretch, at)?;
    let point = editor.document.path().points.get(other.from.point)?;
    let key = point.orientations.get(other.from.orientation)?;
    let speed = speed * f64::from(stretch.scale / other.scale.max(1e-6));
    goes_by_ten(&key.own.pace).then(|| {
        with(other.from, key, |key| {
            key.speeds[there] = speed.round().clamp(MIN_SPEED, MAX_SPEED);
        })
    })
}

#[cfg(test)]
#[path = "graph_tests.rs"]
mod tests;
