//! Files written by hand, and broken ones.

use std::path::Path;

use glam::DVec3;
use vides_document::SceneDocument;
use vides_engine::scene::Kind;

use super::tests::{everything, read, states, taken, written};
use super::*;
use crate::loss::Loss;
use crate::{Imported, by_name, import};

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
    crate::base64::write(&bytes, &mut data).unwrap();
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
          "KHR_animation_pointer": {"pointer": "/cameras/0/perspective/yfov"}}}}]}]"#;
    let read = taken(&file(
        rest,
        &[("SCALAR", &[0.0, 1.0, 2.0]), ("SCALAR", &[0.5, 1.5, 3.125])],
    ));
    for (frame, wanted) in [(1.0, 0.5), (11.0, 0.9), (26.0, 1.5)] {
        let zoom = states(&read.document, frame)[0].pose.zoom;
        let field = crate::convention::field_of_view(zoom);
        assert!((field - wanted).abs() < 1e-6, "{frame}: {field}");
    }
    let losses = read.report.losses();
    assert!(matches!(losses[0], Loss::FieldsClamped(count) if (1..25).contains(&count)));
    assert!(losses.contains(&Loss::Orthographic(1)));
    // Cameras at the origin look along −z.
    assert_eq!(states(&read.document, 1.0)[0].pose.vpn, [0.0, 0.0, -1.0]);
    let Kind::Camera(camera) = found(&read, "camera 0").kind else {
        panic!();
    };
    assert_eq!((camera.near, camera.far), (0.25, 25000.0));
}

/// As Blender writes them: an animation for each object, and several for one.
#[test]
fn animations_of_different_things_are_read_together() {
    let channel = |node: usize, path: &str| {
        let target = format!(r#"{{"node": {node}, "path": "{path}"}}"#);
        format!(r#"{{"sampler": 0, "target": {target}}}"#)
    };
    let clip = |name: &str, channels: &[String]| {
        let channels = channels.join(",");
        format!(
            r#"{{"name": "{name}", "samplers": [{{"input": 0, "output": 1}}], "channels": [{channels}]}}"#
        )
    };
    let all = [
        clip("walk", &[channel(0, "translation")]),
        clip("run", &[channel(0, "translation")]),
        // The camera hangs on node 1.
        clip("pan left", &[channel(1, "translation")]),
        clip(
            "pan right",
            &[channel(1, "translation"), channel(0, "scale")],
        ),
    ];
    let rest = format!(
        r#""nodes": [{{"name": "man"}}, {{"name": "dolly", "children": [2]}}, {{"camera": 0}}],
        "cameras": [{{"type": "perspective", "perspective": {{"yfov": 1, "znear": 0.1}}}}],
        "animations": [{}]"#,
        all.join(",")
    );
    let file = file(
        &rest,
        &[
            ("SCALAR", &[0.0, 1.0]),
            ("VEC3", &[0.0, 0.0, 0.0, 4.0, 0.0, 0.0]),
        ],
    );
    let tracks = |read: &Imported, name| found(read, name).keys().tracks().len();
    let read = taken(&file);
    assert_eq!((tracks(&read, "man"), tracks(&read, "dolly")), (1, 1));
    let left = read.report.losses()[0].to_string();
    assert_eq!(left, "animations left out (option clip): pan right, run");
    let chosen = |name: &str| {
        let options = Options {
            clip: Some(name.to_owned()),
            ..Options::default()
        };
        import(
            &Source::of_bytes("clips", file.as_bytes().to_vec()),
            None,
            &options,
        )
    };
    let read = chosen("pan right").unwrap();
    assert_eq!((tracks(&read, "man"), tracks(&read, "dolly")), (1, 1));
    assert_eq!(
        found(&read, "man").keys().tracks()[0].channel().to_string(),
        "scale"
    );
    let refused = chosen("jump").unwrap_err().to_string();
    assert!(
        refused.ends_with(
            "there is no animation \"jump\"; animations are: walk, run, pan left, pan right"
        ),
        "{refused}"
    );
}

#[test]
fn numbers_without_a_buffer_are_zeros() {
    let rest = r#""nodes": [{"name": "a", "translation": [1, 2, 3]}], "animations": [{
        "samplers": [{"input": 0, "output": 1}],
        "channels": [{"sampler": 0, "target": {"node": 0, "path": "translation"}}]}]"#;
    let file = file(rest, &[("SCALAR", &[0.0, 1.0]), ("SCALAR", &[5.0, 5.0])]);
    let dense = r#"{"bufferView": 1, "componentType": 5126, "count": 2, "type": "SCALAR"}"#;
    assert!(file.contains(dense));
    let zeros = file.replace(
        dense,
        r#"{"componentType": 5126, "count": 2, "type": "VEC3"}"#,
    );
    assert_eq!(
        found(&taken(&zeros), "a").keys().tracks()[0].values(),
        [0.0; 6]
    );
    // What is wrong is named by its place.
    let broken = file.replace(
        dense,
        r#"{"bufferView": 9, "componentType": 5126, "count": 2, "type": "VEC3"}"#,
    );
    let refused = read(broken.into_bytes()).unwrap_err().to_string();
    assert!(
        refused.starts_with("flight: animations[0].samplers[0].output: "),
        "{refused}"
    );
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
    let gone = animation.replace("\"output\": 1", "\"output\": 7");
    let gone = file(&gone, &[("SCALAR", &[1.0, 2.0])]);
    let cubic = animation.replace(
        "\"output\": 1",
        "\"output\": 1, \"interpolation\": \"CUBIC\"",
    );
    let cubic = file(&cubic, &[("SCALAR", &[1.0, 2.0]), ("VEC3", &[0.0; 6])]);
    let mesh = r#""nodes": [{"mesh": 0}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0}},
        {"attributes": {"POSITION": 0, "COLOR_0": 4}}]}]"#;
    let mesh = file(mesh, &[("VEC3", &[0.0; 9])]);
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
        (
            gone,
            "animations[0].samplers[0].output: the file has no such number",
        ),
        (
            cubic,
            "animations[0].samplers[0].interpolation: CUBIC is not read",
        ),
        (
            mesh,
            "meshes[0].primitives[1].attributes.COLOR_0: the file has no such number",
        ),
        (
            format!(r#"{head}"translation": [1, 2]}}]}}"#),
            "nodes[0].translation: expected 3 numbers, found 2",
        ),
        (
            format!(r#"{head}"children": [1]}}, {{"children": [4]}}]}}"#),
            "nodes[1].children[0]: there is no number 4: there are 2",
        ),
        (
            format!(r#"{head}}}], "scenes": [{{"nodes": [0, 3]}}]}}"#),
            "scenes[0].nodes[1]: there is no number 3: there are 1",
        ),
        (
            r#"{"asset": {"version": "1.0"}, "nodes": {}}"#.to_owned(),
            "asset.version: glTF 1.0 is not read",
        ),
        (
            "{\"asset\": {\"version\": \"2.0\"},\n\"nodes\": [}".to_owned(),
            "line 2: ",
        ),
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
            "buffers[0].uri: a buffer of this file is gone",
        ),
    ] {
        let error = read(json.clone().into_bytes()).unwrap_err().to_string();
        assert!(error.contains(said), "{json}: {error}");
    }
}

/// As many keys as there are in a second, or the rate at which they are at whole frames.
#[test]
fn a_file_without_a_rate_has_that_of_its_keys() {
    let rest = r#""nodes": [{}], "animations": [{
        "samplers": [{"input": 0, "output": 1}, {"input": 2, "output": 3}],
        "channels": [{"sampler": 0, "target": {"node": 0, "path": "translation"}},
            {"sampler": 1, "target": {"node": 0, "path": "scale"}}]}]"#;
    let every = |step: f64, count: u32| -> Vec<f32> {
        let keys = 0..count;
        keys.map(|key| (f64::from(key) * step) as f32).collect()
    };
    let film = every(1001.0 / 24000.0, 400);
    let mut gaps = every(1.0 / 30.0, 100);
    gaps.drain(20..50);
    for (seconds, fps) in [
        (every(1.0 / 24.0, 30), 24.0),
        (film, 24000.0 / 1001.0),
        (gaps, 30.0),
        // Every third frame of 24, every second second, none that fits.
        (every(0.125, 9), 24.0),
        (every(2.0, 4), 25.0),
        (vec![0.0, 0.1234, 0.5678], 25.0),
    ] {
        let values = vec![1.0; 3 * seconds.len()];
        let lists = [
            ("SCALAR", &seconds[..]),
            ("VEC3", &values),
            ("SCALAR", &[0.0, 0.7]),
            ("VEC3", &[1.0; 6]),
        ];
        let read = taken(&file(rest, &lists));
        assert_eq!(read.document.info.fps, fps, "{seconds:?}");
        let frames = read.document.scene.nodes()[0].keys().tracks()[0]
            .frames()
            .to_vec();
        let whole = frames.iter().all(|frame| frame.fract() == 0.0);
        assert!(whole || fps == 25.0, "{frames:?}");
    }
}

/// A camera and an object that move, in a short file.
const SMALL: &str = r#"
version = 1
[[node]]
name = "c"
kind = "camera"
[[node.track]]
channel = "zoom"
interpolation = "linear"
frames = [1.0, 3.0]
values = [24.0, 50.0]
[[node.track]]
channel = "rotation"
interpolation = "hermite"
frames = [1.0, 3.0]
values = [[1.0, 0.0, 0.0, 0.0], [0.8, 0.6, 0.0, 0.0]]
shape = [[0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0], [0.0, 0.1, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]]
[[node]]
name = "o"
kind = "object"
pivot = [1.0, 0.0, 0.0]
[node.mesh]
points = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]
triangles = [[0, 1, 2]]
[[node.shape]]
name = "s"
points = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 1.0, 0.0]]
"#;

/// Cut off at every byte, each byte changed; of the large file some.
#[test]
fn any_bytes_do_no_harm() {
    let small = SceneDocument::from_toml(SMALL).unwrap();
    let far = super::tests_far::far("z");
    for (document, every) in [(small, 1), (everything(), 17), (far, 17)] {
        for format in ["glb", "gltf"] {
            let (file, _) = written(&document, format, &Options::default());
            let format = by_name(format).unwrap();
            let look = |bytes: Vec<u8>| {
                let source = Source::of_bytes("flight", bytes);
                if let Ok(read) = import(&source, Some(format), &Options::default()) {
                    // What is taken is sound: it is written and read as our own.
                    let text = read.document.to_toml().unwrap();
                    let again = SceneDocument::from_toml(&text).unwrap();
                    assert!(again == read.document, "{text}");
                }
            };
            for at in (0..file.len()).step_by(every) {
                look(file[..at].to_vec());
                for flip in [1, 2 << (at % 6), 255] {
                    let mut broken = file.clone();
                    broken[at] ^= flip;
                    look(broken);
                }
            }
        }
    }
}

#[test]
fn what_is_no_gltf_is_told_so() {
    for format in ["glb", "gltf"] {
        let source = Source::of_bytes("a.glb", b"junk".to_vec());
        let error = import(&source, by_name(format).ok(), &Options::default()).unwrap_err();
        assert_eq!(error.to_string(), "a.glb: expected \"glTF\"");
    }
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
