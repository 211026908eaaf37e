//! Warnings about a section whose result is a choice that the path leaves open (`docs/theory/path.md`):
//! half a turn goes either way, and a camera that passes through its target has no direction there.

use glam::{DQuat, DVec3};

use super::ahead;
use super::ahead::AT_TARGET;
use super::camera_path::{CameraPath, Orientation, Target};
use super::hermite::Cubic;
use super::space::{Space, Up};
use super::timeline::{Change, Timeline, next};
use super::ups::rolled;
use crate::math::orientation::quaternion_from_view;
use crate::math::quaternion::{angle, continue_sign};

/// What is ambiguous in a section.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ambiguity {
    /// The orientations are half a turn apart: the camera may turn either way.
    HalfTurn,
    /// The camera passes through the target that it looks at.
    AtTarget,
    /// The camera passes straight above or below its target, where the yaw is undefined.
    OverTarget,
}

/// Places of a curve that are tried before Newton's method.
const PLACES: usize = 64;

/// What is ambiguous in a section, if anything.
///
/// # Panics
/// If there is no such section.
#[must_use]
pub fn ambiguity(path: &CameraPath, timeline: &Timeline, section: usize) -> Option<Ambiguity> {
    match turn(path, timeline, section)? {
        Turn::Tracks(target, up) => {
            let begin = timeline.section(section);
            let curve = (begin.change == Change::Position).then(|| timeline.curve(begin.point))?;
            met(curve, target, Space { up, ..path.space })
        }
        Turn::Free(a, b) => continue_sign(a, b).1.then_some(Ambiguity::HalfTurn),
    }
}

/// How far short of a half turn a section turns, in degrees; `None` where it follows a rule.
///
/// # Panics
/// If there is no such section.
#[must_use]
pub fn half_turn(path: &CameraPath, timeline: &Timeline, section: usize) -> Option<f64> {
    match turn(path, timeline, section)? {
        Turn::Tracks(..) => None,
        Turn::Free(a, b) => {
            let turned = 2.0 * angle(a, continue_sign(a, b).0);
            Some(180.0 - turned.to_degrees())
        }
    }
}

/// How a section turns.
enum Turn {
    /// With the way, towards a target, with this up axis.
    Tracks(DVec3, Up),
    /// From one orientation to another.
    Free(DQuat, DQuat),
}

/// How a section turns; `None` along the way.
fn turn(path: &CameraPath, timeline: &Timeline, section: usize) -> Option<Turn> {
    let begin = timeline.section(section);
    let here = &path.points[begin.point];
    let from = &here.orientations[begin.orientation];
    let next = next(path, (begin.point, begin.orientation));
    let to = &path.points[next.0].orientations[next.1];
    let same_up = from.own.up.same(&to.own.up, path.space.up);
    if same_up && from.own.ahead.is_some() && from.own.ahead == to.own.ahead {
        return None;
    }
    let tracks = same_up && from.own.ahead.or(to.own.ahead).is_none();
    if let (Target::Absolute(a), Target::Absolute(b)) = (from.target, to.target)
        && tracks
        && a == b
    {
        let up = from.own.up.level(path.space.up).unwrap_or(path.space.up);
        return Some(Turn::Tracks(a, up));
    }
    let key = |(point, number): (usize, usize), orientation: &Orientation| {
        let view = ahead::view(path, point, number);
        let reference = timeline.reference(path, (point, number), view);
        let view = path.space.up.upright(view);
        let up = rolled(view, reference, orientation.roll.to_radians());
        quaternion_from_view(view, up)
    };
    let begins = (begin.point, begin.orientation);
    Some(Turn::Free(key(begins, from), key(next, to)))
}

/// Whether a curve leads through a target, or straight above or below it.
fn met(curve: &Cubic, target: DVec3, space: Space) -> Option<Ambiguity> {
    let flat = space.up.world(DVec3::new(1.0, 0.0, 1.0));
    let near = AT_TARGET * space.half_size;
    if nearest(curve, target, DVec3::ONE) < near {
        Some(Ambiguity::AtTarget)
    } else if nearest(curve, target, flat) < near {
        Some(Ambiguity::OverTarget)
    } else {
        None
    }
}

/// The least distance of a curve from a place, along the axes whose part in `seen` is 1: from each
/// minimum among the places tried, Newton's method on the slope of the square.
fn nearest(curve: &Cubic, place: DVec3, seen: DVec3) -> f64 {
    let at = |t: f64| (curve.point(t) - place) * seen;
    let far = |k: usize| at(k as f64 / PLACES as f64).length_squared();
    let mut least = f64::INFINITY;
    for k in 0..=PLACES {
        let here = far(k);
        if (k > 0 && far(k - 1) < here) || (k < PLACES && far(k + 1) < here) {
            continue;
        }
        let mut t = k as f64 / PLACES as f64;
        least = least.min(here);
        for _ in 0..60 {
            let (offset, way) = (at(t), curve.derivative(t) * seen);
            let bend = way.length_squared() + offset.dot(curve.second_derivative(t) * seen);
            // A negative second term is left out: the step would lead uphill.
            let step = offset.dot(way) / bend.max(way.length_squared());
            if !step.is_finite() || step == 0.0 {
                break;
            }
            t = (t - step).clamp(0.0, 1.0);
            least = least.min(at(t).length_squared());
        }
    }
    least.sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::path::SupportPoint;

    fn orientation(target: Target, roll: f64) -> Orientation {
        Orientation {
            target,
            roll,
            ..Orientation::default()
        }
    }

    fn point(x: f64, y: f64, z: f64, orientations: Vec<Orientation>) -> SupportPoint {
        SupportPoint {
            position: DVec3::new(x, y, z),
            orientations,
            ..CameraPath::default().points[0].clone()
        }
    }

    fn ambiguities(points: Vec<SupportPoint>) -> Vec<Option<Ambiguity>> {
        let path = CameraPath {
            points: points.into(),
            ..CameraPath::default()
        };
        path.check().unwrap();
        let timeline = Timeline::new(&path).unwrap();
        (0..timeline.section_count())
            .map(|section| ambiguity(&path, &timeline, section))
            .collect()
    }

    #[test]
    fn half_a_turn_goes_either_way() {
        let relative = |x, y, z| Target::Relative(DVec3::new(x, y, z));
        let looks = |target| vec![orientation(target, 0.0)];
        let ahead = looks(relative(0.0, 0.0, -0.4));
        for (target, roll, wanted) in [
            (relative(0.0, 0.0, 1.0), 0.0, Some(Ambiguity::HalfTurn)),
            (relative(0.0, 0.0, -2.0), 180.0, Some(Ambiguity::HalfTurn)),
            (relative(0.0, 0.0, -2.0), 179.9, None),
            (relative(1e-9, 0.0, 1.0), 0.0, None),
            (relative(1.0, 0.0, 0.0), 0.0, None),
        ] {
            let there = vec![orientation(target, roll)];
            let moving = ambiguities(vec![
                point(-0.5, 0.0, 0.0, ahead.clone()),
                point(0.5, 0.0, 0.0, there.clone()),
            ]);
            assert_eq!(moving, [wanted], "{target:?} {roll}");
            let both = [ahead.clone(), there].concat();
            let panning = ambiguities(vec![
                point(-0.5, 0.0, 0.0, both),
                point(0.5, 0.0, 0.0, looks(target)),
            ]);
            assert_eq!(panning[0], wanted, "{target:?} {roll}");
        }
    }

    #[test]
    fn a_tracked_target_may_be_met() {
        let target = DVec3::new(0.1, 0.2, 0.3);
        let along = |y: f64, z: f64| {
            let looks = vec![orientation(Target::Absolute(target), 0.0)];
            ambiguities(vec![
                point(-0.7, y, z, looks.clone()),
                point(0.9, y, z, looks.clone()),
            ])
        };
        assert_eq!(along(0.2, 0.3), [Some(Ambiguity::AtTarget)]);
        assert_eq!(along(0.6, 0.3), [Some(Ambiguity::OverTarget)]);
        assert_eq!(along(-0.6, 0.3), [Some(Ambiguity::OverTarget)]);
        assert_eq!(along(0.2, 0.3 + 1e-6), [None]);
        assert_eq!(along(0.6, 0.3 - 1e-6), [None]);
        // Bent ways, wherever on them the target lies.
        for k in 0..200 {
            let bent = |target: DVec3| {
                let looks = vec![orientation(Target::Absolute(target), 0.0)];
                let place = |x, y, z| point(x, y, z, looks.clone());
                vec![
                    place(-0.7, 0.1, 0.4),
                    place(0.2, -0.3, 0.9),
                    place(0.8, 0.6, -0.5),
                ]
            };
            let path = CameraPath {
                points: bent(DVec3::ZERO).into(),
                ..CameraPath::default()
            };
            let on_it = Timeline::new(&path)
                .unwrap()
                .curve(1)
                .point((f64::from(k) + 0.5) / 200.0);
            assert_eq!(
                ambiguities(bent(on_it))[1],
                Some(Ambiguity::AtTarget),
                "{k}"
            );
            let below = on_it - DVec3::new(0.0, 0.25, 0.0);
            assert_eq!(
                ambiguities(bent(below))[1],
                Some(Ambiguity::OverTarget),
                "{k}"
            );
            let beside = on_it + DVec3::new(0.0, 0.0, 0.01);
            assert_ne!(
                ambiguities(bent(beside))[1],
                Some(Ambiguity::AtTarget),
                "{k}"
            );
        }
    }

    #[test]
    fn a_camera_that_stands_meets_nothing() {
        let looks = |roll| orientation(Target::Absolute(DVec3::ZERO), roll);
        let still = vec![looks(0.0), looks(30.0)];
        let found = ambiguities(vec![
            point(0.5, 0.5, 0.5, still.clone()),
            point(0.6, 0.5, 0.5, still),
        ]);
        assert_eq!(found, [None, None, None]);
    }
}
