//! The way into a callback of the host's: through a frame that no exception
//! passes.
//!
//! A C++ exception that leaves a callback would unwind frames of Rust, which
//! cannot have it: Rust's runtime ends the program with a word about Rust, or, in
//! the shared library, whose unwinder is its own, without any. So every callback
//! is called from one frame whose personality routine, which the unwinder asks
//! first, says what happened and refuses. The stack still stands then, and the
//! C++ runtime ends the program as at a `noexcept` function: by
//! `std::terminate`, with its own words about the exception. The routine asks
//! nothing of the unwinder, since that may be another one than ours.
//!
//! The frame is written for x86-64. Elsewhere callbacks are called plainly, and
//! Rust's runtime has the last word.

use std::cell::Cell;

#[cfg(all(target_arch = "x86_64", not(miri)))]
pub(super) use frame::vides_enter;

thread_local! {
    /// The callback that runs.
    static NAME: Cell<&'static str> = const { Cell::new("") };
}

/// Calls a function of the host's: its name in the header, the function with its
/// arguments and their types, the type that it returns.
///
/// # Safety
/// The function is of these types and may be called with these arguments.
macro_rules! enter {
    ($name:literal, $function:ident($($argument:expr => $kind:ty),* $(,)?) -> $result:ty) => {{
        type Function = unsafe extern "C" fn($($kind),*) -> $result;
        $crate::ffi::enter::named($name, || {
            #[cfg(all(target_arch = "x86_64", not(miri)))]
            {
                type Enter = unsafe extern "C" fn(Function $(, $kind)*) -> $result;
                // The frame takes the function and up to six arguments that are no
                // floating-point numbers; those pass by.
                let enter = std::mem::transmute::<unsafe extern "C" fn(), Enter>(
                    $crate::ffi::enter::vides_enter,
                );
                enter($function $(, $argument)*)
            }
            #[cfg(not(all(target_arch = "x86_64", not(miri))))]
            {
                let function: Function = $function;
                function($($argument),*)
            }
        })
    }};
}

/// Runs `call` under a callback's name.
pub(super) fn named<T>(name: &'static str, call: impl FnOnce() -> T) -> T {
    let outer = NAME.replace(name);
    let result = call();
    NAME.set(outer);
    result
}

#[cfg(all(target_arch = "x86_64", not(miri)))]
mod frame {
    use std::ffi::{c_int, c_void};

    use super::NAME;
    use crate::error::complain;

    // What each line means to an unwinder: "DWARF Debugging Information Format", 6.4,
    // and the C++ ABI for Itanium, "Exception Handling". 0x1b: the routine's address
    // is given relative to the place where it stands, in four bytes.
    std::arch::global_asm!(
        ".pushsection .text.vides_enter,\"ax\",@progbits",
        ".balign 16",
        ".globl vides_enter",
        ".hidden vides_enter",
        ".type vides_enter,@function",
        "vides_enter:",
        ".cfi_startproc",
        ".cfi_personality 0x1b, {refuse}",
        "endbr64",
        "sub rsp, 8",
        ".cfi_adjust_cfa_offset 8",
        "mov rax, rdi",
        "mov rdi, rsi",
        "mov rsi, rdx",
        "mov rdx, rcx",
        "mov rcx, r8",
        "mov r8, r9",
        // The sixth is the first on the stack; where there is none, nobody looks.
        "mov r9, [rsp + 16]",
        "call rax",
        "add rsp, 8",
        ".cfi_adjust_cfa_offset -8",
        "ret",
        ".cfi_endproc",
        ".size vides_enter, . - vides_enter",
        ".popsection",
        refuse = sym refuse,
    );

    unsafe extern "C" {
        /// Calls the function that is its first argument with the others.
        pub(in crate::ffi) fn vides_enter();
    }

    /// Looking for a handler, and nothing is unwound yet (`_UA_SEARCH_PHASE`).
    const SEARCH: c_int = 1;
    /// `_URC_FATAL_PHASE1_ERROR`, `_URC_FATAL_PHASE2_ERROR`.
    const NO_HANDLER: c_int = 3;
    const NO_WAY_ON: c_int = 2;

    /// The frame's personality routine: whoever unwinds the stack asks it how to go on.
    extern "C" fn refuse(
        _version: c_int,
        actions: c_int,
        _class: u64,
        _exception: *mut c_void,
        _context: *mut c_void,
    ) -> c_int {
        let name = NAME.get();
        if actions & SEARCH != 0 {
            complain(format_args!(
                "an exception leaves the callback {name}(), which none may: the program ends"
            ));
            return NO_HANDLER;
        }
        // Without a search before it: the thread is to end, or is cancelled.
        complain(format_args!(
            "the thread is to end within the callback {name}(), where it may not: the program ends"
        ));
        NO_WAY_ON
    }
}
