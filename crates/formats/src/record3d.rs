//! The `metadata` in the `.r3d` files of Record3D (Šimoník), which record what ARKit tells of an
//! iPhone's camera: a quaternion x, y, z, w and a place for each frame, from camera to world; the camera
//! looks along −z, y is upright. It is read only.

use glam::{DQuat, DVec3};
use vides_document::error::vec_with_room;
use vides_engine::math::camera::CameraAxes;
use vides_engine::path::Up;

use super::content::{Content, Recording};
use super::error::{Cause, Result, Wanted};
use super::format::Format;
use super::lens::{Lens, Lenses};
use super::loss::Report;
use super::options::Options;
use super::source::Source;
use super::tree::{self, At};

pub(super) static RECORD3D: Format = Format {
    name: "record3d",
    title: "Record3D",
    file_names: &["metadata", "metadata.json"],
    up: Some(Up::Y),
    recognises,
    read: Some(read),
    ..Format::PLAIN
};

fn recognises(source: &Source) -> bool {
    // Its keys have no order, and each may have a number for each frame.
    source.beginning().trim_start().starts_with('{')
        && source.text().is_ok_and(|text| {
            let has = |key: &str| text.contains(key);
            has("\"poses\"") && (has("\"perFrameIntrinsicCoeffs\"") || has("\"K\":"))
        })
}

fn read(source: &Source, _: &Options, report: &mut Report) -> Result<Content> {
    let document = tree::parse(&source.bytes)?;
    let root = At::root(&document);
    let mut recording = Recording {
        up: RECORD3D.up,
        fps: root.get("fps").map(At::positive).transpose()?,
        ..Recording::default()
    };
    let mut lenses = Lenses::default();
    let poses = root.need("poses")?;
    let each = root.get("perFrameIntrinsicCoeffs");
    // Without a number it is as if it were not there.
    let each = each.filter(|each| each.value.as_array().is_none_or(|list| !list.is_empty()));
    if let Some(each) = each {
        let (poses, found) = (poses.list()?.len(), each.list()?.len());
        if found < poses {
            return Err(each.wrong(Cause::EachPose { poses, found }));
        }
    }
    for (index, pose) in poses.list()?.enumerate() {
        let [x, y, z, w, position @ ..] = pose.numbers::<7>()?;
        let zoom = match each {
            Some(each) => lens(root, each.element(index)?, false)?,
            None => root
                .get("K")
                .map_or(Ok(None), |matrix| lens(root, matrix, true))?,
        };
        let zoom = match zoom {
            Some(lens) => lenses.zoom(&lens),
            None => lenses.without(),
        };
        let (turn, position) = (DQuat::from_xyzw(x, y, z, w), DVec3::from_array(position));
        recording.push(
            pose.place()
                .pose(position, turn, CameraAxes::OpenGl, zoom)?,
        )?;
    }
    if let Some(stamps) = root.get("frameTimestamps") {
        recording.seconds = Some(seconds(stamps, recording.poses.len())?);
    }
    lenses.tell(report);
    Ok(Content::Poses(recording))
}

/// Of four numbers, or of a matrix column by column; none if the picture's size is missing.
fn lens(root: At<'_>, at: At<'_>, is_matrix: bool) -> Result<Option<Lens>> {
    let [fx, fy, cx, cy] = if is_matrix {
        let [fx, _, _, _, fy, _, cx, cy, _] = at.numbers::<9>()?;
        [fx, fy, cx, cy]
    } else {
        at.numbers()?
    };
    if !(fx > 0.0 && fy > 0.0) {
        return Err(at.expected(Wanted::PositiveNumber));
    }
    let (Some(width), Some(height)) = (root.get("w"), root.get("h")) else {
        return Ok(None);
    };
    Ok(Some(Lens {
        focal: [fx, fy],
        size: [width.positive()?, height.positive()?],
        centre: [cx, cy],
    }))
}

/// As many times as there are poses.
fn seconds(at: At<'_>, poses: usize) -> Result<Vec<f64>> {
    let list = at.list()?;
    let found = list.len();
    if found != poses {
        return Err(at.wrong(Cause::EachPose { poses, found }));
    }
    let mut seconds: Vec<f64> = vec_with_room(found)?;
    for stamp in list {
        let time = stamp.number()?;
        if seconds.last().is_some_and(|&before| time <= before) {
            return Err(stamp.wrong(Cause::Order));
        }
        seconds.push(time);
    }
    Ok(seconds)
}
