//! Reads meshes of all formats.

use vides_engine::scene::Mesh;

use super::error::{Beside, Error, Result};
use super::format::Format;
#[cfg(feature = "gltf")]
use super::gltf;
#[cfg(feature = "ply")]
use super::ply;
use super::shared::checked;
use super::{obj, stl};

/// Reads a mesh. `go_on` is called repeatedly with the share that is done, from 0 to 1.
///
/// # Errors
/// [`Error`]; [`Error::Stopped`] if `go_on` returns false.
pub fn read(format: Format, bytes: &[u8], go_on: &mut dyn FnMut(f64) -> bool) -> Result<Mesh> {
    read_with(format, bytes, &mut |_| None, go_on)
}

/// Like [`read`], for files with external buffers, which `beside` returns by name.
///
/// # Errors
/// Those of [`read`].
pub fn read_with(
    format: Format,
    bytes: &[u8],
    beside: Beside<'_>,
    go_on: &mut dyn FnMut(f64) -> bool,
) -> Result<Mesh> {
    let mesh = match format {
        Format::Obj => obj::read(bytes, go_on),
        #[cfg(feature = "ply")]
        Format::Ply => ply::read(bytes, go_on),
        Format::Stl => stl::read(bytes, go_on),
        #[cfg(feature = "gltf")]
        Format::Gltf => gltf::read(bytes, beside, go_on),
        #[allow(unreachable_patterns)]
        _ => {
            let _ = beside;
            Err(Error::LeftOut)
        }
    }?;
    checked(mesh)
}
