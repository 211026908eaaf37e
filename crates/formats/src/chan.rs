//! Channel files of Nuke, which Blender and Houdini read too: a line `frame x y z rx ry rz fov` a
//! pose. The angles are degrees about the axes, turned in the order of the option
//! `rotation-order`; the field of view is the vertical one in degrees. The camera looks along −z.

use std::cell::Cell;
use std::io::Write;

use glam::DVec3;
use vides_engine::math::camera::CameraAxes;
use vides_engine::math::euler::{euler, of_euler};

use super::content::{Content, Recording};
use super::convention;
use super::error::{Cause, Result};
use super::flight::Flight;
use super::format::Format;
use super::lens::Lenses;
use super::loss::Report;
use super::options::Options;
use super::rows;
use super::source::Source;

pub(super) static CHAN: Format = Format {
    name: "chan",
    title: "Nuke",
    endings: &["chan"],
    recognises,
    read: Some(read),
    write: Some(write),
    ..Format::PLAIN
};

fn recognises(source: &Source) -> bool {
    let text = source.beginning();
    let whole = rows::first(text).is_some_and(|row| !rows::turns_last(row));
    whole || rows::first::<7>(text).is_some()
}

fn read(source: &Source, options: &Options, report: &mut Report) -> Result<Content> {
    let mut recording = Recording::default();
    let mut frames: Vec<f64> = Vec::new();
    let mut lenses = Lenses::default();
    for (place, row) in rows::rows(source.text()?) {
        let field = rows::words(row).count() != 7;
        let [frame, x, y, z, a, b, c, fov] = if field {
            rows::numbers(&place, row)?
        } else {
            let mut all = [0.0; 8];
            all[..7].copy_from_slice(&rows::numbers::<7>(&place, row)?);
            all
        };
        if frames.last().is_some_and(|&before| frame <= before) {
            return Err(place.wrong(Cause::Order));
        }
        let zoom = if field {
            lenses.clamped(convention::zoom_of_field(fov.to_radians()))
        } else {
            lenses.without()
        };
        let turn = [a, b, c].map(f64::to_radians);
        let turn = of_euler(turn, &options.rotation_order);
        let position = DVec3::new(x, y, z);
        recording.push(place.pose(position, turn, CameraAxes::OpenGl, zoom)?)?;
        frames.try_reserve(1)?;
        frames.push(frame);
    }
    recording.frames = Some(frames);
    lenses.tell(report);
    Ok(Content::Poses(recording))
}

fn write(flight: &mut Flight<'_>, out: &mut dyn Write, _: &mut Report) -> Result<()> {
    let order = flight.options().rotation_order;
    // Counted at the rate that is written, as whoever reads them counts.
    let first = flight.number(0);
    let before = Cell::new([0.0; 3]);
    flight.write_poses(Vec::new(), out, |_, text, index, pose| {
        let turn = convention::rotation(pose, CameraAxes::OpenGl);
        let mut angles = euler(turn, order).map(f64::to_degrees);
        // What is drawn between frames runs on, not once round.
        for (angle, before) in angles.iter_mut().zip(before.get()) {
            *angle += 360.0 * ((before - *angle) / 360.0).round();
        }
        before.set(angles);
        let field = convention::field_of_view(pose.zoom).to_degrees();
        let _ = write!(text, "{}\t", first + index as f64);
        let numbers = pose.vrp.into_iter().chain(angles);
        rows::push(text, numbers.chain([field]), "\t");
        text.push(b'\n');
    })
}
