//! The ruler of the timeline: seconds or frames in steps of 1, 2 and 5, the playhead, what the
//! check has found.

use egui::{
    Align2, Button, CursorIcon, EventFilter, FontId, Key, Modifiers, Painter, Rect, Response, Role,
    Sense, Shape, Stroke, Ui, WidgetInfo, pos2, vec2,
};

use super::axis::{Axis, step};
use super::markers;
use crate::action::{Action, TimeAction};
use crate::entry::Entry;
use crate::setup::Element;
use crate::state::Editor;
use crate::state::playing::{Mark, Retiming};
use crate::state::selected::SelectionChange;
use crate::theme;

pub(super) const HEIGHT: f32 = 25.0;

/// A press this near to a mark, in points, means the mark.
const SNAP: f64 = 6.0;

/// Least distances between labels and between small lines, in points.
const ROOM: f64 = 36.0;
const APART: f64 = 5.0;

/// Shows it in `rect`; its rail runs along `axis`.
pub(super) fn show(
    editor: &Editor,
    ui: &mut Ui,
    rect: Rect,
    axis: &Axis,
    actions: &mut Vec<Action>,
) {
    let texts = &editor.texts().space;
    let response = ui.interact(rect, id(), Sense::click_and_drag());
    let (name, at) = (texts.timeline, editor.position_on_bar());
    response.widget_info(|| WidgetInfo::slider(true, at, name));
    if editor.playing.marks.frames > 0 {
        scrub_by_mouse(editor, ui, &response, axis, actions);
        scrub_by_keys(editor, ui, &response, axis, actions);
        markers::make(editor, &response, axis, actions);
    }
    if response.hovered() || response.dragged() {
        ui.set_cursor_icon(CursorIcon::PointingHand);
    }
    let painter = ui.painter_at(rect);
    steps(editor, &painter, axis, rect);
    let found = findings(editor, ui, &painter, axis, rect);
    rail(editor, ui, &painter, axis, rect, response.has_focus());
    let tip = match found {
        Some(words) => words,
        None => texts.timeline_tip.to_owned(),
    };
    response.on_hover_text(tip);
}

/// The ruler's widget for the keyboard focus.
pub(super) fn id() -> egui::Id {
    egui::Id::unique("ruler of time")
}

/// Where the rail of the playhead runs.
fn rail_of(axis: &Axis, rect: Rect) -> Rect {
    let middle = rect.bottom() - 7.0;
    Rect::from_x_y_ranges(axis.rail, middle - 2.0..=middle + 2.0)
}

fn to_frame(frame: f64) -> Action {
    Action::Time(TimeAction::Playhead(Entry::Set(frame)))
}

/// Takes the playhead to where the mouse is held.
pub(super) fn scrub_by_mouse(
    editor: &Editor,
    ui: &Ui,
    response: &Response,
    axis: &Axis,
    actions: &mut Vec<Action>,
) {
    // A click may come with its press and its release in one pass.
    let holds = response.is_pointer_button_down_on() && !middle_down(ui);
    if !(holds || response.clicked()) {
        return;
    }
    response.request_focus();
    if let Some(pointer) = response.interact_pointer_pos() {
        let frame = axis.frame(pointer.x).round();
        let start = editor.document.start_frame();
        let pressed = ui.input(|input| input.pointer.any_pressed()) || response.clicked();
        let reach = if pressed { SNAP } else { 1.0 };
        let span = 1.0 / axis.frames_per_point();
        let of_scene = |mark: &Mark| start + (mark.first() - 1.0);
        let away = |mark: &Mark| (of_scene(mark) - frame).abs() * span;
        let marks = editor.playing.marks.keys.iter();
        let nearest = marks.min_by(|a, b| away(a).total_cmp(&away(b)));
        let snapped = nearest.filter(|mark| away(mark) <= reach);
        let mut markers = editor.playing.marks.markers_there();
        let marker = markers.find(|(at, _)| (at - frame).abs() * span <= reach);
        // As in the space and in the list: one more, or all up to here.
        let held = ui.input(|input| input.modifiers);
        if held.ctrl || held.shift {
            let choice = snapped.filter(|_| response.clicked());
            actions.extend(choice.map(|mark| chosen_too(mark.point, held)));
            return;
        }
        let marker = marker.map_or(frame, |(at, _)| *at);
        actions.push(to_frame(snapped.map_or(marker, of_scene)));
        ui.ctx().request_repaint();
    }
}

/// The middle button moves the axis and nothing on it.
fn middle_down(ui: &Ui) -> bool {
    ui.input(|input| input.pointer.middle_down())
}

/// What a click with Ctrl or Shift means.
pub(super) fn chosen_too(point: usize, held: Modifiers) -> Action {
    Action::Choose(match held.ctrl {
        true => SelectionChange::Switch(point),
        false => SelectionChange::UpTo(point),
    })
}

fn scrub_by_keys(
    editor: &Editor,
    ui: &Ui,
    response: &Response,
    axis: &Axis,
    actions: &mut Vec<Action>,
) {
    if !response.has_focus() {
        return;
    }
    let filter = EventFilter {
        horizontal_arrows: true,
        ..EventFilter::default()
    };
    ui.memory_mut(|memory| memory.set_focus_lock_filter(response.id, filter));
    let (step, moved, end, plays) = ui.input_mut(|input| {
        let mut both = |modifiers| {
            // With Shift and Ctrl first: without modifiers egui would take these, too.
            let mut count = |key| input.count_and_consume_key(modifiers, key) as f64;
            count(Key::ArrowRight) - count(Key::ArrowLeft)
        };
        let far = both(Modifiers::CTRL | Modifiers::SHIFT);
        let near = both(Modifiers::CTRL);
        let ten = both(Modifiers::SHIFT);
        let one = both(Modifiers::NONE);
        let first = input.consume_key(Modifiers::NONE, Key::Home);
        let last = input.consume_key(Modifiers::NONE, Key::End);
        let plays = input.consume_key(Modifiers::NONE, Key::Space);
        let moved = near + 10.0 * far;
        (one + 10.0 * ten, moved, (first, last), plays)
    });
    #[allow(clippy::cast_possible_truncation)]
    move_current(editor, moved as i64, actions);
    if step != 0.0 {
        let at = editor.position_on_bar().round();
        actions.push(to_frame(at + step));
    }
    match end {
        (true, _) if !axis.shows_all() => actions.push(Action::Time(TimeAction::See(None))),
        (true, _) => actions.push(to_frame(editor.playing.marks.range.0)),
        (_, true) => actions.push(to_frame(editor.playing.marks.range.1)),
        _ => {}
    }
    if plays {
        actions.push(Action::Time(TimeAction::PlayOrPause));
    }
}

/// Moves the current key by so many frames, as far as it can go.
fn move_current(editor: &Editor, by: i64, actions: &mut Vec<Action>) {
    let playing = &editor.playing;
    let Some(mark) = playing.marks.of(editor.document.selection()) else {
        return;
    };
    let beside = playing.marks.beside(mark.frame);
    let moved = playing.marks.moved(beside, by, playing.moves_along);
    if moved != Retiming::Nothing {
        let moved = Action::Time(TimeAction::Retime(moved));
        actions.extend([
            Action::Enter(Entry::Begin),
            moved,
            Action::Enter(Entry::End),
        ]);
    }
}

/// The lines and numbers, as many as have room.
fn steps(editor: &Editor, painter: &Painter, axis: &Axis, rect: Rect) {
    let palette = theme::palette_of(&painter.ctx().global_style().visuals);
    let info = editor.document.info();
    let (in_frames, first) = (editor.setup.ruler_frames, f64::from(info.first_frame));
    // What is counted: its number at the first frame, and how many a frame are.
    let (begin, each) = match in_frames {
        true => (first, 1.0),
        false => (0.0, 1.0 / info.fps),
    };
    let (from, whole) = (
        begin + (axis.first() - 1.0) * each,
        (axis.last() - axis.first()) * each,
    );
    let per_point = axis.frames_per_point() * each;
    let digits = (from + whole).abs().max(1.0).log10().floor() + 1.0;
    let least = per_point * (ROOM + 7.0 * digits.clamp(0.0, 12.0));
    let least = if in_frames { least.max(1.0) } else { least };
    let (wide, parts) = step(least);
    let decimals = if in_frames {
        0
    } else {
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
        let decimals = (-wide.log10()).ceil().clamp(0.0, 6.0) as usize;
        decimals
    };
    let x_of = |value: f64| axis.x_of(1.0 + (value - begin) / each);
    let parts = if wide / f64::from(parts) / per_point < APART {
        1
    } else {
        parts
    };
    let small = wide / f64::from(parts);
    let line = |x: f32, height: f32, color| {
        let foot = rect.bottom() - 10.0;
        painter.vline(x, foot - height..=foot, Stroke::new(1.0, color));
    };
    let mut free = f32::NEG_INFINITY;
    // Few enough, since each has room; the bound is for numbers out of the ordinary.
    for at in 0..4096_u32 {
        let value = small * ((from / small).ceil() + f64::from(at));
        if value > from + whole * (1.0 + 1e-9) {
            break;
        }
        let x = x_of(value);
        let number = (value / wide).round();
        if (value / wide - number).abs() > 1e-6 {
            line(x, 3.0, palette.line);
            continue;
        }
        line(x, 5.0, palette.edge);
        let unit = if in_frames { "" } else { " s" };
        let text = editor.language().number(wide * number, decimals) + unit;
        let galley = painter.layout_no_wrap(text, FontId::proportional(11.0), palette.weak);
        let size = galley.size();
        let most = (rect.right() - size.x).max(rect.left());
        let left = (x - size.x / 2.0).clamp(rect.left(), most);
        if left > free && (left - (x - size.x / 2.0)).abs() < 12.0 {
            free = left + size.x + 4.0;
            painter.galley(pos2(left, rect.top() - 1.0), galley, palette.weak);
        }
    }
}

/// Marks what the open check has found; describes what is under the pointer.
fn findings(
    editor: &Editor,
    ui: &Ui,
    painter: &Painter,
    axis: &Axis,
    rect: Rect,
) -> Option<String> {
    let window = editor.windows.check.as_ref()?;
    let colour = theme::palette(ui).error;
    let pointer = ui.input(|input| input.pointer.hover_pos());
    let pointer = pointer.filter(|at| rect.contains(*at));
    let axis = editor.axis_of_path(axis);
    let mut words = None;
    for finding in window.found() {
        let [from, to] = [finding.first_frame, finding.last_frame].map(|frame| axis.x_of(frame));
        let place = Rect::from_x_y_ranges(
            from - 1.0..=to.max(from) + 1.0,
            // Below the numbers.
            rect.bottom() - 16.0..=rect.bottom() - 10.0,
        );
        painter.rect_filled(place, 1.0, colour.gamma_multiply(0.5));
        let tip = pos2(from, rect.bottom() - 10.0);
        let sign = [tip, tip + vec2(3.5, -6.0), tip + vec2(-3.5, -6.0)];
        painter.add(Shape::convex_polygon(sign.to_vec(), colour, Stroke::NONE));
        let under = |at: egui::Pos2| place.x_range().expand(4.0).contains(at.x);
        if words.is_none() && pointer.is_some_and(under) {
            words = Some(editor.language().finding(finding).0.to_string());
        }
    }
    words
}

/// The rail with what is done, and the playhead.
fn rail(editor: &Editor, ui: &Ui, painter: &Painter, axis: &Axis, rect: Rect, focus: bool) {
    let palette = theme::palette(ui);
    let rail = rail_of(axis, rect);
    let at = axis.x_of(editor.position_on_bar());
    painter.rect_filled(rail, 2.0, palette.edge);
    let end = at.clamp(rail.left(), rail.right());
    let done = Rect::from_min_max(rail.min, pos2(end, rail.bottom()));
    painter.rect_filled(done, 2.0, palette.accent);
    if let Some(part) = axis.part() {
        let rows = rect.bottom() - 2.0..=rect.bottom();
        let all = Rect::from_x_y_ranges(axis.rail, rows.clone());
        painter.rect_filled(all, 1.0, palette.line);
        let seen = Rect::from_x_y_ranges(part.min..=part.max.max(part.min + 3.0), rows);
        painter.rect_filled(seen, 1.0, palette.weak);
    }
    if !axis.sees(at) {
        return;
    }
    let color = colour_of_playhead(editor, ui);
    let handle = pos2(at, rail.center().y);
    painter.circle(handle, 6.0, color, Stroke::new(2.0, palette.panel));
    if focus {
        painter.circle_stroke(handle, 6.5, Stroke::new(1.5, palette.focus));
    }
}

/// It stands at a key, or elsewhere.
pub(super) fn colour_of_playhead(editor: &Editor, ui: &Ui) -> egui::Color32 {
    match editor.playing.frame {
        Some(_) => editor.setup.colours().of(Element::Player),
        None => theme::palette(ui).accent,
    }
}

/// The button that changes between seconds and frames.
pub(super) fn unit(editor: &Editor, ui: &mut Ui, room: Rect, actions: &mut Vec<Action>) {
    let texts = &editor.texts().timeline;
    let frames = editor.setup.ruler_frames;
    let words = if frames { texts.frames } else { texts.seconds };
    let button = Button::new(egui::RichText::new(words).font(theme::small()));
    let response = ui.put(room, button);
    response.widget_info(|| WidgetInfo {
        current_text_value: Some(words.to_owned()),
        ..WidgetInfo::labeled(Role::Button, true, texts.unit)
    });
    if response.on_hover_text(texts.unit_tip).clicked() {
        actions.push(Action::Time(TimeAction::RulerInFrames(!frames)));
    }
}

/// A word at the left of a row.
pub(super) fn caption(ui: &Ui, room: Rect, words: &str) {
    let color = theme::palette(ui).weak;
    let painter = ui.painter_at(room);
    let place = room.left_center();
    painter.text(place, Align2::LEFT_CENTER, words, theme::small(), color);
}
