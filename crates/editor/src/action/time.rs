//! What can be asked for of the timeline.

use vides_engine::tools::profile::Quantity;

use crate::entry::Entry;
use crate::playing::axis::Seen;
use crate::state::playing::tracks::KeyMotion;
use crate::state::playing::{Pace, Retiming};

/// What plays, and moves keys in time.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum TimeAction {
    /// Show this in the graph, or else the pace, or no longer.
    Plot(Option<Quantity>),
    /// Open or close the speeds of the whole path.
    SwitchSpeedGraph,
    PlayOrPause,
    /// An entry into the play bar's frame.
    Playhead(Entry),
    /// Sets the frame rate; keys keep their time in seconds.
    Rate(f64),
    SwitchLoops,
    SwitchOnlySelected,
    /// Keep the times of keys in later edits, or let them follow the speed.
    SwitchFixedTimes,
    /// What follows a key that is moved in time moves along, or no longer.
    SwitchMovesAlong,
    /// Move or copy a key in time, in place of what the open step has done.
    Retime(Retiming),
    /// Move or copy keys of the scene, likewise.
    MoveKeys(Box<KeyMotion>),
    /// Move a marker to a frame of the scene, likewise.
    MoveMarker {
        name: String,
        to: f64,
    },
    /// The ruler counts frames, or seconds.
    RulerInFrames(bool),
    /// Show this part of the time on the timeline, or all.
    See(Option<Seen>),
    GraphHeight(f32),
    Pace(Pace),
}

impl TimeAction {
    /// Whether what a shown tool has made is taken first.
    pub(super) const fn takes_tool(&self) -> bool {
        matches!(
            self,
            Self::Retime(_) | Self::MoveKeys(_) | Self::MoveMarker { .. } | Self::SwitchSpeedGraph
        )
    }
}
