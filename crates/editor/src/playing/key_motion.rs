//! What becomes of keys of the scene: in time, and of their numbers. The whole motion is done from
//! the original keys each time.

use vides_document::error::Result;
use vides_document::{Document, Edit, EditedScene};
use vides_engine::scene::{Channel, Interpolation, KeyList};

use super::track_curve::Of;
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

/// Keys by their tracks, in rising order.
pub(super) fn by_track<'a>(edited: &'a EditedScene, keys: &[KeyAt]) -> Vec<(Of<'a>, Vec<usize>)> {
    let mut sorted: Vec<&KeyAt> = keys.iter().collect();
    sorted.sort_by(|a, b| {
        let (a, b) = ((a.node, &a.channel, a.key), (b.node, &b.channel, b.key));
        a.cmp(&b)
    });
    sorted.dedup();
    let tracks = sorted.chunk_by(|a, b| (a.node, &a.channel) == (b.node, &b.channel));
    let one = |keys: &[&KeyAt]| {
        let of = Of::new(edited, keys[0].node, &keys[0].channel)?;
        Some((of, keys.iter().map(|at| at.key).collect()))
    };
    tracks.filter_map(one).collect()
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

    /// Whether copies move.
    pub(super) fn copies(&self) -> bool {
        self.copies && !self.is_nothing()
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
    fn change_numbers(&self, of: &Of<'_>, put: &mut KeyList) {
        let (channel, width) = (of.track.channel(), of.track.width());
        match &self.numbers {
            Numbers::Stay => {}
            Numbers::By(by, parts) if !of.is_read_only() => {
                for (key, frame) in put.frames.iter().enumerate() {
                    for (.., part) in parts.range(of.part(*frame, 0)..of.part(*frame, width)) {
                        let number = &mut put.values[key * width + part];
                        *number = self.number(channel, *number + by);
                    }
                }
            }
            Numbers::By(..) => {}
            Numbers::Tangents(tangents) => put.shape.clone_from(tangents),
        }
    }

    /// The edits of a scene that is as it was when the motion began, and for each track the frames
    /// at which the keys lie then.
    fn edits(&self, edited: &EditedScene) -> Result<Vec<(Edit, Place)>> {
        let edit = |(of, which): (Of<'_>, Vec<usize>)| {
            let mut put = of.track.keys(&which)?;
            self.change_numbers(&of, &mut put);
            for frame in &mut put.frames {
                *frame = self.to.of(*frame);
            }
            if *of.track.interpolation() == Interpolation::Hermite {
                // They are by frame.
                let factor = self.to.factor();
                put.shape.iter_mut().for_each(|slope| *slope /= factor);
            }
            let place = (of.node, of.track.channel().clone(), put.frames.clone());
            let remove = if self.copies { Vec::new() } else { which };
            Ok((of.replaced(remove, put), place))
        };
        by_track(edited, &self.keys).into_iter().map(edit).collect()
    }
}

/// A node, a channel, and frames at which it has keys.
pub(super) type Place = (usize, Channel, Vec<f64>);

impl Editor {
    /// Moves or copies keys in place of what the open step has done.
    pub(crate) fn move_keys(&mut self, motion: &KeyMotion) {
        self.restart_step();
        self.select_keys(motion.keys.clone());
        if motion.is_nothing() {
            self.message = None;
            return;
        }
        let edits = self.document.edited_scene();
        let edits = edits.map_or(Ok(Vec::new()), |edited| motion.edits(edited));
        match edits {
            Ok(edits) => {
                let (edits, places): (Vec<_>, Vec<_>) = edits.into_iter().unzip();
                if self.edit_together(edits) {
                    self.select_keys(keys_at(&self.document, &places));
                }
            }
            Err(error) => self.complain_of(&error),
        }
    }
}

/// The keys at these places.
pub(super) fn keys_at(document: &Document, places: &[Place]) -> Vec<KeyAt> {
    let of = |(node, channel, frames): &'_ Place| {
        let of = Of::new(document.edited_scene()?, *node, channel)?;
        let keys = frames.iter().filter_map(|&frame| of.at_frame(frame));
        Some(keys.map(|key| of.key(key)).collect::<Vec<_>>())
    };
    places.iter().filter_map(of).flatten().collect()
}

/// The edits that remove keys.
pub(super) fn removed(document: &Document, keys: &[KeyAt]) -> Vec<Edit> {
    let edited = document.edited_scene();
    let tracks = edited.map_or(Vec::new(), |edited| by_track(edited, keys));
    let tracks = tracks.into_iter();
    tracks
        .map(|(of, which)| of.replaced(which, KeyList::default()))
        .collect()
}
