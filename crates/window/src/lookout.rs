//! Finds out whether a host that runs Xt serves its windows.
//!
//! An Xt program that sleeps in its own `select()` over its X connection looks like any other when
//! it opens a window: Xt accepts our input. While it sleeps, it does not see that input, and the
//! window is dead. No code of ours runs to report it: Xt's timers do not run either, signals belong
//! to the host, and nothing that the X server could send reaches a program that does not ask for
//! it.
//!
//! So a thread watches. It starts with a window, in a program that runs Xt and has called nothing
//! that serves windows. It ends as soon as the host has shown what it does: Xt slept on our input;
//! windows were served a few times without delay; the host called `v_fd()`, `v_dispatch()` or
//! `v_main_loop()`; the last window is gone; or nothing serves the windows and the hint is given.
//! The thread takes no signals and touches no window.

#![allow(unsafe_code)] // system calls

use std::fs::File;
use std::io::Read as _;
use std::os::fd::{AsRawFd, FromRawFd, OwnedFd, RawFd};
use std::sync::atomic::{AtomicU64, AtomicUsize, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use vides_engine::descriptor::off_standard;
use vides_x11::without_signals;

/// How often, and how many times, to check: in less than the two seconds promised for the hint.
const STEP: Duration = Duration::from_millis(100);
const STEPS: u32 = 15;

/// How often windows must have been served before the host counts as serving them. A host with its
/// own `select()` serves them now and then by chance, along with its own events.
const BELIEVED: u32 = 20;

enum State {
    /// No thread is watching.
    Unknown,
    /// A thread of this process is watching, and ends when this descriptor is rung.
    Looking { bell: OwnedFd, process: u32 },
    /// The answer is known.
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

/// Starts to find out whether the host of the calling thread serves this descriptor, which stays
/// open, unless that is known. A failure does no harm.
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
    // SAFETY: a new descriptor, which no one else owns.
    let bell = unsafe { OwnedFd::from_raw_fd(bell) };
    let Ok(bell) = off_standard(bell) else { return };
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

/// Ends the watching: for good if `known`, otherwise until the next window.
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

/// Watches until it is known what the host does (true) or until the thread must end.
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
            // Input that is gone was served, perhaps before the count was read.
            served = SERVED.load(Ordering::Relaxed) != count
                || SERVING.load(Ordering::Relaxed) > 0
                || !wait(&[windows], Some(Duration::ZERO))[0];
            if served {
                break;
            }
            asleep += u32::from(sleeps(host));
        }
        if served {
            times += 1;
            continue;
        }
        // A host that is computing will come back.
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
        .and_then(off_standard)
        .and_then(|mut file| file.read(&mut line));
    let line = &line[..read.unwrap_or(0)];
    // The state follows the name, which is in parentheses and may hold any character.
    let name = line.iter().rposition(|&letter| letter == b')');
    name.and_then(|end| line.get(end + 2)) == Some(&b'S')
}

/// Waits until one of the descriptors is readable or the time is over; returns which are readable.
fn wait<const N: usize>(descriptors: &[RawFd; N], limit: Option<Duration>) -> [bool; N] {
    let mut polled = descriptors.map(|fd| libc::pollfd {
        fd,
        events: libc::POLLIN,
        revents: 0,
    });
    let limit = limit.map_or(-1, |limit| limit.as_millis().min(60_000) as libc::c_int);
    // SAFETY: N elements, alive during the call.
    let _ = unsafe { libc::poll(polled.as_mut_ptr(), N as libc::nfds_t, limit) };
    polled.map(|one| one.revents != 0)
}
