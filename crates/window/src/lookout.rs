//! Finds out whether an Xt host serves its windows.
//!
//! An Xt program that sleeps in a `select()` of its own over its X connection looks like any other
//! when a window is opened: Xt takes our input. But while it sleeps it does not see that input, the
//! window is dead, and no code of ours runs that could say why: Xt's timers do not run either,
//! signals are the host's, and nothing that the X server could send reaches a program that does not
//! ask for it.
//!
//! So a thread looks. It is started with a window in a program that runs Xt and has called nothing
//! that serves windows, and ends as soon as the host has shown what it does: Xt slept on our input;
//! windows were served a few times without delay; the host called `v_fd()`, `v_dispatch()` or
//! `v_main_loop()`; the last window is gone; or nobody serves and the hint is given. It takes no
//! signal and touches no window.

#![allow(unsafe_code)] // system calls

use std::fs::File;
use std::io::Read as _;
use std::os::fd::{AsRawFd, FromRawFd, OwnedFd, RawFd};
use std::sync::atomic::{AtomicU64, AtomicUsize, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use vides_x11::without_signals;

/// How often and how many times it checks: less than the two seconds promised for the hint.
const STEP: Duration = Duration::from_millis(100);
const STEPS: u32 = 15;

/// How often windows must have been served for the host to be believed. One with a `select()` of
/// its own serves them now and then by chance, along with events of its own.
const BELIEVED: u32 = 20;

enum State {
    /// Nobody looks.
    Unknown,
    /// A thread of this process looks, and ends when this descriptor is rung.
    Looking { bell: OwnedFd, process: u32 },
    /// Nothing is left to find out.
    Known,
}

static STATE: Mutex<State> = Mutex::new(State::Unknown);
/// How often windows were served, and how many calls are serving them now.
static SERVED: AtomicU64 = AtomicU64::new(0);
static SERVING: AtomicUsize = AtomicUsize::new(0);

fn state() -> MutexGuard<'static, State> {
    STATE.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Windows are being served until this is dropped.
pub(super) struct Serving;

pub(super) fn serving() -> Serving {
    SERVING.fetch_add(1, Ordering::Relaxed);
    SERVED.fetch_add(1, Ordering::Relaxed);
    Serving
}

impl Drop for Serving {
    fn drop(&mut self) {
        SERVING.fetch_sub(1, Ordering::Relaxed);
    }
}

/// Begins to look whether the calling thread's host serves this descriptor, which stays open,
/// unless that is known. A failure does no harm.
pub(super) fn begin(windows: RawFd) {
    let mut state = state();
    if !matches!(*state, State::Unknown) {
        return;
    }
    // SAFETY: system calls without pointers.
    let (bell, host) = unsafe {
        let flags = libc::EFD_CLOEXEC | libc::EFD_NONBLOCK;
        (libc::eventfd(0, flags), libc::gettid())
    };
    if bell < 0 {
        return;
    }
    // SAFETY: a new descriptor, which nobody else has.
    let bell = unsafe { OwnedFd::from_raw_fd(bell) };
    let Ok(end) = bell.try_clone() else { return };
    let look = move || {
        if look(windows, &end, host) {
            settle();
        }
    };
    let thread = std::thread::Builder::new().name("vides lookout".to_owned());
    if without_signals(|| thread.spawn(look)).is_ok() {
        let process = std::process::id();
        *state = State::Looking { bell, process };
    }
}

/// Ends the looking: for good if `known`, else until the next window.
pub(super) fn end(known: bool) {
    let mut state = state();
    if let State::Looking { bell, process } = &*state
        && *process == std::process::id()
    {
        // SAFETY: eight bytes, as an eventfd takes them.
        let _ = unsafe { libc::write(bell.as_raw_fd(), (&raw const RING).cast(), 8) };
    }
    match *state {
        State::Known => {}
        _ if known => *state = State::Known,
        State::Looking { .. } => *state = State::Unknown,
        State::Unknown => {}
    }
}

static RING: u64 = 1;

fn settle() {
    *state() = State::Known;
}

pub(super) fn is_looking() -> bool {
    matches!(*state(), State::Looking { .. })
}

/// Looks until it is known what the host does (true) or until it is told to end.
fn look(windows: RawFd, end: &OwnedFd, host: libc::pid_t) -> bool {
    let mut times = 0;
    while times < BELIEVED {
        if wait(&[windows, end.as_raw_fd()], None)[1] {
            return false;
        }
        let count = SERVED.load(Ordering::Relaxed);
        let (mut served, mut asleep) = (false, 0);
        for _ in 0..STEPS {
            if wait(&[end.as_raw_fd()], Some(STEP))[0] {
                return false;
            }
            served = SERVED.load(Ordering::Relaxed) != count || SERVING.load(Ordering::Relaxed) > 0;
            if served {
                break;
            }
            asleep += u32::from(sleeps(host));
        }
        if served {
            times += 1;
            continue;
        }
        // A host that computes will come back.
        if asleep > STEPS / 2 {
            super::hint::give_to_xt();
            return true;
        }
    }
    true
}

/// Whether a thread of this process sleeps (proc(5), `stat`).
fn sleeps(thread: libc::pid_t) -> bool {
    let mut line = [0; 256];
    let read = File::open(format!("/proc/self/task/{thread}/stat"))
        .and_then(|mut file| file.read(&mut line));
    let line = &line[..read.unwrap_or(0)];
    // The state follows the name, which is in parentheses and may hold any character.
    let name = line.iter().rposition(|&letter| letter == b')');
    name.and_then(|end| line.get(end + 2)) == Some(&b'S')
}

/// Waits until one of the descriptors is readable or the limit is over; tells which are.
fn wait<const N: usize>(descriptors: &[RawFd; N], limit: Option<Duration>) -> [bool; N] {
    let mut polled = descriptors.map(|fd| libc::pollfd {
        fd,
        events: libc::POLLIN,
        revents: 0,
    });
    let limit = limit.map_or(-1, |limit| limit.as_millis().min(60_000) as libc::c_int);
    // SAFETY: so many elements, alive during the call.
    let _ = unsafe { libc::poll(polled.as_mut_ptr(), N as libc::nfds_t, limit) };
    polled.map(|one| one.revents != 0)
}
