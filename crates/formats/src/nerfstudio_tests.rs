//! Files of nerfstudio's viewer: its keys, and what its code makes of them.

use glam::DVec3;
use serde_json::Value;
use vides_engine::path::{CameraPath, CurveParameters, Pose, Space, Tcb};
use vides_engine::scene::{Interpolation, NodeState, Track, Warnings};
use vides_engine::shared_list::SharedList;

use crate::{As, Imported, Loss, Options, Report, Source, by_name, export_to, import, recording};

fn file(name: &str) -> Value {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/nerfstudio");
    let text = std::fs::read_to_string(format!("{folder}/{name}.json")).unwrap();
    serde_json::from_str(&text).unwrap()
}

fn read(json: &Value, as_: Option<As>) -> Imported {
    let options = Options {
        as_,
        ..Options::default()
    };
    let source = Source::of_bytes("camera_path.json", json.to_string().into());
    import(&source, None, &options).unwrap()
}

fn path(read: &Imported) -> &CameraPath {
    read.document.scene.nodes()[0].path().unwrap().path()
}

fn tracks(read: &Imported) -> &SharedList<Track> {
    read.document.scene.nodes()[0].keys().tracks()
}

/// The camera's poses, frame by frame.
fn poses(read: &Imported) -> Vec<Pose> {
    let scene = &read.document.scene;
    let mut states = [NodeState::default()];
    let (first, last) = scene.frame_range();
    let frames = (first as usize..=last as usize).map(|frame| {
        let warnings = &mut Warnings::default();
        scene.evaluate(frame as f64, &mut states, warnings).unwrap();
        states[0].pose
    });
    frames.collect()
}

/// What the viewer renders (`tests/nerfstudio/make.py`).
#[test]
fn keyframes_become_points_that_move_as_in_the_viewer() {
    for (name, tension) in [("open", 0.3), ("closed", 0.0)] {
        let json = file(name);
        let dense = json["camera_path"].as_array().unwrap();
        let imported = read(&json, None);
        let path = path(&imported);
        assert_eq!((path.points.len(), path.closed), (5, name == "closed"));
        let shape = CurveParameters::Own(Tcb::new(tension, 0.0, 0.0));
        assert!(path.points.iter().all(|point| point.curve == shape));
        let made = poses(&imported);
        assert_eq!(made.len(), dense.len());
        let mut most = 0.0_f64;
        for (at, (made, wanted)) in made.iter().zip(dense).enumerate() {
            let m = |at: usize| wanted["camera_to_world"][at].as_f64().unwrap();
            let off = made.position().distance(DVec3::new(m(3), m(7), m(11)));
            let view = -DVec3::new(m(2), m(6), m(10));
            let turned = made.view().cross(view).length().asin().to_degrees();
            if [0, 10, 30, 60, 75, 95].contains(&at) {
                assert!(
                    off < 1e-6 && turned < 1e-4,
                    "{name} at {at}: {off} {turned}"
                );
            }
            assert!(off < 1e-3, "{name} at {at}: {off}");
            most = most.max(turned);
        }
        // Between keys that turn by 60 to 80 degrees.
        assert!(most < 8.0, "{name}: {most}");
    }
}

/// One for each keyframe; the first again at the end of a loop.
#[test]
fn keyframes_become_keys_that_are_joined_smoothly() {
    for (name, frames) in [
        ("open", &[1.0, 11.0, 31.0, 61.0, 76.0][..]),
        ("closed", &[1.0, 11.0, 31.0, 61.0, 76.0, 96.0]),
    ] {
        let imported = read(&file(name), Some(As::Keys));
        assert_eq!(tracks(&imported).len(), 3);
        for track in tracks(&imported).iter() {
            assert_eq!(track.frames(), frames);
            assert_eq!(*track.interpolation(), Interpolation::CatmullRom);
        }
    }
}

/// A file that VIDES wrote, with its mark or without, is its frames; so is one without keyframes or
/// with malformed ones.
#[test]
fn frames_are_read_where_keyframes_are_not_the_source() {
    let theirs = file("open");
    let document = read(&theirs, None).document;
    let mut out = Vec::new();
    let format = by_name("nerfstudio").unwrap();
    let options = Options::default();
    export_to(&document, &mut out, format, &options, &mut |_, _| {}).unwrap();
    let ours: Value = serde_json::from_slice(&out).unwrap();
    let mut unmarked = ours.clone();
    let mark = unmarked.as_object_mut().unwrap().remove("generator");
    assert_eq!(mark.unwrap(), "VIDES");
    let mut without = theirs.clone();
    without["keyframes"].take();
    let mut malformed = theirs.clone();
    malformed["keyframes"][1]["override_transition_sec"] = (-1.0).into();
    for json in [ours, unmarked, without, malformed] {
        let read = read(&json, Some(As::Keys));
        assert_eq!(tracks(&read)[0].frames().len(), 76, "{:?}", read.report);
    }
    // What VIDES did not write has keys of its own even with its numbers.
    let mut alike = theirs;
    alike["smoothness_value"] = 0.0.into();
    alike["default_transition_sec"] = 0.1.into();
    assert_eq!(tracks(&read(&alike, Some(As::Keys)))[0].frames().len(), 5);
}

/// A fit takes the frames, and says what else there is; a path takes the keyframes.
#[test]
fn a_fit_reports_the_keyframes_that_it_leaves_out() {
    let json = file("open");
    let source = Source::of_bytes("camera_path.json", json.to_string().into());
    let mut report = Report::default();
    let read = recording(&source, None, &Options::default(), &mut report).unwrap();
    assert_eq!(read.poses.len(), 76);
    assert_eq!(report.losses(), [Loss::OwnSpline, Loss::Keyframes(5)]);
    let up = read.up.unwrap();
    let path = read.path(None, up, 10.0).unwrap().unwrap();
    let imported = self::read(&json, None);
    assert_eq!(&path, self::path(&imported));
    assert_eq!(imported.report.losses(), [Loss::OwnSpline]);
    // A space that holds all points is kept, another is not.
    let space = |half_size: f64| Space {
        centre: DVec3::ZERO,
        half_size,
        up,
    };
    let within = |half_size: f64| {
        let path = read
            .path(Some(space(half_size)), up, 10.0)
            .unwrap()
            .unwrap();
        path.space.half_size == half_size
    };
    assert!(within(5.0) && !within(0.5));
}

/// And without transitions all sections last as long.
#[test]
fn equal_keyframes_are_a_hold() {
    let mut json = file("open");
    json["keyframes"][2] = json["keyframes"][1].clone();
    json["keyframes"][2]["override_transition_sec"] = 2.0.into();
    let imported = read(&json, None);
    let points = path(&imported).points.iter();
    let holds: Vec<_> = points.map(|point| point.orientations[0].hold).collect();
    assert_eq!(holds, [0, 20, 0, 0]);
    let made = poses(&imported);
    assert_eq!((made.len(), made[10]), (76, made[30]));
    for key in json["keyframes"].as_array_mut().unwrap() {
        let key = key.as_object_mut().unwrap();
        key.retain(|name, _| !name.starts_with("override"));
    }
    json["default_transition_sec"].take();
    let imported = read(&json, Some(As::Keys));
    let frames = tracks(&imported)[0].frames();
    assert_eq!(frames, [1.0, 19.75, 38.5, 57.25, 76.0]);
}

/// A loop is squeezed into the seconds, and the tension is that of three.js.
#[test]
fn the_old_viewer_counts_otherwise() {
    let key = |x: f64, y: f64, time: f64| {
        let properties = format!("[[\"FOV\",90],[\"TIME\",{time}]]");
        let matrix = format!("[1,0,0,0, 0,0,1,0, 0,-1,0,0, {x},{y},3,1]");
        serde_json::json!({"matrix": matrix, "fov": 90, "properties": properties})
    };
    let json = serde_json::json!({
        "keyframes": [key(1.0, 0.0, 0.0), key(3.0, 1.0, 0.5), key(2.0, 2.0, 1.0)],
        "camera_path": [],
        "fps": 10,
        "seconds": 6,
        "smoothness_value": 0.25,
        "is_cycle": true,
    });
    let imported = read(&json, None);
    let path = path(&imported);
    assert!(path.closed);
    for point in &path.points {
        assert_eq!(point.curve, CurveParameters::Own(Tcb::new(0.5, 0.0, 0.0)));
        assert_eq!(point.orientations[0].own.frames, 20);
    }
}
