//! A script for Blender: a camera with a key a frame, the object, and those of the scene.

use std::cell::Cell;
use std::io::Write;

use vides_engine::math::camera::CameraAxes;
use vides_engine::path::Up;

use super::{data, objects};
use crate::convention::{self, Continued};
use crate::error::Result;
use crate::flight::Flight;
use crate::format::{Format, Holds};
use crate::loss::{Loss, Report};

const SCRIPT: &str = include_str!("for_blender.py");

/// The frame numbers that Blender has are 0 to this.
const LAST_FRAME: f64 = 1_048_574.0;

pub(crate) static BLENDER: Format = Format {
    name: "blender",
    title: "Blender script",
    endings: &["py"],
    up: Some(Up::Z),
    holds: Holds::Objects,
    write: Some(write),
    ..Format::PLAIN
};

fn write(flight: &mut Flight<'_>, out: &mut dyn Write, report: &mut Report) -> Result<()> {
    let first = first_frame(flight, report);
    let mut head = data::head(flight, SCRIPT, first, report)?;
    objects::push(&mut head, flight, report)?;
    data::begin_frames(&mut head);
    let continued = Cell::new(Continued::default());
    flight.write_poses(head, out, |_, text, index, pose| {
        let mut before = continued.get();
        let q = before.next(convention::rotation(pose, CameraAxes::OpenGl));
        continued.set(before);
        let [x, y, z] = pose.vrp;
        data::push_frame(text, index, &[x, y, z, q.w, q.x, q.y, q.z, pose.zoom]);
    })?;
    data::finish(SCRIPT, out)
}

/// The number of the first frame, or 1 if Blender has not all numbers from there on.
fn first_frame(flight: &Flight<'_>, report: &mut Report) -> i64 {
    let number = flight.number(0);
    let first = number.round();
    let last = |first: f64| first + (flight.count() - 1) as f64;
    if (first - number).abs() < 1e-6 && first >= 0.0 && last(first) <= LAST_FRAME {
        return first as i64;
    }
    report.add(Loss::FrameNumbers {
        first: number,
        last: LAST_FRAME,
    });
    1
}
