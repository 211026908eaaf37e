//! The colours of the movement window (thesis A.5): an element is chosen from a list, three sliders
//! mix its red, green and blue. Changes show at once, and belong to the current theme.

use egui::{
    Button, Color32, CornerRadius, Grid, Rect, Sense, Slider, Stroke, StrokeKind, Ui, vec2,
};

use crate::action::Action;
use crate::number::Number;
use crate::setup::{Colours, Element, Setup, Theme};
use crate::state::Editor;
use crate::state::windows::{ColourWindow, Windows};
use crate::texts::fill;
use crate::theme;
use crate::windows::dock::docked;
use crate::windows::sub_window::SubWindow;

/// Width of a name, of a number, and between the columns.
const NAME: f32 = 44.0;
const NUMBER: f32 = 56.0;
const APART: f32 = 8.0;

impl SubWindow for ColourWindow {
    const ID: &'static str = "colours";
    const DOCKED: bool = true;

    fn slot(windows: &mut Windows) -> &mut Option<Self> {
        &mut windows.colours
    }

    fn new(editor: &Editor) -> Self {
        Self {
            element: Element::Background,
            before: None,
            before_all: (editor.setup.dark, editor.setup.light),
        }
    }

    fn show(
        &mut self,
        editor: &Editor,
        context: &egui::Context,
        actions: &mut Vec<Action>,
    ) -> bool {
        let texts = &editor.texts().colours;
        let mut setup = editor.setup.clone();
        let tools = &editor.texts().tools;
        let named = (Self::ID, texts.title);
        let keeps = ([tools.ok, tools.ok_hint], true);
        let end = docked(editor, context, named, Some(keeps), |ui| {
            self.mix(editor, ui, &mut setup, actions);
            ui.separator();
            self.list(editor, ui);
        });
        if end == Some(false) {
            (setup.dark, setup.light) = self.before_all;
        }
        if setup != editor.setup {
            actions.push(Action::Setup(Box::new(setup)));
        }
        end.is_none()
    }
}

impl ColourWindow {
    fn list(&mut self, editor: &Editor, ui: &mut Ui) {
        ui.spacing_mut().item_spacing.y = 0.0;
        for element in Element::ALL {
            let name = editor.texts().display.name(element);
            let chosen = element == self.element;
            let row = ui.horizontal(|ui| {
                let (place, _) = ui.allocate_exact_size(vec2(16.0, theme::ROW), Sense::hover());
                let place = Rect::from_center_size(place.center(), vec2(16.0, 14.0));
                swatch(ui, place, editor.setup.colours().of(element));
                let row = Button::selectable(chosen, name)
                    .min_size(vec2(ui.available_width(), theme::ROW))
                    .wrap_mode(egui::TextWrapMode::Truncate);
                // Words from the left.
                ui.vertical(|ui| ui.add(row)).inner
            });
            let response = row.inner;
            response.widget_info(|| {
                egui::WidgetInfo::selected(egui::Role::RadioButton, true, chosen, name)
            });
            if response.clicked() {
                self.element = element;
                self.before = None;
            }
        }
    }

    fn mix(&mut self, editor: &Editor, ui: &mut Ui, setup: &mut Setup, actions: &mut Vec<Action>) {
        let texts = &editor.texts().colours;
        let element = self.element;
        let colour = setup.colours().of(element);
        ui.strong(editor.texts().display.name(element));
        let (rect, _) = ui.allocate_exact_size(vec2(ui.available_width(), 32.0), Sense::hover());
        swatch(ui, rect, colour);
        ui.add_space(theme::GAP);
        let slider = ui.available_width() - NAME - NUMBER - 2.0 * APART;
        let [r, g, b, _] = colour.to_array();
        let names = [texts.red, texts.green, texts.blue];
        Grid::new("mix")
            .num_columns(3)
            .spacing(vec2(APART, theme::GAP))
            .show(ui, |ui| {
                for (part, (name, value)) in names.into_iter().zip([r, g, b]).enumerate() {
                    let label = ui.horizontal(|ui| {
                        ui.set_min_width(NAME);
                        ui.label(name)
                    });
                    let label = label.inner;
                    let mut slid = value;
                    ui.spacing_mut().slider_width = slider;
                    let slider = Slider::new(&mut slid, 0..=255).show_value(false);
                    if ui.add(slider).labelled_by(label.id).changed() {
                        setup
                            .colours_mut()
                            .set(element, with_part(colour, part, slid));
                    }
                    let number = Number::new(name, f64::from(value))
                        .decimals(0)
                        .whole()
                        .range(0.0..=255.0)
                        .steps(1.0, 1.0);
                    let id = format!("colour.{part}");
                    let entry = number.show(ui, editor.language(), &id, NUMBER);
                    let mut new = colour;
                    // `Number` keeps it in range.
                    let set = |new: &mut Color32, value: f64| {
                        *new = with_part(colour, part, value.round() as u8);
                    };
                    entry.apply(&mut self.before, &mut new, set, actions);
                    if new != colour {
                        setup.colours_mut().set(element, new);
                    }
                    ui.end_row();
                }
            });
        ui.add_space(theme::GAP * 2.0);
        let original = match setup.theme() {
            Theme::Dark => Colours::DARK,
            Theme::Light => Colours::LIGHT,
        };
        ui.horizontal(|ui| {
            let one = ui.add_enabled(colour != original.of(element), Button::new(texts.reset));
            if one.on_hover_text(texts.reset_hint).clicked() {
                setup.colours_mut().set(element, original.of(element));
            }
            let changed = *setup.colours() != original;
            let all = ui.add_enabled(changed, Button::new(texts.reset_all));
            if all.on_hover_text(texts.reset_all_hint).clicked() {
                *setup.colours_mut() = original;
            }
        });
        ui.add_space(theme::GAP);
        let menu = &editor.texts().menu;
        let theme = match setup.theme() {
            Theme::Dark => menu.dark,
            Theme::Light => menu.light,
        };
        let weak = theme::palette(ui).weak;
        ui.colored_label(weak, fill(texts.of_theme, &[&theme]));
    }
}

fn swatch(ui: &Ui, rect: Rect, colour: Color32) {
    let edge = Stroke::new(1.0, theme::palette(ui).rim);
    ui.painter().rect(
        rect,
        CornerRadius::same(3),
        colour,
        edge,
        StrokeKind::Inside,
    );
}

fn with_part(colour: Color32, part: usize, value: u8) -> Color32 {
    let mut parts = colour.to_array();
    parts[part] = value;
    Color32::from_rgb(parts[0], parts[1], parts[2])
}
