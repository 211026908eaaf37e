//! Unsaved work that was left behind is offered at the start.

use vides_document::At;

use crate::screenshots::screenshot;
use crate::tests::*;

fn start(language: Language, folder: &std::path::Path) -> Window {
    start_of(Program::of_tests("xflight"), language, folder)
}

fn start_of(program: Program, language: Language, folder: &std::path::Path) -> Window {
    let theme = match language {
        Language::English => Theme::Light,
        Language::German => Theme::Dark,
    };
    let options = Options {
        folders: Folders {
            state: Some(folder.to_owned()),
            ..Folders::default()
        },
        program,
        ..options(language)
    };
    window_of(options, SMALL, 1.0, theme)
}

/// A window with unsaved work vanishes.
fn vanish(folder: &std::path::Path, x: f64) {
    let mut window = start(Language::English, folder);
    let editor = window.state_mut();
    editor.windows.recovery = None;
    editor.file = Some("/somewhere/flight.vid".into());
    let position = DVec3::new(x, 0.0, 0.0);
    editor
        .document
        .apply(Edit::set(At::Point(0), "position", position))
        .unwrap();
}

fn files(folder: &std::path::Path) -> usize {
    std::fs::read_dir(folder).unwrap().count()
}

#[test]
fn it_is_restored() {
    for language in BOTH {
        let texts = &language.texts().recovery;
        let folder = work_folder();
        vanish(folder.path(), 0.25);
        let mut window = start(language, folder.path());
        assert!(window.query_by_label(texts.title).is_some());
        let date = match language {
            Language::English => "2026-03-09, 14:05",
            Language::German => "09.03.2026, 14:05",
        };
        for said in ["flight.vid", "xflight", date, texts.just_now, texts.picture] {
            assert!(window.query_by_label(said).is_some(), "{said}");
        }
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
        let texts = &language.texts().recovery;
        let folder = work_folder();
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
        assert_eq!(files(folder.path()), 1);
        click(&mut window, texts.discard_now);
        assert!(window.query_by_label(texts.title).is_none());
        drop(window);
        assert_eq!(files(folder.path()), 0);
        let window = start(language, folder.path());
        assert!(window.query_by_label(texts.title).is_none());
    }
}

/// What is offered stands beside the work, and waits as long as it likes.
#[test]
fn nothing_waits_for_an_answer() {
    let folder = work_folder();
    vanish(folder.path(), 0.5);
    let mut window = start(Language::English, folder.path());
    let texts = Language::English.texts();
    let offers = |window: &Window| window.query_by_label(texts.recovery.title).is_some();
    assert!(offers(&window));
    press(&mut window, Modifiers::ALT, Key::U);
    let request = window.state_mut().next_request();
    assert_eq!(request, Some(crate::Request::HandOver));
    press(&mut window, Modifiers::NONE, Key::Insert);
    assert_eq!(window.state().document.path().points.len(), 3);
    assert!(offers(&window));
    // It would take the place of work: that is asked about like any other.
    click(&mut window, texts.recovery.restore);
    assert!(window.query_by_label(texts.questions.unsaved).is_some());
    press(&mut window, Modifiers::NONE, Key::Escape);
    assert_eq!(window.state().document.path().points.len(), 3);
    assert!(offers(&window));
    click(&mut window, texts.recovery.restore);
    // Of the two with this name the question's lies above.
    let answer = window.get_all_by_label(texts.questions.discard).last();
    answer.expect("an answer").click();
    window.run();
    assert_eq!(window.state().document.path().points[0].position.x, 0.5);
    assert!(!offers(&window));
    // Its own work is all there is now.
    assert_eq!(files(folder.path()), 1);
}

/// Each program is offered its own work, the command all there is.
#[test]
fn work_is_offered_to_the_program_that_it_was_made_in() {
    let folder = work_folder();
    vanish(folder.path(), 0.5);
    let mut other = start_of(Program::of_tests("other"), Language::English, folder.path());
    assert!(other.state().windows.recovery.is_none());
    let edit = Edit::set(At::Path, "closed", true);
    other.state_mut().document.apply(edit).unwrap();
    drop(other);
    assert_eq!(files(folder.path()), 2);
    let mut command = Program::of_tests("vides");
    command.offers_all = true;
    for (language, look) in [(Language::German, "de"), (Language::English, "en")] {
        let mut window = start_of(command.clone(), language, folder.path());
        for program in ["xflight", "other"] {
            assert!(window.query_by_label(program).is_some(), "{program}");
        }
        screenshot(&mut window, &format!("rescue-all-{look}.png"));
    }
    let window = start_of(Program::of_tests("other"), Language::English, folder.path());
    assert!(window.query_by_label("other").is_some());
    assert!(window.query_by_label("xflight").is_none());
}

/// What the file contained is known again with the work that was done on it.
#[test]
fn a_file_that_changed_since_the_crash_is_not_overwritten_unasked() {
    for changed in [false, true] {
        let folder = work_folder();
        let file = folder.path().join("flight.vid");
        Document::new().save(&file).unwrap();
        let state = folder.path().join("state");
        let mut window = start(Language::English, &state);
        window.state_mut().load_path(&file).unwrap();
        press(&mut window, Modifiers::NONE, Key::Insert);
        drop(window);
        if changed {
            some_points().save(&file).unwrap();
        }
        let texts = Language::English.texts();
        let mut window = start(Language::English, &state);
        click(&mut window, texts.recovery.restore);
        press(&mut window, Modifiers::CTRL, Key::S);
        let asks = window.query_by_label(texts.questions.changed).is_some();
        assert_eq!(asks, changed);
    }
}

/// Passes until what is unsaved is written; one takes a quarter of a second.
fn later(window: &mut Window) {
    (0..4).for_each(|_| window.step());
}

/// An idle window asks for no wake-up, modified or not.
#[test]
fn an_idle_window_sleeps() {
    let folder = work_folder();
    let mut window = start(Language::English, folder.path());
    let sleeps = |window: &Window| {
        let viewport = window.output().viewport_output.values().next().unwrap();
        viewport.repaint_delay > std::time::Duration::from_secs(60)
    };
    assert!(sleeps(&window));
    let edit = Edit::set(At::Path, "closed", true);
    window.state_mut().document.apply(edit).unwrap();
    window.step();
    window.step();
    assert!(!sleeps(&window), "the change is to be written");
    later(&mut window);
    assert_eq!(files(folder.path()), 1);
    window.step();
    window.step();
    assert!(sleeps(&window));
}

#[test]
fn a_window_that_cannot_keep_its_work_says_so_once() {
    for language in BOTH {
        let folder = work_folder();
        let blocked = folder.path().join("file");
        std::fs::write(&blocked, "").unwrap();
        let mut window = start(language, &blocked.join("state"));
        let mut said = 0;
        for closed in [true, false] {
            window
                .state_mut()
                .document
                .apply(Edit::set(At::Path, "closed", closed))
                .unwrap();
            window.state_mut().document.mark_unsaved();
            later(&mut window);
            let message = window.state_mut().message.take();
            said += usize::from(message.is_some_and(|message| message.error));
        }
        assert_eq!(said, 1);
    }
}

#[test]
fn tab_goes_through_the_answers_as_they_are_read() {
    let folder = work_folder();
    vanish(folder.path(), 0.25);
    let mut window = start(Language::English, folder.path());
    let texts = &Language::English.texts().recovery;
    // It lies beside the work, which has the keyboard.
    assert!(!window.get_by_label(texts.restore).is_focused());
    window.get_by_label(texts.restore).focus();
    window.run();
    for name in [texts.restore, texts.discard, texts.later] {
        assert!(window.get_by_label(name).is_focused(), "{name}");
        press(&mut window, Modifiers::NONE, Key::Tab);
    }
}
