//! A pivot that moves while its node stays, and keys of a position that are moved in space.
//!
//! The matrix of a node is T(position)·T(pivot)·R·S·T(−pivot): with a pivot that is d farther it is
//! the same where its position is R·S·d − d farther. While rotation and scale rest that is one number
//! for all frames, and keys of the position change with it. Where these move by keys it differs at
//! each frame: the position gets a key a frame then, and one where another key lies.

use glam::{DMat3, DQuat, DVec3};
use vides_document::Edit;
use vides_document::error::{Refused, Result};
use vides_engine::scene::{Channel, Interpolation, Node, Part, Rest, Scene, Track, Warnings};

use super::values::not_by_path;
use crate::state::Editor;
use crate::texts::fill;
use crate::texts::refusals::of_edit;

/// Most frames of which each gets a key.
const MOST: f64 = 100_000.0;

impl Editor {
    /// The edits that move a node's pivot to a position in its coordinates, or why they fail.
    pub(crate) fn pivot_edits(&self, node: usize, pivot: DVec3) -> Result<Vec<Edit>, String> {
        let told = |error| of_edit(self.language(), &error);
        let of = self.node_of_scene(node).map_err(told)?;
        not_by_path(of, &Channel::Position).map_err(told)?;
        let (first, last) = self.keyed_range();
        if turns(of) && last - first >= MOST {
            return Err(fill(self.texts().space.pivot_too_long, &[&of.name, &MOST]));
        }
        let scene = self.with_scene(|now| edits(&now.scene, node, pivot, (first, last)));
        let edits = scene.map_err(told)?.ok_or(Refused::NoScene.into());
        let edits = edits.and_then(|edits| edits).map_err(told)?;
        let edits = edits.into_iter().map(|part| Edit::Part(Box::new(part)));
        Ok(edits.collect())
    }

    /// Whether a pivot that moves gives the position of its node a key a frame.
    pub(crate) fn pivot_makes_keys(&self, node: usize) -> bool {
        self.node_of_scene(node).is_ok_and(turns)
    }

    /// The whole frames of the scene.
    fn keyed_range(&self) -> (f64, f64) {
        let edited = self.document.edited_scene();
        let (first, last) = edited.map_or((1.0, 1.0), |edited| edited.scene().frame_range());
        (first.floor(), last.ceil())
    }

    /// The edit that gives a key of a node's position another value.
    pub(crate) fn key_edit(&self, node: usize, key: usize, value: DVec3) -> Result<Edit> {
        let of = self.node_of_scene(node)?;
        let channel = Channel::Position;
        let track = of.keys().track(&channel).ok_or(Refused::NoScene)?;
        let mut put = track.keys(&[key])?;
        put.values.copy_from_slice(&value.to_array());
        let remove = Vec::new();
        let part = Part::Keys {
            node,
            channel,
            remove,
            put,
        };
        Ok(Edit::Part(Box::new(part)))
    }
}

/// Whether keys turn or scale a node, or a host's function moves it, which may do with other values
/// as it likes.
fn turns(of: &Node) -> bool {
    let mut both = [Channel::Rotation, Channel::Scale].into_iter();
    let position = of.keys().track(&Channel::Position);
    let host = |track: &Track| matches!(track.interpolation(), Interpolation::Host(_));
    both.any(|channel| of.keys().track(&channel).is_some()) || position.is_some_and(host)
}

fn edits(scene: &Scene, node: usize, pivot: DVec3, range: (f64, f64)) -> Result<Vec<Part>> {
    let of = scene.node(node)?;
    let by = pivot - of.pivot;
    let mut rest = Rest::of(of);
    rest.pivot = pivot;
    let away = |rotation: DQuat, scale: DVec3| {
        let own = DMat3::from_quat(rotation.normalize()) * DMat3::from_diagonal(scale);
        own * by - by
    };
    let channel = Channel::Position;
    let track = of.keys().track(&channel);
    let position = if turns(of) {
        let track = position_by_frames(scene, node, range, away)?;
        Some(Part::track(node, channel, Some(track))?)
    } else {
        let away = away(of.rest.rotation, of.rest.scale);
        match track {
            Some(track) => {
                let all: Vec<usize> = (0..track.frames().len()).collect();
                let mut put = track.keys(&all)?;
                for value in put.values.chunks_exact_mut(3) {
                    value.copy_from_slice(&(DVec3::from_slice(value) + away).to_array());
                }
                let remove = Vec::new();
                Some(Part::Keys {
                    node,
                    channel,
                    remove,
                    put,
                })
            }
            None => {
                rest.values.position += away;
                None
            }
        }
    };
    let rest = Box::new(rest);
    let mut parts = vec![Part::Rest { node, rest }];
    parts.extend(position);
    Ok(parts)
}

/// The position with a key a frame, farther by what rotation and scale make of the pivot's way.
fn position_by_frames(
    scene: &Scene,
    node: usize,
    (first, last): (f64, f64),
    away: impl Fn(DQuat, DVec3) -> DVec3,
) -> Result<Track> {
    let moving = [Channel::Position, Channel::Rotation, Channel::Scale];
    let keys = scene.node(node)?.keys();
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    let count = (last - first) as u32;
    let mut frames: Vec<f64> = (0..=count).map(|at| first + f64::from(at)).collect();
    for track in moving.iter().filter_map(|channel| keys.track(channel)) {
        frames.extend(track.frames());
    }
    frames.sort_by(f64::total_cmp);
    frames.dedup();
    let mut values = Vec::with_capacity(3 * frames.len());
    for &frame in &frames {
        let of = |channel| scene.value(node, channel, frame, &mut Warnings::default());
        let rotation = of(&Channel::Rotation)?;
        let [w, x, y, z] = [0, 1, 2, 3].map(|at: usize| rotation[at]);
        let scale = DVec3::from_slice(&of(&Channel::Scale)?);
        let position = DVec3::from_slice(&of(&Channel::Position)?);
        values.extend((position + away(DQuat::from_xyzw(x, y, z, w), scale)).to_array());
    }
    let by = Interpolation::Linear;
    Ok(Track::new(
        Channel::Position,
        by,
        frames,
        values,
        Vec::new(),
    )?)
}
