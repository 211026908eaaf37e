//! What the graph shows beside the pace, from the poses as `vides plot` has them: its menu, its
//! scale, the limits of the check, and what the check has found.

use std::sync::Arc;

use egui::{
    Align2, Button, Color32, Painter, Popup, PopupCloseBehavior, Pos2, Rect, RichText, Shape,
    Stroke, Ui, pos2, vec2,
};
use vides_document::Document;
use vides_document::error::Result;
use vides_engine::tools::check::{FindingKind, OFF};
use vides_engine::tools::clearance::Clearance;
use vides_engine::tools::profile::{Film, Quantity, samples, with_peaks};

use super::axis::{Axis, step};
use crate::action::{Action, TimeAction};
use crate::state::Editor;
use crate::state::playing::graph::Scale;
pub(super) use crate::state::playing::plot::Shown;
use crate::state::playing::plot::{Curve, Plot};
use crate::texts::{Texts, fill};
use crate::theme::{self, Palette};

/// Most poses sampled; while something is held, [`VALUES`], which also bounds the values drawn: a
/// little more than there are columns.
const POSES: usize = 20_000;
const VALUES: usize = 1_000;

/// Height of the row with what is shown and its values.
pub(super) const WORDS: f32 = 15.0;

/// A limit beyond this multiple of the highest value is hidden: the curve would be flat.
const FAR: f64 = 2.5;

/// Least distance between two lines of the scale, in points.
const APART: f64 = 18.0;

/// Findings that are marked over the speeds of the sections.
const OF_SECTIONS: &[FindingKind] = &[
    FindingKind::SpeedJump,
    FindingKind::Cusp,
    FindingKind::Corner,
];

impl Default for Shown {
    fn default() -> Self {
        Self {
            pace: true,
            quantities: [false; Quantity::ALL.len()],
        }
    }
}

impl Shown {
    pub(super) fn has(&self, quantity: Option<Quantity>) -> bool {
        quantity.map_or(self.pace, |quantity| self.quantities[quantity as usize])
    }

    /// Shows it, or no longer; something is always shown.
    pub(super) fn switch(&mut self, quantity: Option<Quantity>) {
        let on = match quantity {
            None => &mut self.pace,
            Some(quantity) => &mut self.quantities[quantity as usize],
        };
        *on = !*on;
        if self.quantities == [false; Quantity::ALL.len()] {
            self.pace = true;
        }
    }

    /// What is shown beside the pace.
    fn quantities(&self) -> impl Iterator<Item = Quantity> + use<> {
        let shown = *self;
        let all = Quantity::ALL.into_iter();
        all.filter(move |&quantity| shown.has(Some(quantity)))
    }
}

impl Plot {
    pub(super) fn is_empty(&self) -> bool {
        self.curves.is_empty()
    }

    /// Brings the values up to date; `held`: something may be dragged.
    pub(super) fn update(
        &mut self,
        document: &Document,
        shown: Shown,
        held: bool,
        object: impl FnOnce() -> Result<Option<Arc<Clearance>>>,
    ) -> Result<()> {
        let most = if held { VALUES } else { POSES };
        let of = Some((document.revision(), shown, most));
        if self.of == of {
            return Ok(());
        }
        self.of = of;
        self.curves.clear();
        if shown.quantities().next().is_none() {
            return Ok(());
        }
        let object = match shown.has(Some(Quantity::Clearance)) {
            true => object()?,
            false => None,
        };
        let film = Film {
            samples: &samples(document.sampler()?, most)?,
            fps: document.info().fps,
            up: document.path().space.up,
            object: object.as_deref(),
        };
        for quantity in shown.quantities() {
            let values = with_peaks(quantity.of(&film)?, VALUES);
            self.curves.try_reserve(1)?;
            self.curves.push(Curve { quantity, values });
        }
        Ok(())
    }
}

impl Curve {
    /// The value at a frame, or at the nearest one that has a value.
    fn at(&self, frame: f64) -> Option<f64> {
        let next = self.values.partition_point(|&(at, _)| at < frame);
        let near = self.values[next.saturating_sub(1)..].iter().take(2);
        let away = |at: f64| (at - frame).abs();
        let nearest = near.min_by(|a, b| away(a.0).total_cmp(&away(b.0)))?;
        Some(nearest.1)
    }

    /// From the least to the greatest value that is drawn, zero and a near limit among them.
    fn range(&self, limit: Option<f64>) -> (f64, f64) {
        let all = self.values.iter().map(|&(_, value)| value);
        let finite = all.filter(|value| value.is_finite());
        let (low, high) = finite.fold((0.0_f64, 0.0_f64), |(a, b), v| (a.min(v), b.max(v)));
        let high = limit.map_or(high, |limit| high.max(1.04 * limit));
        (low, if high - low > 0.0 { high } else { low + 1.0 })
    }
}

/// The limit of the check for a quantity, in its unit, where it is on and not far off.
fn limit(document: &Document, curve: &Curve) -> Option<f64> {
    let kind = match curve.quantity {
        Quantity::Speed => FindingKind::Speed,
        Quantity::Acceleration => FindingKind::Acceleration,
        Quantity::Turning => FindingKind::Turning,
        Quantity::Clearance => FindingKind::Clearance,
        Quantity::Distance | Quantity::Roll | Quantity::Zoom => return None,
    };
    let limit = document.info().limits.get(kind);
    let unit = match kind {
        FindingKind::Turning => 1.0,
        _ => document.path().space.half_size,
    };
    let (_, high) = curve.range(None);
    let shown = limit != OFF && (unit * limit).is_finite() && unit * limit <= FAR * high;
    shown.then_some(unit * limit)
}

/// A quantity's colour, told apart from the others by the colour-blind, too: they differ in
/// lightness, and the curves in their dashes.
fn colour(palette: &Palette, quantity: Option<Quantity>) -> Color32 {
    let Some(quantity) = quantity else {
        return palette.accent;
    };
    let dark = palette.field.r() < 0x80;
    let [on_dark, on_light] = match quantity {
        Quantity::Distance => [0xf0_e442, 0x7a_6a00],
        Quantity::Speed => [0xff_9f1c, 0xa8_4b00],
        Quantity::Acceleration => [0xff_8fab, 0xb0_1f5a],
        Quantity::Turning => [0x2f_d0a0, 0x00_6b50],
        Quantity::Roll => [0xc7_9bff, 0x6a_38c0],
        Quantity::Zoom => [0xb8_c4d2, 0x48_5463],
        Quantity::Clearance => [0xff_ffff, 0x00_0000],
    };
    theme::rgb(if dark { on_dark } else { on_light })
}

/// Lengths of a curve's dashes and gaps; none: drawn through.
const fn dashes(quantity: Quantity) -> Option<(f32, f32)> {
    match quantity {
        Quantity::Distance | Quantity::Speed => None,
        Quantity::Acceleration => Some((6.0, 3.0)),
        Quantity::Turning => Some((2.0, 3.0)),
        Quantity::Roll => Some((10.0, 4.0)),
        Quantity::Zoom => Some((4.0, 6.0)),
        Quantity::Clearance => Some((12.0, 2.0)),
    }
}

/// All that can be shown, with its name: the pace first.
fn names(texts: &Texts) -> [(Option<Quantity>, &'static str); 8] {
    let texts = &texts.space;
    [
        (None, texts.speed_graph),
        (Some(Quantity::Distance), texts.plot_distance),
        (Some(Quantity::Speed), texts.plot_speed),
        (Some(Quantity::Acceleration), texts.plot_acceleration),
        (Some(Quantity::Turning), texts.plot_turning),
        (Some(Quantity::Roll), texts.plot_roll),
        (Some(Quantity::Zoom), texts.plot_zoom),
        (Some(Quantity::Clearance), texts.plot_clearance),
    ]
}

/// The button with the menu that chooses what is shown.
pub(super) fn choices(editor: &Editor, ui: &mut Ui, room: Rect, actions: &mut Vec<Action>) {
    let texts = &editor.texts().space;
    let shown = &editor.playing.shown;
    let palette = theme::palette(ui);
    let all = names(editor.texts());
    let chosen = all.iter().filter(|(quantity, _)| shown.has(*quantity));
    let chosen: Vec<&str> = chosen.map(|&(_, name)| name).collect();
    let words = match chosen.as_slice() {
        [one] => (*one).to_owned(),
        many => format!("{} · {}", texts.plot, many.len()),
    };
    let place = Rect::from_min_size(
        room.min + vec2(0.0, theme::GAP),
        vec2(room.width(), theme::ROW),
    );
    let response = ui.put(
        place,
        Button::new(RichText::new(words).font(theme::small())),
    );
    let at = |x: f32, y: f32| place.right_center() + vec2(x - 10.0, y + 1.0);
    let arrow = vec![at(-3.5, -2.0), at(0.0, 2.0), at(3.5, -2.0)];
    let color = ui.style().interact(&response).fg_stroke.color;
    ui.painter()
        .add(Shape::line(arrow, Stroke::new(1.5, color)));
    response.widget_info(|| egui::WidgetInfo {
        current_text_value: Some(chosen.join(", ")),
        ..egui::WidgetInfo::labeled(egui::Role::ComboBox, ui.is_enabled(), texts.plot)
    });
    let menu = Popup::menu(&response).close_behavior(PopupCloseBehavior::CloseOnClickOutside);
    menu.show(|ui| {
        for (quantity, name) in all {
            ui.horizontal(|ui| {
                let (sample, _) =
                    ui.allocate_exact_size(vec2(18.0, theme::ROW), egui::Sense::hover());
                let line = [sample.left_center(), sample.right_center()];
                draw(ui.painter(), &line, colour(palette, quantity), quantity);
                let mut on = shown.has(quantity);
                let tick = theme::tick(ui, &mut on, name);
                if tick.on_hover_text(told(editor.texts(), quantity)).clicked() {
                    actions.push(Action::Time(TimeAction::Plot(quantity)));
                }
            });
        }
    });
    response.on_hover_text(texts.plot_tip);
}

/// What the curve of a quantity tells; none stands for the speeds of the sections.
pub(super) fn told(texts: &Texts, quantity: Option<Quantity>) -> &'static str {
    let texts = &texts.space;
    match quantity {
        None => texts.speed_graph_tip,
        Some(Quantity::Distance) => texts.plot_distance_tip,
        Some(Quantity::Speed) => texts.plot_speed_tip,
        Some(Quantity::Acceleration) => texts.plot_acceleration_tip,
        Some(Quantity::Turning) => texts.plot_turning_tip,
        Some(Quantity::Roll) => texts.plot_roll_tip,
        Some(Quantity::Zoom) => texts.plot_zoom_tip,
        Some(Quantity::Clearance) => texts.plot_clearance_tip,
    }
}

/// Marks what the open check has found of what is shown.
pub(super) fn findings(editor: &Editor, painter: &Painter, scale: &Scale, ground: Rect) {
    let Some(window) = &editor.windows.check else {
        return;
    };
    let shown = &editor.playing.shown;
    let seen = |kind| {
        let in_pace = shown.pace && OF_SECTIONS.contains(&kind);
        in_pace
            || shown
                .quantities()
                .any(|quantity| quantity.findings().contains(&kind))
    };
    let colour = theme::palette_of(&painter.ctx().global_style().visuals).error;
    for finding in window.found().iter().filter(|found| seen(found.kind)) {
        let [from, to] = [finding.first_frame, finding.last_frame].map(|at| scale.axis.x_of(at));
        let place = Rect::from_x_y_ranges(from..=to.max(from + 2.0), ground.y_range());
        painter.rect_filled(place, 0.0, colour.gamma_multiply(0.25));
    }
}

/// The curves with their limits; the scale, if there is but one, at the left of them in `room`;
/// above them their names with the values at a frame, else at the playhead.
pub(super) fn paint(
    editor: &Editor,
    ui: &Ui,
    painter: &Painter,
    axis: &Axis,
    (ground, room, at): (Rect, Rect, Option<f64>),
) {
    let palette = theme::palette(ui);
    let curves = &editor.playing.plot.curves;
    if let Some(at) = at.filter(|_| !curves.is_empty()) {
        let line = Stroke::new(1.0, palette.weak.gamma_multiply(0.6));
        painter.vline(axis.x_of(at), ground.y_range(), line);
    }
    let at = at.unwrap_or_else(|| editor.frame_on_path(editor.position_on_bar()));
    let rows = (ground.top() + WORDS, ground.bottom() - 5.0);
    let scale = (curves.len() == 1 && !editor.playing.shown.pace).then_some(room);
    let (mut left, mut right) = (ground.left() + 8.0, ground.right() - 4.0);
    for curve in curves {
        let limit = limit(&editor.document, curve);
        let (low, high) = curve.range(limit);
        let per_unit = f64::from(rows.1 - rows.0) / (high - low);
        #[allow(clippy::cast_possible_truncation)]
        let y = |value: f64| rows.1 - ((value - low) * per_unit) as f32;
        if let Some(room) = scale {
            lines_of_scale(editor, ui, (ground, room), (low, high), curve, &y);
        }
        let colour = colour(palette, Some(curve.quantity));
        let values = curve.values.iter().filter(|(_, value)| value.is_finite());
        let line: Vec<Pos2> = values
            .map(|&(frame, value)| pos2(axis.x_of(frame), y(value)))
            .collect();
        draw(painter, &line, colour, Some(curve.quantity));
        if let Some(limit) = limit {
            let ends = [ground.left(), ground.right()].map(|x| pos2(x, y(limit)));
            let stroke = Stroke::new(1.0, palette.error);
            painter.extend(Shape::dashed_line(&ends, stroke, 3.0, 3.0));
            let value = with_unit(editor, curve.quantity, limit);
            let words = fill(editor.texts().timeline.limit, &[&value]);
            let place = pos2(right, y(limit) - 1.0);
            let (place, align) = match place.y - 12.0 < ground.top() {
                true => (place + vec2(0.0, 2.0), Align2::RIGHT_TOP),
                false => (place, Align2::RIGHT_BOTTOM),
            };
            // In the curve's colour, since there may be several; beside one another.
            let galley = painter.layout_no_wrap(words, theme::small(), colour);
            let text = align.anchor_size(place, galley.size());
            painter.rect_filled(text.expand2(vec2(2.0, 0.0)), 2.0, palette.field);
            painter.galley(text.min, galley, colour);
            right = text.left() - 10.0;
        }
        let place = pos2(left, ground.top() + 1.0);
        left = heading(editor, painter, (curve, at), colour, place);
    }
}

/// A line in the colour and the dashes of a quantity.
fn draw(painter: &Painter, line: &[Pos2], colour: Color32, quantity: Option<Quantity>) {
    let stroke = Stroke::new(1.5, colour);
    match quantity.and_then(dashes) {
        _ if line.len() < 2 => {}
        None => {
            painter.add(Shape::line(line.to_vec(), stroke));
        }
        Some((dash, gap)) => {
            painter.extend(Shape::dashed_line(line, stroke, dash, gap));
        }
    }
}

/// The name of a curve and its value at a frame; where the next one may stand.
fn heading(
    editor: &Editor,
    painter: &Painter,
    (curve, at): (&Curve, f64),
    colour: Color32,
    place: Pos2,
) -> f32 {
    let all = names(editor.texts());
    let name = all
        .iter()
        .find(|(quantity, _)| *quantity == Some(curve.quantity));
    let name = name.map_or("", |(_, name)| name);
    let value = match curve.at(at) {
        Some(value) => with_unit(editor, curve.quantity, value),
        None if curve.quantity == Quantity::Clearance => {
            editor.texts().space_window.no_object.to_owned()
        }
        None => "–".to_owned(),
    };
    let words = format!("{name} {value}");
    let galley = painter.layout_no_wrap(words, theme::small(), colour);
    let right = place.x + galley.size().x;
    // What has no room is in the menu.
    if right < painter.clip_rect().right() {
        painter.galley(place, galley, colour);
    }
    right + 14.0
}

/// Lines at round values, with these at the left.
fn lines_of_scale(
    editor: &Editor,
    ui: &Ui,
    (ground, room): (Rect, Rect),
    (low, high): (f64, f64),
    curve: &Curve,
    y: &dyn Fn(f64) -> f32,
) {
    let palette = theme::palette(ui);
    let per_point = (high - low) / f64::from((y(low) - y(high)).max(1.0));
    let (wide, _) = step(per_point * APART);
    let painter = ui.painter();
    let below = room.top() + theme::GAP + theme::ROW;
    for at in 0..64_u32 {
        let value = wide * ((low / wide).ceil() + f64::from(at));
        if value > high {
            break;
        }
        painter.hline(ground.x_range(), y(value), Stroke::new(1.0, palette.line));
        // Below the button.
        if y(value) - 7.0 > below {
            let place = pos2(room.right() - 2.0, y(value));
            let text = with_unit(editor, curve.quantity, value);
            painter.text(
                place,
                Align2::RIGHT_CENTER,
                text,
                theme::small(),
                palette.weak,
            );
        }
    }
}

fn with_unit(editor: &Editor, quantity: Quantity, value: f64) -> String {
    let (unit, decimals) = match quantity {
        Quantity::Distance | Quantity::Clearance => ("", 3),
        Quantity::Speed => ("/s", 3),
        Quantity::Acceleration => ("/s²", 3),
        Quantity::Turning => ("°/s", 1),
        Quantity::Roll => ("°", 1),
        Quantity::Zoom => (" mm", 1),
    };
    format!("{}{unit}", editor.language().number(value, decimals))
}

#[cfg(test)]
#[path = "plot_tests.rs"]
mod tests;
