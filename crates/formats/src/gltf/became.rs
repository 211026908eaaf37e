//! What a node of the file becomes.

use glam::DVec3;

use crate::error::Error;

/// Errors of the container, which know no more than their reason.
pub(super) fn wrong(error: vides_document::mesh::Error) -> Error {
    vides_document::Error::from(error).into()
}

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
