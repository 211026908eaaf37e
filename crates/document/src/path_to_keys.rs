//! A node that follows a path comes to move by keys, one a frame.

use vides_engine::scene::{Channel, FollowPath, Interpolation, Kind, Part, Track};

use super::edit::Edit;
use super::editing::Document;
use crate::error::{Refused, Result, vec_with_room};
use crate::math::orientation::quaternion_from_view;
use crate::math::quaternion::continue_sign;
use crate::path::Pose;

impl Document {
    /// The edits that let a node move by keys in place of its path: one a frame, straight from one
    /// to the next. At whole frames it is where it was, to 1e-12.
    ///
    /// # Errors
    /// `ErrorKind::Argument` if it follows no path, `ErrorKind::Range` if there is no such node;
    /// `ErrorKind::Limit` for more keys than a track has.
    pub fn path_to_keys(&self, node: usize) -> Result<Vec<Edit>> {
        let present;
        let (follow, camera) = match self.edited_scene() {
            Some(edited) => {
                present = match edited.node() == Some(node) {
                    true => edited.present_path(self.path())?,
                    false => None,
                };
                let of = edited.scene().node(node)?;
                let camera = matches!(of.kind, Kind::Camera(_));
                let none = || Refused::NoPathOf((&of.name).into());
                (present.as_ref().or(of.path()).ok_or_else(none)?, camera)
            }
            None if node == 0 => {
                let path = self.path().try_clone()?;
                present = Some(FollowPath::new(path, 1.0, Default::default())?);
                (present.as_ref().ok_or(Refused::NoScene)?, true)
            }
            None => return Err(Refused::NoScene.into()),
        };
        let count = follow.count();
        let mut poses = vec_with_room(count)?;
        poses.resize(count, Pose::default());
        follow.sampler()?.sample_once(1, &mut poses)?;
        let mut parts = vec_with_room(4)?;
        parts.push(Part::path(node, None)?);
        let mut places = vec_with_room(3 * count)?;
        let mut turns = vec_with_room(4 * count)?;
        let mut last = None;
        for pose in &poses {
            places.extend(pose.vrp);
            let turn = quaternion_from_view(pose.vpn.into(), pose.vup.into());
            let turn = last.map_or(turn, |last| continue_sign(last, turn).0);
            last = Some(turn);
            turns.extend([turn.w, turn.x, turn.y, turn.z]);
        }
        let mut zooms = vec_with_room(count)?;
        zooms.extend(poses.iter().map(|pose| pose.zoom));
        let tracks = [
            (Channel::Position, places),
            (Channel::Rotation, turns),
            (Channel::Zoom, zooms),
        ];
        let beyond = follow.extrapolation();
        for (channel, values) in tracks.into_iter().take(if camera { 3 } else { 2 }) {
            let mut frames = vec_with_room(count)?;
            #[allow(clippy::cast_precision_loss)] // MAX_KEYS
            frames.extend((0..count).map(|at| follow.start_frame() + at as f64));
            let track = Track::new(
                channel.clone(),
                Interpolation::Linear,
                frames,
                values,
                Vec::new(),
            )?;
            let track = track.with_extrapolation(beyond, beyond)?;
            parts.push(Part::track(node, channel, Some(track))?);
        }
        let edits = parts.into_iter().map(|part| Edit::Part(Box::new(part)));
        Ok(edits.collect())
    }
}
