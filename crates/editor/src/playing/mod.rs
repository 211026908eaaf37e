//! The timeline under the whole window: playing, a ruler, the keys, a graph.
//!
//! While it plays the window asks for the next frame when that is due; at rest it asks for nothing.

pub(crate) mod axis;
mod buttons;
mod curve;
mod drag;
mod fields;
mod graph;
mod graph_drag;
mod graph_paint;
mod key_menu;
mod key_motion;
mod key_row;
mod markers;
mod marks;
mod moment;
mod pins;
pub(crate) mod playhead;
mod plot;
mod retime;
mod ruler;
mod section_menu;
mod time_action;
mod track_clipboard;
mod track_curve;
mod track_dots;
mod track_drag;
mod track_graph;
mod track_keys;
pub(crate) mod track_menu;
mod track_rows;
mod tracks;
mod zoom;

use std::time::Duration;

use egui::{Context, CursorIcon, Id, Rangef, Rect, Sense, Ui, UiBuilder, pos2};
use vides_document::Selection;
use vides_engine::tools::profile::Quantity;

use self::axis::Axis;
pub(super) use self::axis::Seen;
pub(super) use self::pins::menu as pin_menu;
pub(super) use self::track_keys::take_keys;
use crate::action::{Action, TimeAction};
use crate::entry::Entry;
use crate::space::cameras::Camera;
use crate::state::Editor;
use crate::state::playing::{Mark, Pace, Playing};
use crate::texts::refusals::of_edit;
use crate::{theme, windows};

/// A lower window has little room for the graph.
const MIN_HEIGHT_FOR_GRAPH: f32 = 660.0;

/// Height of the row with what plays.
const TRANSPORT: f32 = 32.0;

/// Width of what stands at the left of the rows, in a window with room and in a narrow one.
const CAPTIONS: (f32, f32) = (132.0, 92.0);

/// At the left and right edge; around the rail, for the first and the last key.
const MARGIN: f32 = 12.0;
const END: f32 = 8.0;

/// Height of the edge by which the timeline is made higher.
const EDGE: f32 = 6.0;

/// Seconds between updates of the marks in a drag: a change of the first section moves them all.
const MARKS_STEP: f64 = 0.25;

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

    /// The playhead has selected a key at its frame or next to it.
    pub(super) fn selected(&mut self, selection: Selection, at_it: bool) {
        self.selection = selection;
        if at_it {
            self.frame = None;
        }
    }

    /// Shows a part of the time, or all.
    pub(super) fn see(&mut self, seen: Option<Seen>) {
        self.seen = seen;
    }

    /// Keeps the playhead in sight.
    fn follow(&mut self, pages: bool) {
        if let Some(frame) = self.frame {
            self.seen = self.seen.map(|seen| seen.showing(frame, pages));
        }
    }

    /// Forgets all of another document; what the user prefers stays.
    pub(super) fn show_anew(&mut self, selection: Selection) {
        *self = Self {
            loops: self.loops,
            pace: self.pace,
            low: self.low,
            low_graph: self.low_graph,
            graph_height: self.graph_height,
            shown: self.shown,
            moves_along: self.moves_along,
            selection,
            ..Self::default()
        };
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
        let there = frame.and_then(|frame| self.seen_on_path(frame));
        if let Some(pose) = there.and_then(|frame| self.document.sampler().ok()?.pose(frame).ok()) {
            return Some((pose.into(), true));
        }
        let Selection { point, orientation } = self.document.selection();
        Camera::at(&self.document, point, orientation).map(|camera| (camera, false))
    }

    /// Plays, from the beginning if at the end, or stops.
    pub(super) fn play_or_pause(&mut self, context: &Context) {
        if self.playing.since.take().is_some() {
            self.select_at_playhead();
            return;
        }
        let (first, last) = self.played();
        let at = self.position_on_bar();
        let within = at >= first && at < last;
        let from = if within { at } else { first };
        self.playing.frame = Some(from);
        self.playing.since = Some((context.input(|input| input.time), from));
    }

    pub(super) fn set_pace(&mut self, pace: Pace, context: &Context) {
        self.go_on_from_here(context);
        self.playing.pace = pace;
    }

    /// Shows a quantity in the graph, or the pace, or no longer.
    pub(super) fn plot(&mut self, quantity: Option<Quantity>) {
        self.playing.shown.switch(quantity);
    }

    pub(super) fn switch_moves_along(&mut self) {
        self.playing.moves_along = !self.playing.moves_along;
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

    /// The graph's height; what is too much is cut off where it is shown.
    pub(super) fn set_graph_height(&mut self, height: f32) {
        self.playing.graph_height = Some(height).filter(|height| height.is_finite());
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
        self.playing.scrubbed = true;
        self.put_playhead(frame);
        self.playing.follow(false);
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

    /// Another rate, at which whatever happens keeps its second, the playhead too; at the current
    /// key it stays there, though keys lie on whole frames.
    pub(super) fn set_rate(&mut self, fps: f64) {
        let at = self.playing.frame;
        let ratio = fps / self.document.info().fps;
        match self.document.rate_edits(fps) {
            Ok(edits) => {
                if self.edit_all(edits)
                    && let Some(at) = at
                {
                    self.scrub(1.0 + (at - 1.0) * ratio);
                }
            }
            Err(error) => self.complain(of_edit(self.language(), &error)),
        }
    }

    /// The frame at which the bar's handle stands.
    pub(super) fn position_on_bar(&self) -> f64 {
        let playing = &self.playing;
        let current = || {
            let mark = playing.marks.of(self.document.selection())?;
            Some(self.document.frame_of_scene(mark.first()))
        };
        let first = playing.marks.range.0;
        playing.frame.or_else(current).unwrap_or(first)
    }

    /// Keeps the state in step with time, path and selection.
    fn advance(&mut self, context: &Context) {
        let now = context.input(|input| input.time);
        let rest = self.playing.marked + MARKS_STEP - now;
        if rest > 0.0 && self.space.moves() && self.playing.frame.is_none() {
            context.request_repaint_after(Duration::from_secs_f64(rest.min(MARKS_STEP)));
        } else {
            self.playing.marked = now;
            let shown = match self.shows_speed_graph() {
                true => self.playing.shown,
                false => plot::Shown::default(),
            };
            // Too many frames to plot are reported elsewhere.
            let mut plot = std::mem::take(&mut self.playing.plot);
            let held = context.input(|input| input.pointer.any_down());
            let _ = plot.update(&self.document, shown, held, || self.obstacles());
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
        let (first, last) = playing.marks.range;
        playing.frame = playing.frame.map(|frame| frame.clamp(first, last));
        let held = matches!(playing.speeds.held, graph::Held::Key(_));
        let stays = held || self.document.edited_scene().is_some();
        if !(stays && self.document.in_step()) {
            playing.axis = playing.marks.range;
        }
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
        let (first, last) = self.played();
        let playing = &mut self.playing;
        let loops = playing.loops && last > first;
        if loops {
            // The last frame is seen as long as the others.
            gone = (from - first + gone).rem_euclid(last - first + 1.0) - (from - first);
        }
        let frame = (from + gone).floor().max(first).min(last);
        playing.frame = Some(frame);
        playing.follow(true);
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

pub(super) fn show(editor: &mut Editor, ui: &mut Ui) {
    editor.playing.low = ui.ctx().content_rect().height() < MIN_HEIGHT_FOR_GRAPH;
    editor.advance(ui.ctx());
    editor.keep_between();
    let context = ui.ctx().clone();
    editor.part_of(
        &context,
        |editor| &mut editor.playing.speeds,
        |editor, speeds, actions| bar(editor, speeds, ui, actions),
    );
}

fn bar(editor: &Editor, memory: &mut graph::Memory, ui: &mut Ui, actions: &mut Vec<Action>) {
    let palette = theme::palette(ui);
    let whole = ui.ctx().content_rect();
    let frame = egui::Frame::new()
        .fill(palette.panel)
        .inner_margin(egui::Margin::symmetric(MARGIN as i8, 0));
    let graph = match editor.shows_speed_graph() {
        true => graph_height(editor, whole.height()),
        false => 0.0,
    };
    // A scene can have markers: their row is there before the first of them.
    let markers = match editor.document.edited_scene() {
        Some(_) => markers::HEIGHT,
        None => 0.0,
    };
    let nodes = track_rows::rows(editor, &memory.tracks);
    let count = nodes.len();
    // Where no path is edited, keys of nodes have the room of its keys and its graph.
    let of_path = count == 0 || editor.document.edits_path();
    let tracks = match memory.tracks.curves && count > 0 {
        true => curves_height(editor, whole.height(), graph > 0.0),
        // The bar stays where it is when the first key is made.
        false if !of_path && graph > 0.0 => 0.0,
        false => tracks_height(editor, count, whole.height(), graph > 0.0),
    };
    let height =
        TRANSPORT + ruler::HEIGHT + markers + key_row::HEIGHT + tracks + graph + theme::GAP;
    let (of_nodes, below) = match of_path {
        true => (tracks, graph),
        false => (key_row::HEIGHT + tracks + graph, 0.0),
    };
    let panel = egui::Panel::bottom("playing")
        .resizable(false)
        .exact_size(height)
        .frame(frame);
    panel.show(ui, |ui| {
        let mut rest = ui.max_rect();
        let edge = rest.expand2(egui::vec2(MARGIN, 0.0));
        let mut row = |height: f32| {
            let (row, below) = rest.split_top_bottom_at_y(rest.top() + height);
            rest = below;
            row
        };
        let top = UiBuilder::new().max_rect(row(TRANSPORT));
        ui.scope_builder(top, |ui| fields::show(editor, ui, actions));
        let captions = match windows::sub_window::is_cramped(ui.ctx()) {
            true => CAPTIONS.1,
            false => CAPTIONS.0,
        };
        let parts = |row: Rect| {
            let (left, right) = row.split_left_right_at_x(row.left() + captions);
            (left.with_max_x(left.right() - theme::GAP), right)
        };
        let (left, right) = parts(row(ruler::HEIGHT));
        let begin = right.left() + END;
        // A window may be one pixel wide.
        let rail = Rangef::new(begin, (right.right() - END).max(begin + 1.0));
        let axis = Axis::new(rail, editor.playing.axis, editor.playing.seen);
        let time = Rect::from_min_max(right.min, pos2(right.right(), edge.bottom()));
        zoom::by_keys(editor, ui, &axis, actions);
        ruler::unit(editor, ui, left.shrink2(egui::vec2(0.0, 1.0)), actions);
        ruler::show(editor, ui, right, &axis, actions);
        let above = right.top();
        if markers > 0.0 {
            let (_, right) = parts(row(markers));
            let place = (right, above);
            markers::show(editor, &mut memory.markers, ui, place, &axis, actions);
        }
        if of_path {
            let (left, right) = parts(row(key_row::HEIGHT));
            ruler::caption(ui, left, editor.texts().timeline.keys);
            key_row::show(editor, memory, ui, (right, above), &axis, actions);
        }
        let rows = row(of_nodes);
        #[allow(clippy::cast_precision_loss)]
        let scrolls = !memory.tracks.curves && of_nodes < track_rows::ROW * count as f32;
        zoom::by_mouse(ui, time, scrolls.then_some(rows), &axis, actions);
        if count > 0 {
            let place = (rows, captions, above);
            let shown = (&nodes[..], &axis);
            tracks::show(editor, &mut memory.tracks, ui, place, shown, actions);
        }
        if below > 0.0 {
            let (left, right) = parts(row(below));
            let places = (right.with_min_y(right.top() + theme::GAP), left);
            graph::show(editor, memory, ui, places, &axis, actions);
        }
        if graph > 0.0 {
            dragged_edge(editor, ui, edge, graph, actions);
        } else if count > 0 {
            dragged_edge(editor, ui, edge, tracks, actions);
        }
    });
}

/// A higher window has more room for the graph; dragged it is as high as it was made.
fn graph_height(editor: &Editor, whole: f32) -> f32 {
    let usual = ((whole - 580.0) * 0.45).clamp(56.0, 160.0);
    let most = (0.45 * whole).max(graph::LEAST);
    let height = editor.playing.graph_height.unwrap_or(usual);
    height.clamp(graph::LEAST, most).round()
}

/// As high as its rows, but they leave room for the rest; without a graph as high as it was dragged.
#[allow(clippy::cast_precision_loss)]
fn tracks_height(editor: &Editor, rows: usize, whole: f32, graph: bool) -> f32 {
    let dragged = editor.playing.graph_height.filter(|_| !graph);
    let most = dragged.map_or(0.2 * whole, |height| height.min(0.45 * whole));
    let most = most.max(2.0 * track_rows::ROW);
    (track_rows::ROW * rows as f32).min(most).round()
}

/// The same of their curves, which have room at the least.
fn curves_height(editor: &Editor, whole: f32, graph: bool) -> f32 {
    let dragged = editor.playing.graph_height.filter(|_| !graph);
    let height = dragged.unwrap_or(0.2 * whole);
    height.clamp(96.0, (0.45 * whole).max(96.0)).round()
}

/// The upper edge, by which the graph is made higher.
fn dragged_edge(editor: &Editor, ui: &Ui, rect: Rect, height: f32, actions: &mut Vec<Action>) {
    let place = rect.with_max_y(rect.top() + EDGE);
    let response = ui.interact(place, Id::unique("height of the graph"), Sense::DRAG);
    let texts = &editor.texts().timeline;
    response.widget_info(|| egui::WidgetInfo::slider(true, f64::from(height), texts.height));
    let lively = response.hovered() || response.dragged();
    if lively {
        ui.set_cursor_icon(CursorIcon::ResizeVertical);
    }
    if let (true, Some(pointer)) = (response.dragged(), response.interact_pointer_pos()) {
        let by = rect.top() + EDGE / 2.0 - pointer.y;
        actions.push(Action::Time(TimeAction::GraphHeight(height + by)));
    }
    let palette = theme::palette(ui);
    let colour = if lively { palette.focus } else { palette.line };
    let line = egui::Stroke::new(1.0, colour);
    ui.ctx()
        .layer_painter(ui.layer_id())
        .hline(rect.x_range(), rect.top() + 0.5, line);
}

#[cfg(test)]
mod tests;
#[cfg(test)]
mod track_menu_tests;
