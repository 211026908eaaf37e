//! Random paths through the formats that hold a list of poses, and back.

#[path = "pose_lists/known.rs"]
mod known;
#[path = "pose_lists/refused.rs"]
mod refused;

use std::ops::Range;
use std::path::Path;

use glam::DVec3;
use proptest::prelude::*;
use vides_document::SceneDocument;
use vides_engine::path::{Pose, Up};
use vides_formats::{Flight, Format, Loss, Options, Source, by_name, export, formats, import};

/// A format, a file of it, whether it keeps fields of view, and whether it keeps times.
const LISTS: [(&str, &str, bool, bool); 14] = [
    ("tum", "a.tum", false, true),
    ("euroc", "a.euroc", false, true),
    ("kitti", "a.kitti", false, false),
    ("matrices", "a.matrices", false, false),
    ("matrices", "a.npy", false, false),
    ("open3d", "camera_trajectory.json", true, false),
    ("open3d", "a.log", false, false),
    ("colmap", "model", true, false),
    ("osg", "a.path", false, true),
    ("chan", "a.chan", true, true),
    ("nerfstudio", "camera_path.json", true, true),
    ("transforms", "transforms.json", true, false),
    ("instant-ngp", "base_cam.json", true, true),
    ("cameras", "cameras.json", true, false),
];

fn options(lines: &str) -> Options {
    Options::parse(lines).unwrap()
}

/// The poses of a document's camera with an axis upright.
fn poses(document: &SceneDocument, up: Up) -> Vec<Pose> {
    let options = Options {
        up: Some(up),
        ..Options::default()
    };
    let mut ignored = |_, _| {};
    let flight = Flight::new(document, &options, &Format::PLAIN, &mut ignored).unwrap();
    flight.all_poses().unwrap()
}

fn written(document: &SceneDocument, name: &str, file: &Path, options: &Options) -> Vec<Loss> {
    let format = by_name(name).unwrap();
    let report = export(document, file, format, options, &mut |_, _| {}).unwrap();
    report.losses().to_vec()
}

fn diagonal(poses: &[Pose]) -> f64 {
    let places = || poses.iter().map(Pose::position);
    let low = places().fold(DVec3::INFINITY, DVec3::min);
    let high = places().fold(DVec3::NEG_INFINITY, DVec3::max);
    low.distance(high)
}

fn degrees(a: DVec3, b: DVec3) -> f64 {
    a.cross(b).length().atan2(a.dot(b)).to_degrees()
}

fn field(pose: &Pose) -> f64 {
    2.0 * (12.0 / pose.zoom).atan().to_degrees()
}

/// The largest differences: a length, degrees, degrees of the field of view.
fn differences(a: &[Pose], b: &[Pose]) -> [f64; 3] {
    assert_eq!(a.len(), b.len());
    let mut worst = [0.0_f64; 3];
    for (a, b) in a.iter().zip(b) {
        let turned = degrees(a.view(), b.view()).max(degrees(a.up(), b.up()));
        let found = [
            a.position().distance(b.position()),
            turned,
            (field(a) - field(b)).abs(),
        ];
        for (worst, found) in worst.iter_mut().zip(found) {
            *worst = worst.max(found);
        }
    }
    worst
}

prop_compose! {
    /// A path in a space of some size somewhere, with either axis upright.
    fn path(zooms: Range<f64>)(
        up in prop::sample::select(vec!["y", "z"]),
        half in prop::sample::select(vec![0.05, 1.0, 250.0]),
        fps in prop::sample::select(vec![24.0, 25.0, 29.97, 60.0]),
        centre in prop::array::uniform3(-2.0..2.0_f64),
        points in prop::collection::vec(
            (
                prop::array::uniform3(-1.0..1.0_f64),
                prop::array::uniform3(-1.0..1.0_f64),
                -180.0..180.0_f64,
                zooms,
                0..4_u32,
            ),
            2..5,
        ),
    ) -> SceneDocument {
        let centre = centre.map(|coordinate| coordinate * half);
        let mut text = format!(
            "version = 1\nfps = {fps}\n[base_speeds]\nmove_frames = 12.0\nturn_frames = 12.0\n\
             zoom_frames = 12.0\nroll_frames = 12.0\n[space]\nup = \"{up}\"\nhalf_size = {half:?}\n\
             centre = {centre:?}\n"
        );
        for (place, offset, roll, zoom, hold) in points {
            let place: Vec<_> = (0..3).map(|axis| place[axis] * half + centre[axis]).collect();
            let offset = offset.map(|coordinate| (coordinate + 0.1) * half);
            text += &format!(
                "[[point]]\nposition = {place:?}\n[[point.orientation]]\noffset = {offset:?}\n\
                 roll_degrees = {roll:?}\nzoom_mm = {zoom:?}\nhold_frames = {hold}\n"
            );
        }
        SceneDocument::from_toml(&text).unwrap()
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn lists_give_the_poses_back(document in path(1.0..2000.0)) {
        let folder = tempfile::tempdir().unwrap();
        for (name, file, fields, times) in LISTS {
            let file = folder.path().join(file);
            let losses = written(&document, name, &file, &Options::default());
            prop_assert_eq!(losses.contains(&Loss::FieldOfView), !fields, "{}", name);
            prop_assert_eq!(losses.contains(&Loss::Times), !times, "{}", name);
            let up = by_name(name).unwrap().up;
            let up = up.unwrap_or(document.scene.space().up);
            let keys = options(&format!("as=keys\nfps={}\nup={}", document.info.fps, up.name()));
            let back = import(&Source::open(&file).unwrap(), None, &keys).unwrap();
            prop_assert_eq!(back.format, name);
            prop_assert_eq!(back.document.scene.space().up, up);
            prop_assert_eq!(back.report.losses().contains(&Loss::FieldOfView), !fields);
            let (went, came) = (poses(&document, up), poses(&back.document, up));
            let [off, turned, field] = differences(&went, &came);
            prop_assert!(off <= 1e-9 * diagonal(&went), "{}: {}", name, off);
            prop_assert!(turned <= 1e-6, "{}: {} degrees", name, turned);
            if fields {
                prop_assert!(field <= 1e-9, "{}: {} degrees of field", name, field);
            } else {
                prop_assert!(came.iter().all(|pose| pose.zoom == 24.0));
            }
        }
    }

    #[test]
    fn angles_of_any_order_come_back(document in path(1.0..2000.0)) {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("a.chan");
        for order in ["xyz", "xzy", "yxz", "yzx", "zxy", "zyx"] {
            let choice = options(&format!(
                "rotation-order={order}\nas=keys\nfps={}\nup={}",
                document.info.fps,
                document.scene.space().up.name()
            ));
            let _ = written(&document, "chan", &file, &choice);
            let back = import(&Source::open(&file).unwrap(), None, &choice).unwrap();
            let up = document.scene.space().up;
            let [off, turned, _] = differences(&poses(&document, up), &poses(&back.document, up));
            prop_assert!(off == 0.0 && turned <= 1e-6, "{}: {} {} degrees", order, off, turned);
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(4))]

    /// Lenses as there are: of a zoom from 21 to 1282 mm in 16 frames the fit says that it misses.
    #[test]
    fn a_fitted_path_is_as_near_as_was_asked(document in path(18.0..135.0)) {
        let folder = tempfile::tempdir().unwrap();
        for (name, file, ..) in LISTS {
            let file = folder.path().join(file);
            let _ = written(&document, name, &file, &Options::default());
            let choice = options(&format!("fps={}", document.info.fps));
            let back = import(&Source::open(&file).unwrap(), None, &choice).unwrap();
            let told = back.report.losses().iter().find_map(|loss| match loss {
                Loss::Fitted { off, turned, .. } => Some((*off, *turned)),
                _ => None,
            });
            let (off, turned) = told.unwrap();
            let up = by_name(name).unwrap().up.unwrap_or(Up::Y);
            let fixed = by_name(name).unwrap().up.is_some();
            let went = poses(&document, if fixed { up } else { document.scene.space().up });
            prop_assert!(off <= 1e-3 * diagonal(&went) * (1.0 + 1e-6), "{}: {}", name, off);
            prop_assert!(turned <= 0.5 + 1e-6, "{}: {} degrees", name, turned);
            let came = poses(&back.document, up);
            let found = differences(&went[..came.len().min(went.len())], &came[..came.len().min(went.len())]);
            prop_assert!(came.len().abs_diff(went.len()) <= 1, "{}", name);
            prop_assert!(found[0] <= off + 1e-9 * diagonal(&went), "{}: {:?} {}", name, found, off);
        }
    }
}

/// A document to write: the camera of a path.
fn pyramid() -> SceneDocument {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/pyramid.vid");
    SceneDocument::from_toml(&std::fs::read_to_string(file).unwrap()).unwrap()
}

#[test]
fn content_tells_the_format_and_where_it_cannot_the_name_does() {
    let folder = tempfile::tempdir().unwrap();
    for (name, file, ..) in LISTS {
        let file = folder.path().join(file);
        let _ = written(&pyramid(), name, &file, &Options::default());
        if file.is_dir() {
            continue;
        }
        let bytes = std::fs::read(file).unwrap();
        let read = |file: &str| {
            let source = Source::of_bytes(file, bytes.clone());
            import(&source, None, &options("as=keys")).map(|imported| imported.format)
        };
        if name == "osg" {
            let error = read("flight").unwrap_err().to_string();
            assert_eq!(
                error,
                "flight: this may be \"tum\" or \"osg\": name it, with --from in the command"
            );
            assert_eq!(read("flight.tum").unwrap(), "tum");
            assert_eq!(read("flight.PATH").unwrap(), "osg");
            assert_eq!(read("CameraTrajectory.txt").unwrap(), "tum");
        } else {
            assert_eq!(read("flight.txt").unwrap(), name);
        }
    }
    let by_target = |file: &str| vides_formats::by_target(Path::new(file)).unwrap().name;
    assert_eq!(by_target("a/images.txt"), "colmap");
    assert_eq!(by_target("a/poses.txt"), "ascii");
    assert_eq!(by_target("a/poses.json"), "json");
    assert_eq!(by_target("a/Transforms.json"), "transforms");
    assert_eq!(
        vides_formats::by_target(folder.path()).unwrap().name,
        "colmap"
    );
}

/// A line of numbers that is a matrix is no pose with its frame and seconds.
#[test]
fn twelve_numbers_are_a_matrix_or_a_pose() {
    let source = |text: &str| Source::of_bytes("a", text.into());
    let told = |text: &str| {
        import(&source(text), None, &options("as=keys"))
            .unwrap()
            .format
    };
    assert_eq!(
        told("1 0 0 0 0 1 0 0 0 0 1 0\n1 0 0 1 0 1 0 0 0 0 1 0\n"),
        "kitti"
    );
    assert_eq!(
        told("1 0 0 0 0 0 -1 0 1 0 24 0\n2 0 0 1 0 0 -1 0 1 0 24 0.04\n"),
        "ascii"
    );
}

/// Lines as in the ground truth of EuRoC and TUM-VI, whose scalar comes first; of two poses at one
/// time the first counts.
#[test]
fn nanoseconds_with_the_scalar_first_are_euroc() {
    let heading = "\u{feff}#timestamp [ns], p_RS_R_x [m], p_RS_R_y [m], p_RS_R_z [m], q_RS_w [], \
                   q_RS_x [], q_RS_y [], q_RS_z [], v_RS_R_x [m s^-1]\n";
    let rows = "1403636580838555648,4.6,-1.7,0.7,1.0,0.0,0.0,0.0,0.1\n\
                1403636580878555648,4.7,-1.7,0.7,0.0,1.0,0.0,0.0,0.1\n\
                1403636580878555648,9.0,-1.7,0.7,0.0,1.0,0.0,0.0,0.1\n\
                1403636580918555648,4.8,-1.7,0.7,0.0,1.0,0.0,0.0,0.1\n";
    let read = |text: &str| {
        let source = Source::of_bytes("data.csv", text.into());
        import(&source, None, &options("as=keys"))
    };
    let taken = read(&format!("{heading}{rows}")).unwrap();
    assert_eq!((taken.format, taken.document.info.fps), ("euroc", 25.0));
    let poses = poses(&taken.document, taken.document.scene.space().up);
    // Half a turn about x, from looking along z.
    let views: Vec<_> = poses.iter().map(|pose| pose.vpn[2].round()).collect();
    assert_eq!((poses.len(), views), (3, vec![1.0, -1.0, -1.0]));
    let told: Vec<_> = taken
        .report
        .losses()
        .iter()
        .map(ToString::to_string)
        .collect();
    assert!(
        told.contains(&"1 pose at the time of another left out".to_owned()),
        "{told:?}"
    );
    // Without a heading it may be the other order.
    let bare: String = rows
        .lines()
        .map(|row| row.rsplit_once(',').unwrap().0.to_owned() + "\n")
        .collect();
    let refused = read(&bare).unwrap_err().to_string();
    assert!(refused.contains("\"tum\", \"euroc\""), "{refused}");
}

#[test]
fn what_a_file_holds_and_is_not_taken_is_told() {
    let told = |name: &str, text: &str| {
        let source = Source::of_bytes("file", text.into());
        let format = by_name(name).unwrap();
        let read = import(&source, Some(format), &options("as=keys")).unwrap();
        let losses = read.report.losses().iter().map(ToString::to_string);
        (
            losses.collect::<Vec<_>>(),
            poses(&read.document, read.document.scene.space().up),
        )
    };
    let identity = "[[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]";
    let (losses, poses) = told(
        "transforms",
        &format!(
            "{{\"w\": 800, \"h\": 600, \"fl_x\": 500, \"fl_y\": 300, \"cx\": 400, \"cy\": 290, \
             \"k1\": 0.1, \"frames\": [{{\"transform_matrix\": {identity}}}, \
             {{\"transform_matrix\": {identity}, \"camera_angle_x\": 1.5707963267948966, \"cy\": 300}}, \
             {{\"transform_matrix\": {identity}, \"camera_angle_y\": 3.14}}]}}"
        ),
    );
    assert_eq!(
        losses,
        [
            "1 field of view beyond 0.69 to 170.5 degrees, clamped",
            "1 picture whose axis is off the centre: taken as in it",
            "the distortion of 1 camera is left out",
            "the width of 1 picture whose pixels are not square: their height counts",
            "there are no times: a pose is a frame",
        ]
    );
    let zooms: Vec<_> = poses.iter().map(|pose| pose.zoom).collect();
    // 300 of 600 pixels; 400 of 600, from 90° across 800; too wide.
    assert!((zooms[0] - 12.0).abs() < 1e-12 && (zooms[1] - 16.0).abs() < 1e-12 && zooms[2] == 1.0);
    assert_eq!(poses[0].view(), DVec3::NEG_Z);

    // The old viewer in the browser: column by column, times as shares of the whole.
    let key = |x: f64, time: f64| {
        format!(
            "{{\"matrix\": \"[1,0,0,0, 0,0,1,0, 0,-1,0,0, {x},2,3,1]\", \"fov\": 90, \
             \"properties\": \"[[\\\"FOV\\\",90],[\\\"TIME\\\",{time}]]\"}}"
        )
    };
    let text = format!(
        "{{\"keyframes\": [{}, {}], \"camera_path\": [], \"fps\": 10, \"seconds\": 2, \
         \"camera_type\": \"fisheye\", \"is_cycle\": true, \"crop\": {{}}}}",
        key(1.0, 0.0),
        key(3.0, 1.0)
    );
    let (losses, poses) = told("nerfstudio", &text);
    assert_eq!(
        losses,
        [
            "its viewer joins the keys by a spline of its own",
            "camera_type fisheye is not taken, 2 of it",
            "crop is not taken, 1 of it",
        ]
    );
    assert_eq!(poses.len(), 21);
    // There in the first second, back in the second.
    for (frame, x) in [(0, 1.0), (10, 3.0), (20, 1.0)] {
        assert!(poses[frame].position().distance(DVec3::new(x, 2.0, 3.0)) < 1e-12);
    }
    // Its z axis is −y of the world, so it looks along y, z upright.
    assert!(poses[0].view().distance(DVec3::Y) < 1e-12 && poses[0].up().distance(DVec3::Z) < 1e-12);
    assert!((poses[0].zoom - 12.0).abs() < 1e-12);
}

/// Recorded times: how many poses there are in a second, and when they begin.
#[test]
fn times_of_a_recording_are_told_and_put_back() {
    let line = |n: u32| {
        let jitter = if n.is_multiple_of(3) { 0.004 } else { 0.0 };
        let time = 1_305_031_102.25 + f64::from(n) / 30.0 + jitter;
        format!("{time:.4} {n} 0 0 0 0 0 1\n")
    };
    let text: String = (0..40).map(line).collect();
    let source = Source::of_bytes("file", text.into());
    let tum = by_name("tum").unwrap();
    let read = import(&source, Some(tum), &options("as=keys")).unwrap();
    assert_eq!(read.document.info.fps, 30.0);
    let epoch = 1_305_031_102.254;
    let losses = read.report.losses();
    assert!(losses.contains(&Loss::Epoch(epoch)), "{losses:?}");
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("back.tum");
    let start = options(&format!("start={epoch}"));
    written(&read.document, "tum", &file, &start);
    let back = std::fs::read_to_string(&file).unwrap();
    let times: Vec<f64> = back
        .lines()
        .skip(1)
        .map(|line| line.split(' ').next().unwrap().parse().unwrap())
        .collect();
    assert_eq!(times[0], epoch);
    assert!((times[30] - epoch - 1.0).abs() < 1e-6);
    for (rate, told) in [(29.97, 30_000.0 / 1001.0), (24.9, 24.9), (60.0, 60.0)] {
        let line = |n: u32| format!("{:.7} {n} 0 0 0 0 0 1\n", f64::from(n) / rate);
        let text: String = (0..600).map(line).collect();
        let source = Source::of_bytes("file", format!("\u{feff}{text}").into());
        let read = import(&source, Some(tum), &options("as=keys")).unwrap();
        assert!((read.document.info.fps - told).abs() < 1e-3, "{rate}");
        import(&source, Some(tum), &options("")).unwrap();
    }
    // Keys of a viewer are no recording.
    let sparse = Source::of_bytes("file", b"0 0 0 0 0 0 0 1\n4 1 0 0 0 0 0 1\n".to_vec());
    let read = import(&sparse, Some(tum), &options("as=keys")).unwrap();
    assert_eq!(read.document.info.fps, 25.0);
}

/// All files of a folder are new, or none is; a folder is not made for nothing.
#[test]
fn a_folder_is_written_wholly_or_not_at_all() {
    let folder = tempfile::tempdir().unwrap();
    let colmap = by_name("colmap").unwrap();
    let model = folder.path().join("model");
    std::fs::create_dir_all(model.join("points3D.txt")).unwrap();
    std::fs::write(model.join("cameras.txt"), "old").unwrap();
    let document = pyramid();
    let write = |to: &Path, options: &Options| {
        export(&document, to, colmap, options, &mut |_, _| {}).map(drop)
    };
    assert!(write(&model, &Options::default()).is_err());
    let old = std::fs::read_to_string(model.join("cameras.txt")).unwrap();
    assert_eq!(old, "old");
    assert!(!model.join("images.txt").exists());
    let fresh = folder.path().join("fresh");
    assert!(write(&fresh.join("deeper"), &Options::default()).is_err());
    assert!(!fresh.exists());
    write(&fresh, &Options::default()).unwrap();
    let source = Source::open(&fresh).unwrap();
    let tum = import(&source, by_name("tum").ok(), &Options::default());
    let said = tum.unwrap_err().to_string();
    assert!(said.ends_with("this is a directory, not a file"), "{said}");
}

/// What interpolates is missing: nothing is written as if all were well.
#[test]
fn a_host_interpolation_that_is_missing_is_no_export() {
    let text = include_str!("../../../examples/car.vid");
    let text = text.replacen("\"catmull-rom\"", "\"host:missing\"", 1);
    let document = SceneDocument::load_from(&mut text.as_bytes(), "car").unwrap();
    let folder = tempfile::tempdir().unwrap();
    for (name, file, ..) in LISTS {
        let to = folder.path().join(file);
        let format = by_name(name).unwrap();
        let refused = export(&document, &to, format, &Options::default(), &mut |_, _| {});
        let said = refused.unwrap_err().to_string();
        assert!(
            said.contains("node \"car\": channel \"position\": no interpolation"),
            "{said}"
        );
        assert!(!to.exists());
    }
}

/// The keys of `camera_path.json` alone give the same places at their times.
#[test]
fn keys_of_the_viewer_are_ours() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("camera_path.json");
    let document = pyramid();
    let losses = written(&document, "nerfstudio", &file, &Options::default());
    assert!(losses.contains(&Loss::OwnSpline));
    let mut json: serde_json::Value =
        serde_json::from_slice(&std::fs::read(&file).unwrap()).unwrap();
    let frames = json["camera_path"].as_array().unwrap().len();
    let fps = json["fps"].as_f64().unwrap();
    assert_eq!(json["seconds"].as_f64().unwrap(), frames as f64 / fps);
    json["camera_path"].take();
    let source = Source::of_bytes("keys.json", json.to_string().into());
    let read = import(&source, None, &options("as=keys")).unwrap();
    assert_eq!(read.format, "nerfstudio");
    let camera = &read.document.scene.nodes()[0];
    let keys = camera.keys().tracks()[0].frames().to_vec();
    let count = document.scene.nodes()[0]
        .path()
        .unwrap()
        .path()
        .points
        .len();
    assert!(keys.len() >= count && keys.len() < frames, "{}", keys.len());
    let (went, came) = (poses(&document, Up::Z), poses(&read.document, Up::Z));
    assert_eq!((went.len(), came.len()), (frames, frames));
    for key in keys {
        let at = key as usize - 1;
        assert!((key - key.round()).abs() < 1e-6);
        let found = differences(&went[at..=at], &came[at..=at]);
        assert!(found[0] < 1e-9 && found[1] < 1e-5, "{key}: {found:?}");
    }
}

/// A new format stands among the lists, or among those whose tests are elsewhere.
#[test]
fn every_list_is_tried() {
    const OTHERS: [&str; 14] = [
        "ascii",
        "csv",
        "json",
        "glb",
        "gltf",
        "usda",
        "vid",
        "html",
        "blender",
        "paraview",
        "vtk",
        "supersplat",
        "record3d",
        "polycam",
    ];
    let mut names: Vec<_> = formats().iter().map(|format| format.name).collect();
    let mut known: Vec<_> = LISTS.iter().map(|list| list.0).chain(OTHERS).collect();
    names.sort_unstable();
    known.sort_unstable();
    known.dedup();
    assert_eq!(names, known);
}
