//! What the three files hold, and the kinds of cameras.

use std::collections::HashMap;

use glam::{DQuat, DVec3};
use vides_engine::limits::MAX_OBJECT_POINTS;
use vides_engine::math::camera::CameraAxes;

use crate::content::Recording;
use crate::convention;
use crate::error::{Cause, Error, Place, Result, Wanted};
use crate::lens::{Lens, Lenses};
use crate::loss::{Loss, Report};
use crate::natural;

/// What the three files hold.
#[derive(Default)]
pub(super) struct Model {
    /// By their numbers; true: with distortion.
    cameras: HashMap<u64, (Lens, bool)>,
    images: Vec<Image>,
    points: Vec<DVec3>,
    /// Points beyond what is taken.
    more_points: usize,
}

pub(super) struct Image {
    pub(super) name: String,
    /// World to camera.
    pub(super) rotation: DQuat,
    pub(super) translation: DVec3,
    pub(super) camera: u64,
}

impl Model {
    /// Takes a camera of a kind with its parameters.
    pub(super) fn add_camera(
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
            return Err(place.clone().expected(Wanted::PositiveNumber));
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
    pub(super) fn add_image(&mut self, place: &Place, image: Image) -> Result<()> {
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
    pub(super) fn add_point(&mut self, point: [f64; 3]) -> Result<()> {
        if self.points.len() >= MAX_OBJECT_POINTS {
            self.more_points += 1;
            return Ok(());
        }
        self.points.try_reserve(1)?;
        self.points.push(point.into());
        Ok(())
    }

    /// The poses in the order of the names.
    pub(super) fn recording(mut self, report: &mut Report) -> Result<Recording> {
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
pub(super) struct Kind {
    pub(super) name: &'static str,
    pub(super) focal_lengths: usize,
    pub(super) parameters: usize,
    /// Whether it bends lines whatever its parameters are.
    pub(super) bends: bool,
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
pub(super) const KINDS: [Kind; 17] = [
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
pub(super) fn unknown_kind(place: &Place, name: &str) -> Error {
    place.clone().wrong(Cause::Unsupported {
        name: (&format!("the camera model {name}")).into(),
        help: "",
    })
}
