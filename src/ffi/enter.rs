//! Calling the host's callbacks through a frame that no exception passes.
//!
//! A C++ exception must not unwind Rust frames: Rust's runtime would end the program with a message
//! about Rust, or, in the shared library with its own unwinder, with none. So callbacks are called
//! from one frame whose personality routine reports what happened and refuses. As this is in the
//! search phase, the stack is intact, and the C++ runtime calls `std::terminate` with its own
//! message, as at a `noexcept` function. The routine calls nothing in the unwinder, which may not
//! be ours.
//!
//! The frame exists for x86-64 only; elsewhere callbacks are called directly.

use std::cell::Cell;

#[cfg(all(target_arch = "x86_64", not(miri)))]
pub(super) use frame::vides_enter;

thread_local! {
    /// The callback that is running.
    static NAME: Cell<&'static str> = const { Cell::new("") };
}

/// Calls a function of the host's. Takes its name in the header, the function with its arguments
/// and their types, and the result type.
///
/// # Safety
/// The function has these types and may be called with these arguments.
macro_rules! enter {
    ($name:literal, $function:ident($($argument:expr => $kind:ty),* $(,)?) -> $result:ty) => {{
        type Function = unsafe extern "C" fn($($kind),*) -> $result;
        $crate::ffi::enter::named($name, || {
            #[cfg(all(target_arch = "x86_64", not(miri)))]
            {
                type Enter = unsafe extern "C" fn(Function $(, $kind)*) -> $result;
                // The frame passes on the function and up to six integer or pointer arguments;
                // floating-point arguments stay in their registers.
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

/// Runs `call`, with `name` as the running callback.
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

    // The directives: DWARF Debugging Information Format, 6.4, and the Itanium C++ ABI, Exception
    // Handling. 0x1b: the routine's address, PC-relative in four bytes.
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
        // The sixth argument is the first on the stack; garbage if there is none.
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
        /// Calls its first argument with the others.
        pub(in crate::ffi) fn vides_enter();
    }

    /// `_UA_SEARCH_PHASE`: nothing is unwound yet.
    const SEARCH: c_int = 1;
    /// `_URC_FATAL_PHASE1_ERROR`, `_URC_FATAL_PHASE2_ERROR`.
    const NO_HANDLER: c_int = 3;
    const NO_WAY_ON: c_int = 2;

    /// The frame's personality routine, which unwinders ask how to go on.
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
        // Forced unwinding skips the search phase: the thread exits or is cancelled.
        complain(format_args!(
            "the thread is to end within the callback {name}(), where it may not: the program ends"
        ));
        NO_WAY_ON
    }
}
