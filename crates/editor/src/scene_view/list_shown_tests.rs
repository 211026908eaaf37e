//! What the list shows of nodes, and what undo and redo select in it.

use egui::{Event, Vec2};
use vides_engine::scene::{Channel, Keep, KeyList, Kind, Node, Part, Scene};

use super::tests::{
    LEFT, NONE, click_on, drag, parts, row, rows, scene_of, selected, track, window_of_parts,
};
use super::*;
use crate::screenshots::screenshot;
use crate::space::tests::{motion, press as press_at, release};
use crate::state::scene_view::NodeCommand;
use crate::tests::*;

/// A key at the playhead where there is a track, else the rest value.
#[test]
fn the_eye_hides_and_shows() {
    for language in BOTH {
        let texts = &language.texts().scene;
        let mut window = window_of_parts(language);
        let of = |window: &Window, name: &str| {
            let scene = scene_of(window);
            scene.nodes()[scene.find(name).unwrap()].clone()
        };
        let hide = fill(texts.hide, &[&"car"]);
        let show = fill(texts.show, &[&"car"]);
        click(&mut window, &hide);
        assert!(!of(&window, "car").rest.visible);
        assert!(of(&window, "wheel").rest.visible);
        click(&mut window, &show);
        assert!(of(&window, "car").rest.visible);
        let visible = track(Channel::Visible, &[1.0, 21.0], &[1.0, 0.0]);
        let part = vides_engine::scene::Part::track(1, Channel::Visible, Some(visible)).unwrap();
        window.state_mut().edit(Edit::Part(Box::new(part)));
        window.state_mut().set_frame(11.0).unwrap();
        window.run();
        click(&mut window, &hide);
        let keys = |window: &Window| {
            let car = of(window, "car");
            let track = car.keys().track(&Channel::Visible).unwrap();
            (track.frames().to_vec(), track.values().to_vec())
        };
        let wanted = (vec![1.0, 11.0, 21.0], vec![1.0, 0.0, 0.0]);
        assert_eq!(keys(&window), wanted);
        assert!(of(&window, "car").rest.visible);
        // At the same frame the key gets the other value.
        click(&mut window, &show);
        assert_eq!(keys(&window).1, [1.0, 1.0, 0.0]);
        window.state_mut().set_frame(30.0).unwrap();
        window.run();
        assert!(window.query_by_label(&show).is_some());
    }
}

/// However many there are, only the rows that are seen are made.
#[test]
fn of_many_nodes_only_what_is_seen_is_made() {
    const MANY_NODES: usize = 99_990;
    let scene = parts().scene().unwrap();
    let mut nodes: Vec<Node> = scene.nodes().iter().cloned().collect();
    nodes.extend((0..MANY_NODES).map(|at| {
        let mut node = Node::new(&format!("part {at}"), Kind::Group);
        node.parent = Some(if at % 100 == 0 { 1 } else { 6 + at - at % 100 });
        node
    }));
    let scene = Scene::from_nodes(nodes).unwrap();
    let mut document = Document::new();
    let edit = Edit::ReplaceScene(Box::new(scene));
    document.apply(edit).unwrap();
    let options = Options {
        document: document.as_opened(),
        ..options(Language::English)
    };
    let mut window = window_of(options, LARGE, 1.0, Theme::Dark);
    let texts = &Language::English.texts().scene;
    assert!(rows(&window).len() < 40, "{}", rows(&window).len());
    window.state_mut().select_nodes(vec![6 + 77_123]);
    window.run();
    let shown = rows(&window);
    assert!(
        shown.contains(&format!("part 77123 {}", texts.group)),
        "{shown:?}"
    );
    screenshot(&mut window, "scene-many.png");
    window.get_by_label(texts.filter).click();
    window.run();
    window.event(Event::Text("T 99988".to_owned()));
    window.run();
    let wanted = ["car group", "part 99900 group", "part 99988 group"];
    assert_eq!(rows(&window), wanted);
    screenshot(&mut window, "scene-filter.png");
    window.event(Event::Text("x".to_owned()));
    window.run();
    assert_eq!(rows(&window), [""; 0]);
    assert!(window.query_by_label(texts.not_found).is_some());
}

#[test]
fn pictures_of_the_list() {
    for (language, theme, size, name) in [
        (Language::German, Theme::Dark, LARGE, "de-large"),
        (Language::English, Theme::Light, LARGE, "en-large"),
        (Language::German, Theme::Light, SMALL, "de-small"),
        (Language::English, Theme::Dark, SMALL, "en-small"),
    ] {
        let options = Options {
            document: parts(),
            ..options(language)
        };
        let mut window = window_of(options, size, 1.0, theme);
        let texts = &language.texts().scene;
        click(&mut window, &fill(texts.hide, &[&"lamp"]));
        window.state_mut().select_nodes(vec![2, 4]);
        window.run();
        screenshot(&mut window, &format!("scene-list-{name}.png"));
        // In the middle of a drag.
        let (from, to) = (row(&window, "wheel"), row(&window, "box"));
        press_at(&mut window, from, LEFT);
        motion(&mut window, from + Vec2::new(0.0, 8.0));
        motion(&mut window, to);
        screenshot(&mut window, &format!("scene-drag-{name}.png"));
        press(&mut window, NONE, Key::Escape);
        release(&mut window, to, LEFT);
        open_menu(&mut window, 1);
        screenshot(&mut window, &format!("scene-menu-{name}.png"));
    }
}

#[test]
fn what_follows_a_path_moves() {
    let mut window = window_of_parts(Language::English);
    let path = scene_of(&window).nodes()[0].path().unwrap().clone();
    let to = row(&window, "car");
    drag(&mut window, "camera", to);
    click(&mut window, Language::English.texts().scene.go_along);
    let scene = scene_of(&window);
    assert_eq!(scene.nodes()[0].parent, Some(1));
    assert_eq!(scene.nodes()[0].path(), Some(&path));
    let mut same = parts().scene().unwrap();
    same.set_parent(0, Some(1), Keep::Numbers).unwrap();
    assert_eq!(scene, same);
}

#[test]
fn undo_and_redo_select_what_they_change() {
    let mut window = window_of_parts(Language::English);
    let steps = |window: &Window| window.state().document().can_undo();
    // Looking at this and that is no step.
    for name in ["camera", "box", "camera", "lamp"] {
        click_on(&mut window, name, NONE);
    }
    assert!(!steps(&window));
    let rename = NodeCommand::Rename(2, "tyre".to_owned());
    window.state_mut().do_to_nodes(rename);
    let keys = KeyList {
        frames: vec![5.0, 7.0],
        values: vec![0.5; 6],
        shape: Vec::new(),
    };
    let (node, channel) = (4, Channel::Position);
    let put = |remove, put| {
        let channel = channel.clone();
        let part = Part::Keys {
            node,
            channel,
            remove,
            put,
        };
        Edit::Part(Box::new(part))
    };
    window.state_mut().edit_all([put(Vec::new(), keys)]);
    click_on(&mut window, "camera", NONE);
    assert!(window.state().document().edits_path());
    press(&mut window, Modifiers::CTRL, Key::Z);
    assert_eq!(selected(&window), ["lamp"]);
    assert!(!window.state().document().edits_path());
    click_on(&mut window, "camera", NONE);
    press(&mut window, Modifiers::CTRL, Key::Z);
    assert_eq!(selected(&window), ["wheel"]);
    // What was looked at meanwhile takes nothing away that can be done again.
    click_on(&mut window, "camera", NONE);
    press(&mut window, Modifiers::CTRL, Key::Y);
    assert_eq!(selected(&window), ["tyre"]);
    click_on(&mut window, "box", NONE);
    press(&mut window, Modifiers::CTRL, Key::Y);
    assert_eq!(selected(&window), ["lamp"]);
    let keys = |window: &Window| -> Vec<usize> {
        let keys = window.state().selected_keys();
        keys.into_iter().map(|at| at.key).collect()
    };
    assert_eq!(keys(&window), [1, 2]);
    // A key before them gives them other numbers.
    let before = KeyList {
        frames: vec![3.0],
        values: vec![0.0; 3],
        shape: Vec::new(),
    };
    window.state_mut().edit_all([put(Vec::new(), before)]);
    window.run();
    assert_eq!(keys(&window), [2, 3]);
    window
        .state_mut()
        .edit_all([put(vec![2], KeyList::default())]);
    window.run();
    assert_eq!(keys(&window), [2]);
    press(&mut window, Modifiers::CTRL, Key::Z);
    assert_eq!(keys(&window), [2]);
    // All nodes that came back.
    let all = NodeCommand::Remove;
    click_on(&mut window, "car", NONE);
    click_on(&mut window, "box", Modifiers::CTRL);
    window.state_mut().do_to_nodes(all);
    press(&mut window, Modifiers::CTRL, Key::Z);
    assert_eq!(selected(&window), ["car", "tyre", "hub", "box"]);
}

/// Whatever comes and goes, what is selected stays so under its name.
#[test]
fn what_is_selected_stays_so_when_numbers_change() {
    let mut window = window_of_parts(Language::English);
    let editor = window.state_mut();
    let mut seed = 7_u64;
    let mut below = |count: usize| {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        usize::try_from(seed >> 33).unwrap() % count
    };
    let mut changed = 0;
    for step in 0..3000 {
        let Some(edited) = editor.document.edited_scene() else {
            panic!("the camera stays");
        };
        let nodes = edited.scene().nodes();
        let count = nodes.len();
        let names: Vec<String> = nodes.iter().map(|node| node.name.clone()).collect();
        if below(3) == 0 {
            let chosen = (0..1 + below(3)).map(|_| below(count));
            let mut chosen: Vec<usize> = chosen.collect();
            chosen.sort_unstable();
            chosen.dedup();
            editor.select_nodes(chosen);
            continue;
        }
        let of = editor.scene_view.selection.names();
        let edit = match below(4) {
            0 if count > 20 => Edit::Part(Box::new(Part::Remove(vec![1 + below(count - 1)]))),
            1 => Edit::CopyNodes(vec![1 + below(count - 1)]),
            2 => Edit::AddNodes(vec![Node::new(&format!("new {step}"), Kind::Group)]),
            _ => {
                match below(2) {
                    0 => editor.document.undo(),
                    _ => editor.document.redo(),
                };
                editor.scene_view.follow(&editor.document);
                let scene = editor.document.edited_scene().unwrap().scene();
                let left = of.into_iter().filter(|name| scene.find(name).is_some());
                assert_eq!(
                    editor.scene_view.selection.names(),
                    left.collect::<Vec<_>>()
                );
                continue;
            }
        };
        if editor.document.apply(edit).is_err() {
            continue;
        }
        editor.scene_view.follow(&editor.document);
        let scene = editor.document.edited_scene().unwrap().scene();
        let left = of.into_iter().filter(|name| scene.find(name).is_some());
        assert_eq!(
            editor.scene_view.selection.names(),
            left.collect::<Vec<_>>()
        );
        let selected = &editor.scene_view.selection;
        for (node, name) in selected.numbers().iter().zip(selected.names()) {
            assert_eq!(scene.nodes()[*node].name, name);
        }
        changed += usize::from(names.len() != scene.nodes().len());
    }
    assert!(changed > 1000, "{changed}");
}
