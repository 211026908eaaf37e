//! The binary files are made by hand here; `tests/formats/pose_lists.py` has COLMAP write them.

use std::path::Path;

use glam::DVec3;
use vides_document::SceneDocument;

use super::*;
use crate::content::Recording;
use crate::loss::Loss;
use crate::{by_name, export, read};

const CAMERAS: &str = "# a comment\n\n7 PINHOLE 800 600 450 450 400 300\n\
                       8 OPENCV 800 600 300 300 410 300 0.1 0 0 0\n";
const IMAGES: &str = "3 1 0 0 0 -1 0 0 7 frame 10.png\n\n\
                      9 0 1 0 0 0 0 2 8 frame 9.png\n1 2 -1 3 4 5\n";
const POINTS: &str = "1 5 6 7 0 0 0 0.5 3 0\n";

fn folder(ending: &str, files: [&[u8]; 3]) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    for (name, content) in ["cameras", "images", "points3D"].iter().zip(files) {
        std::fs::write(folder.path().join(format!("{name}.{ending}")), content).unwrap();
    }
    folder
}

fn recording(file: &Path) -> Result<(Recording, Report)> {
    let mut report = Report::default();
    let source = Source::open(file)?;
    let (name, content) = read(&source, None, &Options::default(), &mut report)?;
    assert_eq!(name, "colmap");
    match content {
        Content::Poses(recording) => Ok((recording, report)),
        Content::Scene(_) => panic!("a list of poses"),
    }
}

/// The same model as the texts.
fn binaries() -> [Vec<u8>; 3] {
    let numbers = |file: &mut Vec<u8>, numbers: &[f64]| {
        numbers
            .iter()
            .for_each(|number| file.extend(number.to_le_bytes()));
    };
    let mut cameras = 2_u64.to_le_bytes().to_vec();
    for (id, kind, parameters) in [
        (7_u32, 1_u32, &[450.0, 450.0, 400.0, 300.0][..]),
        (8, 4, &[300.0, 300.0, 410.0, 300.0, 0.1, 0.0, 0.0, 0.0]),
    ] {
        cameras.extend(id.to_le_bytes());
        cameras.extend(kind.to_le_bytes());
        cameras.extend(800_u64.to_le_bytes());
        cameras.extend(600_u64.to_le_bytes());
        numbers(&mut cameras, parameters);
    }
    let mut images = 2_u64.to_le_bytes().to_vec();
    for (id, pose, camera, name, points) in [
        (
            3_u32,
            [1.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0],
            7_u32,
            "frame 10.png",
            0,
        ),
        (9, [0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 2.0], 8, "frame 9.png", 2),
    ] {
        images.extend(id.to_le_bytes());
        numbers(&mut images, &pose);
        images.extend(camera.to_le_bytes());
        images.extend(name.as_bytes());
        images.push(0);
        images.extend((points as u64).to_le_bytes());
        images.extend(vec![1; 24 * points]);
    }
    let mut points = 1_u64.to_le_bytes().to_vec();
    points.extend(1_u64.to_le_bytes());
    numbers(&mut points, &[5.0, 6.0, 7.0]);
    points.extend([0; 3]);
    numbers(&mut points, &[0.5]);
    points.extend(1_u64.to_le_bytes());
    points.extend([0; 8]);
    [cameras, images, points]
}

#[test]
fn text_and_binary_are_one_model_in_the_order_of_names() {
    let text = folder(
        "txt",
        [CAMERAS.as_bytes(), IMAGES.as_bytes(), POINTS.as_bytes()],
    );
    let (read, report) = recording(text.path()).unwrap();
    let [nine, ten] = &*read.poses else {
        panic!("two poses")
    };
    // Half a turn about x; the camera is where world to camera takes to 0.
    assert!(nine.position().distance(DVec3::new(0.0, 0.0, 2.0)) < 1e-15);
    assert!(nine.view().distance(DVec3::NEG_Z) < 1e-15 && nine.up().distance(DVec3::Y) < 1e-15);
    assert!((nine.zoom - 12.0).abs() < 1e-12 && (ten.zoom - 18.0).abs() < 1e-12);
    assert_eq!(ten.position(), DVec3::X);
    assert!(ten.view().distance(DVec3::Z) < 1e-15 && ten.up().distance(DVec3::NEG_Y) < 1e-15);
    assert_eq!(read.points, [DVec3::new(5.0, 6.0, 7.0)]);
    let losses = [Loss::OffCentre(1), Loss::Distortion(1), Loss::Times];
    assert_eq!(report.losses(), losses);

    let files = binaries();
    let binary = folder("bin", [&files[0], &files[1], &files[2]]);
    assert_eq!(recording(binary.path()).unwrap(), (read.clone(), report));
    // A file stands for its folder.
    assert_eq!(recording(&text.path().join("images.txt")).unwrap().0, read);
    // Of both COLMAP takes the binary ones; nothing is written beside them.
    std::fs::write(binary.path().join("cameras.txt"), "wrong").unwrap();
    std::fs::write(binary.path().join("images.txt"), "wrong").unwrap();
    assert_eq!(recording(binary.path()).unwrap().0, read);
    let scene = SceneDocument::from_toml(
        "version = 1\n[[point]]\nposition = [0, 0, 0]\n[[point]]\nposition = [0.5, 0, 0]\n",
    )
    .unwrap();
    let format = by_name("colmap").unwrap();
    let error = export(
        &scene,
        binary.path(),
        format,
        &Options::default(),
        &mut |_, _| {},
    );
    let said = error.unwrap_err().to_string();
    assert!(
        said.ends_with("cameras.bin lies there too and would be read first: move it away"),
        "{said}"
    );
    assert_eq!(
        std::fs::read(binary.path().join("images.txt")).unwrap(),
        b"wrong"
    );
}

/// What COLMAP has reconstructed is not replaced by a file without points.
#[test]
fn points_that_are_there_stay() {
    let scene = SceneDocument::from_toml(
        "version = 1\n[[point]]\nposition = [0, 0, 0]\n[[point]]\nposition = [0.5, 0, 0]\n",
    )
    .unwrap();
    let folder = tempfile::tempdir().unwrap();
    let points = folder.path().join("points3D.txt");
    let written = |to: &Path| {
        let format = by_name("colmap").unwrap();
        export(&scene, to, format, &Options::default(), &mut |_, _| {})
    };
    for text in ["", "# POINT3D_ID\n\n"] {
        std::fs::write(&points, text).unwrap();
        written(folder.path()).unwrap();
    }
    let text = "# POINT3D_ID\n1 0 0 0 255 255 255 0.1 1 0\n";
    std::fs::write(&points, text).unwrap();
    let images = std::fs::read(folder.path().join("images.txt")).unwrap();
    for to in [folder.path(), &folder.path().join("images.txt")] {
        let said = written(to).unwrap_err().to_string();
        assert!(
            said.ends_with(
                "points3D.txt there has data that would be lost: write into another folder"
            ),
            "{said}"
        );
        assert_eq!(std::fs::read_to_string(&points).unwrap(), text);
    }
    assert_eq!(
        std::fs::read(folder.path().join("images.txt")).unwrap(),
        images
    );
}

#[test]
fn points_are_shown() {
    let text = folder(
        "txt",
        [CAMERAS.as_bytes(), IMAGES.as_bytes(), POINTS.as_bytes()],
    );
    let options = Options::parse("as=keys").unwrap();
    let read = crate::import(&Source::open(text.path()).unwrap(), None, &options).unwrap();
    let object = &read.document.info.object;
    assert_eq!(
        (object.len(), object[0].position),
        (1, DVec3::new(5.0, 6.0, 7.0))
    );
    let space = read.document.scene.space();
    assert!((object[0].position - space.centre).abs().max_element() <= space.half_size);
}

#[test]
fn broken_models_are_refused_with_file_and_place() {
    for (cameras, images, said) in [
        (
            CAMERAS,
            "3 1 0 0 0 0 0 0 5 a\n",
            "images.txt: line 1: camera 5 is not there",
        ),
        (
            CAMERAS,
            "3 1 0 0 0 0 0 0 7",
            "images.txt: line 1: expected a text",
        ),
        (
            CAMERAS,
            "3 0 0 0 0 0 0 0 7 a",
            "images.txt: line 1: the rotation is zero",
        ),
        (
            CAMERAS,
            "3 1 0 0 inf 0 0 0 7 a",
            "images.txt: line 1: the number must be finite",
        ),
        (
            CAMERAS,
            "3 1 0 0 0 0 0 0 7 a\n4 1 0 0 0 0 0 0 7 b\n",
            "images.txt: line 2: expected the points of the image before, or an empty line",
        ),
        (
            "1 SPHERE 3 3 1",
            IMAGES,
            "cameras.txt: line 1: the camera model SPHERE is not read",
        ),
        (
            "1 PINHOLE 3 3 1 1 1",
            IMAGES,
            "cameras.txt: line 1: expected 4 numbers, found 3",
        ),
        (
            "1 PINHOLE 3 3 0 1 1 1",
            IMAGES,
            "cameras.txt: line 1: expected a number greater than 0",
        ),
        (
            "-1 PINHOLE 3 3 0 1 1 1",
            IMAGES,
            "cameras.txt: line 1: expected a whole number",
        ),
    ] {
        let folder = folder("txt", [cameras.as_bytes(), images.as_bytes(), b""]);
        let error = recording(folder.path()).unwrap_err().to_string();
        assert!(error.ends_with(said), "{error}");
    }
}

/// Every count is tried as the largest there is, every file is cut off everywhere.
#[test]
fn counts_are_believed_as_far_as_the_bytes_reach() {
    let files = binaries();
    let whole = folder("bin", [&files[0], &files[1], &files[2]]);
    for (name, file) in ["cameras.bin", "images.bin", "points3D.bin"]
        .iter()
        .zip(&files)
    {
        let place = whole.path().join(name);
        for length in 0..file.len() {
            std::fs::write(&place, &file[..length]).unwrap();
            let error = recording(whole.path()).unwrap_err().to_string();
            assert!(error.ends_with("the file ends too early"), "{error}");
        }
        for at in 0..=file.len() - 8 {
            let mut huge = file.clone();
            huge[at..at + 8].fill(0xff);
            std::fs::write(&place, &huge).unwrap();
            if let Err(error) = recording(whole.path()) {
                assert!(!error.to_string().contains('\n'), "{error}");
            }
        }
        std::fs::write(&place, file).unwrap();
    }
    assert!(recording(whole.path()).is_ok());
}

/// Writes a model of so many images into a folder below another one.
fn put(project: &Path, name: &str, ending: &str, images: usize) {
    let folder = project.join(name);
    std::fs::create_dir_all(&folder).unwrap();
    let file = |part: &str| folder.join(format!("{part}.{ending}"));
    let mut lines = String::new();
    for at in 0..images {
        lines += &format!("{at} 1 0 0 0 0 0 0 7 {name} {at}.png\n\n");
    }
    std::fs::write(file("cameras"), CAMERAS).unwrap();
    std::fs::write(file("images"), lines).unwrap();
}

fn images(folder: &Path) -> (usize, Vec<Loss>) {
    let (read, report) = recording(folder).unwrap();
    let mut losses = report.losses().to_vec();
    losses.retain(|loss| *loss != Loss::Times);
    (read.poses.len(), losses)
}

#[test]
fn a_model_is_found_in_its_project() {
    for place in [
        "sparse/0",
        "sparse",
        "sparse/3",
        "colmap/sparse/0",
        "dense/sparse",
        "0",
    ] {
        let project = tempfile::tempdir().unwrap();
        std::fs::create_dir_all(project.path().join("images")).unwrap();
        put(project.path(), place, "txt", 2);
        assert_eq!(images(project.path()), (2, vec![]), "{place}");
        let within = project.path().join("sparse");
        if within.exists() {
            assert_eq!(images(&within), (2, vec![]), "{place}");
        }
    }
    // A model in the folder itself comes first, then those in `sparse`.
    let project = tempfile::tempdir().unwrap();
    put(project.path(), "copy", "txt", 4);
    put(project.path(), "sparse/0", "txt", 2);
    assert_eq!(images(project.path()), (2, vec![]));
    put(project.path(), "", "txt", 3);
    assert_eq!(images(project.path()), (3, vec![]));
}

#[test]
fn of_several_models_the_one_with_most_images_is_read() {
    let project = tempfile::tempdir().unwrap();
    let chosen = |name: &str, images, others| {
        vec![Loss::OtherModels {
            read: Path::new(name).display().to_string().as_str().into(),
            images,
            others,
        }]
    };
    for (name, images) in [("sparse/0", 2), ("sparse/1", 3), ("sparse/2", 3)] {
        put(project.path(), name, "txt", images);
    }
    assert_eq!(images(project.path()), (3, chosen("sparse/1", 3, 2)));
    assert_eq!(
        images(&project.path().join("sparse")),
        (3, chosen("1", 3, 2))
    );
    put(project.path(), "sparse/10", "txt", 4);
    assert_eq!(images(project.path()), (4, chosen("sparse/10", 4, 3)));
    // Of a binary model the count before its images decides.
    let [cameras, mut many, _] = binaries();
    let binary = project.path().join("sparse/11");
    std::fs::create_dir(&binary).unwrap();
    std::fs::write(binary.join("cameras.bin"), cameras).unwrap();
    many[0] = 200;
    std::fs::write(binary.join("images.bin"), many).unwrap();
    let error = recording(project.path()).unwrap_err().to_string();
    assert!(error.contains("images.bin: byte "), "{error}");
}

#[cfg(unix)]
#[test]
fn a_model_outside_of_the_project_is_not_searched() {
    let [project, other] = [(); 2].map(|()| tempfile::tempdir().unwrap());
    put(other.path(), "sparse/0", "txt", 2);
    std::os::unix::fs::symlink(other.path().join("sparse"), project.path().join("sparse")).unwrap();
    let error = recording(project.path()).unwrap_err().to_string();
    assert!(error.contains("no file of a format"), "{error}");
}
