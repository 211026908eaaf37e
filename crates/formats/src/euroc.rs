//! Trajectories of the EuRoC data set (Burri et al. 2016), which TUM-VI and ORB-SLAM share: a line
//! `t, x, y, z, qw, qx, qy, qz` a pose, with commas, nanoseconds and the scalar first; what follows
//! are velocities and biases. The axes are those of the body, which are taken as the camera's.

use std::io::Write;

use glam::{DQuat, DVec3};
use vides_engine::math::camera::CameraAxes;

use super::content::Content;
use super::convention;
use super::error::{Cause, Result, Wanted};
use super::flight::Flight;
use super::format::Format;
use super::loss::{Loss, Report};
use super::rows;
use super::source::Source;
use super::tum::Trajectory;

pub(super) static EUROC: Format = Format {
    name: "euroc",
    title: "EuRoC",
    endings: &["euroc"],
    recognises: |source| {
        let beginning = source.beginning();
        has_heading(beginning)
            || rows::with_commas(beginning) && rows::first(beginning).is_some_and(turns_first)
    },
    read: Some(|source, _, report| read(source, report)),
    write: Some(write),
    own_times: true,
    ..Format::PLAIN
};

/// Whether the text begins with the heading of the data set.
pub(super) fn has_heading(beginning: &str) -> bool {
    let heading = beginning.lines().next().unwrap_or_default();
    heading.starts_with('#') && heading.contains("q_") && heading.contains("_w")
}

/// Whether numbers 5 to 8 are nearly a quaternion of length 1.
fn turns_first(row: [f64; 8]) -> bool {
    let [.., a, b, c, d] = row;
    (DQuat::from_xyzw(a, b, c, d).length() - 1.0).abs() < 0.1
}

fn read(source: &Source, report: &mut Report) -> Result<Content> {
    let mut trajectory = Trajectory::default();
    trajectory.recording.rounding = 1.5e-9;
    for (place, row) in rows::rows(source.text()?) {
        let mut numbers = [0.0_f64; 8];
        let mut found = 0;
        for (word, number) in rows::words(row).zip(&mut numbers) {
            *number = word
                .parse()
                .map_err(|_| place.clone().expected(Wanted::Number))?;
            found += 1;
        }
        if found < numbers.len() {
            let wanted = numbers.len();
            return Err(place.wrong(Cause::NumberCount { wanted, found }));
        }
        if !numbers.iter().all(|number| number.is_finite()) {
            return Err(place.wrong(Cause::NotFinite));
        }
        let [stamp, x, y, z, qw, qx, qy, qz] = numbers;
        let seconds = stamp / 1e9;
        let (position, turn) = (DVec3::new(x, y, z), DQuat::from_xyzw(qx, qy, qz, qw));
        trajectory.push(place, seconds, position, turn, CameraAxes::OpenCv)?;
    }
    Ok(trajectory.content(report))
}

fn write(flight: &mut Flight<'_>, out: &mut dyn Write, report: &mut Report) -> Result<()> {
    report.add(Loss::FieldOfView);
    let head = "#timestamp [ns], p_RS_R_x [m], p_RS_R_y [m], p_RS_R_z [m], \
                q_RS_w [], q_RS_x [], q_RS_y [], q_RS_z []\n";
    flight.write_poses(head.as_bytes().into(), out, |flight, text, index, pose| {
        let [qx, qy, qz, qw] = convention::rotation(pose, CameraAxes::OpenCv).to_array();
        let seconds = flight.time(index);
        // Writing into a vector cannot fail.
        let _ = write!(text, "{:.0},", seconds * 1e9);
        rows::push(text, pose.vrp.into_iter().chain([qw, qx, qy, qz]), ",");
        text.push(b'\n');
    })
}
