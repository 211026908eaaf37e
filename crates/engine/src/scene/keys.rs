//! A node that moves by keys: a track for each channel that changes.

use std::sync::Arc;

use super::channel::Channel;
use super::motion::Motion;
use super::state::Warnings;
use super::track::Track;
use super::values::Values;
use crate::error::{Result, TooMany};
use crate::limits::{MAX_TRACKS, MAX_ZOOM, MIN_ZOOM};
use crate::shared_list::SharedList;

/// The tracks of a node, in the order of their channels.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Keys {
    tracks: SharedList<Track>,
}

impl Keys {
    /// All tracks.
    #[must_use]
    pub const fn tracks(&self) -> &SharedList<Track> {
        &self.tracks
    }

    /// The track of a channel.
    #[must_use]
    pub fn track(&self, channel: &Channel) -> Option<&Track> {
        self.tracks
            .iter()
            .find(|track| track.channel().same_as(channel))
    }

    pub(super) fn set(&mut self, track: Arc<Track>) -> Result<()> {
        let channel = track.channel();
        let same = self
            .tracks
            .iter()
            .position(|t| t.channel().same_as(channel));
        if same.is_none() && self.tracks.len() >= MAX_TRACKS {
            return Err(TooMany::Tracks.into());
        }
        if let Some(same) = same {
            self.tracks.remove(same);
        }
        let before = |t: &&Track| t.channel() < track.channel();
        let at = self.tracks.iter().take_while(before).count();
        self.tracks.insert(at, track);
        Ok(())
    }

    pub(super) fn track_mut(&mut self, channel: &Channel) -> Option<&mut Track> {
        let mut tracks = self.tracks.iter();
        let at = tracks.position(|track| track.channel().same_as(channel))?;
        self.tracks.get_mut(at)
    }

    pub(super) fn remove(&mut self, channel: &Channel) -> bool {
        let before = self.tracks.len();
        self.tracks
            .retain(|track| !track.channel().same_as(channel));
        self.tracks.len() < before
    }

    /// Keeps the tracks for which `keep` is true.
    pub(super) fn retain(&mut self, keep: impl FnMut(&Track) -> bool) {
        self.tracks.retain(keep);
    }

    /// Gives deformations other numbers in the channels of their tracks.
    pub(super) fn renumber_deformations(&mut self, number: impl Fn(usize) -> usize) {
        for at in 0..self.tracks.len() {
            if let Channel::Deformation { at: old, .. } = self.tracks[at].channel()
                && number(*old) != *old
            {
                self.tracks[at].renumber_deformation(&number);
            }
        }
        self.tracks.sort_by(|a, b| a.channel().cmp(b.channel()));
    }

    pub(super) fn numbers(&self) -> usize {
        self.tracks.iter().map(Track::numbers_kept).sum()
    }
}

impl Track {
    /// Sets what it moves, if that is not the place of the node.
    pub(super) fn other(&self, frame: f64, values: &mut Values, warnings: &mut Warnings) {
        match self.channel() {
            Channel::Colour => {
                values.colour = self.value(frame, warnings).map(|v: f64| v.max(0.0));
            }
            Channel::Cone => {
                let [inner, outer] = self.value(frame, warnings);
                let outer = f64::clamp(outer, 0.0, 90.0);
                values.cone = [f64::clamp(inner, 0.0, outer), outer];
            }
            Channel::Visible => values.visible = self.value(frame, warnings) != [0.0],
            Channel::Zoom => {
                let [zoom] = self.value(frame, warnings);
                values.zoom = f64::clamp(zoom, MIN_ZOOM, MAX_ZOOM);
            }
            Channel::Roll => [values.roll] = self.value(frame, warnings),
            Channel::Intensity => {
                [values.intensity] = self.value(frame, warnings).map(|v: f64| v.max(0.0));
            }
            Channel::AimWeight => {
                let [weight] = self.value(frame, warnings);
                values.aim_weight = f64::clamp(weight, 0.0, 1.0);
            }
            Channel::Position | Channel::Rotation | Channel::Scale => {}
            // Not among the values: evaluated where they are asked for.
            Channel::Weights | Channel::Deformation { .. } | Channel::Value { .. } => {}
        }
    }
}

impl Motion for Keys {
    fn at(&self, frame: f64, values: &mut Values, warnings: &mut Warnings) -> Result<()> {
        for track in &self.tracks {
            match track.channel() {
                Channel::Position => values.position = track.value(frame, warnings).into(),
                Channel::Scale => values.scale = track.value(frame, warnings).into(),
                Channel::Rotation => values.rotation = track.rotation(frame, warnings),
                _ => track.other(frame, values, warnings),
            }
        }
        Ok(())
    }

    fn frames(&self) -> Option<(f64, f64)> {
        let ends = self.tracks.iter().map(Track::ends);
        ends.reduce(|a, b| (a.0.min(b.0), a.1.max(b.1)))
    }
}
