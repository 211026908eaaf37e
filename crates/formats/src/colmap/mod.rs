//! Models of COLMAP (Schönberger and Frahm 2016): a folder with `cameras`, `images` and `points3D`,
//! as text or as `.bin`. World to camera, x right, y down, z forward; no times: images are in the
//! order of their names, numbers in them as numbers.

mod binary;
mod natural;
mod text;
mod write;

use std::collections::HashMap;
use std::io::Write;
use std::path::Path;

use glam::{DQuat, DVec3};

use super::content::{Content, Recording};
use super::convention;
use super::error::{Cause, Error, Place, Result};
use super::flight::Flight;
use super::format::{Format, Row};
use super::lens::{Lens, Lenses};
use super::loss::{Loss, Report};
use super::options::Options;
use super::source::Source;
use crate::limits::{MAX_FILE_BYTES, MAX_OBJECT_POINTS};
use crate::math::camera::CameraAxes;

pub(super) struct Colmap;

const ROW: Row = Row {
    name: "colmap",
    title: "COLMAP",
    parts: &["cameras.txt", "images.txt", "points3D.txt"],
    ..Row::PLAIN
};

/// What COLMAP reads before the three texts, or together with them.
const BESIDE: [&str; 7] = [
    "cameras.bin",
    "images.bin",
    "points3D.bin",
    "rigs.bin",
    "frames.bin",
    "rigs.txt",
    "frames.txt",
];

impl Format for Colmap {
    fn row(&self) -> &'static Row {
        &ROW
    }

    fn recognises(&self, source: &Source) -> bool {
        ending(source).is_some()
    }

    fn read(&self, source: &Source, _: &Options, report: &mut Report) -> Result<Content> {
        let ending = ending(source).unwrap_or("txt");
        let is_text = ending == "txt";
        let mut model = Model::default();
        let read_cameras = if is_text {
            text::cameras
        } else {
            binary::cameras
        };
        let read_images = if is_text {
            text::images
        } else {
            binary::images
        };
        let read_points = if is_text {
            text::points
        } else {
            binary::points
        };
        part(
            source,
            &format!("cameras.{ending}"),
            &mut model,
            read_cameras,
        )?;
        part(source, &format!("images.{ending}"), &mut model, read_images)?;
        let points = format!("points3D.{ending}");
        if source.place_beside(&points)?.is_file() {
            part(source, &points, &mut model, read_points)?;
        }
        model.recording(report).map(Content::Poses)
    }

    fn check_folder(&self, folder: &Path) -> Result<()> {
        match BESIDE.iter().find(|name| folder.join(name).exists()) {
            Some(name) => Err(Place::Whole
                .wrong(Cause::Beside((*name).into()))
                .at(&folder.display().to_string())),
            None => Ok(()),
        }
    }

    fn write(
        &self,
        flight: &mut Flight<'_>,
        part: usize,
        out: &mut dyn Write,
        report: &mut Report,
    ) -> Result<()> {
        flight.needs_camera()?;
        flight.tell_poses_only(report);
        report.add(Loss::Times);
        match part {
            0 => write::cameras(flight, out),
            1 => write::images(flight, out),
            _ => write::points(out),
        }
    }
}

/// Whether a model is binary or text; COLMAP takes `.bin` before text.
fn ending(source: &Source) -> Option<&'static str> {
    let folder = source.folder.as_deref()?;
    let there = |ending: &&str| {
        let parts = ["cameras", "images"];
        let mut files = parts
            .iter()
            .map(|part| folder.join(format!("{part}.{ending}")));
        files.all(|file| file.is_file())
    };
    let mut endings = ["bin", "txt"].into_iter().filter(there);
    if source.is_folder {
        return endings.next();
    }
    let name = Path::new(&source.name).file_name()?.to_str()?;
    endings.find(|ending| {
        let stem = name.strip_suffix(ending).unwrap_or("");
        ["cameras.", "images.", "points3D."].contains(&stem)
    })
}

/// Reads one of the files; errors name it.
fn part(
    source: &Source,
    name: &str,
    model: &mut Model,
    read: fn(&[u8], &mut Model) -> Result<()>,
) -> Result<()> {
    let bytes = source.beside(name, MAX_FILE_BYTES)?;
    let place = source.place_beside(name)?.display().to_string();
    read(&bytes, model).map_err(|error: Error| error.at(&place))
}

/// What the three files hold.
#[derive(Default)]
struct Model {
    /// By their numbers; true: with distortion.
    cameras: HashMap<u64, (Lens, bool)>,
    images: Vec<Image>,
    points: Vec<DVec3>,
    /// Points beyond what is taken.
    more_points: usize,
}

struct Image {
    name: String,
    /// World to camera.
    rotation: DQuat,
    translation: DVec3,
    camera: u64,
}

impl Model {
    /// Takes a camera of a kind with its parameters.
    fn add_camera(
        &mut self,
        id: u64,
        place: &Place,
        kind: &Kind,
        size: [f64; 2],
        parameters: &[f64],
    ) -> Result<()> {
        let (focal, rest) = parameters.split_at(kind.focal_lengths);
        let &[cx, cy, ref bends @ ..] = rest else {
            return Err(place.clone().wrong(Cause::End));
        };
        let (fx, fy) = (focal[0], focal[focal.len() - 1]);
        if !(fx > 0.0 && fy > 0.0 && size[0] > 0.0 && size[1] > 0.0) {
            return Err(place.clone().expected(super::Wanted::PositiveNumber));
        }
        let lens = Lens {
            focal: [fx, fy],
            size,
            centre: [cx, cy],
        };
        let distorted = kind.bends || bends.iter().any(|&bend| bend != 0.0);
        self.cameras.try_reserve(1)?;
        self.cameras.insert(id, (lens, distorted));
        Ok(())
    }

    /// Takes an image; its camera has been read.
    fn add_image(&mut self, place: &Place, image: Image) -> Result<()> {
        if !self.cameras.contains_key(&image.camera) {
            let camera = format!("camera {}", image.camera);
            return Err(place.clone().wrong(Cause::Missing((&camera).into())));
        }
        let numbers = image.rotation.is_finite() && image.translation.is_finite();
        if !numbers {
            return Err(place.clone().wrong(Cause::NotFinite));
        }
        if image.rotation.length() < 1e-12 {
            return Err(place.clone().wrong(Cause::NoRotation));
        }
        self.images.try_reserve(1)?;
        self.images.push(image);
        Ok(())
    }

    /// Takes a point, as many as an object may have.
    fn add_point(&mut self, point: [f64; 3]) -> Result<()> {
        if self.points.len() >= MAX_OBJECT_POINTS {
            self.more_points += 1;
            return Ok(());
        }
        self.points.try_reserve(1)?;
        self.points.push(point.into());
        Ok(())
    }

    /// The poses in the order of the names.
    fn recording(mut self, report: &mut Report) -> Result<Recording> {
        self.images
            .sort_by(|a, b| natural::compare(&a.name, &b.name));
        let mut lenses = Lenses::default();
        let mut recording = Recording::default();
        for image in &self.images {
            let (lens, distorted) = &mut self
                .cameras
                .get_mut(&image.camera)
                .ok_or_else(|| Place::Whole.wrong(Cause::Missing((&image.name).into())))?;
            // Each camera is told once.
            lenses.distorted += usize::from(std::mem::take(distorted));
            let zoom = lenses.zoom(lens);
            let (turn, position) =
                convention::inverse(image.rotation.normalize(), image.translation);
            let place = Place::Key((&image.name).into());
            recording.push(place.pose(position, turn, CameraAxes::OpenCv, zoom)?)?;
        }
        lenses.tell(report);
        report.add(Loss::Times);
        report.not_taken("points3D", self.more_points);
        recording.points = self.points;
        Ok(recording)
    }
}

/// A kind of camera: the parameters are one or two focal lengths, the principal point, then what
/// bends lines.
struct Kind {
    name: &'static str,
    focal_lengths: usize,
    parameters: usize,
    /// Whether it bends lines whatever its parameters are.
    bends: bool,
}

const fn kind(name: &'static str, focal_lengths: usize, parameters: usize, bends: bool) -> Kind {
    Kind {
        name,
        focal_lengths,
        parameters,
        bends,
    }
}

/// By their numbers in `.bin` (COLMAP 4.2, `sensor/models.h`); the 17th, of a whole sphere, has no
/// field of view.
const KINDS: [Kind; 17] = [
    kind("SIMPLE_PINHOLE", 1, 3, false),
    kind("PINHOLE", 2, 4, false),
    kind("SIMPLE_RADIAL", 1, 4, false),
    kind("RADIAL", 1, 5, false),
    kind("OPENCV", 2, 8, false),
    kind("OPENCV_FISHEYE", 2, 8, true),
    kind("FULL_OPENCV", 2, 12, false),
    kind("FOV", 2, 5, false),
    kind("SIMPLE_RADIAL_FISHEYE", 1, 4, true),
    kind("RADIAL_FISHEYE", 1, 5, true),
    kind("THIN_PRISM_FISHEYE", 2, 12, true),
    kind("RAD_TAN_THIN_PRISM_FISHEYE", 2, 16, true),
    kind("SIMPLE_DIVISION", 1, 4, false),
    kind("DIVISION", 2, 5, false),
    kind("SIMPLE_FISHEYE", 1, 3, true),
    kind("FISHEYE", 2, 4, true),
    kind("EUCM", 2, 6, true),
];

/// The error of a kind that is not among them.
fn unknown_kind(place: &Place, name: &str) -> Error {
    place.clone().wrong(Cause::Unsupported {
        name: (&format!("the camera model {name}")).into(),
        help: "",
    })
}

#[cfg(test)]
mod tests;
