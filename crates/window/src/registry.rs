//! The windows of a thread.
//!
//! While a window works, it is taken out of the table. Host code runs with nothing borrowed, so a
//! callback may open windows, close them, serve the others, or change this one. While host code
//! runs for a window, that window is not served, and it is closed only after the call.
//!
//! A panic in the work of one window closes that window only.
//!
//! After a `fork` the child has no windows. Because it shares their connections with the parent, it
//! drops them without a message to the server.

use std::any::Any;
use std::cell::RefCell;
use std::os::fd::RawFd;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::rc::Rc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::Duration;

use super::descriptors::Descriptors;
use super::host::{Gone, Host, Id};
use super::window::Window;
use super::{clock, lookout, thread_end, xt};
use crate::error::{EngineError, Error, Result, panic_said};
use vides_engine::inject;

/// Ids are never reused within a process.
static NEXT: AtomicU64 = AtomicU64::new(1);

thread_local! {
    static TABLE: RefCell<Table> = RefCell::new(Table::new());
}

struct Table {
    /// The process that owns the windows, not a forked child.
    process: u32,
    /// Ordered by id.
    slots: Vec<Slot>,
    /// Created with the first window or when the host asks; then kept, because the host may watch
    /// them.
    descriptors: Option<Descriptors>,
    /// The number of calls into the host that are running.
    calls: usize,
    /// The last loss that was reported to a host. A server that goes away takes many windows, and
    /// one report is enough.
    last_loss: String,
    /// The window whose user is being asked whether all may be closed.
    asking: Option<Id>,
    /// The last loss, until a call that serves windows returns it.
    lost: Option<Lost>,
}

struct Slot {
    id: Id,
    host: Rc<dyn Host>,
    /// `None` while it works.
    window: Option<Box<Window>>,
    /// Host code runs for it.
    calling: bool,
    /// To be closed as soon as neither its work nor host code is running.
    closing: bool,
    watched: bool,
}

/// Why a window was lost.
#[derive(Clone, Debug)]
pub struct Lost {
    /// One sentence.
    pub why: String,
    /// The reason for its owner.
    pub gone: Gone,
}

impl Table {
    fn new() -> Self {
        Self {
            process: std::process::id(),
            slots: Vec::new(),
            descriptors: None,
            calls: 0,
            last_loss: String::new(),
            asking: None,
            lost: None,
        }
    }

    fn place(&self, id: Id) -> Option<usize> {
        self.slots.binary_search_by_key(&id, |slot| slot.id).ok()
    }

    fn slot(&mut self, id: Id) -> Option<&mut Slot> {
        let place = self.place(id)?;
        self.slots.get_mut(place)
    }

    fn remove(&mut self, id: Id) -> Option<Slot> {
        let place = self.place(id)?;
        let slot = self.slots.remove(place);
        if let (Some(window), Some(descriptors), true) =
            (&slot.window, &self.descriptors, slot.watched)
        {
            descriptors.leave(window.screen().connection());
        }
        if self.slots.is_empty() {
            lookout::end(false);
        }
        Some(slot)
    }

    fn descriptors(&mut self) -> Result<&mut Descriptors> {
        if self.descriptors.is_none() {
            self.descriptors = Some(Descriptors::new()?);
        }
        // Created above if it was missing.
        self.descriptors.as_mut().ok_or(EngineError::Memory.into())
    }
}

impl Drop for Table {
    /// The thread ends (or the process, if this is its main thread).
    fn drop(&mut self) {
        let slots = std::mem::take(&mut self.slots);
        if self.process != std::process::id() {
            std::mem::forget(slots);
        } else if !slots.is_empty() {
            lookout::end(false);
            thread_end::takes(slots.len());
            for slot in slots {
                discard(slot.window);
                // Calls no host code.
                slot.host.closed(slot.id, Gone::Thread);
            }
        }
        if xt::thread_is_watched()
            && let Some(descriptors) = self.descriptors.take()
        {
            descriptors.leak();
        }
    }
}

/// Borrows the thread's table. `f` must not run host code or a window's work.
fn table<R>(f: impl FnOnce(&mut Table) -> R) -> R {
    TABLE.with_borrow_mut(|table| {
        if table.process != std::process::id() {
            // A forked child: the windows belong to the parent.
            std::mem::forget(std::mem::replace(table, Table::new()));
        }
        f(table)
    })
}

/// Drops a window, even if that panics; true if [`pane_closed`] must be called.
fn discard(window: Option<Box<Window>>) -> bool {
    let shows_pane = window.as_ref().is_some_and(|window| window.shows_pane());
    let _ = catch_unwind(AssertUnwindSafe(|| drop(window)));
    shows_pane
}

/// Runs host code for a window that is already gone.
fn call_afterwards(call: impl FnOnce()) {
    table(|table| table.calls += 1);
    let _ = catch_unwind(AssertUnwindSafe(call));
    table(|table| table.calls = table.calls.saturating_sub(1));
}

/// Reports to the host of a window that is gone that its pane is closed. Calls host code.
fn pane_closed(id: Id, host: &Rc<dyn Host>) {
    call_afterwards(|| host.pane(id, 0, [0; 2]));
}

/// Reports to the host that a window is gone that it did not close. Calls host code.
fn tell_gone(id: Id, host: &Rc<dyn Host>, why: Gone, shows_pane: bool) {
    host.closed(id, why);
    if shows_pane {
        pane_closed(id, host);
    }
    call_afterwards(|| host.gone(id, why));
}

/// Discards a window that its owner closed.
fn discard_closed(slot: Option<Slot>) {
    if let Some(slot) = slot
        && discard(slot.window)
    {
        pane_closed(slot.id, &slot.host);
    }
}

pub(super) fn insert(window: Box<Window>, host: Rc<dyn Host>) -> Result<Id> {
    let id = Id(NEXT.fetch_add(1, Ordering::Relaxed));
    table(|table| {
        table.slots.try_reserve(1).map_err(EngineError::from)?;
        let descriptors = table.descriptors()?;
        descriptors.watch(window.screen().connection())?;
        descriptors.ring();
        table.last_loss.clear();
        if table.calls == 0 {
            table.lost = None;
        }
        table.slots.push(Slot {
            id,
            host,
            window: Some(window),
            calling: false,
            closing: false,
            watched: true,
        });
        Ok(id)
    })
}

/// The id of the next window; all open windows have lower ones.
pub(super) fn next() -> Id {
    Id(NEXT.load(Ordering::Relaxed))
}

/// The oldest open window.
pub(super) fn first() -> Option<Id> {
    table(|table| {
        let mut open = table.slots.iter().filter(|slot| !slot.closing);
        open.next().map(|slot| slot.id)
    })
}

/// While this exists, all windows are being closed and the user of one is being asked.
pub(super) struct Asking;

/// Notes that the user of a window is asked.
pub(super) fn ask(id: Id) -> Asking {
    table(|table| table.asking = Some(id));
    Asking
}

impl Drop for Asking {
    fn drop(&mut self) {
        table(|table| table.asking = None);
    }
}

/// The window whose user is being asked, if all windows are being closed.
pub(super) fn asking() -> Option<Id> {
    table(|table| table.asking)
}

pub(super) fn count() -> usize {
    table(|table| table.slots.iter().filter(|slot| !slot.closing).count())
}

/// Whether a callback of one of this thread's windows is running.
pub fn within_a_call() -> bool {
    table(|table| table.calls > 0)
}

pub(super) fn descriptor() -> Result<RawFd> {
    table(|table| Ok(table.descriptors()?.raw()))
}

/// Why the last window was lost; returned once, and never to a callback.
pub(super) fn last_lost() -> Option<Lost> {
    table(|table| match table.calls {
        0 => table.lost.take(),
        _ => table.lost.clone(),
    })
}

/// How long until the timer makes the descriptor readable.
pub(super) fn wait() -> Option<Duration> {
    table(|table| table.descriptors.as_ref()?.wait(clock::now()))
}

/// Sleeps until the descriptor is readable, with nothing borrowed: a signal handler may call VIDES.
pub(super) fn sleep() -> Result<()> {
    super::descriptors::sleep_on(descriptor()?);
    Ok(())
}

/// The next window that may be served, ordered by id.
pub(super) fn next_after(id: Option<Id>) -> Option<Id> {
    table(|table| {
        let free = |slot: &&Slot| slot.window.is_some() && !slot.calling && Some(slot.id) > id;
        table.slots.iter().find(free).map(|slot| slot.id)
    })
}

/// Stops watching windows for which host code runs. They are not served meanwhile, so they must not
/// wake a loop in that code.
pub(super) fn leave_those_that_call() {
    table(|table| {
        let Some(descriptors) = &table.descriptors else {
            return;
        };
        for slot in table.slots.iter_mut().filter(|slot| slot.calling) {
            if let Some(window) = &slot.window {
                descriptors.leave(window.screen().connection());
                slot.watched = false;
            }
        }
    });
}

/// Sets the timer for whatever is due next, or at once if a window may have more to do.
pub(super) fn set_timer(more: bool) {
    table(|table| {
        let now = clock::now();
        let free = table.slots.iter().filter(|slot| !slot.calling);
        let due = free
            .filter_map(|slot| slot.window.as_ref()?.due(now))
            .chain((more && !table.slots.is_empty()).then_some(now))
            .min();
        if let Some(descriptors) = &mut table.descriptors {
            descriptors.wake_at(due, now);
        }
    });
}

/// Makes the windows be served again soon.
pub(super) fn ring() {
    table(|table| {
        if let Some(descriptors) = &mut table.descriptors {
            descriptors.ring();
        }
    });
}

/// Reads a window; `None` if there is no such window or it is working.
pub(super) fn look<R>(id: Id, f: impl FnOnce(&Window) -> R) -> Option<R> {
    table(|table| table.slot(id)?.window.as_deref().map(f))
}

/// Takes a window out of the table, lets `f` work with it, and puts it back. `None` if there is no
/// such window, if it is already working, or after a panic, which loses the window.
pub(super) fn work<R>(id: Id, f: impl FnOnce(&mut Window, &Rc<dyn Host>) -> R) -> Option<R> {
    let (mut window, host) = table(|table| {
        let slot = table.slot(id)?;
        Some((slot.window.take()?, Rc::clone(&slot.host)))
    })?;
    match catch_unwind(AssertUnwindSafe(|| f(&mut window, &host))) {
        Ok(done) => {
            let closed = table(|table| {
                let slot = table.slot(id)?;
                slot.window = Some(window);
                if slot.closing && !slot.calling {
                    table.remove(id)
                } else {
                    None
                }
            });
            discard_closed(closed);
            Some(done)
        }
        Err(panic) => {
            lose(id, Some(window), Lost::fault(&*panic));
            None
        }
    }
}

impl Lost {
    /// The X server is gone or failed.
    pub(super) fn screen(error: &Error) -> Self {
        use vides_x11::Error::{Destroyed, Reparented};
        let gone = match error {
            Error::Screen(Destroyed | Reparented) => Gone::FromOutside,
            _ => Gone::Screen,
        };
        Self {
            why: error.to_string(),
            gone,
        }
    }

    /// A panic in the window's work.
    fn fault(panic: &(dyn Any + Send)) -> Self {
        let said = panic_said(panic);
        Self {
            why: format!("a fault inside the library closed the window: {said}"),
            gone: Gone::Fault,
        }
    }
}

/// Removes a window that cannot go on.
pub(super) fn lose(id: Id, window: Option<Box<Window>>, why: Lost) {
    let (slot, new) = table(|table| {
        // If a child shares the connection, closing it would not end the watch.
        if let (Some(window), Some(descriptors)) = (&window, &table.descriptors) {
            descriptors.leave(window.screen().connection());
        }
        let slot = table.remove(id);
        let new = table.last_loss != why.why;
        table.last_loss.clone_from(&why.why);
        table.lost = Some(why.clone());
        (slot, new)
    });
    let mut shows_pane = discard(window);
    if let Some(slot) = slot {
        shows_pane |= discard(slot.window);
        if new {
            slot.host.lost(&why.why);
        }
        tell_gone(id, &slot.host, why.gone, shows_pane);
    }
}

/// Closes a window, after its work or its callback if one is running. False if there is no such
/// window.
pub(super) fn close(id: Id) -> bool {
    let (found, closed) = table(|table| {
        let Some(slot) = table.slot(id) else {
            return (false, None);
        };
        let found = !slot.closing;
        slot.closing = true;
        let free = slot.window.is_some() && !slot.calling;
        (found, if free { table.remove(id) } else { None })
    });
    discard_closed(closed);
    found
}

/// Closes a window for which no host code runs, and reports it to its owner.
pub(super) fn close_and_tell(id: Id, why: Gone) {
    if let Some(slot) = table(|table| table.remove(id)) {
        let shows_pane = discard(slot.window);
        tell_gone(id, &slot.host, why, shows_pane);
    }
}

/// Runs host code for a window, which is not served meanwhile. `None` if there is no such window,
/// or after a panic.
pub(super) fn call<R>(id: Id, f: impl FnOnce(&dyn Host) -> R) -> Option<R> {
    let host = table(|table| {
        let slot = table.slot(id)?;
        slot.calling = true;
        let host = Rc::clone(&slot.host);
        table.calls += 1;
        Some(host)
    })?;
    let done = catch_unwind(AssertUnwindSafe(|| {
        inject::point(inject::Place::Callback);
        f(&*host)
    }));
    let closed = table(|table| {
        table.calls = table.calls.saturating_sub(1);
        let place = table.place(id)?;
        let slot = &mut table.slots[place];
        slot.calling = false;
        if slot.closing {
            return table.remove(id);
        }
        if !slot.watched
            && let (Some(window), Some(descriptors)) = (&slot.window, &table.descriptors)
        {
            // A connection that was watched before can be watched again.
            slot.watched = descriptors.watch(window.screen().connection()).is_ok();
        }
        None
    });
    discard_closed(closed);
    match done {
        Ok(done) => Some(done),
        Err(panic) => {
            lose(id, None, Lost::fault(&*panic));
            None
        }
    }
}

/// Whether a window is open.
pub fn is_open(id: Id) -> bool {
    table(|table| table.slot(id).is_some_and(|slot| !slot.closing))
}
