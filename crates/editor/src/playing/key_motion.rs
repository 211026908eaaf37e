//! What becomes of keys of the scene: in time, and of their numbers. The whole motion is done from
//! the original keys each time.

use vides_document::error::Result;
use vides_document::{Document, Edit};
use vides_engine::scene::{Channel, Interpolation, KeyList, Part, Track};

use super::track_curve::is_read_only;
use crate::state::Editor;
use crate::state::playing::tracks::{Change, KeyMotion, Numbers};
use crate::state::scene_view::KeyAt;

impl Change {
    pub(super) fn of(self, frame: f64) -> f64 {
        match self {
            Self::By(by) => frame + by,
            Self::Scale { from, to, .. } if frame == from => to,
            Self::Scale { about, .. } => about + (frame - about) * self.factor(),
        }
    }

    fn factor(self) -> f64 {
        match self {
            Self::By(_) => 1.0,
            Self::Scale { about, from, to } => (to - about) / (from - about),
        }
    }

    pub(super) fn is_nothing(self) -> bool {
        match self {
            Self::By(by) => by == 0.0,
            Self::Scale { from, to, .. } => from == to,
        }
    }
}

/// Keys of one track, in rising order.
type OfTrack = (usize, Channel, Vec<usize>);

/// Keys by their tracks.
pub(super) fn by_track(keys: &[KeyAt]) -> Vec<OfTrack> {
    let mut sorted: Vec<&KeyAt> = keys.iter().collect();
    sorted.sort_by(|a, b| {
        let (a, b) = ((a.node, &a.channel, a.key), (b.node, &b.channel, b.key));
        a.cmp(&b)
    });
    sorted.dedup();
    let tracks = sorted.chunk_by(|a, b| (a.node, &a.channel) == (b.node, &b.channel));
    let one = |keys: &[&KeyAt]| {
        let which = keys.iter().map(|at| at.key).collect();
        (keys[0].node, keys[0].channel.clone(), which)
    };
    tracks.map(one).collect()
}

impl KeyMotion {
    pub(super) const fn new(keys: Vec<KeyAt>, to: Change, copies: bool, numbers: Numbers) -> Self {
        Self {
            keys,
            to,
            copies,
            numbers,
        }
    }

    pub(super) const fn copies(&self) -> bool {
        self.copies
    }

    pub(super) fn is_nothing(&self) -> bool {
        self.to.is_nothing() && self.numbers == Numbers::Stay
    }

    /// The frame of what stood at this one.
    pub(super) fn frame_of(&self, frame: f64) -> f64 {
        self.to.of(frame)
    }

    /// By how much numbers are greater.
    pub(super) const fn lift(&self) -> f64 {
        match self.numbers {
            Numbers::By(by, _) => by,
            _ => 0.0,
        }
    }

    /// A number that a channel can have, as near to this one as can be.
    pub(super) fn number(&self, channel: &Channel, number: f64) -> f64 {
        let (low, high) = channel.range();
        match channel {
            Channel::Visible => number.round().clamp(low, high),
            _ => number.clamp(low, high),
        }
    }

    /// Changes the numbers of keys of a track that stand at their old frames.
    fn change_numbers(&self, (node, track): (usize, &Track), put: &mut KeyList) {
        let (channel, width) = (track.channel(), track.width());
        match &self.numbers {
            Numbers::Stay => {}
            Numbers::By(by, parts) if !is_read_only(track) => {
                for (key, frame) in put.frames.iter().enumerate() {
                    let of = |part| (node, channel.clone(), frame.to_bits(), part);
                    for (.., part) in parts.range(of(0)..of(width)) {
                        let number = &mut put.values[key * width + part];
                        *number = self.number(channel, *number + by);
                    }
                }
            }
            Numbers::By(..) => {}
            Numbers::Tangents(tangents) => put.shape.clone_from(tangents),
        }
    }

    /// The edits of a document that is as it was when the motion began, and the frames at which
    /// the keys lie then.
    fn edits(&self, document: &Document) -> Result<Vec<(Edit, Vec<f64>)>> {
        let mut edits = Vec::new();
        for (node, channel, which) in by_track(&self.keys) {
            let nodes = document.edited_scene().map(|edited| edited.scene().nodes());
            let of = nodes.and_then(|nodes| nodes.get(node));
            let Some(track) = of.and_then(|node| node.keys().track(&channel)) else {
                continue;
            };
            let mut put = track.keys(&which)?;
            self.change_numbers((node, track), &mut put);
            for frame in &mut put.frames {
                *frame = self.to.of(*frame);
            }
            if *track.interpolation() == Interpolation::Hermite {
                // They are by frame.
                let factor = self.to.factor();
                put.shape.iter_mut().for_each(|slope| *slope /= factor);
            }
            let frames = put.frames.clone();
            let remove = if self.copies { Vec::new() } else { which };
            let part = Part::Keys {
                node,
                channel,
                remove,
                put,
            };
            edits.push((Edit::Part(Box::new(part)), frames));
        }
        Ok(edits)
    }
}

impl Editor {
    /// Moves or copies keys in place of what the open step has done.
    pub(crate) fn move_keys(&mut self, motion: &KeyMotion) {
        self.restart_step();
        self.select_keys(motion.keys.clone());
        if motion.is_nothing() {
            self.message = None;
            return;
        }
        let (edits, frames): (Vec<_>, Vec<_>) = match motion.edits(&self.document) {
            Ok(edits) => edits.into_iter().unzip(),
            Err(error) => return self.complain_of(&error),
        };
        if self.edit_together(edits) {
            let tracks = by_track(&motion.keys);
            let tracks = tracks.into_iter().map(|(node, channel, _)| (node, channel));
            self.select_keys(keys_at(&self.document, tracks.zip(frames)));
        }
    }
}

/// The keys of tracks at these frames.
pub(super) fn keys_at(
    document: &Document,
    tracks: impl Iterator<Item = ((usize, Channel), Vec<f64>)>,
) -> Vec<KeyAt> {
    let Some(edited) = document.edited_scene() else {
        return Vec::new();
    };
    let mut keys = Vec::new();
    for ((node, channel), frames) in tracks {
        let of = edited.scene().nodes().get(node);
        let Some(track) = of.and_then(|node| node.keys().track(&channel)) else {
            continue;
        };
        let all = track.frames();
        let there = |frame: f64| {
            let key = all.partition_point(|&key| key < frame);
            (all.get(key) == Some(&frame)).then_some(key)
        };
        keys.extend(frames.into_iter().filter_map(there).map(|key| KeyAt {
            node,
            channel: channel.clone(),
            key,
        }));
    }
    keys
}

/// The edits that remove keys.
pub(super) fn removed(keys: &[KeyAt]) -> Vec<Edit> {
    let of_track = |(node, channel, remove)| {
        let put = Default::default();
        Edit::Part(Box::new(Part::Keys {
            node,
            channel,
            remove,
            put,
        }))
    };
    by_track(keys).into_iter().map(of_track).collect()
}
