//! Out and in again; files written by hand; broken ones.

use std::path::{Path, PathBuf};

use glam::{DAffine3, DQuat, DVec3};
use proptest::prelude::*;
use vides_engine::scene::{Channel, Interpolation, Kind, NodeState, Track, Warnings};

use super::*;
use crate::document::SceneDocument;
use crate::loss::Loss;
use crate::path::Pose;
use crate::{Imported, by_name, export_to, import};

fn example(name: &str) -> SceneDocument {
    let folder = PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples"));
    SceneDocument::load(&folder.join(name)).unwrap()
}

/// Everything that the format holds.
fn everything() -> SceneDocument {
    SceneDocument::from_toml(include_str!("everything.vid")).unwrap()
}

fn written(document: &SceneDocument, format: &str, options: &Options) -> (Vec<u8>, Report) {
    let mut file = Vec::new();
    let format = by_name(format).unwrap();
    let report = export_to(document, &mut file, format, options, &mut |_, _| {}).unwrap();
    (file, report)
}

fn read(file: Vec<u8>) -> crate::Result<Imported> {
    import(&Source::of_bytes("flight", file), None, &Options::default())
}

fn taken(json: &str) -> Imported {
    read(json.as_bytes().to_vec()).unwrap()
}

fn states(document: &SceneDocument, frame: f64) -> Vec<NodeState> {
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
        assert!((old - new).abs() < 1e-6 && (old.fract() != 0.0 || old == new), "{new}");
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

/// A file of text with a buffer of these floats, each list an accessor.
fn file(rest: &str, lists: &[(&str, &[f32])]) -> String {
    let mut bytes: Vec<u8> = Vec::new();
    let (mut views, mut accessors) = (Vec::new(), Vec::new());
    for (at, (kind, numbers)) in lists.iter().enumerate() {
        let width = match *kind {
            "VEC3" => 3,
            "VEC4" => 4,
            _ => 1,
        };
        let (start, length) = (bytes.len(), 4 * numbers.len());
        bytes.extend(numbers.iter().flat_map(|number| number.to_le_bytes()));
        views.push(format!(
            r#"{{"buffer": 0, "byteOffset": {start}, "byteLength": {length}}}"#
        ));
        accessors.push(format!(
            r#"{{"bufferView": {at}, "componentType": 5126, "count": {}, "type": "{kind}"}}"#,
            numbers.len() / width
        ));
    }
    let mut data = Vec::new();
    write_base64(&bytes, &mut data).unwrap();
    format!(
        r#"{{"asset": {{"version": "2.0"}}, {rest}, "accessors": [{}], "bufferViews": [{}],
        "buffers": [{{"byteLength": {}, "uri": "data:application/octet-stream;base64,{}"}}]}}"#,
        accessors.join(","),
        views.join(","),
        bytes.len(),
        String::from_utf8(data).unwrap(),
    )
}

fn found<'a>(imported: &'a Imported, name: &str) -> &'a vides_engine::scene::Node {
    let scene = &imported.document.scene;
    &scene.nodes()[scene.find(name).unwrap()]
}

#[test]
fn cubic_keys_are_those_of_the_specification() {
    let rest = r#""nodes": [{"name": "a"}], "animations": [{
        "samplers": [{"input": 0, "output": 1, "interpolation": "CUBICSPLINE"}],
        "channels": [{"sampler": 0, "target": {"node": 0, "path": "translation"}}]}]"#;
    let (a, v0, m0) = ([9.0; 3], [0.0, 1.0, 2.0], [1.0, -2.0, 0.5]);
    let (m1, v1, b) = ([3.0, 0.0, -1.0], [4.0, 1.0, 0.0], [7.0; 3]);
    let output: Vec<f32> = [a, v0, m0, m1, v1, b].concat();
    let read = taken(&file(rest, &[("SCALAR", &[1.0, 3.0]), ("VEC3", &output)]));
    // At 25 frames a second: seconds 1 and 3 are frames 26 and 76.
    assert_eq!(found(&read, "a").keys().tracks()[0].frames(), [26.0, 76.0]);
    for share in [0.0, 0.125, 0.5, 0.9, 1.0] {
        let state = &states(&read.document, 26.0 + 50.0 * share)[0];
        let (t, t2, t3) = (share, share * share, share * share * share);
        for k in 0..3 {
            // Appendix C, spline interpolation, over two seconds.
            let wanted = (2.0 * t3 - 3.0 * t2 + 1.0) * f64::from(v0[k])
                + 2.0 * (t3 - 2.0 * t2 + t) * f64::from(m0[k])
                + (-2.0 * t3 + 3.0 * t2) * f64::from(v1[k])
                + 2.0 * (t3 - t2) * f64::from(m1[k]);
            assert!((state.matrix[12 + k] - wanted).abs() < 1e-12);
        }
    }
}

/// A field of view that opens straight: between its keys too.
#[test]
fn fields_of_view_stay_straight_between_keys() {
    let rest = r#""nodes": [{"camera": 0}, {"camera": 1}],
        "cameras": [
          {"type": "perspective", "perspective": {"yfov": 0.5, "znear": 0.25}},
          {"type": "orthographic", "orthographic": {"xmag": 1, "ymag": 1, "znear": 0, "zfar": 9}}],
        "extensionsUsed": ["KHR_animation_pointer"],
        "animations": [{
        "samplers": [{"input": 0, "output": 1}],
        "channels": [{"sampler": 0, "target": {"path": "pointer", "extensions": {
          "KHR_animation_pointer": {"pointer": "/cameras/0/perspective/yfov"}}}}]},
        {"samplers": [], "channels": []}]"#;
    let read = taken(&file(
        rest,
        &[("SCALAR", &[0.0, 1.0, 2.0]), ("SCALAR", &[0.5, 1.5, 3.14])],
    ));
    for (frame, wanted) in [(1.0, 0.5), (11.0, 0.9), (26.0, 1.5)] {
        let zoom = states(&read.document, frame)[0].pose.zoom;
        let field = crate::convention::field_of_view(zoom);
        assert!((field - wanted).abs() < 1e-6, "{frame}: {field}");
    }
    let losses = read.report.losses();
    assert!(losses.contains(&Loss::OtherAnimations(1)), "{losses:?}");
    assert!(matches!(losses[1], Loss::FieldsClamped(count) if (1..25).contains(&count)));
    let flat = Loss::NotTaken {
        what: "an orthographic projection".into(),
        count: 1,
    };
    assert!(losses.contains(&flat));
    // Cameras at the origin look along −z.
    assert_eq!(states(&read.document, 1.0)[0].pose.vpn, [0.0, 0.0, -1.0]);
    let Kind::Camera(camera) = found(&read, "camera 0").kind else {
        panic!();
    };
    assert_eq!((camera.near, camera.far), (0.25, 25000.0));
}

#[test]
fn nodes_of_others_are_taken_as_they_stand() {
    let json = r#"{"asset": {"version": "2.0"}, "nodes": [
        {"name": "twice", "matrix": [0,0,-2,0, 0,3,0,0, 1,0,0,0, 5,6,7,1], "children": [1, 2, 3]},
        {"name": "twice", "camera": 0, "children": [4]},
        {"matrix": [1,0,0,0, 0.5,1,0,0, 0,0,1,0, 0,0,0,1], "skin": 0},
        {"extensions": {"KHR_lights_punctual": {"light": 0}}},
        {"name": "a\nb", "scale": [2, 0, -1]}],
        "cameras": [{"type": "perspective", "perspective": {"yfov": 1, "znear": 0.1, "zfar": 4}}],
        "skins": [{"joints": [0]}],
        "extensions": {"KHR_lights_punctual": {"lights": [
          {"type": "spot", "color": [0.5, 0.25, 1], "intensity": 7,
           "spot": {"innerConeAngle": 0.1}}]}}}"#;
    let read = taken(json);
    let scene = &read.document.scene;
    let names: Vec<&str> = scene
        .nodes()
        .iter()
        .map(|node| node.name.as_str())
        .collect();
    // A camera with children hangs on a node of its own; parents come first.
    assert_eq!(
        names,
        ["twice", "twice 2", "twice view", "a", "node 2", "light 3"]
    );
    let state = &states(&read.document, 1.0)[2];
    assert_eq!(state.pose.vrp, [5.0, 6.0, 7.0]);
    // Along −z, which the node above turns to −x.
    assert!(DVec3::from(state.pose.vpn).distance(-DVec3::X) < 1e-12);
    assert!(read.report.losses().contains(&Loss::Sheared(1)));
    assert!(read.report.losses().contains(&Loss::Skins(1)));
    let light = found(&read, "light 3");
    assert_eq!(
        (light.rest.colour, light.rest.intensity),
        ([0.5, 0.25, 1.0], 7.0)
    );
    assert!((light.rest.cone[1] - 45.0).abs() < 1e-12);
    let space = scene.space();
    // All on one spot: as large as it is far away.
    assert_eq!((space.up, space.half_size), (Up::Y, 7.0));
}

#[test]
fn what_is_wrong_is_told_with_its_place() {
    let animation = r#""nodes": [{}], "animations": [{
        "samplers": [{"input": 0, "output": 1}],
        "channels": [{"sampler": 0, "target": {"node": 0, "path": "translation"}}]}]"#;
    let moved = file(animation, &[("SCALAR", &[1.0, 1.0]), ("VEC3", &[0.0; 6])]);
    let few = file(animation, &[("SCALAR", &[1.0, 2.0]), ("VEC3", &[0.0; 3])]);
    let nan = file(
        animation,
        &[("SCALAR", &[1.0, 2.0]), ("VEC3", &[f32::NAN; 6])],
    );
    let head = r#"{"asset": {"version": "2.0"}, "nodes": [{"#;
    for (json, said) in [
        (
            moved,
            "animations[0].samplers[0].input: the times must increase",
        ),
        (
            few,
            "animations[0].samplers[0].output: expected 6 numbers, found 3",
        ),
        (nan, "key 1: a value must be a finite number"),
        (format!(r#"{head}"camera": 3}}]}}"#), "cameras is not there"),
        (
            format!(r#"{head}"rotation": [0, 0, 0, 0]}}]}}"#),
            "nodes[0]: the rotation is zero",
        ),
        (
            format!(r#"{head}"mesh": -1}}]}}"#),
            "nodes[0].mesh: expected a whole number",
        ),
        (format!(r#"{head}"children": [0]}}]}}"#), "below itself"),
        (
            r#"{"asset": {"version": "2.0"}}"#.to_owned(),
            "there are no poses",
        ),
        (
            format!(r#"{head}}}], "extensionsRequired": ["EXT_strange"]}}"#),
            "requires the extension EXT_strange",
        ),
        (
            format!(r#"{head}}}], "buffers": [{{"byteLength": 1, "uri": "../a.bin"}}]}}"#),
            "a buffer of this file is gone",
        ),
    ] {
        let error = read(json.clone().into_bytes()).unwrap_err().to_string();
        assert!(error.contains(said), "{json}: {error}");
    }
}

#[test]
fn any_bytes_do_no_harm() {
    for format in ["glb", "gltf"] {
        let (file, _) = written(&everything(), format, &Options::default());
        let format = by_name(format).unwrap();
        let look = |bytes: Vec<u8>| {
            let source = Source::of_bytes("flight", bytes);
            let _ = import(&source, Some(format), &Options::default());
        };
        let step = 1 + file.len() / 3000;
        for end in (0..file.len()).step_by(step) {
            look(file[..end].to_vec());
        }
        let mut seed = 1_u64;
        for _ in 0..3000 {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            let at = (seed >> 33) as usize % file.len();
            let mut broken = file.clone();
            broken[at] ^= 1 << (seed >> 61);
            look(broken);
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

#[test]
fn a_file_beside_is_read_and_none_outside() {
    let folder = tempfile::tempdir().unwrap();
    let inside = folder.path().join("in");
    std::fs::create_dir(&inside).unwrap();
    let json = |uri: &str| {
        format!(
            r#"{{"asset": {{"version": "2.0"}}, "nodes": [{{"mesh": 0}}],
            "meshes": [{{"primitives": [{{"attributes": {{"POSITION": 0}}}}]}}],
            "accessors": [{{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}}],
            "bufferViews": [{{"buffer": 0, "byteLength": 36}}],
            "buffers": [{{"byteLength": 36, "uri": "{uri}"}}]}}"#
        )
    };
    let write = |path: &Path, bytes: &[u8]| std::fs::write(path, bytes).unwrap();
    write(&folder.path().join("out.bin"), &[0; 36]);
    write(&inside.join("my points.bin"), &[0; 36]);
    let look = |uri: &str| {
        let file = inside.join("scene.gltf");
        write(&file, json(uri).as_bytes());
        import(&Source::open(&file).unwrap(), None, &Options::default())
    };
    look("my%20points.bin").unwrap();
    let absolute = folder.path().join("out.bin");
    for outside in ["../out.bin", "%2e%2e/out.bin", absolute.to_str().unwrap()] {
        assert!(
            look(outside).unwrap_err().to_string().contains("a buffer"),
            "{outside}"
        );
    }
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
