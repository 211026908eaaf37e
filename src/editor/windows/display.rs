//! What the movement window shows (thesis A.5): a switch for each element.

use egui::{Grid, vec2};

use super::{SubWindow, Windows, sub_window};
use crate::editor::setup::{Element, Shown, Theme, View};
use crate::editor::state::Editor;
use crate::editor::texts::Language;
use crate::editor::theme;

/// From one choice to the next.
const APART: f32 = 16.0;

/// The display window.
#[derive(Debug)]
pub(in crate::editor) struct DisplayWindow {}

impl SubWindow for DisplayWindow {
    const ID: &'static str = "display";

    fn slot(windows: &mut Windows) -> &mut Option<Self> {
        &mut windows.display
    }

    fn new(_: &Editor) -> Self {
        Self {}
    }

    fn show(&mut self, editor: &mut Editor, context: &egui::Context) -> bool {
        let texts = &editor.texts().display;
        let (menu, hints) = (&editor.texts().menu, &editor.texts().menu_hints);
        let before = editor.setup.clone();
        let stays = sub_window(context, Self::ID, texts.title, |ui| {
            ui.set_width(420.0);
            Grid::new("elements")
                .num_columns(2)
                .min_col_width(202.0)
                .spacing(vec2(16.0, 0.0))
                .show(ui, |ui| {
                    let with_switch: Vec<Element> = Element::ALL
                        .into_iter()
                        .filter(|element| element.has_switch())
                        .collect();
                    let half = with_switch.len().div_ceil(2);
                    for row in 0..half {
                        for &element in with_switch.iter().skip(row).step_by(half) {
                            let mut on = editor.setup.shown.has(element);
                            if ui.checkbox(&mut on, texts.name(element)).changed() {
                                editor.setup.shown.set(element, on);
                            }
                        }
                        ui.end_row();
                    }
                });
            let mut camera = editor.setup.camera_view;
            if ui.checkbox(&mut camera, texts.camera_view).changed() {
                editor.setup.camera_view = camera;
            }
            ui.add_space(theme::GAP);
            ui.horizontal(|ui| {
                let all = editor.setup.shown == Shown::default();
                let button = ui.add_enabled(!all, egui::Button::new(texts.all));
                if button.on_hover_text(texts.all_hint).clicked() {
                    editor.setup.shown = Shown::default();
                }
                let same = editor.setup.view == View::default();
                let button = ui.add_enabled(!same, egui::Button::new(texts.view));
                if button.on_hover_text(texts.view_hint).clicked() {
                    editor.setup.view = View::default();
                }
            });
            ui.separator();
            ui.horizontal(|ui| {
                ui.spacing_mut().item_spacing.x = APART;
                named(ui, texts.theme);
                for (theme, name, hint) in [
                    (None, menu.as_system, hints.as_system),
                    (Some(Theme::Dark), menu.dark, hints.dark),
                    (Some(Theme::Light), menu.light, hints.light),
                ] {
                    ui.radio_value(&mut editor.setup.theme, theme, name)
                        .on_hover_text(hint);
                }
            });
            ui.horizontal(|ui| {
                ui.spacing_mut().item_spacing.x = APART;
                named(ui, texts.language);
                // Each language by its own name, to be found by who speaks it.
                for (language, name) in [
                    (None, texts.automatic),
                    (Some(Language::German), texts.german),
                    (Some(Language::English), texts.english),
                ] {
                    ui.radio_value(&mut editor.setup.language, language, name)
                        .on_hover_text(texts.language_hint);
                }
            });
        });
        if editor.setup != before {
            // The movement window has been drawn already.
            context.request_repaint();
        }
        stays
    }
}

/// What the choices beside it are about, in a column.
fn named(ui: &mut egui::Ui, name: &str) {
    let size = vec2(112.0, theme::ROW);
    ui.allocate_ui_with_layout(size, *ui.layout(), |ui| {
        ui.set_min_width(size.x);
        ui.label(name);
    });
}
