//! `transforms.json` of neural radiance fields (Mildenhall et al. 2020; instant-ngp; nerfstudio): an
//! array of frames with the matrix to the world, row by row. The camera looks along −z, z is
//! up. There are no times; frames are in the order of the array.

use std::cell::OnceCell;
use std::collections::BTreeMap;
use std::io::Write;

use glam::DMat4;
use vides_engine::math::camera::CameraAxes;
use vides_engine::path::{Pose, Up};

use super::content::{Content, Recording};
use super::error::Result;
use super::flight::Flight;
use super::format::Format;
use super::lens::{Lens, Lenses};
use super::loss::{Loss, Report};
use super::options::{DEFAULT_SIZE, Options};
use super::source::Source;
use super::tree::{self, At};
use super::{blocks, convention, picture, rows};

pub(super) static TRANSFORMS: Format = Format {
    name: "transforms",
    title: "NeRF transforms",
    file_names: &["transforms.json"],
    up: Some(Up::Z),
    recognises,
    read: Some(read),
    write: Some(write),
    ..Format::PLAIN
};

fn recognises(source: &Source) -> bool {
    let text = source.beginning();
    let has = |key: &str| text.contains(key);
    text.trim_start().starts_with('{')
        && has("\"frames\"")
        && ["\"transform_matrix\"", "\"camera_angle_x\"", "\"fl_x\""].map(has) != [false; 3]
}

fn read(source: &Source, options: &Options, report: &mut Report) -> Result<Content> {
    let document = tree::parse(&source.bytes)?;
    let root = At::root(&document);
    let mut recording = Recording {
        up: TRANSFORMS.up,
        ..Recording::default()
    };
    let mut cameras = Cameras {
        source,
        options,
        root,
        beside: OnceCell::new(),
        lenses: Lenses::default(),
    };
    cameras.lenses.distorted = usize::from(distorted(root));
    let mut panoramas: BTreeMap<&str, usize> = BTreeMap::new();
    for frame in root.need("frames")?.list()? {
        let matrix = frame.need("transform_matrix")?;
        let rows = matrix.rows()?;
        let panorama = model(frame)
            .or(model(root))
            .filter(|model| panoramic(model));
        let zoom = match panorama {
            Some(model) => {
                *panoramas.entry(model).or_default() += 1;
                cameras.lenses.without()
            }
            None => cameras.zoom(frame, report)?,
        };
        cameras.lenses.distorted += usize::from(distorted(frame));
        recording.push(matrix.pose(rows, CameraAxes::OpenGl, zoom)?)?;
    }
    for (model, count) in panoramas {
        report.not_taken(&format!("camera_model {model}"), count);
    }
    cameras.lenses.tell(report);
    if transformed(root) {
        report.add(Loss::AppliedTransform);
    }
    report.add(Loss::Times);
    Ok(Content::Poses(recording))
}

fn write(flight: &mut Flight<'_>, out: &mut dyn Write, report: &mut Report) -> Result<()> {
    report.add(Loss::Times);
    let [width, height] = flight.pixels();
    let [cx, cy] = flight.size().map(|side| 0.5 * side);
    let mut head = Vec::new();
    // Writing into a vector cannot fail.
    let _ = write!(
        head,
        "{{\n  \"w\": {width},\n  \"h\": {height},\n  \"cx\": {cx:?},\n  \"cy\": {cy:?},"
    );
    // Readers take what holds for all before what a frame says.
    let all = only_zoom(flight)?;
    if let Some(zoom) = all {
        head.extend_from_slice(b"\n  ");
        push_lens(&mut head, flight, zoom);
        head.push(b',');
    }
    head.extend_from_slice(b"\n  \"frames\": [");
    flight.write_poses(head, out, |flight, text, index, pose| {
        let comma = if index == 0 { "" } else { "," };
        let name = index + 1;
        let _ = write!(
            text,
            "{comma}\n    {{\"file_path\": \"images/frame_{name:05}.png\", "
        );
        if all.is_none() {
            push_lens(text, flight, pose.zoom);
            text.extend_from_slice(b", ");
        }
        text.extend_from_slice(b"\"transform_matrix\": ");
        let rows = convention::matrix(pose, CameraAxes::OpenGl).transpose();
        rows::push_matrix(text, rows.to_cols_array_2d());
        text.push(b'}');
    })?;
    out.write_all(b"\n  ]\n}\n").map_err(blocks::failed)
}

/// What the cameras of a file have in common, and what is known of them so far.
struct Cameras<'a> {
    source: &'a Source,
    options: &'a Options,
    root: At<'a>,
    /// Of a picture beside the file, once it was looked for.
    beside: OnceCell<Option<[f64; 2]>>,
    lenses: Lenses,
}

impl<'a> Cameras<'a> {
    /// The zoom of a frame: by its own numbers or those of all; by focal lengths rather than by
    /// angles, by what is vertical rather than by what is horizontal.
    fn zoom(&mut self, frame: At<'a>, report: &mut Report) -> Result<f64> {
        let own = ["fl_x", "fl_y", "camera_angle_x", "camera_angle_y"];
        let is_own = own.iter().any(|key| frame.get(key).is_some());
        let at = if is_own { frame } else { self.root };
        let number = |key| at.get(key).map(At::positive).transpose();
        let focal = match (number("fl_x")?, number("fl_y")?) {
            (Some(x), Some(y)) => Some([x, y]),
            (x, y) => x.or(y).map(|focal| [focal; 2]),
        };
        if let (None, Some(angle)) = (focal, number("camera_angle_y")?) {
            return Ok(self.lenses.clamped(convention::zoom_of_field(angle)));
        }
        let angle = number("camera_angle_x")?;
        if focal.is_none() && angle.is_none() {
            return Ok(self.lenses.without());
        }
        let size = match self.size(frame)? {
            Some(size) => size,
            None if focal.is_none() => {
                report.add(Loss::SquarePictures);
                [1.0; 2]
            }
            None => {
                report.add(Loss::UnknownSize);
                DEFAULT_SIZE.map(f64::from)
            }
        };
        let across = angle.map(|angle| [convention::focal_of_width(angle, size[0]); 2]);
        let focal = focal.or(across).unwrap_or(size);
        let [x, y] = self.centre(frame)?;
        Ok(self.lenses.zoom(&Lens {
            focal,
            size,
            centre: [x.unwrap_or(0.5 * size[0]), y.unwrap_or(0.5 * size[1])],
        }))
    }

    /// Of a frame or of all.
    fn of_all(&self, frame: At<'a>, key: &'a str) -> Option<At<'a>> {
        frame.get(key).or(self.root.get(key))
    }

    /// Where the axes of the pictures meet them, as far as that is said.
    fn centre(&self, frame: At<'a>) -> Result<[Option<f64>; 2]> {
        let number = |key| self.of_all(frame, key).map(At::number).transpose();
        Ok([number("cx")?, number("cy")?])
    }

    /// Width and height of a picture: as the file says, or the first one beside it, or the user;
    /// else twice what its centre is.
    fn size(&self, frame: At<'a>) -> Result<Option<[f64; 2]>> {
        let side = |key| self.of_all(frame, key).map(At::positive).transpose();
        let said = (side("w")?, side("h")?);
        if let (Some(width), Some(height)) = said {
            return Ok(Some([width, height]));
        }
        let other = self
            .beside()
            .or(self.options.size.map(|size| size.map(f64::from)));
        let other = match (other, self.centre(frame)?) {
            (None, [Some(x), Some(y)]) if x > 0.0 && y > 0.0 => Some([2.0 * x, 2.0 * y]),
            _ => other,
        };
        Ok(other.map(|[width, height]| [said.0.unwrap_or(width), said.1.unwrap_or(height)]))
    }

    /// The size of the first picture that lies beside the file.
    fn beside(&self) -> Option<[f64; 2]> {
        let size = || {
            let frames = self.root.get("frames")?.list().ok()?;
            let mut names = frames.filter_map(|frame| frame.get("file_path")?.value.as_str());
            let mut first = names.by_ref().take(MAX_TRIED);
            first.find_map(|name| picture::size_beside(self.source, name))
        };
        *self.beside.get_or_init(size)
    }
}

/// Pictures that are looked for, of which the first may be missing.
const MAX_TRIED: usize = 8;

/// Whether there are coefficients of distortion, or a model of a camera that bends lines.
fn distorted(at: At<'_>) -> bool {
    let number = |key: &str| at.get(key).and_then(|at| at.value.as_f64());
    let bends = |key: &&str| number(key).is_some_and(|number| number != 0.0);
    let keys = ["k1", "k2", "k3", "k4", "p1", "p2", "ftheta_p1"];
    let fisheye = at.get("is_fisheye").and_then(|at| at.value.as_bool());
    keys.iter().any(bends)
        || fisheye == Some(true)
        || model(at).is_some_and(|model| model.contains("FISHEYE"))
}

fn model(at: At<'_>) -> Option<&str> {
    at.get("camera_model").and_then(|at| at.value.as_str())
}

/// Whether a model of a camera sees more than a perspective has; its focal lengths are none.
fn panoramic(model: &str) -> bool {
    let kinds = ["EQUIRECTANGULAR", "OMNIDIRECTIONALSTEREO", "VR180"];
    kinds.iter().any(|kind| model.starts_with(kind))
}

/// Whether the poses were transformed from the world of the capture into another one.
fn transformed(root: At<'_>) -> bool {
    let matrix = root.get("applied_transform").map(At::rows);
    let scale = root.get("applied_scale").map(At::number);
    matrix.is_some_and(|matrix| matrix.is_ok_and(|matrix| matrix != DMat4::IDENTITY))
        || scale.is_some_and(|scale| scale.is_ok_and(|scale| scale != 1.0))
}

/// The zoom of all frames, if it is one.
fn only_zoom(flight: &Flight<'_>) -> Result<Option<f64>> {
    let mut block = [Pose::default(); 64];
    flight.poses(0, &mut block[..1])?;
    let zoom = block[0].zoom;
    for from in (0..flight.count()).step_by(block.len()) {
        let count = block.len().min(flight.count() - from);
        flight.poses(from, &mut block[..count])?;
        if block[..count].iter().any(|pose| pose.zoom != zoom) {
            return Ok(None);
        }
    }
    Ok(Some(zoom))
}

fn push_lens(text: &mut Vec<u8>, flight: &Flight<'_>, zoom: f64) {
    let focal = flight.focal_pixels(zoom);
    let angle = convention::width_of_focal(focal, flight.size()[0]);
    let _ = write!(
        text,
        "\"camera_angle_x\": {angle:?}, \"fl_x\": {focal:?}, \"fl_y\": {focal:?}"
    );
}
