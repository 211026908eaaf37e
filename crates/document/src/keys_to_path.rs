//! A node that moves by keys comes to follow a path, fitted to its poses.

use glam::{DQuat, DVec3};
use vides_engine::scene::{
    Channel, Extrapolation, FollowPath, NodeState, Part, Rest, Scene, Values, Warnings,
};
use vides_engine::tools::fit::{Tolerance, fit};

use super::edit::Edit;
use super::editing::Document;
use super::tool::in_space;
use crate::error::{EngineError, Invalid, Refused, Result, TooMany, vec_with_room};
use vides_engine::limits::MAX_SAMPLED_FRAMES;
use vides_engine::math::orientation::quaternion_from_view;
use vides_engine::math::quaternion::{angle, continue_sign};
use vides_engine::path::{CameraPath, Plan, Pose};

/// How near the path comes to the poses: shares of `half_size`, degrees.
const NEAR: f64 = 1e-3;
const ANGLE: f64 = 0.1;

/// The channels whose keys the path takes over.
const MOVED: [Channel; 5] = [
    Channel::Position,
    Channel::Rotation,
    Channel::Zoom,
    Channel::Roll,
    Channel::AimWeight,
];

/// What [`Document::keys_to_path`] makes.
#[derive(Debug)]
pub struct KeysToPath {
    /// What lets the camera follow its path, and its choice, to be one step.
    pub edits: Vec<Edit>,
    /// Points of the path.
    pub points: usize,
    /// The farthest that a whole frame is from where it was, in world units.
    pub off: f64,
    /// And by how many degrees the view and its up are turned.
    pub turned: f64,
}

impl Document {
    /// How near a path or keys come by default.
    #[must_use]
    pub fn usual_tolerance(&self) -> Tolerance {
        let edited = self.edited_scene();
        let space = edited.map_or(self.path().space, |edited| edited.scene().space());
        Tolerance {
            position: NEAR * space.half_size,
            angle: ANGLE,
        }
    }

    /// The edits that let a node of the scene follow a path in place of its keys, and of its aim,
    /// from the scene's first frame to its last.
    ///
    /// # Errors
    /// `ErrorKind::Argument` without a scene; `ErrorKind::Range` if there is no such node; those of
    /// [`vides_engine::tools::fit`].
    pub fn keys_to_path(&self, node: usize, tolerance: Tolerance) -> Result<KeysToPath> {
        if self.edited_scene().is_none() {
            return Err(Refused::NoScene.into());
        }
        let mut scene = self.scene()?;
        let fitted = keys_to_path(&mut scene, node, self.info().fps, tolerance)?;
        let made = &scene.nodes()[node];
        let mut parts = vec_with_room(MOVED.len() + 3)?;
        if let Some(edited) = self.edited_scene() {
            let old = &edited.scene().nodes()[node];
            for channel in MOVED {
                if old.keys().track(&channel).is_some() {
                    parts.push(Part::track(node, channel, None)?);
                }
            }
        }
        parts.push(Part::Rest {
            node,
            rest: Box::new(Rest::of(made)),
        });
        parts.push(Part::Links {
            node,
            parent: made.parent,
            aim: made.aim,
        });
        parts.push(Part::path(node, made.path().cloned())?);
        let parts = parts.into_iter().map(|part| Edit::Part(Box::new(part)));
        Ok(KeysToPath {
            edits: parts.chain([Edit::EditNode(Some(node))]).collect(),
            points: fitted.points,
            off: fitted.off,
            turned: fitted.turned,
        })
    }
}

/// How near a path is that was fitted to a camera's keys.
#[derive(Debug, Clone, Copy)]
pub struct FittedKeys {
    /// Points of the path.
    pub points: usize,
    /// The farthest that a whole frame is from where it was, in world units.
    pub off: f64,
    /// And by how many degrees the view and its up are turned.
    pub turned: f64,
}

/// Lets a node follow a path in place of its keys and its aim, from the scene's first frame to
/// its last, within a tolerance. If it fails the scene may be half changed.
///
/// # Errors
/// As [`Document::keys_to_path`].
pub fn keys_to_path(
    scene: &mut Scene,
    node: usize,
    fps: f64,
    tolerance: Tolerance,
) -> Result<FittedKeys> {
    let (start, poses) = match scene.node(node)?.kind.looks() {
        true => poses_in_parent(scene, node)?,
        false => own_poses(scene, node)?,
    };
    let options = in_space(tolerance.into(), &poses, scene.space());
    let path = fit(&poses, None, fps, &options, &mut |_, _| true)?.path;
    let (off, turned) = missed(&path, &poses)?;
    let points = path.points.len();
    for channel in MOVED {
        scene.remove_track(node, &channel)?;
    }
    let mut still = scene.node(node)?.clone();
    still.aim = None;
    still.rest.roll = 0.0;
    scene.set_node(node, &still)?;
    let follow = FollowPath::new(path, start, Extrapolation::Hold)?;
    scene.set_path(node, Some(follow))?;
    Ok(FittedKeys {
        points,
        off,
        turned,
    })
}

/// As [`poses_in_parent`] of a node that looks nowhere: where it is, and how it is turned.
fn own_poses(scene: &Scene, node: usize) -> Result<(f64, Vec<Pose>)> {
    let (first, count) = frames(scene)?;
    let mut poses = vec_with_room(count)?;
    let mut warnings = Warnings::default();
    for at in 0..count {
        #[allow(clippy::cast_precision_loss)]
        let frame = first + at as f64;
        let mut value = |channel| scene.value(node, &channel, frame, &mut warnings);
        let turn = value(Channel::Rotation)?;
        let turn = DQuat::from_xyzw(turn[1], turn[2], turn[3], turn[0]);
        poses.push(Pose {
            vrp: DVec3::from_slice(&value(Channel::Position)?).to_array(),
            vpn: (turn * DVec3::Z).to_array(),
            vup: (turn * DVec3::Y).to_array(),
            zoom: Values::default().zoom,
        });
    }
    warnings
        .into_error()
        .map_or(Ok((first, poses)), |error| Err(error.into()))
}

/// The first frame of a scene, and how many whole steps it has.
fn frames(scene: &Scene) -> Result<(f64, usize)> {
    let (first, last) = scene.frame_range();
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    let count = (last - first).floor() as usize + 1;
    match count > MAX_SAMPLED_FRAMES {
        true => Err(TooMany::SampledFrames(count).into()),
        false => Ok((first, count)),
    }
}

/// The scene's first frame, and the poses from there on in the coordinates of the node's parent.
fn poses_in_parent(scene: &Scene, node: usize) -> Result<(f64, Vec<Pose>)> {
    let (first, count) = frames(scene)?;
    let states = |node: usize| -> Result<Vec<NodeState>> {
        let mut states = vec_with_room(count)?;
        states.resize(count, NodeState::default());
        let mut warnings = Warnings::default();
        scene.sample(node, first, 1.0, &mut states, &mut warnings)?;
        warnings
            .into_error()
            .map_or(Ok(states), |error| Err(error.into()))
    };
    let seen = states(node)?;
    let parents = scene.nodes()[node].parent.map(states).transpose()?;
    let mut poses = vec_with_room(count)?;
    for (at, state) in seen.iter().enumerate() {
        let mut pose = state.pose;
        if let Some(parents) = &parents {
            let into = parents[at].world().inverse();
            if !into.is_finite() {
                return Err(EngineError::Argument(Invalid::RotationZero).into());
            }
            let turned = |way: [f64; 3]| into.transform_vector3(way.into()).normalize().to_array();
            pose.vrp = into.transform_point3(pose.vrp.into()).to_array();
            (pose.vpn, pose.vup) = (turned(pose.vpn), turned(pose.vup));
        }
        poses.push(pose);
    }
    Ok((first, poses))
}

/// How far a path is at most from the poses at its whole frames.
fn missed(path: &CameraPath, poses: &[Pose]) -> Result<(f64, f64)> {
    let plan = Plan::new();
    let sampler = plan.sampler(path)?;
    let (mut off, mut turned): (f64, f64) = (0.0, 0.0);
    for (at, pose) in poses.iter().enumerate() {
        #[allow(clippy::cast_precision_loss)]
        let made = sampler.pose((at + 1).min(sampler.frame_count()) as f64)?;
        let place = |pose: &Pose| DVec3::from_array(pose.vrp);
        let turn = |pose: &Pose| quaternion_from_view(pose.vpn.into(), pose.vup.into());
        off = off.max(place(&made).distance(place(pose)));
        let (a, b) = (turn(pose), turn(&made));
        turned = turned.max(2.0 * angle(a, continue_sign(a, b).0).to_degrees());
    }
    Ok((off, turned))
}

#[cfg(test)]
mod tests {
    use vides_engine::scene::{Interpolation, Node, Track};

    use super::*;

    /// The example's camera looks at a car that drives; its keys move it along.
    #[test]
    fn a_camera_by_keys_comes_to_follow_a_path_that_sees_the_same() {
        let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/car.vid");
        let (mut document, _) = Document::load_scene(file.as_ref()).unwrap();
        let camera = document.scene().unwrap().shown_camera().unwrap();
        assert!(!document.edits_path());
        let all = |document: &Document| {
            let scene = document.scene().unwrap();
            let mut states = vec![NodeState::default(); 76];
            scene
                .sample(camera, 1.0, 1.0, &mut states, &mut Warnings::default())
                .unwrap();
            states.iter().map(|state| state.pose).collect::<Vec<_>>()
        };
        let before = all(&document);
        let made = document
            .keys_to_path(camera, document.usual_tolerance())
            .unwrap();
        assert!(made.points >= 2 && made.points < 40, "{}", made.points);
        document.apply_all(made.edits).unwrap();
        assert!(document.edits_path());
        assert_eq!(document.edited_scene().unwrap().node(), Some(camera));
        let after = all(&document);
        let half_size = document.path().space.half_size;
        for (a, b) in before.iter().zip(&after) {
            let [a, b, u, v] = [a.vrp, b.vrp, a.vpn, b.vpn].map(DVec3::from_array);
            assert!(a.distance(b) <= (1.001 * NEAR * half_size).min(made.off + 1e-12));
            let turned = u.dot(v).clamp(-1.0, 1.0).acos().to_degrees();
            assert!(
                turned <= made.turned + 1e-5 && made.turned < 1.01 * ANGLE,
                "{turned}"
            );
        }
        // It is one step.
        assert!(document.undo() && !document.edits_path() && !document.can_undo());
        let near = document.usual_tolerance();
        assert!(document.keys_to_path(99, near).is_err());
        assert!(Document::new().keys_to_path(0, near).is_err());
        let none = Tolerance {
            position: 0.0,
            angle: 1.0,
        };
        assert!(document.keys_to_path(camera, none).is_err());
    }

    /// A group's keys become a path, and that becomes few keys; both stay as near as asked, and
    /// the reported deviation is the real one.
    #[test]
    fn keys_of_a_group_become_a_path_and_few_keys_again() {
        let mut group = Node::new("drone", vides_engine::scene::Kind::Group);
        group.pivot = DVec3::new(0.1, 0.0, 0.2);
        let track = |channel: Channel, values: &[f64]| {
            let frames = vec![1.0, 20.0, 45.0, 70.0];
            let by = Interpolation::CatmullRom;
            Track::new(channel, by, frames, values.to_vec(), Vec::new()).unwrap()
        };
        let places = [0.0, 0.0, 0.0, 0.5, 0.1, 0.0, 0.6, 0.2, 0.5, 0.0, 0.4, 0.7];
        group.set_track(track(Channel::Position, &places)).unwrap();
        let turns: Vec<f64> = [0.0, 0.4, 0.7, 0.2]
            .into_iter()
            .flat_map(|turn: f64| [turn.cos(), 0.0, turn.sin(), 0.0])
            .collect();
        group.set_track(track(Channel::Rotation, &turns)).unwrap();
        let mut document = Document::new();
        document.apply(Edit::AddNodes(vec![group])).unwrap();
        let values = |document: &Document| -> Vec<(DVec3, DQuat)> {
            let scene = document.scene().unwrap();
            let value = |channel: Channel, frame: f64| {
                let warnings = &mut Warnings::default();
                scene.value(1, &channel, frame, warnings).unwrap()
            };
            let at = |frame: i32| {
                let frame = f64::from(frame);
                let q = value(Channel::Rotation, frame);
                let place = DVec3::from_slice(&value(Channel::Position, frame));
                (place, DQuat::from_xyzw(q[1], q[2], q[3], q[0]))
            };
            (1..=70).map(at).collect()
        };
        let missed = |a: &[(DVec3, DQuat)], b: &[(DVec3, DQuat)]| {
            a.iter()
                .zip(b)
                .fold((0.0_f64, 0.0_f64), |(off, turned), (a, b)| {
                    let turn = 2.0 * a.1.dot(b.1).abs().min(1.0).acos().to_degrees();
                    (off.max(a.0.distance(b.0)), turned.max(turn))
                })
        };
        let before = values(&document);
        for (position, angle) in [(0.01, 1.0), (0.001, 0.1)] {
            let near = Tolerance { position, angle };
            let made = document.keys_to_path(1, near).unwrap();
            let (told_off, told_turned) = (made.off, made.turned);
            document.apply_all(made.edits).unwrap();
            let along = values(&document);
            let (off, turned) = missed(&before, &along);
            assert!(
                off <= 1.01 * position && turned <= 1.01 * angle,
                "{off} {turned}"
            );
            assert!((off - told_off).abs() < 1e-9 && (turned - told_turned).abs() < 1e-4);
            // And back: as few as a tenth of the frames.
            let made = document.path_to_few_keys(1, near).unwrap();
            let (told_off, told_turned, keys) = (made.off, made.turned, made.keys);
            document.apply_all(made.edits).unwrap();
            let (off, turned) = missed(&along, &values(&document));
            assert!(off <= position && turned <= angle + 1e-5, "{off} {turned}");
            assert!((off - told_off).abs() < 1e-9 && (turned - told_turned).abs() < 1e-4);
            assert!((4..40).contains(&keys), "{keys}");
            let scene = document.scene().unwrap();
            let tracks = scene.nodes()[1].keys().tracks().iter();
            assert_eq!(
                tracks.map(|track| track.frames().len()).sum::<usize>(),
                keys
            );
            assert!(document.undo() && document.undo());
            assert_eq!(values(&document), before);
        }
        let none = Tolerance {
            position: f64::NAN,
            angle: 1.0,
        };
        assert!(document.path_to_few_keys(0, none).is_err());
        assert!(
            document
                .path_to_few_keys(1, document.usual_tolerance())
                .is_err()
        );
    }
}
