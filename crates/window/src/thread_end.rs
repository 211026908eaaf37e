//! Reports that a thread with open windows has ended: its windows close, and nothing else explains
//! why.
//!
//! At the end of the process, the windows of the thread that calls `exit` close in the same way,
//! which needs no report. The destructors of thread keys tell the two apart: the C library runs
//! them when a thread ends, but not in `exit`.

#![allow(unsafe_code)] // pthread_key_create

use std::ffi::c_void;
use std::ptr;
use std::sync::OnceLock;

use crate::error::complain;

/// The key whose destructor reports; `None` if the system has no key left.
static KEY: OnceLock<Option<libc::pthread_key_t>> = OnceLock::new();

/// Notes how many windows the calling thread closes; to be called while it ends.
pub(super) fn takes(windows: usize) {
    let key = KEY.get_or_init(|| {
        let mut key = 0;
        // SAFETY: room for the key; the function remains, because the library is never unloaded.
        let made = unsafe { libc::pthread_key_create(&mut key, Some(say)) };
        (made == 0).then_some(key)
    });
    if let Some(key) = *key {
        let count: *mut c_void = ptr::without_provenance_mut(windows);
        // SAFETY: a key of ours. Without memory for it nothing is reported, which does no harm.
        let _ = unsafe { libc::pthread_setspecific(key, count) };
    }
}

extern "C" fn say(windows: *mut c_void) {
    match windows.addr() {
        1 => complain(
            "the thread that opened a window has ended, and the window is closed: the thread \
             that opens a window must go on serving it",
        ),
        count => complain(format_args!(
            "the thread that opened {count} windows has ended, and they are closed: the thread \
             that opens a window must go on serving it",
        )),
    }
}
