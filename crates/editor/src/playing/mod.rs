//! Playing: the bar under the movement window, with all frames and the marks of the orientations.
//!
//! While it plays the window asks for the next frame when that is due; at rest it asks for nothing.

mod buttons;
mod curve;
mod fields;
mod graph;
pub(crate) mod playhead;
mod plot;

use std::time::Duration;

use egui::{
    Context, CursorIcon, EventFilter, FontId, Key, Modifiers, Painter, Pos2, Rect, Sense, Shape,
    Stroke, Ui, UiBuilder, WidgetInfo, pos2, vec2,
};

use self::buttons::{camera_button, play_button, speed_button};
pub(super) use self::fields::Pace;
use crate::actions::Action;
use crate::document::{Document, Selection};
use crate::error::Result;
use crate::number::Entry;
use crate::path::{Change, Timeline};
use crate::selected::SelectionChange;
use crate::setup::Element;
use crate::space::Camera;
use crate::state::Editor;
use crate::theme;
use crate::tools::profile::Quantity;

const HEIGHT: f32 = 56.0;

/// A lower window has little room for the graph of the speeds.
const MIN_HEIGHT_FOR_GRAPH: f32 = 660.0;

const BUTTON: f32 = 32.0;

/// A press this near to a mark, in points, means the mark.
const SNAP: f64 = 6.0;

/// Seconds between updates of the marks in a drag: a change of the first section moves them all.
const MARKS_STEP: f64 = 0.25;

#[derive(Debug, Default)]
pub(super) struct Playing {
    /// The frame that is shown, from 1; none: the current orientation.
    frame: Option<f64>,
    /// While it plays: since when, in egui's time, and from which frame.
    since: Option<(f64, f64)>,
    /// Whether to play from the next pass on, if that was ordered.
    ordered: Option<bool>,
    /// The playhead was moved by hand.
    scrubbed: bool,
    /// Begins anew at the end.
    loops: bool,
    pace: Pace,
    /// The frame before a number of the bar was dragged.
    before: Option<f64>,
    /// What was current in the last pass.
    selection: Selection,
    marks: Marks,
    between: Option<playhead::Between>,
    /// When `marks` were brought up to date, in egui's time.
    marked: f64,
    speeds: graph::Memory,
    /// The window is low, and the graph is to be shown there, too.
    low: bool,
    low_graph: bool,
    /// What is plotted instead of the speeds.
    quantity: Option<Quantity>,
    plot: plot::Plot,
}

/// The keys of the path on the scale of its frames.
#[derive(Debug, Default)]
struct Marks {
    revision: Option<u64>,
    keys: Vec<Mark>,
    /// The scene's markers: frames of the path, and their names.
    markers: Vec<(f64, String)>,
    /// All frames; 0 if there are too many.
    frames: usize,
    graph: graph::Graph,
}

/// An orientation and its frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Mark {
    pub(super) point: usize,
    pub(super) orientation: usize,
    frame: usize,
    /// For how many frames more the camera rests there.
    hold: usize,
}

impl Mark {
    /// The frame in which the key is reached.
    pub(super) fn first(self) -> f64 {
        as_frame(self.frame)
    }

    /// The last frame that shows it.
    pub(super) fn last(self) -> f64 {
        as_frame(self.frame + self.hold)
    }
}

impl Marks {
    fn update(&mut self, document: &Document) -> Result<()> {
        let revision = document.revision();
        if self.revision == Some(revision) {
            return Ok(());
        }
        self.revision = Some(revision);
        self.keys.clear();
        self.markers.clear();
        self.graph.clear();
        self.frames = 0;
        if let Some(edited) = document.edited_scene() {
            let markers = edited.scene().markers().iter();
            let of_path = |frame: f64| document.frame_of_path(frame);
            self.markers
                .extend(markers.map(|marker| (of_path(marker.frame), marker.name.clone())));
        }
        if !document.edits_path() {
            // No path is edited, so there are no keys to show.
            self.frames = document.timeline(Timeline::frame_count)??;
            return Ok(());
        }
        let path = document.path();
        let keys = &mut self.keys;
        self.frames = document.timeline(|timeline| {
            let mut frame = 1;
            for index in 0..timeline.section_count() {
                let section = timeline.section(index);
                let (point, orientation) = (section.point, section.orientation);
                keys.try_reserve(2)?;
                let hold = if section.change == Change::Nothing {
                    0
                } else {
                    path.points[point].orientations[orientation].hold as usize
                };
                keys.push(Mark {
                    point,
                    orientation,
                    frame,
                    hold,
                });
                if section.change != Change::Nothing {
                    frame += hold + section.frames;
                }
            }
            if let Some(point) = path.points.len().checked_sub(1).filter(|_| !path.closed) {
                let orientation = path.points[point].orientations.len().saturating_sub(1);
                let hold = usize::MAX - frame;
                keys.push(Mark {
                    point,
                    orientation,
                    frame,
                    hold,
                });
            }
            timeline.frame_count()
        })??;
        self.graph.update(document, &self.keys)
    }

    /// The markers between the first frame and the last one.
    fn markers_between(&self, last: f64) -> impl Iterator<Item = &(f64, String)> {
        let within = move |marker: &&(f64, String)| (1.0..=last).contains(&marker.0);
        self.markers.iter().filter(within)
    }

    fn of(&self, selection: Selection) -> Option<Mark> {
        let mut keys = self.keys.iter().copied();
        keys.find(|mark| Selection::at(mark.point, mark.orientation) == selection)
    }
}

impl Playing {
    pub(super) fn is_playing(&self) -> bool {
        self.since.is_some()
    }

    /// Whether it plays once what was ordered is done.
    pub(super) fn will_play(&self) -> bool {
        self.ordered.unwrap_or(self.is_playing())
    }

    pub(super) fn was_scrubbed(&self) -> bool {
        self.scrubbed
    }

    /// Starts or stops playing in the next pass.
    pub(super) fn order(&mut self, plays: bool) {
        self.ordered = Some(plays);
    }

    pub(super) fn frame(&self) -> Option<f64> {
        self.frame
    }

    /// The last key at or before a frame.
    pub(super) fn mark_before(&self, frame: f64) -> Option<Mark> {
        let keys = &self.marks.keys;
        let behind = keys.partition_point(|mark| mark.first() <= frame);
        keys.get(behind.checked_sub(1)?).copied()
    }

    pub(super) fn mark_of(&self, selection: Selection) -> Option<Mark> {
        self.marks.of(selection)
    }

    /// The playhead has selected a key: it stands at it, or beside it.
    pub(super) fn selected(&mut self, selection: Selection, at_it: bool) {
        self.selection = selection;
        if at_it {
            self.frame = None;
        }
    }

    pub(super) fn put_back(&mut self, frame: Option<f64>, selection: Selection) {
        (self.frame, self.selection) = (frame, selection);
    }

    /// Stops playing, with the playhead at the current key.
    pub(super) fn leave(&mut self) {
        (self.frame, self.since) = (None, None);
        self.scrubbed = false;
    }
}

impl Editor {
    /// The camera at the frame that is played, else the current one; and whether it is of a frame.
    pub(super) fn camera(&self) -> Option<(Camera, bool)> {
        let frame = self.playing.frame;
        if let Some(pose) = frame.and_then(|frame| self.document.sampler().ok()?.pose(frame).ok()) {
            return Some((pose.into(), true));
        }
        let Selection { point, orientation } = self.document.selection();
        Camera::at(&self.document, point, orientation).map(|camera| (camera, false))
    }

    #[allow(clippy::cast_possible_truncation)]
    pub(super) fn shown_frame(&self) -> Option<i64> {
        let frame = self.playing.frame?.round() as i64;
        Some(frame - 1 + i64::from(self.document.info().first_frame))
    }

    /// Plays, from the beginning if at the end, or stops.
    pub(super) fn play_or_pause(&mut self, context: &Context) {
        if self.playing.since.take().is_some() {
            self.select_at_playhead();
            return;
        }
        let last = as_frame(self.playing.marks.frames);
        let at = self.position_on_bar();
        let from = if at >= last { 1.0 } else { at };
        self.playing.frame = Some(from);
        self.playing.since = Some((context.input(|input| input.time), from));
    }

    pub(super) fn set_pace(&mut self, pace: Pace, context: &Context) {
        self.go_on_from_here(context);
        self.playing.pace = pace;
    }

    /// Plots a quantity, or the speeds of the sections.
    pub(super) fn plot(&mut self, quantity: Option<Quantity>) {
        self.playing.quantity = quantity;
    }

    /// A low window shows the graph if it is asked for there.
    fn shows_speed_graph(&self) -> bool {
        let playing = &self.playing;
        if playing.low {
            playing.low_graph
        } else {
            self.setup.speed_graph
        }
    }

    pub(super) fn switch_speed_graph(&mut self) {
        let shows = !self.shows_speed_graph();
        if self.playing.low {
            self.playing.low_graph = shows;
        } else {
            self.setup.speed_graph = shows;
        }
    }

    pub(super) fn switch_loops(&mut self, context: &Context) {
        self.go_on_from_here(context);
        self.playing.loops = !self.playing.loops;
    }

    /// Counts the time of playing from now on, from the frame that is shown.
    fn go_on_from_here(&mut self, context: &Context) {
        let (now, at) = (context.input(|input| input.time), self.position_on_bar());
        let playing = &mut self.playing;
        playing.since = playing.since.map(|_| (now, at));
    }

    /// Goes to a frame; out of range to the nearest one.
    pub(super) fn scrub(&mut self, frame: f64) {
        self.playing.since = None;
        // The path may have changed since they were shown; too many frames leave it without marks.
        let _ = self.playing.marks.update(&self.document);
        self.playing.frame = Some(frame.clamp(1.0, as_frame(self.playing.marks.frames)));
        self.playing.scrubbed = true;
        self.select_at_playhead();
    }

    /// Moves the playhead by a number of the bar.
    pub(super) fn enter_frame(&mut self, entry: Entry) {
        match entry {
            Entry::Begin => self.playing.before = Some(self.position_on_bar()),
            Entry::Drag(frame) | Entry::Set(frame) => self.scrub(frame),
            Entry::Cancel => {
                if let Some(before) = self.playing.before.take() {
                    self.scrub(before);
                }
            }
            Entry::Wrong(why) => self.complain(why),
            Entry::Idle | Entry::End => {}
        }
    }

    /// The frame at which the bar's handle stands.
    pub(super) fn position_on_bar(&self) -> f64 {
        let playing = &self.playing;
        let current = || Some(playing.marks.of(self.document.selection())?.first());
        playing.frame.or_else(current).unwrap_or(1.0)
    }

    /// Keeps the state in step with time, path and selection.
    fn advance(&mut self, context: &Context) {
        let now = context.input(|input| input.time);
        let rest = self.playing.marked + MARKS_STEP - now;
        if rest > 0.0 && self.space.moves() && self.playing.frame.is_none() {
            context.request_repaint_after(Duration::from_secs_f64(rest.min(MARKS_STEP)));
        } else {
            self.playing.marked = now;
            let quantity = self.playing.quantity.filter(|_| self.shows_speed_graph());
            // Too many frames to plot are reported elsewhere.
            let mut plot = std::mem::take(&mut self.playing.plot);
            let held = context.input(|input| input.pointer.any_down());
            let _ = plot.update(&self.document, quantity, held, || self.obstacles());
            self.playing.plot = plot;
            if let Err(error) = self.playing.marks.update(&self.document)
                && self.playing.frame.is_some()
            {
                self.complain_of(&error);
            }
        }
        let playing = &mut self.playing;
        let selection = self.document.selection();
        // A newly selected orientation is to be seen.
        if playing.selection != selection && playing.since.is_none() {
            playing.leave();
        }
        playing.selection = selection;
        if playing.marks.frames == 0 {
            (playing.frame, playing.since) = (None, None);
        }
        let last = as_frame(playing.marks.frames);
        playing.frame = playing.frame.map(|frame| frame.clamp(1.0, last.max(1.0)));
        let ordered = playing.ordered.take();
        if ordered.is_some_and(|plays| plays != playing.is_playing()) {
            self.play_or_pause(context);
        }
        let playing = &mut self.playing;
        if context.text_edit_focused() && playing.since.take().is_some() {
            // A number must not come to mean another key while it is typed.
            self.select_at_playhead();
        }
        let playing = &mut self.playing;
        let Some((start, from)) = playing.since else {
            return;
        };
        let fps = self.document.info().fps * playing.pace.factor();
        let mut gone = (now - start).max(0.0) * fps;
        let loops = playing.loops && last > 1.0;
        if loops {
            // The last frame is seen as long as the others.
            gone = (from - 1.0 + gone).rem_euclid(last) - (from - 1.0);
        }
        let frame = (from + gone).floor().min(last);
        playing.frame = Some(frame);
        if frame >= last && !loops {
            playing.since = None;
            self.select_at_playhead();
        } else {
            // Until the next whole frame is due.
            let wait = (frame + 1.0 - from - gone) / fps;
            context.request_repaint_after(Duration::from_secs_f64(wait.clamp(0.001, 3600.0)));
        }
    }
}

#[allow(clippy::cast_precision_loss)]
fn as_frame(frame: usize) -> f64 {
    frame as f64
}

pub(super) fn show(editor: &mut Editor, ui: &mut Ui) {
    editor.playing.low = ui.ctx().content_rect().height() < MIN_HEIGHT_FOR_GRAPH;
    editor.advance(ui.ctx());
    editor.keep_between();
    let context = ui.ctx().clone();
    let mut speeds = std::mem::take(&mut editor.playing.speeds);
    editor.part(&context, |editor, actions| {
        bar(editor, &mut speeds, ui, actions)
    });
    editor.playing.speeds = speeds;
}

fn bar(editor: &Editor, graph: &mut graph::Memory, ui: &mut Ui, actions: &mut Vec<Action>) {
    let palette = theme::palette(ui);
    let frame = egui::Frame::new()
        .fill(palette.panel)
        .inner_margin(egui::Margin {
            left: 12,
            right: 12,
            top: 0,
            bottom: 0,
        });
    let speeds = if editor.shows_speed_graph() {
        graph::HEIGHT + theme::GAP
    } else {
        0.0
    };
    egui::Panel::bottom("playing")
        .resizable(false)
        .exact_size(HEIGHT + speeds)
        .frame(frame)
        .show(ui, |ui| {
            let whole = ui.max_rect();
            let (top, below) = whole.split_top_bottom_at_y(whole.top() + HEIGHT);
            let row = UiBuilder::new().max_rect(top);
            let rail = ui.scope_builder(row, |ui| {
                ui.horizontal_centered(|ui| {
                    ui.spacing_mut().item_spacing.x = 12.0;
                    play_button(editor, ui, actions);
                    fields::show(editor, ui, actions);
                    let buttons = 2.0 * (BUTTON + theme::GAP) + 8.0;
                    let width = ui.available_width() - buttons;
                    let rail = timeline(editor, ui, width.max(60.0), actions);
                    ui.spacing_mut().item_spacing.x = theme::GAP;
                    speed_button(editor, ui, actions);
                    camera_button(editor, ui, actions);
                    rail
                })
            });
            if speeds > 0.0 {
                let rail = rail.inner.inner;
                let rect = below.with_max_y(below.bottom() - theme::GAP);
                graph::show(editor, graph, ui, rect, rail, actions);
            }
        });
}

/// The scale of frames with its handle; returns its rail.
fn timeline(editor: &Editor, ui: &mut Ui, width: f32, actions: &mut Vec<Action>) -> Rect {
    let (rect, response) = ui.allocate_exact_size(vec2(width, HEIGHT), Sense::click_and_drag());
    let texts = &editor.texts().space;
    let name = texts.timeline;
    let at = editor.position_on_bar();
    response.widget_info(|| WidgetInfo::slider(true, at, name));
    let rail = Rect::from_min_max(
        pos2(rect.left() + 8.0, rect.center().y - 2.0),
        pos2(rect.right() - 8.0, rect.center().y + 2.0),
    );
    if editor.playing.marks.frames > 0 {
        scrub_by_mouse(editor, ui, &response, rail, actions);
        scrub_by_keys(editor, ui, &response, actions);
    }
    if response.hovered() || response.dragged() {
        ui.set_cursor_icon(CursorIcon::PointingHand);
    }
    paint_timeline(editor, ui, rect, rail, response.has_focus());
    response.on_hover_text(texts.timeline_tip);
    rail
}

fn to_frame(frame: f64) -> Action {
    Action::Playhead(Entry::Set(frame))
}

fn scrub_by_mouse(
    editor: &Editor,
    ui: &Ui,
    response: &egui::Response,
    rail: Rect,
    actions: &mut Vec<Action>,
) {
    // A click may come with its press and its release in one pass.
    if !(response.is_pointer_button_down_on() || response.clicked()) {
        return;
    }
    response.request_focus();
    if let Some(pointer) = response.interact_pointer_pos() {
        let share = f64::from((pointer.x - rail.left()) / rail.width().max(1.0));
        let last = as_frame(editor.playing.marks.frames);
        let frame = (1.0 + share * (last - 1.0)).round();
        let pressed = ui.input(|input| input.pointer.any_pressed()) || response.clicked();
        let reach = if pressed { SNAP } else { 1.0 };
        let span = f64::from(rail.width()) / (last - 1.0).max(1.0);
        let away = |mark: &Mark| (mark.first() - frame).abs() * span;
        let marks = editor.playing.marks.keys.iter();
        let nearest = marks.min_by(|a, b| away(a).total_cmp(&away(b)));
        let snapped = nearest.filter(|mark| away(mark) <= reach);
        let mut markers = editor.playing.marks.markers_between(last);
        let marker = markers.find(|(at, _)| (at - frame).abs() * span <= reach);
        // As in the space and in the list: one more, or all up to here.
        let held = ui.input(|input| input.modifiers);
        if held.ctrl || held.shift {
            let choice = snapped
                .filter(|_| response.clicked())
                .map(|mark| match held.ctrl {
                    true => SelectionChange::Switch(mark.point),
                    false => SelectionChange::UpTo(mark.point),
                });
            actions.extend(choice.map(Action::Choose));
            return;
        }
        let marker = marker.map_or(frame, |(at, _)| *at);
        actions.push(to_frame(snapped.map_or(marker, |mark| mark.first())));
        ui.ctx().request_repaint();
    }
}

fn scrub_by_keys(editor: &Editor, ui: &Ui, response: &egui::Response, actions: &mut Vec<Action>) {
    if !response.has_focus() {
        return;
    }
    let filter = EventFilter {
        horizontal_arrows: true,
        ..EventFilter::default()
    };
    ui.memory_mut(|memory| memory.set_focus_lock_filter(response.id, filter));
    let (step, end, plays) = ui.input_mut(|input| {
        let mut count = |modifiers, key| input.count_and_consume_key(modifiers, key) as f64;
        // With Shift first: without modifiers egui would take both.
        let ten =
            count(Modifiers::SHIFT, Key::ArrowRight) - count(Modifiers::SHIFT, Key::ArrowLeft);
        let one = count(Modifiers::NONE, Key::ArrowRight) - count(Modifiers::NONE, Key::ArrowLeft);
        let first = input.consume_key(Modifiers::NONE, Key::Home);
        let last = input.consume_key(Modifiers::NONE, Key::End);
        let plays = input.consume_key(Modifiers::NONE, Key::Space);
        (one + 10.0 * ten, (first, last), plays)
    });
    if step != 0.0 {
        let at = editor.position_on_bar().round();
        actions.push(to_frame(at + step));
    }
    match end {
        (true, _) => actions.push(to_frame(1.0)),
        (_, true) => actions.push(to_frame(as_frame(editor.playing.marks.frames))),
        _ => {}
    }
    if plays {
        actions.push(Action::PlayOrPause);
    }
}

fn paint_timeline(editor: &Editor, ui: &Ui, rect: Rect, rail: Rect, focus: bool) {
    let palette = theme::palette(ui);
    let painter = ui.painter_at(rect);
    let marks = &editor.playing.marks;
    let span = (as_frame(marks.frames) - 1.0).max(1.0);
    #[allow(clippy::cast_possible_truncation)]
    let x_of = |frame: f64| rail.left() + rail.width() * ((frame - 1.0) / span) as f32;
    painter.rect_filled(rail, 2.0, palette.edge);
    let at = x_of(editor.position_on_bar());
    let done = Rect::from_min_max(rail.min, pos2(at, rail.bottom()));
    painter.rect_filled(done, 2.0, palette.accent);
    let selection = editor.document.selection();
    let scale = ui.ctx().pixels_per_point();
    let mut free = f32::NEG_INFINITY;
    let mut last_tick = f32::NEG_INFINITY;
    for mark in &marks.keys {
        let x = x_of(as_frame(mark.frame));
        let current = (mark.point, mark.orientation) == (selection.point, selection.orientation);
        if x - last_tick < 3.0 && !current {
            continue;
        }
        last_tick = x;
        let color = if current {
            palette.accent
        } else {
            palette.weak
        };
        // One pixel wide, on whole pixels.
        let left = (x * scale).floor() / scale;
        let tick = Rect::from_min_max(
            pos2(left, rail.top() - 7.0),
            pos2(left + 1.0 / scale, rail.top() - 1.0),
        );
        painter.add(theme::block(tick, color));
        if x < free {
            continue;
        }
        let text = if mark.orientation == 0 {
            (mark.point + 1).to_string()
        } else {
            format!("{}.{}", mark.point + 1, mark.orientation + 1)
        };
        let galley = painter.layout_no_wrap(text, FontId::proportional(11.0), color);
        let width = galley.size().x;
        let left = (x - width / 2.0).clamp(rect.left(), (rect.right() - width).max(rect.left()));
        if left > free {
            free = left + width + 4.0;
            painter.galley(
                pos2(left, rail.top() - 9.0 - galley.size().y),
                galley,
                color,
            );
        }
    }
    paint_markers(ui, &painter, marks, rail, &x_of);
    let plays = editor.playing.frame.is_some();
    let handle: Pos2 = pos2(at, rail.center().y);
    let color = if plays {
        editor.setup.colours().of(Element::Player)
    } else {
        palette.accent
    };
    painter.circle(handle, 7.0, color, Stroke::new(2.0, palette.panel));
    if focus {
        painter.circle_stroke(handle, 9.5, Stroke::new(1.5, palette.focus));
    }
}

/// The scene's markers below the rail, with their names as far as there is room.
fn paint_markers(ui: &Ui, painter: &Painter, marks: &Marks, rail: Rect, x_of: &dyn Fn(f64) -> f32) {
    let palette = theme::palette(ui);
    let mut free = f32::NEG_INFINITY;
    for (frame, name) in marks.markers_between(as_frame(marks.frames)) {
        let tip = pos2(x_of(*frame), rail.bottom() + 2.0);
        let corners = [tip, tip + vec2(3.5, 6.0), tip + vec2(-3.5, 6.0)];
        let sign = Shape::convex_polygon(corners.to_vec(), palette.weak, Stroke::NONE);
        painter.add(sign);
        let galley = painter.layout_no_wrap(name.clone(), FontId::proportional(11.0), palette.weak);
        let room = painter.clip_rect();
        let width = galley.size().x;
        let left =
            (tip.x - width / 2.0).clamp(room.left(), (room.right() - width).max(room.left()));
        if left > free {
            free = left + width + 6.0;
            painter.galley(pos2(left, tip.y + 7.0), galley, palette.weak);
        }
    }
}

#[cfg(test)]
mod tests;
