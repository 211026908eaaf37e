//! x11rb's connection, without the three places where it waits for a reply while it holds a lock
//! that an X error needs: extensions, the longest request, and further identifiers. A server that
//! replies with an error would block the caller for good there.
//!
//! It also checks the one reply in use whose counts x11rb allocates without checking its length.

use std::cell::{Cell, RefCell};
use std::io::IoSlice;

use x11rb::connection::{
    BufWithFds, Connection, DiscardMode, RawEventAndSeqNumber, ReplyOrError, RequestConnection,
    RequestKind, SequenceNumber,
};
use x11rb::cookie::{Cookie, CookieWithFds, VoidCookie};
use x11rb::errors::{ConnectError, ConnectionError, ParseError, ReplyOrIdError};
use x11rb::protocol::xc_misc::{self, ConnectionExt as _};
use x11rb::protocol::xproto::{ConnectionExt as _, QueryExtensionReply, Setup};
use x11rb::protocol::{Event, render};
use x11rb::rust_connection::RustConnection;
use x11rb::utils::RawFdContainer;
use x11rb::x11_utils::{ExtInfoProvider, ExtensionInformation, TryParse, TryParseFd, X11Error};

use super::stream::Stream;

/// Bytes per unit of a request's length.
const UNIT: usize = 4;

/// The minor opcode of RENDER's `QueryPictFormats`.
const QUERY_PICT_FORMATS: u8 = 1;

#[derive(Debug)]
pub(super) struct Raw {
    inner: RustConnection<Stream>,
    /// Never borrowed while waiting for a reply.
    extensions: RefCell<Extensions>,
    ids: Cell<Ids>,
    pict_formats: Cell<Option<SequenceNumber>>,
}

#[derive(Debug, Default)]
struct Extensions(Vec<(&'static str, Extension)>);

#[derive(Clone, Copy, Debug)]
enum Extension {
    Asked(SequenceNumber),
    Known(Option<ExtensionInformation>),
}

/// Identifiers of this client that are not in use yet.
#[derive(Clone, Copy, Debug)]
struct Ids {
    next: Option<u32>,
    last: u32,
    step: u32,
}

impl Ids {
    fn take(&mut self) -> Option<u32> {
        let id = self.next.filter(|id| *id <= self.last)?;
        self.next = id.checked_add(self.step);
        Some(id)
    }
}

impl Raw {
    /// Connects through `stream`.
    pub(super) fn open(
        stream: Stream,
        screen: usize,
        name: Vec<u8>,
        data: Vec<u8>,
    ) -> Result<Self, ConnectError> {
        let inner = RustConnection::connect_to_stream_with_auth_info(stream, screen, name, data)?;
        let setup = inner.setup();
        let ids = Ids {
            next: Some(setup.resource_id_base),
            last: setup.resource_id_base | setup.resource_id_mask,
            step: 1 << setup.resource_id_mask.trailing_zeros(), // x11rb refuses a mask of 0
        };
        Ok(Self {
            inner,
            extensions: RefCell::default(),
            ids: Cell::new(ids),
            pict_formats: Cell::new(None),
        })
    }

    pub(super) fn stream(&self) -> &Stream {
        self.inner.stream()
    }

    fn asked(&self, name: &'static str) -> Result<Extension, ConnectionError> {
        if let Some(known) = self.extensions.borrow().get(name) {
            return Ok(known);
        }
        let asked = self.query_extension(name.as_bytes())?;
        let asked = Extension::Asked(kept(asked.sequence_number(), asked));
        self.extensions.borrow_mut().0.push((name, asked));
        Ok(asked)
    }

    /// Fails if x11rb would query the extension for long requests.
    fn fits(&self, bufs: &[IoSlice<'_>]) -> Result<(), ConnectionError> {
        let length = bufs.iter().map(|buf| buf.len()).sum::<usize>();
        match length <= self.maximum_request_bytes() {
            true => Ok(()),
            false => Err(ConnectionError::MaximumRequestLengthExceeded),
        }
    }

    fn is_pict_formats(&self, request: &[IoSlice<'_>]) -> bool {
        let known = self.extensions.borrow().get(render::X11_EXTENSION_NAME);
        let Some(Extension::Known(Some(render))) = known else {
            return false;
        };
        let head = request.first().and_then(|head| head.get(..2));
        head == Some(&[render.major_opcode, QUERY_PICT_FORMATS])
    }

    fn check(&self, sequence: SequenceNumber, reply: &[u8]) -> Result<(), ConnectionError> {
        let hollow = self.pict_formats.get() == Some(sequence) && !holds_pict_formats(reply);
        match hollow {
            true => Err(ParseError::InsufficientData.into()),
            false => Ok(()),
        }
    }
}

/// The number of a request whose reply another cookie takes.
fn kept<T>(sequence: SequenceNumber, cookie: T) -> SequenceNumber {
    std::mem::forget(cookie); // dropping it would discard the reply
    sequence
}

/// Whether a reply to `QueryPictFormats` is as long as its counts require.
fn holds_pict_formats(reply: &[u8]) -> bool {
    let walk = || {
        let count = |at: usize| -> Option<usize> {
            let bytes = reply.get(at..at + 4)?.try_into().ok()?;
            usize::try_from(u32::from_ne_bytes(bytes)).ok()
        };
        let (formats, screens, subpixels) = (count(8)?, count(12)?, count(24)?);
        let mut at = 32_usize.checked_add(formats.checked_mul(28)?)?;
        for _ in 0..screens {
            let depths = count(at)?;
            at += 8;
            for _ in 0..depths {
                let visuals = reply.get(at + 2..at + 4)?.try_into().ok()?;
                at += 8 + 8 * usize::from(u16::from_ne_bytes(visuals));
            }
        }
        (at.checked_add(subpixels.checked_mul(4)?)? <= reply.len()).then_some(())
    };
    walk().is_some()
}

impl Extensions {
    fn get(&self, name: &str) -> Option<Extension> {
        let known = self.0.iter().find(|(known, _)| *known == name);
        known.map(|(_, extension)| *extension)
    }

    fn present(&self) -> impl Iterator<Item = (&str, ExtensionInformation)> {
        self.0
            .iter()
            .filter_map(|(name, extension)| match extension {
                Extension::Known(Some(information)) => Some((*name, *information)),
                _ => None,
            })
    }
}

impl ExtInfoProvider for Extensions {
    fn get_from_major_opcode(&self, major_opcode: u8) -> Option<(&str, ExtensionInformation)> {
        self.present()
            .find(|(_, known)| known.major_opcode == major_opcode)
    }

    fn get_from_event_code(&self, event_code: u8) -> Option<(&str, ExtensionInformation)> {
        self.present()
            .filter(|(_, known)| known.first_event <= event_code)
            .max_by_key(|(_, known)| known.first_event)
    }

    fn get_from_error_code(&self, error_code: u8) -> Option<(&str, ExtensionInformation)> {
        self.present()
            .filter(|(_, known)| known.first_error <= error_code)
            .max_by_key(|(_, known)| known.first_error)
    }
}

impl RequestConnection for Raw {
    type Buf = Vec<u8>;

    fn send_request_with_reply<R: TryParse>(
        &self,
        bufs: &[IoSlice<'_>],
        fds: Vec<RawFdContainer>,
    ) -> Result<Cookie<'_, Self, R>, ConnectionError> {
        self.fits(bufs)?;
        let sent = self.inner.send_request_with_reply::<R>(bufs, fds)?;
        let sequence = kept(sent.sequence_number(), sent);
        if self.is_pict_formats(bufs) {
            self.pict_formats.set(Some(sequence));
        }
        Ok(Cookie::new(self, sequence))
    }

    fn send_request_with_reply_with_fds<R: TryParseFd>(
        &self,
        bufs: &[IoSlice<'_>],
        fds: Vec<RawFdContainer>,
    ) -> Result<CookieWithFds<'_, Self, R>, ConnectionError> {
        self.fits(bufs)?;
        let sent = (self.inner).send_request_with_reply_with_fds::<R>(bufs, fds)?;
        Ok(CookieWithFds::new(self, kept(sent.sequence_number(), sent)))
    }

    fn send_request_without_reply(
        &self,
        bufs: &[IoSlice<'_>],
        fds: Vec<RawFdContainer>,
    ) -> Result<VoidCookie<'_, Self>, ConnectionError> {
        self.fits(bufs)?;
        let sent = self.inner.send_request_without_reply(bufs, fds)?;
        Ok(VoidCookie::new(self, kept(sent.sequence_number(), sent)))
    }

    fn discard_reply(&self, sequence: SequenceNumber, kind: RequestKind, mode: DiscardMode) {
        self.inner.discard_reply(sequence, kind, mode);
    }

    fn prefetch_extension_information(&self, name: &'static str) -> Result<(), ConnectionError> {
        self.asked(name).map(drop)
    }

    /// An extension counts as missing if the server does not describe it.
    fn extension_information(
        &self,
        name: &'static str,
    ) -> Result<Option<ExtensionInformation>, ConnectionError> {
        let sequence = match self.asked(name)? {
            Extension::Known(known) => return Ok(known),
            Extension::Asked(sequence) => sequence,
        };
        let reply = match self.inner.wait_for_reply_or_raw_error(sequence)? {
            ReplyOrError::Reply(reply) => reply,
            ReplyOrError::Error(_) => Vec::new(),
        };
        let known = QueryExtensionReply::try_parse(&reply)
            .ok()
            .map(|(reply, _)| reply)
            .filter(|reply| reply.present)
            .map(|reply| ExtensionInformation {
                major_opcode: reply.major_opcode,
                first_event: reply.first_event,
                first_error: reply.first_error,
            });
        let mut extensions = self.extensions.borrow_mut();
        for (_, extension) in extensions.0.iter_mut().filter(|(asked, _)| *asked == name) {
            *extension = Extension::Known(known);
        }
        Ok(known)
    }

    fn wait_for_reply_or_raw_error(
        &self,
        sequence: SequenceNumber,
    ) -> Result<ReplyOrError<Vec<u8>>, ConnectionError> {
        let answer = self.inner.wait_for_reply_or_raw_error(sequence)?;
        if let ReplyOrError::Reply(reply) = &answer {
            self.check(sequence, reply)?;
        }
        Ok(answer)
    }

    fn wait_for_reply(&self, sequence: SequenceNumber) -> Result<Option<Vec<u8>>, ConnectionError> {
        let reply = self.inner.wait_for_reply(sequence)?;
        self.check(sequence, reply.as_deref().unwrap_or_default())?;
        Ok(reply)
    }

    fn wait_for_reply_with_fds_raw(
        &self,
        sequence: SequenceNumber,
    ) -> Result<ReplyOrError<BufWithFds<Vec<u8>>, Vec<u8>>, ConnectionError> {
        self.inner.wait_for_reply_with_fds_raw(sequence)
    }

    fn check_for_raw_error(
        &self,
        sequence: SequenceNumber,
    ) -> Result<Option<Vec<u8>>, ConnectionError> {
        self.inner.check_for_raw_error(sequence)
    }

    fn prefetch_maximum_request_bytes(&self) {}

    /// Without the extension for long requests, which x11rb would query.
    fn maximum_request_bytes(&self) -> usize {
        usize::from(self.inner.setup().maximum_request_length) * UNIT
    }

    fn parse_error(&self, error: &[u8]) -> Result<X11Error, ParseError> {
        X11Error::try_parse(error, &*self.extensions.borrow())
    }

    fn parse_event(&self, event: &[u8]) -> Result<Event, ParseError> {
        Event::parse(event, &*self.extensions.borrow())
    }
}

impl Connection for Raw {
    fn wait_for_raw_event_with_sequence(
        &self,
    ) -> Result<RawEventAndSeqNumber<Vec<u8>>, ConnectionError> {
        self.inner.wait_for_raw_event_with_sequence()
    }

    fn poll_for_raw_event_with_sequence(
        &self,
    ) -> Result<Option<RawEventAndSeqNumber<Vec<u8>>>, ConnectionError> {
        self.inner.poll_for_raw_event_with_sequence()
    }

    fn flush(&self) -> Result<(), ConnectionError> {
        self.inner.flush()
    }

    fn setup(&self) -> &Setup {
        self.inner.setup()
    }

    fn generate_id(&self) -> Result<u32, ReplyOrIdError> {
        let mut ids = self.ids.get();
        let mut id = ids.take();
        if id.is_none()
            && self
                .extension_information(xc_misc::X11_EXTENSION_NAME)?
                .is_some()
        {
            let more = self.xc_misc_get_xid_range()?.reply()?;
            // A range of one that starts at 0 means that there are no more.
            if more.start_id != 0 && more.count != 0 {
                let length = (more.count - 1).saturating_mul(ids.step);
                ids.next = Some(more.start_id);
                ids.last = more.start_id.saturating_add(length);
                id = ids.take();
            }
        }
        self.ids.set(ids);
        id.ok_or(ReplyOrIdError::IdsExhausted)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn reply(words: &[u32]) -> Vec<u8> {
        words.iter().flat_map(|word| word.to_ne_bytes()).collect()
    }

    #[test]
    fn picture_formats_are_counted_before_they_are_allocated() {
        let depth = |visuals: u32| {
            u32::from_ne_bytes(
                [[24, 0], (visuals as u16).to_ne_bytes()]
                    .concat()
                    .try_into()
                    .unwrap(),
            )
        };
        // The head, one format, one screen with one depth with one visual, one subpixel order.
        let whole = |formats, screens, depths, visuals, subpixels| {
            let head = [1, 0, formats, screens, 1, 1, subpixels, 0];
            let rest = [7, 7, 7, 7, 7, 7, 7, depths, 7, depth(visuals), 0, 7, 7, 0];
            reply(&[&head[..], &rest[..]].concat())
        };
        assert!(holds_pict_formats(&whole(1, 1, 1, 1, 1)));
        let most = u32::MAX;
        for hollow in [
            whole(most, 1, 1, 1, 1),
            whole(1, most, 1, 1, 1),
            whole(1, 1, most, 1, 1),
            whole(1, 1, 1, 0xffff, 1),
            whole(1, 1, 1, 1, most),
            whole(2, 1, 1, 1, 1),
            Vec::new(),
        ] {
            assert!(!holds_pict_formats(&hollow), "{hollow:?}");
        }
    }

    #[test]
    fn identifiers_end_without_an_overflow() {
        let mut ids = Ids {
            next: Some(0xffff_fffe),
            last: u32::MAX,
            step: 1,
        };
        let taken: Vec<_> = std::iter::from_fn(|| ids.take()).collect();
        assert_eq!(taken, [0xffff_fffe, u32::MAX]);
    }
}
