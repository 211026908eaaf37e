//! Files written by hand, whose poses are known.

use glam::DVec3;
use vides_engine::path::{Pose, Up};
use vides_formats::{Content, Loss, Options, Recording, Report, Source, by_name, read};

use super::{differences, options, poses, pyramid, written};

/// What a file of this name holds, and the format that its content shows.
fn taken(file: &str, bytes: &[u8]) -> (&'static str, Recording, Vec<Loss>) {
    let source = Source::of_bytes(file, bytes.into());
    let mut report = Report::default();
    let (name, content) = read(&source, None, &Options::default(), &mut report).unwrap();
    let Content::Poses(recording) = content else {
        panic!("{file}: no poses");
    };
    (name, recording, report.losses().to_vec())
}

fn is_at(pose: &Pose, place: [f64; 3], view: DVec3, up: DVec3) {
    let pairs = [(pose.vrp, place.into()), (pose.vpn, view), (pose.vup, up)];
    for (found, wanted) in pairs {
        assert!(DVec3::from(found).distance(wanted) < 1e-12, "{pose:?}");
    }
}

/// Two cameras at (1, 2, 3) and (4, 5, 6): the first has the axes of the world, the second looks
/// along x, y up.
fn is_pair(recording: &Recording) {
    let [first, second] = recording.poses.as_slice() else {
        panic!("{} poses", recording.poses.len());
    };
    is_at(first, [1.0, 2.0, 3.0], DVec3::Z, DVec3::NEG_Y);
    is_at(second, [4.0, 5.0, 6.0], DVec3::X, DVec3::Y);
}

const ROWS: [[&str; 4]; 2] = [
    ["1 0 0 1", "0 1 0 2", "0 0 1 3", "0 0 0 1"],
    ["0 0 1 4", "0 -1 0 5", "1 0 0 6", "0 0 0 1"],
];

#[test]
fn matrices_in_every_layout_are_the_same_poses() {
    let [a, b] = ROWS;
    let three = |rows: [&str; 4]| rows[..3].join(" ");
    for text in [
        format!("{}\n{}\n", a.join(" "), b.join(" ")),
        format!("{}\n\n{}", a.join("\n"), b.join("\n")),
        format!("# scene\n{}\n{}\n", a.join(", "), b.join(",")),
        format!("7 {} \n11 {} \n", three(a), three(b)),
        format!("7 {}\n11 {}\n", a.join("\t"), b.join(" ")),
    ] {
        let (name, recording, losses) = taken("poses.txt", text.as_bytes());
        is_pair(&recording);
        let numbered = text.starts_with('7');
        assert_eq!(name, "matrices");
        assert_eq!(recording.frames, numbered.then_some(vec![7.0, 11.0]));
        assert_eq!(losses.contains(&Loss::Times), !numbered);
        assert!(losses.contains(&Loss::FieldOfView));
    }
    let text = format!("{}\n{}\n", three(a), three(b));
    assert_eq!(taken("poses.txt", text.as_bytes()).0, "kitti");
}

/// Arrays that `numpy.save` has written.
#[test]
fn arrays_of_numpy_are_poses() {
    for bytes in [
        &include_bytes!("../../../../tests/corpus/formats/matrices/f8_4x4.npy")[..],
        include_bytes!("../../../../tests/corpus/formats/matrices/f4_3x4.npy"),
        include_bytes!("../../../../tests/corpus/formats/matrices/version_2.npy"),
    ] {
        let (name, recording, losses) = taken("poses.npy", bytes);
        is_pair(&recording);
        assert_eq!(name, "matrices");
        assert_eq!(losses, [Loss::FieldOfView, Loss::Times]);
    }
}

/// What `numpy.save` writes of the same array, byte for byte but for rounding and the sign of zeros.
#[test]
fn a_written_array_is_one_of_numpy() {
    let of_numpy = include_bytes!("../../../../tests/corpus/formats/matrices/f8_4x4.npy");
    let source = Source::of_bytes("poses.npy", of_numpy.to_vec());
    let read = vides_formats::import(&source, by_name("matrices").ok(), &options("as=keys"));
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("again.NPY");
    written(
        &read.unwrap().document,
        "matrices",
        &file,
        &Options::default(),
    );
    let again = std::fs::read(file).unwrap();
    assert_eq!(
        (again.len(), &again[..128]),
        (of_numpy.len(), &of_numpy[..128])
    );
    let numbers = |bytes: &[u8]| {
        let eights = bytes[128..].chunks_exact(8);
        let numbers = eights.map(|bytes| f64::from_le_bytes(bytes.try_into().unwrap()));
        numbers.collect::<Vec<_>>()
    };
    let pairs = numbers(&again).into_iter().zip(numbers(of_numpy));
    for (found, wanted) in pairs {
        assert!((found - wanted).abs() < 1e-12, "{found} {wanted}");
    }
}

/// Made by hand as Open3D's source writes them: 525 pixels of focal length in a picture 480 high.
#[test]
fn trajectories_of_open3d_are_poses() {
    let json = include_bytes!("../../../../tests/corpus/formats/open3d/valid.json");
    let (name, recording, losses) = taken("a.json", json);
    is_pair(&recording);
    assert_eq!((name, losses), ("open3d", vec![Loss::Times]));
    let zoom = 525.0 * 24.0 / 480.0;
    let fits = |pose: &Pose| (pose.zoom - zoom).abs() < 1e-12;
    assert!(recording.poses.iter().all(fits));
    let one = include_bytes!("../../../../tests/corpus/formats/open3d/screen_camera.json");
    let (name, recording, _) = taken("ScreenCamera.json", one);
    assert_eq!((name, recording.poses.len()), ("open3d", 1));
    is_at(&recording.poses[0], [4.0, 5.0, 6.0], DVec3::X, DVec3::Y);
    let log = include_bytes!("../../../../tests/corpus/formats/open3d/valid.log");
    let (name, recording, losses) = taken("a.txt", log);
    is_pair(&recording);
    assert_eq!(name, "open3d");
    assert_eq!(losses, [Loss::Times, Loss::FieldOfView]);
}

/// The centre of a picture is at half a pixel less than half its size, or at that.
#[test]
fn only_a_centre_elsewhere_is_told_of_open3d() {
    let json = include_str!("../../../../tests/corpus/formats/open3d/valid.json");
    for (centre, off) in [("320.0", 0), ("319.5", 0), ("321.0", 2), ("318.0", 2)] {
        let json = json.replace("319.5", centre);
        let losses = taken("a.json", json.as_bytes()).2;
        assert_eq!(losses.contains(&Loss::OffCentre(2)), off == 2, "{centre}");
    }
}

/// By hand as the source of instant-ngp does it with matrices of `transforms.json`: y and z columns
/// mirrored, times 0.33, plus 0.5, then rows y, z, x.
#[test]
fn keys_of_instant_ngp_are_in_the_world_of_transforms() {
    let gui = include_bytes!("../../../../tests/corpus/formats/instant-ngp/gui.json");
    let (name, recording, losses) = taken("a.json", gui);
    let [first, second] = recording.poses.as_slice() else {
        panic!("{} poses", recording.poses.len());
    };
    is_at(first, [1.0, 2.0, 3.0], DVec3::NEG_Z, DVec3::Y);
    is_at(second, [3.0, 1.0, 2.0], DVec3::NEG_X, DVec3::Z);
    let wanted = 12.0 / (0.5 * 50.625_f64).to_radians().tan();
    assert!((first.zoom - wanted).abs() < 1e-12);
    assert_eq!((name, &recording.seconds), ("instant-ngp", &None));
    let told: Vec<_> = losses.iter().map(ToString::to_string).collect();
    assert_eq!(
        told,
        [
            "there are no times: a pose is a frame",
            "its viewer joins the keys by a spline of its own",
            "loop is not taken, 1 of it",
        ]
    );
    let timed = include_bytes!("../../../../tests/corpus/formats/instant-ngp/timed.json");
    let (_, timed, losses) = taken("a.json", timed);
    assert_eq!((timed.seconds, losses), (Some(vec![0.0, 0.5]), vec![]));
    assert_eq!(timed.poses, recording.poses);
}

/// The same two keys in settings of both versions and in a document: at (1, 2, 3) and (4, 5, 6) of
/// the PLY, which is turned by half a turn about z, in a picture of 16 × 9.
#[test]
fn tracks_of_supersplat_are_in_the_world_of_the_ply() {
    let files = [
        include_str!("../../../../tests/corpus/formats/supersplat/settings.json"),
        include_str!("../../../../tests/corpus/formats/supersplat/version_1.json"),
        include_str!("../../../../tests/corpus/formats/supersplat/document.json"),
    ];
    let told = [
        vec![
            "animTracks is not taken, 1 of it",
            "loopMode is not taken, 1 of it",
            "its viewer joins the keys by a spline of its own",
        ],
        vec!["its viewer joins the keys by a spline of its own"],
        vec![
            "a pose beyond the time line is not taken, 1 of it",
            "its viewer joins the keys by a spline of its own",
        ],
    ];
    for (at, (text, told)) in files.iter().zip(told).enumerate() {
        let (name, recording, losses) = taken("a.json", text.as_bytes());
        let losses: Vec<_> = losses.iter().map(ToString::to_string).collect();
        assert_eq!(
            (name, losses),
            ("supersplat", told.iter().map(ToString::to_string).collect())
        );
        assert_eq!(recording.seconds, Some(vec![0.0, 1.0]));
        assert_eq!(recording.fps, Some(30.0));
        let [first, second] = recording.poses.as_slice() else {
            panic!("{} poses", recording.poses.len());
        };
        let half = 0.5_f64.sqrt();
        is_at(first, [1.0, 2.0, 3.0], DVec3::Z, DVec3::NEG_Y);
        let (view, up) = (DVec3::new(0.0, -half, -half), DVec3::new(0.0, -half, half));
        is_at(second, [4.0, 5.0, 6.0], view, up);
        // 90° across are 2·atan(9/16) down; the first file of version 1 has them for both.
        assert!((first.zoom - 12.0 * 16.0 / 9.0).abs() < 1e-12);
        let degrees: f64 = if at == 1 { 90.0 } else { 60.0 };
        let down = (0.5 * degrees).to_radians().tan() * 9.0 / 16.0;
        assert!((second.zoom - 12.0 / down).abs() < 1e-12);
    }
}

/// All but the roll comes back; a camera that the viewer holds upright comes back whole.
#[test]
fn a_track_of_supersplat_gives_the_flight_back() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("settings.json");
    for size in ["1920x1080", "1080x1920", "500x500"] {
        let choice = options(&format!("as=keys\nsize={size}"));
        let document = pyramid();
        let losses = written(&document, "supersplat", &file, &choice);
        let went = poses(&document, Up::Y);
        // The top of the PLY is down in its own axes.
        assert!(losses.contains(&Loss::Roll(went.len())), "{losses:?}");
        let source = Source::open(&file).unwrap();
        let back = vides_formats::import(&source, None, &choice).unwrap();
        assert_eq!((back.format, back.report.losses()), ("supersplat", &[][..]));
        let came = poses(&back.document, Up::Y);
        assert_eq!(went.len(), came.len());
        for (went, came) in went.iter().zip(&came) {
            assert!(went.position().distance(came.position()) < 1e-12);
            assert!(went.view().distance(came.view()) < 1e-12);
            assert!((went.zoom - came.zoom).abs() < 1e-9);
            assert!(came.up().dot(went.up()) < 0.0);
        }
        let losses = written(&back.document, "supersplat", &file, &choice);
        assert!(
            !losses.iter().any(|loss| matches!(loss, Loss::Roll(_))),
            "{losses:?}"
        );
        let again = vides_formats::import(&Source::open(&file).unwrap(), None, &choice).unwrap();
        let [off, turned, field] = differences(&came, &poses(&again.document, Up::Y));
        assert!(
            off < 1e-12 && turned < 1e-6 && field < 1e-9,
            "{off} {turned} {field}"
        );
    }
}

/// Poses by hand: OpenGL's axes, from camera to world, the quaternion's scalar last.
#[test]
fn metadata_of_record3d_are_poses() {
    let all = include_str!("../../../../tests/corpus/formats/record3d/metadata.json");
    let early = include_str!("../../../../tests/corpus/formats/record3d/early.json");
    // An empty list is none: the camera of all counts.
    let empty = early.replace("\"K\"", "\"perFrameIntrinsicCoeffs\": [], \"K\"");
    for (text, times, second, told) in [
        (empty.as_str(), None, 20.0, vec![]),
        (all, Some(vec![0.0, 0.5]), 24.0, vec![Loss::OffCentre(1)]),
        (early, None, 20.0, vec![]),
    ] {
        let (name, recording, losses) = taken("a", text.as_bytes());
        let [first, last] = recording.poses.as_slice() else {
            panic!("{} poses", recording.poses.len());
        };
        is_at(first, [1.0, 2.0, 3.0], DVec3::NEG_Z, DVec3::Y);
        // A quarter about y.
        is_at(last, [4.0, 5.0, 6.0], DVec3::NEG_X, DVec3::Y);
        // 800 and 960 pixels of focal length in a picture 960 high.
        assert!((first.zoom - 20.0).abs() < 1e-12 && (last.zoom - second).abs() < 1e-12);
        assert_eq!(
            (name, recording.fps, recording.up),
            ("record3d", Some(60.0), Some(Up::Y))
        );
        assert_eq!((recording.seconds, losses), (times, told));
    }
}

/// What a folder of files gives, with the names and texts in it.
fn taken_together(files: &[(&str, &str)]) -> (&'static str, Recording, Vec<Loss>) {
    let folder = tempfile::tempdir().unwrap();
    for (name, text) in files {
        std::fs::write(folder.path().join(name), text).unwrap();
    }
    let source = Source::open(folder.path()).unwrap();
    let mut report = Report::default();
    let (name, content) = read(&source, None, &Options::default(), &mut report).unwrap();
    let Content::Poses(recording) = content else {
        panic!("no poses");
    };
    (name, recording, report.losses().to_vec())
}

#[test]
fn a_folder_of_cameras_of_polycam_is_a_recording() {
    let files = [
        (
            "10500000.json",
            include_str!("../../../../tests/corpus/formats/polycam/10500000.json"),
        ),
        (
            "9000000.json",
            include_str!("../../../../tests/corpus/formats/polycam/9000000.json"),
        ),
        ("mesh_info.json", "{}"),
    ];
    let (name, recording, losses) = taken_together(&files);
    let [first, second] = recording.poses.as_slice() else {
        panic!("{} poses", recording.poses.len());
    };
    is_at(first, [1.0, 2.0, 3.0], DVec3::NEG_Z, DVec3::Y);
    is_at(second, [4.0, 5.0, 6.0], DVec3::NEG_X, DVec3::Y);
    assert!((first.zoom - 800.0 * 24.0 / 768.0).abs() < 1e-12);
    assert_eq!(
        (name, recording.seconds),
        ("polycam", Some(vec![9.0, 10.5]))
    );
    assert_eq!(losses, [Loss::OffCentre(1), Loss::Epoch(9.0)]);
    let (name, one, losses) = taken("a.json", files[1].1.as_bytes());
    assert_eq!(
        (name, one.poses, losses),
        ("polycam", vec![*first], vec![Loss::Times])
    );
}

/// 7-Scenes and ScanNet have a file for each frame; ScanNet has infinite numbers where it was lost.
#[test]
fn a_folder_of_matrices_is_a_recording() {
    let [a, b] = ROWS.map(|rows| rows.join("\n"));
    let lost = "-inf -inf -inf -inf\n".repeat(4);
    let (name, recording, losses) = taken_together(&[
        ("frame-000010.pose.txt", &b),
        ("frame-000002.pose.txt", &a),
        ("frame-000002.color.png", ""),
    ]);
    is_pair(&recording);
    assert_eq!(
        (name, recording.frames),
        ("matrices", Some(vec![2.0, 10.0]))
    );
    assert_eq!(losses, [Loss::FieldOfView]);
    let (name, recording, losses) =
        taken_together(&[("10.txt", &b), ("9.txt", &lost), ("2.txt", &a)]);
    is_pair(&recording);
    assert_eq!(
        (name, recording.frames),
        ("matrices", Some(vec![2.0, 10.0]))
    );
    let told = losses[1].to_string();
    assert_eq!(told, "a pose that is not finite is not taken, 1 of it");
}
