//! Animation paths of OpenSceneGraph: a line `t x y z qx qy qz qw` a pose, seconds and camera to
//! world; the camera looks along −z. OpenSceneGraph takes no comments.

use std::io::Write;

use vides_engine::math::camera::CameraAxes;

use super::content::Content;
use super::error::Result;
use super::flight::Flight;
use super::format::Format;
use super::loss::Report;
use super::options::Options;
use super::row::Row;
use super::source::Source;
use super::{rows, tum};

pub(super) struct Osg;

const ROW: Row = Row {
    name: "osg",
    title: "OpenSceneGraph",
    endings: &["path"],
    ..Row::PLAIN
};

impl Format for Osg {
    fn row(&self) -> &'static Row {
        &ROW
    }

    fn recognises(&self, source: &Source) -> bool {
        let text = source.beginning();
        !text.contains('#') && rows::first(text).is_some_and(rows::turns_last)
    }

    fn read(&self, source: &Source, _: &Options, report: &mut Report) -> Result<Content> {
        tum::read(source, CameraAxes::OpenGl, report)
    }

    fn write(
        &self,
        flight: &mut Flight<'_>,
        _: usize,
        out: &mut dyn Write,
        report: &mut Report,
    ) -> Result<()> {
        tum::write(flight, b"", CameraAxes::OpenGl, out, report)
    }
}
