//! Panes outlive the windows that show them. If a window that a host draws in vanishes, Xlib ends
//! the program, and OpenGL writes to freed memory. So panes belong to a separate connection per
//! display, which lives as long as the process; a closed pane is parked on the root window for
//! reuse and never destroyed.

use std::sync::{Mutex, MutexGuard, PoisonError};

use x11rb::connection::{Connection as _, RequestConnection as _};
use x11rb::protocol::xfixes::{
    self, ConnectionExt as _, SaveSetMapping, SaveSetMode, SaveSetTarget,
};
use x11rb::protocol::xproto::{ConnectionExt as _, CreateWindowAux, WindowClass};

use super::connection::Connection;
use crate::error::Result;

/// A coordinate outside the screen, in case a parked pane is mapped.
const AWAY: i16 = -2000;

/// The connection that owns a display's panes.
struct Pool {
    display: String,
    connection: Connection,
    free: Vec<u32>,
}

/// All pools, and the process that created them: after `fork` the child has none. The lock is held
/// while a server is asked, so a silent server delays the panes of other threads, too: by at most a
/// second for each request.
static POOLS: Mutex<(u32, Vec<Pool>)> = Mutex::new((0, Vec::new()));

fn pools() -> MutexGuard<'static, (u32, Vec<Pool>)> {
    let mut pools = POOLS.lock().unwrap_or_else(PoisonError::into_inner);
    let process = std::process::id();
    if pools.0 != process {
        pools.0 = process;
        std::mem::forget(std::mem::take(&mut pools.1));
    }
    pools
}

/// Calls `f` with a display's pool, which is dropped with its panes if its connection fails.
fn with<R>(display: &str, f: impl FnOnce(&mut Pool) -> Result<R>) -> Option<Result<R>> {
    let mut pools = pools();
    let place = (pools.1.iter()).position(|pool| pool.display == display)?;
    let pool = &mut pools.1[place];
    let done = pool.read().and_then(|()| f(pool));
    if done.is_err() {
        pools.1.swap_remove(place);
    }
    Some(done)
}

/// A parked pane of the root visual, without a background. `None` if the server cannot create one.
pub(super) fn take(display: &str) -> Result<Option<u32>> {
    // A pool whose connection is lost is dropped at the first try and replaced.
    for _ in 0..2 {
        if let Some(Ok(pane)) = with(display, Pool::take) {
            return Ok(pane);
        }
        let pool = Pool::new(display)?;
        pools().1.push(pool);
    }
    Ok(None)
}

/// Moves a pane and its children, unmapped, to the root window. Requests for it on the caller's
/// connection must be done before.
pub(super) fn park(display: &str, pane: u32) {
    with(display, |pool| pool.park(pane));
}

/// Adds a window in a pane to the save-set of the pool's connection, or removes it.
pub(super) fn save(display: &str, window: u32, mode: SaveSetMode) {
    with(display, |pool| {
        save_in(&pool.connection, window, mode)?;
        pool.connection.flush()
    });
}

/// Adds a window to a connection's save-set, or removes it: when the connection ends, the server
/// moves the window to the root, unmapped.
pub(super) fn save_in(connection: &Connection, window: u32, mode: SaveSetMode) -> Result<()> {
    let (target, map) = (SaveSetTarget::ROOT, SaveSetMapping::UNMAP);
    let asked = connection.xfixes_change_save_set(mode, target, map, window);
    connection.sent(asked).map(drop)
}

/// Whether the server supports what panes need: XFIXES save-sets with a target, and SHAPE. Query
/// before using either.
pub(super) fn can(connection: &Connection) -> Result<bool> {
    let shape = x11rb::protocol::shape::X11_EXTENSION_NAME;
    for name in [xfixes::X11_EXTENSION_NAME, shape] {
        if connection
            .sent(connection.extension_information(name))?
            .is_none()
        {
            return Ok(false);
        }
    }
    let version = connection.answer(connection.xfixes_query_version(1, 0))?;
    Ok(version.is_some_and(|version| version.major_version >= 1))
}

impl Pool {
    fn new(display: &str) -> Result<Self> {
        let connection = Connection::open(Some(display))?;
        let able = can(&connection)?;
        connection.settle();
        if !able {
            return Err(connection.unfit(crate::error::Cause::NoSaveSet));
        }
        Ok(Self {
            display: display.to_owned(),
            connection,
            free: Vec::new(),
        })
    }

    /// Discards what has arrived, so that it does not accumulate.
    fn read(&self) -> Result<()> {
        while self.connection.next()?.is_some() {}
        Ok(())
    }

    fn take(&mut self) -> Result<Option<u32>> {
        // A parked pane may have been destroyed by another client.
        while let Some(pane) = self.free.pop() {
            let asked = self.connection.get_window_attributes(pane);
            if self.connection.answer(asked)?.is_some() {
                return Ok(Some(pane));
            }
        }
        self.make()
    }

    fn make(&self) -> Result<Option<u32>> {
        let connection = &self.connection;
        let pane = connection.sent(connection.generate_id())?;
        let screen = connection.screen();
        // Window managers ignore override-redirect windows while on the root.
        let attributes = CreateWindowAux::new()
            .border_pixel(0)
            .colormap(screen.default_colormap)
            .override_redirect(1);
        let made = connection.create_window(
            screen.root_depth,
            pane,
            screen.root,
            AWAY,
            AWAY,
            1,
            1,
            0,
            WindowClass::INPUT_OUTPUT,
            screen.root_visual,
            &attributes,
        );
        Ok(connection.done(made)?.then_some(pane))
    }

    fn park(&mut self, pane: u32) -> Result<()> {
        let connection = &self.connection;
        let root = connection.screen().root;
        connection.sent(connection.unmap_window(pane))?;
        let inside = connection.answer(connection.query_tree(pane))?;
        for child in inside.map_or_else(Vec::new, |tree| tree.children) {
            connection.sent(connection.unmap_window(child))?;
            connection.sent(connection.reparent_window(child, root, 0, 0))?;
            save_in(connection, child, SaveSetMode::DELETE)?;
        }
        if connection.done(connection.reparent_window(pane, root, AWAY, AWAY))? {
            self.free.push(pane);
        }
        Ok(())
    }
}
