//! Serving the windows from the host's event loop.

use std::ffi::{c_int, c_void};
use std::panic::{AssertUnwindSafe, catch_unwind};

use super::border::border;
use super::pointers::check;
use super::status::{
    Answer, Failure, V_ERR_BUSY, V_ERR_DISPLAY, V_ERR_INTERNAL, V_OK, set_last_error,
};
use crate::error::panic_said;
use crate::instance::{self, Gone, Lost, Refusal};

/// Serves the windows when an Xt host's loop finds the descriptor readable. Sets the last error
/// only on failure, since the host has called nothing.
pub(super) fn serve() {
    match catch_unwind(AssertUnwindSafe(instance::dispatch)) {
        Ok(served) => tell(served.lost.as_ref()),
        Err(panic) => {
            let said = panic_said(&*panic);
            set_last_error(format_args!("a fault inside the library: {said}"));
        }
    }
}

fn tell(lost: Option<&Lost>) {
    if let Some(lost) = lost {
        set_last_error(format_args!("{}", lost.why));
    }
}

/// ==== Event loop: how your program serves its windows ====
///
/// Returns the descriptor to watch with select(), poll() or the like; when it is
/// readable, call v_dispatch(). It stays the same and open as long as the thread
/// lives; never read or close it. Returns -1 if the system has no more descriptors.
///
/// The functions of this section concern the calling thread's windows. A program with
/// an Xt or Motif main loop needs none of them, unless it processes XtIMXEvent only.
/// Any other program, also one that runs Xt under its own select(), watches this
/// descriptor or calls v_main_loop(). If no loop serves a window, a hint appears on
/// standard error.
#[unsafe(no_mangle)]
pub extern "C" fn v_fd() -> c_int {
    border(-1, || {
        instance::descriptor().or_else(|error| {
            set_last_error(format_args!("{error}"));
            Ok(-1)
        })
    })
}

/// Returns the milliseconds after which v_dispatch() has something to do even without
/// input, and v_fd() becomes readable; -1: no limit.
#[unsafe(no_mangle)]
pub extern "C" fn v_timeout() -> c_int {
    border(-1, || {
        let Some(wait) = instance::wait() else {
            return Ok(-1);
        };
        // Rounded up, so as not to wake too early.
        let wait = wait.as_nanos().div_ceil(1_000_000);
        Ok(c_int::try_from(wait).unwrap_or(c_int::MAX))
    })
}

/// Does all pending work for the windows without waiting; callbacks run inside it.
/// Returns the number of open windows; if one was destroyed, or its X server went
/// away, v_last_error() returns the reason. Inside a callback it serves only windows
/// whose callbacks are not running.
#[unsafe(no_mangle)]
pub extern "C" fn v_dispatch() -> c_int {
    border(0, || {
        instance::host_serves();
        let served = instance::dispatch();
        super::status::clear_last_error();
        tell(served.lost.as_ref());
        super::pointers::count(served.open)
    })
}

/// Serves the windows until the last one is closed. Returns at once without windows.
/// V_ERR_BUSY (inside a callback), V_ERR_DISPLAY (a window was destroyed or its X
/// server went away; after all have closed), V_ERR_LIMIT (no descriptors).
#[unsafe(no_mangle)]
pub extern "C" fn v_main_loop() -> c_int {
    border(V_ERR_INTERNAL, || {
        if instance::within_a_call() {
            return Err(Failure::Border(
                V_ERR_BUSY,
                "the main loop cannot run within a callback",
            ));
        }
        let served = instance::main_loop()?;
        super::status::clear_last_error();
        tell(served.lost.as_ref());
        Ok(match served.lost {
            None => V_OK,
            Some(lost) if lost.gone == Gone::Fault => V_ERR_INTERNAL,
            Some(_) => V_ERR_DISPLAY,
        })
    })
}

/// Lets an XtAppContext run by this thread serve its windows; needed only for one
/// created after a window was opened.
/// V_ERR_ARGUMENT (no Xt, or no such context).
#[unsafe(no_mangle)]
pub extern "C" fn v_set_app_context(app_context: *mut c_void) -> c_int {
    border(V_ERR_INTERNAL, || {
        check(app_context, "app_context")?;
        instance::on_input(serve);
        set_app_context(app_context)
    })
}

fn set_app_context(app_context: *mut c_void) -> Answer<c_int> {
    match instance::set_app_context(app_context)? {
        Ok(()) => Ok(V_OK),
        Err(Refusal::NoXt) => Err(Failure::argument(
            "there is no Xt in this program, or its functions cannot be found",
        )),
        Err(Refusal::NoContext) => Err(Failure::argument("Xt has no such application context")),
    }
}
