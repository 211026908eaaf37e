//! A script for VTK: plays the flight, writes its pictures, gives its poses.

use std::io::Write;

use super::data;
use crate::error::Result;
use crate::flight::Flight;
use crate::format::Format;
use crate::loss::Report;
use crate::row::Row;

const SCRIPT: &str = include_str!("for_vtk.py");

pub(crate) struct Vtk;

const ROW: Row = Row {
    name: "vtk",
    title: "VTK script",
    endings: &["py"],
    reads: false,
    ..Row::PLAIN
};

impl Format for Vtk {
    fn row(&self) -> &'static Row {
        &ROW
    }

    fn write(
        &self,
        flight: &mut Flight<'_>,
        _: usize,
        out: &mut dyn Write,
        report: &mut Report,
    ) -> Result<()> {
        flight.needs_camera()?;
        flight.tell_motion(report);
        let first = flight.number(0).round() as i64;
        let head = data::head(flight, SCRIPT, first, report);
        flight.write_poses(head, out, |_, text, index, pose| {
            let mut row = [pose.zoom; 10];
            row[..9].copy_from_slice([pose.vrp, pose.vpn, pose.vup].as_flattened());
            data::push_frame(text, index, &row);
        })?;
        data::finish(SCRIPT, out)
    }
}
