//! Errors of the engine: each is one English sentence that can be shown to a user.

mod causes;
mod counting;
mod range;
mod text;

use std::fmt;
use std::sync::Arc;

pub use causes::{Invalid, TooMany};
pub use counting::{Called, Entry, FromZero, Index};
pub use range::{Bound, OutOfRange, Quantity};
pub use text::{List, Text};

/// What can go wrong in the engine.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Error {
    /// An argument that makes no sense whatever its size: not finite, a target on its own point.
    #[error(transparent)]
    Argument(#[from] Invalid),
    /// An index or a value outside its range.
    #[error(transparent)]
    Range(#[from] OutOfRange),
    /// More of something than [`crate::limits`] allows.
    #[error(transparent)]
    Limit(#[from] TooMany),
    /// There was no memory left; nothing was changed.
    #[error("out of memory")]
    Memory,
    /// One of these at a place.
    #[error("{0}: {1}")]
    At(Place, Cause<Error>),
}

/// The result of everything that can fail.
pub type Result<T, E = Error> = std::result::Result<T, E>;

/// The kind of an error. The statuses of the C interface are these.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ErrorKind {
    /// An argument that makes no sense whatever its size.
    Argument,
    /// An index or a value outside its range.
    Range,
    /// More of something than [`crate::limits`] allows.
    Limit,
    /// There was no memory left; nothing was changed.
    Memory,
    /// The operating system refused to read or write a file.
    Io,
    /// A file's contents are not what they should be.
    Format,
    /// No window can be opened, or its X server went away.
    Display,
}

/// Where something is wrong. Numbers count from 0; sentences say them as [`Index`] does.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[allow(missing_docs)]
pub enum Place {
    #[error("point {}", Index(*.0))]
    Point(usize),
    #[error("orientation {}", Index(*.0))]
    Orientation(usize),
    #[error("object point {}", Index(*.0))]
    ObjectPoint(usize),
    #[error("node \"{0}\"")]
    Node(Text),
    #[error("channel \"{0}\"")]
    Channel(Text),
    #[error("key {}", Index(*.0))]
    Key(usize),
    #[error("marker")]
    Marker,
    #[error("parent")]
    Parent,
    #[error("aim")]
    Aim,
    #[error("the name")]
    Name,
    #[error("the title")]
    Title,
    #[error("the unit")]
    Unit,
    #[error("the position")]
    Position,
    #[error("the scale")]
    Scale,
    #[error("the pivot")]
    Pivot,
    #[error("the step")]
    Step,
    #[error("the tangents")]
    Tangents,
    #[error("pose {}", Index(*.0))]
    Pose(usize),
}

impl Error {
    /// The same error with the place where it happened put before it.
    #[must_use]
    pub fn at(self, place: Place) -> Self {
        if self == Self::Memory {
            return self;
        }
        Cause::new(self).map_or_else(|same| same, |cause| Self::At(place, cause))
    }

    /// The kind of its cause.
    #[must_use]
    pub fn kind(&self) -> ErrorKind {
        match self {
            Self::Argument(_) => ErrorKind::Argument,
            Self::Range(_) => ErrorKind::Range,
            Self::Limit(_) => ErrorKind::Limit,
            Self::Memory => ErrorKind::Memory,
            Self::At(_, cause) => cause.kind(),
        }
    }

    /// The error itself, without its places.
    #[must_use]
    pub fn cause(&self) -> &Self {
        match self {
            Self::At(_, cause) => cause.cause(),
            _ => self,
        }
    }
}

/// An error behind the place where it happened.
#[derive(Clone, Debug, PartialEq)]
pub struct Cause<E>(Box<[E]>);

impl<E> Cause<E> {
    /// Gives the error back where there is no memory to keep it.
    #[doc(hidden)]
    pub fn new(error: E) -> Result<Self, E> {
        match vec_with_room(1) {
            Ok(mut room) => {
                room.push(error);
                Ok(Self(room.into_boxed_slice()))
            }
            Err(_) => Err(error),
        }
    }
}

impl<E> std::ops::Deref for Cause<E> {
    type Target = E;

    fn deref(&self) -> &E {
        &self.0[0]
    }
}

impl<E: fmt::Display> fmt::Display for Cause<E> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        (**self).fmt(f)
    }
}

/// What the operating system said, without Rust's "(os error 2)", which tells a person nothing.
#[must_use]
pub fn reason(error: &std::io::Error) -> String {
    let mut words = error.to_string();
    if let Some(code) = error.raw_os_error()
        && let Some(said) = words.strip_suffix(&format!(" (os error {code})"))
    {
        words.truncate(said.len());
    }
    words
}

/// Room for the longest message of the C border.
const LINE_BYTES: usize = 2048;

/// Writes one line to standard error, cut to fit, in one piece so that no other text comes between.
#[doc(hidden)]
pub fn complain(sentence: impl fmt::Display) {
    use std::io::Write as _;
    let mut line = [0; LINE_BYTES];
    let length = {
        let mut rest = &mut line[..LINE_BYTES - 1];
        let _ = write!(rest, "vides: {sentence}");
        LINE_BYTES - 1 - rest.len()
    };
    for byte in &mut line[..length] {
        if byte.is_ascii_control() {
            *byte = b' ';
        }
    }
    line[length] = b'\n';
    // Standard error may be closed.
    let _ = std::io::stderr().write_all(&line[..=length]);
}

/// The message of a panic.
#[doc(hidden)]
#[must_use]
pub fn panic_said(panic: &(dyn std::any::Any + Send)) -> &str {
    panic
        .downcast_ref::<String>()
        .map(String::as_str)
        .or_else(|| panic.downcast_ref::<&str>().copied())
        .unwrap_or("no more is known")
}

impl From<std::collections::TryReserveError> for Error {
    fn from(_: std::collections::TryReserveError) -> Self {
        Self::Memory
    }
}

/// An empty vector with room for `capacity` elements, or [`Error::Memory`]. All between a host's
/// call and its poses is allocated through this, so that running out of memory does not abort.
#[doc(hidden)]
pub fn vec_with_room<T>(capacity: usize) -> Result<Vec<T>> {
    let mut vec = Vec::new();
    vec.try_reserve_exact(capacity)?;
    Ok(vec)
}

/// Checks that this many bytes can be allocated, before code that would abort without them, as std
/// may.
#[doc(hidden)]
pub fn can_allocate(bytes: usize) -> Result<()> {
    // The compiler would leave out an allocation that is not used.
    std::hint::black_box(vec_with_room::<u8>(bytes)?);
    Ok(())
}

/// `value` behind a counted pointer, which std cannot refuse where memory has run out.
#[doc(hidden)]
pub fn try_arc<T>(value: T) -> Result<Arc<T>> {
    can_allocate(size_of::<T>() + 2 * size_of::<usize>())?;
    Ok(Arc::new(value))
}

/// `value` on the heap as a slice of one, or [`Error::Memory`].
#[doc(hidden)]
pub fn try_box<T>(value: T) -> Result<Box<[T]>> {
    let mut vec = vec_with_room(1)?;
    vec.push(value);
    Ok(vec.into_boxed_slice())
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io;

    #[test]
    fn the_systems_number_is_left_out() {
        let missing = io::Error::from_raw_os_error(2);
        assert_eq!(reason(&missing), "No such file or directory");
        let ours = io::Error::other("no (os error 2) of the system's");
        assert_eq!(reason(&ours), "no (os error 2) of the system's");
    }
}
