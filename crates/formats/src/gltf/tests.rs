//! Out and in again.

use std::path::PathBuf;

use glam::{DAffine3, DQuat, DVec3};
use proptest::prelude::*;
use vides_document::SceneDocument;
use vides_engine::path::Pose;
use vides_engine::scene::{Channel, Interpolation, Kind, NodeState, Track, Warnings};

use super::*;
use crate::loss::Loss;
use crate::{Imported, by_name, export_to, import};

fn example(name: &str) -> SceneDocument {
    let folder = PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples"));
    SceneDocument::load(&folder.join(name)).unwrap()
}

/// Everything that the format holds.
pub(super) fn everything() -> SceneDocument {
    SceneDocument::from_toml(include_str!("everything.vid")).unwrap()
}

pub(super) fn written(
    document: &SceneDocument,
    format: &str,
    options: &Options,
) -> (Vec<u8>, Report) {
    let mut file = Vec::new();
    let format = by_name(format).unwrap();
    let report = export_to(document, &mut file, format, options, &mut |_, _| {}).unwrap();
    (file, report)
}

pub(super) fn read(file: Vec<u8>) -> crate::Result<Imported> {
    import(&Source::of_bytes("flight", file), None, &Options::default())
}

pub(super) fn taken(json: &str) -> Imported {
    read(json.as_bytes().to_vec()).unwrap()
}

pub(super) fn states(document: &SceneDocument, frame: f64) -> Vec<NodeState> {
    let scene = &document.scene;
    let mut states = vec![NodeState::default(); scene.nodes().len()];
    let warnings = &mut Warnings::default();
    scene.evaluate(frame, &mut states, warnings).unwrap();
    assert!(warnings.first().is_none());
    states
}

/// How far apart two rotations are, in degrees.
fn degrees(a: &Pose, b: &Pose) -> f64 {
    let both = [(a.vpn, b.vpn), (a.vup, b.vup)];
    let angles = both.map(|(a, b)| DVec3::from(a).angle_between(b.into()).to_degrees());
    angles[0].max(angles[1])
}

/// The same places, poses and values in all frames.
fn is_the_same(before: &SceneDocument, after: &SceneDocument, options: &Options) {
    let mut ignored = |_, _| {};
    let flight = Flight::new(before, options, &GLB, &mut ignored).unwrap();
    assert_eq!(after.info.fps, flight.fps());
    assert_eq!(f64::from(after.info.first_frame), flight.number(0).round());
    let size = before.scene.space().half_size * options.scale;
    for index in 0..flight.count() {
        let (old, new) = (
            states(before, flight.frame(index)),
            states(after, 1.0 + index as f64),
        );
        for (node, old) in before.scene.nodes().iter().zip(&old) {
            let at = after.scene.find(&node.name).unwrap();
            let (place, new) = (format!("{} at {index}", node.name), &new[at]);
            // What lies below is turned and scaled with the world, each in its own way.
            let inside = DAffine3::from_scale(DVec3::splat(options.scale)).inverse();
            let wanted = flight.to_file() * old.world() * inside;
            if !node.kind.looks() {
                assert!(new.world().abs_diff_eq(wanted, 2e-6 * size), "{place}");
            }
            if node.kind.looks() {
                let pose = &new.pose;
                let wanted = Pose {
                    vrp: flight.place(old.pose.vrp.into()).to_array(),
                    vpn: flight.direction(old.pose.vpn.into()).to_array(),
                    vup: flight.direction(old.pose.vup.into()).to_array(),
                    ..old.pose
                };
                let off = pose.position().distance(wanted.position());
                assert!(off < 2e-6 * size, "{place}: {off}");
                assert!(
                    degrees(pose, &wanted) < 0.01,
                    "{place}: {}",
                    degrees(pose, &wanted)
                );
                let fields = [pose.zoom, wanted.zoom].map(crate::convention::field_of_view);
                assert!((fields[0] - fields[1]).to_degrees().abs() < 1e-3, "{place}");
            }
            match &node.kind {
                Kind::Object(object) if !object.mesh().points.is_empty() => {
                    assert_eq!(new.visible, old.visible, "{place}");
                    points_are_the_same(before, after, &node.name, index, &flight);
                }
                Kind::Light(_) => {
                    assert_eq!(new.visible, old.visible, "{place}");
                    let light = |state: &NodeState| DVec3::from(state.colour) * state.intensity;
                    let [new, old] = [new, old].map(light);
                    assert!(
                        (new - old).length() < 1e-6 * old.length(),
                        "{place}: {new} {old}"
                    );
                }
                _ => {}
            }
        }
    }
}

/// Morphed points of a node in the world.
fn points_are_the_same(
    before: &SceneDocument,
    after: &SceneDocument,
    name: &str,
    index: usize,
    flight: &Flight<'_>,
) {
    let points = |document: &SceneDocument, frame: f64| {
        let scene = &document.scene;
        let at = scene.find(name).unwrap();
        let Kind::Object(object) = &scene.nodes()[at].kind else {
            panic!("{name} is no object");
        };
        let mut points = vec![DVec3::ZERO; object.mesh().points.len()];
        let warnings = &mut Warnings::default();
        scene.vertices(at, frame, &mut points, warnings).unwrap();
        points
    };
    let old = points(before, flight.frame(index));
    let new = points(after, 1.0 + index as f64);
    assert_eq!(old.len(), new.len());
    for (old, new) in old.iter().zip(&new) {
        let old = *old * flight.options().scale;
        assert!(
            old.distance(*new) < 1e-6 * (1.0 + old.length()),
            "{name} at {index}: {old} {new}"
        );
    }
}

#[test]
fn what_goes_out_comes_in_again() {
    let scaled = Options {
        scale: 2.5,
        ..Options::default()
    };
    let some = Options {
        frames: Some((12.0, 30.0)),
        fps: Some(60.0),
        ..Options::default()
    };
    for (document, options) in [
        (example("pyramid.vid"), &Options::default()),
        (example("car.vid"), &Options::default()),
        (everything(), &Options::default()),
        (everything(), &scaled),
        (everything(), &some),
    ] {
        for format in ["glb", "gltf"] {
            let (file, _) = written(&document, format, options);
            let imported = read(file).unwrap();
            assert_eq!(imported.format, format);
            assert!(imported.report.losses().is_empty(), "{:?}", imported.report);
            is_the_same(&document, &imported.document, options);
        }
    }
}

/// The range and the shown camera, where they are not what they would be without a word.
#[test]
fn range_and_camera_come_back() {
    let mut before = everything();
    let watcher = before.scene.find("watcher");
    assert_ne!(before.scene.shown_camera(), watcher);
    before.scene.set_camera(watcher).unwrap();
    before.scene.set_range(Some((-3.0, 40.0))).unwrap();
    let (file, _) = written(&before, "glb", &Options::default());
    let after = read(file).unwrap().document;
    assert_eq!(after.scene.shown_camera(), after.scene.find("watcher"));
    assert_eq!(after.scene.frame_range(), (1.0, 44.0));
    is_the_same(&before, &after, &Options::default());
    // Without cameras too.
    let mut scene = vides_engine::scene::Scene::new();
    scene
        .add(vides_engine::scene::Node::new("alone", Kind::Group))
        .unwrap();
    let document = SceneDocument::new(scene, vides_document::Info::default()).unwrap();
    for format in ["gltf", "glb"] {
        let (file, _) = written(&document, format, &Options::default());
        assert_eq!(read(file).unwrap().document.scene.nodes()[0].name, "alone");
    }
    let nothing = SceneDocument::new(Default::default(), vides_document::Info::default()).unwrap();
    let format = by_name("glb").unwrap();
    let file = &mut Vec::new();
    let refused = export_to(&nothing, file, format, &Options::default(), &mut |_, _| {});
    assert!(refused.unwrap_err().to_string().contains("no camera"));
}

#[test]
fn markers_are_told() {
    let mut document = everything();
    document.scene.set_marker("here", 3.0).unwrap();
    let told = written(&document, "glb", &Options::default()).1;
    assert!(told.losses().contains(&Loss::Markers(1)));
}

#[test]
fn nodes_come_back_as_they_were() {
    let before = everything();
    let (file, report) = written(&before, "glb", &Options::default());
    let told = [Loss::Aims(1), Loss::Interpolations(2)];
    assert_eq!(report.losses(), told);
    let after = read(file).unwrap().document;
    assert_eq!(after.info.title, before.info.title);
    let node = |document: &SceneDocument, name: &str| {
        document.scene.nodes()[document.scene.find(name).unwrap()].clone()
    };
    // The camera in a scaled node has left its own place to its children.
    assert_eq!(after.scene.nodes().len(), before.scene.nodes().len() + 1);
    for old in before.scene.nodes() {
        let new = node(&after, &old.name);
        assert_eq!(new.kind.name(), old.kind.name(), "{}", old.name);
        assert_eq!(new.pivot, old.pivot, "{}", old.name);
        for track in old.keys().tracks() {
            let channel = track.channel();
            let places = [Channel::Position, Channel::Scale, Channel::Weights];
            let visible = *channel == Channel::Visible;
            let known = [
                Interpolation::Step,
                Interpolation::Linear,
                Interpolation::Hermite,
            ];
            if !known.contains(track.interpolation()) {
                continue;
            }
            let kept = places.contains(channel) || visible;
            if kept || *channel == Channel::Rotation && old.name == "arm" {
                is_the_same_track(
                    track,
                    new.keys().track(channel).unwrap(),
                    old.parent.is_some(),
                );
            }
        }
    }
    let spot = node(&after, "lamp").rest;
    assert!((spot.cone[1] - 30.0).abs() < 1e-5 && spot.cone[0] < spot.cone[1]);
    let (arm, old) = (node(&after, "arm"), node(&before, "arm"));
    assert_eq!(arm.rest.colour, [0.5, 0.25, 1.0]);
    let (Kind::Object(new), Kind::Object(old)) = (&arm.kind, &old.kind) else {
        panic!();
    };
    assert_eq!(new.mesh(), old.mesh());
    assert_eq!(new.shapes(), old.shapes());
}

/// The keys, as far as 32 bits hold them; roots are turned upright.
fn is_the_same_track(old: &Track, new: &Track, below: bool) {
    assert_eq!(old.interpolation(), new.interpolation());
    for (old, new) in old.frames().iter().zip(new.frames()) {
        // Whole ones are whole again.
        assert!(
            (old - new).abs() < 1e-6 && (old.fract() != 0.0 || old == new),
            "{new}"
        );
    }
    let turn = match below {
        true => DQuat::IDENTITY,
        false => crate::convention::turn(Up::Z, Up::Y),
    };
    let turned = |numbers: &[f64]| match old.channel() {
        Channel::Position => (turn * DVec3::from_slice(numbers)).to_array().to_vec(),
        Channel::Rotation => {
            let [w, x, y, z] = *numbers else { panic!() };
            let q = turn * DQuat::from_xyzw(x, y, z, w);
            vec![q.w, q.x, q.y, q.z]
        }
        _ => numbers.to_vec(),
    };
    let width = old.width();
    for (old, new) in [(old.values(), new.values()), (old.shape(), new.shape())] {
        for (old, new) in old.chunks(width).zip(new.chunks(width)) {
            let off = turned(old)
                .iter()
                .zip(new)
                .fold(0.0, |off: f64, (a, b)| off.max((a - b).abs()));
            assert!(off < 1e-7, "{old:?} {new:?}");
        }
    }
}

/// The camera's axes and the pointer, by what stands in the file.
#[test]
fn a_camera_looks_along_minus_z() {
    let mut scene = vides_engine::scene::Scene::new();
    let camera = Kind::Camera(vides_engine::scene::Camera::default());
    let mut node = vides_engine::scene::Node::new("one", camera);
    node.rest.position = DVec3::new(1.0, 2.0, 3.0);
    // A quarter about y: the view is x.
    node.rest.rotation = DQuat::from_rotation_y(std::f64::consts::FRAC_PI_2);
    let zooms = Track::new(
        Channel::Zoom,
        Interpolation::Linear,
        vec![1.0, 3.0],
        vec![12.0, 36.0],
        Vec::new(),
    );
    node.set_track(zooms.unwrap()).unwrap();
    scene.add(node).unwrap();
    let document = SceneDocument::new(scene, vides_document::Info::default()).unwrap();
    let (file, report) = written(&document, "gltf", &Options::default());
    assert!(report.losses().is_empty());
    let json: serde_json::Value = serde_json::from_slice(&file).unwrap();
    let half = 0.5_f32.sqrt();
    // (w, x, y, z) = (c, 0, s, 0)·(0, 0, 1, 0) = (−s, 0, c, 0).
    let stored: Vec<f64> = json["nodes"][0]["rotation"]
        .as_array()
        .unwrap()
        .iter()
        .map(|number| number.as_f64().unwrap())
        .collect();
    for (found, wanted) in stored.iter().zip([0.0, half, 0.0, -half]) {
        assert!((found - f64::from(wanted)).abs() < 1e-7, "{stored:?}");
    }
    let yfov = json["cameras"][0]["perspective"]["yfov"].as_f64().unwrap();
    assert!((yfov - std::f64::consts::FRAC_PI_2).abs() < 1e-6);
    let target = &json["animations"][0]["channels"][0]["target"];
    let pointer = &target["extensions"]["KHR_animation_pointer"]["pointer"];
    assert_eq!(pointer, "/cameras/0/perspective/yfov");
    assert_eq!(
        json["animations"][0]["samplers"][0]["interpolation"],
        "LINEAR"
    );
}

/// The longer way round would be another motion in programs that do not look for the shorter.
#[test]
fn neighbouring_rotations_lie_in_one_hemisphere() {
    for document in [example("pyramid.vid"), example("car.vid"), everything()] {
        let (file, _) = written(&document, "glb", &Options::default());
        let word = |at: usize| u32::from_le_bytes(file[at..at + 4].try_into().unwrap()) as usize;
        let json: serde_json::Value = serde_json::from_slice(&file[20..20 + word(12)]).unwrap();
        let data = &file[28 + word(12)..];
        let mut seen = 0;
        for sampler in json["animations"][0]["samplers"].as_array().unwrap() {
            let accessor = &json["accessors"][sampler["output"].as_u64().unwrap() as usize];
            if accessor["type"] != "VEC4" || sampler["interpolation"] == "CUBICSPLINE" {
                continue;
            }
            let view = &json["bufferViews"][accessor["bufferView"].as_u64().unwrap() as usize];
            let start = view["byteOffset"].as_u64().unwrap() as usize;
            let numbers: Vec<f32> = (0..4 * accessor["count"].as_u64().unwrap() as usize)
                .map(|at| f32::from_le_bytes(data[start + 4 * at..][..4].try_into().unwrap()))
                .collect();
            for pair in numbers.chunks(4).collect::<Vec<_>>().windows(2) {
                let dot: f32 = pair[0].iter().zip(pair[1]).map(|(a, b)| a * b).sum();
                assert!(dot > -1e-6, "{pair:?}");
                seen += 1;
            }
        }
        assert!(seen > 50);
    }
}

/// Few keys, yet within what was asked for.
#[test]
fn compact_curves_stay_near() {
    for name in ["pyramid.vid", "car.vid"] {
        let document = example(name);
        let size = document.scene.space().half_size;
        let options = Options {
            compact: Some(1e-3 * size),
            angle: 0.1,
            ..Options::default()
        };
        let (plain, _) = written(&document, "glb", &Options::default());
        let (file, _) = written(&document, "glb", &options);
        assert!(
            file.len() < plain.len(),
            "{} of {}",
            file.len(),
            plain.len()
        );
        let after = read(file).unwrap().document;
        let (first, last) = document.scene.frame_range();
        let camera = document.scene.shown_camera().unwrap();
        let new_camera = after.scene.shown_camera().unwrap();
        let mut frame = first;
        while frame <= last {
            let old = states(&document, frame)[camera].pose;
            let new = states(&after, frame - first + 1.0)[new_camera].pose;
            let off = old.position().distance(new.position());
            assert!(off < 1.001e-3 * size, "{name} at {frame}: {off}");
            // View and up may each be off by all of it.
            assert!(
                degrees(&old, &new) < 0.101,
                "{name} at {frame}: {}",
                degrees(&old, &new)
            );
            frame += 1.0;
        }
    }
}

/// Meshes stay in their file, and come from it when the scene is loaded again.
#[test]
fn meshes_stay_in_their_file() {
    let folder = tempfile::tempdir().unwrap();
    let (file, _) = written(&everything(), "glb", &Options::default());
    let glb = folder.path().join("all.glb");
    std::fs::write(&glb, file).unwrap();
    let source = Source::open(&glb).unwrap();
    let read = import(&source, None, &Options::default()).unwrap().document;
    let vid = folder.path().join("all.vid");
    read.save(&vid).unwrap();
    let text = std::fs::read_to_string(&vid).unwrap();
    assert_eq!(
        text.matches("file = \"all.glb\"\npart = ").count(),
        4,
        "{text}"
    );
    let again = SceneDocument::load(&vid).unwrap();
    assert!(again.warnings().is_empty());
    assert_eq!(again, read);
    assert_eq!(mesh_bytes(&again), mesh_bytes(&read));
}

fn mesh_bytes(document: &SceneDocument) -> usize {
    let objects = document.scene.nodes().iter().map(|node| match &node.kind {
        Kind::Object(object) => object.mesh().points.len(),
        _ => 0,
    });
    objects.sum()
}

fn turn() -> impl Strategy<Value = DQuat> {
    prop::array::uniform4(-1.0..1.0)
        .prop_map(DQuat::from_array)
        .prop_filter("no rotation", |q| q.length() > 0.1)
}

fn place() -> impl Strategy<Value = DVec3> {
    prop::array::uniform3(-10.0..10.0).prop_map(DVec3::from_array)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// Chains of nodes with any places, scales and pivots, a camera at the end.
    #[test]
    fn any_tree_comes_back(
        chain in prop::collection::vec((place(), turn(), place(), 0.2..3.0, any::<[bool; 3]>()), 1..5),
        camera in (place(), turn(), 1.0..2000.0),
        keyed in any::<bool>(),
    ) {
        use vides_engine::scene::{Camera, Node, Scene};
        let mut scene = Scene::new();
        for (at, (position, rotation, pivot, scale, chosen)) in chain.iter().enumerate() {
            let mut node = Node::new(&format!("node {at}"), Kind::Group);
            node.parent = at.checked_sub(1);
            node.rest.position = *position;
            node.rest.rotation = *rotation;
            if chosen[0] {
                node.pivot = *pivot;
            }
            if chosen[1] {
                node.rest.scale = DVec3::splat(if chosen[2] { *scale } else { -*scale });
            }
            scene.add(node).unwrap();
        }
        let (position, rotation, zoom) = camera;
        let mut node = Node::new("camera", Kind::Camera(Camera::default()));
        node.parent = Some(chain.len() - 1);
        node.rest.position = position;
        node.rest.rotation = rotation;
        node.rest.zoom = zoom;
        if keyed {
            let turns = [rotation.normalize(), DQuat::IDENTITY, chain[0].1.normalize()];
            let values = turns.iter().flat_map(|q| [q.w, q.x, q.y, q.z]).collect();
            let frames = vec![1.0, 2.5, 9.0];
            let track = Track::new(Channel::Rotation, Interpolation::Linear, frames, values, Vec::new());
            node.set_track(track.unwrap()).unwrap();
        }
        scene.add(node).unwrap();
        let mut space = scene.space();
        space.half_size = 1000.0;
        scene.set_space(space).unwrap();
        let document = SceneDocument::new(scene, vides_document::Info::default()).unwrap();
        let (file, _) = written(&document, "glb", &Options::default());
        let imported = read(file).unwrap();
        is_the_same(&document, &imported.document, &Options::default());
    }
}

/// A new camera sees everything, however large it is; planes that someone set are kept.
#[test]
fn a_camera_sees_what_is_there() {
    let planes = |size: f64, own: &str| {
        let text = format!(
            "version = 1\n[space]\nhalf_size = {size:?}\n[object]\npoints = [[-{size:?}, 0.0, 0.0], \
             [{size:?}, 0.0, 0.0]]\n[[node]]\nname = \"camera\"\nkind = \"camera\"\n{own}"
        );
        let document = SceneDocument::from_toml(&text).unwrap();
        let (file, _) = written(&document, "gltf", &Options::default());
        let json: serde_json::Value = serde_json::from_slice(&file).unwrap();
        let lens = &json["cameras"][0]["perspective"];
        [&lens["znear"], &lens["zfar"]].map(|plane| plane.as_f64().unwrap())
    };
    for size in [0.002, 1.0, 8000.0] {
        let [near, far] = planes(size, "");
        assert!(near <= 0.02 * size && far >= 100.0 * size, "{near} {far}");
        assert_eq!(planes(size, "near = 0.5\nfar = 70.0\n"), [0.5, 70.0]);
    }
}
