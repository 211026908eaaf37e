//! Nodes that are clicked, keys on their ways that are dragged, and what a drag costs.

use egui::{Event, Key, Modifiers, PointerButton, Pos2, vec2};
use glam::DVec3;
use vides_document::Edit;
use vides_engine::path::CameraPath;
use vides_engine::scene::{Channel, Interpolation, Kind, Light, Node, Scene, Track};

use super::nodes_tests::{
    CAMERA, NONE, NUMBERS, OTHER, THING, Window, is_one_step, keyed, pivot_of, scene, typed,
    window_of,
};
use super::tests::{
    editor, hold, image, message, motion, press, release, tap, text, viewport, window,
};
use super::*;
use crate::screenshots::screenshot;
use crate::setup::Theme;
use crate::texts::{Language, fill};

#[test]
fn numbers_out_of_range_are_told_and_nothing_changes() {
    let mut harness = window_of(scene(), &[THING]);
    let (before, state) = (text(&harness), harness.state().document.state_number());
    tap(&mut harness, Key::M, NONE);
    tap(&mut harness, Key::X, NONE);
    harness.event(Event::Text("1000000000000000000".to_owned()));
    harness.step();
    let (said, error) = message(&harness).unwrap();
    assert!(error, "{said}");
    tap(&mut harness, Key::Enter, NONE);
    assert_eq!(text(&harness), before);
    assert_eq!(harness.state().document.state_number(), state);
    // A path moves what follows it.
    let mut harness = window_of(scene(), &[CAMERA, THING]);
    let before = text(&harness);
    for key in [Key::M, Key::R, Key::P] {
        tap(&mut harness, key, NONE);
        let wanted = fill(harness.state().texts().space.path_moves_it, &[&"camera"]);
        assert_eq!(message(&harness), Some((wanted, true)));
    }
    assert_eq!(text(&harness), before);
    // Lights have no pivot.
    let mut harness = window_of(scene(), &[4]);
    typed(&mut harness, &[Key::P, Key::X], "1");
    assert_eq!(text(&harness), before);
    // With nothing selected there is nothing to move.
    let mut harness = window_of(scene(), &[]);
    let context = harness.ctx.clone();
    harness
        .state_mut()
        .act(Action::SelectNodes(Vec::new()), &context);
    harness.step();
    for key in [Key::M, Key::P] {
        tap(&mut harness, key, NONE);
        assert!(harness.state().space.pointer.transform.is_none());
        let wanted = harness.state().texts().space.needs_nodes.to_owned();
        assert_eq!(message(&harness), Some((wanted, true)));
    }
}

fn click(harness: &mut Window<'_>, at: Pos2, held: Modifiers) {
    hold(harness, held);
    press(harness, at, PointerButton::Primary);
    release(harness, at, PointerButton::Primary);
    hold(harness, NONE);
}

fn world_image(harness: &Window<'_>, node: usize, at: DVec3) -> Pos2 {
    let place = harness
        .state()
        .with_scene(|now| (now.into_path * now.states[node].world()).transform_point3(at));
    image(harness, place.unwrap().unwrap())
}

#[test]
fn a_click_selects_signs_before_lines_and_then_what_lies_behind() {
    let mut harness = window_of(scene(), &[THING]);
    let before = text(&harness);
    let lamp = world_image(&harness, 4, DVec3::ZERO);
    click(&mut harness, lamp + vec2(4.0, 3.0), NONE);
    assert_eq!(harness.state().selected_nodes(), [4]);
    click(&mut harness, lamp + vec2(60.0, 60.0), NONE);
    // A line of an object, away from its pivot.
    let line = world_image(&harness, OTHER, DVec3::new(0.15, 0.0, 0.0));
    click(&mut harness, line + vec2(0.0, 3.0), NONE);
    assert_eq!(harness.state().selected_nodes(), [OTHER]);
    // Ctrl and Shift take one more, or one less.
    click(&mut harness, lamp, Modifiers::CTRL);
    assert_eq!(harness.state().selected_nodes(), [4, OTHER]);
    click(&mut harness, line, Modifiers::SHIFT);
    assert_eq!(harness.state().selected_nodes(), [4]);
    // Two at one place: the second click takes the other one, the third the first again.
    let mut both = scene();
    let mut second = Node::new("second", Kind::Light(Light::Spot));
    second.rest.position = DVec3::new(0.6, 0.7, -0.2);
    let second = both.add(second).unwrap();
    let mut harness = window_of(both, &[THING]);
    let view = harness.state().setup.view;
    for wanted in [4, second, 4] {
        click(&mut harness, lamp, NONE);
        assert_eq!(harness.state().selected_nodes(), [wanted]);
    }
    // Also where the clicks are quick.
    assert_eq!(harness.state().setup.view, view);
    click(&mut harness, lamp + vec2(0.0, 5.0), NONE);
    assert_eq!(
        harness.state().selected_nodes(),
        [4],
        "elsewhere it begins anew"
    );
    // More than six points away is beside it: the star of a point light is longer than that, so
    // the sign is tried.
    let only = nodes::at(
        harness.state(),
        &projection_of(harness.state(), viewport(&harness)),
        viewport(&harness),
        world_image(&harness, OTHER, DVec3::from_array(NUMBERS[OTHER][2])) + vec2(0.0, 5.9),
    );
    assert_eq!(only.first(), Some(&OTHER));
    assert!(!harness.state().document.is_modified() && !before.is_empty());
}

#[test]
fn a_sign_is_taken_within_six_points_and_no_farther() {
    let mut alone = Scene::new();
    alone.add(Node::new("far", Kind::Group)).unwrap();
    let mut one = Node::new("one", Kind::Group);
    one.rest.position = DVec3::new(0.4, 0.3, -0.2);
    one.pivot = DVec3::new(0.1, 0.1, 0.1);
    alone.add(one).unwrap();
    let harness = window_of(alone, &[0]);
    let place = world_image(&harness, 1, DVec3::splat(0.1));
    let viewport = viewport(&harness);
    let projection = projection_of(harness.state(), viewport);
    for turn in 0..16_u8 {
        let way = egui::Vec2::angled(f32::from(turn));
        let at = |far: f32| nodes::at(harness.state(), &projection, viewport, place + far * way);
        assert_eq!((at(5.99), at(6.01)), (vec![1], vec![]), "{turn}");
    }
}

#[test]
fn points_of_the_edited_path_come_before_nodes() {
    let mut crowded = scene();
    let start = CameraPath::default().points[0].position;
    let mut lamp = Node::new("near", Kind::Light(Light::Point));
    lamp.rest.position = start;
    let near = crowded.add(lamp).unwrap();
    let mut harness = window_of(crowded, &[CAMERA]);
    assert!(harness.state().document.edits_path());
    let at = image(&harness, start);
    click(&mut harness, at, NONE);
    assert!(harness.state().document.edits_path());
    assert_eq!(harness.state().document.selection().point, 0);
    // Letters mean the path's points, until the node is shown.
    tap(&mut harness, Key::M, NONE);
    assert!(harness.state().document.in_step());
    tap(&mut harness, Key::Escape, NONE);
    let context = harness.ctx.clone();
    harness
        .state_mut()
        .act(Action::SelectNodes(vec![near]), &context);
    harness.step();
    assert!(!harness.state().document.edits_path());
    click(&mut harness, at, NONE);
    assert_eq!(harness.state().selected_nodes(), [near]);
}

#[test]
fn keys_on_the_way_of_a_node_are_dragged() {
    let mut moving = scene();
    let track = keyed(Channel::Position, Interpolation::CatmullRom, 3);
    moving.set_track(OTHER, track.clone()).unwrap();
    let mut harness = window_of(moving, &[OTHER]);
    harness.state_mut().setup.theme = Some(Theme::Light);
    screenshot(&mut harness, "nodes-way.png");
    let before = text(&harness);
    let pivot = DVec3::from_array(NUMBERS[OTHER][2]);
    let place = DVec3::from_slice(&track.values()[9..12]) + pivot;
    let from = image(&harness, place);
    let to = from + vec2(-30.0, 25.0);
    press(&mut harness, from, PointerButton::Primary);
    motion(&mut harness, to);
    release(&mut harness, to, PointerButton::Primary);
    let scene = harness.state().document.scene().unwrap();
    let now = scene.nodes()[OTHER]
        .keys()
        .track(&Channel::Position)
        .unwrap();
    assert_eq!(now.frames(), track.frames());
    assert_eq!(now.values()[..9], track.values()[..9]);
    let place = DVec3::from_slice(&now.values()[9..12]) + pivot;
    assert!(image(&harness, place).distance(to) < 1e-3);
    is_one_step(&mut harness, &before);
}

#[test]
fn arrow_keys_move_nodes_and_delete_removes_them() {
    let mut harness = window_of(scene(), &[OTHER]);
    let before = text(&harness);
    let of = |harness: &Window<'_>| {
        harness.state().document.scene().unwrap().nodes()[OTHER]
            .rest
            .position
    };
    let from = of(&harness);
    let ways = [
        (Key::ArrowRight, vec2(1.0, 0.0)),
        (Key::ArrowLeft, vec2(-1.0, 0.0)),
        (Key::ArrowUp, vec2(0.0, -1.0)),
        (Key::ArrowDown, vec2(0.0, 1.0)),
    ];
    for (key, way) in ways {
        let at = image(&harness, pivot_of(&harness, OTHER));
        tap(&mut harness, key, Modifiers::SHIFT);
        let seen = image(&harness, pivot_of(&harness, OTHER)) - at;
        assert!(seen.dot(way) > 0.0, "{key:?} {seen:?}");
        let by = of(&harness) - from;
        assert!((by.abs().element_sum() - 0.1).abs() < 1e-12, "{by}");
        harness.step();
        is_one_step(&mut harness, &before);
        harness.step();
    }
    tap(&mut harness, Key::Delete, NONE);
    harness.step();
    let scene = harness.state().document.scene().unwrap();
    assert_eq!(scene.find("other"), None);
    assert_eq!(scene.nodes().len(), 5);
    assert!(harness.state_mut().document.undo());
    assert_eq!(text(&harness), before);
}

/// A pass of a drag in a scene of 200,000 keys, and one that scrubs it. What else the machine does
/// only makes passes longer, so the least ones count.
#[test]
fn timed_a_drag_costs_about_as_much_as_scrubbing() {
    let mut large = Scene::new();
    for at in 0..200 {
        let mut node = Node::new(&format!("node {at}"), Kind::Group);
        let far = f64::from(at) * 0.005;
        node.rest.position = DVec3::new(far, 0.5 - far, -far);
        let at = large.add(node).unwrap();
        let frames: Vec<f64> = (1..=1_000).map(f64::from).collect();
        let values = (0..3_000).map(|k| 0.5 * (0.01 * f64::from(k)).sin());
        let by = Interpolation::Linear;
        let track = Track::new(Channel::Position, by, frames, values.collect(), Vec::new());
        large.set_track(at, track.unwrap()).unwrap();
    }
    let mut harness = window_of(large, &[100]);
    let (mut scrub, mut drag) = (f64::INFINITY, f64::INFINITY);
    let pass = |least: &mut f64, harness: &mut Window<'_>| {
        let before = crate::tests::spent();
        harness.step();
        *least = least.min(crate::tests::spent() - before);
    };
    for round in 0..30 {
        if round >= 3 && drag <= 1.5 * scrub {
            break;
        }
        for at in 0..20_u8 {
            harness.state_mut().set_frame(20.0 + f64::from(at)).unwrap();
            pass(&mut scrub, &mut harness);
        }
        harness.state_mut().set_frame(20.0).unwrap();
        harness.step();
        let from = image(&harness, pivot_of(&harness, 100));
        press(&mut harness, from, PointerButton::Primary);
        motion(&mut harness, from + vec2(5.0, 5.0));
        assert!(harness.state().document.in_step());
        for at in 0..20_u8 {
            harness.event(Event::PointerMoved(from + vec2(6.0 + f32::from(at), 7.0)));
            pass(&mut drag, &mut harness);
        }
        tap(&mut harness, Key::Escape, NONE);
        release(&mut harness, from, PointerButton::Primary);
    }
    println!(
        "a pass of a drag takes {:.2} of one that scrubs",
        drag / scrub
    );
    assert!(drag <= 1.5 * scrub, "drag {drag}, scrub {scrub}");
}

#[test]
fn pictures_of_selected_nodes() {
    for (language, theme, size, name) in [
        (
            Language::English,
            Theme::Light,
            vec2(1200.0, 800.0),
            "en-light",
        ),
        (
            Language::German,
            Theme::Dark,
            vec2(800.0, 600.0),
            "de-small",
        ),
    ] {
        let mut moving = scene();
        let track = keyed(Channel::Position, Interpolation::CatmullRom, 3);
        moving.set_track(OTHER, track).unwrap();
        let mut document = Document::new();
        document
            .apply(Edit::ReplaceScene(Box::new(moving)))
            .unwrap();
        let mut editor = editor(document.as_opened(), language);
        editor.setup.theme = Some(theme);
        editor.select_nodes(vec![OTHER]);
        let _ = editor.set_frame(20.0);
        let mut harness = window(editor, size, 1.0);
        let at = image(&harness, pivot_of(&harness, OTHER));
        motion(&mut harness, at);
        screenshot(&mut harness, &format!("nodes-{name}.png"));
        for key in [Key::M, Key::X, Key::X] {
            tap(&mut harness, key, NONE);
        }
        motion(&mut harness, at + vec2(40.0, 10.0));
        screenshot(&mut harness, &format!("nodes-moved-{name}.png"));
    }
}
