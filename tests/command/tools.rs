//! The tools as a shell sees them: moves, blocks, fits, checks, plots.

use super::*;

pub(super) const CAR: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/car.vid");

// ---- Tools ----------------------------------------------------------------------------

/// A file in a folder of this test's own, with what a run wrote there.
pub(super) fn written(folder: &Path, name: &str, arguments: &[&str]) -> String {
    let file = folder.join(name);
    let mut all = arguments.to_vec();
    all.extend(["-o", file.to_str().unwrap()]);
    match arguments[0] {
        "fit" => drop(fit_report(&run(&all))),
        _ => assert_eq!(said(&run(&all)), ""),
    }
    file.to_str().unwrap().to_owned()
}

/// What a fit reports, a line each.
fn fit_report(output: &std::process::Output) -> Vec<String> {
    let told = String::from_utf8(output.stderr.clone()).unwrap();
    assert!(output.status.success(), "{told}");
    let lines: Vec<String> = told.lines().map(str::to_owned).collect();
    assert!(
        lines.iter().any(|line| line.contains(" points for ")),
        "{told}"
    );
    lines
}

#[test]
fn an_orbit_is_made_extracted_repeated_and_turned_round() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let orbit = written(
        folder,
        "orbit.vid",
        &[
            "orbit",
            "--around",
            "0,0.5,0",
            "--radius",
            "1.2",
            "--height",
            "0.4",
            "--turns",
            "2",
            "--seconds",
            "12",
        ],
    );
    let poses = poses_of(&orbit);
    assert_eq!(poses.len(), 300);
    for pose in &poses {
        assert!((pose.vrp[0].hypot(pose.vrp[2]) - 1.2).abs() < 1e-6);
        assert!((pose.vrp[1] - 0.9).abs() < 1e-12);
    }
    let half = written(folder, "half.vid", &["extract", &orbit, "--last", "13"]);
    let again = written(folder, "again.vid", &["repeat", &half, "--times", "3"]);
    assert_eq!(
        Document::load(Path::new(&again))
            .unwrap()
            .path()
            .points
            .len(),
        37
    );
    let exact = written(folder, "exact.vid", &["frames", &orbit, "--frames", "77"]);
    assert_eq!(poses_of(&exact).len(), 77);
    let back = written(folder, "back.vid", &["reverse", &orbit]);
    let mut reversed = poses_of(&back);
    reversed.reverse();
    for (a, b) in poses.iter().zip(&reversed) {
        assert!(
            numbers(a)
                .iter()
                .zip(numbers(b))
                .all(|(a, b)| (a - b).abs() < 1e-9)
        );
    }
    let moved = written(
        folder,
        "moved.vid",
        &["move", &orbit, "--by", "1,-2,3", "--with-targets"],
    );
    for (a, b) in poses.iter().zip(&poses_of(&moved)) {
        assert!(
            (b.vrp[0] - a.vrp[0] - 1.0).abs() < 1e-12 && (b.vrp[1] - a.vrp[1] + 2.0).abs() < 1e-12
        );
        assert!((b.vpn[0] - a.vpn[0]).abs() < 1e-12);
    }
    let blend = written(
        folder,
        "blend.vid",
        &["blend", &orbit, &moved, "--weight", "0.75"],
    );
    let first = poses_of(&blend)[0].vrp;
    assert!((first[0] - poses[0].vrp[0] - 0.75).abs() < 1e-12);
    let twisted = written(
        folder,
        "twisted.vid",
        &["twist", &orbit, "--axis", "y", "--angle", "90"],
    );
    assert_ne!(poses_of(&twisted)[150].vrp, poses[150].vrp);
    let joined = written(
        folder,
        "joined.vid",
        &["insert", PYRAMID, &half, "--fit", "turn"],
    );
    assert!(poses_of(&joined).len() > poses_of(PYRAMID).len());
}

#[test]
fn tools_refuse_what_does_not_do() {
    for arguments in [
        &["orbit", "--radius", "0"][..],
        &["dolly-zoom", "--end-distance", "1e-3"],
        &["figure-eight", "--width", "0"],
        &["scale", PYRAMID, "--factor", "0"],
        &["move", PYRAMID, "--first", "5", "--last", "99"],
        &["move", PYRAMID, "--first", "5", "--last", "4"],
        &["scale", PYRAMID, "--at", "7"],
        &["frames", PYRAMID, "--frames", "5"],
        &["twist", PYRAMID, "--axis", "y", "--box", "1,1,1,0,0,0"],
        &["extract", PYRAMID, "--first", "2", "--last", "2"],
        &["extract", PYRAMID, "--first", "3", "--last", "2"],
        &["repeat", PYRAMID, "--times", "0"],
        &["insert", PYRAMID, PYRAMID, "--at", "0"],
        &["insert", PYRAMID, PYRAMID, "--fit", "scale"],
    ] {
        sentence(&run(arguments), 1);
    }
    for arguments in [
        &["loop"][..],
        &["orbit", "--around", "1,2"],
        &["orbit", "--radius", "nan"],
        &["frames", PYRAMID],
        &["shear", PYRAMID],
        &["transform", PYRAMID],
        &["blend", PYRAMID],
        &["turn", PYRAMID, "--about", "nowhere"],
        &["turn", PYRAMID, "--axis", "w"],
        &["twist", PYRAMID, "--box", "1,2,3"],
        &["fit", PYRAMID, "--tolerance", "inf"],
    ] {
        complaint(&run(arguments), 2);
    }
}

/// The true reason, and what helps.
#[test]
fn sentences_tell_why() {
    let folder = tempfile::tempdir().unwrap();
    let poses = folder.path().join("poses.csv");
    let poses = poses.to_str().unwrap();
    said(&run(&["sample", PYRAMID, "--format", "csv", "-o", poses]));
    let scale = "the scale of a matrix must lie between 1e-78 and 1e78, mirrored or not";
    let still = "the camera would stay where it is: the move must end elsewhere than it begins";
    let fps = "the frames per second must be greater than 0 and at most 100000";
    for (arguments, reason) in [
        (
            &["fit", poses, "--tolerance", "0"][..],
            "the tolerance must be finite and greater than 0",
        ),
        (
            &["fit", poses, "--angle", "1e300"],
            "the tolerance of angles must be greater than 0 and at most 180 degrees",
        ),
        (&["fit", poses, "--fps", "1e9"], fps),
        (&["orbit", "--fps", "1e9"], fps),
        (&["crane", "--height", "0", "--end-height", "0"], still),
        (
            &["approach", "--distance", "1", "--end-distance", "1"],
            still,
        ),
        (&["scale", PYRAMID, "--factor", "0"], scale),
        (
            &["frames", PYRAMID, "--seconds", "1"],
            "25 frames are too few: it must have at least 33",
        ),
        (
            &["frames", PYRAMID, "--frames", "1"],
            "1 frame is too few: it must have at least 33",
        ),
    ] {
        let said = sentence(&run(arguments), 1);
        assert!(
            said.ends_with(&format!(": {reason}\n")),
            "{arguments:?}: {said}"
        );
    }
    let line = folder.path().join("line.txt");
    let lines: String = (0..10)
        .map(|k| format!("{k} 0 0 0 0 -1 0 1 0 24\n"))
        .collect();
    fs::write(&line, lines).unwrap();
    // Within the tolerance it rests.
    fit_report(&run(&[
        "fit",
        line.to_str().unwrap(),
        "--tolerance",
        "1e300",
    ]));
    // What turns has its points by the angle, whatever the tolerance.
    fit_report(&run(&["fit", poses, "--tolerance", "1e300"]));
    // So noisy that each pose would be a point.
    let noisy = folder.path().join("noisy.txt");
    let mut state = 26_u64;
    let mut jitter = || {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / 2_f64.powi(53)
    };
    let lines: String = (0..120_000)
        .map(|_| format!("{} {} {} 0 0 -1 0 1 0 24\n", jitter(), jitter(), jitter()))
        .collect();
    fs::write(&noisy, lines).unwrap();
    let said = sentence(&run(&["fit", noisy.to_str().unwrap()]), 1);
    assert!(
        said.ends_with(
            ": within this tolerance the poses need more than 100000 points: with a larger one the \
             path does not follow their noise; or fit fewer poses at once\n"
        ),
        "{said}"
    );
}

#[test]
fn frames_are_given_as_seconds_too() {
    let folder = tempfile::tempdir().unwrap();
    for (option, given, frames) in [
        ("--seconds", "10", 250),
        ("--seconds", "9.98", 250),
        ("--frames", "250", 250),
        ("--seconds", "40.04", 1001),
    ] {
        let path = written(
            folder.path(),
            "paced.vid",
            &["frames", PYRAMID, option, given],
        );
        assert_eq!(poses_of(&path).len(), frames, "{given}");
    }
    for wrong in ["-3", "0", "nan", "ten"] {
        complaint(&run(&["frames", PYRAMID, "--seconds", wrong]), 2);
    }
}

/// A closed form: the fixed point of a turn, of a mirror and of a scale stays, others move by it.
#[test]
fn points_are_changed_about_a_place() {
    let folder = tempfile::tempdir().unwrap();
    let orbit = written(folder.path(), "orbit.vid", &["orbit"]);
    let before = poses_of(&orbit)[0].vrp;
    let at = |file: &str| poses_of(file)[0].vrp;
    let close = |a: [f64; 3], b: [f64; 3]| {
        assert!(
            a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-9),
            "{a:?} {b:?}"
        );
    };
    let [x, y, z] = before;
    for (arguments, wanted) in [
        (
            &["scale", &orbit, "--factor", "3", "--about", "1,2,-3"][..],
            [
                1.0 + 3.0 * (x - 1.0),
                2.0 + 3.0 * (y - 2.0),
                -3.0 + 3.0 * (z + 3.0),
            ],
        ),
        (
            &["mirror", &orbit, "--axis", "x", "--about", "origin"],
            [-x, y, z],
        ),
        (
            &["mirror", &orbit, "--axis", "z", "--about", "0,0,-2"],
            [x, y, -4.0 - z],
        ),
        (
            &[
                "turn",
                &orbit,
                "--axis",
                "y",
                "--angle",
                "90",
                "--about=1,5,2",
            ],
            [1.0 + (z - 2.0), y, 2.0 - (x - 1.0)],
        ),
        (
            &["scale", &orbit, "--factor", "3", "--about", "point"],
            [x, y, z],
        ),
    ] {
        close(at(&written(folder.path(), "made.vid", arguments)), wanted);
    }
}

/// A twist about the axis of a given box: by ±45° at its ends, nothing in its middle.
#[test]
fn a_box_of_ones_own_is_twisted() {
    let folder = tempfile::tempdir().unwrap();
    let arc = written(folder.path(), "arc.vid", &["arc", "--height", "0"]);
    let still = ["twist", &arc, "--axis", "y", "--box", "-1,-1,-1,1,1,1"];
    let still = written(folder.path(), "still.vid", &still);
    let turned = ["twist", &arc, "--axis", "y", "--box", "-1,0,-1,1,1,1"];
    let turned = written(folder.path(), "turned.vid", &turned);
    let point = |file: &str| Document::load(Path::new(file)).unwrap().path().points[0].position;
    let (from, same, far) = (point(&arc), point(&still), point(&turned));
    assert_ne!(same, far);
    for place in [same, far] {
        assert!(
            (place.length() - from.length()).abs() < 1e-9,
            "{place} {from}"
        );
    }
    let angle = from.angle_between(far) - from.angle_between(same);
    assert!(
        (angle.abs() - std::f64::consts::FRAC_PI_4).abs() < 1e-9,
        "{angle}"
    );
}

/// An object's file needs no checksum by hand; saved, it has one.
#[test]
fn an_object_is_named_by_its_file_alone() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    fs::write(at("roof.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").unwrap();
    let points = "[[point]]\nposition = [0, 0, 1]\n[[point]]\nposition = [1, 0, 1]\n";
    let by_hand = format!("version = 1\n[object]\nfile = \"roof.obj\"\n{points}");
    fs::write(at("hand.vid"), &by_hand).unwrap();
    let checked = run(&["check", &at("hand.vid")]);
    assert!(checked.stderr.is_empty(), "{checked:?}");
    let saved = written(folder.path(), "saved.vid", &["reverse", &at("hand.vid")]);
    let text = fs::read_to_string(&saved).unwrap();
    assert!(
        text.contains("file = \"roof.obj\"\nbytes = 32\nchecksum = \""),
        "{text}"
    );
    // A mesh of a scene too.
    let scene = "version = 1\n[[node]]\nname = \"roof\"\nkind = \"object\"\n[node.mesh]\nfile = \"roof.obj\"\n";
    fs::write(at("scene.vid"), scene).unwrap();
    let text = said(&run(&["info", &at("scene.vid")]));
    assert!(text.contains("3 points, 1 triangles"), "{text}");
    // Gone, it stays as it was written; half a checksum is none.
    fs::remove_file(at("roof.obj")).unwrap();
    let gone = String::from_utf8(run(&["check", &at("hand.vid")]).stderr).unwrap();
    assert!(gone.contains("roof.obj: "), "{gone}");
    let kept = written(folder.path(), "kept.vid", &["reverse", &at("hand.vid")]);
    let text = fs::read_to_string(&kept).unwrap();
    assert!(text.contains("file = \"roof.obj\"\n\n"), "{text}");
    let half = by_hand.replace(".obj\"\n", ".obj\"\nbytes = 32\n");
    fs::write(at("hand.vid"), half).unwrap();
    let said = sentence(&run(&["info", &at("hand.vid")]), 1);
    assert!(
        said.contains("line 2: object: a mesh has points of its own, or a file: alone"),
        "{said}"
    );
}

/// What the tables say, from the same file by another reader.
#[test]
fn info_is_json_too() {
    let json = |arguments: &[&str]| -> serde_json::Value {
        serde_json::from_str(&said(&run(arguments))).unwrap()
    };
    let path = json(&["info", PYRAMID, "--json"]);
    let poses = poses_of(PYRAMID);
    assert_eq!(
        (&path["kind"], &path["title"]),
        (&"path".into(), &"Around the pyramid".into())
    );
    assert_eq!(path["frames"], poses.len());
    assert_eq!(path["seconds"], poses.len() as f64 / 25.0);
    assert_eq!(path["file"], PYRAMID);
    assert_eq!(
        path["points"][0]["position"],
        serde_json::json!(poses[0].vrp)
    );
    let sections = path["sections"].as_array().unwrap();
    let [first, last] = [&sections[0], &sections[sections.len() - 1]];
    let held = |section: &serde_json::Value| section["hold_frames"].as_u64().unwrap();
    assert_eq!(first["first_frame"], 2 + held(first));
    assert_eq!(last["last_frame"], poses.len());
    let frames = sections
        .iter()
        .map(|one| one["frames"].as_u64().unwrap() + held(one));
    assert_eq!(1 + frames.sum::<u64>(), poses.len() as u64);
    let scene = json(&["info", CAR, "--json"]);
    assert_eq!(scene["kind"], "scene");
    let nodes = scene["nodes"].as_array().unwrap();
    let camera = nodes.iter().find(|node| node["kind"] == "camera").unwrap();
    assert_eq!(
        (&camera["name"], &camera["mesh"]),
        (&"camera".into(), &serde_json::Value::Null)
    );
}

#[test]
fn a_sampled_film_becomes_a_path_again() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let poses = folder.join("poses.csv");
    let poses = poses.to_str().unwrap();
    said(&run(&["sample", PYRAMID, "--format", "csv", "-o", poses]));
    let fitted = written(folder, "fitted.vid", &["fit", poses, "--tolerance", "0.02"]);
    let (want, got) = (poses_of(PYRAMID), poses_of(&fitted));
    assert_eq!(got.len(), want.len());
    for (a, b) in want.iter().zip(&got) {
        let far = (0..3).map(|k| (a.vrp[k] - b.vrp[k]).powi(2)).sum::<f64>();
        assert!(far.sqrt() < 0.0201);
    }
    let few = folder.join("few.vid");
    let few = few.to_str().unwrap();
    let told = fit_report(&run(&["fit", poses, "--points", "6", "-o", few]));
    assert!(
        told[0].contains(": 6 points for 724 poses at 25 frames per second; "),
        "{told:?}"
    );
    sentence(&run(&["fit", poses, "--points", "1"]), 1);
    sentence(&run(&["fit", PYRAMID]), 1);
    sentence(&run(&["fit", poses, "--tolerance", "0"]), 1);
    let huge = folder.join("huge.csv");
    let holes = std::fs::File::create(&huge).unwrap();
    holes.set_len(vides::limits::MAX_FILE_BYTES + 1).unwrap();
    let complaint = sentence(&run(&["fit", huge.to_str().unwrap()]), 1);
    assert!(complaint.contains("larger than"), "{complaint}");
}

/// A first orbit around a mesh, or wider than the default space, has nothing to find.
#[test]
fn the_space_of_a_move_holds_it() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let mesh = folder.join("mesh.obj");
    std::fs::write(
        &mesh,
        "v 10 0 0\nv 14 0 0\nv 12 5 0\nv 12 2 3\nf 1 2 3\nf 2 3 4\n",
    )
    .unwrap();
    let mesh = mesh.to_str().unwrap();
    for (name, options) in [
        ("around.vid", &["--object", mesh, "--seconds", "20"][..]),
        ("wide.vid", &["--radius", "40", "--seconds", "20"]),
    ] {
        let file = written(folder, name, &[&["orbit"], options].concat());
        assert_eq!(said(&run(&["check", &file])), "");
    }
}

#[test]
fn fits_and_moves_have_a_space() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let orbit = written(folder, "z.vid", &["orbit", "--up", "z"]);
    for pose in poses_of(&orbit) {
        assert!((pose.vrp[0].hypot(pose.vrp[1]) - 1.0).abs() < 1e-6 && pose.vup[2] > 0.9);
    }
    let poses = folder.join("poses.csv");
    let poses = poses.to_str().unwrap();
    said(&run(&["sample", &orbit, "--format", "csv", "-o", poses]));
    let space = |file: &str| Document::load(Path::new(file)).unwrap().path().space;
    let fitted = written(folder, "fitted.vid", &["fit", poses, "--up", "z"]);
    assert_eq!(space(&fitted).up.name(), "z");
    assert!((space(&fitted).half_size - 1.1).abs() < 1e-3);
    let given = ["fit", poses, "--space", "-1,2,3,40"];
    let space = space(&written(folder, "given.vid", &given));
    assert_eq!(
        (space.centre.to_array(), space.half_size),
        ([-1.0, 2.0, 3.0], 40.0)
    );
    complaint(&run(&["fit", poses, "--space", "1,2,3"]), 2);
    complaint(&run(&["fit", poses, "--up", "x"]), 2);
    sentence(&run(&["fit", poses, "--space", "1,2,3,0"]), 1);
    // One pose far off.
    let text = std::fs::read_to_string(poses).unwrap();
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    let mut numbers: Vec<&str> = text.lines().nth(100).unwrap().split(',').collect();
    numbers[3] = "7";
    lines[100] = numbers.join(",");
    std::fs::write(poses, lines.join("\n")).unwrap();
    let robust = folder.join("robust.vid");
    let arguments = ["fit", poses, "--robust", "-o", robust.to_str().unwrap()];
    let told = fit_report(&run(&arguments));
    assert_eq!(
        told.last().unwrap(),
        "vides: 1 of 250 poses is left out: frame 100"
    );
    assert!(
        told.iter().any(|line| line.ends_with("found: 1 outlier")),
        "{told:?}"
    );
    for pose in poses_of(robust.to_str().unwrap()) {
        assert!((pose.vrp[2] - 0.4).abs() < 0.011);
    }
    // The times are those of the frames; the first one stays.
    let later: Vec<String> = text.lines().skip(101).map(str::to_owned).collect();
    std::fs::write(poses, later.join("\n")).unwrap();
    let later = folder.join("later.vid");
    let arguments = ["fit", poses, "--fps", "50", "-o", later.to_str().unwrap()];
    let output = run(&arguments);
    assert!(output.status.success());
    let told = String::from_utf8(output.stderr).unwrap();
    assert!(
        told.contains("pose 2 would be at 0.04") && told.contains("by its frame it is at 0.02 s"),
        "{told}"
    );
    assert_eq!(Document::load(&later).unwrap().info().first_frame, 101);
}

#[test]
fn seconds_that_are_too_many_are_told_as_given() {
    let folder = tempfile::tempdir().unwrap();
    let path = written(folder.path(), "arc.vid", &["arc"]);
    let told = sentence(&run(&["frames", &path, "--seconds", "1e300"]), 1);
    assert!(told.contains("1e300 seconds are too many"), "{told}");
}
