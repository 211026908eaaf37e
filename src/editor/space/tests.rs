//! The movement window as a hand meets it: whole sequences of mouse and keys.

use egui::{Event, PointerButton, Pos2, Vec2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;
use glam::DVec3;

use super::*;
use crate::document::Document;
use crate::editor::setup::Theme;
use crate::editor::state::Options;
use crate::editor::texts::Language;
use crate::raster::testing::{renderer, screenshot};

pub(in crate::editor) fn editor(document: Document, language: Language) -> Editor {
    Editor::new(Options {
        document,
        file: None,
        title: None,
        language,
        hand_over: false,
        fixed_speeds: false,
        folders: crate::editor::Folders::default(),
    })
    .unwrap()
}

pub(in crate::editor) fn pyramid() -> Document {
    let file = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/pyramid.vid");
    Document::load(&file).unwrap()
}

/// The whole window, at `scale` pixels for a point.
pub(in crate::editor) fn window<'a>(editor: Editor, size: Vec2, scale: f32) -> Harness<'a, Editor> {
    let mut prepared = false;
    let mut harness = Harness::builder()
        .with_size(size)
        .with_pixels_per_point(scale)
        .renderer(renderer())
        .build_ui_state(
            move |ui, editor: &mut Editor| {
                if !std::mem::replace(&mut prepared, true) {
                    editor.prepare(ui.ctx());
                }
                editor.show(ui);
            },
            editor,
        );
    harness.run();
    harness
}

/// The room of the movement window.
fn room(harness: &Harness<'_, Editor>) -> Rect {
    let name = harness.state().texts().space.name;
    harness.get_by_label(name).rect()
}

/// Where a point of the movement space is seen.
fn image(harness: &Harness<'_, Editor>, at: DVec3) -> Pos2 {
    Projection::new(&harness.state().setup.view, room(harness)).pos(at)
}

fn motion(harness: &mut Harness<'_, Editor>, to: Pos2) {
    harness.event(Event::PointerMoved(to));
    harness.step();
}

fn button(harness: &mut Harness<'_, Editor>, pos: Pos2, button: PointerButton, pressed: bool) {
    let modifiers = harness.ctx.input(|input| input.modifiers);
    harness.event(Event::PointerButton {
        pos,
        button,
        pressed,
        modifiers,
    });
    harness.step();
}

fn press(harness: &mut Harness<'_, Editor>, pos: Pos2, which: PointerButton) {
    motion(harness, pos);
    button(harness, pos, which, true);
}

fn release(harness: &mut Harness<'_, Editor>, pos: Pos2, which: PointerButton) {
    button(harness, pos, which, false);
    harness.step();
}

#[test]
fn pictures() {
    for (name, theme, language, scale) in [
        ("space-dark.png", Theme::Dark, Language::German, 1.0),
        ("space-light.png", Theme::Light, Language::English, 1.0),
        ("space-dark-2x.png", Theme::Dark, Language::English, 2.0),
    ] {
        let mut editor = editor(pyramid(), language);
        editor.setup.theme = theme;
        editor.document.select(3, 0).unwrap();
        let mut harness = window(editor, vec2(1200.0, 800.0), scale);
        screenshot(&mut harness, name);
        if scale == 1.0 {
            // In the midst of a drag, with the pointer on the point.
            let at = harness.state().document.path().points[3].position;
            let from = image(&harness, at);
            press(&mut harness, from, PointerButton::Middle);
            motion(&mut harness, from + vec2(70.0, 30.0));
            screenshot(&mut harness, &format!("drag-{name}"));
            release(&mut harness, from + vec2(70.0, 30.0), PointerButton::Middle);
        }
    }
}
