//! All keys and what the mouse does (F1).

use std::borrow::Cow;

use egui::{Grid, Key, Modifiers, ScrollArea, vec2};

use crate::action::{Action, FileAction, PathAction, TimeAction};
use crate::keys::{SHORTCUTS, combination};
use crate::state::Editor;
use crate::state::windows::{HelpWindow, Windows};
use crate::texts::{Language, fill};
use crate::windows::sub_window::{SubWindow, sub_window};
use crate::{menu, space, theme};

const KEYS: f32 = 232.0;

/// Width of the field for the words that are looked for.
const SEARCH: f32 = 320.0;

/// More pages than there are.
const ALL: f32 = 1e3;

impl SubWindow for HelpWindow {
    const ID: &'static str = "help";

    fn slot(windows: &mut Windows) -> &mut Option<Self> {
        &mut windows.help
    }

    fn new(_: &Editor) -> Self {
        Self {
            pages: 0.0,
            search: String::new(),
        }
    }

    fn show(&mut self, editor: &Editor, context: &egui::Context, _: &mut Vec<Action>) -> bool {
        let texts = &editor.texts().help;
        let screen = context.content_rect().size();
        let height = (screen.y - 120.0).max(160.0);
        let column = ((screen.x - 100.0) / 2.0).max(KEYS);
        sub_window(context, Self::ID, texts.title, |ui| {
            let words = (texts.search, texts.search_hint);
            ui.horizontal(|ui| {
                ui.label(texts.search);
                theme::line_edit(ui, &mut self.search, "help.search", SEARCH, words);
            });
            let wanted = self.search.trim().to_lowercase();
            let fits = |(keys, meaning): &Row| {
                let says = |words: &str| words.to_lowercase().contains(&wanted);
                says(keys) || says(meaning)
            };
            ScrollArea::vertical().max_height(height).show(ui, |ui| {
                ui.set_min_width(SEARCH);
                let pages = std::mem::take(&mut self.pages);
                ui.scroll_with_delta(vec2(0.0, -0.9 * pages * height));
                for (heading, rows) in sections(editor.language(), editor.fixed_speeds) {
                    let all = heading.to_lowercase().contains(&wanted);
                    let rows: Vec<Row> = rows.into_iter().filter(|row| all || fits(row)).collect();
                    if rows.is_empty() {
                        continue;
                    }
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

impl HelpWindow {
    /// Takes the keys that scroll it, which would move points or nodes.
    pub(super) fn take_keys(&mut self, context: &egui::Context) {
        for (key, pages) in [
            (Key::PageUp, -1.0),
            (Key::PageDown, 1.0),
            (Key::Home, -ALL),
            (Key::End, ALL),
        ] {
            if context.input_mut(|input| input.consume_key(Modifiers::NONE, key)) {
                self.pages += pages;
            }
        }
    }
}

/// Keys or what the mouse does, and the meaning.
type Row = (String, Cow<'static, str>);

fn sections(language: Language, of_1994: bool) -> [(&'static str, Vec<Row>); 6] {
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
        // Those that open menus are told there.
        .filter(|(modifiers, key, _)| {
            let mut menus = menu::letters(language, of_1994).into_iter();
            *modifiers != Modifiers::ALT || menus.all(|(letter, _)| letter != *key)
        })
        .map(|(modifiers, key, action)| {
            (
                combination(language, *modifiers, *key),
                meaning(language, action),
            )
        })
        .collect();
    let mut menus = vec![
        (plain(Key::F10), texts.first_menu.into()),
        row(texts.arrows, texts.arrows_meaning),
        row(texts.letter, texts.letter_meaning),
    ];
    let opened = menu::letters(language, of_1994).map(|(letter, title)| {
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
    let scene = &language.texts().scene;
    let nodes = vec![
        row(texts.several, texts.several_meaning),
        (
            format!("{}, {}", texts.rename, plain(Key::F2)),
            texts.rename_meaning.into(),
        ),
        row(texts.put_into, texts.put_into_meaning),
        (plain(Key::Delete), texts.remove_meaning.into()),
        (
            combination(language, Modifiers::CTRL, Key::D),
            texts.copy_meaning.into(),
        ),
        (
            [Key::C, Key::X, Key::V]
                .map(|key| combination(language, Modifiers::CTRL, key))
                .join(", "),
            texts.clipboard_meaning.into(),
        ),
        (
            combination(language, Modifiers::CTRL, Key::A),
            texts.all_meaning.into(),
        ),
        row(texts.tree, texts.tree_meaning),
    ];
    [
        (texts.mouse, mouse),
        (texts.shortcuts, shortcuts),
        (texts.menus, menus),
        (language.texts().speed_window.title, speed),
        (scene.list, nodes),
        (texts.fields, fields),
    ]
}

/// What an action does, in the words of the window: those of its menu entry, else of its button.
pub(crate) fn meaning(language: Language, action: &Action) -> Cow<'static, str> {
    let texts = language.texts();
    let (menu, space) = (&texts.menu, &texts.space);
    let (position, orientation) = (&texts.position, &texts.orientation);
    let button = |name: &str, does: &str| format!("{name} · {does}").into();
    match action {
        Action::File(FileAction::New) => menu.new.into(),
        Action::File(FileAction::Load) => menu.load.into(),
        Action::File(FileAction::Save) => menu.save.into(),
        Action::File(FileAction::SaveAs) => menu.save_as.into(),
        Action::File(FileAction::Export) => menu.export.into(),
        Action::File(FileAction::Quit) => menu.quit.into(),
        Action::Undo => menu.undo.into(),
        Action::Redo => menu.redo.into(),
        Action::Path(PathAction::AddPoint) => menu.add_point.into(),
        Action::Path(PathAction::AddPointOtherwise) => menu.add_copy.into(),
        Action::Path(PathAction::AddHere) => button(position.add_here, position.add_here_hint),
        Action::Path(PathAction::AskPoints) => menu.add_points.into(),
        Action::Path(PathAction::RemovePoint) => menu.remove_point.into(),
        Action::Choose(_) => space.all_points.into(),
        Action::Path(PathAction::SwitchClosed) => menu.close.into(),
        Action::Path(PathAction::NextPoint) => position.next_hint.into(),
        Action::Path(PathAction::PreviousPoint) => position.previous_hint.into(),
        Action::Path(PathAction::AddOrientation) => menu.add_orientation.into(),
        Action::Path(PathAction::RemoveOrientation) => menu.remove_orientation.into(),
        Action::Path(PathAction::NextOrientation) => orientation.next_hint.into(),
        Action::Path(PathAction::PreviousOrientation) => orientation.previous_hint.into(),
        Action::Path(PathAction::SwitchAbsolute) => fill(
            texts.help.absolute,
            &[&orientation.absolute, &orientation.relative],
        )
        .into(),
        Action::Path(PathAction::AimAll) => menu.aim_all.into(),
        Action::Check => texts.check.menu.into(),
        Action::Path(PathAction::TakeOver { replace: false }) => space.take_over.into(),
        Action::Path(PathAction::TakeOver { replace: true }) => space.take_over_here.into(),
        Action::SwitchHandsOver => menu.hands_over.into(),
        Action::Curve => button(texts.curve.title, position.change_hint),
        Action::SpeedCurve => menu.speeds.into(),
        Action::SwitchCameraView => space.camera_meaning.into(),
        Action::Time(TimeAction::PlayOrPause) => space.play_meaning.into(),
        Action::Copy => button(menu.copy_orientation, texts.help.copy),
        Action::Cut => menu.cut.into(),
        Action::Paste => button(menu.paste, texts.help.paste),
        Action::HandOver => menu.hand_over.into(),
        Action::Colours => menu.colours.into(),
        Action::Display => menu.display.into(),
        Action::File(FileAction::LoadSetup) => menu.load_setup.into(),
        Action::File(FileAction::SaveSetup) => menu.save_setup.into(),
        Action::Node(_) => texts.node.set_keys.into(),
        _ => menu.keys.into(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tests::*;

    /// What stands in a menu or on a button is called so here, too.
    #[test]
    fn it_speaks_the_words_of_the_window() {
        for language in BOTH {
            let texts = language.texts();
            let mut window = window(language);
            let mut entries = 0;
            for (at, (letter, title)) in menu::letters(language, false).into_iter().enumerate() {
                let named = menu::names(window.state(), at);
                for (action, name) in named {
                    let known = SHORTCUTS.iter().any(|(.., known)| *known == action);
                    if known {
                        entries += 1;
                        let here = meaning(language, &action);
                        assert_eq!(here.split(" · ").next(), Some(&*name), "{title}");
                    }
                }
                let rows = sections(language, false);
                let opens = combination(language, Modifiers::ALT, letter);
                assert!(rows.iter().any(|(_, rows)| {
                    rows.iter()
                        .any(|(keys, meaning)| *keys == opens && meaning.contains(title))
                }));
            }
            assert!(entries >= 20, "{entries}");
            let absolute = meaning(language, &Action::Path(PathAction::SwitchAbsolute));
            for button in [texts.orientation.absolute, texts.orientation.relative] {
                assert!(
                    absolute.contains(button) && window.query_all_by_label(button).next().is_some()
                );
            }
            for (meaning, button) in [
                (texts.space.loop_meaning, texts.space.again),
                (texts.space.speed_graph_meaning, texts.space.speed_graph),
                (texts.space.camera_meaning, texts.space.camera_view),
            ] {
                let meaning = meaning.to_lowercase();
                assert!(meaning.contains(&button.to_lowercase()), "{meaning}");
                let mut there = window.query_all_by_label(button);
                assert!(there.next().is_some(), "{button}");
            }
            // Its own windows are titled as here.
            press(&mut window, Modifiers::NONE, Key::F1);
            assert!(window.query_all_by_label(texts.menu.keys).next().is_some());
        }
    }
}
