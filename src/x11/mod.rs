//! One window on an X server: its connection, its input as egui wants it, its
//! pixels on the screen, the clipboard.
//!
//! Why not Xlib: it ends the process when the server goes away, and a host may
//! have an Xlib of its own with an error handler of its own. This speaks the
//! protocol itself (x11rb). Each window has its own connection, so that what
//! happens to one concerns no other. Nothing here blocks for longer than a
//! stated time, raises a signal, or ends the process; if the server goes away
//! every call says [`crate::Error::Display`].
//!
//! It knows nothing of what the window shows, and nothing of C.

mod atoms;
mod clipboard;
mod compose;
mod connect;
mod connection;
mod core_keymap;
mod cursor;
mod incoming;
mod keyboard;
mod keymap;
mod keys;
mod outgoing;
mod stream;

#[cfg(test)]
mod keyboard_tests;
#[cfg(test)]
mod testing;

use std::os::fd::{AsFd, BorrowedFd};

use crate::error::Result;

/// How a window is to be opened.
#[derive(Clone, Debug, Default)]
pub(crate) struct Options {
    /// The display's name; the environment's `DISPLAY` if none.
    pub(crate) display: Option<String>,
    /// The title; UTF-8.
    pub(crate) title: String,
    /// Wanted inner size in points (pixels at 96 dots per inch).
    pub(crate) size: [f32; 2],
    /// Smallest useful inner size in points.
    pub(crate) smallest: [f32; 2],
}

/// What happened since the last look, beside input for egui.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct News {
    /// There is input, or the size or the scale changed: egui should run.
    pub(crate) input: bool,
    /// The user or the window manager wants the window to be closed.
    pub(crate) close: bool,
    /// The frame that was in flight has arrived: another may be shown.
    pub(crate) shown: bool,
    /// The buffer of pixels is another one (size): paint it whole.
    pub(crate) new_buffer: bool,
}

/// An open window. Dropping it closes the window and the connection.
pub(crate) struct Window {
    never: std::convert::Infallible,
}

impl Window {
    /// Connects and opens a window. Waits for the server's answers, but at
    /// most a few seconds in all.
    pub(crate) fn open(options: &Options) -> Result<Self> {
        let _ = options;
        Err(crate::Error::Display("no window yet".into()))
    }

    /// Reads and handles everything that has arrived; never blocks. Answers
    /// the server's questions (ping, selections, exposures) itself.
    ///
    /// # Errors
    /// [`crate::Error::Display`] if the server is gone or hangs.
    pub(crate) fn poll(&mut self) -> Result<News> {
        match self.never {}
    }

    /// The input since the last call, complete: time, screen, scale,
    /// modifiers, focus, events.
    pub(crate) fn take_input(&mut self) -> egui::RawInput {
        match self.never {}
    }

    /// Pixels for one point.
    pub(crate) fn scale(&self) -> f32 {
        match self.never {}
    }

    /// The pixels to paint into; `None` while a frame is in flight, or when
    /// the window is not visible. [`News::shown`] tells when to ask again.
    pub(crate) fn target(&mut self) -> Option<crate::raster::Target<'_>> {
        match self.never {}
    }

    /// Shows these areas of the pixels.
    pub(crate) fn present(&mut self, areas: &[crate::raster::Area]) -> Result<()> {
        let _ = areas;
        match self.never {}
    }

    /// Does what egui wants done outside: cursor, clipboard, primary selection.
    pub(crate) fn take_output(&mut self, output: egui::PlatformOutput) -> Result<()> {
        drop(output);
        match self.never {}
    }

    /// Another title.
    pub(crate) fn set_title(&mut self, title: &str) -> Result<()> {
        let _ = title;
        match self.never {}
    }

    /// To the front, with the keyboard.
    pub(crate) fn raise(&mut self) -> Result<()> {
        match self.never {}
    }

    /// Sends what is still waiting to be sent.
    pub(crate) fn flush(&mut self) -> Result<()> {
        match self.never {}
    }
}

impl AsFd for Window {
    /// The connection: readable when [`Window::poll`] has something to do.
    fn as_fd(&self) -> BorrowedFd<'_> {
        match self.never {}
    }
}
