//! Cursor shapes: from the user's theme, or else the X server's cursor font; loaded at first use.

use std::panic::{AssertUnwindSafe, catch_unwind};

use egui::CursorIcon;
use x11rb::NONE;
use x11rb::connection::Connection as _;
use x11rb::cursor::Handle;
use x11rb::protocol::xproto::{
    ChangeWindowAttributesAux, ConnectionExt as _, CreateGCAux, Cursor, Rectangle, Window,
};
use x11rb::resource_manager::Database;

use super::connection::Connection;
use crate::error::Result;

#[derive(Default)]
pub(super) struct Cursors {
    /// The theme's loader; outer `None` if not requested yet, inner if unavailable.
    theme: Option<Option<Handle>>,
    loaded: Vec<(CursorIcon, Cursor)>,
    shown: Option<CursorIcon>,
}

impl Cursors {
    pub(super) fn new() -> Self {
        Self::default()
    }

    /// Sets a window's shape; the X resources name the theme and its size.
    pub(super) fn apply(
        &mut self,
        connection: &Connection,
        resources: &Database,
        window: Window,
        icon: CursorIcon,
    ) -> Result<()> {
        if self.shown == Some(icon) {
            return Ok(());
        }
        let cursor = self.cursor(connection, resources, icon)?;
        let aux = ChangeWindowAttributesAux::new().cursor(cursor);
        connection.sent_quietly(connection.change_window_attributes(window, &aux))?;
        self.shown = Some(icon);
        Ok(())
    }

    fn cursor(
        &mut self,
        connection: &Connection,
        resources: &Database,
        icon: CursorIcon,
    ) -> Result<Cursor> {
        if let Some((_, cursor)) = self.loaded.iter().find(|(known, _)| *known == icon) {
            return Ok(*cursor);
        }
        let cursor = match icon {
            CursorIcon::None => invisible(connection)?,
            _ => match self.themed(connection, resources, icon)? {
                NONE => from_font(connection, glyph(icon))?,
                cursor => cursor,
            },
        };
        self.loaded.push((icon, cursor));
        Ok(cursor)
    }

    /// The theme's shape; [`NONE`] if the theme lacks it.
    fn themed(
        &mut self,
        connection: &Connection,
        resources: &Database,
        icon: CursorIcon,
    ) -> Result<Cursor> {
        if self.theme.is_none() {
            let ask = || {
                let asked = Handle::new(&**connection, connection.screen_number(), resources);
                asked.map_err(Into::into).and_then(|asked| asked.reply())
            };
            self.theme = Some(match sound(ask) {
                Some(handle) => connection.excuse(handle)?,
                None => None,
            });
        }
        let Some(Some(handle)) = &self.theme else {
            return Ok(NONE);
        };
        for name in names(icon) {
            let Some(loaded) = sound(|| handle.load_cursor(&**connection, name)) else {
                return Ok(NONE);
            };
            match connection.excuse(loaded)? {
                None | Some(NONE) => {}
                Some(cursor) => return Ok(cursor),
            }
        }
        Ok(NONE)
    }
}

/// Catches panics: theme files can be malformed, and x11rb takes some server features for granted.
fn sound<T>(work: impl FnOnce() -> T) -> Option<T> {
    catch_unwind(AssertUnwindSafe(work)).ok()
}

/// A shape of the cursor font, which every server has.
fn from_font(connection: &Connection, glyph: u16) -> Result<Cursor> {
    let (Some(font), Some(cursor)) = (
        connection.excuse(connection.generate_id())?,
        connection.excuse(connection.generate_id())?,
    ) else {
        return Ok(NONE);
    };
    const WHITE: u16 = u16::MAX;
    connection.sent_quietly(connection.open_font(font, b"cursor"))?;
    // A glyph's mask is the next glyph.
    let mask = glyph + 1;
    let made = connection.done(connection.create_glyph_cursor(
        cursor, font, font, glyph, mask, 0, 0, 0, WHITE, WHITE, WHITE,
    ))?;
    connection.sent_quietly(connection.close_font(font))?;
    Ok(if made { cursor } else { NONE })
}

fn invisible(connection: &Connection) -> Result<Cursor> {
    let (Some(pixmap), Some(cursor)) = (
        connection.excuse(connection.generate_id())?,
        connection.excuse(connection.generate_id())?,
    ) else {
        return Ok(NONE);
    };
    let root = connection.screen().root;
    connection.sent_quietly(connection.create_pixmap(1, pixmap, root, 1, 1))?;
    let Some(gc) = connection.excuse(connection.generate_id())? else {
        return Ok(NONE);
    };
    let black = CreateGCAux::new().foreground(0);
    connection.sent_quietly(connection.create_gc(gc, pixmap, &black))?;
    let whole = Rectangle {
        x: 0,
        y: 0,
        width: 1,
        height: 1,
    };
    connection.sent_quietly(connection.poly_fill_rectangle(pixmap, gc, &[whole]))?;
    let made = connection.create_cursor(cursor, pixmap, pixmap, 0, 0, 0, 0, 0, 0, 0, 0);
    let made = connection.done(made)?;
    connection.sent_quietly(connection.free_gc(gc))?;
    connection.sent_quietly(connection.free_pixmap(pixmap))?;
    Ok(if made { cursor } else { NONE })
}

/// A shape's names in themes: CSS names first, then those of the cursor font.
fn names(icon: CursorIcon) -> &'static [&'static str] {
    match icon {
        CursorIcon::Default | CursorIcon::None => &["default", "left_ptr"],
        CursorIcon::ContextMenu => &["context-menu", "left_ptr"],
        CursorIcon::Help => &["help", "question_arrow"],
        CursorIcon::PointingHand => &["pointer", "hand2", "hand1"],
        CursorIcon::Progress => &["progress", "left_ptr_watch", "watch"],
        CursorIcon::Wait => &["wait", "watch"],
        CursorIcon::Cell => &["cell", "plus"],
        CursorIcon::Crosshair => &["crosshair", "cross"],
        CursorIcon::Text => &["text", "xterm"],
        CursorIcon::VerticalText => &["vertical-text", "xterm"],
        CursorIcon::Alias => &["alias", "link"],
        CursorIcon::Copy => &["copy"],
        CursorIcon::Move => &["move", "fleur"],
        CursorIcon::NoDrop => &["no-drop", "circle"],
        CursorIcon::NotAllowed => &["not-allowed", "crossed_circle", "circle"],
        CursorIcon::Grab => &["grab", "openhand", "hand1"],
        CursorIcon::Grabbing => &["grabbing", "closedhand", "fleur"],
        CursorIcon::AllScroll => &["all-scroll", "fleur"],
        CursorIcon::ResizeHorizontal => &["ew-resize", "sb_h_double_arrow"],
        CursorIcon::ResizeNeSw => &["nesw-resize", "fd_double_arrow"],
        CursorIcon::ResizeNwSe => &["nwse-resize", "bd_double_arrow"],
        CursorIcon::ResizeVertical => &["ns-resize", "sb_v_double_arrow"],
        CursorIcon::ResizeEast => &["e-resize", "right_side"],
        CursorIcon::ResizeSouthEast => &["se-resize", "bottom_right_corner"],
        CursorIcon::ResizeSouth => &["s-resize", "bottom_side"],
        CursorIcon::ResizeSouthWest => &["sw-resize", "bottom_left_corner"],
        CursorIcon::ResizeWest => &["w-resize", "left_side"],
        CursorIcon::ResizeNorthWest => &["nw-resize", "top_left_corner"],
        CursorIcon::ResizeNorth => &["n-resize", "top_side"],
        CursorIcon::ResizeNorthEast => &["ne-resize", "top_right_corner"],
        CursorIcon::ResizeColumn => &["col-resize", "split_h", "sb_h_double_arrow"],
        CursorIcon::ResizeRow => &["row-resize", "split_v", "sb_v_double_arrow"],
        CursorIcon::ZoomIn => &["zoom-in"],
        CursorIcon::ZoomOut => &["zoom-out"],
    }
}

/// A shape's glyph in the cursor font (`X11/cursorfont.h`).
fn glyph(icon: CursorIcon) -> u16 {
    match icon {
        CursorIcon::Default | CursorIcon::None | CursorIcon::ContextMenu => 68, // left_ptr
        CursorIcon::Help => 92,                                                 // question_arrow
        CursorIcon::PointingHand => 60,                                         // hand2
        CursorIcon::Progress | CursorIcon::Wait => 150,                         // watch
        CursorIcon::Cell | CursorIcon::Copy => 90,                              // plus
        CursorIcon::Crosshair | CursorIcon::ZoomIn | CursorIcon::ZoomOut => 34, // crosshair
        CursorIcon::Text | CursorIcon::VerticalText => 152,                     // xterm
        CursorIcon::Alias => 50,                                                // exchange
        CursorIcon::Move | CursorIcon::Grabbing | CursorIcon::AllScroll => 52,  // fleur
        CursorIcon::Grab => 58,                                                 // hand1
        CursorIcon::NoDrop | CursorIcon::NotAllowed => 24,                      // circle
        CursorIcon::ResizeHorizontal | CursorIcon::ResizeColumn => 108,         // sb_h_double_arrow
        CursorIcon::ResizeVertical | CursorIcon::ResizeRow => 116,              // sb_v_double_arrow
        CursorIcon::ResizeNeSw | CursorIcon::ResizeNorthEast => 136,            // top_right_corner
        CursorIcon::ResizeNwSe | CursorIcon::ResizeSouthEast => 14, // bottom_right_corner
        CursorIcon::ResizeSouthWest => 12,                          // bottom_left_corner
        CursorIcon::ResizeNorthWest => 134,                         // top_left_corner
        CursorIcon::ResizeEast => 96,                               // right_side
        CursorIcon::ResizeWest => 70,                               // left_side
        CursorIcon::ResizeNorth => 138,                             // top_side
        CursorIcon::ResizeSouth => 16,                              // bottom_side
    }
}
