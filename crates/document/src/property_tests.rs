use super::*;
use crate::error::ErrorKind;
use crate::scene::SceneDocument;

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
        if ["version", "space.unit"].contains(&name.as_str()) {
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
        ("space.up", "x", "space.up: must be \"y\" or \"z\""),
        ("space.half_size", "0", "space.half_size: "),
        ("space.size", "1", "there is no property \"space.size\""),
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

/// Lists of numbers, as a file has them.
#[test]
fn values_have_types() {
    let mut document = flight();
    let before = document.to_toml().unwrap();
    let speeds = [50.0, 40.0, 30.0, 20.0, 10.0, 10.0, 20.0, 30.0, 40.0, 50.0];
    for (name, numbers, as_text) in [
        (
            "point.2.own",
            &[0.5, 0.25, -0.5][..],
            "{ tension = 0.5, continuity = 0.25, bias = -0.5 }",
        ),
        (
            "presets.4",
            &[0.5, 0.0, 0.0],
            "{ tension = 0.5, continuity = 0.0, bias = 0.0 }",
        ),
        (
            "point.2.ease",
            &[1.0, 0.25, 0.5, 60.0],
            "{ kind = \"parabolic\", rise = 0.25, fall = 0.5, cruise = 60.0 }",
        ),
        (
            "point.2.distance",
            &[0.0, 0.0, 0.5, 0.25, 1.0, 1.0],
            "[[0.0, 0.0], [0.5, 0.25], [1.0, 1.0]]",
        ),
        ("point.2.up_point", &[0.0, 2.0, 0.0], "[0.0, 2.0, 0.0]"),
        (
            "point.2.tangents",
            &[1.0, 0.0, 0.0, 0.0, 1.0, 0.0],
            "{ before = [1.0, 0.0, 0.0], after = [0.0, 1.0, 0.0] }",
        ),
        ("point.2.speed_curve", &speeds, &format!("{speeds:?}")),
        (
            "base_speeds",
            &[10.0, 20.0, 30.0, 40.0],
            "{ move_frames = 10.0, turn_frames = 20.0, zoom_frames = 30.0, roll_frames = 40.0 }",
        ),
    ] {
        document.set_value(name, Given::Numbers(numbers)).unwrap();
        assert_eq!(document.numbers_of(name).unwrap(), numbers, "{name}");
        assert_eq!(document.text_of(name).unwrap(), as_text);
        document.undo();
        document.set_value(name, Given::Text(as_text)).unwrap();
        assert_eq!(document.numbers_of(name).unwrap(), numbers, "{name}");
        document.undo();
        assert_eq!(document.to_toml().unwrap(), before, "{name}");
    }
}

/// One value each; a part of a property keeps the others.
#[test]
fn single_values_have_types() {
    let mut document = flight();
    document
        .set_value("point.2.ahead", Given::Number(0.5))
        .unwrap();
    assert_eq!(document.number_of("point.2.ahead").unwrap(), Some(0.5));
    document
        .set_value("point.2.ahead", Given::Text(""))
        .unwrap();
    assert_eq!(document.number_of("point.2.ahead").unwrap(), None);
    document
        .set_value("point.2.hold", Given::Number(7.0))
        .unwrap();
    assert_eq!(document.number_of("point.2.hold").unwrap(), Some(7.0));
    document
        .set_value("point.2.locked", Given::Flag(true))
        .unwrap();
    assert!(document.flag_of("point.2.locked").unwrap());
    // As it is, where a file has quotes.
    document
        .set_value("title", Given::Text("\"Um\" den Turm "))
        .unwrap();
    assert_eq!(document.text_of("title").unwrap(), "\"Um\" den Turm ");
    document
        .set_value("base_speeds.zoom_frames", Given::Number(70.0))
        .unwrap();
    assert_eq!(
        document.number_of("base_speeds.zoom_frames").unwrap(),
        Some(70.0)
    );
    document
        .set_value("check.turning", Given::Number(45.0))
        .unwrap();
    assert_eq!(document.number_of("check.turning").unwrap(), Some(45.0));
    document
        .set_value("check.turning", Given::Number(f64::INFINITY))
        .unwrap();
    assert_eq!(document.property("check.turning").unwrap(), "off");
    document
        .set_value("check.turning", Given::Text(""))
        .unwrap();
    assert_eq!(document.number_of("check.turning").unwrap(), Some(60.0));
}

/// The file counts them in half sizes, programs in lengths of the world; degrees stay.
#[test]
fn limits_of_lengths_are_in_those_of_the_space() {
    let mut document = Document::new();
    document.set_property("space.half_size", "50").unwrap();
    assert_eq!(document.path().space.half_size, 50.0);
    document.set_property("space.centre", "[10, 0, 0]").unwrap();
    let centre = document.numbers_of("space.centre").unwrap();
    assert_eq!(centre, [10.0, 0.0, 0.0]);
    document
        .set_value("check.speed", Given::Number(25.0))
        .unwrap();
    document.set_property("check.acceleration", "100").unwrap();
    document.set_property("check.turning", "90").unwrap();
    let text = document.to_toml().unwrap();
    for line in ["speed = 0.5", "acceleration = 2.0", "turning = 90.0"] {
        assert!(text.contains(line), "{text}");
    }
    assert_eq!(document.number_of("check.speed").unwrap(), Some(25.0));
    let all = document.properties().unwrap();
    assert!(all.contains(&("check.acceleration".to_owned(), "100.0".to_owned())));
    // The default is that of the space.
    document
        .set_value("check.acceleration", Given::Text(""))
        .unwrap();
    let usual = document.number_of("check.acceleration").unwrap();
    assert_eq!(usual, Some(500.0));
    document
        .set_value("check.speed", Given::Text("off"))
        .unwrap();
    assert_eq!(document.property("check.speed").unwrap(), "off");
}

/// By the property's name, and nothing changes.
#[test]
fn values_of_another_type_are_refused() {
    let mut document = flight();
    for (name, given, reason) in [
        (
            "point.2.zoom",
            Given::Flag(true),
            "expected a number, found true or false",
        ),
        (
            "point.2.zoom",
            Given::Number(f64::NAN),
            "the zoom must lie between",
        ),
        (
            "point.2.hold",
            Given::Number(1.5),
            "expected a whole number",
        ),
        (
            "point.2.hold",
            Given::Number(-1.0),
            "must lie between 0 and 1000000",
        ),
        (
            "point.2.position",
            Given::Numbers(&[0.0; 2]),
            "expected 3 numbers, found 2",
        ),
        (
            "point.2.position",
            Given::Numbers(&[]),
            "expected 3 numbers, found 0",
        ),
        (
            "point.2.distance",
            Given::Numbers(&[0.0; 3]),
            "expected 4 numbers, found 3",
        ),
        (
            "point.2.own",
            Given::Number(0.5),
            "expected an array, found a number",
        ),
        (
            "closed",
            Given::Number(1.0),
            "expected true or false, found a number",
        ),
        ("curve", Given::Text("round"), "must be \"tcb\""),
        (
            "point.2.ease",
            Given::Numbers(&[2.0, 0.0, 0.0, 50.0]),
            "must be \"sine\" or \"parabolic\"",
        ),
        ("check.turning", Given::Number(-1.0), ""),
    ] {
        let after = document.to_toml().unwrap();
        let error = document.set_value(name, given).unwrap_err().to_string();
        assert!(
            error.starts_with(&format!("{name}: ")) && error.contains(reason),
            "{error}"
        );
        assert_eq!(document.to_toml().unwrap(), after);
    }
    let error = document
        .set_value("check.boredom", Given::Number(1.0))
        .unwrap_err();
    assert_eq!(error.kind(), ErrorKind::Range);
    let error = document.number_of("title").unwrap_err();
    assert_eq!(error.to_string(), "title: expected a text, found a number");
}

/// A scene has what its file has besides paths.
#[test]
fn scenes_have_properties() {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/car.vid");
    let mut scene = SceneDocument::load(file.as_ref()).unwrap();
    for (name, given) in [
        ("title", Given::Text("A car")),
        ("fps", Given::Number(50.0)),
        ("first_frame", Given::Number(1001.0)),
        ("check.zoom", Given::Number(5.0)),
        ("node.sun.intensity", Given::Number(3.0)),
        ("node.sun.colour", Given::Numbers(&[1.0, 0.5, 0.25])),
        ("node.sun.visible", Given::Flag(false)),
    ] {
        scene.set_value(name, given).unwrap();
    }
    let again = SceneDocument::from_toml(&scene.to_toml().unwrap()).unwrap();
    assert_eq!(again.text_of("title").unwrap(), "A car");
    assert_eq!(again.number_of("fps").unwrap(), Some(50.0));
    assert_eq!(again.number_of("first_frame").unwrap(), Some(1001.0));
    assert_eq!(again.number_of("check.zoom").unwrap(), Some(5.0));
    assert_eq!(again.number_of("node.sun.intensity").unwrap(), Some(3.0));
    assert_eq!(
        again.numbers_of("node.sun.colour").unwrap(),
        [1.0, 0.5, 0.25]
    );
    assert!(!again.flag_of("node.sun.visible").unwrap());
    for (name, given, reason) in [
        ("fps", Given::Number(0.0), "fps: "),
        (
            "node.sun.intensity",
            Given::Number(-1.0),
            "node.sun.intensity: ",
        ),
        ("node.moon.intensity", Given::Number(1.0), "moon"),
        (
            "closed",
            Given::Flag(true),
            "known here: title, comment, fps, first_frame, space.NAME, check.NAME",
        ),
        ("point.1.zoom", Given::Number(30.0), "there is no property"),
    ] {
        let before = scene.to_toml().unwrap();
        let error = scene.set_value(name, given).unwrap_err().to_string();
        assert!(error.contains(reason), "{error}");
        assert_eq!(scene.to_toml().unwrap(), before);
    }
}
