//! All keys and what the mouse does (F1).

use std::borrow::Cow;

use egui::{Grid, Key, Modifiers, ScrollArea};

use super::{SubWindow, Windows, sub_window};
use crate::actions::Action;
use crate::keys::{SHORTCUTS, combination};
use crate::menu;
use crate::space;
use crate::state::Editor;
use crate::texts::{Language, fill};
use crate::theme;

const KEYS: f32 = 232.0;

#[derive(Debug)]
pub(crate) struct HelpWindow {}

impl SubWindow for HelpWindow {
    const ID: &'static str = "help";

    fn slot(windows: &mut Windows) -> &mut Option<Self> {
        &mut windows.help
    }

    fn new(_: &Editor) -> Self {
        Self {}
    }

    fn show(&mut self, editor: &Editor, context: &egui::Context, _: &mut Vec<Action>) -> bool {
        let texts = &editor.texts().help;
        let screen = context.content_rect().size();
        let height = (screen.y - 120.0).max(160.0);
        let column = ((screen.x - 100.0) / 2.0).max(KEYS);
        sub_window(context, Self::ID, texts.title, |ui| {
            ScrollArea::vertical().max_height(height).show(ui, |ui| {
                for (heading, rows) in sections(editor.language()) {
                    let palette = theme::palette(ui);
                    ui.add_space(4.0);
                    ui.colored_label(palette.accent, heading);
                    Grid::new(heading)
                        .num_columns(2)
                        .spacing([16.0, 4.0])
                        .min_col_width(KEYS)
                        .max_col_width(column)
                        .show(ui, |ui| {
                            for (keys, meaning) in rows {
                                ui.label(keys);
                                let meaning = egui::RichText::new(&*meaning);
                                ui.add(egui::Label::new(meaning.color(palette.weak)).wrap());
                                ui.end_row();
                            }
                        });
                    ui.add_space(4.0);
                }
            });
        })
    }
}

/// Keys or what the mouse does, and the meaning.
type Row = (String, Cow<'static, str>);

fn sections(language: Language) -> [(&'static str, Vec<Row>); 5] {
    let texts = &language.texts().help;
    let row = |keys: &str, meaning: &'static str| (keys.to_owned(), meaning.into());
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
        row(texts.drop, texts.drop_meaning),
    ];
    let others = space::shortcut_help(language.texts());
    mouse.extend(others.map(|(hand, meaning)| row(hand, meaning)));
    let shortcuts = SHORTCUTS
        .iter()
        .map(|(modifiers, key, action)| {
            (
                combination(language, *modifiers, *key),
                meaning(language, action).into(),
            )
        })
        .collect();
    let mut menus = vec![
        (plain(Key::F10), texts.first_menu.into()),
        row(texts.arrows, texts.arrows_meaning),
        (
            menu::in_menu(language, Key::A, Key::D),
            texts.d_meaning.into(),
        ),
    ];
    let opened = menu::letters(language.texts()).map(|(letter, title)| {
        let keys = combination(language, Modifiers::ALT, letter);
        (keys, fill(texts.open_menu, &[&title]).into())
    });
    menus.splice(0..0, opened);
    let fields = vec![
        row(texts.drag, texts.drag_meaning),
        row(texts.click, texts.click_meaning),
        row(texts.enter, texts.enter_meaning),
        row(texts.escape, texts.escape_meaning),
        row(texts.up_down, texts.up_down_meaning),
        row(texts.tab, texts.tab_meaning),
    ];
    let speed = vec![
        row(texts.squares, texts.squares_meaning),
        row(texts.on_way, texts.on_way_meaning),
        row(texts.way_key, texts.way_key_meaning),
    ];
    [
        (texts.mouse, mouse),
        (texts.shortcuts, shortcuts),
        (texts.menus, menus),
        (language.texts().speed_window.title, speed),
        (texts.fields, fields),
    ]
}

/// What an action does: the words of its menu entry.
fn meaning(language: Language, action: &Action) -> &'static str {
    let texts = language.texts();
    let (menu, help, space) = (&texts.menu, &texts.help, &texts.space);
    match action {
        Action::Load => menu.load,
        Action::Save => menu.save,
        Action::SaveAs => menu.save_as,
        Action::Quit => menu.quit,
        Action::Undo => menu.undo,
        Action::Redo => menu.redo,
        Action::AddPoint => menu.add_point,
        Action::AddHere => texts.position.add_here,
        Action::AskPoints => menu.add_points,
        Action::RemovePoint => menu.remove_point,
        Action::Choose(_) => space.all_points,
        Action::NextPoint => texts.position.next_hint,
        Action::PreviousPoint => texts.position.previous_hint,
        Action::AddOrientation => menu.add_orientation,
        Action::RemoveOrientation => menu.remove_orientation,
        Action::NextOrientation => texts.orientation.next_hint,
        Action::PreviousOrientation => texts.orientation.previous_hint,
        Action::SwitchAbsolute => help.absolute,
        Action::AimAll => menu.aim_all,
        Action::TakeOver { replace: false } => space.take_over,
        Action::TakeOver { replace: true } => space.take_over_here,
        Action::SwitchHandsOver => menu.hands_over,
        Action::Curve => texts.curve.title,
        Action::SpeedCurve => texts.speed_window.title,
        Action::SwitchCameraView => space.camera_meaning,
        Action::PlayOrPause => space.play_meaning,
        Action::Copy => help.copy,
        Action::Cut => menu.cut,
        Action::Paste => help.paste,
        Action::HandOver => menu.hand_over,
        Action::Colours => menu.colours,
        Action::Display => menu.display,
        Action::LoadSetup => menu.load_setup,
        Action::SaveSetup => menu.save_setup,
        _ => help.this_window,
    }
}
