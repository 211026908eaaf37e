//! The ordinary end of the process, `exit` or the return from `main`. Whoever ends a program like
//! that is done with its windows, and their unsaved work is not offered again. Any other end (a
//! signal, `abort`, `_exit`) leaves that work.
//!
//! `exit` runs the destructors of its thread's variables, which closes that thread's windows, then
//! what was registered with `atexit`, and last the functions in `.fini_array`; the end of a thread
//! alone runs only the first. Our function stands in `.fini_array`: so nothing is registered in the
//! host's process, and a host that crashes while it cleans up still leaves the work.
//!
//! One `exit` is nobody's intention: Xlib's, when its server goes away or its connection is killed.
//! It is recognized by a connection of the process to our server that was hung up.

#![allow(unsafe_code)] // system calls, a function for the system to call

use std::fs;
use std::mem::{MaybeUninit, size_of};
use std::os::fd::{AsRawFd, BorrowedFd, RawFd};
use std::panic::catch_unwind;
use std::path::PathBuf;
use std::sync::{Mutex, MutexGuard, PoisonError, TryLockError};
use std::time::Duration;

use super::descriptors::events_of;
use super::host::Id;
use super::xt::own_thread;

/// The windows that keep work, of all threads.
static WINDOWS: Mutex<Vec<Entry>> = Mutex::new(Vec::new());

/// How often and how long the end waits for a thread that holds the list, and may be stopped.
const TRIES: u32 = 20;
const PAUSE: Duration = Duration::from_millis(1);

struct Entry {
    window: Id,
    /// Not that of a forked child.
    process: u32,
    thread: usize,
    /// Its thread has ended, or ends along with the process.
    dropped: bool,
    /// The file of its unsaved work.
    work: PathBuf,
    /// The server's end of its connection.
    server: Address,
}

fn windows() -> MutexGuard<'static, Vec<Entry>> {
    WINDOWS.lock().unwrap_or_else(PoisonError::into_inner)
}

pub(super) fn opened(window: Id, work: PathBuf, connection: BorrowedFd<'_>) {
    let entry = Entry {
        window,
        process: std::process::id(),
        thread: own_thread(),
        dropped: false,
        work,
        server: Address::of_peer(connection.as_raw_fd()),
    };
    let mut windows = windows();
    // Without memory for the entry the work is offered at the next start.
    if windows.try_reserve(1).is_ok() {
        windows.push(entry);
    }
}

/// The window is gone, and how the process ends no longer matters to its work.
pub(super) fn closed(window: Id) {
    windows().retain(|entry| entry.window != window);
}

/// The window goes with its thread, and perhaps with the process.
pub(super) fn dropped(window: Id) {
    let mut windows = windows();
    if let Some(entry) = windows.iter_mut().find(|entry| entry.window == window) {
        entry.dropped = true;
        if entry.server.hung_up_on_us() {
            windows.retain(|entry| entry.window != window);
        }
    }
}

#[used]
#[unsafe(link_section = ".fini_array")]
static AT_END: extern "C" fn() = at_end;

extern "C" fn at_end() {
    // No fault of ours may stop the host at its end.
    let _ = catch_unwind(forget_all);
}

fn forget_all() {
    let mut tries = 0;
    let mut windows = loop {
        match WINDOWS.try_lock() {
            Ok(windows) => break windows,
            Err(TryLockError::Poisoned(poisoned)) => break poisoned.into_inner(),
            Err(TryLockError::WouldBlock) if tries < TRIES => tries += 1,
            Err(TryLockError::WouldBlock) => return,
        }
        std::thread::sleep(PAUSE);
    };
    let (process, thread) = (std::process::id(), own_thread());
    for entry in windows.drain(..) {
        // If its thread ended earlier, the window vanished while its user worked: offer that work.
        let is_ours = entry.process == process && (!entry.dropped || entry.thread == thread);
        // A dropped one was checked while it still had its connection.
        if is_ours && (entry.dropped || !entry.server.hung_up_on_us()) {
            let _ = fs::remove_file(entry.work);
        }
    }
}

/// The address that a connection leads to.
#[derive(Clone, Copy)]
struct Address {
    bytes: [u8; size_of::<libc::sockaddr_storage>()],
    length: usize,
}

impl Address {
    /// The other end of a connection; empty if there is none.
    fn of_peer(socket: RawFd) -> Self {
        let mut address = MaybeUninit::<libc::sockaddr_storage>::zeroed();
        let mut length = size_of::<libc::sockaddr_storage>() as libc::socklen_t;
        // SAFETY: room for any address, and its size; all of it is bytes, and zero so far.
        let (done, bytes) = unsafe {
            let done = libc::getpeername(socket, address.as_mut_ptr().cast(), &mut length);
            (done, address.as_ptr().cast::<[u8; _]>().read())
        };
        Self {
            bytes,
            length: if done == 0 { length as usize } else { 0 },
        }
    }

    /// Its bytes. On Linux a local server listens at a path and at the same name in the abstract
    /// namespace, which begins with a zero.
    fn name(&self) -> &[u8] {
        let bytes = &self.bytes[..self.length.min(self.bytes.len())];
        let family = size_of::<libc::sa_family_t>();
        let local = bytes.len() > family
            && self.bytes[..family] == (libc::AF_UNIX as libc::sa_family_t).to_ne_bytes();
        match bytes.get(family..) {
            Some([0, name @ ..]) | Some(name) if local => name.strip_suffix(b"\0").unwrap_or(name),
            _ => bytes,
        }
    }

    /// Whether the other side hung up a connection of this process to it.
    fn hung_up_on_us(&self) -> bool {
        let Ok(open) = fs::read_dir("/proc/self/fd") else {
            return false;
        };
        open.flatten()
            .filter_map(|entry| entry.file_name().to_str()?.parse().ok())
            .any(|socket| is_hung_up(socket) && self.is_peer_of(socket))
    }

    fn is_peer_of(&self, socket: RawFd) -> bool {
        let other = Self::of_peer(socket);
        other.length > 0 && other.name() == self.name()
    }
}

fn is_hung_up(descriptor: RawFd) -> bool {
    let ended = libc::POLLHUP | libc::POLLRDHUP | libc::POLLERR;
    events_of(descriptor, libc::POLLRDHUP) & ended != 0
}
