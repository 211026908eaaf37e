//! Trajectories of the TUM RGB-D benchmark (Sturm et al. 2012): a line `t x y z qx qy qz qw` a pose,
//! seconds and camera to world; the camera has x right, y down, z forward.

use std::io::Write;

use glam::{DQuat, DVec3};

use super::content::{Content, DEFAULT_ZOOM, Recording};
use super::convention;
use super::error::Result;
use super::flight::Flight;
use super::format::{Format, Row};
use super::loss::{Loss, Report};
use super::options::Options;
use super::rows;
use super::source::Source;
use crate::math::camera::CameraAxes;

pub(super) struct Tum;

const ROW: Row = Row {
    name: "tum",
    title: "TUM",
    endings: &["tum"],
    ..Row::PLAIN
};

impl Format for Tum {
    fn row(&self) -> &'static Row {
        &ROW
    }

    fn recognises(&self, source: &Source) -> bool {
        rows::width(source.beginning()) == Some(8)
    }

    fn read(&self, source: &Source, _: &Options, report: &mut Report) -> Result<Content> {
        let mut recording = Recording::default();
        let mut seconds = Vec::new();
        for (place, row) in rows::rows(source.text()?) {
            let [t, x, y, z, i, j, k, w] = rows::numbers(&place, row)?;
            let turn = DQuat::from_xyzw(i, j, k, w);
            recording.push(place.pose(
                DVec3::new(x, y, z),
                turn,
                CameraAxes::OpenCv,
                DEFAULT_ZOOM,
            )?)?;
            seconds.try_reserve(1)?;
            seconds.push(t);
        }
        recording.seconds = Some(seconds);
        report.add(Loss::FieldOfView);
        Ok(Content::Poses(recording))
    }

    fn write(
        &self,
        flight: &mut Flight<'_>,
        _: usize,
        out: &mut dyn Write,
        report: &mut Report,
    ) -> Result<()> {
        flight.needs_camera()?;
        flight.tell_poses_only(report);
        report.add(Loss::FieldOfView);
        flight.write_poses(Vec::new(), out, |flight, text, index, pose| {
            let [x, y, z] = pose.vrp;
            let q = convention::rotation(pose, CameraAxes::OpenCv);
            // Writing into a vector cannot fail.
            let _ = writeln!(
                text,
                "{:?} {x:?} {y:?} {z:?} {:?} {:?} {:?} {:?}",
                flight.seconds(index),
                q.x,
                q.y,
                q.z,
                q.w
            );
        })
    }
}
