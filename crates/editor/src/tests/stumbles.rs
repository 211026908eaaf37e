//! What somebody stumbled over who used the window for the first time.

use egui::Event;
use vides_engine::scene::{Kind, Node, Part};

use super::hands::Hands;
use super::*;
use crate::space::tests::{motion, press as press_at, release};

const NONE: Modifiers = Modifiers::NONE;

#[test]
fn the_help_is_scrolled_and_nothing_behind_it_moves() {
    let texts = Language::English.texts();
    let mut window = window(Language::English);
    open_menu(&mut window, 1);
    click(&mut window, texts.menu.add_light);
    let before = window.state().document().scene().unwrap();
    press(&mut window, NONE, Key::F1);
    let top = |window: &Window| window.get_by_label(texts.help.left_meaning).rect().top();
    let first = top(&window);
    for _ in 0..3 {
        press(&mut window, NONE, Key::PageDown);
    }
    assert!(top(&window) < first - 300.0, "{} {first}", top(&window));
    press(&mut window, NONE, Key::Home);
    assert_eq!(top(&window), first);
    assert_eq!(window.state().document().scene().unwrap(), before);
}

#[test]
fn a_scene_ends_where_it_is_told_to() {
    let mut hands = Hands::new(options(Language::English));
    let texts = &Language::English.texts().space;
    hands.add(Language::English.texts().menu.add_light);
    assert_eq!(hands.scene().frame_range(), (1.0, 121.0));
    hands.number(texts.duration, "9");
    assert_eq!(hands.scene().range(), Some((1.0, 225.0)));
    hands.frame(220);
    hands.number(texts.last_frame, "121");
    assert_eq!(
        hands.scene().range(),
        None,
        "it is what it would be by itself"
    );
    // Seconds count from the first frame that a scene can have, whichever is its own.
    let part = Part::Range(Some((51.0, 226.0)));
    let document = hands.window.state_mut().document_mut();
    document.apply(Edit::Part(Box::new(part))).unwrap();
    hands.window.run();
    hands.frame(226);
    assert_eq!(value(&hands.window, texts.second), "9.00 s");
    assert_eq!(value(&hands.window, texts.duration), "9.04 s");
}

#[test]
fn what_is_lost_is_told() {
    let texts = Language::English.texts();
    let mut hands = Hands::new(options(Language::English));
    hands.add(texts.menu.add_light);
    hands.key(NONE, Key::F2);
    hands.window.event(Event::Text("   ".to_owned()));
    hands.window.run();
    hands.key(NONE, Key::Enter);
    let told = fill(texts.scene.needs_name, &[&texts.scene.light]);
    assert_eq!(said(&hands.window), Some(told));
    let aim = Part::Links {
        node: 0,
        parent: None,
        aim: Some(1),
    };
    let document = hands.window.state_mut().document_mut();
    document.apply(Edit::Part(Box::new(aim))).unwrap();
    hands.window.run();
    // More than half a turn is kept by angles only, once there are keys.
    hands.number(texts.node.yaw, "200");
    assert_eq!(said(&hands.window), None);
    hands.diamond(texts.node.rotation);
    hands.number(texts.node.yaw, "200");
    let told = texts.node.more_than_half;
    assert_eq!(said(&hands.window).as_deref(), Some(told));
    hands.entry(1, texts.menu.remove_nodes);
    let told = fill(texts.scene.aims_lost, &[&"camera"]);
    assert_eq!(said(&hands.window), Some(told));
}

/// Two wheels on one axle turn about it; where they are stays to the last bit.
#[test]
fn what_is_turned_about_itself_stays_where_it_is() {
    let mut document = Document::new();
    let mut scene = document.scene().unwrap();
    for (name, x) in [("left", -0.1), ("right", 0.1)] {
        let mut wheel = Node::new(name, Kind::Light(Default::default()));
        wheel.rest.position = DVec3::new(x, 0.03, 0.09);
        scene.add(wheel).unwrap();
    }
    document.apply(Edit::ReplaceScene(Box::new(scene))).unwrap();
    let mut hands = Hands::new(Options {
        document: document.as_opened(),
        ..options(Language::English)
    });
    hands.window.state_mut().select_nodes(vec![1, 2]);
    hands.window.run();
    let before = hands.scene();
    let space = Language::English.texts().space.name;
    let middle = hands.window.get_by_label(space).rect().center();
    motion(&mut hands.window, middle);
    press(&mut hands.window, NONE, Key::R);
    press(&mut hands.window, NONE, Key::X);
    hands.window.event(Event::Text("90".to_owned()));
    hands.window.run();
    press(&mut hands.window, NONE, Key::Enter);
    let after = hands.scene();
    for at in [1, 2] {
        let [was, is] = [&before, &after].map(|scene| scene.nodes()[at].rest);
        assert_ne!(was.rotation, is.rotation);
        assert_eq!(was.position, is.position);
    }
}

/// On a busy machine seconds pass between a press and its release.
#[test]
fn a_button_that_is_held_down_long_is_clicked() {
    let mut window = window(Language::English);
    let points = |window: &Window| window.state().document().path().points.len();
    let before = points(&window);
    let at = window.get_by_label("+ Point").rect().center();
    press_at(&mut window, at, egui::PointerButton::Primary);
    for _ in 0..20 {
        window.step();
    }
    release(&mut window, at, egui::PointerButton::Primary);
    window.run();
    assert_eq!(points(&window), before + 1);
}
