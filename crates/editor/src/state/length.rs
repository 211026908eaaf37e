//! What is known of the length of the path.

/// What is known of the length; none of it is in the file.
#[derive(Debug, Default)]
pub(crate) struct Length {
    pub(crate) seen: Option<Seen>,
}

/// The path as it was when its length was last looked at.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Seen {
    /// [`crate::Editor::step_number`]
    pub(crate) state: (u64, u64),
    /// The newest state of that path.
    pub(crate) newest: u64,
    /// The path of this node.
    pub(crate) node: Option<usize>,
    pub(crate) frames: usize,
    pub(crate) fps: f64,
}
