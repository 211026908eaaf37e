//! The sliders around the movement window, each with its number (thesis A.2).

use egui::{Align, Layout, Rect, Slider, SliderOrientation, Ui, UiBuilder, pos2};

use crate::action::Action;
use crate::number::Number;
use crate::setup::View;
use crate::space::surface::resized;
use crate::state::Editor;

/// Height of the rows above and below, width of the column.
const ROW: f32 = 32.0;
const COLUMN: f32 = 68.0;

/// Width of a name and of a number.
const NAME: f32 = 48.0;
const NUMBER: f32 = 56.0;

/// Distance from the border, and between slider and number.
const EDGE: f32 = 12.0;
const GAP: f32 = 8.0;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Part {
    Size,
    Rotation,
    Tilt,
}

/// Shows the sliders; returns the viewport between them. `before` is the view before a drag.
pub(super) fn show(
    editor: &Editor,
    before: &mut Option<View>,
    ui: &mut Ui,
    actions: &mut Vec<Action>,
) -> Rect {
    let all = ui.available_rect_before_wrap();
    ui.advance_cursor_after_rect(all);
    let mut view = editor.setup.view;
    let right = (all.right() - COLUMN).max(all.left());
    let bottom = (all.bottom() - ROW).max(all.top() + ROW);
    let between = Rect::from_min_max(pos2(all.left(), all.top() + ROW), pos2(right, bottom));
    let row = |top: f32| {
        let min = pos2(all.left() + EDGE, top);
        Rect::from_min_max(min, pos2(all.right() - EDGE, top + ROW))
    };
    let level = |top| {
        let layout = Layout::left_to_right(Align::Center);
        UiBuilder::new().max_rect(row(top)).layout(layout)
    };
    let mut sliders = Sliders {
        editor,
        view: &mut view,
        before,
        viewport: between,
        actions,
    };
    ui.scope_builder(level(all.top()), |ui| sliders.along(ui, Part::Size));
    ui.scope_builder(level(bottom), |ui| sliders.along(ui, Part::Rotation));
    let column = Rect::from_min_max(
        pos2(all.right() - EDGE - NUMBER, between.top()),
        pos2(all.right() - EDGE, between.bottom()),
    );
    let upright = Layout::top_down(Align::Center);
    let upright = UiBuilder::new().max_rect(column).layout(upright);
    ui.scope_builder(upright, |ui| {
        ui.spacing_mut().item_spacing.y = GAP;
        ui.weak(editor.texts().space.tilt);
        ui.spacing_mut().slider_width = (ui.available_height() - ROW).max(40.0);
        sliders.slide(ui, Part::Tilt);
        sliders.number(ui, Part::Tilt);
    });
    if view != editor.setup.view {
        actions.push(Action::View(view));
    }
    between
}

/// The numbers alone, each with its name: two columns of a grid.
pub(super) fn numbers(
    editor: &Editor,
    before: &mut Option<View>,
    viewport: Rect,
    ui: &mut Ui,
    actions: &mut Vec<Action>,
) {
    let mut view = editor.setup.view;
    let texts = &editor.texts().space;
    let mut sliders = Sliders {
        editor,
        view: &mut view,
        before,
        viewport,
        actions,
    };
    for (part, name) in [
        (Part::Size, texts.size),
        (Part::Rotation, texts.rotate),
        (Part::Tilt, texts.tilt),
    ] {
        ui.label(name);
        sliders.number(ui, part);
        ui.end_row();
    }
    if view != editor.setup.view {
        actions.push(Action::View(view));
    }
}

/// What the three share.
struct Sliders<'a> {
    editor: &'a Editor,
    view: &'a mut View,
    before: &'a mut Option<View>,
    viewport: Rect,
    actions: &'a mut Vec<Action>,
}

impl Sliders<'_> {
    fn along(&mut self, ui: &mut Ui, part: Part) {
        let text = match part {
            Part::Size => self.editor.texts().space.size,
            _ => self.editor.texts().space.rotate,
        };
        ui.allocate_ui_with_layout(
            egui::vec2(NAME, ROW),
            Layout::left_to_right(Align::Center),
            |ui| {
                ui.set_min_width(NAME);
                ui.weak(text);
            },
        );
        ui.spacing_mut().item_spacing.x = GAP;
        ui.spacing_mut().slider_width = (ui.available_width() - NUMBER - GAP).max(40.0);
        self.slide(ui, part);
        self.number(ui, part);
    }

    fn slide(&mut self, ui: &mut Ui, part: Part) {
        let texts = &self.editor.texts().space;
        let (name, tip) = match part {
            Part::Size => (texts.size, texts.size_tip),
            Part::Rotation => (texts.rotate, texts.rotate_tip),
            Part::Tilt => (texts.tilt, texts.tilt_tip),
        };
        let mut value = part.of(self.view);
        let slider = Slider::new(&mut value, part.range())
            .show_value(false)
            .logarithmic(part == Part::Size)
            .trailing_fill(part == Part::Size)
            .orientation(if part == Part::Tilt {
                SliderOrientation::Vertical
            } else {
                SliderOrientation::Horizontal
            });
        let response = ui.add(slider);
        ui.ctx()
            .accesskit_node_builder(response.id, |node| node.set_label(name));
        if response.changed() {
            part.set(self.view, self.viewport, value);
        }
        if response.double_clicked() {
            part.set(self.view, self.viewport, part.of(&View::default()));
        }
        response.on_hover_text(tip);
    }

    fn number(&mut self, ui: &mut Ui, part: Part) {
        let texts = &self.editor.texts().space;
        let (name, unit) = match part {
            Part::Size => (texts.size, " %"),
            Part::Rotation => (texts.rotate, "°"),
            Part::Tilt => (texts.tilt, "°"),
        };
        let value = part.of(self.view);
        let id = match part {
            Part::Size => "space size",
            Part::Rotation => "space rotation",
            Part::Tilt => "space tilt",
        };
        let entry = Number::new(name, value)
            .unit(unit)
            .decimals(0)
            .range(part.range())
            .steps(1.0, 0.5)
            .show(ui, self.editor.language(), id, NUMBER);
        let viewport = self.viewport;
        let set = |view: &mut View, value| part.set(view, viewport, value);
        entry.apply(self.before, self.view, set, self.actions);
    }
}

impl Part {
    /// The value shown for it: the size in percent, the others in degrees.
    fn of(self, view: &View) -> f64 {
        match self {
            Self::Size => view.size * 100.0,
            Self::Rotation => view.rotation,
            Self::Tilt => view.tilt,
        }
    }

    fn set(self, view: &mut View, viewport: Rect, value: f64) {
        match self {
            Self::Size => *view = resized(view, viewport, None, value / 100.0 / view.size),
            Self::Rotation => view.rotation = value,
            Self::Tilt => view.tilt = value,
        }
        *view = view.in_range();
    }

    fn range(self) -> std::ops::RangeInclusive<f64> {
        match self {
            Self::Size => View::MIN_SIZE * 100.0..=View::MAX_SIZE * 100.0,
            Self::Rotation => -180.0..=180.0,
            Self::Tilt => -90.0..=90.0,
        }
    }
}
