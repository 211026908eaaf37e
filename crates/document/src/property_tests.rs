use super::*;
use crate::error::ErrorKind;

fn flight() -> Document {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/pyramid.vid");
    Document::load(file.as_ref()).unwrap()
}

/// Every property that a file has is set to what it is: no bit changes, no step is made.
#[test]
fn what_is_got_can_be_set() {
    let mut document = flight();
    let before = document.to_toml().unwrap();
    let all = document.properties().unwrap();
    assert!(all.len() > 60);
    for (name, value) in all {
        if ["version", "space.", "check."]
            .iter()
            .any(|other| name.starts_with(other))
        {
            continue;
        }
        document.set_property(&name, &value).unwrap();
        assert_eq!(document.property(&name).unwrap(), value, "{name}");
    }
    assert_eq!(document.to_toml().unwrap(), before);
    assert!(!document.undo());
}

/// The same of nodes; what a node cannot have is refused by its full name.
#[test]
fn nodes_have_properties() {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/car.vid");
    let mut document = Document::load_scene(file.as_ref()).unwrap().0;
    let before = document.to_toml().unwrap();
    let all = document.properties().unwrap();
    let of_nodes = all.iter().filter(|(name, _)| name.starts_with("node."));
    assert!(of_nodes.clone().count() > 10);
    for (name, value) in of_nodes {
        document.set_property(name, value).unwrap();
        assert_eq!(document.property(name).unwrap(), *value, "{name}");
    }
    assert_eq!(document.to_toml().unwrap(), before);
    assert!(!document.undo());
    for row in Values::PROPERTIES {
        let name = format!("node.camera.{}", row.key());
        let value = document.property(&name).unwrap();
        document.set_property(&name, "").unwrap();
        document.set_property(&name, &value).unwrap();
    }
    assert_eq!(document.to_toml().unwrap(), before);
    document.set_property("node.sun.intensity", "3").unwrap();
    assert!(document.to_toml().unwrap().contains("\nintensity = 3.0\n"));
    assert!(document.undo());
    assert_eq!(document.to_toml().unwrap(), before);
    for (name, value, reason) in [
        ("node.sun.intensity", "-1", "node.sun.intensity: "),
        ("node.sun.cone", "[40, 20]", "node.sun.cone: "),
        ("node.sun.rotation", "[0, 0, 0, 0]", "node.sun.rotation: "),
        ("node.moon.intensity", "1", "moon"),
        ("node.0.intensity", "1", "\"0\""),
        ("node.sun.near", "1", "known here: position"),
        ("node.sun", "1", "known here: position"),
    ] {
        let error = document.set_property(name, value).unwrap_err();
        assert!(error.to_string().contains(reason), "{name}: {error}");
    }
    assert_eq!(document.to_toml().unwrap(), before);
    let error = flight().set_property("node.sun.intensity", "1");
    assert_eq!(error.unwrap_err().kind(), ErrorKind::Argument);
}

/// By their short names, and undone in one step each.
#[test]
fn names_need_neither_unit_nor_view() {
    let mut document = flight();
    let before = document.to_toml().unwrap();
    for (name, value, full) in [
        ("point.2.zoom", "30", "point.2.view.1.zoom_mm"),
        ("point.2.view.1.hold", "12", "point.2.view.1.hold_frames"),
        ("point.2.locked", "true", "point.2.view.1.locked"),
        ("point.2.roll", "-7.5", "point.2.view.1.roll_degrees"),
        ("point.2.up", "minimal", "point.2.view.1.up"),
        (
            "point.2.ease",
            "{kind = \"sine\", rise = 0.5}",
            "point.2.view.1.ease",
        ),
        ("point.1.name", "left \"corner\"", "point.1.name"),
        ("point.1.position", "[0.5, 0.25, 0.75]", "point.1.position"),
        ("point.1.preset", "3", "point.1.preset"),
        ("curve", "cubic", "curve"),
        ("title", "", "title"),
        ("fps", "30", "fps"),
        ("base_speeds.zoom_frames", "70", "base_speeds.zoom_frames"),
        ("presets.4", "{ tension = 0.5 }", "presets.4"),
    ] {
        document.set_property(name, value).unwrap();
        let got = document.property(full).unwrap();
        assert_eq!(got, document.property(name).unwrap());
        let after = document.to_toml().unwrap();
        assert_ne!(after, before, "{name}");
        let differ = after.lines().filter(|line| !before.contains(line)).count();
        assert!(differ <= 1, "{name}: {differ} lines");
        assert!(
            document.undo() && document.to_toml().unwrap() == before,
            "{name}"
        );
    }
}

#[test]
fn nothing_gives_back_what_a_new_one_has() {
    let mut document = flight();
    document.set_property("fps", "30").unwrap();
    document.set_property("curve", "cubic").unwrap();
    for (name, value) in [
        ("fps", "25.0"),
        ("closed", "false"),
        ("curve", "\"tcb\""),
        ("title", "\"\""),
        ("base_speeds.zoom_frames", "100.0"),
        ("point.2.zoom", "24.0"),
        ("point.2.hold", "0"),
        ("point.2.name", ""),
        ("point.2.up", "\"axis\""),
        ("point.2.ahead", ""),
        ("point.2.roll_slope", ""),
        ("point.2.tangents", ""),
    ] {
        document.set_property(name, "").unwrap();
        assert_eq!(document.property(name).unwrap(), value, "{name}");
    }
}

#[test]
fn a_target_ends_looking_ahead() {
    let mut document = flight();
    document.set_property("point.2.ahead", "0.5").unwrap();
    assert_eq!(document.property("point.2.ahead").unwrap(), "0.5");
    document
        .set_property("point.2.target", "[0, 0.1, 0]")
        .unwrap();
    assert_eq!(document.property("point.2.ahead").unwrap(), "");
}

/// Each with a sentence that begins with its name; the path stays.
#[test]
fn what_cannot_be_is_refused() {
    let mut document = flight();
    let before = document.to_toml().unwrap();
    for (name, value, said) in [
        (
            "point.2.zoom",
            "3000",
            "point.2.zoom: the zoom must lie between 1 and 2000",
        ),
        (
            "point.2.zoom",
            "wide",
            "point.2.zoom: expected a number, found a text",
        ),
        (
            "point.2.zoom",
            "nan",
            "point.2.zoom: the number must be finite",
        ),
        ("point.2.zoom", "1\nhold_frames = 4", "point.2.zoom: "),
        (
            "point.2.hold",
            "-1",
            "point.2.hold: must lie between 0 and 1000000",
        ),
        (
            "point.2.locked",
            "yes",
            "point.2.locked: expected true or false, found a text",
        ),
        (
            "point.2.colour",
            "1",
            "there is no property \"point.2.colour\"",
        ),
        (
            "point.0.zoom",
            "30",
            "there is no property \"point.0.zoom\"",
        ),
        (
            "point.99.zoom",
            "30",
            "there is no point 99: the path has points 1 to ",
        ),
        (
            "point.2.view.9.zoom",
            "30",
            "there is no orientation 9: point 2 has orientations 1 to",
        ),
        ("point.2", "30", "there is no property \"point.2\""),
        (
            "curve",
            "round",
            "curve: must be \"tcb\", \"centripetal\", \"chordal\", \"cubic\" or \"linear\"",
        ),
        ("base_speeds.zoom_frames", "0", "base_speeds.zoom_frames: "),
        (
            "presets.12",
            "{}",
            "presets.12: the presets are numbered 0 to 9",
        ),
        ("space.up", "z", "there is no property \"space.up\""),
        ("", "", "there is no property \"\""),
    ] {
        let error = document.set_property(name, value).unwrap_err();
        assert!(error.to_string().starts_with(said), "{name}: {error}");
        let kind = error.kind();
        assert!(
            matches!(kind, ErrorKind::Argument | ErrorKind::Range),
            "{name}"
        );
        assert_eq!(document.to_toml().unwrap(), before);
    }
}
