//! Properties got and set by their names, as a shell does it.

use super::*;

/// A file is changed where it lies, or beside it; what is refused leaves it as it was.
#[test]
fn properties_are_got_and_set_by_name() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("flight.vid");
    fs::copy(PYRAMID, &file).unwrap();
    let name = file.to_str().unwrap();
    let zooms = ["get", name, "point.2.zoom", "point.1.name", "fps"];
    let before = fs::read_to_string(&file).unwrap();
    let out = folder.path().join("other.vid");
    let other = out.to_str().unwrap();
    let set = [
        "set",
        name,
        "point.2.zoom=31.5",
        "point.1.name=the corner",
        "fps=30",
    ];
    said(&run(&[&set[..], &["-o", other]].concat()));
    assert_eq!(fs::read_to_string(&file).unwrap(), before);
    said(&run(&set));
    assert_eq!(fs::read(&file).unwrap(), fs::read(&out).unwrap());
    assert_eq!(said(&run(&zooms)), "31.5\n\"the corner\"\n30.0\n");
    let all = said(&run(&["get", name]));
    assert!(all.contains("\npoint.2.view.1.zoom_mm = 31.5\n"), "{all}");

    let after = fs::read(&file).unwrap();
    let refused = complaint(&run(&["set", name, "fps=24", "point.2.zoom=0"]), 1);
    assert!(
        refused.contains("flight.vid: point.2.zoom: the zoom must lie"),
        "{refused}"
    );
    complaint(&run(&["get", name, "point.9.zoom"]), 1);
    let unknown = complaint(&run(&["set", name, "point.2.colour=1"]), 1);
    assert!(
        unknown.contains("no property \"point.2.colour\"; known here: name, position, preset,"),
        "{unknown}"
    );
    complaint(&run(&["set", name, "fps"]), 2);
    let none = complaint(&run(&["set", name, "node.car.scale=[2, 2, 2]"]), 1);
    assert!(none.contains("no scene"), "{none}");
    assert_eq!(fs::read(&file).unwrap(), after);
}

/// Nodes by their names and numbers, beside the path of the shown camera.
#[test]
fn values_of_nodes_are_got_and_set_by_name() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("car.vid");
    let car = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/car.vid");
    fs::copy(car, &file).unwrap();
    let name = file.to_str().unwrap();
    let before = said(&run(&["get", name]));
    let set = [
        "set",
        name,
        "node.car.visible=false",
        "node.car.position=[0, 0.5, 0]",
        "fps=30",
        "--keep",
        "frames",
    ];
    said(&run(&set));
    let after = said(&run(&["get", name]));
    let new: Vec<_> = after
        .lines()
        .filter(|line| !before.contains(line))
        .collect();
    assert_eq!(
        new,
        [
            "fps = 30.0",
            "node.car.position = [0.0, 0.5, 0.0]",
            "node.car.visible = false"
        ]
    );
    let one = said(&run(&["get", name, "node.car.visible", "node.1.scale"]));
    assert_eq!(one, "false\n[1.0, 1.0, 1.0]\n");
    let text = fs::read_to_string(&file).unwrap();
    let refused = complaint(&run(&["set", name, "node.car.aim_weight=2"]), 1);
    assert!(
        refused.contains("car.vid: node.car.aim_weight: "),
        "{refused}"
    );
    complaint(&run(&["get", name, "node.99.zoom"]), 1);
    let unknown = complaint(&run(&["get", name, "node.car.near"]), 1);
    assert!(
        unknown.contains("known here: position, rotation, scale,"),
        "{unknown}"
    );
    assert_eq!(fs::read_to_string(&file).unwrap(), text);
}

/// Another rate keeps seconds, unless frames are to stay; comments stay in either case.
#[test]
fn another_rate_keeps_the_seconds() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("rest.vid");
    let name = file.to_str().unwrap();
    let text = "version = 1\n\n# The corner.\n[[point]]\nposition = [-0.5, 0.0, 0.0]\n\
                orientation = [{ offset = [0.0, 0.0, -1.0], hold_frames = 50, frames = 100 }]\n\n\
                [[point]]\nposition = [0.5, 0.0, 0.0]\norientation = [{ offset = [0.0, 0.0, -1.0] }]\n";
    let hold = ["get", name, "point.1.hold", "point.1.view.1.frames", "fps"];
    fs::write(&file, text).unwrap();
    said(&run(&["set", name, "fps=50", "--keep", "frames"]));
    assert_eq!(said(&run(&hold)), "50\n100\n50.0\n");
    fs::write(&file, text).unwrap();
    said(&run(&["set", name, "fps=50"]));
    assert_eq!(said(&run(&hold)), "100\n200\n50.0\n");
    assert!(fs::read_to_string(&file).unwrap().contains("# The corner."));
    // A scene: keys at the frames that are shown at their seconds.
    let car = folder.path().join("car.vid");
    fs::copy(
        concat!(env!("CARGO_MANIFEST_DIR"), "/examples/car.vid"),
        &car,
    )
    .unwrap();
    let car = car.to_str().unwrap();
    let seconds = |fps: &str| {
        let output = run(&["convert", car, "-", "--to", "csv", "--fps", fps]);
        assert!(output.status.success());
        String::from_utf8(output.stdout).unwrap()
    };
    let before = seconds("25");
    said(&run(&["set", car, "fps=50"]));
    let rows = |text: &str| -> Vec<Vec<f64>> {
        let numbers = |line: &str| line.split(',').map(|cell| cell.parse().unwrap()).collect();
        text.lines().skip(1).map(numbers).collect()
    };
    for (a, b) in rows(&before).iter().zip(rows(&seconds("25"))) {
        let far = a[1..11].iter().zip(&b[1..11]).map(|(a, b)| (a - b).abs());
        assert!(far.fold(0.0, f64::max) < 0.02, "{a:?} {b:?}");
    }
    let refused = complaint(&run(&["set", name, "fps=0"]), 1);
    assert!(refused.contains("fps"), "{refused}");
}
