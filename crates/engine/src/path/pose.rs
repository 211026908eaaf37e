//! One camera pose, in the layout of the C interface's `V_POSE`.

use glam::{DMat4, DQuat, DVec3};

use crate::error::Result;
use crate::math::camera::CameraAxes;
use crate::math::orientation::{quaternion_from_view, view_from_quaternion};

/// Where the camera is, where it looks, what is up and how far it zooms.
/// The layout is frozen: ten doubles without padding.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[repr(C)]
pub struct Pose {
    /// Position (view reference point), world coordinates.
    pub vrp: [f64; 3],
    /// View direction: unit vector along which the camera looks.
    pub vpn: [f64; 3],
    /// Up: unit vector, perpendicular to `vpn`.
    pub vup: [f64; 3],
    /// 1…2000; the vertical field of view is 2·atan(12/zoom).
    pub zoom: f64,
}

impl Pose {
    /// A camera at `position`, turned by a unit quaternion that takes (0, 0, 1) to the view
    /// direction and (0, 1, 0) to up.
    #[must_use]
    pub fn new(position: DVec3, rotation: DQuat, zoom: f64) -> Self {
        let (view, up) = view_from_quaternion(rotation);
        Self {
            vrp: position.into(),
            vpn: view.into(),
            vup: up.into(),
            zoom,
        }
    }

    /// Where the camera is.
    #[must_use]
    pub const fn position(&self) -> DVec3 {
        DVec3::from_array(self.vrp)
    }

    /// Where it looks: a unit vector.
    #[must_use]
    pub const fn view(&self) -> DVec3 {
        DVec3::from_array(self.vpn)
    }

    /// What is up: a unit vector, perpendicular to [`Pose::view`].
    #[must_use]
    pub const fn up(&self) -> DVec3 {
        DVec3::from_array(self.vup)
    }

    /// The quaternion of [`Pose::new`], one of two that differ in sign.
    #[must_use]
    pub fn rotation(&self) -> DQuat {
        quaternion_from_view(self.view(), self.up())
    }

    /// The vertical field of view in radians.
    #[must_use]
    pub fn field_of_view(&self) -> f64 {
        2.0 * (12.0 / self.zoom).atan()
    }

    /// From camera coordinates, whose axes lie like this, to the world's.
    ///
    /// # Errors
    /// [`crate::Error::Argument`] if view and up are not finite, zero or parallel.
    pub fn to_world(&self, axes: CameraAxes) -> Result<DMat4> {
        axes.to_world(self.position(), self.view(), self.up())
    }

    /// The same memory as poses, ten numbers each as their fields follow; what is left over
    /// behind the last stays out.
    #[must_use]
    pub fn of_numbers(numbers: &mut [f64]) -> &mut [Self] {
        let count = numbers.len() / 10;
        // SAFETY: as below, the other way round: a pose is aligned as its doubles are.
        #[allow(unsafe_code)]
        unsafe {
            std::slice::from_raw_parts_mut(numbers.as_mut_ptr().cast(), count)
        }
    }

    /// The same memory as plain numbers, ten for each pose.
    pub(super) fn as_numbers(poses: &mut [Self]) -> &mut [f64] {
        const { assert!(size_of::<Pose>() == 10 * size_of::<f64>()) }
        let count = 10 * poses.len();
        // SAFETY: a pose is ten doubles without padding, any bits are a double; the borrow goes on.
        #[allow(unsafe_code)]
        unsafe {
            std::slice::from_raw_parts_mut(poses.as_mut_ptr().cast(), count)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pose_is_vectors_a_quaternion_and_a_matrix() {
        let rotation = DQuat::from_xyzw(0.1, -0.4, 0.3, 0.8).normalize();
        let pose = Pose::new(DVec3::new(1.0, 2.0, 3.0), rotation, 12.0);
        assert!(pose.rotation().dot(rotation).abs() > 1.0 - 1e-15);
        assert!((pose.view() - rotation * DVec3::Z).length() < 1e-15);
        let world = pose.to_world(CameraAxes::Vides).unwrap();
        assert!((world.transform_vector3(DVec3::Y) - pose.up()).length() < 1e-15);
        assert_eq!(world.transform_point3(DVec3::ZERO), pose.position());
        assert!((pose.field_of_view() - std::f64::consts::FRAC_PI_2).abs() < 1e-15);
        assert!(Pose::default().to_world(CameraAxes::OpenGl).is_err());
        let mut numbers: Vec<f64> = (0..25).map(f64::from).collect();
        let poses = Pose::of_numbers(&mut numbers);
        assert_eq!(poses.len(), 2);
        assert_eq!((poses[1].vrp, poses[1].zoom), ([10.0, 11.0, 12.0], 19.0));
    }
}
