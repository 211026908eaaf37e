//! The numbers of a track over the frames that are seen, as fine as the screen shows them.
//!
//! Between two keys the curve is cut into thirds until it lies near its chords: a curve of the third
//! degree that crosses its chord at both thirds is that chord.

use glam::DQuat;
use vides_document::{Edit, EditedScene};
use vides_engine::math::euler::EulerAngles;
use vides_engine::scene::{Channel, Extrapolation, KeyList, Part, Scene, Track, Warnings};

use crate::state::playing::track_graph::PartOf;
use crate::state::scene_view::KeyAt;

/// More keys than this in sight: of each column those with the least and the greatest numbers.
const MOST_KEYS: usize = 4000;

/// Width of a piece that is not asked whether it is straight, in columns; how often one is cut.
const PIECE: f64 = 8.0;
const CUTS: u32 = 5;

/// A track of a node, whose numbers are asked for.
#[derive(Clone, Copy)]
pub(crate) struct Of<'a> {
    pub(super) scene: &'a Scene,
    pub(super) node: usize,
    pub(super) track: &'a Track,
}

impl<'a> Of<'a> {
    pub(super) fn new(edited: &'a EditedScene, node: usize, channel: &Channel) -> Option<Self> {
        let scene = edited.scene();
        let track = scene.nodes().get(node)?.keys().track(channel)?;
        Some(Self { scene, node, track })
    }

    pub(super) fn key(&self, key: usize) -> KeyAt {
        let (node, channel) = (self.node, self.track.channel().clone());
        KeyAt { node, channel, key }
    }

    pub(super) fn has(&self, at: &KeyAt) -> bool {
        self.is(at.node, &at.channel)
    }

    pub(super) fn is(&self, node: usize, channel: &Channel) -> bool {
        node == self.node && channel.same_as(self.track.channel())
    }

    /// The key at exactly this frame.
    pub(super) fn at_frame(&self, frame: f64) -> Option<usize> {
        let frames = self.track.frames();
        let key = frames.partition_point(|&key| key < frame);
        (frames.get(key) == Some(&frame)).then_some(key)
    }

    /// A number of the key at a frame.
    pub(super) fn part(&self, frame: f64, part: usize) -> PartOf {
        let channel = self.track.channel().clone();
        (self.node, channel, frame.to_bits(), part)
    }

    /// The edit that puts keys in the place of others.
    pub(super) fn replaced(&self, remove: Vec<usize>, put: KeyList) -> Edit {
        let (node, channel) = (self.node, self.track.channel().clone());
        Edit::Part(Box::new(Part::Keys {
            node,
            channel,
            remove,
            put,
        }))
    }

    /// Rotations by quaternions are shown as angles, which are not those of the keys.
    pub(super) fn is_read_only(&self) -> bool {
        is_read_only(self.track)
    }

    /// How many numbers are shown.
    pub(super) fn width(&self) -> usize {
        match self.is_read_only() {
            true => 3,
            false => self.track.width(),
        }
    }

    /// The numbers at a frame, behind those that `out` has: of rotations yaw, pitch, roll in degrees.
    fn put(&self, frame: f64, out: &mut Vec<f64>) {
        let (warnings, channel) = (&mut Warnings::default(), self.track.channel());
        let begin = out.len();
        if *channel == Channel::Rotation && !self.is_read_only() {
            out.resize(begin + 3, 0.0);
            self.track.numbers(frame, &mut out[begin..], warnings);
            return;
        }
        let numbers = self.scene.value(self.node, channel, frame, warnings);
        match (numbers.as_deref(), self.is_read_only()) {
            (Ok(&[w, x, y, z]), true) => out.extend(angles([w, x, y, z])),
            (Ok(numbers), false) => out.extend(numbers),
            _ => {}
        }
        out.resize(begin + self.width(), 0.0);
    }

    /// The numbers at a frame.
    pub(super) fn at(&self, frame: f64) -> Vec<f64> {
        let mut out = Vec::new();
        self.put(frame, &mut out);
        out
    }

    /// One number of a key as it is shown.
    pub(super) fn of_key(&self, key: usize, part: usize) -> f64 {
        let (frames, values) = (self.track.frames(), self.track.values());
        match self.is_read_only() {
            true => self.at(frames[key])[part],
            false => values[key * self.track.width() + part],
        }
    }
}

pub(super) fn is_read_only(track: &Track) -> bool {
    *track.channel() == Channel::Rotation && track.width() == 4
}

fn angles([w, x, y, z]: [f64; 4]) -> [f64; 3] {
    let angles = EulerAngles::from_quaternion(DQuat::from_xyzw(x, y, z, w));
    [angles.yaw, angles.pitch, angles.roll].map(f64::to_degrees)
}

/// A frame and the numbers there.
type Place = (f64, Vec<f64>);

/// Frames in rising order with their numbers.
#[derive(Debug, Default)]
pub(super) struct Curve {
    width: usize,
    frames: Vec<f64>,
    values: Vec<f64>,
}

impl Curve {
    /// What is seen from one frame to another, each column of `column` frames; nowhere is it
    /// farther from what is returned than `tolerance`, where that is finite.
    pub(super) fn new(of: &Of<'_>, ends: (f64, f64), column: f64, tolerance: f64) -> Self {
        let mut curve = Self {
            width: of.width(),
            ..Self::default()
        };
        let mut from = ends.0;
        let inner = breaks(of, ends, column);
        for to in inner.into_iter().chain([ends.1]) {
            curve.section(of, (from, to), column, tolerance);
            from = to;
        }
        curve.push(of, ends.1);
        curve
    }

    /// Its lines: one for each number, of frames and numbers.
    pub(super) fn line(&self, part: usize) -> impl Iterator<Item = (f64, f64)> + '_ {
        let values = self.values.iter().skip(part).step_by(self.width.max(1));
        self.frames.iter().copied().zip(values.copied())
    }

    /// The least and the greatest of all its numbers.
    pub(super) fn bounds(&self) -> Option<(f64, f64)> {
        let both = self.values.iter().map(|&value| (value, value));
        both.reduce(|a, b| (a.0.min(b.0), a.1.max(b.1)))
    }

    fn push(&mut self, of: &Of<'_>, frame: f64) {
        self.frames.push(frame);
        of.put(frame, &mut self.values);
    }

    /// From a key up to the next one, at which the curve may jump.
    fn section(&mut self, of: &Of<'_>, (from, to): (f64, f64), column: f64, tolerance: f64) {
        self.push(of, from);
        // Beside the keys by so much that no rounding takes it for one.
        let beside = (1e-3 * column).min(0.25 * (to - from));
        let (from, to) = (from + beside, to - beside);
        if !(from < to) {
            return;
        }
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
        let pieces = ((to - from) / (PIECE * column)).ceil().clamp(1.0, 4096.0) as u32;
        let frame = |at: u32| from + (to - from) * (f64::from(at) / f64::from(pieces));
        let mut begin = (from, of.at(from));
        for at in 1..=pieces {
            let end = if at == pieces { to } else { frame(at) };
            let end = (end, of.at(end));
            self.take(&begin);
            self.between(of, (&begin, &end), tolerance, CUTS);
            begin = end;
        }
        self.take(&begin);
    }

    fn take(&mut self, (frame, values): &Place) {
        self.frames.push(*frame);
        self.values.extend(values);
    }

    /// What is needed between two places.
    fn between(&mut self, of: &Of<'_>, (begin, end): (&Place, &Place), tolerance: f64, cuts: u32) {
        let third = |share: f64| {
            let frame = begin.0 + (end.0 - begin.0) * share;
            (frame, of.at(frame))
        };
        let inner = [third(1.0 / 3.0), third(2.0 / 3.0)];
        let straight = inner.iter().zip([1.0 / 3.0, 2.0 / 3.0]).all(|(at, share)| {
            let chord = begin.1.iter().zip(&end.1);
            let chord = chord.map(|(a, b)| a + (b - a) * share);
            let mut away = at.1.iter().zip(chord).map(|(value, on)| (value - on).abs());
            away.all(|away| away <= tolerance)
        });
        if straight && tolerance.is_finite() {
            return;
        }
        let [first, second] = &inner;
        for (from, to) in [(begin, first), (first, second), (second, end)] {
            if cuts > 0 && tolerance.is_finite() {
                self.between(of, (from, to), tolerance, cuts - 1);
            }
            if to.0 < end.0 {
                self.take(to);
            }
        }
    }
}

/// The frames between `ends` at which the curve may jump or bend, in rising order.
fn breaks(of: &Of<'_>, (low, high): (f64, f64), column: f64) -> Vec<f64> {
    let keys = of.track.frames();
    let ((first, last), (before, after)) = (of.track.ends(), of.track.extrapolation());
    let period = last - first;
    let inside = |frame: f64| low < frame && frame < high;
    let (from, to) = (
        keys.partition_point(|&key| key <= low),
        keys.partition_point(|&key| key < high),
    );
    let mut all: Vec<f64> = match to - from > MOST_KEYS {
        true => extremes(of, from..to, column),
        false => keys[from..to].to_vec(),
    };
    // The rounds that are seen, counted from that of the keys.
    let round = |frame: f64| ((frame - first) / period).floor();
    for (beyond, begin, end) in [(before, low, high.min(first)), (after, low.max(last), high)] {
        if beyond == Extrapolation::Hold || !(begin < end) || !(period > 0.0) {
            continue;
        }
        let rounds = (round(begin), round(end));
        let count = rounds.1 - rounds.0 + 1.0;
        // As many as can be told apart.
        if !(count * column <= 2.0 * (high - low)) || count > 10_000.0 {
            continue;
        }
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
        let (count, most) = (count as usize, MOST_KEYS / keys.len().max(1));
        let mut number = rounds.0;
        for _ in 0..count {
            let back = beyond == Extrapolation::PingPong && number.rem_euclid(2.0) == 1.0;
            let start = first + number * period;
            let place = |key: &f64| match back {
                true => start + (last - key),
                false => start + (key - first),
            };
            let within = |frame: &f64| inside(*frame) && begin <= *frame && *frame <= end;
            match count > most {
                true => all.extend([start, start + period].into_iter().filter(within)),
                false => all.extend(keys.iter().map(place).filter(within)),
            }
            number += 1.0;
        }
    }
    all.sort_by(f64::total_cmp);
    all.dedup();
    all
}

/// Of each column the keys whose numbers are the least and the greatest.
fn extremes(of: &Of<'_>, keys: std::ops::Range<usize>, column: f64) -> Vec<f64> {
    let (frames, mut all) = (of.track.frames(), Vec::new());
    let mut begin = keys.start;
    while begin < keys.end {
        let until = frames[begin] + column;
        let rest = &frames[begin..keys.end];
        let end = begin + rest.partition_point(|&key| key < until).max(1);
        for part in 0..of.width() {
            let value = |key: &usize| of.of_key(*key, part);
            let of_both = |a: &usize, b: &usize| value(a).total_cmp(&value(b));
            let both = [(begin..end).min_by(of_both), (begin..end).max_by(of_both)];
            all.extend(both.into_iter().flatten().map(|key| frames[key]));
        }
        begin = end;
    }
    all
}
