//! Objects from files.

use super::tests::{modified, name, window_in};
use crate::screenshots::screenshot;
use crate::state::files::Purpose;
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
        assert!(tool.plays_from().is_some(), "{:?}", said(&window));
        press(&mut window, Modifiers::NONE, Key::Enter);
        let document = &window.state().document;
        assert!(document.path().points.len() > 2);
        assert_eq!(document.sampler().expect("poses").frame_count(), 60 * 25);
    }
}

/// A tour of what a film already shows comes after it, and is played from there.
#[test]
fn a_tour_comes_after_the_film() {
    let folder = tempfile::tempdir().expect("a folder");
    let shape = "v -30 0 0\nv 30 0 0\nv 0 40 0\nv 0 10 30\nf 1 2 3\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    std::fs::write(folder.path().join("shape.obj"), shape).expect("written");
    let mut window = window_in(Language::English, folder.path());
    let texts = Language::English.texts();
    click(
        &mut window,
        &fill(texts.space.begin_with, &[&texts.space.begin_open]),
    );
    name(&mut window, "shape.obj");
    press(&mut window, Modifiers::ALT, Key::Insert);
    let before = window.state().document.path().clone();
    let frames = window
        .state()
        .document
        .sampler()
        .expect("poses")
        .frame_count();
    let context = window.ctx.clone();
    let tour = vides_document::tool::tools().find(|tool| tool.name == "tour");
    let open = crate::action::ToolAction::Open(tour.expect("a tour"));
    window
        .state_mut()
        .act(crate::action::Action::Tool(open), &context);
    window.step();
    let editor = window.state();
    let tool = editor.windows.tool.as_ref().expect("a tool");
    let from = tool.plays_from().expect("a tour");
    assert!(from > frames as f64, "{from} after {frames}");
    assert!(editor.playing.is_playing() && editor.position_on_bar() >= from);
    let points = &editor.document.path().points;
    for (now, then) in points.iter().zip(&before.points) {
        assert_eq!(now.position, then.position);
    }
    assert!(points.len() > before.points.len() + 2);
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

/// A mesh that is not there is found by a button, and named from the document's folder as before.
#[test]
fn a_missing_mesh_is_found_and_stays_relative() {
    for language in BOTH {
        let texts = language.texts();
        let folder = tempfile::tempdir().expect("a folder");
        let at = |name: &str| folder.path().join(name);
        for name in ["work", "work/meshes", "moved"] {
            std::fs::create_dir(at(name)).expect("a folder");
        }
        let mesh = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
        std::fs::write(at("work/meshes/a.obj"), mesh).unwrap();
        let file = at("work/flight.vid");
        let text = || std::fs::read_to_string(&file).expect("text");
        for purpose in [Purpose::LoadObject(None), Purpose::AddObject] {
            let mut window = window_in(language, folder.path());
            let state = window.state_mut();
            state.file_chosen(purpose, &at("work/meshes/a.obj"));
            state.save_path(&file).expect("saved");
            assert!(text().contains("\"meshes/a.obj\""), "{}", text());
            std::fs::rename(at("work/meshes/a.obj"), at("moved/a.obj")).unwrap();
            let mut window = window_in(language, folder.path());
            window.state_mut().load_path(&file).expect("loaded");
            window.run();
            screenshot(&mut window, &format!("find-mesh-{language:?}.png"));
            click(&mut window, &fill(texts.node.find_mesh, &[&"a.obj"]));
            let asked = window.state().windows.files.as_ref();
            let asked = asked.map(|asked| asked.purpose).expect("a window");
            window.state_mut().file_chosen(asked, &at("moved/a.obj"));
            window.run();
            assert_eq!(window.state().first_missing_mesh(), None);
            window.state_mut().save_path(&file).expect("saved");
            assert!(text().contains("\"../moved/a.obj\""), "{}", text());
            std::fs::rename(at("moved/a.obj"), at("work/meshes/a.obj")).unwrap();
        }
    }
}

/// A file that somebody sent names a mesh elsewhere: the window asks, and reads it only then.
#[test]
fn a_mesh_outside_the_folder_is_asked_for() {
    for language in BOTH {
        let texts = language.texts();
        let folder = tempfile::tempdir().expect("a folder");
        let at = |name: &str| folder.path().join(name);
        std::fs::create_dir(at("work")).expect("a folder");
        let mesh = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
        std::fs::write(at("out.obj"), mesh).unwrap();
        let node = "[[node]]\nname = \"a\"\nkind = \"object\"\n[node.mesh]\n";
        // A wrong length must not have it read when the window looks after its meshes.
        let named = "file = \"../out.obj\"\nbytes = 5\nchecksum = \"0\"\n";
        std::fs::write(at("work/a.vid"), format!("version = 1\n{node}{named}")).unwrap();
        for agreed in [false, true] {
            let mut window = window_in(language, folder.path());
            window.state_mut().load_path(&at("work/a.vid")).unwrap();
            window.run();
            screenshot(&mut window, &format!("outside-{language:?}.png"));
            let answer = match agreed {
                true => texts.questions.read_outside,
                false => texts.questions.leave_outside,
            };
            click(&mut window, answer);
            window.run();
            window.state_mut().look_after_meshes();
            window.state_mut().look_after_meshes();
            let missing = window.state().missing_mesh(Some(0)).is_some();
            assert_eq!(missing, !agreed);
            assert!(window.state().windows.question.is_none());
        }
    }
}
