//! What the rows of a scene's keys show, and what is held there.

use std::collections::HashSet;
use std::sync::Arc;

use vides_engine::scene::Extrapolation;

use super::track_graph;
use crate::state::playing::drag::Drag;
use crate::state::playing::track_graph::Parts;
use crate::state::scene_view::KeyAt;

/// What the rows remember from pass to pass.
#[derive(Debug, Default)]
pub(crate) struct Memory {
    pub(crate) held: Held,
    /// Nodes whose tracks are not shown.
    pub(crate) folded: HashSet<usize>,
    /// The row whose menu is open.
    pub(crate) menu: Option<Row>,
    /// Curves are seen in place of rows.
    pub(crate) curves: bool,
    pub(crate) graph: track_graph::Memory,
}

/// A row: a node, or one of its tracks by number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Row {
    pub(crate) node: usize,
    pub(crate) track: Option<usize>,
}

/// What is held in the rows.
#[derive(Debug, Default)]
pub(crate) enum Held {
    #[default]
    Nothing,
    Keys(Box<Drag<KeysDrag>>),
    Bar(Box<Drag<BarDrag>>),
    /// Where the box began: its x, and its row with a fraction; what stays selected besides.
    Box {
        x: f32,
        row: f32,
        besides: Vec<KeyAt>,
    },
}

/// Keys that are dragged.
#[derive(Debug)]
pub(crate) struct KeysDrag {
    /// The other end of the selection, if its time is scaled.
    pub(crate) about: Option<f64>,
    pub(crate) done: KeyMotion,
}

/// The bar of a path that is dragged.
#[derive(Debug)]
pub(crate) struct BarDrag {
    pub(crate) node: usize,
    pub(crate) at: f64,
    pub(crate) beyond: Extrapolation,
    /// No pin holds it.
    pub(crate) free: bool,
}

/// What becomes of keys in time.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct KeyMotion {
    /// The keys as they were when it began.
    pub(crate) keys: Vec<KeyAt>,
    pub(crate) to: Change,
    /// They stay, and copies of them move.
    pub(crate) copies: bool,
    pub(crate) numbers: Numbers,
}

/// What becomes of the numbers of keys.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Numbers {
    Stay,
    /// These are greater by so much.
    By(f64, Arc<Parts>),
    /// The tangents of the one key.
    Tangents(Vec<f64>),
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Change {
    /// By this number of frames.
    By(f64),
    /// The one at `from` goes to `to`, and all others along with it as that at `about` stays.
    Scale { about: f64, from: f64, to: f64 },
}
