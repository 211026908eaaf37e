//! A node that moves keeps its way through the world in another parent.
//!
//! Where both parents rest and the way from the one into the other turns, scales evenly and moves,
//! so do the keys, or the points of the path: interpolations commute with such a map. Else there is
//! a key a frame. What was made is held against what was there at every frame of the scene.

use glam::{DAffine3, DMat4, DQuat, DVec3, DVec4};

use super::channel::Channel;
use super::motion::{FollowPath, Motion as _};
use super::part::{Part, Rest};
use super::reparent::{KEPT, without_shear};
use super::scene::Scene;
use super::state::{NodeState, Warnings};
use super::track::{Interpolation, Track};
use super::values::Values;
use crate::error::{Invalid, Result, TooMany, can_allocate, vec_with_room};
use crate::limits::MAX_FRAMES;
use crate::math::quaternion::continue_sign;
use crate::tools::transform::transform;

/// How even a scale must be, and how square its axes, for keys to be transformed by it.
const EVEN: f64 = 1e-12;

/// A map that turns, scales evenly and moves; and where it puts positions of a node with a pivot.
struct Similar {
    turn: DQuat,
    scale: f64,
    by: DVec3,
}

impl Similar {
    /// The map of a node's numbers by which its local matrix becomes `map` times that.
    fn of(map: &DAffine3, pivot: DVec3) -> Option<Self> {
        let linear = map.matrix3;
        let columns = [linear.x_axis, linear.y_axis, linear.z_axis];
        let scale = columns[0].length();
        let even = columns
            .iter()
            .all(|column| (column.length() - scale).abs() <= EVEN * scale);
        let square = |a: usize, b: usize| columns[a].dot(columns[b]).abs() <= EVEN * scale * scale;
        let proper = linear.determinant() > 0.0;
        if !(scale > 0.0 && even && square(0, 1) && square(1, 2) && square(2, 0) && proper) {
            return None;
        }
        Some(Self {
            turn: DQuat::from_mat3(&(linear * (1.0 / scale))).normalize(),
            scale,
            by: linear * pivot + map.translation - pivot,
        })
    }

    fn way(&self, way: DVec3) -> DVec3 {
        self.turn * (self.scale * way)
    }

    fn values(&self, old: &Values) -> Values {
        Values {
            position: self.way(old.position) + self.by,
            rotation: self.turn * old.rotation,
            scale: self.scale * old.scale,
            ..*old
        }
    }

    /// The track of a channel with its numbers mapped; none for angles, which are not.
    fn track(&self, track: &Track) -> Result<Option<Track>> {
        let (channel, width) = (track.channel(), track.width());
        let by = match channel {
            Channel::Position => self.by,
            _ => DVec3::ZERO,
        };
        let one = |numbers: &mut [f64], by: DVec3| match (channel, &*numbers) {
            (Channel::Position, &[x, y, z]) => {
                let place = self.way(DVec3::new(x, y, z)) + by;
                numbers.copy_from_slice(&place.to_array());
            }
            (Channel::Rotation, &[w, x, y, z]) => {
                // Of tangents the length counts, too.
                let turned = self.turn * DQuat::from_vec4(DVec4::new(x, y, z, w));
                numbers.copy_from_slice(&[turned.w, turned.x, turned.y, turned.z]);
            }
            _ => numbers.iter_mut().for_each(|number| *number *= self.scale),
        };
        if *channel == Channel::Rotation && width != 4 {
            return Ok(None);
        }
        let copy = |numbers: &[f64]| -> Result<Vec<f64>> {
            let mut copy = vec_with_room(numbers.len())?;
            copy.extend_from_slice(numbers);
            Ok(copy)
        };
        let frames = copy(track.frames())?;
        let (mut values, mut shape) = (copy(track.values())?, copy(track.shape())?);
        values.chunks_mut(width).for_each(|key| one(key, by));
        if *track.interpolation() == Interpolation::Hermite {
            shape
                .chunks_mut(width)
                .for_each(|key| one(key, DVec3::ZERO));
        }
        let interpolation = track.interpolation().clone();
        let new = Track::new(channel.clone(), interpolation, frames, values, shape)?;
        let (before, after) = track.extrapolation();
        new.with_extrapolation(before, after).map(Some)
    }
}

impl Scene {
    /// The parts whose exchange gives a node another parent and keeps its way through the world at
    /// every frame of the scene, to 1e-9.
    ///
    /// # Errors
    /// As [`Scene::set_parent`]; [`crate::Error::Argument`] where it would need a shear, for a path whose
    /// parents move or that would not fly the same; [`crate::Error::Limit`], [`crate::Error::Memory`].
    pub fn way_in(&self, at: usize, parent: Option<usize>) -> Result<Vec<Part>> {
        self.check_parent(at, parent)?;
        let node = self.node(at)?;
        let follows = node.path().is_some();
        if self.rests(node.parent) && self.rests(parent) {
            let first = self.frame_range().0;
            let mut states = self.scratch()?;
            self.evaluate(first, &mut states, &mut Warnings::default())?;
            let world = |of: Option<usize>| of.map_or(DAffine3::IDENTITY, |of| states[of].world());
            let map = world(parent).inverse() * world(node.parent);
            if let Some(similar) = Similar::of(&map, node.pivot)
                && let Some(parts) = self.mapped(at, parent, &similar)?
                && self.keeps_way(at, &parts)?
            {
                return Ok(parts);
            }
            if follows {
                return Err(Invalid::PathFliesOtherwise((&node.name).into()).into());
            }
        } else if follows {
            return Err(Invalid::WayOfPath((&node.name).into()).into());
        }
        let parts = self.key_a_frame(at, parent)?;
        match self.keeps_way(at, &parts)? {
            true => Ok(parts),
            false => Err(Invalid::NeedsShear((&node.name).into()).into()),
        }
    }

    /// Whether a node and all that it is in rest.
    fn rests(&self, node: Option<usize>) -> bool {
        let mut above = std::iter::successors(node, |&up| self.nodes()[up].parent);
        above.all(|up| {
            let of = &self.nodes()[up];
            !of.moves() && of.aim.is_none() && of.keys().track(&Channel::Roll).is_none()
        })
    }

    fn links(&self, at: usize, parent: Option<usize>) -> Part {
        let aim = self.nodes()[at].aim;
        Part::Links {
            node: at,
            parent,
            aim,
        }
    }

    /// The parts with all numbers mapped; none where angles are.
    fn mapped(
        &self,
        at: usize,
        parent: Option<usize>,
        similar: &Similar,
    ) -> Result<Option<Vec<Part>>> {
        let node = &self.nodes()[at];
        let mut parts = vec_with_room(6)?;
        for channel in [Channel::Position, Channel::Rotation, Channel::Scale] {
            if let Some(track) = node.keys().track(&channel) {
                let Some(new) = similar.track(track)? else {
                    return Ok(None);
                };
                parts.push(Part::track(at, channel, Some(new))?);
            }
        }
        if let Some(follow) = node.path() {
            let (path, count) = (follow.path(), follow.path().points.len());
            let all: Vec<usize> = (0..count).collect();
            let scale = DVec3::splat(similar.scale);
            let map = DMat4::from_scale_rotation_translation(scale, similar.turn, similar.by);
            let mut new = path.try_clone()?;
            // As long a way in its space as before.
            new.space.half_size *= similar.scale;
            new.space.centre = map.transform_point3(new.space.centre);
            for (number, point) in transform(path, &all, &map, true)? {
                new.points[number] = point;
            }
            let new = FollowPath::new(new, follow.start_frame(), follow.extrapolation())?;
            parts.push(Part::path(at, Some(new))?);
        }
        parts.push(self.rest_part(at, similar.values(&node.rest))?);
        parts.push(self.links(at, parent));
        Ok(Some(parts))
    }

    fn rest_part(&self, at: usize, values: Values) -> Result<Part> {
        can_allocate(size_of::<Rest>())?;
        let rest = Rest {
            values,
            ..Rest::of(&self.nodes()[at])
        };
        Ok(Part::Rest {
            node: at,
            rest: Box::new(rest),
        })
    }

    /// The frames of the scene: whole steps from the first one, and the last.
    fn steps(&self) -> Result<Vec<f64>> {
        let (first, last) = self.frame_range();
        if !(last - first < MAX_FRAMES as f64) {
            return Err(TooMany::SceneFrames(MAX_FRAMES).into());
        }
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
        let count = (last - first).floor() as usize + 1;
        let mut frames = vec_with_room(count + 1)?;
        frames.extend((0..count).map(|step| first + step as f64));
        if frames.last() != Some(&last) {
            frames.push(last);
        }
        Ok(frames)
    }

    /// The states of some nodes at these frames; none: the world.
    fn worlds(&self, of: Option<usize>, frames: &[f64]) -> Result<Vec<DAffine3>> {
        let mut worlds = vec_with_room(frames.len())?;
        let Some(node) = of else {
            worlds.resize(frames.len(), DAffine3::IDENTITY);
            return Ok(worlds);
        };
        let mut states = [NodeState::default()];
        for &frame in frames {
            self.sample(node, frame, 1.0, &mut states, &mut Warnings::default())?;
            worlds.push(states[0].world());
        }
        Ok(worlds)
    }

    fn key_a_frame(&self, at: usize, parent: Option<usize>) -> Result<Vec<Part>> {
        let node = &self.nodes()[at];
        let frames = self.steps()?;
        let (old, new) = (
            self.worlds(node.parent, &frames)?,
            self.worlds(parent, &frames)?,
        );
        let mut keys: [Vec<f64>; 3] = Default::default();
        for (keys, width) in keys.iter_mut().zip([3, 4, 3]) {
            *keys = vec_with_room(width * frames.len())?;
        }
        let (mut last, mut rest) = (None, node.rest);
        for ((&frame, old), new) in frames.iter().zip(&old).zip(&new) {
            let mut values = node.rest;
            node.keys()
                .at(frame, &mut values, &mut Warnings::default())?;
            let wanted = new.inverse() * (*old * super::hierarchy::local(node, &values));
            let made = without_shear(node, &wanted, values.scale)?;
            let turn = last.map_or(made.rotation, |last| continue_sign(last, made.rotation).0);
            if last.is_none() {
                rest = made;
            }
            last = Some(turn);
            keys[0].extend(made.position.to_array());
            keys[1].extend([turn.w, turn.x, turn.y, turn.z]);
            keys[2].extend(made.scale.to_array());
        }
        let mut parts = vec_with_room(5)?;
        let channels = [Channel::Position, Channel::Rotation, Channel::Scale];
        for ((channel, values), width) in channels.into_iter().zip(keys).zip([3, 4, 3]) {
            let still = values.chunks(width).all(|key| *key == values[..width]);
            let track = match still {
                true => None,
                false => {
                    let mut at = vec_with_room(frames.len())?;
                    at.extend_from_slice(&frames);
                    let by = Interpolation::Linear;
                    Some(Track::new(channel.clone(), by, at, values, Vec::new())?)
                }
            };
            parts.push(Part::track(at, channel, track)?);
        }
        parts.push(self.rest_part(at, rest)?);
        parts.push(self.links(at, parent));
        Ok(parts)
    }

    /// Whether a node's world matrices are the same at every frame with these parts.
    fn keeps_way(&self, at: usize, parts: &[Part]) -> Result<bool> {
        let mut new = self.clone();
        for part in parts {
            new.apply(part.clone())?;
        }
        let frames = self.steps()?;
        let (old, new) = (
            self.worlds(Some(at), &frames)?,
            new.worlds(Some(at), &frames)?,
        );
        let near = |(old, new): (&DAffine3, &DAffine3)| {
            let columns = |of: &DAffine3| of.to_cols_array();
            let size = columns(old)
                .into_iter()
                .fold(1.0, |a: f64, b| a.max(b.abs()));
            old.abs_diff_eq(*new, KEPT * size)
        };
        Ok(old.iter().zip(&new).all(near))
    }
}

#[cfg(test)]
#[path = "keep_way_tests.rs"]
mod tests;
