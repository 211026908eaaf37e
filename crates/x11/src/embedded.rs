//! A window that lives in one of the host's: it fills that, and takes the keyboard
//! when it is clicked, for no window manager gives it to a child.

use std::time::{Duration, Instant};

use x11rb::protocol::Event;
use x11rb::protocol::xproto::{
    AtomEnum, ChangeWindowAttributesAux, ConfigureWindowAux, ConnectionExt as _, EventMask,
    InputFocus, WindowClass,
};

use super::Window;
use super::connection::Connection;
use super::events::SENT;
use crate::error::{Error, Result};

/// A toolkit that finds the keyboard gone may take it back (GTK 3 does): after so long
/// we look again …
const LOOK_AGAIN: Duration = Duration::from_millis(60);

/// … and so often.
const LOOKS: u32 = 4;

/// Windows between a child and the host's top-level one.
const MOST_ANCESTORS: usize = 64;

/// Where a window lives.
pub(super) struct Home {
    parent: u32,
    /// When to look who has the keyboard, and how often yet.
    look: Option<(Instant, u32)>,
}

impl Home {
    /// Looks at a window of the host's and listens to its size, which is given back.
    ///
    /// # Errors
    /// `ErrorKind::Argument`: there is no such window, or nothing can live in it.
    pub(super) fn enter(connection: &Connection, parent: u32) -> Result<(Self, (u32, u32))> {
        let unfit = |why| Error::Parent {
            parent,
            display: connection.display().into(),
            why,
        };
        let attributes = connection.answer(connection.get_window_attributes(parent))?;
        let attributes = attributes.ok_or_else(|| unfit("does not exist"))?;
        if attributes.class != WindowClass::INPUT_OUTPUT {
            return Err(unfit("shows nothing: it takes input only"));
        }
        let root = connection.screen().root;
        if parent == root {
            return Err(unfit("is the root window"));
        }
        // Listened to first, so that no size is missed.
        let listen = ChangeWindowAttributesAux::new().event_mask(EventMask::STRUCTURE_NOTIFY);
        let asked = connection.change_window_attributes(parent, &listen);
        asked.map_err(|error| connection.lost(error))?;
        let geometry = connection.answer(connection.get_geometry(parent))?;
        let geometry = geometry.ok_or_else(|| unfit("does not exist"))?;
        if geometry.root != root {
            return Err(unfit("is on another screen"));
        }
        let home = Self { parent, look: None };
        Ok((home, (geometry.width.into(), geometry.height.into())))
    }

    /// The window in which ours is a child.
    pub(super) fn parent(&self) -> u32 {
        self.parent
    }
}

impl Window {
    /// Follows the host's window.
    pub(super) fn home_event(&mut self, event: &Event) -> Result<()> {
        let (connection, ours) = (&self.connection, self.frame.window);
        let Some(home) = &mut self.home else {
            return Ok(());
        };
        let size = match event {
            Event::ConfigureNotify(event)
                if event.window == home.parent && event.response_type & SENT == 0 =>
            {
                (event.width.into(), event.height.into())
            }
            Event::ReparentNotify(event)
                if event.window == ours
                    && event.parent != home.parent
                    && event.response_type & SENT == 0 =>
            {
                let (new, size) =
                    Home::enter(connection, event.parent).map_err(|_| Error::PutOut)?;
                *home = new;
                size
            }
            _ => return Ok(()),
        };
        let fill = ConfigureWindowAux::new().width(size.0).height(size.1);
        let asked = connection.configure_window(ours, &fill);
        asked.map(drop).map_err(|error| connection.lost(error))
    }

    /// The window was clicked: the keyboard is to be its own.
    pub(super) fn claim_keyboard(&mut self) -> Result<()> {
        let Some(home) = &mut self.home else {
            return Ok(());
        };
        home.look = Some((Instant::now() + LOOK_AGAIN, LOOKS));
        self.take_keyboard(self.time)
    }

    /// The user has gone elsewhere: whoever has the keyboard keeps it.
    pub(super) fn leave_keyboard(&mut self) {
        if let Some(home) = &mut self.home {
            home.look = None;
        }
    }

    /// When [`Window::look_for_keyboard`] has something to do.
    pub(super) fn keyboard_look(&self) -> Option<Instant> {
        Some(self.home.as_ref()?.look?.0)
    }

    /// Takes the keyboard again if somebody took it back just after the click.
    pub(super) fn look_for_keyboard(&mut self, now: Instant) -> Result<()> {
        let Some((due, left)) = self.home.as_ref().and_then(|home| home.look) else {
            return Ok(());
        };
        if now < due {
            return Ok(());
        }
        let lost = !self.focus.own;
        if lost && !self.host_has_keyboard()? {
            // A dialog that the host has opened since, or another program: they keep it.
            self.leave_keyboard();
            return Ok(());
        }
        if let Some(home) = &mut self.home {
            home.look = (left > 1).then(|| (now + LOOK_AGAIN, left - 1));
        }
        if !lost {
            return Ok(());
        }
        // Later than whatever took it.
        self.take_keyboard(x11rb::CURRENT_TIME)
    }

    /// Whether the keyboard is with the host's top-level window, or something in it (a
    /// toolkit's own window for the keyboard), or with nobody.
    fn host_has_keyboard(&self) -> Result<bool> {
        let connection = &self.connection;
        let focus = connection
            .answer(connection.get_input_focus())?
            .map_or(x11rb::NONE, |reply| reply.focus);
        let nobody = [InputFocus::NONE, InputFocus::POINTER_ROOT].map(u32::from);
        Ok(nobody.contains(&focus) || self.above(focus)? == self.top_level()?)
    }

    fn take_keyboard(&self, time: u32) -> Result<()> {
        let (connection, ours) = (&self.connection, self.frame.window);
        let asked = connection.set_input_focus(InputFocus::PARENT, ours, time);
        asked.map(drop).map_err(|error| connection.lost(error))
    }

    /// The window that window managers know: ours, or the host's around it.
    pub(super) fn top_level(&self) -> Result<u32> {
        match &self.home {
            Some(home) => self.above(home.parent),
            None => Ok(self.frame.window),
        }
    }

    /// The top-level window around one.
    fn above(&self, mut window: u32) -> Result<u32> {
        let connection = &self.connection;
        for _ in 0..MOST_ANCESTORS {
            let state = connection.atoms().WM_STATE;
            let asked = connection.get_property(false, window, state, AtomEnum::ANY, 0, 0);
            let managed = connection.answer(asked)?;
            if managed.is_some_and(|property| property.type_ != x11rb::NONE) {
                break;
            }
            match connection.answer(connection.query_tree(window))? {
                Some(tree) if tree.parent != tree.root && tree.parent != x11rb::NONE => {
                    window = tree.parent;
                }
                _ => break,
            }
        }
        Ok(window)
    }
}
