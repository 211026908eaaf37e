//! A host that shows another scene while the user drags.

use egui::{PointerButton, Pos2, pos2};
use vides_engine::scene::{Channel, Interpolation, Kind, Node, Scene, Track};

use super::hands::Hands;
use super::*;
use crate::space::tests::{motion, press as press_at, release};

const LAMP: usize = 1;

fn scene() -> Scene {
    let mut scene = Scene::new();
    for name in ["box", "lamp", "sun"] {
        let node = Node::new(name, Kind::Light(Default::default()));
        scene.add(node).unwrap();
    }
    let frames = vec![1.0, 20.0, 40.0];
    let values = vec![0.0, 0.0, 0.0, 0.5, 0.0, 0.0, 0.5, 0.5, 0.0];
    let by = Interpolation::Linear;
    let track = Track::new(Channel::Position, by, frames, values, Vec::new());
    scene.set_track(LAMP, track.unwrap()).unwrap();
    scene.set_range(Some((1.0, 41.0))).unwrap();
    scene.set_marker("here", 11.0).unwrap();
    scene
}

/// What the host does to the scene that it took: numbers move, keys come, tracks and nodes go.
fn changed(mut scene: Scene, how: u8) -> Scene {
    match how {
        0 => scene.remove(0).map(drop).unwrap(),
        1 => scene.remove(LAMP).map(drop).unwrap(),
        2 => scene
            .remove_track(LAMP, &Channel::Position)
            .map(drop)
            .unwrap(),
        _ => {
            let frames = vec![1.0, 5.0, 9.0, 13.0, 20.0, 40.0];
            let (by, values) = (Interpolation::Linear, vec![0.25; 18]);
            let track = Track::new(Channel::Position, by, frames, values, Vec::new());
            scene.set_track(LAMP, track.unwrap()).unwrap();
        }
    }
    scene.add(Node::new("of the host", Kind::Group)).unwrap();
    scene
}

/// Where each drag begins: a key of the timeline, a number of the panel, the node in the space, a
/// marker.
fn begin(hands: &mut Hands, what: u8) -> Pos2 {
    let at = match what {
        0 => {
            let row = hands.row(&Channel::Position, 0.0);
            let name = hands.window.state().texts().space.timeline;
            let rail = hands.window.get_by_label(name).rect().shrink(8.0);
            pos2(rail.left() + rail.width() * 19.0 / 40.0, row.y)
        }
        3 => {
            let texts = hands.window.state().texts();
            let name = fill(texts.timeline.marker, &[&"here"]);
            hands.window.get_by_label(&name).rect().center()
        }
        1 => number(&hands.window, "Position x").rect().center(),
        _ => {
            let name = hands.window.state().texts().space.name;
            hands.window.get_by_label(name).rect().center()
        }
    };
    motion(&mut hands.window, at);
    if what == 2 {
        press(&mut hands.window, Modifiers::NONE, Key::M);
    } else {
        press_at(&mut hands.window, at, PointerButton::Primary);
    }
    at
}

#[test]
fn a_scene_that_comes_while_the_user_drags_loses_nothing() {
    for what in 0..4 {
        for how in 0..4 {
            let mut document = Document::new();
            document
                .apply(Edit::ReplaceScene(Box::new(scene())))
                .unwrap();
            let mut hands = Hands::new(Options {
                document: document.as_opened(),
                ..options(Language::English)
            });
            hands.window.state_mut().select_nodes(vec![LAMP]);
            hands.window.run();
            let first = hands.scene();
            let at = begin(&mut hands, what);
            for step in 1..=4_u8 {
                motion(&mut hands.window, at + vec2(8.0 * f32::from(step), 0.0));
            }
            assert_ne!(hands.scene(), first, "gesture {what} does nothing");
            let other = changed(hands.scene(), how);
            let document = hands.window.state_mut().document_mut();
            document.begin_step();
            document.apply(Edit::ReplaceScene(Box::new(other))).unwrap();
            document.end_step();
            // Nothing goes on: neither on the host's keys nor where there are none any more.
            let shown = hands.scene();
            for step in 5..=8_u8 {
                motion(&mut hands.window, at + vec2(8.0 * f32::from(step), 0.0));
            }
            if what == 2 {
                press(&mut hands.window, Modifiers::NONE, Key::Enter);
            } else {
                release(
                    &mut hands.window,
                    at + vec2(64.0, 0.0),
                    PointerButton::Primary,
                );
            }
            hands.window.run();
            let scene = hands.scene();
            assert!(scene.find("of the host").is_some(), "gesture {what}, {how}");
            assert_eq!(scene.nodes().len(), 4 - usize::from(how < 2));
            assert_eq!(scene, shown, "gesture {what}, {how}");
            let mut steps = 0;
            while hands.window.state_mut().document.undo() {
                steps += 1;
            }
            assert_eq!(steps, 2, "gesture {what}, {how}");
            assert_eq!(hands.scene().nodes(), first.nodes());
        }
    }
}
