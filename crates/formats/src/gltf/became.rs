//! What a node of the file becomes.

use glam::DVec3;

/// What a node of the file becomes.
#[derive(Clone, Copy, Default)]
pub(super) struct Became {
    /// Our number; none if it is the origin of the whole file.
    pub(super) node: Option<usize>,
    /// Whether it was turned to look along z.
    pub(super) turned: bool,
    /// What its position counts from.
    pub(super) pivot: DVec3,
    /// Whether it is a part of the node above.
    pub(super) absorbed: bool,
    /// The numbers in the file of its parts, which are no nodes of ours.
    pub(super) parts: [Option<usize>; 3],
    /// Where the positions of its children count from, in the node.
    pub(super) origin: DVec3,
}
