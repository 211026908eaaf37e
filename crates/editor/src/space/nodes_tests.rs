//! Nodes of a scene that are selected, moved, turned and scaled in the movement window. Where they
//! come to lie is computed here from numbers and matrices written out, not by the engine.

use egui::{Event, Key, Modifiers, PointerButton, vec2};
use egui_kittest::Harness;
use glam::{DQuat, DVec3};
use vides_document::Edit;
use vides_engine::path::CameraPath;
use vides_engine::scene::{
    Channel, Extrapolation, FollowPath, Interpolation, Kind, Light, Mesh, Node, NodeState, Object,
    Scene, Track, Warnings,
};

use super::tests::{editor, image, motion, press, release, tap, text, window};
use super::*;
use crate::texts::Language;

pub(super) type Window<'a> = Harness<'a, Editor>;
type Matrix = [[f64; 4]; 4];

pub(super) const NONE: Modifiers = Modifiers::NONE;
pub(super) const THING: usize = 2;
pub(super) const OTHER: usize = 3;
pub(super) const CAMERA: usize = 5;

fn times(a: Matrix, b: Matrix) -> Matrix {
    let mut out = [[0.0; 4]; 4];
    for (i, row) in out.iter_mut().enumerate() {
        for (j, cell) in row.iter_mut().enumerate() {
            *cell = (0..4).map(|k| a[i][k] * b[k][j]).sum();
        }
    }
    out
}

fn shifted([x, y, z]: [f64; 3]) -> Matrix {
    [
        [1.0, 0.0, 0.0, x],
        [0.0, 1.0, 0.0, y],
        [0.0, 0.0, 1.0, z],
        [0.0, 0.0, 0.0, 1.0],
    ]
}

fn scaled([x, y, z]: [f64; 3]) -> Matrix {
    [
        [x, 0.0, 0.0, 0.0],
        [0.0, y, 0.0, 0.0],
        [0.0, 0.0, z, 0.0],
        [0.0, 0.0, 0.0, 1.0],
    ]
}

/// The matrix of a unit quaternion w, x, y, z.
fn turned([w, x, y, z]: [f64; 4]) -> Matrix {
    [
        [
            1.0 - 2.0 * (y * y + z * z),
            2.0 * (x * y - w * z),
            2.0 * (x * z + w * y),
            0.0,
        ],
        [
            2.0 * (x * y + w * z),
            1.0 - 2.0 * (x * x + z * z),
            2.0 * (y * z - w * x),
            0.0,
        ],
        [
            2.0 * (x * z - w * y),
            2.0 * (y * z + w * x),
            1.0 - 2.0 * (x * x + y * y),
            0.0,
        ],
        [0.0, 0.0, 0.0, 1.0],
    ]
}

/// A turn about the axis with this number.
fn about(axis: usize, degrees: f64) -> Matrix {
    let (sin, cos) = (0.5 * degrees.to_radians()).sin_cos();
    let mut q = [cos, 0.0, 0.0, 0.0];
    q[axis + 1] = sin;
    turned(q)
}

/// What a node has: position, rotation, scale and pivot.
#[derive(Clone, Copy)]
struct Has {
    position: [f64; 3],
    rotation: Matrix,
    scale: [f64; 3],
    pivot: [f64; 3],
}

impl Has {
    fn local(&self) -> Matrix {
        let [x, y, z] = self.pivot;
        let place = times(shifted(self.position), shifted(self.pivot));
        let own = times(times(place, self.rotation), scaled(self.scale));
        times(own, shifted([-x, -y, -z]))
    }
}

const ROTATIONS: [[f64; 4]; 4] = [
    [0.5, 0.5, -0.5, 0.5],
    [0.7, 0.1, 0.7, -0.1],
    [0.9, -0.3, 0.3, 0.1],
    [0.1, 0.7, 0.1, 0.7],
];

pub(super) const NUMBERS: [[[f64; 3]; 3]; 4] = [
    [[0.2, -0.1, 0.3], [1.5, 0.7, 1.2], [0.0, 0.0, 0.0]],
    [[-0.3, 0.25, 0.1], [0.8, -1.3, 1.1], [0.1, 0.2, -0.1]],
    [[0.15, 0.1, -0.2], [0.9, 1.2, 0.6], [0.05, -0.1, 0.2]],
    [[-0.5, -0.4, 0.35], [1.0, 0.5, 2.0], [0.3, 0.0, 0.1]],
];

fn has(at: usize) -> Has {
    let [position, scale, pivot] = NUMBERS[at];
    let q = ROTATIONS[at];
    let length = q.iter().map(|part| part * part).sum::<f64>().sqrt();
    let rotation = turned(q.map(|part| part / length));
    Has {
        position,
        rotation,
        scale,
        pivot,
    }
}

/// The world of "thing" if it has this: in "arm", which is in "base".
fn world_of_thing(thing: Has) -> Matrix {
    times(times(has(0).local(), has(1).local()), thing.local())
}

/// Base, arm and thing in one another, another object, a lamp, a camera on a path.
pub(super) fn scene() -> Scene {
    let mut scene = Scene::new();
    let kinds = ["base", "arm", "thing", "other"];
    for (at, name) in kinds.into_iter().enumerate() {
        let kind = match at {
            THING | OTHER => Kind::Object(Object::default()),
            _ => Kind::Group,
        };
        let mut node = Node::new(name, kind);
        node.parent = [None, Some(0), Some(1), None][at];
        let [position, scale, pivot] = NUMBERS[at].map(DVec3::from_array);
        (node.rest.position, node.rest.scale, node.pivot) = (position, scale, pivot);
        let [w, x, y, z] = ROTATIONS[at];
        node.rest.rotation = DQuat::from_xyzw(x, y, z, w);
        scene.add(node).unwrap();
        if matches!(at, THING | OTHER) {
            let corners = [[0.0, 0.0, 0.0], [0.3, 0.0, 0.0], [0.0, 0.3, 0.0]];
            let mesh = Mesh {
                points: corners.map(DVec3::from_array).to_vec(),
                triangles: vec![[0, 1, 2]],
                ..Mesh::default()
            };
            scene.set_mesh(at, mesh).unwrap();
        }
    }
    let mut lamp = Node::new("lamp", Kind::Light(Light::Point));
    lamp.rest.position = DVec3::new(0.6, 0.7, -0.2);
    scene.add(lamp).unwrap();
    let mut camera = Node::new("camera", Kind::Camera(Default::default()));
    let path = FollowPath::new(CameraPath::default(), 1.0, Extrapolation::Hold).unwrap();
    camera.set_path(Some(path)).unwrap();
    scene.add(camera).unwrap();
    scene
}

pub(super) fn keyed(channel: Channel, by: Interpolation, width: usize) -> Track {
    let frames = vec![1.0, 12.5, 30.0, 41.0];
    let some = |count: usize, by: f64| -> Vec<f64> {
        (0..count)
            .map(|at| (by * (at as f64 + 1.0)).sin() * 0.4)
            .collect()
    };
    let shape = match by {
        Interpolation::Hermite => some(8 * width, 1.7)
            .iter()
            .map(|slope| slope * 0.05)
            .collect(),
        Interpolation::Tcb => some(12, 2.3),
        _ => Vec::new(),
    };
    Track::new(channel, by, frames, some(4 * width, 0.9), shape).unwrap()
}

pub(super) fn window_of<'a>(scene: Scene, selected: &[usize]) -> Window<'a> {
    let mut document = Document::new();
    document.apply(Edit::ReplaceScene(Box::new(scene))).unwrap();
    let mut editor = editor(document.as_opened(), Language::English);
    editor.select_nodes(selected.to_vec());
    let _ = editor.set_frame(20.0);
    let mut harness = window(editor, vec2(1200.0, 800.0), 1.0);
    harness.step();
    harness
}

fn states(harness: &Window<'_>, frame: f64) -> Vec<NodeState> {
    let scene = harness.state().document.scene().unwrap();
    let mut states = vec![NodeState::default(); scene.nodes().len()];
    scene
        .evaluate(frame, &mut states, &mut Warnings::default())
        .unwrap();
    states
}

/// The largest difference of a node's matrix at the playhead.
fn off(harness: &Window<'_>, node: usize, wanted: Matrix) -> f64 {
    let frame = harness.state().frame().unwrap();
    let state = &states(harness, frame)[node];
    let cells = (0..16).map(|at| (state.matrix[at] - wanted[at % 4][at / 4]).abs());
    cells.fold(0.0, f64::max)
}

/// Presses letters and types a number, then Enter.
pub(super) fn typed(harness: &mut Window<'_>, keys: &[Key], number: &str) {
    for &key in keys {
        tap(harness, key, NONE);
    }
    harness.event(Event::Text(number.to_owned()));
    harness.step();
    tap(harness, Key::Enter, NONE);
    harness.step();
}

/// One step, whose undoing restores every bit.
pub(super) fn is_one_step(harness: &mut Window<'_>, before: &str) {
    let after = text(harness);
    assert_ne!(after, before);
    assert!(!harness.state().document.in_step());
    assert!(harness.state_mut().document.undo());
    assert_eq!(text(harness), before);
    assert!(harness.state_mut().document.redo());
    assert_eq!(text(harness), after);
    assert!(harness.state_mut().document.undo());
    harness.state_mut().select_touched();
}

#[test]
fn typed_numbers_move_turn_and_scale_a_node_in_its_parents_axes_or_its_own() {
    use Key::{M, R, S, X, Y, Z};
    let of = has(THING);
    let along = |axis: usize, by: f64, own: bool| {
        let mut to = of;
        for row in 0..3 {
            let share = match own {
                true => of.rotation[row][axis],
                false => f64::from(u8::from(row == axis)),
            };
            to.position[row] += by * share;
        }
        to
    };
    let with = |rotation: Matrix| Has { rotation, ..of };
    let size = |by: [f64; 3]| {
        let [x, y, z] = of.scale;
        Has {
            scale: [x * by[0], y * by[1], z * by[2]],
            ..of
        }
    };
    let all: [(&[Key], &str, Has); 12] = [
        (&[M, X], "0.25", along(0, 0.25, false)),
        (&[M, Z], "-0.4", along(2, -0.4, false)),
        (&[M, Y, Y], "0.3", along(1, 0.3, true)),
        (&[M, Z, Z], "0.125", along(2, 0.125, true)),
        (&[R, X], "30", with(times(about(0, 30.0), of.rotation))),
        (&[R, Y], "-75", with(times(about(1, -75.0), of.rotation))),
        (&[R, Z, Z], "40", with(times(of.rotation, about(2, 40.0)))),
        (&[R, X, X], "200", with(times(of.rotation, about(0, 200.0)))),
        (&[S], "1.5", size([1.5; 3])),
        (&[S, Y], "2", size([1.0, 2.0, 1.0])),
        (&[S, X, X], "-0.5", size([-0.5, 1.0, 1.0])),
        // The third time there is no axis any more.
        (&[S, Y, Y, Y], "3", size([3.0; 3])),
    ];
    for (keys, number, wanted) in all {
        let mut harness = window_of(scene(), &[THING]);
        assert!(off(&harness, THING, world_of_thing(of)) < 1e-12);
        let before = text(&harness);
        typed(&mut harness, keys, number);
        let off = off(&harness, THING, world_of_thing(wanted));
        assert!(off < 1e-9, "{keys:?} {number}: {off}");
        is_one_step(&mut harness, &before);
    }
}

#[test]
fn what_moves_by_keys_gets_a_key_at_the_playhead_and_the_others_stay() {
    let mut moving = scene();
    let tracks = [
        keyed(Channel::Position, Interpolation::CatmullRom, 3),
        keyed(Channel::Scale, Interpolation::Hermite, 3),
    ];
    for track in tracks.clone() {
        moving.set_track(THING, track).unwrap();
    }
    let mut harness = window_of(moving, &[THING]);
    let before = text(&harness);
    let at = |track: &Track| {
        let mut value = [0.0; 3];
        track.numbers(20.0, &mut value, &mut Warnings::default());
        value
    };
    let [mut position, scale] = [at(&tracks[0]), at(&tracks[1])];
    position[1] += 0.2;
    typed(&mut harness, &[Key::M, Key::Y], "0.2");
    let wanted = Has {
        position,
        scale,
        ..has(THING)
    };
    assert!(off(&harness, THING, world_of_thing(wanted)) < 1e-9);
    let scene = harness.state().document.scene().unwrap();
    let keys = scene.nodes()[THING].keys();
    let track = keys.track(&Channel::Position).unwrap();
    assert_eq!(track.frames(), [1.0, 12.5, 20.0, 30.0, 41.0]);
    assert_eq!(track.values()[..6], tracks[0].values()[..6]);
    assert_eq!(keys.track(&Channel::Scale), Some(&tracks[1]));
    assert_eq!(
        scene.nodes()[THING].rest.position.to_array(),
        NUMBERS[THING][0]
    );
    is_one_step(&mut harness, &before);
}

/// Both turn about the middle of their pivots, in the axes of the first one's parent.
#[test]
fn several_nodes_go_together_also_out_of_different_parents() {
    // The parents are turned and of one scale: else a turn would be a shear.
    let mut plain = Scene::new();
    let mut base = Node::new("base", Kind::Group);
    base.rest.position = DVec3::new(0.2, 0.1, -0.3);
    base.rest.scale = DVec3::splat(0.5);
    base.rest.rotation = DQuat::from_xyzw(0.5, 0.5, 0.5, 0.5);
    plain.add(base).unwrap();
    for (name, parent, at) in [
        ("one", Some(0), [0.4, 0.0, 0.2]),
        ("two", None, [-0.3, 0.2, 0.6]),
    ] {
        let mut node = Node::new(name, Kind::Group);
        (node.parent, node.rest.position) = (parent, DVec3::from_array(at));
        node.pivot = DVec3::new(0.1, 0.2, 0.3);
        plain.add(node).unwrap();
    }
    let base = Has {
        position: [0.2, 0.1, -0.3],
        rotation: turned([0.5; 4]),
        scale: [0.5; 3],
        pivot: [0.0; 3],
    };
    let one = Has {
        position: [0.4, 0.0, 0.2],
        rotation: shifted([0.0; 3]),
        scale: [1.0; 3],
        pivot: [0.1, 0.2, 0.3],
    };
    let two = Has {
        position: [-0.3, 0.2, 0.6],
        ..one
    };
    let place = |matrix: Matrix, at: [f64; 3]| {
        let row = |row: usize| matrix[row][3] + (0..3).map(|k| matrix[row][k] * at[k]).sum::<f64>();
        [row(0), row(1), row(2)]
    };
    let worlds = [times(base.local(), one.local()), two.local()];
    let pivots = worlds.map(|world| place(world, one.pivot));
    let middle = [0, 1, 2].map(|k| 0.5 * (pivots[0][k] + pivots[1][k]));
    // About the world's axis that is the base's x: y.
    let there = shifted(middle);
    let back = shifted(middle.map(|part| -part));
    let about_base = |change: Matrix| {
        let inverse = turned([0.5, -0.5, -0.5, -0.5]);
        times(times(turned([0.5; 4]), change), inverse)
    };
    let turn = times(times(there, about_base(about(0, 50.0))), back);
    for first in [1, 2] {
        let mut harness = window_of(plain.clone(), &[first, 3 - first]);
        let before = text(&harness);
        let change = match first {
            1 => turn,
            _ => times(times(there, about(0, 50.0)), back),
        };
        typed(&mut harness, &[Key::R, Key::X], "50");
        for (node, world) in [1, 2].into_iter().zip(worlds) {
            let off = off(&harness, node, times(change, world));
            assert!(off < 1e-9, "{node} with {first} first: {off}");
        }
        is_one_step(&mut harness, &before);
        typed(&mut harness, &[Key::S], "2");
        let change = times(times(there, scaled([2.0; 3])), back);
        for (node, world) in [1, 2].into_iter().zip(worlds) {
            assert!(off(&harness, node, times(change, world)) < 1e-9, "{node}");
        }
        is_one_step(&mut harness, &before);
        typed(&mut harness, &[Key::M, Key::Z], "0.4");
        let by = match first {
            // Half of the base's z, which is the world's x.
            1 => [0.2, 0.0, 0.0],
            _ => [0.0, 0.0, 0.4],
        };
        for (node, world) in [1, 2].into_iter().zip(worlds) {
            assert!(
                off(&harness, node, times(shifted(by), world)) < 1e-9,
                "{node}"
            );
        }
        is_one_step(&mut harness, &before);
    }
    // What is in a node that goes along is not moved twice.
    let mut harness = window_of(scene(), &[0, THING]);
    typed(&mut harness, &[Key::M, Key::X], "0.5");
    let base = has(0);
    let [x, y, z] = base.position;
    let moved = Has {
        position: [x + 0.5, y, z],
        ..base
    };
    let wanted = times(times(moved.local(), has(1).local()), has(THING).local());
    assert!(off(&harness, THING, wanted) < 1e-9);
}

/// The pivot of a node in the space.
pub(super) fn pivot_of(harness: &Window<'_>, node: usize) -> DVec3 {
    let all = nodes::selected_pivots(harness.state());
    all.into_iter().find(|(at, _)| *at == node).unwrap().1
}

#[test]
fn the_mouse_moves_a_node_by_its_pivot_and_the_pivot_stays_under_the_pointer() {
    let of = has(THING);
    let mut harness = window_of(scene(), &[THING]);
    let before = text(&harness);
    let from = image(&harness, pivot_of(&harness, THING));
    press(&mut harness, from, PointerButton::Primary);
    for step in 1..=8_u8 {
        let to = from + vec2(6.0, -5.0) * f32::from(step);
        motion(&mut harness, to);
        let there = image(&harness, pivot_of(&harness, THING));
        assert!(there.distance(to) < 1e-3, "{there:?} {to:?}");
    }
    // One of the parent's coordinates stays.
    let now = harness.state().document.scene().unwrap().nodes()[THING]
        .rest
        .position;
    let same = (0..3).filter(|&k| now[k].to_bits() == of.position[k].to_bits());
    assert_eq!(same.count(), 1);
    // Along an axis it goes as far as the pointer along that.
    tap(&mut harness, Key::X, NONE);
    let now = harness.state().document.scene().unwrap().nodes()[THING]
        .rest
        .position;
    assert!(now.x != of.position[0] && now.y == of.position[1] && now.z == of.position[2]);
    release(
        &mut harness,
        from + vec2(48.0, -40.0),
        PointerButton::Primary,
    );
    is_one_step(&mut harness, &before);
    // Escape gives back.
    let state = harness.state().document.state_number();
    press(&mut harness, from, PointerButton::Primary);
    motion(&mut harness, from + vec2(30.0, 30.0));
    assert_ne!(text(&harness), before);
    tap(&mut harness, Key::Escape, NONE);
    release(
        &mut harness,
        from + vec2(30.0, 30.0),
        PointerButton::Primary,
    );
    assert_eq!(text(&harness), before);
    assert_eq!(harness.state().document.state_number(), state);
    // The ring turns it about the axis of the parent that points at the viewer.
    let ring = from + vec2(56.0, 0.0);
    press(&mut harness, ring, PointerButton::Primary);
    motion(&mut harness, from + vec2(0.0, -56.0));
    release(
        &mut harness,
        from + vec2(0.0, -56.0),
        PointerButton::Primary,
    );
    let turned: Vec<f64> = [0, 1, 2]
        .into_iter()
        .flat_map(|axis| [90.0, -90.0].map(|by| (axis, by)))
        .map(|(axis, by)| {
            let rotation = times(about(axis, by), of.rotation);
            off(&harness, THING, world_of_thing(Has { rotation, ..of }))
        })
        .collect();
    assert_eq!(
        turned.iter().filter(|off| **off < 1e-6).count(),
        1,
        "{turned:?}"
    );
    is_one_step(&mut harness, &before);
}

/// What is turned by the mouse follows it: the mirrored arm turns the other way round.
#[test]
fn a_turn_by_the_mouse_is_seen_as_the_mouse_makes_it() {
    for node in [THING, OTHER] {
        let mut harness = window_of(scene(), &[node]);
        let centre = image(&harness, pivot_of(&harness, node));
        let corner = |harness: &Window<'_>| {
            let place = harness.state().with_scene(|now| {
                let world = now.into_path * now.states[node].world();
                world.transform_point3(DVec3::new(0.3, 0.3, 0.3))
            });
            image(harness, place.unwrap().unwrap()) - centre
        };
        let before = corner(&harness);
        press(
            &mut harness,
            centre + vec2(56.0, 0.0),
            PointerButton::Primary,
        );
        let small = vec2(56.0 * 0.1_f32.cos(), 56.0 * 0.1_f32.sin());
        motion(&mut harness, centre + small);
        release(&mut harness, centre + small, PointerButton::Primary);
        let after = corner(&harness);
        // Clockwise, as y runs downwards.
        let way = before.x * after.y - before.y * after.x;
        assert!(way > 0.0, "{node}: {before:?} {after:?}");
    }
}

/// How far matrices of a node are apart over these frames.
fn apart(before: &Scene, after: &Scene, node: usize, frames: impl Iterator<Item = f64>) -> f64 {
    let mut most = 0.0_f64;
    for frame in frames {
        let [a, b] = [before, after].map(|scene| {
            let mut states = vec![NodeState::default(); scene.nodes().len()];
            scene
                .evaluate(frame, &mut states, &mut Warnings::default())
                .unwrap();
            states[node].matrix
        });
        most = (0..16).map(|k| (a[k] - b[k]).abs()).fold(most, f64::max);
    }
    most
}

#[test]
fn the_pivot_moves_and_the_node_stays_at_every_frame() {
    use Interpolation::{CatmullRom, Cubic, Hermite, Linear, Parabolic, Ramp, Sine, Step, Tcb};
    let finely = || (0..150).map(|at| -3.0 + 0.377 * f64::from(at));
    let ways = [
        Step, Linear, Ramp, Sine, Parabolic, CatmullRom, Hermite, Tcb, Cubic,
    ];
    for by in ways.into_iter().map(Some).chain([None]) {
        let mut moving = scene();
        if let Some(by) = &by {
            let track = keyed(Channel::Position, by.clone(), 3);
            moving.set_track(THING, track).unwrap();
        }
        let mut harness = window_of(moving, &[THING]);
        let (before, old) = (text(&harness), harness.state().document.scene().unwrap());
        let from = pivot_of(&harness, THING);
        typed(&mut harness, &[Key::P, Key::Z], "0.35");
        let new = harness.state().document.scene().unwrap();
        let off = apart(&old, &new, THING, finely());
        assert!(off < 1e-12, "{by:?}: {off}");
        // It has gone along the parent's z.
        let arm = times(has(0).local(), has(1).local());
        let wanted = DVec3::new(arm[0][2], arm[1][2], arm[2][2]) * 0.35;
        assert!((pivot_of(&harness, THING) - from - wanted).length() < 1e-9);
        assert_eq!(
            new.nodes()[THING].keys().tracks().len(),
            usize::from(by.is_some())
        );
        is_one_step(&mut harness, &before);
    }
    // Where keys turn and scale it, the position gets a key a frame.
    let mut moving = scene();
    for (channel, width) in [
        (Channel::Rotation, 4),
        (Channel::Scale, 3),
        (Channel::Position, 3),
    ] {
        moving
            .set_track(THING, keyed(channel, CatmullRom, width))
            .unwrap();
    }
    let mut harness = window_of(moving, &[THING]);
    let (before, old) = (text(&harness), harness.state().document.scene().unwrap());
    typed(&mut harness, &[Key::P, Key::X], "0.5");
    let new = harness.state().document.scene().unwrap();
    let (first, last) = old.frame_range();
    let whole = (first as u32..=last as u32).map(f64::from).chain([12.5]);
    let off = apart(&old, &new, THING, whole);
    assert!(off < 1e-12, "{off}");
    assert!(new.nodes()[THING].pivot != old.nodes()[THING].pivot);
    is_one_step(&mut harness, &before);
}
