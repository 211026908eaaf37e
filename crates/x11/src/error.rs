//! Why there is no window, or no more.

pub(crate) use vides_engine::error::vec_with_room;
use vides_engine::error::{Error as EngineError, ErrorKind, Text};

/// Why there is no window, or no more.
#[derive(Clone, Debug, thiserror::Error)]
pub enum Error {
    /// Memory ran out.
    #[error(transparent)]
    Engine(#[from] EngineError),
    /// The environment names no display.
    #[error("DISPLAY is not set: there is no X server for a window")]
    NoDisplay,
    /// The environment's display is no text.
    #[error("DISPLAY is not the name of a display")]
    NotUtf8,
    /// This is no display's name.
    #[error("\"{0}\" is not the name of a display; those look like \":0\" or \"host:0\"")]
    NotADisplay(Text),
    /// Something is wrong with this display.
    #[error("display \"{display}\": {cause}")]
    Display {
        /// Its name.
        display: Text,
        /// What is wrong.
        cause: Cause,
    },
    /// The host's window for this one to live in is unfit.
    #[error("the parent, window {parent:#x} of display \"{display}\", {why}")]
    Parent {
        /// Its number.
        parent: u32,
        /// The display's name.
        display: Text,
        /// Why it is unfit.
        why: &'static str,
    },
    /// The host's window that this one should belong to is none.
    #[error("the window {window:#x} to belong to does not exist on display \"{display}\"")]
    NoOwner {
        /// Its number.
        window: u32,
        /// The display's name.
        display: Text,
    },
    /// The host took the window out of the one that it lived in.
    #[error("the host has put the window out of its own")]
    PutOut,
    /// The server made no window of what was asked.
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

/// The result of everything that can fail.
pub type Result<T, E = Error> = std::result::Result<T, E>;

impl Error {
    /// What kind it is.
    #[must_use]
    pub fn kind(&self) -> ErrorKind {
        match self {
            Self::Engine(error) => error.kind(),
            Self::Parent { .. } | Self::NoOwner { .. } => ErrorKind::Argument,
            _ => ErrorKind::Display,
        }
    }
}
