//! Why a window could not be opened, or was lost.

pub(crate) use vides_engine::error::vec_with_room;
use vides_engine::error::{Error as EngineError, ErrorKind, Text};

/// Why a window could not be opened, or was lost.
#[derive(Clone, Debug, thiserror::Error)]
pub enum Error {
    /// Memory ran out.
    #[error(transparent)]
    Engine(#[from] EngineError),
    /// `DISPLAY` is not set.
    #[error("DISPLAY is not set: there is no X server for a window")]
    NoDisplay,
    /// `DISPLAY` is not UTF-8.
    #[error("DISPLAY is not the name of a display")]
    NotUtf8,
    /// The text is not a display name.
    #[error("\"{0}\" is not the name of a display; those look like \":0\" or \"host:0\"")]
    NotADisplay(Text),
    /// The display cannot be used, or can no longer be used.
    #[error("display \"{display}\": {cause}")]
    Display {
        /// Its name.
        display: Text,
        /// What is wrong.
        cause: Cause,
    },
    /// The host's parent window cannot be used.
    #[error("the parent, window {parent:#x} of display \"{display}\", {why}")]
    Parent {
        /// Its number.
        parent: u32,
        /// The display's name.
        display: Text,
        /// Why not.
        why: &'static str,
    },
    /// The window to be transient for does not exist.
    #[error("the window {window:#x} to belong to does not exist on display \"{display}\"")]
    NoOwner {
        /// Its number.
        window: u32,
        /// The display's name.
        display: Text,
    },
    /// The host reparented the window out of its parent.
    #[error("the host has put the window out of its own")]
    Reparented,
    /// The server refused to create the window.
    #[error("the X server makes no window")]
    NoWindow,
    /// Another program has destroyed the window.
    #[error("the window was closed from outside")]
    Destroyed,
}

/// What is wrong with a display.
#[derive(Clone, Debug, thiserror::Error)]
#[allow(missing_docs)]
pub enum Cause {
    #[error("no X server is reached ({0})")]
    Unreached(Text),
    #[error("the X server refuses the connection ({0})")]
    Refused(Text),
    #[error("it has no screen {0}")]
    NoScreen(usize),
    #[error("the X server broke off ({0})")]
    BrokenOff(Text),
    #[error("what answers is not an X server")]
    NoServer,
    #[error("the screen shows no true colours, which are needed")]
    NoTrueColour,
    #[error("it cannot keep a pane")]
    NoSaveSet,
    #[error("the X server does not answer")]
    Silent,
    #[error("the X server has no more identifiers")]
    NoIdentifiers,
    #[error("the X server answers {0:?}")]
    Answers(x11rb::protocol::ErrorKind),
    #[error("there is no memory left for what waits to be sent")]
    NoRoomToSend,
    #[error("the X server went away")]
    Gone,
    #[error("the X server's answers make no sense")]
    Senseless,
}

/// The result type of this crate.
pub type Result<T, E = Error> = std::result::Result<T, E>;

impl Error {
    /// The kind of this error.
    #[must_use]
    pub fn kind(&self) -> ErrorKind {
        match self {
            Self::Engine(error) => error.kind(),
            Self::Parent { .. } | Self::NoOwner { .. } => ErrorKind::Argument,
            _ => ErrorKind::Display,
        }
    }
}
