//! A text on its way from us to another program, in pieces (ICCCM 2.7.2): the
//! next one is written when the other has deleted the one before.

use std::rc::Rc;
use std::time::{Duration, Instant};

use x11rb::connection::RequestConnection as _;
use x11rb::protocol::xproto::{
    Atom, ChangeWindowAttributesAux, ConnectionExt as _, EventMask, PropMode, Window,
};
use x11rb::wrapper::ConnectionExt as _;

use super::connection::Connection;
use crate::error::Result;

/// How long the other program may let us wait for its next step.
const PATIENCE: Duration = Duration::from_secs(5);

/// The largest piece. Small enough that no other traffic waits for it.
const PIECE: usize = 256 << 10;

/// What a request needs beside its data, generously.
const REQUEST_HEAD: usize = 64;

/// A transfer under way.
pub(super) struct Outgoing {
    requestor: Window,
    property: Atom,
    kind: Atom,
    bytes: Rc<[u8]>,
    sent: usize,
    patience: Instant,
}

/// The most that is written at once.
pub(super) fn piece(connection: &Connection) -> usize {
    let most = connection.maximum_request_bytes();
    most.saturating_sub(REQUEST_HEAD).clamp(1, PIECE)
}

impl Outgoing {
    /// Announces the pieces.
    pub(super) fn start(
        connection: &Connection,
        (requestor, property): (Window, Atom),
        kind: Atom,
        bytes: Rc<[u8]>,
        now: Instant,
    ) -> Result<Self> {
        listen(connection, requestor, true)?;
        let size = u32::try_from(bytes.len()).unwrap_or(u32::MAX);
        let incr = connection.atoms().INCR;
        connection
            .change_property32(PropMode::REPLACE, requestor, property, incr, &[size])
            .map_err(|error| connection.lost(error))?
            .ignore_error();
        Ok(Self {
            requestor,
            property,
            kind,
            bytes,
            sent: 0,
            patience: now + PATIENCE,
        })
    }

    pub(super) fn requestor(&self) -> Window {
        self.requestor
    }

    /// In which property.
    pub(super) fn property(&self) -> Atom {
        self.property
    }

    /// When it has taken too long.
    pub(super) fn deadline(&self) -> Instant {
        self.patience
    }

    /// The other has taken what was written: writes the next piece, an empty
    /// one at the end. True if that was the end.
    pub(super) fn taken(&mut self, connection: &Connection, now: Instant) -> Result<bool> {
        self.patience = now + PATIENCE;
        let rest = self.bytes.get(self.sent..).unwrap_or_default();
        let next = rest.get(..piece(connection)).unwrap_or(rest);
        connection
            .change_property8(
                PropMode::REPLACE,
                self.requestor,
                self.property,
                self.kind,
                next,
            )
            .map_err(|error| connection.lost(error))?
            .ignore_error();
        self.sent += next.len();
        Ok(next.is_empty())
    }
}

/// Has the server tell us what becomes of a foreign window, or not.
pub(super) fn listen(connection: &Connection, window: Window, listen: bool) -> Result<()> {
    let events = match listen {
        true => EventMask::PROPERTY_CHANGE | EventMask::STRUCTURE_NOTIFY,
        false => EventMask::NO_EVENT,
    };
    let aux = ChangeWindowAttributesAux::new().event_mask(events);
    connection
        .change_window_attributes(window, &aux)
        .map_err(|error| connection.lost(error))?
        .ignore_error();
    Ok(())
}
