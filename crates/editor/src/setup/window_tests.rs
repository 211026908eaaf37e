//! The colour and display windows and the setup file (thesis A.5, A.9).

use egui::Color32;

use crate::screenshots::screenshot;
use crate::setup::{Element, Setup};
use crate::tests::*;

#[test]
fn an_element_is_chosen_and_three_sliders_mix_its_colour() {
    for language in BOTH {
        let texts = &language.texts().colours;
        let mut window = window(language);
        let as_new = window.state().setup.clone();
        open_menu(&mut window, 4);
        click(&mut window, language.texts().menu.colours);
        click(&mut window, language.texts().display.curve);
        let first = window.state().setup.colours().of(Element::Curve);
        for (name, text) in [(texts.red, "10"), (texts.green, "20"), (texts.blue, "256")] {
            enter(&mut window, name, text);
        }
        let colour = window.state().setup.colours().of(Element::Curve);
        assert_eq!(
            colour,
            Color32::from_rgb(10, 20, first.b()),
            "256 is refused"
        );
        window
            .get_by_role_and_label(Role::Slider, texts.red)
            .focus();
        window.run();
        press(&mut window, Modifiers::NONE, Key::ArrowRight);
        assert_eq!(window.state().setup.colours().of(Element::Curve).r(), 11);
        click(&mut window, texts.reset);
        assert_eq!(window.state().setup, as_new);
        // No change of the path: nothing to be saved with it.
        assert!(!window.state().document.is_modified());
    }
}

#[test]
fn each_element_is_switched_off_and_on() {
    for language in BOTH {
        let texts = &language.texts().display;
        let mut window = window(language);
        let as_new = window.state().setup.clone();
        press(&mut window, Modifiers::ALT, Key::Z);
        for element in Element::ALL.into_iter().filter(|e| e.has_switch()) {
            for on in [false, true] {
                window
                    .get_by_role_and_label(Role::CheckBox, texts.name(element))
                    .click();
                window.run();
                assert_eq!(window.state().setup.shown.has(element), on, "{element:?}");
            }
        }
        window
            .get_by_role_and_label(Role::CheckBox, texts.cube)
            .click();
        window.run();
        click(&mut window, texts.all);
        assert_eq!(window.state().setup, as_new);
    }
}

#[test]
fn the_language_is_chosen_and_kept() {
    let folder = tempfile::tempdir().unwrap();
    let start = |language| {
        let options = Options {
            folders: Folders {
                setup: Some(folder.path().to_owned()),
                ..Folders::default()
            },
            ..options(language)
        };
        window_of(options, SMALL, 1.0, Theme::Dark)
    };
    let mut window = start(Language::English);
    open_menu(&mut window, 4);
    // At once, in all of the window.
    click(&mut window, "Deutsch");
    assert!(window.query_by_label("Datei").is_some());
    assert!(window.query_by_label("Bearbeiten").is_some());
    let file = folder.path().join("other.toml");
    window.state_mut().save_setup(&file).unwrap();
    // At the next start, too, without a word of the setup.
    let mut window = start(Language::English);
    assert!(window.query_by_label("Datei").is_some());
    open_menu(&mut window, 4);
    click(&mut window, "Sprache: automatisch");
    assert!(window.query_by_label("File").is_some());
    // A setup that is loaded brings its language.
    window.state_mut().load_setup(&file).unwrap();
    window.run();
    assert!(window.query_by_label("Datei").is_some());
}

/// By the menu; whatever else stands in the setup file stays as it
/// is written there.
#[test]
fn the_theme_chosen_is_that_of_the_next_start() {
    for language in BOTH {
        let menu = &language.texts().menu;
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("deep/setup.toml");
        let start = || {
            let options = Options {
                folders: Folders {
                    setup: Some(folder.path().join("deep")),
                    ..Folders::default()
                },
                ..options(language)
            };
            Editor::new(options).unwrap()
        };
        let choose = |name: &str| {
            let mut window = window_of_editor(start(), SMALL, 1.0);
            open_menu(&mut window, 4);
            click(&mut window, name);
            assert!(
                !window
                    .state()
                    .message
                    .as_ref()
                    .is_some_and(|said| said.error)
            );
        };
        choose(menu.light);
        assert_eq!(start().setup.theme, Some(Theme::Light));
        choose(menu.dark);
        assert_eq!(start().setup.theme, Some(Theme::Dark));
        assert_eq!(
            std::fs::read_to_string(&file).unwrap(),
            "theme = \"dark\"\nversion = 1\n"
        );
        let by_hand = "# mine\nversion = 1\ntheme = 'dark' # at night\n[view]\nsize = 2\n";
        std::fs::write(&file, by_hand).unwrap();
        choose(menu.as_system);
        let kept = by_hand.replace("'dark'", "\"system\"");
        assert_eq!(std::fs::read_to_string(&file).unwrap(), kept);
        assert_eq!(start().setup.theme, None);
        assert_eq!(start().setup.view.size, 2.0);
        // One that is not understood is not touched, and that is said.
        std::fs::write(&file, "theme = 3\n").unwrap();
        let mut editor = start();
        editor.choose_theme(Some(Theme::Light));
        let said = editor.message.clone().unwrap();
        assert!(
            said.error && said.text.contains("setup.toml"),
            "{}",
            said.text
        );
        assert_eq!(std::fs::read_to_string(&file).unwrap(), "theme = 3\n");
        assert_eq!(editor.setup.theme(), Theme::Light);
    }
}

/// What is switched off is not seen any more.
#[test]
fn the_cube_is_gone_from_the_picture() {
    let mut window = window_with_points(Language::German, SMALL, 1.0, Theme::Dark);
    let colour = window.state().setup.colours().of(Element::Cube);
    let count = |window: &mut Window| {
        let image = window.render().unwrap();
        let same = |p: &&image::Rgba<u8>| p.0[..3] == colour.to_array()[..3];
        image.pixels().filter(same).count()
    };
    let with = count(&mut window);
    window.state_mut().setup.shown.set(Element::Cube, false);
    window.run();
    let without = count(&mut window);
    assert!(with > without + 100, "{with} {without}");
}

#[test]
fn the_setup_is_read_at_start() {
    let folder = tempfile::tempdir().unwrap();
    let folders = || Folders {
        setup: Some(folder.path().to_owned()),
        ..Folders::default()
    };
    let start = |language| {
        let options = Options {
            folders: folders(),
            ..options(language)
        };
        Editor::new(options).unwrap()
    };
    // None there: nothing to be said.
    let mut editor = start(Language::German);
    assert!(editor.message.is_none());
    editor.setup.theme = Some(Theme::Light);
    editor.setup.view.tilt = 33.0;
    editor.setup.shown.set(Element::Cube, false);
    editor
        .save_setup(&folder.path().join("setup.toml"))
        .unwrap();
    let again = start(Language::German);
    assert_eq!(again.setup, editor.setup);
    // A broken one: said so, and all as in a new window.
    std::fs::write(
        folder.path().join("setup.toml"),
        "theme = \"dark\"\ncolor = 3\n",
    )
    .unwrap();
    for language in BOTH {
        let broken = start(language);
        assert_eq!(broken.setup, Setup::default());
        let message = broken.message.clone().unwrap();
        assert!(message.error && message.text.contains("setup.toml"));
        let why = match language {
            Language::English => "line 2: unknown key \"color\"",
            Language::German => "Zeile 2: unbekannter Schlüssel „color“",
        };
        assert!(message.text.contains(why), "{}", message.text);
    }
}

#[test]
fn a_setup_is_saved_and_loaded_by_the_menu() {
    for language in BOTH {
        let folder = tempfile::tempdir().unwrap();
        let options = Options {
            folders: Folders {
                setup: Some(folder.path().to_owned()),
                ..Folders::default()
            },
            ..options(language)
        };
        let mut window = window_of(options, LARGE, 1.0, Theme::Light);
        press(&mut window, Modifiers::ALT, Key::P);
        window
            .get_by_role_and_label(Role::Button, language.texts().files.save)
            .click();
        window.run();
        let file = folder.path().join("setup.toml");
        assert!(file.is_file(), "the proposal is setup.toml in its folder");
        window.state_mut().setup = Setup::default();
        open_menu(&mut window, 4);
        click(&mut window, language.texts().menu.load_setup);
        click(&mut window, "setup.toml");
        window
            .get_by_role_and_label(Role::Button, language.texts().files.load)
            .click();
        window.run();
        assert_eq!(window.state().setup.theme, Some(Theme::Light));
    }
}

#[test]
fn pictures() {
    for (language, theme, scale, name) in LOOKS {
        let menu = &language.texts().menu;
        for (entry, which) in [(menu.colours, "colours"), (menu.display, "display")] {
            let mut window = window_with_points(language, SMALL, scale, theme);
            open_menu(&mut window, 4);
            click(&mut window, entry);
            screenshot(&mut window, &format!("{which}-{name}.png"));
        }
    }
}

#[test]
fn light_and_dark_are_the_desktops_unless_chosen() {
    let mut window = window(Language::English);
    let dark = |window: &Window| {
        let visuals = window.ctx.global_style().visuals.dark_mode;
        let ground = window.state().background();
        assert_eq!(ground.r() < 128, visuals);
        visuals
    };
    let desktop = |window: &mut Window, theme| {
        window.input_mut().system_theme = Some(theme);
        window.run();
    };
    window.state_mut().setup.theme = None;
    desktop(&mut window, egui::Theme::Light);
    assert!(!dark(&window));
    desktop(&mut window, egui::Theme::Dark);
    assert!(dark(&window));
    open_menu(&mut window, 4);
    click(&mut window, "Light");
    assert!(!dark(&window));
    desktop(&mut window, egui::Theme::Light);
    open_menu(&mut window, 4);
    click(&mut window, "Dark");
    assert!(dark(&window));
    // A setup that chooses nothing leaves it to the desktop, which is known.
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("setup.toml");
    std::fs::write(&file, "theme = \"system\"\n").unwrap();
    window.state_mut().load_setup(&file).unwrap();
    window.run();
    assert!(!dark(&window));
    open_menu(&mut window, 4);
    click(&mut window, "As the system");
    assert!(!dark(&window));
}
