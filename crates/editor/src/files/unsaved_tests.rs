//! Work that is not saved: what asks before it is lost, and what another program wrote.

use std::path::Path;

use super::tests::{modified, name, window_in};
use crate::state::Request;
use crate::tests::*;

/// Two windows on one file of which the other one has just saved what it did.
fn overtaken(language: Language, folder: &Path) -> (Window, std::path::PathBuf) {
    let file = folder.join("both.vid");
    Document::new().save(&file).expect("a file");
    let open = || {
        let options = Options {
            document: Document::load(&file).expect("a path"),
            file: Some(file.clone()),
            ..options(language)
        };
        window_of(options, SMALL, 1.0, Theme::Light)
    };
    let (mut first, mut second) = (open(), open());
    press(&mut first, Modifiers::NONE, Key::Insert);
    press(&mut first, Modifiers::CTRL, Key::S);
    assert!(!modified(&first), "{:?}", said(&first));
    press(&mut second, Modifiers::ALT, Key::Insert);
    press(&mut second, Modifiers::CTRL, Key::S);
    (second, file)
}

#[test]
fn a_file_that_another_program_wrote_is_offered_when_one_comes_back() {
    for language in BOTH {
        let texts = &language.texts().questions;
        let folder = tempfile::tempdir().expect("a folder");
        let file = folder.path().join("flight.vid");
        Document::new().save(&file).expect("a file");
        let mut window = window(language);
        window.state_mut().load_path(&file).expect("a path");
        let come_back = |window: &mut Window| {
            for focused in [false, true] {
                window.event(egui::Event::WindowFocused(focused));
                window.run();
            }
            window.query_by_label(texts.changed).is_some()
        };
        assert!(!come_back(&mut window));
        let other = |points: usize| {
            let mut document = Document::new();
            let edit = Edit::DivideSegment { segment: 0, points };
            document.apply(edit).expect("points");
            document.save(&file).expect("a file");
        };
        other(1);
        assert!(come_back(&mut window));
        click(&mut window, texts.reload);
        assert_eq!(window.state().document.path().points.len(), 3);
        assert!(!come_back(&mut window));
        // Left alone it is not asked about again, but before it is overwritten.
        other(2);
        assert!(come_back(&mut window));
        click(&mut window, texts.keep);
        assert!(!come_back(&mut window));
        assert_eq!(window.state().document.path().points.len(), 3);
        press(&mut window, Modifiers::CTRL, Key::S);
        assert!(window.query_by_label(texts.save_as).is_some());
    }
}

#[test]
fn a_file_that_changed_is_not_overwritten_unasked() {
    for language in BOTH {
        let texts = language.texts();
        let asks = |window: &Window| window.query_by_label(texts.questions.changed).is_some();
        let points = |file: &Path| Document::load(file).expect("a path").path().points.len();

        // The other one's work is there, ours is still unsaved.
        let folder = tempfile::tempdir().expect("a folder");
        let (mut window, file) = overtaken(language, folder.path());
        assert!(asks(&window) && modified(&window));
        assert_eq!(points(&file), 3);
        let picture = format!("changed-{}.png", texts.questions.reload);
        crate::screenshots::screenshot(&mut window, &picture);
        press(&mut window, Modifiers::NONE, Key::Escape);
        assert!(!asks(&window) && modified(&window));
        assert_eq!(points(&file), 3);

        // Overwritten only when that was said, and not asked about again.
        press(&mut window, Modifiers::CTRL, Key::S);
        click(&mut window, texts.files.overwrite);
        assert!(!asks(&window) && !modified(&window));
        assert_eq!(points(&file), 2);
        press(&mut window, Modifiers::ALT, Key::Insert);
        press(&mut window, Modifiers::CTRL, Key::S);
        assert!(!asks(&window) && !modified(&window));

        let folder = tempfile::tempdir().expect("a folder");
        let (mut window, file) = overtaken(language, folder.path());
        click(&mut window, texts.questions.reload);
        assert!(!asks(&window) && !modified(&window));
        assert_eq!(window.state().document.path().points.len(), 3);
        assert_eq!(points(&file), 3);

        // On the way out: saved elsewhere, then closed.
        let folder = tempfile::tempdir().expect("a folder");
        let (mut window, file) = overtaken(language, folder.path());
        press(&mut window, Modifiers::NONE, Key::Escape);
        window.state_mut().last_folder = Some(folder.path().to_owned());
        window.state_mut().ask_to_close();
        window.run();
        click(&mut window, texts.questions.save);
        assert!(asks(&window));
        assert_eq!(window.state_mut().next_request(), None);
        click(&mut window, texts.questions.save_as);
        name(&mut window, "mine");
        assert_eq!(window.state_mut().next_request(), Some(Request::Close));
        assert_eq!(points(&file), 3);
        assert_eq!(points(&folder.path().join("mine.vid")), 2);
    }
}

/// What is there counts, and not when it came there.
#[test]
fn only_other_contents_are_a_change() {
    let texts = Language::English.texts();
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("a.vid");
    let asks = |window: &Window| window.query_by_label(texts.questions.changed).is_some();
    // A name that had no file: one that has come since is somebody's.
    let mut first = options(Language::English);
    first.file = Some(file.clone());
    let mut window = window_of(first, SMALL, 1.0, Theme::Dark);
    press(&mut window, Modifiers::NONE, Key::Insert);
    Document::new().save(&file).expect("saved");
    press(&mut window, Modifiers::CTRL, Key::S);
    assert!(asks(&window));
    press(&mut window, Modifiers::NONE, Key::Escape);
    // Gone: there is nothing to lose.
    std::fs::remove_file(&file).expect("gone");
    press(&mut window, Modifiers::CTRL, Key::S);
    assert!(!asks(&window) && !modified(&window));
    // Written anew with the same bytes, by another file in its place.
    let bytes = std::fs::read(&file).expect("there");
    let other = folder.path().join("other");
    std::fs::write(&other, &bytes).expect("written");
    std::fs::rename(&other, &file).expect("renamed");
    press(&mut window, Modifiers::NONE, Key::Insert);
    press(&mut window, Modifiers::CTRL, Key::S);
    assert!(!asks(&window) && !modified(&window));
    // As many bytes, at the same time, in the same file.
    let mut bytes = std::fs::read(&file).expect("there");
    let times = std::fs::metadata(&file)
        .expect("there")
        .modified()
        .expect("a time");
    let last = bytes.len() - 1;
    bytes[last] = b' ';
    std::fs::write(&file, &bytes).expect("written");
    let opened = std::fs::File::options()
        .write(true)
        .open(&file)
        .expect("there");
    opened.set_modified(times).expect("set");
    press(&mut window, Modifiers::NONE, Key::Insert);
    press(&mut window, Modifiers::CTRL, Key::S);
    assert!(asks(&window));
    assert_eq!(std::fs::read(&file).expect("there"), bytes);
}

/// A host has what was handed over to it.
#[test]
fn after_a_hand_over_nothing_is_unsaved_where_the_host_keeps_it() {
    for saves in [true, false] {
        let mut options = options(Language::English);
        options.program.hand_over_saves = saves;
        let mut window = window_of(options, SMALL, 1.0, Theme::Dark);
        press(&mut window, Modifiers::NONE, Key::Insert);
        let title = |window: &Window| window.state().window_title();
        assert_eq!(title(&window), "VIDES*");
        press(&mut window, Modifiers::ALT, Key::U);
        assert_eq!(window.state_mut().next_request(), Some(Request::HandOver));
        window.state_mut().handed_over(Ok(121), true);
        assert_eq!(title(&window), if saves { "VIDES" } else { "VIDES*" });
        window.state_mut().ask_to_close();
        let closes = window.state_mut().next_request() == Some(Request::Close);
        assert_eq!(closes, saves);
        if !saves {
            continue;
        }
        // What is done afterwards is unsaved again, what was taken back is not.
        press(&mut window, Modifiers::NONE, Key::Insert);
        assert!(window.state().is_unsaved());
        press(&mut window, Modifiers::CTRL, Key::Z);
        assert!(!window.state().is_unsaved());
        // Nothing was handed over of a path that is opened later.
        let folder = tempfile::tempdir().expect("a folder");
        let file = folder.path().join("a.vid");
        Document::new().save(&file).expect("saved");
        window.state_mut().load_path(&file).expect("loaded");
        window.run();
        press(&mut window, Modifiers::NONE, Key::Insert);
        assert!(window.state().is_unsaved());
    }
}

#[test]
fn unsaved_work_is_asked_about_before_the_window_closes() {
    for language in BOTH {
        let texts = &language.texts().questions;
        let folder = tempfile::tempdir().expect("a folder");
        let closes = |window: &mut Window| window.state_mut().next_request();
        let mut window = window_in(language, folder.path());
        window.state_mut().ask_to_close();
        assert_eq!(closes(&mut window), Some(Request::Close));

        press(&mut window, Modifiers::NONE, Key::Insert);
        window.state_mut().ask_to_close();
        window.run();
        assert_eq!(closes(&mut window), None);
        press(&mut window, Modifiers::NONE, Key::Escape);
        assert!(window.query_by_label(texts.unsaved).is_none());
        assert_eq!(closes(&mut window), None);
        press(&mut window, Modifiers::CTRL, Key::Q);
        click(&mut window, texts.cancel);
        assert_eq!(closes(&mut window), None);
        press(&mut window, Modifiers::ALT, Key::F4);
        click(&mut window, texts.discard);
        assert_eq!(closes(&mut window), Some(Request::Close));
        // The host refused; the work is still there, and saved by the keyboard.
        window.state_mut().ask_to_close();
        window.run();
        press(&mut window, Modifiers::NONE, Key::Enter);
        name(&mut window, "kept");
        assert_eq!(closes(&mut window), Some(Request::Close));
        assert!(folder.path().join("kept.vid").is_file());
    }
}

#[test]
fn unsaved_work_is_asked_about_before_another_path_is_loaded() {
    let texts = Language::German.texts();
    let folder = tempfile::tempdir().expect("a folder");
    let mut window = window_in(Language::German, folder.path());
    press(&mut window, Modifiers::NONE, Key::Insert);
    press(&mut window, Modifiers::CTRL, Key::O);
    assert!(window.query_by_label(texts.files.load_path).is_none());
    click(&mut window, texts.questions.save);
    name(&mut window, "first");
    assert!(folder.path().join("first.vid").is_file());
    assert!(window.query_by_label(texts.files.load_path).is_some());
    press(&mut window, Modifiers::NONE, Key::Escape);
    assert!(window.query_by_label(texts.files.load_path).is_none());
}

#[test]
fn what_is_typed_counts_when_the_window_is_closed() {
    let mut window = window(Language::German);
    type_into(&mut window, "Position x", "0,5");
    window.state_mut().ask_to_close();
    assert_eq!(window.state_mut().next_request(), None);
    window.run();
    assert_eq!(window.state_mut().next_request(), None);
    let texts = &Language::German.texts().questions;
    assert!(window.query_by_label(texts.unsaved).is_some());
}
