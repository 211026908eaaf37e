//! Views in the manner of PHIGS (thesis 2.4, 2.5; Foley and van Dam 1990, chapter 6): from the
//! description of a picture to the matrix that brings the visible part of the world into a
//! canonical volume, and from there onto the picture plane.
//!
//! PHIGS looks **against** the view plane normal, a camera **along** its view direction:
//! [`View::from_pose`] turns the sign, so that the picture is not mirrored.

use glam::dcamera::rh::view::look_to_mat4;
use glam::{DMat4, DVec3};

use super::orientation::unit;
use super::transform::{scaling, shear_along_z, translation};
use crate::error::{Invalid, OutOfRange, Result};

/// Below this sine two directions count as parallel: a third would have less than four digits.
const PARALLEL: f64 = 1e-12;

/// Half the height in mm of the film on which the zoom is a focal length.
pub const HALF_FILM_HEIGHT: f64 = 12.0;

/// The vertical field of view in degrees, in (0, 180), of a lens of `zoom` mm before a picture of
/// `height` mm: 2·atan(height/(2·zoom)), to 4 ulp.
///
/// # Errors
/// [`crate::Error::Range`] unless both are positive and finite, and so is the angle.
pub fn fov_from_zoom(zoom: f64, height: f64) -> Result<f64> {
    if !(zoom > 0.0 && zoom.is_finite()) {
        return Err(OutOfRange::ViewZoom.into());
    }
    check_height(height)?;
    let fov = 2.0 * (0.5 * height / zoom).atan().to_degrees();
    check_fov(fov)?;
    Ok(fov)
}

/// The lens in mm that gives a picture of `height` mm the vertical field of view `fov`, in degrees:
/// height/(2·tan(fov/2)); the inverse of [`fov_from_zoom`].
///
/// # Errors
/// [`crate::Error::Range`] unless `fov` is in (0, 180), and height and lens are positive and finite.
pub fn zoom_from_fov(fov: f64, height: f64) -> Result<f64> {
    check_fov(fov)?;
    check_height(height)?;
    let zoom = 0.5 * height / (0.5 * fov).to_radians().tan();
    if !(zoom > 0.0 && zoom.is_finite()) {
        return Err(OutOfRange::ViewZoom.into());
    }
    Ok(zoom)
}

fn check_height(height: f64) -> Result<()> {
    if !(height > 0.0 && height.is_finite()) {
        return Err(OutOfRange::PictureHeight.into());
    }
    Ok(())
}

fn check_fov(fov: f64) -> Result<()> {
    if !(fov > 0.0 && fov < 180.0) {
        return Err(OutOfRange::FieldOfView.into());
    }
    Ok(())
}

/// The description of a picture (2.4.1). `vrp`, `normal` and `up` are world coordinates, all else
/// view reference coordinates (u, v, n): origin in `vrp`, n along `normal`, v along the part of
/// `up` perpendicular to it, u = v × n to the right in the picture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct View {
    /// View reference point.
    pub vrp: DVec3,
    /// View plane normal, of any length, pointing **towards** the eye.
    pub normal: DVec3,
    /// View up vector, of any length, not parallel to `normal`.
    pub up: DVec3,
    /// Projection reference point (u, v, n): the eye of a perspective. The direction of a parallel
    /// projection runs from here to the window's centre.
    pub prp: DVec3,
    /// What of the view plane is the picture: u_min, u_max, v_min, v_max.
    pub window: [f64; 4],
    /// n of the front plane; nothing nearer to the eye is seen.
    pub front: f64,
    /// n of the back plane; nothing farther from the eye is seen.
    pub back: f64,
    /// n of the view plane, on which the window lies. A plane behind the eye
    /// of a perspective gives its picture upside down, as a pinhole does.
    pub distance: f64,
    /// Perspective, or else parallel (oblique where the direction of projection is not the normal).
    pub perspective: bool,
}

impl View {
    /// The perspective view of a camera at `position` that looks along `view` (of any length):
    /// vertical field of view 2·atan(12/`zoom`), `aspect` = width / height; planes at the distances
    /// `front` and `back`, 0 < `front` < `back`. `view` × `up` is to the right in the picture.
    ///
    /// The eye is the view reference point; the window lies at distance 1, so
    /// that v ∈ ±12/`zoom` and u ∈ ±`aspect`·12/`zoom`.
    ///
    /// # Errors
    /// [`crate::Error::Range`] for numbers out of these ranges, and whatever [`View::check`] finds.
    pub fn from_pose(
        position: DVec3,
        view: DVec3,
        up: DVec3,
        zoom: f64,
        aspect: f64,
        front: f64,
        back: f64,
    ) -> Result<Self> {
        if !(zoom > 0.0 && zoom.is_finite()) {
            return Err(OutOfRange::ViewZoom.into());
        }
        if !(aspect > 0.0 && aspect.is_finite()) {
            return Err(OutOfRange::ViewAspect.into());
        }
        if !(front > 0.0 && front.is_finite()) {
            return Err(OutOfRange::FrontPlane.into());
        }
        if !(back > front && back.is_finite()) {
            return Err(OutOfRange::BackPlane.into());
        }
        let v = HALF_FILM_HEIGHT / zoom;
        let u = aspect * v;
        let view = Self {
            vrp: position,
            normal: -view,
            up,
            prp: DVec3::ZERO,
            window: [-u, u, -v, v],
            front: -front,
            back: -back,
            distance: -1.0,
            perspective: true,
        };
        view.check()?;
        Ok(view)
    }

    /// Checks that this describes a picture.
    ///
    /// # Errors
    /// [`crate::Error::Argument`] for anything not finite, or a normal and an up vector that are
    /// zero or parallel; [`crate::Error::Range`] for an empty window, a back plane not behind the
    /// front plane, or a reference point (`prp`) not before the front plane or in the view plane.
    pub fn check(&self) -> Result<()> {
        let vectors = [self.vrp, self.normal, self.up, self.prp];
        let numbers = [self.front, self.back, self.distance];
        if !(vectors.iter().all(|v| v.is_finite())
            && numbers.iter().chain(&self.window).all(|x| x.is_finite()))
        {
            return Err(Invalid::ViewNotFinite.into());
        }
        if self.normal == DVec3::ZERO {
            return Err(Invalid::NormalZero.into());
        }
        if self.up == DVec3::ZERO {
            return Err(Invalid::ViewUpZero.into());
        }
        if unit(self.up).cross(unit(self.normal)).length() < PARALLEL {
            return Err(Invalid::ViewUpParallel.into());
        }
        let [u_min, u_max, v_min, v_max] = self.window;
        if u_min >= u_max || v_min >= v_max {
            return Err(OutOfRange::ViewWindow.into());
        }
        if self.back >= self.front {
            return Err(OutOfRange::ViewPlanes.into());
        }
        if self.prp.z <= self.front {
            return Err(OutOfRange::ReferenceBehindFront.into());
        }
        if self.prp.z == self.distance {
            return Err(OutOfRange::ReferenceInViewPlane.into());
        }
        Ok(())
    }

    /// The matrix from world coordinates into the canonical volume (2.5.1); affine, so w stays 1.
    ///
    /// Parallel: x and y in [−1, 1], z from 0 at the front plane to −1 at the back plane.
    /// Perspective: |x| ≤ z and |y| ≤ z with the eye in the origin and the back plane at z = 1, a
    /// left-handed volume; x/z and y/z are the place in the picture, [−1, 1] each.
    ///
    /// # Errors
    /// As [`View::check`]; [`crate::Error::Range`] if numbers are too large or too close together.
    pub fn matrix(&self) -> Result<DMat4> {
        self.check()?;
        let matrix = if self.perspective {
            self.perspective_mapping()
        } else {
            self.parallel_mapping()
        } * self.orientation();
        if matrix.is_finite() {
            Ok(matrix)
        } else {
            Err(OutOfRange::ViewNumbers.into())
        }
    }

    /// World to view reference coordinates, moved along n so that the view plane is n = 0 (2.36).
    /// The rows of the rotation, R_z·R_y·R_x of 2.5.1, are u, v and n.
    fn orientation(&self) -> DMat4 {
        let n = unit(self.normal);
        let u = unit(unit(self.up).cross(n));
        let v = n.cross(u);
        let rotation = DMat4::from_cols(
            u.extend(0.0),
            v.extend(0.0),
            n.extend(0.0),
            DVec3::ZERO.extend(1.0),
        )
        .transpose();
        rotation * translation(-(self.vrp + self.distance * n))
    }

    /// Half the window and its centre seen from the projection reference point.
    fn window_from_eye(&self) -> (f64, f64, DVec3) {
        let [u_min, u_max, v_min, v_max] = self.window;
        let centre = DVec3::new(
            u_min + (u_max - u_min) / 2.0,
            v_min + (v_max - v_min) / 2.0,
            self.distance,
        );
        (
            (u_max - u_min) / 2.0,
            (v_max - v_min) / 2.0,
            centre - self.prp,
        )
    }

    /// S·SH·T (2.38). The planes are given from the old reference point, so
    /// that moving it into the view plane moves them too.
    fn perspective_mapping(&self) -> DMat4 {
        let (half_u, half_v, centre) = self.window_from_eye();
        let back = self.back - self.prp.z;
        let eye = DVec3::new(self.prp.x, self.prp.y, self.prp.z - self.distance);
        // centre.z is the z'_vrp of 2.29, back its z'_vrp + B; the shear takes
        // the centre onto the z axis (2.28 has the other sign).
        scaling(DVec3::new(
            centre.z / half_u / back,
            centre.z / half_v / back,
            1.0 / back,
        )) * shear_along_z(-centre.x / centre.z, -centre.y / centre.z)
            * translation(-eye)
    }

    /// S·T·SH (2.37); the shear takes the projection onto the z axis (2.33 has the other sign).
    fn parallel_mapping(&self) -> DMat4 {
        let (half_u, half_v, direction) = self.window_from_eye();
        let centre = direction + self.prp;
        scaling(DVec3::new(
            1.0 / half_u,
            1.0 / half_v,
            1.0 / (self.front - self.back),
        )) * translation(DVec3::new(-centre.x, -centre.y, self.distance - self.front))
            * shear_along_z(-direction.x / direction.z, -direction.y / direction.z)
    }
}

/// Projects from the origin onto the plane z = `d` (M_per, 2.23): after the division by w, (d·x/z,
/// d·y/z, d). For points with z > 0 and `d` ≠ 0; in the canonical volume of a perspective the
/// window lies at d = (`distance` − `prp.z`) / (`back` − `prp.z`).
#[must_use]
pub fn perspective_projection(d: f64) -> DMat4 {
    let mut matrix = DMat4::IDENTITY;
    matrix.z_axis.w = 1.0 / d;
    matrix.w_axis.w = 0.0;
    matrix
}

/// Projects along z onto the plane z = 0 (M_par, 2.24).
#[must_use]
pub fn parallel_projection() -> DMat4 {
    scaling(DVec3::new(1.0, 1.0, 0.0))
}

/// World to eye coordinates as OpenGL's `gluLookAt` makes them, stored by columns: the camera at
/// the origin, looking along −z, y up. `view` and `up` need be neither unit nor perpendicular.
///
/// # Errors
/// [`crate::Error::Argument`] if anything is not finite, `view` or `up` zero or both parallel;
/// [`crate::Error::Range`] if the position is too large.
pub fn gl_matrix(position: DVec3, view: DVec3, up: DVec3) -> Result<DMat4> {
    if !(position.is_finite() && view.is_finite() && up.is_finite()) {
        return Err(Invalid::LookNotFinite.into());
    }
    if view == DVec3::ZERO || up == DVec3::ZERO {
        return Err(Invalid::LookZero.into());
    }
    let (view, up) = (unit(view), unit(up));
    if view.cross(up).length() < PARALLEL {
        return Err(Invalid::UpParallel.into());
    }
    let matrix = look_to_mat4(position, view, up);
    if matrix.is_finite() {
        Ok(matrix)
    } else {
        Err(OutOfRange::CameraTooFar.into())
    }
}

#[cfg(test)]
#[path = "view_tests.rs"]
mod tests;
