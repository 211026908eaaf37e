//! Camera trajectories of Open3D (Zhou et al. 2018): JSON of the matrices from world to camera, column
//! by column, with focal lengths in pixels; and `.log` files of the Redwood data set, a line of three
//! numbers and four of the matrix from camera to world for each pose. The camera has x right, y down,
//! z forward. There are no times.

use std::io::Write;

use glam::{DMat3, DMat4};
use vides_engine::math::camera::CameraAxes;

use super::content::{Content, DEFAULT_ZOOM, Recording};
use super::error::{Cause, Result, Wanted};
use super::flight::Flight;
use super::format::Format;
use super::lens::{Lens, Lenses};
use super::loss::{Loss, Report};
use super::options::Options;
use super::source::Source;
use super::tree::{self, At};
use super::{blocks, convention, matrices, rows};

pub(super) static OPEN3D: Format = Format {
    name: "open3d",
    title: "Open3D",
    file_names: &["camera_trajectory.json"],
    recognises,
    read: Some(read),
    write: Some(write),
    by_ending: &[("log", write_log)],
    ..Format::PLAIN
};

/// Open3D takes the centre of the first pixel as 0.
const PIXEL_CENTRE: f64 = 0.5;

fn recognises(source: &Source) -> bool {
    let text = source.beginning();
    if text.trim_start().starts_with('{') {
        let kinds = ["\"PinholeCameraTrajectory\"", "\"PinholeCameraParameters\""];
        return kinds.iter().any(|kind| text.contains(kind));
    }
    let mut lines = rows::rows(text);
    rows::first::<3>(text).is_some()
        && lines.next().is_some()
        && lines
            .next()
            .is_some_and(|first| matrices::of_four_lines(first, &mut lines).is_ok())
}

fn read(source: &Source, _: &Options, report: &mut Report) -> Result<Content> {
    report.add(Loss::Times);
    let text = source.text()?;
    if text.trim_start().starts_with(['{', '[']) {
        return read_json(&source.bytes, report);
    }
    report.add(Loss::FieldOfView);
    let mut recording = Recording::default();
    let mut lines = rows::rows(text);
    while let Some((place, row)) = lines.next() {
        let _: [f64; 3] = rows::numbers(&place, row)?;
        let first = lines.next().ok_or_else(|| place.wrong(Cause::End))?;
        let place = first.0.clone();
        let matrix = matrices::of_four_lines(first, &mut lines)?;
        recording.push(place.matrix(matrix, CameraAxes::OpenCv, DEFAULT_ZOOM)?)?;
    }
    Ok(Content::Poses(recording))
}

fn read_json(bytes: &[u8], report: &mut Report) -> Result<Content> {
    let document = tree::parse(bytes)?;
    let root = At::root(&document);
    let mut recording = Recording::default();
    let mut lenses = Lenses::default();
    let mut push = |camera: At<'_>| -> Result<()> {
        let at = camera.need("extrinsic")?;
        let place = at.place();
        let columns = DMat4::from_cols_array(&at.numbers()?);
        let matrix = matrices::of_rows(&place, columns.transpose().to_cols_array())?;
        // Only what turns has an inverse.
        place
            .clone()
            .matrix(matrix, CameraAxes::OpenCv, DEFAULT_ZOOM)?;
        let zoom = zoom(camera, &mut lenses)?;
        recording.push(place.matrix(matrix.inverse(), CameraAxes::OpenCv, zoom)?)
    };
    // A screenshot's camera stands alone.
    if root.get("extrinsic").is_some() {
        push(root)?;
    } else {
        root.need("parameters")?.list()?.try_for_each(push)?;
    }
    lenses.tell(report);
    Ok(Content::Poses(recording))
}

fn zoom(camera: At<'_>, lenses: &mut Lenses) -> Result<f64> {
    let Some(intrinsic) = camera.get("intrinsic") else {
        return Ok(lenses.without());
    };
    let size = [
        intrinsic.need("width")?.positive()?,
        intrinsic.need("height")?.positive()?,
    ];
    let at = intrinsic.need("intrinsic_matrix")?;
    let columns = DMat3::from_cols_array(&at.numbers()?);
    let focal = [columns.x_axis.x, columns.y_axis.y];
    if !(focal[0] > 0.0 && focal[1] > 0.0) {
        return Err(at.expected(Wanted::PositiveNumber));
    }
    // Half of all programs count from a corner.
    let centre = |axis: usize| {
        let (found, half) = (columns.z_axis[axis] + PIXEL_CENTRE, 0.5 * size[axis]);
        if (found - half).abs() <= PIXEL_CENTRE {
            half
        } else {
            found
        }
    };
    let centre = [centre(0), centre(1)];
    Ok(lenses.zoom(&Lens {
        focal,
        size,
        centre,
    }))
}

fn write(flight: &mut Flight<'_>, out: &mut dyn Write, report: &mut Report) -> Result<()> {
    report.add(Loss::Times);
    let [width, height] = flight.pixels();
    let [cx, cy] = flight.size().map(|side| 0.5 * side - PIXEL_CENTRE);
    let head = "{\n  \"class_name\": \"PinholeCameraTrajectory\",\n  \"version_major\": 1,\n  \
                \"version_minor\": 0,\n  \"parameters\": [";
    flight.write_poses(head.into(), out, |flight, text, index, pose| {
        let comma = if index == 0 { "" } else { "," };
        // Writing into a vector cannot fail.
        let _ = write!(
            text,
            "{comma}\n    {{\"class_name\": \"PinholeCameraParameters\", \"version_major\": 1, \
             \"version_minor\": 0, \"extrinsic\": ["
        );
        let turn = convention::rotation(pose, CameraAxes::OpenCv);
        let (turn, place) = convention::inverse(turn, pose.position());
        let columns = DMat4::from_rotation_translation(turn, place);
        rows::push(text, columns.to_cols_array(), ", ");
        let focal = flight.focal_pixels(pose.zoom);
        let _ = write!(
            text,
            "], \"intrinsic\": {{\"width\": {width}, \"height\": {height}, \"intrinsic_matrix\": \
             [{focal:?}, 0.0, 0.0, 0.0, {focal:?}, 0.0, {cx:?}, {cy:?}, 1.0]}}}}"
        );
    })?;
    out.write_all(b"\n  ]\n}\n").map_err(blocks::failed)
}

fn write_log(flight: &mut Flight<'_>, out: &mut dyn Write, report: &mut Report) -> Result<()> {
    report.add(Loss::Times);
    report.add(Loss::FieldOfView);
    flight.write_poses(Vec::new(), out, |_, text, index, pose| {
        let _ = writeln!(text, "{index} {index} {}", index + 1);
        let rows = convention::matrix(pose, CameraAxes::OpenCv).transpose();
        for row in rows.to_cols_array_2d() {
            rows::push(text, row, " ");
            text.push(b'\n');
        }
    })
}
