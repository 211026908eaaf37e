//! Markers that are dragged or renamed.

use crate::state::playing::drag::Drag;

/// What the markers remember from pass to pass.
#[derive(Debug, Default)]
pub(crate) struct Memory {
    pub(crate) held: Option<Box<Drag<Moved>>>,
    pub(crate) renaming: Option<Renaming>,
}

/// A marker that is dragged, and the scene's frame to which it moves.
#[derive(Debug)]
pub(crate) struct Moved {
    pub name: String,
    pub(crate) to: f64,
}

/// A marker that gets another name.
#[derive(Debug)]
pub(crate) struct Renaming {
    pub name: String,
    pub(crate) text: String,
    /// It does not have the keyboard yet.
    pub(crate) fresh: bool,
}
