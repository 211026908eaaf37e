//! The speed curve of the current section, small (thesis A.4.3), with its frames and seconds.

use egui::{
    Align2, CornerRadius, Pos2, Rect, RectAlign, Response, Sense, Shape, Stroke, Tooltip, Ui,
    WidgetInfo, pos2, vec2,
};

use super::{PanelButton, button_row, heading};
use crate::action::Action;
use crate::limits::{BASE_SPEED, MAX_SPEED, MIN_SPEED, SPEEDS};
use crate::path::speed_curve::INTERVALS;
use crate::path::{Change, Section, Timing};
use crate::state::Editor;
use crate::texts::fill;
use crate::theme;
use crate::windows::goes_by_ten;

/// Height of what lies below this panel's beginning, but for the picture.
const BELOW: f32 = 118.0;
/// The picture's least and greatest height.
const HEIGHTS: (f32, f32) = (36.0, 112.0);

pub(super) fn show(editor: &Editor, ui: &mut Ui, height: f32, actions: &mut Vec<Action>) {
    let texts = &editor.texts().speed;
    let (timing, section) = current(editor);
    let above = ui.cursor().top() - ui.min_rect().top();
    let words = section.map_or_else(|| texts.end.to_owned(), |section| frames(editor, section));
    heading(ui, texts.heading, &words);
    let height = (height - above - BELOW).clamp(HEIGHTS.0, HEIGHTS.1);
    let current = editor.orientation();
    let speeds = current
        .filter(|current| goes_by_ten(&current.own.pace))
        .map(|current| current.speeds);
    let (rect, response) =
        ui.allocate_exact_size(vec2(ui.available_width(), height.floor()), Sense::click());
    paint(ui, rect, &response, timing.as_ref(), speeds.as_ref());
    if let Some(section) = section {
        let (place, align) = if timing.as_ref().is_some_and(begins_low) {
            (rect.left_top() + vec2(6.0, 4.0), Align2::LEFT_TOP)
        } else {
            (rect.left_bottom() + vec2(6.0, -4.0), Align2::LEFT_BOTTOM)
        };
        let color = theme::palette(ui).weak;
        let words = ends(editor, section);
        ui.painter()
            .text(place, align, words, theme::small(), color);
    }
    response.widget_info(|| WidgetInfo::labeled(egui::Role::Button, true, texts.picture));
    // Beside it: below lies its button.
    let mut hint = Tooltip::for_enabled(&response);
    hint.popup = hint.popup.align(RectAlign::LEFT_START);
    hint.show(|ui| ui.label(texts.picture_hint));
    if response.clicked() {
        actions.push(Action::SpeedCurve);
    }
    let change = PanelButton::new(texts.change, texts.change_hint, Action::SpeedCurve);
    button_row(editor, ui, &[change], actions);
}

/// Whether there is more room above the first speeds than below them.
fn begins_low(timing: &Timing) -> bool {
    let first = (0..=SPEEDS / 3).map(|at| timing.speed(at as f64 / INTERVALS as f64));
    let (lowest, highest) = first.fold((MAX_SPEED, MIN_SPEED), |(low, high), speed| {
        (speed.min(low), speed.max(high))
    });
    MAX_SPEED - highest > lowest - MIN_SPEED
}

/// The pace of the current orientation, and its section; an open path's last one begins none.
fn current(editor: &Editor) -> (Option<Timing>, Option<Section>) {
    let selection = editor.document.selection();
    let path = editor.document.path();
    let found = editor.document.timeline(|timeline| {
        let section = timeline.section_from(selection.point, selection.orientation)?;
        let timing = timeline.timing(path, section).ok()?;
        Some((timing, timeline.section(section)))
    });
    match found {
        Ok(Some((timing, section))) => (Some(timing), Some(section)),
        _ => {
            let orientation = editor.orientation();
            let timing = orientation.and_then(|new| Timing::new(new, None, None).ok());
            (timing, None)
        }
    }
}

/// The ends of a section: points, with the orientation where a point has several.
fn ends(editor: &Editor, section: Section) -> String {
    let points = &editor.document.path().points;
    let here = points
        .get(section.point)
        .map_or(0, |point| point.orientations.len());
    let (to, orientation) = if section.orientation + 1 < here {
        (section.point, section.orientation + 1)
    } else {
        ((section.point + 1) % points.len().max(1), 0)
    };
    let from = editor.name_of(section.point, section.orientation);
    let to = editor.name_of(to, orientation);
    fill(editor.texts().speed.section, &[&from, &to])
}

/// Frames and seconds of a section.
fn frames(editor: &Editor, section: Section) -> String {
    let texts = &editor.texts().speed;
    if section.change == Change::Nothing {
        return texts.no_frames.to_owned();
    }
    let fps = editor.document.info().fps;
    let seconds = editor.language().number(section.frames as f64 / fps, 2);
    let text = if section.frames == 1 {
        texts.one_frame
    } else {
        texts.frames
    };
    fill(text, &[&section.frames, &seconds])
}

fn paint(
    ui: &Ui,
    rect: Rect,
    response: &Response,
    timing: Option<&Timing>,
    speeds: Option<&[f64; SPEEDS]>,
) {
    let palette = theme::palette(ui);
    let border = if response.hovered() {
        palette.accent
    } else {
        palette.edge
    };
    let painter = ui.painter().with_clip_rect(rect);
    painter.rect(
        rect,
        CornerRadius::same(4),
        palette.field,
        Stroke::new(1.0, border),
        egui::StrokeKind::Inside,
    );
    let inner = rect.shrink2(vec2(6.0, 6.0));
    #[allow(clippy::cast_possible_truncation)]
    let place = |u: f64, speed: f64| -> Pos2 {
        let share = (speed - MIN_SPEED) / (MAX_SPEED - MIN_SPEED);
        pos2(
            egui::lerp(inner.x_range(), u as f32),
            egui::lerp(inner.bottom()..=inner.top(), share as f32),
        )
    };
    let (left, right) = (place(0.0, BASE_SPEED), place(1.0, BASE_SPEED));
    painter.line_segment([left, right], Stroke::new(1.0, palette.line));
    if let Some(timing) = timing {
        let pieces = INTERVALS * 8;
        let line = (0..=pieces).map(|piece| {
            let u = piece as f64 / pieces as f64;
            place(u, timing.speed(u).min(MAX_SPEED))
        });
        painter.add(Shape::line(
            line.collect(),
            Stroke::new(1.5, palette.accent),
        ));
    }
    for (index, &speed) in speeds.into_iter().flatten().enumerate() {
        let square = Rect::from_center_size(
            place(index as f64 / INTERVALS as f64, speed),
            vec2(5.0, 5.0),
        );
        painter.rect_filled(square, CornerRadius::ZERO, palette.accent);
    }
}
