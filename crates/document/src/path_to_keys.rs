//! A node that follows a path comes to move by keys: one a frame, or few with tangents.

use glam::{DQuat, DVec3, DVec4};
use vides_engine::scene::{Channel, Extrapolation, FollowPath, Interpolation, Kind, Part, Track};
use vides_engine::tools::fit::Tolerance;

use super::edit::Edit;
use super::editing::Document;
use crate::error::{Refused, Result, TooMany, vec_with_room};
use vides_engine::limits::MAX_KEYS;
use vides_engine::math::orientation::quaternion_from_view;
use vides_engine::math::quaternion::{angle, continue_sign};
use vides_engine::path::Pose;

/// How near a zoom is kept, as a share of it.
const ZOOM: f64 = 1e-3;

/// What [`Document::path_to_few_keys`] makes.
#[derive(Debug)]
pub struct PathToKeys {
    /// What puts keys in place of the path, to be one step.
    pub edits: Vec<Edit>,
    /// Keys of position and rotation.
    pub keys: usize,
    /// The farthest that a whole frame is from where it was, in world units.
    pub off: f64,
    /// And by how many degrees it is turned.
    pub turned: f64,
}

/// What a path is at its frames.
struct Samples {
    start: f64,
    beyond: Extrapolation,
    count: usize,
    tracks: Vec<(Channel, Vec<f64>)>,
}

impl Samples {
    fn of(follow: &FollowPath, camera: bool) -> Result<Self> {
        let count = follow.count();
        if count > MAX_KEYS {
            return Err(TooMany::Keys.into());
        }
        let mut poses = vec_with_room(count)?;
        poses.resize(count, Pose::default());
        follow.sampler()?.sample_once(1, &mut poses)?;
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
        let mut tracks = vec_with_room(3)?;
        tracks.extend([(Channel::Position, places), (Channel::Rotation, turns)]);
        if camera {
            tracks.push((Channel::Zoom, zooms));
        }
        Ok(Self {
            start: follow.start_frame(),
            beyond: follow.extrapolation(),
            count,
            tracks,
        })
    }

    #[allow(clippy::cast_precision_loss)] // MAX_KEYS
    fn frame(&self, at: usize) -> f64 {
        self.start + at as f64
    }
}

impl Document {
    /// The edits that let a node move by keys in place of its path: one a frame, straight from one
    /// to the next. At whole frames it is where it was, to 1e-12.
    ///
    /// # Errors
    /// `ErrorKind::Argument` if it follows no path, `ErrorKind::Range` if there is no such node;
    /// `ErrorKind::Limit` for more keys than a track has.
    pub fn path_to_keys(&self, node: usize) -> Result<Vec<Edit>> {
        let samples = self.samples(node)?;
        let mut parts = vec_with_room(4)?;
        parts.push(Part::path(node, None)?);
        let (count, beyond) = (samples.count, samples.beyond);
        for (channel, values) in &samples.tracks {
            let mut frames = vec_with_room(count)?;
            frames.extend((0..count).map(|at| samples.frame(at)));
            let mut copy = vec_with_room(values.len())?;
            copy.extend_from_slice(values);
            let by = Interpolation::Linear;
            let track = Track::new(channel.clone(), by, frames, copy, Vec::new())?;
            let track = track.with_extrapolation(beyond, beyond)?;
            parts.push(Part::track(node, channel.clone(), Some(track))?);
        }
        Ok(edits(parts))
    }

    /// As [`Document::path_to_keys`] with as few keys, with tangents, as stay within a tolerance at
    /// whole frames; a zoom stays within a thousandth.
    ///
    /// # Errors
    /// As [`Document::path_to_keys`]; what is wrong with the tolerance.
    pub fn path_to_few_keys(&self, node: usize, tolerance: Tolerance) -> Result<PathToKeys> {
        tolerance.check()?;
        let samples = self.samples(node)?;
        let mut parts = vec_with_room(4)?;
        parts.push(Part::path(node, None)?);
        let (mut keys, mut off, mut turned) = (0, 0.0, 0.0);
        for (channel, values) in &samples.tracks {
            let curve = Curve {
                values,
                width: values.len() / samples.count,
                count: samples.count,
                channel,
            };
            let most = match channel {
                Channel::Position => tolerance.position,
                Channel::Rotation => tolerance.angle,
                _ => ZOOM,
            };
            let (chosen, missed) = curve.keys(most)?;
            match channel {
                Channel::Position => off = missed,
                Channel::Rotation => turned = missed,
                _ => {}
            }
            if *channel != Channel::Zoom {
                keys += chosen.len();
            }
            let track = curve.track(&chosen, &samples)?;
            parts.push(Part::track(node, channel.clone(), Some(track))?);
        }
        Ok(PathToKeys {
            edits: edits(parts),
            keys,
            off,
            turned,
        })
    }

    fn samples(&self, node: usize) -> Result<Samples> {
        if self.edited_scene().is_none() && node != 0 {
            return Err(Refused::NoScene.into());
        }
        let scene = self.scene()?;
        let of = scene.node(node)?;
        let none = || Refused::NoPathOf((&of.name).into());
        let camera = matches!(of.kind, Kind::Camera(_));
        Samples::of(of.path().ok_or_else(none)?, camera)
    }
}

fn edits(parts: Vec<Part>) -> Vec<Edit> {
    let edits = parts.into_iter().map(|part| Edit::Part(Box::new(part)));
    edits.collect()
}

/// Numbers at whole frames, through some of which a curve is laid.
struct Curve<'a> {
    values: &'a [f64],
    width: usize,
    count: usize,
    channel: &'a Channel,
}

impl Curve<'_> {
    fn at(&self, frame: usize) -> &[f64] {
        &self.values[self.width * frame..][..self.width]
    }

    /// The slope at a frame from its neighbours, per frame.
    #[allow(clippy::cast_precision_loss)]
    fn slope(&self, frame: usize, of: usize) -> f64 {
        let (before, after) = (frame.saturating_sub(1), (frame + 1).min(self.count - 1));
        (self.at(after)[of] - self.at(before)[of]) / (after - before).max(1) as f64
    }

    /// How far the curve between two keys is from a frame in between: a distance, degrees, a share.
    #[allow(clippy::cast_precision_loss)]
    fn missed(&self, from: usize, to: usize, frame: usize) -> f64 {
        let step = (to - from) as f64;
        let u = (frame - from) as f64 / step;
        let mut made = [0.0; 4];
        for (of, made) in made.iter_mut().enumerate().take(self.width) {
            let (a, b) = (self.at(from)[of], self.at(to)[of]);
            let [r, s] = [from, to].map(|key| step * self.slope(key, of));
            let rise = b - a;
            *made = a + u * (r + u * (3.0 * rise - 2.0 * r - s + u * (r + s - 2.0 * rise)));
        }
        let there = self.at(frame);
        match *self.channel {
            Channel::Position => DVec3::from_slice(&made).distance(DVec3::from_slice(there)),
            Channel::Rotation => {
                let turn =
                    |q: &[f64]| DQuat::from_vec4(DVec4::new(q[1], q[2], q[3], q[0])).normalize();
                let (a, b) = (turn(there), turn(&made));
                2.0 * angle(a, continue_sign(a, b).0).to_degrees()
            }
            _ => (made[0] - there[0]).abs() / there[0].abs().max(1.0),
        }
    }

    /// The frames of as few keys as stay within this, and how far they miss at most: a section that
    /// misses too far is parted where it does so most.
    fn keys(&self, most: f64) -> Result<(Vec<usize>, f64)> {
        let last = self.count - 1;
        let mut keys = vec_with_room(self.count)?;
        keys.push(0);
        let mut open = vec_with_room(self.count)?;
        if last > 0 {
            open.push(last);
        }
        let (mut from, mut off) = (0, 0.0_f64);
        while let Some(&to) = open.last() {
            let (mut worst, mut where_) = (0.0, from);
            for frame in from + 1..to {
                let missed = self.missed(from, to, frame);
                // What is no number is too far, too.
                if !(missed <= worst) {
                    (worst, where_) = (missed, frame);
                }
            }
            if worst <= most {
                off = off.max(worst);
                keys.push(to);
                from = to;
                open.pop();
            } else {
                open.push(where_);
            }
        }
        Ok((keys, off))
    }

    fn track(&self, keys: &[usize], samples: &Samples) -> Result<Track> {
        let count = keys.len();
        let mut frames = vec_with_room(count)?;
        let mut values = vec_with_room(self.width * count)?;
        let mut shape = vec_with_room(2 * self.width * count)?;
        for &key in keys {
            frames.push(samples.frame(key));
            values.extend_from_slice(self.at(key));
            for _ in 0..2 {
                shape.extend((0..self.width).map(|of| self.slope(key, of)));
            }
        }
        let by = Interpolation::Hermite;
        let track = Track::new(self.channel.clone(), by, frames, values, shape)?;
        Ok(track.with_extrapolation(samples.beyond, samples.beyond)?)
    }
}
