//! `.vid` files: what is refused, with which sentence; what comes back.

use std::path::{Path, PathBuf};

use vides::document::{Document, Edit};
use vides::path::{Pace, PaceSource};
use vides::planner::{Request, retime};

/// Every broken file with the whole sentence that refuses it.
const BROKEN: &[(&str, &str)] = &[
    (
        "base_speed_zero",
        "line 3: move_frames: a base speed must be finite and greater than zero",
    ),
    ("binary", "line 2: this is not UTF-8 text"),
    (
        "closed_number",
        "line 2: closed: expected true or false, found a whole number",
    ),
    (
        "coordinate_text",
        "line 4: position: expected a number, found a text",
    ),
    (
        "date",
        "line 2: fps: expected a number, found a date or time",
    ),
    ("duplicate_key", "line 6: duplicate key"),
    (
        "eleven_orientations",
        "line 16: orientation: a point has at most 10 orientations",
    ),
    ("empty", "line 1: a .vid file begins with version = 1"),
    (
        "first_frame_large",
        "line 2: first_frame: must lie between -2147483648 and 2147483647",
    ),
    (
        "fps_zero",
        "line 2: fps: the frames per second must be greater than 0 and at most 100000",
    ),
    (
        "half_size_negative",
        "line 3: half_size: the half size of the space must lie between 1e-30 and 1e30",
    ),
    (
        "hold_fraction",
        "line 7: hold_frames: expected a whole number, found a decimal number",
    ),
    (
        "hold_negative",
        "line 7: hold_frames: must lie between 0 and 1000000",
    ),
    (
        "infinite",
        "line 7: roll_degrees: the number must be finite",
    ),
    (
        "mode",
        "line 2: orientation_mode: must be \"tcb\", \"barry-goldman\" or \"slerp\"",
    ),
    (
        "name_too_long",
        "line 5: name: at most 256 bytes are allowed",
    ),
    (
        "name_with_newline",
        "line 5: name: control characters are not allowed",
    ),
    ("nan", "line 5: position: the number must be finite"),
    (
        "nested_deeply",
        "line 2: cannot recurse further; max recursion depth met",
    ),
    (
        "newer_version",
        "line 1: version: this file is of version 2, newer than this program, which knows up to version 1",
    ),
    (
        "misspelt_position",
        "line 4: unknown key \"positon\"; known here: name, position, preset, own, tangents, keeps_motion, orientation",
    ),
    (
        "nine_speeds",
        "line 7: speed_curve: expected 10 numbers, found 9",
    ),
    (
        "no_point",
        "line 1: a path needs at least two points, each with its [[point]], found 0",
    ),
    ("no_position", "line 3: point: this point has no position"),
    ("no_version", "line 1: a .vid file begins with version = 1"),
    ("not_utf8", "line 2: this is not UTF-8 text"),
    (
        "offset_zero",
        "line 7: offset: the target must not lie on the camera's own position",
    ),
    (
        "one_point",
        "line 4: a path needs at least two points, each with its [[point]], found 1",
    ),
    (
        "orientation_no_array",
        "line 5: orientation: expected an array, found a whole number",
    ),
    ("overflow", "line 7: zoom_mm: the number must be finite"),
    (
        "position_text",
        "line 4: position: expected an array, found a text",
    ),
    (
        "preset_and_own",
        "line 5: preset: a point has either a preset or its own values",
    ),
    (
        "preset_number",
        "line 3: 10: the presets are numbered 0 to 9",
    ),
    ("preset_ten", "line 5: preset: must lie between 0 and 9"),
    (
        "space_far",
        "line 2: space: the centre of the space must lie within 1e9 half edges of the world's origin",
    ),
    (
        "space_origin",
        "line 3: origin: a space is given by centre and half_size, and all numbers are the world's",
    ),
    (
        "space_scale",
        "line 3: scale: a space is given by centre and half_size, and all numbers are the world's",
    ),
    (
        "space_too_small_for_its_points",
        "line 3: position: a coordinate must lie within 1e9 half edges of the space's centre",
    ),
    ("space_up", "line 3: up: must be \"y\" or \"z\""),
    (
        "speed_too_fast",
        "line 7: speed_curve: each value of a speed curve must lie between 1 and 100",
    ),
    ("syntax", "line 2: invalid basic string, expected `\"`"),
    (
        "target_and_offset",
        "line 8: target: an orientation has either a target or an offset",
    ),
    (
        "target_on_position",
        "line 8: target: the target must not lie on the camera's own position",
    ),
    (
        "tension_large",
        "line 5: tension: the tension must lie between -1 and 1",
    ),
    (
        "too_far",
        "line 7: target: a coordinate must not exceed 1e9",
    ),
    (
        "two_coordinates",
        "line 4: position: expected 3 numbers, found 2",
    ),
    ("unclosed_array", "line 4: unclosed array, expected `]`"),
    (
        "unknown_object_key",
        "line 3: unknown key \"edges\"; known here: polylines, points, colours, lines, triangles, file, bytes, \
         checksum, part",
    ),
    (
        "unknown_orientation_key",
        "line 7: unknown key \"rol_degrees\"; known here: target, offset, roll_degrees, zoom_mm, turning, hold_frames, speed_curve, ahead, up, up_point, up_path, frames, locked, curve_time, ease, distance, pace_part, velocity_degrees, turning_part, roll_slope_degrees, zoom_slope_mm",
    ),
    (
        "unknown_point_key",
        "line 5: unknown key \"presset\"; known here: name, position, preset, own, tangents, keeps_motion, orientation",
    ),
    (
        "unknown_root_key",
        "line 2: unknown key \"titel\"; known here: version, title, comment, fps, first_frame, closed, curve, \
         orientation_mode, zoom_mode, base_speeds, presets, space, check, object, point, camera, range, \
         marker, node",
    ),
    (
        "unknown_space_key",
        "line 3: unknown key \"factor\"; known here: centre, half_size, unit, up",
    ),
    (
        "unknown_speed_key",
        "line 3: unknown key \"move\"; known here: move_frames, turn_frames, zoom_frames, roll_frames",
    ),
    (
        "unknown_turning_key",
        "line 7: unknown key \"tention\"; known here: tension, continuity, bias",
    ),
    (
        "version_as_text",
        "line 1: version: expected a whole number, found a text",
    ),
    ("version_zero", "line 1: version: there is no such version"),
    (
        "zero_byte",
        "line 2: invalid basic string, expected non-double-quote visible characters, `\\`",
    ),
    (
        "zoom_mode",
        "line 2: zoom_mode: must be \"smooth\" or \"linear\"",
    ),
    (
        "zoom_zero",
        "line 8: zoom_mm: the zoom must lie between 1 and 2000",
    ),
];

fn corpus() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/corpus")
}

#[test]
fn broken_files_are_refused_with_line_and_reason() {
    let mut names: Vec<String> = std::fs::read_dir(corpus())
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "vid"))
        .map(|path| path.file_stem().unwrap().to_str().unwrap().to_owned())
        .collect();
    names.sort();
    let mut wrong = Vec::new();
    for name in &names {
        let file = corpus().join(format!("{name}.vid"));
        let found = match Document::load(&file) {
            Ok(_) => "no error".to_owned(),
            Err(error) => error.to_string(),
        };
        // The file's name stands first; the table leaves it out.
        let found = found
            .strip_prefix(&format!("{}: ", file.display()))
            .map_or_else(|| format!("without its name: {found}"), str::to_owned);
        if !BROKEN.contains(&(name.as_str(), found.as_str())) {
            wrong.push(format!("    ({name:?}, {found:?}),"));
        }
    }
    assert!(wrong.is_empty(), "not in the table:\n{}", wrong.join("\n"));
    assert_eq!(names.len(), BROKEN.len(), "a file of the table is missing");
}

const TWO_POINTS: &str = "
[[point]]
position = [-0.6, 0.2, 0.8]

[[point]]
position = [0.6, 0.2, 0.8]
";

fn parse(text: &str) -> Result<Document, String> {
    Document::from_toml(text).map_err(|error| error.to_string())
}

/// Everything of a document; `{:?}` tells 0 from −0 and gives every digit.
fn content(document: &Document) -> String {
    format!("{:?} {:?}", document.path(), document.info())
}

#[test]
fn the_shortest_file_is_the_path_of_a_new_window() {
    let document = parse(&format!("version = 1\n{TWO_POINTS}")).unwrap();
    assert_eq!(content(&document), content(&Document::new()));
}

#[test]
fn numbers_may_be_written_as_people_do() {
    let text = "version = 1
fps = 0x18
[[point]]
position = [0, 1_000, +0.5]
preset = 0x3
own-less-comment-is-no-key = 1
"
    .replace("own-less-comment-is-no-key = 1\n", "# a comment\n");
    let document = parse(&format!("{text}{TWO_POINTS}")).unwrap();
    assert_eq!(document.info().fps, 24.0);
    assert_eq!(
        document.path().points[0].position.to_array(),
        [0.0, 1000.0, 0.5]
    );
    assert_eq!(
        document.path().points[0].curve,
        vides::path::CurveParameters::Preset(3)
    );
}

#[test]
fn windows_line_ends_and_a_byte_order_mark_are_read() {
    let text = format!("\u{feff}version = 1\ntitle = \"t\"\n{TWO_POINTS}").replace('\n', "\r\n");
    assert_eq!(parse(&text).unwrap().info().title, "t");
}

/// Enough points that the file is read in many pieces.
fn long_file(comment: &str) -> String {
    let mut text = format!("version = 1\ncomment = \"\"\"\n{comment}\"\"\"\n");
    for index in 0..20_000 {
        text += &format!("\n[[point]]\nposition = [{index}.5, 0.0, 0.0]\n");
    }
    text
}

#[test]
fn long_files_are_read_like_short_ones() {
    let document = parse(&long_file("")).unwrap();
    assert_eq!(document.path().points.len(), 20_000);
    for (index, point) in document.path().points.iter().enumerate() {
        assert_eq!(point.position.x, index as f64 + 0.5);
    }
    // Errors late in the file keep their line; tables may stand at the end.
    let text = long_file("");
    let lines = text.matches('\n').count();
    assert_eq!(
        parse(&format!("{text}zoom = 3\n")).unwrap_err(),
        format!(
            "line {}: unknown key \"zoom\"; known here: name, position, preset, own, tangents, keeps_motion, orientation",
            lines + 1
        )
    );
    assert_eq!(
        parse(&format!("{text}name = \"\n")).unwrap_err(),
        format!("line {}: invalid basic string, expected `\"`", lines + 1)
    );
    let last = format!("{text}[space]\nhalf_size = 2.0\n");
    assert_eq!(
        parse(&last).unwrap_err(),
        format!(
            "line {}: space: this must stand before the first point or node",
            lines + 1
        )
    );
    let twice = last.replace(
        "\n\n[[point]]\nposition = [0.5,",
        "\n\n[space]\nhalf_size = 1.0\n\n[[point]]\nposition = [0.5,",
    );
    assert_eq!(
        parse(&twice).unwrap_err(),
        format!(
            "line {}: space: this was given further up already",
            lines + 4
        )
    );
}

#[test]
fn a_point_within_a_comment_is_none() {
    // The longest comment, its `[[point]]` lines where a piece would end.
    let line = "[[point]]\nposition = [9.0, 9.0, 9.0]\n";
    let comment = line.repeat(vides::limits::MAX_COMMENT_BYTES / line.len());
    for filler in [0, 40_000, 80_000, 100_000, 120_000, 130_000] {
        let text = long_file(&comment).replacen(
            "comment",
            &format!("#{}\ncomment", "-".repeat(filler)),
            1,
        );
        let document = parse(&text).unwrap();
        assert_eq!(document.path().points.len(), 20_000);
        assert_eq!(document.info().comment, comment);
    }
    // The same with every byte written as six.
    let lines = "[[point]]\n".repeat(100);
    let escapes = "\\u007f".repeat((vides::limits::MAX_COMMENT_BYTES - lines.len() - 2) / 2);
    let text = long_file(&format!("{escapes}\n{lines}{escapes}"));
    assert_eq!(parse(&text).unwrap().path().points.len(), 20_000);
    let filler = format!("#{}\ncomment", "-".repeat(130_000));
    let text = long_file(&format!("\n{lines}{escapes}{escapes}")).replacen("comment", &filler, 1);
    assert_eq!(parse(&text).unwrap().path().points.len(), 20_000);
    // Unfinished, it is an error however long the file.
    let text = long_file(&comment).replacen("\"\"\"\n\n[[point]]", "\n[[point]]", 1);
    assert!(parse(&text).unwrap_err().contains("string"));
}

#[test]
fn limits_are_told_with_their_line() {
    let mut text = "version = 1\n".to_owned();
    for _ in 0..=vides::limits::MAX_POINTS {
        text += "[[point]]\nposition = [0, 0, 0]\n";
    }
    let line = 2 + 2 * vides::limits::MAX_POINTS;
    assert_eq!(
        parse(&text).unwrap_err(),
        format!("line {line}: point: a path has at most 100000 support points")
    );
    let comment = "c".repeat(vides::limits::MAX_COMMENT_BYTES + 1);
    assert_eq!(
        parse(&format!(
            "version = 1\ncomment = \"{comment}\"\n{TWO_POINTS}"
        ))
        .unwrap_err(),
        "line 2: comment: the comment has at most 65536 bytes"
    );
}

#[test]
fn what_is_no_file_is_refused_and_never_waits() {
    let folder = tempfile::tempdir().unwrap();
    let load = |path: &Path| Document::load(path).unwrap_err().to_string();
    assert_eq!(
        load(folder.path()),
        format!(
            "{}: this is a directory, not a file",
            folder.path().display()
        )
    );
    let pipe = folder.path().join("pipe");
    assert!(
        std::process::Command::new("mkfifo")
            .arg(&pipe)
            .status()
            .unwrap()
            .success()
    );
    assert_eq!(
        load(&pipe),
        format!("{}: this is not a regular file", pipe.display())
    );
    assert_eq!(
        load(Path::new("/dev/zero")),
        "/dev/zero: this is not a regular file"
    );
    let missing = folder.path().join("missing.vid");
    assert_eq!(
        load(&missing),
        format!("{}: No such file or directory", missing.display())
    );
    let large = folder.path().join("large.vid");
    std::fs::File::create(&large)
        .unwrap()
        .set_len(vides::limits::MAX_FILE_BYTES + 1)
        .unwrap();
    assert_eq!(
        load(&large),
        format!(
            "{}: the file is larger than the 972 MiB that are read",
            large.display()
        )
    );
    let endless = Document::load_from(&mut std::io::repeat(b'#'), "-").unwrap_err();
    assert_eq!(
        endless.to_string(),
        "-: the file is larger than the 972 MiB that are read"
    );
}

/// The file that the module's own description shows.
fn example() -> String {
    let description = include_str!("../crates/document/src/vid/mod.rs");
    let example = description.split("//! ```toml\n").nth(1).unwrap();
    let example = example.split("//! ```").next().unwrap();
    let lines = example.lines().map(|line| line.trim_start_matches("//!"));
    lines.collect::<Vec<_>>().join("\n")
}

proptest::proptest! {
    #![proptest_config(proptest::prelude::ProptestConfig {
        cases: 3_000,
        failure_persistence: None,
        ..Default::default()
    })]

    /// Files with a few characters changed are refused in a sentence with a
    /// line, or read and then saved and read again to the same document.
    #[test]
    fn damaged_files_never_do_harm(
        damages in proptest::collection::vec(
            (proptest::prelude::any::<usize>(), 0..3_u8, proptest::prelude::any::<u8>()),
            1..6,
        ),
    ) {
        let mut bytes = example().into_bytes();
        for (at, kind, byte) in damages {
            let at = at % bytes.len();
            match kind {
                0 => bytes[at] = byte,
                1 => drop(bytes.remove(at)),
                _ => {
                    let signs = b"[]{}\"'=,.\n#e-+01_nai ";
                    bytes.insert(at, signs[usize::from(byte) % signs.len()]);
                }
            }
        }
        match Document::load_from(&mut bytes.as_slice(), "damaged") {
            Err(error) => {
                let error = error.to_string();
                proptest::prop_assert!(error.starts_with("damaged: line "), "{error}");
                proptest::prop_assert!(!error.contains('\n'), "{error}");
            }
            Ok(document) => {
                let again = Document::from_toml(&document.to_toml().unwrap()).unwrap();
                proptest::prop_assert_eq!(content(&again), content(&document));
            }
        }
    }
}

#[test]
fn the_example_is_read() {
    let document = parse(&example()).unwrap();
    let points = &document.path().points;
    assert_eq!(points.len(), 2);
    let (start, end) = (&points[0], &points[1]);
    assert_eq!(start.name.as_deref(), Some("start"));
    assert_eq!(start.orientations[0].roll, 15.0);
    assert_eq!(end.orientations[0].hold, 12);
    assert_eq!(end.orientations[0].speeds[1], 20.0);
}

/// A computed pace comes back from a file as it was, to the last bit.
#[test]
fn a_computed_pace_comes_back() {
    let mut document = Document::new();
    let limits = document.info().limits;
    let request = Request {
        limits,
        fps: 29.97,
        points: None,
        seconds: 7.0,
    };
    let made = retime(document.path(), &request, &mut |_, _| true).unwrap();
    document
        .apply(Edit::ReplacePath(Box::new(made.path)))
        .unwrap();
    let text = document.to_toml().unwrap();
    let again = Document::from_toml(&text).unwrap();
    let [before, after] = [&document, &again].map(bits);
    assert!(before.len() >= 6, "{text}");
    assert_eq!(before, after);
    assert_eq!(document.path(), again.path());
}

/// The numbers of all computed paces.
fn bits(document: &Document) -> Vec<u64> {
    let points = document.path().points.iter();
    let orientations = points.flat_map(|point| &point.orientations);
    let tracks = orientations.filter_map(|one| match &one.own.pace {
        Pace::Part(part) => match &part.of {
            PaceSource::Track(keys) => Some(keys.clone()),
            _ => None,
        },
        _ => None,
    });
    tracks
        .flat_map(|keys| keys.as_flattened().to_vec())
        .map(f64::to_bits)
        .collect()
}
