//! Statuses, versions and the calling thread's last error message.

use std::cell::UnsafeCell;
use std::collections::TryReserveError;
use std::ffi::{c_char, c_int, c_ulong};
use std::fmt::{self, Write as _};
use std::ops::Range;
use std::thread::LocalKey;

use crate::error::{
    Bound, EngineError, ErrorKind, FromZero, Index, Invalid, OutOfRange, Refused, Text, TooMany,
};
use crate::formats;
use crate::instance::Error;

/// ==== Version of this header ====
///
/// v_version() returns the version of the library in use.
#[allow(dead_code)] // only the host reads these three
pub const V_VERSION_MAJOR: c_int = 1;
#[allow(dead_code)]
pub const V_VERSION_MINOR: c_int = 0;
#[allow(dead_code)]
pub const V_VERSION_PATCH: c_int = 0;

/// ==== Statuses ====
///
/// v_strerror() describes a status; v_last_error() returns what was wrong in the call.
///
/// V_OK            done
/// V_ERR_NULL      a pointer that must not be NULL is NULL
/// V_ERR_HANDLE    not a valid handle: freed, of another kind, never made, or a window of
///                 another thread
/// V_ERR_ARGUMENT  a value is not valid: not finite, a target on the camera, an up vector
///                 along the view, a text that is not UTF-8, a misaligned pointer
/// V_ERR_RANGE     an index or a value is out of range, or NaN where a range applies
/// V_ERR_SIZE      an array is too small, or the size of a struct is not set
/// V_ERR_LIMIT     more points, orientations, poses or bytes than the library allows
/// V_ERR_MEMORY    out of memory; nothing was changed
/// V_ERR_IO        the operating system refused to read or write a file
/// V_ERR_FORMAT    the contents of a file are not valid; v_last_error() names the place
/// V_ERR_DISPLAY   no window can be opened, or its X server went away
/// V_ERR_BUSY      not possible now, for example within this callback
/// V_ERR_CLOSED    the window is gone (V_GONE_...), or its thread has ended
/// V_ERR_INTERNAL  a fault of the library; the path or scene concerned may be unusable
///                 from now on, everything else works
/// V_ERR_REFUSED   the user or a callback refused
pub const V_OK: c_int = 0;
pub const V_ERR_NULL: c_int = 1;
pub const V_ERR_HANDLE: c_int = 2;
pub const V_ERR_ARGUMENT: c_int = 3;
pub const V_ERR_RANGE: c_int = 4;
pub const V_ERR_SIZE: c_int = 5;
pub const V_ERR_LIMIT: c_int = 6;
pub const V_ERR_MEMORY: c_int = 7;
pub const V_ERR_IO: c_int = 8;
pub const V_ERR_FORMAT: c_int = 9;
pub const V_ERR_DISPLAY: c_int = 10;
pub const V_ERR_BUSY: c_int = 11;
pub const V_ERR_CLOSED: c_int = 12;
pub const V_ERR_INTERNAL: c_int = 13;
pub const V_ERR_REFUSED: c_int = 14;

/// What is wrong, as the header names it.
#[derive(Clone, Copy, Debug, thiserror::Error)]
pub(super) enum Name {
    #[error("{0}")]
    Parameter(&'static str),
    #[error("{0}->{1}")]
    Field(&'static str, &'static str),
    #[error("{0}[{1}]")]
    Element(&'static str, usize),
}

impl From<&'static str> for Name {
    fn from(name: &'static str) -> Self {
        Self::Parameter(name)
    }
}

/// Why a call from C failed.
#[derive(Debug, thiserror::Error)]
pub(super) enum Failure {
    /// An error detected in the interface itself: its status and sentence.
    #[error("{1}")]
    Border(c_int, &'static str),
    /// An error of the library.
    #[error(transparent)]
    Library(#[from] Error),
    /// An error in a file of another program.
    #[error(transparent)]
    Format(#[from] formats::Error),
    #[error("{0} is NULL")]
    Null(Name),
    #[error("{0} is not a valid handle: freed, of another kind, or never made")]
    Handle(Name),
    #[error("{0} is not aligned for what it points to")]
    Unaligned(Name),
    #[error("{0} is not UTF-8")]
    NotUtf8(&'static str),
    #[error("{name} is {size}, but sizeof ({of}) is {wanted}")]
    Size {
        name: Name,
        size: usize,
        of: &'static str,
        wanted: usize,
    },
    #[error("{name} has room for {room}, but {needed} are needed")]
    NoRoom {
        name: &'static str,
        room: usize,
        needed: usize,
    },
    #[error("{name} is {given}, but counting starts at 0")]
    NegativeIndex { name: &'static str, given: c_int },
    #[error("{name} is {given}, but must be at least 0")]
    NegativeCount { name: &'static str, given: c_int },
    #[error("{name} cannot have {count} elements")]
    NoSuchCount { name: Name, count: usize },
    #[error("{name} is {given}; known: {known}")]
    Unknown {
        name: Name,
        given: c_int,
        known: &'static str,
    },
    #[error("options->language is \"{0}\"; known: de, en")]
    NoLanguage(Text),
    #[error("{name} is {given}, but the number of an X window has at most 32 bits")]
    NoWindow { name: &'static str, given: c_ulong },
    #[error("there is no tool \"{0}\" for a path")]
    NoTool(Text),
    #[error("there are no \"{0}\"; known: nodes, markers, pins, tracks, shapes, deformations")]
    NoKind(Text),
    #[error("the last tool reported no number \"{0}\"")]
    NoNumber(Text),
    /// An error of a property, which counts as its name does.
    #[error("{1}")]
    Property(c_int, Text),
    #[error("there is no {what} {at} among {count}, counted from 0")]
    NoEntry {
        what: &'static str,
        at: usize,
        count: usize,
    },
    #[error("there is no section {} among {count}", Index(*at))]
    NoSection { at: usize, count: usize },
    #[error("there are no {count} poses from number {first} on: the path has poses 1 to {frames}")]
    NoPoses {
        count: usize,
        first: usize,
        frames: usize,
    },
    #[error("{name} is {}, but frames go from 1 to {frames}", Bound(*given))]
    NoFrame {
        name: Name,
        given: f64,
        frames: usize,
    },
    #[error("{name} is {}, but must be a finite number", Bound(*given))]
    NotFinite { name: &'static str, given: f64 },
    #[error("{0} must be finite and not zero")]
    Zero(&'static str),
    #[error("{name} is {}, but must be between {from} and {end}", Bound(*given))]
    NotBetween {
        name: &'static str,
        given: f64,
        from: f64,
        end: f64,
    },
    #[error("{name} is {}, but must be finite and greater than 0", Bound(*given))]
    NotPositive { name: &'static str, given: f64 },
    #[error("{name} is {given}, but must be a multiple of {of}")]
    NotMultiple { name: Name, given: usize, of: usize },
    #[error("{name} is {given}, but at most {limit} are allowed")]
    TooMany {
        name: Name,
        given: usize,
        limit: usize,
    },
}

pub(super) type Answer<T> = Result<T, Failure>;

impl Failure {
    /// A value outside its range.
    pub(super) const fn range(sentence: &'static str) -> Self {
        Self::Border(V_ERR_RANGE, sentence)
    }

    /// An unknown number of an enum.
    pub(super) fn unknown(name: impl Into<Name>, given: c_int, known: &'static str) -> Self {
        Self::Unknown {
            name: name.into(),
            given,
            known,
        }
    }

    /// A value that is not valid.
    pub(super) const fn argument(sentence: &'static str) -> Self {
        Self::Border(V_ERR_ARGUMENT, sentence)
    }

    /// An error of a property: its sentence is made here, where counting starts at 1.
    pub(super) fn of_property(error: crate::document::Error) -> Self {
        match error.kind() {
            ErrorKind::Memory => error.into(),
            kind => Self::Property(status_of(kind), (&error).into()),
        }
    }

    pub(super) fn status(&self) -> c_int {
        match self {
            Self::Border(status, _) | Self::Property(status, _) => *status,
            Self::Library(error) => status_of(error.kind()),
            Self::Format(error) => status_of(error.kind()),
            Self::Null(_) => V_ERR_NULL,
            Self::Handle(_) => V_ERR_HANDLE,
            Self::Unaligned(_)
            | Self::NotUtf8(_)
            | Self::NoLanguage(_)
            | Self::NotFinite { .. }
            | Self::Zero(_)
            | Self::NoTool(_)
            | Self::NoNumber(_)
            | Self::NoKind(_)
            | Self::NotPositive { .. } => V_ERR_ARGUMENT,
            Self::Size { .. } | Self::NoRoom { .. } => V_ERR_SIZE,
            Self::TooMany { .. } => V_ERR_LIMIT,
            Self::NegativeIndex { .. }
            | Self::NegativeCount { .. }
            | Self::NoSuchCount { .. }
            | Self::NotMultiple { .. }
            | Self::Unknown { .. }
            | Self::NoWindow { .. }
            | Self::NoEntry { .. }
            | Self::NoSection { .. }
            | Self::NoPoses { .. }
            | Self::NoFrame { .. }
            | Self::NotBetween { .. } => V_ERR_RANGE,
        }
    }

    /// The same error with another name of the handle.
    pub(super) fn named(self, name: impl Into<Name>) -> Self {
        match self {
            Self::Null(_) => Self::Null(name.into()),
            Self::Handle(_) => Self::Handle(name.into()),
            other => other,
        }
    }
}

const fn status_of(kind: ErrorKind) -> c_int {
    match kind {
        ErrorKind::Argument => V_ERR_ARGUMENT,
        ErrorKind::Range => V_ERR_RANGE,
        ErrorKind::Limit => V_ERR_LIMIT,
        ErrorKind::Memory => V_ERR_MEMORY,
        ErrorKind::Io => V_ERR_IO,
        ErrorKind::Format => V_ERR_FORMAT,
        ErrorKind::Display => V_ERR_DISPLAY,
    }
}

/// Errors of the crates that this one uses.
macro_rules! library {
    ($($error:ty),*) => {$(
        impl From<$error> for Failure {
            fn from(error: $error) -> Self {
                Self::Library(crate::error::Error::from(error).into())
            }
        }
    )*};
}
library!(
    crate::Error,
    EngineError,
    Invalid,
    OutOfRange,
    Refused,
    TooMany,
    TryReserveError
);

/// Room for a sentence with a long file name, kept small, since every thread has one.
/// Longer sentences lose their middle: the beginning and end of a file name and the
/// reason after it are more useful.
const MESSAGE_BYTES: usize = 1024;

/// Replaces what was left out.
const LEFT_OUT: &str = "…";

/// A thread's last message, zero-terminated. Needs no destructor and no allocation, so it works
/// while a thread ends and when memory has run out.
struct Message {
    used: usize,
    text: [u8; MESSAGE_BYTES],
}

impl Message {
    const fn new() -> Self {
        Self {
            used: 0,
            text: [0; MESSAGE_BYTES],
        }
    }

    fn clear(&mut self) {
        self.used = 0;
        self.text[0] = 0;
    }

    /// Replaces the message.
    fn set(&mut self, sentence: fmt::Arguments<'_>) {
        self.clear();
        self.add(sentence);
    }

    /// Appends a sentence, shortened in the middle to the room left. Indices count from
    /// 0, as in C.
    fn add(&mut self, sentence: fmt::Arguments<'_>) {
        let sentence = format_args!("{}", FromZero(sentence));
        let room = MESSAGE_BYTES - 1 - self.used;
        let mut whole = Length(0);
        let _ = whole.write_fmt(sentence);
        let mut part = Part {
            message: self,
            seen: 0,
            gap: 0..0,
        };
        if whole.0 > room {
            let side = room.saturating_sub(LEFT_OUT.len()) / 2;
            part.gap = side..whole.0 - side;
        }
        // Fails only if a value formats longer the second time.
        let _ = part.write_fmt(sentence);
    }

    /// Appends a text if it fits whole.
    fn push(&mut self, text: &str) -> fmt::Result {
        let end = self.used + text.len();
        if end >= MESSAGE_BYTES {
            return Err(fmt::Error);
        }
        // A zero byte inside would end the text for C.
        for (place, &byte) in self.text[self.used..end].iter_mut().zip(text.as_bytes()) {
            *place = if byte == 0 { b' ' } else { byte };
        }
        self.used = end;
        self.text[end] = 0;
        Ok(())
    }
}

/// Counts the bytes written.
struct Length(usize);

impl fmt::Write for Length {
    fn write_str(&mut self, s: &str) -> fmt::Result {
        self.0 += s.len();
        Ok(())
    }
}

/// Appends what lies outside a gap in the text.
struct Part<'a> {
    message: &'a mut Message,
    seen: usize,
    gap: Range<usize>,
}

impl fmt::Write for Part<'_> {
    fn write_str(&mut self, s: &str) -> fmt::Result {
        let mut character = [0; 4];
        for c in s.chars() {
            let text = c.encode_utf8(&mut character);
            let place = self.seen..self.seen + text.len();
            self.seen = place.end;
            if place.end <= self.gap.start || place.start >= self.gap.end {
                self.message.push(text)?;
            } else if place.start <= self.gap.start {
                self.message.push(LEFT_OUT)?;
            }
        }
        Ok(())
    }
}

thread_local! {
    static LAST: UnsafeCell<Message> = const { UnsafeCell::new(Message::new()) };
    static WARNING: UnsafeCell<Message> = const { UnsafeCell::new(Message::new()) };
}

fn with_message<R>(change: impl FnOnce(&mut Message) -> R) -> R {
    with(&LAST, change)
}

fn with<R>(
    which: &'static LocalKey<UnsafeCell<Message>>,
    change: impl FnOnce(&mut Message) -> R,
) -> R {
    which.with(|message| {
        // SAFETY: the cell belongs to this thread, and no closure in this file keeps the reference
        // or comes back here.
        change(unsafe { &mut *message.get() })
    })
}

pub(super) fn clear_last_error() {
    with_message(Message::clear);
}

pub(super) fn set_last_error(sentence: fmt::Arguments<'_>) {
    // Formatting before the borrow would need memory; the values formatted here do not re-enter
    // this module.
    with_message(|message| message.set(sentence));
}

/// Every function that can warn calls this first.
pub(super) fn clear_last_warning() {
    with(&WARNING, Message::clear);
}

/// Appends a sentence to the last warning.
pub(super) fn add_last_warning(sentence: fmt::Arguments<'_>) {
    with(&WARNING, |message| {
        if message.used > 0 {
            message.add(format_args!(" "));
        }
        message.add(sentence);
    });
}

/// Appends to the last message, or sets it.
pub(super) fn add_last_error(sentence: fmt::Arguments<'_>) {
    with_message(|message| {
        if message.used > 0 {
            message.add(format_args!("; {sentence}"));
        } else {
            message.set(sentence);
        }
    });
}

/// Passes the last message on as bytes, for standard error.
pub(super) fn with_last_error(show: impl FnOnce(&[u8])) {
    with_message(|message| show(&message.text[..message.used]));
}

/// ==== Errors: why a call failed, and what it reports ====
///
/// Returns why the calling thread's last call failed: one sentence in English, at
/// most 1023 bytes, "" after a success. It names parameters (path, options->title)
/// and counts as this header does. Valid until the same thread's next call of any
/// function except this one, v_last_warning(), v_strerror() and v_version().
#[unsafe(no_mangle)]
pub extern "C" fn v_last_error() -> *const c_char {
    with_message(|message| message.text.as_ptr().cast())
}

/// Returns the warnings of the calling thread's last call of a function whose comment
/// mentions them: sentences in English, at most 1023 bytes, or "". Valid until the
/// same thread's next call of such a function.
#[unsafe(no_mangle)]
pub extern "C" fn v_last_warning() -> *const c_char {
    with(&WARNING, |message| message.text.as_ptr().cast())
}

/// Returns the meaning of a status, in English.
#[unsafe(no_mangle)]
pub extern "C" fn v_strerror(status: c_int) -> *const c_char {
    match status {
        V_OK => c"no error",
        V_ERR_NULL => c"a pointer that must not be NULL is NULL",
        V_ERR_HANDLE => c"not a valid handle",
        V_ERR_ARGUMENT => c"an argument is not valid",
        V_ERR_RANGE => c"an index or a value is out of range",
        V_ERR_SIZE => c"an array is too small or a struct's size is not set",
        V_ERR_LIMIT => c"a limit of the library is exceeded",
        V_ERR_MEMORY => c"out of memory",
        V_ERR_IO => c"a file could not be read or written",
        V_ERR_FORMAT => c"the contents of a file are not valid",
        V_ERR_DISPLAY => c"no connection to an X server",
        V_ERR_BUSY => c"not possible at this moment",
        V_ERR_CLOSED => c"the window has been closed",
        V_ERR_INTERNAL => c"a fault inside the library",
        V_ERR_REFUSED => c"the user or a callback refused",
        _ => c"not a status of this library",
    }
    .as_ptr()
}

/// Returns the version of the library in use, as "1.0.0".
#[unsafe(no_mangle)]
pub extern "C" fn v_version() -> *const c_char {
    concat!(env!("CARGO_PKG_VERSION"), "\0").as_ptr().cast()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::ffi::CStr;

    fn last() -> String {
        // SAFETY: v_last_error always gives a zero-terminated text.
        let text = unsafe { CStr::from_ptr(v_last_error()) };
        text.to_str().expect("valid UTF-8").to_owned()
    }

    #[test]
    fn the_header_has_the_version_of_the_package() {
        let header = format!("{V_VERSION_MAJOR}.{V_VERSION_MINOR}.{V_VERSION_PATCH}");
        assert_eq!(header, env!("CARGO_PKG_VERSION"));
    }

    #[test]
    fn of_a_long_message_the_middle_is_left_out() {
        // Miri is slow and tries only some of the lengths.
        let step = if cfg!(miri) { 401 } else { 1 };
        for length in (0..4 * MESSAGE_BYTES).step_by(step) {
            let long = format!(
                "{}€{}: why",
                "a/".repeat(length / 3),
                "é".repeat(length / 2)
            );
            set_last_error(format_args!("{long}{}", '!'));
            let kept = last();
            if long.len() + 1 < MESSAGE_BYTES {
                assert_eq!(kept, long + "!");
                continue;
            }
            assert!(kept.len() > MESSAGE_BYTES - 12 && kept.len() < MESSAGE_BYTES);
            let (head, tail) = kept.split_once(LEFT_OUT).expect("something left out");
            assert!(long.starts_with(head) && (long + "!").ends_with(tail));
            assert!(tail.ends_with(": why!"));
        }
    }

    #[test]
    fn a_sentence_is_put_behind_another() {
        clear_last_error();
        add_last_error(format_args!("one"));
        add_last_error(format_args!("two"));
        assert_eq!(last(), "one; two");
        for length in [900, MESSAGE_BYTES - 5, MESSAGE_BYTES - 1, 4 * MESSAGE_BYTES] {
            set_last_error(format_args!("{}", "x".repeat(length)));
            let before = last();
            add_last_error(format_args!("{}", "y".repeat(MESSAGE_BYTES)));
            assert!(last().starts_with(&before) && last().len() < MESSAGE_BYTES);
        }
    }

    #[test]
    fn a_message_has_no_zero_byte_and_can_be_cleared() {
        set_last_error(format_args!("a{}b", '\0'));
        assert_eq!(last(), "a b");
        clear_last_error();
        assert_eq!(last(), "");
    }

    #[test]
    fn what_fits_to_the_last_byte_is_kept_whole() {
        for (length, whole) in [(MESSAGE_BYTES - 1, true), (MESSAGE_BYTES, false)] {
            let sentence = "x".repeat(length);
            set_last_error(format_args!("{sentence}"));
            assert_eq!(last() == sentence, whole);
        }
    }
}
