//! Trajectories of the TUM RGB-D benchmark (Sturm et al. 2012): a line `t x y z qx qy qz qw` a pose,
//! seconds and camera to world; the camera has x right, y down, z forward. `#` begins a comment.

use std::io::Write;

use glam::{DQuat, DVec3};
use vides_engine::math::camera::CameraAxes;

use super::content::{Content, DEFAULT_ZOOM, Recording};
use super::convention;
use super::error::{Cause, Result};
use super::flight::Flight;
use super::format::Format;
use super::loss::{Loss, Report};
use super::rows;
use super::source::Source;

pub(super) static TUM: Format = Format {
    name: "tum",
    title: "TUM",
    endings: &["tum"],
    recognises: |source| rows::first(source.beginning()).is_some_and(rows::turns_last),
    read: Some(|source, _, report| read(source, CameraAxes::OpenCv, report)),
    write: Some(|flight, out, report| {
        let head = b"# timestamp tx ty tz qx qy qz qw\n";
        write(flight, head, CameraAxes::OpenCv, out, report)
    }),
    ..Format::PLAIN
};

/// The poses of lines `t x y z qx qy qz qw`, of cameras with these axes.
pub(super) fn read(source: &Source, axes: CameraAxes, report: &mut Report) -> Result<Content> {
    let mut recording = Recording::default();
    let mut seconds: Vec<f64> = Vec::new();
    for (place, row) in rows::rows(source.text()?) {
        let [t, x, y, z, turn @ ..] = rows::numbers::<8>(&place, row)?;
        if seconds.last().is_some_and(|&before| t <= before) {
            return Err(place.wrong(Cause::Order));
        }
        let (position, turn) = (DVec3::new(x, y, z), DQuat::from_array(turn));
        recording.push(place.pose(position, turn, axes, DEFAULT_ZOOM)?)?;
        seconds.try_reserve(1)?;
        seconds.push(t);
    }
    recording.seconds = Some(seconds);
    report.add(Loss::FieldOfView);
    Ok(Content::Poses(recording))
}

/// Writes `head`, then the lines that [`read`] takes.
pub(super) fn write(
    flight: &mut Flight<'_>,
    head: &[u8],
    axes: CameraAxes,
    out: &mut dyn Write,
    report: &mut Report,
) -> Result<()> {
    report.add(Loss::FieldOfView);
    flight.write_poses(head.into(), out, |flight, text, index, pose| {
        let turn = convention::rotation(pose, axes).to_array();
        let place = [flight.options().start + flight.seconds(index)]
            .into_iter()
            .chain(pose.vrp);
        rows::push(text, place.chain(turn), " ");
        text.push(b'\n');
    })
}
