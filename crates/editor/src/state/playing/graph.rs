//! What the graph of the whole path shows, and what is held there and in the row of keys.

use std::sync::Arc;

use egui::{Color32, Id, Mesh, Rangef};
use vides_document::Selection;
use vides_raster::Lines;

use super::{markers, tracks};
use crate::playing::axis::Axis;
use crate::state::playing::drag::Drag;
use crate::state::playing::{Beside, Retiming};

/// The speeds of the whole path.
#[derive(Debug, Default)]
pub(crate) struct Graph {
    pub(crate) stretches: Vec<Stretch>,
    /// The highest speed, or the largest of the ten if that is higher.
    pub(crate) highest: f32,
}

/// The frames of a section in which something changes.
#[derive(Debug)]
pub(crate) struct Stretch {
    /// The orientation with which it begins.
    pub(crate) from: Selection,
    /// The frame after its hold, and the one of the next key.
    pub(crate) start: usize,
    pub(crate) end: usize,
    /// 50 is the base speed; higher the fewer frames the section has for its length.
    pub(crate) speeds: [f32; PIECES + 1],
    /// Factor from the ten speeds to these.
    pub(crate) scale: f32,
}

/// What is being dragged.
#[derive(Debug, Default)]
pub(crate) enum Held {
    #[default]
    Nothing,
    /// A key or a border.
    Key(Box<Drag<KeyDrag>>),
    /// One of the ten speeds, the pointer's offset from its middle, and whether the section beside,
    /// which goes on as fast, follows.
    Speed(usize, f32, bool),
}

/// What the timeline remembers from pass to pass.
#[derive(Debug, Default)]
pub(crate) struct Memory {
    pub(crate) held: Held,
    /// A key is held since an earlier pass: nothing else can be taken.
    pub(crate) carries: bool,
    pub(crate) curve: Curve,
    pub(crate) tracks: tracks::Memory,
    pub(crate) markers: markers::Memory,
}

/// Pieces of a section's curve.
pub(crate) const PIECES: usize = 24;

/// A key of the path that is dragged.
#[derive(Debug)]
pub(crate) struct KeyDrag {
    /// What was taken; what shows it may vanish meanwhile.
    pub(crate) id: Id,
    pub(crate) of: Selection,
    /// The path's frame at which it stood.
    pub(crate) from: usize,
    pub(crate) beside: Beside,
    /// All frames when it began.
    pub(crate) frames: usize,
    pub(crate) done: Retiming,
}

#[derive(Debug, Default)]
pub(crate) struct Curve {
    /// The path's revision, what is current, the scale, and the theme's accent.
    pub(crate) made_of: Option<(Option<u64>, Selection, Scale, Color32)>,
    pub(crate) shade: Arc<Mesh>,
    pub(crate) lines: Arc<Lines>,
}

/// From frames and speeds to the screen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Scale {
    pub(crate) axis: Axis,
    pub(crate) rows: Rangef,
    pub(crate) highest: f32,
}
