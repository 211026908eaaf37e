//! Embedding in a host's window: our window fills it, and takes the focus when clicked, because
//! window managers do not focus child windows.

use std::time::{Duration, Instant};

use x11rb::protocol::Event;
use x11rb::protocol::xproto::{
    AtomEnum, ChangeWindowAttributesAux, ConfigureWindowAux, ConnectionExt as _, EventMask,
    InputFocus, WindowClass,
};

use super::connection::Connection;
use super::packets::SENT;
use super::state::Window;
use crate::error::{Error, Result};

/// How long after taking the focus to check it: a toolkit may take it back (GTK 3 does).
const CHECK_AFTER: Duration = Duration::from_millis(60);

const CHECKS: u32 = 4;

/// The most ancestors searched for the host's top-level window.
const MOST_ANCESTORS: usize = 64;

/// The host's window around ours.
pub(super) struct EmbedParent {
    parent: u32,
    /// When to check the focus, and how many checks are left.
    check: Option<(Instant, u32)>,
}

impl EmbedParent {
    /// Checks the host's window and selects its size changes; also returns its size. Fails with
    /// `ErrorKind::Argument` if the window does not exist or cannot hold ours.
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
        // Select events before reading the size, so that no change is missed.
        let listen = ChangeWindowAttributesAux::new().event_mask(EventMask::STRUCTURE_NOTIFY);
        connection.sent(connection.change_window_attributes(parent, &listen))?;
        let geometry = connection.answer(connection.get_geometry(parent))?;
        let geometry = geometry.ok_or_else(|| unfit("does not exist"))?;
        if geometry.root != root {
            return Err(unfit("is on another screen"));
        }
        let home = Self {
            parent,
            check: None,
        };
        Ok((home, (geometry.width.into(), geometry.height.into())))
    }

    pub(super) fn parent(&self) -> u32 {
        self.parent
    }
}

impl Window {
    /// Follows the size of the host's window, and notices when ours is reparented.
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
                    EmbedParent::enter(connection, event.parent).map_err(|_| Error::Reparented)?;
                *home = new;
                size
            }
            _ => return Ok(()),
        };
        let fill = ConfigureWindowAux::new().width(size.0).height(size.1);
        connection
            .sent(connection.configure_window(ours, &fill))
            .map(drop)
    }

    /// Takes the focus after a click, and checks it for a while.
    pub(super) fn claim_focus(&mut self) -> Result<()> {
        let Some(home) = &mut self.home else {
            return Ok(());
        };
        home.check = Some((Instant::now() + CHECK_AFTER, CHECKS));
        self.take_focus(self.time)
    }

    /// Stops claiming the focus once the user has moved it elsewhere.
    pub(super) fn stop_claiming_focus(&mut self) {
        if let Some(home) = &mut self.home {
            home.check = None;
        }
    }

    pub(super) fn focus_check(&self) -> Option<Instant> {
        Some(self.home.as_ref()?.check?.0)
    }

    /// Takes the focus again if it was taken back just after the click.
    pub(super) fn recheck_focus(&mut self, now: Instant) -> Result<()> {
        let Some((due, left)) = self.home.as_ref().and_then(|home| home.check) else {
            return Ok(());
        };
        if now < due {
            return Ok(());
        }
        let lost = !self.focus.own;
        if lost && !self.focus_is_in_host()? {
            // A dialog of the host or another program has the focus, and keeps it.
            self.stop_claiming_focus();
            return Ok(());
        }
        if let Some(home) = &mut self.home {
            home.check = (left > 1).then(|| (now + CHECK_AFTER, left - 1));
        }
        if !lost {
            return Ok(());
        }
        // CurrentTime, to be later than whatever took it.
        self.take_focus(x11rb::CURRENT_TIME)
    }

    /// Whether the focus is somewhere in the host's top-level window, or nowhere.
    fn focus_is_in_host(&self) -> Result<bool> {
        let connection = &self.connection;
        let focus = connection
            .answer(connection.get_input_focus())?
            .map_or(x11rb::NONE, |reply| reply.focus);
        let nobody = [InputFocus::NONE, InputFocus::POINTER_ROOT].map(u32::from);
        Ok(nobody.contains(&focus) || self.above(focus)? == self.top_level()?)
    }

    fn take_focus(&self, time: u32) -> Result<()> {
        let (connection, ours) = (&self.connection, self.frame.window);
        let asked = connection.set_input_focus(InputFocus::PARENT, ours, time);
        connection.sent(asked).map(drop)
    }

    /// The top-level window that window managers know: ours, or the host's around it.
    pub(super) fn top_level(&self) -> Result<u32> {
        match &self.home {
            Some(home) => self.above(home.parent),
            None => Ok(self.frame.window),
        }
    }

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
