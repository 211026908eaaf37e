//! The program that this process runs, and its user's local time.

#![allow(unsafe_code)] // a system call

use std::mem::MaybeUninit;
use std::path::Path;
use std::time::{SystemTime, UNIX_EPOCH};

use vides_editor::{Date, Program};

/// The name by which the program was called, without folders; empty if unknown. Desktops
/// group our windows with the program's by this name, and unsaved work is found by it.
pub(super) fn name() -> String {
    let called = std::env::args_os().next().unwrap_or_default();
    let name = Path::new(&called).file_name().unwrap_or_default();
    name.to_string_lossy().into_owned()
}

/// The host program, by its name. `hand_over_saves`: nothing counts as unsaved after a hand-over.
pub fn host_program(hand_over_saves: bool) -> Program {
    Program {
        name: name(),
        offers_all: false,
        hand_over_saves,
        local_time,
    }
}

/// The command `vides edit`, which offers the unsaved work of any program.
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
    // SAFETY: both live during the call; fields that it does not fill in are zero.
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
