//! The sliders around the movement window: size above, rotation below, tilt at
//! the right, each with its number (thesis A.2).

use egui::{Align, DragValue, Layout, Rect, Slider, SliderOrientation, Ui, UiBuilder, pos2, vec2};

use crate::editor::setup::View;
use crate::editor::state::Editor;
use crate::editor::texts::Language;

/// Height of the rows above and below, width of the column.
const ROW: f32 = 36.0;
const COLUMN: f32 = 60.0;

/// Width of a number.
const NUMBER: f32 = 52.0;

/// Shows the sliders and gives back the room between them.
pub(super) fn show(editor: &mut Editor, ui: &mut Ui) -> Rect {
    let all = ui.available_rect_before_wrap();
    ui.advance_cursor_after_rect(all);
    let right = (all.right() - COLUMN).max(all.left());
    let bottom = (all.bottom() - ROW).max(all.top() + ROW);
    let between = Rect::from_min_max(pos2(all.left(), all.top() + ROW), pos2(right, bottom));
    let texts = &editor.texts().space;
    let language = editor.language;
    let view = &mut editor.setup.view;
    let before = *view;

    let row = |top: f32| {
        let min = pos2(all.left() + 16.0, top);
        Rect::from_min_max(min, pos2(right, top + ROW))
    };
    let row_layout = || UiBuilder::new().layout(Layout::left_to_right(Align::Center));
    let mut size = view.size;
    ui.scope_builder(row_layout().max_rect(row(all.top())), |ui| {
        along(ui, texts.size, texts.size_tip, |ui, tip| {
            let range = View::MIN_SIZE..=View::MAX_SIZE;
            let slider = Slider::new(&mut size, range.clone()).logarithmic(true);
            ui.add(slider.show_value(false)).on_hover_text(tip);
            let mut percent = size * 100.0;
            let range = range.start() * 100.0..=range.end() * 100.0;
            let number = number(&mut percent, language, 0, " %")
                .range(range)
                .speed(1.0);
            if ui.add_sized(vec2(NUMBER, 22.0), number).changed() {
                size = percent / 100.0;
            }
        });
    });
    if size != view.size {
        super::hand::resize(view, between, None, size / view.size);
        view.size = size;
    }
    ui.scope_builder(row_layout().max_rect(row(bottom)), |ui| {
        along(ui, texts.rotate, texts.rotate_tip, |ui, tip| {
            let slider = Slider::new(&mut view.rotation, -180.0..=180.0);
            ui.add(slider.show_value(false)).on_hover_text(tip);
            let number = number(&mut view.rotation, language, 0, "°").speed(1.0);
            ui.add_sized(vec2(NUMBER, 22.0), number);
        });
    });
    let column = Rect::from_min_max(
        pos2(right, between.top()),
        pos2(all.right() - 4.0, between.bottom()),
    );
    let layout = UiBuilder::new().layout(Layout::top_down(Align::Center));
    ui.scope_builder(layout.max_rect(column), |ui| {
        ui.label(texts.tilt).on_hover_text(texts.tilt_tip);
        ui.spacing_mut().slider_width = (ui.available_height() - 36.0).max(40.0);
        let slider = Slider::new(&mut view.tilt, -90.0..=90.0)
            .orientation(SliderOrientation::Vertical)
            .show_value(false);
        ui.add(slider).on_hover_text(texts.tilt_tip);
        let number = number(&mut view.tilt, language, 0, "°")
            .range(-90.0..=90.0)
            .speed(1.0);
        ui.add_sized(vec2(NUMBER, 22.0), number);
    });
    if *view != before {
        *view = view.in_range();
    }
    between
}

/// A name and what takes the rest of the row.
fn along(ui: &mut Ui, name: &str, tip: &str, add: impl FnOnce(&mut Ui, &str)) {
    ui.label(name).on_hover_text(tip);
    ui.add_space(4.0);
    ui.spacing_mut().slider_width = (ui.available_width() - NUMBER - 12.0).max(40.0);
    add(ui, tip);
}

/// A number to be dragged or typed, in the language's way.
fn number<'a>(
    value: &'a mut f64,
    language: Language,
    decimals: usize,
    unit: &'static str,
) -> DragValue<'a> {
    DragValue::new(value)
        .custom_formatter(move |value, _| language.number(value, decimals) + unit)
        .custom_parser(move |text| {
            let text = text.trim().trim_end_matches(unit.trim()).trim();
            text.replace(',', ".").replace('−', "-").parse().ok()
        })
}
