//! Other quantities along the path in place of the speeds, from the poses as `vides plot` has them,
//! and what a check has found.

use std::rc::Rc;

use egui::{Align2, Button, Painter, Pos2, Rect, RichText, Shape, Stroke, Ui, pos2, vec2};

use super::graph::Scale;
use crate::actions::Action;
use crate::document::Document;
use crate::error::Result;
use crate::state::Editor;
use crate::texts::Texts;
use crate::theme::{self, Palette};
use crate::tools::check::FindingKind;
use crate::tools::clearance::Clearance;
use crate::tools::profile::{Film, Quantity, samples, with_peaks};

/// Most poses sampled; while something is held, [`VALUES`]. At most so many values are drawn: a
/// little more than there are columns.
const POSES: usize = 20_000;
const VALUES: usize = 1_000;

/// Findings that are marked over the speeds of the sections.
const OF_SECTIONS: &[FindingKind] = &[
    FindingKind::SpeedJump,
    FindingKind::Cusp,
    FindingKind::Corner,
];

#[derive(Debug, Default)]
pub(super) struct Plot {
    /// The revision of the path, the quantity, the most poses.
    of: Option<(u64, Quantity, usize)>,
    /// Frame and value.
    values: Vec<(f64, f64)>,
}

impl Plot {
    /// Brings the values up to date; `held`: something may be dragged.
    pub(super) fn update(
        &mut self,
        document: &Document,
        quantity: Option<Quantity>,
        held: bool,
        object: impl FnOnce() -> Result<Option<Rc<Clearance>>>,
    ) -> Result<()> {
        let most = if held { VALUES } else { POSES };
        let of = quantity.map(|quantity| (document.revision(), quantity, most));
        if self.of == of {
            return Ok(());
        }
        self.of = of;
        self.values.clear();
        if let Some(quantity) = quantity {
            let object = match quantity {
                Quantity::Clearance => object()?,
                _ => None,
            };
            let film = Film {
                samples: &samples(document.sampler()?, most)?,
                fps: document.info().fps,
                up: document.path().space.up,
                object: object.as_deref(),
            };
            self.values = with_peaks(quantity.of(&film)?, VALUES);
        }
        Ok(())
    }

    /// The value at a frame, or at the nearest one that has a value.
    fn at(&self, frame: f64) -> Option<f64> {
        let next = self.values.partition_point(|&(at, _)| at < frame);
        let near = self.values[next.saturating_sub(1)..].iter().take(2);
        let away = |at: f64| (at - frame).abs();
        let nearest = near.min_by(|a, b| away(a.0).total_cmp(&away(b.0)))?;
        Some(nearest.1)
    }
}

/// The buttons that choose a quantity, the speeds of the sections first.
pub(super) fn choices(editor: &Editor, ui: &mut Ui, room: Rect, actions: &mut Vec<Action>) {
    let texts = &editor.texts().space;
    let names = [
        (None, texts.speed_graph),
        (Some(Quantity::Distance), texts.plot_distance),
        (Some(Quantity::Speed), texts.plot_speed),
        (Some(Quantity::Acceleration), texts.plot_acceleration),
        (Some(Quantity::Turning), texts.plot_turning),
        (Some(Quantity::Roll), texts.plot_roll),
        (Some(Quantity::Zoom), texts.plot_zoom),
        (Some(Quantity::Clearance), texts.plot_clearance),
    ];
    let gap = theme::GAP;
    let size = (room.size() - 2.0 * vec2(gap, gap)) / 3.0;
    for (at, (quantity, name)) in names.into_iter().enumerate() {
        let (row, column) = ((at / 3) as f32, (at % 3) as f32);
        let corner = room.min + vec2(column, row) * (size + vec2(gap, gap));
        let chosen = editor.playing.quantity == quantity;
        let words = RichText::new(name).font(theme::small());
        let place = Rect::from_min_size(corner, size);
        let button = ui.put(
            place,
            Button::selectable(chosen, words).frame_when_inactive(true),
        );
        button.widget_info(|| {
            let name = format!("{}: {name}", texts.plot);
            egui::WidgetInfo::selected(egui::Role::RadioButton, true, chosen, name)
        });
        let tip = format!("{}\n{}", meaning(editor.texts(), quantity), texts.plot_tip);
        if button.on_hover_text(tip).clicked() {
            actions.push(Action::Plot(quantity));
        }
    }
}

/// What the curve of a quantity tells; none stands for the speeds of the sections.
pub(super) fn meaning(texts: &Texts, quantity: Option<Quantity>) -> &'static str {
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

/// Marks what the open check has found.
pub(super) fn findings(editor: &Editor, painter: &Painter, scale: &Scale, ground: Rect) {
    let Some(window) = &editor.windows.check else {
        return;
    };
    let quantity = editor.playing.quantity;
    let kinds = quantity.map_or(OF_SECTIONS, Quantity::findings);
    let colour = theme::palette_of(&painter.ctx().global_style().visuals).error;
    for finding in window.found().iter().filter(|f| kinds.contains(&f.kind)) {
        #[allow(clippy::cast_possible_truncation)]
        let [from, to] =
            [finding.first_frame, finding.last_frame].map(|frame| scale.x(frame as f32));
        let place = Rect::from_x_y_ranges(from..=to.max(from + 2.0), ground.y_range());
        painter.rect_filled(place, 0.0, colour.gamma_multiply(0.25));
    }
}

/// The curve, and its value at the playhead.
pub(super) fn paint(
    editor: &Editor,
    painter: &Painter,
    scale: &Scale,
    ground: Rect,
    palette: &Palette,
) {
    let plot = &editor.playing.plot;
    if plot.values.is_empty() && editor.playing.quantity == Some(Quantity::Clearance) {
        let words = editor.texts().space_window.no_object;
        let middle = ground.center();
        painter.text(
            middle,
            Align2::CENTER_CENTER,
            words,
            theme::small(),
            palette.weak,
        );
        return;
    }
    let all = plot.values.iter().map(|&(_, value)| value);
    let (low, high) = all.fold((0.0_f64, 0.0_f64), |(a, b), v| (a.min(v), b.max(v)));
    let span = (high - low).max(1e-9);
    let height = f64::from(ground.height()) - 20.0;
    #[allow(clippy::cast_possible_truncation)]
    let y = |value: f64| ground.bottom() - 5.0 - ((value - low) / span * height) as f32;
    painter.hline(ground.x_range(), y(0.0), Stroke::new(1.0, palette.line));
    #[allow(clippy::cast_possible_truncation)]
    let line: Vec<Pos2> = plot
        .values
        .iter()
        .map(|&(frame, value)| pos2(scale.x(frame as f32), y(value)))
        .collect();
    if line.len() > 1 {
        painter.add(Shape::line(line, Stroke::new(1.5, palette.accent)));
    }
    let Some((_, quantity, _)) = plot.of else {
        return;
    };
    // The scale beside it.
    for value in [high, low] {
        if !plot.values.is_empty() && (value != 0.0 || high == low) {
            let place = pos2(ground.right() + 6.0, y(value));
            let text = with_unit(editor, quantity, value);
            painter.text(
                place,
                Align2::LEFT_CENTER,
                text,
                theme::small(),
                palette.weak,
            );
        }
    }
    let frame = editor.position_on_bar();
    if let Some(value) = plot.at(frame) {
        #[allow(clippy::cast_possible_truncation)]
        let at = scale.x(frame as f32);
        let (place, align) = if at > ground.center().x {
            (pos2(at - 5.0, ground.bottom() - 4.0), Align2::RIGHT_BOTTOM)
        } else {
            (pos2(at + 5.0, ground.bottom() - 4.0), Align2::LEFT_BOTTOM)
        };
        let text = with_unit(editor, quantity, value);
        painter.text(place, align, text, theme::small(), palette.text);
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
mod tests {
    use egui_kittest::kittest::Queryable;
    use glam::DVec3;

    use super::*;
    use crate::screenshots::screenshot;
    use crate::space::tests::{pyramid_window, tap};

    #[test]
    fn a_quantity_is_plotted_in_place_of_the_speeds_and_follows_the_path() {
        let mut harness = pyramid_window();
        let texts = &crate::Language::English.texts().space;
        for (name, quantity) in [
            (texts.plot_speed, Quantity::Speed),
            (texts.plot_turning, Quantity::Turning),
            (texts.plot_zoom, Quantity::Zoom),
        ] {
            let label = format!("{}: {name}", texts.plot);
            harness.get_by_label(&label).click();
            harness.step();
            harness.step();
            let editor = harness.state();
            assert_eq!(editor.playing.quantity, Some(quantity));
            assert!(editor.playing.plot.values.len() > 700);
            screenshot(&mut harness, &format!("plot-{name}.png"));
        }
        // The pyramid is an object; the way is as long as its parts.
        let label = |name| format!("{}: {name}", texts.plot);
        for (name, quantity) in [
            (texts.plot_distance, Quantity::Distance),
            (texts.plot_clearance, Quantity::Clearance),
        ] {
            harness.get_by_label(&label(name)).click();
            harness.step();
            harness.step();
            let editor = harness.state();
            let sampler = editor.document.sampler().unwrap();
            let place = |frame: f64| DVec3::from_array(sampler.pose(frame).unwrap().vrp);
            let frames = sampler.frame_count() as u32;
            let expected = if quantity == Quantity::Distance {
                let steps = (1..frames).map(f64::from);
                steps.map(|k| place(k).distance(place(k + 1.0))).sum()
            } else {
                // No line of the object is far from one of these.
                let lines = editor.document.info().object.lines();
                let last = place(f64::from(frames));
                let places = lines.flat_map(|(ends, _)| {
                    (0..=1000).map(move |k| ends[0].lerp(ends[1], f64::from(k) / 1000.0))
                });
                places.map(|on| on.distance(last)).fold(f64::MAX, f64::min)
            };
            let shown = editor.playing.plot.at(1e9).unwrap();
            assert!(
                (shown - expected).abs() < 1e-5,
                "{name}: {shown} {expected}"
            );
            screenshot(&mut harness, &format!("plot-{name}.png"));
        }
        harness.get_by_label(&label(texts.plot_zoom)).click();
        harness.step();
        harness.step();
        // The zoom of all is 24; at the end it is another.
        let last = |harness: &egui_kittest::Harness<'_, Editor>| {
            harness.state().playing.plot.at(1e9).unwrap()
        };
        assert_eq!(last(&harness), 24.0);
        let points = harness.state().document.path().points.len();
        harness.state_mut().document.select(points - 1, 0).unwrap();
        harness.state_mut().set_orientation(|last| last.zoom = 50.0);
        harness.step();
        harness.step();
        assert_eq!(last(&harness), 50.0);
        tap(&mut harness, egui::Key::Z, egui::Modifiers::CTRL);
        harness.step();
        assert_eq!(last(&harness), 24.0);
        harness
            .get_by_label(&format!("{}: {}", texts.plot, texts.speed_graph))
            .click();
        harness.step();
        harness.step();
        assert!(harness.state().playing.plot.values.is_empty());
    }

    #[test]
    fn the_hint_over_a_plot_tells_what_is_plotted() {
        use crate::tests::{BOTH, window};
        for language in BOTH {
            let texts = language.texts();
            let mut window = window(language);
            let all = || std::iter::once(None).chain(Quantity::ALL.map(Some));
            for quantity in all() {
                let context = window.ctx.clone();
                window.state_mut().act(Action::Plot(quantity), &context);
                window.run();
                let plot =
                    window.get_by_role_and_label(egui::Role::Canvas, texts.space.speed_graph);
                let plot = plot.rect();
                window.hover_at(plot.center() + vec2(0.0, 20.0));
                for _ in 0..80 {
                    window.step();
                }
                for other in all() {
                    let words = meaning(texts, other);
                    let seen = window.query_by_label(words).is_some();
                    assert_eq!(seen, other == quantity, "{words}");
                }
                screenshot(
                    &mut window,
                    &format!("plot-tip-{quantity:?}-{language:?}.png"),
                );
                window.hover_at(pos2(1.0, 799.0));
                window.run();
            }
        }
    }
}
