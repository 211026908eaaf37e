//! A hint for a programmer whose window shows nothing because the program never serves it.
//!
//! When a host opens a window, VIDES cannot know whether it will serve it, because most begin to do
//! so afterwards. So the hint is given once, at exit or when a later window is opened, if no window
//! was served until then. For hosts that run Xt, [`super::lookout`] finds out more.

#![allow(unsafe_code)] // atexit

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, Once, PoisonError};
use std::time::{Duration, Instant};

use crate::error::complain;

/// A host that has not served its first window for this long has no loop that serves it.
const PATIENCE: Duration = Duration::from_secs(2);

/// When the first window was opened.
static OPENED: Mutex<Option<Instant>> = Mutex::new(None);
static SERVED: AtomicBool = AtomicBool::new(false);
static GIVEN: AtomicBool = AtomicBool::new(false);
static WATCH: Once = Once::new();

pub(super) fn served() {
    SERVED.store(true, Ordering::Relaxed);
}

pub(super) fn opened() {
    if SERVED.load(Ordering::Relaxed) {
        return;
    }
    let first = *OPENED
        .lock()
        .unwrap_or_else(PoisonError::into_inner)
        .get_or_insert_with(Instant::now);
    if first.elapsed() > PATIENCE {
        give();
    }
    WATCH.call_once(|| {
        // SAFETY: the function remains, because the library is never unloaded. A failure does no
        // harm.
        let _ = unsafe { libc::atexit(at_exit) };
    });
}

extern "C" fn at_exit() {
    give();
}

fn give() {
    if !SERVED.swap(true, Ordering::Relaxed) {
        say(
            "a window was opened, but nothing serves it: watch the descriptor of v_fd() and \
             call v_dispatch(), or call v_main_loop(); a host with Xt needs neither \
             (v_set_app_context() if it makes its application context later)",
        );
    }
}

/// Gives the hint to a host that runs Xt but sleeps without watching Xt's inputs.
pub(super) fn give_to_xt() {
    say(
        "a window waits to be served: this program runs Xt, but its own loop does not see \
         Xt's inputs; let its select() or poll() watch the descriptor of v_fd(), too, and \
         call v_dispatch() when that is readable",
    );
}

fn say(hint: &str) {
    if !GIVEN.swap(true, Ordering::Relaxed) {
        complain(hint);
    }
}
