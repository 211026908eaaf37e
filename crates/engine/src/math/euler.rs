//! Euler angles (thesis 4.3, 4.4.5): yaw about y, then pitch about the turned x axis, then roll
//! about the view direction. Nothing is interpolated in them, since they tumble.

use glam::{DMat3, DQuat, DVec3};

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

/// The angles about x, y and z in radians whose turns make a rotation, the axis `order[0]` first.
/// The middle turn is within ±π/2 (Shoemake, Graphics Gems IV, 1994); where the first and the last
/// become one, they share it.
#[must_use]
pub fn euler(rotation: DQuat, order: [usize; 3]) -> [f64; 3] {
    let [first, middle, last] = order;
    let sign = handedness(order);
    let at = |matrix: DMat3, row: usize, column: usize| matrix.col(column)[row];
    let whole = DMat3::from_quat(rotation);
    let mut angles = [0.0; 3];
    angles[first] = (sign * at(whole, last, middle)).atan2(at(whole, last, last));
    // Without the first turn the others are exact even where it is not determined.
    let rest = whole * DMat3::from_quat(about(first, -angles[first]));
    angles[middle] = (-sign * at(rest, last, first)).atan2(at(rest, last, last));
    angles[last] = (-sign * at(rest, first, middle)).atan2(at(rest, middle, middle));
    angles
}

/// The rotation of turns by angles about x, y and z in radians, the axis `order[0]` first; axes
/// that are not in `order` do not turn.
#[must_use]
pub fn of_euler(angles: [f64; 3], order: &[usize]) -> DQuat {
    let turns = order.iter().map(|&axis| about(axis, angles[axis % 3]));
    turns
        .rev()
        .fold(DQuat::IDENTITY, |turned, turn| turned * turn)
}

fn about(axis: usize, angle: f64) -> DQuat {
    DQuat::from_axis_angle([DVec3::X, DVec3::Y, DVec3::Z][axis % 3], angle)
}

/// 1 for an order that runs x, y, z from some axis on, else −1.
fn handedness([first, middle, _]: [usize; 3]) -> f64 {
    if middle == (first + 1) % 3 { 1.0 } else { -1.0 }
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

    #[test]
    fn angles_make_their_rotation_in_any_order() {
        let quarter = std::f64::consts::FRAC_PI_2;
        let middles = [0.3, -1.2, quarter, -quarter, quarter - 1e-9, 0.0];
        for order in [
            [0, 1, 2],
            [0, 2, 1],
            [1, 0, 2],
            [1, 2, 0],
            [2, 0, 1],
            [2, 1, 0],
        ] {
            for middle in middles {
                let mut angles = [0.0; 3];
                for (axis, angle) in order.into_iter().zip([2.5, middle, -0.7]) {
                    angles[axis] = angle;
                }
                let turn = of_euler(angles, &order);
                let again = euler(turn, order);
                let off = turn.conjugate() * of_euler(again, &order);
                assert!(off.xyz().length() < 1e-15, "{order:?} {middle}");
                if middle.abs() < 1.5 {
                    let same = |axis: usize| (angles[axis] - again[axis]).abs() < 1e-14;
                    assert!((0..3).all(same), "{order:?} {again:?}");
                }
            }
        }
        // First about z, then x, then y: x goes to y, on to z, on to x.
        let quarters = of_euler([quarter; 3], &[2, 0, 1]);
        assert!((quarters * DVec3::X - DVec3::X).length() < 1e-15);
    }
}
