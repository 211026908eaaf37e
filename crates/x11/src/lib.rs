//! One window on an X server: its connection, its input as egui wants it, its
//! pixels on the screen, the clipboard.
//!
//! Why not Xlib: it ends the process when the server goes away, and a host may
//! have an Xlib of its own with an error handler of its own. This speaks the
//! protocol itself (x11rb). Each window has its own connection, so that what
//! happens to one concerns no other. Nothing here blocks for longer than a
//! stated time, raises a signal, or ends the process; if the server goes away
//! every call says `ErrorKind::Display`.
//!
//! It knows nothing of what the window shows, and nothing of C.

mod areas;
mod atoms;
mod clipboard;
mod compose;
mod connect;
mod connection;
mod core_keymap;
mod cursor;
mod embedded;
mod error;
mod events;
mod icon;
mod incoming;
mod keyboard;
mod keymap;
mod keys;
mod outgoing;
mod pane;
mod pane_pool;
mod pixels;
mod pointer;
mod present;
mod scale;
mod settings;
mod shared;
mod stream;
mod visual;
mod window;

#[cfg(test)]
mod clipboard_hostile_tests;
#[cfg(test)]
mod clipboard_tests;
#[cfg(test)]
mod input_tests;
#[cfg(test)]
mod keyboard_tests;
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
use x11rb::connection::{Connection as _, RequestConnection as _};
use x11rb::protocol::xproto::ImageOrder;
use x11rb::resource_manager::Database;

use vides_engine::{inject, limits};
use vides_raster as raster;

use crate::raster::{Area, Target};
use clipboard::{Clipboard, Selection};
pub use connect::without_signals;
use connection::Connection;
use cursor::Cursors;
use embedded::Home;
pub use error::{Cause, Error, Result};
use keyboard::Keyboard;
use pane::Pane;
pub use pane::{PanePlace, PaneWindow};
use pixels::Layout;
use pointer::Pointer;
use present::Surface;
use settings::Settings;
use window::Frame;

/// The largest texture that the painter is given, pixels a side.
const TEXTURE_SIDE: usize = 2048;

/// Events that are handled in one look. A client that sends without an end
/// shall keep neither the host nor the other windows.
const MOST_EVENTS: usize = 256;

/// How long a clipboard manager is waited for when the window closes.
const HAND_OVER: Duration = Duration::from_millis(300);

/// How a window is to be opened.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// The display's name; the environment's `DISPLAY` if none.
    pub display: Option<String>,
    /// The title; UTF-8.
    pub title: String,
    /// The program's name, for WM_CLASS; "vides" if it is empty.
    pub application: String,
    /// Wanted inner size in points (pixels at 96 dots per inch).
    pub size: [f32; 2],
    /// Smallest useful inner size in points.
    pub smallest: [f32; 2],
    /// A window of the host's to live in, which it fills then; none: a top-level window.
    pub parent: Option<u32>,
    /// The host's window that it belongs to.
    pub transient_for: Option<u32>,
}

/// What happened since the last look, beside input for egui.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct News {
    /// There is input, or the size or the scale changed: egui should run.
    pub input: bool,
    /// The pointer moved, and nothing else: egui may run a little later, and take
    /// several motions at once.
    pub motion: bool,
    /// The user or the window manager wants the window to be closed.
    pub close: bool,
    /// The frame that was in flight has arrived: another may be shown.
    pub shown: bool,
    /// The buffer of pixels is another one (size): paint it whole.
    pub new_buffer: bool,
    /// Not all that has arrived was looked at: look again soon, whatever the
    /// descriptor says.
    pub more: bool,
}

/// An open window. Dropping it closes the window and the connection.
pub struct Window {
    connection: Connection,
    frame: Frame,
    surface: Surface,
    pointer: Pointer,
    keyboard: Keyboard,
    clipboard: Clipboard,
    cursors: Cursors,
    /// The desktop's settings: the server's resources.
    resources: Database,
    /// Those of its settings manager.
    settings: Settings,
    /// Where it lives, if that is in another window.
    home: Option<Home>,
    /// What the host draws in.
    pane: Option<Pane>,
    /// When and where the middle button was pressed, until egui has said whether
    /// there is a text.
    middle: Option<(u32, Pos2)>,
    /// Where the pointer was last, in points.
    pos: Pos2,
    /// Pixels for a point.
    scale: f32,
    /// The smallest useful size in points.
    smallest: [f32; 2],
    /// The window's size in pixels; the buffer follows when it can.
    size: (u32, u32),
    focus: Focus,
    /// It is on the screen, or was iconified.
    mapped: bool,
    /// Nothing of it is to be seen.
    covered: bool,
    /// When the user last did something, by the server's clock, milliseconds.
    time: u32,
    /// What egui has not taken yet.
    events: Vec<egui::Event>,
    news: News,
    opened: Instant,
    /// Why there is no window any more.
    lost: Option<Error>,
}

/// Who gives the window the keyboard.
#[derive(Clone, Copy, Debug, Default)]
struct Focus {
    /// It was given to the window.
    own: bool,
    /// It belongs to the window under the pointer, and this is it.
    by_pointer: bool,
    told: bool,
}

impl Window {
    /// Connects and opens a window. Waits for the server's answers, but at
    /// most a few seconds in all.
    ///
    /// # Errors
    /// `ErrorKind::Display` with a sentence that names the display and the reason;
    /// `ErrorKind::Argument` if one of the windows that are named is none.
    pub fn open(options: &Options) -> Result<Self> {
        let connection = Connection::open(options.display.as_deref())?;
        let setup = connection.setup();
        let visual = visual::choose(setup, connection.screen())
            .ok_or_else(|| connection.unfit(Cause::NoTrueColour))?;
        let layout = Layout::new(&visual, setup.image_byte_order == ImageOrder::MSB_FIRST);
        connection.maximum_request_bytes(); // asked for long ago; now it is known
        window::watch_desktop(&connection)?;
        let resources = scale::ask(&connection)?.unwrap_or_default();
        let scale = scale::of(&resources);
        let settings = Settings::ask(&connection)?;
        let home = match options.parent {
            None => None,
            Some(parent) => Some(Home::enter(&connection, parent)?),
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
            news: News {
                input: true,
                ..News::default()
            },
            opened: Instant::now(),
            lost: None,
        };
        window.flush()?;
        Ok(window)
    }

    /// Reads and handles what has arrived, a fair share of it at once; never
    /// blocks. Answers the server's questions (ping, selections, exposures)
    /// itself.
    ///
    /// # Errors
    /// `ErrorKind::Display` if the server or the window is gone.
    pub fn poll(&mut self) -> Result<News> {
        self.alive()?;
        let before = self.events.len();
        let result = self.drain();
        self.noted(result)?;
        let mut news = std::mem::take(&mut self.news);
        let added = self.events.get(before..).unwrap_or_default();
        let is_motion = |event: &egui::Event| matches!(event, egui::Event::PointerMoved(_));
        news.motion |= added.iter().any(is_motion);
        news.input |= !added.iter().all(is_motion);
        // What was covered meanwhile may be on its way once more.
        news.shown &= self.surface.is_free();
        Ok(news)
    }

    fn drain(&mut self) -> Result<()> {
        let now = Instant::now();
        self.clipboard.tick(&self.connection, now)?;
        self.look_for_keyboard(now)?;
        let pushed = self.connection.stream().push();
        pushed.map_err(|error| {
            self.connection
                .lost(x11rb::errors::ConnectionError::from(error))
        })?;
        // Handling an event may wait for an answer, and that may bring further
        // events whose arrival the descriptor does not show any more.
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
            self.send()?;
            self.news.more = left == 0;
            if !any || left == 0 {
                return Ok(());
            }
        }
    }

    /// The input for one pass: time, screen, scale, focus, events. After a
    /// window was not served for a while that may not be all of it; the rest is
    /// new input then.
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
            system_theme: self.settings.dark().map(|dark| match dark {
                true => egui::Theme::Dark,
                false => egui::Theme::Light,
            }),
            events,
            ..egui::RawInput::default()
        }
    }

    /// When to [`Window::poll`] even if the connection stays quiet: a transfer
    /// of the clipboard is to be given up then, or the keyboard to be looked for.
    pub fn deadline(&self) -> Option<Instant> {
        let due = [self.clipboard.deadline(), self.keyboard_look()];
        due.into_iter().flatten().min()
    }

    /// The pixels to paint into; `None` while a frame is in flight, or when
    /// the window is not visible. [`News::shown`] tells when to ask again.
    pub fn target(&mut self) -> Option<Target<'_>> {
        let fits = self.surface.size() == self.size;
        if !self.visible() || !fits || self.lost.is_some() {
            return None;
        }
        self.surface.target()
    }

    /// Shows these areas of the pixels.
    ///
    /// # Errors
    /// `ErrorKind::Display` if the server or the window is gone.
    pub fn present(&mut self, areas: &[Area]) -> Result<()> {
        self.alive()?;
        let result = self.surface.show(&self.connection, areas);
        self.noted(result)?;
        self.flush()
    }

    /// Does what egui wants done outside: cursor, clipboard, primary selection.
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
        // The button also drags; only over a text does it paste.
        if let Some((time, place)) = self.middle.take()
            && output.mutable_text_under_cursor
        {
            self.paste(Selection::Primary, time, Some(place))?;
        }
        Ok(())
    }

    /// Another title.
    ///
    /// # Errors
    /// `ErrorKind::Display` if the server or the window is gone.
    pub fn set_title(&mut self, title: &str) -> Result<()> {
        self.alive()?;
        let result = window::set_title(&self.connection, self.frame.window, title);
        self.noted(result)?;
        self.flush()
    }

    /// To the front, with the keyboard.
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

    /// Sends what is still waiting to be sent, as far as it goes now; the
    /// descriptor becomes readable when more goes.
    ///
    /// # Errors
    /// `ErrorKind::Display` if the server or the window is gone.
    pub fn flush(&mut self) -> Result<()> {
        self.alive()?;
        let result = self.send();
        self.noted(result)
    }

    fn send(&self) -> Result<()> {
        let sent = self.connection.flush();
        sent.map_err(|error| self.connection.lost(error))
    }

    /// Asks for a text that another program, or this one, offers.
    fn paste(&mut self, which: Selection, time: u32, place: Option<Pos2>) -> Result<()> {
        let out = &mut self.events;
        self.clipboard
            .request(&self.connection, which, time, place, out)
    }

    fn visible(&self) -> bool {
        self.mapped && !self.covered
    }

    /// Nothing is asked of a server that is gone.
    fn alive(&self) -> Result<()> {
        match &self.lost {
            Some(error) => Err(error.clone()),
            None => Ok(()),
        }
    }

    /// Keeps in mind that the window is gone.
    fn noted<R>(&mut self, result: Result<R>) -> Result<R> {
        if let Err(error) = &result {
            self.lost = Some(error.clone());
        }
        result
    }
}

/// Takes the events up to the first thing that the user has done with them, a
/// key or a click: a pass sees one of each only, and of two that come together
/// after a rest the first would be lost. What is written before goes into a pass
/// of its own: a Tab or a click gives the keyboard to another field, and that
/// would get the text too. Takes all where there are very many.
fn first_deed(events: &mut Vec<egui::Event>) -> Vec<egui::Event> {
    use egui::Event::{Copy, Cut, Key, Paste, PointerButton, Text};
    if events.len() > MOST_EVENTS {
        return std::mem::take(events);
    }
    let mut written = false;
    let mut end = events.len();
    for (place, event) in events.iter().enumerate() {
        let (begins, ends) = match event {
            Text(_) => {
                written = true;
                (false, false)
            }
            // A key that writes is one of many, and every one is written.
            Key {
                pressed, repeat, ..
            } => {
                let writes = matches!(events.get(place + 1), Some(Text(_)));
                let deed = *pressed && !writes;
                (deed, deed && !repeat)
            }
            PointerButton { pressed, .. } => (*pressed, !pressed),
            Copy | Cut | Paste(_) => (true, true),
            _ => (false, false),
        };
        if begins && written {
            end = place;
            break;
        }
        if ends {
            end = place + 1;
            break;
        }
    }
    let rest = events.split_off(end);
    std::mem::replace(events, rest)
}

impl Drop for Window {
    /// What was copied here is left with whoever keeps it when programs end.
    /// All else ends with the connection.
    fn drop(&mut self) {
        if self.lost.is_none() {
            self.clipboard.hand_over(&self.connection, HAND_OVER).ok();
        }
        self.close_pane().ok();
    }
}

impl Window {
    /// The connection itself, for questions about it; nobody else reads from it.
    pub fn socket(&self) -> BorrowedFd<'_> {
        self.connection.socket()
    }
}

impl AsFd for Window {
    /// Readable when [`Window::poll`] has something to do.
    fn as_fd(&self) -> BorrowedFd<'_> {
        self.connection.as_fd()
    }
}
