//! Poses of the KITTI odometry benchmark (Geiger et al. 2012): a line of 12 numbers a pose, three
//! rows of the matrix from camera to world; the camera has x right, y down, z forward. There are
//! neither times nor fields of view.

use std::io::Write;

use vides_engine::math::camera::CameraAxes;

use super::content::{Content, DEFAULT_ZOOM, Recording};
use super::convention;
use super::error::Result;
use super::flight::Flight;
use super::format::Format;
use super::loss::{Loss, Report};
use super::options::Options;
use super::rows;
use super::source::Source;

pub(super) static KITTI: Format = Format {
    name: "kitti",
    title: "KITTI",
    endings: &["kitti"],
    recognises: |source| rows::is_matrix(source.beginning()),
    read: Some(read),
    write: Some(write),
    own_times: true,
    ..Format::PLAIN
};

fn read(source: &Source, _: &Options, report: &mut Report) -> Result<Content> {
    let mut recording = Recording::default();
    for (place, row) in rows::rows(source.text()?) {
        let matrix = rows::matrix(rows::numbers(&place, row)?);
        recording.push(place.matrix(matrix, CameraAxes::OpenCv, DEFAULT_ZOOM)?)?;
    }
    report.add(Loss::Times);
    report.add(Loss::FieldOfView);
    Ok(Content::Poses(recording))
}

fn write(flight: &mut Flight<'_>, out: &mut dyn Write, report: &mut Report) -> Result<()> {
    report.add(Loss::Times);
    report.add(Loss::FieldOfView);
    flight.write_poses(Vec::new(), out, |_, text, _, pose| {
        let rows = convention::matrix(pose, CameraAxes::OpenCv).transpose();
        rows::push(text, rows.to_cols_array().into_iter().take(12), " ");
        text.push(b'\n');
    })
}
