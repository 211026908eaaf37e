//! Poses written out: ASCII as C prints it, CSV and JSON with every bit.

// C's own printf is asked, and calling it is unsafe.
#![allow(unsafe_code)]

use std::ffi::CStr;
use std::io::Write;

use glam::{DVec3, dvec3};
use vides::Error;
use vides::document::{Document, Edit, Info};
use vides::formats::{self, Options, Progress, by_name};
use vides::path::{BaseFrames, CameraPath, Pose, Space, SupportPoint, Up};

/// What C's printf makes of a number, minus zero excepted, with a point for
/// whatever the locale's decimal sign is.
fn c_prints(x: f64) -> String {
    let mut text = [0; 400];
    // SAFETY: the buffer is as large as snprintf is told, the format takes one
    // double, and snprintf ends the text with a zero.
    let text = unsafe {
        libc::snprintf(text.as_mut_ptr(), text.len(), c"%3.4f".as_ptr(), x);
        CStr::from_ptr(text.as_ptr())
    };
    let text = text.to_str().unwrap().replace(',', ".");
    match text.as_str() {
        "-0.0000" => "0.0000".to_owned(),
        _ => text,
    }
}

/// Pseudo-random numbers in [−1, 1).
fn random() -> impl FnMut() -> f64 {
    let mut state = 3_u64;
    move || {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / 2_f64.powi(52) - 1.0
    }
}

fn document(positions: impl IntoIterator<Item = DVec3>, info: Info) -> Document {
    let path = CameraPath {
        points: positions.into_iter().map(SupportPoint::new).collect(),
        // One frame from point to point: every position leaves as it is.
        base_frames: BaseFrames {
            movement: 1e-20,
            ..BaseFrames::default()
        },
        ..CameraPath::default()
    };
    Document::from_parts(path, info).unwrap()
}

fn poses(document: &Document) -> Vec<Pose> {
    let sampler = document.sampler().unwrap();
    let mut poses = vec![Pose::default(); sampler.frame_count()];
    sampler.sample(1, &mut poses).unwrap();
    poses
}

fn numbers(pose: &Pose) -> Vec<f64> {
    let mut numbers = [pose.vrp, pose.vpn, pose.vup].concat();
    numbers.push(pose.zoom);
    numbers
}

/// What `vides sample` writes.
const ALL: [&str; 3] = ["ascii", "csv", "json"];

fn write(
    document: &Document,
    format: &str,
    out: &mut dyn Write,
    progress: Progress<'_>,
) -> formats::Result<()> {
    let scene = document.scene_document()?;
    let report = formats::export_to(&scene, out, by_name(format)?, &Options::default(), progress)?;
    assert_eq!(report.losses(), []);
    Ok(())
}

fn written(document: &Document, format: &str) -> String {
    let mut out = Vec::new();
    write(document, format, &mut out, &mut |_, _| {}).unwrap();
    String::from_utf8(out).unwrap()
}

#[test]
fn ascii_is_what_c_prints() {
    // A locale with a decimal comma, where the system has one.
    // SAFETY: no other thread of this test reads the locale meanwhile but
    // through snprintf, whose result is the same either way.
    unsafe { libc::setlocale(libc::LC_NUMERIC, c"de_DE.UTF-8".as_ptr()) };
    let mut random = random();
    let mut positions = Vec::new();
    for index in 0..40_000 {
        let mut number = || match index % 8 {
            // Half-way between two ten-thousandths, exactly or by a hair.
            0 => (random() * 1e5).round() / 32.0,
            1 => (random() * 1e6).round() / 20_000.0,
            2 => ((random() * 1e6).round() / 20_000.0).next_up(),
            3 => ((random() * 1e6).round() / 20_000.0).next_down(),
            4 => random() * 2e-4,
            5 => random() * 1e9,
            _ => random(),
        };
        positions.push(dvec3(number(), number(), number()));
    }
    positions.extend([
        dvec3(0.0, -0.0, -0.000_01),
        dvec3(0.000_05, -0.000_05, -5e-324),
        dvec3(0.5 / 16.0, -0.5 / 16.0, 1.5 / 16.0),
        dvec3(1e9, -1e9, 0.99995),
    ]);
    let document = document(positions.iter().copied(), Info::default());
    let poses = poses(&document);
    assert_eq!(poses.len(), positions.len());
    for (pose, position) in poses.iter().zip(&positions) {
        assert_eq!(pose.vrp, position.to_array());
    }
    let text = written(&document, "ascii");
    let mut lines = text.lines();
    for pose in &poses {
        let expected: Vec<_> = numbers(pose).into_iter().map(c_prints).collect();
        assert_eq!(lines.next().unwrap(), expected.join(" "), "{pose:?}");
    }
    assert_eq!(lines.next(), None);
    assert!(text.ends_with('\n') && !text.contains("-0.0000"));
}

/// A document with everything that a format must quote.
fn described() -> Document {
    let info = Info {
        title: "a \"title\" \\ \u{e4}\u{1F3A5}".to_owned(),
        comment: "two\nlines\t\u{7f}\r\u{85}".to_owned(),
        fps: 23.976,
        first_frame: -3,
        unit: "m".to_owned(),
        ..Info::default()
    };
    let mut random = random();
    document(
        (0..2_000).map(|_| dvec3(random(), random(), random() * 1e-7)),
        info,
    )
}

fn same_bits(a: f64, b: f64) -> bool {
    a.to_bits() == b.to_bits()
}

#[test]
fn csv_has_a_header_and_every_bit() {
    let document = described();
    let text = written(&document, "csv");
    let mut lines = text.lines();
    assert_eq!(
        lines.next().unwrap(),
        "frame,vrp_x,vrp_y,vrp_z,vpn_x,vpn_y,vpn_z,vup_x,vup_y,vup_z,zoom,seconds"
    );
    for (index, pose) in poses(&document).iter().enumerate() {
        let mut cells = lines.next().unwrap().split(',');
        let frame: i32 = cells.next().unwrap().parse().unwrap();
        assert_eq!(frame, index as i32 - 3);
        for number in numbers(pose) {
            let cell: f64 = cells.next().unwrap().parse().unwrap();
            assert!(same_bits(cell, number));
        }
        let seconds: f64 = cells.next().unwrap().parse().unwrap();
        assert!(same_bits(seconds, index as f64 / document.info().fps));
        assert_eq!(cells.next(), None);
    }
    assert_eq!(lines.next(), None);
}

#[test]
fn json_is_json_with_every_bit() {
    let document = described();
    let mut document = document;
    let space = Space {
        centre: dvec3(0.5, -20.0, 1e-3),
        half_size: 2.5,
        up: Up::Z,
    };
    document
        .apply(Edit::SetSpace { space, fit: false })
        .unwrap();
    let info = document.info();
    let text = written(&document, "json");
    let json: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert_eq!(json["title"], info.title.as_str());
    assert_eq!(json["comment"], info.comment.as_str());
    assert_eq!(json["fps"], 23.976);
    assert_eq!(json["first_frame"], -3);
    assert_eq!(
        json["space"],
        serde_json::json!({
            "centre": [0.5, -20.0, 1e-3],
            "half_size": 2.5,
            "unit": "m",
            "up": "z",
        })
    );
    let poses = poses(&document);
    assert_eq!(json["frame_count"], poses.len());
    let array = json["poses"].as_array().unwrap();
    assert_eq!(array.len(), poses.len());
    for (pose, value) in poses.iter().zip(array) {
        for (name, vector) in [("vrp", pose.vrp), ("vpn", pose.vpn), ("vup", pose.vup)] {
            for (axis, &number) in vector.iter().enumerate() {
                assert!(same_bits(value[name][axis].as_f64().unwrap(), number));
            }
        }
        assert!(same_bits(value["zoom"].as_f64().unwrap(), pose.zoom));
    }
}

#[test]
fn files_hold_the_same_and_progress_reaches_the_end() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("poses.txt");
    let document = described();
    for format in ALL {
        let mut seen = Vec::new();
        let (scene, options) = (document.scene_document().unwrap(), Options::default());
        let mut see = |done, all| seen.push((done, all));
        let by_its_name = by_name(format).unwrap();
        formats::export(&scene, &file, by_its_name, &options, &mut see).unwrap();
        let text = std::fs::read_to_string(&file).unwrap();
        assert_eq!(text, written(&document, format));
        assert!(seen.is_sorted());
        assert_eq!(seen.last(), Some(&(2_000, 2_000)));
    }
    let sampler = document.sampler().unwrap();
    formats::write_ascii_file(sampler, &file).unwrap();
    let text = std::fs::read_to_string(&file).unwrap();
    assert_eq!(text, written(&document, "ascii"));
}

/// A writer that takes so many bytes and then fails.
struct Full(usize);

impl Write for Full {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        if self.0 == 0 {
            return Err(std::io::Error::from_raw_os_error(libc::ENOSPC));
        }
        let taken = bytes.len().min(self.0);
        self.0 -= taken;
        Ok(taken)
    }

    fn flush(&mut self) -> std::io::Result<()> {
        Ok(())
    }
}

#[test]
fn a_full_output_is_told() {
    let document = described();
    for format in ALL {
        for room in [0, 1, 100, 100_000] {
            let error = write(&document, format, &mut Full(room), &mut |_, _| {});
            let error = error.unwrap_err();
            assert!(matches!(error, formats::Error::Document(Error::Io { .. })));
            assert_eq!(error.to_string(), "the output: No space left on device");
        }
    }
}
