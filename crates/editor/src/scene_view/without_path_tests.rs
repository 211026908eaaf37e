//! Where no path is edited, what is done to points elsewhere is done to nodes.

use egui::{Event, Modifiers};
use vides_engine::scene::Channel;

use super::clipboard::tests::taken;
use super::list::tests::{click_on, names, pick, scene_of, selected, window_of_parts};
use crate::tests::*;

const CTRL: Modifiers = Modifiers::CTRL;

#[test]
fn keys_and_menus_mean_nodes() {
    for language in BOTH {
        let (menu, scene) = (&language.texts().menu, &language.texts().scene);
        let mut window = window_of_parts(language);
        // Now nothing has the keyboard, and a light is selected.
        pick(&mut window, menu.add_light);
        let before = names(&window);
        press(&mut window, CTRL, Key::A);
        assert_eq!(selected(&window).len(), before.len());
        assert_eq!(selected(&window)[0], before[6], "the current one stays");
        assert!(window.state().several().is_none(), "points are meant");
        pick(&mut window, menu.copy_nodes);
        assert_eq!(said(&window), Some(fill(scene.nodes_copied, &[&7])));
        window.state_mut().select_nodes(vec![5, 6]);
        window.run();
        let text = taken(&mut window, Event::Cut).expect("a text");
        assert_eq!(names(&window), before[..5]);
        window.event(Event::Paste(text));
        window.run();
        assert_eq!(names(&window), before);
        window.event(Event::Paste("[[point]]\n".to_owned()));
        window.run();
        assert_eq!(said(&window).as_deref(), Some(scene.no_nodes));
        pick(&mut window, menu.remove_nodes);
        assert_eq!(names(&window), before[..5]);
        pick(&mut window, menu.all_nodes);
        assert_eq!(selected(&window).len(), 5);
    }
}

/// A path is edited; a value of another node is changed, and taken back.
#[test]
fn undo_selects_what_it_has_changed_and_nothing_else() {
    let texts = &Language::English.texts().node;
    let mut window = window_of_parts(Language::English);
    click_on(&mut window, "camera", Modifiers::NONE);
    click_on(&mut window, "box", Modifiers::NONE);
    enter(&mut window, &format!("{} x", texts.scale), "2");
    assert_eq!(scene_of(&window).nodes()[5].rest.scale.x, 2.0);
    press(&mut window, CTRL, Key::Z);
    assert_eq!(selected(&window), ["box"]);
}

/// Keys are keys where the list has the keyboard, too.
#[test]
fn keys_are_pasted_beside_the_list() {
    let mut window = window_of_parts(Language::English);
    click_on(&mut window, "lamp", Modifiers::NONE);
    let text = "[[node.track]]\nchannel = \"position\"\ninterpolation = \"linear\"\n\
                frames = [0.0]\nvalues = [[0.0, 9.0, 0.0]]\n";
    window.event(Event::Paste(text.to_owned()));
    window.run();
    let scene = scene_of(&window);
    let track = scene.nodes()[4].keys().track(&Channel::Position).unwrap();
    assert_eq!(track.frames(), [1.0, 11.0], "{:?}", said(&window));
    assert_eq!(track.values()[..3], [0.0, 9.0, 0.0], "{:?}", said(&window));
}

/// Whoever makes a node's first key has the bar under the pointer as before.
#[test]
fn the_first_key_moves_nothing() {
    let texts = Language::English.texts();
    let mut window = window_of_parts(Language::English);
    click_on(&mut window, "box", Modifiers::NONE);
    let bar = |window: &Window| window.get_by_label(texts.space.play).rect();
    let before = bar(&window);
    press(&mut window, Modifiers::NONE, Key::K);
    let scene = scene_of(&window);
    assert!(scene.nodes()[5].keys().track(&Channel::Position).is_some());
    assert_eq!(bar(&window), before);
}
