//! Serves all windows until none has anything left to do; the host's loop calls it.
//!
//! Serving takes several rounds: waiting for a reply also reads events from the connection, which
//! the descriptor then does not announce. So each window is asked again until it has done nothing.
//! Because a flooded window must not keep the host from its own work, the call returns after some
//! rounds, and the timer makes the descriptor readable at once.

use super::host::{Gone, Id};
use super::live::HostEvent;
use super::registry::Lost;
use super::window::HostRequest;
use super::{clock, hint, lookout, registry, xt};
use crate::error::Result;
use vides_engine::inject;

/// Rounds in one call: a frame, the events that its reply brings along, and a few more.
const ROUNDS: u32 = 8;

/// The outcome of a call that served the windows.
#[derive(Debug)]
pub struct Served {
    /// The number of windows that are still open.
    pub open: usize,
    /// Why the last of the windows lost since the previous call is gone.
    pub lost: Option<Lost>,
}

/// Serves the thread's windows until there is nothing left to do, or for a limited time. Never
/// waits. Calls the host.
pub fn dispatch() -> Served {
    hint::served();
    let _serving = lookout::serving();
    inject::point(inject::Place::Dispatch);
    registry::leave_those_that_call();
    let mut more = true;
    for _ in 0..ROUNDS {
        more = round();
        if !more {
            break;
        }
    }
    registry::set_timer(more);
    Served {
        open: registry::count(),
        lost: registry::last_lost(),
    }
}

/// Serves every window once; true if any of them did something.
fn round() -> bool {
    let mut busy = false;
    let mut last = None;
    while let Some(id) = registry::next_after(last) {
        last = Some(id);
        busy |= serve(id);
    }
    busy
}

/// Serves one window, and calls the host for it.
fn serve(id: Id) -> bool {
    let Some(polled) = registry::work(id, |window, host| window.poll(id, host)) else {
        // The window was lost by a fault; others may have work.
        return true;
    };
    let polled = match polled {
        Ok(polled) => polled,
        Err(error) => {
            registry::lose(id, None, Lost::screen(&error));
            return true;
        }
    };
    match polled.request {
        None => return polled.busy,
        Some(HostRequest::HandOver) => {
            registry::call(id, |host| host.hand_over(id));
        }
        Some(HostRequest::Capture { replace }) => {
            if let Some(view) = registry::call(id, |host| host.capture(id)) {
                registry::work(id, |window, _| {
                    window.command(false, |editor| editor.take_over(view.as_ref(), replace));
                });
            }
        }
        Some(HostRequest::Live(call)) => {
            let began = clock::now();
            registry::call(id, |host| match call {
                HostEvent::View(pose, frame, reason) => host.view(id, &pose, frame, reason),
                HostEvent::Frame(frame, reason) => host.frame(id, frame, reason),
                HostEvent::Changed => host.changed(id),
                HostEvent::HandOver => host.hand_over(id),
            });
            registry::work(id, |window, _| window.called(began));
        }
        Some(HostRequest::Pane(pane)) => {
            let (window, size) =
                pane.map_or((0, [0; 2]), |pane| (pane.window, [pane.width, pane.height]));
            registry::call(id, |host| host.pane(id, window, size));
        }
        Some(HostRequest::Close) => {
            if registry::call(id, |host| host.may_close(id)) == Some(true) {
                registry::close_and_tell(id, Gone::ByUser);
            }
        }
    }
    true
}

/// Serves the windows until the last one is closed. Must not be called within a callback: see
/// [`registry::within_a_call`].
///
/// # Errors
/// `ErrorKind::Limit` if no descriptor is left.
pub fn main_loop() -> Result<Served> {
    host_serves();
    let mut lost = None;
    loop {
        let mut served = dispatch();
        lost = served.lost.take().or(lost);
        if served.open == 0 {
            return Ok(Served { lost, ..served });
        }
        registry::sleep()?;
    }
}

/// The outcome of closing all windows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Closing {
    /// All are closed.
    Done,
    /// A user or a host refused.
    Refused,
    /// An earlier call is still asking; its question is now in front.
    Asking,
}

/// Closes all windows that are open on this thread now. With `ask`, each in turn asks its user
/// about unsaved work, and then its host. Meanwhile all windows are served, and so is a host that
/// runs Xt, which may call this again. Must not be called within a callback.
///
/// # Errors
/// `ErrorKind::Limit` if no descriptor is left.
pub fn close_all(ask: bool) -> Result<Closing> {
    if let (true, Some(id)) = (ask, registry::asking()) {
        registry::work(id, |window, _| window.raise()).transpose()?;
        return Ok(Closing::Asking);
    }
    // Without those that a host opens meanwhile, for example one for each that is closed.
    let closing = close_before(registry::next(), ask);
    if ask {
        xt::go_on();
    }
    closing
}

/// Closes the windows opened before `end`.
fn close_before(end: Id, ask: bool) -> Result<Closing> {
    while let Some(id) = registry::first().filter(|id| *id < end) {
        if !ask {
            registry::close_and_tell(id, Gone::WithAll);
            continue;
        }
        let _asking = registry::ask(id);
        registry::work(id, |window, _| window.ask_to_close()).transpose()?;
        loop {
            dispatch();
            if !registry::is_open(id) {
                break;
            }
            if registry::look(id, |window| window.editor().asks_to_close()) != Some(true) {
                return Ok(Closing::Refused);
            }
            host_serves();
            if !xt::process_one() {
                registry::sleep()?;
            }
        }
    }
    Ok(Closing::Done)
}

/// The host serves its windows itself, or is about to, and needs no hint.
pub fn host_serves() {
    hint::served();
    lookout::end(true);
}
