//! What is refused says where and why, and changes nothing.

use vides_engine::scene::{Kind, Light, Node, Scene};

use crate::state::files::Purpose;
use crate::tests::*;

const LAMP: usize = 1;

fn window_of_nodes(language: Language) -> Window {
    let mut scene = Scene::new();
    for (name, kind) in [
        ("camera", Kind::Camera(Default::default())),
        ("lamp", Kind::Light(Light::Spot)),
    ] {
        scene.add(Node::new(name, kind)).unwrap();
    }
    let mut document = Document::new();
    document.apply(Edit::ReplaceScene(Box::new(scene))).unwrap();
    let options = Options {
        document: document.as_opened(),
        ..options(language)
    };
    // So high that nothing has to be scrolled.
    let mut window = window_of(options, [1200.0, 1200.0], 1.0, Theme::Dark);
    window.state_mut().select_nodes(vec![LAMP]);
    window.run();
    window
}

fn scene(window: &Window) -> Scene {
    window.state().document().scene().unwrap()
}

#[test]
fn two_nodes_have_no_name_in_common() {
    for language in BOTH {
        let mut window = window_of_nodes(language);
        let before = scene(&window);
        let lamp = language.texts().scene.light;
        let row = format!("lamp {lamp}");
        window.get_by_role_and_label(Role::ListItem, &row).click();
        window.run();
        press(&mut window, Modifiers::NONE, Key::F2);
        press(&mut window, Modifiers::COMMAND, Key::A);
        window.event(egui::Event::Text("camera".to_owned()));
        window.run();
        press(&mut window, Modifiers::NONE, Key::Enter);
        let said = said(&window).expect("a sentence");
        assert!(said.contains("camera"), "{said}");
        assert_eq!(scene(&window), before);
        assert!(!window.state().document().can_undo());
    }
}

#[test]
fn numbers_out_of_range_are_told_with_their_channel() {
    for language in BOTH {
        let texts = &language.texts().node;
        let mut window = window_of_nodes(language);
        let before = scene(&window);
        for (name, number) in [
            (format!("{} x", texts.position), "1e12"),
            (texts.pitch.to_owned(), "91"),
            (format!("{} y", texts.scale), "1e300"),
            (texts.intensity.to_owned(), "-1"),
            (format!("{} {}", texts.cone, texts.outer), "91"),
            (format!("{} G", texts.colour), "2e9"),
        ] {
            enter(&mut window, &name, number);
            let message = window.state().message.as_ref();
            let said = message.map(|message| (message.error, message.text.clone()));
            let (error, said) = said.unwrap_or_else(|| panic!("{name}: nothing is said"));
            // By its field, or by its node and channel.
            let places = said.contains(&name) || said.contains("lamp");
            assert!(error && places, "{name}: {said}");
            assert_eq!(scene(&window), before, "{name}");
            press(&mut window, Modifiers::NONE, Key::Escape);
        }
        assert!(!window.state().document().can_undo());
    }
}

/// A mesh that comes back with another number of points than its shapes have is not taken.
#[test]
fn a_watched_mesh_that_no_longer_fits_stays_as_it_was() {
    let folder = tempfile::tempdir().unwrap();
    let file = |name: &str, text: &str| {
        let file = folder.path().join(name);
        std::fs::write(&file, text).unwrap();
        file
    };
    let three = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    let mesh = file("tent.obj", three);
    let shape = file("open.obj", &three.replace("0 1 0", "0 2 0"));
    let mut window = window_of_nodes(Language::English);
    let editor = window.state_mut();
    editor.file_chosen(Purpose::AddObject, &mesh);
    editor.file_chosen(Purpose::LoadShape(2), &shape);
    editor.look_after_meshes();
    window.run();
    let before = scene(&window);
    assert_eq!(before.object(2).unwrap().shapes().len(), 1);
    file("tent.obj", &format!("v 0 0 1\n{three}"));
    window.state_mut().look_after_meshes();
    window.run();
    let message = window.state().message.as_ref().expect("a sentence");
    let text = &message.text;
    assert!(
        message.error && text.contains("tent.obj") && text.contains('3'),
        "{text}"
    );
    assert_eq!(scene(&window), before);
    // Once it fits again it is taken.
    file("tent.obj", &three.replace("1 0 0", "1.5 0 0"));
    window.state_mut().look_after_meshes();
    window.run();
    assert_eq!(scene(&window).object(2).unwrap().mesh().points[1].x, 1.5);
}
