//! What changes over the frames of a film, as it is plotted: how fast the camera goes and
//! turns, its roll, its zoom (`docs/tools.md`, plots).

use glam::{DMat3, DQuat, DVec3};

use crate::math::orientation::roll_from_up;
use crate::path::{Pose, Sampler, Up};
use crate::{Result, error::vec_with_room};

/// A quantity of a camera in motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Quantity {
    /// Length per second.
    Speed,
    /// Length per second squared.
    Acceleration,
    /// Degrees per second, of the camera as a whole.
    Turning,
    /// Degrees about the view direction, from the space's vertical.
    Roll,
    /// Millimetres.
    Zoom,
}

impl Quantity {
    /// All of them, in the order in which they are plotted.
    pub const ALL: [Self; 5] = [
        Self::Speed,
        Self::Acceleration,
        Self::Turning,
        Self::Roll,
        Self::Zoom,
    ];

    /// The kinds of findings ([`super::check`]) that are seen in it.
    #[must_use]
    pub const fn findings(self) -> &'static [&'static str] {
        match self {
            Self::Speed => &["speed-jump", "cusp", "corner", "space"],
            Self::Acceleration => &["acceleration"],
            Self::Turning => &[
                "turning",
                "turning-acceleration",
                "view-jump",
                "half-turn",
                "pole",
            ],
            Self::Roll => &["redundant"],
            Self::Zoom => &["zoom"],
        }
    }

    /// Its values over `samples` of a film (frame, pose; in order, equally far apart for
    /// the acceleration): pairs of frame and value. Differences lie between two frames.
    ///
    /// # Errors
    /// [`crate::Error::Memory`].
    pub fn of(self, samples: &[(f64, Pose)], fps: f64, up: Up) -> Result<Vec<(f64, f64)>> {
        let mut values = vec_with_room(samples.len())?;
        let place = |pose: &Pose| DVec3::from_array(pose.vrp);
        let pairs = samples.windows(2).map(|pair| (&pair[0], &pair[1]));
        let between = |value: &dyn Fn(&Pose, &Pose) -> f64, (from, to): (&_, &_)| {
            let ((a, from), (b, to)): (&(f64, Pose), &(f64, Pose)) = (from, to);
            (0.5 * (a + b), value(from, to) * fps / (b - a))
        };
        match self {
            Self::Speed => {
                let way = |a: &Pose, b: &Pose| place(a).distance(place(b));
                values.extend(pairs.map(|pair| between(&way, pair)));
            }
            Self::Turning => values.extend(pairs.map(|pair| between(&turned, pair))),
            Self::Acceleration => values.extend(samples.windows(3).map(|three| {
                let [a, b, c] = [0, 1, 2].map(|k| place(&three[k].1));
                let step = three[1].0 - three[0].0;
                let change = (a - 2.0 * b + c).length();
                (three[1].0, change * (fps / step).powi(2))
            })),
            Self::Roll => values.extend(samples.iter().map(|(frame, pose)| {
                let [view, up] = [pose.vpn, pose.vup].map(|v| up.upright(v.into()));
                (*frame, roll_from_up(view, up).to_degrees())
            })),
            Self::Zoom => values.extend(samples.iter().map(|(frame, pose)| (*frame, pose.zoom))),
        }
        Ok(values)
    }
}

/// The angle from one pose's camera to another's, in degrees.
fn turned(from: &Pose, to: &Pose) -> f64 {
    let [a, b] = [from, to].map(|pose| {
        let (view, up) = (DVec3::from_array(pose.vpn), DVec3::from_array(pose.vup));
        DQuat::from_mat3(&DMat3::from_cols(up.cross(view), up, view))
    });
    a.angle_between(b).to_degrees()
}

/// Poses of a film with their frames: every one, or so many at equal distances.
///
/// # Errors
/// As [`Sampler::pose`]; [`crate::Error::Memory`].
#[allow(clippy::cast_precision_loss)]
pub fn samples(sampler: &Sampler, most: usize) -> Result<Vec<(f64, Pose)>> {
    let frames = sampler.frame_count();
    let count = frames.min(most);
    let mut samples = vec_with_room(count)?;
    for k in 0..count {
        let frame = if frames > count {
            1.0 + (frames - 1) as f64 * k as f64 / (count.max(2) - 1) as f64
        } else {
            1.0 + k as f64
        };
        samples.push((frame, sampler.pose(frame)?));
    }
    Ok(samples)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A camera that goes round on a circle with constant speed: v = rω, a = v²/r, and it
    /// turns by ω.
    #[test]
    fn a_round_has_the_values_of_a_circle() {
        let (fps, seconds, radius) = (25.0, 10.0, 2.0);
        let omega = std::f64::consts::TAU / seconds;
        let frame = |k: i32| {
            let angle = omega * f64::from(k) / fps;
            let away = DVec3::new(angle.cos(), 0.0, angle.sin());
            let pose = Pose {
                vrp: (away * radius).to_array(),
                vpn: (-away).to_array(),
                vup: [0.0, 1.0, 0.0],
                zoom: 24.0 + f64::from(k),
            };
            (1.0 + f64::from(k), pose)
        };
        let samples: Vec<_> = (0..250).map(frame).collect();
        for (quantity, expected) in [
            (Quantity::Speed, radius * omega),
            (Quantity::Acceleration, radius * omega * omega),
            (Quantity::Turning, omega.to_degrees()),
            (Quantity::Roll, 0.0),
        ] {
            let values = quantity.of(&samples, fps, Up::Y).unwrap();
            assert!(values.len() >= 248);
            for (frame, value) in values {
                // A chord is a little shorter than its arc.
                let error = (value - expected).abs();
                assert!(
                    error < 1e-3 * expected.max(1e-6),
                    "{quantity:?} {frame}: {value}"
                );
            }
        }
        let zoom = Quantity::Zoom.of(&samples, fps, Up::Y).unwrap();
        assert_eq!(zoom[7], (8.0, 31.0));
    }
}
