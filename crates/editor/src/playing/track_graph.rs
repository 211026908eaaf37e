//! The tracks of nodes as curves: their numbers over frames, with keys that are dragged in both and
//! the handles of own tangents. What is dragged is [`super::graph_drag`]'s.

pub(super) use crate::state::playing::track_graph::Memory;
use crate::state::playing::track_graph::{Dot, Parts};
use std::collections::BTreeSet;

use egui::{Pos2, Rect, Response, Role, Sense, Shape, Stroke, Ui, WidgetInfo, pos2, vec2};
use vides_engine::scene::{Channel, Interpolation, Track};

use super::axis::Axis;
use super::graph_paint::{colour, headings, scale, signs};
use super::track_curve::{Curve, Of, is_read_only};
use super::track_time::{REACH, Time};
use super::{graph_drag, key_motion, track_menu, tracks};
use crate::action::Action;
use crate::document::EditedScene;
use crate::state::Editor;
use crate::state::playing::track_graph::{Held, Side};
use crate::state::playing::tracks::Row;
use crate::state::scene_view::KeyAt;

/// As many tracks are shown where none is chosen.
const MOST: usize = 16;

/// How long a handle is.
const HANDLE: f32 = 40.0;

/// The share of the height that stays free above and below.
const FREE: f64 = 0.1;

/// Curves are this near to what the engine says, in points.
const NEAR: f64 = 0.15;

/// From numbers to the screen.
#[derive(Clone, Copy, Debug)]
pub(super) struct Fit {
    low: f64,
    bottom: f64,
    pub(super) per_point: f64,
}

impl Fit {
    fn new((low, high): (f64, f64), rect: Rect) -> Self {
        let (bottom, height) = (f64::from(rect.bottom()), f64::from(rect.height().max(1.0)));
        let per_point = (high - low) / height;
        Self {
            low,
            bottom,
            per_point,
        }
    }

    /// What is far away stays within what can be drawn.
    #[allow(clippy::cast_possible_truncation)]
    pub(super) fn y(&self, value: f64) -> f32 {
        let y = self.bottom - (value - self.low) / self.per_point;
        y.clamp(-1e5, 1e5) as f32
    }
}

/// The least and the greatest number that are seen, with room around them.
fn range_of(bounds: Option<(f64, f64)>) -> (f64, f64) {
    let (low, high) = bounds.unwrap_or((0.0, 1.0));
    let least = 1e-9 * low.abs().max(high.abs()).max(1e-3);
    let more = match high - low > least {
        true => FREE * (high - low),
        false => 0.5 * high.abs().max(1.0),
    };
    (low - more, high + more)
}

/// What is seen.
pub(super) struct Shown<'a> {
    pub(super) time: Time,
    pub(super) fit: Fit,
    pub(super) ground: Rect,
    pub(super) tracks: Vec<Of<'a>>,
    pub(super) selected: Vec<KeyAt>,
}

/// What lies under the pointer.
pub(super) enum Hit {
    Nothing,
    Dot(Dot),
    Handle(Dot, Side),
}

impl<'a> Shown<'a> {
    pub(super) fn place(&self, of: &Of<'_>, key: usize, part: usize) -> Pos2 {
        let x = self.time.x(of.track.frames()[key]);
        pos2(x, self.fit.y(of.of_key(key, part)))
    }

    pub(super) fn track_of(&self, at: &KeyAt) -> Option<Of<'a>> {
        let same = |of: &&Of<'_>| of.node == at.node && of.track.channel().same_as(&at.channel);
        self.tracks.iter().find(same).copied()
    }

    /// Where the handle of a tangent stands.
    pub(super) fn handle(&self, of: &Of<'_>, dot: &Dot, side: Side) -> Option<Pos2> {
        let slope = side.slope(of.track, dot.at.key, dot.part)?;
        let way = vec2(1.0, self.rise(slope)).normalized() * HANDLE * side.sign();
        Some(self.place(of, dot.at.key, dot.part) + way)
    }

    /// Points downwards for each to the right, of a number that changes by so much a frame.
    #[allow(clippy::cast_possible_truncation)]
    fn rise(&self, slope: f64) -> f32 {
        let rise = -slope * self.time.axis.frames_per_point() / self.fit.per_point;
        rise.clamp(-1e6, 1e6) as f32
    }

    /// The same backwards, of a handle that is so far away from its key.
    pub(super) fn slope(&self, way: egui::Vec2) -> f64 {
        let frames = f64::from(way.x) * self.time.axis.frames_per_point();
        -f64::from(way.y) * self.fit.per_point / frames
    }

    /// The handles that are seen, of selected numbers.
    pub(super) fn handles(&self, parts: &Parts) -> Vec<(Dot, Side, Pos2)> {
        let mut all = Vec::new();
        for dot in self.dots(parts) {
            let Some(of) = self.track_of(&dot.at) else {
                continue;
            };
            let sides = [Side::Before, Side::After].into_iter();
            let places = sides.filter_map(|side| Some((side, self.handle(&of, &dot, side)?)));
            all.extend(places.map(|(side, place)| (dot.clone(), side, place)));
        }
        all
    }

    /// The selected numbers of keys that are in sight.
    pub(super) fn dots(&self, parts: &Parts) -> Vec<Dot> {
        let mut all = Vec::new();
        for at in &self.selected {
            let Some(of) = self.track_of(at) else {
                continue;
            };
            let frame = of.track.frames()[at.key];
            if !self.time.axis.sees(self.time.x(frame)) {
                continue;
            }
            let chosen = parts_of(parts, at, frame, of.width());
            all.extend(chosen.map(|part| Dot {
                at: at.clone(),
                part,
            }));
        }
        all
    }

    pub(super) fn hit(&self, parts: &Parts, at: Pos2) -> Hit {
        for (dot, side, place) in self.handles(parts) {
            if place.distance(at) <= REACH {
                return Hit::Handle(dot, side);
            }
        }
        let ends = [at.x - REACH, at.x + REACH].map(|x| self.time.frame(x));
        let mut near: Option<(f32, Dot)> = None;
        for of in &self.tracks {
            for key in keys_between(of.track, ends) {
                for part in 0..of.width() {
                    let away = self.place(of, key, part).distance(at);
                    let nearer = near.as_ref().is_none_or(|(known, _)| away < *known);
                    if away <= REACH && nearer {
                        near = Some((away, dot(of, key, part)));
                    }
                }
            }
        }
        near.map_or(Hit::Nothing, |(_, dot)| Hit::Dot(dot))
    }

    /// The numbers of keys within a box.
    pub(super) fn within(&self, place: Rect) -> Vec<Dot> {
        let ends = [place.left(), place.right()].map(|x| self.time.frame(x));
        let mut all = Vec::new();
        for of in &self.tracks {
            for key in keys_between(of.track, ends) {
                let inside = (0..of.width())
                    .filter(|&part| place.y_range().contains(self.place(of, key, part).y));
                all.extend(inside.map(|part| dot(of, key, part)));
            }
        }
        all
    }
}

fn dot(of: &Of<'_>, key: usize, part: usize) -> Dot {
    let (node, channel) = (of.node, of.track.channel().clone());
    let at = KeyAt { node, channel, key };
    Dot { at, part }
}

pub(super) fn keys_between(track: &Track, [first, last]: [f64; 2]) -> std::ops::Range<usize> {
    let frames = track.frames();
    let low = frames.partition_point(|&key| key < first);
    low..frames.partition_point(|&key| key <= last).max(low)
}

/// Which numbers of a selected key are.
pub(super) fn parts_of(
    parts: &Parts,
    at: &KeyAt,
    frame: f64,
    width: usize,
) -> impl Iterator<Item = usize> {
    let key = |part| (at.node, at.channel.clone(), frame.to_bits(), part);
    let known = parts.range(key(0)..key(usize::MAX));
    let mut known: Vec<usize> = known.map(|of| of.3).filter(|&part| part < width).collect();
    if known.is_empty() {
        known.extend(0..width);
    }
    known.into_iter()
}

/// Selects these numbers.
pub(super) fn select(
    memory: &mut Memory,
    shown: &Shown<'_>,
    dots: Vec<Dot>,
    actions: &mut Vec<Action>,
) {
    memory.parts.clear();
    let mut keys: Vec<KeyAt> = Vec::new();
    for Dot { at, part } in dots {
        let Some(of) = shown.track_of(&at) else {
            continue;
        };
        let frame = of.track.frames()[at.key].to_bits();
        let of_key = (at.node, at.channel.clone(), frame, part);
        if memory.parts.insert(of_key) && keys.last() != Some(&at) {
            keys.push(at);
        }
    }
    let mut seen = BTreeSet::new();
    keys.retain(|at| seen.insert((at.node, at.channel.clone(), at.key)));
    if keys != shown.selected {
        actions.push(Action::SelectKeys(keys));
    }
}

impl Memory {
    /// The rows whose curves are seen.
    pub(super) fn shows(&self, editor: &Editor, edited: &EditedScene, rows: &[Row]) -> Vec<Row> {
        let with_track = || rows.iter().filter(|row| row.track.is_some());
        let is_one_of = |row: &Row, all: &[(usize, Channel)]| {
            let channel = row.track(edited).map(Track::channel);
            channel.is_some_and(|own| {
                all.iter()
                    .any(|(node, other)| *node == row.node && own.same_as(other))
            })
        };
        let mut all: Vec<Row> = match self.chosen.is_empty() {
            true => Vec::new(),
            false => with_track()
                .filter(|row| is_one_of(row, &self.chosen))
                .copied()
                .collect(),
        };
        if all.is_empty() {
            let selected = editor.selected_keys();
            let tracks = key_motion::by_track(&selected).into_iter();
            let tracks: Vec<_> = tracks.map(|(node, channel, _)| (node, channel)).collect();
            let selected = with_track().filter(|row| is_one_of(row, &tracks));
            all = selected.take(MOST).copied().collect();
        }
        if all.is_empty() {
            all.extend(with_track().next());
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
        let of = |row: Row| Some((row.node, row.track(edited)?.channel().clone()));
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
    let scene = edited.scene();
    let tracks = rows.iter().filter_map(|row| {
        Some(Of {
            scene,
            node: row.node,
            track: row.track(edited)?,
        })
    });
    let tracks: Vec<Of<'_>> = tracks.collect();
    let time = Time::new(axis);
    let ends = (time.frame(ground.left()), time.frame(ground.right()));
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
        time,
        fit: Fit::new(range, ground),
        ground,
        tracks,
        selected: editor.selected_keys(),
    };
    let response = ui.interact(ground, tracks::id(), Sense::click_and_drag());
    let name = editor.texts().timeline.graph_of_keys;
    response.widget_info(|| WidgetInfo::labeled(Role::Canvas, true, name));
    let painter = ui.painter_at(ground.intersect(ui.clip_rect()));
    scale(editor, ui, &painter, (&shown, range), rect.left());
    for (of, curve) in shown.tracks.iter().zip(&curves) {
        for part in 0..of.width() {
            let place = |(frame, value)| pos2(shown.time.x(frame), shown.fit.y(value));
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
    graph_drag::show(
        editor,
        &mut memory.graph,
        ui,
        &response,
        (&shown, top),
        actions,
    );
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
        let of_dot = |row: &&Row| {
            let track = shown
                .tracks
                .iter()
                .zip(rows)
                .find(|(_, other)| other == row);
            let channel = track.map(|(of, _)| of.track.channel());
            row.node == dot.at.node && channel.is_some_and(|own| own.same_as(&dot.at.channel))
        };
        memory.menu = rows.iter().find(of_dot).copied();
        if !shown.selected.contains(&dot.at) {
            memory.graph.keep(shown);
            select(&mut memory.graph, shown, vec![dot], actions);
        }
    }
    if let Some(at) = pointer.filter(|_| response.clicked()) {
        response.request_focus();
        memory.graph.keep(shown);
        let held = ui.input(|input| input.modifiers);
        let dot = match shown.hit(&memory.graph.parts, at) {
            Hit::Dot(dot) => Some(dot),
            Hit::Handle(..) => return,
            Hit::Nothing => None,
        };
        let dots = chosen(&memory.graph, shown, dot, held);
        select(&mut memory.graph, shown, dots, actions);
    }
    if let Some(row) = memory.menu {
        track_menu::show(editor, &mut memory.graph, response, row, actions);
    }
}

/// The selection after a click at this number of a key.
fn chosen(memory: &Memory, shown: &Shown<'_>, dot: Option<Dot>, held: egui::Modifiers) -> Vec<Dot> {
    let mut all = match held.ctrl || held.shift {
        true => shown.dots(&memory.parts),
        false => Vec::new(),
    };
    let Some(dot) = dot else {
        return all;
    };
    if held.ctrl && all.contains(&dot) {
        all.retain(|other| *other != dot);
        return all;
    }
    // All up to here from the last one that was clicked on the curve.
    let same = |other: &&Dot| {
        let (a, b) = (&other.at, &dot.at);
        (a.node, &a.channel, other.part) == (b.node, &b.channel, dot.part)
    };
    let from = all.iter().find(same).map_or(dot.at.key, |at| at.at.key);
    let from = if held.shift { from } else { dot.at.key };
    for key in from.min(dot.at.key)..=from.max(dot.at.key) {
        let mut next = dot.clone();
        next.at.key = key;
        if !all.contains(&next) {
            all.push(next);
        }
    }
    if !held.shift {
        all.rotate_right(1);
    }
    all
}

/// Whether the numbers of a track have handles.
pub(super) fn has_handles(track: &Track) -> bool {
    *track.interpolation() == Interpolation::Hermite && !is_read_only(track)
}

#[cfg(test)]
#[path = "track_graph_tests.rs"]
pub(super) mod tests;
