//! `base_cam.json` of instant-ngp (Müller et al. 2022), the camera path of its window: a quaternion
//! x, y, z, w, a place in its cube and a vertical field of view in degrees for each key. The world is
//! that of the `transforms.json` that it was trained with, z upright.

use std::io::Write;

use glam::{DQuat, DVec3};
use vides_engine::math::camera::CameraAxes;
use vides_engine::path::Up;

use super::content::{Content, Recording};
use super::error::Result;
use super::flight::Flight;
use super::format::Format;
use super::lens::Lenses;
use super::loss::{Loss, Report};
use super::options::Options;
use super::source::Source;
use super::tree::{self, At};
use super::{blocks, convention, rows};

pub(super) static NGP: Format = Format {
    name: "instant-ngp",
    title: "instant-ngp",
    file_names: &["base_cam.json"],
    up: Some(Up::Z),
    recognises,
    read: Some(read),
    write: Some(write),
    ..Format::PLAIN
};

/// Of a path whose keys are joined by straight lines.
const LINEAR: u64 = 1;

/// Times are numbers of 32 bits.
const ROUNDING: f32 = 4e-6;

fn recognises(source: &Source) -> bool {
    let text = source.beginning();
    text.trim_start().starts_with('{')
        && ["\"path\"", "\"R\"", "\"T\""]
            .iter()
            .all(|key| text.contains(key))
}

fn read(source: &Source, _: &Options, report: &mut Report) -> Result<Content> {
    let document = tree::parse(&source.bytes)?;
    let root = At::root(&document);
    let mut recording = Recording {
        up: NGP.up,
        rounding: ROUNDING,
        ..Recording::default()
    };
    let mut lenses = Lenses::default();
    // Each key has the time at which the next one is reached.
    let mut seconds = vec![0.0];
    let mut blurred = 0;
    for key in root.need("path")?.list()? {
        let turn = key.need("R")?;
        let rotation = DQuat::from_array(turn.numbers()?);
        let position = DVec3::from_array(key.need("T")?.numbers()?);
        let zoom = match key.get("fov") {
            Some(degrees) => {
                let field = degrees.positive()?.to_radians();
                lenses.clamped(convention::zoom_of_field(field))
            }
            None => lenses.without(),
        };
        let aperture = key.get("dof").or(key.get("aperture_size"));
        let aperture = aperture.map(At::number).transpose()?;
        blurred += usize::from(aperture.is_some_and(|size| size != 0.0));
        let (rotation, position) = convention::of_ngp(rotation, position);
        let place = turn.place();
        recording.push(place.pose(position, rotation, CameraAxes::OpenCv, zoom)?)?;
        if let Some(time) = key.get("timestamp").map(At::number).transpose()? {
            seconds.try_reserve(1)?;
            seconds.push(time);
        }
    }
    let timed = seconds.len() == recording.poses.len() + 1 && seconds.is_sorted_by(|a, b| a < b);
    if timed {
        seconds.pop();
        recording.seconds = Some(seconds);
    } else {
        report.add(Loss::Times);
    }
    let order = root.get("spline_order").and_then(|at| at.value.as_u64());
    if order != Some(LINEAR) {
        report.add(Loss::OwnSpline);
    }
    lenses.tell(report);
    report.not_taken("aperture_size", blurred);
    let loops = root.get("loop").and_then(|at| at.value.as_bool());
    report.not_taken("loop", usize::from(loops == Some(true)));
    Ok(Content::Poses(recording))
}

fn write(flight: &mut Flight<'_>, out: &mut dyn Write, _: &mut Report) -> Result<()> {
    let (count, fps) = (flight.count(), flight.fps());
    let head = format!(
        "{{\n  \"loop\": false,\n  \"time\": 0.0,\n  \"duration_seconds\": {:?},\n  \
         \"spline_order\": {LINEAR},\n  \"path\": [",
        count as f64 / fps
    );
    flight.write_poses(head.into(), out, |flight, text, index, pose| {
        let comma = if index == 0 { "" } else { "," };
        let turn = convention::rotation(pose, CameraAxes::OpenCv);
        let (turn, place) = convention::to_ngp(turn, pose.position());
        // Writing into a vector cannot fail.
        let _ = write!(text, "{comma}\n    {{\"R\": [");
        rows::push(text, turn.to_array(), ", ");
        let _ = write!(text, "], \"T\": [");
        rows::push(text, place.to_array(), ", ");
        let field = convention::field_of_view(pose.zoom).to_degrees();
        let _ = write!(
            text,
            "], \"slice\": 0.0, \"scale\": 1.0, \"fov\": {field:?}, \"aperture_size\": 0.0, \
             \"timestamp\": {:?}}}",
            flight.seconds(index + 1)
        );
    })?;
    out.write_all(b"\n  ]\n}\n").map_err(blocks::failed)
}
