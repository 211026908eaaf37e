//! Sending text to another program in pieces (ICCCM 2.7.2, INCR): each piece is written when the
//! requestor has deleted the one before.

use std::rc::Rc;
use std::time::Instant;

use x11rb::connection::RequestConnection as _;
use x11rb::protocol::xproto::{
    Atom, ChangeWindowAttributesAux, ConnectionExt as _, EventMask, PropMode, Window,
};
use x11rb::wrapper::ConnectionExt as _;

use super::connection::Connection;
use super::incoming::STEP_TIMEOUT;
use crate::error::Result;

/// The largest piece, in bytes; small enough not to delay other traffic.
const PIECE: usize = 256 << 10;

/// Room for a request's header, generously.
const REQUEST_HEAD: usize = 64;

pub(super) struct Outgoing {
    requestor: Window,
    property: Atom,
    kind: Atom,
    bytes: Rc<[u8]>,
    sent: usize,
    step_end: Instant,
}

pub(super) fn piece(connection: &Connection) -> usize {
    let most = connection.maximum_request_bytes();
    most.saturating_sub(REQUEST_HEAD).clamp(1, PIECE)
}

impl Outgoing {
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
        let replace = PropMode::REPLACE;
        let asked = connection.change_property32(replace, requestor, property, incr, &[size]);
        connection.sent_quietly(asked)?;
        Ok(Self {
            requestor,
            property,
            kind,
            bytes,
            sent: 0,
            step_end: now + STEP_TIMEOUT,
        })
    }

    pub(super) fn requestor(&self) -> Window {
        self.requestor
    }

    pub(super) fn property(&self) -> Atom {
        self.property
    }

    pub(super) fn deadline(&self) -> Instant {
        self.step_end
    }

    /// The requestor took a piece: writes the next one, an empty one at the end. True when done.
    pub(super) fn taken(&mut self, connection: &Connection, now: Instant) -> Result<bool> {
        self.step_end = now + STEP_TIMEOUT;
        let rest = self.bytes.get(self.sent..).unwrap_or_default();
        let next = rest.get(..piece(connection)).unwrap_or(rest);
        connection.sent_quietly(connection.change_property8(
            PropMode::REPLACE,
            self.requestor,
            self.property,
            self.kind,
            next,
        ))?;
        self.sent += next.len();
        Ok(next.is_empty())
    }
}

/// Selects or deselects property and structure events of a foreign window.
pub(super) fn listen(connection: &Connection, window: Window, listen: bool) -> Result<()> {
    let events = match listen {
        true => EventMask::PROPERTY_CHANGE | EventMask::STRUCTURE_NOTIFY,
        false => EventMask::NO_EVENT,
    };
    let aux = ChangeWindowAttributesAux::new().event_mask(events);
    connection.sent_quietly(connection.change_window_attributes(window, &aux))
}
