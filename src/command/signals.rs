//! Signals that would end the command without a word.

#![allow(unsafe_code)] // the standard library sets no signals

/// Beyond the size that files may have (`ulimit -f`) writing fails and is reported, as on a full
/// disk, in place of the signal that ends the process.
pub(super) fn survive_size_limit() {
    // SAFETY: to ignore a signal needs no handler; nothing else here sets this one.
    unsafe {
        libc::signal(libc::SIGXFSZ, libc::SIG_IGN);
    }
}
