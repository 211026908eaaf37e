//! Why a file cannot be read or written.

use std::fmt;

use vides_document::error::{Called, EngineError, ErrorKind, Text};

use super::foreign::Foreign;
use super::options::OPTIONS;

/// The names of all formats, in the order in which they are offered, which errors tell.
pub(super) const NAMES: [&str; 26] = [
    "vid",
    "ascii",
    "csv",
    "json",
    "gltf",
    "glb",
    "usda",
    "blender",
    "paraview",
    "vtk",
    "html",
    "nerfstudio",
    "transforms",
    "instant-ngp",
    "cameras",
    "supersplat",
    "tum",
    "euroc",
    "kitti",
    "matrices",
    "open3d",
    "record3d",
    "polycam",
    "colmap",
    "osg",
    "chan",
];

/// How a format is named for writing: as people do it, and as a C program does.
const NAMED_TO: Called = Called("name it, with --to in the command", "name it, with format");
/// The same for reading.
const NAMED_FROM: Called = Called(
    "name it, with --from in the command",
    "name it, with format",
);

/// Why a file cannot be read or written.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// Of the document, the engine or the system.
    #[error(transparent)]
    Document(#[from] vides_document::Error),
    /// What is wrong at a place of a file.
    #[error("{place}{cause}")]
    Content {
        /// Where.
        place: Place,
        /// What.
        cause: Cause,
    },
    /// No node has this name.
    #[error("there is no node \"{0}\"")]
    NoNode(Text),
    /// The node is no camera, which this format is for.
    #[error("node \"{0}\" is no camera; of others this format holds nothing")]
    NoCamera(Text),
    /// No animation has this name.
    #[error("there is no animation \"{wanted}\"; animations are: {known}")]
    NoClip {
        /// The name.
        wanted: Text,
        /// The existing names.
        known: Text,
    },
    /// The frames asked for are not there.
    #[error("the frames are {first} to {last}")]
    NoFrames {
        /// The first existing frame.
        first: f64,
        /// The last one.
        last: f64,
    },
    /// An unknown option.
    #[error("there is no option \"{0}\"; options are {names}", names = names(OPTIONS.iter().map(|row| row.name)))]
    NoOption(Text),
    /// An option cannot have this value.
    #[error("{name}: {wanted} is wanted, not \"{given}\"")]
    Value {
        /// The option.
        name: &'static str,
        /// What it takes.
        wanted: &'static str,
        /// What was given.
        given: Text,
    },
    /// No format has this name.
    #[error("there is no format \"{0}\"; formats are {names}", names = names(NAMES.into_iter()))]
    UnknownFormat(Text),
    /// No format is written into files of this name.
    #[error("{0}: no format has this ending: {NAMED_TO}")]
    UnknownEnding(Text),
    /// Several formats are written into files of this ending.
    #[error("{file}: this may be {}: {NAMED_TO}", or_names(.formats))]
    SharedEnding {
        /// The file.
        file: Text,
        /// The formats.
        formats: Vec<&'static str>,
    },
    /// No format reads this content.
    #[error("this is no file of a format that is read: {NAMED_FROM}")]
    NotRecognised,
    /// The content is that of another program, and not read.
    #[error("{} files are not read: {}", .0.name, .0.way)]
    Foreign(&'static Foreign),
    /// A list of poses is wanted.
    #[error("this is a path or a scene, not a list of poses")]
    NotPoses,
    /// Several formats could read this content.
    #[error("this may be {}: {NAMED_FROM}", or_names(.0))]
    Ambiguous(Vec<&'static str>),
    /// The format is written only.
    #[error("the format {0} is written, not read")]
    NotRead(&'static str),
    /// The format is read only.
    #[error("the format {0} is read, not written")]
    NotWritten(&'static str),
    /// The format is a folder of files, and no stream.
    #[error("the format {0} is a folder of files: name one")]
    Folder(&'static str),
    /// The format holds a whole document, of which nothing can be chosen.
    #[error("{0}: a .vid file holds all of a document as it is")]
    Whole(&'static str),
    /// The format has another up axis.
    #[error("in the format {format} the {up} axis stands upright")]
    OtherUp {
        /// The format.
        format: &'static str,
        /// Its axis.
        up: &'static str,
    },
    /// Poses at their own times, of another format or at a rate.
    #[error("times=own is for the formats tum, euroc, osg, kitti and matrices, without fps")]
    OwnTimes,
    /// The progress callback ended it.
    #[error("it was stopped")]
    Stopped,
    /// In a file.
    #[error("{0}: {1}")]
    In(Text, Box<Error>),
}

/// The result of fallible operations.
pub type Result<T, E = Error> = std::result::Result<T, E>;

fn names<'a>(names: impl Iterator<Item = &'a str>) -> String {
    names.collect::<Vec<_>>().join(", ")
}

fn or_names(names: &[&'static str]) -> String {
    vides_document::error::one_of(names, "or")
}

impl Error {
    /// Prefixes the name of the file where the error lacks one.
    #[must_use]
    pub fn at(self, file: &str) -> Self {
        match self {
            Self::Document(error) => Self::Document(error.at(file)),
            Self::In(..) | Self::UnknownEnding(_) | Self::SharedEnding { .. } | Self::Stopped => {
                self
            }
            other => Self::In(file.into(), Box::new(other)),
        }
    }

    /// The kind of the error.
    #[must_use]
    pub fn kind(&self) -> ErrorKind {
        match self {
            Self::Document(error) => error.kind(),
            Self::Content { .. } | Self::NotRecognised | Self::Foreign(_) | Self::Ambiguous(_) => {
                ErrorKind::Format
            }
            Self::NoFrames { .. } => ErrorKind::Range,
            Self::In(_, error) => error.kind(),
            _ => ErrorKind::Argument,
        }
    }
}

impl From<EngineError> for Error {
    fn from(error: EngineError) -> Self {
        Self::Document(error.into())
    }
}

impl From<std::collections::TryReserveError> for Error {
    fn from(_: std::collections::TryReserveError) -> Self {
        EngineError::Memory.into()
    }
}

/// A place in a file.
#[derive(Debug, Clone, PartialEq)]
pub enum Place {
    /// All of it.
    Whole,
    /// A line, counted from 1.
    Line(usize),
    /// A key of structured text (`frames[2].fl_x`).
    Key(Text),
    /// A byte, counted from 0.
    Byte(u64),
}

impl Place {
    /// An error at this place.
    #[must_use]
    pub fn wrong(self, cause: Cause) -> Error {
        Error::Content { place: self, cause }
    }

    /// An error at this place: something else is expected.
    #[must_use]
    pub fn expected(self, wanted: Wanted) -> Error {
        self.wrong(Cause::Expected(wanted))
    }
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Whole => Ok(()),
            Self::Line(line) => write!(f, "line {line}: "),
            Self::Key(key) => write!(f, "{key}: "),
            Self::Byte(byte) => write!(f, "byte {byte}: "),
        }
    }
}

/// What is wrong at a place of a file.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[allow(missing_docs)]
pub enum Cause {
    #[error("expected {0}")]
    Expected(Wanted),
    #[error("expected {wanted} numbers, found {found}")]
    NumberCount { wanted: usize, found: usize },
    #[error("expected one for each of {poses} poses, found {found}")]
    EachPose { poses: usize, found: usize },
    #[error("the number must be finite")]
    NotFinite,
    #[error("the number is too large")]
    TooLarge,
    #[error("the rotation is zero")]
    NoRotation,
    #[error("there is no number {index}: there are {count}")]
    Index { index: u64, count: usize },
    #[error("the times must increase")]
    Order,
    /// In the words of the parser.
    #[error("{0}")]
    Syntax(Text),
    #[error("this is not UTF-8 text")]
    NotUtf8,
    #[error("the file ends too early")]
    End,
    #[error("there are no poses in this file")]
    Empty,
    #[error("this has more than is taken")]
    Long,
    #[error("this lies deeper than is taken")]
    Deep,
    #[error("{0} lies below itself")]
    Cycle(Text),
    #[error("{0} is not there")]
    Missing(Text),
    #[error("{0} lies outside the file's folder, where nothing is read")]
    Outside(Text),
    #[error("{0} lies there too and would be read first: move it away")]
    Beside(Text),
    #[error("{0} there has data that would be lost: write into another folder")]
    Replaced(Text),
    /// With the command that makes something of it that is read, if there is one.
    #[error("{name} is not read{}", if help.is_empty() { String::new() } else { format!(": make text of it by `{help}`") })]
    Unsupported { name: Text, help: &'static str },
}

/// What is expected at a place of a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum Wanted {
    Number,
    WholeNumber,
    PositiveNumber,
    Text,
    List,
    Object,
    Numbers(usize),
    Matrix,
    Rotation,
    Name,
    Value,
    Literal(&'static str),
    ImagePoints,
    LastRow,
    Matrices,
}

impl fmt::Display for Wanted {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Number => "a number",
            Self::WholeNumber => "a whole number",
            Self::PositiveNumber => "a number greater than 0",
            Self::Text => "a text",
            Self::List => "an array",
            Self::Object => "an object",
            Self::Numbers(count) => return write!(f, "{count} numbers"),
            Self::Matrix => "a matrix of 4 × 4 numbers",
            Self::LastRow => "a matrix whose last row is 0 0 0 1",
            Self::Matrices => "an array of N × 4 × 4 or N × 3 × 4 numbers",
            Self::ImagePoints => "the points of the image before, or an empty line",
            Self::Rotation => "a matrix that turns and does not mirror",
            Self::Name => "a name",
            Self::Value => "a value",
            Self::Literal(text) => return write!(f, "\"{text}\""),
        })
    }
}
