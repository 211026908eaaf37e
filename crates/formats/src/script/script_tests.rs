use std::path::Path;

use vides_document::SceneDocument;

use super::*;
use crate::all::by_target;
use crate::content::Content;
use crate::options::Options;
use crate::{Source, by_name, export_to, import, read};

const SCRIPTS: [(&str, &str); 3] = [
    ("blender", include_str!("for_blender.py")),
    ("paraview", include_str!("for_paraview.py")),
    ("vtk", include_str!("for_vtk.py")),
];

/// A flight past a triangle; its title would end any string, and be run behind it.
const FLIGHT: &str = r#"
version = 1
title = "''' + boom() + r''' \"\"\" \\' </script> \u2028 \U0001f600 {}\\"
fps = 29.97
[space]
centre = [0.0, 0.0, 0.0]
half_size = 2.0
up = "y"
[object]
points = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 0.5]]
triangles = [[0, 1, 2]]
lines = [[2, 3]]
[[point]]
position = [0.0, 0.25, 1.5]
[[point.orientation]]
target = [0.0, 0.5, 0.0]
[[point]]
position = [1.5, 0.0, 0.0]
[[point.orientation]]
target = [0.0, 0.5, 0.0]
zoom_mm = 50.0
[[point.orientation]]
offset = [0.0, 0.0, -1.0]
roll_degrees = 170.0
"#;

fn document(text: &str) -> SceneDocument {
    let source = Source::of_bytes("flight.vid", text.into());
    import(&source, None, &Options::default()).unwrap().document
}

fn written(text: &str, format: &str, options: &str) -> (String, Report) {
    let mut out = Vec::new();
    let options = Options::parse(options).unwrap();
    let format = by_name(format).unwrap();
    let report = export_to(&document(text), &mut out, format, &options, &mut |_, _| {});
    (String::from_utf8(out).unwrap(), report.unwrap())
}

fn json(script: &str) -> serde_json::Value {
    serde_json::from_str(data(script).unwrap().0).unwrap()
}

#[test]
fn texts_are_no_code() {
    let hostile = "'''\"\"\"\\'\\\n\r\0 \u{1b}</script>\u{2028}\u{2029}\u{feff}é\u{1f600} {}\\";
    let mut text = Vec::new();
    push_text(&mut text, hostile);
    let text = String::from_utf8(text).unwrap();
    let again: String = serde_json::from_str(&text).unwrap();
    assert_eq!(again, hostile);
    for c in text[1..text.len() - 1].chars() {
        assert!((' '..='~').contains(&c) && !"'\"<>&".contains(c), "{text}");
    }
    // Every backslash begins the number of a character.
    assert_eq!(text.matches('\\').count(), text.matches("\\u").count());
}

#[test]
fn a_script_is_its_template_round_its_data() {
    for (name, template) in SCRIPTS {
        assert!(template.is_ascii() && template.matches(CLOSE).count() == 2);
        let (script, _) = written(FLIGHT, name, "");
        let [before, behind] = around(template);
        assert!(script.starts_with(before) && script.ends_with(behind));
        let inside = &script[before.len()..script.len() - behind.len()];
        assert_eq!(inside.trim(), data(&script).unwrap().0.trim());
        assert!(inside.is_ascii() && !inside.contains('\''));
        assert!(inside.lines().all(|line| line.len() < 300));

        let held = json(&script);
        let title = &document(FLIGHT).info.title;
        assert_eq!(held["title"].as_str(), Some(title.as_str()));
        assert_eq!(held["fps"].as_f64(), Some(29.97));
        assert_eq!(held["object"]["triangles"], serde_json::json!([[0, 1, 2]]));
        assert_eq!(held["object"]["lines"], serde_json::json!([[2, 3]]));
        // Blender's world has z upright.
        let top = if name == "blender" {
            [0.0, 0.0, 1.0]
        } else {
            [0.0, 1.0, 0.0]
        };
        let [x, y, z] = [0, 1, 2].map(|axis| held["object"]["points"][2][axis].as_f64().unwrap());
        assert!([x, y, z] == top, "{name}: {x} {y} {z}");
    }
}

/// Against the poses and turns of the engine, by vectors alone.
#[test]
fn blender_turns_as_the_pose_does() {
    let (script, report) = written(FLIGHT, "blender", "");
    assert_eq!(report.losses(), [Loss::Path]);
    let held = json(&script);
    let scene = document(FLIGHT);
    let options = Options::default();
    let mut ignored = |_, _| {};
    let flight = Flight::new(&scene, &options, &crate::Format::PLAIN, &mut ignored).unwrap();
    let poses = flight.all_poses().unwrap();
    let rows = held["frames"].as_array().unwrap();
    assert_eq!(rows.len(), poses.len());
    let mut before: Option<glam::DQuat> = None;
    for (row, pose) in rows.iter().zip(&poses) {
        let number = |at: usize| row[at].as_f64().unwrap();
        let q = glam::DQuat::from_xyzw(number(4), number(5), number(6), number(3));
        let z_up = |v: [f64; 3]| DVec3::new(v[0], -v[2], v[1]);
        assert!((q * DVec3::NEG_Z - z_up(pose.vpn)).length() < 1e-12);
        assert!((q * DVec3::Y - z_up(pose.vup)).length() < 1e-12);
        assert_eq!([number(0), number(1), number(2)], z_up(pose.vrp).to_array());
        assert_eq!(number(7), pose.zoom);
        assert!(before.is_none_or(|before| before.dot(q) > 0.0));
        before = Some(q);
    }
}

#[test]
fn blender_has_no_frames_before_0() {
    let early = FLIGHT.replace("fps = 29.97", "fps = 25\nfirst_frame = -3");
    let (script, report) = written(&early, "blender", "");
    assert_eq!(json(&script)["first_frame"], 1);
    let said: Vec<_> = report.losses().iter().map(ToString::to_string).collect();
    let words = "the first frame is 1 and not -3: its frames are whole numbers from 0 to 1048574";
    assert!(said.iter().any(|line| line == words), "{said:?}");
    let late = FLIGHT.replace("fps = 29.97", "fps = 25\nfirst_frame = 101");
    let (script, report) = written(&late, "blender", "frames=103..103");
    let held = json(&script);
    assert_eq!(
        (
            &held["first_frame"],
            held["frames"].as_array().unwrap().len()
        ),
        (&103.into(), 1)
    );
    assert_eq!(report.losses(), [Loss::Path]);
    let (script, _) = written(&late, "paraview", "frames=103..103");
    assert_eq!(json(&script)["first_frame"], 103);
}

#[test]
fn paraviews_focal_point_is_the_target() {
    let (script, _) = written(FLIGHT, "paraview", "scale=10");
    let held = json(&script);
    let rows = held["frames"].as_array().unwrap();
    let vector = |row: &serde_json::Value, from: usize| {
        DVec3::from_array([0, 1, 2].map(|axis| row[from + axis].as_f64().unwrap()))
    };
    let distance = |row: &serde_json::Value| row[10].as_f64().unwrap();
    let first = &rows[0];
    let focus = vector(first, 0) + distance(first) * vector(first, 3);
    assert!((focus - DVec3::new(0.0, 5.0, 0.0)).length() < 1e-9);
    // In the last one there is no target: the middle of what is shown of the object.
    let last = rows.last().unwrap();
    let object = &document(FLIGHT).info.object;
    let sum: DVec3 = object.iter().map(|point| point.position).sum();
    let middle = 10.0 * sum / object.len() as f64;
    assert!((distance(last) - middle.distance(DVec3::new(15.0, 0.0, 0.0))).abs() < 1e-9);
    // Without an object the half size.
    let start = FLIGHT.find("[object]").unwrap();
    let end = FLIGHT.find("[[point]]").unwrap();
    let bare = [&FLIGHT[..start], &FLIGHT[end..]].concat();
    let held = json(&written(&bare, "paraview", "").0);
    assert_eq!(
        distance(held["frames"].as_array().unwrap().last().unwrap()),
        2.0
    );
    assert!(held.get("object").is_none());
    assert!(rows.iter().all(|row| distance(row) > 0.0));
}

#[test]
fn scripts_for_others_are_refused_by_name() {
    for name in ["blender", "vtk"] {
        let (script, _) = written(FLIGHT, name, "");
        let source = Source::of_bytes("flight.py", script.into_bytes());
        let refused = read(&source, None, &Options::default(), &mut Report::default());
        assert_eq!(
            refused.unwrap_err().to_string(),
            format!("flight.py: the format {name} is written, not read")
        );
    }
}

#[test]
fn paraviews_script_comes_back() {
    let (script, _) = written(FLIGHT, "paraview", "");
    let source = Source::of_bytes("flight.py", script.into_bytes());
    let mut report = Report::default();
    let (format, content) = read(&source, None, &Options::default(), &mut report).unwrap();
    let Content::Poses(recording) = content else {
        panic!("poses are expected")
    };
    assert_eq!((format, report.losses()), ("paraview", &[Loss::Object][..]));
    let scene = document(FLIGHT);
    let options = Options::default();
    let mut ignored = |_, _| {};
    let flight = Flight::new(&scene, &options, &crate::Format::PLAIN, &mut ignored).unwrap();
    assert_eq!(recording.poses, flight.all_poses().unwrap());
    assert_eq!(
        (recording.fps, recording.first_frame),
        (Some(29.97), Some(1.0))
    );
    assert_eq!(
        (recording.up, &recording.title),
        (Some(vides_engine::path::Up::Y), &scene.info.title)
    );
}

#[test]
fn broken_data_are_refused_with_their_place() {
    let (script, _) = written(FLIGHT, "paraview", "frames=1..2");
    let first = script
        .lines()
        .position(|line| line.starts_with("\"frames\""))
        .unwrap()
        + 2;
    let (row, second) = (
        script.lines().nth(first - 1).unwrap(),
        script.lines().nth(first).unwrap(),
    );
    let short = row.rsplit_once(", ").unwrap().0;
    let before = script.split_once(BEGIN).unwrap().0;
    for (broken, said) in [
        (
            before.to_owned(),
            format!("flight.py: {BEGIN} is not there"),
        ),
        (
            script.replace(OPEN, "DATA = '"),
            format!("flight.py: {OPEN} is not there"),
        ),
        (
            script.split_once(second).unwrap().0.to_owned(),
            "flight.py: the file ends too early".into(),
        ),
        (
            script.replace(row, &format!("{short}],")),
            "flight.py: frames[0]: expected 11 numbers, found 10".into(),
        ),
        (
            script.replace("\"fps\": 29.97", "\"fps\": -1"),
            "flight.py: fps: expected a number greater than 0".into(),
        ),
        (
            script.replace("\"up\": \"y\"", "\"up\": \"q\""),
            "flight.py: up: q is not read".into(),
        ),
        (
            script.replace("\"frames\": ", "\"films\": "),
            "flight.py: frames is not there".into(),
        ),
    ] {
        assert_ne!(broken, script);
        let source = Source::of_bytes("flight.py", broken.into_bytes());
        let error = import(&source, None, &Options::default()).unwrap_err();
        assert_eq!(error.to_string(), said);
    }
    let broken = script.replace(second, "[1e999, __import__('os')]");
    let source = Source::of_bytes("flight.py", broken.into_bytes());
    let error = import(&source, None, &Options::default())
        .unwrap_err()
        .to_string();
    assert!(
        error.starts_with(&format!("flight.py: line {}: ", first + 1)),
        "{error}"
    );
}

#[test]
fn large_objects_are_left_out() {
    let row = "[0, 0, 0], ".repeat(MOST_PIECES + 1);
    let large = FLIGHT.replace("points = [", &format!("points = [{row}"));
    let (script, report) = written(&large, "vtk", "");
    assert!(json(&script).get("object").is_none() && report.losses().contains(&Loss::Object));
}

#[test]
fn a_name_in_py_is_no_format() {
    let error = by_target(Path::new("flight.py"))
        .map(|format| format.name)
        .unwrap_err();
    let said = "flight.py: this may be \"blender\", \"paraview\" or \"vtk\": name it, with --to in the \
                command";
    assert_eq!(error.to_string(), said);
}

/// A camera that flies past a box in a turned and scaled group; the box moves, a sign does not.
const SCENE: &str = r#"
version = 1
[space]
up = "y"
[[node]]
name = "eye"
kind = "camera"
position = [0.0, 0.0, 5.0]
[[node]]
name = "turned"
kind = "group"
rotation = [0.8, 0.0, 0.6, 0.0]
scale = [2.0, 2.0, 2.0]
[[node]]
name = "box"
kind = "object"
parent = "turned"
[[node.track]]
channel = "position"
interpolation = "linear"
frames = [1.0, 11.0]
values = [[0.0, 0.0, 0.0], [1.0, 2.0, 3.0]]
[[node.track]]
channel = "visible"
interpolation = "step"
frames = [1.0, 6.0]
values = [1.0, 0.0]
[node.mesh]
points = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]
triangles = [[0, 1, 2]]
[[node]]
name = "a ''' + boom()"
kind = "object"
position = [1.0, 2.0, 3.0]
[node.mesh]
points = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0]]
lines = [[0, 1]]
[[node]]
name = "lamp"
kind = "light"
light = "point"
"#;

/// Each corner is where the engine has it, frame by frame, with z upright; ParaView's script has none.
#[test]
fn blender_gets_the_objects_of_a_scene() {
    let (script, report) = written(SCENE, "blender", "scale=10");
    assert_eq!(report.losses(), [Loss::OtherNodes(1)]);
    let held = json(&script);
    let objects = held["objects"].as_array().unwrap();
    let names = objects
        .iter()
        .map(|object| object["name"].as_str().unwrap());
    assert!(names.eq(["box", "a ''' + boom()"]));
    let document = document(SCENE);
    let scene = &document.scene;
    let numbers = |row: &serde_json::Value| -> Vec<f64> {
        let row = row.as_array().unwrap().iter();
        row.map(|number| number.as_f64().unwrap()).collect()
    };
    let mut hidden = 0;
    for (object, count) in objects.iter().zip([11, 1]) {
        let at = scene.find(object["name"].as_str().unwrap()).unwrap();
        let places = object["places"].as_array().unwrap();
        assert_eq!(places.len(), count);
        for frame in 0..11 {
            let place = numbers(places.get(frame).unwrap_or(&places[0]));
            let [x, y, z, w, i, j, k, a, b, c, hides] = *place else {
                panic!("{place:?}");
            };
            let turn = glam::DQuat::from_xyzw(i, j, k, w);
            let mut states = vec![Default::default(); scene.nodes().len()];
            let warnings = &mut vides_engine::scene::Warnings::default();
            scene
                .evaluate(1.0 + frame as f64, &mut states, warnings)
                .unwrap();
            for corner in object["points"].as_array().unwrap() {
                let corner = DVec3::from_slice(&numbers(corner));
                let made = turn * (DVec3::new(a, b, c) * corner) + DVec3::new(x, y, z);
                let wanted = 10.0 * states[at].world().transform_point3(corner);
                let wanted = DVec3::new(wanted.x, -wanted.z, wanted.y);
                assert!(made.distance(wanted) < 1e-12, "{frame}: {made} {wanted}");
            }
            assert_eq!(hides == 1.0, states[at].visible == 0);
            hidden += usize::from(hides == 1.0);
        }
    }
    assert_eq!(hidden, 6);
    let (script, report) = written(SCENE, "paraview", "");
    assert!(json(&script).get("objects").is_none());
    assert_eq!(report.losses(), [Loss::OtherNodes(4)]);
}

/// Objects and their places share the room of a script; those that do not fit are counted.
#[test]
fn large_objects_of_a_scene_are_left_out() {
    let row = "[0, 0, 0], ".repeat(MOST_PIECES);
    let large = SCENE.replacen("points = [", &format!("points = [{row}"), 1);
    let (script, report) = written(&large, "blender", "");
    let held = json(&script);
    assert_eq!(held["objects"].as_array().unwrap().len(), 1);
    assert_eq!(report.losses(), [Loss::OtherNodes(2)]);
}
