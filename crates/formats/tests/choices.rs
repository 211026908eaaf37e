//! What was chosen holds in every format, and what a format leaves out is told by it.

use std::path::{Path, PathBuf};

use glam::DVec3;
use vides_document::SceneDocument;
use vides_formats::{Error, Format, Loss, Options, Report, Source, export, export_to};
use vides_formats::{Imported, Result, by_name, formats, import};

fn example(name: &str) -> SceneDocument {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples");
    let text = std::fs::read_to_string(folder.join(name)).unwrap();
    SceneDocument::from_toml_in(&text, &folder).unwrap()
}

fn options(lines: &str) -> Options {
    Options::parse(lines).unwrap()
}

/// What is written with these options, and what is told of it.
fn written(document: &SceneDocument, format: &str, lines: &str) -> (String, Report) {
    let mut out = Vec::new();
    let format = by_name(format).unwrap();
    let report = export_to(document, &mut out, format, &options(lines), &mut |_, _| {}).unwrap();
    (String::from_utf8(out).unwrap(), report)
}

fn taken(format: &str, text: &str, lines: &str) -> Result<Imported> {
    let source = Source::of_bytes("flight", text.into());
    import(&source, Some(by_name(format).unwrap()), &options(lines))
}

/// The numbers of each line that begins with one.
fn rows(text: &str) -> Vec<Vec<f64>> {
    let numbers = |line: &str| {
        let words = line.split([',', ' ', '\t']);
        words.map(|word| word.parse().ok()).collect::<Option<_>>()
    };
    text.lines().filter_map(numbers).collect()
}

/// Other programs count the frames of a file at its own rate, and some take whole numbers only.
#[test]
fn frames_of_channels_are_counted_at_the_rate_that_is_written() {
    let document = example("pyramid.vid");
    let (text, _) = written(&document, "chan", "fps=50\nframes=3..6");
    let frames: Vec<f64> = rows(&text).iter().map(|row| row[0]).collect();
    assert_eq!(frames, [3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0]);
    let back = taken("chan", &text, "fps=50\nas=keys").unwrap().document;
    assert_eq!(back.scene.frame_range(), (1.0, 8.0));
    assert_eq!(back.info.first_frame, 3);
}

/// However slow, the first pose is there.
#[test]
fn the_slowest_rate_gives_the_first_pose() {
    let document = example("pyramid.vid");
    let first = rows(&written(&document, "csv", "").0)[0].clone();
    let (text, _) = written(&document, "csv", "fps=1e-320");
    assert_eq!(rows(&text), [first]);
}

/// Names of files are the same in either case: a file of the folder stands for it.
#[test]
fn a_file_of_a_folder_stands_for_it_in_either_case() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("IMAGES.TXT");
    let format = vides_formats::by_target(&file).unwrap();
    assert_eq!(format.name, "colmap");
    let document = example("pyramid.vid");
    export(
        &document,
        &file,
        format,
        &Options::default(),
        &mut |_, _| {},
    )
    .unwrap();
    assert!(folder.path().join("images.txt").is_file());
}

/// Nodes that have no poses are written as matrices: turned upright and scaled like poses.
#[test]
fn matrices_are_turned_and_scaled_as_poses_are() {
    let document = example("car.vid");
    for format in ["ascii", "csv", "json"] {
        let numbers = |lines: &str| -> Vec<Vec<f64>> {
            let text = written(&document, format, lines).0;
            if format != "json" {
                let skip = usize::from(format == "csv");
                let whole = |row: Vec<f64>| row[skip..skip + 16].to_vec();
                // `visible` of CSV is a number too.
                return rows(&text).into_iter().map(whole).collect();
            }
            let json: serde_json::Value = serde_json::from_str(&text).unwrap();
            let states = json["states"].as_array().unwrap().iter();
            states
                .map(|state| serde_json::from_value(state["matrix"].clone()).unwrap())
                .collect()
        };
        let plain = numbers("node=car\ndigits=17");
        let turned = numbers("node=car\ndigits=17\nup=z\nscale=10");
        assert_eq!(plain.len(), turned.len());
        for (from, to) in plain.iter().zip(&turned) {
            for (column, scale) in [(0, 1.0), (4, 1.0), (8, 1.0), (12, 10.0)] {
                let [x, y, z] = [0, 1, 2].map(|row| from[column + row]);
                let wanted = scale * DVec3::new(x, -z, y);
                let found = DVec3::from_slice(&to[column..]);
                assert!(wanted.distance(found) < 1e-12, "{format}: {wanted} {found}");
            }
        }
        assert!(plain.iter().any(|matrix| matrix[12..15] != [0.0; 3]));
    }
}

/// Title, comment and unit come back; an axis that is not known is refused, not passed over.
#[test]
fn json_keeps_what_belongs_to_the_document() {
    let mut document = example("pyramid.vid");
    document.info.unit = "cm".into();
    document.info.comment = "two\nlines".into();
    let (text, _) = written(&document, "json", "up=z");
    let back = taken("json", &text, "as=keys").unwrap().document;
    assert_eq!(back.info.unit, "cm");
    assert_eq!(back.info.comment, "two\nlines");
    assert_eq!(back.info.title, document.info.title);
    assert_eq!(back.scene.space().up, vides_engine::path::Up::Z);
    let error = taken("json", &text.replace("\"up\": \"z\"", "\"up\": \"x\""), "");
    assert_eq!(
        error.unwrap_err().to_string(),
        "flight: space.up: x is not read"
    );
}

/// A matrix has no place for what hides its node, nor a pose.
#[test]
fn states_that_are_not_seen_are_told() {
    let state = |visible: bool| {
        format!("{{\"matrix\": [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1], \"visible\": {visible}}}")
    };
    let text = format!("{{\"states\": [{}, {}]}}", state(true), state(false));
    let told = taken("json", &text, "as=keys").unwrap().report;
    let hidden = Loss::NotTaken {
        what: "visible".into(),
        count: 1,
    };
    assert_eq!(told.losses(), [Loss::FieldOfView, hidden]);
}

/// Frames of some lines alone would be dropped.
#[test]
fn lines_have_as_many_numbers_as_the_first() {
    let pose = "0 0 0 0 0 -1 0 1 0 24";
    for (first, second, said) in [
        (
            pose.to_owned(),
            format!("2 {pose}"),
            "line 2: expected 10 numbers, found 11",
        ),
        (
            format!("1 {pose}"),
            pose.to_owned(),
            "line 2: expected 11 numbers, found 10",
        ),
        (
            format!("1 {pose} 0"),
            format!("2 {pose}"),
            "line 2: expected 12 numbers, found 11",
        ),
    ] {
        let error = taken("ascii", &format!("{first}\n{second}\n"), "").unwrap_err();
        assert_eq!(error.to_string(), format!("flight: {said}"));
    }
}

/// Lines of one camera tell of the others; of a path alone there is nothing to tell.
#[test]
fn lines_of_a_scene_tell_what_else_is_in_it() {
    let car = example("car.vid");
    for format in ["ascii", "csv", "json"] {
        let losses = written(&car, format, "").1;
        let nodes = |loss: &Loss| matches!(loss, Loss::OtherNodes(_));
        assert!(losses.losses().iter().any(nodes), "{format}");
        let alone = written(&example("pyramid.vid"), format, "").1;
        assert_eq!(alone.losses(), [], "{format}");
    }
}

fn writing() -> impl Iterator<Item = &'static Format> {
    let all = formats().iter().copied();
    all.filter(|format| format.writes() && format.name != "vid")
}

/// Where a format is written to in a folder.
fn target(folder: &Path, format: &Format) -> PathBuf {
    match (format.file_names, format.endings) {
        ([name, ..], _) => folder.join(name),
        (_, [ending, ..]) => folder.join(format!("{}.{ending}", format.name)),
        _ => folder.join(format.name),
    }
}

/// A camera that turns on one spot: its positions have no diagonal.
#[test]
fn a_camera_on_one_spot_is_fitted() {
    let pose = |at: u32| {
        let half = 0.1 * f64::from(at);
        format!("{at} 1 2 3 0 {} 0 {}\n", half.sin(), half.cos())
    };
    let text: String = (0..9).map(pose).collect();
    let read = taken("tum", &text, "fps=1").unwrap();
    assert_eq!(read.document.scene.frame_range(), (1.0, 9.0));
    let fitted = |loss: &Loss| matches!(loss, Loss::Fitted { turned, .. } if *turned < 0.5);
    assert!(read.report.losses().iter().any(fitted));
}

/// One frame is a flight.
#[test]
fn a_flight_of_one_frame_goes_out_and_comes_in() {
    let folder = tempfile::tempdir().unwrap();
    for name in ["pyramid.vid", "car.vid"] {
        let document = example(name);
        for format in writing() {
            let file = target(folder.path(), format);
            let one = options("frames=2..2");
            export(&document, &file, format, &one, &mut |_, _| {}).unwrap();
            if !format.reads() {
                continue;
            }
            for kind in ["path", "keys"] {
                let choice = options(&format!("as={kind}"));
                let read = import(&Source::open(&file).unwrap(), Some(format), &choice);
                let read = match read {
                    Err(error) if kind == "path" => {
                        let said = error.to_string();
                        assert!(said.ends_with("a fit needs at least two poses"), "{said}");
                        continue;
                    }
                    read => read.unwrap(),
                };
                let range = read.document.scene.frame_range();
                assert_eq!(range.0, range.1, "{name} {} {kind}", format.name);
            }
        }
    }
}

/// A node that is no camera is written or refused by its name, whatever the format.
#[test]
fn other_nodes_are_written_or_refused_by_name() {
    let document = example("car.vid");
    let folder = tempfile::tempdir().unwrap();
    let mut refused = Vec::new();
    for node in document.scene.nodes() {
        for format in writing() {
            let file = target(folder.path(), format);
            let choice = options(&format!("node={}", node.name));
            match export(&document, &file, format, &choice, &mut |_, _| {}) {
                Ok(_) => {}
                Err(Error::NoCamera(name)) => {
                    assert_eq!(name.to_string(), node.name);
                    refused.push(format.name);
                }
                Err(other) => panic!("{} {}: {other}", node.name, format.name),
            }
        }
    }
    assert!(refused.contains(&"tum") && refused.contains(&"html"));
    assert!(!refused.contains(&"csv") && !refused.contains(&"usda"));
}

/// What any format writes is told by its content alone; only two share theirs.
#[test]
fn content_is_recognised_by_its_own_format_alone() {
    let folder = tempfile::tempdir().unwrap();
    for name in ["pyramid.vid", "car.vid"] {
        let document = example(name);
        for format in formats().iter().filter(|format| format.writes()) {
            let file = target(folder.path(), format);
            export(
                &document,
                &file,
                format,
                &Options::default(),
                &mut |_, _| {},
            )
            .unwrap();
            let source = Source::open(&file).unwrap();
            let found: Vec<_> = formats()
                .iter()
                .filter(|format| format.reads() && (format.recognises)(&source))
                .map(|format| format.name)
                .collect();
            let own = format.name;
            match own {
                // They differ in the axes of the camera only.
                "osg" => assert_eq!(found, ["tum", "osg"]),
                _ if !format.reads() => assert!(found.is_empty(), "{own}: {found:?}"),
                _ => assert_eq!(found, [own], "{own} of {name}"),
            }
        }
    }
}
