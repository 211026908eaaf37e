//! Motion that is written: tracks of the format's own interpolations as their keys, everything
//! else as a key a frame.

use glam::{DQuat, DVec3};
use serde_json::{Value, json};
use vides_document::error::{TooMany, vec_with_room};
use vides_engine::scene::{Extrapolation, Interpolation, Track};

use super::binary::{Binary, Use};
use super::compact;
use crate::convention::{self, Continued};
use crate::error::{Error, Result};
use crate::flight::Flight;

/// Beyond this number of frames neighbouring times are equal in 32 bits.
const MAX_KEYS: usize = 1 << 23;

/// How far the square of the length of a key of a rotation may be from 1.
const UNIT: f64 = 1e-6;

/// An animation that is written.
#[derive(Default)]
pub(super) struct Animation {
    samplers: Vec<Value>,
    channels: Vec<Value>,
    /// The accessor of the times of all frames.
    times: Option<usize>,
    /// Whether the extension for pointers is needed.
    pub(super) points: bool,
}

/// The ways between keys.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Way {
    Step,
    Linear,
    Cubic,
}

impl Way {
    const fn name(self) -> &'static str {
        match self {
            Self::Step => "STEP",
            Self::Linear => "LINEAR",
            Self::Cubic => "CUBICSPLINE",
        }
    }

    const fn of(interpolation: &Interpolation) -> Option<Self> {
        match interpolation {
            Interpolation::Step => Some(Self::Step),
            Interpolation::Linear => Some(Self::Linear),
            Interpolation::Hermite => Some(Self::Cubic),
            _ => None,
        }
    }
}

/// What of the file is moved.
pub(super) enum Target {
    /// A node's `translation`, `rotation`, `scale` or `weights`.
    Node(usize, &'static str),
    /// Anything else, by a JSON pointer.
    Pointer(String),
}

/// Keys of a track: times in seconds, values with tangents where the way has some.
pub(super) struct Keys {
    pub(super) times: Vec<f32>,
    pub(super) values: Vec<f32>,
    pub(super) way: Way,
}

/// How a node's place goes into the file.
#[derive(Clone, Copy)]
pub(super) struct Place {
    /// Rotates a root to the up axis.
    pub(super) turn: DQuat,
    pub(super) from: vides_engine::path::Up,
    pub(super) to: vides_engine::path::Up,
    pub(super) scale: f64,
    pub(super) pivot: DVec3,
    /// What its positions count from, in the file's coordinates.
    pub(super) origin: DVec3,
    /// What turns the node's own axes into the file's.
    pub(super) look: DQuat,
}

impl Place {
    pub(super) fn direction(&self, v: DVec3) -> DVec3 {
        convention::turned(v, self.from, self.to) * self.scale
    }

    pub(super) fn position(&self, position: DVec3) -> DVec3 {
        self.direction(position + self.pivot) - self.origin
    }

    pub(super) fn rotation(&self, rotation: DQuat) -> DQuat {
        self.turn * rotation * self.look
    }
}

/// As it is stored in keys: 32 bits, x y z w.
fn stored(rotation: DQuat) -> [f32; 4] {
    rotation.normalize().to_array().map(|number| number as f32)
}

/// The times of a track's keys if the format plays it as we do within the frames written.
fn key_times(flight: &Flight<'_>, track: &Track) -> Option<(Way, Vec<f32>)> {
    let mut way = Way::of(track.interpolation())?;
    let (first, step) = flight.first_and_step();
    let (from, to) = track.ends();
    let last = flight.frame(flight.count() - 1);
    let (before, after) = track.extrapolation();
    let held = (before == Extrapolation::Hold || from <= first)
        && (after == Extrapolation::Hold || to >= last);
    if from < first || to >= last + step || !held {
        return None;
    }
    let seconds = |frame: f64| ((frame - first) / (step * flight.fps())) as f32;
    let times: Vec<f32> = track.frames().iter().map(|&frame| seconds(frame)).collect();
    if times.len() == 1 {
        way = Way::Step;
    }
    times.is_sorted_by(|a, b| a < b).then_some((way, times))
}

/// The keys of a track of vectors; `value` and `tangent` append one each.
pub(super) fn keys(
    flight: &Flight<'_>,
    track: &Track,
    mut value: impl FnMut(&[f64], &mut Vec<f32>),
    mut tangent: impl FnMut(&[f64], &mut Vec<f32>),
) -> Option<Keys> {
    let (way, times) = key_times(flight, track)?;
    let width = track.width();
    let (_, step) = flight.first_and_step();
    let rate = step * flight.fps();
    let mut values = Vec::new();
    let mut per_second = vec![0.0; width];
    let mut slope = |at: usize, values: &mut Vec<f32>| {
        let slopes = &track.shape()[at * width..][..width];
        for (per_second, slope) in per_second.iter_mut().zip(slopes) {
            *per_second = slope * rate;
        }
        tangent(&per_second, values);
    };
    for (at, key) in track.values().chunks_exact(width).enumerate() {
        if way == Way::Cubic {
            slope(2 * at, &mut values);
        }
        value(key, &mut values);
        if way == Way::Cubic {
            slope(2 * at + 1, &mut values);
        }
    }
    Some(Keys { times, values, way })
}

/// The keys of a track of positions.
pub(super) fn positions(flight: &Flight<'_>, track: &Track, place: Place) -> Option<Keys> {
    let push = |v: DVec3, values: &mut Vec<f32>| values.extend(v.as_vec3().to_array());
    keys(
        flight,
        track,
        |key, values| push(place.position(DVec3::from_slice(key)), values),
        |slope, values| push(place.direction(DVec3::from_slice(slope)), values),
    )
}

/// The keys of a track of rotations.
pub(super) fn rotations(flight: &Flight<'_>, track: &Track, place: Place) -> Option<Keys> {
    let quaternion = |key: &[f64]| DQuat::from_xyzw(key[1], key[2], key[3], key[0]);
    // Between keys of other lengths the curve would be another when they are made units.
    let hermite = *track.interpolation() == Interpolation::Hermite;
    let unit = |key: &[f64]| (quaternion(key).length_squared() - 1.0).abs() < UNIT;
    if hermite && !track.values().chunks_exact(track.width()).all(unit) {
        return None;
    }
    let mut continued = Continued::default();
    keys(
        flight,
        track,
        |key, values| {
            let rotation = place.rotation(quaternion(key));
            let rotation = if hermite {
                rotation
            } else {
                continued.next(rotation.normalize())
            };
            values.extend(stored(rotation));
        },
        |slope, values| {
            let slope = place.rotation(quaternion(slope));
            values.extend(slope.to_array().map(|number| number as f32));
        },
    )
}

/// The keys of a track whose numbers are stored as they are.
pub(super) fn numbers(flight: &Flight<'_>, track: &Track) -> Option<Keys> {
    let push = |key: &[f64], values: &mut Vec<f32>| {
        values.extend(key.iter().map(|&number| number as f32));
    };
    keys(flight, track, push, push)
}

impl Animation {
    /// The accessor of the times of all frames.
    fn frames(&mut self, flight: &Flight<'_>, binary: &mut Binary) -> Result<usize> {
        if let Some(times) = self.times {
            return Ok(times);
        }
        let mut seconds: Vec<f32> = vec_with_room(flight.count())?;
        seconds.extend((0..flight.count()).map(|at| flight.seconds(at) as f32));
        let times = binary.floats(&seconds, 1, Use::Times)?;
        self.times = Some(times);
        Ok(times)
    }

    /// A key a frame, `width` numbers each.
    pub(super) fn a_key_a_frame(
        &mut self,
        flight: &Flight<'_>,
        binary: &mut Binary,
        target: Target,
        values: &[f32],
        width: usize,
    ) -> Result<()> {
        let times = self.frames(flight, binary)?;
        let values = binary.floats(values, accessor_width(&target, width), Use::Keys)?;
        self.channel(target, times, values, Way::Linear)
    }

    /// A switch a frame.
    pub(super) fn a_switch_a_frame(
        &mut self,
        flight: &Flight<'_>,
        binary: &mut Binary,
        target: Target,
        switches: &[u8],
    ) -> Result<()> {
        let times = self.frames(flight, binary)?;
        let values = binary.switches(switches)?;
        self.channel(target, times, values, Way::Step)
    }

    /// Keys of a track of `width` numbers.
    pub(super) fn keys(
        &mut self,
        binary: &mut Binary,
        target: Target,
        keys: &Keys,
        width: usize,
    ) -> Result<()> {
        let times = binary.floats(&keys.times, 1, Use::Times)?;
        let values = match target {
            Target::Pointer(_) if keys.way == Way::Step && width == 1 => {
                let switches: Vec<u8> = keys.values.iter().map(|v| u8::from(*v != 0.0)).collect();
                binary.switches(&switches)?
            }
            _ => binary.floats(&keys.values, accessor_width(&target, width), Use::Keys)?,
        };
        self.channel(target, times, values, keys.way)
    }

    /// A key a frame of a place or rotation, or fewer within what the options allow.
    pub(super) fn sampled<const N: usize>(
        &mut self,
        flight: &Flight<'_>,
        binary: &mut Binary,
        node: usize,
        values: &[[f64; N]],
    ) -> Result<()> {
        let target = Target::Node(node, if N == 3 { "translation" } else { "rotation" });
        if let Some(most) = flight.options().compact {
            let keys = compact::keys(values, most, flight.options().angle, flight)?;
            if let Some(keys) = keys {
                return self.keys(binary, target, &keys, N);
            }
        }
        let mut stored: Vec<f32> = vec_with_room(N * values.len())?;
        stored.extend(values.as_flattened().iter().map(|&number| number as f32));
        self.a_key_a_frame(flight, binary, target, &stored, N)
    }

    fn channel(&mut self, target: Target, input: usize, output: usize, way: Way) -> Result<()> {
        let sampler = self.samplers.len();
        self.samplers.try_reserve(1)?;
        self.samplers
            .push(json!({"input": input, "output": output, "interpolation": way.name()}));
        let target = match target {
            Target::Node(node, path) => json!({"node": node, "path": path}),
            Target::Pointer(pointer) => {
                self.points = true;
                json!({
                    "path": "pointer",
                    "extensions": {"KHR_animation_pointer": {"pointer": pointer}},
                })
            }
        };
        self.channels.try_reserve(1)?;
        self.channels
            .push(json!({"sampler": sampler, "target": target}));
        Ok(())
    }

    /// What the file holds of it; none if nothing moves.
    pub(super) fn into_json(self, name: &str) -> Option<Value> {
        if self.channels.is_empty() {
            return None;
        }
        let mut animation = json!({"samplers": self.samplers, "channels": self.channels});
        if !name.is_empty() {
            animation["name"] = name.into();
        }
        Some(animation)
    }
}

/// Weights lie one after the other.
fn accessor_width(target: &Target, width: usize) -> usize {
    match target {
        Target::Node(_, "weights") => 1,
        _ => width,
    }
}

/// Fails where neighbouring times would be the same.
pub(super) fn check_count(flight: &Flight<'_>) -> Result<()> {
    if flight.count() > MAX_KEYS {
        return Err(Error::Document(TooMany::SceneFrames(MAX_KEYS).into()));
    }
    Ok(())
}
