//! What is known of the host: where the playhead was when it was last told, and where it draws.

use egui::Rect;
use vides_document::Selection;

/// Where the playhead stands in which path: while this is equal, the host has nothing new to learn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlayheadState {
    pub(crate) revision: u64,
    /// The shown camera of a scene, and how many nodes that has: their numbers may have changed.
    pub(crate) camera: Option<(Option<usize>, usize)>,
    pub(crate) selection: Selection,
    pub(crate) frame: Option<f64>,
    pub(crate) plays: bool,
    pub(crate) scrubbed: bool,
}

/// Where the host draws, in points of the window.
#[derive(Clone, Debug, PartialEq)]
pub struct HostPane {
    /// The picture.
    pub picture: Rect,
    /// What is shown above it, at least in part.
    pub above: Vec<Rect>,
}
