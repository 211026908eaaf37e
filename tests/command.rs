//! The command `vides` as a shell sees it: what it writes where, its exit statuses.

use std::collections::BTreeSet;
use std::fs;
use std::io::{BufRead, BufReader, Read, Write};
use std::path::Path;
use std::process::{Command, Output, Stdio};

#[path = "command/check_and_plot.rs"]
mod check_and_plot;
#[path = "command/convert.rs"]
mod convert;
#[path = "command/files.rs"]
mod files;
#[path = "command/planner.rs"]
mod planner;
#[path = "command/properties.rs"]
mod properties;
#[path = "command/sample.rs"]
mod sample;
#[path = "command/tools.rs"]
mod tools;

use vides::document::Document;
use vides::path::Pose;

const PYRAMID: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/pyramid.vid");

/// A short path in metres, z upright, and frames counted from 101.
const IN_A_WORLD: &str = "\
version = 1
first_frame = 101
base_speeds = { move_frames = 10.0 }
space = { half_size = 20.0, centre = [100.0, 0.0, -5.0], unit = \"m\", up = \"z\" }
[[point]]
position = [90.0, 5.0, -5.0]
[[point]]
position = [110.0, 5.0, -5.0]
";

/// A move of length 1; a turn of 180 degrees; a roll of 90 degrees; a zoom
/// from 1 to 100: each as long as its base speed says.
const ONE_OF_EACH: &str = "\
version = 1
base_speeds = { move_frames = 7.0, turn_frames = 5.0, zoom_frames = 3.0, roll_frames = 2.0 }
[[point]]
position = [0.0, 0.0, 0.0]
[[point.orientation]]
offset = [0.0, 0.0, -1.0]
zoom_mm = 1.0
[[point]]
position = [0.0, 0.0, 1.0]
[[point.orientation]]
offset = [0.0, 0.0, -1.0]
zoom_mm = 1.0
[[point.orientation]]
offset = [0.0, 0.0, 1.0]
zoom_mm = 1.0
[[point.orientation]]
offset = [0.0, 0.0, 1.0]
roll_degrees = 90.0
zoom_mm = 1.0
[[point.orientation]]
offset = [0.0, 0.0, 1.0]
roll_degrees = 90.0
zoom_mm = 100.0
";

fn vides(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_vides"));
    command.args(arguments).stdin(Stdio::null());
    command
}

/// Runs it to its end.
fn run(arguments: &[&str]) -> Output {
    vides(arguments).output().unwrap()
}

/// Runs it with something on standard input.
fn run_with_input(arguments: &[&str], input: &[u8]) -> Output {
    let mut command = vides(arguments);
    command
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped());
    let mut child = command.spawn().unwrap();
    // Little enough to fit into the pipe.
    child.stdin.take().unwrap().write_all(input).unwrap();
    child.wait_with_output().unwrap()
}

/// What a run that must succeed wrote; it has nothing to complain about.
fn said(output: &Output) -> String {
    let complaints = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{}: {complaints}", output.status);
    assert_eq!(complaints, "");
    String::from_utf8(output.stdout.clone()).unwrap()
}

/// The complaint of a run that must fail: one sentence, nothing else written.
fn complaint(output: &Output, status: i32) -> String {
    let complaint = String::from_utf8(output.stderr.clone()).unwrap();
    assert_eq!(output.status.code(), Some(status), "{complaint}");
    assert!(complaint.starts_with("vides: "), "{complaint}");
    assert!(complaint.ends_with('\n'), "{complaint}");
    assert_eq!(output.stdout, b"");
    complaint
}

/// The same where the sentence stands on a line of its own.
fn sentence(output: &Output, status: i32) -> String {
    let complaint = complaint(output, status);
    assert_eq!(complaint.lines().count(), 1, "{complaint}");
    complaint
}

fn poses_of(file: &str) -> Vec<Pose> {
    let document = Document::load(Path::new(file)).unwrap();
    let sampler = document.sampler().unwrap();
    let mut poses = vec![Pose::default(); sampler.frame_count()];
    sampler.sample(1, &mut poses).unwrap();
    poses
}

fn numbers(pose: &Pose) -> Vec<f64> {
    [pose.vrp, pose.vpn, pose.vup]
        .into_iter()
        .flatten()
        .chain([pose.zoom])
        .collect()
}

fn parsed(fields: std::str::Split<'_, char>) -> Vec<f64> {
    fields.map(|field| field.parse().unwrap()).collect()
}

// ---- What goes wrong -------------------------------------------------------------

#[test]
fn broken_files_are_named_with_line_and_reason() {
    let corpus = |name: &str| format!("{}/tests/corpus/{name}.vid", env!("CARGO_MANIFEST_DIR"));
    for (name, line, reason) in [
        ("zoom_zero", 8, "the zoom must lie between 1 and 2000"),
        ("preset_ten", 5, "9"),
        ("unknown_point_key", 5, "preset"),
    ] {
        let file = corpus(name);
        for command in ["sample", "info"] {
            let sentence = sentence(&run(&[command, &file]), 1);
            let place = format!("vides: {file}: line {line}");
            assert!(sentence.starts_with(&place), "{sentence}");
            assert!(sentence.contains(reason), "{sentence}");
        }
    }
    for entry in fs::read_dir(corpus("").trim_end_matches("/.vid")).unwrap() {
        let file = entry.unwrap().path();
        let sentence = sentence(&run(&["info", file.to_str().unwrap()]), 1);
        assert!(sentence.contains(file.to_str().unwrap()), "{sentence}");
    }
}

#[test]
fn what_a_file_says_cannot_steer_the_terminal() {
    let broken = run_with_input(&["info", "-"], b"version = 1\n\"fp\\u001b[2Js\\n\" = 3\n");
    assert!(!sentence(&broken, 1).contains('\u{1b}'));
    let comment = "version = 1\ncomment = \"a\\u001b[2Jb\"\n[[point]]\nposition = [0.0, 0.0, 0.0]\n[[point]]\nposition = [1.0, 0.0, 0.0]\n";
    let text = said(&run_with_input(&["info", "-"], comment.as_bytes()));
    assert!(text.contains("a\u{fffd}[2Jb"), "{text}");
}

#[test]
fn files_that_are_not_there_are_named() {
    let sentence_of = |arguments: &[&str]| sentence(&run(arguments), 1);
    assert_eq!(
        sentence_of(&["info", "/no/such.vid"]),
        "vides: /no/such.vid: No such file or directory\n"
    );
    assert_eq!(
        sentence_of(&["sample", PYRAMID, "-o", "/no/such/out.txt"]),
        "vides: /no/such/out.txt: No such file or directory\n"
    );
    assert_eq!(
        sentence_of(&["sample", "/tmp"]),
        "vides: /tmp: this is a directory, not a file\n"
    );
    assert_eq!(
        sentence_of(&["sample", PYRAMID, "-o", "/dev/full"]),
        "vides: /dev/full: No space left on device\n"
    );
}

#[test]
fn a_full_standard_output_is_told() {
    for arguments in [&["sample", PYRAMID][..], &["info", PYRAMID], &["--help"]] {
        let full = fs::OpenOptions::new()
            .write(true)
            .open("/dev/full")
            .unwrap();
        let output = vides(arguments).stdout(full).output().unwrap();
        assert_eq!(
            sentence(&output, 1),
            "vides: standard output: No space left on device\n"
        );
    }
}

#[test]
fn too_many_frames_are_refused_before_anything_is_written() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("out.txt");
    let out = file.to_str().unwrap();
    let output = run(&["sample", PYRAMID, "-o", out, "--move-frames", "1e300"]);
    let sentence = sentence(&output, 1);
    assert!(
        sentence.contains(PYRAMID) && sentence.contains("frames"),
        "{sentence}"
    );
    assert!(!file.exists());
}

#[test]
fn bad_usage_is_told() {
    let bad: [&[&str]; 12] = [
        &["sample"],
        &["info"],
        &["dance"],
        &["sample", PYRAMID, "--format", "xml"],
        &["sample", PYRAMID, "--frames", "3"],
        &["sample", PYRAMID, "another.vid"],
        &["sample", PYRAMID, "--move-frames"],
        &["sample", PYRAMID, "--move-frames", "fast"],
        &["sample", PYRAMID, "--move-frames", "0"],
        &["sample", PYRAMID, "--turn-frames", "-5"],
        &["sample", PYRAMID, "--zoom-frames", "nan"],
        &["sample", PYRAMID, "--roll-frames", "inf"],
    ];
    for arguments in bad {
        complaint(&run(arguments), 2);
    }
    let nothing = run(&[]);
    assert_eq!(nothing.status.code(), Some(2));
    assert!(
        String::from_utf8(nothing.stderr)
            .unwrap()
            .contains("Usage: vides")
    );
}

// ---- vides info --------------------------------------------------------------------

#[test]
fn info_accounts_for_every_frame() {
    let text = said(&run(&["info", PYRAMID]));
    let frames = poses_of(PYRAMID).len();
    let entry = |name: &str| {
        let line = text.lines().find(|line| line.starts_with(name));
        line.unwrap()[name.len()..].trim().to_owned()
    };
    assert!(text.starts_with("Around the pyramid\n"));
    assert_eq!(entry("File"), PYRAMID);
    assert_eq!(entry("Path"), "open, 6 points");
    assert_eq!(entry("Frames"), format!("{frames}, numbered 1 to {frames}"));
    let seconds = frames as f64 / 25.0;
    assert_eq!(
        entry("Time"),
        format!("{seconds:.2} s at 25 frames per second")
    );

    let (_, sections) = text.split_once("\nSections\n").unwrap();
    // First and last frame of each row, from the right: the rows follow one
    // another without a gap, and begin after the first pose.
    let mut next = 2;
    for row in sections.lines().skip(1) {
        let mut cells = row.split_whitespace().rev().skip(1);
        let mut number = || cells.next().unwrap().parse::<usize>().unwrap();
        let (last, first, count) = (number(), number(), number());
        assert_eq!((first, last), (next, next + count - 1), "{row}");
        next = last + 1;
    }
    assert_eq!(next - 1, frames);
    assert_eq!(
        sections
            .lines()
            .filter(|row| row.contains("position"))
            .count(),
        5
    );
    assert_eq!(
        sections.lines().filter(|row| row.contains("view")).count(),
        3
    );
    assert_eq!(
        sections.lines().filter(|row| row.contains("rest")).count(),
        2
    );
}

#[test]
fn info_says_what_changes_and_by_how_much() {
    let text = said(&run_with_input(&["info", "-"], ONE_OF_EACH.as_bytes()));
    let (_, sections) = text.split_once("\nSections\n").unwrap();
    let rows: Vec<Vec<&str>> = sections
        .lines()
        .skip(1)
        .map(|row| row.split_whitespace().collect())
        .collect();
    let expected = [
        "1 1 2.1 position 1.0000 7 2 8 0.28",
        "2 2.1 2.2 view 180.00 degrees 5 9 13 0.20",
        "3 2.2 2.3 roll 90.00 degrees 2 14 15 0.08",
        "4 2.3 2.4 zoom 99.00 mm 3 16 18 0.12",
    ];
    let expected: Vec<Vec<&str>> = expected.map(|row| row.split(' ').collect()).to_vec();
    assert_eq!(rows, expected);
    // The film's own numbers, and the world.
    let text = said(&run_with_input(&["info", "-"], IN_A_WORLD.as_bytes()));
    assert!(text.contains("11, numbered 101 to 111\n"), "{text}");
    assert!(
        text.contains("(100.0, 0.0, -5.0) ± 20.0 m, z up\n"),
        "{text}"
    );
}

// ---- Help and version ------------------------------------------------------------

#[test]
fn version_and_help_go_to_standard_output() {
    let version = format!("vides {}\n", env!("CARGO_PKG_VERSION"));
    assert_eq!(said(&run(&["--version"])), version);
    assert_eq!(said(&run(&["-V"])), version);
    for arguments in [
        &["--help"][..],
        &["-h"],
        &["sample", "--help"],
        &["info", "-h"],
    ] {
        let help = said(&run(arguments));
        assert!(help.contains("Usage: vides"), "{help}");
        assert!(
            help.lines().all(|line| line.chars().count() <= 80),
            "{help}"
        );
    }
    let help = said(&run(&["--help"]));
    let headings = [
        "Make a path:",
        "Change a path:",
        "Time:",
        "Look and check:",
        "Convert:",
    ];
    let places = headings.map(|heading| help.find(heading).expect(heading));
    assert!(places.is_sorted(), "{help}");
    // Each subcommand once, with an example of its own in its help.
    let rows = help.lines().filter_map(|line| line.strip_prefix("  "));
    let rows = rows.filter(|row| !row.starts_with(' '));
    let names = rows.filter_map(|row| row.split_whitespace().next());
    let names: Vec<_> = names.filter(|name| !name.starts_with('-')).collect();
    assert_eq!(names.len(), 38, "{names:?}");
    for name in names {
        let help = said(&run(&[name, "--help"]));
        assert_eq!(
            help.matches(&format!("Example: vides {name} ")).count(),
            1,
            "{help}"
        );
        assert!(
            help.lines().all(|line| line.chars().count() <= 80),
            "{help}"
        );
    }
}

/// `vides FILE` opens a path or a mesh: here without a display to open it on.
#[test]
fn a_file_alone_is_one_to_edit() {
    let folder = tempfile::tempdir().unwrap();
    let [mesh, other] = ["mesh.obj", "other.txt"].map(|name| folder.path().join(name));
    fs::write(&mesh, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").unwrap();
    let alone = |arguments: &[&str]| {
        let mut command = vides(arguments);
        command.env("DISPLAY", ":no").output().unwrap()
    };
    let mesh = mesh.to_str().unwrap();
    let wanted = sentence(&alone(&["edit", "--object", mesh]), 1);
    assert!(wanted.contains("display"), "{wanted}");
    for arguments in [&[mesh][..], &["edit", mesh], &[PYRAMID]] {
        assert_eq!(sentence(&alone(arguments), 1), wanted, "{arguments:?}");
    }
    // No file, and no name of one.
    complaint(&alone(&[other.to_str().unwrap()]), 2);
    complaint(&alone(&["tours"]), 2);
    let gone = sentence(&alone(&["gone.obj"]), 1);
    assert!(gone.contains("gone.obj: No such file"), "{gone}");
}
