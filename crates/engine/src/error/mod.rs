//! One error type for the whole library. Each message is one sentence that
//! names the place and the reason, fit to be shown to a person as it stands.

mod messages;

use std::fmt;

#[doc(hidden)]
pub use messages::{Kind, fill, sentence};
pub use messages::{Message, Part};

/// A [`Message`] that can reach a person in a window: a sentence, and the values
/// for its places `{0}`, `{1}` …. Each of these sentences stands in every
/// language among the window's texts, which a test holds.
#[doc(hidden)]
#[macro_export]
macro_rules! message {
    ($sentence:literal) => {
        $crate::error::Message::from($sentence)
    };
    ($sentence:literal, $($value:expr),+ $(,)?) => {
        $crate::error::Message::with($sentence, [$($crate::error::Part::from($value)),+])
    };
}
#[doc(hidden)]
pub use crate::message;

/// What can go wrong. The variants are those of the C interface's statuses.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// An argument that makes no sense whatever its size: not finite, a
    /// target on its own point, a view without direction.
    #[error("{0}")]
    Argument(Message),
    /// An index or a value outside its range.
    #[error("{0}")]
    Range(Message),
    /// More of something than [`crate::limits`] allows.
    #[error("{0}")]
    Limit(Message),
    /// There was no memory left; nothing was changed.
    #[error("out of memory")]
    Memory,
    /// The operating system refused to read or write a file.
    #[error("{place}: {}", reason(source))]
    Io {
        /// The file, as the caller named it.
        place: String,
        /// What the operating system said.
        source: std::io::Error,
    },
    /// A file's contents are not what they should be; the text names the
    /// line and the reason.
    #[error("{0}")]
    Format(Message),
    /// No window can be opened, or its X server went away.
    #[error("{0}")]
    Display(Message),
}

/// The result of everything that can fail.
pub type Result<T, E = Error> = std::result::Result<T, E>;

impl Error {
    /// The same error with the place where it happened put before it.
    #[must_use]
    pub fn at(self, place: impl Into<Part>) -> Self {
        let put = |message: Message| message!("{0}: {1}", place.into(), message);
        match self {
            Self::Argument(message) => Self::Argument(put(message)),
            Self::Range(message) => Self::Range(put(message)),
            Self::Limit(message) => Self::Limit(put(message)),
            Self::Format(message) => Self::Format(put(message)),
            Self::Display(message) => Self::Display(put(message)),
            Self::Memory | Self::Io { .. } => self,
        }
    }

    /// What it says.
    #[doc(hidden)]
    pub fn into_message(self) -> Message {
        match self {
            Self::Argument(message)
            | Self::Range(message)
            | Self::Limit(message)
            | Self::Format(message)
            | Self::Display(message) => message,
            Self::Memory => message!("out of memory"),
            Self::Io { place, source } => message!("{0}: {1}", place, reason(&source)),
        }
    }
}

/// What the operating system said, without Rust's number behind it
/// ("(os error 2)"), which tells a person nothing.
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

/// Room for the longest message of the border with what stands around it.
const LINE_BYTES: usize = 2048;

/// Says a sentence on standard error: one line, in one piece, so that nobody
/// else's text comes between. What is too long is cut.
#[doc(hidden)]
pub fn complain(sentence: impl fmt::Display) {
    use std::io::Write as _;
    let mut line = [0; LINE_BYTES];
    let length = {
        let mut rest = &mut line[..LINE_BYTES - 1];
        // Cut where it does not fit; no allocation.
        let _ = write!(rest, "vides: {sentence}");
        LINE_BYTES - 1 - rest.len()
    };
    for byte in &mut line[..length] {
        if byte.is_ascii_control() {
            *byte = b' ';
        }
    }
    line[length] = b'\n';
    // Nothing is left to be done where standard error is closed.
    let _ = std::io::stderr().write_all(&line[..=length]);
}

/// What a panic said.
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

/// An empty vector with room for `capacity` elements, or [`Error::Memory`].
/// Everything between a host's call and its list of poses allocates through
/// this, so that running out of memory is a status and not an abort.
#[doc(hidden)]
pub fn vec_with_room<T>(capacity: usize) -> Result<Vec<T>> {
    let mut vec = Vec::new();
    vec.try_reserve_exact(capacity)?;
    Ok(vec)
}

/// Sees that so many bytes can be had just now: asks for them and gives them
/// back. For what follows and cannot be told to give up, as parts of the standard
/// library; nobody but another thread comes in between.
#[doc(hidden)]
pub fn can_allocate(bytes: usize) -> Result<()> {
    // Shown to the compiler as used: else it leaves the question out.
    std::hint::black_box(vec_with_room::<u8>(bytes)?);
    Ok(())
}

/// `value` on the heap, or [`Error::Memory`].
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
        let error = Error::Io {
            place: "a.vid".to_owned(),
            source: missing,
        };
        assert_eq!(error.to_string(), "a.vid: No such file or directory");
    }
}
