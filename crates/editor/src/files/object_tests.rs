//! Objects from files.

use super::tests::{modified, name, window_in};
use crate::tests::*;
use crate::texts::fill;

#[test]
fn an_object_is_loaded_shown_and_taken_back() {
    for language in BOTH {
        let texts = language.texts();
        let folder = tempfile::tempdir().expect("a folder");
        let corner = |size: f64| format!("v 0 0 0\nv {size} 0 0\nv 0 {size} 0\nf 1 2 3\n");
        for (file, text) in [
            ("small.obj", corner(0.5)),
            ("large.obj", corner(80.0)),
            ("broken.obj", "v 1 2\n".to_owned()),
        ] {
            std::fs::write(folder.path().join(file), text).expect("written");
        }
        let mut window = window_in(language, folder.path());
        let drawn = |window: &Window| {
            let object = &window.state().document.info().object;
            object.iter().filter(|point| point.draw).count()
        };
        let before = drawn(&window);
        for (file, said_then) in [
            ("small.obj", texts.output.loaded),
            ("large.obj", texts.output.too_large),
        ] {
            click(&mut window, texts.menu.file);
            click(&mut window, texts.menu.load_object);
            name(&mut window, file);
            assert_eq!(said(&window), Some(fill(said_then, &[&file])));
            assert_eq!(drawn(&window), 3);
            assert!(modified(&window));
            // A path in which nothing is done yet lies around it, another stays where it is.
            let document = &window.state().document;
            let space = document.path().space;
            let around = document.space_around_object().expect("a space");
            assert_eq!(space == around, file == "small.obj");
            assert_eq!(window.state().begins(), file == "small.obj");
            press(&mut window, Modifiers::NONE, Key::Insert);
        }
        click(&mut window, texts.menu.file);
        click(&mut window, texts.menu.load_object);
        name(&mut window, "broken.obj");
        let told = said(&window).expect("a sentence");
        assert!(told.contains("broken.obj") && told.contains('1'), "{told}");
        assert!(window.state().windows.files.is_some());
        press(&mut window, Modifiers::NONE, Key::Escape);
        assert_eq!(drawn(&window), 3);
        for _ in 0..4 {
            press(&mut window, Modifiers::CTRL, Key::Z);
        }
        assert_eq!(drawn(&window), before);
        let path = vides_engine::path::CameraPath::default();
        assert_eq!(*window.state().document.path(), path);
    }
}

/// *Open* begins a path around an object, and a tour asks for the object that it is to show.
#[test]
fn a_path_begins_with_an_object() {
    for language in BOTH {
        let texts = language.texts();
        let folder = tempfile::tempdir().expect("a folder");
        let shape =
            "v -30 0 0\nv 30 0 0\nv 0 40 0\nv 0 10 30\nf 1 2 3\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
        std::fs::write(folder.path().join("shape.obj"), shape).expect("written");
        let begin = |window: &mut Window, with: &str| {
            click(window, &fill(texts.space.begin_with, &[&with]));
        };

        let mut window = window_in(language, folder.path());
        begin(&mut window, texts.space.begin_open);
        name(&mut window, "shape.obj");
        let editor = window.state();
        let path = editor.document.path();
        assert!(editor.windows.files.is_none(), "{:?}", said(&window));
        assert_eq!(editor.document.space_around_object().ok(), Some(path.space));
        // No change of the user's, and no file yet; the beginnings are still there.
        assert!(editor.file.is_none() && !modified(&window));
        begin(&mut window, language.tool("orbit"));

        let mut window = window_in(language, folder.path());
        begin(&mut window, language.tool("tour"));
        name(&mut window, "shape.obj");
        let editor = window.state();
        let tool = editor.windows.tool.as_ref().expect("a tool");
        assert!(tool.shows_tour(), "{:?}", said(&window));
        press(&mut window, Modifiers::NONE, Key::Enter);
        let document = &window.state().document;
        assert!(document.path().points.len() > 2);
        assert_eq!(document.sampler().expect("poses").frame_count(), 60 * 25);
    }
}

/// A space that somebody chose stays, and a path in which anything is done is no beginning.
#[test]
fn a_chosen_space_stays_and_what_is_done_is_no_beginning() {
    let folder = tempfile::tempdir().expect("a folder");
    let shape = "v 0 0 0\nv 9 0 0\nv 0 9 0\nf 1 2 3\n";
    std::fs::write(folder.path().join("shape.obj"), shape).expect("written");
    let mut window = window_in(Language::English, folder.path());
    let space = vides_engine::path::Space {
        half_size: 3.0,
        ..vides_engine::path::Space::default()
    };
    let editor = window.state_mut();
    editor
        .document
        .apply(Edit::SetSpace { space, fit: true })
        .expect("a space");
    assert!(editor.begins());
    let menu = &Language::English.texts().menu;
    click(&mut window, menu.file);
    click(&mut window, menu.load_object);
    name(&mut window, "shape.obj");
    let document = &mut window.state_mut().document;
    assert!(!document.info().object.is_empty() && document.path().space == space);
    for (key, value) in [("roll_degrees", 1.0), ("zoom_mm", 30.0)] {
        let at = At::View(0, 0);
        document.apply(Edit::set(at, key, value)).expect("a number");
        assert!(!document.path().is_new(), "{key}");
        document.undo();
        assert!(document.path().is_new());
    }
}
