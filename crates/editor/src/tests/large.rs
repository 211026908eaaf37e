//! A scene of ten thousand nodes that move by a million keys.

use egui::{PointerButton, pos2};
use vides_engine::scene::{Channel, Interpolation, Kind, Node, Scene, Track};

use super::*;
use crate::space::tests::{motion, press as press_at, release};

const NODES: usize = 10_000;
const KEYS: usize = 100;
const LAST: f32 = 397.0;

fn scene() -> Scene {
    let mut scene = Scene::new();
    let frames: Vec<f64> = (0..KEYS).map(|key| 1.0 + 4.0 * key as f64).collect();
    for number in 0..NODES {
        let node = Node::new(&format!("lamp {number}"), Kind::Light(Default::default()));
        let at = scene.add(node).unwrap();
        let values = (0..3 * KEYS).map(|at| 0.001 * ((at + number) % 700) as f64);
        let (by, frames) = (Interpolation::CatmullRom, frames.clone());
        let track = Track::new(Channel::Position, by, frames, values.collect(), Vec::new());
        scene.set_track(at, track.unwrap()).unwrap();
    }
    scene
}

/// A key is dragged as fluently as the time is scrubbed: a pass of the window each.
#[test]
fn timed_a_key_of_a_million_is_dragged_as_the_time_is_scrubbed() {
    let mut document = Document::new();
    let edit = Edit::ReplaceScene(Box::new(scene()));
    document.apply(edit).unwrap();
    let options = Options {
        document: document.as_opened(),
        ..options(Language::English)
    };
    let mut window = window_of(options, LARGE, 1.0, Theme::Dark);
    window.state_mut().select_nodes(vec![NODES / 2]);
    window.run();
    let texts = Language::English.texts();
    let ruler = window.get_by_label(texts.space.timeline).rect();
    let rows = texts.timeline.tracks;
    let rows = window.get_by_role_and_label(Role::Canvas, rows).rect();
    let rail = ruler.shrink(8.0);
    let x = |frame: f32| rail.left() + (frame - 1.0) / (LAST - 1.0) * rail.width();
    let below = rows.top() + 30.0;
    let mut best = [f64::INFINITY; 2];
    for round in 0..6 {
        let drags = round % 2 == 1;
        let y = if drags { below } else { ruler.center().y };
        press_at(&mut window, pos2(x(201.0), y), PointerButton::Primary);
        motion(&mut window, pos2(x(207.0), y));
        let start = spent();
        for pass in 0..20_u8 {
            motion(&mut window, pos2(x(207.0 + f32::from(pass)), y));
        }
        best[round % 2] = best[round % 2].min(spent() - start);
        if drags {
            // It is not where it was.
            let scene = window.state().document().scene().unwrap();
            let track = scene.nodes()[NODES / 2].keys().tracks()[0].frames();
            assert!(track.contains(&226.0), "{track:?}");
        }
        release(&mut window, pos2(x(226.0), y), PointerButton::Primary);
        while window.state_mut().document.undo() {}
        window.run();
    }
    let ratio = best[1] / best[0];
    println!("{:.1} ms a pass, {ratio:.2}", best[1] / 20.0);
    assert!(ratio <= 1.5, "{ratio}");
}
