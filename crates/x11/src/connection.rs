//! A separate connection to an X server, with atoms and extensions.
//!
//! It dereferences to x11rb's connection, with two traps. While a reply is waited for, events pile
//! up in x11rb's queue and the descriptor remains quiet, so drain events afterwards. A reply may
//! never come, so ask with [`Connection::answer`], which distinguishes a lost server from a slow
//! one.

use std::io::ErrorKind;
use std::ops::Deref;
use std::os::fd::{AsFd, BorrowedFd};
use std::time::{Duration, Instant};

use x11rb::connection::{Connection as _, RequestConnection as _};
use x11rb::cookie::{Cookie, VoidCookie};
use x11rb::errors::{ConnectError, ConnectionError, ReplyError, ReplyOrIdError};
use x11rb::protocol::{Event, shm, xkb, xproto};
use x11rb::x11_utils::TryParse;

use super::atoms::Atoms;
use super::authority::authority;
use super::connect;
use super::raw::Raw;
use super::stream::Stream;
use crate::error::{Cause, Error, Result};
use vides_engine::error::reason;

/// The smallest event, in bytes.
const EVENT: usize = 32;

const OPENING: Duration = Duration::from_secs(2);

pub(super) struct Connection {
    raw: Raw,
    /// An index into the setup's screens, checked when connecting.
    screen: usize,
    atoms: Atoms,
    display: String,
    local: bool,
}

impl Connection {
    /// Connects to `display`, or to the environment's `DISPLAY`, and fetches the atoms. Until
    /// [`Connection::settle`], all waits together take at most [`OPENING`].
    pub(super) fn open(display: Option<&str>) -> Result<Self> {
        let display = match display {
            Some(name) => name.to_owned(),
            None => environment()?,
        };
        let parsed =
            connect::parse(&display).ok_or_else(|| Error::NotADisplay((&display).into()))?;
        let deadline = Instant::now() + OPENING;
        let fail = |cause| Error::Display {
            display: (&display).into(),
            cause,
        };
        let peer = connect::connect(&parsed, deadline).map_err(|error| fail(no_server(&error)))?;
        let (name, data) = authority(peer.name(), parsed.display, deadline);
        let local = peer.local;
        let stream = Stream::new(peer.socket, deadline).map_err(|error| fail(no_server(&error)))?;
        let screen = usize::from(parsed.screen);
        let raw =
            Raw::open(stream, screen, name, data).map_err(|error| fail(refusal(error, screen)))?;
        let lost = |error: ReplyError| fail(lost_because(error.into()));
        // Send all requests before reading replies: one round trip.
        for name in [shm::X11_EXTENSION_NAME, xkb::X11_EXTENSION_NAME] {
            raw.prefetch_extension_information(name)
                .map_err(|error| lost(error.into()))?;
        }
        let atoms = Atoms::new(&raw).map_err(|error| lost(error.into()))?;
        let atoms = atoms.reply().map_err(lost)?;
        Ok(Self {
            raw,
            screen,
            atoms,
            display,
            local,
        })
    }

    /// Ends the opening phase: from now on each reply is waited for separately, for at most a
    /// second, and after a timeout not at all until the server speaks again.
    pub(super) fn settle(&self) {
        self.raw.stream().settle();
    }

    pub(super) fn display(&self) -> &str {
        &self.display
    }

    pub(super) fn screen(&self) -> &xproto::Screen {
        &self.raw.setup().roots[self.screen]
    }

    pub(super) fn screen_number(&self) -> usize {
        self.screen
    }

    pub(super) fn atoms(&self) -> &Atoms {
        &self.atoms
    }

    /// The server runs on this machine, so memory and files can be shared.
    pub(super) fn is_local(&self) -> bool {
        self.local
    }

    pub(super) fn stream(&self) -> &Stream {
        self.raw.stream()
    }

    /// The next queued event, without waiting. Events that cannot be parsed are skipped.
    pub(super) fn next(&self) -> Result<Option<Event>> {
        loop {
            match self.raw.poll_for_event() {
                Ok(event) => {
                    let looked_at = if event.is_some() { EVENT } else { usize::MAX };
                    self.stream().looked_at(looked_at);
                    return Ok(event);
                }
                Err(ConnectionError::ParseError(_)) => {}
                Err(error) => return Err(self.lost(error)),
            }
        }
    }

    /// Waits for a reply. `None` if it is an error or late; neither ends the window.
    pub(super) fn answer<R: TryParse>(
        &self,
        question: Result<Cookie<'_, Raw, R>, ConnectionError>,
    ) -> Result<Option<R>> {
        let answer = question.map_err(ReplyError::from).and_then(|asked| {
            let bytes = asked.raw_reply()?;
            self.stream().looked_at(bytes.len());
            Ok(R::try_parse(&bytes)?.0)
        });
        self.excuse(answer.map_err(ReplyOrIdError::from))
    }

    /// Waits until the server has carried out a request. `false` if it refused or timed out.
    pub(super) fn done(&self, asked: Result<VoidCookie<'_, Raw>, ConnectionError>) -> Result<bool> {
        let result = asked.map_err(ReplyError::from).and_then(VoidCookie::check);
        Ok(self.excuse(result.map_err(ReplyOrIdError::from))?.is_some())
    }

    /// Turns failures that do not end the window into `None`.
    pub(super) fn excuse<T>(&self, result: Result<T, ReplyOrIdError>) -> Result<Option<T>> {
        match result {
            Ok(value) => Ok(Some(value)),
            Err(ReplyOrIdError::X11Error(_)) => Ok(None),
            Err(ReplyOrIdError::ConnectionError(ConnectionError::IoError(error)))
                if error.kind() == ErrorKind::TimedOut =>
            {
                Ok(None)
            }
            Err(ReplyOrIdError::ConnectionError(
                ConnectionError::ParseError(_)
                | ConnectionError::UnsupportedExtension
                | ConnectionError::MaximumRequestLengthExceeded,
            )) => Ok(None),
            Err(error) => Err(self.lost(error)),
        }
    }

    /// The result of sending a request; an error of the server arrives as an event.
    pub(super) fn sent<T>(&self, result: Result<T, impl Into<ReplyOrIdError>>) -> Result<T> {
        result.map_err(|error| self.lost(error))
    }

    /// Like [`Connection::sent`], but ignores an error of the server.
    pub(super) fn sent_quietly(
        &self,
        request: Result<VoidCookie<'_, Raw>, ConnectionError>,
    ) -> Result<()> {
        self.sent(request).map(VoidCookie::ignore_error)
    }

    /// Sends as much queued output as the socket takes.
    pub(super) fn flush(&self) -> Result<()> {
        self.sent(self.raw.flush())
    }

    /// Like [`Connection::flush`], but only for what the socket did not take before.
    pub(super) fn push(&self) -> Result<()> {
        self.sent(self.stream().push().map_err(ConnectionError::from))
    }

    pub(super) fn unfit(&self, cause: Cause) -> Error {
        Error::Display {
            display: (&self.display).into(),
            cause,
        }
    }

    pub(super) fn lost(&self, error: impl Into<ReplyOrIdError>) -> Error {
        self.unfit(lost_because(error.into()))
    }
}

impl Deref for Connection {
    type Target = Raw;

    fn deref(&self) -> &Raw {
        &self.raw
    }
}

impl AsFd for Connection {
    fn as_fd(&self) -> BorrowedFd<'_> {
        self.raw.stream().watch()
    }
}

fn environment() -> Result<String> {
    let name = std::env::var_os("DISPLAY").ok_or(Error::NoDisplay)?;
    match name.into_string() {
        Ok(name) if name.is_empty() => Err(Error::NoDisplay),
        Ok(name) => Ok(name),
        Err(_) => Err(Error::NotUtf8),
    }
}

fn no_server(error: &std::io::Error) -> Cause {
    match error.kind() {
        ErrorKind::TimedOut => Cause::Silent,
        _ => Cause::Unreached((&reason(error)).into()),
    }
}

fn refusal(error: ConnectError, screen: usize) -> Cause {
    let said = |words: &[u8]| {
        let words = String::from_utf8_lossy(words);
        Cause::Refused(
            words
                .trim_matches(|c: char| c.is_whitespace() || c.is_control())
                .into(),
        )
    };
    match error {
        ConnectError::SetupFailed(failed) => said(&failed.reason),
        ConnectError::SetupAuthenticate(failed) => said(&failed.reason),
        ConnectError::InvalidScreen => Cause::NoScreen(screen),
        ConnectError::IoError(error) if error.kind() == ErrorKind::TimedOut => Cause::Silent,
        ConnectError::IoError(error) => Cause::BrokenOff((&reason(&error)).into()),
        _ => Cause::NoServer,
    }
}

fn lost_because(error: ReplyOrIdError) -> Cause {
    match error {
        ReplyOrIdError::IdsExhausted => Cause::NoIdentifiers,
        ReplyOrIdError::X11Error(error) => Cause::Answers(error.error_kind),
        ReplyOrIdError::ConnectionError(ConnectionError::IoError(error)) => match error.kind() {
            ErrorKind::TimedOut => Cause::Silent,
            ErrorKind::OutOfMemory => Cause::NoRoomToSend,
            ErrorKind::InvalidData => Cause::Senseless,
            _ => Cause::Gone,
        },
        ReplyOrIdError::ConnectionError(_) => Cause::Senseless,
    }
}
