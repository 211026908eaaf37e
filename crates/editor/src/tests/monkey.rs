//! Somebody who presses anything anywhere in the window of a scene.

use egui::{Event, MouseWheelUnit, PointerButton, TouchPhase, pos2};
use vides_engine::scene::Scene;

use super::*;

/// Numbers that repeat.
struct Random(u64);

impl Random {
    fn below(&mut self, end: usize) -> usize {
        let next = self.0.wrapping_mul(6_364_136_223_846_793_005);
        self.0 = next.wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as usize % end
    }
}

/// Without N: Ctrl-N begins anew.
const KEYS: [Key; 31] = [
    Key::M,
    Key::R,
    Key::S,
    Key::X,
    Key::Y,
    Key::Z,
    Key::P,
    Key::K,
    Key::B,
    Key::G,
    Key::L,
    Key::A,
    Key::C,
    Key::V,
    Key::D,
    Key::Comma,
    Key::Period,
    Key::Home,
    Key::End,
    Key::Delete,
    Key::F2,
    Key::Enter,
    Key::Escape,
    Key::Tab,
    Key::Space,
    Key::ArrowUp,
    Key::ArrowDown,
    Key::ArrowLeft,
    Key::ArrowRight,
    Key::PageUp,
    Key::Backspace,
];

/// One thing that is done.
fn event(random: &mut Random) -> Event {
    // Not in the menus, where another file is opened.
    let at = pos2(random.below(1200) as f32, 32.0 + random.below(768) as f32);
    let modifiers = [Modifiers::NONE, Modifiers::SHIFT, Modifiers::CTRL][random.below(8) % 3];
    let button = |pressed| Event::PointerButton {
        pos: at,
        button: PointerButton::Primary,
        pressed,
        modifiers,
    };
    match random.below(20) {
        0..8 => Event::PointerMoved(at),
        8..12 => button(true),
        12..15 => button(false),
        15 => Event::Text(["1", "-", ".", "25", "0", "a"][random.below(6)].to_owned()),
        16 => Event::MouseWheel {
            unit: MouseWheelUnit::Line,
            delta: vec2(0.0, [1.0, -1.0][random.below(2)]),
            phase: TouchPhase::Move,
            source: egui::MouseWheelSource::Wheel,
            modifiers,
        },
        17 => Event::ModifiersChanged(modifiers),
        _ => Event::Key {
            key: KEYS[random.below(KEYS.len())],
            physical_key: None,
            pressed: true,
            repeat: false,
            modifiers,
        },
    }
}

/// Whatever is done, all of it is undone to the first scene, and done again to the last.
#[test]
fn anything_done_to_a_scene_is_undone() {
    let folder = tempfile::tempdir().unwrap();
    let car = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/car.vid");
    let rounds = std::env::var("VIDES_ROUNDS").map_or(6, |text| text.parse().unwrap());
    for seed in 1..=rounds {
        let document = Document::load_scene(car.as_ref()).unwrap().0.as_opened();
        let first: Scene = document.scene().unwrap();
        let mut window = window_of(
            Options {
                document,
                ..options(Language::English)
            },
            LARGE,
            1.0,
            Theme::Dark,
        );
        window.state_mut().last_folder = Some(folder.path().to_owned());
        let mut random = Random(seed);
        for _ in 0..600 {
            window.event(event(&mut random));
            window.step();
        }
        let document = &mut window.state_mut().document;
        document.end_step();
        while document.redo() {}
        let last = document.scene().unwrap();
        while document.undo() {}
        assert_eq!(document.scene().unwrap(), first, "seed {seed}");
        while document.redo() {}
        assert_eq!(document.scene().unwrap(), last, "seed {seed}");
    }
}
