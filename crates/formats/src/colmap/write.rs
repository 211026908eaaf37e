//! The three files as text: a camera for each focal length, an image for each pose, no points.

use std::cell::RefCell;
use std::collections::HashMap;
use std::io::Write;

use vides_document::error::can_allocate;
use vides_engine::math::camera::CameraAxes;

use crate::blocks;
use crate::convention;
use crate::error::Result;
use crate::flight::Flight;
use crate::loss::{Loss, Report};
use crate::rows;

/// Bytes that the number of a focal length may take.
const NUMBERED: usize = 48;

/// The numbers of focal lengths, from 1 in the order in which they come.
#[derive(Default)]
struct Numbers(RefCell<HashMap<u64, usize>>);

impl Numbers {
    /// The number of a zoom, and whether it is new.
    fn of(&self, zoom: f64) -> (usize, bool) {
        let mut numbers = self.0.borrow_mut();
        let next = numbers.len() + 1;
        let number = *numbers.entry(zoom.to_bits()).or_insert(next);
        (number, number == next)
    }
}

pub(super) fn cameras(flight: &mut Flight<'_>, out: &mut dyn Write, _: &mut Report) -> Result<()> {
    can_allocate(NUMBERED * flight.count())?;
    let numbers = Numbers::default();
    let head = b"# CAMERA_ID MODEL WIDTH HEIGHT FX FY CX CY\n".to_vec();
    flight.write_poses(head, out, |flight, text, _, pose| {
        if let (number, true) = numbers.of(pose.zoom) {
            let [width, height] = flight.pixels();
            let focal = flight.focal_pixels(pose.zoom);
            let [x, y] = flight.size().map(|side| 0.5 * side);
            // Writing into a vector cannot fail.
            let _ = write!(text, "{number} PINHOLE {width} {height} ");
            rows::push(text, [focal, focal, x, y], " ");
            text.push(b'\n');
        }
    })
}

pub(super) fn images(
    flight: &mut Flight<'_>,
    out: &mut dyn Write,
    report: &mut Report,
) -> Result<()> {
    report.add(Loss::Times);
    can_allocate(NUMBERED * flight.count())?;
    let numbers = Numbers::default();
    // As wide as the last number, so that names sorted as texts are in order too.
    let digits = flight.count().to_string().len().max(5);
    let head = b"# IMAGE_ID QW QX QY QZ TX TY TZ CAMERA_ID NAME, then its points\n".to_vec();
    flight.write_poses(head, out, |_, text, index, pose| {
        let turn = convention::rotation(pose, CameraAxes::OpenCv);
        let (turn, translation) = convention::inverse(turn, pose.position());
        let image = index + 1;
        let _ = write!(text, "{image} ");
        let quaternion = [turn.w, turn.x, turn.y, turn.z];
        rows::push(
            text,
            quaternion.into_iter().chain(translation.to_array()),
            " ",
        );
        let (camera, _) = numbers.of(pose.zoom);
        let _ = writeln!(text, " {camera} frame_{image:0digits$}.png\n");
    })
}

pub(super) fn points(_: &mut Flight<'_>, out: &mut dyn Write, _: &mut Report) -> Result<()> {
    let head = b"# POINT3D_ID X Y Z R G B ERROR TRACK\n";
    out.write_all(head).map_err(blocks::failed)
}
