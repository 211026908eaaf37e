//! glTF 2.0 (Khronos 2021), text and GLB. Written by hand: readers of the whole format assume that
//! the accessors of a validated file are within its buffers.
//!
//! [`Container`] splits a file, [`Accessor`] finds numbers in it, [`Container::tree`] returns its
//! nodes and [`Container::part`] one of its meshes; readers of scenes need no more. Nothing here
//! knows scenes; materials and textures are not read.

mod accessor;
mod container;
mod geometry;
mod join;
#[cfg(test)]
mod tests;
mod tree;

use std::borrow::Cow;

use vides_engine::scene::Mesh;

pub use accessor::{Accessor, Component};
pub use container::Container;
pub use geometry::{Part, Room};
pub use tree::{Local, Placed};

use super::error::{Beside, Result};

/// The primitives of all nodes of the scene, in place.
pub(super) fn read(
    bytes: &[u8],
    beside: Beside<'_>,
    go_on: &mut dyn FnMut(f64) -> bool,
) -> Result<Mesh> {
    geometry::whole(&Container::open(Cow::Borrowed(bytes), beside)?, go_on)
}

/// Like [`read`], for an open file.
pub(super) fn whole(container: &Container<'_>, go_on: &mut dyn FnMut(f64) -> bool) -> Result<Mesh> {
    geometry::whole(container, go_on)
}
