//! The program that this process runs, and its user's clock.

#![allow(unsafe_code)] // a system call

use std::mem::MaybeUninit;
use std::path::Path;
use std::time::{SystemTime, UNIX_EPOCH};

use vides_editor::{Date, Program};

/// The name the program was called by, without folders; empty if there was none. By it a desktop
/// groups our windows with the program's own, and unsaved work is found again.
pub(super) fn name() -> String {
    let called = std::env::args_os().next().unwrap_or_default();
    let name = Path::new(&called).file_name().unwrap_or_default();
    name.to_string_lossy().into_owned()
}

/// The host, by its name. `hand_over_saves`: after a hand-over nothing counts as unsaved.
pub fn host_program(hand_over_saves: bool) -> Program {
    Program {
        name: name(),
        offers_all: false,
        hand_over_saves,
        local_time,
    }
}

/// The command `vides edit`: it offers the unsaved work of any program.
pub fn own_program() -> Program {
    Program {
        name: "vides".to_owned(),
        offers_all: true,
        hand_over_saves: false,
        local_time,
    }
}

fn local_time(time: SystemTime) -> Option<Date> {
    let seconds = time.duration_since(UNIX_EPOCH).ok()?.as_secs();
    let seconds = libc::time_t::try_from(seconds).ok()?;
    let mut parts = MaybeUninit::<libc::tm>::zeroed();
    // SAFETY: both live during the call; what it does not fill in is zero.
    let parts = unsafe {
        let done = libc::localtime_r(&seconds, parts.as_mut_ptr());
        (!done.is_null()).then(|| parts.assume_init())
    }?;
    Some(Date {
        year: parts.tm_year + 1900,
        month: parts.tm_mon + 1,
        day: parts.tm_mday,
        hour: parts.tm_hour,
        minute: parts.tm_min,
    })
}
