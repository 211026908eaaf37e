//! Meshes and point clouds from Wavefront OBJ, PLY, STL (both ASCII and binary) and glTF or GLB.
//!
//! Files are read from memory, and no count in a header causes an allocation. Only geometry is
//! read: points, their colours, lines, and polygons as fans of triangles; from glTF also morph
//! targets, for readers of scenes (module `gltf`). The crate opens no files and knows neither
//! scenes nor windows.

#![forbid(unsafe_code)]
// Standard output is the host's.
#![cfg_attr(not(test), warn(clippy::print_stdout))]

mod error;
mod format;
#[cfg(feature = "gltf")]
pub mod gltf;
mod obj;
mod opened;
#[cfg(feature = "ply")]
mod ply;
mod read;
mod shared;
pub mod srgb;
mod stl;
#[cfg(all(test, feature = "gltf", feature = "ply"))]
mod tests;

pub use error::{Beside, Error, Problem};
pub use format::Format;
pub use opened::Opened;
pub use read::{read, read_with};
pub use shared::fan;
