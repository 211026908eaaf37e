//! The state of an open window.

use std::time::Instant;

use egui::Pos2;
use x11rb::resource_manager::Database;

use super::clipboard::Clipboard;
use super::connection::Connection;
use super::cursor::Cursors;
use super::drops::Drops;
use super::embedded::EmbedParent;
use super::error::Error;
use super::keyboard::Keyboard;
use super::pane::Pane;
use super::pointer::Pointer;
use super::present::Surface;
use super::settings::Settings;
use super::window::Frame;

/// What happened since the last poll, apart from input events for egui.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PollResult {
    /// There is input, or the size or scale changed: run egui.
    pub input: bool,
    /// Only the pointer moved: egui may run later and take several motions at once.
    pub motion: bool,
    /// The user or the window manager asked to close the window.
    pub close: bool,
    /// The frame in flight has arrived: another may be shown.
    pub shown: bool,
    /// The pixel buffer was replaced: paint it whole.
    pub new_buffer: bool,
    /// More events are waiting: poll again soon, even if the descriptor is not readable.
    pub more: bool,
}

/// An open window. Dropping it closes the window and the connection.
pub struct Window {
    pub(super) connection: Connection,
    pub(super) frame: Frame,
    pub(super) surface: Surface,
    pub(super) pointer: Pointer,
    pub(super) keyboard: Keyboard,
    pub(super) clipboard: Clipboard,
    pub(super) drops: Drops,
    pub(super) cursors: Cursors,
    /// The X resources.
    pub(super) resources: Database,
    /// The XSETTINGS manager's settings.
    pub(super) settings: Settings,
    pub(super) home: Option<EmbedParent>,
    pub(super) pane: Option<Pane>,
    /// Time and place of a middle click, until egui reports whether it was over editable text.
    pub(super) middle: Option<(u32, Pos2)>,
    /// The last pointer position, in points.
    pub(super) pos: Pos2,
    /// Pixels per point.
    pub(super) scale: f32,
    /// The minimum size in points.
    pub(super) smallest: [f32; 2],
    /// The window's size in pixels; the buffer follows when no frame is in flight.
    pub(super) size: (u32, u32),
    pub(super) focus: Focus,
    pub(super) mapped: bool,
    /// Fully obscured by other windows.
    pub(super) covered: bool,
    /// The server time of the last user action, in milliseconds.
    pub(super) time: u32,
    pub(super) events: Vec<egui::Event>,
    pub(super) news: PollResult,
    pub(super) opened: Instant,
    /// Why the window is gone.
    pub(super) lost: Option<Error>,
}

#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Focus {
    /// The window itself has the keyboard focus.
    pub(super) own: bool,
    /// The focus follows the pointer, which is in this window.
    pub(super) by_pointer: bool,
    pub(super) told: bool,
}
