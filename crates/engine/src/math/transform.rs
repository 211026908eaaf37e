//! Transformations of space as 4×4 matrices (thesis 2.2): p' = M·p with column vectors in
//! homogeneous coordinates, right-handed axes, angles in radians, positive counter-clockwise when
//! looking from the axis's tip to the origin. A product applies its rightmost factor first.

use glam::{DMat3, DMat4, DVec3};

use super::orientation::unit;
use crate::error::{Invalid, Result};

/// Moves every point by `d` (2.2).
#[must_use]
pub fn translation(d: DVec3) -> DMat4 {
    DMat4::from_translation(d)
}

/// Stretches along the axes by the components of `s`; the origin stays (2.4).
#[must_use]
pub fn scaling(s: DVec3) -> DMat4 {
    DMat4::from_scale(s)
}

/// As [`scaling`], with the point `fixed` staying where it is (2.2.4).
#[must_use]
pub fn scaling_about(s: DVec3, fixed: DVec3) -> DMat4 {
    translation(fixed) * scaling(s) * translation(-fixed)
}

/// Turns about the x axis: y goes towards z (2.5).
#[must_use]
pub fn rotation_x(angle: f64) -> DMat4 {
    DMat4::from_rotation_x(angle)
}

/// Turns about the y axis: z goes towards x (2.6).
#[must_use]
pub fn rotation_y(angle: f64) -> DMat4 {
    DMat4::from_rotation_y(angle)
}

/// Turns about the z axis: x goes towards y (2.6).
#[must_use]
pub fn rotation_z(angle: f64) -> DMat4 {
    DMat4::from_rotation_z(angle)
}

/// The rotation R_y·R_x of 2.2.5 that brings `axis`, of any length, onto the z axis: first about x
/// into the xz plane (2.15), then about y (2.17; its sine is −x whatever the sign of x). For an
/// axis along x, R_x is the identity.
///
/// # Errors
/// [`crate::Error::Argument`] if `axis` is zero or not finite.
pub fn axis_to_z(axis: DVec3) -> Result<DMat4> {
    if !axis.is_finite() || axis == DVec3::ZERO {
        return Err(Invalid::RotationAxis.into());
    }
    let DVec3 { x, y, z } = unit(axis);
    let r = y.hypot(z);
    let (sin, cos) = if r == 0.0 { (0.0, 1.0) } else { (y / r, z / r) };
    let about_x = DMat3::from_cols(
        DVec3::X,
        DVec3::new(0.0, cos, sin),
        DVec3::new(0.0, -sin, cos),
    );
    let about_y = DMat3::from_cols(DVec3::new(r, 0.0, x), DVec3::Y, DVec3::new(-x, 0.0, r));
    Ok(DMat4::from_mat3(about_y * about_x))
}

/// Turns by `angle` about the line through `point` along `axis`, by the seven steps of 2.2.5:
/// T⁻¹·R_x⁻¹·R_y⁻¹·R_z·R_y·R_x·T. (2.19 prints the two inverse rotations the other way round.)
///
/// # Errors
/// [`crate::Error::Argument`] if `axis` is zero or anything is not finite.
pub fn rotation_about_axis(point: DVec3, axis: DVec3, angle: f64) -> Result<DMat4> {
    if !point.is_finite() || !angle.is_finite() {
        return Err(Invalid::RotationNotFinite.into());
    }
    let to_z = axis_to_z(axis)?;
    // A rotation's inverse is its transpose.
    let rotation = to_z.transpose() * rotation_z(angle) * to_z;
    Ok(translation(point) * rotation * translation(-point))
}

/// Shears along the z axis: x grows by `x`·z and y by `y`·z (2.20).
#[must_use]
pub fn shear_along_z(x: f64, y: f64) -> DMat4 {
    DMat4::from_mat3(DMat3::from_cols(DVec3::X, DVec3::Y, DVec3::new(x, y, 1.0)))
}

/// Shears along the x axis: y grows by `y`·x and z by `z`·x (2.2.6).
#[must_use]
pub fn shear_along_x(y: f64, z: f64) -> DMat4 {
    DMat4::from_mat3(DMat3::from_cols(DVec3::new(1.0, y, z), DVec3::Y, DVec3::Z))
}

/// Shears along the y axis: x grows by `x`·y and z by `z`·y (2.2.6).
#[must_use]
pub fn shear_along_y(x: f64, z: f64) -> DMat4 {
    DMat4::from_mat3(DMat3::from_cols(DVec3::X, DVec3::new(x, 1.0, z), DVec3::Z))
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{FRAC_PI_2, PI};

    use proptest::prelude::*;

    use super::*;

    const P: DVec3 = DVec3::new(2.0, 3.0, 5.0);

    fn assert_near(got: DVec3, want: DVec3, tolerance: f64) {
        assert!(
            (got - want).abs().max_element() <= tolerance,
            "got {got}, want {want}"
        );
    }

    /// Rodrigues' formula, written out: no matrix of the code under test.
    fn rodrigues(point: DVec3, axis: DVec3, angle: f64, p: DVec3) -> DVec3 {
        let k = axis / axis.length();
        let v = p - point;
        let (sin, cos) = angle.sin_cos();
        point + v * cos + k.cross(v) * sin + k * (k.dot(v) * (1.0 - cos))
    }

    #[test]
    fn translates_and_scales() {
        assert_eq!(
            translation(DVec3::new(1.0, -2.0, 4.0)).transform_point3(P),
            DVec3::new(3.0, 1.0, 9.0)
        );
        let s = DVec3::new(2.0, -1.0, 0.5);
        assert_eq!(scaling(s).transform_point3(P), DVec3::new(4.0, -3.0, 2.5));
        let fixed = DVec3::new(1.0, 1.0, 1.0);
        let about = scaling_about(s, fixed);
        assert_eq!(about.transform_point3(fixed), fixed);
        assert_eq!(about.transform_point3(P), DVec3::new(3.0, -1.0, 3.0));
    }

    #[test]
    fn turns_the_axes_into_each_other() {
        let turned = [
            (rotation_x(FRAC_PI_2), DVec3::Y, DVec3::Z),
            (rotation_y(FRAC_PI_2), DVec3::Z, DVec3::X),
            (rotation_z(FRAC_PI_2), DVec3::X, DVec3::Y),
        ];
        for (matrix, from, to) in turned {
            assert_near(matrix.transform_point3(from), to, 1e-15);
        }
    }

    #[test]
    fn shears() {
        let sheared = [
            (shear_along_z(0.5, -2.0), DVec3::new(4.5, -7.0, 5.0)),
            (shear_along_x(0.5, -2.0), DVec3::new(2.0, 4.0, 1.0)),
            (shear_along_y(0.5, -2.0), DVec3::new(3.5, 3.0, -1.0)),
        ];
        for (matrix, want) in sheared {
            assert_eq!(matrix.transform_point3(P), want);
        }
    }

    #[test]
    fn every_axis_direction_comes_to_z() {
        let mut axes = vec![
            DVec3::new(1e-300, 0.0, 0.0),
            DVec3::new(-3.0, 1e-17, 0.0),
            DVec3::new(1e200, -1e200, 1e199),
        ];
        for x in [-1.0, 0.0, 1.0] {
            for y in [-1.0, 0.0, 1.0] {
                for z in [-1.0, 0.0, 1.0] {
                    axes.push(DVec3::new(x, y, z));
                }
            }
        }
        axes.retain(|&axis| axis != DVec3::ZERO);
        for axis in axes {
            let turned = axis_to_z(axis).unwrap().transform_vector3(unit(axis));
            assert_near(turned, DVec3::Z, 1e-15);
        }
    }

    #[test]
    fn axes_along_x_turn_as_the_plain_rotation() {
        for angle in [-3.0, -0.1, 0.0, 1.0, FRAC_PI_2, PI] {
            for (axis, signed) in [(DVec3::X, angle), (-DVec3::X, -angle)] {
                let matrix = rotation_about_axis(DVec3::ZERO, axis * 7.0, angle).unwrap();
                assert!(matrix.abs_diff_eq(rotation_x(signed), 1e-15));
            }
        }
    }

    #[test]
    fn refuses_what_has_no_direction() {
        for axis in [
            DVec3::ZERO,
            DVec3::new(f64::NAN, 1.0, 0.0),
            DVec3::new(f64::INFINITY, 1.0, 0.0),
        ] {
            assert!(rotation_about_axis(P, axis, 1.0).is_err());
        }
        assert!(rotation_about_axis(DVec3::NAN, DVec3::X, 1.0).is_err());
        assert!(rotation_about_axis(P, DVec3::X, f64::INFINITY).is_err());
    }

    fn vector(range: f64) -> impl Strategy<Value = DVec3> {
        prop::array::uniform3(-range..range).prop_map(DVec3::from_array)
    }

    proptest! {
        #[test]
        fn any_axis_turns_as_rodrigues_and_glam(
            point in vector(10.0), axis in vector(1.0), p in vector(10.0), angle in -7.0..7.0f64,
        ) {
            prop_assume!(axis.length() > 1e-3);
            let matrix = rotation_about_axis(point, axis, angle).unwrap();
            assert_near(
                matrix.transform_point3(p),
                rodrigues(point, axis, angle, p),
                1e-13,
            );
            let glam = DMat4::from_translation(point)
                * DMat4::from_axis_angle(axis.normalize(), angle)
                * DMat4::from_translation(-point);
            prop_assert!(matrix.abs_diff_eq(glam, 1e-13));
        }
    }
}
