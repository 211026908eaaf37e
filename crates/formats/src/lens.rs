//! What is reported of pictures in pixels: our cameras have one field of view about the centre.

use super::convention;
use super::loss::{Loss, Report};

/// The camera of a picture in pixels.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Lens {
    /// Focal lengths across and down; > 0.
    pub(super) focal: [f64; 2],
    /// Width and height; > 0.
    pub(super) size: [f64; 2],
    /// Where the camera's axis meets the picture.
    pub(super) centre: [f64; 2],
}

/// A share of a picture's size that is rounding.
const HAIR: f64 = 1e-6;

/// Ignored properties, counted in pictures.
#[derive(Debug, Default)]
pub(super) struct Lenses {
    clamped: usize,
    off_centre: usize,
    oblong: usize,
    without: usize,
    /// How many cameras have distortion.
    pub(super) distorted: usize,
}

impl Lenses {
    /// The zoom of a picture.
    pub(super) fn zoom(&mut self, lens: &Lens) -> f64 {
        let Lens {
            focal,
            size,
            centre,
        } = *lens;
        let off = |axis: usize| (centre[axis] - 0.5 * size[axis]).abs() > HAIR * size[axis];
        self.off_centre += usize::from(off(0) || off(1));
        self.oblong += usize::from((focal[0] - focal[1]).abs() > HAIR * focal[1]);
        self.clamped(convention::zoom_of_focal(focal[1], size[1]))
    }

    /// A zoom and whether it lies in the range.
    pub(super) fn clamped(&mut self, (zoom, inside): (f64, bool)) -> f64 {
        self.clamped += usize::from(!inside);
        zoom
    }

    /// The zoom of a picture without a field of view.
    pub(super) fn without(&mut self) -> f64 {
        self.without += 1;
        super::content::DEFAULT_ZOOM
    }

    /// Tells it.
    pub(super) fn tell(self, report: &mut Report) {
        if self.without > 0 {
            report.add(Loss::FieldOfView);
        }
        report.count(self.clamped, Loss::FieldsClamped);
        report.count(self.off_centre, Loss::OffCentre);
        report.count(self.distorted, Loss::Distortion);
        report.count(self.oblong, Loss::Oblong);
    }
}
