//! Meshes and point clouds from Wavefront OBJ, PLY, STL (both ASCII and binary) and glTF or GLB.
//!
//! Files are read from memory; nothing is allocated because a header claims a number. Only geometry
//! is taken: points, their colours, lines, and polygons as fans of triangles; of glTF also morph
//! targets, for readers of scenes (module `gltf`). The crate opens no
//! files and knows neither scenes nor windows.

#![forbid(unsafe_code)]

#[cfg(feature = "gltf")]
pub mod gltf;
mod obj;
mod opened;
#[cfg(feature = "ply")]
mod ply;
pub mod srgb;
mod stl;
#[cfg(all(test, feature = "gltf", feature = "ply"))]
mod tests;

use std::ffi::OsStr;
use std::path::Path;

use vides_engine::scene::Mesh;

pub use opened::Opened;

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

/// Why a mesh cannot be read.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// An error in a line of a text file.
    #[error("line {line}: {problem}")]
    Line {
        /// Counted from 1.
        line: usize,
        /// What is wrong with it.
        problem: Problem,
    },
    /// An error of the whole file.
    #[error("{0}")]
    File(Problem),
    /// An error of the PLY reader.
    #[error("{0}")]
    Ply(String),
    /// A glTF file that cannot be read without this extension.
    #[error("this file requires the extension {0}, which is not read")]
    Extension(String),
    /// Out of memory.
    #[error("out of memory")]
    Memory,
    /// `go_on` returned false.
    #[error("reading was stopped")]
    Stopped,
    /// The file's extension is none of [`Format`]'s.
    #[error("the names of files with meshes end in .obj, .ply, .stl, .gltf or .glb")]
    UnknownFormat,
    /// This build reads no files of this format: PLY and glTF are features.
    #[error("this program is built without meshes of this format")]
    LeftOut,
    /// A warning: the file has changed since the scene was saved.
    #[error("the mesh has changed since the scene was saved")]
    Changed,
    /// The engine rejects the mesh: too large, or not finite.
    #[error(transparent)]
    Mesh(#[from] vides_engine::Error),
}

/// What is wrong in a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Problem {
    /// Not three finite coordinates.
    #[error("expected three finite numbers")]
    Coordinates,
    /// A line or polygon with too few points, or with one that does not exist.
    #[error("expected numbers of points that are in the file")]
    Indices,
    /// The file is truncated.
    #[error("the file ends too early")]
    End,
    /// An unexpected line.
    #[error("expected \"{0}\"")]
    Expected(&'static str),
    /// No points.
    #[error("there are no points in this file")]
    Empty,
    /// A glTF buffer is missing or unreadable.
    #[error("a buffer of this file is gone, or cannot be read")]
    Buffer,
    /// More than the limits allow.
    #[error("this file has more than is taken")]
    Long,
    /// A glTF mesh with `KHR_draco_mesh_compression`.
    #[error(
        "a mesh compressed by Draco (KHR_draco_mesh_compression) is not read; export it uncompressed"
    )]
    Draco,
    /// A glTF mesh with `EXT_meshopt_compression`.
    #[error(
        "a mesh compressed by meshoptimizer (EXT_meshopt_compression) is not read; export it uncompressed"
    )]
    Meshopt,
    /// A part that the file does not have.
    #[error("this file has no such part")]
    NoPart,
    /// A glTF node below itself, or in two places.
    #[error("a node of this file lies below itself or in two places; each may stand in one")]
    Cycle,
    /// Not a file of this format.
    #[error("this is no file of this format")]
    Format,
}

impl From<std::collections::TryReserveError> for Error {
    fn from(_: std::collections::TryReserveError) -> Self {
        Self::Memory
    }
}

/// Gives an external buffer by the name in the file.
pub type Beside<'a> = &'a mut dyn FnMut(&str) -> Option<Vec<u8>>;

type Result<T, E = Error> = std::result::Result<T, E>;

/// Reads a mesh. `go_on` is called now and then with the share done, in 0…1.
///
/// # Errors
/// [`Error`]; [`Error::Stopped`] if `go_on` returns false.
pub fn read(format: Format, bytes: &[u8], go_on: &mut dyn FnMut(f64) -> bool) -> Result<Mesh> {
    read_with(format, bytes, &mut |_| None, go_on)
}

/// As [`read`], for files with external buffers, which `beside` gives by name.
///
/// # Errors
/// As [`read`].
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

/// A mesh of some points that fits the engine.
fn checked(mesh: Mesh) -> Result<Mesh> {
    if mesh.points.is_empty() {
        return Err(Error::File(Problem::Empty));
    }
    mesh.check()?;
    Ok(mesh)
}

/// Lines or records between two calls of `go_on`.
const EVERY: usize = 1 << 14;

/// The words of each non-empty line, with the line's number; calls `go_on`.
fn lines<'a>(
    bytes: &'a [u8],
    go_on: &'a mut dyn FnMut(f64) -> bool,
) -> impl Iterator<Item = Result<(usize, impl Iterator<Item = &'a str> + Clone)>> {
    let mut done = 0;
    bytes
        .split(|&byte| byte == b'\n')
        .enumerate()
        .filter_map(move |(at, line)| {
            done += line.len() + 1;
            if at % EVERY == 0 && !go_on(done as f64 / bytes.len().max(1) as f64) {
                return Some(Err(Error::Stopped));
            }
            // Anything but UTF-8 is a name or a comment, or no valid number.
            let text = str::from_utf8(line).unwrap_or("?").trim();
            (!text.is_empty()).then(|| Ok((at + 1, text.split_ascii_whitespace())))
        })
}

fn coordinates<'a>(words: &mut impl Iterator<Item = &'a str>) -> Option<glam::DVec3> {
    let mut next = || {
        words
            .next()?
            .parse()
            .ok()
            .filter(|number: &f64| number.is_finite())
    };
    Some(glam::DVec3::new(next()?, next()?, next()?))
}

/// A polygon as a fan of triangles around its first corner.
///
/// # Errors
/// [`Error::Memory`].
pub fn fan(corners: &[u32], triangles: &mut Vec<[u32; 3]>) -> Result<(), Error> {
    triangles.try_reserve(corners.len().saturating_sub(2))?;
    triangles.extend(
        corners
            .windows(2)
            .skip(1)
            .map(|pair| [corners[0], pair[0], pair[1]]),
    );
    Ok(())
}
