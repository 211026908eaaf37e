//! `vides convert`: what it writes, what it tells, what it refuses.

use std::fs;

use super::{PYRAMID, complaint, run, run_with_input, said};

const CAR: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/car.vid");

/// What a run that loses something wrote, and what it told, a sentence each.
fn lossy(arguments: &[&str]) -> (String, Vec<String>) {
    let output = run(arguments);
    let told = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.success(), "{told}");
    let told = told.lines().map(str::to_owned).collect();
    (String::from_utf8(output.stdout).unwrap(), told)
}

#[test]
fn what_sample_writes_is_written_by_the_same_code() {
    for format in ["ascii", "csv", "json"] {
        let sampled = said(&run(&["sample", PYRAMID, "--format", format]));
        assert!(said(&run(&["convert", PYRAMID, "-", "--to", format])) == sampled);
    }
    // A path comes through to the last bit, and is then as it is saved, to the last byte.
    let folder = tempfile::tempdir().unwrap();
    let copy = folder.path().join("copy.vid");
    let copy = copy.to_str().unwrap();
    said(&run(&["convert", PYRAMID, copy]));
    let poses = |file| said(&run(&["sample", file, "--format", "csv"]));
    assert!(poses(copy) == poses(PYRAMID));
    let text = fs::read_to_string(copy).unwrap();
    assert!(said(&run(&["convert", copy, "-", "--to", "vid"])) == text);
}

#[test]
fn poses_become_keys_exactly_or_a_path_within_a_tolerance() {
    let folder = tempfile::tempdir().unwrap();
    let place = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let (tum, keys, path) = (place("a.tum"), place("keys.vid"), place("path.vid"));
    let (_, told) = lossy(&["convert", PYRAMID, &tum]);
    assert_eq!(
        told,
        [
            format!("vides: {tum}: points, speeds and holds become poses, one a frame"),
            format!("vides: {tum}: the object is left out"),
            format!("vides: {tum}: the field of view is left out"),
        ]
    );
    let (_, told) = lossy(&["convert", &tum, &keys, "--as", "keys"]);
    assert_eq!(
        told,
        [format!("vides: {tum}: the field of view is left out")]
    );
    let numbers = |text: &str| -> Vec<Vec<f64>> {
        let row = |row: &str| row.split(',').map(|cell| cell.parse().unwrap()).collect();
        text.lines().skip(1).map(row).collect()
    };
    let sampled = |file: &str| numbers(&said(&run(&["sample", file, "--format", "csv"])));
    let (first, again) = (sampled(PYRAMID), sampled(&keys));
    assert_eq!(first.len(), again.len());
    for (a, b) in first.iter().zip(&again) {
        for (a, b) in a[1..10].iter().zip(&b[1..10]) {
            assert!((a - b).abs() < 1e-12, "{a} {b}");
        }
    }
    // From list to list nothing is fitted.
    let csv = lossy(&["convert", &tum, "-", "--to", "csv"]).0;
    for (a, b) in first.iter().zip(&numbers(&csv)) {
        assert!((a[1] - b[1]).abs() < 1e-12);
    }
    let (_, told) = lossy(&["convert", &tum, &path, "--tolerance", "0.001"]);
    assert!(told[1].contains(": a path of "), "{told:?}");
    for (a, b) in first.iter().zip(&sampled(&path)) {
        for (a, b) in a[1..4].iter().zip(&b[1..4]) {
            assert!((a - b).abs() <= 0.001, "{a} {b}");
        }
    }
}

#[test]
fn frames_rate_and_axes_are_chosen() {
    let csv = |options: &[&str]| {
        let arguments = [&["convert", PYRAMID, "-", "--to", "csv"], options].concat();
        let text = said(&run(&arguments));
        let row = |row: &str| row.split(',').map(|cell| cell.parse().unwrap()).collect();
        text.lines().skip(1).map(row).collect::<Vec<Vec<f64>>>()
    };
    let all = csv(&[]);
    let some = csv(&["--frames", "3..7"]);
    assert_eq!(some.len(), 5);
    assert_eq!(some[0][..11], all[2][..11]);
    // Twice the rate lasts as long: every second pose is one of before, at the same time, and the
    // last is shown twice.
    let fine = csv(&["--fps", "50"]);
    assert_eq!(fine.len(), 2 * all.len());
    for (at, pose) in all.iter().enumerate() {
        assert_eq!(fine[2 * at], *pose);
    }
    assert_eq!(fine[fine.len() - 1][1..11], all[all.len() - 1][1..11]);
    // Half the rate leaves out every second one.
    let coarse = csv(&["--fps", "12.5"]);
    assert_eq!(coarse.len(), all.len().div_ceil(2));
    assert_eq!(coarse[1][1..11], all[2][1..11]);
    let turned = csv(&["--up", "z", "--scale", "10"]);
    for (a, b) in all.iter().zip(&turned) {
        assert_eq!([10.0 * a[1], -(10.0 * a[3]), 10.0 * a[2]], b[1..4]);
        assert_eq!([a[4], -a[6], a[5]], b[4..7]);
    }
    assert_eq!(
        complaint(
            &run(&["convert", PYRAMID, "-", "--to", "csv", "--frames", "0..3"]),
            1
        ),
        format!("vides: {PYRAMID}: the frames are 1 to {}\n", all.len())
    );
}

#[test]
fn a_scene_gives_its_shown_camera_or_a_node() {
    let shown = said(&run(&["sample", CAR, "--format", "csv"]));
    let (text, told) = lossy(&["convert", CAR, "-", "--to", "tum"]);
    // Either has a heading.
    assert_eq!(text.lines().count(), shown.lines().count());
    assert!(
        told.iter().any(|line| line.contains("other node")),
        "{told:?}"
    );
    let (wheel, _) = lossy(&["convert", CAR, "-", "--to", "csv", "--node", "car"]);
    assert!(wheel.starts_with("frame,m00,"));
    assert_eq!(
        complaint(
            &run(&["convert", CAR, "-", "--to", "tum", "--node", "car"]),
            1
        ),
        format!("vides: {CAR}: node \"car\" is no camera; of others this format holds nothing\n")
    );
}

/// From list to list, poses keep their times, unless frames are asked for.
#[test]
fn a_list_keeps_its_times() {
    let folder = tempfile::tempdir().unwrap();
    let place = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let (tum, euroc) = (place("a.tum"), place("b.euroc"));
    let stamps = [1403636580.838, 1403636580.911, 1403636581.5, 1403636583.25];
    let lines = stamps.map(|stamp| format!("{stamp} {} 0 0 0 0 0 1\n", stamp - 1403636580.0));
    fs::write(&tum, lines.concat()).unwrap();
    let (_, told) = lossy(&["convert", &tum, &euroc]);
    assert!(
        !told.iter().any(|line| line.contains("begin at")),
        "{told:?}"
    );
    let (text, _) = lossy(&["convert", &euroc, "-", "--to", "tum"]);
    let times = |text: &str| -> Vec<f64> {
        let rows = text.lines().filter(|line| !line.starts_with('#'));
        rows.map(|row| row.split(' ').next().unwrap().parse().unwrap())
            .collect()
    };
    for (was, is) in stamps.iter().zip(times(&text)) {
        assert!((was - is).abs() < 5e-6, "{was} {is}");
    }
    let (frames, _) = lossy(&[
        "convert", &tum, "-", "--to", "tum", "--times", "frames", "--start", "0",
    ]);
    let frames = times(&frames);
    assert!(
        frames.len() > 4
            && frames
                .windows(2)
                .all(|pair| (pair[1] - pair[0] - frames[1]).abs() < 1e-9)
    );
}

#[test]
fn what_cannot_be_done_is_told() {
    for (arguments, status, said) in [
        (
            ["convert", PYRAMID, "-"].as_slice(),
            2,
            "vides: standard output has no name that tells a format: give --to\n",
        ),
        (
            &["convert", PYRAMID, "x.unknown"],
            2,
            "vides: x.unknown: no format has this ending: name it, with --to in the command\n",
        ),
        (
            &["convert", PYRAMID, "-", "--to", "csv", "--node", "x"],
            1,
            "there is no node \"x\"\n",
        ),
        (
            &["convert", "/nowhere.tum", "-", "--to", "csv"],
            1,
            "vides: /nowhere.tum: No such file or directory\n",
        ),
        (
            &["convert", PYRAMID, "-", "--to", "csv", "--fps", "0"],
            2,
            "a number greater than 0 and at most 100000 is wanted\n\nFor more information, try '--help'.\n",
        ),
        (
            &["convert", PYRAMID, "-", "--to", "vid", "--scale", "2"],
            1,
            "scale: a .vid file holds all of a document as it is\n",
        ),
        (
            &["convert", PYRAMID, PYRAMID],
            2,
            "which was read: name another output\n",
        ),
    ] {
        let complaint = complaint(&run(arguments), status);
        assert!(complaint.ends_with(said), "{complaint}");
    }
    let unknown = complaint(&run(&["convert", PYRAMID, "-", "--to", "tea"]), 2);
    assert!(unknown.starts_with("vides: there is no format \"tea\"; formats are vid, "));
    for (input, said) in [
        (
            "nothing known",
            "this is no file of a format that is read: name it, with --from in the command",
        ),
        ("0 1 2 3 0 0 0 x\n", "line 1: expected a number"),
        (
            "0 1 2 3 0 0 0 1\n1 0 0 0 0 0 0 0\n",
            "line 2: the rotation is zero",
        ),
        (
            "0 1 2 3 0 0 0 1\n-1 0 0 0 0 0 0 1\n",
            "line 2: the times must increase",
        ),
        ("0 1 2 inf 0 0 0 1\n", "line 1: the number must be finite"),
    ] {
        let from = if input.starts_with('0') {
            "--from=tum"
        } else {
            "--as=keys"
        };
        let arguments = ["convert", "-", "-", "--to", "csv", "--as", "keys", from];
        let arguments = if from == "--as=keys" {
            &arguments[..5]
        } else {
            &arguments[..]
        };
        let output = run_with_input(arguments, input.as_bytes());
        assert_eq!(
            complaint(&output, 1),
            format!("vides: standard input: {said}\n")
        );
    }
}

/// A camera by keys in a file with keys keeps them, or follows a path if that is asked for.
#[test]
fn keys_stay_keys_or_become_a_path() {
    let folder = tempfile::tempdir().unwrap();
    let place = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let (glb, keys, path) = (place("a.glb"), place("keys.vid"), place("path.vid"));
    lossy(&["convert", PYRAMID, &glb]);
    lossy(&["convert", &glb, &keys]);
    let (_, told) = lossy(&["convert", &glb, &path, "--as", "path"]);
    assert!(
        told.iter().any(|line| line.contains(": a path of ")),
        "{told:?}"
    );
    let holds = |file: &str, what: &str| fs::read_to_string(file).unwrap().contains(what);
    assert!(holds(&keys, "[[node.track]]") && !holds(&keys, "[[node.path"));
    assert!(!holds(&path, "channel = \"position\"") && holds(&path, "point]]"));
    let count = |file: &str| said(&run(&["sample", file])).lines().count();
    assert_eq!(count(&path), count(PYRAMID));
}
