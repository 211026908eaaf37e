//! Errors of documents and their files; the engine's errors pass through unchanged.

use std::fmt;
use std::io;

pub use vides_engine::error::{
    Bound, Called, Cause, Error as EngineError, ErrorKind, FromZero, Index, Invalid, List,
    OutOfRange, Place, Quantity, Text, TooMany, reason,
};
#[doc(hidden)]
pub use vides_engine::error::{can_allocate, complain, panic_said, try_box, vec_with_room};

use vides_engine::limits;
use vides_engine::property::Kind;

/// What can go wrong with a document and its files.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// An error of the engine, or out of memory.
    #[error(transparent)]
    Engine(#[from] EngineError),
    /// An edit that this path does not allow.
    #[error(transparent)]
    Refused(#[from] Refused),
    /// The operating system failed to read or write a file.
    #[error("{place}: {}", reason(source))]
    Io {
        /// The file, as the caller named it.
        place: String,
        /// What the operating system said.
        source: io::Error,
    },
    /// The contents of a file are invalid.
    #[error("line {line}: {key}{cause}")]
    Format {
        /// Counted from 1.
        line: usize,
        /// The key on that line.
        key: Key,
        /// What is wrong.
        cause: Malformed,
    },
    /// A property cannot be set so.
    #[error("{name}: {cause}")]
    Property {
        /// Its name, as it was given.
        name: Text,
        /// What is wrong.
        cause: Malformed,
    },
    /// A file is longer than the MiB that are read.
    #[error("the file is larger than the {0} MiB that are read")]
    FileTooLarge(u64),
    /// Parsing from this line could take too much memory.
    #[error(
        "line {0}: what begins here could take more than {most} MiB of memory to be read",
        most = limits::MAX_PARSE_BYTES >> 20
    )]
    PieceTooLarge(usize),
    /// A mesh file is invalid.
    #[error(transparent)]
    Mesh(#[from] vides_mesh::Error),
    /// An error at a place of a scene.
    #[error("{0}: {1}")]
    At(Place, Cause<Error>),
    /// An error in a file.
    #[error("{0}: {1}")]
    In(Text, Cause<Error>),
}

/// The result of fallible operations.
pub type Result<T, E = Error> = std::result::Result<T, E>;

impl Error {
    /// Prefixes the file's name where the error lacks one.
    #[must_use]
    pub fn at(self, file: impl fmt::Display) -> Self {
        if matches!(self, Self::Io { .. } | Self::Engine(EngineError::Memory)) {
            return self;
        }
        let name = (&file).into();
        Cause::new(self).map_or_else(|same| same, |cause| Self::In(name, cause))
    }

    /// The file of [`Refused::Outside`].
    #[must_use]
    pub fn outside(&self) -> Option<&Text> {
        match self.innermost() {
            Self::Refused(Refused::Outside(file)) => Some(file),
            _ => None,
        }
    }

    /// Whether it is [`Refused::Input`].
    #[must_use]
    pub fn is_input(&self) -> bool {
        matches!(self.innermost(), Self::Refused(Refused::Input(_)))
    }

    /// The error without the places before it.
    fn innermost(&self) -> &Self {
        match self {
            Self::At(_, cause) | Self::In(_, cause) => cause.innermost(),
            other => other,
        }
    }

    /// The kind of the error.
    #[must_use]
    pub fn kind(&self) -> ErrorKind {
        match self {
            Self::Engine(error) => error.kind(),
            Self::Refused(refused) => refused.kind(),
            Self::Io { .. } => ErrorKind::Io,
            Self::Format { .. } => ErrorKind::Format,
            Self::Property { cause, .. } => match cause {
                Malformed::Engine(error) => error.kind(),
                Malformed::Between { .. } | Malformed::PresetNumber => ErrorKind::Range,
                _ => ErrorKind::Argument,
            },
            Self::FileTooLarge(_) | Self::PieceTooLarge(_) => ErrorKind::Limit,
            Self::Mesh(error) => match error {
                vides_mesh::Error::Memory => ErrorKind::Memory,
                vides_mesh::Error::Mesh(error) => error.kind(),
                _ => ErrorKind::Format,
            },
            Self::At(_, cause) | Self::In(_, cause) => cause.kind(),
        }
    }
}

impl From<std::collections::TryReserveError> for Error {
    fn from(_: std::collections::TryReserveError) -> Self {
        EngineError::Memory.into()
    }
}

/// The key of a line, if any.
#[derive(Debug)]
pub struct Key(pub Option<Text>);

impl fmt::Display for Key {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.0 {
            Some(key) => write!(f, "{key}: "),
            None => Ok(()),
        }
    }
}

/// An edit that this path does not allow. Numbers count from 0; sentences say them as [`Index`]
/// does.
#[derive(Debug, thiserror::Error)]
#[allow(missing_docs)]
pub enum Refused {
    #[error("a new point must be put at {} to {}, not at {}", Index(0), Index(*last), Index(*at))]
    NewPoint { at: usize, last: usize },
    #[error("the last two points of a path cannot be removed")]
    TwoPointsRemain,
    #[error("no segment begins in the last point of an open path")]
    NoSegmentAtEnd,
    #[error(
        "there is no segment {}: the path has segments {} to {}",
        Index(*segment), Index(0), Index(*last)
    )]
    NoSegment { segment: usize, last: usize },
    #[error("a segment is divided by 1 to 10 points")]
    Division,
    #[error("a closed path has no ends")]
    NoEnds,
    #[error("the {0} segment has no length and so no direction to go on in")]
    NoDirection(End),
    #[error("there is no room in the movement space beyond the {0} point")]
    NoRoom(End),
    #[error(
        "there is no orientation {}: point {} has orientations {} to {}",
        Index(*orientation), Index(*point), Index(0), Index(*last)
    )]
    NoOrientation {
        orientation: usize,
        point: usize,
        last: usize,
    },
    #[error(
        "a new orientation must be put at {} to {}, not at {}",
        Index(0), Index(*last), Index(*at)
    )]
    NewOrientation { at: usize, last: usize },
    #[error("the last orientation of a point cannot be removed")]
    OneOrientationRemains,
    #[error(
        "point {} must not lie on the target of its orientation {}",
        Index(*point),
        Index(*orientation)
    )]
    OnTarget { point: usize, orientation: usize },
    #[error("a target in this direction would lie farther than 1e9 half edges of the space")]
    TargetTooFar,
    #[error("this scene has no camera on a path")]
    NoCamera,
    #[error("no path is edited: choose a node that follows one")]
    NoPathEdited,
    #[error("node \"{0}\" follows no path")]
    NoPathOf(Text),
    #[error("there is no property \"{name}\"; known here: {known}")]
    NoProperty { name: Text, known: Text },
    #[error("the property \"{0}\" cannot be set so; it is: {1}")]
    NotOfKind(&'static str, Kind),
    #[error("there is no scene, only a path")]
    NoScene,
    #[error("this path has no file yet")]
    NoFile,
    #[error("another program has changed the file since it was read or written here")]
    FileChanged,
    #[error("{0} lies outside the folder of the file that names it and was not read")]
    Outside(Text),
    #[error("this would overwrite {0}, which was read: name another output")]
    Input(Text),
}

impl Refused {
    fn kind(&self) -> ErrorKind {
        match self {
            Self::NoEnds
            | Self::NoDirection(_)
            | Self::OnTarget { .. }
            | Self::NoCamera
            | Self::NoPathEdited
            | Self::NotOfKind(..)
            | Self::NoPathOf(_)
            | Self::NoScene
            | Self::NoFile
            | Self::FileChanged
            | Self::Outside(_)
            | Self::Input(_) => ErrorKind::Argument,
            _ => ErrorKind::Range,
        }
    }
}

/// An end of an open path.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum End {
    First,
    Last,
}

impl fmt::Display for End {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::First => "first",
            Self::Last => "last",
        })
    }
}

/// What is invalid in a file.
#[derive(Debug, thiserror::Error)]
#[allow(missing_docs)]
pub enum Malformed {
    /// In the words of the TOML parser.
    #[error("{0}")]
    Toml(Text),
    #[error(transparent)]
    Engine(#[from] EngineError),
    #[error("this is not UTF-8 text")]
    NotUtf8,
    #[error("a .vid file begins with version = 1")]
    NoVersion,
    #[error("there is no such version")]
    NoSuchVersion,
    #[error(
        "this file is of version {version}, newer than this program, which knows up to version {known}"
    )]
    NewerVersion { version: i64, known: i64 },
    #[error("unknown key \"{key}\"; known here: {known}")]
    UnknownKey { key: Text, known: Text },
    #[error("expected {wanted}, found {found}")]
    Expected { wanted: Value, found: Value },
    #[error("expected {wanted} numbers, found {found}")]
    NumberCount { wanted: usize, found: usize },
    #[error("expected {wanted} quaternions, found {found}")]
    QuaternionCount { wanted: usize, found: usize },
    #[error("the number must be finite")]
    NotFinite,
    #[error("the number is too large")]
    TooLarge,
    #[error("must lie between {low} and {high}")]
    Between { low: i64, high: i64 },
    #[error("must be {}", one_of(.0, "or"))]
    OneOf(&'static [&'static str]),
    #[error("both {0} and {1} must be given")]
    Both(&'static str, &'static str),

    #[error("a space is given by centre and half_size, and all numbers are the world's")]
    Space,
    #[error("this must stand before the first point or node")]
    BehindPoints,

    // Paths.
    #[error("the presets are numbered 0 to 9")]
    PresetNumber,
    #[error("a path needs at least two points, each with its [[point]], found {0}")]
    TooFewPoints(usize),
    #[error("this point has no position")]
    NoPosition,
    #[error("a point has either a preset or its own values")]
    PresetAndOwn,
    #[error("an orientation has either a target or an offset")]
    TargetAndOffset,
    #[error("an orientation has either an ease, a distance or a part of a pace")]
    PaceTwice,
    #[error("an orientation has one of up, up_point and up_path")]
    UpTwice,
    #[error("this up path has not been given further up")]
    NoUpPath,
    #[error("a part is one of one whole")]
    PartTwice,
    #[error("a part needs its whole: speed_curve, ease, distance or track")]
    PartWithoutWhole,
    #[error("only ten speeds have slopes at their ends")]
    NoSlopes,

    // Scenes.
    #[error("this is a scene with {0} nodes, not a path alone")]
    Scene(usize),
    #[error("in a scene \"{0}\" belongs to the path of a node")]
    KeyOfPath(&'static str),
    #[error("a marker has a name and a frame")]
    Marker,
    #[error("there is a marker \"{0}\" already")]
    MarkerTwice(Text),
    #[error("this node has no name")]
    NoName,
    #[error("this node has no kind")]
    NoKind,
    #[error("a {0} has none")]
    NotOfKind(&'static str),
    #[error("here are rows of numbers before")]
    RowsBefore,
    #[error("here are single numbers before")]
    NumbersBefore,
    #[error("{keys} keys need as many values, not {values}")]
    ValueCount { keys: usize, values: usize },
    #[error("this deformation has no kind")]
    NoDeformationKind,
    #[error("a checksum has up to 16 digits 0 to 9, a to f")]
    Checksum,
    #[error(
        "a mesh has points of its own, or a file: alone, or with both its bytes and its checksum, \
         and the number of its part where it has parts"
    )]
    MeshFile,
    #[error("an object has either polylines or a mesh of its own")]
    PolylinesAndMesh,
    #[error("a pin has a point and a marker")]
    Pin,
    #[error("a track has a channel, an interpolation, frames and values")]
    Track,

    // The setup of the window.
    #[error("this is version {version} of the setup; version {known} is understood here")]
    SetupVersion { version: i64, known: i64 },
    #[error(
        "out of range: the tilt lies in [-90, 90], the size in [{least}, {most}], the shift in [-4, 4]"
    )]
    View { least: f64, most: f64 },
    #[error("a colour is written as \"#\" and six digits 0 to 9, a to f")]
    Colour,
}

/// Converts a cause of the engine's directly.
macro_rules! of_engine {
    ($($cause:ty => $error:ty),*) => {$(
        impl From<$cause> for $error {
            fn from(cause: $cause) -> Self {
                EngineError::from(cause).into()
            }
        }
    )*};
}
of_engine!(Invalid => Error, OutOfRange => Error, TooMany => Error, TooMany => Malformed);

/// `"a", "b" or "c"`.
#[doc(hidden)]
#[must_use]
pub fn one_of(names: &[&str], or: &str) -> String {
    let (last, others) = names.split_last().expect("there is something to choose");
    format!("\"{}\" {or} \"{last}\"", others.join("\", \""))
}

/// The type of a value in a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum Value {
    Number,
    WholeNumber,
    DecimalNumber,
    Text,
    TextInQuotes,
    Boolean,
    DateOrTime,
    Array,
    Table,
}

impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Number => "a number",
            Self::WholeNumber => "a whole number",
            Self::DecimalNumber => "a decimal number",
            Self::Text => "a text",
            Self::TextInQuotes => "a text in quotes",
            Self::Boolean => "true or false",
            Self::DateOrTime => "a date or time",
            Self::Array => "an array",
            Self::Table => "a table",
        })
    }
}
