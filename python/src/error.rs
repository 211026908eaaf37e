//! Converts errors of the crates to `vides.Error`, whose sentences count points from 0.

use pyo3::exceptions::PyAttributeError;
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use vides::error::{EngineError, ErrorKind, FromZero, Invalid, OutOfRange, Refused};
use vides::{formats, window};

/// What will be raised as an exception.
#[derive(Debug)]
pub(crate) struct Failure {
    kind: &'static str,
    /// File, point, key, as far as known, the outermost first.
    place: Vec<String>,
    line: Option<usize>,
    sentence: String,
    /// There is no such name: an `AttributeError` in Python.
    no_attribute: bool,
    /// What there is none of: an `"index"` (also an `IndexError`) or a `"name"` (a `KeyError`).
    missing: Option<&'static str>,
    /// The system's error number.
    errno: Option<i32>,
}

/// Words in the library's sentences, and what they are called in Python.
const WORDS: [(&str, &str); 1] = [("name it, with format", "name it, with format=")];

pub(crate) type Result<T, E = Failure> = std::result::Result<T, E>;

const fn name(kind: ErrorKind) -> &'static str {
    match kind {
        ErrorKind::Argument => "argument",
        ErrorKind::Range => "range",
        ErrorKind::Limit => "limit",
        ErrorKind::Memory => "memory",
        ErrorKind::Io => "io",
        ErrorKind::Format => "format",
        ErrorKind::Display => "display",
    }
}

impl Failure {
    fn new(kind: ErrorKind, error: &dyn std::fmt::Display) -> Self {
        let sentence = FromZero(error).to_string();
        let in_python = |sentence: String, (command, python)| sentence.replace(command, python);
        Self {
            kind: name(kind),
            ..Self::argument(WORDS.into_iter().fold(sentence, in_python))
        }
    }

    /// An argument that is not valid.
    pub(crate) fn argument(sentence: impl Into<String>) -> Self {
        Self {
            kind: "argument",
            place: Vec::new(),
            line: None,
            sentence: sentence.into(),
            no_attribute: false,
            missing: None,
            errno: None,
        }
    }

    /// The window was lost.
    pub(crate) fn display(why: &str) -> Self {
        Self {
            kind: "display",
            ..Self::argument(why)
        }
    }

    /// For functions whose parameter `format=` has another name.
    pub(crate) fn with_format_as(mut self, name: &str) -> Self {
        self.sentence = self.sentence.replace(" format=", &format!(" {name}"));
        self
    }

    /// The path has only `last` frames, fewer than `count` from the first one.
    #[expect(clippy::cast_precision_loss)]
    pub(crate) fn frames(first: usize, count: usize, last: usize) -> Self {
        let end = first.saturating_add(count.saturating_sub(1));
        let frame = if (1..=last).contains(&first) {
            end
        } else {
            first
        };
        let (frame, last) = (frame as f64, last as f64);
        EngineError::from(OutOfRange::NoFrame {
            frame,
            first: 1.0,
            last,
        })
        .into()
    }

    fn engine(&mut self, error: &EngineError) {
        match error {
            EngineError::At(place, cause) => {
                self.place.push(bare(place));
                self.engine(cause);
            }
            EngineError::Range(OutOfRange::NoPoint { .. }) => self.missing = Some("index"),
            EngineError::Argument(Invalid::NoNodeNamed(_)) => self.missing = Some("name"),
            _ => {}
        }
    }

    fn document(&mut self, error: &vides::Error) {
        match error {
            vides::Error::Engine(error) => self.engine(error),
            vides::Error::Refused(Refused::NoProperty { .. }) => self.no_attribute = true,
            vides::Error::Refused(Refused::NoOrientation { .. }) => self.missing = Some("index"),
            vides::Error::Io { place, source } => {
                self.place.push(place.clone());
                self.errno = source.raw_os_error();
            }
            vides::Error::Format { line, key, .. } => {
                self.line = Some(*line);
                self.place.extend(key.0.iter().map(ToString::to_string));
            }
            vides::Error::PieceTooLarge(line) => self.line = Some(*line),
            vides::Error::Property { name, .. } => self.place.push(name.to_string()),
            vides::Error::At(place, cause) => {
                self.place.push(bare(place));
                self.document(cause);
            }
            vides::Error::In(file, cause) => {
                self.place.push(file.to_string());
                self.document(cause);
            }
            _ => {}
        }
    }

    fn formats(&mut self, error: &formats::Error) {
        match error {
            formats::Error::Document(error) => self.document(error),
            formats::Error::NoNode(_) => self.missing = Some("name"),
            formats::Error::Content { place, .. } => match place {
                formats::Place::Line(line) => self.line = Some(*line),
                formats::Place::Key(key) => self.place.push(key.to_string()),
                formats::Place::Byte(byte) => self.place.push(format!("byte {byte}")),
                formats::Place::Whole => {}
            },
            formats::Error::In(file, cause) => {
                self.place.push(file.to_string());
                self.formats(cause);
            }
            _ => {}
        }
    }
}

/// The place, without the note that it counts from 0.
fn bare(place: &impl std::fmt::Display) -> String {
    FromZero(place).to_string().replace(" (counted from 0)", "")
}

impl From<vides::Error> for Failure {
    fn from(error: vides::Error) -> Self {
        let mut failure = Self::new(error.kind(), &error);
        failure.document(&error);
        failure
    }
}

impl From<EngineError> for Failure {
    fn from(error: EngineError) -> Self {
        vides::Error::from(error).into()
    }
}

impl From<formats::Error> for Failure {
    fn from(error: formats::Error) -> Self {
        let mut failure = Self::new(error.kind(), &error);
        failure.formats(&error);
        failure
    }
}

impl From<window::Error> for Failure {
    fn from(error: window::Error) -> Self {
        match error {
            window::Error::Document(error) => error.into(),
            other => Self::new(other.kind(), &other),
        }
    }
}

impl From<Failure> for PyErr {
    fn from(failure: Failure) -> Self {
        static MAKE: PyOnceLock<Py<PyAny>> = PyOnceLock::new();
        Python::attach(|py| {
            if failure.no_attribute {
                return PyAttributeError::new_err(failure.sentence);
            }
            let place = (!failure.place.is_empty()).then(|| failure.place.join(": "));
            let (kind, errno) = (failure.kind, failure.errno);
            let given = (
                failure.sentence,
                kind,
                place,
                failure.line,
                errno,
                failure.missing,
            );
            let error = MAKE
                .import(py, "vides._error", "error_of")
                .and_then(|make| make.call1(given));
            error.map_or_else(|raised| raised, Self::from_value)
        })
    }
}
