use std::io;

pub(crate) use vides_document::error::EngineError;
use vides_document::error::{Error as DocumentError, ErrorKind, reason};
pub(crate) use vides_engine::error::{complain, panic_said};

/// An error of a window.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// An error of the document, or a lack of memory.
    #[error(transparent)]
    Document(#[from] DocumentError),
    /// There is no screen for the window, or it went away.
    #[error(transparent)]
    Screen(#[from] vides_x11::Error),
    /// The system has no descriptor left.
    #[error("no descriptor for the windows: {}", reason(.0))]
    NoDescriptor(io::Error),
    /// The window was lost, for this reason.
    #[error("{0}")]
    Lost(String),
}

/// The result of everything that can fail.
pub type Result<T, E = Error> = std::result::Result<T, E>;

impl Error {
    /// The kind of this error.
    #[must_use]
    pub fn kind(&self) -> ErrorKind {
        match self {
            Self::Document(error) => error.kind(),
            Self::Screen(error) => error.kind(),
            Self::NoDescriptor(_) => ErrorKind::Limit,
            Self::Lost(_) => ErrorKind::Display,
        }
    }
}

impl From<EngineError> for Error {
    fn from(error: EngineError) -> Self {
        DocumentError::from(error).into()
    }
}
