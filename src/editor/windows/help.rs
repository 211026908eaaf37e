//! All keys and what the mouse does (F1).

use egui::{Grid, Key, Modifiers, ScrollArea};

use super::{SubWindow, Windows, sub_window};
use crate::editor::actions::Action;
use crate::editor::keys::{SHORTCUTS, combination};
use crate::editor::space;
use crate::editor::state::Editor;
use crate::editor::texts::Language;
use crate::editor::theme;

/// The window.
#[derive(Debug)]
pub(in crate::editor) struct HelpWindow {}

impl SubWindow for HelpWindow {
    const ID: &'static str = "help";

    fn slot(windows: &mut Windows) -> &mut Option<Self> {
        &mut windows.help
    }

    fn new(_: &Editor) -> Self {
        Self {}
    }

    fn show(&mut self, editor: &mut Editor, context: &egui::Context) -> bool {
        let texts = &editor.texts().help;
        let height = (context.content_rect().height() - 120.0).max(160.0);
        sub_window(context, Self::ID, texts.title, |ui| {
            ScrollArea::vertical().max_height(height).show(ui, |ui| {
                for (heading, rows) in sections(editor.language()) {
                    let palette = theme::palette(ui);
                    ui.add_space(4.0);
                    ui.colored_label(palette.accent, heading);
                    Grid::new(heading)
                        .num_columns(2)
                        .spacing([16.0, 4.0])
                        .min_col_width(168.0)
                        .show(ui, |ui| {
                            for (keys, meaning) in rows {
                                ui.label(keys);
                                ui.colored_label(palette.weak, meaning);
                                ui.end_row();
                            }
                        });
                    ui.add_space(4.0);
                }
            });
        })
    }
}

/// The headings, each with its rows of keys and meanings.
fn sections(language: Language) -> [(&'static str, Vec<(String, &'static str)>); 4] {
    let texts = &language.texts().help;
    let row = |keys: &str, meaning| (keys.to_owned(), meaning);
    let alt = |key| combination(language, Modifiers::ALT, key);
    let plain = |key| combination(language, Modifiers::NONE, key);
    let mut mouse = vec![
        row(texts.left_button, texts.left_meaning),
        row(texts.middle_button, texts.middle_meaning),
        row(texts.right_button, texts.right_meaning),
        row(texts.held_letters, texts.held_meaning),
        row(texts.vup_tip, texts.vup_meaning),
        row(texts.empty, texts.empty_meaning),
        row(texts.wheel, texts.wheel_meaning),
        row(texts.context, texts.context_meaning),
    ];
    let ways = space::ways(language.texts());
    mouse.extend(ways.map(|(hand, meaning)| row(hand, meaning)));
    let shortcuts = SHORTCUTS
        .iter()
        .map(|&(modifiers, key, action)| {
            (
                combination(language, modifiers, key),
                meaning(language, action),
            )
        })
        .collect();
    let menus = vec![
        (alt(Key::D), texts.open_file),
        (alt(Key::A), texts.open_output),
        (alt(Key::E), texts.open_settings),
        row(texts.arrows, texts.arrows_meaning),
        (plain(Key::D), texts.d_meaning),
    ];
    let fields = vec![
        row(texts.drag, texts.drag_meaning),
        row(texts.click, texts.click_meaning),
        row(texts.enter, texts.enter_meaning),
        row(texts.escape, texts.escape_meaning),
        row(texts.up_down, texts.up_down_meaning),
        row(texts.tab, texts.tab_meaning),
    ];
    [
        (texts.mouse, mouse),
        (texts.shortcuts, shortcuts),
        (texts.menus, menus),
        (texts.fields, fields),
    ]
}

/// What an action does: the words of its menu entry.
fn meaning(language: Language, action: Action) -> &'static str {
    let (menu, help) = (&language.texts().menu, &language.texts().help);
    match action {
        Action::Load => menu.load,
        Action::Save => menu.save,
        Action::SaveAs => menu.save_as,
        Action::Quit => menu.quit,
        Action::Undo => menu.undo,
        Action::Redo => menu.redo,
        Action::RemovePoint => menu.remove_point,
        Action::CopyOrientation => menu.copy_orientation,
        Action::PasteOrientation => menu.paste_orientation,
        Action::HandOver => menu.hand_over,
        Action::Colours => menu.colours,
        Action::Display => menu.display,
        Action::LoadSetup => menu.load_setup,
        Action::SaveSetup => menu.save_setup,
        _ => help.this_window,
    }
}
