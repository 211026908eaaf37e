use egui::{Event, Modifiers};
use vides_document::{Edit, SceneDocument};
use vides_engine::scene::{Kind, Light, Node, Part};

use super::super::list::tests::{click_on, names, scene_of, selected, window_of_parts};
use crate::tests::*;

const NONE: Modifiers = Modifiers::NONE;

/// Copies or cuts by the event that the keyboard's keys make.
pub(in crate::scene_view) fn taken(window: &mut Window, event: Event) -> Option<String> {
    window.event(event);
    window.step();
    let commands = window.output().platform_output.commands.iter();
    let mut texts = commands.filter_map(|command| match command {
        egui::OutputCommand::CopyText(text) => Some(text.clone()),
        _ => None,
    });
    let text = texts.next_back();
    window.run();
    text
}

fn paste(window: &mut Window, text: &str) {
    window.event(Event::Paste(text.to_owned()));
    window.run();
}

fn edit(window: &mut Window, edit: Edit) {
    window.state_mut().edit_all([edit]);
    window.run();
}

/// An eye in the car that looks at the hub, and one that looks at the lamp.
fn add_eyes(window: &mut Window) {
    let eye = |name: &str, aim: usize| {
        let mut node = Node::new(name, Kind::Camera(Default::default()));
        (node.parent, node.aim) = (Some(1), Some(aim));
        node
    };
    let eyes = vec![eye("eye", 3), eye("beside", 4)];
    edit(window, Edit::AddNodes(eyes));
}

#[test]
fn nodes_go_from_window_to_window_with_all_that_is_in_them() {
    for language in BOTH {
        let texts = &language.texts().scene;
        let (mut one, mut other) = (window_of_parts(language), window_of_parts(language));
        add_eyes(&mut one);
        click_on(&mut one, "car", NONE);
        let text = taken(&mut one, Event::Copy).expect("a text");
        assert_eq!(said(&one), Some(fill(texts.nodes_copied, &[&1])));
        click_on(&mut other, "box", NONE);
        paste(&mut other, &text);
        let all = names(&other);
        assert_eq!(all[6..], ["car 2", "wheel 2", "hub 2", "eye", "beside"]);
        assert_eq!(selected(&other), ["car 2"]);
        assert_eq!(said(&other), Some(fill(texts.nodes_pasted, &[&1])));
        let (from, to) = (scene_of(&one), scene_of(&other));
        let links = |node: &Node| (node.parent, node.aim);
        let links: Vec<_> = to.nodes().range(6..).map(links).collect();
        assert_eq!(
            links,
            [
                (None, None),
                (Some(6), None),
                (Some(7), None),
                (Some(6), Some(8)),
                // The one of this name here.
                (Some(6), Some(4)),
            ]
        );
        for (new, old) in [(6, 1), (7, 2), (8, 3), (9, 6), (10, 7)] {
            let (new, old) = (&to.nodes()[new], &from.nodes()[old]);
            assert_eq!((&new.kind, new.rest), (&old.kind, old.rest));
            assert_eq!(new.keys(), old.keys());
        }
        // One step.
        press(&mut other, Modifiers::CTRL, Key::Z);
        assert_eq!(names(&other).len(), 6);
        // In the group that is selected; who aimed at what is not here aims at none, and it is told.
        edit(
            &mut other,
            Edit::Part(Box::new(Part::Name {
                node: 4,
                name: "sun".to_owned(),
            })),
        );
        click_on(&mut other, "car", NONE);
        paste(&mut other, &text);
        let to = scene_of(&other);
        assert_eq!((to.nodes()[6].parent, to.nodes()[10].aim), (Some(1), None));
        let lost = fill(texts.pasted_without_aim, &[&1, &"beside: lamp"]);
        assert_eq!(said(&other), Some(lost));
    }
}

/// Paths and keys go along bit by bit, and to a window with a path alone, too.
#[test]
fn what_moves_comes_as_it_is() {
    let mut one = window_of_parts(Language::English);
    click_on(&mut one, "camera", NONE);
    edit(&mut one, Edit::AppendAfterLast);
    click_on(&mut one, "camera", NONE);
    click_on(&mut one, "lamp", Modifiers::CTRL);
    let text = taken(&mut one, Event::Copy).expect("a text");
    // Whoever pastes it into a text file has a scene.
    let of_file = SceneDocument::from_toml(&text).expect("a file").scene;
    let from = scene_of(&one);
    let nodes = [&from.nodes()[0], &from.nodes()[4]];
    assert_eq!(of_file.nodes().iter().collect::<Vec<_>>(), nodes);
    let mut other = window(Language::English);
    paste(&mut other, &text);
    assert_eq!(names(&other), ["camera", "camera 2", "lamp"]);
    let to = scene_of(&other);
    assert_eq!(to.nodes()[1].path(), from.nodes()[0].path());
    assert_eq!(to.nodes()[2].keys(), from.nodes()[4].keys());
    assert_eq!(to.nodes()[2].kind, Kind::Light(Light::Point));
    let edited = other.state().document().edited_scene().unwrap().node();
    assert_eq!(edited, Some(1));
}

#[test]
fn cut_nodes_go_in_one_step() {
    let mut window = window_of_parts(Language::English);
    let before = scene_of(&window);
    click_on(&mut window, "car", NONE);
    click_on(&mut window, "box", Modifiers::CTRL);
    let text = taken(&mut window, Event::Cut).expect("a text");
    assert_eq!(names(&window), ["camera", "lamp"]);
    paste(&mut window, &text);
    let all = ["camera", "lamp", "car", "wheel", "hub", "box"];
    assert_eq!(names(&window), all);
    press(&mut window, Modifiers::CTRL, Key::Z);
    press(&mut window, Modifiers::CTRL, Key::Z);
    assert_eq!(scene_of(&window), before);
    assert!(!window.state().document().can_undo());
}

#[test]
fn what_is_no_node_changes_nothing() {
    for language in BOTH {
        let texts = &language.texts().scene;
        let mut window = window_of_parts(language);
        let before = scene_of(&window);
        click_on(&mut window, "car", NONE);
        let broken = "version = 1\n[[node]]\nname = \"a\"\nkind = \"cloud\"\n";
        for (text, begin) in [
            ("", texts.no_nodes),
            ("hello", texts.no_nodes),
            ("version = 1\n[[point]]\n", texts.no_nodes),
            (broken, texts.nodes_not_pasted.split('{').next().unwrap()),
            (
                "[[node]]\n",
                texts.nodes_not_pasted.split('{').next().unwrap(),
            ),
        ] {
            paste(&mut window, text);
            let said = said(&window).unwrap();
            assert!(said.starts_with(begin), "{text}: {said}");
            assert_eq!(scene_of(&window), before);
            assert!(!window.state().document().can_undo());
        }
        // Nothing is selected.
        window.state_mut().select_nodes(Vec::new());
        window.run();
        assert_eq!(taken(&mut window, Event::Copy), None);
        assert_eq!(said(&window).as_deref(), Some(texts.nothing_copied));
    }
}
