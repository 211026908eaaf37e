//! The loop under the host's loop: every window has its turn until none has anything to do.
//!
//! It takes rounds, since waiting for a reply also reads events from the connection, of which the
//! descriptor then says nothing: each window is asked again until it has done nothing. A flooded
//! window must not keep the host from its own work: after some rounds the call returns, and the
//! timer brings it back at once.

use super::host::Id;
use super::live::HostEvent;
use super::registry::Lost;
use super::window::HostRequest;
use super::{clock, hint, lookout, registry};
use crate::error::Result;
use vides_engine::inject;

/// Rounds in one call: a picture, what its reply brings along, and a few more.
const ROUNDS: u32 = 8;

/// What happened in a call that served the windows.
#[derive(Debug)]
pub struct Served {
    /// Windows that are open now.
    pub open: usize,
    /// Why the last of the windows is gone that were lost since the last such call.
    pub lost: Option<Lost>,
}

/// Serves the thread's windows until there is nothing to do, or for a fair while; never waits.
/// Calls the host.
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

/// Gives every window one turn; true if one of them did anything.
fn round() -> bool {
    let mut busy = false;
    let mut last = None;
    while let Some(id) = registry::next_after(last) {
        last = Some(id);
        busy |= serve(id);
    }
    busy
}

/// Gives one window its turn, and calls the host for it.
fn serve(id: Id) -> bool {
    let Some(polled) = registry::work(id, |window, host| window.poll(id, host)) else {
        // Gone by a fault: there may be work for the others.
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
                registry::close_for_the_user(id);
            }
        }
    }
    true
}

/// Serves the windows until the last one is closed. Not from within a callback: see
/// [`registry::within_a_call`].
///
/// # Errors
/// `ErrorKind::Limit` without descriptors.
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

/// Closes all windows of this thread. With `ask`, each in turn asks its user about unsaved work and
/// then its host, while all are served; false if one refused. Not from within a callback.
///
/// # Errors
/// `ErrorKind::Limit` without descriptors.
pub fn close_all(ask: bool) -> Result<bool> {
    while let Some(id) = registry::first() {
        if !ask {
            registry::close(id);
            continue;
        }
        registry::work(id, |window, _| window.ask_to_close()).transpose()?;
        loop {
            dispatch();
            if !registry::is_open(id) {
                break;
            }
            if registry::look(id, |window| window.editor().asks_to_close()) != Some(true) {
                return Ok(false);
            }
            host_serves();
            registry::sleep()?;
        }
    }
    Ok(true)
}

/// The host serves its windows itself, or is about to: it needs no hint.
pub fn host_serves() {
    hint::served();
    lookout::end(true);
}
