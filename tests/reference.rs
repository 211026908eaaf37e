//! The engine against `tests/oracles/reference.py`: a slow, plain one in
//! 40-digit arithmetic that shares no code with it. Every file of
//! `tests/oracles/reference/` is a path with its lengths, sections and poses.

use std::path::{Path, PathBuf};

use glam::DVec3;
use vides::path::{
    BaseFrames, CameraPath, Change, CurveParameters, Orientation, OrientationMode,
    OrientationOverrides, Pose, Sampler, SupportPoint, Target, Tcb, Timeline, Up, UpVector,
    ZoomMode,
};

/// Lengths, relative; positions, relative to the segment and its distance
/// from the origin; components of unit vectors; zoom. The worst case of each
/// is printed (`cargo test --test reference -- --nocapture`).
const LENGTH: f64 = 1e-12;
const POSITION: f64 = 1e-12;
const DIRECTION: f64 = 1e-12;
const ZOOM: f64 = 1e-12;

/// Poses are also asked for so many at a time.
const PIECE: usize = 37;

/// A path and what the other engine makes of it.
struct Case {
    path: CameraPath,
    segments: Vec<f64>,
    sections: Vec<(Change, f64, f64, usize)>,
    frames: usize,
    poses: Vec<(f64, Pose)>,
}

fn numbers<const N: usize>(words: &[&str]) -> [f64; N] {
    let values: Vec<f64> = words.iter().map(|w| w.parse().expect("a number")).collect();
    values.try_into().expect("so many numbers")
}

fn vector(words: &[&str]) -> DVec3 {
    DVec3::from_array(numbers(words))
}

fn tcb(words: &[&str]) -> Tcb {
    let [tension, continuity, bias] = numbers(words);
    Tcb::new(tension, continuity, bias)
}

fn point(words: &[&str]) -> SupportPoint {
    let curve = match words[3] {
        "preset" => CurveParameters::Preset(words[4].parse().expect("a preset")),
        "tcb" => CurveParameters::Own(tcb(&words[4..])),
        other => panic!("no curve {other}"),
    };
    SupportPoint {
        curve,
        orientations: Vec::new(),
        ..SupportPoint::new(vector(&words[..3]))
    }
}

fn view(words: &[&str]) -> Orientation {
    let target = match words[0] {
        "absolute" => Target::Absolute(vector(&words[1..4])),
        "relative" => Target::Relative(vector(&words[1..4])),
        other => panic!("no target {other}"),
    };
    let [roll, zoom, hold] = numbers(&words[4..7]);
    Orientation {
        target,
        roll,
        zoom,
        turning: tcb(&words[7..10]),
        speeds: numbers(&words[10..]),
        hold: hold as u32,
        ..Orientation::default()
    }
}

fn pose(words: &[&str]) -> (f64, Pose) {
    let v: [f64; 11] = numbers(words);
    let three = |at: usize| [v[at], v[at + 1], v[at + 2]];
    let pose = Pose {
        vrp: three(1),
        vpn: three(4),
        vup: three(7),
        zoom: v[10],
    };
    (v[0], pose)
}

/// What the last view owns, changed.
fn own(path: &mut CameraPath, change: impl FnOnce(&mut OrientationOverrides)) {
    let point = path.points.last_mut();
    let view = point.and_then(|point| point.orientations.last_mut());
    let own = &mut view.expect("a view before what it owns").own;
    *own = own.with(change).expect("memory");
}

impl Case {
    fn read(file: &Path) -> Self {
        let text = std::fs::read_to_string(file).expect("the file can be read");
        let mut path = CameraPath {
            points: [].into(),
            ..CameraPath::default()
        };
        let (mut segments, mut sections, mut poses) = (Vec::new(), Vec::new(), Vec::new());
        let (mut frames, mut presets) = (0, 0);
        for line in text.lines().filter(|line| !line.starts_with('#')) {
            let words: Vec<&str> = line.split(' ').collect();
            let (&key, words) = words.split_first().expect("a word");
            match (key, words) {
                ("closed", [flag]) => path.closed = *flag == "1",
                ("orientation_mode", [mode]) => path.orientation_mode = orientation_mode(mode),
                ("zoom_mode", [mode]) => path.zoom_mode = zoom_mode(mode),
                ("speeds", _) => {
                    let [movement, turning, zoom, rolling] = numbers(words);
                    path.base_frames = BaseFrames {
                        movement,
                        turning,
                        zoom,
                        rolling,
                    };
                }
                ("preset", _) => {
                    path.presets[presets] = tcb(words);
                    presets += 1;
                }
                ("point", _) => path.points.push(point(words)),
                ("view", _) => {
                    let point = path.points.last_mut().expect("a point before its views");
                    point.orientations.push(view(words));
                }
                ("zoom_slope", _) => {
                    let [slope] = numbers(words);
                    own(&mut path, |own| own.zoom_slope = Some(slope));
                }
                ("up", ["z"]) => own(&mut path, |own| own.up = UpVector::Fixed(Up::Z)),
                ("segment", _) => segments.extend(numbers::<1>(words)),
                ("section", [what, amount, mean, frames]) => {
                    let [amount, mean] = numbers(&[amount, mean]);
                    sections.push((change(what), amount, mean, frames.parse().expect("frames")));
                }
                ("frames", [count]) => frames = count.parse().expect("a count"),
                ("pose", _) => poses.push(pose(words)),
                _ => panic!("{}: what is {line:?}?", file.display()),
            }
        }
        path.check().expect("the path is a valid one");
        assert!(poses.len() > 10 && segments.len() == path.segment_count());
        Self {
            path,
            segments,
            sections,
            frames,
            poses,
        }
    }
}

fn orientation_mode(name: &str) -> OrientationMode {
    match name {
        "tcb" => OrientationMode::Tcb,
        "barry-goldman" => OrientationMode::BarryGoldman,
        "slerp" => OrientationMode::Slerp,
        other => panic!("no orientation mode {other}"),
    }
}

fn zoom_mode(name: &str) -> ZoomMode {
    match name {
        "smooth" => ZoomMode::Smooth,
        "linear" => ZoomMode::Linear,
        other => panic!("no zoom mode {other}"),
    }
}

fn change(name: &str) -> Change {
    match name {
        "position" => Change::Position,
        "view" => Change::View,
        "roll" => Change::Roll,
        "zoom" => Change::Zoom,
        "nothing" => Change::Nothing,
        other => panic!("nothing changes like {other}"),
    }
}

/// The worst of one kind of difference, and where it was.
struct Worst {
    what: &'static str,
    allowed: f64,
    value: f64,
    place: String,
}

impl Worst {
    fn new(what: &'static str, allowed: f64) -> Self {
        Self {
            what,
            allowed,
            value: 0.0,
            place: String::new(),
        }
    }

    /// Also takes a NaN for the worst.
    fn see(&mut self, value: f64, place: impl FnOnce() -> String) {
        if value.is_nan() || value > self.value {
            self.value = value;
            self.place = place();
        }
    }

    fn complaint(&self) -> Option<String> {
        let bad = self.value.is_nan() || self.value > self.allowed;
        bad.then(|| format!("{} {:.3e} at {}", self.what, self.value, self.place))
    }
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    (DVec3::from_array(a) - DVec3::from_array(b)).length()
}

/// What a rounding of the place is measured by: the longest adjoining segment
/// and the distance from the origin.
fn sizes(case: &Case) -> Vec<f64> {
    let points = &case.path.points;
    let far: Vec<f64> = points.iter().map(|p| p.position.length()).collect();
    let next = |i: usize| (i + 1) % far.len();
    let lengths = case.segments.iter().enumerate();
    lengths
        .map(|(i, length)| length + far[i].max(far[next(i)]))
        .collect()
}

/// The segment in which each section runs or at whose start it stands.
fn size_at(case: &Case, timeline: &Timeline, sampler: &Sampler, frame: f64, sizes: &[f64]) -> f64 {
    let mut size = sizes[0];
    for index in 0..case.sections.len() {
        let section = timeline.section(index);
        if section.frames > 0 && sampler.first_frame(index) as f64 - 1.0 <= frame {
            size = sizes[section.point.min(sizes.len() - 1)];
        }
    }
    size
}

fn compare(file: &Path) -> Vec<String> {
    let name = file
        .file_stem()
        .expect("a name")
        .to_string_lossy()
        .into_owned();
    let case = Case::read(file);
    let timeline = Timeline::new(&case.path).expect("a timeline");
    let sampler = Sampler::new(&case.path, &timeline).expect("a sampler");
    let mut bad = Vec::new();

    let mut length = Worst::new("length", LENGTH);
    for (i, &expected) in case.segments.iter().enumerate() {
        let got = timeline.segment_length(i);
        let relative = (got - expected).abs() / expected.max(f64::MIN_POSITIVE);
        length.see(if got == expected { 0.0 } else { relative }, || {
            format!("segment {i}")
        });
    }
    assert_eq!(
        timeline.section_count(),
        case.sections.len(),
        "{name}: sections"
    );
    for (i, (what, amount, mean, frames)) in case.sections.iter().enumerate() {
        let got = timeline.section(i);
        if (got.change, got.frames) != (*what, *frames) {
            bad.push(format!(
                "section {i}: {:?}, {} frames; not {what:?}, {frames}",
                got.change, got.frames
            ));
        }
        if *frames > 0 {
            length.see((got.amount - amount).abs() / amount, || {
                format!("amount of section {i}")
            });
            length.see((got.mean_speed - mean).abs() / mean, || {
                format!("mean speed of section {i}")
            });
        }
    }
    let counts = (
        timeline.frame_count().expect("a count"),
        sampler.frame_count(),
    );
    if counts != (case.frames, case.frames) {
        bad.push(format!("frames {counts:?}, not {}", case.frames));
    }
    if !bad.is_empty() {
        return bad
            .into_iter()
            .map(|line| format!("{name}: {line}"))
            .collect();
    }

    let mut all = vec![Pose::default(); case.frames];
    sampler.sample(1, &mut all).expect("poses");
    let mut pieces = vec![Pose::default(); case.frames];
    for (i, piece) in pieces.chunks_mut(PIECE).enumerate() {
        sampler.sample(1 + i * PIECE, piece).expect("poses");
    }
    let mut worst = [
        Worst::new("vrp", POSITION),
        Worst::new("vpn", DIRECTION),
        Worst::new("vup", DIRECTION),
        Worst::new("zoom", ZOOM),
    ];
    let sizes = sizes(&case);
    for &(frame, expected) in &case.poses {
        let size = size_at(&case, &timeline, &sampler, frame, &sizes);
        let mut see = |how: &str, got: &Pose| {
            let differences = [
                distance(got.vrp, expected.vrp) / size,
                distance(got.vpn, expected.vpn),
                distance(got.vup, expected.vup),
                (got.zoom - expected.zoom).abs() / expected.zoom,
            ];
            for (worst, value) in worst.iter_mut().zip(differences) {
                worst.see(value, || format!("frame {frame} ({how})"));
            }
        };
        see("pose", &sampler.pose(frame).expect("a pose"));
        if frame.fract() == 0.0 {
            see("sample", &all[frame as usize - 1]);
            see("sample in pieces", &pieces[frame as usize - 1]);
        }
    }
    let shown: Vec<String> = worst
        .iter()
        .chain([&length])
        .map(|w| format!("{} {:8.1e}", w.what, w.value))
        .collect();
    println!("{name:28} {}", shown.join("  "));
    let complaints = worst.iter().chain([&length]).filter_map(Worst::complaint);
    complaints.map(|line| format!("{name}: {line}")).collect()
}

fn files() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/oracles/reference");
    let entries = std::fs::read_dir(folder).expect("the folder of the references");
    let mut files: Vec<PathBuf> = entries
        .map(|entry| entry.expect("an entry").path())
        .collect();
    files.sort();
    files
}

#[test]
fn every_reference_path_agrees() {
    let files = files();
    assert!(files.len() >= 40, "only {} references", files.len());
    let bad: Vec<String> = files.iter().flat_map(|file| compare(file)).collect();
    assert!(
        bad.is_empty(),
        "{} differences:\n{}",
        bad.len(),
        bad.join("\n")
    );
}
