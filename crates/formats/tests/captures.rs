//! What captures for NeRF and splats say of their pictures and their world.

use std::fs;
use std::path::Path;

use vides_engine::path::{Pose, Up};
use vides_formats::{Flight, Format, Imported, Loss, Options, Source, import};

const IDENTITY: &str = "[[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]";

/// The horizontal field of view of a right angle.
const ANGLE: &str = "\"camera_angle_x\": 1.5707963267948966";

fn png(size: [u32; 2]) -> Vec<u8> {
    let mut file = b"\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR".to_vec();
    size.iter().for_each(|side| file.extend(side.to_be_bytes()));
    file
}

/// With another segment before the size, as cameras write it.
fn jpeg([width, height]: [u16; 2]) -> Vec<u8> {
    let mut file = b"\xff\xd8\xff\xe1\0\x06Exif\xff\xff\xc2\0\x11\x08".to_vec();
    file.extend(height.to_be_bytes());
    file.extend(width.to_be_bytes());
    file
}

/// A file in a folder, read with options.
fn read(folder: &Path, name: &str, text: &str, options: &str) -> (Vec<f64>, Vec<Loss>) {
    fs::write(folder.join(name), text).unwrap();
    let source = Source::open(&folder.join(name)).unwrap();
    let options = Options::parse(&format!("as=keys\n{options}")).unwrap();
    let Imported {
        document, report, ..
    } = import(&source, None, &options).unwrap();
    let (as_is, mut ignored) = (Options::default(), |_, _| {});
    let as_is = Options {
        up: Some(Up::Z),
        ..as_is
    };
    let flight = Flight::new(&document, &as_is, &Format::PLAIN, &mut ignored).unwrap();
    let zooms = flight
        .all_poses()
        .unwrap()
        .iter()
        .map(|pose: &Pose| pose.zoom)
        .collect();
    let mut losses = report.losses().to_vec();
    losses.retain(|loss| *loss != Loss::Times);
    (zooms, losses)
}

/// The only zoom of `transforms.json` with these keys and one frame.
fn zoom(folder: &Path, keys: &str, frame: &str, options: &str) -> (f64, Vec<Loss>) {
    let text = format!("{{{keys}, \"frames\": [{{{frame} \"transform_matrix\": {IDENTITY}}}]}}");
    let (zooms, losses) = read(folder, "transforms.json", &text, options);
    assert_eq!(zooms.len(), 1);
    ((zooms[0] * 1e9).round() / 1e9, losses)
}

#[test]
fn an_angle_alone_is_of_a_picture_beside_the_file_or_a_square_one() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    fs::create_dir(folder.join("train")).unwrap();
    fs::write(folder.join("train/wide.png"), png([800, 400])).unwrap();
    fs::write(folder.join("train/high.jpg"), jpeg([300, 600])).unwrap();
    fs::write(folder.join("train/none.png"), b"\x89PNG\r\n\x1a\n").unwrap();
    let of = |name: &str| zoom(folder, ANGLE, &format!("\"file_path\": \"{name}\","), "");
    // The synthetic scenes of NeRF name files without their ending.
    for name in ["./train/wide", "train/wide.png"] {
        assert_eq!(of(name), (24.0, vec![]), "{name}");
    }
    assert_eq!(of("train/high.jpg"), (6.0, vec![]));
    assert_eq!(of("train/high"), (6.0, vec![]));
    let square = || vec![Loss::SquarePictures];
    for name in ["train/none", "train/missing.png", "", "train"] {
        assert_eq!(of(name), (12.0, square()), "{name}");
    }
    assert_eq!(zoom(folder, ANGLE, "", ""), (12.0, square()));
    // The file counts first, then what the user says.
    let wide = "\"file_path\": \"train/wide\",";
    let sized = format!("{ANGLE}, \"w\": 400, \"h\": 400");
    assert_eq!(zoom(folder, &sized, wide, ""), (12.0, vec![]));
    let centred = format!("{ANGLE}, \"cx\": 300, \"cy\": 100");
    assert_eq!(zoom(folder, &centred, "", ""), (36.0, vec![]));
    assert_eq!(zoom(folder, ANGLE, "", "size=1920x1080").1, []);
    assert_eq!(zoom(folder, ANGLE, "", "size=400x100"), (48.0, vec![]));
    // No square says how high a picture is in pixels.
    assert_eq!(
        zoom(folder, "\"fl_x\": 540", "", ""),
        (12.0, vec![Loss::UnknownSize])
    );
    assert_eq!(zoom(folder, "\"fl_x\": 200", wide, ""), (12.0, vec![]));
}

#[test]
fn pictures_outside_of_the_folder_are_not_opened() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("wide.png"), png([800, 400])).unwrap();
    let within = folder.path().join("capture");
    fs::create_dir(&within).unwrap();
    let frame = "\"file_path\": \"../wide.png\",";
    assert_eq!(
        zoom(&within, ANGLE, frame, ""),
        (12.0, vec![Loss::SquarePictures])
    );
}

#[test]
fn cameras_without_perspective_are_reported() {
    let folder = tempfile::tempdir().unwrap();
    let model = |name: &str| {
        let keys = format!("\"camera_model\": \"{name}\", \"fl_x\": 50, \"w\": 100, \"h\": 100");
        zoom(folder.path(), &keys, "", "")
    };
    assert_eq!(model("OPENCV"), (12.0, vec![]));
    assert_eq!(model("OPENCV_FISHEYE"), (12.0, vec![Loss::Distortion(1)]));
    let not_taken = Loss::NotTaken {
        what: "camera_model EQUIRECTANGULAR".into(),
        count: 1,
    };
    assert_eq!(
        model("EQUIRECTANGULAR"),
        (24.0, vec![not_taken, Loss::FieldOfView])
    );
    let ngp = format!("{ANGLE}, \"w\": 9, \"h\": 9, \"is_fisheye\": true");
    assert_eq!(
        zoom(folder.path(), &ngp, "", ""),
        (12.0, vec![Loss::Distortion(1)])
    );
}

#[test]
fn worlds_that_were_transformed_are_reported() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let keys =
        |matrix: &str| format!("{ANGLE}, \"w\": 9, \"h\": 9, \"applied_transform\": {matrix}");
    let none = keys("[[1,0,0,0],[0,1,0,0],[0,0,1,0]]");
    assert_eq!(zoom(folder, &none, "", ""), (12.0, vec![]));
    let turned = keys("[[0,1,0,0],[1,0,0,0],[0,0,-1,0]]");
    assert_eq!(
        zoom(folder, &turned, "", ""),
        (12.0, vec![Loss::AppliedTransform])
    );

    let path = "{\"fps\": 24, \"camera_path\": \
                [{\"camera_to_world\": [1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1], \"fov\": 90}]}";
    let losses = || read(folder, "camera_path.json", path, "").1;
    assert_eq!(losses(), []);
    let beside = folder.join("dataparser_transforms.json");
    fs::write(
        &beside,
        "{\"transform\": [[1,0,0,0],[0,1,0,0],[0,0,1,0]], \"scale\": 0.25}",
    )
    .unwrap();
    assert_eq!(losses(), [Loss::NormalisedWorld(0.25)]);
    fs::write(&beside, "{\"scale\": \"a\"}").unwrap();
    assert_eq!(losses(), []);
}
