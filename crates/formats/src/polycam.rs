//! Cameras of a capture by Polycam, a file of JSON for each picture, named by the microsecond: the
//! matrix of ARKit from camera to world and focal lengths in pixels; the camera looks along −z, y is
//! upright. They are read only, one or a folder of them.

use glam::DMat4;
use vides_engine::limits::MAX_FILE_BYTES;
use vides_engine::math::camera::CameraAxes;
use vides_engine::path::Up;

use super::content::{Content, Recording};
use super::error::{Error, Result};
use super::format::Format;
use super::lens::{Lens, Lenses};
use super::loss::{Loss, Report};
use super::options::Options;
use super::source::Source;
use super::tree::{self, At};

pub(super) static POLYCAM: Format = Format {
    name: "polycam",
    title: "Polycam",
    up: Some(Up::Y),
    recognises,
    read: Some(read),
    reads_folder: true,
    ..Format::PLAIN
};

const KEYS: [[&str; 4]; 3] = [
    ["t_00", "t_01", "t_02", "t_03"],
    ["t_10", "t_11", "t_12", "t_13"],
    ["t_20", "t_21", "t_22", "t_23"],
];

fn recognises(source: &Source) -> bool {
    if source.is_folder {
        return source.first_of(is_camera).as_ref().is_some_and(recognises);
    }
    let text = source.beginning();
    text.trim_start().starts_with('{')
        && ["\"t_00\"", "\"fx\""].iter().all(|key| text.contains(key))
}

fn is_camera(name: &str) -> bool {
    let stem = name.strip_suffix(".json").unwrap_or_default();
    !stem.is_empty() && stem.bytes().all(|byte| byte.is_ascii_digit())
}

fn read(source: &Source, _: &Options, report: &mut Report) -> Result<Content> {
    let mut recording = Recording {
        up: POLYCAM.up,
        ..Recording::default()
    };
    let mut lenses = Lenses::default();
    if source.is_folder {
        let mut seconds: Vec<f64> = Vec::new();
        for name in source.names(is_camera)? {
            let bytes = source.beside(&name, MAX_FILE_BYTES)?;
            let pushed = push(&bytes, &mut recording, &mut lenses);
            pushed.map_err(|error: Error| error.at(&format!("{}/{name}", source.name)))?;
            seconds.try_reserve(1)?;
            seconds.extend(Source::number_of(&name).map(|stamp| stamp / 1e6));
        }
        recording.seconds = Some(seconds).filter(|seconds| seconds.is_sorted_by(|a, b| a < b));
    } else {
        push(&source.bytes, &mut recording, &mut lenses)?;
    }
    if recording.seconds.is_none() {
        report.add(Loss::Times);
    }
    lenses.tell(report);
    Ok(Content::Poses(recording))
}

fn push(bytes: &[u8], recording: &mut Recording, lenses: &mut Lenses) -> Result<()> {
    let document = tree::parse(bytes)?;
    let root = At::root(&document);
    let mut rows = DMat4::IDENTITY.to_cols_array_2d();
    for (row, keys) in rows.iter_mut().zip(KEYS) {
        for (number, key) in row.iter_mut().zip(keys) {
            *number = root.need(key)?.number()?;
        }
    }
    let positive = |key| root.need(key)?.positive();
    let number = |key| root.need(key)?.number();
    let zoom = lenses.zoom(&Lens {
        focal: [positive("fx")?, positive("fy")?],
        size: [positive("width")?, positive("height")?],
        centre: [number("cx")?, number("cy")?],
    });
    let matrix = DMat4::from_cols_array_2d(&rows).transpose();
    recording.push(root.pose(matrix, CameraAxes::OpenGl, zoom)?)
}
