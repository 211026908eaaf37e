//! `cameras.json` of 3D Gaussian splatting (Kerbl et al. 2023): an array of cameras with position
//! and rotation to the world, x right, y down, z forward, and focal lengths in pixels. There are no
//! times. Many viewers of it keep no roll.

use std::io::Write;

use glam::{DMat3, DMat4, DVec3};
use vides_engine::math::camera::CameraAxes;

use super::content::{Content, Recording};
use super::error::Result;
use super::flight::Flight;
use super::format::Format;
use super::lens::{Lens, Lenses};
use super::loss::{Loss, Report};
use super::options::Options;
use super::source::Source;
use super::{blocks, convention, rows, tree};

pub(super) static CAMERAS: Format = Format {
    name: "cameras",
    title: "3D Gaussian splatting",
    file_names: &["cameras.json"],
    recognises,
    read: Some(read),
    write: Some(write),
    ..Format::PLAIN
};

fn recognises(source: &Source) -> bool {
    let text = source.beginning();
    let has = |key: &str| text.contains(key);
    text.trim_start().starts_with('[') && has("\"position\"") && has("\"rotation\"")
}

fn read(source: &Source, _: &Options, report: &mut Report) -> Result<Content> {
    let document = tree::parse(&source.bytes)?;
    let mut recording = Recording::default();
    let mut lenses = Lenses::default();
    for camera in tree::At::root(&document).list()? {
        let rotation = camera.need("rotation")?;
        let [x, y, z] = rotation.vectors()?;
        // The file has rows.
        let turn = DMat3::from_cols(x, y, z).transpose();
        let position = DVec3::from_array(camera.need("position")?.numbers()?);
        let zoom = match (camera.get("fy"), camera.get("height")) {
            (Some(fy), Some(height)) => {
                let (fy, height) = (fy.positive()?, height.positive()?);
                let fx = camera.get("fx").map_or(Ok(fy), |fx| fx.positive())?;
                lenses.zoom(&Lens {
                    focal: [fx, fy],
                    size: [height, height],
                    centre: [0.5 * height; 2],
                })
            }
            _ => lenses.without(),
        };
        let matrix = DMat4::from_mat3_translation(turn, position);
        recording.push(rotation.pose(matrix, CameraAxes::OpenCv, zoom)?)?;
    }
    lenses.tell(report);
    report.add(Loss::Times);
    Ok(Content::Poses(recording))
}

fn write(flight: &mut Flight<'_>, out: &mut dyn Write, report: &mut Report) -> Result<()> {
    report.add(Loss::Times);
    let [width, height] = flight.pixels();
    flight.write_poses(b"[".into(), out, |flight, text, index, pose| {
        let comma = if index == 0 { "" } else { "," };
        // Writing into a vector cannot fail.
        let _ = write!(
            text,
            "{comma}\n  {{\"id\": {index}, \"img_name\": \"{:05}\", \"width\": {width}, \
             \"height\": {height}, \"position\": {:?}, \"rotation\": ",
            index + 1,
            pose.vrp
        );
        let rows = DMat3::from_mat4(convention::matrix(pose, CameraAxes::OpenCv)).transpose();
        rows::push_matrix(text, rows.to_cols_array_2d());
        let focal = flight.focal_pixels(pose.zoom);
        let _ = write!(text, ", \"fx\": {focal:?}, \"fy\": {focal:?}}}");
    })?;
    out.write_all(b"\n]\n").map_err(blocks::failed)
}
