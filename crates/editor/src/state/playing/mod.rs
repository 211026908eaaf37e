//! What the timeline remembers, and what can be asked for there.

pub(crate) mod drag;
pub(crate) mod graph;
pub(crate) mod markers;
pub(crate) mod plot;
pub(crate) mod track_graph;
pub(crate) mod tracks;

use vides_document::Selection;
use vides_engine::path::Overrides;

use crate::playing::axis::Seen;
use crate::state::playing::graph::Graph;

/// Speed of playing.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Pace {
    #[default]
    Whole,
    Half,
    Double,
}

/// An orientation and its frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Mark {
    pub(crate) point: usize,
    pub(crate) orientation: usize,
    pub(crate) frame: usize,
    /// For how many frames more the camera rests there.
    pub(crate) hold: usize,
}

/// The keys of the path on the scale of its frames.
#[derive(Debug, Default)]
pub(crate) struct Marks {
    pub(crate) revision: Option<u64>,
    pub(crate) keys: Vec<Mark>,
    /// The scene's markers: its frames, and their names.
    pub(crate) markers: Vec<(f64, String)>,
    /// All frames of the path; 0 if there are too many.
    pub(crate) frames: usize,
    /// The first and the last frame of the scene, or of the path alone.
    pub(crate) range: (f64, f64),
    pub(crate) graph: Graph,
}

/// Roll and up of the playhead between two keys, kept for one pass.
#[derive(Debug)]
pub(crate) struct Between {
    pub(crate) revision: u64,
    pub(crate) frame: f64,
    pub(crate) roll: f64,
    pub(crate) own: Overrides,
}

/// What becomes of a key in time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Retiming {
    /// As it was when the drag began.
    Nothing,
    /// Moves this number of frames from the section after it to the one before it; without
    /// one, all behind it moves along.
    Move {
        before: (Selection, usize),
        after: Option<(Selection, usize)>,
        by: i64,
    },
    /// A key like it at this frame.
    Copy { of: Selection, to: usize },
}

#[derive(Debug, Default)]
pub(crate) struct Playing {
    /// The frame that is shown, of the scene or of a path alone; none: the current orientation.
    pub(crate) frame: Option<f64>,
    /// While it plays: since when, in egui's time, and from which frame.
    pub(crate) since: Option<(f64, f64)>,
    /// Whether to play from the next pass on, if that was ordered.
    pub(crate) ordered: Option<bool>,
    /// The playhead was moved by hand.
    pub(crate) scrubbed: bool,
    /// Starts over at the end.
    pub(crate) loops: bool,
    pub(crate) pace: Pace,
    /// The frame before a number of the bar was dragged.
    pub(crate) before: Option<f64>,
    /// What was current in the last pass.
    pub(crate) selection: Selection,
    pub(crate) marks: Marks,
    pub(crate) between: Option<Between>,
    /// When `marks` were brought up to date, in egui's time.
    pub(crate) marked: f64,
    pub(crate) speeds: graph::Memory,
    /// The window is low, and the graph is to be shown there, too.
    pub(crate) low: bool,
    pub(crate) low_graph: bool,
    /// Its height, if it was dragged.
    pub(crate) graph_height: Option<f32>,
    /// What the graph shows.
    pub(crate) shown: plot::Shown,
    pub(crate) plot: plot::Plot,
    /// What follows a key moves along with it.
    pub(crate) moves_along: bool,
    /// The part of the time that is seen; none: all.
    pub(crate) seen: Option<Seen>,
    /// Only the frames in which what is selected moves are played.
    pub(crate) only_selected: bool,
    /// The first and the last frame of the axis, which stays while something is dragged.
    pub(crate) axis: (f64, f64),
}

/// The sections beside a key with their frames.
pub(crate) type Beside = [Option<(Selection, usize)>; 2];
