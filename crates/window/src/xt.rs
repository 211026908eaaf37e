//! Hosts that run Xt: our descriptor becomes an input of their application contexts, and the hosts
//! need no changes.
//!
//! Xt is not linked, so that a host without it needs no X library; its functions are looked up in
//! the running process. No public function lists the contexts, but `_XtGetProcessContext` returns
//! the process's record of two pointers (the default context and the list of all). A context begins
//! with three: the next context, the record that it belongs to, and the callbacks for its end. This
//! has been so since X11R6; the second pointer is checked before a context is trusted. Without that
//! function, `XtAddInput` serves the default context.
//!
//! Xt keeps our pointers, so the library is never unloaded, and an input remains until its context
//! ends; without windows, the descriptor is quiet. A new context may have the address of one that
//! ended, so each context that has our input reports its end.
//!
//! For hosts that ask for pending events before they take one, see [`super::xt_wake`].

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
type ProcessEvent = unsafe extern "C" fn(Context, c_ulong);
type EndCallback = unsafe extern "C" fn(*mut c_void, *mut c_void, *mut c_void);
type AddEndCallback = unsafe extern "C" fn(*mut *mut c_void, EndCallback, *mut c_void);
type Lock = unsafe extern "C" fn();

/// `XtInputReadMask`.
const READ: *mut c_void = ptr::without_provenance_mut(1);

/// `XtIMAll`.
const ALL_EVENTS: c_ulong = 15;

/// More contexts than any program has; a longer list is corrupt.
const MOST_CONTEXTS: usize = 10_000;

/// The beginning of Xt's record of the process.
#[repr(C)]
struct ProcessHead {
    default: Context,
    first: Context,
}

/// The beginning of an application context.
#[repr(C)]
struct ContextHead {
    next: Context,
    process: *mut ProcessHead,
    ends: *mut c_void,
}

/// The functions of Xt, if found.
struct Xt {
    add_input: AddInput,
    remove_input: RemoveInput,
    process_event: Option<ProcessEvent>,
    add_default_input: Option<AddDefaultInput>,
    process: Option<unsafe extern "C" fn() -> *mut ProcessHead>,
    add_end_callback: Option<AddEndCallback>,
    lock: Option<(Lock, Lock)>,
}

/// A context that has a thread's descriptor as an input; its address is valid while this exists.
#[derive(Clone, Copy)]
struct Watched {
    /// What Xt passes to our callbacks; never reused.
    number: usize,
    context: usize,
    thread: usize,
    descriptor: RawFd,
    /// The last sleep of its host.
    sleep: Sleep,
    /// The thread that ran it last; 0 if unknown.
    runner: usize,
    /// The sequence number of that run.
    run: usize,
}

/// Stands for the address of the default context.
const DEFAULT: usize = 0;

/// What to call when a descriptor is readable.
static SERVE: OnceLock<fn()> = OnceLock::new();

static WATCHED: Mutex<Vec<Watched>> = Mutex::new(Vec::new());
static THREADS: AtomicUsize = AtomicUsize::new(1);
static NUMBERS: AtomicUsize = AtomicUsize::new(1);
static RUNS: AtomicUsize = AtomicUsize::new(1);

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

/// Notes that this thread runs the context of this entry.
fn note_run(number: usize) {
    let (runner, run) = (own_thread(), RUNS.fetch_add(1, Ordering::Relaxed));
    for entry in watched().iter_mut().filter(|entry| entry.number == number) {
        (entry.runner, entry.run) = (runner, run);
    }
}

/// This thread's number, never reused; 0 while the thread is ending. (The standard library's
/// function allocates, and cannot report a failure.)
pub fn own_thread() -> usize {
    THREAD.try_with(|number| *number).unwrap_or(0)
}

/// Whether an Xt context watches this thread's descriptor.
pub(super) fn thread_is_watched() -> bool {
    let thread = own_thread();
    watched().iter().any(|entry| entry.thread == thread)
}

/// Why the host's context cannot be used.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Refusal {
    /// There is no Xt in this process.
    NoXt,
    /// Xt does not know this context.
    NoContext,
}

/// Makes all application contexts that do not watch the descriptor yet watch it, and call `serve`
/// when it is readable.
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

/// The name of the display that Xt opened last, that of the newest context that has one.
pub(super) fn display() -> Option<String> {
    let mut contexts = Xt::find()?.contexts()?.into_iter();
    let newest = contexts.find_map(|context| xt_wake::display(context.expose_provenance()))?;
    newest.into_string().ok()
}

/// Waits for the next event in the context that this thread ran last, and lets Xt handle it, so
/// that the host continues and our windows are served. False if there is no such context.
pub(super) fn process_one() -> bool {
    let Some(xt) = Xt::find() else { return false };
    let (own, contexts) = (own_thread(), xt.contexts().unwrap_or_default());
    let last_run = |context: &Context| {
        let all = watched();
        let same = |entry: &&Watched| (entry.context, entry.thread) == (context.addr(), own);
        let entry = all.iter().find(same)?;
        [0, own].contains(&entry.runner).then_some(entry.run)
    };
    let runs = contexts
        .into_iter()
        .filter_map(|context| Some((last_run(&context)?, context)));
    let last = runs.max_by_key(|(run, _)| *run);
    let (Some((_, context)), Some(process)) = (last, xt.process_event) else {
        return false;
    };
    // SAFETY: a context that Xt knows, which no other thread was seen to run.
    unsafe { process(context, ALL_EVENTS) };
    // It no longer sleeps, even if it has processed nothing but our input.
    for entry in watched().iter_mut() {
        if entry.context == context.addr() {
            entry.sleep = Sleep::default();
        }
    }
    true
}

/// Sends an event to the hosts of the contexts that this thread runs, after [`process_one`]. It may
/// have handled the event that a host already knew of and is about to wait for.
pub(super) fn go_on() {
    let own = own_thread();
    let run: Vec<usize> = watched()
        .iter()
        .filter(|entry| entry.context != DEFAULT && entry.runner == own)
        .map(|entry| entry.context)
        .collect();
    run.into_iter().for_each(xt_wake::wake);
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
                process_event: named(c"XtAppProcessEvent")
                    .map(|found| transmute::<*mut c_void, ProcessEvent>(found)),
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

    /// All application contexts of the process, the newest first; `None` if unknown.
    fn contexts(&self) -> Option<Vec<Context>> {
        let process = self.process?;
        let mut found = Vec::new();
        // SAFETY: a function without arguments; it returns Xt's own record.
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

    /// Adds the descriptor to the inputs of a context (null: the default one), once.
    fn watch(&self, context: Context, descriptor: RawFd) {
        let entry = Watched {
            number: NUMBERS.fetch_add(1, Ordering::Relaxed),
            context: context.expose_provenance(),
            thread: own_thread(),
            descriptor,
            sleep: Sleep::default(),
            runner: 0,
            run: 0,
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
                // SAFETY: as Xt's header declares it; the callback and the descriptor remain.
                unsafe { add(descriptor, READ, on_input, closure) };
            }
            return;
        }
        // SAFETY: a context that Xt knows or the host vouches for; callback and descriptor remain.
        unsafe { (self.add_input)(context, descriptor, READ, on_input, closure) };
        if self.process.is_some()
            && let Some(add) = self.add_end_callback
        {
            // SAFETY: the context is in Xt's list and begins as declared above; the callback
            // remains.
            unsafe { add(&raw mut (*context).ends, on_end, closure) };
            // Only if its end is reported.
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
    note_run(closure.addr());
    match entry(closure.addr()) {
        Some(entry) if entry.thread == own_thread() => serve(entry),
        _ => {
            // Another thread runs this context. The windows are not on this thread, so the
            // descriptor would remain readable for ever.
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
    // Before host code, which may itself sleep in Xt.
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
    note_run(closure.addr());
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
