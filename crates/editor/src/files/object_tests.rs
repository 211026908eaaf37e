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
        }
        click(&mut window, texts.menu.file);
        click(&mut window, texts.menu.load_object);
        name(&mut window, "broken.obj");
        let told = said(&window).expect("a sentence");
        assert!(told.contains("broken.obj") && told.contains('1'), "{told}");
        assert!(window.state().windows.files.is_some());
        press(&mut window, Modifiers::NONE, Key::Escape);
        assert_eq!(drawn(&window), 3);
        for _ in 0..2 {
            press(&mut window, Modifiers::CTRL, Key::Z);
        }
        assert_eq!(drawn(&window), before);
    }
}
