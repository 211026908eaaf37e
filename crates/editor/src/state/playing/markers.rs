//! Markers that are dragged or renamed.

use crate::state::playing::tracks::Way;

/// What the markers remember from pass to pass.
#[derive(Debug, Default)]
pub(crate) struct Memory {
    pub(crate) held: Option<Drag>,
    pub(crate) renaming: Option<Renaming>,
}

/// A marker that is dragged.
#[derive(Debug)]
pub(crate) struct Drag {
    pub name: String,
    /// The scene's frames from which and to which it moves.
    pub(crate) from: f64,
    pub(crate) to: f64,
    pub(crate) way: Way,
}

/// A marker that gets another name.
#[derive(Debug)]
pub(crate) struct Renaming {
    pub name: String,
    pub(crate) text: String,
    /// It does not have the keyboard yet.
    pub(crate) fresh: bool,
}
