//! Matrices for programs that draw or compute with a camera in other axes.

use glam::{DMat3, DMat4, DVec3, DVec4};

use super::orientation::unit;
use super::view::{HALF_FILM_HEIGHT, gl_matrix};
use crate::error::{OutOfRange, Result};

/// A matrix is a camera's if its axes, as long as each other, are this near to perpendicular: programs
/// with `float` matrices that they turn again and again let rounding grow.
const NEARLY: f64 = 1e-3;

/// Which way the axes of a camera point, all right-handed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CameraAxes {
    /// x right, y up, z back.
    OpenGl,
    /// x right, y down, z forward.
    OpenCv,
    /// x forward, y left, z up (REP 103, of a body).
    Ros,
    /// x left, y up, z forward: those of the library's quaternions and nodes.
    Vides,
}

impl CameraAxes {
    /// Each axis as one of OpenGL's and its sign.
    const fn in_opengl(self) -> [(usize, f64); 3] {
        match self {
            Self::OpenGl => [(0, 1.0), (1, 1.0), (2, 1.0)],
            Self::OpenCv => [(0, 1.0), (1, -1.0), (2, -1.0)],
            Self::Ros => [(2, -1.0), (0, -1.0), (1, 1.0)],
            Self::Vides => [(0, -1.0), (1, 1.0), (2, -1.0)],
        }
    }

    /// World to camera coordinates; of [`CameraAxes::OpenGl`] bit for bit [`gl_matrix`].
    ///
    /// # Errors
    /// As [`gl_matrix`].
    pub fn from_world(self, position: DVec3, view: DVec3, up: DVec3) -> Result<DMat4> {
        let [x, y, z] = self.rows(position, view, up)?;
        Ok(DMat4::from_cols(x, y, z, DVec4::W).transpose())
    }

    /// Camera to world coordinates: its axes, and `position`, column by column.
    ///
    /// # Errors
    /// As [`gl_matrix`].
    pub fn to_world(self, position: DVec3, view: DVec3, up: DVec3) -> Result<DMat4> {
        let [x, y, z] = self.rows(position, view, up)?;
        let axes = [x, y, z].map(|row| row.truncate().extend(0.0));
        Ok(DMat4::from_cols(
            axes[0],
            axes[1],
            axes[2],
            position.extend(1.0),
        ))
    }

    /// The position, view and up of a camera whose matrix from the world's coordinates, or `to_world`,
    /// this is: the other way of [`CameraAxes::from_world`] and [`CameraAxes::to_world`]. One scale of
    /// all axes is taken out. `None` if it mirrors, shears or projects, or is not finite.
    #[must_use]
    pub fn of_matrix(self, matrix: DMat4, to_world: bool) -> Option<[DVec3; 3]> {
        let (turn, offset) = (DMat3::from_mat4(matrix), matrix.w_axis.truncate());
        // In the columns, the camera's axes in the world.
        let axes = if to_world { turn } else { turn.transpose() };
        let scale = axes.determinant().cbrt();
        if !(scale > 0.0) || !matrix.is_finite() || matrix.row(3) != DVec4::W {
            return None;
        }
        let axes = axes * scale.recip();
        let square = axes.transpose() * axes;
        if !square.abs_diff_eq(DMat3::IDENTITY, NEARLY) {
            return None;
        }
        let mut opengl = [DVec3::ZERO; 3];
        for ((row, sign), axis) in
            self.in_opengl()
                .into_iter()
                .zip([axes.x_axis, axes.y_axis, axes.z_axis])
        {
            opengl[row] = sign * axis;
        }
        let view = unit(-opengl[2]);
        let up = unit(opengl[1] - view * opengl[1].dot(view));
        let position = if to_world {
            offset
        } else {
            -(turn.inverse() * offset)
        };
        position.is_finite().then_some([position, view, up])
    }

    fn rows(self, position: DVec3, view: DVec3, up: DVec3) -> Result<[DVec4; 3]> {
        let opengl = gl_matrix(position, view, up)?;
        Ok(self.in_opengl().map(|(row, sign)| sign * opengl.row(row)))
    }
}

/// What a picture's depth and height become between the planes of a projection.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Clip {
    /// From −1 at the front plane (OpenGL), else from 0; 1 at the back plane.
    pub from_minus_one: bool,
    /// Depths are exchanged: 1 at the front plane.
    pub reversed: bool,
    /// y points down in the picture (Vulkan).
    pub y_down: bool,
}

impl Clip {
    /// Camera coordinates as OpenGL has them (looking along −z) to clip coordinates, w = −z: the
    /// vertical field of view is 2·atan(12/`zoom`), `aspect` = width / height. `far` may be
    /// infinite. (Matrices as in the OpenGL specification's glFrustum; Upchurch and Desbrun 2012
    /// for the infinite ones.)
    ///
    /// # Errors
    /// [`crate::Error::Range`] unless zoom, aspect and `near` are positive and finite, and `far` >
    /// `near`; or if numbers become too large or too small.
    pub fn projection(self, zoom: f64, aspect: f64, near: f64, far: f64) -> Result<DMat4> {
        let good = |x: f64| x > 0.0 && x.is_finite();
        if !good(zoom) {
            return Err(OutOfRange::ViewZoom.into());
        }
        if !good(aspect) {
            return Err(OutOfRange::ViewAspect.into());
        }
        if !good(near) {
            return Err(OutOfRange::FrontPlane.into());
        }
        if !(far > near) {
            return Err(OutOfRange::BackPlane.into());
        }
        let y = zoom / HALF_FILM_HEIGHT;
        let x = y / aspect;
        // (far − near) / far, and near / far, also where far is infinite.
        let (between, share) = if far.is_finite() {
            ((far - near) / far, near / far)
        } else {
            (1.0, 0.0)
        };
        // Depth from 0: slope and offset over z, before the division by w.
        let (slope, offset) = if self.reversed {
            (share / between, near / between)
        } else {
            (-1.0 / between, -near / between)
        };
        // From −1: twice that, less w.
        let (slope, offset) = match (self.from_minus_one, self.reversed) {
            (false, _) => (slope, offset),
            (true, true) => ((1.0 + share) / between, 2.0 * offset),
            (true, false) => (-(1.0 + share) / between, 2.0 * offset),
        };
        if !(good(x) && good(y) && slope.is_finite() && offset.is_finite()) {
            return Err(OutOfRange::ViewNumbers.into());
        }
        let y = if self.y_down { -y } else { y };
        Ok(DMat4::from_cols(
            DVec4::new(x, 0.0, 0.0, 0.0),
            DVec4::new(0.0, y, 0.0, 0.0),
            DVec4::new(0.0, 0.0, slope, -1.0),
            DVec4::new(0.0, 0.0, offset, 0.0),
        ))
    }
}
