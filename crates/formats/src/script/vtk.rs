//! A script for VTK: plays the flight, writes its pictures, gives its poses.

use std::io::Write;

use super::data;
use crate::error::Result;
use crate::flight::Flight;
use crate::format::{Format, Holds};
use crate::loss::Report;

const SCRIPT: &str = include_str!("for_vtk.py");

pub(crate) static VTK: Format = Format {
    name: "vtk",
    title: "VTK script",
    endings: &["py"],
    holds: Holds::Motion,
    write: Some(write),
    ..Format::PLAIN
};

fn write(flight: &mut Flight<'_>, out: &mut dyn Write, report: &mut Report) -> Result<()> {
    let first = flight.number(0).round() as i64;
    let mut head = data::head(flight, SCRIPT, first, report)?;
    data::begin_frames(&mut head);
    flight.write_poses(head, out, |_, text, index, pose| {
        let mut row = [pose.zoom; 10];
        row[..9].copy_from_slice([pose.vrp, pose.vpn, pose.vup].as_flattened());
        data::push_frame(text, index, &row);
    })?;
    data::finish(SCRIPT, out)
}
