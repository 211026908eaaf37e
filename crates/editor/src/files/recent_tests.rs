//! Recent files in the File menu.

use vides_document::At;

use crate::tests::*;

#[test]
fn recent_files_are_in_the_menu_and_load() {
    for language in BOTH {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        let start = || {
            let options = Options {
                folders: Folders {
                    state: Some(at("state")),
                    ..Folders::default()
                },
                ..options(language)
            };
            window_of(options, SMALL, 1.0, Theme::Dark)
        };
        let mut window = start();
        let closed = Edit::set(At::Path, "closed", true);
        window.state_mut().document.apply(closed).unwrap();
        for name in ["one.vid", "two.vid", "sub/one.vid", "gone.vid"] {
            std::fs::create_dir_all(at(name).parent().unwrap()).unwrap();
            window.state_mut().save_path(&at(name)).unwrap();
        }
        for number in 0..6 {
            let name = format!("more {number}.vid");
            window.state_mut().save_path(&at(&name)).unwrap();
        }
        window.state_mut().load_path(&at("two.vid")).unwrap();
        assert_eq!(window.state().recent.len(), 8, "at most");
        window.state_mut().save_path(&at("one.vid")).unwrap();
        std::fs::remove_file(at("gone.vid")).unwrap();
        drop(window);

        // The next window knows them, without the one that is gone.
        let mut window = start();
        let names = window.state().recent_names();
        assert_eq!(names[..3], ["one.vid", "two.vid", "more 5.vid"]);
        assert!(!names.contains(&"gone.vid".to_owned()));
        open_menu(&mut window, 0);
        click(&mut window, "two.vid");
        assert_eq!(
            window.state().file.as_deref(),
            Some(at("two.vid").as_path())
        );
        assert!(window.state().document.path().closed);
        assert_eq!(window.state().recent_names()[0], "two.vid");

        // Unsaved work is asked about first.
        window
            .state_mut()
            .document
            .apply(Edit::set(At::Path, "closed", false))
            .unwrap();
        window.run();
        open_menu(&mut window, 0);
        click(&mut window, "one.vid");
        let texts = &language.texts().questions;
        assert!(window.query_by_label(texts.unsaved).is_some());
        click(&mut window, texts.discard);
        assert_eq!(
            window.state().file.as_deref(),
            Some(at("one.vid").as_path())
        );

        // Two of the same name are told apart.
        window.state_mut().note_file(&at("sub/one.vid"));
        let names = window.state().recent_names();
        assert_eq!(names[0], "one.vid (sub)");
        // One that vanished meanwhile is a message.
        std::fs::remove_file(at("two.vid")).unwrap();
        open_menu(&mut window, 0);
        click(&mut window, "two.vid");
        let message = window.state().message.clone().unwrap();
        assert!(message.error && message.text.contains("two.vid"));
    }
}

#[test]
fn a_link_in_place_of_the_list_is_not_followed() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    std::fs::create_dir(at("state")).unwrap();
    std::fs::write(at("precious"), "kept").unwrap();
    std::os::unix::fs::symlink(at("precious"), at("state/recent")).unwrap();
    let options = Options {
        folders: Folders {
            state: Some(at("state")),
            ..Folders::default()
        },
        ..options(Language::English)
    };
    let mut window = window_of(options, SMALL, 1.0, Theme::Dark);
    window.state_mut().save_path(&at("one.vid")).unwrap();
    assert!(window.state().recent.is_empty());
    assert_eq!(std::fs::read_to_string(at("precious")).unwrap(), "kept");
}
