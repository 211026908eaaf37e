//! The movement window as a user meets it: whole sequences of mouse and keys.

use egui::{CursorIcon, Event, Key, Modifiers, MouseWheelUnit, PointerButton, Pos2, Vec2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;
use glam::DVec3;
use vides_document::Document;
use vides_engine::path::Target;

use super::projection::{Axis, from_pos};
use super::*;
use crate::screenshots::{renderer, screenshot};
use crate::setup::{Theme, View};
use crate::state::Options;
use crate::texts::Language;

pub(crate) fn editor(document: Document, language: Language) -> Editor {
    Editor::new(Options {
        document,
        file: None,
        title: None,
        language: Some(language),
        host_takes_poses: false,
        fixed_speeds: false,
        folders: crate::Folders::default(),
        program: crate::Program::of_tests("tests"),
        host_view: crate::HostView::default(),
    })
    .unwrap()
}

pub(crate) fn pyramid() -> Document {
    let file = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/pyramid.vid");
    Document::load(&file).unwrap()
}

/// The whole window, at `scale` pixels for a point.
pub(crate) fn window<'a>(editor: Editor, size: Vec2, scale: f32) -> Harness<'a, Editor> {
    let mut prepared = false;
    let mut harness = Harness::builder()
        .with_size(size)
        .with_pixels_per_point(scale)
        .with_step_dt(1.0 / 60.0)
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

/// The viewport of the movement window.
pub(super) fn viewport(harness: &Harness<'_, Editor>) -> Rect {
    let name = harness.state().texts().space.name;
    harness.get_by_label(name).rect()
}

/// Where a point of the movement space is seen.
pub(crate) fn image(harness: &Harness<'_, Editor>, at: DVec3) -> Pos2 {
    projection_of(harness.state(), viewport(harness)).pos(at)
}

pub(crate) fn motion(harness: &mut Harness<'_, Editor>, to: Pos2) {
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

pub(crate) fn press(harness: &mut Harness<'_, Editor>, pos: Pos2, which: PointerButton) {
    motion(harness, pos);
    button(harness, pos, which, true);
}

pub(crate) fn release(harness: &mut Harness<'_, Editor>, pos: Pos2, which: PointerButton) {
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
        editor.setup.theme = Some(theme);
        editor.document.select(3, 0).unwrap();
        let mut harness = window(editor, vec2(1200.0, 800.0), scale);
        screenshot(&mut harness, name);
        harness.state_mut().scrub(180.0);
        harness.state_mut().setup.view.rotation = -35.0;
        harness.step();
        screenshot(&mut harness, &format!("play-{name}"));
        harness.state_mut().setup.view = View::default();
        harness.step();
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

pub(super) const BUTTONS: [(PointerButton, Axis); 3] = [
    (PointerButton::Primary, Axis::X),
    (PointerButton::Middle, Axis::Y),
    (PointerButton::Secondary, Axis::Z),
];

pub(crate) fn pyramid_window<'a>() -> Harness<'a, Editor> {
    window(
        editor(pyramid(), Language::English),
        vec2(1200.0, 800.0),
        1.0,
    )
}

pub(super) fn position(harness: &Harness<'_, Editor>, at: usize) -> DVec3 {
    harness.state().document.path().points[at].position
}

pub(super) fn target(harness: &Harness<'_, Editor>, at: usize) -> Target {
    harness.state().document.path().points[at].orientations[0].target
}

pub(super) fn message(harness: &Harness<'_, Editor>) -> Option<(String, bool)> {
    let message = harness.state().message.as_ref()?;
    Some((message.text.clone(), message.error))
}

pub(super) fn tips(harness: &Harness<'_, Editor>) -> picking::Tips {
    picking::tips(&harness.state().document).unwrap()
}

pub(super) fn key(
    harness: &mut Harness<'_, Editor>,
    key: Key,
    pressed: bool,
    modifiers: Modifiers,
) {
    harness.event(Event::Key {
        key,
        physical_key: None,
        pressed,
        repeat: false,
        modifiers,
    });
    harness.step();
}

pub(crate) fn tap(harness: &mut Harness<'_, Editor>, which: Key, modifiers: Modifiers) {
    key(harness, which, true, modifiers);
    key(harness, which, false, modifiers);
}

/// A path's text says every bit of it.
pub(super) fn text(harness: &Harness<'_, Editor>) -> String {
    harness.state().document.to_toml().unwrap()
}

/// An empty place.
pub(super) fn empty(harness: &Harness<'_, Editor>) -> Pos2 {
    viewport(harness).left_bottom() + vec2(150.0, -60.0)
}

#[test]
fn each_button_drags_in_its_plane_and_a_drag_is_one_step() {
    for (which, axis) in BUTTONS {
        let mut harness = pyramid_window();
        let before = text(&harness);
        let from = position(&harness, 4);
        let start = image(&harness, from);
        press(&mut harness, start + vec2(3.0, -2.0), which);
        assert_eq!(harness.state().document.selection().point, 4);
        assert_eq!(text(&harness), before);
        // Every motion on the way, not the last one only.
        for step in 1..=8_u8 {
            let pointer = start + vec2(-4.0, 3.0) * f32::from(step);
            motion(&mut harness, pointer);
            let now = position(&harness, 4);
            let seen = Projection::new(&harness.state().setup.view, viewport(&harness)).image(now);
            assert!(seen.distance(from_pos(pointer)) < 1e-6, "{axis:?}");
            let index = axis.index();
            assert_eq!(now[index].to_bits(), from[index].to_bits());
            let (said, error) = message(&harness).unwrap();
            assert!(said.starts_with("Position") && !error, "{said}");
            let x = harness.state().language().number(now.x, 3);
            assert!(said.contains(&x), "{said}");
        }
        let end = start + vec2(-32.0, 24.0);
        release(&mut harness, end, which);
        assert_eq!(crate::tests::said_besides_length(&harness), None);
        let dragged = text(&harness);
        assert_ne!(dragged, before);
        let document = &mut harness.state_mut().document;
        assert!(document.undo());
        assert!(!document.can_undo());
        assert_eq!(text(&harness), before);
        assert!(harness.state_mut().document.redo());
        assert_eq!(text(&harness), dragged);
    }
}

#[test]
fn held_keys_stand_for_buttons() {
    for (which, axis) in [(Key::X, Axis::X), (Key::Y, Axis::Y), (Key::Z, Axis::Z)] {
        let mut harness = pyramid_window();
        let from = position(&harness, 2);
        let start = image(&harness, from);
        key(&mut harness, which, true, Modifiers::NONE);
        press(&mut harness, start, PointerButton::Primary);
        let end = start + vec2(12.0, 9.0);
        motion(&mut harness, end);
        let now = position(&harness, 2);
        for other in Axis::ALL {
            let same = now[other.index()].to_bits() == from[other.index()].to_bits();
            assert_eq!(same, other == axis, "{axis:?} {other:?}");
        }
        // The plane stays when the key is let go, and changes with another one.
        key(&mut harness, which, false, Modifiers::NONE);
        let next = [Key::Y, Key::Z, Key::X][axis.index()];
        key(&mut harness, next, true, Modifiers::NONE);
        let fixed = Axis::ALL[(axis.index() + 1) % 3];
        motion(&mut harness, end + vec2(5.0, 5.0));
        let later = position(&harness, 2);
        assert_eq!(later[fixed.index()].to_bits(), now[fixed.index()].to_bits());
        assert_ne!(later, now);
        release(&mut harness, end + vec2(5.0, 5.0), PointerButton::Primary);
        assert!(harness.state_mut().document.undo());
        assert!(!harness.state().document.can_undo());
    }
}

#[test]
fn a_press_alone_makes_current_and_changes_nothing() {
    let mut harness = pyramid_window();
    let before = text(&harness);
    for at in [3, 5, 1] {
        let there = image(&harness, position(&harness, at)) + vec2(-4.0, 3.0);
        press(&mut harness, there, PointerButton::Primary);
        // Hands tremble.
        motion(&mut harness, there + vec2(1.0, -1.0));
        release(
            &mut harness,
            there + vec2(1.0, -1.0),
            PointerButton::Primary,
        );
        assert_eq!(harness.state().document.selection().point, at);
    }
    assert_eq!(text(&harness), before);
    assert!(!harness.state().document.can_undo());
}

#[test]
fn escape_takes_a_drag_back() {
    let mut harness = pyramid_window();
    let before = text(&harness);
    let start = image(&harness, position(&harness, 2));
    press(&mut harness, start, PointerButton::Middle);
    motion(&mut harness, start + vec2(30.0, 10.0));
    assert_ne!(text(&harness), before);
    tap(&mut harness, Key::Escape, Modifiers::NONE);
    assert_eq!(text(&harness), before);
    // What the pointer does now is no drag any more.
    motion(&mut harness, start + vec2(60.0, 10.0));
    release(
        &mut harness,
        start + vec2(60.0, 10.0),
        PointerButton::Middle,
    );
    assert_eq!(text(&harness), before);
    let document = &harness.state().document;
    assert!(!document.can_undo() && !document.can_redo() && !document.is_modified());
    // The view, too.
    let view = harness.state().setup.view;
    let start = empty(&harness);
    press(&mut harness, start, PointerButton::Primary);
    motion(&mut harness, start + vec2(50.0, -20.0));
    assert_ne!(harness.state().setup.view, view);
    tap(&mut harness, Key::Escape, Modifiers::NONE);
    assert_eq!(harness.state().setup.view, view);
}

#[test]
fn an_undo_ends_a_drag() {
    let mut harness = pyramid_window();
    let before = text(&harness);
    let start = image(&harness, position(&harness, 2));
    press(&mut harness, start, PointerButton::Middle);
    motion(&mut harness, start + vec2(30.0, 10.0));
    assert!(harness.state_mut().document.undo());
    motion(&mut harness, start + vec2(40.0, 20.0));
    assert_eq!(text(&harness), before);
    release(
        &mut harness,
        start + vec2(40.0, 20.0),
        PointerButton::Middle,
    );
    assert_eq!(text(&harness), before);
}

#[test]
fn the_tip_of_vpn_moves_in_a_plane_too() {
    for (which, axis) in BUTTONS {
        let mut harness = pyramid_window();
        let tip = tips(&harness).target;
        let start = image(&harness, tip);
        press(&mut harness, start, which);
        let end = start + vec2(21.0, 13.0);
        motion(&mut harness, end);
        let Target::Absolute(now) = target(&harness, 0) else {
            panic!("it stays absolute");
        };
        assert_eq!(now[axis.index()].to_bits(), tip[axis.index()].to_bits());
        let projection = Projection::new(&harness.state().setup.view, viewport(&harness));
        assert!(projection.image(now).distance(from_pos(end)) < 1e-6);
        assert!(message(&harness).unwrap().0.starts_with("Target"));
        release(&mut harness, end, which);
        assert!(harness.state_mut().document.undo());
        assert!(!harness.state().document.can_undo());
    }
}

#[test]
fn the_tip_of_vup_rolls_with_the_left_button_only() {
    let mut harness = pyramid_window();
    let before = text(&harness);
    let start = image(&harness, tips(&harness).up_tip);
    for which in [PointerButton::Middle, PointerButton::Secondary] {
        press(&mut harness, start, which);
        motion(&mut harness, start + vec2(20.0, 20.0));
        release(&mut harness, start + vec2(20.0, 20.0), which);
    }
    assert_eq!(text(&harness), before);
    harness.state_mut().setup.view = View::default();
    harness.step();
    let start = image(&harness, tips(&harness).up_tip);
    press(&mut harness, start, PointerButton::Primary);
    let centre = image(&harness, tips(&harness).position);
    for turn in 1..12_u8 {
        let way = Vec2::angled(f32::from(turn) * 0.5) * 70.0;
        motion(&mut harness, centre + way);
        let seen = image(&harness, tips(&harness).up_tip) - centre;
        let off = (seen.angle() - way.angle()).to_degrees();
        let off = (off + 180.0).rem_euclid(360.0) - 180.0;
        assert!(off.abs() < 0.1, "{off}");
        assert!(message(&harness).unwrap().0.starts_with("Roll"));
    }
    release(&mut harness, centre, PointerButton::Primary);
    assert!(harness.state_mut().document.undo());
    assert_eq!(text(&harness), before);
}

/// All texts in the picture.
pub(super) fn shown(harness: &Harness<'_, Editor>) -> Vec<String> {
    let shapes = harness.output().shapes.iter();
    let texts = shapes.filter_map(|clipped| match &clipped.shape {
        egui::Shape::Text(text) => Some(text.galley.text().to_owned()),
        _ => None,
    });
    texts.collect()
}

/// Tells of keys that are held.
pub(crate) fn hold(harness: &mut Harness<'_, Editor>, modifiers: Modifiers) {
    harness.event(Event::ModifiersChanged(modifiers));
    harness.step();
}

#[test]
fn empty_space_turns_and_shifts_and_the_wheel_enlarges() {
    let mut harness = pyramid_window();
    let before = text(&harness);
    let view = |harness: &Harness<'_, Editor>| harness.state().setup.view;
    let start = empty(&harness);
    press(&mut harness, start, PointerButton::Primary);
    motion(&mut harness, start + vec2(20.0, 10.0));
    release(
        &mut harness,
        start + vec2(20.0, 10.0),
        PointerButton::Primary,
    );
    let turned = view(&harness);
    assert!(turned.rotation > 28.0 && turned.tilt > 20.0);
    press(&mut harness, start, PointerButton::Middle);
    motion(&mut harness, start + vec2(20.0, 10.0));
    release(
        &mut harness,
        start + vec2(20.0, 10.0),
        PointerButton::Middle,
    );
    let shifted = view(&harness);
    assert!(shifted.shift[0] > 0.0 && shifted.shift[1] < 0.0);
    let wheel = |harness: &mut Harness<'_, Editor>, steps: f32| {
        harness.event(Event::MouseWheel {
            unit: MouseWheelUnit::Line,
            delta: vec2(0.0, steps),
            phase: egui::TouchPhase::Move,
            source: egui::MouseWheelSource::Wheel,
            modifiers: Modifiers::NONE,
        });
        harness.step();
    };
    // What lies under the pointer stays there.
    let point = position(&harness, 4);
    let under = image(&harness, point);
    motion(&mut harness, under);
    wheel(&mut harness, 3.0);
    assert!((view(&harness).size - 1.1f64.powi(3)).abs() < 1e-9);
    assert!(image(&harness, point).distance(under) < 0.01);
    // Small again it is back in the middle.
    wheel(&mut harness, -5.0);
    assert!(view(&harness).size < 1.0);
    assert_eq!(view(&harness).shift, [0.0; 2]);
    for _ in 0..2 {
        press(&mut harness, start, PointerButton::Primary);
        release(&mut harness, start, PointerButton::Primary);
    }
    assert_eq!(view(&harness), View::default());
    assert_eq!(text(&harness), before);
}

#[test]
fn the_pointer_tells_what_it_would_do() {
    let mut harness = pyramid_window();
    let cursor = |harness: &Harness<'_, Editor>| harness.output().platform_output.cursor_icon;
    let at = empty(&harness);
    motion(&mut harness, at);
    assert_eq!(cursor(&harness), CursorIcon::Default);
    press(&mut harness, at, PointerButton::Primary);
    assert_eq!(cursor(&harness), CursorIcon::Grabbing);
    release(&mut harness, at, PointerButton::Primary);
    let at = image(&harness, position(&harness, 3));
    motion(&mut harness, at);
    assert_eq!(cursor(&harness), CursorIcon::Grab);
    press(&mut harness, at, PointerButton::Middle);
    motion(&mut harness, at + vec2(20.0, 0.0));
    assert_eq!(cursor(&harness), CursorIcon::Crosshair);
    release(&mut harness, at + vec2(20.0, 0.0), PointerButton::Middle);
}

#[test]
fn what_stands_above_the_space_keeps_its_presses() {
    let mut harness = pyramid_window();
    let before = harness.state().setup.view;
    let inside = harness.get_by_label("What the camera sees").rect().center();
    press(&mut harness, inside, PointerButton::Secondary);
    motion(&mut harness, inside + vec2(-30.0, 20.0));
    release(
        &mut harness,
        inside + vec2(-30.0, 20.0),
        PointerButton::Secondary,
    );
    assert_eq!(harness.state().setup.view, before);
}

/// A small flight in a large space is brought into view when its file opens, and by F; what is begun
/// around an object is seen with it.
#[test]
fn a_flight_that_opens_is_seen() {
    use crate::tests::{At, Edit, LARGE, Language, Options, Theme, options, press, window_of};
    let small = |file: Option<&str>| {
        let mut document = Document::new();
        for at in 0..2 {
            let place = DVec3::new(0.5, 0.5 + 0.02 * at as f64, 0.5);
            document
                .apply(Edit::set(At::Point(at), "position", place))
                .unwrap();
        }
        let options = Options {
            document,
            file: file.map(Into::into),
            ..options(Language::English)
        };
        window_of(options, LARGE, 1.0, Theme::Dark)
    };
    let mut window = small(Some("flight.vid"));
    let opened = window.state().setup.view;
    assert!(opened.size > 10.0, "{opened:?}");
    let viewport = window
        .get_by_label(window.state().texts().space.name)
        .rect();
    let projection = projection_of(window.state(), viewport);
    for point in &window.state().document.path().points {
        assert!(
            viewport
                .shrink(20.0)
                .contains(projection.pos(point.position))
        );
    }
    window.state_mut().setup.view = View::default();
    window.hover_at(viewport.center());
    window.run();
    press(&mut window, egui::Modifiers::NONE, Key::F);
    assert_eq!(window.state().setup.view, opened);
    assert_eq!(small(None).state().setup.view, View::default());
}
