//! Animation paths of OpenSceneGraph: a line `t x y z qx qy qz qw` a pose, seconds and camera to
//! world; the camera looks along −z. OpenSceneGraph takes no comments.

use vides_engine::math::camera::CameraAxes;

use super::format::Format;
use super::{rows, tum};

pub(super) static OSG: Format = Format {
    name: "osg",
    title: "OpenSceneGraph",
    endings: &["path"],
    recognises: |source| {
        let text = source.beginning();
        // The same columns as TUM's, whose recordings are called CameraTrajectory.txt.
        let is_txt = source.name.to_ascii_lowercase().ends_with(".txt");
        !is_txt && !text.contains('#') && rows::first(text).is_some_and(rows::turns_last)
    },
    read: Some(|source, _, report| tum::read(source, CameraAxes::OpenGl, report)),
    write: Some(|flight, out, report| tum::write(flight, b"", CameraAxes::OpenGl, out, report)),
    own_times: true,
    ..Format::PLAIN
};
