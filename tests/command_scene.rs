//! Scenes as a shell sees them: `vides info`, `vides sample --node`.

use std::path::Path;
use std::process::{Command, Output, Stdio};

use vides::document::{Document, SceneDocument};
use vides::path::Pose;
use vides::scene::{Camera, Kind, Node, NodeState, Warnings};

const CAR: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/car.vid");

fn run(arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_vides"));
    command
        .args(arguments)
        .stdin(Stdio::null())
        .output()
        .unwrap()
}

fn said(arguments: &[&str]) -> String {
    let output = run(arguments);
    let complaints = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{}: {complaints}", output.status);
    assert_eq!(complaints, "");
    String::from_utf8(output.stdout).unwrap()
}

/// The one sentence of a run that must fail.
fn sentence(arguments: &[&str], status: i32) -> String {
    let output = run(arguments);
    let complaint = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(status), "{complaint}");
    assert_eq!(complaint.lines().count(), 1, "{complaint}");
    assert_eq!(output.stdout, b"");
    complaint
}

/// The states of a node of the car's scene, and its first frame.
fn states(name: &str) -> (f64, Vec<NodeState>) {
    let document = SceneDocument::load(Path::new(CAR)).unwrap();
    let scene = &document.scene;
    let (first, last) = scene.frame_range();
    let mut states = vec![NodeState::default(); (last - first) as usize + 1];
    let mut warnings = Warnings::default();
    let node = scene.find(name).unwrap();
    scene
        .sample(node, first, 1.0, &mut states, &mut warnings)
        .unwrap();
    (first, states)
}

fn row(line: &str) -> Vec<f64> {
    line.split(',')
        .map(|field| field.parse().unwrap())
        .collect()
}

fn numbers(pose: &Pose) -> Vec<f64> {
    let mut numbers = [pose.vrp, pose.vpn, pose.vup].concat();
    numbers.push(pose.zoom);
    numbers
}

#[test]
fn a_camera_of_a_scene_is_written_as_poses() {
    let text = said(&["sample", CAR, "--node", "camera", "--format", "csv"]);
    let (first, states) = states("camera");
    let mut lines = text.lines();
    assert!(lines.next().unwrap().starts_with("frame,vrp_x,"));
    let rows: Vec<_> = lines.map(row).collect();
    assert_eq!(rows.len(), states.len());
    for (at, (row, state)) in rows.iter().zip(&states).enumerate() {
        assert_eq!(row[0], first + at as f64);
        assert_eq!(row[1..11], numbers(&state.pose));
        assert_eq!(row[11..], [at as f64 / 25.0]);
    }
    // Ten numbers a line, four decimals.
    let ascii = said(&["sample", CAR, "--node", "camera"]);
    let line = ascii.lines().last().unwrap().split(' ');
    let last = numbers(&states.last().unwrap().pose);
    for (text, number) in line.zip(last) {
        assert!((text.parse::<f64>().unwrap() - number).abs() <= 0.000_051);
    }
}

#[test]
fn other_nodes_are_written_as_matrices() {
    let (_, states) = states("body");
    let text = said(&["sample", CAR, "--node", "body", "--format", "csv"]);
    assert!(text.starts_with("frame,m00,m10,m20,m30,m01,"), "{text}");
    for (line, state) in text.lines().skip(1).zip(&states) {
        let row = row(line);
        assert_eq!(row[1..17], state.matrix);
        assert_eq!(row[17], 1.0);
        assert_eq!(row.len(), 19);
    }
    assert!(text.lines().nth(26).unwrap().ends_with(",1,1.0"), "{text}");
    let json = said(&["sample", CAR, "--node", "body", "--format", "json"]);
    let json: serde_json::Value = serde_json::from_str(&json).unwrap();
    assert_eq!(
        (&json["node"], &json["kind"]),
        (&"body".into(), &"object".into())
    );
    assert_eq!(json["frame_count"], states.len());
    let written = json["states"].as_array().unwrap();
    assert_eq!(written.len(), states.len());
    for (written, state) in written.iter().zip(&states) {
        let matrix = written["matrix"].as_array().unwrap();
        assert!(
            matrix
                .iter()
                .zip(state.matrix)
                .all(|(is, number)| is.as_f64() == Some(number))
        );
        assert_eq!(written["visible"], true);
    }
    assert_eq!(
        said(&["sample", CAR, "--node", "body"])
            .split_whitespace()
            .count(),
        16 * states.len()
    );
}

/// A path alone is a scene of one camera.
#[test]
fn a_path_is_a_scene() {
    let pyramid = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/pyramid.vid");
    let plain = said(&["sample", pyramid, "--format", "csv"]);
    let document = Document::load(Path::new(pyramid)).unwrap();
    let node = said(&["sample", pyramid, "--format", "csv", "--node", "camera"]);
    // A scene counts from 1, whatever the path's first frame is called.
    let poses = |text: &str| {
        let rows = text.lines().skip(1).map(|line| row(line)[1..].to_vec());
        rows.collect::<Vec<_>>()
    };
    assert_eq!(
        poses(&plain).len(),
        document.sampler().unwrap().frame_count()
    );
    for (a, b) in poses(&plain)
        .iter()
        .flatten()
        .zip(poses(&node).iter().flatten())
    {
        assert!((a - b).abs() <= 1e-12, "{a} {b}");
    }
}

#[test]
fn info_shows_nodes_tracks_and_markers() {
    let text = said(&["info", CAR]);
    for words in [
        "A car, an arm",
        "Nodes",
        "Tracks",
        "catmull-rom",
        "Markers",
        "at the arm",
    ] {
        assert!(text.contains(words), "{words}: {text}");
    }
    let document = SceneDocument::load(Path::new(CAR)).unwrap();
    for node in document.scene.nodes() {
        assert!(text.contains(&node.name), "{}: {text}", node.name);
    }
}

/// Frames are told as people count them, and which camera is shown.
#[test]
fn info_counts_from_the_first_frame() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("car.vid");
    let mut document = SceneDocument::load(Path::new(CAR)).unwrap();
    document.info.first_frame = 1001;
    document.scene.set_range(Some((3.0, 20.5))).unwrap();
    document.save(&file).unwrap();
    let file = file.to_str().unwrap();
    let text = said(&["info", file]);
    assert!(
        text.contains("Camera       camera\nFrames       1003 to 1020.5\n"),
        "{text}"
    );
    let frame = document.scene.markers()[0].frame + 1000.0;
    assert!(text.contains(&format!(" {frame}  at the arm")), "{text}");
    let json = said(&["info", file, "--json"]);
    let told: serde_json::Value = serde_json::from_str(&json).unwrap();
    assert_eq!(told["camera"], "camera");
    assert_eq!(
        [&told["first_frame"], &told["last_frame"]],
        [1003.0, 1020.5]
    );
}

/// Without a node it is the shown camera's, over the scene's range, as people count.
#[test]
fn the_shown_camera_is_written_over_the_range() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("car.vid");
    let mut document = SceneDocument::load(Path::new(CAR)).unwrap();
    let mut second = Node::new("second", Kind::Camera(Camera::default()));
    second.rest.position.z = 5.0;
    let second = document.scene.add(second).unwrap();
    document.info.first_frame = 1001;
    document.scene.set_camera(Some(second)).unwrap();
    document.scene.set_range(Some((3.0, 20.5))).unwrap();
    document.save(&file).unwrap();
    let file = file.to_str().unwrap();
    let shown = said(&["sample", file, "--format", "csv"]);
    let named = said(&["sample", file, "--format", "csv", "--node", "second"]);
    let other = said(&["sample", file, "--format", "csv", "--node", "camera"]);
    assert_eq!(shown, named);
    assert_ne!(shown, other);
    let frames: Vec<&str> = shown
        .lines()
        .skip(1)
        .filter_map(|line| line.split(',').next())
        .collect();
    let want: Vec<String> = (1003..=1020).map(|frame: i32| frame.to_string()).collect();
    assert_eq!(frames, want);
}

/// A file with a track whose interpolation is the host's.
fn with_host(folder: &Path) -> String {
    let file = folder.join("host.vid");
    let text = std::fs::read_to_string(CAR).unwrap();
    std::fs::write(&file, text.replace("\"catmull-rom\"", "\"host:near\"")).unwrap();
    file.to_str().unwrap().to_owned()
}

#[test]
fn an_interpolation_comes_from_a_shared_library() {
    let folder = tempfile::tempdir().unwrap();
    let file = with_host(folder.path());
    let source = folder.path().join("near.c");
    let library = folder.path().join("near.so");
    // The key before, from the end: what "step" does.
    let code = "#include <stddef.h>\n\
        int near(const double *f, const double *v, size_t w, size_t n, double at, double *out, void *u)\n\
        { size_t k = 0, i; (void)u; while (k + 1 < n && f[k + 1] <= at) k++;\n\
          for (i = 0; i < w; i++) out[i] = v[k * w + i]; return 0; }\n\
        int fails(void) { return 1; }\n";
    std::fs::write(&source, code).unwrap();
    let compiled = Command::new(std::env::var("CC").unwrap_or("cc".to_owned()))
        .args(["-shared", "-fPIC", "-o"])
        .args([&library, &source])
        .status();
    assert!(compiled.unwrap().success());
    let library = library.to_str().unwrap();
    let option = format!("near={library}:near");
    let by_host = said(&["sample", &file, "--node", "car", "--interpolation", &option]);
    let steps = folder.path().join("step.vid");
    let text = std::fs::read_to_string(&file).unwrap();
    std::fs::write(&steps, text.replace("host:near", "step")).unwrap();
    assert_eq!(
        by_host,
        said(&["sample", steps.to_str().unwrap(), "--node", "car"])
    );

    let refused = |option: &str, status| {
        sentence(
            &["sample", &file, "--node", "car", "--interpolation", option],
            status,
        )
    };
    let fails = refused(&format!("near={library}:fails"), 1);
    assert!(fails.contains("host:near"), "{fails}");
    assert!(refused(&format!("near={library}:nothing"), 1).contains("nothing"));
    assert!(refused("near=./none.so:near", 1).contains("none.so"));
    assert!(refused("near", 2).contains("NAME=FILE.so:SYMBOL"));
}

#[test]
fn what_is_not_there_is_named() {
    let complaint = sentence(&["sample", CAR, "--node", "wheel 5"], 1);
    assert!(
        complaint.contains("car.vid") && complaint.contains("wheel 5"),
        "{complaint}"
    );
    let folder = tempfile::tempdir().unwrap();
    let file = with_host(folder.path());
    // Nobody sees in a file that something stood still.
    let complaint = sentence(&["sample", &file, "--node", "car"], 1);
    assert!(complaint.contains("host:near"), "{complaint}");
    let speeds = ["sample", CAR, "--node", "car", "--move-frames", "5"];
    assert!(sentence(&speeds, 2).contains("base speeds"));
}
