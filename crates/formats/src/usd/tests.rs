//! What we write, and what comes back of it.

use glam::{DAffine3, DVec3};
use vides_document::SceneDocument;
use vides_engine::scene::{Channel, Kind, Light, NodeState, Warnings};

use super::USDA;
use crate::{Imported, Loss, Options, Report, Source, export_to, import};

const CAR: &str = include_str!("../../../../examples/car.vid");
const PYRAMID: &str = include_str!("../../../../examples/pyramid.vid");

pub(super) fn document(text: &str) -> SceneDocument {
    SceneDocument::from_toml(text).unwrap()
}

fn written_with(document: &SceneDocument, options: &Options) -> (String, Report) {
    let mut out = Vec::new();
    let report = export_to(document, &mut out, &USDA, options, &mut |_, _| {}).unwrap();
    (String::from_utf8(out).unwrap(), report)
}

pub(super) fn written(document: &SceneDocument) -> String {
    written_with(document, &Options::default()).0
}

pub(super) fn read(text: &str) -> Imported {
    let source = Source::of_bytes("a.usda", text.as_bytes().to_vec());
    import(&source, None, &Options::default()).unwrap()
}

pub(super) fn states(document: &SceneDocument, frame: f64) -> Vec<(String, NodeState)> {
    let nodes = document.scene.nodes();
    let mut states = vec![NodeState::default(); nodes.len()];
    let warnings = &mut Warnings::default();
    document
        .scene
        .evaluate(frame, &mut states, warnings)
        .unwrap();
    nodes
        .iter()
        .map(|node| node.name.clone())
        .zip(states)
        .collect()
}

pub(super) fn matrix(document: &SceneDocument, name: &str, frame: f64) -> DAffine3 {
    let all = states(document, frame);
    all.iter()
        .find(|(other, _)| other == name)
        .unwrap()
        .1
        .world()
}

/// A stage of one prim with these lines in it.
pub(super) fn prim(kind: &str, lines: &str) -> String {
    format!("#usda 1.0\ndef {kind} \"it\"\n{{\n{lines}\n}}\ndef Camera \"seen\" {{}}\n")
}

pub(super) fn not_taken(report: &Report) -> Vec<(String, usize)> {
    let losses = report.losses().iter();
    let told = losses.filter_map(|loss| match loss {
        Loss::NotTaken { what, count } => Some((what.to_string(), *count)),
        _ => None,
    });
    told.collect()
}

#[test]
fn a_scene_comes_back_as_it_was() {
    for text in [CAR, PYRAMID] {
        let was = document(text);
        let is = read(&written(&was)).document;
        assert_eq!(is.info.title, was.info.title);
        assert_eq!(is.info.comment, was.info.comment);
        assert_eq!(
            (is.info.fps, is.info.first_frame),
            (was.info.fps, was.info.first_frame)
        );
        assert_eq!(is.scene.frame_range(), was.scene.frame_range());
        let (first, last) = was.scene.frame_range();
        let mut frame = first;
        while frame <= last {
            let back = states(&is, frame);
            for (name, was) in states(&was, frame) {
                let (_, is) = back.iter().find(|(other, _)| *other == name).unwrap();
                let turn =
                    |state: &NodeState| (DVec3::from(state.pose.vpn), DVec3::from(state.pose.vup));
                assert!(
                    is.world().abs_diff_eq(was.world(), 1e-12),
                    "{name} at {frame}"
                );
                assert!(
                    turn(is).0.abs_diff_eq(turn(&was).0, 1e-12),
                    "{name} at {frame}"
                );
                assert!(
                    turn(is).1.abs_diff_eq(turn(&was).1, 1e-12),
                    "{name} at {frame}"
                );
                // Lenses and colours are of 32 bits.
                assert!((is.pose.zoom - was.pose.zoom).abs() <= 2e-7 * was.pose.zoom);
                for (a, b) in is
                    .colour
                    .iter()
                    .chain(&is.cone)
                    .zip(was.colour.iter().chain(&was.cone))
                {
                    assert!((a - b).abs() <= 1e-6 * b.abs(), "{name} at {frame}");
                }
            }
            frame += 1.0;
        }
        let kinds = |document: &SceneDocument| {
            let mut kinds: Vec<_> = document
                .scene
                .nodes()
                .iter()
                .map(|node| (node.name.clone(), node.kind.name(), node.pivot.to_string()))
                .collect();
            kinds.sort();
            kinds
        };
        assert_eq!(kinds(&is), kinds(&was));
        for (a, b) in is.info.object.iter().zip(was.info.object.iter()) {
            assert!(a.draw == b.draw && a.position.abs_diff_eq(b.position, 1e-6));
        }
        assert_eq!(is.info.object.len(), was.info.object.len());
    }
}

pub(super) const KEYS: &str = r#"
version = 1
first_frame = 101
[[node]]
name = "camera"
kind = "camera"
roll_degrees = 90.0
[[node.track]]
channel = "position"
interpolation = "step"
frames = [1.0, 4.0, 9.5]
values = [[0.0, 0.0, 0.0], [1.0, 2.0, 3.0], [1.0, 0.0, 0.0]]
[[node.track]]
channel = "rotation"
interpolation = "linear"
frames = [2.0, 7.0]
values = [[1.0, 0.0, 0.0, 0.0], [0.0, 0.0, 2.0, 0.0]]
[[node.track]]
channel = "visible"
interpolation = "step"
frames = [3.0, 5.0]
values = [[0.0], [1.0]]
[[node.track]]
channel = "zoom"
interpolation = "linear"
frames = [1.0, 12.0]
values = [[24.0], [48.0]]
"#;

#[test]
fn keys_stay_keys() {
    let was = document(KEYS);
    let (text, report) = written_with(&was, &Options::default());
    assert_eq!(report.losses(), []);
    // A step is held to just before the next key, in time codes that people see.
    for line in [
        "101: (0.0, 0.0, 0.0),",
        "103.999999: (0.0, 0.0, 0.0),",
        "104: (1.0, 2.0, 3.0),",
        "103: \"invisible\",",
        "startTimeCode = 101",
        "endTimeCode = 112",
        "112: 0.48,",
    ] {
        assert!(text.contains(line), "{line}\n{text}");
    }
    let is = read(&text).document;
    let (was, is) = (&was.scene.nodes()[0], &is.scene.nodes()[0]);
    for track in was.keys().tracks() {
        let back = is.keys().track(track.channel()).unwrap();
        assert_eq!(back.interpolation(), track.interpolation());
        assert_eq!(back.frames(), track.frames());
        if *track.channel() == Channel::Rotation {
            continue; // Of any length there, and with the roll in it here.
        }
        for (a, b) in back.values().iter().zip(track.values()) {
            assert!((a - b).abs() <= 2e-7 * b, "{}", track.channel());
        }
    }
}

#[test]
fn between_keys_it_is_the_same() {
    let was = document(KEYS);
    let is = read(&written(&was)).document;
    for step in 0..110 {
        let frame = 1.0 + f64::from(step) / 10.0;
        let (was, is) = (&states(&was, frame)[0].1, &states(&is, frame)[0].1);
        for (a, b) in [
            (was.pose.vrp, is.pose.vrp),
            (was.pose.vpn, is.pose.vpn),
            (was.pose.vup, is.pose.vup),
        ] {
            assert!(DVec3::from(a).abs_diff_eq(b.into(), 1e-12), "{frame}");
        }
        assert_eq!(was.visible, is.visible, "{frame}");
    }
}

#[test]
fn options_turn_scale_and_choose_frames() {
    let was = document(KEYS);
    let lines = "up=z\nscale=100\nframes=103..105\nfps=50\nsize=1000x500";
    let (text, _) = written_with(&was, &Options::parse(lines).unwrap());
    for line in [
        "upAxis = \"Z\"",
        "startTimeCode = 103",
        "endTimeCode = 108",
        "timeCodesPerSecond = 50",
        "(100.0, -300.0, 200.0)",
        "float horizontalAperture = 0.48",
        "float verticalAperture = 0.24",
        "float2 clippingRange = (1.65, 165000.0)",
        "metersPerUnit = 1.0",
    ] {
        assert!(text.contains(line), "{line}\n{text}");
    }
    let metre = document(&KEYS.replace("first_frame = 101", "space = { unit = \"m\" }"));
    let (text, _) = written_with(&metre, &Options::parse("scale=100").unwrap());
    assert!(text.contains("metersPerUnit = 0.01\n"), "{text}");
    assert!(text.contains("float verticalAperture = 24.0\n"), "{text}");
    assert_eq!(read(&text).document.info.unit, "cm");
}

#[test]
fn a_camera_with_others_in_it_comes_back_as_one() {
    let text = "version = 1\n[[node]]\nname = \"a \\\"b\\\"\\\\\"\nkind = \"camera\"\nzoom_mm = 35.0\n\
                rotation = [0.9, 0.1, 0.2, 0.3]\n[[node]]\nname = \"1\"\nkind = \"light\"\n\
                light = \"spot\"\nparent = \"a \\\"b\\\"\\\\\"\nposition = [1.0, 2.0, 3.0]\n";
    let was = document(text);
    let (text, _) = written_with(&was, &Options::default());
    assert!(text.contains("displayName = \"a \\\"b\\\"\\\\\""), "{text}");
    let is = read(&text).document;
    assert_eq!(is.scene.nodes().len(), 2);
    for ((a, was), (b, is)) in states(&was, 1.0).iter().zip(states(&is, 1.0)) {
        assert_eq!(*a, b);
        assert!(was.world().abs_diff_eq(is.world(), 1e-15));
    }
    assert!(matches!(is.scene.nodes()[1].kind, Kind::Light(Light::Spot)));
}

#[test]
fn the_shown_camera_stays_it() {
    let text = "version = 1\n[[node]]\nname = \"a\"\nkind = \"camera\"\nparent = \"b\"\n\
                [[node]]\nname = \"b\"\nkind = \"group\"\n[[node]]\nname = \"c\"\nkind = \"camera\"\n\
                parent = \"b\"\nposition = [1.0, 2.0, 3.0]\n";
    let was = document(text);
    for shown in ["a", "c"] {
        let options = Options::parse(&format!("node={shown}")).unwrap();
        let is = read(&written_with(&was, &options).0).document.scene;
        let name = |at: usize| is.nodes()[at].name.as_str();
        assert_eq!(name(is.shown_camera().unwrap()), shown);
        for node in is.nodes().iter().filter(|node| node.name != "b") {
            assert_eq!(node.parent.map(name), Some("b"));
        }
    }
}

#[test]
fn the_shown_frames_stay_them() {
    let text = KEYS.replace("first_frame", "range = [3.0, 20.0]\nfirst_frame");
    let (text, _) = written_with(&document(&text), &Options::default());
    assert!(
        text.contains("startTimeCode = 103\n    endTimeCode = 120\n"),
        "{text}"
    );
    let is = read(&text).document;
    assert_eq!(is.info.first_frame, 103);
    assert_eq!(is.scene.range(), Some((1.0, 18.0)));
    // Keys stay at the frames that people see.
    let zoom = is.scene.nodes()[0].keys().track(&Channel::Zoom).unwrap();
    assert_eq!(zoom.frames(), [-1.0, 10.0]);
    // Where the frames are those of the keys none are chosen.
    assert_eq!(read(&written(&document(KEYS))).document.scene.range(), None);
}

#[test]
fn texts_are_data() {
    let mut was = document(KEYS);
    was.info.title = "\"\"\" ) { </script>".to_owned();
    was.info.comment = "\"\n\\ #usda\t'''".to_owned();
    let is = read(&written(&was)).document;
    assert_eq!(is.info.title, was.info.title);
    assert_eq!(is.info.comment, was.info.comment);
}

#[test]
fn morphed_objects_go_out_point_by_point() {
    let text = "version = 1\n[[node]]\nname = \"camera\"\nkind = \"camera\"\n[[node]]\nname = \"o\"\nkind = \"object\"\n\
                weights = [0.0]\n[node.mesh]\npoints = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]\n\
                triangles = [[0, 1, 2]]\n[[node.shape]]\nname = \"s\"\n\
                points = [[0.0, 0.0, 2.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]\n\
                [[node.track]]\nchannel = \"weights\"\ninterpolation = \"linear\"\nframes = [1.0, 3.0]\nvalues = [[0.0], [1.0]]\n";
    let (text, report) = written_with(&document(text), &Options::default());
    assert_eq!(report.losses(), [Loss::Forms(1)]);
    assert!(
        text.contains("2: [(0.0, 0.0, 1.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0)],"),
        "{text}"
    );
    let told = not_taken(&read(&text).report);
    assert_eq!(told, [("points.timeSamples".to_owned(), 1)]);
}

/// The colours of a path's object go along, of its faces and of its lines.
#[test]
fn the_object_of_a_path_keeps_its_colours() {
    let text = "version = 1\n[object]\npoints = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]\n\
                triangles = [[0, 1, 2]]\nlines = [[2, 3]]\n\
                colours = [[255, 0, 0], [0, 255, 0], [0, 0, 255], [9, 90, 200]]\n\
                [[point]]\nposition = [0, 0, 0]\n[[point]]\nposition = [0.5, 0, 0]\n";
    let document = SceneDocument::from_toml(text).unwrap();
    let file = written(&document);
    let back = read(&file).document;
    let colours = |name: &str| {
        let at = back.scene.find(name).unwrap();
        match &back.scene.nodes()[at].kind {
            Kind::Object(object) => object.mesh().colours.clone(),
            _ => panic!("{name} is no object"),
        }
    };
    assert_eq!(
        colours("object_mesh"),
        [[255, 0, 0], [0, 255, 0], [0, 0, 255], [9, 90, 200]]
    );
    assert_eq!(colours("object_basiscurves"), [[0, 0, 255], [9, 90, 200]]);
}

/// Candela and lux, in the words of USD; Blender counts the same lamp of 1000 W in both formats.
#[test]
fn a_lamp_keeps_its_intensity() {
    for (kind, intensity) in [("point", 683.0), ("spot", 12.5), ("directional", 3.0)] {
        let text = format!(
            "version = 1\n[[node]]\nname = \"lamp\"\nkind = \"light\"\nlight = \"{kind}\"\nintensity = {intensity:?}\n"
        );
        let again = read(&written(&document(&text)));
        let lamp = &again.document.scene.nodes()[0];
        assert_eq!(lamp.rest.intensity, intensity, "{kind}");
    }
    let watts =
        "float inputs:intensity = 318.309886\nbool inputs:normalize = 1\nfloat inputs:radius = 0.1";
    let blender = prim("SphereLight", watts).replacen(
        "#usda 1.0\n",
        "#usda 1.0\n(\ndoc = \"Blender v4.2.1 LTS\"\nmetersPerUnit = 1\n)\n",
        1,
    );
    let lamp = read(&blender).document.scene.nodes()[0].rest.intensity;
    // 1000 W / 4π sr at 683 lm/W, as its glTF has it.
    assert!((lamp - 54_351.413).abs() < 1e-2, "{lamp}");
}

/// What `customData` marks is read as it was written. Without the marks the world is one more node
/// in each further file, the wireframe is a node, and an object of faces and lines, or a camera that
/// carries others, is several.
#[test]
fn marks_are_needed() {
    let mut was = document(
        "version = 1\n[[point]]\nposition = [0, 0, 1]\n[[point]]\nposition = [1, 0, 1]\n\
         [object]\npoints = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0]]\nlines = [[0, 1]]\n",
    );
    let others = document(
        "version = 1\n[[node]]\nname = \"eye\"\nkind = \"camera\"\n\
         [[node]]\nname = \"lamp\"\nkind = \"light\"\nlight = \"point\"\nparent = \"eye\"\n\
         [[node]]\nname = \"sign\"\nkind = \"object\"\n[node.mesh]\n\
         points = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]\n\
         triangles = [[0, 1, 2]]\nlines = [[0, 1]]\n",
    );
    let before = was.scene.nodes().len();
    for node in others.scene.nodes() {
        let mut node = node.clone();
        node.parent = node.parent.map(|at| at + before);
        was.scene.add(node).unwrap();
    }
    let marked: fn(&SceneDocument) -> String = written;
    let unmarked: fn(&SceneDocument) -> String = |document| {
        let text = written(document);
        let mut without = String::new();
        let mut rest = text.as_str();
        while let Some((before, after)) = rest.split_once("customData = {") {
            without += before;
            without += "customData = { int none = 0 ";
            rest = &after[after.find('}').unwrap()..];
        }
        without + rest
    };
    let count = |document: &SceneDocument| document.scene.nodes().len();
    let trips = |text: fn(&SceneDocument) -> String| {
        let first = read(&text(&was)).document;
        let second = read(&text(&first)).document;
        let third = read(&text(&second)).document;
        [first, second, third]
    };
    let same = trips(marked);
    assert_eq!(same.each_ref().map(count), [count(&was); 3]);
    assert!(!same[2].info.object.is_empty());
    let grown = trips(unmarked);
    let counts = grown.each_ref().map(count);
    // The world, the wireframe, a second one of the sign and of the camera.
    assert_eq!(counts[0], count(&was) + 5);
    assert!(counts.is_sorted_by(|a, b| a < b), "{counts:?}");
    assert!(grown[0].info.object.is_empty());
    let eye = &grown[0].scene.nodes()[grown[0].scene.find("eye").unwrap()];
    assert_eq!(eye.kind, Kind::Group);
}
