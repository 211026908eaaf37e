//! Hosts that ask `XtAppPending` before they take an event.
//!
//! Such a host draws between its rounds, and takes only what is pending:
//! `while (XtAppPending(app)) { XtAppNextEvent(app, &event); XtDispatchEvent(&event); }`.
//! Our input is pending, too, but it is no event: `XtAppNextEvent` has the windows served and then
//! waits for an event of the host's, perhaps for ever. So after serving, an event is put back into
//! the host's own queue: an empty `NoExpose` for no window, which has no meaning for anyone. No
//! request is made.
//!
//! A host that sleeps in Xt until something is due needs no event, and would be woken for nothing.
//! A hook of Xt reports that sleep. Serving within it sends no event until the host has processed
//! one, and so has woken up.

#![allow(unsafe_code)] // functions of C, found by name

use std::collections::hash_map::DefaultHasher;
use std::ffi::{CStr, CString, c_char, c_int, c_uint, c_ulong, c_void};
use std::hash::{Hash as _, Hasher as _};
use std::hint::black_box;
use std::mem::{MaybeUninit, transmute};
use std::os::fd::RawFd;
use std::ptr;
use std::sync::OnceLock;

use super::descriptors::events_of;
use super::xt::named;

/// A `Display`, opaque here.
type Display = *mut c_void;
/// An `XEvent`: it has room for 24 numbers.
type Event = [c_ulong; 24];

pub(super) type BlockHook = unsafe extern "C" fn(*mut c_void);
type AddBlockHook = unsafe extern "C" fn(*mut c_void, BlockHook, *mut c_void) -> c_ulong;
type GetDisplays = unsafe extern "C" fn(*mut c_void, *mut *mut Display, *mut c_uint);
type Free = unsafe extern "C" fn(*mut c_char);
type LastEvent = unsafe extern "C" fn(Display) -> *const Head;
type LastTime = unsafe extern "C" fn(Display) -> c_ulong;
type NameOf = unsafe extern "C" fn(Display) -> *const c_char;
type Queued = unsafe extern "C" fn(Display, c_int) -> c_int;
type PutBack = unsafe extern "C" fn(Display, *mut Event) -> c_int;
type LastSerial = unsafe extern "C" fn(Display) -> c_ulong;

/// `NoExpose`, and `QueuedAlready`: only events that have been read already.
const NO_EXPOSE: c_int = 14;
const QUEUED_ALREADY: c_int = 0;

/// More bytes than a list of a context's displays needs.
const LIST_ROOM: usize = 4096;

struct Calls {
    add_block_hook: AddBlockHook,
    get_displays: GetDisplays,
    free: Free,
    last_event: LastEvent,
    last_time: LastTime,
    name_of: NameOf,
    queued: Queued,
    put_back: PutBack,
    last_serial: LastSerial,
}

/// The beginning of every event, up to its window.
#[repr(C)]
struct Head {
    kind: c_int,
    serial: c_ulong,
    send_event: c_int,
    display: Display,
    window: c_ulong,
}

/// How the host of a context sleeps.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Sleep {
    /// The last event that it had processed before.
    at: Option<u64>,
    /// Nothing was waiting to be served.
    quiet: bool,
}

impl Calls {
    /// All of the functions, or `None`.
    fn find() -> Option<&'static Self> {
        static FOUND: OnceLock<Calls> = OnceLock::new();
        if let Some(found) = FOUND.get() {
            return Some(found);
        }
        // SAFETY: each function has the type that the headers of Xt and Xlib declare.
        let found = unsafe {
            Self {
                add_block_hook: transmute::<*mut c_void, AddBlockHook>(named(
                    c"XtAppAddBlockHook",
                )?),
                get_displays: transmute::<*mut c_void, GetDisplays>(named(c"XtGetDisplays")?),
                free: transmute::<*mut c_void, Free>(named(c"XtFree")?),
                last_event: transmute::<*mut c_void, LastEvent>(named(c"XtLastEventProcessed")?),
                last_time: transmute::<*mut c_void, LastTime>(named(c"XtLastTimestampProcessed")?),
                name_of: transmute::<*mut c_void, NameOf>(named(c"XDisplayString")?),
                queued: transmute::<*mut c_void, Queued>(named(c"XEventsQueued")?),
                put_back: transmute::<*mut c_void, PutBack>(named(c"XPutBackEvent")?),
                last_serial: transmute::<*mut c_void, LastSerial>(named(
                    c"XLastKnownRequestProcessed",
                )?),
            }
        };
        Some(FOUND.get_or_init(|| found))
    }

    /// Runs `f` with the displays of an Xt context, the oldest first; with none if memory is short,
    /// because Xt ends the program if it cannot allocate its list.
    fn displays<R>(&self, context: usize, f: impl FnOnce(&[Display]) -> R) -> R {
        let mut room = Vec::<u8>::new();
        if room.try_reserve(LIST_ROOM).is_err() {
            return f(&[]);
        }
        drop(black_box(room));
        let (mut list, mut count) = (ptr::null_mut::<Display>(), 0);
        let context = ptr::with_exposed_provenance_mut(context);
        // SAFETY: a context that Xt knows; room for the results, which are freed below.
        unsafe { (self.get_displays)(context, &mut list, &mut count) };
        if list.is_null() {
            return f(&[]);
        }
        // SAFETY: `count` displays, as Xt says.
        let result = f(unsafe { std::slice::from_raw_parts(list, count as usize) });
        // SAFETY: the list that Xt returned.
        unsafe { (self.free)(list.cast()) };
        result
    }

    /// A hash of the events that the displays of a context processed last. It reads only the fields
    /// that all events have: the rest of Xt's record may be uninitialised.
    fn processed(&self, context: usize) -> u64 {
        self.displays(context, |displays| {
            let mut hash = DefaultHasher::new();
            for &display in displays {
                // SAFETY: a display of Xt's; the event is Xt's record of it.
                let (event, time) = unsafe {
                    (
                        (self.last_event)(display).as_ref(),
                        (self.last_time)(display),
                    )
                };
                let event = event.map(|event| (event.kind, event.serial, event.window));
                (event, time).hash(&mut hash);
            }
            hash.finish()
        })
    }

    fn any_queued(&self, displays: &[Display]) -> bool {
        // SAFETY: displays of Xt's.
        let queued = |&display: &Display| unsafe { (self.queued)(display, QUEUED_ALREADY) } > 0;
        displays.iter().any(queued)
    }
}

/// The name of the display that a context opened last, as the host gave it to Xlib.
pub(super) fn display(context: usize) -> Option<CString> {
    let calls = Calls::find()?;
    calls.displays(context, |displays| {
        // SAFETY: a display of Xt's.
        let name = unsafe { (calls.name_of)(*displays.last()?) };
        // SAFETY: a text ended by zero, which lives as long as the display.
        (!name.is_null()).then(|| unsafe { CStr::from_ptr(name) }.to_owned())
    })
}

/// Makes Xt call this hook with this closure when the host of a context is about to sleep.
pub(super) fn watch_sleep(context: usize, hook: BlockHook, closure: *mut c_void) {
    if let Some(calls) = Calls::find() {
        let context = ptr::with_exposed_provenance_mut(context);
        // SAFETY: a context that Xt knows; the function stays.
        unsafe { (calls.add_block_hook)(context, hook, closure) };
    }
}

/// Notes the state in which the host of a context falls asleep.
pub(super) fn falls_asleep(context: usize, windows: Option<RawFd>) -> Sleep {
    let Some(calls) = Calls::find() else {
        return Sleep::default();
    };
    let quiet = windows.is_some_and(|fd| events_of(fd, libc::POLLIN) == 0)
        && !calls.displays(context, |displays| calls.any_queued(displays));
    Sleep {
        at: Some(calls.processed(context)),
        quiet,
    }
}

/// Whether the host of a context, which is serving the windows, is still in this sleep.
pub(super) fn sleeps(context: usize, sleep: Sleep) -> bool {
    let Some(calls) = Calls::find() else {
        return true;
    };
    sleep.at == Some(calls.processed(context))
}

impl Sleep {
    /// Whether the host fell asleep with nothing to do, so that Xt woke it for our input.
    pub(super) fn was_sound(self) -> bool {
        self.quiet
    }
}

/// Gives the host of a context an event to take, if none is queued.
pub(super) fn wake(context: usize) {
    let Some(calls) = Calls::find() else { return };
    calls.displays(context, |displays| {
        let (Some(&display), false) = (displays.first(), calls.any_queued(displays)) else {
            return;
        };
        let mut event = MaybeUninit::<Event>::zeroed();
        let head = Head {
            kind: NO_EXPOSE,
            // SAFETY: a display of Xt's.
            serial: unsafe { (calls.last_serial)(display) },
            send_event: 1,
            display,
            window: 0,
        };
        // SAFETY: an event begins like this, and consists of numbers; Xlib copies it.
        unsafe {
            event.as_mut_ptr().cast::<Head>().write(head);
            (calls.put_back)(display, event.as_mut_ptr());
        }
    });
}
