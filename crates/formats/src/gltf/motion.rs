//! An animation as tracks: the keys of the file, their times in frames, in the same interpolation.
//!
//! A field of view that changes straight is no zoom that does: between keys that are farther apart
//! than a frame there is a key a frame.

use std::collections::{HashMap, HashSet};

use glam::DQuat;
use vides_document::error::{TooMany, vec_with_room};
use vides_document::mesh::gltf::{Accessor, Container};
use vides_engine::limits::{MAX_COORDINATE, MAX_KEYS, MAX_SCENE_NUMBERS};
use vides_engine::scene::{Channel, Interpolation, Node, Track, Warnings};

use super::became::Became;
use super::wrong::wrong_at;
use super::{extensions, looks};
use crate::convention;
use crate::convention::HALF_TURN;
use crate::error::{Cause, Error, Result, Wanted};
use crate::tree::At;

/// Keys that may be put between those of a file, whatever their number.
const MOST_BETWEEN: usize = 500_000;

/// Our nodes by what of the file they have.
#[derive(Default)]
pub(super) struct Users {
    cameras: HashMap<usize, Vec<usize>>,
    lights: HashMap<usize, Vec<usize>>,
    materials: HashMap<usize, Vec<usize>>,
}

fn add(map: &mut HashMap<usize, Vec<usize>>, index: usize, node: usize) -> Result<()> {
    map.try_reserve(1)?;
    let nodes = map.entry(index).or_default();
    nodes.try_reserve(1)?;
    nodes.push(node);
    Ok(())
}

impl Users {
    pub(super) fn camera(&mut self, index: usize, node: usize) -> Result<()> {
        add(&mut self.cameras, index, node)
    }

    pub(super) fn light(&mut self, index: usize, node: usize) -> Result<()> {
        add(&mut self.lights, index, node)
    }

    pub(super) fn material(&mut self, index: usize, node: usize) -> Result<()> {
        add(&mut self.materials, index, node)
    }
}

/// How many numbers of keys, and of keys between them, may be taken yet.
pub(super) struct Room {
    numbers: usize,
    between: usize,
}

pub(super) const fn room() -> Room {
    Room {
        numbers: MAX_SCENE_NUMBERS,
        between: MOST_BETWEEN,
    }
}

/// The nodes of the file whose place animations move.
pub(super) fn moved(clips: &[At<'_>]) -> Result<HashSet<usize>> {
    let mut moved = HashSet::new();
    for clip in clips {
        for channel in clip.need("channels")?.list()? {
            if let Some((node, path)) = target_of(channel)
                && path != "weights"
            {
                moved.try_reserve(1)?;
                moved.insert(node);
            }
        }
    }
    Ok(moved)
}

/// The node and the property of a channel, by its target or by a pointer; none for other pointers.
pub(super) fn target_of(channel: At<'_>) -> Option<(usize, &str)> {
    let target = channel.get("target")?;
    if let Some(pointer) = pointer_of(target) {
        let mut steps = pointer.strip_prefix("/nodes/")?.split('/');
        let (node, path) = (steps.next()?.parse().ok()?, steps.next()?);
        return steps.next().is_none().then_some((node, path));
    }
    let node = usize::try_from(target.get("node")?.value.as_u64()?).ok()?;
    Some((node, target.get("path")?.value.as_str()?))
}

pub(super) fn pointer_of(target: At<'_>) -> Option<&str> {
    target
        .get("extensions")?
        .get(extensions::POINTER)?
        .get("pointer")?
        .value
        .as_str()
}

/// Which cone angle of a light is meant.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
enum Cone {
    Inner,
    Outer,
}

/// What a channel moves beside nodes.
enum Pointed {
    Visible(usize),
    Zoom(usize),
    Colour(usize),
    Intensity(usize),
    Cone(usize, Cone),
    Material(usize),
}

fn pointed(pointer: &str) -> Option<Pointed> {
    let steps: Vec<&str> = pointer.split('/').skip(1).take(7).collect();
    let number = |text: &str| text.parse::<usize>().ok();
    Some(match *steps {
        ["nodes", at, "extensions", name, "visible"] if name == extensions::VISIBILITY => {
            Pointed::Visible(number(at)?)
        }
        ["cameras", at, "perspective", "yfov"] => Pointed::Zoom(number(at)?),
        ["materials", at, "pbrMetallicRoughness", "baseColorFactor"] => {
            Pointed::Material(number(at)?)
        }
        ["extensions", name, "lights", at, ref what @ ..] if name == extensions::LIGHTS => {
            let at = number(at)?;
            match *what {
                ["color"] => Pointed::Colour(at),
                ["intensity"] => Pointed::Intensity(at),
                ["spot", "innerConeAngle"] => Pointed::Cone(at, Cone::Inner),
                ["spot", "outerConeAngle"] => Pointed::Cone(at, Cone::Outer),
                _ => return None,
            }
        }
        _ => return None,
    })
}

/// The keys of a sampler, `width` numbers each, tangents per frame.
#[derive(Clone)]
struct Keys {
    frames: Vec<f64>,
    values: Vec<f64>,
    shape: Vec<f64>,
    by: Interpolation,
}

impl Keys {
    /// The same with each key and each tangent changed.
    fn map<const N: usize, const M: usize>(
        self,
        value: impl Fn([f64; N]) -> [f64; M],
        tangent: impl Fn([f64; N]) -> [f64; M],
    ) -> Result<Self> {
        let each = |numbers: &[f64], change: &dyn Fn([f64; N]) -> [f64; M]| {
            let mut all = vec_with_room(numbers.len() / N * M)?;
            let (keys, _) = numbers.as_chunks::<N>();
            all.extend(keys.iter().flat_map(|key| change(*key)));
            Ok::<_, Error>(all)
        };
        Ok(Self {
            values: each(&self.values, &value)?,
            shape: each(&self.shape, &tangent)?,
            ..self
        })
    }

    /// A key that is no rotation has this many numbers.
    fn width(&self) -> usize {
        self.values.len() / self.frames.len().max(1)
    }

    /// The numbers at any frame, as a track gives them.
    fn as_track(&self) -> Result<Track> {
        let channel = Channel::Value {
            name: "keys".to_owned(),
            width: self.width(),
        };
        let (frames, values) = (self.frames.clone(), self.values.clone());
        Ok(Track::new(
            channel,
            self.by.clone(),
            frames,
            values,
            self.shape.clone(),
        )?)
    }
}

pub(super) struct Reader<'a> {
    pub(super) container: &'a Container<'a>,
    pub(super) fps: f64,
    pub(super) nodes: &'a mut [Node],
    /// What the nodes of the file have become, where they are in the scene.
    pub(super) became: &'a [Option<Became>],
    pub(super) users: &'a Users,
    pub(super) clamped: usize,
    pub(super) left_out: usize,
    pub(super) room: Room,
}

/// A frame of 32-bit seconds: the whole one if 32 bits mean it.
fn frame(seconds: f64, fps: f64) -> f64 {
    let frames = seconds * fps;
    let whole = frames.round();
    if (whole / fps) as f32 == seconds as f32 {
        1.0 + whole
    } else {
        1.0 + frames
    }
}

impl Reader<'_> {
    /// All channels of an animation.
    pub(super) fn animation(&mut self, at: At<'_>) -> Result<()> {
        let samplers = at.need("samplers")?;
        let mut cones: HashMap<usize, [Option<Keys>; 2]> = HashMap::new();
        for channel in at.need("channels")?.list()? {
            let sampler = samplers.element(channel.need("sampler")?.index()?)?;
            if let Some((node, path)) = target_of(channel) {
                // Else a node that is in no scene.
                match self.became.get(node).copied().flatten() {
                    Some(became) => self.node(sampler, became, path)?,
                    None => self.left_out += 1,
                }
                continue;
            }
            let pointer = channel.get("target").and_then(pointer_of);
            match pointer.and_then(pointed) {
                Some(Pointed::Cone(light, which)) => {
                    let keys = self.keys(sampler, 1)?;
                    cones.try_reserve(1)?;
                    cones.entry(light).or_default()[which as usize] = Some(keys);
                }
                Some(other) => self.pointer(sampler, &other)?,
                None => self.left_out += 1,
            }
        }
        for (light, [inner, outer]) in cones {
            self.cone(light, inner, outer)?;
        }
        Ok(())
    }

    /// The keys of a sampler, `width` numbers each.
    fn keys(&mut self, sampler: At<'_>, width: usize) -> Result<Keys> {
        let accessor = |name| -> Result<(At<'_>, Accessor<'_>)> {
            let at = sampler.need(name)?;
            // Without a buffer all its numbers are 0.
            let accessor = self.container.accessor(at.value, MAX_SCENE_NUMBERS);
            Ok((at, accessor.map_err(|error| wrong_at(at, error))?))
        };
        let (times_at, times) = accessor("input")?;
        let (values_at, values) = accessor("output")?;
        let by = sampler.get("interpolation");
        let mut way = match by.map(At::text).transpose()? {
            None | Some("LINEAR") => Interpolation::Linear,
            Some("STEP") => Interpolation::Step,
            Some("CUBICSPLINE") => Interpolation::Hermite,
            Some(other) => {
                return Err(by.unwrap_or(sampler).wrong(Cause::Unsupported {
                    name: other.chars().take(64).collect::<String>().as_str().into(),
                    help: "",
                }));
            }
        };
        let (count, parts) = (
            times.count(),
            if way == Interpolation::Hermite { 3 } else { 1 },
        );
        let wanted = count.checked_mul(parts * width);
        let found = values.count().checked_mul(values.width());
        if times.width() != 1 || count == 0 || count > MAX_KEYS {
            return Err(times_at.expected(Wanted::List));
        }
        if wanted.is_none() || wanted != found {
            return Err(values_at.wrong(Cause::NumberCount {
                wanted: wanted.unwrap_or(usize::MAX),
                found: found.unwrap_or(usize::MAX),
            }));
        }
        self.take(count * (1 + parts * width))?;
        let mut frames: Vec<f64> = vec_with_room(count)?;
        frames.extend((0..count).map(|key| frame(times.number(key, 0), self.fps)));
        if !frames.is_sorted_by(|a, b| a < b) {
            return Err(times_at.wrong(Cause::Order));
        }
        let number = |at: usize| values.number(at / values.width(), at % values.width());
        let row = |part: usize, key: usize| {
            let start = (key * parts + part) * width;
            (start..start + width).map(number)
        };
        let (mut kept, mut shape) = (vec_with_room(count * width)?, Vec::new());
        for key in 0..count {
            if parts == 1 {
                kept.extend(row(0, key));
                continue;
            }
            kept.extend(row(1, key));
            shape.try_reserve(2 * width)?;
            for part in [0, 2] {
                shape.extend(row(part, key).map(|per_second| per_second / self.fps));
            }
        }
        if count == 1 {
            (way, shape) = (Interpolation::Step, Vec::new());
        }
        Ok(Keys {
            frames,
            values: kept,
            shape,
            by: way,
        })
    }

    fn take(&mut self, numbers: usize) -> Result<()> {
        let left = self.room.numbers.checked_sub(numbers);
        self.room.numbers = left.ok_or_else(|| Error::Document(TooMany::SceneNumbers.into()))?;
        Ok(())
    }

    fn set(&mut self, node: usize, channel: Channel, keys: Keys) -> Result<()> {
        let track = Track::new(channel, keys.by, keys.frames, keys.values, keys.shape);
        let place = || vides_engine::error::Place::Node(self.nodes[node].name.as_str().into());
        let track = track.map_err(|error| error.at(place()))?;
        self.nodes[node].set_track(track)?;
        Ok(())
    }

    /// A node's place, or its weights.
    fn node(&mut self, sampler: At<'_>, became: Became, path: &str) -> Result<()> {
        let Some(node) = became.node else {
            self.left_out += 1;
            return Ok(());
        };
        match path {
            // What is a part of the node above does not move: only its weights are that node's.
            "translation" | "rotation" | "scale" if became.absorbed => self.left_out += 1,
            "translation" => {
                let keys = self.keys(sampler, 3)?;
                let pivot = became.pivot.to_array();
                let from_pivot = |p: [f64; 3]| std::array::from_fn(|k| p[k] - pivot[k]);
                let keys = keys.map(from_pivot, |slope: [f64; 3]| slope)?;
                self.set(node, Channel::Position, keys)?;
            }
            "rotation" => {
                let keys = self.keys(sampler, 4)?;
                let ours = |q: [f64; 4]| {
                    let q = DQuat::from_array(q);
                    let q = if became.turned {
                        q * HALF_TURN.inverse()
                    } else {
                        q
                    };
                    [q.w, q.x, q.y, q.z]
                };
                self.set(node, Channel::Rotation, keys.map(ours, ours)?)?;
            }
            "scale" => {
                let keys = self.keys(sampler, 3)?;
                self.set(node, Channel::Scale, keys)?;
            }
            "weights" => match Channel::Weights.width(&self.nodes[node]) {
                Ok(width) => {
                    let keys = self.keys(sampler, width)?;
                    self.set(node, Channel::Weights, keys)?;
                }
                Err(_) => self.left_out += 1,
            },
            _ => self.left_out += 1,
        }
        Ok(())
    }

    fn pointer(&mut self, sampler: At<'_>, what: &Pointed) -> Result<()> {
        let bright = |colour: [f64; 3]| colour.map(|part| part.clamp(0.0, MAX_COORDINATE));
        match *what {
            Pointed::Visible(node) => {
                let became = self.became.get(node).copied().flatten();
                let Some(node) = became.and_then(|became| became.node) else {
                    self.left_out += 1;
                    return Ok(());
                };
                let keys = self.keys(sampler, 1)?;
                let switch = |[on]: [f64; 1]| [f64::from(u8::from(on != 0.0))];
                let mut keys = keys.map(switch, switch)?;
                (keys.by, keys.shape) = (Interpolation::Step, Vec::new());
                self.set(node, Channel::Visible, keys)
            }
            Pointed::Zoom(camera) => {
                let keys = self.keys(sampler, 1)?;
                let keys = self.zooms(keys)?;
                self.set_all(self.users.cameras.get(&camera), &Channel::Zoom, &keys)
            }
            Pointed::Colour(light) => {
                let keys = self
                    .keys(sampler, 3)?
                    .map(bright, |slope: [f64; 3]| slope)?;
                self.set_all(self.users.lights.get(&light), &Channel::Colour, &keys)
            }
            Pointed::Intensity(light) => {
                let keys = self.keys(sampler, 1)?;
                let keys = keys.map(
                    |[number]: [f64; 1]| [number.clamp(0.0, MAX_COORDINATE)],
                    |slope| slope,
                )?;
                self.set_all(self.users.lights.get(&light), &Channel::Intensity, &keys)
            }
            Pointed::Material(material) => {
                let keys = self.keys(sampler, 4)?;
                let keys = keys.map(
                    |[red, green, blue, _]: [f64; 4]| bright([red, green, blue]),
                    |[red, green, blue, _]| [red, green, blue],
                )?;
                self.set_all(self.users.materials.get(&material), &Channel::Colour, &keys)
            }
            Pointed::Cone(..) => Ok(()),
        }
    }

    /// The same keys for all nodes that have the camera, light or material.
    fn set_all(
        &mut self,
        nodes: Option<&Vec<usize>>,
        channel: &Channel,
        keys: &Keys,
    ) -> Result<()> {
        for &node in nodes.into_iter().flatten() {
            self.take(keys.frames.len() + keys.values.len() + keys.shape.len())?;
            self.set(node, channel.clone(), keys.clone())?;
        }
        Ok(())
    }

    /// Fields of view as zooms.
    fn zooms(&mut self, keys: Keys) -> Result<Keys> {
        let keys = match keys.by {
            Interpolation::Step => keys,
            _ => self.a_key_a_frame(keys)?,
        };
        let mut beyond = 0;
        let mut values = vec_with_room(keys.values.len())?;
        for field in &keys.values {
            let (zoom, inside) = convention::zoom_of_field(*field);
            beyond += usize::from(!inside);
            values.push(zoom);
        }
        self.clamped += beyond;
        Ok(Keys { values, ..keys })
    }

    /// A key a frame where keys are farther apart and differ; straight from one to the next.
    fn a_key_a_frame(&mut self, keys: Keys) -> Result<Keys> {
        let width = keys.width();
        let linear = keys.by == Interpolation::Linear;
        let mut frames: Vec<f64> = vec_with_room(keys.frames.len())?;
        for (at, pair) in keys.frames.windows(2).enumerate() {
            frames.push(pair[0]);
            let values = &keys.values[at * width..][..2 * width];
            if linear && values[..width] == values[width..] {
                continue;
            }
            let (mut next, end) = (pair[0].floor() + 1.0, pair[1]);
            let between = (end - next).max(0.0).ceil();
            if between > self.room.between as f64 {
                // Too far apart: straight.
                continue;
            }
            self.room.between -= between as usize;
            frames.try_reserve(between as usize + 2)?;
            while next < end {
                frames.push(next);
                next += 1.0;
            }
        }
        frames.try_reserve(1)?;
        frames.extend(keys.frames.last());
        let track = keys.as_track()?;
        let mut values = vec_with_room(width * frames.len())?;
        let mut numbers = vec![0.0; width];
        for frame in &frames {
            track.numbers(*frame, &mut numbers, &mut Warnings::default());
            values.extend_from_slice(&numbers);
        }
        Ok(Keys {
            frames,
            values,
            shape: Vec::new(),
            by: Interpolation::Linear,
        })
    }

    /// Both angles of a light's cone in one track: at the keys of either.
    fn cone(&mut self, light: usize, inner: Option<Keys>, outer: Option<Keys>) -> Result<()> {
        let steps = |keys: &Option<Keys>| {
            keys.as_ref()
                .is_none_or(|keys| keys.by == Interpolation::Step)
        };
        let by = match steps(&inner) && steps(&outer) {
            true => Interpolation::Step,
            false => Interpolation::Linear,
        };
        let mut both = [None, None];
        let mut frames: Vec<f64> = Vec::new();
        for (track, keys) in both.iter_mut().zip([inner, outer]) {
            let Some(keys) = keys else { continue };
            let keys = match keys.by {
                Interpolation::Hermite => self.a_key_a_frame(keys)?,
                _ => keys,
            };
            frames.try_reserve(keys.frames.len())?;
            frames.extend_from_slice(&keys.frames);
            *track = Some(keys.as_track()?);
        }
        frames.sort_by(f64::total_cmp);
        frames.dedup();
        let Some(nodes) = self.users.lights.get(&light) else {
            return Ok(());
        };
        for &node in nodes {
            let rest = self.nodes[node].rest.cone.map(f64::to_radians);
            let mut values = vec_with_room(2 * frames.len())?;
            for frame in &frames {
                let angle = |which: usize| {
                    let mut number = [rest[which]];
                    if let Some(track) = &both[which] {
                        track.numbers(*frame, &mut number, &mut Warnings::default());
                    }
                    number[0]
                };
                values.extend(looks::cone(angle(0), angle(1)));
            }
            self.take(3 * frames.len())?;
            let keys = Keys {
                frames: frames.clone(),
                values,
                shape: Vec::new(),
                by: by.clone(),
            };
            self.set(node, Channel::Cone, keys)?;
        }
        Ok(())
    }
}
