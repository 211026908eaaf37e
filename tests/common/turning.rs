//! Paths for the turning of the camera, and rotations measured from the
//! vectors of the poses alone, never from quaternions.

use glam::DVec3;
use vides::path::{CameraPath, Orientation, Pose, Sampler, SupportPoint, Target, Timeline};

use super::{Random, path_through};

pub fn axes(pose: &Pose) -> [DVec3; 3] {
    let (view, up) = (DVec3::from(pose.vpn), DVec3::from(pose.vup));
    [view, up, up.cross(view)]
}

/// Rotation vector that leads from one pose to the other by the shorter way,
/// and its length. (Half a turn has a length but no one vector.)
pub fn rotation(from: &Pose, to: &Pose) -> (DVec3, f64) {
    let pairs = axes(from).into_iter().zip(axes(to));
    let (mut sine, mut trace) = (DVec3::ZERO, 0.0);
    for (a, b) in pairs {
        sine += 0.5 * a.cross(b);
        trace += a.dot(b);
    }
    let length = sine.length();
    let angle = length.atan2(0.5 * (trace - 1.0));
    let scale = if length > 0.0 { angle / length } else { 0.0 };
    (sine * scale, angle)
}

pub fn turned(from: &Pose, to: &Pose) -> f64 {
    rotation(from, to).1
}

pub fn looking(direction: DVec3, roll: f64) -> Orientation {
    Orientation {
        target: Target::Relative(direction),
        roll,
        ..Orientation::default()
    }
}

pub fn at_target(target: DVec3, roll: f64) -> Orientation {
    Orientation {
        target: Target::Absolute(target),
        roll,
        ..Orientation::default()
    }
}

pub fn yawed(degrees: f64) -> Orientation {
    let (sin, cos) = degrees.to_radians().sin_cos();
    looking(DVec3::new(sin, 0.0, cos), 0.0)
}

/// A path of 0.7-long straight moves, one orientation at each point.
pub fn moving(orientations: Vec<Orientation>) -> CameraPath {
    let mut path = CameraPath::default();
    path.points.clear();
    for (i, orientation) in orientations.into_iter().enumerate() {
        let mut point = SupportPoint::new(DVec3::X * (0.7 * i as f64));
        point.orientations = vec![orientation];
        path.points.push(point);
    }
    path
}

/// A path that stands still at first and pans through all orientations.
pub fn panning(orientations: Vec<Orientation>) -> CameraPath {
    let mut path = path_through(&[[0.0; 3], [0.7, 0.0, 0.0]]);
    path.points[1].orientations = vec![orientations[orientations.len() - 1].clone()];
    path.points[0].orientations = orientations;
    path
}

/// Curve time of a section, its two keys and half the angle between them.
pub fn span(timeline: &Timeline, sampler: &Sampler, section: usize) -> (f64, f64) {
    let facts = timeline.section(section);
    let start = (sampler.first_frame(section) - 1) as f64;
    let from = sampler.pose(start).unwrap();
    let to = sampler.pose(start + facts.frames as f64).unwrap();
    let time = facts.frames as f64 * facts.mean_speed / 50.0;
    (time, 0.5 * turned(&from, &to))
}

/// Nothing of a random path but what is asked for: points of different
/// distances, speed curves, holds, and some pans.
pub fn busy_path(
    random: &mut Random,
    mut orientation: impl FnMut(&mut Random) -> Orientation,
) -> CameraPath {
    let mut path = CameraPath::default();
    path.points.clear();
    for _ in 0..3 + random.below(4) {
        let scale = random.between(0.2, 2.0);
        let mut point = SupportPoint::new(scale * random.vector());
        point.orientations.clear();
        for _ in 0..1 + random.below(3) {
            let mut own = orientation(random);
            own.hold = random.below(4) as u32;
            for speed in &mut own.speeds {
                *speed = random.between(10.0, 90.0);
            }
            point.orientations.push(own);
        }
        path.points.push(point);
    }
    path.closed = random.chance(0.4);
    path.base_frames.movement = random.between(30.0, 100.0);
    path.base_frames.turning = random.between(30.0, 300.0);
    path
}

pub fn free(random: &mut Random) -> Orientation {
    looking(random.vector(), random.between(-179.0, 180.0))
}
