//! What changes over the frames of a film, as it is plotted (`docs/reference/tools.md`, plot).

use glam::{DMat3, DQuat, DVec3};

use super::check::FindingKind;
use super::clearance::Clearance;
use crate::math::orientation::roll_from_up;
use crate::path::{Pose, Sampler, Up};
use crate::{Result, error::vec_with_room};

/// A quantity of a camera in motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Quantity {
    /// Length of the way since the first frame.
    Distance,
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
    /// Distance to the nearest of the object.
    Clearance,
}

/// A film as it is plotted.
#[derive(Debug, Clone, Copy)]
pub struct Film<'a> {
    /// Frames and poses, in order, equally far apart for the acceleration.
    pub samples: &'a [(f64, Pose)],
    /// Frames a second.
    pub fps: f64,
    /// The vertical of the space.
    pub up: Up,
    /// What the camera must not run into.
    pub object: Option<&'a Clearance>,
}

impl Quantity {
    /// All of them, in the order in which they are plotted.
    pub const ALL: [Self; 7] = [
        Self::Distance,
        Self::Speed,
        Self::Acceleration,
        Self::Turning,
        Self::Roll,
        Self::Zoom,
        Self::Clearance,
    ];

    /// The kinds of findings ([`super::check`]) that are seen in it.
    #[must_use]
    pub const fn findings(self) -> &'static [FindingKind] {
        use FindingKind::{
            Acceleration, Backwards, Clearance, Corner, Crossing, Cusp, HalfTurn, Jerk,
            NothingToSee, Pole, Redundant, Space, Speed, SpeedJump, Target, Through, Turning,
            TurningAcceleration, ViewJump, Zoom,
        };
        match self {
            Self::Distance => &[],
            Self::Speed => &[Speed, SpeedJump, Cusp, Backwards, Corner, Space],
            Self::Acceleration => &[Acceleration, Jerk],
            Self::Turning => &[
                Turning,
                TurningAcceleration,
                ViewJump,
                HalfTurn,
                Pole,
                Crossing,
            ],
            Self::Roll => &[Redundant],
            Self::Zoom => &[Zoom],
            Self::Clearance => &[Clearance, Through, NothingToSee, Target],
        }
    }

    /// Pairs of frame and value over a film; differences lie between two frames.
    ///
    /// # Errors
    /// [`crate::Error::Memory`].
    pub fn of(self, film: &Film<'_>) -> Result<Vec<(f64, f64)>> {
        let (samples, fps, up) = (film.samples, film.fps, film.up);
        let mut values = vec_with_room(samples.len())?;
        let place = |pose: &Pose| DVec3::from_array(pose.vrp);
        let pairs = samples.windows(2).map(|pair| (&pair[0], &pair[1]));
        let between = |value: &dyn Fn(&Pose, &Pose) -> f64, (from, to): (&_, &_)| {
            let ((a, from), (b, to)): (&(f64, Pose), &(f64, Pose)) = (from, to);
            (0.5 * (a + b), value(from, to) * fps / (b - a))
        };
        match self {
            Self::Distance => {
                let mut way = 0.0;
                let mut last = None;
                values.extend(samples.iter().map(|(frame, pose)| {
                    let here = place(pose);
                    way += here.distance(last.replace(here).unwrap_or(here));
                    (*frame, way)
                }));
            }
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
            Self::Clearance => {
                let Some(object) = film.object else {
                    return Ok(values);
                };
                let mut before: Option<(DVec3, f64)> = None;
                for (frame, pose) in samples {
                    let here = place(pose);
                    // No farther than from the place before and the way from there.
                    let most = before.map_or(f64::INFINITY, |(place, far)| {
                        (far + place.distance(here)) * (1.0 + 1e-9) + f64::MIN_POSITIVE
                    });
                    let far = object.distance(here, most).unwrap_or(most);
                    let crossed = |(place, _)| object.is_crossed(place, here);
                    if let (true, Some(last)) = (before.is_some_and(crossed), values.last()) {
                        let (last, _): &(f64, f64) = last;
                        values.push((0.5 * (last + frame), 0.0));
                    }
                    before = Some((here, far));
                    values.try_reserve(2)?;
                    values.push((*frame, far));
                }
            }
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

/// Poses of a film with their frames: all, or `most` at equal distances.
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

/// About `most` of the values: of each stretch the least and the greatest, so that peaks are seen.
#[must_use]
pub fn with_peaks(values: Vec<(f64, f64)>, most: usize) -> Vec<(f64, f64)> {
    let [Some(&first), Some(&last)] = [values.first(), values.last()] else {
        return values;
    };
    if values.len() <= most {
        return values;
    }
    let mut kept = vec![first];
    for stretch in values.chunks(values.len().div_ceil(most / 2)) {
        let by_value = |a: &&(f64, f64), b: &&(f64, f64)| a.1.total_cmp(&b.1);
        let ends = [
            stretch.iter().min_by(by_value),
            stretch.iter().max_by(by_value),
        ];
        let [Some(&low), Some(&high)] = ends else {
            continue;
        };
        kept.extend(if low.0 < high.0 {
            [low, high]
        } else {
            [high, low]
        });
    }
    kept.push(last);
    kept
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
        let film = Film {
            samples: &samples,
            fps,
            up: Up::Y,
            object: None,
        };
        for (quantity, expected) in [
            (Quantity::Speed, radius * omega),
            (Quantity::Acceleration, radius * omega * omega),
            (Quantity::Turning, omega.to_degrees()),
            (Quantity::Roll, 0.0),
        ] {
            let values = quantity.of(&film).unwrap();
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
        assert_eq!(Quantity::Zoom.of(&film).unwrap()[7], (8.0, 31.0));
        let way = Quantity::Distance.of(&film).unwrap();
        assert_eq!(way[0], (1.0, 0.0));
        assert!((way[249].1 - radius * omega * 249.0 / fps).abs() < 1e-3);
        assert!(Quantity::Clearance.of(&film).unwrap().is_empty());
    }

    /// Past two points on a line: the distance to the nearer of them, by Pythagoras.
    #[test]
    fn the_clearance_is_the_distance_to_the_nearest() {
        let points = vec![DVec3::new(-1.0, 0.5, 0.0), DVec3::new(2.0, 0.0, 0.25)];
        let mesh = crate::scene::Mesh {
            points: points.clone(),
            ..Default::default()
        };
        let object = Clearance::new(&mesh).unwrap();
        let frame = |k: i32| {
            let pose = Pose {
                vrp: [0.07 * f64::from(k) - 3.0, 0.0, 0.0],
                vpn: [0.0, 0.0, 1.0],
                vup: [0.0, 1.0, 0.0],
                zoom: 24.0,
            };
            (1.0 + f64::from(k), pose)
        };
        // There, and at once back to the beginning.
        let samples: Vec<_> = (0..90).chain([0]).map(frame).collect();
        let film = Film {
            samples: &samples,
            fps: 25.0,
            up: Up::Y,
            object: Some(&object),
        };
        let values = Quantity::Clearance.of(&film).unwrap();
        assert_eq!(values.len(), 91);
        for ((_, pose), (_, value)) in samples.iter().zip(values) {
            let place = DVec3::from_array(pose.vrp);
            let far = points.iter().map(|point| point.distance(place));
            let expected = far.fold(f64::INFINITY, f64::min);
            assert!((value - expected).abs() < 1e-12, "{value} {expected}");
        }
    }

    #[test]
    fn a_peak_of_one_frame_stays() {
        let value = |frame: u32| match frame {
            3333 => 12.5,
            7001 => -3.0,
            _ => 1.0,
        };
        let all = |count| (0..count).map(|k| (f64::from(k), value(k))).collect();
        let kept = with_peaks(all(10_000), 2_000);
        assert!(kept.len() <= 2_002);
        assert!(kept.contains(&(3333.0, 12.5)) && kept.contains(&(7001.0, -3.0)));
        assert!(kept.is_sorted_by(|a, b| a.0 <= b.0));
        assert_eq!([kept[0].0, kept[kept.len() - 1].0], [0.0, 9_999.0]);
        let short: Vec<_> = all(100);
        assert_eq!(with_peaks(short.clone(), 2_000), short);
    }
}
