//! Dispatch of the server's events.

use egui::{Pos2, pos2};
use x11rb::protocol::ErrorKind;
use x11rb::protocol::Event;
use x11rb::protocol::xproto::{
    ButtonPressEvent, ClientMessageEvent, ConfigureNotifyEvent, EnterNotifyEvent, ExposeEvent,
    FocusInEvent, NotifyDetail, NotifyMode, Property, Visibility,
};
use x11rb::x11_utils::X11Error;

use super::packets::SENT;
use super::present::Surface;
use super::state::Window;
use super::{scale, window};
use crate::error::{Error, Result};
use vides_engine::inject;
use vides_raster::Area;

impl Window {
    /// Handles one event and ignores those of other windows. Any client can send events, so their
    /// contents are not trusted.
    pub(super) fn handle(&mut self, event: &Event) -> Result<()> {
        inject::point(inject::Place::Event);
        if let Event::KeyPress(event) | Event::KeyRelease(event) = event {
            self.time = event.time;
        }
        let (connection, out) = (&self.connection, &mut self.events);
        if self.keyboard.handle(connection, event, out)?
            || self.clipboard.handle(connection, event, out)?
        {
            return Ok(());
        }
        let ours = self.frame.window;
        self.news.input |= self.drops.handle(connection, ours, event)?;
        self.pane_event(event)?;
        self.home_event(event)?;
        match event {
            Event::MotionNotify(event) if event.event == ours => {
                self.time = event.time;
                let pos = self.moved(event.event_x, event.event_y);
                self.pointer.moved(pos, &mut self.events);
            }
            Event::ButtonPress(event) if event.event == ours => {
                self.button(event, true);
                self.claim_focus()?;
            }
            Event::ButtonRelease(event) if event.event == ours => self.button(event, false),
            Event::EnterNotify(event) if event.event == ours => self.crossed(event, true)?,
            Event::LeaveNotify(event) if event.event == ours => self.crossed(event, false)?,
            Event::FocusIn(event) if event.event == ours => self.focus(event, true)?,
            Event::FocusOut(event) if event.event == ours => self.focus(event, false)?,
            Event::Expose(event) if event.window == ours => self.expose(event)?,
            Event::ConfigureNotify(event) if event.window == ours => self.configured(event),
            Event::MapNotify(event) if event.window == ours => {
                self.mapped = true;
                self.covered = false;
                self.news.shown = true;
            }
            Event::UnmapNotify(event) if event.window == ours => {
                self.mapped = false;
                let (pos, modifiers) = (self.pos, self.keyboard.modifiers());
                self.pointer.lost(pos, modifiers, &mut self.events);
                self.keyboard.leave(&self.connection, &mut self.events)?;
            }
            Event::VisibilityNotify(event) if event.window == ours => {
                self.covered = event.state == Visibility::FULLY_OBSCURED;
                self.news.shown |= !self.covered;
            }
            Event::DestroyNotify(event) if event.window == ours => {
                return Err(Error::Destroyed);
            }
            Event::PropertyNotify(event) if self.settings.note(&self.connection, event) => {}
            Event::PropertyNotify(event) => {
                let resources = u32::from(x11rb::protocol::xproto::AtomEnum::RESOURCE_MANAGER);
                let root = scale::root(&self.connection);
                if event.window == root
                    && event.atom == resources
                    && event.state == Property::NEW_VALUE
                {
                    self.rescale()?;
                }
            }
            Event::ClientMessage(event) if event.window == ours => self.message(event)?,
            Event::ClientMessage(event) => self.settings.announced(&self.connection, event),
            Event::ShmCompletion(event) => {
                self.news.shown |= self.surface.completed(event);
            }
            Event::Error(error) => self.complaint(error)?,
            _ => {}
        }
        Ok(())
    }

    fn moved(&mut self, x: i16, y: i16) -> Pos2 {
        self.pos = pos2(f32::from(x) / self.scale, f32::from(y) / self.scale);
        self.pos
    }

    fn button(&mut self, event: &ButtonPressEvent, pressed: bool) {
        self.time = event.time;
        let pos = self.moved(event.event_x, event.event_y);
        let modifiers = self.keyboard.modifiers();
        let out = &mut self.events;
        self.pointer
            .button(event.detail, pressed, pos, modifiers, out);
        const MIDDLE: u8 = 2;
        if event.detail == MIDDLE && pressed {
            self.middle = Some((event.time, pos));
        }
    }

    fn crossed(&mut self, event: &EnterNotifyEvent, enters: bool) -> Result<()> {
        if event.detail == NotifyDetail::INFERIOR {
            return Ok(());
        }
        self.time = event.time;
        let pos = self.moved(event.event_x, event.event_y);
        if enters {
            self.pointer.entered(pos, &mut self.events);
        } else {
            self.stop_claiming_focus();
            self.pointer.left(&mut self.events);
        }
        // Without a focused window, keys go to the one under the pointer.
        const HAS_FOCUS: u8 = 1;
        let focused = event.same_screen_focus & HAS_FOCUS != 0;
        self.focus.by_pointer = enters && focused;
        self.tell_focus()
    }

    fn focus(&mut self, event: &FocusInEvent, gained: bool) -> Result<()> {
        // A grab takes the keys only for a short time, which `Keyboard` handles; the widgets keep
        // the focus.
        if matches!(event.mode, NotifyMode::GRAB | NotifyMode::UNGRAB) {
            return Ok(());
        }
        match event.detail {
            NotifyDetail::POINTER => self.focus.by_pointer = gained,
            NotifyDetail::POINTER_ROOT | NotifyDetail::NONE => {}
            _ => self.focus.own = gained,
        }
        self.tell_focus()
    }

    fn tell_focus(&mut self) -> Result<()> {
        let focused = self.focus.own || self.focus.by_pointer;
        if focused != self.focus.told {
            self.focus.told = focused;
            self.events.push(egui::Event::WindowFocused(focused));
            if !focused {
                self.keyboard.leave(&self.connection, &mut self.events)?;
            }
        }
        Ok(())
    }

    fn expose(&mut self, event: &ExposeEvent) -> Result<()> {
        let area = Area {
            x: event.x.into(),
            y: event.y.into(),
            width: event.width.into(),
            height: event.height.into(),
        };
        self.surface.show(&self.connection, &[area])
    }

    fn configured(&mut self, event: &ConfigureNotifyEvent) {
        // Events sent by a window manager only give the position; the server reports every size.
        if event.response_type & SENT == 0 {
            let size = Surface::fitting(event.width.into(), event.height.into());
            self.news.input |= size != self.size;
            self.size = size;
        }
    }

    /// The X resources changed, and with them perhaps the resolution.
    fn rescale(&mut self) -> Result<()> {
        let Some(resources) = scale::ask(&self.connection)? else {
            return Ok(());
        };
        self.resources = resources;
        let scale = scale::of(&self.resources);
        if scale != self.scale {
            let pixels = self.pos * self.scale;
            self.scale = scale;
            self.pos = pixels / scale;
            self.news.input = true;
            let (connection, window) = (&self.connection, self.frame.window);
            window::set_sizes(connection, window, self.smallest, scale, self.size)?;
        }
        Ok(())
    }

    fn message(&mut self, event: &ClientMessageEvent) -> Result<()> {
        if event.format != 32 {
            return Ok(());
        }
        let atoms = self.connection.atoms();
        let data = event.data.as_data32();
        if event.type_ == atoms._VIDES_SHOWN {
            self.news.shown |= self.surface.arrived(&self.connection, data[0])?;
        } else if event.type_ == atoms.WM_PROTOCOLS {
            if data[0] == atoms.WM_DELETE_WINDOW {
                self.news.close = true;
            } else if data[0] == atoms._NET_WM_PING {
                window::answer_ping(&self.connection, event)?;
            }
        } else {
            let (connection, ours) = (&self.connection, self.frame.window);
            self.drops.message(connection, ours, event)?;
        }
        Ok(())
    }

    /// An error from the server. It ends the window only if our window no longer exists.
    fn complaint(&mut self, error: &X11Error) -> Result<()> {
        let ours = error.bad_value == self.frame.window;
        if ours && matches!(error.error_kind, ErrorKind::Window | ErrorKind::Drawable) {
            return Err(Error::Destroyed);
        }
        self.news.shown |= self.surface.failed(&self.connection, error)?;
        Ok(())
    }
}
