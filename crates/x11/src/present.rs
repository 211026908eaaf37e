//! Brings the pixel buffer to the screen.
//!
//! It uses shared memory if the server is on this machine and can attach it, otherwise images in
//! pieces. One frame is in flight at a time, so a slow link or a stalled server lowers the frame
//! rate and never builds a queue.
//!
//! The buffer keeps its pixels, so exposed areas are shown again without painting.

use std::collections::VecDeque;

use x11rb::connection::{Connection as _, RequestConnection as _};
use x11rb::protocol::shm::{self, ConnectionExt as _};
use x11rb::protocol::xproto::{
    ClientMessageEvent, ConnectionExt as _, EventMask, ImageFormat, PUT_IMAGE_REQUEST,
};
use x11rb::x11_utils::X11Error;

use super::areas;
use super::connection::Connection;
use super::pixels::Layout;
use super::shared::Memory;
use crate::error::{Result, vec_with_room};
use vides_raster::{Area, Target};

/// The largest piece of an image, in bytes.
const PIECE: usize = 256 << 10;

const PIECES: u32 = 3;

/// The most spare shared memory, in bytes, kept for a window that may grow.
const MOST_SLACK: usize = 8 << 20;

/// The maximum number of pixels in a buffer, enough for four of today's largest screens.
const MOST_PIXELS: u32 = 1 << 26;

/// The longest side of a buffer, in pixels.
const LONGEST: u32 = 16_384;

pub(super) struct Surface {
    window: u32,
    context: u32,
    depth: u8,
    layout: Layout,
    /// The buffer's size: that of the window when the buffer was created.
    size: (u32, u32),
    store: Store,
    shares: bool,
    painted: bool,
    /// Areas to show after the frame in flight.
    waiting: Vec<Area>,
    flight: Flight,
    /// The serial number of the last piece.
    serial: u32,
    scratch: Vec<u8>,
}

#[derive(Default)]
enum Store {
    /// No buffer, as at first or when memory runs out.
    #[default]
    None,
    /// In our memory; sent as images.
    Private(Vec<u32>),
    Shared(Segment),
    /// In our memory, and converted into shared memory.
    Both(Vec<u32>, Segment),
}

/// Shared memory attached by the server.
struct Segment {
    id: u32,
    memory: Memory,
}

enum Flight {
    None,
    /// The server reads the shared memory.
    Shared,
    /// Pieces of an image in flight, and those still to be sent.
    Pieces {
        under_way: u32,
        rest: VecDeque<Area>,
    },
}

impl Surface {
    pub(super) fn new(window: u32, context: u32, depth: u8, layout: Layout) -> Self {
        Self {
            window,
            context,
            depth,
            layout,
            size: (0, 0),
            store: Store::None,
            shares: false,
            painted: false,
            waiting: Vec::new(),
            flight: Flight::None,
            serial: 0,
            scratch: Vec::new(),
        }
    }

    pub(super) fn try_sharing(&mut self, connection: &Connection) -> Result<()> {
        if !connection.is_local() {
            return Ok(());
        }
        let known = connection.sent(connection.extension_information(shm::X11_EXTENSION_NAME))?;
        if known.is_none() {
            return Ok(());
        }
        let version = connection.answer(connection.shm_query_version())?;
        // Attaching by file descriptor came with version 1.2.
        if version.is_none_or(|version| (version.major_version, version.minor_version) < (1, 2)) {
            return Ok(());
        }
        let Ok((_, file)) = Memory::new(1) else {
            return Ok(());
        };
        let Some(id) = connection.excuse(connection.generate_id())? else {
            return Ok(());
        };
        self.shares = connection.done(connection.shm_attach_fd(id, file, true))?;
        if self.shares {
            detach(connection, id)?;
        }
        Ok(())
    }

    pub(super) fn size(&self) -> (u32, u32) {
        self.size
    }

    pub(super) fn fitting(width: u32, height: u32) -> (u32, u32) {
        let width = width.clamp(1, LONGEST);
        (width, height.clamp(1, LONGEST).min(MOST_PIXELS / width))
    }

    pub(super) fn is_free(&self) -> bool {
        matches!(self.flight, Flight::None)
    }

    /// Resizes the buffer and discards its contents; call only while no frame is in flight. If
    /// memory runs out, nothing is shown until the next size.
    pub(super) fn resize(&mut self, connection: &Connection, size: (u32, u32)) -> Result<()> {
        self.size = size;
        self.painted = false;
        self.waiting.clear();
        let (width, height) = (size.0 as usize, size.1 as usize);
        let pixels = width * height;
        let segment = match std::mem::take(&mut self.store) {
            Store::Shared(segment) | Store::Both(_, segment) => Some(segment),
            Store::None | Store::Private(_) => None,
        };
        let bytes = self.layout.row(width) * height;
        let segment = match segment {
            Some(segment) if fits(segment.memory.length(), bytes) => Some(segment),
            Some(segment) => {
                detach(connection, segment.id)?;
                drop(segment);
                self.attach(connection, bytes + (bytes / 4).min(MOST_SLACK))?
            }
            None if self.shares => self.attach(connection, bytes)?,
            None => None,
        };
        let private = || {
            let mut room = vec_with_room(pixels).ok()?;
            room.resize(pixels, 0);
            Some(room)
        };
        self.store = match segment {
            Some(segment) if self.layout.is_ours() => Store::Shared(segment),
            Some(segment) => private().map_or(Store::None, |own| Store::Both(own, segment)),
            None => private().map_or(Store::None, Store::Private),
        };
        Ok(())
    }

    /// Allocates shared memory; `None` if that fails. Does not wait until the server attaches it:
    /// if that fails, [`Surface::failed`] gets the error.
    fn attach(&mut self, connection: &Connection, bytes: usize) -> Result<Option<Segment>> {
        let Ok((memory, file)) = Memory::new(bytes) else {
            return Ok(None);
        };
        let Some(id) = connection.excuse(connection.generate_id())? else {
            return Ok(None);
        };
        connection.sent(connection.shm_attach_fd(id, file, true))?;
        Ok(Some(Segment { id, memory }))
    }

    pub(super) fn target(&mut self) -> Option<Target<'_>> {
        if !self.is_free() {
            return None;
        }
        let (width, height) = self.size;
        let pixels = match &mut self.store {
            Store::None => return None,
            Store::Private(pixels) | Store::Both(pixels, _) => pixels.as_mut_slice(),
            Store::Shared(segment) => segment.memory.pixels(),
        };
        self.painted = true;
        Some(Target {
            pixels: pixels.get_mut(..width as usize * height as usize)?,
            stride: width as usize,
            width,
            height,
        })
    }

    /// Shows these areas now, or after the frame in flight.
    pub(super) fn show(&mut self, connection: &Connection, areas: &[Area]) -> Result<()> {
        for &area in areas {
            areas::add(&mut self.waiting, area, self.size);
        }
        self.go_on(connection)
    }

    pub(super) fn go_on(&mut self, connection: &Connection) -> Result<()> {
        if self.is_free() && self.painted && !self.waiting.is_empty() {
            let areas = std::mem::take(&mut self.waiting);
            match &self.store {
                Store::Shared(_) | Store::Both(..) => self.show_shared(connection, &areas)?,
                Store::Private(_) => {
                    let most = PIECE.min(connection.maximum_request_bytes().saturating_sub(32));
                    let layout = &self.layout;
                    let cut = |area| areas::pieces(area, most, |width| layout.row(width));
                    self.flight = Flight::Pieces {
                        under_way: 0,
                        rest: areas.into_iter().flat_map(cut).collect(),
                    };
                }
                Store::None => {}
            }
        }
        self.send_pieces(connection)
    }

    fn show_shared(&mut self, connection: &Connection, areas: &[Area]) -> Result<()> {
        let (width, height) = self.size;
        let segment = match &mut self.store {
            Store::Shared(segment) => segment,
            Store::Both(pixels, segment) => {
                let row = self.layout.row(width as usize);
                for area in areas {
                    let start = area.y as usize * row + self.layout.offset(area.x as usize);
                    let out = segment.memory.bytes().get_mut(start..);
                    let out = out.unwrap_or_default();
                    convert(&self.layout, pixels, width as usize, area, out, row);
                }
                segment
            }
            Store::None | Store::Private(_) => return Ok(()),
        };
        for (i, area) in areas.iter().enumerate() {
            let request = shm::PutImageRequest {
                drawable: self.window,
                gc: self.context,
                total_width: width as u16,
                total_height: height as u16,
                src_x: area.x as u16,
                src_y: area.y as u16,
                src_width: area.width as u16,
                src_height: area.height as u16,
                dst_x: area.x as i16,
                dst_y: area.y as i16,
                depth: self.depth,
                format: ImageFormat::Z_PIXMAP.into(),
                send_event: i + 1 == areas.len(),
                shmseg: segment.id,
                offset: 0,
            };
            connection.sent(connection.send_trait_request_without_reply(request))?;
        }
        self.flight = Flight::Shared;
        Ok(())
    }

    fn send_pieces(&mut self, connection: &Connection) -> Result<()> {
        let Flight::Pieces { under_way, rest } = &mut self.flight else {
            return Ok(());
        };
        let Store::Private(pixels) = &self.store else {
            self.flight = Flight::None;
            return Ok(());
        };
        while *under_way < PIECES
            && let Some(area) = rest.pop_front()
        {
            let row = self.layout.row(area.width as usize);
            self.scratch.clear();
            self.scratch.resize(row * area.height as usize, 0);
            let stride = self.size.0 as usize;
            convert(&self.layout, pixels, stride, &area, &mut self.scratch, row);
            let asked = connection.put_image(
                ImageFormat::Z_PIXMAP,
                self.window,
                self.context,
                area.width as u16,
                area.height as u16,
                area.x as i16,
                area.y as i16,
                0,
                self.depth,
                &self.scratch,
            );
            connection.sent(asked)?;
            // A message to ourselves arrives when the image has been drawn.
            self.serial = self.serial.wrapping_add(1);
            let kind = connection.atoms()._VIDES_SHOWN;
            let message = ClientMessageEvent::new(32, self.window, kind, [self.serial, 0, 0, 0, 0]);
            let asked = connection.send_event(false, self.window, EventMask::NO_EVENT, message);
            connection.sent(asked)?;
            *under_way += 1;
        }
        if *under_way == 0 {
            self.flight = Flight::None;
        }
        Ok(())
    }

    /// The server has read the shared memory. True if that completes our frame.
    pub(super) fn completed(&mut self, event: &shm::CompletionEvent) -> bool {
        let ours = match &self.store {
            Store::Shared(segment) | Store::Both(_, segment) => segment.id == event.shmseg,
            Store::None | Store::Private(_) => false,
        };
        let arrived =
            ours && event.drawable == self.window && matches!(self.flight, Flight::Shared);
        if arrived {
            self.flight = Flight::None;
        }
        arrived
    }

    /// Our message after a piece arrived. True if that completes the frame.
    pub(super) fn arrived(&mut self, connection: &Connection, serial: u32) -> Result<bool> {
        if let Flight::Pieces { under_way, .. } = &mut self.flight {
            // Check the serial: any client can send such messages.
            if self.serial.wrapping_sub(serial) < *under_way {
                *under_way -= 1;
                self.send_pieces(connection)?;
                return Ok(self.is_free());
            }
        }
        Ok(false)
    }

    /// Handles an error that concerns images. The frame is given up; after an error of shared
    /// memory everything is sent again as images. True if a frame was in flight.
    pub(super) fn failed(&mut self, connection: &Connection, error: &X11Error) -> Result<bool> {
        let known = connection.sent(connection.extension_information(shm::X11_EXTENSION_NAME))?;
        let busy = !self.is_free();
        if known.is_some_and(|known| known.major_opcode == error.major_opcode) {
            self.flight = Flight::None;
            self.unshare(connection)?;
            return Ok(busy);
        }
        if error.major_opcode == PUT_IMAGE_REQUEST && matches!(self.flight, Flight::Pieces { .. }) {
            self.flight = Flight::None;
            return Ok(busy);
        }
        Ok(false)
    }

    fn unshare(&mut self, connection: &Connection) -> Result<()> {
        self.shares = false;
        let (width, height) = self.size;
        self.store = match std::mem::take(&mut self.store) {
            Store::Shared(mut segment) => {
                let mut own = Vec::new();
                let pixels = segment.memory.pixels();
                let pixels = pixels.get(..width as usize * height as usize);
                match (
                    own.try_reserve_exact(pixels.map_or(0, <[u32]>::len)),
                    pixels,
                ) {
                    (Ok(()), Some(pixels)) => {
                        own.extend_from_slice(pixels);
                        Store::Private(own)
                    }
                    _ => Store::None,
                }
            }
            Store::Both(own, _) => Store::Private(own),
            other => other,
        };
        let whole = Area {
            x: 0,
            y: 0,
            width,
            height,
        };
        self.show(connection, &[whole])
    }
}

/// Converts an area's pixels. `out` begins at the area's first pixel; `row` is its stride in bytes.
fn convert(
    layout: &Layout,
    pixels: &[u32],
    stride: usize,
    area: &Area,
    out: &mut [u8],
    row: usize,
) {
    let (x, width) = (area.x as usize, area.width as usize);
    let lines = area.y as usize..(area.y + area.height) as usize;
    for (y, out) in lines.zip(out.chunks_mut(row.max(1))) {
        let start = y * stride + x;
        if let Some(pixels) = pixels.get(start..start + width) {
            layout.convert(pixels, x, y, out);
        }
    }
}

/// Whether memory of `length` bytes suffices and is not far too large.
fn fits(length: usize, needed: usize) -> bool {
    length >= needed && (length <= MOST_SLACK || length / 4 <= needed)
}

fn detach(connection: &Connection, segment: u32) -> Result<()> {
    connection.sent(connection.shm_detach(segment)).map(drop)
}

#[cfg(test)]
impl Surface {
    /// Whether the server uses shared memory.
    pub(super) fn shares(&self) -> bool {
        self.shares
    }

    /// The number of bytes in the pixels.
    pub(super) fn room(&self) -> usize {
        match &self.store {
            Store::None => 0,
            Store::Private(pixels) => pixels.capacity() * 4,
            Store::Shared(segment) => segment.memory.length(),
            Store::Both(pixels, segment) => pixels.capacity() * 4 + segment.memory.length(),
        }
    }
}
