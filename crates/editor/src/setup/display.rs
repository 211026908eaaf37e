//! What the movement window shows (thesis A.5): a switch for each element.

use egui::{Grid, vec2};

use crate::action::Action;
use crate::setup::{Element, Shown, Theme, View};
use crate::state::Editor;
use crate::texts::Language;
use crate::theme;
use crate::windows::{SubWindow, Windows, sub_window};

/// From one choice to the next.
const APART: f32 = 16.0;

#[derive(Debug)]
pub(crate) struct DisplayWindow {}

impl SubWindow for DisplayWindow {
    const ID: &'static str = "display";

    fn slot(windows: &mut Windows) -> &mut Option<Self> {
        &mut windows.display
    }

    fn new(_: &Editor) -> Self {
        Self {}
    }

    fn show(
        &mut self,
        editor: &Editor,
        context: &egui::Context,
        actions: &mut Vec<Action>,
    ) -> bool {
        let texts = &editor.texts().display;
        let (menu, hints) = (&editor.texts().menu, &editor.texts().menu_hints);
        let mut setup = editor.setup.clone();
        let stays = sub_window(context, Self::ID, texts.title, |ui| {
            ui.set_width(420.0);
            Grid::new("elements")
                .num_columns(2)
                .min_col_width(202.0)
                .spacing(vec2(16.0, 0.0))
                .show(ui, |ui| {
                    // The camera's picture is the last one.
                    let elements = Element::ALL
                        .into_iter()
                        .filter(|element| element.has_switch());
                    let with_switch: Vec<_> = elements.map(Some).chain([None]).collect();
                    let half = with_switch.len().div_ceil(2);
                    for row in 0..half {
                        for &element in with_switch.iter().skip(row).step_by(half) {
                            let Some(element) = element else {
                                theme::tick(ui, &mut setup.camera_view, texts.camera_view);
                                continue;
                            };
                            let mut on = setup.shown.has(element);
                            if theme::tick(ui, &mut on, texts.name(element)).changed() {
                                setup.shown.set(element, on);
                            }
                        }
                        ui.end_row();
                    }
                });
            ui.add_space(theme::GAP);
            ui.horizontal(|ui| {
                let all = setup.shown == Shown::default();
                let button = ui.add_enabled(!all, egui::Button::new(texts.all));
                if button.on_hover_text(texts.all_hint).clicked() {
                    setup.shown = Shown::default();
                }
                let same = setup.view == View::default();
                let button = ui.add_enabled(!same, egui::Button::new(texts.view));
                if button.on_hover_text(texts.view_hint).clicked() {
                    setup.view = View::default();
                }
            });
            ui.separator();
            Grid::new("choices")
                .num_columns(4)
                .spacing(vec2(APART, theme::GAP))
                .show(ui, |ui| {
                    ui.label(texts.theme);
                    for (theme, name, hint) in [
                        (None, menu.as_system, hints.as_system),
                        (Some(Theme::Dark), menu.dark, hints.dark),
                        (Some(Theme::Light), menu.light, hints.light),
                    ] {
                        let choice = theme::choice(ui, editor.setup.theme == theme, name);
                        if choice.on_hover_text(hint).clicked() {
                            actions.push(Action::Theme(theme));
                        }
                    }
                    ui.end_row();
                    ui.label(texts.language);
                    // Each language by its own name, for those who speak it.
                    for (language, name) in [
                        (None, texts.automatic),
                        (Some(Language::German), texts.german),
                        (Some(Language::English), texts.english),
                    ] {
                        let choice = theme::choice(ui, editor.setup.language == language, name);
                        if choice.on_hover_text(texts.language_hint).clicked() {
                            actions.push(Action::Language(language));
                        }
                    }
                    ui.end_row();
                });
        });
        if setup != editor.setup {
            actions.insert(0, Action::Setup(Box::new(setup)));
        }
        stays
    }
}
