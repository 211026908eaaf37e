//! The points that are selected together, and how others are chosen.

use vides_document::{Document, Selection};

/// The points selected together.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Selected {
    /// Ascending; empty: the current one alone.
    pub(crate) points: Vec<usize>,
    pub(crate) of: SelectionScope,
}

/// What a selection holds for: it ends when another point is current or their number changes.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct SelectionScope {
    pub(crate) current: usize,
    pub(crate) count: usize,
    pub(crate) node: Option<usize>,
}

impl SelectionScope {
    pub(crate) fn now(document: &Document) -> Self {
        Self {
            current: document.selection().point,
            count: document.path().points.len(),
            node: document.edited_scene().and_then(|edited| edited.node()),
        }
    }
}

/// Which points to select.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum SelectionChange {
    /// The current one alone.
    Current,
    /// This one alone, with its orientation; both become current.
    Only(Selection),
    All,
    /// Adds one, which becomes current, or removes it.
    Switch(usize),
    /// From the current one to this one.
    UpTo(usize),
    /// These; if the current one is not among them, the nearest to it becomes current.
    These(Vec<usize>),
}

/// The next one of `count`, or the one before, round and round.
pub(crate) fn step_around(at: usize, forward: bool, count: usize) -> usize {
    let count = count.max(1);
    (at % count + if forward { 1 } else { count - 1 }) % count
}
