//! The keys on the timeline, and the sections between them: dragged, copied, selected.

use egui::{
    CursorIcon, FontId, Id, Painter, Rangef, Rect, Response, Sense, Stroke, Ui, WidgetInfo, pos2,
    vec2,
};
use vides_document::Selection;

use super::axis::Axis;
use super::drag::{Moves, Pass, To, begun};
use super::ruler::chosen_too;
use super::{pins, section_menu};
use crate::action::{Action, TimeAction};
use crate::entry::Entry;
use crate::playing::axis::as_frame;
use crate::playing::track_rows::diamond;
use crate::state::Editor;
use crate::state::playing::drag::Drag;
use crate::state::playing::graph::{Held, KeyDrag, Memory};
use crate::state::playing::{Mark, Retiming};
use crate::texts::fill;
use crate::theme;

pub(super) const HEIGHT: f32 = 24.0;

/// Least room for a key that is dragged, in points; the room that it takes where there is enough.
const LEAST: f32 = 6.0;
const ROOM: f32 = 24.0;

/// Half of a key's sign.
const SIGN: f32 = 5.0;

impl KeyDrag {
    /// Where it is now.
    fn frame(&self) -> usize {
        match self.done {
            Retiming::Nothing => self.from,
            Retiming::Move { by, .. } => {
                usize::try_from(as_count(self.from) + by).unwrap_or(self.from)
            }
            Retiming::Copy { to, .. } => to,
        }
    }
}

impl Moves for KeyDrag {
    fn go_on(&mut self, pass: &Pass<'_>, to: &To) -> Option<Action> {
        let playing = &pass.editor.playing;
        #[allow(clippy::cast_possible_truncation)]
        let by = to.by.round() as i64;
        let from = as_count(self.from);
        // Between the first frame and the last one.
        let there = by.min(as_count(self.frames) - from).max(1 - from);
        let wanted = match to.copies {
            false => (playing.marks).moved(self.beside, by, playing.moves_along),
            true if there == 0 => Retiming::Nothing,
            true => Retiming::Copy {
                of: self.of,
                to: usize::try_from(from + there).unwrap_or(1),
            },
        };
        (wanted != self.done).then(|| {
            self.done = wanted;
            Action::Time(TimeAction::Retime(wanted))
        })
    }

    fn at(&self, _editor: &Editor, from: f64) -> f64 {
        from + as_frame(self.frame()) - as_frame(self.from)
    }

    fn copies(&self) -> bool {
        matches!(self.done, Retiming::Copy { .. })
    }

    fn more(&self, editor: &Editor) -> Vec<String> {
        let texts = &editor.texts().timeline;
        let line = match self.done {
            Retiming::Move { before, after, by } => {
                let frames = |(_, frames): (Selection, usize), by: i64| as_count(frames) + by;
                let before = frames(before, by);
                match after.map(|after| frames(after, -by)) {
                    Some(after) => fill(texts.sections, &[&before, &after]),
                    None => fill(texts.section, &[&before]),
                }
            }
            _ if self.beside[0].is_none() => texts.first_stays.to_owned(),
            _ => return Vec::new(),
        };
        vec![line]
    }

    fn cursor(&self) -> CursorIcon {
        match self.done {
            Retiming::Copy { .. } => CursorIcon::Copy,
            Retiming::Nothing if self.beside[0].is_none() => CursorIcon::NotAllowed,
            _ => CursorIcon::ResizeHorizontal,
        }
    }
}

fn as_count(frames: usize) -> i64 {
    i64::try_from(frames).unwrap_or(i64::MAX / 4)
}

/// Shows the keys in `rect`, whose words above begin at `top`.
pub(super) fn show(
    editor: &Editor,
    memory: &mut Memory,
    ui: &Ui,
    (rect, top): (Rect, f32),
    axis: &Axis,
    actions: &mut Vec<Action>,
) {
    let Memory { held, carries, .. } = memory;
    *carries = matches!(held, Held::Key(_));
    let palette = theme::palette(ui);
    let ground = Rect::from_x_y_ranges(axis.rail.expand(8.0), rect.y_range());
    let painter = ui.painter_at(ground);
    painter.rect_filled(ground.shrink2(vec2(0.0, 1.0)), 3.0, palette.field);
    let at = axis.x_of(editor.position_on_bar());
    let (of_scene, axis) = (axis, &editor.axis_of_path(axis));
    if editor.document.edits_path() {
        let id = ui.scope_id().with("sections");
        let response = ui.interact(ground, id, Sense::CLICK);
        let name = editor.texts().timeline.all_sections;
        response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Canvas, true, name));
        section_menu::show(editor, &response, axis, actions);
        sections(editor, &painter, axis, rect);
        let keys = with_room(
            &editor.playing.marks.keys,
            axis,
            editor.document.selection(),
        );
        for (mark, room) in keys {
            key(
                editor,
                (held, *carries),
                ui,
                (mark, room),
                axis,
                rect,
                actions,
            );
        }
    }
    pins::of_keys(editor, &painter, (of_scene, axis), rect.y_range());
    let color = super::ruler::colour_of_playhead(editor, ui);
    painter.vline(at, rect.y_range(), Stroke::new(1.0, color));
    if let Held::Key(drag) = held
        && *carries
    {
        let pass = Pass {
            editor,
            ui,
            response: &ui.interact(rect, drag.of.id, Sense::CLICK | Sense::DRAG),
            axis: of_scene,
            top,
        };
        if drag.go_on(&pass, actions).is_some() {
            *held = Held::Nothing;
        }
    }
}

/// The keys that can be seen one from another, and how far each reaches.
fn with_room(keys: &[Mark], axis: &Axis, current: Selection) -> Vec<(Mark, Rangef)> {
    let mut shown: Vec<(Mark, f32)> = Vec::new();
    for &mark in keys {
        let x = axis.x_of(mark.first());
        if !axis.sees(x) {
            continue;
        }
        let is_current = Selection::at(mark.point, mark.orientation) == current;
        match shown.last_mut() {
            Some(last) if x - last.1 < LEAST => {
                if is_current {
                    *last = (mark, x);
                }
            }
            _ => shown.push((mark, x)),
        }
    }
    let half = |from: Option<&(Mark, f32)>, x: f32| {
        from.map_or(ROOM / 2.0, |(_, other)| {
            ((other - x).abs() / 2.0).min(ROOM / 2.0)
        })
    };
    let reach = |(at, &(mark, x)): (usize, &(Mark, f32))| {
        let before = at.checked_sub(1).and_then(|at| shown.get(at));
        let (left, right) = (half(before, x), half(shown.get(at + 1), x));
        (mark, Rangef::new(x - left, x + right))
    };
    shown.iter().enumerate().map(reach).collect()
}

/// The sections as bars, with the number of the key with which each begins; rests in between.
fn sections(editor: &Editor, painter: &Painter, axis: &Axis, rect: Rect) {
    let palette = theme::palette_of(&painter.ctx().global_style().visuals);
    let marks = &editor.playing.marks;
    let rows = rect.y_range().shrink(4.0);
    let current = editor.document.selection();
    let points = &editor.document.path().points;
    let mut last = f32::NEG_INFINITY;
    for stretch in marks.graph.stretches() {
        let [from, to] = [stretch.start, stretch.end].map(|frame| axis.x_of(as_frame(frame)));
        let is_current = stretch.from == current;
        if to - last < 1.5 && !is_current {
            continue;
        }
        let rests = from - last;
        if last.is_finite() && rests > 1.5 {
            // The camera rests there.
            let place = Rect::from_x_y_ranges(last..=from, rows.shrink(5.0));
            painter.rect_filled(place, 1.0, palette.edge.gamma_multiply(0.5));
        }
        last = to;
        let several = points.get(stretch.from.point);
        let pans =
            several.is_some_and(|point| stretch.from.orientation + 1 < point.orientations.len());
        let part = match (is_current, pans) {
            (true, _) => 0.5,
            (false, false) => 0.28,
            (false, true) => 0.14,
        };
        let place = Rect::from_x_y_ranges(from + 0.5..=(to - 0.5).max(from + 0.5), rows);
        painter.rect_filled(place, 3.0, palette.accent.gamma_multiply(part));
    }
    let mut free = f32::NEG_INFINITY;
    for (at, mark) in marks.keys.iter().enumerate() {
        let x = axis.x_of(mark.first());
        if !axis.sees(x) {
            continue;
        }
        let text = if mark.orientation == 0 {
            (mark.point + 1).to_string()
        } else {
            format!("{}.{}", mark.point + 1, mark.orientation + 1)
        };
        let rests = axis.x_of(as_frame(mark.frame.saturating_add(mark.hold)));
        let wide = rests - x > 60.0 || mark.hold > editor.playing.marks.frames;
        let left = if wide { x } else { x.max(rests - SIGN) } + SIGN + 3.0;
        if left < free {
            continue;
        }
        let next = marks
            .keys
            .get(at + 1)
            .map(|next| axis.x_of(next.first()) - SIGN);
        let galley = painter.layout_no_wrap(text, FontId::proportional(11.0), palette.text);
        let size = galley.size();
        let is_current = Selection::at(mark.point, mark.orientation) == current;
        let fits = next.is_none_or(|next| left + size.x < next);
        if (fits || is_current) && left + size.x < rect.right() {
            free = left + size.x + 2.0;
            let place = pos2(left, rect.center().y - size.y / 2.0);
            painter.galley(place, galley, palette.text);
        }
    }
}

/// A key: clicked it is selected, dragged it moves, with Ctrl a copy of it.
fn key(
    editor: &Editor,
    (held, carries): (&mut Held, bool),
    ui: &Ui,
    (mark, room): (Mark, Rangef),
    axis: &Axis,
    rect: Rect,
    actions: &mut Vec<Action>,
) {
    let texts = &editor.texts().timeline;
    let of = Selection::at(mark.point, mark.orientation);
    let id = Id::unique(("key in time", mark.point, mark.orientation));
    let place = Rect::from_x_y_ranges(room, rect.y_range());
    let painter = ui.painter_at(rect);
    let palette = theme::palette(ui);
    let several = editor.several().is_some() && editor.is_selected(of.point);
    let selected = editor.document.selection() == of || several;
    let middle = pos2(axis.x_of(mark.first()), rect.center().y);
    let paint = |fill, half| {
        let line = Stroke::new(1.5, palette.field);
        painter.add(diamond(middle, half, fill, line));
    };
    let colour = if selected {
        palette.accent
    } else {
        palette.weak
    };
    if carries {
        paint(colour, SIGN);
        return;
    }
    let name = editor.name_of(of.point, of.orientation);
    // Not by Tab: Ctrl with the arrow keys moves it from the ruler.
    let response = ui.interact(place, id, Sense::CLICK | Sense::DRAG);
    let label = fill(texts.key, &[&name]);
    response.widget_info(|| WidgetInfo::slider(true, mark.first(), label.as_str()));
    section_menu::of_key(editor, &response, of, actions);
    if response.clicked() {
        let held = ui.input(|input| input.modifiers);
        actions.push(match held.ctrl || held.shift {
            true => chosen_too(mark.point, held),
            false => Action::Select(of),
        });
    }
    take(editor, held, ui, (&response, of, mark.frame), actions);
    match response.hovered() {
        true => paint(if selected { colour } else { palette.focus }, SIGN + 1.0),
        false => paint(colour, SIGN),
    }
    response.on_hover_ui(|ui| {
        let info = editor.document.info();
        let of_scene = editor.document.frame_of_scene(mark.first());
        let second = editor.language().number((of_scene - 1.0) / info.fps, 2);
        let frame = editor.frame_for_people(of_scene);
        ui.strong(fill(texts.key_at, &[&name, &second, &frame]));
        ui.weak(texts.key_tip);
    });
}

/// Takes the key at a frame by what shows it: its sign or a border of the graph.
pub(super) fn take(
    editor: &Editor,
    held: &mut Held,
    ui: &Ui,
    (response, of, frame): (&Response, Selection, usize),
    actions: &mut Vec<Action>,
) {
    if response.hovered() {
        ui.set_cursor_icon(CursorIcon::ResizeHorizontal);
    }
    if let Some(pointer) = begun(ui, response) {
        let marks = &editor.playing.marks;
        let key = KeyDrag {
            id: response.id,
            of,
            from: frame,
            beside: marks.beside(frame),
            frames: marks.frames,
            done: Retiming::Nothing,
        };
        let name = editor.name_of(of.point, of.orientation);
        let from = editor.document.frame_of_scene(as_frame(frame));
        *held = Held::Key(Drag::new(key, name, from, pointer));
        actions.push(Action::Enter(Entry::Begin));
    }
}
