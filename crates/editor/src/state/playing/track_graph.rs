//! What the curves of a scene's keys show, and what is held there.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use egui::Pos2;
use vides_engine::scene::Channel;

use crate::state::playing::drag::Drag;
use crate::state::playing::tracks::KeyMotion;
use crate::state::scene_view::KeyAt;
use crate::state::space::Joint;

/// What the graph remembers from pass to pass.
#[derive(Debug, Default)]
pub(crate) struct Memory {
    /// The tracks that are to be seen; none: those with selected keys, else the first one.
    pub(crate) chosen: Vec<(usize, Channel)>,
    /// Of the selected keys; a key that is missing here has all its numbers selected.
    pub(crate) parts: Parts,
    pub(crate) joints: Joints,
    pub(crate) held: Held,
    /// The least and the greatest number that are seen while something is held.
    pub(crate) range: Option<(f64, f64)>,
}

/// A number of a key: node, channel, the frame's bits, which number.
pub(crate) type PartOf = (usize, Channel, u64, usize);

/// Numbers of keys that are selected.
pub(crate) type Parts = BTreeSet<PartOf>;

/// One number of a key.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Dot {
    pub(crate) at: KeyAt,
    pub(crate) part: usize,
}

/// What is held in the graph.
#[derive(Debug, Default)]
pub(crate) enum Held {
    #[default]
    Nothing,
    Dots(Box<Drag<DotsDrag>>),
    Handle(Box<HandleDrag>),
    /// Where the box began, and what stays selected besides.
    Box {
        from: Pos2,
        besides: Vec<Dot>,
    },
}

/// What keys do with one tangent while the user drags the opposite one.
pub(crate) type Joints = BTreeMap<PartOf, Joint>;

/// Numbers of keys that are dragged.
#[derive(Debug)]
pub(crate) struct DotsDrag {
    pub(crate) parts: Arc<Parts>,
    /// What the graph knew of selected numbers.
    pub(crate) before: Parts,
    /// The number that was taken as it was, and whether that is just to be read.
    pub(crate) value: f64,
    pub(crate) read_only: bool,
    pub(crate) channel: Channel,
    /// The pointer of the last pass, what a point is worth, and how far the number has gone.
    pub(crate) pointer: f32,
    pub(crate) each: f64,
    pub(crate) gone: f64,
    /// Some of the numbers are not just to be read.
    pub(crate) lifts: bool,
    /// The time stays, or the number.
    pub(crate) stays: [bool; 2],
    pub(crate) done: KeyMotion,
}

/// A handle that is dragged.
#[derive(Debug)]
pub(crate) struct HandleDrag {
    pub(crate) dot: Dot,
    pub(crate) side: Side,
    pub(crate) joint: Joint,
    pub(crate) pointer: Pos2,
    /// Where it stands from its key.
    pub(crate) way: egui::Vec2,
    /// The key's tangents before.
    pub(crate) before: Vec<f64>,
    pub(crate) done: Vec<f64>,
}

/// A side of a key.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Side {
    Before,
    After,
}
