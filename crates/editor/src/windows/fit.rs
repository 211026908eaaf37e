//! What the window of the tool that fits recorded poses shows below its fields: how far the path is
//! from them in words and over time, what was found in them, and what would need fewer points.

use egui::{Button, Rect, Role, Sense, Shape, Stroke, Ui, WidgetInfo, pos2, vec2};
use vides_document::tool::FitResult;
use vides_engine::tools::fit::{Deviation, PoseDeviation, Report, TimeUnit, Tolerance};

use crate::action::{Action, TimeAction};
use crate::entry::Entry;
use crate::state::Editor;
use crate::state::windows::FitShown;
use crate::texts::{Language, fill};
use crate::theme;

/// Height of a graph, in points.
const GRAPH: f32 = 52.0;

/// The most places of a graph; each shows the greatest deviation of its poses.
const PLACES: usize = 400;

/// Room above the greatest of deviation and tolerance, as a share of it.
const HEADROOM: f64 = 0.15;

/// Fields of view that differ by less than so many degrees are not reported.
const SAME_LENS: f64 = 5e-4;

/// What a button above the graphs was pressed for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Offer {
    Tolerance(Tolerance),
    Robust,
}

/// One of the graphs.
struct Curve<'a> {
    name: &'a str,
    of: fn(&PoseDeviation) -> f64,
    tolerance: f64,
}

/// Length and angle of a tolerance.
fn of_tolerance(language: Language, tolerance: Tolerance) -> String {
    let [position, angle] = [tolerance.position, tolerance.angle].map(|at| short(language, at));
    format!("{position} · {angle}°")
}

/// A number with two digits that count, as the panel is narrow; whole digits are kept.
fn short(language: Language, value: f64) -> String {
    if value == 0.0 {
        return language.number(0.0, 0);
    }
    let size = value.abs().log10().floor();
    if !(-5.0..6.0).contains(&size) {
        return language.power(value, 1);
    }
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    language.number(value, (1.0 - size).max(0.0) as usize)
}

impl FitShown {
    /// Shows a path that begins `later` frames after the film.
    pub(super) fn new(made: FitResult, later: f64) -> Self {
        let all = made.deviations;
        let each = all.len().div_ceil(PLACES).max(1);
        let places = all.chunks(each).map(|poses| {
            let start = PoseDeviation {
                position: 0.0,
                angle: 0.0,
                frame: poses[0].frame + later,
            };
            poses.iter().fold(start, |most, pose| PoseDeviation {
                frame: most.frame,
                position: most.position.max(pose.position),
                angle: most.angle.max(pose.angle),
            })
        });
        Self {
            tolerance: made.tolerance,
            places: places.collect(),
            report: made.report,
            left_out: made.left_out,
        }
    }

    /// Shows it; returns what a button was pressed for.
    pub(super) fn show(
        &self,
        editor: &Editor,
        ui: &mut Ui,
        actions: &mut Vec<Action>,
    ) -> Option<Offer> {
        let (texts, language) = (&editor.texts().fit, editor.language());
        let report = &self.report;
        let of = |text, off: Deviation| {
            let [most, rms] = [off.greatest, off.rms].map(|off| short(language, off));
            fill(text, &[&most, &rms])
        };
        ui.add_space(theme::GAP);
        // In sight in a low window, too.
        let taken = self.offer(editor, ui);
        ui.label(of(texts.position, report.position));
        let curve = Curve {
            name: texts.position_graph,
            of: |place| place.position,
            tolerance: self.tolerance.position,
        };
        self.graph(editor, ui, &curve, actions);
        ui.label(of(texts.view, report.view));
        if report.lens.greatest >= SAME_LENS {
            ui.label(of(texts.lens, report.lens));
        }
        let curve = Curve {
            name: texts.view_graph,
            of: |place| place.angle,
            tolerance: self.tolerance.angle,
        };
        self.graph(editor, ui, &curve, actions);
        let noise = short(language, report.noise);
        ui.label(fill(texts.recording, &[&report.poses, &noise]));
        let fps = short(language, report.fps);
        ui.label(fill(texts.rate, &[&fps]));
        let found = found(editor, report);
        if !found.is_empty() {
            ui.label(fill(texts.found, &[&found]));
        }
        taken
    }

    fn offer(&self, editor: &Editor, ui: &mut Ui) -> Option<Offer> {
        let (texts, language) = (&editor.texts().fit, editor.language());
        let mut taken = None;
        let size = vec2(ui.available_width(), theme::ROW);
        if let Some((tolerance, points)) = self.report.better {
            let words = fill(texts.better, &[&of_tolerance(language, tolerance), &points]);
            let button = ui.add(Button::new(words).min_size(size));
            if button.on_hover_text(texts.better_hint).clicked() {
                taken = Some(Offer::Tolerance(tolerance));
            }
        }
        if let Some((outliers, points)) = self.report.robust {
            let button = Button::new(fill(texts.robust, &[&points])).min_size(size);
            let hint = fill(texts.robust_hint, &[&outliers]);
            if ui.add(button).on_hover_text(hint).clicked() {
                taken = Some(Offer::Robust);
            }
        }
        taken
    }

    /// A deviation over the frames, the tolerance as a line, and the playhead.
    fn graph(&self, editor: &Editor, ui: &mut Ui, curve: &Curve<'_>, actions: &mut Vec<Action>) {
        let Curve {
            name,
            of,
            tolerance,
        } = *curve;
        let size = vec2(ui.available_width(), GRAPH);
        let (rect, response) = ui.allocate_exact_size(size, Sense::click_and_drag());
        response.widget_info(|| WidgetInfo::labeled(Role::Image, true, name));
        let palette = theme::palette(ui);
        let painter = ui.painter_at(rect);
        painter.rect_filled(rect, 3.0, palette.field);
        let (Some(first), Some(last)) = (self.places.first(), self.places.last()) else {
            return;
        };
        let (first, last) = (first.frame, last.frame.max(first.frame + 1.0));
        let most = self.places.iter().map(of).fold(tolerance, f64::max) * (1.0 + HEADROOM);
        let inner: Rect = rect.shrink(4.0);
        #[allow(clippy::cast_possible_truncation)]
        let x = |frame: f64| {
            let share = ((frame - first) / (last - first)).clamp(0.0, 1.0);
            inner.left() + inner.width() * share as f32
        };
        #[allow(clippy::cast_possible_truncation)]
        let y = |off: f64| inner.bottom() - inner.height() * (off / most) as f32;
        let line = self
            .places
            .iter()
            .map(|place| pos2(x(place.frame), y(of(place))));
        painter.add(Shape::line(
            line.collect(),
            Stroke::new(1.4, palette.accent),
        ));
        let bound = [
            pos2(inner.left(), y(tolerance)),
            pos2(inner.right(), y(tolerance)),
        ];
        let bound = Shape::dashed_line(&bound, Stroke::new(1.0, palette.error), 4.0, 3.0);
        painter.extend(bound);
        if let Ok(frame) = editor.previewed_frame() {
            let now = x(frame);
            painter.vline(now, rect.y_range(), Stroke::new(1.0, palette.text));
        }
        if let Some(at) = response.interact_pointer_pos() {
            let share = ((at.x - inner.left()) / inner.width()).clamp(0.0, 1.0);
            let frame = (first + f64::from(share) * (last - first)).round();
            let told = frame - 1.0 + f64::from(editor.document.info().first_frame);
            actions.push(Action::Time(TimeAction::Playhead(Entry::Set(told))));
        }
        response.on_hover_text(format!("{name}\n{}", editor.texts().fit.go_there));
    }
}

/// What was found in a recording, in words.
fn found(editor: &Editor, report: &Report) -> String {
    let texts = &editor.texts().fit;
    let counts = [
        (report.holds, texts.hold, texts.holds),
        (report.gaps, texts.gap, texts.gaps),
        (report.cuts, texts.cut, texts.cuts),
        (report.outliers, texts.outlier, texts.outliers),
        (report.dropped, texts.repeated, texts.repeated_times),
    ];
    let words = counts.into_iter().filter(|(count, ..)| *count > 0);
    let words =
        words.map(|(count, one, several)| fill(if count == 1 { one } else { several }, &[&count]));
    let unit = report.unit.map(|unit| match unit {
        TimeUnit::Microseconds => texts.microseconds,
        TimeUnit::Nanoseconds => texts.nanoseconds,
    });
    let unit = unit.map(|unit| fill(texts.times_in, &[&unit]));
    words.chain(unit).collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
#[path = "fit_tests.rs"]
mod tests;
