//! What else changes along the path, in place of the speeds of its sections: read from the
//! poses, as `vides plot` has it. What a check has found is marked, in both.

use egui::{Align2, Button, Painter, Pos2, Rect, RichText, Shape, Stroke, Ui, pos2, vec2};

use super::graph::Scale;
use crate::actions::Action;
use crate::document::Document;
use crate::error::Result;
use crate::state::Editor;
use crate::theme::{self, Palette};
use crate::tools::profile::{Quantity, samples};

/// So many poses are looked at: a little more than there are columns.
const POSES: usize = 1_000;

/// Findings that are marked over the speeds of the sections.
const OF_SECTIONS: &[&str] = &["speed-jump", "cusp", "corner"];

/// The values of a quantity.
#[derive(Debug, Default)]
pub(super) struct Plot {
    /// The revision of the path, and the quantity.
    of: Option<(u64, Quantity)>,
    /// Frame and value.
    values: Vec<(f64, f64)>,
}

impl Plot {
    pub(super) fn update(&mut self, document: &Document, quantity: Option<Quantity>) -> Result<()> {
        let of = quantity.map(|quantity| (document.revision(), quantity));
        if self.of == of {
            return Ok(());
        }
        self.of = of;
        self.values.clear();
        if let Some(quantity) = quantity {
            let poses = samples(document.sampler()?, POSES)?;
            let up = document.path().space.up;
            self.values = quantity.of(&poses, document.info().fps, up)?;
        }
        Ok(())
    }

    /// The value at a frame, or at the nearest that has one.
    fn at(&self, frame: f64) -> Option<f64> {
        let next = self.values.partition_point(|&(at, _)| at < frame);
        let near = self.values[next.saturating_sub(1)..].iter().take(2);
        let away = |at: f64| (at - frame).abs();
        let nearest = near.min_by(|a, b| away(a.0).total_cmp(&away(b.0)))?;
        Some(nearest.1)
    }
}

/// Which of them is shown, in the room at the left: the speeds of the sections first.
pub(super) fn choices(editor: &Editor, ui: &mut Ui, room: Rect, actions: &mut Vec<Action>) {
    let texts = &editor.texts().space;
    let names = [
        (None, texts.speed_graph),
        (Some(Quantity::Speed), texts.plot_speed),
        (Some(Quantity::Acceleration), texts.plot_acceleration),
        (Some(Quantity::Turning), texts.plot_turning),
        (Some(Quantity::Roll), texts.plot_roll),
        (Some(Quantity::Zoom), texts.plot_zoom),
    ];
    let gap = theme::GAP;
    let size = vec2((room.width() - 2.0 * gap) / 3.0, theme::ROW);
    for (at, (quantity, name)) in names.into_iter().enumerate() {
        let (row, column) = ((at / 3) as f32, (at % 3) as f32);
        let corner = room.min + vec2(column * (size.x + gap), gap + row * (size.y + gap));
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
        if button.on_hover_text(texts.plot_tip).clicked() {
            actions.push(Action::Plot(quantity));
        }
    }
}

/// What a check that is open has found, over the frames.
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
    let frame = editor.position_on_bar();
    let Some((_, quantity)) = plot.of else { return };
    if let Some(value) = plot.at(frame) {
        let unit = match quantity {
            Quantity::Speed => "/s",
            Quantity::Acceleration => "/s²",
            Quantity::Turning => "°/s",
            Quantity::Roll => "°",
            Quantity::Zoom => " mm",
        };
        let decimals = if matches!(quantity, Quantity::Speed | Quantity::Acceleration) {
            3
        } else {
            1
        };
        let text = format!("{}{unit}", editor.language().number(value, decimals));
        #[allow(clippy::cast_possible_truncation)]
        let at = scale.x(frame as f32);
        let (place, align) = if at > ground.center().x {
            (pos2(at - 5.0, ground.bottom() - 4.0), Align2::RIGHT_BOTTOM)
        } else {
            (pos2(at + 5.0, ground.bottom() - 4.0), Align2::LEFT_BOTTOM)
        };
        painter.text(place, align, text, theme::small(), palette.text);
    }
}

#[cfg(test)]
mod tests {
    use egui_kittest::kittest::Queryable;

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
}
