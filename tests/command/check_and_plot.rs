//! Checks and plots as a shell sees them.

use vides::document::Edit;

use super::tools::{CAR, written};
use super::*;

#[test]
fn a_check_tells_by_its_exit_status() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let calm = written(folder, "calm.vid", &["orbit", "--radius", "0.9"]);
    assert_eq!(said(&run(&["check", &calm])), "");
    assert_eq!(said(&run(&["check", &calm, "--json"])), "[]\n");
    let fast = written(
        folder,
        "fast.vid",
        &["orbit", "--radius", "0.9", "--seconds", "3"],
    );
    let output = run(&["check", &fast, "--json"]);
    assert_eq!(output.status.code(), Some(3));
    assert!(output.stderr.is_empty());
    let found: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    let turning = found
        .as_array()
        .unwrap()
        .iter()
        .find(|f| f["kind"] == "turning");
    let value = turning.unwrap()["value"].as_f64().unwrap();
    assert!((100.0..140.0).contains(&value), "{value}");
    let text = run(&["check", &fast]);
    assert_eq!(text.status.code(), Some(3));
    assert!(String::from_utf8(text.stdout).unwrap().contains("turning"));
    sentence(&run(&["check", "no such file"]), 1);
}

/// The same object from the path's file, from a mesh file and from another path.
#[test]
fn a_check_looks_at_the_object_that_it_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let wall = folder.join("wall.obj");
    fs::write(&wall, "v 0 -9 -9\nv 0 9 -9\nv 0 0 9\nf 1 2 3\n").unwrap();
    let wall = wall.to_str().unwrap();
    let plain = folder.join("plain.vid");
    let document = Document::new();
    document.save(&plain).unwrap();
    let plain = plain.to_str().unwrap();
    let kinds = |arguments: &[&str]| {
        let output = run(arguments);
        assert!(output.stderr.is_empty());
        let found: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
        let found = found.as_array().unwrap().iter();
        found
            .map(|f| f["kind"].as_str().unwrap().to_owned())
            .collect::<Vec<_>>()
    };
    assert!(!kinds(&["check", plain, "--json"]).contains(&"through".to_owned()));
    let wanted = kinds(&["check", plain, "--json", "--object", wall]);
    assert!(wanted.contains(&"through".to_owned()) && wanted.contains(&"clearance".to_owned()));
    let poses = folder.join("poses.csv");
    let poses = poses.to_str().unwrap();
    said(&run(&["sample", plain, "--format", "csv", "-o", poses]));
    let fitted = written(folder, "fitted.vid", &["fit", poses, "--object", wall]);
    assert!(kinds(&["check", &fitted, "--json"]).contains(&"through".to_owned()));
    assert_eq!(
        kinds(&["check", plain, "--json", "--object", &fitted]),
        wanted
    );
    let plot = said(&run(&["plot", plain, "--object", wall]));
    assert!(plot.contains("leads through the object") && plot.contains("Clearance"));
    let past = ["flyby", "--object", wall];
    assert!(written(folder, "past.vid", &past).ends_with("past.vid"));
    assert!(
        fs::read_to_string(folder.join("past.vid"))
            .unwrap()
            .contains("wall.obj")
    );
    let off = [
        "through=off",
        "clearance=off",
        "nothing-to-see=off",
        "redundant=off",
    ];
    let off: Vec<&str> = off.iter().flat_map(|kind| ["--limit", kind]).collect();
    let left = kinds(&[&["check", plain, "--json", "--object", wall][..], &off].concat());
    assert!(!left.contains(&"through".to_owned()), "{left:?}");
    for wrong in ["turning", "tuning=3", "turning=x", "turning=-1"] {
        complaint(&run(&["check", plain, "--limit", wrong]), 2);
    }
    sentence(&run(&["check", plain, "--object", plain]), 1);
}

#[test]
fn a_note_is_no_finding() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let room = folder.join("room.obj");
    let corners = "v -9 -9 -9\nv 9 -9 -9\nv 0 9 -9\nv 0 0 9\n";
    fs::write(
        &room,
        format!("{corners}f 1 2 3\nf 1 2 4\nf 2 3 4\nf 3 1 4\n"),
    )
    .unwrap();
    let path = written(folder, "orbit.vid", &["orbit", "--radius", "0.9"]);
    let check = ["check", &path, "--object", room.to_str().unwrap()];
    let text = said(&run(&check));
    assert_eq!(
        text,
        "Note: The camera is inside the object all the time.\n"
    );
    let json = said(&run(&[&check[..], &["--json"]].concat()));
    let notes: serde_json::Value = serde_json::from_str(&json).unwrap();
    assert_eq!(notes[0]["kind"], "note");
    assert_eq!(
        notes[0]["text"],
        "The camera is inside the object all the time."
    );
}

/// 20 m in 10 frames of a space of 20 m: some 50 m/s, whatever the file counts in.
#[test]
fn limits_and_findings_are_in_lengths_of_the_path() {
    let speed = |limit: &str| {
        let check = ["check", "-", "--json", "--limit", limit];
        let output = run_with_input(&check, IN_A_WORLD.as_bytes());
        let found: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
        let all = found.as_array().unwrap().clone();
        all.into_iter().find(|finding| finding["kind"] == "speed")
    };
    let found = speed("speed=40").unwrap();
    let value = found["value"].as_f64().unwrap();
    assert!((45.0..80.0).contains(&value), "{value}");
    assert_eq!(found["limit"], 40.0);
    let text = found["text"].as_str().unwrap();
    assert!(text.contains(" lengths/s (limit 40)"), "{text}");
    assert!(speed("speed=80").is_none());
}

#[test]
fn what_can_be_is_fixed() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let fast = ["orbit", "--radius", "0.9", "--seconds", "3"];
    let fast = written(folder, "fast.vid", &fast);
    let fixed = folder.join("fixed.vid");
    let fixed = fixed.to_str().unwrap();
    let text = said(&run(&["check", &fast, "--fix", "-o", fixed]));
    assert!(text.starts_with("Fixed turning, frames "), "{text}");
    assert_eq!(said(&run(&["check", fixed])), "");
    // What is the user's to choose stays, and is told.
    let near = ["check", fixed, "--limit", "target=5"];
    let none = run(&[&near[..], &["--fix", "-o", fixed]].concat());
    assert_eq!(none.status.code(), Some(3));
    let told = String::from_utf8(none.stderr).unwrap();
    assert!(told.starts_with("vides: nothing was fixed"), "{told}");
    complaint(&run(&["check", &fast, "--fix"]), 2);
    complaint(&run(&["check", &fast, "-o", fixed]), 2);
    complaint(&run(&["check", &fast, "--fix", "-o", "-"]), 2);
}

#[test]
fn a_plot_has_all_its_parts() {
    let folder = tempfile::tempdir().unwrap();
    let light = folder.path().join("a.svg");
    assert_eq!(
        said(&run(&["plot", PYRAMID, "-o", light.to_str().unwrap()])),
        ""
    );
    let light = fs::read_to_string(light).unwrap();
    let dark = said(&run(&["plot", PYRAMID, "--dark"]));
    assert!(light.contains("#ffffff") && !dark.contains("#ffffff"));
    for text in [light, dark] {
        assert!(text.starts_with("<svg ") && text.ends_with("</svg>\n"));
        for part in [
            "view-0",
            "view-1",
            "view-2",
            "sphere",
            "findings",
            "chart-0",
            "chart-5",
            "Speed",
            "Acceleration",
            "Turning",
            "Roll",
            "Zoom",
            "Clearance",
        ] {
            assert!(text.contains(part), "{part}");
        }
        assert!(!text.contains("NaN") && !text.contains("inf"));
        // Every element is closed.
        assert_eq!(text.matches("<g ").count(), text.matches("</g>").count());
    }
    complaint(&run(&["plot", PYRAMID, "-o", "a.gif"]), 2);
    sentence(&run(&["plot", "no such file"]), 1);
    sentence(&run(&["plot", CAR]), 1);
    sentence(&run(&["check", CAR]), 1);
}

/// Of a scene it is the path of the camera that is shown, with the objects where they stand.
#[test]
fn a_scene_is_checked_and_plotted_by_its_cameras_path() {
    use vides::scene::{Camera, Extrapolation, FollowPath, Kind, Mesh, Node, Object, Scene};
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("scene.vid");
    let path = Document::new().path().clone();
    let mut scene = Scene::new();
    let mut camera = Node::new("eye", Kind::Camera(Camera::default()));
    let follow = FollowPath::new(path.clone(), 1.0, Extrapolation::Hold).unwrap();
    camera.set_path(Some(follow)).unwrap();
    scene.add(camera).unwrap();
    let mut object = Object::default();
    let size = [[2.0, 0.0], [-1.0, 2.0], [-1.0, -2.0]];
    let points = size
        .map(|[y, z]| vides::glam::DVec3::new(0.0, y, z))
        .to_vec();
    object
        .set_mesh(Mesh {
            points,
            triangles: vec![[0, 1, 2]],
            ..Mesh::default()
        })
        .unwrap();
    scene.add(Node::new("wall", Kind::Object(object))).unwrap();
    let mut document = Document::new();
    document.apply(Edit::ReplaceScene(Box::new(scene))).unwrap();
    document.save(&file).unwrap();
    let file = file.to_str().unwrap();
    // The default path leads from one side of x = 0 to the other.
    assert!(path.points[0].position.x * path.points[1].position.x < 0.0);
    let output = run(&["check", file]);
    assert_eq!(output.status.code(), Some(3));
    assert_eq!(output.stderr, b"");
    assert!(
        String::from_utf8(output.stdout)
            .unwrap()
            .contains("through")
    );
    assert!(said(&run(&["plot", file])).contains("Clearance"));
    let text = fs::read_to_string(file).unwrap();
    let piped = run_with_input(&["check", "-"], text.as_bytes());
    assert_eq!(piped.status.code(), Some(3));

    // Frames are told as people count them: those of the scene, from the number that the first has.
    let frames = |text: &str| -> Vec<f64> {
        let output = run_with_input(&["check", "-", "--json"], text.as_bytes());
        let found: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
        let found = found.as_array().unwrap().iter();
        let found = found.flat_map(|finding| [&finding["first_frame"], &finding["last_frame"]]);
        found.filter_map(serde_json::Value::as_f64).collect()
    };
    let later = text.replacen("\nfirst_frame = 1\n", "\nfirst_frame = 101\n", 1);
    let later = later.replacen("\nstart_frame = 1.0\n", "\nstart_frame = 11.0\n", 1);
    let more = frames(&text).into_iter().map(|frame| frame + 110.0);
    assert_eq!(frames(&later), more.collect::<Vec<_>>());
    assert!(!frames(&later).is_empty());
}

#[test]
fn a_plot_is_a_png_too() {
    let folder = tempfile::tempdir().unwrap();
    let pixels = |more: &[&str]| {
        let file = folder.path().join("a.png");
        let whole = [&["plot", PYRAMID, "-o", file.to_str().unwrap()], more].concat();
        assert_eq!(said(&run(&whole)), "");
        let decoder = png::Decoder::new(BufReader::new(fs::File::open(&file).unwrap()));
        let mut reader = decoder.read_info().unwrap();
        let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
        let info = reader.next_frame(&mut bytes).unwrap();
        assert_eq!((info.width, info.color_type), (1920, png::ColorType::Rgb));
        assert_eq!(bytes.len(), (info.width * info.height * 3) as usize);
        bytes
    };
    for (more, ground, way, ink) in [
        (
            &[][..],
            [0xff, 0xff, 0xff],
            [0x1f, 0x62, 0xb5],
            [0x1d, 0x27, 0x33],
        ),
        (
            &["--dark"][..],
            [0x16, 0x19, 0x1e],
            [0x6e, 0xa8, 0xf0],
            [0xe8, 0xeb, 0xef],
        ),
    ] {
        let bytes = pixels(more);
        assert_eq!(bytes[..3], ground);
        let count = |colour: [u8; 3]| bytes.chunks(3).filter(|pixel| *pixel == colour).count();
        // Lines and letters stand there, and most of it is ground.
        assert!(
            count(way) > 2_000 && count(ink) > 200,
            "{} {}",
            count(way),
            count(ink)
        );
        assert!(count(ground) > bytes.len() / 6);
    }
}

/// The flight of the README, as a reader copies it: with a hold, and clean.
#[test]
fn the_readmes_flight_has_no_findings() {
    let readme = include_str!("../../README.md");
    let (_, flight) = readme.split_once("```toml\n").unwrap();
    let (flight, _) = flight.split_once("```").unwrap();
    assert!(flight.contains("hold_frames"));
    let checked = run_with_input(&["check", "-"], flight.as_bytes());
    assert_eq!(said(&checked), "");
    // A limit that is set counts at the hold, too.
    let checked = run_with_input(
        &["check", "-", "--limit", "speed-jump=0.4"],
        flight.as_bytes(),
    );
    assert_eq!(checked.status.code(), Some(3));
}

/// Recordings whose times are no seconds: a sentence, in little time and memory.
#[test]
fn recordings_with_times_far_apart_are_refused_at_once() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let lines = |times: [f64; 4], rest: &str| {
        times
            .map(|time| format!("{time} {}{rest}\n", time.ln()))
            .concat()
    };
    let ns = lines([1.4e18, 1.5e18, 1.6e18, 1.7e18], " 0 0 0 0 0 1");
    fs::write(at("ns.tum"), ns).unwrap();
    fs::write(at("far.chan"), lines([1.0, 2.0, 3.0, 1e9], " 0 0 0 0 0 40")).unwrap();
    for name in ["ns.tum", "far.chan"] {
        for arguments in [
            &["fit", &at(name), "-o", &at("out.vid")][..],
            &["convert", &at(name), &at("out.vid")],
            &["convert", &at(name), &at("out.glb")],
            &["convert", &at(name), &at("out.tum"), "--as", "keys"],
        ] {
            let script = "ulimit -v 4000000; exec timeout 60 \"$@\"";
            let output = Command::new("sh")
                .args(["-c", script, "sh", env!("CARGO_BIN_EXE_vides")])
                .args(arguments)
                .output()
                .unwrap();
            let told = String::from_utf8_lossy(&output.stderr);
            assert_eq!(output.status.code(), Some(1), "{arguments:?}: {told}");
            assert!(told.contains("frame"), "{arguments:?}: {told}");
        }
    }
    // Keys far apart become no path: one pose a frame would be sampled.
    let keys = "version = 1\n[[node]]\nname = \"eye\"\nkind = \"camera\"\n[[node.track]]\nchannel = \
                \"position\"\ninterpolation = \"linear\"\nframes = [1, 90000000]\nvalues = [[0, 0, 0], [1, 0, 0]]\n";
    let told = sentence(
        &run_with_input(
            &["convert", "-", &at("out.vid"), "--as", "path"],
            keys.as_bytes(),
        ),
        1,
    );
    assert!(
        told.contains("at most 1000000 frames can be fitted"),
        "{told}"
    );
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 2);
}
