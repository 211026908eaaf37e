//! Values of nodes, changed in one place: a key at the playhead where the channel has a track, else
//! what the node has at rest; and the keys that come and go there.

use glam::{DQuat, DVec4};
use vides_document::Edit;
use vides_document::error::{Invalid, OutOfRange, Refused, Result};
use vides_engine::deform::check_number;
use vides_engine::math::euler::EulerAngles;
use vides_engine::scene::time::local_frame;
use vides_engine::scene::{
    Channel, Extrapolation, Interpolation, KeyList, Kind, Node, Part, Rest, Scene, Track, Warnings,
};

use crate::state::Editor;

/// Those for which K sets keys.
const PLACE: [Channel; 3] = [Channel::Position, Channel::Rotation, Channel::Scale];

/// Whether a channel has a key at the playhead.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum KeyState {
    NoTrack,
    NotHere,
    Here,
}

impl Editor {
    /// The numbers of a channel at the playhead as its keys have them, so of rotations by Euler
    /// angles yaw, pitch and roll in degrees, else w, x, y, z.
    pub(crate) fn channel_value(&self, node: usize, channel: &Channel) -> Option<Vec<f64>> {
        let value = self.with_scene(|now| value_of(&now.scene, node, channel, now.frame));
        value.ok()??.ok()
    }

    /// Whether it has a key at the playhead.
    pub(crate) fn key_state(&self, node: usize, channel: &Channel) -> KeyState {
        let of = self.node_of_scene(node).ok();
        let Some(track) = of.and_then(|of| of.keys().track(channel)) else {
            return KeyState::NoTrack;
        };
        let frame = self
            .previewed_frame()
            .map(|frame| key_frame(Some(track), frame));
        match frame.ok().and_then(|frame| key_at(track, frame)) {
            Some(_) => KeyState::Here,
            None => KeyState::NotHere,
        }
    }

    /// Sets the numbers of a channel: in a key at the playhead, rounded to a whole frame, where it
    /// has a track, else at rest. Rotations are w, x, y, z, or yaw, pitch and roll in degrees. It is
    /// a part of the open step, or a new one; false with a message if refused.
    pub(crate) fn set_channel(&mut self, node: usize, channel: &Channel, value: &[f64]) -> bool {
        match self.value_part(node, channel, value) {
            Ok(part) => self.edit(Edit::Part(Box::new(part))),
            Err(error) => {
                self.complain_of(&error);
                false
            }
        }
    }

    /// Makes a track of one key, sets a key with the value that is there, or removes the one that
    /// is; the last one's value is that of rest then.
    pub(crate) fn switch_key(&mut self, node: usize, channel: &Channel) {
        match self.switched(node, channel) {
            Ok(part) => drop(self.edit_all([Edit::Part(Box::new(part))])),
            Err(error) => self.complain_of(&error),
        }
    }

    /// Sets missing keys for position, rotation and scale of the selected nodes, in
    /// one step.
    pub(crate) fn set_keys(&mut self) {
        let nodes = self.selected_nodes();
        let all = nodes
            .iter()
            .flat_map(|&node| PLACE.map(|channel| (node, channel)));
        let missing =
            all.filter(|(node, channel)| self.key_state(*node, channel) != KeyState::Here);
        let parts: Result<Vec<Part>> = missing
            .map(|(node, channel)| self.switched(node, &channel))
            .collect();
        match parts {
            Ok(parts) if parts.is_empty() && nodes.is_empty() => {}
            Ok(parts) if parts.is_empty() => self.say(self.texts().node.keys_are_there),
            Ok(parts) => {
                let edits = parts.into_iter().map(|part| Edit::Part(Box::new(part)));
                if self.edit_all(edits) {
                    self.say_done(self.texts().node.keys_set.to_owned());
                }
            }
            Err(error) => self.complain_of(&error),
        }
    }

    /// A node with its tracks; its path is as it was when its node was chosen.
    pub(super) fn node_of_scene(&self, node: usize) -> Result<&Node> {
        let edited = self.document.edited_scene().ok_or(Refused::NoScene)?;
        Ok(edited.scene().node(node)?)
    }

    fn value_part(&self, node: usize, channel: &Channel, value: &[f64]) -> Result<Part> {
        let of = self.node_of_scene(node)?;
        not_by_path(of, channel)?;
        let Some(track) = of.keys().track(channel) else {
            return at_rest(of, node, channel, value);
        };
        let frame = key_frame(Some(track), self.previewed_frame()?);
        Ok(Part::Keys {
            node,
            channel: channel.clone(),
            remove: Vec::new(),
            put: with_value(track, frame, value)?,
        })
    }

    fn switched(&self, node: usize, channel: &Channel) -> Result<Part> {
        let of = self.node_of_scene(node)?;
        not_by_path(of, channel)?;
        let frame = self.previewed_frame()?;
        let Some(track) = of.keys().track(channel) else {
            let first = self.with_scene(|now| first_key(&now.scene, node, channel, frame))?;
            return first.ok_or(Refused::NoScene)?;
        };
        let frame = key_frame(Some(track), frame);
        let (remove, put) = match key_at(track, frame) {
            Some(key) => (vec![key], KeyList::default()),
            None => (Vec::new(), key_on_curve(track, frame)),
        };
        Ok(Part::Keys {
            node,
            channel: channel.clone(),
            remove,
            put,
        })
    }
}

/// Whether the path that a node follows moves this.
pub(super) fn path_moves(of: &Node, channel: &Channel) -> bool {
    use Channel::{Position, Rotation, Zoom};
    of.path().is_some() && matches!(channel, Position | Rotation | Zoom)
}

pub(super) fn not_by_path(of: &Node, channel: &Channel) -> Result<()> {
    if path_moves(of, channel) {
        return Err(Invalid::PathMovesIt {
            node: (&of.name).into(),
            channel: channel.into(),
        }
        .into());
    }
    Ok(())
}

/// The frame of a key at the playhead: one that is there, else a whole one.
fn key_frame(track: Option<&Track>, frame: f64) -> f64 {
    let there = track.is_some_and(|track| key_at(track, frame).is_some());
    // No minus zero.
    if there { frame } else { frame.round() + 0.0 }
}

/// The number of the key at a frame.
fn key_at(track: &Track, frame: f64) -> Option<usize> {
    let at = track.frames().partition_point(|key| *key < frame);
    (track.frames().get(at) == Some(&frame)).then_some(at)
}

fn value_of(scene: &Scene, node: usize, channel: &Channel, frame: f64) -> Result<Vec<f64>> {
    let track = scene.node(node)?.keys().track(channel);
    let frame = key_frame(track, frame);
    let warnings = &mut Warnings::default();
    match track.filter(|track| by_angles(track)) {
        Some(track) => {
            let mut angles = vec![0.0; 3];
            track.numbers(frame, &mut angles, warnings);
            Ok(angles)
        }
        None => Ok(scene.value(node, channel, frame, warnings)?),
    }
}

fn by_angles(track: &Track) -> bool {
    *track.channel() == Channel::Rotation && track.width() == 3
}

/// The track of one key, with the value that is there.
fn first_key(scene: &Scene, node: usize, channel: &Channel, frame: f64) -> Result<Part> {
    let frame = key_frame(None, frame);
    let value = value_of(scene, node, channel, frame)?;
    let by = match channel {
        Channel::Visible => Interpolation::Step,
        _ => Interpolation::Linear,
    };
    let track = Track::new(channel.clone(), by, vec![frame], value, Vec::new())?;
    Ok(Part::track(node, channel.clone(), Some(track))?)
}

/// A key, at a frame without one, that leaves the value there as it is. One of `hermite` takes the
/// tangents of the curve, which stays the same; beyond an end that holds so does the key at that
/// end. (Beyond an end that repeats, the period is another one from then on.)
pub(crate) fn key_on_curve(track: &Track, frame: f64) -> KeyList {
    let (width, warnings) = (track.width(), &mut Warnings::default());
    let hermite = *track.interpolation() == Interpolation::Hermite;
    let mut values = vec![0.0; width];
    if *track.channel() == Channel::Rotation && width == 4 && !hermite {
        values.copy_from_slice(&wxyz(track.rotation(frame, warnings)));
    } else {
        // Of `hermite` as long as the curve between the keys is, so that both are in proportion.
        track.numbers(frame, &mut values, warnings);
    }
    let slopes = match track.interpolation() {
        Interpolation::Hermite => slope(track, frame),
        Interpolation::Tcb => vec![0.0; 3],
        _ => Vec::new(),
    };
    let mut put = KeyList {
        frames: vec![frame],
        values,
        shape: slopes.clone(),
    };
    if !hermite {
        return put;
    }
    put.shape.extend(&slopes);
    let ((first, last), (before, after)) = (track.ends(), track.extrapolation());
    let end = match (frame < first, frame > last) {
        (true, _) if before == Extrapolation::Hold => 0,
        (_, true) if after == Extrapolation::Hold => track.frames().len() - 1,
        _ => return put,
    };
    let value = &track.values()[width * end..][..width];
    let [into, out] = [0, width].map(|side| &track.shape()[2 * width * end + side..][..width]);
    let still = vec![0.0; width];
    if end == 0 && frame < first {
        put.frames.push(first);
        put.values.extend(value);
        put.shape.extend(still.iter().chain(out));
    } else {
        put.frames.insert(0, last);
        put.values.splice(..0, value.iter().copied());
        put.shape.splice(..0, into.iter().chain(&still).copied());
    }
    put
}

/// How fast the numbers of a track of `hermite` change at a frame, per frame.
fn slope(track: &Track, frame: f64) -> Vec<f64> {
    let ((first, last), (before, after)) = (track.ends(), track.extrapolation());
    let beyond = match frame {
        frame if frame < first => before,
        frame if frame > last => after,
        _ => Extrapolation::Repeat,
    };
    let (width, frames, period) = (track.width(), track.frames(), last - first);
    if beyond == Extrapolation::Hold || frames.len() < 2 {
        return vec![0.0; width];
    }
    let back =
        beyond == Extrapolation::PingPong && (frame - first).rem_euclid(2.0 * period) > period;
    let (local, _) = local_frame(frame, first, last, before, after);
    let behind = frames.partition_point(|key| *key <= local);
    let section = behind.clamp(1, frames.len() - 1) - 1;
    let step = frames[section + 1] - frames[section];
    let u = (local - frames[section]) / step;
    let number = |at: usize| {
        let [from, to] = [0, 1].map(|key| track.values()[(section + key) * width + at]);
        let [r, s] = [1, 2].map(|side| step * track.shape()[(2 * section + side) * width + at]);
        let rise = to - from;
        let (b, a) = (3.0 * rise - 2.0 * r - s, r + s - 2.0 * rise);
        let slope = ((3.0 * a * u + 2.0 * b) * u + r) / step;
        if back { -slope } else { slope }
    };
    (0..width).map(number).collect()
}

/// The key at a frame with another value, and what must come with it.
fn with_value(track: &Track, frame: f64, value: &[f64]) -> Result<KeyList> {
    let mut put = match key_at(track, frame) {
        Some(key) => track.keys(&[key])?,
        None => key_on_curve(track, frame),
    };
    let width = track.width();
    let at = put.frames.iter().position(|key| *key == frame);
    let old = &mut put.values[width * at.unwrap_or(0)..][..width];
    let new = as_key(track, value, old);
    if new.len() != width {
        return Err(OutOfRange::KeyWidth {
            wanted: width,
            given: new.len(),
        }
        .into());
    }
    old.copy_from_slice(&new);
    Ok(put)
}

/// A value as the keys of a track have it.
fn as_key(track: &Track, value: &[f64], old: &[f64]) -> Vec<f64> {
    if *track.channel() != Channel::Rotation {
        return value.to_vec();
    }
    let rotation = match *value {
        [w, x, y, z] => DVec4::new(w, x, y, z),
        [_, _, _] if by_angles(track) => return value.to_vec(),
        [yaw, pitch, roll] => DVec4::from_array(wxyz(of_angles([yaw, pitch, roll]))),
        _ => return value.to_vec(),
    };
    if by_angles(track) {
        let near = angles_of(DQuat::from_xyzw(
            rotation.y, rotation.z, rotation.w, rotation.x,
        ));
        // As many turns as were there.
        let turned = |(new, old): (f64, &f64)| new + 360.0 * ((old - new) / 360.0).round();
        return near.into_iter().zip(old).map(turned).collect();
    }
    let there = DVec4::from_slice(old);
    let hermite = *track.interpolation() == Interpolation::Hermite;
    match rotation.try_normalize().filter(|_| hermite) {
        // The tangents are those of a curve of this length, on this side.
        Some(unit) => {
            let side = if unit.dot(there) < 0.0 { -1.0 } else { 1.0 };
            (side * there.length() * unit).to_array().to_vec()
        }
        None => rotation.to_array().to_vec(),
    }
}

/// Yaw, pitch and roll in degrees.
pub(super) fn angles_of(rotation: DQuat) -> [f64; 3] {
    let EulerAngles { yaw, pitch, roll } = EulerAngles::from_quaternion(rotation.normalize());
    [yaw, pitch, roll].map(f64::to_degrees)
}

fn of_angles(degrees: [f64; 3]) -> DQuat {
    let [yaw, pitch, roll] = degrees.map(f64::to_radians);
    EulerAngles { yaw, pitch, roll }.quaternion()
}

fn wxyz(q: DQuat) -> [f64; 4] {
    [q.w, q.x, q.y, q.z]
}

/// The part that sets a channel's numbers at rest.
fn at_rest(of: &Node, node: usize, channel: &Channel, value: &[f64]) -> Result<Part> {
    let mut rest = Rest::of(of);
    let values = &mut rest.values;
    match (channel, value, &of.kind) {
        (Channel::Rotation, &[yaw, pitch, roll], _) => {
            values.rotation = of_angles([yaw, pitch, roll]);
        }
        (Channel::Weights, weights, Kind::Object(_)) => {
            let weights = weights.to_vec();
            return Ok(Part::Weights { node, weights });
        }
        (Channel::Deformation { at, parameter }, numbers, Kind::Object(object)) => {
            let Some((mut deformation, bounds)) = object.deformations().get(*at).cloned() else {
                return Err(not_there(of, channel, value));
            };
            let here = deformation.channel_mut(parameter);
            let Some(here) = here.filter(|here| here.len() == numbers.len()) else {
                return Err(not_there(of, channel, value));
            };
            numbers
                .iter()
                .try_for_each(|&number| check_number(number))?;
            here.copy_from_slice(numbers);
            return Ok(Part::Deformation {
                node,
                at: *at,
                deformation,
                bounds,
            });
        }
        _ if channel.width(of).is_ok() && values.set(channel, value) => {}
        _ => return Err(not_there(of, channel, value)),
    }
    let rest = Box::new(rest);
    Ok(Part::Rest { node, rest })
}

/// Why a channel without a track cannot have a value.
fn not_there(of: &Node, channel: &Channel, value: &[f64]) -> vides_document::error::Error {
    match channel.width(of) {
        Err(error) => error.into(),
        Ok(_) if matches!(channel, Channel::Value { .. }) => Invalid::NoChannelOfNode {
            node: (&of.name).into(),
            channel: channel.into(),
        }
        .into(),
        Ok(wanted) => OutOfRange::KeyWidth {
            wanted,
            given: value.len(),
        }
        .into(),
    }
}

#[cfg(test)]
#[path = "values_tests.rs"]
mod tests;
