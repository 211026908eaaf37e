//! Euler angles (thesis 4.3, 4.4.5): yaw about y, then pitch about the turned x axis, then roll
//! about the view direction. Nothing is interpolated in them, since they tumble.

use glam::{DQuat, DVec3};

use super::orientation::{POLE, roll_from_up, view_from_quaternion};

/// Three angles in radians; q = q_yaw(y)·q_pitch(x)·q_roll(z).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EulerAngles {
    /// (−π, π]: from the z axis towards the x axis; 0 at the poles.
    pub yaw: f64,
    /// [−π/2, π/2]: positive looks down.
    pub pitch: f64,
    /// (−π, π]: turns the up vector about the view direction.
    pub roll: f64,
}

impl EulerAngles {
    /// The angles of a view; both vectors unit and perpendicular.
    #[must_use]
    pub fn from_view(view: DVec3, up: DVec3) -> Self {
        let h = view.x.hypot(view.z);
        Self {
            yaw: if h < POLE { 0.0 } else { view.x.atan2(view.z) },
            pitch: (-view.y).atan2(h),
            roll: roll_from_up(view, up),
        }
    }

    /// The angles of a quaternion of any length but zero.
    #[must_use]
    pub fn from_quaternion(q: DQuat) -> Self {
        let (view, up) = view_from_quaternion(q);
        Self::from_view(view, up)
    }

    /// View direction and up vector.
    #[must_use]
    pub fn view(self) -> (DVec3, DVec3) {
        view_from_quaternion(self.quaternion())
    }

    /// The quaternion, the product of the three turns.
    #[must_use]
    pub fn quaternion(self) -> DQuat {
        DQuat::from_rotation_y(self.yaw)
            * DQuat::from_rotation_x(self.pitch)
            * DQuat::from_rotation_z(self.roll)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::orientation::quaternion_from_roll;
    use glam::EulerRot;
    use proptest::prelude::*;
    use std::f64::consts::{FRAC_PI_2, PI};

    proptest! {
        #[test]
        fn angles_and_quaternions_agree_with_glam(
            yaw in -PI..PI, pitch in -1.57..1.57f64, roll in -PI..PI,
        ) {
            let angles = EulerAngles { yaw, pitch, roll };
            let known = DQuat::from_euler(EulerRot::YXZ, yaw, pitch, roll);
            prop_assert!(angles.quaternion().dot(known).abs() > 1.0 - 1e-15);
            let back = EulerAngles::from_quaternion(known);
            let apart = |a: f64, b: f64| (a - b).sin().abs() + (1.0 - (a - b).cos());
            // Near the poles yaw and roll are known as well as their distance is.
            let known_to = 1e-14 / pitch.cos();
            prop_assert!(apart(back.yaw, yaw) < known_to);
            prop_assert!(apart(back.pitch, pitch) < known_to);
            prop_assert!(apart(back.roll, roll) < known_to);
            let (view, _) = angles.view();
            let by_roll = quaternion_from_roll(view, roll);
            prop_assert!(by_roll.dot(known).abs() > 1.0 - 1e-13 / pitch.cos());
        }
    }

    #[test]
    fn a_positive_pitch_looks_down_and_a_pole_has_no_yaw() {
        let down = EulerAngles {
            yaw: 0.0,
            pitch: 0.5,
            roll: 0.0,
        };
        assert!(down.view().0.y < 0.0);
        for y in [1.0, -1.0] {
            let angles = EulerAngles::from_view(DVec3::Y * y, DVec3::Z);
            assert_eq!((angles.yaw, angles.pitch), (0.0, -y * FRAC_PI_2));
            let (view, up) = angles.view();
            assert!((view - DVec3::Y * y).length() < 1e-15 && (up - DVec3::Z).length() < 1e-15);
        }
    }
}
