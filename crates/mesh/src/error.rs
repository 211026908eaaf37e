//! Why a mesh cannot be read.

/// Why a mesh cannot be read.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// An error in a line of a text file.
    #[error("line {line}: {problem}")]
    Line {
        /// Counted from 1.
        line: usize,
        /// The problem in that line.
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
    /// The file's extension belongs to no [`super::Format`].
    #[error("the names of files with meshes end in .obj, .ply, .stl, .gltf or .glb")]
    UnknownFormat,
    /// This build does not read files of this format: PLY and glTF are features.
    #[error("this program is built without meshes of this format")]
    LeftOut,
    /// A warning: the file has changed since the scene was saved.
    #[error("the mesh has changed since the scene was saved")]
    Changed,
    /// The engine rejects the mesh: too large, or not finite.
    #[error(transparent)]
    Mesh(#[from] vides_engine::Error),
}

/// A problem in a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Problem {
    /// Not three finite coordinates.
    #[error("expected three finite numbers")]
    Coordinates,
    /// A line or polygon with too few points, or with a point that does not exist.
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
    /// The file has no such part.
    #[error("this file has no such part")]
    NoPart,
    /// A glTF node that is its own ancestor, or has two parents.
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

/// Returns an external buffer by the name in the file.
pub type Beside<'a> = &'a mut dyn FnMut(&str) -> Option<Vec<u8>>;

pub(crate) type Result<T, E = Error> = std::result::Result<T, E>;
