//! One window on an X server: its connection, input for egui, pixels, and clipboard.
//!
//! Xlib is not used, because it ends the process when the server goes away, and because the host
//! may use Xlib with its own error handler. Each window has its own connection, so windows cannot
//! disturb each other. No call blocks beyond a stated time, raises a signal, or ends the process;
//! once the server is gone, every call returns `ErrorKind::Display`.
//!
//! This crate knows neither what the window shows nor C.

// Standard output is the host's.
#![cfg_attr(not(test), warn(clippy::print_stdout))]

mod areas;
mod atoms;
mod authority;
mod clipboard;
mod compose;
mod connect;
mod connection;
mod core_keymap;
mod cursor;
mod drops;
mod embedded;
mod error;
mod events;
mod icon;
mod incoming;
mod keyboard;
mod keymap;
mod keys;
mod options;
mod outgoing;
mod packets;
mod pane;
mod pane_pool;
mod pixels;
mod pointer;
mod present;
mod raw;
mod scale;
mod settings;
mod shared;
mod state;
mod stream;
mod visual;
mod window;

#[cfg(test)]
mod clipboard_hostile_tests;
#[cfg(test)]
mod clipboard_tests;
#[cfg(test)]
mod drops_tests;
#[cfg(test)]
mod input_tests;
#[cfg(test)]
mod keyboard_tests;
#[cfg(test)]
mod opening_tests;
#[cfg(test)]
mod server_tests;
#[cfg(test)]
mod settings_tests;
#[cfg(test)]
mod testing;
#[cfg(test)]
mod window_tests;

use std::os::fd::{AsFd, BorrowedFd};
use std::time::{Duration, Instant};

use egui::{Pos2, Rect, Vec2, ViewportInfo};
use x11rb::connection::Connection as _;
use x11rb::protocol::xproto::ImageOrder;

use clipboard::{Clipboard, Selection};
pub use connect::without_signals;
use connection::Connection;
use cursor::Cursors;
use drops::Drops;
use embedded::EmbedParent;
pub use error::{Cause, Error, Result};
use keyboard::Keyboard;
pub use options::Options;
pub use pane::{PanePlace, PaneWindow};
use pixels::Layout;
use pointer::Pointer;
use present::Surface;
use settings::Settings;
use state::Focus;
pub use state::{PollResult, Window};
use vides_raster::{Area, Target};

/// The largest texture the painter accepts, in pixels per side.
const TEXTURE_SIDE: usize = 2048;

/// Events handled per poll, so that a flood starves neither the host nor other windows.
const MOST_EVENTS: usize = 256;

/// How long to wait for a clipboard manager when the window closes.
const HAND_OVER: Duration = Duration::from_millis(300);

impl Window {
    /// Connects and opens a window, which takes a few seconds at most.
    ///
    /// # Errors
    /// `ErrorKind::Display`, naming the display and the reason; `ErrorKind::Argument` if a window
    /// given in `options` does not exist.
    pub fn open(options: &Options) -> Result<Self> {
        let connection = Connection::open(options.display.as_deref())?;
        let setup = connection.setup();
        let visual = visual::choose(setup, connection.screen())
            .ok_or_else(|| connection.unfit(Cause::NoTrueColour))?;
        let layout = Layout::new(&visual, setup.image_byte_order == ImageOrder::MSB_FIRST);
        window::watch_desktop(&connection)?;
        let resources = scale::ask(&connection)?.unwrap_or_default();
        let scale = scale::of(&resources);
        let settings = Settings::ask(&connection)?;
        let home = match options.parent {
            None => None,
            Some(parent) => Some(EmbedParent::enter(&connection, parent)?),
        };
        let place = home.as_ref().map(|(home, size)| (home.parent(), *size));
        let frame = window::create(&connection, &visual, options, scale, place)?;
        let mut surface = Surface::new(frame.window, frame.context, visual.depth, layout);
        surface.try_sharing(&connection)?;
        let keyboard = Keyboard::new(&connection)?;
        connection.settle();
        let mut window = Self {
            connection,
            frame,
            surface,
            pointer: Pointer::default(),
            keyboard,
            clipboard: Clipboard::new(),
            drops: Drops::default(),
            cursors: Cursors::new(),
            resources,
            settings,
            home: home.map(|(home, _)| home),
            pane: None,
            middle: None,
            pos: Pos2::ZERO,
            scale,
            smallest: options.smallest,
            size: frame.size,
            focus: Focus::default(),
            mapped: false,
            covered: false,
            time: x11rb::CURRENT_TIME,
            events: Vec::new(),
            news: PollResult {
                input: true,
                ..PollResult::default()
            },
            opened: Instant::now(),
            lost: None,
        };
        window.flush()?;
        Ok(window)
    }

    /// Reads and handles what has arrived, up to a limit, without blocking. It also answers pings,
    /// selection requests and exposures.
    ///
    /// # Errors
    /// `ErrorKind::Display` if the server or the window is gone.
    pub fn poll(&mut self) -> Result<PollResult> {
        self.alive()?;
        let before = self.events.len();
        let result = self.drain();
        self.noted(result)?;
        let mut news = std::mem::take(&mut self.news);
        let added = self.events.get(before..).unwrap_or_default();
        let is_motion = |event: &egui::Event| matches!(event, egui::Event::PointerMoved(_));
        news.motion |= added.iter().any(is_motion);
        news.input |= !added.iter().all(is_motion);
        // An expose may have started another frame.
        news.shown &= self.surface.is_free();
        Ok(news)
    }

    fn drain(&mut self) -> Result<()> {
        let now = Instant::now();
        self.clipboard.tick(&self.connection, now)?;
        (self.drops).tick(&self.connection, self.frame.window, now)?;
        self.recheck_focus(now)?;
        self.connection.push()?;
        // Handling an event may wait for a reply. That can read further events into x11rb's queue,
        // which the descriptor does not show.
        let mut left = MOST_EVENTS;
        loop {
            let mut any = false;
            while left > 0
                && let Some(event) = self.connection.next()?
            {
                left -= 1;
                any = true;
                self.handle(&event)?;
            }
            self.keyboard.settle(&self.connection, &mut self.events)?;
            if let Some(time) = self.keyboard.take_paste() {
                self.paste(Selection::Clipboard, time, None)?;
            }
            self.news.input |= self.settings.renew(&self.connection)?;
            if self.mapped && self.surface.is_free() && self.surface.size() != self.size {
                self.surface.resize(&self.connection, self.size)?;
                self.news.new_buffer = true;
                self.news.input = true;
            }
            self.surface.go_on(&self.connection)?;
            self.connection.flush()?;
            self.news.more = left == 0;
            if !any || left == 0 {
                return Ok(());
            }
        }
    }

    /// The input for one pass: time, screen, scale, focus, events. Events may be left for another
    /// pass; they then count as new input.
    pub fn take_input(&mut self) -> egui::RawInput {
        let events = first_deed(&mut self.events);
        self.news.input |= !self.events.is_empty();
        let points = |pixels: u32| pixels as f32 / self.scale;
        let size = Vec2::new(points(self.size.0), points(self.size.1));
        let screen = self.connection.screen();
        let screen = [screen.width_in_pixels, screen.height_in_pixels];
        let viewport = ViewportInfo {
            native_pixels_per_point: Some(self.scale),
            monitor_size: Some(Vec2::from(screen.map(|side| points(side.into())))),
            focused: Some(self.focus.told),
            occluded: Some(!self.visible()),
            ..ViewportInfo::default()
        };
        egui::RawInput {
            viewports: std::iter::once((egui::ViewportId::ROOT, viewport)).collect(),
            screen_rect: Some(Rect::from_min_size(Pos2::ZERO, size)),
            max_texture_side: Some(TEXTURE_SIDE),
            time: Some(self.opened.elapsed().as_secs_f64()),
            focused: self.focus.told,
            system_theme: self.settings.asked().dark.map(|dark| match dark {
                true => egui::Theme::Dark,
                false => egui::Theme::Light,
            }),
            events,
            dropped_files: self.drops.take(),
            ..egui::RawInput::default()
        }
    }

    /// Whether the desktop asks for no animations.
    #[must_use]
    pub fn still(&self) -> bool {
        self.settings.asked().still
    }

    /// When to call [`Window::poll`] even if the connection stays quiet: a clipboard transfer times
    /// out, or the focus is to be checked.
    pub fn deadline(&self) -> Option<Instant> {
        let due = [
            self.clipboard.deadline(),
            self.drops.deadline(),
            self.focus_check(),
        ];
        due.into_iter().flatten().min()
    }

    /// The pixels to paint into; `None` while a frame is in flight, while the window is not visible
    /// or waits for a buffer of another size, or if the connection is lost. Ask again after
    /// [`PollResult::shown`] or [`PollResult::new_buffer`].
    pub fn target(&mut self) -> Option<Target<'_>> {
        let fits = self.surface.size() == self.size;
        if !self.visible() || !fits || self.lost.is_some() {
            return None;
        }
        self.surface.target()
    }

    /// Shows these areas of the pixel buffer.
    ///
    /// # Errors
    /// `ErrorKind::Display` if the server or the window is gone.
    pub fn present(&mut self, areas: &[Area]) -> Result<()> {
        self.alive()?;
        let result = self.surface.show(&self.connection, areas);
        self.noted(result)?;
        self.flush()
    }

    /// Carries out egui's requests: cursor, clipboard, primary selection.
    ///
    /// # Errors
    /// `ErrorKind::Display` if the server or the window is gone.
    pub fn take_output(&mut self, output: egui::PlatformOutput) -> Result<()> {
        self.alive()?;
        let result = self.serve(output);
        self.noted(result)?;
        self.flush()
    }

    fn serve(&mut self, output: egui::PlatformOutput) -> Result<()> {
        let (connection, window) = (&self.connection, self.frame.window);
        self.keyboard.set_editing(output.ime.is_some());
        (self.cursors).apply(connection, &self.resources, window, output.cursor_icon)?;
        for command in output.commands {
            let (which, text) = match command {
                egui::OutputCommand::CopyText(text) => (Selection::Clipboard, text),
                egui::OutputCommand::TextSelectionSettled(text) => (Selection::Primary, text),
                _ => continue,
            };
            self.clipboard.own(connection, which, &text, self.time)?;
        }
        // The middle button also drags; it pastes only over text.
        if let Some((time, place)) = self.middle.take()
            && output.mutable_text_under_cursor
        {
            self.paste(Selection::Primary, time, Some(place))?;
        }
        Ok(())
    }

    /// Sets the title.
    ///
    /// # Errors
    /// `ErrorKind::Display` if the server or the window is gone.
    pub fn set_title(&mut self, title: &str) -> Result<()> {
        self.alive()?;
        let result = window::set_title(&self.connection, self.frame.window, title);
        self.noted(result)?;
        self.flush()
    }

    /// Raises the window and asks for the keyboard focus.
    ///
    /// # Errors
    /// `ErrorKind::Display` if the server or the window is gone.
    pub fn raise(&mut self) -> Result<()> {
        self.alive()?;
        let result = self
            .top_level()
            .and_then(|top| window::raise(&self.connection, self.frame.window, top, self.time));
        self.noted(result)?;
        self.flush()
    }

    /// Sends as much queued output as the socket takes; the descriptor becomes readable when it
    /// takes more.
    ///
    /// # Errors
    /// `ErrorKind::Display` if the server or the window is gone.
    pub fn flush(&mut self) -> Result<()> {
        self.alive()?;
        let result = self.connection.flush();
        self.noted(result)
    }

    /// Requests the clipboard's text, as the keys do; it arrives as input.
    ///
    /// # Errors
    /// `ErrorKind::Display` if the server or the window is gone.
    pub fn ask_for_clipboard(&mut self) -> Result<()> {
        self.alive()?;
        let result = self.paste(Selection::Clipboard, self.time, None);
        self.noted(result)?;
        // Our own text arrives at once.
        self.news.input |= !self.events.is_empty();
        self.flush()
    }

    /// Requests the text of a selection, which may be our own.
    fn paste(&mut self, which: Selection, time: u32, place: Option<Pos2>) -> Result<()> {
        let out = &mut self.events;
        self.clipboard
            .request(&self.connection, which, time, place, out)
    }

    fn visible(&self) -> bool {
        self.mapped && !self.covered
    }

    fn alive(&self) -> Result<()> {
        match &self.lost {
            Some(error) => Err(error.clone()),
            None => Ok(()),
        }
    }

    fn noted<R>(&mut self, result: Result<R>) -> Result<R> {
        if let Err(error) = &result {
            self.lost = Some(error.clone());
        }
        result
    }
}

/// Takes the events up to the first completed key press or click: egui sees at most one of each per
/// pass and would lose the first of two. Text before it gets a separate pass, because a Tab or
/// click moves the focus, and the next field would also receive the text. So does a motion before a
/// release: a drag that has stopped no longer moves what it held. If very many events are queued,
/// all are taken.
fn first_deed(events: &mut Vec<egui::Event>) -> Vec<egui::Event> {
    use egui::Event::{Copy, Cut, Key, Paste, PointerButton, PointerMoved, Text};
    if events.len() > MOST_EVENTS {
        return std::mem::take(events);
    }
    let (mut written, mut moved) = (false, false);
    let mut end = events.len();
    for (at, event) in events.iter().enumerate() {
        let (begins, ends) = match event {
            Text(_) => {
                written = true;
                (false, false)
            }
            // A key press that produces text need not end the pass.
            Key {
                pressed, repeat, ..
            } => {
                let writes = matches!(events.get(at + 1), Some(Text(_)));
                let deed = *pressed && !writes;
                (deed, deed && !repeat)
            }
            PointerMoved(_) => {
                moved = true;
                (false, false)
            }
            PointerButton { pressed, .. } => {
                if moved && !pressed {
                    end = at;
                    break;
                }
                moved = false;
                (*pressed, !pressed)
            }
            Copy | Cut | Paste(_) => (true, true),
            _ => (false, false),
        };
        if begins && written {
            end = at;
            break;
        }
        if ends {
            end = at + 1;
            break;
        }
    }
    let rest = events.split_off(end);
    std::mem::replace(events, rest)
}

impl Drop for Window {
    /// Hands copied text to the clipboard manager; closing the connection frees the rest.
    fn drop(&mut self) {
        if self.lost.is_none() {
            self.clipboard.hand_over(&self.connection, HAND_OVER).ok();
        }
        self.close_pane().ok();
    }
}

impl AsFd for Window {
    /// Readable when [`Window::poll`] has something to do.
    fn as_fd(&self) -> BorrowedFd<'_> {
        self.connection.as_fd()
    }
}
