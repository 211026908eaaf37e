//! The menus by the keyboard: arrows, Alt and a letter, letters within a menu (thesis A.5).

use crate::state::Request;
use crate::tests::*;

#[test]
fn alt_and_a_letter_open_the_menus() {
    for language in BOTH {
        let texts = &language.texts().menu;
        let mut window = window(language);
        for (menu, entries) in [
            (0, vec![texts.load, texts.save, texts.save_as, texts.quit]),
            (1, vec![texts.undo, texts.add_points, texts.aim_all]),
            (2, vec![texts.export, texts.hand_over]),
            (
                4,
                vec![
                    texts.colours,
                    texts.display,
                    texts.load_setup,
                    texts.save_setup,
                ],
            ),
            (5, vec![texts.keys]),
        ] {
            assert!(window.query_by_label(entries[0]).is_none());
            open_menu(&mut window, menu);
            for entry in entries {
                assert!(window.query_by_label(entry).is_some(), "{entry}");
            }
            press(&mut window, Modifiers::NONE, Key::Escape);
        }
        assert!(window.query_by_label(texts.colours).is_none());
    }
}

#[test]
fn the_menus_are_walked_through_by_the_arrow_keys() {
    let texts = &Language::German.texts().menu;
    let mut window = window(Language::German);
    open_menu(&mut window, 0);
    assert!(window.get_by_label(texts.new).is_focused());
    press(&mut window, Modifiers::NONE, Key::ArrowUp);
    assert!(window.get_by_label(texts.quit).is_focused());
    press(&mut window, Modifiers::NONE, Key::ArrowDown);
    press(&mut window, Modifiers::NONE, Key::ArrowDown);
    assert!(window.get_by_label(texts.load).is_focused());
    press(&mut window, Modifiers::NONE, Key::ArrowDown);
    assert!(window.get_by_label(texts.load_object).is_focused());
    press(&mut window, Modifiers::NONE, Key::ArrowDown);
    assert!(window.get_by_label(texts.save).is_focused());
    press(&mut window, Modifiers::NONE, Key::ArrowRight);
    press(&mut window, Modifiers::NONE, Key::ArrowRight);
    assert!(window.get_by_label(texts.export).is_focused());
    press(&mut window, Modifiers::NONE, Key::ArrowLeft);
    press(&mut window, Modifiers::NONE, Key::ArrowLeft);
    press(&mut window, Modifiers::NONE, Key::ArrowLeft);
    assert!(window.get_by_label(texts.keys).is_focused());
    press(&mut window, Modifiers::NONE, Key::Enter);
    assert!(window.state().windows.help.is_some());
    let entry = window.query_by_role_and_label(egui::accesskit::Role::MenuItem, texts.quit);
    assert!(entry.is_none());
}

#[test]
fn f10_opens_the_first_menu_and_shift_f10_does_not() {
    let texts = &Language::English.texts().menu;
    let mut window = window(Language::English);
    press(&mut window, Modifiers::NONE, Key::F10);
    assert!(window.get_by_label(texts.new).is_focused());
    press(&mut window, Modifiers::NONE, Key::Escape);
    press(&mut window, Modifiers::SHIFT, Key::F10);
    assert!(window.query_by_label(texts.load).is_none());
    assert!(window.query_by_label(texts.copy_orientation).is_some());
    press(&mut window, Modifiers::NONE, Key::Escape);
    // Nor does it while another menu is open.
    open_menu(&mut window, 2);
    press(&mut window, Modifiers::SHIFT, Key::F10);
    assert!(window.query_by_label(texts.load).is_none());
}

/// Of the menus' titles the open one alone is highlighted, also where the pointer rests on another.
#[test]
fn one_title_is_highlighted() {
    let texts = &Language::English.texts().menu;
    let mut window = window(Language::English);
    let place = |window: &Window, title: &str| window.get_by_label(title).rect();
    let [file, edit] = [texts.file, texts.edit].map(|title| place(&window, title));
    click(&mut window, texts.file);
    window.hover_at(file.center());
    window.run();
    press(&mut window, Modifiers::NONE, Key::ArrowRight);
    let image = crate::screenshots::screenshot(&mut window, "menu-highlight.png");
    let ground = |rect: egui::Rect| {
        let corner = rect.left_center() + vec2(2.0, 0.0);
        *image.get_pixel(corner.x as u32, corner.y as u32)
    };
    let help = place(&window, texts.help);
    assert_eq!(ground(file), ground(help));
    assert_ne!(ground(edit), ground(help));
}

/// The key that opens a window closes it again; where no path is edited there is no speed curve.
#[test]
fn the_key_that_opens_a_window_closes_it() {
    for language in BOTH {
        let mut window = window(language);
        let open = |window: &Window| {
            let windows = &window.state().windows;
            let speed = windows.speed.is_some();
            [
                windows.help.is_some(),
                windows.curve.is_some(),
                speed,
                windows.check.is_some(),
            ]
        };
        for (at, key) in [Key::F1, Key::F2, Key::F3, Key::F8].into_iter().enumerate() {
            press(&mut window, Modifiers::NONE, key);
            assert!(open(&window)[at], "{key:?}");
            press(&mut window, Modifiers::NONE, key);
            assert_eq!(open(&window), [false; 4], "{key:?}");
        }
        press(&mut window, Modifiers::NONE, Key::F3);
        let light =
            crate::state::scene_view::NodeCommand::Add(crate::state::scene_view::NewNode::Light);
        window.state_mut().do_to_nodes(light);
        window.run();
        assert_eq!(open(&window), [false; 4]);
        press(&mut window, Modifiers::NONE, Key::F3);
        assert_eq!(open(&window), [false; 4]);
        assert_eq!(
            said(&window).as_deref(),
            Some(language.texts().tools.only_path)
        );
    }
}

#[test]
fn a_pointer_at_rest_leaves_the_menus_to_the_keyboard() {
    let texts = &Language::German.texts().menu;
    let mut window = window(Language::German);
    let place = |window: &Window, title: &str| window.get_by_label(title).rect().center();
    click(&mut window, texts.file);
    let on_file = place(&window, texts.file);
    window.hover_at(on_file);
    window.run();
    assert!(window.query_by_label(texts.load).is_some());
    press(&mut window, Modifiers::NONE, Key::ArrowRight);
    assert!(window.query_by_label(texts.load).is_none());
    assert!(window.get_by_label(texts.add_point).is_focused());
    // One that moves chooses.
    let on_output = place(&window, texts.output);
    window.hover_at(on_output);
    window.run();
    assert!(window.query_by_label(texts.export).is_some());
    assert!(window.query_by_label(texts.undo).is_none());
}

#[test]
fn the_thesis_shortcuts_do_what_the_menus_do() {
    for language in BOTH {
        let opened = |key: Key| {
            let options = Options {
                fixed_speeds: true,
                ..options(language)
            };
            let mut window = window_of(options, LARGE, 1.0, Theme::Dark);
            press(&mut window, Modifiers::ALT, key);
            window
        };
        let texts = &language.texts().files;
        let shows = |window: &Window, title: &str| window.query_by_label(title).is_some();
        assert!(shows(&opened(Key::L), texts.load_path));
        assert!(shows(&opened(Key::S), texts.save_path));
        assert!(shows(&opened(Key::T), texts.load_setup));
        assert!(shows(&opened(Key::P), texts.save_setup));
        assert!(opened(Key::F).state().windows.colours.is_some());
        assert!(opened(Key::Z).state().windows.display.is_some());
        assert_eq!(
            opened(Key::U).state_mut().next_request(),
            Some(Request::HandOver)
        );
        assert_eq!(
            opened(Key::F4).state_mut().next_request(),
            Some(Request::Close)
        );
        // Its menus; in English, E is the edit menu's.
        let menu = &language.texts().menu;
        assert!(shows(&opened(Key::D), menu.load));
        assert!(shows(&opened(Key::A), menu.hand_over));
        let fifth = match language {
            Language::German => menu.colours,
            Language::English => menu.aim_all,
        };
        assert!(shows(&opened(Key::E), fifth));
    }
}

#[test]
fn d_in_the_open_output_menu_writes_to_a_file() {
    let keys = [Modifiers::NONE, Modifiers::ALT];
    for (modifiers, language) in keys
        .into_iter()
        .flat_map(|keys| BOTH.map(|one| (keys, one)))
    {
        let mut window = window(language);
        press(&mut window, Modifiers::ALT, Key::A);
        press(&mut window, modifiers, Key::D);
        let texts = language.texts();
        assert!(window.query_by_label(texts.files.export).is_some());
        assert!(window.query_by_label(texts.menu.load).is_none());
    }
}

#[test]
fn every_key_stands_in_the_help() {
    for language in BOTH {
        let mut window = window(language);
        press(&mut window, Modifiers::NONE, Key::F1);
        let of_menu = (language == Language::English).then_some((Modifiers::ALT, Key::F));
        for &(modifiers, key, _) in crate::keys::SHORTCUTS {
            if of_menu == Some((modifiers, key)) {
                continue;
            }
            let words = crate::keys::combination(language, modifiers, key);
            assert!(
                window.query_all_by_label(&words).next().is_some(),
                "{words}"
            );
        }
    }
}

/// In each language, whatever there is to undo or is selected.
#[test]
fn no_two_entries_of_a_menu_and_no_two_menus_have_one_key() {
    for language in BOTH {
        let mut window = window_with_points(language, LARGE, 1.0, Theme::Dark);
        for round in 0..3 {
            let menus = super::menus(window.state());
            let mut opens = menus.each_ref().map(|menu| menu.letter);
            opens.sort();
            assert!(opens.windows(2).all(|pair| pair[0] != pair[1]), "{opens:?}");
            for menu in &menus {
                assert!(
                    super::letters::is_in(menu.letter, menu.title),
                    "{}",
                    menu.title
                );
                let mut letters = Vec::new();
                for entry in &menu.entries {
                    let Some(letter) = entry.letter else {
                        let mut own = entry.text.chars().filter_map(super::letters::key_of);
                        let all: Vec<_> = menu.entries.iter().map(|other| other.letter).collect();
                        assert!(own.all(|key| all.contains(&Some(key))), "{}", entry.text);
                        continue;
                    };
                    assert!(
                        super::letters::is_in(letter, &entry.text),
                        "{letter:?}: {}",
                        entry.text
                    );
                    assert!(!letters.contains(&letter), "{letter:?}: {}", entry.text);
                    letters.push(letter);
                }
            }
            // What opens a menu is no other shortcut.
            for (number, menu) in menus.iter().enumerate() {
                open_menu(&mut window, number);
                let open = super::names(window.state(), number);
                let (_, last) = open.last().expect("entries");
                assert!(window.query_by_label(last).is_some(), "{}", menu.title);
                assert!(
                    window.state().windows.front().is_none() && !window.state().windows.has_modal()
                );
                press(&mut window, Modifiers::NONE, Key::Escape);
            }
            match round {
                0 => window.state_mut().edit(Edit::AppendAfterLast),
                _ => window.state_mut().document.undo(),
            };
            window.run();
        }
    }
}

#[test]
fn the_letters_are_underlined_and_pick() {
    for language in BOTH {
        let mut window = window(language);
        open_menu(&mut window, 0);
        let shapes = window.output().shapes.iter();
        let sections = shapes.flat_map(|clipped| match &clipped.shape {
            egui::Shape::Text(text) => text.galley.job.sections.clone(),
            _ => Vec::new(),
        });
        let lined = sections.filter(|section| section.format.underline.width > 0.0);
        // Six titles, eight entries.
        assert_eq!(lined.count(), 14);
        window.state_mut().edit(Edit::AppendAfterLast);
        press(&mut window, Modifiers::NONE, Key::N);
        let question = language.texts().questions.unsaved;
        assert!(window.query_by_label(question).is_some());
    }
}
