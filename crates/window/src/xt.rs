//! Hosts that run Xt: our descriptor becomes one more input of their application contexts, and
//! nothing in them needs to change.
//!
//! Xt is not linked, since a host without it shall need no X library: it is looked for among the
//! names of the running process. No public function tells which contexts there are;
//! `_XtGetProcessContext` gives the process's record, two pointers (the default context, the list
//! of all), and a context begins with three: the next one, the record it belongs to, the callbacks
//! for its end. This has been so since X11R6; the second one is checked before a context is
//! trusted. Where that function is missing, `XtAddInput` serves the default context.
//!
//! Xt keeps our pointers, so the library is never unloaded, and an input that was added stays until
//! its context ends: the descriptor is quiet while there are no windows. Another context may come
//! to lie at the address of one that ended, so each one that we are in tells us its end.
//!
//! For hosts that ask before they take an event see [`super::xt_wake`].

#![allow(unsafe_code)] // functions of C, found by name

use std::ffi::{CStr, c_char, c_int, c_ulong, c_void};
use std::mem::transmute;
use std::os::fd::RawFd;
use std::ptr;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, MutexGuard, OnceLock, PoisonError};

use super::lookout;
use super::xt_wake::{self, Sleep};

/// An `XtAppContext`.
type Context = *mut ContextHead;
type InputCallback = unsafe extern "C" fn(*mut c_void, *mut c_int, *mut c_ulong);
type AddInput =
    unsafe extern "C" fn(Context, c_int, *mut c_void, InputCallback, *mut c_void) -> c_ulong;
type AddDefaultInput =
    unsafe extern "C" fn(c_int, *mut c_void, InputCallback, *mut c_void) -> c_ulong;
type RemoveInput = unsafe extern "C" fn(c_ulong);
type EndCallback = unsafe extern "C" fn(*mut c_void, *mut c_void, *mut c_void);
type AddEndCallback = unsafe extern "C" fn(*mut *mut c_void, EndCallback, *mut c_void);
type Lock = unsafe extern "C" fn();

/// `XtInputReadMask`.
const READ: *mut c_void = ptr::without_provenance_mut(1);

/// More contexts than any program has: the list must be damaged.
const MOST_CONTEXTS: usize = 10_000;

/// How Xt's record of the process begins.
#[repr(C)]
struct ProcessHead {
    default: Context,
    first: Context,
}

/// How an application context begins.
#[repr(C)]
struct ContextHead {
    next: Context,
    process: *mut ProcessHead,
    ends: *mut c_void,
}

/// The functions of Xt that were found.
struct Xt {
    add_input: AddInput,
    remove_input: RemoveInput,
    add_default_input: Option<AddDefaultInput>,
    process: Option<unsafe extern "C" fn() -> *mut ProcessHead>,
    add_end_callback: Option<AddEndCallback>,
    lock: Option<(Lock, Lock)>,
}

/// A context with a thread's descriptor among its inputs; its address is valid while this exists.
#[derive(Clone, Copy)]
struct Watched {
    /// What Xt passes to our callbacks; never used again for another.
    number: usize,
    context: usize,
    thread: usize,
    descriptor: RawFd,
    /// When its host slept last.
    sleep: Sleep,
}

/// Stands for the address of the default context.
const DEFAULT: usize = 0;

/// What is done when a descriptor is readable.
static SERVE: OnceLock<fn()> = OnceLock::new();

static WATCHED: Mutex<Vec<Watched>> = Mutex::new(Vec::new());
static THREADS: AtomicUsize = AtomicUsize::new(1);
static NUMBERS: AtomicUsize = AtomicUsize::new(1);

thread_local! {
    static THREAD: usize = THREADS.fetch_add(1, Ordering::Relaxed);
}

fn watched() -> MutexGuard<'static, Vec<Watched>> {
    WATCHED.lock().unwrap_or_else(PoisonError::into_inner)
}

fn entry(number: usize) -> Option<Watched> {
    watched()
        .iter()
        .find(|entry| entry.number == number)
        .copied()
}

/// This thread's number, never used again; 0 while the thread is ending. (The standard library's
/// takes memory, and cannot report that there is none.)
pub fn own_thread() -> usize {
    THREAD.try_with(|number| *number).unwrap_or(0)
}

/// Whether an Xt context watches this thread's descriptor.
pub(super) fn thread_is_watched() -> bool {
    let thread = own_thread();
    watched().iter().any(|entry| entry.thread == thread)
}

/// Why a context of the host's cannot be used.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Refusal {
    /// There is no Xt in this process.
    NoXt,
    /// Xt knows no such context.
    NoContext,
}

/// Has the descriptor watched by all application contexts that do not watch it yet; `serve` is called
/// where it is readable.
pub(super) fn watch_in_all_contexts(descriptor: RawFd, serve: fn()) {
    let _ = SERVE.set(serve);
    let Some(xt) = Xt::find() else { return };
    match xt.contexts() {
        Some(contexts) => {
            for context in contexts {
                xt.watch(context, descriptor);
            }
        }
        None => xt.watch(ptr::null_mut(), descriptor),
    }
}

pub(super) fn watch_in(
    context: *mut c_void,
    descriptor: RawFd,
    serve: fn(),
) -> Result<(), Refusal> {
    let _ = SERVE.set(serve);
    let xt = Xt::find().ok_or(Refusal::NoXt)?;
    let context = context.cast::<ContextHead>();
    if let Some(contexts) = xt.contexts()
        && !contexts.contains(&context)
    {
        return Err(Refusal::NoContext);
    }
    xt.watch(context, descriptor);
    Ok(())
}

impl Xt {
    fn find() -> Option<Self> {
        // SAFETY: each function has the type that Xt's header declares (XtAppContext, XtPointer,
        // XtInputId and the callbacks are pointers and an unsigned long).
        unsafe {
            Some(Self {
                add_input: transmute::<*mut c_void, AddInput>(named(c"XtAppAddInput")?),
                remove_input: transmute::<*mut c_void, RemoveInput>(named(c"XtRemoveInput")?),
                add_default_input: named(c"XtAddInput")
                    .map(|found| transmute::<*mut c_void, AddDefaultInput>(found)),
                process: named(c"_XtGetProcessContext").map(|found| {
                    transmute::<*mut c_void, unsafe extern "C" fn() -> *mut ProcessHead>(found)
                }),
                add_end_callback: named(c"_XtAddCallback")
                    .map(|found| transmute::<*mut c_void, AddEndCallback>(found)),
                lock: named(c"XtProcessLock").zip(named(c"XtProcessUnlock")).map(
                    |(lock, unlock)| {
                        (
                            transmute::<*mut c_void, Lock>(lock),
                            transmute::<*mut c_void, Lock>(unlock),
                        )
                    },
                ),
            })
        }
    }

    /// All application contexts of the process, the newest first; `None` if that is unknown.
    fn contexts(&self) -> Option<Vec<Context>> {
        let process = self.process?;
        let mut found = Vec::new();
        // SAFETY: a function without arguments; it gives Xt's own record.
        let record = unsafe { process() };
        if record.is_null() || !record.is_aligned() {
            return None;
        }
        if let Some((lock, _)) = self.lock {
            // SAFETY: a function without arguments; unlocked below.
            unsafe { lock() };
        }
        // SAFETY: Xt's record begins so.
        let mut context = unsafe { (*record).first };
        let mut sound = true;
        while !context.is_null() {
            // SAFETY: a context of Xt's list, aligned; it begins so.
            sound = context.is_aligned()
                && found.len() < MOST_CONTEXTS
                && unsafe { (*context).process } == record;
            if !sound {
                break;
            }
            found.push(context);
            // SAFETY: as above.
            context = unsafe { (*context).next };
        }
        if let Some((_, unlock)) = self.lock {
            // SAFETY: locked above.
            unsafe { unlock() };
        }
        sound.then_some(found)
    }

    /// Adds the descriptor to the inputs of a context (null: the default one) unless it is there.
    fn watch(&self, context: Context, descriptor: RawFd) {
        let entry = Watched {
            number: NUMBERS.fetch_add(1, Ordering::Relaxed),
            context: context.expose_provenance(),
            thread: own_thread(),
            descriptor,
            sleep: Sleep::default(),
        };
        {
            let mut all = watched();
            let same = |one: &Watched| (one.context, one.thread) == (entry.context, entry.thread);
            if all.iter().any(same) || all.try_reserve(1).is_err() {
                return;
            }
            all.push(entry);
        }
        let closure = ptr::without_provenance_mut(entry.number);
        if entry.context == DEFAULT {
            if let Some(add) = self.add_default_input {
                // SAFETY: as Xt's header declares it; the callback and the descriptor stay.
                unsafe { add(descriptor, READ, on_input, closure) };
            }
            return;
        }
        // SAFETY: a context that Xt knows or the host vouches for; callback and descriptor stay.
        unsafe { (self.add_input)(context, descriptor, READ, on_input, closure) };
        if self.process.is_some()
            && let Some(add) = self.add_end_callback
        {
            // SAFETY: the context is in Xt's list and begins as declared above; the callback stays.
            unsafe { add(&raw mut (*context).ends, on_end, closure) };
            // Only where its end is reported.
            xt_wake::watch_sleep(entry.context, on_sleep, closure);
        }
    }
}

/// The address of a function in this process.
pub(super) fn named(name: &CStr) -> Option<*mut c_void> {
    let name: *const c_char = name.as_ptr();
    // SAFETY: a text ended by zero.
    let found = unsafe { libc::dlsym(libc::RTLD_DEFAULT, name) };
    (!found.is_null()).then_some(found)
}

/// Xt calls this when the descriptor is readable.
unsafe extern "C" fn on_input(closure: *mut c_void, _: *mut c_int, id: *mut c_ulong) {
    match entry(closure.addr()) {
        Some(entry) if entry.thread == own_thread() => serve(entry),
        _ => {
            // Another thread runs this context. Its windows are not here, and the descriptor would
            // be readable without end.
            if let Some(xt) = Xt::find()
                && !id.is_null()
            {
                // SAFETY: the input that Xt is calling for; it may be removed here.
                unsafe { (xt.remove_input)(*id) };
            }
        }
    }
}

fn call_host() {
    if let Some(serve) = SERVE.get() {
        serve();
    }
}

fn serve(watched: Watched) {
    if watched.context == DEFAULT {
        call_host();
        return;
    }
    // Before host code runs, which may itself sleep in Xt.
    let sleeps = xt_wake::sleeps(watched.context, watched.sleep);
    if sleeps && watched.sleep.was_sound() {
        lookout::end(true);
    }
    call_host();
    // A callback may have ended the context.
    if !sleeps && entry(watched.number).is_some() {
        xt_wake::wake(watched.context);
    }
}

/// Xt calls this when the host is going to sleep in a context.
unsafe extern "C" fn on_sleep(closure: *mut c_void) {
    let Some(of) = entry(closure.addr()) else {
        return;
    };
    let windows = lookout::is_looking().then_some(of.descriptor);
    let sleep = xt_wake::falls_asleep(of.context, windows);
    for entry in watched().iter_mut() {
        if entry.number == of.number {
            entry.sleep = sleep;
        }
    }
}

/// Xt calls this when an application context ends.
unsafe extern "C" fn on_end(_: *mut c_void, closure: *mut c_void, _: *mut c_void) {
    watched().retain(|entry| entry.number != closure.addr());
}
