//! Unsaved work that was left behind is offered at the start.

use super::*;
use crate::editor::screenshots::screenshot;

fn start(language: Language, folder: &std::path::Path) -> Window {
    let options = Options {
        folders: Folders {
            setup: None,
            state: Some(folder.to_owned()),
        },
        ..options(language)
    };
    window_of(options, SMALL, 1.0, Theme::Dark)
}

/// A window with unsaved work vanishes.
fn vanish(folder: &std::path::Path, x: f64) {
    let mut window = start(Language::English, folder);
    let editor = window.state_mut();
    editor.windows.rescue = None;
    editor.file = Some("/somewhere/flight.vid".into());
    let position = DVec3::new(x, 0.0, 0.0);
    editor
        .document
        .apply(Edit::SetPosition { at: 0, position })
        .unwrap();
}

fn files(folder: &std::path::Path) -> usize {
    std::fs::read_dir(folder).unwrap().count()
}

#[test]
fn it_is_restored() {
    for language in BOTH {
        let texts = &language.texts().rescue;
        let folder = tempfile::tempdir().unwrap();
        vanish(folder.path(), 0.25);
        let mut window = start(language, folder.path());
        assert!(window.query_by_label(texts.title).is_some());
        assert!(window.query_by_label("flight.vid").is_some());
        screenshot(&mut window, &format!("rescue-{}.png", texts.later));
        click(&mut window, texts.restore);
        let editor = window.state();
        assert_eq!(editor.document.path().points[0].position.x, 0.25);
        assert!(editor.document.is_modified());
        assert_eq!(
            editor.file.as_deref(),
            Some("/somewhere/flight.vid".as_ref())
        );
        assert!(window.query_by_label(texts.title).is_none());
        // Now it is this window's, and survives it too.
        assert_eq!(files(folder.path()), 1);
        drop(window);
        let window = start(language, folder.path());
        assert!(window.query_by_label(texts.title).is_some());
    }
}

#[test]
fn it_is_discarded_or_left_for_later() {
    for language in BOTH {
        let texts = &language.texts().rescue;
        let folder = tempfile::tempdir().unwrap();
        vanish(folder.path(), 0.5);
        for by_key in [true, false] {
            let mut window = start(language, folder.path());
            if by_key {
                press(&mut window, Modifiers::NONE, Key::Escape);
            } else {
                click(&mut window, texts.later);
            }
            assert!(window.query_by_label(texts.title).is_none());
            assert!(!window.state().document.is_modified());
        }
        let mut window = start(language, folder.path());
        click(&mut window, texts.discard);
        assert!(window.query_by_label(texts.title).is_none());
        drop(window);
        assert_eq!(files(folder.path()), 0);
        let window = start(language, folder.path());
        assert!(window.query_by_label(texts.title).is_none());
    }
}

/// An idle window asks for no wake-up, modified or not.
#[test]
fn an_idle_window_sleeps() {
    let folder = tempfile::tempdir().unwrap();
    let mut window = start(Language::English, folder.path());
    let sleeps = |window: &Window| {
        let viewport = window.output().viewport_output.values().next().unwrap();
        viewport.repaint_delay > std::time::Duration::from_secs(60)
    };
    assert!(sleeps(&window));
    let edit = Edit::SetClosed(true);
    window.state_mut().document.apply(edit).unwrap();
    window.step();
    window.step();
    assert!(!sleeps(&window), "the change is to be written");
    std::thread::sleep(std::time::Duration::from_millis(750));
    window.step();
    assert_eq!(files(folder.path()), 1);
    window.step();
    window.step();
    assert!(sleeps(&window));
}

#[test]
fn a_window_that_cannot_keep_its_work_says_so_once() {
    for language in BOTH {
        let folder = tempfile::tempdir().unwrap();
        let blocked = folder.path().join("file");
        std::fs::write(&blocked, "").unwrap();
        let mut window = start(language, &blocked.join("state"));
        let mut said = 0;
        for closed in [true, false] {
            window
                .state_mut()
                .document
                .apply(Edit::SetClosed(closed))
                .unwrap();
            window.state_mut().document.mark_unsaved();
            window.step();
            std::thread::sleep(std::time::Duration::from_millis(750));
            window.step();
            let message = window.state_mut().message.take();
            said += usize::from(message.is_some_and(|message| message.error));
        }
        assert_eq!(said, 1);
    }
}

#[test]
fn tab_goes_through_the_answers_as_they_are_read() {
    let folder = tempfile::tempdir().unwrap();
    vanish(folder.path(), 0.25);
    let mut window = start(Language::English, folder.path());
    let texts = &Language::English.texts().rescue;
    for name in [texts.restore, texts.discard, texts.later, texts.restore] {
        assert!(window.get_by_label(name).is_focused(), "{name}");
        press(&mut window, Modifiers::NONE, Key::Tab);
    }
}
