//! `transforms.json` of neural radiance fields (Mildenhall et al. 2020; instant-ngp; nerfstudio): an
//! array of frames with the matrix to the world, row by row. The camera looks along −z, z is
//! up. There are no times; frames are in the order of the array.

use std::io::Write;

use vides_engine::math::camera::CameraAxes;
use vides_engine::path::{Pose, Up};

use super::content::{Content, Recording};
use super::error::Result;
use super::flight::Flight;
use super::format::Format;
use super::lens::{Lens, Lenses};
use super::loss::{Loss, Report};
use super::options::Options;
use super::source::Source;
use super::tree::{self, At};
use super::{blocks, convention, rows};

pub(super) static TRANSFORMS: Format = Format {
    name: "transforms",
    title: "NeRF transforms",
    file_names: &["transforms.json"],
    up: Some(Up::Z),
    recognises,
    read: Some(read),
    write: Some(write),
    ..Format::PLAIN
};

fn recognises(source: &Source) -> bool {
    let text = source.beginning();
    let has = |key: &str| text.contains(key);
    text.trim_start().starts_with('{')
        && has("\"frames\"")
        && ["\"transform_matrix\"", "\"camera_angle_x\"", "\"fl_x\""].map(has) != [false; 3]
}

fn read(source: &Source, options: &Options, report: &mut Report) -> Result<Content> {
    let document = tree::parse(&source.bytes)?;
    let root = At::root(&document);
    let mut recording = Recording {
        up: TRANSFORMS.up,
        ..Recording::default()
    };
    let mut lenses = Lenses::default();
    lenses.distorted = usize::from(distorted(root));
    for frame in root.need("frames")?.list()? {
        let matrix = frame.need("transform_matrix")?;
        let rows = matrix.rows()?;
        let zoom = zoom(root, frame, options, &mut lenses)?;
        lenses.distorted += usize::from(distorted(frame));
        recording.push(matrix.pose(rows, CameraAxes::OpenGl, zoom)?)?;
    }
    lenses.tell(report);
    report.add(Loss::Times);
    Ok(Content::Poses(recording))
}

fn write(flight: &mut Flight<'_>, out: &mut dyn Write, report: &mut Report) -> Result<()> {
    report.add(Loss::Times);
    let [width, height] = flight.options().size;
    let [cx, cy] = flight.size().map(|side| 0.5 * side);
    let mut head = Vec::new();
    // Writing into a vector cannot fail.
    let _ = write!(
        head,
        "{{\n  \"w\": {width},\n  \"h\": {height},\n  \"cx\": {cx:?},\n  \"cy\": {cy:?},"
    );
    // Readers take what holds for all before what a frame says.
    let all = only_zoom(flight)?;
    if let Some(zoom) = all {
        head.extend_from_slice(b"\n  ");
        push_lens(&mut head, flight, zoom);
        head.push(b',');
    }
    head.extend_from_slice(b"\n  \"frames\": [");
    flight.write_poses(head, out, |flight, text, index, pose| {
        let comma = if index == 0 { "" } else { "," };
        let name = index + 1;
        let _ = write!(
            text,
            "{comma}\n    {{\"file_path\": \"images/frame_{name:05}.png\", "
        );
        if all.is_none() {
            push_lens(text, flight, pose.zoom);
            text.extend_from_slice(b", ");
        }
        text.extend_from_slice(b"\"transform_matrix\": ");
        let rows = convention::matrix(pose, CameraAxes::OpenGl).transpose();
        rows::push_matrix(text, rows.to_cols_array_2d());
        text.push(b'}');
    })?;
    out.write_all(b"\n  ]\n}\n").map_err(blocks::failed)
}

/// The zoom of a frame: by its own numbers or those of all; by focal lengths rather than by angles,
/// by what is vertical rather than by what is horizontal. Pictures of unknown size are as the
/// options say.
fn zoom(root: At<'_>, frame: At<'_>, options: &Options, lenses: &mut Lenses) -> Result<f64> {
    let own = ["fl_x", "fl_y", "camera_angle_x", "camera_angle_y"];
    let at = if own.iter().any(|key| frame.get(key).is_some()) {
        frame
    } else {
        root
    };
    let number = |key| at.get(key).map(At::positive).transpose();
    let of_all = |key| frame.get(key).or(root.get(key));
    let size = |key, other: u32| of_all(key).map_or(Ok(f64::from(other)), At::positive);
    let size = [size("w", options.size[0])?, size("h", options.size[1])?];
    let focal = match (number("fl_x")?, number("fl_y")?) {
        (Some(x), Some(y)) => Some([x, y]),
        (x, y) => x.or(y).map(|focal| [focal; 2]),
    };
    if let (None, Some(angle)) = (focal, number("camera_angle_y")?) {
        return Ok(lenses.clamped(convention::zoom_of_field(angle)));
    }
    let across = number("camera_angle_x")?;
    let across = across.map(|angle| [convention::focal_of_width(angle, size[0]); 2]);
    let Some(focal) = focal.or(across) else {
        return Ok(lenses.without());
    };
    let centre = |key, side: f64| of_all(key).map_or(Ok(0.5 * side), At::number);
    Ok(lenses.zoom(&Lens {
        focal,
        size,
        centre: [centre("cx", size[0])?, centre("cy", size[1])?],
    }))
}

/// Whether there are coefficients of distortion, or a model of a camera that bends lines.
fn distorted(at: At<'_>) -> bool {
    let number = |key: &str| at.get(key).and_then(|at| at.value.as_f64());
    let bends = |key: &&str| number(key).is_some_and(|number| number != 0.0);
    let keys = ["k1", "k2", "k3", "k4", "p1", "p2"];
    let model = at.get("camera_model").and_then(|at| at.value.as_str());
    keys.iter().any(bends)
        || model.is_some_and(|model| model.contains("FISHEYE") || model == "EQUIRECTANGULAR")
}

/// The zoom of all frames, if it is one.
fn only_zoom(flight: &Flight<'_>) -> Result<Option<f64>> {
    let mut block = [Pose::default(); 64];
    flight.poses(0, &mut block[..1])?;
    let zoom = block[0].zoom;
    for from in (0..flight.count()).step_by(block.len()) {
        let count = block.len().min(flight.count() - from);
        flight.poses(from, &mut block[..count])?;
        if block[..count].iter().any(|pose| pose.zoom != zoom) {
            return Ok(None);
        }
    }
    Ok(Some(zoom))
}

fn push_lens(text: &mut Vec<u8>, flight: &Flight<'_>, zoom: f64) {
    let focal = flight.focal_pixels(zoom);
    let angle = convention::width_of_focal(focal, flight.size()[0]);
    let _ = write!(
        text,
        "\"camera_angle_x\": {angle:?}, \"fl_x\": {focal:?}, \"fl_y\": {focal:?}"
    );
}
