//! The formats of mesh files.

use std::ffi::OsStr;
use std::path::Path;

/// A mesh file format.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// Wavefront OBJ: `v` (with colours, if it has six numbers), `f`, `l`.
    Obj,
    /// Polygon file format: the elements `vertex`, `face` and `edge`.
    Ply,
    /// Stereolithography. Corners with equal coordinates are merged.
    Stl,
    /// glTF 2.0, text or GLB: coloured triangles, lines and points of all nodes of its scene.
    Gltf,
}

impl Format {
    /// The format by the file name's extension, in either case.
    #[must_use]
    pub fn of(file: &Path) -> Option<Self> {
        let ending = file.extension().and_then(OsStr::to_str)?;
        let known = [
            ("obj", Self::Obj),
            ("ply", Self::Ply),
            ("stl", Self::Stl),
            ("gltf", Self::Gltf),
            ("glb", Self::Gltf),
        ];
        known
            .into_iter()
            .find_map(|(name, format)| ending.eq_ignore_ascii_case(name).then_some(format))
    }
}
