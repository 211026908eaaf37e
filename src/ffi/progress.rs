//! How far work that takes long has come, told to a callback of the host's, which may end it.

use std::cell::Cell;
use std::ffi::{c_double, c_int, c_void};
use std::sync::TryLockError;
use std::time::{Duration, Instant};

use super::border::border;
use super::status::{
    Answer, Failure, V_ERR_BUSY, V_ERR_INTERNAL, V_ERR_REFUSED, V_OK, clear_last_error,
    clear_last_warning,
};
use crate::tools::fit::Progress;

/// Time from one call of the callback to the next, at least.
const PAUSE: Duration = Duration::from_millis(100);

const REFUSED: Failure = Failure::Border(
    V_ERR_REFUSED,
    "the progress callback ended the call, and nothing has changed",
);

type Callback = unsafe extern "C" fn(c_double, *mut c_void) -> c_int;

thread_local! {
    /// The thread's callback, and its `user`.
    static CALLBACK: Cell<Option<(Callback, *mut c_void)>> = const { Cell::new(None) };
    /// How many of its calls are under way, one within another.
    static WITHIN: Cell<u32> = const { Cell::new(0) };
}

const BUSY: Failure = Failure::Border(
    V_ERR_BUSY,
    "this path or scene is in use, and cannot be waited for within a progress callback",
);

/// The lock of a path or scene. Within a progress callback the call in progress may hold it, or
/// another thread that waits for one of ours, so a callback does not wait.
pub(super) fn locked<G, E>(
    wait: impl FnOnce() -> Result<G, E>,
    take: impl FnOnce() -> Result<G, TryLockError<G>>,
    spoiled: Failure,
) -> Answer<G> {
    if WITHIN.get() == 0 {
        return wait().map_err(|_| spoiled);
    }
    take().map_err(|error| match error {
        TryLockError::WouldBlock => BUSY,
        TryLockError::Poisoned(_) => spoiled,
    })
}

/// Does work that the thread's callback may end.
pub(super) fn watched<R>(work: impl FnOnce(Progress<'_>) -> Answer<R>) -> Answer<R> {
    let mut called = Instant::now();
    let mut refused = false;
    let made = work(&mut |done, all| {
        if !refused && called.elapsed() >= PAUSE {
            refused = !asked(done as f64 / all.max(1) as f64);
            called = Instant::now();
        }
        !refused
    });
    if refused { Err(REFUSED) } else { made }
}

fn asked(share: f64) -> bool {
    let Some((callback, user)) = CALLBACK.get() else {
        return true;
    };
    WITHIN.set(WITHIN.get() + 1);
    // SAFETY: the host's function, as the header says.
    let answer = unsafe {
        enter!("progress", callback(
            share.clamp(0.0, 1.0) => c_double,
            user => *mut c_void,
        ) -> c_int)
    };
    WITHIN.set(WITHIN.get() - 1);
    // What failed or warned in there is not of the call that is under way.
    clear_last_error();
    clear_last_warning();
    answer != 0
}

/// Sets the function that the calling thread's long calls (those with V_ERR_REFUSED,
/// except v_editors_close()) call at most ten times a second; NULL, the default:
/// none.
///
/// progress  share is from 0 to 1, and may fall when another round begins. If it
///     returns 0, the call fails with V_ERR_REFUSED and changes nothing. In it, a
///     path or scene in use, such as that of the call, is V_ERR_BUSY. No exception or
///     longjmp() may leave it
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_set_progress(
    progress: Option<unsafe extern "C" fn(share: c_double, user: *mut c_void) -> c_int>,
    user: *mut c_void,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        CALLBACK.set(progress.map(|progress| (progress as Callback, user)));
        Ok(V_OK)
    })
}
